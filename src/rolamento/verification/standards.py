"""Factors of ISO 281 and ISO 76 that follow from a formula, and a reference program for ISO 16281.

ISO 281: f_c, reliability, where the axial load counts. The limit e of the load ratio is where both
lines of the equivalent load meet, (1 - X)/Y, with the factors as the standard prints them; of two
rows that face each other, (1 - X_2)/(Y_2 - Y_1). ISO 76: the table of f_0, by Hertz.

ISO/TS 16281 takes the stiffness of a ball between its races once, at the free contact angle,
however far the angle rises under load. Under radial load at contact angle zero there is nothing to
distinguish the two. Under axial load the bearing of the examples turns from 0° to 13.1°.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import radians
from typing import Final

import numpy as np

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.duty import Duty, Load
from rolamento.life.equivalent_load import load_factors
from rolamento.life.iso16281 import race_ratings, reference_life
from rolamento.life.reliability import reliability_factor
from rolamento.numerics import FloatArray
from rolamento.ratings import dynamic_factor_of_grooves, static_factor_of_grooves
from rolamento.solution import solve
from rolamento.static import axial_load
from rolamento.units import MICROMETRE, MILLIMETRE
from rolamento.verification.check import Check, bearing_of, half_unit, last_unit, published, steel
from rolamento.words import Note

_MPA: Final = 1e6
_STEEP_LOAD: Final = 1.0
"""Relative axial load at steep angles, where it does not matter; MPa."""
_OF_THE_FACTORS: Final = Note("verify_iso_of_the_factors")
_HALF_DIGIT: Final = 0.005
"""Half a digit of the printed factors."""
_OF_TWO_ROWS: Final = Note("verify_iso_of_two_rows")


def iso_281_checks() -> Iterator[Check]:
    """Compare f_c over the whole table, a_1 of both editions, and e of one row and of two."""
    data = published("iso_281")
    table = data["dynamic_factor"]
    for step, printed in enumerate(table["factors"], start=1):
        gamma = table["gamma_step"] * step
        yield Check(
            source=table["source"],
            quantity=f"f_c, γ = {gamma:.2f}",
            unit="",
            printed=printed,
            computed=float(dynamic_factor_of_grooves(gamma)),
        )
    for table in data["reliability"]:
        for percent, printed in zip(table["percent"], table["factor"], strict=True):
            yield Check(
                source=table["source"],
                quantity=f"a_1, {percent} %",
                unit="",
                printed=printed,
                computed=float(reliability_factor(float(percent) / 100.0, table["edition"])),
            )
    ratio = data["load_ratio"]
    for row in ratio["shallow"]:
        for load, printed in zip(ratio["relative_axial_load"], row["e"], strict=True):
            yield _load_ratio_check(ratio["source"], row["contact_angle_deg"], load, printed)
    for angle, printed in zip(ratio["steep_angle_deg"], ratio["steep_e"], strict=True):
        yield _load_ratio_check(ratio["source"], angle, "", printed)
    for row in data["double_row"]["shallow"]:
        for load, printed in zip(ratio["relative_axial_load"], row["e"], strict=True):
            angle, source = row["contact_angle_deg"], data["double_row"]["source"]
            if printed:
                yield _load_ratio_check(source, angle, load, printed, double_row=True)


def _load_ratio_check(
    source: str, degrees: int, load: str, printed: str, *, double_row: bool = False
) -> Check:
    megapascal = float(load) if load else _STEEP_LOAD
    factors = load_factors(radians(degrees), megapascal * _MPA, double_row=double_row)
    rows = ", i = 2" if double_row else ""
    rise = float(factors.axial - factors.axial_below)
    short = 1.0 - float(factors.radial)
    room = half_unit(printed) + _HALF_DIGIT * (1.0 + 2.0 * short / rise) / rise
    return Check(
        source=source,
        quantity=f"e, {degrees}°" + (f", {load} MPa" if load else "") + rows,
        unit="",
        printed=printed,
        computed=short / rise,
        tolerance=room if double_row else last_unit(printed),
        explanation=_OF_TWO_ROWS if double_row else _OF_THE_FACTORS,
    )


_GAMMA_OF_ZERO: Final = 1e-12
"""γ in the place of 0, where the closed form begins."""
_EXACT_HERTZ: Final = Note("verify_iso_exact_hertz")
_NOT_ROUNDED: Final = Note("verify_iso_not_rounded")
_NOT_ROUNDED_ROOM: Final = 0.003


def iso_76_checks() -> Iterator[Check]:
    """Compare f_0 over the whole table."""
    table = published("iso_76")["static_factor"]
    for index, printed in enumerate(table["factors"]):
        gamma = table["gamma_step"] * index
        odd = index in table["not_rounded"]
        found = static_factor_of_grooves(max(gamma, _GAMMA_OF_ZERO), *table["conformities"])
        yield Check(
            source=table["source"],
            quantity=f"f_0, γ = {gamma:.2f}",
            unit="N/mm²",
            printed=printed,
            computed=float(found),
            tolerance=half_unit(printed) + (_NOT_ROUNDED_ROOM if odd else 0.0),
            explanation=_NOT_ROUNDED if odd else _EXACT_HERTZ,
        )


_PRECISION: Final = 1e-5
"""Relative, of the reference program: its elliptic integrals are approximate."""
_LIFE_PRECISION: Final = 1e-4
"""Relative, of its lives: loads to about 1e-5 and less, and the life goes with their cube."""
_FROZEN_LIFE: Final = 2e-4
"""Relative: what the stiffness of the loaded angle makes of the life."""
_FROZEN_DEVIATION: Final = 1e-4
"""Relative: the most that the stiffness of the loaded angle may make of it."""

_APPROXIMATE: Final = Note("verify_iso_approximate")
_FROZEN: Final = Note("verify_iso_frozen")
_APPROXIMATE_LOADS: Final = Note("verify_iso_approximate_loads")
_FROZEN_ANGLE: Final = Note("verify_iso_frozen_angle")


def iso_16281_bearing(clearance_mm: float) -> Bearing:
    """Return the bearing of the examples, with a clearance in mm."""
    given = published("iso_16281")["bearing"]
    material = steel(given["youngs_modulus_GPa"] * 1e9, given["poisson_ratio"])
    return bearing_of(given, material, diametral_clearance=clearance_mm * MILLIMETRE)


def iso_16281_checks() -> Iterator[Check]:
    """Compare displacement and life of all examples."""
    data = published("iso_16281")
    for example in data["radial"]["example"]:
        solved = solve(_iso_16281_case(example["clearance_mm"], Load(fz=example["load_N"])))
        yield Check(
            source=data["radial"]["source"],
            quantity=f"δ_r, P_d = {example['clearance_mm']:g} mm",
            unit="µm",
            printed=example["displacement_um"],
            computed=float(solved.displacement.z[0]) / MICROMETRE,
            tolerance=_iso_16281_tolerance(example["displacement_um"]),
            explanation=_APPROXIMATE,
        )
        yield Check(
            source=data["radial"]["source"],
            quantity=f"L_10r, P_d = {example['clearance_mm']:g} mm",
            unit="10⁶",
            printed=example["life_million"],
            computed=iso_16281_life(solved.inner.load),
            tolerance=_LIFE_PRECISION * float(example["life_million"]),
            explanation=_APPROXIMATE_LOADS,
        )
    example = data["axial"]
    solved = solve(_iso_16281_case(example["clearance_mm"], Load(fx=example["load_N"])))
    frozen = axial_load(
        iso_16281_bearing(example["clearance_mm"]), example["load_N"], stiffness_angle="free"
    )
    yield Check(
        source=data["axial"]["source"],
        quantity="δ_a",
        unit="µm",
        printed=example["displacement_um"],
        computed=float(solved.displacement.x[0]) / MICROMETRE,
        tolerance=_iso_16281_tolerance(example["displacement_um"]),
        explanation=_FROZEN,
        evidence=float(frozen.axial_displacement) / MICROMETRE,
        deviation=_FROZEN_DEVIATION * float(example["displacement_um"]),
    )
    printed = example["life_million"]
    yield Check(
        source=data["axial"]["source"],
        quantity="L_10r",
        unit="10⁶",
        printed=printed,
        computed=iso_16281_life(solved.inner.load),
        tolerance=3.0 * _PRECISION * float(printed),
        explanation=_FROZEN_ANGLE,
        evidence=iso_16281_life(np.full_like(solved.inner.load, frozen.ball_load)),
        deviation=_FROZEN_LIFE * float(printed),
    )


def iso_16281_life(loads: FloatArray) -> float:
    """Return the examples' reference life under ball loads, (1, balls), in N; 10⁶ revolutions."""
    given = published("iso_16281")["bearing"]
    ratings = race_ratings(
        given["dynamic_rating_N"],
        given["ball_count"],
        given["ball_diameter_mm"] * MILLIMETRE,
        given["pitch_diameter_mm"] * MILLIMETRE,
        given["inner_conformity"],
        given["outer_conformity"],
        0.0,
    )
    return float(reference_life(loads, loads, ratings).life[0])


def _iso_16281_case(clearance_mm: float, load: Load) -> Case:
    return Case(bearing=iso_16281_bearing(clearance_mm), duty=Duty(load=load))


def _iso_16281_tolerance(printed: str) -> float:
    return max(half_unit(printed), _PRECISION * float(printed))
