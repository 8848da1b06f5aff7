"""`rolamento tolerance`: percentiles of a scatter study's outputs, and which input matters most."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated, Any

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    Language,
    plain_endings,
    words_of,
)
from rolamento.cli.options import JsonOption, LanguageOption, PlotOption
from rolamento.cli.outputs import check_outputs
from rolamento.cli.streams import STANDARD_STREAM, print_text, put
from rolamento.cli.waiting import waiting
from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.report.tolerance import ToleranceStudy

__all__ = ["tolerance"]


def tolerance(
    result: Annotated[
        str,
        typer.Argument(
            metavar="RESULT",
            help="Result of a scatter study (.nc), or a study file with a [scatter] to be run.",
        ),
    ],
    percentiles: Annotated[
        str | None,
        typer.Option("--percentiles", metavar="LIST", help="Such as 5,50,95; in per cent."),
    ] = None,
    sobol: Annotated[
        int | None,
        typer.Option(
            "--sobol",
            metavar="N",
            help="Sobol's indices too, from N (inputs + 2) runs of a study file; N such as 1024.",
        ),
    ] = None,
    json: JsonOption = None,
    plot: PlotOption = None,
    lang: LanguageOption = None,
) -> None:
    """Show percentiles of a study, and which input matters.

    Of every output of a scatter study, with the inputs that it depends on most.
    """
    with plain_endings(lang):
        wanted = _percentiles(percentiles)
        check_outputs({"--json": json, "--plot": plot}, result, rule="is the study itself")
        with waiting(lang):
            dataset, found = _found(result, wanted, sobol)
        _show(dataset, found, json, plot, lang)
    some = int(found.bands.without_result.sum()) < found.bands.samples * max(
        found.bands.without_result.size, 1
    )
    raise typer.Exit(SOLVED if some else NO_RESULT)


def _percentiles(text: str | None) -> tuple[float, ...]:
    from rolamento.studies.tolerance import PERCENTILES, checked_percentiles

    if text is None:
        return PERCENTILES
    try:
        values = [float(part) for part in text[:2000].split(",")]
    except ValueError:
        raise InputError(
            "must be numbers with commas between them",
            field="--percentiles",
            value=text,
            example="5,50,95",
        ) from None
    return checked_percentiles(values)


def _found(
    result: str, percentiles: tuple[float, ...], sobol: int | None
) -> tuple[Any, ToleranceStudy]:
    """Read or run the study, and take it apart."""
    from rolamento._reading import format_of_path
    from rolamento.report.tolerance import ToleranceStudy
    from rolamento.studies import load_study, run, sensitivity
    from rolamento.studies.dataset import load_result
    from rolamento.studies.tolerance import samples_of, tolerance_bands

    indices = None
    if result == STANDARD_STREAM or format_of_path(result) is not None:
        study = load_study(result)
        if study.scatter is None:
            raise InputError(
                "is missing: there is nothing to take percentiles of",
                field="scatter",
                source=result,
            )
        indices = None if sobol is None else sensitivity.sobol(study, samples=sobol)
        dataset = run(study)
    elif sobol is not None:
        raise InputError(
            "needs the study file: indices come from runs of their own",
            field="--sobol",
            source=result,
            example="rolamento tolerance study.toml --sobol 1024",
        )
    else:
        dataset = load_result(result)
    samples = samples_of(dataset)
    ranks = sensitivity.rank_correlation(dataset) if samples.inputs else None
    title = str(dataset.attrs.get("title", ""))
    bands = tolerance_bands(dataset, percentiles)
    return dataset, ToleranceStudy(title, samples, bands, ranks, indices)


def _show(
    dataset: Any,
    found: ToleranceStudy,
    json: str | None,
    plot: str | None,
    lang: Language | None,
) -> None:
    """Write what was asked for; standard output takes data or the report, not both."""
    from rolamento.report.tolerance import tolerance_json, tolerance_report

    words = words_of(lang)
    if json is not None:
        put(tolerance_json(found) + "\n", json)
    if plot is not None:
        if found.ranks is None:
            raise InputError("has no scattered input to draw", field="scatter.fields")
        from rolamento.plots.saving import save_figure
        from rolamento.plots.tolerance import tolerance_figure

        save_figure(tolerance_figure(dataset, found.bands, found.ranks, words.code), plot)
    if json == STANDARD_STREAM:
        return
    from rolamento.report.medium import Medium

    print_text(tolerance_report(found, words, Medium.of(sys.stdout)))
