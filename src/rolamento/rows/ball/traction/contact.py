"""Friction over one contact ellipse, and how it changes with the motion of the ball.

The contact has the axes a = (sin α, cos α) in the radial plane (x, r), outward at both races,
t = (cos α, -sin α) across rolling, and e along increasing azimuth; a × t = e. The ball's centre
is at r_c from the axis. With Ω the ball's angular velocity less the ring's, w = (ω_ring - ω_m) r_c,
and σ = +1 at the outer race, -1 at the inner, the ball slips over the race at (x, y) = (across,
along) with

    v_t = σ ρ Ω_e - y Ω_a
    v_e = x Ω_a - σ ρ Ω_t + w

where ρ(x) is the distance of the deformed surface from the ball's centre along a. Each point
takes the friction f = -μ p v / √(v² + v0²): Coulomb's, smoothed at speeds below v0. What the ball
feels of it, M_a, M_t, M_e, F_e, F_t, belongs to the velocities Ω_a, Ω_t, Ω_e, w, and a
translation along t: forces are B' f where v = B V, and their derivative by V is symmetric.

A film that is sheared has the same law with v0 = μ p h / η, its own at every point.

Jones (1959); Harris (1971); Johnson, Contact Mechanics (1985), chapter 8.
"""

from __future__ import annotations

from math import pi, sqrt

import numpy as np

from rolamento.numerics.compiled import vector_loop
from rolamento.rows.ball.types import Array

FORCES = 5  # M_a, M_t, M_e, F_e, F_t
LANES = 64  # places across that are summed at a time
# rows of LANES: ρ σ, v_e; sums over y of g, p_t, y p_t, p_t v_t, of H's entries times 1, y, y²
R, V_E, G, P, Y_P, W, TT, Y_TT, YY_TT, TE, Y_TE, EE = range(0, 12 * LANES, LANES)
SUMS = 12 * LANES


def ellipse_nodes(across: int, along: int) -> tuple[Array, Array, Array]:
    """Nodes and weights for integrals of Hertz pressure over an ellipse: (x/a, y/b, weight).

    Gauss-Legendre across, Gauss-Chebyshev of the second kind along; the weights contain the
    pressure and sum to one. Shapes (across * along,), row after row along y, x rising in each.
    """
    x, legendre = np.polynomial.legendre.leggauss(across)
    theta = pi * np.arange(1, along + 1) / (along + 1)
    chebyshev = pi / (along + 1) * np.sin(theta) ** 2
    height = np.sqrt(1.0 - x * x)
    eta = height[:, np.newaxis] * np.cos(theta)
    weight = 1.5 / pi * ((1.0 - x * x) * legendre)[:, np.newaxis] * chebyshev
    return np.tile(x, along), eta.T.ravel(), weight.T.ravel()


