"""What a catalogue holds of one bearing, with the source of each figure; read from CSV or TOML.

A CSV file has one bearing in a line, as `rolamento.io.tables` reads it, under the names here or the
headings of catalogues (`rolamento.catalogue.headings`). ``# maker: NSK``, ``# kind:``,
``# source:`` and ``# units: mm, kN`` before the header hold for all lines. A TOML file has one
``[[bearing]]`` a bearing, quantities with units.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Mapping, Sequence
from dataclasses import field, fields
from functools import cached_property
from itertools import pairwise
from math import degrees, radians
from typing import TYPE_CHECKING, Any, Final, cast, overload

import numpy as np

from rolamento.catalogue.headings import CatalogueColumn, columns_of, heads_catalogue, kind_of_word
from rolamento.errors import FileError, InputError, UnknownKeyError, guess
from rolamento.io.data import toml_of
from rolamento.io.text import parse_mapping
from rolamento.records import frozen
from rolamento.types import BALL, PLAIN_BALLS, TYPES, BearingKey, BearingType, of_balls
from rolamento.units import Dimension, readable, to_si
from rolamento.validate import one_of
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.io.numerals import Numerals


@frozen(kw_only=True)
class CatalogueBearing:
    """One bearing of a catalogue; what its maker does not publish is None.

    Attributes
    ----------
    designation
        As the maker writes it.
    maker
        Its name; may be empty.
    kind
        Key of its type in `rolamento.types.TYPES`.
    bore, outside_diameter, width
        d, D and B, in m; of a thrust bearing its height T, of a tapered roller bearing its width
        T. Without an inner ring the bore is the raceway of the shaft.
    inner_width, outer_width
        B and C of a tapered roller bearing, the widths of its cone and cup, in m.
    inner_raceway_diameter, outer_raceway_diameter
        F_w and E_w of a cylindrical or needle roller bearing, in m.
    contact_angle
        α, nominal, in rad.
    dynamic_rating, static_rating
        C and C_0 in N: radial, of a thrust bearing axial.
    axial_dynamic_rating, axial_static_rating
        C_a and C_0a in N of a four-point bearing whose maker gives these.
    axial_limit, axial_factor, static_axial_factor
        e, Y and Y_0 of a tapered roller bearing.
    load_centre
        a of a tapered roller bearing, in m: from the back face of its cup to where the contact
        lines meet the shaft.
    fatigue_load_limit
        C_u of the maker, in N.
    load_centre_distance
        Of a double row, in m: where the contact lines of its rows meet the shaft.
    limiting_speed
        Of the maker, with oil, in rad/s.
    f0
        Factor of the static rating and of the axial load factors, in N/mm².
    ball_count, ball_diameter, pitch_diameter
        Z, D and d_m (m), where published.
    inner_conformity, outer_conformity
        f_i and f_o, where published.
    roller_count, roller_diameter, effective_length
        Z, D_we (in the middle of a tapered roller) and L_we (m), where published.
    clearance_factor
        k_2 of a toroidal roller bearing: s takes k_2 s²/B off the radial clearance.
    sources
        Where each figure comes from, by its name.
    """

    designation: str
    maker: str = ""
    kind: BearingKey = PLAIN_BALLS
    bore: float
    outside_diameter: float
    width: float | None = None
    contact_angle: float | None = None
    dynamic_rating: float | None = None
    static_rating: float | None = None
    axial_dynamic_rating: float | None = None
    axial_static_rating: float | None = None
    load_centre_distance: float | None = None
    limiting_speed: float | None = None
    f0: float | None = None
    ball_count: int | None = None
    ball_diameter: float | None = None
    pitch_diameter: float | None = None
    inner_conformity: float | None = None
    outer_conformity: float | None = None
    inner_width: float | None = None
    outer_width: float | None = None
    inner_raceway_diameter: float | None = None
    outer_raceway_diameter: float | None = None
    axial_limit: float | None = None
    axial_factor: float | None = None
    static_axial_factor: float | None = None
    load_centre: float | None = None
    fatigue_load_limit: float | None = None
    roller_count: int | None = None
    roller_diameter: float | None = None
    effective_length: float | None = None
    clearance_factor: float | None = None
    sources: Mapping[str, str] = field(default_factory=dict, hash=False)

    def __repr__(self) -> str:
        """One line: designation, maker, kind, boundary dimensions and ratings."""
        sizes = (self.bore, self.outside_diameter, self.width)
        words = [f"{self.maker} {self.designation}".strip(), self.kind.replace("_", " ")]
        words.append(" x ".join(f"{1e3 * size:.6g}" for size in sizes if size is not None) + " mm")
        for name, rating in (("C", self.dynamic_rating), ("C_0", self.static_rating)):
            if rating is not None:
                words.append(f"{name} {rating / 1e3:.6g} kN")
        return f"<{', '.join(words)}>"

    @property
    def mean_diameter(self) -> float:
        """(d + D)/2, in m: near the pitch diameter."""
        return 0.5 * (self.bore + self.outside_diameter)

    @property
    def section_height(self) -> float:
        """(D − d)/2, in m."""
        return 0.5 * (self.outside_diameter - self.bore)

    @property
    def type(self) -> BearingType:
        """What type of bearing it is."""
        return TYPES[self.kind]

    @property
    def has_rollers(self) -> bool:
        """Whether it is a roller bearing."""
        return self.type.has_rollers

    @property
    def knows_elements(self) -> bool:
        """Whether the number and size of what rolls in it are published."""
        if self.has_rollers:
            return None not in (self.roller_count, self.roller_diameter, self.effective_length)
        return self.ball_count is not None and self.ball_diameter is not None

    @property
    def is_full_complement(self) -> bool:
        """Whether rollers fill its rows, without a cage: V behind the number (DIN 623-1)."""
        return self.has_rollers and _FULL.search(self.designation) is not None

    @property
    def rows(self) -> int:
        """Rows of balls, i."""
        return self.type.rows

    @property
    def rated(self) -> tuple[float | None, float | None]:
        """C and C_0 of the standards' formulas, in N.

        Those that are listed; of a four-point bearing with axial ratings, Y C_a and Y_0 C_0a.
        ISO 281:2007, table 3; ISO 76:2006, table 2.
        """
        if self.dynamic_rating is not None or self.static_rating is not None:
            return self.dynamic_rating, self.static_rating
        if self.contact_angle is None or self.contact_angle < _LEAST_STEEP:
            return None, None
        data, angle = toml_of("iso281"), degrees(self.contact_angle)
        steep, static = data["equivalent_load"]["steep"], data["static_equivalent_load"]
        dynamic = float(np.interp(angle, steep["contact_angle_deg"], steep["Y"]))
        at_rest = float(np.interp(angle, static["contact_angle_deg"], static["Y0"]))
        axial, axial_static = self.axial_dynamic_rating, self.axial_static_rating
        return (
            None if axial is None else dynamic * axial,
            None if axial_static is None else at_rest * axial_static,
        )

    @property
    def figures(self) -> dict[str, float]:
        """The figures that are published, by their name, in SI."""
        found = {name: getattr(self, name) for name in FIGURES}
        return {name: value for name, value in found.items() if value is not None}

    @property
    def source(self) -> str:
        """The source of the boundary dimensions."""
        return self.sources.get("bore", "")


FIGURES: Final = tuple(
    part.name
    for part in fields(CatalogueBearing)
    if part.name not in ("designation", "maker", "kind", "sources")
)
"""Names of the figures of a `CatalogueBearing`."""


_FULL: Final = re.compile(r"\d\s?C?VH?(?![A-Z])")
MAX_BEARINGS: Final = 20_000
_LONGEST_TEXT: Final = 200
_TEXTS: Final = ("designation", "maker", "kind", "source")
_EXAMPLE: Final = "designation,bore_mm,outside_diameter_mm,dynamic_rating_N"

_LEAST_STEEP: Final = radians(20.0)
"""From where on Y does not depend on the load."""
_LENGTHS: Final = (
    "bore", "outside_diameter", "width", "load_centre_distance", "ball_diameter", "pitch_diameter",
    "inner_width", "outer_width", "inner_raceway_diameter", "outer_raceway_diameter", "load_centre",
    "roller_diameter", "effective_length",
)  # fmt: skip
_FORCES: Final = (
    "dynamic_rating", "static_rating", "axial_dynamic_rating", "axial_static_rating",
    "fatigue_load_limit",
)  # fmt: skip
_FACTORS: Final = ("axial_limit", "axial_factor", "static_axial_factor", "clearance_factor")
_COUNTS: Final = ("ball_count", "roller_count")
_RATIOS: Final = ("f0", "inner_conformity", "outer_conformity", *_FACTORS)
_DIMENSIONS: Final[Mapping[str, Dimension]] = {
    **dict.fromkeys(_LENGTHS, "length"),
    **dict.fromkeys(_FORCES, "force"),
    "contact_angle": "angle",
    "limiting_speed": "angular_speed",
}
_LIMITS: Final[Mapping[str, tuple[float, float]]] = {
    **dict.fromkeys(_LENGTHS, (1e-5, 20.0)),
    **dict.fromkeys(_FORCES, (1e-3, 1e10)),
    "contact_angle": (0.0, radians(90.0)),
    "limiting_speed": (1e-3, 1e6),
    "f0": (1.0, 50.0),
    "inner_conformity": (0.501, 1.0),
    "outer_conformity": (0.501, 1.0),
    **dict.fromkeys(_FACTORS, (0.01, 20.0)),
    **dict.fromkeys(_COUNTS, (3, 500)),
}


def records_of_csv(text: str, source: str) -> tuple[CatalogueBearing, ...]:
    """Return the bearings of a CSV text.

    Parameters
    ----------
    text
        See the module.
    source
        What to call the text in messages, and the source of figures that name none.

    Raises
    ------
    InputError
        With the line, if a column is not known, a figure is missing or out of range.
    """
    from rolamento.io.tables import parse_table

    table = parse_table(
        text,
        source,
        most_rows=MAX_BEARINGS,
        example=_EXAMPLE,
        least_rows=0,
        is_header=heads_catalogue,
    )
    defaults: dict[str, str] = {name: table.said[name] for name in _TEXTS[1:] if name in table.said}
    try:
        columns = columns_of(table.header, table.said.get("unit", ""))
    except InputError as error:
        raise table.placed(error) from None
    words = [(column.figure, place) for place, column in columns.items() if column.is_text]
    numbers = [(column, place) for place, column in columns.items() if not column.is_text]
    numerals = table.numerals([place for _, place in numbers], argument=False)
    found: list[CatalogueBearing] = []
    for number, cells in enumerate(table.rows):
        try:
            texts = defaults | {name: cells[place] for name, place in words if cells[place]}
            figures = {
                column.figure: _number_of_cell(cells[place], column.title, numerals) * column.factor
                for column, place in numbers
                if cells[place]
            }
            found.append(_bearing_within_reason(texts, _sorted_out(figures, texts), source))
        except InputError as error:
            raise table.placed(error, number) from None
    return tuple(found)


class OwnRecords(Sequence[CatalogueBearing]):
    """Bearings of CSV files of this package; one becomes a record when it is asked for.

    Nobody looks for what is wrong in them, and few of some thousands are asked for: every command
    would wait. The tests hold that `records_of_csv` reads the same.

    Parameters
    ----------
    files
        Their texts, by their names.

    Attributes
    ----------
    designations
        as their makers write them
    """

    def __init__(self, files: Mapping[str, str]) -> None:
        self._rows = [
            (file, line)
            for file in (_OwnFile(text, source) for source, text in files.items())
            for line in file.lines
        ]
        self._made: dict[int, CatalogueBearing] = {}
        self.designations = [line.partition(",")[0] for _, line in self._rows]

    def __len__(self) -> int:
        return len(self._rows)

    @overload
    def __getitem__(self, place: int) -> CatalogueBearing: ...
    @overload
    def __getitem__(self, place: slice) -> Sequence[CatalogueBearing]: ...
    def __getitem__(self, place: int | slice) -> Any:
        if isinstance(place, slice):
            return [self[one] for one in range(*place.indices(len(self)))]
        place = range(len(self))[place]
        if place not in self._made:
            file, line = self._rows[place]
            self._made.setdefault(place, file.record(line))  # what another thread made first stays
        return self._made[place]


class _OwnFile:
    """A CSV file of this package: its rows, each of which begins with a designation; their meaning.

    A row is taken apart when its bearing is asked for.
    """

    def __init__(self, text: str, source: str) -> None:
        lines = [line for line in text.splitlines() if line]
        remarks = (line.lstrip("# ").partition(":") for line in lines if line.startswith("#"))
        self._source = source
        self._said = {name: value.strip() for name, colon, value in remarks if colon}
        self._header, *self.lines = (line for line in lines if not line.startswith("#"))

    @cached_property
    def _columns(self) -> Mapping[int, CatalogueColumn]:
        return columns_of(self._header.split(","), self._said.get("units", ""))

    def record(self, line: str) -> CatalogueBearing:
        """Return the bearing of a row."""
        (cells,) = csv.reader([line])
        texts: dict[str, str] = {
            name: self._said[name] for name in _TEXTS[1:] if name in self._said
        }
        figures: dict[str, float] = {}
        for place, column in self._columns.items():
            if cells[place] and column.is_text:
                texts[column.figure] = cells[place]
            elif cells[place]:
                figures[column.figure] = float(cells[place]) * column.factor
        return _bearing(texts, _sorted_out(figures, texts), self._source)


def _sorted_out(figures: dict[str, float], texts: dict[str, str]) -> dict[str, float]:
    """Give the figures whose names depend on the kind of bearing their own; and the kind its key.

    B of a row that has T is the width of a cone; Z and D_w are of balls or of rollers.
    """
    kind = kind_of_word(texts.get("kind", ""))
    if kind is not None:
        texts["kind"] = kind
    kind = texts.get("kind", "")
    rolling = TYPES[kind].rolls if kind in TYPES else BALL
    named = {"count": f"{rolling}_count", "element_diameter": f"{rolling}_diameter"}
    height = figures.pop("height", None)
    if height is not None:
        if "width" in figures:
            figures["inner_width"] = figures["width"]
        figures["width"] = height
    return {named.get(name, name): value for name, value in figures.items()}


def records_of_toml(text: str, source: str) -> tuple[CatalogueBearing, ...]:
    """Return the bearings of a TOML text.

    Parameters
    ----------
    text
        See the module; ``maker``, ``kind`` and ``source`` at the top hold for all bearings.
    source
        As in `records_of_csv`.

    Raises
    ------
    InputError
        If it is not TOML, a key is not known, a figure is missing or out of range.
    """
    data = parse_mapping(text, "toml", source)
    tables = data.pop("bearing", None)
    if not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise FileError(said("contains no [[bearing]]"), source=source, example="[[bearing]]")
    _check_keys(data, _TEXTS[1:], source)
    _check_count(len(tables) - 1, source)
    found = []
    for number, table in enumerate(tables, start=1):
        where = f"{source}, bearing {number}"
        _check_keys(table, (*_TEXTS, *FIGURES), where)
        merged = {**data, **table}
        try:
            texts = {name: _line_of_text(merged[name], name) for name in _TEXTS if name in merged}
            figures = {
                name: _figure_of_toml(table[name], name) for name in FIGURES if name in table
            }
            found.append(_bearing_within_reason(texts, figures, source))
        except InputError as error:
            raise error.with_details(source=where) from None
    return tuple(found)


def _bearing_within_reason(
    texts: Mapping[str, str], figures: Mapping[str, float], source: str
) -> CatalogueBearing:
    """Return a record whose figures are within reason."""
    for name in ("designation", "bore", "outside_diameter"):
        if not (texts.get(name) or figures.get(name)):
            raise InputError(said("is missing"), field=name)
    for name, value in figures.items():
        low, high = _LIMITS[name]
        if not low <= value <= high:
            raise InputError(
                said("must be between {low:.6g} and {high:.6g} in SI units", low=low, high=high),
                field=name,
            )
    for name in _COUNTS:
        if (count := figures.get(name)) is not None and count != int(count):
            raise InputError(said("must be an integer"), field=name, value=count)
    if figures["outside_diameter"] <= figures["bore"]:
        raise InputError(said("must be greater than the bore"), field="outside_diameter")
    _check_raceways(figures)
    kind = _kind_of(texts, figures)
    one_of(kind, "kind", TYPES)
    return _bearing(texts, figures, source)


def _kind_of(texts: Mapping[str, str], figures: Mapping[str, float]) -> str:
    return texts.get("kind") or of_balls(angled="contact_angle" in figures).key


def _bearing(
    texts: Mapping[str, str], figures: Mapping[str, float], source: str
) -> CatalogueBearing:
    values: dict[str, Any] = {**figures}
    values |= {name: int(figures[name]) for name in _COUNTS if name in figures}
    return CatalogueBearing(
        designation=texts["designation"],
        maker=texts.get("maker", ""),
        kind=cast("BearingKey", _kind_of(texts, figures)),
        sources=dict.fromkeys(figures, texts.get("source") or source),
        **values,
    )


def _check_raceways(figures: Mapping[str, float]) -> None:
    """Refuse raceways that are not, in this order, between bore and outside diameter."""
    names = ("bore", "inner_raceway_diameter", "outer_raceway_diameter", "outside_diameter")
    given = [name for name in names if name in figures]
    for inner, outer in pairwise(given):
        if figures[outer] < figures[inner] or ((inner, outer) == names[1:3] and (
            figures[outer] == figures[inner]
        )):  # fmt: skip
            raise InputError(
                said("must be greater than {name}, {low:.6g mm}", name=inner, low=figures[inner]),
                field=outer,
                value=readable(figures[outer], "length"),
            )


def _check_keys(table: Mapping[str, Any], known: tuple[str, ...], source: str) -> None:
    for name in table:
        if name not in known:
            rule = said("is an unknown key; {guess}", guess=guess(name, known))
            raise UnknownKeyError(rule, field=name, source=source)


def _check_count(number: int, source: str) -> None:
    if number >= MAX_BEARINGS:
        raise FileError(
            said("has more than {most} bearings", most=MAX_BEARINGS),
            source=source,
        )


def _number_of_cell(cell: str, name: str, numerals: Numerals) -> float:
    value = numerals.number(cell)
    if value is None:
        raise InputError(said("must be a number"), field=name, value=cell)
    return value


def _line_of_text(value: object, name: str) -> str:
    if not isinstance(value, str) or len(value) > _LONGEST_TEXT or not value.isprintable():
        raise InputError(said("must be one line of text"), field=name, value=value)
    return value.strip()


def _figure_of_toml(value: object, name: str) -> float:
    dimension = _DIMENSIONS.get(name)
    if dimension is None:
        return _plain_number(value, name)
    if not isinstance(value, str):
        raise InputError(
            said("needs a unit"),
            field=name,
            value=value,
            example=f'{name} = "{_example_quantity(dimension)}"',
        )
    try:
        return to_si(value, dimension)
    except InputError as error:
        raise error.with_details(field=name) from None


def _plain_number(value: object, name: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(said("must be a number"), field=name, value=value)
    try:
        return float(value)
    except OverflowError:
        raise InputError(said("must be a finite number"), field=name, value=value) from None


def _example_quantity(dimension: Dimension) -> str:
    examples: dict[str, str] = {
        "length": "25 mm", "force": "14 kN", "angle": "40 deg", "angular_speed": "9000 rpm"
    }  # fmt: skip
    return examples[dimension]
