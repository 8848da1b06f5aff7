"""What a heat balance is asked for: springs, ceramic, distance of the rows, speed, oil.

Each answer is the balance of the same case with one thing changed, or the place where a balance
crosses a line:

- the same preload by springs or clamped rings; rolling elements of silicon nitride or of steel;
- the distance of the rows at which the warm preload is the cold one: along the shaft an O pair that
  is warmer inside is relieved in proportion to the distance, across it is loaded whatever it is;
- the multiple of the speeds up to which there is a state below the temperature limit;
- the oil flow with which no part is warmer than a temperature.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import inf, isfinite, nan
from typing import Any, Final, Literal

import numpy as np

from rolamento.case import Case, case_of
from rolamento.errors import InputError
from rolamento.heat.balance import (
    CaseLike,
    HeatBalance,
    balances_of,
    heat_balance,
    heat_balances,
)
from rolamento.heat.warmed import Warmed
from rolamento.io.json import plain
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.units import readable
from rolamento.words import said

__all__ = ["HeatVariant", "NeutralDistance", "highest_speed", "neutral_distance", "oil_needed",
           "variants_of"]  # fmt: skip

VariantName = Literal["as_given", "rigid", "spring", "ceramic", "steel"]
CERAMIC: Final = "Si3N4"
_LIGHT: Final = 0.5
"""Density of the elements over that of the rings below which they are ceramic."""
_DISTANCES: Final = np.geomspace(0.1, 30.0, 25)
"""Distances of rows that are looked at, over the pitch diameter."""
_CLOSER: Final = 3
_FASTER: Final = 1.25 ** np.arange(1, 13)
"""Multiples of the speed that are tried beyond it, up to 14.6."""
_FLOWS: Final = np.geomspace(1e-3, 100.0, 11) / 60e3
"""Oil flows that are tried, 0.001 to 100 l/min, m³/s."""
_BETWEEN: Final = 5


@frozen(eq=False)
class HeatVariant:
    """A case with one thing changed, and its balance.

    Attributes
    ----------
    name
        "as_given"; "rigid" or "spring", the same preload by the other way; "ceramic" or "steel",
        the other rolling elements
    balance
        of it
    """

    name: VariantName
    balance: HeatBalance


@frozen(eq=False)
class NeutralDistance:
    """How what becomes of the preload depends on the distance of the rows.

    Attributes
    ----------
    distance
        at which the preload of the warm set is that of the cold one, m; NaN where there is none
    spacing
        of the rows that was looked at, (points,), m
    cold, warm
        preload at ambient temperature, and at those of the balance, (points,), N
    """

    distance: float
    spacing: FloatArray
    cold: FloatArray
    warm: FloatArray

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, SI."""
        found: dict[str, Any] = plain(
            {name: getattr(self, name) for name in self.__dataclass_fields__}
        )
        return found


def variants_of(case: CaseLike, threads: int | None = None) -> tuple[HeatVariant, ...]:
    """Find the balance of a case, and those with the other preload and the other elements.

    Parameters
    ----------
    case, threads
        As of `rolamento.heat.heat_balance`.

    Returns
    -------
    tuple of HeatVariant
        The case as it is given first. A bearing without a preload has no other one.

    Raises
    ------
    InputError
        As `heat_balance`.
    """
    case = case_of(case)
    found = heat_balance(case, threads=threads)
    return (
        HeatVariant("as_given", found),
        *(
            HeatVariant(name, heat_balance(case.with_(changes), threads=threads))
            for name, changes in _changes(case, found)
        ),
    )


def _changes(case: Case, found: HeatBalance) -> Iterator[tuple[VariantName, Mapping[str, Any]]]:
    bearing = case.bearing
    preload = bearing.preload
    if preload is not None and found.cold.preload is not None:
        if preload.spring is not None:
            yield "rigid", {"bearing.preload": {"force": preload.spring}}
        else:
            force = preload.pair_force(bearing.contact_angle) or preload.force
            yield "spring", {"bearing.preload": {"spring": force or found.cold.preload}}
    field = f"bearing.{bearing.MATERIAL}"
    if bearing.element_material.density < _LIGHT * bearing.ring_material.density:
        yield "steel", {field: bearing.ring_material}
    else:
        yield "ceramic", {field: CERAMIC}


