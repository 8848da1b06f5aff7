"""What files and users call units, and what one unit of a file's samples is worth.

Units are those of samples, of what a recorder gives, and of speeds. The worth of samples that are
not calibrated follows from the sensitivity of a sensor.
"""

from __future__ import annotations

import re
from math import isfinite, pi
from typing import Any, Final, NamedTuple

import numpy as np

from rolamento.errors import InputError, arguments, nearest, phrase
from rolamento.validate import one_of
from rolamento.vibration.signal import SI_UNITS, Quantity, unit_scale
from rolamento.words import marked, said

__all__ = [
    "SPEED_UNITS",
    "checked_scale",
    "checked_speed_unit",
    "checked_unit",
    "is_raw",
    "is_unit",
    "plain_unit",
    "quantity_of_unit",
    "speed_unit_in",
    "spelled",
]

_LONGEST_UNIT: Final = 30
RAW_UNITS: Final = ("V", "mV", "uV", "counts", "1")
"""What a recorder gives before the sensitivity of the sensor is applied; 1 is its full scale."""

SPEED_UNITS: Final = {
    "rpm": pi / 30.0,
    "rad/s": 1.0,
    "deg/s": pi / 180.0,
    "Hz": 2.0 * pi,
}
"""Units of a rotating speed, and their value in rad/s."""

_OTHER_UNITS: Final = ("A", "mA", "N", "kN", "Pa", "kPa", "bar", "dB", "degC", "°C", "K", "%")
_ALIASES: Final = {
    **dict.fromkeys(("m/s/s", "m/s2", "ms-2", "ms^-2", "m*s^-2"), "m/s^2"),
    **dict.fromkeys(("mm/s2", "mm/s/s"), "mm/s^2"),
    **dict.fromkeys(("gn", "g_n", "g0", "gs", "g's", "G", "Gs"), "g"),
    **dict.fromkeys(("micron", "microns"), "um"),
    **dict.fromkeys(("inch/s", "ips"), "in/s"),
    "inch": "in",
    "mils": "mil",
    **dict.fromkeys(("v", "volt", "volts", "Volt", "Volts"), "V"),
    **dict.fromkeys(("count", "Count", "Counts", "lsb", "LSB", "digits"), "counts"),
    "FS": "1",
    **dict.fromkeys(("r/min", "rev/min", "1/min", "min-1", "min^-1", "U/min"), "rpm"),
    **dict.fromkeys(("rps", "r/s", "rev/s", "hz"), "Hz"),
    **dict.fromkeys(("rads-1", "rad*s^-1"), "rad/s"),
    "°/s": "deg/s",
}
_SPELLINGS: Final = str.maketrans({"µ": "u", "μ": "u", "²": "^2", "⁻": "-", "·": "*", "⋅": "*"})
_KNOWN: Final[dict[str, Quantity]] = {
    **dict.fromkeys(("m/s^2", "mm/s^2", "g", "mg"), "acceleration"),
    **dict.fromkeys(("m/s", "mm/s", "um/s", "in/s"), "velocity"),
    **dict.fromkeys(("m", "mm", "um", "nm", "in", "mil"), "displacement"),
}
for _unit, _quantity in _KNOWN.items():
    unit_scale(_quantity, _unit)  # each is a unit that a signal can have
_NAMED: Final = frozenset((*_KNOWN, *RAW_UNITS, *SPEED_UNITS, *_OTHER_UNITS))
_SPEED_IN_NAME: Final = re.compile(r"(rpm|hz)[\W_\d]*", re.I)


def spelled(text: str) -> str:
    """Return a unit without what spellings differ in: ``"µm"`` as ``"um"``."""
    return text.strip().replace("**", "^").translate(_SPELLINGS).replace(" ", "")


def plain_unit(text: str) -> str:
    """Return a unit as signals write it: ``"m/s²"`` as ``"m/s^2"``, ``"µm"`` as ``"um"``."""
    plain = spelled(text)
    for candidate in (plain, plain.lower() if plain.isupper() else plain):
        unit = _ALIASES.get(candidate, candidate)
        if unit in _NAMED:
            return unit
    return text.strip()[:_LONGEST_UNIT]


