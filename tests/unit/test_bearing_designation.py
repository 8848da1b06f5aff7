"""A bearing given by its designation: what is filled in, what is the user's, what is written."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from rolamento import Bearing, Case, Duty, InputError, Load, studies
from rolamento.case import case_to_json, case_to_toml, override, parse_case
from rolamento.clearance import class_clearance

CASE = '[bearing]\ndesignation = "{}"\n{}\n[duty.load]\nfz = "5 kN"\n'


def test_deep_groove_bearing() -> None:
    bearing = Bearing.named("6305/C3")
    assert (bearing.ball_count, bearing.ball_diameter) == (8, pytest.approx(13 / 32 * 25.4e-3))
    assert bearing.inner_conformity == bearing.outer_conformity == 0.52
    assert bearing.contact_angle is None
    assert bearing.diametral_clearance == pytest.approx(class_clearance(0.025, "C3").middle)
    assert Bearing.named("6305").diametral_clearance == pytest.approx(12.5e-6)


def test_angular_contact_bearing() -> None:
    bearing = Bearing.named("S 6012 C", ball_material="Si3N4")
    assert bearing.contact_angle == pytest.approx(np.radians(15.0))
    assert bearing.diametral_clearance is None
    assert bearing.origins["pitch_diameter"] == "published"
    assert bearing.ball_material.name == "Si3N4"


def test_origins() -> None:
    bearing = Bearing.named("6305", inner_conformity=0.515)
    assert bearing.origins["inner_conformity"] == "given"
    assert bearing.origins["outer_conformity"] == "assumed"
    assert bearing.origins["ball_count"] == "inferred"
    plain = Bearing.named("6305").model_dump() | {"designation": None}
    assert Bearing(**plain).origins == {}


def test_own_fields_go_over_the_catalogue() -> None:
    bearing = Bearing.named("6305/C3", ball_count=7, contact_angle="12 deg")
    assert bearing.ball_count == 7
    assert bearing.diametral_clearance is None
    assert bearing.model_fields_set == {"designation", "ball_count", "contact_angle"}
    other = bearing.replace(contact_angle=None, diametral_clearance=1e-5)
    assert (other.ball_count, other.diametral_clearance) == (7, 1e-5)
    again = bearing.replace(contact_angle=None)
    assert again.diametral_clearance == pytest.approx(class_clearance(0.025, "C3").middle)


def test_a_file_holds_the_designation_and_what_is_given() -> None:
    case = parse_case(CASE.format("6305/C3", "inner_conformity = 0.515"))
    written = case.to_mapping()["bearing"]
    assert written["designation"] == "6305/C3"
    assert written["inner_conformity"] == 0.515
    assert not {"ball_count", "diametral_clearance", "outer_conformity"} & written.keys()


@pytest.mark.parametrize("name", ["6305", "6203/C4", "EX 70 25deg", "S 6012 C", "7218B", "6821"])
@pytest.mark.parametrize("own", ["", 'pitch_diameter = "133.33 mm"', "outer_conformity = 0.53"])
def test_round_trip(name: str, own: str) -> None:
    case = parse_case(CASE.format(name, own))
    for again in (
        parse_case(case_to_toml(case), format="toml"),
        parse_case(case_to_json(case), format="json"),
        override(case, []),
        Case(**case.model_dump()),
        pickle.loads(pickle.dumps(case)),
    ):
        assert again == case
        assert hash(again) == hash(case)
        assert repr(again.model_dump()) == repr(case.model_dump())
    python = Bearing.named(name, **{key: case.bearing.model_dump()[key] for key in _keys(own)})
    assert python == case.bearing


def _keys(own: str) -> list[str]:
    return [own.split(" = ")[0]] if own else []


def test_settings() -> None:
    case = parse_case(CASE.format("6305", 'ball_diameter = "10 mm"'))
    assert override(case, ["bearing.ball_count=7"]).bearing.ball_diameter == 0.010
    other = override(case, ["bearing.designation=6306"]).bearing
    assert (other.designation, other.ball_diameter) == ("6306", pytest.approx(0.01190625))
    loose = override(case, ["bearing.diametral_clearance=0.03 mm"]).bearing
    assert loose.diametral_clearance == pytest.approx(3e-5)


def test_a_number_is_a_designation() -> None:
    assert parse_case(CASE.replace('"{}"', "6305").format("")).bearing.designation == "6305"


def test_balls_of_ones_own_need_no_ratings() -> None:
    own = {"ball_count": 13, "ball_diameter": "7.938 mm", "pitch_diameter": "38.5 mm"}
    bearing = Bearing.named("7205B", **own)
    assert bearing.contact_angle == pytest.approx(np.radians(40.0))
    assert bearing.origins["ball_count"] == "given"
    with pytest.raises(InputError, match="has no load rating to estimate the balls from: give"):
        Bearing.named("7230C", ball_count=13)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("6255", r"line 2: bearing\.designation = \"6255\": is in no catalogue; did you mean 62"),
        ("6305/C9", "no clearance class"),
        ("", "1 to 60 characters"),
        ("7205", "does not say its contact angle: write 7205C"),
        ("7230C", "no load rating"),
        ("x" * 250, "1 to 60 characters"),
    ],
)
def test_wrong_designations(name: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        parse_case(CASE.format(name, ""))


@pytest.mark.parametrize("value", [True, -5, 10**400, 62.05, ["6205"], {"a": 1}])
def test_what_is_no_designation(value: object) -> None:
    with pytest.raises(InputError, match="designation"):
        Bearing(**{"designation": value})


def test_a_class_without_a_range_for_the_bore() -> None:
    own = {"ball_count": 13, "ball_diameter": "7.938 mm", "pitch_diameter": "38.5 mm"}
    with pytest.raises(InputError, match="does not define the contact angle: give contact_angle"):
        Bearing.named("7205", **own)


def test_a_study_over_designations_and_over_what_is_filled_in() -> None:
    case = Case(bearing=Bearing.named("6305"), duty=Duty(load=Load(fz=5000.0)))
    names = studies.Axis(field="bearing.designation", values=["6305", "6306"])
    sizes = studies.Axis(field="bearing.diametral_clearance", values=["5 um", "20 um"])
    for axes, outputs in (([names], 2), ([sizes], 2), ([names, sizes], 4)):
        result = studies.run(studies.Study(case=case, axes=axes, outputs=("max_inner_load",)))
        loads = result.max_inner_load.to_numpy()
        assert loads.size == outputs
        assert np.isfinite(loads).all()
        assert np.unique(loads).size == outputs
