"""Pages, pictures and folders of a reproduction, and its command."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Callable
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
import typer
from PIL import Image
from tests.reproduced import beside, both, find, spoken
from typer.testing import CliRunner, Result

from rolamento.cli.reproduce import reproduce
from rolamento.document import Document
from rolamento.document.html import html
from rolamento.document.markdown import markdown
from rolamento.errors import FileError
from rolamento_reproductions import radaelli_2013
from rolamento_reproductions.drawing import drawn, rendered
from rolamento_reproductions.page import index_page, kind_of
from rolamento_reproductions.record import (
    Cell,
    Claim,
    Curves,
    Figure,
    Line,
    Panel,
    Part,
    Positions,
    Section,
    Series,
    Source,
    Table,
    TableColumn,
)
from rolamento_reproductions.text import Text, same
from rolamento_reproductions.writing import computed, figure_csv, file_names, open_folder, write

HOSTILE = same("<script>alert('x')</script> & \"quoted\" |*`[x](y)`")
X = np.linspace(0.0, 10.0, 11)


def small_figure(number: str = "1.1", *, gap: bool = False) -> Figure:
    y = X**2 - 20.0
    status = ["converged"] * X.size
    if gap:
        y = np.where(X == 3.0, np.nan, y)
        status[3] = "no_equilibrium"
    return Figure(
        number=number,
        caption=HOSTILE,
        source=same("nowhere"),
        columns=(
            Series("axial_load", "kN", both("Axial load F_a", "Carga axial F_a"), X),
            Series("shift", "mm", both("Displacement δ_a", "Deslocamento δ_a"), y / 80.0),
            Series("status", "", same("status"), tuple(status)),
        ),
        picture=Curves((Panel("axial_load", same("δ_a"), "mm", (Line("shift", 0),)),)),
        claims=(Claim(HOSTILE, same("1"), holds=False),),
    )


def small_table() -> Table:
    return Table(
        number="1.2",
        caption=HOSTILE,
        source=same("nowhere"),
        columns=(
            TableColumn("name", same("Name"), (HOSTILE, same("b"))),
            TableColumn("value", same("δ_z (mm)"), (Cell("1.25", 1.2512), Cell("-2.5", -2.7))),
        ),
    )


def page_of(language: str, renderer: Callable[..., str], page: Callable[[], Document]) -> str:
    return spoken(language, lambda: renderer(page(), picture=beside))


def small_section(title: Text) -> Section:
    return Section(title, (small_figure(), small_table()))


SMALL = Source(
    name="radaelli-2013",
    title=HOSTILE,
    reference=both("small", "pequeno"),
    remarks=(HOSTILE,),
    parts=(Part(HOSTILE, ("figure-1.01", "table-1.2"), small_section),),
)


def quiet(done: int, total: int, what: Text) -> None:
    """Say nothing."""


def written(folder: Path, **options: object) -> Path:
    target = open_folder(str(folder), SMALL)
    write(SMALL, computed(SMALL, quiet), target, **options)  # type: ignore[arg-type]
    return target


# --- pages ------------------------------------------------------------------


class Reader(HTMLParser):
    """Checks that every element is closed in turn, and gathers what the page points to."""

    VOID = frozenset({"meta", "img", "br", "link"})

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[str] = []
        self.targets: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.targets += [value or "" for name, value in attrs if name in ("src", "href")]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.mark.parametrize("language", ["en", "pt"])
def test_page_is_whole_and_needs_nothing_from_outside(language: str) -> None:
    assert language in ("en", "pt")
    page = page_of(
        language, html, lambda: index_page(SMALL, [small_section(HOSTILE)], ("svg", "png"))
    )
    reader = Reader()
    reader.feed(page)
    assert reader.open == []
    assert "script" not in reader.tags
    assert "link" not in reader.tags
    names = set(file_names(SMALL))
    inside = [target for target in reader.targets if not target.startswith("#")]
    assert set(inside) <= names
    assert {"figure-1.01.svg", "figure-1.01.png", "figure-1.01.csv"} <= set(inside)
    assert "@import" not in page
    assert "url(" not in page


def test_page_escapes_what_it_is_told() -> None:
    page = page_of("en", html, lambda: index_page(SMALL, [small_section(HOSTILE)], ("svg",)))
    assert "<script" not in page
    assert "&lt;script&gt;" in page
    assert 'alt="&lt;script&gt;alert(&#x27;x&#x27;)' in page


def test_markdown_escapes_what_it_is_told() -> None:
    page = page_of("en", markdown, lambda: index_page(SMALL, [small_section(HOSTILE)], ("svg",)))
    assert r"\<script" in page
    assert "<script" not in page.replace(r"\<", "")
    assert r"\|\*\`\[x\](y)\`" in page


def test_pages_show_what_differs_and_what_is_missing() -> None:
    section = Section(same("t"), (small_figure(gap=True), small_table()))
    page = page_of("en", html, lambda: index_page(SMALL, [section], ("svg",)))
    assert "−2.700: differs." in page
    assert "Of 2 printed numbers, 1 are" in page
    assert "Gaps: 1 of 11 points have no result: there is no equilibrium (1)." in page
    assert "Does not hold." in page
    text = page_of("pt", markdown, lambda: index_page(SMALL, [section], ("svg",)))
    assert "−2,700: difere." in text.replace("\\", "")
    assert "Lacunas: 1 de 11 pontos não têm resultado: não há equilíbrio (1)." in text
    assert "Não se confirma." in text


def test_page_of_the_real_one_is_whole() -> None:
    source = find("radaelli-2013")
    sections = computed(source, quiet)
    reader = Reader()
    reader.feed(page_of("pt", html, lambda: index_page(source, sections, ("svg", "png"))))
    assert reader.open == []
    assert reader.tags.count("img") == 32
    assert reader.tags.count("table") == 4
    inside = {target for target in reader.targets if not target.startswith("#")}
    assert inside == set(file_names(source)) - {"index.html", "index.md", "document.css"}


# --- pictures ---------------------------------------------------------------


@pytest.mark.parametrize("number", ["5.1", "5.2", "5.8", "5.11", "5.15", "5.25"])
def test_what_is_drawn_is_what_is_written(number: str) -> None:
    """Every row of the data that belongs to a line is drawn, and nothing else."""
    figure = next(
        item
        for part in find("radaelli-2013").parts
        if f"figure-5.{int(number[2:]):02d}" in part.stems
        for item in part.compute(part.title).items
        if item.number == number
    )
    assert isinstance(figure, Figure)
    assert isinstance(figure.picture, Curves)
    header, *rows = [line.split(",") for line in figure_csv(figure).splitlines()]
    data = {
        column.name: [row[header.index(column.header)] for row in rows] for column in figure.columns
    }
    picture = spoken("en", lambda: drawn(figure))
    for panel, axes in zip(figure.picture.panels, picture.axes, strict=True):
        lines = [line for line in axes.lines if len(np.asarray(line.get_xdata())) > 2]
        for line in panel.lines:
            chosen = [
                (float(x), float(y))
                for place, (x, y) in enumerate(zip(data[panel.x], data[line.y], strict=True))
                if line.by is None or float(data[line.by[0]][place]) == line.by[1]
            ]
            shown = lines.pop(0)
            points = np.column_stack([shown.get_xdata(), shown.get_ydata()]).astype(float)
            if panel.around:
                points = points[(points[:, 0] > -180.0 - 1e-9) & (points[:, 0] <= 180.0 + 1e-9)]
                points = np.unique(points.round(6), axis=0)
                points = points[np.isin(points[:, 0], np.round([x for x, _ in chosen], 6))]
                chosen.sort()
            assert points == pytest.approx(np.array(chosen), rel=1e-6, abs=1e-5)
            if line.marked is not None:
                markers = np.asarray(lines.pop(0).get_xdata(), dtype=float)
                balls = sum(
                    bool(ball) and (line.by is None or float(data[line.by[0]][k]) == line.by[1])
                    for k, ball in enumerate(data[line.marked])
                )
                assert balls <= np.unique(np.mod(markers.round(6), 360.0)).size <= balls
        assert lines == []


def test_gaps_are_not_drawn_over() -> None:
    picture = spoken("en", lambda: drawn(small_figure(gap=True)))
    line = picture.axes[0].lines[0]
    assert np.isnan(np.asarray(line.get_ydata())[3])


def test_a_figure_without_any_result_is_an_empty_frame() -> None:
    figure = small_figure()
    nothing = Series("shift", "mm", same("δ_a"), np.full(X.size, np.nan))
    empty = replace(figure, columns=(figure.columns[0], nothing, figure.columns[2]))
    assert b"<svg" in spoken("en", lambda: rendered(empty, ("svg",)))["svg"]


def test_labels_speak_the_language() -> None:
    axes = spoken("pt", lambda: drawn(small_figure())).axes[0]
    axes.figure.draw_without_rendering()
    assert axes.get_xlabel() == "Carga axial $F_{a}$ (kN)"
    drawn_ticks = [tick.get_text() for tick in axes.get_yticklabels()]
    assert any("," in text for text in drawn_ticks)
    assert not any("." in text for text in drawn_ticks)


def test_the_same_figure_gives_the_same_bytes() -> None:
    first, second = (
        spoken("en", lambda: rendered(small_figure(), ("svg", "png"))) for _ in range(2)
    )
    assert first == second
    assert b"<svg" in first["svg"]
    with Image.open(io.BytesIO(first["png"])) as image:
        assert image.info["dpi"] == pytest.approx((200.0, 200.0), abs=0.1)
        assert image.size[0] == pytest.approx(150.0 / 25.4 * 200.0, abs=1.0)


def test_balls_in_their_places() -> None:
    figure = Figure(
        number="1.3",
        caption=same("c"),
        source=same("s"),
        columns=(
            Series("ball", "", same("Ball"), np.array([1.0, 2.0])),
            Series("azimuth", "°", same("ψ"), np.array([0.0, 112.5])),
        ),
        picture=Positions(20.0, 100.0),
    )
    axes = spoken("pt", lambda: drawn(figure)).axes[0]
    texts = {text.get_text(): text.xy for text in axes.texts}  # type: ignore[attr-defined]
    assert texts["1"] == pytest.approx((0.0, 50.0))
    angle = np.radians(112.5)
    assert texts["2"] == pytest.approx((50.0 * np.sin(angle), 50.0 * np.cos(angle)))
    assert "112,5°" in texts


# --- folders ----------------------------------------------------------------


def test_writes_known_names_only(tmp_path: Path) -> None:
    folder = written(tmp_path / "new" / "one")
    assert {path.name for path in folder.iterdir()} == set(file_names(SMALL))
    assert f'content="rolamento {kind_of(SMALL)}"' in (folder / "index.html").read_text("utf-8")


def test_writes_again_over_its_own(tmp_path: Path) -> None:
    folder = written(tmp_path / "one")
    (folder / "notes.txt").write_text("mine", encoding="utf-8")
    (folder / "figure-1.01.csv").write_text("old", encoding="utf-8")
    written(folder, pictures="png")
    assert "old" not in (folder / "figure-1.01.csv").read_text("utf-8")
    assert (folder / "notes.txt").read_text("utf-8") == "mine"
    assert not (folder / "figure-1.01.svg").exists()  # it would not go with the data any more
    assert (folder / "figure-1.01.png").exists()


@pytest.mark.parametrize("name", ["index.html", "figure-1.01.png"])
def test_does_not_write_over_what_is_not_its_own(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("mine", encoding="utf-8")
    with pytest.raises(FileError, match=f"holds a {name}"):
        open_folder(str(tmp_path), SMALL)
    assert (tmp_path / name).read_text("utf-8") == "mine"


def test_a_folder_of_other_files_is_taken(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("mine", encoding="utf-8")
    written(tmp_path)
    assert (tmp_path / "thesis.tex").read_text("utf-8") == "mine"


def test_a_link_is_replaced_not_followed(tmp_path: Path) -> None:
    folder = written(tmp_path / "one")
    outside = tmp_path / "outside.csv"
    outside.write_text("mine", encoding="utf-8")
    (folder / "figure-1.01.csv").unlink()
    os.symlink(outside, folder / "figure-1.01.csv")
    written(folder)
    assert outside.read_text("utf-8") == "mine"
    assert not (folder / "figure-1.01.csv").is_symlink()


def test_a_file_is_no_folder(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine", encoding="utf-8")
    with pytest.raises(FileError, match="is a file"):
        open_folder(str(tmp_path / "file"), SMALL)
    with pytest.raises(FileError, match="cannot be written"):
        open_folder(str(tmp_path / "file" / "below"), SMALL)


@pytest.mark.parametrize("path", ["", "a\0b", "x" * 5000])
def test_impossible_folders(path: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(FileError):
        open_folder(path, SMALL)
    assert list(tmp_path.iterdir()) == []


def test_a_directory_in_the_way(tmp_path: Path) -> None:
    folder = written(tmp_path / "one")
    (folder / "figure-1.01.csv").unlink()
    (folder / "figure-1.01.csv").mkdir()
    with pytest.raises(FileError, match=r"figure-1\.01\.csv"):
        written(folder)
    assert not list(folder.glob(".*"))


def test_names_stay_inside() -> None:
    for name in file_names(find("radaelli-2013")):
        assert os.path.basename(name) == name
        assert not name.startswith(".")


# --- command ----------------------------------------------------------------


def run(*arguments: str, language: str = "C") -> Result:
    app = typer.Typer()
    app.command()(reproduce)
    return CliRunner().invoke(app, list(arguments), env={"LC_ALL": language, "COLUMNS": "200"})


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(radaelli_2013, "SOURCE", SMALL)
    monkeypatch.chdir(tmp_path)


def test_without_a_name_it_lists() -> None:
    result = run()
    assert result.exit_code == 0
    assert "radaelli-2013\n    Radaelli (2013), master's dissertation" in result.stdout
    assert "dissertação" in run("--lang", "pt").stdout
    assert max(map(len, result.stdout.splitlines())) <= 80


def test_an_unknown_name() -> None:
    result = run("radaeli_2013")
    assert result.exit_code == 2
    assert "did you mean radaelli-2013?" in result.stderr
    assert "known: braga-almeida" in run("harris").stderr
    assert run("../radaelli-2013").exit_code == 2


def test_without_a_package_it_says_how_to_get_one(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("importlib.metadata.entry_points", lambda group: ())
    result = run()
    assert result.exit_code == 2
    assert "pip install rolamento-reproductions" in result.stderr


@pytest.mark.usefixtures("small")
def test_it_writes_a_folder_of_that_name() -> None:
    result = run("radaelli-2013")
    assert result.exit_code == 0
    assert result.stdout.splitlines()[0] == "Figures: 1; tables: 1."
    assert result.stdout.endswith(os.path.join("radaelli-2013", "index.html") + "\n")
    assert result.stderr == ""
    assert Path("radaelli-2013/figure-1.01.svg").exists()


@pytest.mark.usefixtures("small")
def test_options() -> None:
    result = run("radaelli-2013", "--output", "x", "--lang", "pt", "--pictures", "png")
    assert result.exit_code == 0
    assert "Figuras: 1;" in result.stdout
    assert sorted(os.listdir("x")) == [
        "document.css",
        "figure-1.01.csv",
        "figure-1.01.png",
        "index.html",
        "index.md",
        "table-1.2.csv",
    ]
    assert '<html lang="pt-BR">' in Path("x/index.html").read_text("utf-8")


@pytest.mark.usefixtures("small")
def test_a_file_in_the_way_is_told() -> None:
    Path("x").write_text("mine", encoding="utf-8")
    result = run("radaelli-2013", "--output", "x")
    assert result.exit_code == 2
    assert "x: is a file; give a folder" in result.stderr


@pytest.mark.usefixtures("small")
def test_a_person_at_a_terminal_sees_progress(monkeypatch: pytest.MonkeyPatch) -> None:
    from rolamento.cli.reproduce import _progress_bar

    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(sys, "stderr", Terminal())
    with _progress_bar() as progress:
        progress(1, 4, both("Ball loads", "Cargas"))
        progress(4, 4, both("Done", "Pronto"))
    assert "4/4" in sys.stderr.getvalue()  # type: ignore[attr-defined]


@pytest.mark.sweep
def test_the_whole_thing(tmp_path: Path) -> None:
    told: list[tuple[int, int]] = []
    source = find("radaelli-2013")
    folder = open_folder(str(tmp_path), source)

    def note(done: int, total: int, what: Text) -> None:
        told.append((done, total))

    sections = computed(source, note)
    write(source, sections, folder, pictures="png", progress=note)
    expected = {name for name in file_names(source) if not name.endswith(".svg")}
    assert {path.name for path in tmp_path.iterdir()} == expected
    assert all(path.stat().st_size < 60_000 for path in tmp_path.glob("*.png"))
    assert told == sorted(told)
    assert told[-1] == (41, 41)
