"""Laws of the slip field, at any attitude."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from rolamento.friction.slip import BallVelocity, Patch, relative_motion, slip_velocity
from rolamento.friction.traction import contact_friction, ellipse_mesh

speeds = st.floats(-1e3, 1e3)
patches = st.builds(
    lambda race, angle, a, flat, f: Patch(
        race,
        *(np.array([x]) for x in (300.0, angle, a, flat * a, 10e-3, 60e-3, f)),
    ),
    st.sampled_from(["inner", "outer"]),
    st.floats(-1.5, 1.5),
    st.floats(1e-5, 2e-3),
    st.floats(0.05, 1.0),
    st.floats(0.502, 0.6),
)
MESH = ellipse_mesh(12, 5)


def ball(x: float, y: float, z: float) -> BallVelocity:
    return BallVelocity(np.array([x]), np.array([y]), np.array([z]))


@given(patches, speeds, speeds, speeds, speeds, st.floats(-3.0, 3.0))
def test_slip_is_linear_in_the_motion(
    patch: Patch, x: float, y: float, z: float, ring: float, factor: float
) -> None:
    one = slip_velocity(patch, relative_motion(patch, ball(x, y, z), ring), MESH.across, MESH.along)
    more = slip_velocity(
        patch,
        relative_motion(patch, ball(factor * x, factor * y, factor * z), factor * ring),
        MESH.across,
        MESH.along,
    )
    np.testing.assert_allclose(more.rolling, factor * one.rolling, atol=1e-10)
    np.testing.assert_allclose(more.transverse, factor * one.transverse, atol=1e-10)


@given(patches, speeds, speeds, speeds, speeds)
def test_mirror_along_the_shaft(patch: Patch, x: float, y: float, z: float, ring: float) -> None:
    """x → -x turns α and the axial vectors: across rolling the field is reflected."""
    mirrored = Patch(patch.race, patch.load, -patch.contact_angle, *patch.arrays[2:])
    here = slip_velocity(patch, relative_motion(patch, ball(x, y, z), ring), 0.3, 0.2)
    there = slip_velocity(mirrored, relative_motion(mirrored, ball(x, -y, -z), ring), -0.3, 0.2)
    np.testing.assert_allclose(there.rolling, here.rolling, atol=1e-11)
    np.testing.assert_allclose(there.transverse, -here.transverse, atol=1e-11)


@given(patches, speeds, speeds, speeds, speeds)
def test_friction_always_takes_power(
    patch: Patch, x: float, y: float, z: float, ring: float
) -> None:
    motion = relative_motion(patch, ball(x, y, z), ring)
    friction = contact_friction(patch, motion, 0.1, mesh=MESH)
    assert friction.power[0] >= 0.0
    force = np.hypot(friction.force_rolling, friction.force_transverse)
    assert force[0] <= 0.1 * 300.0 * (1.0 + 1e-12)
