"""When a bearing wants new grease: one base interval, and what three sets of factors make of it.

    t_f = K (14e6/(n √d) - 4 d)   h

with n in r/min and d in mm; K 10 of radial ball bearings, 5 of cylindrical and needle rollers, 1 of
others. It is for lithium grease at 70 °C, a horizontal shaft, a turning inner ring, light load and
clean surroundings. Makers draw it as charts today; this is the formula that they stem from.

- SKF: halved for each 15 K above 70 °C, up to doubled below; halved on a vertical shaft, and above
  300 mm of bore; at most 30 000 h. Where the outer ring turns, n D counts in the place of n d_m.
- Noria: factors by steps of temperature, by dust, and 0.3 on a vertical shaft.
- FAG: ranges of reduction factors for temperature, load, dust and moisture, vertical shafts.

Neither gives a number for oscillation: Schaeffler's factor of it is a chart.

The interval is that at whose end 99 % of the bearings are still well lubricated; L_10 = 2.7 times
as long (SKF).

Sources: in data/grease.toml.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import isnan, nan, sqrt
from typing import Any

from rolamento.grease.estimate import MILLIMETRES, figures
from rolamento.records import frozen
from rolamento.units import RPM
from rolamento.validate import finite

__all__ = ["Interval", "base_interval", "fag_interval", "intervals", "noria_interval",
           "skf_interval"]  # fmt: skip

Factors = Mapping[str, tuple[float, float]]


@frozen
class Interval:
    """A relubrication interval; NaN where there is none.

    Attributes
    ----------
    name
        whose factors: "skf", "noria" or "fag"
    low, high
        h; the same but where the factors are ranges
    factors
        least and most of each, by what they are for
    source
        where they are from
    checked
        whether they were compared with a text of the source
    """

    name: str
    low: float
    high: float
    factors: Factors
    source: str
    checked: bool

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values; h, NaN as None."""
        return {
            "name": self.name,
            "low": finite(self.low),
            "high": finite(self.high),
            "factors": {name: list(pair) for name, pair in self.factors.items()},
            "source": self.source,
            "checked": self.checked,
        }


def base_interval(
    speed: float, bore: float, element: str = "ball", *, axial: bool = False
) -> float:
    """Relubrication interval under reference conditions, t_f; h.

    Parameters
    ----------
    speed
        n, rad/s; of a bearing at rest there is none.
    bore
        d, m.
    element
        What rolls: ``"ball"``, ``"cylindrical"``, ``"needle"`` or another roller.
    axial
        Whether it is a thrust bearing.

    Returns
    -------
    float
        NaN where n √d is beyond the formula, which then gives less than nothing.

    SKF, former catalogues.

    >>> print(f"{base_interval(1480 * RPM, 0.050):.3g} h")
    1.14e+04 h
    """
    data = figures()["interval"]
    by_type = data["type_factor"]
    factor = by_type["other"] if axial else by_type.get(element, by_type["other"])
    n, d = speed / RPM, bore * MILLIMETRES
    if not (n > 0.0 and d > 0.0):
        return nan
    found = factor * (14e6 / (n * sqrt(d)) - 4.0 * d)
    return float(found) if found > 0.0 else nan


def skf_interval(
    base: float,
    temperature: float,
    *,
    vertical: bool = False,
    bore: float = nan,
    sizes_ratio: float = 1.0,
) -> Interval:
    """Return the interval with SKF's adjustments.

    Parameters
    ----------
    base
        t_f of `base_interval`, h.
    temperature
        Of the bearing, K.
    vertical
        Whether the shaft stands upright.
    bore
        d, m, of which more than 300 mm halves it.
    sizes_ratio
        D/d_m where the outer ring turns: the speed counts by so much more.

    >>> skf_interval(10_000.0, 273.15 + 85.0, vertical=True).low
    2500.0
    """
    data = figures()["skf"]
    away = (temperature - 273.15 - data["temperature"]) / data["halving"]
    factors = {
        "temperature": min(2.0**-away, data["most_gain"]),
        "vertical_shaft": data["vertical"] if vertical else 1.0,
        "large_bore": data["large"] if bore * MILLIMETRES > data["large_bore"] else 1.0,
        "outer_ring": 1.0 / sizes_ratio,
    }
    return _interval("skf", base, {name: (one, one) for name, one in factors.items()})


def noria_interval(
    base: float, temperature: float, contamination: str = "normal", *, vertical: bool = False
) -> Interval:
    """Return the interval with Noria's factors.

    Parameters
    ----------
    base, temperature, vertical
        As of `skf_interval`.
    contamination
        Level of `life.grease_cleanliness`: ``"high"`` and ``"normal"`` as light dust that does not
        scratch, ``"slight"`` as heavy such dust, ``"severe"`` and ``"very_severe"`` as light and
        heavy dust that scratches.

    >>> round(noria_interval(10_000.0, 273.15 + 70.0, "severe").low, 6)
    2000.0
    """
    data = figures()["noria"]
    warm = next(factor for most, factor in data["temperature"] if temperature - 273.15 <= most)
    factors = {
        "temperature": warm,
        "contamination": data["contamination"][contamination],
        "vertical_shaft": data["vertical"] if vertical else 1.0,
    }
    return _interval("noria", base, {name: (one, one) for name, one in factors.items()})


def fag_interval(
    base: float,
    temperature: float,
    load_ratio: float,
    contamination: str = "normal",
    *,
    vertical: bool = False,
) -> Interval:
    """Return the interval with FAG's reduction factors, which are ranges.

    Parameters
    ----------
    base, temperature, vertical
        As of `skf_interval`.
    load_ratio
        P/C, at most 0.35; NaN counts as light.
    contamination
        Level of `life.grease_cleanliness`.

    Returns
    -------
    Interval
        NaN above 120 °C or P/C of 0.35.

    >>> found = fag_interval(10_000.0, 273.15 + 80.0, 0.12)
    >>> round(found.low), round(found.high)
    (1890, 6000)
    """
    data = figures()["fag"]
    factors = {
        "temperature": _range_of(data["temperature"], temperature - 273.15),
        "load": _range_of(data["load"], 0.0 if isnan(load_ratio) else load_ratio),
        "contamination": tuple(data["contamination"][contamination]),
        "vertical_shaft": tuple(data["vertical"]) if vertical else (1.0, 1.0),
    }
    return _interval("fag", base, factors)


def _range_of(rows: list[list[float]], value: float) -> tuple[float, float]:
    return next(((low, high) for most, low, high in rows if value <= most), (nan, nan))


def _interval(name: str, base: float, factors: Factors) -> Interval:
    most = figures()["interval"]["most_hours"]
    low, high = base, base
    for least, greatest in factors.values():
        low, high = low * least, high * greatest
    data = figures()[name]
    low, high = (value if isnan(value) else min(value, most) for value in (low, high))
    return Interval(name, low, high, factors, data["source"], data["checked"])


def intervals(
    base: float,
    temperature: float,
    load_ratio: float,
    contamination: str,
    *,
    vertical: bool,
    bore: float,
    sizes_ratio: float,
) -> tuple[Interval, ...]:
    """Return the intervals by all sets of factors; parameters as of those."""
    return (
        skf_interval(base, temperature, vertical=vertical, bore=bore, sizes_ratio=sizes_ratio),
        noria_interval(base, temperature, contamination, vertical=vertical),
        fag_interval(base, temperature, load_ratio, contamination, vertical=vertical),
    )
