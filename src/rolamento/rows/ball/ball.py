"""One ball between two grooves: its forces, its residual, and their exact derivatives.

Everything happens in the ball's radial plane, in coordinates (x, r) from the centre of
curvature of the outer groove. The centre of the inner groove is at A, the ball's at X, and
Y = A - X, so that the two contacts are alike: each is a spring along its own vector (X for the
outer, Y for the inner), with the groove's offset L as its free length. A groove has a bottom and
two flanks and no roof: a contact presses only at |α| < 90°.

With the contact angle's unit vectors n = (sin a, cos a) and t = (cos a, -sin a), and
T = M_g / D the gyroscopic moment over the ball diameter,

    the inner ring presses on the ball with   f = Q_i n_i - lambda_i T t_i
    the ball presses on the outer ring with   g = Q_o n_o - lambda_o T t_o

and the ball is in equilibrium when r = f - g + F_c (0, 1) = 0 (Radaelli 2013, eqs. 76-77; the
gyroscopic moment is signed). The moment about the ring's axis plane has the arm of the groove's
centre; the friction lambda_i T acts f_i D further out, at the groove's surface: divided by the
arm, the moment is h = f_1 + (f_i D / R_i) lambda_i T.

The ball's orbit goes over from the cage's to its own under raceway control as the inner ring takes
hold of it (see `rolamento.kinematics`), and under inner control so does what it rolls on: nothing
jumps when a ball touches. The speed of the cage is an unknown of the
case, like the displacement of the ring.

The formulas are written for scalars and without branches, so that the same text compiles to
vector code over many cases (`_fast`) and to the plain form that checks it (`_exact`), which is
vector code too where K is at hand (`_given`): to the last bit the same.
"""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt
from typing import Any, Final

from rolamento.kinematics import LEAST_COSINE
from rolamento.numerics.compiled import inline_exact, inline_fast
from rolamento.rows.ball import layout
from rolamento.rows.ball.types import (
    Cage,
    Coefficients,
    Contact,
    Five,
    Four,
    Linearised,
    Motion,
    Race,
    StoredPolynomial,
    Three,
    Touching,
    Two,
)

TINY: Final = 1e-300
"""So that grooves whose centres coincide have a direction, any, and no NaN."""


long_polynomial = inline_exact(layout.long_polynomial)


def _short_polynomial(c: float, stiffness: Coefficients) -> Two:
    """K(cos a) and dK/d(cos a) from seven coefficients, by Horner's scheme."""
    k0, k1, k2, k3, k4, k5, k6 = stiffness
    value = k6
    slope = value
    value = value * c + k5
    slope = slope * c + value
    value = value * c + k4
    slope = slope * c + value
    value = value * c + k3
    slope = slope * c + value
    value = value * c + k2
    slope = slope * c + value
    value = value * c + k1
    slope = slope * c + value
    value = value * c + k0
    return value, slope


@inline_exact
def horner(value: float, slope: float, c: float, coefficient: float) -> Two:
    """K and dK/d(cos a) with one coefficient more, the next lower."""
    return value * c + coefficient, slope * c + value


short_polynomial = inline_exact(_short_polynomial)


def _at_hand(c: float, stiffness: Two) -> Two:
    """K(cos a) and dK/d(cos a), evaluated before."""
    return stiffness


@inline_exact
def stored_polynomial(c: float, stiffness: StoredPolynomial) -> Two:
    """K(cos a) and dK/d(cos a) to the last digits: as many coefficients as the case has."""
    p, first, case = stiffness
    count = int(p[layout.TERMS, case])
    if count > layout.COEFFICIENTS:
        first = long_polynomial(first)
    value = p[first + count - 1, case]
    slope = 0.0
    for power in range(count - 2, -1, -1):
        value, slope = horner(value, slope, c, p[first + power, case])
    return value, slope


