"""A 6305 bearing: maximum shear under a ball, oil film, measured clearances, tested lives.

The film: the author takes the sum of the surface speeds for their mean, the hollow groove for a
convex one, and then exchanges x and y. The first makes the film thicker, the others thinner, so
that his film is only a fifth too thin, and his film parameters with it.

The clearances: the table gives one number for a range of bores and a class of clearance, and
follows from the radial equilibrium of usual bearings with a ball under the load: the minimum
clearances share the load among several balls, the wide ones leave it all to one.

The lives: all three printed lives L_10h are regressions of ln ln 1/(1 - F) on ln t with exact
median ranks, of some of the tests.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Final

import numpy as np

from rolamento.case.bearing import Bearing
from rolamento.case.material import Material
from rolamento.clearance.measuring_load import measuring_load_correction
from rolamento.clearance.standards import CLEARANCE_CLASSES, class_clearance
from rolamento.contact.hertz import (
    HertzContact,
    brewe_hamrock_ellipticity,
    effective_modulus,
    elliptical_contact,
)
from rolamento.contact.subsurface import maximum_shear
from rolamento.geometry import race_curvature
from rolamento.kinematics import rolling_entrainment_speed
from rolamento.life.iso281 import basic_rating_life, hours
from rolamento.lubrication.film_thickness import central_film, film_groups
from rolamento.oil import ViscosityLine, astm_d341, astm_d341_line, viscosity_index, wooster
from rolamento.ratings import dynamic_factor_of_grooves
from rolamento.units import MICROMETRE, MILLIMETRE, RPM
from rolamento.verification.check import Check, bearing_of, half_unit, published, steel
from rolamento.weibull import (
    LifeTest,
    WeibullFit,
    bounds,
    maximum_likelihood,
    published_life_test,
    rank_regression,
)
from rolamento.words import Note

STRIBECK: Final = 5.0
"""Z times the heaviest ball's load over the radial load, with usual clearance. Stribeck (1901)."""
LINE_CONTACT_DEPTH: Final = 0.5
"""Depth over the minor semi-axis that the author takes."""
A_THIRD: Final = 1.0 / 3.0
"""The most by which the exact depth may exceed the printed one, and a printed film be too thin."""

_WHOLE_LOAD: Final = Note("verify_campanha_whole_load")


def inner_contact(load: float) -> HertzContact:
    """Return the contact of a ball of the 6305 with the inner race, under a load in N."""
    given = published("campanha_2008")["bearing_6305"]
    material = steel(given["youngs_modulus_GPa"] * 1e9, given["poisson_ratio"])
    curvature = race_curvature(
        given["ball_diameter_mm"] * MILLIMETRE,
        given["pitch_diameter_mm"] * MILLIMETRE,
        given["inner_conformity"],
        0.0,
        "inner",
    )
    modulus = effective_modulus(material, material)
    return elliptical_contact(load, curvature.rolling, curvature.across, modulus)


def checks() -> Iterator[Check]:
    """Compare depth of the maximum shear, oil, film, clearances, rating, life and life tests."""
    yield _shear_depth()
    yield from film_checks()
    yield from clearance_checks()
    yield from life_checks()
    yield from weibull_checks()


def _shear_depth() -> Check:
    data = published("campanha_2008")
    given, printed = data["bearing_6305"], data["shear_depth"]
    whole = printed["radial_load_N"]
    contact = inner_contact(STRIBECK * whole / given["ball_count"])
    shear = maximum_shear(
        contact.max_pressure, contact.semi_major, contact.semi_minor, given["poisson_ratio"]
    )
    return Check(
        source=printed["source"],
        quantity="z(τ_max)",
        unit="mm",
        printed=printed["greatest_shear_depth_mm"],
        computed=float(shear.depth) / MILLIMETRE,
        explanation=_WHOLE_LOAD,
        deviation=A_THIRD * float(printed["greatest_shear_depth_mm"]),
        evidence=LINE_CONTACT_DEPTH * float(inner_contact(whole).semi_minor) / MILLIMETRE,
    )


_ZERO_CELSIUS: Final = 273.15
_MM2: Final = 1e6

_OTHER_TEMPERATURE: Final = Note("verify_campanha_other_temperature")
_SUM_OF_SPEEDS: Final = Note("verify_campanha_sum_of_speeds")
_CONVEX_RADIUS: Final = Note("verify_campanha_convex_radius")
_CONVEX_ELLIPSE: Final = Note("verify_campanha_convex_ellipse")
_FILM: Final = Note("verify_campanha_film")
_PARAMETER: Final = Note("verify_campanha_parameter")


