"""Friction over an ellipse, the forces of a race on a ball, and one evaluation of the balance."""

from __future__ import annotations

from functools import lru_cache
from importlib.resources import as_file, files
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.one_case import solve_one

from rolamento import Case, Lubricant, Model, load_case
from rolamento.friction.slip import BallVelocity, Patch, relative_motion
from rolamento.friction.traction import contact_friction, ellipse_mesh
from rolamento.kinematics import RacewayControl, ball_motion
from rolamento.rows.ball import layout
from rolamento.rows.ball.single import groove
from rolamento.rows.ball.traction import balance, newton
from rolamento.rows.ball.traction.ball import (
    AXES_INNER,
    AXES_OUTER,
    HALF,
    INPUTS,
    RADIUS,
    Mesh,
    Rig,
    contact_forces,
    least_speed,
    polynomial,
    race_room,
    rolling_start,
)
from rolamento.rows.ball.traction.contact import FORCES, SUMS, add_friction, ellipse_nodes
from rolamento.rows.ball.traction.solve import case_constants
from rolamento.system import spread

Floats = NDArray[np.float64]
MU = 0.08
NODES = (12, 3)


@pytest.fixture
def rig(case_218: Case) -> Rig:
    """The 218 bearing under combined load, with a drag on the cage."""
    columns = spread(case_218, {})
    row = columns.alone
    assert row is not None
    constants = case_constants(row.p, np.array([MU]))[:, 0].copy()
    azimuth = 2.0 * np.pi * np.arange(3) / 3
    return Rig(row.p.whole(), 0, constants, 0.2, np.cos(azimuth), np.sin(azimuth))


def mesh_of(rig: Rig, smoothing: float, nodes: tuple[int, int] = NODES) -> Mesh:
    found = ellipse_nodes(*nodes)
    speed = smoothing * least_speed(rig)[0]
    return Mesh(*found, np.full(found[0].size, speed**2))


@pytest.mark.parametrize("nodes", [(20, 3), (40, 5), (120, 9)])
def test_nodes_carry_the_pressure(nodes: tuple[int, int]) -> None:
    """Moments of Hertz's pressure: <1> = 1, <u²> = 1/5, <u⁴> = 3/35, <u² v²> = 1/35."""
    u, v, weight = ellipse_nodes(*nodes)
    for values, expected in ((1.0, 1.0), (u, 0.0), (u**2, 0.2), (v**2, 0.2), (u**4, 3.0 / 35.0)):
        assert np.sum(weight * values) == pytest.approx(expected, abs=1e-14)
    assert np.sum(weight * u**2 * v**2) == pytest.approx(1.0 / 35.0, abs=1e-14)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("race", ["inner", "outer"])
def test_friction_is_that_of_the_slip_field(race: Any, seed: int) -> None:
    """Any attitude, against the slip field that `rolamento.friction` has in NumPy."""
    random = np.random.default_rng(seed)
    diameter, pitch, conformity = 12e-3, 60e-3, 0.5 + random.uniform(0.01, 0.05)
    load, angle = random.uniform(50, 2e3), random.uniform(-0.9, 1.2)
    a = random.uniform(0.3e-3, 2e-3)
    b = a * random.uniform(0.05, 0.9)
    omega, orbit, ring = (
        random.normal(0.0, 3e3, 3),
        random.normal(0.0, 400.0),
        random.normal(0, 1e3),
    )
    patch = Patch(race, *(np.array([v]) for v in (load, angle, a, b, diameter, pitch, conformity)))
    ball = BallVelocity(*(np.array([v]) for v in (omega[0] - orbit, omega[1], omega[2])))
    motion = relative_motion(patch, ball, ring - orbit)
    expected = contact_friction(patch, motion, MU, rounding=0.3, mesh=ellipse_mesh(*NODES))

    s, c = np.sin(angle), np.cos(angle)
    nodes = ellipse_nodes(*NODES)
    force, slope, growth = np.empty(FORCES), np.empty((FORCES, FORCES)), np.empty((FORCES, 2))
    power = add_friction(
        *nodes, (omega[0] - ring) * s + omega[2] * c, (omega[0] - ring) * c - omega[2] * s,
        omega[1], 0.5 * (ring - orbit) * pitch, patch.side, MU * load, a, b,
        float(patch.deformed_radius[0]), 0.5 * diameter, np.full(nodes[0].size, 0.3**2), force,
        slope, growth, np.empty(SUMS),
    )  # fmt: skip
    names = ("moment_twist", "moment_roll", "moment_tumble", "force_rolling", "force_transverse")
    for value, name in zip(force, names, strict=True):
        assert value == pytest.approx(getattr(expected, name)[0], rel=1e-11, abs=1e-13)
    assert power == pytest.approx(expected.power[0], rel=1e-11)
    assert power > 0.0
    np.testing.assert_allclose(slope, slope.T, rtol=0, atol=0)
    assert np.linalg.eigvalsh(slope).max() <= 1e-9 * np.abs(slope).max()


