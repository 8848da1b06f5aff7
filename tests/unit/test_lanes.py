"""The vector code beside the plain one: the same numbers, lane by lane, whatever the lane."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from rolamento.case import Case
from rolamento.numerics.compiled import Kernel
from rolamento.rows.ball import lanes, layout
from rolamento.rows.ball.accept import judge
from rolamento.rows.ball.blocks import (
    Batch,
    begin,
    fill_all,
    judge_blocks,
    put_displacement,
    room_for,
)
from rolamento.rows.ball.elimination import elimination
from rolamento.rows.ball.mirror import mirror
from rolamento.rows.ball.problem import Columns, apply_model, directions, ring_arms
from rolamento.rows.ball.run import BallResponse, solve_columns
from rolamento.rows.ball.settle import NEAR, settle
from rolamento.rows.ball.single import (
    OFF_GROOVE,
    OneCase,
    direction,
    groove,
    linearised,
    ring_around,
    static_ball,
)
from rolamento.status import CONVERGED, TOLERANCE
from rolamento.system import spread

BALLS = 16
N = layout.LANES
TOUCH = np.zeros(layout.TOUCH_ROWS * N)
"""Room for how a ball touches."""

Code = Callable[[Kernel[..., None]], Callable[..., None]]
AS_WRITTEN = pytest.param(lambda kernel: kernel.python, id="as written")
COMPILED = pytest.param(
    lambda kernel: kernel.compiled,
    id="compiled",
    marks=pytest.mark.sweep,  # for a quarter minute
)


@pytest.fixture
def filled(case_218: Case) -> tuple[np.ndarray, ...]:
    """Sixteen different duties in the lanes, under mixed raceway control."""
    rng = np.random.default_rng(3)
    p = np.repeat(spread(case_218).rows[0].row.p.whole(), N, axis=1)
    p[layout.INNER_SPEED] = rng.uniform(0.0, 1500.0, N)
    p[layout.OUTER_SPEED] = rng.uniform(-500.0, 500.0, N)
    p[layout.LAMBDA_INNER] = rng.integers(0, 2, N)
    p[layout.FREE : layout.FREE + 5] = rng.integers(0, 2, (5, N))
    p[layout.COS_FIRST], p[layout.SIN_FIRST] = np.cos(0.3), np.sin(0.3)
    azimuth = 2.0 * np.pi * np.arange(BALLS) / BALLS
    cosines, sines = np.cos(azimuth), np.sin(azimuth)
    control = rng.choice([-1.0, 1.0], (N, BALLS))
    u = rng.uniform(-1e-5, 4e-5, (N, 5))
    room, columns = room_for(BALLS), Columns(p[: layout.DUTY], p[layout.DUTY :])
    w, b = room.w, room.b
    batch = Batch(columns.duty, columns.bearing, control, cosines, sines, mirror(BALLS, 0))
    begin(room, batch)
    fill_all(room, batch, np.arange(N))
    for lane in range(N):
        put_displacement(w, lane, u[lane])
    return p, cosines, sines, control, u, w, b


def row(array: np.ndarray, first: int, lane: int, count: int = 1) -> np.ndarray:
    return array[[(first + i) * N + lane for i in range(count)]]


def ring_sum(
    p: np.ndarray, lane: int, cosines: np.ndarray, sines: np.ndarray, pieces: list[tuple]
) -> tuple[np.ndarray, np.ndarray]:
    """Reaction and stiffness of the ring from (force, stiffness) of its balls, by matrices."""
    reaction, matrix = np.zeros(5), np.zeros((5, 5))
    for cosine, sine, (force, k) in zip(cosines, sines, pieces, strict=True):
        c, s = direction(p, lane, cosine, sine)
        to_groove = np.array([[1, 0, 0, c, -s], [0, s, c, 0, 0]])
        f1, f2, h = force
        rows_ = np.array([[1, 0, 0], [0, s, 0], [0, c, 0], [0, 0, c], [0, 0, -s]])
        reaction += rows_ @ np.array([f1, f2, h])
        matrix += rows_ @ np.reshape(k, (3, 2)) @ to_groove
    return reaction, matrix


@pytest.mark.parametrize("code", [AS_WRITTEN, COMPILED])
def test_moving_balls(code: Code, filled: tuple[np.ndarray, ...]) -> None:
    p, cosines, sines, control, u, w, b = filled
    for ball in b:
        code(lanes.place_ball)(w, ball)
    code(lanes.reset_sums)(w)
    for ball in b:
        code(lanes.add_moving_ball)(w, ball, TOUCH, 1e-6)
    for lane in range(N):
        pieces, drives = [], []
        for j in range(BALLS):
            c, s = direction(p, lane, cosines[j], sines[j])
            a1, a2 = groove(p, lane, u[lane], c, s)
            x1, x2 = row(b[j], layout.POSITION, lane, 2)
            cage = float(row(w, layout.CAGE, lane)[0])
            _, follow, force, stiffness, _, _, drive, _ = linearised(
                p, lane, cage, control[lane, j], a1, a2, x1, x2
            )
            np.testing.assert_allclose(
                row(b[j], layout.FOLLOW, lane, 8), follow, rtol=1e-7, atol=1e-12
            )
            pieces.append((force, stiffness))
            drives.append((c, s, drive))
        reaction, matrix = ring_sum(p, lane, cosines, sines, pieces)
        scale = np.abs(matrix).max()
        np.testing.assert_allclose(
            row(w, layout.REACTION, lane, 5),
            reaction,
            rtol=1e-9,
            atol=1e-9 * np.abs(reaction).max(),
        )
        np.testing.assert_allclose(
            row(w, layout.MATRIX, lane, 25), matrix.ravel(), rtol=1e-8, atol=1e-9 * scale
        )
        lag = sum(drive[3] for _, _, drive in drives)
        by_ring = sum(
            np.array([d[4], s * d[5], c * d[5], c * d[4], -s * d[4]]) for c, s, d in drives
        )
        by_cage = sum(
            np.array([d[0], s * d[1], c * d[1], c * d[2], -s * d[2]]) for c, s, d in drives
        )
        for first, wanted in (
            (layout.LAG, np.array([lag])), (layout.LAG_BY_RING, by_ring), (layout.BY_CAGE, by_cage),
            (layout.LAG_BY_CAGE, np.array([sum(d[6] for _, _, d in drives)])),
        ):  # fmt: skip
            found = row(w, first, lane, len(wanted))
            size = max(np.abs(wanted).max(), 1e-12)
            np.testing.assert_allclose(found, wanted, rtol=1e-7, atol=1e-8 * size)


@pytest.mark.parametrize("code", [AS_WRITTEN, COMPILED])
def test_static_balls_and_the_ring_step(code: Code, filled: tuple[np.ndarray, ...]) -> None:
    p, cosines, sines, _, u, w, b = filled
    code(lanes.reset_sums)(w)
    for ball in b:
        code(lanes.add_static_ball)(w, ball)
    code(lanes.step_ring)(w)
    for lane in range(N):
        pieces = []
        for j in range(BALLS):
            c, s = direction(p, lane, cosines[j], sines[j])
            a1, a2 = groove(p, lane, u[lane], c, s)
            pieces.append(static_ball(p, lane, 1.0, a1, a2)[2:4])
        reaction, matrix = ring_sum(p, lane, cosines, sines, pieces)
        np.testing.assert_allclose(row(w, layout.REACTION, lane, 5), reaction, rtol=1e-9, atol=1e-6)
        free = row(w, layout.FREE, lane, 5) > 0.0
        step = np.zeros(5)
        unbalanced = row(w, layout.APPLIED, lane, 5) - reaction
        step[free] = np.linalg.solve(matrix[np.ix_(free, free)], unbalanced[free])
        longest = lanes.LONGEST_STEP * (p[layout.INNER_LENGTH, lane] + p[layout.OUTER_LENGTH, lane])
        step *= min(1.0, longest / max(np.abs(step[:3]).max(), 1e-300))
        np.testing.assert_allclose(
            row(w, layout.STEP, lane, 5), step, rtol=1e-7, atol=1e-9 * np.abs(step).max()
        )


@pytest.mark.parametrize("code", [AS_WRITTEN, COMPILED])
def test_balls_follow_the_ring(code: Code, filled: tuple[np.ndarray, ...]) -> None:
    p, cosines, sines, _, _, w, b = filled
    for ball in b:
        code(lanes.place_ball)(w, ball)
    code(lanes.reset_sums)(w)
    for ball in b:
        code(lanes.add_moving_ball)(w, ball, TOUCH, 1e-6)
    code(lanes.step_ring)(w)
    before = b.copy()
    for ball in b:
        code(lanes.follow_ring)(w, ball)
    for lane in range(N):
        dx, dy, dz, dp, dq = row(w, layout.STEP, lane, 5)
        for j in range(BALLS):
            c, s = direction(p, lane, cosines[j], sines[j])
            q1, q2, w11, w12, w21, w22 = row(before[j], layout.FOLLOW, lane, 6)
            da = np.array([dx + c * dp - s * dq, c * dz + s * dy])
            moved = row(b[j], layout.POSITION, lane, 2) - row(before[j], layout.POSITION, lane, 2)
            expected = np.array([q1, q2]) + np.array([[w11, w12], [w21, w22]]) @ da
            np.testing.assert_allclose(moved, expected, rtol=1e-9, atol=1e-15)


@np.errstate(all="ignore")  # what compiled code divides by zero stays where it is
def test_steps_of_its_own_bring_a_ball_to_rest(filled: tuple[np.ndarray, ...]) -> None:
    """Newton's method from where the formula puts a ball, by the plain code that settles one."""
    p, cosines, sines, control, u, w, b = filled
    for ball in b:
        lanes.place_ball(w, ball)
    stands = [b.copy()]
    for _ in range(5):
        for ball in b:
            lanes.settle_ball(w, ball, TOUCH)
        stands.append(b.copy())
    off = np.zeros((len(stands), N, BALLS))
    for lane in range(N):
        cage = row(w, layout.CAGE, lane)[0]
        for j in range(BALLS):
            a1, a2 = groove(p, lane, u[lane], *direction(p, lane, cosines[j], sines[j]))
            start = row(stands[-1][j], layout.POSITION, lane, 2)
            found, *place, _ = settle(
                p, lane, cage, control[lane, j], a1, a2, *start, NEAR, np.array([1e6])
            )
            assert found
            for k, balls in enumerate(stands):
                off[k, lane, j] = np.hypot(*(row(balls[j], layout.POSITION, lane, 2) - place))
    middle = np.median(off / p[layout.OUTER_LENGTH][:, np.newaxis], axis=(1, 2))
    assert middle[0] < 0.05
    assert middle[1] < 0.5 * middle[0]
    # on the way to the square
    assert middle[3] < middle[2] ** 1.4
    assert middle[4] < middle[3] ** 1.7
    assert np.mean(off[1] <= off[0]) > 0.9


