"""One ball between two grooves, in balance of forces and moments with the friction on it.

Unknowns: its place X (x, r) from the outer groove's centre, and its angular velocity ω_b
(x, e, r), absolute, in the axes of the contact frame at its azimuth. Given: the inner groove's
centre A, the speeds of the rings, and the orbital speed ω_m, which all balls share with the cage.

    Q_i a_i - Q_o a_o + friction + F_c (0, 1) = 0          in the radial plane
    moments of the friction = J ω_m x̂ × ω_b                about the ball's centre

Along the orbit the cage pushes the ball as much as the friction is not in balance.

Jones (1959, 1960); Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 8.
"""

from __future__ import annotations

from math import sqrt

import numpy as np

from rolamento.equilibrium import rows
from rolamento.equilibrium.ball import contact_exact
from rolamento.equilibrium.single import coefficients
from rolamento.equilibrium.traction.contact import FORCES, add_friction
from rolamento.equilibrium.types import Array, Two
from rolamento.numerics.compiled import shared

OUTPUTS = 6  # Fx, Fr, Fe on the ball, Mx, Me, Mr about its centre
INPUTS = 6  # y1, y2 (the contact's vector), ω_x, ω_e, ω_r of the ball, ω_m

# constants of a case beside its column of `rows`
RADIUS = 0  # r_c, of the orbit
INERTIA = 1  # J
MASS = 2
HALF = 3  # D / 2
GROOVE_INNER = 4  # radius of the deformed surface 2 f D / (2 f + 1)
GROOVE_OUTER = 5
FRICTION = 6  # μ
AXES_INNER = 7  # a / Q^(1/3), then b / Q^(1/3): polynomials in cos α
AXES_OUTER = AXES_INNER + 2 * rows.COEFFICIENTS
CONSTANTS = AXES_OUTER + 2 * rows.COEFFICIENTS


@shared
def polynomial(c: Array, first: int, x: float) -> Two:
    """A polynomial of `rows.COEFFICIENTS` terms and its slope, by Horner's scheme."""
    value = c[first + rows.COEFFICIENTS - 1]
    slope = 0.0
    for power in range(rows.COEFFICIENTS - 2, -1, -1):
        slope = slope * x + value
        value = value * x + c[first + power]
    return value, slope


