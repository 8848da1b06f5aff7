"""`rolamento diagnose`: what it prints, writes and draws, and how it ends."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from functools import cache
from math import pi
from pathlib import Path

import numpy as np
import pytest
import typer
from typer.testing import CliRunner

from rolamento import Bearing
from rolamento.cli import diagnose_signal
from rolamento.cli.diagnose import diagnose
from rolamento.cli.optional_value import JsonCommand
from rolamento.vibration.frequencies import nominal_frequencies
from rolamento.vibration.synthesis import Fault, Noise, Recipe, synthesise

app = typer.Typer()
app.command(cls=JsonCommand)(diagnose)

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


@cache
def outer() -> np.ndarray:
    recipe = Recipe(
        frequencies=FREQUENCIES, faults=(Fault(kind="outer_race"),), noise=Noise(ratio=-5.0),
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
        assert squeezed(out).startswith("The outer race is damaged: lines at 107.")

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
        assert squeezed(out).startswith("A pista externa está danificada: linhas em 107,")

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
        monkeypatch.setattr(diagnose_signal, "PIECE", 5_000)
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
            (("outer.npy", "--bearing", "6205", "--speed", "1797 rpm"), "rate"),
            (("outer.npy", "--bearing", "6205", "--rate", "12000"), "--speed"),
            (("outer.npy", *KNOWN, "--speed", "0 rpm"), "must not be 0"),
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
            (("outer.npy", *KNOWN, "--plot", "a.gif"), "a.gif"),
            (("outer.npy", *KNOWN, "--csv", "outer.npy"), "signal itself"),
            (("outer.npy", *KNOWN, "--csv", "a", "--json", "a"), "only one of"),
        ],
    )
    def test_one_line_and_two(self, run: Run, arguments: tuple[str, ...], told: str) -> None:
        code, out, err = run(*arguments)
        assert (code, out) == (2, "")
        assert told in err
        assert err.count("\n") == 1
