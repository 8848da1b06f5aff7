"""Preload at rest and at speed, clamped and by springs, and the load that takes it away."""

from __future__ import annotations

import math
import tomllib
from importlib import resources
from itertools import pairwise
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.one_case import solve_one

from rolamento import Bearing, Case, Displacement, Duty, Load, Solved
from rolamento.solution import solve
from rolamento.solved import Preloading
from rolamento.system import Cases
from rolamento.system import preload as search

SPINDLE: dict[str, Any] = {
    "ball_count": 22,
    "ball_diameter": "9.525 mm",
    "pitch_diameter": "77.5 mm",
    "contact_angle": "15 deg",
    "inner_conformity": 0.52,
    "outer_conformity": 0.52,
}
CONSTANT_ANGLE = 2.0**1.5
"""Load over preload that lifts a row of a pair where the contact angle does not change."""


@pytest.fixture(scope="module", autouse=True)
def _compiled() -> None:
    """Load the compiled kernels first: few cases alone would run as plain Python, slowly."""
    solve(Case(bearing=Bearing(**SPINDLE), duty=Duty()), fx=np.full(100, 1e3), inner_speed=100.0)


def pair(preload: Any, arrangement: Any = "DB", **changes: Any) -> Bearing:
    return Bearing(
        **{**SPINDLE, "arrangement": arrangement, "spacing": 0.03, "preload": preload, **changes}
    )


def state_of(bearing: Bearing, *, speed: float = 0.0, **load: float) -> SimpleNamespace:
    state = solve_one(Case(bearing=bearing, duty=Duty(inner_speed=speed, load=Load(**load))))
    assert state.status.converged, state.status
    return state


def rows_of(bearing: Bearing, *, speed: float = 0.0, **load: float) -> list[int]:
    """How many balls of each row the inner ring presses on; without the search for the point."""
    batch = solve(Case(bearing=bearing, duty=Duty()), inner_speed=speed, **load)
    assert batch.converged.all()
    pressed = batch.inner.load[0] > 1e-9 * batch.outer.load[0]
    return [int(pressed[batch.elements.row == row].sum()) for row in range(len(batch.rows))]


def preload_of(bearing: Bearing, *, speed: float = 0.0, **load: float) -> Preloading:
    found = state_of(bearing, speed=speed, **load).preload
    assert found is not None
    return found


def listed_factors() -> list[dict[str, Any]]:
    file = resources.files("rolamento") / "data" / "preloads.toml"
    sets: list[dict[str, Any]] = tomllib.loads(file.read_text(encoding="utf-8"))["set"]
    return sets


# --- at rest ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arrangement", "axial"),
    [
        ("DB", [1, -1]),
        ("DF", [-1, 1]),
        ("TBT", [1, -1 / 2, -1 / 2]),
        ("QBT", [1, -1 / 3, -1 / 3, -1 / 3]),
        ("QFC", [-1 / 2, -1 / 2, 1 / 2, 1 / 2]),
    ],
)
@pytest.mark.parametrize("kind", ["force", "spring"])
def test_a_force_is_shared_by_the_rows_that_face_one_way(
    kind: str, arrangement: Any, axial: list[float]
) -> None:
    state = state_of(pair({kind: 600.0}, arrangement))
    assert [row.load.fx for row in state.rows] == pytest.approx([600.0 * f for f in axial])
    assert sum(row.load.fx for row in state.rows) == pytest.approx(0.0, abs=1e-6)
    assert state.load.fx == 0.0
    assert state.preload is not None
    assert (state.preload.kind, state.preload.at_rest) == (kind, pytest.approx(600.0))
    assert all(row.loaded_balls == 22 for row in state.rows)


