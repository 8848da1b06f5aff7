"""Ricci and Fleury, Braga and Almeida: figures, tables and pages of misprints, computed anew."""

from __future__ import annotations

import csv
import io
from functools import partial
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import typer
from matplotlib.axes import Axes
from tests.reproduced import english, find, portuguese, spoken
from typer.testing import CliRunner

from rolamento.cli.reproduce import reproduce
from rolamento.document import Statement
from rolamento.document.html import html
from rolamento.document.markdown import markdown
from rolamento.friction.slip import rolling_lines
from rolamento_reproductions.braga_almeida.speeds import ball
from rolamento_reproductions.drawing import drawn, rendered
from rolamento_reproductions.page import index_page, misprints_page, summary
from rolamento_reproductions.record import (
    Curves,
    Errata,
    Figure,
    Maps,
    Misprint,
    Section,
    Table,
    power_above,
    power_text,
    residual,
)
from rolamento_reproductions.text import Text, formula, same
from rolamento_reproductions.writing import (
    computed,
    errata_csv,
    figure_csv,
    file_names,
    open_folder,
    table_csv,
    write,
)

NAMES = ("ricci-fleury", "braga-almeida")
FIGURES = {
    "ricci-fleury": ["8", "9"],
    "braga-almeida": ["2.1", "2.2", "3.1", "3.2", "4.1", "4.2", "5.1", "5.2"],
}


def quiet(done: int, total: int, what: Text) -> None:
    """Tell nobody."""


@pytest.fixture(scope="module")
def papers() -> dict[str, tuple[Section, ...]]:
    return {name: computed(find(name), quiet) for name in NAMES}


@pytest.fixture(scope="module")
def items(papers: dict[str, tuple[Section, ...]]) -> dict[str, Figure | Table | Errata]:
    return {
        f"{name}/{item.stem}": item
        for name, sections in papers.items()
        for section in sections
        for item in section.items
    }


def figure(items: dict[str, Any], name: str) -> Figure:
    found = items[name]
    assert isinstance(found, Figure)
    return found


