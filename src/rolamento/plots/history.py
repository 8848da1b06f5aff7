"""A machine's history: depths now and then, and over many records."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from rolamento.charts import Axis, Chart, Line, Look, Mark, series_look
from rolamento.charts.drawing import figure
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
    return figure(then_chart(parts), height=38.0 + 11.0 * max(len(parts), 2))


def then_chart(parts: Sequence[tuple[str, float, Sequence[float]]]) -> Chart:
    """Return the depths of parts, now and then; parameters as of `then_figure`."""
    places = np.arange(float(len(parts)))
    then = np.concatenate([100.0 * np.asarray(own, np.float64) for _, _, own in parts])
    rows = np.repeat(places, [len(own) for _, _, own in parts])
    now = np.array([100.0 * depth for _, depth, _ in parts])
    damage = said("damage, without a history")
    deepest = max(parts, key=lambda part: part[1])
    conclusion = said(
        "deepest now: {part}, {depth:.3 %}; in good order {usual:.3 %} at most",
        part=part_name(deepest[0]), depth=deepest[1], usual=max(deepest[2], default=float("nan")),
    )  # fmt: skip
    return Chart(
        (Line(then, rows, said("machine in good order"), Look("grey", mark="tick", width=2.0),
              "points"),
         Line(now, places, said("now"), Look("inner"), "points")),
        Axis(zero=True, name=said("Modulation depth"), unit="%"),
        Axis(categories=tuple(part_name(name) for name, _, _ in parts)),
        conclusion,
        marks=(Mark(100.0 * DAMAGE, damage, Look("grey", "dash", width=0.65), "x"),),
    )  # fmt: skip


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
    return figure(records_chart(depths, changes), height=80.0)


def records_chart(depths: Mapping[str, FloatArray], changes: Mapping[str, Sequence[int]]) -> Chart:
    """Return the depth of each part over the records."""
    lines, marks = [], [Mark(100.0 * DAMAGE, "", Look("grey", "dash", width=0.65))]
    for number, (part, values) in enumerate(depths.items()):
        look = replace(series_look(number), dash="solid", width=0.65)
        records = np.arange(1.0, len(values) + 1.0)
        lines.append(Line(records, 100.0 * values, part_name(part), look, "both"))
        level = replace(look, dash="dot")
        marks += [Mark(place + 1.0, "", level, "x") for place in changes.get(part, ())]
    upright = Axis(unit="%", zero=True, name=said("Modulation depth"))
    return Chart(tuple(lines), Axis(said("Record")), upright, marks=tuple(marks))
