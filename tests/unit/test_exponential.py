"""The exponential of a small matrix, beside SciPy's."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm

from rolamento import InputError
from rolamento.numerics.exponential import exponential


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("scale", [1e-6, 1.0, 30.0])
def test_it_is_scipys(seed: int, scale: float) -> None:
    rng = np.random.default_rng(seed)
    matrix = scale * (rng.normal(size=(6, 6)) - 3.0 * np.eye(6))
    exact = expm(matrix)
    np.testing.assert_allclose(exponential(matrix), exact, atol=1e-11 * np.abs(exact).max())


def test_a_stiff_network_decays() -> None:
    """Rates from 1e-4 to 1e3 over an hour: nothing grows, and the slowest is exact."""
    rates = np.array([1e-4, 0.1, 1e3])
    found = exponential(np.diag(-3600.0 * rates))
    np.testing.assert_allclose(np.diag(found), np.exp(-3600.0 * rates), atol=1e-9)
    assert np.count_nonzero(found - np.diag(np.diag(found))) == 0


def test_what_is_no_number_is_refused() -> None:
    with pytest.raises(InputError, match="finite"):
        exponential(np.array([[np.nan]]))
    assert exponential(np.zeros((3, 3))).tolist() == np.eye(3).tolist()
