"""Words and numbers on the pictures of a reproduction."""

from __future__ import annotations

import re
from typing import Final

import numpy as np
from matplotlib.axis import Axis
from matplotlib.ticker import Formatter

from rolamento_reproductions.record import Floats
from rolamento_reproductions.text import Language, localised, with_indices

__all__ = ["Numbers", "mathematical", "titled"]

_LONE_SYMBOL: Final = re.compile(r"(?<![$\w{}])([α-ωQ])(?![\w$}])")


class Numbers(Formatter):
    """Numbers of an axis: as many decimals as its ticks need, in the manner of a language."""

    def __init__(self, ticked: Axis, language: Language) -> None:
        self._ticked = ticked
        self._language: Language = language

    def __call__(self, x: float, pos: int | None = None) -> str:
        """Return how a number stands at the axis."""
        places: Floats = np.asarray(self._ticked.get_majorticklocs(), dtype=np.float64)
        decimals = next(
            (n for n in range(7) if np.allclose(places, np.round(places, n), rtol=0, atol=1e-9)), 7
        )
        value = 0.0 if round(x, decimals) == 0.0 else x
        grouping = "," if np.abs(places).max(initial=0.0) >= 1e4 else ""
        return localised(f"{value:{grouping}.{decimals}f}", self._language)


def titled(title: str, unit: str) -> str:
    """Return an axis's title with its unit."""
    return f"{mathematical(title)} ({unit})" if unit else mathematical(title)


def mathematical(text: str) -> str:
    """Set symbols as mathematics: indices below, letters that stand for quantities slanted."""
    indexed = with_indices(
        text,
        lambda symbol, index: (
            f"${symbol}_{{{index}}}$" if len(index) == 1 else f"${symbol}_{{\\mathrm{{{index}}}}}$"
        ),
    )
    return _LONE_SYMBOL.sub(r"$\1$", indexed)
