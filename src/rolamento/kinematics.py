"""Motions of a ball between turning rings: orbit, spin about itself, rolling at the contacts.

In the ball's radial plane with unit vectors x (along the shaft) and r (outward), a contact at
angle α has the normal n = (sin α, cos α) and the tangent t = (cos α, -sin α). The control ring
c lets the ball roll without spin: relative to it the ball turns about t_c. With the slave ring
s, γ' = D/d_m, and σ = +1 for outer control, -1 for inner control:

    w   = (1 - σ γ' cos α_s) / (1 + cos(α_i - α_o))
    ω_m = ω_c + (ω_s - ω_c) w                                orbit (cage)
    κ   = σ (ω_c - ω_m)/γ'                                   rolling on the control ring
    Ω   = ω_c x + κ t_c                                      the ball, absolute
    Ω - ω_m x = ω_R (cos β, -sin β)                          the ball, seen from the cage

The signed gyroscopic moment on the ball is M_g = J ω_R ω_m sin β, about y = r × x at ψ = 0.
Speeds are signed about +x; both rings may turn. The pure-rolling radius is D/2.

Sources: Jones (1959, 1960); Harris, Rolling Bearing Analysis, 3rd ed. (1991);
Radaelli (2013), section 4.3 and appendix A, extended to both rings and to inner control.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Final, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.numerics import FloatArray
from rolamento.numerics.elliptic import complete

LEAST_COSINE: Final = -0.5
"""Bound of cos(α_i - α_o): no ball that carries load comes near angles 120° apart, and without
a bound the orbit of one that carries none would have no limit when the outer ring turns."""

ControlCodes = NDArray[np.int64]
ControlName = Literal["outer", "inner", "none"]


class RacewayControl(IntEnum):
    """Which race lets the ball roll without spin; the value is σ."""

    OUTER = 1
    INNER = -1
    INDETERMINATE = 0
    """Neither race wins by Jones's criterion, or the moment is shared: moves as under OUTER."""


@dataclass(frozen=True, slots=True)
class BallMotion:
    """Speeds of balls; arrays of one shape, rad/s and rad."""

    orbital_speed: FloatArray
    """ω_m, of the cage."""
    ball_speed: FloatArray
    """ω_R about the ball's own axis, seen from the cage; negative when only the inner ring
    turns forward: the ball spins against its orbit."""
    attitude: FloatArray
    """β, from the shaft direction to the ball's axis, in (-π, π]."""
    inner_spin: FloatArray
    outer_spin: FloatArray
    """Ball relative to ring about the contact normal that points from the ring into the ball."""
    inner_roll: FloatArray
    outer_roll: FloatArray
    """Ball relative to ring about the tangent t."""

    @property
    def inner_spin_to_roll(self) -> FloatArray:
        """Ratio of spin to roll at the inner contact; NaN where nothing rolls."""
        return _ratio(self.inner_spin, self.inner_roll)

    @property
    def outer_spin_to_roll(self) -> FloatArray:
        """Ratio of spin to roll at the outer contact; NaN where nothing rolls."""
        return _ratio(self.outer_spin, self.outer_roll)


def control_codes(control: ControlName | ArrayLike) -> ControlCodes:
    """`RacewayControl` codes from a name or from codes; "none" becomes INDETERMINATE.

    Raises
    ------
    ValueError : for an unknown name or code. ("jones" is decided by `jones_control`.)
    """
    names = {"outer": 1, "inner": -1, "none": 0}
    if isinstance(control, str):
        if control not in names:
            raise ValueError(f"raceway control must be one of {sorted(names)}, got {control!r}")
        return np.asarray(names[control], dtype=np.int64)
    codes = np.asarray(control)
    if not np.all(np.isin(codes, list(names.values()))):
        raise ValueError("raceway control codes must be -1, 0 or 1")
    return codes.astype(np.int64)


