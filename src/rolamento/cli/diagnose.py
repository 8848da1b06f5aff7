"""`rolamento diagnose`: which parts of a bearing a vibration signal shows to be damaged."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import typer

from rolamento.cli.common import (
    NO_RESULT,
    SOLVED,
    Language,
    plain_endings,
    words_of,
)
from rolamento.cli.diagnose_options import (
    AngleOption,
    BearingOption,
    CsvOption,
    FalseAlarmOption,
    KurtogramOption,
    NominalOption,
    PlotOption,
    PulsesOption,
    SignalArgument,
    SlipOption,
    SpeedChannelOption,
    SpeedOption,
    SpeedToleranceOption,
    SpeedUnitOption,
    TachoOption,
    TrackOption,
    UnitOption,
    WithinOption,
)
from rolamento.cli.options import (
    ChannelOption,
    DurationOption,
    JsonOption,
    LanguageOption,
    OuterSpeedOption,
    RateOption,
    ScaleOption,
    SettingsOption,
    StartOption,
)
from rolamento.cli.outputs import check_outputs
from rolamento.cli.streams import STANDARD_STREAM, complain, print_text, put
from rolamento.cli.table_options import DecimalMarkOption
from rolamento.errors import InputError

if TYPE_CHECKING:
    from rolamento.cli.diagnose_bearing import GivenBearing
    from rolamento.cli.diagnose_speed import AskedSpeed, KnownSpeed
    from rolamento.cli.signal_source import SignalChoice
    from rolamento.report.diagnosis import DiagnosisResult
    from rolamento.report.language import Words
    from rolamento.vibration.diagnosis import DiagnosisSettings
    from rolamento.vibration.frequencies import FaultFrequencies

__all__ = ["diagnose"]

_FALSE_ALARM: Final = 0.01
_NO_VERDICT: Final = ("no_verdict", "undecided")
_SLIP: Final = 0.02
_SPEED_TOLERANCE: Final = "3 %"


@dataclass(frozen=True, slots=True)
class _Asked:
    """What the options say of the signal's file, the speed, the bearing and the search."""

    path: str
    choice: SignalChoice
    speed: AskedSpeed
    bearing: GivenBearing
    nominal: bool
    angle: str | None
    settings: DiagnosisSettings


def diagnose(
    signal: SignalArgument,
    bearing: BearingOption,
    settings: SettingsOption = None,
    nominal: NominalOption = False,
    angle: AngleOption = None,
    speed: SpeedOption = None,
    outer_speed: OuterSpeedOption = None,
    speed_channel: SpeedChannelOption = None,
    speed_unit: SpeedUnitOption = None,
    tacho: TachoOption = None,
    pulses: PulsesOption = None,
    track: TrackOption = False,
    within: WithinOption = None,
    channel: ChannelOption = None,
    rate: RateOption = None,
    unit: UnitOption = None,
    scale: ScaleOption = None,
    start: StartOption = None,
    duration: DurationOption = None,
    decimal_mark: DecimalMarkOption = None,
    slip: SlipOption = _SLIP,
    speed_tolerance: SpeedToleranceOption = _SPEED_TOLERANCE,
    false_alarm: FalseAlarmOption = _FALSE_ALARM,
    plot: PlotOption = None,
    kurtogram: KurtogramOption = None,
    json: JsonOption = None,
    csv: CsvOption = None,
    lang: LanguageOption = None,
) -> None:
    """Say which parts a vibration signal shows to be damaged.

    Says how badly, why, and what speaks against it. A long signal is read block by block, in
    bounded memory.
    """
    with plain_endings(lang):
        outputs = {"--json": json, "--csv": csv, "--plot": plot, "--kurtogram": kurtogram}
        check_outputs(outputs, signal, bearing, rule="is a file that is read")
        from rolamento.cli.diagnose_bearing import bearing_of
        from rolamento.cli.diagnose_speed import AskedSpeed
        from rolamento.cli.quantities import speed_given
        from rolamento.cli.signal_source import choice_of

        asked = _Asked(
            path=signal,
            choice=choice_of(channel, rate, unit, scale, start, duration, decimal_mark),
            speed=AskedSpeed(
                inner=speed_given(speed, "--speed"),
                outer=speed_given(outer_speed, "--outer-speed"),
                channel=speed_channel,
                unit=speed_unit,
                tacho=tacho,
                pulses=pulses,
                track=track,
                within=within,
            ),
            bearing=bearing_of(bearing, settings or []),
            nominal=nominal,
            angle=angle,
            settings=_settings(slip, false_alarm, speed_tolerance),
        )
        words = words_of(lang)
        try:
            found = _found(asked, words, lang)
        except _TooShortError as short:
            short.show(json, words.code)
            raise typer.Exit(NO_RESULT) from None
        _draw(found, plot, kurtogram, words.code)
        _show(found, json, csv, words)
    raise typer.Exit(NO_RESULT if found.verdict in _NO_VERDICT else SOLVED)


def _settings(slip: float, false_alarm: float, speed_tolerance: str) -> DiagnosisSettings:
    from rolamento.vibration.diagnosis import DiagnosisSettings

    options = {
        "tolerance": ("--slip", _SLIP),
        "false_alarm": ("--false-alarm", _FALSE_ALARM),
        "speed_tolerance": ("--speed-tolerance", f"'{_SPEED_TOLERANCE}'"),
    }
    try:
        return DiagnosisSettings(
            false_alarm=false_alarm,
            tolerance=slip,
            speed_tolerance=_part(speed_tolerance, "--speed-tolerance"),
        )
    except InputError as error:
        if error.field not in options:
            raise
        option, usual = options[error.field]
        example = f"{option} {usual}"
        raise InputError(error.rule, source=option, value=error.value, example=example) from None


