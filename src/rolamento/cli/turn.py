"""`rolamento turn`: what a bearing does while the cage turns by one pitch."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Final

import typer

import rolamento
from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    Language,
    complain_of_points,
    plain_endings,
)
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import (
    CaseArgument,
    JsonOption,
    LanguageOption,
    PlotOption,
)
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import STANDARD_STREAM, put_json
from rolamento.cli.waiting import waiting

if TYPE_CHECKING:
    from rolamento.studies.cage_turn import CageTurn

__all__ = ["app", "turn"]

_POINTS: Final = 256


app = typer.Typer()


@app.command(cls=JsonCommand, epilog="Example: turn case.toml --plot turn.png.")
@with_outputs
@with_case
def turn(
    case: CaseArgument,
    given: CaseOptions = NOTHING_GIVEN,
    points: Annotated[
        int,
        typer.Option("--points", metavar="N", help="Instants in one period, 4 to 4096."),
    ] = _POINTS,
    json: JsonOption = None,
    plot: PlotOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show what varies while the cage turns by one pitch.

    Displacement, stiffness and ball loads over that period.
    """
    with plain_endings(lang), given.in_force():
        outputs.check({"--json": json, "--plot": plot}, case)
        turned = _turned(given.case(case, needs_load=True), points, lang)
        _show(turned, json, plot, outputs, lang)
    raise typer.Exit(SOLVED if turned.converged else NO_RESULT)


def _turned(case: rolamento.Case, points: int, lang: Language | None) -> CageTurn:
    """Solve every instant."""
    from rolamento.studies.cage_turn import cage_turn

    with waiting(lang):
        return cage_turn(case, points=points)


def _show(
    turned: CageTurn, json: str | None, plot: str | None, outputs: Outputs, lang: Language | None
) -> None:
    """Write what was asked for; standard output takes data or the page, not both."""
    from rolamento.pages.turn import turn_page
    from rolamento.studies.torque_turn import torque_over_turn

    torque = torque_over_turn(turned)

    if json is not None:
        own = {} if torque is None else {"torque": torque.to_mapping()}
        put_json({**turned.to_mapping(), **own}, json)
    if plot is not None:
        from rolamento.plots.cage_turn import cage_turn_figure
        from rolamento.plots.saving import save_figure

        save_figure(cage_turn_figure(turned), plot)
    outputs.show(lambda: turn_page(turned, torque), json)
    if STANDARD_STREAM in (json, outputs.csv) and not turned.converged:
        complain_of_points(turned.status[turned.status != "converged"], len(turned), lang)
