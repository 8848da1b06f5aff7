"""Documents as text for a terminal, a pipe or a file.

Lines are set here and not by Rich's tables, which take longer for sixty balls than the solver
does; Rich does the colours.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from io import StringIO
from itertools import zip_longest
from math import isfinite, nan
from textwrap import wrap
from typing import Final, TypeAlias

from rich.console import Console
from rich.text import Text

from rolamento.document.medium import Medium
from rolamento.document.model import (
    Bars,
    Beside,
    Block,
    CellContent,
    Column,
    Document,
    Equation,
    Figure,
    KeyValues,
    Notes,
    Number,
    Section,
    Statement,
    Table,
    Title,
    Tone,
)
from rolamento.words import ABSENT, Manner, aligned, decimals_for, in_unit, manner, speaking

__all__ = ["terminal"]

Lines: TypeAlias = list[Text]

STYLES: Final[dict[Tone, str]] = {
    "": "",
    "strong": "bold",
    "faint": "dim",
    "mark": "cyan",
    "good": "green",
    "good-strong": "bold green",
    "warning": "yellow",
    "warning-strong": "bold yellow",
    "bad": "red",
    "bad-strong": "bold red",
    "peak": "bold magenta",
}
_HEADING: Final = "bold cyan"
_BULLET: Final = "  • "
_LONGEST_BAR: Final = 20
_EIGHTHS: Final = " ▏▎▍▌▋▊▉"
_RULE: Final = "─"
_PEAK: Final = "◂"


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
        setter = _Setter(medium, manner())
        parts = [setter.part(one, medium.width) for one in document.sections]
        return _coloured(medium, [part for part in parts if part])


def _coloured(medium: Medium, parts: Sequence[Lines]) -> str:
    """Return the parts one below the other, with an empty line between them."""
    console = Console(
        file=StringIO(),
        width=medium.width,
        color_system=medium.colors,
        force_terminal=medium.colors is not None,
        no_color=medium.colors is None,
        legacy_windows=False,
        highlight=False,
        markup=False,
        emoji=False,
    )
    with console.capture() as capture:
        for number, part in enumerate(parts):
            for line in [Text(), *part] if number else part:
                line.rstrip()
                console.print(line, no_wrap=True, overflow="ignore", crop=False)
    return capture.get()


class _Setter:
    """Sets blocks as lines of characters, for one medium and one manner of numbers."""

    def __init__(self, medium: Medium, manner: Manner) -> None:
        self._medium, self._manner = medium, manner
        self._by_block: dict[type, Callable[..., Lines]] = {
            Title: self._title,
            Statement: self._statement,
            KeyValues: self._key_values,
            Table: self._table,
            Bars: self._bars,
            Figure: self._figure,
            Notes: self._notes,
            Equation: self._equation,
        }

    def part(self, one: Section | Beside, width: int) -> Lines:
        """Set a section, or sections beside each other where there is room."""
        if isinstance(one, Section):
            return self._section(one, width)
        left = self._stacked(one.left, width)
        room = width - max(map(len, left), default=0) - one.gap
        if _least_width(one.right) <= room:
            right = self._stacked(one.right, room)
            if max(map(len, right), default=0) <= room:
                return _beside(left, right, one.gap)
        return _joined([left, self._stacked(one.right, width)])

    def _stacked(self, sections: Iterable[Section], width: int) -> Lines:
        return _joined([self._section(one, width) for one in sections])

    def _section(self, section: Section, width: int) -> Lines:
        heading = self._hanging(Text(), section.heading, width, _HEADING) if section.heading else []
        return [*heading, *(line for block in section.blocks for line in self._block(block, width))]

    def _block(self, block: Block, width: int) -> Lines:
        return self._by_block[type(block)](block, width)

    # --- texts ------------------------------------------------------------------------------

    def _text(self, content: str, style: str = "") -> Text:
        """Return plain text that the medium can show: never read as markup."""
        return Text(self._medium.fitted(content), style)

    def _hanging(self, label: Text, content: str, width: int, style: str = "") -> Lines:
        """Break a text into lines that begin to the right of its label."""
        pieces = [
            piece
            for line in self._medium.fitted(content).split("\n")
            for piece in wrap(line, max(width - len(label), 8), break_on_hyphens=False) or [""]
        ]
        margins = [label] + [Text(" " * len(label))] * (len(pieces) - 1)
        return [
            Text.assemble(margin, (piece, style))
            for margin, piece in zip(margins, pieces, strict=True)
        ]

    def _rule(self, width: int) -> Text:
        return self._text((_RULE if self._medium.shows(_RULE) else "-") * width, "dim")

    def _title(self, block: Title, width: int) -> Lines:
        return [*self._hanging(Text(), block.text, width, "bold"), self._rule(width)]

    def _statement(self, block: Statement, width: int) -> Lines:
        mark = f"{block.mark} " if block.mark else ""
        label = self._text(" " * block.indent + mark, STYLES[block.mark_tone or block.tone])
        return self._hanging(label, block.text, width, STYLES[block.tone])

    def _key_values(self, block: KeyValues, width: int) -> Lines:
        longest = max((len(entry.label) for entry in block.entries), default=0)
        lines: Lines = []
        for entry in block.entries:
            label = f"{' ' * block.indent}{entry.label:{longest}}  "
            content = entry.content if isinstance(entry.content, str) else self._cell(entry.content)
            own = self._text(label, STYLES[block.label_tone])
            lines += self._hanging(own, content, width, STYLES[entry.tone])
        return lines

    def _notes(self, block: Notes, width: int) -> Lines:
        lines: Lines = []
        for remark in block.remarks:
            lines += self._hanging(
                self._text(_BULLET, "yellow"), remark.text, width, STYLES[remark.tone]
            )
        return lines

    def _equation(self, block: Equation, width: int) -> Lines:
        label = f"({block.number})" if block.number else ""
        lines = self._hanging(self._text(f"  {label:5}"), block.plain, width)
        behind = "; ".join(part for part in (block.name, block.source, block.valid) if part)
        return lines + self._hanging(Text(" " * 7), behind, width, "dim")

    def _figure(self, block: Figure, width: int) -> Lines:
        if block.sketch is None:
            return []
        drawn = block.sketch(width, self._medium.draws)
        return [
            Text.assemble(*((self._medium.fitted(text), STYLES[tone]) for text, tone in line))
            for line in drawn
        ]

    # --- tables -----------------------------------------------------------------------------

    def _table(self, block: Table, width: int) -> Lines:
        shown = tuple(column for column in block.columns if not column.only_in_files)
        breaks = [_shown_place(block, each.column) for each in block.breaks]
        plain = [column for column in shown if not column.bar]
        whole = self._set_columns(plain, block)
        legends = (*block.legends, *(each.legend for each in block.breaks))
        if not breaks or _width(whole, block) <= width:
            bars = len(plain) < len(shown) and not breaks
            table = self._with_bars(whole, shown, block, width) if bars else whole
            return self._assembled(table, replace(block, legends=legends), width)
        lines: Lines = []
        ends = [*breaks[1:], len(shown)]
        for part in range(len(breaks) + 1):
            columns = (
                list(shown[: breaks[0]])
                if part == 0
                else [*shown[: block.fixed], *shown[breaks[part - 1] : ends[part - 1]]]
            )
            own = block.legends if part == 0 else (block.breaks[part - 1].legend,)
            heading = block.breaks[part - 1].heading if part else ""
            table = self._set_columns([one for one in columns if not one.bar], block)
            table = self._with_bars(table, columns, block, width)
            lines += [Text()] if part else []
            lines += [self._text(heading, _HEADING)] if heading else []
            lines += self._assembled(table, replace(block, legends=own), width)
        return lines

    def _assembled(self, columns: Sequence[Lines], block: Table, width: int) -> Lines:
        """Put columns beside each other, the rule and the names of groups between their lines."""
        lines = _in_columns(columns, block.indent, block.gap)
        heads = 0 if block.headless else 1 + _has_units(block)
        head, body = lines[:heads], lines[heads:]
        if block.rule:
            head.append(self._rule(max(map(len, lines), default=0)))
        names = dict(block.groups)
        for row, line in enumerate(body):
            if row in names:
                head.append(self._text(" " * block.indent + names[row], "cyan"))
            head.append(line)
        for legend in block.legends:
            if legend:
                head += self._hanging(Text(" " * block.indent), legend, width, "dim")
        return head

    def _set_columns(self, columns: Sequence[Column], block: Table) -> list[Lines]:
        """Return each column as its heads and cells, padded to one width."""
        return [self._set_column(column, block) for column in columns]

    def _set_column(self, column: Column, block: Table) -> Lines:
        room = " " if column.peak else ""
        texts, tops = self._cells(column), _tops(column)
        tones = column.tones or [column.tone] * len(texts)
        cells: Lines = []
        for text, top, tone in zip(texts, tops, tones, strict=True):
            style = STYLES["peak" if top else tone]
            style = "dim" if text.strip() == ABSENT else style
            mark = (_PEAK if top else " ") if column.peak else ""
            cells.append(self._text(text + mark, style))
        column_ = [*self._heads(column, block, room), *cells]
        width = max(map(len, column_), default=0)
        left = column.align == "left" or (not column.align and _is_text(column))
        return [_padded(cell, width, left) for cell in column_]

    def _heads(self, column: Column, block: Table, room: str) -> Lines:
        if block.headless:
            return []
        if not _has_units(block):
            unit = f" {column.unit}" if column.unit and block.units == "behind" else ""
            return [self._text(column.head + unit + room, "dim")]
        if not column.unit:
            return [Text(), self._text(column.head + room)]
        return [self._text(column.head + room), self._text(column.unit + room, "dim")]

    def _with_bars(
        self, table: list[Lines], columns: Sequence[Column], block: Table, width: int
    ) -> list[Lines]:
        """Add the columns of bars, in what room is left."""
        room = width - _width(table, block) - block.gap
        for column in columns:
            if column.bar:
                numbers = [value if isinstance(value, float) else 0.0 for value in column.values]
                greatest = max(numbers, default=0.0)
                longest = min(max(room, 0), _LONGEST_BAR)
                shares = [number / greatest if greatest > 0.0 else 0.0 for number in numbers]
                heads = self._heads(replace(column, unit=""), block, "")
                bars = [*heads, *(self._bar(longest * share) for share in shares)]
                table = [*table, [_padded(bar, max(map(len, bars)), True) for bar in bars]]
        return table

    def _bar(self, length: float, style: str = "cyan") -> Text:
        if not self._medium.draws:
            return Text("#" * round(length), style)
        eighths = round(8 * length)
        return Text("█" * (eighths // 8) + _EIGHTHS[eighths % 8].strip(), style)

    # --- numbers ----------------------------------------------------------------------------

    def _cells(self, column: Column) -> list[str]:
        """Write the cells of a column: numbers with the same decimals, the marks in line."""
        mark = self._manner.mark
        if column.form:
            values = [_formed(value, column.form) for value in column.values]
            column = replace(column, values=values, form="")
        decimals = decimals_for(_numbers(column), column.figures, column.most)
        texts = [self._cell(value, column.unit, decimals) for value in column.values]
        if any(isinstance(value, Number) for value in column.values):
            numeric = [not isinstance(value, str) for value in column.values]
            lined = iter(
                aligned([t for t, own in zip(texts, numeric, strict=True) if own and t], mark)
            )
            texts = [
                next(lined) if own and text else text
                for text, own in zip(texts, numeric, strict=True)
            ]
        return [_centred_dash(text, texts) for text in texts]

    def _cell(self, value: CellContent, unit: str = "", decimals: int = 0) -> str:
        if value is None:
            return ""
        if isinstance(value, str):
            return value
        if isinstance(value, Number):
            number = self._manner.number(value.value, value.form)
            return f"{value.before}{number}{value.behind}"
        if isinstance(value, bool | int):
            return self._manner.fixed(float(value), 0)
        return self._manner.fixed(float(in_unit(value, unit)), decimals)

    # --- bars -------------------------------------------------------------------------------

    def _bars(self, block: Bars, width: int) -> Lines:
        columns = (
            Column(head=block.heads[0], values=[bar.label for bar in block.bars]),
            Column(
                head=block.heads[1],
                values=[bar.number for bar in block.bars],
                unit=block.unit,
                align="right",
                tones=[bar.tone for bar in block.bars],
            ),
        )
        table = Table(columns=columns, headless=not any(block.heads), units="behind")
        lines = self._table(table, width)
        greatest = max((bar.length for bar in block.bars), default=0.0)
        room = min(width - max(map(len, lines), default=0) - table.gap, block.longest)
        first = len(lines) - len(block.bars)
        for line, bar in zip(lines[first:], block.bars, strict=True):
            share = bar.length / greatest if greatest > 0.0 and bar.length > 0.0 else 0.0
            drawn = self._bar(max(room * share, 0.125 if share else 0.0), STYLES[block.tone])
            line.append(" " * table.gap).append_text(drawn)
        for legend in block.legends:
            lines += self._hanging(Text("  "), legend, width, "dim")
        return lines


# --- lines beside lines ------------------------------------------------------------------------


def _beside(left: Lines, right: Lines, gap: int) -> Lines:
    width = max(map(len, left)) + gap
    pairs = zip_longest(left, right, fillvalue=Text())
    return [Text.assemble(one, " " * (width - len(one)), other) for one, other in pairs]


def _joined(parts: Sequence[Lines]) -> Lines:
    """Set parts below each other, with an empty line between them."""
    lines: Lines = []
    for part in parts:
        if part:
            lines += [Text(), *part] if lines else part
    return lines


def _in_columns(columns: Sequence[Lines], indent: int, gap: int) -> Lines:
    return [
        Text(" " * indent) + Text(" " * gap).join(cells) for cells in zip(*columns, strict=True)
    ]


def _padded(cell: Text, width: int, left: bool) -> Text:
    room = " " * (width - len(cell))
    return Text.assemble(cell, room) if left else Text.assemble(room, cell)


def _width(columns: Sequence[Lines], block: Table) -> int:
    widths = [max(map(len, column), default=0) for column in columns]
    return block.indent + sum(widths) + block.gap * max(len(widths) - 1, 0)


def _least_width(sections: Sequence[Section]) -> int:
    """Return what room sketches need to stand beside something."""
    return max(
        (b.width for one in sections for b in one.blocks if isinstance(b, Figure)), default=0
    )


# --- columns -----------------------------------------------------------------------------------


def _has_units(block: Table) -> bool:
    return block.units == "below" and any(c.unit for c in block.columns if not c.bar)


def _shown_place(block: Table, place: int) -> int:
    """Return the place of a column among those that are shown."""
    return sum(not column.only_in_files for column in block.columns[:place])


def _is_text(column: Column) -> bool:
    return any(isinstance(value, str) for value in column.values) and not any(
        isinstance(value, float | int | Number) for value in column.values
    )


def _formed(value: CellContent, form: str) -> CellContent:
    return Number(float(value), form) if isinstance(value, float | int) else value


def _numbers(column: Column) -> list[float]:
    return [
        float(in_unit(value, column.unit)) for value in column.values if isinstance(value, float)
    ]


def _tops(column: Column) -> list[bool]:
    """Tell which cells have the greatest or the least number, where that is to be marked."""
    numbers = [abs(v) if isinstance(v, float) else nan for v in column.values]
    choose = min if column.peak == "minimum" else max
    extreme = choose((n for n in numbers if isfinite(n)), default=nan)
    return [bool(column.peak) and number == extreme for number in numbers]


def _centred_dash(text: str, texts: Sequence[str]) -> str:
    """Put a dash below the last digit before the decimal mark, as far as that is known."""
    if text != ABSENT:
        return text
    longest = max(texts, key=len)
    tail = len(longest) - max(longest.find("."), longest.find(","))
    return text + " " * (tail if tail <= len(longest) else 0)
