"""Rings that an axial load pushes to one side: the axial load alone, or with a radial one.

`axial_load`: every ball alike, the contact angle rises with load. The groove centres start A2_0
apart radially and stay so, whence the deflection at contact angle α is δ_n = A2_0/cos α - BD.
Equilibrium of the ring is

    F_a = Z K_n δ_n^1.5 sin α.

`combined_load` keeps the contact angle (Sjövall), a table-book method. The ring moves δ_r and δ_a
without tilting; a ball at azimuth ψ is squeezed by δ_a sin α + δ_r cos α cos ψ. Then

    F_r = Z Q_max J_r(ε) cos α,    F_a = Z Q_max J_a(ε) sin α,    F_r tan α / F_a = J_r/J_a,

where ε = ½ (1 + δ_a tan α/δ_r).

Sources: Sjövall (1933); Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 6; Radaelli
(2013), 4.2.2.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.contact.race import BallBearing, RaceStiffness, race_stiffness
from rolamento.geometry import RingGeometry, ring_geometry
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.records import frozen
from rolamento.static._common import StatusArray, status_codes
from rolamento.static.sjovall import (
    half_power_means,
    load_zone_half_angle,
    sjovall_axial,
    sjovall_radial,
)

StiffnessAngle = Literal["loaded", "free"]


@frozen
class AxialSolution:
    """Static state under an axial load; arrays over the loads, NaN where not CONVERGED."""

    load: FloatArray
    """F_a; N."""
    stiffness_angle: StiffnessAngle
    """The contact angle at which the contact stiffness was taken."""
    contact_angle: FloatArray
    """α, positive when the inner ring is pushed toward +x; rad."""
    axial_displacement: FloatArray
    """δ_a, from first contact (contact-angle bearing) or from the centre (clearance); m."""
    ball_load: FloatArray
    """Q; N."""
    deflection: FloatArray
    """δ_n, over both contacts; m."""
    stiffness: RaceStiffness
    """Contact stiffness that went into the result."""
    status: StatusArray
    """`StaticStatus` code of each load."""


def axial_load(
    bearing: BallBearing, load: ArrayLike, *, stiffness_angle: StiffnessAngle = "loaded"
) -> AxialSolution:
    """Contact angle, ball load and displacement of a bearing under central axial load.

    Parameters
    ----------
    bearing : any object with the attributes of `BallBearing`; SI.
    load : array of any shape, F_a; N. Negative loads push toward -x.
    stiffness_angle : whether the contact stiffness belongs to the "loaded" contact angle
        (default) or is frozen at the "free" one, as hand calculations do.

    Returns
    -------
    AxialSolution over the shape of `load`. A negative load on a one-sided bearing has status
    NO_EQUILIBRIUM; an infinite or NaN load INVALID_LOAD. At F_a = 0 a ring with clearance is
    left in the centre, with its free contact angle.

    Harris (1991), chapter 6; Radaelli (2013) eqs. 21 to 32.
    """
    ring = ring_geometry(bearing)
    force = np.asarray(load, dtype=np.float64)
    valid = np.isfinite(force)
    supported = ~(valid & (force < 0.0) & ring.one_sided)
    size = np.where(valid & supported, np.abs(force), 0.0)
    free = race_stiffness(bearing, ring.free_contact_angle)

    def stiffness(angle: FloatArray) -> RaceStiffness:
        return free if stiffness_angle == "free" else race_stiffness(bearing, angle)

    start = _rise_below(ring, size / (bearing.ball_count * free.combined))

    def balance(rise: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Ring equilibrium and its slope, but for the slight change of stiffness with angle."""
        angle = ring.free_contact_angle + rise
        s, c = np.sin(angle), np.cos(angle)
        squeeze = _squeeze(ring, rise)
        root = bearing.ball_count * stiffness(angle).combined * np.sqrt(squeeze)
        slope = root * (squeeze * c + 1.5 * ring.radial_offset * s * s / (c * c))
        return root * squeeze * s - size, slope

    steepest = np.full_like(start, 0.5 * np.pi - ring.free_contact_angle)
    rise, converged = increasing_root(balance, start, np.zeros_like(start), steepest)
    idle = size == 0.0
    converged = converged | idle
    bad = ~(valid & supported & converged)
    rise = np.where(bad, np.nan, np.where(idle, 0.0, rise))
    angle = ring.free_contact_angle + rise
    at_angle = stiffness(angle)
    squeeze = _squeeze(ring, rise)
    sign = np.where(force < 0.0, -1.0, 1.0)
    return AxialSolution(
        load=force,
        stiffness_angle=stiffness_angle,
        contact_angle=sign * angle,
        axial_displacement=np.where(idle & ~bad, 0.0, sign * _axial_displacement(ring, rise)),
        ball_load=at_angle.combined * squeeze**1.5,
        deflection=squeeze,
        stiffness=at_angle,
        status=status_codes(converged, valid, supported),
    )


def _squeeze(ring: RingGeometry, rise: FloatArray) -> FloatArray:
    """δ_n = A2_0/cos α - BD, at an angle that has risen from the free one. Radaelli (2013) eq. 24.

    Written with the difference of the cosines as a product, for the precision of light loads.
    """
    free = ring.free_contact_angle
    fall = 2.0 * np.sin(free + 0.5 * rise) * np.sin(0.5 * rise)
    interference = max(ring.radial_offset - ring.groove_centre_distance, 0.0)
    return np.asarray(ring.radial_offset * fall / _cosines(free, rise) + interference)


def _axial_displacement(ring: RingGeometry, rise: FloatArray) -> FloatArray:
    """δ_a = A2_0 tan α - A1_0. Radaelli (2013) eq. 32."""
    free = ring.free_contact_angle
    to_contact = ring.radial_offset * np.tan(free) - ring.axial_offset
    return np.asarray(ring.radial_offset * np.sin(rise) / _cosines(free, rise) + to_contact)


def _cosines(free: float, rise: FloatArray) -> FloatArray:
    return np.asarray(np.cos(free) * np.cos(free + rise))


def _rise_below(ring: RingGeometry, load: FloatArray) -> FloatArray:
    """A rise of the angle below the true one: that of δ_n = (F_a / Z K_n)^(2/3), as if sin α = 1.

    Not from zero, where the slope vanishes.
    """
    squeeze = load ** (2.0 / 3.0)
    interference = max(ring.radial_offset - ring.groove_centre_distance, 0.0)
    fall = np.maximum(squeeze - interference, 0.0) / (ring.groove_centre_distance + squeeze)
    fall = fall * np.cos(ring.free_contact_angle)
    half_sine = np.sin(0.5 * ring.free_contact_angle)
    half_angle = np.arcsin(np.sqrt(half_sine**2 + 0.5 * fall))
    mean_sine = np.sin(half_angle + 0.5 * ring.free_contact_angle)
    safe = np.where(mean_sine > 0.0, mean_sine, 1.0)
    return np.asarray(2.0 * np.arcsin(np.minimum(0.5 * fall / safe, 1.0)))


_NEAR_ZERO, _NEAR_INFINITY = 1e-7, 1e7


@frozen
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
