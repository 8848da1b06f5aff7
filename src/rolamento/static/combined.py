"""Radial and axial load together on one row, at a constant contact angle (Sjövall).

The ring moves δ_r and δ_a without tilting; a ball at azimuth ψ is squeezed by
δ_a sin α + δ_r cos α cos ψ. Then

    F_r = Z Q_max J_r(ε) cos α,    F_a = Z Q_max J_a(ε) sin α,    F_r tan α / F_a = J_r/J_a,

where ε = ½ (1 + δ_a tan α/δ_r). It is a table-book method: the contact angle is the same for
all balls and does not rise with load.

Source: Sjövall (1933); Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 6.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from rolamento.geometry import ring_geometry
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.static._common import (
    BallBearing,
    RaceStiffness,
    StatusArray,
    race_stiffness,
    status_codes,
)
from rolamento.static.sjovall import (
    half_power_means,
    load_zone_half_angle,
    sjovall_axial,
    sjovall_radial,
)

_NEAR_ZERO, _NEAR_INFINITY = 1e-7, 1e7


@dataclass(frozen=True, slots=True)
class CombinedSolution:
    """Static state under radial and axial load; arrays over the loads, NaN where not CONVERGED."""

    radial_load: FloatArray
    axial_load: FloatArray
    """F_r and F_a; N."""
    contact_angle: float
    """α, the same for all balls; rad."""
    load_zone_parameter: FloatArray
    """ε; infinite under pure axial load."""
    load_zone_half_angle: FloatArray
    """ψ_l; rad."""
    max_ball_load: FloatArray
    """Q_max, at ψ = 0; N."""
    radial_displacement: FloatArray
    """δ_r; m."""
    axial_displacement: FloatArray
    """δ_a, from first contact; m."""
    stiffness: RaceStiffness
    status: StatusArray
    """`StaticStatus` code of each load."""


def combined_load(
    bearing: BallBearing,
    radial_load: ArrayLike,
    axial_load: ArrayLike,
    *,
    contact_angle: float | None = None,
) -> CombinedSolution:
    """Load zone and displacements of one row under radial and axial load.

    Parameters
    ----------
    bearing : any object with the attributes of `BallBearing`; SI.
    radial_load, axial_load : arrays that broadcast, F_r ≥ 0 and F_a > 0; N.
    contact_angle : α of all balls; rad. Default: the bearing's free contact angle.

    Returns
    -------
    CombinedSolution of the broadcast shape. Where F_r tan α reaches F_a not even one ball could
    carry the load at this angle: status NO_EQUILIBRIUM. A negative load: INVALID_LOAD.

    Raises
    ------
    ValueError : if the contact angle is not between 0 and 90°, both excluded.

    Sjövall (1933); Harris (1991), chapter 6.
    """
    angle = ring_geometry(bearing).free_contact_angle if contact_angle is None else contact_angle
    if not 0.0 < angle < 0.5 * np.pi:
        raise ValueError(f"a combined load needs a contact angle in (0, 90°), got {angle!r} rad")
    fr, fa = np.broadcast_arrays(
        np.asarray(radial_load, dtype=np.float64), np.asarray(axial_load, dtype=np.float64)
    )
    valid = np.isfinite(fr) & np.isfinite(fa) & (fr >= 0.0) & (fa >= 0.0)
    idle = valid & (fr == 0.0) & (fa == 0.0)
    supported = ~valid | idle | (fr * np.tan(angle) < fa)
    solvable = valid & supported & ~idle
    ratio = np.where(solvable, fr, 0.0) * np.tan(angle) / np.where(solvable, fa, 1.0)
    epsilon, converged = _load_zone(ratio)
    bad = ~(valid & supported & converged)
    epsilon = np.where(bad, np.nan, epsilon)

    stiffness = race_stiffness(bearing, angle)
    max_load = fa / (bearing.ball_count * sjovall_axial(epsilon) * np.sin(angle))
    deflection = (max_load / stiffness.combined) ** (2.0 / 3.0)
    radial_share = 1.0 / (2.0 * epsilon)
    return CombinedSolution(
        radial_load=fr,
        axial_load=fa,
        contact_angle=float(angle),
        load_zone_parameter=epsilon,
        load_zone_half_angle=load_zone_half_angle(epsilon),
        max_ball_load=max_load,
        radial_displacement=deflection * radial_share / np.cos(angle),
        axial_displacement=deflection * (1.0 - radial_share) / np.sin(angle),
        stiffness=stiffness,
        status=status_codes(converged, valid, supported),
    )


def _load_zone(ratio: FloatArray) -> tuple[FloatArray, BoolArray]:
    """ε whose J_r/J_a is F_r tan α/F_a in [0, 1), by Newton on ln ε.

    Beyond the bracket the limits serve: J_r/J_a = 1 - ε/3 toward 0 and 3/(8 ε) toward infinity.
    """
    with np.errstate(divide="ignore"):
        far = 3.0 / (8.0 * ratio)
    near = 3.0 * (1.0 - ratio)
    outside = (far > _NEAR_INFINITY) | (near < _NEAR_ZERO)
    target = np.where(outside, 0.5, ratio)

    def balance(log_epsilon: FloatArray) -> tuple[FloatArray, FloatArray]:
        epsilon = np.exp(log_epsilon)
        jr, ja = sjovall_radial(epsilon), sjovall_axial(epsilon)
        m0, m1, m2 = half_power_means(epsilon)
        rate = 0.75 / epsilon  # dJ/d ln ε = 3/(4ε) times a difference of means
        slope = (rate * (m0 - m1) * jr - rate * (m1 - m2) * ja) / (ja * ja)
        return target - jr / ja, slope

    lower = np.full_like(target, np.log(0.5 * _NEAR_ZERO))
    upper = np.full_like(target, np.log(2.0 * _NEAR_INFINITY))
    start = np.log(np.where(target < 0.5, 3.0 / (8.0 * target), 3.0 * (1.0 - target)))
    log_epsilon, converged = increasing_root(balance, start, lower, upper, tolerance=1e-13)
    limit = np.where(ratio > 0.5, near, far)
    return np.where(outside, limit, np.exp(log_epsilon)), converged | outside
