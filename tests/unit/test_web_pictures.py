"""The app's pictures show the numbers of the records, in the units that people read."""

from __future__ import annotations

import json
from functools import cache
from math import degrees
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import rolamento
from rolamento import Analysis, analyse
from rolamento.case import Case, case_of
from rolamento.charts.limits import decades, reach, rounded_up
from rolamento.tasks.report import analysis_of
from rolamento.web.pictures import PICTURES, described, figures
from rolamento.words import speaking

EXAMPLES = Path(rolamento.__file__).parent / "examples"


@cache
def analysis(name: str, *settings: str) -> Analysis:
    return analysis_of(case_of(str(EXAMPLES / f"{name}.toml"), settings))


def trace(picture: Any, name: str) -> Any:
    return next(one for one in picture["data"] if one["name"] == name)


def every_number(value: Any) -> list[float]:
    if isinstance(value, dict):
        return [x for one in value.values() for x in every_number(one)]
    if isinstance(value, list | tuple):
        return [x for one in value for x in every_number(one)]
    return [value] if isinstance(value, float) else []


NAMES = ("218_combined", "6305_film", "6310_motor", "nu205_gear", "30206_pinion", "6012_triple")


@pytest.mark.parametrize("name", NAMES)
def test_pictures_are_plain_bounded_json_in_both_languages(name: str) -> None:
    for language in ("en", "pt_BR"):
        with speaking(language):
            found = figures([analysis(name)], PICTURES)
        text = json.dumps(found, allow_nan=False)
        assert json.loads(text) == found
        assert set(found) == set(PICTURES)
        assert len(text) < 150_000
        for picture in found.values():
            assert picture["summary"]
            assert picture["empty"] is (not picture["data"])


def test_a_bearing_that_nothing_loads_is_asked_for_a_speed_and_a_load() -> None:
    found = figures(
        [analyse(Case(bearing={"designation": "6310"}, duty={}))], ("rosette", "pressures")
    )
    assert {picture["summary"] for picture in found.values()} == {
        "no load is given yet: give a speed and a load"
    }
    assert all(picture["empty"] for picture in found.values())
    loaded = Case(bearing={"designation": "6310"}, duty={"load": {"fz": "2 kN"}})
    both = figures(
        [analyse(Case(bearing={"designation": "6310"}, duty={})), analyse(loaded)], ("loads",)
    )
    assert not both["loads"]["empty"]


def test_loads_are_those_of_the_json() -> None:
    found = figures([analysis("218_combined")], ["loads", "rosette", "pressures", "angles"])
    balls = analysis("218_combined").to_mapping()["balls"]
    azimuth = [degrees(ball["azimuth"]) for ball in balls]
    for key, column, factor in (
        ("loads", "load", 1.0),
        ("pressures", "max_pressure", 1e-6),
        ("angles", "contact_angle", degrees(1.0)),
    ):
        for race in ("inner", "outer"):
            line = trace(found[key], race)
            assert line["x"][1:-1] == pytest.approx(azimuth)
            assert line["y"][1:-1] == pytest.approx([ball[race][column] * factor for ball in balls])
            assert (line["x"][0], line["y"][0]) == pytest.approx((azimuth[-1] - 360, line["y"][-2]))
    round_about = trace(found["rosette"], "outer")
    assert round_about["r"] == pytest.approx([ball["outer"]["load"] for ball in [*balls, balls[0]]])
    assert trace(found["angles"], "free (unloaded)")["y"] == pytest.approx([40.0, 40.0])


def test_ellipses_lie_where_the_contacts_are() -> None:
    found = figures([analysis("218_combined")], ["ellipses"])["ellipses"]
    balls = analysis("218_combined").to_mapping()["balls"]
    outline = np.array(trace(found, "inner: contact ellipse")["y"], dtype=float)
    each = np.split(outline, np.flatnonzero(np.isnan(outline)))[: len(balls)]
    high = [np.nanmax(one) for one in each]
    low = [np.nanmin(one) for one in each]
    radius = 0.5232 * 22.23
    assert 0.5 * (np.array(high) + low) == pytest.approx(
        [radius * ball["inner"]["contact_angle"] for ball in balls], rel=1e-3
    )
    assert np.subtract(high, low) == pytest.approx(
        [2e3 * ball["inner"]["semi_major"] for ball in balls], rel=2e-3
    )


def test_ellipses_over_the_edge_are_named() -> None:
    low = analysis("218_combined", "bearing.inner_shoulder_height=8 mm")
    found = figures([low], ["ellipses"])["ellipses"]
    keys = {note.key for note in low.solved.notes[0]}
    assert "ellipse_over_shoulder" in keys
    assert trace(found, "inner: ellipse over the edge")["line"]["color"] == "bad"
    assert trace(found, "edge of the groove")
    assert "inner at" in found["summary"]


def test_friction_film_and_life_are_those_of_the_records() -> None:
    own = analysis("6305_film")
    found = figures([own], ["friction", "film_parameter", "film_thickness", "life"])
    mapping = own.to_mapping()
    heat = mapping["friction"]["heat"]
    sources = list(mapping["friction"]["torque_by_source"])
    for name, race in (("heat, inner", "inner"), ("heat, outer", "outer")):
        bars = trace(found["friction"], name)
        assert bars["x"] == pytest.approx([sum(heat[one][race]) for one in sources])
    assert own.film is not None
    for key, column, factor in (
        ("film_parameter", "film_parameter", 1.0),
        ("film_thickness", "central_thickness", 1e6),
    ):
        shown = np.array(trace(found[key], "outer")["y"][1:-1], dtype=float)
        assert shown == pytest.approx(factor * getattr(own.film.outer, column)[0], nan_ok=True)
    bands = found["film_parameter"]["layout"]["shapes"]
    assert [band["y0"] for band in bands] == [1.0, 0.5, 0.0] or bands[0]["y1"] > bands[-1]["y1"]
    lives = mapping["life"]["theories"]
    (bars,) = (one for one in found["life"]["data"] if one["type"] == "bar")
    assert sorted(bars["x"]) == pytest.approx(
        sorted(one["hours"] for one in lives.values() if one["hours"] is not None)
    )


