"""Sets of rows in the report, in the notes and in the advice."""

from __future__ import annotations

import csv
import dataclasses
import re
from functools import cache
from math import acos, degrees, nan
from pathlib import Path

import numpy as np
import pytest
from tests.one_case import keys, said

import rolamento
from rolamento import Case
from rolamento.case.bearing import Bearing
from rolamento.document.medium import Medium
from rolamento.document.tables import to_csv
from rolamento.document.terminal import terminal
from rolamento.pages.state import state_page
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.words import Note, speaking

EXAMPLES = Path(rolamento.__file__).parent / "examples"
BOTH = pytest.mark.parametrize("language", ["en", "pt"])
AXIAL = "duty.load.fz=0 N"
"""Without it, every row of the pair keeps some contact."""


@cache
def solved(name: str, *settings: str) -> Solved:
    return solve(case_of(name, *settings))


def case_of(name: str, *settings: str) -> Case:
    return rolamento.load_case(EXAMPLES / f"{name}.toml", settings)


def plain(state: Solved, language: str = "en", **medium: object) -> str:
    with speaking(language):
        return terminal(state_page(state), Medium(**medium))  # type: ignore[arg-type]


def flat(text: str) -> str:
    """The text without line breaks and margins."""
    return " ".join(text.split())


def row_lines(report: str, language: str = "en") -> list[list[str]]:
    """The cells of the lines of the part "Rows"."""
    heading = {"en": "Rows", "pt": "Carreiras"}[language]
    part = report.split(f"\n\n{heading}\n")[1].split("\n\n")[0]
    cells = (line.replace("−", "-").split() for line in part.splitlines())
    return [line for line in cells if line and re.fullmatch(r"\d+", line[0]) and len(line) == 11]


# --- head -------------------------------------------------------------------


def test_the_head_says_arrangement_and_preload() -> None:
    report = plain(solved("6012_pair"))
    assert "DB, back to back (+ −), 18 mm between rows" in report
    assert "preload class medium of S 6012 C (515 N in a pair), clamped" in report


def test_the_head_lists_rows_with_what_they_have_of_their_own() -> None:
    report = flat(plain(solved("6012_triple"), "pt"))
    listed = "3 carreiras: + em −36 mm, + em −18 mm (fase 8,18°), − em 18 mm (α 15°)"
    assert listed in report
    assert "pré-carga de 600 N, anéis travados axialmente" in report


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("DF", "DF, face to face (− +)"),
        ("DT", "DT, in tandem (+ +)"),
        ("QBC", "QBC, back to back (+ + − −)"),
        ("TFT", "TFT, face to face (− + +)"),
    ],
)
def test_every_arrangement_is_drawn_by_its_signs(name: str, said: str) -> None:
    case = case_of("6012_pair")
    bearing = case.bearing.replace(arrangement=name, preload=None)
    assert said in plain(solve(case.replace(bearing=bearing)))


@pytest.mark.parametrize(
    ("preload", "said"),
    [
        ("400 N", "preload 400 N, clamped"),
        ("3 um", "clamped, each row pressed in by 3 µm"),
        ({"spring": "300 N"}, "preload by springs of 300 N"),
    ],
)
@pytest.mark.thirds
def test_every_preload_is_told_as_it_was_given(preload: object, said: str) -> None:
    case = case_of("6012_pair")
    state = solve(case.replace(bearing=case.bearing.replace(preload=preload)))
    assert said in plain(state)


def test_rows_with_clearance_face_both_ways() -> None:
    case = case_of("209_radial")
    rows = [{"position": "-10 mm"}, {"position": "10 mm", "ball_count": 8}]
    report = plain(solve(case.replace(bearing=case.bearing.replace(rows=rows))))
    assert "2 rows: ± at −10 mm, ± at 10 mm (8 balls)" in report
    assert "± both ways" in report
    assert "Preload" not in report


# --- rows -------------------------------------------------------------------


