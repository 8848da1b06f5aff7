"""The lubricant film in the report: the oil, the thinnest films, the films of every ball."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import degrees, isfinite, nan
from typing import Final

from rich.text import Text

from rolamento.lubrication.record import BallFilm, ContactFilm, Film
from rolamento.report.film_sentences import said_note
from rolamento.report.page import Lines, Page

__all__ = ["film_notes", "film_parts"]


@dataclass(frozen=True, slots=True)
class _Words:
    film: str
    oil: str
    ratio: str
    at_rest: str
    thinnest: str
    central: str
    minimum: str
    parameter: str
    entrainment: str
    heat: str
    starvation: str
    regime: str
    regimes: Mapping[str, str]
    expected: str
    failures: Mapping[str, str]
    balls: str
    legend: str


_WORDS: Final[Mapping[str, _Words]] = {
    "en": _Words(
        film="Lubricant film",
        oil="{name} at {temperature}: {kinematic} mm²/s, {dynamic} mPa·s, α = {alpha} 1/GPa",
        ratio="viscosity ratio κ = {ratio}; the bearing needs {needed} mm²/s at this speed",
        at_rest="nothing turns: no film",
        thinnest="at the contact with the thinnest film",
        central="central film h_c",
        minimum="minimum film h_0",
        parameter="film parameter λ",
        entrainment="entrainment speed",
        heat="left by inlet heat",
        starvation="left by starvation",
        regime="regime",
        regimes={
            "full_film": "full film",
            "partial": "partial film",
            "boundary": "boundary",
            "adhesive": "adhesive wear",
        },
        expected="failures to expect",
        failures={
            "subsurface_inclusion": "fatigue from inclusions",
            "subsurface_asperity": "fatigue from near the surface",
            "surface_micropitting": "micropitting",
            "surface_point": "fatigue from surface points",
            "adhesive_mild": "mild adhesive wear",
            "adhesive_severe": "severe adhesive wear",
        },
        balls="Films of the balls",
        legend=(
            "h_c central, h_0 minimum film, λ = h_c over the combined Rq; i inner, o outer; ◂ least"
        ),
    ),
    "pt": _Words(
        film="Filme lubrificante",
        oil="{name} a {temperature}: {kinematic} mm²/s, {dynamic} mPa·s, α = {alpha} 1/GPa",
        ratio="razão de viscosidade κ = {ratio}; o rolamento precisa de {needed} mm²/s a esta"
        " rotação",
        at_rest="nada gira: não há filme",
        thinnest="no contato de filme mais fino",
        central="filme central h_c",
        minimum="filme mínimo h_0",
        parameter="parâmetro de filme λ",
        entrainment="velocidade de arraste",
        heat="resta após o calor",
        starvation="resta após a falta de óleo",
        regime="regime",
        regimes={
            "full_film": "filme completo",
            "partial": "filme parcial",
            "boundary": "limítrofe",
            "adhesive": "desgaste adesivo",
        },
        expected="falhas esperadas",
        failures={
            "subsurface_inclusion": "fadiga a partir de inclusões",
            "subsurface_asperity": "fadiga perto da superfície",
            "surface_micropitting": "micropitting",
            "surface_point": "fadiga de pontos da superfície",
            "adhesive_mild": "desgaste adesivo leve",
            "adhesive_severe": "desgaste adesivo severo",
        },
        balls="Filmes das esferas",
        legend=(
            "h_c filme central, h_0 mínimo, λ = h_c sobre a Rq combinada; i interno, o externo;"
            " ◂ menor"
        ),
    ),
}

_ZERO_CELSIUS: Final = 273.15
_WHOLE: Final = 0.9995
"""Of a film: what a reduction must leave less of to be shown."""


def film_parts(page: Page, film: Film) -> list[Lines]:
    """Show the film: the oil, the thinnest films, and the balls where anything turns."""
    said = _words(page)
    thinnest = [film.thinnest("inner"), film.thinnest("outer")]
    lines = [page.heading(said.film), *_oil(page, said, film)]
    known = [contact for contact in thinnest if contact is not None]
    if not any(contact.central_thickness > 0.0 for contact in known):
        return [lines + page.hanging(Text("  "), said.at_rest)] if known else [lines]
    return [lines + _thinnest(page, said, thinnest), _balls(page, said, film)]


def film_notes(page: Page, film: Film) -> list[str]:
    """Return what is to be known of a film, in the page's language."""
    return [said_note(note, page.words.code) for note in film.notes]


def _words(page: Page) -> _Words:
    return _WORDS.get(page.words.code, _WORDS["en"])


