"""`rolamento anderon`: levels and verdicts, several signals over a test, outputs, hostile input."""

from __future__ import annotations

import csv
import json
import re
import shlex
from collections.abc import Callable
from dataclasses import replace
from math import inf, nan, pi, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import tasks
from rolamento.cli.app import app
from rolamento.document.terminal import terminal
from rolamento.io.json import dumps
from rolamento.pages.anderon import anderon_page, noise_statement
from rolamento.plots.anderon import noise_bands, noise_figure
from rolamento.tasks import signals
from rolamento.tasks.noise import FullScale, MeasuredNoise, NoiseResult
from rolamento.tasks.noise import _full_scales_of as full_scales_of
from rolamento.vibration.anderon import BANDS, SPEED, BandNoise, measure_noise, noise_steps
from rolamento.vibration.reading import read_signal
from rolamento.vibration.signal import Signal
from rolamento.weibull import parse_trend
from rolamento.words import speaking

DOCS = Path(__file__).resolve().parents[2] / "docs"
Run = Callable[..., tuple[int, str, str]]
RATE = 51_200.0
SECONDS = 4
TONES = {"low": 150.0, "medium": 900.0, "high": 5000.0}
FULL = ("--full-scale", "low=30,medium=60,high=60")


def tones(**sizes: float) -> np.ndarray:
    """RMS velocities (m/s) of one tone a band."""
    time = np.arange(int(RATE * SECONDS)) / RATE
    parts = [
        sqrt(2.0) * size * np.sin(2.0 * pi * TONES[name] * time) for name, size in sizes.items()
    ]
    return np.asarray(sum(parts))