def ball_motion(
    inner_contact_angle: ArrayLike,
    outer_contact_angle: ArrayLike,
    diameter_ratio: ArrayLike,
    inner_speed: ArrayLike,
    outer_speed: ArrayLike = 0.0,
    control: ControlName | ArrayLike = "outer",
) -> BallMotion:
    """Orbit, ball speed and attitude, and spin and roll at both contacts.

    Parameters
    ----------
    inner_contact_angle, outer_contact_angle : arrays; rad.
    diameter_ratio : array, γ' = D/d_m; dimensionless.
    inner_speed, outer_speed : arrays, of the rings about +x; rad/s.
    control : "outer", "inner", "none", or an array of `RacewayControl` codes.
        All broadcast against each other.

    Returns
    -------
    BallMotion of the broadcast shape. Where cos(α_i - α_o) is below `LEAST_COSINE` (a ball that
    has lost its inner contact) that bound stands in for it, and the slave contact slips.

    Radaelli (2013) eqs. 43 to 46 for outer control and one ring turning; see the module's head.
    """
    sigma = _sigma(control)
    inner, outer = np.asarray(inner_contact_angle), np.asarray(outer_contact_angle)
    ratio = np.asarray(diameter_ratio, dtype=np.float64)
    inner_ring, outer_ring = np.asarray(inner_speed), np.asarray(outer_speed)
    angle = np.where(sigma > 0, outer, inner)
    control_ring = np.where(sigma > 0, outer_ring, inner_ring)

    share = _slave_share(inner, outer, ratio, sigma)
    orbit = control_ring + sigma * (inner_ring - outer_ring) * share
    rolling = sigma * (control_ring - orbit) / ratio
    ball_x = control_ring + rolling * np.cos(angle)
    ball_r = -rolling * np.sin(angle)
    axis_x, axis_r = np.cos(angle) + sigma * ratio, np.sin(angle)
    fields = np.broadcast_arrays(
        orbit,
        rolling * np.hypot(axis_x, axis_r),
        np.arctan2(axis_r, axis_x),
        (ball_x - inner_ring) * np.sin(inner) + ball_r * np.cos(inner),
        -(ball_x - outer_ring) * np.sin(outer) - ball_r * np.cos(outer),
        (ball_x - inner_ring) * np.cos(inner) - ball_r * np.sin(inner),
        (ball_x - outer_ring) * np.cos(outer) - ball_r * np.sin(outer),
    )
    return BallMotion(*fields)


def orbital_speed(
    inner_contact_angle: ArrayLike,
    outer_contact_angle: ArrayLike,
    diameter_ratio: ArrayLike,
    inner_speed: ArrayLike,
    outer_speed: ArrayLike = 0.0,
    control: ControlName | ArrayLike = "outer",
) -> FloatArray:
    """Speed ω_m of a ball about the shaft (of the cage); rad/s. As in `ball_motion`."""
    sigma = _sigma(control)
    inner_ring, outer_ring = np.asarray(inner_speed), np.asarray(outer_speed)
    share = _slave_share(
        np.asarray(inner_contact_angle),
        np.asarray(outer_contact_angle),
        np.asarray(diameter_ratio, dtype=np.float64),
        sigma,
    )
    control_ring = np.where(sigma > 0, outer_ring, inner_ring)
    return np.asarray(control_ring + sigma * (inner_ring - outer_ring) * share)


def ball_mass(ball_diameter: ArrayLike, density: ArrayLike) -> FloatArray:
    """Mass of a solid ball, ρ π D³/6; kg. Parameters: arrays that broadcast; m, kg/m³."""
    diameter = np.asarray(ball_diameter, dtype=np.float64)
    return np.asarray(np.asarray(density) * np.pi / 6.0 * diameter**3)


def centrifugal_force(
    mass: ArrayLike, pitch_diameter: ArrayLike, orbital_speed: ArrayLike
) -> FloatArray:
    """Centrifugal force on a ball, F_c = ½ m d_m ω_m²; N.

    Parameters: arrays that broadcast; kg, m, rad/s. Returns the broadcast shape.
    Radaelli (2013) eq. 47.
    """
    speed = np.asarray(orbital_speed, dtype=np.float64)
    return np.asarray(0.5 * np.asarray(mass) * np.asarray(pitch_diameter) * speed**2)


