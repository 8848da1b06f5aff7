"""What files call sampling rates, speeds and time, and where they write units.

Of several numbers that a file gives, one may be no sampling rate at all: ``rate`` beside ``sr`` or
beside times is often the shaft's. What is left and disagrees is a doubt that the user decides.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping, Sequence
from math import isfinite, pi
from typing import Final, Literal, NamedTuple

import numpy as np

from rolamento.errors import FileError
from rolamento.io.columns import seconds_of_heading
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.vibration.reading.units import SPEED_UNITS, is_unit, plain_unit
from rolamento.words import marked, said

__all__ = [
    "SAME_RATE",
    "FileRate",
    "RateClaim",
    "RateClaims",
    "Timeline",
    "TwoWays",
    "is_rate_or_step",
    "is_unit_name",
    "label_parts",
    "positive",
    "rate_of",
    "rates_among",
    "short_name",
    "speed_among",
    "speeds_perhaps",
    "time_scale",
    "time_scale_perhaps",
    "unit_among",
]

_LONGEST_NAME: Final = 100
"""Characters of a channel's name; longer ones are cut."""

_RATE: Final = (
    *("fs", "sr", "sps", "fsamp", "fsample", "abtastrate", "taxadeamostragem"),
    *("samplingrate", "samplerate", "samplingfrequency", "samplefrequency", "samplingfreq"),
    *("samplefreq", "samplingspeed", "scanrate", "acquisitionrate", "samplespersecond"),
    *("samplespersec", "samplespers", "sampless", "sampleclockrate", "samplespeed"),
    *("frequenciadeamostragem", "freqamostragem", "taxaamostragem", "taxadeaquisicao"),
    *("frequenciadeaquisicao", "abtastfrequenz", "messrate", "abtastratehz", "abtastung"),
    *("frecuenciademuestreo", "tasademuestreo", "velocidaddemuestreo", "frecuenciadeadquisicion"),
)
_LOOSE_RATE: Final = ("rate", "taxa")
"""The sampling rate where nothing else is; the shaft's speed in Hz in other files."""
_STEP: Final = (
    *("dt", "dx", "deltat", "tdelta", "timestep", "timeincrement", "wfincrement", "xincrement"),
    *("samplingperiod", "sampleperiod", "samplinginterval", "sampleinterval", "deltax", "xdelta"),
    *("timeinterval", "sampletime", "samplingtime", "scaninterval", "timebetweensamples"),
    *("intervalodeamostragem", "periododeamostragem", "passodetempo", "incrementodetempo"),
    *("abtastintervall", "abtastperiode", "abtastzeit", "messintervall", "zeitschritt"),
    *("intervalodemuestreo", "periododemuestreo", "pasodetiempo"),
)
_SHAFT: Final = re.compile(
    r"(?:shaft|rotation|rotational|rotating|motor|running|rotor|eixo|rotacao|derotacao|velocidade)*"
    r"(?:speed|velocity|freq|frequency|rate|rotacao|velocidade|frequencia)?"
)
"""What stands before the unit of a number that is a speed, folded: shaft speed, motor, nothing."""
_IN_HERTZ: Final = re.compile(
    r"(?:shaft|rotation|rotational|rotor)(?:rate|freq|frequency)|frequenciaderotacao"
)
"""Names of a speed that is turns per second without a unit."""
_PERHAPS_SPEED: Final = (
    *("rate", "speed", "shaft", "shaftspeed", "motorspeed", "rotationspeed", "rotationalspeed"),
    *("velocidade", "rotacao", "drehzahl", "freq", "frequency", "fr"),
)
_FASTEST_SHAFT: Final = 1000.0
"""Turns per second: no sampling rate of a vibration is as low, and hardly a shaft is as fast."""
_CLEARLY_BELOW: Final = 20.0
"""Times that a sampling rate is above the shaft's: a record with less shows no bearing."""
_UNIT: Final = (
    *("unit", "units", "unitstring", "yunit", "yunits", "engunits", "yunitlabel", "yunitslabel"),
    *("verticalunits", "verticalunit", "unidade", "unidades", "einheit", "einheiten", "unidad"),
    *("unidades", "engineeringunits"),
)
_BRACKETED: Final = re.compile(r"([^()\[\]{}]*)(?:\[([^\[\]]*)\]|\(([^()]*)\))\s*")


def label_parts(label: str) -> tuple[str, str]:
    """Split a heading such as ``"acc (g)"`` into name and unit.

    In square brackets everything is a unit; in round ones only what is known to be one, of a
    signal or of time.
    """
    match = _BRACKETED.fullmatch(label[: 2 * _LONGEST_NAME])
    if match:
        unit = plain_unit(match[2] if match[2] is not None else match[3])
        if match[2] is not None or is_unit(unit) or seconds_of_heading("", unit)[0] is not None:
            return short_name(match[1]), unit
    return short_name(label), ""


