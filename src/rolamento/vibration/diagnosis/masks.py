"""Lines left out of the search, each with as many neighbours as it spreads to.

They are those of the shaft, of what else is known to turn, and of faults that were found already.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import ceil, sqrt
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import special

from rolamento.numerics import BoolArray, FloatArray
from rolamento.vibration.diagnosis.leakage import envelope_leakage, reach
from rolamento.vibration.diagnosis.orders import Component, FaultOrders
from rolamento.vibration.diagnosis.runs import runs
from rolamento.vibration.diagnosis.search import Finding

__all__ = ["Place", "fault_places", "filled", "lines_about", "lines_connected", "shaft_places"]

_SIDEBANDS: Final = 6
"""That a fault may have at its own spacing."""
_OF_SHAFT: Final = 3
"""And about each of those at the shaft's."""
_SPREAD_TO: Final = 0.3
"""Of the noise: what a line may add to its neighbours before they are left out."""
_MULTIPLES: Final = 6
_BEYOND: Final = 4.0
"""Multiples of a fault that are put aside: so many, or so many times the highest that was matched."""
_KNOWN: Final = 0.25
"""Of the distance between multiples: farther off, a multiple is not known."""
_CONNECTED: Final = 3.0
"""Orders between which a modulation carries noise; farther, less than a hundredth of it."""


class Place(NamedTuple):
    """A line to leave out.

    line: where; within: how far it may be from there; width: of a hump that slip makes of it, 0 for
    a discrete line. In lines of the spectrum.
    """

    line: float
    within: float
    width: float = 0.0


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


def fault_places(
    component: Component,
    finding: Finding,
    orders: FaultOrders,
    turns: float,
    lines: int,
    tolerance: float,
) -> list[Place]:
    """Lines that a fault which was found may make: multiples, and sidebands of each and of 0.

    The order is known to a line, or half of its width, of the highest multiple that was matched:
    far beyond it, nothing is known of where its multiples lie. A ball's sidebands are one turn of
    the cage away, which is known to a line if they were matched, else to the tolerance.
    """
    fundamental, hypothesis = finding.fundamental, finding.hypothesis
    step = 0.5 * fundamental if component == "ball" else fundamental
    spacing = finding.spacing or orders.spacing(component) * turns
    # what the shaft does to the noise of a machine it does to the blows as well
    sides = {
        (side * spacing + of_shaft * turns, abs(side))
        for side in range(-_SIDEBANDS, _SIDEBANDS + 1)
        for of_shaft in range(-_OF_SHAFT, _OF_SHAFT + 1)
    }
    of_spacing = 0.0
    if component == "ball":
        of_spacing = 1.0 if finding.spacing else tolerance * spacing
    doubt = hypothesis.step / fundamental
    places = []
    highest = max(_MULTIPLES, _BEYOND * hypothesis.highest) * fundamental
    farthest = max(offset for offset, _ in sides)
    for number in range(int(min(lines + farthest, highest) / step) + 1):
        width = hypothesis.width * number * step / (fundamental * hypothesis.highest)
        for offset, side in sides:
            line = number * step + offset
            if 0.0 < line < lines:
                within = 1.0 + doubt * number * step + 0.5 * width + side * of_spacing
                places.append(Place(line, within, width))
    if component == "cage":
        places += _far_multiples(step, doubt, lines)
    return places


def _far_multiples(step: float, doubt: float, lines: int) -> list[Place]:
    """All multiples that are known well enough: blows of the cage are felt up to its hundredth.

    Among them some lie where those of a ball are looked for.
    """
    last = min(int(lines / step), int(_KNOWN / doubt))
    return [Place(n * step, 1.0 + doubt * n * step) for n in range(1, last + 1)]


def lines_about(
    power: FloatArray,
    level: FloatArray,
    places: Iterable[Place],
    *,
    stands_out: float = 0.0,
    averages: int = 1,
) -> BoolArray:
    """Lines at some places, in each band as far about them as the strongest there spreads.

    Parameters
    ----------
    power, level
        (bands, lines); mean of the noise about each line.
    places
        To leave out.
    stands_out
        Quantile of the strongest line of noise at a place, from which on lines are left out; 0 for
        all.
    averages
        Of how many independent spectra the powers are means.

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
        peaks = np.max(ratio[:, first:last], axis=1)
        quantile = stands_out ** (1.0 / (last - first)) if stands_out > 0.0 else 0.0
        least = float(special.gammaincinv(averages, quantile)) / averages
        for band in np.flatnonzero(peaks >= least):
            over = float(peaks[band]) / _SPREAD_TO
            # a hump falls off with the square of the distance
            hump = min(0.5 * place.width * sqrt(over), 0.1 * place.line)
            spread = max(reach(leakage, over), int(hump))
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
