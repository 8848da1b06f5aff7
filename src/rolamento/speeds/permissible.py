"""The permissible speed: where friction under one's own load and oil balances a heat flow.

With the thermal reference speed n_r, the speed ratio f = n/n_r solves

    K_L f^(5/3) + K_P f = 1,
    K_L = (π/30 000) n_r 1e-7 f_0 (ν n_r)^(2/3) d_m³ / Φ,    K_P = (π/30 000) n_r f_1 P_1 d_m / Φ

with lengths in mm, forces in N, ν in mm²/s, n_r in r/min and the heat flow Φ in W. Under the
reference conditions K_L + K_P = 1 and f = 1. Valid for ν n of 2000 mm²/s · r/min and above, where
Palmgren's M_0 grows with (ν n)^(2/3).

Source: DIN 732-2:1994 (DIN 732:2010).
"""

from __future__ import annotations

from math import isfinite, pi
from typing import Final, NamedTuple

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.words import said

__all__ = ["LEAST_PRODUCT", "HeatShares", "heat_shares", "speed_ratio"]

LEAST_PRODUCT: Final = 2000.0
"""ν n in mm²/s·r/min below which M_0 no longer falls: Palmgren, as Harris (1991), chapter 14."""
_POWER: Final = 5.0 / 3.0


class HeatShares(NamedTuple):
    """K_L and K_P: friction of the lubricant and of the load at n_r, over the heat flow."""

    lubricant: float
    load: float


def speed_ratio(lubricant: float, load: float) -> float:
    """Return f of K_L f^(5/3) + K_P f = 1.

    Parameters
    ----------
    lubricant, load
        K_L and K_P, zero or more and not both zero.

    Raises
    ------
    InputError
        Otherwise.

    DIN 732-2.
    """
    for field, value in (("lubricant", lubricant), ("load", load)):
        if not (isfinite(value) and value >= 0.0):
            raise InputError(said("must not be negative"), field=field, value=value, example="0.52")
    if lubricant == 0.0 and load == 0.0:
        raise InputError(said("must not be zero beside a load share of zero"), field="lubricant")

    def balance(x: FloatArray) -> tuple[FloatArray, FloatArray]:
        value = lubricant * x**_POWER + load * x - 1.0
        return value, _POWER * lubricant * np.cbrt(x) ** 2 + load

    # each part alone gives a ratio that the sum cannot reach
    parts = (lubricant ** (-1.0 / _POWER) if lubricant else np.inf, 1.0 / load if load else np.inf)
    most = np.array([min(parts)])
    found, _ = increasing_root(balance, 0.7 * most, 0.0 * most, most)
    return float(found[0])


def heat_shares(
    reference_speed: float,
    mean_diameter: float,
    heat_flow: float,
    *,
    viscosity: float,
    load: float,
    f_0: float,
    f_1: float,
) -> HeatShares:
    """Return K_L and K_P of DIN 732-2.

    Parameters
    ----------
    reference_speed
        n_r; rad/s.
    mean_diameter
        d_m = (d + D)/2; m.
    heat_flow
        Φ that is given off; W.
    viscosity
        ν of the oil at the temperature of the bearing; m²/s.
    load
        P_1, that of the friction; N.
    f_0, f_1
        Of type and lubrication, and of type and load.
    """
    n, mean = reference_speed * 30.0 / pi, 1e3 * mean_diameter
    power = pi * n / 30e3 / heat_flow
    product = 1e6 * viscosity * n
    return HeatShares(
        power * 1e-7 * f_0 * product ** (2.0 / 3.0) * mean**3, power * f_1 * load * mean
    )
