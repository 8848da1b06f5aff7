"""What a table shows of cases: each quantity described once, its label, getter, form and path.

A table has a line for each quantity and a column for each case, or for each race, each state of
one case: whatever the quantities are of. One case is a sequence of one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from math import isfinite, nan
from operator import attrgetter
from typing import TYPE_CHECKING, Any, Final, Generic, TypeVar

import numpy as np

from rolamento.document import CellContent, Column, Number, Table
from rolamento.records import frozen
from rolamento.words import manner, said

if TYPE_CHECKING:
    from rolamento.friction import Friction
    from rolamento.friction.seals import SealsAndBath
    from rolamento.life import LifeSummary
    from rolamento.lubrication import Film
    from rolamento.solved import Preloading, Rolling, Solved
    from rolamento.tasks.report import CaseReport
    from rolamento.vibration.frequencies import FaultFrequencies

__all__ = [
    "FILM", "FREQUENCIES", "FRICTION", "LIFE", "PRELOAD", "ROLLING", "SEALS_AND_BATH", "SOLVED",
    "Group", "Part", "Quantity", "beside", "extreme", "number_of", "tables_of",
]  # fmt: skip

T = TypeVar("T")
P = TypeVar("P")

_ABREAST: Final = 2
"""Cases that stand beside the first in one table: more need more paper than there is."""


@frozen
class Quantity(Generic[T]):
    """A number, or a text, of cases or of something else.

    Attributes
    ----------
    label
        what it is called
    of
        gives it in SI; None, or an empty text, where there is none
    form
        of the number, with its unit; its difference has as many figures
    path
        its name in `CaseReport.numbers`, for files
    unit
        where the number is not in SI, and written as it is
    """

    label: str
    of: Callable[[T], float | str | None]
    form: str = ".4"
    path: str = ""
    unit: str = ""

    @property
    def shown_unit(self) -> str:
        """The unit that stands in a column of its own."""
        return self.unit or self.form.partition(" ")[2]

    @property
    def plain_form(self) -> str:
        """The form of the number where its unit stands elsewhere."""
        figures, _, unit = self.form.partition(" ")
        return f"{figures} [{unit}]" if unit else figures

    def number(self, thing: T) -> float | None:
        """Return the number of a thing; None where there is none, or where it is a text."""
        value = self.of(thing)
        return None if value is None or isinstance(value, str) else number_of(value)

    def cell(self, thing: T) -> str | Number:
        """Return what a table shows of a thing."""
        value = self.of(thing)
        if isinstance(value, str):
            return value
        number = None if value is None else number_of(value)
        return Number(nan if number is None else number, self.plain_form)

    def known(self, things: Iterable[T]) -> bool:
        """Whether any of some things has it."""
        cells = (self.cell(one) for one in things)
        return any(cell if isinstance(cell, str) else isfinite(cell.value) for cell in cells)


Group = tuple[str, Sequence[Quantity[T]]]
"""Quantities below a name."""


def number_of(value: Any) -> float | None:
    """Return a number, or the first of an array; None where it is not finite."""
    number = float(np.ravel(value)[0])
    return number if isfinite(number) else None


def beside(
    quantities: Sequence[Quantity[T]], things: Iterable[tuple[str, str, T]]
) -> Iterator[Column]:
    """Yield quantities by name and unit, and a column for each thing: its key, its head, itself."""
    yield Column("", [one.label for one in quantities], "quantity")
    yield Column(said("unit"), [one.shown_unit for one in quantities], "unit")
    for key, head, thing in things:
        yield Column(head, [one.cell(thing) for one in quantities], key, align="right")


# --- quantities of cases --------------------------------------------------------------------------


@frozen
class Part(Generic[P]):
    """A part of what is known of a case, and where `CaseReport.numbers` has it."""

    path: str
    of: Callable[[CaseReport], P | None]

    def __call__(
        self, label: str, path: str, form: str = ".4", get: Callable[[P], Any] | None = None
    ) -> Quantity[CaseReport]:
        """Return a quantity of this part.

        get: a number, or an array of which the first counts; by default what is called as in the
        path.
        """
        own = get or attrgetter(path)

        def of(case: CaseReport) -> float | None:
            part = self.of(case)
            value = None if part is None else own(part)
            return None if value is None else number_of(value)

        return Quantity(label, of, form, f"{self.path}.{path}")


def _rolling(case: CaseReport) -> Rolling | None:
    return case.analysis.solved.rolling if case.converged else None


SOLVED: Final[Part[Solved]] = Part("analysis", lambda case: case.analysis.solved)
LIFE: Final[Part[LifeSummary]] = Part("analysis.life", lambda case: case.analysis.life)
FILM: Final[Part[Film]] = Part("analysis.film", lambda case: case.analysis.film)
FRICTION: Final[Part[Friction]] = Part("analysis.friction", lambda case: case.analysis.friction)
ROLLING: Final[Part[Rolling]] = Part("analysis.rolling", _rolling)
PRELOAD: Final[Part[Preloading]] = Part(
    "analysis.preload", lambda case: case.analysis.solved.preload
)
SEALS_AND_BATH: Final[Part[SealsAndBath]] = Part(
    "analysis.seals_and_bath", lambda case: case.analysis.seals_and_bath
)
FREQUENCIES: Final[Part[FaultFrequencies]] = Part(
    "analysis.frequencies", lambda case: case.analysis.frequencies
)


def extreme(label: str, name: str, form: str = ".4") -> Quantity[CaseReport]:
    """Return a quantity of the heaviest contacts by its name in `CaseReport.numbers`."""
    return Quantity(label, lambda case: case.extreme(name), form, f"extremes.{name}")


# --- their tables ---------------------------------------------------------------------------------


def tables_of(
    cases: Sequence[CaseReport],
    groups: Sequence[Group[CaseReport]],
    key: str,
    *,
    caption: str = "",
    legends: tuple[str, ...] = (),
    abreast: int = _ABREAST,
) -> tuple[Table, ...]:
    """Return quantities as tables: a column a case, and what differs in the later ones.

    Quantities that no case has are left out.
    """
    kept = [(name, [one for one in own if one.known(cases)]) for name, own in groups]
    rows = [one for _, own in kept for one in own]
    if not rows:
        return ()
    places, first = [], 0
    for name, own in kept:
        if own and name:
            places.append((first, name))
        first += len(own)
    later = cases[1:]
    parts = [later[at : at + abreast] for at in range(0, len(later), abreast)] or [[]]
    return tuple(
        Table(
            tuple(_columns(cases[0], part, rows, many=len(cases) > 1)),
            key if number == 0 else f"{key}_{number + 1}",
            caption=caption,
            groups=tuple(places),
            legends=legends if number == len(parts) - 1 else (),
            rule=True,
            fixed=2,
        )
        for number, part in enumerate(parts)
    )


def _columns(
    first: CaseReport,
    later: Sequence[CaseReport],
    rows: Sequence[Quantity[CaseReport]],
    *,
    many: bool,
) -> Iterator[Column]:
    yield Column(said("quantity"), [row.label for row in rows], "quantity")
    yield Column(said("unit"), [row.shown_unit for row in rows], "unit", tone="faint")
    for case in (first, *later):
        head = said("case {name}", name=case.name) if many else said("value")
        yield Column(head, [row.cell(case) for row in rows], case.name, align="right")
        if case is not first and case.converged and first.converged:
            pairs = [_differences(row, first, case) for row in rows]
            for place, head, key in ((0, "Δ", "difference"), (1, "Δ, %", "percent")):
                values = [pair[place] for pair in pairs]
                yield Column(head, values, f"{case.name}_{key}", align="right", tone="faint")
    yield Column("path", [row.path or None for row in rows], "path", only_in_files=True)


def _differences(
    row: Quantity[CaseReport], first: CaseReport, case: CaseReport
) -> tuple[CellContent, CellContent]:
    """The difference to the first case, and its share; none of what is printed alike."""
    before, own = row.number(first), row.number(case)
    if before is None or own is None:
        return None, None
    write, form = manner().number, row.plain_form
    if write(before, form) == write(own, form):  # what is less is rounding
        return Number(0.0), None
    absolute = Number(own - before, f"+{form.replace('[°C]', '[K]')}")
    if row.shown_unit == "°C" or write(before, form) == write(0.0, form):
        return absolute, None
    return absolute, Number((own - before) / abs(before), "+.1f [%]")
