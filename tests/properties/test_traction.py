"""Laws that balls controlled by friction alone keep: balance, power, symmetry, limits."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.one_case import solve_one

from rolamento import Bearing, Case, Displacement, Duty, Load, Lubricant, Model
from rolamento.friction.jones_full import jones_full
from rolamento.friction.slip import BallVelocity, Patch, relative_motion
from rolamento.friction.traction import ContactFriction, contact_friction, ellipse_mesh
from rolamento.rows.ball import layout
from rolamento.rows.ball.problem import ring_arms
from rolamento.rows.ball.rolling import Rolling
from rolamento.rows.ball.traction import solve as traction
from rolamento.solution import solve
from rolamento.solved import Solved

Floats = NDArray[np.float64]
RPM = np.pi / 30.0
MU = 0.07
GEOMETRY: dict[str, Any] = {
    "ball_count": 16,
    "ball_diameter": "22.23 mm",
    "pitch_diameter": "125.26 mm",
    "contact_angle": "40 deg",
    "inner_conformity": 0.5232,
    "outer_conformity": 0.5232,
}
ANGULAR = Bearing(**GEOMETRY)
HYBRID = Bearing(**GEOMETRY, ball_material="Si3N4")
DEEP_GROOVE = Bearing(
    ball_count=9,
    ball_diameter="12.7 mm",
    pitch_diameter="65 mm",
    diametral_clearance="0.015 mm",
    inner_conformity=0.515,
    outer_conformity=0.53,
)


def case_of(
    bearing: Bearing = ANGULAR,
    *,
    inner: float = 10_000.0,
    outer: float = 0.0,
    mu: float = MU,
    displacement: dict[str, float] | None = None,
    model: dict[str, Any] | None = None,
    **load: float,
) -> Case:
    """Speeds in rpm, loads in N and N·m."""
    return Case(
        bearing=bearing,
        duty=Duty(
            inner_speed=inner * RPM,
            outer_speed=outer * RPM,
            load=Load(**load),
            displacement=Displacement(**(displacement or {})),
        ),
        model=Model(**{"raceway_control": "friction", "mesh": "coarse", **(model or {})}),
        lubricant=Lubricant(kind="dry", friction_coefficient=mu),
    )


CASES = {
    "thrust": case_of(fx=20e3),
    "combined": case_of(fx=20e3, fz=15e3),
    "free tilts": case_of(fx=20e3, fy=3e3, fz=8e3, my=5.0, mz=-20.0),
    "held": case_of(fz=8e3, displacement={"x": 2e-5}),
    "partly loaded": case_of(fx=5e3, fz=10e3),
    "outer turns": case_of(inner=0.0, outer=8e3, fx=12e3, fz=3e3),
    "against each other": case_of(inner=6e3, outer=-2e3, fx=12e3, fz=3e3),
    "cage held back": case_of(fx=20e3, fz=5e3, model={"cage_drag": 0.5}),
    "deep groove": case_of(DEEP_GROOVE, fz=3e3),
    "deep groove, pushed back": case_of(DEEP_GROOVE, fx=-1e3, fz=3e3),
    "ceramic": case_of(HYBRID, inner=14e3, fx=10e3, fz=4e3),
    "no centrifugal force": case_of(
        DEEP_GROOVE, fz=3e3, fx=300.0, model={"centrifugal_force": False}
    ),
    "no gyroscopic moment": case_of(fx=20e3, fz=5e3, model={"gyroscopic_moment": False}),
}


@pytest.fixture(scope="module", params=list(CASES))
def solved(request: pytest.FixtureRequest) -> tuple[Case, Solved, Rolling]:
    case = CASES[request.param]
    batch = solve(case)
    assert batch.converged.all()
    rolling = batch.answer.motion
    assert rolling is not None
    return case, batch, rolling


def rolling_of(state: SimpleNamespace) -> Any:
    assert state.status.converged
    assert state.rolling is not None
    return state.rolling


def directions(batch: Solved) -> tuple[Floats, Floats]:
    """Outward and along the orbit at every ball of the first case, (balls, 3) in (x, y, z)."""
    azimuth = batch.elements.azimuth[0]
    zero, c, s = np.zeros_like(azimuth), np.cos(azimuth), np.sin(azimuth)
    return np.stack([zero, s, c], axis=1), np.stack([zero, c, -s], axis=1)


def in_space(batch: Solved, parts: Floats, order: tuple[int, int, int]) -> Floats:
    """Vectors from their parts along x, outward and along the orbit, which stand in that order."""
    outward, along = directions(batch)
    x, out, orbit = (parts[:, i : i + 1] for i in order)
    return np.concatenate([x, np.zeros_like(x), np.zeros_like(x)], axis=1) + (
        out * outward + orbit * along
    )


def race_loads(batch: Solved, rolling: Rolling, race: str) -> tuple[Floats, Floats]:
    """Forces and moments of a race on the balls of the first case, in space."""
    parts = (rolling.inner if race == "inner" else rolling.outer)[0]
    return in_space(batch, parts, (0, 1, 2)), in_space(batch, parts[:, 3:], (0, 2, 1))


def test_every_ball_is_in_balance(solved: tuple[Case, Solved, Rolling]) -> None:
    """Forces with F_c, but for what the cage bears along the orbit; moments with J ω_m x̂ × ω_b."""
    case, batch, rolling = solved
    table = batch
    force_i, moment_i = race_loads(batch, rolling, "inner")
    force_o, moment_o = race_loads(batch, rolling, "outer")
    outward, along = directions(batch)
    total = force_i + force_o + table.elements.centrifugal_force[0][:, None] * outward
    total -= np.sum(total * along, axis=1)[:, None] * along
    scale = np.maximum(table.outer.load[0], 1e-6 * table.outer.load.max())
    assert (np.linalg.norm(total, axis=1) <= 1e-8 * scale).all()

    p = batch.answer.p.whole()[:, 0]
    inertia = p[layout.GYROSCOPIC] * p[layout.GAMMA] * p[layout.BALL_DIAMETER]
    omega = in_space(batch, np.nan_to_num(rolling.angular_velocity[0]), (0, 2, 1))
    turning = inertia * np.cross([rolling.cage_speed[0], 0.0, 0.0], omega)
    left = np.linalg.norm(moment_i + moment_o - turning, axis=1)
    grip = MU * scale * case.bearing.ball_diameter
    assert (left <= 1e-8 * grip).all()
    gyroscopic = np.nan_to_num(table.elements.gyroscopic_moment[0])
    size = np.linalg.norm(turning, axis=1)
    # the moment that a result shows is the part about the orbit's direction
    np.testing.assert_allclose(
        np.abs(gyroscopic), np.abs(np.sum(turning * along, axis=1)),
        rtol=1e-9, atol=1e-9 * max(size.max(), 1e-12),
    )  # fmt: skip


def test_attitude_and_yaw_are_harriss(solved: tuple[Case, Solved, Rolling]) -> None:
    """They give back the ball's velocity seen from the cage, along x, the azimuth and outward."""
    _, batch, rolling = solved
    table = batch
    motion, yaw = table.elements, table.elements.yaw[0]
    beta, speed = motion.attitude[0], motion.ball_speed[0]
    seen = rolling.angular_velocity[0] - [rolling.cage_speed[0], 0.0, 0.0]
    axis = np.stack([np.cos(beta) * np.cos(yaw), np.cos(beta) * np.sin(yaw), -np.sin(beta)], axis=1)
    np.testing.assert_allclose(
        speed[:, None] * axis, seen, atol=1e-9 * np.nanmax(np.abs(speed)), equal_nan=True
    )
    known = np.isfinite(yaw)
    assert known.any()
    np.testing.assert_allclose(
        np.tan(yaw[known]), seen[known, 1] / seen[known, 0], rtol=1e-9, atol=1e-12
    )


