"""The inner ring in the report: displacement, load, stiffness."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from rich.console import Group, RenderableType
from rich.table import Table

from rolamento.duty import AXES, LOADS, Duty
from rolamento.report.numbers import aligned
from rolamento.report.page import Page
from rolamento.state import State

__all__ = ["ring_part", "stiffness_part"]

_SHIFTS: Final = 3
"""x, y, z come before the tilts."""

_NEGLIGIBLE: Final = 1e-9
"""Of the stiffnesses on the diagonal: what is less is rounding, and written 0."""


def ring_part(page: Page, state: State) -> RenderableType:
    """Show displacement and load of the five degrees of freedom, the results in bold."""
    shifts = [1e6 * value for value in state.displacement[:_SHIFTS]]
    tilts = [1e3 * value for value in state.displacement[_SHIFTS:]]
    displacements = _two_groups(page, shifts, tilts)
    loads = _two_groups(page, state.load[:_SHIFTS], state.load[_SHIFTS:])
    grid = page.grid(gap=1)
    for justify in ("left", "right", "left", "left", "right", "left", "left"):
        grid.add_column(justify=justify, no_wrap=True)
    for position, (axis, load) in enumerate(zip(AXES, LOADS, strict=True)):
        shift = position < _SHIFTS
        known, load_known = _known(page, state.case.duty, axis, load)
        grid.add_row(
            page.text(f"  {axis}"),
            page.text(displacements[position], "" if not load_known else "bold"),
            page.text("µm " if shift else "mrad "),
            page.text(load),
            page.text(loads[position], "" if load_known else "bold"),
            page.text("N " if shift else "N·m "),
            page.text(known, "dim"),
        )
    return Group(page.heading(page.words.inner_ring), grid)


def _two_groups(page: Page, first: Sequence[float], second: Sequence[float]) -> list[str]:
    """Write shifts and tilts, or forces and moments, each with their own decimals."""
    cells = page.digits.column(first, most=3) + page.digits.column(second)
    return aligned(cells, page.words.decimal_mark)


def _known(page: Page, duty: Duty, axis: str, load: str) -> tuple[str, bool]:
    """Say what was known of a degree of freedom, and whether that was its load."""
    words = page.words
    if getattr(duty.load, load) is not None:
        return words.given.format(name=load), True
    if getattr(duty.displacement, axis) is not None:
        return words.given.format(name=axis), False
    held = axis in ("ry", "rz")
    return (words.held if held else words.free), not held


def stiffness_part(page: Page, state: State) -> RenderableType:
    """Show the 5 x 5 matrix in four blocks of one unit each."""
    matrix = state.stiffness.tolist()
    grid = page.grid(gap=3)
    grid.add_column(no_wrap=True)
    for _ in AXES:
        grid.add_column(justify="right", no_wrap=True)
    grid.add_row("", *(page.text(axis) for axis in AXES))
    columns = _columns(page, matrix)
    _add_rows(page, grid, columns, range(_SHIFTS), ("N/µm", "N/mrad"))
    _add_rows(page, grid, columns, range(_SHIFTS, len(AXES)), ("N·m/mm", "N·m/mrad"))
    return Group(page.heading(page.words.stiffness), grid)


def _add_rows(
    page: Page, grid: Table, columns: list[list[str]], rows: range, units: tuple[str, str]
) -> None:
    """Add the rows of the forces or of the moments, below their units."""
    over = (units[0] if column < _SHIFTS else units[1] for column in range(len(AXES)))
    grid.add_row("", *(page.text(unit, "dim") for unit in over))
    for row in rows:
        cells = (
            page.text(columns[column][row], "bold" if row == column else "")
            for column in range(len(AXES))
        )
        grid.add_row(page.text(f"  {LOADS[row]}"), *cells)


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
