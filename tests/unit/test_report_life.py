"""Life in the report: what is said, in both languages, on any medium, with the right numbers."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import fields
from functools import cache
from pathlib import Path
from string import Formatter
from typing import Any

import pytest
from rolamento.report.life import life_report
from rolamento.report.life_curves import curves_report
from rolamento.report.life_spectrum import spectrum_report
from rolamento.report.life_statement import (
    factor_text,
    given_percent,
    life_text,
    lives_column,
    percent,
)
from rolamento.report.life_words import LIFE_WORDS
from rolamento.report.shaft import shaft_report
from tests.one_case import keys, said

from rolamento import Case, analyse, load_case, override
from rolamento.document.medium import Medium
from rolamento.life import LifeSummary, conditions_of, life, sensitivity
from rolamento.life.record import OUTSIDE
from rolamento.life.sensitivity import CHANGES
from rolamento.report.language import ENGLISH, PORTUGUESE, Words
from rolamento.report.page import Page
from rolamento.report.terminal import terminal_report
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.studies.ranges import read_range
from rolamento.tasks.life import life_of_shaft
from rolamento.tasks.life_over import life_curve
from rolamento.tasks.life_spectrum import life_under, read_spectrum
from rolamento.words import Note
from rolamento.words.sentences import sentences

EXAMPLES = Path(__file__).resolve().parents[2] / "src" / "rolamento" / "examples"
LANGUAGES = (ENGLISH, PORTUGUESE)
NAN, INF = float("nan"), float("inf")
VARIED: dict[str, tuple[str, ...]] = {
    "as it is": (),
    "hot": ("temperature.lubricant=130 degC",),
    "hot ring": ("temperature.inner_ring=130 degC",),
    "too much": ("duty.load.fz=12 kN",),
    "thin oil": ("life.viscosity_ratio=0.05",),
    "at rest": ("duty.inner_speed=0 rpm",),
    "unloaded": ("duty.load.fz=0 N", "duty.load.fx=0 N", "duty.inner_speed=0 rpm"),
    "ceramic": ("bearing.ball_material=Si3N4",),
    "all theories": ("life.material_factor=1", "life.operation_factor=2", "life.nsk_cleanliness=1"),
    "sure": ("life.reliability=0.9999", "life.wanted_life=1 h"),
    "dirty": ("life.contamination=0",),
    "tilted": ("duty.load.my=5 N m", "duty.inner_speed=15000 rpm"),
    "clean": ("life.contamination=1", "life.viscosity_ratio=5", "duty.load.fz=500 N"),
}


@cache
def solved(name: str) -> tuple[Solved, LifeSummary]:
    state = solve(load_case(EXAMPLES / "6305_life.toml", VARIED[name]))
    return state, life(state)


def report(name: str, words: Words = ENGLISH, **medium: Any) -> str:
    state, found = solved(name)
    return life_report(state, found, sensitivity(state), words, Medium(**medium))


def section(text: str, heading: str) -> str:
    """The lines below a heading, up to the next empty one."""
    return text.split(f"\n{heading}\n")[1].split("\n\n")[0]


# --- words ------------------------------------------------------------------------------------


def test_every_change_is_said() -> None:
    for words in LIFE_WORDS.values():
        assert set(words.helps) == set(CHANGES) <= set(sentences())


def test_portuguese_is_not_english() -> None:
    english, portuguese = LIFE_WORDS["en"], LIFE_WORDS["pt"]
    for name in ("helps", "valid", "long"):
        ours, theirs = getattr(portuguese, name), getattr(english, name)
        assert [key for key in ours if ours[key] == theirs[key]] in ([], ["l_able"])


def test_both_languages_fill_in_the_same() -> None:
    def blanks(value: object) -> object:
        if isinstance(value, Mapping):
            return {key: blanks(inner) for key, inner in value.items()}
        if isinstance(value, tuple):
            return len(value)
        return {name for _, name, _, _ in Formatter().parse(str(value)) if name is not None}

    english, portuguese = LIFE_WORDS["en"], LIFE_WORDS["pt"]
    for field in fields(english):
        own, other = getattr(english, field.name), getattr(portuguese, field.name)
        assert blanks(own) == blanks(other), field.name


# --- numbers ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("value", "english", "portuguese"),
    [
        (1138.257, "1140", "1140"),
        (12_345.6, "12 300", "12 300"),
        (2_662_083.0, "2 660 000", "2 660 000"),
        (51.3264, "51.3", "51,3"),
        (5.0, "5.00", "5,00"),
        (0.012345, "0.0123", "0,0123"),
        (9.999, "10.0", "10,0"),
        (5.913e11, "5.91e11", "5,91e11"),
        (1e-9, "1.00e-9", "1,00e-9"),
        (0.0, "0", "0"),
        (INF, "endless", "sem fim"),
        (NAN, "–", "–"),
    ],
)
def test_a_life_has_three_digits(value: float, english: str, portuguese: str) -> None:
    assert life_text(Page(ENGLISH, Medium()), value) == english
    assert life_text(Page(PORTUGUESE, Medium()), value) == portuguese


@pytest.mark.parametrize(
    ("share", "text"),
    [
        (0.5, "50 %"),
        (0.65607, "65.6 %"),
        (0.9999, "more than 99.9 %"),
        (0.9994, "99.9 %"),
        (1.0, "100 %"),
        (1e-9, "less than 0.1 %"),
        (0.0, "0 %"),
        (NAN, "–"),
    ],
)
def test_shares(share: float, text: str) -> None:
    assert percent(Page(ENGLISH, Medium()), share) == text


def test_a_given_reliability_keeps_its_digits() -> None:
    page = Page(PORTUGUESE, Medium())
    assert given_percent(page, 0.9) == "90 %"
    assert given_percent(page, 0.99995) == "99,995 %"
    assert factor_text(page, 0.41689) == "0,417"


def test_decimal_marks_stand_in_line() -> None:
    column = lives_column(Page(ENGLISH, Medium()), [1138.0, 56.9, 5.9e11, NAN])
    assert column == ["1140  ", "56.9", "5.90e11  ", "–  "]


# --- the statement ----------------------------------------------------------------------------


def test_the_statement_goes_by_the_life_that_leads() -> None:
    state, found = solved("as it is")
    text = section(report("as it is"), "Life")
    best = found["iso16281_modified"]
    assert found.headline.theory[0] == best.theory
    assert found.headline.hours[0] == best.hours[0]
    hours = life_text(Page(ENGLISH, Medium()), float(best.hours[0]))
    assert f"With 90 % reliability this bearing reaches {hours} h" in text
    assert "(modified reference life, ISO/TS 16281)." in text
    assert "The inner ring limits it." in text
    assert found.limit.race[0] == "inner"
    first = sensitivity(state)[0]
    assert first.name == "cleaner_oil"
    assert f"Cleaner oil would help most: {first.life_ratio:.3g} times the life." in text
    reliability = 100.0 * float(found.reliability_after(5000.0 * 3600.0)[0])
    assert f"The required 5000 h have a reliability of {reliability:.3g} %." in text


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("too much", "No theory that counts the load of every ball is valid for this case."),
        ("too much", "exceeds half of the dynamic load rating"),
        ("too much", "do not rely on them"),
        ("hot", "exceed 120 °C, the limit"),
        ("hot ring", "exceed 120 °C, the limit"),
        ("thin oil", "reaches less than 917 h"),
        ("thin oil", "(bound of the modified reference life, ISO/TS 16281)"),
        ("thin oil", "κ is below 0.1, where the standard gives no factor"),
        ("thin oil", "The required 5000 h have a reliability below 23.9 %."),
        ("dirty", "reaches less than 917 h"),
        ("dirty", "wear, not fatigue, ends the life"),
        ("at rest", "nothing turns, so there are no hours"),
        ("unloaded", "No ball transmits load between the rings: there is no rating life."),
        ("sure", "With 99.99 % reliability"),
        ("sure", "The required 1.00 h have a reliability of 100 %"),
    ],
)
def test_the_statement_warns(name: str, said: str) -> None:
    text = " ".join(section(report(name), "Life").split())
    assert said in text


def test_what_does_not_hold_does_not_stand_in_the_statement() -> None:
    for name in ("too much", "hot"):
        text = section(report(name), "Life")
        assert " h," not in text
        assert "wanted" not in text


def test_without_lubrication_it_says_what_is_missing() -> None:
    state = solve(load_case(EXAMPLES / "218_combined.toml"))
    text = " ".join(life_report(state, life(state)).split())
    assert "Oil and dirt are not in it: for them the case needs the viscosity" in text
    assert "life.cleanliness" in text


def test_a_set_is_told_row_by_row() -> None:
    state = solve(load_case(EXAMPLES / "6012_pair.toml"))
    text = life_report(state, life(state))
    assert "this set reaches" in text
    assert "The inner ring of row 0 limits it." in text
    assert "the inner ring of row 0 has" in text


def test_without_a_result_there_is_the_reason_and_no_life(case_218: Case) -> None:
    state = solve(override(case_218, ["duty.load.fx=-20 kN"]))
    text = life_report(state, None)
    assert "there is no equilibrium" in text
    assert "\nLife\n" not in text


# --- tables -----------------------------------------------------------------------------------


def test_the_table_has_every_theory_and_its_factors() -> None:
    _, found = solved("all theories")
    table = section(report("all theories", width=120), "Life by theory")
    assert len(found.theories) == 7
    page = Page(ENGLISH, Medium())
    for name, record in found.theories.items():
        (line,) = (
            line for line in table.splitlines() if f" {LIFE_WORDS['en'].names[name]} " in line
        )
        assert life_text(page, float(record.life[0])) in line
        assert life_text(page, float(record.hours[0])) in line
        for factor in ("a_1", "a_iso", "a_2", "a_3", "a_nsk", "viscosity_ratio"):
            if factor in record.factors:
                assert factor_text(page, float(record.factors[factor][0])) in line
    assert next(line for line in table.splitlines() if "▸" in line).split()[1:3] == [
        "ISO/TS",
        "16281,",
    ]


def test_what_refuses_a_theory_stands_below_it() -> None:
    _, found = solved("too much")
    text = " ".join(report("too much").split())
    for name in OUTSIDE & keys(found["iso281"].notes_of()):
        assert Note(name).text in text
        assert "✗ not valid (ISO 281, basic; ISO 281, modified; ISO/TS 16281, basic;" in text
    rows = section(report("too much"), "Life by theory").splitlines()[1:]
    verdicts = {row[:26].strip(): row.split()[-1] for row in rows[:5]}
    assert verdicts["Ioannides and Harris"] == "bound"
    assert set(verdicts.values()) == {"no", "bound"}


def test_ratings_have_their_sources() -> None:
    text = section(report("as it is"), "Ratings and loads")
    assert re.search(r"C +20\.6 +kN +NSK, Rolling Bearings", text)
    assert "where the weaker race reaches 1500 MPa" in text
    state, found = solved("as it is")
    ratio = found.ratings.dynamic_of_set[0] / found.loads.dynamic[0]
    assert f"C/P = {ratio:.3g}" in text
    given = solve(
        override(state.case, ["life.dynamic_rating=21 kN", "life.fatigue_load_limit=470 N"])
    )
    text = section(life_report(given, life(given)), "Ratings and loads")
    assert re.search(r"C +21 +kN +given", text)
    assert re.search(r"C_u +0\.47 +kN +given", text)
    assert "not known" in section(report("ceramic"), "Ratings and loads")


def test_changes_have_bars_as_long_as_their_gain() -> None:
    state, _ = solved("as it is")
    lines = section(report("as it is", width=120), "What would help").splitlines()
    bars = [line.count("█") for line in lines]
    gains = [change.life_ratio - 1.0 for change in sensitivity(state)]
    assert bars[0] == max(bars) > 0
    for bar, gain in zip(bars, gains, strict=False):
        assert bar == pytest.approx(max(bars) * max(gain, 0.0) / gains[0], abs=1.0)


@pytest.mark.parametrize("words", LANGUAGES, ids=lambda words: words.code)
@pytest.mark.parametrize("width", [80, 120])
@pytest.mark.parametrize("name", VARIED)
def test_the_report_fits_and_leaves_no_blank(name: str, width: int, words: Words) -> None:
    text = report(name, words, width=width)
    assert max(map(len, text.splitlines())) <= width
    for wrong in ("nan", "inf ", "None", "{", "}"):
        assert wrong not in text
    if words is PORTUGUESE:
        for english in (" the ", "Life", " life", "bearing", "reliability"):
            assert english not in text.replace("Rolling Bearings (general catalogue)", "").replace(
                "deep-groove ball\nbearings", ""
            ).replace("bearings", "")


@pytest.mark.parametrize("words", LANGUAGES, ids=lambda words: words.code)
def test_colours_change_nothing_but_colours(words: Words) -> None:
    plain = report("as it is", words)
    coloured = report("as it is", words, colors="standard")
    assert "\x1b[" in coloured
    assert re.sub(r"\x1b\[[0-9;]*m", "", coloured) == plain


def test_plain_terminals_get_plain_characters() -> None:
    text = report("all theories", PORTUGUESE, encoding="ascii")
    assert text.isascii()
    assert "kappa" in text
    assert "?" not in text


# --- in the report of a state -----------------------------------------------------------------


def test_solve_shows_the_life_in_short() -> None:
    analysis = analyse(load_case(EXAMPLES / "6305_life.toml"))
    text = terminal_report(analysis.solved, ENGLISH, Medium(), analysis)
    part = section(text, "Life")
    assert "With 90 % reliability this bearing reaches" in part
    assert "it is the dirt that costs most (e_C = 0.0675)" in part
    assert "ISO 281, basic: 9110 h" in part
    assert "rolamento life" in part
    assert text.index("\nLubricant film") < text.index("\nLife\n") < text.index("\nNotes")
    notes = section(text, "Notes")
    assert Note("moment_left_out").text[:40] in notes
    portuguese = terminal_report(analysis.solved, PORTUGUESE, Medium(), analysis)
    assert "\nVida\n" in portuguese
    assert said(Note("moment_left_out"), "pt")[:40] in portuguese


def test_a_case_that_asks_for_no_life_shows_none(case_218: Case) -> None:
    analysis = analyse(case_218)
    assert analysis.life is None
    assert "\nLife\n" not in terminal_report(analysis.solved, ENGLISH, Medium(), analysis)


@pytest.mark.parametrize(
    ("settings", "name"),
    [
        (("bearing.contact_angle=60 deg",), "life_of_thrust_bearing"),
        (("bearing.ball_diameter=20 mm", "bearing.pitch_diameter=45 mm", "bearing.ball_count=5",
          "bearing.contact_angle=5 deg"), "life_without_rating"),
    ],
)  # fmt: skip
def test_why_a_case_has_no_life_is_a_note(
    case_218: Case, settings: tuple[str, ...], name: str
) -> None:
    case = override(case_218, ["life.reliability=0.9", "duty.inner_speed=100 rpm", *settings])
    analysis = analyse(override(case, ["duty.load.fz=0 N"]))
    assert analysis.solved.converged[0]
    assert keys(analysis.notes) == {name}
    for words in LANGUAGES:
        text = terminal_report(analysis.solved, words, Medium(width=120), analysis)
        assert said(Note(name), words.code)[:60] in text


def test_l_able_without_viscosity_is_a_note_and_no_end() -> None:
    case = load_case(EXAMPLES / "218_combined.toml", ["life.nsk_cleanliness=0.8"])
    analysis = analyse(case)
    assert keys(analysis.notes) == {"l_able_without_viscosity"}
    assert analysis.life is not None
    assert set(analysis.life.theories) == {"iso281", "iso16281", "ioannides_harris"}
    for words in LANGUAGES:
        text = terminal_report(analysis.solved, words, Medium(width=120), analysis)
        assert said(analysis.notes[0], words.code)[:60] in text


# --- curves, spectra, shafts ------------------------------------------------------------------


@pytest.mark.parametrize("words", LANGUAGES, ids=lambda words: words.code)
@pytest.mark.parametrize("width", [80, 120])
def test_the_other_reports_fit(words: Words, width: int, tmp_path: Path) -> None:
    case = load_case(EXAMPLES / "6305_life.toml", VARIED["all theories"])
    medium = Medium(width=width)
    curve = life_curve(case, read_range("duty.load.fz=1..14kN", 6))
    found = life_under(case, read_spectrum(EXAMPLES / "6305_steps.csv"))
    shaft = life_of_shaft([case, override(case, ["duty.load.fz=3 kN"])])
    names = ["a bearing with a title that is longer than any table", "b.toml"]
    for text in (
        curves_report([curve], words, medium),
        spectrum_report(found, words, medium),
        shaft_report(shaft, names, words, medium),
    ):
        assert max(map(len, text.splitlines())) <= width
        assert not re.search(r"nan|inf |None|[{}]", text)


def test_a_curve_marks_where_a_theory_does_not_hold() -> None:
    case = load_case(EXAMPLES / "6305_life.toml")
    text = curves_report([life_curve(case, read_range("duty.load.fz=8..12kN", 3))])
    rows = [line.split() for line in text.splitlines() if re.match(r" +\d+\.\d{3} ", line)]
    assert [row[0] for row in rows] == ["8.000", "10.000", "12.000"]
    assert [sum(cell.endswith("*") for cell in row) for row in rows] == [0, 0, 4]
    assert "at 12 kN): The equivalent load exceeds half" in " ".join(text.split())
    assert "longest at 8 kN" in text


def test_a_curve_at_rest_is_in_revolutions() -> None:
    case = load_case(EXAMPLES / "6305_life.toml", ["duty.inner_speed=0 rpm"])
    text = curves_report([life_curve(case, read_range("duty.load.fz=1..2kN", 2))])
    assert "in Mrev, for 90 % reliability" in text


def test_conditions_of_a_state_are_those_of_its_case() -> None:
    state, found = solved("as it is")
    again = life(state, conditions_of(state.case))
    assert again["iso16281"].hours == found["iso16281"].hours
