"""Small dense linear systems inside kernels, where calling LAPACK would cost more than solving."""

from __future__ import annotations

from rolamento.numerics import FloatArray as Array
from rolamento.numerics.compiled import shared


@shared
def solve_dense(a: Array, b: Array) -> bool:
    """Solve a x = b in place by elimination with partial pivoting; x replaces b, a is destroyed.

    a: (n, n), b: (n,). Returns False where a is singular to working precision or not finite.
    """
    n = b.size
    greatest = 0.0
    for i in range(n):
        for j in range(n):
            greatest = max(greatest, abs(a[i, j]))
    for k in range(n):
        pivot = k
        for i in range(k + 1, n):
            if abs(a[i, k]) > abs(a[pivot, k]):
                pivot = i
        if not abs(a[pivot, k]) > 1e-15 * greatest:
            return False
        if pivot != k:
            b[k], b[pivot] = b[pivot], b[k]
            for j in range(n):
                a[k, j], a[pivot, j] = a[pivot, j], a[k, j]
        for i in range(k + 1, n):
            factor = a[i, k] / a[k, k]
            b[i] -= factor * b[k]
            for j in range(k, n):
                a[i, j] -= factor * a[k, j]
    for i in range(n - 1, -1, -1):
        for j in range(i + 1, n):
            b[i] -= a[i, j] * b[j]
        b[i] /= a[i, i]
    return True
