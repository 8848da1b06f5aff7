"""Half of the balls, where load and ring have a plane of symmetry: the same as all of them."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.case import Case
from rolamento.rows.ball import layout
from rolamento.rows.ball.mirror import AXES, mirror, planes
from rolamento.rows.ball.problem import directions
from rolamento.rows.ball.run import BallResponse, solve_columns
from rolamento.system import spread

CASES = 60
NEXT_TO_NOTHING = 1e-250
"""A load that changes no number, and yet is none that a mirror image leaves as it is."""


def solved(case: Case, duties: dict[str, np.ndarray]) -> BallResponse:
    p = spread(case, duties).rows[0].row.p
    balls = case.bearing.ball_count
    return solve_columns(p, np.ones((1, balls)), balls, threads=1)


def found_planes(case: Case, duties: dict[str, np.ndarray], control: np.ndarray) -> list[int]:
    return planes(spread(case, duties).rows[0].row.p, control).tolist()


@pytest.mark.parametrize("plane", AXES)
@pytest.mark.parametrize("balls", [4, 6, 15, 16])
def test_every_ball_is_seen_once(balls: int, plane: int) -> None:
    if plane % 2 == 0 and balls % 2:
        return
    half = mirror(balls, plane)
    images = half.seats[: half.pairs].ravel().tolist()
    alone = half.seats[half.pairs :]
    assert (alone[:, 0] == alone[:, 1]).all()
    assert sorted(images + alone[:, 0].tolist()) == list(range(balls))
    cosines, sines = directions(balls)
    if plane > 2:
        between = np.pi / balls * (2 * np.arange(balls) + 1)
        cosines, sines = np.cos(between), np.sin(between)
    own, image = half.seats.T
    turned, kept = (sines, cosines) if plane % 2 else (cosines, sines)
    np.testing.assert_allclose(turned[own], -turned[image], atol=0.0 if plane < 3 else 1e-15)
    np.testing.assert_allclose(kept[own], kept[image], atol=0.0 if plane < 3 else 1e-15)


@pytest.mark.parametrize("speed", [0.0, 1200.0], ids=["at rest", "at speed"])
@pytest.mark.parametrize("tilting", [False, True], ids=["held", "tilting"])
@pytest.mark.parametrize("plane", AXES, ids=["along z", "along y", "between, z", "between, y"])
def test_half_of_the_balls_is_all_of_them(
    plane: int, tilting: bool, speed: float, case_218: Case
) -> None:
    rng = np.random.default_rng(4)
    fx = rng.uniform(2e3, 4e4, CASES)
    force, moment, broken = ("fz", "my", "fy") if plane % 2 else ("fy", "mz", "fz")
    duties = {
        "fx": fx,
        force: fx * rng.uniform(-0.8, 0.8, CASES),
        broken: np.zeros(CASES),
        "inner_speed": np.full(CASES, speed),
        "first_ball_azimuth": np.full(CASES, np.radians(11.25) if plane > 2 else 0.0),
    }
    for tilt in ("ry", "rz"):
        duties[tilt] = np.zeros(CASES)
    if tilting:
        del duties["ry"], duties["rz"]
        duties |= {"my": np.zeros(CASES), "mz": np.zeros(CASES)}
        duties[moment] = 0.01 * fx * rng.uniform(-1.0, 1.0, CASES)
    whole = duties | {broken: np.full(CASES, NEXT_TO_NOTHING)}
    control = np.ones((1, case_218.bearing.ball_count))
    assert found_planes(case_218, duties, control) == [plane] * CASES
    assert found_planes(case_218, whole, control) == [0] * CASES
    one, other = solved(case_218, duties), solved(case_218, whole)
    assert (one.number == 0).all()
    assert (other.number == 0).all()
    for name in ("displacement", "position", "force", "stiffness", "cage"):
        found, expected = getattr(one, name), getattr(other, name)
        size = np.nanmax(np.abs(expected), initial=0.0)
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-11 * size)
    assert np.abs(one.force[:, list(AXES[plane])]).max() < 1e-10 * fx.max()


def test_what_has_no_mirror_image(case_218: Case) -> None:
    control = np.ones((1, 16))
    axial = {"fx": np.array([1e3, 2e3]), "fy": np.zeros(2), "fz": np.zeros(2)}
    assert found_planes(case_218, axial, control) == [1, 1]
    both = axial | {"fy": np.array([0.0, 1.0]), "fz": np.array([1.0, 1.0])}
    assert found_planes(case_218, both, control) == [1, 0]
    turned = axial | {"first_ball_azimuth": np.array([0.0, 0.1])}
    assert found_planes(case_218, turned, control) == [1, 0]
    between = axial | {"first_ball_azimuth": np.radians([11.25, 11.2])}
    assert found_planes(case_218, between, control) == [3, 0]
    tilted = axial | {"rz": np.array([1e-4, 0.0])}
    assert found_planes(case_218, tilted, control) == [2, 1]
    pushed = tilted | {"fz": np.array([1.0, 1.0])}
    assert found_planes(case_218, pushed, control) == [0, 1]
    # one ball under the control of the other race, and then its image too
    control[0, 3] = -1.0
    assert found_planes(case_218, axial, control) == [0, 0]
    control[0, 13] = -1.0
    assert found_planes(case_218, axial, control) == [1, 1]
    odd = case_218.replace(bearing=case_218.bearing.replace(ball_count=15))
    sideways = axial | {"fy": np.array([1.0, 0.0])}
    assert found_planes(odd, sideways, np.ones((1, 15))) == [0, 1]


def test_factors_keep_what_is_the_greatest_of_all() -> None:
    factors = mirror(16, 1).factors
    assert factors[layout.FAULT - layout.REACTION] == 1.0
    assert factors[layout.HEAVIEST - layout.REACTION] == 1.0
    assert factors[layout.PULL - layout.REACTION] == 2.0
    assert (mirror(16, 0).factors == 1.0).all()
