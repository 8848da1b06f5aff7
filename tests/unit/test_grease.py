"""Life of greases, relubrication, amounts, and the choice of an oil."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import Case, InputError, load_case
from rolamento.cli.app import app
from rolamento.grease import (
    GreaseDuty,
    base_interval,
    fag_amount,
    fag_interval,
    grease_life_jtekt,
    grease_life_kawamura,
    grease_life_nsk,
    l10_of_mean,
    noria_interval,
    skf_amount,
    skf_interval,
)
from rolamento.grease.models import MODELS
from rolamento.lubrication.oil_choice import choose_oil, viscosity_at_40
from rolamento.oil.state import oil_state, viscosity_ratio
from rolamento.studies import Study, run
from rolamento.tasks.grease import choose_oil_of_case, grease_of_case

RPM = np.pi / 30.0
ZERO = 273.15


def duty(**changes: Any) -> GreaseDuty:
    own = {
        "temperature": ZERO + 80.0,
        "speed": 3000 * RPM,
        "limiting_speed": 9000 * RPM,
        "mean_diameter": 0.050,
        "load_ratio": 0.05,
    }
    return GreaseDuty(**{**own, **changes})


def sealed(**changes: Any) -> Case:
    values = {"duty.load.fz": "500 N", "duty.inner_speed": "3000 rpm"}
    return load_case("6205-2RS1", {**values, "temperature.lubricant": "80 degC", **changes})


# --- laws -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("law", MODELS)
def test_a_warmer_faster_grease_lives_shorter(law: str) -> None:
    lives = [MODELS[law].evaluate(duty(temperature=ZERO + t)).hours for t in range(70, 111, 5)]
    assert np.all(np.diff(lives) < 0.0)
    lives = [MODELS[law].evaluate(duty(speed=n * RPM)).hours for n in (3000, 5000, 7000)]
    assert np.all(np.diff(lives) < 0.0)


@pytest.mark.parametrize("law", ["kawamura", "jtekt"])
def test_a_heavier_load_shortens_the_life(law: str) -> None:
    lives = [MODELS[law].evaluate(duty(load_ratio=x)).hours for x in (0.06, 0.10, 0.15)]
    assert np.all(np.diff(lives) < 0.0)


@pytest.mark.parametrize(("law", "changes", "note"), [
    ("nsk", {"temperature": ZERO + 110.01}, "grease_too_hot"),
    ("nsk", {"base_oil": "ester", "temperature": ZERO + 130.01}, "grease_too_hot"),
    ("nsk", {"speed": 9001 * RPM}, "grease_too_fast"),
    ("nsk", {"load_ratio": 0.101}, "grease_loaded_too_much"),
    ("nsk", {"limiting_speed": np.nan}, "grease_without_limiting_speed"),
    ("nsk", {"thickener": "urea"}, "grease_law_of_lithium"),
    ("jtekt", {"thickener": "urea"}, "grease_law_of_lithium"),
    ("kawamura", {"temperature": ZERO + 150.01}, "grease_too_hot"),
    ("kawamura", {"thickener": "urea", "temperature": ZERO + 180.01}, "grease_too_hot"),
    ("kawamura", {"mean_diameter": 0.1001, "speed": 10.0}, "grease_size"),
    ("kawamura", {"speed": 8001 * RPM}, "grease_speed_factor"),
    ("kawamura", {"base_oil": "ether"}, "grease_unknown_pair"),
    ("kawamura", {"load_ratio": np.nan}, "grease_without_load_ratio"),
    ("jtekt", {"temperature": ZERO + 120.01}, "grease_too_hot"),
    ("jtekt", {"speed": 10001 * RPM}, "grease_speed_factor"),
    ("jtekt", {"load_ratio": 0.161}, "grease_loaded_too_much"),
])  # fmt: skip
def test_outside_its_range_a_law_has_no_number(
    law: str, changes: dict[str, Any], note: str
) -> None:
    found = MODELS[law].evaluate(duty(**changes))
    assert np.isnan(found.hours)
    assert not found.valid
    assert note in [one.key for one in found.notes]
    assert found.to_mapping()["hours"] is None
    assert MODELS[law].evaluate(duty()).valid


def test_at_the_ends_of_its_range_it_has_one() -> None:
    assert np.isfinite(grease_life_nsk(1.0, ZERO + 110.0))
    assert np.isfinite(grease_life_nsk(1.0, ZERO + 130.0, "wide_range"))
    assert np.isfinite(grease_life_kawamura(400e3, ZERO + 150.0, 0.1))
    assert np.isfinite(grease_life_jtekt(500e3, ZERO + 120.0, 0.16))


def test_slow_and_cool_count_as_the_least() -> None:
    assert grease_life_nsk(0.01, ZERO + 20.0) == grease_life_nsk(0.25, ZERO + 70.0)
    assert grease_life_jtekt(1e3, ZERO, 0.0) == grease_life_jtekt(125e3, ZERO + 50.0, 0.05)
    cool, least = (grease_life_kawamura(1e5, ZERO + t, 0.05) for t in (20.0, 70.0))
    assert cool == least
    keys = [note.key for note in MODELS["nsk"].evaluate(duty(speed=1.0, temperature=290.0)).notes]
    assert keys == ["grease_slow_counts_as", "grease_cool_counts_as"]


def test_an_outer_ring_turns_the_cage_faster() -> None:
    """K = (1 + γ)/(1 - γ) on the speed."""
    gamma = 0.2
    inner = MODELS["kawamura"].evaluate(duty(speed=1.5 * 3000 * RPM))
    outer = MODELS["kawamura"].evaluate(duty(outer_ring_turns=True, ratio=gamma))
    assert outer.hours == pytest.approx(inner.hours)


def test_mean_and_l10_of_a_grease() -> None:
    """Weibull's slope of L_10 = 2.7 L_1 gives L_50 = 2.2 L_10."""
    slope = np.log(np.log(0.9) / np.log(0.99)) / np.log(2.7)
    assert l10_of_mean(1000.0) == pytest.approx(1000.0 * (np.log(0.9) / np.log(0.5)) ** (1 / slope))
    assert 1000.0 / l10_of_mean(1000.0) == pytest.approx(2.217, abs=1e-3)


