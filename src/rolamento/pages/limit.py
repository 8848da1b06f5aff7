"""When something that grows reaches a limit: the section that several pages share."""

from __future__ import annotations

from collections.abc import Sequence
from math import expm1, isfinite
from typing import TYPE_CHECKING, Final

from rolamento.document import Column, Number, Section, Statement, Table, Tone
from rolamento.io.dates import moment_after
from rolamento.words import ABSENT, ENDLESS, manner, said, said_in

if TYPE_CHECKING:
    from rolamento.numerics.growth import Crossing, Forecast, Growth

__all__ = ["limit_section", "limit_statement"]
_FEW_DAYS: Final = 3.0
"""Length in days of a record, below which growth is shown by the day."""


def limit_statement(
    found: Forecast, name: str, unit: str, time_unit: str, start: str = ""
) -> Statement:
    """Return when the limit is reached, in a sentence.

    Parameters
    ----------
    found
        Of `rolamento.numerics.growth.forecast`.
    name
        Of what is measured, or of whom; empty for the only one.
    unit, time_unit
        Of values and times.
    start
        Date from which the times count as days, if they do.
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
        if start:
            values |= {
                "at": _time(crossing.time, start),
                "first": _time(crossing.lower, start),
                "end": _time(crossing.upper, start),
            }
        text = (
            said(
                "The limit of {limit:.4} {unit} is reached on {at} ({confidence:.3 [%]} % interval:"
                " {first} to {end}), if the growth continues as measured.",
                **values,
            )
            if start
            else said(
                "The limit of {limit:.4} {unit} is reached in {left:.3} {time_unit}"
                " ({confidence:.3 [%]} % interval: {lower:.3} to {upper:.3} {time_unit}), if the"
                " growth continues as measured.",
                left=crossing.time - last,
                lower=crossing.lower - last,
                upper=crossing.upper - last,
                **values,
            )
        )
    elif crossing.code == "exceeded":
        tone = "bad-strong"
        last = growth.last_value
        if last < crossing.limit:
            text = said(
                "The fitted trend has reached the limit of {limit:.4} {unit}; the last reading,"
                " {last:.3} {unit}, has not.",
                last=last,
                **values,
            )
        else:
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


def limit_section(
    found: Sequence[tuple[str, Forecast]],
    unit: str,
    time_unit: str,
    start: str = "",
    *,
    leading: Sequence[Statement] = (),
) -> Section:
    """Return the section on the time to a limit: a sentence and two laws of each.

    Parameters
    ----------
    found
        Names, and what `rolamento.numerics.growth.forecast` found.
    unit, time_unit, start
        Of values and times, as of `limit_statement`.
    leading
        Sentences that stand at the head of the page already.
    """
    rows: list[tuple[str, Growth, Crossing, bool]] = []
    for name, one in found:
        for place, (growth, crossing) in enumerate(zip(one.growths, one.crossings, strict=True)):
            rows.append((name, growth, crossing, place == one.chosen))
    named = any(name for name, *_ in rows)
    span = _span(time_unit, max((growth.last_time for _, growth, *_ in rows), default=0.0))
    laws = {"linear": said("linear"), "exponential": said("exponential")}
    columns = [
        *([Column("", [name for name, *_ in rows], "name", once=True)] * named),
        Column(
            said("law"),
            [laws[growth.law] + (" ←" if chosen else "") for _, growth, _, chosen in rows],
            "law",
        ),
        Column(
            said("growth per {time} {unit}", time=span, unit=time_unit),
            [_growth(growth, unit, span) for _, growth, *_ in rows],
            "growth",
            align="right",
        ),
        Column("p", [Number(growth.p_value, ".2") for _, growth, *_ in rows], "p_value"),
        Column(
            head=said("reached on") if start else said("reached at {unit}", unit=time_unit),
            values=[
                # of one reached already the time is that of the last measurement
                said_in("limit", "already")
                if crossing.code == "exceeded"
                else _time(crossing.time, start)
                for _, _, crossing, _ in rows
            ],
            key="time",
            align="right",
        ),
        Column(
            said("from"),
            [_time(crossing.lower, start) for _, _, crossing, _ in rows],
            "lower",
            align="right",
        ),
        Column(
            said("to"),
            [_time(crossing.upper, start) for _, _, crossing, _ in rows],
            "upper",
            align="right",
        ),
    ]
    legend = said(
        "Least squares; ← the likelier law, or the one asked for. p: probability of such a slope"
        " without growth (one-sided, Student's t). From–to: where the line may reach the limit"
        " (Fieller's theorem); individual measurements scatter around it. The laws describe what"
        " was measured; damage may grow faster."
    )
    table = Table(tuple(columns), "limit", legends=(legend,))
    said_of = [limit_statement(one, name, unit, time_unit, start) for name, one in found]
    statements = [one for one in said_of if one not in leading]
    return Section(said("Time to the limit"), (*statements, table), "limit")


def _span(time_unit: str, longest: float) -> int:
    """Time over which growth is shown: a month of days, a thousand of hours and of all else.

    longest: time of the last measurement; of a few days one day is enough.
    """
    if time_unit.casefold() not in ("d", "day", "days", "dia", "dias"):
        return 1000
    return 30 if longest > _FEW_DAYS else 1


def _growth(growth: Growth, unit: str, span: int) -> str:
    if not isfinite(growth.slope):
        return ABSENT
    if growth.law == "exponential":
        return said("{part:.3 [%]} %", part=expm1(min(span * growth.slope, 50.0)))
    return said("{value:.3} {unit}", value=span * growth.slope, unit=unit)


def _time(value: float, start: str = "") -> str:
    """Write a time; as a date, if the times count as days from one."""
    if value == float("inf"):
        return ENDLESS
    if not isfinite(value):
        return ABSENT
    if not start:
        return manner().number(value, ".4")
    try:
        return moment_after(start, value, to_the_day=True)
    except OverflowError:
        return ENDLESS
