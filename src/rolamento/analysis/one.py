"""A case, solved and analysed."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import isfinite
from typing import TYPE_CHECKING, Any, Final

from rolamento.analysis.machine import machine_of
from rolamento.analysis.mapping import friction_mapping
from rolamento.analysis.needs import coefficient, has_film, has_friction, has_life, missing
from rolamento.case import Case
from rolamento.errors import InputError
from rolamento.state import State

if TYPE_CHECKING:
    from rolamento.friction import Friction
    from rolamento.life import LifeConditions, LifeSummary
    from rolamento.lubrication import Film
    from rolamento.vibration.frequencies import FaultFrequencies

DEFAULT_HYSTERESIS: Final = 0.01
"""Part α_h of the elastic work that the material loses."""

NOTES: Final[Mapping[str, str]] = {
    "no_temperature": (
        "No film: the lubricant's temperature is not given (temperature.lubricant)."
    ),
    "no_coefficient": (
        "No friction: the lubricant's coefficient of friction is not given"
        " (lubricant.friction_coefficient)."
    ),
    "life_of_thrust_bearing": (
        "No life: the theories here are for radial bearings, with a contact angle up to 45°."
    ),
    "life_without_rating": (
        "No life: the geometry lies outside the standard's table (D cos α/d_m from 0.01 to 0.40),"
        " and no dynamic rating is given (life.dynamic_rating)."
    ),
    "l_able_without_viscosity": (
        "No L_able: the viscosity ratio is not known; it needs a lubricant with its temperature, or"
        " life.viscosity_ratio."
    ),
}
"""Why a part is missing, by name."""


@dataclass(frozen=True, slots=True, eq=False)
class Analysis:
    """A state and what follows from it.

    Attributes
    ----------
    state
        of `rolamento.solve`
    film
        of the lubricant; None without oil or grease, its temperature, or a result
    friction
        torque, power and heat, arrays of one case; None without a coefficient of friction or a
        result
    life
        by every theory that the case allows, arrays of one case; None if the case has neither a
        designation nor a [life] table, or no result
    notes
        names in `NOTES`: why a part is missing that the case seems to ask for
    """

    state: State
    film: Film | None = None
    friction: Friction | None = None
    life: LifeSummary | None = None
    notes: tuple[str, ...] = ()

    @property
    def frequencies(self) -> FaultFrequencies | None:
        """Fault frequencies under load; None without a result, or where nothing turns."""
        duty = self.state.case.duty
        if not self.state.status.converged or duty.inner_speed == duty.outer_speed:
            return None
        from rolamento.solving import solve
        from rolamento.vibration.frequencies import frequencies_of

        return frequencies_of(solve(self.state.case))

    @property
    def sentences(self) -> tuple[str, ...]:
        """The notes in words."""
        return tuple(NOTES[name] for name in self.notes)

    def to_mapping(self) -> dict[str, Any]:
        """Give the state's mapping with "film", "friction", "life", "frequencies"; None without."""
        mapping = self.state.to_mapping()
        film = None if self.film is None else self.film.to_mapping()
        friction = None if self.friction is None else friction_mapping(self.state, self.friction)
        notes = [*mapping.pop("notes"), *self.sentences]
        case = mapping.pop("case")
        life = None if self.life is None else self.life.to_mapping()
        turns = None if self.frequencies is None else self.frequencies.to_mapping()
        parts = {"film": film, "friction": friction, "life": life, "frequencies": turns}
        return {**mapping, **parts, "notes": notes, "case": case}

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give everything as one JSON object, in SI units."""
        return json.dumps(self.to_mapping(), indent=indent, ensure_ascii=False, allow_nan=False)


def analyse(case: Case, *, hysteresis: float = DEFAULT_HYSTERESIS) -> Analysis:
    """Solve a case, and find what follows from the state.

    The film needs `case.lubricant` (an oil or a grease) and `case.temperature`, and
    `case.surface` for its film parameter; friction needs the friction coefficient of the
    lubricant. With a film, the oil's rolling resistance counts as friction, and the film
    parameter decides which friction models hold; Palmgren's and SKF's need a designation too.
    Life needs a designation or `case.life`.

    Parameters
    ----------
    case
        What to solve.
    hysteresis
        Part α_h of the elastic work that the material loses, 0 to 1.

    Returns
    -------
    Analysis
        Never raises for a duty that has no solution: the state's status tells.

    Raises
    ------
    InputError
        If the mounting closes the bearing, or the oil is dirtier than all classes of ISO 281.
    """
    from rolamento.solution import solve

    return analyse_state(solve(case), hysteresis=hysteresis)


def analyse_state(state: State, *, hysteresis: float = DEFAULT_HYSTERESIS) -> Analysis:
    """Find what follows from a solved state; as `analyse`."""
    if not state.status.converged:
        return Analysis(state)
    lives, why_not = _life(state)
    if state.case.lubricant is None:
        return Analysis(state, None, None, lives, why_not)
    film = _film(state) if has_film(state.case) else None
    found = _friction(state, film, lives, hysteresis) if has_friction(state.case) else None
    return Analysis(state, film, found, lives, (*missing(state.case), *why_not))


def _friction(
    state: State, film: Film | None, lives: LifeSummary | None, hysteresis: float
) -> Friction:
    from rolamento.friction import friction

    return friction(
        state,
        friction_coefficient=coefficient(state.case),
        hysteresis=hysteresis,
        dynamic_viscosity=None if film is None else film.dynamic_viscosity,
        film_parameter=None if film is None else _least_parameter(film),
        machine=machine_of(state.case, film, lives),
    )


def _life(state: State) -> tuple[LifeSummary | None, tuple[str, ...]]:
    """Life of a state, if its case asks for one; or why there is none."""
    if not has_life(state.case):
        return None, ()
    from rolamento.life import conditions_of, life

    conditions = conditions_of(state.case)
    why_not: tuple[str, ...] = ()
    if conditions.nsk_cleanliness is not None and not _viscosity_known(conditions):
        conditions = replace(conditions, nsk_cleanliness=None)
        why_not = ("l_able_without_viscosity",)
    try:
        return life(state, conditions), why_not
    except InputError as error:
        if error.field == "bearing.contact_angle":
            return None, ("life_of_thrust_bearing",)
        if error.field == "dynamic_rating":
            return None, ("life_without_rating",)
        raise


def _viscosity_known(conditions: LifeConditions) -> bool:
    return conditions.viscosity is not None or conditions.viscosity_ratio is not None


def _film(state: State) -> Film:
    from rolamento.lubrication import film_of

    return film_of(state)


def _least_parameter(film: Film) -> float:
    parameters = [
        contact.film_parameter for ball in film.balls for contact in (ball.inner, ball.outer)
    ]
    return min((value for value in parameters if isfinite(value)), default=float("nan"))
