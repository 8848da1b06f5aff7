"""`rolamento synthesise`: files that are read back, the truth, the report, hostile input."""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from math import log10, pi, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import typer
from typer.testing import CliRunner

from rolamento import Bearing, load_case
from rolamento.case import case_of, is_designation
from rolamento.cli.app import app
from rolamento.document.terminal import terminal
from rolamento.errors import InputError
from rolamento.pages.synthesis import synthesis_page
from rolamento.plots.vibration_modulation import envelope_depths, modulation_figure
from rolamento.solution import solve
from rolamento.tasks.bearing import has_load
from rolamento.tasks.quantities import fields_of, number_of
from rolamento.tasks.synthesis import SynthesisResult
from rolamento.tasks.synthesis import synthesise as synthesise_task
from rolamento.vibration import writing
from rolamento.vibration.frequencies import frequencies_of, nominal_frequencies
from rolamento.vibration.reading import open_signal, read_signal
from rolamento.vibration.signal import Signal
from rolamento.vibration.synthesis import (
    Fault,
    LoadDistribution,
    Mode,
    Noise,
    Recipe,
    SwingingSpeed,
    TransferPath,
    WanderingSpeed,
    Waviness,
    synthesise,
)
from rolamento.vibration.writing import write_signal
from rolamento.words import speaking

