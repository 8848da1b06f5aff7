"""All theories side by side: what they read of a state or a batch, their notes, what limits."""

from __future__ import annotations

import json

import numpy as np
import pytest
from tests.one_case import keys

from rolamento import Bearing, Case, Displacement, Duty, InputError, Load
from rolamento.case.temperature import Temperature
from rolamento.life import (
    Life,
    LifeConditions,
    life,
    sensitivity,
    with_lubricant,
)
from rolamento.life.contamination import class_of_code, class_of_grease
from rolamento.life.l_able import FactorTable
from rolamento.life.record import OUTSIDE
from rolamento.life.theories import THEORIES
from rolamento.lubrication import film as film_of
from rolamento.oil.state import viscosity_ratio
from rolamento.solution import solve
from rolamento.words.sentences import sentences
from rolamento.words.theories import theory_heads, theory_life, theory_name, theory_scope

RPM = np.pi / 30.0
SPEED = 2000.0 * RPM
DEEP = Bearing(
    ball_count=8,
    ball_diameter=0.010319,
    pitch_diameter=0.0445,
    diametral_clearance=13e-6,
    inner_conformity=0.52,
    outer_conformity=0.53,
)
ANGULAR = {
    "ball_count": 16,
    "ball_diameter": 0.0127,
    "pitch_diameter": 0.07,
    "contact_angle": np.radians(25.0),
    "inner_conformity": 0.52,
    "outer_conformity": 0.53,
}
MULTIPLIERS = ("a_1", "a_iso", "a_2", "a_3")
OILED = LifeConditions(
    viscosity=13e-6,
    contamination=class_of_code("-/15/12", "circulating"),
    material_factor=1.0,
    nsk_cleanliness=0.8,
    reliability=0.95,
)


def _case(bearing: Bearing = DEEP, speed: float = SPEED, **load: float) -> Case:
    return Case(bearing=bearing, duty=Duty(inner_speed=speed, load=Load(**load)))


def test_state_and_batch_agree_on_every_theory() -> None:
    case = _case(fz=4000.0, fx=600.0)
    one = life(solve(case), OILED)
    many = life(solve(case, fz=[4000.0, 5000.0]), OILED, stress_volume=True)
    assert set(one.theories) == set(many.theories)
    assert len(one.theories) == 7
    for name in one.theories:
        assert many[name].life[0] == pytest.approx(one[name].life[0], rel=1e-6), name
        assert many[name].life[1] < many[name].life[0]
        assert many[name].hours == pytest.approx(many[name].life * 1e6 / 120_000.0)


def test_factors_multiply() -> None:
    found = life(solve(_case(fz=4000.0)), OILED)
    for name in ("iso281", "iso281_modified", "iso16281", "iso16281_modified", "iso281_1990"):
        record = found[name]
        product = float(
            np.prod(
                [
                    record.factors[f][0]
                    for f in ("a_1", "a_iso", "a_2", "a_3")
                    if f in record.factors
                ]
            )
        )
        assert record.life[0] == pytest.approx(record.basic[0] * product)
    assert found["iso281"].basic[0] == pytest.approx(
        (found.ratings.dynamic_of_set[0] / 4000.0) ** 3
    )


def test_viscosity_is_turned_into_its_ratio() -> None:
    found = life(solve(_case(fz=4000.0)), OILED)
    assert found.viscosity_ratio is not None
    assert found.viscosity_ratio[0] == viscosity_ratio(13e-6, SPEED, 0.0445)


def test_a_case_without_result_has_no_life() -> None:
    case = _case(fz=4000.0)
    batch = solve(case, {"bearing.diametral_clearance": [13e-6, 5.0]})
    found = life(batch, OILED, stress_volume=True)
    for record in found.theories.values():
        assert np.isfinite(record.life[0])
        assert np.isnan(record.life[1])
        assert not record.valid[1]
    assert found.limit.race[1] == ""
    assert found.limit.ball[1] == -1


def test_notes_on_load_and_speed() -> None:
    heavy = life(solve(_case(fz=12_000.0)), OILED)
    assert {"load_above_half_rating", "load_above_static_rating"} <= keys(
        heavy["iso281"].notes_of()
    )
    assert np.isfinite(heavy["iso281"].life[0])
    assert not heavy["iso281"].valid[0]
    assert np.isnan(heavy["l_able"].life[0])
    still = life(solve(_case(speed=0.0, fz=4000.0)), LifeConditions(viscosity_ratio=1.0))
    assert "hours_at_rest" in keys(still["iso281"].notes_of())
    assert np.isnan(still["iso281"].hours[0])
    assert np.isfinite(still["iso281"].life[0])
    fast = life(solve(_case(speed=40_000.0 * RPM, fz=300.0)))
    assert "centrifugal_left_out" in keys(fast["iso281"].notes_of())
    assert "centrifugal_left_out" not in keys(fast["iso16281"].notes_of())


