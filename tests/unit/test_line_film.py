"""Films of line contacts: the formulas, their regime, and what the groups are made of."""

from __future__ import annotations

from math import inf, isinf, isnan

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from rolamento.errors import InputError
from rolamento.lubrication.film_thickness import FilmGroups
from rolamento.lubrication.line_film import (
    MARTIN,
    dowson_minimum,
    dowson_toyoda_central,
    line_film,
    line_groups,
    pan_hamrock_central,
    pan_hamrock_minimum,
    rigid_film,
)

FORMULAS = {
    pan_hamrock_central: (2.922, 0.692, 0.470, -0.166),
    pan_hamrock_minimum: (1.714, 0.694, 0.568, -0.128),
    dowson_toyoda_central: (3.06, 0.69, 0.56, -0.10),
    dowson_minimum: (2.65, 0.70, 0.54, -0.13),
}
ROLLER = {
    "entrainment_speed": 5.0, "load_per_length": 2e5, "rolling_curvature": 1 / 4.1e-3,
    "modulus": 2.26e11, "viscosity": 0.02, "pressure_viscosity_coefficient": 2e-8,
}  # fmt: skip
"""A NU 210 at 3000 r/min, at a well-loaded roller."""


def groups(speed: float, load: float, material: float) -> FilmGroups:
    return FilmGroups(*(np.asarray(part) for part in (speed, load, material, inf)))


@pytest.mark.parametrize("formula", FORMULAS)
def test_factor_and_exponents(formula: object) -> None:
    factor, speed, material, load = FORMULAS[formula]  # type: ignore[index]
    assert callable(formula)
    assert formula(groups(1.0, 1.0, 1.0)) == pytest.approx(factor)
    assert formula(groups(2.0, 1.0, 1.0)) == pytest.approx(factor * 2**speed)
    assert formula(groups(1.0, 2.0, 1.0)) == pytest.approx(factor * 2**load)
    assert formula(groups(1.0, 1.0, 2.0)) == pytest.approx(factor * 2**material)
    assert isnan(formula(groups(1.0, 0.0, 1.0)))
    assert formula(groups(0.0, 1.0, 1.0)) == 0.0


def test_groups_of_a_roller() -> None:
    found = line_groups(**ROLLER)
    assert found.speed == pytest.approx(0.02 * 5.0 / (2.26e11 * 4.1e-3))
    assert found.load == pytest.approx(2e5 / (2.26e11 * 4.1e-3))
    assert found.material == pytest.approx(2e-8 * 2.26e11)
    assert isinf(found.ellipticity)
    assert isnan(line_groups(**{**ROLLER, "load_per_length": np.nan}).ellipticity)
    with pytest.raises(InputError, match="load_per_length"):
        line_groups(**{**ROLLER, "load_per_length": -1.0})


def test_films_rank_and_agree_on_a_roller() -> None:
    """Two independent fits: minima within 10 %, centres within 30 % of each other."""
    found = line_groups(**ROLLER)
    for formula in ("pan_hamrock", "dowson_toyoda"):
        central, minimum = line_film(found, formula)  # type: ignore[arg-type]
        assert 0.7 < minimum / central < 0.95
    assert 0.7 < pan_hamrock_central(found) / dowson_toyoda_central(found) < 1.0
    assert 0.9 < pan_hamrock_minimum(found) / dowson_minimum(found) < 1.1
    assert pan_hamrock_minimum(found) > rigid_film(found)


def test_martins_constant_from_reynolds() -> None:
    """dp/dx = 12 η u (h - h*)/h³ under a parabola, p = dp/dx = 0 at the outlet."""

    def gradient(s: float, c: float) -> float:
        return (s * s - c * c) / (1.0 + s * s) ** 3

    def pressure(s: float, c: float) -> float:
        return float(quad(gradient, -np.inf, s, args=(c,))[0])

    c = brentq(lambda trial: pressure(trial, trial), 0.3, 0.7)
    assert c == pytest.approx(0.4751, abs=1e-4)
    # w = ∫ p dx = -∫ x dp/dx dx, in x = √(2 R h0) s
    load = -quad(lambda s: s * gradient(s, c), -np.inf, c)[0]
    assert 24.0 * load == pytest.approx(MARTIN, rel=1e-3)


def test_lightly_loaded_contacts_leave_the_regime() -> None:
    light = line_groups(**{**ROLLER, "load_per_length": 20.0, "viscosity": 0.1})
    assert rigid_film(light) > pan_hamrock_minimum(light)
    assert isinf(rigid_film(line_groups(**{**ROLLER, "load_per_length": 0.0})))
