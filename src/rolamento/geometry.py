"""The geometry of balls and grooves, and of cones: curvatures, contact angles, clearances.

Pure functions of plain numbers or arrays, and `RingGeometry`, which gathers what the mechanics
of a bearing needs. Angles are counted from the radial plane; conformity is the radius of the
groove over the ball diameter.

Sources: Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 2; Jones (1960).
"""

from __future__ import annotations

from functools import cached_property
from math import pi, sin
from typing import Any, Final, Literal, NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray
from rolamento.numerics.compiled import choose, inline_exact, kernel
from rolamento.numerics.elementwise import of_each
from rolamento.records import frozen

Race = Literal["inner", "outer"]
_END_RADIUS: Final = 0.95
"""Fraction of the distance of the apex: see `usual_end_radius`."""
_APEX_STEPS: Final = 60


@frozen(eq=False, slots=False)
class Angle:
    """An angle, rad, whose cosine and sine are computed once, when they are asked for."""

    value: FloatArray

    @classmethod
    def of(cls, angle: AngleLike) -> Angle:
        """Take it from an array; an angle is returned as it is."""
        return angle if isinstance(angle, Angle) else cls(np.asarray(angle, dtype=np.float64))

    @cached_property
    def cosine(self) -> FloatArray:
        """Cosine of the angle."""
        return np.cos(self.value)

    @cached_property
    def sine(self) -> FloatArray:
        """Sine of the angle."""
        return np.sin(self.value)


AngleLike = ArrayLike | Angle
"""An angle, or numbers of it; rad."""


class BearingGeometry(Protocol):
    """What `ring_geometry` reads of a bearing; lengths in m, angle in rad.

    Exactly one of contact_angle and diametral_clearance is given; the other is None.
    """

    @property
    def ball_diameter(self) -> float:
        """D; m."""
        ...

    @property
    def pitch_diameter(self) -> float:
        """d_m; m."""
        ...

    @property
    def inner_conformity(self) -> float:
        """f_i."""
        ...

    @property
    def outer_conformity(self) -> float:
        """f_o."""
        ...

    @property
    def contact_angle(self) -> float | None:
        """Free contact angle α; rad."""
        ...

    @property
    def diametral_clearance(self) -> float | None:
        """P_d; m, negative for interference."""
        ...


@frozen
class RaceCurvature:
    """Curvatures of a ball against a groove, body by body summed; a hollow counts negative.

    rolling, across : arrays, in the rolling direction and across it; 1/m.
    """

    rolling: FloatArray
    across: FloatArray

    @property
    def sum(self) -> FloatArray:
        """Sum of curvatures Σρ; 1/m. Harris (1991), chapter 2."""
        return self.rolling + self.across

    @property
    def difference(self) -> FloatArray:
        """Relative difference of curvatures F(ρ), in [0, 1). Radaelli (2013) eq. 3."""
        return np.abs(self.rolling - self.across) / self.sum


@frozen
class RingGeometry:
    """What the mechanics needs of a bearing's rings; lengths in m, angle in rad.

    The outer groove centre is the origin; (axial_offset, radial_offset) is where the inner
    groove centre lies before any displacement, as (x, r).
    """

    inner_length: float
    """L_i = (f_i - ½) D, from the ball's centre to the inner groove's, at first contact."""
    outer_length: float
    """L_o = (f_o - ½) D."""
    axial_offset: float
    """A1_0: BD sin α of a bearing given by its contact angle, 0 of one given by clearance."""
    radial_offset: float
    """A2_0: BD cos α, or BD - P_d/2."""
    inner_groove_radius: float
    """R_i, the radius of the circle of inner groove centres about the shaft."""
    free_contact_angle: float
    one_sided: bool
    """Whether only one side of the grooves can touch: a bearing given by an angle above zero."""
    diametral_clearance: float
    """P_d, given, or the one that goes with the contact angle."""
    endplay: float
    """Free axial travel 2 BD sin α of a two-sided ring with this clearance."""

    @property
    def groove_centre_distance(self) -> float:
        """BD, the distance of the groove centres at first contact; m."""
        return self.inner_length + self.outer_length


def total_curvature(inner_conformity: ArrayLike, outer_conformity: ArrayLike) -> FloatArray:
    """Total curvature B = f_i + f_o - 1; dimensionless. Radaelli (2013) eq. 22.

    Parameters: arrays that broadcast. Returns the broadcast shape.

    >>> print(f"{total_curvature(0.52, 0.52):.2f}")
    0.04
    """
    return np.asarray(np.add(inner_conformity, outer_conformity, dtype=np.float64) - 1.0)


