"""The same index as Markdown, for places that show files of a repository."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from html import escape
from typing import Final

from rolamento_reproductions.errata import Errata
from rolamento_reproductions.printed import Cell
from rolamento_reproductions.record import Claim, Figure, Section, Source, Table, TableColumn
from rolamento_reproductions.text import Language, Text, localised, with_indices
from rolamento_reproductions.wording import (
    COMPUTED,
    DATA,
    EXPECTED,
    FIGURE,
    INPUTS,
    MISPRINTS,
    PRINTED,
    REGENERATED,
    TABLE,
    VERDICTS,
    claims_by_kind,
    gap_sentence,
    misprints_sentence,
    summary,
)

__all__ = ["markdown_page", "marked"]

_SPECIAL: Final = re.compile(r"([\\`*\[\]|])")
_AS_PRINTED: Final = ("printed", "tie", "cut")


def markdown_page(
    source: Source, sections: Sequence[Section], endings: Sequence[str], language: Language
) -> str:
    """Write the page; parameters as of `rolamento_reproductions.page.html_page`."""
    parts = [
        f"# {marked(source.title, language)}",
        *(marked(text, language) for text in source.remarks),
        "\n".join(f"- {marked(line, language)}" for line in summary(tuple(sections))),
    ]
    for section in sections:
        parts.append(f"## {marked(section.title, language)}")
        for item in section.items:
            parts += _item(item, endings, language)
    parts.append(f"{REGENERATED.speak(language)} `rolamento reproduce {source.name}`.")
    return "\n\n".join(parts) + "\n"


def _item(
    item: Figure | Table | Errata, endings: Sequence[str], language: Language
) -> Iterable[str]:
    if isinstance(item, Errata):
        return _errata(item, language)
    return _figure(item, endings, language) if isinstance(item, Figure) else _table(item, language)


def _errata(errata: Errata, language: Language) -> Iterable[str]:
    """Name the misprints, and point to the page that has them."""
    yield f"{marked(errata.caption, language)} {marked(misprints_sentence(errata), language)}"
    yield "\n".join(
        f"- {marked(one.place, language)}: {marked(one.what, language)}" for one in errata.misprints
    )
    page, data = MISPRINTS.speak(language), DATA.speak(language)
    yield f"[{page}]({errata.stem}.md), [{data}]({errata.stem}.csv)"


def _figure(figure: Figure, endings: Sequence[str], language: Language) -> Iterable[str]:
    name = f"{FIGURE.speak(language)} {figure.number}"
    yield f"![{name}]({figure.stem}.{endings[0]})"
    yield f"**{name}.** {marked(figure.caption, language)}"
    yield from _remarks(figure, language)


def _table(table: Table, language: Language) -> Iterable[str]:
    name = f"{TABLE.speak(language)} {table.number}"
    yield f"**{name}.** {marked(table.caption, language)}"
    columns = [_column(column, language) for column in table.columns]
    width = sum(len(column[0]) for column in columns)
    rows = [
        "| " + " | ".join(cell for cells in row for cell in cells) + " |"
        for row in zip(*columns, strict=True)
    ]
    yield "\n".join([rows[0], "|" + "---|" * width, *rows[1:]])
    yield from _remarks(table, language)


def _column(column: TableColumn, language: Language) -> list[list[str]]:
    """Return a column of a table, head first, each entry as one cell or two."""
    title = marked(column.title, language)
    if not any(isinstance(cell, Cell) for cell in column.cells):
        texts = (
            cell.speak(language) if isinstance(cell, Text) else localised(str(cell), language)
            for cell in column.cells
        )
        return [[title], *([_indexed(text)] for text in texts)]
    words = column.heads or (PRINTED, COMPUTED)
    heads = [f"{title} {word.speak(language)}".strip() for word in words]
    return [heads, *(_pair(c, language) for c in column.cells if isinstance(c, Cell))]


def _pair(cell: Cell, language: Language) -> list[str]:
    """Return a printed number and the computed one, bold where the two differ."""
    printed, computed = (localised(text, language) for text in (cell.printed, cell.text))
    return [printed, computed if cell.agreement in _AS_PRINTED else f"**{computed}**"]


def _remarks(item: Figure | Table, language: Language) -> Iterable[str]:
    data = f"[{DATA.speak(language)}]({item.stem}.csv)"
    yield f"{INPUTS.speak(language)}: {marked(item.source, language)}. {data}"
    for heading, claims in claims_by_kind(item):
        if heading is EXPECTED:
            yield f"{marked(heading, language)}:"
        yield "\n".join(_claim(claim, language) for claim in claims)
    yield from (marked(note, language) for note in item.notes)
    gaps = gap_sentence(item, language) if isinstance(item, Figure) else ""
    if gaps:
        yield _indexed(gaps)


def _claim(claim: Claim, language: Language) -> str:
    verdict = VERDICTS[claim.verdict].speak(language)
    statement, finding = (marked(text, language) for text in (claim.statement, claim.finding))
    return f"- {statement} **{verdict}** {finding}"


def marked(text: Text, language: Language) -> str:
    """Return a text as Markdown, with the indices of its symbols below the line."""
    return _indexed(text.speak(language))


def _indexed(text: str) -> str:
    """Escape what Markdown would read as marks, and set indices below the line."""
    plain = _SPECIAL.sub(r"\\\1", escape(text, quote=False))
    return with_indices(plain, lambda symbol, index: f"*{symbol}*<sub>{index}</sub>")