def _formulas(inline: Callable[..., Any], polynomial: Callable[..., Two]) -> tuple[Any, ...]:
    """Build the formulas of a ball: how to compile them, and how to evaluate K."""

    @inline
    def towards(y1: float, y2: float) -> Four:
        """Sin a and cos a of a vector to the flanks of a groove, its length, and 1 over that."""
        up = max(y2, 0.0)
        length = sqrt(y1 * y1 + up * up + TINY)
        inverse = 1.0 / length
        return y1 * inverse, up * inverse, length, inverse

    @inline
    def contact(y1: float, y2: float, free_length: float, stiffness: Any) -> Contact:
        """A Hertz spring along y: sin a, cos a, da/dt (1/|y|), approach, Q, dQ/d|y|, dQ/da.

        Beyond 90° the flanks are taken to go on straight up, for the sake of a force without
        jumps on the way to the solution: there is none against a ball between them.
        """
        s, c, length, inverse = towards(y1, y2)
        delta = max(length - free_length, 0.0)
        value, slope = polynomial(c, stiffness)
        root = sqrt(delta)
        power = root * delta
        turn = inverse if y2 > 0.0 else 0.0
        return s, c, turn, delta, value * power, 1.5 * value * root, -s * slope * power

    @inline
    def own_orbit(inner: Contact, outer: Contact, motion: Motion, sigma: float) -> Three:
        """The speed of a ball's orbit under raceway control, and its derivatives by a_i, a_o.

        sigma is +1 when the outer race controls the ball and -1 when the inner race does; the
        other race is the slave.
        """
        s_i, c_i, s_o, c_o = inner[0], inner[1], outer[0], outer[1]
        gamma, inner_speed, outer_speed = motion[0], motion[3], motion[4]
        by_outer = sigma > 0.0
        s_slave = s_i if by_outer else s_o
        c_slave = c_i if by_outer else c_o
        turn = sigma * (inner_speed - outer_speed)

        cosine = c_i * c_o + s_i * s_o
        sine = (s_i * c_o - c_i * s_o) * sigma if cosine > LEAST_COSINE else 0.0
        inverse = 1.0 / (1.0 + max(cosine, LEAST_COSINE))
        w = (1.0 - sigma * gamma * c_slave) * inverse
        by_slave = turn * (sigma * gamma * s_slave + w * sine) * inverse
        by_control = -turn * w * sine * inverse
        speed = (outer_speed if by_outer else inner_speed) + turn * w
        return speed, by_slave if by_outer else by_control, by_control if by_outer else by_slave

    @inline
    def touching(
        a1: float,
        a2: float,
        x1: float,
        x2: float,
        inner: Race,
        outer: Race,
        motion: Motion,
        sigma: float,
    ) -> Touching:
        """The contacts of a ball at X with the inner groove at A, and the orbit that it rolls on.

        inner, outer: (free length L, K).
        """
        at_outer = contact(x1, x2, outer[0], outer[1])
        at_inner = contact(a1 - x1, a2 - x2, inner[0], inner[1])
        return at_inner, at_outer, own_orbit(at_inner, at_outer, motion, sigma)

    @inline
    def inertia(
        touch: Touching, motion: Motion, cage: Cage, sigma: float
    ) -> tuple[Five, Five, Five]:
        """F_c, T, and the lag of the cage behind the ball, weighted by its load.

        Each with its derivatives by a_i, a_o, Q_i and the cage's speed; sigma: as of `own_orbit`.
        c_f = m d_m / 2; c_g = J / (gamma' D) = m d_m / 10. The lag is h Q_i (ω_own - ω_cage).
        """
        s_i, c_i, _, _, q_i, _, _ = touch[0]
        s_o, c_o, _, _, _, _, _ = touch[1]
        own_speed, lag_i, lag_o = touch[2]
        _, c_f, c_g, inner_speed, outer_speed, _ = motion
        cage_speed, hold_rate, hold_offset, own = cage
        lag = own_speed - cage_speed

        # how firmly the inner ring holds the ball
        grip = min(max(q_i * hold_rate + hold_offset, 0.0), 1.0)
        hold = grip * grip * (3.0 - 2.0 * grip)
        hold_q = 6.0 * grip * (1.0 - grip) * hold_rate

        orbit = cage_speed + own * hold * lag
        orbit_i = own * hold * lag_i
        orbit_o = own * hold * lag_o
        orbit_q = own * hold_q * lag
        orbit_c = 1.0 - own * hold

        force = c_f * orbit * orbit
        force_m = 2.0 * c_f * orbit

        # rolling on the race in control: the inner one as far as it holds the ball
        by_outer = sigma > 0.0
        speed = outer_speed if by_outer else inner_speed
        s = s_o if by_outer else hold * s_i
        c = c_o if by_outer else hold * c_i
        rolls = -sigma * c_g * orbit * (orbit - speed)
        t = rolls * s
        t_m = -sigma * c_g * (2.0 * orbit - speed) * s
        t_i = t_m * orbit_i + (0.0 if by_outer else rolls * c)
        t_o = t_m * orbit_o + (rolls * c if by_outer else 0.0)
        t_q = t_m * orbit_q + (0.0 if by_outer else rolls * hold_q * s_i)
        t_c = t_m * orbit_c

        pull = q_i * hold
        return (
            (force, force_m * orbit_i, force_m * orbit_o, force_m * orbit_q, force_m * orbit_c),
            (t, t_i, t_o, t_q, t_c),
            (pull * lag, pull * lag_i, pull * lag_o, (hold + q_i * hold_q) * lag, -pull),
        )

    @inline
    def polar(s: float, c: float, nn: float, nt: float, tn: float, tt: float) -> Four:
        """The matrix nn n n' + nt n t' + tn t n' + tt t t', by rows."""
        return (
            nn * s * s + (nt + tn) * s * c + tt * c * c,
            (nn - tt) * s * c - nt * s * s + tn * c * c,
            (nn - tt) * s * c + nt * c * c - tn * s * s,
            nn * c * c - (nt + tn) * s * c + tt * s * s,
        )

    @inline
    def linearised(
        touch: Touching, motion: Motion, cage: Cage, sigma: float, lambda_i: float
    ) -> Linearised:
        """The ball at X with the inner groove at A, and the ring's and the cage's view of it.

        touch: as of `touching`; motion: (gamma', c_f, c_g, inner speed, outer speed, f_i D / R_i);
        cage: (its speed, and how it hands a ball over, as of `rows`). Returns

        - the residual r,
        - the Newton step dX = q + W dA + z dω with which the ball follows the groove and the cage,
        - the force f and moment h that the ball asks of the ring, after the step q,
        - their derivatives by A with the ball following: k (2 x 2) and h (2),
        - the scale of the ball's own loads, the greatest of Q_i, Q_o and F_c,
        - how it touches the rings: Q_i, cos a_i, cos a_o, the greater approach, sin a_i,
        - the cage: derivatives of f and h by its speed; the lag h Q_i (ω_own - ω), after the step
          q, and its derivatives by A and by the speed; all with the ball following,
        - f, h and the lag before the step q, and the lag's weight h Q_i.
        """
        arm = motion[5]
        s_i, c_i, v_i, delta_i, q_i, kn_i, ka_i = touch[0]
        s_o, c_o, v_o, delta_o, q_o, kn_o, ka_o = touch[1]
        force, turning, lagging = inertia(touch, motion, cage, sigma)
        f_c, f_c_i, f_c_o, f_c_q, f_c_c = force
        t, t_i, t_o, t_q, t_c = turning
        lag, lag_i, lag_o, lag_q, lag_c = lagging
        lambda_o = 2.0 - lambda_i
        m_i, m_i_o, m_i_c = lambda_i * t, lambda_i * t_o, lambda_i * t_c
        m_o, m_o_o, m_o_c = lambda_o * t, lambda_o * t_o, lambda_o * t_c

        f1 = q_i * s_i - m_i * c_i
        f2 = q_i * c_i + m_i * s_i
        r1 = f1 - q_o * s_o + m_o * c_o
        r2 = f2 - q_o * c_o - m_o * s_o + f_c

        # what depends on Y = (n, t): through the angle, t / |Y|, and through the load
        t_n, t_t = t_q * kn_i, (t_i + t_q * ka_i) * v_i
        m_i_n, m_i_t = lambda_i * t_n, lambda_i * t_t
        m_o_n, m_o_t = lambda_o * t_n, lambda_o * t_t
        f_c_n, f_c_t = f_c_q * kn_i, (f_c_i + f_c_q * ka_i) * v_i
        lag_n, lag_t = lag_q * kn_i, (lag_i + lag_q * ka_i) * v_i

        # df/dY and dg/dX, the turning of the friction with its own angle included
        y11, y12, y21, y22 = polar(s_i, c_i, kn_i, (ka_i + m_i) * v_i, -m_i_n, q_i * v_i - m_i_t)
        g11, g12, g21, g22 = polar(s_o, c_o, kn_o, (ka_o + m_o) * v_o, 0.0, (q_o - m_o_o) * v_o)
        # what the inner contact does to the outer side, and the outer angle to the inner side
        n1, n2 = m_o_n * c_o, f_c_n - m_o_n * s_o
        t1, t2 = m_o_t * c_o, f_c_t - m_o_t * s_o
        back1 = -m_i_o * c_i
        back2 = m_i_o * s_i
        p11 = y11 + n1 * s_i + t1 * c_i
        p12 = y12 + n1 * c_i - t1 * s_i
        p21 = y21 + n2 * s_i + t2 * c_i
        p22 = y22 + n2 * c_i - t2 * s_i
        s11 = p11 + g11 - back1 * c_o * v_o
        s12 = p12 + g12 + back1 * s_o * v_o
        s21 = p21 + g21 - (back2 + f_c_o) * c_o * v_o
        s22 = p22 + g22 + (back2 + f_c_o) * s_o * v_o
        # what the speed of the cage does
        d1 = -m_i_c * c_i + m_o_c * c_o
        d2 = m_i_c * s_i - m_o_c * s_o + f_c_c

        inverse = 1.0 / (s11 * s22 - s12 * s21)
        step1 = (s22 * r1 - s12 * r2) * inverse
        step2 = (s11 * r2 - s21 * r1) * inverse
        w11 = (s22 * p11 - s12 * p21) * inverse
        w12 = (s22 * p12 - s12 * p22) * inverse
        w21 = (s11 * p21 - s21 * p11) * inverse
        w22 = (s11 * p22 - s21 * p12) * inverse
        z1 = (s22 * d1 - s12 * d2) * inverse
        z2 = (s11 * d2 - s21 * d1) * inverse

        # f loses df/dY - df/dX for each step of the ball
        b11 = y11 - back1 * c_o * v_o
        b12 = y12 + back1 * s_o * v_o
        b21 = y21 - back2 * c_o * v_o
        b22 = y22 + back2 * s_o * v_o
        k11 = y11 - b11 * w11 - b12 * w21
        k12 = y12 - b11 * w12 - b12 * w22
        k21 = y21 - b21 * w11 - b22 * w21
        k22 = y22 - b21 * w12 - b22 * w22
        e1 = f1 - b11 * step1 - b12 * step2
        e2 = f2 - b21 * step1 - b22 * step2
        c1 = -m_i_c * c_i - b11 * z1 - b12 * z2
        c2 = m_i_c * s_i - b21 * z1 - b22 * z2

        # the friction's own share of the moment
        my1 = arm * (m_i_n * s_i + m_i_t * c_i)
        my2 = arm * (m_i_n * c_i - m_i_t * s_i)
        mx1 = arm * m_i_o * c_o * v_o - my1
        mx2 = -arm * m_i_o * s_o * v_o - my2
        h = e1 + arm * m_i + mx1 * step1 + mx2 * step2
        h1 = k11 + my1 + mx1 * w11 + mx2 * w21
        h2 = k12 + my2 + mx1 * w12 + mx2 * w22
        hc = c1 + arm * m_i_c + mx1 * z1 + mx2 * z2

        # the cage's balance
        ly1 = lag_n * s_i + lag_t * c_i
        ly2 = lag_n * c_i - lag_t * s_i
        lx1 = lag_o * c_o * v_o - ly1
        lx2 = -lag_o * s_o * v_o - ly2

        scale = max(max(q_i, q_o), f_c)
        return (
            (r1, r2),
            (step1, step2, w11, w12, w21, w22, z1, z2),
            (e1, e2, h),
            (k11, k12, k21, k22, h1, h2),
            scale,
            (q_i, c_i, c_o, max(delta_i, delta_o), s_i),
            (
                c1,
                c2,
                hc,
                lag + lx1 * step1 + lx2 * step2,
                ly1 + lx1 * w11 + lx2 * w21,
                ly2 + lx1 * w12 + lx2 * w22,
                lag_c + lx1 * z1 + lx2 * z2,
            ),
            (f1, f2, f1 + arm * m_i, lag, -lag_c),
        )

    return towards, contact, touching, inertia, polar, linearised


_, contact_fast, touching_fast, _, polar_fast, linearised_fast = _formulas(
    inline_fast, inline_fast(_short_polynomial)
)
_, _, touching_given, *_ = _formulas(inline_exact, inline_exact(_at_hand))
(
    towards_exact,
    contact_exact,
    touching_exact,
    inertia_exact,
    polar_exact,
    linearised_exact,
) = _formulas(inline_exact, stored_polynomial)
