"""The axis of a field of a case: its name, its unit, whether its points have equal ratios."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from rolamento.charts.axes_units import read_values
from rolamento.charts.record import Axis
from rolamento.charts.texts import capitalised
from rolamento.studies.fields import Field

__all__ = ["field_axis", "is_geometric"]

Floats = NDArray[np.float64]


def field_axis(field: Field, values: Floats) -> Axis:
    """Return the axis of a field, its limits those of the values (SI)."""
    x, symbol = read_values(field, values)
    limits = float(x.min()), float(x.max())
    return Axis(capitalised(field.label), symbol, limits, log=is_geometric(values))


def is_geometric(values: Floats) -> bool:
    """Whether the points have equal ratios, as after ``--log``."""
    if len(values) < 3 or not np.all(values * values[0] > 0.0):
        return False
    ratios = np.diff(np.log(np.abs(values)))
    return bool(np.ptp(ratios) < 1e-6 * np.abs(ratios).max())
