"""The lubricant film on the page of a case: the oil, the thinnest films, the films of all balls."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from math import isfinite, nan
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.document import Block, Column, Entry, KeyValues, Section, Statement, Table
from rolamento.geometry import Race
from rolamento.pages.notes import cautions
from rolamento.pages.quantities import Quantity, beside
from rolamento.solved import RACES
from rolamento.words import marked, said, said_in
from rolamento.words.quantities import CALLED

if TYPE_CHECKING:
    from rolamento.lubrication import Film

__all__ = ["FILMS", "film_sections", "regime_name"]

_ZERO: Final = 273.15
"""K, at 0 °C."""
_WHOLE: Final = 0.9995
"""Fraction of a film: a reduction that leaves more is not shown."""
_REGIMES: Final = {
    "full_film": marked("full film"),
    "partial": marked("partial film"),
    "boundary": marked("boundary lubrication"),
    "adhesive": marked("adhesive wear"),
}
_FAILURES: Final = {
    "subsurface_inclusion": marked("fatigue from inclusions"),
    "subsurface_asperity": marked("near-surface fatigue"),
    "surface_micropitting": marked("micropitting"),
    "surface_point": marked("surface-initiated fatigue"),
    "adhesive_mild": marked("mild adhesive wear"),
    "adhesive_severe": marked("severe adhesive wear"),
}


def regime_name(regime: str) -> str:
    """Return what a regime of lubrication is called, by its `Regime.name`."""
    return said(_REGIMES[regime])


def film_sections(film: Film) -> list[Section]:
    """Return the film of a single case: the oil, the thinnest films, and those of the balls."""
    blocks: list[Block] = [*_oil(film), *cautions(film.notes_of())]
    thickness = [_at_thinnest(film, race, "central_thickness") for race in RACES]
    if not any(map(isfinite, thickness)):
        return [Section(said("Lubricant film"), tuple(blocks), "film")]
    if not any(value > 0.0 for value in thickness):
        blocks.append(Statement(said("nothing rotates: no film"), indent=2))
        return [Section(said("Lubricant film"), tuple(blocks), "film")]
    heading = Statement(said("at the contact with the thinnest film"), "faint", indent=2)
    blocks += [heading, _thinnest(film), _regimes(film)]
    return [Section(said("Lubricant film"), tuple(blocks), "film"), _elements(film)]


def _oil(film: Film) -> list[Statement]:
    oil = said(
        "{name} at {temperature:.4 °C}: {kinematic:.3 mm²/s}, {dynamic:.3 mPa·s},"
        " α = {alpha:.3 1/GPa}",
        name=film.lubricant,
        temperature=round(float(film.temperature[0]) - _ZERO, 1) + _ZERO,
        kinematic=float(film.kinematic_viscosity[0]),
        dynamic=float(film.dynamic_viscosity[0]),
        alpha=float(film.pressure_viscosity[0]),
    )
    needed = float(film.reference_viscosity[0])
    if not isfinite(needed):
        return [Statement(oil, indent=2)]
    ratio = said(
        "viscosity ratio κ = {ratio:.3}; required at this speed: {needed:.3 mm²/s}",
        ratio=float(film.viscosity_ratio[0]),
        needed=needed,
    )
    return [Statement(oil, indent=2), Statement(ratio, indent=2)]


def _at_thinnest(film: Film, race: Race, name: str) -> float:
    """A number at the contact of a race with the thinnest film."""
    element = film.thinnest(race)
    return nan if element is None else float(getattr(film.of(race), name)[0, element])


FILMS: Final = (
    ("central_thickness", marked("central film thickness h_c"), ".3 µm"),
    ("minimum_thickness", marked("minimum film thickness h_0"), ".3 µm"),
    ("film_parameter", CALLED["film_parameter"], ".3"),
    ("entrainment_speed", marked("entrainment speed"), ".3 m/s"),
    ("thermal_factor", marked("thermal factor"), ".3 %"),
    ("starvation_factor", marked("starvation factor"), ".3 %"),
)
"""Numbers of the film of a contact: name, label, form."""


def _thinnest(film: Film) -> Table:
    rows: list[Quantity[Race]] = [
        Quantity(said(label), partial(_at_thinnest, film, name=name), form)
        for name, label, form in FILMS
    ]
    shown = [
        row for row in rows
        if row.shown_unit != "%" or any((row.number(race) or 0.0) < _WHOLE for race in RACES)
    ]  # fmt: skip
    heads = {"inner": said_in("race", "inner"), "outer": said_in("race", "outer")}
    label, unit, *values = beside(shown, [(race, heads[race], race) for race in RACES])
    return Table((label, *values, replace(unit, head="")), "thinnest_film")


def _regimes(film: Film) -> KeyValues:
    """Name the regime of each race's thinnest film, and the failures to expect."""
    heads = {"inner": said_in("race", "inner"), "outer": said_in("race", "outer")}
    entries = []
    for race in RACES:
        element = film.thinnest(race)
        regime = "" if element is None else str(film.of(race).regime[0, element])
        if element is None or not regime:
            continue
        expected = film.of(race).expected_failures(0, element)
        text = said(
            "{regime}; failures to expect: {failures}",
            regime=regime_name(regime),
            failures=[said(_FAILURES[failure]) for failure in expected],
        )
        entries.append(Entry(heads[race], text))
    return KeyValues(tuple(entries), 2)


_COLUMNS: Final[tuple[tuple[str, str, Race, str], ...]] = (
    ("h_c,i", "µm", "inner", "central_thickness"),
    ("h_c,o", "µm", "outer", "central_thickness"),
    ("h_0,i", "µm", "inner", "minimum_thickness"),
    ("h_0,o", "µm", "outer", "minimum_thickness"),
    ("λ_i", "–", "inner", "film_parameter"),
    ("λ_o", "–", "outer", "film_parameter"),
)
_ONLY_IN_FILES: Final = (
    ("entrainment_speed", "m/s"),
    ("thermal_factor", ""),
    ("starvation_factor", ""),
)


def _elements(film: Film) -> Section:
    """Show the films of all rolling elements, the minimum of each column marked."""
    count = film.azimuth.shape[1]
    columns = [
        Column("#", list(range(count)), "ball", tone="faint"),
        Column("ψ", film.azimuth[0].tolist(), "azimuth", "°", figures=5),
    ]
    for symbol, unit, race, name in _COLUMNS:
        values = getattr(film.of(race), name)[0]
        if np.isfinite(values).any():
            columns.append(
                Column(
                    symbol,
                    values.tolist(),
                    f"{race}_{name}",
                    unit,
                    figures=3,
                    most=4,
                    peak="minimum",
                )
            )
    columns += [
        Column(
            name,
            getattr(film.of(race), name)[0].tolist(),
            f"{race}_{name}",
            unit,
            only_in_files=True,
        )
        for race in RACES
        for name, unit in _ONLY_IN_FILES
    ]
    legend = said(
        "h_c central film, h_0 minimum film, λ = h_c over the combined Rq; i inner, o outer;"
        " ◂ minimum"
    )
    table = Table(tuple(columns), "films", legends=(legend,), rule=True)
    return Section(_whose(film), (table,), "films")


def _whose(film: Film) -> str:
    kinds = {place.bearing.element for place in film.case.bearing.places}
    if kinds == {"ball"}:
        return said("Films of the balls")
    if "ball" in kinds:
        return said("Films of the rolling elements")
    return said("Films of the rollers")
