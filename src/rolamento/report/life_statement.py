"""What all pages of life have in common: lives as they are written, notes, and the statement.

Three digits tell what a life is worth.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import floor, isfinite, isinf, log10
from typing import TYPE_CHECKING, Final

from rich.text import Text

from rolamento.life.iso16281 import THEORY as REFERENCE
from rolamento.life.iso16281_modified import THEORY as MODIFIED_REFERENCE
from rolamento.life.record import BOUNDS, OUTSIDE
from rolamento.report.life_words import LIFE_WORDS, LifeWords
from rolamento.report.numbers import ABSENT
from rolamento.report.page import Lines, Page
from rolamento.words import Note, speaking

if TYPE_CHECKING:
    from rolamento.life import Change, Headline, LifeSummary
    from rolamento.solved import Solved

_LONGEST: Final = 1e8
"""From which a life is written by its order of magnitude."""
_SHORTEST: Final = 1e-4
_LEAST_PERCENT, _MOST_PERCENT = 0.1, 99.9
_KILO: Final = 1e3
_HOUR: Final = 3600.0
_WORTH: Final = 1.05

Sentence = tuple[str, str]
"""What is said, and its style."""


def said_of(page: Page) -> LifeWords:
    """Return what is said of life in the page's language."""
    return LIFE_WORDS.get(page.words.code, LIFE_WORDS["en"])


def significant(value: float, digits: int = 3) -> float:
    """Round to so many significant digits."""
    if value == 0.0 or not isfinite(value):
        return value
    return round(value, digits - 1 - floor(log10(abs(value))))


def life_text(page: Page, value: float) -> str:
    """Write a life in hours or millions of revolutions: three digits, or that it has no end."""
    if value == float("inf"):
        return said_of(page).endless
    if not isfinite(value):
        return ABSENT
    if value >= _LONGEST or 0.0 < value < _SHORTEST:
        mantissa, _, exponent = f"{value:.2e}".partition("e")
        return f"{mantissa.replace('.', page.words.decimal_mark)}e{int(exponent)}"
    rounded = significant(value)
    decimals = max(2 - floor(log10(rounded)), 0) if rounded > 0.0 else 0
    return page.digits.fixed(rounded, decimals)


def lives_column(page: Page, values: Sequence[float]) -> list[str]:
    """Write lives that stand below each other, their decimal marks in line."""
    cells, mark = [life_text(page, value) for value in values], page.words.decimal_mark
    tails = [
        len(cell) - cell.index(mark) if mark in cell and "e" not in cell else 0 for cell in cells
    ]
    return [cell + " " * (max(tails) - tail) for cell, tail in zip(cells, tails, strict=True)]


def factor_text(page: Page, value: float) -> str:
    """Write a factor with three digits, trailing zeros left out."""
    return page.digits.short(significant(value), 3)


def percent(page: Page, share: float) -> str:
    """Write a share or a reliability that was found, with three digits; nearly sure is not sure."""
    if not isfinite(share):
        return ABSENT
    number = significant(100.0 * share)
    if share < 1.0 and number >= 100.0:
        return said_of(page).more_than.format(value=f"{page.digits.short(_MOST_PERCENT)} %")
    if 0.0 < number < _LEAST_PERCENT:
        return said_of(page).less_than.format(value=f"{page.digits.short(_LEAST_PERCENT)} %")
    return f"{page.digits.short(number, 3)} %"


def given_percent(page: Page, share: float) -> str:
    """Write a reliability that was given, with all its digits."""
    return f"{page.digits.short(100.0 * share, 7)} %"


def unit_of_force(values: Sequence[float]) -> tuple[float, str]:
    """Return factor and unit of forces that stand below each other; values in N."""
    greatest = max((abs(value) for value in values if isfinite(value)), default=0.0)
    return (1.0 / _KILO, "kN") if greatest >= _KILO else (1.0, "N")


def force_text(page: Page, value: float) -> str:
    """Write a force in its unit, with four digits and no more than three decimals."""
    return page.digits.short(round(significant(value, 4), 3), 4)


# --- notes ------------------------------------------------------------------------------------


def remarks(page: Page, found: Iterable[tuple[str, str, str]], count: int) -> Lines:
    """List what refuses theories, then what they leave out.

    Parameters
    ----------
    page
        What is written on.
    found
        Theory, name of the note, and where it is true, if not everywhere.
    count
        How many theories there are.
    """
    said = said_of(page)
    about: dict[tuple[str, str], list[str]] = {}
    for theory, name, place in found:
        about.setdefault((name, place), []).append(theory)
    lines: Lines = []
    for name, place in sorted(about, key=lambda key: key[0] not in OUTSIDE):
        theories = about[name, place]
        every = len(theories) == count > 1
        named = said.every_theory if every else "; ".join(said.names[t] for t in theories)
        named += f", {place}" if place else ""
        if name in OUTSIDE:
            text = said.fails_for.format(theories=named, reason=note_text(page, name))
            lines += page.hanging(page.text("  ✗ ", "yellow"), text, "yellow")
        else:
            lines += page.hanging(page.text("  • ", "yellow"), f"{named}: {note_text(page, name)}")
    return lines


