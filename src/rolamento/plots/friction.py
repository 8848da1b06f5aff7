"""Friction over a field of a case: the torque by every model, and the ratios of spin to roll."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from rolamento.charts.axes_units import NONE, read_values, readable_unit
from rolamento.charts.frame import add_title, empty_frame, label_y, legend_above, log_scale
from rolamento.charts.style import (
    INNER,
    OUTER,
    new_figure,
    new_stacked_figure,
    series,
    styled,
)
from rolamento.charts.texts import no_result
from rolamento.friction.models import torque_model_name
from rolamento.plots.over_field import (
    across,
    is_geometric,
    judged_line,
)
from rolamento.studies.names import setting_name
from rolamento.words import said

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.studies.friction_curves import FrictionCurve

__all__ = ["friction_figure", "spin_to_roll", "torque_by_model"]

Floats = NDArray[np.float64]

_NO_SPIN: Final = 1e-9
"""Spin-to-roll ratio below which it is rounding."""
_CONTROLLED: Final = "friction_control"
_OF_CONTROL: Final = "#6a3d9a"
"""Colour of friction control: there are as many models as colours of series."""
_WIDE: Final = 30.0
"""Maximum over minimum torque from which on both axes become logarithmic, not only the field's."""
_VARIANTS: Final[tuple[Any, ...]] = ("-", "--", ":", "-.", (0, (5, 1, 1, 1)), (0, (7, 2)))


def friction_figure(curves: Sequence[FrictionCurve]) -> Figure:
    """Draw friction over a field: the torque by model, and over a speed the ratios below it.

    Parameters
    ----------
    curves
        The case's own first, then its variants; over one field.
    """
    shown = curves[0].is_speed and any(curve.controlled is not None for curve in curves)
    with styled():
        if shown:
            figure, (above, below) = new_stacked_figure(2, height=165.0)
            torque_by_model(curves, above)
            above.set_xlabel("")
            spin_to_roll(curves, below)
        else:
            figure, above = new_figure(height=105.0)
            torque_by_model(curves, above)
        if curves[0].case.title:
            add_title(figure, curves[0].case.title)
    return figure


def torque_by_model(curves: Sequence[FrictionCurve], axes: Axes | None = None) -> Axes:
    """Draw the running torque of all sources by every model; of variants by the one in use.

    Parameters
    ----------
    curves
        As in `friction_figure`.
    axes
        To draw on; of a new figure if not given.
    """
    with styled():
        axes = new_figure()[1] if axes is None else axes
        lines = list(_lines(curves))
        values = np.concatenate([torque for torque, _, _, _ in lines])
        if not np.isfinite(values).any():
            return empty_frame(axes, no_result())
        unit, x = readable_unit("N*m", values), _x(curves[0])
        faint = False
        for torque, valid, name, look in lines:
            faint |= judged_line(axes, x, unit.of(torque), valid, name, look)
        across(axes, curves[0].field, curves[0].values)
        if _is_wide(values) and is_geometric(curves[0].values):
            log_scale(axes, "y")
            axes.set_ylabel(unit.label(said("Friction torque")), parse_math=False)
        else:
            axes.set_ylim(bottom=0.0)
            label_y(axes, unit.label(said("Friction torque")))
        legend_above(axes, title=said("faint: the model is not valid there") if faint else "")
    return axes


def spin_to_roll(curves: Sequence[FrictionCurve], axes: Axes | None = None) -> Axes:
    """Draw the ratios of spin to roll under friction control, of the most loaded ball.

    Parameters as of `torque_by_model`.
    """
    with styled():
        axes = new_figure()[1] if axes is None else axes
        drawn = False
        for number, curve in enumerate(curves):
            if curve.controlled is None:
                continue
            ratios = (
                (said("inner contact"), INNER, curve.controlled.inner_spin_to_roll),
                (said("outer contact"), OUTER, curve.controlled.outer_spin_to_roll),
            )
            for name, look, values in ratios:
                drawn |= bool(np.isfinite(values).any())
                axes.plot(
                    _x(curve),
                    np.where(np.abs(values) < _NO_SPIN, 0.0, np.abs(values)),
                    color=look.color,
                    linestyle=_VARIANTS[number % len(_VARIANTS)],
                    label=", ".join(part for part in (name, setting_name(curve.label)) if part),
                )
        if not drawn:
            return empty_frame(axes, no_result())
        across(axes, curves[0].field, curves[0].values)
        axes.set_ylim(bottom=0.0)
        label_y(axes, NONE.label(said("Spin-to-roll ratio")))
        legend_above(axes)
    return axes


def _lines(
    curves: Sequence[FrictionCurve],
) -> list[tuple[Floats, NDArray[np.bool_], str, dict[str, Any]]]:
    """Torque, where it is valid, name and look of every line."""
    own = curves[0]
    lines: list[tuple[Floats, NDArray[np.bool_], str, dict[str, Any]]] = []
    for index, found in enumerate(own.friction.judged):
        name = torque_model_name(found.model)
        look = series(index).keywords()
        lines.append((own.torque(found.model), found.valid, name, look))
    torque = own.controlled_torque
    controlled = bool(np.isfinite(torque).any())
    if controlled:
        name = torque_model_name(_CONTROLLED)
        look = {"color": _OF_CONTROL, "linestyle": "-"}
        lines.append((torque, own.controlled_valid, name, look))
    for number, curve in enumerate(curves[1:], start=1):
        colour = _OF_CONTROL if controlled else "#000000"
        look = {"color": colour, "linestyle": _VARIANTS[number % len(_VARIANTS)]}
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
