"""One ball in balance with friction along rolling alone, between lines of pure rolling; compiled.

The sums between the lines are those of `harris_1971.line_friction`, here of one contact, with the
derivatives that Newton's method needs.
"""

from __future__ import annotations

from math import asin, inf, nan, sqrt
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from rolamento.friction.free_ball import (
    COSINE,
    HALF,
    LIFT,
    LOAD,
    PITCH,
    RADIUS,
    SEMI_MAJOR,
    SINE,
)
from rolamento.numerics import FloatArray
from rolamento.numerics.compiled import filling, inline_exact, kernel
from rolamento.numerics.dense import solve_dense

TOLERANCE: Final = 1e-8
"""Residual of the balance of forces, over friction itself: what stands of a closed form in
doubles."""
STEPS: Final = 60
MINIMUM_DAMPING: Final = 1e-14
MAXIMUM_DAMPING: Final = 1e6
REACH: Final = 1e6
"""Multiple of the ring's speed: no ball turns faster."""

Two: TypeAlias = tuple[float, float]
Three: TypeAlias = tuple[float, float, float]
Surface: TypeAlias = tuple[float, float, float, float]
"""a, R, the lift of its arc, and σ."""


@inline_exact
def _arc(surface: Surface, s: float) -> float:
    """The distance r = σρ at s = x0/a."""
    a, radius, lift, side = surface
    return side * (sqrt(radius * radius - a * a * s * s) + lift)


@inline_exact
def _rolling_lines(surface: Surface, motion: Three) -> Two:
    """x0/a of the lines without slip along rolling, in rising order; NaN for one that is not there.

    motion: drift, roll, twist. As of `slip.rolling_lines`.
    """
    a, radius, lift, side = surface
    drift, roll, twist = motion
    slope = side * roll
    level = drift + slope * lift
    total = slope * slope + twist * twist
    under = radius * radius * total - level * level
    if not (under >= 0.0 and total > 0.0):
        return nan, nan
    root = abs(slope) * sqrt(under)
    low, high = (twist * level - root) / (total * a), (twist * level + root) / (total * a)
    has_low = abs(low) <= 1.0 and (twist * low * a - level) * slope >= 0.0
    has_high = abs(high) <= 1.0 and (twist * high * a - level) * slope >= 0.0
    if has_low:
        return low, high if has_high else nan
    return high if has_high else nan, nan


@inline_exact
def _primitives(surface: Surface, s: float) -> Three:
    """Primitives by s of q, ρ q and x0 q over the load, q the pressure summed along."""
    a, radius, lift, _ = surface
    plain = 0.75 * (s - s * s * s / 3.0)
    ratio = a / radius
    t = ratio * s
    root, angle = sqrt(1.0 - t * t), asin(t)
    first = 0.5 * (s * root + angle / ratio)
    second = (0.125 * (2.0 * t * t - 1.0) * t * root + 0.125 * angle) / (ratio * ratio * ratio)
    moment = 0.75 * a * (0.5 * s * s - 0.25 * s * s * s * s)
    return plain, 0.75 * radius * (first - second) + lift * plain, moment


@inline_exact
def _line_sums(surface: Surface, motion: Three, lines: Two) -> Three:
    """∫ f, ∫ ρ f and ∫ x0 f of the friction along rolling, over μ Q."""
    drift, roll, twist = motion
    force, rolled, twisted = 0.0, 0.0, 0.0
    begin = -1.0
    left = _primitives(surface, begin)
    for part in range(3):
        end = 1.0 if part == 2 else lines[part]
        end = end if end == end else 1.0
        if end > begin:
            right = _primitives(surface, end)
            middle = 0.5 * (begin + end)
            slip = drift + _arc(surface, middle) * roll - surface[0] * middle * twist
            sign = 1.0 if slip > 0.0 else -1.0 if slip < 0.0 else 0.0
            force += sign * (right[0] - left[0])
            rolled += sign * (right[1] - left[1])
            twisted += sign * (right[2] - left[2])
            begin, left = end, right
    return force, rolled, twisted