@vector_loop
def add_friction(
    xi: Array,
    eta: Array,
    weight: Array,
    spin: float,
    across: float,
    roll: float,
    w: float,
    sigma: float,
    grip: float,
    a: float,
    b: float,
    groove: float,
    half: float,
    least: Array,
    force: Array,
    slope: Array,
    growth: Array,
    sums: Array,
) -> float:
    """Integrate the friction on a ball at one contact, with its derivatives.

    spin, across, roll: Ω_a, Ω_t, Ω_e; grip: μ Q; a, b: semi-axes; groove: radius of the deformed
    surface; half: D/2; least: v0² at every node. Writes force (FORCES,) and slope (FORCES,
    FORCES), symmetric, the derivative by (Ω_a, Ω_t, Ω_e, w, translation along t), and growth
    (FORCES, 2), the derivative by ln a and ln b. Returns the power of the friction, at least zero.

    All places across lie side by side, and first the nodes along y are summed at each: x, r and
    v_e are the same there. sums: room for that, (SUMS,).
    """
    m_a, m_t, m_e, f_e, f_t, power = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    s00, s01, s02, s03, s04 = 0.0, 0.0, 0.0, 0.0, 0.0
    s11, s12, s13, s14 = 0.0, 0.0, 0.0, 0.0
    s22, s23, s24, s33, s34, s44 = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    g00, g10, g20, g30, g40 = 0.0, 0.0, 0.0, 0.0, 0.0
    g01, g11, g21, g31, g41 = 0.0, 0.0, 0.0, 0.0, 0.0
    base = sqrt(half * half - a * a) - sqrt(groove * groove - a * a)
    square = groove * groove
    sink = a * a * (1.0 / sqrt(square - a * a) - 1.0 / sqrt(half * half - a * a))
    wide = 1
    while wide < xi.size and xi[wide] > xi[wide - 1]:
        wide += 1
    for start in range(0, wide, LANES):
        lanes = min(LANES, wide - start)
        for i in range(lanes):
            x = a * xi[start + i]
            r = sigma * (sqrt(square - x * x) + base)
            sums[R + i], sums[V_E + i] = r, x * spin - r * across + w
            sums[G + i], sums[P + i], sums[Y_P + i], sums[W + i] = 0.0, 0.0, 0.0, 0.0
            sums[TT + i], sums[Y_TT + i], sums[YY_TT + i] = 0.0, 0.0, 0.0
            sums[TE + i], sums[Y_TE + i], sums[EE + i] = 0.0, 0.0, 0.0
        for first in range(start, xi.size, wide):
            for i in range(lanes):
                y = b * eta[first + i]
                v_t = sums[R + i] * roll - y * spin
                v_e = sums[V_E + i]
                smooth = least[first + i]
                other = v_e * v_e + smooth
                inverse = 1.0 / (v_t * v_t + other)
                g = grip * weight[first + i] * sqrt(inverse)
                p = g * v_t
                g_v = g * inverse
                h_tt = g_v * other
                h_te = g_v * v_t
                sums[G + i] += g
                sums[P + i] += p
                sums[Y_P + i] += y * p
                sums[W + i] += p * v_t
                sums[TT + i] += h_tt
                sums[Y_TT + i] += y * h_tt
                sums[YY_TT + i] += y * y * h_tt
                sums[TE + i] += h_te
                sums[Y_TE + i] += y * h_te
                sums[EE + i] += g_v * (v_t * v_t + smooth)
        for i in range(lanes):
            x = a * xi[start + i]
            r = sums[R + i]
            v_e = sums[V_E + i]
            p_t = sums[P + i]
            p_e = v_e * sums[G + i]
            y_p = sums[Y_P + i]
            h_tt = sums[TT + i]
            h_te = -v_e * sums[TE + i]
            h_ee = sums[EE + i]
            y_tt = sums[Y_TT + i]
            y_te = -v_e * sums[Y_TE + i]
            m_a -= x * p_e - y_p
            m_t += r * p_e
            m_e -= r * p_t
            f_e -= p_e
            f_t -= p_t
            power += sums[W + i] + p_e * v_e
            # the columns of H B, then B' of them; B = [(-y, 0, r, 0, 1), (x, -r, 0, 1, 0)]
            u_t = x * h_te - y_tt
            u_e = x * h_ee - y_te
            s00 -= x * u_e - (x * y_te - sums[YY_TT + i])
            s01 += r * u_e
            s02 -= r * u_t
            s03 -= u_e
            s04 -= u_t
            s11 -= r * r * h_ee
            s12 += r * r * h_te
            s13 += r * h_ee
            s14 += r * h_te
            s22 -= r * r * h_tt
            s23 -= r * h_te
            s24 -= r * h_tt
            s33 -= h_ee
            s34 -= h_te
            s44 -= h_tt
            # a longer ellipse: x grows by x, r by r_a; a broader one: y by y
            r_a = sigma * (sink - x * x / (sigma * r - base))
            a_t = r_a * roll
            a_e = x * spin - r_a * across
            q_t = h_tt * a_t + h_te * a_e
            q_e = h_te * a_t + h_ee * a_e
            g00 -= x * (q_e + p_e) - (y_tt * a_t + y_te * a_e)
            g10 += r * q_e + r_a * p_e
            g20 -= r * q_t + r_a * p_t
            g30 -= q_e
            g40 -= q_t
            g01 += x * spin * y_te - spin * sums[YY_TT + i] + y_p
            g11 -= r * spin * y_te
            g21 += r * spin * y_tt
            g31 += spin * y_te
            g41 += spin * y_tt
    force[0], force[1], force[2], force[3], force[4] = m_a, m_t, m_e, f_e, f_t
    slope[0, 0], slope[0, 1], slope[0, 2], slope[0, 3], slope[0, 4] = s00, s01, s02, s03, s04
    slope[1, 1], slope[1, 2], slope[1, 3], slope[1, 4] = s11, s12, s13, s14
    slope[2, 2], slope[2, 3], slope[2, 4] = s22, s23, s24
    slope[3, 3], slope[3, 4], slope[4, 4] = s33, s34, s44
    growth[0, 0], growth[1, 0], growth[2, 0], growth[3, 0], growth[4, 0] = g00, g10, g20, g30, g40
    growth[0, 1], growth[1, 1], growth[2, 1], growth[3, 1], growth[4, 1] = g01, g11, g21, g31, g41
    for i in range(5):
        for j in range(i):
            slope[i, j] = slope[j, i]
    return power
