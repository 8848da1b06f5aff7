"""From a bearing to the numbers of a row of rollers: geometry in the roller's own plane.

Axis t = (cos β, -sin β) and normal n = (sin β, cos β) of a roller in (x, r), with β = α_o - φ; the
contacts' normals are e_i = n cos φ - t sin φ and e_o = n cos φ + t sin φ, their directions along
the raceway stand across those. The large end of a tapered roller lies toward -x, the rib of the
inner ring behind it. The rib's normal f stands at ε over t: from the point of contact, d = R_large
- h under the axis, through the centre of the spherical end of radius R_s, sin ε = d/R_s.

Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapters 2 and 8; docs/theory/rollers.md.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import RowPlace
from rolamento.contact.coupled import body_term, influence_table, scratch
from rolamento.contact.hertz import effective_modulus
from rolamento.contact.line import contact_constant, roller_share, slice_places
from rolamento.contact.profile import drop
from rolamento.geometry import Race
from rolamento.kinematics import BallMotion, centrifugal_force
from rolamento.numerics import FloatArray
from rolamento.roller_kinematics import roller_body, roller_gyroscopic_moment, roller_motion
from rolamento.rows.roller import layout
from rolamento.rows.roller.roller import Line

__all__ = ["RIB_HEIGHT", "Cut", "Numbers", "numbers_of"]

RIB_HEIGHT: Final = 0.1
"""Of the roller's diameter: where a rib touches if the bearing does not say; general knowledge of
how high ribs are (a fifth of the diameter), not a figure of a source."""


@dataclass(frozen=True, slots=True)
class Cut:
    """The contacts along the roller, cut into slices; (cases or 1, …), m and 1/m.

    place: x_k (…, n); drops, curvature, body: of the inner and the outer contact, (…, 2, n).
    """

    coupled: bool
    place: FloatArray
    drops: FloatArray
    curvature: FloatArray
    body: FloatArray
    table: FloatArray

    @property
    def slices(self) -> int:
        """How many."""
        return int(self.place.shape[-1])

    def lines(self) -> Line:
        """For the kernels, with scratch of its own."""
        n = self.slices if self.coupled else 1
        return (
            self.coupled, self.place, self.drops, self.curvature, self.body, self.table,
            scratch(n),
        )  # fmt: skip

    def part(self, index: Any) -> Cut:
        """Of some of the cases."""
        place, drops, curvature, body = (
            a if len(a) == 1 else a[index]
            for a in (self.place, self.drops, self.curvature, self.body)
        )
        return Cut(self.coupled, place, drops, curvature, body, self.table)


@dataclass(frozen=True, slots=True)
class Numbers:
    """The numbers of a row in many cases: columns of `layout`, slices, and what tables need.

    motion, centrifugal and gyroscopic (N, N·m, as they are shown), modulus, axis (β), half_angle
    and rib_angle (ε), rib_arm (of the rib's force about the roller's centre): (cases,).
    """

    p: FloatArray
    cut: Cut
    motion: BallMotion
    centrifugal: FloatArray
    gyroscopic: FloatArray
    modulus: FloatArray
    axis: FloatArray
    half_angle: FloatArray
    rib_angle: FloatArray
    rib_arm: FloatArray
    tapered: bool


def numbers_of(
    case: Case, place: RowPlace, bearing: Any, varied: Mapping[str, FloatArray], cases: int
) -> Numbers:
    """Make the numbers; bearing: the fields of `RollerBearing`, numbers or arrays (cases,)."""

    def column(value: Any) -> FloatArray:
        return np.array(np.broadcast_to(np.asarray(value, np.float64), cases))

    tapered = place.bearing.element == "tapered"
    duty, model = case.duty, case.model
    diameter, pitch = column(bearing.roller_diameter), column(bearing.pitch_diameter)
    length = column(bearing.effective_length)
    whole = length if bearing.roller_length is None else column(bearing.roller_length)
    outer = column(bearing.contact_angle if tapered else 0.0)
    half = column(bearing.roller_half_angle if tapered else 0.0)
    axis = outer - half
    height = RIB_HEIGHT * diameter if bearing.rib_height is None else column(bearing.rib_height)
    epsilon, arm = _rib_normal(bearing, diameter, whole, half, height, tapered)
    modulus = column(effective_modulus(bearing.ring_material, bearing.roller_material))
    constant = contact_constant(length, modulus)
    speeds = [column(varied.get(f"duty.{n}", getattr(duty, n))) for n in _SPEEDS]
    motion = roller_motion(diameter, pitch, axis, half, *speeds)
    body = roller_body(diameter, whole, half, column(bearing.roller_material.density))
    force = centrifugal_force(body.mass, pitch, motion.orbital_speed)
    moment = roller_gyroscopic_moment(body, motion)
    first = varied.get("duty.first_ball_azimuth", np.asarray(duty.first_ball_azimuth))

    p = np.zeros((layout.COLUMN, cases))
    radius = 0.5 * diameter
    p[layout.ARM] = 0.5 * pitch
    p[layout.DIAMETER], p[layout.LENGTH] = diameter, length
    p[layout.OUTER_SINE], p[layout.OUTER_COSINE] = np.sin(outer), np.cos(outer)
    p[layout.LEVER] = radius * np.sin(half)
    p[layout.INNER_SHIFT] = -np.cos(half - epsilon)
    p[layout.INNER_TURN] = arm * np.sin(epsilon - half) - p[layout.LEVER]
    p[layout.OUTER_SHIFT] = np.cos(half + epsilon)
    p[layout.OUTER_TURN] = p[layout.LEVER] - arm * np.sin(half + epsilon)
    p[layout.INNER_CONSTANT] = p[layout.OUTER_CONSTANT] = constant
    p[layout.GAP] = 0.0 if tapered else 0.25 * column(bearing.diametral_clearance)
    p[layout.CENTRIFUGAL] = model.centrifugal_force * force
    p[layout.CENTRIFUGAL_SHIFT] = np.cos(axis - epsilon)
    p[layout.CENTRIFUGAL_TURN] = arm * np.sin(axis - epsilon)
    # M_g is what turns the roller's momentum; the roller resists it
    p[layout.GYROSCOPIC] = -model.gyroscopic_moment * moment
    if not tapered:
        ahead, behind = _opposed_ribs(bearing)
        stiffness = _rib_stiffness(diameter, height, modulus)
        p[layout.RIB_AHEAD], p[layout.RIB_BEHIND] = ahead * stiffness, behind * stiffness
        p[layout.RIB_LEVER] = (radius - height) * (ahead or behind)
        play = getattr(bearing, "axial_play", None)
        p[layout.RIB_PLAY] = 0.0 if play is None else 0.5 * column(play)
    p[layout.COS_FIRST], p[layout.SIN_FIRST] = (
        np.cos(first + place.phase),
        np.sin(first + place.phase),
    )
    p[layout.COMPLIANCE] = 2.0 / (np.pi * modulus)
    return Numbers(
        p=p,
        cut=_cut(case, bearing, p, half, axis, modulus),
        motion=motion,
        centrifugal=p[layout.CENTRIFUGAL].copy(),
        gyroscopic=-p[layout.GYROSCOPIC],
        modulus=modulus,
        axis=axis,
        half_angle=half,
        rib_angle=epsilon,
        rib_arm=arm if tapered else -2.0 * p[layout.RIB_LEVER],
        tapered=tapered,
    )


_SPEEDS: Final = ("inner_speed", "outer_speed")


def _rib_normal(
    bearing: Any,
    diameter: FloatArray,
    length: FloatArray,
    half: FloatArray,
    height: FloatArray,
    tapered: bool,
) -> tuple[FloatArray, FloatArray]:
    """ε of the rib's normal, and the arm of its force about the roller's centre (of r × x).

    An end without a radius is a sphere about the apex of the roller's cone. The arm is that of
    f_x p_r - f_r p_x at the contact, which lies at -(L/2) t - d n.
    """
    if not tapered:
        return np.zeros_like(diameter), np.zeros_like(diameter)
    below = 0.5 * diameter + 0.5 * length * np.tan(half) - height
    given = bearing.roller_end_radius
    sphere = 0.5 * diameter / np.tan(half) + 0.5 * length if given is None else given
    sine = np.where(below < sphere, below / sphere, np.nan)
    return np.arcsin(sine), 0.5 * length * sine - below * np.sqrt(1.0 - sine**2)


def _opposed_ribs(bearing: Any) -> tuple[bool, bool]:
    """Whether ribs of both rings carry axial load toward +x, and toward -x.

    The inner ring's rib behind the roller pushes it against the outer ring's before it.
    """
    inner, outer = bearing.inner_ribs, bearing.outer_ribs
    return (
        inner in ("-", "both") and outer in ("+", "both"),
        inner in ("+", "both") and outer in ("-", "both"),
    )


def _rib_stiffness(diameter: FloatArray, height: FloatArray, modulus: FloatArray) -> FloatArray:
    """Stiffness of both ribs of a cylindrical roller in line (N/m).

    Each end presses on a rib of twice the contact's height with a segment of its circle, taken for
    a flat round punch of the same area A: F = E' a δ, a = √(A/π), E' twice Johnson's E*.
    Johnson, Contact Mechanics (1985), eq. 3.36; Boussinesq (1885).
    """
    radius = 0.5 * diameter
    part = np.clip(1.0 - 2.0 * height / radius, -1.0, 1.0)
    area = radius**2 * (np.arccos(part) - part * np.sqrt(1.0 - part**2))
    return np.asarray(0.5 * modulus * np.sqrt(area / np.pi))


def _cut(
    case: Case,
    bearing: Any,
    p: FloatArray,
    half: FloatArray,
    axis: FloatArray,
    modulus: FloatArray,
) -> Cut:
    """Cut the contacts into slices; what is alike in all cases is kept once."""
    slices = case.model.slices
    coupled = case.model.roller_contact == "coupled"
    length, diameter, pitch = p[layout.LENGTH], p[layout.DIAMETER], 2.0 * p[layout.ARM]
    same = all(bool((a == a[:1]).all()) for a in (length, diameter, pitch, half, axis, modulus))
    some = slice(0, 1) if same else slice(None)
    length, diameter, pitch, half, axis = (a[some] for a in (length, diameter, pitch, half, axis))
    place = slice_places(length, slices)
    tapered = bool((half > 0.0).any())
    sizes = {"length": length[:, np.newaxis], "diameter": diameter[:, np.newaxis]}
    roller = drop(bearing.roller_profile, place, tapered=tapered, **sizes)
    races = [
        drop(getattr(bearing, f"{race}_profile"), place, tapered=tapered, **sizes)
        for race in ("inner", "outer")
    ]
    drops = np.stack([roller + race for race in races], axis=1)
    curvature = np.stack(
        [_curvature(race, place, diameter, pitch, half, axis) for race in ("inner", "outer")],
        axis=1,
    )  # fmt: skip
    table = influence_table(slices) if coupled else np.zeros((1, 2, 1))
    body = np.zeros((1, 2, 1))
    if coupled:
        share = roller_share(bearing.roller_material, bearing.ring_material)
        shares = np.broadcast_to(np.asarray(share), len(modulus))[some]
        body = np.stack(
            [
                np.tile(body_term(slices, float(long) / slices, float(wide), float(s)), (2, 1))
                for long, wide, s in zip(length, diameter, shares, strict=True)
            ]
        )
    return Cut(coupled, place, drops, curvature, body, table)


def _curvature(
    race: Race,
    place: FloatArray,
    diameter: FloatArray,
    pitch: FloatArray,
    half: FloatArray,
    axis: FloatArray,
) -> FloatArray:
    """Σρ of roller and race along rolling at every slice; (…, n), 1/m.

    Of cones, whose radius of curvature is that across the axis over the cosine of the cone's angle.
    """
    diameter, pitch, half, axis = (a[:, np.newaxis] for a in (diameter, pitch, half, axis))
    sign = 1.0 if race == "outer" else -1.0
    angle = axis + sign * half
    roller = (0.5 * diameter - place * np.sin(half)) / np.cos(half)
    ring = 0.5 * pitch + sign * 0.5 * diameter * np.cos(axis) - place * np.sin(angle)
    return np.asarray(1.0 / roller - sign * np.cos(angle) / ring)
