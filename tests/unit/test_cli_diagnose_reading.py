"""What `rolamento diagnose` makes of files: whose rate, whose speed, and what cannot be tested."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import scipy.io
from typer.testing import CliRunner

from rolamento.cli.requested import program_of

app = program_of("vibration_diagnosis:VibrationDiagnosis", "diagnose")

Run = Callable[..., tuple[int, str, str]]
NOISE = np.random.default_rng(5).normal(size=60_000)


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Run the command in a directory of its own, in English."""
    monkeypatch.chdir(tmp_path)

    def runner(*arguments: str) -> tuple[int, str, str]:
        given = (*arguments, "--bearing", "6205")
        result = CliRunner().invoke(app, given, env={"LC_ALL": "C.UTF-8"})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        squeezed = (" ".join(text.split()) for text in (result.stdout, result.stderr))
        return (result.exit_code, *squeezed)

    return runner


def mfpt(path: str = "a.mat", **changed: float) -> None:
    fields = {"sr": 12_000.0, "gs": NOISE[:, None], "load": 270.0, "rate": 25.0}
    scipy.io.savemat(path, {"bearing": {**fields, **changed}})


def test_a_speed_that_does_not_say_its_unit_is_offered(run: Run) -> None:
    mfpt()
    code, _, error = run("a.mat")
    assert code == 2
    assert "bearing.rate = 25 in the file may be it, but without a unit" in error
    assert "--speed-channel bearing.rate --speed-unit Hz" in error
    code, out, _ = run("a.mat", "--speed-channel", "bearing.rate", "--speed-unit", "Hz")
    assert code == 0
    assert "5 s at 12 000 Hz, 125 revolutions" in out
    assert (
        'The sampling rate is 12 000 Hz; "rate" = 25 of the file is taken for something else.'
        in out
    )


def test_the_rate_of_the_option_wins(run: Run) -> None:
    mfpt()
    code, out, _ = run("a.mat", "--speed", "1500 rpm", "--rate", "24 kHz")
    assert code == 0
    assert "The sampling rate is 24 000 Hz as given; the file says 12 000 Hz." in out
    out = run("a.mat", "--speed", "1500 rpm", "--rate", "24 kHz", "--lang", "pt")[1]
    assert "A taxa de amostragem é 24 000 Hz, conforme informada; o arquivo diz 12 000 Hz." in out


def test_rates_that_disagree_name_the_option(run: Run) -> None:
    mfpt(rate=51_200.0)
    code, _, error = run("a.mat", "--speed", "1500 rpm")
    assert code == 2
    assert '"sr" says 12 000 Hz and "rate" says 51 200 Hz; give it, in Hz' in error
    assert "sampling rate: is ambiguous" in error
    assert "example: --rate 51200.0" in error
    code, out, _ = run("a.mat", "--speed", "1500 rpm", "--rate", "12 kHz", "--json")
    choices = json.loads(out)["signal"]["reading_notes"]
    assert "rate_over_doubt" in [note["key"] for note in choices]
    assert code == 0


def test_the_speed_of_the_option_wins(run: Run) -> None:
    np.savez("a.npz", x=NOISE, fs=12_000.0, rpm=1797.0)
    out = run("a.npz", "--speed", "1500 rpm")[1]
    assert "The speed is 1500 rpm as given; the file says 1797 rpm." in out
    out = run("a.npz", "--speed", "1500 rpm", "--lang", "pt")[1]
    assert "A rotação é 1500 rpm, conforme informada; o arquivo diz 1797 rpm." in out
    assert "as given; the file" not in run("a.npz", "--speed", "1797 rpm")[1]


def test_pulses_go_with_the_rate_that_is_given(run: Run) -> None:
    """Both channels of a WAV header that is wrong by two are as fast as is said."""
    pulses = (np.arange(len(NOISE)) * 25.0 / 12_000.0 % 1.0 < 0.1).astype(float)
    np.savez("a.npz", x=NOISE, tacho=pulses, fs=6000.0)
    out = run("a.npz", "--channel", "x", "--tacho", "tacho", "--rate", "12 kHz")[1]
    assert "mean 1500 rpm" in out or "1500 rpm (25 Hz)" in out


