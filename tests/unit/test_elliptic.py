"""Elliptic integrals against SciPy's and against their own identities."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
from scipy import special

from rolamento.numerics.elliptic import associate, carlson_rf_rd, complete

COMPLEMENTS = np.concatenate([10.0 ** np.linspace(-25.0, 0.0, 200), [0.5, 1.0 - 1e-12]])


def test_complete_integrals_agree_with_scipy() -> None:
    k, e = complete(COMPLEMENTS)
    np.testing.assert_allclose(k, special.ellipkm1(COMPLEMENTS), rtol=5e-15)
    np.testing.assert_allclose(e, special.ellipe(1.0 - COMPLEMENTS), rtol=2e-14)


def test_small_complement_is_not_lost() -> None:
    """K ≈ ln 4 - ½ ln(1 - m), where passing m itself would give infinity."""
    k, e = complete(1e-40)
    assert k == pytest.approx(np.log(4.0) + 20.0 * np.log(10.0), rel=1e-15)
    assert e == pytest.approx(1.0, rel=1e-14)


def test_complete_integrals_at_the_ends() -> None:
    assert complete(1.0) == pytest.approx((0.5 * np.pi, 0.5 * np.pi), rel=1e-15)
    k, e = complete(0.0)
    assert np.isinf(k)
    assert e == 1.0


def test_associate_integrals_agree_with_carlson_forms() -> None:
    """DLMF 19.25: D = R_D(0, 1-m, 1)/3 and B = (1-m) R_D(0, 1, 1-m)/3."""
    b, d = associate(COMPLEMENTS)
    np.testing.assert_allclose(d, special.elliprd(0.0, COMPLEMENTS, 1.0) / 3.0, rtol=5e-15)
    reference = COMPLEMENTS * special.elliprd(0.0, 1.0, COMPLEMENTS) / 3.0
    np.testing.assert_allclose(b, reference, rtol=2e-14)


def test_legendre_relation() -> None:
    m = np.linspace(0.01, 0.99, 50)
    (k, e), (k1, e1) = complete(1.0 - m), complete(m)
    np.testing.assert_allclose(e * k1 + e1 * k - k * k1, 0.5 * np.pi, rtol=3e-15)


def test_outside_the_range_is_nan() -> None:
    for value in complete([-0.1, 1.1, np.nan]):
        assert np.all(np.isnan(value))


def test_carlson_forms_agree_with_scipy() -> None:
    ends = 10.0 ** np.linspace(-16.0, 0.0, 60)
    x, y = np.concatenate([[0.0], ends])[:, np.newaxis], ends
    first, second = carlson_rf_rd(x, y)
    np.testing.assert_allclose(first, special.elliprf(x, y, 1.0), rtol=3e-15)
    np.testing.assert_allclose(second, special.elliprd(x, y, 1.0), rtol=5e-15)
    assert carlson_rf_rd(0.25, 0.5) == pytest.approx(
        (special.elliprf(0.25, 0.5, 1.0), special.elliprd(0.25, 0.5, 1.0)), rel=1e-15
    )


def test_shapes_broadcast() -> None:
    assert carlson_rf_rd(np.ones((3, 1)), np.ones(4))[1].shape == (3, 4)
    assert np.shape(complete(np.full((2, 5), 0.5))[0]) == (2, 5)


def test_the_mechanics_do_not_import_scipy() -> None:
    """Starting the program must not pay for scipy.special."""
    modules = "rolamento.static, rolamento.kinematics, rolamento.contact.subsurface"
    code = f"import sys, {modules}; sys.exit('scipy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
