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
from rolamento.errors import InputError
from rolamento.words import said

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from rolamento.case import Case
    from rolamento.document import Document
    from rolamento.studies.heat_curves import HeatOver
    from rolamento.units import Dimension

__all__ = ["app", "heat"]

_SCHEMA: Final = 1
_POINTS: Final = 13
"""Each point is a balance of its own: some hundred solutions."""


app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Examples: heat 6220 --fr '10 kN' --speed '3000 rpm' --lubricant 'ISO VG 68'; heat"
    " spindle.toml --over duty.inner_speed=2000..12000rpm --plot heat.png; heat spindle.toml --time"
    " '1 h'; heat spindle.toml --compare --oil-for '60 degC'.",
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
    time: Annotated[
        str | None,
        typer.Option(
            "--time",
            metavar="DURATION",
            help="Start up from ambient temperature, such as '1 h'; steps runs those of [heat].",
        ),
    ] = None,
    plan: Annotated[
        str | None,
        typer.Option(
            "--warm-up",
            metavar="LIMIT",
            help="Plan steps of speed that keep the preload or every part below a limit, such as"
            " '1500 N' or '60 degC'.",
        ),
    ] = None,
    compare: Annotated[
        bool,
        typer.Option(
            "--compare",
            help="Springs beside rigid preload, ceramic beside steel, the distance of rows that"
            " keeps the preload, the highest speed.",
        ),
    ] = False,
    oil_for: Annotated[
        str | None,
        typer.Option(
            "--oil-for",
            metavar="TEMPERATURE",
            help="With --compare, the oil flow that keeps every part below it, such as '60 degC'.",
        ),
    ] = None,
    plot: Annotated[str | None, plot_option("Draw the balance, the field or the time")] = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show how warm a bearing runs, and what becomes of its preload.

    Friction balanced by the heat that [heat] lets out; cold beside warm, or in time.
    """
    with plain_endings(lang), given.in_force():
        _check_alone({"--over": over, "--time": time, "--warm-up": plan, "--compare": compare})
        if oil_for is not None and not compare:
            raise InputError(
                said("is for --compare"), source="--oil-for", value=oil_for, example="--compare"
            )
        outputs.check({"--json": json, "--plot": plot}, case)
        chosen = given.case(case, needs_load=over is None)
        if time is not None:
            solved = _in_time(chosen, time, json, plot, outputs, lang)
        elif plan is not None:
            solved = _planned(chosen, plan, json, plot, outputs, lang)
        elif compare:
            solved = _compared(chosen, oil_for, json, plot, outputs, lang)
        elif over is None:
            solved = _one(chosen, json, plot, outputs, lang)
        else:
            solved = _over(chosen, over, points, log, json, plot, outputs, lang)
    raise typer.Exit(SOLVED if solved else NO_RESULT)


def _check_alone(given: dict[str, object]) -> None:
    """Refuse options of which one is enough."""
    named = [name for name, value in given.items() if value]
    if len(named) > 1:
        raise InputError(said("cannot be combined with {before}", before=named[0]), source=named[1])


def _number(text: str, dimension: Dimension, option: str) -> float:
    from rolamento.units import to_si

    try:
        return to_si(text, dimension)
    except InputError as error:
        raise error.with_details(source=option) from None


def _in_time(
    case: Case,
    time: str,
    json: str | None,
    plot: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    """Show how the bearing runs up; return whether it does."""
    from rolamento.heat import heat_transient

    duration = None if time.strip() == "steps" else _number(time, "time", "--time")
    with waiting(lang):
        try:
            found = heat_transient(case, duration)
        except InputError as error:
            if error.field != "duration":
                raise
            raise error.with_details(field="", source="--time", example="--time '1 h'") from None
    if json is not None:
        put_json({"schema": _SCHEMA, "kind": "heat_time", **found.to_mapping()}, json)
    if plot is not None:
        from rolamento.plots.heat import heat_time_figure
        from rolamento.plots.saving import save_figure

        save_figure(heat_time_figure([("", found)]), plot)
    from rolamento.pages.heat_time import heat_time_page

    outputs.show(lambda: heat_time_page(found), json)
    _complain(found.status, json, outputs)
    return found.converged


def _planned(
    case: Case,
    limit: str,
    json: str | None,
    plot: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    """Show a plan that stays below a limit; return whether there is one."""
    from rolamento.pages.heat_time import warm_up_figure, warm_up_page
    from rolamento.tasks.heat import limit_of_text, warm_up

    try:
        chosen = limit_of_text(limit)
    except InputError as error:
        raise error.with_details(source="--warm-up") from None
    with waiting(lang):
        found = warm_up(case, **chosen)
    if json is not None:
        put_json({"schema": _SCHEMA, "kind": "warm_up", **found.to_mapping()}, json)
    if plot is not None:
        from rolamento.plots.saving import save_figure

        save_figure(warm_up_figure(found), plot)
    outputs.show(lambda: warm_up_page(found), json)
    return found.transient is not None


def _compared(
    case: Case,
    oil_for: str | None,
    json: str | None,
    plot: str | None,
    outputs: Outputs,
    lang: Language | None,
) -> bool:
    """Show what a balance is asked for; return whether the case as it is given has one."""
    from rolamento.tasks.heat import heat_answers

    most = None if oil_for is None else _number(oil_for, "temperature", "--oil-for")
    with waiting(lang):
        found = heat_answers(case, most)
    if json is not None:
        put_json({"schema": _SCHEMA, "kind": "heat_answers", **found.to_mapping()}, json)
    if plot is not None:
        from rolamento.plots.heat import heat_variants_figure
        from rolamento.plots.saving import save_figure

        save_figure(heat_variants_figure(found.variants), plot)
    from rolamento.pages.heat_answers import heat_answers_page

    outputs.show(lambda: heat_answers_page(found), json)
    _complain(found.balance.status, json, outputs)
    return found.balance.converged


def _complain(status: str, json: str | None, outputs: Outputs) -> None:
    """Say beside data why there is no result."""
    if STANDARD_STREAM in (json, outputs.csv) and status != "converged":
        from rolamento.words.reasons import reason

        complain(reason(status))


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
    _complain(found.status, json, outputs)
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
