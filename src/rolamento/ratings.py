"""Basic load ratings of ball bearings by their internal geometry: ISO 281 and ISO 76.

The standards give factors in a table; both tables have a closed form behind them, which also
tells what other grooves would be worth. All functions take numbers or arrays that broadcast,
in SI, and give NaN where the standard gives no number.

Sources: ISO 281:2007; ISO 76:2006; Lundberg and Palmgren (1947). The tables are in
data/iso_ratings.toml.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento._data import toml_of
from rolamento._reach import numbers
from rolamento.numerics import FloatArray
from rolamento.numerics.elliptic import complete

__all__ = [
    "MAXIMUM_GAMMA",
    "dynamic_factor",
    "dynamic_factor_of_grooves",
    "dynamic_rating",
    "static_factor",
    "static_factor_of_grooves",
    "static_rating",
]

MAXIMUM_GAMMA: Final = 0.40
"""The maximum D cos α / d_m of the standards' tables."""

_LARGE_BALL: Final = 25.4
"""Ball diameter in mm above which the dynamic rating grows with D^1.4 (ISO 281)."""
_LARGE_BALL_FACTOR: Final = 3.647
_DYNAMIC: Final = 98.0665 * 0.41 * 0.95
"""Leading constant of f_c in N and mm: Lundberg and Palmgren's 10 kgf, their inner race's 0.41, and
the reduction factor of radial ball bearings."""
_PRESSURE: Final = 4200.0
"""MPa at the heaviest ball under the static rating (ISO 76, radial ball bearings)."""
_YOUNGS_MODULUS: Final = 207e3
_POISSON_RATIO: Final = 0.3
_HALVINGS: Final = 60


def dynamic_factor(gamma: ArrayLike) -> FloatArray:
    """Return f_c of ISO 281, interpolated in its table (N and mm, without b_m).

    Parameters
    ----------
    gamma
        D cos α / d_m, 0.01 to 0.40; NaN outside.
    """
    return _interpolated("dynamic", gamma)


def static_factor(gamma: ArrayLike) -> FloatArray:
    """Return f_0 of ISO 76, interpolated in its table, in N/mm².

    Parameters
    ----------
    gamma
        D cos α / d_m, 0 to 0.40; NaN outside.
    """
    return _interpolated("static", gamma)


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
    grooves = (f_i / f_o * (2.0 * f_o - 1.0) / (2.0 * f_i - 1.0)) ** 0.41
    ratio = 1.04 * ((1.0 - g) / (1.0 + g)) ** 1.72 * grooves
    shared = (1.0 + ratio ** (10.0 / 3.0)) ** -0.3
    size = g**0.3 * (1.0 - g) ** 1.39 / (1.0 + g) ** (1.0 / 3.0)
    return np.asarray(_DYNAMIC * shared * size * (2.0 * f_i / (2.0 * f_i - 1.0)) ** 0.41)


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
    inner = _load_at_pressure(
        1.0 + g / (1.0 - g), _open_groove(inner_conformity, "inner_conformity")
    )
    outer = _load_at_pressure(
        1.0 - g / (1.0 + g), _open_groove(outer_conformity, "outer_conformity")
    )
    return np.asarray(np.minimum(inner, outer) / 5.0)


def dynamic_rating(
    ball_count: ArrayLike,
    ball_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    contact_angle: ArrayLike = 0.0,
    *,
    rows: ArrayLike = 1,
    factor: ArrayLike | None = None,
) -> FloatArray:
    """Return the basic dynamic radial load rating C_r, in N.

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
    rows
        i.
    factor
        f_c to take instead of the table's, such as that of `dynamic_factor_of_grooves`.

    ISO 281:2007, equations 1 and 2: b_m f_c (i cos α)^0.7 Z^(2/3) D^1.8, and above 25.4 mm
    3.647 D^1.4 in the place of D^1.8.
    """
    d = 1e3 * numbers(ball_diameter, "ball_diameter")
    cosine = np.cos(numbers(contact_angle, "contact_angle"))
    gamma = d * cosine / (1e3 * numbers(pitch_diameter, "pitch_diameter"))
    f_c = dynamic_factor(gamma) if factor is None else numbers(factor, "factor")
    size = np.where(d <= _LARGE_BALL, d**1.8, _LARGE_BALL_FACTOR * d**1.4)
    balls = numbers(ball_count, "ball_count") ** (2.0 / 3.0)
    shared = (numbers(rows, "rows") * cosine) ** 0.7
    return np.asarray(toml_of("iso_ratings")["dynamic"]["bm"] * f_c * shared * balls * size)


def static_rating(
    ball_count: ArrayLike,
    ball_diameter: ArrayLike,
    pitch_diameter: ArrayLike,
    contact_angle: ArrayLike = 0.0,
    *,
    rows: ArrayLike = 1,
    factor: ArrayLike | None = None,
) -> FloatArray:
    """Return the basic static radial load rating C_0r, in N.

    Parameters
    ----------
    ball_count, ball_diameter, pitch_diameter, contact_angle, rows
        As in `dynamic_rating`.
    factor
        f_0 in N/mm² to take instead of the table's.

    ISO 76:2006, equation 1: f_0 i Z D² cos α.
    """
    d = 1e3 * numbers(ball_diameter, "ball_diameter")
    cosine = np.cos(numbers(contact_angle, "contact_angle"))
    gamma = d * cosine / (1e3 * numbers(pitch_diameter, "pitch_diameter"))
    f_0 = static_factor(gamma) if factor is None else numbers(factor, "factor")
    balls = numbers(rows, "rows") * numbers(ball_count, "ball_count")
    return np.asarray(f_0 * balls * d**2 * cosine)


def _load_at_pressure(curvature: FloatArray, conformity: FloatArray) -> FloatArray:
    """Return the load on a ball of 1 mm at 4200 MPa; `curvature` is D/(2 Rx).

    p_0 = 3kQ/(2πa²) with a³ = 6k²E Q/(πS E′) gives Q = (2πp_0/3k)³ (6k²E/(πS E′))².
    """
    rolling, across = 2.0 * curvature, 2.0 - 1.0 / conformity
    total = rolling + across
    complement, e = _ellipse((rolling - across) / total)
    modulus = _YOUNGS_MODULUS / (1.0 - _POISSON_RATIO**2)
    k_squared = 1.0 / complement
    size = 6.0 * k_squared * e / (np.pi * total * modulus)
    load = (2.0 * np.pi * _PRESSURE / 3.0) ** 3 * complement**1.5 * size**2
    return np.asarray(load)


def _ellipse(difference: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return (b/a)² and E for F = ((k² + 1)E − 2K)/((k² − 1)E), by halving in log k."""
    shape = np.shape(difference)
    low, high = np.zeros(shape), np.full(shape, np.log(1e6))
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        complement = np.exp(-2.0 * middle)
        K, E = complete(complement)
        with np.errstate(divide="ignore", invalid="ignore"):
            found = ((1.0 + complement) * E - 2.0 * complement * K) / ((1.0 - complement) * E)
        too_flat = found > difference
        low, high = np.where(too_flat, low, middle), np.where(too_flat, middle, high)
    complement = np.where(np.isnan(difference), np.nan, np.exp(-(low + high)))
    return complement, complete(complement)[1]


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


def _nan_outside(value: ArrayLike, field: str, minimum: float, maximum: float) -> FloatArray:
    number = numbers(value, field)
    return np.where((number > minimum) & (number < maximum), number, np.nan)


def _open_groove(conformity: ArrayLike, field: str) -> FloatArray:
    return _nan_outside(conformity, field, 0.5, np.inf)