def groove_centre_distance(
    ball_diameter: ArrayLike, inner_conformity: ArrayLike, outer_conformity: ArrayLike
) -> FloatArray:
    """Distance BD of the groove centres when the ball touches both grooves unloaded; m.

    Parameters: arrays that broadcast, the diameter in m. Returns the broadcast shape.
    Radaelli (2013) eq. 22.

    >>> print(f"{1e3 * groove_centre_distance(0.02223, 0.5232, 0.5232):.4f} mm")
    1.0315 mm
    """
    return np.asarray(ball_diameter) * total_curvature(inner_conformity, outer_conformity)


def free_contact_angle(
    diametral_clearance: ArrayLike, centre_distance: ArrayLike, shim_angle: ArrayLike = 0.0
) -> FloatArray:
    """Contact angle of an axially taken-up, unloaded ring: cos α = cos α_s - P_d / (2 BD).

    Parameters
    ----------
    diametral_clearance : array, P_d; m. Negative for interference, whose angle is 0.
    centre_distance : array that broadcasts with it, BD; m.
    shim_angle : array, α_s of a four-point bearing, 0 of one groove a ring; rad.

    Returns
    -------
    Angle; rad, the broadcast shape; NaN when the clearance exceeds 2 BD: no angle closes it.

    Harris (1991), chapter 2, as a half-angle so that small clearances keep their precision.
    """
    clearance = np.asarray(diametral_clearance, dtype=np.float64)
    closed = np.sin(0.5 * np.asarray(shim_angle, dtype=np.float64)) ** 2
    half_sine_squared = np.maximum(closed + clearance / (4.0 * np.asarray(centre_distance)), 0.0)
    half_sine_squared = np.where(half_sine_squared <= 0.5, half_sine_squared, np.nan)
    return 2.0 * np.arcsin(np.sqrt(half_sine_squared))


def clearance_of_angle(contact_angle: ArrayLike, centre_distance: ArrayLike) -> FloatArray:
    """Diametral clearance P_d = 2 BD (1 - cos α) that goes with a free contact angle; m.

    Parameters: arrays that broadcast; rad, m. Returns the broadcast shape.
    Harris (1991), chapter 2.

    >>> print(f"{1e3 * clearance_of_angle(np.radians(40.0), 1.0315e-3):.4f} mm")
    0.4827 mm
    """
    half_sine = np.sin(0.5 * np.asarray(contact_angle, dtype=np.float64))
    return np.asarray(4.0 * np.asarray(centre_distance) * half_sine**2)


def sphere_conformity(
    ball_diameter: ArrayLike, pitch_diameter: ArrayLike, tangent: ArrayLike
) -> FloatArray:
    """Radius of a self-aligning bearing's outer race over the ball diameter, d_m/(2 D cos α) + ½.

    Parameters: arrays that broadcast; m, m, and tan α = distance of the rows over d_m. Returns the
    broadcast shape. The sphere's centre, the bearing's, is where the outer groove centre of every
    ball of both rows lies: L_o = (f_o - ½) D = d_m / (2 cos α).
    """
    slope = np.sqrt(1.0 + np.asarray(tangent, dtype=np.float64) ** 2)
    return np.asarray(0.5 * np.asarray(pitch_diameter) / np.asarray(ball_diameter) * slope + 0.5)


def apex_half_angle(
    roller_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    contact_angle: ArrayLike,
    *,
    washers: bool = False,
) -> FloatArray:
    """Half angle φ of a roller whose cone has its apex with those of both raceways; rad.

    Parameters
    ----------
    roller_diameter, pitch_diameter : arrays, D and d_m, at the roller's middle; m.
    contact_angle : array, α, of the outer raceway, from 0 to 90°; rad.
        All broadcast against each other.
    washers : whether α is that of the rollers' axes, as between washers.

    Returns
    -------
    Array of the broadcast shape: the root of tan φ = (D/d_m) sin(α - φ), from 0 to α; between
    washers of tan φ = (D/d_m) sin α.

    From the triangle of apex, roller's middle and its surface.
    """
    diameter, pitch, outer = np.broadcast_arrays(
        *(np.asarray(one, np.float64) for one in (roller_diameter, pitch_diameter, contact_angle))
    )
    ratio = diameter / pitch
    angle = np.arctan(ratio * np.sin(outer))
    if washers:
        return np.asarray(angle)
    for _ in range(_APEX_STEPS):  # Newton; the left side rises, the right side falls with φ
        excess = np.tan(angle) - ratio * np.sin(outer - angle)
        step = excess / (1.0 / np.cos(angle) ** 2 + ratio * np.cos(outer - angle))
        angle = np.clip(angle - step, 0.0, outer)
        if not np.any(np.abs(step) > 1e-16):
            break
    return np.asarray(angle)


