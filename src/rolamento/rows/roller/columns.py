"""From a bearing to the numbers of a row of rollers: geometry in the roller's own plane.

Axis t = (cos β, -sin β) and normal n = (sin β, cos β) of a roller in (x, r), with β = α_o - φ; the
contacts' normals are e_i = n cos φ - t sin φ and e_o = n cos φ + t sin φ, their directions along
the raceway stand across those. The large end of a tapered roller lies toward -x, the rib of the
inner ring behind it. The rib's normal f stands at ε over t: from the point of contact, d = R_large
- h under the axis, through the centre of the spherical end of radius R_s, sin ε = d/R_s.

Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapters 2 and 8; docs/theory/rollers.md.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, replace
from functools import lru_cache
from typing import Any, Final

import numpy as np

from rolamento.case.parameters import RollerParameters
from rolamento.case.roller_bearing import USUAL_RIB_HEIGHT, RollerBearing, axis_angle
from rolamento.contact.coupled import body_term, influence_table, scratch
from rolamento.contact.hertz import effective_modulus
from rolamento.contact.line import contact_constant, roller_share, slice_places
from rolamento.contact.profile import drop
from rolamento.errors import InputError
from rolamento.geometry import Race, apex_distance
from rolamento.kinematics import (
    BallMotion,
    RollerBody,
    centrifugal_force,
    roller_body,
    roller_gyroscopic_moment,
    roller_motion,
)
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.rows.roller import layout
from rolamento.rows.roller.roller import Line
from rolamento.rows.row import Running

__all__ = ["Cut", "Geometry", "Numbers", "geometry_of", "numbers_of"]


@frozen
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
        """Number of slices."""
        return int(self.place.shape[-1])

    @property
    def alike(self) -> bool:
        """Whether they are the same in all cases."""
        return len(self.place) == len(self.drops) == len(self.curvature) == len(self.body) == 1

    def lines(self) -> Line:
        """For the kernels, with scratch of its own."""
        return (
            self.coupled, self.place, self.drops, self.curvature, self.body, self.table,
            scratch(self.slices if self.coupled else 1),
        )  # fmt: skip

    def part(self, index: Any) -> Cut:
        """The same numbers for some of the cases."""
        place, drops, curvature, body = (
            a if len(a) == 1 else a[index]
            for a in (self.place, self.drops, self.curvature, self.body)
        )
        return Cut(self.coupled, place, drops, curvature, body, self.table)


@frozen
class Geometry:
    """What does not depend on the duty; p: columns of `layout`, the others (cases,).

    axis: β, half_angle: φ, rib_angle: ε, rib_arm: of the rib's force about the roller's centre.
    """

    p: FloatArray
    cut: Cut
    body: RollerBody
    modulus: FloatArray
    axis: FloatArray
    half_angle: FloatArray
    rib_angle: FloatArray
    rib_arm: FloatArray
    tapered: bool

    def part(self, index: Any) -> Geometry:
        """The same numbers for some of the cases."""
        return self._each(lambda one: one[..., index], self.cut.part(index))

    def repeated(self, cases: int) -> Geometry:
        """The one case that it is, as often as asked."""
        return self._each(lambda one: np.repeat(one, cases, axis=-1), self.cut)

    def _each(self, change: Callable[[FloatArray], FloatArray], cut: Cut) -> Geometry:
        body = RollerBody(*(change(getattr(self.body, one.name)) for one in fields(RollerBody)))
        changed: dict[str, Any] = {
            name: change(getattr(self, name))
            for name in ("p", "modulus", "axis", "half_angle", "rib_angle", "rib_arm")
        }
        return replace(self, cut=cut, body=body, **changed)


@frozen
class Numbers:
    """The numbers of a row in many cases: its geometry, with the duty in its columns p.

    centrifugal, gyroscopic: as they are shown; (cases,), N and N·m.
    """

    p: FloatArray
    geometry: Geometry
    motion: BallMotion
    centrifugal: FloatArray
    gyroscopic: FloatArray

    @property
    def cut(self) -> Cut:
        """The contacts along the roller."""
        return self.geometry.cut

    @property
    def tapered(self) -> bool:
        """Whether the rollers are cones."""
        return self.geometry.tapered

    def part(self, index: Any) -> Numbers:
        """The same numbers for some of the cases."""
        motion = BallMotion(*(getattr(self.motion, one.name)[index] for one in fields(BallMotion)))
        own = self.geometry.part(index)
        return Numbers(
            self.p[:, index], own, motion, self.centrifugal[index], self.gyroscopic[index]
        )


def numbers_of(bearing: RollerParameters, running: Running) -> Numbers:
    """Make the numbers of a row.

    The roller's inertia acts at its centroid, which a taper has toward its large end.
    """
    cases, model = running.cases, running.model
    coupled = model.roller_contact == "coupled"
    if running.record is None:
        conical = bearing.bearing_type.conical
        geometry = geometry_of(bearing, conical, model.slices, coupled, cases)
    else:
        geometry = _alone(running.record, model.slices, coupled).repeated(cases)
    p, body, axis = geometry.p, geometry.body, geometry.axis
    diameter, pitch = p[layout.DIAMETER], 2.0 * p[layout.ARM]
    speeds = running.column(running.inner_speed), running.column(running.outer_speed)
    motion = roller_motion(diameter, pitch, axis, geometry.half_angle, *speeds)
    at_centroid = pitch + 2.0 * body.centroid * np.sin(axis)
    force = model.centrifugal_force * centrifugal_force(
        body.mass, at_centroid, motion.orbital_speed
    )
    moment = model.gyroscopic_moment * roller_gyroscopic_moment(body, motion)
    p[layout.CENTRIFUGAL] = force
    # M_g is what turns the roller's momentum; the roller resists it
    p[layout.MOMENT] = force * body.centroid * np.cos(axis) - moment
    p[layout.COS_FIRST] = np.cos(running.azimuth)
    p[layout.SIN_FIRST] = np.sin(running.azimuth)
    return Numbers(p, geometry, motion, force, moment)


@lru_cache(maxsize=64)
def _alone(bearing: RollerBearing, slices: int, coupled: bool) -> Geometry:
    """Row index of a bearing of one row; not to be written to."""
    return geometry_of(bearing, bearing.bearing_type.conical, slices, coupled, 1)


def geometry_of(bearing: Any, tapered: bool, slices: int, coupled: bool, cases: int) -> Geometry:
    """Lay a roller between its races; bearing: as of `numbers_of`."""

    def column(value: Any) -> FloatArray:
        return _column(value, cases)

    diameter, pitch = column(bearing.roller_diameter), column(bearing.pitch_diameter)
    length = column(bearing.effective_length)
    whole = length if bearing.roller_length is None else column(bearing.roller_length)
    half = column(bearing.roller_half_angle if tapered else 0.0)
    axis = column(axis_angle(bearing))
    outer = axis + half
    given = bearing.rib_height
    height = USUAL_RIB_HEIGHT * diameter if given is None else column(given)
    epsilon, arm = _rib_normal(bearing, diameter, whole, half, height, tapered)
    modulus = column(effective_modulus(bearing.ring_material, bearing.roller_material))
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
    p[layout.INNER_CONSTANT] = p[layout.OUTER_CONSTANT] = contact_constant(length, modulus)
    play = bearing.diametral_clearance
    p[layout.GAP] = 0.0 if play is None else 0.25 * column(play)
    p[layout.CENTRIFUGAL_SHIFT] = np.cos(axis - epsilon)
    p[layout.CENTRIFUGAL_TURN] = arm * np.sin(axis - epsilon)
    if not tapered:
        ahead, behind = _opposed_ribs(bearing)
        stiffness = _rib_stiffness(diameter, height, modulus)
        p[layout.RIB_AHEAD], p[layout.RIB_BEHIND] = ahead * stiffness, behind * stiffness
        reach = np.where(height < radius, radius - height, np.nan)
        p[layout.RIB_LEVER] = reach * (ahead or behind)
        play = bearing.axial_play
        p[layout.RIB_PLAY] = 0.0 if play is None else 0.5 * column(play)
    p[layout.COMPLIANCE] = 2.0 / (np.pi * modulus)
    return Geometry(
        p=p,
        cut=_cut(bearing, p, half, axis, modulus, slices, coupled, tapered),
        body=roller_body(diameter, whole, half, column(bearing.roller_material.density)),
        modulus=modulus,
        axis=axis,
        half_angle=half,
        rib_angle=epsilon,
        rib_arm=arm if tapered else -2.0 * p[layout.RIB_LEVER],
        tapered=tapered,
    )


def _column(value: Any, cases: int) -> FloatArray:
    return np.array(np.broadcast_to(np.asarray(value, np.float64), cases))


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
    sphere = apex_distance(diameter, length, half) if given is None else given
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
    bearing: Any,
    p: FloatArray,
    half: FloatArray,
    axis: FloatArray,
    modulus: FloatArray,
    slices: int,
    coupled: bool,
    tapered: bool,
) -> Cut:
    """Cut the contacts into slices; what is alike in all cases is kept once."""
    length, diameter, pitch = p[layout.LENGTH], p[layout.DIAMETER], 2.0 * p[layout.ARM]
    same = all(bool((a == a[:1]).all()) for a in (length, diameter, pitch, half, axis, modulus))
    some = slice(0, 1) if same else slice(None)
    length, diameter, pitch, half, axis = (a[some] for a in (length, diameter, pitch, half, axis))
    place = slice_places(length, slices)
    sizes = {"length": length[:, np.newaxis], "diameter": diameter[:, np.newaxis]}

    def drops_of(body: str) -> FloatArray:
        try:
            own = getattr(bearing, f"{body}_profile")
            return drop(own, place, tapered=bearing.bearing_type.crowned_whole, **sizes)
        except InputError as error:
            name = f"bearing.{body}_profile.{error.field}"
            raise error.with_details(field=name) from None

    roller = drops_of("roller")
    drops = np.stack([roller + drops_of(race) for race in ("inner", "outer")], axis=1)
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
