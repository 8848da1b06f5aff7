"""`rolamento solve` and `rolamento demo`: the internal state of a bearing under its duty."""

from __future__ import annotations

import os
import shutil
import sys
from typing import Annotated, Final

import typer

import rolamento
from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import NO_RESULT, SOLVED, Language, complain_of, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import CaseArgument, LanguageOption, VariantsOption, json_option
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text, put
from rolamento.cli.waiting import progress_of, waiting
from rolamento.words import said
from rolamento.words.reasons import reason

__all__ = ["app", "demo", "solve"]

_PROGRAM: Final = "rolamento"

app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Examples: solve 6310/C3 --fr '5 kN' --speed '1480 rpm'; solve case.toml --json;"
    " solve case.toml --set duty.load.fz='10 kN'; solve case.toml --report state.pdf"
    " --csv stiffness.csv --table stiffness; solve case.toml --variant"
    " 'spring:bearing.preload={ spring = \"500 N\" }'.",
)
@with_outputs
@with_case
def solve(
    case: CaseArgument,
    given: CaseOptions = NOTHING_GIVEN,
    variants: VariantsOption = None,
    json: Annotated[str | None, json_option("Write the state as JSON, in SI units")] = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show the internal state of a bearing under its duty.

    With variants, all cases side by side, and their differences from the first.
    """
    with plain_endings(lang), given.in_force():
        outputs.check({"--json": json}, case)
        loaded = given.case(case, needs_load=True)
        if variants:
            solved = _compare(loaded, variants, json, outputs)
        else:
            analysis = _analysed(loaded, lang)
            _show(analysis, json, outputs, lang)
            solved = bool(analysis.solved.converged[0])
    raise typer.Exit(SOLVED if solved else NO_RESULT)


def _compare(case: rolamento.Case, variants: list[str], json: str | None, outputs: Outputs) -> bool:
    """Show a case and its variants; return whether all have a result."""
    from rolamento.case.variant import read_variants
    from rolamento.pages.report import comparison_page
    from rolamento.tasks.report import compare_variants

    with progress_of(said("cases analysed")) as progress:
        found = compare_variants(case, read_variants(variants), progress=progress)
    if json is not None:
        put(found.to_json() + "\n", json)
    outputs.show(lambda: comparison_page(found, case.title), json)
    if STANDARD_STREAM in (json, outputs.csv):
        for one in found.cases:
            if not one.converged:
                complain(f"{one.name}: {reason(str(one.analysis.solved.status.code[0]))}")
    return found.converged


@app.command(cls=JsonCommand)
def demo(
    write: Annotated[
        str | None,
        typer.Option("--write", metavar="FILE", help="Write the example's case file instead."),
    ] = None,
    lang: LanguageOption = None,
) -> None:
    """Solve the shipped example, and suggest what to try next.

    A 218 angular-contact bearing at 10 000 rpm under combined load.
    """
    from rolamento.tasks.demonstration import example_case, write_example

    with plain_endings(lang):
        if write is not None:
            write_example(write)
            text = said("Wrote {path}; now try: {command} solve {path}", path=write,
                        command=_command())  # fmt: skip
            print_text(f"{text}\n")
            return
        _show(_analysed(example_case(), lang), None, NOWHERE, lang)
        print_text(_what_next())


def _analysed(case: rolamento.Case, lang: Language | None) -> rolamento.Analysis:
    """Solve a case; whoever waits at a terminal for long is shown why."""
    from rolamento.analysis import analyse

    with waiting(lang):
        return analyse(case)


def _show(
    analysis: rolamento.Analysis, json: str | None, outputs: Outputs, lang: Language | None
) -> None:
    """Write what was asked for; standard output takes data or the page, not both."""
    from rolamento.pages.state import state_page

    if json is not None:
        put(analysis.to_json() + "\n", json)
    outputs.show(lambda: state_page(analysis.solved, analysis), json)
    if STANDARD_STREAM in (json, outputs.csv) and not analysis.solved.converged[0]:
        complain_of(analysis.solved, lang)


def _what_next() -> str:
    """Return which file was solved, and commands to go on with."""
    from rolamento.tasks.demonstration import EXAMPLE

    command = _command()
    steps = (
        (said("a copy to work on"), "demo --write case.toml"),
        (said("the same with ceramic balls"), "solve case.toml --set bearing.ball_material=Si3N4"),
        (
            said("the balls as a table, and everything as JSON"),
            "solve case.toml --csv balls.csv --json state.json",
        ),
    )
    lines = [f"  # {purpose}\n  {command} {arguments}\n" for purpose, arguments in steps]
    source = said("This was {path}", path=_nearby(str(EXAMPLE)))
    return f"\n{source}\n\n{said('What to try next')}\n{''.join(lines)}"


def _command() -> str:
    """Return how this program can be called again from here."""
    called, found = sys.argv[0], shutil.which(_PROGRAM)
    if os.path.basename(called) != _PROGRAM or not os.path.isfile(called):
        return _PROGRAM
    known = found is not None and os.path.samefile(found, called)
    return _PROGRAM if known else _nearby(called)


def _nearby(path: str) -> str:
    """Return the path as seen from the current directory, if that is shorter."""
    try:
        return min(os.path.relpath(path), path, key=len)
    except ValueError:  # on another drive
        return path
