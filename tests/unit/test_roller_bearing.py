"""Bearings of rollers as they are given: records, files, sets of both kinds, the result's JSON."""

from __future__ import annotations

import json
from math import radians
from typing import Any

import numpy as np
import pytest

import rolamento
from rolamento.case import Bearing, Case, load_case, parse_case
from rolamento.case.bearing import ball_bearing
from rolamento.case.roller_bearing import RollerBearing
from rolamento.errors import InputError
from rolamento.solved import Solved

NU: dict[str, Any] = {
    "element": "cylindrical",
    "roller_count": 13,
    "roller_diameter": "7.5 mm",
    "effective_length": "8.2 mm",
    "pitch_diameter": "38.5 mm",
    "diametral_clearance": "30 um",
}
CONE: dict[str, Any] = {
    "element": "tapered",
    "roller_count": 17,
    "roller_diameter": "7.5 mm",
    "effective_length": "10 mm",
    "pitch_diameter": "46 mm",
    "contact_angle": "14 deg",
    "roller_half_angle": "1.9 deg",
}
BALLS: dict[str, Any] = {
    "ball_count": 10,
    "ball_diameter": "12.7 mm",
    "pitch_diameter": "70 mm",
    "diametral_clearance": "10 um",
    "inner_conformity": 0.52,
    "outer_conformity": 0.53,
}


def case_of(bearing: dict[str, Any], **duty: Any) -> Case:
    return Case.from_mapping({"bearing": bearing, "duty": duty})


def test_the_element_tells_the_record() -> None:
    rollers, balls = case_of(NU).bearing, case_of(BALLS).bearing
    assert isinstance(rollers, RollerBearing)
    assert isinstance(balls, Bearing)
    assert (rollers.element_count, rollers.element_diameter) == (13, 7.5e-3)
    assert (balls.element_count, balls.element_diameter) == (10, 12.7e-3)
    assert rollers.roller_length == rollers.effective_length
    assert (rollers.inner_ribs, rollers.outer_ribs) == ("none", "both")
    assert (rollers.roller_profile.kind, rollers.inner_profile.kind) == ("iso", "none")
    assert not rollers.carries_one_way
    cone = case_of(CONE).bearing
    assert isinstance(cone, RollerBearing)
    assert cone.carries_one_way
    assert cone.inner_contact_angle == pytest.approx(radians(14.0 - 2 * 1.9))


@pytest.mark.parametrize(
    ("bearing", "field", "rule"),
    [
        ({k: v for k, v in NU.items() if k != "element"}, "bearing.element", "is missing"),
        ({**NU, "element": "cone"}, "bearing.element", "tapered, needle, barrel"),
        ({**NU, "element": ["cylindrical"]}, "bearing.element", "must be"),
        ({**NU, "ball_count": 9}, "bearing.ball_count", "unknown key"),
        ({**NU, "roller_diametre": "7 mm"}, "bearing.roller_diametre", "roller_diameter"),
        ({**NU, "roller_count": 17}, "bearing.roller_count", "there is room for 16"),
        ({**NU, "pitch_diameter": "7 mm"}, "bearing.pitch_diameter", "roller diameter"),
        ({**NU, "roller_length": "8 mm"}, "bearing.roller_length", "effective length"),
        ({**NU, "contact_angle": "10 deg"}, "bearing.contact_angle", "tapered rollers only"),
        ({**NU, "diametral_clearance": "-1 mm"}, "bearing.diametral_clearance", "greater than"),
        ({**NU, "roller_profile": "barrel"}, "bearing.roller_profile", "iso"),
        ({**CONE, "diametral_clearance": "1 um"}, "bearing.diametral_clearance", "cylindrical"),
        ({**CONE, "roller_half_angle": "8 deg"}, "bearing.roller_half_angle", "half the contact"),
        ({**CONE, "effective_length": "250 mm"}, "bearing.roller_half_angle", "small end"),
        ({**NU, "rows": [1]}, "bearing.rows.0", "must be a table"),
        (
            {**NU, "rows": [{"element": "cylindrical", "position": "0 mm", "ball_count": 3}]},
            "bearing.rows.0.ball_count",
            "unknown key",
        ),
    ],
)
def test_what_is_refused(bearing: dict[str, Any], field: str, rule: str) -> None:
    with pytest.raises(InputError, match=rule) as caught:
        case_of(bearing)
    assert caught.value.field == field


