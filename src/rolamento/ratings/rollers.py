"""Basic load ratings of roller bearings by their internal geometry: ISO 281 and ISO 76.

Line contact is simpler than that of balls in grooves: no conformity, and one closed form behind
each table of the standards. Radial bearings are rated for radial load, thrust bearings (contact
angles above 45°) for axial load.

    C_r = b_m f_c (i L_we cos α)^(7/9) Z^(3/4) D_we^(29/27)
    C_0r = 44 (1 - γ) i Z L_we D_we cos α,   γ = D_we cos α/d_pw

Sources: ISO 281:2007, clauses 7 and 8; ISO 76:2006, clauses 7 and 8; the closed forms of f_c:
Lundberg and Palmgren (1952), as in ISO/TR 1281-1. The tables are in data/iso_ratings.toml.
"""

from __future__ import annotations

from typing import Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.io.data import toml_of
from rolamento.numerics import FloatArray
from rolamento.validate import numbers, one_of

RollerRated = Literal["roller", "roller_thrust"]
"""What the standards rate by one formula, beside the `RatedType` of ball bearings: radial roller
bearings, and those above 45°."""

_RADIAL: Final = 207.9
"""N and mm, as printed; 0.377, the share of the load over the rollers, times the next."""
_THRUST: Final = 551.13373
"""Load of a million revolutions of a roller of 1 mm and 1 mm, in N: B_1 of ISO/TR 1281-1."""
REDUCTION: Final = 0.83
"""λν of radial roller bearings: what edge stress and uneven loading take off the rating."""
THRUST_REDUCTION: Final = 0.73
"""λν of thrust roller bearings."""
_UNEVEN: Final = 0.15
"""1 - 0.15 sin α: what thrust bearings lose by their rollers' not sharing the load evenly."""
_RISK: Final = 4.5
"""Exponent of the load, in the risk of failure: exponent 4 of line contact times Weibull's slope
9/8."""
_CURVATURE: Final = 143.0 / 108.0
_STATIC: Final = 44.0
"""N/mm²: 4000 MPa at the heaviest of Z rollers that carries 5 F_r/Z; ISO 76, 7.1."""
_STATIC_THRUST: Final = 220.0
"""N/mm²: 4000 MPa at each of the Z rollers; ISO 76, 8.1."""
_RIGHT: Final = np.pi / 2
_ROUNDING: Final = 1e-12


def roller_dynamic_factor(gamma: ArrayLike) -> FloatArray:
    """Return f_c of radial roller bearings (N and mm, without b_m).

    Parameters
    ----------
    gamma
        D_we cos α / d_pw, 0.01 to 0.30; NaN outside the standard's table.

    ISO/TR 1281-1: 207.9 · 0.83 γ^(2/9) (1-γ)^(29/27) (1+γ)^(-1/4)
    {1 + [1.04 ((1-γ)/(1+γ))^(143/108)]^(9/2)}^(-2/9), which, rounded, is the table
    of ISO 281:2007, 7.1.
    """
    g = _within(gamma)
    return np.asarray(_RADIAL * REDUCTION * g ** (2.0 / 9.0) * _races(g, 1.04))


def roller_thrust_dynamic_factor(ratio: ArrayLike, contact_angle: ArrayLike) -> FloatArray:
    """Return f_c (cos α)^(7/9) tan α of a thrust roller bearing, at 90° its f_c (N and mm).

    The product is what stands in C_a. Below 90° the table of the standard has f_c at
    γ = D_we cos α/d_pw.

    Parameters
    ----------
    ratio
        D_we / d_pw, 0.01 to 0.30; NaN outside.
    contact_angle
        α, in rad, above 0 and up to 90°.

    ISO/TR 1281-1: 551.13373 · 0.73 (1 - 0.15 sin α) with what `roller_dynamic_factor` has, without
    1.04; ISO 281:2007, table 10 (50°, 65°, 80° and 90°). γ^(2/9) (cos α)^(7/9) tan α is written as
    (D_we/d_pw)^(2/9) sin α, which has a value at 90°.
    """
    size = _within(ratio)
    angle = numbers(contact_angle, "contact_angle")
    g = size * _cosine(angle)
    uneven = 1.0 - _UNEVEN * np.sin(angle)
    shared = size ** (2.0 / 9.0) * np.sin(angle) * _races(g, 1.0)
    return np.asarray(_THRUST * THRUST_REDUCTION * uneven * shared)


