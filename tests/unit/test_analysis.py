"""What follows from a case: which parts there are, in one record, as JSON, and over a batch."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.one_case import keys

import rolamento
from rolamento import (
    Case,
    Load,
    Lubricant,
    analyse,
    load_case,
    parse_case,
)
from rolamento.friction.palmgren import palmgren
from rolamento.lubrication import film as film_of
from rolamento.solution import solve
from rolamento.vibration.frequencies import frequencies_of

SURFACE = {"inner_roughness": 1e-7, "outer_roughness": 1e-7, "ball_roughness": 5e-8}
WARM = {"lubricant": 343.15}


def strict(text: str) -> Any:
    def refuse(constant: str) -> None:
        raise AssertionError(f"{constant} in JSON")

    return json.loads(text, parse_constant=refuse)


@pytest.fixture(scope="module")
def oiled(case_218: Case) -> Case:
    oil = Lubricant.named("ISO VG 68").replace(friction_coefficient=0.08)
    return case_218.replace(lubricant=oil, temperature=WARM, surface=SURFACE)


def test_a_plain_case_is_its_state_and_nothing_else(case_218: Case) -> None:
    analysis = analyse(case_218)
    assert analysis.film is None
    assert analysis.friction is None
    assert analysis.notes == ()
    mapping = analysis.to_mapping()
    assert mapping.pop("film") is None
    assert mapping.pop("friction") is None
    assert mapping.pop("life") is None
    frequencies = mapping.pop("frequencies")
    assert frequencies == frequencies_of(analysis.solved).to_mapping()
    assert mapping == analysis.solved.to_mapping()


def test_oil_and_coefficient_make_film_and_friction(oiled: Case) -> None:
    analysis = analyse(oiled)
    assert analysis.film is not None
    assert analysis.film.to_mapping() == film_of(analysis.solved).to_mapping()
    assert analysis.friction is not None
    assert analysis.notes == ()
    assert set(analysis.friction.torque_by_source) == {
        "spin", "rolling_slip", "hysteresis", "rolling_resistance"
    }  # fmt: skip
    total = sum(part[0] for part in analysis.friction.torque_by_source.values())
    assert analysis.friction.torque[0] == pytest.approx(total)


def test_the_minimum_film_parameter_decides_the_regime(oiled: Case) -> None:
    analysis = analyse(oiled)
    assert analysis.film is not None
    assert analysis.friction is not None
    assert analysis.film.minimum_film_parameter[0] > 3.0
    assert analysis.friction.regime.tolist() == ["full_film"]
    warm = oiled.replace(temperature={"lubricant": 430.0})
    mixed = analyse(warm).friction
    assert mixed is not None
    assert mixed.regime.tolist() == ["mixed"]


@pytest.mark.parametrize(
    ("changes", "film", "with_friction", "notes"),
    [
        ({"temperature": None}, False, True, ("no_temperature",)),
        ({"lubricant": "ISO VG 68"}, True, True, ()),
        (
            {"lubricant": "ISO VG 68", "temperature": None},
            False,
            False,
            ("no_temperature_no_friction",),
        ),
        ({"lubricant": "BP 135"}, False, True, ()),
        ({"surface": None}, True, True, ()),
        ({"lubricant": None}, False, False, ()),
    ],
)
def test_what_a_case_lacks_is_noted_and_not_raised(
    oiled: Case, changes: dict[str, Any], film: bool, with_friction: bool, notes: tuple[str, ...]
) -> None:
    analysis = analyse(oiled.replace(**changes))
    assert (analysis.film is not None) is film
    assert (analysis.friction is not None) is with_friction
    assert tuple(note.key for note in analysis.notes) == notes
    mapping = strict(analysis.to_json())
    assert (mapping["film"] is not None) is film
    assert (mapping["friction"] is not None) is with_friction
    assert set(notes) <= {note["key"] for note in mapping["notes"]}


def test_a_speed_that_varied_has_its_frequencies() -> None:
    """The speeds of what was solved count, not those of the case that they went over."""
    found = analyse("6310", fz=5e3, inner_speed=100.0).frequencies
    assert found is not None
    assert found.inner_speed == 100.0
    assert analyse("6310", fz=5e3).frequencies is None


def test_without_a_result_there_is_neither(oiled: Case) -> None:
    load = oiled.duty.load.replace(fx=-20e3)
    analysis = analyse(oiled.replace(duty=oiled.duty.replace(load=load)))
    assert not analysis.solved.converged[0]
    assert analysis.film is None
    assert analysis.friction is None


def test_json_has_heat_of_every_contact(oiled: Case) -> None:
    found = strict(analyse(oiled).to_json())["friction"]
    assert found["friction_coefficient"] == 0.08
    assert found["model"] == "jones_full"
    heat = sum(
        sum(value)
        for source in found["heat"].values()
        for value in (source["inner"], source["outer"])
    )
    assert heat == pytest.approx(found["power"], rel=1e-9)
    assert len(found["heat"]["spin"]["inner"]) == 16
    speed = oiled.duty.inner_speed
    assert found["torque"] * speed == pytest.approx(found["power"], rel=1e-9)
    assert set(found["models"]) == {
        "jones_full", "jones_control", "jones_simplified", "harris_1971", "todd"
    }  # fmt: skip
    assert found["models"]["todd"]["valid"] is False
    assert "inertia" in {note["key"] for note in found["models"]["todd"]["reasons"]}


def test_hysteresis_is_the_users(oiled: Case) -> None:
    parts = [analyse(oiled, hysteresis=loss).friction for loss in (0.0, 0.01, 0.02)]
    torques = [part.torque_by_source["hysteresis"][0] for part in parts if part is not None]
    assert torques[0] == 0.0
    assert torques[2] == pytest.approx(2.0 * torques[1])


def test_at_rest_there_is_a_starting_torque_and_no_power(examples: Path) -> None:
    case = load_case(examples / "ricci_fleury.toml", ["duty.inner_speed=0 rpm"])
    found = analyse(case).friction
    assert found is not None
    assert found.power[0] == 0.0
    assert found.starting_torque[0] > 0.0


# --- batches ---------------------------------------------------------------------------------


FX = np.linspace(20e3, 40e3, 7)


def test_a_batch_is_the_cases_one_by_one(oiled: Case) -> None:
    found = analyse(solve(oiled, fx=FX), model="jones_full", compare=True)
    assert found.film is not None
    assert found.friction is not None
    for index in (0, 3, 6):
        load = oiled.duty.load.replace(fx=float(FX[index]))
        one = analyse(oiled.replace(duty=oiled.duty.replace(load=load)))
        assert one.film is not None
        assert one.friction is not None
        assert found.friction.torque[index] == pytest.approx(one.friction.torque[0], rel=1e-6)
        assert found.friction.regime[index] == one.friction.regime[0]
        for name, model in one.friction.models.items():
            assert found.friction.models[name].total[index] == pytest.approx(
                model.total[0], rel=1e-6
            )
        assert found.film.to_mapping(index)["notes"] == one.film.to_mapping()["notes"]
        np.testing.assert_allclose(
            found.film.inner.central_thickness[index], one.film.inner.central_thickness[0], 1e-9
        )


def test_blocks_are_the_whole(oiled: Case, monkeypatch: pytest.MonkeyPatch) -> None:
    fx = FX.copy()
    fx[2] = -50e3  # no equilibrium
    batch = solve(oiled, fx=fx, inner_speed=np.linspace(0.0, 900.0, 7))
    whole = analyse(batch)
    monkeypatch.setattr("rolamento.numerics.blocks.BLOCK", 2)
    for threads in (1, 2):
        blocks = analyse(batch, threads=threads)
        assert whole.friction is not None
        assert blocks.friction is not None
        assert whole.film is not None
        assert blocks.film is not None
        np.testing.assert_array_equal(blocks.friction.torque, whole.friction.torque)
        np.testing.assert_array_equal(blocks.film.viscosity_ratio, whole.film.viscosity_ratio)
        for one, other in zip(blocks.friction.validity, whole.friction.validity, strict=True):
            np.testing.assert_array_equal(one.valid, other.valid)
            assert one.notes.keys() == other.notes.keys()
            for name, where in one.notes.items():
                np.testing.assert_array_equal(where, other.notes[name])
        for name, loss in blocks.friction.heat.items():
            np.testing.assert_array_equal(loss.inner, whole.friction.heat[name].inner)
        assert np.isnan(whole.friction.torque[2])
        assert np.isfinite(np.delete(whole.friction.torque, 2)).all()


def test_coefficient_and_temperature_may_vary(case_218: Case) -> None:
    case = case_218.replace(lubricant="ISO VG 68")
    bare = analyse(solve(case, fx=FX))
    assert bare.film is None
    assert bare.friction is None
    assert keys(bare.notes) == {"no_temperature_no_friction"}
    varied = {
        "duty.load.fx": FX,
        "temperature.lubricant": np.linspace(300.0, 380.0, 7),
        "lubricant.friction_coefficient": np.linspace(0.02, 0.2, 7),
    }
    found = analyse(solve(case, varied))
    assert found.film is not None
    assert found.friction is not None
    own = {"friction_coefficient": float(varied["lubricant.friction_coefficient"][3])}
    one = analyse(
        case.replace(
            lubricant=Lubricant.named("ISO VG 68").replace(**own),
            temperature={"lubricant": float(varied["temperature.lubricant"][3])},
            duty=case.duty.replace(load=case.duty.load.replace(fx=float(FX[3]))),
        ),
        model="jones_simplified",
    )
    assert one.film is not None
    assert one.friction is not None
    np.testing.assert_allclose(
        found.film.inner.central_thickness[3], one.film.inner.central_thickness[0], rtol=1e-9
    )
    np.testing.assert_allclose(found.friction.torque[3], one.friction.torque[0], rtol=1e-9)


# --- import ----------------------------------------------------------------------------------


def test_the_names_are_there_when_asked_for() -> None:
    for name in ("Analysis", "Lubricant", "Surface", "Temperature", "analyse"):
        assert name in rolamento.__all__
        assert getattr(rolamento, name).__name__ == name


def test_a_plain_case_does_not_load_film_or_friction(examples: Path) -> None:
    code = (
        "import sys, rolamento\n"
        f"rolamento.analyse(rolamento.load_case({str(examples / '218_combined.toml')!r}))\n"
        "bad = [n for n in sys.modules if n.startswith(('rolamento.friction',"
        " 'rolamento.lubrication', 'rolamento.oil'))]\n"
        "assert not bad, bad\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_a_designation_brings_life_and_the_models_of_machine_bearings() -> None:
    """Sizes, ratings and series come from the catalogue, the viscosity from the film."""
    case = Case(
        bearing={"designation": "6305"},
        duty={"inner_speed": 200.0, "load": {"fz": 2e3}},
        lubricant=Lubricant.named("ISO VG 68").replace(friction_coefficient=0.08),
        temperature={"lubricant": 340.0},
    )
    found = analyse(case)
    assert found.life is not None
    assert found.life.rating_sources["dynamic"].startswith("NSK")
    assert found.friction is not None
    assert {"palmgren", "skf"} <= set(found.friction.models)
    by_hand = palmgren(
        kind="deep_groove",
        lubrication="oil_bath",
        speed=200.0,
        mean_diameter=0.0435,
        kinematic_viscosity=found.film.kinematic_viscosity[0] if found.film else 0.0,
        radial_load=2e3,
        axial_load=0.0,
        static_load_ratio=2e3 / 11_200.0,
    )
    assert found.friction.models["palmgren"].total[0] == pytest.approx(by_hand.total)


def test_skfs_constants_are_for_another_angle_than_a_spindle_bearings() -> None:
    case = Case(
        bearing={"designation": "EX 70 25deg"},
        duty={"inner_speed": 200.0, "load": {"fx": 2e3}},
        lubricant=Lubricant.named("ISO VG 68").replace(friction_coefficient=0.08),
        temperature={"lubricant": 340.0},
    )
    found = analyse(case)
    assert found.friction is not None
    assert "palmgren" in found.friction.models
    (validity,) = (own for own in found.friction.validity if own.model == "skf")
    assert validity.notes["other_angle"].all()
    assert not validity.valid.any()


def test_why_there_is_no_life(case_218: Case) -> None:
    steep = case_218.replace(
        bearing=case_218.bearing.replace(contact_angle=np.radians(50.0)),
        duty=case_218.duty.replace(load=Load(fx="30 kN", fz="15 kN")),
        life={},
    )
    found = analyse(steep)
    assert found.life is None
    assert keys(found.notes) == {"life_of_thrust_bearing"}


def test_a_setting_opens_a_lubricant_that_is_given_by_name() -> None:
    text = "\n".join(
        [
            'lubricant = "ISO VG 68"',
            "[bearing]",
            'designation = "6305"',
            "[duty]",
            'load = { fz = "1 kN" }',
        ]
    )
    case = parse_case(text, overrides=["lubricant.friction_coefficient=0.08"])
    assert case.lubricant == Lubricant.named("ISO VG 68").replace(friction_coefficient=0.08)
    thicker = parse_case(text, overrides=["lubricant.viscosity_40=80 mm^2/s"])
    assert thicker.lubricant is not None
    assert thicker.lubricant.viscosity_40 == pytest.approx(80e-6)


def part_of(mapping: Any, whole: Any) -> Any:
    """What a mapping lacks of another, by its paths; what both have is alike, to the last bit."""
    if not isinstance(mapping, dict):
        assert mapping == whole
        return set()
    assert mapping.keys() <= whole.keys()
    lacks = whole.keys() - mapping.keys()
    inner = ({f"{name}.{one}" for one in part_of(mapping[name], whole[name])} for name in mapping)
    return lacks.union(*inner)


OTHER_MODELS = {"jones_control", "jones_simplified", "harris_1971", "todd"}


def test_a_quick_analysis_is_a_part_of_the_full_one() -> None:
    case = Case(
        bearing={"designation": "6305"},
        duty={"inner_speed": "3000 rpm", "load": {"fz": "4 kN"}},
        lubricant=Lubricant.named("ISO VG 68").replace(friction_coefficient=0.08),
        temperature=WARM,
        surface=SURFACE,
        life={"cleanliness": "-/17/14", "oil_supply": "bath"},
    )
    full = analyse(case)
    quick = analyse(full.solved, quick=True)
    assert (full.left_out, quick.left_out) == ((), ("friction_models", "stress_volume"))
    whole, part = full.to_mapping(), quick.to_mapping()
    assert {note["key"] for note in part.pop("notes")} - {n["key"] for n in whole.pop("notes")} == {
        "without_friction_models", "without_stress_volume"
    }  # fmt: skip
    assert part_of(part, whole) == {
        "life.theories.ioannides_harris",
        *(f"friction.models.{name}" for name in OTHER_MODELS),
    }
    compared = analyse(full.solved, quick=True, compare=True)
    assert compared.left_out == ("stress_volume",)
    assert analyse(case, quick=True, model="todd").friction.models.keys() >= {"todd"}


def test_a_quick_analysis_does_not_look_for_the_loss_of_preload(examples: Path) -> None:
    case = load_case(examples / "6012_pair.toml")
    full, quick = analyse(case), analyse(case, quick=True)
    assert quick.left_out == ("preload_loss",)
    assert quick.notes[0].key == "without_preload_loss"
    whole, part = full.to_mapping(), quick.to_mapping()
    assert part_of(part["preload"], whole["preload"]) == {
        "lift_factor", "lift_row", "loss_factor", "lost_row"
    }  # fmt: skip
    text = quick.solved.to_json()
    assert rolamento.Solved.from_json(text).to_json() == text
    assert rolamento.Solved.from_json(text).preload == quick.solved.preload
    unloaded = case.replace(duty={"inner_speed": case.duty.inner_speed})
    assert analyse(unloaded, quick=True).left_out == ()  # there is no loss to look for


def test_a_model_that_was_left_out_may_be_valid(oiled: Case) -> None:
    full, quick = analyse(oiled, compare=True), analyse(oiled, quick=True)
    assert full.friction is not None
    assert quick.friction is not None
    assert full.friction.without_model(full.solved)[0].key == "no_valid_torque_model"
    assert quick.friction.without_model(quick.solved) == ()
