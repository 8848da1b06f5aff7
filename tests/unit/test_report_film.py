"""Film and friction in the report: numbers, units, languages; a plain case has neither."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.one_case import said

from rolamento import Analysis, analyse, load_case
from rolamento.document.medium import Medium
from rolamento.document.terminal import terminal
from rolamento.lubrication import film as film_of
from rolamento.pages.state import state_page
from rolamento.solution import solve
from rolamento.words import speaking


@pytest.fixture(scope="module")
def oiled(examples: Path) -> Analysis:
    return analyse(load_case(examples / "6305_film.toml"))


@pytest.fixture(scope="module")
def dry(examples: Path) -> Analysis:
    return analyse(load_case(examples / "ricci_fleury.toml"))


def report(analysis: Analysis, language: str = "en", encoding: str = "utf-8") -> str:
    with speaking(language):
        page = state_page(analysis.solved, analysis)
    return terminal(page, Medium(encoding=encoding))


def test_a_plain_case_has_the_plain_report(examples: Path) -> None:
    case = load_case(examples / "218_combined.toml")
    assert report(analyse(case)) == terminal(state_page(solve(case)))


def test_film_and_friction_come_after_the_balls(oiled: Analysis) -> None:
    text = report(oiled)
    order = [
        text.index(heading)
        for heading in (
            "\nBalls", "\nLubricant film", "\nFilms of the balls", "\nFriction\n",
            "\nFriction torque by model", "\nNotes",
        )
    ]  # fmt: skip
    assert order == sorted(order)


def test_the_film_has_its_numbers_and_units(oiled: Analysis) -> None:
    text = report(oiled)
    film = oiled.film
    assert film is not None
    thinnest = film.thinnest("inner")
    assert thinnest is not None
    (line,) = (line for line in text.splitlines() if "central film thickness h_c" in line)
    label, inner, outer, unit = line.rsplit(maxsplit=3)
    assert float(inner) == pytest.approx(1e6 * film.inner.central_thickness[0, thinnest], abs=6e-4)
    assert float(outer) > float(inner)
    assert (label.strip(), unit) == ("central film thickness h_c", "µm")
    assert f"{1e6 * film.kinematic_viscosity[0]:.1f} mm²/s" in text
    assert "83.4 °C" in text
    assert "inner  partial film; failures to expect: fatigue from inclusions" in text


def test_the_sources_add_up_to_the_torque(dry: Analysis) -> None:
    lines = report(dry).splitlines()
    start = lines.index("Friction")
    table = [line.split() for line in lines[start:]]
    parts = [
        float(cells[-3])
        for cells in table
        if cells[:1] in (["spin"], ["differential"], ["elastic"])
    ]
    (total,) = (float(cells[1]) for cells in table if cells[:1] == ["sum"])
    assert sum(parts) == pytest.approx(total, abs=2e-3)
    assert dry.friction is not None
    assert total == pytest.approx(1e3 * dry.friction.torque[0], abs=6e-4)


def test_a_model_that_does_not_hold_says_why(examples: Path) -> None:
    settings = ["duty.inner_speed=20000 rpm", "duty.load.fx=50 N"]
    text = report(analyse(load_case(examples / "ricci_fleury.toml", settings)))
    assert "no: inertia" in text


def test_friction_control_has_its_line(examples: Path) -> None:
    settings = ["model.raceway_control=friction"]
    analysis = analyse(load_case(examples / "ricci_fleury.toml", settings))
    text = report(analysis)
    (line,) = (line for line in text.splitlines() if line.startswith("  friction control"))
    assert analysis.friction is not None
    # at half a revolution a minute inertia does nothing: Jones's full model without it
    jones = 1e3 * analysis.friction.models["jones_full"].total[0]
    assert float(line.split()[2]) == pytest.approx(jones, rel=0.02)


def test_the_report_speaks_portuguese(oiled: Analysis) -> None:
    text = report(oiled, "pt")
    for words in (
        "Filme lubrificante", "razão de viscosidade κ = 0,889", "filme parcial",
        "Torque de atrito por modelo", "Jones, completo", "histerese elástica",
        "O coeficiente pressão-viscosidade é uma estimativa", "Fora da faixa calculada por Hamrock",
    ):  # fmt: skip
        assert words in text
    for left in ("Friction", "Lubricant", "The pressure", "Outside the"):
        assert left not in text


@pytest.mark.parametrize(
    "settings",
    [
        [],
        ["temperature.lubricant=300 degC"],
        ["temperature.lubricant=-30 degC"],
        ["duty.inner_speed=0 rpm"],
        ["duty.inner_speed=60 rpm"],
        ["duty.inner_speed=25000 rpm", "temperature.lubricant=20 degC"],
        ["film.starvation=inlet_distance", "film.inlet_distance=0.2 mm"],
        ["lubricant.kind=grease"],
    ],
)
def test_every_note_is_said_in_portuguese(examples: Path, settings: list[str]) -> None:
    film = film_of(solve(load_case(examples / "6305_film.toml", settings)))
    assert film.notes_of()
    for note in film.notes_of():
        assert said(note, "pt") != said(note)


def test_notes_of_what_is_missing_are_said_in_portuguese(examples: Path) -> None:
    case = load_case(examples / "218_combined.toml").replace(lubricant="ISO VG 68")
    analysis = analyse(case)
    assert len(analysis.notes) == 1
    text = " ".join(report(analysis, "pt").split())
    assert "Sem filme e sem torque de atrito: a temperatura do lubrificante não foi dada" in text


@pytest.mark.parametrize("language", ["en", "pt"])
@pytest.mark.parametrize("name", ["6305_film.toml", "ricci_fleury.toml"])
@pytest.mark.thirds
def test_the_report_keeps_to_80_columns(examples: Path, language: str, name: str) -> None:
    for settings in ([], ["duty.inner_speed=20000 rpm"], ["duty.inner_speed=0 rpm"]):
        text = report(analyse(load_case(examples / name, settings)), language)
        assert max(map(len, text.splitlines())) <= 80


def test_plain_ascii_will_do(oiled: Analysis) -> None:
    report(oiled, encoding="ascii").encode("ascii")
