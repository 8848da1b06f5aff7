"""The page of `seek`: the input that gives an output its value, on the curve that leads there."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.charts import Chart, Line, Look, Mark
from rolamento.charts.axes_units import read_values, readable_unit
from rolamento.charts.curve_charts import curve_chart
from rolamento.charts.texts import capitalised
from rolamento.document import Column, Document, Figure, Section, Statement, Table, Title, Tone
from rolamento.pages.across import field_column, read_text
from rolamento.pages.given import title_of
from rolamento.pages.notes import cautions
from rolamento.words import ABSENT, UNITS, manner, said

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Picture

    from rolamento.tasks.seek import Goal

__all__ = ["seek_chart", "seek_page", "seek_picture", "seek_statement"]

_WIDE: Final = 100.0
"""The greatest over the least value from which on the upright axis is logarithmic."""


def seek_page(found: Goal) -> Document:
    """Return the page of a goal that was sought.

    Parameters
    ----------
    found
        Of `rolamento.tasks.seek.GoalSeek`.
    """
    case = found.curve.case
    title = title_of(case)
    tone: Tone = "good-strong" if found.found else "warning-strong"
    statements = [Statement(seek_statement(found), tone)]
    for at in found.jumps:
        text = said(
            "At {value} {output} jumps, or ends: no solution lies there.",
            value=_value(found, at),
            output=found.output.label,
        )
        statements.append(Statement(text, "warning"))
    if found.curve.present is not None:
        statements.append(Statement(_now(found), "faint"))
    head = Section("", (*statements, *cautions(found.notes), Title(title)), "verdict")
    caption = said("{output} over {field}", output=found.output.label, field=found.field.label)
    figure = Figure(caption, lambda: seek_picture(found), "curve")
    table = Section("", (figure, _table(found)), "curve")
    return Document(title, (head, table), kind="seek", main="curve")


def seek_statement(found: Goal) -> str:
    """Return what gives the output its value, or that nothing in the range does."""
    names = {"field": found.field.label, "output": found.output.label}
    goal = _number(found, found.target)
    if found.found:
        values = said(" or ").join(_value(found, at) for at in found.found)
        return capitalised(
            said("{field} of {values}: {output} of {goal}.", values=values, goal=goal, **names)
        )
    numbers = found.curve.numbers
    first, last = (_value(found, float(one)) for one in found.curve.values[[0, -1]])
    if not np.isfinite(numbers).any():
        reasons = "; ".join(note.text for note in found.curve.reasons)
        return said(
            "No result from {first} to {last}: {reasons}",
            first=first, last=last, reasons=reasons or ABSENT,
        )  # fmt: skip
    return said(
        "Nowhere from {first} to {last} is there {output} of {goal}: it lies between {least} and"
        " {most}. Give a wider range.",
        first=first,
        last=last,
        least=_number(found, float(np.nanmin(numbers))),
        most=_number(found, float(np.nanmax(numbers))),
        goal=goal,
        output=names["output"],
    )


def seek_chart(found: Goal) -> Chart:
    """Return the chart of the output over the field, its goal, and where it is met."""
    known = found.curve.numbers[np.isfinite(found.curve.numbers)]
    wide = known.size > 0 and known.min() > 0.0 and found.target > 0.0
    wide = bool(wide and known.max() > _WIDE * known.min())
    chart = curve_chart([found.curve], upright="log" if wide else "linear")
    if not chart.series:
        return chart
    if wide:
        chart = replace(chart, y=replace(chart.y, step=1.0))
    unit = readable_unit(found.output.unit, found.curve.numbers, found.output.name)
    goal = float(unit.of(found.target))
    marks = (Mark(goal, said("goal"), Look("outer", dash="dash")),)
    series = chart.series
    if found.found:
        places = read_values(found.field, np.append(found.curve.values, found.found))[0]
        at = places[len(found.curve.values) :]
        look = Look("outer", mark="star")
        series = (*series, Line(at, np.full(len(at), goal), said("found"), look, "points"))
    return replace(chart, series=series, marks=marks, conclusion=seek_statement(found))


def seek_picture(found: Goal) -> Picture:
    """Draw the chart of a goal as a figure."""
    from rolamento.charts.drawing import draw
    from rolamento.charts.frame import figure_of

    return figure_of(draw(seek_chart(found)))


def _table(found: Goal) -> Table:
    """Set the curve in a table, what was found among it."""
    curve = found.curve
    values = np.concatenate([curve.values, found.found])
    numbers = np.concatenate([curve.numbers, np.full(len(found.found), found.target)])
    order = np.argsort(values, kind="stable")
    unit = readable_unit(found.output.unit, numbers, found.output.name)
    tones: list[Tone] = ["good-strong" if place >= len(curve.values) else "" for place in order]
    read, known = unit.of(numbers[order]), unit.symbol in UNITS
    if known:  # what an output has in hours or 10⁶ rev is in SI here, as in every table
        factor, offset = UNITS[unit.symbol]
        read = (read - offset) / factor
    column = Column(
        found.output.label if known else unit.label(found.output.label),
        [float(one) if np.isfinite(one) else ABSENT for one in read],
        found.output.name,
        unit.symbol if known else "",
        most=6,
        tones=tones,
    )
    return Table((field_column(found.field, values[order]), column), "curve")


def _now(found: Goal) -> str:
    curve = found.curve
    assert curve.present is not None
    at, number = float(curve.values[curve.present]), float(curve.numbers[curve.present])
    if not np.isfinite(number):
        return said("Now, at {value}, it has no result.", value=_value(found, at))
    return said(
        "Now, at {value}, it is {number}.", value=_value(found, at), number=_number(found, number)
    )


def _value(found: Goal, at: float) -> str:
    return read_text(found.field, np.append(found.curve.values, at), at)


def _number(found: Goal, number: float) -> str:
    unit = readable_unit(found.output.unit, [number], found.output.name)
    text = manner().short(float(unit.of(number)), 4)
    return text if unit.symbol == "–" else f"{text} {unit.symbol}"
