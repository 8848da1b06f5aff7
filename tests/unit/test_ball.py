"""The ball's equations: exact derivatives, Newton's third law, and limits of the inertia."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from rolamento.case import Case
from rolamento.kinematics import BallMotion, ball_motion, grip, orbital_speed
from rolamento.rows.ball import layout
from rolamento.rows.ball.ball import contact_exact
from rolamento.rows.ball.single import inner_length, linearised
from rolamento.system import spread

CONTROLS = [(1.0, 0.0), (1.0, 1.0), (-1.0, 0.0)]
"""(sigma, lambda_i under outer control): outer, shared, inner."""


@pytest.fixture(params=CONTROLS, ids=["outer", "none", "inner"])
def control(request: pytest.FixtureRequest) -> tuple[float, float]:
    return request.param  # type: ignore[no-any-return]


@pytest.fixture
def parameters(case_218: Case, control: tuple[float, float]) -> np.ndarray:
    p = spread(case_218).rows[0].row.p.whole()
    p[layout.LAMBDA_INNER] = control[1]
    p[layout.OUTER_SPEED] = -300.0  # both rings turning
    return p


def places(p: np.ndarray, count: int = 20) -> np.ndarray:
    """(A1, A2, X1, X2) of loaded balls about the free position, as angles and approaches."""
    rng = np.random.default_rng(7)
    l_o, l_i = p[layout.OUTER_LENGTH, 0], p[layout.INNER_LENGTH, 0]
    alpha_o = rng.uniform(0.1, 0.7, count)
    alpha_i = alpha_o + rng.uniform(0.0, 0.6, count)
    reach_o = l_o + rng.uniform(1e-6, 3e-5, count)
    reach_i = l_i + rng.uniform(1e-6, 3e-5, count)
    x1, x2 = reach_o * np.sin(alpha_o), reach_o * np.cos(alpha_o)
    a1, a2 = x1 + reach_i * np.sin(alpha_i), x2 + reach_i * np.cos(alpha_i)
    return np.stack([a1, a2, x1, x2], axis=1)


CAGE = 420.0
"""rad/s, near the balls' own orbits but not the same."""


def at(p: np.ndarray, sigma: float, place: np.ndarray, cage: float = CAGE) -> tuple:
    return linearised(p, 0, cage, sigma, *place.tolist())


def moves(
    p: np.ndarray, sigma: float, a_i: float, a_o: float, q_i: float, cage: float
) -> tuple[BallMotion, float, float]:
    """A ball's motion as `kinematics` has it, how firmly it is held, and its own orbit."""
    rings = (
        a_i, a_o, p[layout.GAMMA, 0], p[layout.INNER_SPEED, 0], p[layout.OUTER_SPEED, 0],
        "inner" if sigma < 0 else "outer",
    )  # fmt: skip
    hold = float(grip(q_i, p[layout.HOLD_RATE, 0], p[layout.HOLD_OFFSET, 0]))
    own = float(orbital_speed(*rings))
    orbit = cage + p[layout.OWN_ORBIT, 0] * hold * (own - cage)
    return ball_motion(*rings, orbit=orbit, hold=hold), hold, own


def balance(p: np.ndarray, sigma: float, place: np.ndarray, cage: float) -> np.ndarray:
    """r1, r2, f1, f2, h and the cage's lag at a place, without any step, from `kinematics`."""
    a1, a2, x1, x2 = place
    inner = (inner_length(p, 0, 1.0), (p, layout.INNER_STIFFNESS, 0))
    outer = (p[layout.OUTER_LENGTH, 0], (p, layout.OUTER_STIFFNESS, 0))
    s_i, c_i, _, _, q_i, _, _ = contact_exact(a1 - x1, a2 - x2, *inner)
    s_o, c_o, _, _, q_o, _, _ = contact_exact(x1, x2, *outer)
    motion, hold, own = moves(p, sigma, np.arctan2(s_i, c_i), np.arctan2(s_o, c_o), q_i, cage)
    f_c = p[layout.CENTRIFUGAL, 0] * motion.orbital_speed**2
    t = p[layout.GYROSCOPIC, 0] * p[layout.GAMMA, 0]  # J / D
    t *= motion.ball_speed * motion.orbital_speed * np.sin(motion.attitude)
    share = p[layout.LAMBDA_INNER, 0] if sigma > 0 else 2.0
    m_i, m_o = share * t, (2.0 - share) * t
    f = np.array([q_i * s_i - m_i * c_i, q_i * c_i + m_i * s_i])
    g = np.array([q_o * s_o - m_o * c_o, q_o * c_o + m_o * s_o])
    r = f - g + np.array([0.0, f_c])
    return np.array([*r, *f, f[0] + p[layout.FRICTION_ARM, 0] * m_i, hold * q_i * (own - cage)])


