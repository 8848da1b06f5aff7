"""The commands by their names. One is read when it is called: `--version` waits for nothing."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from importlib import import_module
from typing import Annotated, Any, Final

import typer
from typer.main import get_group_from_info
from typer.models import TyperInfo

import rolamento
from rolamento.cli.common import SOLVED, WRONG_INPUT, LanguageOption, plain_endings
from rolamento.cli.grouped_help import GroupedCommands
from rolamento.cli.streams import end_of_output, print_text
from rolamento.words import marked, said

COMMANDS: Final[Mapping[str, Mapping[str, str]]] = {
    "To start with": {
        "demo": marked("Solve the shipped example, and suggest what to try next."),
        "app": marked("Open the app in the browser."),
        "new": marked("Write a commented case file to start from."),
        "examples": marked("List the shipped examples, or copy one or all of them."),
        "warm": marked("Compile the solver for this machine, once."),
    },
    "Inside the bearing": {
        "solve": marked("Show the internal state of a bearing under its duty."),
        "turn": marked("Show what varies while the cage turns by one pitch."),
        "friction": marked("Show the friction torque by every model."),
        "heat": marked("Show how warm a bearing runs, and what becomes of its preload."),
        "static": marked("Show static safety, launch loads, gaps and hardness."),
        "electrical": marked("Show a bearing as a capacitor: current, field, breakdown."),
        "report": marked("Write a calculation report to sign, of one case or several."),
    },
    "The machine around it": {
        "shaft": marked("Show loads, tilts and lives of the bearings on shafts."),
        "rotor": marked("Show natural frequencies and critical speeds of shafts."),
        "import": marked("Make a machine file from a REXS model."),
        "export": marked("Write a machine or its bearings for another program."),
    },
    "Life and life tests": {
        "service-life": marked("Show what ends a bearing first: fatigue, grease or another."),
        "life": marked("Show the life by every theory, and what would help."),
        "oscillation": marked("Show the life of a bearing that swings instead of turning."),
        "weibull": marked("Fit a Weibull distribution to a life test, with bounds."),
        "weibull-plan": marked("Plan a life test: bearings, time, failures."),
        "replace": marked("Plan to keep or to replace bearings."),
        "trend": marked("Show what changed in operation, and when it reaches a limit."),
    },
    "Vibration": {
        "frequencies": marked("Show the fault frequencies of a bearing, also under load."),
        "diagnose": marked("Diagnose damaged parts of a bearing from a vibration signal."),
        "severity": marked("Show the vibration severity in mm/s and its zone."),
        "synthesise": marked("Make a vibration signal of a bearing with known damage."),
        "anderon": marked("Show the noise in anderons and µm/s, and whether it passes."),
    },
    "Catalogue and clearance": {
        "catalogue": marked("Search bearings, and show the internal geometry of one."),
        "clearance": marked("Show the clearance in operation, and the preload of a set."),
        "speed": marked("Show how fast a bearing may run, and the load that it needs."),
    },
    "Lubrication": {
        "grease": marked("Show how long a grease lives, and which one to take."),
        "oil": marked("Show which ISO viscosity grade gives the required κ."),
    },
    "Studies and figures": {
        "sweep": marked("Solve many cases: ranges of fields, or random draws."),
        "tolerance": marked("Show percentiles of a study, and which inputs matter."),
        "seek": marked("Find the input that brings an output to a target value."),
        "plot": marked("Draw a state, its life or a study; several share a figure."),
    },
    "Verification": {
        "verify": marked("Compare the program with published numbers."),
        "reproduce": marked("Reproduce every figure and table of a publication."),
    },
}
"""What a person wants, and the commands for it: in the help, the front pages and the guide.

