"""Which bearings of the catalogue share the lines of a diagnosis, and what distinguishs them.

A line of an envelope spectrum is that of a part of some bearing. Slip moves it by a part in a
hundred, and many bearings lie closer together than that: the line shows damage, not the bearing.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import inf
from typing import Any, Final

from rolamento.catalogue.rolling import RollingBearing
from rolamento.records import frozen
from rolamento.vibration.diagnosis import COMPONENTS, Component, Diagnosis, FaultOrders
from rolamento.vibration.frequencies import LineName, line_orders, turns_of
from rolamento.words import Note

__all__ = ["Lookalike", "Lookalikes", "lookalikes", "orders_of"]

_NAMED: Final = 3
_LINES: Final = 2.0
"""Lines of a spectrum by which two peaks must lie apart to be seen as two."""
_ALIKE: Final = 2.5e-4
"""Part within which two orders are the same: no record distinguishes them. Balls 20 K warmer than
the rings change D/d_m by as much."""


_LINE_OF: Final[Mapping[Component, LineName]] = {
    "outer_race": "ball_pass_outer",
    "inner_race": "ball_pass_inner",
    "ball": "ball_spin_twice",
    "cage": "cage",
}


def _lines_of(bearing: RollingBearing, inner: float, outer: float) -> dict[LineName, float]:
    turns = turns_of(bearing.diameter_ratio, bearing.angle, inner, outer)
    return {name: abs(order) for name, order in line_orders(turns, bearing.element_count).items()}


def orders_of(bearing: RollingBearing, inner: float = 1.0, outer: float = 0.0) -> FaultOrders:
    """Return the orders of a bearing's faults by its geometry, for speeds over the shaft's."""
    lines = _lines_of(bearing, inner, outer)
    return FaultOrders(
        outer_race=lines["ball_pass_outer"] or None,
        inner_race=lines["ball_pass_inner"] or None,
        ball=lines["ball_spin"] or None,
        cage=lines["cage"] or None,
    )


@frozen
class Lookalike:
    """A bearing whose lines lie where those were found.

    Attributes
    ----------
    designation, ball_count
        Of the catalogue.
    is_inferred
        Whether its balls are inferred from its ratings.
    differences
        Its orders over those of the bearing that was sought, less 1, by part.
    """

    designation: str
    ball_count: int
    is_inferred: bool
    differences: Mapping[Component, float]

    def distance(self, parts: Iterable[Component]) -> float:
        """Return the greatest difference of some parts."""
        return max((abs(self.differences[part]) for part in parts), default=inf)


@frozen
class Lookalikes:
    """The bearings that share what a diagnosis found.

    Attributes
    ----------
    parts
        That were found: a bearing that is counted has the lines of all of them.
    found
        The bearings, those nearest to the one that was sought first.
    compared
        How many of the catalogue were compared.
    sought, frequency, resolution, slip
        Orders that were sought; the shaft's frequency in Hz; between lines of the spectrum, in
        orders; part by which the cage was allowed to be off.
    """

    parts: tuple[Component, ...]
    found: tuple[Lookalike, ...]
    compared: int
    sought: FaultOrders
    frequency: float
    resolution: float
    slip: float

    @property
    def shared(self) -> Note:
        """Number of bearings that share the lines, and the nearest ones."""
        if not self.found:
            return Note("lines_of_no_other_bearing", {"compared": self.compared})
        return Note(
            "lines_of_other_bearings",
            {
                "parts": list(self.parts),
                "count": len(self.found),
                "compared": self.compared,
                "inferred": sum(one.is_inferred for one in self.found),
                "nearest": [
                    {"designation": one.designation, "difference": one.distance(self.parts)}
                    for one in self.found[:_NAMED]
                ],
            },
        )

    @property
    def telling(self) -> Note:
        """What would distinguish the bearing that was sought from the nearest other one."""
        nearest = self.found[0]
        main = self.parts[0]
        apart = abs(nearest.differences[main])
        best = max(nearest.differences, key=lambda part: abs(nearest.differences[part]))
        values: dict[str, Any] = {
            "other": nearest.designation,
            "balls": [_balls(self.sought), nearest.ball_count],
            "part": main,
            "difference": apart,
            "best_part": best,
            "best_difference": abs(nearest.differences[best]),
            "best_frequency": self._hertz(best),
            "best_other_frequency": self._hertz(best) * (1.0 + nearest.differences[best]),
        }
        if values["best_difference"] < _ALIKE:
            return Note("no_distinguishing_line", values)
        order = self.sought.fundamental(best) or 0.0
        spacing = order * values["best_difference"]
        values["known_within"] = 0.5 * values["best_difference"]
        values["duration"] = _LINES / (spacing * self.frequency)
        values["resolved"] = spacing >= _LINES * self.resolution
        values["slip"] = self.slip
        return Note("distinguishing_lines", values)

    def _hertz(self, part: Component) -> float:
        return (self.sought.fundamental(part) or 0.0) * self.frequency

    def to_mapping(self) -> dict[str, Any]:
        """Return the bearings as plain data."""
        return {
            "parts": list(self.parts),
            "compared": self.compared,
            "count": len(self.found),
            "bearings": [
                {
                    "designation": one.designation,
                    "inferred": one.is_inferred,
                    "differences": dict(one.differences),
                }
                for one in self.found
            ],
        }


def lookalikes(
    diagnosis: Diagnosis,
    sought: FaultOrders,
    bearings: Iterable[RollingBearing],
    *,
    speed_tolerance: float,
    ratios: tuple[float, float] = (1.0, 0.0),
    designation: str = "",
) -> Lookalikes | None:
    """Return the bearings that the same search would have found damaged by the same lines.

    Parameters
    ----------
    diagnosis
        Of which the parts count that are damaged or undecided.
    sought
        The orders that were looked for.
    bearings
        Of a catalogue.
    speed_tolerance
        Part by which a speed that nothing confirms may be off.
    ratios
        Speeds of inner and outer ring over the shaft's.
    designation
        Of the bearing that was sought, which is none of the others.

    Returns
    -------
    Lookalikes
        None if no part is damaged or undecided.
    """
    stated = [part for part in diagnosis.stated if part.verdict in ("fault", "undecided")]
    found = {part.component: part.order for part in stated if part.order > 0.0}
    if not found:
        return None
    freedom = 0.0 if diagnosis.speed_confirmed else speed_tolerance
    own = {part: order for part in COMPONENTS if (order := sought.fundamental(part))}
    others, compared = [], 0
    for bearing in bearings:
        if bearing.designation == designation:
            continue
        compared += 1
        lines = _lines_of(bearing, *ratios)
        if not all(_near(lines[_LINE_OF[p]], found[p], diagnosis, freedom) for p in found):
            continue
        orders = orders_of(bearing, *ratios)
        if all(_has(orders, part, order, diagnosis, freedom) for part, order in found.items()):
            differences = {
                part: (orders.fundamental(part) or 0.0) / order - 1.0 for part, order in own.items()
            }
            told = bearing.designation, bearing.element_count, bearing.is_inferred
            others.append(Lookalike(*told, differences))
    parts = tuple(found)
    others.sort(key=lambda one: one.distance(parts))
    return Lookalikes(
        parts,
        tuple(others),
        compared,
        sought,
        diagnosis.shaft_frequency,
        diagnosis.resolution,
        diagnosis.tolerance,
    )


def _balls(orders: FaultOrders) -> int:
    """The number of balls, which the orders of both races add up to, whatever the slip."""
    return round((orders.outer_race or 0.0) + (orders.inner_race or 0.0))


def _near(order: float, found: float, diagnosis: Diagnosis, freedom: float) -> bool:
    """Whether a line is worth a closer look: no part's may move farther than the cage's."""
    return abs(found - order) <= (diagnosis.tolerance + freedom) * order + diagnosis.resolution


def _has(
    orders: FaultOrders, part: Component, found: float, diagnosis: Diagnosis, freedom: float
) -> bool:
    """Whether slip and speed may move a part's line to where one was found."""
    order = orders.fundamental(part)
    if order is None:
        return False
    allowed = orders.tolerance(part, diagnosis.tolerance) + freedom
    return abs(found - order) <= allowed * order + diagnosis.resolution
