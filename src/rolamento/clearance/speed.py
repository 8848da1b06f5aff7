"""Growth of a ring by its own rotation: a spinning annulus, plane stress.

A part of bore 2a and outside diameter 2b moves outward at radius r by

    u = ρ ω² r / (8 E) · { (1 - ν)(3 + ν)(a² + b²) + (1 + ν)(3 + ν) a² b²/r² - (1 - ν²) r² };

a = 0 is a solid shaft. A fit that both parts leave with different growth loses the difference of
its interference.

Source: Timoshenko and Goodier, Theory of Elasticity, 3rd ed. (1970), section 32.
"""

from __future__ import annotations

from typing import Final, Protocol

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray

__all__ = ["SPEED_SOURCE", "SpinningMaterial", "spin_growth"]

SPEED_SOURCE: Final = "Timoshenko and Goodier 1970, section 32"


class SpinningMaterial(Protocol):
    """What the rotation reads of a material."""

    @property
    def youngs_modulus(self) -> float:
        """E; Pa."""
        ...

    @property
    def poisson_ratio(self) -> float:
        """ν."""
        ...

    @property
    def density(self) -> float:
        """ρ; kg/m³."""
        ...


def spin_growth(
    speed: ArrayLike,
    diameter: float,
    *,
    bore: float,
    outside: float,
    material: SpinningMaterial,
) -> FloatArray:
    """Growth of a diameter of a spinning annulus, free on both sides; m.

    Parameters
    ----------
    speed
        ω, in rad/s; array.
    diameter
        Where, from bore to outside; m.
    bore, outside
        Of the annulus, in m; a bore of 0 is solid.
    material
        A `SpinningMaterial`.
    """
    nu = material.poisson_ratio
    a, b, r = 0.5 * bore, 0.5 * outside, 0.5 * diameter
    shape = (
        (1.0 - nu) * (3.0 + nu) * (a * a + b * b)
        + (1.0 + nu) * (3.0 + nu) * (a * b / r) ** 2
        - (1.0 - nu * nu) * r * r
    )
    omega = np.asarray(speed, dtype=np.float64)
    return np.asarray(
        material.density * omega**2 * diameter * shape / (8.0 * material.youngs_modulus)
    )
