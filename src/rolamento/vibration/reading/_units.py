"""What files and users call units: of samples, of what a recorder gives, and of speeds."""

from __future__ import annotations

import re
from math import pi
from typing import Any, Final

from rolamento.errors import InputError, nearest
from rolamento.vibration.reading._limits import LONGEST_UNIT
from rolamento.vibration.signal import Quantity, unit_scale

__all__ = [
    "RAW_UNITS",
    "SPEED_UNITS",
    "checked_speed_unit",
    "checked_unit",
    "is_raw",
    "is_unit",
    "plain_unit",
    "quantity_of_unit",
    "speed_unit_in",
    "spelled",
]

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
    return text.strip()[:LONGEST_UNIT]


def is_unit(unit: str) -> bool:
    """Tell whether text, as `plain_unit` returns it, is a unit that has a name here."""
    return unit in _NAMED


def is_raw(unit: str) -> bool:
    """Tell whether a unit is that of a recorder: of volts or counts."""
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
        raise InputError("must be text", field="unit", value=unit, example='unit="g"')
    plain = plain_unit(unit)
    allowed = (*_KNOWN, *RAW_UNITS)
    if plain not in allowed:
        raise InputError(
            f"is no unit of a signal; those that are: {', '.join(_KNOWN)}; "
            f"before calibration: {', '.join(RAW_UNITS)}",
            field="unit",
            value=unit,
            example=f'unit="{nearest(plain, allowed) or "g"}"',
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
    if plain not in SPEED_UNITS:
        raise InputError(
            f"must be one of {', '.join(SPEED_UNITS)}",
            field="speed_unit",
            value=unit,
            example='speed_unit="rpm"',
        )
    return plain
