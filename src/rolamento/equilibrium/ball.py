"""One ball between two grooves: its forces, its residual, and their exact derivatives.

Everything happens in the ball's radial plane, in coordinates (x, r) from the centre of
curvature of the outer groove. The centre of the inner groove is at A, the ball's at X, and
Y = A - X, so that the two contacts are alike: each is a spring along its own vector (X for the
outer, Y for the inner), with the groove's offset L as its free length.

With the contact angle's unit vectors n = (sin a, cos a) and t = (cos a, -sin a), and
T = M_g / D the gyroscopic moment over the ball diameter,

    the inner ring presses on the ball with   f = Q_i n_i - lambda_i T t_i
    the ball presses on the outer ring with   g = Q_o n_o - lambda_o T t_o

and the ball is in equilibrium when r = f - g + F_c (0, 1) = 0 (Radaelli 2013, eqs. 76-77; the
gyroscopic moment is signed). The moment about the ring's axis plane has the arm of the groove's
centre; the friction lambda_i T acts f_i D further out, at the groove's surface: divided by the
arm, the moment is h = f_1 + (f_i D / R_i) lambda_i T.

The formulas are written for scalars and without branches, so that the same text compiles to
vector code over many cases (`_fast`) and to the plain form that checks it (`_exact`).
"""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt
from typing import Any

from rolamento.equilibrium.types import Coefficients, Four, Linearised, Motion, Race, Seven, Six
from rolamento.kinematics import LEAST_COSINE
from rolamento.numerics.compiled import inline_exact, inline_fast


