"""The plain statement on a life: how long, by which theory, what limits it, what would help."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite, isinf
from typing import TYPE_CHECKING, Final

from rich.text import Text

from rolamento.life.record import OUTSIDE
from rolamento.report.life_numbers import (
    factor_text,
    given_percent,
    life_text,
    percent,
    said_of,
)
from rolamento.report.page import Lines, Page

if TYPE_CHECKING:
    from rolamento.life import Change, Life, LifeSummary
    from rolamento.state import State

__all__ = ["reached", "statement", "wanted_sentence"]

_WORTH: Final = 1.05
_ENDLESS_NOTES: Final = ("unloaded", "below_fatigue_limit")
_MODIFIED: Final = ("iso281_modified", "iso16281_modified")
_HOUR: Final = 3600.0

Sentence = tuple[str, str]
"""What is said, and its style."""


def statement(
    page: Page, state: State, summary: LifeSummary, changes: Sequence[Change] | None = None
) -> Lines:
    """State the life by the theory that knows most of those that hold; warn if none does.

    changes: what would help; None where nobody looked, and what costs most is told instead.
    """
    chosen = summary.best_that_holds()
    if chosen is None:
        sentences = _warning(page, summary)
    elif _endless_note(chosen) or isinf(chosen.life[0]):
        sentences = [_endless(page, state, chosen), *_wanted(page, summary)]
    else:
        sentences = [_life(page, state, chosen), *_left_out(page, summary, chosen)]
        sentences += [*_limit(page, state, summary), *_help(page, summary, changes)]
        sentences += _wanted(page, summary)
    lines: Lines = []
    for text, style in sentences:
        lines += page.hanging(Text("  "), text, style)
    return lines


def reached(
    page: Page, theory: str, life: float, hours: float, reliability: float, what: str
) -> str:
    """Say how long something runs, by a theory; lives in millions of revolutions."""
    said = said_of(page)
    template = said.reaches if isfinite(hours) else said.turns_only
    return template.format(
        reliability=given_percent(page, reliability),
        what=what,
        hours=life_text(page, hours),
        revolutions=life_text(page, life),
        theory=said.long[theory],
    )


def wanted_sentence(page: Page, wanted: float, reliability: float) -> str:
    """Say with which reliability a wanted life (s) is reached."""
    return said_of(page).wanted.format(
        life=life_text(page, wanted / _HOUR), reliability=percent(page, reliability)
    )


def _life(page: Page, state: State, chosen: Life) -> Sentence:
    life, hours = float(chosen.life[0]), float(chosen.hours[0])
    what = _what(page, state)
    return reached(page, chosen.theory, life, hours, chosen.reliability, what), "bold"


def _endless(page: Page, state: State, chosen: Life) -> Sentence:
    """Say that fatigue ends no such life, and why."""
    said = said_of(page)
    text = said.endless_life.format(
        what=_what(page, state),
        theory=said.long[chosen.theory],
        reason=said.notes.get(_endless_note(chosen), ""),
    )
    return text.strip(), "bold"


def _endless_note(chosen: Life) -> str:
    return next((name for name in _ENDLESS_NOTES if name in chosen.notes_of()), "")


def _what(page: Page, state: State) -> str:
    return said_of(page).several if state.case.bearing.is_set else said_of(page).one


def _limit(page: Page, state: State, summary: LifeSummary) -> list[Sentence]:
    said, race = said_of(page), str(summary.limit.race[0])
    if not race:
        return []
    template = said.limit_of_row if state.case.bearing.is_set else said.limit
    return [(template.format(race=said.races[race], row=int(summary.limit.row[0])), "")]


def _help(page: Page, summary: LifeSummary, changes: Sequence[Change] | None) -> list[Sentence]:
    """Name the change that helps most; where none was tried, what costs most."""
    said = said_of(page)
    if changes is None:
        return _costs(page, summary)
    known = [change for change in changes if isfinite(change.life_ratio)]
    if not known:
        return []
    best = max(known, key=lambda change: change.life_ratio)
    if best.life_ratio < _WORTH:
        return [(said.nothing_helps, "")]
    ratio = factor_text(page, best.life_ratio)
    return [(said.helps_most.format(change=said.helps[best.name], ratio=ratio), "")]


def _costs(page: Page, summary: LifeSummary) -> list[Sentence]:
    text = cost_text(page, summary)
    return [(f"{text[0].upper()}{text[1:]}.", "")] if text else []


def cost_text(page: Page, summary: LifeSummary) -> str:
    """Say which of oil, dirt and load costs most; empty where lubrication is not known."""
    name = str(summary.limit.factor[0])
    if not name or summary.viscosity_ratio is None or summary.contamination_factor is None:
        return ""
    return (
        said_of(page)
        .factor[name]
        .format(
            kappa=factor_text(page, float(summary.viscosity_ratio[0])),
            clean=factor_text(page, float(summary.contamination_factor[0])),
        )
    )


def _wanted(page: Page, summary: LifeSummary) -> list[Sentence]:
    """Say how reliable the wanted life is, if one is and the theory for it holds."""
    wanted = summary.conditions.wanted_life
    if wanted is None or not summary.best().holds[0]:
        return []
    reliability = float(summary.reliability_after(wanted)[0])
    return [(wanted_sentence(page, wanted, reliability), "")] if isfinite(reliability) else []


def _left_out(page: Page, summary: LifeSummary, chosen: Life) -> list[Sentence]:
    """Say that oil and dirt are not in the life, and why."""
    said = said_of(page)
    if chosen.theory in _MODIFIED:
        return []
    if any(name in summary.theories for name in _MODIFIED):
        return [(said.modified_fails, "yellow")]
    return [(said.lubrication_left_out, "dim")]


def _warning(page: Page, summary: LifeSummary) -> list[Sentence]:
    """Say that no theory holds, why the one that knows most does not, and what the numbers are."""
    said, best = said_of(page), summary.best()
    reasons = [said.notes[name] for name in best.notes_of() if name in OUTSIDE]
    found = [(said.none_holds, "bold red"), *((reason, "") for reason in reasons)]
    if any(isfinite(float(life.life[0])) for life in summary.theories.values()):
        found.append((said.not_to_be_used, "bold"))
    return found
