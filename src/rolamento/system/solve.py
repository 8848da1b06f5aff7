"""From cases to the result: one plain row by its own fast path, rows on a ring around them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields, replace
from functools import reduce
from typing import Any

import numpy as np

from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.rows.row import (
    Film,
    IntArray,
    Response,
)
from rolamento.solved import (
    Answer,
    Index,
    RingDisplacement,
    RingLoad,
    Rollers,
    Rows,
    Solved,
    Status,
    Stiffness,
    Tables,
)
from rolamento.solved.tables import GEOMETRY_COLUMNS
from rolamento.status import NOT_CONVERGED
from rolamento.system.cases import Cases
from rolamento.system.guidance import S, System, solve_by_jones


@frozen
class Balanced:
    """Cases in balance: the ring's place, force and stiffness in SI, and the rows held there.

    control: what guided each element, of all rows; shown: what the result says of that.
    """

    status: Status
    place: FloatArray
    force: FloatArray
    stiffness: FloatArray
    rows: tuple[Response, ...]
    control: FloatArray
    shown: IntArray

    def without(self, cases: BoolArray) -> Balanced:
        """The same with cases that, after all, did not converge."""
        number = np.where(cases & self.status.converged, NOT_CONVERGED, self.status.number)
        return replace(self, status=replace(self.status, number=number))


def solve_cases(cases: Cases) -> Solved:
    """Solve cases whose balance has no lubricant film in it."""
    return result(cases, balance(cases))


def balance(cases: Cases, film: Film | None = None) -> Balanced:
    """Find the equilibrium of every case.

    film: what shears in the contacts under friction control, instead of Coulomb's friction.
    """
    row = cases.alone
    if row is None:
        return _on_ring(cases)
    held, control, shown = _guided(row, cases.case.model.raceway_control)
    if cases.case.model.raceway_control == "friction":
        held = row.rolled(held, replace(cases.traction, film=film))
    status = Status(held.number, held.residual, held.iterations, held.safe_path, held.unsupported)
    return Balanced(status, held.place, held.force, held.stiffness, (held,), control, shown)


def _on_ring(cases: Cases) -> Balanced:
    from rolamento.system.ring import RowsOnRing, condensed

    system = RowsOnRing.of(cases)
    solution, control, shown = _guided(system, cases.case.model.raceway_control)
    status = Status(
        solution.number, solution.residual, solution.iterations, solution.safe_path,
        solution.unsupported,
    )  # fmt: skip
    stiffness = condensed(solution.stiffness)
    place, force = solution.place[:, :5], solution.force[:, :5]
    return Balanced(status, place, force, stiffness, tuple(solution.rows), control, shown)


def _guided(system: System[S], mode: str) -> tuple[S, FloatArray, IntArray]:
    """Solve under the raceway control asked for: solution, control used, verdict to show."""
    if mode == "jones":
        return solve_by_jones(system)
    shape, race = system.shape, 1  # the outer, by itself
    if mode == "inner":
        race = -1
        system = system.guided(np.full((1, shape[1]), -1.0))
    return system.solve(), np.broadcast_to(float(race), shape), np.broadcast_to(race, shape)


def result(cases: Cases, balanced: Balanced) -> Solved:
    """Put the result together; a case without one carries NaN."""
    lost = ~balanced.status.converged
    guides = zip(cases.split(balanced.control), cases.split(balanced.shown), strict=True)
    answers = tuple(
        placed.row.answer(held, *guide, lost)
        for placed, held, guide in zip(cases.rows, balanced.rows, guides, strict=True)
    )
    # a row is shown as often as it has faces
    faces = [(placed, face) for placed in cases.rows for face in placed.row.faces]
    geometry = [placed.row.geometry for placed, _ in faces]
    place, load, stiffness = balanced.place, balanced.force, balanced.stiffness
    np.copyto(load, cases.load, where=cases.free)  # in place: what was given, to the last bit
    carried = load[:, np.newaxis] if cases.alone is not None else _carried(cases, balanced)
    for array in (place, load, stiffness, carried):
        array[lost] = np.nan
    return Solved(
        case=cases.case,
        varied=cases.varied,
        status=balanced.status,
        displacement=RingDisplacement(*place.T),
        load=RingLoad(*load.T),
        stiffness=Stiffness(stiffness),
        rows=Rows(
            sign=np.array([placed.sign * face for placed, face in faces]),
            element_count=np.array([placed.row.element_count for placed, _ in faces]),
            position=_side_by_side([placed.position for placed, _ in faces]),
            load=carried,
            element=tuple(one.bearing.element for one in cases.case.bearing.places),
            **{
                name: _side_by_side([getattr(own, name) for own in geometry])
                for name in (*GEOMETRY_COLUMNS, "effective_length")
            },
        ),
        answer=answers[0] if len(answers) == 1 else RowAnswers(answers),
    )


def _side_by_side(rows: Sequence[FloatArray]) -> FloatArray:
    """Numbers of the rows, (cases,) each, as (cases, rows); of a single row not a copy."""
    return rows[0][:, np.newaxis] if len(rows) == 1 else np.stack(rows, axis=1)


def _carried(cases: Cases, balanced: Balanced) -> FloatArray:
    """What the ring carries through each row; (cases, rows, 5), in the bearing's frame."""
    from rolamento.system.network import seen_by_ring

    parts = [
        seen_by_ring(placed.sign, placed.lever, held.face_forces)
        for placed, held in zip(cases.rows, balanced.rows, strict=True)
    ]
    return np.concatenate(parts, axis=1)


