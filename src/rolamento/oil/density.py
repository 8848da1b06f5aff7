"""Density of an oil over temperature."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento._reach import in_reach
from rolamento.numerics import FloatArray

STANDARD_TEMPERATURE: Final = 288.15
"""K: 15 °C, at which oils are measured."""
_LUBRICATING_OILS: Final = 0.6278
"""kg/(m³·K): expansion at 15 °C times density there."""
_STEPS: Final = 20


def density_by_expansion(
    temperature: ArrayLike,
    reference_density: ArrayLike,
    reference_temperature: ArrayLike,
    thermal_expansion: ArrayLike,
) -> FloatArray:
    """Density of an oil whose coefficient of thermal expansion is known; kg/m³.

    Parameters: arrays that broadcast; K, kg/m³, K, 1/K. Returns the broadcast shape, the density
    ρ exp(-a ΔT), positive at any temperature. Definition of the coefficient, held constant.
    """
    warming = _kelvin(temperature, "temperature") - _kelvin(
        reference_temperature, "reference_temperature"
    )
    density = in_reach(reference_density, "reference_density", "kg/m^3", 0.0, 1e6)
    expansion = in_reach(thermal_expansion, "thermal_expansion", "1/K", -0.05, 0.05)
    return np.asarray(density * np.exp(-expansion * warming))


def density_of_lubricating_oil(
    temperature: ArrayLike, reference_density: ArrayLike, reference_temperature: ArrayLike
) -> FloatArray:
    """Density of a mineral lubricating oil from one at another temperature; kg/m³.

    Parameters: arrays that broadcast; K, kg/m³, K. Returns the broadcast shape.

    API MPMS 11.1 (1980), table 54D: ρ = ρ_15 exp(-a ΔT (1 + 0.8 a ΔT)), a = 0.6278/ρ_15, ΔT from
    15 °C. ρ_15 follows from the given density by iteration.
    """
    known = in_reach(reference_density, "reference_density", "kg/m^3", 100.0, 1e6)
    warm = _kelvin(temperature, "temperature")
    reference = _kelvin(reference_temperature, "reference_temperature")
    standard = known
    for _ in range(_STEPS):
        standard = known / _correction(reference, standard)
    return np.asarray(standard * _correction(warm, standard))


def _kelvin(temperature: ArrayLike, field: str) -> FloatArray:
    """Of a liquid; K."""
    return in_reach(temperature, field, "K", 1.0, 2000.0)


def _correction(temperature: FloatArray, standard_density: FloatArray) -> FloatArray:
    warming = temperature - STANDARD_TEMPERATURE
    grown = _LUBRICATING_OILS / standard_density * warming
    return np.asarray(np.exp(-grown * (1.0 + 0.8 * grown)))
