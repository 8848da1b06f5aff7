"""What the user should know about a film: limits passed, assumptions strained.

A note never changes a number.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite, isnan
from typing import Final

from rolamento.case import Case
from rolamento.case.lubricant import Lubricant
from rolamento.lubrication.film_thickness import COMPUTED_RANGE
from rolamento.lubrication.record import ContactFilm, Film
from rolamento.oil import MINIMUM_VISCOSITY
from rolamento.units import from_si

LEAST_RATIO: Final = 1.0
"""κ below which the standard calls for additives that protect the surface."""
STRONG_REDUCTION: Final = 0.5
"""Of the film: where heat or lack of oil takes more, the estimate is rough."""
_GROUPS: Final = {
    "U": "speed_parameter",
    "W": "load_parameter",
    "G": "material_parameter",
    "k": "ellipticity",
}


def notes_on(film: Film, case: Case) -> Iterator[str]:
    """Return what the user should know about a film."""
    lubricant = case.lubricant
    assert lubricant is not None
    if lubricant.kind == "dry":
        yield (
            f"Dry lubrication ({lubricant.name}): there is no film, only a coefficient of friction"
            f" of {lubricant.friction_coefficient:g}."
        )
        return
    yield from _temperature(film, lubricant)
    yield from _assumptions(film, case, lubricant)
    if case.duty.inner_speed == case.duty.outer_speed:
        yield "Nothing turns: no film separates the surfaces."
        return
    contacts = [
        contact
        for ball in film.balls
        for contact in (ball.inner, ball.outer)
        if isfinite(contact.central_thickness)
    ]
    if contacts:
        yield from _range(contacts)
        yield from _reductions(contacts)
        yield from _regime(film, contacts)


def _temperature(film: Film, lubricant: Lubricant) -> Iterator[str]:
    at = from_si(film.temperature, "temperature")
    oil = lubricant.oil
    least, most = oil.minimum_temperature, oil.maximum_temperature
    if least is not None and film.temperature < least:
        yield (
            f"The lubricant is below its range at {at}: {lubricant.name} is for"
            f" {from_si(least, 'temperature')} and more."
        )
    if most is not None and film.temperature > most:
        yield (
            f"The lubricant is above its range at {at}: {lubricant.name} is for at most"
            f" {from_si(most, 'temperature')}."
        )
    if film.kinematic_viscosity < MINIMUM_VISCOSITY:
        yield (
            f"At {at} the oil has less than 2 mm²/s, where the line of ASTM D341 does not hold as"
            " it is used here."
        )


def _assumptions(film: Film, case: Case, lubricant: Lubricant) -> Iterator[str]:
    oil = lubricant.oil
    if oil.pressure_viscosity is None:
        method = "So and Klaus" if oil.pressure_viscosity_method == "so_klaus" else "Wooster"
        yield (
            "The pressure-viscosity coefficient is estimated"
            f" ({film.pressure_viscosity * 1e9:.3g} 1/GPa, {method}, for mineral oils)."
        )
    if isnan(film.pressure_viscosity) or film.pressure_viscosity <= 0.0:
        yield "The estimate of the pressure-viscosity coefficient fails for so thin an oil."
    if lubricant.kind == "grease":
        yield "A grease is reckoned by its base oil, its inlets full; it may starve."
    if case.surface is None:
        yield "Without the roughness of the surfaces there is no film parameter."


def _range(contacts: list[ContactFilm]) -> Iterator[str]:
    """Groups outside of what the formulas were fitted to."""
    outside = []
    for symbol, name in _GROUPS.items():
        values = [getattr(contact, name) for contact in contacts]
        least, most = COMPUTED_RANGE[symbol]
        if min(values) < least or max(values) > most:
            outside.append(f"{symbol} {min(values):.2g} to {max(values):.2g}")
    if outside:
        yield (
            "Outside of what Hamrock and Dowson computed, as is usual for rolling bearings: "
            + ", ".join(outside)
            + "."
        )


def _reductions(contacts: list[ContactFilm]) -> Iterator[str]:
    for name, cause in (
        ("thermal_factor", "The heat of shear in the inlet"),
        ("starvation_factor", "Lack of oil in the inlet"),
    ):
        least = min(getattr(contact, name) for contact in contacts)
        if least < STRONG_REDUCTION:
            yield f"{cause} leaves only {100.0 * least:.0f} % of the film at some contacts."


def _regime(film: Film, contacts: list[ContactFilm]) -> Iterator[str]:
    known = [contact for contact in contacts if not isnan(contact.film_parameter)]
    thinnest = min(known, key=lambda contact: contact.film_parameter, default=None)
    if thinnest is not None and thinnest.regime in {"boundary", "adhesive"}:
        yield (
            f"Film parameter down to {thinnest.film_parameter:.2g}: the asperities carry the load,"
            " and fatigue is to be expected from the surface"
            + (", with adhesive wear." if thinnest.regime == "adhesive" else ".")
        )
    if film.viscosity_ratio < LEAST_RATIO:
        yield (
            f"Viscosity ratio {film.viscosity_ratio:.2g}: the oil is thinner than the bearing needs"
            f" ({film.reference_viscosity * 1e6:.3g} mm²/s)."
        )
