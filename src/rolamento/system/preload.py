"""How the rows of a set press on each other, and the external load that takes it away.

Rings that are clamped press each row in by a fixed offset: the force between them grows with
speed and changes with load, and an axial load of some three times the preload lifts a row of a
pair off its balls. Where the contact angle does not change, a row whose force grows with its
approach as δ^n is lifted by 2^n times the preload: 2^(3/2) = 2.83 of balls, 2^(10/9) = 2.16 of
straight rollers, up to 3 of crowned ones, whose line of contact grows with the load. Springs keep
their force.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from math import isfinite
from typing import Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.duty import AXES, LOADS, Duty
from rolamento.case.varied import is_of_mounting
from rolamento.numerics import BoolArray, FloatArray, IntArray
from rolamento.records import frozen
from rolamento.solved import Preloading, Solved
from rolamento.system.cases import spread
from rolamento.system.solve import solve_cases

__all__ = ["Lost", "between_rows", "first_lift_off", "preload_at", "preload_loss", "preload_of"]

PRECISION: Final = 1e-6
"""Relative width of the two multiples of the load between which contact is lost."""
NO_CLOSER: Final = 1e-3
"""The same of those between which the set ceases to have an equilibrium: nothing is lost there."""
ROUNDS: Final = 40
ROUNDS_OUT: Final = 8
"""Largest number of the rounds outward; where the grip flattens out as the load grows, they never
arrive."""
STRIDE: Final = 4.0
"""Times the multiple so far: what a round outward tries where no line loses contact."""
FURTHEST: Final = 1e3
"""Times the multiple so far: the most that a round goes outward."""
_AHEAD: Final = (1.02, 1.1, 1.5)
"""Fractions of the way to where a straight line loses contact: of the first rounds outward."""
FAR_AHEAD: Final = 2.5
"""The same of later ones."""
MUCH_HEAVIER: Final = 10.0
"""Times the force without external load: what is left of the preload under it is little."""

_SPEEDS: Final = ("duty.inner_speed", "duty.outer_speed")
_NONE: Final = -1

Press = tuple[FloatArray, ...]
"""How far each row is pressed in; (cases,) each, m."""


@frozen(eq=False)
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
    at_rest, at_speed = _forces(case.without_load, frozenset(case.bearing.model_fields_set))
    given = _Given(case, {}, 1)
    if not loss and given.loaded.any():
        return Preloading(preload.kind, at_rest, at_speed)
    # all balls of a row are alike under an axial load: the first takes its row along
    searches = np.array([False]) if given.axial[0] else np.array([False, True])
    found = _lost(given, np.zeros(len(searches), np.int64), searches)
    lost = (*_of_one(found, 0), *_of_one(found, -1))
    return Preloading(preload.kind, at_rest, at_speed, *lost)


@lru_cache(maxsize=64)
def _forces(case: Case, own: frozenset[str]) -> tuple[float, float]:
    """Preload at rest and at speed of a case without a load; found once while the load changes.

    own: the bearing's own fields, which cases that are equal may differ in.
    """
    given = _Given(case, {}, 1)
    found = _without_load(given) if given.moving else _at(given, running=False).repeat(2)
    return float(found[0]), float(found[1])


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
        Cases of a set. Some 20 more solutions of each are needed: all cases take a round of the
        search together.
    """
    every = np.arange(len(solved))
    return _lost(_given_by(solved), every, np.zeros(len(solved), np.bool_))


def preload_loss(solved: Solved) -> Lost:
    """Find the preload-loss point: where a row loses all contact with the inner ring.

    As `first_lift_off`, which it is where the load is purely axial: all balls of a row are alike.
    """
    given = _given_by(solved)
    return _lost(given, np.arange(len(solved)), ~given.axial)


