"""The oil itself: viscosity over temperature and pressure, viscosity index, density.

A model a function, of numbers or arrays in SI units; nothing here knows a bearing.

Viscosity over temperature is the straight line of ASTM D341,

    log10 log10(ν + 0.7) = A - B log10 T          ν in mm²/s, T in K

which holds for petroleum oils and hydrocarbons from about 2 mm²/s up; below, the standard adds
terms that are left out here. Both laws of viscosity under pressure leave the viscosity without
pressure as it is and rise from there with the slope α. Where nobody has measured α there are two
correlations of mineral oils; neither is meant for other fluids: give the measured value.
"""

from __future__ import annotations

from functools import lru_cache
from math import inf, log10
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import within
from rolamento.words import said

MINIMUM_VISCOSITY: Final = 2e-6
"""m²/s; below it the line needs the terms that are left out, and there is no viscosity index."""
_ASTM_SHIFT: Final = 0.7
_MM2: Final = 1e6
"""mm²/s in a m²/s."""


@frozen
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
    one = _height_on_chart(first_viscosity, "first_viscosity")
    other = _height_on_chart(second_viscosity, "second_viscosity")
    abscissa = np.log10(_temperature(first_temperature, "first_temperature"))
    further = np.log10(_temperature(second_temperature, "second_temperature"))
    if np.any(abscissa == further):
        raise InputError(said("must differ from the first"), field="second_temperature")
    slope = (one - other) / (further - abscissa)
    return ViscosityLine(np.asarray(one + slope * abscissa), np.asarray(slope))


def astm_d341(temperature: ArrayLike, line: ViscosityLine) -> FloatArray:
    """Kinematic viscosity on the line of an oil; m²/s.

    Parameters: temperature, array; K. Returns the broadcast shape. ASTM D341.
    """
    return (_shifted_viscosity(temperature, line) - _ASTM_SHIFT) / _MM2


def viscosity_temperature_coefficient(temperature: ArrayLike, line: ViscosityLine) -> FloatArray:
    """Relative fall of the kinematic viscosity with temperature, -d ln ν/dT; 1/K.

    Parameters: temperature, array; K. Returns the broadcast shape. Derivative of ASTM D341.
    """
    z = _shifted_viscosity(temperature, line)
    return np.asarray(z / (z - _ASTM_SHIFT) * np.log(z) * line.slope / np.asarray(temperature))


def dynamic_viscosity(kinematic_viscosity: ArrayLike, density: ArrayLike) -> FloatArray:
    """Dynamic viscosity η = ρ ν; Pa·s. Parameters: arrays that broadcast; m²/s, kg/m³.

    >>> print(f"{1e3 * dynamic_viscosity(1e-5, 850.0):.1f} mPa s")
    8.5 mPa s
    """
    nu = within(kinematic_viscosity, "kinematic_viscosity", "m²/s", 0.0, 1e6)
    return np.asarray(nu * within(density, "density", "kg/m^3", 0.0, 1e6))


def _height_on_chart(viscosity: ArrayLike, field: str) -> FloatArray:
    minimum = (1.0 - _ASTM_SHIFT) / _MM2
    z = within(viscosity, field, "m²/s", minimum, 1e6, least_too=False) * _MM2 + _ASTM_SHIFT
    return np.asarray(np.log10(np.log10(z)))


def _shifted_viscosity(temperature: ArrayLike, line: ViscosityLine) -> FloatArray:
    """ν + 0.7, in mm²/s."""
    with np.errstate(over="ignore"):
        exponent = line.intercept - line.slope * np.log10(_temperature(temperature, "temperature"))
        return np.asarray(10.0 ** (10.0**exponent))


# --- viscosity index: how little an oil thins between 40 and 100 °C; plain numbers -----------


