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

A ball that the inner ring hardly presses on is driven by the cage instead: it takes the cage's
speed, the mean of the orbits of the balls that are held weighted by their loads, and rolls on the
race that it lies on, the outer. In between, with h from 0 to 1 for how firmly the ring holds it,

    ω_m = ω_cage + h (ω_own - ω_cage),    ω_cage = Σ h Q_i ω_own / Σ h Q_i

Under inner control the ball's angular velocity passes over in the same way, to rolling on the
inner race from turning about an axis along the shaft, as a ball does at the bottom of the outer.

The signed gyroscopic moment on the ball is M_g = J ω_R ω_m sin β, about y = r × x at ψ = 0.
Speeds are signed about +x; both rings may turn. The pure-rolling radius is D/2.

Sources: Jones (1959, 1960); Harris, Rolling Bearing Analysis, 3rd ed. (1991);
Radaelli (2013), section 4.3 and appendix A, extended to both rings and to inner control.
"""

from __future__ import annotations

from enum import IntEnum
from typing import Final, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.geometry import Angle, AngleLike, Race
from rolamento.numerics import FloatArray
from rolamento.numerics.compiled import choose, inline_exact, kernel
from rolamento.numerics.elementwise import of_each
from rolamento.numerics.elliptic import complete
from rolamento.records import frozen
from rolamento.validate import within

LEAST_COSINE: Final = -0.5
"""Bound of cos(α_i - α_o): no ball that carries load comes near angles 120° apart, and without
a bound the orbit of one that carries none would have no limit when the outer ring turns."""

_TURN: Final = 2.0 * np.pi
_ROUNDING_OF_ROLL: Final = 1e-12
"""Part of the spin of a contact that a roll is but rounding of."""
_FASTEST: Final = 1e9
"""rad/s, far beyond any bearing: a number above has the wrong unit."""

ControlCodes = NDArray[np.int64]
ControlName = Literal["outer", "inner", "none"]


class RacewayControl(IntEnum):
    """Which race lets the ball roll without spin; the value is σ."""

    OUTER = 1
    INNER = -1
    INDETERMINATE = 0
    """Neither race wins by Jones's criterion, or the moment is shared: moves as under OUTER."""


@frozen
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
        return spin_to_roll(self.inner_spin, self.inner_roll)

    @property
    def outer_spin_to_roll(self) -> FloatArray:
        """Ratio of spin to roll at the outer contact; NaN where nothing rolls."""
        return spin_to_roll(self.outer_spin, self.outer_roll)


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
    whole = codes.dtype.kind == "i" or bool(np.all(np.rint(codes) == codes))
    if not whole or np.any((codes < -1) | (codes > 1)):
        raise ValueError("raceway control codes must be -1, 0 or 1")
    return codes.astype(np.int64, copy=False)


def ball_motion(
    inner_contact_angle: AngleLike,
    outer_contact_angle: AngleLike,
    diameter_ratio: ArrayLike,
    inner_speed: ArrayLike,
    outer_speed: ArrayLike = 0.0,
    control: ControlName | ArrayLike = "outer",
    *,
    orbit: ArrayLike | None = None,
    hold: ArrayLike = 1.0,
) -> BallMotion:
    """Orbit, ball speed and attitude, and spin and roll at both contacts.

    Parameters
    ----------
    inner_contact_angle, outer_contact_angle : arrays or `Angle`; rad.
    diameter_ratio : array, γ' = D/d_m; dimensionless.
    inner_speed, outer_speed : arrays, of the rings about +x; rad/s.
    control : "outer", "inner", "none", or an array of `RacewayControl` codes.
    orbit : array, the balls' speed about the shaft, if the cage has a part in it; rad/s.
        By default raceway control alone decides.
    hold : array from 0 to 1, how firmly the inner ring holds the balls, from `grip`.
        All broadcast against each other.

    Returns
    -------
    BallMotion of the broadcast shape. Where cos(α_i - α_o) is below `LEAST_COSINE` (a ball that
    has lost its inner contact) that bound stands in for it, and the slave contact slips.

    Radaelli (2013) eqs. 43 to 46 for outer control and one ring turning; see the module's head.
    """
    inner, outer = Angle.of(inner_contact_angle), Angle.of(outer_contact_angle)
    ratio = np.asarray(diameter_ratio, dtype=np.float64)
    inner_ring, outer_ring = np.asarray(inner_speed), np.asarray(outer_speed)
    if orbit is None:
        orbit = orbital_speed(inner, outer, ratio, inner_ring, outer_ring, control)
    orbit = np.asarray(orbit, dtype=np.float64)
    axis_x, axis_r, *speeds = of_each(
        _turned, _fill_turned, 7, inner.cosine, inner.sine, outer.cosine, outer.sine, ratio,
        inner_ring, outer_ring, orbit, control_codes(control), np.asarray(hold, dtype=np.float64),
    )  # fmt: skip
    ball_speed, *others = speeds
    return BallMotion(*np.broadcast_arrays(orbit, ball_speed, np.arctan2(axis_r, axis_x), *others))


