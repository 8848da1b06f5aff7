"""Sets of rows: one rigid inner ring, or rings clamped on one shaft, in several rows of balls.

Every row is a bearing of its own, held where the ring holds it; the ring is in balance when the
rows' reactions add up to the load. A row that faces -x is the mirror image of one that faces +x.
With the ring's displacement u = (x, y, z, ry, rz), taken at the set's origin, the row at axial
position a, facing σ = ±1, has in its own frame

    x_r = σ x + e,   y_r = y + a rz,   z_r = z - a ry,   ry_r = σ ry,   rz_r = σ rz

where e is how far the clamped rings press it in. Springs add a sixth unknown: how far they have
pushed the outer rings of the rows that face -x. In the scaled form of `rows` (tilts times arm)
this is v = T u + e, the ring's force is the sum of T' f, and its stiffness the sum of T' k T.

Rigid-body kinematics; Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapters 8 and 9.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from rolamento import status
from rolamento.numerics.newton import Balance, balance
from rolamento.rows.ball import layout
from rolamento.rows.ball.columns import Columns, RowColumns
from rolamento.rows.ball.problem import Floats, ring_arms
from rolamento.rows.ball.run import Solution, row_verdict, solve_columns

UNKNOWNS: Final = 6
SLIDE: Final = 5  # of the spring-loaded outer rings
PRECISION: Final = 1e-10
USABLE: Final = (
    status.CONVERGED, status.OVERLOADED, status.UNHELD_BALL, status.OVER_SHOULDER,
)  # fmt: skip
"""Verdicts on a row that come with its forces; so does no_equilibrium while it touches."""

Indices = NDArray[np.intp]


@dataclass(slots=True)
class SetSolution:
    """The ring's equilibrium, scaled as in `rows`, and the rows' own solutions.

    displacement, reaction (cases, 6), stiffness (cases, 6, 6): the sixth is the springs' slide.
    """

    displacement: Floats
    reaction: Floats
    stiffness: Floats
    residual: Floats
    code: NDArray[np.int64]
    unsupported: NDArray[np.int64]
    iterations: NDArray[np.int64]
    safe: NDArray[np.bool_]
    rows: list[Solution]

    def put(self, cases: Indices, part: SetSolution) -> None:
        """Copy the solution of some of the cases to their places."""
        for name in ("displacement", "reaction", "stiffness", "residual", "code", "unsupported"):
            getattr(self, name)[cases] = getattr(part, name)
        self.iterations[cases], self.safe[cases] = part.iterations, part.safe
        for whole, piece in zip(self.rows, part.rows, strict=True):
            whole.put(cases, piece)


@dataclass(frozen=True, slots=True)
class _View:
    """The rows seen from the ring: their forces and stiffness, summed."""

    force: Floats
    stiffness: Floats
    scale: Floats
    sound: NDArray[np.bool_]
    rows: list[Solution]


@dataclass(frozen=True, slots=True)
class RowSet:
    """Many cases of a set, as `jones` wants a system; press: what the clamping does to each row."""

    columns: Columns
    press: tuple[Floats, ...]
    threads: int | None = None
    fast: bool = True

    @property
    def shape(self) -> tuple[int, int]:
        """Cases and balls."""
        return self.columns.cases, sum(row.balls for row in self.columns.rows)

    def solve(self, control: Floats, which: Indices | None = None) -> SetSolution:
        """Solve all cases, or some."""
        chosen = np.arange(self.columns.cases) if which is None else which
        control = np.broadcast_to(control, (len(chosen), self.shape[1]))
        return _Problem.of(self, control, chosen).solve()

    def verdict(self, solution: SetSolution, control: Floats) -> NDArray[np.int64]:
        """Jones's criterion for every ball at a solution; (cases, balls)."""
        parts = zip(self.columns.rows, solution.rows, self.split(control), strict=True)
        return np.concatenate([row_verdict(row.p, part, own) for row, own, part in parts], axis=1)

    def split(self, control: Floats) -> list[Floats]:
        """The columns of an array over all balls, row by row."""
        ends = np.cumsum([row.balls for row in self.columns.rows])[:-1]
        return list(np.split(control, ends, axis=1))


