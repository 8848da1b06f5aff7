"""The page of `friction`, and friction on other pages: torque and heat by source, the models."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento import document as doc
from rolamento.friction.models import torque_model_name
from rolamento.pages.given import case_page, head
from rolamento.pages.notes import cautions
from rolamento.words import in_unit, marked, said
from rolamento.words.quantities import called

if TYPE_CHECKING:
    from rolamento.analysis import Analysis
    from rolamento.friction import Friction, ModelValidity
    from rolamento.solved import Solved

__all__ = [
    "SOURCES",
    "friction_page",
    "friction_sections",
    "power_unit",
    "source_name",
    "torque_and_power",
    "torque_unit",
    "validity_text",
]

SOURCES: Final = {
    "spin": marked("spin"),
    "rolling_slip": marked("differential slip"),
    "rib": marked("sliding at the ribs"),
    "hysteresis": marked("elastic hysteresis"),
    "rolling_resistance": marked("hydrodynamic rolling resistance"),
}
"""Sources of friction, by their names in `Friction.torque_by_source`."""
_REASONS: Final = {
    "inertia": marked("inertia"),
    "full_film": marked("full film"),
    "film_by_regime": marked("full film: μ by regime"),
    "rating_of_steel": marked("C₀ with steel balls"),
    "partial_film": marked("partial film: μ effective"),
    "no_film": marked("no film"),
    "more_contacts": marked("balls on both arcs"),
    "other_angle": marked("constants for 40°"),
    "for_balls": marked("for balls"),
    "axial_share": marked("axial load too high"),
    "rib_film_unknown": marked("rib: no film assumed"),
    "torque_at_rest": marked("at rest"),
    "torque_unknown": marked("no result"),
}
"""Why a model is not valid, in a cell; the notes of these keys say it in a sentence."""


def friction_page(analysis: Analysis) -> doc.Document:
    """Return the page of the friction of one case; without a result it says why and what to do."""
    solved = analysis.solved
    whole = (*solved.notes[0], *analysis.notes)
    sections: list[doc.Section] = []
    if analysis.friction is not None:
        sections = [*friction_sections(solved, analysis.friction), *beside_sections(analysis)]
    return case_page(solved.case, head(solved), sections, "friction", "models", cautions=whole)


def beside_sections(analysis: Analysis) -> list[doc.Section]:
    """Return what seals and an oil bath add to the friction of the contacts; nothing without."""
    friction, beside = analysis.friction, analysis.seals_and_bath
    if friction is None or beside is None:
        return []
    seal, drag = float(beside.seal[0]), float(beside.drag[0])
    lines = [(said("contacts"), float(friction.torque[0]), float(friction.power[0]))]
    if seal or not drag:
        lines.append((said("seals"), seal, seal * float(beside.speed[0])))
    given = analysis.solved.case.losses
    if given is not None and given.oil_level is not None:
        lines.append((said("oil bath"), drag, drag * float(beside.speed[0])))
    torques, powers = [one for _, one, _ in lines], [one for _, _, one in lines]
    columns = (
        doc.Column("", [*(label for label, _, _ in lines), said("sum")], "source"),
        doc.Column(
            said("torque"), [*torques, sum(torques)], "torque", torque_unit([sum(torques)]), most=4
        ),
        doc.Column(said("power"), [*powers, sum(powers)], "power", power_unit([sum(powers)])),
    )
    table = doc.Table(columns, "seals_and_bath", rule=True)
    remarks = tuple(doc.Remark(note.text, note.key, "warning") for note in beside.notes)
    blocks: tuple[doc.Block, ...] = (table, *([doc.Notes(remarks)] if remarks else []))
    return [doc.Section(said("Whole bearing, with seals and oil bath"), blocks, "seals_and_bath")]


def source_name(source: str) -> str:
    """Return what a source of friction is called, by its name in `Friction.torque_by_source`."""
    return said(SOURCES[source])


def torque_unit(values: Sequence[float]) -> str:
    """Return the unit in which torques of a table are read; values in N·m."""
    return _readable(values, ("N·m", "N·mm", "µN·m"))


def power_unit(values: Sequence[float]) -> str:
    """Return the unit in which powers of a table are read; values in W."""
    return _readable(values, ("W", "mW", "µW"))


def _readable(values: Sequence[float], units: tuple[str, ...]) -> str:
    """Return the largest unit of which the maximum has at least a tenth, else the last."""
    maximum = max((abs(value) for value in values if isfinite(value)), default=0.0)
    fitting = (unit for unit in units if in_unit(maximum, unit) >= 0.1)
    return next(fitting, units[-1] if maximum else units[1])


def validity_text(validity: ModelValidity, case: int = 0) -> str:
    """Say whether a model is valid for a case, and if not, why; remarks follow a "yes"."""
    from rolamento.friction.model import REMARKS

    keys = [note.key for note in validity.notes_of(case)]
    if validity.valid[case]:
        return "; ".join([said("yes"), *map(_reason, keys)])
    refused = [key for key in keys if key not in REMARKS]
    return _refused(["torque_unknown"] if "torque_unknown" in refused else refused)


def _refused(keys: Sequence[str]) -> str:
    return said("no: {reasons}", reasons=[_reason(key) for key in keys])


def _reason(key: str) -> str:
    return said(_REASONS[key])


def friction_sections(solved: Solved, friction: Friction) -> list[doc.Section]:
    """Return the friction of a single solved case: torque and heat by source, and the models."""
    return [torque_and_power(solved, friction), *_sources(friction), _models(solved, friction)]


def torque_and_power(solved: Solved, friction: Friction) -> doc.Section:
    """Return torque and power loss of a single solved case, and what qualifies them."""
    lubricant = solved.case.lubricant
    assert lubricant is not None
    coefficient = float(friction.friction_coefficient[0])
    named = said("μ = {coefficient:.5} ({name})", coefficient=coefficient, name=lubricant.name)
    if friction.by_regime:
        low, high = friction.coefficient_range[0].tolist()
        named = said(
            "μ = {coefficient:.2} by the regime of lubrication, {low:.2} to {high:.2} ({name})",
            coefficient=coefficient,
            low=low,
            high=high,
            name=lubricant.name,
        )
    notes = friction.qualifications(solved)
    blocks: tuple[doc.Block, ...] = (
        doc.Statement(named, indent=2),
        _totals(friction),
        *cautions(notes),
    )
    return doc.Section(said("Friction"), blocks, "friction")


def _totals(friction: Friction) -> doc.Table:
    from rolamento.friction.line_losses import RIB_COEFFICIENT

    running, starting = float(friction.torque[0]), float(friction.starting_torque[0])
    power = float(friction.power[0])
    bound = bool(friction.upper_bound[0])
    rows = [(called("torque", bound=bound), running), (called("starting_torque"), starting)]
    for name, found in friction.models.items():
        if found.starting is not None:
            text = said("starting torque, {model}", model=torque_model_name(name))
            rows.append((text, float(found.starting[0])))
    torque, watt = torque_unit([value for _, value in rows]), power_unit([power])
    units = [torque] * len(rows) + [watt]
    rows.append((called("power", bound=bound), power))
    values = [
        doc.Number(value, f".4 [{unit}]") for (_, value), unit in zip(rows, units, strict=True)
    ]
    labels = [label for label, _ in rows]
    columns = (
        doc.Column("", labels, "quantity"),
        doc.Column("", values, "value", tone="strong"),
        doc.Column("", units, "unit"),
    )
    legends: tuple[str, ...] = ()
    if float(friction.torque_by_source.get("rib", [0.0])[0]) > 0.0:
        text = said(
            "starting torque of bearings that have not run in; coefficient of friction at the ribs"
            " {coefficient}",
            coefficient=RIB_COEFFICIENT,
        )
        legends = (text,)
    return doc.Table(columns, "friction", headless=True, legends=legends)


def _sources(friction: Friction) -> list[doc.Section]:
    """Show torque and heat of every source, the heat by race, and their sums."""
    names = [name for name in SOURCES if name in friction.torque_by_source]
    torque = [float(friction.torque_by_source[name][0]) for name in names]
    columns = [
        doc.Column("", [*(source_name(name) for name in names), said("sum")], "source"),
        doc.Column(said("torque"), [*torque, sum(torque)], "torque", torque_unit(torque), most=4),
    ]
    heat = np.array(
        [[friction.heat[name].inner[0].sum(), friction.heat[name].outer[0].sum()] for name in names]
    )
    if heat.any():
        watt = power_unit(heat.sum(axis=0).tolist())
        heads = {"inner": said("heat, inner"), "outer": said("heat, outer")}
        columns += [
            doc.Column(
                text,
                [*heat[:, place].tolist(), float(heat[:, place].sum())],
                f"{race}_heat",
                watt,
                most=4,
            )
            for place, (race, text) in enumerate(heads.items())
        ]
    legend = said(
        "torque and heat of the ball contacts by {model}; seals, cage and churning of the oil are"
        " not included",
        model=torque_model_name(friction.model),
    )
    if "rib" in names:
        legend = said(
            "torque and heat of the contacts; seals, cage and churning of the oil are not included"
        )
    table = doc.Table(tuple(columns), "sources", legends=(legend,), gap=3)
    return [doc.Section("", (table,), "sources")]


def _models(solved: Solved, friction: Friction) -> doc.Section:
    """Show the torque of every model and whether it is valid here; the one in use in bold."""
    from rolamento.friction.models import TORQUE_MODELS

    added = float(friction.torque[0] - friction.models[friction.model].total[0])
    entries: list[tuple[str, float, float, str, bool]] = []
    for found in friction.judged:
        own = float(friction.models[found.model].total[0])
        whole = own + added if TORQUE_MODELS[found.model].of_contacts else own
        valid = bool(found.valid[0])
        entries.append((found.model, own, whole, validity_text(found), valid))
    speed = abs(solved.case.duty.inner_speed - solved.case.duty.outer_speed)
    if solved.rolling is not None and speed > 0.0:
        own = float(solved.rolling.power[0]) / speed
        valid = friction.regime[0] != "full_film" or friction.by_regime
        text = said("yes") if valid else _refused(["full_film"])
        entries.append(("friction_control", own, own + added, text, valid))
    unit = torque_unit([own for _, own, _, _, _ in entries])
    tones: list[doc.Tone] = ["strong" if entry[0] == friction.model else "" for entry in entries]
    columns = (
        doc.Column("", [torque_model_name(entry[0]) for entry in entries], "model", tones=tones),
        doc.Column(
            said("contacts"),
            [entry[1] for entry in entries],
            "contact_torque",
            unit,
            most=4,
            tones=tones,
        ),
        doc.Column(
            said("total"), [entry[2] for entry in entries], "torque", unit, most=4, tones=tones
        ),
        doc.Column(
            said("valid here"),
            [entry[3] for entry in entries],
            "valid",
            tones=["" if entry[4] else "warning" for entry in entries],
        ),
    )
    legends: tuple[str, ...] = ()
    if friction.judged != friction.validity:
        legends = (said("the models of Jones, Harris and Todd are for balls"),)
    table = doc.Table(columns, "models", legends=legends)
    return doc.Section(said("Friction torque by model"), (table,), "models")
