"""Reads the tables of the standards, which go by steps of a diameter."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Any, Final

from rolamento._data import toml_of
from rolamento.errors import InputError
from rolamento.units import from_si

__all__ = ["MICROMETRE", "MILLIMETRE", "step_of", "table"]

MICROMETRE: Final = 1e-6
MILLIMETRE: Final = 1e-3

_ROUNDING: Final = 1e-9
"""Relative: 0.025 m is 25 mm, whatever binary arithmetic makes of it."""


def table(name: str) -> Mapping[str, Any]:
    """Return a table of the package's data; not to be changed."""
    return toml_of(name, "rolamento.clearance")


def step_of(diameter: float, limits: Sequence[float], *, field: str, standard: str) -> int:
    """Return the step of a diameter: over limits[i] up to and including limits[i + 1].

    Parameters
    ----------
    diameter
        In m.
    limits
        In mm, rising.
    field, standard
        For the message.

    Raises
    ------
    InputError
        If the diameter is outside the limits.
    """
    size = diameter / MILLIMETRE
    found = bisect_left(limits, size * (1.0 - _ROUNDING)) - 1
    if not isfinite(size) or not 0 <= found < len(limits) - 1:
        raise InputError(
            f"is outside {standard}, which goes from over {limits[0]:g} mm to {limits[-1]:g} mm",
            field=field,
            value=from_si(diameter, "length") if isfinite(diameter) else diameter,
            example=f'{field} = "25 mm"',
        )
    return found
