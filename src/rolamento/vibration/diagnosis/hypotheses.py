"""Which lines damage to a part may make: what the search tries, and all that it counts as tried.

A hypothesis is a set of multiples of the fault's order, with or without sidebands, and a width that
slip has given the highest of them; lower ones are narrower in proportion. Damage that strikes in
a steady load shows its first multiples; a ring that turns through the load has sidebands; a ball
that strikes one race harder than the other shows odd multiples of its spin.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from rolamento.numerics import FloatArray
from rolamento.vibration.diagnosis.orders import Component, FaultOrders

__all__ = ["WIDTHS", "Hypothesis", "SearchedLine", "highest_order", "hypotheses_of", "trials_grid"]

WIDTHS: Final = (1, 2, 4, 8, 16)
"""Of the highest multiple; in lines."""
_WIDTHS_WITH_SIDEBANDS: Final = WIDTHS[:4]
"""Sidebands lie close enough to share the noise that they are compared with; wide ones would feel
its scatter together."""

_PLAIN: Final[dict[Component, tuple[tuple[float, ...], ...]]] = {
    "outer_race": ((1,), (1, 2), (1, 2, 3), (1, 2, 3, 4, 5)),
    "inner_race": ((1,), (1, 2, 3)),
    "ball": ((1,), (1, 2, 3), (0.5, 1, 1.5, 2)),
    "cage": ((1,), (1, 2, 3)),
}
_WITH_SIDEBANDS: Final[tuple[tuple[tuple[float, ...], int], ...]] = (
    ((1,), 1),
    ((1, 2, 3), 1),
    ((1, 2, 3), 2),
)


@dataclass(frozen=True, slots=True)
class SearchedLine:
    """One line of a hypothesis: multiple of the fault's order, sidebands away, and its width."""

    multiple: float
    sideband: int
    width: int


@dataclass(frozen=True, slots=True)
class Hypothesis:
    """What damage may look like.

    Attributes
    ----------
    lines
        that should stand out together
    spacing
        of the sidebands, in orders; 0 if there are none
    width
        of the highest multiple, in lines
    """

    lines: tuple[SearchedLine, ...]
    spacing: float
    width: int

    @property
    def highest(self) -> float:
        """Highest multiple."""
        return max(line.multiple for line in self.lines)

    @property
    def step(self) -> float:
        """How well a fundamental is told: a line, or half of the width, at the highest multiple."""
        return max(1.0, 0.5 * self.width) / self.highest


def hypotheses_of(orders: FaultOrders, component: Component) -> tuple[Hypothesis, ...]:
    """Return all hypotheses for a component; none if it is not looked for."""
    if orders.fundamental(component) is None:
        return ()
    found = [
        _hypothesis(multiples, 0, 0.0, width) for multiples in _PLAIN[component] for width in WIDTHS
    ]
    spacing = orders.spacing(component)
    if spacing > 0.0:
        found += [
            _hypothesis(multiples, sidebands, spacing, width)
            for multiples, sidebands in _WITH_SIDEBANDS
            for width in _WIDTHS_WITH_SIDEBANDS
        ]
    return tuple(found)


def highest_order(orders: FaultOrders, component: Component, tolerance: float) -> float:
    """Highest order that any hypothesis for a component looks at; 0 if it is not looked for."""
    fundamental = orders.fundamental(component)
    if fundamental is None:
        return 0.0
    stretched = fundamental * (1.0 + orders.tolerance(component, tolerance))
    return max(
        line.multiple * stretched + abs(line.sideband) * hypothesis.spacing * (1.0 + tolerance)
        for hypothesis in hypotheses_of(orders, component)
        for line in hypothesis.lines
    )


def trials_grid(
    low: float, high: float, hypothesis: Hypothesis, spacing_freedom: float
) -> tuple[FloatArray, FloatArray]:
    """Fundamentals and sideband spacings to try, in lines of the spectrum.

    Steps are a line, or half of its width, at the highest multiple, and a line of the spacing. No
    line reaches with its width beyond what is allowed; there are none if it is wider than that.

    Parameters
    ----------
    low, high
        Of the fundamental; lines.
    hypothesis
        With its spacing in lines.
    spacing_freedom
        Part by which the spacing may be off.
    """
    step = hypothesis.step
    inside = 0.5 * max(0, hypothesis.width - 2) / hypothesis.highest
    count = max(0, int((high - low - 2.0 * inside) / step + 1.0))
    fundamentals = low + inside + step * np.arange(count, dtype=np.float64)
    reach = int(spacing_freedom * hypothesis.spacing)
    return fundamentals, hypothesis.spacing + np.arange(-reach, reach + 1, dtype=np.float64)


def _hypothesis(
    multiples: tuple[float, ...], sidebands: int, spacing: float, width: int
) -> Hypothesis:
    highest = max(multiples)
    lines = tuple(
        SearchedLine(multiple, side, max(1, round(width * multiple / highest)))
        for multiple in multiples
        for side in range(-sidebands, sidebands + 1)
    )
    return Hypothesis(lines, spacing, width)
