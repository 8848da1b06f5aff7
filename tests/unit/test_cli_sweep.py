"""`rolamento sweep`: what it prints, what it writes, how it ends."""

from __future__ import annotations

import io
import os
import re
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.children import python
from typer.testing import CliRunner, Result

from rolamento.cli import sweep_progress
from rolamento.cli.requested import program_of
from rolamento.document.medium import Medium
from rolamento.document.terminal import terminal
from rolamento.pages.study import study_page
from rolamento.studies import Interrupted, load_result, load_study, run_to_file, runner
from rolamento.words import speaking

STUDY = """
title = "Two loads"
case = "case.toml"
outputs = ["x", "max_inner_contact_angle", "max_inner_max_pressure"]

[[axes]]
field = "duty.load.fx"
values = ["20 kN", "30 kN"]
"""

Run = Callable[..., Result]


@pytest.fixture
def run(tmp_path: Path, examples: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Run the command in a directory that holds a study and its case."""
    monkeypatch.chdir(tmp_path)
    Path("case.toml").write_text((examples / "218_combined.toml").read_text("utf-8"), "utf-8")
    Path("study.toml").write_text(STUDY, "utf-8")
    app = program_of("studying:SweepRequest", "sweep")

    def runner(*arguments: str, given: str | None = None) -> Result:
        environment = {"LC_ALL": "C.UTF-8", "COLUMNS": "100"}
        result = CliRunner().invoke(app, arguments, input=given, env=environment)
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result

    return runner


def test_a_study_is_solved_and_told_of(run: Run) -> None:
    result = run("study.toml")
    assert (result.exit_code, result.stderr) == (0, "")
    assert result.stdout.startswith("Two loads\n2 cases in ")
    assert "all cases have a result" in result.stdout
    assert "max_inner_max_pressure" in result.stdout
    assert "MPa" in result.stdout
    assert "Written to study.nc." in result.stdout
    assert load_result("study.nc").sizes == {"fx": 2}
    assert sorted(os.listdir()) == ["case.toml", "study.nc", "study.toml"]


@pytest.mark.parametrize("name", ["out.csv", "out.parquet", "out.nc"])
def test_the_ending_decides(run: Run, name: str) -> None:
    assert run("study.toml", "-o", name).exit_code == 0
    assert Path(name).stat().st_size > 100


def test_standard_input_settings_and_language(run: Run) -> None:
    result = run("-", "--set", "duty.load.fz=1 kN", "--lang", "pt", given=STUDY)
    assert result.exit_code == 0
    assert "todos os casos têm resultado" in result.stdout
    assert 'fz = "1 kN"' in load_result("study.nc").attrs["case"]


def test_some_without_a_result(run: Run) -> None:
    Path("study.toml").write_text(STUDY.replace("30 kN", "-30 kN"), "utf-8")
    result = run("study.toml")
    assert result.exit_code == 0
    assert "cases with a result: 1; without: 1" in result.stdout
    assert "there is no equilibrium" in result.stdout


def test_none_with_a_result(run: Run) -> None:
    axis = '[[axes]]\nfield = "bearing.ball_count"\nvalues = [40, 50]\n'
    Path("study.toml").write_text('case = "case.toml"\n' + axis, "utf-8")
    result = run("study.toml")
    assert result.exit_code == 1
    assert "do not fit" in result.stdout
    assert "stiffness" not in result.stdout


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ((), "STUDY: is missing"),
        (("none.toml",), "cannot be opened"),
        (("case.toml",), "bearing: is an unknown key"),
        (("study.toml", "-o", "out.txt"), "must end in"),
        (("study.toml", "-o", "study.toml"), "is one of the input files"),
        (("study.toml", "-o", "./case.toml"), "is the case file of the study; choose another name"),
        (("study.toml", "-o", "none/out.nc"), "no such directory"),
        (("study.toml", "--set", "duty.load.fy=1"), "needs a unit"),
        (("study.toml", "--set", "duty.lod.fy=1 N"), "did you mean load"),
    ],
)
def test_wrong_input(run: Run, arguments: tuple[str, ...], says: str) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert says in result.stderr
    assert result.stderr.count("\n") == 1
    assert "study.nc" not in os.listdir()


def test_a_sweep_does_not_write_over_its_case(run: Run) -> None:
    Path("case.csv").write_bytes(Path("case.toml").read_bytes())
    Path("study.toml").write_text(STUDY.replace("case.toml", "case.csv"), "utf-8")
    result = run("study.toml", "-o", "./case.csv")
    assert (
        result.exit_code,
        "is the case file of the study; choose another name" in result.stderr,
    ) == (2, True)
    assert Path("case.csv").read_bytes() == Path("case.toml").read_bytes()


def test_lists(run: Run) -> None:
    fields, outputs = run("--list", "fields").stdout, run("--list", "outputs").stdout
    assert "duty.load.fx" in fields
    assert "axes, scatter" in fields
    assert "stiffness_ryry" in outputs
    assert "per ball" in outputs


def test_ctrl_c_keeps_what_is_done(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    real = runner.run_to_file

    def interrupted(study: object, path: str, **options: object) -> None:
        def progress(done: int, total: int, failed: int) -> None:
            if done:
                raise KeyboardInterrupt

        real(study, path, **{**options, "progress": progress, "chunk": 1})  # type: ignore[arg-type]

    monkeypatch.setattr("rolamento.studies.runner.run_to_file", interrupted)
    result = run("study.toml")
    assert result.exit_code == 130
    assert "1 of 2 cases are kept in study.nc.parts" in result.stderr
    monkeypatch.undo()


def test_parts_of_another_study(run: Run) -> None:
    def stop(done: int, total: int, failed: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(Interrupted):
        run_to_file(load_study("study.toml"), "study.nc", progress=stop)
    result = run("study.toml", "--set", "duty.load.fz=1 kN")
    assert (result.exit_code, "--restart" in result.stderr) == (2, True)
    assert run("study.toml", "--set", "duty.load.fz=1 kN", "--restart").exit_code == 0


SLOW = (
    'case = "case.toml"\noutputs = ["x"]\n[scatter]\ncount = {count}\n'
    '[scatter.fields."duty.load.fx"]\ndistribution = "uniform"\nminimum = "20 kN"\n'
    'maximum = "40 kN"\n'
)
SWEEP = (
    "from rolamento.cli.requested import program_of; program_of('studying:SweepRequest', 'sweep')()"
)


def ended(how: signal.Signals, *arguments: str, **options: Any) -> str:
    """What a sweep says that is sent a signal as soon as it has kept something."""
    parts = Path(arguments[0]).with_suffix(".nc.parts")
    with python("-c", SWEEP, *arguments, stderr=subprocess.PIPE, text=True, **options) as process:
        deadline = time.monotonic() + 240.0  # kernels may have to be compiled
        while not list(parts.glob("*.npz")):
            assert process.poll() is None
            assert time.monotonic() < deadline
            time.sleep(0.05)
        process.send_signal(how)
        _, errors = process.communicate(timeout=60)
        assert process.returncode == 130, errors
    assert "Traceback" not in errors
    assert list(parts.glob("*.npz"))
    return str(errors)


@pytest.mark.skipif(os.name != "posix", reason="needs POSIX signals")
@pytest.mark.sweep
@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM])
def test_a_process_is_interrupted(run: Run, how: signal.Signals) -> None:
    """In the middle: exit code 130, and the rest is done by a second run."""
    Path("long.toml").write_text(SLOW.format(count=3_000_000), "utf-8")
    assert "of 3 000 000 cases are kept in long.nc.parts" in ended(how, "long.toml")


@pytest.mark.skipif(os.name != "posix", reason="needs POSIX signals")
@pytest.mark.slow
@pytest.mark.parametrize(
    ("how", "ignored"), [(signal.SIGINT, ()), (signal.SIGTERM, (signal.SIGINT,))]
)
def test_ctrl_c_among_slow_cases(
    run: Run, how: signal.Signals, ignored: tuple[signal.Signals, ...]
) -> None:
    """A friction sweep on one thread, stopped in the middle: at once, and with parts to go on from.

    A third of a million cases of some 4 ms, which the first chunk of 16 384 took over a minute of.
    Where Ctrl-C is ignored, the sweep says how it is ended.
    """
    Path("slow.toml").write_text(SLOW.format(count=300_000), "utf-8")
    settings = ["model.raceway_control=friction", "lubricant=ISO VG 68",
                "lubricant.friction_coefficient=0.07"]  # fmt: skip
    words = [word for setting in settings for word in ("--set", setting)]
    errors = ended(how, "slow.toml", "--threads", "1", *words, ignored=ignored)
    assert "of 300 000 cases are kept in slow.nc.parts" in errors
    assert bool(re.search(r"'kill \d+'", errors)) == bool(ignored)


class TestProgress:
    def test_lines_where_there_is_no_terminal(self, capsys: pytest.CaptureFixture[str]) -> None:
        seconds = iter([0.0, 1.0, 5.0, 11.0, 11.0, 11.0, 11.0])
        lines = sweep_progress.Lines(clock=lambda: next(seconds))
        lines(1000, 21_000, 0)
        lines(11_000, 21_000, 3)
        written = capsys.readouterr().err
        assert written == (
            "rolamento: 11 000 of 21 000 cases, 1000/s, 0:10 left, 3 without a result\n"
        )

    def test_no_line_too_early(self, capsys: pytest.CaptureFixture[str]) -> None:
        lines = sweep_progress.Lines()
        for done in (0, 10, 20):
            lines(done, 20, 0)
        assert capsys.readouterr().err == ""

    def test_a_bar_on_a_terminal(self, monkeypatch: pytest.MonkeyPatch) -> None:
        class Terminal(io.StringIO):
            encoding = "utf-8"  # type: ignore[assignment]

            def isatty(self) -> bool:
                return True

        monkeypatch.setenv("TERM", "xterm")
        monkeypatch.setenv("COLUMNS", "120")
        stream = Terminal()
        with speaking("pt"), sweep_progress.told(stream) as progress:
            progress(0, 100, 0)
            progress(50, 100, 2)
        shown = stream.getvalue()
        assert "resolvendo" in shown
        assert "50 / 100" in shown
        assert "2 sem resultado" in shown


def test_report_in_ascii(run: Run) -> None:
    summary = run_to_file(load_study("study.toml"), "study.nc")
    for language in ("en", "pt"):
        with speaking(language):
            text = terminal(study_page(summary, "Two loads"), Medium(encoding="ascii"))
        assert text.isascii()
        assert max(map(len, text.splitlines())) <= 80
