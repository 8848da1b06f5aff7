"""The life that leads: its bounds, their reasons, and the same rule everywhere it is shown."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.one_case import keys

from rolamento import (
    Bearing,
    Case,
    Displacement,
    Duty,
    LifeModel,
    Load,
    Temperature,
    analyse,
    load_case,
    override,
)
from rolamento.document.terminal import terminal
from rolamento.life import (
    LifeConditions,
    LifeSummary,
    conditions_of,
    life,
    sensitivity,
)
from rolamento.life.record import BOUNDS, OUTSIDE
from rolamento.pages.life import life_page
from rolamento.pages.life_over import life_over_page
from rolamento.pages.life_spectrum import life_spectrum_page
from rolamento.pages.shaft import shaft_page
from rolamento.pages.state import state_page
from rolamento.solution import solve
from rolamento.studies.ranges import read_range
from rolamento.tasks.life import life_of_shaft
from rolamento.tasks.life_over import life_curve
from rolamento.tasks.life_spectrum import life_of_duty_spectrum, read_spectrum

CASE = load_case(Path(__file__).parents[2] / "src" / "rolamento" / "examples" / "6305_life.toml")
KNOWN = {"viscosity_ratio": 1.0, "contamination": 0.5}


def deep(clearance: float = 10e-6, **load: Any) -> Case:
    bearing = Bearing.named("6305").replace(diametral_clearance=clearance)
    return Case(bearing=bearing, duty=Duty(inner_speed=100.0, load=Load(**load)))


def of(case: Case, **conditions: Any) -> LifeSummary:
    given = conditions_of(case) if not conditions else LifeConditions(**conditions)
    return life(solve(case), given, stress_volume=False)


def set_to(*settings: str) -> Case:
    return override(CASE, settings)


# --- bounds -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("conditions", "factor", "reason"),
    [
        ({"viscosity_ratio": 0.0999, "contamination": 1.0}, 0.1, "viscosity_ratio_too_small"),
        ({"viscosity_ratio": 1e-9, "contamination": 0.3}, 0.1, "viscosity_ratio_too_small"),
        ({"viscosity_ratio": 2.0, "contamination": 0.0}, 0.1, "contamination_severe"),
        ({"viscosity_ratio": 0.05}, 0.1, "viscosity_ratio_too_small"),
        ({"contamination": 0.0}, 0.1, "contamination_severe"),
        ({"viscosity_ratio": 0.15}, None, "contamination_unknown"),
        ({"contamination": 0.01}, None, "viscosity_unknown"),
    ],
)
def test_a_bound_leads_with_its_reason(
    conditions: dict[str, Any], factor: float | None, reason: str
) -> None:
    found = of(deep(fz=4000.0), **conditions)
    leading, basic = found.headline, found["iso16281"].life[0]
    assert (leading.below[0], leading.valid[0], leading.reason[0]) == (True, False, reason)
    assert leading.theory[0] == "iso16281_modified"
    share = leading.life[0] / basic
    assert share == pytest.approx(factor) if factor else 0.1 < share < 1.0
    assert leading.factor[0] == pytest.approx(share)
    assert reason in BOUNDS


def test_what_is_half_known_and_good_leaves_the_basic_life() -> None:
    for conditions in ({"viscosity_ratio": 2.0}, {"contamination": 0.8}, {}):
        found = of(deep(fz=4000.0), **conditions)
        assert found.headline.theory[0] == "iso16281"
        assert found.headline.valid[0]
        assert found.headline.life[0] == found["iso16281"].life[0]


def test_a_class_without_viscosity_is_taken_with_the_thickest_film() -> None:
    case = deep(fz=4000.0).replace(life=LifeModel(grease_cleanliness="very_severe"))
    assert of(case).headline.reason[0] == "contamination_severe"


def test_the_reference_life_is_not_passed_by_what_knows_less() -> None:
    """A moment that ISO 281 does not know loads the balls beyond what the reference life is for."""
    found = of(deep(fz=8000.0, my=130.0), **KNOWN)
    assert "load_above_half_rating" in keys(found["iso16281"].notes_of())
    assert not found.headline.leads[0]
    assert found.headline.reason[0] in OUTSIDE - BOUNDS


def test_without_a_fatigue_load_limit_nothing_leads() -> None:
    balls = {"ball_count": 5, "ball_diameter": 0.02, "pitch_diameter": 0.045}  # beyond ISO 76
    outside = Bearing(**balls, inner_conformity=0.52, outer_conformity=0.53, contact_angle=0.0)
    case = Case(bearing=outside, duty=Duty(inner_speed=100.0, load=Load(fz=2000.0)))
    given = {"fatigue_load_limit": "estimate", "dynamic_rating": 20600.0}
    found = of(case, **KNOWN, **given)
    assert np.isnan(found.headline.life[0])
    assert found.headline.reason[0] == "no_fatigue_load_limit"
    thin = of(case, viscosity_ratio=0.05, contamination=0.5, **given)
    assert thin.headline.below[0]  # the bound needs no fatigue load limit


# --- no load, no force, moments, clearance ----------------------------------------------------


def test_no_load_no_life() -> None:
    """At speed the balls press on the outer race by their centrifugal force: no rating life."""
    found = of(deep(fz=0.0), **KNOWN)
    for record in (found.headline, *found.theories.values()):
        assert np.isnan(record.life[0])
        assert np.isnan(record.hours[0])
        assert not record.valid[0]
    assert found.headline.reason[0] == "unloaded"
    assert found.limit.ball[0] == -1
    assert "there is no rating life" in terminal(life_page(solve(deep(fz=0.0)), found))


def test_a_pure_moment_is_nothing_for_iso_281() -> None:
    found = of(deep(my=10.0), **KNOWN)
    for name in ("iso281", "iso281_modified"):
        assert np.isnan(found[name].life[0])
        assert "no_force" in keys(found[name].notes_of())
    assert found.headline.valid[0]
    assert np.isfinite(found.headline.life[0])


def test_a_moment_that_governs_is_nothing_for_iso_281() -> None:
    pitch = deep().bearing.pitch_diameter
    for share, governs in ((0.45, False), (0.55, True)):
        found = of(deep(fz=1000.0, my=share * 1000.0 * pitch), **KNOWN)
        assert ("moment_governs" in keys(found["iso281"].notes_of())) is governs
        assert ("moment_left_out" in keys(found["iso281"].notes_of())) is not governs
        assert found["iso281"].valid[0] != governs
        assert found["iso16281"].valid[0]


def test_a_preload_without_a_force_is_nothing_for_iso_281() -> None:
    held = Displacement(x=20e-6, y=0.0, z=0.0)
    single = Case(bearing=deep(-20e-6).bearing, duty=Duty(inner_speed=100.0, displacement=held))
    still = single.replace(duty=single.duty.replace(displacement=held.replace(x=0.0)))
    found = of(still, **KNOWN)
    assert "no_force" in keys(found["iso281"].notes_of())
    assert np.isnan(found["iso281"].life[0])
    assert np.isfinite(found["iso16281"].life[0])


@pytest.mark.parametrize(
    ("clearance", "told"), [(-60e-6, True), (0.0, False), (15e-6, False), (150e-6, True)]
)
def test_iso_281_tells_of_a_clearance_far_from_normal(clearance: float, told: bool) -> None:
    found = of(deep(clearance, fz=2000.0), **KNOWN)
    assert ("load_shared_otherwise" in keys(found["iso281"].notes_of())) is told
    ratio = found["iso281"].life[0] / found["iso16281"].life[0]
    assert (not 0.5 <= ratio <= 2.0) is told
    assert "load_shared_otherwise" not in keys(found["iso16281"].notes_of())


def test_a_light_load_is_told() -> None:
    for force, told in ((205.0, True), (207.0, False)):
        assert ("light_load" in keys(of(deep(fz=force))["iso281"].notes_of())) is told


@pytest.mark.parametrize("part", ["inner_ring", "outer_ring", "balls", "lubricant"])
def test_hot_parts_count(part: str) -> None:
    for kelvin, hot in ((392.15, False), (394.15, True)):
        case = deep(fz=2000.0).replace(temperature=Temperature(**{part: kelvin}))
        conditions = conditions_of(case)
        found = life(solve(case), conditions)
        if part == "lubricant":  # without an oil nothing is known of it
            assert conditions.temperature is None
            continue
        assert ("too_hot_for_steel" in keys(found["iso16281"].notes_of())) is hot
        assert found.headline.leads[0] != hot


def test_hot_rings_count_one_by_one_in_a_batch() -> None:
    case = deep(fz=2000.0)
    batch = solve(case, fz=[2000.0] * 3)
    hottest = replace(conditions_of(case), bearing_temperature=[300.0, 400.0, 420.0])
    found = life(batch, hottest)
    assert found.headline.leads.tolist() == [True, False, False]


def test_a_mounted_bearing_keeps_the_temperatures_of_its_rings() -> None:
    hot = set_to("temperature.inner_ring=130 degC", "temperature.outer_ring=120 degC")
    assert of(hot).headline.reason[0] == "too_hot_for_steel"


# --- one rule everywhere ----------------------------------------------------------------------


@pytest.mark.parametrize("ratio", [0.05, 0.099, 1.0])
def test_what_would_help_is_judged_or_not_named(ratio: float) -> None:
    state = solve(set_to(f"life.viscosity_ratio={ratio}"))
    changes = {change.name: change.life_ratio for change in sensitivity(state)}
    judged = ratio >= 0.1
    assert all(np.isfinite(value) is np.bool_(judged) for value in changes.values())
    text = terminal(life_page(state, life(state), sensitivity(state)))
    assert ("would help" in text) is judged


def test_a_change_into_a_bound_is_not_judged() -> None:
    """Thicker oil from just above the end is judged; nothing that ends in a bound is."""
    state = solve(set_to("duty.load.fz=13 kN", "life.viscosity_ratio=1"))
    assert all(np.isnan(change.life_ratio) for change in sensitivity(state))


def test_a_curve_has_the_same_rule() -> None:
    curve = life_curve(CASE, read_range("life.viscosity_ratio=0.02..2", 12, log=True))
    for point, ratio in enumerate(curve.values):
        alone = of(set_to(f"life.viscosity_ratio={float(ratio)!r}")).headline
        assert curve.headline.hours[point] == pytest.approx(alone.hours[0])
        assert curve.headline.below[point] == alone.below[0]
        assert curve.headline.reason[point] == alone.reason[0]
    text = terminal(life_over_page([curve]))
    assert "<917" in text
    assert "< the life is below the number" in text


def test_a_curve_shows_a_bound_that_is_no_theory() -> None:
    dirty = CASE.replace(life=LifeModel(), lubricant=None)
    curve = life_curve(dirty, read_range("life.contamination=0..0.5", 6))
    assert curve.headline.below[0]
    lines = terminal(life_over_page([curve])).splitlines()
    assert any("leading" in line for line in lines[:8])
    assert any("<917" in line for line in lines)


def test_a_spectrum_has_the_same_rule(tmp_path: Path) -> None:
    file = tmp_path / "steps.csv"
    file.write_text("share,life.viscosity_ratio\n0.5,1\n0.5,0.05\n", encoding="utf-8")
    duty = life_of_duty_spectrum(CASE, read_spectrum(str(file)))
    leading = duty.headline
    parts = [of(set_to(f"life.viscosity_ratio={ratio}")).headline.hours[0] for ratio in (1, 0.05)]
    assert leading.hours == pytest.approx(2.0 / sum(1.0 / part for part in parts))
    assert (leading.below, leading.valid) == (True, False)
    text = " ".join(terminal(life_spectrum_page(duty)).split())
    assert "this duty reaches less than" in text
    assert "in some of the steps the standard only bounds the life" in text
    assert "Reliability at the required 5000 h: below" in text


def test_an_idle_step_does_no_damage(tmp_path: Path) -> None:
    file = tmp_path / "steps.csv"
    file.write_text("share,duty.load.fz,duty.load.fx\n0.5,2 kN,0.4 kN\n0.5,0 N,0 N\n", "utf-8")
    duty = life_of_duty_spectrum(CASE, read_spectrum(str(file)))
    assert duty.headline.hours == pytest.approx(2.0 * of(CASE).headline.hours[0])
    assert duty.headline.damage.tolist() == pytest.approx([1.0, 0.0])
    assert duty.headline.valid
    assert np.isnan(duty.headline.steps.hours[1])
    assert duty["iso16281"].valid
    file.write_text("share,duty.load.fz,duty.load.fx\n1,0 N,0 N\n", "utf-8")
    idle = life_of_duty_spectrum(CASE, read_spectrum(str(file)))
    assert not idle.headline.valid
    assert not idle.headline.below


def test_a_shaft_has_the_same_rule() -> None:
    """Of a bearing with thin oil, and one of whose oil nothing is known."""
    thin = set_to("life.viscosity_ratio=0.05").replace(title="thin")
    plain = CASE.replace(life=LifeModel(), lubricant=None, title="plain")
    found = life_of_shaft([thin, plain])
    hours = [of(case).headline.hours[0] for case in (thin, plain)]
    assert found.headline.bearing_hours == pytest.approx(hours)
    assert found.headline.theories == ("iso16281_modified", "iso16281")
    assert (found.headline.below, found.headline.valid) == (True, False)
    assert found.headline.hours < min(hours)
    text = " ".join(terminal(shaft_page(found, ["thin", "plain"])).split())
    assert "the 2 bearings together reach less than" in text


def test_a_bound_of_the_life_bounds_the_reliability() -> None:
    found = of(set_to("life.viscosity_ratio=0.05"))
    wanted = found.to_mapping()["required_life"]
    assert wanted["upper_bound"]
    assert wanted["reliability"] == pytest.approx(0.239, abs=5e-4)
    assert found.to_mapping()["headline"]["reason"]["key"] in BOUNDS


def test_the_report_of_a_state_has_the_same_rule() -> None:
    def report(*settings: str) -> str:
        found = analyse(set_to(*settings))
        return terminal(state_page(found.solved, found))

    thin = report("life.viscosity_ratio=0.05")
    assert "reaches less than 917 h" in " ".join(thin.split())
    assert "ISO/TS 16281, modified: <917 h" in " ".join(thin.split())
    idle = report("duty.load.fz=0 N", "duty.load.fx=0 N")
    section = idle.split("\nLife\n")[1].split("\n\n")[0]
    assert "there is no rating life" in " ".join(section.split())
