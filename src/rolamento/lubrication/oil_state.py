"""What the film needs of a lubricant at its temperature."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case.lubricant import DEFAULT_CONDUCTIVITY, Lubricant
from rolamento.numerics import FloatArray
from rolamento.oil.density import (
    STANDARD_TEMPERATURE,
    density_by_expansion,
    density_of_lubricating_oil,
)
from rolamento.oil.pressure_viscosity import so_klaus, wooster
from rolamento.oil.viscosity import (
    ViscosityLine,
    astm_d341,
    astm_d341_line,
    dynamic_viscosity,
    viscosity_temperature_coefficient,
)


@dataclass(frozen=True, slots=True)
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
    cool, hot = lubricant.points
    return astm_d341_line(cool.temperature, cool.viscosity, hot.temperature, hot.viscosity)


def oil_density(lubricant: Lubricant, temperature: ArrayLike) -> FloatArray:
    """Density of an oil or a grease's base oil; kg/m³. Parameters: temperature, array; K."""
    oil = lubricant.oil
    assert oil.density is not None
    reference = oil.density_temperature
    reference = STANDARD_TEMPERATURE if reference is None else reference
    if oil.thermal_expansion is None:
        return density_of_lubricating_oil(temperature, oil.density, reference)
    return density_by_expansion(temperature, oil.density, reference, oil.thermal_expansion)


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
        thermal_conductivity=DEFAULT_CONDUCTIVITY if conductivity is None else conductivity,
    )