@dataclass(frozen=True, slots=True)
class _Problem:
    """Some cases of a set as the equations of a ring, and where to begin.

    By row: control (cases, balls), transforms (cases, 5, 6), press (cases,). Of the ring, scaled:
    free, target (what is asked of a free unknown) and start (where a held one is), (cases, 6).
    """

    system: RowSet
    chosen: Indices
    control: list[Floats]
    transforms: list[Floats]
    press: list[Floats]
    free: NDArray[np.bool_]
    target: Floats
    start: Floats

    @classmethod
    def of(cls, system: RowSet, control: Floats, chosen: Indices) -> _Problem:
        """Set up the chosen cases."""
        columns = system.columns
        sprung = columns.preload == "spring"
        arms = ring_arms(columns.rows[0].p[:, chosen])
        press = [press[chosen] for press in system.press]
        free = np.zeros((len(chosen), UNKNOWNS), np.bool_)
        target, held = np.zeros(free.shape), np.zeros(free.shape)
        free[:, :5] = columns.free[:, chosen].T
        free[:, SLIDE] = sprung
        target[:, :5] = (columns.load[:, chosen] / arms).T
        target[:, SLIDE] = columns.preload_value[chosen] if sprung else 0.0
        held[:, :5] = (columns.displacement[:, chosen] * arms).T
        touching = np.max([np.abs(e) for e in press], axis=0) > 0.0
        return cls(
            system=system,
            chosen=chosen,
            control=system.split(control),
            transforms=[transform(row, columns.rows[0], sprung)[chosen] for row in columns.rows],
            press=press,
            free=free,
            target=target,
            start=held + _pressed(columns, chosen, free & ~touching[:, np.newaxis], target),
        )

    def solve(self) -> SetSolution:
        first = self.system.columns.rows[0].p[:, self.chosen]
        finite = np.isfinite(first).all(axis=0) & np.isfinite(self.target).all(axis=1)
        finite &= np.isfinite(self.start).all(axis=1) & np.isfinite(np.sum(self.press, axis=0))
        which = np.flatnonzero(finite)
        found = balance(
            lambda some, u: self._view(which[some], u),
            self.start[which],
            self.target[which],
            self.free[which],
            precision=PRECISION,
            longest=0.3 * (first[layout.INNER_LENGTH] + first[layout.OUTER_LENGTH])[which],
            limit=first[layout.BALL_DIAMETER, which],
            reference=1.5e-6 * first[layout.SERIES_STIFFNESS, which],
        )
        return self._solution(which, found)

    def _view(self, which: Indices, u: Floats) -> _View:
        """Hold every row where the ring holds it, and sum up what they answer."""
        n = len(which)
        view = _View(
            np.zeros((n, UNKNOWNS)), np.zeros((n, UNKNOWNS, UNKNOWNS)), np.zeros(n),
            np.ones(n, np.bool_), [],
        )  # fmt: skip
        parts = zip(
            self.system.columns.rows, self.transforms, self.press, self.control, strict=True
        )
        for row, transforms, press, control in parts:
            t = transforms[which]
            place = np.einsum("nij,nj->ni", t, u)
            place[:, 0] += press[which]
            solution = self._hold(row, place, which, control[which])
            view.rows.append(solution)
            view.force[:] += np.einsum("nij,ni->nj", t, solution.reaction)
            view.stiffness[:] += np.einsum("nki,nkl,nlj->nij", t, solution.stiffness, t)
            np.maximum(view.scale, np.abs(solution.reaction).max(axis=1), out=view.scale)
            usable = np.isin(solution.code, USABLE) | (solution.code == status.NO_EQUILIBRIUM)
            view.sound[:] &= usable
        return view

    def _hold(self, row: RowColumns, place: Floats, which: Indices, control: Floats) -> Solution:
        p = row.p[:, self.chosen[which]]
        p[layout.FREE : layout.FREE + 5] = 0.0
        p[layout.APPLIED : layout.APPLIED + 5] = 0.0
        p[layout.IMPOSED : layout.IMPOSED + 5] = place.T
        system = self.system
        return solve_columns(p, control, row.balls, threads=system.threads, fast=system.fast)

    def _solution(self, which: Indices, found: Balance) -> SetSolution:
        """Evaluate the rows once more where the ring came to rest, and judge."""
        n = len(self.chosen)
        solution = SetSolution(
            displacement=np.full((n, UNKNOWNS), np.nan),
            reaction=np.full((n, UNKNOWNS), np.nan),
            stiffness=np.full((n, UNKNOWNS, UNKNOWNS), np.nan),
            residual=np.full(n, np.nan),
            code=np.full(n, status.INVALID_INPUT),
            unsupported=np.full(n, -1),
            iterations=np.zeros(n, np.int64),
            safe=np.zeros(n, np.bool_),
            rows=[Solution.empty(n, row.balls) for row in self.system.columns.rows],
        )
        if not len(which):
            return solution
        view = self._view(which, found.displacement)
        solution.displacement[which] = found.displacement
        solution.reaction[which], solution.stiffness[which] = view.force, view.stiffness
        for whole, part in zip(solution.rows, view.rows, strict=True):
            whole.put(which, part)
        rest = np.max([row.residual for row in view.rows], axis=0)
        solution.residual[which] = np.fmax(found.residual, rest)
        solution.iterations[which] = found.steps
        solution.safe[which] = np.any([row.safe for row in view.rows], axis=0)
        solution.code[which], solution.unsupported[which] = _judged(found, view)
        return solution


