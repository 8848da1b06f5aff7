"""Life over the angle of oscillation: race by race, beside Harris's form."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts import Axis, Chart, Line, Look, Mark, Zone, nothing, series_look
from rolamento.charts.drawing import figure
from rolamento.charts.texts import no_result
from rolamento.units import DEGREES
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.tasks.oscillation import OscillationCase

__all__ = ["angle_chart", "oscillation_figure"]


def oscillation_figure(found: OscillationCase) -> Figure:
    """Draw the life over the angle of oscillation, with the angle of the case.

    Parameters
    ----------
    found
        What `rolamento.tasks.life_in_oscillation` gives.
    """
    return figure(angle_chart(found), title=found.solved.title)


def angle_chart(found: OscillationCase) -> Chart:
    """Return both lives over the angle, where a bearing frets, and the critical angles."""
    life = found.life
    if life is None or not np.isfinite(found.lives).any():
        return nothing(no_result())
    angles = found.angles * DEGREES
    series = [Line(angles, found.lives, said("race by race"), series_look(0)),
              Line(angles, found.simple, said("Harris"), series_look(1))]  # fmt: skip
    frets = Zone(float(angles[0]), 0.5 * life.critical * DEGREES, said("fretting"), "fair", "x")
    marks = [
        Mark(float(values.max()) * DEGREES, name, Look("grey", dash, width=0.6), "x")
        for values, name, dash in (
            (life.critical_inner, said("critical angle, inner race"), "dash"),
            (life.critical_outer, said("critical angle, outer race"), "dot"),
        )
    ]
    if np.isfinite(life.life):
        at = np.array([life.angle * DEGREES]), np.array([life.life])
        series.append(Line(*at, said("this duty"), Look("ink"), "points"))
    return Chart(
        tuple(series),
        Axis(unit="°", limits=(float(angles[0]), float(angles[-1])), log=True,
             name=said("Angle of oscillation between the end points")),
        Axis(log=True, name=said("Life"), unit=said("million oscillations")),
        said("this duty, {angle:.3 °}: {life}; frets below {frets:.3 °}", angle=life.angle,
             frets=0.5 * life.critical,
             life=said("{life:.3} million oscillations", life=life.life)
             if np.isfinite(life.life) else said("no life")),
        marks=tuple(marks),
        zones=(frets,),
    )  # fmt: skip
