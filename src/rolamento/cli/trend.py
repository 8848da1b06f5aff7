"""`rolamento trend`: what grew while bearings ran: clearance with a law of wear, noise."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, Final, cast

import typer

from rolamento.cli.common import SOLVED, plain_endings
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import LanguageOption, PlotOption, json_option
from rolamento.cli.outputs import NOWHERE, Outputs, with_outputs
from rolamento.cli.shipped_data import check_one_given, data_and_json, known_example
from rolamento.cli.streams import put_json
from rolamento.cli.table_options import (
    BearingColumnOption,
    DateOrderOption,
    DecimalMarkOption,
    TimeColumnOption,
    ValueColumnOption,
    told_in_options,
)
from rolamento.errors import InputError
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.clearance import WearLaw
    from rolamento.numerics.growth import Law

__all__ = ["app", "trend"]

EXAMPLES: Final = ("campanha-2008-clearance", "campanha-2008-anderon")
LAWS: Final[dict[str, WearLaw]] = {
    "running-in": "running_in",
    "running-in-and-steady": "running_in_and_steady",
    "power": "power",
}


_GROWTH: Final = ("linear", "exponential")

app = typer.Typer()


@app.command(
    cls=JsonCommand,
    epilog="Example: trend --example campanha-2008-clearance --plot clearance.png.",
)
@with_outputs
def trend(
    data: Annotated[
        str | None,
        typer.Argument(
            metavar="DATA.csv",
            help="Columns of time or date, bearing and quantities, units in brackets; - for "
            "standard input.",
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
    limit: Annotated[
        list[str] | None,
        typer.Option(
            "--limit",
            metavar="[COLUMN=]VALUE",
            help="Limit of a quantity, such as '4.5 mm/s': when it is reached. Repeatable.",
        ),
    ] = None,
    growth: Annotated[
        str | None,
        typer.Option(
            "--growth",
            metavar="LAW",
            help="Law of growth: linear or exponential; by default the likelier one.",
        ),
    ] = None,
    confidence: Annotated[
        float,
        typer.Option(
            "--confidence", metavar="C", help="Confidence of the time to the limit, such as 0.9."
        ),
    ] = 0.9,
    time_column: TimeColumnOption = None,
    bearing_column: BearingColumnOption = None,
    value_column: ValueColumnOption = None,
    decimal_mark: DecimalMarkOption = None,
    date_order: DateOrderOption = None,
    plot: PlotOption = None,
    json: Annotated[str | None, json_option("Write everything as JSON")] = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show what changed in operation, and when it reaches a limit.

    Clearance, with a wear law; noise, vibration and other quantities.
    """
    with plain_endings(lang):
        data, json = data_and_json(data, example, json)
        outputs.check(
            {"--json": json, "--plot": plot},
            data,
            rule=marked("is the data file itself; choose another name"),
        )
        check_one_given(data, example, "trend", EXAMPLES)
        if law is not None and law not in LAWS:
            rule = said("must be one of {known}", known=", ".join(LAWS))
            raise InputError(rule, source="--law", value=law, example="running-in")
        columns: dict[str, Any] = {
            "time": time_column, "bearing": bearing_column, "values": value_column or (),
            "decimal_mark": decimal_mark, "date_order": date_order,
        }  # fmt: skip
        from rolamento.pages.trend import trend_page
        from rolamento.tasks.weibull import trend_study
        from rolamento.weibull import published_trend

        with told_in_options(limits="--limit", confidence="--confidence"):
            given: Any = data
            if example is not None:
                given = published_trend(known_example(example, EXAMPLES).replace("-", "_"))
            found = trend_study(
                given,
                law=None if law is None else LAWS[law],
                limits=limit or (),
                growth=_checked_growth(growth),
                confidence=confidence,
                columns=columns,
            )
        if plot is not None:
            from rolamento.pages.trend import trend_picture
            from rolamento.plots.saving import save_figure

            save_figure(trend_picture(found), plot)
        if json is not None:
            put_json(found.to_mapping(), json)
        outputs.show(lambda: trend_page(found), json)
    raise typer.Exit(SOLVED)


def _checked_growth(name: str | None) -> Law | None:
    if name is not None and name not in _GROWTH:
        rule = said("must be one of {known}", known=", ".join(_GROWTH))
        raise InputError(rule, source="--growth", value=name, example="--growth linear")
    return cast("Law | None", name)
