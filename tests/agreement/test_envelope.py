"""Spectra, envelopes, kurtogram, cyclic coherence and the rest beside independent ones.

The reference (`reference_envelope`, whose docstring tells why it is independent) computes by
definitions: matrices, kernels, a filter bank, quadrature demodulation, bisection. Where it is the
same mathematics by another road, the two must meet to the rounding of N² sums (`EXACT`); where it
is another estimator or filter of the same quantity, the tolerance is what that leaves open, told
at each test.

The kurtogram has a second opinion: PySDKit's `fast_kurtogram`, a port of the author's own program.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from itertools import product
from math import fsum, log2, pi, sqrt
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from scipy import stats

from rolamento.vibration.cyclic import cyclic_coherence, enhanced_envelope_spectrum
from rolamento.vibration.demodulation import (
    Kurtogram,
    KurtogramLevel,
    analytic_signal,
    envelope,
    envelope_spectrum,
    kurtogram,
    prewhitened,
)
from rolamento.vibration.order_tracking import order_spectrum, order_tracked
from rolamento.vibration.separation import separate
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import (
    amplitude_spectrum,
    averaged_density,
    indicators,
    power_density,
    spectral_indicators,
)

Array = np.ndarray[Any, np.dtype[np.float64]]

RATE = 10_000.0
EXACT = 1e-9
"""Of signals of size 1 and up to 1000 samples: sums of N² products of rounding 1e-16."""
SIZES = pytest.mark.parametrize("count", [900, 901])


@pytest.fixture(scope="module")
def reference() -> ModuleType:
    path = Path(__file__).with_name("reference_envelope.py")
    spec = importlib.util.spec_from_file_location("reference_envelope", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def noise(count: int, seed: int = 0) -> Array:
    return 0.3 + np.random.default_rng(seed).normal(size=count)


def struck(count: int, seed: int, centre: float, per_second: float = 87.0) -> Array:
    """Blows that slip by a hundredth and ring about a frequency, in noise."""
    random = np.random.default_rng(seed)
    gaps = RATE / per_second * (1.0 + 0.01 * random.normal(size=count))
    places = np.cumsum(gaps)
    time = np.arange(400) / RATE
    ringing = 6.0 * np.exp(-900.0 * time) * np.sin(2.0 * pi * centre * time)
    found = 0.7 * random.normal(size=count)
    for place in places[places < count - 400].astype(int):
        found[place : place + 400] += ringing
    return found


# --- transforms ----------------------------------------------------------------------------------


@SIZES
def test_amplitudes_and_density_of_every_line(reference: ModuleType, count: int) -> None:
    samples = noise(count)
    signal = Signal(samples, RATE)
    np.testing.assert_allclose(
        amplitude_spectrum(signal).values, reference.amplitudes(samples), atol=EXACT
    )
    np.testing.assert_allclose(
        power_density(signal).values, reference.density(samples, RATE), atol=EXACT / RATE
    )


@SIZES
@pytest.mark.parametrize("line", [1, 37, 444])
def test_one_line_by_goertzel(reference: ModuleType, count: int, line: int) -> None:
    samples = noise(count)
    found = 2.0 / count * abs(reference.goertzel(samples, line))
    assert amplitude_spectrum(Signal(samples, RATE)).values[line] == pytest.approx(found, abs=EXACT)


@pytest.mark.parametrize("resolution", [50.0, 33.0, 20.0])
def test_averaged_density_as_welch_tells_it(reference: ModuleType, resolution: float) -> None:
    samples = noise(6000)
    found = averaged_density(Signal(samples, RATE), resolution)
    size = round(RATE / resolution)
    np.testing.assert_allclose(found.values, reference.welch(samples, RATE, size), rtol=1e-9)


# --- envelopes -----------------------------------------------------------------------------------


@SIZES
def test_envelope_by_the_kernel_of_hilbert(reference: ModuleType, count: int) -> None:
    samples = noise(count)
    found = envelope(Signal(samples, RATE)).samples
    np.testing.assert_allclose(found, reference.hilbert_envelope(samples), atol=EXACT)


@SIZES
@pytest.mark.parametrize("band", [(1000.0, 3333.0), (200.0, 260.0), (100.0, 4900.0)])
def test_analytic_signal_by_the_kernel_of_the_band(
    reference: ModuleType, count: int, band: tuple[float, float]
) -> None:
    samples = noise(count)
    found = analytic_signal(Signal(samples, RATE), band)
    np.testing.assert_allclose(found, reference.band_analytic(samples, RATE, *band), atol=EXACT)


@pytest.mark.parametrize("seed", range(4))
def test_envelope_by_quadrature_demodulation(reference: ModuleType, seed: int) -> None:
    """The filter's ripple is 1e-5 of what it passes, and of what it should stop.

    All tones are whole in the record, so that the engine's has no ends.
    """
    random = np.random.default_rng(seed)
    time, low, high = np.arange(8000) / RATE, 2000.0, 3000.0
    inside = np.round(random.uniform(2100.0, 2900.0, 5) / 1.25) * 1.25
    outside = np.r_[random.uniform(50.0, 1750.0, 3), random.uniform(3250.0, 4900.0, 3)]
    outside = np.round(outside / 1.25) * 1.25
    weights = random.uniform(0.2, 2.0, 5)
    samples = sum(
        a * np.cos(2.0 * pi * f * time + random.uniform(0.0, 6.0))
        for a, f in zip(np.r_[weights, np.full(6, 5.0)], np.r_[inside, outside], strict=True)
    )
    half = 160
    found = envelope(Signal(samples, RATE), (low, high)).samples[half:-half]
    wanted = reference.quadrature_envelope(samples, RATE, low, high, half)
    tolerance = 2e-5 * (np.sum(weights) + 6 * 5.0)
    np.testing.assert_allclose(found, wanted, atol=tolerance)
    assert np.ptp(wanted) > 100.0 * tolerance


@SIZES
@pytest.mark.parametrize("kind", ["squared", "plain"])
def test_spectrum_of_the_envelope(reference: ModuleType, count: int, kind: Any) -> None:
    samples, band = noise(count), (1500.0, 3500.0)
    size = np.abs(reference.band_analytic(samples, RATE, *band))
    if kind == "squared":
        size = size**2
    found = envelope_spectrum(Signal(samples, RATE), band, kind=kind)
    np.testing.assert_allclose(found.values, reference.amplitudes(size - size.mean()), atol=EXACT)
    assert found.axis[-1] == pytest.approx(RATE / count * (count // 2))


def test_spectrum_of_the_squared_envelope_of_blows_by_demodulation(reference: ModuleType) -> None:
    """Another filter, half as strong at the band's edges and gone 83 Hz beyond them.

    A sixth of the band is passed otherwise, of which the noise is a small part: five per cent.
    """
    samples, half = struck(20_000, 1, 3000.0), 160
    ours = envelope_spectrum(Signal(samples[half:-half], RATE), (2500.0, 3500.0))
    square = reference.quadrature_envelope(samples, RATE, 2583.0, 3417.0, half) ** 2
    strong = np.flatnonzero(ours.values[100:1000] > 0.3 * np.max(ours.values[100:])) + 100
    assert len(strong) >= 4
    for line in strong:
        theirs = 2.0 / len(square) * abs(reference.goertzel(square - square.mean(), line))
        assert ours.values[line] == pytest.approx(theirs, rel=0.05)
    strongest = int(np.argmax(ours.values[100:1000])) + 100
    assert ours.axis[strongest] == pytest.approx(87.0, abs=1.5)


# --- kurtogram -----------------------------------------------------------------------------------


def of_level(found: Kurtogram, level: float) -> KurtogramLevel:
    return next(one for one in found.levels if abs(one.level - level) < 1e-9)


@pytest.mark.parametrize("count", [6000, 6007])
def test_kurtogram_by_a_filter_bank_at_the_full_rate(reference: ModuleType, count: int) -> None:
    """The same filters, never decimated, each where its band is: equal to rounding."""
    signal = Signal(struck(count, 2, 2600.0), RATE)
    found, analytic = kurtogram(signal, 3), analytic_signal(signal)
    for depth in (1, 2, 3):
        for number, halvings in enumerate(product((0, 1), repeat=depth)):
            wanted = reference.filter_bank_kurtosis(analytic, halvings, None)
            assert of_level(found, depth).kurtosis[number] == pytest.approx(wanted, abs=EXACT)
    for depth in (0, 1, 2):
        for number, halvings in enumerate(product((0, 1), repeat=depth)):
            for third in range(3):
                wanted = reference.filter_bank_kurtosis(analytic, halvings, third)
                ours = of_level(found, depth + log2(3.0)).kurtosis[3 * number + third]
                assert ours == pytest.approx(wanted, abs=EXACT)


@pytest.fixture(scope="module")
def published() -> Any:
    """PySDKit's port of the program that came with the paper; a test dependency."""
    return pytest.importorskip("pysdkit.utils")


