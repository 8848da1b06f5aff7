"""Rating life as bearing makers work it out: their examples, and their tables of load factors."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import cbrt, nan, radians
from typing import Any, Final

from rolamento.life.equivalent_load import equivalent_load, load_factors, static_equivalent_load
from rolamento.life.iso281 import basic_rating_life, hours
from rolamento.verification.check import Check
from rolamento.verification.published import RPM, published

__all__ = ["checks"]

_MPA: Final = 1e6
_STEEP_LOAD: Final = 1.0
"""Relative axial load at steep angles, where it does not matter; MPa."""
_HUNDREDTH: Final = 0.005
"""Tolerance of factors with two decimals: makers leave out zeros at the end."""
_ROW_SHARE: Final = 2.0**0.7
_SHARE_DEVIATION: Final = 150.0
"""Hours: the most that 1.62 in the place of 2^0.7 may make of the pump's life."""
_NAMES: Final = {
    "e": ("limit", False),
    "X": ("radial", False),
    "Y": ("axial", False),
    "Y_1": ("axial_below", True),
    "X_2": ("radial", True),
    "Y_2": ("axial", True),
}
"""Attribute of `LoadFactors`, and whether of two rows."""

_PAIR: Final = (
    "SKF rounds 2^0.7 to 1.62 for the rating of a pair. Tolerance: half of the last digit that is"
    " not zero."
)


def checks() -> Iterator[Check]:
    """Compare lives, then the factors of the equivalent loads, then the speed factor."""
    data = published("makers_life")
    for example in data["life"]:
        yield from _lives(example)
    yield from _pump(data["pump"])
    yield from _sets(data["lyc"])
    yield from _deep_grooves(data["nmb"])
    table = data["speed_factor"]
    life = basic_rating_life(1.0, 1.0)
    for speed, printed in zip(table["speed_rpm"], table["factor"], strict=True):
        found = cbrt(float(hours(life, speed * RPM)) / table["hours"])
        yield _check(table["source"], f"{speed} r/min", printed, found, nan)


def _lives(example: Mapping[str, Any]) -> Iterator[Check]:
    life = basic_rating_life(example["dynamic_rating_N"], example["load_N"])
    source, name = example["source"], example["name"]
    if "million" in example:
        yield _check(source, f"L_10, {name}", example["million"], float(life), nan, "10⁶")
    found = float(hours(life, example["speed_rpm"] * RPM))
    yield _check(source, f"L_10h, {name}", example["hours"], found, nan, "h")


def _pump(example: Mapping[str, Any]) -> Iterator[Check]:
    found = equivalent_load(
        example["radial_load_N"],
        example["axial_load_N"],
        radians(example["contact_angle_deg"]),
        _STEEP_LOAD * _MPA,
        double_row=True,
    )
    load = float(found.load)

    def life(share: float) -> float:
        rating = share * example["dynamic_rating_N"]
        return float(hours(basic_rating_life(rating, load), example["speed_rpm"] * RPM))

    yield Check(
        source=example["source"],
        quantity=f"L_10h, {example['name']}",
        unit="h",
        printed=example["hours"],
        computed=life(_ROW_SHARE),
        explanation=_PAIR,
        evidence=life(example["printed_pair"]),
        deviation=_SHARE_DEVIATION,
    )


def _sets(table: Mapping[str, Any]) -> Iterator[Check]:
    source, shallow = table["source"], table["shallow"]
    angle = shallow["contact_angle_deg"]
    for index, load in enumerate(table["relative_axial_load_MPa"]):
        for name in ("e", "Y", "Y_1", "Y_2"):
            found = _factor(name, angle, float(load))
            quantity = f"{name}, {angle:g}°, {load} MPa"
            yield _check(source, quantity, shallow[name][index], found, _HUNDREDTH)
    for row in table["steep"]:
        for name, printed in row["factors"].items():
            found = _factor(name, row["contact_angle_deg"], _STEEP_LOAD)
            quantity = f"{name}, {row['contact_angle_deg']:g}°"
            yield _check(source, quantity, printed, found, _HUNDREDTH)
    for row in table["static"]:
        for name, printed in row["factors"].items():
            found = _static_factor(name, row["contact_angle_deg"])
            quantity = f"{name}, {row['contact_angle_deg']:g}°"
            yield _check(source, quantity, printed, found, _HUNDREDTH)


def _deep_grooves(table: Mapping[str, Any]) -> Iterator[Check]:
    for index, load in enumerate(table["relative_axial_load_MPa"]):
        for name in ("e", "Y"):
            found = _factor(name, 0.0, float(load))
            quantity = f"{name}, {load} MPa"
            yield _check(table["source"], quantity, table[name][index], found, _HUNDREDTH)
    radial = _factor("X", 0.0, _STEEP_LOAD)
    yield _check(table["source"], "X", table["X"], radial, _HUNDREDTH)
    for name, printed in table["static"].items():
        found = _static_factor(name, 0.0)
        yield _check(table["static_source"], name, printed, found, _HUNDREDTH)


def _factor(name: str, degrees: float, megapascal: float) -> float:
    attribute, double = _NAMES[name]
    found = load_factors(radians(degrees), megapascal * _MPA, double_row=double)
    return float(getattr(found, attribute))


def _static_factor(name: str, degrees: float) -> float:
    """X_0 or Y_0 of one row, Y_02 of two, out of equivalent loads that they decide."""
    angle, double = radians(degrees), name == "Y_02"
    axial = float(static_equivalent_load(0.0, 1.0, angle, double_row=double))
    if name != "X_0":
        return axial
    return float(static_equivalent_load(1.0, 10.0, angle)) - 10.0 * axial


def _check(
    source: str, quantity: str, printed: str, computed: float, tolerance: float, unit: str = ""
) -> Check:
    return Check(
        source=source,
        quantity=quantity,
        unit=unit,
        printed=printed,
        computed=computed,
        tolerance=tolerance,
    )
