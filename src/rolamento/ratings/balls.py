"""Basic load ratings of ball bearings by their internal geometry: ISO 281 and ISO 76.

The standards give factors in a table; all tables have a closed form behind them, which also
shows what other grooves would be worth. All functions take numbers or arrays that broadcast,
in SI, and give NaN where the standard gives no number.

Radial bearings with grooved rings, one row or several, are rated by the printed tables; four-point
contact and double-row angular-contact bearings among them. Self-aligning bearings, whose outer race
is a sphere about the bearing's centre, and thrust bearings, which are rated for axial load, have
factors by the closed form: it gives the numbers of their tables to half of the last digit.

Sources: ISO 281:2007; ISO 76:2006; Lundberg and Palmgren (1947). The tables are in
data/iso_ratings.toml.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.io.data import toml_of
from rolamento.numerics import FloatArray
from rolamento.numerics.ellipse import ellipse_of_log_ratio
from rolamento.validate import numbers

__all__ = [
    "INNER_GROOVE",
    "MAXIMUM_GAMMA",
    "SELF_ALIGNING_CONFORMITY",
    "THRUST_CONFORMITY",
    "RatedType",
    "dynamic_factor",
    "dynamic_factor_of_grooves",
    "dynamic_factor_of_open_grooves",
    "dynamic_rating",
    "static_factor",
    "static_factor_of_grooves",
    "static_factor_of_open_grooves",
    "static_rating",
    "thrust_dynamic_factor",
    "thrust_static_factor",
]

RatedType = Literal["radial", "self_aligning", "thrust"]
"""What the standards rate by one formula: radial bearings with grooves in both rings, self-aligning
ones, and thrust bearings (their C and C_0 are axial)."""

MAXIMUM_GAMMA: Final = 0.40
"""The maximum D cos α / d_m of the standards' tables."""

INNER_GROOVE: Final = 0.52
_OUTER_GROOVE: Final = 0.53
"""Conformities of radial bearings up to which the factors hold; ISO 281:2007, 5.1."""
_LARGE_BALL: Final = 25.4
"""Ball diameter in mm above which the dynamic rating grows with D^1.4 (ISO 281)."""
_LARGE_BALL_FACTOR: Final = 3.647
_LUNDBERG_PALMGREN: Final = 98.0665
"""10 kgf, in N and mm: ball load of a million revolutions."""
_DYNAMIC: Final = _LUNDBERG_PALMGREN * 0.41 * 0.95
"""Leading constant of f_c in N and mm: Lundberg and Palmgren's, 0.41 of the load's share over the
balls, and the reduction factor of radial ball bearings."""
_DYNAMIC_SELF_ALIGNING: Final = _LUNDBERG_PALMGREN * 0.41
"""The reduction factor of self-aligning bearings is 1."""
_DYNAMIC_THRUST: Final = _LUNDBERG_PALMGREN * 0.9
"""All balls share an axial load; reduction factor 0.9."""
_UNEVEN: Final = 1.0 / 3.0
"""1 - sin α/3: what thrust bearings lose by their balls' not sharing the load evenly."""
SELF_ALIGNING_CONFORMITY: Final = 0.53
"""f_i behind the tables of self-aligning bearings."""
THRUST_CONFORMITY: Final = 0.535
"""Conformity of both grooves, behind the table of ISO 281 for thrust bearings."""
_THRUST_STATIC_CONFORMITY: Final = 0.54
"""The same for ISO 76."""
_PRESSURE: Final = 4200.0
"""MPa at the heaviest ball under the static rating (ISO 76, ball bearings but self-aligning)."""
_PRESSURE_SELF_ALIGNING: Final = 4600.0
_RIGHT: Final = np.pi / 2
_YOUNGS_MODULUS: Final = 207e3
_POISSON_RATIO: Final = 0.3
_TINY: Final = 1e-9


def dynamic_factor(gamma: ArrayLike, kind: RatedType = "radial") -> FloatArray:
    """Return f_c of ISO 281, interpolated in its table (N and mm, without b_m).

    Parameters
    ----------
    gamma
        D cos α / d_m, 0.01 to 0.40; NaN outside.
    kind
        ``"radial"``, or ``"self_aligning"`` by the closed form; for thrust bearings, whose f_c
        depends on the angle too, see `thrust_dynamic_factor`.

    >>> print(f"{dynamic_factor(0.2):.1f}")
    59.9
    """
    if kind == "radial":
        return _interpolated("dynamic", gamma)
    g = _within(gamma, 0.01, MAXIMUM_GAMMA)
    inner = SELF_ALIGNING_CONFORMITY
    return _dynamic_by_grooves(_DYNAMIC_SELF_ALIGNING, g, inner, _sphere(g), 1.04)