def test_ring_is_in_balance(solved: tuple[Case, Solved, Rolling]) -> None:
    """Sum of the balls' forces, friction included, and of their moments about the ring's centre."""
    case, batch, rolling = solved
    table, p = batch, batch.answer.p
    force, moment = race_loads(batch, rolling, "inner")
    outward, _ = directions(batch)
    reach = np.hypot(*_groove_to_ball(batch))
    angle = table.inner.contact_angle[0]
    arm = (p[layout.ARM][0] - reach * np.cos(angle))[:, None] * outward
    arm[:, 0] = -reach * np.sin(angle)
    turning = (np.cross(arm, force) + moment).sum(axis=0)
    found = np.append(force.sum(axis=0), turning[1:])
    arms = ring_arms(p)[:, 0]
    scale = max(np.abs(batch.load.array[0] / arms).max(), table.inner.load.max())
    np.testing.assert_allclose(found / arms, batch.load.array[0] / arms, rtol=0, atol=1e-8 * scale)
    free = np.array(case.duty.free)
    np.testing.assert_array_equal(batch.load.array[0][free], np.array(case.duty.applied_load)[free])


def _groove_to_ball(batch: Solved) -> tuple[Floats, Floats]:
    """From the ball's centre to the inner groove's, along x and outward."""
    answer = batch.answer
    p, u, psi = answer.p.whole()[:, 0], answer.displacement[0], batch.elements.azimuth[0]
    axial = p[layout.AXIAL_OFFSET] + u[0] + u[3] * np.cos(psi) - u[4] * np.sin(psi)
    radial = p[layout.RADIAL_OFFSET] + u[2] * np.cos(psi) + u[1] * np.sin(psi)
    return axial - answer.position[0, :, 0], radial - answer.position[0, :, 1]


