"""Life over a field: each point is the case solved alone, and where there is no life it is told."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.one_case import keys

from rolamento import Case, InputError, load_case, override
from rolamento.life import LifeSummary, life, sensitivity
from rolamento.life.l_able import FactorTable
from rolamento.solution import solve
from rolamento.studies.ranges import read_range
from rolamento.tasks.life import life_of_case
from rolamento.tasks.life_over import LifeCurve, life_curve

ALONE = 1e-6
FIVE = {"iso281", "iso281_modified", "iso16281", "iso16281_modified", "ioannides_harris"}


@pytest.fixture(scope="module")
def gearbox(examples: Path) -> Case:
    return load_case(examples / "6305_life.toml")


def curve(case: Case, text: str, points: int = 3, **more: object) -> LifeCurve:
    return life_curve(case, read_range(text, points), **more)  # type: ignore[arg-type]


def alone(case: Case, setting: str) -> LifeSummary:
    return life(solve(override(case, [setting])))


@pytest.mark.parametrize(
    ("text", "middle"),
    [
        ("duty.load.fz=1..3kN", "duty.load.fz=2 kN"),
        ("duty.inner_speed=1000..3000rpm", "duty.inner_speed=2000 rpm"),
        ("temperature.lubricant=50..90degC", "temperature.lubricant=70 degC"),
        ("temperature.outer_ring=60..70degC", "temperature.outer_ring=65 degC"),
        ("mounting.shaft_interference=0..20um", "mounting.shaft_interference=10 um"),
        ("life.contamination=0.2..0.8", "life.contamination=0.5"),
        ("life.viscosity_ratio=1..3", "life.viscosity_ratio=2"),
        ("life.reliability=0.9..0.98", "life.reliability=0.94"),
        ("life.fatigue_load_limit=400..600N", "life.fatigue_load_limit=500 N"),
        ("life.dynamic_rating=18..22kN", "life.dynamic_rating=20 kN"),
    ],
)
def test_a_point_is_the_case_solved_alone(gearbox: Case, text: str, middle: str) -> None:
    found, single = curve(gearbox, text), alone(gearbox, middle)
    assert found.converged
    assert set(found.theories) == FIVE
    for theory in FIVE:
        assert found[theory].hours[1] == pytest.approx(single[theory].hours[0], rel=ALONE), theory
        assert found[theory].life[1] == pytest.approx(single[theory].life[0], rel=ALONE)
        assert found[theory].valid[1] == single[theory].valid[0]
        assert {n for n, where in found[theory].notes.items() if where[1]} == set(
            keys(single[theory].notes_of())
        )
    assert single.viscosity_ratio is not None
    assert found.viscosity_ratio[1] == pytest.approx(single.viscosity_ratio[0])


def test_fields_that_need_a_case_each_are_solved_one_by_one(gearbox: Case) -> None:
    found = curve(gearbox, "life.reliability=0.9..0.99")
    plain = found["iso281"].hours / found["iso281"].hours[0]
    # ISO 281:2007, table 12: 0.25 at 99 %
    assert plain[-1] == pytest.approx(0.25, abs=0.005)
    with pytest.raises(InputError, match="must be at most 200"):
        curve(gearbox, "life.reliability=0.9..0.99", 201)


def test_the_rating_life_goes_with_the_cube_of_the_load(gearbox: Case) -> None:
    case = override(gearbox, ["duty.load.fx=0 N"])
    found = curve(case, "duty.load.fz=1..8kN", 8)
    assert found["iso281"].hours * found.values**3 == pytest.approx(
        np.full(8, found["iso281"].hours[0] * 1e9)
    )
    assert np.all(np.diff(found["iso16281_modified"].hours) < 0.0)


def test_life_is_longest_with_a_little_preload(gearbox: Case) -> None:
    case = override(load_without_mounting(gearbox), ["duty.load.fx=0 N"])
    found = curve(case, "bearing.diametral_clearance=-40..40um", 41)
    best = found.values[np.argmax(found["iso16281"].hours)]
    assert -20e-6 < best < 0.0
    assert np.ptp(found["iso281"].hours) == 0.0  # forces know no clearance


def load_without_mounting(case: Case) -> Case:
    return case.replace(
        mounting=None,
        temperature=case.temperature.replace(  # type: ignore[union-attr]
            inner_ring=None, outer_ring=None
        ),
    )


def test_where_a_theory_does_not_hold_it_is_told(gearbox: Case) -> None:
    found = curve(gearbox, "duty.load.fz=8..16kN", 5)
    over_half = found.values > 10.3e3
    assert np.array_equal(found["iso281"].valid, ~over_half)
    assert np.array_equal(found["iso281"].notes["load_above_half_rating"], over_half)
    assert np.all(np.isfinite(found["iso281"].hours))  # the formula still gives a number


def test_a_point_without_a_bearing_does_not_stop_the_others(gearbox: Case) -> None:
    found = curve(gearbox, "mounting.shaft_interference=0..500um", 3)
    assert found.status.tolist() == ["converged", "invalid_input", "invalid_input"]
    assert not found.converged
    for theory in FIVE:
        assert np.isfinite(found[theory].hours[0])
        assert np.all(np.isnan(found[theory].hours[1:]))
        assert not np.any(found[theory].valid[1:])


def test_a_point_without_a_case_of_its_own_does_not_either(gearbox: Case) -> None:
    # shoulders must be lower than half a ball, 5.16 mm
    found = curve(gearbox, "bearing.inner_shoulder_height=1..8mm", 3)
    assert found.status.tolist() == ["converged", "converged", "invalid_input"]
    assert np.isnan(found["iso281"].hours[-1])


def test_nothing_turns_no_hours(gearbox: Case) -> None:
    found = curve(gearbox, "duty.inner_speed=0..1000rpm", 2)
    assert np.isnan(found["iso281"].hours[0])
    assert np.isfinite(found["iso281"].life[0])
    assert found["iso281"].notes["hours_at_rest"].tolist() == [True, False]


def test_a_range_in_which_no_point_has_a_life_is_refused(gearbox: Case) -> None:
    plain = load_without_mounting(gearbox)
    with pytest.raises(InputError, match="above 45°"):
        curve(plain, "bearing.contact_angle=50..60deg")


def test_some_points_of_a_range_may_be_thrust_bearings(gearbox: Case) -> None:
    plain = override(load_without_mounting(gearbox), ["duty.load.fx=4 kN"])
    found = curve(plain, "bearing.contact_angle=30..60deg")
    assert found["iso281"].notes["thrust_bearing"].tolist() == [False, False, True]
    assert np.isnan(found["iso281"].hours[-1])
    assert np.all(np.isfinite(found["iso281"].hours[:2]))


def test_a_users_chart_is_interpolated(gearbox: Case) -> None:
    case = override(gearbox, ["life.nsk_cleanliness=1", "life.viscosity_ratio=1"])
    flat = FactorTable(np.array([0.5, 4.0]), np.array([1e-3, 10.0]), np.full((2, 2), 2.0))
    found = curve(case, "duty.load.fz=1..4kN", nsk_table=flat)
    assert found["l_able"].hours == pytest.approx(2.0 * found["iso281"].hours)
    assert not found["l_able"].notes["stand_in_for_the_chart"].any()
    without = curve(case, "duty.load.fz=1..4kN")
    assert np.all(without["l_able"].notes["stand_in_for_the_chart"])


def test_the_record_names_what_varies(gearbox: Case) -> None:
    found = curve(gearbox, "duty.load.fz=1..3kN", label="as it is")
    assert (found.field, found.label, len(found)) == ("duty.load.fz", "as it is", 3)
    assert found.values.tolist() == [1000.0, 2000.0, 3000.0]
    assert found.case == gearbox


def test_files_and_text_will_do(examples: Path) -> None:
    path = examples / "6305_life.toml"
    over = "duty.load.fz=1..2kN"
    found = life_curve(path, over)
    own = life_curve(load_case(path), read_range(over))
    assert np.array_equal(found["iso281"].hours, own["iso281"].hours)
    assert life_of_case(path).changes
    with pytest.raises(InputError, match="must be a Case, a bearing, a designation or the path"):
        life_of_case(3)  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"must be the result of rolamento\.solve"):
        life(load_case(path))  # type: ignore[arg-type]


def test_what_would_help_is_for_a_single_case(gearbox: Case) -> None:
    with pytest.raises(InputError, match="a single case"):
        sensitivity(solve(gearbox, fz=[1000.0, 2000.0]))
