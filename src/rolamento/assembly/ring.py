"""Rows on one rigid inner ring, or on rings clamped on one shaft.

Every row is held where the ring holds it; the ring is in balance when what the rows answer adds up
to the load. A row that faces -x is the mirror image of one that faces +x. With the ring's
displacement u = (x, y, z, ry, rz), taken at the bearing's origin, the row at axial position a,
facing σ = ±1, has in its own frame

    x_r = σ x + e,   y_r = y + a rz,   z_r = z - a ry,   ry_r = σ ry,   rz_r = σ rz

where e is how far the clamped rings press it in. (In a self-aligning bearing a = 0: its rows know
of no tilt, see `rolamento.rows.sphere`.) Springs add a sixth unknown: how far they have
pushed the outer rings of the rows that face -x. This is v = T u + e, the ring's force is the sum of
T' f, and its stiffness the sum of T' k T. Tilts times the first row's arm make one unit of all.

Rigid-body kinematics; Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapters 8 and 9.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from rolamento.assembly.cases import Cases, PlacedRow
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.newton import Balance, balance
from rolamento.records import frozen
from rolamento.rows.ball import sets
from rolamento.rows.row import Indices, IntArray, Response, SelfBalancing
from rolamento.rows.sphere import SphereRow, from_outside, from_ring
from rolamento.status import (
    CONVERGED,
    INVALID_INPUT,
    NO_EQUILIBRIUM,
    NOT_CONVERGED,
    OVER_SHOULDER,
    OVERLOADED,
    TOLERANCE,
    UNCONSTRAINED_BALL,
)

UNKNOWNS: Final = 6
SLIDE: Final = 5  # of the spring-loaded outer rings
PRECISION: Final = 1e-10
_SHIFTS: Final = np.array([True, True, True, False, False])
ANSWERED: Final = np.zeros(16, np.bool_)
"""By verdict on a row, whether it comes with its forces; no_equilibrium while it touches."""
ANSWERED[[CONVERGED, OVERLOADED, UNCONSTRAINED_BALL, OVER_SHOULDER, NO_EQUILIBRIUM]] = True


@dataclass(slots=True)
class RingSolution:
    """Where the ring came to rest, in SI; place, force (cases, 6), stiffness (cases, 6, 6).

    The sixth is the springs' slide.
    """

    place: FloatArray
    force: FloatArray
    stiffness: FloatArray
    residual: FloatArray
    number: IntArray
    unsupported: IntArray
    iterations: IntArray
    safe_path: BoolArray
    rows: list[Response]

    def put(self, cases: Indices, part: RingSolution) -> None:
        """Copy the solution of some of the cases to their places."""
        for name in ("place", "force", "stiffness", "residual", "number", "unsupported"):
            getattr(self, name)[cases] = getattr(part, name)
        self.iterations[cases], self.safe_path[cases] = part.iterations, part.safe_path
        for whole, piece in zip(self.rows, part.rows, strict=True):
            whole.put(cases, piece)


@frozen
class _View:
    """The rows seen from the ring, scaled: their forces and stiffness, summed."""

    force: FloatArray
    stiffness: FloatArray
    scale: FloatArray
    sound: BoolArray
    rows: list[Response]


@frozen
class RowsOnRing:
    """Cases of several rows, as `guidance` asks for a system; press: how far each is pressed in."""

    cases: Cases
    press: tuple[FloatArray, ...]

    @classmethod
    def of(cls, cases: Cases) -> RowsOnRing:
        """Clamp the rings."""
        return cls(cases, pressed_in(cases))

    @property
    def shape(self) -> tuple[int, int]:
        """Cases and elements."""
        return len(self.cases), sum(placed.row.element_count for placed in self.cases.rows)

    def solve(self, control: FloatArray, which: Indices | None = None) -> RingSolution:
        """Solve all cases, or some."""
        chosen = np.arange(len(self.cases)) if which is None else which
        asked = _Asked.of(self, chosen)
        solution = _proposed(self, control, asked)
        control = np.broadcast_to(control, (len(chosen), self.shape[1]))
        near = self.cases.start is not None
        if solution is None:
            solution = _Problem.of(self, control, asked).solve()
            if not near:
                return solution
        left = solution.number == NOT_CONVERGED
        if near:  # what is not found from a neighbour's place may be from one's own
            left |= asked.sound & (solution.number == NO_EQUILIBRIUM)
        if left.any():
            again = _Asked.of(self, chosen[left], near=False)
            solution.put(np.flatnonzero(left), _Problem.of(self, control[left], again).solve())
        return solution

    def verdict(
        self, solution: RingSolution, control: FloatArray, which: Indices | None = None
    ) -> IntArray:
        """What guides every element of all cases, or some, by its row's own criterion.

        (cases, elements).
        """
        chosen = slice(None) if which is None else which
        parts = zip(self.cases.rows, solution.rows, self.split(control), strict=True)
        return np.concatenate(
            [placed.row.verdict(held, own, chosen) for placed, held, own in parts], axis=1
        )

    def split(self, control: FloatArray) -> list[FloatArray]:
        """The columns of an array over all elements, row by row."""
        ends = np.cumsum([placed.row.element_count for placed in self.cases.rows])[:-1]
        return list(np.split(control, ends, axis=1))


@frozen
class _Asked:
    """What is asked of some rings, and where they begin.

    press: of each row, (cases,). arms (cases, 6), and scaled: free, target (what is asked of a free
    unknown) and start (where a held one is), (cases, 6). sound: whether a case can be solved,
    unconstrained: whether nothing can hold it, (cases,).
    """

    chosen: Indices
    press: list[FloatArray]
    arms: FloatArray
    free: BoolArray
    target: FloatArray
    start: FloatArray
    sound: BoolArray
    unconstrained: BoolArray

    @classmethod
    def of(cls, system: RowsOnRing, chosen: Indices, *, near: bool = True) -> _Asked:
        """Take the chosen cases; near: begin at `Cases.start` where there is one."""
        cases = system.cases
        rows = [placed.row for placed in cases.rows]
        sprung = cases.preload == "spring"
        arms = np.ones((len(chosen), UNKNOWNS))
        arms[:, 3:5] = rows[0].sizes.arm[chosen, np.newaxis]
        press = [press[chosen] for press in system.press]
        free = np.zeros((len(chosen), UNKNOWNS), np.bool_)
        target, held = np.zeros(free.shape), np.zeros(free.shape)
        free[:, :5] = cases.free[chosen]
        free[:, SLIDE] = sprung
        target[:, :5] = cases.load[chosen]
        target[:, SLIDE] = cases.preload_value[chosen] if sprung else 0.0
        held[:, :5] = cases.displacement[chosen]
        target, held = target / arms, held * arms
        touching = np.max([np.abs(e) for e in press], axis=0) > 0.0
        start = held + _pushed(cases, chosen, free & ~touching[:, np.newaxis], target)
        if near and cases.start is not None:
            place = cases.start[chosen] * arms[:, :5]
            known = free[:, :5] & np.isfinite(place).all(axis=1, keepdims=True)
            start[:, :5] = np.where(known, place, start[:, :5])
        finite = cases.valid[chosen] & np.isfinite(target).all(axis=1)
        finite &= np.isfinite(start).all(axis=1) & np.isfinite(np.sum(press, axis=0))
        finite &= np.all([row.valid[chosen] for row in rows], axis=0)
        unconstrained = finite & cases.unconstrained[chosen]
        return cls(chosen, press, arms, free, target, start, finite & ~unconstrained, unconstrained)


def _proposed(system: RowsOnRing, control: FloatArray, asked: _Asked) -> RingSolution | None:
    """Solutions by the kernels that know of rings with rows of balls; None where they do not.

    Judged row by row as when held there; what they do not find is left as not converged.
    """
    cases, chosen, arms = system.cases, asked.chosen, asked.arms
    spheres = [row for row in (p.row for p in cases.rows) if isinstance(row, SphereRow)]
    rows = sets.balls_only(
        [placed.row for placed in cases.rows] if not spheres else [r.row for r in spheres]
    )
    if rows is None:
        return None
    target, start, solvable = asked.target, asked.start, asked.sound
    tilt = start[:, 3:5] / arms[:, 3:5]
    if spheres:  # as the tilted ring sees it, which a sphere does not know of
        solvable = solvable & (asked.free[:, :5] == _SHIFTS).all(axis=1)
        target, start = np.zeros_like(target), np.zeros_like(start)
        target[:, :3] = from_ring(tilt, asked.target[:, :3])
        start[:, :3] = from_ring(tilt, asked.start[:, :3])
    stand = sets.standing(
        [placed.sign for placed in cases.rows],
        [placed.lever[chosen] for placed in cases.rows],
        [placed.row.sizes.arm[chosen] for placed in cases.rows],
        asked.press,
        sprung=cases.preload == "spring",
    )
    parts = asked.free.astype(np.float64), target, start
    found = sets.settle(rows, chosen, control, stand, parts, solvable)
    if found is None:
        return None
    view = _View(found.force, found.stiffness, found.force[:, 0], found.sound, list(found.rows))
    place = found.place
    if spheres:
        place[:, :3] = from_outside(tilt, found.place[:, :3])
        place[:, 3:5] = asked.start[:, 3:5]
        transforms = [transform(placed, sprung=False)[chosen] for placed in cases.rows]
        answers = [
            row.turned(held, (t[:, :, :5] @ (place / arms)[:, :5, np.newaxis])[..., 0])
            for row, held, t in zip(spheres, found.rows, transforms, strict=True)
        ]
        view = _summed(answers, [t / arms[:, np.newaxis, :] for t in transforms])
    number, unsupported = _gravest(view.rows, len(chosen))
    number[~found.sound] = NOT_CONVERGED
    number[~asked.sound] = INVALID_INPUT
    number[asked.unconstrained], unsupported[asked.unconstrained] = NO_EQUILIBRIUM, 0
    return RingSolution(
        place=place / arms,
        force=view.force * arms,
        stiffness=view.stiffness * arms[:, :, np.newaxis] * arms[:, np.newaxis, :],
        residual=found.residual,
        number=number,
        unsupported=unsupported,
        iterations=found.steps,
        safe_path=np.zeros(len(chosen), np.bool_),
        rows=view.rows,
    )


def _summed(answers: Sequence[Response], transforms: Sequence[FloatArray]) -> _View:
    """The rows' answers seen from the ring, summed up; transforms: (cases, 5, 6), scaled."""
    n = len(transforms[0])
    force, stiffness = np.zeros((n, UNKNOWNS)), np.zeros((n, UNKNOWNS, UNKNOWNS))
    scale, sound = np.zeros(n), np.ones(n, np.bool_)
    for held, t in zip(answers, transforms, strict=True):
        back = np.swapaxes(t, 1, 2)
        force += (back @ held.force[..., np.newaxis])[..., 0]
        stiffness += back @ (held.stiffness @ t)
        np.maximum(scale, held.scale, out=scale)
        sound &= ANSWERED[held.number]
    return _View(force, stiffness, scale, sound, list(answers))


