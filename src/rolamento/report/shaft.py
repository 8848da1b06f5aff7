"""The life of several bearings on one shaft for a reader; JSON of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.life.theories import FIRST_LEFT_OUT, THEORIES
from rolamento.report.language import ENGLISH, Words
from rolamento.report.life_statement import (
    given_percent,
    life_text,
    lives_column,
    percent,
    remarks,
    said_of,
)
from rolamento.report.page import Lines, Page, rendered
from rolamento.report.plain_data import json_text

if TYPE_CHECKING:
    from rolamento.tasks.life import ShaftLife, SystemLife

__all__ = ["shaft_json", "shaft_report"]

SCHEMA: Final = 2
_SHORTEST_NAME, _LONGEST_NAME = 12, 30
_NUMBER_WIDTH: Final = 6
"""Of the first column, with the gaps beside it."""


@dataclass(frozen=True, slots=True)
class _Words:
    heading: str
    reaches: str
    reaches_less: str
    limit: str
    no_life: str
    no_hours: str
    system: str
    risk: str
    legend: str
    left_out: str
    failed: str
    of_bearing: str


_WORDS: Final[Mapping[str, _Words]] = {
    "en": _Words(
        heading="Life of {count} bearings on one shaft, in hours",
        reaches=(
            "With {reliability} reliability the {count} bearings together reach {hours} h"
            " ({theory})."
        ),
        reaches_less=(
            "With {reliability} reliability the {count} bearings together reach less than {hours} h"
            " (bound of the {theory})."
        ),
        limit="Bearing {number} limits it, with {share} of the risk.",
        no_life="Without a result of every bearing there is no life of the shaft.",
        no_hours="Nothing turns at one of them: there are no hours.",
        system="together",
        risk="risk",
        legend=(
            "for {reliability} reliability, of each bearing and of all together (Weibull slope"
            " 10/9); risk: share of each, by the {theory}; * the theory does not hold"
            " there, < the life is below"
        ),
        left_out="no room here, but in --json: {names}",
        failed="bearing {number}: {reason}",
        of_bearing="bearing {numbers}",
    ),
    "pt": _Words(
        heading="Vida de {count} rolamentos num eixo, em horas",
        reaches=(
            "Com {reliability} de confiabilidade os {count} rolamentos juntos atingem {hours} h"
            " ({theory})."
        ),
        reaches_less=(
            "Com {reliability} de confiabilidade os {count} rolamentos juntos atingem menos de"
            " {hours} h (limite superior da {theory})."
        ),
        limit="O rolamento {number} a limita, com {share} do risco.",
        no_life="Sem resultado de todos os rolamentos não há vida do eixo.",
        no_hours="Num deles nada gira: não há horas.",
        system="juntos",
        risk="risco",
        legend=(
            "para {reliability} de confiabilidade, de cada rolamento e de todos juntos (inclinação"
            " de Weibull 10/9); risco: parte de cada um, pela {theory}; * a teoria não"
            " vale ali, < a vida está abaixo"
        ),
        left_out="sem lugar aqui, mas em --json: {names}",
        failed="rolamento {number}: {reason}",
        of_bearing="rolamento {numbers}",
    ),
}


def shaft_report(
    found: ShaftLife,
    names: Sequence[str],
    words: Words = ENGLISH,
    medium: Medium | None = None,
) -> str:
    """Return the lives of several bearings as text that ends in a newline.

    Parameters
    ----------
    found
        Of `rolamento.tasks.life.life_of_shaft`.
    names
        Of the bearings: their titles, or files.
    words
        The language.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    page = Page(words, medium or Medium())
    own = _WORDS.get(words.code, _WORDS["en"])
    parts = [_statement(page, own, found)]
    if found.theories:
        parts.append([*_bearing_table(page, own, found, names), *_remarks(page, own, found)])
    return rendered(page.medium, parts)


def _theories(page: Page, found: ShaftLife) -> str:
    """Name the theories of the lives that lead, each once."""
    names = dict.fromkeys(name for name in found.headline.theories if name)
    return "; ".join(said_of(page).long[name] for name in names)


def _statement(page: Page, own: _Words, found: ShaftLife) -> Lines:
    said, leading = said_of(page), found.headline
    sentences: list[tuple[str, str]] = []
    if not found.converged:
        sentences.append((own.no_life, "bold red"))
        for number, solved in enumerate(found.bearings, start=1):
            if not solved.converged[0]:
                parts = (page.words.reason(solved), page.words.advice(solved))
                reason = ": ".join(part for part in parts if part)
                sentences.append((own.failed.format(number=number, reason=reason), "red"))
    elif not (leading.valid or leading.below):
        sentences += [(said.none_holds, "bold red"), (said.not_to_be_used, "bold")]
    elif np.isnan(leading.hours):
        sentences.append((own.no_hours, "yellow"))
    else:
        sentences += _reached(page, own, found)
    lines = [page.heading(own.heading.format(count=len(found)))]
    for text, style in sentences:
        lines += page.hanging(Text("  "), text, style)
    return lines


