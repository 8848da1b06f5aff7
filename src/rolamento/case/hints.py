"""What a field may be meant by, where nobody knows the word for it: other names, other tables."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Final

from rolamento.errors import alike, guess
from rolamento.words import marked, said

__all__ = ["ALIASES", "LISTED", "hint"]

ALIASES: Final = {
    "duty.inner_speed": (
        *("speed", "rpm", "n", "n_i", "ni", "shaft_speed", "rotation_speed", "rotational_speed"),
        *("omega", "rotacao", "velocidade"),
    ),
    "duty.outer_speed": ("n_o", "no", "n_e", "ne", "housing_speed"),
    "duty.load.fz": (
        *("fr", "f_r", "radial", "radial_load", "radial_force", "load", "force"),
        *("carga", "carga_radial", "forca_radial"),
    ),
    "duty.load.fx": (
        *("fa", "f_a", "axial", "axial_load", "axial_force", "thrust", "thrust_load"),
        *("carga_axial", "forca_axial"),
    ),
    "duty.load.my": ("moment", "moment_y", "tilting_moment", "m", "momento"),
    "duty.load.mz": ("moment_z",),
    "duty.displacement.ry": ("tilt", "misalignment", "desalinhamento"),
    "bearing.designation": ("name_of_bearing", "designacao", "rolamento"),
    "bearing.ball_count": ("balls", "n_balls", "number_of_balls", "z", "esferas"),
    "bearing.ball_diameter": ("d_w", "dw", "d_b", "diameter", "diametro_da_esfera"),
    "bearing.pitch_diameter": ("d_m", "dm", "d_pw", "dpw", "mean_diameter", "pitch"),
    "bearing.contact_angle": ("angle", "alpha", "angulo", "angulo_de_contato"),
    "bearing.diametral_clearance": (
        *("clearance", "radial_clearance", "internal_clearance", "play", "p_d", "pd", "g_r", "gr"),
        *("folga", "folga_radial"),
    ),
    "bearing.inner_conformity": ("f_i", "fi", "conformity", "osculation"),
    "bearing.outer_conformity": ("f_o", "fo", "f_e", "fe"),
    "bearing.ball_material": ("balls_material", "hybrid", "ceramic"),
    "bearing.ring_material": ("material", "rings", "steel"),
    "bearing.arrangement": ("arranjo", "mounting_arrangement"),
    "bearing.spacing": ("distance", "spacer", "row_distance"),
    "bearing.preload": ("pre_load", "pretension", "pre_carga", "precarga"),
    "bearing.preload.spring": ("spring", "spring_force", "spring_preload"),
    "lubricant": ("oil", "grease", "oleo", "graxa", "lubrificante"),
    "lubricant.viscosity_40": ("viscosity", "nu", "nu_40", "v40", "viscosidade"),
    "lubricant.viscosity_100": ("nu_100", "v100"),
    "lubricant.viscosity_index": ("vi", "ivi"),
    "lubricant.friction_coefficient": ("mu", "friction", "coefficient", "atrito"),
    "temperature.lubricant": (
        *("temperature", "oil_temperature", "lubricant_temperature", "operating_temperature"),
        *("t", "temp", "temperatura"),
    ),
    "temperature.inner_ring": ("inner_temperature", "t_i"),
    "temperature.outer_ring": ("outer_temperature", "t_o"),
    "mounting.shaft_tolerance": ("shaft_fit", "fit", "shaft", "eixo"),
    "mounting.housing_tolerance": ("housing_fit", "housing", "alojamento"),
    "mounting.bore": ("d", "bore_diameter", "furo"),
    "mounting.outside_diameter": ("outer_diameter", "od"),
    "surface.inner_roughness": ("roughness", "rq", "rugosidade"),
    "life.dynamic_rating": ("c", "c_r", "cr", "dynamic_load_rating", "capacidade_dinamica"),
    "life.static_rating": ("c_0", "c0", "c0r", "static_load_rating", "capacidade_estatica"),
    "life.fatigue_load_limit": ("c_u", "cu", "p_u", "pu"),
    "life.required_life": ("vida", "hours", "life_hours", "horas"),
    "life.contamination": ("e_c", "ec", "eta_c"),
    "life.cleanliness": ("iso_4406", "iso4406", "limpeza"),
    "life.viscosity_ratio": ("kappa",),
    "life.reliability": ("confiabilidade",),
}
"""Words that people use, by the dotted name of the field."""

LISTED: Final = marked("rolamento sweep --list fields lists them all")
"""Where the list of fields that vary stands."""
_BY_WORD: Final = {word: name for name, words in ALIASES.items() for word in words}


def hint(name: str, known: Collection[str], here: Iterable[str], where: str = "") -> str:
    """Return what to say of a field that nobody knows, as the end of a sentence.

    Before the ones that are spelt most like it come fields of the same table, behind them those of
    others.

    Parameters
    ----------
    name
        Dotted, as it was given: ``"duty.speed"``, ``"fr"``, ``"duty.fz"``.
    known
        The dotted names of all fields.
    here
        What the table of the name does hold; or all names.
    where
        Where the list of many stands, as of `rolamento.errors.guess`.
    """
    here = tuple(here)
    table, _, leaf = name.rpartition(".")
    word = name if any("." in one for one in here) else leaf
    meant = _in_table(name, known) or ("" if alike(word, here) else _elsewhere(name, known))
    if not meant:
        return guess(word, here, where)
    inside = meant.removeprefix(f"{table}.")
    return said("did you mean {near}?", near=inside if inside in here else meant)


def _in_table(name: str, known: Collection[str]) -> str:
    """A field of the same table of the case, by its own word or another one for it."""
    top, dot, _ = name.partition(".")
    inside = [one for one in known if (one.startswith(f"{top}.") if dot else "." not in one)]
    return _by_leaf(name, inside) or _by_word(name, inside)


def _elsewhere(name: str, known: Collection[str]) -> str:
    return _by_word(name, known) or _by_leaf(name, known)


def _by_leaf(name: str, known: Iterable[str]) -> str:
    leaf = _folded(name)
    return next((one for one in known if _folded(one) == leaf), "")


def _by_word(name: str, known: Iterable[str]) -> str:
    """The field that a word stands for; of a record alone, whose names begin further in."""
    meant = _BY_WORD.get(_folded(name), "")
    return next((one for one in known if f".{meant}".endswith(f".{one}")), "") if meant else ""


def _folded(name: str) -> str:
    return name.rpartition(".")[2].casefold().replace("-", "_")
