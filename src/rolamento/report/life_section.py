"""Life beside the state of a bearing: the statement, and the numbers that one looks for first."""

from __future__ import annotations

from math import isfinite, isnan
from typing import TYPE_CHECKING, Final

from rich.text import Text

from rolamento.report.life_numbers import factor_text, life_text, said_of
from rolamento.report.life_statement import statement
from rolamento.report.page import Lines, Page

if TYPE_CHECKING:
    from rolamento.life import Life, LifeSummary
    from rolamento.state import State

__all__ = ["life_notes", "life_part"]

_SHOWN: Final = ("iso281", "iso281_modified", "iso16281", "iso16281_modified")


def life_part(page: Page, state: State, summary: LifeSummary) -> Lines:
    """Show the statement, the lives by the standards, and how far the loads are from the ratings.

    All theories and what would help are for a report of their own.
    """
    said, loads = said_of(page), summary.loads
    turns = any(not isnan(life.hours[0]) for life in summary.theories.values())
    numbers = [
        f"{said.names[name]}: {_bounded(page, life, float(value[0]))} {unit}"
        for name, life in ((name, summary[name]) for name in _SHOWN if name in summary.theories)
        for value, unit in [(life.hours, said.hour) if turns else (life.life, said.million)]
        if not isnan(value[0])
    ]
    load = float(loads.dynamic[0])
    if load > 0.0:
        ratio = factor_text(page, float(summary.ratings.dynamic_of_set[0]) / load)
        numbers.append(said.load_ratio.format(ratio=ratio))
    if isfinite(loads.safety[0]):
        numbers.append(said.static_safety.format(safety=factor_text(page, float(loads.safety[0]))))
    lines = [page.heading(said.life), *statement(page, state, summary)]
    if numbers:
        lines += page.hanging(Text("  "), "; ".join(numbers))
    return lines + page.hanging(Text("  "), said.all_lives, "dim")


def _bounded(page: Page, life: Life, value: float) -> str:
    """Write a life, with a sign where it is below the number."""
    return f"<{life_text(page, value)}" if life.below[0] else life_text(page, value)


def life_notes(page: Page, summary: LifeSummary) -> list[str]:
    """Return what is to be known of the lives that are shown, each said once."""
    said = said_of(page)
    names = [
        name
        for theory, life in summary.theories.items()
        if theory in _SHOWN
        for name in life.notes_of()
    ]
    return [said.notes[name] for name in dict.fromkeys(names)]
