"""One ball or one case at a time, in exact arithmetic: the plain form of the equations.

`blocks` is fast; this is what it is measured by. A ball is evaluated as `ball` writes it, a
ring by a loop over its balls.
"""

from __future__ import annotations

from typing import Final

from rolamento.equilibrium import rows
from rolamento.equilibrium.ball import contact_exact, inertia_exact, linearised_exact, polar_exact
from rolamento.equilibrium.types import (
    Array,
    Coefficients,
    Linearised,
    Motion,
    Race,
    Six,
    StaticBall,
    Ten,
    Three,
    Two,
)
from rolamento.numerics.compiled import inline_exact, shared

LOAD_FLOOR: Final = 1e-6  # of the heaviest ball: below it a ball's own load is no scale


@inline_exact
def coefficients(p: Array, row: int, case: int) -> Coefficients:
    """The seven coefficients of a contact's stiffness."""
    return (
        p[row, case], p[row + 1, case], p[row + 2, case], p[row + 3, case],
        p[row + 4, case], p[row + 5, case], p[row + 6, case],
    )  # fmt: skip


@inline_exact
def races(p: Array, case: int) -> tuple[Race, Race]:
    """Inner and outer contact: free length and stiffness."""
    inner = (p[rows.INNER_LENGTH, case], coefficients(p, rows.INNER_STIFFNESS, case))
    outer = (p[rows.OUTER_LENGTH, case], coefficients(p, rows.OUTER_STIFFNESS, case))
    return inner, outer


@inline_exact
def motion(p: Array, case: int) -> Motion:
    """gamma', c_f, c_g, the rings' speeds, and the arm of the friction."""
    return (
        p[rows.GAMMA, case], p[rows.CENTRIFUGAL, case], p[rows.GYROSCOPIC, case],
        p[rows.INNER_SPEED, case], p[rows.OUTER_SPEED, case], p[rows.FRICTION_ARM, case],
    )  # fmt: skip


@inline_exact
def inner_share(p: Array, case: int, sigma: float) -> float:
    """lambda_i: the inner race's part of the gyroscopic moment."""
    return p[rows.LAMBDA_INNER, case] if sigma > 0 else 2.0


@inline_exact
def direction(p: Array, case: int, cosine: float, sine: float) -> Two:
    """Cos and sin of a ball's azimuth, the first ball's taken in."""
    c0, s0 = p[rows.COS_FIRST, case], p[rows.SIN_FIRST, case]
    return cosine * c0 - sine * s0, sine * c0 + cosine * s0


@inline_exact
def groove(p: Array, case: int, u: Array, c: float, s: float) -> Two:
    """A1, A2: the inner groove's centre at azimuth (c, s), for the ring's displacement u."""
    a1 = p[rows.AXIAL_OFFSET, case] + u[0] + c * u[3] - s * u[4]
    a2 = p[rows.RADIAL_OFFSET, case] + c * u[2] + s * u[1]
    return a1, a2


@shared
def contacts(p: Array, case: int, sigma: float, a1: float, a2: float, x1: float, x2: float) -> Ten:
    """Both contacts and the inertia of a ball at X: what a result shows.

    Returns s_i, c_i, |Y|, Q_i, s_o, c_o, |X|, Q_o, F_c, T.
    """
    inner, outer = races(p, case)
    gamma, c_f, c_g, inner_speed, outer_speed, _ = motion(p, case)
    s_o, c_o, v_o, _, q_o, _, _ = contact_exact(x1, x2, outer[0], outer[1])
    s_i, c_i, v_i, _, q_i, _, _ = contact_exact(a1 - x1, a2 - x2, inner[0], inner[1])
    f_c, _, _, t, _, _ = inertia_exact(
        s_i, c_i, s_o, c_o, gamma, c_f, c_g, inner_speed, outer_speed, sigma
    )
    return s_i, c_i, 1.0 / v_i, q_i, s_o, c_o, 1.0 / v_o, q_o, f_c, t


@shared
def linearised(
    p: Array, case: int, sigma: float, a1: float, a2: float, x1: float, x2: float
) -> Linearised:
    """`ball.linearised` for a ball of a case."""
    inner, outer = races(p, case)
    lambda_i = inner_share(p, case, sigma)
    ball: Linearised = linearised_exact(
        a1, a2, x1, x2, inner, outer, motion(p, case), sigma, lambda_i
    )
    return ball


@shared
def static_ball(p: Array, case: int, a1: float, a2: float) -> StaticBall:
    """A ball without inertia: its place X1, X2, then as of `linearised` from the force on."""
    inner, outer = races(p, case)
    series = coefficients(p, rows.SERIES_STIFFNESS, case)
    s, c, v, delta, q, kn, ka = contact_exact(a1, a2, inner[0] + outer[0], series)
    k11, k12, k21, k22 = polar_exact(s, c, kn, ka * v, q * v)
    outer_stiffness = outer[1][6]
    for power in range(5, -1, -1):
        outer_stiffness = outer_stiffness * c + outer[1][power]
    reach: float = outer[0] + (q / outer_stiffness) ** (2.0 / 3.0)
    force, stiffness = (q * s, q * c, q * s), (k11, k12, k21, k22, k11, k12)
    return s * reach, c * reach, force, stiffness, q, (q, s, delta)


@inline_exact
def _add_row(matrix: Array, row: int, by_a1: float, by_a2: float, c: float, s: float) -> None:
    """Add a row of the ring's stiffness, given the derivatives by A1 and A2."""
    matrix[row, 0] += by_a1
    matrix[row, 1] += s * by_a2
    matrix[row, 2] += c * by_a2
    matrix[row, 3] += c * by_a1
    matrix[row, 4] -= s * by_a1


@shared
def add_to_ring(
    reaction: Array, matrix: Array, c: float, s: float, force: Three, stiffness: Six
) -> None:
    """Add one ball's force and stiffness to the ring's (as lanes._add_to_ring does)."""
    f1, f2, h = force
    k11, k12, k21, k22, h1, h2 = stiffness
    reaction[0] += f1
    reaction[1] += s * f2
    reaction[2] += c * f2
    reaction[3] += c * h
    reaction[4] -= s * h
    _add_row(matrix, 0, k11, k12, c, s)
    _add_row(matrix, 1, s * k21, s * k22, c, s)
    _add_row(matrix, 2, c * k21, c * k22, c, s)
    _add_row(matrix, 3, c * h1, c * h2, c, s)
    _add_row(matrix, 4, -s * h1, -s * h2, c, s)


@shared
def moves(p: Array, case: int) -> bool:
    """Whether the case has inertia at all: a speed, and an effect switched on."""
    speed = p[rows.INNER_SPEED, case] != 0.0 or p[rows.OUTER_SPEED, case] != 0.0
    inertia = p[rows.CENTRIFUGAL, case] > 0.0 or p[rows.GYROSCOPIC, case] > 0.0
    return bool(speed and inertia)