def _reached(page: Page, own: _Words, found: ShaftLife) -> list[tuple[str, str]]:
    leading = found.headline
    text = (own.reaches_less if leading.below else own.reaches).format(
        reliability=given_percent(page, found.reliability),
        count=len(found),
        hours=life_text(page, leading.hours),
        theory=_theories(page, found),
    )
    risk = leading.risk
    if not np.all(np.isfinite(risk)):
        return [(text, "bold")]
    most = int(np.argmax(risk))
    limit = own.limit.format(number=most + 1, share=percent(page, float(risk[most])))
    return [(text, "bold"), (limit, "")]


def _bearing_table(page: Page, own: _Words, found: ShaftLife, names: Sequence[str]) -> Lines:
    """Set bearings below each other, theories side by side, all together at the foot."""
    said = said_of(page)
    columns = {
        name: _hours_column(page, found, name)
        for name in found.theories
        if not THEORIES[name].bound  # bounds of parts say little of the whole
    }
    risk = [percent(page, float(share)) for share in found.headline.risk]
    last: Lines = [Text(), page.text(own.risk), *map(page.text, [*risk, ""])]
    left_out = []
    for name in FIRST_LEFT_OUT:
        if name in columns and _room(page, [*columns.values(), last]) < _SHORTEST_NAME:
            del columns[name]
            left_out.append(said.names[name])
    room = min(_room(page, [*columns.values(), last]), _LONGEST_NAME)
    labels = [page.text(_shortened(name, room)) for name in names]
    first = [
        [Text(), Text(), *(page.text(str(n + 1), "dim") for n in range(len(found))), Text()],
        [Text(), Text(), *labels, page.text(own.system, "bold")],
    ]
    rows = list(zip(*first, *columns.values(), last, strict=True))
    lines = page.columns(rows, "rl" + "r" * (len(columns) + 1))
    if left_out:
        lines += page.hanging(Text("  "), own.left_out.format(names="; ".join(left_out)), "dim")
    legend = own.legend.format(
        reliability=given_percent(page, found.reliability), theory=_theories(page, found)
    )
    return lines + page.hanging(Text("  "), legend, "dim")


def _hours_column(page: Page, found: ShaftLife, name: str) -> Lines:
    """A theory's name, the hours of each bearing by it, and of all together."""
    cells = lives_column(page, [*found[name].bearing_hours.tolist(), found[name].hours])
    valid = [s is not None and bool(s[name].valid[0]) for s in found.lives]
    below = [s is not None and bool(s[name].below[0]) for s in found.lives]
    whole = found[name]
    fine = all(h or b for h, b in zip(valid, below, strict=True))
    marks = zip(cells, [*valid, fine], [*below, whole.below], strict=True)
    marked = [_marked(page, *mark) for mark in marks]
    marked[-1].stylize("bold")
    return [*(page.text(f"{word} ") for word in said_of(page).short[name]), *marked]


def _marked(page: Page, cell: str, valid: bool, below: bool) -> Text:
    """A life, with a mark where it is a bound or does not hold."""
    if below:
        return page.text(f"<{cell} ", "yellow")
    return page.text(f"{cell}{' ' if valid else '*'}", "" if valid else "yellow")


def _room(page: Page, columns: Sequence[Lines]) -> int:
    """Characters that are left for the names of the bearings."""
    return page.medium.width - page.width_of(columns) - _NUMBER_WIDTH


def _shortened(name: str, room: int) -> str:
    return name if len(name) <= room else f"{name[: max(room, 2) - 1]}…"


def _remarks(page: Page, own: _Words, found: ShaftLife) -> Lines:
    """Say what stands against the theories, and of which bearings; of all if none is named."""
    numbers: dict[tuple[str, str], list[str]] = {}
    for number, summary in enumerate(found.lives, start=1):
        for life in () if summary is None else summary.theories.values():
            for note in () if THEORIES[life.theory].bound else life.notes_of():
                numbers.setdefault((life.theory, note.key), []).append(str(number))
    notes = [
        (theory, name, "" if len(own_numbers) == len(found) else _place(own, own_numbers))
        for (theory, name), own_numbers in numbers.items()
    ]
    return remarks(page, notes, sum(not THEORIES[name].bound for name in found.theories))


def _place(own: _Words, numbers: Sequence[str]) -> str:
    return own.of_bearing.format(numbers=", ".join(numbers))


def shaft_json(found: ShaftLife, names: Sequence[str]) -> str:
    """Return everything as one JSON object, lives in hours and millions of revolutions."""
    return json_text(
        {
            "schema": SCHEMA,
            "kind": "shaft_life",
            "reliability": found.reliability,
            "bearings": [
                {
                    "name": name,
                    "status": str(solved.status.code[0]),
                    "life": None if summary is None else summary.to_mapping(),
                    "case": solved.case.to_mapping(),
                }
                for name, solved, summary in zip(names, found.bearings, found.lives, strict=True)
            ],
            "headline": {
                "theories": list(found.headline.theories),
                "hours": found.headline.hours if isfinite(found.headline.hours) else None,
                "holds": found.headline.valid,
                "below": found.headline.below,
                "risk": found.headline.risk,
            },
            "together": {name: _together(own) for name, own in found.theories.items()},
        }
    )


def _together(own: SystemLife) -> dict[str, Any]:
    hours = own.hours
    return {
        "hours": hours if isfinite(hours) else None,
        "endless": bool(np.isposinf(hours)),
        "holds": own.valid,
        "risk": own.risk,
    }