@inline_exact
def _turned(
    cos_i: FloatArray, sin_i: FloatArray, cos_o: FloatArray, sin_o: FloatArray, ratio: FloatArray,
    inner_ring: FloatArray, outer_ring: FloatArray, orbit: FloatArray, control: FloatArray,
    hold: FloatArray,
) -> tuple[FloatArray, ...]:  # fmt: skip
    """The direction of the ball's axis, along x and inward; then ball speed, spins and rolls."""
    by_outer = control >= 0.0
    on_inner = choose(by_outer, 0.0, hold)
    # what each ring turns faster or slower than the ball orbits, over the difference of both
    relative = outer_ring - inner_ring
    alike = relative == 0.0
    divisor = choose(alike, 1.0, relative)
    ahead = choose(alike, 1.0, (outer_ring - orbit) / divisor)
    behind = choose(alike, 1.0, (orbit - inner_ring) / divisor)
    ahead, behind = (1.0 - on_inner) * ahead, on_inner * behind
    axis_x = ahead * (cos_o + ratio) + behind * (cos_i - ratio)
    axis_r = choose(by_outer, ahead * sin_o, behind * sin_i)
    scale = relative / ratio
    ball_x = orbit + scale * axis_x
    ball_r = -scale * axis_r
    over_inner, over_outer = ball_x - inner_ring, ball_x - outer_ring
    return (
        axis_x,
        axis_r,
        scale * np.sqrt(axis_x * axis_x + axis_r * axis_r),
        over_inner * sin_i + ball_r * cos_i,
        -over_outer * sin_o - ball_r * cos_o,
        over_inner * cos_i - ball_r * sin_i,
        over_outer * cos_o - ball_r * sin_o,
    )


@kernel
def _fill_turned(
    cos_i: FloatArray, sin_i: FloatArray, cos_o: FloatArray, sin_o: FloatArray, ratio: FloatArray,
    inner_ring: FloatArray, outer_ring: FloatArray, orbit: FloatArray, control: FloatArray,
    hold: FloatArray, out: FloatArray,
) -> None:  # fmt: skip
    """Fill out, (7, numbers)."""
    for i in range(orbit.size):
        (
            out[0, i], out[1, i], out[2, i], out[3, i], out[4, i], out[5, i], out[6, i],
        ) = _turned(
            cos_i[i], sin_i[i], cos_o[i], sin_o[i], ratio[i], inner_ring[i], outer_ring[i],
            orbit[i], control[i], hold[i],
        )  # fmt: skip


def orbital_speed(
    inner_contact_angle: AngleLike,
    outer_contact_angle: AngleLike,
    diameter_ratio: ArrayLike,
    inner_speed: ArrayLike,
    outer_speed: ArrayLike = 0.0,
    control: ControlName | ArrayLike = "outer",
) -> FloatArray:
    """Speed ω_m of a ball about the shaft (of the cage); rad/s. As in `ball_motion`.

    >>> print(f"{orbital_speed(0.0, 0.0, 0.2, 100.0):.1f} rad/s")
    40.0 rad/s
    """
    inner, outer = Angle.of(inner_contact_angle), Angle.of(outer_contact_angle)
    rings = (np.asarray(inner_speed), np.asarray(outer_speed))
    ratio = np.asarray(diameter_ratio, dtype=np.float64)
    (orbit,) = of_each(
        _orbit, _fill_orbit, 1, inner.cosine, inner.sine, outer.cosine, outer.sine, ratio, *rings,
        control_codes(control),
    )  # fmt: skip
    return np.asarray(orbit)


@inline_exact
def _orbit(
    cos_i: FloatArray, sin_i: FloatArray, cos_o: FloatArray, sin_o: FloatArray, ratio: FloatArray,
    inner_ring: FloatArray, outer_ring: FloatArray, control: FloatArray,
) -> tuple[FloatArray]:  # fmt: skip
    """ω_m by raceway control, with w the share of the slave ring."""
    by_outer = control >= 0.0
    sigma = choose(by_outer, 1.0, -1.0)
    slave = choose(by_outer, cos_i, cos_o)
    between = cos_i * cos_o + sin_i * sin_o  # cos(α_i - α_o)
    share = (1.0 - sigma * ratio * slave) / (1.0 + np.maximum(between, LEAST_COSINE))
    control_ring = choose(by_outer, outer_ring, inner_ring)
    return (control_ring + sigma * (inner_ring - outer_ring) * share,)