@shared
def contact_forces(
    p: Array,
    case: int,
    k: Array,
    inner: bool,
    y1: float,
    y2: float,
    omega: Array,
    orbit: float,
    nodes: tuple[Array, Array, Array],
    least: Array,
    out: Array,
    jacobian: Array,
) -> tuple[float, float]:
    """Forces and moments of one race on the ball, and their derivatives: (Q, dissipated power).

    y1, y2: from the groove's centre to the ball's (outer), or from the ball's to the groove's
    (inner). Fills out (OUTPUTS,) and jacobian (OUTPUTS, INPUTS).
    """
    if inner:
        length, series = p[rows.INNER_LENGTH, case], rows.INNER_STIFFNESS
        groove, axes, sign = k[GROOVE_INNER], AXES_INNER, 1.0
        speed = p[rows.INNER_SPEED, case]
    else:
        length, series = p[rows.OUTER_LENGTH, case], rows.OUTER_STIFFNESS
        groove, axes, sign = k[GROOVE_OUTER], AXES_OUTER, -1.0
        speed = p[rows.OUTER_SPEED, case]
    out[:] = 0.0
    jacobian[:, :] = 0.0
    s, c, v, _, q, kn, ka = contact_exact(y1, y2, length, coefficients(p, series, case))
    if q <= 0.0:
        return 0.0, 0.0
    root = q ** (1.0 / 3.0)
    a_1, a_c = polynomial(k, axes, c)
    b_1, b_c = polynomial(k, axes + rows.COEFFICIENTS, c)
    a, b = a_1 * root, b_1 * root
    spin = (omega[0] - speed) * s + omega[2] * c
    across = (omega[0] - speed) * c - omega[2] * s
    w = (speed - orbit) * k[RADIUS]
    g, n, grow = np.empty(FORCES), np.empty((FORCES, FORCES)), np.empty((FORCES, 2))
    power = add_friction(
        nodes[0], nodes[1], nodes[2], spin, across, omega[1], w, -sign, k[FRICTION] * q,
        a, b, groove, k[HALF], least, g, n, grow,
    )  # fmt: skip

    out[0] = sign * q * s + g[4] * c
    out[1] = sign * q * c - g[4] * s
    out[2] = g[3]
    out[3] = g[0] * s + g[1] * c
    out[4] = g[2]
    out[5] = g[0] * c - g[1] * s

    # derivatives by the load and by the angle, then by the contact's vector
    h, by_load = np.empty(FORCES), np.empty(FORCES)
    for i in range(FORCES):
        h[i] = n[i, 0] * across - n[i, 1] * spin
        h[i] -= s * (grow[i, 0] * a_c / a_1 + grow[i, 1] * b_c / b_1)
        by_load[i] = (g[i] + (grow[i, 0] + grow[i, 1]) / 3.0) / q
    for column in range(2):
        turn = c * v if column == 0 else -s * v
        load = kn * (s if column == 0 else c) + ka * turn
        m_a = by_load[0] * load + h[0] * turn
        m_t = by_load[1] * load + h[1] * turn
        f_t = by_load[4] * load + h[4] * turn
        jacobian[0, column] = sign * (load * s + q * c * turn) + f_t * c - g[4] * s * turn
        jacobian[1, column] = sign * (load * c - q * s * turn) - f_t * s - g[4] * c * turn
        jacobian[2, column] = by_load[3] * load + h[3] * turn
        jacobian[3, column] = m_a * s + m_t * c + (g[0] * c - g[1] * s) * turn
        jacobian[4, column] = by_load[2] * load + h[2] * turn
        jacobian[5, column] = m_a * c - m_t * s - (g[0] * s + g[1] * c) * turn
    for column in range(2, INPUTS):
        for i in range(FORCES):
            if column == 2:
                h[i] = n[i, 0] * s + n[i, 1] * c
            elif column == 3:
                h[i] = n[i, 2]
            elif column == 4:
                h[i] = n[i, 0] * c - n[i, 1] * s
            else:
                h[i] = -n[i, 3] * k[RADIUS]
        jacobian[0, column] = h[4] * c
        jacobian[1, column] = -h[4] * s
        jacobian[2, column] = h[3]
        jacobian[3, column] = h[0] * s + h[1] * c
        jacobian[4, column] = h[2]
        jacobian[5, column] = h[0] * c - h[1] * s
    return q, power


@shared
def rolling_start(
    p: Array, case: int, k: Array, s_i: float, c_i: float, s_o: float, c_o: float
) -> tuple[float, float, float]:
    """ω_x, ω_r and ω_m of a ball that rolls on both races and spins on the inner one only."""
    inner, outer = p[rows.INNER_SPEED, case], p[rows.OUTER_SPEED, case]
    half, radius = k[HALF], k[RADIUS]
    # with u = (ω_x - ω_outer, ω_r) along the outer contact's t, no spin there: u = τ (c_o, -s_o)
    cosine = c_i * c_o + s_i * s_o
    # outer: -τ half + (outer - ω_m) radius = 0; inner: Ω_t half + (inner - ω_m) radius = 0
    # with Ω_t = τ cosine - (inner - outer) c_i
    relative = inner - outer
    tau = (half * c_i - radius) * relative / (half * (1.0 + cosine))
    orbit = outer - tau * half / radius
    return outer + tau * c_o, -tau * s_o, orbit


@shared
def least_speed(p: Array, case: int, k: Array) -> Two:
    """The scale of slip, |ω_i - ω_o| D, and of angular velocity."""
    relative = abs(p[rows.INNER_SPEED, case] - p[rows.OUTER_SPEED, case])
    return 2.0 * relative * k[HALF], relative * sqrt(1.0 + (k[RADIUS] / k[HALF]) ** 2)
