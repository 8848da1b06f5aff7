"""`rolamento turn`: what a bearing does while the cage turns by one pitch."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated, Final

import typer

import rolamento
from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    CaseArgument,
    JsonOption,
    Language,
    LanguageOption,
    SettingsOption,
    plain_endings,
    same_file,
    words_of,
)
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text, put
from rolamento.errors import FileError, InputError

if TYPE_CHECKING:
    from rolamento.studies.cage_turn import CageTurn

__all__ = ["turn"]

_POINTS: Final = 256


def turn(
    case: CaseArgument,
    points: Annotated[
        int,
        typer.Option("--points", metavar="N", help="Instants in one period, 4 to 4096."),
    ] = _POINTS,
    json: JsonOption = None,
    csv: Annotated[
        str | None,
        typer.Option(
            "--csv", metavar="FILE", help="Write a table of the instants; - is standard output."
        ),
    ] = None,
    plot: Annotated[
        str | None,
        typer.Option("--plot", metavar="FILE", help="Draw it: a .png, .svg or .pdf file."),
    ] = None,
    settings: SettingsOption = None,
    lang: LanguageOption = None,
) -> None:
    """Show how displacement, stiffness and ball loads vary while the cage turns by one pitch."""
    with plain_endings(lang):
        _check_outputs(case, json, csv, plot)
        turned = _turned(rolamento.load_case(case, settings or ()), points, lang)
        _show(turned, json, csv, plot, lang)
    raise typer.Exit(SOLVED if turned.converged else NO_RESULT)


def _check_outputs(case: str, json: str | None, csv: str | None, plot: str | None) -> None:
    """Refuse outputs that would run into each other or over the case file, before any work."""
    given = [path for path in (json, csv, plot) if path is not None]
    for path in given:
        if given.count(path) > 1:
            where = "standard output" if path == STANDARD_STREAM else path
            raise InputError("only one of --json, --csv and --plot can go there", source=where)
        if same_file(path, case):
            raise FileError("is the case file itself; choose another name", source=path)
    if plot is not None:
        from rolamento.plots.saving import check_name

        check_name(plot)


def _turned(case: rolamento.Case, points: int, lang: Language | None) -> CageTurn:
    """Solve every instant; whoever waits at a terminal for long is told why."""
    from rolamento.studies.cage_turn import cage_turn

    if sys.stderr is None or not sys.stderr.isatty():
        return cage_turn(case, points=points)
    from rolamento.cli.waiting import told

    with told(words_of(lang).waiting):
        return cage_turn(case, points=points)


def _show(
    turned: CageTurn, json: str | None, csv: str | None, plot: str | None, lang: Language | None
) -> None:
    """Write what was asked for; standard output takes data or the report, not both."""
    from rolamento.report.turn import turn_csv, turn_json, turn_report

    words = words_of(lang)
    if json is not None:
        put(turn_json(turned) + "\n", json)
    if csv is not None:
        put(turn_csv(turned), csv)
    if plot is not None:
        from rolamento.plots.cage_turn import cage_turn_figure
        from rolamento.plots.saving import save_figure

        save_figure(cage_turn_figure(turned, words.code), plot)
    if STANDARD_STREAM not in (json, csv):
        from rolamento.report.medium import Medium

        print_text(turn_report(turned, words, Medium.of(sys.stdout)))
    elif not turned.converged:
        failed = int((turned.status != "converged").sum())
        complain(f"{failed} / {len(turned)}: {words.reasons[str(_first_failure(turned))]}")


def _first_failure(turned: CageTurn) -> str:
    return str(turned.status[turned.status != "converged"][0])
