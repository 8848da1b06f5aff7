"""A field of a case and its values, as pages over a field have them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.charts.axes_units import read_values
from rolamento.document import Column, Notes, Remark, Statement
from rolamento.words import UNITS, Note, manner, said
from rolamento.words.reasons import reason

if TYPE_CHECKING:
    from collections.abc import Iterable

    from rolamento.case.fields import Field
    from rolamento.words.headlines import Qualified

__all__ = ["cautions_over", "failures", "field_column", "place_text", "read_text"]

_DECADES: Final = 100.0


def field_column(field: Field, values: NDArray[np.float64]) -> Column:
    """Return the column of a field's values, each with its own digits where they span decades."""
    symbol = read_values(field, values)[1]
    wide = np.abs(values).max() > _DECADES * np.abs(values).min() > 0.0
    return Column(
        "",
        values.tolist(),
        field.name,
        symbol if symbol in UNITS else "",
        figures=5,
        most=6,
        form=f".4 [{symbol}]" if wide and symbol in UNITS else "",
    )


def read_text(field: Field, values: NDArray[np.float64], value: float) -> str:
    """Write one of the values of a field, with the unit in which all of them are read."""
    across, symbol = read_values(field, values)
    place = int(np.argmin(np.abs(values - value)))
    number = manner().short(float(across[place]), 4)
    return number if symbol == "–" else f"{number} {symbol}"


def place_text(field: Field, values: NDArray[np.float64], where: NDArray[np.bool_]) -> str:
    """Say at which values of a field something holds: at all, at one, between two."""
    if where.all():
        return said("everywhere")
    some = values[where]
    least, greatest = (read_text(field, values, float(v)) for v in (some.min(), some.max()))
    if least == greatest:
        return said("at {value}", value=least)
    return said("from {least} to {greatest}", least=least, greatest=greatest)


def cautions_over(
    field: Field, values: NDArray[np.float64], found: Iterable[Qualified]
) -> tuple[Notes, ...]:
    """Return what qualifies the numbers over a field, and where; nothing without."""

    def text(note: Note, where: NDArray[np.bool_]) -> str:
        if where.all():
            return note.text
        return said("{note} ({place})", note=note.text, place=place_text(field, values, where))

    remarks = tuple(Remark(text(note, where), note.key, "warning") for note, where in found)
    return (Notes(remarks),) if remarks else ()


def failures(status: NDArray[np.str_]) -> list[Statement]:
    """Say how many points of a curve have no result, and why; nothing where all have one."""
    failed = status[status != "converged"]
    if not failed.size:
        return []
    text = said(
        "{failed} of {count} points without a result: {reasons}",
        failed=int(failed.size),
        count=int(status.size),
        reasons=[reason(code) for code in np.unique(failed).tolist()],
    )
    return [Statement(text, "bad-strong", indent=2)]
