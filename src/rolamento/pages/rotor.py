"""The page of `rotor`: natural frequencies, critical speeds, and what unbalance does."""

from __future__ import annotations

from collections.abc import Iterable
from math import pi
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.document import (
    CellContent,
    Column,
    Document,
    Entry,
    Figure,
    KeyValues,
    Remark,
    Section,
    Statement,
    Table,
    Title,
    finite_cells,
)
from rolamento.document import Notes as NotesBlock
from rolamento.pages.notes import notes_section
from rolamento.words import said
from rolamento.words.reasons import reason
from rolamento.words.whirl import whirl_name

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Picture

    from rolamento.solved.rotor import UnbalanceResponse
    from rolamento.tasks.rotor import MachineVibration

__all__ = ["vibration_page"]

_HERTZ: Final = 1.0 / (2.0 * pi)
_SHOWN: Final = 1e-4
"""Damping ratio from which on a column shows it."""


def vibration_page(found: MachineVibration) -> Document:
    """Return the page of how a machine vibrates.

    Parameters
    ----------
    found
        Of `rolamento.tasks.rotor.machine_vibration`.
    """
    title = found.machine.title or said("Machine without a title")
    sections = [
        Section("", (Title(title), _given(found)), key="given"),
        Section(said("Critical speeds"), (*_headline(found), *_critical(found)), key="critical"),
        _modes(found),
        *_response(found),
        Section("", (_every_speed(found),), key="speeds"),
        *notes_section(dict.fromkeys((*found.modes.notes, *found.campbell.notes))),
    ]
    return Document(title, tuple(sections), kind="machine_vibration", main="modes")


def _given(found: MachineVibration) -> KeyValues:
    speed = found.campbell.speed
    text = said(
        "{shaft}: {first:.5g rpm} to {last:.5g rpm}, operating speed {own:.5g rpm}",
        shaft=found.campbell.shaft, first=speed[0], last=speed[-1], own=found.speed,
    )  # fmt: skip
    entries = [Entry(said("shaft speed"), text)]
    lost = found.campbell.status != "converged"
    if lost.any():
        names = dict.fromkeys(found.campbell.status[lost].tolist())
        why = ", ".join(reason(str(name)) for name in names)
        entries.append(
            Entry(
                said("status"),
                said("✗ {count} of {all} speeds have no equilibrium: {why}",
                     count=int(lost.sum()), all=len(lost), why=why),
                "bad-strong",
            )
        )  # fmt: skip
    return KeyValues(tuple(entries))


def _headline(found: MachineVibration) -> Iterable[Statement | NotesBlock]:
    nearest = found.nearest
    if nearest is None:
        text = said("No natural frequency meets an order of the rotation at these speeds.")
        yield Statement(text, "strong", indent=2)
    else:
        apart = nearest.speed / found.speed - 1.0
        text = said(
            "The critical speed nearest to the operating speed is {speed:.5g rpm} ({whirl},"
            " order {order:.4g}): {apart:+.3 %} from it.",
            speed=nearest.speed,
            whirl=whirl_name(nearest.whirl),
            order=nearest.order,
            apart=apart,
        )
        yield Statement(text, "strong", indent=2)
    if found.response is not None and found.response.notes:
        remarks = tuple(Remark(note.text, note.key, "warning") for note in found.response.notes)
        yield NotesBlock(remarks)


def _critical(found: MachineVibration) -> tuple[Figure | Table, ...]:
    def draw() -> Picture:
        from rolamento.plots.machine import campbell_figure

        return campbell_figure(found.campbell)

    caption = said("Natural frequencies over speed, each speed with its own operating point")
    figure = Figure(caption=caption, draw=draw, key="campbell")
    critical = found.campbell.critical
    if not critical:
        return (figure,)
    columns = (
        Column(head=said("order"), values=[one.order for one in critical], key="order", most=4),
        Column(head=said("speed"), unit="rpm", key="speed", figures=5,
               values=[one.speed for one in critical]),
        Column(head="Hz", values=[one.frequency * _HERTZ for one in critical], key="hertz",
               figures=5),
        Column(head=said("motion"), values=[whirl_name(one.whirl) for one in critical],
               key="whirl"),
        Column(head=said("from the operating\nspeed"), key="apart", align="right",
               form="+.3 %", values=[one.speed / found.speed - 1.0 for one in critical]),
    )  # fmt: skip
    legends = (said("unbalance excites order 1: forward whirl and motion along a line"),)
    return figure, Table(columns=columns, key="critical", legends=legends)


