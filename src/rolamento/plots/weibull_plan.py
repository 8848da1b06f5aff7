"""Planned life tests: the chance of passing one, and what equally precise ones cost."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts import Axis, Chart, Labels, Line, Look, Mark, nothing, series_look
from rolamento.charts.drawing import figure
from rolamento.charts.record import Side
from rolamento.charts.texts import no_result, number, shown_text
from rolamento.words import counted, said

if TYPE_CHECKING:
    from rolamento.weibull import Demonstration, LifeTestPlan

__all__ = ["chance_chart", "chance_figure", "cost_chart", "cost_figure"]

_RATIOS: Final = (0.3, 20.0)
_POINTS: Final = 300
_HEIGHT: Final = 95.0
_ASIDE: Final = 0.006
"""Part of the axis by which the schemes stand beside each other."""


def chance_figure(plans: Sequence[Demonstration], unit: str) -> Figure:
    """Draw chances of passing, as `chance_chart` has them, on a figure of their own."""
    return figure(chance_chart(plans, unit), height=_HEIGHT)


def chance_chart(plans: Sequence[Demonstration], unit: str) -> Chart:
    """Return the chance of passing over the true life, one line a test.

    Parameters
    ----------
    plans
        Of `rolamento.weibull.planning.demonstrate`; those without a plan are left out.
    unit
        Of their times.
    """
    planned = [plan for plan in plans if plan.planned]
    if not planned:
        return nothing(no_result())
    ratio = np.geomspace(*_RATIOS, _POINTS)
    names = [
        counted(
            "{bearings} × {time} {unit}, {n} failure allowed",
            "{bearings} × {time} {unit}, {n} failures allowed",
            plan.failures_allowed,
            bearings=plan.bearings,
            time=number(plan.time),
            unit=shown_text(unit, 12),
        )
        for plan in planned
    ]
    lines = (
        Line(ratio, 100.0 * plan.chance_of_passing(ratio), name, series_look(index))
        for index, (plan, name) in enumerate(zip(planned, names, strict=True))
    )
    exactly = Mark(1.0, said("exactly the required life"), Look("grey", width=0.65), "x")
    return Chart(
        tuple(lines),
        Axis(limits=_RATIOS, log=True, label=said("True life/required life")),
        Axis(limits=(0.0, 100.0), name=said("Probability of passing"), unit="%"),
        said(
            "bearings of just the required life pass in {exactly}, of twice the life in {twice}",
            exactly=_chances(planned, 1.0),
            twice=_chances(planned, 2.0),
        ),
        marks=(exactly,),
    )


def _chances(plans: Sequence[Demonstration], ratio: float) -> str:
    """The chances that bearings of some multiple of the required life pass."""
    found = [float(plan.chance_of_passing(np.array([ratio]))[0]) for plan in plans]
    return ", ".join(dict.fromkeys(f"{number(100.0 * one, 3)} %" for one in found))


def cost_figure(plans: Sequence[LifeTestPlan], unit: str) -> Figure:
    """Draw what tests cost, as `cost_chart` has it, with a title."""
    title = said("Tests of equal precision")
    return figure(cost_chart(plans, unit), title=title, height=_HEIGHT + 10.0)


def cost_chart(plans: Sequence[LifeTestPlan], unit: str) -> Chart:
    """Return the duration of tests over the bearings that they take.

    Parameters
    ----------
    plans
        Of `rolamento.weibull.precision.plans_for_ratio`; those without a plan are left out.
    unit
        Of their times.
    """
    planned = [plan for plan in plans if plan.planned]
    if not planned:
        return nothing(no_result())
    most = max(plan.bearings for plan in planned)
    names = {"complete": said("all fail"), "type_ii": said("stopped earlier"),
             "sudden_death": said("sudden death")}  # fmt: skip
    series: list[Line | Labels] = []
    for index, (scheme, name) in enumerate(names.items()):
        own = [plan for plan in planned if plan.scheme == scheme]
        if own:  # beside each other where they take as many bearings
            series += _scheme(own, index, name, _ASIDE * most * (index - 1))
    ends = [plan.duration for plan in planned if plan.duration is not None]
    soonest = min(planned, key=lambda plan: plan.duration.mean if plan.duration else np.inf)
    lowest, highest = min(end.lower for end in ends), max(end.upper for end in ends)
    return Chart(
        tuple(series),
        Axis(limits=(0.0, 1.1 * most), label=said("Bearings")),
        Axis(limits=(lowest / 1.3, highest * 1.3), log=True,
             name=said("Duration"), unit=shown_text(unit, 12)),
        said(
            "soonest done: {name}, {bearings} bearings, {time} {unit}",
            name=names[soonest.scheme], bearings=soonest.bearings, unit=shown_text(unit, 12),
            time=number(soonest.duration.mean if soonest.duration else lowest, 3),
        ),
        over_names=said("bars: 90 % of the tests end within; numbers: failures"),
    )  # fmt: skip


def _scheme(
    plans: Sequence[LifeTestPlan], index: int, name: str, aside: float
) -> Iterator[Line | Labels]:
    """Yield the tests of one scheme, joined, with what they may last and their failures."""
    look, ordered = series_look(index), sorted(plans, key=lambda plan: plan.bearings)
    ends = [plan.duration for plan in ordered if plan.duration is not None]
    x, mean = (
        np.array([plan.bearings for plan in ordered]) + aside, np.array([end.mean for end in ends])
    )  # fmt: skip
    bars = np.array([[end.lower, end.upper, np.nan] for end in ends]).ravel()
    yield Line(np.repeat(x, 3), bars, "", Look(look.color, width=0.7))
    yield Line(x, mean, name, replace(look, width=0.7), "both")
    sides: list[Side] = ["right"] * len(ordered)
    texts = tuple(str(plan.failures) for plan in ordered)
    yield Labels(x, mean, texts, tuple(sides), look.color)
