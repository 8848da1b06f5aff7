"""One ball between grooves that stand still: the safe way to its place.

Newton's method first. Where it fails or strays, the ball's place is bracketed: its distance from
the outer groove's centre at a given outer angle (the force along the outer normal falls with the
distance), and the outer angle itself: between the radial direction and the line of the groove
centres, alpha_o <= alpha <= alpha_i, or beyond that line where rings that turn against each other
reverse the gyroscopic moment.
"""

from __future__ import annotations

from math import acos, atan2, cos, pi, sin, sqrt
from typing import Final

from rolamento.numerics.compiled import filling, inline_exact
from rolamento.rows.ball import layout
from rolamento.rows.ball.ball import stored_polynomial
from rolamento.rows.ball.single import (
    OFF_GROOVE,
    balance_along,
    inner_length,
    linearised,
    rounding,
)
from rolamento.rows.ball.types import Array, Found, Settled, Two

NEAR: Final = 1e-7
"""Residual of a ball over its loads that one more step settles."""
PLACE_SLACK: Final = 1e-6
"""rad: a ball that hardly anything holds does not stand more exactly than this."""
NEWTON_STEPS: Final = 20
SHORTENINGS: Final = 4
LONGEST: Final = 0.2
"""Longest step of a ball, over L_o."""
SHORTENED: Final = 0.3
"""To which part a step that does not help is shortened."""
BRACKET_STEPS: Final = 80
IN_LINE: Final = 1e-3
"""sin(a_i - a_o) of a ball that the grooves press harder than its centrifugal force."""


@filling
def in_place(p: Array, case: int, a1: float, x1: float, x2: float) -> bool:
    """Whether a ball stands where it can: pushed to the same side by both rings, and outward."""
    slack = PLACE_SLACK * p[layout.OUTER_LENGTH, case]
    side = 1.0 if a1 >= 0.0 else -1.0
    return side * x1 >= -slack and x2 > 0.0 and side * (a1 - x1) >= -slack


@filling
def free_ball(p: Array, case: int, cage: float, control: float, a1: float, a2: float) -> Found:
    """A ball that only its centrifugal force presses outward: (whether it is free, X1, X2)."""
    length: float = p[layout.OUTER_LENGTH, case]
    x2 = length
    stiffness, _ = stored_polynomial(1.0, (p, layout.OUTER_STIFFNESS, case))
    for _ in range(50):
        f_c = balance_along(p, case, cage, control, a1, a2, 0.0, x2)[2]
        before = x2
        x2 = length + (f_c / stiffness) ** (2.0 / 3.0)
        if abs(x2 - before) <= 1e-16 * x2:
            break
    gap = sqrt(a1 * a1 + max(a2 - x2, 0.0) ** 2)
    return abs(control) >= OFF_GROOVE or gap <= p[layout.INNER_LENGTH, case], 0.0, x2


@filling
def _newton(
    p: Array,
    case: int,
    cage: float,
    control: float,
    a1: float,
    a2: float,
    x1: float,
    x2: float,
    near: float,
    work: Array,
) -> Settled:
    """Newton's method with shortened steps; returns what `settle` does."""
    longest = LONGEST * p[layout.OUTER_LENGTH, case]
    ball = linearised(p, case, cage, control, a1, a2, x1, x2)
    work[0] -= 1.0
    error = sqrt(ball[0][0] ** 2 + ball[0][1] ** 2)
    for _ in range(NEWTON_STEPS):
        step1, step2, scale = ball[1][0], ball[1][1], ball[4]
        if error <= near * scale + rounding(p, case, scale):
            y1, y2 = x1 + step1, x2 + step2
            if in_place(p, case, a1, y1, y2):
                return True, y1, y2, ball
            if error <= NEAR * scale + rounding(p, case, scale):
                return False, y1, y2, ball
        length = sqrt(step1 * step1 + step2 * step2)
        part = min(1.0, longest / length) if length > 0.0 else 1.0
        for _ in range(SHORTENINGS):
            y1 = x1 + part * step1
            y2 = x2 + part * step2
            ahead = linearised(p, case, cage, control, a1, a2, y1, y2)
            work[0] -= 1.0
            trial = sqrt(ahead[0][0] ** 2 + ahead[0][1] ** 2)
            if trial < error:
                break
            part *= SHORTENED
        if not trial < error:
            return False, x1, x2, ball
        x1, x2, ball, error = y1, y2, ahead, trial
    return False, x1, x2, ball


@inline_exact
def _along_and_across(
    p: Array,
    case: int,
    cage: float,
    control: float,
    a1: float,
    a2: float,
    alpha: float,
    reach: float,
) -> Two:
    """The ball's residual along the outer normal and across it."""
    along, across, _ = balance_along(
        p, case, cage, control, a1, a2, reach * sin(alpha), reach * cos(alpha)
    )
    return along, across


