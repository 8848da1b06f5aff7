"""Keep or replace: what is left of a life, what replacing at an age costs, failures of a fleet."""

from __future__ import annotations

from math import isfinite
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts.frame import GREY, label_x, label_y, legend_above, panels
from rolamento.charts.style import INNER, OUTER, new_figure, styled
from rolamento.charts.texts import number, shown_text
from rolamento.words import said

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rolamento.weibull.fleet import FleetForecast
    from rolamento.weibull.replacement import AgeReplacement
    from rolamento.weibull.residual import RemainingLife

__all__ = ["cost_of_ages", "cost_of_ages_figure", "fleet_failures", "fleet_failures_figure",
           "remaining_life_curve", "remaining_life_figure"]  # fmt: skip

_HEIGHT: Final = 92.0
_POINTS: Final = 120
_DRAWN_POINTS: Final = 40
_LONGEST_UNIT: Final = 12


def remaining_life_figure(found: RemainingLife) -> Figure:
    """Draw the chance of running on, as `remaining_life_curve`, on a figure of its own."""
    return panels(lambda axes: remaining_life_curve(found, axes), height=_HEIGHT)


def remaining_life_curve(found: RemainingLife, axes: Axes | None = None) -> Axes:
    """Draw the chance of running on over the time to come, beside that of a new bearing.

    Parameters
    ----------
    found
        Of `rolamento.weibull.residual.remaining_life`.
    axes
        To draw on; of a new figure if not given.
    """
    from rolamento.weibull.residual import conditional_reliability

    with styled():
        axes = new_figure(height=_HEIGHT)[1] if axes is None else axes
        law, unit = found.distribution, shown_text(found.distribution.unit, _LONGEST_UNIT)
        longest = max(
            2.0 * found.median.value, 1.5 * found.mission if isfinite(found.mission) else 0.0
        )
        fine, coarse = (np.linspace(0.0, longest, many) for many in (_POINTS, _DRAWN_POINTS))
        value, _, _ = found.curve(fine) if not law.uncertain else (
            conditional_reliability(law.shape, law.scale, found.age, fine), None, None
        )  # fmt: skip
        label = said("has run {age} {unit}", age=number(found.age), unit=unit)
        axes.plot(fine, 100.0 * value, **INNER.keywords(), label=label)
        if law.uncertain:
            _, low, high = found.curve(coarse)
            axes.fill_between(
                coarse, 100.0 * low, 100.0 * high, color=INNER.color, alpha=0.15, linewidth=0.0,
                label=said("{confidence:.3 [%]} % confidence", confidence=found.confidence),
            )  # fmt: skip
        new = conditional_reliability(law.shape, law.scale, 0.0, fine)
        axes.plot(fine, 100.0 * new, **OUTER.keywords(), label=said("new"))
        if isfinite(found.mission):
            axes.axvline(found.mission, color=GREY, linewidth=0.9)
            axes.plot([found.mission], [100.0 * found.reliability.value], marker="o",
                      color="black", zorder=4.0)  # fmt: skip
        label_x(axes, said("Time from now ({unit})", unit=unit))
        label_y(axes, said("Probability of running on (%)"))
        axes.set_xlim(0.0, longest)
        axes.set_ylim(0.0, 101.0)
        legend_above(axes)
    return axes


def cost_of_ages_figure(found: AgeReplacement, currency: str = "") -> Figure:
    """Draw what replacing at an age costs, as `cost_of_ages`, on a figure of its own."""
    return panels(lambda axes: cost_of_ages(found, axes, currency=currency), height=_HEIGHT)


def cost_of_ages(found: AgeReplacement, axes: Axes | None = None, *, currency: str = "") -> Axes:
    """Draw the cost per 1000 units of time over the age of replacement.

    Parameters
    ----------
    found
        Of `rolamento.weibull.replacement.age_replacement`.
    axes
        To draw on; of a new figure if not given.
    currency
        Label of the costs.
    """
    from rolamento.weibull.replacement import cost_rate

    with styled():
        axes = new_figure(height=_HEIGHT)[1] if axes is None else axes
        law, unit = found.distribution, shown_text(found.distribution.unit, _LONGEST_UNIT)
        middle = found.age.value if found.worthwhile else 0.6 * law.scale
        longest = max(3.0 * middle, 1.3 * law.scale if law.scale < 6.0 * middle else 0.0)
        ages = np.geomspace(0.08 * middle, longest, 4 * _POINTS)
        costs = 1000.0 * cost_rate(ages, law.shape, law.scale, found.planned, found.failure)
        axes.plot(ages, costs, **INNER.keywords(), label=said("replaced at an age"))
        never = 1000.0 * found.cost_on_failure
        axes.axhline(never, color=OUTER.color, linestyle="--", label=said("replaced on failure"))
        if found.worthwhile:
            axes.axvspan(found.near[0], min(found.near[1], longest), color=INNER.color, alpha=0.12,
                         linewidth=0.0, label=said("at most 5 % above the least"))  # fmt: skip
            label = said("{age} {unit}", age=number(found.age.value), unit=unit)
            axes.plot([found.age.value], [1000.0 * found.cost], marker="o", color="black",
                      linestyle="", zorder=4.0, label=label)  # fmt: skip
        label_x(axes, said("Age of replacement ({unit})", unit=unit))
        money = shown_text(currency, _LONGEST_UNIT)
        label_y(
            axes,
            said("Cost per 1000 {unit} ({currency})", unit=unit, currency=money)
            if money
            else said("Cost per 1000 {unit}", unit=unit),
        )
        axes.set_xlim(0.0, longest)
        axes.set_ylim(0.0, 1.25 * max(never, *costs[ages >= 0.5 * middle].tolist()))
        legend_above(axes)
    return axes


def fleet_failures_figure(found: FleetForecast) -> Figure:
    """Draw the failures of a fleet, as `fleet_failures`, on a figure of its own."""
    return panels(lambda axes: fleet_failures(found, axes), height=_HEIGHT)


def fleet_failures(found: FleetForecast, axes: Axes | None = None) -> Axes:
    """Draw cumulated failures of a fleet over the time to come, with their prediction.

    Parameters
    ----------
    found
        Of `rolamento.weibull.fleet.fleet_forecast`.
    axes
        To draw on; of a new figure if not given.
    """
    with styled():
        axes = new_figure(height=_HEIGHT)[1] if axes is None else axes
        ahead = found.fleet.ahead
        alike = bool(np.ptp(ahead) == 0.0)
        scale = float(ahead[0]) if alike else 100.0
        x = scale * np.array([0.0, *(step.part for step in found.steps)])
        low, mean, high = (
            np.array([0.0, *(getattr(step, name) for step in found.steps)])
            for name in ("lower", "expected", "upper")
        )
        axes.fill_between(
            x, low, high, step="pre", color=INNER.color, alpha=0.18, linewidth=0.0,
            label=said("{confidence:.3 [%]} % prediction", confidence=found.confidence),
        )  # fmt: skip
        axes.plot(x, mean, **INNER.keywords(), label=said("expected"))
        unit = shown_text(found.distribution.unit, _LONGEST_UNIT)
        label_x(
            axes,
            said("Time from now ({unit})", unit=unit) if alike else said("Part of the time (%)"),
        )
        label_y(axes, said("Failures"))
        axes.set_xlim(0.0, float(x[-1]) or 1.0)
        axes.set_ylim(0.0, 1.1 * max(float(high[-1]), 1.0))
        legend_above(axes)
    return axes
