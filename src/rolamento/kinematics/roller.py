"""Motions of a roller between turning rings: orbit, spin about its axis, sliding at its end.

In the roller's axial plane (x along the shaft, r outward) its axis is a = (cos β, -sin β); with the
half angle φ of its taper the raceways stand at α_i = β - φ and α_o = β + φ, with the normals
n = (sin α, cos α) and the tangents t = (cos α, -sin α). The large end of a positive contact angle
lies toward -x. Nothing slips at the middle of both contact lines, so that with γ = (D/d_m) cos β

    ω_m = ½ (1 - γ) ω_i + ½ (1 + γ) ω_o                      orbit (cage)
    ω_R = -½ (d_m/D) (1 - γ²) (ω_i - ω_o)                    the roller about a, seen from the cage

Seen from a ring, the roller turns by roll about t and spin about n, so that the surfaces slide by
spin·s at s from the middle of the line. Cones with one apex, tan φ = (D/d_m) sin β, have no spin
and roll all along; then

    ω_m = (ω_i sin α_i + ω_o sin α_o)/(sin α_i + sin α_o)

which the above is for them, whatever the numbers; β = φ = 0 is the cylinder. There is no skew.

Sources: Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 8, for γ; the rest from no slip,
derived in docs/theory/kinematics.md.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from rolamento.geometry import Race
from rolamento.kinematics.ball import BallMotion, nominal_orbit
from rolamento.numerics import FloatArray
from rolamento.records import frozen

__all__ = [
    "RibMotion",
    "RollerBody",
    "apex_mismatch",
    "rib_motion",
    "roller_body",
    "roller_gyroscopic_moment",
    "roller_motion",
]


@frozen
class RibMotion:
    """Motion where a roller's end touches a rib; arrays of one shape.

    sliding: speed of the end along the rib, m/s, at least 0. entrainment: mean of both surfaces'
    speeds along the rib, seen from the contact, m/s, at least 0. spin: of the end against the rib
    about their common normal, rad/s, signed.
    """

    sliding: FloatArray
    entrainment: FloatArray
    spin: FloatArray


@frozen
class RollerBody:
    """Mass of a roller; arrays of one shape.

    mass: kg. centroid: from the middle toward the large end, m. polar_inertia,
    transverse_inertia: about its axis, and across it about the centroid, kg·m².
    """

    mass: FloatArray
    centroid: FloatArray
    polar_inertia: FloatArray
    transverse_inertia: FloatArray


def roller_motion(
    roller_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    axis_angle: ArrayLike,
    half_angle: ArrayLike,
    inner_speed: ArrayLike,
    outer_speed: ArrayLike = 0.0,
) -> BallMotion:
    """Orbit, speed about its axis, and spin and roll at both contact lines of a roller.

    Parameters
    ----------
    roller_diameter, pitch_diameter : arrays, D and d_m, at the roller's middle; m.
    axis_angle : array, β, from the shaft to the roller's axis; rad. 0 of a cylindrical roller.
    half_angle : array, φ, of the roller's taper; rad. 0 of a cylinder.
    inner_speed, outer_speed : arrays, of the rings about +x; rad/s.
        All broadcast against each other.

    Returns
    -------
    BallMotion of the broadcast shape, with β as the attitude.

    See the module's head.
    """
    diameter, pitch = _numbers(roller_diameter, pitch_diameter)
    axis, taper, inner_ring, outer_ring = _numbers(axis_angle, half_angle, inner_speed, outer_speed)
    gamma = diameter / pitch * np.cos(axis)
    orbit = nominal_orbit(gamma, inner_ring, outer_ring)
    speed = 0.5 * pitch / diameter * (1.0 - gamma**2) * (outer_ring - inner_ring)
    along, across = speed * np.cos(axis), -speed * np.sin(axis)
    inner, outer = axis - taper, axis + taper
    fields = np.broadcast_arrays(
        orbit,
        speed,
        axis,
        (orbit - inner_ring + along) * np.sin(inner) + across * np.cos(inner),
        -(orbit - outer_ring + along) * np.sin(outer) - across * np.cos(outer),
        (orbit - inner_ring + along) * np.cos(inner) - across * np.sin(inner),
        (orbit - outer_ring + along) * np.cos(outer) - across * np.sin(outer),
    )
    return BallMotion(*fields)


def apex_mismatch(
    roller_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    axis_angle: ArrayLike,
    half_angle: ArrayLike,
) -> FloatArray:
    """Part by which the taper of a roller misses that of cones with one apex.

    Parameters: arrays that broadcast, as of `roller_motion`. Returns
    tan φ / ((D/d_m) sin β) - 1 of the broadcast shape; 0 of a cylinder along the shaft.
    """
    diameter, pitch, axis, taper = _numbers(roller_diameter, pitch_diameter, axis_angle, half_angle)
    wanted = diameter / pitch * np.sin(axis)
    has_none = (wanted == 0.0) & (np.tan(taper) == 0.0)
    with np.errstate(divide="ignore"):
        ratio = np.tan(taper) / np.where(has_none, 1.0, wanted)
    return np.asarray(np.where(has_none, 0.0, ratio - 1.0))


def rib_motion(
    race: Race,
    roller_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    roller_length: ArrayLike,
    axis_angle: ArrayLike,
    half_angle: ArrayLike,
    rib_height: ArrayLike,
    inner_speed: ArrayLike,
    outer_speed: ArrayLike = 0.0,
    roller_end_radius: ArrayLike = np.inf,
) -> RibMotion:
    """Sliding, entrainment and spin where a roller's large end touches a rib of a ring.

    Seen from the ring, the roller turns about its contact line. So the end slides over the rib by

        v = |roll h + spin s|

    at the height h above the raceway, s along it from the middle; cones with one apex, and
    cylinders, have v = |roll| h. With the normal at θ = asin(ρ/R) to the roller's axis, R the
    radius of the end and ρ where it is touched, the end spins by roll cos(φ - θ) - spin sin(φ - θ).

    Parameters
    ----------
    race : "inner" or "outer", of the ring that has the rib.
    roller_diameter, pitch_diameter : arrays, D and d_m, at the roller's middle; m.
    roller_length : array, along its axis, from end to end; m.
    axis_angle, half_angle : arrays, β and φ; rad.
    rib_height : array, h, of the contact above the raceway of the ring, square to it; m.
    inner_speed, outer_speed : arrays, of the rings about +x; rad/s.
    roller_end_radius : array, R, of the sphere of the roller's end; m. By default a plane end.
        All broadcast against each other.

    Returns
    -------
    RibMotion of the broadcast shape; spin is NaN where no point of the sphere lies so far out.

    Derivation in docs/theory/kinematics.md.
    """
    motion = roller_motion(
        roller_diameter, pitch_diameter, axis_angle, half_angle, inner_speed, outer_speed
    )
    diameter, pitch, length, axis, taper, height, end = _numbers(
        roller_diameter,
        pitch_diameter,
        roller_length,
        axis_angle,
        half_angle,
        rib_height,
        roller_end_radius,
    )
    side = -1.0 if race == "inner" else 1.0
    angle = axis + side * taper
    roll, spin, ring = (
        (motion.inner_roll, motion.inner_spin, np.asarray(inner_speed))
        if race == "inner"
        else (motion.outer_roll, motion.outer_spin, np.asarray(outer_speed))
    )
    place = 0.5 * length / np.cos(taper) - height * np.tan(taper)
    slide = roll * height + spin * place
    radius = 0.5 * (pitch + side * diameter * np.cos(axis))
    radius = radius + place * np.sin(angle) - side * height * np.cos(angle)
    ring_surface = (ring - motion.orbital_speed) * radius
    off_axis = 0.5 * diameter + 0.5 * length * np.tan(taper) - height / np.cos(taper)
    with np.errstate(invalid="ignore"):
        lean = taper - np.arcsin(off_axis / end)
    return RibMotion(
        *np.broadcast_arrays(
            np.abs(slide),
            np.abs(ring_surface - 0.5 * side * slide),
            roll * np.cos(lean) - spin * np.sin(lean),
        )
    )


def roller_body(
    roller_diameter: ArrayLike,
    roller_length: ArrayLike,
    half_angle: ArrayLike,
    density: ArrayLike,
) -> RollerBody:
    """Mass, centroid and moments of inertia of a solid cylinder or frustum of a cone.

    Parameters
    ----------
    roller_diameter : array, D, at the middle; m.
    roller_length : array, L, along the axis; m.
    half_angle : array, φ; rad.
    density : array; kg/m³.
        All broadcast against each other.

    Returns
    -------
    RollerBody of the broadcast shape. m = ρ π L (R² + e²/3) with R = D/2 and e = (L/2) tan φ.

    Integrals of r², s r², r⁴ and s² r² over the length, with r = R + s tan φ.
    """
    diameter, length, taper, mass_density = _numbers(
        roller_diameter, roller_length, half_angle, density
    )
    radius, rise = 0.5 * diameter, 0.5 * length * np.tan(taper)
    slab, half = mass_density * np.pi * length, 0.5 * length
    mass = slab * (radius**2 + rise**2 / 3.0)
    centroid = slab * half * 2.0 * radius * rise / 3.0 / mass
    fourth = slab * (radius**4 + 2.0 * radius**2 * rise**2 + rise**4 / 5.0)
    second = slab * half**2 * (radius**2 / 3.0 + rise**2 / 5.0)
    return RollerBody(
        *np.broadcast_arrays(
            mass, centroid, 0.5 * fourth, 0.25 * fourth + second - mass * centroid**2
        )
    )


def roller_gyroscopic_moment(body: RollerBody, motion: BallMotion) -> FloatArray:
    """Signed gyroscopic moment on a roller about y = r × x; N·m.

    M_g = ω_m sin β [J_p ω_R + (J_p - J_t) ω_m cos β], which of a ball, J_p = J_t, is that of
    `kinematics.gyroscopic_moment`. It tilts the roller; 0 where its axis is along the shaft.

    Parameters
    ----------
    body : from `roller_body`.
    motion : from `roller_motion`, that broadcasts with it.

    Returns
    -------
    Array of the broadcast shape. From dH/dt = ω_m x × H of a body of revolution.
    """
    orbit, beta = motion.orbital_speed, motion.attitude
    spin = body.polar_inertia * motion.ball_speed
    carried = (body.polar_inertia - body.transverse_inertia) * orbit * np.cos(beta)
    return np.asarray(orbit * np.sin(beta) * (spin + carried))


def _numbers(*given: ArrayLike) -> tuple[FloatArray, ...]:
    return tuple(np.asarray(one, dtype=np.float64) for one in given)
