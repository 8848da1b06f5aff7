"""Friction over a field for a reader: tables for a terminal, a table for spreadsheets, JSON."""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from io import StringIO
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray
from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.plots.axes_units import read_values, readable_unit
from rolamento.plots.variable_names import torque_model_name
from rolamento.report.across import place_text, written_values
from rolamento.report.friction import friction_parts, unit_of_torque
from rolamento.report.language import ENGLISH, Words
from rolamento.report.numbers import decimals_for
from rolamento.report.page import Lines, Page, rendered
from rolamento.report.plain_data import csv_number, json_text
from rolamento.report.terminal import terminal_head

if TYPE_CHECKING:
    from rolamento.analysis import Analysis
    from rolamento.studies.friction_curves import FrictionCurve

__all__ = ["curves_csv", "curves_json", "curves_report", "friction_json", "friction_report"]

SCHEMA: Final = 1
_CONTROLLED: Final = "friction_control"
_MARK: Final = "*"


@dataclass(frozen=True, slots=True)
class _Words:
    torque: str
    with_all: str
    refused: str
    all_models: str
    reasons: Mapping[str, str]
    spin: str
    spin_legend: str
    variant: str
    failed: str


_WORDS: Final[Mapping[str, _Words]] = {
    "en": _Words(
        torque="Friction torque by model over {field}",
        with_all=(
            "running torque of all sources, in {unit}: the contacts by each model, elastic"
            " hysteresis{oil}; with friction control the balls' inertia counts"
        ),
        refused="* the model is not valid there",
        all_models="every model but friction control",
        reasons={
            "inertia": "inertia counts",
            "full_film": "a full film",
            "torque_unknown": "no result",
            "no_film": "no film",
            "other_angle": "constants for 40°",
        },
        spin="Spin to roll over {field}",
        spin_legend=(
            "friction control, the ball with the maximum inner load; i inner contact, o outer"
            " contact; n_m cage"
        ),
        variant="with {label}",
        failed="{failed} of {count} points without a result: {reasons}",
    ),
    "pt": _Words(
        torque="Torque de atrito por modelo em função de {field}",
        with_all=(
            "torque em movimento de todas as fontes, em {unit}: os contatos segundo cada modelo,"
            " histerese elástica{oil}; com controle por atrito conta a inércia das esferas"
        ),
        refused="* o modelo não vale ali",
        all_models="todos os modelos menos o controle por atrito",
        reasons={
            "inertia": "a inércia conta",
            "full_film": "filme completo",
            "torque_unknown": "sem resultado",
            "no_film": "sem filme",
            "other_angle": "constantes para 40°",
        },
        spin="Pivotamento sobre rolamento em função de {field}",
        spin_legend=(
            "controle por atrito, a esfera de maior carga interna; i contato interno, o externo;"
            " n_m gaiola"
        ),
        variant="com {label}",
        failed="{failed} de {count} pontos sem resultado: {reasons}",
    ),
}
_OIL: Final = {"en": ", oil at the inlets", "pt": ", óleo nas entradas"}