@frozen
class _Problem:
    """Some cases as the equations of a ring, and where to begin.

    By row: control (cases, elements), transforms (cases, 5, 6). start: (cases, 6), scaled; before:
    steps that have led there, (cases,).
    """

    system: RowsOnRing
    asked: _Asked
    control: list[FloatArray]
    transforms: list[FloatArray]
    start: FloatArray
    before: IntArray

    @classmethod
    def of(cls, system: RowsOnRing, control: FloatArray, asked: _Asked) -> _Problem:
        """Set up the chosen cases."""
        cases, start = system.cases, asked.start.copy()
        sprung = cases.preload == "spring"
        before = _propose(cases, asked.chosen, asked.press[0], asked.arms, start)
        return cls(
            system=system,
            asked=asked,
            control=system.split(control),
            transforms=[transform(placed, sprung)[asked.chosen] for placed in cases.rows],
            start=start,
            before=before,
        )

    def solve(self) -> RingSolution:
        asked, sizes = self.asked, self.system.cases.rows[0].row.sizes
        which = np.flatnonzero(asked.sound & np.isfinite(self.start).all(axis=1))
        of_ring = asked.chosen[which]
        seen: list[tuple[FloatArray, _View]] = []

        def look(some: Indices, u: FloatArray) -> _View:
            view = self._view(which[some], u)
            seen[:] = [(u, view)] if len(some) == len(which) else []
            return view

        found = balance(
            look,
            self.start[which],
            asked.target[which],
            asked.free[which],
            precision=PRECISION,
            longest=0.3 * sizes.reach[of_ring],
            limit=sizes.diameter[of_ring],
            reference=1.5e-6 * sizes.stiffness[of_ring],
        )
        solution = self._solution(which, found, seen)
        solution.number[asked.unconstrained], solution.unsupported[asked.unconstrained] = (
            NO_EQUILIBRIUM,
            0,
        )
        return solution

    def _view(self, which: Indices, u: FloatArray) -> _View:
        """Hold every row where the ring holds it, and sum up what they answer."""
        chosen, arms = self.asked.chosen[which], self.asked.arms[which]
        answers: list[Response] = []
        transforms = [t[which] / arms[:, np.newaxis, :] for t in self.transforms]
        parts = zip(self.system.cases.rows, transforms, self.asked.press, self.control, strict=True)
        for placed, t, press, control in parts:
            place = (t @ u[..., np.newaxis])[..., 0]
            place[:, 0] += press[which]
            answers.append(placed.row.respond(place, chosen, control[which]))
        return _summed(answers, transforms)

    def _solution(
        self, which: Indices, found: Balance, seen: list[tuple[FloatArray, _View]]
    ) -> RingSolution:
        """Evaluate the rows where the ring came to rest, and judge.

        seen: the last place where all rings were looked at together, and how.
        """
        n = len(self.asked.chosen)
        solution = RingSolution(
            place=np.full((n, UNKNOWNS), np.nan),
            force=np.full((n, UNKNOWNS), np.nan),
            stiffness=np.full((n, UNKNOWNS, UNKNOWNS), np.nan),
            residual=np.full(n, np.nan),
            number=np.full(n, INVALID_INPUT),
            unsupported=np.full(n, -1),
            iterations=np.zeros(n, np.int64),
            safe_path=np.zeros(n, np.bool_),
            rows=[placed.row.no_response(n) for placed in self.system.cases.rows],
        )
        if not len(which):
            return solution
        known = [view for u, view in seen if np.array_equal(u, found.displacement)]
        view = known[0] if known else self._view(which, found.displacement)
        arms = self.asked.arms[which]
        solution.place[which] = found.displacement / arms
        solution.force[which] = view.force * arms
        solution.stiffness[which] = view.stiffness * arms[:, :, np.newaxis] * arms[:, np.newaxis, :]
        for whole, part in zip(solution.rows, view.rows, strict=True):
            whole.put(which, part)
        rest = np.max([held.residual for held in view.rows], axis=0)
        solution.residual[which] = np.fmax(found.residual, rest)
        solution.iterations[which] = found.steps + self.before[which]
        solution.safe_path[which] = np.any([held.safe_path for held in view.rows], axis=0)
        solution.number[which], solution.unsupported[which] = _judged(found, view)
        return solution


