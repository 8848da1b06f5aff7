"""The inner ring in the report: displacement, load, stiffness."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite, nan
from typing import Final

import numpy as np
from rich.text import Text

from rolamento.case.arrangement import Preload
from rolamento.case.bearing import Bearing, RowPlace
from rolamento.case.duty import AXES, LOADS, Duty
from rolamento.numerics import FloatArray
from rolamento.report.numbers import ABSENT, aligned
from rolamento.report.page import Lines, Page
from rolamento.solved import Preloading, Solved

_SHIFTS: Final = 3
"""x, y, z come before the tilts."""

_NEGLIGIBLE: Final = 1e-9
"""Of the stiffnesses on the diagonal: what is less is rounding, and written 0."""


def ring_part(page: Page, solved: Solved) -> Lines:
    """Show displacement and load of the five degrees of freedom, the results in bold."""
    moved, load_values = solved.displacement.array[0].tolist(), solved.load.array[0].tolist()
    shifts = [1e6 * value for value in moved[:_SHIFTS]]
    tilts = [1e3 * value for value in moved[_SHIFTS:]]
    displacements = page.digits.column(shifts, most=3) + page.digits.column(tilts)
    forces, moments = load_values[:_SHIFTS], load_values[_SHIFTS:]
    loads = page.digits.column(forces, most=3) + page.digits.column(moments)
    rows = []
    for position, (axis, load) in enumerate(zip(AXES, LOADS, strict=True)):
        known, load_known = _known(page, solved.case.duty, axis, load)
        units = ("µm", "N") if position < _SHIFTS else ("mrad", "N·m")
        rows.append(
            (
                Text(axis),
                page.text(displacements[position], "bold" if load_known else ""),
                page.text(units[0]),
                Text(f" {load}"),
                page.text(loads[position], "" if load_known else "bold"),
                page.text(units[1]),
                page.text(f" {known}", "dim"),
            )
        )
    return [page.heading(page.words.inner_ring), *page.columns(rows, "lrllrll", gap=1)]


def _known(page: Page, duty: Duty, axis: str, load: str) -> tuple[str, bool]:
    """Say what was known of a degree of freedom, and whether that was its load."""
    words = page.words
    if getattr(duty.load, load) is not None:
        return words.given.format(name=load), True
    if getattr(duty.displacement, axis) is not None:
        return words.given.format(name=axis), False
    held = axis in ("ry", "rz")
    return (words.held if held else words.free), not held


def stiffness_part(page: Page, solved: Solved) -> Lines:
    """Show the 5 x 5 matrix in four blocks of one unit each."""
    columns = _columns(page, solved.stiffness.array[0].tolist())
    rows = [
        [Text(), *map(Text, AXES)],
        _units(page, "N/µm", "N/mrad"),
        *(_row(page, columns, row) for row in range(_SHIFTS)),
        _units(page, "N·m/mm", "N·m/mrad"),
        *(_row(page, columns, row) for row in range(_SHIFTS, len(AXES))),
    ]
    return [page.heading(page.words.stiffness), *page.columns(rows, "lrrrrr", gap=3)]


def _units(page: Page, shift: str, tilt: str) -> list[Text]:
    """Return the line of units above the rows of forces or of moments."""
    units = [shift] * _SHIFTS + [tilt] * (len(AXES) - _SHIFTS)
    return [Text(), *(page.text(unit, "dim") for unit in units)]


def _row(page: Page, columns: list[list[str]], row: int) -> list[Text]:
    """Return the stiffnesses of one load, that on the diagonal in bold."""
    styles = ("bold" if column == row else "" for column in range(len(AXES)))
    texts = (column[row] for column in columns)
    return [Text(LOADS[row]), *map(page.text, texts, styles)]


def _columns(page: Page, matrix: list[list[float]]) -> list[list[str]]:
    """Write the matrix column by column, forces and moments each with their decimals."""
    written = []
    for column in range(len(AXES)):
        values = [_in_unit(matrix, row, column) for row in range(len(AXES))]
        cells = page.digits.column(values[:_SHIFTS], most=3)
        cells += page.digits.column(values[_SHIFTS:], most=3)
        written.append(aligned(cells, page.words.decimal_mark))
    return written


def _in_unit(matrix: list[list[float]], row: int, column: int) -> float:
    """Return N/µm, N/mrad, N·m/mm or N·m/mrad, and rounding errors as zero."""
    value = matrix[row][column]
    if value * value <= _NEGLIGIBLE**2 * abs(matrix[row][row] * matrix[column][column]):
        return 0.0
    return value * (1e-6 if row < _SHIFTS and column < _SHIFTS else 1e-3)


_PLUS: Final = "+"
_MINUS: Final = "−"
_BOTH: Final = "±"
_FORCES: Final = 3
"""fx, fy, fz come before the moments."""


def facing(bearing: Bearing, place: RowPlace) -> str:
    """Tell toward which side a row carries axial load: with clearance and no preload, both."""
    if place.bearing.contact_angle is None and bearing.preload is None:
        return _BOTH
    return _PLUS if place.sign > 0.0 else _MINUS


def arrangement_lines(page: Page, bearing: Bearing) -> list[str]:
    """Say how the rows of a set are arranged and preloaded; nothing of a plain bearing."""
    if not bearing.is_set:
        return []
    preload = _preload(page, bearing.preload, bearing.contact_angle)
    return [_arrangement(page, bearing), *preload]


def _arrangement(page: Page, bearing: Bearing) -> str:
    words, places = page.words, bearing.places
    if bearing.arrangement is not None:
        return words.arrangement.format(
            name=bearing.arrangement,
            kind=words.arrangement_kinds[_kind(bearing.arrangement)],
            faces=" ".join(facing(bearing, place) for place in places),
            spacing=page.quantity(bearing.spacing or 0.0, "length"),
        )
    rows = ", ".join(_place(page, bearing, place) for place in places)
    return (words.one_row if len(places) == 1 else words.row_list).format(
        count=len(places), rows=rows
    )


def _kind(arrangement: str) -> str:
    """The letter that tells back to back, face to face or all in tandem."""
    return next((letter for letter in "BF" if letter in arrangement), "T")


def _place(page: Page, bearing: Bearing, place: RowPlace) -> str:
    """One row of a list: its side, its place, and what it has of its own."""
    words, own = page.words, []
    row = place.bearing
    if row.ball_count != bearing.ball_count:
        own.append(words.row_balls.format(count=row.ball_count))
    for name, symbol in (("ball_diameter", "D"), ("pitch_diameter", "d_m")):
        if getattr(row, name) != getattr(bearing, name):
            own.append(f"{symbol} {page.quantity(getattr(row, name), 'length')}")
    if row.contact_angle is not None and row.contact_angle != bearing.contact_angle:
        own.append(f"α {page.quantity(row.contact_angle, 'angle')}")
    for name, symbol in (("inner_conformity", "f_i"), ("outer_conformity", "f_o")):
        if getattr(row, name) != getattr(bearing, name):
            own.append(f"{symbol} {page.digits.short(getattr(row, name))}")
    if place.phase != 0.0:
        own.append(words.row_phase.format(angle=page.quantity(place.phase, "angle")))
    where = words.row_place.format(
        face=facing(bearing, place), position=page.quantity(place.position, "length")
    )
    return where + (f" ({'; '.join(own)})" if own else "")


def _preload(page: Page, preload: Preload | None, contact_angle: float | None) -> list[str]:
    words = page.words
    if preload is None:
        return []
    if preload.level is not None:
        force = page.quantity(preload.pair_force(contact_angle) or nan, "force")
        level = words.preload_levels[preload.level]
        return [
            words.preload_level.format(level=level, name=preload.designation or "", force=force)
        ]
    if preload.offset is not None:
        offset = f"{page.digits.short(1e6 * preload.offset)} µm"  # as displacements are
        return [words.preload_offset.format(offset=offset)]
    if preload.spring is not None:
        return [words.preload_spring.format(force=page.quantity(preload.spring, "force"))]
    return [words.preload_force.format(force=page.quantity(preload.force or 0.0, "force"))]


def rows_part(page: Page, solved: Solved) -> Lines:
    """Show a line for each row: its place, what it takes, its loaded balls, its peaks."""
    words, rows = page.words, solved.rows
    numbers = _rows_column(page, "", words.row_heading, [str(row) for row in range(len(rows))])
    bearing = solved.case.bearing
    faces = [facing(bearing, place) for place in bearing.places]
    positions = page.digits.column((1e3 * rows.position[0]).tolist(), most=2)
    place = [
        numbers,
        _rows_column(page, "", words.faces, faces),
        _rows_column(page, "x", "mm", positions),
    ]
    taken, peaks = _taken(page, rows.load[0]), _peaks(page, solved)
    whole = [*place, *taken, *peaks]
    both = words.both_ways if _BOTH in faces else ""
    legend = page.hanging(Text("  "), words.rows_legend.format(both=both), "dim")
    if page.width_of(whole) <= page.medium.width:
        return [page.heading(words.rows), *page.table(whole), *legend]
    parts = [*page.table([*place, *peaks]), Text(), *page.table([numbers, *taken])]
    return [page.heading(words.rows), *parts, *legend]


def _rows_column(page: Page, symbol: str, below: str, cells: Sequence[str]) -> Lines:
    """Return two lines of header, symbol and unit, or a word on the second; then the cells."""
    texts = [page.text(cell, "dim" if cell == ABSENT else "") for cell in cells]
    return [page.text(symbol), page.text(below, "dim" if symbol else ""), *texts]


def _taken(page: Page, loads: FloatArray) -> list[Lines]:
    """The forces and moments of each row, all forces and all moments with the same decimals."""
    columns = []
    for first, end, unit in ((0, _FORCES, "N"), (_FORCES, len(LOADS), "N·m")):
        width = end - first
        cells = page.digits.column(loads[:, first:end].ravel().tolist(), digits=4, most=2)
        for index in range(width):
            columns.append(_rows_column(page, LOADS[first + index], unit, cells[index::width]))
    return columns


def _peaks(page: Page, solved: Solved) -> list[Lines]:
    """Loaded balls of each row, and the maxima of load and pressure at its inner race."""
    loaded = zip(solved.loaded_elements[0], solved.rows.element_count, strict=True)
    counts = [f"{some}/{count}" for some, count in loaded]
    loads = _maximum_by_row(solved, solved.inner.load[0])
    pressures = _maximum_by_row(solved, 1e-6 * solved.inner.max_pressure[0])
    return [
        _rows_column(page, "", page.words.loaded, counts),
        _rows_column(page, "Q_i", "N", page.digits.column(loads, digits=4, most=1)),
        _rows_column(page, "p_i", "MPa", page.digits.column(pressures, digits=4, most=1)),
    ]


def _maximum_by_row(solved: Solved, values: FloatArray) -> list[float]:
    """At the inner contacts that are loaded; NaN without any."""
    loaded = np.where(solved.inner.load[0] > 0.0, values, np.nan)
    return np.fmax.reduceat(loaded, solved.rows.starts).tolist()


def preload_part(page: Page, solved: Solved, preload: Preloading) -> Lines:
    """Show the preload at rest and at speed, and where it is lost."""
    words, duty = page.words, solved.case.duty
    entries = [(words.preload_at_rest, _force(page, preload.at_rest), "")]
    if duty.inner_speed or duty.outer_speed:
        entries.append((words.preload_at_speed, _force(page, preload.at_speed), ""))
    entries += _lift(page, duty, preload)
    entries += _loss(page, solved, preload)
    return [page.heading(words.preload), *page.labelled(entries, indent="  ", style="")]


def _lift(page: Page, duty: Duty, preload: Preloading) -> list[tuple[str, str, str]]:
    """Where the first ball lifts off, unless it takes its row along."""
    if preload.lift_row is None or preload.lift_factor == preload.loss_factor:
        return []
    words, gone = page.words, preload.lift_factor < 1.0
    text = (words.ball_has_lifted_off if gone else words.ball_lifts_off).format(
        row=preload.lift_row,
        factor=page.digits.short(preload.lift_factor, 3),
        load=_resulting_load(page, duty, preload.lift_factor),
    )
    return [(words.preload_lift, text, "yellow" if gone else "")]


def _loss(page: Page, solved: Solved, preload: Preloading) -> list[tuple[str, str, str]]:
    """Where a row lifts off, as a multiple of the load and as that load."""
    words, row, duty = page.words, preload.lost_row, solved.case.duty
    label = words.preload_loss
    lost = [str(other) for other in np.flatnonzero(solved.loaded_elements[0] == 0)]
    if row is None or not isfinite(preload.loss_factor):
        if lost:
            return [(label, words.nothing_left.format(rows=", ".join(lost)), "bold yellow")]
        loaded = any(getattr(duty.load, name) for name in LOADS)
        return [(label, words.no_loss, "")] if loaded else []
    gone = preload.loss_factor < 1.0 or str(row) in lost
    text = (words.has_lifted_off if gone else words.lifts_off).format(
        row=row,
        factor=page.digits.short(preload.loss_factor, 3),
        load=_resulting_load(page, duty, preload.loss_factor),
    )
    return [(label, text, "bold yellow" if gone else "")]


def _resulting_load(page: Page, duty: Duty, factor: float) -> str:
    """The external load, times a factor."""
    parts = []
    for name in LOADS:
        value = getattr(duty.load, name)
        if value:
            unit = "N" if name.startswith("f") else "N·m"
            parts.append(f"{name} {page.digits.short(factor * value, 4)} {unit}")
    return ", ".join(parts)


def _force(page: Page, force: float) -> str:
    return f"{page.digits.short(force, 4)} N"
