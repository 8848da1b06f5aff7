"""The page of `life` for several bearings on one shaft: of each, and of all together."""

from __future__ import annotations

from collections.abc import Sequence
from math import isnan
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.document import (
    Block,
    Break,
    CellContent,
    Column,
    Document,
    Notes,
    Number,
    Remark,
    Section,
    Statement,
    Table,
    Tone,
)
from rolamento.life.theories import THEORIES
from rolamento.pages.life import LONGEST_LIFE, formulas_only, none_valid, percent, remarks
from rolamento.units import HOUR
from rolamento.words import Note, said
from rolamento.words.headlines import qualifies
from rolamento.words.naming import shortened
from rolamento.words.reasons import why_not
from rolamento.words.theories import theory_heads, theory_life

if TYPE_CHECKING:
    from rolamento.life.system import SystemLife
    from rolamento.tasks.life import ShaftLife

__all__ = ["shaft_page", "together_sentences", "together_statement"]

_LONGEST_NAME: Final = 22


def shaft_page(found: ShaftLife, names: Sequence[str]) -> Document:
    """Return the page of the lives of several bearings.

    Parameters
    ----------
    found
        Of `rolamento.tasks.life.life_of_shaft`.
    names
        Of the bearings: their titles, or files.
    """
    heading = said("Life of {count} bearings on one shaft", count=len(found))
    sections = [Section(heading, _statement(found), "life")]
    if found.theories:
        sections.append(Section("", (_table(found, names), *_remarks(found)), "bearings"))
    return Document(heading, tuple(sections), kind="shaft_life")


def _theories(leading: SystemLife) -> str:
    """Name the theories of the lives that lead, each once."""
    names = dict.fromkeys(name for name in leading.theories if name)
    return "; ".join(map(theory_life, names))


def _statement(found: ShaftLife) -> tuple[Block, ...]:
    leading = found.headline
    sentences: list[tuple[str, Tone]] = []
    if not found.converged:
        none = said("Without a result of every bearing there is no life of the shaft.")
        sentences.append((none, "bad-strong"))
        sentences += [(text, "bad") for text in _failures(found)]
    elif not (leading.valid or leading.below):
        none = none_valid("ball" if _elements(found) <= {"ball"} else "element")
        sentences += [(none, "bad-strong"), (formulas_only(), "strong")]
    elif np.isnan(leading.hours):
        text = said("Nothing turns at one of the bearings: there are no hours.")
        sentences.append((text, "warning"))
    else:
        sentences += _reached(found)
    statements = tuple(Statement(text, tone, indent=2) for text, tone in sentences)
    return (*statements, *_cautions(found))


def _cautions(found: ShaftLife) -> tuple[Notes, ...]:
    """Say what qualifies the lives, and of which bearings; of all if none is named."""
    numbers: dict[Note, list[int]] = {}
    for number, (solved, own) in enumerate(zip(found.bearings, found.lives, strict=True), start=1):
        leading = () if own is None else own.qualifications()
        for note in dict.fromkeys((*leading, *filter(qualifies, solved.notes[0]))):
            numbers.setdefault(note, []).append(number)
    remarks = []
    for note, own_numbers in numbers.items():
        text = note.text
        if len(own_numbers) < len(found):
            text = said("bearing {number}: {reason}", number=own_numbers, reason=text)
        remarks.append(Remark(text, note.key, "warning"))
    return (Notes(tuple(remarks)),) if remarks else ()


def _failures(found: ShaftLife) -> list[str]:
    texts = []
    for number, solved in enumerate(found.bearings, start=1):
        if not solved.converged[0]:
            why = why_not(solved, advised=True)
            texts.append(said("bearing {number}: {reason}", number=number, reason=why))
    return texts


def _reached(found: ShaftLife) -> list[tuple[str, Tone]]:
    numbers = range(1, len(found) + 1)
    return together_sentences(found.headline, found.reliability, numbers)


def together_sentences(
    leading: SystemLife, reliability: float, bearings: Sequence[int | str]
) -> list[tuple[str, Tone]]:
    """Say what bearings reach together, and which limits it; bearings: names or numbers."""
    values = {
        "reliability": reliability,
        "count": len(bearings),
        "hours": leading.hours * HOUR,
        "theory": _theories(leading),
    }
    if leading.below:
        text = said(
            "With {reliability:.7 %} reliability the {count} bearings together reach less than "
            "{hours:.3r h} (upper bound of the {theory}).",
            **values,
        )
    elif leading.hours > LONGEST_LIFE:
        text = said(
            "With {reliability:.7 %} reliability the {count} bearings together reach more than "
            "{hours:.3r h} ({theory}).",
            **{**values, "hours": LONGEST_LIFE * HOUR},
        )
    else:
        text = said(
            "With {reliability:.7 %} reliability the {count} bearings together reach "
            "{hours:.3r h} ({theory}).",
            **values,
        )
    sentences: list[tuple[str, Tone]] = [(text, "strong")]
    if np.all(np.isfinite(leading.risk)):
        most = int(np.argmax(leading.risk))
        limit = said(
            "Bearing {number} limits it: it contributes {share} of the failure probability.",
            number=bearings[most],
            share=percent(float(leading.risk[most])),
        )
        sentences.append((limit, ""))
    return sentences


