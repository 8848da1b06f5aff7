"""The pages of `heat`: temperatures, heat flows, and what becomes of the preload."""

from __future__ import annotations

from math import nan
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento import document as doc
from rolamento import plots
from rolamento.heat import CONDUCTANCES, NODES
from rolamento.pages.across import cautions_over, failures, field_column
from rolamento.pages.friction import torque_unit
from rolamento.pages.given import case_page, picture, title_of
from rolamento.pages.notes import cautions
from rolamento.pages.quantities import Quantity, beside
from rolamento.units import HOUR
from rolamento.words import marked, said
from rolamento.words.quantities import called
from rolamento.words.reasons import reason
from rolamento.words.sentences.heat import CONDUCTANCE_NAMES, PLACE_NAMES

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from rolamento.heat import HeatBalance, HeatState
    from rolamento.studies.heat_curves import HeatOver

__all__ = ["heat_blocks", "heat_over_page", "heat_page"]

_OF_HEAT: Final = (
    "thermal_runaway", "heated_past_limit", "conductances_estimated", "heat_without_mounting",
    "lubricant_keeps_temperature", "hotter_unstable_state",
)  # fmt: skip

_STABLE: Final = {True: marked("stable"), False: marked("unstable")}


def heat_page(found: HeatBalance) -> doc.Document:
    """Return the heat balance of a case: its state, where the heat goes, cold beside warm.

    Parameters
    ----------
    found
        What `rolamento.heat.heat_balance` gives.
    """
    sections = [] if found.warm is None else [_nodes(found), _flows(found)]
    sections.append(_states_beside(found))
    if found.roots:
        sections.append(_roots(found))
    if len(found.curve.power):
        caption = said("Friction and the heat that is removed, over the temperature")
        sections.append(picture(caption, lambda: plots.heat_figure(found), "heat"))
    return case_page(
        found.case,
        doc.Section("", (doc.Title(title_of(found.case)), *_headline(found)), "head"),
        sections,
        "heat",
        "nodes",
        notes=found.notes,
    )


def heat_blocks(found: HeatBalance) -> list[doc.Block]:
    """Return a heat balance as a part of a report: its state, temperatures, flows, cold and warm.

    Parameters
    ----------
    found
        As of `heat_page`.
    """
    sections = [] if found.warm is None else [_nodes(found), _flows(found)]
    sections.append(_states_beside(found))
    own = [*_headline(found), *(block for one in sections for block in one.blocks)]
    remarks = cautions([note for note in found.notes if note.key in _OF_HEAT])
    return [*own, *remarks]


def _headline(found: HeatBalance) -> Iterator[doc.Block]:
    """Yield temperatures, preload and how stable they are; else why there is no state."""
    root, warm = found.root, found.warm
    if root is None or warm is None:
        yield doc.Statement(reason(found.status), "bad-strong")
        return
    at = root.temperatures
    entries = [
        doc.Entry(
            said("temperatures"),
            said(
                "inner ring {inner:.1f °C}, outer ring {outer:.1f °C}, housing {housing:.1f °C}",
                inner=at["inner_ring"],
                outer=at["outer_ring"],
                housing=at["housing"],
            ),
        ),
        doc.Entry(called("power"), doc.Number(root.power, ".4 W")),
    ]
    if found.cold.preload is not None and warm.preload is not None:
        text = said(
            "{cold:.4 [N]} → {warm:.4 N} (cold → warm)", cold=found.cold.preload, warm=warm.preload
        )
        entries.append(doc.Entry(said("preload"), text))
    entries.append(
        doc.Entry(
            said("stability"),
            said("stable: one watt of heat more makes {slope:.3} W of friction", slope=root.slope),
        )
    )
    yield doc.KeyValues(tuple(entries))


