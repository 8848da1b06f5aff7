"""Friction over the contact ellipses: points to integrate at, and Coulomb's law summed up.

In unit coordinates u = x0/a and v = y0/b, with v = s √(1 - u²),

    ∫ p g dA = (3Q/2π) ∫∫ (1 - u²) √(1 - s²) g du ds

so Gauss-Legendre in u and Gauss-Chebyshev of the second kind in s carry Hertz's pressure in their
weights: the load itself, and any polynomial g of moderate degree, come out exact, and the same
points serve every contact (DLMF 3.5(v)).

Rounded, the friction per load is μ v/√(v² + v0²): the gradient of μ √(v² + v0²), a convex
function of the slip. Slip is linear in the angular velocities of ball and cage, so the power of
friction is convex in them, and where no inertia acts its minimum is the equilibrium of the ball.
"""

from __future__ import annotations

from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.friction.slip import Patch, RelativeMotion, Slip, slip_velocity
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.words import said

_MAXIMUM_POINTS = 2000
_MIDDLE = 1e-9


@frozen(slots=False)
class EllipseMesh:
    """Points (points,) in u = x0/a and v = y0/b; the weights add up to one.

    The load times the weighted sum of g is ∫ p g dA.
    """

    across: FloatArray
    along: FloatArray
    weight: FloatArray

    @cached_property
    def folded(self) -> EllipseMesh:
        """The half with y0 ≥ 0, for integrands that are even along rolling."""
        kept = self.along > -_MIDDLE
        share = np.where(np.abs(self.along[kept]) < _MIDDLE, 1.0, 2.0)
        return EllipseMesh(self.across[kept], self.along[kept], self.weight[kept] * share)

    @cached_property
    def rows(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Places across, u (places,), with v² and weight of their points, (rows along, places)."""
        u, count = np.unique(self.across, return_counts=True)
        shape = (u.size, int(count[0]))
        return (
            self.across.reshape(shape)[:, 0].copy(),
            np.ascontiguousarray(np.square(self.along).reshape(shape).T),
            np.ascontiguousarray(self.weight.reshape(shape).T),
        )


@lru_cache(maxsize=32)
def ellipse_mesh(across: int = 80, along: int = 5) -> EllipseMesh:
    """Return the points of a mesh.

    Parameters
    ----------
    across, along : number of points across rolling and along it, at least 2 and 1.

    Returns
    -------
    EllipseMesh of across × along points; its arrays do not change.

    Raises
    ------
    InputError
        If a number is out of range.
    """
    for name, count, minimum in (("across", across, 2), ("along", along, 1)):
        if not minimum <= count <= _MAXIMUM_POINTS:
            raise InputError(
                said("must be from {least} to {most}", least=minimum, most=_MAXIMUM_POINTS),
                field=f"mesh.{name}",
                value=count,
            )
    u, legendre = np.polynomial.legendre.leggauss(across)
    angle = np.arange(1, along + 1) * np.pi / (along + 1)
    s, chebyshev = np.cos(angle), np.pi / (along + 1) * np.sin(angle) ** 2
    weight = 1.5 / np.pi * ((1.0 - u**2) * legendre)[:, np.newaxis] * chebyshev
    v = np.sqrt(1.0 - u**2)[:, np.newaxis] * s
    mesh = EllipseMesh(np.repeat(u, along), v.ravel(), weight.ravel())
    for array in (mesh.across, mesh.along, mesh.weight):
        array.setflags(write=False)
    return mesh


@frozen
class ContactFriction:
    """Friction of a race on the ball, summed over contacts; arrays of one shape, SI.

    Forces N on the ball; moments N·m on it about its centre, in (t, y, n); race_torque N·m, what
    the ball does to the ring about the shaft; power W, always taken from the motion.
    """

    force_rolling: FloatArray
    force_transverse: FloatArray
    moment_roll: FloatArray
    moment_tumble: FloatArray
    moment_twist: FloatArray
    race_torque: FloatArray
    power: FloatArray
    spin_power: FloatArray
    """The part of the power that the twisting moment takes."""


def friction_per_load(
    slip: Slip, coefficient: ArrayLike, rounding: ArrayLike = 0.0
) -> tuple[FloatArray, FloatArray]:
    """Friction over pressure, in the rolling direction and across it.

    Parameters
    ----------
    slip : at points of contacts, arrays (..., points).
    coefficient : μ, array that broadcasts; dimensionless.
    rounding : v0, array that broadcasts; m/s. Zero gives Coulomb's law, with no friction where
        nothing slips.

    Returns
    -------
    f_y/p and f_t/p on the ball, arrays (..., points).
    """
    speed = np.sqrt(slip.rolling**2 + slip.transverse**2 + np.asarray(rounding) ** 2)
    with np.errstate(invalid="ignore", divide="ignore"):
        scale = np.where(speed == 0.0, 0.0, coefficient / speed)
    return np.asarray(scale * slip.rolling), np.asarray(scale * slip.transverse)


def contact_friction(
    patch: Patch,
    motion: RelativeMotion,
    coefficient: ArrayLike,
    *,
    rounding: ArrayLike = 0.0,
    mesh: EllipseMesh | None = None,
) -> ContactFriction:
    """Integrate Coulomb friction over the ellipses.

    Parameters
    ----------
    patch, motion : of the same contacts, arrays (...).
    coefficient : μ, array (...) or scalar.
    rounding : v0, array (...) or scalar; m/s.
    mesh : points; 80 × 5 by default.

    Returns
    -------
    ContactFriction of shape (...).
    """
    mesh = ellipse_mesh() if mesh is None else mesh
    slip = slip_velocity(patch, motion, mesh.across, mesh.along)
    mu, v0 = np.asarray(coefficient, np.float64), np.asarray(rounding, np.float64)
    f_y, f_t = friction_per_load(slip, mu[..., np.newaxis], v0[..., np.newaxis])
    return integrate_friction(patch, motion, slip, f_y, f_t, mesh)


def integrate_friction(
    patch: Patch,
    motion: RelativeMotion,
    slip: Slip,
    per_load_rolling: FloatArray,
    per_load_transverse: FloatArray,
    mesh: EllipseMesh,
) -> ContactFriction:
    """Sum any friction law up: friction over pressure at the points of a mesh.

    Parameters
    ----------
    patch, motion : of the same contacts, arrays (...).
    slip, per_load_rolling, per_load_transverse : arrays (..., points).
    mesh : the points.

    Returns
    -------
    ContactFriction of shape (...).
    """
    points = patch.at_points()
    f_y, f_t = (points.load * mesh.weight * f for f in (per_load_rolling, per_load_transverse))
    radius = patch.side * points.rolling_radius(mesh.across)
    x0, y0 = points.semi_major * mesh.across, points.semi_minor * mesh.along
    cosine, sine = np.cos(points.contact_angle), np.sin(points.contact_angle)
    arm = 0.5 * points.pitch_diameter + radius * cosine - x0 * sine
    twist = np.sum(x0 * f_y - y0 * f_t, axis=-1)
    return ContactFriction(
        force_rolling=np.sum(f_y, axis=-1),
        force_transverse=np.sum(f_t, axis=-1),
        moment_roll=-np.sum(radius * f_y, axis=-1),
        moment_tumble=np.sum(radius * f_t, axis=-1),
        moment_twist=twist,
        # on the ring -f at (arm along z, y0 along y); about x: y f_z - z f_y
        race_torque=np.sum(arm * f_y + y0 * sine * f_t, axis=-1),
        power=np.sum(f_y * slip.rolling + f_t * slip.transverse, axis=-1),
        spin_power=-twist * motion.twist,
    )
