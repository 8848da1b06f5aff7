"""The benchmarks of vibration run on short signals, and what they compare with finds the same."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.io import wavfile

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def bench(monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.syspath_prepend(str(ROOT))
    return importlib.import_module("benchmarks.vibration")


@pytest.mark.sweep
def test_diagnosis_and_plain_bands_find_the_same(bench: Any) -> None:
    findings = bench.measure(3.0, 1)
    assert findings.failures == []
    assert all(figure.value > 0.0 for figure in findings.figures)
    assert [figure.target for figure in findings.figures] == [None] * len(findings.figures)


def test_another_finding_is_told(bench: Any) -> None:
    plain = bench.vibration_plain
    signal = bench.synthesise(bench.recipe(3.0)).signal
    found = bench.diagnose(signal, bench.FaultOrders.of(bench.frequencies()))
    order = found.of("inner_race").order
    assert bench._complaints("it", found, plain.Match(9.0, "inner_race", order)) == []
    for part, other in (("ball", order), ("inner_race", order + 5.0 * found.resolution)):
        assert "SciPy finds" in bench._complaints("it", found, plain.Match(9.0, part, other))[0]
    noise = bench.Signal(
        np.random.default_rng(4).normal(size=50_000), bench.RATE, speed=bench.SPEED
    )
    nothing = bench.diagnose(noise, bench.FaultOrders.of(bench.frequencies()))
    assert "finds nothing" in bench._complaints("it", nothing, plain.Match(9.0, "ball", order))[0]


def test_kurtograms(bench: Any) -> None:
    findings = bench.measure_kurtogram(2.0, 1)
    assert findings.failures == []
    assert len(findings.figures) == 7


def test_a_different_kurtogram_is_told(bench: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    kept = bench.vibration_plain.kurtosis
    monkeypatch.setattr(bench.vibration_plain, "kurtosis", lambda band: kept(band) + 1e-6)
    assert "the same filters differ by" in bench.measure_kurtogram(2.0, 1).failures[0]


def test_synthesis(bench: Any) -> None:
    findings = bench.measure_synthesis(0.5, 1)
    assert findings.failures == []
    assert [figure.name for figure in findings.figures] == ["steady speed", "varying speed"]


def test_order_tracking_is_that_of_a_spline(bench: Any) -> None:
    assert bench.measure_tracking(1.0, 1).failures == []


def test_coherence_is_that_of_cross_spectra(bench: Any) -> None:
    findings = bench.measure_coherence(2.0, 1, 1)
    assert findings.failures == []
    assert "1001 modulations" in findings.figures[0].group


def test_a_recording_is_read_from_its_file(bench: Any, tmp_path: Path) -> None:
    path = tmp_path / "recording.npy"
    bench.write_recording(path, 0.25)
    samples = np.load(path)
    assert len(samples) == 15 * bench.RATE
    assert np.std(samples) > 0.0
    # the damage comes again, its noise does not
    once, again = samples[: len(samples) // 3], samples[2 * len(samples) // 3 :]
    # as much is alike as is damage: half of the power
    assert np.corrcoef(once, again)[0, 1] == pytest.approx(0.5, abs=0.1)
    found = bench.diagnose_file(str(path))
    assert found["faults"] == ["inner_race"]
    assert found["megabytes"] > 10.0


@pytest.mark.slow
@pytest.mark.sweep
def test_recordings_in_a_process_of_their_own(bench: Any) -> None:
    findings = bench.measure_recording(0.5, 0.75)
    assert findings.failures == []
    values = {figure.name: figure.value for figure in findings.figures}
    assert values["peak memory, 0.75 min"] > 10.0


@pytest.mark.sweep
def test_a_process_that_fails_is_told(bench: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        bench, "write_recording", lambda path, minutes: path.write_bytes(b"not a recording")
    )
    assert "exit code 1" in bench.measure_recording(0.1, 0.1).failures[0]


@pytest.fixture
def recorded(monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.syspath_prepend(str(ROOT))
    return importlib.import_module("benchmarks.recordings")


def test_rates_of_a_folder(
    recorded: Any, bench: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A damaged race is found in both ways, noise in none; the table tells."""
    signal = bench.synthesise(bench.recipe(6.0)).signal
    noise = np.random.default_rng(5).normal(size=len(signal.samples))
    rows = ["file,rig,bearing,nominal_rpm,truth,damaged_elsewhere"]
    for name, samples, truth in (
        ("inner", signal.samples, "inner_race"),
        ("noise", noise, "healthy"),
        ("other", noise[::-1], "healthy"),
    ):
        scaled = np.round(20_000.0 * samples / np.max(np.abs(samples))).astype(np.int16)
        wavfile.write(tmp_path / f"{name}.wav", int(bench.RATE), scaled)
        elsewhere = "ball" if name == "other" else ""
        rows.append(f"{name}.wav,rig-{name},6205,1797,{truth},{elsewhere}")
    (tmp_path / "recordings.csv").write_text("\n".join(rows), encoding="utf-8")
    page = tmp_path / "page.md"
    recorded.main([str(tmp_path), "--quick", "--markdown", str(page)])
    text = page.read_text(encoding="utf-8")
    assert "| race: named first | 1 of 1 |" in text
    assert "| healthy: damage stated | 0 of 1 |" in text
    assert "| other end: damage stated | 0 of 1 |" in text
    assert text in capsys.readouterr().out


def test_a_limit_lies_between_the_healthy_and_the_damaged(recorded: Any) -> None:
    def one(truth: str, depth: float, rig: str = "a-1") -> Any:
        stated = (truth,) if truth != "healthy" else ()
        row = recorded.Recording("f", rig, "6205", 1000.0, truth, "")
        return row, recorded.Outcome(stated, "", "", depth, "", 1.0, 1.0, (1.0, "ball"))

    results = [one("healthy", 0.1), one("inner_race", 0.9), one("outer_race", 0.9, "b")]
    assert recorded.limit_of(results) == pytest.approx(0.3)
    first, second = recorded.left_out(results)
    assert (first["rig"], second["rig"]) == ("a", "b")
    assert np.isnan(first["limit"])  # no healthy bearing is left
    assert second["limit"] == pytest.approx(0.3)
    assert second["race"] == (1, 1)
    assert recorded.is_right("ball_or_cage", "ball")
    assert not recorded.is_right("ball_or_cage", "outer_race")
