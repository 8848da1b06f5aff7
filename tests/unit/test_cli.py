"""The command line: what it prints, where, and the exit code that it ends with."""

from __future__ import annotations

import csv
import importlib
import io
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any, ClassVar

import pytest
import typer
from typer.testing import CliRunner

import rolamento
from rolamento.cli import streams
from rolamento.cli.app import COMMANDS, app
from rolamento.cli.common import Language
from rolamento.cli.grouped_help import GroupedCommands, Groups, SpokenCommand, paragraphs
from rolamento.cli.optional_value import with_values
from rolamento.cli.outputs import check_outputs
from rolamento.cli.waiting import progress_of, waiting

EXAMPLE = Path(rolamento.__file__).parent / "examples" / "218_combined.toml"
ENGLISH = {"LC_ALL": "C.UTF-8"}
needs_sh = pytest.mark.skipif(os.name != "posix", reason="needs a POSIX shell")
UNSOLVABLE = ("--set", "duty.load.fx=-20 kN")


class Outcome:
    def __init__(self, code: int, out: str, err: str) -> None:
        self.code, self.out, self.err = code, out, err


Run = Callable[..., Outcome]


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Run a command in an empty directory that holds a case file."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "case.toml").write_text(EXAMPLE.read_text(encoding="utf-8"), encoding="utf-8")

    def runner(*arguments: str, given: str | None = None, **environment: str) -> Outcome:
        result = CliRunner().invoke(app, arguments, input=given, env={**ENGLISH, **environment})
        if result.exception and not isinstance(result.exception, SystemExit):
            raise result.exception
        return Outcome(result.exit_code, result.stdout, result.stderr)

    return runner


def strict(text: str) -> Any:
    def refuse(constant: str) -> None:
        raise AssertionError(f"{constant} in JSON")

    return json.loads(text, parse_constant=refuse)


# --- solve ------------------------------------------------------------------


def test_solve_prints_the_report(run: Run) -> None:
    outcome = run("solve", "case.toml")
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out.startswith("218 angular-contact ball bearing, combined load\n")
    assert "converged in" in outcome.out


def test_the_case_may_come_from_standard_input(run: Run) -> None:
    text = EXAMPLE.read_text(encoding="utf-8")
    assert run("solve", "-", given=text).out == run("solve", "case.toml").out


def test_set_overrides_the_case(run: Run) -> None:
    outcome = run("solve", "case.toml", "--set", "duty.load.fz=10 kN", "--set", "title=Lighter")
    assert outcome.code == 0
    assert outcome.out.startswith("Lighter\n")
    assert "fz 10 kN" in outcome.out


@pytest.mark.parametrize(
    ("arguments", "environment", "first"),
    [
        (("--lang", "pt"), {}, "rolamento"),
        (("--lang", "en"), {"LC_ALL": "pt_BR.UTF-8"}, "bearing"),
        ((), {"LC_ALL": "pt_BR.UTF-8"}, "rolamento"),
        ((), {"LC_ALL": "", "LC_MESSAGES": "", "LANG": "pt_BR"}, "rolamento"),
        ((), {"LC_ALL": "C"}, "bearing"),
    ],
)
def test_the_language_is_asked_for_or_that_of_the_locale(
    run: Run, arguments: tuple[str, ...], environment: dict[str, str], first: str
) -> None:
    outcome = run("solve", "case.toml", *arguments, **environment)
    assert outcome.out.splitlines()[2].split()[0] == first


# --- JSON and CSV -----------------------------------------------------------


@pytest.mark.parametrize(
    "arguments",
    [
        ("case.toml", "--json"),
        ("--json", "case.toml"),
        ("--json", "-", "case.toml"),
        ("case.toml", "--json=-"),
        ("case.toml", "--json", "--set", "title=x"),
        ("--json", "--", "case.toml"),
    ],
)
def test_json_goes_to_standard_output_alone(run: Run, arguments: tuple[str, ...]) -> None:
    outcome = run("solve", *arguments)
    assert (outcome.code, outcome.err) == (0, "")
    state = strict(outcome.out)
    assert state["schema"] == 3
    assert state["status"]["converged"] is True
    assert os.listdir() == ["case.toml"]


@pytest.mark.parametrize(
    "arguments",
    [
        ("case.toml", "--json", "out.json"),
        ("--json", "out.json", "case.toml"),
        ("--json=out.json", "case.toml"),
        ("--set", "title=x", "--json", "out.json", "case.toml"),
        ("--json", "out.json", "--", "case.toml"),
    ],
)
def test_json_goes_to_a_file_beside_the_report(run: Run, arguments: tuple[str, ...]) -> None:
    outcome = run("solve", *arguments)
    assert outcome.code == 0
    assert "Stiffness" in outcome.out
    assert strict(Path("out.json").read_text(encoding="utf-8"))["status"]["code"] == "converged"