@BOTH
@pytest.mark.parametrize("width", [80, 120])
@pytest.mark.parametrize("name", ["6012_pair", "6012_triple"])
def test_every_row_has_its_line(name: str, width: int, language: str) -> None:
    state = solved(name)
    lines = row_lines(plain(state, language, width=width), language)
    assert len(lines) == len(state.rows)
    signs = {1.0: "+", -1.0: "−"}
    rows = state.rows
    for row, line in enumerate(lines):
        own = state.elements.row == row
        numbers = [float(cell.replace(",", ".")) for cell in (line[2], *line[6:], *line[4:6])]
        load = rows.load[0, row]
        assert line[0] == str(row)
        assert line[1].replace("-", "−") == signs[rows.sign[row]]
        assert line[3] == f"{state.loaded_elements[0, row]}/{rows.element_count[row]}"
        assert numbers[0] == pytest.approx(1e3 * rows.position[0, row], abs=0.006)
        assert numbers[1:4] == pytest.approx(load[:3], abs=0.6)
        assert numbers[4:6] == pytest.approx(load[3:], abs=0.06)
        assert numbers[6] == pytest.approx(state.inner.load[0, own].max(), abs=0.06)
        assert numbers[7] == pytest.approx(1e-6 * state.inner.max_pressure[0, own].max(), abs=0.6)


@BOTH
def test_loads_too_wide_for_a_line_take_two_tables(language: str) -> None:
    state = solved("6012_pair")
    load = np.broadcast_to([-1.2e8, -1e8, -1e8, -1e6, 0.0], state.rows.load.shape)
    rows = dataclasses.replace(state.rows, load=load)
    report = plain(dataclasses.replace(state, rows=rows), language)
    assert max(map(len, report.splitlines())) == 80
    assert "−120 000 000" in report


def test_balls_run_on_from_row_to_row_as_in_json_and_csv() -> None:
    state = solved("6012_triple")
    report = plain(state, width=120)
    headings = [report.index(f"\n  row {row}\n") for row in range(3)]
    assert headings == sorted(headings)
    for number in (0, 21, 22, 43, 44, 65):
        row, azimuth = state.elements.row[number], state.elements.azimuth[0, number]
        line = re.search(rf"(?m)^ +{number} +[\d.]+ .*$", report)
        assert line
        cells = line.group().replace("◂", "").split()
        assert float(cells[1]) == pytest.approx(degrees(azimuth), abs=0.006)
        assert float(cells[2]) == pytest.approx(state.inner.load[0, number], abs=0.06)
        assert headings[row] < line.start()
        assert all(line.start() < later for later in headings[row + 1 :])
    rows = list(csv.DictReader(to_csv(state_page(state)).splitlines()))
    assert [int(row["row"]) for row in rows] == state.elements.row.tolist()
    assert [int(row["ball"]) for row in rows] == list(range(66))


def test_the_heaviest_ball_names_its_row() -> None:
    state = solved("6012_triple")
    number = int(np.argmax(np.maximum(state.inner.load[0], state.outer.load[0])))
    assert f"#{number} of row {state.elements.row[number]} at" in plain(state)


@pytest.mark.parametrize(
    ("arrangement", "width", "abreast"), [("DB", 80, 2), ("DB", 120, 2), ("QBC", 80, 2),
                                          ("QBC", 120, 4), ("TBT", 80, 3)]
)  # fmt: skip
@pytest.mark.thirds
def test_a_rosette_a_row_and_as_many_abreast_as_there_is_room(
    arrangement: str, width: int, abreast: int
) -> None:
    report = plain(solved("6012_pair", f"bearing.arrangement={arrangement}"), width=width)
    captions = [line for line in report.splitlines() if "+z" in line]
    assert [line.count("+z") for line in captions] == [abreast] * len(captions)
    assert sum(line.count("+z") for line in captions) == len(
        rolamento.case.arrangement.ARRANGEMENTS[arrangement]
    )  # type: ignore[index]
    assert max(map(len, report.splitlines())) == width


def test_all_rosettes_have_the_scale_of_the_greatest_load() -> None:
    state = solved("6012_pair", AXIAL)
    greatest = float(state.inner.load.max())
    report = plain(state)
    assert report.count("rim: Q_i") == 1
    assert f"rim: Q_i = {greatest:.2f} N" in report


# --- preload ----------------------------------------------------------------