def test_slices_are_odd() -> None:
    with pytest.raises(InputError, match="must be odd"):
        Case.from_mapping({"bearing": NU, "duty": {}, "model": {"slices": 34}})
    coupled = {"slices": 303, "roller_contact": "coupled"}
    with pytest.raises(InputError, match="at most 301"):
        Case.from_mapping({"bearing": NU, "duty": {}, "model": coupled})
    assert "slices" not in Case.from_mapping({"bearing": BALLS, "duty": {}}).to_mapping()["model"]
    given = Case.from_mapping({"bearing": NU, "duty": {}, "model": {"slices": 51}})
    assert given.to_mapping()["model"]["slices"] == 51


@pytest.mark.parametrize(
    "bearing",
    [
        NU,
        CONE,
        {**NU, "roller_profile": {"kind": "crowned", "radius": "2 m"}, "inner_ribs": "-"},
        {**CONE, "arrangement": "DB", "spacing": "20 mm", "preload": "500 N"},
        {"rows": [{**BALLS, "position": "-20 mm"}, {**NU, "position": "20 mm"}]},
        {"rows": [{**NU, "position": "-20 mm"}, {**CONE, "position": "20 mm"}]},
        {"rows": [{"designation": "6210", "position": "0 mm"}, {**NU, "position": "9 mm"}]},
    ],
)
def test_a_case_is_written_and_read(bearing: dict[str, Any]) -> None:
    case = case_of(bearing, load={"fz": "1 kN"})
    assert Case.from_mapping(case.to_mapping()) == case
    assert parse_case(rolamento.case.case_to_toml(case), format="toml") == case


def test_a_set_of_both_kinds() -> None:
    case = case_of({"rows": [{**BALLS, "position": "-20 mm"}, {**NU, "position": "20 mm"}]})
    assert isinstance(case.bearing, Bearing)
    balls, rollers = case.bearing.places
    assert (balls.bearing.element, rollers.bearing.element) == ("ball", "cylindrical")
    assert isinstance(rollers.bearing, RollerBearing)
    with pytest.raises(InputError, match="ball bearings only"):
        ball_bearing(case)


@pytest.mark.parametrize("bearing", [RollerBearing.named("NU 205"), Bearing.named("6205")])
def test_a_mounting_takes_its_sizes_from_a_bearings_record(bearing: Any) -> None:
    case = Case(bearing=bearing, duty={}, mounting={"shaft_tolerance": "k5"})
    assert case.mounting is not None
    sizes = case.mounting.bore, case.mounting.outside_diameter
    assert sizes == pytest.approx((0.025, 0.052))


@pytest.mark.parametrize(
    ("bearing", "elements"),
    [
        ({"designation": "N 416"}, ["cylindrical"] * 2),
        ({"designation": "30206"}, ["tapered"] * 2),
        ({"designation": "6210"}, ["ball"] * 2),
        (NU, ["cylindrical"] * 2),
        (CONE, ["tapered"] * 2),
        (BALLS, ["ball"] * 2),
        ({"designation": "30206", "second": {"designation": "NU 210"}}, ["tapered", "cylindrical"]),
        ({"designation": "6210", "second": NU}, ["ball", "cylindrical"]),
    ],
)
def test_a_row_that_does_not_say_is_of_its_bearings_elements(
    bearing: dict[str, Any], elements: list[str]
) -> None:
    given = dict(bearing)
    second = given.pop("second", {})
    rows = [{"position": "-20 mm"}, {"position": "20 mm", **second}]
    case = case_of({**given, "rows": rows})
    assert [place.bearing.element for place in case.bearing.places] == elements
    assert case.bearing.element == elements[0]
    assert Case.from_mapping(case.to_mapping()) == case
    if second:
        return
    one = case_of({**given, "rows": [{"element": elements[0], "position": "0 mm"}]})
    assert case.with_(bearing__rows=[{"position": 0.0}]) == one
    count = next(name for name in ("roller_count", "ball_count") if hasattr(case.bearing, name))
    fewer = case.with_(bearing__rows=[{"position": 0.0, count: 9}])
    assert [place.bearing.element_count for place in fewer.bearing.places] == [9]


def test_rows_by_designation_are_those_bearings() -> None:
    rows = [
        {"designation": name, "position": f"{x} mm"} for name, x in (("6210", -20), ("6310", 20))
    ]
    case = case_of({"rows": rows})
    first, second = (place.bearing for place in case.bearing.places)
    assert isinstance(first, Bearing)
    assert isinstance(second, Bearing)
    for place, name in ((first, "6210"), (second, "6310")):
        alone = Bearing.named(name)
        assert (place.ball_count, place.ball_diameter, place.pitch_diameter) == (
            alone.ball_count, alone.ball_diameter, alone.pitch_diameter,
        )  # fmt: skip