def column(of: Figure, name: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    return of.column(name).numbers


# --- what is there ----------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_parts_hold_what_they_say(name: str, papers: dict[str, tuple[Section, ...]]) -> None:
    for part, section in zip(find(name).parts, papers[name], strict=True):
        assert part.stems == tuple(item.stem for item in section.items)
    shown = [i for s in papers[name] for i in s.items if isinstance(i, Figure)]
    assert [one.number for one in shown] == FIGURES[name]


def test_every_point_has_a_result(items: dict[str, Any]) -> None:
    for item in items.values():
        if isinstance(item, Figure):
            assert item.gaps == ()
            for one in item.columns:
                if one.name != "status":
                    assert np.isfinite(one.numbers).all(), (item.number, one.name)


def test_both_languages_are_spoken(items: dict[str, Any]) -> None:
    for item in items.values():
        texts = [item.caption, item.source]
        if isinstance(item, Errata):
            texts += [t for m in item.misprints for t in (m.place, m.derivation)]
            texts += item.remarks
        else:
            texts += [t for claim in item.claims for t in (claim.statement, claim.finding)]
        for text in texts:
            assert english(text) != portuguese(text)
            assert " sin " not in portuguese(text)


# --- statements -------------------------------------------------------------


def test_every_statement_ends_as_told(items: dict[str, Any]) -> None:
    """All hold, of the text and of theory, but these."""
    verdicts = {
        (name, place): claim.verdict
        for name, item in items.items()
        if not isinstance(item, Errata)
        for place, claim in enumerate(item.claims)
    }
    assert len(verdicts) == 18
    assert {key: value for key, value in verdicts.items() if value != "holds"} == {
        ("ricci-fleury/figure-09", 0): "partly",  # the inner contact spins less, the outer more
        ("ricci-fleury/figure-09", 1): "partly",  # at the load drawn, not at a heavier one
        ("braga-almeida/figure-3.01", 0): "partly",  # on the two lines only, not between them
        ("braga-almeida/table-4.1", 0): "fails",  # less friction lets the gyroscopic motion grow
        ("braga-almeida/table-5.1", 0): "partly",  # equation 48 has a misprint
    }


def test_statements_of_theory_are_apart(items: dict[str, Any]) -> None:
    section = Section(same("t"), (items["ricci-fleury/figure-08"],))
    page = spoken("en", lambda: index_page(find("ricci-fleury"), (section,), ("svg",)))
    told = [block for block in page.blocks() if isinstance(block, Statement)]
    marks = [block.mark or block.text.partition(",")[0] for block in told]
    first, second = marks.index("What the text says"), marks.index("What theory predicts")
    assert marks[first + 1 : second] == ["✓"] * 2
    assert marks[second + 1 : second + 7] == ["✓"] * 6


def test_summary_counts_what_there_is(papers: dict[str, tuple[Section, ...]]) -> None:
    lines = [english(line) for line in summary(papers["braga-almeida"])]
    assert lines[0] == "Figures: 8; tables: 3."
    assert not any("printed numbers" in line for line in lines)
    assert any(line.startswith("15 misprints") for line in lines)


def test_order_and_ratios_of_the_models(items: dict[str, Any]) -> None:
    """From the data alone."""
    of = figure(items, "ricci-fleury/figure-08")
    t = {
        name: column(of, name)
        for name in (
            "jones_full",
            "jones_control",
            "jones_simplified",
            "harris",
            "todd",
            "todd_bare",
        )
    }
    assert (t["harris"] < t["jones_full"]).all()
    assert (t["jones_full"] < t["jones_control"]).all()
    assert (t["todd_bare"] < t["todd"]).all()
    assert (t["todd"] < t["jones_simplified"]).all()
    assert t["jones_full"] / t["harris"] == pytest.approx(1.025, abs=0.01)
    assert t["jones_control"] / t["todd_bare"] == pytest.approx(1.0, abs=3e-3)
    over_control = t["jones_simplified"] / t["jones_control"]
    over_full = t["jones_simplified"] / t["jones_full"]
    assert 1.095 < over_control.min() < over_control.max() < 1.175
    assert 1.27 < over_full.min() < over_full.max() < 1.535
    # a point contact: torque with the load to the power of 4/3, and more as the angle rises
    slope = np.polyfit(np.log(column(of, "axial_load")), np.log(t["todd_bare"]), 1)[0]
    assert 1.3 < slope < 1.45


def test_table_8_is_figure_8(items: dict[str, Any]) -> None:
    of, table = figure(items, "ricci-fleury/figure-08"), items["ricci-fleury/table-8"]
    rows = list(csv.DictReader(io.StringIO(table_csv(table))))
    loads = column(of, "axial_load")
    for row in rows:
        place = int(np.flatnonzero(loads == float(row["axial_load_N"]))[0])
        for name in ("jones_full", "harris", "todd"):
            value, share = row[f"{name}_Nmm"].rstrip(")").split(" (")
            assert float(value) == pytest.approx(column(of, name)[place], abs=6e-4)
            part = column(of, name)[place] / column(of, "jones_full")[place]
            assert float(share) == pytest.approx(part, abs=6e-4)


def test_control_goes_from_the_inner_to_the_outer_race(items: dict[str, Any]) -> None:
    of = figure(items, "ricci-fleury/figure-09")
    equal = column(of, "outer_conformity") == 0.525
    inner, outer = column(of, "inner_spin_to_roll"), column(of, "outer_spin_to_roll")
    assert inner[equal][0] < outer[equal][0]
    assert inner[equal][-1] > 5.0 * outer[equal][-1]
    lines = column(of, "inner_rolling_lines") - column(of, "outer_rolling_lines")
    assert lines[equal][0] == 1.0
    assert lines[equal][-1] == -1.0
    assert (np.diff(lines[equal]) <= 0.0).all()
    # the wide outer groove keeps the inner race in control to a far higher speed
    speed = column(of, "inner_speed")
    change = [speed[rows][np.argmax(inner[rows] > outer[rows])] for rows in (equal, ~equal)]
    assert change[1] > 3.0 * change[0]
    torque = column(of, "friction_torque")
    assert (torque[~equal] < torque[equal]).all()


# --- motions of Braga and Almeida -------------------------------------------


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_slip_maps_are_the_corrected_equations(race: str, items: dict[str, Any]) -> None:
    """(32), (34), (41), (42) with their spin terms, in the paper's axes, from the ball's motion."""
    of = figure(items, f"braga-almeida/figure-{'3' if race == 'outer' else '4'}.01")
    one = ball("friction")
    side = 1.0 if race == "outer" else -1.0
    patch = one.patch(race)  # type: ignore[arg-type]
    theta = -float(patch.contact_angle[0])  # the paper has the outer contact on the -x side
    x0, y0 = column(of, "across") / 1e3, column(of, "along") / 1e3
    big, a = float(patch.deformed_radius[0]), float(patch.semi_major[0])
    half = 0.5 * float(patch.ball_diameter[0])
    rho = np.sqrt(big**2 - x0**2) - np.sqrt(big**2 - a**2) + np.sqrt(half**2 - a**2)
    x, y, z = one.velocity
    ring = (one.speed if race == "inner" else 0.0) - one.orbit
    spin = side * (z * np.cos(theta) - x * np.sin(theta) + ring * np.sin(theta))
    turn = x * np.cos(theta) + z * np.sin(theta) - ring * np.cos(theta)
    rolling = -0.5 * float(patch.pitch_diameter[0]) * ring + side * rho * turn - side * x0 * spin
    transverse = -side * rho * y + side * y0 * spin
    assert column(of, "rolling_slip") == pytest.approx(rolling, abs=1e-9)
    assert column(of, "transverse_slip") == pytest.approx(transverse, abs=1e-9)
    assert column(of, "slip") == pytest.approx(np.hypot(rolling, transverse), abs=1e-9)
    inside = (x0 / a) ** 2 + (y0 / float(patch.semi_minor[0])) ** 2
    assert inside.max() <= 1.0 + 1e-9


def test_profiles_cross_zero_on_the_lines_of_pure_rolling(items: dict[str, Any]) -> None:
    of = figure(items, "braga-almeida/figure-3.02")
    one = ball("friction")
    lines = rolling_lines(one.patch("outer"), one.motion("outer"))[0]
    across, slip = column(of, "across"), column(of, "with_spin")
    changes = np.flatnonzero(np.diff(np.sign(slip)))
    found = across[changes] / across.max()
    assert found == pytest.approx(lines, abs=0.011)
    assert column(of, "as_printed") == pytest.approx(column(of, "as_printed")[::-1], abs=1e-9)
    assert np.abs(slip - slip[::-1]).max() > 0.3


def test_frequencies(items: dict[str, Any]) -> None:
    rows = list(csv.DictReader(io.StringIO(table_csv(items["braga-almeida/table-2.1"]))))
    gamma = 22.23 * np.cos(np.radians(40.0)) / 125.26
    turns = 10_000.0 / 60.0
    cage = 0.5 * turns * (1.0 - gamma)
    expected = [
        cage,
        0.5 * 125.26 / 22.23 * turns * (1.0 - gamma**2),
        16.0 * cage,
        16.0 * (turns - cage),
    ]
    assert [float(row["equations_Hz"]) for row in rows] == pytest.approx(expected, abs=0.006)
    for way in ("equations_Hz", "outer_control_Hz", "friction_Hz"):
        values = [float(row[way]) for row in rows]
        assert values[2] + values[3] == pytest.approx(16.0 * turns, abs=0.02)
    parted = float(rows[0]["friction_Hz"]) / float(rows[0]["outer_control_Hz"]) - 1.0
    assert -0.02 < parted < -0.01


def test_slow_speeds_approach_the_equations(items: dict[str, Any]) -> None:
    of = figure(items, "braga-almeida/figure-2.01")
    by_equations, solved = column(of, "equations"), column(of, "outer_control")
    gap = np.abs(solved / by_equations - 1.0)
    assert gap[0] < 0.006  # the contact angle under load
    assert gap[-1] > 0.05
    assert np.diff(gap).min() > -1e-6


def test_orbit_of_the_solved_ball_by_the_equations() -> None:
    one = ball("friction")
    exact = one.orbits()
    outer, inner, turning = exact.from_vectors()
    assert -outer[0] == pytest.approx(one.orbit, rel=1e-12)
    assert inner[0] == pytest.approx(one.speed - one.orbit, rel=1e-12)
    assert turning[0] == pytest.approx(one.ball_speed, rel=1e-12)
    assert exact.inner_speed()[0] == pytest.approx(one.speed - one.orbit, rel=1e-12)
    assert abs(exact.inner_speed_printed()[0] / (one.speed - one.orbit) - 1.0) > 0.05


# --- misprints --------------------------------------------------------------

MISPRINTS = {
    "ricci-fleury": ["10", "13", "16", "19"],
    "braga-almeida": [
        *("26", "", "28", "29", "31", "33", "35", "36", "39", "40", "41", "42", "48", "", "41"),
    ],
}
SOUND = {
    "ricci-fleury": ["5", "8", "18"],
    "braga-almeida": ["19", "22", "38", "43", "44", "45", "49", "50"],
}


def errata(items: dict[str, Any], name: str) -> Errata:
    found = items[f"{name}/misprints"]
    assert isinstance(found, Errata)
    return found


@pytest.mark.parametrize("name", NAMES)
def test_misprints_are_those(name: str, items: dict[str, Any]) -> None:
    found = errata(items, name)
    assert [one.number for one in found.misprints] == MISPRINTS[name]
    assert [one.number for one in found.valid] == SOUND[name]


@pytest.mark.parametrize(
    ("name", "place"),
    [(name, place) for name in NAMES for place in range(len(MISPRINTS[name]))],
)
def test_residuals_of_a_misprint(name: str, place: int, items: dict[str, Any]) -> None:
    """As printed it is off at most attitudes; corrected, it is right at all to rounding."""
    one: Misprint = errata(items, name).misprints[place]
    assert one.printed_residual.median > 5e-3, one.place
    assert one.printed_residual.maximum >= one.printed_residual.median
    assert one.corrected_residual.maximum < 1e-12, one.place
    assert one.printed != one.corrected


@pytest.mark.parametrize("name", NAMES)
def test_residuals_of_what_is_sound(name: str, items: dict[str, Any]) -> None:
    for one in errata(items, name).valid:
        assert one.residual.maximum < 1e-13, one.number


def test_a_residual_sees_the_worst_component() -> None:
    truth = np.zeros((3, 2))
    form = np.array([[0.0, 0.0], [0.0, -2.0], [1.0, 0.5]])
    found = residual(form, truth, np.array([1.0, 4.0, 1.0]))
    assert (found.median, found.maximum) == (0.5, 1.0)


@pytest.mark.parametrize(
    ("value", "power"), [(0.0, "10⁻¹⁴"), (2e-16, "10⁻¹⁴"), (3e-13, "10⁻¹²"), (0.02, "10⁻¹")]
)
def test_rounding_is_told_by_the_power_of_ten_above(value: float, power: str) -> None:
    assert value < power_above(value)
    assert power_text(value) == power


def test_formulas_speak_portuguese() -> None:
    text = formula("sin β − tan α, single")
    assert english(text) == "sin β − tan α, single"
    assert portuguese(text) == "sen β − tg α, single"


class Reader(HTMLParser):
    """Checks that every element is closed in turn, and gathers what the page points to."""

    VOID = frozenset({"meta", "img", "br", "link"})

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.targets: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.targets += [value or "" for key, value in attrs if key in ("src", "href")]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("language", ["en", "pt"])
def test_page_of_misprints(name: str, language: str, items: dict[str, Any]) -> None:
    source, found = find(name), errata(items, name)
    page = spoken(language, lambda: html(misprints_page(source, found)))
    reader = Reader()
    reader.feed(page)
    assert reader.open == []
    assert [target for target in reader.targets if target[0] != "#"] == ["index.html"]
    assert page.count("<dt ") == 3 * len(found.misprints)
    assert ("sen " in page) == (language == "pt")
    text = spoken(language, lambda: markdown(misprints_page(source, found)))
    assert text.count("\n## ") == len(found.misprints) + 2
    rows = [line for line in text.splitlines() if line.startswith("|")]
    assert len({row.count("|") for row in rows[: len(found.misprints) + 2]}) == 1


@pytest.mark.parametrize("name", NAMES)
def test_data_of_misprints(name: str, items: dict[str, Any]) -> None:
    found = errata(items, name)
    rows = list(csv.DictReader(io.StringIO(errata_csv(found))))
    assert len(rows) == len(found.misprints) + len(found.valid)
    for row, one in zip(rows, found.misprints, strict=False):
        assert row["printed"] == english(one.printed)
        assert row["corrected"] == english(one.corrected)
        value = one.printed_residual.median
        assert float(row["residual_median"]) == pytest.approx(value, rel=0.06)
        assert one.corrected_residual.maximum < float(row["residual_corrected_below"]) <= 1e-12
    assert all(row["corrected"] == "" for row in rows[len(found.misprints) :])


# --- pictures and data ------------------------------------------------------


def test_data_hold_all_columns(items: dict[str, Any]) -> None:
    for item in items.values():
        if not isinstance(item, Figure):
            continue
        rows = list(csv.DictReader(io.StringIO(figure_csv(item))))
        for one in item.columns:
            written = [row[one.header] for row in rows]
            if one.name == "status":
                assert written == list(one.values)
            else:
                assert [float(v) for v in written] == pytest.approx(one.numbers, rel=1e-7, abs=1e-9)


def test_lines_drawn_are_the_data(items: dict[str, Any]) -> None:
    for item in items.values():
        if not isinstance(item, Figure) or not isinstance(item.picture, Curves):
            continue
        data = list(csv.DictReader(io.StringIO(figure_csv(item))))
        panel = item.picture.panels[0]
        lines = [
            line
            for line in spoken("pt", partial(drawn, item)).axes[0].lines
            if len(line.get_xdata()) > 2
        ]  # type: ignore[arg-type]
        assert len(lines) == len(panel.lines)
        for line, shown in zip(panel.lines, lines, strict=True):
            rows = [
                row
                for row in data
                if line.by is None or float(row[item.column(line.by[0]).header]) == line.by[1]
            ]
            for name, values in ((panel.x, shown.get_xdata()), (line.y, shown.get_ydata())):
                written = [float(row[item.column(name).header]) for row in rows]
                assert np.asarray(values, float) == pytest.approx(written, rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("number", ["3.01", "4.01"])
def test_maps_drawn_are_the_data(
    number: str, items: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    of = figure(items, f"braga-almeida/figure-{number}")
    assert isinstance(of.picture, Maps)
    drawn_fields: list[tuple[Any, ...]] = []
    filled = Axes.contourf

    def noted(self: Axes, *args: Any, **keywords: Any) -> Any:
        drawn_fields.append(args)
        return filled(self, *args, **keywords)

    monkeypatch.setattr(Axes, "contourf", noted)
    picture = spoken("en", lambda: drawn(of))
    data = list(csv.DictReader(io.StringIO(figure_csv(of))))
    for one, args in zip(of.picture.maps, drawn_fields, strict=True):
        for name, values in zip((of.picture.x, of.picture.y, one.value), args, strict=True):
            written = [float(row[of.column(name).header]) for row in data]
            assert values.ravel() == pytest.approx(written, rel=1e-6, abs=1e-9)
    assert picture.axes[0].get_title(loc="left").startswith("Slip along rolling")
    assert "mm" in picture.axes[2].get_xlabel()


@pytest.mark.sweep
def test_a_map_gives_the_same_bytes(items: dict[str, Any]) -> None:
    of = figure(items, "braga-almeida/figure-3.01")
    assert spoken("pt", lambda: rendered(of, ("png",))) == spoken(
        "pt", lambda: rendered(of, ("png",))
    )


# --- folders and command ----------------------------------------------------


@pytest.mark.sweep
def test_folder_holds_the_page_of_misprints(
    tmp_path: Path, papers: dict[str, tuple[Section, ...]]
) -> None:
    source = find("braga-almeida")
    folder = open_folder(str(tmp_path), source)
    write(source, papers["braga-almeida"], folder, pictures="png")
    expected = {name for name in file_names(source) if not name.endswith(".svg")}
    assert {path.name for path in tmp_path.iterdir()} == expected
    assert {"misprints.html", "misprints.md", "misprints.csv"} <= expected
    reader = Reader()
    reader.feed((tmp_path / "index.html").read_text("utf-8"))
    assert reader.open == []
    inside = {target for target in reader.targets if not target.startswith("#")}
    assert inside <= expected
    assert "misprints.html" in inside
    assert "(misprints.md)" in (tmp_path / "index.md").read_text("utf-8")
    assert sum(path.stat().st_size for path in tmp_path.glob("*.png")) < 500_000


def run(*arguments: str) -> Any:
    app = typer.Typer()
    app.command()(reproduce)
    return CliRunner().invoke(app, list(arguments), env={"LC_ALL": "C", "COLUMNS": "200"})


def test_command_lists_them() -> None:
    listed = run()
    assert listed.exit_code == 0
    for name in ("radaelli-2013", *NAMES):
        assert f"{name}\n" in listed.stdout
    assert "did you mean ricci-fleury?" in run("ricci-fleuri").stderr


def test_command_writes_a_paper(tmp_path: Path) -> None:
    folder = tmp_path / "out"
    result = run("ricci-fleury", "--output", str(folder), "--lang", "pt", "--pictures", "png")
    assert result.exit_code == 0, result.stderr
    assert "4 erros de impressão" in result.stdout
    assert "Erros de impressão" in (folder / "misprints.html").read_text("utf-8")
    assert '<html lang="pt-BR">' in (folder / "misprints.html").read_text("utf-8")
    assert (folder / "figure-08.png").exists()
    assert not (folder / "figure-08.svg").exists()


@pytest.mark.parametrize("name", NAMES)
def test_the_gallery_is_what_the_command_writes(
    name: str, papers: dict[str, tuple[Section, ...]]
) -> None:
    """The numbers of the repository's gallery, to what other machines may differ in."""
    gallery = Path(__file__).parents[2] / "docs" / "gallery" / name
    for section in papers[name]:
        for item in section.items:
            if isinstance(item, Figure):
                kept = list(
                    csv.DictReader(io.StringIO((gallery / f"{item.stem}.csv").read_text("utf-8")))
                )
                for one in item.columns:
                    if one.name == "status":
                        continue
                    written = [float(row[one.header]) for row in kept]
                    scale = float(np.abs(one.numbers).max())
                    assert written == pytest.approx(one.numbers, rel=1e-4, abs=1e-4 * scale)
