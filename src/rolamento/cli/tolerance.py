"""`rolamento tolerance`: percentiles of a scatter study's outputs, and which input matters most."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    plain_endings,
)
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import JsonOption, LanguageOption, PlotOption
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.streams import put
from rolamento.cli.waiting import waiting
from rolamento.errors import InputError
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.studies.sensitivity import ToleranceStudy

__all__ = ["app", "tolerance"]


app = typer.Typer()


@app.command(cls=JsonCommand, epilog="Example: tolerance scatter.nc --plot bands.png.")
@with_outputs
def tolerance(
    result: Annotated[
        str,
        typer.Argument(
            metavar="RESULT",
            help="Result of a scatter study (.nc), or a study file with [scatter] to run.",
        ),
    ],
    percentiles: Annotated[
        str | None,
        typer.Option(
            "--percentiles", metavar="LIST", help="Percentiles in per cent, such as 5,50,95."
        ),
    ] = None,
    sobol: Annotated[
        int | None,
        typer.Option(
            "--sobol",
            metavar="N",
            help="Also Sobol's indices, from N (inputs + 2) runs of a study file; N such as 1024.",
        ),
    ] = None,
    json: JsonOption = None,
    plot: PlotOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show percentiles of a study, and which inputs matter.

    For every output of a scatter study, with the inputs that it depends on most.
    """
    with plain_endings(lang):
        wanted = _percentiles(percentiles)
        outputs.check(
            {"--json": json, "--plot": plot},
            result,
            rule=marked("is the study itself; choose another name"),
        )
        with waiting(lang):
            from rolamento.tasks import studies

            found = studies.tolerance(result, percentiles=wanted, sobol_samples=sobol)
        _show(found, json, plot, outputs)
    raise typer.Exit(SOLVED if found.bands.share_without_result < 1.0 else NO_RESULT)


def _percentiles(text: str | None) -> tuple[float, ...]:
    from rolamento.studies.tolerance import PERCENTILES

    if text is None:
        return PERCENTILES
    try:
        values = [float(part) for part in text[:2000].split(",")]
    except ValueError:
        raise InputError(
            said("must be numbers separated by commas"),
            field="--percentiles",
            value=text,
            example="5,50,95",
        ) from None
    return tuple(values)


def _show(found: ToleranceStudy, json: str | None, plot: str | None, outputs: Outputs) -> None:
    """Write what was asked for; standard output takes data or the page, not both."""
    if json is not None:
        from rolamento.io.json import dumps

        put(dumps(found.to_mapping()) + "\n", json)
    if plot is not None:
        from rolamento.plots.saving import save_figure
        from rolamento.plots.tolerance import tolerance_figure

        save_figure(tolerance_figure(found), plot)
    from rolamento.pages.tolerance import tolerance_page

    outputs.show(lambda: tolerance_page(found), json)
