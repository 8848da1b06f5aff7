"""Harris's table of a*, b* and δ* against F(ρ), and his examples 6.1 and 6.5.

The examples are worked by hand, with charts. Radaelli (2013) prints his results beside Harris's:
where the two differ, the number that should have been printed is Radaelli's.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import nan, pi, radians, sin
from typing import Any, Final

from rolamento.contact.hertz import hertz_coefficients
from rolamento.numerics.elliptic import complete
from rolamento.verification.check import Check, cut, half_unit, last_unit
from rolamento.verification.published import published
from rolamento.verification.static_examples import (
    AXIAL,
    BY_INTEGRAL,
    RADIAL,
    Number,
    axial_example,
    bearing_209,
    radial_example,
)

__all__ = ["checks"]

SYMBOLS: Final = {"semi_major": "a*", "semi_minor": "b*", "deflection": "δ*"}

_ABSCISSA: Final = "The tolerance includes what the rounding of the printed F(ρ) leaves open."
_MISPRINT: Final = (
    "A misprint, three units of the last digit off: the printed a* and b* of the same row give"
    " 0.9432, as the exact solution does."
)
_CUT: Final = "The digits beyond the printed ones are cut off, not rounded."
_LOW_DEFLECTION: Final = (
    "By hand: δ* comes out 0.2 to 0.3 % too low, the stiffness 0.4 to 0.8 % too high. Radaelli's"
    " table gives the number by computer beside it."
)
_INTEGRAL_BY_TABLE: Final = (
    "By hand: the continuous load integral, J_r cut to 0.218. The equilibrium counts the balls"
    " where they stand."
)
_DISPLACEMENT: Final = (
    "The continuous load integral, and the digits beyond the printed ones cut off. The equilibrium"
    " counts the balls where they stand."
)
_BY_HAND: Final = (
    "By hand, ended after three iterations (Radaelli's appendix C), whose table gives the number"
    " by computer beside it."
)
_FROM_ANGLE: Final = "Follows from the contact angle of the hand calculation: Q = F_a/(Z sin α)."


def checks() -> Iterator[Check]:
    """Compare the table of dimensionless parameters and both examples."""
    yield from _table()
    yield from _example_6_1()
    yield from _example_6_5()


def _table() -> Iterator[Check]:
    table = published("harris_1991")["hertz_table"]
    errata = {(e["curvature_difference"], e["column"]): e for e in table["errata"]}
    for row in table["rows"]:
        for column, printed in zip(table["columns"][1:], row[1:], strict=True):
            erratum = errata.get((row[0], column))
            yield _table_entry(table["source"], row, column, printed, erratum)


def _table_entry(
    source: str, row: list[str], column: str, printed: str, erratum: Mapping[str, Any] | None
) -> Check:
    """Compare one entry; the abscissa is rounded, too, and any number within that may be meant."""
    middle, width = float(row[0]), half_unit(row[0])
    computed, *ends = (
        float(getattr(hertz_coefficients(f), column))
        for f in (middle, middle - width, middle + width)
    )
    toward_print = max(ends) if float(printed) > computed else min(ends)
    return Check(
        source=source,
        quantity=f"{SYMBOLS[column]}, F = {row[0]}",
        unit="",
        printed=printed,
        computed=computed,
        tolerance=half_unit(printed) + abs(toward_print - computed),
        explanation=_MISPRINT if erratum else _ABSCISSA,
        evidence=_deflection_of_ellipse(row[1], row[2]) if erratum else None,
        corrected=erratum["corrected"] if erratum else "",
        deviation=float(erratum["units_off"]) * last_unit(printed) if erratum else 0.0,
    )


def _deflection_of_ellipse(semi_major: str, semi_minor: str) -> float:
    """δ* = 2 K(m) / (π a*) with m = 1 - (b*/a*)², from printed a* and b*. Harris (1991), 5."""
    a, b = float(semi_major), float(semi_minor)
    return float(2.0 * complete((b / a) ** 2)[0] / (pi * a))


def _example_6_1() -> Iterator[Check]:
    example = published("harris_1991")["example_6_1"]
    radaelli = published("radaelli_2013")["table_C1"]
    balls, integral = bearing_209().ball_count, float(example["printed"]["radial_integral"])
    heaviest = radaelli["radial_load_N"] / (balls * integral)
    found = radial_example()
    for key, printed in example["printed"].items():
        yield Check(
            source=example["source"],
            quantity=RADIAL[key].name,
            unit=RADIAL[key].unit,
            printed=printed,
            computed=found[key].computed,
            **_reason_6_1(key, printed, found[key], heaviest),
        )


def _reason_6_1(key: str, printed: str, number: Number, heaviest: float) -> dict[str, Any]:
    """Say why a number of example 6.1 differs, and what proves it; nothing where it does not.

    heaviest: Q_max = F_r/(Z J_r) with the printed J_r; N.
    """
    if key in ("curvature_difference_inner", "radial_integral"):
        evidence = cut(number.computed, printed)
        return {"explanation": _CUT, "evidence": evidence, "deviation": last_unit(printed)}
    if key.startswith(("deflection_star", "stiffness")):
        corrected = published("radaelli_2013")["table_C1"]["printed"][key]
        return {"explanation": _LOW_DEFLECTION, **_correction("table_C1", key, corrected)}
    if number.by_choice is None or float(printed) == 0.0:
        return {}
    if key == "radial_displacement":
        evidence = cut(number.by_choice, printed)
        reason: dict[str, Any] = {"explanation": _DISPLACEMENT, "evidence": evidence}
    else:
        share = number.by_choice / (radial_example()["max_ball_load"].by_choice or nan)
        reason = {"explanation": _INTEGRAL_BY_TABLE, "evidence": heaviest * share}
    return reason | {"deviation": BY_INTEGRAL * float(printed)}


def _example_6_5() -> Iterator[Check]:
    example = published("harris_1991")["example_6_5"]
    radaelli = published("radaelli_2013")
    angle = radians(float(example["printed"]["contact_angle_deg"]))
    for key, printed in example["printed"].items():
        if key == "ball_load":
            count = radaelli["bearing_218"]["ball_count"]
            load = radaelli["table_C2"]["axial_load_N"] / (count * sin(angle))
            reason: dict[str, Any] = {"explanation": _FROM_ANGLE, "evidence": load}
            reason |= {"deviation": _stated_share("table_C2", key) * float(printed)}
        else:
            corrected = example["corrected"][key]
            reason = {"explanation": _BY_HAND, **_correction("table_C2", key, corrected)}
        yield Check(
            source=example["source"],
            quantity=AXIAL[key].name,
            unit=AXIAL[key].unit,
            printed=printed,
            computed=axial_example()[key].computed,
            **reason,
        )


def _correction(table: str, key: str, corrected: str) -> dict[str, Any]:
    """Give a corrected number, and by how much the print is off as Radaelli's table states it."""
    deviation = _stated_share(table, key) * float(corrected) + half_unit(corrected)
    return {"corrected": corrected, "deviation": deviation}


def _stated_share(table: str, key: str) -> float:
    """Return the greatest difference of the two authors that rounds to the stated percentage."""
    percent = published("radaelli_2013")[table]["difference_percent"][key]
    return (float(percent) + half_unit(percent)) / 100.0