@np.errstate(all="ignore")  # what compiled code divides by zero stays where it is
def test_a_ball_is_near_enough_where_its_step_leaves_next_to_nothing(
    filled: tuple[np.ndarray, ...],
) -> None:
    """Balls pushed out of their places, some too far."""
    p, cosines, sines, control, u, w, b = filled
    rng = np.random.default_rng(7)

    def residual(lane: int, j: int) -> float:
        a1, a2 = groove(p, lane, u[lane], *direction(p, lane, cosines[j], sines[j]))
        place, cage = row(b[j], layout.POSITION, lane, 2), row(w, layout.CAGE, lane)[0]
        missing, _, _, _, scale, *_ = linearised(
            p, lane, cage, control[lane, j], a1, a2, place[0], place[1]
        )
        return float(np.hypot(*missing) / scale)

    before, after = [], []
    for ball in b:
        lanes.place_ball(w, ball)
        for _ in range(8):
            lanes.settle_ball(w, ball, TOUCH)
    for j, ball in enumerate(b):
        push = p[layout.OUTER_LENGTH] * 10.0 ** rng.uniform(-8.0, -4.0, N)
        turn = rng.uniform(0.0, 2.0 * np.pi, N)
        ball[layout.POSITION * N : (layout.POSITION + 2) * N] += np.concatenate(
            [push * np.cos(turn), push * np.sin(turn)]
        )
        fault = w[layout.FAULT * N : (layout.FAULT + 1) * N]
        fault[:] = -np.inf
        lanes.add_moving_ball(w, ball, TOUCH, 1e-8)
        near = np.flatnonzero(fault <= 0.0)
        pushed = [residual(lane, j) for lane in range(N)]
        lanes.settle_ball(w, ball, TOUCH)
        before += [pushed[lane] for lane in near]
        after += [residual(lane, j) for lane in near]
    assert max(before) > 1e-6
    assert max(after) < 1e-9
    assert len(before) > 50


