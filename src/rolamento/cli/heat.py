"""`rolamento heat`: how warm a bearing runs, and what becomes of its preload."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Final

import typer

from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import NO_RESULT, SOLVED, Language, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import CaseArgument, JsonOption, LanguageOption, plot_option
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.over_field import LogOption, PointsOption, show_curves
from rolamento.cli.streams import STANDARD_STREAM, complain, put_json
from rolamento.cli.waiting import waiting

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from rolamento.case import Case
    from rolamento.document import Document
    from rolamento.studies.heat_curves import HeatOver

__all__ = ["app", "heat"]

_SCHEMA: Final = 1
_POINTS: Final = 13
"""Each point is a balance of its own: some hundred solutions."""


app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Examples: heat 6220 --fr '10 kN' --speed '3000 rpm' --lubricant 'ISO VG 68'; heat"
    " spindle.toml --over duty.inner_speed=2000..12000rpm --plot heat.png.",
)
@with_outputs
@with_case
def heat(
    case: CaseArgument,
    given: CaseOptions = NOTHING_GIVEN,
    over: Annotated[
        str | None,
        typer.Option(
            "--over",
            metavar="FIELD=FIRST..LAST",
            help="Vary a field, such as duty.inner_speed=1000..6000rpm or"
            " bearing.preload.force=100..500N.",
        ),
    ] = None,
    points: PointsOption = _POINTS,
    log: LogOption = False,
    plot: Annotated[str | None, plot_option("Draw the balance, or with --over the field")] = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show how warm a bearing runs, and what becomes of its preload.

    Friction balanced by the heat that [heat] lets out; cold beside warm.
    """
    with plain_endings(lang), given.in_force():
        outputs.check({"--json": json, "--plot": plot}, case)
        chosen = given.case(case, needs_load=over is None)
        if over is None:
            solved = _one(chosen, json, plot, outputs, lang)
        else:
            solved = _over(chosen, over, points, log, json, plot, outputs, lang)
    raise typer.Exit(SOLVED if solved else NO_RESULT)


def _one(
    case: Case, json: str | None, plot: str | None, outputs: Outputs, lang: Language | None
) -> bool:
    """Show the balance of the case itself; return whether it has a state."""
    from rolamento.heat import heat_balance

    with waiting(lang):
        found = heat_balance(case)
    if json is not None:
        put_json({"schema": _SCHEMA, "kind": "heat", **found.to_mapping()}, json)
    if plot is not None:
        from rolamento.plots.heat import heat_figure
        from rolamento.plots.saving import save_figure

        save_figure(heat_figure(found), plot)
    from rolamento.pages.heat import heat_page

    outputs.show(lambda: heat_page(found), json)
    if STANDARD_STREAM in (json, outputs.csv) and not found.converged:
        from rolamento.words.reasons import reason

        complain(reason(found.status))
    return found.converged


def _over(
    case: Case,
    over: str,
    points: int,
    log: bool,
    json: str | None,
    plot: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    """Show the balance over a field; return whether every point has a state."""
    from rolamento.studies.heat_curves import heat_over
    from rolamento.studies.ranges import read_range

    chosen = read_range(over, points, log=log)
    with waiting(lang):
        found = heat_over(case, chosen)

    def page(shown: Sequence[HeatOver]) -> Document:
        from rolamento.pages.heat import heat_over_page

        return heat_over_page(shown[0])

    def figure(shown: Sequence[HeatOver]) -> Figure:
        from rolamento.plots.heat import heat_over_figure

        return heat_over_figure(shown[0])

    def json_text(shown: Sequence[HeatOver]) -> str:
        from rolamento.io.json import dumps

        return dumps(shown[0].to_mapping(), indent=2)

    return show_curves([found], page, json_text, figure, json, plot, outputs, lang)
