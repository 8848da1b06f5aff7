"""What the user should know about a film: limits passed, assumptions strained.

A note never changes a number.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isnan
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.case.lubricant import Lubricant
from rolamento.lubrication.film_thickness import COMPUTED_RANGE
from rolamento.lubrication.regime import regime_of
from rolamento.oil import MINIMUM_VISCOSITY
from rolamento.units import from_si

if TYPE_CHECKING:
    from rolamento.lubrication.films import Film
    from rolamento.numerics import BoolArray, FloatArray

MINIMUM_RATIO: Final = 1.0
"""κ below which the standard calls for additives that protect the surface."""
STRONG_REDUCTION: Final = 0.5
"""Of the film: where heat or lack of oil takes more, the estimate is rough."""
_GROUPS: Final = {
    "U": "speed_parameter",
    "W": "load_parameter",
    "G": "material_parameter",
    "k": "ellipticity",
}


def notes_on(film: Film, case: int) -> Iterator[str]:
    """Return what the user should know about the film of one case."""
    lubricant = film.case.lubricant
    assert lubricant is not None
    if lubricant.kind == "dry":
        yield (
            f"Dry lubrication ({lubricant.name}): there is no film, only a coefficient of friction"
            f" of {lubricant.friction_coefficient:g}."
        )
        return
    yield from _temperature(film, case, lubricant)
    yield from _assumptions(film, case, lubricant)
    if np.isinf(film.reference_viscosity[case]):
        yield "Nothing turns: no film separates the surfaces."
        return
    there = np.isfinite(_of_contacts(film, case, "central_thickness"))
    if there.any():
        yield from _range(film, case, there)
        yield from _reductions(film, case, there)
        yield from _regime(film, case, there)


def _of_contacts(film: Film, case: int, name: str) -> FloatArray:
    """A number of all contacts of a case, of both races."""
    return np.concatenate([getattr(film.inner, name)[case], getattr(film.outer, name)[case]])


def _temperature(film: Film, case: int, lubricant: Lubricant) -> Iterator[str]:
    temperature = float(film.temperature[case])
    at = from_si(temperature, "temperature")
    oil = lubricant.oil
    minimum, maximum = oil.minimum_temperature, oil.maximum_temperature
    if minimum is not None and temperature < minimum:
        yield (
            f"The lubricant is below its range at {at}: {lubricant.name} is for"
            f" {from_si(minimum, 'temperature')} and more."
        )
    if maximum is not None and temperature > maximum:
        yield (
            f"The lubricant is above its range at {at}: {lubricant.name} is for at most"
            f" {from_si(maximum, 'temperature')}."
        )
    if film.kinematic_viscosity[case] < MINIMUM_VISCOSITY:
        yield (
            f"At {at} the oil has less than 2 mm²/s, where the line of ASTM D341 does not hold as"
            " it is used here."
        )


def _assumptions(film: Film, case: int, lubricant: Lubricant) -> Iterator[str]:
    oil, alpha = lubricant.oil, float(film.pressure_viscosity[case])
    if oil.pressure_viscosity is None:
        method = "So and Klaus" if oil.pressure_viscosity_method == "so_klaus" else "Wooster"
        yield (
            "The pressure-viscosity coefficient is estimated"
            f" ({alpha * 1e9:.3g} 1/GPa, {method}, for mineral oils)."
        )
    if isnan(alpha) or alpha <= 0.0:
        yield "The estimate of the pressure-viscosity coefficient fails for so thin an oil."
    if lubricant.kind == "grease":
        yield "A grease is reckoned by its base oil, its inlets full; it may starve."
    if film.case.surface is None:
        yield "Without the roughness of the surfaces there is no film parameter."


def _range(film: Film, case: int, there: BoolArray) -> Iterator[str]:
    """Groups outside of what the formulas were fitted to."""
    outside = []
    for symbol, name in _GROUPS.items():
        values = _of_contacts(film, case, name)[there]
        minimum, maximum = COMPUTED_RANGE[symbol]
        if values.min() < minimum or values.max() > maximum:
            outside.append(f"{symbol} {values.min():.2g} to {values.max():.2g}")
    if outside:
        yield (
            "Outside of what Hamrock and Dowson computed, as is usual for rolling bearings: "
            + ", ".join(outside)
            + "."
        )


def _reductions(film: Film, case: int, there: BoolArray) -> Iterator[str]:
    for name, cause in (
        ("thermal_factor", "The heat of shear in the inlet"),
        ("starvation_factor", "Lack of oil in the inlet"),
    ):
        minimum = _of_contacts(film, case, name)[there].min()
        if minimum < STRONG_REDUCTION:
            yield f"{cause} leaves only {100.0 * minimum:.0f} % of the film at some contacts."


def _regime(film: Film, case: int, there: BoolArray) -> Iterator[str]:
    minimum = float(np.fmin.reduce(_of_contacts(film, case, "film_parameter")[there]))
    regime = regime_of(minimum)
    if regime is not None and regime.name in {"boundary", "adhesive"}:
        yield (
            f"Film parameter down to {minimum:.2g}: the asperities carry the load,"
            " and fatigue is to be expected from the surface"
            + (", with adhesive wear." if regime.name == "adhesive" else ".")
        )
    ratio, needed = film.viscosity_ratio[case], film.reference_viscosity[case]
    if ratio < MINIMUM_RATIO:
        yield (
            f"Viscosity ratio {ratio:.2g}: the oil is thinner than the bearing needs"
            f" ({needed * 1e6:.3g} mm²/s)."
        )
