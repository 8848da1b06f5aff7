"""Laws of vibration analysis: Parseval, known envelopes, scale, time reversal, orders, anderons."""

from __future__ import annotations

from itertools import pairwise
from math import isnan, log2, log10, pi, sqrt
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from rolamento import Bearing
from rolamento.vibration.anderon import (
    BANDS,
    SPEED,
    anderons_of_velocity,
    measure_noise,
    velocity_of_anderons,
)
from rolamento.vibration.cyclic import cyclic_coherence, enhanced_envelope_spectrum
from rolamento.vibration.demodulation import (
    analytic_signal,
    envelope,
    envelope_spectrum,
    kurtogram,
    prewhitened,
)
from rolamento.vibration.frequencies import (
    FAULTS,
    FaultFrequencies,
    line_orders,
    nominal_frequencies,
    turns_of,
)
from rolamento.vibration.order_tracking import (
    AngularSignal,
    order_spectrum,
    order_tracked,
    revolutions_of,
)
from rolamento.vibration.separation import separate
from rolamento.vibration.shaft_speed import estimate_speed, pulse_times, speed_from_pulses
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import (
    Spectrum,
    amplitude_spectrum,
    averaged_density,
    bins_of_band,
    indicators,
    power_density,
    spectral_indicators,
)
from rolamento.vibration.synthesis import (
    Fault,
    Noise,
    Recipe,
    SwingingSpeed,
    Synthesis,
    WanderingSpeed,
    synthesise,
)

Array = np.ndarray[Any, np.dtype[np.float64]]

RATE = 10_000.0
FEW = settings(max_examples=20)
FEWEST = settings(max_examples=6)
COUNTS = st.integers(64, 700)
SEEDS = st.integers(0, 10_000)
SCALES = st.floats(-40.0, 40.0).map(lambda power: 10.0**power)
"""The greatest sample that a signal may have is 1e60."""


def noise(count: int, seed: int, level: float = 0.4) -> Array:
    return level + np.random.default_rng(seed).normal(size=count)