def static_factor(gamma: ArrayLike, kind: RatedType = "radial") -> FloatArray:
    """Return f_0 of ISO 76, interpolated in its table, in N/mm².

    Parameters
    ----------
    gamma
        D cos α / d_m, 0 to 0.40; NaN outside.
    kind
        ``"radial"``; ``"self_aligning"`` or ``"thrust"`` by the closed form.

    >>> print(f"{static_factor(0.2):.1f}")
    14.0
    """
    if kind == "radial":
        return _interpolated("static", gamma)
    if kind == "thrust":
        return thrust_static_factor(gamma)
    return _self_aligning_static_factor(gamma)


def _self_aligning_static_factor(
    gamma: ArrayLike, inner_conformity: ArrayLike = SELF_ALIGNING_CONFORMITY
) -> FloatArray:
    """Return f_0 of self-aligning bearings by Hertz, in N/mm².

    Parameters
    ----------
    gamma
        D cos α / d_m, 0 to 0.40; NaN outside.
    inner_conformity
        Above 0.5; 0.53 gives the numbers of the table.

    ISO 76:2006, table 1: the heaviest ball presses one race with 4600 MPa.
    """
    g = _within(gamma, 0.0, MAXIMUM_GAMMA)
    groove = _open_groove(inner_conformity, "inner_conformity")
    return _static_by_grooves(g, groove, _sphere(np.maximum(g, _TINY)), _PRESSURE_SELF_ALIGNING)


def thrust_dynamic_factor(
    ratio: ArrayLike, contact_angle: ArrayLike, conformity: ArrayLike = THRUST_CONFORMITY
) -> FloatArray:
    """Return f_c (cos α)^0.7 tan α of a thrust bearing, at 90° its f_c (N and mm, without b_m).

    The product is what stands in C_a, and goes over into f_c of 90° without a step.

    Parameters
    ----------
    ratio
        D / d_m, 0.01 to 0.40; NaN outside.
    contact_angle
        α, in rad, up to 90°.
    conformity
        Of both grooves, above 0.5; 0.535 gives the numbers of the tables.

    Lundberg and Palmgren (1947), as in ISO/TR 1281-1; ISO 281:2007, table 4: 90°, 75°, 60° and 45°.
    """
    size = _within(ratio, 0.01, MAXIMUM_GAMMA)
    angle = numbers(contact_angle, "contact_angle")
    g = size * np.where(angle >= _RIGHT, 0.0, np.cos(angle))
    f = _open_groove(conformity, "conformity")
    uneven = 1.0 - _UNEVEN * np.sin(angle)
    races = _races(g, 1.0) * size**0.3 * np.sin(angle)
    return np.asarray(_DYNAMIC_THRUST * uneven * races * _closeness(f))


def thrust_static_factor(
    gamma: ArrayLike, conformity: ArrayLike = _THRUST_STATIC_CONFORMITY
) -> FloatArray:
    """Return f_0 of thrust bearings by Hertz, in N/mm².

    Parameters
    ----------
    gamma
        D cos α / d_m, 0 (90°) to 0.40; NaN outside.
    conformity
        Of both grooves, above 0.5; 0.54 gives the numbers of the table.

    ISO 76:2006, 5.2, with C_0a = f_0 Z D² sin α: the ball presses its inner groove with 4200 MPa.
    """
    g = _within(gamma, 0.0, MAXIMUM_GAMMA)
    groove = _open_groove(conformity, "conformity")
    return _load_at_pressure(1.0 + g / (1.0 - g), groove, _PRESSURE)


