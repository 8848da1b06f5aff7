"""The commands. Each imports what it needs when it runs: `--version` waits for nothing."""

from __future__ import annotations

import os
import shutil
import sys
from typing import TYPE_CHECKING, Annotated, Final

import typer

import rolamento
from rolamento.cli.anderon import AnderonCommand, anderon
from rolamento.cli.browser import browser
from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.catalogue import app as catalogue_app
from rolamento.cli.clearance import clearance
from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    WRONG_INPUT,
    Language,
    complain_of,
    plain_endings,
)
from rolamento.cli.diagnose import DiagnoseCommand, diagnose
from rolamento.cli.frequencies import frequencies
from rolamento.cli.friction import friction
from rolamento.cli.grouped_help import GroupedCommands, Groups
from rolamento.cli.life import life
from rolamento.cli.new import examples, new
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import (
    CaseArgument,
    LanguageOption,
    VariantsOption,
    json_option,
)
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.plot import plot
from rolamento.cli.replace import app as replace_app
from rolamento.cli.report import report
from rolamento.cli.reproduce import reproduce
from rolamento.cli.severity import SeverityCommand, severity
from rolamento.cli.speed import speed_command
from rolamento.cli.streams import STANDARD_STREAM, complain, end_of_output, print_text, put
from rolamento.cli.sweep import sweep
from rolamento.cli.synthesise import SynthesiseCommand, synthesise
from rolamento.cli.tolerance import tolerance
from rolamento.cli.trend import trend
from rolamento.cli.turn import turn
from rolamento.cli.verify import verify
from rolamento.cli.waiting import progress_of, waiting
from rolamento.cli.weibull import WeibullCommand, weibull
from rolamento.cli.weibull_plan import app as weibull_plan_app
from rolamento.words import said
from rolamento.words.reasons import reason

if TYPE_CHECKING:
    pass

_PROGRAM: Final = "rolamento"
COMMANDS: Final[Groups] = {
    "To start with": ("demo", "app", "new", "examples"),
    "Inside the bearing": ("solve", "turn", "friction", "report"),
    "Life and life tests": ("life", "weibull", "weibull-plan", "replace", "trend"),
    "Vibration": ("frequencies", "diagnose", "severity", "synthesise", "anderon"),
    "Catalogue and clearance": ("catalogue", "clearance", "speed"),
    "Studies and figures": ("sweep", "tolerance", "plot"),
    "Verification": ("verify", "reproduce"),
}
"""What a person wants, and the commands for it: in the help, the front pages and the guide."""


class Program(GroupedCommands):
    """`rolamento`, its commands in groups."""

    groups = COMMANDS


