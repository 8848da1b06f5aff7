"""Lines that stand out, and that no part of the bearing and no turn of the shaft explains.

A wrong speed or another bearing than was thought shows so, and so does another machine nearby.
"""

from __future__ import annotations

from math import log
from typing import Final

import numpy as np

from rolamento.vibration.diagnosis.family import explained
from rolamento.vibration.diagnosis.field import Field
from rolamento.vibration.diagnosis.orders import COMPONENTS, Component, FaultOrders
from rolamento.vibration.diagnosis.record import UnexplainedLine
from rolamento.vibration.diagnosis.search import Scores, chance
from rolamento.vibration.diagnosis.size import DAMAGE, depth_of

__all__ = ["unexplained_lines"]

_WIDTHS: Final = (1, 4)
_MOST: Final = 3
_BEYOND_SLOW: Final = 2.5
"""Times the slow orders: nearer, the level about a line is theirs, which was divided out."""
_APART: Final = 0.01
"""Of a line's order: nearer ones are of the same origin."""
_MULTIPLES: Final = 20
"""Of a fault's order, and sidebands of them, that are not unexplained."""
_SIDEBAND: Final = 2.0
"""Depth of a sideband over that of the deepest multiple, at most."""
_LOWER: Final = (2, 3, 4)
"""Multiples of another comb that a part's line may be; of a ball's the half is its spin's."""
_SAME: Final = 0.004
"""Of an order: as near, a line is a multiple."""
_NEAR_SPEED: Final = 0.25
"""By which a speed may be wrong for the part to be told whose line it would then be."""


def unexplained_lines(
    field: Field, fault: tuple[Component, float, float] | None
) -> tuple[UnexplainedLine, ...]:
    """Return up to three lines that noise would not give, the deepest first.

    Parameters
    ----------
    field
        As searched.
    fault
        The part that explains most, its order, and its depth: from where it counts as damage on,
        only lines as deep are told of, so that none is taken for what a fault makes besides its
        multiples and their sidebands.
    """
    left_out = field.left_out.copy()
    orders = np.arange(left_out.shape[1]) / field.turns
    if fault is not None:
        of_fault = explained(
            orders, *fault[:2], field.orders, field.turns, multiples=_MULTIPLES, cage=True
        )
        near = np.maximum(2.0 / field.turns, _SAME * orders)
        step = 0.5 * fault[1] if fault[0] == "ball" else fault[1]
        multiples = np.abs(orders - np.rint(orders / step) * step) <= near
        deepest = np.max(field.depths[:, multiples], initial=fault[2] ** 2)
        if fault[0] != "cage":
            # of a comb of a lower frequency the part's line is but one; the part makes none of it
            numbers = [n for n in _LOWER if fault[0] != "ball" or n > 2]
            lower = fault[1] / np.array(numbers)[:, None]
            of_fault &= ~np.any(np.abs(orders - lower) <= 2.0 / field.turns, axis=0)
        left_out |= multiples | of_fault & (field.depths <= _SIDEBAND**2 * deepest)
    scores = Scores(field.spectra.power, left_out, field.medians, field.spectra.blocks)
    lines = np.arange(scores.lines)
    clearness = np.maximum.reduce([scores.about(lines, width)[0] for width in _WIDTHS])
    clearness[:, : int(_BEYOND_SLOW * field.spectra.slow_order * field.turns)] = 0.0
    trials = max(1, len(_WIDTHS) * int(np.count_nonzero(clearness)))
    squares = np.where(left_out, 0.0, field.depths)
    peaks = np.where(clearness < log(trials / field.settings.false_alarm), 0.0, squares)
    strongest = fault[2] if fault is not None and fault[2] >= DAMAGE else 0.0
    found: list[UnexplainedLine] = []
    while len(found) < _MOST:
        band, line = (int(place) for place in np.unravel_index(peaks.argmax(), peaks.shape))
        depth = depth_of(squares[band], line, 1) if peaks[band, line] > 0.0 else 0.0
        if depth == 0.0 or depth < strongest:
            break
        probability, _ = chance(float(clearness[band, line]), trials)
        about = slice(max(0, line - max(_WIDTHS)), line + max(_WIDTHS) + 1)
        ratio = field.spectra.power[band, about] / field.level[band, about]
        above = 10.0 * float(np.log10(np.max(ratio[~left_out[band, about]])))
        found.append(_line(line, above, depth, band, probability, field))
        apart = max(2 * max(_WIDTHS), int(_APART * line))
        peaks[:, max(0, line - apart) : line + apart + 1] = 0.0
    return tuple(found)


def _line(
    line: int, above: float, depth: float, band: int, probability: float, field: Field
) -> UnexplainedLine:
    order = line / field.turns
    shaft = field.spectra.shaft_frequency
    of_mains = field.on_mains(band, line)
    return UnexplainedLine(
        order=order,
        frequency=order * shaft,
        above_noise=above,
        depth=depth,
        band=field.spectra.bands[band],
        probability=probability,
        shaft_frequencies=() if of_mains else _shaft_frequencies(order, shaft, field.orders),
        of_mains=of_mains,
    )


def _shaft_frequencies(
    order: float, shaft: float, orders: FaultOrders
) -> tuple[tuple[Component, float], ...]:
    """At which speeds of the shaft, not far from the given one, a line would be a part's."""
    speeds = []
    for part in COMPONENTS:
        nominal = orders.fundamental(part)
        if nominal is not None and abs(order / nominal - 1.0) <= _NEAR_SPEED:
            speeds.append((part, shaft * order / nominal))
    return tuple(speeds)
