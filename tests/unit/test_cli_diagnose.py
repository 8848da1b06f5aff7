"""`rolamento diagnose`: what it prints, writes and draws, and how it ends."""

from __future__ import annotations

import csv
import json
import re
import shlex
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from math import pi
from pathlib import Path

import numpy as np
import pytest
import scipy.io
import scipy.io.wavfile
import typer
from typer.testing import CliRunner

from rolamento import Bearing, load_case
from rolamento.case import parse_case
from rolamento.cli.requested import program_of
from rolamento.solution import solve
from rolamento.tasks import signals
from rolamento.tasks.diagnosis import widened
from rolamento.vibration.diagnosis import DiagnosisSettings
from rolamento.vibration.frequencies import FaultFrequencies, frequencies_of, nominal_frequencies
from rolamento.vibration.synthesis import Fault, Noise, Recipe, synthesise

app = program_of("vibration_diagnosis:VibrationDiagnosis", "diagnose")

Run = Callable[..., tuple[int, str, str]]
RATE = 12_000.0
FREQUENCIES = nominal_frequencies(Bearing.named("6205"), 1797.0 * pi / 30.0)
KNOWN = ("--bearing", "6205", "--speed", "1797 rpm", "--rate", "12 kHz", "--lang", "en")

CASE = """
title = "fan"

[bearing]
designation = "6205"

[duty]
inner_speed = "1797 rpm"

[duty.load]
fz = "1 kN"
"""


THRUST = CASE.replace('fz = "1 kN"', 'fx = "1 kN"\nfz = "0.5 kN"')


