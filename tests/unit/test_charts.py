"""One record a picture: both renderers draw the same numbers, in the colours of one palette."""

from __future__ import annotations

import itertools
import json
import re
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_rgb

import rolamento
from rolamento.charts import (
    Arrows,
    Axis,
    Bars,
    Chart,
    Ellipses,
    Field,
    Labels,
    Line,
    Look,
    Mark,
    Spread,
    Zone,
    key,
    nothing,
    once,
    race_look,
    series_look,
    step_line,
)
from rolamento.charts.drawing import draw
from rolamento.charts.frame import figure_of
from rolamento.charts.palette import DARK, LIGHT, SERIES
from rolamento.charts.plotly import picture
from rolamento.charts.record import BREAK
from rolamento.document import Document, Figure, Section
from rolamento.document.html import html

STYLE = Path(rolamento.__file__).parent / "web" / "page" / "pictures.css"
X = np.array([0.0, 1.0, 2.0, 3.0])
HALF = np.array([True, True, False, False])
EVERY = Chart(
    (
        Line(X, np.array([1.0, 2.0, np.nan, 4.0]), "line", Look("inner"), "both", (1, 1)),
        Line(X, 2.0 * X, "judged", Look("outer", "dash"), valid=HALF),
        Line(X[:2], np.zeros(2), "none", Look("bad", mark="thin"), "points", height=0.0,
             texts=("why", "why not")),
        Spread(X, X, X + 1.0, "band", Look("inner2")),
        Ellipses(X[:2], X[:2], X[:2] + 0.1, X[:2] + 0.2, "ellipses", Look("outer2"), hatched=True),
        Labels(X[:1], X[:1], ("here",), ("right",)),
    ),
    Axis("Speed", "rpm"),
    Axis("Load", "N", zero=True),
    "The load rises to 4 N.",
    "Load over speed",
    marks=(Mark(3.0, "limit", Look("bad")), Mark(1.5, "now", Look("ink"), "x")),
    zones=(Zone(2.0, np.inf, "much", "fair"),),
)  # fmt: skip
CELLS = Chart(
    (
        Field(X, X[:3], np.array([[1.0, -2.0, 3.0], [4.0, np.nan, 6.0]]), Axis("Gap", "µm"),
              signed=True, missing="none"),
        Arrows(X, X, np.array([1.0, 0.0, -1.0, 2.0]), np.zeros(4)),
        Line(X, X, "path", Look("white", "dash")),
        Line(*step_line(X, [1.0, 2.0, 1.0]), "steps", Look("inner"), filled=True),
        Line(X, X, "sparse", Look("outer"), "sparse"),
        key("key", Look("grey")),
        Labels(X[:1], X[:1], ("Q_0",), ("on",), height=0.5),
    ),
    Axis("Load Q_0", "N", (0.0, 3.0)),
    Axis("Gap", "µm", (0.0, 4.0)),
    symbols=True,
    over_names="all of them",
)  # fmt: skip
SPANS = Chart(
    (
        Bars(np.array([2.0]), (0,), "first", Look("inner", opacity=0.5), start=np.array([1.0])),
        Bars(np.array([3.0]), (1,), "second", Look("outer", hollow=True), start=np.array([2.0])),
    ),
    Axis("Time", "h", (0.0, 4.0)),
    Axis(categories=("first", "second")),
)
BARS = Chart(
    (
        Bars(np.array([1.0, np.inf]), (0, 1), "case A", Look("inner"), ("1", "∞"), (True, False)),
        Bars(np.array([2.0, 3.0]), (0, 1), "case B", Look("inner2")),
    ),
    Axis("Life", "h", (0.0, 10.0)),
    Axis(categories=("first", "second")),
)


def trace(chart: Chart, name: str) -> dict[str, object]:
    return next(one for one in picture(chart)["data"] if one.get("name") == name)


def luminance(color: str) -> float:
    """Of WCAG 2.1."""
    linear = [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in to_rgb(color)]
    return float(np.dot([0.2126, 0.7152, 0.0722], linear))


def test_both_renderers_have_the_numbers_of_the_record() -> None:
    axes = draw(EVERY)
    drawn = {line.get_label(): line for line in axes.lines}
    for name in ("line", "judged"):
        upright = np.array(trace(EVERY, name)["y"], dtype=float)
        np.testing.assert_array_equal(np.asarray(drawn[name].get_ydata(), dtype=float), upright)
    assert axes.get_xlabel() == picture(EVERY)["layout"]["xaxis"]["title"]["text"] == "Speed (rpm)"
    assert axes.get_ylabel() == picture(EVERY)["layout"]["yaxis"]["title"]["text"] == "Load (N)"
    assert axes.get_ylim()[0] == picture(EVERY)["layout"]["yaxis"]["range"][0] == 0.0


