"""How fast the surfaces of a contact draw the oil in.

The contact travels with the ball about the shaft, so the speeds of both surfaces are taken in the
frame of the cage, at the contact's centre and in the rolling direction:

    ring   v_r = (ω_ring - ω_m) (d_m/2 ∓ (D/2) cos α)        inner -, outer +
    ball   v_b = ∓ (D/2) ω_R (cos β cos β' cos α + sin β sin α)

β' = atan(ω_y/ω_x) is the yaw of the ball's axis, zero under raceway control, where the bracket is
cos(β - α).

The entrainment speed is their *mean*, u = ½ |v_r + v_b|. With rolling at one contact angle both
are equal and u = (d_m/4) (1 - γ²) |ω_i - ω_o| at either race, γ = D cos α / d_m. Some books print
the sum.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento._reach import in_reach
from rolamento.geometry import Race
from rolamento.numerics import FloatArray

_TURN: Final = 2.0 * np.pi
_FASTEST: Final = 1e9
"""rad/s, far beyond any bearing: a number above has the wrong unit."""


@dataclass(frozen=True, slots=True)
class SurfaceSpeeds:
    """Speeds of ring and ball at a contact, seen from it, along rolling; arrays, m/s, signed."""

    ring: FloatArray
    ball: FloatArray

    @property
    def entrainment(self) -> FloatArray:
        """Mean speed u = ½ |v_r + v_b|; m/s. Hamrock and Dowson (1977)."""
        return np.asarray(0.5 * np.abs(self.ring + self.ball))

    @property
    def sliding(self) -> FloatArray:
        """Sliding speed |v_r - v_b|; m/s."""
        return np.asarray(np.abs(self.ring - self.ball))


def surface_speeds(
    race: Race,
    ball_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    contact_angle: ArrayLike,
    ring_speed: ArrayLike,
    orbital_speed: ArrayLike,
    ball_speed: ArrayLike,
    attitude: ArrayLike,
    yaw: ArrayLike = 0.0,
) -> SurfaceSpeeds:
    """Speeds of both surfaces at the centre of a contact.

    Parameters
    ----------
    race : "inner" or "outer".
    ball_diameter, pitch_diameter : arrays; m.
    contact_angle : array, of this contact under load; rad.
    ring_speed : array, of this race's ring about the shaft; rad/s.
    orbital_speed, ball_speed, attitude : arrays, as in `BallMotion`; rad/s, rad/s, rad.
    yaw : array, β' of the ball's axis; rad.
        All broadcast against each other.

    Returns
    -------
    SurfaceSpeeds of the broadcast shape.

    Derivation in docs/theory/film.md.
    """
    side = -1.0 if race == "inner" else 1.0
    radius = 0.5 * in_reach(ball_diameter, "ball_diameter", "m", 0.0, 1e3)
    angle = in_reach(contact_angle, "contact_angle", "rad", -_TURN, _TURN)
    beta = in_reach(attitude, "attitude", "rad", -_TURN, _TURN)
    arm = 0.5 * in_reach(pitch_diameter, "pitch_diameter", "m", 0.0, 1e3)
    arm = arm + side * radius * np.cos(angle)
    orbit = in_reach(orbital_speed, "orbital_speed", "rad/s", -_FASTEST, _FASTEST)
    ring = (in_reach(ring_speed, "ring_speed", "rad/s", -_FASTEST, _FASTEST) - orbit) * arm
    tangent = np.cos(beta) * np.cos(in_reach(yaw, "yaw", "rad", -_TURN, _TURN)) * np.cos(angle)
    tangent = tangent + np.sin(beta) * np.sin(angle)
    ball = (
        side * radius * in_reach(ball_speed, "ball_speed", "rad/s", -_FASTEST, _FASTEST) * tangent
    )
    return SurfaceSpeeds(*np.broadcast_arrays(ring, ball))


def rolling_entrainment_speed(
    pitch_diameter: ArrayLike, gamma: ArrayLike, inner_speed: ArrayLike, outer_speed: ArrayLike
) -> FloatArray:
    """Entrainment speed of pure rolling at one contact angle, (d_m/4)(1 - γ²)|ω_i - ω_o|; m/s.

    Parameters: arrays that broadcast; m, D cos α / d_m, rad/s. Returns the broadcast shape.
    """
    difference = np.abs(np.subtract(inner_speed, outer_speed, dtype=np.float64))
    return np.asarray(0.25 * np.asarray(pitch_diameter) * (1.0 - np.square(gamma)) * difference)
