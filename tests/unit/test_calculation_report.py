"""The report that an engineer signs: its numbers are those of its JSON, in every language."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from html.parser import HTMLParser
from io import BytesIO
from math import isfinite
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from rolamento.case import ReportHead, load_case, override
from rolamento.cli.app import app
from rolamento.document import Document, Number, Table
from rolamento.document.html import html
from rolamento.document.pdf import pdf
from rolamento.document.terminal import terminal
from rolamento.errors import InputError
from rolamento.pages.equations import (
    CONDITIONS,
    EQUATIONS,
    REFERENCES,
    SYMBOLS,
    equations_of,
    references_of,
)
from rolamento.pages.report import report_page
from rolamento.tasks.demonstration import EXAMPLE
from rolamento.tasks.inside import ReportRequest
from rolamento.tasks.report import MOST_CASES, Report, calculation_report, checksum_of
from rolamento.words import in_unit, manner, speaking

EXAMPLES = Path(str(EXAMPLE)).parent
OVERLOADED = "duty.load.fz=9000 kN"
LIVES = ("10⁶ rev", "h")
_LIMITS = ("minimum", "mean", "maximum")


def example(name: str) -> str:
    return str(EXAMPLES / f"{name}.toml")


def of(*names: str, **head: str) -> Report:
    return calculation_report([example(name) for name in names], {"date": "2026-11-22", **head})


@pytest.fixture(scope="module")
def gearbox() -> Report:
    return of("6305_life")


@pytest.fixture(scope="module")
def spindle() -> Report:
    return of("218_combined", "218_hybrid")


# --- numbers of the page and of the JSON --------------------------------------------------------


def at(mapping: Any, path: str) -> Any:
    for part in path.split("."):
        if isinstance(mapping, list):
            mapping = mapping[int(part)]
        elif isinstance(mapping, dict):
            mapping = mapping.get(part)
        else:
            return None
    return mapping


def numbers_with_paths(page: Document, written: dict[str, Any]) -> list[tuple[float, Any]]:
    """Every number of a row that has a path, and what the JSON holds there."""
    cases = {case["name"]: case for case in written["cases"]}
    found = []
    for table in page.tables():
        columns = {column.key: column for column in table.columns}
        if "path" not in columns:
            continue
        for row, path in enumerate(columns["path"].values):
            for key, column in columns.items():
                value = column.values[row]
                own = value.value if isinstance(value, Number) else value
                if not isinstance(own, float) or not isfinite(own) or not path:
                    continue
                if key in cases:
                    found.append((own, at(cases[key], str(path))))
                elif key.endswith(("_difference", "_percent")):
                    name, _, kind = key.partition("_")
                    other = next(o for o in written["differences"] if o["case"] == name)
                    kind = "absolute" if kind == "difference" else "relative"
                    held = other["numbers"][str(path)][kind]
                    found.append((own, 0.0 if own == 0.0 else held))
                elif "*" in str(path):
                    found.append((own, at(written["cases"][0], str(path).replace("*", key))))
                else:
                    case = cases[table.key.rpartition("_")[2]]
                    held = at(case, str(path))
                    if column.unit in LIVES:
                        own = in_unit(own, column.unit)
                    if isinstance(held, dict) and key in held.get("factors", {}):
                        held = held["factors"]
                    place = _LIMITS.index(key) if isinstance(held, list) else None
                    found.append((own, at(held, key) if place is None else held[place]))
    return found


@pytest.mark.parametrize("lang", ["en", "pt"])
@pytest.mark.parametrize("names", [("6305_life",), ("6305_film",), ("6012_pair",),
                                   ("218_combined", "218_hybrid"),
                                   ("nu205_gear",)])  # fmt: skip
@pytest.mark.thirds
def test_every_number_is_one_of_the_json(names: tuple[str, ...], lang: str) -> None:
    report = of(*names)
    with speaking(lang):
        page = report_page(report)
    written = json.loads(report.to_json())
    pairs = numbers_with_paths(page, written)
    assert len(pairs) > 60
    for shown, held in pairs:
        assert held is not None
        assert shown == pytest.approx(held, rel=1e-12, abs=1e-300)


def test_balls_are_those_of_the_json(gearbox: Report) -> None:
    balls = json.loads(gearbox.to_json())["cases"][0]["analysis"]["balls"]
    table = next(table for table in report_page(gearbox).tables() if table.key == "balls_A")
    columns = {column.key: column.values for column in table.columns}
    for race in ("inner", "outer"):
        for ball, own in enumerate(balls):
            shown = columns[f"{race}_load"][ball]
            if own[race]["load"] > 0.0 and isfinite(shown):
                assert shown == own[race]["load"]


def test_inputs_are_those_of_the_json(gearbox: Report) -> None:
    inputs = {one["field"]: one for one in json.loads(gearbox.to_json())["cases"][0]["inputs"]}
    table = next(table for table in report_page(gearbox).tables() if table.key == "inputs")
    columns = {column.key: column.values for column in table.columns}
    assert list(columns["field"]) == sorted(inputs, key=list(columns["field"]).index)
    for field, cell in zip(columns["field"], columns["A"], strict=True):
        if isinstance(cell, Number):
            assert cell.value == inputs[str(field)]["value"]


def printed(table: Table, lang: str) -> list[str]:
    """Every number of a table as a page prints it."""
    with speaking(lang):
        return [
            manner().number(cell.value, cell.form)
            for column in table.columns
            if not column.only_in_files
            for cell in column.values
            if isinstance(cell, Number) and isfinite(cell.value)
        ]


def spaceless(text: str) -> str:
    return re.sub(r"\s|&nbsp;|\u202f|\u2009|\u2007", "", text)


@pytest.mark.parametrize("lang", ["en", "pt"])
def test_the_terminal_shows_every_number(gearbox: Report, lang: str) -> None:
    with speaking(lang):
        page = report_page(gearbox)
    text = spaceless(terminal(page))
    for table in page.tables():
        for number in printed(table, lang):
            assert spaceless(number) in text


# --- the head, the checksum ---------------------------------------------------------------------


def test_options_go_over_the_table_of_the_case() -> None:
    case = load_case(example("218_combined")).replace(
        report=ReportHead(project="Spindle", author="A. Souza", date="2026-01-02")
    )
    head = calculation_report([case], {"author": "M. Okafor"}).head
    assert (head.project, head.author, head.date) == ("Spindle", "M. Okafor", "2026-01-02")


def test_the_date_is_that_of_the_day_by_default() -> None:
    assert re.fullmatch(
        r"\d{4}-\d{2}-\d{2}", calculation_report([example("218_combined")]).head.date
    )


def test_title_block_and_units_do_not_change_the_checksum() -> None:
    case = load_case(example("218_combined"))
    same = case.replace(report={"project": "P"}, title="other")
    assert checksum_of(case) == checksum_of(same)
    assert checksum_of(override(case, ["duty.load.fx=20000 N"])) == checksum_of(case)
    assert checksum_of(override(case, ["duty.outer_speed=0 rpm"])) == checksum_of(case)
    assert checksum_of(override(case, ["duty.load.fx=20001 N"])) != checksum_of(case)


def test_the_title_block_does_not_change_the_result() -> None:
    case = load_case(example("218_combined"))
    plain, signed = (
        calculation_report([one]).cases[0].numbers["analysis"]
        for one in (case, case.replace(report={"project": "P"}))
    )
    assert {**plain} == {**signed}


# --- inputs -------------------------------------------------------------------------------------


def test_origins_of_inputs() -> None:
    report = calculation_report([example("6305_life")], changes=["duty.inner_speed=3000 rpm"])
    origins = {one.field: one.origin for one in report.cases[0].inputs}
    assert origins["bearing.designation"] == "given"
    assert origins["bearing.ball_count"] == "inferred"
    assert origins["bearing.inner_conformity"] == "assumed"
    assert origins["mounting.bore"] == "published"
    assert origins["duty.inner_speed"] == "set"
    assert origins["duty.load.fz"] == "given"
    assert origins["duty.outer_speed"] == "default"
    assert origins["lubricant"] == "given"
    assert origins["lubricant.viscosity_40"] == "data"


def test_what_the_letters_of_a_designation_tell_has_its_origin() -> None:
    report = calculation_report(
        ["7014CTYNDBLP4"], changes=["duty.load.fz=2 kN", "duty.inner_speed=2000 rpm"]
    )
    origins = {one.field: one.origin for one in report.cases[0].inputs}
    assert origins["bearing.arrangement"] == "designation"
    assert origins["bearing.preload.level"] == "designation"
    assert "designation" in "".join(terminal(report_page(report)))


def test_constants_of_a_material_come_from_where_it_does() -> None:
    set_by_hand = ["bearing.ball_material=Si3N4", "duty.load.fz=2 kN", "duty.inner_speed=2000 rpm"]
    for case, settings in (("7014C", set_by_hand), ("HCB7014-C-T-P4S", set_by_hand[1:])):
        found = {
            one.field: one for one in calculation_report([case], changes=settings).cases[0].inputs
        }
        modulus = found["bearing.ball_material.youngs_modulus"]
        assert (modulus.origin, bool(modulus.source)) == ("data", True), case


def test_a_designation_is_enough() -> None:
    report = calculation_report(
        ["6305"], changes=["duty.load.fz=2 kN", "duty.inner_speed=2000 rpm"]
    )
    origins = {one.field: one.origin for one in report.cases[0].inputs}
    assert origins["bearing.designation"] == "given"
    assert origins["duty.load.fz"] == "set"
    assert report.converged


def test_inputs_that_differ_stand_first(spindle: Report) -> None:
    page = report_page(spindle)
    differing, common = (
        next(table for table in page.tables() if table.key == key)
        for key in ("inputs_that_differ", "inputs_in_common")
    )
    fields = {
        table.key: next(c for c in table.columns if c.key == "field").values
        for table in (differing, common)
    }
    assert set(fields["inputs_that_differ"]) == {
        "bearing.ball_material",
        "bearing.ball_material.youngs_modulus",
        "bearing.ball_material.poisson_ratio",
        "bearing.ball_material.density",
    }
    assert "duty.load.fx" in fields["inputs_in_common"]


# --- cases without a solution, limits ------------------------------------------------------------


def test_a_case_without_a_solution_has_reason_and_advice_and_no_number() -> None:
    report = calculation_report([example("218_combined")], changes=[OVERLOADED, "duty.load.fx=1 N"])
    assert not report.converged
    page = report_page(report)
    text = terminal(page)
    assert "No solution" in text
    assert not [table for table in page.tables() if not table.key.startswith("inputs")]


def test_a_case_without_a_solution_stands_beside_others() -> None:
    case = load_case(example("218_combined"))
    report = calculation_report([case, override(case, [OVERLOADED])])
    summary = next(table for table in report_page(report).tables() if table.key == "summary")
    columns = {column.key: column.values for column in summary.columns}
    numbers = [cell for cell in columns["B"] if isinstance(cell, Number)]
    assert not any(isfinite(cell.value) for cell in numbers)
    assert any(isinstance(cell, Number) and isfinite(cell.value) for cell in columns["A"])


def test_the_number_of_cases_is_bounded() -> None:
    with pytest.raises(InputError, match="must be 1 to 20"):
        calculation_report([example("218_combined")] * (MOST_CASES + 1))


def test_progress_is_told() -> None:
    told: list[tuple[int, int]] = []
    calculation_report(
        [example("218_combined")] * 2, progress=lambda done, all_: told.append((done, all_))
    )
    assert told == [(0, 2), (1, 2), (2, 2)]


# --- equations ----------------------------------------------------------------------------------


def test_every_law_can_be_set_and_has_its_symbols_and_sources() -> None:
    from matplotlib.mathtext import MathTextParser

    parser = MathTextParser("path")
    for law in EQUATIONS:
        parser.parse(f"${law.latex}$")
        assert law.plain
        assert law.source
        assert set(law.symbols) <= SYMBOLS.keys()
        assert set(law.references) <= REFERENCES.keys()
        assert {condition.split()[0] for condition in law.used} <= CONDITIONS.keys()


def test_only_what_was_used_is_shown(gearbox: Report) -> None:
    of_gearbox = {one.name for one in equations_of(gearbox.cases)}
    assert "Central film thickness (Hamrock–Dowson)" in of_gearbox
    assert "Contamination factor" in of_gearbox
    assert "Coefficient of friction by the regime of lubrication" in of_gearbox
    of_spindle = {one.name for one in equations_of(of("218_combined").cases)}
    assert "Central film thickness (Hamrock–Dowson)" not in of_spindle
    assert "Elastic hysteresis" not in of_spindle  # no lubricant
    assert "Basic dynamic load rating" in of_spindle


@pytest.mark.parametrize("ending", [".txt", ".html"])
def test_the_theory_that_leads_is_marked_in_every_medium(gearbox: Report, ending: str) -> None:
    shown = report_page(gearbox)
    text = terminal(shown) if ending == ".txt" else html(shown)
    assert "in bold" not in text
    assert text.count("▸") == 2  # at the theory, and in the legend


def test_symbols_stand_where_they_first_occur(gearbox: Report) -> None:
    equations = equations_of(gearbox.cases)
    symbols = [symbol.symbol for one in equations for symbol in one.symbols]
    assert len(symbols) == len(set(symbols))
    assert [one.number for one in equations] == list(range(1, len(equations) + 1))
    assert any("Harris" in text for text in references_of(gearbox.cases))


# --- the command --------------------------------------------------------------------------------


def test_a_wrong_ending_is_refused(tmp_path: Path) -> None:
    run = CliRunner().invoke(app, ["report", example("218_combined"), "-o", "report.docx"])
    assert run.exit_code == 2
    assert "report.docx" in run.output
    assert ".html, .pdf, .md" in run.output


def test_an_input_is_never_written_over(tmp_path: Path) -> None:
    case = tmp_path / "case.md"
    case.write_text(Path(example("218_combined")).read_text(), encoding="utf-8")
    before = case.read_bytes()
    run = CliRunner().invoke(app, ["report", example("218_combined"), str(case), "-o", str(case)])
    assert run.exit_code == 2
    assert case.read_bytes() == before


def test_an_empty_title_block_is_none() -> None:
    """As a script writes it whose variable is empty; an empty case is still missing."""
    run = CliRunner().invoke(app, ["report", example("218_combined"), "--author", "", "--date", ""])
    assert run.exit_code == 0, run.output
    run = CliRunner().invoke(app, ["report", ""])
    assert run.exit_code == 2
    assert "is missing" in run.output


def test_json_of_the_command() -> None:
    run = CliRunner().invoke(app, ["report", example("218_combined"), "--json"])
    assert run.exit_code == 0
    found = json.loads(run.output)
    assert found["kind"] == "report"
    assert found["cases"][0]["analysis"]["status"]["converged"]


def test_units_of_the_page_are_known(gearbox: Report) -> None:
    for one in gearbox.cases[0].inputs:
        in_unit(1.0, one.unit)


# --- HTML and PDF -------------------------------------------------------------------------------


class _Rows(HTMLParser):
    """The rows of all tables, as the texts of their cells."""

    def __init__(self) -> None:
        super().__init__()
        self.rows: list[list[str]] = []
        self._in_cell = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag == "tr":
            self.rows.append([])
        elif tag in ("td", "th") and self.rows:
            self.rows[-1].append("")
            self._in_cell = True

    def handle_endtag(self, tag: str) -> None:
        if tag in ("td", "th"):
            self._in_cell = False

    def handle_data(self, data: str) -> None:
        if self._in_cell:
            self.rows[-1][-1] += spaceless(data)


def rows_of(page: Document, lang: str) -> list[list[str]]:
    """Every row of the tables that name their rows: label, unit and numbers, as printed."""
    found = []
    for table in page.tables():
        keys = [column.key for column in table.columns]
        if "path" not in keys:
            continue
        for row in range(len(table.columns[0].values)):
            cells = []
            for column in table.columns:
                if column.only_in_files:
                    continue
                value = column.values[row]
                if isinstance(value, float):
                    value = Number(value, column.form)
                if isinstance(value, Number):
                    with speaking(lang):
                        value = manner().number(value.value, value.form)
                if isinstance(value, str) and value:
                    cells.append(spaceless(value).replace("_", ""))
            found.append(cells)
    return found


@pytest.mark.parametrize(
    ("names", "lang"),
    [
        (("6305_life",), "en"),
        (("218_combined", "218_hybrid"), "pt"),
        pytest.param(("6012_pair",), "pt", marks=pytest.mark.sweep),
        pytest.param(("6305_film", "ricci_fleury"), "en", marks=pytest.mark.sweep),
    ],
)
def test_html_shows_the_numbers_of_the_json(names: tuple[str, ...], lang: str) -> None:
    with speaking(lang):
        page = report_page(of(*names))
    parser = _Rows()
    parser.feed(html(page))
    shown = {tuple(cell.replace("_", "") for cell in row if cell) for row in parser.rows}
    for cells in rows_of(page, lang):
        assert tuple(cells) in shown


@pytest.mark.parametrize(
    ("names", "lang"),
    [
        (("6305_life",), "en"),
        (("218_combined", "218_hybrid"), "pt"),
        pytest.param(("6012_pair",), "pt", marks=pytest.mark.sweep),
        pytest.param(("6305_film", "ricci_fleury"), "en", marks=pytest.mark.sweep),
    ],
)
@pytest.mark.thirds
def test_pdf_shows_the_numbers_of_the_json(names: tuple[str, ...], lang: str) -> None:
    pypdf = pytest.importorskip("pypdf")
    with speaking(lang):
        page = report_page(of(*names))
    reader = pypdf.PdfReader(BytesIO(pdf(page)))
    text = "".join(spaceless(sheet.extract_text()) for sheet in reader.pages).replace("_", "")
    for cells in rows_of(page, lang):
        assert "".join(cells) in text


def test_hostile_texts_are_escaped(spindle: Report) -> None:
    hostile = '<script>alert(1)</script>&"#set text(red)$x$'
    case = spindle.cases[0]
    titled = replace(case, case=case.case.replace(title=hostile))
    report = replace(spindle, head=ReportHead(author=hostile, date="x"), cases=(titled,))
    page = report_page(report)
    assert "<script>alert" not in html(page)
    assert pdf(page).startswith(b"%PDF")
    assert "alert(1)" in terminal(page)


@pytest.mark.parametrize("ending", [".html", ".pdf", ".md", ".txt"])
def test_the_command_writes_every_format(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"report{ending}"
    run = CliRunner().invoke(
        app, ["report", example("218_combined"), "-o", str(path), "--author", "A. Souza"]
    )
    assert run.exit_code == 0, run.output
    assert path.stat().st_size > 1000


def test_one_name_in_the_place_of_several_is_one_case() -> None:
    assert ReportRequest(case="6305").case == ("6305",)
    assert ReportRequest(case=EXAMPLE).case == (EXAMPLE,)
    assert ReportRequest(case=["6305", "6306"]).case == ["6305", "6306"]
