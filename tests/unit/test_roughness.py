"""Roughness of a profile: the filter's transmissions, the parameters of a sine, what is refused."""

from __future__ import annotations

from math import pi, sqrt
from typing import Any

import numpy as np
import pytest

from rolamento.errors import InputError
from rolamento.lubrication.roughness import (
    gaussian_mean_line,
    gaussian_transmission,
    rms_of_mean_roughness,
    roughness_of_profile,
    roughness_profile,
)

CUTOFF = 0.8e-3
SPACING = 1e-6
PLACE = np.arange(7000) * SPACING
AMPLITUDE = 1e-6


def sine(wavelength: float) -> np.ndarray[Any, np.dtype[np.float64]]:
    return AMPLITUDE * np.sin(2.0 * pi * PLACE / wavelength)


@pytest.mark.parametrize(
    ("part", "transmission"), [(1.0, 0.5), (0.5, 0.9375), (2.0, 0.15910), (0.25, 1.0 - 0.5**16)]
)
def test_transmission_of_the_roughness(part: float, transmission: float) -> None:
    """A wave of the cut-off's length loses half of its height, one of half of it a sixteenth."""
    wavelength = part * CUTOFF
    middle = slice(2000, 5000)
    rough = roughness_profile(sine(wavelength), SPACING, CUTOFF)
    found = np.abs(np.fft.rfft(rough[middle][: round(2 * CUTOFF / SPACING)])).max()
    whole = np.abs(np.fft.rfft(sine(wavelength)[middle][: round(2 * CUTOFF / SPACING)])).max()
    assert found / whole == pytest.approx(transmission, abs=2e-4)
    kept = 1.0 - float(gaussian_transmission(wavelength, CUTOFF))
    assert kept == pytest.approx(transmission, abs=1e-4)


def test_parameters_of_a_short_sine() -> None:
    found = roughness_of_profile(sine(CUTOFF / 8), SPACING, CUTOFF)
    assert found.ra == pytest.approx(2.0 * AMPLITUDE / pi, rel=1e-3)
    assert found.rq == pytest.approx(AMPLITUDE / sqrt(2.0), rel=1e-3)
    assert found.rz == pytest.approx(2.0 * AMPLITUDE, rel=2e-3)
    assert found.rt == pytest.approx(2.0 * AMPLITUDE, rel=2e-3)
    assert found.sampling_lengths == 5


def test_a_gaussian_surface() -> None:
    heights = np.random.default_rng(1).normal(scale=0.1e-6, size=7000)
    found = roughness_of_profile(heights, SPACING, CUTOFF)
    assert found.rq / found.ra == pytest.approx(float(rms_of_mean_roughness(1.0)), rel=0.02)
    assert float(rms_of_mean_roughness(1.0)) == pytest.approx(1.25, rel=3e-3)
    assert found.rz < found.rt


def test_one_scratch_shows_in_rt_and_a_fifth_of_it_in_rz() -> None:
    heights = np.zeros(7000)
    heights[3500] = -10e-6
    found = roughness_of_profile(heights, SPACING, CUTOFF, form=0)
    assert found.rt == pytest.approx(10e-6, rel=0.01)
    assert found.rz == pytest.approx(2e-6, rel=0.03)


@pytest.mark.parametrize(("form", "shape"), [(0, 0), (1, 1), (2, 2)])
def test_form_is_taken_off(form: int, shape: int) -> None:
    heights = sine(CUTOFF / 20) + 1e-4 * (PLACE / PLACE[-1]) ** shape
    plain = roughness_of_profile(sine(CUTOFF / 20), SPACING, CUTOFF, form=form)
    found = roughness_of_profile(heights, SPACING, CUTOFF, form=form)
    assert found.rq == pytest.approx(plain.rq, rel=1e-4)


def test_the_mean_line_keeps_a_level_to_its_ends() -> None:
    level = np.full(2000, 3e-6)
    np.testing.assert_allclose(gaussian_mean_line(level, SPACING, CUTOFF), 3e-6, rtol=1e-12)


def test_the_mean_line_against_the_plain_sum() -> None:
    """The definition, point by point, with the weights that are inside scaled to one."""
    heights = np.random.default_rng(2).normal(size=300)
    alpha = sqrt(np.log(2.0) / pi)
    cutoff = 40 * SPACING
    found = gaussian_mean_line(heights, SPACING, cutoff)
    place = np.arange(300) * SPACING
    for index in (0, 7, 150, 299):
        distance = place - place[index]
        weights = np.exp(-pi * (distance / (alpha * cutoff)) ** 2) * (
            np.abs(distance) <= cutoff * 1.0001
        )
        assert found[index] == pytest.approx((weights * heights).sum() / weights.sum(), abs=1e-12)


def test_the_short_cutoff_takes_noise_away() -> None:
    noise = np.random.default_rng(3).normal(scale=0.05e-6, size=7000)
    wave = sine(CUTOFF / 10)
    clean = roughness_of_profile(wave, SPACING, CUTOFF)
    filtered = roughness_of_profile(wave + noise, SPACING, CUTOFF, short_cutoff=8e-6)
    raw = roughness_of_profile(wave + noise, SPACING, CUTOFF)
    assert filtered.rt < raw.rt
    assert filtered.rq == pytest.approx(clean.rq, rel=0.02)


@pytest.mark.parametrize(
    ("changes", "field"),
    [
        ({"heights": np.zeros(100)}, "heights"),
        ({"heights": np.zeros((7000, 2))}, "heights"),
        ({"heights": []}, "heights"),
        ({"heights": "rough"}, "heights"),
        ({"heights": np.full(7000, np.nan)}, "heights"),
        ({"spacing": 0.0}, "spacing"),
        ({"spacing": np.nan}, "spacing"),
        ({"cutoff": -1.0}, "cutoff"),
        ({"spacing": 0.2e-3}, "cutoff"),
        ({"short_cutoff": 1e-3}, "short_cutoff"),
        ({"sampling_lengths": 0}, "sampling_lengths"),
        ({"form": 3}, "form"),
    ],
)
def test_refuses(changes: dict[str, Any], field: str) -> None:
    arguments = {"heights": sine(CUTOFF / 20), "spacing": SPACING, "cutoff": CUTOFF} | changes
    with pytest.raises(InputError) as caught:
        roughness_of_profile(**arguments)
    assert caught.value.field == field
