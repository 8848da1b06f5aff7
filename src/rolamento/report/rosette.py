"""The load rosette: a small polar drawing of the ball loads.

The bearing is seen from the +x end, so that x points at the reader: +z is up, +y is to the right,
and azimuths run clockwise like the hours.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, pi, sin
from typing import Final, NamedTuple

__all__ = ["Cell", "rosette"]

_BRAILLE: Final = 0x2800
_BITS: Final = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))
"""Bit of the dot in a row and column of a braille character."""


class Cell(NamedTuple):
    """One character of the drawing, and whether a load (or only the rim) is in it."""

    character: str
    loaded: bool


def rosette(
    loads: Sequence[float],
    azimuths: Sequence[float],
    height: int,
    *,
    rim: float | None = None,
    braille: bool = True,
) -> list[list[Cell]]:
    """Draw a spoke for each ball, as long as its load, within a rim.

    Parameters
    ----------
    loads
        Of the balls; what is not a number or not above zero is left out.
    azimuths
        Of the balls, in rad.
    height
        In lines; the drawing is twice as many characters wide.
    rim
        The load at the rim; the greatest of the loads if not given.
    braille
        Draw with braille dots, two by four to a character; otherwise with ASCII.
    """
    canvas = _Canvas(height, braille=braille)
    for step in range(16 * height):
        canvas.dot(1.0, 2.0 * pi * step / (16 * height), loaded=False)
    greatest = rim or max((load for load in loads if load > 0.0), default=0.0)
    for load, azimuth in zip(loads, azimuths, strict=True):
        if load > 0.0:
            canvas.spoke(load / greatest, azimuth)
    return list(canvas.lines())


class _Canvas:
    """Dots on a grid of characters, addressed by radius (1 at the rim) and azimuth."""

    def __init__(self, height: int, *, braille: bool) -> None:
        self._height, self._width = height, 2 * height
        self._braille = braille
        self._across, self._down = (2, 4) if braille else (1, 1)
        self._rim: set[tuple[int, int]] = set()
        self._loads: set[tuple[int, int]] = set()

    def dot(self, radius: float, azimuth: float, *, loaded: bool) -> None:
        columns, rows = self._width * self._across, self._height * self._down
        column = round((columns - 1) / 2 * (1.0 + radius * sin(azimuth)))
        row = round((rows - 1) / 2 * (1.0 - radius * cos(azimuth)))
        (self._loads if loaded else self._rim).add((row, column))

    def spoke(self, length: float, azimuth: float) -> None:
        steps = self._width * self._across
        for step in range(round(length * steps) + 1):
            self.dot(step / steps, azimuth, loaded=True)

    def lines(self) -> Iterator[list[Cell]]:
        for row in range(self._height):
            yield [self._cell(row, column) for column in range(self._width)]

    def _cell(self, row: int, column: int) -> Cell:
        if not self._braille:
            loaded = (row, column) in self._loads
            return Cell("o" if loaded else "." if (row, column) in self._rim else " ", loaded)
        bits, loaded = 0, False
        for down in range(self._down):
            for across in range(self._across):
                place = (self._down * row + down, self._across * column + across)
                loaded = loaded or place in self._loads
                if place in self._loads or place in self._rim:
                    bits |= _BITS[down][across]
        return Cell(chr(_BRAILLE + bits) if bits else " ", loaded)