def _propose(
    cases: Cases, chosen: Indices, press: FloatArray, arms: FloatArray, start: FloatArray
) -> IntArray:
    """Begin where a row that is the whole bearing says that the ring rests; in how many steps.

    Only rows whose kernels know the ring have one; it is judged as any other start.
    """
    placed, steps = cases.rows[0], np.zeros(len(chosen), np.int64)
    if len(cases.rows) > 1 or placed.sign < 0.0 or not isinstance(placed.row, SelfBalancing):
        return steps
    known = cases.valid[chosen] & placed.row.valid[chosen] & (press == 0.0)
    known &= placed.lever[chosen] == 0.0
    if not known.any():
        return steps
    which = chosen[known]
    place, settled, taken = placed.row.equilibrium(
        cases.free[which], cases.load[which], start[known, :5] / arms[known, :5], which
    )
    rows = np.flatnonzero(known)[settled]
    start[rows, :5] = place[settled] * arms[rows, :5]
    steps[known] = taken
    return steps


def _pushed(cases: Cases, chosen: Indices, loose: BoolArray, target: FloatArray) -> FloatArray:
    """Where to begin with what is loose: pushed in by the load, for rows that touch are stiff."""
    sizes = [placed.row.sizes for placed in cases.rows]
    counts = [placed.row.element_count for placed in cases.rows]
    stiffness = np.sum(
        [size.stiffness[chosen] * count for size, count in zip(sizes, counts, strict=True)], axis=0
    )
    begin = np.zeros(target.shape)
    radial = np.hypot(target[:, 1], target[:, 2])
    away = (4.5 * radial / stiffness) ** (2.0 / 3.0)
    for i in (1, 2):
        unit = np.divide(target[:, i], radial, where=radial > 0.0, out=np.zeros(len(chosen)))
        begin[:, i] = np.where(loose[:, i], away * unit, 0.0)
    axial, force = target[:, 0], target[:, SLIDE]
    yielding = stiffness * np.maximum(sizes[0].sine[chosen], 0.2) ** 2.5
    into = np.sign(axial) * (np.abs(axial) / yielding) ** (2.0 / 3.0)
    if cases.preload == "spring":
        begin[:, SLIDE] = 2.0 * (force / yielding) ** (2.0 / 3.0)
        into += np.where(axial == 0.0, 0.5 * begin[:, SLIDE], 0.0)
    begin[:, 0] = np.where(loose[:, 0], into, 0.0)
    return begin


