"""The record of a signal, its spectra and the numbers that sum it up."""

from __future__ import annotations

from math import isnan, pi, sqrt
from typing import Any

import numpy as np
import pytest

from rolamento.errors import InputError
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import (
    amplitude_spectrum,
    averaged_density,
    indicators,
    power_density,
    spectral_indicators,
)

RATE = 10_000.0
TIME = np.arange(20_000) / RATE


def sine(frequency: float, amplitude: float = 1.0) -> np.ndarray[Any, np.dtype[np.float64]]:
    return amplitude * np.sin(2.0 * pi * frequency * TIME)


def test_samples_are_kept_and_cannot_be_changed() -> None:
    own = np.array([1.0, 2.0, 3.0])
    signal = Signal(own, RATE)
    assert signal.samples.dtype == np.float64
    assert signal.duration == 3 / RATE
    with pytest.raises(ValueError, match="read-only"):
        signal.samples[0] = 5.0
    own[0] = 7.0  # the caller's array stays the caller's


def test_whole_numbers_become_floating_point() -> None:
    assert Signal(np.array([1, 2], dtype=np.int16), 8).samples.tolist() == [1.0, 2.0]


@pytest.mark.parametrize(
    ("quantity", "unit", "factor"),
    [
        ("acceleration", "g", 9.80665),
        ("acceleration", "m/s^2", 1.0),
        ("velocity", "mm/s", 1e-3),
        ("velocity", "in/s", 0.0254),
        ("displacement", "um", 1e-6),
        ("displacement", "mil", 25.4e-6),
        ("unknown", "V", 1.0),
    ],
)
def test_units(quantity: Any, unit: str, factor: float) -> None:
    signal = Signal(np.array([1.0, -2.0]), RATE, quantity, unit).in_si
    assert signal.samples == pytest.approx([factor, -2.0 * factor])
    assert signal.in_si is signal


@pytest.mark.parametrize(
    ("wrong", "field"),
    [
        ({"samples": []}, "samples"),
        ({"samples": [[1.0, 2.0]]}, "samples"),
        ({"samples": [1.0, float("nan")]}, "samples"),
        ({"samples": [1.0, float("inf")]}, "samples"),
        ({"samples": ["a"]}, "samples"),
        ({"samples": [1j]}, "samples"),
        ({"samples": [[1.0], [1.0, 2.0]]}, "samples"),
        ({"samples": [1e300]}, "samples"),
        ({"rate": 0.0}, "rate"),
        ({"rate": float("nan")}, "rate"),
        ({"rate": "fast"}, "rate"),
        ({"quantity": "acelleration"}, "quantity"),
        ({"quantity": "velocity", "unit": "g"}, "unit"),
        ({"quantity": "velocity"}, "unit"),
        ({"unit": 5}, "unit"),
        ({"speed": [1.0, 2.0, 3.0]}, "speed"),
        ({"speed": float("nan")}, "speed"),
        ({"title": "x" * 1000}, "title"),
    ],
)
def test_what_is_refused(wrong: dict[str, Any], field: str) -> None:
    given: dict[str, Any] = {"samples": [1.0, 2.0], "rate": RATE, **wrong}
    with pytest.raises(InputError) as caught:
        Signal(**given)
    assert caught.value.field == field
    assert str(caught.value)


def test_speed_of_a_signal() -> None:
    assert isnan(Signal([1.0, 2.0], RATE).mean_speed)
    assert Signal([1.0, 2.0], RATE, speed=np.array([10.0, 20.0])).mean_speed == 15.0
    assert Signal([1.0, 2.0], RATE, speed=np.float64(10.0)).mean_speed == 10.0


def test_a_sine_has_its_amplitude_on_its_line() -> None:
    found = amplitude_spectrum(Signal(3.0 + sine(250.0, 2.0), RATE, unit="V"))
    assert found.axis[500] == pytest.approx(250.0)
    assert found.values[500] == pytest.approx(2.0)
    assert found.values[0] == pytest.approx(3.0)
    assert np.delete(found.values, [0, 500]).max() < 1e-9
    assert (found.unit, found.axis_unit) == ("V", "Hz")


@pytest.mark.parametrize("count", [999, 1000])
def test_parseval(count: int) -> None:
    samples = np.random.default_rng(1).normal(size=count) + 0.3
    found = power_density(Signal(samples, RATE))
    assert np.sum(found.values) * found.resolution == pytest.approx(np.mean(samples**2))


def test_averaged_density_of_white_noise() -> None:
    noise = np.random.default_rng(2).normal(size=200_000)
    found = averaged_density(Signal(noise, RATE), 50.0)
    assert found.resolution == pytest.approx(50.0)
    inside = found.values[2:-2]
    assert np.mean(inside) == pytest.approx(2.0 / RATE, rel=0.01)
    assert np.std(inside) / np.mean(inside) < 1.5 / sqrt(found.averages)


def test_indicators_of_a_sine() -> None:
    found = indicators(Signal(5.0 + sine(100.0, 2.0), RATE, unit="V"))
    assert found.mean == pytest.approx(5.0)
    assert found.rms == pytest.approx(2.0 / sqrt(2.0))
    assert found.peak == pytest.approx(2.0)
    assert found.peak_to_peak == pytest.approx(4.0)
    assert found.crest == pytest.approx(sqrt(2.0))
    assert found.shape == pytest.approx(pi / (2.0 * sqrt(2.0)), rel=1e-3)
    assert found.impulse == pytest.approx(pi / 2.0, rel=1e-3)
    assert found.skewness == pytest.approx(0.0, abs=1e-9)
    assert found.kurtosis == pytest.approx(1.5)


def test_indicators_of_noise_and_of_blows() -> None:
    noise = np.random.default_rng(3).normal(size=400_000)
    plain = indicators(Signal(noise, RATE))
    assert plain.kurtosis == pytest.approx(3.0, abs=0.05)
    assert plain.shape == pytest.approx(sqrt(pi / 2.0), rel=5e-3)
    noise[::4000] += 20.0
    struck = indicators(Signal(noise, RATE))
    assert struck.kurtosis > 10.0
    assert struck.skewness > 0.5
    assert struck.crest > 2.0 * plain.crest


def test_indicators_where_nothing_changes() -> None:
    found = indicators(Signal(np.full(100, 3.0), RATE))
    assert (found.mean, found.rms, found.peak) == (3.0, 0.0, 0.0)
    assert isnan(found.crest)
    assert isnan(found.kurtosis)


def test_spectral_indicators() -> None:
    tone = spectral_indicators(Signal(sine(1000.0), RATE))
    assert tone.centre == pytest.approx(1000.0, abs=0.1)
    assert tone.spread < 1.0
    assert tone.rms == pytest.approx(1.0 / sqrt(2.0))
    assert tone.flatness < 1e-3
    noise = Signal(np.random.default_rng(4).normal(size=100_000), RATE)
    white = spectral_indicators(noise)
    assert white.centre == pytest.approx(2500.0, rel=0.01)
    assert white.flatness == pytest.approx(np.exp(-np.euler_gamma), rel=0.01)
    part = spectral_indicators(noise, (1000.0, 2000.0))
    assert part.rms == pytest.approx(sqrt(0.2), rel=0.02)
    assert part.centre == pytest.approx(1500.0, rel=0.01)
    with pytest.raises(InputError, match="half the sampling rate"):
        spectral_indicators(noise, (1000.0, 6000.0))
