"""Components between nodes, and where the nodes come to rest under their loads.

A node has five degrees of freedom: x, y, z (m), ry, rz (rad). A component joins some nodes, or a
node and the ground, and resists their displacement: `RowBetween` is a row of rolling elements
between an inner and an outer ring, `Linear` whatever has a constant stiffness. The displacement of
all nodes is one vector, node after node; each degree of freedom of a node takes a load or a
displacement. A ring with its rows is a network of one node, and of two where springs push the outer
rings; a shaft in its bearings is a longer one.

A row at the axial position a of its nodes, carrying axial load toward σ = ±1, is held in its own
frame at

    v = S B (u_inner - u_outer) + (e, 0, 0, 0, 0),   S = diag(σ, 1, 1, σ, σ),
    B:   y += a rz,   z -= a ry,

where e is how far it is pressed in. It puts ±T' f(v) on its nodes, with the stiffness T' K T,
T = S B. Rigid-body kinematics; Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapters 8 and 9.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final, Protocol

import numpy as np

from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.newton import Balance, balance
from rolamento.records import frozen
from rolamento.rows.row import Indices, IntArray, Response, Row
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

FIVE: Final = 5
"""Degrees of freedom of a node."""
ALONG: Final = np.array([1.0, 0.0, 0.0, 0.0, 0.0])
"""Selects x from a node's degrees of freedom."""
PRECISION: Final = 1e-10
"""Unbalanced force over the forces that make it up."""
ROUNDING: Final = 1e-15
"""The same that rounding leaves of a linear component's own sum."""
ANSWERED: Final = np.zeros(16, np.bool_)
"""By verdict on a row, whether it comes with its forces; no_equilibrium while it touches."""
ANSWERED[[CONVERGED, OVERLOADED, UNCONSTRAINED_BALL, OVER_SHOULDER, NO_EQUILIBRIUM]] = True


@frozen(eq=False)
class Reaction:
    """How a component resists its nodes' displacement, in some cases.

    force (n, k), stiffness (n, k, k): of the nodes on it, k degrees of freedom; scale (n,): size of
    the forces that make it up; held: what a row answers.
    """

    force: FloatArray
    stiffness: FloatArray
    scale: FloatArray
    held: Response | None = None


class Component(Protocol):
    """What resists the displacement of the nodes that it joins."""

    @property
    def nodes(self) -> tuple[int, ...]:
        """Which nodes it joins."""
        ...

    def respond(self, place: FloatArray, which: Indices, memory: FloatArray | None) -> Reaction:
        """Hold its nodes in some of the cases; place (len(which), 5 nodes), SI.

        memory: as `rolamento.rows.row.Response` has it, of the same cases.
        """
        ...

    def no_response(self, cases: int) -> Response | None:
        """Make room for what a row answers; None of what has no state of its own."""
        ...


@frozen(eq=False)
class Linear:
    """A constant stiffness between nodes: matrix (cases or 1, 5 nodes, 5 nodes), SI."""

    nodes: tuple[int, ...]
    matrix: FloatArray

    def respond(self, place: FloatArray, which: Indices, memory: FloatArray | None) -> Reaction:
        """Multiply."""
        k = self.matrix if len(self.matrix) == 1 else self.matrix[which]
        force = (k @ place[..., np.newaxis])[..., 0]
        size = (np.abs(k) @ np.abs(place)[..., np.newaxis])[..., 0].max(axis=1)
        stiffness = np.broadcast_to(k, (len(place), *k.shape[1:]))
        return Reaction(force, stiffness, size * (ROUNDING / PRECISION))

    def moved(self, places: Mapping[int, int]) -> Linear:
        """The same among other nodes."""
        return replace(self, nodes=tuple(places[node] for node in self.nodes))

    def no_response(self, cases: int) -> Response | None:
        """There is nothing to keep."""
        return None


@frozen(eq=False)
class RowBetween:
    """A row between an inner and an outer node, or the ground where that is None.

    way: σ. lever: a, (cases,), m. press: e, (cases,), m. slide: the node whose x is how far its
    outer ring has slid in its seat, pushed by springs; None where it does not.
    """

    row: Row
    inner: int
    outer: int | None
    way: float
    lever: FloatArray
    press: FloatArray
    slide: int | None = None

    @property
    def nodes(self) -> tuple[int, ...]:
        """The inner ring's, the outer's, and that of its sliding."""
        return tuple(n for n in (self.inner, self.outer, self.slide) if n is not None)

    def respond(self, place: FloatArray, which: Indices, memory: FloatArray | None) -> Reaction:
        """Hold the row where its rings are."""
        t = self._seen(self.lever[which])
        own = (t @ place[..., np.newaxis])[..., 0]
        own[:, 0] += self.press[which]
        held = self.row.respond(own, which, memory)
        back = np.swapaxes(t, 1, 2)
        force = (back @ held.force[..., np.newaxis])[..., 0]
        return Reaction(force, back @ (held.stiffness @ t), held.scale, held)

    def _seen(self, lever: FloatArray) -> FloatArray:
        """From the displacement of its nodes to its own place; (cases, 5, 5 nodes)."""
        inner = seen_by_row(self.way, lever)
        parts = [inner]
        if self.outer is not None:
            parts.append(-inner)
        if self.slide is not None:
            parts.append(-inner * ALONG)
        return inner if len(parts) == 1 else np.concatenate(parts, axis=2)

    def tangent(self, held: Response) -> FloatArray:
        """The stiffness between its nodes where it is held; (cases, 5 nodes, 5 nodes)."""
        t = self._seen(self.lever)
        return np.asarray(np.swapaxes(t, 1, 2) @ (held.stiffness @ t))

    def on_nodes(self, force: FloatArray) -> FloatArray:
        """A force on the row in its own frame as the inner node puts it; (cases, 5)."""
        return seen_by_ring(self.way, self.lever, force)

    def moved(self, places: Mapping[int, int]) -> RowBetween:
        """The same among other nodes."""
        outer = None if self.outer is None else places[self.outer]
        slide = None if self.slide is None else places[self.slide]
        return replace(self, inner=places[self.inner], outer=outer, slide=slide)

    def no_response(self, cases: int) -> Response | None:
        """Make room for what the row answers."""
        return self.row.no_response(cases)


