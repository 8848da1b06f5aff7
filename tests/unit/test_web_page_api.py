"""What the page asks: its form, opening a case, following it while it is changed, saving it."""

from __future__ import annotations

import json

import pytest

from rolamento import analyse
from rolamento.case import Case, parse_case
from rolamento.errors import InputError
from rolamento.pages.report import PARTS
from rolamento.tasks.report import analysis_of
from rolamento.units import to_si
from rolamento.web import form, live, page_api
from rolamento.words import speaking

SPINDLE = {"example": "218_combined"}


@pytest.fixture(scope="module")
def spindle() -> dict[str, object]:
    return page_api.opened(SPINDLE)["case"]


def test_every_field_of_a_case_is_in_the_form_once() -> None:
    names = [field["name"] for group in form.form() for field in group["fields"]]
    assert sorted(names) == sorted(Case.fields())
    assert set(form.FIRST) <= set(names)


def test_the_form_says_of_which_bearings_a_field_is() -> None:
    fields = {one["name"]: one for group in form.form() for one in group["fields"]}
    assert fields["bearing.ball_diameter"]["of"] == ["ball"]
    assert fields["bearing.roller_profile.kind"]["of"] == ["roller"]
    assert fields["model.raceway_control"]["of"] == ["ball"]
    assert fields["duty.load.fz"]["of"] == ["ball", "roller"]
    assert fields["bearing.contact_angle"]["replaces"] == ["bearing.diametral_clearance"]
    assert "ISO VG 68" in fields["lubricant"]["suggestions"]
    assert {one["name"] for one in fields["bearing.rows"]["entries"]} >= {"position"}


def test_units_of_the_form_are_those_that_a_file_takes() -> None:
    for dimension, units in form.units().items():
        for one in units:
            expected = to_si(f"20 {one['unit']}", dimension)  # type: ignore[arg-type]
            assert one["factor"] * 20.0 + one["offset"] == pytest.approx(expected, rel=1e-12)


def test_the_form_speaks_portuguese() -> None:
    with speaking("pt"):
        start = page_api.start()
    labels = {one["name"]: one["label"] for g in start["form"]["groups"] for one in g["fields"]}
    assert labels["duty.inner_speed"] == "rotação do anel interno"
    assert start["lang"] == "pt"
    assert page_api.start()["lang"] == "en"


def test_a_designation_opens_as_a_case_whose_values_have_an_origin() -> None:
    found = page_api.opened({"designation": "6310/C3"})
    assert found["case"] == {"bearing": {"designation": "6310/C3"}, "duty": {}}
    assert found["inputs"]["bearing.ball_count"]["origin"] == "inferred"
    assert found["inputs"]["bearing.designation"]["origin"] == "given"
    assert found["elements"] == ["ball"]


def test_a_file_opens_as_it_was_written(spindle: dict[str, object]) -> None:
    text = page_api.saved({"case": spindle})["text"]
    again = page_api.opened({"text": text, "format": "toml"})
    assert Case.from_mapping(again["case"]) == Case.from_mapping(spindle)


@pytest.mark.parametrize(
    ("request_", "field"),
    [
        ({}, "open"),
        ({"designation": "6310", "example": "218_combined"}, "open"),
        ({"designation": "no such bearing"}, "bearing.designation"),
        ({"example": "../../etc/passwd"}, "example"),
        ({"text": "[bearing\n"}, ""),
        ({"case": []}, "case"),
        ({"text": 4}, "text"),
    ],
)
def test_what_cannot_be_opened_is_refused(request_: dict[str, object], field: str) -> None:
    with pytest.raises(InputError) as refused:
        page_api.opened(request_)
    assert refused.value.field == field


@pytest.mark.parametrize("wanted", ["toml", "json"])
def test_a_saved_case_is_read_back(spindle: dict[str, object], wanted: str) -> None:
    found = page_api.saved({"case": spindle, "format": wanted})
    assert found["name"].endswith(f".{wanted}")
    assert parse_case(found["text"]) == Case.from_mapping(spindle)


def test_the_search_finds_by_size_and_by_designation() -> None:
    by_size = page_api.search({"text": "25x52x15"})["bearings"]
    assert "6205" in [one["designation"] for one in by_size]
    nothing = page_api.search({"text": ""})
    assert nothing == {"bearings": [], "more": False, "opens": None, "why": "", "near": ()}
    with pytest.raises(InputError, match="at most 60"):
        page_api.search({"text": "6" * 61})


def test_the_search_finds_what_opens_though_no_catalogue_lists_it() -> None:
    found = page_api.search({"text": "7014 C/HCP4A DBA"})
    assert found["bearings"] == []
    assert found["opens"]["designation"] == "7014 C/HCP4A DBA"
    assert found["opens"]["arrangement"] == "DB"
    assert page_api.opened({"designation": found["opens"]["designation"]})["elements"] == ["ball"]


