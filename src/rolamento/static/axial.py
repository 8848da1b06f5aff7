"""A centrally and axially loaded ring: every ball alike, the contact angle rises with load.

The groove centres start A2_0 apart radially and stay so, whence the approach of the races at
contact angle α is δ_n = A2_0/cos α - BD. Equilibrium of the ring is

    F_a = Z K_n δ_n^1.5 sin α.

Source: Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 6; Radaelli (2013), 4.2.2.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.geometry import RingGeometry, ring_geometry
from rolamento.numerics import FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.static._common import (
    BallBearing,
    RaceStiffness,
    StatusArray,
    race_stiffness,
    status_codes,
)

StiffnessAngle = Literal["loaded", "free"]


@dataclass(frozen=True, slots=True)
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

    start = _least_rise(ring, size / (bearing.ball_count * free.combined))

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
        axial_displacement=np.where(idle & ~bad, 0.0, sign * _travel(ring, rise)),
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


def _travel(ring: RingGeometry, rise: FloatArray) -> FloatArray:
    """δ_a = A2_0 tan α - A1_0. Radaelli (2013) eq. 32."""
    free = ring.free_contact_angle
    to_contact = ring.radial_offset * np.tan(free) - ring.axial_offset
    return np.asarray(ring.radial_offset * np.sin(rise) / _cosines(free, rise) + to_contact)


def _cosines(free: float, rise: FloatArray) -> FloatArray:
    return np.asarray(np.cos(free) * np.cos(free + rise))


def _least_rise(ring: RingGeometry, load: FloatArray) -> FloatArray:
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