def _nodes(found: HeatBalance) -> doc.Section:
    root = found.root
    assert root is not None
    heated = dict.fromkeys(NODES, 0.0)
    for flow in found.flows:
        if flow.start in ("friction", "outside"):
            heated[flow.end] += flow.power
    most = max(root.temperatures.values())
    tones: list[doc.Tone] = ["strong" if root.temperatures[one] == most else "" for one in NODES]
    columns = (
        doc.Column("", [said(PLACE_NAMES[one]) for one in NODES], "node", tones=tones),
        doc.Column(
            said("temperature"),
            [doc.Number(root.temperatures[one], ".1f [°C]") for one in NODES],
            "temperature",
            "°C",
            tones=tones,
        ),
        doc.Column(said("heat put in"), [heated[one] for one in NODES], "heat", "W", tones=tones),
    )
    table = doc.Table(columns, "nodes", rule=True, fixed=1)
    return doc.Section(said("Temperatures"), (table,), "nodes")


def _flows(found: HeatBalance) -> doc.Section:
    by_ends = {ends: name for name, ends in CONDUCTANCES.items()}
    network, labels, powers, values, origin = found.network, [], [], [], []
    for flow in found.flows:
        name = by_ends.get((flow.start, flow.end))
        if name is None and flow.end != "oil":
            continue
        labels.append(
            said("elements – oil flow") if name is None else said(CONDUCTANCE_NAMES[name])
        )
        powers.append(flow.power)
        values.append(network.oil if name is None else network.conductances[name])
        is_estimate = name in network.estimated
        origin.append(said("estimated") if is_estimate else said("given"))
    columns = (
        doc.Column("", labels, "between"),
        doc.Column(said("heat flow"), powers, "power", "W"),
        doc.Column(said("conductance"), values, "conductance", "W/K", figures=3),
        doc.Column("", origin, "origin", tone="faint"),
    )
    table = doc.Table(columns, "flows", rule=True, fixed=1)
    return doc.Section(said("Heat flows"), (table,), "flows")


def _states_beside(found: HeatBalance) -> doc.Section:
    """Cold beside warm, line by line."""
    states: list[HeatState] = [found.cold, *([found.warm] if found.warm is not None else [])]
    temperatures: list[Quantity[HeatState]] = [
        Quantity(said("inner ring"), lambda one: one.temperatures["inner_ring"], ".4 °C"),
        Quantity(said("outer ring"), lambda one: one.temperatures["outer_ring"], ".4 °C"),
        Quantity(said("lubricant"), lambda one: one.lubricant, ".4 °C"),
        Quantity(said("preload"), lambda one: one.preload, ".4 N"),
        Quantity(said("axial load"), lambda one: one.axial_load or None, ".4 N"),
    ]
    results: list[Quantity[HeatState]] = [
        Quantity(called("max_pressure"), lambda one: one.max_pressure, ".4 MPa"),
        Quantity(called("film_parameter"), lambda one: one.film_parameter, ".3"),
        Quantity(called("viscosity_ratio"), lambda one: one.viscosity_ratio, ".3"),
        Quantity(
            called("torque"),
            lambda one: one.torque,
            f".4 {torque_unit([one.torque for one in states])}",
        ),
        Quantity(called("power"), lambda one: one.power, ".4 W"),
        Quantity(said("life"), lambda one: HOUR * (one.life_hours or nan), ".3 h"),
    ]
    lines = [
        *temperatures,
        *_of_rows(said("clearance"), lambda one: one.clearance, ".4 µm", states),
        *_of_rows(said("free contact angle"), lambda one: one.contact_angle, ".4 °", states),
        *results,
    ]
    shown = [line for line in lines if line.known(states)]
    heads = (("cold", said("cold")), ("warm", said("warm")))
    things = [(*head, state) for head, state in zip(heads, states, strict=False)]
    heading = said("Cold and warm") if len(states) > 1 else said("Cold")
    table = doc.Table(tuple(beside(shown, things)), "states", rule=True, fixed=1)
    return doc.Section(heading, (table,), "states")


