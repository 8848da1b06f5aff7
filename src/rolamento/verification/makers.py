"""What bearing makers print: rigidity and preload of pairs and sets, rating lives, load factors.

Makers calculate with a contact angle that stays: then the force grows with the 3/2 power of the
axial approach, and the factors of sets are plain numbers, the same for every bearing. The angle
does grow, so that a real pair is stiffer and holds its second bearing longer. Where the preload
vanishes the two meet: that is the proof of what the explanations say. What they print as
rigidities has the growth in it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from math import cbrt, nan, radians
from typing import Any, Final

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty, Load
from rolamento.life.equivalent_load import equivalent_load, load_factors, static_equivalent_load
from rolamento.life.iso281 import basic_rating_life, hours
from rolamento.solution import solve
from rolamento.units import MICROMETRE, RPM
from rolamento.verification.check import Check, bearing_of, half_unit, published, steel
from rolamento.words import Note

_RIGIDITY_FIT: Final = 0.01
"""Relative: how well one conformity and one modulus fit the bearings that are compared."""
_FACTOR_BEARING: Final = "S 6012 E"
_VANISHING: Final = 1e-3
"""N of preload: the contact angle hardly changes."""
_GROWTH: Final = 0.05
"""Relative: the most that the growth of the contact angle may make of a factor here."""

_QUANTITIES: Final = {
    "preload": "preload",
    "rigidity": "axial rigidity",
    "lift_off": "unloading load",
}
_CONFORMITY: Final = Note("verify_makers_conformity")
_ROUND: Final = Note("verify_makers_round")
_CONSTANT: Final = Note("verify_makers_constant")


def bearing(designation: str, **changes: Any) -> Bearing:
    """Return a GMN bearing, with what the catalogue does not give as assumed.

    Parameters
    ----------
    designation
        As in the catalogue.
    changes
        Fields of `Bearing` to be given as well or instead.

    Raises
    ------
    KeyError
        If the catalogue has no such bearing.
    """
    data = published("makers")
    assumed, row = data["assumed"], gmn_row(designation)
    table = {**row, **{f"{race}_conformity": assumed["conformity"] for race in ("inner", "outer")}}
    material = steel(assumed["youngs_modulus_GPa"] * 1e9, assumed["poisson_ratio"])
    return bearing_of(table, material).replace(**changes)


def gmn_row(designation: str) -> Mapping[str, Any]:
    """Return a bearing's line of GMN's table, by column; KeyError if there is none."""
    table = published("makers")["gmn"]
    rows = {row[0]: dict(zip(table["columns"], row, strict=True)) for row in table["rows"]}
    return rows[designation]


def checks() -> Iterator[Check]:
    """Compare the rigidities of pairs, then the factors of sets."""
    yield from _rigidities()
    for line in published("makers")["factor"]:
        yield _set_factor_check(line)


def _rigidities() -> Iterator[Check]:
    data = published("makers")
    for designation in data["assumed"]["designations"]:
        row = gmn_row(designation)
        pair = bearing(designation, **_arranged("DB"), preload={"force": 1.0})
        solved = solve(Case(bearing=pair, duty=Duty()), {"bearing.preload.force": row["preload_N"]})
        found = solved.stiffness["fx", "x"] * MICROMETRE
        for force, printed, computed in zip(
            row["preload_N"], row["rigidity_N_per_um"], found.tolist(), strict=True
        ):
            yield Check(
                source="GMN catalogue 4000 0813 EN, table of bearing data",
                quantity=f"C_ax, {designation}, {force:g} N",
                unit="N/µm",
                printed=str(printed),
                computed=computed,
                tolerance=max(half_unit(str(printed)), _RIGIDITY_FIT * printed),
                explanation=_CONFORMITY,
            )


def _set_factor_check(line: Mapping[str, Any]) -> Check:
    printed = line["printed"]
    light = float(gmn_row(_FACTOR_BEARING)["preload_N"][0])
    exact = printed == "2.83"
    return Check(
        source=f"{line['source']}, over the pair's preload or rigidity",
        quantity=f"{_QUANTITIES[line['quantity']]}, {line['arrangement']}",
        unit="",
        printed=printed,
        computed=set_factor(line["quantity"], line["arrangement"], light),
        tolerance=half_unit(printed) if exact else max(half_unit(printed), 0.025),
        explanation=_CONSTANT if exact else _ROUND,
        evidence=set_factor(line["quantity"], line["arrangement"], _VANISHING),
        deviation=_GROWTH * float(printed),
    )


@cache
def set_factor(quantity: str, arrangement: str, pair_preload: float) -> float:
    """Return a quantity of a set over that of the pair of the same bearings and offset.

    Parameters
    ----------
    quantity
        ``"preload"``, ``"rigidity"``, or ``"lift_off"``: the axial load, toward the side with more
        bearings, that unloads the others, over the pair's preload.
    arrangement
        ``"DB"``, ``"TBT"`` or ``"QBT"``.
    pair_preload
        In N.
    """
    alone = Case(bearing=bearing(_FACTOR_BEARING), duty=Duty(load=Load(fx=pair_preload)))
    preload = {"offset": float(solve(alone).displacement.x[0])}
    pair, several = (
        Case(bearing=bearing(_FACTOR_BEARING, **_arranged(name), preload=preload), duty=Duty())
        for name in ("DB", arrangement)
    )
    if quantity == "rigidity":
        stiffness = (float(solve(case).stiffness["fx", "x"][0]) for case in (several, pair))
        return next(stiffness) / next(stiffness)
    # the single row of TBT and QBT faces +x: a load toward -x unloads it
    toward = 1.0 if arrangement == "DB" else -1.0
    load = several.replace(duty=Duty(load=Load(fx=toward * pair_preload)))
    found = solve(load if quantity == "lift_off" else several).preload
    assert found is not None
    assert found.loss_factor is not None
    return found.loss_factor if quantity == "lift_off" else found.at_rest / pair_preload


def _arranged(arrangement: str) -> dict[str, Any]:
    return {
        "arrangement": arrangement,
        "spacing": f"{published('makers')['assumed']['spacing_mm']} mm",
    }


_MPA: Final = 1e6
_STEEP_LOAD: Final = 1.0
"""Relative axial load at steep angles, where it does not matter; MPa."""
_HUNDREDTH: Final = 0.005
"""Tolerance of factors with two decimals: makers leave out zeros at the end."""
_ROW_SHARE: Final = 2.0**0.7
_SHARE_DEVIATION: Final = 150.0
"""Hours: the most that 1.62 in the place of 2^0.7 may make of the pump's life."""
_FACTOR_ATTRIBUTES: Final = {
    "e": ("limit", False),
    "X": ("radial", False),
    "Y": ("axial", False),
    "Y_1": ("axial_below", True),
    "X_2": ("radial", True),
    "Y_2": ("axial", True),
}
"""Attribute of `LoadFactors`, and whether of two rows."""

