"""Permissible axial load of the ribs of a cylindrical roller bearing, by two makers.

Rollers slide with their ends on the ribs: what limits the load is the heat of that friction, and at
low speed the strength of the rib. There is no standard for it; the makers' rules differ by a factor
of up to two, and the smaller one is the careful one.

Sources: NSK, Rolling Bearings (CAT. No. E1102e), 5.6, page A33; SKF, Dynamic axial load carrying
capacity of single row cylindrical roller bearings (skf.com, and Rolling bearings, catalogue 17000
EN): the mechanical limits and the factors k1 and k2 are printed there; the thermal formula itself
is carried from general knowledge of the catalogue.
"""

from __future__ import annotations

from typing import Final, Literal

import numpy as np
from numpy.typing import ArrayLike

from rolamento.numerics import FloatArray
from rolamento.units import RPM
from rolamento.validate import numbers

RibLubricant = Literal["grease", "oil"]

_NSK: Final = {"grease": (900.0, 1500.0, 0.023, 2.5), "oil": (490.0, 1000.0, 0.000135, 3.4)}
_NSK_SIZE: Final = {2: 0.75, 3: 1.0, 4: 1.2}
"""k by diameter series."""
_NSK_MAXIMUM_BORE: Final = 0.2
_SKF: Final = {"grease": (1.0, 0.1), "oil": (1.5, 0.15)}
"""k1, k2 of single-row bearings with cage."""
_SKF_SURFACE: Final = 50_000.0
"""mm²: above it heat leaves less readily, and the rule changes."""
AXIAL_SHARE: Final = 0.5
"""F_a/F_r up to which a single-row bearing with ribs may be loaded; SKF."""


def permissible_axial_load_nsk(
    bore: ArrayLike,
    speed: ArrayLike,
    diameter_series: int,
    lubricant: RibLubricant = "grease",
    *,
    interval: float = 1.0,
) -> FloatArray:
    """Return NSK's permissible axial load C_A of a cylindrical roller bearing with ribs, N.

    Parameters
    ----------
    bore
        d, in m, up to 200 mm; NaN above, where NSK wants to be asked.
    speed
        Of the rings against each other, in rad/s, unsigned.
    diameter_series
        2, 3 or 4; NaN for others, for which no size factor k is printed.
    lubricant
        ``"grease"`` (with extreme-pressure additives) or ``"oil"``.
    interval
        f: 1 for a continuous load, 2 intermittent, 3 for a short time only.

    Equations 5.34 and 5.35: 9.8 f {900 (k d)²/(n + 1500) - 0.023 (k d)^2.5} with grease, and
    9.8 f {490 (k d)²/(n + 1000) - 0.000135 (k d)^3.4} with oil, d in mm and n in min⁻¹; never below
    0. At rest both permit alike, within an eighth up to d = 120 mm: there the rib decides.
    """
    diameter = numbers(bore, "bore")
    kd = 1e3 * diameter * _NSK_SIZE.get(diameter_series, np.nan)
    turns = np.abs(numbers(speed, "speed")) / RPM
    most, offset, less, power = _NSK[lubricant]
    load = 9.8 * interval * (most * kd**2 / (turns + offset) - less * kd**power)
    within = diameter <= _NSK_MAXIMUM_BORE * (1.0 + 1e-9)
    return np.where(within, np.where(np.isnan(load), np.nan, np.maximum(load, 0.0)), np.nan)


def permissible_axial_load_skf(
    bore: ArrayLike,
    outside_diameter: ArrayLike,
    width: ArrayLike,
    static_rating: ArrayLike,
    radial_load: ArrayLike,
    speed: ArrayLike,
    lubricant: RibLubricant = "grease",
    *,
    series_2: bool = False,
) -> FloatArray:
    """Return SKF's permissible constant axial load of a cylindrical roller bearing with ribs, N.

    Parameters
    ----------
    bore, outside_diameter, width
        d, D and B, in m.
    static_rating
        C_0, in N.
    radial_load
        F_r that acts with it, in N.
    speed
        Of the rings against each other, in rad/s, unsigned; at 0 only the ribs' strength limits.
    lubricant
        ``"grease"`` or ``"oil"``.
    series_2
        Whether it is of series 2, whose ribs are weaker in large bearings.

    The least of: k1 C_0 10⁴/(n (d + D)) - k2 F_r, above π B (D + d) = 50 000 mm² with 7.5 C_0^(2/3)
    for C_0 (kN, mm, min⁻¹); 0.0023 D^1.7 kN, in series 2 0.0045 D^1.5; and F_r/2. For κ of 2 and
    more, a misalignment up to 1′, and some 60 K above the surroundings.
    """
    d, outer, wide = (
        1e3 * numbers(value, name)
        for value, name in (
            (bore, "bore"), (outside_diameter, "outside_diameter"), (width, "width")
        )
    )  # fmt: skip
    rating = 1e-3 * numbers(static_rating, "static_rating")
    radial = 1e-3 * numbers(radial_load, "radial_load")
    turns = np.abs(numbers(speed, "speed")) / RPM
    k1, k2 = _SKF[lubricant]
    large = np.pi * wide * (outer + d) > _SKF_SURFACE
    strength = np.where(large, 7.5 * np.cbrt(rating) ** 2, rating)
    with np.errstate(divide="ignore"):
        thermal = k1 * strength * 1e4 / (turns * (d + outer)) - k2 * radial
    mechanical = 0.0045 * outer**1.5 if series_2 else 0.0023 * outer**1.7
    least = np.minimum(np.minimum(thermal, mechanical), AXIAL_SHARE * radial)
    return np.asarray(1e3 * np.maximum(least, 0.0))