def friction_report(
    analysis: Analysis, words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return the friction of one case as text that ends in a newline."""
    page = Page(words, medium or Medium())
    parts = [terminal_head(page, analysis.solved)]
    if analysis.friction is not None:
        parts += friction_parts(page, analysis.solved, analysis.friction)
    return rendered(page.medium, parts)


def friction_json(analysis: Analysis) -> str:
    """Return the friction of one case as one JSON object in SI units."""
    whole = analysis.to_mapping()
    kept = {key: whole[key] for key in ("schema", "title", "status", "friction", "notes", "case")}
    return json_text({**kept, "kind": "friction"})


def curves_report(
    curves: Sequence[FrictionCurve], words: Words = ENGLISH, medium: Medium | None = None
) -> str:
    """Return friction over a field as text that ends in a newline.

    Parameters
    ----------
    curves
        The case's own first, then its variants.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page = Page(words, medium or Medium())
    head = page.hanging(Text(), curves[0].case.title or words.untitled, "bold")
    parts: list[Lines] = [[*head, page.rule(page.medium.width)]]
    for curve in curves:
        parts.append(_torques(page, curve))
        if curve.is_speed and curve.controlled is not None:
            parts.append(_ratios(page, curve))
    return rendered(page.medium, parts)


def _words(page: Page) -> _Words:
    return _WORDS.get(page.words.code, _WORDS["en"])


def _heading(page: Page, template: str, curve: FrictionCurve) -> Lines:
    said, lines = _words(page), [page.heading(template.format(field=curve.field.name))]
    if curve.label:
        lines += page.hanging(Text("  "), said.variant.format(label=curve.label))
    return lines


def _columns(curve: FrictionCurve) -> dict[str, tuple[NDArray[np.float64], NDArray[np.bool_]]]:
    """Torque of every model, and where the model is valid."""
    found = {
        validity.model: (curve.torque(validity.model), validity.valid)
        for validity in curve.friction.validity
    }
    if curve.controlled is not None and np.isfinite(curve.controlled_torque).any():
        torque = curve.controlled_torque
        film = curve.friction.regime == "full_film"
        found[_CONTROLLED] = (torque, np.isfinite(torque) & ~film)
    return found


def _torques(page: Page, curve: FrictionCurve) -> Lines:
    said, digits = _words(page), page.digits
    columns = _columns(curve)
    values_shown = [float(v) for torque, _ in columns.values() for v in torque]
    factor, unit = unit_of_torque(values_shown)
    across, symbol = read_values(curve.field, curve.values)
    values = written_values(page, across)
    decimals = decimals_for([factor * value for value in values_shown], 5)
    cells: list[Lines] = [[Text(), page.text(symbol, "dim"), *map(page.text, values)]]
    for model, (torque, valid) in columns.items():
        written = [digits.fixed(factor * float(value), decimals) for value in torque]
        head = [
            page.text(f"{torque_model_name(model, page.words.code, short=True)} "),
            page.text(f"{unit} ", "dim"),
        ]
        cells.append(head + [_marked(page, t, v) for t, v in zip(written, valid, strict=True)])
    lines = _heading(page, said.torque, curve)
    lines += page.columns(list(zip(*cells, strict=True)), "r" * len(cells))
    oil = _OIL[page.words.code] if "rolling_resistance" in curve.friction.heat else ""
    lines += page.hanging(Text("  "), said.with_all.format(unit=unit, oil=oil), "dim")
    return lines + _failures(page, curve)


def _marked(page: Page, text: str, valid: bool) -> Text:
    return page.text(f"{text} ") if valid else page.text(f"{text}{_MARK}", "yellow")


def _failures(page: Page, curve: FrictionCurve) -> Lines:
    """Say of every group of models why and where they are not valid, and what was not solved."""
    said, lines = _words(page), []
    why: dict[str, list[str]] = {}
    for validity in curve.friction.validity:
        for name in said.reasons:
            where = validity.notes.get(name)
            if where is not None and where.any():
                place = place_text(page, curve.field, curve.values, where)
                text = f"{said.reasons[name]} {place}"
                why.setdefault(text, []).append(torque_model_name(validity.model, page.words.code))
    if any(not validity.valid.all() for validity in curve.friction.validity):
        lines += page.hanging(Text("  "), said.refused, "dim")
    for text, models in why.items():
        every = len(models) == len(curve.friction.validity)
        named = said.all_models if every else "; ".join(models)
        lines += page.hanging(Text("    "), f"{text}: {named}", "dim")
    failed = curve.status[curve.status != "converged"]
    if failed.size:
        reasons = ", ".join(page.words.reasons.get(c, c) for c in np.unique(failed).tolist())
        text = said.failed.format(failed=failed.size, count=len(curve), reasons=reasons)
        lines += page.hanging(Text("  "), text, "bold red")
    return lines


def _ratios(page: Page, curve: FrictionCurve) -> Lines:
    assert curve.controlled is not None
    said, digits = _words(page), page.digits
    across, symbol = read_values(curve.field, curve.values)
    controlled = curve.controlled
    cage = readable_unit("rad/s", controlled.cage_speed)
    columns = (
        ("", symbol, written_values(page, across)),
        ("s_i", "–", digits.column(controlled.inner_spin_to_roll.tolist(), 4)),
        ("s_o", "–", digits.column(controlled.outer_spin_to_roll.tolist(), 4)),
        ("n_m", cage.symbol, [digits.short(float(v), 4) for v in cage.of(controlled.cage_speed)]),
    )
    cells = [
        [page.text(name), page.text(unit, "dim"), *map(page.text, written)]
        for name, unit, written in columns
    ]
    lines = _heading(page, said.spin, curve)
    lines += page.columns(list(zip(*cells, strict=True)), "rrrr")
    return lines + page.hanging(Text("  "), said.spin_legend, "dim")


# --- data -------------------------------------------------------------------------------------


def curves_csv(curves: Sequence[FrictionCurve]) -> str:
    """Return the points, one a line below a header that names the units (RFC 4180).

    SI units, a decimal point, ten significant digits, an empty field for what does not exist.
    """
    text = StringIO(newline="")
    writer = csv.writer(text)
    first = curves[0]
    models = [validity.model for validity in first.friction.validity]
    sources = list(first.friction.torque_by_source)
    writer.writerow(
        [
            "variant",
            f"{first.field.name}_{first.field.unit}",
            "status",
            *(f"torque_{model}_Nm" for model in models),
            *(f"holds_{model}" for model in models),
            *(f"torque_of_{source}_Nm" for source in sources),
            "torque_friction_control_Nm",
            "cage_speed_rad/s",
            "inner_spin_to_roll",
            "outer_spin_to_roll",
            "film_parameter",
        ]
    )
    for curve in curves:
        torques = [curve.torque(model) for model in models]
        valid = {validity.model: validity.valid for validity in curve.friction.validity}
        parts = [
            curve.friction.torque_by_source.get(s, np.full(len(curve), np.nan)) for s in sources
        ]
        for point in range(len(curve)):
            writer.writerow(
                [
                    curve.label,
                    csv_number(curve.values[point]),
                    str(curve.status[point]),
                    *(csv_number(torque[point]) for torque in torques),
                    *("yes" if valid[model][point] else "no" for model in models),
                    *(csv_number(part[point]) for part in parts),
                    *(csv_number(column[point]) for column in _controlled_columns(curve)),
                    csv_number(curve.friction.film_parameter[point]),
                ]
            )
    return text.getvalue()


def _controlled_columns(curve: FrictionCurve) -> tuple[NDArray[np.float64], ...]:
    found = curve.controlled
    if found is None:
        return (np.full(len(curve), np.nan),) * 4
    ratios = (found.inner_spin_to_roll, found.outer_spin_to_roll)
    return (curve.controlled_torque, found.cage_speed, *ratios)


def curves_json(curves: Sequence[FrictionCurve]) -> str:
    """Return everything as one JSON object in SI units, ``null`` for what does not exist."""
    first = curves[0]
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "friction_curve",
            "title": first.case.title,
            "field": first.field.name,
            "unit": first.field.unit,
            "values": first.values,
            "curves": [_curve_mapping(curve) for curve in curves],
        }
    )


def _curve_mapping(curve: FrictionCurve) -> dict[str, Any]:
    friction = curve.friction
    models = {
        validity.model: {
            "contact_torque": friction.models[validity.model].total,
            "torque": curve.torque(validity.model),
            "holds": validity.valid.tolist(),
            "reasons": {name: where.tolist() for name, where in validity.notes.items()},
        }
        for validity in friction.validity
    }
    torque, cage, inner, outer = _controlled_columns(curve)
    return {
        "label": curve.label,
        "status": curve.status.tolist(),
        "model": friction.model,
        "torque": friction.torque,
        "starting_torque": friction.starting_torque,
        "power": friction.power,
        "torque_by_source": dict(friction.torque_by_source),
        "regime": friction.regime.tolist(),
        "film_parameter": curve.friction.film_parameter,
        "models": models,
        "friction_control": {
            "torque": torque,
            "cage_speed": cage,
            "inner_spin_to_roll": inner,
            "outer_spin_to_roll": outer,
        },
    }
