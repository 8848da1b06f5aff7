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
from typing import NamedTuple

import numpy as np

from rolamento.kinematics import LEAST_COSINE
from rolamento.numerics.compiled import filling, shared
from rolamento.rows.ball import layout
from rolamento.rows.ball.ball import contact_exact
from rolamento.rows.ball.traction.contact import FORCES, SUMS, add_friction
from rolamento.rows.ball.types import Array, Two

OUTPUTS = 6  # Fx, Fr, Fe on the ball, Mx, Me, Mr about its centre
MOST_NODES = 4096
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
AXES_OUTER = AXES_INNER + 2 * layout.COEFFICIENTS
CONSTANTS = AXES_OUTER + 2 * layout.COEFFICIENTS


class Rig(NamedTuple):
    """What stays while a case is solved.

    p: parameters (layout.PARAMETERS, cases), and which of the cases; k (CONSTANTS,); drag on the
    cage, N·m; cosines, sines of the azimuths beyond the first ball's (balls,).
    """

    p: Array
    case: int
    k: Array
    drag: float
    cosines: Array
    sines: Array


NO_FILM = np.zeros((0, 2, 0))
NO_LIFT = np.zeros((0, 2))


class Mesh(NamedTuple):
    """Nodes of an ellipse as of `ellipse_nodes`, and v0² at each; (nodes,).

    film (balls, 2, nodes): what a film adds to v0² at the inner and the outer contact of every
    ball; lift (balls, 2): its thickness, where it enters the geometry. Empty without a film.
    """

    across: Array
    along: Array
    weight: Array
    least: Array
    film: Array = NO_FILM
    lift: Array = NO_LIFT


class Race(NamedTuple):
    """Room for what one race does to a ball.

    force (OUTPUTS,), slope (OUTPUTS, INPUTS); friction (FORCES,) and its derivatives by velocity
    (FORCES, FORCES), by the logarithms of the axes (FORCES, 2), by angle and by load (FORCES,);
    least, v0² at the nodes of this contact; lift (1,), the film between ball and race; sums
    (SUMS,), of the nodes.
    """

    force: Array
    slope: Array
    friction: Array
    by_velocity: Array
    growth: Array
    by_angle: Array
    by_load: Array
    least: Array
    lift: Array
    sums: Array


@shared
def race_room() -> Race:
    """Make room for one race."""
    return Race(
        np.empty(OUTPUTS),
        np.empty((OUTPUTS, INPUTS)),
        np.empty(FORCES),
        np.empty((FORCES, FORCES)),
        np.empty((FORCES, 2)),
        np.empty(FORCES),
        np.empty(FORCES),
        np.empty(MOST_NODES),
        np.zeros(1),
        np.empty(SUMS),
    )


@filling
def polynomial(c: Array, first: int, x: float) -> Two:
    """A polynomial of `layout.COEFFICIENTS` terms and its slope, by Horner's scheme."""
    value = c[first + layout.COEFFICIENTS - 1]
    slope = 0.0
    for power in range(layout.COEFFICIENTS - 2, -1, -1):
        slope = slope * x + value
        value = value * x + c[first + power]
    return value, slope


@filling
def contact_forces(
    rig: Rig,
    inner: bool,
    y1: float,
    y2: float,
    omega: Array,
    orbit: float,
    mesh: Mesh,
    least: Array,
    found: Race,
) -> tuple[float, float]:
    """Forces and moments of one race on the ball, and their derivatives: (Q, dissipated power).

    y1, y2: from the groove's centre to the ball's (outer), or from the ball's to the groove's
    (inner). omega (3,), orbit: ω_b and ω_m; least: v0² at the nodes of this contact. Fills
    found.force and found.slope.
    """
    p, case, k = rig.p, rig.case, rig.k
    if inner:
        length, series = p[layout.INNER_LENGTH, case], layout.INNER_STIFFNESS
        groove, axes, sign = k[GROOVE_INNER], AXES_INNER, 1.0
        speed = p[layout.INNER_SPEED, case]
    else:
        length, series = p[layout.OUTER_LENGTH, case], layout.OUTER_STIFFNESS
        groove, axes, sign = k[GROOVE_OUTER], AXES_OUTER, -1.0
        speed = p[layout.OUTER_SPEED, case]
    for i in range(OUTPUTS):
        found.force[i] = 0.0
        for column in range(INPUTS):
            found.slope[i, column] = 0.0
    length -= found.lift[0]
    s, c, v, _, q, kn, ka = contact_exact(y1, y2, length, (p, series, case))
    if q <= 0.0:
        return 0.0, 0.0
    root = q ** (1.0 / 3.0)
    a_1, a_c = polynomial(k, axes, c)
    b_1, b_c = polynomial(k, axes + layout.COEFFICIENTS, c)
    spin = (omega[0] - speed) * s + omega[2] * c
    across = (omega[0] - speed) * c - omega[2] * s
    w = (speed - orbit) * k[RADIUS]
    g, n, grow = found.friction, found.by_velocity, found.growth
    power = add_friction(
        mesh.across, mesh.along, mesh.weight, spin, across, omega[1], w, -sign, k[FRICTION] * q,
        a_1 * root, b_1 * root, groove, k[HALF], least, g, n, grow, found.sums,
    )  # fmt: skip
    found.force[0] = sign * q * s + g[4] * c
    found.force[1] = sign * q * c - g[4] * s
    found.force[2] = g[3]
    found.force[3] = g[0] * s + g[1] * c
    found.force[4] = g[2]
    found.force[5] = g[0] * c - g[1] * s
    turn = found.by_angle
    for i in range(FORCES):
        turn[i] = n[i, 0] * across - n[i, 1] * spin
        turn[i] -= s * (grow[i, 0] * a_c / a_1 + grow[i, 1] * b_c / b_1)
    _slope_by_place(found, sign, q, s, c, v, kn, ka)
    _slope_by_motion(found, s, c, k[RADIUS])
    return q, power


