"""Density of an oil over temperature."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

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
    warming = np.subtract(temperature, reference_temperature, dtype=np.float64)
    return np.asarray(
        np.asarray(reference_density) * np.exp(-np.asarray(thermal_expansion) * warming)
    )


def density_of_lubricating_oil(
    temperature: ArrayLike, reference_density: ArrayLike, reference_temperature: ArrayLike
) -> FloatArray:
    """Density of a mineral lubricating oil from one at another temperature; kg/m³.

    Parameters: arrays that broadcast; K, kg/m³, K. Returns the broadcast shape.

    API MPMS 11.1 (1980), table 54D: ρ = ρ_15 exp(-a ΔT (1 + 0.8 a ΔT)), a = 0.6278/ρ_15, ΔT from
    15 °C. ρ_15 follows from the given density by iteration.
    """
    known = np.asarray(reference_density, dtype=np.float64)
    standard = known
    for _ in range(_STEPS):
        standard = known / _correction(reference_temperature, standard)
    return np.asarray(standard * _correction(temperature, standard))


def _correction(temperature: ArrayLike, standard_density: FloatArray) -> FloatArray:
    warming = np.asarray(temperature, dtype=np.float64) - STANDARD_TEMPERATURE
    grown = _LUBRICATING_OILS / standard_density * warming
    return np.asarray(np.exp(-grown * (1.0 + 0.8 * grown)))