def short_name(name: str) -> str:
    """Return a name in one line, cut where it is too long."""
    line = " ".join(name[: 4 * _LONGEST_NAME].split())
    return line if len(line) <= _LONGEST_NAME else line[: _LONGEST_NAME - 1] + "…"


def time_scale(name: str, unit: str) -> float | None:
    """Seconds in one unit of a column, if its name is that of times; None if it is not."""
    scale, sure = seconds_of_heading(name, unit)
    return scale if sure else None


def time_scale_perhaps(name: str, unit: str) -> float | None:
    """Seconds in one unit of a column that is one of times if its numbers rise evenly."""
    return seconds_of_heading(name, unit)[0]


class RateClaim(NamedTuple):
    """A number that a file gives for its sampling rate: by which name, and what it comes to; Hz."""

    name: str
    value: float


class TwoWays(NamedTuple):
    """A line of a file's header whose number may be read in two ways: "Fs: 25.600"; line from 1."""

    name: str
    text: str
    line: int


class RateClaims(NamedTuple):
    """Numbers of a file that are sampling rates, and such as may be something else; Hz."""

    clear: tuple[RateClaim, ...] = ()
    loose: tuple[RateClaim, ...] = ()
    two_ways: TwoWays | None = None


@frozen
class FileRate:
    """What a file says of its sampling rate, all in all.

    Attributes
    ----------
    value
        Hz; None if the file does not say, or says it in several ways
    doubt
        the ways, if there is more than one, or the only one if it may be of something else
    aside
        number that is taken for something else, with its name; None if there is none
    two_ways
        the only line that says it, if it may be read in two ways
    """

    value: float | None = None
    doubt: tuple[RateClaim, ...] = ()
    aside: RateClaim | None = None
    two_ways: TwoWays | None = None


def rates_among(levels: Sequence[Mapping[str, float]]) -> RateClaims:
    """Sampling rates by the names of the numbers that a file gives.

    Parameters
    ----------
    levels
        Numbers of the channel itself, of its group, of the file: the nearest hold.
    """
    clear: tuple[RateClaim, ...] = ()
    loose: tuple[RateClaim, ...] = ()
    for numbers in levels:
        if not clear:
            clear = (
                *(RateClaim(f'"{short_name(name)}"', value) for name, value in numbers.items()
                  if _without_unit(name) in _RATE and positive(value)),
                *(RateClaim(f'"{short_name(name)}" = {value:.9g} s', 1.0 / value)
                  for name, value in numbers.items()
                  if _without_unit(name) in _STEP and positive(value) and positive(1.0 / value)),
            )  # fmt: skip
        if not loose:
            loose = tuple(
                RateClaim(f'"{short_name(name)}"', value)
                for name, value in numbers.items()
                if _without_unit(name) in _LOOSE_RATE and positive(value)
            )
    return RateClaims(clear, loose)


def rate_of(claims: RateClaims, times: float | None = None) -> FileRate:
    """Weigh what a file says of its sampling rate.

    Parameters
    ----------
    claims
        Numbers by their names.
    times
        Rate of the samples' times, if the file has them; Hz.
    """
    stated = (*(() if times is None else (RateClaim("the column of times", times),)), *claims.clear)
    if not stated:
        return _of_loose(claims.loose)
    # what is written down holds over times of few digits, if they agree
    value = (claims.clear or stated)[0].value
    rivals = [claim for claim in stated if not _same(claim.value, value)]
    aside = None
    for claim in claims.loose:
        if _same(claim.value, value):
            continue
        if claim.value <= min(_FASTEST_SHAFT, value / _CLEARLY_BELOW):
            aside = claim
        else:
            rivals.append(claim)
    if rivals:
        first = next(claim for claim in stated if _same(claim.value, value))
        doubt = (first, *rivals)
        alone = len({claim.name for claim in doubt}) == 1
        return FileRate(None, doubt, two_ways=claims.two_ways if alone else None)
    return FileRate(value, (), aside)


def _of_loose(loose: Sequence[RateClaim]) -> FileRate:
    """Weigh a number that is called a rate, and nothing more."""
    if not loose:
        return FileRate()
    first = loose[0]
    if not all(_same(claim.value, first.value) for claim in loose):
        return FileRate(None, tuple(loose))
    if first.value <= _FASTEST_SHAFT:  # it may be the speed of the shaft as well
        return FileRate(None, (first,))
    return FileRate(first.value)


def _same(one: float, other: float) -> bool:
    return abs(one - other) <= SAME_RATE * other


