"""The page of `shaft --heat`: how warm the bearings of a machine run."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from rolamento import plots
from rolamento.document import (
    CellContent,
    Column,
    Document,
    Entry,
    KeyValues,
    Number,
    Section,
    Statement,
    Table,
    Title,
)
from rolamento.heat import NODES
from rolamento.pages.given import picture
from rolamento.pages.notes import cautions_section, notes_section, remarks_of
from rolamento.words import said
from rolamento.words.reasons import reason
from rolamento.words.sentences.heat import PLACE_NAMES

if TYPE_CHECKING:
    from rolamento.heat.machine import MachineHeat
    from rolamento.solved.machine import SolvedMachine

__all__ = ["machine_heat_page"]


def machine_heat_page(found: MachineHeat) -> Document:
    """Return the heat balance of a machine: temperatures, what becomes of loads, what shafts carry.

    Parameters
    ----------
    found
        What `rolamento.heat.machine.machine_heat` gives.
    """
    title = found.machine.title or said("machine")
    head = Section("", (Title(title), _headline(found)), "head")
    sections = [head, *cautions_section(found.notes)]
    if found.warm is not None:
        caption = said("Temperatures of the bearings")
        sections += [_temperatures(found), _loads(found, found.warm), *_links(found)]
        sections.append(picture(caption, lambda: plots.machine_heat_figure(found), "heat"))
    sections += notes_section(remarks_of(found.notes))
    return Document(title, tuple(sections), kind="machine_heat", main="bearings")


def _headline(found: MachineHeat) -> Statement | KeyValues:
    if not found.converged:
        return Statement(reason(found.status), "bad-strong")
    place, node = np.unravel_index(int(np.argmax(found.temperatures)), found.temperatures.shape)
    warmest = said(
        "{bearing}, {part}: {temperature:.1f °C}",
        bearing=found.bearings[int(place)],
        part=said(PLACE_NAMES[NODES[int(node)]]),
        temperature=float(found.temperatures[place, node]),
    )
    return KeyValues(
        (
            Entry(said("warmest part"), warmest),
            Entry(said("power loss"), Number(float(found.power.sum()), ".4 W")),
            Entry(
                said("stability"),
                said(
                    "stable: one watt of heat more makes {slope:.3} W of friction",
                    slope=found.growth,
                ),
            ),
        )
    )


def _temperatures(found: MachineHeat) -> Section:
    columns = [Column("", list(found.bearings), "bearing")]
    for index, node in enumerate(NODES):
        cells: list[CellContent] = [
            Number(value, ".1f [°C]") for value in found.temperatures[:, index].tolist()
        ]
        columns.append(Column(said(PLACE_NAMES[node]), cells, node, "°C", align="right"))
    columns.append(Column(said("power loss"), found.power.tolist(), "power", "W"))
    table = Table(tuple(columns), "bearings", rule=True)
    return Section(said("Temperatures"), (table,), "bearings")


def _loads(found: MachineHeat, warm: SolvedMachine) -> Section:
    """The loads of each bearing in its hardest step, cold beside warm."""
    lines: list[tuple[str, list[float]]] = []
    for name in found.bearings:
        values = []
        for solved in (found.cold, warm):
            own = solved.bearings[name].solved
            load = own.load.array
            values += [
                float(np.abs(load[:, 0]).max()),
                float(np.hypot(load[:, 1], load[:, 2]).max()),
                float(np.nanmax(own.inner.max_pressure)),
            ]
        lines.append((name, values))
    heads = (
        (said("axial load, cold"), "axial_cold", "N"),
        (said("radial load, cold"), "radial_cold", "N"),
        (said("p, cold"), "pressure_cold", "MPa"),
        (said("axial load, warm"), "axial_warm", "N"),
        (said("radial load, warm"), "radial_warm", "N"),
        (said("p, warm"), "pressure_warm", "MPa"),
    )
    columns = [Column("", [name for name, _ in lines], "bearing")]
    for place in (0, 3, 1, 4, 2, 5):
        head, key, unit = heads[place]
        columns.append(Column(head, [own[place] for _, own in lines], key, unit))
    legend = said("p maximum pressure")
    table = Table(tuple(columns), "loads", legends=(legend,), rule=True)
    return Section(said("Cold and warm"), (table,), "loads")


def _links(found: MachineHeat) -> list[Section]:
    if not found.links:
        return []
    columns = (
        Column("", [f"{one.first} – {one.second}" for one in found.links], "bearings"),
        Column("", [said(PLACE_NAMES[one.part]) for one in found.links], "part"),
        Column(said("heat flow"), list(found.link_flows()), "flow", "W"),
        Column(
            said("conductance"),
            [one.conductance for one in found.links],
            "conductance",
            "W/K",
            figures=3,
        ),
    )
    table = Table(columns, "links", rule=True)
    return [Section(said("Heat between the bearings"), (table,), "links")]
