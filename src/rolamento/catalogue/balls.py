"""Standard ball sizes."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from typing import Final

import numpy as np

from rolamento._data import toml_of
from rolamento.numerics import FloatArray

__all__ = ["ball_name", "ball_sizes"]

_INCH: Final = 25.4e-3
_SAME: Final = 2e-3
"""Relative difference within which a printed ball size is a rounded standard one."""


def ball_sizes() -> FloatArray:
    """Return the diameters of the standard balls in m, rising."""
    return np.array(sorted({round(size, 9) for size, _ in _named_sizes()}))


def ball_name(diameter: float) -> str:
    """Return how a standard ball is called, ``"5/16 in"`` or ``"8 mm"``; else an empty text.

    Parameters
    ----------
    diameter
        In m.
    """
    size, name = min(_named_sizes(), key=lambda known: abs(known[0] - diameter))
    return name if abs(size - diameter) <= _SAME * diameter else ""


@lru_cache(maxsize=1)
def _named_sizes() -> tuple[tuple[float, str], ...]:
    data = toml_of("ball_sizes")
    inches = [
        Fraction(number, parts)
        for key, parts in (("inch_64ths", 64), ("inch_32nds", 32), ("inch_16ths", 16))
        for number in data[key]
    ]
    metric = [(1e-3 * size, f"{size:g} mm") for size in data["metric_mm"]]
    return (*((float(size) * _INCH, _inch_name(size)) for size in inches), *metric)


def _inch_name(size: Fraction) -> str:
    whole, rest = divmod(size, 1)
    return " ".join(str(part) for part in (whole, rest) if part) + " in"
