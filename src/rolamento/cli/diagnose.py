"""`rolamento diagnose`: which parts of a bearing a vibration signal shows to be damaged."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final

import typer

from rolamento.cli.case_options import CASE_OPTIONS, NOTHING_GIVEN, CaseOptions, with_case
from rolamento.cli.common import NO_RESULT, SOLVED, plain_endings
from rolamento.cli.grouped_help import Groups
from rolamento.cli.option_names import in_options
from rolamento.cli.optional_value import JsonCommand
from rolamento.cli.options import (
    ChannelOption,
    DurationOption,
    JsonOption,
    LanguageOption,
    OuterSpeedOption,
    RateOption,
    ScaleOption,
    StartOption,
    plot_option,
)
from rolamento.cli.outputs import NOWHERE, OUTPUT_OPTIONS, Outputs, with_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text, put_json
from rolamento.cli.table_options import DecimalMarkOption
from rolamento.tasks.inputs import SIGNAL, by_name
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.tasks.diagnosis import DiagnosisResult

_ASKED: Final = by_name(SIGNAL)
_FALSE_ALARM: Final = 0.01
_NO_VERDICT: Final = ("no_verdict", "undecided")
_SLIP: Final = 0.02
_SPEED_TOLERANCE: Final = "3 %"
_TOLERANCE_EXAMPLE: Final = 'speed_tolerance="3 %"'


class DiagnoseCommand(JsonCommand):
    """`rolamento diagnose`, its help in groups."""

    groups: ClassVar[Groups] = {
        "Bearing": ("bearing", "machine", "baseline", *CASE_OPTIONS, "nominal", "angle"),
        "Speed": (
            *("speed", "outer_speed", "speed_channel", "speed_unit"),
            *("tacho", "pulses", "track", "within"),
        ),
        "Signal": ("channel", "rate", "unit", "scale", "start", "duration", "decimal_mark"),
        "Search": ("slip", "speed_tolerance", "false_alarm"),
        "Output": ("plot", "kurtogram", "json", *OUTPUT_OPTIONS, "lang", "help"),
    }


app = typer.Typer()


@app.command(
    cls=DiagnoseCommand,
    epilog="Examples: diagnose signal.wav --bearing 6205 --speed '1797 rpm' --plot signal.png; "
    "diagnose run.npz --bearing case.toml --speed-channel rpm.",
)
@with_outputs
@with_case
def diagnose(
    signal: Annotated[
        str,
        typer.Argument(
            metavar="SIGNAL",
            help="Signal file: WAV, CSV, NumPy, MATLAB, HDF5, Parquet or UFF 58; or a folder of "
            "many, followed by their names.",
        ),
    ],
    bearing: Annotated[
        str,
        typer.Option(
            "--bearing",
            metavar="BEARING",
            help="Designation such as 6205, or a case file; for a case with a load, "
            "the frequencies of the loaded bearing are searched. 'unknown' ranks the bearings of "
            "the catalogue.",
        ),
    ] = "",
    machine: Annotated[
        str | None,
        typer.Option(
            "--machine",
            metavar="FILE",
            help="File of a machine with several bearings, shafts and gears, instead of "
            "--bearing: all are tested together.",
        ),
    ] = None,
    baseline: Annotated[
        list[str] | None,
        typer.Option(
            "--baseline",
            metavar="PATH",
            help="Record of the machine in good order, or a folder of them; may be repeated. "
            "Damage is what has doubled since.",
        ),
    ] = None,
    given: CaseOptions = NOTHING_GIVEN,
    nominal: Annotated[
        bool,
        typer.Option("--nominal", help=_ASKED["nominal"].meaning),
    ] = False,
    angle: Annotated[
        str | None,
        typer.Option(
            "--angle",
            metavar="ANGLE",
            help=_ASKED["angle"].meaning,
        ),
    ] = None,
    speed: Annotated[
        str | None,
        typer.Option(
            "--speed",
            metavar="SPEED",
            help=_ASKED["speed"].meaning,
        ),
    ] = None,
    outer_speed: OuterSpeedOption = None,
    speed_channel: Annotated[
        str | None,
        typer.Option(
            "--speed-channel",
            metavar="CHANNEL",
            help=_ASKED["speed_channel"].meaning,
        ),
    ] = None,
    speed_unit: Annotated[
        str | None,
        typer.Option(
            "--speed-unit",
            metavar="UNIT",
            help=_ASKED["speed_unit"].meaning,
        ),
    ] = None,
    tacho: Annotated[
        str | None,
        typer.Option(
            "--tacho",
            metavar="CHANNEL",
            help=_ASKED["tacho"].meaning,
        ),
    ] = None,
    pulses: Annotated[
        int | None,
        typer.Option("--pulses", metavar="N", help=_ASKED["pulses"].meaning),
    ] = None,
    track: Annotated[
        bool,
        typer.Option(
            "--track",
            help="Track the speed in the vibration itself, around --speed; at least "
            "96 revolutions.",
        ),
    ] = False,
    within: Annotated[
        float | None,
        typer.Option(
            "--within",
            metavar="FRACTION",
            help="Maximum deviation of the speed from --speed, for --track: a "
            "fraction up to 0.3 (default 0.1).",
        ),
    ] = None,
    channel: ChannelOption = None,
    rate: RateOption = None,
    unit: Annotated[
        str | None,
        typer.Option(
            "--unit",
            metavar="UNIT",
            help=_ASKED["unit"].meaning,
        ),
    ] = None,
    scale: ScaleOption = None,
    start: StartOption = None,
    duration: DurationOption = None,
    decimal_mark: DecimalMarkOption = None,
    slip: Annotated[
        float,
        typer.Option(
            "--slip",
            metavar="FRACTION",
            help=_ASKED["tolerance"].meaning,
        ),
    ] = _SLIP,
    speed_tolerance: Annotated[
        str,
        typer.Option(
            "--speed-tolerance",
            metavar="FRACTION",
            help=_ASKED["speed_tolerance"].meaning,
        ),
    ] = _SPEED_TOLERANCE,
    false_alarm: Annotated[
        float,
        typer.Option(
            "--false-alarm",
            metavar="P",
            help=_ASKED["false_alarm"].meaning,
        ),
    ] = _FALSE_ALARM,
    plot: Annotated[
        str | None, plot_option("Draw waveform, kurtogram and envelope spectrum")
    ] = None,
    kurtogram: Annotated[
        str | None,
        typer.Option("--kurtogram", metavar="FILE", help="Draw the kurtogram alone, likewise."),
    ] = None,
    json: JsonOption = None,
    outputs: Outputs = NOWHERE,
    lang: LanguageOption = None,
) -> None:
    """Diagnose damaged parts of a bearing from a vibration signal.

    How severe, why, and what speaks against it. A long signal is read block by block, in
    bounded memory.
    """
    with plain_endings(lang), given.in_force(), in_options(diagnose, tolerance="--slip"):
        outputs.check(
            {"--json": json, "--plot": plot, "--kurtogram": kurtogram},
            signal,
            bearing or machine or "",
            rule=marked("is one of the input files; choose another name"),
        )
        from rolamento import tasks
        from rolamento.cli.waiting import progress_of
        from rolamento.tasks.quantities import number_given, part_of_one
        from rolamento.vibration.diagnosis import DiagnosisSettings

        reading: dict[str, Any] = {
            "channel": channel,
            "rate": number_given(rate, "--rate", "frequency", "--rate '50 kHz'"),
            "unit": unit,
            "scale": scale,
            "decimal_mark": decimal_mark,
        }
        part: dict[str, Any] = {
            "start": number_given(start, "--start", "time", "--start '2 s'") or 0.0,
            "duration": number_given(duration, "--duration", "time", "--duration '10 s'"),
        }
        search = DiagnosisSettings(
            false_alarm=false_alarm,
            tolerance=slip,
            speed_tolerance=part_of_one(speed_tolerance, "speed_tolerance", _TOLERANCE_EXAMPLE),
        )
        asked: dict[str, Any] = {
            "speed": speed,
            "outer_speed": outer_speed,
            "speed_channel": speed_channel,
            "speed_unit": speed_unit,
            "tacho": tacho,
            "pulses": pulses,
            "track": track,
            "within": within,
            "nominal": nominal,
            "angle": angle,
            "search": search,
            "changes": given.settings,
            **part,
            **reading,
        }
        _check_together(signal, bearing, machine, baseline)
        found: Any
        with progress_of(said("blocks of the signal")) as progress:
            asked["progress"] = progress
            if machine is not None:
                found = tasks.diagnose_machine(signal, machine, **asked)
            elif bearing == _UNKNOWN:
                found = tasks.rank_bearings(signal, speed=speed, search=search, **part, **reading)
            elif os.path.isdir(signal):
                found = tasks.trend_of_records([signal], bearing, **asked)
            elif baseline:
                found = tasks.diagnose_since(signal, bearing, baseline, **asked)
            else:
                found = tasks.diagnose(signal, bearing, **asked)
        if isinstance(found, tasks.History) and found.now.too_short is not None:
            found = found.now
        if not isinstance(found, tasks.DiagnosisResult):
            _refuse_pictures(plot, kurtogram)
            _show_more(found, signal, json, outputs)
            verdict = getattr(found, "verdict", "nothing_found")
            raise typer.Exit(NO_RESULT if verdict in _NO_VERDICT else SOLVED)
        if found.too_short is not None:
            _show_too_short(found, json)
            raise typer.Exit(NO_RESULT)
        _draw(found, plot, kurtogram)
        _show(found, json, outputs)
    raise typer.Exit(NO_RESULT if found.verdict in _NO_VERDICT else SOLVED)


_UNKNOWN: Final = "unknown"


def _check_together(
    signal: str, bearing: str, machine: str | None, baseline: list[str] | None
) -> None:
    """Refuse what does not go together: a machine, a bearing, a folder and a history.

    Raises
    ------
    InputError
        With an example of what does.
    """
    from rolamento.errors import InputError

    if not bearing and machine is None:
        raise InputError(said("must be given"), field="--bearing", example="--bearing 6205")
    if bearing and machine is not None:
        rule = said("names the bearings: leave --bearing out")
        raise InputError(rule, field="--machine", example="--machine machine.toml")
    alone = machine is not None or bearing == _UNKNOWN or os.path.isdir(signal)
    if baseline and alone:
        rule = said("goes with one record and one bearing")
        raise InputError(rule, field="--baseline", example="now.wav --bearing 6205")
    if os.path.isdir(signal) and (machine is not None or bearing == _UNKNOWN):
        rule = said("must be one record here")
        raise InputError(rule, field="signal", value=signal, example="now.wav")


def _refuse_pictures(plot: str | None, kurtogram: str | None) -> None:
    from rolamento.errors import InputError

    for option, given in (("--plot", plot), ("--kurtogram", kurtogram)):
        if given is not None:
            rule = said("goes with one record; --report draws the others")
            raise InputError(rule, field=option, example="--report page.pdf")


def _show_more(found: Any, signal: str, json: str | None, outputs: Outputs) -> None:
    """Write a history, many records, a machine, or the bearings that a record may be of."""
    from rolamento import tasks
    from rolamento.pages import history as pages

    if json is not None:
        put_json(found.to_mapping(), json)
    if isinstance(found, tasks.History):
        outputs.show(lambda: pages.history_page(found), json)
    elif isinstance(found, tasks.Records):
        outputs.show(lambda: pages.records_page(found, signal), json)
    elif isinstance(found, tasks.MachineDiagnosis):
        outputs.show(lambda: pages.machine_page(found), json)
    else:
        outputs.show(lambda: pages.unknown_page(found), json)


def _show_too_short(found: DiagnosisResult, json: str | None) -> None:
    """Write JSON where it was asked for, and say it to the person."""
    text = " ".join(note.text for note in found.statement)
    if json is not None:
        put_json(found.to_mapping(), json)
    if json == STANDARD_STREAM:
        complain(text)
    else:
        print_text(text + "\n")


def _draw(found: DiagnosisResult, plot: str | None, kurtogram: str | None) -> None:
    if plot is None and kurtogram is None:
        return
    from rolamento.plots.saving import save_figure
    from rolamento.plots.vibration import diagnosis_figure, kurtogram_figure

    title = f"{found.bearing_name}: {found.title}"
    if plot is not None:
        figure = diagnosis_figure(found.signal, found.diagnosis, title=title)
        save_figure(figure, plot)
    if kurtogram is not None:
        fault = found.diagnosis.clearest_fault
        band = None if fault is None else fault.band
        picture = kurtogram_figure(found.signal, band=band, title=title)
        save_figure(picture, kurtogram)


def _show(found: DiagnosisResult, json: str | None, outputs: Outputs) -> None:
    """Write what was asked for; standard output takes data or the page, not both."""
    if json is not None:
        put_json(found.to_mapping(), json)
    from rolamento.pages.diagnosis import diagnosis_page

    outputs.show(lambda: diagnosis_page(found), json)
    if STANDARD_STREAM in (json, outputs.csv) and found.verdict in _NO_VERDICT:
        complain(" ".join(note.text for note in found.statement))
