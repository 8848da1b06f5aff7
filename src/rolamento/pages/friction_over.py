"""The page of `friction --over`: torque by every model, and spin to roll, over a field."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento import document as doc
from rolamento import plots
from rolamento.friction.models import torque_model_name
from rolamento.friction.summary import no_friction_control
from rolamento.numerics import BoolArray, FloatArray
from rolamento.pages.across import cautions_over, failures, field_column, place_text
from rolamento.pages.friction import torque_unit
from rolamento.pages.given import title_of
from rolamento.studies.names import setting_name
from rolamento.words import decimals_for, in_unit, marked, said

if TYPE_CHECKING:
    from rolamento.studies.friction_curves import FrictionCurve

__all__ = ["friction_over_page"]

_CONTROLLED: Final = "friction_control"
_MARK: Final = "*"
_REASONS: Final = {
    "inertia": marked("inertia not negligible {place}: {models}"),
    "full_film": marked("full film {place}: {models}"),
    "torque_unknown": marked("no result {place}: {models}"),
    "no_film": marked("no film {place}: {models}"),
    "more_contacts": marked("balls on both arcs {place}: {models}"),
    "other_angle": marked("constants for 40° {place}: {models}"),
    "axial_share": marked("axial load too high {place}: {models}"),
}


def friction_over_page(curves: Sequence[FrictionCurve]) -> doc.Document:
    """Return friction over a field.

    Parameters
    ----------
    curves
        The case's own first, then its variants.
    """
    title = title_of(curves[0].case)
    sections = [doc.Section("", (doc.Title(title),), "head")]
    for number, curve in enumerate(curves):
        sections.append(_torques(curve, number))
        if curve.is_speed and curve.controlled is not None:
            sections.append(_ratios(curve, number))
    figure = doc.Figure(
        said("Friction torque by model over {field}", field=curves[0].field.label),
        lambda: plots.friction_figure(curves),
        "friction",
    )
    sections.append(doc.Section("", (figure, _points(curves)), "points"))
    return doc.Document(title, tuple(sections), kind="friction", main="points")


def _variant(curve: FrictionCurve) -> list[doc.Block]:
    if not curve.label:
        return []
    text = said("with {setting}", setting=setting_name(curve.label))
    return [doc.Statement(text, indent=2)]


def _valid_torques(curve: FrictionCurve) -> dict[str, tuple[FloatArray, BoolArray]]:
    """Torque of every model, and where the model is valid."""
    found = {
        validity.model: (curve.torque(validity.model), validity.valid)
        for validity in curve.friction.judged
    }
    torque = curve.controlled_torque
    if np.isfinite(torque).any():
        found[_CONTROLLED] = (torque, curve.controlled_valid)
    return found


def _torques(curve: FrictionCurve, number: int) -> doc.Section:
    found = _valid_torques(curve)
    shown = [float(value) for torque, _ in found.values() for value in torque]
    unit = torque_unit(shown)
    decimals = decimals_for([float(in_unit(value, unit)) for value in shown], 5)
    columns = [field_column(curve.field, curve.values)]
    for model, (torque, valid) in found.items():
        cells: list[doc.CellContent] = [
            doc.Number(value, f".{decimals}f [{unit}]", behind="" if holds else _MARK)
            for value, holds in zip(torque.tolist(), valid.tolist(), strict=True)
        ]
        columns.append(
            doc.Column(
                torque_model_name(model, short=True),
                cells,
                model,
                unit,
                tones=["" if holds else "warning" for holds in valid.tolist()],
            )
        )
    legend = said(
        "friction torque of all sources, in {unit}: the contacts by each model, elastic hysteresis;"
        " friction control includes the inertia of the balls",
        unit=unit,
    )
    if "rolling_resistance" in curve.friction.heat:
        legend = said(
            "friction torque of all sources, in {unit}: the contacts by each model, elastic"
            " hysteresis, hydrodynamic rolling resistance; friction control includes the inertia"
            " of the balls",
            unit=unit,
        )
    if curve.case.bearing.element != "ball":
        legend = said(
            "friction torque of all sources, in {unit}: the contacts, elastic"
            " hysteresis, hydrodynamic rolling resistance; Palmgren and SKF have formulas for the"
            " whole bearing",
            unit=unit,
        )
    table = doc.Table(tuple(columns), f"torque_{number}", legends=(legend,))
    heading = said("Friction torque by model over {field}", field=curve.field.label)
    blocks = (*_variant(curve), table, *_cautions(curve), *_failures(curve))
    return doc.Section(heading, blocks, f"torque_{number}")


def _cautions(curve: FrictionCurve) -> Iterator[doc.Block]:
    """Say with which coefficient, if none was given, and what else qualifies the torque."""
    friction = curve.friction
    if friction.by_regime and np.isfinite(friction.coefficient_range).any():
        low, high = np.nanmin(friction.coefficient_range), np.nanmax(friction.coefficient_range)
        text = said(
            "The coefficient of friction is taken by the regime of lubrication, {low:.2} to"
            " {high:.2}.",
            low=float(low),
            high=float(high),
        )
        yield doc.Statement(text, "warning", indent=2)
    told = {"coefficient_by_regime", "no_valid_torque_model", *_REASONS}
    found = (one for one in curve.cautions if one[0].key not in told)
    yield from cautions_over(curve.field, curve.values, found)


def _failures(curve: FrictionCurve) -> Iterator[doc.Block]:
    """Say of every group of models why and where they are not valid, and what was not solved."""
    validities = curve.friction.judged
    why: dict[tuple[str, str], list[str]] = {}
    for validity in validities:
        for key in _REASONS:
            where = validity.notes.get(key)
            if where is not None:
                place = place_text(curve.field, curve.values, where)
                why.setdefault((key, place), []).append(torque_model_name(validity.model))
    if any(not validity.valid.all() for validity in validities):
        yield doc.Statement(said("* the model is not valid there"), "faint", indent=2)
    for (key, place), models in why.items():
        named = "; ".join(models)
        if len(models) == len(validities):
            beside = np.isfinite(curve.controlled_torque).any()
            named = said("all models except friction control") if beside else said("all models")
        yield doc.Statement(said(_REASONS[key], place=place, models=named), "faint", indent=4)
    nowhere = curve.without_model
    if nowhere.any():
        place = place_text(curve.field, curve.values, nowhere)
        text = said("No model is valid {place}.", place=place)
        yield doc.Statement(text, "warning", indent=2)
        if curve.controlled is None and curve.case.bearing.element == "ball":
            yield doc.Statement(no_friction_control().text, "faint", indent=4)
    yield from failures(curve.status)


def _ratios(curve: FrictionCurve, number: int) -> doc.Section:
    controlled = curve.controlled
    assert controlled is not None
    columns = (
        field_column(curve.field, curve.values),
        _ratio("s_i", controlled.inner_spin_to_roll, "inner_spin_to_roll"),
        _ratio("s_o", controlled.outer_spin_to_roll, "outer_spin_to_roll"),
        doc.Column(
            "n_m",
            [doc.Number(value, ".4 [rpm]") for value in controlled.cage_speed.tolist()],
            "cage_speed",
            "rpm",
        ),
    )
    legend = said(
        "friction control, ball with the maximum inner load; s spin-to-roll ratio: i inner,"
        " o outer contact; n_m cage speed"
    )
    table = doc.Table(columns, f"spin_to_roll_{number}", legends=(legend,))
    heading = said("Spin-to-roll ratio over {field}", field=curve.field.label)
    return doc.Section(heading, (*_variant(curve), table), f"spin_to_roll_{number}")


def _ratio(head: str, values: FloatArray, key: str) -> doc.Column:
    return doc.Column(head, values.tolist(), key, "–", figures=4, most=4)


# --- the points --------------------------------------------------------------------------------


def _points(curves: Sequence[FrictionCurve]) -> doc.Table:
    """Return a line for every point of every curve; for files."""
    first = curves[0]
    models = [validity.model for validity in first.friction.judged]
    sources = list(first.friction.torque_by_source)
    across = field_column(first.field, np.concatenate([curve.values for curve in curves]))
    columns = [
        doc.Column(
            said("variant"), [curve.label for curve in curves for _ in curve.values], "variant"
        ),
        across,
        doc.Column(
            said("status"), [str(code) for curve in curves for code in curve.status], "status"
        ),
    ]

    def add(key: str, unit: str, parts: Iterator[FloatArray]) -> None:
        values = np.concatenate(list(parts)).tolist()
        columns.append(doc.Column(key, values, key, unit))

    for model in models:
        add(f"torque_{model}", "N·m", (curve.torque(model) for curve in curves))
    for model in models:
        valid = [curve.valid(model) for curve in curves]
        words = ["yes" if holds else "no" for part in valid for holds in part]
        columns.append(doc.Column(f"valid_{model}", words, f"valid_{model}"))
    for source in sources:
        add(f"torque_of_{source}", "N·m", (_of_source(curve, source) for curve in curves))
    add("torque_friction_control", "N·m", (curve.controlled_torque for curve in curves))
    for name, unit in (
        ("cage_speed", "rpm"), ("inner_spin_to_roll", ""), ("outer_spin_to_roll", ""),
    ):  # fmt: skip
        add(name, unit, (_of_control(curve, name) for curve in curves))
    add("film_parameter", "", (curve.friction.film_parameter for curve in curves))
    return doc.Table(tuple(columns), "points", only_in_files=True)


def _of_source(curve: FrictionCurve, source: str) -> FloatArray:
    return curve.friction.torque_by_source.get(source, np.full(len(curve), np.nan))


def _of_control(curve: FrictionCurve, name: str) -> FloatArray:
    found: FloatArray = getattr(curve.controlled, name, np.full(len(curve), np.nan))
    return found
