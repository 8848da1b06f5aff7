"""The page of what grew while bearings ran: measurements, and a law of wear."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Final

from rolamento import document as doc
from rolamento import plots
from rolamento.io.dates import moment_after
from rolamento.pages.given import picture
from rolamento.pages.limit import limit_section
from rolamento.units import to_si
from rolamento.words import marked, said
from rolamento.words.naming import one_line, shortened

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Picture

    from rolamento.clearance.wear import WearFit
    from rolamento.tasks.weibull import TrendStudy
    from rolamento.weibull import Trend

__all__ = ["QUANTITIES", "trend_page", "trend_picture"]

_MOST_ROWS: Final = 60
_FIGURES: Final = 3
_REJECTED: Final = "×"

QUANTITIES: Final = {"radial clearance": marked("radial clearance")}
"""What columns of a record are called, of which the name is known."""
_LAWS: Final = {
    "running_in": "P_0 + A (1 − e^(−t/τ))",
    "running_in_and_steady": "P_0 + A (1 − e^(−t/τ)) + w t",
    "power": "P_0 + A (t/t_n)^n",
}


def trend_page(found: TrendStudy) -> doc.Document:
    """Return the page of a record; lengths and times are in the units of the data.

    Parameters
    ----------
    found
        Of `rolamento.tasks.TrendEvaluation`.
    """
    trend = found.trend
    title = one_line(trend.title) or said("Measurements")
    entries = [doc.Entry(said("source"), one_line(trend.source))]
    if trend.start:
        entries.append(doc.Entry(said("days from"), trend.start))
    source = doc.KeyValues(tuple(entries))
    sections = [
        doc.Section(blocks=(doc.Title(title), source), key="head"),
        doc.Section(blocks=(_measurements(trend),), key="measurements"),
    ]
    notes = tuple(doc.Statement(note.text, "faint", indent=2) for note in trend.notes)
    if notes:
        sections.append(doc.Section(blocks=notes))
    if found.fits:
        sections.append(_laws_of_wear(trend, found.fits))
    for place in dict.fromkeys(one.quantity for one in found.limits):
        own = [
            (said("bearing {name}", name=shortened(one_line(one.bearing))) if one.bearing else "",
             one.forecast)
            for one in found.limits
            if one.quantity == place
        ]  # fmt: skip
        sections.append(limit_section(own, trend.units[place], trend.time_unit, trend.start))

    caption = said("Measurements over the running time")
    sections.append(picture(caption, lambda: trend_picture(found), "trend", ""))
    return doc.Document(title, tuple(sections), "trend")


def trend_picture(found: TrendStudy) -> Picture:
    """Draw the record, with its laws and limits."""
    limits = {(one.bearing, one.quantity): one.forecast for one in found.limits}
    figure: Picture = plots.trend_figure(found.trend, found.fits, limits)
    return figure


def _measurements(trend: Trend) -> doc.Table:
    """One line a measurement."""
    places = {name: place for place, name in enumerate(trend.names)}
    order = sorted(
        range(len(trend.times)),
        key=lambda row: (places[str(trend.bearings[row])], float(trend.times[row])),
    )
    shown = order[:_MOST_ROWS]
    bearings = [str(trend.bearings[row]) for row in shown]
    groups = tuple(
        (place, said("bearing {name}", name=shortened(one_line(name))))
        for place, name in enumerate(bearings)
        if name and (not place or name != bearings[place - 1])
    )
    columns = [
        doc.Column(said("bearing"), bearings, "bearing", only_in_files=True),
        *_days(trend, shown),
        doc.Column(
            trend.time_unit, [doc.Number(float(trend.times[row]), ".6") for row in shown], "time"
        ),
    ]
    for place, (name, unit) in enumerate(zip(trend.quantities, trend.units, strict=True)):
        known = said(QUANTITIES[name]) if name in QUANTITIES else name
        columns.append(
            doc.Column(
                f"{shortened(known)} {unit}".rstrip(),
                _cells(trend, shown, place),
                name,
                align="right",
            )
        )
    legends = [said("× rejected")] if trend.rejected.any() else []
    if len(order) > len(shown):
        legends.append(
            said(
                "{count} measurements; the first {shown} are shown.",
                count=len(order),
                shown=len(shown),
            )
        )
    return doc.Table(tuple(columns), "measurements", groups=groups, legends=tuple(legends))


def _days(trend: Trend, rows: Sequence[int]) -> list[doc.Column]:
    """The dates of measurements, if the record has them."""
    if not trend.start:
        return []
    days = [moment_after(trend.start, float(trend.times[row])) for row in rows]
    return [doc.Column(said("date"), days, "date")]


def _cells(trend: Trend, rows: Sequence[int], quantity: int) -> list[doc.CellContent]:
    return [
        _REJECTED
        if trend.rejected[row, quantity]
        else doc.Number(float(trend.values[row, quantity]), ".5")
        for row in rows
    ]


def _laws_of_wear(trend: Trend, fits: Mapping[str, WearFit]) -> doc.Section:
    """One line a bearing: the constants of its law, with their standard errors."""
    length, time = trend.units[0], trend.time_unit
    metre, second = to_si(f"1 {length}", "length"), to_si(f"1 {time}", "time")
    constants = {
        "initial_clearance": (f"P_0 {length}", metre),
        "running_in_wear": (f"A {length}", metre),
        "wear_at_last": (f"A {length}", metre),
        "running_in_time": (f"τ {time}", second),
        "wear_rate": (f"w {length}/1000 {time}", metre / (1000.0 * second)),
        "exponent": ("n", 1.0),
    }
    first = next(iter(fits.values()))
    columns = [
        doc.Column(said("bearing"), [shortened(one_line(bearing)) for bearing in fits], "bearing")
    ]
    for name in first.constants:
        head, scale = constants[name]
        values = [fit.constants[name] / scale for fit in fits.values()]
        errors = [fit.standard_errors[name] / scale for fit in fits.values()]
        for key, shown, numbers, figures in (
            (name, head, values, _FIGURES), (f"{name}_error", "±", errors, 2),
        ):  # fmt: skip
            cells = [doc.Number(value, f".{figures}") for value in numbers]
            columns.append(doc.Column(shown, cells, key))
    columns.append(
        doc.Column(
            said("residual {length}", length=length),
            [doc.Number(fit.residual / metre, ".2") for fit in fits.values()],
            "residual",
        )
    )
    legends = (
        said(
            "± standard error, from the curvature at the best fit; without it, the measurements do"
            " not determine the constant."
        ),
        said(
            "The law describes what was measured. It is not valid beyond the last measurement, nor"
            " for other bearings."
        ),
    )
    table = doc.Table(tuple(columns), "wear", legends=legends)
    return doc.Section(said("Law of wear: {law}", law=_LAWS[first.law]), (table,), "wear")