def note_text(page: Page, key: str) -> str:
    """Say a note of a life in the page's language."""
    with speaking(page.words.code):
        return Note(key).text


def verdict(page: Page, valid: bool, below: bool) -> Text:
    """Say in a word whether a theory is valid, or gives an upper bound of the life."""
    said = said_of(page)
    if below:
        return page.text(said.bound, "green" if valid else "yellow")
    return page.text(said.holds, "green") if valid else page.text(said.fails, "yellow")


# --- the statement ----------------------------------------------------------------------------


def statement(
    page: Page, solved: Solved, summary: LifeSummary, changes: Sequence[Change] | None = None
) -> Lines:
    """State the life that leads, or its bound and the reason; warn if nothing does.

    changes: what would help; None where nobody looked, and what costs most is told instead.
    """
    leading = summary.headline
    if not leading.leads[0]:
        sentences = _warning(page, summary)
    elif isinf(leading.life[0]):
        sentences = [_endless(page, solved, leading), *_required(page, summary)]
    else:
        sentences = [_life(page, solved, leading), *_left_out(page, leading)]
        sentences += [*_limit(page, solved, summary), *_help(page, summary, changes)]
        sentences += _required(page, summary)
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


def required_sentence(page: Page, wanted: float, reliability: float, *, below: bool = False) -> str:
    """Say with which reliability a required life (s) is reached, or below which."""
    said = said_of(page)
    return (said.wanted_below if below else said.wanted).format(
        life=life_text(page, wanted / _HOUR), reliability=percent(page, reliability)
    )


def _life(page: Page, solved: Solved, leading: Headline) -> Sentence:
    theory, life, hours = str(leading.theory[0]), float(leading.life[0]), float(leading.hours[0])
    what, below = _what(page, solved), bool(leading.below[0])
    return reached(page, theory, life, hours, leading.reliability, what, below=below), "bold"


def _endless(page: Page, solved: Solved, leading: Headline) -> Sentence:
    """Say that fatigue ends no such life."""
    said, theory = said_of(page), str(leading.theory[0])
    return said.endless_life.format(what=_what(page, solved), theory=said.long[theory]), "bold"


def _what(page: Page, solved: Solved) -> str:
    return said_of(page).several if solved.case.bearing.is_set else said_of(page).one


def _limit(page: Page, solved: Solved, summary: LifeSummary) -> list[Sentence]:
    said, race = said_of(page), str(summary.limit.race[0])
    if not race:
        return []
    template = said.limit_of_row if solved.case.bearing.is_set else said.limit
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


def _required(page: Page, summary: LifeSummary) -> list[Sentence]:
    """Say how reliable the required life is, if there is one and the theory for it is valid."""
    wanted = summary.conditions.wanted_life
    if wanted is None:
        return []
    reliability = float(summary.reliability_after(wanted)[0])
    if not isfinite(reliability):
        return []
    below = bool(summary.headline.below[0])
    return [(required_sentence(page, wanted, reliability, below=below), "")]


def _left_out(page: Page, leading: Headline) -> list[Sentence]:
    """Say why the life is but a bound, or that oil and dirt are not in it."""
    said = said_of(page)
    if leading.below[0]:
        return [(note_text(page, str(leading.reason[0])), "yellow")]
    if leading.theory[0] == MODIFIED_REFERENCE.name:
        return []
    return [(said.lubrication_left_out, "dim")]


def _warning(page: Page, summary: LifeSummary) -> list[Sentence]:
    """Say that there is no life to go by, why not, and what the numbers are."""
    said = said_of(page)
    best = summary.theories.get(MODIFIED_REFERENCE.name, summary[REFERENCE.name])
    keys = [note.key for note in best.notes_of() if note.key in OUTSIDE - BOUNDS]
    if "unloaded" in keys:
        return [(note_text(page, "unloaded"), "bold")]
    reasons = [note_text(page, key) for key in keys]
    found = [(said.none_holds, "bold red"), *((reason, "") for reason in reasons)]
    if any(isfinite(float(life.life[0])) for life in summary.theories.values()):
        found.append((said.not_to_be_used, "bold"))
    return found
