"""Documents as HTML, PDF, Markdown, CSV and workbooks: all that is said, nothing that acts."""

from __future__ import annotations

import csv
import io
import json
import math
import re
import xml.etree.ElementTree as ElementTree
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pypdf import PdfReader

import rolamento
from rolamento.charts import Axis, Chart, Field, Line, Look
from rolamento.charts.drawing import draw
from rolamento.document import (
    Bar,
    Bars,
    Beside,
    Break,
    Column,
    Document,
    Entry,
    Equation,
    Figure,
    KeyValues,
    Link,
    Links,
    Medium,
    Notes,
    Number,
    Remark,
    Section,
    Statement,
    Symbol,
    Table,
    Title,
)
from rolamento.document.cells import cells, indexed
from rolamento.document.html import fragment, html
from rolamento.document.markdown import markdown
from rolamento.document.pdf import pdf
from rolamento.document.picture import formula
from rolamento.document.tables import SI_UNITS, table_of, to_csv, to_xlsx
from rolamento.document.terminal import terminal
from rolamento.document.writing import write
from rolamento.words import UNITS, speaking

HOSTILE = (
    """<script>alert(1)</script> "q" 'a' $x$ #let *b* _c_ [x](y) `t` =1 \x1b[31m <!-- \\ -->"""
)
EXAMPLE = Path(rolamento.__file__).parent / "examples" / "218_combined.toml"


def picture() -> Any:
    from rolamento.charts.style import new_figure

    figure, axes = new_figure()
    axes.plot([0.0, 1.0], [0.0, 1.0], label="line")
    axes.set_title(HOSTILE, parse_math=False)
    return figure


