"""Friction-controlled balls on a lubricant film: the film shears, and may enter the geometry.

A film of thickness h between the contact and its ball resists a slip v with the shear stress
η v / h, up to the limiting stress μ p; joined smoothly, τ = μ p v / √(v² + v₀²) with
v₀ = μ p h / η(p), η by Roelands. The film depends on the motion and the loads that it
brings about: both are found in turn.

Johnson and Tevaarwerk (1977), Newtonian shear with a limiting stress; Radaelli (2013), section 6,
which asks for the film in the balance of the balls.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from rolamento import system
from rolamento.lubrication.films import film
from rolamento.numerics import BoolArray, FloatArray
from rolamento.oil import roelands
from rolamento.records import frozen
from rolamento.solved import Solved
from rolamento.system import Balanced, Cases, solve_cases

PASSES: Final = 25
SAME: Final = 1e-6
"""Relative change of the films at which they no longer change."""


@frozen
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


def solved_on_film(cases: Cases) -> Solved:
    """Solve cases whose model wants the film in the balance of the balls.

    A case whose film still changes after `PASSES` solutions has no result.
    """
    balanced, settled, _ = balanced_on_film(cases)
    return system.result(cases, balanced.without(~settled))


def balanced_on_film(cases: Cases) -> tuple[Balanced, BoolArray, ShearedFilm]:
    """The last balance, which cases have settled, and the film that they were balanced with."""
    after = _film_felt(cases, solve_cases(cases))
    for _ in range(PASSES):
        before, balanced = after, system.balance(cases, after)
        after = _film_felt(cases, system.result(cases, balanced))
        moved = np.abs(after.thickness - before.thickness).max(axis=(1, 2), initial=0.0)
        settled = ~(moved > SAME * after.thickness.max(axis=(1, 2), initial=0.0))
        if settled.all():
            break
    return balanced, settled, before


def _film_felt(cases: Cases, solved: Solved) -> ShearedFilm:
    """The films that a solution brings about."""
    films, model = film(solved), cases.case.model
    thickness = [films.inner.central_thickness, films.outer.central_thickness]
    pressure = [solved.inner.max_pressure, solved.outer.max_pressure]
    return ShearedFilm(
        thickness=np.nan_to_num(np.stack(thickness, axis=-1)),
        pressure=np.nan_to_num(np.stack(pressure, axis=-1)),
        friction=cases.traction.friction,
        viscosity=films.dynamic_viscosity,
        pressure_viscosity=films.pressure_viscosity,
        shears=model.traction == "film",
        lifts=model.film_in_contact,
    )
