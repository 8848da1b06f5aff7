"""Many cases of one bearing: its rows, and what is asked of their common ring."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from pkgutil import resolve_name
from typing import Final, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.case import Case
from rolamento.case.duty import AXES, LOADS
from rolamento.case.parameters import parameters_of
from rolamento.case.rolling_bearing import RollingBearing
from rolamento.case.varied import bounded, is_of_mounting, varied_arrays
from rolamento.errors import InputError
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.rows.row import Driven, Guided, Row, Running, Traction, WholeBearing
from rolamento.words import marked, said

__all__ = ["Cases", "PlacedRow", "RowState", "spread"]

_PRELOADS: Final = ("force", "offset", "spring")
S = TypeVar("S", bound=np.generic)


@frozen
class RowState:
    """What one row of a set has of its own in many cases, as it runs.

    Attributes
    ----------
    geometry
        by field of `Bearing`; (cases,), SI, None for the rival of one that is given
    press
        how far the clamped rings press it in, e of `rolamento.system.network`; (cases,), m; None
        where it follows from the preload of the cases
    """

    geometry: Mapping[str, FloatArray | None]
    press: FloatArray | None = None


@frozen
class PlacedRow:
    """A row, the way it faces (+1 or -1), and where it is along x; (cases,), m.

    press: how far the clamped rings press it in, (cases,), m; None where it follows from
    the preload of the cases.
    """

    row: Row
    sign: float
    position: FloatArray
    press: FloatArray | None = None

    @property
    def lever(self) -> FloatArray:
        """How far from the row's own centre of tilting the bearing's is; (cases,), m."""
        return 0.0 * self.position if self.row.aside is not None else self.position


@frozen(slots=False)
class Cases:
    """Many cases of one bearing.

    Attributes
    ----------
    case
        what they have in common
    varied
        what varies from it, by the dotted names; (cases,)
    rows
        of rolling elements, from -x to +x
    free
        whether the load is given on a degree of freedom, else the displacement; (cases, 5)
    load, displacement
        what is given; (cases, 5), SI
    preload
        how the rows press on each other: "force", "offset", "spring", "pair" for the force in a
        pair of such bearings, or ""
    preload_value
        how much; (cases,), SI
    valid
        which cases the records would take; (cases,)
    unconstrained
        which cases nothing can hold along x: a thrust bearing without axial load; (cases,)
    traction
        what friction control takes
    start
        where the ring probably rests, by its place in neighbouring cases; (cases, 5), SI, NaN
        where that is not known
    """

    case: Case
    varied: Mapping[str, FloatArray]
    rows: tuple[PlacedRow, ...]
    free: BoolArray
    load: FloatArray
    displacement: FloatArray
    preload: str
    preload_value: FloatArray
    valid: BoolArray
    unconstrained: BoolArray
    traction: Traction
    start: FloatArray | None = None

    def __len__(self) -> int:
        """Count the cases."""
        return len(self.free)

    @cached_property
    def alone(self) -> WholeBearing | None:
        """The row that is the whole bearing, and balances its own ring; None of any other."""
        placed = self.rows[0]
        plain = len(self.rows) == 1 and placed.sign > 0.0 and placed.press is None
        plain = plain and not np.any(placed.position != 0.0)
        return placed.row if plain and isinstance(placed.row, WholeBearing) else None

    def guided(self, control: FloatArray) -> Cases:
        """The same cases, their elements guided so; (cases or 1, elements), row after row."""
        parts = self.split(control)
        rows = (
            replace(placed, row=placed.row.guided(own))
            if isinstance(placed.row, Guided)
            else placed
            for placed, own in zip(self.rows, parts, strict=True)
        )
        return replace(self, rows=tuple(rows))

    def split(self, elements: NDArray[S]) -> list[NDArray[S]]:
        """The columns of an array over all elements, row by row."""
        ends = np.cumsum([placed.row.element_count for placed in self.rows])[:-1]
        return list(np.split(elements, ends, axis=1))


def spread(
    case: Case,
    values: Mapping[str, ArrayLike] | None = None,
    *,
    threads: int | None = None,
    fast: bool = True,
    states: Sequence[RowState] | None = None,
) -> Cases:
    """Repeat a case over a batch, and put the fields in; threads, fast: how to solve them.

    states: of the rows of a mounted set, one each.

    values: as `varied_arrays` takes them. A load frees its degree of freedom, a displacement holds
    it; an angle takes the place of a clearance, and the other way round. Cases whose values the
    records would refuse are not `valid`.

    Raises
    ------
    InputError
        For an unknown field, lengths that differ, two fields that exclude each other, or a case
        that still has a mounting.
    """
    if case.mounting is not None:
        raise InputError(
            said("is only used by rolamento.solve, which finds the operating clearance first"),
            field="mounting",
            example="rolamento.solve(case)",
        )
    given = varied_arrays(values)
    for name in given:
        if is_of_mounting(name):
            raise InputError(
                said("takes effect through [mounting], which this case lacks"),
                field=name,
                example='mounting = { bore = "25 mm", outside_diameter = "62 mm" }',
            )
    cases = max((array.size for array in given.values() if array.ndim), default=1)
    if any(array.ndim and array.size == 0 for array in given.values()):
        cases = 0
    arrays = bounded(given)
    valid = np.ones(cases, np.bool_)
    for array in arrays.values():
        valid &= ~np.isnan(array)
    free, load, displacement = _duty(case, arrays, cases)
    kind, amount = _preload(case.bearing, arrays, cases)
    # what the rows have in common has to be sound by itself, as the case has it
    common = parameters_of(case.bearing, case.bearing, frozenset(), arrays)
    if arrays:
        _check_own_fields(case, arrays)
    valid &= common.consistent
    limit = np.broadcast_to(common.element_diameter, cases)
    valid &= (np.abs(displacement[:, :3]) <= limit[:, np.newaxis]).all(axis=1)  # as `Case` has it
    first = arrays.get("duty.first_ball_azimuth", np.asarray(case.duty.first_ball_azimuth))
    placed = []
    for index, place in enumerate(case.bearing.element_rows):
        of_row, bearing, varied = case.bearing.bearing_type, common, arrays
        if case.bearing.kind is None and place.bearing != case.bearing:
            of_row, own = place.bearing.bearing_type, case.bearing.own_fields(index)
            bearing = parameters_of(case.bearing, place.bearing, own, arrays)
        if states is not None:
            geometry = states[index].geometry
            bearing = bearing.with_(**geometry)
            given_of_row = {f"bearing.{k}": v for k, v in geometry.items() if v is not None}
            varied = {**arrays, **given_of_row}
        valid &= bearing.consistent
        alike = not any(name.startswith("bearing.") for name in varied)
        running = Running(
            cases=cases,
            inner_speed=arrays.get("duty.inner_speed", case.duty.inner_speed),
            outer_speed=arrays.get("duty.outer_speed", case.duty.outer_speed),
            azimuth=first + place.phase,
            spacing=arrays.get("bearing.spacing", case.bearing.spacing),
            model=case.model,
            record=place.bearing if alike else None,
            threads=threads,
            fast=fast,
        )
        row: Row = resolve_name(of_row.row)(bearing, running)  # imported now
        position, press = np.full(cases, place.position), None
        if case.bearing.spacing is not None and "bearing.spacing" in arrays:
            apart = arrays["bearing.spacing"]
            position = place.position / case.bearing.spacing * apart + 0.0 * position
        if row.aside is not None:
            position = place.sign * row.aside
        if states is not None:
            press = states[index].press
        elif place.offset is not None:  # the clamping presses it in by an offset of its own
            touching = 0.0 if case.bearing.preload is None else row.first_contact()
            press = place.offset + np.zeros(cases) + touching
        placed.append(PlacedRow(row, place.sign, position, press))
    if not valid.all():
        for part in placed:
            part.row.invalidate(~valid)
    unconstrained = np.zeros(cases, np.bool_)
    if case.bearing.bearing_type.washers:
        unconstrained = _pushed_apart(placed[0].row, free, load)
    oil = case.lubricant
    coefficient = 0.0 if oil is None else oil.friction_coefficient or 0.0
    friction = arrays.get("lubricant.friction_coefficient", coefficient)
    drag = arrays.get("model.cage_drag", case.model.cage_drag)
    found = Cases(
        case=case,
        varied={name: np.broadcast_to(array, (cases,)) for name, array in given.items()},
        rows=tuple(placed),
        free=free,
        load=load,
        displacement=displacement,
        preload=kind,
        preload_value=amount,
        valid=valid,
        unconstrained=unconstrained,
        traction=Traction(np.full(cases, friction), np.full(cases, drag), case.model.mesh),
    )
    if found.alone is not None:
        found.alone.asked(free, load, displacement)
    return found


def _pushed_apart(row: Row, free: BoolArray, load: FloatArray) -> BoolArray:
    """Cases whose washers are pushed apart, or pushed together by nothing; (cases,).

    Every contact of a thrust bearing pushes toward -x. Only where nothing else acts, at rest, may
    the axial load be zero.
    """
    acts = (load[:, 1:] != 0.0).any(axis=1)
    if isinstance(row, Driven):
        acts = acts | row.driven
    return np.asarray(free[:, 0] & ((load[:, 0] < 0.0) | ((load[:, 0] == 0.0) & acts)))


def _duty(
    case: Case, arrays: Mapping[str, FloatArray], cases: int
) -> tuple[BoolArray, FloatArray, FloatArray]:
    """Which degrees of freedom are free, the loads and the displacements; (cases, 5) each.

    The cases of an axis stand together, as the kernels have them.
    """
    duty = case.duty
    free = np.repeat(np.array(duty.free), cases).reshape(5, cases).T
    own = np.concatenate([duty.applied_load, duty.imposed_displacement])
    load, displacement = np.repeat(own, cases).reshape(2, 5, cases).transpose(0, 2, 1)
    for i, (axis, name) in enumerate(zip(AXES, LOADS, strict=True)):
        if (given := arrays.get(f"duty.load.{name}")) is not None:
            free[:, i], load[:, i], displacement[:, i] = True, given, 0.0
        if (given := arrays.get(f"duty.displacement.{axis}")) is not None:
            free[:, i], load[:, i], displacement[:, i] = False, 0.0, given
    return free, load, displacement


def _preload(
    bearing: RollingBearing, arrays: Mapping[str, FloatArray], cases: int
) -> tuple[str, FloatArray]:
    """How the rows press on each other, and how much; (cases,)."""
    signs = {place.sign for place in bearing.places}
    for name in _PRELOADS:
        given = arrays.get(f"bearing.preload.{name}")
        if given is None:
            continue
        if len(signs) < 2:
            raise InputError(
                said("needs opposed rows"),
                field=f"bearing.preload.{name}",
                example='arrangement = "DB"',
            )
        return name, np.broadcast_to(given, cases).astype(np.float64)
    if bearing.preload is None:
        return "", np.zeros(cases)
    pair_force = bearing.preload.pair_force(bearing.contact_angle)
    if pair_force is not None:
        return "pair", np.full(cases, pair_force)
    kind = next(name for name in _PRELOADS if getattr(bearing.preload, name) is not None)
    return kind, np.full(cases, getattr(bearing.preload, kind))


def _check_own_fields(case: Case, arrays: Mapping[str, FloatArray]) -> None:
    """Refuse to vary what the case, or a bearing of its kind, does not have.

    Raises
    ------
    InputError
        Naming the field.
    """
    bearing = case.bearing
    known = type(bearing).model_fields
    for name in arrays:
        table, _, leaf = name.partition(".")
        if table == "bearing" and leaf.partition(".")[0] not in known:
            raise InputError(
                said("is no quantity of such a bearing: {element}", element=bearing.element),
                field=name,
                example="bearing.pitch_diameter",
            )
        if table == "bearing" and bearing.is_of_rows(leaf.partition(".")[0]):
            raise InputError(
                said("has no effect: every row has its own"), field=name, example="duty.load.fz"
            )
    of = bearing.bearing_type
    none_such = marked("is no quantity of such a bearing: {element}")
    for name, refused, rule, example in (
        (
            "bearing.contact_angle",
            of.has_rollers and not (of.conical or of.inclined),
            none_such,
            "bearing.pitch_diameter",
        ),
        (
            "bearing.roller_half_angle",
            of.has_rollers and not of.conical,
            none_such,
            "bearing.pitch_diameter",
        ),
        ("bearing.diametral_clearance", of.conical, none_such, "bearing.pitch_diameter"),
        (
            "bearing.diametral_clearance",
            of.washers,
            marked("is not a quantity of a thrust bearing"),
            "bearing.contact_angle",
        ),
        (
            "bearing.shim_angle",
            not of.has_arches,
            marked("is of four-point bearings only"),
            'kind = "four_point"',
        ),
        (
            "bearing.outer_conformity",
            of.aligns,
            marked("is not given of a self-aligning bearing: its outer race is a sphere"),
            "bearing.inner_conformity",
        ),
        (
            "bearing.spacing",
            bearing.spacing is None,
            marked("applies to an arrangement, and this bearing has none"),
            'arrangement = "DB"',
        ),
        (
            "lubricant.friction_coefficient",
            case.lubricant is None,
            marked("is a property of a lubricant, and this case has none"),
            'lubricant = "ISO VG 68"',
        ),
    ):
        if refused and name in arrays:
            raise InputError(said(rule, element=bearing.element), field=name, example=example)