def test_a_designation_says_what_rolls_in_a_row() -> None:
    rows = {"6210": "-40 mm", "NU 210": "0 mm", "30210": "40 mm"}
    case = case_of({"rows": [{"designation": n, "position": x} for n, x in rows.items()]})
    elements = [place.bearing.element for place in case.bearing.places]
    assert elements == ["ball", "cylindrical", "tapered"]
    assert Case.from_mapping(case.to_mapping()) == case
    rollers = case_of({"rows": [{"designation": n, "position": rows[n]} for n in list(rows)[1:]]})
    assert [place.bearing.element for place in rollers.bearing.places] == elements[1:]
    assert isinstance(rollers.bearing, RollerBearing)


def test_settings_and_variants_of_rollers() -> None:
    case = case_of(NU, load={"fz": "1 kN"})
    assert case.with_({"bearing.roller_profile": "none"}).bearing.roller_profile.kind == "none"
    wider = case.with_({"bearing.effective_length": 9e-3})
    assert wider.bearing.roller_length == 9e-3
    balls = case.with_({"bearing": BALLS})
    assert isinstance(balls.bearing, Bearing)
    with pytest.raises(InputError, match="no quantity of such a bearing"):
        rolamento.solve(case, {"bearing.ball_diameter": [1e-3, 2e-3]})


def test_cases_that_the_record_refuses_are_not_solved() -> None:
    case = case_of({**NU, "roller_length": "9 mm"}, load={"fz": "1 kN"}, displacement={"x": "0 mm"})
    lengths = np.array([8.2e-3, 30e-3, 8e-3])
    solved = rolamento.solve(case, {"bearing.effective_length": lengths})
    assert solved.status.code.tolist() == ["converged", "invalid_input", "converged"]


@pytest.fixture(scope="module")
def solved() -> Solved:
    rows = [{**BALLS, "position": "-20 mm"}, {**NU, "position": "20 mm"}]
    duty = {"load": {"fz": "5 kN"}, "displacement": {"x": "0 mm", "ry": "0.1 deg"}}
    return rolamento.solve(case_of({"rows": rows}, inner_speed="3000 rpm", **duty))


def test_json_of_a_set_of_both(solved: Solved) -> None:
    text = solved.to_json()
    state = json.loads(text)
    assert (len(state["balls"]), len(state["rollers"])) == (10, 13)
    assert {ball["row"] for ball in state["balls"]} == {0}
    assert {roller["row"] for roller in state["rollers"]} == {1}
    assert (state["slices"], state["roller_contact"]) == (35, "slices")
    roller = max(state["rollers"], key=lambda one: one["inner"]["load"])
    width = 8.2e-3 / 35
    carried = sum(roller["inner"]["load_per_length"]) * width
    assert carried == pytest.approx(roller["inner"]["load"], rel=1e-9)
    assert roller["inner"]["max_pressure"] == max(roller["inner"]["pressure"])
    assert state["rows"][1]["roller_count"] == 13
    assert "inner_conformity" not in state["rows"][1]
    assert Solved.from_json(text).to_json() == text


@pytest.mark.parametrize(
    ("change", "field"),
    [
        (lambda s: s.pop("slices"), "slices"),
        (lambda s: s.update(slices=1e9), "slices"),
        (lambda s: s["rollers"][0]["inner"]["pressure"].pop(), "rollers.0.inner.pressure"),
        (lambda s: s["rollers"][0].pop("slice_place"), "rollers.0.slice_place"),
        (lambda s: s["rollers"][0]["inner"].update(pressure="x"), "rollers.0.inner.pressure"),
        (lambda s: s["rollers"].clear(), "rows"),
    ],
)
def test_hostile_json_of_rollers(solved: Solved, change: Any, field: str) -> None:
    state = json.loads(solved.to_json())
    change(state)
    with pytest.raises(InputError) as caught:
        Solved.from_mapping(state)
    assert caught.value.field == field


def test_a_file_of_a_roller_bearing(tmp_path: Any) -> None:
    lines = [f"{k} = {json.dumps(v)}" for k, v in NU.items()]
    path = tmp_path / "nu.toml"
    path.write_text("[bearing]\n" + "\n".join(lines) + '\n[duty.load]\nfz = "1 kN"\n', "utf-8")
    case = load_case(path, ["bearing.roller_profile={ kind = 'crowned', radius = '1 m' }"])
    assert isinstance(case.bearing, RollerBearing)
    assert case.bearing.roller_profile.radius == 1.0
