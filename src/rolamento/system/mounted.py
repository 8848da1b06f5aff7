"""A set in its seats: which geometry it runs with, and what becomes of its preload.

Before mounting the preload shows how far the rows are pressed in; from then on clamped rings keep
the axial places of their grooves, and `rolamento.clearance.sets` shows how those of each row
change. Without springs the force between the rows is what comes out. In a set whose rows all face
one way only the differences between rows act, and x counts from the mean of their first contacts.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, Final, NamedTuple

import numpy as np

from rolamento.case import Case
from rolamento.case.arrangement import Preload
from rolamento.case.bearing import Bearing, RowPlace
from rolamento.case.duty import Duty
from rolamento.case.roller_bearing import RollerBearing
from rolamento.case.varied import is_of_mounting
from rolamento.clearance.operating import OperatingClearance, operating_clearance
from rolamento.clearance.sets import RunningRow, Stage, running_rows, width_of
from rolamento.clearance.standards import Limit
from rolamento.errors import InputError
from rolamento.numerics import BoolArray, FloatArray
from rolamento.rows.row import IntArray
from rolamento.solved import PreloadStage, Solved
from rolamento.system.cases import Cases, RowState, spread
from rolamento.system.preload import between_rows
from rolamento.system.ring import pressed_in
from rolamento.system.solve import joined, solve_cases
from rolamento.types import type_of_element
from rolamento.units import from_si
from rolamento.words import Note, said

__all__ = [
    "LIMITS",
    "clearances_of_set",
    "notes_on_set",
    "preload_stages",
    "running_set",
    "solve_mounted",
]

LIMITS: Final[tuple[Limit, Limit, Limit]] = ("maximum", "mean", "minimum")
"""Limits of the clearance, from the loosest set to the tightest."""
_OWN: Final = ("contact_angle", "diametral_clearance")


class _Placed(NamedTuple):
    """A row and where the axial distance of its groove centres has come to; arrays (cases,), m.

    element: what rolls in it. angular: whether it is given by its contact angle.
    """

    row: RunningRow
    axial: FloatArray
    element: str
    angular: bool

    @property
    def closed(self) -> BoolArray:
        """Where the fits have taken its whole clearance, and with it the free contact angle."""
        return np.asarray(self.angular & self.row.closed)

    @property
    def offset(self) -> FloatArray:
        """How far it is pressed in from first contact."""
        return np.asarray(self.axial - self.row.touch)


class _Unmounted(NamedTuple):
    """The rows before they are mounted, at a limit of their tolerances.

    angular: which are given by their contact angle. press: how far the clamped rings press each
    in, (cases,), m. springs: whether springs do.
    """

    limit: Limit | None
    rows: list[RunningRow]
    angular: list[bool]
    press: tuple[FloatArray, ...]
    springs: bool


def solve_mounted(
    case: Case,
    values: Mapping[str, FloatArray],
    *,
    threads: int | None = None,
    start: FloatArray | None = None,
) -> Solved:
    """Solve cases of a mounted set, each with the geometry and the preload that it runs with.

    Parameters
    ----------
    case
        With a mounting.
    values
        As `spread`; those of the mounting and of temperatures too.
    start
        As `Cases.start`.

    Raises
    ------
    InputError
        As `spread` and `rolamento.clearance.sets.running_rows`. What closes the bearing of a case,
        past all sense or for want of seats, is that case's affair: it is not valid.
    """
    groups = _mounted_groups(case, values, threads)
    if start is not None:
        groups = ((index, replace(cases, start=start[index])) for index, cases in groups)
    return joined([(index, solve_cases(cases)) for index, cases in groups])


def _mounted_groups(
    case: Case, values: Mapping[str, FloatArray], threads: int | None
) -> Iterator[tuple[IntArray, Cases]]:
    """The cases in which the same rows have kept a free contact angle: which, and how they run."""
    arrays = {name: np.asarray(array, np.float64) for name, array in values.items()}
    plain = _plain(case)
    of_set = {name: array for name, array in arrays.items() if not is_of_mounting(name)}
    cases = max((array.size for array in arrays.values() if array.ndim), default=1)
    of_set.setdefault("duty.inner_speed", np.full(cases, case.duty.inner_speed))
    of_set = {name: np.broadcast_to(array, cases) for name, array in of_set.items()}
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        unmounted = _unmounted(case, arrays, None, cases)
        placed = _placed(case, arrays, "running", unmounted, cases)
        closed = np.stack([np.broadcast_to(one.closed, cases) for one in placed], axis=1)
    # beyond its bounds a value is NaN, also where this mounting makes nothing of it
    refused = np.any([np.broadcast_to(np.isnan(one), cases) for one in arrays.values()], axis=0)
    for one in placed:
        if not type_of_element(one.element).conical:
            refused = refused | one.row.shut
    kept = {name: array for name, array in of_set.items() if name not in _of_rows(case)}
    for pattern in np.unique(closed, axis=0) if cases else closed[:1]:
        index = np.flatnonzero((closed == pattern).all(axis=1))
        states = [
            _some(_state(one, shut=bool(shut)), index)
            for one, shut in zip(placed, pattern, strict=True)
        ]
        own = {name: array[index] for name, array in kept.items()}
        found = spread(plain, own, threads=threads, states=states)
        lost = refused[index]
        for part in found.rows:
            part.row.invalidate(lost)
        varied = {name: array for name, array in found.varied.items() if name in arrays}
        yield index, replace(found, varied=varied, valid=found.valid & ~lost)


def running_set(case: Case) -> Case:
    """The case with its rows as they run, and no mounting; what `solve` solves.

    Raises
    ------
    InputError
        If something is missing, contradicts itself or is not in the tables, or no bearing is left.
    """
    mounting = case.mounting
    assert mounting is not None
    clearances_of_set(case)  # which refuses by name what the arrays below leave as NaN
    unmounted = _unmounted(case, {}, mounting.limit, 1)
    placed = _placed(case, {}, "running", unmounted, 1)
    facing = _facing(case)
    preload = case.bearing.preload
    clamped = facing and (preload is None or preload.spring is None)
    if preload is None and not any(one.angular for one in placed):
        clamped = False
    rows = []
    listed = case.bearing.rows or [None] * len(placed)
    for place, own, one in zip(case.bearing.places, listed, placed, strict=True):
        shut = bool(one.closed[0])
        _refuse_shut(one)
        numbers = {name: float(array[0]) for name, array in one.row.geometry.items()}
        if one.angular and not shut:
            numbers["contact_angle"] = float(one.row.contact_angle[0])
        else:
            numbers["diametral_clearance"] = float(one.row.clearance[0])
        counts_from_touch = clamped or preload is not None or (one.angular and not shut)
        offset = one.offset if counts_from_touch else one.axial
        rows.append(
            place.bearing.ROW(
                element=place.bearing.element,
                orientation="+" if place.sign > 0.0 else "-",
                position=place.position,
                phase=place.phase,
                offset=float(offset[0]),
                designation=None if own is None else own.designation,  # and all that it tells
                **{**_inside(place), **numbers},
            )
        )
    if clamped:
        preload = Preload(offset=rows[0].offset)
    bearing = case.bearing.replace(
        arrangement=None, spacing=None, rows=tuple(rows), preload=preload
    )
    return _plain(case).replace(bearing=bearing)


def clearances_of_set(case: Case) -> tuple[OperatingClearance, ...]:
    """The clearance in operation of each row of a set that differs from those before it.

    Raises
    ------
    InputError
        As `operating_clearance`.
    """
    assert case.mounting is not None
    found: dict[Bearing | RollerBearing, OperatingClearance] = {}
    for place in case.bearing.places:
        if place.bearing not in found:
            found[place.bearing] = operating_clearance(
                place.bearing,
                case.mounting,
                case.temperature,
                inner_speed=case.duty.inner_speed,
                outer_speed=case.duty.outer_speed,
            )
    return tuple(found.values())


def preload_stages(case: Case) -> tuple[PreloadStage, ...]:
    """What becomes of the preload of a mounted set; empty where its rows do not face each other.

    Raises
    ------
    InputError
        As `running_set`.
    """
    mounting, duty = case.mounting, case.duty
    assert mounting is not None
    if not _facing(case):
        return ()
    chosen = LIMITS.index(mounting.limit)
    turning = duty.turns
    steps: list[tuple[str, Stage, bool]] = [
        ("unmounted", "unmounted", False), ("mounted", "mounted", False)
    ]  # fmt: skip
    if case.temperature is not None and case.temperature.inner_ring is not None:
        steps.append(("warm", "warm", False))
    if turning:
        steps += [("rings_grown", "running", False), ("at_speed", "running", True)]
    points: list[tuple[list[_Placed], bool]] = []
    unmounted = [_unmounted(case, {}, limit, 1) for limit in LIMITS]
    for _, stage, moving in steps:
        points += [(_placed(case, {}, stage, before, 1), moving) for before in unmounted]
    force, stiffness, pressure = _without_load(case, points)
    stages = []
    for index, (name, _, _) in enumerate(steps):
        first = len(LIMITS) * index
        here, at = points[first + chosen][0], first + chosen
        stages.append(
            PreloadStage(
                name=name,
                preload=(force[first], force[first + 1], force[first + 2]),
                contact_angle=tuple(float(one.row.contact_angle[0]) for one in here),
                offset=tuple(float(one.offset[0]) for one in here),
                axial_stiffness=stiffness[at],
                max_pressure=pressure[at],
            )
        )
    return tuple(stages)


def notes_on_set(case: Case, stages: Sequence[PreloadStage]) -> tuple[Note, ...]:
    """What to know about a mounted set: its preload in operation, and of the chain of its rows."""
    notes: list[Note] = []
    if stages:
        first, last = stages[0], stages[-1]
        limits = dict(zip(("loosest", "mean", "tightest"), last.preload, strict=True))
        chosen = LIMITS.index(case.mounting.limit) if case.mounting is not None else 1
        notes.append(Note("preload_in_operation", {"unmounted": first.preload[chosen], **limits}))
        if limits["loosest"] == 0.0:
            notes.append(Note("preload_lost_mounted", {"always": limits["tightest"] == 0.0}))
        balls = [place.bearing.element == "ball" for place in case.bearing.places]
        angles = zip(last.contact_angle, balls, strict=True)
        if any(angle == 0.0 for angle, of_balls in angles if of_balls):
            notes.append(Note("no_free_angle"))
    if case.temperature is not None and case.temperature.inner_ring is not None:
        width = width_of(case)
        key = "distance_of_seats" if width is None else "distance_of_rings"
        notes.append(Note(key, {} if width is None else {"width": width}))
    if any(place.bearing.bearing_type.conical for place in case.bearing.places):
        notes.append(Note("clearance_of_tapered"))
    of_rows = dict.fromkeys(
        note
        for found in clearances_of_set(case)
        for note in found.warnings
        if note.key not in ("interference", "interference_at_minimum")
    )
    return (*notes, *of_rows)


def _plain(case: Case) -> Case:
    warm = None if case.temperature is None else case.temperature.of_bearing
    return case.replace(mounting=None, temperature=warm)


def _of_rows(case: Case) -> set[str]:
    """The fields that each row runs with its own values of."""
    names = _OWN if case.bearing.element == "ball" else ("diametral_clearance",)
    return {f"bearing.{name}" for name in names}


def _facing(case: Case) -> bool:
    """Whether rows that can be pressed in face each other."""
    return len({place.sign for place in case.bearing.places if place.bearing.locates}) > 1


def _inside(place: RowPlace) -> dict[str, Any]:
    """What a row is made of, beside what the temperatures and the fits change."""
    bearing = place.bearing
    if isinstance(bearing, Bearing):
        return {"ball_count": bearing.ball_count}
    names = set(type(bearing).model_fields) & set(bearing.ROW.model_fields)
    kept = {name: getattr(bearing, name) for name in names - {"element", "designation"}}
    return {name: value for name, value in kept.items() if value is not None}


def _refuse_shut(one: _Placed) -> None:
    """Refuse an interference that is past all sense, as a single bearing does."""
    if type_of_element(one.element).conical or not one.row.shut[0]:
        return
    raise InputError(
        said(
            "closes the bearing: its operating clearance would be {clearance}",
            clearance=from_si(float(f"{float(one.row.clearance[0]):.4g}"), "length"),
        ),
        field="mounting",
        example='a looser shaft_tolerance, or clearance_class = "C3"',
    )


def _unmounted(
    case: Case, arrays: Mapping[str, FloatArray], limit: Limit | None, cases: int
) -> _Unmounted:
    """The rows before anything is mounted, and how far they are pressed in then."""
    rows = [row.over(cases) for row in running_rows(case, arrays, "unmounted", limit)]
    given = {name: array for name, array in arrays.items() if not is_of_mounting(name)}
    elements = [place.bearing.element for place in case.bearing.places]
    angular = [_angular(case, index, arrays) for index in range(len(rows))]
    start = [
        replace(_state(_Placed(row, row.touch, element, own), shut=False), press=None)
        for row, element, own in zip(rows, elements, angular, strict=True)
    ]
    fields = {name: array for name, array in given.items() if name not in _of_rows(case)}
    fields = {name: np.broadcast_to(array, cases) for name, array in fields.items()}
    fields = fields or {"duty.inner_speed": np.zeros(cases)}
    held = spread(_plain(case), fields, states=start)
    return _Unmounted(limit, rows, angular, pressed_in(held), held.preload == "spring")


def _placed(
    case: Case,
    arrays: Mapping[str, FloatArray],
    stage: Stage,
    unmounted: _Unmounted,
    cases: int,
) -> list[_Placed]:
    """The rows at a stage, each with the axial distance of its groove centres."""
    limit, before, angular, press, springs = unmounted
    after = before
    if stage != "unmounted":
        after = [row.over(cases) for row in running_rows(case, arrays, stage, limit)]
    elements = [place.bearing.element for place in case.bearing.places]
    placed = []
    for row, new, element, own, e in zip(before, after, elements, angular, press, strict=True):
        axial = np.asarray((row.touch + e if own else e) * new.stretch)
        placed.append(_Placed(new, (new.touch if springs else axial) + new.along, element, own))
    if not _facing(case):  # x takes up what the rows have in common
        held_axially = [
            one
            for one, place in zip(placed, case.bearing.places, strict=True)
            if place.bearing.locates
        ]
        common = [one.offset if one.angular else one.axial for one in held_axially or placed]
        placed = [one._replace(axial=one.axial - np.mean(common, axis=0)) for one in placed]
    return placed


def _angular(case: Case, index: int, arrays: Mapping[str, FloatArray]) -> bool:
    """Whether a row is given by its contact angle, which may be what varies."""
    row = case.bearing.places[index].bearing
    if row.element != "ball":
        return row.bearing_type.conical
    if not case.bearing.own_fields(index) & set(_OWN):
        if "bearing.diametral_clearance" in arrays:
            return False
        if "bearing.contact_angle" in arrays:
            return True
    return bool(row.contact_angle)


def _state(one: _Placed, *, shut: bool) -> RowState:
    """What the assembly takes; shut: an angular row without clearance, given by that."""
    geometry: dict[str, Any] = dict(one.row.geometry)
    if type_of_element(one.element).conical:
        return RowState(geometry, one.offset)
    if one.element != "ball":
        return RowState({**geometry, "diametral_clearance": one.row.clearance}, one.axial)
    if one.angular and not shut:
        angle = np.where(one.closed, np.nan, one.row.contact_angle)
        geometry.update(contact_angle=angle, diametral_clearance=None)
        return RowState(geometry, one.offset)
    geometry.update(contact_angle=None, diametral_clearance=one.row.clearance)
    return RowState(geometry, one.axial)


def _some(state: RowState, index: IntArray) -> RowState:
    """The state of a row in some of the cases."""
    geometry = {
        name: None if array is None else array[index] for name, array in state.geometry.items()
    }
    return RowState(geometry, None if state.press is None else state.press[index])


def _without_load(
    case: Case, points: Sequence[tuple[list[_Placed], bool]]
) -> tuple[list[float], list[float], list[float]]:
    """Preload, axial stiffness and largest pressure of sets that nothing loads but themselves.

    points: rows of one case each, and whether the set turns.
    """
    duty = case.duty
    count = len(points)
    force, stiffness, pressure = (np.full(count, np.nan) for _ in range(3))
    still = Duty(first_ball_azimuth=duty.first_ball_azimuth)
    plain = _plain(case).replace(duty=still)
    shut = np.array([[bool(one.closed[0]) for one in rows] for rows, _ in points])
    for pattern in np.unique(shut, axis=0):
        chosen = np.flatnonzero((shut == pattern).all(axis=1)).tolist()
        states = []
        for index, closed in enumerate(pattern):
            own = [_state(points[i][0][index], shut=bool(closed)) for i in chosen]
            geometry = {
                name: None if value is None else np.concatenate([one.geometry[name] for one in own])
                for name, value in own[0].geometry.items()
            }
            states.append(RowState(geometry, np.concatenate([one.press for one in own])))
        turning = np.array([1.0 if points[i][1] else 0.0 for i in chosen])
        speeds = {
            "duty.inner_speed": duty.inner_speed * turning,
            "duty.outer_speed": duty.outer_speed * turning,
        }
        solved = solve_cases(spread(plain, speeds, threads=1, states=states))
        force[chosen] = between_rows(solved)
        stiffness[chosen] = solved.stiffness.array[:, 0, 0]
        with np.errstate(invalid="ignore"):
            pressure[chosen] = np.fmax(
                solved.inner.max_pressure.max(axis=1), solved.outer.max_pressure.max(axis=1)
            )
    return force.tolist(), stiffness.tolist(), pressure.tolist()
