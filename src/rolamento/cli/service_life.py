"""`rolamento service-life`: what ends a bearing first."""

from __future__ import annotations

from typing import Annotated

import typer

from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import CaseArgument, JsonOption, LanguageOption, plot_option
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, put
from rolamento.cli.waiting import waiting

__all__ = ["app", "service_life_command"]

app = typer.Typer()


@app.command(
    "service-life",
    cls=JsonCommand,
    epilog="Examples: service-life 6205-2RS1 --fr '500 N' --speed '3000 rpm' --temperature"
    " '80 degC'; service-life motor.toml --plot ends.png.",
)
@with_outputs
@with_case
def service_life_command(
    case: CaseArgument,
    given: CaseOptions = NOTHING_GIVEN,
    plot: Annotated[str | None, plot_option("Draw the time line")] = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show what ends a bearing first: fatigue, grease or another.

    Everything that is known on one time line, with its spread, beside the required life.
    """
    with plain_endings(lang), given.in_force():
        outputs.check({"--json": json, "--plot": plot}, case)
        from rolamento.tasks.time_line import service_life

        chosen = given.case(case, needs_load=True)
        with waiting(lang):
            found = service_life(chosen)
        if json is not None:
            put(found.to_json() + "\n", json)
        if plot is not None:
            from rolamento.plots.saving import save_figure
            from rolamento.plots.service_life import service_life_figure

            save_figure(service_life_figure(found), plot)
        from rolamento.pages.service_life import service_life_page

        outputs.show(lambda: service_life_page(found), json)
        if STANDARD_STREAM in (json, outputs.csv) and not found.converged:
            from rolamento.words.reasons import reason

            complain(reason(str(found.solved.status.code[0])))
    raise typer.Exit(SOLVED if found.first is not None else NO_RESULT)