def _pressed(columns: Columns, chosen: Indices, loose: NDArray[np.bool_], target: Floats) -> Floats:
    """Where to begin with what is loose: pressed in by the load, for rows that touch are stiff."""
    first = columns.rows[0].p[:, chosen]
    stiffness = sum(row.p[layout.SERIES_STIFFNESS, chosen] * row.balls for row in columns.rows)
    begin = np.zeros(target.shape)
    radial = np.hypot(target[:, 1], target[:, 2])
    away = (4.5 * radial / stiffness) ** (2.0 / 3.0)
    for i in (1, 2):
        unit = np.divide(target[:, i], radial, where=radial > 0.0, out=np.zeros(len(chosen)))
        begin[:, i] = np.where(loose[:, i], away * unit, 0.0)
    axial, force = target[:, 0], target[:, SLIDE]
    sine = np.clip(first[layout.AXIAL_OFFSET], 0.0, None)
    sine = np.maximum(sine / (first[layout.OUTER_LENGTH] + first[layout.INNER_LENGTH]), 0.2)
    yielding = stiffness * sine**2.5
    into = np.sign(axial) * (np.abs(axial) / yielding) ** (2.0 / 3.0)
    if columns.preload == "spring":
        begin[:, SLIDE] = 2.0 * (force / yielding) ** (2.0 / 3.0)
        into += np.where(axial == 0.0, 0.5 * begin[:, SLIDE], 0.0)
    begin[:, 0] = np.where(loose[:, 0], into, 0.0)
    return begin


def transform(row: RowColumns, first: RowColumns, sprung: bool) -> Floats:
    """The matrices T that take the ring's displacement to a row's; (cases, 5, 6), scaled."""
    t = np.zeros((len(row.position), 5, UNKNOWNS))
    arm = first.p[layout.ARM]
    ratio = row.p[layout.ARM] / arm
    t[:, 0, 0] = row.sign
    t[:, 0, SLIDE] = 1.0 if sprung and row.sign < 0.0 else 0.0
    t[:, 1, 1] = t[:, 2, 2] = 1.0
    t[:, 1, 4] = row.position / arm
    t[:, 2, 3] = -row.position / arm
    t[:, 3, 3] = t[:, 4, 4] = row.sign * ratio
    return t


def _judged(found: Balance, view: _View) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The verdict on each case: the ring's own, or the gravest of its rows'."""
    code = np.full(len(found.settled), status.CONVERGED)
    unsupported = np.full(len(code), -1)
    for verdict in (
        status.OVERLOADED, status.UNHELD_BALL, status.OVER_SHOULDER, status.NO_EQUILIBRIUM,
        status.NOT_CONVERGED,
    ):  # fmt: skip
        hit = np.any([row.code == verdict for row in view.rows], axis=0)
        code[hit] = verdict
        unsupported[hit & (verdict == status.NO_EQUILIBRIUM)] = 0
    near = found.residual <= status.TOLERANCE
    code[~(found.settled | near)] = status.NOT_CONVERGED
    escaped = ~found.settled & (found.escaping >= 0)
    code[escaped] = status.NO_EQUILIBRIUM
    unsupported[escaped] = np.where(found.escaping[escaped] == SLIDE, 0, found.escaping[escaped])
    return code, unsupported


def pressed_in(columns: Columns, *, threads: int | None = None) -> tuple[Floats, ...]:
    """How far the clamped rings press each row in axially, e of the module; (cases,) each, m.

    Rows count from first contact on their own side. A clamped force is shared equally by the
    rows that face the same way, and acts at rest; the force of a pair is that of two such rows.
    """
    shares = {sign: sum(row.sign == sign for row in columns.rows) for sign in (1.0, -1.0)}
    press = []
    for row in columns.rows:
        touch = first_contact(row.p)
        if columns.preload == "offset":
            press.append(touch + columns.preload_value)
        elif columns.preload in ("force", "pair"):
            share = shares[row.sign] if columns.preload == "force" else 1
            force = columns.preload_value / share
            press.append(np.where(force > 0.0, _approach(row, force, threads), touch))
        else:
            press.append(touch if columns.preload == "spring" else np.zeros(columns.cases))
    return tuple(press)


def first_contact(p: Floats) -> Floats:
    """Axial displacement at which the unloaded balls of a row touch; (cases,), m."""
    length = p[layout.INNER_LENGTH] + p[layout.OUTER_LENGTH]
    square = np.maximum(length**2 - p[layout.RADIAL_OFFSET] ** 2, 0.0)
    return np.asarray(
        np.where(p[layout.ONE_SIDED] > 0.0, 0.0, np.sqrt(square) - p[layout.AXIAL_OFFSET])
    )


def _approach(row: RowColumns, force: Floats, threads: int | None) -> Floats:
    """Axial displacement of a row at rest under an axial force; NaN where it has none."""
    p = row.p.copy()
    p[layout.INNER_SPEED] = p[layout.OUTER_SPEED] = 0.0
    p[layout.FREE : layout.FREE + 5] = 0.0
    p[layout.APPLIED : layout.APPLIED + 5] = 0.0
    p[layout.IMPOSED : layout.IMPOSED + 5] = 0.0
    p[layout.FREE], p[layout.APPLIED] = 1.0, force
    solution = solve_columns(p, np.ones((1, row.balls)), row.balls, threads=threads)
    settled = solution.code == status.CONVERGED
    return np.where(settled, solution.displacement[:, 0], np.nan)
