"""Sets at their edges: wrong ways, play, absurd loads, many rows; what the state tells of rows."""

from __future__ import annotations

import json
import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from tests.one_case import solve_one

from rolamento import Bearing, Case, Displacement, Duty, Load, Model
from rolamento.case.arrangement import ARRANGEMENTS
from rolamento.solution import solve

ANGULAR: dict[str, Any] = {
    "ball_count": 16,
    "ball_diameter": "22.23 mm",
    "pitch_diameter": "125.26 mm",
    "contact_angle": "40 deg",
    "inner_conformity": 0.5232,
    "outer_conformity": 0.5232,
}
DEEP_GROOVE: dict[str, Any] = {
    **ANGULAR,
    "contact_angle": None,
    "diametral_clearance": "40 um",
}


@pytest.fixture(scope="module", autouse=True)
def _compiled() -> None:
    """Load the compiled kernels first: few cases alone would run as plain Python, slowly."""
    solve(Case(bearing=Bearing(**ANGULAR), duty=Duty()), fx=np.full(100, 1e4), inner_speed=100.0)


def set_of(arrangement: Any, preload: Any = None, **changes: Any) -> Bearing:
    return Bearing(
        **{**ANGULAR, "arrangement": arrangement, "spacing": "40 mm", "preload": preload, **changes}
    )


def state_of(
    bearing: Bearing, *, speed: float = 0.0, control: Any = "outer", **load: Any
) -> SimpleNamespace:
    duty = Duty(inner_speed=speed, load=Load(**load))
    return solve_one(Case(bearing=bearing, duty=duty, model=Model(raceway_control=control)))


# --- what the state tells --------------------------------------------------------------------


def test_rows_and_balls_are_told_one_by_one() -> None:
    state = state_of(set_of("TBT", "3 kN"), fx=2e3, fz=3e3, speed=500.0)
    assert [row.row for row in state.rows] == [0, 1, 2]
    assert [row.orientation for row in state.rows] == ["+", "-", "-"]
    assert [row.position for row in state.rows] == pytest.approx([-0.04, 0.0, 0.04])
    assert [ball.row for ball in state.balls] == [0] * 16 + [1] * 16 + [2] * 16
    total = np.sum([row.load for row in state.rows], axis=0)
    assert total == pytest.approx(np.array(state.load), abs=1e-5)
    mapping = json.loads(state.to_json())
    assert [row["load"]["fx"] for row in mapping["rows"]] == pytest.approx(
        [row.load.fx for row in state.rows]
    )
    first = ("row", "orientation", "position", "load", "loaded_balls")
    assert {name: mapping["rows"][2][name] for name in first} == {
        "row": 2,
        "orientation": "-",
        "position": 0.04,
        "load": pytest.approx(state.rows[2].load._asdict()),
        "loaded_balls": 16,
    }


def test_the_balls_of_each_row_carry_what_the_row_carries() -> None:
    """At rest, from contact loads and angles alone: the row's axial force, and its side."""
    state = state_of(set_of("DB", "3 kN"), fx=2e3, fz=3e3)
    for row in state.rows:
        balls = [ball for ball in state.balls if ball.row == row.row]
        axial = sum(ball.inner.load * math.sin(ball.inner.contact_angle) for ball in balls)
        radial = sum(
            ball.inner.load * math.cos(ball.inner.contact_angle) * math.cos(ball.azimuth)
            for ball in balls
        )
        sign = 1.0 if row.orientation == "+" else -1.0
        assert sign * axial == pytest.approx(row.load.fx, rel=1e-8)
        assert radial == pytest.approx(row.load.fz, rel=1e-8)


def test_one_case_alone_and_in_a_batch_are_the_same() -> None:
    bearing = set_of("QBC")
    one = state_of(bearing, fx=2e3, fz=3e3, my=100.0, mz=0.0, speed=700.0)
    duty = Duty(inner_speed=700.0)
    many = solve(
        Case(bearing=bearing, duty=duty), fx=[2e3, 9e3], fz=3e3, my=100.0, mz=0.0, threads=2
    )
    assert one.displacement.array == pytest.approx(
        many.displacement.array[0].tolist(), rel=1e-7, abs=1e-13
    )


# --- the wrong way ---------------------------------------------------------------------------


@pytest.mark.parametrize("arrangement", ["DT", "TT", "QT"])
@pytest.mark.parametrize("speed", [0.0, 500.0])
def test_a_tandem_loaded_the_wrong_way_has_no_equilibrium(arrangement: Any, speed: float) -> None:
    state = state_of(set_of(arrangement), fx=-1e3, speed=speed)
    assert (state.status.code, state.status.converged) == ("no_equilibrium", False)
    assert state.status.advice
    assert all(math.isnan(value) for value in (*state.displacement, *state.load))
    assert all(math.isnan(row.load.fx) for row in state.rows)
    assert state.preload is None