@frozen
class RowAnswers:
    """What several rows answer, side by side."""

    rows: tuple[Answer, ...]

    def part(self, index: Index) -> RowAnswers:
        """Return some of the cases."""
        return RowAnswers(tuple(row.part(index) for row in self.rows))

    def grip(self) -> FloatArray:
        """How deep each element is pressed into the inner ring, row after row."""
        return np.concatenate([row.grip() for row in self.rows], axis=1)

    def tables(self) -> Tables:
        """Evaluate every element of every case, row after row."""
        parts: list[Tables] = []
        slices = 0
        for row in self.rows:
            own = row.tables()
            slices = max(slices, 0 if own.rollers is None else own.rollers.slices)
            before = 1 + int(parts[-1].elements.row.max()) if parts else 0
            elements = replace(own.elements, row=own.elements.row + before)
            parts.append(replace(own, elements=elements))
        if slices:
            parts = [
                part
                if part.rollers
                else replace(part, rollers=Rollers.nowhere(part.elements.azimuth, slices))
                for part in parts
            ]
        return reduce(_beside, parts)


def _beside(one: Any, other: Any) -> Any:
    """Join records of arrays along the elements, after the cases; friction moves single rows."""
    if one is None or isinstance(one, np.ndarray):
        return None if one is None else np.concatenate([one, other], axis=min(one.ndim - 1, 1))
    names = type(one).__dataclass_fields__
    return type(one)(*(_beside(getattr(one, name), getattr(other, name)) for name in names))


@frozen
class GroupedAnswers:
    """What groups of cases answer, one group after the other.

    order: where each case stands among those of all groups; (cases,).
    """

    groups: tuple[Answer, ...]
    ends: IntArray
    order: IntArray

    def part(self, index: Index) -> GroupedAnswers:
        """Return some of the cases."""
        chosen = self.order[index]
        group = np.searchsorted(self.ends, chosen, side="right")
        starts = np.concatenate([[0], self.ends[:-1]])
        parts, places = [], []
        for number, answer in enumerate(self.groups):
            own = np.flatnonzero(group == number)
            if len(own):
                parts.append(answer.part(chosen[own] - starts[number]))
                places.append(own)
        if not parts:  # no case at all
            return GroupedAnswers((self.groups[0].part(chosen),), np.zeros(1, np.int64), chosen)
        ends = np.cumsum([len(own) for own in places])
        return GroupedAnswers(tuple(parts), ends, np.argsort(np.concatenate(places)))

    def grip(self) -> FloatArray:
        """How deep each element is pressed into the inner ring."""
        return np.concatenate([group.grip() for group in self.groups])[self.order]

    def tables(self) -> Tables:
        """Evaluate every element of every case."""
        found: Tables = _behind([group.tables() for group in self.groups], self.order)
        return found


def joined(groups: Sequence[tuple[IntArray, Solved]]) -> Solved:
    """Return one result of groups of cases of a bearing, each with the places of its cases."""
    if len(groups) == 1:
        return groups[0][1]
    places, parts = zip(*groups, strict=True)
    order = np.argsort(np.concatenate(places))
    first = parts[0]
    varied = {
        name: np.concatenate([part.varied[name] for part in parts])[order] for name in first.varied
    }
    shared = ("sign", "element_count", "element")
    return Solved(
        case=first.case,
        varied=varied,
        status=_behind([part.status for part in parts], order),
        displacement=RingDisplacement(
            *np.concatenate([part.displacement.array for part in parts])[order].T
        ),
        load=RingLoad(*np.concatenate([part.load.array for part in parts])[order].T),
        stiffness=_behind([part.stiffness for part in parts], order),
        rows=_behind([part.rows for part in parts], order, shared),
        answer=GroupedAnswers(
            tuple(part.answer for part in parts), np.cumsum([len(own) for own in places]), order
        ),
    )


def _behind(records: Sequence[Any], order: IntArray, shared: tuple[str, ...] = ("row",)) -> Any:
    """Join records of arrays over cases, one behind the other, and put the cases in order.

    shared: what has no axis of cases.
    """
    first, changed = records[0], {}
    for part in fields(first):
        values = [getattr(record, part.name) for record in records]
        if part.name in shared or values[0] is None:
            continue
        together = isinstance(values[0], np.ndarray)
        changed[part.name] = (
            np.concatenate(values)[order] if together else _behind(values, order, shared)
        )
    return replace(first, **changed)