def test_cage_is_in_balance(solved: tuple[Case, Solved, Rolling]) -> None:
    case, batch, rolling = solved
    along = rolling.inner[0, :, 2] + rolling.outer[0, :, 2]
    radius = 0.5 * case.bearing.pitch_diameter
    # e points against the shaft's turning sense
    held = -np.sign(rolling.cage_speed[0]) * case.model.cage_drag
    grip = MU * (batch.inner.load + batch.outer.load).sum()
    assert along.sum() == pytest.approx(held / radius, abs=1e-8 * grip)
    if case.model.cage_drag == 0.0:
        return
    free = solve(case.model_copy(update={"model": Model(
        raceway_control="friction", mesh="coarse")}))  # fmt: skip
    without = free.answer.motion
    assert without is not None
    assert 0.0 < rolling.cage_speed[0] < without.cage_speed[0]


def test_work_of_the_rings_is_what_is_lost(solved: tuple[Case, Solved, Rolling]) -> None:
    case, _, rolling = solved
    state = rolling_of(solve_one(case))
    work = case.duty.inner_speed * state.inner_torque + case.duty.outer_speed * state.outer_torque
    lost = state.power + case.model.cage_drag * abs(state.cage_speed)
    assert work == pytest.approx(lost, rel=1e-6)
    assert state.imbalance <= 1e-6
    assert state.power == pytest.approx(rolling.power.sum(), rel=1e-12)
    assert state.inner_torque + state.outer_torque == pytest.approx(
        np.sign(state.cage_speed) * case.model.cage_drag, abs=1e-7 * abs(state.inner_torque)
    )
    assert (rolling.power >= 0.0).all()


@pytest.mark.parametrize("race", ["inner", "outer"])
@pytest.mark.thirds
def test_friction_is_that_of_the_slip_in_the_result(
    solved: tuple[Case, Solved, Rolling], race: Any
) -> None:
    """Forces, moments and power from loads, angles and motions alone, by another field."""
    case, batch, rolling = solved
    friction = friction_at(case, batch, rolling, race)
    parts = (rolling.inner if race == "inner" else rolling.outer)[0]
    contacts = batch.inner if race == "inner" else batch.outer
    s, c = np.sin(contacts.contact_angle[0]), np.cos(contacts.contact_angle[0])
    scale = MU * np.maximum(contacts.load[0], 1e-6 * contacts.load.max())
    touched = contacts.load[0] > 1e-6 * contacts.load.max()
    pairs = (
        (parts[:, 2], friction.force_rolling, 1.0),
        (parts[:, 0] * c - parts[:, 1] * s, friction.force_transverse, 1.0),
        (parts[:, 3] * c - parts[:, 5] * s, friction.moment_roll, case.bearing.ball_diameter),
        (parts[:, 4], friction.moment_tumble, case.bearing.ball_diameter),
        (parts[:, 3] * s + parts[:, 5] * c, friction.moment_twist, case.bearing.ball_diameter),
    )
    for found, expected, arm in pairs:
        error = np.abs(found - expected[0])[touched]
        assert (error <= 2e-6 * arm * scale[touched]).all()
    power = rolling.power[0, :, 0 if race == "inner" else 1]
    np.testing.assert_allclose(power[touched], friction.power[0][touched], rtol=1e-6)


