"""Life of the grease in sealed ball bearings by JTEKT's formula.

    log10 L = 6.10 - 4.40e-6 d_m n - 2.50 (P/C - 0.05) - (0.021 - 1.80e-8 d_m n) T

L in h, d_m n in mm r/min, T in °C. d_m n below 125 000, P/C below 0.05 and T below 50 °C count as
these; at most 500 000, 0.16 and 120 °C. From general knowledge of the catalogue, not checked.

Source: JTEKT (Koyo), Ball and Roller Bearings (B2001E).
"""

from __future__ import annotations

from math import isnan, nan
from typing import Final

from rolamento.grease.estimate import GreaseDuty, GreaseLife, GreaseModel, figures
from rolamento.words import Note

__all__ = ["MODEL", "grease_life_jtekt"]


def grease_life_jtekt(speed_factor: float, temperature: float, load_ratio: float) -> float:
    """Life of the grease by JTEKT, within its range; h.

    Parameters
    ----------
    speed_factor
        d_m n in mm r/min, at most 500 000; less than 125 000 counts as that.
    temperature
        T of the bearing, K, at most that of 120 °C; below 50 °C it counts as 50 °C.
    load_ratio
        P/C, at most 0.16; less than 0.05 counts as 0.05.

    Returns
    -------
    float
        NaN outside the range, or if a number is not known.

    JTEKT (Koyo), Ball and Roller Bearings (B2001E).

    >>> print(f"{grease_life_jtekt(200e3, 273.15 + 70.0, 0.05):.0f} h")
    10046 h
    """
    law, celsius = figures()["jtekt"], temperature - 273.15
    outside = (
        speed_factor > law["most_speed_factor"]
        or celsius > law["most_temperature"]
        or load_ratio > law["most_load_ratio"]
    )
    if outside or isnan(speed_factor + celsius + load_ratio):
        return nan
    dn = max(speed_factor, law["least_speed_factor"])
    t = max(celsius, law["least_temperature"])
    load = max(load_ratio, law["least_load_ratio"]) - law["least_load_ratio"]
    exponent = law["a"] - law["b"] * dn - law["load"] * load - (law["c"] - law["d"] * dn) * t
    return float(10.0**exponent)


def _evaluate(duty: GreaseDuty) -> GreaseLife:
    law, dn, warm, load = figures()["jtekt"], duty.speed_factor, duty.celsius, duty.load_ratio
    notes = []
    if isnan(load):
        notes.append(Note("grease_without_load_ratio"))
    if dn > law["most_speed_factor"]:
        notes.append(Note("grease_speed_factor", {"limit": law["most_speed_factor"]}))
    if warm > law["most_temperature"]:
        notes.append(Note("grease_too_hot", {"limit": law["most_temperature"] + 273.15}))
    if load > law["most_load_ratio"]:
        values = {"ratio": load, "limit": law["most_load_ratio"]}
        notes.append(Note("grease_loaded_too_much", values))
    if duty.thickener == "urea":
        notes.append(Note("grease_law_of_lithium"))
    refused = bool(notes)
    if not refused and warm < law["least_temperature"]:
        least = law["least_temperature"] + 273.15
        notes.append(Note("grease_cool_counts_as", {"temperature": least}))
    hours = nan if refused else grease_life_jtekt(dn, duty.temperature, load)
    notes.append(Note("grease_law_unchecked"))
    return GreaseLife("jtekt", hours, law["source"], law["checked"], tuple(notes))


MODEL: Final = GreaseModel("jtekt", _evaluate)
