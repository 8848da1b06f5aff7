"""The film of one state."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np

from rolamento.lubrication.contact_film import ContactFilms
from rolamento.lubrication.notes import notes_on
from rolamento.lubrication.record import BallFilm, ContactFilm, Film
from rolamento.lubrication.regime import regime_of
from rolamento.lubrication.running import balls_of_state
from rolamento.lubrication.table import film_table, lubricant_of, lubricant_temperature_of
from rolamento.state import State


def film_of(state: State) -> Film:
    """Lubricant film of a state whose case has a lubricant and its temperature.

    Raises
    ------
    InputError
        If the case has no lubricant, or no temperature of it.
    """
    case = state.case
    lubricant = lubricant_of(case)
    temperature = np.array([lubricant_temperature_of(case)])
    table = film_table(case, lubricant, balls_of_state(state), temperature)
    oil, count = table.oil, len(state.balls)
    inner, outer = _contact_films(table.inner, count), _contact_films(table.outer, count)
    film = Film(
        lubricant=lubricant.name,
        temperature=float(oil.temperature[0]),
        kinematic_viscosity=float(oil.kinematic_viscosity[0]),
        dynamic_viscosity=float(oil.dynamic_viscosity[0]),
        density=float(oil.density[0]),
        pressure_viscosity=float(oil.pressure_viscosity[0]),
        reference_viscosity=float(table.reference_viscosity[0]),
        viscosity_ratio=float(table.viscosity_ratio[0]),
        balls=tuple(
            BallFilm(ball.row, ball.azimuth, *films)
            for ball, films in zip(state.balls, zip(inner, outer, strict=True), strict=True)
        ),
    )
    return replace(film, notes=tuple(notes_on(film, case)))


def _contact_films(films: ContactFilms, count: int) -> list[ContactFilm]:
    """Return the contacts of the first case's balls with one race."""
    names = [field.name for field in fields(ContactFilms)]
    columns = [getattr(films, name)[0] for name in names]
    found = []
    for index in range(count):
        values = {name: float(column[index]) for name, column in zip(names, columns, strict=True)}
        regime = regime_of(values["film_parameter"])
        expected = () if regime is None else tuple(mode.name for mode in regime.expects)
        found.append(
            ContactFilm(**values, regime=regime.name if regime else "", expected_failures=expected)
        )
    return found
