"""An oil at its temperature, and the viscosity ratio κ: what it has over what the bearing needs."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray
from rolamento.oil import (
    STANDARD_TEMPERATURE,
    ViscosityLine,
    astm_d341,
    astm_d341_line,
    density_by_expansion,
    density_from_standard,
    dynamic_viscosity,
    so_klaus,
    standard_density,
    viscosity_temperature_coefficient,
    wooster,
)
from rolamento.records import frozen
from rolamento.validate import within

if TYPE_CHECKING:
    from rolamento.case.lubricant import Lubricant

_USUAL_CONDUCTIVITY: Final = 0.145
"""W/(m·K): usual of mineral oils, which are alike in this."""
_SLOW: Final = 1000.0 * (1.0 - 1e-9)
"""r/min below which the formula changes: 1000, and rounding of a speed in rad/s does not decide.
There ν_1 falls by 2.3 %; the formulas meet at 10^(100/33) = 1072 r/min."""


@frozen
class OilState:
    """An oil at a temperature; arrays of the temperature's shape, SI.

    Attributes
    ----------
    temperature
        (K)
    kinematic_viscosity
        ν (m²/s)
    density
        (kg/m³)
    dynamic_viscosity
        η at ambient pressure (Pa·s)
    pressure_viscosity
        α (1/Pa)
    viscosity_temperature
        -d ln ν/dT (1/K)
    thermal_conductivity
        (W/(m·K)), one number
    """

    temperature: FloatArray
    kinematic_viscosity: FloatArray
    density: FloatArray
    dynamic_viscosity: FloatArray
    pressure_viscosity: FloatArray
    viscosity_temperature: FloatArray
    thermal_conductivity: float

    def columns(self) -> OilState:
        """Return the same with fields (cases, 1), to stand beside arrays (cases, balls)."""
        return OilState(
            self.temperature[:, np.newaxis],
            self.kinematic_viscosity[:, np.newaxis],
            self.density[:, np.newaxis],
            self.dynamic_viscosity[:, np.newaxis],
            self.pressure_viscosity[:, np.newaxis],
            self.viscosity_temperature[:, np.newaxis],
            self.thermal_conductivity,
        )


def viscosity_line(lubricant: Lubricant) -> ViscosityLine:
    """Line of ASTM D341 through the two viscosities of an oil or of a grease's base oil."""
    return _line_of(lubricant.oil)


@lru_cache(maxsize=256)
def _line_of(oil: Lubricant) -> ViscosityLine:
    """Found once: an analysis asks for it a dozen times."""
    cool, hot = oil.points
    return astm_d341_line(cool.temperature, cool.viscosity, hot.temperature, hot.viscosity)


def oil_density(lubricant: Lubricant, temperature: ArrayLike) -> FloatArray:
    """Density of an oil or a grease's base oil; kg/m³. Parameters: temperature, array; K."""
    oil = lubricant.oil
    assert oil.density is not None
    reference = oil.density_temperature
    reference = STANDARD_TEMPERATURE if reference is None else reference
    if oil.thermal_expansion is None:
        return density_from_standard(temperature, _standard_density(oil.density, reference))
    return density_by_expansion(temperature, oil.density, reference, oil.thermal_expansion)


@lru_cache(maxsize=256)
def _standard_density(density: float, temperature: float) -> FloatArray:
    """Density at 15 °C of an oil by its density at another temperature; found once."""
    return standard_density(density, temperature)


def oil_state(lubricant: Lubricant, temperature: ArrayLike) -> OilState:
    """Return an oil, or a grease's base oil, at a temperature; K, any shape."""
    warm = np.asarray(temperature, dtype=np.float64)
    line = viscosity_line(lubricant)
    kinematic, density = astm_d341(warm, line), oil_density(lubricant, warm)
    dynamic = dynamic_viscosity(kinematic, density)
    oil = lubricant.oil
    if oil.pressure_viscosity is not None:
        alpha = np.full_like(warm, oil.pressure_viscosity)
    elif oil.pressure_viscosity_method == "so_klaus":
        alpha = so_klaus(kinematic, density, line.slope)
    else:
        alpha = wooster(dynamic)
    conductivity = oil.thermal_conductivity
    return OilState(
        temperature=warm,
        kinematic_viscosity=kinematic,
        density=density,
        dynamic_viscosity=dynamic,
        pressure_viscosity=alpha,
        viscosity_temperature=viscosity_temperature_coefficient(warm, line),
        thermal_conductivity=_USUAL_CONDUCTIVITY if conductivity is None else conductivity,
    )


def reference_viscosity(speed: ArrayLike, pitch_diameter: ArrayLike) -> FloatArray:
    """Kinematic viscosity ν_1 that is needed for adequate lubrication; m²/s.

    Parameters
    ----------
    speed : array, of the rings against each other; rad/s, its size counts.
    pitch_diameter : array that broadcasts with it; m.

    Returns
    -------
    ν_1 of the broadcast shape: 45000 n^-0.83 D^-0.5 below 1000 r/min, 4500 n^-0.5 D^-0.5 from there
    on, in mm²/s, r/min and mm; infinite at rest.

    ISO 281:2007, 9.3.3.
    """
    n = np.abs(within(speed, "speed", "rad/s", -1e9, 1e9)) * 30.0 / np.pi
    with np.errstate(divide="ignore"):
        slow, fast = 45000.0 * n**-0.83, 4500.0 * n**-0.5
    root = np.sqrt(within(pitch_diameter, "pitch_diameter", "m", 1e-9, 1e3) * 1e3)
    return np.asarray(np.where(n < _SLOW, slow, fast) / root * 1e-6)


def viscosity_ratio(
    viscosity: ArrayLike, speed: ArrayLike, pitch_diameter: ArrayLike
) -> FloatArray:
    """Ratio κ = ν/ν_1 of kinematic viscosities; 0 at rest.

    Parameters: arrays that broadcast; m²/s, rad/s, m. Returns the broadcast shape.
    ISO 281:2007, 9.3.3.
    """
    nu = within(viscosity, "viscosity", "m²/s", 0.0, 1e6)
    return np.asarray(nu / reference_viscosity(speed, pitch_diameter))
