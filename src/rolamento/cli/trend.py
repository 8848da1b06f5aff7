"""`rolamento trend`: what grew while bearings ran: clearance with a law of wear, noise."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated, Final

import typer

from rolamento.cli.common import SOLVED, plain_endings, words_of
from rolamento.cli.options import LanguageOption, PlotOption, json_option
from rolamento.cli.outputs import check_outputs
from rolamento.cli.shipped_data import check_one_given, data_and_json, known_example
from rolamento.cli.streams import STANDARD_STREAM, print_text, put
from rolamento.cli.table_options import DecimalMarkOption, TimeColumnOption, told_in_options
from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.clearance import WearFit, WearLaw
    from rolamento.weibull.trend import Trend

__all__ = ["trend"]

EXAMPLES: Final = ("campanha-2008-clearance", "campanha-2008-anderon")
LAWS: Final[dict[str, WearLaw]] = {
    "running-in": "running_in",
    "running-in-and-steady": "running_in_and_steady",
    "power": "power",
}


def trend(
    data: Annotated[
        str | None,
        typer.Argument(
            metavar="DATA.csv",
            help="Columns of time, bearing and quantities, units in brackets; - is standard input.",
        ),
    ] = None,
    example: Annotated[
        str | None,
        typer.Option("--example", metavar="NAME", help=f"Shipped: {' or '.join(EXAMPLES)}."),
    ] = None,
    law: Annotated[
        str | None,
        typer.Option(
            "--law",
            metavar="LAW",
            help=f"Of wear, fitted to the clearance: {', '.join(LAWS)}; running-in by default where"
            " the first quantity is a length.",
        ),
    ] = None,
    time_column: TimeColumnOption = None,
    bearing_column: Annotated[
        str | None,
        typer.Option(
            "--bearing-column", metavar="COLUMN", help="Column that names the bearing, if another."
        ),
    ] = None,
    decimal_mark: DecimalMarkOption = None,
    plot: PlotOption = None,
    json: Annotated[str | None, json_option("Write everything as JSON")] = None,
    lang: LanguageOption = None,
) -> None:
    """Show what grew while bearings ran: clearance, noise.

    A law of wear is fitted to a clearance.
    """
    with plain_endings(lang):
        data, json = data_and_json(data, example, json)
        check_outputs({"--json": json, "--plot": plot}, data, rule="is the file of the data itself")
        with told_in_options():
            record = _record(data, example, time_column, bearing_column, decimal_mark)
        fits = _fits(record, law)
        words = words_of(lang)
        if plot is not None:
            from rolamento.plots.saving import save_figure
            from rolamento.plots.trend import trend_figure

            save_figure(trend_figure(record, fits, words.code), plot)
        from rolamento.report.medium import Medium
        from rolamento.report.trend import trend_json, trend_report

        if json is not None:
            put(trend_json(record, fits) + "\n", json)
        if json != STANDARD_STREAM:
            print_text(trend_report(record, fits, words, Medium.of(sys.stdout)))
    raise typer.Exit(SOLVED)


def _record(
    data: str | None,
    example: str | None,
    time: str | None,
    bearing: str | None,
    decimal_mark: str | None,
) -> Trend:
    from rolamento.weibull.trend import published_trend, read_trend

    check_one_given(data, example, "trend", EXAMPLES)
    if example is None:
        assert data is not None
        return read_trend(data, time=time, bearing=bearing, decimal_mark=decimal_mark)
    return published_trend(known_example(example, EXAMPLES).replace("-", "_"))


def _fits(record: Trend, law: str | None) -> dict[str, WearFit]:
    """Fit the law that was asked for, or running-in to what is a length; else none."""
    from rolamento.weibull.trend import wear_of_each

    if law is not None and law not in LAWS:
        raise InputError(
            f"must be one of {', '.join(LAWS)}", source="--law", value=law, example="running-in"
        )
    try:
        return wear_of_each(record, LAWS[law or "running-in"])
    except InputError as error:
        if law is None:  # noise, say, or too few measurements
            return {}
        raise error.with_details(source="--law") from None
