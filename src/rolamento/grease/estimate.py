"""What the laws of a grease's life take and return."""

from __future__ import annotations

from collections.abc import Callable
from math import isnan, log, nan
from typing import Any, Final

from rolamento.case.grease import BaseOil, Thickener
from rolamento.io.data import toml_of
from rolamento.records import frozen
from rolamento.units import RPM, ZERO_CELSIUS
from rolamento.validate import finite
from rolamento.words import Note

__all__ = ["GreaseDuty", "GreaseLife", "GreaseModel", "l10_of_mean", "life_of_mean"]

MILLIMETRES: Final = 1e3


def figures() -> dict[str, Any]:
    """Return the tables of data/grease.toml; not to be changed."""
    return toml_of("grease")


@frozen
class GreaseDuty:
    """What ages the grease of a bearing; NaN where it is not known.

    Attributes
    ----------
    temperature
        of the bearing, K
    speed
        n of the rings against each other, rad/s, 0 or more
    limiting_speed
        N of the maker with grease, rad/s
    mean_diameter
        d_m = (d + D)/2, m
    load_ratio
        P/C
    thickener, base_oil
        of the grease
    outer_ring_turns
        whether the outer ring turns and the inner one stands; then
    ratio
        γ = D cos α/d_m counts
    """

    temperature: float
    speed: float
    limiting_speed: float = nan
    mean_diameter: float = nan
    load_ratio: float = nan
    thickener: Thickener = "lithium"
    base_oil: BaseOil = "mineral"
    outer_ring_turns: bool = False
    ratio: float = 0.0

    @property
    def celsius(self) -> float:
        """T in °C."""
        return self.temperature - ZERO_CELSIUS

    @property
    def speed_factor(self) -> float:
        """Product n d_m in mm r/min."""
        return self.speed / RPM * MILLIMETRES * self.mean_diameter

    @property
    def speed_ratio(self) -> float:
        """Ratio n/N."""
        return self.speed / self.limiting_speed


@frozen
class GreaseLife:
    """Life of a grease by one law.

    Attributes
    ----------
    name
        of the law
    hours
        mean life, of half of the bearings; NaN outside its range
    source
        where the law is from
    checked
        whether it was compared with a text of the source
    notes
        why there is no life, or what was assumed
    """

    name: str
    hours: float
    source: str
    checked: bool
    notes: tuple[Note, ...] = ()

    @property
    def valid(self) -> bool:
        """Whether there is a life."""
        return not isnan(self.hours)

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values; hours, NaN as None."""
        return {
            "name": self.name,
            "hours": finite(self.hours),
            "source": self.source,
            "checked": self.checked,
            "notes": [note.to_mapping() for note in self.notes],
        }


@frozen
class GreaseModel:
    """A law of the life of a grease: its name, and what it makes of a duty."""

    name: str
    evaluate: Callable[[GreaseDuty], GreaseLife]


def life_of_mean(hours: float, reliability: float) -> float:
    """Life that a share of the bearings reaches, from the mean one; in the unit of the life.

    The scatter is that which SKF's L_10 = 2.7 L_1 stands for: Weibull's slope
    ln(ln 0.9/ln 0.99)/ln 2.7 = 2.37. The mean life is taken as that of half of them.

    Parameters
    ----------
    hours
        Mean life.
    reliability
        Share that reaches it, between 0 and 1.

    >>> print(f"{life_of_mean(22_000.0, 0.99):.0f} h")
    3675 h
    """
    slope = log(log(0.9) / log(0.99)) / log(figures()["skf"]["life_over_interval"])
    return float(hours * (log(reliability) / log(0.5)) ** (1.0 / slope))


def l10_of_mean(hours: float) -> float:
    """Life that 90 % of the bearings reach, from the mean one: L_50/2.2, by `life_of_mean`.

    >>> print(f"{l10_of_mean(22_000.0):.0f} h")
    9922 h
    """
    return life_of_mean(hours, 0.9)
