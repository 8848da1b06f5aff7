"""The pages of `heat` in time: how a bearing runs up, and a plan that keeps it below a limit."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento import document as doc
from rolamento import plots
from rolamento.heat import NODES
from rolamento.pages.given import case_page, picture, title_of
from rolamento.pages.notes import remarks_of
from rolamento.words import said
from rolamento.words.quantities import called
from rolamento.words.reasons import reason
from rolamento.words.sentences.heat import PLACE_NAMES

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Picture

    from rolamento.heat import HeatTransient
    from rolamento.tasks.heat import WarmUp

__all__ = ["heat_time_page", "warm_up_figure", "warm_up_page"]

_SHOWN: Final = 14
"""Points of time on the page; files have all."""


def heat_time_page(found: HeatTransient) -> doc.Document:
    """Return how temperatures and preload of a bearing change in time.

    Parameters
    ----------
    found
        What `rolamento.heat.heat_transient` gives.
    """
    return case_page(
        found.case,
        doc.Section("", (doc.Title(title_of(found.case)), *_headline(found)), "head"),
        _course(found),
        "heat_time",
        "course",
        notes=found.notes,
    )


def _headline(found: HeatTransient) -> list[doc.Block]:
    blocks: list[doc.Block] = []
    if not found.converged:
        blocks.append(doc.Statement(reason(found.status), "bad-strong"))
    entries = []
    if found.has_preload:
        largest, when = found.largest_preload
        text = said(
            "{first:.4 [N]} at the start, largest {largest:.4 [N]} after {when:.3 min}, at the end"
            " {last:.4 N}",
            first=float(found.preload[0]),
            largest=largest,
            when=when,
            last=float(found.preload[-1]),
        )
        entries.append(doc.Entry(said("preload"), text))
    at = found.final
    text = said(
        "inner ring {inner:.1f °C}, outer ring {outer:.1f °C}, housing {housing:.1f °C} after"
        " {time:.3 min}",
        inner=at["inner_ring"],
        outer=at["outer_ring"],
        housing=at["housing"],
        time=float(found.time[-1]),
    )
    entries.append(doc.Entry(said("temperatures"), text))
    entries.append(doc.Entry(called("power"), doc.Number(float(found.power[-1]), ".4 W")))
    return [*blocks, doc.KeyValues(tuple(entries))]


def _course(found: HeatTransient) -> list[doc.Section]:
    if len(found) < 2:
        return []
    shown = _moments(found)
    every = np.arange(len(found))
    caption = said("Temperatures, power and preload in time")
    return [
        doc.Section(
            said("In time"),
            (
                doc.Table(_columns(found, shown), "moments", legends=_legends(found)),
                doc.Table(_columns(found, every), "course", only_in_files=True),
            ),
            "course",
        ),
        picture(caption, lambda: plots.heat_time_figure([("", found)]), "course"),
    ]


def _legends(found: HeatTransient) -> tuple[str, ...]:
    legend = said("p maximum pressure; ◂ largest preload") if found.has_preload else ""
    return (legend or said("p maximum pressure"),)


def _moments(found: HeatTransient) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    """Points of time worth a line: evenly in the logarithm, and the worst."""
    time = found.time
    last = float(time[-1])
    wanted = np.geomspace(max(float(time[1]), last / 500.0), last, _SHOWN - 1)
    places = [int(np.argmin(np.abs(time - one))) for one in wanted]
    begins = np.flatnonzero(np.diff(found.speed) != 0.0).tolist()
    kept = {0, found.worst, *places, *(begins if len(begins) < _SHOWN else [])}
    return np.array(sorted(kept), np.int64)


def _columns(
    found: HeatTransient, some: np.ndarray[tuple[int], np.dtype[np.int64]]
) -> tuple[doc.Column, ...]:
    columns = [
        doc.Column(
            said("time"),
            [doc.Number(one, ".3 [min]") for one in found.time[some].tolist()],
            "time",
            "min",
        )
    ]
    if np.ptp(found.speed) > 0.0:
        columns.append(
            doc.Column(said("speed"), found.speed[some].tolist(), "speed_factor", "%", figures=3)
        )
    for node, values in zip(NODES, found.temperatures[:, some], strict=True):
        cells: list[doc.CellContent] = [doc.Number(value, ".1f [°C]") for value in values.tolist()]
        columns.append(doc.Column(said(PLACE_NAMES[node]), cells, node, "°C", align="right"))
    columns.append(doc.Column(called("power"), found.power[some].tolist(), "power", "W"))
    if found.has_preload:
        columns.append(
            doc.Column(
                said("preload"), found.preload[some].tolist(), "preload", "N", peak="maximum"
            )
        )
    columns.append(doc.Column("p", found.max_pressure[some].tolist(), "max_pressure", "MPa"))
    return tuple(columns)


# --- running up -----------------------------------------------------------------------------------


def warm_up_page(found: WarmUp) -> doc.Document:
    """Return a plan of speeds that keeps a bearing below a limit, beside full speed at once.

    Parameters
    ----------
    found
        What `rolamento.tasks.heat.warm_up` gives.
    """
    case, shown = found.at_once.case, found.transient or found.at_once
    plan = [_plan(found)] if found.transient is not None and found.needed else []
    caption = said("Full speed at once, and by the plan")
    return case_page(
        case,
        doc.Section("", (doc.Title(title_of(case)), *_verdict(found)), "head"),
        [*plan, *_course(shown)[:1], picture(caption, lambda: warm_up_figure(found), "course")],
        "warm_up",
        "course",
        cautions=found.at_once.notes,
        remarks=remarks_of(shown.notes),
    )


def warm_up_figure(found: WarmUp) -> Picture:
    """Draw full speed at once, and what the plan makes of it.

    Parameters
    ----------
    found
        As of `warm_up_page`.
    """
    courses = [(said("full speed at once"), found.at_once)]
    if found.transient is not None and found.needed:
        courses.append((said("by the plan"), found.transient))
    figure: Picture = plots.heat_time_figure(courses)
    return figure


def _verdict(found: WarmUp) -> list[doc.Block]:
    limit = (
        said("a preload of {limit:.4 N}", limit=found.preload)
        if found.preload is not None
        else said("{limit:.4 °C} of every part", limit=found.temperature)
    )
    if not found.needed:
        return [doc.Statement(said("Full speed at once stays below {limit}.", limit=limit))]
    if found.transient is None:
        text = said("No plan of four speeds stays below {limit}.", limit=limit)
        return [doc.Statement(text, "bad-strong")]
    return [doc.Statement(said("This plan stays below {limit}.", limit=limit))]


def _plan(found: WarmUp) -> doc.Section:
    assert found.transient is not None
    duty, course = found.at_once.case.duty, found.transient
    fastest = max(abs(duty.inner_speed), abs(duty.outer_speed))
    ends = np.cumsum([step.duration for step in found.steps])
    lines = []
    for index, step in enumerate(found.steps):
        own = (course.time <= ends[index]) & (course.time >= ends[index] - step.duration)
        lines.append((step, own))
    last = len(lines) - 1
    columns = [
        doc.Column(said("step"), list(range(1, len(lines) + 1)), "step", figures=1),
        doc.Column(
            said("speed"), [step.speed_factor * fastest for step, _ in lines], "speed", "rpm"
        ),
        doc.Column(
            said("duration"),
            [
                said("on") if index == last else doc.Number(step.duration, ".3 [min]")
                for index, (step, _) in enumerate(lines)
            ],
            "duration",
            "min",
            align="right",
        ),
        doc.Column(
            said("warmest part"),
            [doc.Number(float(course.temperatures[:, own].max()), ".1f [°C]") for _, own in lines],
            "warmest",
            "°C",
        ),
    ]
    if course.has_preload:
        columns.append(
            doc.Column(
                said("largest preload"),
                [float(course.preload[own].max()) for _, own in lines],
                "largest_preload",
                "N",
            )
        )
    table = doc.Table(tuple(columns), "plan", rule=True)
    return doc.Section(said("Plan"), (table,), "plan")