@filling
def _imbalance(
    contacts: FloatArray, ball: int, motion: FloatArray, error: FloatArray, curved: FloatArray
) -> float:
    """Gradient of the power per μ by the motion, and its Hessian: the greatest over its own scale.

    motion (3,): ball_x, ball_z, orbit; fills error (3,) and curved (3, 3).
    """
    turning, drawing = 0.0, 0.0
    for i in range(3):
        error[i] = 0.0
        for j in range(3):
            curved[i, j] = 0.0
    for race in range(2):
        c, ring, side = contacts[race], 1.0 - race, 2.0 * race - 1.0
        cosine, sine, load, arm = c[COSINE, ball], c[SINE, ball], c[LOAD, ball], c[PITCH, ball]
        surface = (c[SEMI_MAJOR, ball], c[RADIUS, ball], c[LIFT, ball], side)
        seen = (
            arm * (motion[2] - ring),
            cosine * (motion[0] - ring) - sine * motion[1],
            sine * (motion[0] - ring) + cosine * motion[1],
        )
        lines = _rolling_lines(surface, seen)
        force, rolled, twisted = _line_sums(surface, seen, lines)
        error[0] += load * (side * rolled * cosine - twisted * sine)
        error[1] -= load * (side * rolled * sine + twisted * cosine)
        error[2] += load * force * arm
        turning += load * c[HALF, ball]
        drawing += load * arm
        for line in range(2):
            s = lines[line]
            if s == s:
                # the second derivative of the power is 2 q/|v'| at every line
                x0, r = surface[0] * s, _arc(surface, s)
                bend = sqrt(surface[1] * surface[1] - x0 * x0)
                slope = abs(side * seen[1] * x0 / bend + seen[2])
                if slope > 0.0:
                    weight = 1.5 * load * (1.0 - s * s) / (surface[0] * slope)
                    rate = (r * cosine - x0 * sine, -r * sine - x0 * cosine, arm)
                    for i in range(3):
                        for j in range(3):
                            curved[i, j] += weight * rate[i] * rate[j]
    worst: float = max(abs(error[0]) / turning, abs(error[1]) / turning, abs(error[2]) / drawing)
    return worst


@filling
def _damped_step(
    error: FloatArray, curved: FloatArray, damping: float, system: FloatArray, step: FloatArray
) -> bool:
    """Solve for the step against an error; False where that cannot be."""
    most = max(curved[0, 0], curved[1, 1], curved[2, 2])
    # where nothing resists a turn, a little does: the step stays finite
    least = 1e-12 * most if most > 0.0 else 1.0
    for i in range(3):
        own = sqrt(max(curved[i, i], least))
        step[i] = error[i] / own
        for j in range(3):
            other = sqrt(max(curved[j, j], least))
            system[i, j] = curved[i, j] / (own * other) + (damping if i == j else 0.0)
    if not solve_dense(system, step):
        return False
    for i in range(3):
        step[i] /= sqrt(max(curved[i, i], least))
    return True


@filling
def _balance(contacts: FloatArray, ball: int, motion: FloatArray, room: FloatArray) -> float:
    """Newton's method with damping, in place: what is out of balance over its own scale."""
    error, curved, system = room[0], room[1:4], room[4:7]
    step, trial, new_error, new_curved = room[7], room[8], room[9], room[10:13]
    size = _imbalance(contacts, ball, motion, error, curved)
    damping, better = 1e-6, True
    for _ in range(STEPS):
        # within the tolerance a step in vain is one of rounding
        if size <= (1e-3 * TOLERANCE if better else TOLERANCE) or damping > MAXIMUM_DAMPING:
            break
        near = _damped_step(error, curved, damping, system, step)
        for i in range(3):
            trial[i] = motion[i] - step[i]
            # a ball that hardly anything holds is sent away by its first steps: shorter ones do
            near = near and abs(trial[i]) <= REACH
        found = _imbalance(contacts, ball, trial, new_error, new_curved) if near else inf
        better = found < size
        if better:
            size = found
            for i in range(3):
                motion[i], error[i] = trial[i], new_error[i]
                for j in range(3):
                    curved[i, j] = new_curved[i, j]
            damping = max(0.01 * damping, MINIMUM_DAMPING)
        else:
            damping *= 30.0
    return size


@kernel
def balance_balls(
    first: int,
    beyond: int,
    contacts: FloatArray,
    motion: FloatArray,
    converged: NDArray[np.bool_],
) -> None:
    """Balance balls from a first one to that before another.

    contacts (2, NUMBERS, balls) as of `free_ball`; motion (balls, 3), from the start to the result.
    """
    room = np.empty((13, 3))
    for ball in range(first, beyond):
        wide = contacts[0, LIFT, ball] + contacts[1, LIFT, ball]  # NaN: wider than the ball
        converged[ball] = False
        if wide == wide:
            converged[ball] = _balance(contacts, ball, motion[ball], room) <= TOLERANCE
