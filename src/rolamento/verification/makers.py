"""Rigidity and preload of pairs and sets as bearing makers print them.

Makers reckon with a contact angle that stays: then the force grows with the 3/2 power of the
axial approach, and the factors of sets are plain numbers, the same for every bearing. The angle
does grow, so that a real pair is stiffer and holds its second bearing longer. Where the preload
vanishes the two meet: that is the proof of what the explanations say. What they print as
rigidities has the growth in it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any, Final

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty, Load
from rolamento.rows.ball import solve, solve_batch
from rolamento.rows.ball.preload import preload_of
from rolamento.verification.check import Check, half_unit
from rolamento.verification.published import bearing_of, published, steel

__all__ = ["bearing", "checks", "factor"]

_PER_MICROMETRE: Final = 1e-6
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
_CONFORMITY: Final = (
    "The conformity and the elastic constants are not published: 0.52 and 208 GPa, for all alike,"
    " give these bearings within 1 %, which is the tolerance where it is more than half a digit."
)
_ROUND: Final = (
    "One number for all bearings, in steps of 0.05: half a step is the tolerance, or half a digit"
    " where that is more. It follows from a contact angle that does not change, as under vanishing"
    " preload. Computed for S 6012 E at light preload, whose contact angle grows under the load."
)
_CONSTANT: Final = (
    "2^(3/2), from a contact angle that does not change, as under vanishing preload. Computed for"
    " S 6012 E at light preload, whose contact angle grows under the load."
)


def bearing(designation: str, **changes: Any) -> Bearing:
    """Return a GMN bearing, with what the catalogue does not tell as assumed.

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
        yield _factor_check(line)


def _rigidities() -> Iterator[Check]:
    data = published("makers")
    for designation in data["assumed"]["designations"]:
        row = gmn_row(designation)
        pair = bearing(designation, **_arranged("DB"), preload={"force": 1.0})
        batch = solve_batch(
            Case(bearing=pair, duty=Duty()), {"bearing.preload.force": row["preload_N"]}
        )
        found = batch.stiffness[:, 0, 0] * _PER_MICROMETRE
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


def _factor_check(line: Mapping[str, Any]) -> Check:
    printed = line["printed"]
    light = float(gmn_row(_FACTOR_BEARING)["preload_N"][0])
    exact = printed == "2.83"
    return Check(
        source=f"{line['source']}, over the pair's preload or rigidity",
        quantity=f"{_QUANTITIES[line['quantity']]}, {line['arrangement']}",
        unit="",
        printed=printed,
        computed=factor(line["quantity"], line["arrangement"], light),
        tolerance=half_unit(printed) if exact else max(half_unit(printed), 0.025),
        explanation=_CONSTANT if exact else _ROUND,
        evidence=factor(line["quantity"], line["arrangement"], _VANISHING),
        deviation=_GROWTH * float(printed),
    )


@cache
def factor(quantity: str, arrangement: str, pair_preload: float) -> float:
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
    preload = {"offset": solve(alone).displacement.x}
    pair, several = (
        Case(bearing=bearing(_FACTOR_BEARING, **_arranged(name), preload=preload), duty=Duty())
        for name in ("DB", arrangement)
    )
    if quantity == "rigidity":
        stiffness = (float(solve_batch(case).stiffness[0, 0, 0]) for case in (several, pair))
        return next(stiffness) / next(stiffness)
    # the single row of TBT and QBT faces +x: a load toward -x unloads it
    toward = 1.0 if arrangement == "DB" else -1.0
    load = several.replace(duty=Duty(load=Load(fx=toward * pair_preload)))
    found = preload_of(load if quantity == "lift_off" else several)
    assert found is not None
    return found.loss_factor if quantity == "lift_off" else found.at_rest / pair_preload


def _arranged(arrangement: str) -> dict[str, Any]:
    return {
        "arrangement": arrangement,
        "spacing": f"{published('makers')['assumed']['spacing_mm']} mm",
    }
