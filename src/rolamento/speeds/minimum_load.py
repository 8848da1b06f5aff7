"""The load that keeps balls and rollers rolling: below it inertia and drag make them slide.

Of any ball bearing P ≥ 0.01 C. Of radial bearings in oil, and of angular-contact bearings,

    F_rm = k_r (ν n/1000)^(2/3) (d_m/100)²  kN,      F_am = (k_a C_0/1000) (n d_m/100 000)²

with ν in mm²/s at the temperature of the bearing, n in r/min, d_m in mm, F_am and C_0 in the same
unit. Of thrust ball bearings F_am = A (n/1000)², A as the maker lists it. Of cylindrical roller
bearings, with the thermal reference speed n_r,

    F_rm = k_r (6 + 4 n/n_r) (d_m/100)²  kN,

and of tapered and needle roller bearings F_rm = 0.02 C.

Beside these of a series, makers have rules for all bearings (`general_minimum_shares`), a share of
C or of C_0: side by side they show how well the makers agree.

Source: SKF, Rolling bearings (catalogue 10000 EN).
"""

from __future__ import annotations

from math import degrees, pi
from typing import Any, NamedTuple

from rolamento.io.data import toml_of

__all__ = [
    "GeneralShare",
    "MinimumLoadFactors",
    "RollerLoadFactor",
    "general_minimum_shares",
    "minimum_axial_load",
    "minimum_axial_load_of_thrust",
    "minimum_load_factors",
    "minimum_radial_load",
    "minimum_radial_load_of_rollers",
    "minimum_share",
    "minimum_share_source",
    "minimum_static_share",
    "roller_load_factor",
]

_RPM = 30.0 / pi
_SAME_ANGLE = 4.0


class MinimumLoadFactors(NamedTuple):
    """k_r and k_a of a series; None where there is none."""

    radial: float | None
    axial: float | None


def minimum_share(element: str = "ball") -> float | None:
    """Return P/C that a ball bearing, or F_r/C that a tapered or needle roller bearing needs.

    None of cylindrical rollers, whose minimum load goes with the speed.
    """
    data = toml_of("speeds")["minimum_load"]
    if element == "ball":
        return float(data["share"])
    share = data["rollers"].get(element)
    return share if isinstance(share, float) else None


def minimum_static_share(kind: str, is_full_complement: bool = False) -> float | None:
    """Return F_r/C_0 that a type of roller bearing needs; None where its rule is another."""
    shares = toml_of("speeds")["minimum_load"]["rollers"]["static"].get(kind)
    if shares is None:
        return None
    return float(shares["without_cage" if is_full_complement else "with_cage"])


def minimum_share_source(element: str) -> str:
    """Return where `minimum_share` of such rollers is from."""
    rollers = toml_of("speeds")["minimum_load"]["rollers"]
    return str(rollers["sources"].get(element, rollers["source"]))


class GeneralShare(NamedTuple):
    """A maker's rule for all its bearings: a share of C, or of C_0 where ``of`` is "static"."""

    maker: str
    share: float
    of: str
    source: str
    checked: bool


def general_minimum_shares(
    element: str = "ball", is_full_complement: bool = False
) -> tuple[GeneralShare, ...]:
    """Return what makers ask of all bearings with such elements, side by side.

    Parameters
    ----------
    element
        What rolls, as a case file has it, such as ``"tapered"``.
    is_full_complement
        Whether there is no cage.

    SKF, Requisite minimum load; others with their sources in data/speeds.toml.

    >>> [(one.maker, one.share) for one in general_minimum_shares("tapered")]
    [('SKF', 0.02), ('Schaeffler', 0.02)]
    """
    rolls = "ball" if element == "ball" else "roller"
    found = []
    for row in toml_of("speeds")["minimum_load"]["general"]:
        if rolls not in row or element not in row.get("elements", (element,)):
            continue
        share = row.get(f"{rolls}_full", row[rolls]) if is_full_complement else row[rolls]
        found.append(GeneralShare(row["maker"], share, row["of"], row["source"], row["checked"]))
    return tuple(found)


class RollerLoadFactor(NamedTuple):
    """k_r of a series of cylindrical roller bearings; checked: whether against a print."""

    factor: float
    checked: bool


def roller_load_factor(series: str) -> RollerLoadFactor | None:
    """Return k_r of a series such as ``"NU2"``; None where there is none."""
    for row in toml_of("speeds")["minimum_load"]["rollers"]["by_series"]:
        if series in row["series"]:
            return RollerLoadFactor(row["k_r"], row.get("checked", True))
    return None


def minimum_radial_load_of_rollers(
    factor: float, speed: float, reference_speed: float, mean_diameter: float
) -> float:
    """Return F_rm = k_r (6 + 4 n/n_r) (d_m/100)² kN of a cylindrical roller bearing; N.

    factor: k_r; speed, reference_speed: n and n_r, rad/s; mean_diameter: d_m = (d + D)/2, m.
    """
    ratio = abs(speed) / reference_speed
    return 1e3 * factor * (6.0 + 4.0 * ratio) * (1e3 * mean_diameter / 100.0) ** 2


def minimum_load_factors(series: str, contact_angle: float | None) -> MinimumLoadFactors:
    """Return k_r and k_a of a series.

    series: such as ``"62"``; contact_angle: nominal, of angular-contact bearings, rad.
    """
    data: dict[str, Any] = toml_of("speeds")["minimum_load"]
    for row in data["radial"]:
        if series in row["series"]:
            return MinimumLoadFactors(row["k_r"], None)
    for row in data["axial"]:
        near = contact_angle is not None and (
            abs(degrees(contact_angle) - row["contact_angle_deg"]) <= _SAME_ANGLE
        )
        if series in row["series"] and near:
            return MinimumLoadFactors(row["k_r"], row["k_a"])
    return MinimumLoadFactors(None, None)


def minimum_radial_load(
    factor: float, viscosity: float, speed: float, mean_diameter: float
) -> float:
    """Return F_rm; N.

    factor: k_r; viscosity: ν at the temperature of the bearing, m²/s; speed: rad/s;
    mean_diameter: d_m = (d + D)/2, m.
    """
    product = 1e6 * viscosity * abs(speed) * _RPM / 1000.0
    return 1e3 * factor * float(product ** (2.0 / 3.0)) * (1e3 * mean_diameter / 100.0) ** 2


def minimum_axial_load(
    factor: float, static_rating: float, speed: float, mean_diameter: float
) -> float:
    """Return F_am of an angular-contact bearing; N.

    factor: k_a; static_rating: C_0, N; speed: rad/s; mean_diameter: d_m, m.
    """
    product = abs(speed) * _RPM * 1e3 * mean_diameter / 1e5
    return factor * static_rating / 1000.0 * product**2


def minimum_axial_load_of_thrust(factor: float, speed: float) -> float:
    """Return F_am = A (n/1000)² of a thrust ball bearing; N.

    factor: A as the maker lists it, in N; speed: rad/s.
    """
    return factor * (abs(speed) * _RPM / 1000.0) ** 2
