"""Tallian's form of the life equation: a product of factors, for each origin of failure.

    -ln S = φ0 φ1 φ2 φ3 φ4 N^s,   s = ψ μ/ζ

φ0 is the strength of the material, φ1 the shape of the defect and the elasticity, φ2 the density
of defects, φ3 the distribution of the failure rate, φ4 that of the pressure round the race.
Failures from below the surface and from the surface have factors of their own, and their risks
add up. The constants were never published: every factor is the user's. With φ0 = A, φ1 = φ2 = 1
and φ3 φ4 = ∫ a z_0 τ_0^c/z_0^h dl the form is that of Lundberg and Palmgren.

Source: Tallian (1971) and Chiu, Tallian and McCool (1971), as in Campanha (2008), eq. 2.6.3 and
table 2.6.1.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from rolamento.life._figures import positive, within
from rolamento.life.ioannides_harris import DEPTH_EXPONENT, STRESS_EXPONENT
from rolamento.life.reference import SLOPE
from rolamento.life.reliability import RATING_RELIABILITY
from rolamento.numerics import FloatArray


@dataclass(frozen=True, slots=True)
class TallianFactors:
    """φ0 … φ4 of one origin of failure, and the exponent s of the stress cycles; all above 0."""

    strength: float
    defect_shape: float
    defect_density: float
    failure_rate: float
    pressure_distribution: float
    exponent: float

    @property
    def product(self) -> float:
        """φ0 φ1 φ2 φ3 φ4.

        Raises
        ------
        InputError
            If a factor is not above zero.
        """
        factors = (
            "strength",
            "defect_shape",
            "defect_density",
            "failure_rate",
            "pressure_distribution",
        )
        return float(np.prod([positive(getattr(self, name), name) for name in factors]))


def risk(factors: TallianFactors, cycles: ArrayLike) -> FloatArray:
    """-ln S after N stress cycles. Parameters: the factors, and an array of N ≥ 0."""
    exponent = float(positive(factors.exponent, "exponent"))
    return np.asarray(factors.product * positive(cycles, "cycles", zero=True) ** exponent)


def survival(factors: tuple[TallianFactors, ...], cycles: ArrayLike) -> FloatArray:
    """Reliability S after N stress cycles, of all origins together: exp(-Σ risk)."""
    total = np.sum([risk(origin, cycles) for origin in factors], axis=0)
    return np.asarray(np.exp(-total))


def tallian_life(
    factors: TallianFactors, reliability: ArrayLike = RATING_RELIABILITY
) -> FloatArray:
    """Stress cycles that a share S of the contacts survives, by one origin of failure.

    Parameters
    ----------
    factors : of the origin.
    reliability : array, S.
    """
    s = within(reliability, "reliability", 0.01, 0.999999, "reliability = 0.9")
    exponent = float(positive(factors.exponent, "exponent"))
    return np.asarray((-np.log(s) / factors.product) ** (1.0 / exponent))


def lundberg_palmgren_factors(
    material_constant: float,
    semi_major: float,
    shear: float,
    shear_depth: float,
    race_length: float,
) -> TallianFactors:
    """Factors with which Tallian's form is that of Lundberg and Palmgren, for one uniform load.

    Parameters
    ----------
    material_constant : A.
    semi_major : a of the contact; m.
    shear, shear_depth : τ_0 (Pa) and z_0 (m).
    race_length : circumference of the race; m.

    Campanha (2008), table 2.6.1: φ3 φ4 = a z_0 τ_0^c z_0^-h l.
    """
    tau, depth = float(positive(shear, "shear")), float(positive(shear_depth, "shear_depth"))
    return TallianFactors(
        strength=material_constant,
        defect_shape=1.0,
        defect_density=1.0,
        failure_rate=semi_major * tau**STRESS_EXPONENT * depth ** (1.0 - DEPTH_EXPONENT),
        pressure_distribution=race_length,
        exponent=SLOPE,
    )
