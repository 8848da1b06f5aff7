"""A radially loaded ring at contact angle zero, with clearance or interference.

The inner ring moves δ_r along the load; a ball at azimuth ψ from the load is squeezed by
δ_r cos ψ - P_d/2. The loads are summed either by Sjövall's integral over a continuous ring of
balls, or ball by ball. With few balls the two differ, and the result says which it is.

Source: Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 6; Radaelli (2013), 4.2.1.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.contact.race import BallBearing, RaceStiffness, race_stiffness
from rolamento.geometry import ring_geometry
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.records import frozen
from rolamento.static._common import StatusArray, status_codes
from rolamento.static.sjovall import half_power_means, load_zone_half_angle, sjovall_radial

Distribution = Literal["continuous", "discrete"]

_NEWTON_STEPS = 200
_HALVINGS = 60
_RESIDUAL = 1e-12
_ROUNDING = 4.0 * float(np.finfo(np.float64).eps)
_DAMPING = 1e-10


@frozen
class RadialSolution:
    """Static state under a radial load. Arrays over the loads; ball_loads has one axis more, Z.

    Where the status is not CONVERGED the numbers are NaN.
    """

    load: FloatArray
    """F_r; N."""
    distribution: Distribution
    """"continuous": Sjövall's integral; "discrete": the sum over the balls."""
    radial_displacement: FloatArray
    """δ_r along the load, from the centred position; m."""
    lateral_displacement: FloatArray
    """Across the load, toward azimuth +90°: what a discrete ring of balls that does not lie
    symmetrically about the load needs, so that no lateral force remains; m."""
    load_zone_parameter: FloatArray
    """ε, the loaded part of the diameter."""
    load_zone_half_angle: FloatArray
    """ψ_l; rad."""
    max_ball_load: FloatArray
    """Q_max: at ψ = 0 if continuous, on the most loaded ball if discrete; N."""
    ball_azimuths: FloatArray
    """ψ of the balls from the load line, shape (Z,); rad."""
    ball_loads: FloatArray
    """Q on those balls, shape (…, Z); N."""
    stiffness: RaceStiffness
    """Contact stiffness at contact angle zero."""
    status: StatusArray
    """`StaticStatus` code of each load."""

    def load_at(self, azimuth: ArrayLike) -> FloatArray:
        """Q(ψ) of one load, on a ball at an azimuth from the load line (rad, array); N.

        Q_max [1 - (1 - cos ψ)/(2ε)]^1.5 where positive. Sjövall (1933); Radaelli (2013) eq. 13.
        """
        share = 1.0 - (1.0 - np.cos(azimuth)) / (2.0 * float(self.load_zone_parameter))
        return np.asarray(float(self.max_ball_load) * np.maximum(share, 0.0) ** 1.5)


def radial_load(
    bearing: BallBearing,
    load: ArrayLike,
    *,
    distribution: Distribution = "continuous",
    first_ball_azimuth: float = 0.0,
) -> RadialSolution:
    """Load distribution and displacement of a bearing under pure radial load.

    Parameters
    ----------
    bearing : any object with the attributes of `BallBearing`, given by its diametral clearance
        (negative: interference) or by contact angle 0; SI.
    load : array of any shape, F_r ≥ 0; N. As F_r goes to 0 the ring is taken to first contact.
    distribution : "continuous" (default) or "discrete".
    first_ball_azimuth : azimuth of the first ball from the load line; rad.

    Returns
    -------
    RadialSolution over the shape of `load`; a negative, infinite or NaN load has its status.

    Raises
    ------
    ValueError : if the bearing is one-sided (contact angle above zero): a radial load alone
        drives its rings apart; `combined_load` treats it.

    Harris (1991), chapter 6; Radaelli (2013) eqs. 12 to 18.
    """
    ring = ring_geometry(bearing)
    if ring.one_sided:
        raise ValueError(
            "a bearing with a contact angle above zero needs an axial load: use combined_load"
        )
    force = np.asarray(load, dtype=np.float64)
    valid = np.isfinite(force) & (force >= 0.0)
    safe = np.where(valid, force, 0.0)
    stiffness = race_stiffness(bearing, 0.0)
    row = _Row(bearing.ball_count, float(stiffness.combined), 0.5 * ring.diametral_clearance)
    azimuths = first_ball_azimuth + 2.0 * np.pi * np.arange(row.count) / row.count

    excess, converged = _continuous(row, safe)
    along = excess + max(row.gap, 0.0)
    across = np.zeros_like(along)
    if distribution == "discrete":
        along, across, converged = _discrete(row, safe, azimuths, along + excess)
        excess = np.hypot(along, across) - max(row.gap, 0.0)

    ball_loads = row.loads(along, across, azimuths)
    if distribution == "discrete":
        max_load = ball_loads.max(axis=-1)
    else:
        max_load = row.stiffness * (excess + max(-row.gap, 0.0)) ** 1.5
    epsilon = _zone(excess, row.gap)
    bad = ~(valid & converged)
    fields = (along, across, epsilon, load_zone_half_angle(epsilon), max_load)
    along, across, epsilon, half_angle, max_load = (np.where(bad, np.nan, v) for v in fields)
    return RadialSolution(
        load=force,
        distribution=distribution,
        radial_displacement=along,
        lateral_displacement=across,
        load_zone_parameter=epsilon,
        load_zone_half_angle=half_angle,
        max_ball_load=max_load,
        ball_azimuths=azimuths,
        ball_loads=np.where(bad[..., np.newaxis], np.nan, ball_loads),
        stiffness=stiffness,
        status=status_codes(converged, valid, np.ones_like(valid)),
    )


