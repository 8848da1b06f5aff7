"""Laws of wear fitted to clearances."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.clearance.wear import fit_wear
from rolamento.errors import InputError

HOUR = 3600.0
TIMES = np.array([0, 30, 60, 120, 180, 300, 400, 627.6]) * HOUR


def test_running_in_comes_back() -> None:
    made = 25e-6 + 22e-6 * (1 - np.exp(-TIMES / (70 * HOUR)))
    fit = fit_wear(TIMES, made)
    assert fit.constants["initial_clearance"] == pytest.approx(25e-6, rel=1e-6)
    assert fit.constants["running_in_wear"] == pytest.approx(22e-6, rel=1e-6)
    assert fit.constants["running_in_time"] == pytest.approx(70 * HOUR, rel=1e-6)
    assert fit.residual < 1e-11
    assert fit.clearance(TIMES) == pytest.approx(made, rel=1e-9)
    assert fit.growth(0.0) == pytest.approx(0.0, abs=1e-18)


def test_running_in_and_steady_comes_back() -> None:
    made = 25e-6 + 15e-6 * (1 - np.exp(-TIMES / (50 * HOUR))) + 5e-9 / HOUR * TIMES
    fit = fit_wear(TIMES, made, "running_in_and_steady")
    assert fit.constants["wear_rate"] == pytest.approx(5e-9 / HOUR, rel=1e-5)
    assert fit.constants["running_in_time"] == pytest.approx(50 * HOUR, rel=1e-5)


def test_power_comes_back() -> None:
    made = 25e-6 + 20e-6 * (TIMES / TIMES[-1]) ** 0.4
    fit = fit_wear(TIMES, made, "power")
    assert fit.constants["exponent"] == pytest.approx(0.4, rel=1e-6)
    assert fit.constants["wear_at_last"] == pytest.approx(20e-6, rel=1e-6)


@pytest.mark.sweep
def test_standard_errors_cover_the_truth() -> None:
    """Of 200 noisy records about 95 % have A within 2.03 standard errors (Student, 37)."""
    random = np.random.default_rng(7)
    times = np.linspace(0.0, 600.0, 40) * HOUR
    truth = 25e-6 + 20e-6 * (1 - np.exp(-times / (80 * HOUR)))
    hits = 0
    for _ in range(200):
        fit = fit_wear(times, truth + random.normal(0.0, 1e-6, len(times)))
        error = fit.standard_errors["running_in_wear"]
        hits += abs(fit.constants["running_in_wear"] - 20e-6) < 2.03 * error
    assert 0.90 <= hits / 200 <= 0.99


def test_beyond_the_measurements_there_is_no_number() -> None:
    fit = fit_wear(TIMES, 25e-6 + 20e-6 * (1 - np.exp(-TIMES / (70 * HOUR))))
    assert np.isnan(fit.clearance([-1.0, TIMES[-1] * 1.001])).all()
    assert np.isfinite(fit.clearance(TIMES[-1] * 2, beyond=True))


def test_a_bearing_that_does_not_wear() -> None:
    fit = fit_wear(TIMES, np.full(len(TIMES), 20e-6))
    assert fit.clearance(TIMES) == pytest.approx(np.full(len(TIMES), 20e-6), rel=1e-6)


def test_as_many_points_as_constants_leave_no_errors() -> None:
    fit = fit_wear(TIMES[[0, 3, 7]], [20e-6, 30e-6, 34e-6])
    assert np.isnan(fit.residual)
    assert all(np.isnan(error) for error in fit.standard_errors.values())


def test_the_unit_of_time_does_not_matter() -> None:
    made = 25e-6 + 20e-6 * (1 - np.exp(-TIMES / (70 * HOUR))) + 1e-6 * np.cos(TIMES)
    slow, fast = fit_wear(TIMES, made), fit_wear(TIMES / 1e6, made)
    assert fast.constants["running_in_time"] * 1e6 == pytest.approx(
        slow.constants["running_in_time"], rel=1e-6
    )


@pytest.mark.parametrize(
    ("time", "clearance", "law", "told"),
    [
        ([0, 1], [1e-5, 2e-5], "running_in", "at least 3 different values"),
        ([0, 1, 1, 0], [1e-5, 2e-5, 2e-5, 1e-5], "running_in", "at least 3 different"),
        ([0, 1, 2], [1e-5, 2e-5], "running_in", "as long as the times"),
        ([0, 1, -2], [1e-5, 2e-5, 3e-5], "running_in", "must be finite and not negative"),
        ([0, 1, 2], [1e-5, float("nan"), 3e-5], "running_in", "must be finite"),
        ([0, 1, 2], [1e-5, 2e-5, 3e-5], "linear", "must be one of running_in"),
    ],
)
def test_records_that_cannot_be_used(
    time: list[float], clearance: list[float], law: str, told: str
) -> None:
    with pytest.raises(InputError, match=told):
        fit_wear(time, clearance, law)  # type: ignore[arg-type]
