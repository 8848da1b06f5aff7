"""The report: complete, in two languages, on any medium, and never a NaN."""

from __future__ import annotations

import csv
import dataclasses
import re
from functools import cache
from math import degrees, inf, nan, pi
from pathlib import Path
from typing import get_args

import numpy as np
import pytest
from tests.one_case import said

import rolamento
from rolamento import Case
from rolamento.case.model import CageKind, RacewayControl
from rolamento.document import Column, Document, KeyValues, Number, Section, Table
from rolamento.document.cells import cells
from rolamento.document.medium import Medium
from rolamento.document.tables import to_csv
from rolamento.document.terminal import terminal
from rolamento.pages.elements import contact_name, element_sections
from rolamento.pages.given import head, model_text
from rolamento.pages.state import rosette, state_page
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.solved.form import control_names
from rolamento.status import STATUS_NAMES
from rolamento.words import ABSENT, Manner, decimals_for, language_of, speaking
from rolamento.words.reasons import reason

EXAMPLES = Path(rolamento.__file__).parent / "examples"
NAMES = (
    "218_combined",
    "218_hybrid",
    "218_tilted",
    "209_radial",
    "6012_pair",
    "6012_triple",
)
BOTH = pytest.mark.parametrize("language", ["en", "pt"])


@cache
def solved(name: str, *settings: str) -> Solved:
    return solve(rolamento.load_case(EXAMPLES / f"{name}.toml", settings))


def plain(state: Solved, language: str = "en", **medium: object) -> str:
    with speaking(language):
        return terminal(state_page(state), Medium(**medium))  # type: ignore[arg-type]


# --- the report -------------------------------------------------------------


@BOTH
@pytest.mark.parametrize("width", [80, 120])
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.thirds
def test_no_line_is_wider_than_the_medium(name: str, width: int, language: str) -> None:
    lines = plain(solved(name), language, width=width).splitlines()
    assert max(map(len, lines)) == width
    assert all(line == line.rstrip() for line in lines)


def test_the_report_shows_what_was_given_and_what_follows() -> None:
    state = solved("218_combined")
    report = plain(state)
    assert report.startswith("218 angular-contact ball bearing, combined load\n")
    assert "16 balls of 22.23 mm, pitch diameter 125.26 mm" in report
    assert "inner ring 10 000 rpm, fx 20 kN, fz 15 kN" in report
    assert f"{1e6 * state.displacement.z[0]:.3f} µm" in report
    assert re.search(r"fz 15 000 +N +fz given", report)
    assert re.search(rf"my +{state.load.my[0]:.2f} N·m +held", report)
    assert re.search(r"fy +0 +N +free", report)


def test_every_ball_has_its_line_with_its_numbers() -> None:
    state = solved("218_combined")
    report = plain(state, width=120)
    for number, azimuth in enumerate(state.elements.azimuth[0]):
        line = next(row for row in report.splitlines() if re.match(rf" +{number} +\d+\.\d\d", row))
        cells = line.replace("◂", "").replace("−", "-").split()
        assert float(cells[1]) == pytest.approx(degrees(azimuth), abs=0.006)
        inner, outer = state.inner, state.outer
        assert float(cells[2]) == pytest.approx(inner.load[0, number], abs=0.06)
        angle = degrees(outer.contact_angle[0, number])
        assert float(cells[5]) == pytest.approx(angle, abs=0.006)
        assert float(cells[6]) == pytest.approx(1e-6 * inner.max_pressure[0, number], abs=0.6)


def test_the_greatest_loads_and_pressures_are_marked_once_each() -> None:
    marked = [row for row in plain(solved("218_combined")).splitlines() if row.count("◂") == 4]
    assert len(marked) == 1
    assert marked[0].split()[0] == "0"


def test_a_ball_without_inner_contact_has_dashes() -> None:
    row = next(r for r in plain(solved("209_radial")).splitlines() if r.startswith("  4  160"))
    assert row.split()[2:] == [ABSENT] * 6


