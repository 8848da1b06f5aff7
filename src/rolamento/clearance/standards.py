"""What the standards say of clearances and tolerances, from tables that go by steps of a diameter.

Clearance classes of deep-groove ball bearings, of cylindrical roller bearings and of needle roller
bearings with machined rings (ISO 5753-1), bore and outside diameter of radial bearings (ISO 492),
and the tolerances of seats (ISO 286).
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Any, Final, Literal, NamedTuple, NoReturn, get_args

from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.units import MICROMETRE, MILLIMETRE, readable
from rolamento.validate import one_of
from rolamento.words import said

Limit = Literal["minimum", "mean", "maximum"]


class Band(NamedTuple):
    """Minimum and maximum value of a clearance or a deviation, in m."""

    low: float
    high: float

    @property
    def middle(self) -> float:
        """Half-way between the limits, in m."""
        return 0.5 * (self.low + self.high)

    @property
    def mirrored(self) -> Band:
        """The limits in the other order, for what makes the clearance smaller as it grows."""
        return Band(self.high, self.low)

    def at(self, limit: Limit) -> Any:
        """The value at a limit, in m."""
        return {"minimum": self.low, "mean": self.middle, "maximum": self.high}[limit]


_ROUNDING: Final = 1e-9
"""Relative: 0.025 m is 25 mm, whatever binary arithmetic makes of it."""


def step_of(diameter: float, limits: Sequence[float], *, field: str, standard: str) -> int:
    """Return the step of a diameter: over limits[i] up to and including limits[i + 1].

    Parameters
    ----------
    diameter
        In m.
    limits
        In mm, rising.
    field, standard
        For the message.

    Raises
    ------
    InputError
        If the diameter is outside the limits.
    """
    size = diameter / MILLIMETRE
    found = bisect_left(limits, size * (1.0 - _ROUNDING)) - 1
    if not isfinite(size) or not 0 <= found < len(limits) - 1:
        raise InputError(
            said(
                "is outside {standard}, which covers sizes over {above:.6g} mm up to {most:.6g} mm",
                standard=standard,
                above=limits[0],
                most=limits[-1],
            ),
            field=field,
            value=readable(diameter, "length") if isfinite(diameter) else diameter,
            example=f'{field} = "25 mm"',
        )
    return found


ClearanceClass = Literal[
    "C2", "CN", "C3", "C4", "C5", "CM", "CT", "CC1", "CC2", "CC", "CC3", "CC4", "CC5"
]
CLEARANCE_CLASSES: Final[tuple[ClearanceClass, ...]] = get_args(ClearanceClass)[:5]
"""Classes of ISO 5753-1, rising."""
CLEARANCE_SOURCE: Final = "ISO 5753-1:2009"
_E1102: Final = "NSK, Rolling Bearings (CAT. No. E1102e), table {table}"
_MATCHED_TABLE: Final = "9.14"


def _table(name: str) -> Mapping[str, Any]:
    whole = toml_of("iso5753", "rolamento.clearance")
    return whole[name] if name else whole


def clearance_source(clearance_class: str, table: str = "") -> str:
    """Return the source of a class's ranges."""
    if clearance_class in CLEARANCE_CLASSES:
        return CLEARANCE_SOURCE
    matched = clearance_class.startswith("CC")
    return _E1102.format(table=_MATCHED_TABLE if matched else _table(table)["table_of_maker"])


def class_clearance(bore: float, clearance_class: str, table: str = "") -> Band:
    """Radial internal clearance of a class, before mounting.

    Parameters
    ----------
    bore
        d, in m; over 2.5 mm, at most 500 mm.
    clearance_class
        ``"C2"``, ``"CN"``, ``"C3"``, ``"C4"``, ``"C5"``, and of electric motors ``"CM"``; of
        rollers also ``"CT"`` of motors and ``"CC1"`` to ``"CC5"`` (normal: ``"CC"``) of rings that
        are not interchangeable.
    table
        `BearingType.clearance_table`: empty for deep-groove ball bearings.

    Raises
    ------
    InputError
        If there is no such class, or its source has none for this bore.
    """
    data = _table(table)
    one_of(clearance_class, "clearance_class", data["classes"], 'clearance_class = "C3"')
    step = step_of(bore, data["bore_mm"], field="bore", standard=CLEARANCE_SOURCE)
    pair = data["classes"][clearance_class][step]
    begin = data.get("from_mm", {}).get(clearance_class, 0.0) * MILLIMETRE * (1.0 - _ROUNDING)
    if not pair or bore < begin:
        source = clearance_source(clearance_class, table)
        if source != CLEARANCE_SOURCE:
            rule = said(
                "has no range for a bore of {bore} in {clearance_source}",
                bore=readable(bore, "length"),
                clearance_source=source,
            )
        else:
            rule = said(
                "has no range for bores up to {least} in {clearance_source}",
                least=readable(data["bore_mm"][step + 1] * MILLIMETRE, "length"),
                clearance_source=source,
            )
        raise InputError(
            rule,
            field="clearance_class",
            value=clearance_class,
            example='clearance_class = "C3"',
        )
    return Band(pair[0] * MICROMETRE, pair[1] * MICROMETRE)