# From Y mm²/s at 100 °C on: a, b, c of L = a Y² + b Y + c, and d, e, f of H likewise.
_INDEX_COEFFICIENTS: Final = (
    (2.0, 1.14673, 1.7576, -0.109, 0.84155, 1.5521, -0.077),
    (3.8, 3.38095, -15.4952, 33.196, 0.78571, 1.7929, -0.183),
    (4.4, 2.5, -7.2143, 13.812, 0.82143, 1.5679, 0.119),
    (5.0, 0.101, 16.635, -45.469, 0.04985, 9.1613, -18.557),
    (6.4, 3.35714, -23.5643, 78.466, 0.22619, 7.7369, -16.656),
    (7.0, 0.01191, 21.475, -72.870, 0.79762, -0.7321, 14.61),
    (7.7, 0.41858, 16.1558, -56.040, 0.05794, 10.5156, -28.240),
    (9.0, 0.88779, 7.5527, -16.600, 0.26665, 6.7015, -10.810),
    (12.0, 0.7672, 10.7972, -38.180, 0.20073, 8.4658, -22.490),
    (15.0, 0.97305, 5.3135, -2.200, 0.28889, 5.9741, -4.930),
    (18.0, 0.97256, 5.25, -0.980, 0.24504, 7.416, -16.730),
    (22.0, 0.91413, 7.4759, -21.820, 0.20323, 9.1267, -34.230),
    (28.0, 0.87031, 9.7157, -50.770, 0.18411, 10.1015, -46.750),
    (40.0, 0.84703, 12.6752, -133.310, 0.17029, 11.4866, -80.620),
    (55.0, 0.85921, 11.1009, -83.19, 0.1713, 11.368, -76.940),
    (70.0, 0.83531, 14.6731, -216.246, 0.16841, 11.8493, -96.947),
)
_HALVINGS: Final = 80


def viscosity_index(viscosity_40: float, viscosity_100: float) -> float:
    """Viscosity index from the kinematic viscosities at 40 and 100 °C, m²/s; not rounded.

    NaN below 2 mm²/s at 100 °C. ISO 2909, ASTM D2270, with the polynomials that the latter gives
    for its table: good to about a unit of the index.

    >>> print(f"{viscosity_index(68e-6, 8.7e-6):.0f}")
    99
    """
    u = float(within(viscosity_40, "viscosity_40", "m²/s", 1e-9, 1.0)) * _MM2
    y = float(within(viscosity_100, "viscosity_100", "m²/s", 1e-9, 1.0)) * _MM2
    return _index(u, y) if y >= MINIMUM_VISCOSITY * _MM2 else float("nan")


def _index(u: float, y: float) -> float:
    """The viscosity index of ν at 40 and at 100 °C; mm²/s."""
    low, high = _references(y)
    if u >= high:
        return 100.0 * (low - u) / (low - high)
    exponent = log10(high / u) / log10(y)
    return float((10.0**exponent - 1.0) / 0.00715 + 100.0)


def reference_viscosities(viscosity_100: float) -> tuple[float, float]:
    """L and H: at 40 °C, of oils of index 0 and 100 that have this viscosity at 100 °C; mm²/s.

    ASTM D2270, appendix X2.
    """
    return _references(
        float(within(viscosity_100, "viscosity_100", "mm²/s", MINIMUM_VISCOSITY * _MM2, 1e6))
    )


def _references(y: float) -> tuple[float, float]:
    a, b, c, d, e, f = next(line[1:] for line in reversed(_INDEX_COEFFICIENTS) if y >= line[0])
    return (a * y + b) * y + c, (d * y + e) * y + f


# every record of an oil asks for it, and a case makes it anew several times
@lru_cache(maxsize=256)
def viscosity_100_of_index(viscosity_40: float, index: float) -> float:
    """Kinematic viscosity at 100 °C of an oil given at 40 °C by its viscosity index; m²/s.

    NaN where it would be below 2 mm²/s. The inverse of `viscosity_index`, by bisection: the index
    rises with the viscosity at 100 °C.
    """
    minimum, maximum = MINIMUM_VISCOSITY, viscosity_40
    if not viscosity_index(viscosity_40, minimum) <= index < inf or maximum <= minimum:
        return float("nan")
    for _ in range(_HALVINGS):
        middle = 0.5 * (minimum + maximum)
        if _index(viscosity_40 * _MM2, middle * _MM2) < index:
            minimum = middle
        else:
            maximum = middle
    return 0.5 * (minimum + maximum)


# --- viscosity under pressure ----------------------------------------------------------------

_POLE_PRESSURE: Final = 1.0 / 5.1e-9
"""Pa: minus this is where all oils of Roelands meet …"""
_POLE_VISCOSITY: Final = 9.67
"""… in the viscosity e^-9.67 Pa·s = 6.3e-5 Pa·s."""


