"""Life over the angle of oscillation: race by race, beside Harris's form."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts.frame import (
    add_title,
    empty_frame,
    label_x,
    label_y,
    legend_above,
    log_scale,
)
from rolamento.charts.style import new_figure, series, styled
from rolamento.charts.texts import no_result
from rolamento.units import DEGREES
from rolamento.words import said

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.tasks.oscillation import OscillationCase

__all__ = ["life_over_angle", "oscillation_figure"]


def oscillation_figure(found: OscillationCase) -> Figure:
    """Draw the life over the angle of oscillation, with the angle of the case.

    Parameters
    ----------
    found
        What `rolamento.tasks.life_in_oscillation` gives.
    """
    with styled():
        figure, axes = new_figure(height=90.0)
        life_over_angle(found, axes)
        if found.solved.title:
            add_title(figure, found.solved.title)
    return figure


def life_over_angle(found: OscillationCase, axes: Axes | None = None) -> Axes:
    """Draw both lives, the range in which a bearing frets, and the critical angles.

    Parameters
    ----------
    found
        As of `oscillation_figure`.
    axes
        To draw on; of a new figure if not given.
    """
    with styled():
        axes = new_figure()[1] if axes is None else axes
        life = found.life
        if life is None or not np.isfinite(found.lives).any():
            return empty_frame(axes, no_result())
        angles = found.angles * DEGREES
        axes.plot(angles, found.lives, label=said("race by race"), **series(0).keywords())
        axes.plot(angles, found.simple, label=said("Harris"), **series(1).keywords())
        frets = 0.5 * life.critical * DEGREES
        axes.axvspan(
            float(angles[0]), frets, color="#D55E00", alpha=0.15, linewidth=0.0,
            label=said("fretting"),
        )  # fmt: skip
        for index, (values, name) in enumerate(
            ((life.critical_inner, said("critical angle, inner race")),
             (life.critical_outer, said("critical angle, outer race")))
        ):  # fmt: skip
            axes.axvline(
                float(values.max()) * DEGREES, color="#606060", linewidth=0.8,
                linestyle=("--", ":")[index], label=name,
            )  # fmt: skip
        if np.isfinite(life.life):
            axes.plot(
                [life.angle * DEGREES], [life.life], linestyle="none", marker="o", color="#000000",
                zorder=5, label=said("this duty"),
            )  # fmt: skip
        log_scale(axes, "x")
        log_scale(axes, "y")
        axes.set_xlim(float(angles[0]), float(angles[-1]))
        label_x(axes, said("Angle of oscillation between the end points (°)"))
        label_y(axes, said("Life (million oscillations)"))
        log_scale(axes, "x")
        log_scale(axes, "y")
        legend_above(axes)
    return axes
