"""The plain statement on a life: how long, by which theory, what limits it, what would help."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite, isinf
from typing import TYPE_CHECKING, Final

from rich.text import Text

from rolamento.life.record import BOUNDS, OUTSIDE
from rolamento.report.life_numbers import (
    factor_text,
    given_percent,
    life_text,
    percent,
    said_of,
)
from rolamento.report.page import Lines, Page

if TYPE_CHECKING:
    from rolamento.life import Change, Headline, LifeSummary
    from rolamento.state import State

__all__ = ["reached", "statement", "wanted_sentence"]

_WORTH: Final = 1.05
_BASIC: Final = "iso16281"
_MODIFIED: Final = "iso16281_modified"
_HOUR: Final = 3600.0

Sentence = tuple[str, str]
"""What is said, and its style."""


def statement(
    page: Page, state: State, summary: LifeSummary, changes: Sequence[Change] | None = None
) -> Lines:
    """State the life that leads, or its bound and the reason; warn if nothing does.

    changes: what would help; None where nobody looked, and what costs most is told instead.
    """
    leading = summary.headline
    if not leading.leads[0]:
        sentences = _warning(page, summary)
    elif isinf(leading.life[0]):
        sentences = [_endless(page, state, leading), *_wanted(page, summary)]
    else:
        sentences = [_life(page, state, leading), *_left_out(page, leading)]
        sentences += [*_limit(page, state, summary), *_help(page, summary, changes)]
        sentences += _wanted(page, summary)
    lines: Lines = []
    for text, style in sentences:
        lines += page.hanging(Text("  "), text, style)
    return lines


def reached(
    page: Page,
    theory: str,
    life: float,
    hours: float,
    reliability: float,
    what: str,
    *,
    below: bool = False,
) -> str:
    """Say how long something runs, by a theory; lives in millions of revolutions.

    below: whether these are bounds that it does not reach.
    """
    said = said_of(page)
    if below:
        template = said.reaches_less if isfinite(hours) else said.turns_only_less
    else:
        template = said.reaches if isfinite(hours) else said.turns_only
    return template.format(
        reliability=given_percent(page, reliability),
        what=what,
        hours=life_text(page, hours),
        revolutions=life_text(page, life),
        theory=said.long[theory],
    )


def wanted_sentence(page: Page, wanted: float, reliability: float, *, below: bool = False) -> str:
    """Say with which reliability a wanted life (s) is reached, or below which."""
    said = said_of(page)
    return (said.wanted_below if below else said.wanted).format(
        life=life_text(page, wanted / _HOUR), reliability=percent(page, reliability)
    )


def _life(page: Page, state: State, leading: Headline) -> Sentence:
    theory, life, hours = str(leading.theory[0]), float(leading.life[0]), float(leading.hours[0])
    what, below = _what(page, state), bool(leading.below[0])
    return reached(page, theory, life, hours, leading.reliability, what, below=below), "bold"


def _endless(page: Page, state: State, leading: Headline) -> Sentence:
    """Say that fatigue ends no such life."""
    said, theory = said_of(page), str(leading.theory[0])
    return said.endless_life.format(what=_what(page, state), theory=said.long[theory]), "bold"


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
    if wanted is None:
        return []
    reliability = float(summary.reliability_after(wanted)[0])
    if not isfinite(reliability):
        return []
    below = bool(summary.headline.below[0])
    return [(wanted_sentence(page, wanted, reliability, below=below), "")]


def _left_out(page: Page, leading: Headline) -> list[Sentence]:
    """Say why the life is but a bound, or that oil and dirt are not in it."""
    said = said_of(page)
    if leading.below[0]:
        return [(said.notes[str(leading.reason[0])], "yellow")]
    if leading.theory[0] == _MODIFIED:
        return []
    return [(said.lubrication_left_out, "dim")]


def _warning(page: Page, summary: LifeSummary) -> list[Sentence]:
    """Say that there is no life to go by, why not, and what the numbers are."""
    said, best = said_of(page), summary[_MODIFIED if _MODIFIED in summary.theories else _BASIC]
    reasons = [said.notes[name] for name in best.notes_of() if name in OUTSIDE - BOUNDS]
    if "unloaded" in best.notes_of():
        return [(said.notes["unloaded"], "bold")]
    found = [(said.none_holds, "bold red"), *((reason, "") for reason in reasons)]
    if any(isfinite(float(life.life[0])) for life in summary.theories.values()):
        found.append((said.not_to_be_used, "bold"))
    return found