class _Given:
    """Cases whose preload is asked for: the case, what varies from it, and the external loads."""

    def __init__(self, case: Case, values: Mapping[str, FloatArray], cases: int) -> None:
        self.case, self.cases = case, cases
        self.values = {name: np.broadcast_to(array, cases) for name, array in values.items()}
        self.loads = dict(self._loads())

    @cached_property
    def press(self) -> Press | None:
        """Press-in of each row, whatever the load; None where it depends on the solution."""
        if self.case.mounting is not None or self.case.bearing.preload is None:
            return None
        from rolamento.system.ring import pressed_in

        return pressed_in(spread(self.case, self.values, threads=1))

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
        return self.case.duty.turns or any(
            np.any(self.values.get(name, np.zeros(1)) != 0.0) for name in _SPEEDS
        )

    def look(
        self, factor: FloatArray, some: IntArray, deepest: BoolArray, start: FloatArray
    ) -> _Look:
        """Look at some cases at multiples of their external load.

        Parameters
        ----------
        factor
            Multiple of the external load; (some,).
        some
            Which cases.
        deepest
            Whether the deepest element of each row counts, else the shallowest; (some,).
        start
            Where the ring probably rests; (some, 5), NaN where that is not known.
        """
        # what two searches look at is solved once
        pairs = np.stack([factor, some])
        _, once, each = np.unique(pairs, axis=1, return_index=True, return_inverse=True)
        of = some[once]
        values = {name: array[of] for name, array in self.values.items()}
        for name, load in self.loads.items():
            values[f"duty.load.{name}"] = factor[once] * load[of]
        press = None if self.press is None else tuple(own[of] for own in self.press)
        solved = _solved(self.case, values, press, start[once])
        starts = solved.rows.starts
        grip = np.where(solved.converged[:, np.newaxis], solved.answer.grip(), np.nan)[each]
        deep, shallow = np.maximum, np.minimum
        grips = np.where(
            deepest[:, np.newaxis],
            deep.reduceat(grip, starts, axis=1),
            shallow.reduceat(grip, starts, axis=1),
        )
        heaviest = np.linalg.norm(solved.rows.load[:, :, :3], axis=2).max(axis=1)
        return _Look(factor, grips, solved.displacement.array[each], heaviest[each])


@dataclass(slots=True)
class _Look:
    """Multiples of the external load, in an array of any shape, and the bearing under each.

    grips: how far the rows' elements are pressed into the inner ring, a gap is negative, NaN
    without an equilibrium; (…, rows), m. place: of the ring; (…, 5), SI. heaviest: the greatest
    force of a row; N.
    """

    factor: FloatArray
    grips: FloatArray
    place: FloatArray
    heaviest: FloatArray

    def shaped(self, *shape: int) -> _Look:
        """Return the same in another shape."""
        return self._each(lambda own, more: own.reshape(*shape, *more))

    def some(self, index: Any) -> _Look:
        """Return some of it."""
        return self._each(lambda own, _: own[index])

    def beside(self, other: _Look) -> _Look:
        """Return both, one after the other along the second axis."""
        pairs = ((getattr(self, name), getattr(other, name)) for name in self.__slots__)
        return _Look(*(np.concatenate(pair, axis=1) for pair in pairs))

    def put(self, some: IntArray, other: _Look) -> None:
        """Replace some."""
        for name in self.__slots__:
            getattr(self, name)[some] = getattr(other, name)

    def _each(self, change: Callable[[FloatArray, tuple[int, ...]], FloatArray]) -> _Look:
        ends = self.factor.ndim
        parts = (getattr(self, name) for name in self.__slots__)
        return _Look(*(change(part, part.shape[ends:]) for part in parts))


def _given_by(solved: Solved) -> _Given:
    values = dict(solved.varied)
    if solved.case.mounting is None:
        values = {name: array for name, array in values.items() if not is_of_mounting(name)}
    return _Given(solved.case, values, len(solved))


def _solved(
    case: Case,
    values: Mapping[str, FloatArray],
    press: Press | None,
    start: FloatArray | None = None,
) -> Solved:
    """Solve cases; those of a mounted set with the geometry that each of them runs with."""
    if case.mounting is not None:
        from rolamento.system.mounted import solve_mounted

        return solve_mounted(case, values, threads=1, start=start)
    cases = replace(spread(case, values, threads=1), start=start)
    if press is not None:
        pairs = zip(cases.rows, press, strict=True)
        rows = [replace(placed, press=np.broadcast_to(e, len(cases))) for placed, e in pairs]
        cases = replace(cases, rows=tuple(rows))
    return solve_cases(cases)


def between_rows(solved: Solved) -> FloatArray:
    """Axial force that the rows put on each other: what those that carry toward +x carry; N.

    (cases,), of cases without external load; NaN without a result.
    """
    axial = solved.rows.load[:, :, 0]
    force = np.where(axial > 0.0, axial, 0.0).sum(axis=1)
    return np.where(solved.converged, force, np.nan)


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
    return between_rows(_solved(given.case.replace(duty=duty), values, given.press))


