"""Planned life tests: the chance of passing one, and what equally precise ones cost."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts.frame import (
    GREY,
    add_title,
    decades,
    empty_frame,
    label_x,
    label_y,
    legend_above,
    panels,
)
from rolamento.charts.style import new_figure, series, styled
from rolamento.charts.texts import no_result, number, shown_text
from rolamento.words import counted, said

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.weibull import Demonstration, LifeTestPlan

__all__ = ["chance_figure", "chance_of_passing", "cost_figure", "cost_of_precision"]

_RATIOS: Final = (0.3, 20.0)
_POINTS: Final = 300
_HEIGHT: Final = 95.0
_ASIDE: Final = 0.006
"""Part of the axis by which the schemes stand beside each other."""


def chance_figure(plans: Sequence[Demonstration], unit: str) -> Figure:
    """Draw chances of passing, as `chance_of_passing`, on a figure of their own."""
    return panels(lambda axes: chance_of_passing(plans, unit, axes), height=_HEIGHT)


def chance_of_passing(plans: Sequence[Demonstration], unit: str, axes: Axes | None = None) -> Axes:
    """Draw the chance of passing over the true life, one line a test.

    Parameters
    ----------
    plans
        Of `rolamento.weibull.planning.demonstrate`; those without a plan are left out.
    unit
        Of their times.
    axes
        To draw on; of a new figure if not given.
    """
    with styled():
        axes = new_figure(height=_HEIGHT)[1] if axes is None else axes
        planned = [plan for plan in plans if plan.planned]
        if not planned:
            return empty_frame(axes, no_result())
        ratio = np.geomspace(*_RATIOS, _POINTS)
        for index, plan in enumerate(planned):
            label = counted(
                "{bearings} × {time} {unit}, {n} failure allowed",
                "{bearings} × {time} {unit}, {n} failures allowed",
                plan.failures_allowed,
                bearings=plan.bearings,
                time=number(plan.time),
                unit=shown_text(unit, 12),
            )
            look = series(index).keywords()
            axes.plot(ratio, 100.0 * plan.chance_of_passing(ratio), label=label, **look)
        axes.axvline(1.0, color=GREY, linewidth=0.9, label=said("exactly the required life"))
        label_x(axes, said("True life/required life"))
        label_y(axes, said("Probability of passing (%)"))
        decades(axes, "x", _RATIOS)
        axes.set_ylim(0.0, 100.0)
        legend_above(axes)
    return axes


def cost_figure(plans: Sequence[LifeTestPlan], unit: str) -> Figure:
    """Draw what tests cost, as `cost_of_precision`, with a title."""
    with styled():
        figure, axes = new_figure(height=_HEIGHT + 10.0)
        cost_of_precision(plans, unit, axes)
        add_title(figure, said("Tests of equal precision"))
    return figure


def cost_of_precision(plans: Sequence[LifeTestPlan], unit: str, axes: Axes | None = None) -> Axes:
    """Draw the duration of tests over the bearings that they take.

    Parameters
    ----------
    plans
        Of `rolamento.weibull.precision.plans_for_ratio`; those without a plan are left out.
    unit
        Of their times.
    axes
        To draw on; of a new figure if not given.
    """
    with styled():
        axes = new_figure(height=_HEIGHT)[1] if axes is None else axes
        planned = [plan for plan in plans if plan.planned]
        if not planned:
            return empty_frame(axes, no_result())
        most = max(plan.bearings for plan in planned)
        for index, (scheme, label) in enumerate(
            (
                ("complete", said("all fail")),
                ("type_ii", said("stopped earlier")),
                ("sudden_death", said("sudden death")),
            )
        ):
            of_scheme = [plan for plan in planned if plan.scheme == scheme]
            if of_scheme:
                # beside each other where they take as many bearings
                _scheme(axes, of_scheme, index, label, _ASIDE * most * (index - 1))
        _axes(axes, planned, unit)
        legend_above(axes, title=said("bars: 90 % of the tests end within; numbers: failures"))
    return axes


def _scheme(
    axes: Axes, plans: Sequence[LifeTestPlan], index: int, label: str, aside: float
) -> None:
    """Draw the tests of one scheme, joined, with what they may last."""
    look = series(index)
    ordered = sorted(plans, key=lambda plan: plan.bearings)
    ends = [plan.duration for plan in ordered if plan.duration is not None]
    bearings = np.array([plan.bearings for plan in ordered]) + aside
    mean = np.array([end.mean for end in ends])
    limits = np.array([[end.lower, end.upper] for end in ends]).T
    axes.errorbar(
        bearings, mean, yerr=[mean - limits[0], limits[1] - mean], color=look.color,
        marker=look.marker, linestyle=look.linestyle, linewidth=1.0, elinewidth=1.0, capsize=2.5,
        label=label, zorder=3.0,
    )  # fmt: skip
    for plan, x, y in zip(ordered, bearings, mean, strict=True):
        axes.annotate(
            str(plan.failures), (float(x), float(y)), (5.0, 4.0), textcoords="offset points",
            fontsize=7.5, color=look.color,
        )  # fmt: skip


def _axes(axes: Axes, plans: Sequence[LifeTestPlan], unit: str) -> None:
    label_x(axes, said("Bearings"))
    label_y(axes, said("Duration ({unit})", unit=shown_text(unit, 12)))
    ends = [plan.duration for plan in plans if plan.duration is not None]
    lowest, highest = min(end.lower for end in ends), max(end.upper for end in ends)
    decades(axes, "y", (lowest / 1.3, highest * 1.3))
    axes.set_xlim(0.0, 1.1 * max(plan.bearings for plan in plans))
