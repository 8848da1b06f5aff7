"""Forces and moments balance, ball by ball and on the rings, in the numbers that a user gets.

Everything is worked out again from the published record (loads, contact angles, centrifugal
force, gyroscopic moment), in space: where each contact lies, which force it passes on, which
angular momentum the ball carries. Nothing of the solver's own residual is used, but it must be
true.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from tests.one_case import solve_one

from rolamento import Bearing, Case, Duty, Load, Model
from rolamento.contact.hertz import contact_stiffness, effective_modulus
from rolamento.geometry import race_curvature, ring_geometry
from rolamento.solution import solve
from rolamento.solved import Solved

Floats = NDArray[np.float64]
PROMISED = 1e-8
"""Greatest unbalanced load, over each ball's own loads and over the greatest on the ring."""
FLOOR = 1e-6  # of the heaviest ball: below it a ball's own load is no scale
DUTIES = 120

ANGULAR: dict[str, Any] = {
    "ball_count": 16,
    "ball_diameter": "22.23 mm",
    "pitch_diameter": "125.26 mm",
    "contact_angle": "40 deg",
    "inner_conformity": 0.5232,
    "outer_conformity": 0.5232,
}
DEEP_GROOVE: dict[str, Any] = {
    "ball_count": 9,
    "ball_diameter": "12.7 mm",
    "pitch_diameter": "65 mm",
    "diametral_clearance": "0.015 mm",
    "inner_conformity": 0.515,
    "outer_conformity": 0.53,
}
CERAMIC: dict[str, Any] = {
    "ball_count": 21,
    "ball_diameter": "7.144 mm",
    "pitch_diameter": "61 mm",
    "contact_angle": "15 deg",
    "inner_conformity": 0.56,
    "outer_conformity": 0.54,
    "ball_material": "Si3N4",
}
OPEN_GROOVES = ANGULAR | {"inner_conformity": 0.6, "outer_conformity": 0.58, "ball_count": 5}
TIGHT = DEEP_GROOVE | {"diametral_clearance": "-0.01 mm"}


@dataclass(frozen=True)
class Group:
    """A bearing with what its random duties are drawn from."""

    name: str
    bearing: dict[str, Any]
    axial: tuple[float, float]
    radial: float  # of the axial load, at most
    speeds: tuple[float, float]  # rpm, inner and outer, at most
    control: str = "outer"
    moment: float | None = None  # of fx d_m, at most; None: tilts held
    tilt_deg: float = 0.0

    def case(self) -> Case:
        model = Model(raceway_control=self.control)
        return Case(bearing=Bearing(**self.bearing), duty=Duty(), model=model)

    def solve(self) -> Solved:
        rng = np.random.default_rng(2013)
        fx = rng.uniform(*self.axial, DUTIES)
        size, rpm = np.abs(fx), np.pi / 30.0
        fields = {
            "fx": fx,
            "fy": size * self.radial * rng.uniform(-0.5, 0.5, DUTIES),
            "fz": size * self.radial * rng.uniform(0.0, 1.0, DUTIES),
            "inner_speed": self.speeds[0] * rpm * rng.uniform(0.0, 1.0, DUTIES),
            "outer_speed": self.speeds[1] * rpm * rng.uniform(0.0, 1.0, DUTIES),
            "first_ball_azimuth": rng.uniform(0.0, 2.0 * np.pi, DUTIES),
        }
        for load, shift in (("my", "ry"), ("mz", "rz")):
            share = rng.uniform(-1.0, 1.0, DUTIES)
            if self.moment is None:
                fields[shift] = np.radians(self.tilt_deg) * share
            else:
                fields[load] = size * 0.125 * self.moment * share
        return solve(self.case(), **fields)