@frozen
class _Row:
    """A row of balls as radial springs that start after a gap P_d/2."""

    count: int
    stiffness: float
    gap: float

    def squeeze(self, along: FloatArray, across: FloatArray, azimuths: FloatArray) -> FloatArray:
        """Approach of the races at each ball, where positive; shape (…, Z). Radaelli eq. 12."""
        reach = along[..., np.newaxis] * np.cos(azimuths)
        reach = reach + across[..., np.newaxis] * np.sin(azimuths)
        return np.maximum(reach - self.gap, 0.0)

    def loads(self, along: FloatArray, across: FloatArray, azimuths: FloatArray) -> FloatArray:
        return np.asarray(self.stiffness * self.squeeze(along, across, azimuths) ** 1.5)


def _zone(excess: FloatArray, gap: float) -> FloatArray:
    """ε = ½ (1 - P_d/(2 δ_r)) from the displacement beyond first contact; ½ without clearance.

    The excess is the squeeze δ_max of the bottom ball when there is clearance, and δ_r itself
    when there is interference, so neither case subtracts near numbers.
    """
    if gap == 0.0:
        return np.full_like(excess, 0.5)
    deepest, displacement = excess + max(-gap, 0.0), excess + max(gap, 0.0)
    with np.errstate(divide="ignore"):
        return np.asarray(deepest / (2.0 * displacement))


def _continuous(row: _Row, load: FloatArray) -> tuple[FloatArray, BoolArray]:
    """Displacement beyond first contact from F_r = Z K_n δ_max^1.5 J_r(ε). Radaelli eq. 18.

    The start supposes Q_max = 5 F_r / Z.
    """
    scale = row.count * row.stiffness
    interference = max(-row.gap, 0.0)

    def balance(excess: FloatArray) -> tuple[FloatArray, FloatArray]:
        deepest, epsilon = excess + interference, _zone(excess, row.gap)
        value = scale * deepest**1.5 * sjovall_radial(epsilon) - load
        slope = 1.5 * scale * np.sqrt(deepest) * half_power_means(epsilon)[2]
        return value, slope

    idle = load == 0.0
    load = np.where(idle, 1.0, load)  # any load that has a root
    start = (5.0 * load / scale) ** (2.0 / 3.0)
    root, converged = increasing_root(
        balance, start, np.zeros_like(start), np.full_like(start, np.inf)
    )
    return np.where(idle, 0.0, root), converged


def _discrete(
    row: _Row, load: FloatArray, azimuths: FloatArray, start: FloatArray
) -> tuple[FloatArray, FloatArray, BoolArray]:
    """Displacement along and across the load that balances the balls, by damped Newton.

    The elastic energy is convex, so a step is good as soon as the force along it has not
    overshot. The start squeezes the balls more than the answer will. Steps are kept below its
    length: one ball alone leaves the ring free to slide past it, and the stiffness singular.
    """
    cosine, sine = np.cos(azimuths), np.sin(azimuths)
    scale = load + row.count * row.stiffness * max(-row.gap, 0.0) ** 1.5
    longest = np.maximum(start, abs(row.gap)) + np.finfo(np.float64).tiny
    damping = _DAMPING * row.stiffness * np.sqrt(longest)

    def residual(z: FloatArray, y: FloatArray) -> tuple[FloatArray, FloatArray]:
        q = row.loads(z, y, azimuths)
        return q @ cosine - load, q @ sine

    def balanced(z: FloatArray, y: FloatArray, rz: FloatArray, ry: FloatArray) -> BoolArray:
        slope = 1.5 * row.stiffness * np.sqrt(row.squeeze(z, y, azimuths)).sum(axis=-1)
        rounding = _ROUNDING * slope * (np.hypot(z, y) + abs(row.gap))
        return np.asarray(np.hypot(rz, ry) <= _RESIDUAL * scale + rounding)

    z, y = np.array(start), np.zeros_like(start)
    for _ in range(_NEWTON_STEPS):
        rz, ry = residual(z, y)
        done = balanced(z, y, rz, ry)
        if np.all(done):
            break
        h = 1.5 * row.stiffness * np.sqrt(row.squeeze(z, y, azimuths))
        dz, dy = _newton_step(rz, ry, h @ cosine**2, h @ (cosine * sine), h @ sine**2, damping)
        shorten = np.minimum(1.0, longest / np.maximum(np.hypot(dz, dy), longest))
        dz, dy = np.where(done, 0.0, dz * shorten), np.where(done, 0.0, dy * shorten)
        descent = rz * dz + ry * dy
        for _ in range(_HALVINGS):
            tz, ty = residual(z + dz, y + dy)
            overshot = tz * dz + ty * dy > 0.9 * np.abs(descent)
            if not np.any(overshot):
                break
            factor = np.where(overshot, 0.5, 1.0)
            dz, dy, descent = dz * factor, dy * factor, descent * factor
        z, y = z + dz, y + dy
    return z, y, balanced(z, y, *residual(z, y))


def _newton_step(
    rz: FloatArray,
    ry: FloatArray,
    zz: FloatArray,
    zy: FloatArray,
    yy: FloatArray,
    damping: FloatArray,
) -> tuple[FloatArray, FloatArray]:
    """Solve the 2×2 system, damped a trace so that it always can be."""
    zz, yy = zz + damping, yy + damping
    determinant = zz * yy - zy * zy
    return (zy * ry - yy * rz) / determinant, (zy * rz - zz * ry) / determinant
