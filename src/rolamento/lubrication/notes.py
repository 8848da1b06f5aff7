"""Notes on a film: limits exceeded, assumptions strained.

A note never changes a number. Their sentences are in `rolamento.words.sentences.film`.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.case.lubricant import Lubricant
from rolamento.lubrication.film_thickness import COMPUTED_RANGE, FilmGroups
from rolamento.lubrication.line_film import line_film, rigid_film
from rolamento.lubrication.regime import regime_of
from rolamento.oil import MINIMUM_VISCOSITY
from rolamento.words import Note

if TYPE_CHECKING:
    from rolamento.lubrication.films import Film
    from rolamento.numerics import BoolArray, FloatArray

MINIMUM_RATIO: Final = 1.0
"""κ below which the standard calls for additives that protect the surface."""
STRONG_REDUCTION: Final = 0.5
"""Fraction of the film: where heat or lack of oil takes more, the estimate is rough."""
_GROUPS: Final = {
    "U": "speed_parameter",
    "W": "load_parameter",
    "G": "material_parameter",
    "k": "ellipticity",
}


def notes_on(film: Film, case: int) -> Iterator[Note]:
    """Return the notes on the film of one case."""
    lubricant = film.case.lubricant
    assert lubricant is not None
    if lubricant.kind == "dry":
        coefficient = lubricant.friction_coefficient
        yield Note("film_dry", {"lubricant": lubricant.name, "friction_coefficient": coefficient})
        return
    yield from _temperature(film, case, lubricant)
    yield from _assumptions(film, case, lubricant)
    if np.isinf(film.reference_viscosity[case]):
        yield Note("film_at_rest")
        return
    there = np.isfinite(_of_contacts(film, case, "central_thickness"))
    if there.any():
        yield from _range(film, case, there)
        yield from _reductions(film, case, there)
        yield from _regime(film, case, there)


def _of_contacts(film: Film, case: int, name: str) -> FloatArray:
    """A number of all contacts of a case, of both races."""
    return np.concatenate([getattr(film.inner, name)[case], getattr(film.outer, name)[case]])


def _temperature(film: Film, case: int, lubricant: Lubricant) -> Iterator[Note]:
    temperature = float(film.temperature[case])
    known = {"temperature": temperature, "lubricant": lubricant.name}
    oil = lubricant.oil
    minimum, maximum = oil.minimum_temperature, oil.maximum_temperature
    if minimum is not None and temperature < minimum:
        yield Note("lubricant_too_cold", {**known, "minimum_temperature": minimum})
    if maximum is not None and temperature > maximum:
        yield Note("lubricant_too_hot", {**known, "maximum_temperature": maximum})
    if film.kinematic_viscosity[case] < MINIMUM_VISCOSITY:
        yield Note(
            "viscosity_extrapolated", {"temperature": temperature, "minimum": MINIMUM_VISCOSITY}
        )


def _assumptions(film: Film, case: int, lubricant: Lubricant) -> Iterator[Note]:
    oil, alpha = lubricant.oil, float(film.pressure_viscosity[case])
    if oil.pressure_viscosity is None and isfinite(alpha):
        method = "so_klaus" if oil.pressure_viscosity_method == "so_klaus" else "wooster"
        yield Note("pressure_viscosity_estimated", {"pressure_viscosity": alpha, "method": method})
    if not alpha > 0.0:
        yield Note("pressure_viscosity_unknown")
    if lubricant.kind == "grease":
        yield Note("grease_as_base_oil")
    if film.case.surface is None:
        yield Note("roughness_missing")


def _range(film: Film, case: int, there: BoolArray) -> Iterator[Note]:
    """Groups outside of what the formulas were fitted to."""
    groups = {name: _of_contacts(film, case, name)[there] for name in _GROUPS.values()}
    lines = np.isinf(groups["ellipticity"])
    if lines.any():
        yield from _lines(film, FilmGroups(*(values[lines] for values in groups.values())))
    outside = {}
    for symbol, name in _GROUPS.items():
        values = groups[name][~lines]
        if not values.size:
            return
        minimum, maximum = COMPUTED_RANGE[symbol]
        if values.min() < minimum or values.max() > maximum:
            outside[symbol] = [float(values.min()), float(values.max())]
    if outside:
        yield Note("outside_hamrock_dowson", outside)


def _lines(film: Film, groups: FilmGroups) -> Iterator[Note]:
    """Lines of contact too lightly loaded for their formulas, or starved as ellipses are."""
    model = film.case.film
    formula = None if model is None else model.line
    _, least = line_film(groups, formula or "pan_hamrock")
    if (rigid_film(groups) > least)[np.argmax(groups.load)]:
        yield Note("film_of_light_lines")
    if model is not None and model.starvation == "inlet_distance":
        yield Note("lines_not_starved")


def _reductions(film: Film, case: int, there: BoolArray) -> Iterator[Note]:
    for name, key in (("thermal_factor", "film_heated"), ("starvation_factor", "film_starved")):
        minimum = float(_of_contacts(film, case, name)[there].min())
        if minimum < STRONG_REDUCTION:
            yield Note(key, {"factor": minimum})


def _regime(film: Film, case: int, there: BoolArray) -> Iterator[Note]:
    minimum = float(np.fmin.reduce(_of_contacts(film, case, "film_parameter")[there]))
    regime = regime_of(minimum)
    if regime is not None and regime.name in {"boundary", "adhesive"}:
        yield Note(f"film_{regime.name}", {"film_parameter": minimum})
    ratio, needed = float(film.viscosity_ratio[case]), float(film.reference_viscosity[case])
    if ratio < MINIMUM_RATIO:
        yield Note("viscosity_ratio_low", {"viscosity_ratio": ratio, "required_viscosity": needed})
