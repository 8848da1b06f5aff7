"""Noise in anderons: signals in pieces, bands of any kind, thirds of octaves, what is refused."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import isnan, pi, sqrt
from typing import Any

import numpy as np
import pytest

from rolamento.errors import InputError
from rolamento.vibration.anderon import (
    BANDS,
    SPEED,
    Noise,
    accept,
    anderons_of_velocity,
    measure_noise,
    noise_steps,
    velocity_of,
)
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import averaged_density

RATE = 25_600.0


def noise(count: int, rate: float = RATE, **parts: Any) -> Signal:
    samples = np.random.default_rng(1).normal(size=count)
    given: dict[str, Any] = {"quantity": "velocity", "unit": "um/s", "speed": SPEED} | parts
    return Signal(samples, rate, **given)


def cut(signal: Signal, *places: int) -> list[Signal]:
    """Pieces between places."""
    edges = [0, *places, len(signal.samples)]
    return [
        replace(signal, samples=signal.samples[first:last], speed=_speed_of(signal, first, last))
        for first, last in pairwise(edges)
    ]


def _speed_of(signal: Signal, first: int, last: int) -> Any:
    speed = signal.speed
    return speed if speed is None or not speed.ndim else speed[first:last]


# --- in pieces -------------------------------------------------------------------------------


@pytest.mark.parametrize("rate", [RATE, 25_601.0, 25_603.0])
@pytest.mark.parametrize(
    ("quantity", "unit"), [("velocity", "um/s"), ("acceleration", "g"), ("displacement", "nm")]
)
def test_pieces_of_any_length_are_the_whole(rate: float, quantity: Any, unit: str) -> None:
    whole = noise(100_001, rate, quantity=quantity, unit=unit)
    expected = measure_noise(whole)
    for places in ((50_000,), (1, 2, 3, 99_999), (12_800, 25_600), tuple(range(997, 100_000, 997))):
        found = measure_noise(iter(cut(whole, *places)))
        for one, other in zip(found.bands, expected.bands, strict=True):
            assert one.velocity == pytest.approx(other.velocity, rel=1e-12)
            assert one.anderons == pytest.approx(other.anderons, rel=1e-12)
        assert found.velocity.duration == pytest.approx(whole.duration)
        assert found.velocity.density.averages == expected.velocity.density.averages


def test_density_is_the_averaged_one_of_the_velocity() -> None:
    signal = noise(60_000, quantity="acceleration", unit="g")
    found = velocity_of(signal, 2.0)
    wanted = averaged_density(signal.in_si, 2.0)
    turns = 2.0 * pi * wanted.axis[1:]
    assert found.density.axis == pytest.approx(wanted.axis)
    assert found.density.values[1:] == pytest.approx(wanted.values[1:] / turns**2, rel=1e-12)
    assert found.density.values[0] == 0.0
    assert found.density.averages == (60_000 - 6400) // 6400
    assert (found.rate, found.quantity) == (RATE, "acceleration")


def test_speed_is_the_mean_over_all_samples() -> None:
    speed = SPEED * np.linspace(0.99, 1.01, 80_000)
    whole = noise(80_000, speed=speed)
    pieces = measure_noise(cut(whole, 100, 70_000))
    assert pieces.speed == pytest.approx(SPEED, rel=1e-12)
    assert measure_noise(whole).speed == pytest.approx(SPEED, rel=1e-12)
    backwards = measure_noise(noise(80_000, speed=-SPEED))
    assert backwards.speed == SPEED


@pytest.mark.parametrize(
    ("other", "field"),
    [
        ({"rate": 2.0 * RATE}, "rate"),
        ({"unit": "mm/s"}, "unit"),
        ({"quantity": "acceleration", "unit": "g"}, "quantity"),
    ],
)
def test_pieces_of_different_kinds_are_refused(other: dict[str, Any], field: str) -> None:
    with pytest.raises(InputError, match="that of the first piece") as caught:
        measure_noise([noise(30_000), replace(noise(30_000), **other)])
    assert caught.value.field == field


# --- what is refused -------------------------------------------------------------------------


@pytest.mark.parametrize("value", [0.0, 3.3, -1e-9])
def test_a_signal_that_does_not_change_is_refused_by_name(value: float) -> None:
    still = Signal(np.full(40_000, value), RATE, "velocity", "m/s", title="drive end")
    for signal in (still, cut(still, 15_000, 15_001)):
        with pytest.raises(InputError, match="is constant over 40 000 samples") as caught:
            measure_noise(signal)
        assert str(caught.value).startswith("drive end: signal = ")


@pytest.mark.parametrize(
    ("signal", "field"),
    [
        ([], "signal"),
        (noise(12_799), "duration"),
        ([noise(6000), noise(6000)], "duration"),
        (noise(30_000, quantity="unknown", unit="V"), "quantity"),
        (noise(30_000, speed=0.0), "speed"),
    ],
)
def test_signals_that_are_refused(signal: Any, field: str) -> None:
    with pytest.raises(InputError) as caught:
        measure_noise(signal)
    assert caught.value.field == field


@pytest.mark.parametrize("band", [(0.0, 50.0), (300.0, 300.0), (300.0,), "low", (50.0, np.nan)])
def test_bands_that_are_refused(band: Any) -> None:
    with pytest.raises(InputError) as caught:
        measure_noise(noise(30_000), {"mine": band})
    assert caught.value.field == "bands.mine"


# --- bands, notes, steps ---------------------------------------------------------------------


def test_bands_of_any_kind() -> None:
    """White noise of 1 µm/s: each Hz of its 12 800 holds as much."""
    bands = {"all": (1.0, 12_799.0), "octave": (4000.0, 8000.0), "beyond": (10_000.0, 20_000.0)}
    found = measure_noise(noise(400_000), bands)
    assert [band.name for band in found.bands] == list(bands)
    assert found.of("all").velocity == pytest.approx(1e-6, rel=0.01)
    assert found.of("octave").velocity == pytest.approx(1e-6 * sqrt(4000 / 12_800), rel=0.02)
    level = anderons_of_velocity(found.of("octave").velocity, bands["octave"])
    assert found.of("octave").anderons == pytest.approx(level)
    assert isnan(found.of("beyond").anderons)
    assert found.missing == ("beyond",)
    assert accept(found, {"octave": 1.0}).rejected == ()
    assert accept(found, {"beyond": 1.0}).rejected == ("beyond",)
    with pytest.raises(InputError, match="at least one of all, octave, beyond"):
        accept(found, {"low": 1.0})


@pytest.mark.parametrize(
    ("rate", "missing"), [(25_600.0, ()), (19_000.0, ("high",)), (3000.0, ("medium", "high"))]
)
def test_the_note_names_every_band_that_is_missing(rate: float, missing: tuple[str, ...]) -> None:
    found = measure_noise(noise(30_000, rate))
    assert found.missing == missing
    notes = [note for note in found.notes if note.key == "band_incomplete"]
    assert [note.values["bands"] for note in notes] == ([list(missing)] if missing else [])
    assert all(note.text.endswith(f"is too low for: {', '.join(missing)}.") for note in notes)


@pytest.mark.parametrize(
    ("rpm", "differs"),
    [(1764, False), (1763.9, True), (1818, False), (1818.1, True), (-1800, False)],
)
def test_limits_of_the_speed_are_those_of_the_standard(rpm: float, differs: bool) -> None:
    found = measure_noise(noise(30_000, speed=rpm * pi / 30.0))
    assert [note.key for note in found.notes] == ["speed_differs"] * differs


@pytest.fixture(scope="module")
def measured() -> Noise:
    return measure_noise(noise(100_000, quantity="acceleration", unit="m/s^2"))


@pytest.mark.parametrize("parts", [1, 3, 8])
def test_steps_add_up_to_the_level(measured: Noise, parts: int) -> None:
    steps = noise_steps(measured, parts)
    assert list(steps) == list(BANDS)
    for name, (edges, anderons) in steps.items():
        assert len(anderons) == parts
        assert (edges[0], edges[-1]) == pytest.approx(BANDS[name])
        assert np.ptp(np.diff(np.log(edges))) < 1e-9
        level = sqrt(float(np.mean(anderons**2)))
        assert level == pytest.approx(measured.of(name).anderons, rel=1e-9)


def test_the_step_of_a_tone_stands_out() -> None:
    time = np.arange(100_000) / RATE
    samples = sqrt(2.0) * 1e-4 * np.sin(2.0 * pi * 900.0 * time)
    steps = noise_steps(measure_noise(Signal(samples, RATE, "velocity", "m/s")))
    edges, anderons = steps["medium"]
    place = int(np.argmax(anderons))
    assert edges[place] < 900.0 < edges[place + 1]
    around = (float(edges[place]), float(edges[place + 1]))
    assert anderons[place] == pytest.approx(anderons_of_velocity(1e-4, around), rel=1e-3)
    assert np.delete(anderons, place).max() < 0.01 * anderons[place]


def test_steps_of_what_is_held(measured: Noise) -> None:
    slow = measure_noise(noise(30_000, 4000.0))
    assert list(noise_steps(slow)) == ["low", "medium"]
    for parts in (0, 10**6, 2.5):
        with pytest.raises(InputError) as caught:
            noise_steps(measured, parts)  # type: ignore[arg-type]
        assert caught.value.field == "parts"
