"""What lines a fault explains besides its own: multiples, and sidebands of the shaft and the cage.

A line of another part's window that is one of them tells nothing of that part. The sidebands fold
at zero: 4 - f of an outer race lies near the cage's order, f + 1 near the ball's.
"""

from __future__ import annotations

from itertools import product
from typing import Final

import numpy as np

from rolamento.numerics import BoolArray, FloatArray
from rolamento.vibration.diagnosis.orders import Component, FaultOrders

__all__ = ["explained"]

_SHAFT: Final = 5
"""Sidebands of the shaft on either side."""
_CAGE: Final = 2
"""And of the cage about each."""
_NEAR: Final = 0.004
"""Of an order: as near, a line is the same."""
_LINES: Final = 2.5


def explained(
    places: FloatArray,
    component: Component,
    order: float,
    orders: FaultOrders,
    turns: float,
    *,
    multiples: int,
    cage: bool,
) -> BoolArray:
    """Which orders are multiples of a fault's, or sidebands of one.

    Parameters
    ----------
    places
        Orders in question.
    component, order
        Of the fault.
    turns
        Lines per order.
    multiples
        Of the fault's order, up to which they count.
    cage
        Whether sidebands of the cage count too.
    """
    step = 0.5 * order if component == "ball" else order
    highest = 2 * multiples if component == "ball" else multiples
    near = np.maximum(_LINES / turns, _NEAR * places)
    carried = orders.cage if cage and orders.cage and component != "cage" else 0.0
    # of the cage itself, all that turns with it lies near some sideband of the shaft's
    shaft = 1 if component == "cage" else _SHAFT
    found = np.zeros(places.shape, dtype=np.bool_)
    sides = range(-_CAGE, _CAGE + 1) if carried else range(1)
    for of_shaft, of_cage in product(range(-shaft, shaft + 1), sides):
        offset = of_shaft + of_cage * carried
        for sign in (1.0, -1.0):
            number = np.rint((sign * places - offset) / step)
            close = np.abs(sign * places - offset - number * step) <= near
            found |= close & (np.abs(number) <= highest) & ((number != 0.0) | (of_cage != 0))
    return found