@cache
def outer(loaded: bool = False) -> np.ndarray:
    """A damaged outer race, by the geometry or under the load of `THRUST`."""
    frequencies = FREQUENCIES
    if loaded:
        frequencies = frequencies_of(solve(parse_case(THRUST)))
    recipe = Recipe(
        frequencies=frequencies, faults=(Fault(kind="outer_race"),), noise=Noise(ratio=0.0),
        duration=5.0, rate=RATE,
    )  # fmt: skip
    return synthesise(recipe).signal.samples


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Run the command in a directory that holds a few signals."""
    monkeypatch.chdir(tmp_path)
    np.save("outer.npy", outer())
    np.save("noise.npy", np.random.default_rng(2).normal(size=60_000))
    np.save("still.npy", np.ones(60_000))
    Path("fan.toml").write_text(CASE, encoding="utf-8")
    Path("thrust.toml").write_text(THRUST, encoding="utf-8")

    def runner(*arguments: str) -> tuple[int, str, str]:
        result = CliRunner().invoke(app, arguments, env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result.exit_code, result.stdout, result.stderr

    return runner


def squeezed(text: str) -> str:
    return " ".join(text.split())


class TestVerdicts:
    def test_fault_is_a_result(self, run: Run) -> None:
        code, out, err = run("outer.npy", *KNOWN)
        assert (code, err) == (0, "")
        assert squeezed(out).startswith("The outer race is damaged: peaks at 107.")

    def test_nothing_found_is_a_result(self, run: Run) -> None:
        code, out, _ = run("noise.npy", *KNOWN)
        assert code == 0
        assert out.startswith("Nothing found: ")

    def test_no_verdict_ends_with_one(self, run: Run) -> None:
        code, out, _ = run("still.npy", *KNOWN)
        assert code == 1
        assert out.startswith("No verdict: ")

    def test_no_verdict_beside_data_is_said_to_the_person(self, run: Run) -> None:
        code, out, err = run("still.npy", *KNOWN, "--json")
        assert code == 1
        assert json.loads(out)["verdict"] == "no_verdict"
        assert err == "rolamento: No verdict: the signal does not change.\n"

    def test_portuguese(self, run: Run) -> None:
        out = run("outer.npy", *KNOWN[:-1], "pt")[1]
        assert squeezed(out).startswith("A pista externa está danificada: picos em 107,")

    def test_speed_and_bearing_of_a_case(self, run: Run) -> None:
        code, out, _ = run("outer.npy", "--bearing", "fan.toml", "--rate", "12000", "--lang", "en")
        assert code == 0
        assert "outer race is damaged" in squeezed(out)
        assert "fan: 9 balls" in squeezed(out)

    def test_speed_of_the_file(self, run: Run) -> None:
        np.savez("known.npz", vibration=outer(), fs=np.array(RATE), rpm=np.array(1797.0))
        code, out, err = run("known.npz", "--bearing", "6205", "--lang", "en")
        assert code == 0, err
        assert "outer race is damaged" in squeezed(out)
        assert "1797 rpm (29.95 Hz)" in squeezed(out)

    def test_tolerance_of_the_speed_is_a_part_or_in_percent(self, run: Run) -> None:
        for given, part in (("1 %", 0.01), ("0.01", 0.01), ("0", 0.0), ("5%", 0.05)):
            found = json.loads(run("outer.npy", *KNOWN, "--speed-tolerance", given, "--json")[1])
            assert found["speed_tolerance"] == pytest.approx(part)
            assert found["faults"] == ["outer_race"]

    def test_slip_widens_the_search(self, run: Run) -> None:
        true = 1797 / 1680 - 1
        off = ("--bearing", "6205", "--speed", "1680 rpm", *KNOWN[4:], "--json")
        narrow = json.loads(run("outer.npy", *off)[1])["components"][0]
        assert narrow["deviation"] is None or abs(narrow["deviation"] - true) > 0.01
        found = json.loads(run("outer.npy", *off, "--slip", "0.1")[1])
        assert "outer_race" in found["faults"]
        assert found["components"][0]["deviation"] == pytest.approx(true, abs=2e-3)

    def test_part_of_a_signal(self, run: Run) -> None:
        joined = np.concatenate([np.random.default_rng(1).normal(size=60_000), outer()])
        np.save("joined.npy", joined)
        early = json.loads(run("joined.npy", *KNOWN, "--duration", "5 s", "--json")[1])
        late = json.loads(run("joined.npy", *KNOWN, "--start", "5 s", "--json")[1])
        assert early["faults"] == []
        assert late["faults"] == ["outer_race"]
        assert late["signal"]["duration"] == pytest.approx(5.0)


class TestLoadedBearing:
    """An axial load opens the contact angle to 19° and shifts the orders by more than 1 %."""

    NARROW = ("--rate", "12 kHz", "--slip", "0.004", "--lang", "en")

    def test_its_frequencies_are_looked_for(self, run: Run) -> None:
        np.save("loaded.npy", outer(loaded=True))
        given = ("loaded.npy", "--bearing", "thrust.toml", *self.NARROW, "--json")
        found = json.loads(run(*given)[1])
        loaded = frequencies_of(solve(load_case("thrust.toml")))
        assert found["faults"] == ["outer_race"]
        assert found["frequencies"]["source"] == "loaded"
        own = found["frequencies"]["ball_pass_outer"]["order"]
        assert own == pytest.approx(loaded.ball_pass_outer.order, rel=1e-12)
        assert abs(found["components"][0]["deviation"]) < 1e-3
        back = json.loads(run(*given, "--nominal")[1])
        assert back["frequencies"]["source"] == "nominal"
        assert back["state"] is None
        true = loaded.ball_pass_outer.order / FREQUENCIES.ball_pass_outer.order - 1.0
        assert true > 0.01
        # the speed may make up for it, unless it is certain
        certain = json.loads(run(*given, "--nominal", "--speed-tolerance", "0")[1])
        assert certain["faults"] == [] or certain["components"][0]["deviation"] < 0.5 * true
        assert certain["speed_factor"] == 1.0

    def test_it_is_solved_at_the_speed_of_the_signal(self, run: Run) -> None:
        fast = ("--speed", "9000 rpm", "--set", "duty.load.fx=200 N")
        found = json.loads(run("noise.npy", "--bearing", "thrust.toml", *fast, *self.NARROW[:2],
                               "--json")[1])  # fmt: skip
        settings = ["duty.inner_speed=9000 rpm", "duty.load.fx=200 N"]
        expected = frequencies_of(solve(load_case("thrust.toml", settings)))
        at_rest = frequencies_of(solve(load_case("thrust.toml", settings[1:])))
        order = found["frequencies"]["ball_pass_outer"]["order"]
        assert order == pytest.approx(expected.ball_pass_outer.order, rel=1e-9)
        assert abs(order / at_rest.ball_pass_outer.order - 1.0) > 1e-4

    def test_a_designation_with_a_load(self, run: Run) -> None:
        load = ("--set", "duty.load.fx=1 kN", "--set", "duty.load.fz=0.5 kN")
        found = json.loads(run("noise.npy", *KNOWN, *load, "--json")[1])
        assert found["frequencies"]["source"] == "loaded"

    def test_the_range_over_the_balls_widens_the_search(self, run: Run) -> None:
        given = ("noise.npy", "--bearing", "thrust.toml", "--rate", "12 kHz", "--slip", "0")
        found = json.loads(run(*given, "--json")[1])
        line = found["frequencies"]["ball_pass_inner"]
        ratio = found["frequencies"]["ball_pass_outer"]["order"] / line["order"]
        range_ = max(line["maximum"] / line["order"] - 1.0, 1.0 - line["minimum"] / line["order"])
        assert found["slip"] == 0.0
        assert found["tolerance"] >= range_ / ratio * (1.0 - 1e-9) > 1e-5
        assert "wider than --slip" in squeezed(run(*given, "--lang", "en")[1])
        assert "wider than --slip" not in squeezed(run(*given[:-2], "--lang", "en")[1])

    def test_no_solution_falls_back_and_says_so(self, run: Run) -> None:
        given = ("outer.npy", "--bearing", "thrust.toml", "--set", "duty.load.fx=100 MN")
        code, out, err = run(*given, "--rate", "12 kHz", "--json")
        found = json.loads(out)
        assert (code, err) == (0, "")
        assert found["faults"] == ["outer_race"]
        assert found["frequencies"]["source"] == "nominal"
        assert found["state"]["converged"] is False
        assert "no_loaded_frequencies" in [note["key"] for note in found["notes"]]

    def test_angle_of_an_unloaded_bearing(self, run: Run) -> None:
        angles = {}
        for angle in ("zero", "free", "15 deg"):
            found = json.loads(run("noise.npy", *KNOWN, "--angle", angle, "--json")[1])
            angles[angle] = found["frequencies"]["inner_contact_angle"]
        assert angles["zero"] == 0.0
        assert angles["15 deg"] == pytest.approx(pi / 12)
        assert angles["free"] > 0.1
        assert run("noise.npy", "--bearing", "thrust.toml", "--nominal", "--angle", "free",
                   "--rate", "12 kHz")[0] == 0  # fmt: skip


class TestSearch:
    """What a search covers of frequencies that differ from ball to ball, and from row to row."""

    @staticmethod
    def spread(part: float) -> FaultFrequencies:
        lines = {
            name: replace(
                line, minimum=line.order * (1.0 - part), maximum=line.order * (1.0 + part)
            )
            for name, line in FREQUENCIES.lines.items()
        }
        return FREQUENCIES.with_lines(lines)

    def test_not_wider_than_slip(self) -> None:
        found = widened(self.spread(0.01), DiagnosisSettings())
        assert (found.settings.tolerance, found.slip) == (0.02, None)
        assert found.covers_balls

    def test_wider(self) -> None:
        found = widened(self.spread(0.03), DiagnosisSettings())
        # the inner race's order is off by less than the cage's that is allowed
        ratio = FREQUENCIES.ball_pass_inner.order / FREQUENCIES.ball_pass_outer.order
        assert found.settings.tolerance == pytest.approx(0.03 * ratio)
        assert (found.slip, found.covers_balls) == (0.02, True)

    def test_wider_than_any_search(self) -> None:
        found = widened(self.spread(0.2), DiagnosisSettings())
        assert (found.settings.tolerance, found.slip) == (0.1, 0.02)
        assert not found.covers_balls

    def test_rows_with_other_orders(self) -> None:
        lines = FREQUENCIES.lines
        cage = lines["cage"]
        other = replace(cage, order=1.2 * cage.order, minimum=1.2 * cage.order,
                        maximum=1.2 * cage.order)  # fmt: skip
        rows = (
            FREQUENCIES,
            replace(FREQUENCIES, row=1),
            replace(FREQUENCIES.with_lines({**lines, "cage": other}), row=2),
        )
        found = widened(replace(FREQUENCIES, rows=rows), DiagnosisSettings())
        assert found.other_rows == (2,)


class TestFiles:
    """The same signal in several formats has the same verdict."""

    def test_formats(self, run: Run) -> None:
        samples = outer()
        times = np.arange(len(samples)) / RATE
        table = np.column_stack([times, samples])
        np.savetxt("a.csv", table, delimiter=",", header="time (s),acc (g)", comments="")
        np.savez("a.npz", vibration=samples, fs=RATE)
        scipy.io.savemat("a.mat", {"vibration": samples, "fs": RATE})
        scaled = (samples / np.max(np.abs(samples))).astype(np.float32)
        scipy.io.wavfile.write("a.wav", int(RATE), scaled)
        evidence = []
        for name in ("a.csv", "a.npz", "a.mat", "a.wav"):
            code, out, err = run(name, *KNOWN[:4], "--json")
            assert (code, err) == (0, "")
            found = json.loads(out)
            assert found["faults"] == ["outer_race"]
            evidence.append(found["components"][0]["evidence"])
        assert evidence == pytest.approx([evidence[0]] * 4, rel=0.01)

    def test_units_that_are_not_calibrated(self, run: Run) -> None:
        plain = json.loads(run("outer.npy", *KNOWN, "--json")[1])
        volts = json.loads(run("outer.npy", *KNOWN, "--unit", "V", "--json")[1])
        scaled = ("--unit", "V", "--scale", "100 mV/g")
        calibrated = json.loads(run("outer.npy", *KNOWN, *scaled, "--json")[1])
        assert (volts["signal"]["unit"], calibrated["signal"]["unit"]) == ("V", "m/s^2")
        assert volts["faults"] == calibrated["faults"] == ["outer_race"]
        rms = [found["signal"]["indicators"]["rms"] for found in (plain, volts, calibrated)]
        assert rms == pytest.approx([rms[0], rms[0], rms[0] * 98.0665])


class TestOutputs:
    def test_json_and_csv_files(self, run: Run, tmp_path: Path) -> None:
        code, out, _ = run("outer.npy", *KNOWN, "--json", "a.json", "--csv", "a.csv")
        assert code == 0
        assert out.startswith("The outer race")
        data = json.loads((tmp_path / "a.json").read_text("utf-8"))
        rows = list(csv.DictReader((tmp_path / "a.csv").read_text("utf-8").splitlines()))
        peak = max(rows, key=lambda row: float(row["over_noise_dB"] or "-inf"))
        times = float(peak["frequency_Hz"]) / data["components"][0]["frequency"]
        assert times == pytest.approx(round(times), abs=0.01)

    def test_pictures(self, run: Run, tmp_path: Path) -> None:
        code, _, err = run("outer.npy", *KNOWN, "--plot", "a.png", "--kurtogram", "k.svg")
        assert (code, err) == (0, "")
        assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
        assert "<svg" in (tmp_path / "k.svg").read_text("utf-8")

    def test_long_signals_are_streamed(self, run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(signals, "PIECE", 5_000)
        data = json.loads(run("outer.npy", *KNOWN, "--json")[1])
        assert data["faults"] == ["outer_race"]
        assert data["signal"]["duration"] == pytest.approx(5.0)
        assert data["signal"]["indicators_of_first"] == pytest.approx(5_000 / RATE)
        assert "first 0.4167 s: RMS" in squeezed(run("outer.npy", *KNOWN)[1])


class TestWrongInput:
    @pytest.mark.parametrize(
        ("arguments", "told"),
        [
            (("none.npy", *KNOWN), "none.npy"),
            (
                ("outer.npy", "--bearing", "6205", "--speed", "1797 rpm"),
                "(example: --rate 51200.0)",
            ),
            (("outer.npy", "--bearing", "6205", "--rate", "12000"), "--speed"),
            (("outer.npy", *KNOWN, "--speed", "0 rpm"), '--speed: "0 rpm": is that of both'),
            (("outer.npy", *KNOWN, "--speed", "1797"), "--speed '1797 rpm'"),
            (("outer.npy", *KNOWN, "--outer-speed", "1797 rpm"), "nothing rolls"),
            (("outer.npy", *KNOWN, "--unit", "frob"), "before calibration: V, mV"),
            (("outer.npy", *KNOWN, "--scale", "100"), "--scale"),
            (("outer.npy", *KNOWN, "--angle", "95 deg"), "less than 90°"),
            (("outer.npy", *KNOWN, "--angle", "wide"), "--angle free"),
            (("outer.npy", *KNOWN[2:], "--bearing", "fan.toml", "--angle", "free"), "--nominal"),
            (("outer.npy", *KNOWN, "--set", "duty.load.fz=3"), "--set: duty.load.fz"),
            (("outer.npy", *KNOWN, "--set", "duty.lode=3"), "--set"),
            (("junk.wav", *KNOWN), "is not a WAV file, although its name says so"),
            (("text.wav", *KNOWN), "time column: does not increase from the first row to the last"),
            (("two.npz", *KNOWN), "--channel: must be chosen, by name or number: 1 a, 2 b"),
            (("two.npz", *KNOWN, "--channel", "c"), "--channel a"),
            (("outer.npy", *KNOWN, "--speed", "fast"), "--speed"),
            (("outer.npy", *KNOWN, "--bearing", "62059"), "6205"),
            (("outer.npy", *KNOWN, "--bearing", "none.toml"), "none.toml"),
            (("outer.npy", *KNOWN, "--start", "9 s"), "--start"),
            (("outer.npy", *KNOWN, "--start", "-1"), "--start"),
            (("outer.npy", *KNOWN, "--duration", "0"), "--duration"),
            (("outer.npy", *KNOWN, "--duration", "99 s"), "lasts 5 s"),
            (("outer.npy", *KNOWN, "--slip", "3"), "--slip"),
            (("outer.npy", *KNOWN, "--false-alarm", "0"), "--false-alarm"),
            (("outer.npy", *KNOWN, "--rate", "12 apples"), "--rate"),
            (("outer.npy", *KNOWN, "--rate", "nan"), "--rate"),
            (("outer.npy", *KNOWN, "--channel", "9"), "channel"),
            (("outer.npy", *KNOWN, "--speed-tolerance", "much"), "--speed-tolerance"),
            (("outer.npy", *KNOWN, "--speed-tolerance", "20 %"), "--speed-tolerance"),
            (("outer.npy", *KNOWN, "--plot", "a.gif"), "a.gif"),
            (
                ("outer.npy", *KNOWN, "--csv", "outer.npy"),
                "is one of the input files; choose another name",
            ),
            (("outer.npy", *KNOWN[2:], "--bearing", "fan.toml", "--json", "fan.toml"), "fan.toml"),
            (("outer.npy", *KNOWN, "--kurtogram", "a.gif"), "a.gif"),
            (("outer.npy", *KNOWN, "--csv", "a", "--json", "a"), "only one of"),
        ],
    )
    def test_one_line_and_two(self, run: Run, arguments: tuple[str, ...], told: str) -> None:
        Path("junk.wav").write_bytes(bytes(range(256)))
        Path("text.wav").write_text("time;acc\n0;1\n", encoding="utf-8")
        np.savez("two.npz", a=outer(), b=outer())
        code, out, err = run(*arguments)
        assert (code, out) == (2, "")
        assert told in err
        assert err.count("\n") == 1


GUIDE = Path(__file__).resolve().parents[2] / "docs" / "diagnose.md"


class TestGuide:
    """docs/diagnose.md: its examples run as they stand, one after the other."""

    def test_examples(self, run: Run) -> None:
        text = GUIDE.read_text("utf-8")
        (case,) = re.findall(r"```toml\n# (\S+)\n(.*?)```", text, re.DOTALL)
        Path(case[0]).write_text(case[1], "utf-8")
        names: dict[str, object] = {}
        blocks = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
        assert len(blocks) == 4
        for block in blocks:
            exec(compile(block, "docs/diagnose.md", "exec"), names)
        faults = {}
        for line in re.findall(r"^    rolamento diagnose (.*)$", text, re.MULTILINE):
            arguments = shlex.split(line)
            if Path(arguments[0]).is_file():
                code, out, err = run(*arguments, "--json", "found.json")
                assert (code, err) == (0, ""), line
                assert out
                faults[line] = json.loads(Path("found.json").read_text("utf-8"))["faults"]
        assert len(faults) == 5
        tracked = [found for line, found in faults.items() if line.startswith("run.npz")]
        assert tracked == [["outer_race"]] * 3
        assert Path("diagnosis.png").is_file()

    def test_every_option_is_told(self) -> None:
        text = GUIDE.read_text("utf-8")
        for parameter in typer.main.get_command(app).params:
            for option in parameter.opts:
                if option.startswith("--") and "completion" not in option:
                    assert f"`{option}" in text, option

    def test_lines_are_not_too_long(self) -> None:
        assert max(map(len, GUIDE.read_text("utf-8").splitlines())) <= 120
