"""`rolamento diagnose`: which parts of a bearing a vibration signal shows to be damaged."""

from __future__ import annotations

import sys
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Final

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    LanguageOption,
    plain_endings,
    same_file,
    words_of,
)
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text, put
from rolamento.errors import FileError, InputError

if TYPE_CHECKING:
    from rolamento.cli.diagnose_signal import GivenBearing
    from rolamento.cli.weibull_progress import Progress
    from rolamento.report.diagnosis import DiagnosisResult
    from rolamento.report.language import Words
    from rolamento.vibration.diagnosis import DiagnosisSettings

__all__ = ["diagnose"]

_FALSE_ALARM: Final = 0.01
_SLIP: Final = 0.02
_RATES: Final = {"": 1.0, "Hz": 1.0, "kHz": 1e3, "MHz": 1e6}
_TIMES: Final = {"": 1.0, "s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0}


@dataclass(frozen=True, slots=True)
class _Asked:
    """What the options say of the signal's file."""

    path: str
    channel: str | None
    rate: float | None
    unit: str | None
    start: float
    duration: float | None
    inner_speed: float | None
    outer_speed: float | None


def diagnose(
    signal: Annotated[
        str,
        typer.Argument(
            metavar="SIGNAL", help="File of a signal: WAV, CSV, NPY, MATLAB and others."
        ),
    ],
    bearing: Annotated[
        str,
        typer.Option(
            "--bearing", metavar="BEARING", help="Designation such as 6205, or a case file."
        ),
    ],
    speed: Annotated[
        str | None,
        typer.Option(
            "--speed",
            metavar="SPEED",
            help="Of the inner ring, such as '1797 rpm'; by default as the file tells it, or else"
            " the case.",
        ),
    ] = None,
    outer_speed: Annotated[
        str | None,
        typer.Option("--outer-speed", metavar="SPEED", help="Of the outer ring; signed as well."),
    ] = None,
    channel: Annotated[
        str | None,
        typer.Option("--channel", metavar="CHANNEL", help="Name, or number from 1 on."),
    ] = None,
    rate: Annotated[
        str | None,
        typer.Option(
            "--rate", metavar="RATE", help="Of sampling, such as '12 kHz', if the file is silent."
        ),
    ] = None,
    unit: Annotated[
        str | None,
        typer.Option("--unit", metavar="UNIT", help="Of the samples: m/s^2, g, mm/s, um …"),
    ] = None,
    slip: Annotated[
        float,
        typer.Option(
            "--slip",
            metavar="PART",
            help="By which the cage may be off its nominal speed, 0 to 0.1.",
        ),
    ] = _SLIP,
    false_alarm: Annotated[
        float,
        typer.Option(
            "--false-alarm",
            metavar="P",
            help="Probability that a sound bearing gets any fault, up to 0.5.",
        ),
    ] = _FALSE_ALARM,
    start: Annotated[
        str | None,
        typer.Option("--start", metavar="TIME", help="To begin at, such as '2 s'."),
    ] = None,
    duration: Annotated[
        str | None,
        typer.Option("--duration", metavar="TIME", help="To look at from there; by default all."),
    ] = None,
    plot: Annotated[
        str | None,
        typer.Option(
            "--plot",
            metavar="FILE",
            help="Draw waveform, kurtogram and envelope spectrum: a .png, .svg or .pdf file.",
        ),
    ] = None,
    kurtogram: Annotated[
        str | None,
        typer.Option("--kurtogram", metavar="FILE", help="Draw the kurtogram alone, likewise."),
    ] = None,
    json: Annotated[
        str | None,
        typer.Option(
            "--json",
            metavar="[FILE]",
            help="Write everything as JSON, in SI units; without FILE, to standard output.",
        ),
    ] = None,
    csv: Annotated[
        str | None,
        typer.Option(
            "--csv",
            metavar="FILE",
            help="Write the spectrum of the squared envelope; - is standard output.",
        ),
    ] = None,
    lang: LanguageOption = None,
) -> None:
    """Say which parts of a bearing a vibration signal shows to be damaged, and how sure that is."""
    with plain_endings(lang):
        _check_outputs(
            signal, {"--json": json, "--csv": csv, "--plot": plot, "--kurtogram": kurtogram}
        )
        from rolamento.cli.diagnose_signal import bearing_of, speed_given, to_number

        settings = _settings(slip, false_alarm)
        given = bearing_of(bearing)
        asked = _Asked(
            signal,
            channel,
            to_number(rate, "--rate", _RATES, "--rate '12 kHz'"),
            unit,
            to_number(start, "--start", _TIMES, "--start '2 s'") or 0.0,
            to_number(duration, "--duration", _TIMES, "--duration '10 s'"),
            speed_given(speed, "--speed"),
            speed_given(outer_speed, "--outer-speed"),
        )
        words = words_of(lang)
        with _told(words) as progress:
            found = _found(asked, given, settings, progress)
            _draw(found, plot, kurtogram, words.code)
        _show(found, json, csv, words)
    raise typer.Exit(NO_RESULT if found.verdict == "no_verdict" else SOLVED)


def _check_outputs(signal: str, outputs: dict[str, str | None]) -> None:
    """Refuse outputs that would run into each other or over the signal, and unknown pictures."""
    given = {option: path for option, path in outputs.items() if path is not None}
    for option, path in given.items():
        if list(given.values()).count(path) > 1:
            where = "standard output" if path == STANDARD_STREAM else path
            raise InputError(f"only one of {', '.join(outputs)} can go there", source=where)
        if same_file(path, signal):
            raise FileError("is the file of the signal itself; choose another name", source=path)
        if option in ("--plot", "--kurtogram"):
            from rolamento.plots.saving import check_name

            check_name(path)


def _settings(slip: float, false_alarm: float) -> DiagnosisSettings:
    from rolamento.vibration.diagnosis import DiagnosisSettings

    options = {"tolerance": "--slip", "false_alarm": "--false-alarm"}
    try:
        return DiagnosisSettings(false_alarm=false_alarm, tolerance=slip)
    except InputError as error:
        option = options.get(error.field or "", "")
        raise InputError(error.rule, source=option, value=error.value) from None


def _told(words: Words) -> AbstractContextManager[Progress]:
    """Show how much of the signal was read, for whoever waits longer than a second."""
    from rolamento.cli.weibull_progress import told
    from rolamento.report.diagnosis_words import DIAGNOSIS_WORDS

    return told(DIAGNOSIS_WORDS[words.code].reading)


def _found(
    asked: _Asked, given: GivenBearing, settings: DiagnosisSettings, progress: Progress
) -> DiagnosisResult:
    """Read the signal block by block, and diagnose it."""
    from rolamento.cli.diagnose_signal import part_of, streamed
    from rolamento.report.diagnosis import DiagnosisResult
    from rolamento.vibration.diagnosis import FaultOrders, diagnose
    from rolamento.vibration.frequencies import nominal_frequencies
    from rolamento.vibration.reading import open_signal

    with open_signal(asked.path, channel=asked.channel, rate=asked.rate, unit=asked.unit) as source:
        part = part_of(source, asked.start, asked.duration)
        pieces = (source.read(place, min(part.step, part.stop - place)) for place in part)
        inner, outer = _speeds(asked, given, source.speed)

        def read(samples: int) -> None:
            progress(-(-samples // part.step), len(part))

        held = streamed(pieces, inner or outer, read)
        frequencies = nominal_frequencies(given.bearing, inner, outer)
        diagnosis = diagnose(held.pieces, FaultOrders.of(frequencies), settings)
        return DiagnosisResult(
            title=held.first.title or asked.path,
            bearing_name=given.name,
            bearing=given.bearing,
            frequencies=frequencies,
            diagnosis=diagnosis,
            settings=settings,
            signal=held.first,
            duration=held.duration,
            reading_notes=source.notes,
        )


def _speeds(asked: _Asked, given: GivenBearing, of_file: float | None) -> tuple[float, float]:
    """Return the rings' speeds, rad/s: of the options, of the signal's file, of the case.

    What the file tells is the shaft's: the inner ring's, unless the outer one alone is given.
    """
    if asked.inner_speed is None and asked.outer_speed is None and of_file is not None:
        outer_turns = not given.inner_speed and bool(given.outer_speed)
        return (0.0, of_file) if outer_turns else (of_file, given.outer_speed or 0.0)
    outer = given.outer_speed if asked.outer_speed is None else asked.outer_speed
    inner = asked.inner_speed
    if inner is None:
        inner = given.inner_speed
    if not inner and not outer:
        raise InputError(
            "is missing, and neither the file nor the case tells it"
            if inner is None and outer is None
            else "must not be 0: a bearing that does not turn tells nothing",
            source="--speed",
            example="--speed '1797 rpm'",
        )
    return inner or 0.0, outer or 0.0


def _draw(found: DiagnosisResult, plot: str | None, kurtogram: str | None, language: str) -> None:
    if plot is None and kurtogram is None:
        return
    from rolamento.plots.saving import save_figure
    from rolamento.plots.vibration import diagnosis_figure, kurtogram_figure
    from rolamento.plots.vibration_spectrum import clearest_fault

    title = f"{found.bearing_name}: {found.title}"
    if plot is not None:
        figure = diagnosis_figure(found.signal, found.diagnosis, title=title, language=language)
        save_figure(figure, plot)
    if kurtogram is not None:
        fault = clearest_fault(found.diagnosis)
        band = None if fault is None else fault.band
        picture = kurtogram_figure(found.signal, band=band, title=title, language=language)
        save_figure(picture, kurtogram)


def _show(found: DiagnosisResult, json: str | None, csv: str | None, words: Words) -> None:
    """Write what was asked for; standard output takes data or the report, not both."""
    from rolamento.report.diagnosis import diagnosis_csv, diagnosis_json, diagnosis_report

    if json is not None:
        put(diagnosis_json(found) + "\n", json)
    if csv is not None:
        put(diagnosis_csv(found), csv)
    if STANDARD_STREAM not in (json, csv):
        from rolamento.report.medium import Medium

        print_text(diagnosis_report(found, words, Medium.of(sys.stdout)))
    elif found.verdict == "no_verdict":
        from rolamento.report.diagnosis_sentences import said_statements

        complain(" ".join(said_statements(found.diagnosis, words.code, still=found.still)))