def is_unit(unit: str) -> bool:
    """Return whether text, as `plain_unit` returns it, is a unit that has a name here."""
    return unit in _NAMED


def is_raw(unit: str) -> bool:
    """Return whether a unit is that of a recorder: of volts or counts."""
    return unit in RAW_UNITS and unit != "1"


def quantity_of_unit(unit: str) -> Quantity:
    """Return the quantity that a unit belongs to."""
    return _KNOWN.get(unit, "unknown")


def speed_unit_in(name: str) -> str:
    """Return the unit with which the name of a speed ends, as in `X097RPM`; "" if there is none."""
    found = _SPEED_IN_NAME.search(name[-20:])
    return plain_unit(found[1].lower()) if found and found.end() == len(name[-20:]) else ""


def checked_unit(unit: Any) -> str:
    """Return a unit of samples as signals write it, if it is one that can be given.

    Those of acceleration, velocity and displacement are allowed, and what a recorder gives before
    it is calibrated: V, mV, uV, counts, and 1 for its full scale.

    Parameters
    ----------
    unit
        such as "g", "m/s²", "mm/s", "V"

    Raises
    ------
    InputError
        If it is another one: with those that are allowed.
    """
    if not isinstance(unit, str):
        raise InputError(
            said("must be text"), field="unit", value=unit, example=arguments(unit="g")
        )
    plain = plain_unit(unit)
    allowed = (*_KNOWN, *RAW_UNITS)
    if plain not in allowed:
        raise InputError(
            said(
                "is not a unit of a signal; known: {known}; before calibration: {raw_units}",
                known=", ".join(_KNOWN),
                raw_units=", ".join(RAW_UNITS),
            ),
            field="unit",
            value=unit,
            example=arguments(unit=nearest(plain, allowed) or "g"),
        )
    return plain


def checked_speed_unit(unit: Any) -> str:
    """Return a unit of a rotating speed as it is written here.

    Raises
    ------
    InputError
        If it is none.
    """
    plain = plain_unit(unit) if isinstance(unit, str) else ""
    one_of(plain or unit, "speed_unit", SPEED_UNITS, arguments(speed_unit="rpm"))
    return plain


_SMALLEST_SCALE: Final = 1e-15
_LARGEST_SCALE: Final = 1e15
_LONGEST_SCALE: Final = 60
_SCALE: Final = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,3})?)\s*([^\d\s.,].*)")
_VOLTS: Final = {"V": 1.0, "mV": 1e-3, "uV": 1e-6}
_SCALE_EXAMPLE: Final = arguments(scale="100 mV/g")


class Scale(NamedTuple):
    """What one unit of the samples is worth.

    Attributes
    ----------
    factor
        in the SI unit of the quantity
    quantity
        that the samples are of when they are multiplied by it
    """

    factor: float
    quantity: Quantity