@pytest.mark.parametrize("firm", [1e-3, 0.3, 30.0], ids=["held", "half held", "hardly held"])
def test_derivatives_equal_finite_differences(
    parameters: np.ndarray, control: tuple[float, float], firm: float
) -> None:
    """All of the elimination is rebuilt from differences of r, f, h and the lag."""
    sigma = control[0]
    parameters[layout.HOLD_RATE] /= firm
    for place in places(parameters):
        jacobian = np.empty((6, 5))
        for i, step in enumerate((1e-10, 1e-10, 1e-10, 1e-10, 1e-3)):
            change = np.zeros(5)
            change[i] = step
            ahead = balance(parameters, sigma, place + change[:4], CAGE + change[4])
            behind = balance(parameters, sigma, place - change[:4], CAGE - change[4])
            jacobian[:, i] = (ahead - behind) / (2.0 * step)
        by_a, by_x, by_cage = jacobian[:, :2], jacobian[:, 2:4], jacobian[:, 4]
        w = -np.linalg.solve(by_x[:2], by_a[:2])  # dX/dA with r = 0
        z = -np.linalg.solve(by_x[:2], by_cage[:2])
        now = balance(parameters, sigma, place, CAGE)
        q = -np.linalg.solve(by_x[:2], now[:2])
        stiffness = by_a[2:] + by_x[2:] @ w
        drive = by_cage[2:] + by_x[2:] @ z
        force = now[2:] + by_x[2:] @ q

        residual, follow, ring_force, ring_stiffness, _, _, cage, before = at(
            parameters, sigma, place
        )
        np.testing.assert_allclose(residual, now[:2], rtol=1e-9, atol=1e-7)
        np.testing.assert_allclose(before[:4], now[2:], rtol=1e-9, atol=1e-7)
        np.testing.assert_allclose(follow[:2], q, rtol=1e-5, atol=1e-11)
        np.testing.assert_allclose(
            np.reshape(follow[2:6], (2, 2)), w, rtol=1e-5, atol=1e-5 * np.abs(w).max()
        )
        np.testing.assert_allclose(follow[6:], z, rtol=1e-4, atol=1e-5 * np.abs(z).max() + 1e-15)
        np.testing.assert_allclose(ring_force, force[:3], rtol=1e-5, atol=1e-4)
        np.testing.assert_allclose(cage[3], force[3], rtol=1e-4, atol=1e-4 * abs(before[4]))
        np.testing.assert_allclose(
            np.reshape(ring_stiffness, (3, 2)),
            stiffness[:3],
            rtol=1e-4,
            atol=1e-5 * np.abs(stiffness[:3]).max(),
        )
        scale = np.abs(stiffness[3]).max()
        np.testing.assert_allclose(cage[4:6], stiffness[3], rtol=1e-4, atol=1e-5 * scale)
        np.testing.assert_allclose([*cage[:3], cage[6]], drive, rtol=1e-4, atol=1e-6)


def test_a_contact_has_a_bottom_and_two_flanks(parameters: np.ndarray) -> None:
    """No force from a groove that is open upward; beyond 90° a flank presses along the axis."""
    length, stiffness = inner_length(parameters, 0, 1.0), (parameters, layout.INNER_STIFFNESS, 0)
    for y2 in (-0.1, -1.0, -3.0):
        for y1 in (-0.9, 0.0, 0.9):
            assert contact_exact(y1 * length, y2 * length, length, stiffness)[4] == 0.0
    s, c, _, delta, q, _, _ = contact_exact(1.01 * length, -length, length, stiffness)
    assert (s, c) == (1.0, 0.0)
    assert delta == pytest.approx(0.01 * length)
    assert q > 0.0
    loads = [contact_exact(1.001 * length, y * length, length, stiffness)[4] for y in (1e-9, -1e-9)]
    assert loads[0] == pytest.approx(loads[1], rel=1e-6)


def test_newton_settles_a_ball_quadratically(
    parameters: np.ndarray, control: tuple[float, float]
) -> None:
    """Steps with the groove held still: each squares the error of the one before."""
    sigma = control[0]
    place = places(parameters)[0]
    errors = []
    for _ in range(7):
        residual, follow, _, _, scale, *_ = at(parameters, sigma, place)
        errors.append(np.hypot(*residual) / scale)
        place = place + np.array([0.0, 0.0, follow[0], follow[1]])
    assert errors[-1] < 1e-12
    order = [np.log(b) / np.log(a) for a, b in pairwise(errors) if 1e-7 < a < 1e-2]
    assert order
    assert min(order) > 1.7