GROUPS = [
    Group("combined", ANGULAR, (2e3, 45e3), 0.9, (15e3, 0.0)),
    Group("moments given", ANGULAR, (2e3, 45e3), 0.9, (15e3, 0.0), moment=0.15),
    Group("light and fast", ANGULAR, (50.0, 500.0), 3.0, (15e3, 0.0), tilt_deg=0.1),
    Group("outer turns", ANGULAR, (500.0, 20e3), 1.5, (0.0, 10e3), tilt_deg=0.1),
    Group("both turn", ANGULAR, (500.0, 20e3), 1.0, (10e3, 8e3)),
    Group("counter-rotating", ANGULAR, (500.0, 20e3), 1.0, (10e3, -10e3)),
    Group("inner control", ANGULAR, (5e3, 45e3), 0.5, (10e3, 0.0), "inner", moment=0.1),
    Group("shared", ANGULAR, (5e3, 45e3), 0.9, (12e3, 0.0), "none", moment=0.1),
    Group("jones", ANGULAR, (2e3, 45e3), 0.9, (10e3, 0.0), "jones"),
    Group("open grooves", OPEN_GROOVES, (1e3, 20e3), 0.5, (10e3, 0.0)),
    Group("ceramic", CERAMIC, (50.0, 1500.0), 1.0, (30e3, 0.0)),
    Group("clearance", DEEP_GROOVE, (-2e3, 2e3), 3.0, (12e3, 0.0), tilt_deg=0.05),
    Group("clearance, moments", DEEP_GROOVE, (300.0, 2e3), 1.0, (12e3, 0.0), moment=0.02),
    Group("interference", TIGHT, (-2e3, 2e3), 3.0, (9e3, 9e3), tilt_deg=0.02),
    Group("at rest", DEEP_GROOVE, (-2e3, 2e3), 3.0, (0.0, 0.0), tilt_deg=0.05),
]


@pytest.fixture(scope="module", params=GROUPS, ids=lambda group: group.name)
def solved(request: pytest.FixtureRequest) -> tuple[Case, Solved]:
    group: Group = request.param
    return group.case(), group.solve()


def lambda_inner(case: Case, batch: Solved) -> Floats:
    """The inner race's share λ_i of the gyroscopic moment, ball by ball; λ_o is the rest of 2."""
    if case.model.raceway_control == "none":
        return np.ones(batch.elements.raceway_control.shape)
    return np.where(batch.elements.raceway_control < 0, 2.0, 0.0)


def forces(case: Case, batch: Solved) -> dict[str, Floats]:
    """(x, r) forces on each ball from both races, and the scale of its loads; (…, balls, 2)."""
    balls, diameter = batch, case.bearing.ball_diameter
    share = lambda_inner(case, batch)
    friction = balls.elements.gyroscopic_moment / diameter
    (si, ci), (so, co) = (
        (np.sin(contact.contact_angle), np.cos(contact.contact_angle))
        for contact in (balls.inner, balls.outer)
    )
    qi, qo = balls.inner.load, balls.outer.load
    inner = np.stack([qi * si - share * friction * ci, qi * ci + share * friction * si], axis=-1)
    rest = 2.0 - share
    outer = np.stack([-qo * so + rest * friction * co, -qo * co - rest * friction * so], axis=-1)
    own = np.maximum(np.maximum(qi, qo), balls.elements.centrifugal_force)
    scale = np.maximum(own, FLOOR * own.max(axis=1, keepdims=True))
    return {"inner": inner, "outer": outer, "scale": scale}


def test_most_have_a_result_and_the_claim_is_true(solved: tuple[Case, Solved]) -> None:
    _, batch = solved
    assert batch.converged.mean() > 0.5
    assert (batch.status.residual[batch.converged] < PROMISED).all()
    assert set(batch.status.code) <= {"converged", "no_equilibrium"}


def test_forces_on_every_ball(solved: tuple[Case, Solved]) -> None:
    case, batch = solved
    force = forces(case, batch)
    error = force["inner"] + force["outer"]
    error[..., 1] += batch.elements.centrifugal_force
    relative = np.linalg.norm(error, axis=-1) / force["scale"]
    assert relative[batch.converged].max() < PROMISED


