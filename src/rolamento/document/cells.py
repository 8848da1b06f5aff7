"""What the media share: numbers as texts, what stands where in a table, symbols and links.

Numbers are written in the language that is spoken (`rolamento.words.speaking`).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from math import isfinite, nan
from typing import Final

from rolamento.document.model import Bars, CellContent, Column, Number, Table
from rolamento.words import ABSENT, UNITS, decimals_for, in_unit, manner

__all__ = [
    "PEAK",
    "address",
    "broken",
    "cell",
    "cells",
    "characters",
    "figure_spaced",
    "grouped",
    "has_unit_line",
    "indexed",
    "peaks",
    "shares",
    "shares_of_bars",
    "shown",
    "stands_left",
    "table_of_bars",
]

PEAK: Final = "◂"
"""What stands behind the greatest number of a column."""

_AS_WIDE_AS_DIGIT: Final = "\u2007"
_AS_WIDE_AS_MARK: Final = "\u2008"
_LONGEST_LINE: Final = 40
_BAR: Final = 16
_MOST_WIDER: Final = 1
"""Characters by which decimal marks in line may widen a column."""
_INDEXED: Final = re.compile(
    r"(?<![\w.\\@-])([A-Za-zα-ωΑ-Ωµ](')?)_((?(2)[^\W_]+|[A-Za-z0-9]{1,4}))"
    r"(?![^\W²³]|[.\\@-]\w|/(?!\d|[A-Za-zα-ω]['_])\w|_)"
)
"""A letter with an index, ``Q_max``, ``d_m/2``, ``x_0²``, ``E'_steel``; not in names or paths."""
_GROUP: Final = re.compile(r"(?<=\d) (?=\d{3}(?!\d))")
_UNITS: Final = "|".join(map(re.escape, filter(None, (*UNITS, "%"))))
_UNIT: Final = re.compile(rf"(?<=[\d∞⁶]) (?=(?:{_UNITS})(?!\w))")
"""A space between a number and its unit."""
_SCHEME: Final = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*:")


# --- numbers -----------------------------------------------------------------------------------


def cells(column: Column) -> list[str]:
    """Write the cells of a column: numbers with the same decimals.

    Numbers of their own form are padded on the right, so that their decimal marks fall below each
    other where all characters are of one width; not where that would take much room.
    """
    if column.form:
        values = [_formed(value, column.form) for value in column.values]
        column = replace(column, values=values, form="")
    numbers = [in_unit(value, column.unit) for value in column.values if isinstance(value, float)]
    decimals = decimals_for(numbers, column.figures, column.most)
    texts = [cell(value, column.unit, decimals) for value in column.values]
    if any(isinstance(value, Number) for value in column.values):
        own = [not isinstance(value, str) for value in column.values]
        unlined = [text for text, numeric in zip(texts, own, strict=True) if numeric and text]
        mark = manner().mark
        tails = [len(t) - t.index(mark) if mark in t and "e" not in t else 0 for t in unlined]
        lined = [t + " " * (max(tails) - tail) for t, tail in zip(unlined, tails, strict=True)]
        wider = max(map(len, lined), default=0) - max(map(len, unlined), default=0)
        written = iter(lined if wider <= _MOST_WIDER else unlined)
        texts = [
            next(written) if numeric and text else text
            for text, numeric in zip(texts, own, strict=True)
        ]
    if column.once:
        texts = ["" if row and text == texts[row - 1] else text for row, text in enumerate(texts)]
    if all(isinstance(value, str | None) for value in column.values):
        return texts
    longest = max(texts, key=len)  # a dash stands below the last digit before the decimal mark
    tail = len(longest) - max(longest.find("."), longest.find(","))
    dash = ABSENT + " " * (tail if tail <= len(longest) else 0)
    return [dash if text == ABSENT else text for text in texts]


def cell(value: CellContent, unit: str = "", decimals: int = 0) -> str:
    """Write one cell: an SI number in a unit with so many decimals, or in its own form."""
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    if isinstance(value, Number):
        return f"{value.before}{manner().number(value.value, value.form)}{value.behind}"
    if isinstance(value, bool | int):
        return manner().fixed(float(value), 0)
    return manner().fixed(float(in_unit(value, unit)), decimals)


def figure_spaced(text: str) -> str:
    """Return a number padded on the right by spaces as wide as the digits that it lacks."""
    bare = text.rstrip(" ")
    room = len(text) - len(bare)
    if not room:
        return text
    mark = "" if manner().mark in bare else _AS_WIDE_AS_MARK
    return bare + mark + _AS_WIDE_AS_DIGIT * (room - len(mark))