# --- relubrication and amounts --------------------------------------------------------------------


def test_skfs_adjustments() -> None:
    base = 10_000.0
    assert skf_interval(base, ZERO + 70.0).low == pytest.approx(base)
    for steps in (1, 2, 3):
        warm = skf_interval(base, ZERO + 70.0 + 15.0 * steps).low
        assert warm == pytest.approx(base / 2.0**steps)
    assert skf_interval(base, ZERO + 55.0).low == pytest.approx(2.0 * base)
    assert skf_interval(base, ZERO + 10.0).low == pytest.approx(2.0 * base)
    assert skf_interval(base, ZERO + 70.0, vertical=True).low == pytest.approx(0.5 * base)
    assert skf_interval(base, ZERO + 70.0, bore=0.320).low == pytest.approx(0.5 * base)
    assert skf_interval(25_000.0, ZERO + 40.0).low == 30_000.0
    assert skf_interval(base, ZERO + 70.0, sizes_ratio=1.25).low == pytest.approx(0.8 * base)


def test_the_temperature_is_continuous() -> None:
    around = [skf_interval(1e4, ZERO + t).low for t in (69.999, 70.001)]
    assert around[0] == pytest.approx(around[1], rel=1e-3)


def test_noria_and_fag() -> None:
    assert noria_interval(1e4, ZERO + 70.0, "very_severe", vertical=True).low == pytest.approx(
        300.0
    )
    assert noria_interval(1e4, ZERO + 60.0).low == pytest.approx(1e4)
    found = fag_interval(1e4, ZERO + 80.0, 0.2, "severe", vertical=True)
    assert found.low == pytest.approx(1e4 * 0.3 * 0.4 * 0.4 * 0.5)
    assert found.high == pytest.approx(1e4 * 0.6 * 0.7 * 0.7 * 0.7)
    assert np.isnan(fag_interval(1e4, ZERO + 121.0, 0.1).low)
    assert np.isnan(fag_interval(1e4, ZERO + 70.0, 0.36).low)


def test_the_base_interval() -> None:
    ball = base_interval(1000 * RPM, 0.1)
    assert ball == pytest.approx(10.0 * (14e6 / (1000.0 * 10.0) - 400.0))
    for element, share in (
        ("cylindrical", 0.5),
        ("needle", 0.5),
        ("tapered", 0.1),
        ("spherical", 0.1),
    ):
        assert base_interval(1000 * RPM, 0.1, element) == pytest.approx(share * ball)
    assert base_interval(1000 * RPM, 0.1, axial=True) == pytest.approx(0.1 * ball)
    assert np.isnan(base_interval(3500 * RPM, 0.1))  # 14e6/(n √d) falls below 4 d
    assert np.isnan(base_interval(0.0, 0.1))