def friction_at(
    case: Case,
    batch: Solved,
    rolling: Rolling,
    race: Any,
    *,
    omega: Floats | None = None,
    cage: float | None = None,
    rounding: float | None = None,
) -> ContactFriction:
    """What the slip field of `rolamento.friction` makes of a result, or of one near it."""
    omega = rolling.angular_velocity if omega is None else omega
    cage = float(rolling.cage_speed[0]) if cage is None else cage
    patch = Patch.of(batch.contacts[race])
    ball = BallVelocity(omega[..., 0] - cage, omega[..., 1], omega[..., 2])
    speed = case.duty.inner_speed if race == "inner" else case.duty.outer_speed
    relative = abs(case.duty.inner_speed - case.duty.outer_speed)
    v0 = traction.SMOOTHING * relative * case.bearing.ball_diameter
    return contact_friction(
        patch, relative_motion(patch, ball, np.array(speed - cage)), MU,
        rounding=v0 if rounding is None else rounding,
        mesh=ellipse_mesh(*traction.MESHES[case.model.mesh]),
    )  # fmt: skip


# --- limits -----------------------------------------------------------------------------------


def test_torque_is_proportional_to_friction_at_low_speed() -> None:
    torque = [
        rolling_of(solve_one(case_of(inner=10.0, fx=10e3, fz=3e3, mu=mu))).inner_torque
        for mu in (0.02, 0.05, 0.1)
    ]
    # friction carries a little of the load, so that angles and loads change by some μ²
    assert torque[1] / torque[0] == pytest.approx(2.5, rel=1e-3)
    assert torque[2] / torque[0] == pytest.approx(5.0, rel=4e-3)


def test_torque_does_not_depend_on_a_low_speed() -> None:
    slow, slower = (rolling_of(solve_one(case_of(inner=n, fx=10e3, fz=3e3))) for n in (10.0, 0.1))
    assert slow.inner_torque == pytest.approx(slower.inner_torque, rel=1e-5)
    assert slow.cage_speed == pytest.approx(100.0 * slower.cage_speed, rel=1e-6)


@pytest.mark.parametrize("bearing", [ANGULAR, HYBRID])
def test_low_speed_is_jones_full_model(bearing: Bearing) -> None:
    """In thrust, where every ball alone would take the cage's speed."""
    case = case_of(bearing, inner=1.0, fx=10e3, model={"mesh": "fine"})
    state = solve_one(case)
    batch = solve(case)
    expected = jones_full(batch, MU)
    assert rolling_of(state).inner_torque == pytest.approx(float(expected.total[0]), rel=1e-3)


def test_least_power_without_inertia() -> None:
    """Any other motion of balls and cage takes more, by Coulomb's sharp law."""
    off = {"centrifugal_force": False, "gyroscopic_moment": False, "mesh": "fine"}
    case = case_of(fx=20e3, fz=8e3, model=off)
    batch = solve(case)
    rolling = batch.answer.motion
    assert rolling is not None
    assert batch.converged.all()

    def power(omega: Floats, cage: float) -> float:
        parts = [
            friction_at(case, batch, rolling, race, omega=omega, cage=cage, rounding=0.0).power
            for race in ("inner", "outer")
        ]
        return float(np.nansum(parts))

    omega, cage = rolling.angular_velocity, float(rolling.cage_speed[0])
    least = power(omega, cage)
    assert least == pytest.approx(float(rolling.power.sum()), rel=1e-3)
    random = np.random.default_rng(5)
    size = np.linalg.norm(omega, axis=-1).max()
    for part in (0.01, 0.03, 0.1):
        for _ in range(6):
            shift = part * size * random.normal(size=omega.shape)
            assert power(omega + shift, cage * (1.0 + part * random.normal())) > least
        assert power(omega, (1.0 + part) * cage) > least
        assert power(omega, (1.0 - part) * cage) > least


