"""The oil itself: viscosity over temperature and pressure, viscosity index, density.

Inside: `properties` (a formula a function), `state` (a lubricant at its temperature, the viscosity
ratio).
"""

from rolamento.oil.properties import (
    MINIMUM_VISCOSITY,
    STANDARD_TEMPERATURE,
    ViscosityLine,
    astm_d341,
    astm_d341_line,
    barus,
    density_by_expansion,
    density_from_standard,
    density_of_lubricating_oil,
    dynamic_viscosity,
    reference_viscosities,
    roelands,
    so_klaus,
    standard_density,
    viscosity_100_of_index,
    viscosity_index,
    viscosity_temperature_coefficient,
    wooster,
)

__all__ = [
    "MINIMUM_VISCOSITY",
    "STANDARD_TEMPERATURE",
    "ViscosityLine",
    "astm_d341",
    "astm_d341_line",
    "barus",
    "density_by_expansion",
    "density_from_standard",
    "density_of_lubricating_oil",
    "dynamic_viscosity",
    "reference_viscosities",
    "roelands",
    "so_klaus",
    "standard_density",
    "viscosity_100_of_index",
    "viscosity_index",
    "viscosity_temperature_coefficient",
    "wooster",
]
