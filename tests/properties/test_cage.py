"""What drives a free ball: nothing jumps as it touches or is taken hold of; the cage's laws."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Bearing, Case, Duty, Model
from rolamento.case.model import CageKind, RacewayControl
from rolamento.solution import solve

ANGULAR = Bearing(
    ball_count=16,
    ball_diameter="22.23 mm",
    pitch_diameter="125.26 mm",
    contact_angle="40 deg",
    inner_conformity=0.5232,
    outer_conformity=0.5232,
)
SPEEDS = {"inner": (1000.0, 0.0), "outer": (0.0, 1000.0), "both": (900.0, 400.0)}
"""rad/s of the rings."""


def case_of(control: RacewayControl, cage: CageKind, speeds: str = "inner") -> Case:
    inner, outer = SPEEDS[speeds]
    return Case(
        bearing=ANGULAR,
        duty=Duty(inner_speed=inner, outer_speed=outer),
        model=Model(raceway_control=control, cage=cage),
    )


@pytest.mark.parametrize("speeds", SPEEDS)
@pytest.mark.parametrize("cage", ["loose", "rigid"])
@pytest.mark.parametrize("control", ["outer", "inner", "none"])
def test_nothing_jumps_as_balls_touch_and_are_taken_hold_of(
    control: RacewayControl, cage: CageKind, speeds: str
) -> None:
    """Over a sweep of the radial load a tenth of the step brings a tenth of the greatest change."""
    case = case_of(control, cage, speeds)
    changes = []
    for count in (401, 4001):
        load = np.linspace(4e3, 16e3, count)
        batch = solve(case, fx=5e3, fz=load)
        assert batch.converged.all()
        balls = batch
        touching = (balls.inner.load > 0.0).sum(axis=1)
        assert touching.min() < touching.max()
        parts = (
            batch.displacement.array[:, :3] / 1e-4,
            balls.elements.orbital_speed / 1e3,
            balls.elements.centrifugal_force / 1e3,
            balls.elements.gyroscopic_moment / 1.0,
            balls.outer.load / 1e3,
        )
        changes.append([np.abs(np.diff(part, axis=0)).max() for part in parts])
    coarse, fine = changes
    assert (np.array(fine) / np.array(coarse) < 0.11).all()


@pytest.mark.parametrize("cage", ["loose", "rigid"])
@pytest.mark.parametrize("control", ["outer", "inner", "none"])
def test_the_stiffness_does_not_jump_as_a_ball_touches(
    control: RacewayControl, cage: CageKind
) -> None:
    """It grows with the root of the approach: ever steeper at the load of touching, but no jump."""
    case = case_of(control, cage)
    low, high = 4e3, 16e3
    jumps = []
    for _ in range(6):
        load = np.linspace(low, high, 101)
        batch = solve(case, fx=5e3, fz=load)
        assert batch.converged.all()
        touching = (batch.inner.load > 0.0).sum(axis=1)
        at = int(np.flatnonzero(np.diff(touching))[0])
        before, after = batch.stiffness.array[at : at + 2]
        jumps.append(np.abs(after - before).max() / np.abs(before).max())
        low, high = load[at : at + 2]
    assert high - low < 1e-7
    assert jumps[0] > 5e-3
    assert jumps[-1] < 1e-4


@pytest.mark.parametrize("speeds", SPEEDS)
@pytest.mark.parametrize("control", ["outer", "inner", "jones", "none"])
def test_a_free_ball_has_the_cage_s_speed_and_no_ball_leaves_those_of_the_rings(
    control: RacewayControl, speeds: str
) -> None:
    batch = solve(case_of(control, "loose", speeds), fx=[5e3, 8e3], fz=[25e3, 20e3])
    assert batch.converged.all()
    balls = batch
    load, orbit = balls.inner.load, balls.elements.orbital_speed
    assert ((load == 0.0).sum(axis=1) > 1).all()
    # but for the pull of the nominal speed, a hundredth of a ball's F_c among all loads
    cage = (load * orbit).sum(axis=1) / load.sum(axis=1)
    np.testing.assert_allclose(
        np.where(load == 0.0, orbit, cage[:, np.newaxis]), np.repeat(cage[:, np.newaxis], 16, 1),
        rtol=3e-5,
    )  # fmt: skip
    slow, fast = sorted(SPEEDS[speeds])
    assert (orbit > slow).all()
    assert (orbit < fast).all()


def test_where_all_balls_are_firmly_held_the_cage_has_no_say() -> None:
    """At more than 0.8 of the reference force on every ball, to the last digits."""
    loads = {"fx": np.array([40e3, 60e3]), "fz": 2e3}
    found = {cage: solve(case_of("outer", cage), **loads) for cage in ("loose", "none")}  # type: ignore[arg-type]
    assert found["loose"].inner.load.min() > 1.6e3
    for name in ("displacement", "stiffness"):
        loose, none = (getattr(found[cage], name).array for cage in ("loose", "none"))
        np.testing.assert_allclose(loose, none, rtol=1e-8, atol=1e-8 * np.abs(none).max())


def test_a_rigid_cage_has_one_speed() -> None:
    batch = solve(case_of("outer", "rigid"), fx=[5e3, 20e3], fz=[25e3, 15e3])
    orbit = batch.elements.orbital_speed
    np.testing.assert_allclose(orbit, np.repeat(orbit[:, :1], 16, axis=1), rtol=1e-12)