def test_a_bad_case_does_not_touch_its_neighbours() -> None:
    case = Case(bearing=set_of("DT"), duty=Duty())
    mixed = solve(case, fx=[5e3, -5e3, 8e3, np.nan, 1e9], inner_speed=300.0)
    assert mixed.status.code[:4].tolist() == [
        "converged", "no_equilibrium", "converged", "invalid_input",
    ]  # fmt: skip
    assert mixed.status.code[4] != "converged"
    alone = solve(case, fx=[5e3, 8e3], inner_speed=300.0)
    assert mixed.displacement.array[[0, 2]] == pytest.approx(
        alone.displacement.array, rel=1e-9, abs=1e-16
    )


@pytest.mark.parametrize("size", [1e-6, 1e5, 1e7, 1e9])
@pytest.mark.parametrize("name", ["fx", "fz", "my"])
@pytest.mark.parametrize("preload", [None, "5 kN", {"spring": "5 kN"}])
@pytest.mark.thirds
def test_absurd_loads_have_a_name(size: float, name: str, preload: Any) -> None:
    case = Case(bearing=set_of("DB", preload), duty=Duty())
    loads = {"my": 0.0, "mz": 0.0, name: [size, -size]}
    batch = solve(case, loads, inner_speed=300.0)
    named = {"converged", "no_equilibrium", "overloaded", "not_converged", "unconstrained_ball"}
    assert set(batch.status.code.tolist()) <= named
    assert np.isfinite(batch.displacement.array[batch.converged]).all()
    assert np.isnan(batch.displacement.array[~batch.converged]).all()
    if size == 1e9:
        assert not batch.converged.any()
    if size == 1e-6 and preload is not None:
        assert batch.converged.all()


# --- play and clearance ----------------------------------------------------------------------


def test_rows_with_play_bear_one_after_the_other() -> None:
    play = 20e-6
    bearing = set_of("DB", {"offset": -play})
    batch = solve(Case(bearing=bearing, duty=Duty()), fx=[500.0, -500.0])
    alone = solve(Case(bearing=Bearing(**ANGULAR), duty=Duty()), fx=[500.0])
    reach = alone.displacement.array[0, 0] + play
    assert batch.displacement.array[:, 0] == pytest.approx([reach, -reach], rel=1e-7)


def test_a_deep_groove_pair_faces_both_ways() -> None:
    """Without preload each row carries either side: a pair is two bearings at the same place."""
    pair = Bearing(**{**DEEP_GROOVE, "arrangement": "DT", "spacing": "40 mm"})
    alone = Bearing(**DEEP_GROOVE)
    for fx in (4e3, -4e3):
        both = solve(Case(bearing=pair, duty=Duty()), fx=[fx], fz=2e3)
        one = solve(Case(bearing=alone, duty=Duty()), fx=[0.5 * fx], fz=1e3)
        assert both.converged.all()
        assert both.displacement.array == pytest.approx(one.displacement.array, rel=1e-6, abs=1e-13)


def test_a_held_ring_is_held() -> None:
    bearing = set_of("DF", "4 kN")
    held = Displacement(x=5e-6, y=-2e-6, z=8e-6, ry=1e-4, rz=-5e-5)
    state = solve_one(Case(bearing=bearing, duty=Duty(inner_speed=600.0, displacement=held)))
    assert tuple(state.displacement) == pytest.approx((5e-6, -2e-6, 8e-6, 1e-4, -5e-5), rel=1e-14)
    back = state_of(bearing, speed=600.0, **state.load._asdict())
    assert tuple(back.displacement) == pytest.approx(tuple(state.displacement), rel=1e-5, abs=1e-12)


# --- many rows -------------------------------------------------------------------------------


def test_twenty_rows() -> None:
    rows = [
        {"orientation": "+" if i < 10 else "-", "position": 0.03 * (i - 9.5)} for i in range(20)
    ]
    bearing = Bearing(**ANGULAR, rows=rows, preload={"force": 20e3})
    case = Case(bearing=bearing, duty=Duty(inner_speed=300.0))
    batch = solve(case, fx=3e3, fz=20e3, my=500.0, mz=0.0)
    assert batch.converged.all()
    assert batch.inner.load.shape == (1, 320)
    total = batch.rows.load[0].sum(axis=0)
    assert total == pytest.approx([3e3, 0.0, 20e3, 500.0, 0.0], abs=1e-3)


@pytest.mark.parametrize("arrangement", ARRANGEMENTS)
@pytest.mark.parametrize("control", ["outer", "inner", "jones", "none"])
@pytest.mark.thirds
def test_every_arrangement_under_every_control(arrangement: Any, control: Any) -> None:
    two_sided = len(set(ARRANGEMENTS[arrangement])) > 1
    bearing = set_of(arrangement, "6 kN" if two_sided else None)
    case = Case(bearing=bearing, duty=Duty(inner_speed=200.0), model=Model(raceway_control=control))
    batch = solve(case, fx=8e3, fz=2e3)
    assert batch.status.code.tolist() == ["converged"]
    assert batch.status.residual[0] <= 1e-8
