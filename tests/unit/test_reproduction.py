"""The figures and tables of Radaelli (2013): complete, in balance, and as the text says."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np
import pytest
from tests.reproduced import english, find, portuguese

from rolamento.status import STATUS_NAMES
from rolamento_reproductions.record import Agreement, Cell, Curves, Figure, Floats, Section, Table
from rolamento_reproductions.text import templates
from rolamento_reproductions.writing import computed, figure_csv, table_csv

GALLERY = Path(__file__).resolve().parents[2] / "docs" / "gallery" / "radaelli-2013"
COUNT = 16  # balls of the 218


@pytest.fixture(scope="module")
def sections() -> tuple[Section, ...]:
    return computed(find("radaelli-2013"), lambda done, total, what: None)


@pytest.fixture(scope="module")
def figures(sections: tuple[Section, ...]) -> dict[str, Figure]:
    items = [item for section in sections for item in section.items]
    return {item.number: item for item in items if isinstance(item, Figure)}


@pytest.fixture(scope="module")
def tables(sections: tuple[Section, ...]) -> dict[str, Table]:
    items = [item for section in sections for item in section.items]
    return {item.number: item for item in items if isinstance(item, Table)}


def column(figure: Figure, name: str) -> Floats:
    return figure.column(name).numbers


def at_balls(figure: Figure, *names: str) -> list[Floats]:
    """Columns in the rows where there is a ball."""
    placed = np.isfinite(column(figure, "ball"))
    return [column(figure, name)[placed] for name in names]


# --- complete ---------------------------------------------------------------


def test_every_figure_once_and_in_order(sections: tuple[Section, ...]) -> None:
    items = [item for section in sections for item in section.items]
    numbers = [item.number for item in items if isinstance(item, Figure)]
    assert numbers == [f"5.{number}" for number in range(1, 33)]
    assert [item.number for item in items if isinstance(item, Table)] == [
        "5.3",
        "5.4",
        "C.1",
        "C.2",
    ]


def test_parts_hold_what_they_say(sections: tuple[Section, ...]) -> None:
    for part, section in zip(find("radaelli-2013").parts, sections, strict=True):
        assert part.stems == tuple(item.stem for item in section.items)
        assert section.title == part.title


def test_every_point_has_a_result(figures: dict[str, Figure]) -> None:
    for figure in figures.values():
        assert figure.gaps == ()
        for values in figure.columns:
            if values.name not in ("ball", "status"):
                assert np.isfinite(values.numbers).all(), (figure.number, values.name)


def test_both_languages_are_spoken(sections: tuple[Section, ...]) -> None:
    for section in sections:
        for item in section.items:
            texts = [item.caption, item.source, *item.notes]
            texts += [t for claim in item.claims for t in (claim.statement, claim.finding)]
            for text in texts:
                assert english(text)
                assert portuguese(text)
            assert english(item.caption) != portuguese(item.caption)
            assert english(item.source) != portuguese(item.source)


# --- tables -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("number", "count", "exceptions"),
    [
        ("5.3", 36, {"48.77": "tie"}),
        ("5.4", 9, {}),
        ("C.1", 18, {}),
        ("C.2", 6, {"41.494": "cut"}),
    ],
)
def test_printed_numbers(
    tables: dict[str, Table], number: str, count: int, exceptions: dict[str, Agreement]
) -> None:
    cells = tables[number].cells
    assert len(cells) == count
    found = {cell.printed: cell.agreement for cell in cells if cell.agreement != "printed"}
    assert found == exceptions


@pytest.mark.parametrize(
    ("printed", "value", "agreement"),
    [
        ("36.15", 36.1468, "printed"),
        ("36.15", 36.1551, "differs"),
        ("48.77", 48.76498, "tie"),
        ("41.494", 41.49493, "differs"),
        ("-0.0370", -0.036975, "printed"),
        ("-0.0370", 0.0370, "differs"),
        ("1.0217e6", 1021697.0, "printed"),
        ("1.0217e6", 1021800.0, "differs"),
        ("4520", 4520.2, "printed"),
        ("0", 0.0, "printed"),
        ("0", float("nan"), "differs"),
    ],
)
def test_agreement(printed: str, value: float, agreement: Agreement) -> None:
    assert Cell(printed, value).agreement == agreement


@pytest.mark.parametrize(
    ("printed", "value", "agreement"),
    [
        ("41.494", 41.49493, "cut"),
        ("41.494", 41.4942, "printed"),
        ("41.494", 41.4951, "differs"),
        ("41.494", 41.4933, "differs"),
        ("-0.0370", -0.03709, "cut"),
        ("-0.0370", -0.03690, "differs"),
        ("-0.0370", 0.0370, "differs"),
    ],
)
def test_digits_that_are_cut(printed: str, value: float, agreement: Agreement) -> None:
    assert Cell(printed, value, cut=True).agreement == agreement


def test_every_status_has_words() -> None:
    reasons = {key.removeprefix("reason.") for key in templates("", "en") if "reason." in key}
    assert reasons == set(STATUS_NAMES.values()) - {"converged"}


@pytest.mark.parametrize(
    ("printed", "value", "text"),
    [
        ("36.15", 36.14682, "36.1468"),
        ("4520", 4520.216, "4520.22"),
        ("1.0217e6", 1021696.6, "1.021697e6"),
        ("48.77", 48.764981, "48.76498"),  # one digit more, to show that it is a tie
    ],
)
def test_computed_numbers_have_two_digits_more(printed: str, value: float, text: str) -> None:
    assert Cell(printed, value).text == text


# --- statements -------------------------------------------------------------


def test_which_statements_do_not_hold(sections: tuple[Section, ...]) -> None:
    """All hold but these: what they claim is told beside the figure, with what is found."""
    found = {
        (item.stem, claim.verdict)
        for section in sections
        for item in section.items
        for claim in item.claims
        if claim.verdict != "holds"
    }
    assert found == {
        ("table-5.3", "fails"),  # the contact angle, not the speed, moves the ring further
        ("figure-5.28", "partly"),
        ("figure-5.32", "partly"),
    }


def test_radial_displacement_falls_by_four_fifths(figures: dict[str, Figure]) -> None:
    loads, shift = (column(figures["5.25"], n) for n in ("axial_load", "radial_displacement"))
    fall = 1.0 - shift[loads == 80.0][0] / shift[loads == 20.0][0]
    assert fall == pytest.approx(0.80, abs=0.005)


def test_displacement_is_negative_at_speed_under_little_load(figures: dict[str, Figure]) -> None:
    speed, load, shift = (
        column(figures["5.13"], name)
        for name in ("inner_speed", "axial_load", "axial_displacement")
    )
    assert (shift[(speed == 15000.0) & (load <= 20.0)] < 0.0).all()
    assert (shift[speed == 0.0] >= 0.0).all()


# --- balance, from the data alone -------------------------------------------


def test_load_distribution_carries_the_radial_load(figures: dict[str, Figure]) -> None:
    """Z times the mean of Q cos ψ round the ring is F_r, whatever the clearance."""
    clearance, azimuth, load = (
        column(figures["5.1"], n) for n in ("diametral_clearance", "azimuth", "ball_load")
    )
    for value in (-0.04, 0.0, 0.04):
        rows = (clearance == value) & (azimuth < 180.0)
        carried = 9 * np.mean(load[rows] * np.cos(np.radians(azimuth[rows])))
        assert carried == pytest.approx(8900.0, rel=1e-4)


def test_speeds_and_forces_of_a_ball(figures: dict[str, Figure]) -> None:
    """Textbook forms at one contact angle: n_m = n (1 - γ' cos α)/2, F_c = m d_m ω_m²/2."""
    ratio, diameter, pitch = 12.7 / 65.0, 12.7e-3, 65e-3
    angle, speed = (column(figures["5.7"], n) for n in ("contact_angle", "inner_speed"))
    alpha = np.radians(angle)
    cage = 0.5 * speed * (1.0 - ratio * np.cos(alpha))
    assert column(figures["5.7"], "orbital_speed") == pytest.approx(cage)
    mass = 7810.0 * np.pi / 6.0 * diameter**3
    force = 0.5 * mass * pitch * (cage * np.pi / 30.0) ** 2
    assert column(figures["5.8"], "centrifugal_force") == pytest.approx(force)
    # Rolling on both races: the ball's speed across and along the shaft, seen from the cage.
    across, along = np.sin(alpha), np.cos(alpha) + ratio
    ball = cage / ratio * np.hypot(across, along)
    assert column(figures["5.6"], "ball_speed") == pytest.approx(ball)
    moment = mass * diameter**2 / 10.0 * (np.pi / 30.0) ** 2 * cage**2 / ratio * across
    assert column(figures["5.9"], "gyroscopic_moment") == pytest.approx(moment)


def test_positions_are_those_of_the_table(
    figures: dict[str, Figure], tables: dict[str, Table]
) -> None:
    ball, azimuth = (column(figures["5.10"], name) for name in ("ball", "azimuth"))
    printed = tables["5.3"].columns[1].cells
    assert ball.tolist() == list(range(1, COUNT + 1))
    assert azimuth[:9].tolist() == [float(str(cell)) for cell in printed]
    assert azimuth[9:].tolist() == [-float(str(cell)) for cell in printed[-2:0:-1]]


def test_axial_load_is_carried_by_the_balls(figures: dict[str, Figure]) -> None:
    """With the moment at the outer race, Z Q_i sin α_i is the axial load, at every speed."""
    load, ball = (column(figures["5.12"], name) for name in ("axial_load", "inner_load"))
    angle = np.radians(column(figures["5.11"], "inner_contact_angle"))
    assert COUNT * ball * np.sin(angle) == pytest.approx(load, abs=1e-6)


@pytest.mark.parametrize(
    ("pair", "loads"),
    [
        (("5.15", "5.16"), (15e3, 0.0, 15e3)),
        (("5.17", "5.18"), (15e3, 0.0, 15e3)),
        (("5.19", "5.20"), (15e3, 0.0, 15e3)),
        (("5.21", "5.22"), (20e3, 10e3, 15e3)),
        (("5.23", "5.24"), (20e3, 10e3, 15e3)),
        (("5.27", "5.28"), (20e3, 0.0, 15e3)),
        (("5.29", "5.30"), (20e3, 0.0, 15e3)),
        (("5.31", "5.32"), (20e3, 0.0, 15e3)),
    ],
)
def test_balls_carry_the_loads_of_the_caption(
    figures: dict[str, Figure], pair: tuple[str, str], loads: tuple[float, float, float]
) -> None:
    azimuth, load = at_balls(figures[pair[0]], "azimuth", "inner_load")
    (angle,) = at_balls(figures[pair[1]], "inner_contact_angle")
    psi, alpha = np.radians(azimuth), np.radians(angle)
    radial = load * np.cos(alpha)
    carried = (load * np.sin(alpha)).sum(), radial @ np.sin(psi), radial @ np.cos(psi)
    assert carried == pytest.approx(loads, abs=1e-3)


@pytest.mark.parametrize(("number", "first"), [("5.21", 0.0), ("5.23", 11.0)])
def test_places_of_the_balls(figures: dict[str, Figure], number: str, first: float) -> None:
    azimuth, ball = at_balls(figures[number], "azimuth", "ball")
    expected = first + (ball - 1.0) * 360.0 / COUNT
    assert np.mod(azimuth - expected + 1.0, 360.0) == pytest.approx(np.ones(COUNT))


@pytest.mark.parametrize("number", ["5.15", "5.19", "5.23", "5.31"])
def test_a_turned_cage_joins_ball_to_ball(figures: dict[str, Figure], number: str) -> None:
    """The line through all turns has no steps where one ball hands over to the next."""
    figure = figures[number]
    azimuth = column(figure, "azimuth")
    assert np.diff(azimuth) == pytest.approx(np.full(azimuth.size - 1, 1.5))
    for name in ("inner_load", "outer_load"):
        load = column(figure, name)
        bend = np.diff(np.r_[load, load[:2]], 2)
        assert np.abs(bend).max() < 0.01 * load.max()


def test_the_gyroscopic_moment_left_out_and_the_force_left_out(
    figures: dict[str, Figure],
) -> None:
    """Without F_c and at equal loads only the moment parts the races; without it, only F_c."""
    still, light = figures["5.17"], figures["5.19"]
    azimuth, inner, outer = at_balls(still, "azimuth", "inner_load", "outer_load")
    assert (outer > inner).all()
    azimuth, inner, outer = at_balls(light, "azimuth", "inner_load", "outer_load")
    assert (outer < inner).all()
    assert np.abs(azimuth).max() == 180.0


# --- data -------------------------------------------------------------------


def test_data_hold_all_columns(figures: dict[str, Figure]) -> None:
    for figure in figures.values():
        rows = list(csv.DictReader(io.StringIO(figure_csv(figure))))
        for values in figure.columns:
            written = [row[values.header] for row in rows]
            if values.name == "status":
                assert written == list(values.values)
                continue
            numbers = np.array([float(text) if text else np.nan for text in written])
            assert numbers == pytest.approx(values.numbers, rel=1e-7, abs=1e-7, nan_ok=True)


def test_headers_carry_units(figures: dict[str, Figure]) -> None:
    headers = [c.header for figure in figures.values() for c in figure.columns]
    for header in headers:
        units = ("_deg", "_rpm", "_mm", "_N", "_kN", "_Nm")
        assert header in ("ball", "status") or header.endswith(units), header


def test_table_data_hold_printed_beside_computed(tables: dict[str, Table]) -> None:
    rows = list(csv.DictReader(io.StringIO(table_csv(tables["5.4"]))))
    assert [row["moment_Nm_printed"] for row in rows] == ["769.43", "656.54", "542.85"]
    assert [row["moment_Nm_agreement"] for row in rows] == ["printed"] * 3
    assert float(rows[1]["moment_Nm_computed"]) == pytest.approx(656.54, abs=0.005)


def test_the_gallery_shows_what_the_program_gives(
    figures: dict[str, Figure], tables: dict[str, Table]
) -> None:
    """Else: python -m rolamento reproduce …, as docs/gallery/index.md says."""
    page = (GALLERY / "index.md").read_text(encoding="utf-8")
    names = {"index.md", "index.html", "document.css"} | {
        f"{item.stem}.csv" for item in tables.values()
    }
    for figure in figures.values():
        names |= {f"{figure.stem}.csv", f"{figure.stem}.png"}
        assert f"### Figure {figure.number}\n" in page
        rows = list(csv.reader(io.StringIO((GALLERY / f"{figure.stem}.csv").read_text("utf-8"))))
        assert rows[0] == [values.header for values in figure.columns]
        for place, values in enumerate(figure.columns):
            if values.name != "status":
                shown = [float(row[place] or "nan") for row in rows[1:]]
                near = pytest.approx(values.numbers, rel=1e-5, abs=1e-5, nan_ok=True)
                assert shown == near, (figure.number, values.name)
    assert {path.name for path in GALLERY.iterdir()} == names


def test_lines_name_columns_and_rows_that_exist(figures: dict[str, Figure]) -> None:
    for figure in figures.values():
        if not isinstance(figure.picture, Curves):
            continue
        for panel in figure.picture.panels:
            for line in panel.lines:
                assert figure.column(line.y).values is not None
                if line.by is not None:
                    assert (column(figure, line.by[0]) == line.by[1]).sum() > 10
