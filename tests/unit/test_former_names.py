"""Names that files and outputs had before: still read for one release, and said to be others."""

from __future__ import annotations

import json
import logging
from collections.abc import Iterator
from typing import Any

import pytest

from rolamento import Case, InputError, Solved, solve
from rolamento.case import override
from rolamento.case.former import OUTPUTS, _say_once
from rolamento.studies import parse_study
from rolamento.studies.outputs import catalogue
from rolamento.studies.scatter import Distribution

CASE = {
    "bearing": {"designation": "6310"},
    "duty": {"inner_speed": "1480 rpm", "load": {"fz": "5 kN"}},
}
STUDY = """
outputs = ["life_holds", "life_below", "wanted_reliability"]
[case.bearing]
designation = "6310"
[case.duty]
inner_speed = "1480 rpm"
load = { fz = "5 kN" }
[case.life]
wanted_life = "20000 h"
[[axes]]
field = "life.wanted_life"
values = ["10000 h", "20000 h"]
"""


@pytest.fixture(autouse=True)
def said(caplog: pytest.LogCaptureFixture) -> Iterator[pytest.LogCaptureFixture]:
    """What the log says, of names that nobody has used before."""
    _say_once.cache_clear()
    caplog.set_level(logging.WARNING, logger="rolamento")
    yield caplog
    _say_once.cache_clear()


def test_a_file_s_field(said: pytest.LogCaptureFixture) -> None:
    old = Case.from_mapping({**CASE, "life": {"wanted_life": "20000 h"}})
    assert old == Case.from_mapping({**CASE, "life": {"required_life": "20000 h"}})
    assert old.to_mapping()["life"]["required_life"] == "20000 h"
    assert "wanted_life" not in old.to_mapping()["life"]
    assert said.messages == [
        "wanted_life is called required_life now; the old name is read until release 0.3"
    ]
    Case.from_mapping({**CASE, "life": {"wanted_life": "1 h"}})
    assert len(said.messages) == 1  # once


def test_a_setting_and_a_change(said: pytest.LogCaptureFixture) -> None:
    case = Case.from_mapping(CASE)
    new = override(case, ["life.required_life=20000 h"])
    assert override(case, ["life.wanted_life=20000 h"]) == new
    assert case.with_({"life.wanted_life": "20000 h"}) == new
    assert said.messages == [
        "life.wanted_life is called life.required_life now; the old name is read until release 0.3"
    ]


def test_both_names_are_refused() -> None:
    with pytest.raises(InputError, match="wanted_life"):
        Case.from_mapping({**CASE, "life": {"wanted_life": "1 h", "required_life": "2 h"}})


def test_a_study_s_outputs_and_axes() -> None:
    study = parse_study(STUDY)
    assert study.outputs == ("life_valid", "life_upper_bound", "required_life_reliability")
    assert study.axes[0].field == "life.required_life"
    assert set(OUTPUTS.values()) <= set(catalogue())
    assert not set(OUTPUTS) & set(catalogue())


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (
            {"distribution": "uniform", "least": "2 kN", "greatest": "3 kN"},
            {"distribution": "uniform", "minimum": "2 kN", "maximum": "3 kN"},
        ),
        (
            {"distribution": "weibull", "shape": 2, "scale": "1 kN", "minimum": "1 kN",
             "greatest": "9 kN"},
            {"distribution": "weibull", "shape": 2, "scale": "1 kN", "threshold": "1 kN",
             "maximum": "9 kN"},
        ),
        (
            {"distribution": "lognormal", "median": "2 kN", "factor": 2, "minimum": "1 kN",
             "least": "1.5 kN"},
            {"distribution": "lognormal", "median": "2 kN", "factor": 2, "threshold": "1 kN",
             "minimum": "1.5 kN"},
        ),
    ],
)  # fmt: skip
def test_a_scatter_s_ends(old: dict[str, Any], new: dict[str, Any]) -> None:
    assert Distribution.from_mapping(old) == Distribution.from_mapping(new)


def test_what_minimum_is_has_to_be_plain() -> None:
    """It was where a distribution begins, and is where it is cut off: numbers would change."""
    law: dict[str, Any] = {"distribution": "weibull", "shape": 2, "scale": "1 kN"}
    with pytest.raises(InputError, match="is threshold: give both"):
        Distribution.from_mapping({**law, "minimum": "1 kN"})
    plain = Distribution.from_mapping({**law, "threshold": "0 N", "minimum": "1 kN"})
    assert (plain.threshold, plain.minimum) == ("0 N", "1 kN")


def test_a_state_that_was_written_before(said: pytest.LogCaptureFixture) -> None:
    state = solve(Case.from_mapping(CASE)).to_mapping()
    assert state["schema"] == 3
    state["status"] |= {"code": "unheld_ball", "converged": False}
    read = Solved.from_json(json.dumps({**state, "schema": 2}))
    assert str(read.status.code[0]) == "unconstrained_ball"
    assert "unheld_ball is called unconstrained_ball now" in said.text