@filling
def _slope_by_place(
    found: Race, sign: float, q: float, s: float, c: float, v: float, kn: float, ka: float
) -> None:
    """Derivatives by the contact's vector: through the load, and through the angle."""
    g, by_angle, by_load, slope = found.friction, found.by_angle, found.by_load, found.slope
    for i in range(FORCES):
        by_load[i] = (g[i] + (found.growth[i, 0] + found.growth[i, 1]) / 3.0) / q
    for column in range(2):
        turn = c * v if column == 0 else -s * v
        load = kn * (s if column == 0 else c) + ka * turn
        m_a = by_load[0] * load + by_angle[0] * turn
        m_t = by_load[1] * load + by_angle[1] * turn
        f_t = by_load[4] * load + by_angle[4] * turn
        slope[0, column] = sign * (load * s + q * c * turn) + f_t * c - g[4] * s * turn
        slope[1, column] = sign * (load * c - q * s * turn) - f_t * s - g[4] * c * turn
        slope[2, column] = by_load[3] * load + by_angle[3] * turn
        slope[3, column] = m_a * s + m_t * c + (g[0] * c - g[1] * s) * turn
        slope[4, column] = by_load[2] * load + by_angle[2] * turn
        slope[5, column] = m_a * c - m_t * s - (g[0] * s + g[1] * c) * turn


@filling
def _slope_by_motion(found: Race, s: float, c: float, radius: float) -> None:
    """Derivatives by ω_x, ω_e, ω_r of the ball and by ω_m."""
    n, h, slope = found.by_velocity, found.by_angle, found.slope
    for column in range(2, INPUTS):
        for i in range(FORCES):
            if column == 2:
                h[i] = n[i, 0] * s + n[i, 1] * c
            elif column == 3:
                h[i] = n[i, 2]
            elif column == 4:
                h[i] = n[i, 0] * c - n[i, 1] * s
            else:
                h[i] = -n[i, 3] * radius
        slope[0, column] = h[4] * c
        slope[1, column] = -h[4] * s
        slope[2, column] = h[3]
        slope[3, column] = h[0] * s + h[1] * c
        slope[4, column] = h[2]
        slope[5, column] = h[0] * c - h[1] * s


@filling
def rolling_start(
    rig: Rig, s_i: float, c_i: float, s_o: float, c_o: float
) -> tuple[float, float, float]:
    """ω_x, ω_r and ω_m of a ball that rolls on both races and spins on the inner one only."""
    inner, outer = rig.p[layout.INNER_SPEED, rig.case], rig.p[layout.OUTER_SPEED, rig.case]
    half, radius = rig.k[HALF], rig.k[RADIUS]
    # with u = (ω_x - ω_outer, ω_r) along the outer contact's t, no spin there: u = τ (c_o, -s_o)
    # grooves that face away, where a ball hardly touches, are no axis to roll about
    cosine = max(c_i * c_o + s_i * s_o, LEAST_COSINE)
    # outer: -τ half + (outer - ω_m) radius = 0; inner: Ω_t half + (inner - ω_m) radius = 0
    # with Ω_t = τ cosine - (inner - outer) c_i
    relative = inner - outer
    tau = (half * c_i - radius) * relative / (half * (1.0 + cosine))
    orbit = outer - tau * half / radius
    return outer + tau * c_o, -tau * s_o, orbit


@filling
def least_speed(rig: Rig) -> Two:
    """The scale of slip, |ω_i - ω_o| D, and of angular velocity."""
    relative = abs(rig.p[layout.INNER_SPEED, rig.case] - rig.p[layout.OUTER_SPEED, rig.case])
    half = rig.k[HALF]
    return 2.0 * relative * half, relative * sqrt(1.0 + (rig.k[RADIUS] / half) ** 2)