def test_at_rest_nothing_is_said_about_motion() -> None:
    report = plain(solved("209_radial"))
    assert "at rest" in report
    assert "raceway control" not in report
    assert "F_c" not in report


@BOTH
def test_without_a_result_reason_and_advice_are_given(language: str) -> None:
    state = solved("218_combined", "duty.load.fx=-20 kN")
    report = plain(state, language)
    with speaking(language):
        assert f"✗ {reason('no_equilibrium')}" in report
        assert " ".join(str(state.advice[0]).split()) in " ".join(report.split())
    assert {"en": "Stiffness", "pt": "Rigidez"}[language] not in report


@BOTH
def test_a_state_of_nothing_but_nan_is_shown(language: str) -> None:
    state = solved("218_combined", "duty.load.fx=-20 kN")
    status = dataclasses.replace(state.status, number=np.array([0]), residual=np.array([nan]))
    hollow = dataclasses.replace(state, status=status)
    vars(hollow)["notes"] = ((),)  # which cannot be found of such numbers
    report = plain(hollow, language)
    assert "nan" not in report
    assert ABSENT in report


@BOTH
def test_sixty_balls_stay_readable(language: str) -> None:
    settings = ("ball_count=60", "ball_diameter=3 mm", "pitch_diameter=80 mm")
    state = solved("218_combined", *(f"bearing.{setting}" for setting in settings))
    assert state.converged[0]
    report = plain(state, language)
    assert max(map(len, report.splitlines())) == 80
    assert len(re.findall(r"(?m)^ +59 ", report)) == 2


def test_a_long_title_is_broken_and_markup_in_it_is_only_text(case_218: Case) -> None:
    title = "[bold]x[/] :smile: " + "word " * 35
    report = plain(solve(case_218.replace(title=title.strip())))
    assert report.startswith("[bold]x[/] :smile: word")
    assert max(map(len, report.splitlines())) == 80


def test_colours_only_where_the_medium_has_them() -> None:
    state = solved("218_combined")
    assert "\x1b[" not in plain(state)
    coloured = plain(state, colors=True)
    assert "\x1b[" in coloured
    assert re.sub(r"\x1b\[[\d;]*m", "", coloured).split() == plain(state).split()


@BOTH
@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "cp1252", "cp437", "utf-8", "no-such"])
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.thirds
def test_any_encoding_can_show_it(name: str, encoding: str, language: str) -> None:
    report = plain(solved(name), language, encoding=encoding)
    report.encode("ascii" if encoding == "no-such" else encoding)
    assert "?" not in report


def test_ascii_says_the_same() -> None:
    report = plain(solved("218_combined"), "pt", encoding="ascii")
    assert "angulo de contato 40deg" in report
    assert re.search(r"um    fx 20 000 +N    fx dado", report)
    assert "####" in report


# --- languages --------------------------------------------------------------


@BOTH
def test_every_status_has_words(language: str) -> None:
    with speaking(language):
        for code in set(STATUS_NAMES.values()) - {"converged"}:
            assert reason(code)
            assert "_" not in reason(code)


@pytest.mark.parametrize("control", get_args(RacewayControl))
@pytest.mark.parametrize("cage", get_args(CageKind))
def test_every_raceway_control_and_cage_has_words(control: str, cage: str) -> None:
    oil = ("lubricant.kind=dry", "lubricant.friction_coefficient=0.1")
    case = rolamento.load_case(EXAMPLES / "218_combined.toml", oil)
    model = case.model.replace(raceway_control=control, cage=cage)
    heads = []
    for language in ("en", "pt"):
        with speaking(language):
            heads.append(model_text(case.replace(model=model)))
    assert heads[0] != heads[1]
    assert all(heads)