def test_amounts() -> None:
    assert skf_amount(0.1, 0.02) == pytest.approx(10e-3)
    assert skf_amount(0.1, 0.02, "middle") == pytest.approx(4e-3)
    shares = [fag_amount(0.1, 0.02, hours) for hours in (100.0, 500.0, 5000.0)]
    assert shares == pytest.approx([4e-3, 6e-3, 8e-3])


# --- of a case ------------------------------------------------------------------------------------


def test_a_sealed_bearing_has_lives_and_no_interval() -> None:
    found = grease_of_case(sealed())
    assert found.sealed
    assert not found.intervals
    assert len(found.lives) == 3
    low, high = found.spread
    assert low < found.hours < high
    assert found.l10 < found.hours
    by_law = {one.name: one.hours for one in found.lives}
    assert by_law["nsk_general"] == pytest.approx(
        grease_life_nsk(found.duty.speed_ratio, ZERO + 80.0)
    )


def test_an_open_bearing_has_intervals_and_no_lives() -> None:
    found = grease_of_case(sealed().with_({"bearing.designation": "6205"}))
    assert not found.sealed
    assert not found.lives
    assert found.base == pytest.approx(base_interval(3000 * RPM, 0.025))
    assert len(found.intervals) == 3
    assert found.amount_side == pytest.approx(0.005e-3 * 52 * 15)


def test_what_the_case_says_leads_over_what_is_inferred() -> None:
    found = grease_of_case(
        sealed(**{
            "grease.thickener": "urea", "grease.base_oil": "ether", "grease.sealed": True,
            "grease.limiting_speed": "10000 rpm",
        })
    )  # fmt: skip
    assert [one.name for one in found.lives] == ["nsk_wide_range", "kawamura_urea", "jtekt"]
    assert found.duty.speed_ratio == pytest.approx(0.3)
    inferred = {"grease_kind_inferred", "grease_limit_of_class", "grease_sealed_by_designation"}
    assert not inferred & {note.key for note in found.notes}


def test_synthetic_oils_are_wide_range() -> None:
    lubricant = {
        "kind": "grease", "oil_type": "synthetic", "density": "850 kg/m^3",
        "viscosity_40": "100 mm^2/s", "viscosity_100": "14 mm^2/s",
    }  # fmt: skip
    found = grease_of_case(sealed().with_({"lubricant": lubricant}))
    assert found.duty.base_oil == "pao"
    assert found.lives[0].name == "nsk_wide_range"


def test_temperature_is_the_hottest() -> None:
    found = grease_of_case(sealed(**{"temperature.inner_ring": "95 degC"}))
    assert found.duty.celsius == pytest.approx(95.0)


def test_other_bearings_have_no_law_of_life() -> None:
    found = grease_of_case(
        load_case("NU 210", {"duty.load.fz": "5 kN", "duty.inner_speed": "1000 rpm",
                             "grease.sealed": True})
    )  # fmt: skip
    assert not found.lives
    assert "grease_laws_of_deep_groove" in [note.key for note in found.notes]


@pytest.mark.parametrize(("changes", "note"), [
    ({"temperature.lubricant": "125 degC"}, "grease_above_its_limit"),
    ({"temperature.lubricant": "-30 degC"}, "grease_under_its_limit"),
    ({"duty.inner_speed": "20000 rpm"}, "grease_above_speed"),
    ({"duty.inner_speed": "0 rpm"}, "grease_at_rest"),
    ({"lubricant": "ISO VG 68"}, "grease_instead_of_oil"),
])  # fmt: skip
def test_what_is_said_of_a_grease(changes: dict[str, Any], note: str) -> None:
    found = grease_of_case(sealed(**changes))
    assert note in [one.key for one in found.notes]


def test_a_swinging_ring_counts_by_its_mean_speed() -> None:
    found = grease_of_case(
        sealed().with_({"duty.oscillation.angle": "90 deg", "duty.oscillation.frequency": "2 Hz"})
    )
    assert found.duty.speed == pytest.approx(2.0 * np.pi)  # 180° twice a second
    assert "grease_oscillates" in [one.key for one in found.notes]


def test_dry_bearings_have_none() -> None:
    dry = {"kind": "dry", "friction_coefficient": 0.1}
    with pytest.raises(InputError, match="dry"):
        grease_of_case(sealed().with_({"lubricant": dry}))


# --- an oil ---------------------------------------------------------------------------------------


def test_the_chosen_grade_is_the_thinnest_that_is_enough() -> None:
    found = choose_oil(155.0, 0.08, 1.5, ZERO + 40.0, ZERO + 80.0)
    ratios = [one.ratio_hot for one in found.grades]
    assert np.all(np.diff(ratios) > 0.0)
    index = [one.name for one in found.grades].index(found.chosen or "")
    assert ratios[index] >= 1.5 > ratios[index - 1]


