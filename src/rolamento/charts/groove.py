"""Contact ellipses on a groove that is rolled out flat, whatever draws them; mm.

Across the groove an ellipse lies at its contact angle times the radius of the groove, counted
from the bottom.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import acos, isfinite

from rolamento.charts.contacts import touching
from rolamento.geometry import Race, edge_cosine
from rolamento.records import frozen
from rolamento.solved import Solved

__all__ = ["Slot", "extent", "slots_of"]


@frozen
class Slot:
    """One ball's place in the drawing, and its ellipse; mm."""

    row: int
    azimuth: float
    """rad"""
    across: float
    semi_major: float
    semi_minor: float
    groove_radius: float
    bottom: float
    """Contact angle of the groove's deepest point (rad)."""
    edge: float
    """Angle of the edge of the ball's groove, from its bottom."""
    shoulder: bool
    """Whether the height of the shoulder is given; else the edge is that of a half circle."""
    along: float = 0.0

    @property
    def touches(self) -> bool:
        """Whether there is an ellipse."""
        return isfinite(self.across) and self.semi_major > 0.0

    @property
    def over_edge(self) -> bool:
        """Whether the ellipse runs over the edge of the groove."""
        return abs(self.across) + self.semi_major > self.edge


def slots_of(solved: Solved, race: Race) -> list[Slot]:
    """Return the places of all balls of a single case with a result, in the order of its tables."""
    angle, semi_major, semi_minor = (
        touching(solved, race, name) for name in ("contact_angle", "semi_major", "semi_minor")
    )
    bearings = [place.bearing for place in solved.case.bearing.places]
    found = []
    for ball, row in enumerate(solved.elements.row.tolist()):
        bearing = bearings[row]
        radius = 1e3 * getattr(bearing, f"{race}_conformity") * bearing.ball_diameter
        found.append(
            Slot(
                row=row,
                azimuth=float(solved.elements.azimuth[0, ball]),
                across=float(radius * (angle[ball] - bearing.groove_bottom)),
                semi_major=float(1e3 * semi_major[ball]),
                semi_minor=float(1e3 * semi_minor[ball]),
                groove_radius=radius,
                bottom=bearing.groove_bottom,
                edge=radius * acos(float(edge_cosine(bearing, race))),
                shoulder=getattr(bearing, f"{race}_shoulder_height") is not None,
            )
        )
    return found


def extent(balls: Sequence[Slot]) -> tuple[float, float]:
    """Return how far the drawing reaches across the groove: bottom, edges, ellipses."""
    reach = [0.0]
    for slot in balls:
        if slot.touches:
            reach += [slot.across - slot.semi_major, slot.across + slot.semi_major]
        if slot.shoulder:
            reach += [-slot.edge, slot.edge]
    low, high = min(reach), max(reach)
    return (low, high) if high > low else (-1.0, 1.0)
