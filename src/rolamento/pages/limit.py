"""When something that grows reaches a limit: the section that several pages share."""

from __future__ import annotations

from collections.abc import Sequence
from math import expm1, isfinite
from typing import TYPE_CHECKING

from rolamento.document import Column, Number, Section, Statement, Table, Tone
from rolamento.words import ABSENT, ENDLESS, manner, said

if TYPE_CHECKING:
    from rolamento.numerics.growth import Crossing, Forecast, Growth

__all__ = ["limit_section", "limit_statement"]


def limit_statement(found: Forecast, name: str, unit: str, time_unit: str) -> Statement:
    """Return when the limit is reached, in a sentence.

    Parameters
    ----------
    found
        Of `rolamento.numerics.growth.forecast`.
    name
        Of what is measured, or of whom; empty for the only one.
    unit, time_unit
        Of values and times.
    """
    crossing, growth = found.crossing, found.growth
    values = {
        "limit": crossing.limit,
        "unit": unit,
        "time_unit": time_unit,
        "confidence": crossing.confidence,
        "p": growth.p_value,
    }
    tone: Tone = "warning-strong"
    if crossing.code == "reached":
        last = growth.last_time
        text = said(
            "The limit of {limit:.4} {unit} is reached in {left:.3} {time_unit}"
            " ({confidence:.3 [%]} % interval: {lower:.3} to {upper:.3} {time_unit}), if the growth"
            " continues as measured.",
            left=crossing.time - last,
            lower=crossing.lower - last,
            upper=crossing.upper - last,
            **values,
        )
    elif crossing.code == "exceeded":
        tone = "bad-strong"
        text = said("The limit of {limit:.4} {unit} has been reached already.", **values)
    elif crossing.code == "falling":
        tone = "good"
        text = said(
            "The values do not grow: the limit of {limit:.4} {unit} is not reached.", **values
        )
    elif crossing.code == "no_trend":
        tone = "faint"
        text = said(
            "No significant growth (p = {p:.2}): a time to the limit of {limit:.4} {unit} cannot be"
            " stated, and may be never.",
            **values,
        )
    else:
        tone = "faint"
        text = said(
            "At least three different times are needed for a time to the limit of {limit:.4}"
            " {unit}.",
            **values,
        )
    if name:
        text = said("{name}: {text}", name=name, text=text)
    return Statement(text, tone)


def limit_section(found: Sequence[tuple[str, Forecast]], unit: str, time_unit: str) -> Section:
    """Return the section on the time to a limit: a sentence and two laws of each.

    Parameters
    ----------
    found
        Names, and what `rolamento.numerics.growth.forecast` found.
    unit, time_unit
        Of values and times.
    """
    rows: list[tuple[str, Growth, Crossing, bool]] = []
    for name, one in found:
        for place, (growth, crossing) in enumerate(zip(one.growths, one.crossings, strict=True)):
            rows.append((name, growth, crossing, place == one.chosen))
    named = any(name for name, *_ in rows)
    laws = {"linear": said("linear"), "exponential": said("exponential")}
    columns = [
        *([Column(head="", values=[name for name, *_ in rows], key="name", once=True)] * named),
        Column(
            head=said("law"),
            values=[laws[growth.law] + (" ←" if chosen else "") for _, growth, _, chosen in rows],
            key="law",
        ),
        Column(
            head=said("growth per 1000 {unit}", unit=time_unit),
            values=[_growth(growth, unit) for _, growth, *_ in rows],
            key="growth",
            align="right",
        ),
        Column(
            head="p",
            values=[Number(growth.p_value, ".2") for _, growth, *_ in rows],
            key="p_value",
        ),
        Column(
            head=said("reached at {unit}", unit=time_unit),
            values=[_time(crossing.time) for _, _, crossing, _ in rows],
            key="time",
            align="right",
        ),
        Column(
            head=said("from"),
            values=[_time(crossing.lower) for _, _, crossing, _ in rows],
            key="lower",
            align="right",
        ),
        Column(
            head=said("to"),
            values=[_time(crossing.upper) for _, _, crossing, _ in rows],
            key="upper",
            align="right",
        ),
    ]
    legend = said(
        "Least squares; ← the likelier law, or the one asked for. p: probability of such a slope"
        " without growth (one-sided, Student's t). From–to: where the line may reach the limit"
        " (Fieller's theorem); individual measurements scatter around it. The laws describe what"
        " was measured; damage may grow faster."
    )
    table = Table(columns=tuple(columns), key="limit", legends=(legend,))
    statements = tuple(limit_statement(one, name, unit, time_unit) for name, one in found)
    return Section(said("Time to the limit"), (*statements, table), key="limit")


def _growth(growth: Growth, unit: str) -> str:
    if not isfinite(growth.slope):
        return ABSENT
    if growth.law == "exponential":
        return said("{part:.3 [%]} %", part=expm1(min(1000.0 * growth.slope, 50.0)))
    return said("{value:.3} {unit}", value=1000.0 * growth.slope, unit=unit)


def _time(value: float) -> str:
    if value == float("inf"):
        return ENDLESS
    return manner().number(value, ".4") if isfinite(value) else ABSENT
