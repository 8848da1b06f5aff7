"""Elliptical Hertz contact, exact.

Two bodies touch at a point with summed curvatures ρ_x in the rolling direction and ρ_y across
it (a hollow counts negative). The contact is an ellipse with semi-axes a ≥ b; a lies along the
direction of the lesser curvature, which between a ball and a groove is across rolling.

The shape k = a/b follows from the ratio of the curvatures alone,

    ρ_min / ρ_max = (1 - F)/(1 + F) = D(m) / (k² B(m)),      m = 1 - 1/k²,

the same equation as the usual F = ((k²+1) E - 2 K) / ((k²-1) E), but without its cancellation
at k = 1. B and D are the associate complete elliptic integrals.

Sources: Hertz (1881); Johnson, Contact Mechanics (1985), section 4.2; Harris, Rolling Bearing
Analysis, 3rd ed. (1991), chapter 5; Brewe and Hamrock (1977).
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray
from rolamento.numerics.compiled import inline_exact, kernel
from rolamento.numerics.elementwise import of_each
from rolamento.numerics.ellipse import ellipse_of_log_ratio
from rolamento.numerics.elliptic import complete
from rolamento.records import frozen


class ElasticMaterial(Protocol):
    """What a contact reads of a material."""

    @property
    def youngs_modulus(self) -> float:
        """E; Pa."""
        ...

    @property
    def poisson_ratio(self) -> float:
        """ν."""
        ...


@frozen
class HertzCoefficients:
    """Shape of a contact and Harris's dimensionless sizes, functions of F(ρ) alone.

    a = a* c, b = b* c with c = (3 Q / (Σρ E'))^(1/3), and δ = δ* c² Σρ / 2.
    """

    ellipticity: FloatArray
    semi_major: FloatArray
    semi_minor: FloatArray
    deflection: FloatArray


@frozen
class HertzContact:
    """A loaded elliptical contact; every field an array of the same shape, SI.

    load N, semi_major and semi_minor m, deflection m, max_pressure and mean_pressure Pa,
    stiffness N/m^1.5 (load = stiffness · deflection^1.5), ellipticity a/b, second_integral E(m).
    """

    load: FloatArray
    semi_major: FloatArray
    semi_minor: FloatArray
    deflection: FloatArray
    max_pressure: FloatArray
    mean_pressure: FloatArray
    stiffness: FloatArray
    ellipticity: FloatArray
    second_integral: FloatArray

    @property
    def resistance_to_spin(self) -> FloatArray:
        """Q a E(m); (3/8) μ times it is the friction moment; N·m. Jones (1959); Harris (1991)."""
        return self.load * self.semi_major * self.second_integral


def effective_modulus(first: ElasticMaterial, second: ElasticMaterial) -> float:
    """Effective modulus E' of two materials, 2/E' = (1-ν₁²)/E₁ + (1-ν₂²)/E₂; Pa.

    Twice the E* of Johnson (1985), section 4.2.
    """
    return 2.0 / (
        (1.0 - first.poisson_ratio**2) / first.youngs_modulus
        + (1.0 - second.poisson_ratio**2) / second.youngs_modulus
    )


def ellipticity(curvature_difference: ArrayLike) -> FloatArray:
    """Ratio k = a/b ≥ 1 of a contact ellipse from the difference of curvatures F(ρ).

    Parameters
    ----------
    curvature_difference : array of any shape, F in [0, 1); dimensionless.

    Returns
    -------
    k of that shape; NaN outside the range. Near F = 1 the result is as good as F itself, whose
    rounding matters: `elliptical_contact` starts from the curvatures and does not lose it.

    Radaelli (2013) eq. 4.

    >>> print(f"{ellipticity(0.0):.1f}")
    1.0
    """
    f = np.asarray(curvature_difference, dtype=np.float64)
    f = np.where((f >= 0.0) & (f < 1.0), f, np.nan)
    return ellipse_of_log_ratio(-2.0 * np.arctanh(f)).ellipticity


def brewe_hamrock_ellipticity(curvature_ratio: ArrayLike) -> FloatArray:
    """The fit k = 1.0339 (R_y/R_x)^0.636, for published models that were built on it.

    Up to 6 % off the exact k at close conformity; `ellipticity` is the exact one.

    Parameters
    ----------
    curvature_ratio : array, R_y/R_x = ρ_x/ρ_y ≥ 1; dimensionless.

    Returns
    -------
    k of that shape.

    Brewe and Hamrock (1977); fitted for 1 ≤ R_y/R_x ≤ 100.

    >>> print(f"{brewe_hamrock_ellipticity(10.0):.3f}")
    4.472
    """
    return np.asarray(1.0339 * np.asarray(curvature_ratio, dtype=np.float64) ** 0.636)


def hertz_coefficients(curvature_difference: ArrayLike) -> HertzCoefficients:
    """Harris's a*, b* and δ* of a contact.

    Parameters
    ----------
    curvature_difference : array of any shape, F in [0, 1); dimensionless.

    Returns
    -------
    HertzCoefficients of that shape; NaN outside the range.

    Harris (1991), chapter 5; δ* is Radaelli (2013) eq. 7.

    >>> print(f"{hertz_coefficients(0.9).semi_major:.2f}")
    3.09
    """
    k = ellipticity(curvature_difference)
    first, second = complete(1.0 / (k * k))
    b = np.cbrt(2.0 * second / (np.pi * k))
    return HertzCoefficients(k, k * b, b, 2.0 * first / (np.pi * k * b))


def contact_stiffness(
    curvature_rolling: ArrayLike, curvature_across: ArrayLike, modulus: ArrayLike
) -> FloatArray:
    """Stiffness K of an elliptical contact, Q = K δ^1.5.

    Parameters
    ----------
    curvature_rolling, curvature_across : arrays that broadcast; 1/m, positive.
    modulus : array that broadcasts with them, effective modulus E'; Pa.

    Returns
    -------
    K; N/m^1.5, the broadcast shape; NaN where a curvature is not positive.

    Radaelli (2013) eq. 11, for any materials: K = √8/3 · E' Σρ^-½ δ*^-3/2.

    >>> print(f"{1e-9 * contact_stiffness(200.0, 10.0, 2.27e11):.2f} GN/m^1.5")
    26.79 GN/m^1.5
    """
    return elliptical_contact(1.0, curvature_rolling, curvature_across, modulus).stiffness


def series_stiffness(inner: ArrayLike, outer: ArrayLike) -> FloatArray:
    """Stiffness K_n of two contacts in line, whose approaches add: K_n^-⅔ = K_i^-⅔ + K_o^-⅔.

    Parameters: arrays that broadcast; N/m^1.5. Returns the broadcast shape.
    Radaelli (2013) eq. 10.

    >>> print(f"{series_stiffness(1e10, 1e10):.3e}")
    3.536e+09
    """
    third = -2.0 / 3.0
    compliance = np.asarray(inner, np.float64) ** third + np.asarray(outer, np.float64) ** third
    return np.asarray(compliance**-1.5)


def elliptical_contact(
    load: ArrayLike,
    curvature_rolling: ArrayLike,
    curvature_across: ArrayLike,
    modulus: ArrayLike,
) -> HertzContact:
    """Ellipse, deflection and pressure of a contact under load.

    Parameters
    ----------
    load : array, Q; N.
    curvature_rolling, curvature_across : arrays, summed over the two bodies; 1/m, positive.
    modulus : array, effective modulus E'; Pa.
        All broadcast against each other.

    Returns
    -------
    HertzContact of the broadcast shape. No load gives zeros (and the stiffness all the same);
    a negative or NaN load, or a curvature that is not positive, gives NaN.

    Johnson (1985), section 4.2; Harris (1991), chapter 5.

    >>> print(f"{1e-6 * elliptical_contact(1000.0, 200.0, 10.0, 2.27e11).max_pressure:.0f} MPa")
    2098 MPa
    """
    x, y, q, e = (
        np.asarray(one, dtype=np.float64)
        for one in (curvature_rolling, curvature_across, load, modulus)
    )
    valid = (x > 0.0) & (y > 0.0)
    if not valid.all():
        x, y = np.where(valid, x, np.nan), np.where(valid, y, np.nan)
    q = np.where(q >= 0.0, q, np.nan)
    k, first, second = ellipse_of_log_ratio(-np.abs(np.log(x / y)))
    strain = (x + y) / second
    b = np.cbrt(6.0 / np.pi * q / (strain * k * e))
    a, *others = of_each(_pressed, _fill_pressed, 5, b, strain, k, first, e)
    return HertzContact(*np.broadcast_arrays(q, a, b, *others, k, second))


@inline_exact
def _pressed(
    b: FloatArray, strain: FloatArray, k: FloatArray, first: FloatArray, modulus: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray, FloatArray]:
    """Semi-major axis, deflection, maximum and mean pressure, and stiffness; strain: Σρ/E(m)."""
    p0 = 0.25 * b * strain * modulus
    approach = 0.5 * strain * first  # δ/b²
    stiffness = np.pi / 6.0 * strain * k * modulus / (approach * np.sqrt(approach))
    return k * b, approach * (b * b), p0, 2.0 / 3.0 * p0, stiffness


@kernel
def _fill_pressed(
    b: FloatArray, strain: FloatArray, k: FloatArray, first: FloatArray, modulus: FloatArray,
    out: FloatArray,
) -> None:  # fmt: skip
    """Fill out, (5, numbers)."""
    for i in range(b.size):
        out[0, i], out[1, i], out[2, i], out[3, i], out[4, i] = _pressed(
            b[i], strain[i], k[i], first[i], modulus[i]
        )
