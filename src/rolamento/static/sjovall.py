"""Sjövall's load integrals for point contact.

A ring displaced along one line presses the balls as

    Q(ψ) = Q_max w(ψ)^1.5,     w = 1 - (1 - cos ψ)/(2ε) where positive, else 0,

ε being the loaded part of the bearing's diameter. The means round the ring of Q/Q_max and of
its radial component are J_a and J_r. Both reduce to smooth integrals over a quarter turn: with
sin(ψ/2) = √ε sin θ below ε = 1, and θ = ψ/2 above it. J_r is integrated by parts first, so
that it keeps its precision where it becomes small (ε → ∞).

Sources: Sjövall (1933); Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 6.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray

_NODES = 96


def load_zone_half_angle(load_zone_parameter: ArrayLike) -> FloatArray:
    """Half angle of the load zone, cos ψ_l = 1 - 2ε; rad. Half a turn from ε = 1 upward.

    Parameters: array, ε ≥ 0. Returns its shape; NaN below 0. Radaelli (2013) eqs. 14, 15.

    >>> print(f"{np.degrees(load_zone_half_angle(0.5)):.0f} deg")
    90 deg
    """
    epsilon = _parameter(load_zone_parameter)
    return np.asarray(2.0 * np.arcsin(np.sqrt(np.minimum(epsilon, 1.0))))


def sjovall_radial(load_zone_parameter: ArrayLike) -> FloatArray:
    """Radial load integral J_r(ε), the mean of (Q/Q_max) cos ψ round the ring.

    Parameters
    ----------
    load_zone_parameter : array of any shape, ε ≥ 0, infinity included; dimensionless.

    Returns
    -------
    J_r of that shape, 0 at both ends; NaN below 0.

    With I(m) = ∫ sin² cos² √(1 - m sin²) dθ over a quarter turn, (6/π) √ε I(ε) up to ε = 1 and
    (6/π) I(1/ε)/ε above: Sjövall's definition, by parts.

    >>> print(f"{sjovall_radial(0.5):.4f}")
    0.2288
    """
    epsilon = _parameter(load_zone_parameter)
    theta, weight = _quarter_turn()
    m, factor = _fold(epsilon)
    sine2, cosine2 = np.sin(theta) ** 2, np.cos(theta) ** 2
    delta = np.sqrt(1.0 - m[..., np.newaxis] * sine2)
    scale = np.where(epsilon <= 1.0, factor, m)
    return np.asarray(6.0 / np.pi * scale * (delta @ (weight * sine2 * cosine2)))


def sjovall_axial(load_zone_parameter: ArrayLike) -> FloatArray:
    """Axial load integral J_a(ε), the mean of Q/Q_max round the ring.

    Parameters
    ----------
    load_zone_parameter : array of any shape, ε ≥ 0, infinity included; dimensionless.

    Returns
    -------
    J_a of that shape, from 0 at ε = 0 to 1 at infinity; NaN below 0.

    Sjövall (1933); Harris (1991), chapter 6.

    >>> print(f"{sjovall_axial(0.5):.4f}")
    0.2782
    """
    epsilon = _parameter(load_zone_parameter)
    return _mean(epsilon, 1.5, 0)


def half_power_means(load_zone_parameter: ArrayLike) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Means round the ring of w^½, w^½ cos ψ and w^½ cos² ψ, from which the slopes of J follow.

    Parameters: array, ε > 0. Returns three arrays of its shape.
    """
    epsilon = _parameter(load_zone_parameter)
    return _mean(epsilon, 0.5, 0), _mean(epsilon, 0.5, 1), _mean(epsilon, 0.5, 2)


def _mean(epsilon: FloatArray, exponent: float, moment: int) -> FloatArray:
    """Mean of w^exponent cos^moment ψ round the ring."""
    theta, weight = _quarter_turn()
    m, factor = _fold(epsilon)
    sine2, cosine = np.sin(theta) ** 2, np.cos(theta)
    delta = np.sqrt(1.0 - m[..., np.newaxis] * sine2)
    partial = (epsilon <= 1.0)[..., np.newaxis]
    zone = cosine ** (2.0 * exponent + 1.0) / delta
    full = delta ** (2.0 * exponent)
    cos_psi = 1.0 - 2.0 * np.where(partial, m[..., np.newaxis], 1.0) * sine2
    return np.asarray(
        2.0 / np.pi * factor * (np.where(partial, zone, full) * cos_psi**moment @ weight)
    )


def _fold(epsilon: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Parameter m = min(ε, 1/ε) of the quarter-turn integrals, and √ε capped at 1."""
    with np.errstate(divide="ignore"):
        m = np.minimum(epsilon, 1.0 / epsilon)
    return m, np.sqrt(np.minimum(epsilon, 1.0))


def _parameter(epsilon: ArrayLike) -> FloatArray:
    value = np.asarray(epsilon, dtype=np.float64)
    return np.where(value >= 0.0, value, np.nan)


@cache
def _quarter_turn() -> tuple[FloatArray, FloatArray]:
    """Gauss-Legendre nodes and weights on (0, π/2)."""
    node, weight = np.polynomial.legendre.leggauss(_NODES)
    return 0.25 * np.pi * (node + 1.0), 0.25 * np.pi * weight
