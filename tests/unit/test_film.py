"""The film: formulas on published numbers, reductions, regimes, a state and a batch."""

from __future__ import annotations

import json
from functools import cache
from math import isnan, pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rolamento import Case, load_case
from rolamento.errors import InputError
from rolamento.kinematics import rolling_entrainment_speed
from rolamento.lubrication import Film
from rolamento.lubrication import film as film_of
from rolamento.lubrication.film_thickness import (
    central_film,
    film_groups,
    flooded_distance_central,
    gupta_cheng,
    inlet_distance_central,
    inlet_distance_minimum,
    murch_wilson,
    replenishment,
    thermal_loading,
)
from rolamento.lubrication.regime import (
    adhesive_wear_by_speed,
    crack_origin,
    failure_modes,
    regime_indices,
    regime_of,
    regimes,
)
from rolamento.oil.state import reference_viscosity, viscosity_ratio
from rolamento.solution import solve

EXAMPLES = Path(__file__).resolve().parents[2] / "src" / "rolamento" / "examples"
TABLES: dict[str, Any] = {
    "lubricant": "ISO VG 68",
    "temperature": {"lubricant": "70 degC"},
    "surface": {
        "inner_roughness": "0.1 um", "outer_roughness": "0.1 um", "ball_roughness": "0.02 um",
    },
}  # fmt: skip
RPM = pi / 30.0


def case(name: str = "218_combined", **tables: Any) -> Case:
    mapping = {**load_case(EXAMPLES / f"{name}.toml").to_mapping(), **TABLES, **tables}
    return Case.from_mapping({key: value for key, value in mapping.items() if value is not None})


@cache
def film(name: str = "218_combined") -> Film:
    return film_of(solve(case(name)))


def notes_of(changed: Case) -> str:
    return " ".join(note.text for note in film_of(solve(changed)).notes_of())


# --- published numbers ---


def test_public_example_of_the_central_film() -> None:
    """A public test example: ball of 4.365 mm in a race of radius 40.635 mm, k given."""
    modulus = 207e9 / (1.0 - 0.3**2)
    curvature = 2.0 / 4.365e-3 + 1.0 / 40.635e-3
    groups = film_groups(22.36094193, 136.0, curvature, 5.595274, modulus, 0.043691, 0.2 / 9.8067e6)
    thickness = float(central_film(groups)) / curvature
    assert thickness == pytest.approx(1.33431847e-6, rel=1e-6)


def test_public_example_of_the_thermal_factor() -> None:
    loading = thermal_loading(0.043691, 7.5e-4, 22.36094193, 0.145)
    assert float(murch_wilson(loading)) == pytest.approx(0.938371825, rel=1e-8)


def test_reference_viscosity() -> None:
    """ISO 281: 4500/√(n D) from 1000 r/min on, with the standard's step of 2.3 % there."""
    assert float(reference_viscosity(2000 * RPM, 0.0445)) == pytest.approx(15.084e-6, rel=1e-4)
    below, at, above = reference_viscosity(np.array([999.999, 1000.0, 1000.001]) * RPM, 0.1)
    assert below / above == pytest.approx(10 * 1000**-0.33, rel=2e-6)  # 2.3 %
    assert at == pytest.approx(above, rel=1e-6)
    for speed in (1000 * np.pi / 30, 1000 / (30 / np.pi), np.nextafter(1000 * np.pi / 30, 0.0)):
        assert float(reference_viscosity(speed, 0.1)) == pytest.approx(float(at), rel=1e-12)
    assert float(reference_viscosity(-2000 * RPM, 0.0445)) == pytest.approx(15.084e-6, rel=1e-4)
    assert float(viscosity_ratio(20e-6, 0.0, 0.1)) == 0.0


# --- reductions ---


