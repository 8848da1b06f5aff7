"""The outputs of a study are those of the state of each case."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento import Case, Displacement, Duty, Load, Lubricant
from rolamento.case.duty import AXES, LOADS
from rolamento.errors import UnknownKeyError
from rolamento.geometry import Race
from rolamento.solution import solve
from rolamento.studies.bearing_outputs import maximum_pressure
from rolamento.studies.outputs import DEFAULT_OUTPUTS, Evaluation, catalogue, outputs_of

FX = np.array([20e3, 5e3, -20e3])
"""Many balls loaded, few, and no equilibrium."""


@pytest.fixture(scope="module")
def given(case_218: Case) -> Evaluation:
    oil = Lubricant.named("ISO VG 68").replace(friction_coefficient=0.08)
    roughness = dict.fromkeys(("inner_roughness", "outer_roughness", "ball_roughness"), 1e-7)
    life = dict.fromkeys(("contamination", "nsk_cleanliness", "operation_factor"), 0.8)
    case = case_218.replace(
        lubricant=oil,
        temperature={"lubricant": 343.15},
        surface=roughness,
        electrical={"voltage": 10.0, "current": 0.5},
        life={**life, "required_life": 3.6e7, "tallian_subsurface": {}},
        heat={
            "bore": 0.09,
            "outside_diameter": 0.16,
            "width": 0.03,
            "shaft_ambient": 200.0,
            "housing_ambient": 200.0,
        },
    )
    return Evaluation(solve(case, {"duty.load.fx": FX}))


@pytest.fixture(scope="module")
def values(given: Evaluation) -> dict[str, np.ndarray]:
    return {name: output.compute(given) for name, output in catalogue().items()}


def test_every_output_has_a_unit_a_name_and_its_shape(values: dict[str, np.ndarray]) -> None:
    for name, output in catalogue().items():
        assert output.name == name
        assert output.unit
        assert output.long_name
        assert values[name].shape == {"": (3,), "ball": (3, 16), "row": (3, 1)}[output.along], name


def test_no_number_without_a_result(values: dict[str, np.ndarray]) -> None:
    for name, output in catalogue().items():
        if name in ("azimuth", "residual") or output.kind == "whole":
            continue
        if {"bearing.preload", "bearing.designation", "duty.oscillation", "rollers"} & set(
            output.needs
        ):  # which a row of balls that turns has not
            continue
        if name.startswith(("grease_", "relubrication_")):  # of sealed ones, of known sizes
            continue
        assert np.isnan(values[name][2]).all(), name
        under_friction_control = "friction control" in output.needs
        if "spin" not in name and name not in ("ry", "rz") and not under_friction_control:
            assert not np.isnan(values[name][:2]).all(), name


def test_the_ring_is_that_of_solve(case_218: Case, values: dict[str, np.ndarray]) -> None:
    state = solve(case_218.replace(duty=Duty(inner_speed="10000 rpm", load=Load(fx=20e3))))
    two = Evaluation(solve(case_218, {"duty.load.fx": [20e3] * 2, "duty.load.fz": 0.0}))
    values = {name: output.compute(two) for name, output in catalogue().items() if not output.needs}
    for axis in AXES:
        expected = float(getattr(state.displacement, axis)[0])
        assert values[axis][0] == pytest.approx(expected, abs=1e-12)
    for load in LOADS:
        assert values[load][0] == pytest.approx(float(getattr(state.load, load)[0]), abs=1e-5)
    stiffness = state.stiffness.array[0]
    for i, one in enumerate(AXES):
        for j, other in enumerate(AXES):
            scale = (abs(stiffness[i][i]) * abs(stiffness[j][j])) ** 0.5
            assert abs(values[f"stiffness_{one}{other}"][0] - stiffness[i, j]) < 1e-7 * scale


@pytest.mark.parametrize("race", ["inner", "outer"])
@pytest.mark.parametrize(
    "name",
    [
        "load", "contact_angle", "deflection", "semi_major", "semi_minor", "max_pressure",
        "mean_pressure", "spin_to_roll",
    ],
)  # fmt: skip
def test_contacts_are_those_of_solve(
    case_218: Case, values: dict[str, np.ndarray], race: Race, name: str
) -> None:
    contacts = solve(case_218).contacts[race]
    expected = getattr(contacts, name)[0]
    assert np.allclose(values[f"{race}_{name}"][0], expected, rtol=1e-7, atol=1e-12, equal_nan=True)
    loaded = contacts.load[0] > 0.0
    if name not in ("contact_angle", "spin_to_roll"):
        loaded[:] = True
    among = expected[loaded]
    assert values[f"max_{race}_{name}"][0] == pytest.approx(np.nanmax(among), rel=1e-7)
    assert values[f"min_{race}_{name}"][0] == pytest.approx(np.nanmin(among), rel=1e-7)
    assert values[f"mean_{race}_{name}"][0] == pytest.approx(np.nanmean(among), rel=1e-7)


@pytest.mark.parametrize(
    "name",
    [
        "azimuth",
        "centrifugal_force",
        "gyroscopic_moment",
        "orbital_speed",
        "ball_speed",
        "attitude",
    ],
)
def test_balls_are_those_of_solve(case_218: Case, values: dict[str, np.ndarray], name: str) -> None:
    expected = getattr(solve(case_218).elements, name)[0]
    assert np.allclose(values[name][0], expected, rtol=1e-7, atol=1e-12)


def test_loaded_balls_only(values: dict[str, np.ndarray]) -> None:
    """At 5 kN some balls of the inner race carry nothing: their angle means nothing."""
    load, angle = values["inner_load"][1], values["inner_contact_angle"][1]
    assert 0 < values["loaded_balls"][1] == (load > 0.0).sum() < 16
    assert values["max_inner_contact_angle"][1] == angle[load > 0.0].max()
    assert values["min_inner_load"][1] == 0.0


def random_cases(count: int) -> dict[str, np.ndarray]:
    random = np.random.default_rng(5)
    return {
        "duty.load.fx": random.uniform(1e3, 45e3, count),
        "duty.load.fz": random.uniform(0.0, 20e3, count),
        "duty.inner_speed": random.uniform(0.0, 1500.0, count),
        "bearing.inner_conformity": random.uniform(0.505, 0.9, count),
        "bearing.outer_conformity": random.uniform(0.505, 0.9, count),
        "bearing.contact_angle": random.uniform(0.05, 0.9, count),
    }


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_the_maximum_pressure_is_that_of_all_contacts(case_218: Case, race: Race) -> None:
    solved = solve(case_218, random_cases(3000))
    found = maximum_pressure(solved, race)
    expected = np.fmax.reduce(solved.contacts[race].max_pressure, axis=1)
    assert np.array_equal(found, expected, equal_nan=True)
    assert np.isfinite(found).sum() > 1000


def test_the_maximum_pressure_of_a_set_of_rows(case_218: Case) -> None:
    bearing = case_218.bearing.replace(arrangement="DB", spacing="24 mm", preload="500 N")
    case = Case(bearing=bearing, duty=Duty(displacement=Displacement(ry=1e-4)))
    solved = solve(case, {"duty.load.fx": np.linspace(-5e3, 5e3, 5)})
    expected = np.fmax.reduce(solved.inner.max_pressure, axis=1)
    assert solved.converged.all()
    assert np.array_equal(maximum_pressure(solved, "inner"), expected)


def test_names() -> None:
    assert [output.name for output in outputs_of(DEFAULT_OUTPUTS)] == list(DEFAULT_OUTPUTS)
    with pytest.raises(UnknownKeyError, match="did you mean stiffness_zz"):
        outputs_of(["stifness_zz"])
    with pytest.raises(UnknownKeyError, match="--list outputs"):
        outputs_of(["?"])