def seen_by_row(way: float, lever: FloatArray) -> FloatArray:
    """T = S B: from a displacement of the inner node against the outer to the row's own place.

    (cases, 5, 5).
    """
    t = np.zeros((len(lever), FIVE, FIVE))
    t[:, 0, 0] = t[:, 3, 3] = t[:, 4, 4] = way
    t[:, 1, 1] = t[:, 2, 2] = 1.0
    t[:, 1, 4], t[:, 2, 3] = lever, -lever
    return t


def seen_by_ring(way: float, lever: FloatArray, force: FloatArray) -> FloatArray:
    """T' f: forces on the row in its own frame as the inner node puts them; (cases, ..., 5)."""
    seen: FloatArray = force * np.array([way, 1.0, 1.0, way, way]) + 0.0  # no -0.0
    arm = lever.reshape(len(lever), *(1 for _ in force.shape[2:]))
    seen[..., 3] -= arm * force[..., 2]
    seen[..., 4] += arm * force[..., 1]
    return seen


@frozen(eq=False)
class Asked:
    """What is asked of some cases of a network, and where they begin.

    Tilts are scaled by an arm, and moments over it, so that all unknowns have one unit.

    Attributes
    ----------
    chosen
        which cases of the components; (n,)
    arms
        1 of a shift, the arm of a tilt; (n, unknowns)
    free, target, start
        which unknowns may move, the load on them, where they begin or are held; (n, unknowns)
    sound
        which cases can be solved; (n,)
    longest, limit
        the longest step, and how far an unknown may go; (n,), m
    reference
        a stiffness that is small against any real one; (n,), N/m
    """

    chosen: Indices
    arms: FloatArray
    free: BoolArray
    target: FloatArray
    start: FloatArray
    sound: BoolArray
    longest: FloatArray
    limit: FloatArray
    reference: FloatArray


@dataclass(slots=True)
class Rest:
    """Where the nodes came to rest; place, force (cases, unknowns), stiffness, SI.

    unsupported: the unknown that nothing holds, or -1. rows: what the rows answer, in order.
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

    @classmethod
    def nowhere(cls, cases: int, unknowns: int, components: Sequence[Component]) -> Rest:
        """Make room for so many cases, none of which has a result."""
        return cls(
            place=np.full((cases, unknowns), np.nan),
            force=np.full((cases, unknowns), np.nan),
            stiffness=np.full((cases, unknowns, unknowns), np.nan),
            residual=np.full(cases, np.nan),
            number=np.full(cases, INVALID_INPUT),
            unsupported=np.full(cases, -1),
            iterations=np.zeros(cases, np.int64),
            safe_path=np.zeros(cases, np.bool_),
            rows=[room for c in components if (room := c.no_response(cases)) is not None],
        )

    def put(self, cases: Indices, part: Rest) -> None:
        """Copy the solution of some of the cases to their places."""
        for name in ("place", "force", "stiffness", "residual", "number", "unsupported"):
            getattr(self, name)[cases] = getattr(part, name)
        self.iterations[cases], self.safe_path[cases] = part.iterations, part.safe_path
        for whole, piece in zip(self.rows, part.rows, strict=True):
            whole.put(cases, piece)


@frozen(eq=False)
class _Sum:
    """All components' reactions, scaled and summed up; as `numerics.newton.Evaluation`."""

    force: FloatArray
    stiffness: FloatArray
    scale: FloatArray
    sound: BoolArray
    rows: list[Response]