def gyroscopic_moment(mass: ArrayLike, ball_diameter: ArrayLike, motion: BallMotion) -> FloatArray:
    """Signed gyroscopic moment on a ball, M_g = J ω_R ω_m sin β with J = m D²/10; N·m.

    Negative when only the inner ring turns and the contact angle is positive. Its size alone
    is not enough: with the wrong sign the balance of the ball is wrong.

    Parameters
    ----------
    mass, ball_diameter : arrays that broadcast with the motion; kg, m.
    motion : from `ball_motion`.

    Returns
    -------
    M_g of the broadcast shape. In ring speeds it is -J (ω_i - ω_o) ω_m w sin α_c/γ'.

    Jones (1960); Harris (1991), which gives its size.
    """
    inertia = np.asarray(mass) * np.asarray(ball_diameter, dtype=np.float64) ** 2 / 10.0
    return np.asarray(inertia * motion.ball_speed * motion.orbital_speed * np.sin(motion.attitude))


def spin_resistance(load: ArrayLike, semi_major: ArrayLike, ellipticity: ArrayLike) -> FloatArray:
    """Resistance Q a E of a contact to spin; (3/8) μ times it is the friction moment; N·m.

    Parameters
    ----------
    load, semi_major, ellipticity : arrays that broadcast; N, m, a/b ≥ 1.

    Returns
    -------
    Q a E(m) with m = 1 - (b/a)²; the broadcast shape.

    Jones (1959); Harris (1991).
    """
    second = complete(1.0 / np.asarray(ellipticity, dtype=np.float64) ** 2)[1]
    return np.asarray(np.asarray(load) * np.asarray(semi_major) * second)


def jones_control(
    inner_resistance: ArrayLike,
    outer_resistance: ArrayLike,
    inner_contact_angle: ArrayLike,
    outer_contact_angle: ArrayLike,
) -> ControlCodes:
    """Which race controls a ball by Jones's criterion, as `RacewayControl` codes.

    A race controls if it can turn the ball against the other's resistance to spin: the outer if
    Q_o a_o E_o cos(α_i - α_o) > Q_i a_i E_i, the inner with the roles exchanged, else neither.

    Parameters
    ----------
    inner_resistance, outer_resistance : arrays, Q a E from `spin_resistance`; N·m.
    inner_contact_angle, outer_contact_angle : arrays; rad.

    Returns
    -------
    Codes of the broadcast shape.

    Jones (1959); Harris (1991).
    """
    cosine = np.cos(np.asarray(inner_contact_angle) - np.asarray(outer_contact_angle))
    inner, outer = np.asarray(inner_resistance), np.asarray(outer_resistance)
    codes = np.where(outer * cosine > inner, RacewayControl.OUTER, RacewayControl.INDETERMINATE)
    codes = np.where(inner * cosine > outer, RacewayControl.INNER, codes)
    return np.asarray(codes, dtype=np.int64)


def friction_demand(
    gyroscopic_moment: ArrayLike, ball_diameter: ArrayLike, load: ArrayLike, share: ArrayLike = 2.0
) -> FloatArray:
    """Least coefficient of friction λ |M_g| / (D Q) with which a contact holds its share λ.

    Parameters
    ----------
    gyroscopic_moment, ball_diameter, load : arrays that broadcast; N·m, m, N.
    share : λ of this contact; 2 where it carries the whole moment, 1 where both share it.

    Returns
    -------
    Coefficient of the broadcast shape; 0 without a moment, infinite without load.

    From the balance of moments on the ball, Harris (1991).
    """
    force = np.asarray(share) * np.abs(gyroscopic_moment) / np.asarray(ball_diameter)
    load = np.asarray(load, dtype=np.float64)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(force == 0.0, 0.0, force / load)


def _sigma(control: ControlName | ArrayLike) -> FloatArray:
    return np.where(control_codes(control) < 0, -1.0, 1.0)


def _slave_share(
    inner: FloatArray, outer: FloatArray, ratio: FloatArray, sigma: FloatArray
) -> FloatArray:
    """w, the share of the slave ring's speed in the orbit."""
    slave = np.where(sigma > 0, inner, outer)
    cosine = np.maximum(np.cos(inner - outer), LEAST_COSINE)
    return np.asarray((1.0 - sigma * ratio * np.cos(slave)) / (1.0 + cosine))


def _ratio(spin: FloatArray, roll: FloatArray) -> FloatArray:
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(np.where(roll == 0.0, np.nan, spin / roll))
