"""Which friction models hold for a state: its inertia and its film decide."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.friction import (
    harris_1971,
    jones_control,
    jones_full,
    jones_simplified,
    palmgren,
    skf,
    todd,
)
from rolamento.friction.loaded_balls import LoadedBalls
from rolamento.kinematics import friction_demand
from rolamento.numerics import BoolArray, FloatArray

INERTIA_SHARE: Final = 0.1
"""Share of friction, or of the ball's load, that forces of inertia may take at low speed."""

COUNTED_LOAD: Final = 0.05
"""Of the heaviest ball's load: balls with less have no say in the torque."""

FULL_FILM: Final = 3.0
"""Film parameter λ above which the surfaces do not touch."""

BOUNDARY: Final = 1.0
"""Film parameter λ below which the asperities carry the load."""

LOW_SPEED: Final = (
    jones_full.NAME,
    jones_control.NAME,
    jones_simplified.NAME,
    harris_1971.NAME,
    todd.NAME,
)
"""Models of dry or boundary friction without inertia."""

LUBRICATED: Final = (palmgren.NAME, skf.NAME)
"""Models of lubricated machine bearings."""

REASONS: Final[Mapping[str, str]] = {
    "inertia": "the gyroscopic moment or the centrifugal force on a ball takes more than "
    f"{INERTIA_SHARE:.0%} of what friction or its load can hold",
    "full_film": "an oil film keeps the surfaces apart: friction is not Coulomb's",
    "partial_film": "an oil film carries part of the load: the coefficient of friction is an "
    "effective one",
    "no_film": "asperities carry the load, and the model stands for a lubricated bearing",
    "other_angle": "the maker's constants are for bearings of another contact angle",
    "at_rest": "nothing turns: the torque is that of the first motion",
    "no_result": "the state, or the model, has no result",
}
"""Why a model does not hold, or not quite, in words."""

_REFUSING: Final = ("inertia", "full_film", "no_film", "other_angle", "no_result")


@dataclass(frozen=True, slots=True, eq=False)
class ModelVerdict:
    """Whether a model holds; holds (cases,), notes: names of `REASONS` with the cases (cases,)."""

    model: str
    holds: BoolArray
    notes: Mapping[str, BoolArray]


def film_regime(film_parameter: ArrayLike | None, cases: int) -> NDArray[np.str_]:
    """Name the regime of every case: "boundary", "mixed", "full_film" or "unknown".

    film_parameter : λ, a number or (cases,); None where it is not known.
    """
    if film_parameter is None:
        return np.full(cases, "unknown")
    value = np.broadcast_to(np.asarray(film_parameter, dtype=np.float64), cases)
    with np.errstate(invalid="ignore"):
        choices = [value < BOUNDARY, value <= FULL_FILM, value > FULL_FILM]
    return np.select(choices, ["boundary", "mixed", "full_film"], "unknown")


def inertia_counts(balls: LoadedBalls, coefficient: FloatArray) -> BoolArray:
    """(cases,): whether inertia takes a share of a ball's friction or load that cannot be left.

    coefficient : μ, (cases or 1, 1).
    """
    demand = friction_demand(balls.gyroscopic_moment, balls.inner.ball_diameter, balls.outer.load)
    with np.errstate(invalid="ignore"):
        turned = demand > INERTIA_SHARE * coefficient
        thrown = balls.centrifugal_force > INERTIA_SHARE * balls.inner.load
        heaviest = np.max(balls.inner.load, axis=-1, keepdims=True)
        counted = balls.loaded & (balls.inner.load > COUNTED_LOAD * heaviest)
    return np.asarray(np.any(counted & (turned | thrown), axis=-1))


def verdict(
    model: str,
    balls: LoadedBalls,
    coefficient: FloatArray,
    regime: NDArray[np.str_],
    converged: BoolArray,
    *,
    other_angle: bool = False,
) -> ModelVerdict:
    """Judge one model for every case; other_angle: its constants are for another contact angle."""
    cases = len(regime)
    notes: dict[str, BoolArray] = {}
    if model in LOW_SPEED:
        notes["inertia"] = inertia_counts(balls, coefficient)
        notes["full_film"] = regime == "full_film"
        notes["partial_film"] = regime == "mixed"
    else:
        notes["no_film"] = regime == "boundary"
    notes["other_angle"] = np.full(cases, other_angle)
    notes["at_rest"] = np.broadcast_to(balls.relative_speed[:, 0] == 0.0, cases)
    notes["no_result"] = ~converged
    found = {name: where for name, where in notes.items() if np.any(where)}
    refused = [where for name, where in found.items() if name in _REFUSING]
    holds = ~np.any(refused, axis=0) if refused else np.ones(cases, np.bool_)
    return ModelVerdict(model, holds, found)