def test_forces_and_moments_on_the_inner_ring(solved: tuple[Case, Solved]) -> None:
    """Σ over the balls of force, and of moment: arm R_i for the axial force, and λ_i f_i M_g."""
    case, batch = solved
    balls = batch
    c, s = np.cos(balls.elements.azimuth), np.sin(balls.elements.azimuth)
    axial, radial = np.moveaxis(forces(case, batch)["inner"], -1, 0)
    arm = ring_geometry(case.bearing).inner_groove_radius
    friction = (
        case.bearing.inner_conformity * balls.elements.gyroscopic_moment * lambda_inner(case, batch)
    )
    tilting = arm * axial + friction
    sums = [axial, radial * s, radial * c, tilting * c / arm, -tilting * s / arm]
    total = np.stack([term.sum(axis=1) for term in sums], axis=1)
    load = batch.load.array / np.array([1.0, 1.0, 1.0, arm, arm])
    heaviest = np.maximum(balls.inner.load, balls.outer.load).max(axis=1)
    scale = np.maximum(np.abs(load).max(axis=1), heaviest)
    relative = np.abs(total - load).max(axis=1) / scale
    assert relative[batch.converged].max() < PROMISED


def test_what_enters_by_the_shaft_leaves_by_the_housing(solved: tuple[Case, Solved]) -> None:
    """Shaft load and centrifugal forces together press the outer ring."""
    case, batch = solved
    balls = batch
    c, s = np.cos(balls.elements.azimuth), np.sin(balls.elements.azimuth)
    axial, radial = np.moveaxis(-forces(case, batch)["outer"], -1, 0)
    thrown = balls.elements.centrifugal_force
    pairs = [
        (axial.sum(axis=1), batch.load.array[:, 0]),
        ((radial * s).sum(axis=1), batch.load.array[:, 1] + (thrown * s).sum(axis=1)),
        ((radial * c).sum(axis=1), batch.load.array[:, 2] + (thrown * c).sum(axis=1)),
    ]
    scale = np.maximum(balls.outer.load.sum(axis=1), np.abs(batch.load.array[:, :3]).max(axis=1))
    for housing, shaft in pairs:
        assert (np.abs(housing - shaft) / scale)[batch.converged].max() < PROMISED


def test_contacts_close_the_geometry(solved: tuple[Case, Solved]) -> None:
    """From the outer groove's centre over the ball's to the inner groove's, at every azimuth."""
    case, batch = solved
    balls, ring = batch, ring_geometry(case.bearing)
    done = batch.converged
    c, s = np.cos(balls.elements.azimuth), np.sin(balls.elements.azimuth)
    x, y, z, ry, rz = (batch.displacement.array[:, i, np.newaxis] for i in range(5))
    a1 = ring.axial_offset + x + ring.inner_groove_radius * (ry * c - rz * s)
    a2 = ring.radial_offset + z * c + y * s
    outer = ring.outer_length + balls.outer.deflection
    inner = ring.inner_length + balls.inner.deflection
    reach1 = outer * np.sin(balls.outer.contact_angle) + inner * np.sin(balls.inner.contact_angle)
    reach2 = outer * np.cos(balls.outer.contact_angle) + inner * np.cos(balls.inner.contact_angle)
    closed = (balls.inner.deflection > 0.0) & (balls.outer.deflection > 0.0)
    gap = np.hypot(a1 - reach1, a2 - reach2) / ring.groove_centre_distance
    assert gap[closed & done[:, np.newaxis]].max() < 1e-13
    # without inner contact the grooves' centres are nearer to each other than ball and grooves
    open_gap = np.hypot(a1 - outer * np.sin(balls.outer.contact_angle),
                        a2 - outer * np.cos(balls.outer.contact_angle))  # fmt: skip
    loose = (balls.inner.deflection == 0.0) & done[:, np.newaxis]
    assert (open_gap <= inner * (1.0 + 1e-12))[loose].all()


@pytest.mark.parametrize("race", ["inner", "outer"])
@pytest.mark.thirds
def test_loads_are_those_of_exact_hertz(solved: tuple[Case, Solved], race: Any) -> None:
    case, batch = solved
    bearing = case.bearing
    contact = getattr(batch, race)
    conformity = getattr(bearing, f"{race}_conformity")
    touching = contact.load > 0.0
    curvature = race_curvature(
        bearing.ball_diameter,
        bearing.pitch_diameter,
        conformity,
        contact.contact_angle[touching],
        race,
    )
    modulus = effective_modulus(bearing.ring_material, bearing.ball_material)
    exact = contact_stiffness(curvature.rolling, curvature.across, modulus)
    np.testing.assert_allclose(
        contact.load[touching], exact * contact.deflection[touching] ** 1.5, rtol=1e-9
    )


