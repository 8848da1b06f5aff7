"""Parquet files, read by batches of rows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, Final

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from rolamento.errors import FileError
from rolamento.io.foreign.bounds import LARGEST_WHOLE, guarded, size_of_file
from rolamento.numerics import FloatArray
from rolamento.vibration.reading.channels import (
    MOST_CHANNELS,
    MOST_SAMPLES,
    Channel,
    Source,
    checked_channels,
)
from rolamento.vibration.reading.metadata import (
    Timeline,
    label_parts,
    rate_of,
    rates_among,
    speed_among,
    time_scale,
    unit_among,
)
from rolamento.vibration.reading.units import quantity_of_unit
from rolamento.words import marked, said

__all__ = ["ParquetSource"]

_BATCH: Final = 65_536
_BUFFER: Final = 2**20
"""Bytes read at once of a large file; of others, all of a column in a group of rows.

The buffer grows to what a page says that it takes, which a damaged one may overdo.
"""
_MOST_GROUPS: Final = 100_000
_MOST_TEXT: Final = 2**20


class ParquetSource(Source):
    """An open Parquet file; columns of times or of texts are no channels."""

    def __init__(self, path: Path) -> None:
        self._source = str(path)
        size = size_of_file(path)
        self._position: tuple[tuple[int, ...], int] = ((), 0)
        self._batches: Iterator[FloatArray] = iter(())
        self._rest = np.empty((0, 1))
        with guarded(self._source, marked("Parquet file")):
            self._file = pq.ParquetFile(
                path,
                memory_map=False,
                pre_buffer=False,
                buffer_size=_BUFFER if size > LARGEST_WHOLE else 0,
                thrift_string_size_limit=16 * _MOST_TEXT,
                thrift_container_size_limit=_MOST_TEXT,
            )
        try:
            with guarded(self._source, marked("Parquet file")):
                self._look()
                self.numbers = _numbers_among(self._texts)
                channels = [self._channel(field) for field in self._fields]
            self.channels = checked_channels(channels, self._source, marked("Parquet file"))
        except BaseException:
            self.close()
            raise

    def read(self, channels: Sequence[int], start: int, count: int) -> FloatArray:
        """Return samples of some channels; the times beside them are checked."""
        samples = np.empty((len(channels), count))
        filled = 0
        with guarded(self._source, marked("Parquet file")):
            if self._position != (tuple(channels), start):
                self._seek(channels, start)
            self._position = ((), 0)  # until all of it is read
            while filled < count:
                rows = self._next(count - filled)
                if self._timeline is not None:
                    self._timeline.check(rows[:, -1], start + filled, self._source)
                samples[:, filled : filled + len(rows)] = rows.T[: len(channels)]
                filled += len(rows)
        self._position = (tuple(channels), start + count)
        return samples

    def close(self) -> None:
        """Let go of the file."""
        self._batches = iter(())
        self._file.close()

    def _look(self) -> None:
        """Take the columns of numbers, the column of times, and what the file says of them.

        The description of a single column in a group of rows is not asked for: over a damaged one
        the library ends the program.
        """
        schema, about = self._file.schema_arrow, self._file.metadata
        if len(schema) > MOST_CHANNELS or about.num_row_groups > _MOST_GROUPS:
            rule = said(
                "has more than {most} columns or {most_2} row groups",
                most=MOST_CHANNELS,
                most_2=_MOST_GROUPS,
            )
            raise FileError(rule, source=self._source)
        self._groups = [about.row_group(n).num_rows for n in range(about.num_row_groups)]
        if sum(self._groups) != about.num_rows or min(self._groups, default=0) < 0:
            raise FileError(said("is damaged: its row counts do not add up"), source=self._source)
        if max(self._groups, default=0) > MOST_SAMPLES:
            raise FileError(
                said("must be at most {most}; write smaller groups", most=MOST_SAMPLES),
                field=marked("rows in a group"),
                value=max(self._groups),
                source=self._source,
            )
        fields = [field for field in schema if _is_real(field.type)]
        names = [field.name for field in fields]
        if len(set(names)) < len(names):
            raise FileError(said("has two columns of the same name"), source=self._source)
        self._texts = _texts(schema.metadata)
        self._timeline: Timeline | None = None
        self._time_name = ""
        self._fields = fields
        for field in fields:
            scale = time_scale(*label_parts(field.name))
            if scale is not None:
                self._fields = [other for other in fields if other is not field]
                self._take_time(field.name, scale)
                break

    def _take_time(self, name: str, scale: float) -> None:
        count = sum(self._groups)
        ends = []
        for row in (0, count - 1):
            self._batches = self._rows([name], max(row, 0))
            ends.append(float(next(self._batches, np.full((1, 1), np.nan))[0, 0]))
        self._timeline = Timeline.between(ends[0], ends[1], count, scale, self._source)
        self._time_name = name

    def _channel(self, field: Any) -> Channel:
        texts = {**self._texts, **_texts(field.metadata)}
        numbers = _numbers_among(texts)
        times = None if self._timeline is None else self._timeline.rate
        rate = rate_of(rates_among([numbers]), times)
        name, unit = label_parts(field.name)
        unit = unit_among(_texts(field.metadata)) or unit
        count = sum(self._groups)
        return Channel(
            name,
            count,
            rate.value,
            unit,
            quantity_of_unit(unit),
            speed_among(numbers),
            rate.doubt,
            rate.aside,
        )

    def _seek(self, channels: Sequence[int], start: int) -> None:
        names = [self._fields[channel].name for channel in channels]
        if self._timeline is not None:
            names.append(self._time_name)
        self._batches = self._rows(names, start)
        self._rest = np.empty((0, len(names)))

    def _next(self, count: int) -> FloatArray:
        """Up to so many rows that follow; (rows, columns)."""
        if len(self._rest) == 0:
            self._rest = next(self._batches, self._rest)
            if len(self._rest) == 0:
                raise FileError(said("ends before its last row"), source=self._source)
        rows, self._rest = self._rest[:count], self._rest[count:]
        return rows

    def _rows(self, names: list[str], start: int) -> Iterator[FloatArray]:
        """Batches of rows of some columns from a row on; (rows, columns) each."""
        first = 0
        group = 0
        while group < len(self._groups) - 1 and first + self._groups[group] <= start:
            first += self._groups[group]
            group += 1
        skip = start - first
        wanted = range(group, len(self._groups))
        for batch in self._file.iter_batches(
            batch_size=_BATCH, row_groups=list(wanted), columns=names, use_threads=False
        ):
            if skip < batch.num_rows:
                table = np.column_stack([_numbers(batch.column(name)) for name in names])
                yield table[skip:]
            skip = max(0, skip - batch.num_rows)


def _is_real(kind: Any) -> bool:
    return bool(pa.types.is_integer(kind) or pa.types.is_floating(kind))


def _numbers(column: Any) -> FloatArray:
    """Numbers of a column; those that are missing become NaN."""
    return np.asarray(column.cast(pa.float64(), safe=False).to_numpy(zero_copy_only=False))


def _texts(metadata: dict[bytes, bytes] | None) -> dict[str, str]:
    """Short entries of the metadata."""
    return {
        name.decode("utf-8", "replace"): text.decode("utf-8", "replace")
        for name, text in (metadata or {}).items()
        if len(name) < 100 and len(text) < 100
    }


def _numbers_among(texts: dict[str, str]) -> dict[str, float]:
    """Entries of the metadata that are numbers, and not 0."""
    return {name: value for name, text in texts.items() if (value := _number(text))}


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None
