"""Envelopes of signals whose envelope is known, the kurtogram, and cyclic coherence."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest
from scipy import signal as scipy_signal

from rolamento.errors import InputError
from rolamento.vibration.cyclic import cyclic_coherence, enhanced_envelope_spectrum
from rolamento.vibration.demodulation import (
    analytic_signal,
    envelope,
    envelope_spectrum,
    kurtogram,
    prewhitened,
)
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import amplitude_spectrum, averaged_density, spectral_indicators

RATE = 20_000.0
COUNT = 40_000
TIME = np.arange(COUNT) / RATE
Array = np.ndarray[Any, np.dtype[np.float64]]


def modulated(carrier: float, modulation: float, depth: float) -> Array:
    return (1.0 + depth * np.cos(2 * pi * modulation * TIME)) * np.cos(2 * pi * carrier * TIME)


def struck(centre: float, rate: float, random: np.random.Generator) -> Array:
    """Blows that slip by a hundredth and ring about a frequency, in as much noise."""
    steps = RATE / rate * (1.0 + 0.01 * random.normal(size=int(COUNT * rate / RATE)))
    places = np.cumsum(steps).astype(np.int64)
    blows = np.zeros(COUNT)
    blows[places[places < COUNT]] = 1.0
    band = scipy_signal.butter(2, [centre - 250, centre + 250], "band", fs=RATE, output="sos")
    rung = scipy_signal.sosfilt(band, blows)
    return np.asarray(rung / rung.std() + random.normal(size=COUNT))


def test_envelope_of_amplitude_modulation() -> None:
    found = envelope(Signal(modulated(3000.0, 50.0, 0.6), RATE, "acceleration", "g"))
    wanted = 1.0 + 0.6 * np.cos(2 * pi * 50.0 * TIME)
    np.testing.assert_allclose(found.samples, wanted, atol=1e-9)
    assert (found.quantity, found.unit) == ("acceleration", "g")


def test_the_band_keeps_what_is_in_it() -> None:
    both = modulated(3000.0, 50.0, 0.6) + 5.0 * modulated(7000.0, 80.0, 0.9)
    found = envelope(Signal(both, RATE), (2500.0, 3500.0))
    wanted = 1.0 + 0.6 * np.cos(2 * pi * 50.0 * TIME)
    np.testing.assert_allclose(found.samples, wanted, atol=1e-9)


@pytest.mark.parametrize("count", [1000, 1001])
def test_the_real_part_is_the_signal_without_its_mean(count: int) -> None:
    samples = np.random.default_rng(1).normal(size=count)
    found = analytic_signal(Signal(samples, RATE))
    np.testing.assert_allclose(found.real, samples - samples.mean(), atol=1e-9)


def test_spectrum_of_the_squared_envelope() -> None:
    """(1 + d cos)² = 1 + d²/2 + 2d cos + (d²/2) cos 2·: two lines and no more."""
    depth = 0.6
    found = envelope_spectrum(Signal(modulated(3000.0, 50.0, depth), RATE, unit="g"))
    assert found.values[100] == pytest.approx(2.0 * depth)
    assert found.values[200] == pytest.approx(depth**2 / 2.0)
    assert np.delete(found.values, [100, 200]).max() < 1e-9
    assert found.unit == "(g)^2"
    plain = envelope_spectrum(Signal(modulated(3000.0, 50.0, depth), RATE), kind="plain")
    assert plain.values[100] == pytest.approx(depth)
    assert plain.values[200] < 1e-9


def test_half_the_sum_of_squares_is_the_variance_of_the_squared_envelope() -> None:
    noise = Signal(np.random.default_rng(2).normal(size=COUNT), RATE)
    found = envelope_spectrum(noise, (2000.0, 6000.0))
    squared = envelope(noise, (2000.0, 6000.0)).samples ** 2
    assert 0.5 * np.sum(found.values**2) == pytest.approx(np.var(squared), rel=1e-6)


def test_the_line_at_half_the_rate_counts_whole() -> None:
    """Of e² it is 0: no two lines of a band are that far apart. |·| makes it."""
    noise = Signal(np.random.default_rng(6).normal(size=100), RATE)
    assert envelope_spectrum(noise).values[-1] < 1e-12
    found = envelope_spectrum(noise, kind="plain").values
    variance = np.var(envelope(noise).samples)
    assert found[-1] > 0.01
    assert 0.5 * np.sum(found[:-1] ** 2) + found[-1] ** 2 == pytest.approx(variance, rel=1e-9)
    assert 0.5 * np.sum(found**2) != pytest.approx(variance, rel=1e-5)


def test_band_edges_on_lines() -> None:
    """Lines 1, 7 and 500 of 580 samples at 10 kHz: rounding puts some of them beyond the edge."""
    for count in (580, 1001):
        signal = Signal(np.random.default_rng(12).normal(size=count), 10_000.0)
        axis = amplitude_spectrum(signal).axis
        for first in range(1, count // 2 - 3):
            lines = np.abs(np.fft.fft(analytic_signal(signal, (axis[first], axis[first + 3]))))
            assert np.flatnonzero(lines > 1e-9).tolist() == list(range(first, first + 4))


def test_default_band_of_the_spectral_indicators_holds_half_the_rate() -> None:
    samples = np.random.default_rng(0).normal(size=580)
    found = spectral_indicators(Signal(samples, 10_000.0))
    assert found.rms == pytest.approx(np.sqrt(np.mean(samples**2)), rel=1e-12)


BANDS: list[Any] = [
    (3000.0, 3000.0), (3000.0, 2000.0), (0.0, 10_001.0), (1000.0,), "low", "ab", (3000.0, 3001.0),
    (1.0, 10**5000), (np.zeros(2), 3000.0), (float("nan"), 3000.0),
]  # fmt: skip
NO_NUMBERS: list[Any] = [10**400, -(10**400), 10**5000, np.inf, np.nan, True, "1", None]


@pytest.mark.parametrize("band", BANDS, ids=range(len(BANDS)))
def test_bands_that_are_refused(band: Any) -> None:
    with pytest.raises(InputError) as caught:
        envelope(Signal(modulated(3000.0, 50.0, 0.5), RATE), band)
    assert caught.value.field == "band"


def test_an_unknown_envelope_is_refused() -> None:
    with pytest.raises(InputError, match="squared or plain"):
        envelope_spectrum(Signal(TIME, RATE), kind="cubed")  # type: ignore[arg-type]


def test_prewhitening_gives_all_lines_one_size_and_keeps_phases() -> None:
    samples = np.random.default_rng(3).normal(size=1000) + 30.0 * np.sin(0.3 * np.arange(1000))
    found = prewhitened(Signal(samples, RATE, "velocity", "mm/s"))
    before, after = np.fft.rfft(samples), np.fft.rfft(found.samples)
    size = np.abs(after[1:-1])
    assert np.ptp(size) < 1e-9 * size.mean()
    assert np.angle(after[1:-1] / before[1:-1]) == pytest.approx(0.0, abs=1e-9)
    assert np.mean(found.samples**2) == pytest.approx(1.0)
    assert found.quantity == "unknown"


def test_prewhitening_lets_blows_stand_out_of_a_tone() -> None:
    blows = struck(5000.0, 80.0, np.random.default_rng(4))
    loud = Signal(blows + 300.0 * np.sin(2 * pi * 150.0 * TIME), RATE)
    ratios = []
    for signal in (loud, prewhitened(loud)):
        lines = envelope_spectrum(signal).values[100:220]
        ratios.append(lines[60] / np.median(lines))  # 80 Hz
    assert ratios[0] < 3.0
    assert ratios[1] > 6.0


def test_prewhitening_of_silence() -> None:
    assert np.all(prewhitened(Signal(np.zeros(100), RATE)).samples == 0.0)


@pytest.mark.parametrize("centre", [900.0, 3100.0, 5700.0, 6900.0, 9300.0])
def test_kurtogram_finds_the_band_that_rings(centre: float) -> None:
    found = kurtogram(Signal(struck(centre, 87.0, np.random.default_rng(5)), RATE))
    low, high = found.best().band
    assert low < centre < high
    assert high - low < 2000.0
    low, high = found.best("significance").band
    assert low < centre < high


def test_kurtogram_of_noise_is_as_scattered_as_it_says() -> None:
    found = kurtogram(Signal(np.random.default_rng(6).normal(size=200_000), RATE), 5)
    assert [len(level.kurtosis) for level in found.levels] == [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48]
    for level in found.levels[-4:]:
        assert np.std(level.kurtosis) / level.deviation == pytest.approx(1.0, abs=0.45)
        assert np.mean(level.kurtosis) == pytest.approx(0.0, abs=level.deviation)
    assert abs(found.best("significance").significance) < 5.0


def test_kurtogram_of_a_tone_is_minus_one_and_of_its_own_band() -> None:
    noise = 1e-4 * np.random.default_rng(7).normal(size=COUNT)
    found = kurtogram(Signal(np.sin(2 * pi * 3300.0 * TIME) + noise, RATE), 3)
    finest = found.levels[-1]
    place = int(3300.0 / finest.bandwidth)
    assert finest.kurtosis[place] == pytest.approx(-1.0, abs=1e-3)
    assert found.levels[0].kurtosis[0] == pytest.approx(-1.5, abs=1e-3)


def test_picture_of_a_kurtogram() -> None:
    found = kurtogram(Signal(np.random.default_rng(8).normal(size=5000), RATE), 2)
    picture = found.picture()
    assert picture.shape == (5, 12)
    assert np.all(picture[0] == found.levels[0].kurtosis[0])
    assert picture[-1].tolist() == np.repeat(found.levels[-1].kurtosis, 2).tolist()
    assert np.all(kurtogram(Signal(np.zeros(1000), RATE), 1).picture()[1:] == 0.0)


@pytest.mark.parametrize("count", [1000, 1001, 20_000, 33_333])
@pytest.mark.parametrize("value", [3.3, 0.1, 1e30])
def test_kurtogram_of_a_constant_is_that_of_silence(value: float, count: int) -> None:
    """What its mean leaves is rounding, with a kurtosis of 20 and more."""
    found = kurtogram(Signal(np.full(count, value), RATE))
    assert all(np.all(level.kurtosis == 0.0) for level in found.levels)


@pytest.mark.parametrize("count", [1000, 4096, 20_000])
def test_kurtogram_of_a_tone_at_half_the_rate(count: int) -> None:
    found = kurtogram(Signal(np.cos(pi * np.arange(count)), RATE))
    assert found.levels[0].kurtosis[0] == pytest.approx(-2.0)
    assert all(np.all(level.kurtosis <= 0.0) for level in found.levels)


def test_a_faint_band_still_counts() -> None:
    noise = np.random.default_rng(13).normal(size=20_000)
    faint = kurtogram(Signal(1.0 + 1e-10 * noise, RATE), 3)
    plain = kurtogram(Signal(noise, RATE), 3)
    for one, other in zip(faint.levels, plain.levels, strict=True):
        np.testing.assert_allclose(one.kurtosis, other.kurtosis, atol=1e-3)


def test_kurtogram_refuses() -> None:
    with pytest.raises(InputError, match="at least 256"):
        kurtogram(Signal(np.ones(100), RATE))
    with pytest.raises(InputError, match="integer"):
        kurtogram(Signal(np.arange(1000.0), RATE), 9)
    with pytest.raises(InputError, match="kurtosis or significance"):
        kurtogram(Signal(np.arange(1000.0), RATE)).best("size")  # type: ignore[arg-type]


@pytest.mark.parametrize("modulation", [37.0, 312.5, 440.0])
@pytest.mark.thirds
def test_coherence_of_modulated_noise(modulation: float) -> None:
    """Noise times 1 + cos αt: |γ| = 1/(1 + ½) at α, and ½·½/(1 + ½) at 2α."""
    random = np.random.default_rng(9)
    band = scipy_signal.butter(4, [4000, 6000], "band", fs=RATE, output="sos")
    noise = scipy_signal.sosfilt(band, random.normal(size=2 * COUNT))
    time = np.arange(2 * COUNT) / RATE
    samples = noise * (1.0 + np.cos(2 * pi * modulation * time))
    samples = samples + 0.01 * random.normal(size=len(time))
    found = cyclic_coherence(Signal(samples, RATE), 1000.0)
    inside = (found.carrier > 4600.0) & (found.carrier < 5400.0)
    line = int(np.argmin(np.abs(found.modulation - modulation)))
    near = found.coherence[:, line - 1 : line + 2].max(axis=1)
    assert np.mean(near[inside]) == pytest.approx(2.0 / 3.0, abs=0.1)
    twice = int(np.argmin(np.abs(found.modulation - 2 * modulation)))
    assert np.mean(found.coherence[inside, twice - 1 : twice + 2].max(axis=1)) == pytest.approx(
        1.0 / 6.0, abs=0.06
    )
    assert np.all(found.coherence[:, 0] == 1.0)
    enhanced = enhanced_envelope_spectrum(found, (4600.0, 5400.0))
    assert enhanced.values[1:].argmax() + 1 == pytest.approx(line, abs=1)
    assert np.median(enhanced.values) < 0.01


@pytest.mark.parametrize(
    ("first", "second", "level"),
    [(1003.0, 1090.0, 0.01), (3003.0, 3390.0, 1e-4), (1000.0, 1100.0, 1e-4), (500.0, 512.0, 0.0)],
)
def test_coherence_of_two_tones_stays_below_its_bound(
    first: float, second: float, level: float
) -> None:
    """What leaks of a tone to carriers far from it is not taken for modulation of theirs.

    Of scans without weights the greatest is 61, 500 and 640 of the first three.
    """
    time = np.arange(20_000) / 1e4
    noise = level * np.random.default_rng(1).normal(size=len(time))
    tones = np.sin(2 * pi * first * time) + np.sin(2 * pi * second * time)
    found = cyclic_coherence(Signal(tones + noise, 1e4), 400.0, 256)
    assert found.coherence[:, 1:].max() < 1.09
    # the carrier of the upper tone goes with the lower one, an exact distance apart
    carrier = int(np.argmin(np.abs(found.carrier - second)))
    line = int(np.argmin(np.abs(found.modulation - (second - first))))
    assert found.coherence[carrier, line - 1 : line + 2].max() > 0.4


@pytest.mark.parametrize("value", [0.1, 0.7])
def test_coherence_of_a_constant_is_none(value: float) -> None:
    """What its mean leaves is rounding, which goes together with itself."""
    found = cyclic_coherence(Signal(np.full(COUNT, value), RATE), 400.0)
    assert np.all(found.coherence[:, 1:] == 0.0)


@pytest.mark.parametrize("value", NO_NUMBERS, ids=range(len(NO_NUMBERS)))
def test_numbers_that_are_none(value: Any) -> None:
    with pytest.raises(InputError) as caught:
        averaged_density(Signal(TIME, RATE), value)
    assert caught.value.field == "resolution"
    assert "must be a number greater than 0" in str(caught.value)


def test_coherence_refuses() -> None:
    noise = Signal(np.random.default_rng(10).normal(size=COUNT), RATE)
    with pytest.raises(InputError) as caught:
        cyclic_coherence(noise, 6000.0)
    assert caught.value.field == "highest"
    with pytest.raises(InputError, match="32 windows"):
        cyclic_coherence(noise, 100.0, window=4096)
    found = cyclic_coherence(noise, 100.0)
    with pytest.raises(InputError, match="no carrier"):
        enhanced_envelope_spectrum(found, (101.0, 102.0))