def _oil(page: Page, said: _Words, film: Film) -> Lines:
    short = page.digits.short
    oil = said.oil.format(
        name=film.lubricant,
        temperature=f"{short(round(film.temperature - _ZERO_CELSIUS, 1), 4)} °C",
        kinematic=short(1e6 * film.kinematic_viscosity, 3),
        dynamic=short(1e3 * film.dynamic_viscosity, 3),
        alpha=short(1e9 * film.pressure_viscosity, 3),
    )
    lines = page.hanging(Text("  "), oil)
    if isfinite(film.reference_viscosity):
        ratio = said.ratio.format(
            ratio=short(film.viscosity_ratio, 3), needed=short(1e6 * film.reference_viscosity, 3)
        )
        lines += page.hanging(Text("  "), ratio)
    return lines


def _thinnest(page: Page, said: _Words, contacts: list[ContactFilm | None]) -> Lines:
    def column(label: str, name: str, factor: float, unit: str, digits: int = 3) -> list[Text]:
        values = [nan if c is None else factor * getattr(c, name) for c in contacts]
        cells = (page.text(page.digits.short(value, digits)) for value in values)
        return [page.text(label), *cells, page.text(unit)]

    heads = ["", page.words.inner, page.words.outer, ""]
    rows = [
        [page.text(head, "dim") for head in heads],
        column(said.central, "central_thickness", 1e6, "µm"),
        column(said.minimum, "minimum_thickness", 1e6, "µm"),
        column(said.parameter, "film_parameter", 1.0, ""),
        column(said.entrainment, "entrainment_speed", 1.0, "m/s"),
    ]
    known = [contact for contact in contacts if contact is not None]
    for label, name in ((said.heat, "thermal_factor"), (said.starvation, "starvation_factor")):
        if any(getattr(contact, name) < _WHOLE for contact in known):
            rows.append(column(label, name, 1e2, "%"))
    lines = [page.text(f"  {said.thinnest}", "dim"), *page.columns(rows, "lrrl")]
    return lines + _regimes(page, said, contacts)


def _regimes(page: Page, said: _Words, contacts: list[ContactFilm | None]) -> Lines:
    """Name the regime of each race's thinnest film, and what failures it lets expect."""
    lines: Lines = []
    for race, contact in zip((page.words.inner, page.words.outer), contacts, strict=True):
        if contact is None or not contact.regime:
            continue
        failures = ", ".join(said.failures.get(f, f) for f in contact.expected_failures)
        text = f"{said.regimes.get(contact.regime, contact.regime)}; {said.expected}: {failures}"
        lines += page.hanging(page.text(f"  {race}: ", "dim"), text)
    return lines


_COLUMNS: Final[tuple[tuple[str, str, Callable[[BallFilm], float], int], ...]] = (
    ("h_c,i", "µm", lambda ball: 1e6 * ball.inner.central_thickness, 3),
    ("h_c,o", "µm", lambda ball: 1e6 * ball.outer.central_thickness, 3),
    ("h_0,i", "µm", lambda ball: 1e6 * ball.inner.minimum_thickness, 3),
    ("h_0,o", "µm", lambda ball: 1e6 * ball.outer.minimum_thickness, 3),
    ("λ_i", "–", lambda ball: ball.inner.film_parameter, 3),
    ("λ_o", "–", lambda ball: ball.outer.film_parameter, 3),
)


def _balls(page: Page, said: _Words, film: Film) -> Lines:
    """Set the films of all balls in a table, the least of each column marked."""
    numbers = [Text(), Text("#"), *(Text(str(j), "dim") for j in range(len(film.balls)))]
    azimuths = page.digits.column([degrees(ball.azimuth) for ball in film.balls], 5, 2)
    columns = [numbers, [page.text("ψ"), page.text("°", "dim"), *map(page.text, azimuths)]]
    for symbol, unit, of, digits in _COLUMNS:
        values = [of(ball) for ball in film.balls]
        if not any(map(isfinite, values)):
            continue
        least = min(value for value in values if isfinite(value))
        cells = page.digits.column(values, digits)
        head = [page.text(f"{symbol} "), page.text(f"{unit} ", "dim")]
        columns.append(
            head + [_marked(page, c, v == least) for c, v in zip(cells, values, strict=True)]
        )
    rows = list(zip(*columns, strict=True))
    table = page.columns(rows, "r" * len(columns))
    rule = page.rule(max(map(len, table)))
    legend = page.hanging(Text("  "), said.legend, "dim")
    return [page.heading(said.balls), *table[:2], rule, *table[2:], *legend]


def _marked(page: Page, text: str, least: bool) -> Text:
    return page.text(text + ("◂" if least else " "), "bold magenta" if least else "")
