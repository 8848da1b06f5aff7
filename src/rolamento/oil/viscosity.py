"""Viscosity of an oil over temperature: the straight line of ASTM D341.

    log10 log10(ν + 0.7) = A - B log10 T          ν in mm²/s, T in K

holds for petroleum oils and hydrocarbons from about 2 mm²/s up; below, the standard adds terms
that are left out here.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento._reach import in_reach
from rolamento.errors import InputError
from rolamento.numerics import FloatArray

LEAST_VISCOSITY: Final = 2e-6
"""m²/s; below it the line needs the terms that are left out."""
_SHIFT: Final = 0.7
_MM2: Final = 1e6
"""mm²/s in a m²/s."""


@dataclass(frozen=True, slots=True)
class ViscosityLine:
    """The line of an oil: intercept A and slope B; numbers or arrays, of mm²/s and K."""

    intercept: FloatArray
    slope: FloatArray


def astm_d341_line(
    first_temperature: ArrayLike,
    first_viscosity: ArrayLike,
    second_temperature: ArrayLike,
    second_viscosity: ArrayLike,
) -> ViscosityLine:
    """The line through two kinematic viscosities.

    Parameters
    ----------
    first_temperature, second_temperature : arrays that broadcast, different; K.
    first_viscosity, second_viscosity : arrays, more than 0.3 mm²/s; m²/s.

    Returns
    -------
    ViscosityLine of the broadcast shape.

    Raises
    ------
    InputError
        If the temperatures are alike, or a number is out of range.

    ASTM D341; Ubbelohde (1935), Walther (1931).
    """
    one = _ordinate(first_viscosity, "first_viscosity")
    other = _ordinate(second_viscosity, "second_viscosity")
    abscissa = np.log10(_kelvin(first_temperature, "first_temperature"))
    further = np.log10(_kelvin(second_temperature, "second_temperature"))
    if np.any(abscissa == further):
        raise InputError("must differ from the first", field="second_temperature")
    slope = (one - other) / (further - abscissa)
    return ViscosityLine(np.asarray(one + slope * abscissa), np.asarray(slope))


def astm_d341(temperature: ArrayLike, line: ViscosityLine) -> FloatArray:
    """Kinematic viscosity on the line of an oil; m²/s.

    Parameters: temperature, array; K. Returns the broadcast shape. ASTM D341.
    """
    return (_shifted(temperature, line) - _SHIFT) / _MM2


def viscosity_temperature_coefficient(temperature: ArrayLike, line: ViscosityLine) -> FloatArray:
    """Relative fall of the kinematic viscosity with temperature, -d ln ν/dT; 1/K.

    Parameters: temperature, array; K. Returns the broadcast shape. Derivative of ASTM D341.
    """
    z = _shifted(temperature, line)
    return np.asarray(z / (z - _SHIFT) * np.log(z) * line.slope / np.asarray(temperature))


def dynamic_viscosity(kinematic_viscosity: ArrayLike, density: ArrayLike) -> FloatArray:
    """Dynamic viscosity η = ρ ν; Pa·s. Parameters: arrays that broadcast; m²/s, kg/m³."""
    nu = in_reach(kinematic_viscosity, "kinematic_viscosity", "m²/s", 0.0, 1e6)
    return np.asarray(nu * in_reach(density, "density", "kg/m^3", 0.0, 1e6))


def _kelvin(temperature: ArrayLike, field: str) -> FloatArray:
    return in_reach(temperature, field, "K", 1.0, 1e4)


def _ordinate(viscosity: ArrayLike, field: str) -> FloatArray:
    least = (1.0 - _SHIFT) / _MM2
    z = in_reach(viscosity, field, "m²/s", least, 1e6, least_too=False) * _MM2 + _SHIFT
    return np.asarray(np.log10(np.log10(z)))


def _shifted(temperature: ArrayLike, line: ViscosityLine) -> FloatArray:
    """ν + 0.7, in mm²/s."""
    with np.errstate(over="ignore"):
        exponent = line.intercept - line.slope * np.log10(_kelvin(temperature, "temperature"))
        return np.asarray(10.0 ** (10.0**exponent))
