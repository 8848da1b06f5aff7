"""The commands by their names. One is read when it is called: `--version` waits for nothing."""

from __future__ import annotations

import atexit
import gc
import sys
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from importlib import import_module
from itertools import chain
from typing import Annotated, Any, Final

import typer
from typer.main import get_group_from_info
from typer.models import TyperInfo

import rolamento
from rolamento.cli.common import SOLVED, WRONG_INPUT, plain_endings
from rolamento.cli.grouped_help import GroupedCommands, Groups
from rolamento.cli.options import LanguageOption
from rolamento.cli.streams import end_of_output, print_text

COMMANDS: Final[Groups] = {
    "To start with": ("demo", "app", "new", "examples", "warm"),
    "Inside the bearing": ("solve", "turn", "friction", "heat", "static", "electrical", "report"),
    "The machine around it": ("shaft", "rotor", "import", "export"),
    "Life and life tests": (
        *("service-life", "life", "oscillation", "weibull", "weibull-plan", "replace", "trend"),
    ),
    "Vibration": ("frequencies", "diagnose", "severity", "synthesise", "anderon"),
    "Catalogue and clearance": ("catalogue", "clearance", "speed"),
    "Lubrication": ("grease", "oil"),
    "Studies and figures": ("sweep", "tolerance", "seek", "plot"),
    "Verification": ("verify", "reproduce"),
}
"""What a person wants, and the commands for it: in the help, the front pages and the guide."""


_MODULES: Final = {
    "app": "browser", "examples": "new", "import": "exchange", "export": "exchange",
}  # fmt: skip
"""Modules of commands that have none of their own name."""

_REQUESTS: Final = {
    "anderon": "noise:NoiseLevel",
    "clearance": "running:ClearanceRequest",
    "diagnose": "vibration_diagnosis:VibrationDiagnosis",
    "electrical": "inside:ElectricalRequest",
    "frequencies": "running:FrequenciesRequest",
    "friction": "inside:FrictionRequest",
    "grease": "lasting:GreaseRequest",
    "heat": "inside:HeatRequest",
    "life": "lasting:LifeRequest",
    "oil": "lasting:OilRequest",
    "oscillation": "lasting:OscillationRequest",
    "seek": "seek:GoalSeek",
    "service-life": "lasting:ServiceLifeRequest",
    "severity": "severity:VibrationSeverity",
    "solve": "inside:SolveRequest",
    "speed": "running:SpeedRequest",
    "static": "inside:StaticRequest",
    "trend": "weibull:TrendEvaluation",
    "turn": "inside:TurnRequest",
    "weibull": "weibull:LifeTestEvaluation",
}
"""Commands that are made of a request."""

_SOLVING: Final = {
    "demo", "app", "solve", "turn", "friction", "heat", "static", "electrical", "report", "life",
    "sweep", "seek", "shaft", "rotor", "export", "oscillation", "grease", "service-life",
}  # fmt: skip
"""Commands after the first of which the solver is compiled in the background."""

_LITTLE_GARBAGE: Final = 250_000
"""Objects made between two looks for garbage: nearly all that a start makes stay."""


class _Commands(Mapping[str, Any]):
    """The commands of the program; the module of one is imported when it is asked for."""

    def __getitem__(self, name: str) -> Any:
        if name not in self:
            raise KeyError(name)
        return _command(name)

    def __contains__(self, name: object) -> bool:
        return any(name in names for names in COMMANDS.values())

    def __iter__(self) -> Iterator[str]:
        return chain.from_iterable(COMMANDS.values())

    def __len__(self) -> int:
        return sum(map(len, COMMANDS.values()))


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
    gc.set_threshold(_LITTLE_GARBAGE)
    atexit.register(gc.freeze)  # at the end all memory is given back: nobody has to search it
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