def test_meets_outer_control_where_the_outer_race_rules() -> None:
    """Light thrust at rising speed: the outer load outweighs the inner, and its spin dies out."""
    ratio, attitude = [], []
    for speed in (2e3, 8e3, 16e3):
        model = {"gyroscopic_moment": False, "mesh": "fine"}
        state = solve_one(case_of(inner=speed, fx=5e3, model=model))
        controlled = solve_one(
            case_of(inner=speed, fx=5e3, model={**model, "raceway_control": "outer"})
        )
        rolling_of(state)
        ball = state.balls[0]
        ratio.append(abs(ball.outer.spin_to_roll / ball.inner.spin_to_roll))
        attitude.append(abs(ball.attitude - controlled.balls[0].attitude))
    assert ratio[0] > 0.2
    assert ratio[0] > 3.0 * ratio[1] > 9.0 * ratio[2]
    assert ratio[2] < 0.01
    assert attitude[0] > 2.0 * attitude[1] > 4.0 * attitude[2]


def test_meets_raceway_control_where_no_ball_spins() -> None:
    """Radial load on a deep groove: contact angles are zero and every control is the same."""
    state = solve_one(case_of(DEEP_GROOVE, inner=1e3, fz=3e3, model={"mesh": "fine"}))
    rolling = rolling_of(state)
    assert abs(rolling.skid) < 3e-3
    for ball in state.balls:
        if ball.inner.load > 0.0:
            assert ball.attitude == pytest.approx(0.0, abs=1e-9)
            assert ball.inner.spin_to_roll == pytest.approx(0.0, abs=1e-9)


def test_much_friction_leaves_a_motion_that_does_not_depend_on_it() -> None:
    """What the gyroscopic moment does to the motion dies out as 1/μ; torque over μ settles."""
    values = (0.25, 0.5, 1.0)
    states = [
        solve_one(case_of(fx=20e3, mu=mu, model={"centrifugal_force": False})) for mu in values
    ]
    torque = [rolling_of(s).inner_torque / mu for s, mu in zip(states, values, strict=True)]
    attitude = [state.balls[0].attitude for state in states]
    yaw = [abs(rolling_of(state).balls[0].yaw) for state in states]
    for series in (torque, attitude):
        assert abs(series[2] - series[1]) < 0.7 * abs(series[1] - series[0])
    assert yaw[0] > 1.5 * yaw[1] > 2.25 * yaw[2]
    assert torque[2] == pytest.approx(torque[1], rel=0.02)


# --- symmetry ---------------------------------------------------------------------------------


def test_thrust_treats_all_balls_alike() -> None:
    state = solve_one(CASES["thrust"])
    first, *others = rolling_of(state).balls
    for ball in others:
        assert ball.angular_velocity == pytest.approx(first.angular_velocity, rel=1e-8, abs=1e-5)
        assert ball.inner.power == pytest.approx(first.inner.power, rel=1e-6)
    assert state.displacement.y == pytest.approx(0.0, abs=1e-12)


def test_a_pitch_of_balls_turns_into_itself() -> None:
    case = CASES["free tilts"]
    batch = solve(case, first_ball_azimuth=[0.0, 2.0 * np.pi / 16])
    rolling = batch.answer.motion
    assert rolling is not None
    np.testing.assert_allclose(batch.displacement.array[1], batch.displacement.array[0], rtol=1e-7)
    assert rolling.cage_speed[1] == pytest.approx(rolling.cage_speed[0], rel=1e-8)
    np.testing.assert_allclose(
        np.roll(rolling.power[1], 1, axis=0), rolling.power[0], rtol=1e-5, atol=1e-6
    )