@filling
def _reach_at(
    p: Array,
    case: int,
    cage: float,
    control: float,
    a1: float,
    a2: float,
    alpha: float,
    work: Array,
) -> float:
    """The distance from the outer groove's centre at which the normal forces balance."""
    low: float = p[layout.OUTER_LENGTH, case]
    f_low, _ = _along_and_across(p, case, cage, control, a1, a2, alpha, low)
    if not f_low > 0.0:
        return low
    f_first, step = f_low, 1e-4 * low
    high = low + step
    f_high, _ = _along_and_across(p, case, cage, control, a1, a2, alpha, high)
    while f_high > 0.0 and step < low:
        low, f_low = high, f_high
        step *= 4.0
        high += step
        f_high, _ = _along_and_across(p, case, cage, control, a1, a2, alpha, high)
    kept, middle = 0.0, high  # the Illinois method: an end that is kept twice counts half
    for _ in range(BRACKET_STEPS):
        middle = high - f_high * (high - low) / (f_high - f_low)
        if not low < middle < high:  # nothing lies between
            break
        f_middle, _ = _along_and_across(p, case, cage, control, a1, a2, alpha, middle)
        work[0] -= 0.5
        if abs(f_middle) <= rounding(p, case, f_first):
            break
        if f_middle > 0.0:
            low, f_low = middle, f_middle
            f_high *= 0.5 if kept > 0.0 else 1.0
            kept = 1.0
        else:
            high, f_high = middle, f_middle
            f_low *= 0.5 if kept < 0.0 else 1.0
            kept = -1.0
    return middle


@filling
def _bracketed(
    p: Array, case: int, cage: float, control: float, a1: float, a2: float, work: Array
) -> Found:
    """The ball's place between bounds of its outer angle: (whether found, X1, X2); A1 >= 0."""
    low, high = 0.0, atan2(a1, a2)
    _, f_high = _along_and_across(
        p, case, cage, control, a1, a2, high, _reach_at(p, case, cage, control, a1, a2, high, work)
    )
    if f_high > 0.0:  # counter-rotating rings turn the ball the other way
        low, high = high, 0.5 * pi
    for _ in range(BRACKET_STEPS):
        middle = 0.5 * (low + high)
        reach = _reach_at(p, case, cage, control, a1, a2, middle, work)
        _, across = _along_and_across(p, case, cage, control, a1, a2, middle, reach)
        if across > 0.0:
            low = middle
        else:
            high = middle
        x1, x2 = reach * sin(middle), reach * cos(middle)
        found, y1, y2, _ = _newton(p, case, cage, control, a1, a2, x1, x2, NEAR, work)
        if found:
            return True, y1, y2
        if high - low <= 1e-15 or work[0] < 0.0:
            break
    return False, reach * sin(middle), reach * cos(middle)


@filling
def held_up(p: Array, case: int, cage: float, control: float, a1: float, a2: float) -> Two:
    """Where a ball that its centrifugal force holds up touches both grooves, nearly: X1, X2.

    A1 >= 0. It stands at the apex of a triangle over |A|, whose sides grow with what the ball
    presses on the grooves: Q_i = F_c sin a_o / sin(a_i - a_o), Q_o = F_c sin a_i / sin(a_i - a_o).
    One that the grooves hold on the line of their centres is put half way.
    """
    length_o, length_i = p[layout.OUTER_LENGTH, case], inner_length(p, case, control)
    outer, _ = stored_polynomial(1.0, (p, layout.OUTER_STIFFNESS, case))
    inner, _ = stored_polynomial(1.0, (p, layout.INNER_STIFFNESS, case))
    f_c = balance_along(p, case, cage, control, a1, a2, 0.0, length_o)[2]
    apart = sqrt(a1 * a1 + a2 * a2)
    side_o, side_i = length_o + (f_c / outer) ** (2.0 / 3.0), length_i
    x1, x2 = 0.0, side_o
    for _ in range(3):
        cosine = 0.5 * (side_o + (apart - side_i) * (apart + side_i) / side_o) / apart
        alpha = max(atan2(a1, a2) - acos(min(max(cosine, -1.0), 1.0)), 0.0)
        x1, x2 = side_o * sin(alpha), side_o * cos(alpha)
        across = (x2 * a1 - x1 * a2) / (side_o * side_i)  # sin(a_i - a_o)
        if not across > IN_LINE:
            return 0.5 * a1, 0.5 * a2
        q_i, q_o = f_c * sin(alpha) / across, f_c * (a1 - x1) / (side_i * across)
        side_o = length_o + (max(q_o, 0.0) / outer) ** (2.0 / 3.0)
        side_i = length_i + (q_i / inner) ** (2.0 / 3.0)
    return x1, x2


@filling
def settle_otherwise(
    p: Array,
    case: int,
    cage: float,
    control: float,
    a1: float,
    a2: float,
    near: float,
    work: Array,
) -> Settled:
    """`settle` where Newton's method fails from the first guess."""
    found, y1, y2 = free_ball(p, case, cage, control, a1, a2)
    if not found:
        side = 1.0 if a1 >= 0.0 else -1.0
        y1, y2 = held_up(p, case, cage, control, side * a1, a2)
        found, y1, y2, _ = _newton(p, case, cage, control, side * a1, a2, y1, y2, near, work)
        if not found:
            found, y1, y2 = _bracketed(p, case, cage, control, side * a1, a2, work)
        y1 *= side
    return found, y1, y2, linearised(p, case, cage, control, a1, a2, y1, y2)


@filling
def settle(
    p: Array,
    case: int,
    cage: float,
    control: float,
    a1: float,
    a2: float,
    x1: float,
    x2: float,
    near: float,
    work: Array,
) -> Settled:
    """Find a moving ball's place from a first guess: whether found, X1, X2, the ball there.

    The ball is as it was before the last step, which about squares its residual, over its loads;
    near: that residual, `NEAR` or more. work (1,): evaluations of a ball that may still be spent,
    counted down.
    """
    found, y1, y2, ball = _newton(p, case, cage, control, a1, a2, x1, x2, near, work)
    if found:
        return True, y1, y2, ball
    return settle_otherwise(p, case, cage, control, a1, a2, near, work)