def test_names_are_the_same_on_paper_and_on_the_page() -> None:
    for chart in (EVERY, BARS):
        legend = draw(chart).get_legend()
        assert legend is not None
        names = {one.get("name") for one in picture(chart)["data"]} - {"", None}
        assert {text.get_text() for text in legend.get_texts()} == names


def test_numbers_as_colours_are_in_both() -> None:
    axes = draw(CELLS)
    (mesh,) = (one for one in axes.collections if one.get_gid() == "colour-map")
    shown = np.ma.filled(np.ma.asarray(mesh.get_array(), dtype=float), np.nan).ravel()
    cells, arrows, *_ = picture(CELLS)["data"]
    np.testing.assert_array_equal(shown, np.array(cells["marker"]["color"], dtype=float))
    assert cells["x"] == [0.5, 1.5, 2.5] * 2
    assert cells["marker"]["cmid"] == 0.0  # zero is in the middle of the colours
    low, high = mesh.get_clim()
    assert low == -high
    assert arrows["marker"]["angle"] == [90.0, 0.0, -90.0, 90.0]
    assert axes.get_xlabel() == "Load $Q_{0}$ (N)"
    legend = axes.get_legend()
    assert legend is not None
    assert legend.get_title().get_text() == "all of them"
    (path,) = (one for one in legend.get_lines() if one.get_label() == "path")
    assert path.get_color() != "white"  # on white paper
    assert trace(CELLS, "sparse")["marker"]["maxdisplayed"] < 10  # type: ignore[index]
    words = next(one for one in picture(CELLS)["data"] if one["mode"] == "text")
    assert words["y"] == [2.0]  # half way up


def test_bars_begin_where_they_are_said_to() -> None:
    assert trace(SPANS, "second")["base"] == [2.0]
    assert trace(SPANS, "second")["x"] == [1.0]
    assert picture(SPANS)["layout"]["barmode"] == "overlay"
    drawn = [(bar.get_x(), bar.get_width()) for bar in draw(SPANS).patches]  # type: ignore[attr-defined]
    assert drawn == [(1.0, 1.0), (2.0, 1.0)]


def test_a_name_stands_once() -> None:
    line = Line(X, X, "same", Look("inner"))
    assert [one.name for one in once([line, line])] == ["same", ""]


def test_what_does_not_hold_is_faint_and_meets_what_does() -> None:
    faint = [one for one in picture(EVERY)["data"] if "opacity" in one]
    assert [one["y"] for one in faint] == [[None, 2.0, 4.0, 6.0]]
    alphas = [line.get_alpha() for line in draw(EVERY).lines if line.get_alpha()]
    assert alphas == [faint[0]["opacity"]]
    assert trace(BARS, "case A")["marker"]["opacity"] == [1.0, faint[0]["opacity"]]  # type: ignore[index]


def test_what_has_no_number_stands_at_the_foot_with_its_reason() -> None:
    none = trace(EVERY, "none")
    assert none["y"] == [0.0, 0.0]
    assert none["text"] == ["why", "why not"]


def test_what_never_ends_fills_the_frame() -> None:
    assert trace(BARS, "case A")["x"] == [1.0, 10.0]
    assert max(bar.get_width() for bar in draw(BARS).patches) == 10.0


def test_a_bar_beyond_its_axis_has_a_break_mark_at_its_end() -> None:
    far = replace(BARS, x=Axis("Life", "h", (0.1, 2.5), log=True))
    marks = picture(far)["layout"]["annotations"]
    assert [round(one["y"], 6) for one in marks] == [0.8, 1.2]  # "∞" and 3, not 1 and 2
    assert {one["x"] for one in marks} == {np.log10(2.5)}
    drawn = [text for text in draw(far).texts if text.get_text() == BREAK]
    assert [round(float(text.xy[1]), 6) for text in drawn] == [0.8, 1.2]  # type: ignore[attr-defined]
    assert [one["y"] for one in picture(BARS)["layout"]["annotations"]] == [0.8]


def test_pictures_are_plain_json_and_say_what_they_say() -> None:
    found = picture(EVERY)
    assert json.loads(json.dumps(found, allow_nan=False)) == found
    assert found["summary"] == "The load rises to 4 N."
    assert EVERY.shows == "Load over speed"
    assert replace(EVERY, title="").shows == "Load (N) over Speed (rpm)"


def test_panels_stand_beside_or_below_one_another() -> None:
    beside = picture(EVERY, EVERY)["layout"]
    assert beside["xaxis"]["domain"][1] < beside["xaxis2"]["domain"][0]
    below = picture(EVERY, EVERY, down=True)["layout"]
    assert below["yaxis"]["domain"][0] > below["yaxis2"]["domain"][1]


