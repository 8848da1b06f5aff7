"""A row of balls as `rolamento.rows.row` asks for it: from numbers of a case to its tables."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import ClassVar, Final, cast

import numpy as np

from rolamento import status
from rolamento.case.parameters import BallParameters
from rolamento.geometry import Angle, Race
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.rows.ball import layout
from rolamento.rows.ball.detail import (
    BallTable,
    ContactTable,
    axial_load,
    ball_table,
    contact_tables,
)
from rolamento.rows.ball.problem import (
    Columns,
    apply_model,
    bearing_column,
    bearing_columns,
    ring_arms,
)
from rolamento.rows.ball.rolling import Rolling as Motion
from rolamento.rows.ball.run import BallResponse, ball_azimuths, row_verdict, solve_columns
from rolamento.rows.row import (
    Alone,
    Indices,
    OnRing,
    Proposal,
    Response,
    Row,
    RowGeometry,
    RowSizes,
    Running,
    Traction,
)
from rolamento.solved import (
    Elements,
    Index,
    IntArray,
    Rolling,
    RollingContacts,
    Tables,
    taken,
)

__all__ = ["BallRow", "ball_row"]


PRESS_STEPS: Final = 60
PRESS_PRECISION: Final = 1e-15
"""Fraction of the distance between groove centres: the last step of a row that is pressed in."""


@frozen
class BallRow:
    """Many cases of a row of balls; p: their numbers as `layout` has them, a column a case.

    control: the race that guides each ball, +1 outer or -1 inner; (cases or 1, balls).
    """

    p: Columns
    element_count: int
    geometry: RowGeometry
    control: FloatArray
    threads: int | None = None
    fast: bool = True
    faces: ClassVar = (1.0,)
    floats: ClassVar = False
    aside: ClassVar = None

    @property
    def shape(self) -> tuple[int, int]:
        """Cases and balls."""
        return self.p.cases, self.element_count

    @property
    def cases(self) -> int:
        """Number of cases."""
        return self.p.cases

    @property
    def valid(self) -> BoolArray:
        """Which cases have numbers that can be solved; (cases,)."""
        p = self.p
        return np.asarray(np.isfinite(p.duty).all(axis=0) & np.isfinite(p.bearing).all(axis=0))

    @property
    def sizes(self) -> RowSizes:
        """For the system."""
        p = self.p
        reach = p[layout.INNER_LENGTH] + p[layout.OUTER_LENGTH]
        sine = np.clip(p[layout.AXIAL_OFFSET], 0.0, None) / reach
        own = (p[layout.ARM], p[layout.BALL_DIAMETER], reach, p[layout.SERIES_STIFFNESS], sine)
        return RowSizes(*(np.broadcast_to(numbers, p.cases) for numbers in own))

    def invalidate(self, cases: BoolArray) -> None:
        """Take some cases for invalid: they are left alone."""
        self.p.duty[:, cases] = np.nan

    def with_play(self, play: FloatArray) -> BallRow:
        """Draw the unloaded grooves apart by half of a diametral play; (cases,), m.

        The grooves of a self-aligning bearing stand where its rows do, whatever its play.
        """
        bearing = self.p.bearing + np.zeros(self.cases)
        p = Columns(self.p.duty.copy(), bearing)
        p[layout.RADIAL_OFFSET] -= 0.5 * play
        return replace(self, p=p)

    # --- solving --------------------------------------------------------------------------------

    def asked(self, free: BoolArray, load: FloatArray, place: FloatArray) -> BallRow:
        """Put in what is asked of the ring of a bearing that is this row; (cases, 5) each.

        In its own columns, which nobody else has: copying millions of them would show.
        """
        p, arms = self.p, ring_arms(self.p)
        p[layout.FREE : layout.FREE + 5] = free.T
        p[layout.APPLIED : layout.APPLIED + 5] = load.T / arms
        p[layout.IMPOSED : layout.IMPOSED + 5] = place.T * arms
        return self

    def guided(self, control: FloatArray) -> BallRow:
        """The same row, its balls guided so; (cases or 1, balls)."""
        return replace(self, control=control)

    def control_of(self, which: Index) -> FloatArray:
        """What guides the balls of some of the cases; (len(which) or 1, balls)."""
        return self.control if len(self.control) == 1 else self.control[which]

    def solve(self, which: Index = slice(None), memory: FloatArray | None = None) -> BallResponse:
        """Balance ring and balls of a bearing that is this row: the monolithic fast path.

        The row has been `asked`; memory: as of `respond`.
        """
        return solve_columns(
            self.p.of(which), self.control_of(which), self.element_count,
            threads=self.threads, fast=self.fast, memory=memory,
        )  # fmt: skip

    def respond(
        self, place: FloatArray, which: Indices, memory: FloatArray | None = None
    ) -> BallResponse:
        """Hold some of the cases at a place; (len(which), 5)."""
        p = self.p.of(which)
        p[layout.FREE : layout.FREE + 5] = 0.0
        p[layout.APPLIED : layout.APPLIED + 5] = 0.0
        p[layout.IMPOSED : layout.IMPOSED + 5] = place.T * ring_arms(p)
        return replace(self, p=p, control=self.control_of(which)).solve(memory=memory)

    def together(self, rows: Sequence[Row], ring: OnRing) -> Proposal | None:
        """Balance rings with several rows of balls in lanes; None where there are others."""
        from rolamento.rows.ball import sets

        balls = [row for row in rows if isinstance(row, BallRow) and row.fast]
        return sets.settle(balls, ring) if len(balls) == len(rows) else None

    def no_response(self, cases: int) -> BallResponse:
        """Make room for so many cases without a result."""
        return BallResponse.empty(cases, self.element_count, ring_arms(self.p).T)

    def first_contact(self) -> FloatArray:
        """Place along x where the unloaded balls touch; (cases,), m."""
        p = self.p
        length = p[layout.INNER_LENGTH] + p[layout.OUTER_LENGTH]
        square = np.maximum(length**2 - p[layout.RADIAL_OFFSET] ** 2, 0.0)
        touching = np.sqrt(square) - p[layout.AXIAL_OFFSET]
        return np.broadcast_to(np.where(p[layout.ONE_SIDED] > 0.0, 0.0, touching), p.cases)

    def press_in(self, force: FloatArray) -> FloatArray:
        """Place along x under an axial force at rest; (cases,), m, NaN where there is none.

        All balls are alike: one equation, Z Q sin α = F, whose force grows with x.
        """
        p, count = self.p, self.element_count
        reach = p[layout.INNER_LENGTH] + p[layout.OUTER_LENGTH]
        a2, stiffness = p[layout.RADIAL_OFFSET], p[layout.SERIES_STIFFNESS]
        with np.errstate(invalid="ignore", divide="ignore"):
            wanted = np.where(force > 0.0, force / count, np.nan)
            sine = np.sqrt(np.maximum(reach**2 - a2**2, 0.0)) / reach
            far = reach + (wanted / (stiffness * np.maximum(sine, 0.2))) ** (2.0 / 3.0)
            # the groove's axial offset, from too far on: the force bends upward
            a1 = np.sqrt(far**2 - np.minimum(a2, far) ** 2)
            for _ in range(PRESS_STEPS):
                load, sine, cosine, approach, slope = axial_load(p, a1, a2)
                step = (load * sine - wanted) / slope
                a1 = np.maximum(a1 - step, 0.5 * a1)
                if not (np.abs(step) > PRESS_PRECISION * reach).any():
                    break
            near = np.abs(load * sine - wanted) <= status.TOLERANCE * wanted
            held = near & (approach <= status.GREATEST_APPROACH * p[layout.BALL_DIAMETER])
            held &= (cosine > p[layout.INNER_EDGE]) & (cosine > p[layout.OUTER_EDGE])
            return np.asarray(np.where(held, a1 - p[layout.AXIAL_OFFSET], np.nan))

    def verdict(self, held: Response, which: Index = slice(None)) -> IntArray:
        """Jones's criterion for every ball; (cases, balls)."""
        return row_verdict(self.p.of(which), self.control_of(which), cast(BallResponse, held))

    def rolled(self, start: Alone, traction: Traction) -> BallResponse:
        """Let friction alone move the balls of a bearing that is this row.

        start: under outer raceway control, of all cases.
        """
        from rolamento.rows.ball.traction.solve import solve_rolling

        return solve_rolling(
            self.p, cast(BallResponse, start), self.element_count, traction.friction,
            traction.cage_drag, mesh=traction.mesh, film=traction.film, threads=self.threads,
        )  # fmt: skip

    def answer(
        self, held: Response, control: FloatArray, shown: IntArray, lost: BoolArray
    ) -> BallAnswer:
        """Keep what the tables are made from, of cases that are not lost."""
        balls = cast(BallResponse, held)
        balls.position[lost], balls.displacement[lost] = np.nan, np.nan
        if balls.motion is not None:
            balls.motion.forget(lost)
        return BallAnswer(self.p, control, balls.position, balls.displacement, shown, balls.motion)


