"""The same index as Markdown, for places that show files of a repository."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from html import escape
from typing import Final

from rolamento.reproduction.printed import Cell
from rolamento.reproduction.record import Claim, Figure, Section, Source, Table, TableColumn
from rolamento.reproduction.text import Language, Text, localised, with_indices
from rolamento.reproduction.wording import (
    COMPUTED,
    DATA,
    FIGURE,
    INPUTS,
    PRINTED,
    REGENERATED,
    TABLE,
    VERDICTS,
    gap_sentence,
    summary,
)

__all__ = ["markdown_page"]

_SPECIAL: Final = re.compile(r"([\\`*\[\]|])")
_AS_PRINTED: Final = ("printed", "tie", "cut")


def markdown_page(
    source: Source, sections: Sequence[Section], endings: Sequence[str], language: Language
) -> str:
    """Write the page; parameters as of `rolamento.reproduction.page.html_page`."""
    parts = [
        f"# {_marked(source.title, language)}",
        *(_marked(text, language) for text in source.remarks),
        "\n".join(f"- {_marked(line, language)}" for line in summary(tuple(sections))),
    ]
    for section in sections:
        parts.append(f"## {_marked(section.title, language)}")
        for item in section.items:
            parts += (
                _figure(item, endings, language)
                if isinstance(item, Figure)
                else _table(item, language)
            )
    parts.append(f"{REGENERATED.speak(language)} `rolamento reproduce {source.name}`.")
    return "\n\n".join(parts) + "\n"


def _figure(figure: Figure, endings: Sequence[str], language: Language) -> Iterable[str]:
    name = f"{FIGURE.speak(language)} {figure.number}"
    yield f"![{name}]({figure.stem}.{endings[0]})"
    yield f"**{name}.** {_marked(figure.caption, language)}"
    yield from _remarks(figure, language)


def _table(table: Table, language: Language) -> Iterable[str]:
    name = f"{TABLE.speak(language)} {table.number}"
    yield f"**{name}.** {_marked(table.caption, language)}"
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
    title = _marked(column.title, language)
    if not any(isinstance(cell, Cell) for cell in column.cells):
        texts = (
            cell.speak(language) if isinstance(cell, Text) else localised(str(cell), language)
            for cell in column.cells
        )
        return [[title], *([_indexed(text)] for text in texts)]
    heads = [f"{title} {word.speak(language)}" for word in (PRINTED, COMPUTED)]
    return [heads, *(_pair(c, language) for c in column.cells if isinstance(c, Cell))]


def _pair(cell: Cell, language: Language) -> list[str]:
    """Return a printed number and the computed one, bold where the two differ."""
    printed, computed = (localised(text, language) for text in (cell.printed, cell.text))
    return [printed, computed if cell.agreement in _AS_PRINTED else f"**{computed}**"]


def _remarks(item: Figure | Table, language: Language) -> Iterable[str]:
    data = f"[{DATA.speak(language)}]({item.stem}.csv)"
    yield f"{INPUTS.speak(language)}: {_marked(item.source, language)}. {data}"
    if item.claims:
        yield "\n".join(_claim(claim, language) for claim in item.claims)
    yield from (_marked(note, language) for note in item.notes)
    gaps = gap_sentence(item, language) if isinstance(item, Figure) else ""
    if gaps:
        yield _indexed(gaps)


def _claim(claim: Claim, language: Language) -> str:
    verdict = VERDICTS[claim.verdict].speak(language)
    statement, finding = (_marked(text, language) for text in (claim.statement, claim.finding))
    return f"- {statement} **{verdict}** {finding}"


def _marked(text: Text, language: Language) -> str:
    return _indexed(text.speak(language))


def _indexed(text: str) -> str:
    """Escape what Markdown would read as marks, and set indices below the line."""
    plain = _SPECIAL.sub(r"\\\1", escape(text, quote=False))
    return with_indices(plain, lambda symbol, index: f"*{symbol}*<sub>{index}</sub>")
