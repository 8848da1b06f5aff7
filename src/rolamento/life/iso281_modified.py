"""Modified rating life: a_ISO from viscosity ratio, contamination and fatigue load limit.

    L_nm = a_1 a_ISO L_10
    a_ISO = 0.1 [1 - (2.5671 - c/κ^p)^0.83 (e_C C_u/P)^(1/3)]^-9.3, at most 50;

of thrust bearings with e_C C_u/(3 P_a) in the place of e_C C_u/P. Of roller bearings

    a_ISO = 0.1 [1 - (1.5859 - c/κ^p) (e_C C_u/P)^0.4]^-9.185, at most 50,

of thrust bearings with e_C C_u/(2.5 P_a).

The fatigue load limit C_u is the load under which the heaviest contact just reaches the pressure
that the steel withstands for ever, 1500 MPa: by Hertz from the geometry, or estimated as a share
of the static rating. A roller's profile counts: at this pressure it carries on its middle part.

Sources: ISO 281:2007, 9.3 and annex B. The constants 0.2288, 22, 100 mm and 1500 MPa of annex B
and the rule on additives (e_C from 0.2, a_ISO up to 3) agree with a public transcription of the
standard in the source of another bearing program; 0.2288 is J_r(½), the continuous load integral.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.contact.hertz import elliptical_contact
from rolamento.contact.line import EXPONENT, contact_constant
from rolamento.geometry import Race, race_curvature
from rolamento.io.data import toml_of
from rolamento.life.contamination import ContaminationLevel
from rolamento.life.theory import (
    CLEANLINESS,
    OF_BEARING,
    OF_EQUIVALENT_LOAD,
    OF_LUBRICATION,
    VISCOSITY_RATIO,
    Theory,
)
from rolamento.numerics import BoolArray, FloatArray
from rolamento.ratings import RatedType, rated_as
from rolamento.validate import numbers, positive

if TYPE_CHECKING:
    from rolamento.life.basis import Basis
    from rolamento.life.record import Life

MINIMUM_RATIO: Final = 0.1
"""κ below which the standard gives no factor."""
MAXIMUM_RATIO: Final = 4.0
"""κ above which nothing more is gained."""
MAXIMUM_FACTOR: Final = 50.0
MINIMUM_FACTOR: Final = 0.1
"""a_ISO at the end of its range: at κ = 0.1, and with e_C = 0."""
FATIGUE_PRESSURE: Final = 1.5e9
"""Greatest Hertz pressure that bearing steel withstands for ever; Pa. ISO 281:2007, annex B."""
WITH_ADDITIVES: Final = 3.0
"""Most of a_ISO that extreme-pressure additives can make up for a thin film."""
_MINIMUM_CLEANLINESS: Final = 0.2
"""e_C from which the additives count."""
_RADIAL_MEAN: Final = 0.2288
"""Radial load over Z times that of the heaviest ball: J_r(0.5), without clearance."""
_LARGE: Final = 0.1
"""Pitch diameter above which fatigue strength falls with size; m."""
_STATIC_SHARE: Final = 22.0
_ROLLER_MEAN: Final = 0.2453
"""The same for line contact."""
_ROLLER_STATIC_SHARE: Final = 8.2
_ROLLER_SIZE: Final = 0.3
"""Power of the pitch diameter, with which fatigue strength of roller bearings falls."""


def fatigue_load_limit(
    static_rating: ArrayLike, pitch_diameter: ArrayLike, *, rollers: bool = False
) -> FloatArray:
    """Fatigue load limit C_u estimated from the static rating; N.

    Parameters
    ----------
    static_rating : array, C_0; N.
    pitch_diameter : array that broadcasts with it; m.
    rollers : whether the rolling elements are rollers.

    ISO 281:2007, B.3.3: C_0/22, times (100/D_pw)^0.5 above 100 mm; of roller bearings C_0/8.2,
    times (100/D_pw)^0.3; steel only.

    >>> print(f"{1e-3 * fatigue_load_limit(22e3, 0.05):.1f} kN")
    1.0 kN
    """
    rating = positive(static_rating, "static_rating")
    if rollers:
        return np.asarray(
            rating / _ROLLER_STATIC_SHARE * _size_factor(pitch_diameter, _ROLLER_SIZE)
        )
    return np.asarray(rating / _STATIC_SHARE * _size_factor(pitch_diameter))


def fatigue_load_limit_of_contacts(
    ball_count: ArrayLike,
    ball_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    inner_conformity: ArrayLike,
    outer_conformity: ArrayLike,
    contact_angle: ArrayLike,
    modulus: ArrayLike,
    *,
    rows: ArrayLike = 1,
    pressure: ArrayLike = FATIGUE_PRESSURE,
    kind: RatedType = "radial",
) -> FloatArray:
    """Fatigue load limit C_u from the contact pressure at the weaker race; N.

    Parameters
    ----------
    ball_count : array, Z of a row.
    ball_diameter, pitch_diameter : arrays; m.
    inner_conformity, outer_conformity : arrays.
    contact_angle : array, nominal α; rad.
    modulus : array, E' of ball and ring; Pa.
    rows : array, i.
    pressure : array, of the fatigue limit; Pa.
        All broadcast against each other.

    kind : what the bearing is rated as; of thrust bearings C_u is axial.

    ISO 281:2007, B.3.2: 0.2288 Z Q_u i cos α, times (100/D_pw)^0.5 above 100 mm, with exact
    Hertz contacts. Thrust bearings: Z Q_u sin α, the axial load with Q_u on every ball, which is
    C_0a/22 as the estimate has it (some transcriptions have twice as much).
    """
    races: tuple[tuple[Race, ArrayLike], ...] = (
        ("inner", inner_conformity),
        ("outer", outer_conformity),
    )
    loads = []
    for race, conformity in races:
        curvature = race_curvature(ball_diameter, pitch_diameter, conformity, contact_angle, race)
        unit = elliptical_contact(1.0, curvature.rolling, curvature.across, modulus)
        loads.append((numbers(pressure, "pressure") / unit.max_pressure) ** 3)
    angle = numbers(contact_angle, "contact_angle")
    mean = np.sin(angle) if rated_as(kind)["axial"] else _RADIAL_MEAN * np.cos(angle)
    shared = mean * numbers(ball_count, "ball_count") * numbers(rows, "rows")
    return np.asarray(shared * np.minimum(*loads) * _size_factor(pitch_diameter))


def fatigue_load_limit_of_lines(
    roller_count: ArrayLike,
    roller_diameter: ArrayLike,
    effective_length: ArrayLike,
    pitch_diameter: ArrayLike,
    contact_angle: ArrayLike,
    modulus: ArrayLike,
    inner_drop: ArrayLike,
    outer_drop: ArrayLike,
    *,
    rows: ArrayLike = 1,
    pressure: ArrayLike = FATIGUE_PRESSURE,
    thrust: bool = False,
) -> FloatArray:
    """Fatigue load limit C_u of roller bearings from the contact pressure at the weaker race; N.

    Parameters
    ----------
    roller_count : array, Z of a row.
    roller_diameter, effective_length, pitch_diameter : arrays; m.
    contact_angle : array, nominal α; rad.
    modulus : array, E' of roller and ring; Pa.
    inner_drop, outer_drop : arrays (…, slices), of the profiles of roller and race together at
        slices of equal width, m; zeros for straight lines. Only differences along the roller count.
    rows : array, i.
    pressure : array, of the fatigue limit; Pa.
        All but the drops broadcast against each other, and with what these have before their last
        axis.
    thrust : whether the bearing is rated for axial load; C_u then is axial.

    The roller is pressed without tilt until its most loaded slice reaches the pressure, by Hertz;
    the others follow by the slice law of ISO/TS 16281 for one contact. ISO 281:2007, B.3.2:
    0.2453 Z Q_u i cos α, times (100/D_pw)^0.3 above 100 mm; thrust bearings Z Q_u sin α. With the
    profile of ISO/TS 16281 it gives about the C_0/8.2 of the estimate, which supposes such a one.
    """
    length, elastic = numbers(effective_length, "effective_length"), numbers(modulus, "modulus")
    angle = numbers(contact_angle, "contact_angle")
    diameter = numbers(roller_diameter, "roller_diameter")
    right = angle >= np.pi / 2
    gamma = np.where(right, 0.0, diameter * np.cos(angle)) / numbers(
        pitch_diameter, "pitch_diameter"
    )
    law = contact_constant(length, elastic) / length
    loads = []
    for sign, drop in ((-1.0, inner_drop), (1.0, outer_drop)):
        curvature = 2.0 / (diameter * (1.0 + sign * gamma))
        heaviest = 2.0 * np.pi * numbers(pressure, "pressure") ** 2 / (elastic * curvature)
        approach = (heaviest / law) ** (1.0 / EXPONENT)
        away = numbers(drop, "drop")
        away = away - away.min(axis=-1, keepdims=True)
        depth = np.maximum(approach[..., np.newaxis] - away, 0.0)
        loads.append(length * law * np.mean(depth**EXPONENT, axis=-1))
    mean = np.sin(angle) if thrust else _ROLLER_MEAN * np.cos(angle)
    shared = mean * numbers(roller_count, "roller_count") * numbers(rows, "rows")
    return np.asarray(shared * np.minimum(*loads) * _size_factor(pitch_diameter, _ROLLER_SIZE))


def life_modification_factor(
    viscosity_ratio: ArrayLike,
    contamination_factor: ArrayLike,
    fatigue_load_limit: ArrayLike,
    equivalent_load: ArrayLike,
    *,
    additives: bool = False,
    rollers: bool = False,
) -> FloatArray:
    """Factor a_ISO of radial bearings; of thrust bearings with C_u/3 for C_u (rollers C_u/2.5).

    Parameters
    ----------
    viscosity_ratio : array, κ; counted as 4 above 4.
    contamination_factor : array, e_C, 0 to 1.
    fatigue_load_limit, equivalent_load : arrays, C_u and P; N.
        All broadcast against each other.
    additives : whether the lubricant has effective extreme-pressure additives: from e_C = 0.2
        on, κ below 1 then counts as 1, but a_ISO as 3 at most (and never less than without).
    rollers : whether the rolling elements are rollers.

    Returns
    -------
    a_ISO of the broadcast shape, at most 50; NaN where κ < 0.1.

    ISO 281:2007, 9.3.3.

    >>> print(f"{life_modification_factor(2.0, 0.5, 1000.0, 5000.0):.2f}")
    4.20
    """
    ratio = positive(viscosity_ratio, "viscosity_ratio", zero=True)
    clean = numbers(contamination_factor, "contamination_factor")
    limit = positive(fatigue_load_limit, "fatigue_load_limit")
    load = positive(equivalent_load, "equivalent_load", zero=True)
    with np.errstate(divide="ignore", invalid="ignore"):
        strength = np.where(clean == 0.0, 0.0, clean * limit / load)
    law = _roller_factor if rollers else _factor
    factor = law(ratio, strength)
    if not additives:
        return factor
    helped = np.minimum(law(np.maximum(ratio, 1.0), strength), WITH_ADDITIVES)
    counts = (ratio < 1.0) & (clean >= _MINIMUM_CLEANLINESS) & (ratio >= MINIMUM_RATIO)
    return np.where(counts, np.maximum(factor, helped), factor)


def bounded_modification_factor(
    viscosity_ratio: ArrayLike,
    contamination_factor: ArrayLike,
    fatigue_load_limit: ArrayLike,
    equivalent_load: ArrayLike,
    *,
    additives: bool = False,
    rollers: bool = False,
) -> FloatArray:
    """a_ISO, and below κ = 0.1 the 0.1 that it ends with: an upper bound there.

    a_ISO does not fall with κ, and at κ = 0.1 it is 0.1 whatever the dirt and the load. Parameters
    and result as `life_modification_factor`.
    """
    factor = life_modification_factor(
        viscosity_ratio,
        contamination_factor,
        fatigue_load_limit,
        equivalent_load,
        additives=additives,
        rollers=rollers,
    )
    return np.where(
        numbers(viscosity_ratio, "viscosity_ratio") < MINIMUM_RATIO, MINIMUM_FACTOR, factor
    )


def modification_notes(
    viscosity_ratio: ArrayLike, contamination_factor: ArrayLike
) -> dict[str, BoolArray]:
    """Where a_ISO has no value or meets a limit, by name; arrays.

    viscosity_ratio_too_small: κ < 0.1, the standard gives no factor, and the life is below a tenth;
    viscosity_ratio_capped: κ > 4; contamination_severe: e_C of 0, wear and not fatigue ends the
    life, below a tenth.
    """
    ratio = numbers(viscosity_ratio, "viscosity_ratio")
    return {
        "viscosity_ratio_too_small": np.asarray(ratio < MINIMUM_RATIO),
        "viscosity_ratio_capped": np.asarray(ratio > MAXIMUM_RATIO),
        "contamination_severe": np.asarray(
            numbers(contamination_factor, "contamination_factor") <= 0.0
        ),
    }


def _factor(ratio: FloatArray, strength: FloatArray) -> FloatArray:
    """a_ISO by κ and e_C C_u/P; NaN outside the standard, 50 where no stress hurts."""
    ratio, strength = np.broadcast_arrays(np.minimum(ratio, MAXIMUM_RATIO), strength)
    lubrication = np.full(ratio.shape, np.nan)
    for row in toml_of("iso281")["modification_factor"]["ranges"]:
        own = (ratio >= row["from"]) & (ratio <= row["to"])
        lubrication[own] = (2.5671 - row["c"] / ratio[own] ** row["p"]) ** 0.83
    with np.errstate(invalid="ignore", divide="ignore"):
        remaining = 1.0 - lubrication * np.cbrt(strength)
        factor = 0.1 * np.maximum(remaining, 0.0) ** -9.3
    return np.asarray(np.minimum(factor, MAXIMUM_FACTOR))


def _roller_factor(ratio: FloatArray, strength: FloatArray) -> FloatArray:
    """a_ISO of rollers, likewise."""
    ratio, strength = np.broadcast_arrays(np.minimum(ratio, MAXIMUM_RATIO), strength)
    lubrication = np.full(ratio.shape, np.nan)
    for row in toml_of("iso281")["roller_modification_factor"]["ranges"]:
        own = (ratio >= row["from"]) & (ratio <= row["to"])
        # 1e-5 below zero at κ = 0.1, by the rounding of the constants
        lubrication[own] = np.maximum(1.5859 - row["c"] / ratio[own] ** row["p"], 0.0)
    with np.errstate(invalid="ignore", divide="ignore"):
        remaining = 1.0 - lubrication * strength**0.4
        factor = 0.1 * np.maximum(remaining, 0.0) ** -9.185
    return np.asarray(np.minimum(factor, MAXIMUM_FACTOR))


def _size_factor(pitch_diameter: ArrayLike, power: float = 0.5) -> FloatArray:
    diameter = positive(pitch_diameter, "pitch_diameter")
    large = _LARGE / np.maximum(diameter, _LARGE)
    return np.asarray(np.sqrt(large) if power == 0.5 else large**power)


def modification(
    basis: Basis, load: FloatArray | None = None
) -> tuple[dict[str, FloatArray], dict[str, BoolArray]]:
    """Factors of a modified life, and notes on them; needs κ and e_C.

    load: the equivalent load; the reference life's own if not given.
    """
    ratio, clean = basis.viscosity_ratio, basis.contamination_factor
    assert ratio is not None
    assert clean is not None
    factor = basis.modification_factor(ratio, clean, load)
    notes = modification_notes(ratio, clean)
    unlimited = np.isnan(basis.ratings.fatigue).any(axis=1)
    notes["no_fatigue_load_limit"] = unlimited & ~notes["viscosity_ratio_too_small"]
    if isinstance(basis.given.contamination, ContaminationLevel):
        notes["cleanliness_in_words"] = (clean > 0.0) & (clean < 1.0)
    factors = {
        "a_1": basis.reliability_factor,
        "a_iso": factor,
        "viscosity_ratio": ratio,
        "contamination_factor": clean,
    }
    return factors, notes


def _evaluate(basis: Basis) -> Life:
    factors, notes = modification(basis, basis.loads.dynamic)
    return basis.record(THEORY.name, basis.basic_life, factors, {**basis.notes_on_load(), **notes})


THEORY: Final = Theory(
    name="iso281_modified",
    evaluate=_evaluate,
    asked=lambda basis: basis.contamination_factor is not None,
    needs=(VISCOSITY_RATIO, CLEANLINESS),
    validity=(*OF_BEARING, *OF_EQUIVALENT_LOAD, *OF_LUBRICATION),
    rank=1,
    standard=True,
)
