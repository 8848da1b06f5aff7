"""Clearance classes and the measuring load."""

from __future__ import annotations

from itertools import pairwise

import pytest

from rolamento import Bearing
from rolamento.clearance import (
    CLEARANCE_CLASSES,
    class_clearance,
    clearance_from_reading,
    measuring_load_correction,
    usual_measuring_load,
)
from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.static import race_stiffness


def bearing_6205(**changes: object) -> Bearing:
    fields: dict[str, object] = {
        "ball_count": 9,
        "ball_diameter": "7.938 mm",
        "pitch_diameter": "39 mm",
        "diametral_clearance": "0.01 mm",
        "inner_conformity": 0.52,
        "outer_conformity": 0.52,
    }
    return Bearing(**(fields | changes))  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("bore", "clearance_class", "low", "high"),
    [
        # Campanha (2008), chapter 3.2, of NSK's 6305 C3 and 6310 C3
        (25, "C3", 13, 28),
        (50, "C3", 18, 36),
        # SHJF, Internal clearance
        (10, "CN", 2, 13),
        (18, "C4", 18, 33),
        (24, "CN", 5, 20),
        (30, "C5", 30, 53),
        (40, "C2", 1, 11),
        (65, "C4", 38, 61),
        (80, "C5", 65, 105),
        (100, "CN", 12, 36),
    ],
)
def test_classes_as_printed(bore: float, clearance_class: str, low: float, high: float) -> None:
    band = class_clearance(bore * 1e-3, clearance_class)
    assert (band.low * 1e6, band.high * 1e6) == pytest.approx((low, high))
    assert band.middle * 1e6 == pytest.approx(0.5 * (low + high))


def test_every_class_lies_above_the_one_before_and_grows_with_the_bore() -> None:
    data = toml_of("iso5753", "rolamento.clearance")
    steps = len(data["bore_mm"]) - 1
    for name in CLEARANCE_CLASSES:
        pairs = data["classes"][name]
        assert len(pairs) == steps
        full = [pair for pair in pairs if pair]
        assert all(low < high for low, high in full)
        assert full == sorted(full, key=lambda pair: pair[1])
    for step in range(1, steps):
        for first, second in pairwise(CLEARANCE_CLASSES):
            lower, upper = data["classes"][first][step], data["classes"][second][step]
            assert lower[0] < upper[0] < lower[1] < upper[1]


def test_bores_without_a_range_are_refused() -> None:
    with pytest.raises(InputError, match="which covers sizes over") as error:
        class_clearance(0.6, "C3")
    assert error.value.field == "bore"
    with pytest.raises(InputError, match="no range for bores up to 6 mm"):
        class_clearance(0.005, "C4")
    with pytest.raises(InputError, match="must be one of C2, CN") as error:
        class_clearance(0.025, "C0")
    assert error.value.field == "clearance_class"


# --- measuring load ---------------------------------------------------------------


def test_one_ball_alone_carries_the_load_at_wide_clearance() -> None:
    """Then the correction is twice the approach of one ball, (F/K)^⅔, whatever the clearance."""
    bearing = bearing_6205()
    alone = 2.0 * float((49.0 / race_stiffness(bearing, 0.0).combined) ** (2.0 / 3.0))
    for clearance in (40e-6, 80e-6):
        correction = measuring_load_correction(bearing, clearance, 49.0)
        assert correction == pytest.approx(alone, rel=1e-9)


def test_the_correction_without_clearance_goes_with_the_load_to_the_two_thirds() -> None:
    bearing = bearing_6205()
    for distribution in ("discrete", "continuous"):
        small, great = (
            measuring_load_correction(bearing, 0.0, load, distribution=distribution)  # type: ignore[arg-type]
            for load in (10.0, 80.0)
        )
        assert great == pytest.approx(4.0 * small, rel=1e-9)


def test_the_correction_rises_with_the_clearance() -> None:
    bearing = bearing_6205()
    for distribution in ("discrete", "continuous"):
        found = [
            measuring_load_correction(bearing, 1e-6 * c, 49.0, distribution=distribution)  # type: ignore[arg-type]
            for c in range(0, 40, 4)
        ]
        assert all(b >= a * (1 - 1e-9) for a, b in pairwise(found))


@pytest.mark.parametrize("clearance", [0.0, 3e-6, 20e-6, 60e-6])
@pytest.mark.parametrize("azimuth", [0.0, 0.2])
def test_the_reading_gives_the_clearance_back(clearance: float, azimuth: float) -> None:
    bearing = bearing_6205()
    reading = clearance + measuring_load_correction(
        bearing, clearance, 49.0, first_ball_azimuth=azimuth
    )
    found = clearance_from_reading(bearing, reading, 49.0, first_ball_azimuth=azimuth)
    assert found == pytest.approx(clearance, abs=1e-11)


def test_a_contact_angle_is_put_aside() -> None:
    angular = bearing_6205(diametral_clearance=None, contact_angle="15 deg")
    assert measuring_load_correction(angular, 1e-5, 49.0) == measuring_load_correction(
        bearing_6205(), 1e-5, 49.0
    )


def test_readings_and_loads_out_of_range_are_refused() -> None:
    bearing = bearing_6205()
    with pytest.raises(
        InputError, match="is less than the elastic approach under the load alone"
    ) as error:
        clearance_from_reading(bearing, 1e-6, 49.0)
    assert error.value.field == "measured_clearance"
    for load in (0.0, -5.0, 1e9, float("nan")):
        with pytest.raises(InputError, match="at most 1000 kN"):
            measuring_load_correction(bearing, 1e-5, load)
    for reading in (-1e-6, 1.0, float("nan")):
        with pytest.raises(InputError, match="at least 0 mm"):
            clearance_from_reading(bearing, reading, 49.0)


def test_usual_loads() -> None:
    assert [usual_measuring_load(1e-3 * d) for d in (10, 18, 19, 50, 51, 280)] == [
        24.5,
        24.5,
        49.0,
        49.0,
        147.0,
        147.0,
    ]
    with pytest.raises(InputError, match=r"over 2\.5 mm up to 280 mm"):
        usual_measuring_load(0.3)
