"""A row of barrel-shaped rollers between races that are arcs: spherical, barrel, toroidal bearings.

In the axial plane of a roller the outer race is an arc of radius R_o about C_o, the inner race one
of radius r_i about C_i, and the roller has a profile of radius r_r less than both. C_o is the
bearing's centre O where the outer race is a sphere (of spherical bearings, and of barrel roller
bearings with α = 0), and lies beyond the axis where it is a torus. At the free contact angle α

    C_o = G - (R_o - D/2) n,      C_i = C_o + (R_o + r_i - D) n,      n = (sin α, cos α),

G being the roller's middle, at the radius d_pw/2. The inner ring takes C_i along by its
displacement and by the exact rotation of its tilt about O; the roller follows in its pocket, so
that C_i and C_o determine its plane. It lies on the line of both, with the unit vector e:

    δ = |C_o C_i| - (R_o + r_i - D) - ½ P_d cos α = δ_i + δ_o,
    Q_o(δ_o) = Q_i(δ_i) + F_c e_r,

and pushes the inner ring by Q_i along e. With C_o = O the force at rest passes through O whatever
the tilt: no moment about the centre, exactly. What is square to e of the centrifugal force, and the
gyroscopic moment, the guide ring and the cage take: the roller's own turning in its plane is not a
degree of freedom here.

A contact is Hertz's ellipse, Q = K δ^1.5, while 2a ≤ 0.9 L; from there on the ends of the roller
cut it off, and Q grows as the sum of slices that know nothing of each other does, with the profile
P(x) = ½ x² (1/r_r - 1/r_race): Q = Q_t S(δ)/S(δ_t), S = Σ (δ - P(x_k))^(10/9). So do the pressures,
which are those of a line contact at each slice, with the factor that joins them to Hertz's.

Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapters 2, 5 and 8; ISO/TS 16281:2008 for the
slices; docs/theory/barrel-rollers.md.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Final, Self, cast

import numpy as np

from rolamento.case.parameters import RollerParameters
from rolamento.case.roller_bearing import raceway_radii
from rolamento.contact.hertz import effective_modulus, elliptical_contact
from rolamento.contact.line import EXPONENT, half_width, max_pressure, slice_places
from rolamento.geometry import Angle
from rolamento.kinematics import (
    BallMotion,
    centrifugal_force,
    roller_body,
    roller_gyroscopic_moment,
    roller_motion,
)
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.numerics.rotation import rotation_of
from rolamento.records import frozen
from rolamento.rows.ball.problem import directions
from rolamento.rows.row import Indices, IntArray, Response, RowGeometry, RowSizes, Running
from rolamento.solved import Elements, Index, Pressed, Tables
from rolamento.solved.rollers import Line, Rollers
from rolamento.solved.tables import taken
from rolamento.status import (
    CONVERGED,
    GREATEST_APPROACH,
    INVALID_INPUT,
    NOT_CONVERGED,
    OVERLOADED,
    TOLERANCE,
)

__all__ = ["BarrelRow", "barrel_row"]

WHOLE: Final = 0.9
"""Part of the roller's length up to which the ellipse is whole."""