def transform(placed: PlacedRow, sprung: bool) -> FloatArray:
    """The matrices T that take the ring's displacement to a row's place; (cases, 5, 6)."""
    t = np.zeros((len(placed.position), 5, UNKNOWNS))
    t[:, 0, 0] = placed.sign
    t[:, 0, SLIDE] = 1.0 if sprung and placed.sign < 0.0 else 0.0
    t[:, 1, 1] = t[:, 2, 2] = 1.0
    t[:, 1, 4] = placed.lever
    t[:, 2, 3] = -placed.lever
    t[:, 3, 3] = t[:, 4, 4] = placed.sign
    return t


def _judged(found: Balance, view: _View) -> tuple[IntArray, IntArray]:
    """The verdict on each case: the ring's own, or the gravest of its rows'."""
    number, unsupported = _gravest(view.rows, len(found.settled))
    near = found.residual <= TOLERANCE
    number[~(found.settled | near)] = NOT_CONVERGED
    escaped = ~found.settled & (found.escaping >= 0)
    number[escaped] = NO_EQUILIBRIUM
    unsupported[escaped] = np.where(found.escaping[escaped] == SLIDE, 0, found.escaping[escaped])
    return number, unsupported


def _gravest(rows: Sequence[Response], cases: int) -> tuple[IntArray, IntArray]:
    """The gravest verdict on the rows of each case, and the unknown that nothing holds, or -1."""
    number, unsupported = np.full(cases, CONVERGED), np.full(cases, -1)
    for verdict in (OVERLOADED, UNCONSTRAINED_BALL, OVER_SHOULDER, NO_EQUILIBRIUM, NOT_CONVERGED):
        hit = np.any([held.number == verdict for held in rows], axis=0)
        number[hit] = verdict
        unsupported[hit & (verdict == NO_EQUILIBRIUM)] = 0
    return number, unsupported