def test_json_has_the_keys_of_the_contract(run: Run) -> None:
    state = strict(run("solve", "case.toml", "--json").out)
    expected = {"schema", "title", "status", "displacement", "load", "stiffness", "balls", "notes"}
    assert expected <= state.keys()
    assert {"converged", "code", "residual", "iterations", "advice"} == state["status"].keys()
    assert list(state["displacement"]) == ["x", "y", "z", "ry", "rz"]
    assert list(state["load"]) == ["fx", "fy", "fz", "my", "mz"]
    assert [len(row) for row in state["stiffness"]] == [5] * 5
    assert len(state["balls"]) == 16
    ball = state["balls"][0]
    motion = {"centrifugal_force", "gyroscopic_moment", "orbital_speed", "ball_speed"}
    assert {"row", "azimuth", "inner", "outer"} | motion <= ball.keys()
    contact = {"load", "contact_angle", "deflection", "semi_major", "semi_minor", "max_pressure"}
    assert contact <= ball["inner"].keys()
    assert contact <= ball["outer"].keys()
    assert state["load"]["fx"] == pytest.approx(20e3)


def test_json_says_what_python_says(run: Run) -> None:
    analysis = rolamento.analyse(EXAMPLE)
    assert run("solve", "case.toml", "--json").out == analysis.to_json() + "\n"


def test_json_is_utf_8_whatever_the_locale(run: Run) -> None:
    run("solve", "case.toml", "--set", "title=Pré-carga", "--json", "out.json", LC_ALL="C")
    assert strict(Path("out.json").read_bytes().decode("utf-8"))["title"] == "Pré-carga"


def test_csv_parses_back(run: Run) -> None:
    outcome = run("solve", "case.toml", "--csv", "balls.csv", "--json", "out.json")
    assert outcome.code == 0
    with open("balls.csv", newline="", encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    balls = strict(Path("out.json").read_text(encoding="utf-8"))["balls"]
    assert [float(r["inner_load_N"]) for r in rows] == pytest.approx(
        [ball["inner"]["load"] for ball in balls]
    )


def test_csv_goes_to_standard_output_alone(run: Run) -> None:
    outcome = run("solve", "case.toml", "--csv", "-", "--json", "out.json")
    assert len(list(csv.reader(io.StringIO(outcome.out)))) == 17
    assert Path("out.json").exists()


# --- no result --------------------------------------------------------------


def test_without_equilibrium_the_report_gives_reason_and_advice(run: Run) -> None:
    outcome = run("solve", "case.toml", *UNSOLVABLE)
    assert (outcome.code, outcome.err) == (1, "")
    assert "there is no equilibrium" in outcome.out
    assert "Nothing supports the inner ring" in outcome.out


def test_without_equilibrium_json_has_nulls_and_standard_error_the_reason(run: Run) -> None:
    outcome = run("solve", "case.toml", *UNSOLVABLE, "--json", "--lang", "pt")
    assert outcome.code == 1
    state = strict(outcome.out)
    assert state["status"]["code"] == "no_equilibrium"
    assert state["status"]["advice"]
    assert set(state["displacement"].values()) == {None}
    assert outcome.err.startswith("rolamento: não há equilíbrio: Nada sustenta o anel interno")
    assert outcome.err.count("\n") == 1


def test_without_equilibrium_csv_is_written_all_the_same(run: Run) -> None:
    outcome = run("solve", "case.toml", *UNSOLVABLE, "--csv", "balls.csv")
    assert outcome.code == 1
    assert Path("balls.csv").read_text(encoding="ascii").count("\n") == 17


# --- wrong input ------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("missing.toml",), "missing.toml: cannot be opened: no such file or directory"),
        (("case.toml", "--set", "duty.load.fz=10 mm"), "duty.load.fz"),
        (("case.toml", "--set", "duty.load.fz=10"), "needs a unit"),
        (("case.toml", "--set", "duty.load.fq=10 N"), "duty.load.fq: is an unknown key"),
        (("case.toml", "--set", "nonsense"), "must be KEY=VALUE"),
        (("case.toml", "--json", "no/such/place.json"), "no/such/place.json: cannot be written"),
        (("case.toml", "--csv", "no/such/place.csv"), "no/such/place.csv: cannot be written"),
        (("case.toml", "--json="), "cannot be written: no name is given"),
        (("case.toml", "--json", "case.toml"), "is one of the input files"),
        (("case.toml", "--csv", "./case.toml"), "is one of the input files"),
        (("case.toml", "--json", "--csv", "-"), "only one of --json and --csv can go there"),
        (("case.toml", "--json", "a", "--csv", "a"), "only one of --json and --csv can go there"),
        (("case.toml", "--json", "a", "--csv", "./a"), "only one of --json and --csv can go there"),
        ((".",), "is a directory"),
    ],
)
def test_wrong_input_gets_one_line_and_the_code_2(
    run: Run, arguments: tuple[str, ...], message: str
) -> None:
    outcome = run("solve", *arguments)
    assert outcome.code == 2
    assert outcome.err.startswith("rolamento: ")
    assert message in outcome.err
    assert outcome.err.count("\n") == 1
    assert "Traceback" not in outcome.err
    assert Path("case.toml").read_bytes() == EXAMPLE.read_bytes()


