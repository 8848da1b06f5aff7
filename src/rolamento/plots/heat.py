"""The heat balance: friction and the heat that is removed, and temperatures over a field."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts import Axis, Bars, Chart, Line, Look, nothing, series_look
from rolamento.charts.axes_units import read_values, readable_unit
from rolamento.charts.courses import course
from rolamento.charts.drawing import draw, figure
from rolamento.charts.field_axis import field_axis
from rolamento.charts.frame import panels
from rolamento.charts.texts import capitalised, no_result
from rolamento.heat import NODES
from rolamento.numerics import FloatArray
from rolamento.units import ZERO_CELSIUS
from rolamento.words import said
from rolamento.words.quantities import called
from rolamento.words.sentences.heat import PLACE_NAMES, VARIANT_NAMES

if TYPE_CHECKING:
    from rolamento.heat import HeatBalance, HeatTransient
    from rolamento.heat.answers import HeatVariant
    from rolamento.heat.machine import MachineHeat
    from rolamento.studies.heat_curves import HeatOver

__all__ = ["heat_figure", "heat_over_figure", "heat_time_figure",
           "heat_variants_figure"]  # fmt: skip

_HOURS: Final = 3.0 * 3600.0
"""s beyond which time is shown in hours."""


def heat_figure(found: HeatBalance) -> Figure:
    """Draw the balance: friction and the heat that is removed, with the states where they cross.

    Parameters
    ----------
    found
        What `rolamento.heat.heat_balance` gives.
    """
    return figure(balance_chart(found), title=found.case.title, height=95.0)


def balance_chart(found: HeatBalance) -> Chart:
    """Return friction and the heat that is removed, with the states where they cross."""
    curve = found.curve
    if not np.isfinite(curve.friction).any():
        return nothing(no_result())
    warm = curve.temperatures.max(axis=0) - ZERO_CELSIUS
    lines = [Line(warm, curve.friction, said("friction"), series_look(1)),
             Line(warm, curve.power, said("heat removed"), series_look(0))]  # fmt: skip
    for stable, name in ((True, said("stable state")), (False, said("unstable state"))):
        own = [root for root in found.roots if root.stable == stable]
        if own:
            hottest = np.array([max(root.temperatures.values()) for root in own]) - ZERO_CELSIUS
            powers = np.array([root.power for root in own])
            lines.append(Line(hottest, powers, name, Look("ink", hollow=not stable), "points"))
    across, upright = _warmest(warm), Axis(said("Power"), "W", zero=True)
    states = [(one.name, one.x[at : at + 1], one.y[at : at + 1])
              for one in lines[2:] for at in range(len(one.x))]  # fmt: skip
    conclusion = "; ".join(course(*one, across, upright) for one in states)
    return Chart(
        tuple(lines), across, upright,
        conclusion or said("friction exceeds the heat that is removed at every temperature"),
    )  # fmt: skip


def _warmest(warm: FloatArray) -> Axis:
    limits = float(warm.min()), float(warm.max())
    return Axis(unit="°C", limits=limits, name=said("Temperature of the warmest part"))


def heat_over_figure(found: HeatOver) -> Figure:
    """Draw temperatures, power and, of sets, preload over a field, one below the other.

    Parameters
    ----------
    found
        What `rolamento.studies.heat_curves.heat_over` gives.
    """
    charts = [
        _temperatures(found),
        _lines(found, {called("power"): found.power}, "W", capitalised(called("power"))),
    ]
    if found.has_preload:
        preloads = {said("cold"): found.cold_preload, said("warm"): found.warm_preload}
        charts.append(_lines(found, preloads, "N", said("Preload")))
    if not np.isfinite(found.power).any():
        charts = [nothing(no_result())] * len(charts)
    drawn = (partial(draw, one, legend=len(one.lines) > 1) for one in charts)
    return panels(*drawn, title=found.case.title, height=60.0 * len(charts))


def _temperatures(found: HeatOver) -> Chart:
    x = read_values(found.field, found.values)[0]
    lines = (
        Line(x, values - ZERO_CELSIUS, said(PLACE_NAMES[node]), series_look(index))
        for index, (node, values) in enumerate(zip(NODES, found.temperatures, strict=True))
    )
    across = field_axis(found.field, found.values)
    return Chart(tuple(lines), across, Axis(name=said("Temperature"), unit="°C"))


def _lines(found: HeatOver, lines: dict[str, FloatArray], unit: str, name: str) -> Chart:
    x = read_values(found.field, found.values)[0]
    read = readable_unit(unit, np.concatenate(list(lines.values())))
    drawn = (Line(x, read.of(values), label, series_look(index))
             for index, (label, values) in enumerate(lines.items()))  # fmt: skip
    upright = Axis(name, read.symbol, zero=True)
    return Chart(tuple(drawn), field_axis(found.field, found.values), upright)


def heat_time_figure(courses: Sequence[tuple[str, HeatTransient]]) -> Figure:
    """Draw temperatures, power and, of sets, preload in time, one below the other.

    Parameters
    ----------
    courses
        A name, and what `rolamento.heat.heat_transient` gives; of several only the warmest part's
        temperature is drawn.
    """
    longest = max(float(found.time[-1]) for _, found in courses)
    scale, unit = (3600.0, "h") if longest > _HOURS else (60.0, "min")
    across = Axis(name=said("Time"), unit=unit, limits=(0.0, longest / scale))

    def chart(values: Sequence[tuple[str, FloatArray, FloatArray]], upright: Axis) -> Chart:
        lines = (Line(time / scale, own, label, series_look(index))
                 for index, (label, time, own) in enumerate(values))  # fmt: skip
        return Chart(tuple(lines), across, upright)

    def course(unit: str, name: str, values: list[FloatArray]) -> Chart:
        read = readable_unit(unit, np.concatenate(values))
        named = zip(courses, values, strict=True)
        lines = [(label, found.time, read.of(own)) for (label, found), own in named]
        return chart(lines, Axis(name=name, unit=read.symbol, zero=True))

    alone = courses[0][1]
    warmest = [(label, found.time, found.temperatures.max(axis=0) - ZERO_CELSIUS)
               for label, found in courses]  # fmt: skip
    nodes = [(said(PLACE_NAMES[node]), alone.time, values - ZERO_CELSIUS)
             for node, values in zip(NODES, alone.temperatures, strict=True)]  # fmt: skip
    charts = [
        chart(warmest, Axis(name=said("Warmest part"), unit="°C"))
        if len(courses) > 1
        else chart(nodes, Axis(name=said("Temperature"), unit="°C")),
        course("W", capitalised(called("power")), [found.power for _, found in courses]),
    ]
    if any(found.has_preload for _, found in courses):
        preloads = [found.preload for _, found in courses]
        read = readable_unit("N", np.concatenate(preloads))
        peaks = [found.largest_preload for _, found in courses if found.has_preload]
        largest, when = map(np.array, zip(*peaks, strict=True))
        peak = Line(when / scale, read.of(largest), "", Look("ink"), "points")
        shown = course("N", said("Preload"), preloads)
        charts.append(replace(shown, series=(*shown.series, peak)))
    drawn = (partial(draw, one, legend=one is charts[0]) for one in charts)
    return panels(*drawn, title=alone.case.title, height=60.0 * len(charts))


def heat_variants_figure(variants: Sequence[HeatVariant]) -> Figure:
    """Draw friction and the heat that is removed of each variant, with the state where they cross.

    Parameters
    ----------
    variants
        What `rolamento.heat.answers.variants_of` gives.
    """
    title = variants[0].balance.case.title
    return figure(variants_chart(variants), title=title, height=95.0)


def variants_chart(variants: Sequence[HeatVariant]) -> Chart:
    """Return the friction of each variant, and the heat that the first removes."""
    lines: list[Line] = []
    across = Axis(name=said("Temperature of the warmest part"), unit="°C")
    for index, one in enumerate(variants):
        curve = one.balance.curve
        if not np.isfinite(curve.friction).any():
            continue
        warm = curve.temperatures.max(axis=0) - ZERO_CELSIUS
        name = said(VARIANT_NAMES[one.name])
        lines.append(Line(warm, curve.friction, name, series_look(index)))
        if index == 0:
            across, grey = _warmest(warm), Look("grey", width=0.7)
            lines.append(Line(warm, curve.power, said("heat removed"), grey))
        if one.balance.root is not None:
            hottest = max(one.balance.temperatures.values()) - ZERO_CELSIUS
            point = np.array([hottest]), np.array([one.balance.power])
            lines.append(Line(*point, "", Look("ink"), "points"))
    return Chart(tuple(lines), across, Axis(name=said("Power"), unit="W", zero=True))


def machine_heat_figure(found: MachineHeat) -> Figure:
    """Draw the temperatures of all nodes of the bearings of a machine, beside each other.

    Parameters
    ----------
    found
        What `rolamento.heat.machine.machine_heat` gives.
    """
    tall = 46.0 + 24.0 * len(found.bearings)
    return figure(nodes_chart(found), title=found.machine.title, height=tall)


def nodes_chart(found: MachineHeat) -> Chart:
    """Return the temperatures of the nodes of bearings as bars."""
    if not np.isfinite(found.temperatures).all():
        return nothing(no_result())
    places = tuple(range(len(found.bearings)))
    bars = (
        Bars(found.temperatures[:, index] - ZERO_CELSIUS, places, said(PLACE_NAMES[node]),
             series_look(index))
        for index, node in enumerate(NODES)
    )  # fmt: skip
    across = Axis(name=said("Temperature"), unit="°C", zero=True)
    return Chart(tuple(bars), across, Axis(categories=tuple(found.bearings)))