def test_frequencies_are_those_under_load_with_harmonics() -> None:
    own = analysis("218_combined")
    found = figures([own], ["frequencies"])["frequencies"]
    marks = trace(found, "fault frequencies")
    line = own.to_mapping()["frequencies"]["ball_pass_outer"]
    first = marks["text"].index("1 × BPFO")
    assert marks["x"][first : first + 5] == pytest.approx(
        [n * line["frequency"] for n in range(1, 6)]
    )


def test_two_cases_lie_over_one_another_on_common_axes() -> None:
    first, other = analysis("218_combined"), analysis("218_combined", "duty.load.fz=8 kN")
    found = figures([first, other], PICTURES)
    names = [one["name"] for one in found["loads"]["data"]]
    assert names == ["A: inner", "A: outer", "B: inner", "B: outer"]
    looks = [(one["line"]["color"], one["line"]["dash"]) for one in found["loads"]["data"]]
    assert len(set(looks)) == 4
    alone = figures([other], ["loads"])["loads"]
    assert trace(found["loads"], "B: inner")["y"] == trace(alone, "inner")["y"]
    top = found["loads"]["layout"]["yaxis"]["range"][1]
    assert top >= max(x for one in found["loads"]["data"] for x in one["y"])
    assert figures([None, other], ["loads"])["loads"]["data"][0]["name"] == "B: inner"
    json.dumps(found, allow_nan=False)


def test_balls_beside_rollers_show_what_both_have() -> None:
    found = figures([analysis("218_combined"), analysis("nu205_gear")], PICTURES)
    assert {one["name"][0] for one in found["loads"]["data"]} == {"A", "B"}
    assert not any(one["name"].startswith("A") for one in found["along_roller"]["data"])
    assert trace(found["along_roller"], "B: inner")
    assert {one["name"][0] for one in found["ellipses"]["data"] if ":" in one["name"]} == {"A"}


def test_rollers_show_pressure_along_them_and_how_they_lie() -> None:
    own = analysis("nu205_gear")
    found = figures([own], ["along_roller", "between_races", "ellipses"])
    rollers = own.solved.rollers
    assert rollers is not None
    peak = float(np.nanmax(rollers.inner.pressure[0])) * 1e-6
    assert max(trace(found["along_roller"], "inner")["y"]) == pytest.approx(peak)
    assert found["between_races"]["data"]
    assert found["ellipses"]["empty"]


def test_rows_of_a_set_stand_side_by_side() -> None:
    own = analysis("6012_triple")
    found = figures([own], ["rows", "loads"])["rows"]
    assert len({one.get("xaxis") for one in found["data"]}) == len(own.solved.rows) == 3
    shown = sorted(x for one in found["data"] for x in one["y"][1:-1] if "inner" in one["name"])
    assert shown == pytest.approx(sorted(own.solved.inner.load[0].tolist()))


def test_without_a_result_there_is_no_number() -> None:
    dead = analyse(case_of(str(EXAMPLES / "218_combined.toml"), ["duty.load.fx=-50 kN"]))
    assert not dead.solved.converged[0]
    found = figures([dead], PICTURES)
    for picture in found.values():
        assert picture["empty"]
        assert every_number(picture["data"]) == []
        assert picture["summary"].startswith("No result")
    beside = figures([dead, analysis("218_combined")], ["loads"])["loads"]
    assert {one["name"][0] for one in beside["data"]} == {"B"}


def test_missing_parts_say_what_they_need() -> None:
    case = Case.from_mapping({
        "bearing": {"ball_count": 8, "ball_diameter": "12 mm", "pitch_diameter": "50 mm",
                    "contact_angle": "25 deg", "inner_conformity": 0.52, "outer_conformity": 0.52},
        "duty": {"load": {"fx": "1 kN"}},
    })  # fmt: skip
    found = figures([analyse(case)], PICTURES)
    for key in ("film_thickness", "film_parameter", "friction", "life", "frequencies"):
        assert found[key]["empty"]
        assert found[key]["summary"]


def test_unknown_keys_are_left_out_and_labels_are_translated() -> None:
    assert figures([analysis("218_combined")], ["loads", "no such", "loads"]).keys() == {"loads"}
    assert [own["key"] for own in described()] == list(PICTURES)
    for own in described():
        assert set(own["of"]) <= {"ball", "roller", "set"}


def test_decimal_comma_in_portuguese() -> None:
    with speaking("pt_BR"):
        found = figures([analysis("218_combined")], ["loads"])["loads"]
    assert found["layout"]["separators"][0] == ","


def test_limits_of_axes_are_round_and_hold_all() -> None:
    assert rounded_up(6.3e3) == pytest.approx(8e3)
    assert rounded_up(0.0) == 1.0
    low, high = reach([36.2, 69.3])
    assert low <= 36.2 < 69.3 <= high
    assert reach([5.0, 9.9], zero=True)[0] == 0.0
    assert reach([np.nan]) == [0.0, 1.0]
    assert reach([0.0, 0.0], least=1.0)[1] - reach([0.0, 0.0], least=1.0)[0] >= 0.2
    limits = decades([300.0, 2e4])
    assert limits is not None
    assert limits[0] <= np.log10(300.0) < np.log10(2e4) <= limits[1]
    assert decades([np.nan, np.inf, 0.0]) is None
