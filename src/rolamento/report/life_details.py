"""What a life rests on: ratings and loads, what limits it, and what would help."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees, isfinite
from typing import TYPE_CHECKING, Final

from rich.text import Text

from rolamento.report.life_numbers import factor_text, force_text, percent, said_of, unit_of_force
from rolamento.report.life_statement import cost_text
from rolamento.report.numbers import aligned
from rolamento.report.page import Lines, Page

if TYPE_CHECKING:
    from rolamento.life import Change, LifeSummary
    from rolamento.state import State

__all__ = ["changes_part", "limit_part", "ratings_part"]

_BAR: Final = 24
"""Characters of the greatest gain."""
_FULL, _PLAIN = "█", "#"
_GAP: Final = "  "


def ratings_part(page: Page, summary: LifeSummary) -> Lines:
    """Show ratings with their sources, and the loads that stand against them."""
    said, ratings, loads = said_of(page), summary.ratings, summary.loads
    sources = summary.rating_sources
    load, static = float(loads.dynamic[0]), float(loads.static[0])
    entries = [
        ("C", ratings.dynamic_of_set, _source(page, sources["dynamic"], "dynamic")),
        ("C_0", ratings.static_of_set, _source(page, sources["static"], "static")),
        ("C_u", ratings.fatigue_of_set, _source(page, sources["fatigue"], "fatigue")),
    ]
    shown = [
        (symbol, float(values[0]), text if isfinite(values[0]) else said.sources["unknown"])
        for symbol, values, text in entries
    ]
    if isfinite(load):
        factors = said.factors.format(
            x=factor_text(page, float(loads.radial_factor[0])),
            y=factor_text(page, float(loads.axial_factor[0])),
            e=factor_text(page, float(loads.limit[0])),
            ratio=factor_text(page, shown[0][1] / load if load > 0.0 else float("nan")),
        )
        shown.append(("P", load, factors))
        safety = float(loads.safety[0])
        known = said.static_safety.format(safety=factor_text(page, safety))
        shown.append(("P_0", static, known if isfinite(safety) else ""))
    reference = float(summary["iso16281"].factors["equivalent_load"][0])
    if isfinite(reference):
        shown.append(("P_ref", reference, said.reference_load))
    return [page.heading(said.ratings), *_forces(page, shown)]


def _source(page: Page, source: str, rating: str) -> str:
    """Say where a rating comes from; what is no word of the engine is the catalogue's source."""
    said = said_of(page)
    if source == "geometry":
        return said.sources[rating]
    return said.sources.get(source, source)


def _forces(page: Page, shown: Sequence[tuple[str, float, str]]) -> Lines:
    factor, unit = unit_of_force([value for _, value, _ in shown])
    written = [force_text(page, factor * value) for _, value, _ in shown]
    numbers = aligned(written, page.words.decimal_mark)
    cells = [
        [page.text(symbol), page.text(number, "bold"), page.text(unit)]
        for (symbol, _, _), number in zip(shown, numbers, strict=True)
    ]
    lines: Lines = []
    for line, (_, _, text) in zip(page.columns(cells, "lrl"), shown, strict=True):
        lines += page.hanging(Text.assemble(line, "   "), text, "dim")
    return lines


def limit_part(page: Page, state: State, summary: LifeSummary) -> Lines:
    """Name the race with the greatest part of the risk, its heaviest ball, and what costs most."""
    said, limit = said_of(page), summary.limit
    race = str(limit.race[0])
    if not race:
        reason = page.hanging(Text("  "), said.notes["unloaded"])
        return [page.heading(said.limits), *reason]
    template = said.share_of_row if state.case.bearing.is_set else said.share_of_risk
    share = percent(page, float(limit.share[0]))
    texts = [template.format(race=said.races[race], row=int(limit.row[0]), share=share)]
    number = int(limit.ball[0])
    if number >= 0:
        ball = state.balls[number]
        contact = ball.inner if race == "inner" else ball.outer
        texts.append(
            said.heaviest.format(
                ball=number,
                azimuth=page.digits.short(round(degrees(ball.azimuth), 2), 5),
                load=page.digits.short(contact.load, 4),
            )
        )
    cost = cost_text(page, summary)
    lines = [page.heading(said.limits)]
    for text in [*texts, cost] if cost else texts:
        lines += page.hanging(Text("  "), text)
    return lines


def changes_part(page: Page, summary: LifeSummary, changes: Sequence[Change]) -> Lines:
    """Show the life after each change over that before, with a bar; nothing if none is known."""
    said = said_of(page)
    known = [change for change in changes if isfinite(change.life_ratio)]
    if not known:
        return []
    ratios = aligned(
        [f"× {factor_text(page, change.life_ratio)}" for change in known], page.words.decimal_mark
    )
    greatest = max(max(change.life_ratio for change in known) - 1.0, 0.0)
    cells = [
        [
            page.text(said.changes[change.name]),
            page.text(ratio, "bold" if change.life_ratio > 1.0 else ""),
        ]
        for change, ratio in zip(known, ratios, strict=True)
    ]
    table = page.columns(cells, "lr")
    room = min(page.medium.width - len(table[0]) - len(_GAP), _BAR)
    rows = [
        Text.assemble(
            line, _GAP, page.text(_bar(page, change.life_ratio - 1.0, greatest, room), "green")
        )
        for line, change in zip(table, known, strict=True)
    ]
    legend = said.changes_legend.format(theory=said.long[str(summary.headline.theory[0])])
    lines = [page.heading(said.changes_heading), *rows]
    return lines + page.hanging(Text("  "), legend, "dim")


def _bar(page: Page, gain: float, greatest: float, room: int) -> str:
    """Draw a gain, the greatest as long as there is room."""
    if gain <= 0.0 or greatest <= 0.0 or room <= 0:
        return ""
    sign = _FULL if page.medium.draws else _PLAIN
    return sign * max(round(room * gain / greatest), 1)
