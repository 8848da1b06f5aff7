"""The page of `rotor`: natural frequencies, critical speeds, and what unbalance does."""

from __future__ import annotations

from collections.abc import Iterable
from math import pi
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento import document as doc
from rolamento import plots
from rolamento.document import Notes as NotesBlock
from rolamento.pages.notes import notes_section
from rolamento.words import said
from rolamento.words.naming import machine_title
from rolamento.words.reasons import reason
from rolamento.words.whirl import whirl_name

if TYPE_CHECKING:
    from rolamento.solved.rotor import UnbalanceResponse
    from rolamento.tasks.rotor import MachineVibration

__all__ = ["vibration_page"]

_HERTZ: Final = 1.0 / (2.0 * pi)
_SHOWN: Final = 1e-4
"""Damping ratio from which on a column shows it."""


def vibration_page(found: MachineVibration) -> doc.Document:
    """Return the page of how a machine vibrates.

    Parameters
    ----------
    found
        Of a `rolamento.tasks.RotorRequest`.
    """
    title = machine_title(found.machine.title)
    sections = [
        doc.Section("", (doc.Title(title), _given(found)), "given"),
        doc.Section(said("Critical speeds"), (*_headline(found), *_critical(found)), "critical"),
        _modes(found),
        *_response(found),
        doc.Section("", (_every_speed(found),), "speeds"),
        *notes_section(dict.fromkeys((*found.modes.notes, *found.campbell.notes))),
    ]
    return doc.Document(title, tuple(sections), kind="machine_vibration", main="modes")


def _given(found: MachineVibration) -> doc.KeyValues:
    speed = found.campbell.speed
    text = said(
        "{shaft}: {first:.5 rpm} to {last:.5 rpm}, operating speed {own:.5 rpm}",
        shaft=found.campbell.shaft, first=speed[0], last=speed[-1], own=found.speed,
    )  # fmt: skip
    entries = [doc.Entry(said("shaft speed"), text)]
    lost = found.campbell.status != "converged"
    if lost.any():
        names = dict.fromkeys(found.campbell.status[lost].tolist())
        why = ", ".join(reason(str(name)) for name in names)
        entries.append(
            doc.Entry(said("status"), said("✗ {count} of {all} speeds have no equilibrium: {why}",
                     count=int(lost.sum()), all=len(lost), why=why), "bad-strong")
        )  # fmt: skip
    return doc.KeyValues(tuple(entries))


def _headline(found: MachineVibration) -> Iterable[doc.Statement | NotesBlock]:
    nearest = found.nearest
    if nearest is None:
        text = said("No natural frequency meets an order of the rotation at these speeds.")
        yield doc.Statement(text, "strong", indent=2)
    else:
        apart = nearest.speed / found.speed - 1.0
        text = said(
            "The critical speed nearest to the operating speed is {speed:.5 rpm} ({whirl},"
            " order {order:.4g}): {apart:+.3 %} from it.",
            speed=nearest.speed,
            whirl=whirl_name(nearest.whirl),
            order=nearest.order,
            apart=apart,
        )
        yield doc.Statement(text, "strong", indent=2)
    if found.response is not None and found.response.notes:
        remarks = tuple(doc.Remark(note.text, note.key, "warning") for note in found.response.notes)
        yield NotesBlock(remarks)


def _critical(found: MachineVibration) -> tuple[doc.Figure | doc.Table, ...]:

    caption = said("Natural frequencies over speed, each speed with its own operating point")
    figure = doc.Figure(caption, lambda: plots.campbell_figure(found.campbell), "campbell")
    critical = found.campbell.critical
    if not critical:
        return (figure,)
    columns = (
        doc.Column(said("order"), [one.order for one in critical], "order", most=4),
        doc.Column(said("speed"), [one.speed for one in critical], "speed", "rpm", figures=5),
        doc.Column("Hz", [one.frequency * _HERTZ for one in critical], "hertz", figures=5),
        doc.Column(said("motion"), [whirl_name(one.whirl) for one in critical], "whirl"),
        doc.Column(
            said("from the operating\nspeed"),
            [one.speed / found.speed - 1.0 for one in critical],
            "apart",
            align="right",
            form="+.3 %",
        ),
    )
    legends = (said("unbalance excites order 1: forward whirl and motion along a line"),)
    return figure, doc.Table(columns, "critical", legends=legends)