def pressed_in(cases: Cases) -> tuple[FloatArray, ...]:
    """How far the clamped rings press each row in axially, e of the module; (cases,) each, m.

    Rows count from first contact on their own side. A clamped force is shared equally by the
    rows that face the same way, and acts at rest; the force of a pair is that of two such rows.
    Rows that float carry none of it.
    """
    held = [placed for placed in cases.rows if not placed.row.floats]
    shares = {sign: sum(placed.sign == sign for placed in held) for sign in (1.0, -1.0)}
    press = []
    for placed in cases.rows:
        if placed.press is not None:
            press.append(placed.press)
            continue
        if placed.row.floats:
            press.append(np.zeros(len(cases)))
            continue
        touch = placed.row.first_contact()
        if cases.preload == "offset":
            press.append(touch + cases.preload_value)
        elif cases.preload in ("force", "pair"):
            force = cases.preload_value / (shares[placed.sign] if cases.preload == "force" else 1)
            press.append(np.where(force > 0.0, placed.row.press_in(force), touch))
        else:
            press.append(touch if cases.preload == "spring" else np.zeros(len(cases)))
    return tuple(press)


def condensed(stiffness: FloatArray, sprung: bool) -> FloatArray:
    """The ring's stiffness (cases, 5, 5), with the springs' slide following."""
    ring = stiffness[:, :5, :5].copy()
    if sprung:
        slide = stiffness[:, SLIDE, SLIDE]
        follow = np.divide(
            stiffness[:, SLIDE, :5], slide[:, np.newaxis], where=slide[:, np.newaxis] > 0.0,
            out=np.zeros((len(slide), 5)),
        )  # fmt: skip
        ring -= stiffness[:, :5, SLIDE, np.newaxis] * follow[:, np.newaxis, :]
    return ring
