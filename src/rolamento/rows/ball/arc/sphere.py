"""A row of balls whose outer race is a sphere about the bearing's centre: self-aligning.

The sphere looks the same from everywhere, so that a tilt of the inner ring takes balls and cage
along, and leaves everything as it was, seen from the ring. With R the rotation of the ring's tilt
(0, ry, rz), u its displacement (x, y, z) and f the force of the same row without tilt,

    F = R f(Rᵀ u),      M = 0 about the centre.

The moment is exactly zero at rest: every contact with the sphere pushes through its centre. At
speed it is as long as the balls' centrifugal forces and gyroscopic moments are alike, as they are
at the speed of one cage; what is left of them is neglected.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Self, cast

import numpy as np

from rolamento.case.parameters import BallParameters
from rolamento.errors import InputError
from rolamento.geometry import sphere_conformity
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.rotation import rotation_of
from rolamento.records import frozen
from rolamento.rows.ball.row import BallAnswer, BallRow, ball_row
from rolamento.rows.ball.run import BallResponse
from rolamento.rows.row import (
    Indices,
    IntArray,
    OnRing,
    Proposal,
    Response,
    Row,
    RowGeometry,
    RowSizes,
    Running,
)
from rolamento.solved import Index
from rolamento.words import said

__all__ = ["SphereRow", "from_outside", "from_ring"]


@dataclass(slots=True)
class SphereResponse:
    """Balls in their places, seen from the tilted ring, and what they answer to the outer one."""

    balls: BallResponse
    force: FloatArray
    stiffness: FloatArray

    @property
    def face_forces(self) -> FloatArray:
        """(cases, 1, 5)."""
        return self.force[:, np.newaxis]

    @property
    def scale(self) -> FloatArray:
        """(cases,), N."""
        return self.balls.scale

    @property
    def number(self) -> IntArray:
        """(cases,)."""
        return self.balls.number

    @property
    def residual(self) -> FloatArray:
        """(cases,)."""
        return self.balls.residual

    @property
    def safe_path(self) -> BoolArray:
        """(cases,)."""
        return self.balls.safe_path

    @property
    def memory(self) -> FloatArray | None:
        """As the balls'."""
        return self.balls.memory

    def put(self, cases: Indices, part: Self) -> None:
        """Copy what some of the cases answered to their places."""
        self.balls.put(cases, part.balls)
        self.force[cases], self.stiffness[cases] = part.force, part.stiffness