DOCS = Path(__file__).resolve().parents[2] / "docs"
GUIDE = (DOCS / "synthesis.md").read_text("utf-8")
Run = Callable[..., tuple[int, str, str]]
SPEED = 1797.0 * pi / 30.0
KNOWN = ("6205", "--speed", "1797 rpm", "--duration", "2 s", "--rate", "12 kHz")
CASE = """
title = "fan"

[bearing]
designation = "6205"

[duty]
inner_speed = "1797 rpm"

[duty.load]
fz = "1 kN"
fx = "200 N"
"""


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)
    Path("fan.toml").write_text(CASE, encoding="utf-8")

    def runner(*arguments: str, command: str = "synthesise") -> tuple[int, str, str]:
        result = CliRunner().invoke(app, (command, *arguments), env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result.exit_code, result.stdout, result.stderr

    return runner


def squeezed(text: str) -> str:
    return " ".join(text.split())


def made(**fields: Any) -> SynthesisResult:
    """Return what the task makes of a 6205, with damage to the inner race unless told otherwise."""
    given: dict[str, Any] = {"faults": [Fault(kind="inner_race")], "duration": 2.0, **fields}
    found = synthesise_task("6205", speed=SPEED, **given)
    return replace(found, path="a.wav")


class TestSignal:
    def test_it_is_that_of_the_recipe(self, run: Run) -> None:
        code, _, err = run(
            *KNOWN, "--fault", "inner_race", "--load", "radial", "--snr", "-8", "-o", "a.npz"
        )
        assert (code, err) == (0, "")
        recipe = Recipe(
            frequencies=nominal_frequencies(Bearing.named("6205"), SPEED),
            faults=(Fault(kind="inner_race"),),
            load=LoadDistribution.radial(),
            noise=Noise(ratio=-8.0, of="faults"),
            duration=2.0,
            rate=12_000.0,
        )
        expected = synthesise(recipe).signal.samples
        found = read_signal("a.npz", unit="m/s^2")
        assert np.array_equal(found.samples, expected)
        assert (found.rate, found.quantity) == (12_000.0, "acceleration")
        assert found.mean_speed == pytest.approx(SPEED, rel=1e-12)

    def test_same_seed_same_bytes(self, run: Run, tmp_path: Path) -> None:
        for name, seed in (("a", "3"), ("b", "3"), ("c", "4")):
            assert run(*KNOWN, "--fault", "ball", "--seed", seed, "-o", f"{name}.npz")[0] == 0
        a, b, c = ((tmp_path / f"{name}.npz").read_bytes() for name in "abc")
        assert a == b
        assert a != c

    def test_diagnosis_finds_what_was_planted(self, run: Run) -> None:
        for kind in ("outer_race", "inner_race"):
            out = run(
                "6205", "--speed", "1797 rpm", "--rate", "12 kHz", "--fault", kind,
                "--load", "radial", "--snr", "0", "-o", "a.csv", "--lang", "en",
            )[1]  # fmt: skip
            command = shlex.split(out.strip().splitlines()[-1])
            assert command[:3] == ["rolamento", "diagnose", "a.csv"]
            found = run(*command[2:], "--json", command="diagnose")[1]
            assert json.loads(found)["faults"] == [kind]

    def test_loaded_case_is_solved(self, run: Run) -> None:
        code, out, _ = run(
            "fan.toml", "--fault", "inner_race", "--duration", "1 s", "-o", "a.npz", "--truth",
            "a.json", "--lang", "en",
        )  # fmt: skip
        assert code == 0
        assert "load of the solved case" in squeezed(out)
        truth = json.loads(Path("a.json").read_text("utf-8"))
        state = solve(load_case("fan.toml"))
        order = frequencies_of(state).ball_pass_inner.order
        assert truth["faults"][0]["order"] == pytest.approx(order, rel=1e-12)
        assert order != pytest.approx(
            nominal_frequencies(load_case("fan.toml").bearing, SPEED).ball_pass_inner.order,
            rel=1e-3,
        )
        load = LoadDistribution.of_solved(state)
        recipe = Recipe(
            frequencies=frequencies_of(state), faults=(Fault(kind="inner_race"),), load=load,
            duration=1.0,
        )  # fmt: skip
        strengths = synthesise(recipe).truth.faults[0].strengths
        assert truth["faults"][0]["strengths"] == pytest.approx(strengths.tolist())

    def test_case_may_be_given_other_loads_and_speeds(self, run: Run) -> None:
        out = run(
            "fan.toml", "--speed", "600 rpm", "--load", "uniform", "--fault", "ball", "--set",
            "duty.load.fz='2 kN'", "-o", "a.wav", "--duration", "1 s", "--lang", "en",
        )[1]  # fmt: skip
        assert "600 rpm (10 Hz)" in out
        assert "uniform around the circumference" in out
        assert out.strip().endswith("--bearing fan.toml --speed '600 rpm'")

    def test_case_without_solution_ends_with_one(self, run: Run) -> None:
        code, out, err = run(
            "fan.toml", "--set", "duty.load.fz='1e9 N'", "--fault", "ball", "-o", "a.wav"
        )
        assert (code, out) == (1, "")
        assert err.startswith("rolamento: overloaded")
        assert not Path("a.wav").exists()


class TestFiles:
    @pytest.mark.parametrize(
        ("name", "close", "unit", "speed"),
        [("a.npz", 0.0, "", SPEED), ("a.csv", 5e-9, "m/s^2", SPEED), ("a.wav", 6e-8, "", None)],
    )
    @pytest.mark.parametrize("rate", [12_000.0, 51_200.0, 44_100.0])
    def test_reading_takes_back_what_was_written(
        self, tmp_path: Path, name: str, close: float, unit: str, speed: float | None, rate: float
    ) -> None:
        samples = np.random.default_rng(1).normal(size=70_000) * np.geomspace(1e-6, 1e6, 70_000)
        signal = Signal(samples, rate, "acceleration", "m/s^2", np.array(SPEED))
        path = tmp_path / name
        write_signal(signal, str(path))
        with open_signal(path) as file:
            assert len(file.channels) == 1
            assert file.rate == rate
            assert file.channel.unit == unit
            assert file.speed == (None if speed is None else pytest.approx(speed, rel=1e-11))
            found = file.read().samples
        assert found.size == samples.size
        assert np.all(np.abs(found - samples) <= close * np.abs(samples))

    def test_rate_that_is_no_whole_number(self, tmp_path: Path) -> None:
        signal = Signal(np.arange(1000.0), 1000.0 / 3.0, "acceleration", "m/s^2")
        for name in ("a.npz", "a.csv"):
            write_signal(signal, str(tmp_path / name))
            found = read_signal(tmp_path / name, unit="m/s^2")
            assert found.rate == pytest.approx(1000.0 / 3.0, rel=1e-11)
            assert np.isnan(found.mean_speed)
        with pytest.raises(
            InputError, match="must be an integer number of Hz in a WAV file; other"
        ):
            write_signal(signal, str(tmp_path / "a.wav"))

    def test_wav_is_what_others_read(self, tmp_path: Path) -> None:
        from scipy.io import wavfile

        samples = np.random.default_rng(2).normal(size=1001)
        write_signal(Signal(samples, 8000.0, "acceleration", "m/s^2"), str(tmp_path / "a.wav"))
        rate, found = wavfile.read(tmp_path / "a.wav")
        assert (rate, found.dtype) == (8000, np.float32)
        assert np.array_equal(found, samples.astype(np.float32))

    def test_table_has_its_bounds(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(writing, "_MOST_ROWS", 10)
        signal = Signal(np.arange(11.0), 8000.0, "acceleration", "m/s^2")
        with pytest.raises(InputError, match="at most 10 in a table"):
            write_signal(signal, str(tmp_path / "a.csv"))

    def test_disk_that_is_full(self, run: Run) -> None:
        if not Path("/dev/full").exists():
            pytest.skip("no such device here")
        for name in ("full.npz", "full.wav", "full.csv"):
            Path(name).symlink_to("/dev/full")
            code, out, err = run(*KNOWN, "--fault", "ball", "-o", name)
            assert (code, out) == (2, "")
            assert err.startswith(f"rolamento: {name}: cannot be written: ")

    def test_old_files_are_overwritten(self, run: Run) -> None:
        for duration in ("2 s", "1 s"):
            code = run(*KNOWN[:3], "--fault", "ball", "--duration", duration, "-o", "a.wav")[0]
            assert code == 0
        with open_signal("a.wav") as file:
            assert file.duration == pytest.approx(1.0)


class TestTruth:
    def test_ratio_is_that_of_the_faults(self, run: Run) -> None:
        run(*KNOWN, "--fault", "outer_race", "--snr", "-8", "-o", "a.npz", "--truth", "a.json")
        truth = json.loads(Path("a.json").read_text("utf-8"))
        fault = truth["faults"][0]
        assert fault["to_noise"] == pytest.approx(-8.0, abs=1e-9)
        assert truth["rms"] ** 2 == pytest.approx(
            fault["rms"] ** 2 + truth["noise_level"] ** 2, rel=0.05
        )

    def test_rms_of_each_fault_alone(self) -> None:
        faults = [
            Fault(kind="inner_race"),
            Fault(kind="outer_race", strength=3.0),
            Fault(kind="ball", modulation="frequency", index=2.0),
        ]
        for load in ("uniform", "radial"):
            swing = partial(SwingingSpeed, depth=0.05, frequency=0.3)
            found = made(faults=faults, load=load, rate=51_200.0, speed_profile=swing)
            recipe = found.recipe
            # parts are told apart by leaving the others' strengths at zero: same random numbers
            for place, one in enumerate(found.faults):
                alone = list(recipe.faults)
                for other in range(len(alone)):
                    if other != place:
                        alone[other] = Fault(kind=alone[other].kind, strength=0.0)
                samples = synthesise(replace(recipe, faults=tuple(alone))).signal.samples
                assert one.truth.rms == pytest.approx(float(np.sqrt(np.mean(samples**2))), rel=1e-9)

    def test_standard_output_takes_the_truth_alone(self, run: Run) -> None:
        code, out, err = run(*KNOWN, "--fault", "cage", "-o", "a.npz", "--truth", "-")
        assert (code, err) == (0, "")
        truth = json.loads(out)
        assert truth["kind"] == "synthesis"
        assert truth["signal_to_noise"] is None
        assert truth["faults"][0]["to_noise"] is None
        assert len(truth["faults"][0]["times"]) == pytest.approx(2.0 * 11.92, abs=2.0)

    def test_recipe_is_told_by_its_fields(self, run: Run) -> None:
        code, _, err = run(
            *KNOWN, "--fault", "inner_race,strength=2,azimuth=90 deg,slip=around",
            "--jitter", "0.03", "--wander", "0.005,memory=1 s", "--mode", "5 kHz,gain=3",
            "--mode", "2000", "--path", "far_gain=0.5", "--load", "radial,extent=0.7",
            "--waviness", "outer,amplitude=50 nm,last=20", "--shaft-harmonics", "0.5,0.2",
            "--noise", "0.1 g", "--colour", "pink", "--seed", "7", "-o", "a.npz",
            "--truth", "a.json",
        )  # fmt: skip
        assert (code, err) == (0, "")
        told = json.loads(Path("a.json").read_text("utf-8"))["recipe"]
        assert told["faults"][0]["jitter"] == 0.03
        assert told["faults"][0]["azimuth"] == pytest.approx(pi / 2.0)
        assert told["speed"]["kind"] == "WanderingSpeed"
        assert [mode["frequency"] for mode in told["modes"]] == [5000.0, 2000.0]
        assert told["load"] == {"kind": "radial", "extent": 0.7}
        assert told["noise"]["level"] == pytest.approx(0.980665)
        assert told["shaft_harmonics"] == [0.5, 0.2]


class TestPage:
    def test_what_was_planted(self, run: Run) -> None:
        out = run(
            *KNOWN, "--fault", "inner_race", "--fault", "ball", "--snr", "-8", "-o", "a.npz",
            "--lang", "en",
        )[1]  # fmt: skip
        line = squeezed(out)
        assert line.startswith(
            "Written: a.npz, 2 s of a bearing with damage to the inner race and a ball."
        )
        assert "inner race 5.4222 162.40" in line
        assert "faults to noise −8 dB" in line
        assert out.strip().endswith("rolamento diagnose a.npz --bearing 6205")

    def test_portuguese(self, run: Run) -> None:
        out = run(*KNOWN, "--fault", "cage", "-o", "a.npz", "--lang", "pt")[1]
        assert squeezed(out).startswith("Gravado: a.npz, 2 s de um rolamento danificado: a gaiola.")

    @pytest.mark.parametrize("language", ["en", "pt"])
    def test_width(self, run: Run, language: str) -> None:
        out = run(
            "fan.toml", "--fault", "outer_race,modulation=frequency", "--fault", "ball",
            "--swing", "0.02", "--waviness", "inner,amplitude=1 um,last=90", "--shaft-harmonics",
            "1,2,3", "--snr", "-20", "--colour", "pink", "-o",
            "a.csv", "--duration", "1 s", "--truth", "a.json", "--load-turns", "1", "--slip",
            "0.01", "--lang", language,
        )[1]  # fmt: skip
        assert out
        assert max(len(line) for line in out.splitlines()) <= 80

    @pytest.mark.parametrize("other", [(), ("--shaft-harmonics", "0.3")])
    def test_waviness_alone_has_a_ratio_to_noise(self, run: Run, other: tuple[str, ...]) -> None:
        code, out, _ = run(
            *KNOWN, "--waviness", "outer,amplitude=100 nm,last=60", *other, "--snr", "-3", "-o",
            "a.npz", "--truth", "a.json", "--lang", "en",
        )  # fmt: skip
        assert code == 0
        assert "signal to noise −3 dB" in squeezed(out)
        truth = json.loads(Path("a.json").read_text("utf-8"))
        assert truth["signal_to_noise"] == pytest.approx(-3.0)
        assert truth["recipe"]["noise"]["of"] == "signal"
        signal = sqrt(truth["rms"] ** 2 - truth["noise_level"] ** 2)
        assert 20.0 * log10(signal / truth["noise_level"]) == pytest.approx(-3.0, abs=0.3)

    def test_faults_in_the_truth_have_their_size(self, run: Run) -> None:
        run(*KNOWN, "--fault", "ball", "-o", "a.npz", "--truth", "a.json")
        truth = json.loads(Path("a.json").read_text("utf-8"))
        assert truth["faults"][0]["rms"] == pytest.approx(truth["rms"], rel=1e-12)
        assert truth["faults"][0]["to_noise"] is None

    def test_lines_of_waviness_are_those_of_the_truth(self) -> None:
        found = made(faults=(), waviness=[Waviness.falling("outer", 100e-9, last=60)])
        lines = {(line.waves, round(line.frequency, 6)) for line in found.lines}
        shaft = SPEED / (2.0 * pi)
        expected = {
            (line.waves, round(line.order * shaft, 6)) for line in found.made.truth.waviness_lines
        }
        assert lines == expected
        assert [line.rms for line in found.lines] == sorted(
            (line.rms for line in found.lines), reverse=True
        )
        # lines at one frequency add by their phases: their greatest sum bounds the whole
        assert found.rms <= sum(line.rms for line in found.lines)
        text = terminal(synthesis_page(found))
        assert "of a healthy bearing" in text
        assert "Planted" not in text

    def test_lines_beyond_half_the_rate_are_said_to_be_missing(self) -> None:
        found = made(
            faults=(),
            waviness=[Waviness.falling("outer", 100e-9, last=90)],
            rate=1000.0,
            modes=[Mode(300.0)],
        )
        assert "beyond half the sampling rate" in squeezed(terminal(synthesis_page(found)))

    def test_damage_that_no_ball_strikes_is_noted(self, run: Run) -> None:
        away = ("--fault", "outer_race,azimuth=180 deg", "--load", "radial")
        out = run(*KNOWN, *away, "--noise", "1", "-o", "a.npz", "--lang", "en")[1]
        assert "without any impact of non-zero force: outer race." in squeezed(out)
        code, _, err = run(*KNOWN, *away, "--snr", "0", "-o", "b.npz")
        assert code == 2
        assert "--snr: 0.0: is the ratio to faults without any impact" in err
        code, _, err = run(*KNOWN, *away, "-o", "b.npz")
        assert code == 2
        assert "signal: is silent" in err
        assert not Path("b.npz").exists()

    def test_both_rings_turn(self, run: Run) -> None:
        out = run(*KNOWN, "--outer-speed=-300 rpm", "--fault", "ball", "-o", "a.npz", "--lang",
                  "en")[1]  # fmt: skip
        assert "outer ring −300 rpm" in out
        assert out.strip().endswith("--speed '1797 rpm' --outer-speed '-300 rpm'")


FAULT = (*KNOWN, "--fault", "inner_race", "-o", "a.npz")
REFUSED: list[tuple[tuple[str, ...], str]] = [
    ((*KNOWN, "-o", "a.npz"), "would be silent"),
    ((*KNOWN, "--fault", "ball", "-o", "a.mp3"), "must end in one of .wav, .csv, .npz"),
    ((*KNOWN, "--fault", "ball", "-o", "-"), "must end in one of .wav, .csv, .npz"),
    ((*KNOWN, "--fault", "ball", "-o", "none/a.npz"), "none/a.npz: cannot be written"),
    ((*FAULT, "--truth", "a.npz"), "only one of --output and --truth"),
    (("fan.toml", "--fault", "ball", "-o", "a.npz", "--truth", "fan.toml"), "input files"),
    (("6205", "--fault", "ball", "-o", "a.npz"), "--speed: is missing: nothing rotates"),
    ((*FAULT, "--outer-speed", "1797 rpm"), "is that of both rings"),
    ((*FAULT, "--speed", "1797"), "--speed: "),
    ((*FAULT, "--speed", "1e9 rpm"), "--speed: "),
    (("99", "--speed", "1 rpm", "--fault", "ball", "-o", "a.npz"), "is in no catalogue"),
    (("no.toml", "--fault", "ball", "-o", "a.npz"), "no.toml: cannot be opened"),
    ((*KNOWN, "--fault", "race", "-o", "a.npz"), "--fault: kind = "),
    ((*FAULT, "--fault", "ball,jiter=1"), "did you mean jitter?"),
    ((*FAULT, "--fault", "ball,jitter=1"), "--fault: jitter = 1.0: must be from 0 to 0.2"),
    ((*FAULT, "--fault", "ball,jitter=inf"), "--fault: jitter = "),
    ((*FAULT, "--fault", "ball,azimuth=90"), "needs a unit"),
    ((*FAULT, "--fault", "ball,jitter=0.1,jitter=0.1"), "is given twice"),
    ((*FAULT, *("--fault", "ball") * 21), "at most 20"),
    ((*FAULT, "--jitter", "3"), "--fault: jitter = 3.0"),
    ((*FAULT, "--slip", "7"), "--slip: 7.0: must be"),
    ((*FAULT, "--snr", "nan"), "--snr: \"nan\": must be a number"),
    ((*FAULT, "--snr", "0", "--noise", "1"), "cannot be combined with --noise"),
    ((*KNOWN, "--snr", "0", "-o", "a.npz"), "--snr: is a ratio to faults, waviness or"),
    ((*FAULT, "--noise", "1 V"), "--noise: "),
    ((*FAULT, "--noise", "-1"), "--noise: -1.0: must be from 0"),
    ((*FAULT, "--noise", "1", "--colour", "red"), "--colour: "),
    ((*FAULT, "--load", "side"), "must be one of uniform, radial, solved"),
    ((*FAULT, "--load", "uniform,extent=1"), "must be one of uniform, radial, solved"),
    ((*FAULT, "--load", "radial,extent=0"), "--load: extent = 0.0"),
    ((*FAULT, "--load", "solved"), "needs a case file with a load"),
    ((*FAULT, "--load-turns", "1e9"), "--load-turns: "),
    ((*FAULT, "--mode", "9 kHz"), "--mode: frequency = 9000.0: must be below half"),
    ((*FAULT, "--mode", "fast"), "--mode: frequency = "),
    ((*FAULT, "--path", "far"), "known: sensor_azimuth, far_gain"),
    ((*FAULT, "--path", "far_gain=2"), "--path: far_gain = 2.0"),
    ((*FAULT, "--swing", "2"), "--swing: depth = 2.0"),
    ((*FAULT, "--swing", "0.1", "--wander", "0.1"), "cannot be combined with --wander"),
    ((*FAULT, "--wander", "0.1,memory=1e-9"), "--wander: memory = 1e-09"),
    ((*FAULT, "--wander", "0.1,memory=1 ms", "--duration", "200 s"), "steps of a wandering speed"),
    ((*FAULT, "--shaft-harmonics", "1,x"), "--shaft-harmonics: "),
    ((*FAULT, "--shaft-harmonics", "-1"), "--shaft-harmonics: "),
    ((*FAULT, "--waviness", "outer"), "--waviness: amplitude: is missing"),
    ((*FAULT, "--waviness", "top,amplitude=1 nm"), "--waviness: surface = "),
    ((*FAULT, "--waviness", "outer,amplitude=1 nm,last=10000"), "--waviness: lines = "),
    ((*FAULT, "--waviness", "outer,amplitude=1 nm,direction=axial"), "--waviness: direction = "),
    ((*FAULT, "--seed", "-1"), "--seed: -1"),
    ((*FAULT, "--duration", "1e9"), "gives more than 20 000 000 samples"),
    ((*FAULT, "--duration", "0"), "--duration: 0.0"),
    ((*FAULT, "--duration", "soon"), "--duration: "),
    ((*FAULT, "--rate", "6 kHz"), "--mode: frequency = 3500.0: must be below half"),
    ((*FAULT, "--rate", "-1"), "--rate: -1.0"),
    ((*KNOWN, "--fault", "ball", "--rate", "12000.5", "-o", "a.wav"), "must be an integer"),
    ((*FAULT, "--duration", "1600 s", *("--mode", "3 kHz") * 40), "would take too long"),
    ((*FAULT, "--fault", "x" * 2000), "at most 1000 characters"),
]  # fmt: skip


@pytest.mark.parametrize(("arguments", "message"), REFUSED, ids=range(len(REFUSED)))
@pytest.mark.thirds
def test_wrong_input_is_one_line(run: Run, arguments: tuple[str, ...], message: str) -> None:
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert err.startswith("rolamento: ")
    assert err.count("\n") == 1
    assert message in err
    assert not Path("a.npz").exists()


def test_truth_of_too_many_impacts_is_refused(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rolamento.tasks.synthesis._MOST_IMPACTS", 100)
    assert run(*FAULT)[0] == 0
    code, _, err = run(*FAULT, "--truth", "a.json")
    assert code == 2
    assert "would hold more than 100 impacts" in err


# --- what options say ------------------------------------------------------------------------


def test_fields() -> None:
    known: Any = {"kind": "text", "angle": "angle", "place": "frequency", "count": "whole"}
    found = fields_of("a, angle = 180 deg,place=2kHz,count=3", "--x", known, "", first="kind")
    assert found == {"kind": "a", "angle": pytest.approx(pi), "place": 2000.0, "count": 3}
    assert fields_of("place=1e3", "--x", known, "") == {"place": 1000.0}
    assert fields_of("angle=1 rad,kind=b", "--x", known, "", first="kind")["kind"] == "b"
    for wrong in ("angle=1", "count=1.5", "place=1 rpm", "place=nan", "a", "a,b", "=", ""):
        with pytest.raises(InputError):
            fields_of(wrong, "--x", known, "")


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("12 kHz", "frequency", 12e3),
        ("12kHz", "frequency", 12e3),
        ("1e3", "frequency", 1e3),
        ("0.5 min", "time", 30.0),
        ("1 g", "acceleration", 9.80665),
        ("2 m/s²", "acceleration", 2.0),
    ],
)
def test_numbers(text: str, kind: Any, value: float) -> None:
    assert number_of(text, "--x", kind, "") == pytest.approx(value)


def test_recipe_of_options(run: Run) -> None:
    known = (*KNOWN, "-o", "a.npz", "--truth", "a.json")

    def recipe(*options: str) -> Any:
        assert run(*known, *options)[0] == 0
        return json.loads(Path("a.json").read_text("utf-8"))["recipe"]

    both = ("--fault", "inner-race,jitter=0.05", "--fault", "ball", "--jitter", "0.02")
    swinging = recipe(*both, "--swing", "0.1")
    assert [fault["jitter"] for fault in swinging["faults"]] == [0.05, 0.02]
    swing = {"kind": "SwingingSpeed", "mean": pytest.approx(SPEED), "depth": 0.1, "frequency": 0.3}
    assert swinging["speed"] == {**swing, "phase": 0.0}
    assert recipe(*both, "--wander", "0.01")["speed"]["memory"] == 2.0
    assert recipe(*both)["noise"] is None


def test_defaults_are_those_of_a_recipe() -> None:
    default = Recipe(frequencies=nominal_frequencies(Bearing.named("6205"), SPEED))
    found = synthesise_task("6205", speed="1797 rpm", faults=[Fault(kind="ball")], duration=0.5)
    for name in ("rate", "path", "modes", "shaft_harmonics", "seed", "load_turns", "noise"):
        assert getattr(found.recipe, name) == getattr(default, name), name
    assert (found.path, found.truth_path) == ("", None)
    transfer = TransferPath(far_gain=0.5)
    assert made(transfer=transfer).recipe.path == transfer
    wander = partial(WanderingSpeed, deviation=0.01, memory=2.0)
    assert made(speed_profile=wander).recipe.speed == WanderingSpeed(SPEED, 0.01, 2.0)


def test_slip_reaches_the_frequencies() -> None:
    slow = made(slip=0.02).recipe.frequencies
    assert slow.cage.order == pytest.approx(0.98 * made().recipe.frequencies.cage.order)


def test_name_of_the_load(tmp_path: Path) -> None:
    path = tmp_path / "fan.toml"
    path.write_text(CASE, encoding="utf-8")
    solved = synthesise_task(path, tmp_path / "a.npz", faults=[Fault(kind="ball")], duration=0.5)
    assert solved.load == "solved"
    assert read_signal(tmp_path / "a.npz").mean_speed == pytest.approx(SPEED)
    assert (made(load="radial").load, made(load="radial").extent) == ("radial", 0.5)
    assert np.isnan(made().extent)


def test_case_of_a_bearing(tmp_path: Path) -> None:
    path = tmp_path / "fan.toml"
    path.write_text(CASE, encoding="utf-8")
    assert not is_designation(str(path))
    assert not is_designation("-")
    assert not is_designation("none.toml")
    assert is_designation("6205")
    assert not is_designation("a\0b")
    assert has_load(case_of(str(path)))
    assert not has_load(case_of("6205", {"duty.inner_speed": 10.0}))
    assert has_load(case_of("6205", ["duty.displacement.z='1 um'"]))
    changes = {"duty.load.fz": "2 kN", "duty.inner_speed": 1.5, "duty.outer_speed": -2.5}
    case = case_of(str(path), changes)
    assert (case.duty.inner_speed, case.duty.outer_speed) == (1.5, -2.5)
    assert case.duty.load.fz == pytest.approx(2000.0)


# --- the guide, and both modulations ---------------------------------------------------------


def commands_of(text: str) -> list[tuple[list[str], str]]:
    """Commands of a part of the guide, each with the output shown below it."""
    found = re.findall(
        r"\n    rolamento ((?:[^\n]*\\\n)*[^\n]*)(?=\n)(\n\n```\n(.*?)```)?", text, re.DOTALL
    )
    return [(shlex.split(c.replace("\\\n", " ")), output) for c, _, output in found]


def test_the_guide_shows_what_is_printed(run: Run) -> None:
    example = GUIDE.partition("## An example")[2].partition("\n## ")[0]
    commands = commands_of(example)
    assert [words[0] for words, _ in commands] == ["synthesise", "diagnose"]
    for words, output in commands:
        code, out, err = run(*words[1:], command=words[0])
        assert code == 0, err
        expected = output or "The inner race is damaged"
        assert out.strip().startswith(expected.strip())


def test_the_guide_names_commands_that_run(run: Run) -> None:
    Path("case.toml").write_text(CASE, encoding="utf-8")
    commands = [words for words, _ in commands_of(GUIDE.partition("\n| option")[0])][1:]
    assert len(commands) == 4
    for words in commands:
        assert run(*words[1:])[0] == 0, words


def test_python_of_the_guide_tells_both_modulations_apart(run: Run) -> None:
    blocks = re.findall(r"```python\n(.*?)```", GUIDE, re.DOTALL)
    assert len(blocks) == 2
    names: dict[str, Any] = {}
    exec(compile(blocks[1], "example", "exec"), names)
    truth = json.loads(Path("run.json").read_text("utf-8"))
    assert read_signal("run.npz").mean_speed == pytest.approx(truth["speed"]["mean"])
    exec(compile(blocks[0], "example", "exec"), names)
    assert Path("modulation.png").exists()
    amplitude, frequency = names["made"]
    line = names["line"]
    whole = envelope_depths(amplitude, line)
    assert whole[0] == pytest.approx(1.38, abs=5e-3)
    assert whole[2] > 0.5
    assert envelope_depths(frequency, line).max() < 1e-4
    assert envelope_depths(frequency, line, names["band"])[0] == pytest.approx(0.55, abs=5e-3)


def test_depths_of_a_known_modulation() -> None:
    time = np.arange(50_000) / 50_000.0
    swing = 1.0 + 0.4 * np.cos(2.0 * pi * 100.0 * time) + 0.1 * np.cos(2.0 * pi * 300.0 * time)
    signal = Signal(3.0 * swing * np.cos(2.0 * pi * 5000.0 * time), 50_000.0)
    assert envelope_depths(signal, 100.0) == pytest.approx([0.4, 0.0, 0.1], abs=1e-9)


@pytest.mark.parametrize("language", ["en", "pt"])
def test_picture_of_modulations(language: str) -> None:
    signal = made(faults=[Fault(kind="outer_race", jitter=0.0)], duration=0.5).made.signal
    with speaking(language):
        figure = modulation_figure(signal, signal, 107.15, (3500.0, 4500.0))
    labels = [axes.get_xlabel() for axes in figure.axes]
    assert labels[:2] == ["Time (ms)" if language == "en" else "Tempo (ms)"] * 2
    assert len(figure.axes[2].patches) == 9


def test_links_of_the_guide_lead_somewhere() -> None:
    for link in re.findall(r"\]\(([^)#]+)", GUIDE):
        assert (DOCS / link).exists(), link


@pytest.mark.parametrize("name", ["synthesise", "anderon"])
def test_the_guide_tells_of_every_option(name: str) -> None:
    guide = (DOCS / f"{'synthesis' if name == 'synthesise' else name}.md").read_text("utf-8")
    group: Any = typer.main.get_command(app)
    options = [option for parameter in group.commands[name].params for option in parameter.opts]
    options = [option for option in options if option.startswith("--")]
    assert len(options) > 10
    assert [option for option in options if f"`{option}" not in guide] == []
