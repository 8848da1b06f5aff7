"""What the columns of a catalogue are called: by the names here, by symbols and in words.

d, D, B (T), C, C_0, C_u as makers print them, in any case but for d and D, which are never taken
for each other; with the unit behind the name (``d_mm``), in round or square brackets, in a line of
units below or in a comment ``# units: mm, kN`` above. A length without a unit is in millimetres, as
makers of metric bearings print it; a force without one is refused: some print N and others kN.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from math import pi
from typing import Final

from rolamento.errors import InputError, UnknownKeyError, guess
from rolamento.io.columns import folded_name, title_parts
from rolamento.records import frozen
from rolamento.types import TYPES
from rolamento.words import said

__all__ = ["CatalogueColumn", "columns_of", "heads_catalogue", "kind_of_word"]

_TEXTS: Final = {
    "designation": (
        "designation basic_designation bearing bearing_no bearing_number number part_number part_no"
        " model reference ref designacao referencia rolamento bezeichnung kurzzeichen lager"
        " designacion rodamiento"
    ),
    "maker": "maker manufacturer brand make fabricante marca hersteller",
    "kind": "kind type bearing_type tipo bauart lagerart art",
    "source": "source fonte quelle fuente",
}
_LENGTHS: Final = {
    "bore": (
        "bore bore_diameter inner_diameter inside_diameter bohrung bohrungsdurchmesser"
        " innendurchmesser furo diametro_do_furo diametro_interno diametro_interior"
    ),
    "outside_diameter": (
        "outside_diameter outer_diameter od aussendurchmesser diametro_externo diametro_exterior"
    ),
    "width": "b width breite largura ancho anchura",
    "height": "t h total_width height hohe hoehe gesamtbreite altura largura_total",
    "outer_width": "outer_width cup_width",
    "inner_width": "inner_width cone_width",
    "load_centre_distance": "load_centre_distance",
    "load_centre": "load_centre",
    "ball_diameter": "ball_diameter kugeldurchmesser diametro_da_esfera diametro_de_bola",
    "element_diameter": "dw d_w",
    "pitch_diameter": "pitch_diameter dm d_m dpw d_pw teilkreisdurchmesser diametro_primitivo",
    "inner_raceway_diameter": "inner_raceway_diameter fw f_w",
    "outer_raceway_diameter": "outer_raceway_diameter ew e_w",
    "roller_diameter": "roller_diameter dwe d_we",
    "effective_length": "effective_length lwe l_we",
}
_FORCES: Final = {
    "dynamic_rating": (
        "c cr c_r dynamic_rating dynamic_load dynamic_load_rating basic_dynamic_load_rating"
        " dynamic_capacity tragzahl_dynamisch dynamische_tragzahl carga_dinamica"
        " capacidade_de_carga_dinamica capacidade_dinamica capacidad_de_carga_dinamica"
    ),
    "static_rating": (
        "c0 c_0 co c0r c_0r cor static_rating static_load static_load_rating"
        " basic_static_load_rating static_capacity tragzahl_statisch statische_tragzahl"
        " carga_estatica capacidade_de_carga_estatica capacidade_estatica"
        " capacidad_de_carga_estatica"
    ),
    "axial_dynamic_rating": "axial_dynamic_rating ca c_a",
    "axial_static_rating": "axial_static_rating c0a c_0a coa",
    "fatigue_load_limit": (
        "fatigue_load_limit cu c_u pu p_u cur fatigue_limit_load ermudungsgrenzbelastung"
        " limite_de_carga_de_fadiga carga_limite_de_fadiga carga_limite_de_fatiga"
    ),
}
_PURE: Final = {
    "f0": "f0 f_0",
    "inner_conformity": "inner_conformity fi f_i",
    "outer_conformity": "outer_conformity fe fo f_o f_e",
    "axial_limit": "axial_limit e",
    "clearance_factor": "clearance_factor k2 k_2",
    "axial_factor": "axial_factor y",
    "static_axial_factor": "static_axial_factor y0 y_0 yo",
    "ball_count": "ball_count number_of_balls kugelanzahl numero_de_esferas",
    "roller_count": "roller_count number_of_rollers numero_de_rolos",
    "count": "z",
}
_ANGLES: Final = {
    "contact_angle": "contact_angle alpha druckwinkel kontaktwinkel angulo_de_contato"
    " angulo_de_contacto",
}
_SPEEDS: Final = {
    "limiting_speed": "limiting_speed speed_limit grenzdrehzahl velocidade_limite"
    " rotacao_limite velocidad_limite",
}
_LEFT_OUT: Final = frozenset(
    word
    for words in (
        "mass weight massa peso masse gewicht price preco preis precio note notes remark remarks",
        "comment observacao bemerkung link url reference_speed bezugsdrehzahl",
        "rotacao_de_referencia r r_min r1 r1_min r1s_min rs_min chamfer da_min da_max d_a_min",
        "d_a_max ra ra_max kr k_r",
    )
    for word in words.split()
)
"""What catalogues print besides, and no figure here follows from."""
_UNITS: Final[Mapping[str, tuple[str, float]]] = {
    "mm": ("length", 1e-3), "in": ("length", 0.0254), "inch": ("length", 0.0254),
    "m": ("length", 1.0), "cm": ("length", 1e-2),
    "n": ("force", 1.0), "kn": ("force", 1e3), "lbf": ("force", 4.4482216152605),
    "kgf": ("force", 9.80665), "dan": ("force", 10.0),
    "deg": ("angle", pi / 180.0), "rad": ("angle", 1.0), "grad": ("angle", pi / 180.0),
    "rpm": ("speed", pi / 30.0), "r_min": ("speed", pi / 30.0), "min_1": ("speed", pi / 30.0),
    "1_min": ("speed", pi / 30.0), "u_min": ("speed", pi / 30.0),
}  # fmt: skip
"""SI value of the units that a catalogue has, folded, and what they are of."""
_KINDS_OF_FIGURE: Final = (
    ("length", _LENGTHS),
    ("force", _FORCES),
    ("angle", _ANGLES),
    ("speed", _SPEEDS),
    ("", _PURE),
)
_FIGURES: Final = {
    word: (figure, quantity)
    for quantity, named in _KINDS_OF_FIGURE
    for figure, words in named.items()
    for word in words.split()
}
_WORDS: Final = {word: text for text, words in _TEXTS.items() for word in words.split()}
_KIND_OF_WORD: Final = {word: one.key for one in TYPES.values() for word in one.called.split()}
_NO_KIND: Final = frozenset(("ball", "ball_bearing", "esferas", "kugellager", "bolas"))
"""Words that leave open which kind of ball bearing it is: the contact angle decides."""


@frozen
class CatalogueColumn:
    """What a column of a catalogue holds.

    Attributes
    ----------
    figure
        key of the figure or text
    factor
        SI value of one unit
    title
        the heading as it is written
    """

    figure: str
    factor: float
    title: str

    @property
    def is_text(self) -> bool:
        """Whether it holds words."""
        return self.figure in _TEXTS


def columns_of(header: Sequence[str], units: str = "") -> dict[int, CatalogueColumn]:
    """Return what the columns of a catalogue hold, by their places.

    Parameters
    ----------
    header
        As it is written.
    units
        That hold where a heading has none: ``"mm, kN"``.

    Raises
    ------
    InputError
        If a column is not known, occurs twice, or is of a force whose unit is not said.
    """
    usual = dict(_UNITS[word] for part in units.split(",") if (word := folded_name(part)) in _UNITS)
    found: dict[int, CatalogueColumn] = {}
    for place, title in enumerate(header):
        column = _column_of(title, usual)
        if column is None:
            continue
        if column.figure in {other.figure for other in found.values()}:
            raise UnknownKeyError(said("occurs twice"), field=title)
        found[place] = column
    return found


def heads_catalogue(cells: Sequence[str]) -> bool:
    """Return whether cells are headings of a catalogue: designation, d and D among them."""
    figures = set()
    for cell in cells:
        name, _, _ = _parts(cell)
        figures.add(_figure_of(name)[0] if name else "")
    return {"designation", "bore", "outside_diameter"} <= figures


def kind_of_word(word: str) -> str | None:
    """Return the key of a kind of bearing by what catalogues call it; "" for just a ball bearing.

    None of a word that is not known.
    """
    folded = folded_name(word)
    return "" if folded in _NO_KIND else _KIND_OF_WORD.get(folded)


def _column_of(title: str, usual: Mapping[str, float]) -> CatalogueColumn | None:
    name, unit, shown_unit = _parts(title)
    if not name and not unit:
        return None
    figure, quantity = _figure_of(name)
    if quantity == "text":
        return CatalogueColumn(figure, 1.0, title)
    of, factor = _UNITS.get(unit, ("", 1.0))
    if figure == "dynamic_rating" and of == "length":  # C of a tapered bearing, besides C in kN
        figure, quantity = "outer_width", "length"
    if not figure:
        if folded_name(name) in _LEFT_OUT:
            return None
        known = (*_TEXTS, *dict.fromkeys(figure for figure, _ in _FIGURES.values()))
        raise UnknownKeyError(
            said("is an unknown column; {guess}", guess=guess(name, known)), field=title
        )
    if shown_unit and of != quantity:
        raise InputError(said("has a unit of another quantity"), field=title, value=shown_unit)
    if not unit and quantity in usual:
        factor = usual[quantity]
    elif not unit and quantity == "force":
        raise InputError(
            said("needs its unit: some catalogues print N and others kN"),
            field=title,
            example=f"{title} (kN)",
        )
    elif not unit:
        factor = {"length": 1e-3, "angle": pi / 180.0, "speed": pi / 30.0}.get(quantity, 1.0)
    return CatalogueColumn(figure, factor, title)


def _parts(title: str) -> tuple[str, str, str]:
    """Name of a heading, its unit folded, and as it is written; the unit may end the name."""
    name, written = title_parts(title.strip())
    if written:
        return name.strip(), folded_name(written.replace("°", "deg").replace("º", "deg")), written
    head, mark, tail = name.rpartition("_")
    if not mark:
        head, mark, tail = name.rpartition(" ")
    if mark and head and folded_name(tail) in _UNITS:
        return head.strip(), folded_name(tail), tail
    return name.strip(), "", ""


def _figure_of(name: str) -> tuple[str, str]:
    """The figure or text of a name, and the quantity that it is: "text" of a text."""
    if name in ("d", "D"):
        return ("bore" if name == "d" else "outside_diameter"), "length"
    if name in ("α", "Α"):
        return "contact_angle", "angle"
    word = folded_name(name)
    if word in _WORDS:
        return _WORDS[word], "text"
    if word in _FIGURES:
        return _FIGURES[word]
    head, _, tail = word.rpartition("_")
    if head in _FIGURES and _symbol_of(name) in _SYMBOLS.get(_FIGURES[head][0], (tail,)):
        return _FIGURES[head]
    return "", ""


_SYMBOLS: Final = {
    "bore": ("d",),
    "outside_diameter": ("D",),
    "width": ("B", "b", "T", "t"),
    "height": ("T", "t", "H", "h"),
    "dynamic_rating": ("C", "c", "Cr", "C_r"),
    "static_rating": ("C0", "c0", "C_0", "C0r"),
    "fatigue_load_limit": ("Cu", "cu", "Pu", "C_u"),
}
"""Symbols that may stand behind the words for a figure: Bore d, Dynamic_Load_C."""


def _symbol_of(name: str) -> str:
    return re.split(r"[\s_,]+", name.strip())[-1]