def barus(
    pressure: ArrayLike, viscosity: ArrayLike, pressure_viscosity_coefficient: ArrayLike
) -> FloatArray:
    """Dynamic viscosity η e^(α p); Pa·s.

    Parameters: arrays that broadcast; Pa, Pa·s at ambient pressure, 1/Pa. Returns the broadcast
    shape, infinite where it passes all numbers. Useless above about 0.5 GPa. Barus (1893);
    Campanha (2008) eq. 2.4.4.

    >>> print(f"{barus(1e8, 0.01, 2e-8) / 0.01:.3f}")
    7.389
    """
    p, eta, alpha = _checked_arguments(pressure, viscosity, pressure_viscosity_coefficient, 0.0)
    with np.errstate(over="ignore"):
        return np.asarray(eta * np.exp(alpha * p))


def roelands(
    pressure: ArrayLike, viscosity: ArrayLike, pressure_viscosity_coefficient: ArrayLike
) -> FloatArray:
    """Dynamic viscosity by Roelands's law; Pa·s.

    Parameters: arrays that broadcast; Pa, Pa·s at ambient pressure, 1/Pa. Returns the broadcast
    shape. Roelands (1966): ln η_p = ln η + (ln η + 9.67) [(1 + 5.1e-9 p)^Z - 1], with the Z that
    gives the slope α: Z = α / (5.1e-9 (ln η + 9.67)). For η above the pole, 6.3e-5 Pa·s.

    >>> print(f"{roelands(1e8, 0.01, 2e-8) / 0.01:.2f}")
    6.71
    """
    pole = float(np.exp(-_POLE_VISCOSITY))
    p, eta, alpha = _checked_arguments(pressure, viscosity, pressure_viscosity_coefficient, pole)
    height = np.log(eta) + _POLE_VISCOSITY
    with np.errstate(over="ignore"):
        growth = (1.0 + p / _POLE_PRESSURE) ** (alpha * _POLE_PRESSURE / height) - 1.0
        return np.asarray(eta * np.exp(height * growth))


