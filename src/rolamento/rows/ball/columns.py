"""Many cases that share a bearing's rows and models: their numbers, one column a case."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.case.bearing import Bearing, RowPlace
from rolamento.case.duty import AXES, LOADS
from rolamento.case.varied import bounded, varied_arrays
from rolamento.clearance.batch import MOUNTED_FIELDS
from rolamento.errors import InputError
from rolamento.rows.ball import layout
from rolamento.rows.ball.fields import GEOMETRY, PRELOADS, Flags, consistent
from rolamento.rows.ball.problem import (
    Floats,
    apply_model,
    bearing_column,
    bearing_columns,
    ring_arms,
)


@dataclass(frozen=True, slots=True)
class RowColumns:
    """One row of balls: its parameters (layout.COLUMN, cases), which way it faces, where it is.

    position: (cases,), m. The parameters hold the duty of a plain row only.
    """

    p: Floats
    balls: int
    sign: float
    position: Floats


@dataclass(frozen=True, slots=True)
class Columns:
    """Many cases of one bearing; what the ring is asked for in SI units, (5, cases).

    free: whether the load is given on a degree of freedom; load, displacement: what is given.
    preload: how the rows press on each other ("force", "offset", "spring", "pair" for the force in
    a pair of such bearings, or ""), and how much, (cases,). A column that is not valid holds NaN.
    """

    rows: tuple[RowColumns, ...]
    free: Flags
    load: Floats
    displacement: Floats
    preload: str
    preload_value: Floats
    control: str
    friction: Floats
    cage_drag: Floats
    mesh: str

    @property
    def cases(self) -> int:
        """How many."""
        return int(self.free.shape[1])

    @property
    def is_plain(self) -> bool:
        """Whether this is a single row at the origin: its own ring's duty is then the row's."""
        row = self.rows[0]
        return len(self.rows) == 1 and row.sign > 0.0 and not np.any(row.position != 0.0)


def spread(case: Case, values: Mapping[str, ArrayLike]) -> Columns:
    """Repeat a case over a batch, and put the fields in.

    values: as `rolamento.case.varied.varied_arrays` takes them, SI units. A load frees its degree
    of freedom, a displacement holds it; an angle takes the place of a clearance, and the other way
    round. Columns whose values the case would refuse hold NaN.

    Raises
    ------
    InputError
        For an unknown field, lengths that differ, two fields that exclude each other, or a case
        that still has a mounting.
    """
    if case.mounting is not None:
        raise InputError(
            "is for rolamento.solve and rolamento.solve_batch, which find the clearance first",
            field="mounting",
            example="rolamento.solve_batch(case, ...)",
        )
    arrays = bounded(varied_arrays(values))
    for name in MOUNTED_FIELDS:
        if name in arrays:
            raise InputError(
                "acts by way of the [mounting], and this case has none",
                field=name,
                example='[mounting] with bore = "25 mm" and outside_diameter = "62 mm"',
            )
    cases = max((array.size for array in arrays.values() if array.ndim), default=1)
    if any(array.ndim and array.size == 0 for array in arrays.values()):
        cases = 0
    valid = np.ones(cases, np.bool_)
    for array in arrays.values():
        valid &= ~np.isnan(array)
    free, load, displacement = _duty(case, arrays, cases)
    kind, amount = _preload(case.bearing, arrays, cases)
    held = {axis: displacement[i] for i, axis in enumerate(AXES)}
    # what the rows have in common has to be sound by itself, as the case has it
    common = _varied(case.bearing, case.bearing, set(), arrays)
    valid &= consistent(common, held, case.bearing.ball_count)
    columns = []
    for place in case.bearing.places:
        own = _own_fields(case.bearing, place)
        bearing = _varied(case.bearing, place.bearing, own, arrays)
        valid &= consistent(bearing, {}, place.bearing.ball_count)
        columns.append(_row_columns(case, place, bearing, arrays, cases))
    for row in columns:
        row.p[:, ~valid] = np.nan
    friction, drag = _friction(case, arrays)
    found = Columns(
        tuple(columns), free, load, displacement, kind, amount, case.model.raceway_control,
        np.full(cases, friction), np.full(cases, drag), case.model.mesh,
    )  # fmt: skip
    if found.is_plain:
        _put_duty(columns[0].p, free, load, displacement)
    return found


def _duty(case: Case, arrays: Mapping[str, Floats], cases: int) -> tuple[Flags, Floats, Floats]:
    """Which degrees of freedom are free, the loads and the displacements; (5, cases) each."""
    duty = case.duty
    free = np.repeat(np.array(duty.free)[:, np.newaxis], cases, axis=1)
    load = np.repeat(np.array(duty.applied_load)[:, np.newaxis], cases, axis=1)
    displacement = np.repeat(np.array(duty.imposed_displacement)[:, np.newaxis], cases, axis=1)
    for i, (axis, name) in enumerate(zip(AXES, LOADS, strict=True)):
        if (given := arrays.get(f"duty.load.{name}")) is not None:
            free[i], load[i], displacement[i] = True, given, 0.0
        if (given := arrays.get(f"duty.displacement.{axis}")) is not None:
            free[i], load[i], displacement[i] = False, 0.0, given
    return free, load, displacement


def _friction(case: Case, arrays: Mapping[str, Floats]) -> tuple[Floats, Floats]:
    """Coefficient of friction and drag of the cage; 0 where none is given."""
    name = "lubricant.friction_coefficient"
    if name in arrays and case.lubricant is None:
        raise InputError(
            "belongs to a lubricant, and this case has none",
            field=name,
            example='lubricant = "ISO VG 68"',
        )
    own = 0.0 if case.lubricant is None else case.lubricant.friction_coefficient or 0.0
    drag = arrays.get("model.cage_drag", np.asarray(case.model.cage_drag))
    return arrays.get(name, np.asarray(own)), drag


def _preload(bearing: Bearing, arrays: Mapping[str, Floats], cases: int) -> tuple[str, Floats]:
    """How the rows press on each other, and how much; (cases,)."""
    signs = {place.sign for place in bearing.places}
    for name in PRELOADS:
        given = arrays.get(f"bearing.preload.{name}")
        if given is None:
            continue
        if len(signs) < 2:
            raise InputError(
                "needs rows that face each other",
                field=f"bearing.preload.{name}",
                example='arrangement = "DB"',
            )
        return name, np.broadcast_to(given, cases).astype(np.float64)
    if bearing.preload is None:
        return "", np.zeros(cases)
    pair_force = bearing.preload.pair_force(bearing.contact_angle)
    if pair_force is not None:
        return "pair", np.full(cases, pair_force)
    kind = next(name for name in PRELOADS if getattr(bearing.preload, name) is not None)
    return kind, np.full(cases, getattr(bearing.preload, kind))


def _varied(bearing: Bearing, row: Bearing, own: set[str], arrays: Mapping[str, Floats]) -> Any:
    """A row's bearing with the arrays for its attributes; what the row has of its own stays."""
    given = {name: arrays[f"bearing.{name}"] for name in GEOMETRY if f"bearing.{name}" in arrays}
    given = {name: array for name, array in given.items() if name not in own}
    for name in list(given):
        for rival in Case.fields()[f"bearing.{name}"].rivals:
            given.setdefault(rival.removeprefix("bearing."), None)  # type: ignore[arg-type]
    rings = _material(row.ring_material, "ring_material", arrays)
    follows = "ball_material" not in bearing.model_fields_set
    balls = _material(rings if follows else row.ball_material, "ball_material", arrays)
    names = (*GEOMETRY, "inner_shoulder_height", "outer_shoulder_height")
    attributes = {name: getattr(row, name) for name in names}
    return SimpleNamespace(**{**attributes, **given}, ring_material=rings, ball_material=balls)


