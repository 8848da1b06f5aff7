"""What pages say of the data behind them: a signal, and tables that stand only in files."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Protocol

from rolamento.document import CellContent, Column, Entry, Section, Table
from rolamento.words import said
from rolamento.words.quantities import called

__all__ = ["in_files", "signal_entry"]


class Recorded(Protocol):
    """Something that was measured over time."""

    @property
    def quantity(self) -> str:
        """What was measured, by its name in `rolamento.words.quantities`."""

    @property
    def duration(self) -> float:
        """How long; s."""

    @property
    def rate(self) -> float:
        """Samples in a second; Hz."""


def signal_entry(signal: Recorded) -> Entry:
    """Return what was measured, how long and how often."""
    text = said(
        "{quantity}, {duration:.4 s} at {rate:.6 Hz}",
        quantity=called(signal.quantity),
        duration=signal.duration,
        rate=signal.rate,
    )
    return Entry(said("signal"), text)


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
