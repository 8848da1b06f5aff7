"""The small linear solver of the kernels."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.numerics.dense import solve_dense


@pytest.mark.parametrize("n", [1, 2, 5, 8])
def test_agrees_with_lapack(n: int) -> None:
    rng = np.random.default_rng(n)
    for _ in range(20):
        a, b = rng.normal(size=(n, n)), rng.normal(size=n)
        a[0, 0] = 0.0 if n > 1 else a[0, 0]  # needs a row exchange
        x = b.copy()
        assert solve_dense(a.copy(), x)
        np.testing.assert_allclose(x, np.linalg.solve(a, b), rtol=1e-8, atol=1e-10)


@pytest.mark.parametrize(
    "matrix",
    [np.zeros((3, 3)), np.ones((3, 3)), np.full((2, 2), np.nan), np.array([[1.0, 2], [2, 4]])],
    ids=["zero", "rank one", "nan", "dependent"],
)
def test_says_so_when_singular(matrix: np.ndarray) -> None:
    assert not solve_dense(matrix.copy(), np.ones(len(matrix)))
