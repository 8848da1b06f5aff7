"""A small system of linear equations in every lane, by Gauss's elimination."""

from __future__ import annotations

from typing import Any

import numpy as np

from rolamento.numerics.compiled import inline_fast
from rolamento.rows.ball.layout import lanes
from rolamento.rows.ball.types import Array


def elimination(size: int, line: int, matrix: int, right: int) -> Any:
    """Build the solution of so many equations in a lane of a workspace.

    matrix, right: the rows where the matrix begins, each of its lines `line` rows long, and where
    the right side does, which becomes the solution. As the size is known, the loops are written out
    and all numbers stay in registers. No pivot is nearer to zero than `least`.
    """
    n, line_rows, one = np.uintp(size), np.uintp(line), np.uintp(1)
    row_length, a, x = lanes(1), lanes(matrix), lanes(right)

    @inline_fast
    def entry(row: Any, column: Any, i: int) -> Any:
        return a + (row * line_rows + column) * row_length + i

    @inline_fast
    def solve(w: Array, i: int, least: float) -> None:
        for pivot in range(n):
            stiffness = w[entry(pivot, pivot, i)]
            inverse = 1.0 / (least if abs(stiffness) < least else stiffness)
            w[entry(pivot, pivot, i)] = inverse
            for row in range(pivot + one, n):
                part = w[entry(row, pivot, i)] * inverse
                for column in range(pivot + one, n):
                    w[entry(row, column, i)] -= part * w[entry(pivot, column, i)]
                w[x + row * row_length + i] -= part * w[x + pivot * row_length + i]
        for back in range(n):
            up = n - one - back
            rest = w[x + up * row_length + i]
            for column in range(up + one, n):
                rest -= w[entry(up, column, i)] * w[x + column * row_length + i]
            w[x + up * row_length + i] = rest * w[entry(up, up, i)]

    return solve