@frozen
class SphereRow:
    """Many cases of a row of balls in a sphere; row: the same without tilt.

    axial: how far it is from the centre; (cases,), m.
    """

    row: BallRow
    axial: FloatArray

    @property
    def cases(self) -> int:
        """Number of cases."""
        return self.row.cases

    @property
    def element_count(self) -> int:
        """Balls in the row."""
        return self.row.element_count

    @property
    def faces(self) -> tuple[float, ...]:
        """One groove a ring."""
        return self.row.faces

    @property
    def floats(self) -> bool:
        """Whether the row locates the shaft axially: its grooves do."""
        return False

    @property
    def aside(self) -> FloatArray | None:
        """How far its plane is from the sphere's centre; (cases,)."""
        return self.axial

    @property
    def sizes(self) -> RowSizes:
        """For the system."""
        return self.row.sizes

    @property
    def geometry(self) -> RowGeometry:
        """For the result."""
        return self.row.geometry

    @property
    def valid(self) -> BoolArray:
        """Which cases have numbers that can be solved; (cases,)."""
        return self.row.valid

    def invalidate(self, cases: BoolArray) -> None:
        """Take some cases for invalid: they are left alone."""
        self.row.invalidate(cases)

    def guided(self, control: FloatArray) -> SphereRow:
        """The same row, its balls guided so; (cases or 1, balls)."""
        return replace(self, row=self.row.guided(control))

    def respond(
        self, place: FloatArray, which: Indices, memory: FloatArray | None = None
    ) -> SphereResponse:
        """Hold some of the cases at a place; (len(which), 5)."""
        seen = np.zeros_like(place)
        seen[:, :3] = from_ring(place[:, 3:], place[:, :3])
        return self.turned(self.row.respond(seen, which, memory), place)

    def together(self, rows: Sequence[Row], ring: OnRing) -> Proposal | None:
        """Balance rings whose tilt is given: as the tilted ring sees them, they are not tilted."""
        spheres = [row for row in rows if isinstance(row, SphereRow)]
        if len(spheres) < len(rows):
            return None
        tilt, shifts = (
            ring.start[:, 3:5] / ring.arms[0][:, np.newaxis],
            np.arange(ring.free.shape[1]) < 3,
        )
        target, start = np.zeros_like(ring.target), np.zeros_like(ring.start)
        target[:, :3] = from_ring(tilt, ring.target[:, :3])
        start[:, :3] = from_ring(tilt, ring.start[:, :3])
        sound = ring.sound & (ring.free == shifts).all(axis=1)
        seen = replace(ring, target=target, start=start, sound=sound, tangents=True)
        found = self.row.together([row.row for row in spheres], seen)
        if found is None:
            return None
        place = found.place
        place[:, :3] = from_outside(tilt, place[:, :3])
        place[:, 3:5] = tilt
        force, stiffness = np.zeros_like(found.force), np.zeros_like(found.stiffness)
        answers = []
        for row, held, way in zip(spheres, found.rows, ring.ways, strict=True):
            faced = np.array((way, 1.0, 1.0, way, way))
            answers.append(row.turned(cast(BallResponse, held), place[:, :5] * faced))
            force[:, :5] += faced * answers[-1].force
            stiffness[:, :5, :5] += faced[:, np.newaxis] * answers[-1].stiffness * faced
        return replace(found, force=force, stiffness=stiffness, rows=answers)

    def turned(self, balls: BallResponse, place: FloatArray) -> SphereResponse:
        """What balls that are held where a tilted ring has them answer to the outer ring."""
        rotation, turns = rotation_of(place[:, 3], place[:, 4])
        back = np.swapaxes(rotation, 1, 2)
        own, tangent = balls.force[:, :3], balls.stiffness[:, :3, :3]
        force, stiffness = np.zeros_like(place), np.zeros((len(place), 5, 5))
        force[:, :3] = _times(rotation, own)
        stiffness[:, :3, :3] = rotation @ tangent @ back
        for axis, turn in zip((3, 4), turns, strict=True):
            moved = _times(np.swapaxes(turn, 1, 2), place[:, :3])
            change = _times(turn, own) + _times(rotation, _times(tangent, moved))
            stiffness[:, :3, axis] = change
        return SphereResponse(balls, force, stiffness)

    def no_response(self, cases: int) -> SphereResponse:
        """Make room for so many cases without a result."""
        empty = np.full((cases, 5), np.nan)
        return SphereResponse(self.row.no_response(cases), empty, np.full((cases, 5, 5), np.nan))

    def first_contact(self) -> FloatArray:
        """Place along x where the unloaded balls touch; (cases,), m."""
        return self.row.first_contact()

    def press_in(self, force: FloatArray) -> FloatArray:
        """No preload is put on such rows; (cases,), NaN."""
        return np.full(self.cases, np.nan)

    def verdict(self, held: Response, which: Index) -> IntArray:
        """Jones's criterion for every ball; (cases, balls)."""
        return self.row.verdict(cast(SphereResponse, held).balls, which)

    def answer(
        self, held: Response, control: FloatArray, shown: IntArray, lost: BoolArray
    ) -> BallAnswer:
        """Keep what the tables are made from, of cases that are not lost."""
        return self.row.answer(cast(SphereResponse, held).balls, control, shown, lost)


def sphere_row(bearing: BallParameters, running: Running) -> SphereRow:
    """The numbers of a row whose outer race and place follow from its angle.

    Raises
    ------
    InputError
        If neither an angle nor a spacing says where the row is.
    """
    if bearing.contact_angle is not None:
        tangent = np.tan(bearing.contact_angle)
    elif running.spacing is not None:
        tangent = running.spacing / bearing.pitch_diameter
    else:
        raise InputError(
            said("is missing; a self-aligning bearing given by its clearance needs it"),
            field="bearing.spacing",
            example='spacing = "9 mm"',
        )
    play = 0.0 if bearing.diametral_clearance is None else bearing.diametral_clearance
    alone = bearing.with_(
        contact_angle=np.arctan(tangent),
        diametral_clearance=None,
        outer_conformity=sphere_conformity(bearing.ball_diameter, bearing.pitch_diameter, tangent),
    )
    row = ball_row(alone, replace(running, record=None))
    axial = running.column(0.5 * bearing.pitch_diameter * tangent)
    return SphereRow(row.with_play(running.column(play)), axial)


def from_ring(tilt: FloatArray, vector: FloatArray) -> FloatArray:
    """A vector (cases, 3) as a ring sees it that is tilted by (ry, rz); (cases, 2)."""
    rotation, _ = rotation_of(tilt[:, 0], tilt[:, 1])
    return _times(np.swapaxes(rotation, 1, 2), vector)


def from_outside(tilt: FloatArray, vector: FloatArray) -> FloatArray:
    """The same vector from outside again."""
    return _times(rotation_of(tilt[:, 0], tilt[:, 1])[0], vector)


def _times(matrix: FloatArray, vector: FloatArray) -> FloatArray:
    return np.asarray((matrix @ vector[..., np.newaxis])[..., 0])