@pytest.mark.parametrize(("seed", "centre"), [(0, 3000.0), (1, 1300.0), (2, 4200.0), (3, 700.0)])
@pytest.mark.thirds
def test_kurtogram_of_the_authors_program(published: Any, seed: int, centre: float) -> None:
    """Of one analytic signal, every band's figure is the same, but for its scatter.

    Decimated, the two take other samples of each band's envelope. In noise a figure of n values
    scatters by 2/√n; where a few great blows make it, by as much in proportion to it.
    """
    signal = Signal(struck(40_000, seed, centre), RATE)
    analytic, found = analytic_signal(signal), kurtogram(signal, 4)
    filters = published.analytic_filters()
    for level in found.levels[1:-1]:
        for number, ours in enumerate(level.kurtosis):
            middle = (number + 0.5) * level.bandwidth / RATE
            band = published.find_wav_kurt(analytic, level.level, middle, filters=filters)
            assert band["bw"] == pytest.approx(level.bandwidth / RATE)
            assert band["fc"] == pytest.approx(middle)
            scatter = level.deviation * (1.0 + abs(ours))
            assert band["kurtosis"] == pytest.approx(ours, abs=2.5 * scatter)


@pytest.mark.parametrize(("seed", "centre"), [(0, 3000.0), (1, 1300.0), (4, 2500.0)])
def test_the_authors_program_finds_the_same_band(published: Any, seed: int, centre: float) -> None:
    """Far enough from zero and half the rate; of a real signal it sees its image there.

    See `test_what_the_image_does_to_the_authors_program`. On each level the band that stands out
    most is the same, or the next one.
    """
    samples = struck(40_000, seed, centre)
    ours = kurtogram(Signal(samples, RATE), 4)
    theirs, told = published.fast_kurtogram(samples, 4, RATE)
    for row, level in enumerate(told["level_w"]):
        if level >= 2.0:
            own = of_level(ours, level).kurtosis
            their = theirs[row].reshape(len(own), -1)[:, 0]
            assert abs(int(np.argmax(own)) - int(np.argmax(their))) <= 1
            assert np.corrcoef(own, their)[0, 1] > 0.98