def test_the_preload_is_shown_at_rest_and_at_speed_with_the_load_that_takes_it_away() -> None:
    state = solved("6012_pair", AXIAL)
    assert state.preload
    report = flat(plain(state))
    assert "at rest 515 N" in report
    assert f"at speed {state.preload.at_speed:.4g} N" in report
    factor = state.preload.loss_factor
    load = factor * 1000.0
    assert f"row 1 lifts off at {factor:.3g} × the load: fx {load:.0f} N" in report


def test_at_rest_there_is_no_preload_at_speed() -> None:
    report = plain(solved("6012_pair", "duty.inner_speed=0 rpm"))
    assert "at speed" not in report


def test_without_a_load_nothing_is_said_about_its_loss() -> None:
    report = plain(solved("6012_pair", AXIAL, "duty.load.fx=0 N"))
    part = report.split("\n\nPreload\n")[1].split("\n\n")[0]
    assert len(part.splitlines()) == 2


@BOTH
def test_where_no_row_lifts_off_that_is_said(language: str) -> None:
    said = {"en": "no row loses all contact", "pt": "nenhuma carreira perde todo o contato"}
    assert said[language] in flat(plain(solved("6012_pair"), language))


@BOTH
def test_a_row_that_has_lifted_off(language: str) -> None:
    state = solved("6012_pair", AXIAL, "duty.load.fx=20 kN")
    assert state.preload
    assert state.preload.loss_factor < 1.0
    report = flat(plain(state, language))
    assert {"en": "row 1 has lifted off, at", "pt": "carreira 1 já se soltou"}[language] in report
    load = 20e3 * state.preload.loss_factor
    assert f"fx {load:.0f} N" in report
    assert "row 1: all" not in report
    lost = said(state.notes[0][0], language)
    assert lost in report


def test_a_lost_row_without_a_known_point_is_told() -> None:
    state = solved("6012_pair", AXIAL, "duty.load.fx=20 kN")
    assert state.preload
    unknown = dataclasses.replace(state.preload, loss_factor=nan, lost_row=None)
    report = plain(dataclasses.replace(state, preloading=unknown))
    assert "no ball of row 1 presses on the inner ring" in report


# --- notes ------------------------------------------------------------------


def test_a_lost_row_is_noted_and_its_balls_are_not_listed() -> None:
    state = solved("6012_pair", AXIAL, "duty.load.fx=20 kN")
    lost = [note for note in state.notes[0] if note.key == "row_unloaded"]
    assert [dict(note.values) for note in lost] == [{"rows": [1], "preloaded": True}]
    assert lost[0].text.startswith("No ball of row 1 contacts the inner ring: the row has lost its")
    assert "balls_unloaded" not in keys(state.notes[0])


def test_an_unloaded_row_of_a_set_without_preload_is_noted() -> None:
    case = case_of("6012_pair", AXIAL, "duty.load.fx=20 kN")
    state = solve(case.replace(bearing=case.bearing.replace(preload=None)))
    assert "no preload holds the row in contact" in state.notes[0][0].text


def test_a_preload_that_is_nearly_lost_is_noted() -> None:
    state = solved("6012_pair", AXIAL, "duty.load.fx=6.2 kN")
    assert state.preload
    assert 1.0 < state.preload.loss_factor < 1.1
    (note,) = state.notes[0]
    assert note.values == {"row": 1, "factor": state.preload.loss_factor}
    assert note.text.startswith("Row 1 is about to lose its preload")
    assert f"{state.preload.loss_factor:.3g} times this load" in note.text
    assert said(note, "pt").startswith("A carreira 1 está prestes a perder")
    safe = dataclasses.replace(state.preload, loss_factor=1.2)
    assert dataclasses.replace(state, preloading=safe).notes == ((),)


def test_azimuths_are_told_row_by_row() -> None:
    state = solved("6012_triple", "duty.load.fz=20 kN", "duty.load.fx=-30 kN")
    (note,) = [note for note in state.notes[0] if note.key == "balls_unloaded"]
    assert "(azimuth row 0: 81.82°, 98.18°, 114.5°, 130.9°, " in note.text
    assert " …; row 1: 73.63°" in note.text
    assert "(azimute carreira 0: 81,82°, 98,18°, 114,5°, 130,9°, " in said(note, "pt")
    free = ~state.loaded[0]
    assert note.values["balls"] == np.flatnonzero(free).tolist()
    assert note.values["azimuths"] == state.elements.azimuth[0, free].tolist()
    assert note.values["rows"] == state.elements.row[free].tolist()