def _without_load(given: _Given) -> FloatArray:
    """The force between the rows without external load, at rest and at the duty's speeds; N."""
    case = given.case
    still = case.replace(duty=Duty(first_ball_azimuth=case.duty.first_ball_azimuth))
    speeds = {"inner_speed": case.duty.inner_speed, "outer_speed": case.duty.outer_speed}
    turning = {f"duty.{name}": np.array([0.0, speed]) for name, speed in speeds.items()}
    return between_rows(_solved(still, turning, given.press))


def _of_one(found: Lost, search: int) -> tuple[float, int | None]:
    factor, row = float(found.factor[search]), int(found.row[search])
    return factor, row if isfinite(factor) else None


def _lost(given: _Given, cases: IntArray, deepest: BoolArray) -> Lost:
    """The multiples of the external load at which a row first loses contact; (searches,).

    cases: which case a search is of; deepest: whether it is for the deepest element of a row, with
    which the row loses all contact, or for the shallowest; (searches,) each.

    All searches take a round together, each with a multiple of its load: outward until contact is
    lost, then on either side of where straight lines lose it.
    """
    found = Lost(np.full(len(cases), np.nan), np.full(len(cases), _NONE))
    which = np.flatnonzero(given.loaded[cases])
    if not len(which):
        return found
    search = _Search(given, cases[which], deepest[which])
    search.run()
    lost = which[search.gripped][search.enclosed]
    found.factor[lost] = search.loss[search.enclosed]
    found.row[lost] = np.argmin(search.grips[:, 2], axis=1)[search.enclosed]
    return found