def test_polynomials_are_those_of_the_axes(rig: Rig) -> None:
    """Value and slope; the axes at an angle between the points they pass through."""
    for axes in (AXES_INNER, AXES_OUTER):
        for cosine in (0.1, 0.55, 0.97):
            for first in (axes, axes + layout.COEFFICIENTS):
                value, slope = polynomial(rig.k, first, cosine)
                above, below = (polynomial(rig.k, first, cosine + e)[0] for e in (1e-5, -1e-5))
                assert slope == pytest.approx((above - below) / 2e-5, rel=1e-7, abs=1e-9 * value)


def test_rolling_start_is_outer_raceway_control(rig: Rig) -> None:
    alpha_i, alpha_o = 0.8, 0.6
    x, out, orbit = rolling_start(
        rig, np.sin(alpha_i), np.cos(alpha_i), np.sin(alpha_o), np.cos(alpha_o)
    )
    p = rig.p[:, 0]
    motion = ball_motion(
        np.array(alpha_i), np.array(alpha_o), p[layout.GAMMA], p[layout.INNER_SPEED],
        p[layout.OUTER_SPEED], np.array(int(RacewayControl.OUTER)),
    )  # fmt: skip
    assert orbit == pytest.approx(float(motion.orbital_speed), rel=1e-12)
    assert np.hypot(x - orbit, out) == pytest.approx(abs(float(motion.ball_speed)), rel=1e-12)


@pytest.mark.parametrize("inner", [True, False])
def test_derivatives_of_a_contact(rig: Rig, inner: bool) -> None:
    """Forces and moments by the contact's vector, by ω_b and by ω_m, against differences."""
    mesh = mesh_of(rig, 0.05)
    length = rig.p[layout.INNER_LENGTH if inner else layout.OUTER_LENGTH, 0]
    start = np.array([(length + 1e-5) * 0.6, (length + 1e-5) * 0.8, -1500.0, 200.0, 900.0, 450.0])

    def force(values: Floats) -> tuple[Floats, Floats, float]:
        room = race_room()
        load, _ = contact_forces(
            rig, inner, values[0], values[1], values[2:5], values[5], mesh, mesh.least, room
        )
        return room.force.copy(), room.slope.copy(), load

    _, slope, load = force(start)
    assert load > 0.0
    steps = np.array([1e-9, 1e-9, 1e-2, 1e-2, 1e-2, 1e-3])
    for column in range(INPUTS):
        shift = np.zeros(INPUTS)
        shift[column] = steps[column]
        difference = (force(start + shift)[0] - force(start - shift)[0]) / (2.0 * steps[column])
        np.testing.assert_allclose(
            slope[:, column], difference, rtol=0, atol=2e-6 * np.abs(difference).max()
        )


def test_no_contact_no_force(rig: Rig) -> None:
    room = race_room()
    length = rig.p[layout.INNER_LENGTH, 0]
    mesh = mesh_of(rig, 0.1)
    found = contact_forces(rig, True, 0.0, 0.99 * length, np.ones(3), 1.0, mesh, mesh.least, room)
    assert found == (0.0, 0.0)
    assert not room.force.any()
    assert not room.slope.any()


def placed(rig: Rig) -> balance.Place:
    """Balls a little off balance, all pressed in at both races."""
    balls = rig.cosines.size
    place = balance.Place(np.zeros(balance.RING), np.zeros((balls, 2)), np.zeros((balls, 3)))
    place.u[:5] = (8e-5, 1e-6, 4e-5, 2e-6, -3e-6)
    inner, outer = rig.p[layout.INNER_LENGTH, 0], rig.p[layout.OUTER_LENGTH, 0]
    for j, (c, s) in enumerate(zip(rig.cosines, rig.sines, strict=True)):
        a = np.array(groove(rig.p, 0, place.u, c, s))
        place.x[j] = a * outer / (inner + outer) + [1e-7 * j, -2e-7]
    balance.start_rolling(rig, place)
    place.omega[:] *= 1.02
    place.omega[:, 1] = [30.0, -50.0, 10.0]
    return place


