"""The page of `service-life`: what ends a bearing first, and everything else on one time line."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite, isinf
from typing import TYPE_CHECKING

from rolamento import document as doc
from rolamento import plots
from rolamento.pages.given import case_page, head
from rolamento.pages.notes import cautions, remarks_of
from rolamento.units import HOUR
from rolamento.words import said
from rolamento.words.naming import listed
from rolamento.words.sentences.service_life import BASES, ENDING_NAMES

if TYPE_CHECKING:
    from rolamento.tasks.endings import Ending
    from rolamento.tasks.time_line import ServiceLife

__all__ = ["endings_section", "service_life_page", "service_life_statement", "time_line"]

_HOURS = ".2r [h]"


def service_life_page(found: ServiceLife) -> doc.Document:
    """Return what ends a case first, all endings side by side, and their time line.

    Parameters
    ----------
    found
        What `rolamento.tasks.service_life` gives.
    """
    solved = found.solved
    notes = (*found.notes, *solved.notes[0])
    blocks = (*service_life_statement(found), *cautions(notes))
    sections = [doc.Section(said("What ends it first"), blocks, "first")]
    if found.endings:
        sections += [endings_section(found), doc.Section("", (time_line(found),), "figure")]
    remarks = remarks_of(notes)
    return case_page(
        solved.case, head(solved), sections, "service_life", "endings", remarks=remarks
    )


def time_line(found: ServiceLife) -> doc.Figure:
    """Return the picture of all endings on one time line."""
    return doc.Figure(
        said("What ends it, on one time line"),
        lambda: plots.service_life_figure(found),
        "service_life",
    )


def service_life_statement(found: ServiceLife) -> Iterator[doc.Block]:
    """Yield what ends it first and when, what may come before it, and what is not known."""
    first = found.first
    if not found.converged:
        yield doc.Statement(
            said("There is no result, and nothing to say of its end."), "bad-strong"
        )
        return
    if first is None:
        yield doc.Statement(said("Nothing says when this bearing ends."), "warning", indent=2)
    else:
        yield doc.Statement(_first(first), "strong", indent=2)
    if first is not None and found.rivals:
        names = listed([said(ENDING_NAMES[one.name]) for one in found.rivals])
        text = said("Within the spread another may come before it: {names}.", names=names)
        yield doc.Statement(text, indent=2)
    if found.unknown:
        names = listed([said(ENDING_NAMES[one.name]) for one in found.unknown])
        yield doc.Statement(said("Not known: {names}.", names=names), "warning", indent=2)
    for one in found.endings:
        if one.kind == "upkeep" and one.known:
            text = said(
                "Relubricate every {hours:.2r h} ({low:.2r [h]} to {high:.2r h}); without it the"
                " grease ends it.",
                hours=HOUR * one.hours,
                low=HOUR * one.low,
                high=HOUR * one.high,
            )
            yield doc.Statement(text, indent=2)
    yield from _required(found)


def _first(first: Ending) -> str:
    name = said(ENDING_NAMES[first.name])
    values = {"hours": HOUR * first.hours, "low": HOUR * first.low, "high": HOUR * first.high}
    if first.acting:
        return said("First comes {name}: no law says when, and it is at work.", name=name)
    if first.hours == 0.0:
        return said("It ends at once: {name}.", name=name)
    if isinf(first.hours):
        return said("Nothing that is known ends it: {name} never does.", name=name)
    if first.bound:
        return said("First comes {name}, after less than {hours:.2r h}.", name=name, **values)
    return said(
        "First comes {name}: 90 % of such bearings reach {hours:.2r h} ({low:.2r [h]} to"
        " {high:.2r h}).",
        name=name,
        **values,
    )


def _required(found: ServiceLife) -> Iterator[doc.Block]:
    if found.required is None:
        return
    required = HOUR * found.required
    reaches = found.reaches_required
    if reaches is None:
        text = said("Whether it reaches the required {required:.4 h} is open.", required=required)
        yield doc.Statement(text, "warning", indent=2)
    elif reaches:
        text = said("It reaches the required {required:.4 h}.", required=required)
        yield doc.Statement(text, "good", indent=2)
    else:
        text = said("It does not reach the required {required:.4 h}.", required=required)
        yield doc.Statement(text, "bad-strong", indent=2)


def endings_section(found: ServiceLife) -> doc.Section:
    """Return all endings side by side: when, from when to when, and what the hours are."""
    ordered = found.endings
    tones: list[doc.Tone] = ["strong" if one is found.first else "" for one in ordered]
    columns = [
        doc.Column(
            "", ["▸" if one is found.first else "" for one in ordered], "first", tone="good-strong"
        ),
        doc.Column("", [said(ENDING_NAMES[one.name]) for one in ordered], "ending", tones=tones),
    ]
    for key, text in (("hours", said("10 %")), ("low", said("from")), ("high", said("to"))):
        values: list[doc.CellContent] = [_hours(getattr(one, key)) for one in ordered]
        columns.append(doc.Column(text, values, key, "h", align="right", tones=tones))
    columns.append(
        doc.Column(
            "",
            [said(BASES[one.basis]) if one.basis else "" for one in ordered],
            "basis",
            tone="faint",
        )
    )
    legend = said(
        "10 % of such bearings have ended by then; from 1 % to half of them, by all laws together"
    )
    table = doc.Table(tuple(columns), "endings", legends=(legend,), rule=True, fixed=2)
    return doc.Section(said("All endings"), (table,), "endings")


def _hours(value: float) -> doc.Number:
    return doc.Number(HOUR * value if isfinite(value) else value, _HOURS)
