"""Outputs of the lubricant film: thickness and film parameter of each contact, viscosity ratio."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.geometry import Race
from rolamento.solved import RACES
from rolamento.studies.bearing_outputs import at_race, family
from rolamento.studies.outputs import Evaluation, Floats, Output
from rolamento.words import marked, said
from rolamento.words.quantities import CALLED, called

if TYPE_CHECKING:
    from rolamento.lubrication import Film
    from rolamento.solved import Solved

_OIL: Final = ("lubricant", "temperature.lubricant")
_ROUGH: Final = (*_OIL, "surface")
_CONTACT: Final = (
    ("central_film_thickness", marked("central film thickness"), "central_thickness", "m", _OIL),
    ("minimum_film_thickness", marked("minimum film thickness"), "minimum_thickness", "m", _OIL),
    ("film_parameter", CALLED["film_parameter"], "film_parameter", "1", _ROUGH),
    ("entrainment_speed", marked("entrainment speed"), "entrainment_speed", "m/s", _OIL),
)


def lubrication_outputs() -> tuple[Output, ...]:
    """Return the outputs of the film."""
    return (
        *_of_contacts(),
        Output(
            "film_parameter",
            "1",
            lambda: said("film parameter λ, minimum of all contacts"),
            lambda given: given.of(_film).minimum_film_parameter,
            needs=_ROUGH,
        ),
        Output(
            "viscosity_ratio",
            "1",
            lambda: called("viscosity_ratio"),
            _of_oil("viscosity_ratio"),
            needs=_OIL,
        ),
        Output(
            "kinematic_viscosity",
            "m^2/s",
            lambda: said("kinematic viscosity of the lubricant"),
            _of_oil("kinematic_viscosity"),
            needs=_OIL,
        ),
    )


def _of_contacts() -> Iterator[Output]:
    for race in RACES:
        for name, text, attribute, unit, needs in _CONTACT:
            get = _contact(race, attribute)
            yield from family(f"{race}_{name}", unit, at_race(race, text), get, None, needs)


def _film(solved: Solved) -> Film:
    from rolamento.lubrication import film

    return film(solved, threads=1)


def _contact(race: Race, attribute: str) -> Callable[[Evaluation], Floats]:
    return lambda given: getattr(given.of(_film).of(race), attribute)


def _of_oil(attribute: str) -> Callable[[Evaluation], Floats]:
    return lambda given: np.where(
        given.solved.converged, getattr(given.of(_film), attribute), np.nan
    )
