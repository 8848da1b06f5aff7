"""Design questions of the page: what would help, and which input gives a wanted result."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from rolamento import analyse, solve
from rolamento.case import Case
from rolamento.case.fields import changed
from rolamento.errors import InputError
from rolamento.tasks import tolerance_of_case
from rolamento.web.design import helps, seek, tolerance
from rolamento.web.live import live

CASE: dict[str, Any] = {
    "bearing": {"designation": "6310"},
    "duty": {"inner_speed": "1480 rpm", "load": {"fz": "10 kN"}},
    "lubricant": "ISO VG 68",
    "temperature": {"lubricant": "70 degC"},
    "life": {"contamination": 0.5},
}


def hours(tables: dict[str, Any]) -> float:
    found = analyse(Case.from_mapping(tables)).life
    assert found is not None
    return float(found.headline.hours[0])


def test_what_helps_gives_the_life_that_it_promises() -> None:
    trials = {one["name"]: one for one in helps({"case": CASE})["trials"]}
    for name in ("less_load", "cleaner_oil"):
        tried = changed(CASE, trials[name]["changes"], Case, in_file=True)
        assert hours(tried) / hours(CASE) == pytest.approx(trials[name]["ratio"], rel=1e-3), name
    assert trials["thicker_oil"]["changes"] == {"lubricant": "ISO VG 100"}


def test_nothing_helps_a_case_without_a_result() -> None:
    lost = {"bearing": {"designation": "7210 B"}, "duty": {"load": {"fx": "-5 kN"}}}
    assert helps({"case": lost}) == {"trials": []}


@pytest.mark.parametrize("designation", ["7210 B", "7014 C DT", "32008"])
@pytest.mark.parametrize("speed", ["100 rpm", "9000 rpm"])
def test_a_missing_axial_load_is_one_that_holds(designation: str, speed: str) -> None:
    bearing = {"designation": designation}
    if designation.endswith("DT"):
        bearing["spacing"] = "20 mm"
    lost = {"bearing": bearing, "duty": {"inner_speed": speed, "load": {"fz": "5 kN"}}}
    (trial,) = helps({"case": lost})["trials"]
    held = changed(lost, trial["changes"], Case, in_file=True)
    assert list(trial["changes"]) == ["duty.load.fx"]
    assert solve(Case.from_mapping(held)).converged[0]


@pytest.mark.parametrize(
    ("lubricant", "name"),
    [("ISO VG 68", "oil"), ({"kind": "grease", "base_oil": "ISO VG 100"}, "grease")],
)
def test_the_speed_stands_beside_its_limit(lubricant: Any, name: str) -> None:
    for speed, tone in (("1480 rpm", ""), ("9000 rpm", "warning")):
        case = {**CASE, "lubricant": lubricant, "duty": {**CASE["duty"], "inner_speed": speed}}
        figures = {one["label"]: one for one in live({"cases": [{"case": case}]})["figures"][0]}
        assert figures["speed"]["limit"].endswith(f"rpm ({name})")
        assert figures["speed"]["tone"] == tone


def test_what_is_refused_names_fields_as_the_page_does() -> None:
    case = {**CASE, "life": {"cleanliness": "-/17/14"}}
    (answer,) = live({"cases": [{"case": case}]})["cases"]
    assert answer["error"]["field"] == "life.oil_supply"
    assert answer["error"]["rule"] == "is missing; “cleanliness code (ISO 4406)” needs it"


def test_a_goal_is_found_and_gives_the_result() -> None:
    found = seek({"case": CASE, "vary": "duty.load.fz", "output": "max_inner_max_pressure",
                  "wanted": "2 GPa"})  # fmt: skip
    (one,) = found["found"]
    tried = changed(CASE, {found["field"]: one["value"]}, Case, in_file=True)
    pressure = solve(Case.from_mapping(tried)).inner.max_pressure.max()
    assert pressure == pytest.approx(2e9, rel=1e-5)
    assert found["picture"]["data"]
    assert found["good"]


def test_a_goal_says_what_there_is_to_choose_from() -> None:
    offered = seek({"case": CASE})
    assert "statement" not in offered
    assert offered["outputs"][0]["name"] == "life_hours"
    assert offered["outputs"][0]["unit"] == "h"


@pytest.mark.parametrize("request_", [{}, {"case": 3}, {"case": CASE, "vary": 3, "wanted": "1"}])
def test_a_wrong_question_is_refused(request_: dict[str, Any]) -> None:
    with pytest.raises(InputError):
        seek(request_)


def test_sliders_go_to_half_the_rating() -> None:
    answer = live({"cases": [{"case": CASE}]})["cases"][0]
    assert answer["likely"]["duty.load.fz"]["most"] == pytest.approx(0.5 * 62e3)
    assert answer["likely"]["duty.load.fz"]["example"].endswith("kN")
    assert answer["likely"]["duty.inner_speed"]["example"].endswith("rpm")


def test_four_cases_have_names_and_their_differences() -> None:
    changes = [{}, {"duty.load.fz": "5 kN"}, {"duty.load.fz": "6 kN"}, {}]
    cases = [{"case": CASE, "changes": one, "name": f"case {n}"} for n, one in enumerate(changes)]
    answer = live({"cases": cases, "active": 2, "pictures": ["loads"]})
    assert len(answer["figures"]) == 4
    assert "case 3" in answer["summary"]
    assert "pressure" in answer["summary"]
    assert "pressure" not in answer["same"]
    assert "κ" in answer["same"]
    names = {one["name"] for one in answer["pictures"]["loads"]["data"]}
    assert any("case 2" in name for name in names)
    assert not any("case 1" in name for name in names)
    with pytest.raises(InputError, match="1 to 4"):
        live({"cases": [*cases, cases[0]]})


def test_a_base_oil_takes_the_place_of_an_oils_own_viscosities() -> None:
    tables = {**CASE, "lubricant": "ISO VG 32"}
    tried = changed(tables, {"lubricant.base_oil": "ISO VG 32"}, Case, in_file=True)
    case = Case.from_mapping(tried)
    assert case.lubricant is not None
    assert case.lubricant.base_oil == "ISO VG 32"


def test_percentiles_of_the_life_are_the_lives_at_percentiles_of_the_load() -> None:
    case = Case.from_mapping(CASE)
    found = tolerance_of_case(case, {"duty.load.fz": 1e3}, ("life_hours",))
    loads = found.samples.inputs[0].values
    for life, percent in zip(found.bands["life_hours"].percentile, (95, 50, 5), strict=True):
        load = {"duty.load.fz": f"{np.percentile(loads, percent)} N"}
        assert life == pytest.approx(hours(changed(CASE, load, Case, in_file=True)), rel=0.02)
    assert 9e3 <= loads.min() < 9.2e3 < 10.8e3 < loads.max() <= 11e3  # cut off at the tolerance
    assert loads.std() == pytest.approx(1e3 / 3.0, rel=0.1)


def test_what_scatters_is_offered_and_shown() -> None:
    offered = tolerance({"case": CASE})
    fields = {one["name"]: one for one in offered["fields"]}
    assert offered["fields"][0]["name"] == "bearing.diametral_clearance"
    assert fields["duty.load.fz"]["most"] == pytest.approx(5e3)
    assert (fields["duty.load.fz"]["unit"], fields["duty.load.fz"]["factor"]) == ("kN", 1e3)
    assert fields["temperature.lubricant"]["unit"] == "K"
    assert fields["bearing.inner_conformity"]["most"] <= 0.02
    assert "table" not in offered
    scatter = {"bearing.diametral_clearance": 5e-6, "duty.load.fz": 500.0}
    found = tolerance({"case": CASE, "scatter": scatter, "output": "max_inner_max_pressure"})
    assert found["output"] == "max_inner_max_pressure"
    assert found["picture"]["layout"]["xaxis"]["title"]["text"].endswith("(MPa)")
    assert "95\u00a0%" in found["table"]


@pytest.mark.parametrize("scatter", [3, {"duty.load.fz": "x"}, {"duty.load.fz": 9e3},
                                     {"duty.load.fz": -1.0}, {"no.such": 1.0}])  # fmt: skip
def test_a_wrong_tolerance_is_refused(scatter: Any) -> None:
    with pytest.raises(InputError):
        tolerance({"case": CASE, "scatter": scatter})
