"""The shear that every point under a raceway goes through as a ball rolls by, and its integral.

At a point of the cross-section, y from the middle of the contact and z below the surface, the
orthogonal shear τ_xz swings between -τ and +τ, τ(y, z) being its greatest size along x. Over p0,
with η = y/a and ζ = z/b, it depends on the ellipse's shape k = a/b alone: the field is computed
once at some shapes and points, and interpolated in ln k. The integrals

    I(t, k) = 2 ∫∫ ⟨g - t⟩^c / ζ^h dη dζ,     t = τ_u/p0,

are sums over the points (Gauss-Legendre in both directions).

Source: Lundberg and Palmgren (1947); Ioannides and Harris (1985); contact.subsurface for τ_xz.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import numbers

MAXIMUM_ELLIPTICITY: Final = 60.0
"""a/b up to which the field is tabulated; flatter ones count as this one."""
_SHAPES: Final = 12
_WIDTH: Final = 1.5
"""Half-width of the region, over a: beyond it the shear is below a tenth of the greatest."""
_DEPTH: Final = 6.0
"""Depth of the region, over b."""
_NEAREST: Final = 1e-3
_FURTHEST: Final = 100.0
"""Where the peak of the shear is looked for: λ - λ_0 over ζ, and over k (1 + ζ)²."""
_HALVINGS: Final = 36
"""Number of halvings of the logarithm: the place to 1e-9, the peak itself to rounding."""
_BLOCK: Final = 1024


@frozen
class FieldMesh:
    """Points across and into the depth; more of them for a proof of convergence."""

    across: int = 32
    depth: int = 48


@frozen
class ShearIntegrals:
    """Risk integral I and weighted mean depth over b of each contact, both of one shape."""

    local: FloatArray
    plain: FloatArray
    mean_depth: FloatArray


@frozen
class _Field:
    """g at the shapes and points (shapes, points), the points' ζ and weights, ln k of shapes."""

    shear: FloatArray
    depth: FloatArray
    weight: FloatArray
    log_shape: FloatArray
    barycentric: FloatArray


def passing_shear(across: ArrayLike, depth: ArrayLike, ellipticity: ArrayLike) -> FloatArray:
    """Greatest |τ_xz| over p0 along x, at y = η a and z = ζ b.

    Parameters
    ----------
    across, depth, ellipticity : arrays that broadcast, η, ζ > 0 and k ≥ 1.

    Every x has its λ of `contact.subsurface.point_stresses`, from λ_0 at x = 0 on, and with it

        x² = (1 + λ) (1 - y²/(k²+λ) - z²/λ):

    the shear is a plain function of λ, and has one peak, which is halved in on by ln(λ - λ_0).
    """
    eta, zeta, k = np.broadcast_arrays(
        *(np.asarray(value, dtype=np.float64) for value in (across, depth, ellipticity))
    )
    y2, z2, k2 = (eta * k) ** 2, zeta**2, k * k
    inside = k2 - y2 - z2
    twice = np.hypot(inside, 2.0 * zeta * k) + np.abs(inside)
    least = np.where(inside < 0.0, 0.5 * twice, 2.0 * z2 * k2 / twice)
    by_y, by_z = y2 / (k2 + least), z2 / least

    def parts(log_beyond: FloatArray) -> tuple[FloatArray, ...]:
        """λ, 1 + λ and k² + λ; y²/(k²+λ)², z²/λ² and x²/(1+λ)."""
        beyond = np.exp(log_beyond)
        by_root = least + beyond
        by_major = k2 + by_root
        x2 = beyond * (by_y / by_major + by_z / by_root)  # without its cancellation near λ_0
        return by_root, 1.0 + by_root, by_major, y2 / by_major**2, z2 / by_root**2, x2

    low, high = np.log(_NEAREST * zeta), np.log(_FURTHEST * k * (1.0 + zeta) ** 2)
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        r, minor, major, p, q, x2 = parts(middle)
        h = x2 / minor + p + q
        slope_of_h = (p + q - x2 / minor) / minor - 2.0 * (p / major + q / r)
        # of the logarithm of the shear, by λ
        slope = 0.5 * (p + q) / x2 - 1.5 / r - 0.5 / major - 1.0 / minor - slope_of_h / h
        low, high = np.where(slope > 0.0, middle, low), np.where(slope > 0.0, high, middle)
    r, minor, major, p, q, x2 = parts(0.5 * (low + high))
    return np.asarray(k * z2 * np.sqrt(x2 / (r * major)) / (r * minor * (x2 / minor + p + q)))