@pytest.mark.parametrize(
    "text", ["", "\0", "bearing = 3", '[bearing]\nball_count = "x"\n[duty]\n', "{", "[[[["]
)
def test_a_bad_case_on_standard_input_names_its_source(run: Run, text: str) -> None:
    outcome = run("solve", "-", "--json", given=text)
    assert (outcome.code, outcome.out) == (2, "")
    assert outcome.err.startswith("rolamento: standard input")


@pytest.mark.parametrize(
    "arguments",
    [
        ("solve", "case.toml", "--unknown"),
        ("solve",),
        ("solve", "case.toml", "other.toml"),
        ("solve", "case.toml", "--lang", "xx"),
        ("solve", "case.toml", "--csv"),
        ("dissolve", "case.toml"),
    ],
)
def test_a_wrong_command_line_ends_with_2(run: Run, arguments: tuple[str, ...]) -> None:
    outcome = run(*arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert "Error: " in outcome.err


# --- how it ends ------------------------------------------------------------


def test_ctrl_c_gets_one_line_and_the_code_130(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("rolamento.solution.solve", interrupted)
    outcome = run("solve", "case.toml", "--lang", "pt")
    assert (outcome.code, outcome.out, outcome.err) == (130, "", "rolamento: interrompido\n")


def test_a_bug_is_seen(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: object, **__: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr("rolamento.solution.solve", broken)
    with pytest.raises(ZeroDivisionError):
        run("solve", "case.toml")


def test_a_closed_standard_output_is_wrong_input(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(sys, "stdout", None)
    with pytest.raises(rolamento.FileError, match="is closed"):
        streams.print_text("x")


@needs_sh
@pytest.mark.parametrize("body", ["told", "waiting", "progress_of"])
@pytest.mark.parametrize(
    ("term", "after", "told"), [("xterm", 0, 1), ("dumb", 0, 1), ("xterm", 60, 0)]
)
@pytest.mark.thirds
def test_who_waits_at_a_terminal_is_told(term: str, after: float, told: int, body: str) -> None:
    arguments = f"None, 'Solving …', {after}" if body == "waiting" else f"'Solving …', {after}"
    code = (
        f"import time; from rolamento.cli.waiting import {body}\n"
        f"with {body}({arguments}) as progress:\n"
        "    if progress: progress(3, 7)\n"
        "    time.sleep(0.7)\n"
    )
    ours, theirs = os.openpty()
    environment = {**os.environ, **ENGLISH, "TERM": term}
    subprocess.run([sys.executable, "-c", code], stderr=theirs, env=environment, check=True)
    os.write(theirs, b"end")
    shown = os.read(ours, 10_000).decode()
    os.close(ours)
    os.close(theirs)
    assert (shown.count("Solving …") >= 1) == told
    assert ("3/7" in shown) == (body == "progress_of" and term == "xterm" and bool(told))


def seen(code: str, term: str = "xterm") -> str:
    """What a terminal gets on standard output and standard error."""
    ours, theirs = os.openpty()
    environment = {**os.environ, **ENGLISH, "TERM": term}
    subprocess.run(
        [sys.executable, "-c", code], stdout=theirs, stderr=theirs, env=environment, check=True
    )
    os.write(theirs, b"end")
    shown = os.read(ours, 100_000).decode()
    os.close(ours)
    os.close(theirs)
    return shown


def test_every_command_shows_that_it_is_at_work() -> None:
    for command in ALL_COMMANDS.values():
        assert isinstance(command, GroupedCommands) or type(command).invoke is SpokenCommand.invoke


SLOW = """
import time
import typer
from rolamento.cli.grouped_help import GroupedCommands, SpokenCommand
from rolamento.cli.streams import complain, print_text
from rolamento.cli.waiting import progress_of, told
app = typer.Typer(cls=GroupedCommands)

@app.callback()
def whole() -> None: ...

@app.command(cls=SpokenCommand)
def slow() -> None:
    {body}

try:
    app(["slow"])
except SystemExit:
    pass
"""


@needs_sh
@pytest.mark.parametrize("term", ["xterm", "dumb"])
def test_a_silent_command_says_a_word_after_a_second(term: str) -> None:
    shown = seen(SLOW.format(body="time.sleep(1.5); print_text('the page')"), term)
    assert shown.count("Working …") >= 1
    assert "\x1b[?25h" in shown.partition("the page")[0] or term == "dumb"  # taken away before
    assert "Working" not in seen(SLOW.format(body="time.sleep(0.2)"), term)


@needs_sh
def test_there_is_one_word_at_a_time() -> None:
    body = """
    with progress_of("counting", 0.0) as progress:
        complain("half")
        progress(1, 2)
        time.sleep(1.5)
    with told("more", 0.1):
        time.sleep(0.4)
"""
    shown = seen(SLOW.format(body=body.strip()))
    assert "1/2" in shown
    assert "more" in shown
    assert "Working" not in shown


def test_nothing_is_told_where_there_is_no_terminal(capfd: pytest.CaptureFixture[str]) -> None:
    with waiting(Language.en, "Solving …", 0), progress_of("Drawing …", 0) as progress:
        progress(1, 2)
    assert capfd.readouterr() == ("", "")


# --- where commands write to ------------------------------------------------


def test_outputs_may_not_run_into_each_other(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("", encoding="utf-8")
    one, other = str(tmp_path / "out"), str(tmp_path / "." / ".." / tmp_path.name / "out")
    for second in (one, other):
        with pytest.raises(rolamento.InputError, match="only one of --json and --csv can"):
            check_outputs({"--json": one, "--csv": second, "--plot": None})
    with pytest.raises(rolamento.InputError, match="standard output: only one of --a and --b"):
        check_outputs({"--a": "-", "--b": "-"})


def test_outputs_may_not_be_what_is_read(tmp_path: Path) -> None:
    path = tmp_path / "signal.wav"
    path.write_bytes(b"")
    check_outputs({"--json": str(path)}, None, "6205", "-", str(tmp_path / "absent"))
    with pytest.raises(rolamento.FileError, match="is one of the input files; choose"):
        check_outputs({"--json": str(path)}, "6205", str(path))


@pytest.mark.parametrize("option", ["--plot", "--contour", "--kurtogram"])
def test_pictures_have_a_known_ending(option: str) -> None:
    check_outputs({option: "picture.svg"})
    with pytest.raises(rolamento.FileError, match=r"\.png"):
        check_outputs({option: "picture.txt"})


# --- demo, version, help ----------------------------------------------------


def test_demo_solves_the_example_and_says_what_next(run: Run) -> None:
    outcome = run("demo")
    assert outcome.code == 0
    assert outcome.out.startswith(run("solve", "case.toml").out)
    assert "218_combined.toml" in outcome.out
    assert "rolamento demo --write case.toml" in outcome.out


def test_what_demo_suggests_works(run: Run) -> None:
    commands = [
        line.split(maxsplit=1)[1] for line in run("demo").out.splitlines() if "  rolamento " in line
    ]
    assert len(commands) == 3
    Path("case.toml").unlink()
    for command in commands:
        assert run(*command.split()).code == 0
    assert sorted(os.listdir()) == ["balls.csv", "case.toml", "state.json"]


def test_demo_writes_the_example_but_not_over_another_file(run: Run) -> None:
    first = run("demo", "--write", "copy.toml")
    assert (first.code, first.err) == (0, "")
    assert "solve copy.toml" in first.out
    assert Path("copy.toml").read_bytes() == EXAMPLE.read_bytes()
    Path("copy.toml").write_text("mine", encoding="utf-8")
    second = run("demo", "--write", "copy.toml")
    assert second.code == 2
    assert second.err == "rolamento: copy.toml: already exists; choose another name\n"
    assert Path("copy.toml").read_text(encoding="utf-8") == "mine"


def test_demo_cannot_write_where_there_is_no_directory(run: Run) -> None:
    outcome = run("demo", "--write", "no/such/place.toml")
    assert outcome.code == 2
    assert "cannot be written: no such file or directory" in outcome.err


def test_version(run: Run) -> None:
    assert run("--version").out == f"rolamento {rolamento.__version__}\n"


@pytest.mark.parametrize("arguments", [("--help",), ("-h",), ("solve", "--help"), ("demo", "-h")])
def test_help(run: Run, arguments: tuple[str, ...]) -> None:
    outcome = run(*arguments)
    assert outcome.code == 0
    assert outcome.out.startswith("Usage: ")


@pytest.mark.parametrize("arguments", [(), ("catalogue",), ("weibull-plan",)])
def test_without_a_command_all_commands_are_shown(run: Run, arguments: tuple[str, ...]) -> None:
    outcome = run(*arguments)
    assert outcome.code == 2
    assert (outcome.out + outcome.err).strip() == run(*arguments, "--help").out.strip()


def commands_of(group: Any, path: tuple[str, ...] = ()) -> dict[tuple[str, ...], Any]:
    """Return the commands by their words, those of commands too."""
    found: dict[tuple[str, ...], Any] = {}
    for name, command in group.commands.items():
        found[*path, name] = command
        if hasattr(command, "commands"):
            found |= commands_of(command, (*path, name))
    return found


PROGRAM = typer.main.get_command(app)
ALL_COMMANDS = commands_of(PROGRAM)
GROUPED = {
    words: command
    for words, command in ALL_COMMANDS.items()
    if isinstance(command, SpokenCommand) and command.groups
}


def has_arguments(command: SpokenCommand) -> bool:
    return any(parameter.param_type_name == "argument" for parameter in command.params)


def test_the_help_shows_every_command_below_its_heading(run: Run) -> None:
    assert sorted(name for group in COMMANDS.values() for name in group) == sorted(PROGRAM.commands)
    shown: dict[str, list[str]] = {}
    for line in run("--help").out.splitlines():
        if re.fullmatch(r"[A-Z].*:", line):
            shown[line[:-1]] = []
        elif shown and (name := re.match(r"  ([a-z][a-z-]*) {2,}", line)):
            shown[list(shown)[-1]].append(name[1])
    listed = {heading: list(names) for heading, names in COMMANDS.items()}
    assert {heading: names for heading, names in shown.items() if names} == listed


def help_of(words: tuple[str, ...]) -> list[str]:
    """Return the lines of the help of a command."""
    command = ALL_COMMANDS[words] if words else PROGRAM
    return str(command.get_help(typer.Context(command, info_name=" ".join(words)))).splitlines()


@pytest.mark.parametrize("words", ALL_COMMANDS, ids=" ".join)
def test_the_help_of_a_command_begins_with_one_line_of_what_it_does(words: tuple[str, ...]) -> None:
    said = ALL_COMMANDS[words].get_short_help_str(200)
    verbs = (
        "Compare|Compile|Diagnose|Draw|Find|Fit|List|Make|Open|Plan|Reproduce|Say|Search|Show|Solve"
        "|Write"
    )
    assert re.fullmatch(rf"({verbs}) [^.]+\.", said)
    listed = [re.split(" {2,}", line.strip()) for line in help_of(words[:-1])]
    assert [words[-1], said] in listed, "is more than one line"
    lines = help_of(words)
    assert f"  {said}" in lines
    assert max(map(len, lines)) <= 80


@pytest.mark.parametrize("words", GROUPED, ids=" ".join)
def test_every_option_stands_below_one_heading(words: tuple[str, ...]) -> None:
    command = GROUPED[words]
    named = [name for names in command.groups.values() for name in names]
    options = {p.name: p.opts[0] for p in command.params if p.param_type_name == "option"}
    assert sorted(named) == sorted({*options, "help"})
    lines = help_of(words)
    headings = [*(["Arguments"] if has_arguments(command) else []), *command.groups]
    assert [line[:-1] for line in lines if re.fullmatch(r"[A-Z].*:", line)] == headings
    lines = lines[: next(i for i, line in enumerate(lines) if line.startswith("  Example"))]
    for option in options.values():
        assert sum(bool(re.match(rf"  (-\w, )?{option}( |$)", line)) for line in lines) == 1


def test_a_long_list_of_options_has_headings() -> None:
    long = {words for words, command in ALL_COMMANDS.items() if len(command.params) > 15}
    assert long <= {*GROUPED}


def test_what_has_no_heading_is_shown_below_the_last() -> None:
    class Half(SpokenCommand):
        groups: ClassVar[Groups] = {"Where": ("path",), "Nothing": ()}

    class Program(GroupedCommands):
        groups: ClassVar[Groups] = {"First": ("two", "absent")}

    other = typer.Typer(cls=Program, rich_markup_mode=None, add_completion=False)

    def command(path: str = "", size: int = 3) -> None:
        """Do it."""

    other.command("one", cls=Half)(command)
    other.command("two", cls=Half)(command)
    shown = CliRunner().invoke(other, ["--help"]).stdout
    assert re.search(r"First:\n  two  Do it\.\n\nCommands:\n  one  Do it\.", shown)
    options = CliRunner().invoke(other, ["one", "--help"]).stdout
    assert re.search(r"Where:\n  --path <str>\n\nOptions:\n  --size <int>", options)
    assert "Nothing" not in options


@pytest.mark.parametrize(
    ("command", "usage", "argument"),
    [
        ("solve", "CASE", "CASE"),
        ("report", "CASE...", "CASE"),
        ("weibull", "[DATA.csv]", "DATA.csv"),
    ],
)
def test_arguments_are_named_as_usual(command: str, usage: str, argument: str) -> None:
    """A required one without braces, and none by a type of Python."""
    shown = CliRunner().invoke(app, [command, "--help"]).stdout
    assert f" {command} [OPTIONS] {usage}\n" in shown
    assert re.search(rf"Arguments:\n  {re.escape(argument)}  ", shown)


def test_a_long_name_does_not_move_what_the_others_mean() -> None:
    shown = CliRunner().invoke(app, ["synthesise", "--lang", "pt", "--help"]).stdout
    assert re.search(r"\n  --slip FRAÇÃO +Fração", shown)
    assert re.search(r"\n  --swing \S+\n +Fração", shown)


# --- where the value of --json is left out ----------------------------------


@pytest.mark.parametrize(
    ("given", "meant"),
    [
        (["c.toml", "--json"], ["c.toml", "--json=-"]),
        (["--json", "c.toml"], ["--json=-", "c.toml"]),
        (["--json", "-"], ["--json=-", "-"]),
        (["-", "--json", "-"], ["-", "--json=-"]),
        (["c.toml", "--json", "o"], ["c.toml", "--json=o"]),
        (["--json", "o", "c.toml"], ["--json=o", "c.toml"]),
        (["--csv", "b", "--json", "c.toml"], ["--csv", "b", "--json=-", "c.toml"]),
        (["--set", "--json", "c.toml"], ["--set", "--json", "c.toml"]),
        (["--json=o", "c.toml"], ["--json=o", "c.toml"]),
        (["--json", "--csv", "b", "c.toml"], ["--json=-", "--csv", "b", "c.toml"]),
        (["--json", "o", "--", "c.toml"], ["--json=o", "--", "c.toml"]),
        (["--json", "--", "c.toml"], ["--json=-", "--", "c.toml"]),
        (["--", "c.toml", "--json"], ["--", "c.toml", "--json"]),
        ([], []),
    ],
)
def test_the_word_after_json_is_its_file_if_there_is_a_case(
    given: list[str], meant: list[str]
) -> None:
    assert with_values(given, {"--csv", "--set", "--lang"}) == meant


# --- as a process -----------------------------------------------------------


def process(script: str, **environment: str) -> subprocess.CompletedProcess[bytes]:
    program = f"{sys.executable} -c 'from rolamento.cli import main; main()'"
    return subprocess.run(
        ["sh", "-c", script.replace("ROLAMENTO", program)],
        capture_output=True,
        env={**os.environ, **ENGLISH, "CASE": str(EXAMPLE), **environment},
        timeout=300,
        check=False,
    )


@needs_sh
def test_a_reader_that_goes_away_is_no_error() -> None:
    done = process('{ ROLAMENTO solve "$CASE"; echo code $? >&2; } | head -n 1')
    assert done.stdout == b"218 angular-contact ball bearing, combined load\n"
    assert done.stderr == b"code 0\n"


@needs_sh
@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs /dev/full")
@pytest.mark.parametrize(
    "arguments",
    ['solve "$CASE" --json', "--help", "solve --help", "--version", "sweep --list fields"],
)
@pytest.mark.thirds
def test_a_full_disk_is_told(arguments: str) -> None:
    done = process(f"ROLAMENTO {arguments} >/dev/full")
    assert done.returncode == 2
    expected = b"rolamento: standard output: cannot be written: no space left on device\n"
    assert done.stderr == expected


HOSTILE = "\x1b]0;owned\x07\x1b[2J\x9b31m\u202egnp"
"""A new title of the window, an empty screen, red, and letters from right to left."""


def shown_on_a_terminal(directory: Path, *arguments: str) -> str:
    """What a command writes to a terminal, without colours and what moves a progress bar."""
    import pty  # POSIX only

    main, end = pty.openpty()
    code = f"from rolamento.cli.app import app; app({list(arguments)!r})"
    environment = {**os.environ, **ENGLISH, "TERM": "xterm-256color"}
    with subprocess.Popen(
        [sys.executable, "-c", code], cwd=directory, stdout=end, stderr=end, env=environment
    ) as done:
        os.close(end)
        pieces = []
        with suppress(OSError):  # the other end is closed
            while piece := os.read(main, 2**16):
                pieces.append(piece)
        done.wait(60)
    os.close(main)
    bar = r"\x1b\[(\?25[lh]|2K|1A)|\r"
    return re.sub(rf"\x1b\[[0-9;]*m|{bar}", "", b"".join(pieces).decode())


@needs_sh
@pytest.mark.parametrize(
    "arguments",
    [
        ("solve", "bad.json"),
        ("catalogue", "show", "Z9", "--catalogue", "own.csv"),
        ("catalogue", "search", "Z9", "--catalogue", "own.csv"),
        ("trend", "cells.csv"),
        ("weibull", "lives.csv"),
        ("weibull", "cells.csv"),
        ("diagnose", "signal.csv", "--bearing", "6205", "--speed", "1797 rpm"),
        ("plot", "state.json", "-o", "a.png"),
        ("life", "case.json", "--spectrum", "cells.csv"),
    ],
)
@pytest.mark.thirds
def test_a_file_cannot_speak_to_the_terminal(tmp_path: Path, arguments: tuple[str, ...]) -> None:
    case = rolamento.load_case(EXAMPLE)
    (tmp_path / "case.json").write_text(rolamento.case_to_json(case), "utf-8")
    (tmp_path / "bad.json").write_text(json.dumps({HOSTILE: 1}), "utf-8")
    (tmp_path / "state.json").write_text(
        json.dumps({**rolamento.solve(case).to_mapping(), "title": HOSTILE}), "utf-8"
    )
    (tmp_path / "lives.csv").write_text(
        f"# title: {HOSTILE}\nlife,{HOSTILE}\n1,a\n2,{HOSTILE}\n3,b\n", "utf-8"
    )
    (tmp_path / "cells.csv").write_text(f"{HOSTILE},share\n{HOSTILE},0.5\n1,{HOSTILE}\n", "utf-8")
    (tmp_path / "own.csv").write_text(
        "designation,maker,kind,bore_mm,outside_diameter_mm,width_mm,contact_angle_deg,ball_count,"
        "ball_diameter_mm,pitch_diameter_mm,inner_conformity,outer_conformity,source\n"
        f"Z9,{HOSTILE},angular_contact,90,160,30,40,16,22.23,125.26,0.5232,0.5232,{HOSTILE}\n",
        "utf-8",
    )
    rows = "".join(f"{n / 1e3},{(n * 7919) % 101}\n" for n in range(3000))
    (tmp_path / "signal.csv").write_text(f"time (s),{HOSTILE} (g)\n{rows}", "utf-8")
    text = shown_on_a_terminal(tmp_path, *arguments)
    assert text
    assert "Traceback" not in text
    assert text.replace("\n", "").isprintable()


@needs_sh
@pytest.mark.parametrize("environment", [{"PYTHONIOENCODING": "ascii"}, {"PYTHONUTF8": "0"}])
def test_a_plain_terminal_gets_plain_characters(environment: dict[str, str]) -> None:
    done = process('ROLAMENTO solve "$CASE" --lang pt', LC_ALL="C", **environment)
    assert (done.returncode, done.stderr) == (0, b"")
    text = done.stdout.decode()
    assert re.search(r"[aâ]ngulo de contato", text)
    if "PYTHONIOENCODING" in environment:
        assert done.stdout.isascii()


@needs_sh
def test_error_messages_in_ascii_too() -> None:
    done = process("ROLAMENTO solve — --lang pt", PYTHONIOENCODING="ascii")
    assert done.returncode == 2
    assert done.stderr.startswith(b"rolamento: ")
    assert b"Traceback" not in done.stderr


def modules_of(*arguments: str) -> set[str]:
    """What a command has imported at its end."""
    code = (
        "import sys; from rolamento.cli.app import app\n"
        f"try: app({list(arguments)!r})\n"
        "except SystemExit: print(*sys.modules, file=sys.stderr)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(done.stderr.split())


HEAVY = {"matplotlib", "numba", "numpy", "pint", "pydantic", "rich", "scipy", "starlette", "xarray"}


@pytest.mark.parametrize("asked", ["--version", "--help"])
def test_what_needs_no_command_imports_none(asked: str) -> None:
    commands = {f"cli.{name.replace('-', '_')}" for names in COMMANDS.values() for name in names}
    others = {"cli.requested", "cli.outputs", "case", "catalogue", "solved", "studies", "tasks"}
    loaded = modules_of(asked) - {"rolamento.cli.app"}
    assert "rolamento.cli.grouped_help" in loaded
    assert not loaded & (HEAVY | {f"rolamento.{name}" for name in commands | others})


ENGINES = {"matplotlib", "numba", "rich", "starlette", "xarray"}
ENGINES |= {f"scipy.{name}" for name in ("fft", "linalg", "ndimage", "optimize", "special")}
ENGINES |= {
    f"rolamento.{name}"
    for name in ("friction", "life", "lubrication", "pages", "rows", "studies.runner", "system")
}


@pytest.mark.parametrize("name", ["solve", "sweep", "weibull", "diagnose", "anderon", "seek"])
def test_the_help_of_a_command_imports_no_engine(name: str) -> None:
    loaded = modules_of(name, "--help")
    assert "rolamento.cli.optional_value" in loaded
    assert not loaded & ENGINES


@pytest.mark.parametrize("name", [name for names in COMMANDS.values() for name in names])
def test_the_list_says_of_a_command_what_its_own_help_begins_with(name: str) -> None:
    command = PROGRAM.commands[name]
    assert paragraphs(command.help)[0] == PROGRAM.line_of(name)


def test_a_process_looks_for_no_plugins_of_pydantic() -> None:
    code = (
        "import sys; from rolamento.cli import main\n"
        "sys.argv = ['rolamento', 'solve', '6310', '--fr', '5 kN']\n"
        "try: main()\n"
        "finally: print('email' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.endswith("False\n")


def test_a_program_that_fails_after_a_command_has_failed(tmp_path: Path) -> None:
    """It may have caught how the command ended; what it has not yet written is not lost."""
    code = (
        "import sys; from rolamento.cli import main\n"
        "log, sys.argv = open('log', 'w'), ['rolamento', '--version']\n"
        "try: main()\n"
        "except SystemExit: pass\n"
        "log.write('kept')\n"
        "raise RuntimeError"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, cwd=tmp_path)
    assert done.returncode == 1
    assert (tmp_path / "log").read_text() == "kept"


def test_a_pydantic_that_asks_for_more_than_plugins_gets_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    import rolamento.cli as process

    known = importlib.import_module(process._PLUGINS)
    monkeypatch.setitem(sys.modules, process._PLUGINS, process._NoPlugins(process._PLUGINS))
    stand_in: Any = importlib.import_module(process._PLUGINS)
    assert stand_in.get_plugins() == ()
    assert stand_in.PYDANTIC_ENTRY_POINT_GROUP == known.PYDANTIC_ENTRY_POINT_GROUP == "pydantic"


def test_a_command_waits_only_for_what_it_needs() -> None:
    loaded = modules_of("solve", str(EXAMPLE))
    assert "rolamento.rows.ball.row" in loaded
    assert not loaded & {"numba", "scipy", "matplotlib", "xarray", "starlette"}
    others = {"catalogue", "clearance", "friction", "life", "vibration", "cli.weibull"}
    others |= {"system.mounted", "rows.ball.arc", "rows.roller.row"}
    assert not loaded & {f"rolamento.{name}" for name in others}
    by_designation = modules_of("solve", "6310/C3", "--fr", "5 kN", "--speed", "3000 rpm")
    assert "rolamento.catalogue" in by_designation
    assert not by_designation & {"rich", "numpy.ma", "numba", "scipy", "matplotlib"}


# --- what the front pages show ----------------------------------------------


@pytest.mark.parametrize(
    ("page", "front"), [("docs/tour.md", "README.md"), ("docs/tour.pt-BR.md", "README.pt-BR.md")]
)
def test_the_examples_of_the_tour_and_of_the_front_page_work(
    run: Run, page: str, front: str
) -> None:
    text = (Path(__file__).parents[2] / page).read_text(encoding="utf-8")
    case, bearing, study = re.findall(r"```toml\n(.*?)```", text, re.DOTALL)
    Path("case.toml").write_text(case, encoding="utf-8")
    assert run("solve", "case.toml", "--set", "duty.load.fz=10 kN").code == 0
    Path("pair.toml").write_text(f'{bearing}\n[duty.load]\nfx = "400 N"\n', encoding="utf-8")
    assert run("solve", "pair.toml").code == 0
    Path("study.toml").write_text(study, encoding="utf-8")
    for line in re.findall(r"    .venv/bin/rolamento ((?:sweep|plot) .*)", text):
        assert run(*line.split()).code == 0
    assert Path("study.png").is_file()
    names: dict[str, Any] = {}
    shown = (Path(__file__).parents[2] / front).read_text(encoding="utf-8")
    (python,) = re.findall(r"```python\n(.*?)```", shown, re.DOTALL)
    exec(python, names)
    assert names["many"].converged.all()


@pytest.mark.parametrize("page", ["docs/tour.md", "docs/tour.pt-BR.md", "docs/command-line.md"])
def test_the_pages_show_every_command_in_the_groups_of_the_help(page: str) -> None:
    path = Path(__file__).parents[2] / page
    groups: list[list[str]] = []
    for heading, name, rest in re.findall(
        r"^\| (?:(\*\*.+\*\*)|`rolamento ([\w-]+).*?`(.*)) \|", path.read_text("utf-8"), re.M
    ):
        if heading:
            groups.append([])
        elif groups:
            groups[-1].append(name)
            links = re.findall(r"\]\(([^)#]+)", rest)
            assert all((path.parent / link).is_file() for link in links)
    assert groups == [list(names) for names in COMMANDS.values()]


@pytest.mark.parametrize(
    ("page", "language"), [("docs/tour.md", "en"), ("docs/tour.pt-BR.md", "pt")]
)
def test_the_tour_shows_a_true_report(run: Run, page: str, language: str) -> None:
    text = (Path(__file__).parents[2] / page).read_text(encoding="utf-8")
    report = run("solve", "case.toml", "--lang", language).out
    shown = [line[4:] for line in text.splitlines() if re.match("    .*[°µ⡇█]", line)]
    assert len(shown) > 15
    assert all(line in report for line in shown)


@pytest.mark.parametrize(
    ("given", "meant"),
    [
        (["--json", "out.json"], ["--json=out.json"]),
        (["--json", "lives.csv"], ["--json=-", "lives.csv"]),
        (["lives.csv", "--json", "out"], ["lives.csv", "--json=out"]),
    ],
)
def test_a_command_that_needs_no_file_takes_json_for_the_output(
    given: list[str], meant: list[str]
) -> None:
    assert with_values(given, {"--csv"}, takes_word=True, lacks_word=True) == meant
