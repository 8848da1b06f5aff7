"""`rolamento anderon`: noise of a bearing in the bands of an anderometer, and whether it passes."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite, nan
from typing import TYPE_CHECKING, Annotated, ClassVar, Final

import typer

from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings
from rolamento.cli.grouped_help import Groups
from rolamento.cli.option_names import in_options
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import (
    JsonOption,
    LanguageOption,
    plot_option,
)
from rolamento.cli.outputs import NOWHERE, OUTPUT_OPTIONS, Outputs, with_outputs
from rolamento.cli.signal_options import (
    ChannelOption,
    DurationOption,
    RateOption,
    ScaleOption,
    StartOption,
)
from rolamento.cli.streams import STANDARD_STREAM, complain, put, put_json
from rolamento.cli.table_options import DecimalMarkOption
from rolamento.errors import InputError
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.tasks.noise import FullScale, NoiseResult
    from rolamento.vibration.anderon import BandName

_ACCEPTED: Final = 0.4
_MOST_SCALE: Final = 1e9
_SCALE_EXAMPLE: Final = "--full-scale low=30 or --full-scale low='120 um/s'"


class AnderonCommand(JsonCommand):
    """`rolamento anderon`, its help in groups."""

    groups: ClassVar[Groups] = {
        "Signal": ("channel", "rate", "unit", "scale", "start", "duration", "decimal_mark"),
        "Bearing": ("speed", "bearing", "hours"),
        "Acceptance": ("full_scale", "accepted"),
        "Output": ("plot", "record", "json", *OUTPUT_OPTIONS, "lang", "help"),
    }


app = typer.Typer()


@app.command(
    cls=AnderonCommand,
    epilog="Examples: anderon noise.wav --unit um/s --full-scale low=30,medium=60,high=60;"
    " anderon t060.csv t120.csv --hours 60,120 --plot trend.png.",
)
@with_outputs
def anderon(
    signals: Annotated[
        list[str],
        typer.Argument(
            metavar="SIGNAL",
            help="Signal files: WAV, CSV, NPY, MATLAB and others. Several are of one bearing.",
        ),
    ],
    speed: Annotated[
        str | None,
        typer.Option(
            "--speed",
            metavar="SPEED",
            help="Speed of the inner ring; by default that of the file, or else 1800 rpm.",
        ),
    ] = None,
    full_scale: Annotated[
        list[str] | None,
        typer.Option(
            "--full-scale",
            metavar="BAND=VALUE",
            help="Full scale of a band, low, medium or high, in anderons or as a "
            "velocity such as '120 um/s'. Repeatable.",
        ),
    ] = None,
    accepted: Annotated[
        float,
        typer.Option(
            "--accepted", metavar="FRACTION", help="Accepted fraction of the full scale, up to 1."
        ),
    ] = _ACCEPTED,
    unit: Annotated[
        str | None,
        typer.Option(
            "--unit",
            metavar="UNIT",
            help="Unit of the samples: um/s, m/s^2, g …, if the file gives none.",
        ),
    ] = None,
    scale: ScaleOption = None,
    channel: ChannelOption = None,
    rate: RateOption = None,
    start: StartOption = None,
    duration: DurationOption = None,
    decimal_mark: DecimalMarkOption = None,
    hours: Annotated[
        str | None,
        typer.Option(
            "--hours",
            metavar="H,H,…",
            help="Hours of the test at which the signals were recorded, such as 60,120,180.",
        ),
    ] = None,
    bearing: Annotated[
        str, typer.Option("--bearing", metavar="NAME", help="Name of the bearing in the record.")
    ] = "1",
    record: Annotated[
        str | None,
        typer.Option(
            "--record",
            metavar="FILE",
            help="Write the levels over the hours, as rolamento trend reads them.",
        ),
    ] = None,
    plot: Annotated[str | None, plot_option("Draw noise over frequency, or over the hours")] = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Show the noise in anderons and µm/s, and whether it passes.

    In the bands of an anderometer; for several signals, over the hours of a test.
    """
    with plain_endings(lang), in_options(anderon, signals="SIGNAL"):
        files = {"--json": json, "--record": record, "--plot": plot}
        _check_outputs(signals, outputs, files, hours)
        from rolamento import tasks
        from rolamento.cli.waiting import progress_of
        from rolamento.tasks.quantities import number_given

        with progress_of(said("blocks of the signal")) as progress:
            found = tasks.noise_level(
                signals,
                speed=speed,
                full_scale=_full_scales_of(full_scale or []),
                accepted=accepted,
                hours=None if hours is None else hours_of(hours),
                bearing=bearing,
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
    failed = found.measures_nothing or "rejected" in found.verdicts
    raise typer.Exit(NO_RESULT if failed else SOLVED)


def _check_outputs(
    signals: list[str], outputs: Outputs, files: dict[str, str | None], hours: str | None
) -> None:
    """Refuse outputs that would run into each other or over a signal, or lack the hours."""
    outputs.check(files, *signals, rule=marked("is one of the signal files; choose another name"))
    for option in ("--record", "--plot"):
        several = option == "--record" or len(signals) > 1
        if files[option] is not None and several and hours is None:
            raise InputError(
                said("needs the hours of each signal"), source=option, example="--hours 60,120,180"
            )


def _full_scales_of(given: Sequence[str]) -> dict[BandName, FullScale]:
    """Return the full scales that ``--full-scale BAND=VALUE`` gives, several with commas.

    Raises
    ------
    InputError
        If one is none, or given twice.
    """
    from rolamento.vibration.anderon import BANDS

    found: dict[BandName, FullScale] = {}
    for setting in (part for text in given for part in text.split(",")):
        key, equals, text = setting.partition("=")
        name = next((band for band in BANDS if band == key.strip().casefold()), None)
        if name is None or not equals:
            raise InputError(
                said("must be BAND=VALUE; BAND is one of {bands}", bands=", ".join(BANDS)),
                source="--full-scale",
                value=setting,
                example=_SCALE_EXAMPLE,
            )
        if name in found:
            raise InputError(said("is given twice"), source="--full-scale", field=name)
        found[name] = _full_scale(text.strip(), name)
    return found


def _full_scale(text: str, name: BandName) -> FullScale:
    """Read a number of anderons, or a velocity with its unit."""
    from rolamento.tasks.noise import FullScale
    from rolamento.vibration.signal import unit_scale

    number, _, unit = text.partition(" ")
    unit = unit.strip().replace("µ", "u").replace("μ", "u")
    scale = 1.0
    try:
        is_velocity = unit not in ("", "An", "anderon", "anderons")
        if is_velocity:
            scale = unit_scale("velocity", unit)
        value = float(number) * scale
    except ValueError:  # an InputError of the unit is one too
        value = nan
    if not (isfinite(value) and 0.0 < value / scale <= _MOST_SCALE):
        raise InputError(
            said("must be a positive number of anderons, or a velocity in um/s, mm/s, m/s or in/s"),
            source="--full-scale",
            field=name,
            value=text,
            example=_SCALE_EXAMPLE,
        )
    return FullScale(value, is_velocity)


def hours_of(text: str) -> list[float]:
    """Return hours with commas between; NaN for what is no number."""
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        return [nan]


def _draw(found: NoiseResult, plot: str) -> None:
    from rolamento.plots.anderon import noise_figure, noise_trend_figure
    from rolamento.plots.saving import save_figure

    one = found.measured[0]
    limits = found.limits_of(one)
    if len(found.measured) == 1:
        figure = noise_figure(one.noise, limits=limits, title=one.title)
    else:
        from rolamento.weibull import parse_trend

        figure = noise_trend_figure(parse_trend(found.record()), limits=limits)
    save_figure(figure, plot)


def _show(found: NoiseResult, json: str | None, outputs: Outputs, record: str | None) -> None:
    """Write what was asked for; standard output takes data or the page, not both."""
    from rolamento.pages.anderon import anderon_page, noise_statement

    if json is not None:
        put_json(found.to_mapping(), json)
    if record is not None:
        put(found.record(), record)
    outputs.show(lambda: anderon_page(found), json, record)
    if STANDARD_STREAM in (json, outputs.csv, record) and "rejected" in found.verdicts:
        complain(noise_statement(found))