def together_statement(together: SystemLife, reliability: float) -> tuple[Block, ...]:
    """Say what bearings reach together under a spectrum, and which of them limits it."""
    if np.isnan(together.hours):
        none = said("Without a result of every bearing there is no life of the shaft.")
        return (Statement(none, "bad-strong", indent=2),)
    if not (together.valid or together.below):
        return (Statement(none_valid("element"), "bad-strong", indent=2),)
    numbers = range(1, len(together.theories) + 1)
    sentences = together_sentences(together, reliability, numbers)
    return tuple(Statement(text, tone, indent=2) for text, tone in sentences)


def _table(found: ShaftLife, names: Sequence[str]) -> Table:
    """Set bearings below each other, theories side by side, all together at the foot."""
    shown = [name for name in found.theories if not THEORIES[name].bound]  # of parts say little
    order = sorted(shown, key=lambda name: not THEORIES[name].standard)
    tones: list[Tone] = [""] * len(names)
    tones.append("strong")
    columns = [
        Column("", [*range(1, len(found) + 1), ""], "number", tone="faint", align="right"),
        Column(
            "",
            [*(shortened(name, _LONGEST_NAME) for name in names), said("together")],
            "bearing",
            tones=tones,
        ),
        *(_hours_column(found, name) for name in order),
    ]
    risk = [_share(float(share)) for share in found.headline.risk]
    columns.insert(
        2 + sum(THEORIES[name].standard for name in order),
        Column(said("failure\nshare"), [*risk, ""], "failure_share", "%", align="right"),
    )
    first = 3 + sum(THEORIES[name].standard for name in order)
    values = {"reliability": found.reliability, "theory": _theories(found.headline)}
    if _elements(found) <= {"ball"}:
        legend = said(
            "for {reliability:.7 %} reliability, of each bearing and of all together (Weibull "
            "slope 10/9); share of each in the failure probability, by the {theory}; * the theory "
            "is not valid there, < the life is below",
            **values,
        )
    else:
        legend = said(
            "for {reliability:.7 %} reliability, of each bearing and of all together (Weibull "
            "slope 10/9 of ball bearings, 9/8 of roller bearings); share of each in the failure "
            "probability, by the {theory}; * the theory is not valid there, < the life is below",
            **values,
        )
    return Table(
        tuple(columns),
        "bearings",
        legends=(legend,),
        fixed=2,
        breaks=(Break(first, ""),) if first < len(columns) else (),
    )


def _share(share: float) -> Number:
    """Write a share in the failure probability; nearly all is not all."""
    if 0.9995 <= share < 1.0:
        return Number(0.999, ".3 [%]", before="> ")
    if 0.0 < share < 0.001:
        return Number(0.001, ".3 [%]", before="< ")
    return Number(share, ".3 [%]")


def _hours_column(found: ShaftLife, name: str) -> Column:
    """Hours of each bearing by a theory, and of all together; marked where they are not valid."""
    whole = found[name]
    valid = [own is not None and bool(own[name].valid[0]) for own in found.lives]
    below = [own is not None and bool(own[name].below[0]) for own in found.lives]
    fine = all(held or bound for held, bound in zip(valid, below, strict=True))
    values: list[CellContent] = []
    tones: list[Tone] = []
    for hours, held, bound in zip(
        [*whole.bearing_hours.tolist(), whole.hours],
        [*valid, fine],
        [*below, whole.below],
        strict=True,
    ):
        mark = " " if held or bound or isnan(hours) else "*"
        values.append(Number(hours * HOUR, ".3r [h]", "<" if bound else "", mark))
        tones.append("" if held and not bound else "warning")
    tones[-1] = "strong"
    head = "\n".join(f"{word} " for word in theory_heads(name))
    return Column(head, values, name, "h", tones=tones, align="right")


def _elements(found: ShaftLife) -> set[str]:
    """What rolls in the bearings that have a life."""
    return {own.headline.element for own in found.lives if own is not None}


def _remarks(found: ShaftLife) -> tuple[Block, ...]:
    """Say what stands against the theories, and of which bearings; of all if none is named."""
    numbers: dict[tuple[str, Note], list[int]] = {}
    for number, summary in enumerate(found.lives, start=1):
        for life in () if summary is None else summary.theories.values():
            for note in () if THEORIES[life.theory].bound else life.notes_of():
                numbers.setdefault((life.theory, note), []).append(number)
    notes = [
        (theory, note, "" if len(own) == len(found) else said("bearing {numbers}", numbers=own))
        for (theory, note), own in numbers.items()
    ]
    return remarks(notes, sum(not THEORIES[name].bound for name in found.theories))
