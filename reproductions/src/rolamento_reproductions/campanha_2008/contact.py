"""Oil and contact as chapter 4.4.3 has them, and the maximum shear: chapters 2.5 and 4.2."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from rolamento.contact.hertz import HertzContact, effective_modulus, elliptical_contact
from rolamento.contact.subsurface import maximum_shear
from rolamento.geometry import Race, race_curvature
from rolamento.life.iso16281 import race_ratings, reference_life
from rolamento.lubrication.regime import crack_origin
from rolamento.static import RadialSolution, radial_load
from rolamento.units import MILLIMETRE
from rolamento.verification import Check
from rolamento.verification.campanha_2008 import LINE_CONTACT_DEPTH, STRIBECK
from rolamento_reproductions.campanha_2008.inputs import (
    GIVEN,
    Number,
    ball_diameter,
    bearing,
    clearances_of_class,
    contact_at,
    film_checks,
    load,
    numbers_table,
    oil_at,
    outer_conformity,
    printed,
    said,
    speed,
    steel_of_film,
    temperature,
)
from rolamento_reproductions.record import Claim, Section, Table
from rolamento_reproductions.text import Text, same

_MILLI = 1e-3


def check_of(quantity: str, condition: str = "") -> Check:
    """Return a verified number by its name, of a condition of the tests if it depends on it."""
    found = [
        check
        for check in film_checks()
        if check.quantity == quantity
        and check.source.endswith(f"condition {condition}" if condition else "")
    ]
    assert len(found) == 1, quantity
    return found[0]


def contact_table() -> Table:
    """Return the numbers of oil and contact."""
    return numbers_table(
        "H", said("contact_table.caption"), GIVEN.source_of("contact"), contact_numbers()
    )


@cache
def contact_numbers() -> tuple[Number, ...]:
    """Return the printed numbers of oil and contact."""
    return (*_oil(), *_radii(), *_ellipse(), *_motion())


# --- oil --------------------------------------------------------------------


def _oil() -> tuple[Number, ...]:
    index = check_of("viscosity index")
    warm, hot = check_of("ν, 83.4 °C"), check_of("ν, 110 °C")
    return (
        Number(
            "viscosity_index",
            said("oil.viscosity_index.quantity"),
            index.printed,
            index.computed,
            index.computed,
            said("oil.viscosity_index.reason"),
        ),
        Number(
            "viscosity_I",
            said("oil.viscosity_i.quantity"),
            warm.printed,
            evidence(warm),
            warm.computed,
            said(
                "oil.viscosity_i.reason",
                temperature_of_print=temperature_of_print(),
                temperature=temperature("I"),
            ),
        ),
        Number(
            "viscosity_II",
            said("oil.viscosity_ii.quantity"),
            hot.printed,
            hot.computed,
            hot.computed,
            said("oil.viscosity_ii.reason"),
        ),
        *(_dynamic(row) for row in GIVEN.inputs_of("contact")["viscosity"]),
        *(_coefficient(condition) for condition in ("I", "II")),
    )


def temperature_of_print() -> float:
    """Return the temperature at which the oil has the viscosity printed for condition I; °C."""
    return float(printed("oil_in_operation")[0]["temperature_of_print_degC"])


def _dynamic(row: dict[str, Any]) -> Number:
    given, condition = GIVEN.inputs_of("contact"), row["condition"]
    oil = oil_at(temperature(condition))
    lighter = said(
        "dynamic.density_cut" if condition == "II" else "dynamic.density",
        temperature=temperature(condition),
        density=float(oil.density) * _MILLI,
    )
    return Number(
        f"dynamic_{condition}",
        said("dynamic.quantity", condition=condition),
        row["dynamic_mPa_s"],
        given["viscosities_mm2_s"][condition] * given["density_g_cm3"],
        float(oil.dynamic_viscosity) / _MILLI,
        lighter,
        cut=condition == "II",
    )


def _coefficient(condition: str) -> Number:
    check = check_of("α", condition)
    return Number(
        f"coefficient_{condition}",
        said("coefficient.quantity", condition=condition),
        check.printed,
        check.computed,
        float(oil_at(temperature(condition)).pressure_viscosity) * 1e8,
        said("coefficient.reason"),
    )


# --- radii ------------------------------------------------------------------


def _radii() -> tuple[Number, ...]:
    given, rings = GIVEN.inputs_of("contact"), printed("bearing_6305")
    ball, pitch = rings["ball_diameter_mm"], rings["pitch_diameter_mm"]
    groove = printed("life")["measured_conformity"] * ball
    rolling, across = curvatures()
    of_ball, of_ring, of_groove = (
        float(given[name]) for name in ("ball_radius_mm", "inner_radius_mm", "groove_radius_mm")
    )
    return (
        Number(
            "ball_radius",
            said("radii.ball_radius.quantity"),
            given["ball_radius_mm"],
            0.5 * ball,
            0.5 * ball,
            same("D_w/2."),
        ),
        Number(
            "ring_radius",
            said("radii.ring_radius.quantity"),
            given["inner_radius_mm"],
            0.5 * (pitch - ball),
            0.5 * (pitch - ball),
            said("radii.ring_radius.reason"),
        ),
        Number(
            "groove_radius",
            said("radii.groove_radius.quantity"),
            given["groove_radius_mm"],
            groove,
            groove,
            said("radii.groove_radius.reason"),
        ),
        Number(
            "rolling_radius",
            said("radii.rolling_radius.quantity"),
            given["rolling_radius_mm"],
            1.0 / (1.0 / of_ball + 1.0 / of_ring),
            1.0 / (rolling * MILLIMETRE),
            said("radii.rolling_radius.reason"),
        ),
        Number(
            "across_radius",
            said("radii.across_radius.quantity"),
            given["across_radius_mm"],
            1.0 / (1.0 / of_ball + 1.0 / of_groove),
            same("{:.0f}", 1.0 / (across * MILLIMETRE)),
            said("radii.across_radius.reason"),
        ),
    )


def curvatures(race: Race = "inner") -> tuple[float, float]:
    """1/R_x and 1/R_y of a contact, with the inner groove as the film takes it; 1/m."""
    rings, film = printed("bearing_6305"), printed("film")
    inner = film["groove_radius_mm"] / rings["ball_diameter_mm"]
    curvature = race_curvature(
        rings["ball_diameter_mm"] * MILLIMETRE,
        rings["pitch_diameter_mm"] * MILLIMETRE,
        inner if race == "inner" else outer_conformity(),
        0.0,
        race,
    )
    return float(curvature.rolling), float(curvature.across)


def _ellipse() -> tuple[Number, ...]:
    rolling, across = curvatures()
    radius, ratio = check_of("R, convex"), check_of("k, convex")
    steel = steel_of_film()
    modulus = effective_modulus(steel, steel)
    contact = elliptical_contact(printed("film")["load_N"], rolling, across, modulus)
    return (
        Number(
            "reduced_radius",
            same("R′ (mm)"),
            radius.printed,
            radius.computed,
            1.0 / ((rolling + across) * MILLIMETRE),
            said("ellipse.reduced_radius.reason"),
        ),
        Number(
            "ellipticity",
            same("k"),
            ratio.printed,
            ratio.computed,
            same("{:.1f}", float(contact.ellipticity)),
            said("ellipse.ellipticity.reason"),
        ),
        Number(
            "modulus",
            same("E′ (MPa)"),
            GIVEN.inputs_of("contact")["modulus_MPa"],
            modulus / 1e6,
            modulus / 1e6,
            said("ellipse.modulus.reason"),
        ),
    )


# --- load and speed ---------------------------------------------------------


def _motion() -> tuple[Number, ...]:
    check = check_of("U")
    heaviest = [
        float(radial_load(bearing(clearance), load(), distribution="discrete").max_ball_load)
        for clearance in clearances_of_class()
    ]
    return (
        Number(
            "ball_load",
            same("W (N)"),
            GIVEN.inputs_of("contact")["ball_load_N"],
            STRIBECK * load() / printed("bearing_6305")["ball_count"],
            said("motion.ball_load.right", *heaviest),
            said("motion.ball_load.reason"),
        ),
        Number(
            "speed",
            same("U (mm/s)"),
            check.printed,
            _printed_speed(),
            check.computed,
            said("motion.speed.reason"),
        ),
    )


def _printed_speed() -> float:
    """U by eq. 4.4.3, φ rounded as printed; mm/s."""
    rings, phi = printed("bearing_6305"), GIVEN.inputs_of("contact")["rounded_gamma"]
    cage = 0.5 * speed() * (1.0 - phi)
    ball = 0.5 * speed() * rings["pitch_diameter_mm"] / rings["ball_diameter_mm"] * (1.0 - phi**2)
    radius = 0.5 * rings["pitch_diameter_mm"]
    return float(radius * ((1.0 - phi) * (speed() - cage) + phi * ball))


def evidence(check: Check) -> float:
    """Return what the program gives with the author's choice."""
    return np.nan if check.evidence is None else check.evidence


