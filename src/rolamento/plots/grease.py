"""The life of a grease over the temperature, by every law."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts import Axis, Chart, Line, Look, Mark, nothing, series_look
from rolamento.charts.drawing import draw
from rolamento.charts.frame import panels
from rolamento.charts.texts import no_result
from rolamento.grease.models import MODELS
from rolamento.units import ZERO_CELSIUS
from rolamento.words import said
from rolamento.words.sentences.grease import LAWS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.grease.of_case import GreaseCase

__all__ = ["grease_figure", "life_over_temperature"]

_COLDEST, _HOTTEST, _POINTS = 40.0, 180.0, 141


def grease_figure(found: GreaseCase) -> Figure:
    """Draw the life of the grease over the temperature.

    Parameters
    ----------
    found
        What `rolamento.tasks.grease_of_case` gives.
    """
    return panels(
        lambda axes: life_over_temperature(found, axes), title=found.solved.title, height=90.0
    )


def life_over_temperature(found: GreaseCase, axes: Axes | None = None) -> Axes:
    """Draw the mean life by each law within its range, and the case's temperature.

    Parameters
    ----------
    found
        As of `grease_figure`.
    axes
        To draw on; of a new figure if not given.
    """
    return draw(temperature_chart(found), axes)


def temperature_chart(found: GreaseCase) -> Chart:
    """Return the mean life by each law within its range."""
    warm = np.linspace(_COLDEST, _HOTTEST, _POINTS)
    lines = []
    for index, law in enumerate(MODELS.values()):
        lives = [
            law.evaluate(replace(found.duty, temperature=float(one) + ZERO_CELSIUS)) for one in warm
        ]
        hours = np.array([one.hours for one in lives])
        if np.isfinite(hours).any():
            lines.append(Line(warm, hours, said(LAWS[lives[0].name]), series_look(index)))
    if not lines or not found.lives:
        return nothing(no_result())
    now = found.duty.temperature - ZERO_CELSIUS
    return Chart(
        tuple(lines),
        Axis(unit="°C", limits=(_COLDEST, _HOTTEST), label=said("Temperature of the bearing (°C)")),
        Axis(unit="h", log=True, label=said("Mean life of the grease (h)")),
        marks=(Mark(now, said("this case"), Look("grey", "dash", width=0.6), "x"),),
    )
