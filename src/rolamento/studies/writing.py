"""Results as files, written chunk by chunk: NetCDF, CSV, Parquet."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import Final, Protocol

from rolamento.errors import FileError
from rolamento.studies.plan import Part, Plan

__all__ = ["ENDINGS", "PartWriter", "Writer", "writer_for"]

ENDINGS: Final = (".nc", ".csv", ".parquet")


class PartWriter(Protocol):
    """Takes the parts of a result, one after the other from the first to the last."""

    def put(self, part: Part) -> None:
        """Write a part."""
        ...


Writer = Callable[
    [Path, Plan, Mapping[str, int], tuple[str, ...]], AbstractContextManager[PartWriter]
]
"""Opens a file for the parts of a plan; takes also the counts by status and the messages."""


def writer_for(path: Path) -> Writer:
    """Return the writer of a file's kind, by the name's ending.

    Raises
    ------
    FileError
        If it is none of the known ones.
    """
    ending = path.suffix.lower()
    if ending not in ENDINGS:
        raise FileError(
            f"must end in {', '.join(ENDINGS[:-1])} or {ENDINGS[-1]}",
            source=str(path),
            example="result.nc",
        )
    return lambda place, plan, counts, messages: _opened(ending, place, plan, counts, messages)


@contextmanager
def _opened(
    ending: str, place: Path, plan: Plan, counts: Mapping[str, int], messages: tuple[str, ...]
) -> Iterator[PartWriter]:
    """Open a writer; what the disk refuses is told as a `FileError`."""
    try:
        with _writer(ending)(place, plan, counts, messages) as opened:
            yield opened
    except FileError:
        raise
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise FileError(f"cannot be written: {reason}", source=str(place)) from None


def _writer(ending: str) -> Writer:
    """Import the writer of a kind: each brings a library that the others do not need."""
    if ending == ".nc":
        from rolamento.studies.netcdf import netcdf_writer

        return netcdf_writer
    from rolamento.studies import tables

    return tables.csv_writer if ending == ".csv" else tables.parquet_writer
