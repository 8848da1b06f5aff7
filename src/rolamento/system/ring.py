"""Rows on one rigid inner ring, or on rings clamped on one shaft: a network of one node.

Springs that push the outer rings of the rows which face -x make a second node of those, free to
slide along x. Rows of one kind may be balanced in one go by kernels of their own
(`rolamento.rows.row.Joint`); what these do not find goes by the network, as all others do.
"""

from __future__ import annotations

from dataclasses import replace
from functools import reduce
from typing import Any, Final, TypeVar

import numpy as np
from numpy.typing import DTypeLike, NDArray

from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.rows.row import Guided, Indices, IntArray, Joint, OnRing, SelfBalancing
from rolamento.solved import Index
from rolamento.status import INVALID_INPUT, NO_EQUILIBRIUM, NOT_CONVERGED
from rolamento.system.cases import Cases
from rolamento.system.network import (
    FIVE,
    Asked,
    Component,
    Rest,
    RowBetween,
    gravest,
    solve,
)

SLIDE: Final = FIVE
"""The unknown of the spring-loaded outer rings: x of the second node."""
JOINT: Final = SLIDE + 1
"""Unknowns of rows that are balanced in one go."""
TILTS: Final = slice(3, FIVE)
Unknowns = TypeVar("Unknowns", FloatArray, BoolArray)
Values = TypeVar("Values", FloatArray, BoolArray)