def test_its_ratio_is_that_of_the_film() -> None:
    from rolamento.case import Lubricant

    found = choose_oil(155.0, 0.08, 1.5, ZERO + 40.0, ZERO + 80.0)
    oil = oil_state(Lubricant.named("ISO VG 68"), ZERO + 80.0)
    by_hand = viscosity_ratio(oil.kinematic_viscosity, 155.0, 0.08)
    assert found["ISO VG 68"].ratio_hot == pytest.approx(float(by_hand))


def test_a_viscosity_at_40_comes_back() -> None:
    for grade in (32, 100, 460):
        from rolamento.case import Lubricant

        at = float(oil_state(Lubricant.named(f"ISO VG {grade}"), ZERO + 75.0).kinematic_viscosity)
        assert viscosity_at_40(at, ZERO + 75.0) == pytest.approx(grade * 1e-6, rel=1e-6)


def test_no_oil_is_thick_enough_for_a_crawl() -> None:
    found = choose_oil(0.001, 0.05, 4.0, ZERO + 60.0, ZERO + 60.0)
    assert found.chosen is None
    assert "no_oil_thick_enough" in [note.key for note in found.notes]


@pytest.mark.parametrize("changes", [
    {"speed": 0.0}, {"speed": np.nan}, {"required": 0.0}, {"required": np.nan}, {"required": 99.0},
    {"coldest": 400.0},
])  # fmt: skip
def test_choices_that_are_none(changes: dict[str, float]) -> None:
    own = {
        "speed": 100.0,
        "pitch_diameter": 0.05,
        "required": 1.5,
        "coldest": 300.0,
        "hottest": 350.0,
    }
    with pytest.raises(InputError):
        choose_oil(**{**own, **changes})


def test_an_oil_of_a_case_needs_a_temperature() -> None:
    with pytest.raises(InputError, match="goes by it"):
        choose_oil_of_case(load_case("6310", {"duty.inner_speed": "1000 rpm"}))


# --- commands -------------------------------------------------------------------------------------


def test_the_commands() -> None:
    run = CliRunner().invoke
    words = ["grease", "6205-2RS1", "--fr", "500 N", "--speed", "3000 rpm"]
    page = run(app, [*words, "--temperature", "80 degC"])
    assert page.exit_code == 0
    assert "on average, by 3 laws" in " ".join(page.output.split())
    found = json.loads(run(app, [*words, "--json", "-"]).output)
    assert found["sealed"] is True
    assert found["lives"][0]["name"] == "nsk_general"
    assert run(app, [*words, "--kappa", "0"]).exit_code == 2
    oil = run(app, ["oil", "6310", "--speed", "1480 rpm", "--temperatures", "40..70degC"])
    assert oil.exit_code == 0
    assert "ISO VG 68: κ = " in oil.output
    steady = run(app, ["oil", "6310", "--speed", "1480 rpm", "--temperature", "70 degC"])
    assert "at 70 °C." in steady.output
    assert " and " not in steady.output.partition("\n\n")[0]
    wrong = run(app, ["oil", "6310", "--speed", "1480 rpm", "--temperatures", "40"])
    assert wrong.exit_code == 2
    assert "40..80degC" in wrong.output


@pytest.mark.parametrize("designation", ["6205-2RS1", "6310"])
def test_a_study_has_the_grease_of_each_case(designation: str) -> None:
    case = Case(
        bearing=designation,
        duty={"inner_speed": "3000 rpm", "load": {"fz": "500 N"}},
        lubricant="ISO VG 100",
        temperature={"lubricant": "70 degC"},
    )
    warmth, loads = [333.15, 363.15], [500.0, 1500.0]
    axes = [
        {"field": "temperature.lubricant", "values": warmth},
        {"field": "duty.load.fz", "values": loads},
    ]
    names = (
        "grease_hours", "grease_hours_l10", "relubrication_hours_minimum",
        "relubrication_hours_maximum",
    )  # fmt: skip
    found = run(Study(case=case, axes=axes, outputs=names))
    for i, temperature in enumerate(warmth):
        for j, load in enumerate(loads):
            own = grease_of_case(
                case.with_({"temperature.lubricant": temperature, "duty.load.fz": load})
            )
            numbers = [float(found[name][i, j]) for name in names]
            expected = [own.hours, own.l10, *own.interval]
            assert numbers == pytest.approx(expected, rel=1e-9, nan_ok=True)
            assert np.isfinite(numbers).any()
