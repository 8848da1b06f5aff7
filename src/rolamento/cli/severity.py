"""`rolamento severity`: broadband velocity of a machine, its zone, its alarm, and its trend."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, ClassVar, Final, cast

import typer

from rolamento.cli.anderon import hours_of
from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings
from rolamento.cli.grouped_help import Groups
from rolamento.cli.option_names import in_options
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import (
    ChannelOption,
    DurationOption,
    JsonOption,
    LanguageOption,
    RateOption,
    ScaleOption,
    StartOption,
    plot_option,
)
from rolamento.cli.outputs import NOWHERE, OUTPUT_OPTIONS, Outputs, with_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, put, put_json
from rolamento.cli.table_options import DecimalMarkOption
from rolamento.errors import InputError
from rolamento.tasks.inputs import SIGNAL, by_name
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.numerics.growth import Law
    from rolamento.tasks.severity import SeverityResult

__all__ = ["GrowthLawOption", "SeverityCommand", "app", "checked_growth", "severity"]

_ASKED: Final = by_name(SIGNAL)
_LAWS = ("linear", "exponential")


class SeverityCommand(JsonCommand):
    """`rolamento severity`, its help in groups."""

    groups: ClassVar[Groups] = {
        "Machine": ("speed", "power", "support", "group", "machine_class"),
        "Signal": ("channel", "rate", "unit", "scale", "start", "duration", "decimal_mark"),
        "Alarm and trend": ("baseline", "hours", "dates", "limit", "growth", "confidence"),
        "Output": ("plot", "record", "json", *OUTPUT_OPTIONS, "lang", "help"),
    }


GrowthLawOption = Annotated[
    str | None,
    typer.Option(
        "--growth",
        metavar="LAW",
        help="Law of growth: linear or exponential; by default the likelier one.",
    ),
]


app = typer.Typer()


@app.command(
    cls=SeverityCommand,
    epilog="Examples: severity motor.csv --unit g --speed '1480 rpm' --power '45 kW' --support"
    " rigid; severity jan.wav feb.wav mar.wav --unit mm/s --hours 0,700,1400 --plot trend.png.",
)
@with_outputs
def severity(
    signals: Annotated[
        list[str],
        typer.Argument(
            metavar="SIGNAL",
            help="Signal files: WAV, CSV, NPY, MATLAB and others. Several are of one machine.",
        ),
    ],
    speed: Annotated[
        str | None,
        typer.Option(
            "--speed",
            metavar="SPEED",
            help="Speed of the shaft, such as '1480 rpm'; below 600 rpm the band begins at 2 Hz.",
        ),
    ] = None,
    power: Annotated[
        str | None,
        typer.Option(
            "--power",
            metavar="POWER",
            help=_ASKED["power"].meaning,
        ),
    ] = None,
    support: Annotated[
        str | None,
        typer.Option("--support", metavar="SUPPORT", help=_ASKED["support"].meaning),
    ] = None,
    group: Annotated[
        int | None,
        typer.Option("--group", metavar="N", help=_ASKED["group"].meaning),
    ] = None,
    machine_class: Annotated[
        str | None,
        typer.Option("--class", metavar="CLASS", help=_ASKED["machine_class"].meaning),
    ] = None,
    unit: Annotated[
        str | None,
        typer.Option(
            "--unit",
            metavar="UNIT",
            help="Unit of the samples: mm/s, m/s^2, g …, if the file gives none.",
        ),
    ] = None,
    scale: ScaleOption = None,
    channel: ChannelOption = None,
    rate: RateOption = None,
    start: StartOption = None,
    duration: DurationOption = None,
    decimal_mark: DecimalMarkOption = None,
    baseline: Annotated[
        str | None,
        typer.Option(
            "--baseline",
            metavar="VELOCITY",
            help=_ASKED["baseline"].meaning,
        ),
    ] = None,
    hours: Annotated[
        str | None,
        typer.Option(
            "--hours",
            metavar="H,H,…",
            help="Running hours at which the signals were recorded, such as 0,500,1000.",
        ),
    ] = None,
    dates: Annotated[
        str | None,
        typer.Option(
            "--dates",
            metavar="DATE,DATE,…",
            help="Dates of the signals instead, such as 2026-01-31,2026-02-28.",
        ),
    ] = None,
    limit: Annotated[
        str | None,
        typer.Option(
            "--limit",
            metavar="VELOCITY",
            help="Limit of the trend, such as '4.5 mm/s'; by default the alarm.",
        ),
    ] = None,
    growth: GrowthLawOption = None,
    confidence: Annotated[
        float,
        typer.Option(
            "--confidence", metavar="C", help="Confidence of the time to the limit, such as 0.9."
        ),
    ] = 0.9,
    record: Annotated[
        str | None,
        typer.Option(
            "--record",
            metavar="FILE",
            help="Write the velocities over the hours, as rolamento trend reads them.",
        ),
    ] = None,
    plot: Annotated[
        str | None, plot_option("Draw the velocity on the zones, or over the hours")
    ] = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show the vibration severity in mm/s and its zone.

    Broadband RMS velocity and zones A to D of ISO 20816-3; for several signals, over time.
    """
    with plain_endings(lang), in_options(severity, signals="SIGNAL", law="--growth"):
        files = {"--json": json, "--record": record, "--plot": plot}
        outputs.check(
            files, *signals, rule=marked("is one of the signal files; choose another name")
        )
        for option, value in (("--record", record), ("--limit", limit), ("--growth", growth)):
            if value is not None and hours is None and dates is None:
                raise InputError(
                    said("needs the hours or dates of each signal"),
                    source=option,
                    example="--hours 0,500",
                )
        from rolamento import tasks
        from rolamento.cli.waiting import progress_of
        from rolamento.tasks.quantities import number_given

        with progress_of(said("blocks of the signal")) as progress:
            found = tasks.vibration_severity(
                signals,
                speed=speed,
                power=power,
                support=support,
                group=group,
                machine_class=machine_class,
                baseline=baseline,
                limit=limit,
                law=checked_growth(growth),
                confidence=confidence,
                hours=None if hours is None else hours_of(hours),
                dates=None if dates is None else dates.split(","),
                channel=channel,
                rate=number_given(rate, "--rate", "frequency", "--rate '50 kHz'"),
                unit=unit,
                scale=scale,
                start=number_given(start, "--start", "time", "--start '2 s'") or 0.0,
                duration=number_given(duration, "--duration", "time", "--duration '10 s'"),
                decimal_mark=decimal_mark,
                progress=progress,
            )
        if plot is not None:
            _draw(found, plot)
        _show(found, json, outputs, record)
    raise typer.Exit(NO_RESULT if found.worst is None else SOLVED)


def checked_growth(name: str | None) -> Law | None:
    """Return a law of growth by its name.

    Raises
    ------
    InputError
        If it is none.
    """
    if name is not None and name not in _LAWS:
        rule = said("must be one of {known}", known=", ".join(_LAWS))
        raise InputError(rule, source="--growth", value=name, example="--growth linear")
    return cast("Law | None", name)


def _draw(found: SeverityResult, plot: str) -> None:
    from rolamento.pages.severity import trend_picture, zones_picture
    from rolamento.plots.saving import save_figure

    draw = zones_picture if found.forecast is None else trend_picture
    save_figure(draw(found), plot)


def _show(found: SeverityResult, json: str | None, outputs: Outputs, record: str | None) -> None:
    """Write what was asked for; standard output takes data or the page, not both."""
    from rolamento.pages.severity import severity_page, severity_statement

    if json is not None:
        put_json(found.to_mapping(), json)
    if record is not None:
        put(found.record(), record)
    outputs.show(lambda: severity_page(found), json, record)
    if STANDARD_STREAM in (json, outputs.csv, record) and found.worst is None:
        complain(severity_statement(found))