def evaluated(rig: Rig, place: balance.Place) -> balance.Sheet:
    sheet = balance.sheet_for(rig.cosines.size)
    balance.evaluate(rig, place, mesh_of(rig, 0.05), sheet)
    return sheet


def test_derivatives_of_the_balance(rig: Rig) -> None:
    """The equations of ring and cage with all balls following, against differences.

    With the balls' own steps taken, a step of ring and cage leaves the balls in balance to first
    order, and changes what the ring sees as the reduced matrix says.
    """
    place = placed(rig)
    sheet = evaluated(rig, place)
    step = newton.step_for(rig.cosines.size)
    assert newton.eliminate_balls(rig, sheet, step)
    matrix, follow = step.matrix.copy(), step.follow.copy()
    for unknown in range(balance.RING):
        size = 1e-3 if unknown == balance.CAGE else 1e-9
        reactions, residuals = [], []
        for sign in (1.0, -1.0):
            moved = balance.Place(*(array.copy() for array in place))
            moved.u[unknown] += sign * size
            for j, (c, s) in enumerate(zip(rig.cosines, rig.sines, strict=True)):
                ring = np.zeros(5)
                ring[min(unknown, 4)] = 0.0 if unknown == balance.CAGE else 1.0
                asked = [
                    ring[0] + c * ring[3] - s * ring[4], c * ring[2] + s * ring[1],
                    1.0 if unknown == balance.CAGE else 0.0,
                ]  # fmt: skip
                change = sign * size * follow[j, :, 1:] @ asked
                moved.x[j] += change[:2]
                moved.omega[j] += change[2:]
            after = evaluated(rig, moved)
            total = np.zeros(5)
            for c, s, sight in zip(rig.cosines, rig.sines, after.sight, strict=True):
                balance.add_reaction(c, s, sight, total)
            cage = balance.cage_residual(rig, moved.u[balance.CAGE], after.forces)[0]
            reactions.append(np.append(total, cage))
            residuals.append(after.residual.copy())
        slope = (reactions[0] - reactions[1]) / (2.0 * size)
        scale = np.abs(matrix[:, unknown]).max()
        np.testing.assert_allclose(matrix[:, unknown], slope, rtol=0, atol=3e-5 * scale)
        left = (residuals[0] - residuals[1]) / (2.0 * size)
        stiffest = np.abs(sheet.inputs[:, :, :2]).max() if unknown < balance.CAGE else scale
        assert np.abs(left).max() <= 3e-5 * stiffest


def test_newton_lowers_the_residual_to_rounding(rig: Rig) -> None:
    """From a ring pressed in anyhow, with nearly viscous friction, in plain Python."""
    place = placed(rig)
    origin = balance.Place(*(array.copy() for array in place))
    sheet, step = balance.sheet_for(3), newton.step_for(3)
    worst, evaluations = newton.relax(rig, place, origin, mesh_of(rig, 1.0), 1e-9, sheet, step)
    assert worst <= 1e-9
    assert evaluations < 30
    assert np.isfinite(place.u).all()


def test_balls_that_nothing_touches_stay(rig: Rig) -> None:
    place = placed(rig)
    sheet = evaluated(rig, place)
    sheet.forces[1, :2] = 0.0
    step = newton.step_for(3)
    assert newton.eliminate_balls(rig, sheet, step)
    assert not step.follow[1].any()
    assert step.follow[0].any()


def test_constants_of_a_case(rig: Rig, case_218: Case) -> None:
    of = case_218.bearing
    assert rig.k[HALF] == pytest.approx(0.5 * of.ball_diameter, rel=1e-15)
    assert rig.k[RADIUS] == pytest.approx(0.5 * of.pitch_diameter, rel=1e-14)


def test_inertia_switched_off_is_absent(case_218: Case) -> None:
    from rolamento.rows.ball.traction.ball import INERTIA, MASS

    lubricant = Lubricant(kind="dry", friction_coefficient=MU)
    for name, index in (("centrifugal_force", MASS), ("gyroscopic_moment", INERTIA)):
        model = Model(raceway_control="friction", **{name: False})
        case = Case(bearing=case_218.bearing, duty=case_218.duty, model=model, lubricant=lubricant)
        column = spread(case, {}).rows[0].row.p
        constants = case_constants(column, np.array([MU]))
        assert constants[index, 0] == 0.0
        other = INERTIA if index == MASS else MASS
        assert constants[other, 0] > 0.0