def test_notes_on_lubrication() -> None:
    state = solve(_case(fz=4000.0))
    thin = life(state, LifeConditions(viscosity_ratio=0.05, contamination=0.5))
    assert "viscosity_ratio_too_small" in keys(thin["iso281_modified"].notes_of())
    assert thin["iso281_modified"].life[0] == pytest.approx(0.1 * thin["iso281"].life[0])
    assert thin["iso281_modified"].below[0]
    assert not thin["iso281_modified"].valid[0]
    assert thin.limit.factor[0] == "viscosity_ratio"
    hot = life(state, LifeConditions(temperature=400.0))
    assert "too_hot_for_steel" in keys(hot["iso281"].notes_of())
    assert not hot["iso281"].valid[0]
    dirty = life(
        state, LifeConditions(viscosity_ratio=1.0, contamination=class_of_grease("very_severe"))
    )
    assert "contamination_severe" in keys(dirty["iso281_modified"].notes_of())
    assert dirty.limit.factor[0] == "contamination"
    clean = life(state, LifeConditions(viscosity_ratio=4.0, contamination=1.0))
    assert clean.limit.factor[0] == "load"


def test_every_note_has_a_sentence() -> None:
    assert set(sentences()) >= OUTSIDE
    heavy = life(
        solve(_case(Bearing(**{**ANGULAR, "inner_conformity": 0.6}), fx=9e4, fz=3e4)),
        LifeConditions(
            viscosity_ratio=9.0,
            contamination=0.0,
            temperature=500.0,
            material_factor=2.0,
            operation_factor=2.0,
            nsk_cleanliness=0.5,
            reliability=0.5,
        ),
    )
    names = {name for record in heavy.theories.values() for name in record.notes}
    assert len(names) >= 10
    assert names <= set(sentences())


def test_mapping_is_json() -> None:
    mapping = life(solve(_case(fz=4000.0)), OILED).to_mapping()
    again = json.loads(json.dumps(mapping, allow_nan=False))
    assert again["limit"]["race"] == "inner"
    assert again["theories"]["iso16281"]["hours"] > 0.0
    held = Displacement(x=0.0, y=0.0, z=0.0)
    empty = life(solve(Case(bearing=DEEP, duty=Duty(displacement=held)))).to_mapping()
    assert empty["theories"]["iso16281"]["life"] is None
    assert not empty["theories"]["iso16281"]["unlimited"]
    assert not empty["theories"]["iso16281"]["valid"]
    assert empty["theories"]["iso16281"]["notes"][0]["key"] == "unloaded"


def test_heaviest_ball_limits() -> None:
    state = solve(_case(fz=4000.0, fx=500.0))
    found = life(state)
    loads = state.inner.load[0]
    assert found.limit.race[0] == "inner"
    assert found.limit.ball[0] == int(np.argmax(loads))
    assert 0.5 < found.limit.share[0] < 1.0


def test_turning_outer_ring_lives_less() -> None:
    inner = life(solve(_case(fz=4000.0)))
    case = Case(bearing=DEEP, duty=Duty(outer_speed=SPEED, load=Load(fz=4000.0)))
    outer = life(solve(case))
    assert outer["iso16281"].life[0] < inner["iso16281"].life[0]
    told = life(solve(case), LifeConditions(inner_turning=True, outer_turning=False))
    assert told["iso16281"].life[0] == pytest.approx(inner["iso16281"].life[0], rel=2e-3)


def test_tilt_shortens_the_reference_life_alone() -> None:
    duty = Duty(inner_speed=SPEED, load=Load(fz=4000.0))
    tilted = Duty(
        inner_speed=SPEED, load=Load(fz=4000.0), displacement=Displacement(ry=np.radians(0.4))
    )
    straight, bent = (life(solve(Case(bearing=DEEP, duty=d))) for d in (duty, tilted))
    assert bent["iso16281"].life[0] < 0.9 * straight["iso16281"].life[0]
    assert bent["iso281"].life[0] == pytest.approx(straight["iso281"].life[0])
    assert "moment_left_out" in keys(bent["iso281"].notes_of())


def test_tandem_and_pair() -> None:
    one = life(solve(_case(Bearing(**ANGULAR), fx=2000.0)))
    tandem = life(solve(_case(Bearing(**ANGULAR, arrangement="DT", spacing=0.02), fx=4000.0)))
    # two rows share the load: C grows by 2^0.7 only, and so does the reference life
    for name in ("iso281", "iso16281"):
        assert tandem[name].life[0] == pytest.approx(one[name].life[0] * 2.0**-0.9, rel=1e-3)
    pair = life(
        solve(_case(Bearing(**ANGULAR, arrangement="DB", spacing=0.02), fx=2000.0, fz=1000.0))
    )
    # 25 degrees, F_a/F_r = 2 beyond e: X2 = 0.67, Y2 = 1.41
    assert pair.loads.dynamic[0] == pytest.approx(0.67 * 1000.0 + 1.41 * 2000.0)
    assert pair.limit.row[0] in (0, 1)