@frozen(eq=False)
class _Race:
    """A contact with one race in many cases; (cases,) each, of the slices (cases, n); SI.

    stiffness: K of Hertz. limit, load_limit: δ_t and Q_t, at which the ellipse is cut off. unit:
    a, b and p0 at 1 N. curvature: Σρ along rolling. drop: P(x_k). joined: pressure of the ellipse
    over that of the line, in the middle at the limit.
    """

    stiffness: FloatArray
    limit: FloatArray
    load_limit: FloatArray
    semi_major: FloatArray
    semi_minor: FloatArray
    pressure: FloatArray
    curvature: FloatArray
    drop: FloatArray
    sum_at_limit: FloatArray
    joined: FloatArray

    def load(self, approach: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return Q and ∂Q/∂δ of every element; approach: (cases, elements), m."""
        pressed = np.maximum(approach, 0.0)
        root = np.sqrt(pressed)
        stiffness = self.stiffness[:, np.newaxis]
        load, slope = stiffness * pressed * root, 1.5 * stiffness * root
        cut = pressed > self.limit[:, np.newaxis]
        if cut.any():
            case, element = np.nonzero(cut)
            deep = np.maximum(pressed[case, element, np.newaxis] - self.drop[case], 0.0)
            ninth = np.cbrt(np.cbrt(deep))
            scale = self.load_limit[case] / self.sum_at_limit[case]
            load[case, element] = scale * (deep * ninth).sum(axis=-1)
            slope[case, element] = scale * EXPONENT * ninth.sum(axis=-1)
        return load, slope

    def line(
        self, load: FloatArray, approach: FloatArray, place: FloatArray, modulus: FloatArray
    ) -> Line:
        """Return load per length, pressure and half width of the slices; (cases, elements, n)."""
        width = place[:, 1:2] - place[:, :1]
        cube = np.cbrt(load)[..., np.newaxis]
        half = self.semi_major[:, np.newaxis, np.newaxis] * cube
        edge = 0.5 * width[:, np.newaxis]
        x = place[:, np.newaxis]
        with np.errstate(invalid="ignore", divide="ignore"):
            low, high = (np.clip((x + s * edge) / half, -1.0, 1.0) for s in (-1.0, 1.0))
            whole = 0.75 * load[..., np.newaxis] * (_cubic(high) - _cubic(low)) / (2.0 * edge)
            inside = np.maximum(np.abs(x) - edge, 0.0) / half
            shape = np.sqrt(np.maximum(1.0 - inside**2, 0.0))
        q = np.where(half == 0.0, 0.0 * x, whole)  # not 0 where there is no result
        pressure = self.pressure[:, np.newaxis, np.newaxis] * cube * shape
        narrow = self.semi_minor[:, np.newaxis, np.newaxis] * cube * shape
        cut = (approach > self.limit[:, np.newaxis])[..., np.newaxis]
        if cut.any():
            deep = np.maximum(approach[..., np.newaxis] - self.drop[:, np.newaxis], 0.0) ** EXPONENT
            total = deep.sum(axis=-1, keepdims=True)
            share = np.divide(deep, total, where=total > 0.0, out=np.zeros_like(deep))
            cut_q = load[..., np.newaxis] * share / (2.0 * edge)
            given = cut_q, self.curvature[:, np.newaxis, np.newaxis], modulus[:, None, None]
            joined = self.joined[:, np.newaxis, np.newaxis]
            q = np.where(cut, cut_q, q)
            pressure = np.where(cut, joined * max_pressure(*given), pressure)
            narrow = np.where(cut, half_width(*given) / joined, narrow)
        nothing = (load == 0.0)[..., np.newaxis]
        return Line(*(np.where(nothing, 0.0, one) for one in (q, pressure, narrow)))


def _cubic(x: FloatArray) -> FloatArray:
    """Antiderivative of 1 - x²."""
    return np.asarray(x - x**3 / 3.0)


@frozen(eq=False)
class _Numbers:
    """A row in many cases; (cases,) each, SI. outer_x, outer_r: C_o; reach: R_o + r_i - D."""

    inner: _Race
    outer: _Race
    diameter: FloatArray
    length: FloatArray
    pitch: FloatArray
    angle: FloatArray
    axial: FloatArray
    outer_x: FloatArray
    outer_r: FloatArray
    reach: FloatArray
    gap: FloatArray
    modulus: FloatArray
    force: FloatArray
    moment: FloatArray
    first: FloatArray
    place: FloatArray
    motion: BallMotion

    def part(self, index: Any) -> _Numbers:
        """The same of some of the cases."""
        return taken(self, index)


@dataclass(slots=True)
class BarrelResponse:
    """Barrel-shaped rollers in their places, and what they answer; depth: δ_o, (cases, Z)."""

    place: FloatArray
    depth: FloatArray
    force: FloatArray
    stiffness: FloatArray
    scale: FloatArray
    residual: FloatArray
    number: IntArray

    @property
    def face_forces(self) -> FloatArray:
        """(cases, 1, 5)."""
        return self.force[:, np.newaxis]

    @property
    def safe_path(self) -> BoolArray:
        """There is but one path; (cases,)."""
        return np.zeros(len(self.place), np.bool_)

    @property
    def memory(self) -> FloatArray | None:
        """It begins anew at every place."""
        return None

    def put(self, cases: Indices, part: Self) -> None:
        """Copy what some of the cases answered to their places."""
        for one in fields(self):
            getattr(self, one.name)[cases] = getattr(part, one.name)


@frozen(eq=False)
class _Seen:
    """The inner ring's arcs seen from the rollers; (cases, Z) each.

    centre: C_i, (cases, Z, 3). along, outward: e in the roller's plane. length: |C_o C_i|.
    sine, cosine: of the azimuth at which C_i stands. approach: δ.
    """

    centre: FloatArray
    along: FloatArray
    outward: FloatArray
    length: FloatArray
    sine: FloatArray
    cosine: FloatArray
    radius: FloatArray
    approach: FloatArray


@frozen(eq=False)
class BarrelRow:
    """Many cases of a row of barrel-shaped rollers; its place is that of the bearing's centre."""

    numbers: _Numbers
    element_count: int
    geometry: RowGeometry
    sound: BoolArray
    floats: bool

    @property
    def cases(self) -> int:
        """Number of cases."""
        return len(self.sound)

    @property
    def faces(self) -> tuple[float, ...]:
        """One arc a ring."""
        return (1.0,)

    @property
    def aside(self) -> FloatArray | None:
        """How far its plane is from the bearing's centre, about which the ring tilts; (cases,)."""
        return self.numbers.axial

    @property
    def valid(self) -> BoolArray:
        """Which cases have numbers that can be solved; (cases,)."""
        n = self.numbers
        given = (n.reach, n.gap, n.force, n.first, n.inner.stiffness, n.outer.stiffness)
        return np.asarray(self.sound & np.isfinite(np.sum(given, axis=0)))

    @property
    def sizes(self) -> RowSizes:
        """For the system."""
        n = self.numbers
        both = (n.inner.stiffness ** (-2.0 / 3.0) + n.outer.stiffness ** (-2.0 / 3.0)) ** -1.5
        return RowSizes(
            arm=0.5 * n.pitch,
            diameter=n.diameter,
            reach=0.2 * n.diameter,
            stiffness=both,
            sine=np.sin(n.angle),
        )

    def invalidate(self, cases: BoolArray) -> None:
        """Take some cases for invalid: they are left alone."""
        self.sound[cases] = False

    # --- solving --------------------------------------------------------------------------------

    def respond(
        self, place: FloatArray, which: Indices, memory: FloatArray | None = None
    ) -> BarrelResponse:
        """Hold some of the cases at a place; (len(which), 5)."""
        n = self.numbers.part(which)
        rotation, turns = rotation_of(place[:, 3], place[:, 4])
        at_rest = _free_centres(n, self.element_count)
        seen = _seen(n, at_rest @ np.swapaxes(rotation, 1, 2) + place[:, np.newaxis, :3])
        thrown = n.force[:, np.newaxis] * seen.outward
        depth, (inner, outer), (soft_i, soft_o), off = _shared(n, seen.approach, thrown)
        pull = np.stack([seen.along, seen.outward * seen.sine, seen.outward * seen.cosine], axis=-1)
        forces = inner[..., np.newaxis] * pull
        # stiffness in the roller's plane: of the contacts in line, and of the turning force
        with np.errstate(invalid="ignore", divide="ignore"):
            share = np.where(soft_i > 0.0, soft_i / (soft_i + soft_o), 0.0)
        e = np.stack([seen.along, seen.outward], axis=-1)
        t = np.stack([seen.outward, -seen.along], axis=-1)
        turning = t[..., 1] / seen.length  # ∂e_r along t
        change = (share * soft_o)[..., np.newaxis] * e
        change -= (share * n.force[:, np.newaxis] * turning)[..., np.newaxis] * t
        plane = e[..., :, np.newaxis] * change[..., np.newaxis, :]
        plane += (inner / seen.length)[..., np.newaxis, np.newaxis] * (
            t[..., :, np.newaxis] * t[..., np.newaxis, :]
        )
        to_plane = np.zeros((*seen.approach.shape, 2, 3))
        to_plane[..., 0, 0] = 1.0
        to_plane[..., 1, 1], to_plane[..., 1, 2] = seen.sine, seen.cosine
        around = np.stack([0.0 * seen.sine, seen.cosine, -seen.sine], axis=-1)
        tangent = np.swapaxes(to_plane, -1, -2) @ plane @ to_plane
        tangent += (inner * seen.outward / seen.radius)[..., np.newaxis, np.newaxis] * (
            around[..., :, np.newaxis] * around[..., np.newaxis, :]
        )
        moved = np.zeros((*seen.approach.shape, 3, 5))
        moved[..., :3, :3] = np.eye(3)
        for axis, turn in zip((3, 4), turns, strict=True):
            moved[..., :, axis] = at_rest @ np.swapaxes(turn, 1, 2)
        by_place = tangent @ moved
        lever = _levers(seen.centre)
        force = np.zeros_like(place)
        force[:, :3] = forces.sum(axis=1)
        force[:, 3:] = (lever @ forces[..., np.newaxis])[..., 0].sum(axis=1)
        stiffness = np.zeros((len(place), 5, 5))
        stiffness[:, :3] = by_place.sum(axis=1)
        stiffness[:, 3:] = (lever @ by_place + _lever_change(forces, moved)).sum(axis=1)
        size = np.maximum(inner, outer).max(axis=1)
        with np.errstate(invalid="ignore", divide="ignore"):
            residual = np.where(size > 0.0, np.abs(off).max(axis=1) / size, 0.0)
        number = np.full(len(place), CONVERGED)
        number[(seen.approach.max(axis=1) > GREATEST_APPROACH * n.diameter)] = OVERLOADED
        number[~(residual <= TOLERANCE)] = NOT_CONVERGED
        number[~self.valid[which]] = INVALID_INPUT
        return BarrelResponse(
            place.copy(), depth, force, stiffness, size + inner.sum(axis=1), residual, number
        )

    def no_response(self, cases: int) -> BarrelResponse:
        """Make room for so many cases without a result."""
        return BarrelResponse(
            place=np.full((cases, 5), np.nan),
            depth=np.full((cases, self.element_count), np.nan),
            force=np.full((cases, 5), np.nan),
            stiffness=np.full((cases, 5, 5), np.nan),
            scale=np.full(cases, np.nan),
            residual=np.full(cases, np.nan),
            number=np.full(cases, INVALID_INPUT),
        )

    def first_contact(self) -> FloatArray:
        """Place along x from which it counts: where the ring is centred; (cases,), m."""
        return np.zeros(self.cases)

    def press_in(self, force: FloatArray) -> FloatArray:
        """No preload is put on such rows; (cases,), NaN."""
        return np.full(self.cases, np.nan)

    def answer(
        self, held: Response, control: FloatArray, shown: IntArray, lost: BoolArray
    ) -> BarrelAnswer:
        """Keep what the tables are made from, of cases that are not lost."""
        rollers = cast(BarrelResponse, held)
        rollers.place[lost], rollers.depth[lost] = np.nan, np.nan
        codes = np.broadcast_to(shown, (self.cases, self.element_count))
        return BarrelAnswer(self.numbers, rollers.place, rollers.depth, np.asarray(codes))


@frozen(eq=False)
class BarrelAnswer:
    """Where the rollers of solved cases are: what their tables are made from."""

    numbers: _Numbers
    place: FloatArray
    depth: FloatArray
    shown: IntArray

    def part(self, index: Index) -> BarrelAnswer:
        """Return some of the cases."""
        return BarrelAnswer(
            self.numbers.part(index), self.place[index], self.depth[index], self.shown[index]
        )

    def grip(self) -> FloatArray:
        """How deep each roller is pressed into the inner ring; of a gap too."""
        return np.asarray(self._seen().approach - self.depth)

    def _seen(self) -> _Seen:
        rotation, _ = rotation_of(self.place[:, 3], self.place[:, 4])
        at_rest = _free_centres(self.numbers, self.shown.shape[1])
        centre = at_rest @ np.swapaxes(rotation, 1, 2) + self.place[:, np.newaxis, :3]
        return _seen(self.numbers, centre)

    def tables(self) -> Tables:
        """Evaluate every slice of every roller of every case."""
        n, seen = self.numbers, self._seen()
        cases, rollers = self.shown.shape
        known = 0.0 * self.depth

        def wide(values: FloatArray) -> FloatArray:
            return values[:, np.newaxis] + known

        first = np.mod(
            n.first[:, np.newaxis] + 2.0 * np.pi * np.arange(rollers) / rollers, 2 * np.pi
        )
        motion = n.motion
        elements = Elements(
            row=np.zeros(rollers, np.int64),
            azimuth=np.where(first < 2.0 * np.pi, first, 0.0),
            centrifugal_force=wide(n.force),
            gyroscopic_moment=wide(n.moment),
            orbital_speed=wide(motion.orbital_speed),
            ball_speed=wide(motion.ball_speed),
            attitude=wide(motion.attitude),
            yaw=np.zeros((cases, rollers)),
            raceway_control=self.shown,
        )
        angle = np.arctan2(seen.along, seen.outward)
        depths = seen.approach - self.depth, self.depth
        loads = [race.load(deep)[0] for race, deep in zip((n.inner, n.outer), depths, strict=True)]
        lines = [
            race.line(load, np.maximum(deep, 0.0), n.place, n.modulus)
            for race, load, deep in zip((n.inner, n.outer), loads, depths, strict=True)
        ]
        pressed = [
            Pressed(load, Angle(angle), np.maximum(deep, 0.0), deep, wide(spin), wide(roll))
            for load, deep, spin, roll in (
                (loads[0], depths[0], motion.inner_spin, motion.inner_roll),
                (loads[1], depths[1], motion.outer_spin, motion.outer_roll),
            )
        ]
        place = np.broadcast_to(n.place[:, np.newaxis], lines[0].pressure.shape)
        found = Rollers(
            tilt=n.angle[:, np.newaxis] - angle,
            rib_force=n.force[:, np.newaxis] * seen.along,
            rib_moment=known,
            slice_place=place + known[..., np.newaxis],
            inner=lines[0],
            outer=lines[1],
        )
        return Tables(elements, pressed[0], pressed[1], rollers=found)


def _free_centres(n: _Numbers, rollers: int) -> FloatArray:
    """C_i of every roller in a ring that is centred; (cases, Z, 3), m."""
    axial = n.outer_x + n.reach * np.sin(n.angle)
    radial = n.outer_r + n.reach * np.cos(n.angle)
    c0, s0 = np.cos(n.first)[:, np.newaxis], np.sin(n.first)[:, np.newaxis]
    c, s = directions(rollers)
    cosine, sine = c * c0 - s * s0, s * c0 + c * s0
    radial = radial[:, np.newaxis]
    return np.stack([axial[:, np.newaxis] + 0.0 * cosine, radial * sine, radial * cosine], axis=-1)


def _seen(n: _Numbers, centre: FloatArray) -> _Seen:
    radius = np.hypot(centre[..., 1], centre[..., 2])
    axial, radial = centre[..., 0] - n.outer_x[:, np.newaxis], radius - n.outer_r[:, np.newaxis]
    length = np.hypot(axial, radial)
    return _Seen(
        centre=centre,
        along=axial / length,
        outward=radial / length,
        length=length,
        sine=centre[..., 1] / radius,
        cosine=centre[..., 2] / radius,
        radius=radius,
        approach=length - (n.reach + n.gap)[:, np.newaxis],
    )


def _levers(centre: FloatArray) -> FloatArray:
    """What makes M_y = z f_x - x f_z and M_z = x f_y - y f_x of a force; (…, 2, 3)."""
    x, y, z = np.moveaxis(centre, -1, 0)
    nothing = 0.0 * x
    return np.stack(
        [np.stack([z, nothing, -x], axis=-1), np.stack([-y, x, nothing], axis=-1)], axis=-2
    )


def _lever_change(force: FloatArray, moved: FloatArray) -> FloatArray:
    """Change of those moments as the point moves under its force; (…, 2, 5)."""
    fx, fy, fz = (force[..., i, np.newaxis] for i in range(3))
    dx, dy, dz = (moved[..., i, :] for i in range(3))
    return np.stack([dz * fx - dx * fz, dx * fy - dy * fx], axis=-2)


_Pair = tuple[FloatArray, FloatArray]


def _shared(
    n: _Numbers, approach: FloatArray, thrown: FloatArray
) -> tuple[FloatArray, _Pair, _Pair, FloatArray]:
    """Share an approach among both contacts of a roller, Q_o(δ_o) = Q_i(δ - δ_o) + F.

    δ_o; Q_i and Q_o; their derivatives; what is left.
    """
    weak_i, weak_o = (race.stiffness[:, None] ** (-2.0 / 3.0) for race in (n.inner, n.outer))
    closed = np.maximum(approach, 0.0)
    start = closed * (weak_o / (weak_i + weak_o))
    start = np.where(approach > 0.0, start, np.maximum(thrown, 0.0) ** (2.0 / 3.0) * weak_o)

    def both(at: FloatArray) -> tuple[_Pair, _Pair]:
        inner, soft_i = n.inner.load(approach - at)
        outer, soft_o = n.outer.load(at)
        return (inner, outer), (soft_i, soft_o)

    def left(at: FloatArray) -> _Pair:
        (inner, outer), slopes = both(at)
        return outer - inner - thrown, slopes[0] + slopes[1]

    depth, _ = increasing_root(left, start, np.zeros_like(start), np.full_like(start, np.inf))
    loads, slopes = both(depth)
    return depth, loads, slopes, loads[1] - loads[0] - thrown


# --- from a case to its numbers -------------------------------------------------------------------


def barrel_row(bearing: RollerParameters, running: Running) -> BarrelRow:
    """The numbers of a row of barrel-shaped rollers; there is but one path, fast or not."""
    with np.errstate(invalid="ignore", divide="ignore"):
        n = _numbers(bearing, running)
    nothing = np.full(running.cases, np.nan)
    geometry = RowGeometry(
        ball_diameter=n.diameter,
        pitch_diameter=n.pitch,
        inner_conformity=nothing,
        outer_conformity=nothing,
        free_contact_angle=n.angle,
        modulus=n.modulus,
        effective_length=n.length,
    )
    floats, sound = bearing.bearing_type.floats, np.ones(running.cases, np.bool_)
    return BarrelRow(n, bearing.element_count, geometry, sound, floats)


def _numbers(bearing: RollerParameters, running: Running) -> _Numbers:
    column, model = running.column, running.model
    diameter, pitch = column(bearing.roller_diameter), column(bearing.pitch_diameter)
    length, angle = column(bearing.effective_length), column(bearing.contact_angle or 0.0)
    whole = column(bearing.roller_length)
    profile, inner_radius, outer_radius = (column(one) for one in raceway_radii(bearing))
    axial = 0.5 * pitch * np.tan(angle)
    modulus = column(effective_modulus(bearing.ring_material, bearing.roller_material))
    slices = slice_places(length, model.slices)
    races = [
        _race(diameter, pitch, angle, length, profile, radius, modulus, slices, sign)
        for radius, sign in ((inner_radius, -1.0), (outer_radius, 1.0))
    ]
    speeds = column(running.inner_speed), column(running.outer_speed)
    motion = roller_motion(diameter, pitch, angle, 0.0, *speeds)
    body = roller_body(diameter, whole, 0.0, column(bearing.roller_material.density))
    force = centrifugal_force(body.mass, pitch, motion.orbital_speed)
    return _Numbers(
        inner=races[0],
        outer=races[1],
        diameter=diameter,
        length=length,
        pitch=pitch,
        angle=angle,
        axial=axial,
        outer_x=axial - (outer_radius - 0.5 * diameter) * np.sin(angle),
        outer_r=0.5 * pitch - (outer_radius - 0.5 * diameter) * np.cos(angle),
        reach=outer_radius + inner_radius - diameter,
        gap=0.5 * column(bearing.diametral_clearance) * np.cos(angle),
        modulus=modulus,
        force=column(model.centrifugal_force * force),
        moment=column(model.gyroscopic_moment * roller_gyroscopic_moment(body, motion)),
        first=column(running.azimuth),
        place=slices,
        motion=motion,
    )


def _race(
    diameter: FloatArray,
    pitch: FloatArray,
    angle: FloatArray,
    length: FloatArray,
    profile: FloatArray,
    radius: FloatArray,
    modulus: FloatArray,
    slices: FloatArray,
    sign: float,
) -> _Race:
    """A contact with one race; sign: +1 outer, -1 inner."""
    cosine = np.cos(angle)
    rolling = 2.0 / diameter - sign * cosine / (0.5 * pitch + sign * 0.5 * diameter * cosine)
    across = 1.0 / profile - 1.0 / radius
    one = elliptical_contact(1.0, rolling, across, modulus)
    load_limit = (0.5 * WHOLE * length / one.semi_major) ** 3
    limit = (load_limit / one.stiffness) ** (2.0 / 3.0)
    drop = 0.5 * slices**2 * across[:, np.newaxis]
    deep = np.maximum(limit[:, np.newaxis] - drop, 0.0) ** EXPONENT
    total = deep.sum(axis=1)
    middle = limit**EXPONENT / total * load_limit * slices.shape[1] / length
    return _Race(
        stiffness=one.stiffness,
        limit=limit,
        load_limit=load_limit,
        semi_major=one.semi_major,
        semi_minor=one.semi_minor,
        pressure=one.max_pressure,
        curvature=rolling,
        drop=drop,
        sum_at_limit=total,
        joined=one.max_pressure * np.cbrt(load_limit) / max_pressure(middle, rolling, modulus),
    )