def test_reversed_speeds_mirror_the_bearing() -> None:
    """About the plane of x and z: y, rz and what is along the orbit change their sign."""
    case = CASES["combined"]
    batch = solve(case, inner_speed=np.array([1.0, -1.0]) * case.duty.inner_speed)
    rolling = batch.answer.motion
    assert rolling is not None
    mirror = np.array([1.0, -1.0, 1.0, 1.0, -1.0])
    size = np.abs(batch.displacement.array[0]).max()
    np.testing.assert_allclose(
        batch.displacement.array[1] * mirror, batch.displacement.array[0], rtol=0, atol=1e-7 * size
    )
    assert rolling.cage_speed[1] == pytest.approx(-rolling.cage_speed[0], rel=1e-8)
    np.testing.assert_allclose(rolling.power[1].sum(), rolling.power[0].sum(), rtol=1e-7)
    turned = np.roll(rolling.power[1][::-1], 1, axis=0)
    np.testing.assert_allclose(turned, rolling.power[0], rtol=1e-5, atol=1e-6)


def test_mirrored_thrust_mirrors_a_deep_groove() -> None:
    batch = solve(case_of(DEEP_GROOVE, fz=2e3), fx=[800.0, -800.0])
    rolling = batch.answer.motion
    assert rolling is not None
    mirror = np.array([-1.0, 1.0, 1.0, -1.0, -1.0])
    size = np.abs(batch.displacement.array[0]).max()
    np.testing.assert_allclose(
        batch.displacement.array[1] * mirror, batch.displacement.array[0], rtol=0, atol=1e-7 * size
    )
    assert rolling.cage_speed[1] == pytest.approx(rolling.cage_speed[0], rel=1e-8)
    np.testing.assert_allclose(rolling.power[1], rolling.power[0], rtol=1e-5, atol=1e-7)


def test_only_relative_speed_counts_without_inertia() -> None:
    off = {"centrifugal_force": False, "gyroscopic_moment": False}
    batch = solve(
        case_of(fx=20e3, fz=5e3, model=off),
        inner_speed=np.array([1000.0, 1500.0, 0.0]),
        outer_speed=np.array([0.0, 500.0, -1000.0]),
    )
    rolling = batch.answer.motion
    assert rolling is not None
    assert batch.converged.all()
    power = rolling.power.sum(axis=(1, 2))
    np.testing.assert_allclose(power, power[0], rtol=1e-7)
    np.testing.assert_allclose(
        rolling.cage_speed - [0.0, 500.0, -1000.0], rolling.cage_speed[0], rtol=1e-7
    )


def test_stiffness_is_the_derivative_of_the_load() -> None:
    case = case_of(
        displacement={"x": 4e-5, "y": 1e-6, "z": 1e-5, "ry": 1e-5, "rz": -2e-5}, inner=8e3
    )
    step = np.array([1e-9, 1e-9, 1e-9, 2e-8, 2e-8])
    start = np.array([4e-5, 1e-6, 1e-5, 1e-5, -2e-5])
    places = np.concatenate([[start], *([start + s, start - s] for s in np.diag(step))])
    batch = solve(case, **dict(zip(("x", "y", "z", "ry", "rz"), places.T, strict=True)))  # type: ignore[arg-type]
    assert batch.converged.all()
    slope = ((batch.load.array[1::2] - batch.load.array[2::2]) / (2.0 * step[:, None])).T
    arms = ring_arms(batch.answer.p)[:, 0]
    scaled = (batch.stiffness.array[0] - slope) / np.outer(arms, arms)
    assert np.abs(scaled).max() <= 3e-5 * np.abs(slope / np.outer(arms, arms)).max()


# --- batches and statuses ---------------------------------------------------------------------


