"""Closed static analyses against their equations of equilibrium, sums and limits."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
import pytest
from scipy import integrate, optimize

from rolamento.contact.hertz import contact_stiffness, effective_modulus
from rolamento.geometry import race_curvature, ring_geometry
from rolamento.static import (
    StaticStatus,
    axial_load,
    combined_load,
    load_zone_half_angle,
    race_stiffness,
    radial_load,
    sjovall_axial,
    sjovall_radial,
)


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


DEEP_GROOVE = Balls()
ANGULAR = Balls(contact_angle=0.6, diametral_clearance=None)
LOADS = np.array([1e-2, 1.0, 100.0, 5000.0, 1e5])


def sjovall_by_definition(epsilon: float) -> tuple[float, float]:
    half = np.pi if epsilon >= 1.0 else np.arccos(1.0 - 2.0 * epsilon)

    def mean(cosines: int) -> float:
        def load(psi: float) -> float:
            w = 1.0 - (1.0 - np.cos(psi)) / (2.0 * epsilon)
            return float(max(w, 0.0) ** 1.5 * np.cos(psi) ** cosines)

        return float(integrate.quad(load, 0.0, half, epsabs=1e-13, epsrel=1e-12)[0] / np.pi)

    return mean(1), mean(0)


@pytest.mark.parametrize("epsilon", [1e-3, 0.1, 0.4379, 0.5, 0.9, 0.999, 1.0, 1.001, 1.7, 30.0])
def test_sjovall_integrals_by_definition(epsilon: float) -> None:
    radial, axial = sjovall_by_definition(epsilon)
    assert sjovall_radial(epsilon) == pytest.approx(radial, rel=1e-10)
    assert sjovall_axial(epsilon) == pytest.approx(axial, rel=1e-10)


def test_sjovall_integrals_at_their_ends() -> None:
    small, large = 1e-10, 1e10
    assert sjovall_radial(small) == pytest.approx(0.375 * np.sqrt(small), rel=1e-9)
    assert sjovall_axial(small) == pytest.approx(0.375 * np.sqrt(small), rel=1e-9)
    assert sjovall_radial(large) == pytest.approx(0.375 / large, rel=1e-9)
    np.testing.assert_allclose(sjovall_axial([0.0, large, np.inf]), [0.0, 1.0, 1.0], atol=1e-9)
    np.testing.assert_array_equal(sjovall_radial([0.0, np.inf]), [0.0, 0.0])
    assert sjovall_radial(1.0) == pytest.approx(0.8 / np.pi, rel=1e-13)
    assert sjovall_axial(1.0) == pytest.approx(4.0 / (3.0 * np.pi), rel=1e-13)
    assert np.isnan(sjovall_radial(-0.1))


def test_load_zone_half_angle() -> None:
    np.testing.assert_allclose(
        load_zone_half_angle([0.0, 0.5, 1.0, 7.0]), [0.0, 0.5 * np.pi, np.pi, np.pi]
    )
    assert np.cos(load_zone_half_angle(0.3)) == pytest.approx(1.0 - 2.0 * 0.3)


def test_stiffness_of_mixed_materials() -> None:
    hybrid = replace(ANGULAR, ball_material=Elastic(310e9, 0.26))
    curvature = race_curvature(12.7e-3, 65e-3, 0.52, 0.6, "inner")
    modulus = effective_modulus(Elastic(), Elastic(310e9, 0.26))
    inner = contact_stiffness(curvature.rolling, curvature.across, modulus)
    assert race_stiffness(hybrid, 0.6).inner == inner
    assert race_stiffness(hybrid, 0.6).combined > race_stiffness(ANGULAR, 0.6).combined
    steel = replace(ANGULAR, ball_material=Elastic())
    assert race_stiffness(steel, 0.6) == race_stiffness(ANGULAR, 0.6)


@pytest.mark.parametrize("clearance", [-20e-6, -1e-9, 0.0, 1e-9, 15e-6, 200e-6])
def test_continuous_radial_load_is_in_balance(clearance: float) -> None:
    """F_r against the load integral taken straight from the squeeze round the ring."""
    bearing = replace(DEEP_GROOVE, diametral_clearance=clearance)
    state = radial_load(bearing, LOADS)
    assert np.all(state.status == StaticStatus.CONVERGED)
    stiffness = float(state.stiffness.combined)
    for load, shift in zip(LOADS, state.radial_displacement, strict=True):
        ratio = min(max(0.5 * clearance / shift, -1.0), 1.0)

        def pull(psi: float, shift: float = shift) -> float:
            squeeze = max(shift * np.cos(psi) - 0.5 * clearance, 0.0)
            return float(stiffness * squeeze**1.5 * np.cos(psi))

        total = integrate.quad(pull, 0.0, np.arccos(ratio), epsrel=1e-11)[0] / np.pi * 9.0
        assert total == pytest.approx(load, rel=1e-6)


def test_radial_result_is_consistent() -> None:
    state = radial_load(DEEP_GROOVE, 3000.0, first_ball_azimuth=0.2)
    epsilon = 0.5 * (1.0 - 15e-6 / (2.0 * state.radial_displacement))
    assert state.load_zone_parameter == pytest.approx(float(epsilon), rel=1e-12)
    assert np.cos(state.load_zone_half_angle) == pytest.approx(
        float(7.5e-6 / state.radial_displacement)
    )
    w = np.maximum(1.0 - (1.0 - np.cos(state.ball_azimuths)) / (2.0 * epsilon), 0.0)
    np.testing.assert_allclose(state.ball_loads, state.max_ball_load * w**1.5, rtol=1e-9)
    assert state.max_ball_load == pytest.approx(
        float(3000.0 / (9 * sjovall_radial(epsilon))), rel=1e-12
    )


@pytest.mark.parametrize("clearance", [-20e-6, 0.0, 15e-6, 200e-6])
@pytest.mark.parametrize("first", [0.0, 0.1, np.pi / 9.0, 2.0])
def test_discrete_radial_load_is_in_balance_both_ways(clearance: float, first: float) -> None:
    bearing = replace(DEEP_GROOVE, diametral_clearance=clearance)
    state = radial_load(bearing, LOADS, distribution="discrete", first_ball_azimuth=first)
    assert np.all(state.status == StaticStatus.CONVERGED)
    scale = LOADS + 9 * float(state.stiffness.combined) * max(-0.5 * clearance, 0.0) ** 1.5
    psi = state.ball_azimuths
    shift = state.radial_displacement[:, None] * np.cos(psi)
    shift = shift + state.lateral_displacement[:, None] * np.sin(psi)
    loads = state.stiffness.combined * np.maximum(shift - 0.5 * clearance, 0.0) ** 1.5
    np.testing.assert_allclose(loads, state.ball_loads, rtol=1e-12)
    assert np.all(np.abs(loads @ np.cos(psi) - LOADS) < 1e-7 * scale)
    assert np.all(np.abs(loads @ np.sin(psi)) < 1e-7 * scale)


def test_discrete_balls_in_mirrored_places_mirror_the_answer() -> None:
    left, right = (
        radial_load(DEEP_GROOVE, 800.0, distribution="discrete", first_ball_azimuth=s * 0.13)
        for s in (1.0, -1.0)
    )
    assert left.radial_displacement == pytest.approx(float(right.radial_displacement), rel=1e-11)
    assert left.lateral_displacement == pytest.approx(-float(right.lateral_displacement), rel=1e-8)
    assert left.lateral_displacement != 0.0
    aligned = radial_load(DEEP_GROOVE, 800.0, distribution="discrete")
    assert abs(aligned.lateral_displacement) < 1e-12 * aligned.radial_displacement


def test_many_balls_become_the_continuous_ring() -> None:
    many = replace(DEEP_GROOVE, ball_count=400)
    smooth = radial_load(many, 1e5)
    counted = radial_load(many, 1e5, distribution="discrete")
    assert counted.radial_displacement == pytest.approx(float(smooth.radial_displacement), rel=1e-6)
    assert counted.max_ball_load == pytest.approx(float(smooth.max_ball_load), rel=1e-6)


def test_stribecks_number() -> None:
    """Without clearance Q_max = 4.37 F_r/Z for point contact."""
    state = radial_load(replace(DEEP_GROOVE, diametral_clearance=0.0), 1234.0)
    assert state.max_ball_load * 9 / 1234.0 == pytest.approx(4.37, abs=0.001)
    assert state.load_zone_parameter == 0.5


def test_no_radial_load() -> None:
    for clearance, shift, epsilon in [(15e-6, 7.5e-6, 0.0), (0.0, 0.0, 0.5), (-8e-6, 0.0, np.inf)]:
        for distribution in ("continuous", "discrete"):
            state = radial_load(
                replace(DEEP_GROOVE, diametral_clearance=clearance),
                0.0,
                distribution="discrete" if distribution == "discrete" else "continuous",
            )
            assert state.status == StaticStatus.CONVERGED
            assert state.radial_displacement == shift
            assert state.load_zone_parameter == epsilon
            squeeze = max(-0.5 * clearance, 0.0)
            expected = state.stiffness.combined * squeeze**1.5
            np.testing.assert_allclose(state.ball_loads, expected)


def test_bad_radial_loads_spoil_only_themselves() -> None:
    loads = np.array([[100.0, -1.0], [np.nan, np.inf]])
    for discrete in (False, True):
        state = radial_load(
            DEEP_GROOVE, loads, distribution="discrete" if discrete else "continuous"
        )
        np.testing.assert_array_equal(state.status, [[0, 2], [2, 2]])
        np.testing.assert_array_equal(np.isnan(state.radial_displacement), [[0, 1], [1, 1]])
        assert state.ball_loads.shape == (2, 2, 9)
        assert np.isnan(state.ball_loads[0, 1]).all()
        alone = radial_load(DEEP_GROOVE, 100.0, distribution=state.distribution)
        assert state.max_ball_load[0, 0] == pytest.approx(float(alone.max_ball_load), rel=1e-12)


def test_one_sided_bearing_cannot_carry_pure_radial_load() -> None:
    with pytest.raises(ValueError, match="combined_load"):
        radial_load(ANGULAR, 100.0)


@pytest.mark.parametrize(
    "bearing",
    [
        ANGULAR,
        DEEP_GROOVE,
        replace(DEEP_GROOVE, diametral_clearance=0.0),
        replace(DEEP_GROOVE, diametral_clearance=-20e-6),
        replace(ANGULAR, contact_angle=1.4),
    ],
)
@pytest.mark.parametrize("free", [False, True])
def test_axial_load_is_in_balance(bearing: Balls, free: bool) -> None:
    """Ring equilibrium from the displacement alone: where the groove centres end up."""
    loads = np.array([1e-4, 1.0, 100.0, 5000.0, 1e6])
    state = axial_load(bearing, loads, stiffness_angle="free" if free else "loaded")
    assert np.all(state.status == StaticStatus.CONVERGED)
    ring = ring_geometry(bearing)
    axial = ring.axial_offset + state.axial_displacement
    length = np.hypot(axial, ring.radial_offset)
    np.testing.assert_allclose(np.arctan2(axial, ring.radial_offset), state.contact_angle)
    squeeze = length - ring.groove_centre_distance
    np.testing.assert_allclose(squeeze, state.deflection, atol=1e-16)
    angle = np.full(5, ring.free_contact_angle) if free else state.contact_angle
    stiffness = race_stiffness(bearing, angle).combined
    force = 9 * stiffness * state.deflection**1.5 * np.sin(state.contact_angle)
    np.testing.assert_allclose(force, loads, rtol=1e-10)
    np.testing.assert_allclose(state.ball_load * np.sin(state.contact_angle) * 9, loads, rtol=1e-10)


def test_axial_load_agrees_with_a_general_root_finder() -> None:
    ring = ring_geometry(ANGULAR)

    def balance(shift: float) -> float:
        axial = ring.axial_offset + shift
        length = np.hypot(axial, ring.radial_offset)
        angle = np.arctan2(axial, ring.radial_offset)
        q = race_stiffness(ANGULAR, angle).combined * (length - ring.groove_centre_distance) ** 1.5
        return float(9 * q * np.sin(angle) - 2500.0)

    shift = optimize.brentq(balance, 0.0, 1e-3, xtol=1e-16)
    assert axial_load(ANGULAR, 2500.0).axial_displacement == pytest.approx(shift, rel=1e-9)


def test_axial_load_the_other_way() -> None:
    push, pull = axial_load(DEEP_GROOVE, 500.0), axial_load(DEEP_GROOVE, -500.0)
    assert pull.axial_displacement == -push.axial_displacement
    assert pull.contact_angle == -push.contact_angle
    assert pull.ball_load == push.ball_load
    apart = axial_load(ANGULAR, [-500.0, 500.0])
    np.testing.assert_array_equal(apart.status, [StaticStatus.NO_EQUILIBRIUM, 0])
    assert np.isnan(apart.contact_angle[0])


def test_no_axial_load() -> None:
    for bearing in (ANGULAR, DEEP_GROOVE):
        state = axial_load(bearing, 0.0)
        assert state.status == StaticStatus.CONVERGED
        assert state.axial_displacement == state.ball_load == 0.0
        assert state.contact_angle == ring_geometry(bearing).free_contact_angle
    tight = axial_load(replace(DEEP_GROOVE, diametral_clearance=-20e-6), 0.0)
    assert tight.ball_load == pytest.approx(float(tight.stiffness.combined * 10e-6**1.5))


def test_angle_bearing_and_its_clearance_twin_agree() -> None:
    ring = ring_geometry(ANGULAR)
    twin = replace(ANGULAR, contact_angle=None, diametral_clearance=ring.diametral_clearance)
    one, other = axial_load(ANGULAR, LOADS), axial_load(twin, LOADS)
    np.testing.assert_allclose(one.contact_angle, other.contact_angle, rtol=1e-12)
    np.testing.assert_allclose(
        one.axial_displacement + 0.5 * ring.endplay, other.axial_displacement, rtol=1e-12
    )


def test_bad_axial_loads_spoil_only_themselves() -> None:
    state = axial_load(DEEP_GROOVE, [np.nan, np.inf, 10.0])
    np.testing.assert_array_equal(state.status, [2, 2, 0])
    np.testing.assert_array_equal(np.isnan(state.ball_load), [True, True, False])


def test_combined_load_is_in_balance() -> None:
    """Both forces from the displacements, integrated round the ring."""
    axial = 1000.0
    radial = axial / np.tan(0.6) * np.array([1e-3, 0.2, 0.5, 0.8, 0.97])
    state = combined_load(ANGULAR, radial, axial)
    assert np.all(state.status == StaticStatus.CONVERGED)
    psi = 2.0 * np.pi * np.arange(200000) / 200000
    for i, force in enumerate(radial):
        squeeze = state.axial_displacement[i] * np.sin(0.6)
        squeeze = squeeze + state.radial_displacement[i] * np.cos(0.6) * np.cos(psi)
        loads = state.stiffness.combined * np.maximum(squeeze, 0.0) ** 1.5
        assert 9 * np.mean(loads) * np.sin(0.6) == pytest.approx(axial, rel=1e-7)
        radial_sum = 9 * np.mean(loads * np.cos(psi)) * np.cos(0.6)
        assert radial_sum == pytest.approx(force, rel=1e-7)
        assert loads.max() == pytest.approx(state.max_ball_load[i], rel=1e-9)


def test_combined_load_at_its_limits() -> None:
    pure = combined_load(ANGULAR, 0.0, 900.0)
    assert np.isinf(pure.load_zone_parameter)
    assert pure.max_ball_load == pytest.approx(100.0 / np.sin(0.6))
    assert pure.radial_displacement == 0.0
    brink = 900.0 / np.tan(0.6)
    state = combined_load(ANGULAR, brink * np.array([1e-12, 1.0 - 1e-10, 1.0, 2.0]), 900.0)
    np.testing.assert_array_equal(state.status, [0, 0, 3, 3])
    assert state.load_zone_parameter[0] == pytest.approx(0.375e12, rel=1e-6)
    assert state.load_zone_parameter[1] == pytest.approx(3e-10, rel=1e-5)
    assert np.isnan(state.max_ball_load[2])


def test_combined_load_on_nearly_one_ball() -> None:
    """Close to F_a = F_r tan α the load integrals are all but equal: J_r/J_a = 1 - ε/3."""
    short = np.logspace(-7.0, -5.0, 400)
    state = combined_load(ANGULAR, 900.0 / np.tan(0.6) * (1.0 - short), 900.0)
    assert np.all(state.status == StaticStatus.CONVERGED)
    np.testing.assert_allclose(state.load_zone_parameter, 3.0 * short, rtol=1e-5)


def test_combined_load_refuses_what_it_cannot_do() -> None:
    with pytest.raises(ValueError, match="contact angle"):
        combined_load(replace(DEEP_GROOVE, diametral_clearance=0.0), 1.0, 1.0)
    state = combined_load(ANGULAR, [-1.0, 1.0, np.nan, 0.0], [1.0, -1.0, 1.0, 0.0])
    np.testing.assert_array_equal(state.status, [2, 2, 2, 0])
    assert state.max_ball_load[3] == 0.0
    loaded = combined_load(DEEP_GROOVE, 10.0, 100.0, contact_angle=0.3)
    assert loaded.contact_angle == 0.3
