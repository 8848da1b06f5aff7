"""One palette: a part has the same colour, dash and mark in every picture, whatever draws it.

The colours are those of Okabe and Ito (2008), "Color Universal Design", by the name of what they
stand for; in the dark lighter ones of the same hues. Each comes with a dash and a mark of its own,
so that a picture can be read in black and white.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento.geometry import Race
from rolamento.records import frozen

__all__ = ["DARK", "LIGHT", "SERIES", "Look", "case_look", "race_look", "series_look"]

LIGHT: Final[Mapping[str, str]] = {
    "inner": "#0072B2", "outer": "#D55E00", "inner2": "#009E73", "outer2": "#CC79A7",
    "fifth": "#E69F00", "sixth": "#56B4E9", "seventh": "#6A3D9A",
    "ink": "#000000", "grey": "#707070",
    "good": "#17692F", "fair": "#855300", "bad": "#B3201B",
}  # fmt: skip
"""Colours on white paper, by part; "inner2" and "outer2" are those of a second case."""
DARK: Final[Mapping[str, str]] = {
    "inner": "#56B4E9", "outer": "#F08A3C", "inner2": "#3FCF9F", "outer2": "#E59BC6",
    "fifth": "#F0C04F", "sixth": "#8FD3FF", "seventh": "#B79BE6",
    "ink": "#DFE4E7", "grey": "#98A4AC",
    "good": "#74CF8B", "fair": "#EAB95A", "bad": "#FF8F86",
}  # fmt: skip
"""Colours on a dark page, by the same names."""


@frozen
class Look:
    """How a series is drawn.

    Attributes
    ----------
    color
        a name of the palette; "white" on a field of colours
    dash
        "solid", "dash", "dashdot", "dot", "longdash", "longdashdot", "dashdotdot", "fine"
    mark
        "circle", "square", "triangle-up", "diamond", "triangle-down", "cross", "x", "star",
        "triangle-left", "triangle-right", "query"; "tick" is an upright stroke, "thin" a thin cross
    hollow
        whether marks are outlines
    width
        of the line, in those of an ordinary one
    opacity
        of the line and its marks
    """

    color: str
    dash: str = "solid"
    mark: str = "circle"
    hollow: bool = False
    width: float = 1.0
    opacity: float = 1.0


SERIES: Final = (
    Look("inner", "solid", "circle"),
    Look("outer", "dash", "square"),
    Look("inner2", "dashdot", "triangle-up"),
    Look("outer2", "dot", "diamond"),
    Look("fifth", "dashdotdot", "triangle-down"),
    Look("sixth", "longdash", "cross"),
    Look("ink", "fine", "x"),
)
"""How lines are drawn that stand for no part, in their order."""

_CASES: Final = (("inner", "outer"), ("inner2", "outer2"), ("fifth", "sixth"), ("seventh", "ink"))
"""Hues of the races, case by case."""
_DASHES: Final = ("solid", "dash", "dashdot", "dot", "longdash", "longdashdot")
_MARKS: Final = ("circle", "square", "triangle-up", "diamond", "triangle-down", "cross", "star")


def series_look(index: int) -> Look:
    """Return how the line of an index is drawn; after the last the cycle begins anew."""
    return SERIES[index % len(SERIES)]


def race_look(race: Race, case: int = 0, row: int = 0) -> Look:
    """Return how what belongs to a race is drawn.

    Parameters
    ----------
    race
        Of which the hue is; case: 0, or 1 of a second case beside it, with a hue of its own.
    case
        Its marks are hollow if it is the second.
    row
        Of several each has its own dashes and marks; case and race shift them.

    >>> race_look("outer", row=1)
    Look(color='outer', dash='dot', mark='diamond', hollow=False, width=1.0, opacity=1.0)
    """
    step = 2 * (case + row) + (race == "outer")
    color = _CASES[case % len(_CASES)][race == "outer"]
    mark = _MARKS[(2 * row + (race == "outer")) % len(_MARKS)]
    return Look(color, _DASHES[step % len(_DASHES)], mark, hollow=bool(case))


def case_look(case: int) -> Look:
    """Return how what belongs to a whole case is drawn."""
    mark = "diamond" if case else "circle"
    return Look(_CASES[case % len(_CASES)][0], SERIES[2 * case % len(SERIES)].dash, mark)
