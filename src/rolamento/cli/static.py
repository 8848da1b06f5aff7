"""`rolamento static`: static safety of a bearing, allowable pressures, gaps, hardness."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Final

import typer

from rolamento.cli.case_options import NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import CaseArgument, JsonOption, LanguageOption, plot_option
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, put_json
from rolamento.cli.waiting import waiting

if TYPE_CHECKING:
    from rolamento.case import Case
    from rolamento.document import Document

__all__ = ["app", "static"]

_SCHEMA: Final = 1

app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Examples: static 6310 --fr '20 kN' --set static.operation=shock; static pair.toml --set"
    " static.load_factor=1.4 --set static.allowable_pressure='3200 MPa'.",
)
@with_outputs
@with_case
def static(
    case: CaseArgument,
    given: CaseOptions = NOTHING_GIVEN,
    plot: Annotated[str | None, plot_option("Draw safety and gaps over the load")] = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show static safety, launch loads, gaps and hardness.

    By stress and by load at every contact, beside what makers recommend; margins to allowable
    pressures, and at which load a preloaded pair opens.
    """
    with plain_endings(lang), given.in_force():
        outputs.check({"--json": json, "--plot": plot}, case)
        chosen = given.case(case)
        from rolamento.safety import static_safety_of

        with waiting(lang):
            found = static_safety_of(chosen)
        if plot is not None:
            _draw(chosen, plot)
        if json is not None:
            put_json({"schema": _SCHEMA, "kind": "static", **found.to_mapping()}, json)

        def page() -> Document:
            from rolamento.pages.static import static_page

            return static_page(found)

        outputs.show(page, json)
        converged = bool(found.solved.converged[0])
        if STANDARD_STREAM in (json, outputs.csv) and not converged:
            from rolamento.words.reasons import reason

            complain(reason(str(found.solved.status.code[0])))
    raise typer.Exit(SOLVED if converged else NO_RESULT)


def _draw(case: Case, path: str) -> None:
    """Draw safety and gaps over the load."""
    from rolamento.plots.saving import save_figure
    from rolamento.plots.static import static_figure
    from rolamento.safety import static_over_load

    save_figure(static_figure(static_over_load(case)), path)
