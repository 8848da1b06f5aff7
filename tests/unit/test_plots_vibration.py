"""Pictures of signals and diagnoses: what stands on them, and where."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import pi
from pathlib import Path

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from rolamento import Bearing
from rolamento.plots.saving import save_figure
from rolamento.plots.vibration import (
    diagnosis_figure,
    envelope_figure,
    envelope_lines,
    kurtogram_chart,
    kurtogram_figure,
    line_threshold,
    waveform,
    waveform_figure,
)
from rolamento.vibration.diagnosis import Diagnosis, FaultOrders, diagnose
from rolamento.vibration.frequencies import nominal_frequencies
from rolamento.vibration.signal import Signal
from rolamento.vibration.synthesis import Fault, LoadDistribution, Noise, Recipe, synthesise
from rolamento.words import said, speaking

FREQUENCIES = nominal_frequencies(Bearing.named("6205"), 1797.0 * pi / 30.0)
ORDERS = FaultOrders.of(FREQUENCIES)


@cache
def outer() -> tuple[Signal, Diagnosis]:
    recipe = Recipe(
        frequencies=FREQUENCIES, faults=(Fault(kind="outer_race"),), noise=Noise(ratio=3.0),
        duration=5.0, rate=12_000.0,
    )  # fmt: skip
    signal = synthesise(recipe).signal
    return signal, diagnose(signal, ORDERS)


@cache
def inner() -> Diagnosis:
    recipe = Recipe(
        frequencies=FREQUENCIES, faults=(Fault(kind="inner_race"),), noise=Noise(ratio=3.0),
        load=LoadDistribution.radial(), duration=5.0, rate=12_000.0,
    )  # fmt: skip
    return diagnose(synthesise(recipe).signal, ORDERS)


@cache
def healthy() -> tuple[Signal, Diagnosis]:
    samples = np.random.default_rng(3).normal(size=60_000)
    signal = Signal(samples, 12_000.0, "acceleration", "m/s^2", outer()[0].speed)
    return signal, diagnose(signal, ORDERS)


def labels(axes: Axes) -> set[str]:
    return set(axes.get_legend_handles_labels()[1])


def places(axes: Axes, label: str) -> list[float]:
    found = [line for line in axes.get_lines() if line.get_label() == label]
    return [float(x) for line in found for x in np.atleast_1d(line.get_xdata())]


def heights(axes: Axes, label: str) -> list[float]:
    found = [line for line in axes.get_lines() if line.get_label() == label]
    return [float(y) for line in found for y in np.atleast_1d(line.get_ydata())]


class TestEnvelope:
    def test_marks_stand_on_the_planted_lines(self) -> None:
        axes = envelope_lines(outer()[1])
        expected = FREQUENCIES.ball_pass_outer.frequency
        found = places(axes, "outer race, found")
        assert found[0] == pytest.approx(expected, rel=2e-3)
        assert found == pytest.approx([found[0] * (i + 1) for i in range(len(found))])
        assert max(heights(axes, "outer race, found")) > line_threshold(outer()[1])

    def test_other_parts_are_shown_where_they_were_looked_for(self) -> None:
        axes = envelope_lines(outer()[1])
        assert "inner race, found" not in labels(axes)
        assert places(axes, "inner race, expected")[0] == pytest.approx(
            FREQUENCIES.ball_pass_inner.frequency
        )

    def test_sidebands_are_a_turn_of_the_shaft_away(self) -> None:
        axes = envelope_lines(inner())
        middle = places(axes, "inner race, found")[0]
        sides = np.array(places(axes, "inner race, sidebands"))
        shaft = FREQUENCIES.shaft_frequency
        assert np.min(np.abs(sides - middle - shaft)) < 0.02 * shaft
        assert np.min(np.abs(sides - middle + shaft)) < 0.02 * shaft

    def test_band_is_the_one_of_the_fault(self) -> None:
        diagnosis = outer()[1]
        fault = diagnosis.clearest_fault
        assert fault is not None
        assert diagnosis.spectra.bands[diagnosis.clearest_band] == fault.band

    def test_nothing_found_marks_nothing_as_found(self) -> None:
        axes = envelope_lines(healthy()[1])
        assert healthy()[1].clearest_fault is None
        assert not any(label.endswith("found") for label in labels(axes))
        assert {"outer race, expected", "cage, expected"} <= labels(axes)

    def test_threshold_is_where_one_line_alone_is_a_fault(self) -> None:
        diagnosis = healthy()[1]
        assert diagnosis.blocks == 1
        ratio = 10.0 ** (0.1 * line_threshold(diagnosis))
        # of one spectrum, exponential noise: exp(-ratio), a little more as the level is estimated
        plain = np.log(diagnosis.trials / diagnosis.false_alarm)
        assert plain < ratio < 1.15 * plain
        stricter = replace(diagnosis, false_alarm=1e-4)
        assert line_threshold(stricter) > line_threshold(diagnosis)

    def test_means_of_many_blocks_have_a_lower_threshold(self) -> None:
        diagnosis = healthy()[1]
        assert line_threshold(replace(diagnosis, blocks=10)) < line_threshold(diagnosis) - 3.0

    def test_without_any_line_the_frame_says_so(self) -> None:
        diagnosis = healthy()[1]
        nothing = np.full_like(diagnosis.spectra.above_noise, np.nan)
        empty = replace(diagnosis, spectra=replace(diagnosis.spectra, above_noise=nothing))
        axes = envelope_lines(empty)
        assert (
            axes.texts[0].get_text().replace("\n", " ") == "The signal allows no envelope spectrum."
        )


class TestKurtogram:
    def test_frame_is_about_the_resonance(self) -> None:
        signal = outer()[0]
        figure = kurtogram_figure(signal, band=(3000.0, 4500.0), title="x")
        best, fault = figure.axes[0].get_lines()
        assert str(best.get_label()).startswith("stands out")
        assert np.min(best.get_xdata()) < 3500.0 < np.max(best.get_xdata())
        assert np.min(fault.get_xdata()) == 3000.0

    def test_columns_end_at_half_the_rate(self) -> None:
        axes = kurtogram_figure(outer()[0]).axes[0]
        assert axes.get_xlim() == (0.0, 6000.0)

    @pytest.mark.parametrize("samples", [np.ones(5000), np.arange(100.0)])
    def test_too_little_is_said(self, samples: np.ndarray) -> None:
        axes = kurtogram_figure(Signal(samples, 1000.0)).axes[0]
        assert "The signal is too short for a kurtogram." in axes.texts[0].get_text().replace(
            "\n", " "
        )

    def test_none_is_an_empty_frame(self) -> None:
        assert not kurtogram_chart(None).series


class TestWaveform:
    def test_marks_are_a_period_apart_and_at_the_blows(self) -> None:
        rate, period = 10_000.0, 0.02
        samples = np.zeros(4000)
        samples[60::200] = 1.0  # 6 ms after the beginning, every 20 ms
        axes = waveform(Signal(samples, rate), period=period, part="cage")
        marks = [line.get_xdata()[0] for line in axes.get_lines() if line.get_linestyle() == ":"]
        assert np.diff(marks) == pytest.approx(period)
        assert marks[0] == pytest.approx(0.006, abs=period / 40.0)
        assert len(marks) == 20

    def test_long_signals_keep_their_extremes(self) -> None:
        samples = np.zeros(1_000_000)
        samples[123_456] = 7.0
        axes = waveform(Signal(samples, 1e5))
        assert not axes.get_lines()
        drawn = axes.collections[0].get_paths()[0].vertices
        assert np.max(np.asarray(drawn)[:, 1]) == 7.0
        assert len(np.asarray(drawn)) < 10_000

    def test_span_is_shown(self) -> None:
        axes = waveform(outer()[0], span=(1.0, 1.5))
        assert axes.get_xlim() == pytest.approx((1.0, 1.5))

    def test_unit_stands_beside_the_axis(self) -> None:
        with speaking("pt"):
            figure = waveform_figure(outer()[0], title="x")
        assert figure.axes[0].get_ylabel() == "Aceleração (m/s²)"

    def test_period_longer_than_the_record_is_not_marked(self) -> None:
        axes = waveform(Signal(np.arange(100.0), 100.0), period=5.0)
        assert len(axes.get_lines()) == 1


class TestWhole:
    @pytest.mark.parametrize("language", ["en", "pt"])
    def test_one_above_the_other(self, language: str) -> None:
        signal, diagnosis = outer()
        with speaking(language):
            figure = diagnosis_figure(signal, diagnosis, title="$x$ <&>")
            words = [f"{said('Time')} (s)", *[f"{said('Frequency')} (Hz)"] * 2]
        below = [axes.get_xlabel() for axes in figure.axes if axes.get_xlabel()]
        assert below == words
        race = "outer race" if language == "en" else "pista externa"
        assert any(race in label for label in labels(figure.axes[0]))

    def test_of_nothing_found_all_the_waveform_is_shown(self) -> None:
        signal, diagnosis = healthy()
        axes = diagnosis_figure(signal, diagnosis).axes[0]
        assert axes.get_xlim() == pytest.approx((0.0, signal.duration))

    @pytest.mark.parametrize("kind", ["png", "svg", "pdf"])
    @pytest.mark.thirds
    def test_same_picture_same_bytes(self, tmp_path: Path, kind: str) -> None:
        def drawn() -> Figure:
            with speaking("pt"):
                return envelope_figure(inner(), title="x")

        for name in "ab":
            save_figure(drawn(), tmp_path / f"{name}.{kind}")
        assert (tmp_path / f"a.{kind}").read_bytes() == (tmp_path / f"b.{kind}").read_bytes()