def test_an_offset_and_the_force_that_it_gives_are_one_preload() -> None:
    """The offset is what a single bearing gives way under the force."""
    single = solve_one(Case(bearing=Bearing(**SPINDLE), duty=Duty(load=Load(fx=700.0))))
    offset = single.displacement.x
    by_force, by_offset = (
        state_of(pair(preload), fx=300.0, fz=400.0, my=3.0, speed=1000.0)
        for preload in ({"force": 700.0}, {"offset": offset})
    )
    assert by_offset.displacement == pytest.approx(by_force.displacement, rel=1e-7)
    assert by_offset.preload is not None
    assert by_offset.preload.at_rest == pytest.approx(700.0, rel=1e-8)
    assert by_offset.preload.kind == "offset"


def test_no_preload_is_rows_that_just_touch() -> None:
    for preload in (None, {"force": 0.0}, {"offset": 0.0}):
        state = state_of(pair(preload), fx=500.0)
        assert state.displacement.x == pytest.approx(
            state_of(Bearing(**SPINDLE), fx=500.0).displacement.x, rel=1e-8
        )
        assert [row.loaded_balls for row in state.rows] == [22, 0]
    assert state_of(pair(None), fx=500.0).preload is None
    assert preload_of(pair({"force": 0.0}), fx=500.0).at_rest == pytest.approx(0.0, abs=1e-9)


def test_play_between_the_rows_is_a_negative_offset() -> None:
    play = 5e-6
    loose = state_of(pair({"offset": -play}), fx=500.0)
    tight = state_of(pair(None), fx=500.0)
    assert loose.displacement.x - tight.displacement.x == pytest.approx(play, rel=1e-7)
    assert preload_of(pair({"offset": -play}), fx=500.0).at_rest == 0.0


def test_deep_groove_pairs_are_pressed_in_from_first_contact() -> None:
    """A row given by its clearance first touches at half its endplay."""
    own: Any = {"contact_angle": None, "diametral_clearance": "0.02 mm"}
    alone = Bearing(**{**SPINDLE, **own})
    for arrangement in ("DB", "DF"):
        state = state_of(pair({"force": 300.0}, arrangement, **own), fx=100.0)
        assert state.preload is not None
        assert state.preload.at_rest == pytest.approx(300.0)
        front = max(row.load.fx for row in state.rows)
        back = min(row.load.fx for row in state.rows)
        assert front + back == pytest.approx(100.0)
        rest = solve_one(Case(bearing=alone, duty=Duty(load=Load(fx=300.0)))).displacement.x
        held = Displacement(x=rest + state.displacement.x)
        moved = solve_one(Case(bearing=alone, duty=Duty(displacement=held)))
        assert moved.load.fx == pytest.approx(front, rel=1e-7)


def test_a_level_is_the_listed_force_of_a_pair() -> None:
    listed = pair({"level": "medium", "designation": "S 6012 C"})
    assert preload_of(listed).at_rest == pytest.approx(515.0)
    assert preload_of(listed).kind == "level"
    by_force = state_of(pair({"force": 515.0}), fx=200.0, fz=300.0)
    assert state_of(listed, fx=200.0, fz=300.0).displacement == pytest.approx(by_force.displacement)


@pytest.mark.parametrize("factors", listed_factors(), ids=lambda f: f"{f['maker']} {f['bearings']}")
@pytest.mark.thirds
def test_sets_clamped_with_the_offset_of_a_pair_have_the_makers_factors(
    factors: dict[str, Any],
) -> None:
    arrangement = {"1+1": "DB", "2+1": "TBT", "3+1": "QBT", "2+2": "QBC"}[factors["bearings"]]
    for angle, designation in (("15 deg", "S 6012 C"), ("25 deg", "S 6012 E")):
        level = {"level": "light", "designation": designation}
        one = state_of(pair(level, contact_angle=angle))
        several = state_of(pair(level, arrangement, contact_angle=angle))
        assert one.preload is not None
        assert several.preload is not None
        force = several.preload.at_rest / one.preload.at_rest
        assert force == pytest.approx(factors["preload"], rel=0.025)
        if "axial_rigidity" in factors:
            rigidity = several.stiffness[0, 0] / one.stiffness[0, 0]
            assert rigidity == pytest.approx(factors["axial_rigidity"], rel=0.04)
        if "unloading_load" in factors:
            # toward the side that has more rows, as the makers reckon
            load = -100.0 if arrangement in ("TBT", "QBT") else 100.0
            found = preload_of(pair(level, arrangement, contact_angle=angle), fx=load)
            lifted = found.loss_factor * 100.0 / one.preload.at_rest
            assert lifted == pytest.approx(factors["unloading_load"], rel=0.15)