@pytest.mark.parametrize(
    ("environment", "code"),
    [
        ({}, "en"),
        ({"LANG": "pt_BR.UTF-8"}, "pt"),
        ({"LANG": "pt_BR.UTF-8", "LC_ALL": "C"}, "en"),
        ({"LANG": "en_GB.UTF-8", "LC_MESSAGES": "pt_PT"}, "pt"),
        ({"LANG": "de_DE.UTF-8"}, "en"),
        ({"LC_ALL": "", "LANG": "PT"}, "pt"),
    ],
)
def test_the_locale_chooses_the_language(environment: dict[str, str], code: str) -> None:
    assert language_of(None, environment) == code


def test_the_engine_is_heard_in_portuguese() -> None:
    state = solved("218_combined", "duty.load.fx=-20 kN")
    assert "no sentido −x" in said(state.advice[0], "pt")
    (note,) = solved("209_radial").notes[0]
    assert said(note, "pt") == (
        "4 esferas sem contato com a pista interna (azimute 120°, 160°, 200°, 240°):"
        " nenhuma força age sobre elas."
    )


# --- numbers ----------------------------------------------------------------


@pytest.mark.parametrize(
    ("value", "decimals", "text"),
    [
        (1234.5, 1, "1234,5"),
        (12345.6, 1, "12 345,6"),
        (-1234567.0, 0, "−1 234 567"),
        (-0.00001, 3, "0,000"),
        (nan, 2, ABSENT),
        (-inf, 2, ABSENT),
    ],
)
def test_numbers_are_written_as_people_write_them(value: float, decimals: int, text: str) -> None:
    assert Manner(",").fixed(value, decimals) == text


def test_a_column_has_the_decimals_of_its_greatest_number() -> None:
    assert Manner(".").column([0.5, 123.456, nan]) == ["0.50", "123.46", ABSENT]
    assert decimals_for([0.0, nan], 5) == 0
    assert decimals_for([1e-9], 5) == 4


def test_short_numbers_have_no_trailing_zeros() -> None:
    assert Manner(",").short(0.5232) == "0,5232"
    assert Manner(".").short(40.0) == "40"
    assert Manner(".").short(nan) == ABSENT


def test_quantities_of_a_case_keep_their_digits() -> None:
    assert Manner(",").localised("22.23 mm") == "22,23 mm"
    assert Manner(".").localised("10000 rpm") == "10 000 rpm"
    assert Manner(".").localised("-20 kN") == "−20 kN"
    assert Manner(",").localised("0.5 deg") == "0,5°"
    assert Manner(".").localised("70 degC") == "70 °C"
    assert Manner(".").localised("-20 N m") == "−20 N·m"
    assert Manner(".").localised("51210") == "51210"  # a designation


def test_decimal_marks_fall_below_each_other() -> None:
    column = Column("", [Number(1.25, ".3"), Number(10.0, ".3"), Number(nan, ".3")])
    assert cells(column) == ["1.25", "10   ", f"{ABSENT}   "]


# --- the rosette ------------------------------------------------------------


def drawn(loads: list[float], azimuths: list[float], *, braille: bool = True) -> list[str]:
    lines = rosette(loads, azimuths, 11, rim=loads[0], braille=braille)
    return ["".join("#" if tone == "mark" else " " for _, tone in line) for line in lines]


@pytest.mark.parametrize("braille", [True, False])
@pytest.mark.parametrize(
    ("azimuth", "rows", "columns"),
    [
        (0.0, range(6), range(10, 12)),  # +z is up
        (pi / 2, range(5, 6), range(10, 22)),  # +y is to the right
        (pi, range(5, 11), range(10, 12)),
        (3 * pi / 2, range(5, 6), range(12)),
    ],
)
def test_azimuths_run_from_above_to_the_right(
    azimuth: float, rows: range, columns: range, braille: bool
) -> None:
    lines = drawn([1.0, 0.0, nan], [azimuth, 1.0, 2.0], braille=braille)
    loaded = {(r, c) for r, line in enumerate(lines) for c, mark in enumerate(line) if mark == "#"}
    assert loaded
    assert {row for row, _ in loaded} <= set(rows)
    assert {column for _, column in loaded} <= set(columns)
    assert (
        len({row for row, _ in loaded}) * len({c for _, c in loaded})
        >= len(rows) * len(columns) / 2
    )