def _formulas(inline: Callable[..., Any]) -> tuple[Any, ...]:
    """Build the formulas of a ball with the given way to compile them."""

    @inline
    def contact(y1: float, y2: float, free_length: float, stiffness: Coefficients) -> Seven:
        """A Hertz spring along y: sin a, cos a, 1/|y|, approach, Q, dQ/d|y|, dQ/da.

        K is a polynomial in cos a; Horner's scheme gives its slope along with it.
        """
        length = sqrt(y1 * y1 + y2 * y2)
        inverse = 1.0 / length
        s = y1 * inverse
        c = y2 * inverse
        delta = max(length - free_length, 0.0)
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
        root = sqrt(delta)
        power = root * delta
        return s, c, inverse, delta, value * power, 1.5 * value * root, -s * slope * power

    @inline
    def inertia(
        s_i: float,
        c_i: float,
        s_o: float,
        c_o: float,
        gamma: float,
        c_f: float,
        c_g: float,
        inner_speed: float,
        outer_speed: float,
        sigma: float,
    ) -> Six:
        """F_c and T = M_g/D, with their derivatives by the two contact angles.

        sigma is +1 when the outer race controls the ball and -1 when the inner race does; the
        other race is the slave. c_f = m d_m / 2; c_g = J / (gamma' D) = m d_m / 10.
        """
        outer = sigma > 0.0
        s_slave = s_i if outer else s_o
        c_slave = c_i if outer else c_o
        s_control = s_o if outer else s_i
        c_control = c_o if outer else c_i
        control_speed = outer_speed if outer else inner_speed
        relative = inner_speed - outer_speed

        cosine = c_i * c_o + s_i * s_o
        sine = (s_i * c_o - c_i * s_o) * sigma if cosine > LEAST_COSINE else 0.0
        inverse = 1.0 / (1.0 + max(cosine, LEAST_COSINE))
        w = (1.0 - sigma * gamma * c_slave) * inverse
        w_slave = (sigma * gamma * s_slave + w * sine) * inverse
        w_control = -w * sine * inverse

        speed = control_speed + sigma * relative * w
        force = c_f * speed * speed
        force_w = 2.0 * c_f * speed * sigma * relative
        g = -c_g * relative
        moment = g * speed * w * s_control
        moment_w = g * s_control * (speed + sigma * relative * w)
        moment_slave = moment_w * w_slave
        moment_control = moment_w * w_control + g * speed * w * c_control

        force_i = force_w * (w_slave if outer else w_control)
        force_o = force_w * (w_control if outer else w_slave)
        moment_i = moment_slave if outer else moment_control
        moment_o = moment_control if outer else moment_slave
        return force, force_i, force_o, moment, moment_i, moment_o

    @inline
    def polar(s: float, c: float, nn: float, nt: float, tt: float) -> Four:
        """The matrix nn n n' + nt n t' + tt t t', by rows."""
        return (
            nn * s * s + nt * s * c + tt * c * c,
            (nn - tt) * s * c - nt * s * s,
            (nn - tt) * s * c + nt * c * c,
            nn * c * c - nt * s * c + tt * s * s,
        )

    @inline
    def linearised(
        a1: float,
        a2: float,
        x1: float,
        x2: float,
        inner: Race,
        outer: Race,
        motion: Motion,
        sigma: float,
        lambda_i: float,
    ) -> Linearised:
        """The ball at X with the inner groove at A, and the ring's view of it.

        inner, outer: (free length L, seven coefficients of K); motion: (gamma', c_f, c_g,
        inner speed, outer speed, f_i D / R_i). Returns

        - the residual r,
        - the Newton step dX = q + W dA with which the ball follows the groove,
        - the force f and moment h that the ball asks of the ring, after the step q,
        - their derivatives by A with the ball following: k (2 x 2) and h (2),
        - the scale of the ball's own loads, the greatest of Q_i, Q_o and F_c,
        - how it touches the rings: Q_i, sin a_i, the greater approach.
        """
        gamma, c_f, c_g, inner_speed, outer_speed, arm = motion
        lambda_o = 2.0 - lambda_i
        s_o, c_o, v_o, delta_o, q_o, kn_o, ka_o = contact(x1, x2, outer[0], outer[1])
        s_i, c_i, v_i, delta_i, q_i, kn_i, ka_i = contact(a1 - x1, a2 - x2, inner[0], inner[1])
        f_c, f_c_i, f_c_o, t, t_i, t_o = inertia(
            s_i, c_i, s_o, c_o, gamma, c_f, c_g, inner_speed, outer_speed, sigma
        )

        f1 = q_i * s_i - lambda_i * t * c_i
        f2 = q_i * c_i + lambda_i * t * s_i
        r1 = f1 - q_o * s_o + lambda_o * t * c_o
        r2 = f2 - q_o * c_o - lambda_o * t * s_o + f_c

        # df/dY and dg/dX, the turning of the friction with its own angle included
        y11, y12, y21, y22 = polar(
            s_i, c_i, kn_i, (ka_i + lambda_i * t) * v_i, (q_i - lambda_i * t_i) * v_i
        )
        g11, g12, g21, g22 = polar(
            s_o, c_o, kn_o, (ka_o + lambda_o * t) * v_o, (q_o - lambda_o * t_o) * v_o
        )
        # what the inner angle does to the outer side, and the outer angle to the inner side
        cross1 = lambda_o * t_i * c_o
        cross2 = f_c_i - lambda_o * t_i * s_o
        back1 = -lambda_i * t_o * c_i
        back2 = lambda_i * t_o * s_i
        p11 = y11 + cross1 * c_i * v_i
        p12 = y12 - cross1 * s_i * v_i
        p21 = y21 + cross2 * c_i * v_i
        p22 = y22 - cross2 * s_i * v_i
        s11 = p11 + g11 - back1 * c_o * v_o
        s12 = p12 + g12 + back1 * s_o * v_o
        s21 = p21 + g21 - (back2 + f_c_o) * c_o * v_o
        s22 = p22 + g22 + (back2 + f_c_o) * s_o * v_o

        inverse = 1.0 / (s11 * s22 - s12 * s21)
        step1 = (s22 * r1 - s12 * r2) * inverse
        step2 = (s11 * r2 - s21 * r1) * inverse
        w11 = (s22 * p11 - s12 * p21) * inverse
        w12 = (s22 * p12 - s12 * p22) * inverse
        w21 = (s11 * p21 - s21 * p11) * inverse
        w22 = (s11 * p22 - s21 * p12) * inverse

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

        # the friction's own share of the moment
        m = arm * lambda_i
        my1 = m * t_i * c_i * v_i
        my2 = -m * t_i * s_i * v_i
        d1 = m * t_o * c_o * v_o - my1
        d2 = -m * t_o * s_o * v_o - my2
        h = e1 + m * t + d1 * step1 + d2 * step2
        h1 = k11 + my1 + d1 * w11 + d2 * w21
        h2 = k12 + my2 + d1 * w12 + d2 * w22

        scale = max(max(q_i, q_o), f_c)
        return (
            (r1, r2),
            (step1, step2, w11, w12, w21, w22),
            (e1, e2, h),
            (k11, k12, k21, k22, h1, h2),
            scale,
            (q_i, s_i, max(delta_i, delta_o)),
        )

    return contact, inertia, polar, linearised


contact_fast, inertia_fast, polar_fast, linearised_fast = _formulas(inline_fast)
contact_exact, inertia_exact, polar_exact, linearised_exact = _formulas(inline_exact)