def _modes(found: MachineVibration) -> Section:
    modes = found.modes

    def draw() -> Picture:
        from rolamento.plots.machine import modes_figure

        return modes_figure(modes)

    columns = [
        Column(head=said("mode"), values=list(range(1, len(modes) + 1)), key="mode"),
        Column(head="Hz", key="hertz", figures=5, values=(modes.frequency * _HERTZ).tolist()),
        Column(head="", unit="rpm", key="rpm", figures=5, values=modes.frequency.tolist()),
        Column(head=said("motion"), key="whirl",
               values=[whirl_name(str(one)) for one in modes.whirl]),
    ]  # fmt: skip
    if np.any(np.abs(modes.damping_ratio) > _SHOWN):
        damping = Column(head="ζ", key="damping_ratio", most=4,
                         values=modes.damping_ratio.tolist())  # fmt: skip
        columns.append(damping)
    heading = said("Natural frequencies at the operating point")
    figure = Figure(caption=said("Mode shapes"), draw=draw, key="modes")
    return Section(heading, (Table(columns=tuple(columns), key="modes"), figure), key="modes")


def _response(found: MachineVibration) -> list[Section]:
    response = found.response
    if response is None:
        return []

    def draw() -> Picture:
        from rolamento.plots.machine import response_figure

        return response_figure(response)

    places = {name: response.amplitude(name) for name in response.displacement}
    lines = [_peak(response, values.max(axis=1), found.speed) for values in places.values()]
    shafts = Table(
        columns=(
            Column(head=said("shaft"), values=list(places), key="shaft"),
            *_peaks(lines, "µm"),
        ),
        key="unbalance_shafts",
        legends=(
            said(
                "semi-major axis of the orbit, where it is greatest along the shaft; at the speeds"
                " calculated, critical ones among them"
            ),
        ),
    )
    lines = [_peak(response, response.force_amplitude(name), found.speed)
             for name in response.force]  # fmt: skip
    bearings = Table(
        columns=(
            Column(head=said("bearing"), values=list(response.force), key="bearing"),
            *_peaks(lines, "N"),
        ),
        key="unbalance_bearings",
        legends=(said("greatest radial force in a turn, besides what the bearing carries"),),
    )
    caption = said("Response to unbalance over speed")
    figure = Figure(caption=caption, draw=draw, key="unbalance")
    return [Section(said("Response to unbalance"), (figure, shafts, bearings), key="unbalance")]


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


def _peaks(lines: list[tuple[float, float, float]], unit: str) -> tuple[Column, ...]:
    def column(head: str, key: str, unit: str, place: int) -> Column:
        values = finite_cells(one[place] for one in lines)
        return Column(head=head, values=values, unit=unit, key=key, figures=4)

    return (
        column(said("at operating\nspeed"), "at_operating_speed", unit, 0),
        column(said("maximum"), "maximum", unit, 1),
        column(said("at"), "maximum_at", "rpm", 2),
    )


def _every_speed(found: MachineVibration) -> Table:
    """Every branch at every speed, for files."""
    diagram = found.campbell
    shape = diagram.frequency.shape
    speed, branch = np.meshgrid(diagram.speed, np.arange(1, shape[1] + 1), indexing="ij")

    def numbers(values: np.ndarray) -> list[CellContent]:
        return finite_cells(values.ravel().tolist())

    columns = (
        Column(head="speed", unit="rpm", values=numbers(speed), key="speed"),
        Column(head="branch", values=branch.ravel().tolist(), key="branch"),
        Column(head="Hz", values=numbers(diagram.frequency * _HERTZ), key="hertz"),
        Column(head="damping_ratio", values=numbers(diagram.damping_ratio), key="damping_ratio"),
        Column(head="whirl", values=diagram.whirl.ravel().tolist(), key="whirl"),
    )
    return Table(columns=columns, key="campbell", only_in_files=True)
