"""Order tracking, the shaft's speed from pulses and from the signal, discrete and random parts."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest

from rolamento.errors import InputError
from rolamento.vibration.order_tracking import (
    interpolated,
    order_spectrum,
    order_tracked,
    revolutions_of,
)
from rolamento.vibration.separation import separate
from rolamento.vibration.shaft_speed import estimate_speed, pulse_times, speed_from_pulses
from rolamento.vibration.signal import Signal

RATE = 10_000.0
TIME = np.arange(100_000) / RATE
TURNS = 20.0 * TIME + TIME**2  # 20 to 40 revolutions a second
SPEED = 2.0 * pi * (20.0 + 2.0 * TIME)
Array = np.ndarray[Any, np.dtype[np.float64]]


def test_revolutions_of_a_run_up() -> None:
    for speed in (SPEED, -SPEED):
        found = revolutions_of(Signal(TIME, RATE, speed=speed))
        np.testing.assert_allclose(found, TURNS, atol=1e-9)
    steady = revolutions_of(Signal(TIME, RATE, speed=2.0 * pi * 30.0))
    np.testing.assert_allclose(steady, 30.0 * TIME, atol=1e-9)


@pytest.mark.parametrize("per_turn", [None, 64])
def test_a_chirp_becomes_one_line(per_turn: float | None) -> None:
    """7.3 orders run from 146 to 292 Hz; over the angle they stand still."""
    signal = Signal(2.0 * np.sin(2 * pi * 7.3 * TURNS), RATE, speed=SPEED)
    tracked = order_tracked(signal, per_turn)
    assert tracked.samples_per_revolution == (per_turn or 500.0)
    assert tracked.revolutions == pytest.approx(300.0, abs=0.02)
    angle = np.arange(len(tracked.samples)) / tracked.samples_per_revolution
    inside = slice(200, -200)
    wanted = 2.0 * np.sin(2 * pi * 7.3 * angle[inside])
    # what is filtered out first leaks a little where the record ends
    allowed = 1e-4 if per_turn is None else 2e-2
    np.testing.assert_allclose(tracked.samples[inside], wanted, atol=allowed)
    found = order_spectrum(tracked)
    assert found.axis_unit == "order"
    assert found.axis[np.argmax(found.values)] == pytest.approx(7.3, abs=found.resolution)
    assert np.max(found.values) == pytest.approx(2.0, rel=0.01)
    over_time = np.abs(np.fft.rfft(signal.samples)).max() * 2.0 / len(TIME)
    assert over_time < 0.2


def test_too_few_samples_per_revolution_do_not_fold_back() -> None:
    signal = Signal(np.sin(2 * pi * 3000.0 * TIME), RATE, speed=SPEED)
    assert np.abs(order_tracked(signal, 64).samples[500:-500]).max() < 0.01


@pytest.mark.parametrize("turns", [11.0, 7.3, 0.7, 1.1, 23.0])
@pytest.mark.parametrize("per_turn", [None, 64])
def test_a_steady_shaft_is_tracked_by_doing_nothing(turns: float, per_turn: int | None) -> None:
    """At 11 turns and 704 samples a second, these are 64.00000000000001 samples a turn."""
    samples = np.random.default_rng(5).normal(size=3000)
    found = order_tracked(Signal(samples, 64.0 * turns, speed=2.0 * pi * turns), per_turn)
    assert found.samples_per_revolution == 64.0
    np.testing.assert_allclose(found.samples, samples[: len(found.samples)], atol=1e-9)
    assert len(found.samples) >= 2999


def test_interpolation_is_as_good_as_it_says() -> None:
    places = np.arange(500, 4500) + 0.5
    for part, error in ((0.1, 1e-5), (0.25, 1 / 450)):
        samples = np.sin(2 * pi * part * np.arange(5000.0))
        found = interpolated(samples, places)
        np.testing.assert_allclose(found, np.sin(2 * pi * part * places), atol=error)


@pytest.mark.parametrize(
    "speed", [None, 0.0, np.linspace(-1.0, 1.0, len(TIME)), np.linspace(1e-5, 10.0, len(TIME))]
)
def test_speeds_that_cannot_be_tracked(speed: Any) -> None:
    with pytest.raises(InputError) as caught:
        order_tracked(Signal(TIME, RATE, speed=speed))
    assert caught.value.field == "speed"


def test_impossible_numbers_of_samples() -> None:
    signal = Signal(TIME, RATE, speed=SPEED)
    for per_turn in (0.0, 1e9, 1e-9):
        with pytest.raises(InputError) as caught:
            order_tracked(signal, per_turn)
        assert caught.value.field == "samples_per_revolution"


def test_speed_from_pulses_of_a_run_up() -> None:
    random = np.random.default_rng(1)
    pulses = 5.0 * (np.mod(TURNS + 0.3, 1.0) < 0.1) + 0.1 * random.normal(size=len(TIME))
    found = speed_from_pulses(Signal(pulses, RATE))
    np.testing.assert_allclose(found[2000:-2000], SPEED[2000:-2000], rtol=5e-3)
    np.testing.assert_allclose(found, SPEED, rtol=0.02)
    four = speed_from_pulses(Signal(np.sin(2 * pi * 4 * TURNS), RATE), 4, edge="falling")
    np.testing.assert_allclose(four, SPEED, rtol=2e-3)


def test_pulse_times_lie_between_samples() -> None:
    found = pulse_times(Signal(np.sin(2 * pi * 30.0 * TIME - 0.7), RATE), level=0.0)
    wanted = (np.arange(len(found)) + 0.7 / (2 * pi)) / 30.0
    assert found == pytest.approx(wanted, abs=1e-7)


def test_pulses_that_are_refused() -> None:
    pulses = np.where((TIME > 3.02) & (TIME < 3.06), 0.0, np.mod(TURNS, 1.0) < 0.1)
    with pytest.raises(InputError, match="are uneven near"):
        speed_from_pulses(Signal(pulses, RATE))
    with pytest.raises(InputError, match="at least 4"):
        speed_from_pulses(Signal(np.zeros(1000), RATE))
    with pytest.raises(InputError, match="rising or falling"):
        pulse_times(Signal(pulses, RATE), edge="up")  # type: ignore[arg-type]


def with_harmonics(frequency: Array, level: float, seed: int) -> Signal:
    turns = np.cumsum(frequency) / RATE
    noise = np.random.default_rng(seed).normal(size=len(frequency))
    shaft = sum(level / n * np.sin(2 * pi * n * turns + n) for n in range(1, 9))
    return Signal(noise + shaft, RATE)


def test_speed_from_the_harmonics_of_the_shaft() -> None:
    frequency = 30.0 + 1.5 * np.sin(2 * pi * TIME / 6.0)
    found = estimate_speed(with_harmonics(frequency, 1.0, 2), 2.0 * pi * 29.0)
    assert found.found
    assert found.probability < 1e-9
    assert found.evidence > 9.0
    inside = slice(5000, -5000)
    np.testing.assert_allclose(found.speed[inside], 2 * pi * frequency[inside], rtol=5e-3)
    assert np.mean(found.speed) == pytest.approx(2 * pi * np.mean(frequency), rel=1e-3)


def test_noise_has_no_shaft() -> None:
    for seed in range(5):
        found = estimate_speed(with_harmonics(np.full(len(TIME), 30.0), 0.0, seed), 2 * pi * 30.0)
        assert not found.found
        assert np.all(np.isnan(found.speed))
        assert found.probability == 1.0


def test_estimates_that_are_refused() -> None:
    signal = Signal(TIME[:1000], RATE)
    with pytest.raises(InputError) as caught:
        estimate_speed(signal, 2 * pi * 30.0)
    assert caught.value.field == "record"
    with pytest.raises(InputError) as caught:
        estimate_speed(signal, 2 * pi * 3000.0)
    assert caught.value.field == "rate"
    with pytest.raises(InputError) as caught:
        estimate_speed(signal, 200.0, tolerance=0.5)
    assert caught.value.field == "tolerance"


def test_tones_and_noise_are_told_apart() -> None:
    random = np.random.default_rng(3)
    noise = random.normal(size=len(TIME))
    tones = 3.0 * np.sin(2 * pi * 30.0 * TIME) + np.sin(2 * pi * 1234.5 * TIME + 1.0)
    found = separate(Signal(tones + noise, RATE, "velocity", "mm/s"))
    parts = found.discrete.samples + found.random.samples
    np.testing.assert_allclose(parts, tones + noise, atol=1e-12)
    assert np.std(found.discrete.samples - tones) < 0.1
    assert np.std(found.random.samples - noise) < 0.1
    assert np.count_nonzero(found.gain) < 20
    assert found.discrete.unit == "mm/s"
    near = found.frequency[found.gain > 0.5]
    assert np.all((np.abs(near - 30.0) < 10.0) | (np.abs(near - 1234.5) < 10.0))


def test_noise_has_no_discrete_part() -> None:
    found = separate(Signal(np.random.default_rng(4).normal(size=len(TIME)), RATE))
    assert np.all(found.discrete.samples == 0.0)


def test_separations_that_are_refused() -> None:
    signal = Signal(TIME[:1000], RATE)
    with pytest.raises(InputError, match="a delay and three blocks"):
        separate(signal, block=400)
    for name, value in (("block", 0), ("delay", -1), ("false_alarm", 0.0)):
        with pytest.raises(InputError) as caught:
            separate(signal, **{name: value})
        assert caught.value.field == name