# --- at speed --------------------------------------------------------------------------------


def test_clamped_rings_press_harder_with_speed_and_springs_do_not() -> None:
    speeds = [0.0, 500.0, 1000.0, 2000.0, 3000.0]
    clamped = [preload_of(pair({"force": 500.0}), speed=speed) for speed in speeds]
    sprung = [preload_of(pair({"spring": 500.0}), speed=speed) for speed in speeds]
    assert [found.at_rest for found in clamped + sprung] == pytest.approx([500.0] * 10)
    rising = [found.at_speed for found in clamped]
    assert rising[0] == pytest.approx(500.0)
    assert all(after > 1.03 * before for before, after in pairwise(rising))
    assert [found.at_speed for found in sprung] == pytest.approx([500.0] * 5)


def test_springs_keep_their_force_under_any_load_and_give_way_axially() -> None:
    state = state_of(pair({"spring": 500.0}), speed=2000.0, fx=800.0, fz=300.0, my=2.0, mz=-1.0)
    front, back = state.rows
    assert back.load.fx == pytest.approx(-500.0)
    assert front.load.fx == pytest.approx(1300.0)
    still = state_of(pair({"spring": 500.0}), fx=800.0)
    alone = state_of(Bearing(**SPINDLE), fx=1300.0)
    assert still.displacement.x == pytest.approx(alone.displacement.x, rel=1e-7)
    assert still.stiffness[0, 0] == pytest.approx(alone.stiffness[0, 0], rel=1e-7)


def test_at_rest_springs_and_clamps_of_one_force_differ_in_stiffness_only() -> None:
    clamped, sprung = state_of(pair({"force": 500.0})), state_of(pair({"spring": 500.0}))
    assert [ball.inner.load for ball in sprung.balls] == pytest.approx(
        [ball.inner.load for ball in clamped.balls]
    )
    assert clamped.stiffness[0, 0] == pytest.approx(2.0 * sprung.stiffness[0, 0], rel=1e-6)
    for i in (1, 2, 3, 4):
        assert clamped.stiffness[i, i] == pytest.approx(sprung.stiffness[i, i], rel=1e-6)


def test_at_speed_a_clamped_pair_stays_stiff_and_a_sprung_one_softens() -> None:
    rest, fast = (state_of(pair({"spring": 500.0}), speed=speed) for speed in (0.0, 2000.0))
    assert fast.stiffness[0, 0] < 0.7 * rest.stiffness[0, 0]
    stiff = state_of(pair({"force": 500.0}), speed=2000.0)
    assert stiff.stiffness[0, 0] > 2.2 * fast.stiffness[0, 0]


# --- the preload-loss point --------------------------------------------------------------------


@pytest.mark.parametrize(
    ("angle", "force", "rel"),
    [("75 deg", 1.0, 2e-5), ("40 deg", 1e-3, 1e-5), ("15 deg", 1e-4, 1e-4)],
)
@pytest.mark.thirds
def test_a_contact_angle_that_hardly_changes_gives_two_to_the_three_halves(
    angle: str, force: float, rel: float
) -> None:
    found = preload_of(pair({"force": force}, contact_angle=angle), fx=force)
    assert found.loss_factor == pytest.approx(CONSTANT_ANGLE, rel=rel)
    assert found.lost_row == 1


