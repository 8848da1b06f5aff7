"""How the rows of a set press on each other, and the external load that takes it away.

Rings that are clamped press each row in by a fixed offset: the force between them grows with
speed and changes with load, and an axial load of some three times the preload lifts a row of a
pair off its balls. Where the contact angle does not change, a row whose force grows with its
approach as δ^n is lifted by 2^n times the preload: 2^(3/2) = 2.83 of balls, 2^(10/9) = 2.16 of
straight rollers, up to 3 of crowned ones, whose line of contact grows with the load. Springs keep
their force.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite
from typing import Any, Final

import numpy as np

from rolamento.assembly.cases import spread
from rolamento.assembly.mounted import between_rows, mounted_cases
from rolamento.assembly.solve import solve_cases
from rolamento.case import Case
from rolamento.case.duty import AXES, LOADS, Duty
from rolamento.case.varied import varied_arrays
from rolamento.clearance.batch import MOUNTED_FIELDS
from rolamento.numerics import BoolArray, FloatArray, IntArray
from rolamento.rows.ball import row as balls
from rolamento.rows.roller import row as rollers
from rolamento.solved import Preloading, Solved

__all__ = ["Lost", "first_lift_off", "preload_at", "preload_loss", "preload_of"]

STEPS_OUT: Final = 24
SECANTS: Final = 6
"""Of the steps outward; where the grip flattens out as the load grows, they never arrive."""
STRIDE: Final = 1.5
STEPS_IN: Final = 40
PRECISION: Final = 1e-6

_SPEEDS: Final = ("duty.inner_speed", "duty.outer_speed")
_NONE: Final = -1


@dataclass(frozen=True, slots=True, eq=False)
class Lost:
    """Where contact is lost, case by case.

    factor: multiple of the external load, (cases,); NaN where there is no such load, or no contact
    is lost before the set has no equilibrium. row: which row loses it, (cases,); -1 where none
    does.
    """

    factor: FloatArray
    row: IntArray


def preload_of(case: Case, *, loss: bool = True) -> Preloading | None:
    """Find the preload of a set at rest and at speed, and where it is lost, unless not asked for.

    None for a bearing without rows that face each other, or not preloaded.
    """
    preload = case.bearing.preload
    if preload is None:
        return None
    given = _Given(case, {}, 1)
    at_rest = float(_at(given, running=False)[0])
    at_speed = float(_at(given, running=True)[0]) if given.moving else at_rest
    if not loss and given.loaded.any():
        return Preloading(preload.kind, at_rest, at_speed)
    given.load_kernels()
    first = _lost(given, np.minimum)
    whole = first if given.axial[0] else _lost(given, np.maximum)
    return Preloading(preload.kind, at_rest, at_speed, *_of_one(first), *_of_one(whole))


def preload_at(solved: Solved, *, running: bool) -> FloatArray:
    """Return the axial force between the rows that face each other, without external load.

    Parameters
    ----------
    solved
        Cases of a set; each is solved once more.
    running
        At the duty's speeds, else at rest.

    Returns
    -------
    (cases,), N; NaN without an equilibrium.
    """
    return _at(_given_by(solved), running=running)


def first_lift_off(solved: Solved) -> Lost:
    """Find the multiple of the external load at which a rolling element first loses contact.

    Parameters
    ----------
    solved
        Cases of a set. Some 15 to 25 more solutions of each are needed: all cases take a step of
        the search together.
    """
    return _lost(_given_by(solved), np.minimum)


def preload_loss(solved: Solved) -> Lost:
    """Find the preload-loss point: where a row loses all contact with the inner ring.

    As `first_lift_off`, which it is where the load is purely axial: all balls of a row are alike.
    """
    given = _given_by(solved)
    found = _lost(given, np.maximum, ~given.axial)
    axial = _lost(given, np.minimum, given.axial)
    return Lost(
        np.where(given.axial, axial.factor, found.factor),
        np.where(given.axial, axial.row, found.row),
    )


class _Given:
    """Cases whose preload is asked for: the case, what varies from it, and the external loads."""

    def __init__(self, case: Case, values: Mapping[str, FloatArray], cases: int) -> None:
        self.case, self.cases = case, cases
        self.values = {name: np.broadcast_to(array, cases) for name, array in values.items()}
        self.loads = dict(self._loads())

    def _loads(self) -> Any:
        """The loads that are given, by name: (cases,), N and N·m."""
        for axis, name in zip(AXES, LOADS, strict=True):
            own = getattr(self.case.duty.load, name)
            if (varied := self.values.get(f"duty.load.{name}")) is not None:
                yield name, varied
            elif own is not None and f"duty.displacement.{axis}" not in self.values:
                yield name, np.full(self.cases, own)

    @property
    def loaded(self) -> BoolArray:
        """Whether a case has an external load; (cases,)."""
        there = np.zeros(self.cases, np.bool_)
        for load in self.loads.values():
            there |= load != 0.0
        return there

    @property
    def axial(self) -> BoolArray:
        """Whether all balls of a row are alike: they then lift off together; (cases,)."""
        across = np.zeros(self.cases, np.bool_)
        for name in LOADS[1:]:
            across |= self.loads.get(name, np.zeros(1)) != 0.0
        for axis in AXES[1:]:
            own = getattr(self.case.duty.displacement, axis) or 0.0
            held = self.values.get(f"duty.displacement.{axis}", np.full(1, own))
            across |= held != 0.0
        return ~across

    @property
    def moving(self) -> bool:
        """Whether a ring turns in any case."""
        duty = self.case.duty
        own = bool(duty.inner_speed or duty.outer_speed)
        return own or any(np.any(self.values.get(name, np.zeros(1)) != 0.0) for name in _SPEEDS)

    def load_kernels(self) -> None:
        """Have the compiled kernels loaded if they are on disk: hundreds of rows are solved.

        Of balls at rest plain Python is as fast as loading them. A single case takes them only
        where they are loaded already, two cases always.
        """
        elements = {place.bearing.element for place in self.case.bearing.places}
        waiting = self.moving and "ball" in elements and balls.compiled_but_not_loaded()
        waiting = waiting or (elements != {"ball"} and rollers.compiled_but_not_loaded())
        if waiting and any(self.loads.values()):
            twice = {"inner_speed": [self.case.duty.inner_speed] * 2}
            _solved(self.case, varied_arrays(twice))

    def grips(self, factor: FloatArray, some: IntArray, shallowest: np.ufunc) -> FloatArray:
        """How far the rows' elements are pressed into the inner ring; a gap is negative.

        Parameters
        ----------
        factor
            Multiple of the external load; (some,).
        some
            Which cases.
        shallowest
            `np.minimum` for the shallowest element of each row, `np.maximum` for the deepest.

        Returns
        -------
        (some, rows), m; NaN without an equilibrium.
        """
        values = {name: array[some] for name, array in self.values.items()}
        for name, load in self.loads.items():
            values[f"duty.load.{name}"] = factor * load[some]
        solved = _solved(self.case, values)
        grip = solved.inner.approach
        if solved.rollers is not None:  # a tilted roller may hold on by its end alone
            deepest = solved.inner.deflection
            of_rollers = np.where(deepest > 0.0, deepest, -np.abs(grip))
            grip = np.where(np.isnan(solved.rollers.tilt), grip, of_rollers)
        return np.asarray(shallowest.reduceat(grip, solved.rows.starts, axis=1), np.float64)


def _given_by(solved: Solved) -> _Given:
    values = dict(solved.varied)
    if solved.case.mounting is None:
        values = {name: array for name, array in values.items() if name not in MOUNTED_FIELDS}
    return _Given(solved.case, values, len(solved))


def _solved(case: Case, values: Mapping[str, FloatArray]) -> Solved:
    """Solve cases; those of a mounted set with the geometry that each of them runs with."""
    if case.mounting is not None:
        return solve_cases(mounted_cases(case, values, threads=1))
    return solve_cases(spread(case, values, threads=1))


def _at(given: _Given, *, running: bool) -> FloatArray:
    """The force between the rows without external load; (cases,), N."""
    duty = Duty(first_ball_azimuth=given.case.duty.first_ball_azimuth)
    outside = ("duty.load.", "duty.displacement.", *(() if running else _SPEEDS))
    values = {name: array for name, array in given.values.items() if not name.startswith(outside)}
    if running:
        own = given.case.duty
        duty = duty.replace(inner_speed=own.inner_speed, outer_speed=own.outer_speed)
    if not values and given.cases > 1:  # the length has to come from somewhere
        values = {"duty.inner_speed": np.full(given.cases, duty.inner_speed)}
    return between_rows(_solved(given.case.replace(duty=duty), values))


def _of_one(found: Lost) -> tuple[float, int | None]:
    factor, row = float(found.factor[0]), int(found.row[0])
    return factor, row if isfinite(factor) else None


def _lost(given: _Given, shallowest: np.ufunc, where: BoolArray | None = None) -> Lost:
    """The multiple of the external load at which a ball of a row first loses contact, and which.

    shallowest: `np.maximum` for the deepest ball of a row, with which the row loses all contact;
    `np.minimum` for the shallowest, with which it begins. where: which cases; all if not given.

    All cases take each step together: outward from the load itself until it is enclosed, then
    false position, the Illinois way.
    """
    found = Lost(np.full(given.cases, np.nan), np.full(given.cases, _NONE))
    search = _Search(given, shallowest, given.loaded if where is None else given.loaded & where)
    search.enclose()
    search.close_in()
    factor = np.where(search.enclosed, 0.5 * (search.low + search.high), np.nan)
    row = np.where(search.enclosed, np.argmin(search.above, axis=1), _NONE)
    found.factor[search.cases], found.row[search.cases] = factor, row
    return found


class _Search:
    """Two multiples of the load for each case, and the rows' grips at both.

    low, high: (cases,); below, above: the grips at them, (cases, rows); least_below, least_above:
    of the row that is nearest to losing contact, as false position weights them.
    """

    def __init__(self, given: _Given, shallowest: np.ufunc, wanted: BoolArray) -> None:
        self._given, self._shallowest = given, shallowest
        cases = np.flatnonzero(wanted)
        self.cases = cases
        self.low, self.below = np.zeros(len(cases)), self._grips(np.zeros(len(cases)), cases)
        gripped = self.below.min(axis=1) > 0.0
        self.cases = cases[gripped]
        self.low, self.below = self.low[gripped], self.below[gripped]
        self.high = np.ones(len(self.cases))
        self.above = self._grips(self.high, self.cases)
        self.enclosed = np.zeros(len(self.cases), np.bool_)

    def _grips(self, factor: FloatArray, cases: IntArray) -> FloatArray:
        if not len(cases):
            return np.zeros((0, 1))
        return self._given.grips(factor, cases, self._shallowest)

    def enclose(self) -> None:
        """Go outward until contact is lost; half way back where there is no equilibrium."""
        for step in range(STEPS_OUT + 1):
            least = self.above.min(axis=1)
            self.enclosed |= least <= 0.0
            open_ = np.flatnonzero(~self.enclosed & (self.high - self.low > PRECISION * self.high))
            if step == STEPS_OUT:
                return
            if not len(open_):
                return
            nowhere = ~np.isfinite(least[open_])
            low, high = self.low[open_], self.high[open_]
            secant = np.fmin(1.02 * self._zero(open_), 8.0 * high)
            ahead = secant if step < SECANTS else STRIDE * high
            further = np.where(nowhere, 0.5 * (low + high), ahead)
            onward = open_[~nowhere]
            self.low[onward], self.below[onward] = self.high[onward], self.above[onward]
            self.high[open_] = further
            self.above[open_] = self._grips(further, self.cases[open_])

    def _zero(self, some: IntArray) -> FloatArray:
        """Where the line through the grips comes to zero; infinite if it does not fall."""
        least, greatest = self.above[some].min(axis=1), self.below[some].min(axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            fall = greatest - least
            ahead = least * (self.high[some] - self.low[some]) / fall
            return np.where(fall > 0.0, self.high[some] + ahead, np.inf)

    def close_in(self) -> None:
        """Bring the two together; where there is no equilibrium between them, nothing is found."""
        near, far = self.below.min(axis=1), self.above.min(axis=1)
        for _ in range(STEPS_IN):
            wide = self.high - self.low > PRECISION * self.high
            some = np.flatnonzero(self.enclosed & wide)
            if not len(some):
                return
            guess = (self.low[some] * far[some] - self.high[some] * near[some]) / (
                far[some] - near[some]
            )
            grips = self._grips(guess, self.cases[some])
            least = grips.min(axis=1)
            self.enclosed[some[~np.isfinite(least)]] = False
            holds, lost = least > 0.0, least <= 0.0
            exact = np.abs(least) <= PRECISION * np.abs(grips).max(axis=1)
            for side, other, value, rest, taken in (
                (self.low, self.below, near, far, holds), (self.high, self.above, far, near, lost),
            ):  # fmt: skip
                side[some[taken]], other[some[taken]] = guess[taken], grips[taken]
                value[some[taken]] = least[taken]
                rest[some[taken]] *= 0.5
            for side, other in ((self.low, self.below), (self.high, self.above)):
                side[some[exact]], other[some[exact]] = guess[exact], grips[exact]
