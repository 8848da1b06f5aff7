"""Outputs of the lubricant film: thickness and film parameter of each contact, viscosity ratio."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Final

import numpy as np

from rolamento.geometry import Race
from rolamento.studies.ball_outputs import RACES, family
from rolamento.studies.outputs import Floats, Output, Solved

__all__ = ["lubrication_outputs"]

_OIL: Final = ("lubricant", "temperature.lubricant")
_ROUGH: Final = (*_OIL, "surface")
_CONTACT: Final = (
    ("central_film_thickness", "central_thickness", "m", "central film thickness", _OIL),
    ("minimum_film_thickness", "minimum_thickness", "m", "minimum film thickness", _OIL),
    ("film_parameter", "film_parameter", "1", "film parameter λ", _ROUGH),
    ("entrainment_speed", "entrainment_speed", "m/s", "mean speed of the surfaces", _OIL),
)


def lubrication_outputs() -> tuple[Output, ...]:
    """Return the outputs of the film."""
    return (
        *_of_contacts(),
        Output(
            "film_parameter",
            "1",
            "film parameter λ: least of all contacts",
            lambda solved: solved.film.minimum_film_parameter,
            needs=_ROUGH,
        ),
        Output(
            "viscosity_ratio",
            "1",
            "viscosity ratio κ",
            lambda solved: np.where(solved.batch.converged, solved.film.viscosity_ratio, np.nan),
            needs=_OIL,
        ),
        Output(
            "kinematic_viscosity",
            "m^2/s",
            "kinematic viscosity of the lubricant",
            lambda solved: np.where(
                solved.batch.converged, solved.film.kinematic_viscosity, np.nan
            ),
            needs=_OIL,
        ),
    )


def _of_contacts() -> Iterator[Output]:
    for race in RACES:
        for name, attribute, unit, words, needs in _CONTACT:
            get = _contact(race, attribute)
            yield from family(f"{race}_{name}", unit, f"{words}, {race} race", get, None, needs)


def _contact(race: Race, attribute: str) -> Callable[[Solved], Floats]:
    return lambda solved: getattr(solved.film.of(race), attribute)
