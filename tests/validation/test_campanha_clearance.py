"""Campanha (2008): the measuring load's correction, clearance classes, and wear in test 5."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.clearance import (
    class_clearance,
    clearance_from_reading,
    fit_wear,
    measuring_load_correction,
    usual_measuring_load,
)
from rolamento.verification import Check
from rolamento.verification.campanha_2008 import clearance_checks, measured_bearing
from rolamento.verification.check import published

CHECKS = tuple(clearance_checks())
ROWS = published("campanha_2008")["measuring_load"]["row"]
MICROMETRE, HOUR = 1e-6, 3600.0

# Table 4.3.1 and figure 4.3.3: clearance of bearings 9 and 10, in µm, up to the end of test 5.
HOURS = np.array([0.0, 60.0, 120.0, 180.0, 627.6])
BEARING_9 = np.array([27.0, 36.0, 41.0, 45.0, 50.0])
BEARING_10 = np.array([24.0, 37.0, 44.0, 47.0, 48.0])


@pytest.mark.parametrize("check", CHECKS, ids=lambda c: f"{c.quantity} {c.printed}")
def test_printed_number(check: Check) -> None:
    assert check.verdict == "agrees", check


def test_all_of_table_3_2_is_there() -> None:
    """Five classes for three ranges of bores, C2 with two numbers: 18."""
    assert sum(check.quantity.startswith("ΔP_d") for check in CHECKS) == 18


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["bearing"])
def test_the_loads_of_table_3_2(row: dict[str, float]) -> None:
    assert usual_measuring_load(row["bore_mm"] * 1e-3) == row["load_N"]


def test_smearing_the_balls_misses_the_table() -> None:
    """The continuous ring never leaves all of the load to one ball: C5 comes out too great."""
    wrong = 0
    for row in ROWS:
        bearing = measured_bearing(row)
        middle = class_clearance(row["bore_mm"] * 1e-3, "C5").middle
        correction = measuring_load_correction(
            bearing, middle, row["load_N"], distribution="continuous"
        )
        wrong += abs(correction / MICROMETRE - float(row["C5_um"][0])) > 0.5
    assert wrong == len(ROWS)


def test_the_table_taken_from_a_reading_gives_the_clearance_to_a_micrometre() -> None:
    """Campanha takes 6 µm off a C3's reading under 49 N; the equilibrium 5.4 to 6.1."""
    bearing = measured_bearing(ROWS[1])
    for reading in (19e-6, 26e-6, 34e-6):
        found = clearance_from_reading(bearing, reading, 49.0)
        assert found == pytest.approx(reading - 6e-6, abs=0.6e-6)


@pytest.mark.parametrize(
    ("measured", "wear", "hours"),
    [(BEARING_9, 23.2, 124.0), (BEARING_10, 24.6, 73.0)],
    ids=["9", "10"],
)
def test_wear_of_figure_4_3_3(measured: np.ndarray, wear: float, hours: float) -> None:
    """Running in and then nothing: within 0.7 µm, less than the gauge's resolution, everywhere."""
    fit = fit_wear(HOURS * HOUR, measured * MICROMETRE)
    assert fit.clearance(HOURS * HOUR) == pytest.approx(measured * MICROMETRE, abs=0.7e-6)
    assert fit.constants["running_in_wear"] == pytest.approx(wear * MICROMETRE, abs=0.1e-6)
    assert fit.constants["running_in_time"] == pytest.approx(hours * HOUR, rel=0.01)
    early, late = fit.growth(np.array([180.0, 627.6]) * HOUR)
    assert early > 0.75 * late


def test_steady_wear_adds_nothing_to_it() -> None:
    for measured in (BEARING_9, BEARING_10):
        fit = fit_wear(HOURS * HOUR, measured * MICROMETRE, "running_in_and_steady")
        assert fit.constants["wear_rate"] * 600 * HOUR < 0.01 * MICROMETRE


def test_the_other_bearings_fit_what_both_together_say() -> None:
    """Growth of both as one record, and the 31 to 48 µm of table 4.3.1 after other tests.

    A new one of class C3 has 13 to 28 µm; two standard deviations of the fit are allowed.
    """
    growth = np.concatenate((BEARING_9 - 27.0, BEARING_10 - 24.0)) * MICROMETRE
    fit = fit_wear(np.tile(HOURS, 2) * HOUR, growth)
    assert fit.residual < 2.5e-6
    new = class_clearance(0.025, "C3")
    for hours, after in ((38.2, (31, 39)), (124.7, (38, 44)), (118.4, (37, 41)), (184.4, (42, 37))):
        worn = float(fit.growth(hours * HOUR))
        assert all(
            new.low + worn - 2 * fit.residual
            <= clearance * MICROMETRE
            <= new.high + worn + 2 * fit.residual
            for clearance in after
        )


def test_a_power_of_time_describes_it_worse() -> None:
    for measured in (BEARING_9, BEARING_10):
        clearance = measured * MICROMETRE
        assert (
            fit_wear(HOURS * HOUR, clearance).residual
            < fit_wear(HOURS * HOUR, clearance, "power").residual
        )
