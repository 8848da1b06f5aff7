"""Oil and film of a 6305 bearing: as printed, with the author's choices, and as it should be.

The author takes the sum of the surface speeds for their mean, the hollow groove for a convex one,
and then exchanges x and y. The first makes the film thicker, the others thinner, so that his film
is only a fifth too thin, and his film parameters with it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

import numpy as np

from rolamento.contact.hertz import (
    brewe_hamrock_ellipticity,
    effective_modulus,
    elliptical_contact,
)
from rolamento.geometry import race_curvature
from rolamento.kinematics import rolling_entrainment_speed
from rolamento.lubrication.film_thickness import central_film, film_groups
from rolamento.oil import ViscosityLine, astm_d341, astm_d341_line, viscosity_index, wooster
from rolamento.verification.check import Check, half_unit
from rolamento.verification.published import MM, RPM, published, steel

__all__ = ["checks", "film_with_the_authors_choices", "right_film"]

_ZERO_CELSIUS: Final = 273.15
_MM2: Final = 1e6
_MICROMETRE: Final = 1e-6
_A_THIRD: Final = 1.0 / 3.0
"""Of a printed film: the most by which it may be too thin."""

_OTHER_TEMPERATURE: Final = (
    "The line of ASTM D341 through the oil's two printed viscosities gives 12.89 mm²/s at 84.8 °C;"
    " at the 83.4 °C of the text it is 4 % more."
)
_SUM_OF_SPEEDS: Final = (
    "The printed formula gives the sum of the two surface speeds; the film rests on their mean,"
    " half of it."
)
_CONVEX_RADIUS: Final = (
    "As the author has it, the hollow groove taken for a convex one. The film wants the radius of"
    " the rolling direction, 3.963 mm."
)
_CONVEX_ELLIPSE: Final = (
    "As the author has it: a convex groove, x and y exchanged, an approximate formula. The ratio of"
    " the true ellipse's axes is 21.6."
)
_FILM: Final = (
    "With the sum of the speeds, the convex groove and the exchanged x and y the printed film comes"
    " out; the errors nearly cancel. Right is a film a quarter thicker."
)
_PARAMETER: Final = (
    "The film parameter follows the film: with the author's choices the printed one comes out."
    " Right is a quarter more."
)


def checks() -> Iterator[Check]:
    """Compare the oil, the film and the film parameters."""
    yield from _oil()
    yield from _contact()
    film = published("campanha_2008")["film"]
    for condition in film["condition"]:
        yield from _condition(film, condition)
        yield from _parameters(film, condition)


def right_film(film: Mapping[str, Any], condition: Mapping[str, Any]) -> float:
    """Central film at the inner race, in m: mean speed, hollow groove, R_x, exact ellipse."""
    modulus = _modulus(film)
    rolling, across = _curvatures(film)
    contact = elliptical_contact(film["load_N"], rolling, across, modulus)
    groups = film_groups(
        _right_speed(film),
        film["load_N"],
        rolling,
        contact.ellipticity,
        modulus,
        condition["viscosity_cP"] * 1e-3,
        wooster(condition["viscosity_cP"] * 1e-3),
    )
    return float(central_film(groups)) / rolling


def film_with_the_authors_choices(film: Mapping[str, Any], condition: Mapping[str, Any]) -> float:
    """Central film, in m: sum of the speeds, convex groove, radius of all curvatures, x for y."""
    radius, ellipticity = _convex_contact(film)
    groups = film_groups(
        2.0 * _right_speed(film),
        film["load_N"],
        1.0 / radius,
        ellipticity,
        _modulus(film),
        condition["viscosity_cP"] * 1e-3,
        wooster(condition["viscosity_cP"] * 1e-3),
    )
    return float(central_film(groups)) * radius


def _oil() -> Iterator[Check]:
    data = published("campanha_2008")
    oil = data["oil"]
    cool, hot = oil["viscosity_40_mm2_s"] / _MM2, oil["viscosity_100_mm2_s"] / _MM2
    yield Check(
        source=oil["source"],
        quantity="viscosity index",
        unit="",
        printed=oil["viscosity_index"],
        computed=viscosity_index(cool, hot),
    )
    line = astm_d341_line(40.0 + _ZERO_CELSIUS, cool, 100.0 + _ZERO_CELSIUS, hot)
    for state in data["oil_in_operation"]:
        other = state.get("temperature_of_print_degC")
        yield Check(
            source=state["source"],
            quantity=f"ν, {state['temperature_degC']:g} °C",
            unit="mm²/s",
            printed=state["viscosity_mm2_s"],
            computed=_on_line(line, state["temperature_degC"]),
            explanation="" if other is None else _OTHER_TEMPERATURE,
            evidence=None if other is None else _on_line(line, other),
            deviation=0.05 * float(state["viscosity_mm2_s"]),
        )


def _contact() -> Iterator[Check]:
    film = published("campanha_2008")["film"]
    radius, ellipticity = _convex_contact(film)
    yield Check(
        source=film["source"],
        quantity="R, convex",
        unit="mm",
        printed=film["convex_radius_mm"],
        computed=radius / MM,
        explanation=_CONVEX_RADIUS,
    )
    yield Check(
        source=film["source"],
        quantity="k, convex",
        unit="",
        printed=film["convex_ellipticity"],
        computed=ellipticity,
        explanation=_CONVEX_ELLIPSE,
    )
    speed = float(film["speed_mm_s"])
    yield Check(
        source=film["source"],
        quantity="U",
        unit="mm/s",
        printed=film["speed_mm_s"],
        computed=_right_speed(film) / MM,
        explanation=_SUM_OF_SPEEDS,
        evidence=0.5 * speed,
        corrected=film["mean_speed_mm_s"],
        deviation=0.5 * speed + half_unit(film["mean_speed_mm_s"]),
    )


def _condition(film: Mapping[str, Any], condition: Mapping[str, Any]) -> Iterator[Check]:
    source = f"{film['source']}, condition {condition['name']}"
    yield Check(
        source=source,
        quantity="α",
        unit="10⁻⁸/Pa",
        printed=condition["pressure_viscosity_1e8"],
        computed=float(wooster(condition["viscosity_cP"] * 1e-3)) * 1e8,
    )
    printed = condition["central_thickness_um"]
    yield Check(
        source=source,
        quantity="h_c",
        unit="µm",
        printed=printed,
        computed=right_film(film, condition) / _MICROMETRE,
        explanation=_FILM,
        evidence=film_with_the_authors_choices(film, condition) / _MICROMETRE,
        deviation=_A_THIRD * float(printed),
    )


def _parameters(film: Mapping[str, Any], condition: Mapping[str, Any]) -> Iterator[Check]:
    for case in film["lambda"]:
        if case["condition"] != condition["name"]:
            continue
        roughness = _MICROMETRE * float(
            np.hypot(case["inner_roughness_um"], case["ball_roughness_um"])
        )
        printed = case["film_parameter"]
        yield Check(
            source=f"{film['source']}, condition {case['condition']}",
            quantity=f"λ, bearing {case['bearing']}",
            unit="",
            printed=printed,
            computed=right_film(film, condition) / roughness,
            explanation=_PARAMETER,
            evidence=film_with_the_authors_choices(film, condition) / roughness,
            deviation=_A_THIRD * float(printed),
        )


def _on_line(line: ViscosityLine, celsius: float) -> float:
    return float(astm_d341(celsius + _ZERO_CELSIUS, line)) * _MM2


def _modulus(film: Mapping[str, Any]) -> float:
    poisson_ratio = published("campanha_2008")["bearing_6305"]["poisson_ratio"]
    material = steel(film["youngs_modulus_GPa"] * 1e9, poisson_ratio)
    return effective_modulus(material, material)


def _curvatures(film: Mapping[str, Any]) -> tuple[float, float]:
    """Of the inner contact, along and across rolling, in 1/m."""
    bearing = published("campanha_2008")["bearing_6305"]
    conformity = film["groove_radius_mm"] / bearing["ball_diameter_mm"]
    curvature = race_curvature(
        bearing["ball_diameter_mm"] * MM,
        bearing["pitch_diameter_mm"] * MM,
        conformity,
        0.0,
        "inner",
    )
    return float(curvature.rolling), float(curvature.across)


def _convex_contact(film: Mapping[str, Any]) -> tuple[float, float]:
    """Radius of all curvatures (m) and ratio of the axes, the groove taken for convex."""
    bearing = published("campanha_2008")["bearing_6305"]
    rolling, _ = _curvatures(film)
    across = 2.0 / (bearing["ball_diameter_mm"] * MM) + 1.0 / (film["groove_radius_mm"] * MM)
    ratio = across / rolling  # R_x/R_y of the author, with x and y exchanged
    return 1.0 / (rolling + across), float(brewe_hamrock_ellipticity(ratio))


def _right_speed(film: Mapping[str, Any]) -> float:
    """Mean of the surface speeds, in m/s."""
    bearing = published("campanha_2008")["bearing_6305"]
    gamma = bearing["ball_diameter_mm"] / bearing["pitch_diameter_mm"]
    return float(
        rolling_entrainment_speed(
            bearing["pitch_diameter_mm"] * MM, gamma, film["speed_rpm"] * RPM, 0.0
        )
    )