ToleranceClass = Literal["normal", "P6", "P5"]
BEARING_TOLERANCE_SOURCE: Final = "ISO 492:2014"


def bore_deviations(bore: float, tolerance_class: ToleranceClass = "normal") -> Band:
    """Limits of the mean bore from nominal (m); the upper one is 0.

    Raises
    ------
    InputError
        If the bore (m) is outside over 2.5 mm to 500 mm, or to what the class covers.
    """
    return _bearing_deviations("inner", bore, "bore", tolerance_class)


def outside_deviations(diameter: float, tolerance_class: ToleranceClass = "normal") -> Band:
    """Limits of the mean outside diameter from nominal (m); the upper one is 0.

    Raises
    ------
    InputError
        If the diameter (m) is outside over 6 mm to 630 mm, or to what the class covers.
    """
    return _bearing_deviations("outer", diameter, "outside_diameter", tolerance_class)


def _bearing_deviations(ring: str, diameter: float, field: str, tolerance_class: str) -> Band:
    data = toml_of("iso492", "rolamento.clearance")[ring]
    if tolerance_class not in data or tolerance_class == "sizes_mm":
        known = ", ".join(name for name in data if name != "sizes_mm")
        raise InputError(
            said("must be one of {known}", known=known),
            field="tolerance_class",
            value=tolerance_class,
            example='tolerance_class = "normal"',
        )
    standard = BEARING_TOLERANCE_SOURCE
    step = step_of(diameter, data["sizes_mm"], field=field, standard=standard)
    if step >= len(data[tolerance_class]):
        raise InputError(
            said(
                "has no table for {field} = {diameter}",
                field=field,
                diameter=readable(diameter, "length"),
            ),
            field="tolerance_class",
            value=tolerance_class,
            example='tolerance_class = "normal"',
        )
    return Band(-data[tolerance_class][step] * MICROMETRE, 0.0)


TOLERANCE_SOURCE: Final = "ISO 286-1:2010"

_TOLERANCE_CLASS: Final = re.compile(r"([A-Za-z]{1,2})([0-9]{1,2})")
_FINE_SHAFTS: Final = ("r", "s")
_LOWER_SHAFTS: Final = ("k", "m", "n", "p", *_FINE_SHAFTS)
_UPPER_SHAFTS: Final = ("d", "e", "f", "g", "h")
_SHAFTS: Final = (*_UPPER_SHAFTS, "js", "j", *_LOWER_SHAFTS)
_HOLES: Final = ("D", "E", "F", "G", "H", "JS", "J", "K", "M", "N", "P")
_FINEST_SHIFTED: Final = 3
_LAST_SHIFTED: Final = {"K": 8, "M": 8, "N": 8, "P": 7}
"""Coarsest grade at which a hole lies by Δ higher."""
_M6_FROM_250_TO_315: Final = -9.0
"""The one exception that the standard makes: -9 µm in place of -11 µm."""


def standard_tolerance(diameter: float, grade: int) -> float:
    """Width of a standard tolerance grade, IT1 to IT12; m.

    Raises
    ------
    InputError
        If there is no such grade here, or the diameter (m) is outside over 3 mm to 500 mm.

    >>> print(f"{1e6 * standard_tolerance(0.045, 6):.0f} um")
    16 um
    """
    grades = toml_of("iso286", "rolamento.clearance")["grades"]
    if str(grade) not in grades:
        raise InputError(
            said("must be a grade from 1 to {count}", count=len(grades)),
            field="grade",
            value=grade,
            example="6",
        )
    return _grade_width(grade, _size_step(diameter, "diameter")) * MICROMETRE