def film_checks() -> Iterator[Check]:
    """Compare the oil, the film and the film parameters."""
    yield from _oil_checks()
    yield from _convex_contact_checks()
    film = published("campanha_2008")["film"]
    for condition in film["condition"]:
        yield from _film_of_condition(film, condition)
        yield from _film_parameters(film, condition)


def right_film(film: Mapping[str, Any], condition: Mapping[str, Any]) -> float:
    """Central film at the inner race, in m: mean speed, hollow groove, R_x, exact ellipse."""
    modulus = _film_modulus(film)
    rolling, across = _film_curvatures(film)
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
        _film_modulus(film),
        condition["viscosity_cP"] * 1e-3,
        wooster(condition["viscosity_cP"] * 1e-3),
    )
    return float(central_film(groups)) * radius


def _oil_checks() -> Iterator[Check]:
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
            computed=_viscosity_on_line(line, state["temperature_degC"]),
            explanation=None if other is None else _OTHER_TEMPERATURE,
            evidence=None if other is None else _viscosity_on_line(line, other),
            deviation=0.05 * float(state["viscosity_mm2_s"]),
        )


def _convex_contact_checks() -> Iterator[Check]:
    film = published("campanha_2008")["film"]
    radius, ellipticity = _convex_contact(film)
    yield Check(
        source=film["source"],
        quantity="R, convex",
        unit="mm",
        printed=film["convex_radius_mm"],
        computed=radius / MILLIMETRE,
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
        computed=_right_speed(film) / MILLIMETRE,
        explanation=_SUM_OF_SPEEDS,
        evidence=0.5 * speed,
        corrected=film["mean_speed_mm_s"],
        deviation=0.5 * speed + half_unit(film["mean_speed_mm_s"]),
    )


def _film_of_condition(film: Mapping[str, Any], condition: Mapping[str, Any]) -> Iterator[Check]:
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
        computed=right_film(film, condition) / MICROMETRE,
        explanation=_FILM,
        evidence=film_with_the_authors_choices(film, condition) / MICROMETRE,
        deviation=A_THIRD * float(printed),
    )


def _film_parameters(film: Mapping[str, Any], condition: Mapping[str, Any]) -> Iterator[Check]:
    for case in film["lambda"]:
        if case["condition"] != condition["name"]:
            continue
        roughness = MICROMETRE * float(
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
            deviation=A_THIRD * float(printed),
        )


def _viscosity_on_line(line: ViscosityLine, celsius: float) -> float:
    return float(astm_d341(celsius + _ZERO_CELSIUS, line)) * _MM2


def _film_modulus(film: Mapping[str, Any]) -> float:
    poisson_ratio = published("campanha_2008")["bearing_6305"]["poisson_ratio"]
    material = steel(film["youngs_modulus_GPa"] * 1e9, poisson_ratio)
    return effective_modulus(material, material)


def _film_curvatures(film: Mapping[str, Any]) -> tuple[float, float]:
    """Curvatures of the inner contact, along and across rolling, in 1/m."""
    bearing = published("campanha_2008")["bearing_6305"]
    conformity = film["groove_radius_mm"] / bearing["ball_diameter_mm"]
    curvature = race_curvature(
        bearing["ball_diameter_mm"] * MILLIMETRE,
        bearing["pitch_diameter_mm"] * MILLIMETRE,
        conformity,
        0.0,
        "inner",
    )
    return float(curvature.rolling), float(curvature.across)


def _convex_contact(film: Mapping[str, Any]) -> tuple[float, float]:
    """Radius of all curvatures (m) and ratio of the axes, the groove taken for convex."""
    bearing = published("campanha_2008")["bearing_6305"]
    rolling, _ = _film_curvatures(film)
    across = 2.0 / (bearing["ball_diameter_mm"] * MILLIMETRE) + 1.0 / (
        film["groove_radius_mm"] * MILLIMETRE
    )
    ratio = across / rolling  # R_x/R_y of the author, with x and y exchanged
    return 1.0 / (rolling + across), float(brewe_hamrock_ellipticity(ratio))


