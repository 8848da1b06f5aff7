"""A mounted bearing in a batch: each case runs with the clearance of its own temperatures."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from tests.one_case import solve_one

from rolamento import Case, InputError, parse_case
from rolamento.case.varied import batch_fields
from rolamento.clearance import MOUNTED_FIELDS, clearance_of_case, operating_batch
from rolamento.life import life
from rolamento.solution import solve
from rolamento.studies import Axis, Study, run

DEEP = """
lubricant = "ISO VG 68"
[bearing]
designation = "6305/C3"
[duty]
inner_speed = "2000 rpm"
[duty.load]
fz = "4 kN"
[temperature]
lubricant = "70 degC"
inner_ring = "75 degC"
outer_ring = "68 degC"
[mounting]
shaft_tolerance = "k5"
housing_tolerance = "J7"
housing_outside_diameter = "100 mm"
shaft_bore = "5 mm"
"""
ANGULAR = """
[bearing]
ball_count = 16
ball_diameter = "22.23 mm"
pitch_diameter = "125.26 mm"
contact_angle = "40 deg"
inner_conformity = 0.5232
outer_conformity = 0.5232
[duty]
inner_speed = "6000 rpm"
[duty.load]
fx = "10 kN"
fz = "2 kN"
[temperature]
inner_ring = "60 degC"
outer_ring = "50 degC"
[mounting]
bore = "90 mm"
outside_diameter = "160 mm"
shaft_interference = "0.02 mm"
housing_interference = "-0.01 mm"
housing_outside_diameter = "220 mm"
"""
VALUES = {
    "temperature.inner_ring": (303.0, 345.0, 380.0),
    "temperature.outer_ring": (303.0, 335.0, 350.0),
    "temperature.balls": (303.0, 340.0, 370.0),
    "temperature.shaft": (303.0, 340.0, 390.0),
    "temperature.housing": (303.0, 330.0, 340.0),
    "mounting.shaft_interference": (-2e-6, 5e-6, 15e-6),
    "mounting.housing_interference": (-2e-6, 2e-6, 5e-6),
    "mounting.shaft_bore": (0.0, 0.010, 0.015),
    "mounting.housing_outside_diameter": (0.2, 0.25, 0.3),
    "mounting.shaft_roughness": (0.0, 2e-6, 6e-6),
    "mounting.housing_roughness": (0.0, 2e-6, 6e-6),
    "mounting.ring_expansion": (11e-6, 12e-6, 13e-6),
    "mounting.ball_expansion": (3e-6, 8e-6, 12e-6),
    "mounting.assembly_temperature": (283.0, 293.0, 303.0),
    "mounting.wear": (0.0, 5e-6, 10e-6),
    "duty.inner_speed": (0.0, 200.0, 900.0),
    "bearing.ball_diameter": (0.9999, 1.0, 1.0001),
    "bearing.inner_conformity": (0.515, 0.52, 0.53),
}


def changed(case: Case, name: str, value: float) -> Case:
    """The case with one number changed, the rival that it replaces gone."""
    return case.with_({name: float(value)})


@pytest.mark.parametrize("text", [DEEP, ANGULAR], ids=["6305", "218"])
@pytest.mark.parametrize("name", VALUES)
@pytest.mark.thirds
def test_each_case_is_as_solved_alone(text: str, name: str) -> None:
    case = parse_case(text)
    values = np.array(VALUES[name])
    if name == "bearing.ball_diameter":
        values = values * case.bearing.ball_diameter
    batch = solve(case, {name: values})
    for index, value in enumerate(values):
        state = solve_one(changed(case, name, value))
        assert state.status.converged
        assert batch.displacement.array[index] == pytest.approx(
            state.displacement, rel=1e-9, abs=1e-13
        )


def test_all_that_a_mounting_takes_is_tried_above() -> None:
    of_sets = {"temperature.inner_spacer", "temperature.outer_spacer"}  # test_mounted_sets.py
    assert set(MOUNTED_FIELDS) - of_sets <= set(VALUES)
    assert set(MOUNTED_FIELDS) <= set(batch_fields())


@pytest.mark.parametrize("limit", ["minimum", "mean", "maximum"])
def test_the_limit_that_the_mounting_names(limit: str) -> None:
    case = parse_case(DEEP, overrides=[f"mounting.limit={limit}"])
    _, fields = operating_batch(case, {"duty.load.fz": np.array([1e3, 2e3])})
    expected = getattr(clearance_of_case(case), limit)
    assert fields["bearing.diametral_clearance"] == pytest.approx(expected, rel=1e-12)


def test_a_bearing_that_its_fits_close_is_that_cases_affair() -> None:
    case = parse_case(DEEP)
    batch = solve(case, {"mounting.shaft_interference": [5e-6, 900e-6]})
    assert list(batch.status.code) == ["converged", "invalid_input"]
    assert np.all(np.isnan(batch.displacement.array[1]))
    batch = solve(parse_case(ANGULAR), {"mounting.shaft_interference": [5e-6, 900e-6]})
    assert list(batch.status.code) == ["converged", "invalid_input"]


@pytest.mark.parametrize(
    ("name", "value"),
    [("mounting.shaft_bore", 0.03), ("mounting.housing_outside_diameter", 0.05)],
)
def test_a_size_that_the_mounting_would_refuse_is_not_solved(name: str, value: float) -> None:
    batch = solve(parse_case(DEEP), {name: [value]})
    assert list(batch.status.code) == ["invalid_input"]


@pytest.mark.parametrize(
    ("text", "values", "field"),
    [
        (DEEP, {"bearing.diametral_clearance": [1e-5]}, "mounting.clearance_class"),
        (DEEP, {"bearing.ball_diameter": [0.0103]}, "mounting.measured_clearance"),
        (DEEP, {"temperature.inner_ring": [350.0]}, "temperature.outer_ring"),
    ],
    ids=["class", "reading", "one ring"],
)
def test_what_does_not_go_together(text: str, values: dict[str, Any], field: str) -> None:
    extra = {
        "mounting.clearance_class": 'clearance_class = "C3"',
        "mounting.measured_clearance": 'measured_clearance = "0.026 mm"',
    }.get(field, "")
    case = parse_case(text + extra)
    if field.startswith("temperature"):
        case = case.replace(temperature={"lubricant": 340.0})
    with pytest.raises(InputError) as error:
        solve(case, values)
    assert error.value.field == field


def test_without_a_mounting_there_is_nothing_to_vary() -> None:
    case = parse_case(DEEP).replace(mounting=None, temperature=None)
    with pytest.raises(InputError, match="takes effect through"):
        solve(case, {"temperature.inner_ring": [350.0]})


def test_its_own_clearance_may_vary() -> None:
    case = parse_case(DEEP, overrides=["bearing.diametral_clearance=0.02 mm"])
    _, fields = operating_batch(case, {"bearing.diametral_clearance": np.array([10e-6, 20e-6])})
    change = np.diff(fields["bearing.diametral_clearance"])
    assert change == pytest.approx(10e-6, rel=2e-3)  # the seats' diameters change a little


def test_a_study_over_the_temperature_of_a_ring_finds_film_and_life() -> None:
    """A hotter inner ring takes the clearance; a little preload is the best of it."""
    case = parse_case(DEEP)
    warm = [335.0, 345.0, 355.0]
    study = Study(
        case=case,
        axes=[Axis(field="temperature.inner_ring", values=warm)],
        outputs=["z", "viscosity_ratio"],
    )
    dataset = run(study)
    assert np.all(np.diff(dataset["z"].values) < 0.0)
    assert np.ptp(dataset["viscosity_ratio"].values) < 1e-3  # the pitch circle grows
    lives = life(solve(case, {"temperature.inner_ring": warm})).headline.hours
    alone = [
        life(
            solve(changed(case, "temperature.inner_ring", one)), stress_volume=False
        ).headline.hours[0]
        for one in warm
    ]
    assert lives == pytest.approx(alone, rel=1e-9)