@pytest.mark.parametrize(
    "setting", ["combined", "light", "off the groove", "moments", "one bearing", "large balls"]
)
def test_judged_in_lanes_as_one_by_one(setting: str, case_218: Case) -> None:
    """The judgement in lanes has the bits of the plain one; what it does not accept has none."""
    rng = np.random.default_rng(5)
    cases, own = 3 * N + 5, case_218
    if setting == "large balls":  # whose stiffness takes more than seven coefficients
        own = own.replace(bearing=own.bearing.replace(ball_count=10, pitch_diameter=0.085))
    balls = own.bearing.ball_count
    p = np.repeat(spread(own).rows[0].row.p.whole(), cases, axis=1)
    p[layout.FREE : layout.FREE + 5] = 1.0
    p[layout.FREE + 3 : layout.FREE + 5] = setting == "moments"
    fx = 50.0 if setting == "light" else rng.uniform(5e3, 4e4, cases)
    p[layout.APPLIED : layout.APPLIED + 5] = 0.0
    p[layout.APPLIED], p[layout.APPLIED + 2] = fx, fx * rng.uniform(0.0, 0.8, cases)
    p[layout.IMPOSED : layout.IMPOSED + 5] = 0.0
    if setting == "off the groove":  # a heavy radial load presses tilted rings out of it
        p[layout.APPLIED + 2] = 2.5 * fx
        p[layout.IMPOSED + 3 : layout.IMPOSED + 5] = rng.uniform(-1.2e-4, 1.2e-4, (2, cases))
    p[layout.INNER_SPEED] = rng.uniform(600.0, 1500.0, cases)
    p[layout.OUTER_SPEED] = 0.0
    apply_model(p, own.model)
    control = np.ones((1, balls))
    columns = Columns(p[: layout.DUTY], p[layout.DUTY :])
    if setting in ("one bearing", "large balls"):
        columns = Columns(columns.duty, columns.bearing[:, :1].copy())
    assert (len(columns.bearing) > layout.COLUMN - layout.DUTY) == (setting == "large balls")
    solution = solve_columns(columns, control, balls, threads=1)
    (cosines, sines), order = directions(balls), np.arange(cases)

    together = BallResponse.empty(cases, balls)
    accepted = np.zeros(cases, np.bool_)
    ring = ring_around.python(balls, False)
    errors = np.zeros((balls, 2))
    batch = Batch(columns.duty, columns.bearing, control, cosines, sines, mirror(balls, 0))
    judge_blocks.compiled(
        batch, order, room_for(balls), solution.displacement, solution.cage, solution.position,
        together.force, together.stiffness, together.residual, accepted,
    )  # fmt: skip
    arms = ring_arms(p[:, 0])
    assert accepted.mean() > 0.9
    off = 0
    for case in np.flatnonzero(accepted):
        u, x = solution.displacement[case], solution.position[case].copy()
        on_groove = control[0].copy()
        for j in range(balls):
            a1, a2 = groove(p, case, u, *direction(p, case, cosines[j], sines[j]))
            if a2 <= x[j, 1] and abs(a1 - x[j, 0]) > p[layout.INNER_LENGTH, case]:
                on_groove[j] *= OFF_GROOVE
                off += 1
        one = OneCase(p, int(case), True, on_groove, cosines, sines, u, x, ring, errors)
        code, residual, _ = judge.compiled(one, solution.cage[case])
        assert code == CONVERGED
        assert residual == together.residual[case] <= TOLERANCE
        np.testing.assert_array_equal(arms * ring.reaction, together.force[case])
        stiffness = np.outer(arms, arms) * ring.matrix
        np.testing.assert_array_equal(stiffness, together.stiffness[case])
    assert (off > 0) == (setting == "off the groove")


def test_elimination_solves_every_lane() -> None:
    """As NumPy does; and where a pivot is next to nothing, it is as stiff as the least allowed."""
    rng = np.random.default_rng(2)
    solve = elimination(4, 5, 2, 25)
    w = rng.uniform(-1.0, 1.0, (30, N))
    w[2:22:6] += 4.0
    matrices = w[2:22].T.reshape(N, 4, 5)[:, :, :4].copy()
    expected = np.linalg.solve(matrices, w[25:29].T[:, :, np.newaxis])[:, :, 0]
    w[2:22, 0] = 0.0
    expected[0] = w[25:29, 0] / 0.5
    kept = w[[0, 1, 22, 23, 24, 29]].copy()
    flat = w.ravel()
    for lane in range(N):
        solve(flat, np.uintp(lane), 0.5)
    np.testing.assert_allclose(w[25:29].T, expected, rtol=1e-12)
    np.testing.assert_array_equal(w[[0, 1, 22, 23, 24, 29]], kept)
