"""Cage and ball speeds of a ball in any attitude, between contacts at any angle and radius.

The contact angles, the rolling radii of the deformed ball and the attitude of its axis (β out of
the shaft's direction in the axial plane, β' out of that plane) are given; that nothing slips along
rolling then fixes all speeds. Seen from the cage,

    e = (d_m/2 + r_o cos α_o)/(r_o (cos β cos β' cos α_o + sin β sin α_o))      ω_R = e ω_o
    i = (d_m/2 - r_i cos α_i)/(r_i (cos β cos β' cos α_i + sin β sin α_i))      ω_R = -i ω_i

so that with the rings' speeds in space ω_R = -(ω_i - ω_o)/(1/e + 1/i) and ω_m = ω_o - ω_R/e. With
α_i = α_o = β = α, β' = 0 and radii D/2 these are the usual cage and ball frequencies.

Source: Braga and Almeida, equations 38, 45 and 48 to 50, with the denominator of (48) corrected.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.vibration.signal import real_numbers

_LEAST: Final = 1e-12
"""Component of the ball's axis along the tangents: what is less is rounding."""


@frozen
class GeneralMotion:
    """Speeds of cage and ball; arrays of one shape, rad/s.

    orbital_speed: ω_m, of the cage, in space; ball_speed: ω_R about the ball's axis, seen from the
    cage, negative where the inner ring alone turns forward.
    """

    orbital_speed: FloatArray
    ball_speed: FloatArray

    def passes(
        self, ball_count: int, inner_speed: ArrayLike, outer_speed: ArrayLike = 0.0
    ) -> tuple[FloatArray, FloatArray]:
        """Balls that pass a point of the outer and of the inner race; Hz.

        inner_speed, outer_speed : of the rings, arrays that broadcast; rad/s.
        """
        scale = ball_count / (2.0 * np.pi)
        return (
            scale * np.abs(np.subtract(self.orbital_speed, outer_speed)),
            scale * np.abs(np.subtract(inner_speed, self.orbital_speed)),
        )


def general_motion(
    pitch_diameter: ArrayLike,
    rolling_radii: tuple[ArrayLike, ArrayLike],
    contact_angles: tuple[ArrayLike, ArrayLike],
    attitude: ArrayLike,
    yaw: ArrayLike,
    inner_speed: ArrayLike,
    outer_speed: ArrayLike = 0.0,
) -> GeneralMotion:
    """Cage and ball speeds without slip along rolling.

    Parameters
    ----------
    pitch_diameter : array, d_m; m.
    rolling_radii : arrays, r_i and r_o, of the deformed ball at the inner and outer contact; m.
    contact_angles : arrays, α_i and α_o; rad.
    attitude, yaw : arrays, β and β'; rad.
    inner_speed, outer_speed : arrays, of the rings in space; rad/s.
        All broadcast against each other.

    Returns
    -------
    GeneralMotion of the broadcast shape; NaN where the ball's axis stands across both tangents,
    and no ring can turn it.
    """

    def numbers(given: ArrayLike, name: str) -> FloatArray:
        return real_numbers(given, name, f"{name} = [0.1, 0.2]")

    pitch = 0.5 * numbers(pitch_diameter, "pitch_diameter")
    inner_radius, outer_radius = (numbers(radius, "rolling_radii") for radius in rolling_radii)
    inner_angle, outer_angle = (numbers(angle, "contact_angles") for angle in contact_angles)
    attitude, yaw = numbers(attitude, "attitude"), numbers(yaw, "yaw")
    inner_speed = numbers(inner_speed, "inner_speed")
    outer_speed = numbers(outer_speed, "outer_speed")
    outer_arm = pitch + outer_radius * np.cos(outer_angle)
    inner_arm = pitch - inner_radius * np.cos(inner_angle)
    # reciprocals of e and i: finite where the ball's axis stands across a tangent
    by_outer = outer_radius * _along(attitude, yaw, outer_angle) / outer_arm
    by_inner = inner_radius * _along(attitude, yaw, inner_angle) / inner_arm
    lead = np.subtract(inner_speed, outer_speed, dtype=np.float64)
    with np.errstate(divide="ignore", invalid="ignore"):
        ball = -lead / (by_outer + by_inner)
        orbit = np.subtract(outer_speed, ball * by_outer)
    lost = np.abs(by_outer + by_inner) < _LEAST
    return GeneralMotion(*np.broadcast_arrays(*(np.where(lost, np.nan, v) for v in (orbit, ball))))


def _along(attitude: ArrayLike, yaw: ArrayLike, angle: ArrayLike) -> FloatArray:
    """Part of the ball's axis along the tangent of a contact."""
    return np.asarray(
        np.cos(attitude) * np.cos(yaw) * np.cos(angle) + np.sin(attitude) * np.sin(angle)
    )