def apex_distance(
    roller_diameter: ArrayLike, length: ArrayLike, half_angle: ArrayLike
) -> FloatArray:
    """Distance from the apex of a tapered roller's cone to the roller's large end; m.

    Parameters
    ----------
    roller_diameter, length : arrays, D in the middle of the roller and L from end to end; m.
    half_angle : array, φ, above 0; rad.
        All broadcast against each other.

    Along the roller's axis: D/(2 tan φ) + L/2.

    >>> print(f"{1e3 * apex_distance(0.01, 0.012, np.radians(2.0)):.1f} mm")
    149.2 mm
    """
    slope = np.tan(np.asarray(half_angle, np.float64))
    return np.asarray(0.5 * np.asarray(roller_diameter) / slope + 0.5 * np.asarray(length))


def usual_end_radius(
    roller_diameter: ArrayLike, length: ArrayLike, half_angle: ArrayLike
) -> FloatArray:
    """Radius of the sphere that ends a tapered roller, as is usual where no maker gives it; m.

    Parameters: as of `apex_distance`. Makers publish none. 0.95 of the distance of the apex is the
    upper end of what is published: 0.85, 0.90 and 0.95 are compared in Machines 13 (2025), 910, and
    0.75 to 0.87 are claimed in US patent 6 328 477. A smaller radius thins the film at the rib.
    """
    return np.asarray(_END_RADIUS * apex_distance(roller_diameter, length, half_angle))


def race_curvature(
    ball_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    conformity: ArrayLike,
    contact_angle: AngleLike,
    race: Race,
) -> RaceCurvature:
    """Curvatures of the contact of a ball with one race, at any (loaded) contact angle.

    With γ = D cos α / d_m: in the rolling direction 2/D · 1/(1 - γ) at the inner race and
    2/D · 1/(1 + γ) at the outer; across it 2/D - 1/(f D) at both. An outer race of a conformity
    above 1 is no groove: it is the sphere of a self-aligning bearing, of one radius both ways.

    Parameters
    ----------
    ball_diameter, pitch_diameter : arrays; m.
    conformity : array, of this race; dimensionless.
    contact_angle : array or `Angle`; rad.
    race : "inner" or "outer".

    Returns
    -------
    RaceCurvature of the broadcast shape; 1/m.

    Harris (1991), chapter 2.

    >>> found = race_curvature(0.02223, 0.12526, 0.5232, np.radians(40.0), "inner").rolling
    >>> print(f"{found:.2f} 1/m")
    104.12 1/m
    """
    d, pitch, f = (
        np.asarray(one, dtype=np.float64) for one in (ball_diameter, pitch_diameter, conformity)
    )
    sign = np.asarray(-1.0 if race == "inner" else 1.0)
    cosine = Angle.of(contact_angle).cosine
    rolling, across = of_each(_curvatures, _fill_curvatures, 2, d, pitch, f, cosine, sign)
    return RaceCurvature(*np.broadcast_arrays(rolling, across))