def dynamic_factor_of_grooves(
    gamma: ArrayLike, inner_conformity: ArrayLike = 0.52, outer_conformity: ArrayLike = 0.52
) -> FloatArray:
    """Return f_c by the closed form behind the table (N and mm, without b_m).

    With both conformities at 0.52 it gives all 40 numbers of the table, rounded. The standard
    allows no higher rating for closer grooves: what this gives for them is theory, not a rating.

    Parameters
    ----------
    gamma
        D cos α / d_m, between 0 and 1.
    inner_conformity, outer_conformity
        f_i, f_o, groove radius over ball diameter, above 0.5.

    Lundberg and Palmgren (1947), as in ISO/TR 1281-1 (2008 and 2021).
    """
    g = _nan_outside(gamma, "gamma", 0.0, 1.0)
    f_i, f_o = (
        _open_groove(inner_conformity, "inner_conformity"),
        _open_groove(outer_conformity, "outer_conformity"),
    )
    return _dynamic_by_grooves(_DYNAMIC, g, f_i, f_o, 1.04)


def static_factor_of_grooves(
    gamma: ArrayLike, inner_conformity: ArrayLike = 0.52, outer_conformity: ArrayLike = 0.53
) -> FloatArray:
    """Return f_0 by Hertz: the heaviest ball presses one race with 4200 MPa; in N/mm².

    With 0.52 and 0.53 it gives 40 of the table's 41 numbers, rounded, and misses that of
    γ = 0.13 by 0.003: below γ = 0.09 the outer race decides, above it the inner.

    Parameters
    ----------
    gamma
        D cos α / d_m, between 0 and 1.
    inner_conformity, outer_conformity
        f_i, f_o, groove radius over ball diameter, above 0.5.

    ISO 76:2006 with C_0r = 0.2 Z Q cos α; steel of 207 GPa and 0.3.
    """
    g = _nan_outside(gamma, "gamma", 0.0, 1.0)
    f_i, f_o = (
        _open_groove(inner_conformity, "inner_conformity"),
        _open_groove(outer_conformity, "outer_conformity"),
    )
    return _static_by_grooves(g, f_i, f_o, _PRESSURE)


def dynamic_factor_of_open_grooves(
    diameter: FloatArray,
    pitch: FloatArray,
    grooves: tuple[FloatArray, FloatArray],
    angle: FloatArray,
    kind: RatedType = "radial",
) -> FloatArray:
    """Return f_c of the table, lowered for grooves that are more open than it takes, never raised.

    Parameters
    ----------
    diameter, pitch
        D and d_m, in the same unit.
    grooves
        f_i and f_o, above 0.5; of thrust bearings both washers'.
    angle
        α in rad.
    kind
        what is rated.

    ISO 281:2007, 5.1: ratings of more open grooves are to be reduced; by the closed form.
    """
    if kind == "thrust":
        ratio, openest = diameter / pitch, np.maximum(*grooves)
        opened = thrust_dynamic_factor(ratio, angle, np.maximum(_THRUST_STATIC_CONFORMITY, openest))
        full = thrust_dynamic_factor(ratio, angle, _THRUST_STATIC_CONFORMITY)
        return np.asarray(thrust_dynamic_factor(ratio, angle) * opened / full)
    gamma = diameter * np.cos(angle) / pitch
    if kind == "self_aligning":
        usual = SELF_ALIGNING_CONFORMITY
        lower = _closeness(np.maximum(grooves[0], usual)) / _closeness(usual)
        return np.asarray(dynamic_factor(gamma, kind) * lower)
    return _lowered(dynamic_factor, dynamic_factor_of_grooves, gamma, grooves)


def static_factor_of_open_grooves(
    diameter: FloatArray,
    pitch: FloatArray,
    grooves: tuple[FloatArray, FloatArray],
    angle: FloatArray,
    kind: RatedType = "radial",
) -> FloatArray:
    """Return f_0 likewise, in N/mm²; parameters as of `dynamic_factor_of_open_grooves`.

    ISO 76:2006: ratings of more open grooves are to be reduced; by the closed form.
    """
    gamma = diameter * np.where(angle >= _RIGHT, 0.0, np.cos(angle)) / pitch
    if kind == "thrust":
        openest = np.maximum(_THRUST_STATIC_CONFORMITY, np.maximum(*grooves))
        return thrust_static_factor(gamma, openest)
    if kind == "self_aligning":
        return _self_aligning_static_factor(gamma, np.maximum(SELF_ALIGNING_CONFORMITY, grooves[0]))
    return _lowered(static_factor, static_factor_of_grooves, gamma, grooves)