def neutral_distance(found: HeatBalance, threads: int | None = None) -> NeutralDistance | None:
    """Find the distance of the rows at which a rigid preload is warm what it is cold.

    The temperatures are those of the balance, whatever the distance.

    Parameters
    ----------
    found
        The balance of a mounted pair or set with a spacing.
    threads
        As of `rolamento.heat.heat_balance`.

    Returns
    -------
    NeutralDistance or None
        None of a bearing whose preload does not depend on a distance: a single one, one with
        springs, or one without a state.
    """
    case = found.case
    preload, root = case.bearing.preload, found.root
    warmed = Warmed(case, threads=threads)
    rigid = preload is None or preload.spring is None
    if root is None or case.mounting is None or case.bearing.spacing is None or not rigid:
        return None
    if not warmed.has_preload:
        return None
    ambient = np.full(len(root.temperatures), found.network.ambient)
    hot = np.array(list(root.temperatures.values()))

    def preloads(spacing: FloatArray) -> tuple[FloatArray, FloatArray]:
        count = len(spacing)
        own = Warmed(case, {"bearing.spacing": np.tile(spacing, 2)}, threads)
        at = np.concatenate([np.tile(ambient, (count, 1)), np.tile(hot, (count, 1))]).T
        both = own.preload(own.solved(at, np.arange(2 * count)))
        return both[:count], both[count:]

    spacing = _DISTANCES * case.bearing.places[0].bearing.pitch_diameter
    cold, warm = preloads(spacing)
    low, high = _crossing(spacing, warm - cold)
    distance = nan
    for _ in range(_CLOSER if isfinite(low) else 0):
        between = np.linspace(low, high, _BETWEEN + 2)
        own_cold, own_warm = preloads(between)
        change = own_warm - own_cold
        low, high = _crossing(between, change)
        if not isfinite(low):
            break
        ends = np.interp([low, high], between, change)
        distance = float(low + (high - low) * ends[0] / (ends[0] - ends[1]))
    return NeutralDistance(distance, spacing, cold, warm)


def _crossing(x: FloatArray, value: FloatArray) -> tuple[float, float]:
    """The first two neighbours between which a value changes its sign; NaN without."""
    places = np.flatnonzero(value[:-1] * value[1:] <= 0.0)
    if not len(places):
        return nan, nan
    return float(x[places[0]]), float(x[places[0] + 1])


def highest_speed(found: HeatBalance, threads: int | None = None) -> tuple[float, bool]:
    """Find the multiple of the speeds up to which there is a state below the temperature limit.

    Parameters
    ----------
    found
        The balance of a case.
    threads
        As of `rolamento.heat.heat_balance`.

    Returns
    -------
    tuple
        The multiple, infinite if it is more than 14.6 times the speed, NaN for a bearing at rest or
        without an equilibrium; and whether two states merge there. Else the coldest one comes to
        the temperature limit, or the bearing loses its equilibrium.
    """
    if not found.case.duty.turns:
        return nan, False
    if not found.converged:
        return found.runaway, found.merges
    own = balances_of(found.case, threads)
    factors = np.concatenate([[1.0], _FASTER])
    least, _ = own.least_excess(0, factors)
    without = np.flatnonzero(~(least <= 0.0))
    if not len(without):
        return inf, False
    first = int(without[0])
    if first == 0:  # the state is there, though only between two points of the search
        return 1.0, True
    return own.runaway(0, float(factors[first - 1]), float(factors[first]))


def oil_needed(case: CaseLike, most: float, threads: int | None = None) -> float:
    """Find the oil flow with which no part of a bearing is warmer than a temperature.

    Parameters
    ----------
    case
        As of `rolamento.heat.heat_balance`; its own oil flow does not count.
    most
        That temperature, in K.
    threads
        As of `heat_balance`.

    Returns
    -------
    float
        In m³/s; 0 where none is needed, infinite if 100 l/min are not enough.

    Raises
    ------
    InputError
        As `heat_balance`; or if the temperature is not above that of the oil and the surroundings.

    The oil takes 30 W per l/min and K away from the rolling elements.
    """
    case = case_of(case)
    heat = heat_balance(case, look_for_speed=False, threads=threads).network
    coolest = max(heat.ambient, heat.oil_inlet)
    if not most > coolest:
        raise InputError(
            said(
                "must be above that of the oil and the surroundings, {coolest}",
                coolest=readable(coolest, "temperature"),
            ),
            field="most",
            value=readable(most, "temperature"),
        )

    def too_warm(flows: FloatArray) -> list[bool]:
        found = heat_balances(case, {"heat.oil_flow": flows}, threads=threads)
        return [not one.converged or max(one.temperatures.values()) > most for one in found]

    if case.heat is not None and case.heat.oil_inlet is not None:
        flows = np.concatenate([[1e-9], _FLOWS])  # an inlet without a flow has no meaning
    else:
        flows = np.concatenate([[0.0], _FLOWS])
    for _ in range(4):
        warm = too_warm(flows)
        if not warm[0]:
            return 0.0 if flows[0] <= 1e-9 else float(flows[0])
        if warm[-1]:
            return inf
        first = warm.index(False)
        low, high = float(flows[first - 1]), float(flows[first])
        flows = np.linspace(low, high, _BETWEEN + 2)
    return high
