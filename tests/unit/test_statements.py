"""What pages say of cases that are no case for their bearing, or none yet."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path
from typing import Any

import pytest
from tests.one_case import keys, said
from typer.testing import CliRunner

from rolamento import Case, Solved, solve
from rolamento.cli.app import app
from rolamento.document import Document
from rolamento.document.terminal import terminal
from rolamento.pages.report import report_page
from rolamento.pages.state import state_page
from rolamento.solved.notes import nothing_given
from rolamento.tasks.report import calculation_report
from rolamento.web.form import in_labels
from rolamento.web.live import live
from rolamento.words import speaking


def on_the_page(case: dict[str, Any]) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(in_labels(live, {"cases": [case]}))
    return found


def solved(designation: str, **duty: Any) -> Solved:
    return solve(Case(bearing={"designation": designation}, duty=duty))


def printed(*words: str) -> str:
    return CliRunner().invoke(app, list(words), env={"COLUMNS": "300"}).output


def flat(page: Document) -> str:
    """What a page says, without the ends of its lines."""
    return " ".join(terminal(page).split())


# --- no load --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("duty", "speed"),
    [({}, False), ({"load": {"fx": 0.0}}, False), ({"inner_speed": 100.0}, True)],
)
def test_without_a_load_a_page_says_what_to_give(duty: dict[str, Any], speed: bool) -> None:
    found = solved("6310", **duty)
    assert nothing_given(found)
    (note,) = (n for n in found.notes[0] if n.key == "no_load_given")
    assert note.values["speed"] is speed
    assert "no_ball_loaded" not in keys(found.notes[0])
    page = terminal(state_page(found))
    assert "converged" not in page
    assert "no load is given yet: nothing to calculate" in page
    assert "duty.load.fz" in page


@pytest.mark.parametrize(
    ("designation", "duty"),
    [("6310", {"load": {"fz": 1.0}}), ("6310", {"displacement": {"z": 5e-5}}),
     ("6310", {"load": {"fx": 0.0, "my": 1.0, "mz": 0.0}})],
)  # fmt: skip
def test_any_load_or_displacement_is_one(designation: str, duty: dict[str, Any]) -> None:
    assert not nothing_given(solved(designation, **duty))


def test_a_preload_is_a_load() -> None:
    pair = {"designation": "7210 B", "arrangement": "DB", "spacing": "20 mm", "preload": "500 N"}
    assert not nothing_given(solve(Case(bearing=pair, duty={})))


def test_a_report_without_a_load_has_no_numbers_of_it(tmp_path: Path) -> None:
    empty = tmp_path / "empty.toml"
    empty.write_text('[bearing]\ndesignation = "6310"\n[duty]\n', encoding="utf-8")
    page = report_page(calculation_report([empty]))
    (summary,) = (s for s in page.sections if getattr(s, "key", "") == "summary")
    text = terminal(page)
    assert "converged in" not in text
    assert [type(block).__name__ for block in summary.blocks] == ["Statement", "Notes"]
    assert "No theory of life" not in text


def test_the_app_says_so_with_the_names_of_its_fields() -> None:
    empty = {"case": {"bearing": {"designation": "6310"}, "duty": {}}}
    status = on_the_page(empty)["cases"][0]["status"]
    assert status["text"] == "no load is given yet: nothing to calculate"
    assert "“axial load Fx”" in status["advice"]
    assert "duty." not in status["advice"]
    with speaking("pt"):
        assert "“carga axial Fx”" in on_the_page(empty)["cases"][0]["status"]["advice"]
    loaded = {"case": {"bearing": {"designation": "6310"}, "duty": {"load": {"fz": "1 kN"}}}}
    assert live({"cases": [loaded]})["cases"][0]["status"]["advice"] is None


def test_the_app_gives_advice_once() -> None:
    """With the status; the summary says why there is no result, and no more."""
    pulled = {"case": {"bearing": {"designation": "7210 B"}, "duty": {"load": {"fx": "-5 kN"}}}}
    found = on_the_page(pulled)
    advice = found["cases"][0]["status"]["advice"]
    assert "“axial load Fx”" in advice
    assert found["cases"][0]["status"]["text"] == "there is no equilibrium"
    assert advice[:40] not in found["summary"]


# --- the wrong bearing ----------------------------------------------------------------------------


def test_a_thrust_bearing_carries_no_radial_load() -> None:
    out = printed("solve", "51210", "--fr", "3kN", "--fa", "1kN", "--speed", "100rpm")
    assert "A thrust ball bearing carries no radial load: the 3000 N" in out
    assert "90.0°" not in out.partition("advice")[2]
    at_rest = solved("51210", load={"fx": 1e3, "fz": 3e3})
    assert at_rest.converged[0]  # ideal grooves would hold it
    assert "thrust_under_radial_load" in keys(at_rest.notes[0])
    other = solved("51210", load={"fx": 1e3}, displacement={"y": 0.0, "z": 0.0})
    assert "thrust_under_radial_load" not in keys(other.notes[0])


def test_a_four_point_bearing_under_a_radial_load_is_told() -> None:
    found = solved("QJ 210", inner_speed=150.0, load={"fx": 300.0, "fz": 3e3})
    (note,) = (n for n in found.notes[0] if n.key == "four_point_under_radial_load")
    assert note.values["ratio"] == pytest.approx(0.1)
    assert note.values["both_arcs"] > 0
    assert "both arcs" in said(note)
    axial = solved("QJ 210", inner_speed=150.0, load={"fx": 3e3, "fz": 300.0})
    assert "four_point_under_radial_load" not in keys(axial.notes[0])


@pytest.mark.parametrize(
    ("axial", "tilts", "key"),
    [(1.1, True, "tapered_free_to_tilt"), (0.9, True, "tapered_unsupported_axially"),
     (0.9, False, "tapered_unsupported_axially"), (-1.1, True, "tapered_unsupported_axially")],
)  # fmt: skip
def test_why_a_tapered_row_finds_no_place(axial: float, tilts: bool, key: str) -> None:
    """F_a over F_r tan α_o of a 30206: beyond 1 the ring holds, if it cannot tilt."""
    load = {"fx": axial * 4e3 * 0.246673, "fz": 4e3}
    free = {"my": 0.0, "mz": 0.0} if tilts else {}
    found = solved("30206", load=load | free)
    assert found.status.code[0] == "no_equilibrium"
    assert found.advice[0] is not None
    assert found.advice[0].key == key
    held = solved("30206", load=load)
    assert held.converged[0] == (axial > 1.0)


# --- life, stiffness ------------------------------------------------------------------------------


def test_a_report_says_that_oil_and_dirt_are_left_out() -> None:
    oil = ["lubricant.base_oil=ISO VG 68", "temperature.lubricant=70 degC"]
    load = ["duty.inner_speed=1480 rpm", "duty.load.fz=5 kN"]
    text = flat(report_page(calculation_report(["6310/C3"], changes=[*load, *oil])))
    summary = text.partition("Summary")[2].partition("Inputs")[0]
    left_out = "Lubrication and contamination are not included"
    assert f"{left_out}: the case needs the cleanliness" in summary
    clean = ["life.cleanliness=-/17/14", "life.oil_supply=circulating"]
    assert left_out not in flat(
        report_page(calculation_report(["6310/C3"], changes=[*load, *oil, *clean]))
    )


def test_rounding_is_no_stiffness(tmp_path: Path) -> None:
    file = tmp_path / "k.csv"
    printed("solve", "7014 C DB", "--fa", "400N", "--fr", "800N", "--speed", "15000rpm",
            "--set", "bearing.preload=240N", "--set", "bearing.spacing=20mm",
            "--csv", str(file), "--table", "stiffness")  # fmt: skip
    rows = list(csv.DictReader(io.StringIO(file.read_text(encoding="utf-8"))))
    values = {(row["load"], axis): float(row[axis]) for row in rows for axis in ("x", "y", "rz")}
    assert values["fx", "y"] == values["fy", "x"] == values["fx", "rz"] == 0.0
    assert values["fx", "x"] > 10.0
    assert values["fy", "rz"] < -100.0