def dynamic_rating(
    ball_count: ArrayLike,
    ball_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    contact_angle: ArrayLike = 0.0,
    *,
    kind: RatedType = "radial",
    rows: ArrayLike = 1,
    factor: ArrayLike | None = None,
) -> FloatArray:
    """Return the basic dynamic load rating in N: C_r, of thrust bearings the axial C_a.

    Parameters
    ----------
    ball_count
        Z, balls in a row.
    ball_diameter
        D, in m.
    pitch_diameter
        d_m, in m.
    contact_angle
        α, nominal, in rad.
    kind
        What the bearing is rated as.
    rows
        i, of radial bearings.
    factor
        f_c to take instead of the table's, such as that of `dynamic_factor_of_grooves`; of thrust
        bearings f_c (cos α)^0.7 tan α, as of `thrust_dynamic_factor`.

    ISO 281:2007, equations 1 and 2: b_m f_c (i cos α)^0.7 Z^(2/3) D^1.8, and above 25.4 mm
    3.647 D^1.4 in the place of D^1.8. Thrust bearings, equations 5 to 8: b_m f_c (cos α)^0.7 tan α
    Z^(2/3) D^1.8, at 90° b_m f_c Z^(2/3) D^1.8, likewise.

    >>> print(f"{1e-3 * dynamic_rating(8, 0.01905, 0.08112):.1f} kN")
    61.9 kN
    """
    d = 1e3 * numbers(ball_diameter, "ball_diameter")
    angle = numbers(contact_angle, "contact_angle")
    ratio = d / (1e3 * numbers(pitch_diameter, "pitch_diameter"))
    size = np.where(d <= _LARGE_BALL, d**1.8, _LARGE_BALL_FACTOR * d**1.4)
    balls = numbers(ball_count, "ball_count") ** (2.0 / 3.0)
    if kind == "thrust":
        shared = np.ones(())
        computed = thrust_dynamic_factor(ratio, angle) if factor is None else factor
    else:
        cosine = np.cos(angle)
        shared = (numbers(rows, "rows") * cosine) ** 0.7
        computed = dynamic_factor(ratio * cosine, kind) if factor is None else factor
    f_c = numbers(computed, "factor")
    return np.asarray(toml_of("iso_ratings")["dynamic"]["bm"] * f_c * shared * balls * size)


def static_rating(
    ball_count: ArrayLike,
    ball_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    contact_angle: ArrayLike = 0.0,
    *,
    kind: RatedType = "radial",
    rows: ArrayLike = 1,
    factor: ArrayLike | None = None,
) -> FloatArray:
    """Return the basic static load rating in N: C_0r, of thrust bearings the axial C_0a.

    Parameters
    ----------
    ball_count, ball_diameter, pitch_diameter, contact_angle, kind, rows
        As in `dynamic_rating`.
    factor
        f_0 in N/mm² to take instead of the table's.

    ISO 76:2006, equations 1 and 4: f_0 i Z D² cos α; of thrust bearings f_0 Z D² sin α.

    >>> print(f"{1e-3 * static_rating(8, 0.01905, 0.08112):.1f} kN")
    38.0 kN
    """
    d = 1e3 * numbers(ball_diameter, "ball_diameter")
    angle = numbers(contact_angle, "contact_angle")
    cosine = np.where(angle >= _RIGHT, 0.0, np.cos(angle))
    gamma = d * cosine / (1e3 * numbers(pitch_diameter, "pitch_diameter"))
    f_0 = static_factor(gamma, kind) if factor is None else numbers(factor, "factor")
    balls = numbers(rows, "rows") * numbers(ball_count, "ball_count")
    along = np.sin(angle) if kind == "thrust" else cosine
    return np.asarray(f_0 * balls * d**2 * along)


def _dynamic_by_grooves(
    leading: float, g: FloatArray, f_i: ArrayLike, f_o: ArrayLike, inner: float
) -> FloatArray:
    """Return f_c of a radial bearing; inner: what its inner race bears less by its turning."""
    f_i, f_o = np.asarray(f_i), np.asarray(f_o)
    grooves = inner * (f_i / f_o * (2.0 * f_o - 1.0) / (2.0 * f_i - 1.0)) ** 0.41
    return np.asarray(leading * _races(g, grooves) * g**0.3 * _closeness(f_i))