@kernel
def _fill_orbit(
    cos_i: FloatArray, sin_i: FloatArray, cos_o: FloatArray, sin_o: FloatArray, ratio: FloatArray,
    inner_ring: FloatArray, outer_ring: FloatArray, control: FloatArray, out: FloatArray,
) -> None:  # fmt: skip
    """Fill out, (1, numbers)."""
    for i in range(ratio.size):
        (out[0, i],) = _orbit(
            cos_i[i],
            sin_i[i],
            cos_o[i],
            sin_o[i],
            ratio[i],
            inner_ring[i],
            outer_ring[i],
            control[i],
        )


def nominal_orbit(ratio: ArrayLike, inner_speed: ArrayLike, outer_speed: ArrayLike) -> FloatArray:
    """Speed of the cage where both contact angles are alike, ½ ω_i (1 - γ) + ½ ω_o (1 + γ); rad/s.

    Parameters: arrays that broadcast; γ = (D/d_m) cos α, and the rings' speeds in rad/s.
    Harris (1991), eqs. 8.9 and 8.10.

    >>> print(f"{nominal_orbit(0.2, 100.0, 0.0):.1f} rad/s")
    40.0 rad/s
    """
    ratio = np.asarray(ratio, dtype=np.float64)
    inner, outer = np.asarray(inner_speed), np.asarray(outer_speed)
    return np.asarray(0.5 * (inner * (1.0 - ratio) + outer * (1.0 + ratio)))


def grip(load: ArrayLike, rate: ArrayLike, offset: ArrayLike = 0.0) -> FloatArray:
    """How firmly the inner ring holds a ball, from 0 to 1: g² (3 - 2 g) with g = Q_i rate + offset.

    Parameters
    ----------
    load : array, of the inner contact; N.
    rate : array, one over the load that holds firmly; 1/N.
    offset : array; 1 where every ball counts as held.

    Returns
    -------
    Array of the broadcast shape; its slope has no jumps where a ball touches or is held firmly.
    """
    share = np.clip(np.asarray(load) * np.asarray(rate) + np.asarray(offset), 0.0, 1.0)
    return np.asarray(share * share * (3.0 - 2.0 * share))


def cage_speed(
    load: ArrayLike, orbit: ArrayLike, nominal: ArrayLike, weight: ArrayLike
) -> FloatArray:
    """Speed of the cage: the balls' own orbits weighted by their loads; rad/s.

    Parameters
    ----------
    load, orbit : arrays (…, balls), h Q_i (N) and the speed under raceway control (rad/s).
    nominal, weight : arrays (…), the speed that counts with a load of so much (N), so that a
        cage that no ball drives has a speed.

    Returns
    -------
    Array (…).
    """
    load, nominal = np.asarray(load), np.asarray(nominal, dtype=np.float64)
    lag = (load * (np.asarray(orbit) - nominal[..., np.newaxis])).sum(axis=-1)
    total = load.sum(axis=-1) + np.asarray(weight)
    return np.asarray(nominal + np.divide(lag, total, where=total != 0.0, out=np.zeros_like(lag)))


def ball_mass(ball_diameter: ArrayLike, density: ArrayLike) -> FloatArray:
    """Mass of a solid ball, ρ π D³/6; kg. Parameters: arrays that broadcast; m, kg/m³.

    >>> print(f"{1e3 * ball_mass(0.0127, 7810.0):.3f} g")
    8.376 g
    """
    diameter = np.asarray(ball_diameter, dtype=np.float64)
    return np.asarray(np.asarray(density) * np.pi / 6.0 * diameter**3)


def centrifugal_force(
    mass: ArrayLike, pitch_diameter: ArrayLike, orbital_speed: ArrayLike
) -> FloatArray:
    """Centrifugal force on a ball, F_c = ½ m d_m ω_m²; N.

    Parameters: arrays that broadcast; kg, m, rad/s. Returns the broadcast shape.
    Radaelli (2013) eq. 47.

    >>> print(f"{centrifugal_force(0.008, 0.065, 400.0):.1f} N")
    41.6 N
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
    """Minimum coefficient of friction λ |M_g| / (D Q) with which a contact holds its share λ.

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