def _own_fields(bearing: Bearing, place: RowPlace) -> set[str]:
    """What the row does not take from the set; an own angle excludes the set's clearance too."""
    if bearing.rows is None:
        return set()
    return set(bearing.rows[bearing.places.index(place)].own)


def _material(material: Any, part: str, arrays: Mapping[str, Floats]) -> Any:
    names = ("youngs_modulus", "poisson_ratio", "density")
    return SimpleNamespace(
        **{name: arrays.get(f"bearing.{part}.{name}", getattr(material, name)) for name in names}
    )


def _row_columns(
    case: Case, place: RowPlace, bearing: Any, arrays: Mapping[str, Floats], cases: int
) -> RowColumns:
    """A row's parameters, its speeds and first ball put in; the ring's duty is not."""
    if any(name.startswith("bearing.") for name in arrays):
        with np.errstate(invalid="ignore", divide="ignore"):
            p = bearing_columns(bearing, (cases,))
    else:
        p = np.repeat(bearing_column(place.bearing)[:, np.newaxis], cases, axis=1)
    duty = case.duty
    p[layout.INNER_SPEED] = arrays.get("duty.inner_speed", duty.inner_speed)
    p[layout.OUTER_SPEED] = arrays.get("duty.outer_speed", duty.outer_speed)
    apply_model(p, case.model)
    first = arrays.get("duty.first_ball_azimuth", np.asarray(duty.first_ball_azimuth))
    p[layout.COS_FIRST] = np.cos(first + place.phase)
    p[layout.SIN_FIRST] = np.sin(first + place.phase)
    position = np.full(cases, place.position)
    if "bearing.spacing" in arrays:
        if case.bearing.spacing is None:
            raise InputError(
                "belongs to an arrangement, and this bearing has none",
                field="bearing.spacing",
                example='arrangement = "DB"',
            )
        position = (
            place.position / case.bearing.spacing * arrays["bearing.spacing"] + 0.0 * position
        )
    return RowColumns(p, place.bearing.ball_count, place.sign, position)


def _put_duty(p: Floats, free: Flags, load: Floats, displacement: Floats) -> None:
    """Put what the ring is asked for into the parameters of a bearing of one row."""
    arms = ring_arms(p)
    p[layout.FREE : layout.FREE + 5] = free
    p[layout.APPLIED : layout.APPLIED + 5] = load / arms
    p[layout.IMPOSED : layout.IMPOSED + 5] = displacement * arms
