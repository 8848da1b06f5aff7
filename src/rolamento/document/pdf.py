"""Documents as PDF, set by Typst on A4.

The page's look stands in `page.typ`; what it shows goes there as data, so that no text is ever
read as markup, and Typst sees no file but what is given to it.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Final

from rolamento.document.cells import (
    PEAK,
    address,
    broken,
    cell,
    cells,
    characters,
    figure_spaced,
    has_unit_line,
    indexed,
    peaks,
    shares,
    shares_of_bars,
    stands_left,
    table_of_bars,
)
from rolamento.document.model import (
    Bars,
    Beside,
    Block,
    Column,
    Document,
    Equation,
    Figure,
    KeyValues,
    Links,
    Notes,
    Section,
    Statement,
    Table,
    Title,
)
from rolamento.document.picture import alternative_of, conclusion_of, formula, picture_bytes
from rolamento.errors import printable
from rolamento.words import ABSENT, language, languages, said, speaking

__all__ = ["pdf", "set_by_typst"]

_PAGE: Final = Path(__file__).with_name("page.typ")
_WIDEST: Final = 112
"""Characters beside each other across a page, in letters of the size of tables."""
_WIDEST_HALF: Final = 58
_TABLE_SIZE: Final = 9.0
_LEAST_SIZE: Final = 5.5
_LONG_TEXT: Final = 24
_LONGEST_HEADER: Final = 90
_MOST_WITHOUT_CONTENTS: Final = 10
_WIDTH: Final = re.compile(r'<svg\b[^>]*?\bwidth="([\d.]+)pt"')


def pdf(document: Document) -> bytes:
    """Return a document as a PDF file; the same document gives the same bytes.

    Parameters
    ----------
    document
        What to show.
    """
    made = set_by_typst(document, format="pdf")
    assert isinstance(made, bytes)
    return made


def set_by_typst(document: Document, **form: Any) -> bytes | list[bytes] | None:
    """Return what Typst makes of a document; form: such as PNG of so many dots an inch."""
    import typst
    from matplotlib import get_data_path

    with speaking(document.language):
        given = _given(document)
    fonts = typst.Fonts(
        include_system_fonts=False, font_paths=[str(Path(get_data_path(), "fonts", "ttf"))]
    )
    with TemporaryDirectory() as empty:
        compiler = typst.Compiler(
            _page(), root=empty, font_paths=fonts, sys_inputs={"document": json.dumps(given)}
        )
        return compiler.compile(**form)


@cache
def _page() -> bytes:
    return _PAGE.read_bytes()


def _given(document: Document) -> dict[str, Any]:
    """Return what the page shows, as it reads it."""
    headed = [section for section in document.parts() if section.heading]
    highest = min((section.level for section in headed), default=2)
    parts = [one for part in document.sections for one in _parts(part, highest)]
    if len(headed) > _MOST_WITHOUT_CONTENTS:
        places = [i for i, one in enumerate(parts) if one["kind"] == "beside" or one["heading"]]
        leads = headed[0].key == document.main  # what a page begins with stays on it
        parts.insert(places[int(leads)], {"kind": "contents", "title": said("Contents")})
    tag, _, region = languages()[language()].partition("_")
    title = _plain(document.title)
    header = title if len(title) <= _LONGEST_HEADER else title[: _LONGEST_HEADER - 1] + "…"
    return {
        "title": title,
        "header": header,
        "numbered": said("{page} of {pages}", page="\n", pages="\n").split("\n"),
        "about": " · ".join(_plain(one) for one in (document.program, document.date) if one),
        "language": tag,
        "region": region or None,
        "parts": parts,
    }


def _parts(part: Section | Beside, highest: int) -> list[dict[str, Any]]:
    if isinstance(part, Section):
        return [_section(part, highest)]
    left, right = ([_section(one, highest) for one in half] for half in (part.left, part.right))
    blocks = (block for one in (*part.left, *part.right) for block in one.blocks)
    widest = max((characters(block) for block in blocks if isinstance(block, Table)), default=0)
    if widest > _WIDEST_HALF:
        return left + right
    return [{"kind": "beside", "left": left, "right": right}]


def _section(section: Section, highest: int) -> dict[str, Any]:
    return {
        "kind": "section",
        "heading": _text(section.heading),
        "level": 1 + max(section.level - highest, 0),
        "blocks": [set_ for block in section.blocks for set_ in _BY_BLOCK[type(block)](block)],
    }


# --- texts -------------------------------------------------------------------------------------


def _plain(text: str) -> str:
    return " ".join(printable(text).split())


def _text(text: str) -> list[tuple[str, str]]:
    """Return the pieces of a text; nothing of an empty one."""
    return [(printable(piece), index) for piece, index in indexed(text)] if text else []


def _leading(text: str) -> int:
    return len(text) - len(text.lstrip(" "))


def _title(block: Title) -> list[dict[str, Any]]:
    return [{"kind": "title", "text": _text(block.text)}]


def _statement(block: Statement) -> list[dict[str, Any]]:
    return [
        {
            "kind": "statement",
            "text": _text(block.text),
            "mark": _text(block.mark),
            "tone": block.tone,
            "mark-tone": block.mark_tone,
            "indent": block.indent,
            "code": printable(block.text) if block.verbatim else None,
        }
    ]


def _key_values(block: KeyValues) -> list[dict[str, Any]]:
    entries = [
        {
            "label": _text(entry.label.strip()),
            "indent": _leading(entry.label),
            "content": _text(
                entry.content if isinstance(entry.content, str) else cell(entry.content)
            ),
            "tone": entry.tone,
        }
        for entry in block.entries
    ]
    return [
        {
            "kind": "key-values",
            "entries": entries,
            "label": block.label_tone,
            "indent": block.indent,
        }
    ]


def _notes(block: Notes) -> list[dict[str, Any]]:
    remarks = [{"text": _text(one.text), "tone": one.tone} for one in block.remarks]
    return [{"kind": "notes", "remarks": remarks}] if remarks else []


def _links(block: Links) -> list[dict[str, Any]]:
    """Links to the web; what lies beside a page does not lie beside its print."""
    items = []
    for link in block.links:
        target = address(link.target, web_only=True)
        text = link.text if target else f"{link.text}: {link.target}"
        items.append({"text": _text(text), "target": target})
    return [{"kind": "links", "links": items}]


# --- tables ------------------------------------------------------------------------------------


def _table(block: Table) -> list[dict[str, Any]]:
    if block.only_in_files:
        return []
    parts: list[dict[str, Any]] = []
    for heading, part in broken(block, lambda table: characters(table) <= _WIDEST):
        caption = heading or (block.caption if not parts else "")
        parts.append(_one_table(part, caption, bool(heading)))
    return parts


def _one_table(block: Table, caption: str, part: bool) -> dict[str, Any]:
    columns = [_column_cells(column) for column in block.columns]
    names, rows = dict(block.groups), []
    for number, row in enumerate(zip(*columns, strict=True)):
        if number in names:
            rows.append({"group": _text(names[number])})
        rows.append({"cells": row})
    return {
        "kind": "table",
        "caption": _text(caption),
        "part": part,
        "headless": block.headless,
        "columns": [_head(column, block) for column in block.columns],
        "rows": rows,
        "legends": [_text(legend) for legend in block.legends if legend],
        "size": max(
            min(_TABLE_SIZE, _TABLE_SIZE * _WIDEST / max(characters(block), 1)), _LEAST_SIZE
        ),
    }


def _head(column: Column, block: Table) -> dict[str, Any]:
    unit = "" if column.bar else column.unit
    below = has_unit_line(block)
    return {
        "head": _text(column.head),
        "left": stands_left(column) or column.bar,
        "bar": column.bar,
        "peak": bool(column.peak),
        "below": unit if below else None,
        "behind": "" if below else unit,
    }


def _column_cells(column: Column) -> list[dict[str, Any]]:
    if column.bar:
        return [{"bar": share} for share in shares(column)]
    texts, left = cells(column), stands_left(column)
    tones = column.tones or [column.tone] * len(texts)
    set_ = []
    for text, top, tone in zip(texts, peaks(column), tones, strict=True):
        bare = text.strip() if left else figure_spaced(text).lstrip(" ")
        set_.append(
            {
                "text": _text(bare),
                "tone": "peak" if top else "faint" if text.strip() == ABSENT else tone,
                "peak": (PEAK if top else "") if column.peak else None,
                "words": len(text) > _LONG_TEXT,
                "indent": _leading(text) if left else 0,
            }
        )
    return set_


def _bars(block: Bars) -> list[dict[str, Any]]:
    table = _one_table(table_of_bars(block), "", False)
    head = {"head": [], "left": True, "bar": True, "peak": False, "below": None, "behind": ""}
    table["columns"].append(head)
    for row, share in zip(table["rows"], shares_of_bars(block), strict=True):
        row["cells"] = (*row["cells"], {"bar": share})
    table["legends"] = [_text(legend) for legend in block.legends if legend]
    return [table]


# --- equations and pictures --------------------------------------------------------------------


def _equation(block: Equation) -> list[dict[str, Any]]:
    drawn = formula(block.latex) if block.latex else None
    symbols = [
        {"symbol": _text(one.symbol), "meaning": _text(one.meaning), "unit": one.unit}
        for one in block.symbols
    ]
    return [
        {
            "kind": "equation",
            "name": _text(block.name),
            "text": _text(block.plain),
            "plain": _plain(block.plain),
            "svg": drawn.svg() if drawn else None,
            "width": drawn.width if drawn else 0.0,
            "number": f"({block.number})" if block.number else "",
            "symbols": symbols,
            "behind": [_text(one) for one in (block.valid, block.source) if one],
        }
    ]


def _figure(block: Figure) -> list[dict[str, Any]]:
    svg, sketch, width = None, [], 0.0
    drawn = None if block.draw is None else block.draw()
    if drawn is not None:
        svg = picture_bytes(drawn, "svg", transparent=True).decode("utf-8")
        found = _WIDTH.search(svg)
        width = float(found[1]) if found else 400.0
    elif block.sketch is not None:
        sketch = [
            [(printable(text), tone) for text, tone in line] for line in block.sketch(80, True)
        ]
    return [
        {
            "kind": "picture",
            "svg": svg,
            "width": width,
            "sketch": sketch,
            "caption": _text(block.caption),
            "says": _text(conclusion_of(block, drawn)),
            "alternative": _plain(alternative_of(block, drawn)),
        }
    ]


_BY_BLOCK: Final[dict[type[Block], Callable[..., list[dict[str, Any]]]]] = {
    Title: _title,
    Statement: _statement,
    KeyValues: _key_values,
    Table: _table,
    Bars: _bars,
    Figure: _figure,
    Notes: _notes,
    Equation: _equation,
    Links: _links,
}
