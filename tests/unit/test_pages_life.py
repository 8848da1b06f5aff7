"""Pages of life: what is said, in both languages, on any medium, with the right numbers."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from tests.one_case import keys, said

from rolamento import Analysis, Case, analyse, load_case, override
from rolamento.document import Document, Figure, Table
from rolamento.document.medium import Medium
from rolamento.document.terminal import terminal
from rolamento.life import LifeSummary, conditions_of, life, sensitivity
from rolamento.life.record import OUTSIDE
from rolamento.pages.life import life_page, percent
from rolamento.pages.life_over import life_over_page
from rolamento.pages.life_spectrum import life_spectrum_page
from rolamento.pages.shaft import shaft_page
from rolamento.pages.state import state_page
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.studies.names import setting_name
from rolamento.studies.ranges import read_range
from rolamento.tasks.life import life_of_shaft
from rolamento.tasks.life_over import life_curve
from rolamento.tasks.life_spectrum import life_of_duty_spectrum, read_spectrum
from rolamento.words import Note, manner, speaking
from rolamento.words.theories import theory_name

EXAMPLES = Path(__file__).resolve().parents[2] / "src" / "rolamento" / "examples"
LANGUAGES = ("en", "pt")


def shown(analysis: Analysis, language: str, width: int = 80) -> str:
    """The page of the state with what follows from it."""
    with speaking(language):
        return terminal(state_page(analysis.solved, analysis), Medium(width=width))


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
    "sure": ("life.reliability=0.9999", "life.required_life=1 h"),
    "dirty": ("life.contamination=0",),
    "tilted": ("duty.load.my=5 N m", "duty.inner_speed=15000 rpm"),
    "clean": ("life.contamination=1", "life.viscosity_ratio=5", "duty.load.fz=500 N"),
}


@cache
def solved(name: str) -> tuple[Solved, LifeSummary]:
    state = solve(load_case(EXAMPLES / "6305_life.toml", VARIED[name]))
    return state, life(state)


def report(name: str, language: str = "en", **medium: Any) -> str:
    state, found = solved(name)
    with speaking(language):
        return terminal(life_page(state, found, sensitivity(state)), Medium(**medium))


def number(value: float, form: str, language: str = "en") -> str:
    with speaking(language):
        return manner().number(value, form)


def section(text: str, heading: str) -> str:
    """The lines below a heading, up to the next empty one."""
    return text.split(f"\n{heading}\n")[1].split("\n\n")[0]


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
        (INF, "∞", "∞"),
        (NAN, "–", "–"),
    ],
)
def test_a_life_has_three_digits(value: float, english: str, portuguese: str) -> None:
    assert number(value, ".3r") == english
    assert number(value, ".3r", "pt") == portuguese


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
    assert percent(share) == text


def test_a_given_reliability_keeps_its_digits() -> None:
    with speaking("pt"):
        assert manner().number(0.9, ".7 %") == "90 %"
        assert manner().number(0.99995, ".7 %") == "99,995 %"


# --- the statement ----------------------------------------------------------------------------


def test_the_statement_goes_by_the_life_that_leads() -> None:
    state, found = solved("as it is")
    text = section(report("as it is"), "Life")
    best = found["iso16281_modified"]
    assert found.headline.theory[0] == best.theory
    assert found.headline.hours[0] == best.hours[0]
    hours = number(float(best.hours[0]), ".3r")
    assert f"With 90 % reliability this bearing reaches {hours} h" in text
    assert "(modified reference rating life, ISO/TS 16281)." in text
    assert "The inner race limits it." in text
    assert found.limit.race[0] == "inner"
    first = sensitivity(state)[0]
    assert first.name == "cleaner_oil"
    assert f"Cleaner oil would help most: life × {first.life_ratio:.3g}." in text
    reliability = 100.0 * float(found.reliability_after(5000.0 * 3600.0)[0])
    assert f"Reliability at the required 5000 h: {reliability:.3g} %." in text


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("too much", "No theory that considers the load of every ball is valid for this case."),
        ("too much", "exceeds half of the dynamic load rating"),
        ("clean", "More than 100 000 h: fatigue will not end it."),
        ("too much", "do not rely on them"),
        ("hot", "exceed 120 °C, the limit"),
        ("hot ring", "exceed 120 °C, the limit"),
        ("thin oil", "reaches less than 917 h"),
        ("thin oil", "(upper bound of the modified reference rating life, ISO/TS 16281)"),
        ("thin oil", "κ is below 0.1, where the standard gives no factor"),
        ("thin oil", "Reliability at the required 5000 h: below 23.9 %."),
        ("dirty", "reaches less than 917 h"),
        ("dirty", "wear, not fatigue, ends the life"),
        ("at rest", "nothing turns, so there are no hours"),
        ("unloaded", "No ball transmits load between the rings: there is no rating life."),
        ("sure", "With 99.99 % reliability"),
        ("sure", "Reliability at the required 1.00 h: 100 %"),
    ],
)
def test_the_statement_warns(name: str, said: str) -> None:
    text = " ".join(section(report(name), "Life").split())
    assert said in text


def test_what_does_not_hold_does_not_stand_in_the_statement() -> None:
    for name in ("too much", "hot"):
        text = section(report(name), "Life")
        assert " h," not in text
        assert "required" not in text


def test_without_lubrication_it_says_what_is_missing() -> None:
    state = solve(load_case(EXAMPLES / "218_combined.toml"))
    text = " ".join(terminal(life_page(state, life(state))).split())
    assert "Lubrication and contamination are not included: the case needs the viscosity" in text
    assert "life.cleanliness" in text


def test_with_its_oil_only_the_cleanliness_is_missing() -> None:
    oil = ["lubricant.base_oil=ISO VG 32", "temperature.lubricant=45 degC"]
    state = solve(override(load_case(EXAMPLES / "218_combined.toml"), oil))
    text = " ".join(terminal(life_page(state, life(state))).split())
    assert "not included: the case needs the cleanliness" in text
    assert "needs the viscosity" not in text


def test_a_set_is_told_row_by_row() -> None:
    state = solve(load_case(EXAMPLES / "6012_pair.toml"))
    text = terminal(life_page(state, life(state)))
    assert "this set reaches" in text
    assert "The inner race of row 0 limits it." in text
    assert "The inner race of row 0 contributes" in text


def test_without_a_result_there_is_the_reason_and_no_life(case_218: Case) -> None:
    state = solve(override(case_218, ["duty.load.fx=-20 kN"]))
    text = terminal(life_page(state, None))
    assert "there is no equilibrium" in text
    assert "\nLife\n" not in text


# --- tables -----------------------------------------------------------------------------------


def test_the_table_has_every_theory_and_its_factors() -> None:
    _, found = solved("all theories")
    table = section(report("all theories", width=120), "Life by theory")
    assert len(found.theories) == 7
    for name, record in found.theories.items():
        (line,) = (line for line in table.splitlines() if f" {theory_name(name)} " in line)
        assert number(float(record.life[0]), ".3r") in line
        assert number(float(record.hours[0]), ".3r") in line
        for factor in ("a_1", "a_iso", "a_2", "a_3", "a_nsk"):
            if factor in record.factors:
                assert number(float(record.factors[factor][0]), ".3") in line
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
    verdicts = {row[:25].strip(): row.split()[-1] for row in rows[:5]}
    assert verdicts["Ioannides and Harris"] == "bound"
    assert set(verdicts.values()) == {"no", "bound"}


def test_ratings_have_their_sources() -> None:
    text = section(report("as it is"), "Ratings and loads")
    assert re.search(r"C +20\.6 +kN +NSK, Rolling Bearings", text)
    assert "estimate C_0/22, ISO 281; by its contacts this interior has" in " ".join(text.split())
    state, found = solved("as it is")
    ratio = found.ratings.dynamic_of_set[0] / found.loads.dynamic[0]
    assert f"C/P = {ratio:.3g}" in text
    given = solve(
        override(state.case, ["life.dynamic_rating=21 kN", "life.fatigue_load_limit=470 N"])
    )
    text = section(terminal(life_page(given, life(given))), "Ratings and loads")
    assert re.search(r"C +21 +kN +given", text)
    assert re.search(r"C_u +0\.47 +kN +given", text)
    ceramic = " ".join(section(report("ceramic"), "Ratings and loads").split())
    assert "× 0.709, stiffness of the elements" in ceramic


def test_changes_have_bars_as_long_as_their_gain() -> None:
    state, _ = solved("as it is")
    lines = section(report("as it is", width=120), "What would help").splitlines()
    bars = [line.count("█") for line in lines]
    gains = [change.life_ratio - 1.0 for change in sensitivity(state)]
    assert bars[0] == max(bars) > 0
    for bar, gain in zip(bars, gains, strict=False):
        assert bar == pytest.approx(max(bars) * max(gain, 0.0) / gains[0], abs=1.0)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("width", [80, 120])
@pytest.mark.parametrize("name", VARIED)
@pytest.mark.thirds
def test_the_report_fits_and_leaves_no_blank(name: str, width: int, language: str) -> None:
    text = report(name, language, width=width)
    assert max(map(len, text.splitlines())) <= width
    for wrong in ("nan", "inf ", "None", "{", "}"):
        assert wrong not in text
    if language == "pt":
        for english in (" the ", "Life", " life", "bearing", "reliability"):
            assert english not in text.replace("Rolling Bearings (general catalogue)", "").replace(
                "deep-groove ball\nbearings", ""
            ).replace("bearings", "")


@pytest.mark.parametrize("language", LANGUAGES)
def test_colours_change_nothing_but_colours(language: str) -> None:
    plain = report("as it is", language)
    coloured = report("as it is", language, colors=True)
    assert "\x1b[" in coloured
    assert re.sub(r"\x1b\[[0-9;]*m", "", coloured) == plain


def test_plain_terminals_get_plain_characters() -> None:
    text = report("all theories", "pt", encoding="ascii")
    assert text.isascii()
    assert "kappa" in text
    assert "?" not in text


# --- in the report of a state -----------------------------------------------------------------


def test_solve_shows_the_life_in_short() -> None:
    analysis = analyse(load_case(EXAMPLES / "6305_life.toml"))
    text = shown(analysis, "en")
    part = section(text, "Life")
    assert "With 90 % reliability this bearing reaches" in part
    assert "Contamination costs the most life (e_C = 0.0675)." in part
    assert "ISO 281, basic: 9110 h" in part
    assert "rolamento life" in part
    assert text.index("\nLubricant film") < text.index("\nLife\n") < text.index("\nNotes")
    notes = section(text, "Notes")
    assert Note("moment_left_out").text[:40] in notes
    with speaking("pt"):
        portuguese = shown(analysis, "pt")
    assert "\nVida\n" in portuguese
    assert said(Note("moment_left_out"), "pt")[:40] in portuguese


def test_a_case_that_asks_for_no_life_shows_none(case_218: Case) -> None:
    analysis = analyse(case_218)
    assert analysis.life is None
    assert "\nLife\n" not in shown(analysis, "en")


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
    for language in LANGUAGES:
        text = shown(analysis, language, width=120)
        assert said(Note(name), language)[:60] in text


def test_l_able_without_viscosity_is_a_note_and_no_end() -> None:
    case = load_case(EXAMPLES / "218_combined.toml", ["life.nsk_cleanliness=0.8"])
    analysis = analyse(case)
    assert keys(analysis.notes) == {"l_able_without_viscosity"}
    assert analysis.life is not None
    assert set(analysis.life.theories) == {"iso281", "iso16281", "ioannides_harris"}
    for language in LANGUAGES:
        text = shown(analysis, language, width=120)
        assert said(analysis.notes[0], language)[:60] in text


# --- curves, spectra, shafts ------------------------------------------------------------------


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("width", [80, 120])
def test_the_other_reports_fit(language: str, width: int, tmp_path: Path) -> None:
    case = load_case(EXAMPLES / "6305_life.toml", VARIED["all theories"])
    medium = Medium(width=width)
    curve = life_curve(case, read_range("duty.load.fz=1..14kN", 6))
    found = life_of_duty_spectrum(case, read_spectrum(EXAMPLES / "6305_steps.csv"))
    shaft = life_of_shaft([case, override(case, ["duty.load.fz=3 kN"])])
    names = ["a bearing with a title that is longer than any table", "b.toml"]
    with speaking(language):
        pages = [life_over_page([curve]), life_spectrum_page(found), shaft_page(shaft, names)]
    for page in pages:
        text = terminal(page, medium)
        assert max(map(len, text.splitlines())) <= width
        assert not re.search(r"nan|inf |None|[{}]", text)


def test_a_curve_marks_where_a_theory_does_not_hold() -> None:
    case = load_case(EXAMPLES / "6305_life.toml")
    text = terminal(life_over_page([life_curve(case, read_range("duty.load.fz=8..12kN", 3))]))
    rows = [line.split() for line in text.splitlines() if re.match(r" +\d+\.\d{3} ", line)]
    assert [row[0] for row in rows] == ["8.000", "10.000", "12.000"]
    assert [sum(cell.endswith("*") for cell in row) for row in rows] == [0, 0, 4]
    assert "at 12 kN): The equivalent load exceeds half" in " ".join(text.split())
    assert "longest at 8 kN" in text


def test_a_curve_at_rest_is_in_revolutions() -> None:
    case = load_case(EXAMPLES / "6305_life.toml", ["duty.inner_speed=0 rpm"])
    text = terminal(life_over_page([life_curve(case, read_range("duty.load.fz=1..2kN", 2))]))
    assert "10⁶ rev" in text
    assert "for 90 % reliability" in text


def test_conditions_of_a_state_are_those_of_its_case() -> None:
    state, found = solved("as it is")
    again = life(state, conditions_of(state.case))
    assert again["iso16281"].hours == found["iso16281"].hours


# --- documents --------------------------------------------------------------------------------


def table_of(page: Document, key: str) -> Table:
    (found,) = (table for table in page.tables() if table.key == key)
    return found


def test_tables_hold_the_numbers_of_the_record() -> None:
    state, found = solved("as it is")
    page = life_page(state, found, sensitivity(state))
    columns = {column.key: column.values for column in table_of(page, "theories").columns}
    assert columns["hours"] == [3600.0 * float(life.hours[0]) for life in found.theories.values()]
    assert columns["life"] == [1e6 * float(life.life[0]) for life in found.theories.values()]
    assert columns["contamination_factor"][1] == found.contamination_factor[0]
    assert columns["leads"] == ["", "", "", "▸", ""]


def test_a_life_far_from_that_of_the_catalogue_says_why() -> None:
    text = " ".join(section(report("as it is"), "Life").split())
    assert "The catalogue life L_10 = (C/P)³ is 9110 h. This one is 0.573 times as long:" in text
    assert "contamination (a_ISO = 0.57, κ = 1.31, e_C = 0.0675)" in text
    sure = " ".join(section(report("sure"), "Life").split())
    assert "reliability of 99.99 % (a_1 = " in sure


def test_pages_have_pictures() -> None:
    state, found = solved("as it is")
    curve = life_curve(state.case, read_range("duty.load.fz=1..3kN", 3))
    for page in (life_page(state, found, sensitivity(state)), life_over_page([curve])):
        figures = [block for block in page.blocks() if isinstance(block, Figure)]
        assert figures
        assert all(figure.draw is not None and figure.draw().axes for figure in figures)


def test_files_of_a_curve_have_all_its_points() -> None:
    case = load_case(EXAMPLES / "6305_life.toml")
    curves = [life_curve(case, read_range("duty.load.fz=1..14kN", 6), label=name) for name in "ab"]
    page = life_over_page(curves)
    points = {(one.key, one.unit): one for one in table_of(page, page.main).columns}
    assert len(points["duty.load.fz", "kN"].values) == 12
    assert points["headline", "h"].values[0] == 3600.0 * curves[0].headline.hours[0]
    assert points["iso281_valid", ""].values[-1] == "no"


def test_a_setting_has_the_label_of_its_field() -> None:
    assert setting_name("life.contamination=0.8") == "contamination factor e_C = 0.8"
    with speaking("pt"):
        assert setting_name("temperature.lubricant=70.5 °C") == (
            "temperatura do lubrificante = 70,5 °C"
        )
    assert setting_name("nothing of ours") == "nothing of ours"
