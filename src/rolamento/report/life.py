"""The page of a life: a statement, all theories side by side, what it rests on; JSON of it."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees, isfinite, isnan
from typing import TYPE_CHECKING, Final

from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.life.theories import THEORIES
from rolamento.report.language import ENGLISH, Words
from rolamento.report.life_statement import (
    cost_text,
    factor_text,
    force_text,
    given_percent,
    life_text,
    lives_column,
    note_text,
    percent,
    remarks,
    said_of,
    statement,
    unit_of_force,
    verdict,
)
from rolamento.report.numbers import aligned
from rolamento.report.page import Lines, Page, notes_part, rendered
from rolamento.report.plain_data import json_text
from rolamento.report.terminal import terminal_head

if TYPE_CHECKING:
    from rolamento.life import Change, Life, LifeSummary
    from rolamento.solved import Solved

SCHEMA: Final = 2
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
_BAR: Final = 24
"""Characters of the greatest gain."""
_FULL, _PLAIN = "█", "#"
_GAP: Final = "  "


def life_report(
    solved: Solved,
    summary: LifeSummary | None,
    changes: Sequence[Change] = (),
    words: Words = ENGLISH,
    medium: Medium | None = None,
) -> str:
    """Return the life of one case as text that ends in a newline.

    Parameters
    ----------
    solved
        What was solved: a single case.
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
    parts = [terminal_head(page, solved)]
    if summary is not None:
        parts += [
            [page.heading(said_of(page).life), *statement(page, solved, summary, changes)],
            theories_part(page, summary),
            validity_part(page, summary),
            ratings_part(page, summary),
            limit_part(page, solved, summary),
        ]
        parts += [part for part in [changes_part(page, summary, changes)] if part]
    notes = [words.note(note) for note in solved.notes[0]]
    if notes:
        parts.append(notes_part(page, notes))
    return rendered(page.medium, parts)


def theories_part(page: Page, summary: LifeSummary) -> Lines:
    """Set the theories side by side: lives, factors, and whether each is valid for the case."""
    said = said_of(page)
    leading = summary.headline
    chosen = summary.theories.get(str(leading.theory[0])) if leading.leads[0] else None
    lives = list(summary.theories.values())
    factors = [
        (head, name) for head, name in _FACTORS if any(name in life.factors for life in lives)
    ]
    lines = _theory_rows(page, lives, factors, chosen)
    if max(map(len, lines)) > page.medium.width:  # κ and e_C are the same for all of them
        lines = _theory_rows(
            page, lives, [own for own in factors if own not in _CONDITIONS], chosen
        )
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


