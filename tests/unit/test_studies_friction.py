"""Film, friction and slip as outputs of studies: the numbers, and what a case must have."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from rolamento import Case, InputError, Lubricant, analyse, load_case
from rolamento.friction.slip import (
    Patch,
    fast_maximum_pressure_slip,
    maximum_pressure_slip,
    solved_motion,
)
from rolamento.solution import solve
from rolamento.studies import Axis, Distribution, Scatter, Study, parse_study, run, study_to_json
from rolamento.studies.outputs import catalogue

FX = [20e3, 30e3, 40e3]
SURFACE = {"inner_roughness": 1e-7, "outer_roughness": 1e-7, "ball_roughness": 5e-8}


@pytest.fixture(scope="module")
def oiled(case_218: Case) -> Case:
    oil = Lubricant.named("ISO VG 68").replace(friction_coefficient=0.08)
    return case_218.replace(lubricant=oil, temperature={"lubricant": 343.15}, surface=SURFACE)


def over_load(case: Case, *outputs: str) -> Study:
    return Study(case=case, outputs=outputs, axes=(Axis(field="duty.load.fx", values=tuple(FX)),))


def loaded(case: Case, fx: float) -> Case:
    return case.replace(duty=case.duty.replace(load=case.duty.load.replace(fx=fx)))


def test_film_outputs_are_those_of_the_cases(oiled: Case) -> None:
    found = run(
        over_load(
            oiled, "inner_central_film_thickness", "min_outer_minimum_film_thickness",
            "max_inner_film_parameter", "film_parameter", "viscosity_ratio", "kinematic_viscosity",
        )
    )  # fmt: skip
    for index, fx in enumerate(FX):
        film = analyse(loaded(oiled, fx)).film
        assert film is not None
        inner, outer = film.inner, film.outer
        np.testing.assert_allclose(
            found["inner_central_film_thickness"][index], inner.central_thickness[0], rtol=1e-6
        )
        minimum = outer.minimum_thickness.min()
        assert found["min_outer_minimum_film_thickness"][index] == pytest.approx(minimum, rel=1e-6)
        minimum = min(inner.film_parameter.min(), outer.film_parameter.min())
        assert found["film_parameter"][index] == pytest.approx(minimum, rel=1e-6)
        maximum = inner.film_parameter.max()
        assert found["max_inner_film_parameter"][index] == pytest.approx(maximum, rel=1e-6)
        assert found["viscosity_ratio"][index] == pytest.approx(film.viscosity_ratio[0])
        assert found["kinematic_viscosity"][index] == pytest.approx(film.kinematic_viscosity[0])
    assert found["inner_central_film_thickness"].attrs["units"] == "m"


def test_friction_outputs_are_those_of_the_cases(oiled: Case) -> None:
    models = ("jones_full", "jones_control", "jones_simplified", "harris_1971", "todd")
    names = [f"friction_{kind}_{model}" for kind in ("torque", "power") for model in models]
    found = run(over_load(oiled, *names, "hysteresis_torque", "rolling_resistance_torque"))
    for index, fx in enumerate(FX):
        friction = analyse(loaded(oiled, fx)).friction
        assert friction is not None
        beside = friction.torque - friction.models["jones_full"].total
        for model in models:
            torque = (friction.models[model].total + beside)[0]
            assert found[f"friction_torque_{model}"][index] == pytest.approx(torque, rel=1e-6)
            power = torque * oiled.duty.inner_speed
            assert found[f"friction_power_{model}"][index] == pytest.approx(power, rel=1e-6)
        for source in ("hysteresis", "rolling_resistance"):
            assert found[f"{source}_torque"][index] == pytest.approx(
                friction.torque_by_source[source][0], rel=1e-6
            )


def test_spin_is_lost_where_the_race_does_not_control(oiled: Case) -> None:
    found = run(over_load(oiled, "inner_spin_loss", "outer_spin_loss", "max_inner_spin_loss"))
    np.testing.assert_allclose(found["outer_spin_loss"], 0.0, atol=1e-9)
    assert (found["inner_spin_loss"] > 0.0).all()
    np.testing.assert_array_equal(
        found["max_inner_spin_loss"], found["inner_spin_loss"].max("ball")
    )


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_pressure_times_slip_is_that_of_the_whole_ellipse(case_218: Case, race: str) -> None:
    solved = solve(case_218, fx=FX, inner_speed=[0.0, 100.0, 1500.0])
    patch = Patch.of(solved.contacts[race])  # type: ignore[index]
    motion = solved_motion(solved, patch.race)
    whole = maximum_pressure_slip(patch, motion).value
    np.testing.assert_allclose(
        fast_maximum_pressure_slip(patch, motion), whole, rtol=1e-6, atol=1e-3
    )
    found = run(
        Study(
            case=case_218,
            outputs=(f"{race}_pressure_slip",),
            axes=(
                Axis(
                    zipped={
                        "duty.load.fx": tuple(FX),
                        "duty.inner_speed": (0.0, 100.0, 1500.0),
                    }
                ),
            ),
        )
    )
    # a ball that does not touch both races loses nothing there
    expected = np.where(solved.balls_bear, whole, 0.0)
    np.testing.assert_allclose(found[f"{race}_pressure_slip"], expected, rtol=1e-6, atol=1e-3)


def test_under_friction_control_balls_tumble(examples: Path) -> None:
    case = load_case(
        examples / "ricci_fleury.toml",
        ["model.raceway_control=friction", "duty.inner_speed=9000 rpm"],
    )
    study = Study(
        case=case,
        outputs=("outer_pressure_slip", "rolling_power", "cage_speed", "outer_spin_loss",
                 "outer_spin_to_roll"),
        axes=(Axis(field="lubricant.friction_coefficient", values=(0.05, 0.1, 0.2)),),
    )  # fmt: skip
    found = run(study)
    assert (found["outer_pressure_slip"] > 0.0).all()
    assert (np.diff(found["rolling_power"]) > 0.0).all()
    assert (np.abs(found["outer_spin_to_roll"]) > 0.0).all()
    one = analyse(case.replace(lubricant=case.lubricant.replace(friction_coefficient=0.1)))  # type: ignore[union-attr]
    assert one.solved.rolling is not None
    assert found["rolling_power"][1] == pytest.approx(one.solved.rolling.power[0], rel=1e-4)
    assert found["cage_speed"][1] == pytest.approx(one.solved.rolling.cage_speed[0], rel=1e-5)


def test_without_a_result_there_is_no_number(oiled: Case) -> None:
    names = [
        name
        for name, output in catalogue().items()
        if set(output.needs) - {"friction control"}
        and not {"life", "bearing.preload", "bearing.designation", "rollers", "heat"}
        & set(output.needs)
        and not any(need.startswith("electrical.") for need in output.needs)
        and "jones_full" not in name
        and not name.startswith(("grease", "relubrication"))  # of an oil there are none
    ]
    axis = Axis(field="duty.load.fx", values=(30e3, -50e3))
    found = run(Study(case=oiled, outputs=tuple(names), axes=(axis,)))
    assert found["status"].values.tolist()[0] == 0
    for name in names:
        assert np.isfinite(found[name].values[0]).any(), name
        assert np.isnan(found[name].values[1]).all(), name


def test_coefficient_and_temperature_are_scattered(oiled: Case) -> None:
    laws = {
        "lubricant.friction_coefficient": Distribution(
            distribution="uniform", minimum=0.05, maximum=0.1
        ),
        "temperature.lubricant": Distribution(
            distribution="uniform", minimum="60 degC", maximum="90 degC"
        ),
    }
    outputs = (
        "friction_torque_todd", "hysteresis_torque", "rolling_resistance_torque",
        "film_parameter", "x",
    )  # fmt: skip
    found = run(Study(case=oiled, outputs=outputs, scatter=Scatter(count=50, fields=laws), seed=1))
    assert (found["status"] == 0).all()
    np.testing.assert_allclose(found["x"], found["x"][0], rtol=1e-9)
    warm = np.argsort(found["lubricant"].values)
    assert (np.diff(found["film_parameter"].values[warm]) < 0.0).all()
    beside = found["hysteresis_torque"] + found["rolling_resistance_torque"]
    ratio = (found["friction_torque_todd"] - beside) / found["friction_coefficient"]
    np.testing.assert_allclose(ratio, ratio[0], rtol=1e-6)


@pytest.mark.parametrize(
    ("output", "changes", "words"),
    [
        ("film_parameter", {"lubricant": None}, "needs a lubricant"),
        ("viscosity_ratio", {"lubricant": "BP 135"}, "needs a lubricant"),
        ("min_inner_central_film_thickness", {"temperature": None}, "lubricant's temperature"),
        ("min_inner_film_parameter", {"surface": None}, "roughness of the surfaces"),
        (
            "friction_torque_todd",
            {"lubricant": "ISO VG 68", "temperature": None},
            "a coefficient of friction",
        ),
        ("friction_power_jones_full", {"lubricant": None}, "a coefficient of friction"),
        (
            "max_inner_spin_loss",
            {"lubricant": "ISO VG 68", "temperature": None},
            "a coefficient of friction",
        ),
        ("rolling_resistance_torque", {"temperature": None}, "lubricant's temperature"),
        ("cage_speed", {}, "friction control of the balls"),
    ],
)
def test_what_an_output_needs_is_asked_for(
    oiled: Case, output: str, changes: dict[str, object], words: str
) -> None:
    with pytest.raises(InputError, match=words) as caught:
        over_load(oiled.replace(**changes), output)
    assert caught.value.field == "outputs"
    assert output in str(caught.value)


def test_what_varies_counts_as_given(oiled: Case) -> None:
    case = oiled.replace(temperature=None, lubricant="ISO VG 68")
    axis = Axis(field="temperature.lubricant", values=("50 degC", "90 degC"))
    found = run(Study(case=case, outputs=("film_parameter",), axes=(axis,)))
    assert found["film_parameter"][0] > found["film_parameter"][1]


def test_a_study_file_names_them(oiled: Case) -> None:
    study = over_load(oiled, "min_inner_film_parameter", "friction_torque_jones_simplified")
    text = study_to_json(study)
    assert parse_study(text, format="json").outputs == study.outputs
    assert "min_inner_film_parameter" in json.loads(text)["outputs"]


@pytest.mark.parametrize("designation", ["6310", "NU 205", "7014 C/HCP4A DB"])
def test_torques_of_whole_bearings_are_those_of_a_single_analysis(designation: str) -> None:
    """Mounted too, where the designation is that of the bearing as it was delivered."""
    case = Case.model_validate(
        {
            "bearing": {"designation": designation},
            "duty": {"inner_speed": "1500 rpm", "load": {"fx": "400 N", "fz": "2 kN"}},
            "mounting": {"shaft_tolerance": "js5", "housing_tolerance": "H6"},
            "lubricant": "ISO VG 68",
            "temperature": dict.fromkeys(("inner_ring", "outer_ring", "lubricant"), "60 degC"),
        }
    )  # fmt: skip
    if designation == "NU 205":
        case = case.with_({"duty.load.fx": 0.0})
    names = ["palmgren", "skf"]
    outputs = tuple(f"friction_{what}_{name}" for name in names for what in ("torque", "power"))
    axis = Axis(field="duty.load.fz", values=(1e3, 3e3))
    found = run(Study(case=case, outputs=outputs, axes=(axis,)))
    for place, fz in enumerate(axis.values):
        friction = analyse(case.with_({"duty.load.fz": fz})).friction
        assert friction is not None
        for name in names:
            torque = float(friction.models[name].total[0])
            assert found[f"friction_torque_{name}"].values[place] == pytest.approx(torque, rel=1e-6)
            power = 50.0 * np.pi * torque
            assert found[f"friction_power_{name}"].values[place] == pytest.approx(power, rel=1e-6)
