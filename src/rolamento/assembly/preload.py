"""How the rows of a set press on each other, and the external load that takes it away.

Rings that are clamped press each row in by a fixed offset: the force between them grows with
speed and changes with load, and an axial load of some three times the preload lifts a row of a
pair off its balls. (Where the contact angle does not change, 2^(3/2) times.) Springs keep their
force.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import isfinite, nan
from typing import Final, TypeAlias

import numpy as np

from rolamento.assembly.cases import spread
from rolamento.assembly.solve import solve_cases
from rolamento.case import Case
from rolamento.case.duty import AXES, LOADS, Duty, Load
from rolamento.numerics import FloatArray
from rolamento.rows.ball.row import compiled_but_not_loaded
from rolamento.solved import Preloading, Solved

STEPS_OUT: Final = 6
STEPS_IN: Final = 40
PRECISION: Final = 1e-6

Ball: TypeAlias = Callable[[list[float]], float]


def preload_of(case: Case) -> Preloading | None:
    """Find the preload of a set at rest and at speed, and its preload-loss point.

    None for a bearing without rows that face each other, or not preloaded.
    """
    preload = case.bearing.preload
    if preload is None:
        return None
    duty = Duty(first_ball_azimuth=case.duty.first_ball_azimuth)
    running = duty.replace(inner_speed=case.duty.inner_speed, outer_speed=case.duty.outer_speed)
    still = not (case.duty.inner_speed or case.duty.outer_speed)
    at_rest = float(between_rows(_solved(case.replace(duty=duty)))[0])
    at_speed = at_rest if still else float(between_rows(_solved(case.replace(duty=running)))[0])
    first = _loss(case, min)
    whole = first if _axial(case.duty) else _loss(case, max)
    return Preloading(preload.kind, at_rest, at_speed, *first, *whole)


def _axial(duty: Duty) -> bool:
    """Whether all balls of a row are alike: they then lift off together."""
    across = [getattr(duty.load, name) for name in LOADS[1:]]
    across += [getattr(duty.displacement, name) for name in AXES[1:]]
    return not any(across)


def _solved(case: Case) -> Solved:
    return solve_cases(spread(case, threads=1))


def between_rows(solved: Solved) -> FloatArray:
    """Axial force that the rows put on each other: what those that carry toward +x carry; N.

    (cases,), of cases without external load; NaN without a result.
    """
    axial = solved.rows.load[:, :, 0]
    found = np.where(axial > 0.0, axial, 0.0).sum(axis=1)
    return np.where(solved.converged, found, np.nan)


def _loss(case: Case, ball: Ball) -> tuple[float, int | None]:
    """The multiple of the external load at which a ball of a row first loses contact, and which.

    ball: max for the deepest ball of a row, with which the row loses all contact; min for the
    shallowest, with which it begins.
    """
    if not any(getattr(case.duty.load, name) for name in LOADS):
        return nan, None
    _load_kernels(case)
    low, high = _grip(case, ball, 0.0), _grip(case, ball, 1.0)
    if not low.least > 0.0:
        return nan, None
    for _ in range(STEPS_OUT):
        if not isfinite(high.least):  # no equilibrium: come half way back
            high = _grip(case, ball, 0.5 * (low.factor + high.factor))
        elif high.least > 0.0:
            ahead = min(1.02 * _zero(low, high), 8.0 * high.factor)
            low, high = high, _grip(case, ball, ahead)
        else:
            return _between(case, ball, low, high)
    return nan, None


def _load_kernels(case: Case) -> None:
    """Have the compiled kernels loaded if they are on disk: the search solves hundreds of rows.

    At rest plain Python is as fast as loading them. A single case takes them only where they are
    loaded already, two cases always.
    """
    moving = case.duty.inner_speed != 0.0 or case.duty.outer_speed != 0.0
    if moving and compiled_but_not_loaded():
        solve_cases(spread(case, {"inner_speed": [case.duty.inner_speed] * 2}, threads=1))


@dataclass(frozen=True, slots=True)
class _Grip:
    """How far a ball of every row is pressed into the inner ring; a gap is negative."""

    factor: float
    rows: tuple[float, ...]

    @property
    def least(self) -> float:
        """Of the row that is nearest to losing contact; m."""
        return min(self.rows)


def _grip(case: Case, ball: Ball, factor: float) -> _Grip:
    """The rows' grips under a multiple of the external load; NaN without an equilibrium."""
    given = {name: getattr(case.duty.load, name) for name in LOADS}
    load = Load(**{name: factor * value for name, value in given.items() if value is not None})
    solved = _solved(case.replace(duty=case.duty.replace(load=load)))
    approach = np.split(solved.inner.approach[0], solved.rows.starts[1:])
    return _Grip(factor, tuple(ball(row.tolist()) for row in approach))


def _between(case: Case, ball: Ball, low: _Grip, high: _Grip) -> tuple[float, int | None]:
    """Close in on the zero between two factors: false position, the Illinois way."""
    below, above = low.least, high.least
    for _ in range(STEPS_IN):
        if high.factor - low.factor <= PRECISION * high.factor:
            break
        guess = (low.factor * above - high.factor * below) / (above - below)
        found = _grip(case, ball, guess)
        if not isfinite(found.least):
            return nan, None
        if found.least > 0.0:
            low, below, above = found, found.least, 0.5 * above
        else:
            high, above, below = found, found.least, 0.5 * below
        if abs(found.least) <= PRECISION * max(map(abs, found.rows)):
            low = high = found
    return 0.5 * (low.factor + high.factor), int(np.argmin(high.rows))


def _zero(low: _Grip, high: _Grip) -> float:
    """Where the line through the grips comes to zero; infinite if it does not fall."""
    fall = low.least - high.least
    ahead = high.least * (high.factor - low.factor)
    return high.factor + ahead / fall if fall > 0.0 else np.inf
