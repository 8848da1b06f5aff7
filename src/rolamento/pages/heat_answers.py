"""The page of `heat --compare`: springs, ceramic, distance of the rows, speed, oil."""

from __future__ import annotations

from math import isfinite, isinf, isnan, nan
from typing import TYPE_CHECKING

from rolamento import plots
from rolamento.document import Column, Document, Entry, KeyValues, Section, Table, Title
from rolamento.pages.friction import torque_unit
from rolamento.pages.given import case_page, picture, title_of
from rolamento.pages.quantities import Quantity, beside
from rolamento.units import HOUR
from rolamento.words import said
from rolamento.words.quantities import called
from rolamento.words.reasons import reason
from rolamento.words.sentences.heat import VARIANT_NAMES

if TYPE_CHECKING:
    from collections.abc import Callable

    from rolamento.heat import HeatBalance, HeatState
    from rolamento.tasks.heat import HeatAnswers

__all__ = ["heat_answers_page"]


def heat_answers_page(found: HeatAnswers) -> Document:
    """Return what a heat balance is asked for.

    Parameters
    ----------
    found
        What `rolamento.tasks.heat.heat_answers` gives.
    """
    own = found.balance
    caption = said("Temperatures and preload of the variants")
    shown = picture(caption, lambda: plots.heat_variants_figure(found.variants), "variants")
    return case_page(
        own.case,
        Section("", (Title(title_of(own.case)), KeyValues(tuple(_answers(found)))), "head"),
        [_variants(found), shown, *_distances(found)],
        "heat_answers",
        "variants",
        notes=own.notes,
    )


def _answers(found: HeatAnswers) -> list[Entry]:
    entries = [Entry(said("highest speed"), _speed(found))]
    if isfinite(found.permissible_speed):
        entries.append(
            Entry(
                said("permissible speed"),
                said(
                    "{speed:.4 rpm} by DIN 732-2, of one bearing without preload",
                    speed=found.permissible_speed,
                ),
            )
        )
    neutral = found.neutral
    if neutral is not None:
        text = (
            said("none from {first:.3 [mm]} to {last:.3 mm}", first=float(neutral.spacing[0]),
                 last=float(neutral.spacing[-1]))
            if isnan(neutral.distance)
            else said("rows {distance:.3 mm} apart keep their preload at these temperatures",
                      distance=neutral.distance)
        )  # fmt: skip
        entries.append(Entry(said("neutral distance"), text))
    if found.most is not None:
        entries.append(Entry(said("oil flow"), _oil(found)))
    return entries


def _speed(found: HeatAnswers) -> str:
    if isnan(found.speed_factor):
        return reason(found.balance.status)
    if isinf(found.speed_factor):
        return said("no limit by heat up to fifteen times the speed")
    values = {"speed": found.speed, "factor": found.speed_factor}
    if found.merges:
        return said(
            "{speed:.4 rpm} ({factor:.3} of the speed): there the temperature runs away", **values
        )
    return said(
        "{speed:.4 rpm} ({factor:.3} of the speed): there it comes to its temperature limit",
        **values,
    )


def _oil(found: HeatAnswers) -> str:
    most = found.most
    if isinf(found.oil_flow):
        return said("more than 100 l/min would keep every part below {most:.4 °C}", most=most)
    if found.oil_flow == 0.0:
        return said("none is needed to keep every part below {most:.4 °C}", most=most)
    return said(
        "{flow:.3 l/min} keeps every part below {most:.4 °C}", flow=found.oil_flow, most=most
    )


def _variants(found: HeatAnswers) -> Section:
    warm = [one.balance.warm for one in found.variants]
    torques = [one.torque for one in warm if one is not None and isfinite(one.torque)]
    torque = f".4 {torque_unit(torques or [1.0])}"
    lines: list[Quantity[HeatBalance]] = [
        Quantity(said("inner ring"), lambda one: one.temperatures["inner_ring"], ".1f °C"),
        Quantity(said("outer ring"), lambda one: one.temperatures["outer_ring"], ".1f °C"),
        Quantity(called("power"), lambda one: one.power, ".4 W"),
        _warm(called("torque"), lambda one: one.torque, torque),
        Quantity(said("preload, cold"), lambda one: one.cold.preload or None, ".4 N"),
        _warm(said("preload, warm"), lambda one: one.preload, ".4 N"),
        _warm(said("axial stiffness"), lambda one: one.axial_stiffness, ".4 N/µm"),
        _warm(called("max_pressure"), lambda one: one.max_pressure, ".4 MPa"),
        _warm(called("film_parameter"), lambda one: one.film_parameter, ".3"),
        _warm(called("viscosity_ratio"), lambda one: one.viscosity_ratio, ".3"),
        _warm(said("life"), lambda one: HOUR * (one.life_hours or nan), ".3 h"),
    ]
    balances = [one.balance for one in found.variants]
    shown = [line for line in lines if line.known(balances)]
    things = [(one.name, said(VARIANT_NAMES[one.name]), one.balance) for one in found.variants]
    legends = tuple(
        f"{said(VARIANT_NAMES[one.name])}: {reason(one.balance.status)}"
        for one in found.variants
        if not one.balance.converged
    )
    table = Table(tuple(beside(shown, things)), "variants", legends=legends, rule=True, fixed=2)
    return Section(said("With one thing changed"), (table,), "variants")


def _warm(label: str, get: Callable[[HeatState], float | None], form: str) -> Quantity[HeatBalance]:
    return Quantity(label, lambda one: None if one.warm is None else get(one.warm), form)


def _distances(found: HeatAnswers) -> list[Section]:
    neutral = found.neutral
    if neutral is None:
        return []
    columns = (
        Column(said("distance of the rows"), neutral.spacing.tolist(), "spacing", "mm"),
        Column(said("preload, cold"), neutral.cold.tolist(), "cold", "N"),
        Column(said("preload, warm"), neutral.warm.tolist(), "warm", "N"),
    )
    table = Table(columns, "distances", only_in_files=True)
    return [Section("", (table,), "distances")]
