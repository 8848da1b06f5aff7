"""A row of rollers as `rolamento.rows.row` asks for it: from numbers of a case to its tables."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final, Self, cast

import numpy as np

from rolamento.case.parameters import RollerParameters
from rolamento.contact.line import EXPONENT, half_width, max_pressure
from rolamento.geometry import Angle
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.rows.ball.problem import directions
from rolamento.rows.roller import layout
from rolamento.rows.roller.columns import Numbers, numbers_of
from rolamento.rows.roller.run import Solution, hold, settle
from rolamento.rows.row import (
    Indices,
    IntArray,
    Response,
    RowGeometry,
    RowSizes,
    Running,
    alike_in_all_cases,
)
from rolamento.solved import Elements, Index, Pressed, Tables
from rolamento.solved.rollers import Line, Rollers

__all__ = ["RollerRow", "roller_row"]


RUN_OFF: Final = 0.2
"""Fraction of the roller's diameter: a ring that has gone so far without rest is likely to go
on."""


def _memory_of(place: FloatArray, state: FloatArray) -> FloatArray:
    """From what a row may begin nearby: the ring's place (cases, 5), the rollers' (cases, Z, 2)."""
    return np.concatenate([place, state.reshape(len(state), -1)], axis=1)


@dataclass(slots=True)
class RollerResponse:
    """Rollers in their places; place (cases, 5), m and rad."""

    place: FloatArray
    solution: Solution

    @property
    def force(self) -> FloatArray:
        """(cases, 5), N and N·m."""
        return self.solution.force

    @property
    def face_forces(self) -> FloatArray:
        """(cases, 1, 5)."""
        return self.solution.force[:, np.newaxis]

    @property
    def stiffness(self) -> FloatArray:
        """(cases, 5, 5)."""
        return self.solution.stiffness

    @property
    def scale(self) -> FloatArray:
        """(cases,), N."""
        return self.solution.scale

    @property
    def number(self) -> IntArray:
        """(cases,)."""
        return self.solution.number

    @property
    def residual(self) -> FloatArray:
        """(cases,)."""
        return self.solution.residual

    @property
    def safe_path(self) -> BoolArray:
        """There is but one path; (cases,)."""
        return np.zeros(len(self.place), np.bool_)

    @property
    def memory(self) -> FloatArray:
        """Where the ring and the rollers are; (cases, 5 + 2 Z)."""
        return _memory_of(self.place, self.solution.state)

    def put(self, cases: Indices, part: Self) -> None:
        """Copy what some of the cases answered to their places."""
        self.place[cases] = part.place
        self.solution.put(cases, part.solution)


@frozen
class RollerRow:
    """Many cases of a row of cylindrical, needle or tapered rollers."""

    numbers: Numbers
    element_count: int
    geometry: RowGeometry
    threads: int | None = None

    @property
    def cases(self) -> int:
        """Number of cases."""
        return int(self.numbers.p.shape[1])

    @property
    def faces(self) -> tuple[float, ...]:
        """One raceway a ring."""
        return (1.0,)

    @property
    def floats(self) -> bool:
        """Whether no ribs and no cones hold it along the shaft."""
        p = self.numbers.p
        ribs = np.any(p[layout.RIB_AHEAD] + p[layout.RIB_BEHIND] > 0.0)
        return not (self.numbers.tapered or ribs or np.any(p[layout.OUTER_SINE] > 0.0))

    @property
    def valid(self) -> BoolArray:
        """Which cases have numbers that can be solved; (cases,)."""
        sound = np.isfinite(self.numbers.p).all(axis=0)
        cut = self.numbers.cut
        for one in (cut.place, cut.drops, cut.curvature):
            sound = sound & np.isfinite(one).reshape(len(one), -1).all(axis=1)
        return np.asarray(sound)

    @property
    def aside(self) -> FloatArray | None:
        """It is held by the place of its own plane."""
        return None

    @property
    def sizes(self) -> RowSizes:
        """For the system.

        stiffness: K of Q = K δ^1.5 that is as stiff at a thousandth of the roller's diameter.
        """
        p = self.numbers.p
        pair = 0.5**EXPONENT * p[layout.OUTER_CONSTANT]
        return RowSizes(
            arm=p[layout.ARM],
            diameter=p[layout.DIAMETER],
            reach=0.2 * p[layout.DIAMETER],
            stiffness=pair * (1e-3 * p[layout.DIAMETER]) ** (EXPONENT - 1.5),
            sine=p[layout.OUTER_SINE],
        )

    def invalidate(self, cases: BoolArray) -> None:
        """Take some cases for invalid: they are left alone."""
        self.numbers.p[:, cases] = np.nan

    # --- solving --------------------------------------------------------------------------------

    def respond(
        self, place: FloatArray, which: Indices, memory: FloatArray | None = None
    ) -> RollerResponse:
        """Hold some of the cases at a place; (len(which), 5)."""
        p = self.numbers.p[:, which]
        p[layout.IMPOSED : layout.IMPOSED + 5] = place.T
        found = hold(p, self.numbers.cut.part(which), self.element_count, self.threads, memory)
        return RollerResponse(place.copy(), found)

    def no_response(self, cases: int) -> RollerResponse:
        """Make room for so many cases without a result."""
        cut = self.numbers.cut
        empty = Solution.empty(cases, self.element_count, cut.slices, cut.coupled)
        return RollerResponse(np.full((cases, 5), np.nan), empty)

    def equilibrium(
        self, free: BoolArray, load: FloatArray, place: FloatArray, which: Indices
    ) -> tuple[FloatArray, BoolArray, IntArray, FloatArray]:
        """Where the ring of a bearing that is this row comes to rest; (len(which), 5), m and rad.

        As `rows.row.SelfBalancing`; settled too where it has run off. Found in one go by the
        kernels.
        """
        p = self.numbers.p[:, which]
        p[layout.FREE : layout.FREE + 5] = free.T
        p[layout.APPLIED : layout.APPLIED + 5] = load.T
        p[layout.IMPOSED : layout.IMPOSED + 5] = place.T
        cut = self.numbers.cut.part(which)
        rings, states, settled, steps = settle(p, cut, self.element_count, self.threads)
        reach = np.abs(rings[:, :3]).max(axis=1)
        tilted = p[layout.ARM] * np.abs(rings[:, 3:]).max(axis=1)
        off = np.maximum(reach, tilted) > RUN_OFF * p[layout.DIAMETER]
        return rings, settled | off, steps, _memory_of(rings, states)

    def first_contact(self) -> FloatArray:
        """Place along x where the unloaded rollers touch, from which x counts; (cases,), m."""
        return np.zeros(self.cases)

    def press_in(self, force: FloatArray) -> FloatArray:
        """Place along x under an axial force at rest; (cases,), m, NaN where there is none."""
        p = self.numbers.p.copy()
        p[[layout.CENTRIFUGAL, layout.MOMENT]] = 0.0
        still = replace(self, numbers=replace(self.numbers, p=p))
        found = np.full(self.cases, np.nan)
        alike = alike_in_all_cases(p) and alike_in_all_cases(force) and self.numbers.cut.alike
        which = np.flatnonzero(self.valid & np.isfinite(force))
        which = which[:1] if alike else which
        free, load = np.zeros((len(which), 5), np.bool_), np.zeros((len(which), 5))
        free[:, 0], load[:, 0] = True, force[which]
        place, _, _, memory = still.equilibrium(free, load, np.zeros_like(load), which)
        force_there = still.respond(place, which, memory).force[:, 0]
        near = np.abs(force_there - force[which]) <= 1e-9 * np.abs(force[which])
        found[which] = np.where(near, place[:, 0], np.nan)
        return np.full(self.cases, found[0]) if alike else found

    def answer(
        self, held: Response, control: FloatArray, shown: IntArray, lost: BoolArray
    ) -> RollerAnswer:
        """Keep what the tables are made from, of cases that are not lost."""
        rollers = cast(RollerResponse, held)
        solution = rollers.solution
        solution.state[lost], rollers.place[lost] = np.nan, np.nan
        if len(solution.loads):
            solution.loads[lost] = np.nan
        codes = np.broadcast_to(shown, (self.cases, self.element_count))
        return RollerAnswer(
            self.numbers, rollers.place, solution.state, solution.loads, np.asarray(codes)
        )


def roller_row(bearing: RollerParameters, running: Running) -> RollerRow:
    """The numbers of a row of rollers; there is but one path, fast or not."""
    with np.errstate(invalid="ignore", divide="ignore"):
        numbers = numbers_of(bearing, running)
    p = numbers.p
    nothing = np.full(running.cases, np.nan)
    angle = numbers.geometry.axis + numbers.geometry.half_angle
    geometry = RowGeometry(
        ball_diameter=p[layout.DIAMETER].copy(),
        pitch_diameter=2.0 * p[layout.ARM],
        inner_conformity=nothing,
        outer_conformity=nothing,
        free_contact_angle=angle,
        modulus=numbers.geometry.modulus,
        effective_length=p[layout.LENGTH].copy(),
    )
    return RollerRow(numbers, bearing.element_count, geometry, running.threads)


@frozen
class RollerAnswer:
    """Where the rollers of solved cases are: what their tables are made from."""

    numbers: Numbers
    place: FloatArray
    state: FloatArray
    loads: FloatArray
    shown: IntArray

    def part(self, index: Index) -> RollerAnswer:
        """Return some of the cases."""
        return RollerAnswer(
            numbers=self.numbers.part(index),
            place=self.place[index],
            state=self.state[index],
            loads=self.loads[index] if len(self.loads) else self.loads,
            shown=self.shown[index],
        )

    def grip(self) -> FloatArray:
        """How deep each roller's deepest slice is pressed into the inner ring; of a gap too."""
        approach, turn = self._inner()
        return np.asarray(self._depth(0, approach, turn).max(axis=-1))

    def _inner(self) -> tuple[FloatArray, FloatArray]:
        """Approach of the rollers' middles to the inner race, and their turn against it."""
        p, shift, turn = self.numbers.p[:, :, np.newaxis], self.state[..., 0], self.state[..., 1]
        approach = p[layout.INNER_SHIFT] * shift + p[layout.INNER_TURN] * turn - p[layout.GAP]
        return approach, turn

    def _depth(self, race: int, approach: FloatArray, slope: FloatArray) -> FloatArray:
        """How deep each slice of each roller is in a race; (cases, rollers, slices), m."""
        cut = self.numbers.cut
        depth = approach[..., np.newaxis] + slope[..., np.newaxis] * cut.place[:, np.newaxis]
        return np.asarray(depth - cut.drops[:, race][:, np.newaxis])

    def tables(self) -> Tables:
        """Evaluate every slice of every roller of every case."""
        n, g, p = self.numbers, self.numbers.geometry, self.numbers.p[:, :, np.newaxis]
        cases, rollers = self.shown.shape
        azimuth, ring = _seen(self.numbers.p, self.place, rollers)
        shift = self.state[..., 0]
        inner, turn = self._inner()
        outer = p[layout.OUTER_SINE] * ring[0] + p[layout.OUTER_COSINE] * ring[1]
        outer = outer + p[layout.LEVER] * ring[2] + p[layout.OUTER_SHIFT] * shift
        outer = outer + p[layout.OUTER_TURN] * turn - p[layout.GAP]
        tilt = ring[2] + turn
        races = [
            self._line(race, approach, slope)
            for race, (approach, slope) in enumerate(((inner, turn), (outer, -tilt)))
        ]
        known = 0.0 * shift

        def wide(values: FloatArray) -> FloatArray:
            return values[:, np.newaxis] + known

        motion = n.motion
        elements = Elements(
            row=np.zeros(rollers, np.int64),
            azimuth=azimuth,
            centrifugal_force=wide(n.centrifugal),
            gyroscopic_moment=wide(n.gyroscopic),
            orbital_speed=wide(motion.orbital_speed),
            ball_speed=wide(motion.ball_speed),
            attitude=wide(motion.attitude),
            yaw=np.zeros((cases, rollers)),
            raceway_control=self.shown,
        )
        pressed = [
            Pressed(load, Angle(wide(angle)), deep, approach, wide(spin), wide(roll))
            for (load, deep, _), approach, angle, spin, roll in (
                (races[0], inner, g.axis - g.half_angle, motion.inner_spin, motion.inner_roll),
                (races[1], outer, g.axis + g.half_angle, motion.outer_spin, motion.outer_roll),
            )
        ]
        force = self._rib_force(ring, turn, races[0][0], races[1][0])
        place = np.broadcast_to(n.cut.place[:, np.newaxis], races[0][2].pressure.shape)
        found = Rollers(
            tilt=-tilt,
            rib_force=force,
            rib_moment=g.rib_arm[:, np.newaxis] * force,
            slice_place=place + known[..., np.newaxis],
            inner=races[0][2],
            outer=races[1][2],
        )
        return Tables(elements, pressed[0], pressed[1], rollers=found)

    def _line(
        self, race: int, approach: FloatArray, slope: FloatArray
    ) -> tuple[FloatArray, FloatArray, Line]:
        """Load of each roller and greatest deflection of its slices, with the line itself."""
        n, cut = self.numbers, self.numbers.cut
        length = n.p[layout.LENGTH][:, np.newaxis, np.newaxis]
        depth = np.maximum(self._depth(race, approach, slope), 0.0)
        if cut.coupled:
            load = self.loads[:, :, race]
        else:
            constant = n.p[layout.INNER_CONSTANT + race][:, np.newaxis, np.newaxis]
            load = constant / length * depth**EXPONENT
        curvature = cut.curvature[:, race][:, np.newaxis]
        modulus = n.geometry.modulus[:, np.newaxis, np.newaxis]
        line = Line(
            load_per_length=load,
            pressure=max_pressure(load, curvature, modulus),
            half_width=half_width(load, curvature, modulus),
        )
        total = load.sum(axis=-1) * (length[..., 0] / cut.slices)
        return total, np.where(total > 0.0, depth.max(axis=-1), 0.0 * total), line

    def _rib_force(
        self,
        ring: tuple[FloatArray, FloatArray, FloatArray],
        turn: FloatArray,
        inner: FloatArray,
        outer: FloatArray,
    ) -> FloatArray:
        """Rib force of tapered rollers from the balance along the rib's normal, else by its law."""
        n, g, p = self.numbers, self.numbers.geometry, self.numbers.p[:, :, np.newaxis]
        if n.tapered:
            epsilon, half, axis = (a[:, np.newaxis] for a in (g.rib_angle, g.half_angle, g.axis))
            thrown = n.centrifugal[:, np.newaxis] * np.sin(axis - epsilon)
            return outer * np.sin(half + epsilon) + inner * np.sin(half - epsilon) + thrown
        apart = ring[0] + p[layout.RIB_LEVER] * (ring[2] + 2.0 * turn)
        ahead = p[layout.RIB_AHEAD] * np.maximum(apart - p[layout.RIB_PLAY], 0.0)
        behind = p[layout.RIB_BEHIND] * np.maximum(-apart - p[layout.RIB_PLAY], 0.0)
        return np.asarray(ahead - behind)


def _seen(
    p: FloatArray, place: FloatArray, rollers: int
) -> tuple[FloatArray, tuple[FloatArray, FloatArray, FloatArray]]:
    """Azimuths in [0, 2π), and A, b, θ of the inner ring at every roller; (cases, rollers)."""
    c0, s0 = p[layout.COS_FIRST][:, np.newaxis], p[layout.SIN_FIRST][:, np.newaxis]
    c, s = directions(rollers)
    cosine, sine = c * c0 - s * s0, s * c0 + c * s0
    x, y, z, ry, rz = (one[:, np.newaxis] for one in place.T)
    tilt = ry * cosine - rz * sine
    ring = x + p[layout.ARM][:, np.newaxis] * tilt, y * sine + z * cosine, tilt
    first = np.arctan2(s0, c0) + 2.0 * np.pi * np.arange(rollers) / rollers
    wrapped = np.mod(first, 2.0 * np.pi)
    return np.where(wrapped < 2.0 * np.pi, wrapped, 0.0), ring
