"""Lines that stand out, and that no part of the bearing and no turn of the shaft explains.

A wrong speed or another bearing than was thought shows so, and so does another machine nearby.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import product
from typing import Final

import numpy as np

from rolamento.numerics import BoolArray
from rolamento.vibration.diagnosis.field import Field
from rolamento.vibration.diagnosis.orders import COMPONENTS, Component, FaultOrders
from rolamento.vibration.diagnosis.record import ComponentVerdict, UnexplainedLine
from rolamento.vibration.diagnosis.search import Scores, chance

__all__ = ["unexplained_lines"]

_WIDTHS: Final = (1, 4)
_MOST: Final = 3
_BEYOND_SLOW: Final = 2.5
"""Times the slow orders: nearer, the level about a line is theirs, which was divided out."""
_APART: Final = 0.01
"""Of a line's order: nearer ones are of the same origin."""
_OF_FAULT: Final = 0.005
"""Of a line's order: as near, it belongs to a fault."""
_SIDES: Final = (-2, -1, 0, 1, 2)
_NEAR_SPEED: Final = 0.25
"""By which a speed may be wrong for the part to be told whose line it would then be."""


def unexplained_lines(
    field: Field, verdicts: Iterable[ComponentVerdict]
) -> tuple[UnexplainedLine, ...]:
    """Return up to three lines that noise would not give, the clearest first.

    Where faults were found only lines stronger than all of theirs count, so that none is taken for
    what a fault makes besides its multiples and nearest sidebands.

    Parameters
    ----------
    field
        With the lines of the faults that were found.
    verdicts
        Of all parts.
    """
    faults = [part for part in verdicts if part.verdict == "fault"]
    strongest = max(
        (line.above_noise for part in faults for line in part.lines if line.above_noise > 0.0),
        default=0.0,
    )
    left_out = field.left_out | _explained(field, faults)
    scores = Scores(field.spectra.power, left_out, field.medians, field.spectra.blocks)
    lines = np.arange(scores.lines)
    clearness = np.maximum.reduce([scores.about(lines, width)[0] for width in _WIDTHS])
    clearness[:, : int(_BEYOND_SLOW * field.spectra.slow_order * field.turns)] = 0.0
    trials = max(1, len(_WIDTHS) * int(np.count_nonzero(clearness)))
    found: list[UnexplainedLine] = []
    while len(found) < _MOST:
        band, line = (int(place) for place in np.unravel_index(clearness.argmax(), clearness.shape))
        probability, _ = chance(float(clearness[band, line]), trials)
        if probability > field.settings.false_alarm:
            break
        about = slice(max(0, line - max(_WIDTHS)), line + max(_WIDTHS) + 1)
        ratio = field.spectra.power[band, about] / field.level[band, about]
        above = 10.0 * float(np.log10(np.max(ratio[~left_out[band, about]])))
        if above > strongest:
            found.append(_line(line, above, band, probability, field))
        apart = max(2 * max(_WIDTHS), int(_APART * line))
        clearness[:, max(0, line - apart) : line + apart + 1] = 0.0
    return tuple(found)


def _explained(field: Field, faults: Iterable[ComponentVerdict]) -> BoolArray:
    """Lines near multiples of the faults' orders and their nearest sidebands; (lines,)."""
    orders = np.arange(field.left_out.shape[1]) / field.turns
    explained = np.zeros(len(orders), dtype=np.bool_)
    near = np.maximum(2.0 / field.turns, _OF_FAULT * orders)
    for part in faults:
        step = 0.5 * part.order if part.component == "ball" else part.order
        spacings = (field.orders.spacing(part.component), 1.0)
        for side, of_shaft in product(_SIDES, _SIDES):
            offset = side * spacings[0] + of_shaft * spacings[1]
            multiples = np.rint((orders - offset) / step)
            explained |= np.abs(orders - offset - multiples * step) <= near
    return explained


def _line(line: int, above: float, band: int, probability: float, field: Field) -> UnexplainedLine:
    order = line / field.turns
    shaft = field.spectra.shaft_frequency
    return UnexplainedLine(
        order=order,
        frequency=order * shaft,
        above_noise=above,
        band=field.spectra.bands[band],
        probability=probability,
        shaft_frequencies=_shaft_frequencies(order, shaft, field.orders),
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