def shear_integrals(
    threshold: ArrayLike,
    ellipticity: ArrayLike,
    *,
    stress_exponent: float,
    depth_exponent: float,
    mesh: FieldMesh | None = None,
) -> ShearIntegrals:
    """Integrals over the cross-section under contacts.

    Parameters
    ----------
    threshold : array (contacts,), t = τ_u/p0; 0 or more.
    ellipticity : array (contacts,), k ≥ 1.
    stress_exponent, depth_exponent : c and h.
    mesh : by default 32 × 48 points.

    Returns
    -------
    ShearIntegrals (contacts,): local, I with each point's own depth; plain, I without depth
    (h = 0); mean_depth, of the weight ⟨g - t⟩^c. Zero, zero and NaN where no point exceeds t.
    """
    t = numbers(threshold, "threshold")
    k = np.clip(numbers(ellipticity, "ellipticity"), 1.0, MAXIMUM_ELLIPTICITY)
    field = _field(mesh or FieldMesh())
    sums = np.empty((3, t.size))
    weights = np.stack(
        [field.weight * field.depth**-depth_exponent, field.weight, field.weight * field.depth],
        axis=1,
    )
    for first in range(0, t.size, _BLOCK):
        some = slice(first, first + _BLOCK)
        shear = _at_shapes(field, np.log(k[some])) @ field.shear
        excess = np.maximum(shear - t[some, np.newaxis], 0.0)
        sums[:, some] = (_power(excess, stress_exponent) @ weights).T
    with np.errstate(invalid="ignore"):
        return ShearIntegrals(sums[0], sums[1], sums[2] / sums[1])


def _power(base: FloatArray, exponent: float) -> FloatArray:
    """Power of numbers from 0 up, by logarithms: twice as fast as the general one."""
    with np.errstate(divide="ignore"):
        return np.asarray(np.exp(exponent * np.log(base)))


def _at_shapes(field: _Field, log_shape: FloatArray) -> FloatArray:
    """Barycentric weights of the tabulated shapes, (contacts, shapes)."""
    distance = log_shape[:, np.newaxis] - field.log_shape
    exact = distance == 0.0
    with np.errstate(divide="ignore", invalid="ignore"):
        weight = field.barycentric / distance
        weight = weight / weight.sum(axis=1, keepdims=True)
    return np.asarray(np.where(exact.any(axis=1, keepdims=True), exact.astype(np.float64), weight))


@lru_cache(maxsize=8)
def _field(mesh: FieldMesh) -> _Field:
    across, across_weight = _gauss(mesh.across, _WIDTH)
    depth, depth_weight = _depths(mesh.depth)
    eta, zeta = (grid.ravel() for grid in np.meshgrid(across, depth, indexing="ij"))
    weight = 2.0 * np.outer(across_weight, depth_weight).ravel()
    angle = (2.0 * np.arange(_SHAPES) + 1.0) * np.pi / (2.0 * _SHAPES)
    log_shape = 0.5 * np.log(MAXIMUM_ELLIPTICITY) * (1.0 + np.cos(angle))
    barycentric = np.sin(angle) * (-1.0) ** np.arange(_SHAPES)
    shear = passing_shear(eta, zeta, np.exp(log_shape)[:, np.newaxis])
    return _Field(shear, zeta, weight, log_shape, barycentric)


def _depths(count: int) -> tuple[FloatArray, FloatArray]:
    """Depths from 0 to the region's end, dense where the shear is great: ζ = v²."""
    root, weight = _gauss(count, float(np.sqrt(_DEPTH)))
    return root * root, 2.0 * root * weight


def _gauss(count: int, length: float) -> tuple[FloatArray, FloatArray]:
    node, weight = np.polynomial.legendre.leggauss(count)
    return 0.5 * length * (node + 1.0), 0.5 * length * weight