def _right_speed(film: Mapping[str, Any]) -> float:
    """Mean of the surface speeds, in m/s."""
    bearing = published("campanha_2008")["bearing_6305"]
    gamma = bearing["ball_diameter_mm"] / bearing["pitch_diameter_mm"]
    return float(
        rolling_entrainment_speed(
            bearing["pitch_diameter_mm"] * MILLIMETRE, gamma, film["speed_rpm"] * RPM, 0.0
        )
    )


_NO_NAMES: Final = Note("verify_campanha_no_names")


def clearance_checks() -> Iterator[Check]:
    """Compare the corrections and the classes."""
    data = published("campanha_2008")
    for row in data["measuring_load"]["row"]:
        yield from _measuring_load_corrections(data["measuring_load"]["source"], row)
    for printed in data["clearance_class"]:
        yield from _clearance_class_limits(printed)


def measured_bearing(row: Mapping[str, Any]) -> Bearing:
    """Return the bearing that stands for a row of the table; its clearance is zero."""
    conformity = published("campanha_2008")["measuring_load"]["conformity"]
    return bearing_of(
        {**row, "inner_conformity": conformity, "outer_conformity": conformity},
        Material.named("100Cr6"),
        diametral_clearance=0.0,
    )


def _measuring_load_corrections(source: str, row: Mapping[str, Any]) -> Iterator[Check]:
    bearing = measured_bearing(row)
    for name in CLEARANCE_CLASSES:
        band = class_clearance(row["bore_mm"] * MILLIMETRE, name)
        printed = row[f"{name}_um"]
        clearances = (band.middle,) if len(printed) == 1 else band
        for number, clearance in zip(printed, clearances, strict=True):
            yield Check(
                source=f"{source}, {row['load_N']:g} N",
                quantity=f"ΔP_d, {row['bearing']} {name}",
                unit="µm",
                printed=number,
                computed=measuring_load_correction(bearing, clearance, row["load_N"]) / MICROMETRE,
                explanation=_NO_NAMES,
            )


def _clearance_class_limits(printed: Mapping[str, Any]) -> Iterator[Check]:
    band = class_clearance(printed["bore_mm"] * MILLIMETRE, printed["class"])
    for which, number, limit in zip(("min", "max"), printed["range_um"], band, strict=True):
        yield Check(
            source=printed["source"],
            quantity=f"P_d {which}, {printed['bearing']} {printed['class']}",
            unit="µm",
            printed=number,
            computed=limit / MICROMETRE,
        )


_ROUNDED_GROOVE: Final = Note("verify_campanha_rounded_groove")
_BALL_13_32: Final = 25.4 * 13.0 / 32.0
"""mm: 13/32 in, which the text rounds to 10.319 mm."""
_GROOVE_ROUNDING: Final = 0.5
"""Rounding of f_c: what a hundredth of a millimetre of the groove makes."""


def life_checks() -> Iterator[Check]:
    """Compare f_c of the measured grooves and L_10 in hours."""
    data = published("campanha_2008")
    bearing, life = data["bearing_6305"], data["life"]
    diameter = bearing["ball_diameter_mm"]
    gamma = diameter / bearing["pitch_diameter_mm"]
    outer = life["outer_conformity"]
    rounded = life["groove_radius_mm"] / _BALL_13_32
    yield Check(
        source=life["source"],
        quantity="f_c",
        unit="",
        printed=life["factor_of_measured_grooves"],
        computed=float(dynamic_factor_of_grooves(gamma, life["measured_conformity"], outer)),
        explanation=_ROUNDED_GROOVE,
        deviation=_GROOVE_ROUNDING,
        evidence=float(
            dynamic_factor_of_grooves(_BALL_13_32 / bearing["pitch_diameter_mm"], rounded, outer)
        ),
    )
    basic = basic_rating_life(life["dynamic_rating_N"], life["load_N"])
    yield Check(
        source=life["source_of_life"],
        quantity="L_10h",
        unit="h",
        printed=life["basic_life_h"],
        computed=float(hours(basic, life["speed_rpm"] * RPM)),
    )


SHAPE: Final = 1.5
"""Shape of bearing fatigue where a test gives none: that of the factor a_1 in ISO 281:1990."""
CONFIDENCE: Final = 0.95
"""Confidence of the lower bound where nothing failed."""