def test_what_the_image_does_to_the_authors_program(published: Any) -> None:
    """Blows at 700 Hz: wide filters let the image below zero in, and kurtosis nearly doubles."""
    samples = struck(40_000, 3, 700.0)
    theirs, _ = published.fast_kurtogram(samples, 1, RATE)
    ours = kurtogram(Signal(samples, RATE), 1).levels[1].kurtosis[0]
    assert theirs[1, 0] > 1.5 * ours
    assert theirs[0, 0] == pytest.approx(kurtogram(Signal(samples, RATE), 1).levels[0].kurtosis[0])


# --- cyclic coherence ----------------------------------------------------------------------------


@pytest.mark.parametrize("alpha", [37.2, 87.0, 174.1, 261.0, 390.0])
@pytest.mark.parametrize(("count", "window"), [(20_000, 128), (30_000, 256)])
@pytest.mark.thirds
def test_coherence_by_the_averaged_cyclic_periodogram(
    reference: ModuleType, count: int, window: int, alpha: float
) -> None:
    """Two estimators from one record: half as far from each other as either scatters, 1/√K.

    K = 1.5 N/N_w is the number of windows that are about independent. The systematic difference,
    the mean over the carriers, is a tenth of that.
    """
    samples = struck(count, 5, 3000.0)
    found = cyclic_coherence(Signal(samples, RATE), 400.0, window)
    line = round(alpha / float(found.modulation[1]))
    step = min(window // 8, int(RATE / (4.0 * 400.0)))
    exactly = float(found.modulation[line])
    wanted = reference.cyclic_coherence(samples, RATE, exactly, window, step)
    inside = found.carrier >= exactly + 4.0 * RATE / window
    scatter = 1.0 / sqrt(1.5 * count / window)
    off = (found.coherence[:, line] - wanted)[inside]
    assert np.max(np.abs(off)) < 0.5 * scatter
    assert abs(np.mean(off)) < 0.1 * scatter


def test_enhanced_envelope_spectrum_by_its_definition(reference: ModuleType) -> None:
    samples, band = struck(20_000, 6, 3000.0), (2500.0, 3500.0)
    found = cyclic_coherence(Signal(samples, RATE), 400.0, 128)
    enhanced = enhanced_envelope_spectrum(found, band)
    inside = (found.carrier >= band[0]) & (found.carrier <= band[1])
    for line in np.argsort(enhanced.values[5:])[-3:] + 5:
        alpha = float(found.modulation[line])
        wanted = np.mean(reference.cyclic_coherence(samples, RATE, alpha, 128, 6)[inside] ** 2)
        assert enhanced.values[line] == pytest.approx(wanted, rel=0.1)
        assert abs(alpha / 87.0 - round(alpha / 87.0)) < 0.02 * round(alpha / 87.0) + 0.02


# --- pre-whitening, order tracking, separation ----------------------------------------------------


@SIZES
def test_prewhitening_by_the_cepstrum(reference: ModuleType, count: int) -> None:
    samples = noise(count) + 5.0 * np.sin(0.3 * np.arange(count))
    found = prewhitened(Signal(samples, RATE)).samples
    np.testing.assert_allclose(found, reference.cepstrum_whitened(samples), atol=EXACT)


def run_up(time: Array) -> Array:
    """Revolutions of a shaft that goes from 10 to 18 turns a second in two."""
    return 10.0 * time + 2.0 * time**2


@pytest.mark.parametrize("per_turn", [None, 256.0, 333.3])
def test_order_tracking_by_bisection_and_windowed_sinc(
    reference: ModuleType, per_turn: float | None
) -> None:
    """Noise up to a fifth of the rate, where splines are good to 1 part in 1000."""
    rate, count = 2000.0, 3000
    lines = np.fft.rfft(np.random.default_rng(7).normal(size=count))
    lines[count // 5 :] = 0.0
    samples = np.fft.irfft(lines, count)
    speed = 2.0 * pi * (10.0 + 4.0 * np.arange(count) / rate)
    found = order_tracked(Signal(samples, rate, speed=speed), per_turn)
    wanted = reference.tracked(samples, rate, run_up, found.samples_per_revolution)
    assert len(found.samples) == len(wanted)
    known = np.isfinite(wanted)
    assert np.mean(known) > 0.95
    off = (found.samples - wanted)[known]
    assert np.max(np.abs(off)) < 1e-3 * np.std(samples)


def test_orders_of_a_run_up_by_goertzel(reference: ModuleType) -> None:
    """Orders 3 and 7.5 of the shaft, over 28 whole revolutions."""
    rate, count = 2000.0, 4001
    time = np.arange(count) / rate
    angle = 2.0 * pi * (10.0 * time + 2.0 * time**2)
    samples = 1.5 * np.cos(3.0 * angle + 0.4) + 0.5 * np.sin(7.5 * angle)
    signal = Signal(samples, rate, speed=2.0 * pi * (10.0 + 4.0 * time))
    found = order_tracked(signal, 200.0)
    whole = found.samples[: 28 * 200]
    spectrum = order_spectrum(found)
    for order, amplitude in ((3.0, 1.5), (7.5, 0.5)):
        theirs = 2.0 / len(whole) * abs(reference.goertzel(whole, 28.0 * order))
        assert theirs == pytest.approx(amplitude, rel=1e-4)
        line = round(order / spectrum.resolution)
        assert spectrum.values[line] == pytest.approx(amplitude, rel=1e-3)


def test_the_discrete_part_beside_a_fit_of_known_tones(reference: ModuleType) -> None:
    """Prediction knows no frequencies, and passes the noise of the lines that it takes.

    Of L lines that pass, noise is left with L/(N_block/2) of its power; the fit leaves 4/N.
    """
    count = 60_000
    time = np.arange(count) / RATE
    tones = 1.5 * np.sin(2.0 * pi * 30.0 * time + 0.2) + 0.8 * np.cos(2.0 * pi * 1234.5 * time)
    random = 0.2 * struck(count, 8, 3000.0)
    found = separate(Signal(tones + random, RATE))
    wanted = reference.fitted_tones(tones + random, RATE, (30.0, 1234.5))
    lines = float(np.sum(found.gain**2))
    leak = sqrt(2.0 * lines / found.block) * np.std(random)
    assert np.std(wanted - tones) < 0.02 * np.std(random)
    assert np.std(found.discrete.samples - wanted) < 1.5 * leak
    assert leak < 0.2 * np.std(random)
    assert np.std(found.random.samples) == pytest.approx(np.std(random), rel=0.02)


# --- indicators ----------------------------------------------------------------------------------


def plain_mean(function: Callable[[float], float], values: Array) -> float:
    return fsum(function(value) for value in values.tolist()) / len(values)


@pytest.mark.parametrize("seed", range(3))
def test_indicators_by_sums_and_by_scipy(seed: int) -> None:
    samples = struck(5000, seed, 2000.0) + 0.4
    found = indicators(Signal(samples, RATE))
    x = samples - fsum(samples.tolist()) / len(samples)
    rms = sqrt(plain_mean(lambda v: v * v, x))
    peak, size = max(map(abs, x.tolist())), plain_mean(abs, x)
    assert found.rms == pytest.approx(rms, rel=1e-12)
    assert found.peak == pytest.approx(peak, rel=1e-12)
    assert found.crest == pytest.approx(peak / rms, rel=1e-12)
    assert found.shape == pytest.approx(rms / size, rel=1e-12)
    assert found.impulse == pytest.approx(peak / size, rel=1e-12)
    root = plain_mean(lambda v: sqrt(abs(v)), x)
    assert found.clearance == pytest.approx(peak / root**2, rel=1e-12)
    assert found.skewness == pytest.approx(stats.skew(samples), rel=1e-10)
    assert found.kurtosis == pytest.approx(stats.kurtosis(samples, fisher=False), rel=1e-10)


@SIZES
@pytest.mark.parametrize("band", [None, (1000.0, 2500.0)])
def test_spectral_indicators_by_definition(
    reference: ModuleType, count: int, band: tuple[float, float] | None
) -> None:
    samples = noise(count, 3)
    found = spectral_indicators(Signal(samples, RATE), band)
    power = reference.density(samples, RATE)
    frequency = RATE / count * np.arange(len(power))
    low, high = band or (0.0, 0.5 * RATE)
    inside = (frequency >= low) & (frequency <= high)
    shares = stats.rv_discrete(
        values=(np.arange(np.sum(inside)), power[inside] / np.sum(power[inside]))
    )
    first, step = frequency[inside][0], RATE / count
    assert found.centre == pytest.approx(first + step * shares.mean(), rel=1e-9)
    assert found.spread == pytest.approx(step * shares.std(), rel=1e-9)
    assert found.flatness == pytest.approx(
        float(stats.gmean(power[inside]) / np.mean(power[inside])), rel=1e-9
    )
    assert found.rms == pytest.approx(sqrt(np.sum(power[inside]) * step), rel=1e-9)
