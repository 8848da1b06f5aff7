"""`rolamento tolerance`: percentiles of a scatter study's outputs, and which input matters most."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated, Any

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    Language,
    LanguageOption,
    plain_endings,
    same_file,
    words_of,
)
from rolamento.cli.streams import STANDARD_STREAM, print_text, put
from rolamento.errors import FileError, InputError

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
    json: Annotated[
        str | None,
        typer.Option(
            "--json",
            metavar="[FILE]",
            help="Write everything as JSON, in SI units; without FILE, to standard output.",
        ),
    ] = None,
    plot: Annotated[
        str | None,
        typer.Option("--plot", metavar="FILE", help="Draw it: a .png, .svg or .pdf file."),
    ] = None,
    lang: LanguageOption = None,
) -> None:
    """Show percentiles of every output of a scatter study, and which input matters most."""
    with plain_endings(lang):
        wanted = _percentiles(percentiles)
        _check_outputs(result, json, plot)
        with _waiting(lang):
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


def _check_outputs(result: str, json: str | None, plot: str | None) -> None:
    """Refuse outputs that would run into each other or over the result, before any work."""
    if json is not None and json == plot:
        raise InputError("only one of --json and --plot can go there", source=json)
    for path in (json, plot):
        if path is not None and same_file(path, result):
            raise FileError("is the study itself; choose another name", source=path)
    if plot is not None:
        from rolamento.plots.saving import check_name

        check_name(plot)


@contextmanager
def _waiting(lang: Language | None) -> Iterator[None]:
    """Tell whoever waits at a terminal for long why."""
    if sys.stderr is None or not sys.stderr.isatty():
        yield
        return
    from rolamento.cli.waiting import told

    with told(words_of(lang).waiting):
        yield


def _found(
    result: str, percentiles: tuple[float, ...], sobol: int | None
) -> tuple[Any, ToleranceStudy]:
    """Read or run the study, and take it apart."""
    from rolamento._reading import format_of_path
    from rolamento.report.tolerance import ToleranceStudy
    from rolamento.studies import load_study, run, sensitivity
    from rolamento.studies.dataset import load_result
    from rolamento.studies.samples import samples_of
    from rolamento.studies.tolerance import tolerance_bands

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