@pytest.mark.sweep
def test_the_contact_angle_lifts_the_ratio_with_preload_and_for_small_angles() -> None:
    forces = [10.0, 100.0, 1000.0]
    ratios = {
        angle: [
            preload_of(pair({"force": force}, contact_angle=f"{angle} deg"), fx=force).loss_factor
            for force in forces
        ]
        for angle in (12, 15, 25, 40)
    }
    for found in ratios.values():
        assert CONSTANT_ANGLE < found[0] < found[1] < found[2]
    for flatter, steeper in ((12, 15), (15, 25), (25, 40)):
        assert all(a > b for a, b in zip(ratios[flatter], ratios[steeper], strict=True))


@pytest.mark.sweep
def test_a_row_really_loses_its_balls_there() -> None:
    for arrangement, load in (
        ("DB", {"fx": 300.0}),
        ("DF", {"fx": 300.0}),
        ("DB", {"fx": -300.0, "fz": 60.0}),
        ("TBT", {"fx": -300.0, "fz": 10.0}),
        ("TFT", {"fx": 200.0}),
    ):
        for speed in (0.0, 700.0):
            bearing = pair({"force": 500.0}, arrangement)
            found = preload_of(bearing, speed=speed, **load)
            assert found.lost_row is not None
            held, lifted = (
                rows_of(
                    bearing,
                    speed=speed,
                    **{name: factor * found.loss_factor * value for name, value in load.items()},
                )
                for factor in (1.0 - 1e-4, 1.0 + 1e-4)
            )
            assert min(held) > 0
            assert lifted[found.lost_row] == 0


def test_a_ball_lifts_off_before_its_row_does() -> None:
    for arrangement, load, speed in (
        ("DB", {"fx": 300.0, "fz": 60.0}, 0.0),
        ("DF", {"fx": -200.0, "fz": 80.0, "my": 0.5, "mz": 0.3}, 700.0),
        ("DB", {"fz": 300.0}, 0.0),
    ):
        bearing = pair({"force": 500.0}, arrangement)
        found = preload_of(bearing, speed=speed, **load)
        assert found.lift_row is not None
        assert not found.lift_factor >= found.loss_factor  # which may not exist
        held, lifted = (
            rows_of(
                bearing,
                speed=speed,
                **{name: factor * found.lift_factor * value for name, value in load.items()},
            )
            for factor in (1.0 - 1e-4, 1.0 + 1e-4)
        )
        assert held == [22, 22]
        assert 0 < lifted[found.lift_row] < 22


