"""Limits of what the analyses of life tests take."""

from __future__ import annotations

from typing import Final

from rolamento.validate import number, whole_number

MAXIMUM_SAMPLES: Final = 1_000_000
MAXIMUM_SHAPE: Final = 1000.0
LONGEST_TIME: Final = 1e12
"""Maximum of an age or a mission, in any unit."""


def time_of(value: object, field: str, *, least: float | None = None) -> float:
    """Return a time within reason: above zero, or from a least one on."""
    above = 0.0 if least is None else None
    return number(value, field, above=above, least=least, most=LONGEST_TIME, example="2000.0")


def shape_of(value: object, field: str = "shape") -> float:
    """Return a Weibull shape within reason."""
    return number(value, field, above=0.0, most=MAXIMUM_SHAPE, example="1.5")


def sample_count(value: object, least: int = 100) -> int:
    """Return the number of samples to draw."""
    return whole_number(value, "samples", least, MAXIMUM_SAMPLES, "10000")
