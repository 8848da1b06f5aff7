"""HDF5 files, MATLAB 7.3 among them: read in blocks by a process of their own."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

import numpy as np

from rolamento._foreign.child import Child
from rolamento.errors import FileError
from rolamento.numerics import FloatArray
from rolamento.vibration.reading._arrays import ArraysSource
from rolamento.vibration.reading._limits import file_size, guarded
from rolamento.vibration.reading._variables import Place, Variable

__all__ = ["Hdf5Source"]

_PIECE: Final = 1_000_000
"""Samples asked for at once."""


class Hdf5Source(ArraysSource):
    """An open HDF5 file.

    Data sets of one dimension, and of two much unequal ones, are channels. Attributes of a data
    set or of the groups above it give rate, unit and speed, and so do single numbers beside it.
    """

    def __init__(self, path: Path) -> None:
        self._source = str(path)
        file_size(path)
        self._child = Child(path, "signals")
        try:
            with guarded(self._source, "HDF5 file"):
                answer = self._child.ask({})
                variables = [_variable(found) for found in answer["variables"]]
                self._take(variables, self._source, "HDF5 file")
        except BaseException:
            self.close()
            raise

    def _samples(self, place: Place, start: int, count: int) -> FloatArray:
        samples = np.empty(count)
        for first in range(0, count, _PIECE):
            number = min(_PIECE, count - first)
            question = {
                "variable": place.variable,
                "axis": place.axis,
                "place": place.row,
                "start": start + first,
                "count": number,
            }
            content = self._child.ask(question)["content"]
            if len(content) != 8 * number:
                raise FileError("ends before its last sample", source=self._source)
            samples[first : first + number] = np.frombuffer(content, "<f8")
        return samples

    def close(self) -> None:
        """End the process that has the file open."""
        self._child.end()


def _variable(found: dict[str, Any]) -> Variable:
    return Variable(
        found["name"], tuple(found["shape"]), found["value"], found["numbers"], found["texts"]
    )
