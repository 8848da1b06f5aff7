"""The ball's equations: exact derivatives, Newton's third law, and limits of the inertia."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from rolamento.case import Case
from rolamento.equilibrium import rows
from rolamento.equilibrium.problem import case_parameters
from rolamento.equilibrium.single import contacts, linearised
from rolamento.kinematics import ball_motion

CONTROLS = [(1.0, 0.0), (1.0, 1.0), (-1.0, 0.0)]
"""(sigma, lambda_i under outer control): outer, shared, inner."""


@pytest.fixture(params=CONTROLS, ids=["outer", "none", "inner"])
def control(request: pytest.FixtureRequest) -> tuple[float, float]:
    return request.param  # type: ignore[no-any-return]


@pytest.fixture
def parameters(case_218: Case, control: tuple[float, float]) -> np.ndarray:
    p = case_parameters(case_218)[:, np.newaxis].copy()
    p[rows.LAMBDA_INNER] = control[1]
    p[rows.OUTER_SPEED] = -300.0  # both rings turning
    return p


def places(p: np.ndarray, count: int = 20) -> np.ndarray:
    """(A1, A2, X1, X2) of loaded balls about the free position, as angles and approaches."""
    rng = np.random.default_rng(7)
    l_o, l_i = p[rows.OUTER_LENGTH, 0], p[rows.INNER_LENGTH, 0]
    alpha_o = rng.uniform(0.1, 0.7, count)
    alpha_i = alpha_o + rng.uniform(0.0, 0.6, count)
    reach_o = l_o + rng.uniform(1e-6, 3e-5, count)
    reach_i = l_i + rng.uniform(1e-6, 3e-5, count)
    x1, x2 = reach_o * np.sin(alpha_o), reach_o * np.cos(alpha_o)
    a1, a2 = x1 + reach_i * np.sin(alpha_i), x2 + reach_i * np.cos(alpha_i)
    return np.stack([a1, a2, x1, x2], axis=1)


def at(p: np.ndarray, sigma: float, place: np.ndarray) -> tuple:
    return linearised(p, 0, sigma, *place.tolist())


def residual_and_force(p: np.ndarray, sigma: float, place: np.ndarray) -> np.ndarray:
    """r1, r2, f1, f2, h at a place, without any step: from the contacts alone."""
    s_i, c_i, _, q_i, s_o, c_o, _, q_o, f_c, t = contacts(p, 0, sigma, *place.tolist())
    lambda_i = p[rows.LAMBDA_INNER, 0] if sigma > 0 else 2.0
    lambda_o = 2.0 - lambda_i
    f = np.array([q_i * s_i - lambda_i * t * c_i, q_i * c_i + lambda_i * t * s_i])
    g = np.array([q_o * s_o - lambda_o * t * c_o, q_o * c_o + lambda_o * t * s_o])
    r = f - g + np.array([0.0, f_c])
    return np.array([*r, *f, f[0] + p[rows.FRICTION_ARM, 0] * lambda_i * t])


def test_derivatives_equal_finite_differences(
    parameters: np.ndarray, control: tuple[float, float]
) -> None:
    """S, P, k and h of the elimination are rebuilt from differences of r, f and h."""
    sigma = control[0]
    step = 1e-10
    for place in places(parameters):
        jacobian = np.empty((5, 4))
        for i in range(4):
            ahead, behind = place.copy(), place.copy()
            ahead[i] += step
            behind[i] -= step
            difference = residual_and_force(parameters, sigma, ahead) - residual_and_force(
                parameters, sigma, behind
            )
            jacobian[:, i] = difference / (2.0 * step)
        by_a, by_x = jacobian[:, :2], jacobian[:, 2:]
        w = -np.linalg.solve(by_x[:2], by_a[:2])  # dX/dA with r = 0
        now = residual_and_force(parameters, sigma, place)
        q = -np.linalg.solve(by_x[:2], now[:2])
        stiffness = by_a[2:] + by_x[2:] @ w
        force = now[2:] + by_x[2:] @ q

        residual, follow, ring_force, ring_stiffness, _, _ = at(parameters, sigma, place)
        np.testing.assert_allclose(residual, now[:2], rtol=1e-9, atol=1e-7)
        np.testing.assert_allclose(follow[:2], q, rtol=1e-5, atol=1e-11)
        np.testing.assert_allclose(
            np.reshape(follow[2:], (2, 2)), w, rtol=1e-5, atol=1e-5 * np.abs(w).max()
        )
        np.testing.assert_allclose(ring_force, force, rtol=1e-5, atol=1e-4)
        np.testing.assert_allclose(
            np.reshape(ring_stiffness, (3, 2)),
            stiffness,
            rtol=1e-4,
            atol=1e-5 * np.abs(stiffness).max(),
        )


def test_inertia_is_that_of_the_kinematics(
    parameters: np.ndarray, control: tuple[float, float], case_218: Case
) -> None:
    """F_c and T = M_g/D of the kernel against the speeds worked out in `kinematics`."""
    bearing = case_218.bearing
    sigma = control[0]
    mass = np.pi / 6.0 * bearing.ball_material.density * bearing.ball_diameter**3
    for place in places(parameters):
        s_i, c_i, _, _, s_o, c_o, _, _, f_c, t = contacts(parameters, 0, sigma, *place.tolist())
        motion = ball_motion(
            np.arctan2(s_i, c_i),
            np.arctan2(s_o, c_o),
            bearing.ball_diameter / bearing.pitch_diameter,
            parameters[rows.INNER_SPEED, 0],
            parameters[rows.OUTER_SPEED, 0],
            "inner" if sigma < 0 else "outer",
        )
        moment = (
            mass * bearing.ball_diameter**2 / 10.0
            * motion.ball_speed * motion.orbital_speed * np.sin(motion.attitude)
        )  # fmt: skip
        assert f_c == pytest.approx(0.5 * mass * bearing.pitch_diameter * motion.orbital_speed**2)
        assert t == pytest.approx(moment / bearing.ball_diameter, rel=1e-9)


def test_newton_settles_a_ball_quadratically(
    parameters: np.ndarray, control: tuple[float, float]
) -> None:
    """Steps with the groove held still: each squares the error of the one before."""
    sigma = control[0]
    place = places(parameters)[0]
    errors = []
    for _ in range(7):
        residual, follow, _, _, scale, _ = at(parameters, sigma, place)
        errors.append(np.hypot(*residual) / scale)
        place = place + np.array([0.0, 0.0, follow[0], follow[1]])
    assert errors[-1] < 1e-12
    order = [np.log(b) / np.log(a) for a, b in pairwise(errors) if 1e-7 < a < 1e-2]
    assert order
    assert min(order) > 1.7
