"""Lines of what turns, left out of the search, each with as many neighbours as it spreads to."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import ceil
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.numerics import BoolArray, FloatArray
from rolamento.vibration.diagnosis.leakage import envelope_leakage, reach
from rolamento.vibration.diagnosis.runs import runs

__all__ = ["Place", "filled", "lines_about", "lines_connected", "most_spread", "shaft_places"]

_SPREAD_TO: Final = 0.3
"""Of the noise: what a line may add to its neighbours before they are left out."""
_CONNECTED: Final = 3.0
"""Orders between which a modulation carries noise; farther, less than a hundredth of it."""
_LEAST_SPREAD: Final = 2
_MOST_SPREAD: Final = 6
_SPREAD_ORDERS: Final = 0.02


def most_spread(turns: float) -> int:
    """Lines on either side of one of the shaft's that are left out with it at most.

    Farther off, what its taper leaves is small beside damage; and damage at an order near a
    multiple of the shaft's (3.05 of many bearings of eight balls) would go with it.

    turns: lines per order.
    """
    return max(_LEAST_SPREAD, min(_MOST_SPREAD, round(_SPREAD_ORDERS * turns)))


class Place(NamedTuple):
    """A line to leave out: where, and how far it may be from there; lines of the spectrum."""

    line: float
    within: float


def shaft_places(
    regular: Sequence[float], turns: float, lines: int, uncertainty: float
) -> list[Place]:
    """Multiples of what turns, given by its orders."""
    return [
        Place(number * order * turns, 1.0 + uncertainty * number * order * turns)
        for order in regular
        for number in range(1, int(lines / (order * turns)) + 1)
    ]


def lines_connected(
    spreads: NDArray[np.int64], places: Sequence[Place], turns: float, lines: int
) -> BoolArray:
    """Lines whose noise the division by the regular part made depend on that of others.

    About each place as far as the regular part reached about any other from which the modulation
    leads there, which falls off with the distance in orders.

    Parameters
    ----------
    spreads
        (bands, 1 + places), lines on either side of 0 and of each place that were taken for
        regular; -1 for none.
    places
        Of the shaft and what else turns.
    turns
        Lines per order.
    lines
        Of the spectra.

    Returns
    -------
    (bands, lines).
    """
    found = np.zeros((len(spreads), lines), dtype=np.bool_)
    centres = np.array([0.0, *(place.line for place in places)])
    regular = np.any(spreads[:, 1:] >= 0, axis=1)
    for number, place in enumerate(places, 1):
        near = np.abs(centres - centres[number]) <= _CONNECTED * turns + 1.0
        reached = np.max(spreads[:, near], axis=1)
        for band in np.flatnonzero(regular & (reached >= 0)):
            reach_here = float(reached[band]) + place.within
            first = max(0, ceil(place.line - reach_here))
            found[band, first : int(place.line + reach_here) + 1] = True
    return found


def lines_about(
    power: FloatArray, level: FloatArray, places: Iterable[Place], most: int
) -> BoolArray:
    """Lines at some places, in each band as far about them as the strongest there spreads.

    Parameters
    ----------
    power, level
        (bands, lines); mean of the noise about each line.
    places
        To leave out.
    most
        Lines on either side of a place that are left out with it at most.

    Returns
    -------
    (bands, lines).
    """
    found = np.zeros(power.shape, dtype=np.bool_)
    leakage = envelope_leakage()
    lines = power.shape[1]
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.nan_to_num(power / level, nan=0.0, posinf=0.0)
    for place in places:
        first = max(0, ceil(place.line - place.within))
        last = min(lines, int(place.line + place.within) + 1)
        if first >= last:
            continue
        for band, peak in enumerate(np.max(ratio[:, first:last], axis=1)):
            spread = min(reach(leakage, float(peak) / _SPREAD_TO), most)
            found[band, max(0, first - spread) : last + spread] = True
    return found


def filled(power: FloatArray, left_out: BoolArray) -> FloatArray:
    """Powers with those of lines left out replaced by as many of their neighbours.

    A level that is a median over lines is then one of those that are left in.
    """
    found = power.copy()
    lines = power.shape[1]
    for band, out in enumerate(left_out):
        for start, end in zip(*runs(out), strict=True):
            after = np.arange(end, min(lines, end + end - start))
            before = np.arange(max(0, start - (end - start)), start)
            neighbours = np.concatenate([before[~out[before]], after[~out[after]]])
            if len(neighbours) > 0:
                # every other one of both sides
                chosen = np.resize(
                    neighbours[:: max(1, len(neighbours) // (end - start))], end - start
                )
                found[band, start:end] = power[band, chosen]
    return found
