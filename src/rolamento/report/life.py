"""Life in the report: a plain statement, all theories side by side, and what each is for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from rich.text import Text

from rolamento.report.language import ENGLISH, Words
from rolamento.report.life_details import changes_part, limit_part, ratings_part
from rolamento.report.life_numbers import factor_text, given_percent, lives_column, said_of
from rolamento.report.life_remarks import remarks, verdict
from rolamento.report.life_statement import statement
from rolamento.report.medium import Medium
from rolamento.report.numbers import aligned
from rolamento.report.page import Lines, Page
from rolamento.report.terminal import notes_part, rendered, terminal_head

if TYPE_CHECKING:
    from rolamento.life import Change, Life, LifeSummary
    from rolamento.state import State

__all__ = ["life_report", "theories_part", "validity_part"]

_FACTORS: Final = (
    ("a_1", "a_1"),
    ("a_ISO", "a_iso"),
    ("a_2", "a_2"),
    ("a_3", "a_3"),
    ("a_NSK", "a_nsk"),
    ("κ", "viscosity_ratio"),
    ("e_C", "contamination_factor"),
)
"""Of the table: heading, and name in the engine. The last two are no factors of the life."""
_CONDITIONS: Final = _FACTORS[-2:]
_CHOSEN: Final = "▸"


def life_report(
    state: State,
    summary: LifeSummary | None,
    changes: Sequence[Change] = (),
    words: Words = ENGLISH,
    medium: Medium | None = None,
) -> str:
    """Return the life of one case as text that ends in a newline.

    Parameters
    ----------
    state
        What was solved.
    summary
        Its life by every theory; None without a result.
    changes
        What would help, of `rolamento.life.sensitivity`.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page = Page(words, medium or Medium())
    parts = [terminal_head(page, state)]
    if summary is not None:
        parts += [
            [page.heading(said_of(page).life), *statement(page, state, summary, changes)],
            theories_part(page, summary),
            validity_part(page, summary),
            ratings_part(page, summary),
            limit_part(page, state, summary),
        ]
        parts += [part for part in [changes_part(page, summary, changes)] if part]
    notes = [words.note(note) for note in state.notes]
    if notes:
        parts.append(notes_part(page, notes))
    return rendered(page.medium, parts)


def theories_part(page: Page, summary: LifeSummary) -> Lines:
    """Set the theories side by side: lives, factors, and whether each holds for the case."""
    said = said_of(page)
    leading = summary.headline
    chosen = summary.theories.get(str(leading.theory[0])) if leading.leads[0] else None
    lives = _in_order(page, summary)
    factors = [
        (head, name) for head, name in _FACTORS if any(name in life.factors for life in lives)
    ]
    lines = _table(page, lives, factors, chosen)
    if max(map(len, lines)) > page.medium.width:  # κ and e_C are the same for all of them
        lines = _table(page, lives, [own for own in factors if own not in _CONDITIONS], chosen)
        lines += page.hanging(Text("  "), _conditions(page, lives))
    legend = said.legend.format(reliability=given_percent(page, lives[0].reliability))
    legend += said.bounds if any(life.below[0] for life in lives) else ""
    legend += "" if chosen is None else said.chosen
    return [page.heading(said.theories), *lines, *page.hanging(Text("  "), legend, "dim")]


def _conditions(page: Page, lives: Sequence[Life]) -> str:
    """Write κ and e_C, which no theory has otherwise than the others."""
    found = {
        head: factor_text(page, float(life.factors[name][0]))
        for head, name in _CONDITIONS
        for life in lives
        if name in life.factors
    }
    return ", ".join(f"{head} = {text}" for head, text in found.items())


def _in_order(page: Page, summary: LifeSummary) -> list[Life]:
    return [summary[name] for name in said_of(page).names if name in summary.theories]


def _table(
    page: Page, lives: Sequence[Life], factors: Sequence[tuple[str, str]], chosen: Life | None
) -> Lines:
    said, mark = said_of(page), page.words.decimal_mark
    names = [said.names[life.theory] for life in lives]
    columns: list[tuple[str, list[str]]] = [
        (said.million, lives_column(page, [float(life.life[0]) for life in lives])),
        (said.hour, lives_column(page, [float(life.hours[0]) for life in lives])),
    ]
    for head, name in factors:
        cells = [
            factor_text(page, float(life.factors[name][0])) if name in life.factors else ""
            for life in lives
        ]
        columns.append((head, aligned(cells, mark)))
    rows = [[Text(), Text(), *(page.text(head, "dim") for head, _ in columns), Text()]]
    rows[0][-1] = page.text(said.holds_here, "dim")
    for index, (life, name) in enumerate(zip(lives, names, strict=True)):
        own = life is chosen
        style = "bold" if own else "" if life.holds[0] or life.below[0] else "dim"
        cells_ = [page.text(column[index], style) for _, column in columns]
        sign = page.text(_CHOSEN if own else " ", "bold green")
        rows.append(
            [
                sign,
                page.text(name, style),
                *cells_,
                verdict(page, bool(life.holds[0]), bool(life.below[0])),
            ]
        )
    table = page.columns(rows, "ll" + "r" * len(columns) + "l")
    return [_closer(line) for line in table]


def _closer(line: Text) -> Text:
    """Take one space of the gap behind the mark, which is narrow."""
    return Text.assemble(line[1:3], line[4:])


def validity_part(page: Page, summary: LifeSummary) -> Lines:
    """Say what every theory is for, then what stands against it here, and what it leaves out."""
    said, lives = said_of(page), _in_order(page, summary)
    width = max(len(said.names[life.theory]) for life in lives)
    lines = [page.heading(said.validity)]
    for life in lives:
        label = page.text(f"  {said.names[life.theory]:{width}}  ")
        lines += page.hanging(label, said.valid[life.theory], "dim")
    found = [(life.theory, name, "") for life in lives for name in life.notes_of()]
    return lines + remarks(page, found, len(lives))