def peaks(column: Column) -> list[bool]:
    """Return which cells have the greatest or the least number, where that is to be marked."""
    numbers = [abs(v) if isinstance(v, float) else nan for v in column.values]
    choose = min if column.peak == "minimum" else max
    extreme = choose((n for n in numbers if isfinite(n)), default=nan)
    return [bool(column.peak) and number == extreme for number in numbers]


def shares(column: Column) -> list[float]:
    """Return the lengths of a column of bars over that of the greatest."""
    numbers = [v if isinstance(v, float) and isfinite(v) else 0.0 for v in column.values]
    greatest = max(numbers, default=0.0)
    return [number / greatest if greatest > 0.0 else 0.0 for number in numbers]


def shares_of_bars(block: Bars) -> list[float]:
    """Return the lengths of bars over that of the greatest."""
    greatest = max((bar.length for bar in block.bars), default=0.0)
    return [
        bar.length / greatest if greatest > 0.0 and bar.length > 0.0 else 0.0 for bar in block.bars
    ]


# --- tables ------------------------------------------------------------------------------------


def shown(block: Table) -> tuple[Column, ...]:
    """Return the columns that a reader sees."""
    return tuple(column for column in block.columns if not column.only_in_files)


def broken(block: Table, fits: Callable[[Table], bool]) -> Iterator[tuple[str, Table]]:
    """Return a table, or where it does not fit the parts that it may be broken into.

    Each comes with its heading; all have only the columns that a reader sees.
    """
    columns = shown(block)
    legends = tuple(text for text in (*block.legends, *(b.legend for b in block.breaks)) if text)
    whole = replace(block, columns=columns, legends=legends, breaks=())
    if not block.breaks or fits(whole):
        yield "", whole
        return
    places = [sum(not c.only_in_files for c in block.columns[: b.column]) for b in block.breaks]
    yield "", replace(whole, columns=columns[: places[0]], legends=block.legends)
    for each, start, end in zip(block.breaks, places, [*places[1:], len(columns)], strict=True):
        part = (*columns[: block.fixed], *columns[start:end])
        yield each.heading, replace(whole, columns=part, legends=(each.legend,))


def characters(block: Table) -> int:
    """Return about how many characters a table is wide, its columns two apart."""
    width = 0
    for column in block.columns:
        if column.only_in_files:
            continue
        words = max((len(word) for word in column.head.split()), default=0)
        longest = max((min(len(text), _LONGEST_LINE) for text in cells(column)), default=0)
        width += 2 + (_BAR if column.bar else max(words, len(column.unit), longest))
        width += 2 * bool(column.peak)
    return width


def table_of_bars(block: Bars) -> Table:
    """Return labels and numbers of bars as a table."""
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
    return Table(columns=columns, headless=not any(block.heads), units="behind", key=block.key)


def has_unit_line(block: Table) -> bool:
    """Return whether units stand in a line of their own below the heads."""
    return block.units == "below" and any(c.unit for c in block.columns if not c.bar)


def stands_left(column: Column) -> bool:
    """Return whether the cells of a column stand on the left: texts, if nothing else is said."""
    texts = {isinstance(value, str) for value in column.values if value is not None}
    return column.align == "left" or (not column.align and texts == {True})


# --- texts -------------------------------------------------------------------------------------


def address(target: str, *, web_only: bool = False) -> str:
    """Return where a link leads: to the web or to a file beside the page; else nothing."""
    if target.lower().startswith(("http://", "https://")):
        return target
    elsewhere = _SCHEME.match(target) or target.startswith(("/", "\\"))
    return "" if elsewhere or web_only else target


def grouped(text: str) -> str:
    """Return a text with spaces that do not break within its numbers: 30 000 000."""
    return _GROUP.sub("\u00a0", text)


def indexed(text: str) -> Sequence[tuple[str, str]]:
    """Part a text into pieces, each with the index that follows it: ``a_ISO`` ``("a", "ISO")``.

    A number, its groups and its unit stay together.
    """
    text = _UNIT.sub("\u00a0", grouped(text))
    pieces: list[tuple[str, str]] = []
    end = 0
    for found in _INDEXED.finditer(text):
        pieces.append((text[end : found.end(1)], found[3]))
        end = found.end()
    return [*pieces, (text[end:], "")]


# -----------------------------------------------------------------------------------------------


def _formed(value: CellContent, form: str) -> CellContent:
    return Number(float(value), form) if isinstance(value, float | int) else value