def test_thermal_factors_begin_at_one_and_fall() -> None:
    loading = np.array([0.0, 1e-4, 1e-2, 1.0, 10.0])
    for factor in (murch_wilson(loading), gupta_cheng(loading, 1e9, 2.3e11, 0.05)):
        assert factor[0] == 1.0
        assert np.all(np.diff(factor) < 0.0)
        assert np.all((factor > 0.0) & (factor <= 1.0))
    assert gupta_cheng(1.0, 1e9, 2.3e11, 0.2) < gupta_cheng(1.0, 1e9, 2.3e11, 0.0)
    assert gupta_cheng(1e6, 3e9, 2.3e11, 0.0) == 0.0


def test_starvation_by_the_inlet_distance() -> None:
    film, radius, b = 3e-5, 4e-3, 1e-4
    flooded = float(flooded_distance_central(film, radius, b))
    assert flooded == pytest.approx(1.0 + 3.06 * (1600.0 * 3e-5) ** 0.58, rel=1e-12)
    assert float(inlet_distance_central(flooded, flooded)) == 1.0
    assert float(inlet_distance_central(2 * flooded, flooded)) == 1.0
    assert float(inlet_distance_central(1.0, flooded)) == 0.0
    assert float(inlet_distance_central(0.5, flooded)) == 0.0
    halfway = 1.0 + 0.5 * (flooded - 1.0)
    assert float(inlet_distance_central(halfway, flooded)) == pytest.approx(0.5**0.29)
    assert float(inlet_distance_minimum(halfway, flooded)) == pytest.approx(0.5**0.25)
    assert float(inlet_distance_central(5.0, 1.0)) == 1.0
    assert isnan(float(inlet_distance_central(5.0, np.nan)))


def test_replenishment() -> None:
    """6305 with oil at 12.89 mm²/s and 2000 r/min, by hand: exponent 0.0171."""
    hand = 3e-8 * 12.89 * 2000.0 * (25.0 + 62.0) * (3.1 / (2.0 * 37.0)) ** 0.5
    arguments = (12.89e-6, 2000 * RPM, 0.025, 0.062)
    found = replenishment(*arguments, "bath", kind="deep_groove")
    assert float(found) == pytest.approx(np.exp(-hand), rel=1e-9)
    assert float(replenishment(*arguments, "grease", kind="deep_groove")) < float(found)


# --- regimes ---


@pytest.mark.parametrize(
    ("parameter", "name"),
    [(10.0, "full_film"), (3.0, "partial"), (1.5, "partial"), (1.0, "boundary"),
     (0.5, "boundary"), (0.3, "adhesive"), (0.0, "adhesive")],
)  # fmt: skip
def test_regimes(parameter: float, name: str) -> None:
    found = regime_of(parameter)
    assert found is not None
    assert found.name == name
    assert found.expects


def test_regime_of_no_number() -> None:
    assert regime_of(float("nan")) is None
    assert regime_indices([np.nan, 5.0]).tolist() == [-1, 0]


def test_the_table_of_failure_modes_is_whole() -> None:
    groups = [mode.group for mode in failure_modes()]
    assert (groups.count("contact_fatigue"), groups.count("plastic_deformation")) == (6, 3)
    assert groups.count("wear") == 6
    origins = {mode.origin for mode in failure_modes() if mode.group == "wear"}
    assert origins == {"adhesive", "abrasive", "corrosive", "fretting"}
    assert len({mode.name for mode in failure_modes()}) == len(groups)
    assert set(adhesive_wear_by_speed()) == {"low_speed", "high_speed"}
    assert [regime.above for regime in regimes()] == [3.0, 1.0, 0.3, -1.0]


@pytest.mark.parametrize(
    ("ratio", "origin"),
    [(0.0, "surface"), (0.19, "surface"), (0.3, "undecided"), (0.5, "subsurface"),
     (1.0, "subsurface"), (1.5, "subsurface"), (1.6, "undecided")],
)  # fmt: skip
def test_origin_of_a_crack(ratio: float, origin: str) -> None:
    assert crack_origin(ratio * 1.0, 1.0) == origin


@pytest.mark.parametrize(
    ("crack", "shear"), [(-1.0, 1.0), (np.nan, 1.0), (1.0, 0.0), (1.0, np.inf)]
)
def test_refuses_impossible_depths(crack: float, shear: float) -> None:
    with pytest.raises(InputError):
        crack_origin(crack, shear)