def shear_section(title: Text) -> Section:
    """Compute the depth, and judge the failures by it."""
    table = numbers_table(
        "F",
        said("shear_section.caption"),
        GIVEN.source_of("shear"),
        shear_numbers(),
        claims=(_subsurface(), _surface(), _inner_ring()),
    )
    return Section(title, (table,))


@cache
def _heaviest() -> tuple[RadialSolution, RadialSolution]:
    """The new bearing with its minimum and its maximum clearance, a ball under the load."""
    low, high = (
        radial_load(bearing(clearance), load(), distribution="discrete")
        for clearance in clearances_of_class()
    )
    return low, high


def _contacts(inner_conformity: float) -> list[HertzContact]:
    """Inner contacts of the heaviest ball with both clearances."""
    return [
        contact_at(float(state.max_ball_load), inner_conformity, "inner") for state in _heaviest()
    ]


def _measured() -> float:
    return float(printed("life")["measured_conformity"])


def _nominal() -> float:
    return float(GIVEN.inputs_of("ratings")["nominal_conformity"])


def _depths(inner_conformity: float) -> list[float]:
    """Depth of the maximum shear; mm."""
    poisson = printed("bearing_6305")["poisson_ratio"]
    return [
        float(maximum_shear(c.max_pressure, c.semi_major, c.semi_minor, poisson).depth) / MILLIMETRE
        for c in _contacts(inner_conformity)
    ]


