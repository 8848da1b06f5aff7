"""The films of a batch: arrays over cases and balls."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, fields
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.case.film_model import FilmModel
from rolamento.case.lubricant import Lubricant
from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.lubrication.contact_film import ContactFilms, contact_films
from rolamento.lubrication.film_thickness import replenishment
from rolamento.lubrication.oil_state import OilState, oil_state, reference_viscosity
from rolamento.lubrication.running import (
    RunningBalls,
    RunningContacts,
    balls_of_batch,
    part,
)
from rolamento.numerics import FloatArray
from rolamento.numerics.masked import filled
from rolamento.numerics.threads import thread_count
from rolamento.rows.ball import BatchState

BLOCK: Final = 4096
"""Cases at a time."""


@dataclass(frozen=True, slots=True)
class FilmTable:
    """The films of a batch.

    Attributes
    ----------
    inner, outer
        `ContactFilms` of each race, (cases, balls); NaN where a case has no result or a ball does
        not touch the race
    oil
        the `OilState` of each case, (cases,); NaN for dry lubrication
    reference_viscosity
        (cases,), ν_1 of the row that needs most (m²/s); infinite at rest
    viscosity_ratio
        (cases,), κ = ν/ν_1
    """

    inner: ContactFilms
    outer: ContactFilms
    oil: OilState
    reference_viscosity: FloatArray
    viscosity_ratio: FloatArray


def film_of_batch(
    case: Case,
    batch: BatchState,
    *,
    lubricant_temperature: ArrayLike | None = None,
    threads: int | None = None,
) -> FilmTable:
    """Films of all contacts of a batch.

    Parameters
    ----------
    case
        Supplies lubricant, temperature, surface and film model; the one that was solved.
    batch
        From `solve_batch`.
    lubricant_temperature
        A number or an array (cases,) in the place of the case's; K.
    threads
        As many as there are processors by default.

    Raises
    ------
    InputError
        If the case has no lubricant, or no temperature is given.
    """
    lubricant = lubricant_of(case)
    temperature = _temperatures(case, lubricant_temperature, len(batch))

    def films(first: int) -> FilmTable:
        some = slice(first, first + BLOCK)
        return film_table(case, lubricant, balls_of_batch(part(batch, some)), temperature[some])

    # blocks that stay near the processor; NumPy lets the threads run side by side
    blocks = range(0, max(len(batch), 1), BLOCK)
    if len(blocks) == 1:
        return films(0)
    with ThreadPoolExecutor(thread_count(threads)) as pool:
        whole: FilmTable = _stacked(list(pool.map(films, blocks)))
    return whole


def film_table(
    case: Case, lubricant: Lubricant, balls: RunningBalls, temperature: FloatArray
) -> FilmTable:
    """Films of running balls (cases, balls) with the lubricant at a temperature (cases,), K."""
    oil = _oil_at(lubricant, temperature)
    columns = oil.columns()
    model = case.film or FilmModel()
    refill = _refill(case, model, columns, balls)

    def films(race: Race, contacts: RunningContacts) -> ContactFilms:
        roughness = combined_roughness(case, race)
        return contact_films(contacts, balls.modulus, columns, model, refill, roughness)

    needed = reference_viscosity(balls.speed, balls.pitch_diameter).max(axis=1, initial=0.0)
    return FilmTable(
        inner=films("inner", balls.inner),
        outer=films("outer", balls.outer),
        oil=oil,
        reference_viscosity=np.asarray(needed),
        viscosity_ratio=np.asarray(oil.kinematic_viscosity / needed),
    )


def _stacked(parts: list[Any]) -> Any:
    """Join records of arrays along the cases; a plain number is the same in all."""
    first = parts[0]
    if isinstance(first, np.ndarray):
        return np.concatenate(parts)
    if isinstance(first, float):
        return first
    names = (field.name for field in fields(first))
    return type(first)(*(_stacked([getattr(record, name) for record in parts]) for name in names))


def combined_roughness(case: Case, race: Race) -> float:
    """Root mean square roughness of ball and race together, in m; NaN if not given."""
    if case.surface is None:
        return float("nan")
    return case.surface.inner_combined if race == "inner" else case.surface.outer_combined


def lubricant_of(case: Case) -> Lubricant:
    """Return the lubricant of a case.

    Raises
    ------
    InputError
        If it has none.
    """
    if case.lubricant is None:
        raise InputError(
            "is missing: without a lubricant or a coefficient of friction there is no film and no"
            " friction",
            field="lubricant",
            example='lubricant = "ISO VG 68"',
        )
    return case.lubricant


def lubricant_temperature_of(case: Case) -> float:
    """Return the temperature of a case's lubricant, in K.

    Raises
    ------
    InputError
        If none is given.
    """
    if case.lubricant_temperature is None:
        raise InputError(
            "is missing: the film needs the lubricant's temperature",
            field="temperature.lubricant",
            example='[temperature] with lubricant = "70 degC"',
        )
    return case.lubricant_temperature


def _oil_at(lubricant: Lubricant, temperature: FloatArray) -> OilState:
    """Return an oil's state, all NaN for dry lubrication."""
    if lubricant.kind != "dry":
        return oil_state(lubricant, temperature)
    nothing = np.full_like(temperature, np.nan)
    return OilState(temperature, nothing, nothing, nothing, nothing, nothing, float("nan"))


def _refill(case: Case, model: FilmModel, oil: OilState, balls: RunningBalls) -> FloatArray:
    """Return the factor of replenishment, (cases, 1); 1 where it does not apply."""
    if model.starvation != "replenishment":
        return np.ones_like(oil.kinematic_viscosity)
    assert model.supply is not None
    assert model.bore is not None
    assert model.outside_diameter is not None
    return replenishment(
        oil.kinematic_viscosity,
        balls.speed[:, :1],
        model.bore,
        model.outside_diameter,
        model.supply,
        angular_contact=case.bearing.contact_angle is not None,
    )


def _temperatures(case: Case, given: ArrayLike | None, cases: int) -> FloatArray:
    """Return the lubricant's temperature of each case, (cases,)."""
    if given is None:
        return np.full(cases, lubricant_temperature_of(case))
    array = filled(given)
    if array.shape not in ((), (cases,)) or not np.all(array > 0.0):
        raise InputError(
            f"must be one temperature in K, or one for each of the {cases} cases",
            field="lubricant_temperature",
            example="lubricant_temperature=343.15",
        )
    return np.broadcast_to(array, (cases,)).astype(np.float64)