def _checked_arguments(
    pressure: ArrayLike, viscosity: ArrayLike, coefficient: ArrayLike, thinnest: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    return (
        within(pressure, "pressure", "Pa", 0.0, 1e12),
        within(viscosity, "viscosity", "Pa·s", thinnest, 1e9, least_too=False),
        within(coefficient, "pressure_viscosity_coefficient", "1/Pa", 0.0, 1e-3),
    )


# --- pressure-viscosity coefficient ----------------------------------------------------------


def wooster(dynamic_viscosity: ArrayLike) -> FloatArray:
    """Coefficient α = (0.6 + 0.965 log10 η) 10⁻⁸, η in mPa·s; 1/Pa.

    Parameters: dynamic viscosity at the temperature in question, array; Pa·s. Returns its shape.
    Wooster, in Hutchings (1992); Campanha (2008) eq. 4.4.1.

    >>> print(f"{1e9 * wooster(0.01):.1f} 1/GPa")
    15.7 1/GPa
    """
    eta = within(dynamic_viscosity, "dynamic_viscosity", "Pa·s", 1e-9, 1e9)
    return np.asarray((0.6 + 0.965 * np.log10(eta * 1e3)) * 1e-8)


def so_klaus(kinematic_viscosity: ArrayLike, density: ArrayLike, slope: ArrayLike) -> FloatArray:
    """Coefficient α from viscosity, density and the steepness of viscosity over temperature; 1/Pa.

    Parameters
    ----------
    kinematic_viscosity, density : arrays, at the temperature in question; m²/s, kg/m³.
    slope : array, of the oil's line by ASTM D341.
        All broadcast against each other.

    Returns
    -------
    α of the broadcast shape, NaN below 1 mm²/s.

    So and Klaus (1980): with s = log10 ν in mm²/s, ρ in g/cm³, α in 10⁻⁸/Pa,
    1.216 + 4.143 s^3.0627 + 2.848e-4 B^5.1903 s^1.5976 - 3.999 s^3.0975 ρ^0.1162.
    """
    s = np.log10(within(kinematic_viscosity, "kinematic_viscosity", "m²/s", 1e-12, 1e6) * 1e6)
    s = np.where(s >= 0.0, s, np.nan)
    rho = within(density, "density", "kg/m^3", 0.0, 1e6) * 1e-3
    steep = within(slope, "slope", "", 0.0, 1e6)
    return np.asarray(
        1e-8
        * (
            1.216
            + 4.143 * s**3.0627
            + 2.848e-4 * steep**5.1903 * s**1.5976
            - 3.999 * s**3.0975 * rho**0.1162
        )
    )


# --- density ---------------------------------------------------------------------------------

STANDARD_TEMPERATURE: Final = 288.15
"""K: 15 °C, at which oils are measured."""
_LUBRICATING_OILS: Final = 0.6278
"""kg/(m³·K): expansion at 15 °C times density there."""
_DENSITY_STEPS: Final = 20


def density_by_expansion(
    temperature: ArrayLike,
    reference_density: ArrayLike,
    reference_temperature: ArrayLike,
    thermal_expansion: ArrayLike,
) -> FloatArray:
    """Density of an oil whose coefficient of thermal expansion is known; kg/m³.

    Parameters: arrays that broadcast; K, kg/m³, K, 1/K. Returns the broadcast shape, the density
    ρ exp(-a ΔT), positive at any temperature. Definition of the coefficient, held constant.

    >>> print(f"{density_by_expansion(388.15, 880.0, 288.15, 7e-4):.1f} kg/m^3")
    820.5 kg/m^3
    """
    warming = _liquid_temperature(temperature, "temperature") - _liquid_temperature(
        reference_temperature, "reference_temperature"
    )
    density = within(reference_density, "reference_density", "kg/m^3", 0.0, 1e6)
    expansion = within(thermal_expansion, "thermal_expansion", "1/K", -0.05, 0.05)
    return np.asarray(density * np.exp(-expansion * warming))


def density_of_lubricating_oil(
    temperature: ArrayLike, reference_density: ArrayLike, reference_temperature: ArrayLike
) -> FloatArray:
    """Density of a mineral lubricating oil from one at another temperature; kg/m³.

    Parameters: arrays that broadcast; K, kg/m³, K. Returns the broadcast shape.

    API MPMS 11.1 (1980), table 54D: ρ = ρ_15 exp(-a ΔT (1 + 0.8 a ΔT)), a = 0.6278/ρ_15, ΔT from
    15 °C. ρ_15 follows from the given density by iteration.
    """
    warm = _liquid_temperature(temperature, "temperature")
    return density_from_standard(warm, standard_density(reference_density, reference_temperature))


def standard_density(reference_density: ArrayLike, reference_temperature: ArrayLike) -> FloatArray:
    """Density ρ_15 of a mineral lubricating oil at 15 °C from one at another temperature; kg/m³.

    Parameters: arrays that broadcast; kg/m³, K. Returns the broadcast shape, found by iteration.
    API MPMS 11.1 (1980), table 54D.
    """
    known = within(reference_density, "reference_density", "kg/m^3", 100.0, 1e6)
    reference = _liquid_temperature(reference_temperature, "reference_temperature")
    standard = known
    for _ in range(_DENSITY_STEPS):
        standard = known / _thermal_correction(reference, standard)
    return standard


def density_from_standard(temperature: ArrayLike, standard: ArrayLike) -> FloatArray:
    """Density of a mineral lubricating oil from ρ_15; kg/m³.

    Parameters: arrays that broadcast; K, kg/m³. Returns the broadcast shape, by table 54D of
    API MPMS 11.1 (1980).
    """
    warm, known = _liquid_temperature(temperature, "temperature"), np.asarray(standard)
    return np.asarray(known * _thermal_correction(warm, known))


def _thermal_correction(temperature: FloatArray, standard_density: FloatArray) -> FloatArray:
    warming = temperature - STANDARD_TEMPERATURE
    grown = _LUBRICATING_OILS / standard_density * warming
    return np.asarray(np.exp(-grown * (1.0 + 0.8 * grown)))


def _temperature(temperature: ArrayLike, field: str) -> FloatArray:
    return within(temperature, field, "K", 1.0, 1e4)


def _liquid_temperature(temperature: ArrayLike, field: str) -> FloatArray:
    return within(temperature, field, "K", 1.0, 2000.0)
