"""Life of the grease in sealed deep-groove ball bearings by NSK's two formulas.

    log10 t = 6.54 - 2.6 n/N - (0.025 - 0.012 n/N) T      general-purpose grease (mineral oil)
    log10 t = 6.12 - 1.4 n/N - (0.018 - 0.006 n/N) T      wide-range grease (synthetic oil)

t mean life in h, n/N speed over the limiting speed with grease, T in °C. n/N below 0.25 and T below
70 °C count as these; T at most 110 or 130 °C, n/N at most 1, P at most C/10. The first is not
taken for urea greases, which are not what the maker calls general-purpose.

Source: NSK, Rolling Bearings (E1102), grease life of sealed ball bearings.
"""

from __future__ import annotations

from math import isnan, nan
from typing import Final, Literal

from rolamento.grease.estimate import GreaseDuty, GreaseLife, GreaseModel, figures
from rolamento.words import Note

__all__ = ["MODEL", "NskGrease", "grease_life_nsk", "nsk_grease"]

NskGrease = Literal["general", "wide_range"]


def grease_life_nsk(speed_ratio: float, temperature: float, grease: NskGrease = "general") -> float:
    """Mean life of the grease by NSK, within its range; h.

    Parameters
    ----------
    speed_ratio
        n/N, at most 1; less than 0.25 counts as 0.25.
    temperature
        T of the bearing, K, at most that of 110 °C (general) or 130 °C (wide range); below 70 °C
        it counts as 70 °C.
    grease
        ``"general"`` (mineral oil) or ``"wide_range"`` (synthetic oil).

    Returns
    -------
    float
        NaN outside the range, or if a number is not known.

    NSK, Rolling Bearings (E1102).

    >>> print(f"{grease_life_nsk(0.5, 273.15 + 70.0):.0f} h")
    8128 h
    """
    data, law = figures()["nsk"], figures()["nsk"][grease]
    celsius = temperature - 273.15
    known = not isnan(speed_ratio + celsius)
    if not known or speed_ratio > data["most_speed_ratio"] or celsius > law["most_temperature"]:
        return nan
    x = max(speed_ratio, data["least_speed_ratio"])
    t = max(celsius, data["least_temperature"])
    return float(10.0 ** (law["a"] - law["b"] * x - (law["c"] - law["d"] * x) * t))


def nsk_grease(base_oil: str) -> NskGrease:
    """Return which of NSK's two greases one with a base oil is: mineral is for general purposes."""
    return "general" if base_oil == "mineral" else "wide_range"


def _evaluate(duty: GreaseDuty) -> GreaseLife:
    data = figures()["nsk"]
    which = nsk_grease(duty.base_oil)
    notes, most = [], data[which]["most_temperature"]
    ratio, warm, load = duty.speed_ratio, duty.celsius, duty.load_ratio
    if isnan(ratio):
        notes.append(Note("grease_without_limiting_speed"))
    elif ratio > data["most_speed_ratio"]:
        notes.append(Note("grease_too_fast", {"ratio": ratio}))
    if warm > most:
        notes.append(Note("grease_too_hot", {"limit": most + 273.15}))
    if load > data["most_load_ratio"]:
        values = {"ratio": load, "limit": data["most_load_ratio"]}
        notes.append(Note("grease_loaded_too_much", values))
    if which == "general" and duty.thickener == "urea":
        notes.append(Note("grease_law_of_lithium"))
    refused = bool(notes)
    if ratio < data["least_speed_ratio"]:
        notes.append(Note("grease_slow_counts_as", {"ratio": data["least_speed_ratio"]}))
    if warm < data["least_temperature"]:
        least = data["least_temperature"] + 273.15
        notes.append(Note("grease_cool_counts_as", {"temperature": least}))
    hours = nan if refused else grease_life_nsk(ratio, duty.temperature, which)
    return GreaseLife(f"nsk_{which}", hours, data["source"], data["checked"], tuple(notes))


MODEL: Final = GreaseModel("nsk", _evaluate)
