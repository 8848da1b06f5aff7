"""Friction-controlled balls on a lubricant film: the film shears, and may enter the geometry.

A film of thickness h between the contact and its ball resists a slip v with the shear stress
η v / h, up to the limiting stress μ p; joined smoothly, τ = μ p v / √(v² + v₀²) with
v₀ = μ p h / η(p), η by Roelands. The film depends on the motion and the loads that it
brings about: both are found in turn.

Johnson and Tevaarwerk (1977), Newtonian shear with a limiting stress; Radaelli (2013), section 6,
which asks for the film in the balance of the balls.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from rolamento import assembly
from rolamento.assembly import Cases, solve_cases
from rolamento.case import Case
from rolamento.lubrication.running import running_balls
from rolamento.lubrication.table import (
    FilmTable,
    film_of_batch,
    film_table,
    lubricant_of,
    lubricant_temperature_of,
)
from rolamento.numerics import BoolArray, FloatArray
from rolamento.oil.piezoviscosity import roelands
from rolamento.rows.ball import BatchState
from rolamento.rows.ball.assemble import solve_columns_of
from rolamento.rows.ball.columns import Columns
from rolamento.solved import Solved
from rolamento.status import CONVERGED, NOT_CONVERGED

PASSES: Final = 25
SAME: Final = 1e-6
"""Relative change of the films at which they no longer change."""


@dataclass(frozen=True, slots=True)
class ShearedFilm:
    """The films of a batch as the balls feel them; arrays (cases, balls, 2), inner race first."""

    thickness: FloatArray
    pressure: FloatArray
    friction: FloatArray
    viscosity: FloatArray
    pressure_viscosity: FloatArray
    shears: bool
    lifts: bool

    @property
    def lift(self) -> FloatArray:
        """The thickness where it enters the geometry; (cases, balls, 2), m."""
        return self.thickness if self.lifts else np.zeros_like(self.thickness)

    def slip_speed(self, case: int, across: FloatArray, along: FloatArray) -> FloatArray:
        """The slip v₀ at every node of the ellipses of a case; (balls, 2, nodes), m/s."""
        shape = (*self.thickness.shape[1:], across.size)
        if not self.shears:
            return np.zeros(shape)
        height = np.sqrt(np.maximum(1.0 - across**2 - along**2, 0.0))
        pressure = self.pressure[case, ..., np.newaxis] * height
        viscosity = roelands(pressure, self.viscosity[case], self.pressure_viscosity[case])
        gap = self.thickness[case, ..., np.newaxis]
        return np.asarray(self.friction[case] * pressure * gap / viscosity)


def solve_on_film(case: Case, columns: Columns, *, threads: int | None = None) -> BatchState:
    """Solve columns of a case whose model wants the film in the balance of the balls.

    A case whose film still changes after `PASSES` solutions has no result.
    """
    batch = solve_columns_of(columns, threads=threads)
    before = _sheared(case, columns, batch)
    for _ in range(PASSES):
        batch = solve_columns_of(columns, threads=threads, film=before)
        after = _sheared(case, columns, batch)
        moved = np.abs(after.thickness - before.thickness).max(axis=(1, 2), initial=0.0)
        size = after.thickness.max(axis=(1, 2), initial=0.0)
        before = after
        settled = ~(moved > SAME * size)
        if settled.all():
            break
    batch.code[~settled & (batch.code == CONVERGED)] = NOT_CONVERGED
    _forget(batch, batch.code != CONVERGED)
    return batch


def _forget(batch: BatchState, failed: BoolArray) -> None:
    """Leave cases without any number: the ring's, and every row's."""
    arrays = [batch.displacement, batch.load, batch.stiffness]
    for row in batch.rows:
        arrays += [row.displacement, row.load, row.position]
        if row.rolling is not None:
            row.rolling.forget(failed)
    for array in arrays:
        array[failed] = np.nan


def _sheared(case: Case, columns: Columns, batch: BatchState) -> ShearedFilm:
    """The films that a solution brings about."""
    films = film_of_batch(case, batch)
    contacts = [batch.contact("inner"), batch.contact("outer")]
    pressure = np.stack([contact.max_pressure for contact in contacts], axis=-1)
    return ShearedFilm(
        thickness=np.nan_to_num(_thickness(films)),
        pressure=np.nan_to_num(pressure),
        friction=columns.friction,
        viscosity=films.oil.dynamic_viscosity,
        pressure_viscosity=films.oil.pressure_viscosity,
        shears=case.model.traction == "film",
        lifts=case.model.film_in_contact,
    )


def _thickness(films: FilmTable) -> FloatArray:
    """Central film at both races; (cases, balls, 2)."""
    return np.stack([films.inner.central_thickness, films.outer.central_thickness], axis=-1)


def solved_on_film(cases: Cases) -> Solved:
    """Solve cases whose model wants the film in the balance of the balls.

    A case whose film still changes after `PASSES` solutions has no result.
    """
    before = _film_felt(cases, solve_cases(cases))
    for _ in range(PASSES):
        balanced = assembly.balance(cases, before)
        after = _film_felt(cases, assembly.result(cases, balanced))
        moved = np.abs(after.thickness - before.thickness).max(axis=(1, 2), initial=0.0)
        size = after.thickness.max(axis=(1, 2), initial=0.0)
        before = after
        settled = ~(moved > SAME * size)
        if settled.all():
            break
    return assembly.result(cases, balanced.without(~settled))


def _film_felt(cases: Cases, solved: Solved) -> ShearedFilm:
    """The films that a solution brings about."""
    case = cases.case
    temperature = np.full(len(solved), lubricant_temperature_of(case))
    films = film_table(case, lubricant_of(case), running_balls(solved), temperature)
    contacts = solved.contacts.values()
    return ShearedFilm(
        thickness=np.nan_to_num(_thickness(films)),
        pressure=np.nan_to_num(np.stack([c.max_pressure for c in contacts], axis=-1)),
        friction=cases.traction.friction,
        viscosity=films.oil.dynamic_viscosity,
        pressure_viscosity=films.oil.pressure_viscosity,
        shears=case.model.traction == "film",
        lifts=case.model.film_in_contact,
    )
