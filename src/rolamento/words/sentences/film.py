"""What is said of a lubricant film."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from rolamento.words.sentences import Sentence
from rolamento.words.speaking import manner, marked, said

__all__ = ["SENTENCES"]

_METHODS: Final = {"so_klaus": marked("So and Klaus"), "wooster": "Wooster"}


def _pressure_viscosity_estimated(values: Mapping[str, Any]) -> str:
    method = _METHODS[values["method"]]
    return said(
        "The pressure-viscosity coefficient is estimated ({pressure_viscosity:.3 1/GPa}, {method},"
        " for mineral oils).",
        pressure_viscosity=values["pressure_viscosity"],
        method=said(method),
    )


def _outside_hamrock_dowson(values: Mapping[str, Any]) -> str:
    groups = (
        said("{symbol} from {least} to {greatest}", symbol=symbol, least=low, greatest=high)
        for symbol in ("U", "W", "G", "k")
        if symbol in values
        for low, high in [map(_short, values[symbol])]
    )
    return said(
        "Outside the range computed by Hamrock and Dowson, as is usual for rolling bearings:"
        " {groups}.",
        groups="; ".join(groups),
    )


def _short(value: float) -> str:
    """Write a number from 1e-12 to 1e4 in two figures."""
    plain = value == 0.0 or 1e-3 <= value < 1e5
    return manner().short(value, 2) if plain else manner().number(value, ".1e")


SENTENCES: Final[dict[str, Sentence]] = {
    "film_dry": marked(
        "Dry lubrication ({lubricant}): there is no film, only a coefficient of friction of"
        " {friction_coefficient}."
    ),
    "lubricant_too_cold": marked(
        "The lubricant is below its temperature range at {temperature:.4 °C}: {lubricant} is rated"
        " for {minimum_temperature:.4 °C} and above."
    ),
    "lubricant_too_hot": marked(
        "The lubricant is above its temperature range at {temperature:.4 °C}: {lubricant} is rated"
        " for up to {maximum_temperature:.4 °C}."
    ),
    "viscosity_extrapolated": marked(
        "At {temperature:.4 °C} the oil has less than {minimum:.2 mm²/s}, where the straight line"
        " of ASTM D341, as used here, is not valid."
    ),
    "pressure_viscosity_estimated": _pressure_viscosity_estimated,
    "pressure_viscosity_unknown": marked(
        "The estimate of the pressure-viscosity coefficient fails for so thin an oil."
    ),
    "grease_as_base_oil": marked(
        "A grease is calculated by its base oil with fully flooded inlets; in service it may"
        " starve."
    ),
    "roughness_missing": marked(
        "Without the roughness of the surfaces there is no film parameter."
    ),
    "film_at_rest": marked("Nothing rotates: no film separates the surfaces."),
    "outside_hamrock_dowson": _outside_hamrock_dowson,
    "film_of_light_lines": marked(
        "The rollers are so lightly loaded that even the heaviest contact hardly deforms: the film"
        " is thicker than stated."
    ),
    "lines_not_starved": marked(
        "The reduction by the inlet distance is of elliptical contacts: the line contacts of the"
        " rollers are taken as fully flooded."
    ),
    "film_heated": marked(
        "Inlet shear heating leaves only {factor:.0f %} of the film at some contacts."
    ),
    "film_starved": marked(
        "Starvation of the inlet leaves only {factor:.0f %} of the film at some contacts."
    ),
    "film_boundary": marked(
        "Film parameter down to {film_parameter:.2}: the asperities carry the load, and"
        " surface-initiated fatigue is to be expected."
    ),
    "film_adhesive": marked(
        "Film parameter down to {film_parameter:.2}: the asperities carry the load, and"
        " surface-initiated fatigue and adhesive wear are to be expected."
    ),
    "viscosity_ratio_low": marked(
        "Viscosity ratio {viscosity_ratio:.2}: the oil is thinner than the bearing requires"
        " ({required_viscosity:.3 mm²/s})."
    ),
}