def roller_dynamic_rating(
    roller_count: ArrayLike,
    roller_diameter: ArrayLike,
    effective_length: ArrayLike,
    pitch_diameter: ArrayLike,
    contact_angle: ArrayLike = 0.0,
    *,
    kind: str = "cylindrical",
    thrust: bool = False,
    rows: ArrayLike = 1,
    factor: ArrayLike | None = None,
) -> FloatArray:
    """Return the basic dynamic load rating in N: C_r, of thrust bearings the axial C_a.

    Parameters
    ----------
    roller_count
        Z, rollers in a row.
    roller_diameter, effective_length, pitch_diameter
        D_we (mean of a tapered roller), L_we and d_pw, in m.
    contact_angle
        α, of the outer raceway of a tapered bearing, in rad.
    kind
        Type of bearing: b_m depends on it.
    thrust
        Whether it is rated for axial load.
    rows
        i, of radial bearings.
    factor
        f_c to take instead of that of `roller_dynamic_factor`, or, of thrust bearings, of
        `roller_thrust_dynamic_factor`.

    Raises
    ------
    InputError
        If the standard has no b_m for such a bearing.

    ISO 281:2007, 7.1 and 8.1: b_m f_c (i L_we cos α)^(7/9) Z^(3/4) D_we^(29/27); thrust bearings
    b_m f_c (L_we cos α)^(7/9) tan α Z^(3/4) D_we^(29/27), at 90° without cos α and tan α.

    >>> print(f"{1e-3 * roller_dynamic_rating(13, 0.0075, 0.0075, 0.0385):.1f} kN")
    27.9 kN
    """
    diameter = 1e3 * numbers(roller_diameter, "roller_diameter")
    length = 1e3 * numbers(effective_length, "effective_length")
    ratio = diameter / (1e3 * numbers(pitch_diameter, "pitch_diameter"))
    angle = numbers(contact_angle, "contact_angle")
    if thrust:
        angled = np.ones(())
        computed = roller_thrust_dynamic_factor(ratio, angle) if factor is None else factor
    else:
        cosine = np.cos(angle)
        angled = numbers(rows, "rows") * cosine
        computed = roller_dynamic_factor(ratio * cosine) if factor is None else factor
    rollers = numbers(roller_count, "roller_count") ** 0.75
    size = (angled * length) ** (7.0 / 9.0) * diameter ** (29.0 / 27.0)
    return np.asarray(_bearing_factor(kind, thrust) * numbers(computed, "factor") * rollers * size)


def roller_static_rating(
    roller_count: ArrayLike,
    roller_diameter: ArrayLike,
    effective_length: ArrayLike,
    pitch_diameter: ArrayLike,
    contact_angle: ArrayLike = 0.0,
    *,
    thrust: bool = False,
    rows: ArrayLike = 1,
) -> FloatArray:
    """Return the basic static load rating in N: C_0r, of thrust bearings the axial C_0a.

    Parameters
    ----------
    roller_count, roller_diameter, effective_length, pitch_diameter, contact_angle, thrust, rows
        As in `roller_dynamic_rating`.

    ISO 76:2006, 7.1 and 8.1: 44 (1 - γ) i Z L_we D_we cos α; thrust bearings 220 (1 - γ) Z L_we
    D_we sin α: 4000 MPa by Hertz at the heaviest roller on the inner raceway.

    >>> print(f"{1e-3 * roller_static_rating(13, 0.0075, 0.0075, 0.0385):.1f} kN")
    25.9 kN
    """
    diameter = 1e3 * numbers(roller_diameter, "roller_diameter")
    length = 1e3 * numbers(effective_length, "effective_length")
    angle = numbers(contact_angle, "contact_angle")
    cosine = _cosine(angle)
    curved = 1.0 - diameter * cosine / (1e3 * numbers(pitch_diameter, "pitch_diameter"))
    along = _STATIC_THRUST * np.sin(angle) if thrust else _STATIC * cosine
    rollers = numbers(rows, "rows") * numbers(roller_count, "roller_count")
    return np.asarray(curved * along * rollers * length * diameter)


def roller_race_shares(gamma: ArrayLike, inner: float) -> tuple[FloatArray, FloatArray]:
    """Return {1 + T^(±9/2)}^(2/9): what inner and outer race bear alone over what both bear.

    Parameters
    ----------
    gamma
        D_we cos α / d_pw, from 0 to below 1.
    inner
        What the inner race bears less by its turning: 1.04 or 1.038 of radial bearings, else 1.

    T = inner ((1-γ)/(1+γ))^(143/108). Lundberg and Palmgren (1952).
    """
    g = numbers(gamma, "gamma")
    risk = (inner * ((1.0 - g) / (1.0 + g)) ** _CURVATURE) ** _RISK
    return (1.0 + risk) ** (1.0 / _RISK), (1.0 + 1.0 / risk) ** (1.0 / _RISK)


def _races(g: FloatArray, inner: float) -> FloatArray:
    """Return what both races together bear, and how the inner one is curved; without γ^(2/9)."""
    curved = (1.0 - g) ** (29.0 / 27.0) / (1.0 + g) ** 0.25
    return np.asarray(curved / roller_race_shares(g, inner)[0])


def _bearing_factor(kind: str, thrust: bool) -> float:
    factors = toml_of("iso_ratings")["roller_thrust" if thrust else "roller"]["bm"]
    one_of(kind, "kind", factors)
    return float(factors[kind])


def _cosine(angle: FloatArray) -> FloatArray:
    return np.where(angle >= _RIGHT, 0.0, np.cos(angle))


def _within(gamma: ArrayLike) -> FloatArray:
    g = numbers(gamma, "gamma")
    table = toml_of("iso_ratings")["roller"]
    least, most = table["least_gamma"] * (1.0 - _ROUNDING), table["greatest_gamma"]
    return np.where((g >= least) & (g <= most * (1.0 + _ROUNDING)), g, np.nan)
