"""Documents as text for a terminal, a pipe or a file.

Lines are set here and not by Rich: its tables take longer for sixty balls than the solver does,
its import and its texts as long as one solution.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from itertools import groupby, zip_longest
from textwrap import wrap
from typing import ClassVar, Final, TypeAlias

from rolamento.document.cells import (
    PEAK,
    broken,
    cell,
    cells,
    grouped,
    has_unit_line,
    peaks,
    shares,
    shares_of_bars,
    shown,
    stands_left,
    table_of_bars,
)
from rolamento.document.medium import Medium
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
    Tone,
)
from rolamento.records import frozen
from rolamento.words import ABSENT, speaking

__all__ = ["terminal"]

Line: TypeAlias = tuple[tuple[str, str], ...]
"""Pieces of text, each with its style: what stands between ``ESC [`` and ``m`` (ECMA-48, SGR)."""
Lines: TypeAlias = list[Line]

_BOLD: Final = "1"
_DIM: Final = "2"
_CYAN: Final = "36"
_YELLOW: Final = "33"
_STYLES: Final[dict[Tone, str]] = {
    "": "",
    "strong": _BOLD,
    "faint": _DIM,
    "mark": _CYAN,
    "good": "32",
    "good-strong": "1;32",
    "warning": _YELLOW,
    "warning-strong": "1;33",
    "bad": "31",
    "bad-strong": "1;31",
    "peak": "1;35",
}
_HEADING: Final = "1;36"
_EMPTY: Final[Line] = ()
_BULLET: Final = "  • "
_LONGEST_BAR: Final = 20
_EIGHTHS: Final = " ▏▎▍▌▋▊▉"
_RULE: Final = "─"


def terminal(document: Document, medium: Medium | None = None) -> str:
    """Return a document as text that ends in a newline.

    Parameters
    ----------
    document
        What to show.
    medium
        What the text is shown on; by default plain text of 80 columns in UTF-8.
    """
    with speaking(document.language):
        medium = medium or Medium()
        setter = _Setter(medium)
        parts = [setter.part(one, medium.width) for one in document.sections]
        return "".join(f"{_written(line, medium.colors)}\n" for line in _joined(parts))


def _written(line: Line, colors: bool) -> str:
    """Return a line as text without blanks at its end."""
    if not colors:
        return _plain(line).rstrip()
    pieces = list(line)
    while pieces and not pieces[-1][0].rstrip():
        pieces.pop()
    if pieces:
        last, style = pieces[-1]
        pieces[-1] = last.rstrip(), style
    return "".join(
        f"\x1b[{style}m{text}\x1b[0m" if style else text
        for style, same in groupby(pieces, key=lambda piece: piece[1])
        if (text := "".join(part for part, _ in same))
    )


@frozen
class _Setter:
    """Sets blocks as lines of characters, for one medium."""

    medium: Medium

    def part(self, one: Section | Beside, width: int) -> Lines:
        """Set a section, or sections beside each other where there is room."""
        if isinstance(one, Section):
            return self._section(one, width)
        left = _joined([self._section(own, width) for own in one.left])
        begin = _widest(left) + one.gap
        room = width - begin
        sketches = (b for own in one.right for b in own.blocks if isinstance(b, Figure))
        if max((sketch.width for sketch in sketches), default=0) <= room:
            right = _joined([self._section(own, room) for own in one.right])
            if _widest(right) <= room:
                pairs = zip_longest(left, right, fillvalue=_EMPTY)
                return [(*a, *_blank(begin - _widest([a])), *b) for a, b in pairs]
        return _joined([left, *(self._section(own, width) for own in one.right)])

    def _section(self, section: Section, width: int) -> Lines:
        heading: Lines = []
        if section.heading and section.level == 1:
            heading = self._title(Title(section.heading), width)
        elif section.heading:
            heading = self._hanging(_EMPTY, section.heading, width, _HEADING)
        parts = (self._BLOCKS[type(block)](self, block, width) for block in section.blocks)
        return [*heading, *(line for part in parts for line in part)]

    # --- texts ------------------------------------------------------------------------------

    def _text(self, content: str, style: str = "") -> Line:
        """Return text that the medium can show."""
        return ((self.medium.fitted(content), style),)

    def _hanging(self, label: Line, content: str, width: int, style: str = "") -> Lines:
        """Break a text into lines that begin to the right of its label."""
        margin = _widest([label])
        pieces = [
            piece
            for line in self.medium.fitted(content).split("\n")
            for piece in wrap(grouped(line), max(width - margin, 8), break_on_hyphens=False) or [""]
        ]
        return [
            (*(_blank(margin) if number else label), (piece.replace("\u00a0", " "), style))
            for number, piece in enumerate(pieces)
        ]

    def _rule(self, width: int) -> Line:
        return self._text((_RULE if self.medium.shows(_RULE) else "-") * width, _DIM)

    def _title(self, block: Title, width: int) -> Lines:
        return [*self._hanging(_EMPTY, block.text, width, _BOLD), self._rule(width)]

    def _statement(self, block: Statement, width: int) -> Lines:
        mark = f"{block.mark} " if block.mark else ""
        label = self._text(" " * block.indent + mark, _STYLES[block.mark_tone or block.tone])
        if block.verbatim:
            return [label + self._text(line) for line in block.text.split("\n")]
        return self._hanging(label, block.text, width, _STYLES[block.tone])

    def _key_values(self, block: KeyValues, width: int) -> Lines:
        longest = max((len(entry.label) for entry in block.entries), default=0)
        lines: Lines = []
        for entry in block.entries:
            label = f"{' ' * block.indent}{entry.label:{longest}}  "
            content = entry.content if isinstance(entry.content, str) else cell(entry.content)
            own = self._text(label, _STYLES[block.label_tone])
            lines += self._hanging(own, content, width, _STYLES[entry.tone])
        return lines

    def _notes(self, block: Notes, width: int) -> Lines:
        lines: Lines = []
        for remark in block.remarks:
            lines += self._hanging(
                self._text(_BULLET, _YELLOW), remark.text, width, _STYLES[remark.tone]
            )
        return lines

    def _equation(self, block: Equation, width: int) -> Lines:
        label = f"({block.number})" if block.number else ""
        lines = self._hanging(self._text(f"  {label:5}"), block.plain, width)
        longest = max((len(one.symbol) for one in block.symbols), default=0)
        for one in block.symbols:
            meaning = f"{one.meaning} [{one.unit}]" if one.unit else one.meaning
            symbol = self._text(f"{' ' * 7}{one.symbol:{longest}}  ", _DIM)
            lines += self._hanging(symbol, meaning, width, _DIM)
        behind = "; ".join(part for part in (block.name, block.source, block.valid) if part)
        return lines + self._hanging(_blank(7), behind, width, _DIM)

    def _links(self, block: Links, width: int) -> Lines:
        return [
            line
            for link in block.links
            for line in self._hanging(self._text(f"  {link.text}: "), link.target, width)
        ]

    def _figure(self, block: Figure, width: int) -> Lines:
        if block.sketch is None:
            return []
        drawn = block.sketch(width, self.medium.draws)
        return [
            tuple((self.medium.fitted(text), _STYLES[tone]) for text, tone in line)
            for line in drawn
        ]

    # --- tables -----------------------------------------------------------------------------

    def _table(self, block: Table, width: int) -> Lines:
        if block.only_in_files:
            return []
        lines = self._hanging(_EMPTY, block.caption, width, _BOLD) if block.caption else []
        for number, (heading, part) in enumerate(
            broken(block, lambda table: _width(self._set_columns(table), table) <= width)
        ):
            table = self._set_columns(part)
            if _width(table, part) > width:  # closer to each other, then to the margin
                part = replace(part, gap=1)
            if _width(table, part) > width:
                part = replace(part, indent=0)
            bars = len(part.columns) < len(shown(block)) or not block.breaks
            table = self._with_bars(table, part, width) if bars else table
            lines += [_EMPTY] if number else []
            lines += [self._text(heading, _HEADING)] if heading else []
            lines += self._assembled(table, part, width)
        return lines

    def _assembled(self, columns: Sequence[Lines], block: Table, width: int) -> Lines:
        """Put columns beside each other, the rule and the names of groups between their lines."""
        rows = self._rows(columns, block, width)
        heads = len(rows) - len(block.columns[0].values)
        head, body = [line for lines in rows[:heads] for line in lines], rows[heads:]
        if block.rule:
            head.append(self._rule(_widest([line for lines in rows for line in lines])))
        names = dict(block.groups)
        for row, lines in enumerate(body):
            if row in names:
                head.append(self._text(" " * block.indent + names[row], _CYAN))
            head += lines
        for legend in block.legends:
            if legend:
                head += self._hanging(_blank(block.indent), legend, width, _DIM)
        return head

    def _rows(self, columns: Sequence[Lines], block: Table, width: int) -> list[Lines]:
        """Put cells beside each other; texts at the end of too wide a table hang in lines."""
        shown = [column for column in block.columns if not column.bar]
        hangs = len(columns) == len(shown) > 1 and stands_left(shown[-1])
        hangs = hangs and _width(columns, block) > width
        indent, gap, rows = _blank(block.indent), _blank(block.gap), []
        for cells_ in zip(*columns, strict=True):
            begun = [*indent, *cells_[0]]
            for one in cells_[1:-1] if hangs else cells_[1:]:
                begun += (*gap, *one)
            label, last = tuple(begun), cells_[-1]
            rows.append(
                self._hanging(label + gap, _plain(last).rstrip(), width, _style_of(last))
                if hangs
                else [label]
            )
        return rows

    def _set_columns(self, block: Table) -> list[Lines]:
        """Return each column but bars as its heads and cells, padded to one width."""
        found = []
        for column in block.columns:
            if column.bar:
                continue
            lines, texts = self._heads(column, block, " " if column.peak else ""), cells(column)
            tones = column.tones or [column.tone] * len(texts)
            for text, top, tone in zip(texts, peaks(column), tones, strict=True):
                style = _DIM if text.strip() == ABSENT else _STYLES["peak" if top else tone]
                mark = (PEAK if top else " ") if column.peak else ""
                lines.append(self._text(text + mark, style))
            width, left = _widest(lines), stands_left(column)
            found.append([_padded(line, width, left) for line in lines])
        return found

    def _heads(self, column: Column, block: Table, room: str) -> Lines:
        if block.headless:
            return []
        words, units = column.head.split("\n"), has_unit_line(block)
        # heads end in one line, that of the units below it; those without a unit may end there
        ends = [c.head.count("\n") + (0 if units and not c.unit else 1) for c in block.columns]
        count = max(ends, default=1) or 1
        above = [_EMPTY] * (count - len(words))
        if not units:
            unit = f" {column.unit}" if column.unit and block.units == "behind" else ""
            words[-1] = f"{words[-1]}{unit}".strip()
            return [*above, *(self._text(word + room, _DIM) for word in words)]
        lines = [self._text(word + room) for word in words]
        if not column.unit:
            return [_EMPTY] * (count + 1 - len(lines)) + lines
        return [*above, *lines, self._text(column.unit + room, _DIM)]

    def _with_bars(self, table: list[Lines], block: Table, width: int) -> list[Lines]:
        """Add the columns of bars, in what room is left."""
        room = width - _width(table, block) - block.gap
        for column in block.columns:
            if column.bar:
                longest = min(max(room, 0), _LONGEST_BAR)
                heads = self._heads(replace(column, unit=""), block, "")
                bars = [*heads, *(self._bar(longest * share) for share in shares(column))]
                table = [*table, [_padded(bar, _widest(bars), True) for bar in bars]]
        return table

    def _bar(self, length: float, style: str = _CYAN) -> Line:
        if not self.medium.draws:
            return (("#" * round(length), style),)
        eighths = round(8 * length)
        return (("█" * (eighths // 8) + _EIGHTHS[eighths % 8].strip(), style),)

    # --- bars -------------------------------------------------------------------------------

    def _bars(self, block: Bars, width: int) -> Lines:
        table = table_of_bars(block)
        lines = self._table(table, width)
        room = min(width - _widest(lines) - table.gap, block.longest)
        first = len(lines) - len(block.bars)
        for place, share in enumerate(shares_of_bars(block), start=first):
            drawn = self._bar(max(room * share, 0.125 if share else 0.0), _STYLES[block.tone])
            lines[place] = (*lines[place], *_blank(table.gap), *drawn)
        for legend in block.legends:
            lines += self._hanging(_blank(2), legend, width, _DIM)
        return lines

    _BLOCKS: ClassVar[dict[type[Block], Callable[..., Lines]]] = {
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


# --- lines beside lines ------------------------------------------------------------------------


def _plain(line: Line) -> str:
    return "".join([text for text, _ in line])


def _widest(lines: Iterable[Line]) -> int:
    return max((sum([len(text) for text, _ in line]) for line in lines), default=0)


def _blank(width: int) -> Line:
    return ((" " * width, ""),)


def _joined(parts: Sequence[Lines]) -> Lines:
    """Set parts below each other, with an empty line between them."""
    return [line for part in parts if part for line in (_EMPTY, *part)][1:]


def _padded(cell: Line, width: int, left: bool) -> Line:
    room = _blank(width - _widest([cell]))
    return cell + room if left else room + cell


def _style_of(cell: Line) -> str:
    """Return the style of what stands in a padded cell."""
    return next((style for _, style in cell if style), "")


def _width(columns: Sequence[Lines], block: Table) -> int:
    widths = [_widest(column) for column in columns]
    return block.indent + sum(widths) + block.gap * max(len(widths) - 1, 0)