def struck(count: int, seed: int) -> Array:
    """Noise, and blows in it that ring."""
    random = np.random.default_rng(seed)
    found = random.normal(size=count)
    ringing = 8.0 * np.exp(-np.arange(60) / 12.0) * np.sin(1.8 * np.arange(60))
    for place in random.integers(0, count - 60, count // 200):
        found[place : place + 60] += ringing
    return found


# --- Parseval ------------------------------------------------------------------------------------


def power_of_amplitudes(values: Array, count: int) -> float:
    """Mean square of a record whose lines have these amplitudes."""
    total = values[0] ** 2 + 0.5 * np.sum(values[1:] ** 2)
    return float(total + (0.5 * values[-1] ** 2 if count % 2 == 0 else 0.0))


@given(COUNTS, SEEDS)
def test_parseval_of_amplitudes_and_density(count: int, seed: int) -> None:
    samples = noise(count, seed)
    square = float(np.mean(samples**2))
    lines = amplitude_spectrum(Signal(samples, RATE)).values
    assert power_of_amplitudes(lines, count) == pytest.approx(square, rel=1e-12)
    density = power_density(Signal(samples, RATE))
    assert np.sum(density.values) * density.resolution == pytest.approx(square, rel=1e-12)


@given(COUNTS, SEEDS, st.floats(0.5, 300.0))
def test_parseval_of_orders(count: int, seed: int, per_turn: float) -> None:
    angular = AngularSignal(noise(count, seed), per_turn, "unknown", "", "")
    found = order_spectrum(angular)
    square = np.mean(angular.samples**2)
    assert power_of_amplitudes(found.values, count) == pytest.approx(square, rel=1e-12)
    assert found.axis[-1] <= 0.5 * per_turn * (1.0 + 1e-12)


@given(COUNTS, SEEDS)
def test_parseval_of_one_segment_of_the_averaged_density(count: int, seed: int) -> None:
    """Of a segment, the mean square weighted by the window's square."""
    samples = noise(count, seed)
    found = averaged_density(Signal(samples, RATE), RATE / count)
    window = 0.5 - 0.5 * np.cos(2.0 * pi * np.arange(count) / count)
    weighted = np.sum((window * (samples - samples.mean())) ** 2) / np.sum(window**2)
    assert np.sum(found.values) * found.resolution == pytest.approx(weighted, rel=1e-12)


@given(COUNTS, SEEDS, st.sampled_from(["squared", "plain"]))
def test_parseval_of_the_envelope(count: int, seed: int, kind: Any) -> None:
    signal = Signal(noise(count, seed), RATE)
    found = envelope_spectrum(signal, kind=kind).values
    size = envelope(signal).samples ** (2 if kind == "squared" else 1)
    assert power_of_amplitudes(found, count) == pytest.approx(np.var(size), rel=1e-9)
    assert found[0] == pytest.approx(0.0, abs=1e-12 * np.max(found))


@given(COUNTS, SEEDS, st.lists(st.floats(10.0, 4990.0), min_size=1, max_size=4, unique=True))
def test_bands_share_the_power_of_a_signal(count: int, seed: int, cuts: list[float]) -> None:
    signal = Signal(noise(count, seed), RATE)
    lines = RATE / count
    edges = [0.0, *sorted(cuts), 0.5 * RATE]
    assume(min(np.diff(edges)) > 2.0 * lines)
    # no edge on a line, which would belong to both sides
    assume(all(abs(cut / lines - round(cut / lines)) > 1e-5 for cut in cuts))
    parts = [spectral_indicators(signal, band) for band in pairwise(edges)]
    square = np.mean(signal.samples**2)
    assert sum(part.rms**2 for part in parts) == pytest.approx(square, rel=1e-12)
    assert all(part.band[0] <= part.centre <= part.band[1] + 1e-6 for part in parts)
    assert all(0.0 <= part.flatness <= 1.0 for part in parts)


@given(COUNTS, SEEDS, st.integers(1, 60), st.integers(5, 60))
def test_the_analytic_signal_has_the_power_of_its_band_twice(
    count: int, seed: int, first: int, width: int
) -> None:
    first, last = min(first, count // 4), min(first + width, (count - 1) // 2)
    assume(last - first >= 4)
    band = ((first - 0.5) * RATE / count, (last + 0.5) * RATE / count)
    signal = Signal(noise(count, seed), RATE)
    found = np.mean(np.abs(analytic_signal(signal, band)) ** 2)
    assert found == pytest.approx(2.0 * spectral_indicators(signal, band).rms ** 2, rel=1e-12)


@given(COUNTS, SEEDS, st.floats(1.0, 1e5), st.integers(0, 300), st.integers(4, 300))
def test_a_band_read_off_the_axis_has_the_lines_of_its_edges(
    count: int, seed: int, rate: float, first: int, width: int
) -> None:
    """Wherever rounding puts lines and edges; half the rate and zero frequency among them."""
    first, last = min(first, count // 2 - 5), min(first + width, count // 2)
    assume(last - first >= 5)
    signal = Signal(noise(count, seed), rate)
    density = power_density(signal)
    band = (float(density.axis[first]), min(float(density.axis[last]), 0.5 * rate))
    assert np.count_nonzero(bins_of_band(density.axis, band)) == last - first + 1
    power = np.sum(density.values[first : last + 1]) * density.resolution
    assert spectral_indicators(signal, band).rms == pytest.approx(np.sqrt(power), rel=1e-9)
    lines = np.abs(np.fft.fft(analytic_signal(signal, band)))
    assert np.flatnonzero(lines > 1e-9 * np.max(lines))[0] == max(first, 1)
    assert np.flatnonzero(lines > 1e-9 * np.max(lines))[-1] == last


# --- envelopes that are known ---------------------------------------------------------------------


@st.composite
def modulations(draw: st.DrawFn) -> tuple[int, int, int]:
    """Samples, line of a carrier and line of its modulation, side bands within half the rate."""
    count = draw(st.integers(100, 900))
    modulation = draw(st.integers(1, count // 12))
    carrier = draw(st.integers(2 * modulation + 1, (count - 1) // 2 - 2 * modulation))
    return count, carrier, modulation


@given(modulations(), st.floats(0.0, 0.999), st.floats(0.0, 6.3), st.floats(0.1, 9.0))
def test_envelope_of_amplitude_modulation(
    lines: tuple[int, int, int], depth: float, phase: float, size: float
) -> None:
    count, carrier, modulation = lines
    turn = 2.0 * pi * np.arange(count) / count
    wanted = size * (1.0 + depth * np.cos(modulation * turn + phase))
    samples = wanted * np.cos(carrier * turn - 0.7)
    found = envelope(Signal(samples + 3.0, RATE)).samples
    np.testing.assert_allclose(found, wanted, atol=1e-10 * size)
    # (1 + d cos)² = 1 + d²/2 + 2d cos + (d²/2) cos 2·
    squared = envelope_spectrum(Signal(samples, RATE)).values
    assert squared[modulation] == pytest.approx(2.0 * depth * size**2, abs=1e-9 * size**2)
    assert squared[2 * modulation] == pytest.approx(0.5 * (depth * size) ** 2, abs=1e-9 * size**2)
    rest = np.delete(squared, [modulation, 2 * modulation])
    assert np.max(rest) < 1e-9 * size**2
    plain = envelope_spectrum(Signal(samples, RATE), kind="plain").values
    assert plain[modulation] == pytest.approx(depth * size, abs=1e-9 * size)


@given(
    st.integers(100, 900),
    st.tuples(st.integers(1, 49), st.integers(1, 49)),
    st.tuples(st.floats(0.1, 5.0), st.floats(0.1, 5.0)),
)
def test_envelope_of_a_beat(count: int, lines: tuple[int, int], sizes: tuple[float, float]) -> None:
    """Two tones: √(a² + b² + 2ab cos Δ); its square has one line, at the difference."""
    assume(lines[0] != lines[1])
    (a, b), apart = sizes, abs(lines[0] - lines[1])
    turn = 2.0 * pi * np.arange(count) / count
    signal = Signal(a * np.cos(lines[0] * turn) + b * np.cos(lines[1] * turn), RATE)
    wanted = a**2 + b**2 + 2.0 * a * b * np.cos(apart * turn)
    np.testing.assert_allclose(envelope(signal).samples ** 2, wanted, atol=1e-9)
    found = envelope_spectrum(signal).values
    assert found[apart] == pytest.approx(2.0 * a * b, rel=1e-9)
    assert np.max(np.delete(found, apart)) < 1e-9


@FEW
@given(st.floats(0.05, 0.2), st.floats(0.25, 0.4), st.booleans(), st.floats(0.3, 3.0))
def test_envelope_of_a_chirp_is_its_bell(low: float, high: float, falls: bool, size: float) -> None:
    """A bell wide against a period: its spectrum does not reach down to zero frequency."""
    count = 4000
    place = np.arange(count) / count
    bell = size * np.exp(-0.5 * ((place - 0.5) * 12.0) ** 2)
    first, last = (high, low) if falls else (low, high)
    phase = 2.0 * pi * count * (first * place + 0.5 * (last - first) * place**2)
    found = envelope(Signal(bell * np.cos(phase), RATE)).samples
    np.testing.assert_allclose(found, bell, atol=1e-6 * size)


@given(modulations(), st.floats(0.0, 0.9))
def test_a_band_without_one_side_band_halves_the_modulation(
    lines: tuple[int, int, int], depth: float
) -> None:
    """Carrier and one side band of d/2: |1 + (d/2) exp|², whose line is d, not 2d."""
    count, carrier, modulation = lines
    assume(modulation >= 5)
    turn = 2.0 * pi * np.arange(count) / count
    samples = (1.0 + depth * np.cos(modulation * turn)) * np.cos(carrier * turn)
    band = ((carrier - 0.5) * RATE / count, (carrier + modulation + 0.5) * RATE / count)
    found = envelope_spectrum(Signal(samples, RATE), band).values
    assert found[modulation] == pytest.approx(depth, abs=1e-9)
    assert np.max(np.delete(found, modulation)) < 1e-9


# --- scale, unit, time reversal -------------------------------------------------------------------


@FEW
@given(SCALES, SEEDS)
def test_what_has_a_unit_scales_and_what_has_none_stays(scale: float, seed: int) -> None:
    plain = Signal(struck(3000, seed), RATE)
    scaled = Signal(scale * plain.samples, RATE)
    for kind, power in (("squared", 2), ("plain", 1)):
        one = envelope_spectrum(plain, (1000.0, 4000.0), kind=kind).values  # type: ignore[arg-type]
        other = envelope_spectrum(scaled, (1000.0, 4000.0), kind=kind).values  # type: ignore[arg-type]
        np.testing.assert_allclose(other, scale**power * one, rtol=1e-6, atol=1e-9 * scale**power)
    for one_level, other_level in zip(
        kurtogram(plain).levels, kurtogram(scaled).levels, strict=True
    ):
        np.testing.assert_allclose(other_level.kurtosis, one_level.kurtosis, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(prewhitened(scaled).samples, prewhitened(plain).samples, atol=1e-9)
    one_set, other_set = indicators(plain), indicators(scaled)
    for name in ("crest", "shape", "impulse", "clearance", "skewness", "kurtosis"):
        assert getattr(other_set, name) == pytest.approx(getattr(one_set, name), rel=1e-9)
    for name in ("mean", "rms", "peak", "peak_to_peak"):
        assert getattr(other_set, name) == pytest.approx(scale * getattr(one_set, name), rel=1e-9)
    one_bands, other_bands = spectral_indicators(plain), spectral_indicators(scaled)
    for name in ("centre", "spread", "flatness"):
        assert getattr(other_bands, name) == pytest.approx(getattr(one_bands, name), rel=1e-9)


@FEWEST
@given(SCALES, SEEDS)
def test_coherence_and_separation_do_not_see_the_size(scale: float, seed: int) -> None:
    tone = 3.0 * np.sin(0.4 * np.arange(20_000))
    plain = Signal(struck(20_000, seed) + tone, RATE)
    scaled = Signal(scale * plain.samples, RATE)
    one, other = (cyclic_coherence(signal, 200.0, 64) for signal in (plain, scaled))
    np.testing.assert_allclose(other.coherence, one.coherence, rtol=1e-6, atol=1e-9)
    parts, scaled_parts = separate(plain), separate(scaled)
    np.testing.assert_allclose(scaled_parts.gain, parts.gain, rtol=1e-6, atol=1e-12)
    np.testing.assert_allclose(
        scaled_parts.random.samples, scale * parts.random.samples, atol=1e-9 * scale
    )


@FEW
@given(SEEDS, st.sampled_from(["g", "mg", "mm/s^2"]))
def test_the_unit_does_not_matter(seed: int, unit: str) -> None:
    one = Signal(struck(2000, seed), RATE, "acceleration", unit)
    other = one.in_si
    assert other.unit == "m/s^2"
    assert indicators(other).kurtosis == pytest.approx(indicators(one).kurtosis, rel=1e-9)
    assert kurtogram(other, 2).best().band == kurtogram(one, 2).best().band
    lines = [envelope_spectrum(signal) for signal in (one, other)]
    assert int(np.argmax(lines[0].values)) == int(np.argmax(lines[1].values))
    assert [line.unit for line in lines] == [f"({unit})^2", "(m/s^2)^2"]


@FEW
@given(COUNTS, SEEDS)
def test_backwards(count: int, seed: int) -> None:
    """Spectra stay, envelopes run backwards, and so does what is pre-whitened."""
    plain = Signal(noise(count, seed), RATE)
    back = Signal(plain.samples[::-1], RATE)
    for of in (amplitude_spectrum, power_density, envelope_spectrum):
        np.testing.assert_allclose(of(back).values, of(plain).values, atol=1e-10)
    np.testing.assert_allclose(envelope(back).samples[::-1], envelope(plain).samples, atol=1e-10)
    np.testing.assert_allclose(
        prewhitened(back).samples[::-1], prewhitened(plain).samples, atol=1e-9
    )
    one, other = indicators(plain), indicators(back)
    assert (other.kurtosis, other.skewness) == pytest.approx((one.kurtosis, one.skewness))


@FEW
@given(SEEDS)
def test_the_sign_does_not_matter(seed: int) -> None:
    plain = Signal(struck(2000, seed), RATE)
    turned = Signal(-plain.samples, RATE)
    np.testing.assert_allclose(envelope(turned).samples, envelope(plain).samples, atol=1e-10)
    for one, other in zip(kurtogram(plain).levels, kurtogram(turned).levels, strict=True):
        np.testing.assert_allclose(other.kurtosis, one.kurtosis, atol=1e-9)
    assert indicators(turned).skewness == pytest.approx(-indicators(plain).skewness)


@FEWEST
@given(SEEDS, st.floats(50.0, 400.0))
def test_coherence_of_noise_is_small_and_never_above_one(seed: int, highest: float) -> None:
    """Of K about independent windows chance makes |γ|² of 1/K on the mean."""
    found = cyclic_coherence(Signal(noise(20_000, seed), RATE), highest, 64)
    inside = found.coherence[2:-2, 1:]
    windows = 1.5 * 20_000 / 64
    assert np.all(inside <= 1.0)
    assert np.mean(inside**2) < 2.0 / windows
    enhanced = enhanced_envelope_spectrum(found, (2000.0, 4000.0))
    assert enhanced.values[0] == pytest.approx(1.0)
    assert np.max(enhanced.values[1:]) < 0.1


@FEWEST
@given(
    SEEDS,
    st.floats(-12.0, 0.0),
    st.lists(st.tuples(st.floats(1.0, 4999.0), st.floats(-4.0, 4.0)), min_size=1, max_size=5),
    st.floats(10.0, 2500.0),
    st.sampled_from([16, 64, 256]),
)
def test_coherence_of_anything_stays_below_its_bound(
    seed: int, level: float, tones: list[tuple[float, float]], highest: float, window: int
) -> None:
    """Schwarz's inequality, times what interpolation between lines adds to white noise."""
    time = np.arange(9000) / RATE
    samples = 10.0**level * noise(len(time), seed)
    for frequency, power in tones:
        samples = samples + 10.0**power * np.sin(2.0 * pi * frequency * time)
    found = cyclic_coherence(Signal(samples, RATE), highest, window)
    assert np.all(found.coherence < 1.09)
    assert np.all(found.coherence >= 0.0)


# --- order tracking ------------------------------------------------------------------------------


def swept(seed: int, duration: float, rate: float) -> tuple[Array, Array]:
    """Revolutions per second and revolutions so far of a shaft that speeds up and swings."""
    random = np.random.default_rng(seed)
    time = np.arange(round(duration * rate)) / rate
    base, rise, swing = (
        random.uniform(20.0, 40.0),
        random.uniform(-0.3, 0.5),
        random.uniform(0, 0.1),
    )
    turn, phase = 2.0 * pi * random.integers(1, 4) / duration, random.uniform(0.0, 6.0)
    wave = np.cos(turn * time + phase) - np.cos(phase)
    speed = base * (1.0 + rise * time / duration + swing * np.sin(turn * time + phase))
    turns = base * (time + 0.5 * rise * time**2 / duration - swing / turn * wave)
    return speed, turns


def amplitude_at(angular: AngularSignal, order: float) -> float:
    """Amplitude at an order, whole or not, by least squares."""
    angle = 2.0 * pi * order * np.arange(len(angular.samples)) / angular.samples_per_revolution
    basis = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return float(np.hypot(*np.linalg.lstsq(basis, angular.samples, rcond=None)[0]))


def strongest(spectrum: Spectrum) -> float:
    return float(spectrum.axis[np.argmax(spectrum.values)])


SWEEPS = st.tuples(SEEDS, st.floats(0.8, 12.0), st.floats(0.1, 5.0))


@FEW
@given(SWEEPS)
def test_a_chirp_is_one_line_by_the_speed_signal(sweep: tuple[int, float, float]) -> None:
    seed, order, size = sweep
    speed, turns = swept(seed, 4.0, 5000.0)
    samples = size * np.cos(2.0 * pi * order * turns + 1.0)
    signal = Signal(samples, 5000.0, speed=2.0 * pi * speed)
    np.testing.assert_allclose(revolutions_of(signal), turns, atol=1e-4)
    found = order_tracked(signal)
    spectrum = order_spectrum(found)
    assert strongest(spectrum) == pytest.approx(order, abs=spectrum.resolution)
    assert amplitude_at(found, order) == pytest.approx(size, rel=1e-4)
    over_time = amplitude_spectrum(signal).values
    assert np.max(spectrum.values) > 0.6 * size
    assert np.max(spectrum.values) > np.max(over_time)


@FEW
@given(SWEEPS, st.integers(1, 4), st.sampled_from(["rising", "falling"]))
def test_a_chirp_is_one_line_by_the_pulses_of_a_tachometer(
    sweep: tuple[int, float, float], pulses: int, edge: Any
) -> None:
    """Between pulses the speed is that of a spline, at the ends that of the last interval.

    A little is lost of the line, more at high orders.
    """
    seed, order, size = sweep
    speed, turns = swept(seed, 4.0, 5000.0)
    random = np.random.default_rng(seed)
    tacho = 3.0 + 2.0 * np.sin(2.0 * pi * pulses * turns + 0.3)
    tacho += 0.02 * random.normal(size=len(turns))
    measured = speed_from_pulses(Signal(tacho, 5000.0, unit="V"), pulses, edge=edge)
    np.testing.assert_allclose(measured, 2.0 * pi * speed, rtol=0.05)
    inside = (turns > 3.0) & (turns < turns[-1] - 3.0)
    np.testing.assert_allclose(measured[inside], 2.0 * pi * speed[inside], rtol=0.02)
    samples = size * np.cos(2.0 * pi * order * turns)
    found = order_tracked(Signal(samples, 5000.0, speed=measured))
    spectrum = order_spectrum(found)
    assert strongest(spectrum) == pytest.approx(order, abs=spectrum.resolution)
    assert amplitude_at(found, order) == pytest.approx(size, rel=0.01)


@FEWEST
@given(SEEDS, st.floats(2.2, 8.8), st.floats(20.0, 35.0))
def test_a_tone_of_no_whole_order_is_one_line_by_the_estimated_speed(
    seed: int, order: float, mean: float
) -> None:
    """Between the ends, of which less is known: a line at its order, smeared a little."""
    assume(abs(order - round(order)) > 0.1)
    rate, random = 2000.0, np.random.default_rng(seed)
    time = np.arange(20_000) / rate
    speed = mean * (1.0 + 0.04 * np.sin(2.0 * pi * time / 8.0 + random.uniform(0.0, 6.0)))
    turns = np.cumsum(speed) / rate
    samples = 0.7 * random.normal(size=len(time)) + np.cos(2.0 * pi * order * turns)
    for harmonic in range(1, 7):
        samples += np.sin(2.0 * pi * harmonic * turns + harmonic) / harmonic
    found = estimate_speed(Signal(samples, rate), 2.0 * pi * mean)
    assert found.found
    inside = slice(3000, -3000)
    np.testing.assert_allclose(found.speed[inside], 2.0 * pi * speed[inside], rtol=0.01)
    part = Signal(samples[inside], rate, speed=found.speed[inside])
    spectrum = order_spectrum(order_tracked(part))
    near = np.abs(spectrum.axis - order) < 0.09
    place = np.flatnonzero(near)[np.argmax(spectrum.values[near])]
    assert spectrum.axis[place] == pytest.approx(order, abs=3.0 * spectrum.resolution)
    assert spectrum.values[place] > 0.4


@FEW
@given(SEEDS, st.floats(0.1, 50.0), st.floats(-20.0, 20.0))
def test_size_offset_and_sign_of_a_tachometer_do_not_matter(
    seed: int, size: float, offset: float
) -> None:
    _, turns = swept(seed, 1.0, 5000.0)
    pulses = np.sin(2.0 * pi * turns)
    plain = pulse_times(Signal(pulses, 5000.0))
    changed = pulse_times(Signal(offset + size * pulses, 5000.0))
    np.testing.assert_allclose(changed, plain, atol=1e-9)
    turned = pulse_times(Signal(-pulses, 5000.0), edge="falling")
    np.testing.assert_allclose(turned, plain, atol=1e-9)
    passed = np.interp(plain, np.arange(len(turns)) / 5000.0, turns)
    np.testing.assert_allclose(np.diff(passed), 1.0, atol=2e-3)


@FEW
@given(SEEDS, st.floats(5.0, 60.0))
def test_a_steady_shaft_is_tracked_by_doing_nothing(seed: int, turns: float) -> None:
    """With a whole number of samples per revolution."""
    per_turn = 64.0
    samples = noise(3000, seed)
    signal = Signal(samples, turns * per_turn, speed=2.0 * pi * turns)
    found = order_tracked(signal, per_turn)
    np.testing.assert_allclose(found.samples, samples[: len(found.samples)], atol=1e-6)
    assert len(found.samples) >= len(samples) - 1


# --- fault frequencies ----------------------------------------------------------------------------


@given(
    st.integers(3, 30),
    st.floats(0.02, 0.4),
    st.floats(0.0, 1.4),
    st.floats(-0.5, 0.5),
    st.floats(0.0, 0.9),
)
def test_products_and_order_of_the_fault_frequencies(
    count: int, ratio: float, angle: float, outer: float, slip: float
) -> None:
    """f_o f_i = ½ Z² γ' f_b where nothing slips; a ball meets the inner race more often."""
    found = line_orders(turns_of(ratio, angle, 1.0, outer), count)
    relative = 1.0 - outer
    product = found["ball_pass_outer"] * found["ball_pass_inner"]
    spin = -found["ball_spin"]
    assert product == pytest.approx(0.5 * count**2 * ratio * spin * relative, rel=1e-12)
    assert found["ball_pass_outer"] < found["ball_pass_inner"]
    assert found["ball_spin_twice"] == 2.0 * found["ball_spin"]
    slowed = line_orders(turns_of(ratio, angle, 1.0, outer, slip), count)
    share = slowed["ball_pass_outer"] / found["ball_pass_outer"]
    assert share == pytest.approx(1.0 - slip, rel=1e-9)
    assert slowed["ball_spin"] / found["ball_spin"] == pytest.approx(1.0 - slip, rel=1e-9)
    assert slowed["ball_pass_inner"] >= found["ball_pass_inner"]


@given(st.floats(0.02, 0.3), st.floats(0.0, 1.4), st.floats(0.2, 5.0))
def test_only_the_shape_of_a_bearing_counts(ratio: float, angle: float, size: float) -> None:
    def of(pitch: float) -> FaultFrequencies:
        bearing = Bearing(
            ball_count=8,
            ball_diameter=ratio * pitch,
            pitch_diameter=pitch,
            contact_angle=angle,
            inner_conformity=0.52,
            outer_conformity=0.52,
        )
        return nominal_frequencies(bearing, 100.0)

    one, other = of(0.05), of(0.05 * size)
    for name, line in one.lines.items():
        assert other.lines[name].order == pytest.approx(line.order, rel=1e-9)


# --- synthesis -----------------------------------------------------------------------------------

BEARING = Bearing(
    ball_count=9,
    ball_diameter=7.94e-3,
    pitch_diameter=39.04e-3,
    contact_angle=0.0,
    inner_conformity=0.52,
    outer_conformity=0.52,
)
FOUND = nominal_frequencies(BEARING, 2.0 * pi * 30.0)
KINDS = st.sampled_from(list(FAULTS))
PROFILES = st.sampled_from([None, SwingingSpeed(190.0, 0.1, 1.3), WanderingSpeed(190.0, 0.05, 0.3)])


def made(**parts: Any) -> Synthesis:
    given_parts: dict[str, Any] = {"frequencies": FOUND, "duration": 2.0, "rate": 8000.0} | parts
    return synthesise(Recipe(**given_parts))


@FEW
@given(KINDS, SEEDS, PROFILES, st.sampled_from(["white", "pink"]))
def test_one_seed_is_one_signal(kind: Any, seed: int, profile: Any, colour: Any) -> None:
    parts = {
        "faults": (Fault(kind=kind, scatter=0.2),),
        "speed": profile,
        "noise": Noise(colour=colour, ratio=0.0),
        "shaft_harmonics": (0.5, 0.2),
    }
    one, same, other = (made(seed=number, **parts) for number in (seed, seed, seed + 1))
    assert np.array_equal(one.signal.samples, same.signal.samples)
    assert np.array_equal(one.truth.faults[0].times, same.truth.faults[0].times)
    assert not np.array_equal(one.signal.samples, other.signal.samples)


@FEW
@given(KINDS, SEEDS, PROFILES, st.floats(0.0, 0.05), st.sampled_from(["cumulative", "around"]))
def test_impacts_come_as_often_as_the_fault_frequency(
    kind: Any, seed: int, profile: Any, jitter: float, slip: Any
) -> None:
    """By the shaft's angle; cumulative jitter moves the last of n by jitter √n intervals."""
    fault = Fault(kind=kind, jitter=jitter, slip=slip)
    found = made(faults=(fault,), seed=seed, speed=profile)
    truth, count = found.truth.faults[0], len(found.truth.faults[0].times)
    turns = revolutions_of(found.signal)
    passed = truth.order * float(turns[-1])
    assert abs(count - passed) < 1.5 + 5.0 * jitter * sqrt(passed)
    assert truth.frequency == pytest.approx(truth.order * turns[-1] * 8000.0 / (len(turns) - 1))
    assert np.all(np.diff(truth.times) >= 0.0)
    assert truth.times[0] >= 0.0
    assert truth.times[-1] <= found.signal.duration
    angle = np.interp(truth.times, np.arange(len(turns)) / 8000.0, turns)
    gaps = np.diff(angle) * truth.order
    # the speed is straight between samples, the angle that is read off here as well
    spread = 5.0 * jitter * (sqrt(2.0) if slip == "around" else 1.0)
    assert np.all(np.abs(gaps - 1.0) < spread + 1e-3)
    assert np.mean(gaps) == pytest.approx(1.0, abs=5.0 * jitter / sqrt(len(gaps)) + 1e-3)


@FEW
@given(KINDS, SEEDS, st.floats(-30.0, 30.0), st.sampled_from(["white", "pink"]), st.booleans())
def test_noise_as_asked_for(
    kind: Any, seed: int, ratio: float, colour: Any, of_faults: bool
) -> None:
    parts: dict[str, Any] = {"faults": (Fault(kind=kind),), "seed": seed, "shaft_harmonics": (0.7,)}
    clean = made(**parts).signal.samples
    noisy = made(noise=Noise(colour=colour, ratio=ratio,
                             of="faults" if of_faults else "signal"), **parts)  # fmt: skip
    rest = noisy.signal.samples - clean
    beside = made(**{**parts, "shaft_harmonics": ()}).signal.samples if of_faults else clean
    found = 10.0 * log10(np.mean(beside**2) / np.mean(rest**2))
    assert found == pytest.approx(ratio, abs=1e-6)
    whole = 10.0 * log10(np.mean(clean**2) / np.mean(rest**2))
    assert noisy.truth.signal_to_noise == pytest.approx(whole, abs=1e-6)
    assert noisy.truth.noise_level == pytest.approx(np.sqrt(np.mean(rest**2)), rel=1e-6)


@FEWEST
@given(st.sampled_from(["outer_race", "inner_race"]), SEEDS, st.floats(100.0, 300.0))
def test_the_envelope_of_a_fault_has_its_line_where_the_truth_says(
    kind: Any, seed: int, speed: float
) -> None:
    """Without slip the strongest line of the squared envelope is a multiple of the fault's."""
    recipe = {"faults": (Fault(kind=kind, jitter=0.0),), "seed": seed}
    frequencies = nominal_frequencies(BEARING, speed)
    found = made(frequencies=frequencies, **recipe)
    spectrum = envelope_spectrum(found.signal, (2500.0, 3990.0))
    multiple = strongest(spectrum) / found.truth.faults[0].frequency
    spacing = frequencies.spacing(kind) / frequencies.of_fault(kind).order
    nearest = round(multiple)
    sides = [nearest + n * spacing for n in (-1, 0, 1)] if spacing else [nearest]
    width = 2.0 * spectrum.resolution / found.truth.faults[0].frequency
    assert nearest >= 1 or spacing
    assert min(abs(multiple - side) for side in sides) < width


# --- anderon -------------------------------------------------------------------------------------

ANDERON_RATE = 25_600.0


def tone(frequency: float, velocity: float, duration: float = 4.0) -> Array:
    """Of an RMS velocity (m/s)."""
    time = np.arange(round(duration * ANDERON_RATE)) / ANDERON_RATE
    return velocity * sqrt(2.0) * np.cos(2.0 * pi * frequency * time + 0.4)


@FEW
@given(
    st.sampled_from(list(BANDS)),
    st.floats(0.0, 1.0),
    st.floats(0.1, 100.0),
    st.floats(0.5, 2.0),
)
def test_anderons_of_a_tone(name: Any, place: float, anderons: float, share: float) -> None:
    """An = v/(1 µin · ω · √octaves): 25.4e-9 m is a microinch."""
    low, high = BANDS[name]
    frequency = (low + 8.0) * ((high - 8.0) / (low + 8.0)) ** place
    speed = share * SPEED
    velocity = anderons * 25.4e-9 * speed * sqrt(log2(high / low))
    signal = Signal(tone(frequency, velocity), ANDERON_RATE, "velocity", "m/s", speed=speed)
    found = measure_noise(signal)
    assert found.of(name).anderons == pytest.approx(anderons, rel=2e-3)
    others = [found.of(other).anderons for other in BANDS if other != name]
    assert max(others) < 0.02 * anderons
    assert ("speed_differs" in [note.key for note in found.notes]) == (abs(share - 1.0) > 0.02)
    assert velocity_of_anderons(anderons, (low, high), speed) == pytest.approx(velocity, rel=1e-12)


@FEW
@given(st.lists(st.tuples(st.floats(60.0, 9900.0), st.floats(0.1, 5.0)), min_size=1, max_size=5))
def test_levels_of_the_bands_add_up(tones: list[tuple[float, float]]) -> None:
    """Wherever tones lie, on the edges between bands as well: Parseval."""
    assume(min([1e9, *np.diff(sorted(f for f, _ in tones))]) > 12.0)
    samples = np.sum([tone(f, 1e-6 * v) for f, v in tones], axis=0)
    found = measure_noise(Signal(samples, ANDERON_RATE, "velocity", "m/s"))
    total = sum(band.velocity**2 for band in found.bands)
    assert total == pytest.approx(sum((1e-6 * v) ** 2 for _, v in tones), rel=5e-3)
    assert [note.key for note in found.notes] == ["speed_unknown"]


@FEW
@given(st.floats(70.0, 9000.0), st.floats(0.1, 50.0))
def test_what_was_measured_does_not_matter(frequency: float, velocity: float) -> None:
    """Displacement, velocity and acceleration of one motion, in any unit."""
    turn = 2.0 * pi * frequency
    motion = tone(frequency, 1e-6 * velocity)
    levels = [
        measure_noise(Signal(samples, ANDERON_RATE, quantity, unit)).bands  # type: ignore[arg-type]
        for samples, quantity, unit in (
            (motion, "velocity", "m/s"),
            (1e6 * motion, "velocity", "um/s"),
            (motion / turn * 1e9, "displacement", "nm"),
            (motion * turn / 9.80665, "acceleration", "g"),
        )
    ]
    strong = max(range(3), key=lambda band: levels[0][band].velocity)
    for found in levels[1:]:
        assert found[strong].anderons == pytest.approx(levels[0][strong].anderons, rel=5e-3)


@given(
    st.floats(1e-3, 1e3), st.floats(10.0, 1000.0), st.floats(1.01, 50.0), st.floats(10.0, 2000.0)
)
def test_anderons_and_back(anderons: float, low: float, ratio: float, speed: float) -> None:
    band = (low, low * ratio)
    velocity = velocity_of_anderons(anderons, band, speed)
    assert anderons_of_velocity(velocity, band, speed) == pytest.approx(anderons, rel=1e-12)
    # twice as fast a shaft is half as many; twice the octaves 1/√2
    assert anderons_of_velocity(velocity, band, 2.0 * speed) == pytest.approx(0.5 * anderons)
    wide = (low, low * ratio**2)
    assert anderons_of_velocity(velocity, wide, speed) == pytest.approx(anderons / sqrt(2.0))


@FEWEST
@given(st.floats(2000.0, 19_900.0))
def test_a_band_that_the_rate_does_not_hold_has_no_level(rate: float) -> None:
    samples = np.random.default_rng(1).normal(size=round(rate))
    found = measure_noise(Signal(samples, rate, "velocity", "um/s"))
    for band in found.bands:
        assert isnan(band.anderons) == (band.band[1] > 0.5 * rate)
    assert "band_incomplete" in [note.key for note in found.notes]
