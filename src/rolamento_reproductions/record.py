"""What a reproduction consists of: figures and tables with their data, and checked statements.

Plain frozen records. How they are drawn and written is the affair of `drawing`, `page` and
`writing`; what is drawn is named by column, so that a picture cannot differ from its data.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from rolamento_reproductions.errata import Errata
from rolamento_reproductions.printed import Cell
from rolamento_reproductions.text import Text

__all__ = [
    "Claim",
    "Column",
    "Curves",
    "Ending",
    "Figure",
    "Line",
    "Map",
    "Maps",
    "Panel",
    "Part",
    "Positions",
    "Section",
    "Source",
    "Table",
    "TableColumn",
    "Verdict",
]

Floats = NDArray[np.float64]
STATUS: Final = "status"
Ending = Literal["svg", "png"]
Verdict = Literal["holds", "partly", "fails"]

_PLAIN_UNITS: Final = {
    "°": "deg",
    "°C": "degC",
    "N·m": "Nm",
    "N·mm": "Nmm",
    "m/s": "m_per_s",
    "mm²/s": "mm2_per_s",
    "µm": "um",
}
"""How a unit stands in the header of a file."""


@dataclass(frozen=True, slots=True, eq=False)
class Column:
    """One quantity of a figure's data.

    name: in the header of the file; unit: as people use it, "" where there is none; title: for an
    axis; values: numbers, NaN where there is no result, or words.
    """

    name: str
    unit: str
    title: Text
    values: Floats | Sequence[str]

    @property
    def header(self) -> str:
        """The name with its unit, such as ``"axial_load_kN"``."""
        unit = _PLAIN_UNITS.get(self.unit, self.unit)
        return f"{self.name}_{unit}" if unit else self.name

    @property
    def numbers(self) -> Floats:
        """The values as numbers."""
        return np.asarray(self.values, dtype=np.float64)


@dataclass(frozen=True, slots=True)
class Claim:
    """What the source states in words, what the program finds, and whether they agree.

    partly: the statement holds for a part only, which the finding tells; of_theory: the statement
    is not the source's, but what theory lets expect of its subject.
    """

    statement: Text
    finding: Text
    holds: bool
    partly: bool = False
    of_theory: bool = False

    @property
    def verdict(self) -> Verdict:
        """Whether the statement "holds", holds "partly", or "fails"."""
        return "holds" if self.holds else "partly" if self.partly else "fails"


@dataclass(frozen=True, slots=True)
class Line:
    """One line of a picture: a column over the panel's x, in the rows where `by` has a value.

    look: index of colour and marker; dashed: beside a solid line of the same look; marked: the
    column that is a number in the rows that get a marker; points: markers without a line, as for
    what was measured; label: None for a line that the legend's other entries explain.
    """

    y: str
    look: int
    label: Text | None = None
    by: tuple[str, float] | None = None
    dashed: bool | None = None
    marked: str | None = None
    points: bool = False


@dataclass(frozen=True, slots=True)
class Panel:
    """One pair of axes.

    tick: distance of the x axis's numbers; x_ticks, y_ticks: places with what stands there instead,
    where an axis is not numbered by its own values; keys: what solid and dashed lines stand for;
    around: x is an azimuth, and the lines close round the ring; from_zero: the y axis begins at
    zero if nothing lies below; legend_columns: of a legend whose words are long.
    """

    x: str
    y_title: Text
    y_unit: str
    lines: tuple[Line, ...]
    tick: float | None = None
    keys: tuple[Text, Text] | None = None
    around: bool = False
    from_zero: bool = True
    legend_columns: int | None = None
    x_ticks: tuple[tuple[float, str], ...] = ()
    y_ticks: tuple[tuple[float, str], ...] = ()


@dataclass(frozen=True, slots=True)
class Curves:
    """A picture of lines, in panels side by side with one y axis."""

    panels: tuple[Panel, ...]


@dataclass(frozen=True, slots=True)
class Map:
    """One field over a contact ellipse: its column, a title, and arrows (columns along x and y).

    signed: where it changes its sign, zero is in the middle of the colours, with a dashed line.
    """

    value: str
    title: Text
    signed: bool = True
    arrows: tuple[str, str] | None = None


@dataclass(frozen=True, slots=True)
class Maps:
    """A picture of fields over a contact ellipse, one below the other.

    The rows of the data are a grid: `count` lines across, each over the whole of the ellipse.
    """

    x: str
    y: str
    count: int
    maps: tuple[Map, ...]


@dataclass(frozen=True, slots=True)
class Positions:
    """A picture of the balls of a bearing in their places, to scale; lengths in mm."""

    ball_diameter: float
    pitch_diameter: float


@dataclass(frozen=True, slots=True, eq=False)
class Figure:
    """A figure: its data, what it looks like, and what the source says about it."""

    number: str
    caption: Text
    source: Text
    columns: tuple[Column, ...]
    picture: Curves | Maps | Positions
    claims: tuple[Claim, ...] = ()
    notes: tuple[Text, ...] = ()

    @property
    def stem(self) -> str:
        """Its files' name without an ending; sorts in order: ``"figure-5.01"``, ``"figure-08"``."""
        *chapter, figure = self.number.split(".")
        return "figure-" + ".".join([*chapter, f"{int(figure):02d}"])

    def column(self, name: str) -> Column:
        """Return the column of a name."""
        return next(column for column in self.columns if column.name == name)

    @property
    def gaps(self) -> tuple[tuple[int, str], ...]:
        """Rows without a result, with the status that says why."""
        found = [column for column in self.columns if column.name == STATUS]
        states = [str(value) for value in found[0].values] if found else []
        return tuple((row, code) for row, code in enumerate(states) if code != "converged")


@dataclass(frozen=True, slots=True, eq=False)
class TableColumn:
    """A column of a table: words and numbers as they stand there, or printed beside computed.

    heads: what printed and computed are called over such a column, where it is not that; sentences:
    whether the cells are to be read, not compared.
    """

    name: str
    title: Text
    cells: tuple[str, ...] | tuple[Text, ...] | tuple[Cell, ...]
    heads: tuple[Text, Text] | None = None
    sentences: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Table:
    """A table: printed numbers, each beside what the program computes, or computed ones alone."""

    number: str
    caption: Text
    source: Text
    columns: tuple[TableColumn, ...]
    claims: tuple[Claim, ...] = ()
    notes: tuple[Text, ...] = ()

    @property
    def stem(self) -> str:
        """Its file's name without an ending."""
        return f"table-{self.number}"

    @property
    def cells(self) -> tuple[Cell, ...]:
        """All printed numbers, column by column."""
        return tuple(cell for c in self.columns for cell in c.cells if isinstance(cell, Cell))


@dataclass(frozen=True, slots=True, eq=False)
class Section:
    """Figures, tables and misprints that belong together, in the order of the source."""

    title: Text
    items: tuple[Figure | Table | Errata, ...]


@dataclass(frozen=True, slots=True)
class Part:
    """A section to be computed: its title, the stems of what it will hold, and how."""

    title: Text
    holds: tuple[str, ...]
    compute: Callable[[Text], Section]

    @property
    def figures(self) -> tuple[str, ...]:
        """The stems of its figures."""
        return tuple(stem for stem in self.holds if stem.startswith("figure-"))


@dataclass(frozen=True, slots=True)
class Source:
    """A publication that can be reproduced. remarks: what holds for all of it."""

    name: str
    title: Text
    reference: Text
    remarks: tuple[Text, ...]
    parts: tuple[Part, ...]
