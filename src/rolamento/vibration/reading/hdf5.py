"""HDF5 files, MATLAB 7.3 among them: read in blocks by a process of their own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from contextlib import suppress
from pathlib import Path
from typing import Any, Final

import numpy as np

from rolamento.errors import FileError
from rolamento.numerics import FloatArray
from rolamento.vibration.reading._arrays import ArraysSource
from rolamento.vibration.reading._limits import exactly, file_size, guarded, opened
from rolamento.vibration.reading._variables import Place, Variable

__all__ = ["Hdf5Source"]

_SCRIPT: Final = Path(__file__).with_name("_hdf5_worker.py")
_PIECE: Final = 1_000_000
"""Samples asked for at once."""
_LONGEST_ANSWER: Final = 64 * 2**20
_PATIENCE: Final = 30.0
"""Seconds that an answer may take."""


class Hdf5Source(ArraysSource):
    """An open HDF5 file.

    Data sets of one dimension, and of two much unequal ones, are channels. Attributes of a data
    set or of the groups above it give rate, unit and speed, and so do single numbers beside it.
    """

    def __init__(self, path: Path) -> None:
        self._source = str(path)
        file_size(path)
        opened(path).close()
        self._child = _Child(path, self._source)
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


class _Child:
    """The process that reads, and the conversation with it."""

    def __init__(self, path: Path, source: str) -> None:
        self._source = source
        if not sys.executable:
            raise FileError("HDF5 needs a Python interpreter of its own to be read", source=source)
        with guarded(source, "HDF5 file"):
            self._process = subprocess.Popen(
                [sys.executable, "-P", "-W", "ignore", str(_SCRIPT), os.path.abspath(path)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                env={**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"},
            )

    def ask(self, question: dict[str, int]) -> dict[str, Any]:
        """Return the answer to a question, with its bytes as `content`.

        Raises
        ------
        FileError
            If the file is refused, or the process breaks off or takes too long.
        """
        timer = threading.Timer(_PATIENCE, self._process.kill)
        timer.daemon = True
        timer.start()
        try:
            answer = self._conversation(question)
        except (OSError, ValueError, FileError):
            self.end()
            raise FileError(
                "is damaged: the HDF5 library broke off, or came to no end, over it",
                source=self._source,
            ) from None
        finally:
            timer.cancel()
        if "refusal" in answer:
            raise FileError(str(answer["refusal"]), source=self._source)
        return answer

    def _conversation(self, question: dict[str, int]) -> dict[str, Any]:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(json.dumps(question).encode("ascii") + b"\n")
        self._process.stdin.flush()
        answer: dict[str, Any] = json.loads(self._process.stdout.readline(_LONGEST_ANSWER))
        answer["content"] = exactly(
            self._process.stdout,  # type: ignore[arg-type]
            answer["bytes"],
            self._source,
        )
        return answer

    def end(self) -> None:
        """End the process."""
        self._process.kill()
        self._process.wait()
        for stream in (self._process.stdin, self._process.stdout):
            if stream is not None:
                with suppress(OSError):  # a question that was never read
                    stream.close()


def _variable(found: dict[str, Any]) -> Variable:
    return Variable(
        found["name"], tuple(found["shape"]), found["value"], found["numbers"], found["texts"]
    )
