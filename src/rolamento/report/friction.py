"""Friction in the report: torque and heat by source, and what the rival models say."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING, Final

import numpy as np
from rich.text import Text

from rolamento.plots.variable_names import torque_model_name
from rolamento.report.page import Lines, Page

if TYPE_CHECKING:
    from rolamento.friction import Friction, ModelValidity
    from rolamento.solved import Solved

__all__ = ["friction_parts", "reason_text", "unit_of_power", "unit_of_torque"]


@dataclass(frozen=True, slots=True)
class _Words:
    friction: str
    coefficient: str
    running: str
    starting: str
    power: str
    sources: Mapping[str, str]
    torque: str
    heat: str
    total: str
    models: str
    contacts: str
    all_sources: str
    valid_here: str
    valid: str
    refused: str
    reasons: Mapping[str, str]
    at_rest: str
    legend: str


_WORDS: Final[Mapping[str, _Words]] = {
    "en": _Words(
        friction="Friction",
        coefficient="μ = {value} ({name})",
        running="running torque",
        starting="starting torque",
        power="power",
        sources={
            "spin": "spin",
            "rolling_slip": "slip in rolling",
            "hysteresis": "elastic hysteresis",
            "rolling_resistance": "oil at the inlets",
        },
        torque="torque",
        heat="heat,",
        total="sum",
        models="Friction torque by model",
        contacts="contacts",
        all_sources="in all",
        valid_here="valid here",
        valid="yes",
        refused="no: ",
        reasons={
            "inertia": "inertia",
            "full_film": "full film",
            "partial_film": "partial film: μ effective",
            "no_film": "no film",
            "other_angle": "constants for 40°",
            "torque_at_rest": "at rest",
            "torque_unknown": "no result",
        },
        at_rest="at rest: no heat",
        legend=(
            "torque and heat of the balls' contacts as {model} has them; seals, cage and churning"
            " of the oil are not counted"
        ),
    ),
    "pt": _Words(
        friction="Atrito",
        coefficient="μ = {value} ({name})",
        running="torque em movimento",
        starting="torque de partida",
        power="potência",
        sources={
            "spin": "pivotamento",
            "rolling_slip": "deslizamento no rolamento",
            "hysteresis": "histerese elástica",
            "rolling_resistance": "óleo nas entradas",
        },
        torque="torque",
        heat="calor,",
        total="soma",
        models="Torque de atrito por modelo",
        contacts="contatos",
        all_sources="ao todo",
        valid_here="vale aqui",
        valid="sim",
        refused="não: ",
        reasons={
            "inertia": "inércia",
            "full_film": "filme completo",
            "partial_film": "filme parcial: μ efetivo",
            "no_film": "sem filme",
            "other_angle": "constantes para 40°",
            "torque_at_rest": "em repouso",
            "torque_unknown": "sem resultado",
        },
        at_rest="em repouso: sem calor",
        legend=(
            "torque e calor dos contatos das esferas segundo {model}; vedações, gaiola e agitação"
            " do óleo não são contadas"
        ),
    ),
}


def unit_of_torque(values: Sequence[float]) -> tuple[float, str]:
    """Return factor and unit in which torques of a table are read; values in N·m."""
    return _readable(values, ((1.0, "N·m"), (1e3, "N·mm"), (1e6, "µN·m")))


def unit_of_power(values: Sequence[float]) -> tuple[float, str]:
    """Return factor and unit in which powers of a table are read; values in W."""
    return _readable(values, ((1.0, "W"), (1e3, "mW"), (1e6, "µW")))


def _readable(values: Sequence[float], units: tuple[tuple[float, str], ...]) -> tuple[float, str]:
    """Return the largest unit of which the maximum has at least a tenth, else the last."""
    maximum = max((abs(value) for value in values if isfinite(value)), default=0.0)
    fitting = (pair for pair in units if pair[0] * maximum >= 0.1)
    return next(fitting, units[-1] if maximum else units[1])


def reason_text(validity: ModelValidity, language: str, case: int = 0) -> str:
    """Say whether a model is valid for a case, and if not, why; remarks follow a "yes"."""
    from rolamento.friction.model import REMARKS

    said = _WORDS.get(language, _WORDS["en"])
    reasons = [name for name, where in validity.notes.items() if where[case]]
    if validity.valid[case]:
        remarks = [said.reasons[name] for name in reasons]
        return "; ".join([said.valid, *remarks])
    refused = [name for name in reasons if name not in REMARKS]
    refused = ["torque_unknown"] if "torque_unknown" in refused else refused
    return said.refused + ", ".join(said.reasons[name] for name in refused)


def friction_parts(page: Page, solved: Solved, friction: Friction) -> list[Lines]:
    """Show the friction of a single solved case: torque and heat by source, and the models."""
    return [_torque_and_heat(page, solved, friction), _model_table(page, solved, friction)]


def _words(page: Page) -> _Words:
    return _WORDS.get(page.words.code, _WORDS["en"])


def _torque_and_heat(page: Page, solved: Solved, friction: Friction) -> Lines:
    said, digits = _words(page), page.digits
    lubricant = solved.case.lubricant
    assert lubricant is not None
    lines = [page.heading(said.friction)]
    mu = digits.short(lubricant.friction_coefficient or 0.0)
    named = said.coefficient.format(value=mu, name=lubricant.name)
    lines += page.hanging(Text("  "), named)
    lines += _totals(page, said, friction)
    lines += [Text(), *_source_table(page, said, friction)]
    name = torque_model_name(friction.model, page.words.code)
    return lines + page.hanging(Text("  "), said.legend.format(model=name), "dim")


def _totals(page: Page, said: _Words, friction: Friction) -> Lines:
    running, starting = float(friction.torque[0]), float(friction.starting_torque[0])
    power = float(friction.power[0])
    factor, unit = unit_of_torque([running, starting])
    watt, watt_unit = unit_of_power([power])
    entries = (
        (said.running, factor * running, unit),
        (said.starting, factor * starting, unit),
        (said.power, watt * power, watt_unit),
    )
    rows = [
        [page.text(label), page.text(page.digits.short(value, 4), "bold"), page.text(text)]
        for label, value, text in entries
    ]
    return page.columns(rows, "lrl")


def _source_table(page: Page, said: _Words, friction: Friction) -> Lines:
    """Set torque and heat of every source, the heat by race, and their sums."""
    names = [name for name in said.sources if name in friction.torque_by_source]
    torque = [float(friction.torque_by_source[name][0]) for name in names]
    heat = np.array(
        [[friction.heat[name].inner[0].sum(), friction.heat[name].outer[0].sum()] for name in names]
    )
    factor, unit = unit_of_torque(torque)
    columns = [page.digits.column([factor * v for v in [*torque, sum(torque)]], 4)]
    heads, units = [said.torque], [unit]
    if heat.any():
        watt, watt_unit = unit_of_power(heat.sum(axis=0).tolist())
        for index, race in enumerate((page.words.inner, page.words.outer)):
            values = watt * np.append(heat[:, index], heat[:, index].sum())
            columns.append(page.digits.column(values.tolist(), 4))
            heads.append(f"{said.heat} {race}")
            units.append(watt_unit)
    labels = [*(said.sources[name] for name in names), said.total]
    rows = [
        [Text(), *(page.text(head) for head in heads)],
        [Text(), *(page.text(text, "dim") for text in units)],
        *(
            [page.text(label), *(page.text(column[index]) for column in columns)]
            for index, label in enumerate(labels)
        ),
    ]
    return page.columns(rows, "l" + "r" * len(columns), gap=3)


def _model_table(page: Page, solved: Solved, friction: Friction) -> Lines:
    """Set the torque of every model and whether it is valid here; the one in use in bold."""
    from rolamento.friction.models import TORQUE_MODELS

    said = _words(page)
    added = float(friction.torque[0] - friction.models[friction.model].total[0])
    entries: list[tuple[str, float, float, str]] = []
    for found in friction.validity:
        own = float(friction.models[found.model].total[0])
        whole = own + added if TORQUE_MODELS[found.model].of_contacts else own
        entries.append((found.model, own, whole, reason_text(found, page.words.code)))
    speed = abs(solved.case.duty.inner_speed - solved.case.duty.outer_speed)
    if solved.rolling is not None and speed > 0.0:
        own = float(solved.rolling.power[0]) / speed
        film = friction.regime[0] == "full_film"
        held = said.refused + said.reasons["full_film"] if film else said.valid
        entries.append(("friction_control", own, own + added, held))
    factor, unit = unit_of_torque([own for _, own, _, _ in entries])
    owns = page.digits.column([factor * own for _, own, _, _ in entries], 4)
    wholes = page.digits.column([factor * whole for _, _, whole, _ in entries], 4)
    rows = [
        [Text(), page.text(said.contacts), page.text(said.all_sources), page.text(said.valid_here)],
        [Text(), page.text(unit, "dim"), page.text(unit, "dim"), Text()],
    ]
    for (model, _, _, reason), own_text, whole_text in zip(entries, owns, wholes, strict=True):
        style = "bold" if model == friction.model else ""
        dim = "" if reason.startswith(said.valid) else "yellow"
        rows.append(
            [
                page.text(torque_model_name(model, page.words.code), style),
                page.text(own_text, style),
                page.text(whole_text, style),
                page.text(reason, dim),
            ]
        )
    return [page.heading(said.models), *page.columns(rows, "lrrl")]
