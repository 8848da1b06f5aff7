"""Lives of roller bearings: slices, sets of balls and rollers, ribs, what would help, refusals."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

from rolamento import Case, solve
from rolamento.errors import InputError
from rolamento.life import life, sensitivity
from rolamento.life.iso16281 import ROLLER_SLOPE, SLOPE
from rolamento.life.lamina import edge_factor, roller_race_ratings
from rolamento.life.record import slope_of
from rolamento.solved import Solved
from rolamento.studies.life_outputs import refuse_lifeless
from rolamento.tasks.life import life_of_shaft
from rolamento.tasks.life_over import life_curves

GEOMETRY: dict[str, Any] = {
    "element": "cylindrical",
    "roller_count": 13,
    "roller_diameter": 7.5e-3,
    "effective_length": 8.2e-3,
    "pitch_diameter": 39e-3,
    "diametral_clearance": 30e-6,
}
BALLS: dict[str, Any] = {
    "element": "ball",
    "ball_count": 9,
    "ball_diameter": 7.94e-3,
    "pitch_diameter": 39e-3,
    "inner_conformity": 0.52,
    "outer_conformity": 0.52,
    "diametral_clearance": 10e-6,
    "position": -0.012,
}


def case_of(bearing: dict[str, Any] | None = None, **more: Any) -> Case:
    duty = {"inner_speed": 150.0, "load": {"fz": 4000.0}, **more.pop("duty", {})}
    return Case(bearing=bearing or GEOMETRY, duty=duty, **more)


@cache
def plain() -> Solved:
    return solve(case_of())


@cache
def mixed() -> Solved:
    rows = [BALLS, {**GEOMETRY, "position": 0.012}]
    known = {"viscosity_ratio": 1.5, "contamination": 0.4}
    return solve(case_of({"rows": rows}, life=known))


def test_reference_life_is_that_of_the_slices() -> None:
    """Summed here by hand: every slice of every roller, with the edge factor."""
    solved, found = plain(), life(plain())
    rollers = solved.rollers
    assert rollers is not None
    rating = float(found.ratings.dynamic[0, 0])
    races = roller_race_ratings(rating, 13, 7.5e-3, 39e-3, 0.0)
    risk = 0.0
    for line, whole, power in (
        (rollers.inner, races.inner, 4.0),
        (rollers.outer, races.outer, 4.5),
    ):
        for k, factor in enumerate(edge_factor(35)):
            loads = line.load_per_length[0, :, k] * 8.2e-3 / 35 * factor
            mean = np.mean(loads**power) ** (1.0 / power)
            risk += (mean / (float(whole) * 35 ** (-7.0 / 9.0))) ** 4.5
    assert found["iso16281"].basic[0] == pytest.approx(risk ** (-8.0 / 9.0), rel=1e-12)
    assert found.reference_load[0] == pytest.approx(
        rating * float(found["iso16281"].basic[0]) ** -0.3
    )
    assert found["iso281"].basic[0] == pytest.approx((rating / 4000.0) ** (10.0 / 3.0))


def test_result_names_rollers_and_slices() -> None:
    found = life(plain())
    mapping = json.loads(json.dumps(found.to_mapping()))
    assert mapping["slices"] == 35
    assert found.headline.element == "roller"
    refused = found["ioannides_harris"]
    assert not refused.valid[0]
    assert np.isnan(refused.life[0])
    assert "theory_of_balls" in [note.key for note in refused.notes_of()]
    texts = [note.text for own in found.theories.values() for note in own.notes_of()]
    assert texts
    assert not any(" ball " in text for text in texts)


def test_a_ring_without_load_names_rollers() -> None:
    found = life(solve(case_of(duty={"load": {"fz": 0.0}})))["iso16281"]
    assert "No roller transmits load" in found.notes_of()[0].text


@pytest.mark.parametrize("profile", ["none", "iso"])
def test_tilt_costs_life_and_a_profile_saves_it(profile: str) -> None:
    lives = [
        float(
            life(
                solve(case_of({**GEOMETRY, "roller_profile": profile}, duty=tilted)),
                stress_volume=False,
            )["iso16281"].basic[0]
        )
        for tilted in ({}, {"displacement": {"ry": 1e-3}}, {"displacement": {"ry": 3e-3}})
    ]
    assert lives == sorted(lives, reverse=True)
    if profile == "none":
        assert lives[2] < 0.15 * lives[0]
    else:
        assert lives[2] > 0.2 * lives[0]


def test_what_helps_a_tilted_straight_roller() -> None:
    bearing = {**GEOMETRY, "roller_profile": "none"}
    changes = sensitivity(solve(case_of(bearing, duty={"displacement": {"ry": 2e-3}})))
    ratios = {change.name: change.life_ratio for change in changes}
    assert ratios["profiled_rollers"] > 1.5
    assert ratios["less_tilt"] > 1.5
    assert changes[0].name in ("profiled_rollers", "less_tilt")
    assert all(change.note.text != change.name for change in changes)
    assert not {"profiled_rollers", "less_tilt"} & {c.name for c in sensitivity(plain())}


def test_set_of_balls_and_rollers() -> None:
    """Σ (t/L)^e = 1 over all races, each with its slope; no P, and no C of the set."""
    found = life(mixed(), stress_volume=False)
    reference = found.reference
    assert reference.slope == pytest.approx([SLOPE, ROLLER_SLOPE])
    races = np.concatenate([reference.inner, reference.outer], axis=1)
    assert np.sum((reference.life[0] / races[0]) ** reference.race_slopes) == pytest.approx(1.0)
    assert np.isnan(found.ratings.dynamic_of_set[0])
    assert not np.isnan(found.ratings.dynamic).any()
    assert found["iso16281"].valid[0]
    assert not found["iso281"].valid[0]
    modified = found["iso16281_modified"]
    # the whole is modified by something between what its rows are modified by
    alone = []
    for index, rollers in enumerate((False, True)):
        own = found.reference.row[0, index]
        assert own > found.reference.life[0], rollers
        alone.append(own)
    assert 0.1 < modified.factors["a_iso"][0] < 50.0
    assert found.limit.share[0] <= 1.0
    assert found.headline.element == "element"
    ratings = found.to_mapping()["ratings"]
    assert ratings["dynamic"] is None
    assert [row["dynamic"] for row in ratings["rows"]] == found.ratings.dynamic[0].tolist()
    assert ratings["sources"]["dynamic"] == "rows"


def test_one_rating_does_not_hold_for_balls_and_rollers() -> None:
    with pytest.raises(InputError, match="designation"):
        life(mixed(), replace(life(mixed()).conditions, dynamic_rating=2e4))


def test_rows_of_rollers_share_a_load() -> None:
    """C of two equal rows is 2^(7/9) that of one, and so is the life of twice the load."""
    one = life(solve(case_of(duty={"load": {"fz": 2000.0}})), stress_volume=False)
    pair = life(
        solve(case_of({**GEOMETRY, "arrangement": "DT", "spacing": 0.02})), stress_volume=False
    )
    ratio = pair.ratings.dynamic_of_set[0] / one.ratings.dynamic_of_set[0]
    assert ratio == pytest.approx(2.0 ** (7.0 / 9.0))
    # both rows at half of the load each: (2 L^-e)^(-1/e) of one
    expected = one["iso16281"].basic[0] * 2.0 ** (-1.0 / ROLLER_SLOPE)
    assert pair["iso16281"].basic[0] == pytest.approx(expected, rel=1e-6)


def test_lives_with_different_slices_are_not_put_together() -> None:
    finer = case_of(model={"slices": 51})
    with pytest.raises(InputError, match="35, 51"):
        life_of_shaft([case_of(), finer])
    both = life_of_shaft([case_of(), case_of()])
    hours = both.headline.bearing_hours
    assert both.headline.hours == pytest.approx(hours[0] * 2.0 ** (-1.0 / ROLLER_SLOPE))
    assert slope_of("roller") == ROLLER_SLOPE
    assert slope_of("ball") == SLOPE


def test_ribs_of_a_designation() -> None:
    load = {"fz": 4000.0, "fx": 1500.0}
    solved = solve(case_of({"designation": "NJ 205"}, duty={"load": load}))
    ribs = life(solved, stress_volume=False).rib_load
    assert ribs is not None
    assert ribs.lubricant == "grease"
    assert 0.0 < ribs.permissible[0] <= min(ribs.nsk[0], ribs.skf[0])
    noted = life(solved, stress_volume=False)["iso16281"].notes_of()
    assert ("axial_load_above_permissible" in [note.key for note in noted]) == bool(
        ribs.exceeded[0]
    )
    assert ribs.exceeded[0]
    assert life(plain(), stress_volume=False).rib_load is None


def test_tapered_rollers_are_rated_by_their_outer_angle() -> None:
    tapered = {
        "element": "tapered",
        "roller_count": 17,
        "roller_diameter": 7.6e-3,
        "effective_length": 10.3e-3,
        "pitch_diameter": 46e-3,
        "contact_angle": np.radians(14.0),
        "roller_half_angle": np.radians(2.0),
    }
    found = life(solve(case_of(tapered, duty={"load": {"fz": 4000.0, "fx": 1200.0}})))
    assert found.ratings.kinds == ("roller",)
    assert found.loads.limit[0] == pytest.approx(1.5 * np.tan(np.radians(14.0)))
    assert found["iso281"].basic[0] > 0.0
    assert found["iso16281"].valid[0]


def test_geometry_outside_the_table_says_so() -> None:
    thick = {**GEOMETRY, "roller_count": 5, "roller_diameter": 15e-3}
    with pytest.raises(InputError, match=r"0\.30"):
        life(solve(case_of(thick)))


def test_curves_with_different_slices_are_not_compared() -> None:
    with pytest.raises(InputError, match="35, 51"):
        life_curves(
            [("", case_of()), ("fine", case_of(model={"slices": 51}))], "duty.load.fz=2..4kN"
        )


def test_a_study_does_not_compare_lives_over_slices() -> None:
    refuse_lifeless(case_of(), frozenset({"duty.load.fz"}))
    with pytest.raises(InputError, match="edge factor"):
        refuse_lifeless(case_of(), frozenset({"model.slices"}))