def _closeness(conformity: ArrayLike) -> FloatArray:
    """Return what the closeness of a groove is worth in f_c: (2f / (2f - 1))^0.41."""
    f = np.asarray(conformity)
    return np.asarray((2.0 * f / (2.0 * f - 1.0)) ** 0.41)


def _static_by_grooves(
    g: FloatArray, f_i: FloatArray, f_o: FloatArray, pressure: float
) -> FloatArray:
    """Return f_0 of a radial bearing, of the race that decides; pressure in MPa."""
    inner = _load_at_pressure(1.0 + g / (1.0 - g), f_i, pressure)
    outer = _load_at_pressure(1.0 - g / (1.0 + g), f_o, pressure)
    return np.asarray(np.minimum(inner, outer) / 5.0)


def _lowered(
    table: Callable[[FloatArray], FloatArray],
    closed_form: Callable[[FloatArray, ArrayLike, ArrayLike], FloatArray],
    gamma: FloatArray,
    grooves: tuple[FloatArray, FloatArray],
) -> FloatArray:
    """Return a factor of the table times what the closed form loses by more open grooves."""
    inner, outer = np.maximum(grooves[0], INNER_GROOVE), np.maximum(grooves[1], _OUTER_GROOVE)
    full = closed_form(gamma, INNER_GROOVE, _OUTER_GROOVE)
    return np.asarray(table(gamma) * closed_form(gamma, inner, outer) / full)


def _races(g: FloatArray, grooves: ArrayLike) -> FloatArray:
    """Return what both races together bear, and how the inner one is curved; without γ^0.3."""
    ratio = ((1.0 - g) / (1.0 + g)) ** 1.72 * np.asarray(grooves)
    shared = (1.0 + ratio ** (10.0 / 3.0)) ** -0.3
    return np.asarray(shared * (1.0 - g) ** 1.39 / (1.0 + g) ** (1.0 / 3.0))


def _sphere(g: FloatArray) -> FloatArray:
    """Return the outer race's radius over D: a sphere about the bearing's centre."""
    return np.asarray(0.5 * (1.0 + 1.0 / g))


def _load_at_pressure(curvature: FloatArray, conformity: FloatArray, pressure: float) -> FloatArray:
    """Return the load on a ball of 1 mm at a pressure in MPa; `curvature` is D/(2 Rx).

    p_0 = 3kQ/(2πa²) with a³ = 6k²E Q/(πS E′) gives Q = (2πp_0/3k)³ (6k²E/(πS E′))².
    """
    rolling, across = 2.0 * curvature, 2.0 - 1.0 / conformity
    # a race may be as hollow as the ball is round, to rounding
    ellipse = ellipse_of_log_ratio(np.minimum(np.log(across / rolling), 0.0))
    k = ellipse.ellipticity
    modulus = _YOUNGS_MODULUS / (1.0 - _POISSON_RATIO**2)
    size = 6.0 * k * k * ellipse.second / (np.pi * (rolling + across) * modulus)
    load = (2.0 * np.pi * pressure / (3.0 * k)) ** 3 * size**2
    return np.asarray(load)


def _interpolated(name: str, gamma: ArrayLike) -> FloatArray:
    steps, factors = _factor_table(name)
    found = np.interp(numbers(gamma, "gamma"), steps, factors, np.nan, np.nan)
    return np.asarray(found, dtype=np.float64)


@lru_cache(maxsize=2)
def _factor_table(name: str) -> tuple[FloatArray, FloatArray]:
    table = toml_of("iso_ratings")[name]
    factors = np.array(table["factors"])
    steps = np.round(table["first_gamma"] + table["gamma_step"] * np.arange(factors.size), 9)
    return steps, factors


def _within(gamma: ArrayLike, least: float, most: float) -> FloatArray:
    g = numbers(gamma, "gamma")
    margin = 1.0 + 1e-12
    return np.where((g * margin >= least) & (g <= most * margin), g, np.nan)


def _nan_outside(value: ArrayLike, field: str, minimum: float, maximum: float) -> FloatArray:
    number = numbers(value, field)
    return np.where((number > minimum) & (number < maximum), number, np.nan)


def _open_groove(conformity: ArrayLike, field: str) -> FloatArray:
    return _nan_outside(conformity, field, 0.5, np.inf)