@inline_exact
def _curvatures(
    d: FloatArray, pitch: FloatArray, conformity: FloatArray, cosine: FloatArray, sign: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Along and across rolling; sign: -1 at the inner race, +1 at the outer."""
    rolling = 2.0 / d / (1.0 + sign * (d / pitch * cosine))
    across = (2.0 - 1.0 / conformity) / d
    sphere = (sign > 0.0) & (conformity > 1.0)
    return choose(sphere, across, rolling), across


@kernel
def _fill_curvatures(
    d: FloatArray, pitch: FloatArray, conformity: FloatArray, cosine: FloatArray,
    sign: FloatArray, out: FloatArray,
) -> None:  # fmt: skip
    """Fill out, (2, numbers)."""
    for i in range(d.size):
        out[0, i], out[1, i] = _curvatures(d[i], pitch[i], conformity[i], cosine[i], sign[i])


def ring_geometry(bearing: BearingGeometry) -> RingGeometry:
    """Offsets, angles and clearance of a bearing given by its contact angle or its clearance.

    A bearing given by its contact angle starts at first contact, on the +x side; one given by
    its clearance starts centred, and either side may touch.

    Raises
    ------
    ValueError : if both or neither of contact angle and clearance are given, or the angle is
        outside [0, 90°), or the clearance is too wide for the grooves to be taken up axially.
    """
    distance = bearing.ball_diameter * (bearing.inner_conformity + bearing.outer_conformity - 1.0)
    angle, clearance = _angle_and_clearance(bearing, distance)
    places = groove_places(
        bearing.ball_diameter,
        bearing.pitch_diameter,
        bearing.inner_conformity,
        bearing.outer_conformity,
        contact_angle=bearing.contact_angle,
        diametral_clearance=bearing.diametral_clearance,
    )
    inner_length, outer_length, axial, radial, groove_radius = map(float, places)
    return RingGeometry(
        inner_length=inner_length,
        outer_length=outer_length,
        axial_offset=axial,
        radial_offset=radial,
        inner_groove_radius=groove_radius,
        free_contact_angle=angle,
        one_sided=bearing.contact_angle is not None and angle > 0.0,
        diametral_clearance=clearance,
        endplay=2.0 * distance * sin(angle),
    )


class GroovePlaces(NamedTuple):
    """Where the grooves' centres lie, as the fields of `RingGeometry` have it; arrays, m."""

    inner_length: FloatArray
    outer_length: FloatArray
    axial_offset: FloatArray
    radial_offset: FloatArray
    inner_groove_radius: FloatArray


def groove_places(
    ball_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    inner_conformity: ArrayLike,
    outer_conformity: ArrayLike,
    *,
    contact_angle: ArrayLike | None = None,
    diametral_clearance: ArrayLike | None = None,
    shim_angle: ArrayLike | None = None,
) -> GroovePlaces:
    """Groove lengths, offsets of the groove centres, and the circle of the inner ones; m.

    Parameters: arrays that broadcast; m, rad. Without a contact angle the bearing is given by
    its clearance, and centred; so is a four-point bearing, which has a shim angle and either.
    Returns arrays of the broadcast shape; NaN where no contact angle takes up the clearance.
    Harris (1991), chapter 2; Radaelli (2013) eqs. 22, 65, 66, 81.
    """
    diameter = np.asarray(ball_diameter, dtype=np.float64)
    inner = (np.asarray(inner_conformity) - 0.5) * diameter
    outer = (np.asarray(outer_conformity) - 0.5) * diameter
    distance = inner + outer
    if contact_angle is not None:
        angle = np.asarray(contact_angle, dtype=np.float64)
        axial, radial = distance * np.sin(angle), distance * np.cos(angle)
        axial = axial if shim_angle is None else 0.0 * axial
    else:
        assert diametral_clearance is not None
        closed = 0.0 if shim_angle is None else shim_angle
        clearance = np.asarray(diametral_clearance, dtype=np.float64)
        angle = free_contact_angle(clearance, distance, closed)
        axial, radial = 0.0 * distance, distance * np.cos(closed) - 0.5 * clearance
    radius = 0.5 * np.asarray(pitch_diameter) + inner * np.cos(angle)
    return GroovePlaces(*np.broadcast_arrays(inner, outer, axial, radial, radius))


def edge_cosine(bearing: Any, race: Race) -> FloatArray:
    """Cosine of the angle at which a groove ends: that of its shoulder, or 0.

    cos α = 1 - h / (f D) of a shoulder of height h. A groove without a given height is taken as
    a half circle, so that a contact may lie anywhere below 90°. The angle counts from the deepest
    point: of a thrust bearing from the free contact angle, else from the radial plane.
    """
    radius = getattr(bearing, f"{race}_conformity") * bearing.ball_diameter
    height = getattr(bearing, f"{race}_shoulder_height")
    return np.asarray(0.0 if height is None else np.clip(1.0 - height / radius, 0.0, 1.0))


def _angle_and_clearance(bearing: BearingGeometry, distance: float) -> tuple[float, float]:
    angle, clearance = bearing.contact_angle, bearing.diametral_clearance
    if (angle is None) == (clearance is None):
        raise ValueError("give either contact_angle or diametral_clearance of the bearing")
    if angle is not None:
        if not 0.0 <= angle <= 0.5 * pi:
            raise ValueError(f"contact_angle must lie in [0, 90°], got {angle!r} rad")
        return angle, float(clearance_of_angle(angle, distance))
    assert clearance is not None
    if not clearance < 2.0 * distance:
        raise ValueError(
            f"diametral_clearance {clearance!r} m must stay below twice the distance of the "
            f"groove centres, {2.0 * distance:.3g} m: no contact angle takes it up"
        )
    return float(free_contact_angle(clearance, distance)), clearance
