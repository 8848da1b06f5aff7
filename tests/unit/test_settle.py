"""One ball's place: the same from every start, by Newton or by brackets, or plainly free."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.case import Case
from rolamento.rows.ball import layout
from rolamento.rows.ball.abreast import fill
from rolamento.rows.ball.problem import directions
from rolamento.rows.ball.robust import _settle_balls
from rolamento.rows.ball.settle import NEAR, _bracketed, free_ball, in_place, settle
from rolamento.rows.ball.single import OneCase, linearised, ring_around
from rolamento.system import spread


@pytest.fixture(params=[50.0, 1000.0, 1500.0], ids=lambda speed: f"{speed:.0f} rad/s")
def parameters(request: pytest.FixtureRequest, case_218: Case) -> np.ndarray:
    p = spread(case_218).rows[0].row.p.whole()
    p[layout.INNER_SPEED] = request.param
    return p


def cage(p: np.ndarray) -> float:
    return float(p[layout.NOMINAL_ORBIT, 0])


def work() -> np.ndarray:
    return np.full(1, 1e6)


def grooves(p: np.ndarray, count: int = 40) -> np.ndarray:
    """Places of the inner groove's centre, from far too near to deeply pressed."""
    rng = np.random.default_rng(11)
    reach = p[layout.OUTER_LENGTH, 0] + p[layout.INNER_LENGTH, 0] + rng.uniform(-2e-4, 4e-5, count)
    alpha = rng.uniform(0.05, 1.2, count)
    return np.stack([reach * np.sin(alpha), reach * np.cos(alpha)], axis=1)


@pytest.mark.thirds
def test_one_place_from_every_start(parameters: np.ndarray) -> None:
    l_o = parameters[layout.OUTER_LENGTH, 0]
    for a1, a2 in grooves(parameters):
        places = []
        for part in (0.3, 0.5, 0.7):
            found, x1, x2, _ = settle.compiled(
                parameters, 0, cage(parameters), 1.0, a1, a2, part * a1, part * a2, NEAR, work()
            )
            assert found
            assert in_place.compiled(parameters, 0, a1, x1, x2)
            places.append((x1, x2))
        np.testing.assert_allclose(places[1:], [places[0]] * 2, atol=1e-8 * l_o)
        residual, _, _, _, scale, *_ = linearised.compiled(
            parameters, 0, cage(parameters), 1.0, a1, a2, *places[0]
        )
        assert np.hypot(*residual) <= 1e-9 * scale


def test_brackets_agree_with_newton(parameters: np.ndarray) -> None:
    l_o = parameters[layout.OUTER_LENGTH, 0]
    for a1, a2 in grooves(parameters):
        if free_ball.compiled(parameters, 0, cage(parameters), 1.0, a1, a2)[0]:
            continue
        found, x1, x2 = _bracketed.compiled(parameters, 0, cage(parameters), 1.0, a1, a2, work())
        assert found
        _, y1, y2, _ = settle.compiled(
            parameters, 0, cage(parameters), 1.0, a1, a2, 0.5 * a1, 0.5 * a2, NEAR, work()
        )
        np.testing.assert_allclose([x1, x2], [y1, y2], atol=1e-8 * l_o)


def test_a_ball_on_the_other_side_is_the_mirror_image(parameters: np.ndarray) -> None:
    for a1, a2 in grooves(parameters):
        _, x1, x2, _ = settle.compiled(
            parameters, 0, cage(parameters), 1.0, a1, a2, 0.5 * a1, 0.5 * a2, NEAR, work()
        )
        _, y1, y2, _ = settle.compiled(
            parameters, 0, cage(parameters), 1.0, -a1, a2, -0.5 * a1, 0.5 * a2, NEAR, work()
        )
        np.testing.assert_allclose([-y1, y2], [x1, x2], rtol=1e-9, atol=1e-12)


def test_a_free_ball_carries_only_its_centrifugal_force(parameters: np.ndarray) -> None:
    free, x1, x2 = free_ball.compiled(parameters, 0, cage(parameters), 1.0, 1e-5, 3e-4)
    assert free
    assert x1 == 0.0
    residual, _, force, _, scale, touch, *_ = linearised.compiled(
        parameters, 0, cage(parameters), 1.0, 1e-5, 3e-4, x1, x2
    )
    assert touch[0] == 0.0
    assert force[:2] == (0.0, 0.0)
    assert np.hypot(*residual) <= 1e-9 * scale
    assert scale == pytest.approx(parameters[layout.CENTRIFUGAL, 0] * cage(parameters) ** 2)


def test_balls_settle_abreast_as_one_by_one(parameters: np.ndarray) -> None:
    balls = 21  # more than there are lanes, and some of these are pressed out of reach of Newton
    sums = []
    for abreast in (False, True):
        one = OneCase(
            parameters, 0, True, np.ones(balls), *directions(balls), np.zeros(5),
            np.zeros((balls, 2)), ring_around.compiled(balls, abreast), np.zeros((balls, 2)),
        )  # fmt: skip
        one.u[:] = 2e-5, 1e-5, 6e-5, 3e-5, -2e-5
        one.x[:, 1] = parameters[layout.OUTER_LENGTH, 0]
        one.ring.work[0] = 1e6
        if abreast:
            fill.compiled(one)
        settled, greatest = _settle_balls.compiled(one, cage(parameters), NEAR)
        assert settled
        ring = one.ring
        sums.append([
            np.ravel(part)
            for part in (one.x, ring.reaction, ring.matrix, ring.by_cage, ring.lag, ring.pull,
                         ring.lag_by_ring, ring.lag_by_cage, ring.load, ring.follow, greatest)
        ])  # fmt: skip
    for plain, lanes in zip(*sums, strict=True):
        np.testing.assert_allclose(lanes, plain, rtol=1e-11, atol=1e-11 * np.abs(plain).max())
