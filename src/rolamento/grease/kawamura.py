"""Life of lithium and urea greases in sealed ball bearings by Kawamura, Minami and Hirata.

    log10 L_50 = 8.50 - 2.02e-6 K d_m n - 2.95e-2 T - 8.36 P/C + K_1      urea
    log10 L_50 = 6.33 - 1.58e-6 K d_m n - 2.18e-2 T - 9.84 P/C + K_1      lithium

L_50 in h, d_m n in mm r/min up to 400 000, d_m of 10 to 100 mm, T in °C from 70 to 180 (urea) or
150 (lithium), K_1 by the base oil. Of a turning outer ring K is the speed of an inner ring that
drives the cage as fast, over its own: (1 + γ)/(1 - γ). Below 70 °C T counts as 70 °C.

Source: Kawamura, Minami and Hirata (2001), as printed by TPI (2202/TE), equations 7-1 and 7-2.
"""

from __future__ import annotations

from math import isnan, nan
from typing import Final

from rolamento.case.grease import BaseOil, Thickener
from rolamento.grease.estimate import MILLIMETRES, GreaseDuty, GreaseLife, GreaseModel, figures
from rolamento.words import Note

__all__ = ["MODEL", "grease_life_kawamura"]


def grease_life_kawamura(
    speed_factor: float,
    temperature: float,
    load_ratio: float,
    thickener: Thickener = "lithium",
    base_oil: BaseOil = "mineral",
) -> float:
    """Life L_50 of the grease by Kawamura and others, within its range; h.

    Parameters
    ----------
    speed_factor
        K d_m n in mm r/min, at most 400 000.
    temperature
        T of the bearing, K, at most that of 150 °C (lithium) or 180 °C (urea); below 70 °C it
        counts as 70 °C.
    load_ratio
        P/C.
    thickener, base_oil
        ``"lithium"`` or ``"urea"``; of lithium greases ``"mineral"``, ``"pao"``, ``"ester"``,
        ``"diester"``, ``"silicone"``, of urea greases ``"mineral"``, ``"pao"``, ``"ester"``,
        ``"ether"``.

    Returns
    -------
    float
        NaN outside the range, for another pair of them, or if a number is not known.

    Kawamura, Minami and Hirata (2001).

    >>> print(f"{grease_life_kawamura(100e3, 273.15 + 80.0, 0.05, 'lithium', 'ester'):.0f} h")
    22699 h
    """
    data, law = figures()["kawamura"], figures()["kawamura"][thickener]
    oil, celsius = law["base_oil"].get(base_oil, nan), temperature - 273.15
    outside = speed_factor > data["most_speed_factor"] or celsius > law["most_temperature"]
    if outside or isnan(speed_factor + celsius + load_ratio + oil):
        return nan
    t = max(celsius, data["least_temperature"])
    exponent = law["a"] - law["b"] * speed_factor - law["c"] * t - law["f"] * load_ratio + oil
    return float(10.0**exponent)


def _evaluate(duty: GreaseDuty) -> GreaseLife:
    data, law = figures()["kawamura"], figures()["kawamura"][duty.thickener]
    turning = (1.0 + duty.ratio) / (1.0 - duty.ratio) if duty.outer_ring_turns else 1.0
    dn, warm, mean = turning * duty.speed_factor, duty.celsius, duty.mean_diameter * MILLIMETRES
    notes = []
    if isnan(duty.load_ratio):
        notes.append(Note("grease_without_load_ratio"))
    if not data["least_diameter"] <= mean <= data["most_diameter"]:
        notes.append(Note("grease_size", {"size": duty.mean_diameter}))
    if dn > data["most_speed_factor"]:
        notes.append(Note("grease_speed_factor", {"limit": data["most_speed_factor"]}))
    if warm > law["most_temperature"]:
        notes.append(Note("grease_too_hot", {"limit": law["most_temperature"] + 273.15}))
    if duty.base_oil not in law["base_oil"]:
        values = {"thickener": duty.thickener, "base_oil": duty.base_oil}
        notes.append(Note("grease_unknown_pair", values))
    refused = bool(notes)
    if warm < data["least_temperature"]:
        least = data["least_temperature"] + 273.15
        notes.append(Note("grease_cool_counts_as", {"temperature": least}))
    hours = nan
    if not refused:
        pair = (duty.thickener, duty.base_oil)
        hours = grease_life_kawamura(dn, duty.temperature, duty.load_ratio, *pair)
    name = f"kawamura_{duty.thickener}"
    return GreaseLife(name, hours, data["source"], data["checked"], tuple(notes))


MODEL: Final = GreaseModel("kawamura", _evaluate)
