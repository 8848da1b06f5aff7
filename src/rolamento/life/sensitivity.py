"""What would help: the life after one change at a time, the bearing solved anew each time.

Where there is no equilibrium, the axial load that gives it one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import hypot, tan
from typing import Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.profile import Profile
from rolamento.case.roller_bearing import RollerBearing
from rolamento.errors import InputError
from rolamento.life.conditions import LifeConditions, conditions_of
from rolamento.life.summary import LifeSummary, life
from rolamento.records import frozen
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.status import NO_EQUILIBRIUM
from rolamento.words import Note, said

_LOAD: Final = 0.9
_CLEARANCE: Final = 5e-6
_VISCOSITY: Final = 1.5
_CLEANLINESS: Final = 0.2
_TILT: Final = 0.5
_HOLDING: Final = (1.25, 2.0, 4.0)
"""Axial load over F_r tan α. At 1.22 (balls; rollers 1.26) half of the elements carry: J_r/J_a of
Harris and Kotzalas, Essential Concepts of Bearing Technology, 5th ed., chapter 5, ε = 0.5; the
others are tried where centrifugal forces ask for more."""

CHANGES: Final[Mapping[str, float]] = {
    "less_load": _LOAD - 1.0,
    "less_clearance": -_CLEARANCE,
    "more_clearance": _CLEARANCE,
    "thicker_oil": _VISCOSITY - 1.0,
    "cleaner_oil": _CLEANLINESS,
    "less_tilt": _TILT - 1.0,
    "profiled_rollers": 0.0,
}
"""By how much each quantity is changed, by the name of the change: relative, m, or absolute."""


@frozen
class Change:
    """One change: its name in `CHANGES`, and the life after it over the life before.

    The ratio is NaN where the theory cannot judge: where either has no life, no end, or only a
    bound, or the changed case has no result.
    """

    name: str
    life_ratio: float

    @property
    def note(self) -> Note:
        """What is changed, and by how much."""
        return Note(self.name, {"change": round(CHANGES[self.name], 9)})


def sensitivity(solved: Solved, conditions: LifeConditions | None = None) -> tuple[Change, ...]:
    """Life ratios of changes of load, clearance, oil and cleanliness, the most helpful first.

    Of rollers those of the tilt and, where they are straight, of their profile as well.

    By the life that leads: the modified reference life where viscosity and contamination are given,
    else the reference life; changes of the oil only with the former, of clearance only for a
    bearing given by it.

    Parameters
    ----------
    solved
        Of `rolamento.solve`: a single case, from which nothing varied.
    conditions
        As `life`.

    Raises
    ------
    InputError
        If these are several cases, and as `life`.
    """
    if len(solved) != 1 or solved.varied:
        raise InputError(
            said("must be a single case in which nothing varies"),
            field="solved",
            value=f"{len(solved)} cases",
            example="sensitivity(rolamento.solve(case))",
        )
    given = conditions_of(solved) if conditions is None else conditions
    case = solved.case
    before = _life(solved, given)

    def after(changed: Case | None) -> float:
        """Life of a changed case over the one before; NaN where it cannot be, or has no result."""
        if changed is None:
            return float("nan")
        again = replace(solve(changed), before_mounting=solved.before_mounting)  # rated as before
        return _ratio(_life(again, given), before) if again.converged[0] else float("nan")

    less = _with_less_load(case)
    found = [] if less is None else [Change("less_load", after(less))]
    mixed = len({place.bearing.element for place in case.bearing.places}) > 1
    for name, step in (("less_clearance", -_CLEARANCE), ("more_clearance", _CLEARANCE)):
        if case.bearing.diametral_clearance is not None and not mixed:  # whose rows have their own
            found.append(Change(name, after(_with_clearance(case, step))))
    if isinstance(case.bearing, RollerBearing):
        found += [Change(name, after(own)) for name, own in _of_rollers(case)]
    summary = life(solved, given, stress_volume=False)
    if summary.contamination_factor is not None:
        found += [
            Change("thicker_oil", _ratio(_life(solved, _with_thicker_oil(given)), before)),
            Change("cleaner_oil", _ratio(_life(solved, _with_cleaner_oil(summary, given)), before)),
        ]
    return tuple(sorted(found, key=lambda change: -np.nan_to_num(change.life_ratio, nan=-np.inf)))


def holding_load(solved: Solved) -> float | None:
    """Return an axial load (N) that holds together a bearing which carries it one way only.

    Parameters
    ----------
    solved
        A single case.

    Returns
    -------
    float
        To two figures, beside the radial load that is given; None where there is an equilibrium,
        no radial load, rows that face each other, or where no such load helps.
    """
    case = solved.case_at(0)
    load, places = case.duty.load, case.bearing.places
    radial = hypot(load.fy or 0.0, load.fz or 0.0)
    signs = {place.sign for place in places}
    one_way = len(signs) == 1 and all(place.bearing.carries_one_way for place in places)
    if (
        solved.status.number[0] != NO_EQUILIBRIUM
        or not one_way
        or case.bearing.bearing_type.washers
        or case.duty.displacement.x is not None
    ):
        return None
    least = signs.pop() * radial * tan(max(place.bearing.row_angle for place in places))
    for factor in _HOLDING if least else ():
        force = float(f"{factor * least:.2g}")
        held = case.replace(duty=case.duty.replace(load=load.replace(fx=force)))
        if solve(held).converged[0]:
            return force
    return None


def _life(solved: Solved, given: LifeConditions) -> float:
    """The life that leads; NaN where it does not hold or is a bound."""
    leading = life(solved, given, stress_volume=False).headline
    return float(leading.life[0]) if leading.valid[0] else float("nan")


def _ratio(after: float, before: float) -> float:
    usable = np.isfinite(before) and np.isfinite(after) and before > 0.0
    return after / before if usable else float("nan")


def _with_less_load(case: Case) -> Case | None:
    names = ("fx", "fy", "fz", "my", "mz")
    load = case.duty.load
    changes: dict[str, Any] = {
        name: _LOAD * getattr(load, name) for name in names if getattr(load, name)
    }
    if not changes:
        return None
    return case.replace(duty=case.duty.replace(load=load.replace(**changes)))


def _of_rollers(case: Case) -> Iterator[tuple[str, Case]]:
    """Changes that help rollers on a tilted ring, where there is something to change."""
    tilt = case.duty.displacement
    changed = {name: _TILT * value for name in ("ry", "rz") if (value := getattr(tilt, name))}
    if changed:
        duty = case.duty.replace(displacement=tilt.replace(**changed))
        yield "less_tilt", case.replace(duty=duty)
    bearing = case.bearing
    assert isinstance(bearing, RollerBearing)
    names = ("roller_profile", "inner_profile", "outer_profile")
    if all(getattr(bearing, name).kind == "none" for name in names):
        profiled = bearing.replace(roller_profile=Profile(kind="iso"))
        yield "profiled_rollers", case.replace(bearing=profiled)


def _with_clearance(case: Case, step: float) -> Case | None:
    clearance = case.bearing.diametral_clearance
    assert clearance is not None
    try:
        bearing = case.bearing.replace(diametral_clearance=clearance + step)
    except InputError:  # no such bearing: the balls would be crushed, or nothing hold them
        return None
    return case.replace(bearing=bearing)


def _with_thicker_oil(given: LifeConditions) -> LifeConditions:
    if given.viscosity_ratio is not None:
        return replace(given, viscosity_ratio=_VISCOSITY * np.asarray(given.viscosity_ratio))
    assert given.viscosity is not None
    return replace(given, viscosity=_VISCOSITY * np.asarray(given.viscosity))


def _with_cleaner_oil(summary: LifeSummary, given: LifeConditions) -> LifeConditions:
    """With e_C raised; a class becomes its factor first."""
    assert summary.contamination_factor is not None
    return replace(
        given, contamination=np.minimum(summary.contamination_factor + _CLEANLINESS, 1.0)
    )
