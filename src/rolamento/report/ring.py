"""The inner ring in the report: displacement, load, stiffness."""

from __future__ import annotations

from typing import Final

from rich.text import Text

from rolamento.case.duty import AXES, LOADS, Duty
from rolamento.report.numbers import aligned
from rolamento.report.page import Lines, Page
from rolamento.state import State

__all__ = ["ring_part", "stiffness_part"]

_SHIFTS: Final = 3
"""x, y, z come before the tilts."""

_NEGLIGIBLE: Final = 1e-9
"""Of the stiffnesses on the diagonal: what is less is rounding, and written 0."""


def ring_part(page: Page, state: State) -> Lines:
    """Show displacement and load of the five degrees of freedom, the results in bold."""
    shifts = [1e6 * value for value in state.displacement[:_SHIFTS]]
    tilts = [1e3 * value for value in state.displacement[_SHIFTS:]]
    displacements = page.digits.column(shifts, most=3) + page.digits.column(tilts)
    forces, moments = state.load[:_SHIFTS], state.load[_SHIFTS:]
    loads = page.digits.column(forces, most=3) + page.digits.column(moments)
    rows = []
    for position, (axis, load) in enumerate(zip(AXES, LOADS, strict=True)):
        known, load_known = _known(page, state.case.duty, axis, load)
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


def stiffness_part(page: Page, state: State) -> Lines:
    """Show the 5 x 5 matrix in four blocks of one unit each."""
    columns = _columns(page, state.stiffness.tolist())
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
