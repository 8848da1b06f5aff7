"""The page of `heat --compare`: springs, ceramic, distance of the rows, speed, oil."""

from __future__ import annotations

from math import isfinite, isinf, isnan, nan
from typing import TYPE_CHECKING, Final

from rolamento import plots
from rolamento.document import (
    CellContent,
    Column,
    Document,
    Entry,
    KeyValues,
    Number,
    Section,
    Table,
    Title,
)
from rolamento.pages.friction import torque_unit
from rolamento.pages.given import case_page, picture, title_of
from rolamento.pages.notes import remarks_of
from rolamento.words import said
from rolamento.words.reasons import reason
from rolamento.words.sentences.heat import VARIANT_NAMES

if TYPE_CHECKING:
    from rolamento.heat import HeatBalance
    from rolamento.tasks.heat import HeatAnswers

__all__ = ["heat_answers_page"]

_PLAIN: Final = ".4"


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
        cautions=own.notes,
        remarks=remarks_of(own.notes),
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
    balances = [one.balance for one in found.variants]
    torques = [nan if one.warm is None else one.warm.torque for one in balances]
    unit = torque_unit(torques if any(map(isfinite, torques)) else [1.0])

    def warm(one: HeatBalance, name: str, factor: float = 1.0) -> float:
        value = None if one.warm is None else getattr(one.warm, name)
        return nan if value is None else factor * value

    def at(one: HeatBalance, node: str) -> float:
        return one.temperatures[node]

    lines = [
        (said("inner ring"), [at(one, "inner_ring") for one in balances], "°C", ".1f"),
        (said("outer ring"), [at(one, "outer_ring") for one in balances], "°C", ".1f"),
        (said("power loss"), [one.power for one in balances], "W", _PLAIN),
        (said("friction torque"), torques, unit, _PLAIN),
        (said("preload, cold"), [one.cold.preload or nan for one in balances], "N", _PLAIN),
        (said("preload, warm"), [warm(one, "preload") for one in balances], "N", _PLAIN),
        (said("axial stiffness"), [warm(one, "axial_stiffness") for one in balances], "N/µm",
         _PLAIN),
        (said("maximum pressure"), [warm(one, "max_pressure") for one in balances], "MPa", _PLAIN),
        (said("film parameter λ"), [warm(one, "film_parameter") for one in balances], "", ".3"),
        (said("viscosity ratio κ"), [warm(one, "viscosity_ratio") for one in balances], "", ".3"),
        (said("life"), [warm(one, "life_hours", 3600.0) for one in balances], "h", ".3"),
    ]  # fmt: skip
    shown = [line for line in lines if any(isfinite(value) for value in line[1])]
    columns = [
        Column("", [label for label, *_ in shown], "quantity"),
        Column(said("unit"), [unit for _, _, unit, _ in shown], "unit"),
    ]
    for place, one in enumerate(found.variants):
        cells: list[CellContent] = [
            Number(values[place], f"{form} [{own}]" if own else form)
            for _, values, own, form in shown
        ]
        columns.append(Column(said(VARIANT_NAMES[one.name]), cells, one.name, align="right"))
    legends = tuple(
        f"{said(VARIANT_NAMES[one.name])}: {reason(one.balance.status)}"
        for one in found.variants
        if not one.balance.converged
    )
    table = Table(tuple(columns), "variants", legends=legends, rule=True, fixed=2)
    return Section(said("With one thing changed"), (table,), "variants")


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
