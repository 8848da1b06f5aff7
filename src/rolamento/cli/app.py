"""The commands. Each imports what it needs when it runs: `--version` waits for nothing."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from enum import StrEnum
from typing import TYPE_CHECKING, Annotated, Final

import typer

import rolamento
from rolamento.cli.optional_value import SolveCommand
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text, put
from rolamento.errors import FileError, InputError

if TYPE_CHECKING:
    from rolamento.report.language import Words

__all__ = ["app", "main"]

_SOLVED: Final = 0
_NO_RESULT: Final = 1
_WRONG_INPUT: Final = 2
_INTERRUPTED: Final = 130

app = typer.Typer(
    help="Ball bearing analysis: ball loads, contact angles, stresses, displacements, stiffness.",
    epilog="Exit codes: 0 solved, 1 no result (the reason is printed), 2 wrong input.",
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    context_settings={"help_option_names": ["-h", "--help"]},
)


class Language(StrEnum):
    """The languages of reports."""

    pt = "pt"
    en = "en"


LanguageOption = Annotated[
    Language | None,
    typer.Option("--lang", help="Language of the report; by default that of the locale."),
]


def main() -> None:
    """Run the command line."""
    app(prog_name="rolamento")


def _print_version(wanted: bool) -> None:
    if wanted:
        print_text(f"rolamento {rolamento.__version__}\n")
        raise typer.Exit(_SOLVED)


@app.callback()
def rolamento_command(
    version: Annotated[
        bool,
        typer.Option("--version", help="Show the version.", callback=_print_version, is_eager=True),
    ] = False,
) -> None:
    """Ball bearing analysis: ball loads, contact angles, stresses, displacements, stiffness."""


@app.command(
    cls=SolveCommand,
    epilog="Examples: solve case.toml --json; solve case.toml --set duty.load.fz='10 kN'.",
)
def solve(
    case: Annotated[str, typer.Argument(help="Case file (TOML or JSON); - is standard input.")],
    json: Annotated[
        str | None,
        typer.Option(
            "--json",
            metavar="[FILE]",
            help="Write the state as JSON, in SI units; without FILE, to standard output.",
        ),
    ] = None,
    csv: Annotated[
        str | None,
        typer.Option(
            "--csv", metavar="FILE", help="Write the table of balls; - is standard output."
        ),
    ] = None,
    settings: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="KEY=VALUE", help="Override a field of the case. Repeats."),
    ] = None,
    lang: LanguageOption = None,
) -> None:
    """Show the internal state of a bearing under its duty."""
    with _plain_endings(lang):
        _check_outputs(case, json, csv)
        solved = _solved(rolamento.load_case(case, settings or ()), lang)
        _show(solved, json, csv, lang)
    raise typer.Exit(_SOLVED if solved.status.converged else _NO_RESULT)


@app.command()
def demo(
    write: Annotated[
        str | None,
        typer.Option("--write", metavar="FILE", help="Write the example's case file instead."),
    ] = None,
    lang: LanguageOption = None,
) -> None:
    """Solve the shipped example: a 218 bearing at 10 000 rpm under combined load."""
    from rolamento.cli import demonstration

    with _plain_endings(lang):
        if write is not None:
            print_text(demonstration.written(write, _words(lang)))
            return
        example = demonstration.example_case()
        _show(_solved(example, lang), None, None, lang)
        print_text(demonstration.what_next(_words(lang)))


@contextmanager
def _plain_endings(lang: Language | None) -> Iterator[None]:
    """Turn wrong input and Ctrl-C into one line and an exit code; a bug stays a traceback."""
    try:
        yield
    except InputError as error:
        complain(str(error))
        raise typer.Exit(_WRONG_INPUT) from None
    except KeyboardInterrupt:
        complain(_words(lang).interrupted)
        raise typer.Exit(_INTERRUPTED) from None


def _words(lang: Language | None) -> Words:
    from rolamento.report.language import words_for

    return words_for(lang.value if lang else None)


def _check_outputs(case: str, json: str | None, csv: str | None) -> None:
    """Refuse outputs that would run into each other or over the case file."""
    if json is not None and json == csv:
        where = "standard output" if json == STANDARD_STREAM else json
        raise InputError("only one of --json and --csv can go there", source=where)
    for path in (json, csv):
        if path is not None and _same_file(path, case):
            raise FileError("is the case file itself; choose another name", source=path)


def _same_file(path: str, case: str) -> bool:
    try:
        return path != STANDARD_STREAM and os.path.samefile(path, case)
    except (OSError, ValueError):
        return False


def _solved(case: rolamento.Case, lang: Language | None) -> rolamento.State:
    """Solve a case; whoever waits at a terminal for long is told why."""
    from rolamento.equilibrium import solve

    if sys.stderr is None or not sys.stderr.isatty():
        return solve(case)
    from rolamento.cli.waiting import told

    with told(_words(lang).waiting):
        return solve(case)


def _show(state: rolamento.State, json: str | None, csv: str | None, lang: Language | None) -> None:
    """Write what was asked for; standard output takes data or the report, not both."""
    if json is not None:
        put(state.to_json() + "\n", json)
    if csv is not None:
        from rolamento.report.balls_csv import ball_csv

        put(ball_csv(state), csv)
    if STANDARD_STREAM not in (json, csv):
        _print_report(state, _words(lang))
    elif not state.status.converged:
        words, status = _words(lang), state.status
        complain(": ".join(part for part in (words.reason(status), words.advice(status)) if part))


def _print_report(state: rolamento.State, words: Words) -> None:
    from rolamento.report.medium import Medium
    from rolamento.report.terminal import terminal_report

    print_text(terminal_report(state, words, Medium.of(sys.stdout)))
