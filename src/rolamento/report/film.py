"""The lubricant film in the report: the oil, the thinnest films, the films of every ball."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite, nan
from typing import Final

import numpy as np
from rich.text import Text

from rolamento.geometry import Race
from rolamento.lubrication import Film
from rolamento.report.page import Lines, Page
from rolamento.solved import RACES

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
    """Show the film of a single case: the oil, the thinnest films, and those of the balls."""
    said = _words(page)
    lines = [page.heading(said.film), *_oil(page, said, film)]
    thickness = [_at_thinnest(film, race, "central_thickness") for race in RACES]
    if not any(map(isfinite, thickness)):
        return [lines]
    if not any(value > 0.0 for value in thickness):
        return [lines + page.hanging(Text("  "), said.at_rest)]
    return [lines + _thinnest(page, said, film), _balls(page, said, film)]


def film_notes(page: Page, film: Film) -> list[str]:
    """Return what is to be known of the film of a single case, in the page's language."""
    return [page.words.note(note) for note in film.notes_of()]


def _words(page: Page) -> _Words:
    return _WORDS.get(page.words.code, _WORDS["en"])


def _oil(page: Page, said: _Words, film: Film) -> Lines:
    short = page.digits.short
    oil = said.oil.format(
        name=film.lubricant,
        temperature=f"{short(round(float(film.temperature[0]) - _ZERO_CELSIUS, 1), 4)} °C",
        kinematic=short(1e6 * film.kinematic_viscosity[0], 3),
        dynamic=short(1e3 * film.dynamic_viscosity[0], 3),
        alpha=short(1e9 * film.pressure_viscosity[0], 3),
    )
    lines = page.hanging(Text("  "), oil)
    needed = float(film.reference_viscosity[0])
    if isfinite(needed):
        ratio = said.ratio.format(
            ratio=short(film.viscosity_ratio[0], 3), needed=short(1e6 * needed, 3)
        )
        lines += page.hanging(Text("  "), ratio)
    return lines


def _at_thinnest(film: Film, race: Race, name: str) -> float:
    """A number at the contact of a race with the thinnest film."""
    element = film.thinnest(race)
    return nan if element is None else float(getattr(film.of(race), name)[0, element])


def _thinnest(page: Page, said: _Words, film: Film) -> Lines:
    rows = [[page.text(head, "dim") for head in ("", page.words.inner, page.words.outer, "")]]
    for label, name, factor, unit in (
        (said.central, "central_thickness", 1e6, "µm"),
        (said.minimum, "minimum_thickness", 1e6, "µm"),
        (said.parameter, "film_parameter", 1.0, ""),
        (said.entrainment, "entrainment_speed", 1.0, "m/s"),
        (said.heat, "thermal_factor", 1e2, "%"),
        (said.starvation, "starvation_factor", 1e2, "%"),
    ):
        values = [_at_thinnest(film, race, name) for race in RACES]
        if unit == "%" and not any(value < _WHOLE for value in values):
            continue
        cells = (page.text(page.digits.short(factor * value, 3)) for value in values)
        rows.append([page.text(label), *cells, page.text(unit)])
    lines = [page.text(f"  {said.thinnest}", "dim"), *page.columns(rows, "lrrl")]
    return lines + _regimes(page, said, film)


def _regimes(page: Page, said: _Words, film: Film) -> Lines:
    """Name the regime of each race's thinnest film, and what failures it lets expect."""
    lines: Lines = []
    for name, race in zip((page.words.inner, page.words.outer), RACES, strict=True):
        element = film.thinnest(race)
        regime = "" if element is None else str(film.of(race).regime[0, element])
        if element is None or not regime:
            continue
        expected = film.of(race).expected_failures(0, element)
        failures = ", ".join(said.failures.get(f, f) for f in expected)
        text = f"{said.regimes.get(regime, regime)}; {said.expected}: {failures}"
        lines += page.hanging(page.text(f"  {name}: ", "dim"), text)
    return lines


_COLUMNS: Final[tuple[tuple[str, str, Race, str, float], ...]] = (
    ("h_c,i", "µm", "inner", "central_thickness", 1e6),
    ("h_c,o", "µm", "outer", "central_thickness", 1e6),
    ("h_0,i", "µm", "inner", "minimum_thickness", 1e6),
    ("h_0,o", "µm", "outer", "minimum_thickness", 1e6),
    ("λ_i", "–", "inner", "film_parameter", 1.0),
    ("λ_o", "–", "outer", "film_parameter", 1.0),
)


def _balls(page: Page, said: _Words, film: Film) -> Lines:
    """Set the films of all balls in a table, the minimum of each column marked."""
    azimuth = np.degrees(film.azimuth[0])
    numbers = [Text(), Text("#"), *(Text(str(j), "dim") for j in range(len(azimuth)))]
    azimuths = page.digits.column(azimuth.tolist(), 5, 2)
    columns = [numbers, [page.text("ψ"), page.text("°", "dim"), *map(page.text, azimuths)]]
    for symbol, unit, race, name, factor in _COLUMNS:
        values = factor * getattr(film.of(race), name)[0]
        if not np.isfinite(values).any():
            continue
        minimum = np.nanmin(values[np.isfinite(values)])
        cells = page.digits.column(values.tolist(), 3)
        head = [page.text(f"{symbol} "), page.text(f"{unit} ", "dim")]
        columns.append(
            head
            + [_marked(page, c, v == minimum) for c, v in zip(cells, values.tolist(), strict=True)]
        )
    rows = list(zip(*columns, strict=True))
    table = page.columns(rows, "r" * len(columns))
    rule = page.rule(max(map(len, table)))
    legend = page.hanging(Text("  "), said.legend, "dim")
    return [page.heading(said.balls), *table[:2], rule, *table[2:], *legend]


def _marked(page: Page, text: str, minimum: bool) -> Text:
    return page.text(text + ("◂" if minimum else " "), "bold magenta" if minimum else "")
