"""What files call sampling rates, speeds and time, and where they write units."""

from __future__ import annotations

import re
from collections.abc import Mapping
from math import isfinite, pi
from typing import Final

from rolamento.vibration.reading._limits import LONGEST_NAME
from rolamento.vibration.reading._units import is_unit, plain_unit, spelled

__all__ = [
    "label_parts",
    "positive",
    "rate_among",
    "short_name",
    "speed_among",
    "time_scale",
    "unit_among",
]

_RATE: Final = (
    *("fs", "sr", "rate", "sps", "fsamp", "fsample", "abtastrate", "taxadeamostragem"),
    *("samplingrate", "samplerate", "samplingfrequency", "samplefrequency", "samplingfreq"),
)
_STEP: Final = (
    *("dt", "dx", "deltat", "tdelta", "timestep", "timeincrement", "wfincrement", "xincrement"),
    *("samplingperiod", "sampleperiod", "samplinginterval", "sampleinterval"),
)
_SPEED: Final = ("rpm", "shaftrpm", "speedrpm", "rotationspeedrpm", "rotationalspeedrpm")
_UNIT: Final = ("unit", "units", "unitstring", "yunit", "yunits", "engunits")
_TIME: Final = (
    *("t", "time", "times", "timestamp", "seconds", "elapsed", "xtime", "zeit", "tempo", "temps"),
)
_TIME_UNITS: Final = {
    "s": 1.0,
    "sec": 1.0,
    "second": 1.0,
    "seconds": 1.0,
    "ms": 1e-3,
    "us": 1e-6,
    "ns": 1e-9,
    "min": 60.0,
}
_BRACKETED: Final = re.compile(r"([^()\[\]{}]*)(?:\[([^\[\]]*)\]|\(([^()]*)\))\s*")


def label_parts(label: str) -> tuple[str, str]:
    """Split a heading such as ``"acc (g)"`` into name and unit.

    In square brackets everything is a unit; in round ones only what is known to be one.
    """
    match = _BRACKETED.fullmatch(label[: 2 * LONGEST_NAME])
    if match:
        unit = plain_unit(match[2] if match[2] is not None else match[3])
        if match[2] is not None or is_unit(unit) or unit in _TIME_UNITS:
            return short_name(match[1]), unit
    return short_name(label), ""


def short_name(name: str) -> str:
    """Return a name in one line, cut where it is too long."""
    line = " ".join(name[: 4 * LONGEST_NAME].split())
    return line if len(line) <= LONGEST_NAME else line[: LONGEST_NAME - 1] + "…"


def time_scale(name: str, unit: str) -> float | None:
    """Seconds in one unit of a column, if it is one of times; None if it is not."""
    plain = spelled(unit).lower()
    if _folded(name) in _TIME and (not unit or plain in _TIME_UNITS):
        return _TIME_UNITS.get(plain, 1.0)
    return None


def rate_among(numbers: Mapping[str, float]) -> float | None:
    """Sampling rate by the name of one of the numbers that a file gives; Hz."""
    for name, value in numbers.items():
        if _folded(name) in _RATE and positive(value):
            return value
    for name, value in numbers.items():
        if _folded(name) in _STEP and positive(value) and positive(1.0 / value):
            return 1.0 / value
    return None


def speed_among(numbers: Mapping[str, float]) -> float | None:
    """Speed of the shaft by the name of one of the numbers that a file gives; rad/s."""
    for name, value in numbers.items():
        if _folded(name) in _SPEED and isfinite(value):
            return value * pi / 30.0
    return None


def unit_among(texts: Mapping[str, str]) -> str:
    """Unit by the name of one of the texts that a file gives; "" if there is none."""
    return next((plain_unit(text) for name, text in texts.items() if _folded(name) in _UNIT), "")


def positive(value: float) -> bool:
    """Tell whether a number can be a rate or a step."""
    return 0.0 < value < 1e12


def _folded(name: str) -> str:
    """Letters and digits only, in lower case: Sampling_Rate and "sampling rate" are one."""
    plain = re.sub(r"[\[(]\s*(?:hz|s|rpm|1/min)\s*[\])]", "", name[:LONGEST_NAME].lower())
    return re.sub(r"[^a-z0-9]", "", plain)  # of "fs (kHz)" the kHz is left: not a rate in Hz