def _part(text: str, option: str) -> float:
    """Return a part of one, given as a number or in percent."""
    number = text.strip()
    percent = number.endswith("%")
    try:
        value = float(number.removesuffix("%"))
    except ValueError:
        raise InputError(
            "must be a part such as 0.03, or in percent",
            source=option,
            value=text,
            example=f"{option} '{_SPEED_TOLERANCE}'",
        ) from None
    return value / 100.0 if percent else value


def _found(asked: _Asked, words: Words, lang: Language | None) -> DiagnosisResult:
    """Read the signal block by block, and diagnose it at its speed."""
    from rolamento.cli.diagnose_bearing import searched, sought
    from rolamento.cli.diagnose_signal import part_of, streamed
    from rolamento.cli.diagnose_speed import known_speed
    from rolamento.cli.signal_source import opened
    from rolamento.cli.waiting import progress_of, waiting
    from rolamento.report.diagnosis import DiagnosisResult
    from rolamento.report.diagnosis_words import DIAGNOSIS_WORDS
    from rolamento.vibration.diagnosis import FaultOrders, diagnose

    said, given = DIAGNOSIS_WORDS[words.code], asked.bearing
    sensor = {"speed_channel": asked.speed.channel, "speed_unit": asked.speed.unit}
    with opened(asked.path, asked.choice, part=False, **sensor) as source:
        part = part_of(source, asked.choice.start, asked.choice.duration)
        with progress_of(said.tracking) as progress:
            speed = known_speed(asked.speed, given.speeds, source, part, progress)
        with waiting(lang):
            looked = sought(
                given, speed.inner, speed.outer, nominal=asked.nominal, angle=asked.angle
            )
        search = searched(looked.frequencies, asked.settings)
        _check_length(looked.frequencies, speed, part.stop - part.start, source.rate)
        with progress_of(said.reading) as progress:
            pieces = (source.read(place, min(part.step, part.stop - place)) for place in part)
            held = streamed(
                pieces, speed.at, lambda done: progress(-(-done // part.step), len(part))
            )
            orders = FaultOrders.of(looked.frequencies)
            diagnosis = diagnose(held.pieces, orders, search.settings)
        return DiagnosisResult(
            title=held.first.title or asked.path,
            bearing_name=given.name,
            bearing=given.case.bearing,
            frequencies=looked.frequencies,
            diagnosis=diagnosis,
            settings=search.settings,
            signal=held.first,
            duration=held.duration,
            reading_notes=(*source.notes, *(note.text for note in speed.choices)),
            choices=(*source.choices, *speed.choices),
            speed=speed.shaft,
            state=looked.state,
            slip=search.slip,
            covers_balls=search.covers_balls,
            other_rows=search.other_rows,
        )


class _TooShortError(Exception):
    """A record in which no race can be told, by its length: said before it is read.

    turns, least: revolutions that it has, or that the longest stretch has which is judged at once,
    and from which on it tells something; duration: of that, s.
    """

    def __init__(self, turns: float, least: float, duration: float, *, is_stretch: bool) -> None:
        super().__init__(turns, least, duration)
        self.turns, self.least, self.duration = turns, least, duration
        self.is_stretch = is_stretch

    def show(self, json: str | None, language: str) -> None:
        """Write JSON where it was asked for, and say it to the person."""
        from rolamento.report.diagnosis_sentences import said_too_short
        from rolamento.report.plain_data import json_text

        numbers = (self.turns, self.least, self.duration)
        if json is not None:
            statement = said_too_short(*numbers, "en", is_stretch=self.is_stretch)
            data = {
                "verdict": "no_verdict",
                "statement": [statement],
                "reason": "shaft_too_slow" if self.is_stretch else "record_too_short",
                "revolutions": self.turns,
                "least_revolutions": self.least,
                "duration": self.duration,
            }
            put(json_text(data) + "\n", json)
        said = said_too_short(*numbers, language, is_stretch=self.is_stretch)
        if json == STANDARD_STREAM:
            complain(said)
        else:
            print_text(said + "\n")


def _check_length(
    frequencies: FaultFrequencies, speed: KnownSpeed, samples: int, rate: float
) -> None:
    """Refuse a record in whose spectrum both races lie where no level of noise is known."""
    from math import ceil, pi

    from rolamento.vibration.diagnosis.blocks import MOST_SAMPLES
    from rolamento.vibration.noise_floor import LOWEST_LINE

    orders = [frequencies.of_fault(race).order for race in ("outer_race", "inner_race")]
    least = (LOWEST_LINE + 1) / max(orders)
    block = min(samples, MOST_SAMPLES) / rate
    turns = block * max(abs(speed.shaft.least), abs(speed.shaft.most)) / (2.0 * pi)
    if turns < least:
        is_stretch = samples > MOST_SAMPLES
        raise _TooShortError(turns, ceil(10.0 * least) / 10.0, block, is_stretch=is_stretch)


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
    elif found.verdict in _NO_VERDICT:
        from rolamento.report.diagnosis_sentences import said_result

        complain(" ".join(said_result(found, words.code)))