def _theory_rows(
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
        style = "bold" if own else "" if life.valid[0] or life.below[0] else "dim"
        cells_ = [page.text(column[index], style) for _, column in columns]
        sign = page.text(_CHOSEN if own else " ", "bold green")
        rows.append(
            [
                sign,
                page.text(name, style),
                *cells_,
                verdict(page, bool(life.valid[0]), bool(life.below[0])),
            ]
        )
    table = page.columns(rows, "ll" + "r" * len(columns) + "l")
    return [_closer(line) for line in table]


def _closer(line: Text) -> Text:
    """Take one space of the gap behind the mark, which is narrow."""
    return Text.assemble(line[1:3], line[4:])


def validity_part(page: Page, summary: LifeSummary) -> Lines:
    """Say what every theory is for, then what stands against it here, and what it leaves out."""
    said, lives = said_of(page), list(summary.theories.values())
    width = max(len(said.names[life.theory]) for life in lives)
    lines = [page.heading(said.validity)]
    for life in lives:
        label = page.text(f"  {said.names[life.theory]:{width}}  ")
        lines += page.hanging(label, said.valid[life.theory], "dim")
    found = [(life.theory, name, "") for life in lives for name in _keys(life)]
    return lines + remarks(page, found, len(lives))


# --- what it rests on --------------------------------------------------------------------------


def ratings_part(page: Page, summary: LifeSummary) -> Lines:
    """Show ratings with their sources, and the loads that stand against them."""
    said, ratings, loads = said_of(page), summary.ratings, summary.loads
    sources = summary.rating_sources
    load, static = float(loads.dynamic[0]), float(loads.static[0])
    entries = [
        ("C", ratings.dynamic_of_set, _source_text(page, sources["dynamic"], "dynamic")),
        ("C_0", ratings.static_of_set, _source_text(page, sources["static"], "static")),
        ("C_u", ratings.fatigue_of_set, _source_text(page, sources["fatigue"], "fatigue")),
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
    reference = float(summary.reference_load[0])
    if isfinite(reference):
        shown.append(("P_ref", reference, said.reference_load))
    return [page.heading(said.ratings), *_force_rows(page, shown)]


def _source_text(page: Page, source: str, rating: str) -> str:
    """Say where a rating comes from; what is no word of the engine is the catalogue's source."""
    said = said_of(page)
    if source == "geometry":
        return said.sources[rating]
    return said.sources.get(source, source)


def _force_rows(page: Page, shown: Sequence[tuple[str, float, str]]) -> Lines:
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


def limit_part(page: Page, solved: Solved, summary: LifeSummary) -> Lines:
    """Name the race with the greatest part of the risk, its heaviest ball, and what costs most."""
    said, limit = said_of(page), summary.limit
    race = str(limit.race[0])
    if not race:
        reason = page.hanging(Text("  "), note_text(page, "unloaded"))
        return [page.heading(said.limits), *reason]
    template = said.share_of_row if solved.case.bearing.is_set else said.share_of_risk
    share = percent(page, float(limit.share[0]))
    texts = [template.format(race=said.races[race], row=int(limit.row[0]), share=share)]
    number = int(limit.ball[0])
    if number >= 0:
        contacts = solved.inner if race == "inner" else solved.outer
        texts.append(
            said.heaviest.format(
                ball=number,
                azimuth=page.digits.short(round(degrees(solved.elements.azimuth[0, number]), 2), 5),
                load=page.digits.short(float(contacts.load[0, number]), 4),
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
            page.text(page.words.note(change.note)),
            page.text(ratio, "bold" if change.life_ratio > 1.0 else ""),
        ]
        for change, ratio in zip(known, ratios, strict=True)
    ]
    table = page.columns(cells, "lr")
    room = min(page.medium.width - len(table[0]) - len(_GAP), _BAR)
    rows = [
        Text.assemble(
            line, _GAP, page.text(_gain_bar(page, change.life_ratio - 1.0, greatest, room), "green")
        )
        for line, change in zip(table, known, strict=True)
    ]
    legend = said.changes_legend.format(theory=said.long[str(summary.headline.theory[0])])
    lines = [page.heading(said.changes_heading), *rows]
    return lines + page.hanging(Text("  "), legend, "dim")


def _gain_bar(page: Page, gain: float, greatest: float, room: int) -> str:
    """Draw a gain, the greatest as long as there is room."""
    if gain <= 0.0 or greatest <= 0.0 or room <= 0:
        return ""
    sign = _FULL if page.medium.draws else _PLAIN
    return sign * max(round(room * gain / greatest), 1)


# --- beside the state of a bearing -------------------------------------------------------------


def life_part(page: Page, solved: Solved, summary: LifeSummary) -> Lines:
    """Show the statement, the lives by the standards, and how far the loads are from the ratings.

    All theories and what would help are for a report of their own.
    """
    said, loads = said_of(page), summary.loads
    turns = any(not isnan(life.hours[0]) for life in summary.theories.values())
    numbers = [
        f"{said.names[name]}: {_bounded(page, life, float(value[0]))} {unit}"
        for name, life in _standard_lives(summary).items()
        for value, unit in [(life.hours, said.hour) if turns else (life.life, said.million)]
        if not isnan(value[0])
    ]
    load = float(loads.dynamic[0])
    if load > 0.0:
        ratio = factor_text(page, float(summary.ratings.dynamic_of_set[0]) / load)
        numbers.append(said.load_ratio.format(ratio=ratio))
    if isfinite(loads.safety[0]):
        numbers.append(said.static_safety.format(safety=factor_text(page, float(loads.safety[0]))))
    lines = [page.heading(said.life), *statement(page, solved, summary)]
    if numbers:
        lines += page.hanging(Text("  "), "; ".join(numbers))
    return lines + page.hanging(Text("  "), said.all_lives, "dim")


def _bounded(page: Page, life: Life, value: float) -> str:
    """Write a life, with a sign where it is below the number."""
    return f"<{life_text(page, value)}" if life.below[0] else life_text(page, value)


def life_notes(page: Page, summary: LifeSummary) -> list[str]:
    """Return what is to be known of the lives that are shown, each said once."""
    keys = [key for life in _standard_lives(summary).values() for key in _keys(life)]
    return [note_text(page, key) for key in dict.fromkeys(keys)]


def _keys(life: Life) -> list[str]:
    return [note.key for note in life.notes_of()]


def _standard_lives(summary: LifeSummary) -> dict[str, Life]:
    return {name: life for name, life in summary.theories.items() if THEORIES[name].standard}


# --- data --------------------------------------------------------------------------------------


def life_json(solved: Solved, summary: LifeSummary | None, changes: Sequence[Change] = ()) -> str:
    """Return the life of one case as one JSON object, SI units, hours, millions of revolutions."""
    of_case = solved.to_mapping()
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "life",
            **{name: of_case[name] for name in ("title", "status", "notes", "case")},
            "life": None if summary is None else summary.to_mapping(),
            "sensitivity": [
                {
                    "change": change.name,
                    "life_ratio": change.life_ratio,
                    "what": change.note.to_mapping(),
                }
                for change in changes
            ],
        }
    )