def _of_rows(
    label: str, get: Callable[[HeatState], Sequence[float]], form: str, states: Sequence[HeatState]
) -> list[Quantity[HeatState]]:
    """A line for all rows that are alike in every state, else one for each."""
    rows = len(get(states[0]))
    if rows == 1 or all(np.ptp(get(one)) <= 1e-9 * np.max(np.abs(get(one))) for one in states):
        return [Quantity(label, lambda one: get(one)[0], form)]

    def of_row(row: int) -> Quantity[HeatState]:
        text = said("{label}, row {number}", label=label, number=row)
        return Quantity(text, lambda one: get(one)[row], form)

    return [of_row(row) for row in range(rows)]


def _roots(found: HeatBalance) -> doc.Section:
    roots = found.roots
    tones: list[doc.Tone] = ["" if one.stable else "warning" for one in roots]
    columns = [
        doc.Column("", [said(_STABLE[one.stable]) for one in roots], "stability", tones=tones),
        doc.Column(called("power"), [one.power for one in roots], "power", "W"),
    ]
    columns += [
        doc.Column(
            said(PLACE_NAMES[node]),
            [doc.Number(one.temperatures[node], ".1f [°C]") for one in roots],
            node,
            "°C",
        )
        for node in NODES
    ]
    columns.append(doc.Column("dF/dP", [one.slope for one in roots], "slope", "–", figures=3))
    legend = said("dF/dP how much friction a watt of heat more makes; stable below 1")
    table = doc.Table(tuple(columns), "roots", legends=(legend,), rule=True, fixed=1)
    return doc.Section(said("All states below the temperature limit"), (table,), "roots")


# --- over a field ---------------------------------------------------------------------------------


def heat_over_page(found: HeatOver) -> doc.Document:
    """Return the heat balance over a field.

    Parameters
    ----------
    found
        What `rolamento.studies.heat_curves.heat_over` gives.
    """
    title = title_of(found.case)
    across = field_column(found.field, found.values)
    columns = [across]
    for node, values in zip(NODES, found.temperatures, strict=True):
        cells: list[doc.CellContent] = [doc.Number(value, ".1f [°C]") for value in values.tolist()]
        columns.append(doc.Column(said(PLACE_NAMES[node]), cells, node, "°C", align="right"))
    columns.append(doc.Column(called("power"), found.power.tolist(), "power", "W"))
    if found.has_preload:
        for head, key, values in (
            (said("preload, cold"), "cold_preload", found.cold_preload),
            (said("preload, warm"), "warm_preload", found.warm_preload),
        ):
            columns.append(doc.Column(head, values.tolist(), key, "N"))
    columns += [
        doc.Column("p", found.max_pressure.tolist(), "max_pressure", "MPa"),
        doc.Column("dF/dP", found.slope.tolist(), "slope", "–", figures=3),
        *(
            doc.Column(head, values.tolist(), key, unit, only_in_files=True)
            for head, values, unit, key in (
                (said("axial stiffness"), found.axial_stiffness, "N/µm", "axial_stiffness"),
                (said("free contact angle"), found.contact_angle, "°", "contact_angle"),
                (called("viscosity_ratio"), found.viscosity_ratio, "", "viscosity_ratio"),
            )
        ),
        doc.Column(said("status"), found.status.tolist(), "status", only_in_files=True),
    ]
    legend = said(
        "p maximum pressure; dF/dP how much friction a watt of heat more makes, stable below 1"
    )
    table = doc.Table(tuple(columns), "points", legends=(legend,))
    blocks: list[doc.Block] = [table, *cautions_over(found.field, found.values, found.cautions)]
    blocks += failures(found.status)
    heading = said("Heat balance over {field}", field=found.field.label)
    sections = (
        doc.Section("", (doc.Title(title),), "head"),
        doc.Section(
            said("Heat balance over {field}", field=found.field.label), tuple(blocks), "points"
        ),
        picture(heading, lambda: plots.heat_over_figure(found), "heat"),
    )
    return doc.Document(title, sections, kind="heat", main="points")
