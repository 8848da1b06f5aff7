"""The life of a grease over the temperature, by every law."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts import Axis, Chart, Line, Look, Mark, nothing, series_look
from rolamento.charts.drawing import figure
from rolamento.charts.texts import no_result, number
from rolamento.grease.models import MODELS
from rolamento.units import ZERO_CELSIUS
from rolamento.words import said
from rolamento.words.sentences.grease import LAWS

if TYPE_CHECKING:
    from rolamento.grease.of_case import GreaseCase

__all__ = ["grease_figure", "temperature_chart"]

_COLDEST, _HOTTEST, _POINTS = 40.0, 180.0, 141


def grease_figure(found: GreaseCase) -> Figure:
    """Draw the life of the grease over the temperature.

    Parameters
    ----------
    found
        What `rolamento.tasks.grease_of_case` gives.
    """
    return figure(temperature_chart(found), title=found.solved.title)


def temperature_chart(found: GreaseCase) -> Chart:
    """Return the mean life by each law within its range, and the case's temperature."""
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
        Axis(unit="°C", limits=(_COLDEST, _HOTTEST), name=said("Temperature of the bearing")),
        Axis(unit="h", log=True, name=said("Mean life of the grease")),
        said(
            "this case, {temperature}: {lives}",
            temperature=f"{number(now, 3)} °C",
            lives="; ".join(
                f"{said(LAWS[one.name])} {number(one.hours, 3)} h"
                for one in found.lives
                if np.isfinite(one.hours)
            )
            or no_result(),
        ),
        marks=(Mark(now, said("this case"), Look("grey", "dash", width=0.6), "x"),),
    )