@frozen(eq=False)
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

    def guided(self, control: FloatArray) -> RowsOnRing:
        """The same rows, their elements guided so; (cases or 1, elements)."""
        return RowsOnRing(self.cases.guided(control), self.press)

    @property
    def _sprung(self) -> bool:
        return self.cases.preload == "spring"

    def _components(self) -> list[Component]:
        return [
            RowBetween(
                row=placed.row,
                inner=0,
                outer=None,
                way=placed.sign,
                lever=placed.lever,
                press=press,
                slide=1 if self._sprung and placed.sign < 0.0 else None,
            )
            for placed, press in zip(self.cases.rows, self.press, strict=True)
        ]

    def solve(self, which: Index = slice(None)) -> Rest:
        """Solve all cases, or some."""
        chosen = np.arange(len(self.cases))[which]
        hopeless = self.cases.unconstrained[chosen]
        if hopeless.any():
            hopeless &= self._sound(chosen)
        rest = self._solve(chosen)
        rest.number[hopeless], rest.unsupported[hopeless] = NO_EQUILIBRIUM, 0
        rest.unsupported[rest.unsupported >= FIVE] = 0  # a slide that nothing holds: along x
        return rest

    def _solve(self, chosen: Indices) -> Rest:
        asked = self._asked(chosen)
        rest = self._proposed(asked)
        near = self.cases.start is not None
        if rest is None:
            rest = self._by_network(asked)
            if not near:
                return rest
        left = rest.number == NOT_CONVERGED
        if near:  # what is not found from a neighbour's place may be from one's own
            left |= asked.sound & (rest.number == NO_EQUILIBRIUM)
        if left.any():
            again = self._asked(chosen[left], near=False)
            rest.put(np.flatnonzero(left), self._by_network(again))
        return rest

    def verdict(self, rest: Rest, which: Index = slice(None)) -> IntArray:
        """What guides every element of all cases, or some, by its row's own criterion.

        (cases, elements); of a row without one, what it is guided by.
        """
        chosen = np.arange(len(self.cases))[which]
        parts = []
        for placed, held in zip(self.cases.rows, rest.rows, strict=True):
            row = placed.row
            rolling = np.ones((len(chosen), row.element_count), np.int64)
            parts.append(row.verdict(held, chosen) if isinstance(row, Guided) else rolling)
        return np.concatenate(parts, axis=1)

    def _sound(self, chosen: Indices) -> BoolArray:
        """Which of some cases have numbers that can be solved."""
        cases = self.cases
        # each degree of freedom has a load or a displacement, and zero for the other
        numbers = [cases.load.sum(axis=1), cases.displacement.sum(axis=1), *self.press]
        if self._sprung:
            numbers.append(cases.preload_value)
        sound = cases.valid & np.isfinite(sum(numbers))
        for placed in cases.rows:
            sound &= placed.row.valid
        return _some(sound, chosen)

    def _asked(self, chosen: Indices, near: bool = True) -> Asked:
        """Take some cases; near: begin at `Cases.start` where there is one."""
        cases, sizes = self.cases, self.cases.rows[0].row.sizes
        unknowns = FIVE * (2 if self._sprung else 1)
        n = len(chosen)
        arm = _some(sizes.arm, chosen)[:, np.newaxis]
        arms = _zeros(n, unknowns)
        arms[...], arms[:, TILTS] = 1.0, arm
        free = _zeros(n, unknowns, np.bool_)
        target, start = _zeros(n, unknowns), _zeros(n, unknowns)
        free[:, :FIVE] = _some(cases.free, chosen)
        target[:, :FIVE] = _some(cases.load, chosen)
        start[:, :FIVE] = _some(cases.displacement, chosen)
        target[:, TILTS] /= arm
        start[:, TILTS] *= arm
        if self._sprung:
            free[:, SLIDE], target[:, SLIDE] = True, _some(cases.preload_value, chosen)
        clamped = reduce(np.logical_or, [_some(press, chosen) != 0.0 for press in self.press])
        self._push(start, chosen, free & ~clamped[:, np.newaxis], target)
        if near and cases.start is not None:
            place = cases.start[chosen] * arms[:, :FIVE]
            known = free[:, :FIVE] & np.isfinite(place).all(axis=1, keepdims=True)
            start[:, :FIVE] = np.where(known, place, start[:, :FIVE])
        sound = self._sound(chosen) & np.isfinite(start.sum(axis=1) + target.sum(axis=1))
        return Asked(
            chosen=chosen,
            arms=arms,
            free=free,
            target=target,
            start=start,
            sound=sound & ~_some(cases.unconstrained, chosen),
            longest=0.3 * _some(sizes.reach, chosen),
            limit=_some(sizes.diameter, chosen),
            reference=1.5e-6 * _some(sizes.stiffness, chosen),
        )

    def _by_network(self, asked: Asked) -> Rest:
        start = asked.start.copy()
        before, memory = self._propose(asked, start)
        return solve(self._components(), replace(asked, start=start), before, memory)

    def _proposed(self, asked: Asked) -> Rest | None:
        """Solutions by kernels that balance such rows together; None where there are none.

        Judged row by row as when held there; what they do not find is left as not converged.
        """
        cases, chosen = self.cases, asked.chosen
        rows = [placed.row for placed in cases.rows]
        if not isinstance(rows[0], Joint):
            return None
        found = rows[0].together(
            rows,
            OnRing(
                which=chosen,
                ways=[placed.sign for placed in cases.rows],
                levers=[_some(placed.lever, chosen) for placed in cases.rows],
                arms=[_some(row.sizes.arm, chosen) for row in rows],
                press=[_some(press, chosen) for press in self.press],
                sprung=self._sprung,
                free=_of_joint(asked.free),
                target=_of_joint(asked.target),
                start=_of_joint(asked.start),
                sound=asked.sound,
            ),
        )
        if found is None:
            return None
        n, unknowns = asked.arms.shape
        number, unsupported = gravest(found.rows, n)
        number[~found.sound] = NOT_CONVERGED
        number[~asked.sound] = INVALID_INPUT
        return Rest(
            place=_of_network(found.place, unknowns),
            force=_of_network(found.force, unknowns),
            stiffness=_of_network(found.stiffness, unknowns),
            residual=found.residual,
            number=number,
            unsupported=unsupported,
            iterations=found.steps,
            safe_path=np.zeros(n, np.bool_),
            rows=list(found.rows),
        )

    def _propose(self, asked: Asked, start: FloatArray) -> tuple[IntArray, FloatArray | None]:
        """Begin where a row that is the whole bearing says that the ring rests; in how many steps.

        Only rows whose kernels know the ring have one; it is judged as any other start, from
        where its elements are there: the row's memory.
        """
        cases, chosen, arms = self.cases, asked.chosen, asked.arms
        placed, steps = cases.rows[0], np.zeros(len(chosen), np.int64)
        if len(cases.rows) > 1 or placed.sign < 0.0 or not isinstance(placed.row, SelfBalancing):
            return steps, None
        known = cases.valid[chosen] & placed.row.valid[chosen] & (self.press[0][chosen] == 0.0)
        known &= placed.lever[chosen] == 0.0
        if not known.any():
            return steps, None
        which = chosen[known]
        place, settled, taken, memory = placed.row.equilibrium(
            cases.free[which], cases.load[which], start[known, :FIVE] / arms[known, :FIVE], which
        )
        rows = np.flatnonzero(known)[settled]
        start[rows, :FIVE] = place[settled] * arms[rows, :FIVE]
        steps[known] = taken
        if memory is None:
            return steps, None
        nearby = np.full((len(chosen), memory.shape[1]), np.nan)
        nearby[rows] = memory[settled]
        return steps, nearby

    def _push(
        self, start: FloatArray, chosen: Indices, loose: BoolArray, target: FloatArray
    ) -> None:
        """Let what is loose begin pushed in by the load, for rows that touch are stiff."""
        if not (self._sprung or loose.any()):
            return
        begin = np.zeros(target.shape)
        sizes = [placed.row.sizes for placed in self.cases.rows]
        counts = [placed.row.element_count for placed in self.cases.rows]
        stiffness = np.sum(
            [size.stiffness[chosen] * count for size, count in zip(sizes, counts, strict=True)],
            axis=0,
        )
        radial = np.hypot(target[:, 1], target[:, 2])
        away = (4.5 * radial / stiffness) ** (2.0 / 3.0)
        for i in (1, 2):
            unit = np.divide(target[:, i], radial, where=radial > 0.0, out=np.zeros(len(chosen)))
            begin[:, i] = np.where(loose[:, i], away * unit, 0.0)
        axial = target[:, 0]
        yielding = stiffness * np.maximum(sizes[0].sine[chosen], 0.2) ** 2.5
        into = np.sign(axial) * (np.abs(axial) / yielding) ** (2.0 / 3.0)
        if self._sprung:
            begin[:, SLIDE] = 2.0 * (target[:, SLIDE] / yielding) ** (2.0 / 3.0)
            into += np.where(axial == 0.0, 0.5 * begin[:, SLIDE], 0.0)
        begin[:, 0] = np.where(loose[:, 0], into, 0.0)
        start += begin


