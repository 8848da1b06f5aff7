"""Tables that a page has no room for: they stand only in files."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from rolamento.document import CellContent, Column, Section, Table

__all__ = ["in_files"]


def in_files(key: str, units: Mapping[str, str], rows: Iterable[Sequence[CellContent]]) -> Section:
    """Return a section with a table that stands only in files.

    Parameters
    ----------
    key
        Of the table.
    units
        Unit of each column, by its key.
    rows
        Numbers in SI.
    """
    values = [list(column) for column in zip(*rows, strict=True)] or [[] for _ in units]
    columns = tuple(
        Column(name, own, name, unit)
        for (name, unit), own in zip(units.items(), values, strict=True)
    )
    return Section("", (Table(columns, key, only_in_files=True),), f"{key}_data")