class _Search:
    """Two multiples of the load for each search, and one more on either side.

    seen: the four, rising; (searches, 4). At the second all rows hold. The third has no
    equilibrium, has lost contact, or holds while the search is going outward. What is not known yet
    repeats its neighbour. unloaded: the greatest force of a row without external load; (searches,).
    """

    def __init__(self, given: _Given, cases: IntArray, deepest: BoolArray) -> None:
        self._given = given
        factors = np.tile([0.0, 1.0], (len(cases), 1))
        seen = self._look(factors, cases, deepest, np.full((*factors.shape, 5), np.nan))
        self.gripped = seen.grips[:, 0].min(axis=1) > 0.0
        self._cases, self._deepest = cases[self.gripped], deepest[self.gripped]
        self.seen = seen.some((np.flatnonzero(self.gripped)[:, np.newaxis], [0, 0, 1, 1]))
        self.unloaded = self.seen.heaviest[:, 0].copy()

    @property
    def factors(self) -> FloatArray:
        """The multiples; (searches, 4)."""
        return self.seen.factor

    @property
    def grips(self) -> FloatArray:
        """The rows' grips at them; (searches, 4, rows)."""
        return self.seen.grips

    def _look(
        self, factors: FloatArray, cases: IntArray, deepest: BoolArray, start: FloatArray
    ) -> _Look:
        """At some multiples for each search; (searches, multiples)."""
        each = factors.shape[1]
        seen = self._given.look(
            factors.ravel(), cases.repeat(each), deepest.repeat(each), start.reshape(-1, 5)
        )
        return seen.shaped(*factors.shape)

    @property
    def enclosed(self) -> BoolArray:
        """Whether contact is lost between the two in the middle; (searches,)."""
        return np.asarray(self.grips[:, 2].min(axis=1) <= 0.0)

    def _held_by_the_load(self) -> BoolArray:
        """Whether the load alone presses all rows in, and ever more; (searches,).

        The preload is then little beside it: what is under the load only grows with it.
        """
        unbalanced = np.asarray(np.isnan(self.grips[:, 2]).any(axis=1))
        every, last = np.arange(len(unbalanced)), np.where(unbalanced, 1, 2)
        growing = (self.grips[every, last] > self.grips[every, last - 1]).all(axis=1)
        heavy = self.seen.heaviest[every, last - 1] > MUCH_HEAVIER * self.unloaded
        return np.asarray(growing & heavy)

    def zero(self, one: int, other: int, power: float = 1.0) -> FloatArray:
        """Where the line through the least grips at two of the four falls to zero; else infinite.

        power: of the grips on that line.
        """
        near, far = (self.grips[:, i].min(axis=1) for i in (one, other))
        with np.errstate(divide="ignore", invalid="ignore"):
            near, far = near**power, far**power
            way = (self.factors[:, other] - self.factors[:, one]) / (near - far)
            return np.where(way > 0.0, self.factors[:, one] + near * way, np.inf)

    @property
    def loss(self) -> FloatArray:
        """Where contact is lost: where the gap beyond, a straight line, closes; (searches,)."""
        _, low, high, _ = self.factors.T
        gap = self.zero(2, 3)
        return np.where((low <= gap) & (gap <= high), gap, self.zero(1, 2))

    def run(self) -> None:
        """Enclose the loss of contact, and bring the two together: a multiple a round."""
        width = before = np.full(len(self.factors), np.inf)
        for step in range(ROUNDS):
            _, low, high, _ = self.factors.T
            least = self.grips[:, 2].min(axis=1)
            out, lost = least > 0.0, least <= 0.0
            close = np.where(lost, PRECISION, NO_CLOSER)
            going = (high - low > close * high) & (~out | (step < ROUNDS_OUT))
            some = np.flatnonzero(going & (lost | ~self._held_by_the_load()))
            if not len(some):
                return
            slow = high - low > 0.5 * before  # than halving would be
            probes = np.where(lost & ~slow, self._around(), self._half_way())
            probes = np.where(out, self._outward(step), probes)
            self._take(some, probes[some, np.newaxis], self._between(probes)[some])
            width, before = np.where(lost, high - low, np.inf), width

    def _outward(self, step: int) -> FloatArray:
        """A multiple of the load beyond the third: little beyond where a line loses contact."""
        high, zero = self.factors[:, 2], self.zero(1, 2)
        part = _AHEAD[step] if step < len(_AHEAD) else FAR_AHEAD
        ahead = high + (np.minimum(zero, FURTHEST * high) - high) * part
        return np.asarray(np.where(np.isfinite(zero), ahead, high * STRIDE))

    def _half_way(self) -> FloatArray:
        """Between the two, by ratio where they are far apart."""
        low, high = self.factors[:, 1], self.factors[:, 2]
        floor = np.maximum(low, high / FURTHEST)
        return np.where(high > 4.0 * floor, np.sqrt(floor * high), 0.5 * (low + high))

    def _around(self) -> FloatArray:
        """Where lines come to zero, and half as far beyond as they differ, toward the farther end.

        The grip is a straight line close to the loss, or its power 3/2, as a row's load has it.
        """
        _, low, high, _ = self.factors.T
        zeros = np.clip([self.zero(0, 1), self.zero(0, 1, 1.5), self.loss], low, high)
        least, middle, most = np.sort(zeros, axis=0)
        apart = np.minimum(middle - least, most - middle)
        aside = np.maximum(0.5 * apart, 0.2 * PRECISION * high)
        farther = np.where(high - middle > middle - low, 1.0, -1.0)
        within = (low < middle) & (middle < high)
        return np.where(within, np.clip(middle + farther * aside, low, high), self._half_way())

    def _between(self, probes: FloatArray) -> FloatArray:
        """Where the ring rests at a multiple if it moves in proportion; (searches, 1, 5)."""
        unbalanced = np.isnan(self.seen.place[:, 2]).any(axis=1)
        every, last = np.arange(len(probes)), np.where(unbalanced, 1, 2)
        near, far = self.seen.some((every, last - 1)), self.seen.some((every, last))
        with np.errstate(divide="ignore", invalid="ignore"):
            part = (probes - near.factor) / (far.factor - near.factor)
            place = near.place + part[:, np.newaxis] * (far.place - near.place)
            return np.asarray(place[:, np.newaxis])

    def _take(self, some: IntArray, probes: FloatArray, start: FloatArray) -> None:
        """Look at multiples of the load, (some, multiples), and keep the four around the loss."""
        found = self._look(probes, self._cases[some], self._deepest[some], start)
        seen = self.seen.some(some).beside(found)
        rows = np.arange(len(some))[:, np.newaxis]
        seen = seen.some((rows, np.argsort(seen.factor, axis=1, kind="stable")))
        again = np.diff(seen.factor, axis=1, prepend=-1.0) == 0.0  # goes behind the others
        seen = seen.some((rows, np.argsort(again, axis=1, kind="stable")))
        last = np.count_nonzero(~again, axis=1)[:, np.newaxis] - 1
        gone = ~(seen.grips.min(axis=2) > 0.0)
        first = np.where(gone.any(axis=1, keepdims=True), gone.argmax(axis=1)[:, np.newaxis], last)
        kept = np.clip(first + np.arange(-2, 2), 0, last)
        self.seen.put(some, seen.some((rows, kept)))