def _modes(found: MachineVibration) -> doc.Section:
    modes = found.modes

    columns = [
        doc.Column(said("mode"), list(range(1, len(modes) + 1)), "mode"),
        doc.Column("Hz", (modes.frequency * _HERTZ).tolist(), "hertz", figures=5),
        doc.Column("", modes.frequency.tolist(), "rpm", "rpm", figures=5),
        doc.Column(said("motion"), [whirl_name(str(one)) for one in modes.whirl], "whirl"),
    ]
    if np.any(np.abs(modes.damping_ratio) > _SHOWN):
        damping = doc.Column("ζ", modes.damping_ratio.tolist(), "damping_ratio", most=4)
        columns.append(damping)
    heading = said("Natural frequencies at the operating point")
    figure = doc.Figure(said("Mode shapes"), lambda: plots.modes_figure(modes), "modes")
    return doc.Section(heading, (doc.Table(tuple(columns), "modes"), figure), "modes")


def _response(found: MachineVibration) -> list[doc.Section]:
    response = found.response
    if response is None:
        return []

    places = {name: response.amplitude(name) for name in response.displacement}
    lines = [_peak(response, values.max(axis=1), found.speed) for values in places.values()]
    shafts = doc.Table(
        (doc.Column(said("shaft"), list(places), "shaft"), *_peaks(lines, "µm")),
        "unbalance_shafts",
        legends=(
            said(
                "semi-major axis of the orbit, where it is greatest along the shaft; at the speeds"
                " calculated, critical ones among them"
            ),
        ),
    )
    lines = [_peak(response, response.force_amplitude(name), found.speed)
             for name in response.force]  # fmt: skip
    bearings = doc.Table(
        (doc.Column(said("bearing"), list(response.force), "bearing"), *_peaks(lines, "N")),
        "unbalance_bearings",
        legends=(said("greatest radial force in a turn, besides what the bearing carries"),),
    )
    caption = said("Response to unbalance over speed")
    figure = doc.Figure(caption, lambda: plots.response_figure(response), "unbalance")
    return [doc.Section(said("Response to unbalance"), (figure, shafts, bearings), "unbalance")]


def _peak(
    response: UnbalanceResponse, values: np.ndarray, own: float
) -> tuple[float, float, float]:
    """At the operating speed, at most, and where that is."""
    speed = np.abs(response.speed)
    at_own = float(np.interp(own, speed, values)) if speed[0] <= own <= speed[-1] else float("nan")
    if not np.isfinite(values).any():
        return at_own, float("nan"), float("nan")
    most = int(np.nanargmax(values))
    return at_own, float(values[most]), float(speed[most])


def _peaks(lines: list[tuple[float, float, float]], unit: str) -> tuple[doc.Column, ...]:
    def column(head: str, key: str, unit: str, place: int) -> doc.Column:
        values = doc.finite_cells(one[place] for one in lines)
        return doc.Column(head, values, key, unit, figures=4)

    return (
        column(said("at operating\nspeed"), "at_operating_speed", unit, 0),
        column(said("maximum"), "maximum", unit, 1),
        column(said("at"), "maximum_at", "rpm", 2),
    )


def _every_speed(found: MachineVibration) -> doc.Table:
    """Every branch at every speed, for files."""
    diagram = found.campbell
    shape = diagram.frequency.shape
    speed, branch = np.meshgrid(diagram.speed, np.arange(1, shape[1] + 1), indexing="ij")

    def numbers(values: np.ndarray) -> list[doc.CellContent]:
        return doc.finite_cells(values.ravel().tolist())

    columns = (
        doc.Column("speed", numbers(speed), "speed", "rpm"),
        doc.Column("branch", branch.ravel().tolist(), "branch"),
        doc.Column("Hz", numbers(diagram.frequency * _HERTZ), "hertz"),
        doc.Column("damping_ratio", numbers(diagram.damping_ratio), "damping_ratio"),
        doc.Column("whirl", diagram.whirl.ravel().tolist(), "whirl"),
    )
    return doc.Table(columns, "campbell", only_in_files=True)