@pytest.mark.parametrize("control", ["outer", "inner", "none"])
@pytest.mark.parametrize(("inner_rpm", "outer_rpm"), [(9e3, 0.0), (0.0, 6e3), (6e3, -4e3)])
def test_moments_about_every_ball_in_space(
    control: Any, inner_rpm: float, outer_rpm: float
) -> None:
    """Friction at both contacts turns the ball's angular momentum round with the cage.

    Vectors in space: H = J ω_R along the ball's axis, dH/dt = ω_m x̂ × H; the races' forces act
    at the ends of the ball's radii along the contact normals. And the moments that all the balls
    put on the inner ring about the bearing's centre, r × F at the contacts, are the shaft's.
    """
    bearing = Bearing(**ANGULAR)
    speeds = {"inner_speed": inner_rpm * np.pi / 30, "outer_speed": outer_rpm * np.pi / 30}
    load = Load(fx="20 kN", fy="2 kN", fz="8 kN", my="100 N m", mz="-60 N m")
    model = Model(raceway_control=control)
    state = solve_one(Case(bearing=bearing, duty=Duty(load=load, **speeds), model=model))
    assert state.status.converged
    ring = ring_geometry(bearing)
    diameter = bearing.ball_diameter
    polar = bearing.ball_material.density * np.pi / 60.0 * diameter**5
    share = {"outer": 0.0, "inner": 2.0, "none": 1.0}[control]
    shaft = np.array([1.0, 0.0, 0.0])
    on_ring, moment_on_ring = np.zeros(3), np.zeros(3)
    for ball in state.balls:
        outward = np.array([0.0, np.sin(ball.azimuth), np.cos(ball.azimuth)])
        along_y = np.cross(outward, shaft)  # +y at azimuth 0
        friction = ball.gyroscopic_moment / diameter

        def normal_and_tangent(angle: float, r: Floats = outward) -> tuple[Floats, Floats]:
            return (
                np.sin(angle) * shaft + np.cos(angle) * r,
                np.cos(angle) * shaft - np.sin(angle) * r,
            )

        n_i, t_i = normal_and_tangent(ball.inner.contact_angle)
        n_o, t_o = normal_and_tangent(ball.outer.contact_angle)
        from_inner = ball.inner.load * n_i - share * friction * t_i
        from_outer = -ball.outer.load * n_o + (2.0 - share) * friction * t_o
        error = from_inner + from_outer + ball.centrifugal_force * outward
        assert np.linalg.norm(error) < PROMISED * ball.outer.load

        turning = np.cross(-diameter / 2 * n_i, from_inner)
        turning += np.cross(diameter / 2 * n_o, from_outer)
        axis = np.cos(ball.attitude) * shaft - np.sin(ball.attitude) * outward
        momentum = polar * ball.ball_speed * axis
        change = np.cross(ball.orbital_speed * shaft, momentum)
        np.testing.assert_allclose(turning, change, atol=1e-9 * np.linalg.norm(change))
        assert change @ along_y == pytest.approx(ball.gyroscopic_moment, rel=1e-9)
        # against the orbit when the inner ring turns faster, with it when the outer does
        sense = (outer_rpm - inner_rpm) * ball.orbital_speed
        assert np.sign(ball.gyroscopic_moment) == np.sign(sense)

        groove_centre = ring.inner_groove_radius * outward
        contact = groove_centre - bearing.inner_conformity * diameter * n_i
        on_ring -= from_inner
        moment_on_ring -= np.cross(contact, from_inner)
    wanted = np.array([20e3, 2e3, 8e3])
    np.testing.assert_allclose(on_ring, -wanted, atol=PROMISED * 20e3)
    np.testing.assert_allclose(moment_on_ring[1:], [-100.0, 60.0], atol=PROMISED * 20e3)
