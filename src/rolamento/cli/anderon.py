"""`rolamento anderon`: noise of a bearing in the bands of an anderometer, and whether it passes."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated, ClassVar, Final

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    plain_endings,
    words_of,
)
from rolamento.cli.grouped_help import GroupedCommand, Groups
from rolamento.cli.options import (
    ChannelOption,
    DurationOption,
    JsonOption,
    LanguageOption,
    RateOption,
    ScaleOption,
    StartOption,
    csv_option,
    plot_option,
)
from rolamento.cli.outputs import check_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text, put
from rolamento.cli.table_options import DecimalMarkOption
from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.cli.signal_source import SignalChoice
    from rolamento.report.anderon_result import NoiseResult
    from rolamento.report.language import Words

__all__ = ["AnderonCommand", "anderon"]

_ACCEPTED: Final = 0.4
_MOST_SIGNALS: Final = 500
_LONGEST_NAME: Final = 60


class AnderonCommand(GroupedCommand):
    """`rolamento anderon`, its help in groups."""

    groups: ClassVar[Groups] = {
        "Signal": ("channel", "rate", "unit", "scale", "start", "duration", "decimal_mark"),
        "Bearing": ("speed", "bearing", "hours"),
        "Acceptance": ("full_scale", "accepted"),
        "Output": ("plot", "record", "json", "csv", "lang", "help"),
    }


def anderon(
    signals: Annotated[
        list[str],
        typer.Argument(
            metavar="SIGNAL",
            help="Files of signals: WAV, CSV, NPY, MATLAB and others. Several are of one bearing.",
        ),
    ],
    speed: Annotated[
        str | None,
        typer.Option(
            "--speed",
            metavar="SPEED",
            help="Of the inner ring; by default as the file tells it, or else 1800 rpm.",
        ),
    ] = None,
    full_scale: Annotated[
        list[str] | None,
        typer.Option(
            "--full-scale",
            metavar="BAND=VALUE",
            help="Of a band, low, medium or high, in anderons or as a velocity such as '120 um/s'."
            " Repeats.",
        ),
    ] = None,
    accepted: Annotated[
        float,
        typer.Option(
            "--accepted", metavar="PART", help="Of the full scale that is accepted, up to 1."
        ),
    ] = _ACCEPTED,
    unit: Annotated[
        str | None,
        typer.Option(
            "--unit",
            metavar="UNIT",
            help="Of the samples: um/s, m/s^2, g …, if the file is silent.",
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
            help="Of the test after which each signal was recorded, such as 60,120,180.",
        ),
    ] = None,
    bearing: Annotated[
        str, typer.Option("--bearing", metavar="NAME", help="What the record calls the bearing.")
    ] = "1",
    record: Annotated[
        str | None,
        typer.Option(
            "--record",
            metavar="FILE",
            help="Write the levels over the hours as rolamento trend reads them.",
        ),
    ] = None,
    plot: Annotated[str | None, plot_option("Draw noise over frequency, or over the hours")] = None,
    json: JsonOption = None,
    csv: Annotated[str | None, csv_option("Write the table of bands")] = None,
    lang: LanguageOption = None,
) -> None:
    """Show the noise in anderons and µm/s, and if it passes.

    Of a bearing, in the bands of an anderometer; over the hours of a test if there are several.
    """
    with plain_endings(lang):
        outputs = {"--json": json, "--csv": csv, "--record": record, "--plot": plot}
        _check(signals, outputs, hours, bearing)
        from rolamento.cli.signal_source import choice_of

        words = words_of(lang)
        choice = choice_of(channel, rate, unit, scale, start, duration, decimal_mark)
        found = _found(signals, choice, speed, hours, full_scale or [], accepted, bearing, words)
        if plot is not None:
            _draw(found, plot, words.code)
        _show(found, json, csv, record, words)
    failed = found.measures_nothing or "rejected" in found.verdicts
    raise typer.Exit(NO_RESULT if failed else SOLVED)


def _check(
    signals: list[str], outputs: dict[str, str | None], hours: str | None, bearing: str
) -> None:
    """Refuse outputs that would run into each other or over a signal, and lists without end."""
    if len(signals) > _MOST_SIGNALS:
        raise InputError(f"at most {_MOST_SIGNALS} at once", field="SIGNAL", value=len(signals))
    check_outputs(outputs, *signals, rule="is the file of a signal itself")
    if not bearing.strip() or len(bearing) > _LONGEST_NAME or not bearing.isprintable():
        rule = f"must be one line of {_LONGEST_NAME} characters at most"
        raise InputError(rule, source="--bearing", value=bearing, example="--bearing 9")
    for option in ("--record", "--plot"):
        several = option == "--record" or len(signals) > 1
        if outputs[option] is not None and several and hours is None:
            raise InputError(
                "needs the hours of each signal", source=option, example="--hours 60,120,180"
            )


def _found(
    signals: list[str],
    choice: SignalChoice,
    speed: str | None,
    hours: str | None,
    full_scale: list[str],
    accepted: float,
    bearing: str,
    words: Words,
) -> NoiseResult:
    """Measure every signal, after all that the options say was understood."""
    from rolamento.cli.anderon_files import full_scales_of, hours_of, measured_noise
    from rolamento.cli.quantities import speed_given
    from rolamento.cli.waiting import progress_of
    from rolamento.report.anderon_result import NoiseResult
    from rolamento.report.anderon_words import NOISE_WORDS

    if not 0.0 < accepted <= 1.0:
        rule = "must be a part over 0 and up to 1"
        raise InputError(rule, source="--accepted", value=accepted, example="--accepted 0.4")
    scales = full_scales_of(full_scale)
    times = hours_of(hours, len(signals))
    inner_speed = speed_given(speed, "--speed")
    if inner_speed == 0.0:
        rule = "must not be 0: a bearing that stands still makes no noise"
        raise InputError(rule, source="--speed", example="--speed '1800 rpm'")
    with progress_of(NOISE_WORDS[words.code].reading) as progress:
        measured = tuple(
            measured_noise(path, choice, hour, progress, inner_speed)
            for path, hour in zip(signals, times, strict=True)
        )
    found = NoiseResult(measured, scales, accepted, bearing)
    _check_speeds(found)
    return found


def _check_speeds(found: NoiseResult) -> None:
    """Refuse a trend against velocities where the speeds differ: limits in anderons would too."""
    speeds = [one.noise.speed for one in found.measured]
    in_velocity = any(scale.is_velocity for scale in found.full_scales.values())
    if found.trend is not None and in_velocity and max(speeds) > 1.001 * min(speeds):
        raise InputError(
            "must be in anderons, as the speeds of the signals differ",
            source="--full-scale",
            example="--full-scale low=30",
        )


def _draw(found: NoiseResult, plot: str, language: str) -> None:
    from rolamento.plots.anderon import noise_figure, noise_trend_figure
    from rolamento.plots.saving import save_figure

    one = found.measured[0]
    limits = found.limits_of(one)
    if len(found.measured) == 1:
        figure = noise_figure(one.noise, limits=limits, title=one.title, language=language)
    else:
        from rolamento.report.anderon_result import noise_record
        from rolamento.weibull import parse_trend

        record = parse_trend(noise_record(found, language))
        figure = noise_trend_figure(record, limits=limits, language=language)
    save_figure(figure, plot)


def _show(
    found: NoiseResult, json: str | None, csv: str | None, record: str | None, words: Words
) -> None:
    """Write what was asked for; standard output takes data or the report, not both."""
    from rolamento.report.anderon_result import noise_csv, noise_json, noise_record

    if json is not None:
        put(noise_json(found) + "\n", json)
    if csv is not None:
        put(noise_csv(found), csv)
    if record is not None:
        put(noise_record(found, words.code), record)
    if STANDARD_STREAM not in (json, csv, record):
        from rolamento.report.anderon import noise_report
        from rolamento.report.medium import Medium

        print_text(noise_report(found, words, Medium.of(sys.stdout)))
    elif "rejected" in found.verdicts:
        from rolamento.report.anderon import noise_statement

        complain(noise_statement(found, words))