class _Network:
    """The components of some cases, as Newton's method looks at them.

    Each row begins from what it answered last, until it does not answer.
    """

    def __init__(
        self,
        components: Sequence[Component],
        asked: Asked,
        which: Indices,
        memory: FloatArray | None,
    ) -> None:
        self._components, self._chosen = components, asked.chosen[which]
        self._arms = asked.arms[which]
        self._memories: list[FloatArray | None] = [None] * len(components)
        if memory is not None:
            self._memories[0] = memory[which]
        self._last: tuple[FloatArray, _Sum] | None = None

    def __call__(self, some: Indices, u: FloatArray) -> _Sum:
        arms, chosen = self._arms[some], self._chosen[some]
        place = u / arms
        n, unknowns = u.shape
        force, stiffness = np.zeros((n, unknowns)), np.zeros((n, unknowns, unknowns))
        scale, sound = np.zeros(n), np.ones(n, np.bool_)
        rows = []
        for number, component in enumerate(self._components):
            at = unknowns_of(component.nodes)
            memory = self._memories[number]
            reaction = component.respond(
                place[:, at], chosen, None if memory is None else memory[some]
            )
            own = arms[:, at]
            force[:, at] += reaction.force / own
            stiffness[:, at[:, np.newaxis], at] += reaction.stiffness / (
                own[:, :, np.newaxis] * own[:, np.newaxis, :]
            )
            np.maximum(scale, reaction.scale, out=scale)
            if reaction.held is not None:
                answered = ANSWERED[reaction.held.number]
                sound &= answered
                rows.append(reaction.held)
                self._remember(number, some, reaction.held, answered)
        found = _Sum(force, stiffness, scale, sound, rows)
        self._last = (u, found) if n == len(self._chosen) else None
        return found

    def _remember(self, number: int, some: Indices, held: Response, answered: BoolArray) -> None:
        if (new := held.memory) is None:
            return
        memory = self._memories[number]
        if memory is None:
            memory = np.full((len(self._chosen), new.shape[1]), np.nan)
            self._memories[number] = memory
        memory[some] = np.where(answered[:, np.newaxis], new, np.nan)

    def at(self, u: FloatArray) -> _Sum:
        """All cases at a place: looked at already, perhaps."""
        if self._last is not None and np.array_equal(self._last[0], u):
            return self._last[1]
        return self(np.arange(len(self._chosen)), u)


def unknowns_of(nodes: tuple[int, ...]) -> Indices:
    """Where the degrees of freedom of some nodes stand among the unknowns."""
    return (FIVE * np.array(nodes)[:, np.newaxis] + np.arange(FIVE)).ravel()


def solve(
    components: Sequence[Component],
    asked: Asked,
    before: IntArray | int = 0,
    memory: FloatArray | None = None,
) -> Rest:
    """Find where the nodes of some cases come to rest.

    before: steps that have led to where they begin, (n,). memory: of the first component, a row,
    where they begin; (n, any), as `rolamento.rows.row.Response`.
    """
    n, unknowns = asked.start.shape
    rest = Rest.nowhere(n, unknowns, components)
    which = np.flatnonzero(asked.sound & np.isfinite(asked.start).all(axis=1))
    if not len(which):
        return rest
    network = _Network(components, asked, which, memory)
    found = balance(
        network,
        asked.start[which],
        asked.target[which],
        asked.free[which],
        precision=PRECISION,
        longest=asked.longest[which],
        limit=asked.limit[which],
        reference=asked.reference[which],
    )
    seen, arms = network.at(found.displacement), asked.arms[which]
    rest.place[which] = found.displacement / arms
    rest.force[which] = seen.force * arms
    rest.stiffness[which] = seen.stiffness * arms[:, :, np.newaxis] * arms[:, np.newaxis, :]
    for whole, part in zip(rest.rows, seen.rows, strict=True):
        whole.put(which, part)
    left = np.max([held.residual for held in seen.rows], axis=0, initial=0.0)
    rest.residual[which] = np.fmax(found.residual, left)
    rest.iterations[which] = found.steps + np.broadcast_to(before, n)[which]
    safe = [held.safe_path for held in seen.rows]
    rest.safe_path[which] = np.any(safe, axis=0) if safe else False
    rest.number[which], rest.unsupported[which] = _judged(found, seen.rows)
    return rest


def _judged(found: Balance, rows: Sequence[Response]) -> tuple[IntArray, IntArray]:
    """The verdict on each case: the network's own, or the gravest of its rows'."""
    number, unsupported = gravest(rows, len(found.settled))
    near = found.residual <= TOLERANCE
    number[~(found.settled | near)] = NOT_CONVERGED
    escaped = ~found.settled & (found.escaping >= 0)
    number[escaped] = NO_EQUILIBRIUM
    unsupported[escaped] = found.escaping[escaped]
    return number, unsupported


def gravest(rows: Sequence[Response], cases: int) -> tuple[IntArray, IntArray]:
    """The gravest verdict on the rows of each case, and the unknown that nothing holds, or -1."""
    number, unsupported = np.full(cases, CONVERGED), np.full(cases, -1)
    if all((held.number == CONVERGED).all() for held in rows):
        return number, unsupported
    for verdict in (OVERLOADED, UNCONSTRAINED_BALL, OVER_SHOULDER, NO_EQUILIBRIUM, NOT_CONVERGED):
        hit = np.any([held.number == verdict for held in rows], axis=0) if rows else False
        number[hit] = verdict
        unsupported[hit & (verdict == NO_EQUILIBRIUM)] = 0
    return number, unsupported
