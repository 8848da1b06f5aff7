"""What ends a bearing first: order, spreads, what has no time, the report, hostile inputs."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import Case, analyse, load_case, report
from rolamento.cli.app import app
from rolamento.grease import l10_of_mean
from rolamento.life.oscillation import oscillation_life
from rolamento.life.reliability import reliability_factor
from rolamento.pages.service_life import service_life_page
from rolamento.plots.service_life import service_life_figure, time_line
from rolamento.tasks.endings import ENDINGS, Ending
from rolamento.tasks.grease import grease_of_case
from rolamento.tasks.time_line import ServiceLife, service_life
from rolamento.words import speaking
from rolamento.words.sentences.service_life import BASES, ENDING_NAMES

GREASE = {
    "kind": "grease", "viscosity_40": "110 mm^2/s", "viscosity_100": "12 mm^2/s",
    "density": "900 kg/m^3",
}  # fmt: skip


def motor(**changes: Any) -> Case:
    values = {
        "duty.load.fz": "3 kN",
        "duty.inner_speed": "1480 rpm",
        "temperature.lubricant": "80 degC",
        "life.grease_cleanliness": "normal",
    }
    case = load_case("6310-2RS1/C3", values).with_({"lubricant": GREASE})
    return case.with_(changes) if changes else case


def ends(*endings: Ending, required: float | None = None) -> ServiceLife:
    return replace(service_life(motor()), endings=endings, required=required)


# --- which comes first ----------------------------------------------------------------------------


def test_the_grease_of_a_motor_ends_it() -> None:
    found = service_life(motor())
    assert [one.name for one in found.endings] == ["fatigue", "grease", "overload"]
    assert found.first is found["grease"]
    grease = grease_of_case(motor())
    assert found["grease"].hours == pytest.approx(l10_of_mean(grease.hours))
    assert found["grease"].high == pytest.approx(grease.spread[1])


def test_the_fatigue_is_that_of_the_headline() -> None:
    analysis = analyse(motor(**{"life.reliability": 0.95}), quick=True)
    assert analysis.life is not None
    hours = analysis.life.headline.hours[0]
    fatigue = service_life(motor(**{"life.reliability": 0.95}))["fatigue"]
    assert fatigue.hours == pytest.approx(hours / float(reliability_factor(0.95)))
    assert fatigue.low == pytest.approx(fatigue.hours * float(reliability_factor(0.99)))
    assert fatigue.low < fatigue.hours < fatigue.high


def test_an_open_bearing_wants_relubrication() -> None:
    found = service_life(motor(**{"bearing.designation": "6310/C3"}))
    assert [one.name for one in found.endings] == ["fatigue", "relubrication", "overload"]
    assert found["relubrication"].kind == "upkeep"
    assert found.first is found["fatigue"]


def test_oil_has_no_grease_to_end() -> None:
    found = service_life(motor(lubricant="ISO VG 100"))
    assert [one.name for one in found.endings] == ["fatigue", "overload"]
    assert not found.beside_fatigue


def test_a_swing_ends_by_oscillation_or_by_fretting() -> None:
    case = motor(**{"duty.oscillation.angle": "150 deg", "duty.oscillation.frequency": "1 Hz"})
    found = service_life(case)
    assert "fatigue" not in [one.name for one in found.endings]
    life = oscillation_life(found.solved)
    assert found["oscillation"].hours == pytest.approx(life.hours)
    small = service_life(case.with_({"duty.oscillation.angle": "5 deg"}))
    assert small.first is small["fretting"]
    assert small.first.acting
    assert np.isnan(small.first.hours)


OILED = {
    "duty.load.fz": "5 kN",
    "duty.inner_speed": "1480 rpm",
    "lubricant": "ISO VG 68",
    "temperature.lubricant": "70 degC",
}


@pytest.mark.parametrize(("load", "hours"), [("5 kN", np.inf), ("90 kN", 0.0)])
def test_an_overload_ends_it_at_once(load: str, hours: float) -> None:
    found = service_life(load_case("6310", {**OILED, "duty.load.fz": load}))
    assert found["overload"].hours == hours
    assert (found.first is not None and found.first.name == "overload") == (hours == 0.0)


def test_a_current_is_at_work_from_the_band_of_fluting_on() -> None:
    acting, never = [], []
    for current in ("1 mA", "300 mA", "3 A"):
        case = {**OILED, "duty.load.fz": "1 kN", "electrical.current": current}
        ending = service_life(load_case("6205", case))["currents"]
        acting.append(ending.acting)
        never.append(np.isinf(ending.hours))
    assert acting == [False, False, True]
    assert never == [True, False, False]
    with pytest.raises(KeyError):
        service_life(load_case("6205", OILED))["currents"]


def test_wear_is_at_work_below_a_tenth_of_the_viscosity() -> None:
    slow = {**OILED, "duty.inner_speed": "2 rpm", "temperature.lubricant": "90 degC"}
    found = service_life(load_case("6310", slow))
    assert found["wear"].acting
    assert "wear" not in [one.name for one in service_life(load_case("6310", OILED)).endings]


def test_order_of_what_is_at_once_at_work_and_timed() -> None:
    timed, later = Ending("fatigue", 100.0, 10.0, 500.0), Ending("grease", 1000.0, 200.0, 5000.0)
    acting, at_once = Ending("fretting", np.nan, acting=True), Ending("oscillation", 0.0)
    upkeep = Ending("relubrication", 1.0, kind="upkeep")
    assert ends(later, timed, upkeep).first is timed
    assert ends(later, acting, timed).first is acting
    assert ends(acting, at_once, timed).first is at_once
    assert ends(upkeep).first is None


def test_rivals_are_those_whose_spread_reaches_in() -> None:
    first = Ending("grease", 100.0, 10.0, 500.0)
    near, far = Ending("fatigue", 1000.0, 400.0, 9e3), Ending("oscillation", 1e4, 600.0, 9e4)
    assert ends(first, near, far).rivals == (near,)


@pytest.mark.parametrize(("endings", "reaches"), [
    ([Ending("grease", 2000.0)], True),
    ([Ending("grease", 500.0)], False),
    ([Ending("grease", 2000.0, bound=True)], None),
    ([Ending("grease", 2000.0), Ending("fatigue", np.nan)], None),
    ([Ending("fretting", np.nan, acting=True)], None),
    ([Ending("grease", 500.0), Ending("fatigue", np.nan)], False),
    ([Ending("fatigue", np.inf)], True),
])  # fmt: skip
def test_whether_it_reaches_what_is_required(endings: list[Ending], reaches: bool | None) -> None:
    assert ends(*endings, required=1000.0).reaches_required is reaches


def test_no_result_has_no_end() -> None:
    found = service_life(load_case("7210 B", {"duty.load.fz": "5 kN", "duty.inner_speed": "9 rpm"}))
    assert not found.converged
    assert found.first is None
    assert found.endings == ()
    service_life_page(found)
    service_life_figure(found)


# --- registry, page, picture ----------------------------------------------------------------------


def test_every_ending_has_a_name_and_every_basis_words() -> None:
    assert ENDINGS.keys() <= ENDING_NAMES.keys()
    for case in (motor(), motor(**{"bearing.designation": "6310/C3"})):
        for one in service_life(case).endings:
            assert not one.basis or one.basis in BASES


@pytest.mark.parametrize("language", ["en", "pt"])
def test_the_page_says_what_comes_first(language: str) -> None:
    from rolamento.document.markdown import markdown

    with speaking(language):
        text = markdown(service_life_page(service_life(motor())))
    expected = {
        "en": "First comes grease",
        "pt": "Primeiro fator limitante: graxa; 90\u00a0% destes rolamentos",
    }[language]
    assert expected in text


def test_the_time_line_has_a_bar_for_each() -> None:
    found = ends(
        Ending("fatigue", 1e5, 1e4, 1e6), Ending("grease", 3e3, 1e3, 1e4),
        Ending("fretting", np.nan, acting=True), Ending("oscillation", np.inf),
    )  # fmt: skip
    axes = time_line(found)
    assert len(axes.patches) == 2
    assert [label.get_text() for label in axes.get_yticklabels()][:2] == ["fatigue", "grease"]
    texts = [text.get_text() for text in axes.texts]
    assert texts == ["at work, no time known", "never"]


def test_a_report_has_it_where_it_is_not_fatigue_alone() -> None:
    with_grease = report(motor()).cases[0].numbers
    assert with_grease["service_life"]["first"] == "grease"
    assert "service_life" not in report(motor(lubricant="ISO VG 100")).cases[0].numbers


def test_the_command() -> None:
    run = CliRunner().invoke
    words = ["service-life", "6205-2RS1", "--fr", "500 N", "--speed", "3000 rpm"]
    page = run(app, [*words, "--temperature", "80 degC"])
    assert page.exit_code == 0
    assert "First comes grease" in page.output
    found = json.loads(run(app, [*words, "--json", "-"]).output)
    assert found["service_life"]["first"] == "grease"
    assert run(app, ["service-life", "6205-2RS1"]).exit_code == 2


def test_the_page_of_the_case_shows_it() -> None:
    from rolamento.web.live import live

    tables = {
        "bearing": {"designation": "6309-2RS1/C3"},
        "duty": {"inner_speed": "1460 rpm", "load": {"fz": "2.5 kN"}},
        "temperature": {"lubricant": "85 degC"},
    }
    two = [{"case": tables}, {"case": tables, "changes": {"temperature.lubricant": "70 degC"}}]
    shown = live({"cases": two, "sections": ["service_life"]})["sections"]["service_life"]
    assert shown.count("First comes grease") == 2
    oiled = {**tables, "bearing": {"designation": "6309/C3"}, "lubricant": "ISO VG 100"}
    shown = live({"cases": [{"case": oiled}], "sections": ["service_life"]})
    assert "grease" not in shown["sections"]["service_life"]


def test_a_report_has_the_inputs_of_the_grease() -> None:
    from rolamento.document.markdown import markdown
    from rolamento.pages.report import report_page

    text = markdown(report_page(report(motor(grease={"thickener": "urea"}))))
    assert "What ends it first" in text
    assert "urea" in text