# --- a state and a batch ---


def test_a_case_among_many_has_the_film_that_it_has_alone() -> None:
    for name in ("218_combined", "6012_pair", "209_radial"):
        one = case(name)
        loads = one.duty.load.fz * np.array([1.0, 1.1]) if one.duty.load.fz else np.zeros(2)
        many, single = film_of(solve(one, fz=loads)), film_of(solve(one))
        assert many.to_mapping(0) == single.to_mapping()


def test_entrainment_of_a_loaded_bearing_is_nearly_that_of_rolling() -> None:
    one = case("209_radial", duty={"inner_speed": "3000 rpm", "load": {"fz": "5 kN"}})
    state, found = solve(one), film_of(solve(one))
    bearing = one.bearing
    rolling = float(
        rolling_entrainment_speed(
            bearing.pitch_diameter, bearing.ball_diameter / bearing.pitch_diameter, 3000 * RPM, 0.0
        )
    )
    loaded = state.inner.load > 0.0
    assert loaded.any()
    for films in (found.inner, found.outer):
        np.testing.assert_allclose(films.entrainment_speed[loaded], rolling, rtol=1e-3)


def test_blocks_of_a_large_batch_join() -> None:
    one, picked = case(), [0, 4095, 4096, 4999]
    varied = {
        "duty.load.fz": np.linspace(1e3, 15e3, 5000),
        "temperature.lubricant": np.linspace(320.0, 360.0, 5000),
    }
    whole = film_of(solve(one, varied), threads=2)
    few = film_of(solve(one, {name: values[picked] for name, values in varied.items()}))
    np.testing.assert_allclose(
        whole.outer.minimum_thickness[picked], few.outer.minimum_thickness, rtol=1e-8
    )
    np.testing.assert_allclose(whole.viscosity_ratio[picked], few.viscosity_ratio, rtol=1e-12)
    assert whole.inner.film_parameter.shape == (5000, 16)
    assert whole.notes_of(4999) == few.notes_of(3)


def test_a_bad_case_carries_nan_and_leaves_the_others() -> None:
    table = film_of(solve(case(), fx=[20e3, np.nan, 20e3]))
    assert np.isnan(table.inner.central_thickness[1]).all()
    assert np.isfinite(table.inner.central_thickness[[0, 2]]).all()


def test_a_temperature_that_is_none_spoils_its_own_case_only() -> None:
    table = film_of(solve(case(), {"temperature.lubricant": [340.0, -1.0, np.nan]}))
    assert np.isfinite(table.inner.central_thickness[0]).all()
    assert np.isnan(table.inner.central_thickness[1:]).all()


def test_an_empty_batch() -> None:
    table = film_of(solve(case(), fx=[]))
    assert table.inner.central_thickness.shape == (0, 16)
    assert table.viscosity_ratio.shape == (0,)


def test_no_contact_has_no_film() -> None:
    one = case("209_radial", duty={"inner_speed": "3000 rpm", "load": {"fz": "5 kN"}})
    state, found = solve(one), film_of(solve(one))
    missing = np.isnan(found.inner.central_thickness)
    np.testing.assert_array_equal(missing, state.inner.load == 0.0)
    assert missing.any()
    assert found.thinnest("inner") is not None


def test_the_record_as_a_mapping() -> None:
    mapping = film().to_mapping()
    text = json.dumps(mapping, allow_nan=False)
    assert json.loads(text) == json.loads(json.dumps(mapping))
    assert mapping["lubricant"] == "ISO VG 68"
    assert mapping["balls"][0]["inner"]["regime"] == "full_film"
    assert mapping["balls"][0]["inner"]["expected_failures"][0] == "subsurface_inclusion"
    still = film_of(solve(case(duty={"load": {"fx": "20 kN"}})))
    assert still.to_mapping()["reference_viscosity"] is None


# --- what the user should know ---


def test_missing_lubricant_and_temperature_are_named() -> None:
    for changes, field in (
        ({"lubricant": None}, "lubricant"),
        ({"temperature": None}, "temperature.lubricant"),
    ):
        one = case(**changes)
        with pytest.raises(InputError) as caught:
            film_of(solve(one))
        assert caught.value.field == field


