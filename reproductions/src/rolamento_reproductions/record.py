"""What a reproduction consists of: figures and tables with data, misprints, checked statements.

Plain frozen records. How they are drawn and written is the affair of `drawing`, `page` and
`writing`; what is drawn is named by column, so that a picture cannot differ from its data.
Misprinted equations are evaluated at random attitudes, beside the same quantity from vectors in
space; a residual is the distance of the two over the largest term, attitude by attitude.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from decimal import Decimal
from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

from rolamento_reproductions.text import Text

Agreement = Literal["printed", "tie", "cut", "differs"]

_TIE: Final = 0.01
"""Fraction of half a unit of the last digit: how near a tie rounding may go either way."""


@dataclass(frozen=True, slots=True)
class Cell:
    """A number as printed, and as computed in the same unit; cut: printed without rounding."""

    printed: str
    computed: float
    cut: bool = False

    @property
    def unit(self) -> float:
        """One unit of the last printed digit."""
        exponent = Decimal(self.printed).as_tuple().exponent
        assert isinstance(exponent, int)
        return 10.0**exponent

    @property
    def agreement(self) -> Agreement:
        """How the computed number agrees.

        "printed": it rounds to the printed digits; "tie": it lies so near the middle between two
        roundings that the last digit may be either; "cut": of a number known to be printed so, its
        digits cut off are the printed ones; "differs": anything else, NaN too.
        """
        if not math.isfinite(self.computed):
            return "differs"
        halves = abs(self.computed - float(self.printed)) / (0.5 * self.unit)
        if halves <= 1.0 + 1e-9:
            return "printed"
        if halves <= 1.0 + _TIE:
            return "tie"
        beyond = (self.computed - float(self.printed)) / self.unit
        outward = math.copysign(beyond, beyond * float(self.printed))
        return "cut" if self.cut and 0.0 <= outward < 1.0 else "differs"

    @property
    def text(self) -> str:
        """The computed number with two digits more than printed, three where that shows a tie."""
        more = 3 if self.agreement == "tie" else 2
        number = Decimal(self.printed)
        digits = number.as_tuple()
        assert isinstance(digits.exponent, int)
        if "e" in self.printed.lower():
            return f"{self.computed:.{len(digits.digits) - 1 + more}e}".replace("e+0", "e")
        return f"{self.computed:.{max(-digits.exponent, 0) + more}f}"


Floats = NDArray[np.float64]

ERRATA_STEM: Final = "misprints"
"""Name of the page's files without an ending."""


@dataclass(frozen=True, slots=True)
class Residual:
    """How far an equation is from the truth at random attitudes: in the middle, and at most."""

    median: float
    maximum: float


def residual(form: Floats, truth: Floats, scale: Floats) -> Residual:
    """Compare an equation with the truth.

    Parameters
    ----------
    form, truth
        Of one shape, attitudes first.
    scale
        The size of what is compared, above zero, (attitudes,).
    """
    gap = np.abs(form - truth).reshape(len(scale), -1).max(axis=1) / scale
    return Residual(float(np.median(gap)), float(gap.max()))


def power_above(value: float) -> float:
    """Return the power of ten above a residual, at least 1e-15: what stands of rounding."""
    return float(10.0 ** np.ceil(np.log10(max(value, 1e-15)) + 1e-9))


def power_text(value: float) -> str:
    """Return that power as people write it: ``"10⁻¹⁴"``."""
    exponent = round(float(np.log10(power_above(value))))
    return "10" + str(exponent).translate(_RAISED)


_RAISED: Final = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True, slots=True)
class Misprint:
    """One equation, or statement of the text, that is not valid as it is printed.

    number: of the equation, "" for a statement; place: where it stands, for a reader; what: the
    quantity; printed and corrected: as formulas; proof: residuals of both.
    """

    number: str
    place: Text
    what: Text
    printed: Text
    corrected: Text
    derivation: Text
    printed_residual: Residual
    corrected_residual: Residual


@dataclass(frozen=True, slots=True)
class ValidEquation:
    """An equation that was checked likewise and is valid as printed."""

    number: str
    what: Text
    form: Text
    residual: Residual


@dataclass(frozen=True, slots=True)
class Errata:
    """The misprints of a publication, and what was checked and is right.

    remarks: on axes and symbols, before the list; attitudes: how many the proofs rest on.
    """

    caption: Text
    source: Text
    remarks: tuple[Text, ...]
    misprints: tuple[Misprint, ...]
    valid: tuple[ValidEquation, ...]
    attitudes: int

    @property
    def stem(self) -> str:
        """Its files' name without an ending."""
        return ERRATA_STEM


@dataclass(frozen=True, slots=True, eq=False)
class Proof:
    """A quantity at random attitudes: as printed, as corrected, and from vectors.

    Arrays (attitudes, ...) of one shape; scale: (attitudes,), the size of what is compared.
    """

    printed: Floats
    corrected: Floats
    truth: Floats
    scale: Floats


def proven(
    place: tuple[str, Text], what: Text, forms: tuple[Text, Text], derivation: Text, proof: Proof
) -> Misprint:
    """Put a misprint together with the residuals of its proof.

    Parameters
    ----------
    place
        Number of the equation, "" if it has none, and where it stands.
    what
        The quantity.
    forms
        As printed, and as corrected.
    derivation
        In words and formulas.
    proof
        The numbers.
    """
    return Misprint(
        number=place[0],
        place=place[1],
        what=what,
        printed=forms[0],
        corrected=forms[1],
        derivation=derivation,
        printed_residual=residual(proof.printed, proof.truth, proof.scale),
        corrected_residual=residual(proof.corrected, proof.truth, proof.scale),
    )


STATUS: Final = "status"
Ending = Literal["svg", "png"]
Pictures = Literal["svg", "png", "both"]
Progress = Callable[[int, int, Text], None]
"""Called with how much is done, of how much, and what comes next."""
ClaimVerdict = Literal["holds", "partly", "fails"]

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
class Series:
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

    partly: the statement holds for a part only, which the finding shows; of_theory: the statement
    is not the source's, but what theory lets expect of its subject.
    """

    statement: Text
    finding: Text
    holds: bool
    partly: bool = False
    of_theory: bool = False

    @property
    def verdict(self) -> ClaimVerdict:
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
    columns: tuple[Series, ...]
    picture: Curves | Maps | Positions
    claims: tuple[Claim, ...] = ()
    notes: tuple[Text, ...] = ()

    @property
    def stem(self) -> str:
        """Its files' name without an ending; sorts in order: ``"figure-5.01"``, ``"figure-08"``."""
        *chapter, figure = self.number.split(".")
        return "figure-" + ".".join([*chapter, f"{int(figure):02d}"])

    def column(self, name: str) -> Series:
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

    @property
    def compared(self) -> bool:
        """Whether printed numbers stand here beside computed ones."""
        return any(isinstance(cell, Cell) for cell in self.cells)


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
    stems: tuple[str, ...]
    compute: Callable[[Text], Section]

    @property
    def figures(self) -> tuple[str, ...]:
        """The stems of its figures."""
        return tuple(stem for stem in self.stems if stem.startswith("figure-"))


@dataclass(frozen=True, slots=True)
class Source:
    """A publication that can be reproduced. remarks: what holds for all of it."""

    name: str
    title: Text
    reference: Text
    remarks: tuple[Text, ...]
    parts: tuple[Part, ...]

    def reproduce(self, folder: str | None, pictures: Pictures, progress: Progress) -> list[str]:
        """Compute it and write it to a folder (`writing.reproduce`)."""
        from rolamento_reproductions import writing

        return writing.reproduce(self, folder, pictures, progress)
