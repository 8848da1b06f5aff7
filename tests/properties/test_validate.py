"""Numbers outside what a formula takes are refused by name; no warning of NumPy reaches anybody."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from rolamento.errors import InputError
from rolamento.friction.slip import (
    BallVelocity,
    Patch,
    maximum_pressure_slip,
    relative_motion,
    rolling_lines,
    slip_velocity,
)
from rolamento.kinematics import surface_speeds
from rolamento.lubrication.film_thickness import (
    central_film,
    film_groups,
    flooded_distance_central,
    flooded_distance_minimum,
    gupta_cheng,
    inlet_distance_central,
    minimum_film,
    murch_wilson,
    replenishment,
    thermal_loading,
)
from rolamento.oil import (
    astm_d341,
    astm_d341_line,
    barus,
    density_by_expansion,
    density_of_lubricating_oil,
    dynamic_viscosity,
    roelands,
    so_klaus,
    viscosity_100_of_index,
    viscosity_index,
    wooster,
)
from rolamento.oil.state import viscosity_ratio
from rolamento.validate import within

numbers = st.one_of(
    st.floats(),
    st.sampled_from([0.0, -0.0, -1.0, 1.0, 1e-300, 1e300, -1e300, np.inf, -np.inf, np.nan]),
    st.floats(1e-12, 1e12),
)


def films(u: float, q: float, curvature: float, k: float, e: float, eta: float, a: float) -> None:
    groups = film_groups(u, q, curvature, k, e, eta, a)
    central_film(groups)
    minimum_film(groups)


def slips(load: float, x: float, y: float, z: float, ring: float) -> None:
    shape = (load, 0.5, 1e-3, 2e-4, 0.02, 0.1, 0.52)
    patch = Patch("inner", *(np.array(value) for value in shape))
    motion = relative_motion(patch, BallVelocity(np.array(x), np.array(y), np.array(z)), ring)
    assert slip_velocity(patch, motion, np.linspace(-1.0, 1.0, 5), np.zeros(5)).speed.shape == (5,)
    _ = motion.spin_to_roll
    rolling_lines(patch, motion)
    maximum_pressure_slip(patch, motion)


def lines(t1: float, t2: float, nu1: float, nu2: float, t: float) -> None:
    astm_d341(t, astm_d341_line(t1, nu1, t2, nu2))


FORMULAS: dict[str, tuple[int, Callable[..., Any]]] = {
    "film": (7, films),
    "slip": (5, slips),
    "thermal": (4, lambda *given: murch_wilson(thermal_loading(*given))),
    "gupta_cheng": (4, gupta_cheng),
    "flooded_central": (3, flooded_distance_central),
    "flooded_minimum": (3, flooded_distance_minimum),
    "inlet": (2, inlet_distance_central),
    "replenishment": (
        4,
        lambda nu, n, d, e: replenishment(nu, n, d, e, "bath", kind="deep_groove"),
    ),
    "viscosity_ratio": (3, viscosity_ratio),
    "entrainment": (8, lambda *given: surface_speeds("inner", *given).entrainment),
    "barus": (3, barus),
    "roelands": (3, roelands),
    "wooster": (1, wooster),
    "so_klaus": (3, so_klaus),
    "astm_d341": (5, lines),
    "dynamic_viscosity": (2, dynamic_viscosity),
    "density_by_expansion": (4, density_by_expansion),
    "density_of_lubricating_oil": (3, density_of_lubricating_oil),
    "viscosity_index": (2, viscosity_index),
    "viscosity_100_of_index": (2, viscosity_100_of_index),
}


@pytest.mark.parametrize("name", FORMULAS)
@given(st.data())
@pytest.mark.thirds
def test_every_number_is_taken_or_refused_by_name(name: str, data: st.DataObject) -> None:
    count, formula = FORMULAS[name]
    values = [data.draw(numbers) for _ in range(count)]
    try:
        formula(*values)
    except InputError as error:
        assert error.field
        assert "must" in str(error)


@given(numbers, st.booleans())
@example(1.0, True)
@example(2.0, False)
def test_what_is_within(value: float, open_start: bool) -> None:
    inside = np.isnan(value) or ((value > 1.0 if open_start else value >= 1.0) and value <= 2.0)
    if inside:
        found = within(value, "length", "m", 1.0, 2.0, least_too=not open_start)
        assert found == value or np.isnan(value)
        return
    with pytest.raises(InputError, match=re.escape("length")) as error:
        within([1.5, value], "length", "m", 1.0, 2.0, least_too=not open_start)
    least = "a number greater than 1 and at most" if open_start else "from 1 to"
    assert f"must be {least} 2 m" in str(error.value)
    assert error.value.value == value