_SURVIVORS: Final = 0.9
_FAILED_ALONE: Final = (11, 12, 13, 14)
"""The tests of procedure II."""
_WITH_FIVE: Final = (2, 3, 4, 5, *_FAILED_ALONE)
_TESTS_OF_II: Final = (6, 7, 8, 9, 10)
_DEVIATION: Final = 0.4
"""Fraction of the printed life: the most by which the explanations below say that it is too
long."""
_FOUR: Final = Note("verify_campanha_four")
_FIVE: Final = Note("verify_campanha_five")
_AS_IF: Final = Note("verify_campanha_as_if")
_ALL_BEARINGS: Final = Note("verify_campanha_all_bearings")
_LOWER_BOUND: Final = Note("verify_campanha_lower_bound")


def condition(name: str, *, without: Iterable[int] = ()) -> LifeTest:
    """Return the tests of a condition, "I" or "II", both bearings of each; without some tests."""
    whole = published_life_test("campanha_2008").by_group()[name]
    return whole.select(~np.isin(whole.rig, [str(number) for number in without]))


def once_each(numbers: Iterable[int], *, failed: bool | None = None) -> LifeTest:
    """Return tests as the dissertation counts them: one row each, failed where one bearing did.

    Parameters
    ----------
    numbers
        Of the tests.
    failed
        What to take all of them for, if not as they ended.
    """
    whole = published_life_test("campanha_2008")
    chosen = [str(number) for number in numbers]
    times = [float(whole.times[whole.rig == name].max()) for name in chosen]
    ended = [bool(whole.failed[whole.rig == name].any()) for name in chosen]
    return LifeTest(times, ended if failed is None else failed, rig=chosen, unit=whole.unit)


def four_failures() -> LifeTest:
    """Return the tests behind 246.7 h."""
    return once_each(_FAILED_ALONE)


def five_failures() -> LifeTest:
    """Return the tests behind 242.3 h."""
    return once_each(_WITH_FIVE)


def as_if_failed() -> LifeTest:
    """Return the tests behind 117.4 h."""
    return once_each(_TESTS_OF_II, failed=True)


def as_plotted(test: LifeTest) -> WeibullFit:
    """Fit a line as the dissertation does."""
    return rank_regression(test, "y_on_x")


def weibull_checks() -> Iterator[Check]:
    """Compare the three lives: with the choices behind them, and with what all bearings say."""
    lives = published("campanha_2008")["tested_life"]
    for key, chosen, told, whole, right in (
        ("condition_I", four_failures(), _FOUR, condition("I"), _ALL_BEARINGS),
        ("without_test_5", five_failures(), _FIVE, condition("I", without=(5,)), _ALL_BEARINGS),
        ("condition_II", as_if_failed(), _AS_IF, condition("II"), _LOWER_BOUND),
    ):
        printed = lives[key]["printed"]
        yield Check(
            source=lives[key]["source"],
            quantity="L_10h",
            unit="h",
            printed=printed,
            computed=as_plotted(chosen).l10,
            explanation=told,
        )
        yield Check(
            source=lives[key]["source"],
            quantity="L_10h, all",
            unit="h",
            printed=printed,
            computed=maximum_likelihood(whole).l10 if whole.failures else minimum_life(SHAPE),
            explanation=right,
            evidence=_life_by_likelihood_equations(whole)
            if whole.failures
            else _lower_bound(whole),
            corrected=lives[key]["corrected"],
            deviation=_DEVIATION * float(printed),
        )


def minimum_life(shape: float) -> float:
    """Return the lower bound of L_10h in condition II at a shape; h."""
    found = bounds(condition("II"), "L10", shape=shape, sides="lower", confidence=CONFIDENCE)
    return found.lower


def _life_by_likelihood_equations(test: LifeTest) -> float:
    """L_10 by McCool's equations, without the engine."""
    from scipy.optimize import brentq

    time, log_time = test.times, np.log(test.times)
    failed = float(log_time[test.failed].mean())

    def profile(shape: float) -> float:
        power = time**shape
        return 1.0 / shape + failed - float(power @ log_time) / float(power.sum())

    shape = brentq(profile, 0.1, 50.0)
    scale = (float((time**shape).sum()) / test.failures) ** (1.0 / shape)
    return float(scale * (-np.log(_SURVIVORS)) ** (1.0 / shape))


def _lower_bound(test: LifeTest) -> float:
    """L_10 that a test without failures leaves possible, without the engine."""
    ratio = np.log(_SURVIVORS) / np.log(1.0 - CONFIDENCE)
    return float((float((test.times**SHAPE).sum()) * ratio) ** (1.0 / SHAPE))