@pytest.mark.parametrize("arrangement", ["DB", "DF"])
def test_the_search_for_the_loss_of_preload_is_short(
    arrangement: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of a tilted pair of tapered bearings: a roller leaves by its end, and goes on from there."""
    case = Case.model_validate(
        {
            "bearing": {"designation": f"30206 {arrangement}", "preload": "300 N"},
            "duty": {
                "inner_speed": "1500 rpm",
                "load": {"fx": "500 N", "fz": "2 kN"},
                "displacement": {"ry": "0.5 mrad", "rz": "0 mrad"},
            },
        }
    )
    solved, solutions = solve(case), []
    plain = search.solve_cases

    def counted(cases: Cases) -> Solved:
        solutions.append(len(cases))
        return plain(cases)

    monkeypatch.setattr(search, "solve_cases", counted)
    found = solved.preload
    assert found is not None
    assert sum(solutions) <= 30
    if arrangement == "DF":
        assert found.lift_factor is not None
        around = found.lift_factor * np.array([1.0 - 1e-4, 1.0 + 1e-4])
        held = solve(case, fx=500.0 * around, fz=2e3 * around).inner.load > 0.0
        assert held.all(axis=1).tolist() == [True, False]


def test_under_axial_load_all_balls_of_a_row_lift_off_together() -> None:
    found = preload_of(pair({"force": 500.0}), fx=300.0)
    assert (found.lift_factor, found.lift_row) == (found.loss_factor, found.lost_row)
    # and so they do where the search goes ball by ball: hardly any radial load
    nearly = preload_of(pair({"force": 500.0}), fx=300.0, fz=1e-3)
    assert nearly.lift_factor == pytest.approx(found.loss_factor, rel=1e-4)
    assert nearly.loss_factor == pytest.approx(found.loss_factor, rel=1e-4)


@settings(max_examples=3)
@given(scale=st.floats(1e-3, 5.0))
@pytest.mark.sweep
def test_the_point_does_not_hang_on_how_the_load_is_counted(scale: float) -> None:
    bearing = pair({"force": 500.0})
    point = preload_of(bearing, fx=1000.0, fz=100.0).loss_factor
    scaled = preload_of(bearing, fx=1000.0 * scale, fz=100.0 * scale)
    assert scaled.loss_factor * scale == pytest.approx(point, rel=1e-5)


def test_turned_around_the_other_row_is_lost() -> None:
    one, other = (preload_of(pair({"force": 500.0}), fx=load) for load in (700.0, -700.0))
    assert (one.lost_row, other.lost_row) == (1, 0)
    assert one.loss_factor == pytest.approx(other.loss_factor, rel=1e-6)


@pytest.mark.sweep
def test_where_there_is_no_such_point_the_number_does_not_exist() -> None:
    unloaded = preload_of(pair({"force": 500.0}), speed=1000.0)
    without = [
        unloaded,
        preload_of(pair({"force": 500.0}), fx=0.0),
        preload_of(pair({"force": 0.0}), fx=100.0),  # nothing to lose
        preload_of(pair({"offset": -5e-6}), fx=100.0),
        preload_of(pair({"force": 500.0}), fz=100.0),  # held upright, both rows bear it
        preload_of(pair({"force": 500.0}, "TBT"), fx=300.0, fz=60.0, my=0.5, mz=0.0),  # likewise
        preload_of(pair({"spring": 500.0}), fx=100.0),  # the springs follow
    ]
    for found in without:
        assert math.isnan(found.loss_factor)
        assert found.lost_row is None
    for found in (without[0], without[1], without[2], without[3], without[6]):
        assert math.isnan(found.lift_factor)
        assert found.lift_row is None
    mapping = state_of(pair({"force": 500.0}), speed=1000.0).to_mapping()["preload"]
    assert mapping["loss_factor"] is None
    assert mapping["at_speed"] == pytest.approx(unloaded.at_speed)


def test_springs_pushed_back_leave_no_equilibrium() -> None:
    duty = Duty(load=Load(fx=-501.0))
    state = solve_one(Case(bearing=pair({"spring": 500.0}), duty=duty))
    assert (state.status.code, state.preload) == ("no_equilibrium", None)
    near = state_of(pair({"spring": 500.0}), fx=-499.0)
    assert near.rows[0].load.fx == pytest.approx(1.0, rel=1e-5)


def test_a_plain_bearing_and_a_tandem_have_no_preload() -> None:
    assert state_of(Bearing(**SPINDLE), fx=500.0).preload is None
    tandem = state_of(pair(None, "DT"), fx=500.0)
    assert tandem.preload is None
    assert tandem.to_mapping()["preload"] is None


@pytest.mark.parametrize(
    "change",
    [
        {"duty.inner_speed": "9000 rpm"},
        {"bearing.preload.force": "400 N"},
        {"bearing.ball_diameter": "9.0 mm"},
        {"bearing.ball_material": "Si3N4"},
        {"model.raceway_control": "none"},
    ],
)
def test_a_kept_preload_is_that_of_its_case_alone(change: dict[str, str]) -> None:
    tables = {
        "bearing": {**SPINDLE, "arrangement": "DB", "spacing": "18 mm",
                    "preload": {"force": "300 N"}},
        "duty": {"inner_speed": "12000 rpm", "load": {"fx": "100 N"}},
    }  # fmt: skip
    case = Case.from_mapping(tables)

    def forces(of: Case) -> tuple[float, float]:
        found = search.preload_of(of, loss=False)
        assert found is not None
        return found.at_rest, found.at_speed

    first = forces(case)
    assert forces(case.with_(fx="250 N")) == first  # whatever the load
    changed = case.with_(change)
    kept = forces(changed)
    assert kept != first
    search._forces.cache_clear()
    assert forces(changed) == kept
    assert forces(case) == first
