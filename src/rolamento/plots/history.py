"""A machine's history: depths now and then, and over many records."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from rolamento.charts import Axis, Chart, Line, Look, Mark, series_look
from rolamento.charts.drawing import draw
from rolamento.charts.frame import GREY, label_y, legend_above, panels
from rolamento.charts.style import new_figure, series, styled
from rolamento.numerics import FloatArray
from rolamento.vibration.diagnosis import DAMAGE
from rolamento.words import said
from rolamento.words.naming import part_name

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["records_figure", "then_figure"]


def then_figure(parts: Sequence[tuple[str, float, Sequence[float]]]) -> Figure:
    """Draw the depth of each part now beside those of the machine's good days.

    Parameters
    ----------
    parts
        Name, depth now, and depths then.
    """
    with styled():
        figure, axes = new_figure(height=70.0)
        places = np.arange(len(parts))
        now = [100.0 * part[1] for part in parts]
        look = series(0)
        for place, (_, _, then) in enumerate(parts):
            label = said("machine in good order") if place == 0 else None
            axes.plot(
                np.full(len(then), place), 100.0 * np.array(then), color=GREY, linestyle="",
                marker="_", markersize=18.0, label=label,
            )  # fmt: skip
        axes.plot(
            places, now, color=look.color, linestyle="", marker=look.marker, label=said("now")
        )
        axes.axhline(100.0 * DAMAGE, color=GREY, linestyle="--", linewidth=0.9,
                     label=said("damage, without a history"))  # fmt: skip
        axes.set_xticks(places, [part_name(part[0]) for part in parts])
        axes.set_xlim(-0.5, len(parts) - 0.5)
        axes.set_ylim(bottom=0.0)
        label_y(axes, said("Modulation depth (%)"))
        legend_above(axes)
    return figure


def records_figure(
    depths: Mapping[str, FloatArray], changes: Mapping[str, Sequence[int]]
) -> Figure:
    """Draw the depth of each part over many records, and where its level changes.

    Parameters
    ----------
    depths
        (records,) by part.
    changes
        Places of the first records of a new level, by part.
    """
    return panels(lambda axes: draw(records_chart(depths, changes), axes), height=80.0)


def records_chart(depths: Mapping[str, FloatArray], changes: Mapping[str, Sequence[int]]) -> Chart:
    """Return the depth of each part over the records."""
    lines, marks = [], [Mark(100.0 * DAMAGE, "", Look("grey", "dash", width=0.65))]
    for number, (part, values) in enumerate(depths.items()):
        look = replace(series_look(number), dash="solid", width=0.65)
        records = np.arange(1.0, len(values) + 1.0)
        lines.append(Line(records, 100.0 * values, part_name(part), look, "both"))
        level = replace(look, dash="dot")
        marks += [Mark(place + 1.0, "", level, "x") for place in changes.get(part, ())]
    upright = Axis(unit="%", zero=True, label=said("Modulation depth (%)"))
    return Chart(tuple(lines), Axis(said("Record")), upright, marks=tuple(marks))
