"""What a page is made of, whatever it is shown on: terminal, HTML, PDF, Markdown, notebook, tables.

A page is a `Document` of sections; a section is a heading and blocks; blocks hold texts that are
said already (`rolamento.words.said`) and numbers in SI, which the medium writes in the unit that
the block names. What a medium does with them is its own affair.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import field
from math import isfinite
from typing import TYPE_CHECKING, Literal

from rolamento.records import frozen
from rolamento.words import language

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Picture

__all__ = [
    "Bar",
    "Bars",
    "Beside",
    "Block",
    "Break",
    "CellContent",
    "Column",
    "Document",
    "Entry",
    "Equation",
    "Figure",
    "KeyValues",
    "Link",
    "Links",
    "Notes",
    "Number",
    "Remark",
    "Section",
    "Statement",
    "Symbol",
    "Table",
    "Title",
    "Tone",
    "finite_cells",
]

Tone = Literal["", "strong", "faint", "mark", "good", "good-strong", "warning", "warning-strong",
               "bad", "bad-strong", "peak"]  # fmt: skip
"""How a text is meant: what a medium colours, and prints so that it is seen without colours too."""


@frozen
class Number:
    """A number with a form of its own.

    Parameters
    ----------
    value
        In SI.
    form
        As `rolamento.words.manner` says: ``".4 rpm"``; ``".4 [rpm]"`` where the unit stands
        elsewhere.
    before, behind
        What stands at it, such as ``"×"`` or ``"<"``.
    """

    value: float
    form: str = ""
    before: str = ""
    behind: str = ""


CellContent = float | int | str | Number | None
"""A number in the manner of its column, a text, a number of its own form; None for what is not."""


def finite_cells(values: Iterable[float]) -> list[CellContent]:
    """Return the cells of numbers, empty where one is not finite."""
    return [value if isfinite(value) else None for value in values]


@frozen
class Title:
    """The title of a page, or of a part of it that could be a page."""

    text: str


@frozen
class Statement:
    """A sentence or several: what a page says first. A line break begins a new line.

    Parameters
    ----------
    text
        What is said.
    tone
        How it is meant.
    indent
        How far it stands in, in characters.
    mark
        What stands before it, such as ``"✓"``; the lines of the text hang beside it.
    mark_tone
        How the mark is meant, if not as the text.
    verbatim
        Whether it is to be copied, such as a command: its lines are not broken.
    """

    text: str
    tone: Tone = ""
    indent: int = 0
    mark: str = ""
    mark_tone: Tone = ""
    verbatim: bool = False


@frozen
class Entry:
    """A label and what is said to it: a text, or numbers of their own form."""

    label: str
    content: str | Number
    tone: Tone = ""


@frozen
class KeyValues:
    """Texts beside a column of labels. label_tone: of the labels."""

    entries: tuple[Entry, ...]
    indent: int = 0
    label_tone: Tone = "faint"


@frozen
class Column:
    """A column of a table.

    Parameters
    ----------
    head
        A symbol or words; a line break where a narrow medium begins a new line.
    values
        One a row; numbers in SI.
    key
        Its name in files, such as ``"inner_load"``; by default the head.
    unit
        One of `rolamento.words.UNITS`; stands below the head, or behind it.
    figures, most
        The greatest number has so many significant figures, all have its decimals, at most so
        many.
    form
        Instead: how each number is written by itself (`Number`).
    align
        Left or right; by default numbers right, texts left.
    tone, tones
        Of the whole column, or of each cell.
    peak
        Mark the greatest or the least number.
    bar
        Draw each number as a bar, the greatest as long as there is room; a medium may leave a
        column of bars out, and files have none.
    only_in_files
        Whether the column stands only in what is written to files (CSV, workbook).
    once
        Show a text only where it differs from the one above; files have it in every row.
    """

    head: str
    values: Sequence[CellContent]
    key: str = ""
    unit: str = ""
    figures: int = 4
    most: int = 2
    form: str = ""
    align: Literal["", "left", "right"] = ""
    tone: Tone = ""
    tones: Sequence[Tone] = ()
    peak: Literal["", "maximum", "minimum"] = ""
    bar: bool = False
    only_in_files: bool = False
    once: bool = False


@frozen
class Break:
    """Where a narrow medium may go on with a table of its own: before a column.

    The first columns, up to `Table.fixed`, are shown again.
    """

    column: int
    heading: str
    legend: str = ""


@frozen
class Table:
    """Columns beside each other.

    Parameters
    ----------
    columns
        As many values in each.
    key
        Its name in files, such as ``"balls"``; a table without one is not written to files.
    caption
        What a medium that numbers tables says of it; by default the section's heading.
    legends
        What its symbols mean, below it.
    groups
        Rows before which a line with a name stands: ``((0, "row 0"), (16, "row 1"))``.
    rule
        Whether a line parts head and rows.
    fixed, breaks
        Where it may be broken; see `Break`.
    headless
        Whether no heads are shown.
    only_in_files
        Whether it stands only in what is written to files, such as a spectrum of many rows.
    units
        Whether units stand in a line of their own below the heads, or behind each head.
    """

    columns: tuple[Column, ...]
    key: str = ""
    caption: str = ""
    legends: tuple[str, ...] = ()
    groups: tuple[tuple[int, str], ...] = ()
    rule: bool = False
    fixed: int = 1
    breaks: tuple[Break, ...] = ()
    headless: bool = False
    only_in_files: bool = False
    units: Literal["below", "behind"] = "below"
    indent: int = 2
    gap: int = 2


@frozen
class Bar:
    """A bar, and what stands before it. length: over that of the greatest bar, or in any unit."""

    label: str
    number: CellContent
    length: float
    tone: Tone = ""


@frozen(kw_only=True)
class Bars:
    """Bars below each other: label, number, bar.

    heads: of label and number, where they have any; longest: characters of the greatest bar.
    """

    bars: tuple[Bar, ...]
    key: str = ""
    unit: str = ""
    heads: tuple[str, str] = ("", "")
    legends: tuple[str, ...] = ()
    tone: Tone = "mark"
    longest: int = 24


@frozen
class Figure:
    """A picture, and a sketch of it for media that show only characters.

    Parameters
    ----------
    caption
        What it shows.
    draw
        Returns it as a figure of Matplotlib, or the axes of one; it is drawn only where a medium
        shows it.
    key
        Its name, such as ``"rosette"``.
    alternative
        What it shows, for those who cannot see it; by default what its charts say, or the caption.
    sketch
        Called with the characters that there is room for, and whether braille and blocks can be
        shown; returns lines of (text, tone) pairs.
    width
        Characters that the sketch needs to stand beside something.
    """

    caption: str
    draw: Callable[[], Picture | Axes] | None = None
    key: str = ""
    alternative: str = ""
    sketch: Callable[[int, bool], Sequence[Sequence[tuple[str, Tone]]]] | None = None
    width: int = 0


@frozen
class Remark:
    """One thing that the reader should know; key: the note's, for programs and tests."""

    text: str
    key: str = ""
    tone: Tone = ""