def test_a_whole_row_is_told_as_all() -> None:
    state = solved("6012_pair", AXIAL, "duty.load.fx=105 kN")
    (note,) = [note for note in state.notes[0] if note.values.get("race") == "inner"]
    assert "22 balls (azimuth row 0: all)" in note.text
    assert "carreira 0: todas" in said(note, "pt")


def test_shoulders_are_those_of_the_row() -> None:
    """The first row's balls, of the other bearing, have a groove that ends sooner."""
    case = case_of("6012_pair", "duty.inner_speed=0 rpm", AXIAL)
    rows = [
        {"orientation": "+", "position": "-9 mm", "outer_conformity": 0.6},
        {"orientation": "-", "position": "9 mm"},
    ]
    bearing = case.bearing.replace(
        arrangement=None, spacing=None, rows=rows, preload="515 N", outer_shoulder_height="0.3 mm"
    )
    state = solve(case.replace(bearing=bearing))
    outer = state.outer
    reaches = [
        abs(outer.contact_angle[0, ball]) + outer.semi_major[0, ball] / (f * 9.525e-3)
        for ball, f in ((0, 0.6), (22, 0.52))
    ]
    ends = [groove_end(state.case.bearing, row, 0.3e-3) for row in (0, 1)]
    expected = [row for row in (0, 1) if reaches[row] > ends[row]]
    (note,) = [note for note in state.notes[0] if note.key == "ellipse_over_shoulder"]
    assert [int(row) for row in re.findall(r"row (\d)", note.text)] == expected
    worst = max(expected, key=lambda row: reaches[row] - ends[row])
    assert f"reaches {degrees(reaches[worst]):.1f}°" in note.text
    assert f"ends at {degrees(ends[worst]):.1f}°" in note.text


def groove_end(bearing: Bearing, row: int, height: float) -> float:
    own = bearing.places[row].bearing
    return acos(1.0 - height / (own.outer_conformity * own.ball_diameter))


# --- advice -----------------------------------------------------------------


def advice_on(case: Case) -> Note:
    state = solve(case)
    assert state.status.code[0] == "no_equilibrium"
    (advice,) = state.advice
    assert advice
    assert said(advice, "pt") != said(advice)
    return advice


def test_springs_pushed_back() -> None:
    text = advice_on(sprung_with(fx=-400.0)).text
    assert "an axial load of 400 N pushes back the springs, which press with 300 N" in text


def test_springs_too_weak_for_a_moment() -> None:
    advice = advice_on(sprung_with(fx=100.0, my=300.0))
    assert advice.text.startswith("Springs of 300 N do not keep the balls")


def sprung_with(**load: float) -> Case:
    case = case_of("6012_pair", AXIAL)
    bearing = case.bearing.replace(preload={"spring": "300 N"})
    return case.replace(
        bearing=bearing, duty=case.duty.replace(load=case.duty.load.replace(**load))
    )


@pytest.mark.parametrize(("orientation", "fx", "away"), [("+", "-1 kN", "-x"), ("-", "1 kN", "+x")])
def test_rows_that_all_face_one_way(orientation: str, fx: str, away: str) -> None:
    case = case_of("6012_pair", f"duty.load.fx={fx}")
    rows = [{"orientation": orientation, "position": f"{x} mm"} for x in (-9, 9)]
    bearing = case.bearing.replace(arrangement=None, spacing=None, preload=None, rows=rows)
    advice = advice_on(case.replace(bearing=bearing))
    assert f"toward {away}: all rows carry axial load toward" in advice.text


def test_clamped_rows_with_too_much_play() -> None:
    case = case_of("6012_pair", AXIAL)
    bearing = case.bearing.replace(preload="-100 um")
    assert advice_on(case.replace(bearing=bearing)) == Note("shoulder_lost")