@cache
def shear_numbers() -> tuple[Number, ...]:
    """Return the printed depth."""
    whole = contact_at(load(), _nominal(), "inner")
    contact = _contacts(_measured())[0]
    share = _depths(_measured())[0] * MILLIMETRE / float(contact.semi_minor)
    return (
        Number(
            "depth",
            said("shear_numbers.depth.quantity"),
            printed("shear_depth")["greatest_shear_depth_mm"],
            LINE_CONTACT_DEPTH * float(whole.semi_minor) / MILLIMETRE,
            said("shear_numbers.depth.right", *_depths(_measured())),
            said(
                "shear_numbers.depth.reason",
                *(float(state.max_ball_load) / 1e3 for state in _heaviest()),
                share,
                *_depths(_nominal()),
            ),
        ),
    )


def _subsurface() -> Claim:
    depth = float(np.mean(_depths(_measured())))
    lost = GIVEN.inputs_of("shear")["lost_metal_mm"]
    origins = {crack_origin(value * MILLIMETRE, depth * MILLIMETRE) for value in lost}
    return Claim(
        said("subsurface.statement"),
        said("subsurface.finding", *(value / depth for value in lost)),
        origins == {"subsurface"},
    )


def _surface() -> Claim:
    given = GIVEN.inputs_of("shear")
    depth = float(np.mean(_depths(_measured())))
    cracks = [given["crack_share"] * value for value in given["lost_metal_mm"]]
    origins = {crack_origin(value * MILLIMETRE, depth * MILLIMETRE) for value in cracks}
    return Claim(
        said("surface.statement"),
        said("surface.finding", *(value / depth for value in cracks)),
        origins == {"surface"},
    )


def _inner_ring() -> Claim:
    state = _heaviest()[0]
    heaviest = float(state.max_ball_load)
    inner = float(contact_at(heaviest, _measured(), "inner").max_pressure) / 1e9
    outer = float(contact_at(heaviest, outer_conformity(), "outer").max_pressure) / 1e9
    nominal = float(contact_at(heaviest, _nominal(), "inner").max_pressure) / 1e9
    lives = _race_lives(state)
    return Claim(
        said("inner_ring.statement"),
        said(
            "inner_ring.finding",
            nominal=nominal,
            outer=outer,
            inner=inner,
            lives=lives[0] / lives[1],
        ),
        holds=False,
        partly=inner < outer < nominal,
    )


def _race_lives(state: RadialSolution) -> tuple[float, float]:
    """Lives of both races with the grooves as measured; 10^6 rev."""
    rings = printed("bearing_6305")
    ratings = race_ratings(
        printed("life")["dynamic_rating_N"],
        rings["ball_count"],
        ball_diameter(),
        rings["pitch_diameter_mm"] * MILLIMETRE,
        _measured(),
        outer_conformity(),
        0.0,
    )
    loads = state.ball_loads[np.newaxis]
    found = reference_life(loads, loads, ratings)
    return float(found.inner[0, 0]), float(found.outer[0, 0])
