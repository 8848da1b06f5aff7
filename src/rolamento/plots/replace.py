"""Keep or replace: what is left of a life, what replacing at an age costs, failures of a fleet."""

from __future__ import annotations

from math import isfinite
from typing import TYPE_CHECKING, Final

import numpy as np
from matplotlib.figure import Figure

from rolamento.charts import Axis, Chart, Line, Look, Mark, Spread, Zone, series_look
from rolamento.charts.drawing import figure
from rolamento.charts.texts import number, shown_text
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.weibull.fleet import FleetForecast
    from rolamento.weibull.replacement import AgeReplacement
    from rolamento.weibull.residual import RemainingLife

__all__ = ["ages_chart", "cost_of_ages_figure", "failures_chart", "fleet_failures_figure",
           "remaining_chart", "remaining_life_figure"]  # fmt: skip

_HEIGHT: Final = 92.0
_POINTS: Final = 120
_DRAWN_POINTS: Final = 40
_LONGEST_UNIT: Final = 12
_FIRST, _SECOND = series_look(0), series_look(1)
_POINT: Final = Look("ink", width=0.75)


def remaining_life_figure(found: RemainingLife) -> Figure:
    """Draw the chance of running on, as `remaining_chart` has it."""
    return figure(remaining_chart(found), height=_HEIGHT)


def remaining_chart(found: RemainingLife) -> Chart:
    """Return the chance of running on over the time to come, beside that of a new bearing.

    Parameters
    ----------
    found
        Of `rolamento.weibull.residual.remaining_life`.
    """
    from rolamento.weibull.residual import conditional_reliability

    law, unit = found.distribution, shown_text(found.distribution.unit, _LONGEST_UNIT)
    asked = isfinite(found.mission)
    longest = max(2.0 * found.median.value, 1.5 * found.mission if asked else 0.0)
    fine, coarse = (np.linspace(0.0, longest, many) for many in (_POINTS, _DRAWN_POINTS))
    known = conditional_reliability(law.shape, law.scale, found.age, fine)
    value = known if law.uncertain else found.curve(fine)[0]
    label = said("has run {age} {unit}", age=number(found.age), unit=unit)
    series: list[Line | Spread] = [Line(fine, 100.0 * value, label, _FIRST)]
    if law.uncertain:
        _, low, high = found.curve(coarse)
        sure = said("{confidence:.3 [%]} % confidence", confidence=found.confidence)
        series.append(Spread(coarse, 100.0 * low, 100.0 * high, sure, _FIRST))
    new = conditional_reliability(law.shape, law.scale, 0.0, fine)
    series.append(Line(fine, 100.0 * new, said("new"), _SECOND))
    marks: tuple[Mark, ...] = ()
    median = said("{age} {unit}", age=number(found.median.value, 3), unit=unit)
    conclusion = f"{median}: {number(50.0)} %"
    if asked:
        chance = 100.0 * found.reliability.value
        marks = (Mark(found.mission, "", Look("grey", width=0.65), "x"),)
        series.append(Line(np.array([found.mission]), np.array([chance]), "", _POINT, "points"))
        conclusion = f"{number(found.mission)} {unit}: {number(chance, 3)} %"
    return Chart(
        tuple(series),
        Axis(limits=(0.0, longest), name=said("Time from now"), unit=unit),
        Axis(limits=(0.0, 101.0), name=said("Probability of running on"), unit="%"),
        conclusion,
        marks=marks,
    )


def cost_of_ages_figure(found: AgeReplacement, currency: str = "") -> Figure:
    """Draw what replacing at an age costs, as `ages_chart` has it."""
    return figure(ages_chart(found, currency), height=_HEIGHT)


def ages_chart(found: AgeReplacement, currency: str = "") -> Chart:
    """Return the cost per 1000 units of time over the age of replacement.

    Parameters
    ----------
    found
        Of `rolamento.weibull.replacement.age_replacement`.
    currency
        Label of the costs.
    """
    from rolamento.weibull.replacement import cost_rate

    law, unit = found.distribution, shown_text(found.distribution.unit, _LONGEST_UNIT)
    middle = found.age.value if found.worthwhile else 0.6 * law.scale
    longest = max(3.0 * middle, 1.3 * law.scale if law.scale < 6.0 * middle else 0.0)
    ages = np.geomspace(0.08 * middle, longest, 4 * _POINTS)
    costs = 1000.0 * cost_rate(ages, law.shape, law.scale, found.planned, found.failure)
    never = 1000.0 * found.cost_on_failure
    series = [Line(ages, costs, said("replaced at an age"), _FIRST)]
    zones: tuple[Zone, ...] = ()
    if found.worthwhile:
        zones = (Zone(*found.near, said("at most 5 % above the least"), _FIRST.color, "x"),)
        best = said("{age} {unit}", age=number(found.age.value), unit=unit)
        point = np.array([found.age.value]), np.array([1000.0 * found.cost])
        series.append(Line(*point, best, _POINT, "points"))
    money = shown_text(currency, _LONGEST_UNIT)
    upright = (
        said("Cost per 1000 {unit} ({currency})", unit=unit, currency=money) if money
        else said("Cost per 1000 {unit}", unit=unit)
    )  # fmt: skip
    top = 1.25 * max(never, *costs[ages >= 0.5 * middle].tolist())
    return Chart(
        tuple(series),
        Axis(limits=(0.0, longest), name=said("Age of replacement"), unit=unit),
        Axis(limits=(0.0, top), label=upright),
        f"{series[-1].name if found.worthwhile else said('replaced on failure')}: "
        f"{number(1000.0 * found.cost if found.worthwhile else never, 3)} {money}".rstrip(),
        marks=(Mark(never, said("replaced on failure"), _SECOND),),
        zones=zones,
    )


def fleet_failures_figure(found: FleetForecast) -> Figure:
    """Draw the failures of a fleet, as `failures_chart` has them."""
    return figure(failures_chart(found), height=_HEIGHT)


def failures_chart(found: FleetForecast) -> Chart:
    """Return cumulated failures of a fleet over the time to come, with their prediction.

    Parameters
    ----------
    found
        Of `rolamento.weibull.fleet.fleet_forecast`.
    """
    ahead = found.fleet.ahead
    alike = bool(np.ptp(ahead) == 0.0)
    scale = float(ahead[0]) if alike else 100.0
    x = scale * np.array([0.0, *(step.part for step in found.steps)])
    low, mean, high = (
        np.array([0.0, *(getattr(step, name) for step in found.steps)])
        for name in ("lower", "expected", "upper")
    )
    steps = np.repeat(x, 2)[:-1]
    sure = said("{confidence:.3 [%]} % prediction", confidence=found.confidence)
    unit = shown_text(found.distribution.unit, _LONGEST_UNIT)
    across = said("Time from now ({unit})", unit=unit) if alike else said("Part of the time (%)")
    return Chart(
        (Spread(steps, np.repeat(low, 2)[1:], np.repeat(high, 2)[1:], sure, _FIRST),
         Line(x, mean, said("expected"), _FIRST)),
        Axis(limits=(0.0, float(x[-1]) or 1.0), label=across),
        Axis(limits=(0.0, 1.1 * max(float(high[-1]), 1.0)), label=said("Failures")),
        f"{number(float(x[-1]))} {unit if alike else '%'}: {number(float(mean[-1]), 3)}",
    )  # fmt: skip
