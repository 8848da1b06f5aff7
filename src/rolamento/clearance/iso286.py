"""Limits of size of shafts and housing bores: ISO 286, for the tolerance classes of seats.

Standard tolerances and fundamental deviations are read from a table (data/iso286.toml). What the
standard derives is derived here: holes D to H and P mirror shafts; the holes K, M, N up to grade 8
and P up to grade 7 lie by Δ = IT(n) - IT(n-1) higher than the mirror, so that H7/p6 and P7/h6 fit
alike.
"""

from __future__ import annotations

import re
from typing import Any, Final, NoReturn

from rolamento.clearance.band import Band
from rolamento.clearance.tables import MICROMETRE, step_of, table
from rolamento.errors import InputError

__all__ = ["TOLERANCE_SOURCE", "hole_deviations", "shaft_deviations", "standard_tolerance"]

TOLERANCE_SOURCE: Final = "ISO 286-1:2010"

_CLASS: Final = re.compile(r"([A-Za-z]{1,2})([0-9]{1,2})")
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
    """
    grades = table("iso286")["grades"]
    if str(grade) not in grades:
        raise InputError(
            f"must be a grade from 1 to {len(grades)}", field="grade", value=grade, example="6"
        )
    return _grade(grade, _step(diameter, "diameter")) * MICROMETRE


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
    step = _step(diameter, "bore")
    width, data = _grade(grade, step), table("iso286")
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
    step = _step(diameter, "outside_diameter")
    width, data = _grade(grade, step), table("iso286")
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
    data = table("iso286")
    last = _LAST_SHIFTED[letters]
    if letters == "K" and grade > last:
        _refuse("has K with grades up to 8 only", "housing_tolerance", tolerance, "K7")
    if letters == "N" and grade > last:
        return 0.0
    deviation = -float(data["lower"][letters.lower()][step])
    if letters == "M" and grade == 6 and data["sizes_mm"][step] == 250:
        return _M6_FROM_250_TO_315
    if _FINEST_SHIFTED <= grade <= last:
        deviation += _grade(grade, step) - _grade(grade - 1, step)
    return deviation


def _parsed(tolerance: str, letters: tuple[str, ...], field: str, example: str) -> tuple[str, int]:
    found = _CLASS.fullmatch(tolerance.strip()) if len(tolerance) < 10 else None
    if found is None or found[1] not in letters or found[2] not in table("iso286")["grades"]:
        _refuse(
            f"must be one of {', '.join(letters)} and a grade from 1 to 12",
            field,
            tolerance,
            example,
        )
    if found[1] not in {"h", "js", "H", "JS"} and int(found[2]) < _FINEST_SHIFTED:
        _refuse("has grades 1 and 2 with h, js, H and JS only", field, tolerance, example)
    return found[1], int(found[2])


def _of_j(
    by_grade: dict[str, Any], grade: int, step: int, tolerance: str, field: str, example: str
) -> float:
    if str(grade) not in by_grade:
        _refuse(f"has j with the grades {', '.join(by_grade)} only", field, tolerance, example)
    return float(by_grade[str(grade)][step])


def _step(diameter: float, field: str) -> int:
    sizes = table("iso286")["sizes_mm"]
    return step_of(diameter, sizes, field=field, standard=TOLERANCE_SOURCE)


def _grade(grade: int, step: int) -> float:
    return float(table("iso286")["grades"][str(grade)][step])


def _band(lower: float, upper: float) -> Band:
    return Band(lower * MICROMETRE, upper * MICROMETRE)


def _refuse(rule: str, field: str, value: str, example: str) -> NoReturn:
    raise InputError(rule, field=field, value=value, example=f'{field} = "{example}"')