@frozen
class Notes:
    """Things that the reader should know, one below the other."""

    remarks: tuple[Remark, ...]


@frozen
class Symbol:
    """A symbol of an equation: what it means, and its unit."""

    symbol: str
    meaning: str
    unit: str = ""


@frozen(kw_only=True)
class Equation:
    """An equation, with its symbols and its source.

    Parameters
    ----------
    name
        What it gives.
    latex
        For media that set mathematics: what Matplotlib, KaTeX and MathJax understand alike.
    plain
        In plain characters, for a terminal and for those who cannot see it.
    symbols
        That it brings in.
    source
        Author, year, number of the equation there.
    valid
        Where it holds.
    number
        In the document.
    """

    name: str
    latex: str
    plain: str
    symbols: tuple[Symbol, ...] = ()
    source: str = ""
    valid: str = ""
    number: int = 0


@frozen
class Link:
    """A text that leads to a file beside the page, or to an address (http, https)."""

    text: str
    target: str


@frozen
class Links:
    """Where else to look, one link behind the other."""

    links: tuple[Link, ...]


Block = Title | Statement | KeyValues | Table | Bars | Figure | Notes | Equation | Links


@frozen
class Section:
    """A heading, which may be empty, and what stands below it.

    level: 1 for a part of the document, 2 for what is usual, 3 below that.
    """

    heading: str = ""
    blocks: tuple[Block, ...] = ()
    key: str = ""
    level: int = 2


@frozen
class Beside:
    """Sections that stand beside others where there is room, else below them."""

    left: tuple[Section, ...]
    right: tuple[Section, ...]
    gap: int = 3
    key: str = ""


@frozen
class Document:
    """A page: its title and its sections, said in one language.

    Parameters
    ----------
    title
        Also of the window, the file, the PDF. The medium shows it only as a `Title` block.
    sections
        From top to bottom.
    kind
        Of which command, such as ``"solve"``.
    language
        The code of the language that its texts are in.
    main
        Key of the table that a file of one table holds; by default the first that has a key.
    program, date
        Which program and release made it, and when, where a report says so: a running header.
    """

    title: str
    sections: tuple[Section | Beside, ...]
    kind: str = ""
    language: str = field(default_factory=language)
    main: str = ""
    program: str = ""
    date: str = ""

    def parts(self) -> Iterator[Section]:
        """Return its sections one by one, those that stand beside each other too."""
        for one in self.sections:
            if isinstance(one, Beside):
                yield from (*one.left, *one.right)
            else:
                yield one

    @property
    def depths(self) -> dict[int, int]:
        """How deep headings of each level lie, from 0; none lies two deeper than the one above."""
        levels = {section.level for section in self.parts() if section.heading}
        return {level: depth for depth, level in enumerate(sorted(levels))}

    def blocks(self) -> Iterator[Block]:
        """Return its blocks from top to bottom."""
        for section in self.parts():
            yield from section.blocks

    def _repr_html_(self) -> str:
        """Return it as a notebook shows it."""
        from rolamento.document.html import fragment

        return fragment(self)

    def _repr_markdown_(self) -> str:
        """Return it as a notebook without HTML shows it."""
        from rolamento.document.markdown import markdown

        return markdown(self)

    def tables(self) -> tuple[Table, ...]:
        """Return the tables that are written to files."""
        return tuple(b for b in self.blocks() if isinstance(b, Table) and b.key)
