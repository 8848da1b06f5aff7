"""What figures over one field of a case share: the axis across, and lines that hold in places."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from numpy.typing import NDArray

from rolamento.charts.drawing import frame
from rolamento.charts.field_axis import field_axis
from rolamento.charts.record import FAINT, widened
from rolamento.charts.texts import numbers

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.studies.fields import Field

__all__ = ["across", "decades", "judged_line"]

Floats = NDArray[np.float64]

_DECADES: Final = 100.0
"""Greatest over least value from which on there is room for whole decades only."""
_NARROW: Final = 10.0
_WHOLE, _FEW, _MANY = (1.0,), (1.0, 2.0, 5.0), (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0)
"""Ticks in a decade of a wide, a middling and a narrow axis."""
_MOST_TICKS: Final = 9
_LONG: Final = 1e6
"""From here on a tick is written as a power of ten."""
_RAISED: Final = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def across(axes: Axes, field: Field, values: Floats) -> None:
    """Label the axis across with a field, its limits those of the values."""
    frame(axes, "x", field_axis(field, values))


def decades(axes: Axes, axis: str, limits: tuple[float, float]) -> None:
    """Make an axis, "x" or "y", logarithmic between two limits, however many decades there are."""
    getattr(axes, f"set_{axis}scale")("log")
    getattr(axes, f"set_{axis}lim")(*limits)
    span = limits[1] / limits[0]
    scaled = getattr(axes, f"{axis}axis")
    subs = _WHOLE if span > _DECADES else _FEW if span > _NARROW else _MANY
    scaled.set_major_locator(LogLocator(subs=subs, numticks=_MOST_TICKS))
    scaled.set_minor_locator(LogLocator(subs="auto", numticks=_MOST_TICKS))
    scaled.set_minor_formatter(NullFormatter())
    plain = numbers()

    def written(value: float, place: object) -> str:
        power = round(float(np.log10(value)))
        if value >= _LONG and np.isclose(value, 10.0**power):
            return "10" + str(power).translate(_RAISED)
        return plain(value, place)

    scaled.set_major_formatter(FuncFormatter(written))


def judged_line(
    axes: Axes, x: Floats, y: Floats, holds: NDArray[np.bool_], name: str, look: dict[str, Any]
) -> bool:
    """Draw a line, faintly where its model does not hold; return whether that is anywhere."""
    axes.plot(x, np.where(widened(holds), y, np.nan), label=name, **look)
    fails = np.isfinite(y) & ~holds
    if fails.any():
        axes.plot(x, np.where(widened(fails), y, np.nan), alpha=FAINT, **look)
    return bool(fails.any())
