"""Everything that follows from a case: its state, the lubricant film, friction.

`analyse` for a case, `analyse_batch` for many solved cases at once. A part that a case does not
ask for is None; one that it asks for and that cannot be had is None with a note, never an
exception.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, fields
from math import isfinite
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.case import Case
from rolamento.errors import InputError
from rolamento.state import State

if TYPE_CHECKING:
    from rolamento.equilibrium import BatchState
    from rolamento.friction import ContactLoss, Friction, ModelVerdict, Torque
    from rolamento.friction.summary import ContactModel
    from rolamento.lubrication import Film, FilmTable

__all__ = [
    "NOTES",
    "Analysis",
    "BatchAnalysis",
    "analyse",
    "analyse_batch",
    "analyse_state",
    "joined",
    "least_film_parameter",
]

NOTES: Final[Mapping[str, str]] = {
    "no_temperature": (
        "No film: the lubricant's temperature is not given (temperature.lubricant)."
    ),
    "no_coefficient": (
        "No friction: the lubricant's coefficient of friction is not given"
        " (lubricant.friction_coefficient)."
    ),
}
"""Why a part is missing, by name."""

_DEFAULT_HYSTERESIS: Final = 0.01
_BLOCK: Final = 4096
"""Cases at a time, so that their arrays stay near the processor."""


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
    notes
        names in `NOTES`: why a part is missing that the case seems to ask for
    """

    state: State
    film: Film | None = None
    friction: Friction | None = None
    notes: tuple[str, ...] = ()

    @property
    def sentences(self) -> tuple[str, ...]:
        """The notes in words."""
        return tuple(NOTES[name] for name in self.notes)

    def to_mapping(self) -> dict[str, Any]:
        """Give the state's mapping with "film" and "friction", None where there is none."""
        mapping = self.state.to_mapping()
        film = None if self.film is None else self.film.to_mapping()
        friction = None if self.friction is None else friction_mapping(self.state, self.friction)
        notes = [*mapping.pop("notes"), *self.sentences]
        case = mapping.pop("case")
        return {**mapping, "film": film, "friction": friction, "notes": notes, "case": case}

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give everything as one JSON object, in SI units."""
        return json.dumps(self.to_mapping(), indent=indent, ensure_ascii=False, allow_nan=False)


@dataclass(frozen=True, slots=True, eq=False)
class BatchAnalysis:
    """What follows from solved cases: film and friction, arrays over cases; None as above."""

    film: FilmTable | None
    friction: Friction | None


def analyse(case: Case, *, hysteresis: float = _DEFAULT_HYSTERESIS) -> Analysis:
    """Solve a case, and find what follows from the state.

    The film needs `case.lubricant` (an oil or a grease) and `case.temperature`, and
    `case.surface` for its film parameter; friction needs the friction coefficient of the
    lubricant. With a film, the oil's rolling resistance counts as friction, and the film
    parameter decides which friction models hold.

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
    """
    from rolamento.solution import solve

    return analyse_state(solve(case), hysteresis=hysteresis)


def analyse_state(state: State, *, hysteresis: float = _DEFAULT_HYSTERESIS) -> Analysis:
    """Find what follows from a solved state; as `analyse`."""
    case = state.case
    if case.lubricant is None or not state.status.converged:
        return Analysis(state)
    notes = _missing(case)
    film = _film(state) if _has_film(case) else None
    if not _has_friction(case):
        return Analysis(state, film, None, notes)
    from rolamento.friction import friction

    found = friction(
        state,
        friction_coefficient=_coefficient(case),
        hysteresis=hysteresis,
        dynamic_viscosity=None if film is None else film.dynamic_viscosity,
        film_parameter=None if film is None else _least_parameter(film),
    )
    return Analysis(state, film, found, notes)


def analyse_batch(
    case: Case,
    batch: BatchState,
    *,
    model: ContactModel = "jones_simplified",
    friction_coefficient: ArrayLike | None = None,
    lubricant_temperature: ArrayLike | None = None,
    hysteresis: float = _DEFAULT_HYSTERESIS,
    compare: bool = False,
    threads: int | None = None,
) -> BatchAnalysis:
    """Find film and friction of solved cases.

    Parameters
    ----------
    case
        The one that was solved; supplies lubricant, temperature, surface and film model.
    batch
        From `solve_batch`.
    model
        Of the friction in the contacts; the default is a closed form.
    friction_coefficient, lubricant_temperature
        A number or an array (cases,) in the place of the case's; the latter in K.
    hysteresis
        As in `analyse`.
    compare
        Whether to evaluate all models of the contacts.
    threads
        As many as there are processors by default.

    Returns
    -------
    BatchAnalysis
        Without a film, or without friction, where the case does not have what they need.

    Raises
    ------
    InputError
        For a number out of range, or an array of another length.
    """
    cases = len(batch)
    mu = _over_cases(friction_coefficient, "friction_coefficient", cases)
    if mu is None and _has_friction(case):
        mu = np.full(cases, _coefficient(case))
    warm = _over_cases(lubricant_temperature, "lubricant_temperature", cases)
    if warm is not None and not np.all(warm > 0.0):
        raise InputError("must be above absolute zero, in K", field="lubricant_temperature")
    if warm is None and case.temperature is not None:
        warm = np.full(cases, case.temperature.lubricant)
    if not _has_oil(case):
        warm = None

    def part(first: int) -> BatchAnalysis:
        from rolamento.lubrication.running import part as some_of

        some = slice(first, first + _BLOCK)
        return _part(
            case,
            remembering(some_of(batch, some)),
            None if mu is None else mu[some],
            None if warm is None else warm[some],
            (model, hysteresis, compare),
        )

    blocks = range(0, max(cases, 1), _BLOCK)
    if len(blocks) == 1 or threads == 1:
        parts = [part(first) for first in blocks]
    else:
        with ThreadPoolExecutor(threads or os.cpu_count()) as pool:
            parts = list(pool.map(part, blocks))
    return joined(parts)


def remembering(batch: BatchState) -> BatchState:
    """Return a batch that reckons its balls and ellipses once, for film and friction alike."""
    from rolamento.equilibrium.remembering import RememberingBatch

    return RememberingBatch(*(getattr(batch, field.name) for field in fields(batch)))


def _part(
    case: Case,
    batch: BatchState,
    mu: NDArray[np.float64] | None,
    warm: NDArray[np.float64] | None,
    choices: tuple[ContactModel, float, bool],
) -> BatchAnalysis:
    """Film and friction of some cases."""
    from rolamento.friction import friction
    from rolamento.lubrication.running import balls_of_batch
    from rolamento.lubrication.table import film_table, lubricant_of

    model, hysteresis, compare = choices
    film = None
    if warm is not None:
        film = film_table(case, lubricant_of(case), balls_of_batch(batch), warm)
    if mu is None:
        return BatchAnalysis(film, None)
    found = friction(
        batch,
        friction_coefficient=mu,
        model=model,
        hysteresis=hysteresis,
        dynamic_viscosity=None if film is None else film.oil.dynamic_viscosity,
        film_parameter=None if film is None else least_film_parameter(film),
        compare=compare,
    )
    return BatchAnalysis(film, found)


def least_film_parameter(film: FilmTable) -> NDArray[np.float64]:
    """Least film parameter λ of all contacts; (cases,), NaN where there is none."""
    parameters = np.concatenate([film.inner.film_parameter, film.outer.film_parameter], axis=1)
    return np.asarray(np.fmin.reduce(parameters, axis=1))


def friction_mapping(state: State, friction: Friction) -> dict[str, Any]:
    """Give the friction of a state as plain mappings and lists in SI units, NaN as None."""
    heat = {
        source: {"inner": loss.inner[0].tolist(), "outer": loss.outer[0].tolist()}
        for source, loss in friction.heat.items()
    }
    models = {
        found.model: {
            "torque": float(friction.models[found.model].total[0]),
            "parts": _numbers(friction.models[found.model].parts),
            "holds": bool(found.holds[0]),
            "reasons": [name for name, where in found.notes.items() if where[0]],
        }
        for found in friction.verdicts
    }
    mapping: dict[str, Any] = _without_nan(
        {
            "friction_coefficient": _coefficient(state.case),
            "model": friction.model,
            "regime": str(friction.regime[0]),
            "torque": float(friction.torque[0]),
            "starting_torque": float(friction.starting_torque[0]),
            "power": float(friction.power[0]),
            "torque_by_source": _numbers(friction.torque_by_source),
            "heat": heat,
            "models": models,
        }
    )
    return mapping


def _numbers(arrays: Mapping[str, NDArray[np.float64]]) -> dict[str, float]:
    return {name: float(array[0]) for name, array in arrays.items()}


def _without_nan(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _without_nan(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_without_nan(item) for item in value]
    return None if isinstance(value, float) and not isfinite(value) else value


# --- what a case has -------------------------------------------------------------------------


def _has_oil(case: Case) -> bool:
    return case.lubricant is not None and case.lubricant.kind != "dry"


def _has_film(case: Case) -> bool:
    return _has_oil(case) and case.temperature is not None


def _coefficient(case: Case) -> float:
    """The coefficient of friction, or NaN."""
    mu = None if case.lubricant is None else case.lubricant.friction_coefficient
    return float("nan") if mu is None else float(mu)


def _has_friction(case: Case) -> bool:
    return isfinite(_coefficient(case))


def _missing(case: Case) -> tuple[str, ...]:
    notes = []
    if _has_oil(case) and not _has_film(case):
        notes.append("no_temperature")
    if not _has_friction(case):
        notes.append("no_coefficient")
    return tuple(notes)


def _film(state: State) -> Film:
    from rolamento.lubrication import film_of

    return film_of(state)


def _least_parameter(film: Film) -> float:
    parameters = [
        contact.film_parameter for ball in film.balls for contact in (ball.inner, ball.outer)
    ]
    return min((value for value in parameters if isfinite(value)), default=float("nan"))


def _over_cases(given: ArrayLike | None, name: str, cases: int) -> NDArray[np.float64] | None:
    if given is None:
        return None
    array = np.asarray(given, dtype=np.float64)
    if array.shape not in ((), (cases,)):
        raise InputError(f"must be one number, or one for each of the {cases} cases", field=name)
    return np.broadcast_to(array, (cases,)).copy()


# --- blocks side by side ---------------------------------------------------------------------


def joined(parts: list[BatchAnalysis]) -> BatchAnalysis:
    """Put what was found for some cases after what was found for others."""
    from rolamento.lubrication.table import _stacked

    if len(parts) == 1:
        return parts[0]
    films = [part.film for part in parts if part.film is not None]
    frictions = [part.friction for part in parts if part.friction is not None]
    return BatchAnalysis(
        _stacked(films) if films else None, _joined_friction(frictions) if frictions else None
    )


def _joined_friction(parts: list[Friction]) -> Friction:
    from rolamento.friction import Friction

    first = parts[0]
    return Friction(
        model=first.model,
        torque=np.concatenate([part.torque for part in parts]),
        starting_torque=np.concatenate([part.starting_torque for part in parts]),
        power=np.concatenate([part.power for part in parts]),
        torque_by_source=_joined_arrays([part.torque_by_source for part in parts]),
        heat=_joined_losses([part.heat for part in parts]),
        regime=np.concatenate([part.regime for part in parts]),
        models={
            name: _joined_torque([part.models[name] for part in parts]) for name in first.models
        },
        verdicts=tuple(
            _joined_verdict([part.verdicts[index] for part in parts])
            for index in range(len(first.verdicts))
        ),
    )


def _joined_arrays(parts: list[Mapping[str, Any]]) -> dict[str, Any]:
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def _joined_losses(parts: list[Mapping[str, ContactLoss]]) -> dict[str, ContactLoss]:
    from rolamento.friction import ContactLoss

    return {
        name: ContactLoss(
            np.concatenate([part[name].inner for part in parts]),
            np.concatenate([part[name].outer for part in parts]),
        )
        for name in parts[0]
    }


def _joined_torque(parts: list[Torque]) -> Torque:
    from rolamento.friction import Torque

    first = parts[0]
    return Torque(
        first.model,
        np.concatenate([part.total for part in parts]),
        _joined_arrays([part.parts for part in parts]),
        np.concatenate([part.power for part in parts]),
        np.concatenate([part.converged for part in parts]),
        _joined_losses([part.losses for part in parts]),
        first.notes,
    )


def _joined_verdict(parts: list[ModelVerdict]) -> ModelVerdict:
    """A note that some blocks do not have is false in their cases."""
    from rolamento.friction import ModelVerdict

    names = dict.fromkeys(name for part in parts for name in part.notes)
    notes = {
        name: np.concatenate(
            [part.notes.get(name, np.zeros(len(part.holds), np.bool_)) for part in parts]
        )
        for name in names
    }
    return ModelVerdict(parts[0].model, np.concatenate([part.holds for part in parts]), notes)