@pytest.mark.parametrize("language", ["en", "pt"])
def test_a_rate_too_low_for_the_races_is_refused(run: Run, language: str) -> None:
    """At 25 Hz the cage is all that is left: no verdict but one sentence, with the least rate."""
    np.save("a.npy", NOISE)
    code, out, error = run("a.npy", "--speed", "1500 rpm", "--rate", "100", "--lang", language)
    assert (code, out) == (2, "")
    told = {
        "en": "--rate: 100.0: is too low: the races of the bearing are struck up to 135.6 times a "
        "second, which needs more than 271.1 Hz",
        "pt": "--rate: 100.0: é baixa demais: as pistas do rolamento recebem até 135,6 impactos "
        "por segundo, o que exige mais de 271,1 Hz",
    }
    assert told[language] in error


def test_a_short_record_is_told_before_it_is_read(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(*_: object) -> None:
        raise AssertionError("the record was diagnosed")

    np.save("a.npy", NOISE[:40_000])
    monkeypatch.setattr("rolamento.vibration.diagnosis.verdict", never)
    known = ("a.npy", "--speed", "30 rpm", "--rate", "50 kHz")
    code, out, _ = run(*known)
    assert code == 1
    assert " ".join(out.split()).startswith(
        "No verdict: the record is too short. It covers 0.4 revolutions of the shaft, 0.8 s; "
        "below 1.7 revolutions, 3.4 s, nothing can be said about either race."
    )
    code, out, error = run(*known, "--json")
    assert code == 1
    assert json.loads(out)["reason"] == "record_too_short"
    assert error.startswith("rolamento: No verdict: the record is too short.")


@pytest.mark.parametrize("language", ["en", "pt"])
def test_a_shaft_too_slow_for_its_rate_is_told_before_it_is_read(
    run: Run, monkeypatch: pytest.MonkeyPatch, language: str
) -> None:
    """Two million samples are judged at once: 42 s at 50 kHz, in which 2 rpm is 1.4 turns."""

    def never(*_: object) -> None:
        raise AssertionError("the record was diagnosed")

    np.save("a.npy", np.zeros(3_000_000, dtype=np.float32))
    monkeypatch.setattr("rolamento.vibration.diagnosis.verdict", never)
    code, out, _ = run("a.npy", "--speed", "2 rpm", "--rate", "50 kHz", "--lang", language)
    assert code == 1
    said = {"en": "covers 1.4 revolutions", "pt": "abrange 1,4 voltas"}
    assert said[language] in out
    data = json.loads(run("a.npy", "--speed", "2 rpm", "--rate", "50 kHz", "--json")[1])
    assert data["reason"] == "shaft_too_slow"


def test_tracking_a_short_record_is_refused_before_it_is_read(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(*_: object) -> None:
        raise AssertionError("the record was read")

    np.save("a.npy", NOISE)
    monkeypatch.setattr("rolamento.vibration.reading.SignalFile.read", never)
    code, _, error = run("a.npy", "--speed", "600 rpm", "--rate", "12000", "--track")
    assert code == 2
    assert "50 rev" in error
    assert "must be at least 96 shaft revolutions at the nominal speed, 9.6 s" in error


def test_decimal_marks_are_asked_about(run: Run) -> None:
    Path("a.csv").write_text("load;speed\n" + "7;1.234\n" * 9, "utf-8")
    known = ("a.csv", "--speed", "1500 rpm", "--rate", "1000", "--channel", "2")
    code, _, error = run(*known)
    assert code == 2
    assert "--decimal-mark point for 1.234, --decimal-mark comma for 1234" in error
    rows = "\n".join(f"7;{1.0 + n % 9 / 1000:.3f}" for n in range(9000))
    Path("a.csv").write_text(f"load;speed\n{rows}\n", "utf-8")
    assert run(*known)[0] == 2
    assert run(*known, "--decimal-mark", "comma")[0] in (0, 1)
    assert "must be one of point, comma" in run(*known, "--decimal-mark", "x")[2]


def test_a_column_of_decimal_commas_is_not_two_channels(run: Run) -> None:
    """Without a heading nothing shows which; once said, one channel is one channel."""
    samples = np.random.default_rng(5).normal(size=12_000)
    text = "".join(f"{value:.5f}\n" for value in samples).replace(".", ",")
    Path("commas.csv").write_text(text, "utf-8")
    given = ("commas.csv", "--bearing", "6205", "--speed", "1797 rpm", "--rate", "12 kHz")
    code, out, err = run(*given, "--unit", "g")
    assert (code, out) == (2, "")
    assert "may be one channel with decimal commas, or two channels" in err
    assert "--decimal-mark comma" in err
    code, out, _ = run(*given, "--unit", "g", "--decimal-mark", "comma", "--json")
    assert code == 0
    assert json.loads(out)["signal"]["duration"] == pytest.approx(1.0)
