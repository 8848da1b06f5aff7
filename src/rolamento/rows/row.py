"""What a row of rolling elements answers, whatever its elements are.

Many cases of one row, each *held* at a place of its inner ring: x, y, z (m), ry, rz (rad) in the
row's own frame, in which it carries axial load toward +x. It answers force and stiffness, the size
of the forces that make them up and how it went; afterwards its tables. `assembly` puts rows on a
ring by nothing else.

All arrays run over cases and are in SI; forces are those of the ring on the row (N, N·m).
"""

from __future__ import annotations

from typing import Protocol, Self, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.solved import Answer, Index

Indices = NDArray[np.intp]
IntArray = NDArray[np.int64]


@frozen
class RowSizes:
    """What an assembly needs to know to begin and to end; (cases,) each, SI.

    arm: radius on which a tilt acts. diameter: of an element. reach: the distance between centres
    of curvature, of which an element's approach is a part. stiffness: K of one element in
    Q = K δ^1.5, roughly. sine: of its contact angle, roughly.
    """

    arm: FloatArray
    diameter: FloatArray
    reach: FloatArray
    stiffness: FloatArray
    sine: FloatArray


@frozen
class RowGeometry:
    """What the result names a row's geometry; (cases,) each, as `rolamento.solved.Rows`."""

    ball_diameter: FloatArray
    pitch_diameter: FloatArray
    inner_conformity: FloatArray
    outer_conformity: FloatArray
    free_contact_angle: FloatArray
    modulus: FloatArray
    effective_length: FloatArray | None = None


def alike_in_all_cases(numbers: FloatArray) -> bool:
    """Whether several cases, along the last axis, have the same numbers: only the loads vary."""
    return numbers.shape[-1] > 1 and bool((numbers == numbers[..., :1]).all())


class Response(Protocol):
    """A row held in many cases, and what it answers."""

    @property
    def force(self) -> FloatArray:
        """On the row; (cases, 5), N and N·m."""
        ...

    @property
    def face_forces(self) -> FloatArray:
        """The force by the row's faces; (cases, faces, 5)."""
        ...

    @property
    def stiffness(self) -> FloatArray:
        """Derivative of the force by the place; (cases, 5, 5)."""
        ...

    @property
    def scale(self) -> FloatArray:
        """Size of the forces that make it up; (cases,), N."""
        ...

    @property
    def number(self) -> IntArray:
        """How each case went: a number of `rolamento.status`; (cases,)."""
        ...

    @property
    def residual(self) -> FloatArray:
        """The largest unbalanced load of an element, over its loads; (cases,)."""
        ...

    @property
    def safe_path(self) -> BoolArray:
        """Whether the fast path needed help; (cases,)."""
        ...

    def put(self, cases: Indices, part: Self) -> None:
        """Copy what some of the cases answered to their places."""
        ...


class Row(Protocol):
    """Many cases of one row of rolling elements."""

    @property
    def cases(self) -> int:
        """Number of cases."""
        ...

    @property
    def element_count(self) -> int:
        """Elements in the row."""
        ...

    @property
    def faces(self) -> tuple[float, ...]:
        """The rows of contacts that the elements make, each +1 or -1 against the row's own way.

        One, but for elements that touch each ring twice: what is known of a row is known of each.
        """
        ...

    @property
    def floats(self) -> bool:
        """Whether it moves along the shaft without resistance: rollers without opposed ribs."""
        ...

    @property
    def aside(self) -> FloatArray | None:
        """How far its plane is from the bearing's centre, if it is held by the place of that.

        (cases,), m; None of a row that is held by the place of its own plane.
        """
        ...

    @property
    def sizes(self) -> RowSizes:
        """For the assembly."""
        ...

    @property
    def geometry(self) -> RowGeometry:
        """For the result."""
        ...

    @property
    def valid(self) -> BoolArray:
        """Which cases have numbers that can be solved; (cases,)."""
        ...

    def invalidate(self, cases: BoolArray) -> None:
        """Take some cases for invalid: they are left alone."""
        ...

    def respond(self, place: FloatArray, which: Indices, control: FloatArray) -> Response:
        """Hold some of the cases at a place; (len(which), 5).

        control: the race that guides each element, +1 outer or -1 inner, (len(which), elements);
        for rows that have such a choice.
        """
        ...

    def no_response(self, cases: int) -> Response:
        """Make room for so many cases without a result."""
        ...

    def first_contact(self) -> FloatArray:
        """Place along x where the unloaded elements touch; (cases,), m."""
        ...

    def press_in(self, force: FloatArray) -> FloatArray:
        """Place along x under an axial force at rest; (cases,), m, NaN where there is none."""
        ...

    def verdict(self, held: Response, control: FloatArray, which: Index) -> IntArray:
        """Which race would guide each element by its own criterion; (cases, elements).

        which: the cases that are held.
        """
        ...

    def answer(
        self, held: Response, control: FloatArray, shown: IntArray, lost: BoolArray
    ) -> Answer:
        """Keep what the tables are made from, of cases that are not lost.

        shown: the guiding race that they name.
        """
        ...


@runtime_checkable
class Driven(Protocol):
    """A row whose elements may be thrown along the shaft."""

    @property
    def driven(self) -> BoolArray:
        """Whether a force of their own acts on them; (cases,)."""
        ...


@runtime_checkable
class SelfBalancing(Protocol):
    """A row whose kernels find the place of a ring that holds nothing else."""

    def equilibrium(
        self, free: BoolArray, load: FloatArray, place: FloatArray, which: Indices
    ) -> tuple[FloatArray, BoolArray, IntArray]:
        """Where the ring comes to rest, whether it did, and in how many steps.

        (len(which), 5) and (len(which),).

        free: whether the load is given on a degree of freedom, else the place; place: that, or
        where to begin; of the chosen cases, (len(which), 5) each.
        """
        ...