def balls(rows: int = 60) -> Table:
    loads = [4000.0 * max(math.cos(math.radians(6.0 * i)), 0.0) or math.nan for i in range(rows)]
    return Table(
        columns=(
            Column(head="#", values=list(range(rows)), key="ball", tone="faint"),
            Column(
                head="ψ",
                values=[math.radians(6.0 * i) for i in range(rows)],
                unit="°",
                key="azimuth",
                figures=5,
            ),
            Column(
                head="Q_i",
                values=loads,
                unit="N",
                key="inner_load",
                peak="maximum",
                figures=5,
            ),
            Column(head="Q_i", values=loads, bar=True),
            Column(
                head="δ_i",
                values=[1e-6 * i for i in range(rows)],
                unit="µm",
                key="inner_deflection",
            ),
            Column(
                head="row", values=[i // 30 for i in range(rows)], key="row", only_in_files=True
            ),
        ),
        key="balls",
        legends=("Q load; ◂ maximum",),
        groups=((0, "row 0"), (30, "row 1")),
        breaks=(Break(4, "Deflections", "δ deflection"),),
        fixed=2,
    )


def mixed() -> Table:
    return Table(
        columns=(
            Column(head="", values=("x", "ry"), key="direction"),
            Column(
                head="",
                values=(Number(1.5e-6, ".3f [µm]"), Number(2e-3, ".3f [mrad]")),
                key="displacement",
            ),
            Column(head="", values=("µm", "mrad"), key="displacement_unit"),
        ),
        key="ring",
        headless=True,
    )


def document(language: str = "en", hostile: str = HOSTILE) -> Document:
    with speaking(language):
        return Document(
            title=f"Every block {hostile}",
            kind="solve",
            main="balls",
            program="Rolamento 9.8",
            date="2031-02-03",
            sections=(
                Section(
                    "",
                    (
                        Title(f"Every block {hostile}"),
                        Statement("92.5 h is said\nin two lines", "warning", mark="!"),
                        Statement("κ = 1.2 and a_ISO = 3.4; µ λ ◂ ✓ ✗ 10⁶ → ≤ ≥ ∞ ±", indent=2),
                        Statement("solve case.toml --set x='1'", verbatim=True),
                        KeyValues((Entry("speed", Number(1000.0, ".5 rpm")), Entry("of", hostile))),
                    ),
                ),
                Beside(
                    (Section("Ring", (mixed(),), key="ring"),),
                    (Section("Picture", (Figure(caption=hostile, draw=picture, key="p"),)),),
                ),
                Section("Balls", (balls(),), key="balls"),
                Section(
                    "Shares",
                    (
                        Bars(
                            bars=(Bar("inner", Number(0.617, ".3 %"), 1.0), Bar("outer", None, 0))
                        ),
                        Figure(caption="sketched", sketch=lambda width, draws: [[("⣀<", "mark")]]),
                    ),
                ),
                Section(
                    "Equations",
                    (
                        Equation(
                            name="Life",
                            latex=r"L_{10} = \left(\frac{C}{P}\right)^{p}",
                            plain="L_10 = (C/P)^p",
                            symbols=(Symbol("C", "load rating", "N"),),
                            source="ISO 281:2007",
                            number=7,
                        ),
                        Equation(name="Broken", latex=r"\frac{", plain="a = b"),
                    ),
                ),
                Section("Notes", (Notes((Remark("a note", "key"), Remark(hostile))),)),
                Section(
                    hostile,
                    (
                        Links(
                            (
                                Link("data", "data.csv"),
                                Link("evil", "javascript:alert(1)"),
                                Link("site", "https://example.org/?a=1&b='2'"),
                            )
                        ),
                    ),
                ),
                Section("Last", (Statement("the end"),)),
            ),
        )


def numbers_shown(one: Document) -> set[str]:
    """Return every number that stands in a cell that a reader sees."""
    with speaking(one.language):
        return {
            text.strip().replace(" ", "")
            for block in one.blocks()
            if isinstance(block, Table)
            for column in block.columns
            if not column.bar and not column.only_in_files
            for text in cells(column)
            if any(character.isdigit() for character in text)
        }


class Page(HTMLParser):
    """What a browser would make of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.text = ""
        self._silent = 0
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        self._silent += tag == "style"

    def handle_endtag(self, tag: str) -> None:
        self._silent -= tag == "style"
        self.text += "\n" if tag in ("td", "th", "p", "dd", "li") else ""

    def handle_data(self, data: str) -> None:
        self.text += "" if self._silent else data

    def all(self, tag: str) -> list[dict[str, str | None]]:
        return [attributes for name, attributes in self.tags if name == tag]


# --- HTML ---------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def page() -> Page:
    return Page(html(document()))


def test_html_has_no_script_and_asks_for_nothing(page: Page) -> None:
    assert not {"script", "link", "iframe", "object", "embed", "base"} & {t for t, _ in page.tags}
    assert not page.all("img")
    for _, attributes in page.tags:
        assert not [name for name in attributes if name.startswith("on") or name == "srcset"]
    targets = [attributes["href"] for attributes in page.all("a")]
    assert [one for one in targets if not str(one).startswith("#")] == [
        "data.csv",
        "https://example.org/?a=1&b='2'",
    ]
    assert any("default-src 'none'" in str(one.get("content")) for one in page.all("meta"))


def test_html_shows_hostile_texts_as_they_are(page: Page) -> None:
    shown = HOSTILE.replace("\x1b", "\\x1b")
    assert page.text.count(shown) >= 5
    assert "\x1b" not in page.text


def test_html_is_well_formed_and_its_identifiers_are_unique() -> None:
    text = html(document())
    body = text[text.index("<main>") : text.index("</main>") + len("</main>")]
    body = re.sub(r"<(br|img)([^>]*)>", r"<\1\2/>", body).replace(
        "<main>", '<main xmlns:xlink="http://www.w3.org/1999/xlink">'
    )
    ElementTree.fromstring(body)
    identifiers = re.findall(r'\bid="([^"]*)"', text)
    assert len(set(identifiers)) == len(identifiers)
    for target in re.findall(r'href="#([^"]*)"', text) + re.findall(r"url\(#([^)]*)\)", text):
        assert target in identifiers


def test_html_is_semantic(page: Page) -> None:
    assert page.all("html")[0]["lang"] == "en"
    assert [tag for tag, _ in page.tags].count("h1") == 1
    scopes = {attributes.get("scope") for attributes in page.all("th")}
    assert scopes == {"row", "col", "rowgroup"}
    assert {a.get("role") for a in page.all("svg")} == {"img"}
    assert all(attributes.get("aria-label") for attributes in page.all("svg"))
    assert page.all("nav")
    assert len(page.all("figure")) == len(page.all("figcaption")) == 2
    assert Page(html(document("pt"))).all("html")[0]["lang"] == "pt-BR"


def test_html_is_the_same_every_time() -> None:
    assert html(document()) == html(document())


def test_a_map_of_colours_and_its_bar_are_left_as_they_are_in_the_dark() -> None:
    """The names that the style speaks of are those that the picture has in the page."""
    cells_ = Field(np.arange(3.0), np.arange(3.0), np.arange(4.0).reshape(2, 2), Axis("Load", "N"))
    white = Line(np.arange(2.0), np.arange(2.0), "", Look("white"))
    shown = Figure("A map", lambda: draw(Chart((cells_, white), Axis("x"), Axis("y"))))
    page = html(Document("", (Section("", (shown,)),)))
    (rule,) = re.findall(r"figure svg :is\(image, (.*?)\) \{ filter", page)
    kinds = re.findall(r'\[id([*^]?)="([^"]+)"\]', rule)
    named = re.findall(r'<g id="([^"]*)"', page)
    kept = [
        name
        for name in named
        if any(name.startswith(part) if how == "^" else part in name for how, part in kinds)
    ]
    assert len(kept) == 2, named  # the bar of colours, and what is white on them
    assert "<image" in page  # the cells


def test_html_names_pictures_beside_it() -> None:
    text = html(document(), picture=lambda figure: f"{figure.key or 'sketch'}.svg")
    assert [one["src"] for one in Page(text).all("img")] == ["p.svg", "sketch.svg"]


def test_a_notebook_gets_a_piece_of_html_without_identifiers() -> None:
    text = document()._repr_html_()
    assert text == fragment(document())
    assert text.startswith('<div class="rolamento notebook" lang="en">')
    assert not Page(text).all("section")[0].get("id")
    assert document()._repr_markdown_() == markdown(document())


# --- every medium has the numbers -----------------------------------------------------------------


@pytest.mark.parametrize("language", ["en", "pt"])
def test_every_medium_has_every_number(language: str) -> None:
    one = document(language)
    expected = numbers_shown(one)
    assert len(expected) > 100
    reader = PdfReader(io.BytesIO(pdf(one)))
    texts = {
        "terminal": terminal(one, Medium(width=80)),
        "html": Page(html(one)).text,
        "pdf": "\n".join(sheet.extract_text() for sheet in reader.pages),
        "markdown": markdown(one),
    }
    for medium, text in texts.items():
        group = " " if medium == "terminal" else "\u00a0"
        squeezed = re.sub(rf"(?<=\d){group}(?=\d{{3}})", "", text)
        found = set(re.findall(r"−?\d+(?:[.,]\d+)?", squeezed))
        assert expected <= found, medium
        for other in (
            "92.5 h",
            "a note",
            "load rating",
            "ISO 281",
            "the end",
            "61,7" if language == "pt" else "61.7",
        ):
            assert other in re.sub(r"\s+", " ", text), medium


def test_pages_of_cases_in_html_pdf_and_csv_have_the_numbers_of_the_json() -> None:
    from rolamento.pages.state import state_page

    solved = rolamento.solve(rolamento.load_case(str(EXAMPLE)))
    state = json.loads(solved.to_json())
    rows = list(csv.DictReader(io.StringIO(to_csv(state_page(solved), si=True))))
    assert len(rows) == len(state["balls"])
    for row, ball in zip(rows, state["balls"], strict=True):
        assert float(row["azimuth_rad"]) == ball["azimuth"]
        assert float(row["inner_load_N"]) == ball["inner"]["load"]
        assert float(row["outer_max_pressure_Pa"]) == ball["outer"]["max_pressure"]
        assert float(row["gyroscopic_moment_Nm"]) == ball["gyroscopic_moment"]


# --- PDF ----------------------------------------------------------------------------------------


def test_pdf_is_the_same_every_time_and_names_its_document() -> None:
    first, again = pdf(document()), pdf(document())
    assert first == again
    reader = PdfReader(io.BytesIO(first))
    assert reader.metadata is not None
    assert reader.metadata.creation_date is None
    assert str(reader.metadata.title).startswith("Every block <script>")
    texts = [sheet.extract_text() for sheet in reader.pages]
    assert len(texts) > 2
    assert all("Rolamento 9.8" in text and "2031-02-03" in text for text in texts)
    assert f"2 of {len(texts)}" in texts[1]
    # a table over several pages has its heads on each
    assert sum("rpm" not in text and text.count("Deflections") for text in texts) <= 1
    shown = "".join(texts)
    assert all(sign in shown for sign in "κµλ◂✓✗⁶≤≥∞±")
    assert "#let" in shown
    assert "\\x1b[31m" in shown


def test_a_page_without_anything_is_a_page_all_the_same() -> None:
    empty = Document("", ())
    assert PdfReader(io.BytesIO(pdf(empty))).pages
    assert "<main>" in html(empty)
    assert markdown(empty) == "\n"


def test_formulas_are_set_or_left() -> None:
    fraction = formula(r"\frac{a}{b}")
    assert fraction is not None
    assert fraction.height > 0.5 < fraction.height + fraction.depth
    assert formula(r"\frac{") is None
    assert formula(r"\unknown") is None


# --- Markdown -----------------------------------------------------------------------------------


def test_markdown_escapes_what_acts() -> None:
    text = markdown(document())
    assert "<script>" not in text
    assert "\\<script\\>" in text
    assert "\\[x\\]" in text
    assert "[evil]" not in text
    assert "[data](data.csv)" in text
    assert "$$L_{10} = " in text
    assert "\\tag{7}" in text
    rows = [line for line in text.splitlines() if line.startswith("| 59 ")]
    assert len(rows) == 1
    assert "![" not in text


# --- files --------------------------------------------------------------------------------------


def test_documents_are_written_by_the_endings_of_their_names(tmp_path: Path) -> None:
    for ending, begin in (
        (".html", b"<!DOCTYPE"),
        (".PDF", b"%PDF"),
        (".md", b"#"),
        (".txt", b"Ev"),
    ):
        path = tmp_path / f"report{ending}"
        write(document(), path)
        assert path.read_bytes().startswith(begin)
    assert [one.name for one in tmp_path.glob("*.svg")] == ["report-1-p.svg"]
    assert "](report-1-p.svg)" in (tmp_path / "report.md").read_text("utf-8")
    with pytest.raises(rolamento.InputError, match=r"must end in one of \.html, \.pdf"):
        write(document(), tmp_path / "report.docx")
    assert not (tmp_path / "report.docx").exists()


# --- CSV ----------------------------------------------------------------------------------------


def rows_of(text: str, **options: Any) -> list[list[str]]:
    return list(csv.reader(io.StringIO(text, newline=""), strict=True, **options))


def test_csv_is_the_main_table_in_readable_units() -> None:
    header, *rows = rows_of(to_csv(document()))
    assert header == ["ball", "azimuth_deg", "inner_load_N", "inner_deflection_um", "row"]
    assert len(rows) == 60
    assert rows[5][:2] == ["5", "30"]
    assert rows[20][2] == ""
    assert float(rows[7][3]) == 7.0
    assert to_csv(document()).endswith("\r\n")
    assert to_csv(document("pt")) == to_csv(document())


def test_csv_in_si_has_the_numbers_to_the_last_bit() -> None:
    header, *rows = rows_of(to_csv(document(), si=True))
    assert header == ["ball", "azimuth_rad", "inner_load_N", "inner_deflection_m", "row"]
    assert [float(row[1]) for row in rows] == [math.radians(6.0 * i) for i in range(60)]
    assert rows_of(to_csv(document(), "ring", si=True))[1:] == [
        ["x", "1.5e-06", "m"],
        ["ry", "0.002", "rad"],
    ]
    assert rows_of(to_csv(document(), "ring"))[1:] == [["x", "1.5", "µm"], ["ry", "2", "mrad"]]


def test_csv_has_the_marks_that_are_asked_for() -> None:
    text = to_csv(document(), separator=";", decimal=",")
    assert rows_of(text, delimiter=";")[2][:2] == ["1", "6"]
    assert "," in rows_of(text, delimiter=";")[2][2]
    with pytest.raises(rolamento.InputError, match="must differ"):
        to_csv(document(), decimal=",")
    with pytest.raises(rolamento.InputError, match="must be one of ring, balls"):
        to_csv(document(), "ball")
    with pytest.raises(rolamento.InputError, match="no table"):
        to_csv(Document("", ()))


def test_the_main_table_is_the_first_where_none_is_named() -> None:
    assert table_of(Document("", (Section("", (mixed(), balls())),))).key == "ring"


@given(
    st.lists(
        st.tuples(
            st.floats(allow_nan=False, allow_infinity=False),
            st.text(
                st.characters(codec="utf-8", exclude_categories=("Cc", "Cf", "Zl", "Zp", "Cs"))
            ),
        ),
        max_size=20,
    ),
    st.sampled_from([",", ";", "\t", "|"]),
)
def test_csv_round_trip(rows: list[tuple[float, str]], separator: str) -> None:
    columns = (
        Column(head="n", values=[number for number, _ in rows], unit="N", key="n"),
        Column(head="t", values=[text for _, text in rows], key="t"),
    )
    one = Document("", (Section("", (Table(columns=columns, key="t"),)),))
    _, *read = rows_of(to_csv(one, separator=separator), delimiter=separator)
    assert [float(row[0]) for row in read] == [number for number, _ in rows]
    for row, (_, text) in zip(read, rows, strict=True):
        assert row[1] in (text.strip(), f"'{text.strip()}")


@pytest.mark.parametrize("text", ["=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "\t=1"])
def test_no_text_becomes_a_formula(text: str) -> None:
    columns = (Column(head=text, values=(text, "−0.5", "-5", "+"), key="t"),)
    one = Document(text, (Section("", (Table(columns=columns, key="=t"),)),))
    _, *rows = rows_of(to_csv(one))
    assert rows[0][0][0] == "'"
    assert [row[0] for row in rows[1:]] == ["−0.5", "-5", "+"]
    sheet = openpyxl.load_workbook(io.BytesIO(to_xlsx(one))).worksheets[0]
    assert sheet["A2"].data_type == "s"
    assert sheet["A2"].quotePrefix
    assert sheet["A2"].value == text.strip()


def test_every_unit_has_one_of_si() -> None:
    for unit, (factor, offset) in UNITS.items():
        if (factor, offset) != (1.0, 0.0):
            assert unit in SI_UNITS, unit
        elif unit not in ("", "–"):
            assert SI_UNITS.get(unit, unit) == unit


# --- workbooks ----------------------------------------------------------------------------------


def test_a_workbook_has_a_sheet_for_every_table_with_numbers_as_numbers() -> None:
    book = openpyxl.load_workbook(io.BytesIO(to_xlsx(document())))
    assert book.sheetnames == ["ring", "balls"]
    sheet = book["balls"]
    assert [cell.value for cell in sheet[1]] == [
        "ball",
        "azimuth [°]",
        "inner_load [N]",
        "inner_deflection [µm]",
        "row",
    ]
    assert sheet["A1"].font.bold
    assert sheet.freeze_panes == "A2"
    assert sheet["B7"].value == 30
    assert sheet["C2"].value == 4000
    assert sheet["C22"].value is None
    assert sheet.max_row == 61


def test_a_workbook_is_the_same_every_time_whatever_its_tables_are_called() -> None:
    names = ["a" * 60, "a" * 60, "x/y:[z]*?", "''", "History"]
    tables = tuple(
        Table(columns=(Column(head="h\x07", values=("\x00\ud800", 1.0)),), key=name)
        for name in names
    )
    one = Document("\x00t", (Section("", tables),))
    assert to_xlsx(one) == to_xlsx(one)
    book = openpyxl.load_workbook(io.BytesIO(to_xlsx(one)))
    assert all(0 < len(name) <= 31 for name in book.sheetnames)
    assert len({name.lower() for name in book.sheetnames}) == len(names)


# --- symbols ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "pieces"),
    [
        ("a_ISO", [("a", "ISO"), ("", "")]),
        ("times (E'_steel/E')²", [("times (E'", "steel"), ("/E')²", "")]),
        ("vezes E'_aço/E' (Hertz)", [("vezes E'", "aço"), ("/E' (Hertz)", "")]),
        ("Q_i, α_o", [("Q", "i"), (", α", "o"), ("", "")]),
        ("stiffness_zz a_b.csv x_1_2 C:\\d_e", None),
        ("12 300 h", [("12\u00a0300\u00a0h", "")]),
        ("95 % of 3.2 N·mm", [("95\u00a0% of 3.2\u00a0N·mm", "")]),
        ("9 balls, 5 metres", None),
    ],
)
def test_letters_have_their_indices(text: str, pieces: list[tuple[str, str]] | None) -> None:
    assert list(indexed(text)) == (pieces or [(text, "")])


class _Stream(io.StringIO):
    """A stream that may be a terminal."""

    def __init__(self, is_terminal: bool) -> None:
        super().__init__()
        self._is_terminal = is_terminal

    def isatty(self) -> bool:
        return self._is_terminal


@pytest.mark.parametrize(
    ("variables", "at_terminal", "in_pipe"),
    [
        ({}, True, False),
        ({"TERM": "dumb"}, False, False),
        ({"NO_COLOR": "1"}, False, False),
        ({"NO_COLOR": ""}, True, False),
        ({"FORCE_COLOR": "1"}, True, True),
        ({"FORCE_COLOR": ""}, False, False),
        ({"FORCE_COLOR": "1", "NO_COLOR": "1"}, False, False),
    ],
)
def test_colours_where_the_environment_and_the_stream_have_them(
    monkeypatch: pytest.MonkeyPatch,
    variables: dict[str, str],
    at_terminal: bool,
    in_pipe: bool,
) -> None:
    for name in ("NO_COLOR", "FORCE_COLOR", "TERM"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert Medium.of(_Stream(True)).colors is at_terminal
    assert Medium.of(_Stream(False)).colors is in_pipe
    assert Medium.of(None).colors is in_pipe


@pytest.mark.parametrize(
    ("columns", "width"), [("100", 100), ("20", 80), ("500", 120), ("wide", None)]
)
def test_a_page_is_as_wide_as_the_user_says(
    monkeypatch: pytest.MonkeyPatch, columns: str, width: int | None
) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    found = Medium.of(_Stream(True)).width
    assert 80 <= found <= 120 if width is None else found == width


@pytest.mark.parametrize("width", range(80, 100))
def test_a_number_stays_in_one_line_of_a_terminal(width: int) -> None:
    text = "such bearings reach 9 000 000 h, from 2 200 000 to 30 000 000 h, " * 3
    page = Document("t", (Section("", (Statement(text),)),))
    lines = terminal(page, Medium(width=width)).splitlines()
    assert " ".join(" ".join(lines).split()).count("30 000 000 h") == 3
    assert sum(line.count("30 000 000") for line in lines) == 3
    assert sum(line.count("2 200 000") for line in lines) == 3