def shaft_deviations(diameter: float, tolerance: str) -> Band:
    """Lower and upper deviation of a shaft from its nominal diameter; m.

    Parameters
    ----------
    diameter
        Nominal, in m; over 3 mm, at most 500 mm.
    tolerance
        Such as ``"k5"``: d to h, js, j (5 to 7), k, m, n, p, r or s, and a grade up to 12.

    Raises
    ------
    InputError
        If the class or the diameter is not in the tables.
    """
    letters, grade = _parsed(tolerance, _SHAFTS, "shaft_tolerance", "k5")
    step = _size_step(diameter, "bore")
    width, data = _grade_width(grade, step), toml_of("iso286", "rolamento.clearance")
    if letters == "js":
        return _band(-0.5 * width, 0.5 * width)
    if letters in _UPPER_SHAFTS:
        upper = data["upper"][letters][step]
        return _band(upper - width, upper)
    if letters == "j":
        lower = _of_j(data["shaft_j"], grade, step, tolerance, "shaft_tolerance", "j6")
    elif letters in _FINE_SHAFTS:
        fine = data["fine"]
        lower = fine[letters][
            step_of(diameter, fine["sizes_mm"], field="bore", standard=TOLERANCE_SOURCE)
        ]
    else:
        lower = data["lower"][letters][step]
        if letters == "k" and not 4 <= grade <= 7:
            lower = 0.0
    return _band(lower, lower + width)


def hole_deviations(diameter: float, tolerance: str) -> Band:
    """Lower and upper deviation of a housing bore from its nominal diameter; m.

    Parameters
    ----------
    diameter
        Nominal, in m; over 3 mm, at most 500 mm.
    tolerance
        Such as ``"J7"``: D to H, JS, J (6 to 8), K (up to 8), M, N or P, and a grade up to 12.

    Raises
    ------
    InputError
        If the class or the diameter is not in the tables.
    """
    letters, grade = _parsed(tolerance, _HOLES, "housing_tolerance", "H7")
    step = _size_step(diameter, "outside_diameter")
    width, data = _grade_width(grade, step), toml_of("iso286", "rolamento.clearance")
    shaft = letters.lower()
    if letters == "JS":
        return _band(-0.5 * width, 0.5 * width)
    if shaft in _UPPER_SHAFTS:
        lower = -data["upper"][shaft][step]
        return _band(lower, lower + width)
    if letters == "J":
        upper = _of_j(data["hole_j"], grade, step, tolerance, "housing_tolerance", "J7")
    else:
        upper = _shifted(letters, grade, step, tolerance)
    return _band(upper - width, upper)


def _shifted(letters: str, grade: int, step: int, tolerance: str) -> float:
    """Upper deviation of the holes K to P."""
    data = toml_of("iso286", "rolamento.clearance")
    last = _LAST_SHIFTED[letters]
    if letters == "K" and grade > last:
        _refuse(said("has K with grades up to 8 only"), "housing_tolerance", tolerance, "K7")
    if letters == "N" and grade > last:
        return 0.0
    deviation = -float(data["lower"][letters.lower()][step])
    if letters == "M" and grade == 6 and data["sizes_mm"][step] == 250:
        return _M6_FROM_250_TO_315
    if _FINEST_SHIFTED <= grade <= last:
        deviation += _grade_width(grade, step) - _grade_width(grade - 1, step)
    return deviation


def _parsed(tolerance: str, letters: tuple[str, ...], field: str, example: str) -> tuple[str, int]:
    found = _TOLERANCE_CLASS.fullmatch(tolerance.strip()) if len(tolerance) < 10 else None
    if (
        found is None
        or found[1] not in letters
        or found[2] not in toml_of("iso286", "rolamento.clearance")["grades"]
    ):
        _refuse(
            said("must be one of {known} with a grade from 1 to 12", known=", ".join(letters)),
            field,
            tolerance,
            example,
        )
    if found[1] not in {"h", "js", "H", "JS"} and int(found[2]) < _FINEST_SHIFTED:
        rule = said("has grades 1 and 2 for h, js, H and JS only")
        _refuse(rule, field, tolerance, example)
    return found[1], int(found[2])


def _of_j(
    by_grade: dict[str, Any], grade: int, step: int, tolerance: str, field: str, example: str
) -> float:
    if str(grade) not in by_grade:
        rule = said("has j for the grades {grades} only", grades=", ".join(by_grade))
        _refuse(rule, field, tolerance, example)
    return float(by_grade[str(grade)][step])


def _size_step(diameter: float, field: str) -> int:
    sizes = toml_of("iso286", "rolamento.clearance")["sizes_mm"]
    return step_of(diameter, sizes, field=field, standard=TOLERANCE_SOURCE)


def _grade_width(grade: int, step: int) -> float:
    return float(toml_of("iso286", "rolamento.clearance")["grades"][str(grade)][step])


def _band(lower: float, upper: float) -> Band:
    return Band(lower * MICROMETRE, upper * MICROMETRE)


def _refuse(rule: str, field: str, value: str, example: str) -> NoReturn:
    raise InputError(rule, field=field, value=value, example=f'{field} = "{example}"')