app = typer.Typer(
    cls=Program,
    epilog="Exit codes: 0 done, 1 no result or a failed check (the reason is "
    "printed), 2 wrong input.",
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def main() -> None:
    """Run the command line."""
    try:
        app(prog_name="rolamento")
    except OSError as error:
        if error.filename is not None:  # no stream, but a file that somebody should have guarded
            raise
        end_of_output(error)  # the help, which Typer writes
        sys.exit(WRONG_INPUT)


def _print_version(wanted: bool) -> None:
    if wanted:
        with plain_endings(None):
            print_text(f"rolamento {rolamento.__version__}\n")
        raise typer.Exit(SOLVED)


@app.callback()
def rolamento_command(
    version: Annotated[
        bool,
        typer.Option("--version", help="Show the version.", callback=_print_version, is_eager=True),
    ] = False,
    lang: LanguageOption = None,
) -> None:
    """Rolling bearing analysis: internal state, and what follows from it.

    To begin: rolamento demo. Options: rolamento COMMAND --help.
    """


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
    """Show a case and its variants; tell whether all have a result."""
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
    """Solve a case; whoever waits at a terminal for long is told why."""
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


app.command(
    "app",
    cls=JsonCommand,
    epilog="Examples: app; app --port 9000 --no-browser; app --host 0.0.0.0 --lang pt.",
)(browser)
app.command(
    cls=JsonCommand,
    epilog="Examples: new 6310/C3; new 'S 6012 C' --lang pt -o spindle.toml.",
)(new)
app.command(
    cls=JsonCommand,
    epilog="Examples: examples; examples 6310_motor; examples all -o gallery.",
)(examples)
app.command(
    cls=JsonCommand, epilog="Examples: sweep study.toml -o result.nc; sweep --list fields."
)(sweep)
app.command(
    cls=JsonCommand,
    epilog="Examples: plot state.json --kind ellipses -o ellipses.pdf;"
    " plot sweep.nc --variable stiffness_zz.",
)(plot)
app.command(
    cls=JsonCommand,
    epilog="Examples: friction 6310 --fr '5 kN' --speed '1480 rpm' --lubricant 'ISO VG 68'"
    " --temperature '70 degC' --coefficient 0.1; friction case.toml --over duty.load.fx=10..200N"
    " --plot friction.png.",
)(friction)
app.command(
    cls=JsonCommand,
    epilog="Examples: life 6310/C3 --fr '5 kN' --speed '1480 rpm'; life case.toml"
    " --reliability 0.95; life left.toml right.toml;"
    " life case.toml --spectrum steps.csv; life case.toml --over duty.load.fz=1..8kN.",
)(life)
app.command(
    cls=JsonCommand,
    epilog="Examples: report case.toml -o report.pdf --author 'A. Souza';"
    " report old.toml new.toml -o comparison.html; report 6305 --fr '2 kN'.",
)(report)
app.command(cls=JsonCommand, epilog="Example: clearance case.toml --samples 10000.")(clearance)
app.command(
    "speed",
    cls=JsonCommand,
    epilog="Examples: speed 6210 --fr '2 kN' --speed '6000 rpm' --lubricant 'ISO VG 32'"
    " --temperature '70 degC'; speed case.toml --json.",
)(speed_command)
app.command(
    cls=JsonCommand,
    epilog="Examples: frequencies 6205 --speed '1797 rpm'; frequencies case.toml --json.",
)(frequencies)
app.command(
    cls=DiagnoseCommand,
    epilog="Examples: diagnose signal.wav --bearing 6205 --speed '1797 rpm' --plot signal.png; "
    "diagnose run.npz --bearing case.toml --speed-channel rpm.",
)(diagnose)
app.command(
    cls=SeverityCommand,
    epilog="Examples: severity motor.csv --unit g --speed '1480 rpm' --power '45 kW' --support"
    " rigid; severity jan.wav feb.wav mar.wav --unit mm/s --hours 0,700,1400 --plot trend.png.",
)(severity)
app.command(
    cls=SynthesiseCommand,
    epilog="Example: synthesise 6205 --speed '1797 rpm' --fault inner_race --load radial --snr -8"
    " --rate '12 kHz' --output inner.npz --truth inner.json.",
)(synthesise)
app.command(
    cls=AnderonCommand,
    epilog="Examples: anderon noise.wav --unit um/s --full-scale low=30,medium=60,high=60;"
    " anderon t060.csv t120.csv --hours 60,120 --plot trend.png.",
)(anderon)
app.command(
    cls=WeibullCommand,
    epilog="Examples: weibull tests.csv --plot paper.png; weibull tests.csv --shape 1.5;"
    " weibull --example campanha-2008 --calculated-life 'ISO 281=58 h'.",
)(weibull)
app.add_typer(weibull_plan_app, name="weibull-plan")
app.add_typer(replace_app, name="replace")
app.command(
    cls=JsonCommand,
    epilog="Example: trend --example campanha-2008-clearance --plot clearance.png.",
)(trend)
app.command(cls=JsonCommand, epilog="Example: turn case.toml --plot turn.png.")(turn)
app.command(cls=JsonCommand, epilog="Example: tolerance scatter.nc --plot bands.png.")(tolerance)
app.command(
    cls=JsonCommand, epilog="Example: reproduce radaelli-2013 --output radaelli --lang pt."
)(reproduce)
app.command(cls=JsonCommand)(verify)
app.add_typer(catalogue_app, name="catalogue")


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