def test_batch_equals_single_and_threads_change_no_bit() -> None:
    case = CASES["combined"]
    fx = np.array([12e3, 20e3, -1e3, 25e3, np.nan, 30e3])
    one, two = (solve(case, fx=fx, threads=n) for n in (1, 2))
    assert list(one.status.code) == [
        "converged", "converged", "no_equilibrium", "converged", "invalid_input", "converged",
    ]  # fmt: skip
    for name in ("displacement", "load", "stiffness"):
        np.testing.assert_array_equal(getattr(one, name).array, getattr(two, name).array)
    np.testing.assert_array_equal(one.status.residual, two.status.residual)
    first, second = one.answer.motion, two.answer.motion
    assert first is not None
    assert second is not None
    np.testing.assert_array_equal(first.power, second.power)
    np.testing.assert_array_equal(first.angular_velocity, second.angular_velocity)
    assert np.isnan(first.cage_speed[[2, 4]]).all()
    assert np.isnan(one.displacement.array[[2, 4]]).all()
    state = solve_one(case_of(fx=20e3, fz=15e3))
    np.testing.assert_allclose(state.displacement, one.displacement.array[1], rtol=1e-9)
    assert rolling_of(state).cage_speed == pytest.approx(first.cage_speed[1], rel=1e-10)


@pytest.mark.parametrize("speed", [0.0, 3000.0])
def test_rings_that_turn_alike_are_a_case_for_raceway_control(speed: float) -> None:
    case = case_of(fx=20e3, fz=5e3, inner=speed, outer=speed)
    state = solve_one(case)
    plain = solve_one(case.model_copy(update={"model": Model()}))
    assert state.status.converged
    assert state.rolling is None
    assert "friction_control_at_rest" in {note.key for note in state.notes}
    assert state.displacement == plain.displacement
    for ball, other in zip(state.balls, plain.balls, strict=True):
        assert ball.orbital_speed == other.orbital_speed
        assert ball.centrifugal_force == other.centrifugal_force
    assert state.to_mapping()["rolling"] is None


def test_a_ball_that_nothing_touches_has_no_motion() -> None:
    model = {"centrifugal_force": False}
    state = solve_one(case_of(DEEP_GROOVE, fz=3e3, model=model))
    rolling = rolling_of(state)
    pairs = list(zip(state.balls, rolling.balls, strict=True))
    loose = [(b, r) for b, r in pairs if b.outer.load == 0.0]
    assert loose
    for ball, motion in loose:
        assert np.isnan(motion.angular_velocity).all()
        assert np.isnan(ball.ball_speed)
        assert motion.inner.power == 0.0
        assert np.isnan(motion.inner.slip)
    assert state.to_mapping()["rolling"]["balls"][state.balls.index(loose[0][0])]["yaw"] is None


def test_a_cage_that_friction_cannot_turn_is_not_solved() -> None:
    state = solve_one(case_of(fx=20e3, model={"cage_drag": 1e4}))
    assert state.status.code == "not_converged"
    assert state.rolling is None
    assert state.status.advice is not None
    assert "model.cage_drag" in state.status.advice.text
    assert np.isnan(state.displacement.x)


def test_random_cases_converge() -> None:
    """Sixty duties far apart, on three bearings: all that raceway control can solve."""
    random = np.random.default_rng(20)
    solved = total = 0
    for bearing in (ANGULAR, DEEP_GROOVE, HYBRID):
        size = bearing.ball_count * bearing.ball_diameter**2
        fx = size * 10.0 ** random.uniform(5.0, 6.5, 20)
        given = {
            "fx": fx,
            "fy": fx * random.uniform(-0.5, 0.5, 20),
            "fz": fx * random.uniform(0.0, 0.8, 20),
            "inner_speed": random.uniform(-1.0, 1.0, 20) * 1500.0,
            "outer_speed": random.choice([0.0, 200.0], 20),
        }
        mu = float(random.uniform(0.01, 0.15))
        batch = solve(case_of(bearing, mu=mu, fx=1.0), **given)  # type: ignore[arg-type]
        plain = solve(case_of(bearing, fx=1.0, model={"raceway_control": "outer"}), **given)  # type: ignore[arg-type]
        rolling = batch.answer.motion
        assert rolling is not None
        solved += int(batch.converged.sum())
        total += int(plain.converged.sum())
        assert (rolling.imbalance[batch.converged] <= 1e-6).all()
        assert np.isnan(rolling.cage_speed[~batch.converged]).all()
        assert np.isnan(batch.displacement.array[~batch.converged]).all()
    assert total >= 50
    assert solved >= 0.95 * total