def test_the_search_says_why_a_designation_does_not_open() -> None:
    found = page_api.search({"text": "HK 2020"})
    assert found["opens"] is None
    assert "inner ring" in found["why"]
    assert found["near"]


def test_every_example_has_its_drawing() -> None:
    drawings = page_api.example_drawings()
    assert set(drawings) == {one["name"] for one in page_api.start()["examples"]}
    assert all(one.startswith("<svg") for one in drawings.values())


def _ask(case: object, **more: object) -> dict[str, object]:
    return live.live({"cases": [{"case": case, "changes": more.pop("changes", {})}], **more})


def test_the_page_shows_what_the_engine_answers(spindle: dict[str, object]) -> None:
    answer = _ask(spindle, changes={"duty.load.fz": "10 kN"}, pictures=["rosette"])
    (one,) = answer["cases"]
    case = Case.from_mapping(spindle).with_(duty__load__fz="10 kN")
    assert Case.from_mapping(one["case"]) == case
    assert one["status"]["converged"] is True
    found = analyse(case).solved
    pressure = max(one.max_pressure[0].max() for one in found.contacts.values())
    shown = {figure["key"]: figure for figure in answer["figures"][0]}
    assert shown["extremes.max_pressure"]["value"].replace("\u2009", "") == f"{pressure / 1e6:.0f}"
    assert "MPa" in shown["extremes.max_pressure"]["limit"]
    assert one["drawing"].startswith("<svg")


def test_a_value_takes_the_place_of_its_rival(spindle: dict[str, object]) -> None:
    (one,) = _ask(spindle, changes={"bearing.diametral_clearance": "0.3 mm"})["cases"]
    assert "contact_angle" not in one["case"]["bearing"]
    assert one["error"] is None


def test_a_wrong_value_is_told_in_its_place_and_the_other_case_goes_on(
    spindle: dict[str, object],
) -> None:
    wrong = {"case": spindle, "changes": {"duty.load.fz": "10"}}
    answer = live.live({"cases": [{"case": spindle}, wrong], "sections": ["ring"]})
    good, bad = answer["cases"]
    assert good["error"] is None
    assert bad["error"]["field"] == "duty.load.fz"
    assert bad["status"] is None
    assert answer["sections"]["ring"]


def test_a_case_without_equilibrium_has_a_status_with_advice_and_no_numbers(
    spindle: dict[str, object],
) -> None:
    answer = _ask(spindle, changes={"duty.load.fx": "0 N"}, sections=list(PARTS))
    (one,) = answer["cases"]
    assert one["status"]["converged"] is False
    assert one["status"]["advice"]
    assert answer["figures"] == [[]]
    everything = " ".join([answer["summary"], answer["leading"], answer["notes"]])
    assert one["status"]["text"] not in everything  # it is said once, by the status


def test_two_cases_stand_side_by_side_with_their_difference(spindle: dict[str, object]) -> None:
    cases = [{"case": spindle}, {"case": spindle, "changes": {"duty.load.fz": "10 kN"}}]
    answer = live.live({"cases": cases, "sections": ["ring", "inputs"]})
    assert "B − A" in answer["sections"]["ring"] or "Δ" in answer["sections"]["ring"]
    assert "duty.load.fz" in answer["sections"]["inputs"] or "Fz" in answer["sections"]["inputs"]


def test_a_quick_answer_says_what_it_left_out() -> None:
    case = page_api.opened({"example": "6305_film"})["case"]
    quick = _ask(case, quick=True)["cases"][0]
    whole = _ask(case)["cases"][0]
    assert quick["status"]["left_out"]
    assert whole["status"]["left_out"] == []
    assert "inputs" not in quick
    full = analysis_of(Case.from_mapping(case))
    part = analysis_of(Case.from_mapping(case), quick=True)
    assert full.friction is not None
    assert part.friction is not None
    assert part.friction.torque == pytest.approx(full.friction.torque, rel=1e-12)


@pytest.mark.parametrize(
    "request_",
    [
        {},
        {"cases": []},
        {"cases": [{}]},
        {"cases": [{"case": {}}] * 5},
        {"cases": [{"case": {"bearing": {}}, "changes": []}], "pictures": 3},
        {"cases": [{"case": {"bearing": {}}}], "sections": [{}]},
    ],
)
def test_what_is_no_request_is_refused(request_: dict[str, object]) -> None:
    with pytest.raises(InputError):
        live.live(request_)


def test_answers_are_json(spindle: dict[str, object]) -> None:
    answer = _ask(spindle, pictures=["rosette", "loads"], sections=list(PARTS))
    json.dumps(answer, allow_nan=False)