def anderons(velocity: float, name: str) -> float:
    """By the definition: microinch RMS per radian and per root of the octaves."""
    low, high = BANDS[name]  # type: ignore[index]
    microinch = velocity / SPEED / 25.4e-9
    return microinch / sqrt(np.log2(high / low))


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Run the command in a directory that holds a few signals."""
    monkeypatch.chdir(tmp_path)
    for hours, factor in ((60, 1.0), (120, 1.5), (180, 2.5)):
        samples = 1e6 * factor * tones(low=50e-6, medium=100e-6, high=80e-6)
        np.savez(f"t{hours}.npz", velocity=samples, fs=RATE, rpm=1800.0)
    np.save("bare.npy", 1e6 * tones(low=50e-6, medium=100e-6, high=80e-6))
    np.save("still.npy", np.ones(60_000))
    np.save("slow.npy", np.random.default_rng(1).normal(size=5000))

    def runner(*arguments: str) -> tuple[int, str, str]:
        result = CliRunner().invoke(app, ("anderon", *arguments), env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result.exit_code, result.stdout, result.stderr

    return runner


def squeezed(text: str) -> str:
    return " ".join(text.split())


class TestLevels:
    def test_levels_are_those_of_the_definition(self, run: Run) -> None:
        code, out, err = run("t60.npz", "--unit", "um/s", "--json")
        assert (code, err) == (0, "")
        bands = json.loads(out)["signals"][0]["bands"]
        assert [band["name"] for band in bands] == list(BANDS)
        for band, size in zip(bands, (50e-6, 100e-6, 80e-6), strict=True):
            assert band["velocity"] == pytest.approx(size, rel=1e-3)
            assert band["anderons"] == pytest.approx(anderons(size, band["name"]), rel=1e-3)

    @pytest.mark.parametrize(
        ("quantity", "unit", "factor"),
        [("acceleration", "m/s^2", 1.0), ("displacement", "um", 1e6)],
    )
    def test_other_quantities_become_velocity(
        self, run: Run, quantity: str, unit: str, factor: float
    ) -> None:
        turns = 2.0 * pi * TONES["medium"]
        size = 100e-6 * (turns if quantity == "acceleration" else 1.0 / turns)
        np.savez("other.npz", x=factor * tones(medium=size), fs=RATE)
        out = run("other.npz", "--unit", unit, "--json")[1]
        signal = json.loads(out)["signals"][0]
        assert signal["bands"][1]["velocity"] == pytest.approx(100e-6, rel=2e-3)
        assert f"velocity_from_{quantity}" in [note["key"] for note in signal["notes"]]

    def test_rate_of_the_option_goes_before_that_of_the_file(self, run: Run) -> None:
        code, out, _ = run("t60.npz", "--unit", "um/s", "--rate", "25600")
        assert code == 0
        said = "The sampling rate is 25 600 Hz as given; the file says 51 200 Hz."
        assert said in " ".join(out.split())

    def test_speed_of_the_option_goes_before_that_of_the_file(self, run: Run) -> None:
        at_1800 = json.loads(run("t60.npz", "--unit", "um/s", "--json")[1])["signals"][0]
        at_900 = json.loads(run("t60.npz", "--unit", "um/s", "--speed", "900 rpm", "--json")[1])
        slow = at_900["signals"][0]
        assert slow["speed"] == pytest.approx(30.0 * pi)
        for one, other in zip(at_1800["bands"], slow["bands"], strict=True):
            assert other["anderons"] == pytest.approx(2.0 * one["anderons"])
            assert other["velocity"] == pytest.approx(one["velocity"])
        assert [note["key"] for note in slow["notes"]] == ["speed_differs"]

    @pytest.mark.parametrize(
        ("speed", "names"),
        [
            ("1800 rpm", []),
            ("1764 rpm", []),
            ("1818 rpm", []),
            ("1763 rpm", ["speed_differs"]),
            ("1819 rpm", ["speed_differs"]),
        ],
    )
    def test_tolerance_of_the_standard(self, run: Run, speed: str, names: list[str]) -> None:
        out = run("bare.npy", "--unit", "um/s", "--rate", "51.2 kHz", "--speed", speed, "--json")[1]
        notes = json.loads(out)["signals"][0]["notes"]
        assert [note["key"] for note in notes] == names

    def test_unknown_speed_is_said(self, run: Run) -> None:
        out = squeezed(run("bare.npy", "--unit", "um/s", "--rate", "51200", "--lang", "en")[1])
        assert "speed not given; the test's 1800 rpm are assumed" in out
        assert "The signal does not give the speed" in out

    def test_part_of_a_signal(self, run: Run) -> None:
        both = np.concatenate([tones(low=10e-6), tones(low=30e-6)])
        np.savez("both.npz", velocity=1e6 * both, fs=RATE)
        late = json.loads(
            run("both.npz", "--unit", "um/s", "--start", "4 s", "--duration", "2 s", "--json")[1]
        )["signals"][0]
        assert late["duration"] == pytest.approx(2.0)
        assert late["bands"][0]["velocity"] == pytest.approx(30e-6, rel=1e-3)

    @pytest.mark.parametrize(("rate", "count"), [(RATE, 777_777), (51_201.0, 400_001)])
    def test_blocks_have_the_spectrum_of_the_whole(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, rate: float, count: int
    ) -> None:
        monkeypatch.setattr(signals, "PIECE", 100_000)
        path = tmp_path / "long.npy"
        np.save(path, np.random.default_rng(4).normal(size=count))
        told: list[tuple[int, int]] = []

        asked = tasks.NoiseLevel(signals=path, unit="um/s", rate=rate)
        (found,) = asked.run(lambda *done: told.append(done)).measured
        whole = measure_noise(read_signal(path, unit="um/s", rate=rate))
        assert len(told) > 3
        assert told[-1][0] <= told[-1][1]
        for one, other in zip(found.noise.bands, whole.bands, strict=True):
            assert one.velocity == pytest.approx(other.velocity, rel=1e-12)
        assert found.noise.notes == whole.notes
        assert found.noise.velocity.duration == pytest.approx(count / rate)

    def test_low_rate_holds_fewer_bands(self, run: Run) -> None:
        code, out, _ = run("slow.npy", "--unit", "um/s", "--rate", "500", "--lang", "en")
        assert code == 1
        assert "The sampling rate of 500 Hz is too low for: low, medium, high." in squeezed(out)

    def test_rate_just_above_is_noted(self, run: Run) -> None:
        out = run("bare.npy", "--unit", "um/s", "--rate", "22050", "--json")[1]
        names = [note["key"] for note in json.loads(out)["signals"][0]["notes"]]
        assert names == ["speed_unknown", "near_half_rate"]

    def test_sensitivity_of_the_sensor(self, run: Run) -> None:
        turns = 2.0 * pi * TONES["medium"]
        volts = tones(medium=100e-6 * turns) / 9.80665 * 0.1
        np.savez("volts.npz", x=volts, fs=RATE, rpm=1800.0)
        out = run("volts.npz", "--unit", "V", "--scale", "100 mV/g", "--json")[1]
        signal = json.loads(out)["signals"][0]
        assert signal["bands"][1]["velocity"] == pytest.approx(100e-6, rel=2e-3)
        assert signal["quantity"] == "acceleration"
        assert "100 mV/g" in " ".join(note["text"] for note in signal["notes"])

    def test_speed_that_changes_counts_by_its_mean(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(signals, "PIECE", 50_000)
        time = np.arange(400_000) / RATE
        speed = SPEED * (1.0 + 0.01 * np.sin(2.0 * pi * time / time[-1]))
        path = tmp_path / "run.csv"
        table = np.column_stack([time, np.random.default_rng(1).normal(size=time.size), speed])
        header = "time (s),velocity (um/s),speed (rad/s)"
        np.savetxt(path, table[::1], "%.9g", ",", header=header, comments="")
        (found,) = tasks.NoiseLevel(signals=[path], channel="velocity").run().measured
        assert found.noise.speed == pytest.approx(float(np.mean(speed)), rel=2e-3)


class TestVerdicts:
    def test_without_full_scales_there_is_none(self, run: Run) -> None:
        code, out, _ = run("t60.npz", "--unit", "um/s", "--lang", "en")
        assert code == 0
        assert out.startswith("No verdict: no full scale is given (--full-scale).")

    def test_accepted(self, run: Run) -> None:
        code, out, _ = run("t60.npz", "--unit", "um/s", *FULL, "--lang", "en")
        assert code == 0
        assert out.startswith("Accepted: no band is above 40 % of its full scale.")
        assert squeezed(out).count("accepted") == 3

    def test_rejected_in_the_band_that_is_above(self, run: Run) -> None:
        code, out, _ = run("t180.npz", "--unit", "um/s", *FULL, "--lang", "en")
        assert code == 1
        assert squeezed(out).startswith(
            "Rejected: low band with 16.2 anderon, the limit is 12; medium band with 32.5 anderon,"
            " the limit is 24; high band with 26.6 anderon"
        )

    def test_portuguese(self, run: Run) -> None:
        out = run("t180.npz", "--unit", "um/s", "--full-scale", "high=60", "--lang", "pt")[1]
        assert squeezed(out).startswith("Reprovado: faixa alta com 26,6 anderon, o limite é 24.")

    def test_part_of_the_full_scale_is_an_option(self, run: Run) -> None:
        assert run("t180.npz", "--unit", "um/s", *FULL, "--accepted", "0.6")[0] == 0
        assert run("t60.npz", "--unit", "um/s", *FULL, "--accepted", "0.1")[0] == 1

    @pytest.mark.parametrize("speed", ["1800 rpm", "1200 rpm"])
    def test_velocity_as_full_scale(self, run: Run, speed: str) -> None:
        at = ("t60.npz", "--unit", "um/s", "--speed", speed, "--accepted", "1", "--json")
        over = json.loads(run(*at, "--full-scale", "medium=101 µm/s")[1])["signals"][0]
        under = json.loads(run(*at, "--full-scale", "medium=0.099 mm/s")[1])["signals"][0]
        assert (over["verdict"], under["verdict"]) == ("accepted", "rejected")
        part = over["bands"][1]["of_full_scale"]
        assert part == pytest.approx(100.0 / 101.0, rel=1e-3)
        assert over["bands"][0]["verdict"] == "none"

    def test_what_is_not_measured_does_not_pass(self, run: Run) -> None:
        code, out, _ = run("slow.npy", "--unit", "um/s", "--rate", "4000", *FULL, "--lang", "en")
        assert code == 1
        found = json.loads(run("slow.npy", "--unit", "um/s", "--rate", "4000", *FULL, "--json")[1])
        verdicts = [band["verdict"] for band in found["signals"][0]["bands"]]
        assert verdicts == ["accepted", "accepted", "not_measured"]
        assert out.startswith("Not accepted: high band not measured.")

    def test_a_dead_sensor_does_not_pass(self, run: Run) -> None:
        code, _, err = run("still.npy", "--unit", "um/s", "--rate", "51200", *FULL)
        assert code == 2
        assert "still.npy: signal = 1e-06: is constant over 60 000 samples" in err

    def test_rejection_beside_data_is_said_to_the_person(self, run: Run) -> None:
        code, out, err = run("t180.npz", "--unit", "um/s", *FULL, "--csv", "-", "--lang", "en")
        assert code == 1
        assert out.startswith("signal,hours,band")
        assert err.startswith("rolamento: Rejected: low band")


class TestSeveral:
    FILES = ("t180.npz", "t60.npz", "t120.npz", "--unit", "um/s")

    def test_over_the_test(self, run: Run) -> None:
        code, out, _ = run(*self.FILES, "--hours", "180,60,120", *FULL, "--json")
        assert code == 1
        trend = {band["name"]: band for band in json.loads(out)["trend"]}
        assert trend["low"]["hours"] == [60.0, 120.0, 180.0]
        for name, band in trend.items():
            assert band["ratio"] == pytest.approx(2.5, rel=1e-6), name
            assert (band["rejected_after"], band["rejected_by"]) == (120.0, 180.0), name
            # slope of the logarithm through 1, 1.5 and 2.5 at even times: half the ends' apart
            assert band["growth"] == pytest.approx(np.log(2.5) / 120.0, rel=1e-6), name

    def test_page(self, run: Run) -> None:
        code, out, _ = run(*self.FILES, "--hours", "180,60,120", *FULL, "--lang", "en")
        assert code == 1
        assert out.startswith("Rejected: 1 of 3 signals.\n")
        assert "120–180" in out
        assert max(len(line) for line in out.splitlines()) <= 80
        out = run(*self.FILES, "--hours", "180,60,120", *FULL, "--lang", "pt")[1]
        assert max(len(line) for line in out.splitlines()) <= 80

    def test_without_hours_there_is_a_table_alone(self, run: Run) -> None:
        code, out, _ = run(*self.FILES, "--lang", "en")
        assert code == 0
        assert "Signals" in out
        assert "Over the test" not in out

    def test_all_accepted(self, run: Run) -> None:
        code, out, _ = run("t60.npz", "t120.npz", "--unit", "um/s", *FULL, "--lang", "en")
        assert code == 0
        assert squeezed(out).startswith("Accepted: all 2 signals; no band is above 40 %")

    def test_note_names_the_signals_that_it_is_about(self, run: Run) -> None:
        np.savez("fast.npz", velocity=1e6 * tones(low=1e-6), fs=RATE, rpm=3600.0)
        out = squeezed(run("t60.npz", "fast.npz", "--unit", "um/s", "--lang", "en")[1])
        assert "those of 1800 rpm. (fast.npz)" in out

    def test_record_is_what_trend_reads(self, run: Run, tmp_path: Path) -> None:
        hours = ("--hours", "180,60,120", "--bearing", "A, left", "--record", "noise.csv")
        assert run(*self.FILES, *hours)[0] == 0
        record = parse_trend((tmp_path / "noise.csv").read_text("utf-8"))
        assert record.title == "Noise of bearing A, left"
        assert record.names == ("A, left",)
        assert record.units == ("anderon",) * 3
        times, values = record.of_bearing("A, left", 1)
        assert times.tolist() == [60.0, 120.0, 180.0]
        assert values[0] == pytest.approx(anderons(100e-6, "medium"), rel=1e-3)

    def test_velocities_as_full_scales_need_one_speed(self, run: Run) -> None:
        np.savez("fast.npz", velocity=1e6 * tones(low=1e-6), fs=RATE, rpm=3600.0)
        both = ("t60.npz", "fast.npz", "--unit", "um/s", "--full-scale", "low=200 um/s")
        assert run(*both)[0] == 0
        code, _, err = run(*both, "--hours", "1,2")
        assert code == 2
        assert "must be in anderons, since the signals have different speeds" in err


class TestOutputs:
    def test_csv_has_a_band_in_a_row(self, run: Run, tmp_path: Path) -> None:
        assert run("t60.npz", "t180.npz", "--unit", "um/s", *FULL, "--csv", "a.csv")[0] == 1
        rows = list(csv.DictReader((tmp_path / "a.csv").read_text("utf-8").splitlines()))
        assert [*rows[0]] == [
            "signal", "hours", "band", "low_Hz", "high_Hz", "velocity_um_per_s", "anderons",
            "full_scale_anderons", "accepted_to_anderons", "verdict",
        ]  # fmt: skip
        assert [row["band"] for row in rows] == [*BANDS, *BANDS]
        assert [row["verdict"] for row in rows] == ["accepted"] * 3 + ["rejected"] * 3
        assert float(rows[0]["accepted_to_anderons"]) == pytest.approx(12.0)
        assert rows[0]["hours"] == ""

    def test_pictures(self, run: Run, tmp_path: Path) -> None:
        assert run("t60.npz", "--unit", "um/s", *FULL, "--plot", "one.png")[0] == 0
        assert (tmp_path / "one.png").read_bytes().startswith(b"\x89PNG")
        many = ("t60.npz", "t120.npz", "--unit", "um/s", "--hours", "60,120")
        assert run(*many, *FULL, "--plot", "trend.svg", "--lang", "pt")[0] == 0
        drawing = (tmp_path / "trend.svg").read_text("utf-8")
        assert "<svg" in drawing

    def test_json_has_no_numbers_that_do_not_exist(self, run: Run) -> None:
        out = run("slow.npy", "--unit", "um/s", "--rate", "4000", "--json")[1]
        assert "NaN" not in out
        assert json.loads(out)["signals"][0]["bands"][2]["anderons"] is None

    def test_whole_numbers_of_a_recorder_need_a_scale(self, run: Run) -> None:
        """A unit alone would take their full scale for 1 of it."""
        from scipy.io import wavfile

        noise = np.random.default_rng(2).normal(size=60_000)
        wavfile.write("int.wav", 48_000, (3000.0 * noise).astype(np.int16))
        for given in ((), ("--unit", "m/s^2")):
            code, _, err = run("int.wav", *given)
            assert code == 2
            assert "--scale" in err
            assert "the file holds whole numbers" in err
        out = squeezed(run("int.wav", "--scale", "1 m/s^2", "--lang", "en")[1])
        assert "The samples are scaled by 1 m/s^2, as given." in out


REFUSED: list[tuple[tuple[str, ...], str]] = [
    (("none.npz",), "none.npz: cannot be read"),
    (("bare.npy", "--unit", "um/s"), "--rate: is not in the file"),
    (("t60.npz",), "--unit: is not in the file"),
    (("t60.npz", "--unit", "V"), 'is "V": give the unit of'),
    (("t60.npz", "--unit", "um/s", "--speed", "0 rpm"), "--speed: must not be 0"),
    (("t60.npz", "--unit", "um/s", "--speed", "1800"), "--speed: "),
    (("t60.npz", "--unit", "um/s", "--accepted", "0"), "--accepted: 0.0: must be"),
    (("t60.npz", "--unit", "um/s", "--accepted", "nan"), "--accepted: nan: must be"),
    (("t60.npz", "--unit", "um/s", "--full-scale", "mid=3"), "BAND is one of low, medium, high"),
    (("t60.npz", "--unit", "um/s", "--full-scale", "low"), "BAND is one of low, medium, high"),
    (
        ("t60.npz", "--unit", "um/s", "--full-scale", "low=-3"),
        "must be a positive number of anderons, or a velocity in",
    ),
    (
        ("t60.npz", "--unit", "um/s", "--full-scale", "low=3 m"),
        "must be a positive number of anderons, or a velocity in",
    ),
    (("t60.npz", "--unit", "um/s", "--full-scale", "low=1,low=2"), "is given twice"),
    (("t60.npz", "t120.npz", "--unit", "um/s", "--hours", "1"), "for each signal, here 2"),
    (("t60.npz", "--unit", "um/s", "--hours", "-1"), "not negative"),
    (("t60.npz", "t120.npz", "--unit", "um/s", "--plot", "a.png"), "--plot: needs the hours"),
    (("t60.npz", "--unit", "um/s", "--record", "a.csv"), "--record: needs the hours"),
    (("t60.npz", "--unit", "um/s", "--plot", "a.gif"), "must end in .png"),
    (
        ("t60.npz", "--unit", "um/s", "--csv", "t60.npz"),
        "is one of the input files; choose another name",
    ),
    (("t60.npz", "--unit", "um/s", "--csv", "a", "--json", "a"), "only one of"),
    (("t60.npz", "--unit", "um/s", "--bearing", "a\nb"), "--bearing: "),
    (("t60.npz", "--unit", "um/s", "--duration", "0.2"), "must be at least 0.5 s"),
    (("t60.npz", "--unit", "um/s", "--start", "9"), "must be before the end"),
    (("still.npy", "--unit", "um/s", "--rate", "1e9"), "the bands end at 10 kHz"),
    (("t60.npz",) * 501, "must be 1 to 500 files"),
]


@pytest.mark.parametrize(("arguments", "message"), REFUSED, ids=[m for _, m in REFUSED])
def test_wrong_input_is_one_line(run: Run, arguments: tuple[str, ...], message: str) -> None:
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert err.startswith("rolamento: ")
    assert err.count("\n") == 1
    assert message in err


def test_full_scales() -> None:
    found = full_scales_of(["low=30", "HIGH = 50 anderon", "medium=0.1 mm/s"])
    assert found["low"] == FullScale(30.0)
    assert found["high"] == FullScale(50.0)
    assert found["medium"].is_velocity
    assert found["medium"].anderons("medium", SPEED) == pytest.approx(anderons(1e-4, "medium"))


@pytest.mark.parametrize("text", ["1,inf", "1,nan", "", "a,b", "1,2,3"])
def test_hours_that_are_none(run: Run, text: str) -> None:
    code, _, err = run("t60.npz", "t120.npz", "--unit", "um/s", "--hours", text)
    assert code == 2
    rule = "must be a number of hours, not negative, for each signal, here 2"
    assert (rule if text else "--hours: is missing") in err


# --- page and picture of a record ------------------------------------------------------------


def result(levels: tuple[float, float, float] = (10.0, 20.0, 30.0), **scales: Any) -> NoiseResult:
    bands = tuple(
        BandNoise(name, edges, level * 7e-6, level)
        for (name, edges), level in zip(BANDS.items(), levels, strict=True)
    )
    signal = Signal(np.random.default_rng(1).normal(size=60_000), RATE, "velocity", "um/s")
    noise = replace(measure_noise(signal), speed=SPEED, bands=bands, notes=())
    measured = MeasuredNoise("x.wav", noise)
    full = {name: FullScale(value) for name, value in scales.items()}
    return NoiseResult((measured,), full)  # type: ignore[arg-type]


def test_limit_itself_is_accepted() -> None:
    assert result(low=25.0).verdicts == ("accepted",)
    assert result(low=24.99).verdicts == ("rejected",)


def test_huge_and_missing_levels_are_shown() -> None:
    found = result((nan, 1e12, 1e-9), low=3.0, medium=4.0)
    with speaking("pt"):
        assert noise_statement(found).startswith("Reprovado: faixa baixa não medida; ")
    page = terminal(anderon_page(found))
    assert "not measured" in page
    assert json.loads(dumps(found.to_mapping()))["signals"][0]["bands"][0]["anderons"] is None


def test_growth_beyond_all_bounds_is_shown() -> None:
    first = result((1e-300, 1.0, 1.0)).measured[0]
    last = result((1e300, 1.0, 1.0)).measured[0]
    found = NoiseResult((replace(first, hours=0.0), replace(last, hours=0.1)), {})
    assert found.trend is not None
    assert found.trend.of("low").ratio == inf
    assert "Over the test" in terminal(anderon_page(found))


def test_steps_add_up_to_the_level() -> None:
    signal = Signal(np.random.default_rng(5).normal(size=100_000), RATE, "acceleration", "m/s^2")
    noise = measure_noise(signal)
    for name, (edges, values) in noise_steps(noise).items():
        assert (edges[0], edges[-1]) == pytest.approx(BANDS[name])
        assert sqrt(float(np.mean(values**2))) == pytest.approx(noise.of(name).anderons, rel=1e-9)


def test_picture_shows_levels_limits_and_the_tone() -> None:
    signal = Signal(tones(low=1e-5, medium=1e-4, high=1e-5), RATE, "velocity", "m/s")
    noise = measure_noise(signal)
    axes = noise_bands(noise, limits={"medium": 5.0})
    flat = [line for line in axes.get_lines() if len(np.asarray(line.get_xdata())) == 2]
    named = [line for line in flat if line.get_transform() == axes.transData]
    heights = sorted(float(np.asarray(line.get_ydata())[0]) for line in named)
    expected = sorted([*(band.anderons for band in noise.bands), 5.0])
    assert heights == pytest.approx(expected)
    edges, values = noise_steps(noise)["medium"]
    place = int(np.argmax(values))
    assert edges[place] < TONES["medium"] < edges[place + 1]


@pytest.mark.parametrize("language", ["en", "pt"])
def test_picture_without_bands_says_so(language: str) -> None:
    signal = Signal(np.random.default_rng(1).normal(size=5000), 500.0, "velocity", "m/s")
    with speaking(language):
        figure = noise_figure(measure_noise(signal), title="slow")
    texts = " ".join(text.get_text() for text in figure.axes[0].texts)
    assert ("sampling" if language == "en" else "amostragem") in texts


# --- the guide -------------------------------------------------------------------------------


def test_the_guide_shows_what_is_printed(run: Run, tmp_path: Path) -> None:
    example = (DOCS / "anderon.md").read_text("utf-8").partition("## An example")[2]
    example = example.partition("\n## ")[0]
    commands = re.findall(r"\n    rolamento ((?:[^\n]*\\\n)*[^\n]*)(?=\n)(\n\n```\n(.*?)```)?",
                          example, re.DOTALL)  # fmt: skip
    assert len(commands) == 4
    shown = 0
    for command, _, output in commands:
        words = shlex.split(command.replace("\\\n", " "))
        result = CliRunner().invoke(app, words, env={"LC_ALL": "C.UTF-8"})
        assert result.exit_code == (1 if words[0] == "anderon" else 0), result.stderr
        if output:
            shown += 1
            assert result.stdout.strip() == output.strip()
    assert shown == 2
    assert (tmp_path / "anderon.png").exists()


def test_python_of_the_guide_runs(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    blocks = re.findall(r"```python\n(.*?)```", (DOCS / "anderon.md").read_text("utf-8"), re.DOTALL)
    assert len(blocks) == 1
    exec(compile(blocks[0], "example", "exec"), {})
    assert "7.698 µm/s\n4.67 [9, 10]" in capsys.readouterr().out


def test_links_of_the_guide_lead_somewhere() -> None:
    for link in re.findall(r"\]\(([^)#]+)", (DOCS / "anderon.md").read_text("utf-8")):
        assert (DOCS / link).exists(), link
