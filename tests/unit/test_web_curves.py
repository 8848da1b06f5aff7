"""The app's curve: what the engine answers at every point, the case itself among them."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import rolamento
from rolamento.case import Case
from rolamento.errors import InputError
from rolamento.tasks.curve import curve_over, outputs_over, usual_range
from rolamento.tasks.report import analysis_of
from rolamento.web.curves import curve
from rolamento.words import speaking

FILE = Path(rolamento.__file__).parent / "examples" / "218_combined.toml"
TABLES: dict[str, Any] = tomllib.loads(FILE.read_text())
CASE = Case.from_mapping(TABLES)


def test_every_point_is_what_solving_it_alone_gives() -> None:
    found = curve_over(CASE, "duty.load.fz", "max_inner_load", "5 kN", "20 kN", points=4)
    assert found.values.tolist() == [5e3, 10e3, 15e3, 20e3]
    for load, number in zip(found.values, found.numbers, strict=True):
        alone = rolamento.solve(CASE, fz=float(load))
        assert number == pytest.approx(float(alone.inner.load[0].max()), rel=1e-9)
    assert found.present == 2


def test_the_present_value_is_a_point_of_its_own() -> None:
    found = curve_over(CASE, "duty.inner_speed", "life_hours", points=5)
    assert found.present is not None
    assert found.values[found.present] == CASE.duty.inner_speed
    life = analysis_of(CASE).life
    assert life is not None
    assert found.numbers[found.present] == pytest.approx(float(life.headline.hours[0]), rel=1e-9)
    assert np.all(np.diff(found.values) > 0.0)


def test_cases_without_a_result_are_gaps_with_a_reason() -> None:
    picture = curve({
        "case": TABLES, "field": "duty.load.fx", "output": "stiffness_xx", "low": "-20 kN",
        "high": "20 kN",
    })  # fmt: skip
    line, missing, present = picture["data"]
    gaps = [x for x, y in zip(line["x"], line["y"], strict=True) if y is None]
    assert gaps == missing["x"] != []
    assert len(missing["text"]) == len(gaps)
    assert all(missing["text"])
    assert present["x"] == [20.0]
    json.dumps(picture, allow_nan=False)


def test_two_cases_share_range_and_axes() -> None:
    changes = {"duty.load.fx": "10 kN"}
    picture = curve({
        "cases": [{"case": TABLES}, {"case": TABLES, "changes": changes}],
        "field": "duty.load.fz", "output": "max_inner_max_pressure", "scale": "log",
        "upright": "log",
    })  # fmt: skip
    names = [one["name"] for one in picture["data"]]
    assert names == ["case A", "now, case A", "case B", "now, case B"]
    first, _, other, _ = picture["data"]
    assert (first["x"][0], first["x"][-1]) == (other["x"][0], other["x"][-1])
    assert picture["layout"]["xaxis"]["type"] == picture["layout"]["yaxis"]["type"] == "log"
    with speaking("pt_BR"):
        assert curve({"case": TABLES})["layout"]["separators"][0] == ","


def test_nothing_asked_for_gives_what_there_is_to_choose_from() -> None:
    picture = curve({"case": TABLES})
    assert picture["field"] in [one["name"] for one in picture["fields"]]
    assert picture["output"] in [one["name"] for one in picture["outputs"]]
    assert all(one["label"] for one in (*picture["fields"], *picture["outputs"]))
    assert not any(own.name.startswith("film") for own in outputs_over(CASE))


@pytest.mark.parametrize(
    ("request_", "field"),
    [
        ({"field": "duty.load.fq"}, "field"),
        ({"field": "bearing.ball_count"}, "field"),
        ({"output": "no_such"}, "outputs"),
        ({"output": "film_parameter"}, "outputs"),
        ({"output": "inner_load"}, "output"),
        ({"low": "3 mm"}, "low"),
        ({"low": "20 kN", "high": "10 kN"}, "high"),
        ({"field": "duty.load.fx", "low": "-1 kN", "scale": "log"}, "low"),
        ({"scale": "cubic"}, "scale"),
        ({"field": ["duty.load.fz"]}, "field"),
        ({"case": None}, "cases"),
        ({"cases": [{"case": TABLES}] * 3}, "cases"),
    ],
)
def test_wrong_requests_are_refused_by_name(request_: dict[str, Any], field: str) -> None:
    with pytest.raises(InputError) as refused:
        curve({"case": TABLES, **request_})
    assert refused.value.field == field


def test_usual_ranges_keep_to_the_bounds() -> None:
    fields = Case.fields()
    assert usual_range(CASE, fields["duty.load.fz"]) == (3750.0, 30e3)
    low, high = usual_range(CASE, fields["bearing.inner_conformity"])
    assert 0.5 < low < high < 1.0
    low, high = usual_range(CASE, fields["duty.displacement.ry"])
    assert low < high
    low, high = usual_range(CASE, fields["duty.inner_speed"], "log")
    assert high == pytest.approx(100.0 * low)
