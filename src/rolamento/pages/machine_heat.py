"""The page of `shaft --heat`: how warm the bearings of a machine run."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from rolamento import document as doc
from rolamento import plots
from rolamento.heat import NODES
from rolamento.pages.given import picture
from rolamento.pages.notes import cautions_section, notes_section, remarks_of
from rolamento.words import said
from rolamento.words.quantities import called
from rolamento.words.reasons import reason
from rolamento.words.sentences.heat import PLACE_NAMES

if TYPE_CHECKING:
    from rolamento.heat.machine import MachineHeat
    from rolamento.solved.machine import SolvedMachine

__all__ = ["machine_heat_page"]


def machine_heat_page(found: MachineHeat) -> doc.Document:
    """Return the heat balance of a machine: temperatures, what becomes of loads, what shafts carry.

    Parameters
    ----------
    found
        What `rolamento.heat.machine.machine_heat` gives.
    """
    title = found.machine.title or said("machine")
    head = doc.Section("", (doc.Title(title), _headline(found)), "head")
    sections = [head, *cautions_section(found.notes)]
    if found.warm is not None:
        caption = said("Temperatures of the bearings")
        sections += [_temperatures(found), _loads(found, found.warm), *_links(found)]
        sections.append(picture(caption, lambda: plots.machine_heat_figure(found), "heat"))
    sections += notes_section(remarks_of(found.notes))
    return doc.Document(title, tuple(sections), kind="machine_heat", main="bearings")


def _headline(found: MachineHeat) -> doc.Statement | doc.KeyValues:
    if not found.converged:
        return doc.Statement(reason(found.status), "bad-strong")
    place, node = np.unravel_index(int(np.argmax(found.temperatures)), found.temperatures.shape)
    warmest = said(
        "{bearing}, {part}: {temperature:.1f °C}",
        bearing=found.bearings[int(place)],
        part=said(PLACE_NAMES[NODES[int(node)]]),
        temperature=float(found.temperatures[place, node]),
    )
    return doc.KeyValues(
        (
            doc.Entry(said("warmest part"), warmest),
            doc.Entry(called("power"), doc.Number(float(found.power.sum()), ".4 W")),
            doc.Entry(
                said("stability"),
                said(
                    "stable: one watt of heat more makes {slope:.3} W of friction",
                    slope=found.growth,
                ),
            ),
        )
    )


def _temperatures(found: MachineHeat) -> doc.Section:
    columns = [doc.Column("", list(found.bearings), "bearing")]
    for index, node in enumerate(NODES):
        cells: list[doc.CellContent] = [
            doc.Number(value, ".1f [°C]") for value in found.temperatures[:, index].tolist()
        ]
        columns.append(doc.Column(said(PLACE_NAMES[node]), cells, node, "°C", align="right"))
    columns.append(doc.Column(called("power"), found.power.tolist(), "power", "W"))
    table = doc.Table(tuple(columns), "bearings", rule=True)
    return doc.Section(said("Temperatures"), (table,), "bearings")


def _loads(found: MachineHeat, warm: SolvedMachine) -> doc.Section:
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
    columns = [doc.Column("", [name for name, _ in lines], "bearing")]
    for place in (0, 3, 1, 4, 2, 5):
        head, key, unit = heads[place]
        columns.append(doc.Column(head, [own[place] for _, own in lines], key, unit))
    legend = said("p maximum pressure")
    table = doc.Table(tuple(columns), "loads", legends=(legend,), rule=True)
    return doc.Section(said("Cold and warm"), (table,), "loads")


def _links(found: MachineHeat) -> list[doc.Section]:
    if not found.links:
        return []
    columns = (
        doc.Column("", [f"{one.first} – {one.second}" for one in found.links], "bearings"),
        doc.Column("", [said(PLACE_NAMES[one.part]) for one in found.links], "part"),
        doc.Column(said("heat flow"), list(found.link_flows()), "flow", "W"),
        doc.Column(
            said("conductance"),
            [one.conductance for one in found.links],
            "conductance",
            "W/K",
            figures=3,
        ),
    )
    table = doc.Table(columns, "links", rule=True)
    return [doc.Section(said("Heat between the bearings"), (table,), "links")]