# --- how fast the mesh converges --------------------------------------------------------------

MOTIONS = {"spinning": (250.0, -2600.0), "hardly spinning": (30.0, -2600.0)}
FINEST = (1000, 501)
SEMI_MAJOR, SEMI_MINOR, GROOVE, RADIUS_OF_BALL = 2e-3, 0.25e-3, 11.2e-3, 11e-3


def integrals(nodes: tuple[int, int], motion: tuple[float, float], v0: float) -> Floats:
    """All that one contact is integrated for: M_a, M_t, M_e, F_e, F_t and the power.

    The ball and the race roll on each other without slip at a point inside the ellipse.
    """
    spin, across = motion
    a, b = SEMI_MAJOR, SEMI_MINOR
    x, y = 0.35 * a, 0.3 * b
    lift = np.sqrt(RADIUS_OF_BALL**2 - a**2) - np.sqrt(GROOVE**2 - a**2)
    radius = np.sqrt(GROOVE**2 - x**2) + lift
    found = nodes_once(*nodes)
    force, slope, growth = np.empty(FORCES), np.empty((FORCES, FORCES)), np.empty((FORCES, 2))
    power = vectorised(
        *found, spin, across, y * spin / radius, radius * across - x * spin, 1.0, 100.0, a, b,
        GROOVE, RADIUS_OF_BALL, np.full(found[0].size, v0**2), force, slope, growth,
        np.empty(SUMS),
    )  # fmt: skip
    return np.append(force, power)


@lru_cache(maxsize=16)
def nodes_once(across: int, along: int) -> tuple[Floats, Floats, Floats]:
    return ellipse_nodes(across, along)


def vectorised(*arguments: Any) -> float:
    return float(add_friction.compiled(*arguments))


@pytest.mark.parametrize("name", list(MOTIONS))
def test_integrals_converge_with_the_mesh(name: str) -> None:
    """Every integral, with second order.

    The direction of the friction is undefined where nothing slips, and the cells around that
    point are wrong by their share of the area.
    """
    motion = MOTIONS[name]
    counts = np.array([20, 40, 80, 160, 320])
    exact = integrals(FINEST, motion, 1e-5)
    error = np.array([np.abs(integrals((n, n // 4 + 1), motion, 1e-5) - exact) for n in counts])
    error /= np.abs(exact)
    assert error[-1].max() < 3e-3
    for column in range(FORCES + 1):
        order = -np.polyfit(np.log(counts), np.log(error[:, column]), 1)[0]
        assert order > 1.3, (name, column, order)
    orders = -np.polyfit(np.log(counts), np.log(error), 1)[0]
    assert np.median(orders) > 1.8


def test_smooth_friction_converges_to_rounding() -> None:
    """With v0 as large as the slip the integrand is smooth, and Gauss's order shows."""
    for motion in MOTIONS.values():
        exact = integrals((320, 81), motion, 0.1)
        coarse, fine = (np.abs(integrals(m, motion, 0.1) / exact - 1) for m in ((20, 6), (40, 11)))
        assert coarse.max() < 1e-4
        assert fine.max() < 1e-8


@pytest.mark.parametrize("name", list(MOTIONS))
def test_smoothing_converges_to_coulomb_with_second_order(name: str) -> None:
    motion, nodes = MOTIONS[name], FINEST
    values = np.array([4e-3, 2e-3, 1e-3])
    exact = integrals(nodes, motion, 1e-5)
    error = np.array([np.abs(integrals(nodes, motion, v0) / exact - 1.0) for v0 in values])
    orders = np.polyfit(np.log(values), np.log(error), 1)[0]
    assert (orders > 1.6).all()
    assert (orders < 2.4).all()


@pytest.mark.parametrize("load", ["1 kN", "5 kN", "10.8 kN"])
def test_pure_radial_load_with_balls_that_face_away(load: str) -> None:
    """At an unloaded ball the grooves' centres lie on opposite sides: no axis to start rolling."""
    example = files("rolamento") / "examples" / "6305_film.toml"
    with as_file(example) as path:
        settings = [f"duty.load.fz={load}", "model.raceway_control=friction", "model.mesh=coarse"]
        state = solve_one(load_case(path, settings))
    assert state.status.converged
    assert state.rolling is not None
    assert state.rolling.power > 0.0
