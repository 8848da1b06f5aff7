"""Life as outputs of studies: the numbers, every field as an axis, and what a case must have."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

from rolamento import Bearing, Case, Duty, InputError, Load
from rolamento.case.life_model import TallianFactors
from rolamento.catalogue import ambiguity_axis, geometry_of
from rolamento.life import LifeSummary, life
from rolamento.solution import solve
from rolamento.studies import Axis, Distribution, Scatter, Study, parse_study, run, study_to_json
from rolamento.studies.fields import known_fields
from rolamento.studies.outputs import catalogue
from rolamento.studies.solving import array_fields, base_case
from rolamento.studies.tolerance import tolerance_bands

HOUR = 3600.0
DUTY = Duty(inner_speed=200.0, load=Load(fx=500.0, fz=3000.0))
OIL = {"lubricant": "ISO VG 68", "temperature": {"lubricant": 343.15}}
TABLE = {
    "cleanliness": "-/17/14",
    "oil_supply": "circulating",
    "required_life": 1000.0 * HOUR,
    "operation_factor": 0.9,
    "nsk_cleanliness": 0.8,
    "tallian_subsurface": {"defect_density": 0.8},
}
FZ = (1000.0, 3000.0, 12_000.0)
LIVES = tuple(
    name
    for name, output in catalogue().items()
    if "life" in output.needs and "duty.oscillation" not in output.needs
)
SINGLE = {
    "reliability": (0.9, 0.95, 0.999),
    "required_life": (500.0 * HOUR, 5000.0 * HOUR),
    "dynamic_rating": (15e3, 20.6e3),
    "static_rating": (9e3, 12e3),
    "fatigue_load_limit": (400.0, 600.0),
    "fatigue_load_method": ("contacts", "estimate"),
    "contamination": (0.1, 1.0),
    "grease_cleanliness": ("high", "severe"),
    "additives": (False, True),
    "viscosity_ratio": (0.3, 2.0),
    "rotating_load": (False, True),
    "edition": ("2007", "1990"),
    "material_factor": (1.0, 1.2),
    "operation_factor": (0.7, 0.9),
    "fatigue_limit": (300e6, 374e6),
    "depth": ("local", "mean"),
    "nsk_cleanliness": (0.5, 0.8),
    "tallian_subsurface.strength": (1e-97, 2e-97),
    "tallian_subsurface.defect_shape": (1.0, 2.0),
    "tallian_subsurface.defect_density": (0.5, 1.0),
    "tallian_subsurface.exponent": (1.0, 1.5),
}
TOGETHER = (
    {"cleanliness": ("-/15/12", "-/19/16"), "oil_supply": ("circulating", "bath")},
    {"filter_size": (6e-6, 25e-6), "filter_ratio": (200.0, 75.0)},
)
SURFACE = {
    f"tallian_{origin}.{name}"
    for origin, names in (
        ("subsurface", ("failure_rate", "pressure_distribution")),
        ("surface", TallianFactors.model_fields),
    )
    for name in names
}
"""Factors that go together, and not without each other."""
MOVES = {
    "fatigue_load_limit": "life_hours",
    "required_life": "required_life_reliability",
    "static_rating": "static_safety",
    "fatigue_limit": "life_hours_ioannides_harris",
    "depth": "life_hours_ioannides_harris",
    "nsk_cleanliness": "life_hours_l_able",
    "material_factor": "life_hours_iso281_1990",
    "operation_factor": "life_hours_iso281_1990",
    **dict.fromkeys((name for name in SINGLE if "tallian" in name), "life_hours_tallian"),
}
"""Which output each field changes, where it is not the life."""
MATTERS = {
    "additives": {"viscosity_ratio": 0.5, "contamination": 0.5},
    "edition": {**TABLE, "reliability": 0.95},
}
"""Where a field changes it, if not in the case at hand."""


@pytest.fixture(scope="module")
def case() -> Case:
    return Case(bearing=Bearing.named("6305/C3"), duty=DUTY, life=TABLE, **OIL)


def over(case: Case, field: str, values: tuple[Any, ...], *outputs: str) -> Study:
    return Study(case=case, outputs=outputs, axes=(Axis(field=field, values=values),))


def alone(case: Case, **changes: Any) -> LifeSummary:
    """Life of one case by itself, some of its fields changed (``__`` for a dot)."""
    return life(solve(base_case(case, {name.replace("__", "."): v for name, v in changes.items()})))


def risk(lives: np.ndarray[Any, Any]) -> float:
    return float(np.sum(lives ** (-10.0 / 9.0)))


def numbers(summary: LifeSummary) -> dict[str, float]:
    """What the outputs ought to be, from the summary of a single case."""
    best, limit = summary.headline, summary.limit
    found: dict[str, Any] = {
        "dynamic_rating": summary.ratings.dynamic_of_set,
        "static_rating": summary.ratings.static_of_set,
        "fatigue_load_limit": summary.ratings.fatigue_of_set,
        "equivalent_load": summary.loads.dynamic,
        "reference_load": summary["iso16281"].factors["equivalent_load"],
        "static_equivalent_load": summary.loads.static,
        "static_safety": summary.loads.safety,
        "rating_over_load": summary.ratings.dynamic_of_set / summary.loads.dynamic,
        "weakest_race_share": limit.share,
        "weakest_row": limit.row,
        "weakest_ball": limit.ball,
        "inner_risk_share": risk(summary.reference.inner)
        / (risk(summary.reference.inner) + risk(summary.reference.outer)),
    }
    for name, record in (("", best), *((f"_{n}", one) for n, one in summary.theories.items())):
        found[f"life_hours{name}"] = record.hours
        found[f"life_revolutions{name}"] = record.life
        found[f"life_valid{name}"] = record.valid
    found["life_upper_bound"] = best.below
    if summary.contamination_factor is not None:
        found["contamination_factor"] = summary.contamination_factor
        for standard in ("iso281", "iso16281"):
            factor = summary[f"{standard}_modified"].factors["a_iso"]
            found[f"modification_factor_{standard}"] = factor
    if summary.conditions.required_life is not None:
        found["required_life_reliability"] = summary.reliability_after(
            summary.conditions.required_life
        )
    return {name: float(np.ravel(value)[0]) for name, value in found.items()}


def check(found: Any, place: int, expected: dict[str, float]) -> None:
    for name in set(found.data_vars) - {"status"}:
        value = float(found[name].values[place])
        assert value == pytest.approx(expected[name], rel=1e-6, nan_ok=True), name


def test_outputs_are_those_of_the_cases(case: Case) -> None:
    found = run(over(case, "duty.load.fz", FZ, *LIVES))
    for place, fz in enumerate(FZ):
        expected = numbers(alone(case, duty__load__fz=fz))
        assert set(expected) == set(LIVES)
        check(found, place, expected)
    assert found["life_hours"].attrs["units"] == "h"
    assert found["life_revolutions_iso281"].attrs["units"] == "Mrev"
    assert found["life_valid_iso281"].values.tolist() == [1, 1, 0]
    assert np.isnan(found["life_hours_l_able"][2])
    revolutions = found["life_hours"] * 60.0 * 200.0 * 30.0 / np.pi * 1e-6
    np.testing.assert_allclose(found["life_revolutions"], revolutions, rtol=1e-12)


def test_every_field_of_the_life_is_accounted_for() -> None:
    known = {name.removeprefix("life.") for name in known_fields() if name.startswith("life.")}
    assert known == {*SINGLE, *(name for group in TOGETHER for name in group), *SURFACE}


@pytest.mark.parametrize("name", SINGLE)
def test_every_field_of_the_life_can_be_an_axis(case: Case, name: str) -> None:
    values = SINGLE[name]
    chosen = MOVES.get(name, "life_hours")
    case = case.replace(life=MATTERS.get(name, TABLE))
    found = run(over(case, f"life.{name}", values, chosen, "life_hours_iso281"))
    assert (found["status"] == 0).all()
    for place, value in enumerate(values):
        check(found, place, numbers_of(case, {f"life.{name}": value}))
    lives = found[chosen].values
    assert np.isfinite(lives).all()
    assert len(set(lives.tolist())) == len(values)


def numbers_of(case: Case, values: dict[str, Any]) -> dict[str, float]:
    return numbers(life(solve(base_case(case, values))))


@pytest.mark.parametrize("group", TOGETHER, ids=lambda group: next(iter(group)))
def test_fields_that_go_together_can_be_an_axis(case: Case, group: dict[str, Any]) -> None:
    zipped = {f"life.{name}": values for name, values in group.items()}
    found = run(Study(case=case, outputs=("life_hours",), axes=(Axis(zipped=zipped),)))
    for place in range(2):
        values = {name: column[place] for name, column in zipped.items()}
        check(found, place, numbers_of(case, values))
    assert found["life_hours"][0] > found["life_hours"][1]


def test_reliability_is_an_axis_though_no_array(case: Case) -> None:
    assert "life.reliability" not in array_fields()
    found = run(over(case, "life.reliability", (0.5, 0.9, 0.99), "life_hours", "life_hours_iso281"))
    assert (np.diff(found["life_hours"]) < 0.0).all()
    # ISO 281:2007, table 12: a_1 of 99 %
    ratio = float(found["life_hours_iso281"][2] / found["life_hours_iso281"][1])
    assert ratio == pytest.approx(0.25, abs=0.005)


def test_designation_is_an_axis(case: Case) -> None:
    names = ("6205", "6305", "6306/C3")
    found = run(over(case, "bearing.designation", names, "life_hours", "dynamic_rating"))
    assert (found["status"] == 0).all()
    for place, name in enumerate(names):
        check(found, place, numbers_of(case, {"bearing.designation": name}))
    assert (np.diff(found["dynamic_rating"]) > 0.0).all()
    assert (np.diff(found["life_hours"]) > 0.0).all()


def test_clearance_speed_and_temperature_are_axes(case: Case) -> None:
    for field, values in (
        ("bearing.diametral_clearance", (-5e-6, 0.0, 20e-6)),
        ("duty.inner_speed", (20.0, 200.0, 1000.0)),
        ("temperature.lubricant", (313.15, 343.15, 363.15)),
        ("bearing.ball_diameter", (10e-3, 11e-3)),
        ("bearing.outer_conformity", (0.52, 0.54)),
    ):
        found = run(over(case, field, values, "life_hours", "modification_factor_iso16281"))
        for place, value in enumerate(values):
            check(found, place, numbers_of(case, {field: value}))


def test_arrays_and_own_cases_go_together(case: Case) -> None:
    axes = (
        Axis(field="life.reliability", values=(0.9, 0.99)),
        Axis(field="life.contamination", values=(0.2, 0.8)),
        Axis(field="temperature.lubricant", values=(323.15, 353.15)),
    )
    found = run(Study(case=case, outputs=("life_hours",), axes=axes))
    for place in np.ndindex(2, 2, 2):
        values = {axis.field: axis.values[i] for axis, i in zip(axes, place, strict=True)}  # type: ignore[index]
        expected = numbers_of(case, values)["life_hours"]  # type: ignore[arg-type]
        assert float(found["life_hours"][place]) == pytest.approx(expected, rel=1e-6)


def test_scattered_values_out_of_bounds_poison_nothing(case: Case) -> None:
    law = Distribution(distribution="normal", mean=0.5, standard_deviation=0.4)
    scatter = Scatter(count=200, fields={"life.contamination": law})
    found = run(Study(case=case, outputs=("life_hours", "contamination_factor"), scatter=scatter))
    drawn, lives = found["contamination"].values, found["life_hours"].values
    outside = (drawn < 0.0) | (drawn > 1.0)
    assert 0 < outside.sum() < 150
    assert np.isnan(lives[outside]).all()
    assert np.isfinite(lives[~outside]).all()
    np.testing.assert_array_equal(found["contamination_factor"].values[~outside], drawn[~outside])
    order = np.argsort(drawn[~outside])
    assert (np.diff(lives[~outside][order]) >= 0.0).all()


def test_without_a_result_there_is_no_number(case: Case) -> None:
    found = run(over(case, "bearing.diametral_clearance", (13e-6, 0.1), *LIVES))
    assert found["status"].values.tolist()[0] == 0
    for name in LIVES:
        kind = catalogue()[name].kind
        assert np.isfinite(found[name][0]), name
        assert np.isnan(found[name][1]) if kind == "real" else found[name][1] == 0, name


def test_a_study_of_failures_alone_ends_well(case: Case) -> None:
    found = run(over(case, "bearing.diametral_clearance", (0.1, 0.2), "life_hours", "life_valid"))
    assert np.isnan(found["life_hours"]).all()
    assert (found["life_valid"] == 0).all()


def test_a_thrust_bearing_among_others_has_no_life(case: Case) -> None:
    bearing = Bearing.named("7218B")
    angular = case.replace(bearing=bearing, duty=Duty(inner_speed=100.0, load=Load(fx=5e3)))
    angles = (np.radians(25.0), np.radians(60.0))
    found = run(over(angular, "bearing.contact_angle", angles, "life_hours", "static_safety"))
    assert (found["status"] == 0).all()
    assert np.isfinite(found["life_hours"][0])
    assert np.isnan(found["life_hours"][1])
    assert np.isnan(found["static_safety"][1])
    # each a case of its own: a whole group without a life
    axes = (
        Axis(field="bearing.contact_angle", values=(np.radians(60.0),)),
        Axis(field="life.reliability", values=(0.9, 0.95)),
    )
    found = run(Study(case=angular, outputs=("life_hours",), axes=axes))
    assert np.isnan(found["life_hours"]).all()


def test_a_pair_has_the_life_of_the_pair() -> None:
    bearing = Bearing(
        ball_count=14, ball_diameter=0.0127, pitch_diameter=0.0675, contact_angle=0.4363,
        inner_conformity=0.52, outer_conformity=0.53, arrangement="DB", spacing=0.02,
        preload={"force": 300.0},
    )  # fmt: skip
    pair = Case(bearing=bearing, duty=DUTY, life={"viscosity_ratio": 1.0, "contamination": 0.5})
    names = [
        name
        for name in LIVES
        if not name.endswith(("1990", "l_able", "harris", "reliability", "tallian"))
    ]
    found = run(over(pair, "duty.load.fz", FZ[:2], *names))
    for place, fz in enumerate(FZ[:2]):
        check(found, place, numbers(alone(pair, duty__load__fz=fz)))
    assert (found["inner_risk_share"] > 0.5).all()


def test_the_ambiguity_of_an_inside_is_a_band_of_life() -> None:
    inside = geometry_of("6815")
    case = Case(bearing=Bearing.named("6815"), duty=Duty(inner_speed=100.0, load=Load(fz=4000.0)))
    axis = Axis(**ambiguity_axis(inside.candidates))
    assert axis.size > 1
    outputs = ("life_hours_iso281", "life_hours_iso16281", "dynamic_rating")
    found = run(Study(case=case, outputs=outputs, axes=(axis,)))
    assert (found["status"] == 0).all()
    # the published rating is the same whatever the balls; where each ball bears, it is not
    for name in ("dynamic_rating", "life_hours_iso281"):
        assert np.ptp(found[name].values) <= 1e-9 * float(found[name][0])
    lives = found["life_hours_iso16281"]
    assert 1.0001 < float(lives.max() / lives.min()) < 1.2
    for place, one in enumerate(inside.candidates[: axis.size]):
        values = {
            f"bearing.{name}": getattr(one, name)
            for name in ("ball_count", "ball_diameter", "pitch_diameter")
        }
        expected = numbers_of(case, values)["life_hours_iso16281"]
        assert float(lives[place]) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize(
    ("output", "changes", "words"),
    [
        ("life_hours", {"bearing": "plain", "life": None}, "needs a designation"),
        ("static_safety", {"bearing": "plain", "life": None}, "needs a designation"),
        ("life_hours_iso281_modified", {"lubricant": None}, "needs a viscosity ratio"),
        ("contamination_factor", {"temperature": None}, "needs a viscosity ratio"),
        ("modification_factor_iso281", {"life": None}, "needs the cleanliness"),
        ("life_valid_iso281_1990", {"life": None}, "material factor or an operation factor"),
        ("life_revolutions_l_able", {"life": None}, "the maker's cleanliness factor"),
        ("required_life_reliability", {"life": {"reliability": 0.95}}, "the required life"),
    ],
)
def test_what_an_output_needs_is_asked_for(
    case: Case, output: str, changes: dict[str, Any], words: str
) -> None:
    if changes.get("bearing") == "plain":
        inside = geometry_of("6305/C3").fields
        changes = {**changes, "bearing": Bearing(**inside)}
    with pytest.raises(InputError, match=words) as caught:
        over(case.replace(**changes), "duty.load.fz", FZ, output)
    assert caught.value.field == "outputs"
    assert output in str(caught.value)


def test_a_case_that_can_have_no_life_is_refused(case: Case, bearing_218: Bearing) -> None:
    steep = case.replace(bearing=bearing_218.replace(contact_angle=np.radians(60.0)))
    with pytest.raises(InputError, match="is above 45°: such a bearing is rated for axial load"):
        over(steep, "duty.load.fx", FZ, "life_hours")
    plain = {"ball_count": 3, "ball_diameter": 0.03, "pitch_diameter": 0.06}
    groove = {"diametral_clearance": 1e-5, "inner_conformity": 0.52, "outer_conformity": 0.53}
    odd = case.replace(bearing=Bearing(**plain, **groove))
    with pytest.raises(
        InputError, match="is missing: the geometry is outside the table of the"
    ) as caught:
        over(odd, "duty.load.fz", FZ, "life_hours")
    assert caught.value.field.endswith("life.dynamic_rating")
    rated = odd.replace(life={**TABLE, "dynamic_rating": 30e3})
    assert np.isfinite(run(over(rated, "duty.load.fz", FZ, "life_hours"))["life_hours"]).all()
    found = run(over(odd, "life.dynamic_rating", (20e3, 30e3), "life_hours_iso281"))
    ratio = float(found["life_hours_iso281"][1] / found["life_hours_iso281"][0])
    assert ratio == pytest.approx(1.5**3)


def test_what_varies_counts_as_given() -> None:
    bare = Case(bearing=Bearing.named("6305"), duty=DUTY)
    axes = (
        Axis(field="life.viscosity_ratio", values=(0.5, 2.0)),
        Axis(field="life.contamination", values=(0.2, 0.9)),
        Axis(field="life.required_life", values=("100 h", "1000 h")),
    )
    outputs = ("life_hours_iso281_modified", "required_life_reliability")
    found = run(Study(case=bare, outputs=outputs, axes=axes))
    assert np.isfinite(found["life_hours_iso281_modified"]).all()
    assert (found["required_life_reliability"].diff("required_life") <= 0.0).all()
    assert (
        (found["required_life_reliability"] > 0.0) & (found["required_life_reliability"] <= 1.0)
    ).all()


def test_a_study_file_names_them(case: Case) -> None:
    study = over(case, "duty.load.fz", FZ, "life_hours", "rating_over_load")
    text = study_to_json(study)
    assert parse_study(text, format="json").outputs == study.outputs
    assert "life_hours" in json.loads(text)["outputs"]


def test_a_mounted_bearing_lives_with_its_clearance_in_operation(case: Case) -> None:
    mounted = case.replace(
        mounting={"shaft_tolerance": "k5", "housing_tolerance": "J7"},
        temperature={"lubricant": 343.15, "inner_ring": 343.15, "outer_ring": 338.15},
    )
    warm = (338.15, 358.15)
    found = run(over(mounted, "temperature.inner_ring", warm, "life_hours", "life_hours_iso281"))
    assert (found["status"] == 0).all()
    for place, value in enumerate(warm):
        check(found, place, numbers_of(mounted, {"temperature.inner_ring": value}))
    assert found["life_hours"][0] != found["life_hours"][1]
    assert found["life_hours_iso281"][0] == found["life_hours_iso281"][1]


def test_an_endless_life_is_no_failure_and_in_no_percentile(case: Case) -> None:
    law = Distribution(distribution="uniform", minimum=20.0, maximum=2000.0)
    scatter = Scatter(count=60, fields={"duty.load.fz": law})
    light = case.replace(duty=Duty(inner_speed=200.0, load=Load(fz=100.0)))
    name = "life_hours_ioannides_harris"
    found = run(Study(case=light, outputs=(name, "life_hours"), scatter=scatter))
    assert (found["status"] == 0).all()
    endless = np.isinf(found[name].values)
    assert 0 < endless.sum() < 30
    bands = tolerance_bands(found, (5.0, 50.0, 95.0))
    assert bands[name].count == 60 - endless.sum()
    assert np.isfinite(bands[name].percentile).all()
