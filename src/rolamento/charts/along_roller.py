"""What pictures of rollers show, whatever draws them: pressure along them, how they lie.

Along a roller places are counted from its middle, toward +x; of a tapered one along its axis.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.charts.axes_units import DEGREE, MEGAPASCAL, MILLIMETRE, ReadableUnit
from rolamento.charts.texts import number
from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.solved import Solved
from rolamento.solved.outline import roller_outline
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.solved import Rollers

__all__ = [
    "LyingRoller",
    "chosen_roller",
    "lying_roller",
    "most_loaded_rollers",
    "place_name",
    "pressure_along",
    "pressure_name",
    "roller_label",
    "rollers_of",
    "tilted_name",
]

Floats = NDArray[np.float64]

_MICROMETRE: Final = ReadableUnit("µm", 1e6)
_BODY: Final = 0.7
"""Fraction of what is to be seen of profile and overlap: so much is left of half the roller's
body."""
_MARGIN: Final = 0.12
_NO_TILT: Final = 1e-7
"""rad: what is less is rounding."""


def most_loaded_rollers(solved: Solved, race: Race) -> list[int]:
    """Return the roller of each row on which the pressure is greatest, the greatest of all first.

    Rows that bear nothing have none.
    """
    rollers = solved.rollers
    assert rollers is not None
    peak = np.nan_to_num(pressure_along(rollers, race)).max(axis=1)
    rows = solved.elements.row
    best = [int(np.flatnonzero(rows == row)[peak[rows == row].argmax()]) for row in np.unique(rows)]
    best = [one for one in best if peak[one] > 0.0]
    return sorted(best, key=lambda one: -float(peak[one]))


def chosen_roller(solved: Solved, rollers: Rollers, roller: int | None) -> int | None:
    """Return which roller to draw, that which presses most if none is given; None without load.

    Raises
    ------
    InputError
        If there is no roller of this number.
    """
    known = rollers_of(rollers)
    if roller is not None:
        if roller not in known:
            raise InputError(
                said("must be the number of a roller, {first} to {last}",
                     first=known[0], last=known[-1]),
                field="roller",
                value=roller,
            )  # fmt: skip
        return roller
    loaded = most_loaded_rollers(solved, "inner") or most_loaded_rollers(solved, "outer")
    return loaded[0] if loaded else None


def rollers_of(rollers: Rollers) -> list[int]:
    """Which elements are rollers: of a mixed set not the balls."""
    return np.flatnonzero(np.isfinite(rollers.slice_place[0]).all(axis=1)).tolist()


def pressure_along(rollers: Rollers, race: Race) -> Floats:
    """MPa, (elements, slices); NaN of balls beside rollers."""
    line = rollers.inner if race == "inner" else rollers.outer
    return MEGAPASCAL.of(line.pressure[0])


def roller_label(solved: Solved, roller: int) -> str:
    """Name a roller by its number, its row if there are several, and its azimuth."""
    azimuth = number(float(DEGREE.of(solved.elements.azimuth[0, roller])) % 360.0)
    if len(solved.rows) > 1:
        row = int(solved.elements.row[roller])
        return said(
            "roller #{number} of row {row} at {azimuth}°", number=roller, row=row, azimuth=azimuth
        )
    return said("roller #{number} at {azimuth}°", number=roller, azimuth=azimuth)


def tilted_name(name: str, tilt: float) -> str:
    """Name what is tilted, and how far, if it is."""
    if abs(tilt) < _NO_TILT:
        return name
    return said("{name}, tilt {tilt:.3 mrad}", name=name, tilt=tilt)


def pressure_name(race: Race) -> str:
    """Name the pressure at a race."""
    if race == "inner":
        return said("Pressure at the inner race")
    return said("Pressure at the outer race")


def place_name(solved: Solved) -> str:
    """Name the places along a roller."""
    if np.any(solved.rows.sign < 0.0):
        return said("Place along the roller, from its middle toward +x of its row")
    return said("Place along the roller, from its middle toward +x")


class LyingRoller(NamedTuple):
    """A roller between its races, heights many times those of lengths; its body is cut.

    x: places along it (mm). above, below: its outline; axis: its middle; race_above, race_below:
    the surfaces of the outer and the inner race (µm). bottom, top: what is to be seen of it all.
    tilt, ring_tilt: as of `RollerOutline` (rad).
    """

    x: Floats
    above: Floats
    below: Floats
    axis: Floats
    race_above: Floats
    race_below: Floats
    bottom: float
    top: float
    tilt: float
    ring_tilt: float


def lying_roller(solved: Solved, roller: int) -> LyingRoller:
    """Return how to draw a roller of a single case between its races, before they are pressed flat.

    Parameters as of `roller_outline`.
    """
    outline = roller_outline(solved, roller)
    x, axis = MILLIMETRE.of(outline.place), _MICROMETRE.of(outline.tilt * outline.place)
    drop, inner, outer = map(_MICROMETRE.of, (outline.drop, outline.inner, outline.outer))
    pressed = max(float(inner.max()), float(outer.max()), 0.0)
    spans = [float(np.ptp(own)) for own in (axis, drop, inner, outer)]
    body = pressed + _BODY * max(*spans, pressed, 1e-3)
    above, below = axis - drop + body, axis + drop - body
    race_above, race_below = above - outer, below + inner
    top = max(float(race_above.max()), float(above.max()))
    bottom = min(float(race_below.min()), float(below.min()))
    margin = _MARGIN * (top - bottom)
    return LyingRoller(
        x, above, below, axis, race_above, race_below, bottom - margin, top + margin,
        outline.tilt, outline.ring_tilt,
    )  # fmt: skip
