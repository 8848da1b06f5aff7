"""Documents as Markdown, as GitHub reads it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Final

from rolamento.document.cells import (
    PEAK,
    address,
    cell,
    cells,
    indexed,
    peaks,
    shown,
    stands_left,
    table_of_bars,
)
from rolamento.document.model import (
    Bars,
    Block,
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
    Tone,
)
from rolamento.errors import printable
from rolamento.words import speaking

__all__ = ["markdown"]

_ACTING: Final = re.compile(r"([\\`*_\[\]<>&|~$])")
_AT_START: Final = re.compile(r"^( *)([#+=-]|\d+(?=[.)](?:\s|\Z)))", re.M)
_LINK_ADDRESS: Final = re.compile(r"[\s()<>]")
_BOLD: Final[tuple[Tone, ...]] = (
    "strong", "good-strong", "warning", "warning-strong", "bad", "bad-strong", "peak"
)  # fmt: skip


def markdown(document: Document, *, picture: Callable[[Figure], str | None] | None = None) -> str:
    """Return a document as Markdown.

    Parameters
    ----------
    document
        What to show.
    picture
        Returns the name of the file that shows a figure; without one pictures are left out.
    """
    with speaking(document.language):
        setter = _Setter(document, picture)
        parts = [text for section in document.parts() if (text := setter.section(section))]
        about = " · ".join(one for one in (document.program, document.date) if one)
        if about:
            parts.append(f"---\n\n{_text(about)}")
    return "\n\n".join(parts) + "\n"


class _Setter:
    def __init__(self, document: Document, picture: Callable[[Figure], str | None] | None) -> None:
        self._picture = picture
        self._depths = document.depths
        self._by_block: dict[type[Block], Callable[..., str]] = {
            Title: lambda block: f"# {_line(block.text)}",
            Statement: _statement,
            KeyValues: _key_values,
            Table: _table,
            Bars: _bars,
            Figure: self._figure,
            Notes: _notes,
            Equation: _equation,
            Links: _links,
        }

    def section(self, section: Section) -> str:
        """Return a section, its blocks apart."""
        blocks = [self._by_block[type(block)](block) for block in section.blocks]
        if section.heading:
            level = min(2 + self._depths[section.level], 6)
            blocks.insert(0, f"{'#' * level} {_line(section.heading)}")
        return "\n\n".join(filter(None, blocks))

    def _figure(self, block: Figure) -> str:
        name = self._picture(block) if self._picture else None
        if name is None:
            return ""
        alternative = _line(block.alternative or block.caption)
        target = _LINK_ADDRESS.sub(lambda found: f"%{ord(found[0]):02X}", name)
        shown_ = f"![{alternative}]({target})"
        return f"{shown_}\n\n*{_line(block.caption)}*" if block.caption else shown_


# --- texts -------------------------------------------------------------------------------------


def _text(text: str) -> str:
    """Return a text that Markdown shows as it is, its lines broken."""
    pieces = (
        _ACTING.sub(r"\\\1", printable(piece)) + (f"<sub>{index}</sub>" if index else "")
        for piece, index in indexed(text)
    )
    escaped = _AT_START.sub(lambda found: f"{found[1]}{_start(found[2])}", "".join(pieces))
    return "\\\n".join(line.strip() for line in escaped.split("\n"))


def _start(sign: str) -> str:
    return f"{sign}\\" if sign.isdigit() else f"\\{sign}"


def _line(text: str) -> str:
    """Return a text in one line."""
    return _text(" ".join(text.split()))


def _toned(text: str, tone: Tone) -> str:
    return f"**{text}**" if text and tone in _BOLD else text


def _statement(block: Statement) -> str:
    if block.verbatim:
        fence = "`" * max(3, 1 + max(map(len, re.findall("`+", block.text)), default=0))
        return f"{fence}\n{printable(block.text)}\n{fence}"
    return _toned(_text(f"{block.mark} {block.text}" if block.mark else block.text), block.tone)


def _key_values(block: KeyValues) -> str:
    lines = []
    for entry in block.entries:
        content = entry.content if isinstance(entry.content, str) else cell(entry.content)
        written = "<br>".join(_text(content).split("\\\n"))
        lines.append(f"| {_line(entry.label)} | {_toned(written, entry.tone)} |")
    return "\n".join(["| | |", "| --- | --- |", *lines]) if lines else ""


def _notes(block: Notes) -> str:
    return "\n".join(f"- {_toned(_line(remark.text), remark.tone)}" for remark in block.remarks)


def _links(block: Links) -> str:
    return " · ".join(_link(link.text, link.target) for link in block.links)


def _link(text: str, target: str) -> str:
    reached = _LINK_ADDRESS.sub(lambda found: f"%{ord(found[0]):02X}", address(target))
    return f"[{_line(text)}]({reached})" if reached else _line(f"{text}: {target}")


# --- tables ------------------------------------------------------------------------------------


def _table(block: Table) -> str:
    if block.only_in_files:
        return ""
    columns = [column for column in shown(block) if not column.bar]
    heads, sides, texts = [], [], []
    for column in columns:
        unit = f"[{column.unit}]" if column.unit and column.head else column.unit
        heads.append("" if block.headless else _line(f"{column.head} {unit}".strip()))
        sides.append(":---" if stands_left(column) else "---:")
        tones = column.tones or [column.tone] * len(column.values)
        texts.append(
            [
                _toned(_line(text), "peak" if top else tone) + (f" {PEAK}" if top else "")
                for text, top, tone in zip(cells(column), peaks(column), tones, strict=True)
            ]
        )
    return _lines(block, heads, sides, list(zip(*texts, strict=True)))


def _lines(
    block: Table, heads: Sequence[str], sides: Sequence[str], rows: Sequence[Iterable[str]]
) -> str:
    lines = [f"**{_line(block.caption)}**", ""] if block.caption else []
    lines += [_row(heads), _row(sides)]
    names = dict(block.groups)
    for number, row in enumerate(rows):
        if number in names:
            lines.append(_row([f"**{_line(names[number])}**", *[""] * (len(heads) - 1)]))
        lines.append(_row(row))
    legends = (*block.legends, *(each.legend for each in block.breaks))
    return "\n".join([*lines, *(f"\n{_text(legend)}" for legend in legends if legend)])


def _row(cells_: Iterable[str]) -> str:
    return f"| {' | '.join(cells_)} |"


def _bars(block: Bars) -> str:
    return _table(replace(table_of_bars(block), legends=block.legends))


# --- equations ---------------------------------------------------------------------------------


def _equation(block: Equation) -> str:
    number = f" \\tag{{{block.number}}}" if block.number else ""
    # a dollar or a line break would end the formula
    latex = " ".join(printable(block.latex).replace("$", "").split())
    shown_ = f"$${latex}{number}$$" if latex else _text(block.plain)
    parts = [f"**{_line(block.name)}**"] if block.name else []
    parts.append(shown_)
    if block.symbols:
        parts.append(
            "\n".join(
                "- " + _line(f"{one.symbol}: {one.meaning}" + f" [{one.unit}]" * bool(one.unit))
                for one in block.symbols
            )
        )
    parts += [_text(one) for one in (block.valid, block.source) if one]
    return "\n\n".join(parts)