def speed_among(numbers: Mapping[str, float]) -> float | None:
    """Speed of the shaft by the name of one of the numbers that a file gives; rad/s."""
    for name, value in numbers.items():
        plain = _letters_and_digits(name)
        if not isfinite(value):
            continue
        if plain.endswith("rpm") and _SHAFT.fullmatch(plain.removesuffix("rpm")):
            return value * pi / 30.0
        turns = plain.removesuffix("hz")
        if _IN_HERTZ.fullmatch(turns) or (turns != plain and turns and _SHAFT.fullmatch(turns)):
            return value * SPEED_UNITS["Hz"]
    return None


def speeds_perhaps(numbers: Mapping[str, float], rate: float) -> dict[str, float]:
    """Numbers of a file that may be the speed of the shaft, and do not say in which unit.

    rate: of sampling, which is none; Hz.
    """
    return {
        name: value
        for name, value in numbers.items()
        if _without_unit(re.split(r"[./]", name)[-1]) in _PERHAPS_SPEED
        and positive(value)
        and not _same(value, rate)
    }


def unit_among(texts: Mapping[str, str]) -> str:
    """Unit by the name of one of the texts that a file gives; "" if there is none."""
    return next(
        (plain_unit(text) for name, text in texts.items() if _without_unit(name) in _UNIT), ""
    )


def positive(value: float) -> bool:
    """Return whether a number can be a rate or a step."""
    return 0.0 < value < 1e12


def is_rate_or_step(name: str) -> Literal["rate", "step", ""]:
    """Return whether a name is that of a sampling rate, or of the time between samples."""
    plain = _without_unit(name)
    if plain in _RATE or plain in _LOOSE_RATE:
        return "rate"
    return "step" if plain in _STEP else ""


def is_unit_name(name: str) -> bool:
    """Return whether a name is that of the unit of samples."""
    return _without_unit(name) in _UNIT


def _without_unit(name: str) -> str:
    """Letters and digits only, in lower case: Sampling_Rate and "sampling rate" are one."""
    without = re.sub(
        r"[\[(]\s*(?:hz|s|rpm|1/min|sa?/s|samples?/s(?:ec)?)\s*[\])]",
        "",
        name[:_LONGEST_NAME].lower(),
    )
    return _letters_and_digits(without)  # of "fs (kHz)" the kHz is left: not a rate in Hz


def _letters_and_digits(name: str) -> str:
    """Letters and digits of a name with its unit, in lower case and without accents."""
    parts = unicodedata.normalize("NFKD", name[:_LONGEST_NAME].lower())
    return re.sub(r"[^a-z0-9]", "", parts)


SAME_RATE: Final = 1e-3
"""Part by which two statements of a sampling rate may differ: files round the step of time."""

_STEP_OFF: Final = 0.3
"""Fraction of a step: what rounding to the file's digits may do to one. A sample left out does
more."""
_PLACE_OFF: Final = 1.0
"""Fraction of a step: how far an instant may lie from the straight line of its number."""


@frozen
class Timeline:
    """Evenly spaced instants.

    Attributes
    ----------
    first
        instant of sample 0, in the column's unit
    step
        between samples, in the column's unit
    scale
        seconds in the column's unit
    """

    first: float
    step: float
    scale: float

    @classmethod
    def between(cls, first: float, last: float, count: int, scale: float, source: str) -> Timeline:
        """Return the even spacing between the first and the last instant of a column.

        Raises
        ------
        FileError
            If there are fewer than two, or time does not run forward.
        """
        with np.errstate(all="ignore"):
            step = float((np.float64(last) - first) / (count - 1)) if count > 1 else float("nan")
        if not 1e-12 < step * scale < 1e12:
            raise FileError(
                said("does not increase from the first row to the last"),
                field=marked("time column"),
                example="0.0, 0.0001, 0.0002",
                source=source,
            )
        return cls(first, step, scale)

    @property
    def rate(self) -> float:
        """Hz."""
        return 1.0 / (self.step * self.scale)

    def check(self, times: FloatArray, start: int, source: str) -> None:
        """Refuse instants, of which the first is that of sample `start`, that are not even.

        Raises
        ------
        FileError
            If a sample is missing, doubled, or out of step.
        """
        with np.errstate(all="ignore"):
            place = (times - self.first) / self.step - (start + np.arange(len(times)))
            wrong = ~(np.abs(place) <= _PLACE_OFF)
            wrong[1:] |= ~(np.abs(np.diff(place)) <= _STEP_OFF)
        if np.any(wrong):
            number = int(np.argmax(wrong))
            raise FileError(
                said(
                    "is not evenly spaced: sample {start} (counted from 0) is off the mean "
                    "step of {step:.6g} s; a sample is missing, or the times have too few "
                    "digits",
                    start=start + number,
                    step=self.step * self.scale,
                ),
                field=marked("time column"),
                value=float(times[number]),
                source=source,
            )