def test_set_without_equivalent_load() -> None:
    found = life(
        solve(_case(Bearing(**ANGULAR, arrangement="TBT", spacing=0.02), fx=3000.0, fz=500.0))
    )
    assert np.isnan(found["iso281"].life[0])
    assert "no_equivalent_load" in keys(found["iso281"].notes_of())
    assert np.isfinite(found["iso16281"].life[0])


def test_ceramic_balls() -> None:
    hybrid = Bearing(**ANGULAR, ball_material="Si3N4")
    found = life(solve(_case(hybrid, fx=2000.0)))
    assert np.isfinite(found["iso281"].life[0])
    assert "ceramic_balls" in keys(found["iso281"].notes_of())
    steel = life(solve(_case(Bearing(**ANGULAR), fx=2000.0)))
    share = found.ratings.static_of_set[0] / steel.ratings.static_of_set[0]
    assert share == pytest.approx(0.71, abs=0.01)
    assert found.ratings.dynamic_of_set[0] == pytest.approx(steel.ratings.dynamic_of_set[0])
    given = life(solve(_case(hybrid, fx=2000.0)), LifeConditions(static_rating=30_000.0))
    assert given.ratings.static_of_set[0] == 30_000.0
    steel = life(solve(_case(Bearing(**ANGULAR), fx=2000.0)))
    assert found.ratings.fatigue_of_set[0] < steel.ratings.fatigue_of_set[0]


def test_table_of_the_user() -> None:
    table = FactorTable(
        np.array([0.1, 4.0]), np.array([1e-3, 1.0]), np.array([[0.5, 0.5], [2.0, 2.0]])
    )
    conditions = LifeConditions(viscosity_ratio=4.0, nsk_cleanliness=0.8, nsk_table=table)
    found = life(solve(_case(fz=3000.0)), conditions)
    assert found["l_able"].life[0] == pytest.approx(2.0 * found["l_able"].basic[0])
    assert "stand_in_for_the_chart" not in keys(found["l_able"].notes_of())
    outside = life(
        solve(_case(fz=3000.0)),
        LifeConditions(viscosity_ratio=9.0, nsk_cleanliness=0.8, nsk_table=table),
    )
    assert "outside_the_table" in keys(outside["l_able"].notes_of())
    assert np.isnan(outside["l_able"].life[0])


def test_lubricant_of_the_case_is_taken_where_nothing_is_given() -> None:
    oiled = Case(
        bearing=DEEP,
        duty=Duty(inner_speed=SPEED, load=Load(fz=4000.0)),
        lubricant="ISO VG 68",
        temperature=Temperature(lubricant=343.15),
    )
    state = solve(oiled)
    filled = with_lubricant(LifeConditions(contamination=0.5), oiled)
    assert filled.temperature == 343.15
    found = life(state, filled)
    assert found.viscosity_ratio is not None
    assert found.viscosity_ratio[0] == pytest.approx(film_of(solve(oiled)).viscosity_ratio[0])
    own = LifeConditions(viscosity_ratio=2.0, temperature=300.0)
    assert with_lubricant(own, oiled) is own
    dry = Case(bearing=DEEP, duty=oiled.duty)
    assert with_lubricant(own, dry) is own


def test_given_ratings_are_taken() -> None:
    found = life(
        solve(_case(fz=4000.0)), LifeConditions(dynamic_rating=20_600.0, static_rating=11_200.0)
    )
    assert found["iso281"].life[0] == pytest.approx((20_600.0 / 4000.0) ** 3)
    assert found.loads.safety[0] == pytest.approx(2.8)
    estimate = LifeConditions(static_rating=11_000.0, fatigue_load_limit="estimate")
    assert life(solve(_case(fz=4000.0)), estimate).ratings.fatigue_of_set[0] == (
        pytest.approx(500.0)
    )


def test_rating_is_lowered_for_open_grooves_and_never_raised() -> None:
    ratings = [
        float(life(solve(_case(DEEP.replace(inner_conformity=f), fz=4000.0))).ratings.dynamic[0, 0])
        for f in (0.505, 0.52, 0.54)
    ]
    assert ratings[0] == ratings[1]
    assert 0.6 * ratings[1] < ratings[2] < 0.95 * ratings[1]


