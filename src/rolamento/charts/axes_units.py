"""The units on axes: from SI to what a person reads, in one place."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento import units
from rolamento.errors import InputError
from rolamento.units import typed
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.case.fields import Field

__all__ = [
    "ANGLES",
    "CELSIUS",
    "DEGREE",
    "MEGAPASCAL",
    "MILLIMETRE",
    "NONE",
    "PERCENT",
    "RPM",
    "ReadableUnit",
    "read_values",
    "readable_unit",
]

ANGLES: Final = ("contact_angle", "azimuth", "attitude", "shim_angle", "phase")
"""Ends of the names of what is always read in degrees."""
_LONGEST_SYMBOL: Final = 24


class ReadableUnit(NamedTuple):
    """A unit that stands on an axis; a value in it is factor times the value in SI."""

    symbol: str
    factor: float

    def of(self, values: ArrayLike) -> NDArray[np.float64]:
        """Return values given in SI in this unit."""
        converted: NDArray[np.float64] = np.asarray(values, dtype=np.float64) * self.factor
        return converted

    def label(self, name: str) -> str:
        """Return the label of an axis."""
        return f"{name} ({self.symbol})"


DEGREE: Final = ReadableUnit("°", units.DEGREES)
MILLIMETRE: Final = ReadableUnit("mm", 1e3)
MEGAPASCAL: Final = ReadableUnit("MPa", 1e-6)
RPM: Final = ReadableUnit("rpm", units.rpm_of(1.0))
PERCENT: Final = ReadableUnit("%", 1e2)
NONE: Final = ReadableUnit("–", 1.0)
CELSIUS: Final = ReadableUnit("°C", 1.0)
"""For values that count from 0 °C already."""

_READABLE: Final[Mapping[str, tuple[tuple[float, ReadableUnit], ...]]] = {
    "": ((0.0, NONE),),
    "1": ((0.0, NONE),),
    "Mrev": ((0.0, ReadableUnit("10⁶ rev", 1.0)),),
    "m": ((0.0, ReadableUnit("µm", 1e6)), (1e-3, MILLIMETRE)),
    "rad": ((0.0, ReadableUnit("mrad", 1e3)), (0.5 / units.DEGREES, DEGREE)),
    "rad/s": ((0.0, RPM),),
    "N": ((0.0, ReadableUnit("N", 1.0)), (1e4, ReadableUnit("kN", 1e-3))),
    "N*m": (
        (0.0, ReadableUnit("N·mm", 1e3)),
        (0.1, ReadableUnit("N·m", 1.0)),
        (1e4, ReadableUnit("kN·m", 1e-3)),
    ),
    "Pa": ((0.0, MEGAPASCAL), (1e10, ReadableUnit("GPa", 1e-9))),
    "F": ((0.0, ReadableUnit("pF", 1e12)),),
    "A/m^2": ((0.0, ReadableUnit("A/mm²", 1e-6)),),
    "V/m": ((0.0, ReadableUnit("V/µm", 1e-6)),),
    "m^3/s": ((0.0, ReadableUnit("l/min", 60e3)),),
    "N/m": ((0.0, ReadableUnit("N/µm", 1e-6)),),
    "N/rad": ((0.0, ReadableUnit("N/mrad", 1e-3)),),
    "N*m/m": ((0.0, ReadableUnit("N·m/mm", 1e-3)),),
    "N*m/rad": ((0.0, ReadableUnit("N·m/mrad", 1e-3)),),
}
"""For every SI unit, what is read from which magnitude on."""

_RAISED: Final = {"^-1": "⁻¹", "^2": "²", "^3": "³", "^4": "⁴"}


def readable_unit(unit: str, values: ArrayLike, name: str = "") -> ReadableUnit:
    """Return the unit in which a person reads values of one axis.

    Parameters
    ----------
    unit
        In SI, such as ``"N"``, ``"N*m"``, ``"rad/s"``, ``"kg/m^3"``; ``"1"`` for none.
    values
        In that unit; the greatest magnitude decides between N and kN, and the like.
    name
        Of the quantity: contact angles, however small, are read in degrees, tilts in mrad.

    Returns
    -------
    ReadableUnit
        The unit as it is, prettily written, if nothing better is known.
    """
    plain = unit.strip().replace("**", "^").replace("·", "*").replace(" ", "*")
    choices = _READABLE.get(plain)
    if choices is None:
        return ReadableUnit(_with_raised_powers(plain), 1.0)
    if plain == "rad" and name.endswith(ANGLES):
        return DEGREE
    magnitudes = np.abs(np.asarray(values, dtype=np.float64))
    greatest = float(np.max(magnitudes, initial=0.0, where=np.isfinite(magnitudes)))
    return [readable for least, readable in choices if least <= greatest][-1]


def si_value(text: str, unit: str, field: str, example: str) -> float:
    """Read a number with a unit in which a quantity is shown, or in its SI unit.

    Parameters
    ----------
    text
        Such as ``"200 N/um"``; a number alone of a quantity without a unit.
    unit
        In SI; lives have ``"h"`` or ``"Mrev"``.
    field, example
        For the message.

    Raises
    ------
    InputError
        If it is no number, or has another unit.

    >>> si_value("200 N/um", "N/m", "wanted", "")
    200000000.0
    """
    from rolamento.studies.ranges import number_and_unit

    read = number_and_unit(typed(text))
    if read is None:
        rule = said("must be a number with its unit")
        raise InputError(rule, field=field, value=text, example=example)
    value, written = read
    shown = [one for _, one in _READABLE.get(unit, ())]
    known = {_folded(one.symbol): one.factor for one in shown} | {_folded(unit): 1.0}
    if unit in ("", "1"):
        known[""] = 1.0
    if _folded(written) in known:
        return value / known[_folded(written)]
    for dimension, name in units.SI_UNIT.items():
        if _folded(name) == _folded(unit):
            try:
                return units.to_si(text, dimension)
            except InputError as error:
                raise error.with_details(field=field) from None
    names = ", ".join(dict.fromkeys([*(one.symbol for one in shown), unit]))
    rule = said("must be in {names}", names=names)
    raise InputError(rule, field=field, value=text, example=example)


def _folded(symbol: str) -> str:
    """Return a unit without what may be written in several ways."""
    for sign, plain in (("µ", "u"), ("μ", "u"), ("·", "*"), (" ", ""), ("°", "deg"), ("⁶", "^6")):
        symbol = symbol.replace(sign, plain)
    return symbol.replace("–", "")


def read_values(field: Field, values: NDArray[np.float64]) -> tuple[NDArray[np.float64], str]:
    """Return values of a field of a case as a person reads them, and their unit."""
    if field.dimension == "temperature":
        return np.round(values - units.ZERO_CELSIUS, 9), CELSIUS.symbol
    unit = readable_unit(field.unit, values, field.name)
    return unit.of(values), unit.symbol


def _with_raised_powers(unit: str) -> str:
    for power, raised in _RAISED.items():
        unit = unit.replace(power, raised)
    return unit.replace("*", "·")[:_LONGEST_SYMBOL]