def test_what_is_not_solved_is_refused() -> None:
    with pytest.raises(InputError, match="solve"):
        film_of(case())  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("tables", "word"),
    [
        ({"lubricant": "Tonna S 68", "temperature": {"lubricant": "-30 degC"}}, "below its temp"),
        ({"lubricant": "Tonna S 68", "temperature": {"lubricant": "250 degC"}}, "above its temp"),
        ({"temperature": {"lubricant": "200 degC"}}, "less than 2 mm²/s"),
        ({"surface": None}, "no film parameter"),
        ({"lubricant": "Rheolube 2000"}, "base oil"),
        ({"lubricant": "BP 135"}, "Dry lubrication"),
        ({"duty": {"load": {"fx": "20 kN"}}}, "Nothing rotates"),
        ({}, "estimated"),
        ({}, "Hamrock and Dowson"),
        ({"lubricant": "ISO VG 10", "temperature": {"lubricant": "110 degC"}}, "thinner than"),
        ({"surface": {"inner_roughness": "20 um", "outer_roughness": "20 um",
                      "ball_roughness": "1 um"}}, "adhesive wear"),
        ({"film": {"starvation": "inlet_distance", "inlet_distance": "0.2 mm"}},
         "Starvation"),
    ],
)  # fmt: skip
def test_notes(tables: dict[str, Any], word: str) -> None:
    assert word in notes_of(case(**tables))


def test_a_measured_coefficient_is_no_estimate() -> None:
    own = {"base_oil": "ISO VG 68", "pressure_viscosity": "20 1/GPa"}
    assert "estimated" not in notes_of(case(lubricant=own))


def test_standing_still_there_is_no_film() -> None:
    still = film_of(solve(case(duty={"load": {"fx": "20 kN"}})))
    assert set(still.inner.central_thickness[0]) == {0.0}
    assert still.viscosity_ratio[0] == 0.0
    assert still.inner.regime[0, 0] == "adhesive"


def test_dry_lubrication_has_no_numbers() -> None:
    dry = film_of(solve(case(lubricant="BP 135")))
    assert np.isnan(dry.inner.central_thickness).all()
    assert np.isnan(dry.viscosity_ratio).all()
    assert dry.inner.regime[0, 0] == ""


def test_reductions_are_chosen_in_the_case() -> None:
    plain = film_of(solve(case(film={"thermal": "none"})))
    warm, other = film(), film_of(solve(case(film={"thermal": "gupta_cheng"})))
    starved = film_of(
        solve(case(film={"starvation": "replenishment", "supply": "grease", "bore": "90 mm",
                         "outside_diameter": "160 mm"}))
    )  # fmt: skip
    first, second, third, fourth = (f.inner for f in (plain, warm, other, starved))
    assert np.all(first.thermal_factor == 1.0)
    assert second.central_thickness == pytest.approx(
        first.central_thickness * second.thermal_factor
    )
    assert np.all(third.thermal_factor < 1.0)
    assert fourth.central_thickness == pytest.approx(
        second.central_thickness * fourth.starvation_factor
    )
    assert np.all(fourth.starvation_factor < 1.0)


def test_both_rings_turning_count_by_their_difference() -> None:
    # without a cage: how firmly a ball is held depends on which ring throws it outward
    one = case(model={"centrifugal_force": False, "gyroscopic_moment": False, "cage": "none"})
    mapping = one.to_mapping()
    turned = Case.from_mapping(
        {
            **mapping,
            "duty": {**mapping["duty"], "inner_speed": "0 rpm", "outer_speed": "-10000 rpm"},
        }
    )
    first, second = film_of(solve(one)), film_of(solve(turned))
    for one_race, other in ((first.inner, second.inner), (first.outer, second.outer)):
        np.testing.assert_allclose(one_race.entrainment_speed, other.entrainment_speed, rtol=1e-9)


def test_records_are_frozen() -> None:
    with pytest.raises(AttributeError):
        film().temperature = np.zeros(1)  # type: ignore[misc]
