"""Curvatures, angles and clearances."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pytest

from rolamento.geometry import (
    clearance_of_angle,
    free_contact_angle,
    groove_centre_distance,
    race_curvature,
    ring_geometry,
    total_curvature,
)


@dataclass(frozen=True)
class Rings:
    ball_diameter: float = 22.23e-3
    pitch_diameter: float = 125.26e-3
    inner_conformity: float = 0.5232
    outer_conformity: float = 0.53
    contact_angle: float | None = None
    diametral_clearance: float | None = None


def test_total_curvature_and_distance() -> None:
    assert total_curvature(0.52, 0.53) == pytest.approx(0.05)
    assert groove_centre_distance(0.01, 0.52, 0.53) == pytest.approx(0.0005)


def test_free_angle_and_clearance_are_inverse() -> None:
    angle = np.concatenate([[0.0], np.geomspace(1e-7, 1.5, 50)])
    back = free_contact_angle(clearance_of_angle(angle, 1e-3), 1e-3)
    np.testing.assert_allclose(back, angle, rtol=1e-14)
    assert np.cos(free_contact_angle(0.4e-3, 1e-3)) == pytest.approx(1.0 - 0.4 / 2.0)


def test_interference_has_no_contact_angle_and_too_much_clearance_none_at_all() -> None:
    np.testing.assert_array_equal(free_contact_angle([-1e-5, 2.1e-3], 1e-3), [0.0, np.nan])


@pytest.mark.parametrize(("race", "side"), [("inner", -1.0), ("outer", 1.0)])
@pytest.mark.parametrize("angle", [0.0, 0.7, 1.4])
def test_rolling_curvature_is_that_of_the_surface_of_revolution(
    race: str, side: float, angle: float
) -> None:
    """The race's principal radius is its normal's length to the shaft: r / cos α (Meusnier)."""
    d, dm = 0.02, 0.1
    contact_radius = 0.5 * dm + side * 0.5 * d * np.cos(angle)
    curvature = race_curvature(d, dm, 0.52, angle, "inner" if race == "inner" else "outer")
    assert curvature.rolling == pytest.approx(2.0 / d - side * np.cos(angle) / contact_radius)
    assert curvature.across == pytest.approx(2.0 / d - 1.0 / (0.52 * d))


def test_sum_and_difference() -> None:
    curvature = race_curvature(0.02, 0.1, [0.51, 0.52], 0.3, "outer")
    np.testing.assert_allclose(curvature.sum, curvature.rolling + curvature.across)
    # Textbook form: F = (1/f - 2γ/(1+γ)) / (4 - 1/f - 2γ/(1+γ)).
    gamma, f = 0.2 * np.cos(0.3), np.array([0.51, 0.52])
    bend = 2.0 * gamma / (1.0 + gamma)
    np.testing.assert_allclose(curvature.difference, (1 / f - bend) / (4 - 1 / f - bend))


def test_bearing_given_by_its_angle_starts_at_first_contact() -> None:
    ring = ring_geometry(Rings(contact_angle=0.7))
    assert np.hypot(ring.axial_offset, ring.radial_offset) == pytest.approx(
        ring.groove_centre_distance
    )
    assert np.arctan2(ring.axial_offset, ring.radial_offset) == pytest.approx(0.7)
    assert ring.one_sided
    # Ball centre between the groove centres; the inner groove's circle lies outside d_m/2.
    assert ring.inner_groove_radius == pytest.approx(
        125.26e-3 / 2 + ring.inner_length * np.cos(0.7)
    )


def test_clearance_twin_has_the_same_free_angle() -> None:
    by_angle = ring_geometry(Rings(contact_angle=0.7))
    by_clearance = ring_geometry(Rings(diametral_clearance=by_angle.diametral_clearance))
    assert by_clearance.free_contact_angle == pytest.approx(0.7, rel=1e-14)
    assert by_clearance.axial_offset == 0.0
    assert by_clearance.radial_offset == pytest.approx(by_angle.radial_offset, rel=1e-14)
    assert by_clearance.inner_groove_radius == pytest.approx(by_angle.inner_groove_radius)
    assert not by_clearance.one_sided
    assert 0.5 * by_clearance.endplay == pytest.approx(by_angle.axial_offset, rel=1e-13)


def test_interference_squeezes_the_centred_balls() -> None:
    ring = ring_geometry(Rings(diametral_clearance=-10e-6))
    assert ring.free_contact_angle == 0.0
    assert ring.endplay == 0.0
    assert ring.radial_offset - ring.groove_centre_distance == pytest.approx(5e-6)


def test_angle_zero_is_two_sided_without_clearance() -> None:
    ring = ring_geometry(Rings(contact_angle=0.0))
    assert (ring.one_sided, ring.axial_offset, ring.diametral_clearance) == (False, 0.0, 0.0)


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({}, "either"),
        ({"contact_angle": 0.5, "diametral_clearance": 1e-5}, "either"),
        ({"contact_angle": -0.1}, "contact_angle"),
        ({"contact_angle": 1.6}, "contact_angle"),
        ({"contact_angle": float("nan")}, "contact_angle"),
        ({"diametral_clearance": 5e-3}, "diametral_clearance"),
        ({"diametral_clearance": float("nan")}, "diametral_clearance"),
    ],
)
def test_impossible_rings_are_refused(change: dict[str, float], word: str) -> None:
    with pytest.raises(ValueError, match=word):
        ring_geometry(replace(Rings(), **change))