_PAIR: Final = Note("verify_makers_pair")


def life_checks() -> Iterator[Check]:
    """Compare lives, then the factors of the equivalent loads, then the speed factor."""
    data = published("makers_life")
    for example in data["life"]:
        yield from _lives_of_example(example)
    yield from _life_of_pump(data["pump"])
    yield from _factors_of_sets(data["lyc"])
    yield from _factors_of_deep_grooves(data["nmb"])
    table = data["speed_factor"]
    life = basic_rating_life(1.0, 1.0)
    for speed, printed in zip(table["speed_rpm"], table["factor"], strict=True):
        found = cbrt(float(hours(life, speed * RPM)) / table["hours"])
        yield _life_check(table["source"], f"{speed} r/min", printed, found, nan)


def _lives_of_example(example: Mapping[str, Any]) -> Iterator[Check]:
    life = basic_rating_life(example["dynamic_rating_N"], example["load_N"])
    source, name = example["source"], example["name"]
    if "million" in example:
        yield _life_check(source, f"L_10, {name}", example["million"], float(life), nan, "10⁶")
    found = float(hours(life, example["speed_rpm"] * RPM))
    yield _life_check(source, f"L_10h, {name}", example["hours"], found, nan, "h")


def _life_of_pump(example: Mapping[str, Any]) -> Iterator[Check]:
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


def _factors_of_sets(table: Mapping[str, Any]) -> Iterator[Check]:
    source, shallow = table["source"], table["shallow"]
    angle = shallow["contact_angle_deg"]
    for index, load in enumerate(table["relative_axial_load_MPa"]):
        for name in ("e", "Y", "Y_1", "Y_2"):
            found = _load_factor(name, angle, float(load))
            quantity = f"{name}, {angle:g}°, {load} MPa"
            yield _life_check(source, quantity, shallow[name][index], found, _HUNDREDTH)
    for row in table["steep"]:
        for name, printed in row["factors"].items():
            found = _load_factor(name, row["contact_angle_deg"], _STEEP_LOAD)
            quantity = f"{name}, {row['contact_angle_deg']:g}°"
            yield _life_check(source, quantity, printed, found, _HUNDREDTH)
    for row in table["static"]:
        for name, printed in row["factors"].items():
            found = _static_factor(name, row["contact_angle_deg"])
            quantity = f"{name}, {row['contact_angle_deg']:g}°"
            yield _life_check(source, quantity, printed, found, _HUNDREDTH)


def _factors_of_deep_grooves(table: Mapping[str, Any]) -> Iterator[Check]:
    for index, load in enumerate(table["relative_axial_load_MPa"]):
        for name in ("e", "Y"):
            found = _load_factor(name, 0.0, float(load))
            quantity = f"{name}, {load} MPa"
            yield _life_check(table["source"], quantity, table[name][index], found, _HUNDREDTH)
    radial = _load_factor("X", 0.0, _STEEP_LOAD)
    yield _life_check(table["source"], "X", table["X"], radial, _HUNDREDTH)
    for name, printed in table["static"].items():
        found = _static_factor(name, 0.0)
        yield _life_check(table["static_source"], name, printed, found, _HUNDREDTH)


def _load_factor(name: str, degrees: float, megapascal: float) -> float:
    attribute, double = _FACTOR_ATTRIBUTES[name]
    found = load_factors(radians(degrees), megapascal * _MPA, double_row=double)
    return float(getattr(found, attribute))


def _static_factor(name: str, degrees: float) -> float:
    """X_0 or Y_0 of one row, Y_02 of two, out of equivalent loads that they decide."""
    angle, double = radians(degrees), name == "Y_02"
    axial = float(static_equivalent_load(0.0, 1.0, angle, double_row=double))
    if name != "X_0":
        return axial
    return float(static_equivalent_load(1.0, 10.0, angle)) - 10.0 * axial


def _life_check(
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