def ball_row(bearing: BallParameters, running: Running) -> BallRow:
    """The numbers of a row of balls."""
    cases = running.cases
    if running.record is None:
        with np.errstate(invalid="ignore", divide="ignore"):
            own = bearing_columns(bearing, cases)
    else:
        own = bearing_column(running.record).copy()
    p = Columns(np.empty((layout.DUTY, cases)), own)  # zeros would come page by page
    p.duty[...] = 0.0
    p[layout.INNER_SPEED] = running.inner_speed
    p[layout.OUTER_SPEED] = running.outer_speed
    apply_model(p, running.model)
    p[layout.COS_FIRST] = np.cos(running.azimuth)
    p[layout.SIN_FIRST] = np.sin(running.azimuth)
    angle = 0.0 if bearing.contact_angle is None else bearing.contact_angle
    numbers = (
        bearing.ball_diameter, bearing.pitch_diameter, bearing.inner_conformity,
        bearing.outer_conformity, angle, p[layout.MODULUS], np.nan,
    )  # fmt: skip
    geometry = RowGeometry(*(np.broadcast_to(np.asarray(n, np.float64), cases) for n in numbers))
    balls = bearing.element_count
    return BallRow(p, balls, geometry, np.ones((1, balls)), running.threads, running.fast)


@frozen(eq=False, slots=False)
class BallAnswer:
    """Where the balls of solved cases are: what their tables are made from."""

    p: Columns
    control: FloatArray
    position: FloatArray
    displacement: FloatArray
    shown: IntArray
    motion: Motion | None

    def part(self, index: Index) -> BallAnswer:
        """Return some of the cases."""
        return BallAnswer(
            self.p.of(index),
            self.control[index],
            self.position[index],
            self.displacement[index],
            self.shown[index],
            None if self.motion is None else taken(self.motion, index),
        )

    def grip(self) -> FloatArray:
        """How deep each element is pressed into the inner ring."""
        return self._contacts[0].approach

    def pressed_on(self, race: Race) -> tuple[FloatArray, Angle]:
        """Load and angle of every contact with a race."""
        table = self._contacts[0 if race == "inner" else 1]
        return table.load, table.angle

    @cached_property
    def _contacts(self) -> tuple[ContactTable, ContactTable]:
        """Inner and outer."""
        return contact_tables(self.p, self.displacement, self.position, self.motion)

    def tables(self) -> Tables:
        """Evaluate every ball of every case."""
        found = ball_table(
            self.p, self.control, self.displacement, self.position, self.motion, self._contacts
        )
        motion, balls = found.motion, self.position.shape[1]
        elements = Elements(
            row=np.zeros(balls, np.int64),
            azimuth=ball_azimuths(self.p, balls),
            centrifugal_force=found.centrifugal_force,
            gyroscopic_moment=found.gyroscopic_moment,
            orbital_speed=motion.orbital_speed,
            ball_speed=motion.ball_speed,
            attitude=motion.attitude,
            yaw=found.yaw,
            raceway_control=self.shown,
        )
        rolling = None if self.motion is None else self._rolling(self.motion, found)
        return Tables(elements, found.inner, found.outer, rolling)

    def _rolling(self, motion: Motion, balls: BallTable) -> Rolling | None:
        if not np.isfinite(motion.cage_speed).any():
            return None
        return Rolling(
            cage_speed=motion.cage_speed,
            control_cage_speed=motion.control_cage_speed,
            inner_torque=motion.torque("inner"),
            outer_torque=motion.torque("outer"),
            imbalance=motion.imbalance,
            angular_velocity=motion.angular_velocity,
            inner=self._rolling_contacts(motion, "inner", balls.inner.angle.value),
            outer=self._rolling_contacts(motion, "outer", balls.outer.angle.value),
        )

    def _rolling_contacts(self, motion: Motion, race: Race, angle: FloatArray) -> RollingContacts:
        """The friction of one race on the balls."""
        inner = race == "inner"
        forces = motion.inner if inner else motion.outer
        speed = self.p[layout.INNER_SPEED if inner else layout.OUTER_SPEED][:, np.newaxis]
        omega, cage = motion.angular_velocity, motion.cage_speed[:, np.newaxis]
        across = (omega[..., 0] - speed) * np.cos(angle) - omega[..., 2] * np.sin(angle)
        radius = 0.5 * self.p[layout.BALL_DIAMETER][:, np.newaxis] * (-1.0 if inner else 1.0)
        slip = (speed - cage) * motion.radius[:, np.newaxis] - radius * across
        # the normal load has no part along t, nor along the orbit
        sideways = forces[..., 0] * np.cos(angle) - forces[..., 1] * np.sin(angle)
        return RollingContacts(
            power=motion.power[..., 0 if inner else 1],
            slip=np.where(forces.any(axis=-1), slip, np.nan),
            force_along=forces[..., 2],
            force_across=sideways,
        )