Each with the first line of its own help, so that the list imports none of them.
"""

_LINES: Final = {name: line for lines in COMMANDS.values() for name, line in lines.items()}

_MODULES: Final = {
    "app": "browser",
}  # fmt: skip
"""Modules of commands that have none of their own name."""

_REQUESTS: Final = {
    "anderon": "noise:NoiseLevel",
    "clearance": "running:ClearanceRequest",
    "diagnose": "vibration_diagnosis:VibrationDiagnosis",
    "electrical": "inside:ElectricalRequest",
    "frequencies": "running:FrequenciesRequest",
    "examples": "new_case:ExamplesRequest",
    "export": "exchange:ExportRequest",
    "friction": "inside:FrictionRequest",
    "grease": "lasting:GreaseRequest",
    "heat": "inside:HeatRequest",
    "import": "exchange:ImportRequest",
    "life": "lasting:LifeRequest",
    "new": "new_case:NewRequest",
    "oil": "lasting:OilRequest",
    "oscillation": "lasting:OscillationRequest",
    "plot": "studying:PlotRequest",
    "report": "inside:ReportRequest",
    "rotor": "rotor:RotorRequest",
    "seek": "seek:GoalSeek",
    "service-life": "lasting:ServiceLifeRequest",
    "severity": "severity:VibrationSeverity",
    "shaft": "machines:ShaftRequest",
    "solve": "inside:SolveRequest",
    "speed": "running:SpeedRequest",
    "static": "inside:StaticRequest",
    "sweep": "studying:SweepRequest",
    "synthesise": "recipe:SynthesisRequest",
    "tolerance": "studying:ToleranceRequest",
    "trend": "weibull:TrendEvaluation",
    "turn": "inside:TurnRequest",
    "verify": "verifying:VerificationRequest",
    "weibull": "weibull:LifeTestEvaluation",
}
"""Commands that are made of a request."""

_SOLVING: Final = {
    "demo", "app", "solve", "turn", "friction", "heat", "static", "electrical", "report", "life",
    "sweep", "seek", "shaft", "rotor", "export", "oscillation", "grease", "service-life",
}  # fmt: skip
"""Commands after the first of which the solver is compiled in the background."""


class _Commands(Mapping[str, Any]):
    """The commands of the program; the module of one is imported when it is asked for."""

    def __getitem__(self, name: str) -> Any:
        if name not in self:
            raise KeyError(name)
        return _command(name)

    def __contains__(self, name: object) -> bool:
        return name in _LINES

    def __iter__(self) -> Iterator[str]:
        return iter(_LINES)

    def __len__(self) -> int:
        return len(_LINES)


@cache
def _command(name: str) -> Any:
    if name in _REQUESTS:
        from rolamento.cli.requested import program_of

        program = program_of(_REQUESTS[name], name)
    else:
        module = _MODULES.get(name, name.replace("-", "_"))
        program = import_module(f"{__package__}.{module}").app
    of_module = get_group_from_info(
        TyperInfo(program, name=name),
        pretty_exceptions_short=True,
        suggest_commands=True,
        rich_markup_mode=None,
    )
    return of_module.commands.get(name, of_module)


class Program(GroupedCommands):
    """`rolamento`, its commands in groups."""

    groups = COMMANDS

    def __init__(self, **given: Any) -> None:
        super().__init__(**given)
        self.commands = _Commands()  # type: ignore[assignment]  # of which nobody takes one away

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse the arguments before the command; its module is imported first.

        NumPy then comes before ``typing_extensions`` of pydantic, which makes typing slow.
        """
        self.get_command(ctx, next(filter(self.commands.__contains__, args), ""))
        return super().parse_args(ctx, args)

    def line_of(self, name: str) -> str:
        """Return what a command does, in one line; its module is not imported for it."""
        return said(_LINES[name])


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


def run() -> None:
    """Run the command that the process was called with, and end the process."""
    try:
        app(prog_name="rolamento")
    except SystemExit as end:
        if not end.code:  # who mistyped gets one line alone
            _compile_once(sys.argv[1:])
        raise
    except OSError as error:
        if error.filename is not None:  # no stream, but a file that somebody should have guarded
            raise
        end_of_output(error)  # the help, which Typer writes
        sys.exit(WRONG_INPUT)


def _compile_once(words: Sequence[str]) -> None:
    """After the first answer on a machine, compile what later ones will be faster with."""
    if not words or words[0] not in _SOLVING or {"-h", "--help"} & {*words}:
        return
    from rolamento.numerics.beside import compile_beside, has_begun

    if not has_begun(rolamento.__version__):
        compile_beside()


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