def checked_scale(scale: Any, unit: str, quantity: Quantity | None) -> Scale:
    """Return what one unit of the samples is worth.

    Parameters
    ----------
    scale
        a number of SI units, or text: "100 mV/g", "0.5 g/V", or "10 g" for one of whatever the
        samples are in
    unit
        that the samples are in before, "" if nobody says
    quantity
        of the samples after; by default that of the text, and acceleration for a number

    Raises
    ------
    InputError
        If the scale is none, or does not fit the unit or the quantity.
    """
    if quantity_of_unit(unit) != "unknown":
        raise InputError(
            phrase(
                marked(
                    "is for samples in {raw_units}, and these are in {unit} already; write "
                    "the value of one count as {scale}, without unit"
                ),
                raw_units=", ".join(RAW_UNITS),
                unit=unit,
                scale=arguments(scale=f"10 {unit}"),
            ),
            field="scale",
            value=scale,
        )
    if quantity is not None:
        unit_scale(quantity, SI_UNITS.get(quantity, ""))  # refuses what is no quantity
    if quantity == "unknown":
        raise InputError(
            said("needs the quantity that it gives: {si_units}", si_units=", ".join(SI_UNITS)),
            field="scale",
            value=scale,
            example=arguments(quantity="acceleration"),
        )
    if isinstance(scale, str):
        found = _of_text(scale, unit)
    else:
        plain = isinstance(scale, int | float | np.integer | np.floating)
        number = _as_float(scale) if plain and not isinstance(scale, bool) else float("nan")
        found = Scale(number, quantity or "acceleration")
    if not (isfinite(found.factor) and _SMALLEST_SCALE <= abs(found.factor) <= _LARGEST_SCALE):
        raise InputError(
            said(
                "must be a number of magnitude from {least:.6g} to {most:.6g} SI "
                "units, or text with units",
                least=_SMALLEST_SCALE,
                most=_LARGEST_SCALE,
            ),
            field="scale",
            value=scale,
            example=_SCALE_EXAMPLE,
        )
    if quantity is not None and found.quantity != quantity:
        raise InputError(
            said(
                "gives {quantity}, but the quantity is given as {quantity_2}",
                quantity=found.quantity,
                quantity_2=quantity,
            ),
            field="scale",
            value=scale,
        )
    return found


def _of_text(text: str, unit: str) -> Scale:
    match = _SCALE.fullmatch(text) if len(text) <= _LONGEST_SCALE else None
    if match is None:
        raise _unreadable(text)
    number, units = float(match[1]), match[2]
    worth = _worth(units)
    if worth is not None:
        return Scale(number * worth.factor, worth.quantity)
    for place, sign in enumerate(units):
        if sign != "/":
            continue
        above, below = _bare(units[:place]), _bare(units[place + 1 :])
        worth, raw = _worth(below), plain_unit(above)
        if worth is not None and raw in RAW_UNITS:  # "100 mV/g"
            sensitivity = number / _in_samples(raw, unit, text)
            factor = worth.factor / sensitivity if sensitivity else float("inf")
            return Scale(factor, worth.quantity)
        worth, raw = _worth(above), plain_unit(below)
        if worth is not None and raw in RAW_UNITS:  # "0.5 g/V"
            return Scale(number * worth.factor * _in_samples(raw, unit, text), worth.quantity)
    raise _unreadable(text)


def _bare(text: str) -> str:
    return text.strip().removeprefix("(").removesuffix(")")


def _worth(text: str) -> Scale | None:
    """SI value of one unit that a signal can have; None of others."""
    unit = plain_unit(text)
    quantity = quantity_of_unit(unit)
    return None if quantity == "unknown" else Scale(unit_scale(quantity, unit), quantity)


def _in_samples(raw: str, unit: str, text: str) -> float:
    """Conversion factor from the raw unit of a scale to the unit of the samples."""
    if raw == unit or (raw == "counts" and not unit):
        return 1.0
    if raw in _VOLTS and unit in _VOLTS:
        return _VOLTS[unit] / _VOLTS[raw]
    if not unit:
        raise InputError(
            said('of the samples is not in the file; give it with the scale "{text}"', text=text),
            field="unit",
            example=arguments(unit="V" if raw in _VOLTS else raw),
        )
    raise InputError(
        said(
            "is per {raw}, but the samples are in {unit}; give the unit of the samples",
            raw=raw,
            unit=unit,
        ),
        field="scale",
        value=text,
        example=arguments(unit=raw),
    )


def _as_float(number: Any) -> float:
    try:
        return float(number)
    except OverflowError:
        return float("inf")


def _unreadable(text: str) -> InputError:
    return InputError(
        said(
            "is not a sensitivity: a number with units of the signal and of the "
            "raw samples ({raw_units})",
            raw_units=", ".join(RAW_UNITS),
        ),
        field="scale",
        value=text,
        example=_SCALE_EXAMPLE,
    )
