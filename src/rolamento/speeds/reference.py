"""The thermal reference speed: where a bearing's friction balances a reference heat flow.

With lengths in mm, forces in N, ν in mm²/s and n in r/min,

    (π n/30 000) [1e-7 f_0r (ν n)^(2/3) d_m³ + f_1r P_1 d_m] = q_r A_r     (W)

at an outer ring 50 K above an ambient of 20 °C. Radial bearings: ν = 12 mm²/s, P_1 = 0.05 C_0r,
A_r = π B (D + d), T in the place of B for tapered roller bearings, q_r = 0.016 W/mm² up to
50 000 mm², beyond that × (A_r/50 000)^-0.34. Normal clearance, oil bath to the middle of the lowest
rolling element; the inner ring turns. The standard excludes thrust ball bearings.

Source: ISO 15312:2003.
"""

from __future__ import annotations

from functools import cache
from math import isfinite, pi
from typing import Final, NamedTuple

from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.speeds.permissible import speed_ratio
from rolamento.words import said

__all__ = [
    "ReferenceCoefficients",
    "reference_coefficients",
    "reference_heat_flow",
    "thermal_reference_speed",
]

RPM: Final = 30.0 / pi
_TRIAL: Final = 1000.0
"""r/min at which the two parts of the friction are compared with the heat flow."""


class ReferenceCoefficients(NamedTuple):
    """f_0r and f_1r of a series; checked: whether against a print."""

    f_0r: float
    f_1r: float
    checked: bool = True


@cache
def _by_series() -> dict[str, ReferenceCoefficients]:
    rows = toml_of("speeds")["reference"]["coefficients"]
    return {
        name: ReferenceCoefficients(row["f_0r"], row["f_1r"], row.get("checked", True))
        for row in rows
        for name in row["series"]
    }


def reference_coefficients(series: str) -> ReferenceCoefficients | None:
    """Return f_0r and f_1r of a series such as ``"62"`` or ``"NU2"``; None where there are none."""
    return _by_series().get(series)


def reference_heat_flow(bore: float, outside_diameter: float, width: float) -> float:
    """Return the heat that a radial bearing gives off under reference conditions, q_r A_r; W.

    bore, outside_diameter, width: d, D and B, or T of a tapered one; m. ISO 15312:2003.
    """
    conditions = toml_of("speeds")["reference"]
    radial, knee = conditions["radial"], conditions["knee_area"]
    area = pi * width * (outside_diameter + bore) * 1e6
    density = radial["heat_flow"] * max(area / knee, 1.0) ** -radial["exponent"]
    return float(density * area)


def thermal_reference_speed(
    bore: float,
    outside_diameter: float,
    width: float,
    static_rating: float,
    coefficients: ReferenceCoefficients,
) -> float:
    """Return the thermal reference speed of a radial bearing; rad/s.

    Parameters
    ----------
    bore, outside_diameter, width
        d, D and B, or T of a tapered one, in m.
    static_rating
        C_0r, in N.
    coefficients
        f_0r and f_1r of its series.

    Raises
    ------
    InputError
        If a size or the rating is not above zero, or the bore not below the outside diameter.

    ISO 15312:2003.
    """
    for field, value in (
        ("bore", bore), ("width", width), ("static_rating", static_rating),
        ("outside_diameter", outside_diameter - bore),
    ):  # fmt: skip
        if not (isfinite(value) and value > 0.0):
            rule = (
                said("must be greater than the bore")
                if field == "outside_diameter"
                else said("must be greater than zero")
            )
            raise InputError(rule, field=field, value=value)
    radial = toml_of("speeds")["reference"]["radial"]
    mean = 0.5e3 * (bore + outside_diameter)
    flow = reference_heat_flow(bore, outside_diameter, width)
    of_load = coefficients.f_1r * radial["load_share"] * static_rating * mean

    product = radial["viscosity"] * _TRIAL
    of_oil = 1e-7 * coefficients.f_0r * product ** (2.0 / 3.0) * mean**3
    power = pi * _TRIAL / 30e3 / flow
    return speed_ratio(power * of_oil, power * of_load) * _TRIAL / RPM
