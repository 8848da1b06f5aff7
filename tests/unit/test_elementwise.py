"""Formulas of many numbers: one compiled loop gives what NumPy gives, to the last bit."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from dataclasses import astuple
from typing import Any

import numpy as np
import pytest

from rolamento import geometry
from rolamento.contact import hertz
from rolamento.geometry import Angle, race_curvature
from rolamento.kinematics import ball, ball_motion, surface_speeds
from rolamento.numerics import compiled, ellipse, elliptic
from rolamento.numerics.blocks import BLOCK, in_blocks
from rolamento.numerics.elementwise import MANY, of_each

RANDOM = np.random.default_rng(50)
LOOPS: tuple[tuple[Any, Any, int, int], ...] = (
    (elliptic.by_mean, elliptic._fill, 1, 2),
    (ellipse._start, ellipse._fill_start, 1, 1),
    (ellipse._followed, ellipse._fill_followed, 6, 4),
    (hertz._pressed, hertz._fill_pressed, 5, 5),
    (geometry._curvatures, geometry._fill_curvatures, 5, 2),
    (ball._turned, ball._fill_turned, 10, 7),
    (ball._orbit, ball._fill_orbit, 8, 1),
    (ball._surfaces, ball._fill_surfaces, 7, 2),
)


@pytest.fixture
def compiler() -> None:
    """A process that has the compiler, as after solving many cases."""
    compiled._numba()


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize(
    ("formula", "loop", "given", "count"), LOOPS, ids=[str(loop[0].__name__) for loop in LOOPS]
)
def test_a_loop_gives_what_numpy_gives(formula: Any, loop: Any, given: int, count: int) -> None:
    arrays = RANDOM.uniform(0.1, 0.9, (given, MANY))
    arrays[:, ::97] = np.nan
    arrays[:, 1::89] *= -1.0  # the other race, the other way round
    with np.errstate(invalid="ignore"):
        plain = formula(*arrays)
        found = of_each(formula, loop, count, *arrays)
    assert len(found) == count
    for one, other in zip(found, plain, strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.usefixtures("compiler")
def test_columns_and_numbers_stand_beside_arrays() -> None:
    q = RANDOM.uniform(1.0, 9.0, (MANY // 16, 16))
    column, number = RANDOM.uniform(1.0, 9.0, (MANY // 16, 1)), np.asarray(2.0)
    given = (q, column, number, number, column)
    found = of_each(hertz._pressed, hertz._fill_pressed, 5, *given)
    for one, other in zip(found, hertz._pressed(*given), strict=True):
        np.testing.assert_array_equal(one, np.broadcast_to(other, q.shape))


@pytest.mark.usefixtures("compiler")
@pytest.mark.parametrize(
    "function",
    [
        lambda x: elliptic.associate(x),
        lambda x: ellipse.ellipse_of_log_ratio(np.log(x)),
        lambda x: astuple(race_curvature(0.02, 0.1, 0.5 + x, x, "outer")),
        lambda x: astuple(surface_speeds("inner", 0.02, 0.1, x, 9.0, x, -x, x)),
    ],
    ids=["associate", "ellipse", "race_curvature", "surface_speeds"],
)
def test_many_cases_give_what_one_gives(function: Callable[[Any], Any]) -> None:
    x = RANDOM.uniform(0.001, 1.0, MANY)
    many, one = function(x), function(x[:5])
    for all_of_them, some in zip(many, one, strict=True):
        np.testing.assert_array_equal(all_of_them[:5], some)


def test_without_the_compiler_nothing_loads_it() -> None:
    code = (
        "import sys, numpy as np\n"
        "from rolamento.contact.hertz import elliptical_contact\n"
        "elliptical_contact(np.full(100_000, 9.0), 50.0, 10.0, 2e11)\n"
        "sys.exit('numba' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_choose_is_of_numbers_and_arrays() -> None:
    assert compiled.choose(True, 1.0, 2.0) == 1.0
    np.testing.assert_array_equal(compiled.choose(np.array([True, False]), 1.0, 2.0), [1.0, 2.0])


def test_an_angle_knows_its_cosine_and_sine() -> None:
    angle = Angle(np.arctan2(3.0, 4.0))
    assert (angle.cosine, angle.sine) == pytest.approx((0.8, 0.6))
    other = Angle.of(0.25)
    assert Angle.of(other) is other


def test_motion_takes_an_angle_for_its_numbers() -> None:
    inner, outer = RANDOM.uniform(0.2, 0.9, (2, 50))
    given = ball_motion(Angle.of(inner), Angle.of(outer), 0.18, 1.0)
    plain = ball_motion(inner, outer, 0.18, 1.0)
    np.testing.assert_array_equal(given.attitude, plain.attitude)
    np.testing.assert_array_equal(given.orbital_speed, plain.orbital_speed)


def test_the_mean_takes_more_steps_where_it_needs_them() -> None:
    one, both = elliptic.associate(np.array([0.3])), elliptic.associate(np.array([0.3, 1e-200]))
    assert both[1][0] == pytest.approx(one[1][0], rel=1e-15)
    slender = np.array([1e-6, 1e-16, 5e-324])  # D is K - 1, K is ln(4/√(1 - m)), DLMF 19.12.1
    assert elliptic.associate(slender)[1] == pytest.approx(
        np.log(4.0) - 0.5 * np.log(slender) - 1.0, rel=1e-6
    )


def test_nearly_round_ellipses_follow_the_circle() -> None:
    """Near k = 1, ln k = -⅔ ln ratio: the slopes of B and D keep their limits."""
    ratio = -(10.0 ** np.linspace(-15.0, -5.0, 60))
    k = ellipse.ellipse_of_log_ratio(ratio).ellipticity
    np.testing.assert_allclose(np.log(k), -ratio * 2.0 / 3.0, rtol=1e-5, atol=5e-16)


def test_what_stands_twice_in_a_result_is_put_together_once() -> None:
    def twice(some: np.ndarray[Any, Any]) -> dict[str, Any]:
        double = 2.0 * some
        return {"one": double, "same": (double,), "other": 2.0 * some}

    whole = in_blocks(twice, np.arange(2.0 * BLOCK + 7.0), 2)
    assert whole["one"] is whole["same"][0]
    assert whole["other"] is not whole["one"]
    np.testing.assert_array_equal(whole["one"], whole["other"])
