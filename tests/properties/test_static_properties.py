"""What must hold for any bearing at rest: scaling, order, symmetry."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rolamento.contact.hertz import elliptical_contact, ellipticity
from rolamento.contact.subsurface import axis_stresses, maximum_shear, orthogonal_shear
from rolamento.static import axial_load, radial_load, sjovall_axial, sjovall_radial


@dataclass(frozen=True)
class Elastic:
    youngs_modulus: float = 207e9
    poisson_ratio: float = 0.3


@dataclass(frozen=True)
class Balls:
    ball_count: int = 9
    ball_diameter: float = 12.7e-3
    pitch_diameter: float = 65e-3
    inner_conformity: float = 0.52
    outer_conformity: float = 0.53
    contact_angle: float | None = None
    diametral_clearance: float | None = 15e-6
    ring_material: Elastic = field(default_factory=Elastic)
    ball_material: Elastic | None = None


loads = st.floats(1e-3, 1e6)
factors = st.floats(0.01, 100.0)
curvatures = st.floats(0.1, 1e4)
moduli = st.floats(1e9, 1e12)
bearings = st.builds(
    Balls,
    ball_count=st.integers(3, 60),
    inner_conformity=st.floats(0.505, 0.6),
    outer_conformity=st.floats(0.505, 0.6),
    diametral_clearance=st.floats(-30e-6, 60e-6),
)


@given(loads, factors, curvatures, curvatures, moduli)
def test_hertz_scales_with_load(
    load: float, factor: float, rolling: float, across: float, modulus: float
) -> None:
    one = elliptical_contact(load, rolling, across, modulus)
    more = elliptical_contact(load * factor, rolling, across, modulus)
    third = np.cbrt(factor)
    np.testing.assert_allclose(more.semi_major, one.semi_major * third, rtol=1e-12)
    np.testing.assert_allclose(more.semi_minor, one.semi_minor * third, rtol=1e-12)
    np.testing.assert_allclose(more.max_pressure, one.max_pressure * third, rtol=1e-12)
    np.testing.assert_allclose(more.deflection, one.deflection * third**2, rtol=1e-12)
    assert more.stiffness == one.stiffness


@given(loads, factors, curvatures, curvatures, moduli)
def test_hertz_scales_with_size_and_stiffness(
    load: float, factor: float, rolling: float, across: float, modulus: float
) -> None:
    """The same pressure and strain in a body of any size: load with its square."""
    one = elliptical_contact(load, rolling, across, modulus)
    large = elliptical_contact(load * factor**2, rolling / factor, across / factor, modulus)
    np.testing.assert_allclose(large.max_pressure, one.max_pressure, rtol=1e-12)
    np.testing.assert_allclose(large.semi_major, one.semi_major * factor, rtol=1e-12)
    np.testing.assert_allclose(large.deflection, one.deflection * factor, rtol=1e-12)
    stiff = elliptical_contact(load * factor, rolling, across, modulus * factor)
    np.testing.assert_allclose(stiff.deflection, one.deflection, rtol=1e-12)
    np.testing.assert_allclose(stiff.max_pressure, one.max_pressure * factor, rtol=1e-12)


@given(loads, curvatures, curvatures, moduli)
def test_work_of_approach_is_the_stored_energy(
    load: float, rolling: float, across: float, modulus: float
) -> None:
    """dδ/dQ by central difference against δ = (Q/K)^(2/3)."""
    step = 1e-4 * load
    around = elliptical_contact([load - step, load, load + step], rolling, across, modulus)
    slope = (around.deflection[2] - around.deflection[0]) / (2.0 * step)
    np.testing.assert_allclose(slope, 2.0 / 3.0 * around.deflection[1] / load, rtol=1e-7)


@given(st.floats(0.0, 1.0 - 1e-9), st.floats(0.0, 1.0 - 1e-9))
def test_ellipticity_rises_with_the_difference_of_curvatures(one: float, other: float) -> None:
    low, high = sorted((one, other))
    k = ellipticity([low, high])
    assert 1.0 <= k[0] <= k[1]


@given(st.floats(1.0, 100.0), st.floats(0.2, 0.45), st.floats(1e8, 5e9), st.floats(1e-5, 1e-2))
def test_subsurface_stresses_scale_with_pressure_and_size(
    k: float, nu: float, pressure: float, b: float
) -> None:
    unit, real = maximum_shear(1.0, k, 1.0, nu), maximum_shear(pressure, k * b, b, nu)
    np.testing.assert_allclose(real.shear, unit.shear * pressure, rtol=1e-10)
    np.testing.assert_allclose(real.depth, unit.depth * b, rtol=1e-5, atol=1e-7 * b)
    orthogonal = orthogonal_shear(pressure, k * b, b)
    assert 0.2138 * pressure < orthogonal.amplitude <= 0.25 * pressure
    assert 0.3508 * b < orthogonal.depth <= 0.5 * b


@given(st.floats(1.0, 100.0), st.floats(0.0, 0.49), st.floats(0.0, 5.0))
def test_normal_stress_fades_and_dilation_knows_no_poissons_ratio(
    k: float, nu: float, zeta: float
) -> None:
    """The sum of the stresses over 1 + ν is a potential that the load alone fixes."""
    here, deeper = (axis_stresses(z, 1.0, k, 1.0, nu) for z in (zeta, zeta + 0.1))
    assert here.normal < deeper.normal < 0.0
    plain = axis_stresses(zeta, 1.0, k, 1.0, 0.0)
    dilation = (here.minor + here.major + here.normal) / (1.0 + nu)
    np.testing.assert_allclose(dilation, plain.minor + plain.major + plain.normal, atol=1e-12)


@given(st.floats(1e-6, 1e6))
def test_sjovall_integrals_in_their_bounds(epsilon: float) -> None:
    jr, ja = sjovall_radial(epsilon), sjovall_axial(epsilon)
    assert 0.0 < jr < ja < 1.0
    assert sjovall_axial(1.01 * epsilon) > ja
    assert sjovall_radial(1.01 * epsilon) / sjovall_axial(1.01 * epsilon) < jr / ja


@given(bearings, st.floats(1.0, 1e5), st.floats(0.0, 6.3))
def test_every_radial_load_is_solved_and_carried(bearing: Balls, load: float, first: float) -> None:
    state = radial_load(
        bearing, [load, 1.1 * load], distribution="discrete", first_ball_azimuth=first
    )
    assert state.status.tolist() == [0, 0]
    carried = state.ball_loads @ np.cos(state.ball_azimuths)
    across = state.ball_loads @ np.sin(state.ball_azimuths)
    scale = load + bearing.ball_count * state.ball_loads.max()
    np.testing.assert_allclose(carried, state.load, atol=1e-9 * scale)
    np.testing.assert_allclose(across, 0.0, atol=1e-9 * scale)
    smooth = radial_load(bearing, [load, 1.1 * load])
    assert smooth.status.tolist() == [0, 0]
    assert smooth.radial_displacement[1] > smooth.radial_displacement[0]


@given(bearings, st.floats(1.0, 1e4), st.floats(0.0, 6.3))
def test_turning_the_cage_by_a_ball_pitch_changes_nothing(
    bearing: Balls, load: float, first: float
) -> None:
    pitch = 2.0 * np.pi / bearing.ball_count
    one, other = (
        radial_load(bearing, load, distribution="discrete", first_ball_azimuth=azimuth)
        for azimuth in (first, first + pitch)
    )
    np.testing.assert_allclose(
        np.roll(one.ball_loads, -1), other.ball_loads, atol=1e-6 * float(one.max_ball_load)
    )


@given(bearings, st.floats(1e-2, 1e6))
def test_every_axial_load_is_solved(bearing: Balls, load: float) -> None:
    state = axial_load(bearing, [load, 1.1 * load])
    assert state.status.tolist() == [0, 0]
    assert state.axial_displacement[1] > state.axial_displacement[0] > 0.0
    assert state.contact_angle[1] > state.contact_angle[0]


@given(st.floats(1.0, 1e5), st.floats(0.1, 10.0), st.floats(0.1, 1.4))
@pytest.mark.sweep
def test_axial_state_is_the_same_in_a_bearing_of_any_size(
    load: float, factor: float, angle: float
) -> None:
    small = Balls(contact_angle=angle, diametral_clearance=None)
    large = replace(
        small,
        ball_diameter=factor * small.ball_diameter,
        pitch_diameter=factor * small.pitch_diameter,
    )
    one, other = axial_load(small, load), axial_load(large, load * factor**2)
    np.testing.assert_allclose(one.contact_angle, other.contact_angle, rtol=1e-12)
    np.testing.assert_allclose(
        one.axial_displacement * factor, other.axial_displacement, rtol=1e-10
    )