def test_half_the_load_is_half_as_long() -> None:
    lines = drawn([1.0, 0.5], [pi / 2, 3 * pi / 2])
    row = lines[5]
    right, left = row[11:].count("#"), row[:11].count("#")
    assert right == 11
    assert left in (5, 6)


def test_without_any_load_the_rim_is_drawn() -> None:
    lines = rosette([0.0, 0.0], [0.0, 1.0], 11, rim=0.0)
    assert any(character != " " for line in lines for character, _ in line)
    assert not any(tone == "mark" for line in lines for _, tone in line)


# --- the table of balls -----------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_the_csv_reads_back(name: str) -> None:
    state = solved(name)
    text = to_csv(state_page(state))
    assert text.endswith("\r\n")
    assert text.isascii()
    rows = list(csv.DictReader(text.splitlines()))
    assert tuple(rows[0])[:3] == ("row", "ball", "azimuth_deg")
    assert len(rows[0]) == 33
    columns = {
        "azimuth_deg": np.degrees(state.elements.azimuth[0]),
        "inner_load_N": state.inner.load[0],
        "outer_max_pressure_MPa": 1e-6 * state.outer.max_pressure[0],
        "gyroscopic_moment_Nmm": 1e3 * state.elements.gyroscopic_moment[0],
    }
    for name, values in columns.items():
        assert [float(row[name]) for row in rows] == pytest.approx(values.tolist())
    assert [row["raceway_control"] for row in rows] == control_names(state)


def test_the_csv_leaves_empty_what_does_not_exist() -> None:
    rows = list(
        csv.DictReader(
            to_csv(
                Document("", tuple(element_sections(solved("218_combined", "duty.load.fx=-20 kN"))))
            ).splitlines()
        )
    )
    assert len(rows) == 16
    assert {row["inner_load_N"] for row in rows} == {""}


def test_a_page_is_headed_by_the_bearing_as_delivered() -> None:
    case = Case.from_mapping(
        {
            "bearing": {"designation": "6310/C3"},
            "duty": {"inner_speed": "1480 rpm", "load": {"fz": "5 kN"}},
            "mounting": {"shaft_tolerance": "k5", "housing_tolerance": "H6"},
            "temperature": {"inner_ring": "70 degC", "outer_ring": "60 degC"},
        }
    )
    solved = solve(case)
    assert solved.case.bearing.ball_diameter > 19.06e-3  # warm
    assert solved.case.bearing.diametral_clearance is not None
    (given,) = (block for block in head(solved).blocks if isinstance(block, KeyValues))
    text = str(given.entries[0].content)
    assert "8 balls of 19.05 mm" in text
    warm = 1e6 * solved.case.bearing.diametral_clearance
    assert f"mounted and warm: diametral clearance {warm:.4g} µm" in text


def test_a_table_has_its_caption_above_it() -> None:
    table = Table((Column("x", [1.0], "x", "mm"),), "lengths", caption="Case A")
    lines = terminal(Document("Lengths", (Section("", (table,)),))).splitlines()
    assert [line.strip() for line in lines] == ["Case A", "x", "mm", "1000"]


def test_rollers_name_what_their_contacts_have() -> None:
    assert contact_name("semi_major", ["ball"]) == "semi-major axis"
    assert contact_name("semi_major", ["cylindrical"]) == "half the effective length"
    both = contact_name("deflection", ["ball", "cylindrical"])
    assert both == "contact approach; of rollers contact approach, maximum"
    assert contact_name("load", ["ball", "tapered"]) == "contact load"
