"""What a row of rolling elements answers, whatever its elements are.

Many cases of one row, each *held* at a place of its inner ring: x, y, z (m), ry, rz (rad) in the
row's own frame, in which it carries axial load toward +x. It answers force and stiffness, the size
of the forces that make them up and how it went; afterwards its tables. `rolamento.system` puts rows
between rings by `Row` alone; what only some rows can is asked by the small protocols behind it.

All arrays run over cases and are in SI; forces are those of the ring on the row (N, N·m).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol, Self, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from rolamento.case.model import Model
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.solved import Answer, Index

Indices = NDArray[np.intp]
IntArray = NDArray[np.int64]


@frozen
class RowSizes:
    """What a system of rows needs to know to begin and to end; (cases,) each, SI.

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
    """What the result names a row's geometry; (cases,) each, as `rolamento.solved.Rows`.

    effective_length: NaN of balls.
    """

    ball_diameter: FloatArray
    pitch_diameter: FloatArray
    inner_conformity: FloatArray
    outer_conformity: FloatArray
    free_contact_angle: FloatArray
    modulus: FloatArray
    effective_length: FloatArray


@frozen(eq=False, kw_only=True)
class Running:
    """How a row runs in many cases, and what may solve them; numbers or arrays (cases,), SI.

    Attributes
    ----------
    cases
        how many
    inner_speed, outer_speed
        of the rings
    azimuth
        of the first element
    spacing
        between the rows of the bearing, where it is given
    model
        what acts on the elements
    record
        the row's record where all cases have its geometry, so that what follows from it may be
        known already; None where that varies
    threads
        as many as there are processors by default
    fast
        whether the fast path is tried
    """

    cases: int
    inner_speed: Any
    outer_speed: Any
    azimuth: Any
    spacing: Any
    model: Model
    record: Any
    threads: int | None = None
    fast: bool = True

    def column(self, value: Any) -> FloatArray:
        """A number or an array as a new array over the cases."""
        return np.array(np.broadcast_to(np.asarray(value, np.float64), self.cases))


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

    @property
    def memory(self) -> FloatArray | None:
        """Numbers from which the row may begin at a place nearby; (cases, any).

        NaN where there are none; None of a row that always begins anew.
        """
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
        """For the system."""
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

    def respond(
        self, place: FloatArray, which: Indices, memory: FloatArray | None = None
    ) -> Response:
        """Hold some of the cases at a place; (len(which), 5).

        memory: of the response of the same cases at a place nearby; (len(which), any).
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

    def answer(
        self, held: Response, control: FloatArray, shown: IntArray, lost: BoolArray
    ) -> Answer:
        """Keep what the tables are made from, of cases that are not lost.

        control: which race guided each element, as of `Guided`; shown: what the result says of
        that; (cases, elements) each.
        """
        ...


@runtime_checkable
class Guided(Protocol):
    """A row whose elements may be guided by either race: raceway control."""

    def guided(self, control: FloatArray) -> Self:
        """The same row, guided so: +1 by the outer race, -1 by the inner.

        control: (cases, elements), or (1, elements) for all cases alike.
        """
        ...

    def verdict(self, held: Response, which: Index = slice(None)) -> IntArray:
        """Which race would guide each element by the row's own criterion; (cases, elements).

        which: the cases that are held.
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
    ) -> tuple[FloatArray, BoolArray, IntArray, FloatArray | None]:
        """Where the ring comes to rest, whether it did, in how many steps, and its memory there.

        (len(which), 5), (len(which),) twice, and as `Response.memory`.

        free: whether the load is given on a degree of freedom, else the place; place: that, or
        where to begin; of the chosen cases, (len(which), 5) each.
        """
        ...


class Alone(Response, Protocol):
    """The answer of a row that has balanced its own ring: where that is, and in how many steps."""

    @property
    def place(self) -> FloatArray:
        """(cases, 5), m and rad."""
        ...

    @property
    def iterations(self) -> IntArray:
        """(cases,)."""
        ...

    @property
    def unsupported(self) -> IntArray:
        """The degree of freedom that nothing holds, or -1; (cases,)."""
        ...


@runtime_checkable
class WholeBearing(Guided, Protocol):
    """A row that is a whole bearing by itself: ring and elements are balanced in one go."""

    @property
    def shape(self) -> tuple[int, int]:
        """Cases and elements."""
        ...

    def asked(self, free: BoolArray, load: FloatArray, place: FloatArray) -> Self:
        """Put in what is asked of the ring: as `SelfBalancing`, of all cases."""
        ...

    def solve(self, which: Index = slice(None)) -> Alone:
        """Balance ring and elements of all cases, or some."""
        ...

    def rolled(self, start: Alone, traction: Traction) -> Alone:
        """Let friction alone move the elements; start: under outer raceway control."""
        ...


class Film(Protocol):
    """A film between elements and races, that shears instead of Coulomb's friction."""

    @property
    def lift(self) -> FloatArray:
        """Its thickness where it enters the geometry, else zero; (cases, elements, 2), m."""
        ...

    def slip_speed(self, case: int, across: FloatArray, along: FloatArray) -> FloatArray:
        """The slip at which the sheared film would reach the limiting friction, μ p h / η.

        across, along: nodes in units of the axes, (nodes,). Returns (elements, 2, nodes), m/s.
        """
        ...


@frozen
class Traction:
    """What friction control takes beside the row: μ and the cage's drag (N·m), (cases,)."""

    friction: FloatArray
    cage_drag: FloatArray
    mesh: str
    film: Film | None = None


@frozen
class OnRing:
    """Rows on one ring, as their kernels may solve them together.

    Lengths are in m; tilts times the first row's arm, and moments over it, make one unit of all.

    Attributes
    ----------
    which
        the cases of the rows that are asked for; (n,)
    ways
        how each row faces, +1 or -1
    levers, arms, press
        of each row: how far from its centre the ring's is, the radius on which a tilt acts, and how
        far the clamped rings press it in; (n,) each
    sprung
        whether springs push the outer rings of the rows that face -x: a sixth unknown
    free, target, start
        which unknowns are free, the load that is asked of them, and where they begin; (n, 6)
    sound
        which cases can be solved; (n,)
    tangents
        whether the rows' own stiffness is asked for too
    """

    which: Indices
    ways: Sequence[float]
    levers: Sequence[FloatArray]
    arms: Sequence[FloatArray]
    press: Sequence[FloatArray]
    sprung: bool
    free: BoolArray
    target: FloatArray
    start: FloatArray
    sound: BoolArray
    tangents: bool = False


@frozen
class Proposal:
    """Where rings and rows of many cases came to rest, and whether that may be shown.

    place, force (n, 6), stiffness (n, 6, 6), SI; residual, steps, sound (n,).
    """

    place: FloatArray
    force: FloatArray
    stiffness: FloatArray
    residual: FloatArray
    steps: IntArray
    sound: BoolArray
    rows: Sequence[Response]


@runtime_checkable
class Joint(Protocol):
    """A row that its kernels can balance together with others on one ring."""

    def together(self, rows: Sequence[Row], ring: OnRing) -> Proposal | None:
        """Balance the rings of some cases, with all their rows, of which this is the first.

        None where the kernels do not know such rows, or it takes no compiler.
        """
        ...