def test_nothing_to_draw_says_why() -> None:
    assert picture(nothing("no load"))["summary"] == "no load"
    assert "no load" in draw(nothing("no load")).texts[0].get_text()
    assert figure_of(draw(nothing("no load")))


def test_the_page_has_the_colours_of_the_palette() -> None:
    """In the light, in the dark by choice, and in the dark by what the system says."""
    found: dict[str, list[str]] = {}
    for name, color in re.findall(r"--picture-(\w+): (#[0-9a-f]{6})", STYLE.read_text("utf-8")):
        found.setdefault(name, []).append(color)
    for name in sorted(LIGHT.keys() - {"ink", "grey"}):  # those are the page's own
        light, *dark = found[name][:3]
        assert light == LIGHT[name].lower(), name
        assert dark == [DARK[name].lower()] * 2, name
    assert LIGHT.keys() == DARK.keys()


@pytest.mark.parametrize(("colors", "paper"), [(LIGHT, "#ffffff"), (DARK, "#15191c")])
def test_lines_stand_out_from_the_paper(colors: dict[str, str], paper: str) -> None:
    """WCAG 2.1, 1.4.11: 3 to 1; the light orange and sky blue of series beyond the fourth less."""
    ground = luminance(paper)
    for name, color in colors.items():
        bright, dark = sorted((luminance(color), ground), reverse=True)
        least = 2.0 if name in ("fifth", "sixth") else 3.0
        assert (bright + 0.05) / (dark + 0.05) >= least, name


def test_races_rows_and_cases_differ_in_black_and_white() -> None:
    for case in (0, 1):
        looks = [race_look(race, case, row) for row in range(3) for race in ("inner", "outer")]
        assert len({look.dash for look in looks}) == len(looks)
        assert len({look.mark for look in looks}) == len(looks)
    pair = [race_look(race, case) for case in (0, 1) for race in ("inner", "outer")]
    for one, other in itertools.combinations(pair, 2):
        assert one.color != other.color
        assert one.dash != other.dash
    assert len({look.dash for look in SERIES}) == len({look.mark for look in SERIES}) == 7
    assert series_look(7) == SERIES[0]


# --- those who cannot see it ----------------------------------------------------------------------


def test_a_page_says_what_its_charts_say() -> None:
    captions = {"Load over speed.": EVERY, "All cases": EVERY, "Lives": BARS, "": EVERY}
    figures = tuple(Figure(text, partial(draw, chart), "load") for text, chart in captions.items())
    own = Figure("Bearing", partial(draw, EVERY), "own", alternative="A bearing in section.")
    text = html(Document("Loads", (Section("", (*figures, own)),)))
    said = f"{EVERY.shows}. {EVERY.says}"
    lives = "Lives. Life, case A, highest: 1 h (first); Life, case B, highest: 3 h (second)"
    told = [said, f"All cases. {said}", lives, said, "A bearing in section."]
    assert re.findall('role="img" aria-label="([^"]*)"', text) == told
    below = re.findall(r"<figcaption>(.*?)</figcaption>", text, re.S)
    says = '<span class="says">The load rises to 4\u00a0N</span>'
    assert below[:2] == [f"Load over speed.<br>\n{says}", f"All cases<br>\n{says}"]
    assert below[3] == says
    again = Figure("All: the load rises to 4 N.", partial(draw, EVERY), "again")
    text = html(Document("Loads", (Section("", (again,)),)))
    assert 'class="says"' not in text  # its caption says it


def test_a_chart_without_a_conclusion_says_what_its_numbers_show() -> None:
    across, upright = Axis("Speed", "rpm"), Axis("Power", "W")
    falls = Line(X, 4.0 - X, "", Look("inner"))
    turns = Line(X, np.array([1.0, 5.0, 2.0, 0.0]), "A", Look("outer"))
    still = Line(X, np.full(4, 7.0), "B", Look("outer"))
    many = tuple(Line(X, X + place, f"case {place}", Look("inner")) for place in range(4))
    for series, text in (
        ((falls,), "Power falls from 4 W at 0 rpm to 1 W at 3 rpm"),
        ((turns, still), "Power: A is highest at 1 rpm: 5 W; B stays at 7 W"),
        (many, "Power, highest: 6 W at 3 rpm (case 3); lowest: 0 W at 0 rpm (case 0)"),
    ):
        assert Chart(series, across, upright).says == text
    assert Chart((falls,), across, upright, "It falls.").says == "It falls."
    assert CELLS.says == "Gap from −2 µm to 6 µm, highest at 2.5 N, 1.5 µm"
