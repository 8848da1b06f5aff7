"""The life of a grease over the temperature, by every law."""

from __future__ import annotations

from dataclasses import replace
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
from rolamento.grease.models import MODELS
from rolamento.units import ZERO_CELSIUS
from rolamento.words import said
from rolamento.words.sentences.grease import LAWS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.tasks.grease import GreaseCase

__all__ = ["grease_figure", "life_over_temperature"]

_COLDEST, _HOTTEST, _POINTS = 40.0, 180.0, 141


def grease_figure(found: GreaseCase) -> Figure:
    """Draw the life of the grease over the temperature.

    Parameters
    ----------
    found
        What `rolamento.tasks.grease_of_case` gives.
    """
    with styled():
        figure, axes = new_figure(height=90.0)
        life_over_temperature(found, axes)
        if found.solved.title:
            add_title(figure, found.solved.title)
    return figure


def life_over_temperature(found: GreaseCase, axes: Axes | None = None) -> Axes:
    """Draw the mean life by each law within its range, and the case's temperature.

    Parameters
    ----------
    found
        As of `grease_figure`.
    axes
        To draw on; of a new figure if not given.
    """
    with styled():
        axes = new_figure()[1] if axes is None else axes
        warm = np.linspace(_COLDEST, _HOTTEST, _POINTS)
        drawn = False
        for index, law in enumerate(MODELS.values()):
            lives = [
                law.evaluate(replace(found.duty, temperature=float(one) + ZERO_CELSIUS))
                for one in warm
            ]
            hours = np.array([one.hours for one in lives])
            if np.isfinite(hours).any():
                name = said(LAWS[lives[0].name])
                axes.plot(warm, hours, label=name, **series(index).keywords())
                drawn = True
        if not drawn or not found.lives:
            axes.clear()
            return empty_frame(axes, no_result())
        axes.axvline(
            found.duty.temperature - ZERO_CELSIUS, color="#606060", linewidth=0.8, linestyle="--",
            label=said("this case"),
        )  # fmt: skip
        label_x(axes, said("Temperature of the bearing (°C)"))
        label_y(axes, said("Mean life of the grease (h)"))
        log_scale(axes, "y")
        axes.set_xlim(_COLDEST, _HOTTEST)
        legend_above(axes)
    return axes