@pytest.mark.parametrize(
    "wrong",
    [
        {"reliability": 95.0},
        {"edition": "2020"},
        {"dynamic_rating": -1.0},
        {"viscosity": 1e-5, "viscosity_ratio": 1.0},
        {"contamination": 1.5},
        {"contamination": "dirty"},
        {"fatigue_load_limit": "guess"},
        {"fatigue_limit": -1.0},
        {"temperature": -5.0},
    ],
)
def test_wrong_conditions(wrong: dict[str, object]) -> None:
    with pytest.raises(InputError):
        LifeConditions(**wrong)  # type: ignore[arg-type]


def test_what_cannot_be_had() -> None:
    with pytest.raises(InputError, match="45"):
        life(solve(_case(Bearing(**{**ANGULAR, "contact_angle": np.radians(60.0)}), fx=1000.0)))
    with pytest.raises(InputError, match="viscosity_ratio"):
        life(solve(_case(fz=1000.0)), LifeConditions(nsk_cleanliness=0.5))
    case = _case(fz=1000.0)
    with pytest.raises(InputError, match="each of the 2 cases"):
        life(solve(case, fz=[1.0, 2.0]), LifeConditions(viscosity_ratio=[1.0, 2.0, 3.0]))


def test_one_thrust_bearing_does_not_spoil_the_others() -> None:
    case = _case(Bearing(**ANGULAR), fx=2000.0)
    batch = solve(case, {"bearing.contact_angle": np.radians([25.0, 60.0])})
    found = life(batch, OILED, stress_volume=True)
    for record in found.theories.values():
        assert record.life[0] > 0.0
        assert np.isnan(record.life[1])
        assert "thrust_bearing" in keys(record.notes_of(1))
        assert "thrust_bearing" not in keys(record.notes_of(0))


def test_sensitivity_at_rest() -> None:
    found = {
        change.name: change.life_ratio
        for change in sensitivity(solve(_case(speed=0.0, fz=4000.0)), OILED)
    }
    assert np.isnan(found["thicker_oil"])


def test_sensitivity() -> None:
    state = solve(_case(fz=4000.0))
    found = {change.name: change.life_ratio for change in sensitivity(state, OILED)}
    assert found["less_load"] > 1.0 / 0.9**3 * 0.99
    assert found["less_clearance"] > 1.0 > found["more_clearance"]
    assert found["thicker_oil"] > 1.0
    assert found["cleaner_oil"] > 1.0
    dry = sensitivity(state)
    assert dry[0].name == "less_load"
    assert {change.name for change in dry} == {"less_load", "less_clearance", "more_clearance"}
    assert dry[0].note.text == "all forces and moments −10 %"


def test_record_is_one_for_all() -> None:
    found = life(solve(_case(fz=4000.0)), OILED)
    assert all(isinstance(record, Life) for record in found.theories.values())
    assert found.headline.theory[0] == "iso16281_modified"
    assert found.headline.life is found["iso16281_modified"].life


def test_without_a_number_there_is_nothing_that_it_leaves_out() -> None:
    """No load and a pure moment are said; not how a load that is not there is out of range."""
    given = LifeConditions(viscosity_ratio=0.05, contamination=0.5)
    idle = life(solve(_case(fz=0.0)), given)
    for own in idle.theories.values():
        found = keys(own.notes_of())
        assert "unloaded" in found
        assert not found & {"light_load", "centrifugal_left_out", "viscosity_ratio_too_small"}
    tilting = life(solve(_case(my=20.0)), given)
    found = keys(tilting["iso281_modified"].notes_of())
    assert "no_force" in found
    assert not found & {"light_load", "centrifugal_left_out", "viscosity_ratio_too_small"}
    assert "viscosity_ratio_too_small" in keys(tilting["iso16281_modified"].notes_of())


# --- the list of theories ---------------------------------------------------------------------


def test_every_theory_has_its_words_and_a_rank_of_its_own() -> None:
    for theory in THEORIES:
        assert theory_name(theory) != theory
        assert all((*theory_heads(theory), theory_life(theory), theory_scope(theory)))
    assert sorted(theory.rank for theory in THEORIES.values()) == list(range(len(THEORIES)))


def test_what_refuses_a_theory_is_in_its_validity() -> None:
    case = _case(fz=4000.0).replace(
        life={
            "material_factor": 1.0,
            "nsk_cleanliness": 0.8,
            "viscosity_ratio": 1.0,
            "contamination": 0.5,
            "tallian_subsurface": {},
        }
    )
    found = life(solve(case))
    assert list(found.theories) == list(THEORIES)
    for name, record in found.theories.items():
        refusing = set(record.notes) & OUTSIDE
        assert set(THEORIES[name].validity) <= OUTSIDE
        assert refusing <= set(THEORIES[name].validity), name