def spin_to_roll(spin: FloatArray, roll: FloatArray) -> FloatArray:
    """Ratio ω_s/ω_roll of a contact: about its normal over about its tangent; NaN where none rolls.

    None rolls where all that is left of ω_roll is rounding, as at a groove that a free ball does
    not touch, whose angle is ±90°.

    Source: Harris, Rolling Bearing Analysis, 3rd ed. (1991), after Jones (1959).
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        still = np.abs(roll) <= _ROUNDING_OF_ROLL * np.abs(spin)
        return np.asarray(np.where(still, np.nan, spin / roll))


@frozen
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
    contact_angle: AngleLike,
    ring_speed: ArrayLike,
    orbital_speed: ArrayLike,
    ball_speed: ArrayLike,
    attitude: ArrayLike,
    yaw: ArrayLike = 0.0,
) -> SurfaceSpeeds:
    """Speeds of both surfaces at the centre of a contact.

    The contact travels with the ball about the shaft, so both are taken in the frame of the cage
    and in the rolling direction, with β' the yaw of the ball's axis (zero under raceway control):

        ring   v_r = (ω_ring - ω_m) (d_m/2 ∓ (D/2) cos α)        inner -, outer +
        ball   v_b = ∓ (D/2) ω_R (cos β cos β' cos α + sin β sin α)

    The entrainment speed is their *mean*; some books print the sum.

    Parameters
    ----------
    race : "inner" or "outer".
    ball_diameter, pitch_diameter : arrays; m.
    contact_angle : array or `Angle`, of this contact under load; rad.
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
    radius = side * 0.5 * within(ball_diameter, "ball_diameter", "m", 0.0, 1e3)
    given = contact_angle.value if isinstance(contact_angle, Angle) else contact_angle
    checked = within(given, "contact_angle", "rad", -_TURN, _TURN)
    angle = contact_angle if isinstance(contact_angle, Angle) else Angle(checked)
    beta = within(attitude, "attitude", "rad", -_TURN, _TURN)
    pitch = within(pitch_diameter, "pitch_diameter", "m", 0.0, 1e3)
    orbit = within(orbital_speed, "orbital_speed", "rad/s", -_FASTEST, _FASTEST)
    turning = within(ring_speed, "ring_speed", "rad/s", -_FASTEST, _FASTEST)
    aside = within(yaw, "yaw", "rad", -_TURN, _TURN)
    tangent = np.cos(beta - angle.value)
    if aside.any():
        tangent = tangent - np.cos(beta) * angle.cosine * (1.0 - np.cos(aside))
    own = within(ball_speed, "ball_speed", "rad/s", -_FASTEST, _FASTEST)
    speeds = of_each(
        _surfaces, _fill_surfaces, 2, radius, pitch, angle.cosine, turning, orbit, own, tangent
    )
    return SurfaceSpeeds(*np.broadcast_arrays(*speeds))


@inline_exact
def _surfaces(
    radius: FloatArray, pitch: FloatArray, cosine: FloatArray, ring: FloatArray,
    orbit: FloatArray, ball: FloatArray, tangent: FloatArray,
) -> tuple[FloatArray, FloatArray]:  # fmt: skip
    """v_r and v_b; radius: ∓D/2; tangent: the part of the ball's axis along t."""
    return (ring - orbit) * (0.5 * pitch + radius * cosine), radius * ball * tangent


@kernel
def _fill_surfaces(
    radius: FloatArray, pitch: FloatArray, cosine: FloatArray, ring: FloatArray,
    orbit: FloatArray, ball: FloatArray, tangent: FloatArray, out: FloatArray,
) -> None:  # fmt: skip
    """Fill out, (2, numbers)."""
    for i in range(orbit.size):
        out[0, i], out[1, i] = _surfaces(
            radius[i], pitch[i], cosine[i], ring[i], orbit[i], ball[i], tangent[i]
        )


def rolling_entrainment_speed(
    pitch_diameter: ArrayLike, gamma: ArrayLike, inner_speed: ArrayLike, outer_speed: ArrayLike
) -> FloatArray:
    """Entrainment speed of pure rolling at one contact angle, (d_m/4)(1 - γ²)|ω_i - ω_o|; m/s.

    Parameters: arrays that broadcast; m, D cos α / d_m, rad/s. Returns the broadcast shape.

    >>> print(f"{rolling_entrainment_speed(0.065, 0.2, 100.0, 0.0):.3f} m/s")
    1.560 m/s
    """
    difference = np.abs(np.subtract(inner_speed, outer_speed, dtype=np.float64))
    return np.asarray(0.25 * np.asarray(pitch_diameter) * (1.0 - np.square(gamma)) * difference)