def _some(values: Values, chosen: Indices) -> Values:
    """The values of some cases, in order; of all of them not a copy."""
    return values if len(chosen) == len(values) else values[chosen]


def _of_joint(values: Unknowns) -> Unknowns:
    """The unknowns of rows that are balanced in one go; zero where there is no slide."""
    room = _zeros(len(values), JOINT, values.dtype)
    room[:, : values.shape[1]] = values[:, :JOINT]
    return room


def _zeros(cases: int, unknowns: int, kind: DTypeLike = np.float64) -> NDArray[Any]:
    """Zeros (cases, unknowns); the cases of an unknown stand together, as of `Cases.load`."""
    return np.zeros((unknowns, cases), kind).T


def _of_network(values: FloatArray, unknowns: int) -> FloatArray:
    """Forces, places or stiffnesses of the joint unknowns among so many; zero of what is more."""
    shape = values.shape[0], *(unknowns for _ in values.shape[1:])
    if unknowns <= JOINT:
        return values[tuple(slice(size) for size in shape)]
    room = np.zeros(shape)
    room[tuple(slice(size) for size in values.shape)] = values
    return room


def pressed_in(cases: Cases) -> tuple[FloatArray, ...]:
    """How far the clamped rings press each row in axially, e of `network`; (cases,) each, m.

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


def condensed(stiffness: FloatArray) -> FloatArray:
    """The ring's stiffness (cases, 5, 5), with the springs' slide following."""
    ring = stiffness[:, :FIVE, :FIVE]
    if stiffness.shape[1] > FIVE:
        slide = stiffness[:, SLIDE, SLIDE]
        follow = np.divide(
            stiffness[:, SLIDE, :FIVE], slide[:, np.newaxis], where=slide[:, np.newaxis] > 0.0,
            out=np.zeros((len(slide), FIVE)),
        )  # fmt: skip
        ring = ring - stiffness[:, :FIVE, SLIDE, np.newaxis] * follow[:, np.newaxis, :]
    return ring
