"""Friction over a field of a case: the torque by every model, and the ratios of spin to roll."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.charts import Axis, Chart, Line, Look, nothing, series_look
from rolamento.charts.axes_units import read_values, readable_unit
from rolamento.charts.drawing import figure
from rolamento.charts.field_axis import field_axis, is_geometric
from rolamento.charts.texts import capitalised, no_result
from rolamento.friction.models import torque_model_name
from rolamento.studies.names import setting_name
from rolamento.words import said
from rolamento.words.quantities import called

if TYPE_CHECKING:
    from rolamento.studies.friction_curves import FrictionCurve

__all__ = ["friction_figure", "spin_chart", "torque_chart"]

Floats = NDArray[np.float64]

_NO_SPIN: Final = 1e-9
"""Spin-to-roll ratio below which it is rounding."""
_CONTROLLED: Final = "friction_control"
_OF_CONTROL: Final = "seventh"
"""Colour of friction control: there are as many models as colours of series."""
_WIDE: Final = 30.0
"""Maximum over minimum torque from which on both axes become logarithmic, not only the field's."""
_VARIANTS: Final = ("solid", "dash", "dot", "dashdot", "dashdotdot", "longdash")


def friction_figure(curves: Sequence[FrictionCurve]) -> Figure:
    """Draw friction over a field: the torque by model, and over a speed the ratios below it.

    Parameters
    ----------
    curves
        The case's own first, then its variants; over one field.
    """
    charts = [torque_chart(curves)]
    if curves[0].is_speed and any(curve.controlled is not None for curve in curves):
        charts.append(spin_chart(curves))
    return figure(*charts, title=curves[0].case.title, height=165.0 if len(charts) > 1 else 105.0)


def torque_chart(curves: Sequence[FrictionCurve]) -> Chart:
    """Return the running torque of all sources by every model; of variants by the one in use."""
    lines = list(_lines(curves))
    values = np.concatenate([torque for torque, _, _, _ in lines])
    if not np.isfinite(values).any():
        return nothing(no_result())
    unit, x = readable_unit("N*m", values), _x(curves[0])
    series = (Line(x, unit.of(torque), name, look, valid=valid | ~np.isfinite(torque))
              for torque, valid, name, look in lines)  # fmt: skip
    wide = _is_wide(values) and is_geometric(curves[0].values)
    upright = Axis(capitalised(called("torque")), unit.symbol, log=wide, zero=True)
    chart = Chart(tuple(series), field_axis(curves[0].field, curves[0].values), upright)
    return chart.where_faint(said("faint: the model is not valid there"))


def spin_chart(curves: Sequence[FrictionCurve]) -> Chart:
    """Return the ratios of spin to roll of the most loaded ball, of each curve at both races."""
    series = []
    for number, curve in enumerate(curves):
        if curve.controlled is None:
            continue
        for race, name, values in (
            ("inner", said("inner contact"), curve.controlled.inner_spin_to_roll),
            ("outer", said("outer contact"), curve.controlled.outer_spin_to_roll),
        ):
            own = ", ".join(part for part in (name, setting_name(curve.label)) if part)
            ratio = np.where(np.abs(values) < _NO_SPIN, 0.0, np.abs(values))
            series.append(
                Line(_x(curve), ratio, own, Look(race, _VARIANTS[number % len(_VARIANTS)]))
            )
    if not any(np.isfinite(line.y).any() for line in series):
        return nothing(no_result())
    across = field_axis(curves[0].field, curves[0].values)
    return Chart(tuple(series), across, Axis(capitalised(called("spin_to_roll")), zero=True))


def _lines(curves: Sequence[FrictionCurve]) -> list[tuple[Floats, NDArray[np.bool_], str, Look]]:
    """Torque, where it is valid, name and look of every line."""
    own = curves[0]
    lines: list[tuple[Floats, NDArray[np.bool_], str, Look]] = []
    for index, found in enumerate(own.friction.judged):
        name = torque_model_name(found.model)
        look = series_look(index)
        lines.append((own.torque(found.model), found.valid, name, look))
    torque = own.controlled_torque
    controlled = bool(np.isfinite(torque).any())
    if controlled:
        name = torque_model_name(_CONTROLLED)
        look = Look(_OF_CONTROL)
        lines.append((torque, own.controlled_valid, name, look))
    for number, curve in enumerate(curves[1:], start=1):
        look = Look(_OF_CONTROL if controlled else "ink", _VARIANTS[number % len(_VARIANTS)])
        model = _CONTROLLED if controlled else curve.friction.model
        if controlled:
            torque, valid = curve.controlled_torque, curve.controlled_valid
        else:
            torque, valid = curve.torque(model), curve.valid(model)
        name = f"{torque_model_name(model)}, {setting_name(curve.label)}"
        lines.append((torque, np.asarray(valid), name, look))
    return lines


def _x(curve: FrictionCurve) -> Floats:
    return read_values(curve.field, curve.values)[0]


def _is_wide(values: Floats) -> bool:
    finite = values[np.isfinite(values)]
    return bool(finite.min() > 0.0 and finite.max() > _WIDE * finite.min())
