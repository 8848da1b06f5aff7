"""The process that reads HDF5 for this one, and the conversation with it.

The HDF5 library is not made for damaged files: one wrong byte may send it into memory that is not
its own, or round in circles. Here that ends a child, not the program.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any, Final, Literal, Self

from rolamento._foreign.bounds import (
    LARGEST_CHUNK,
    MOST_MEMORY,
    PATIENCE,
    SLOWEST,
    most_declared,
)
from rolamento.errors import FileError

__all__ = ["Child"]

_SCRIPT: Final = Path(__file__).with_name("hdf5_worker.py")
_LONGEST_ANSWER: Final = 64 * 2**20


class Child:
    """A process that has a file open; leaving it as a context ends it.

    Parameters
    ----------
    path
        Of the file.
    kind
        How it is read: the arrays of ``"signals"``, or the variables of a ``"dataset"``.

    Raises
    ------
    FileError
        If there is no interpreter to run it, or the file cannot be opened.
    """

    def __init__(self, path: Path, kind: Literal["signals", "dataset"]) -> None:
        self._source = str(path)
        self._patience = PATIENCE
        if not sys.executable:
            raise FileError(
                "HDF5 needs a Python interpreter of its own to be read", source=self._source
            )
        try:
            size = path.stat().st_size
            path.open("rb").close()
            bounds = {
                "memory": MOST_MEMORY,
                "chunk": min(LARGEST_CHUNK, most_declared(size)),
                "declared": most_declared(size),
            }
            self._process = subprocess.Popen(
                [sys.executable, "-P", "-W", "ignore", str(_SCRIPT), kind, json.dumps(bounds),
                 os.path.abspath(path)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                env={**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"},
            )  # fmt: skip
        except OSError as error:
            reason = (error.strerror or str(error)).lower()
            raise FileError(f"cannot be opened: {reason}", source=self._source) from None

    def ask(self, question: dict[str, Any]) -> dict[str, Any]:
        """Return the answer to a question, with its bytes as ``content``.

        Raises
        ------
        FileError
            If the file is refused, or the process breaks off or falls behind.
        """
        timer = threading.Timer(max(self._patience, 0.0), self._process.kill)
        timer.daemon = True
        timer.start()
        began = time.monotonic()
        try:
            answer = self._conversation(question)
        except (OSError, ValueError):
            self.end()
            raise FileError(
                "is damaged: the HDF5 library broke off, or came to no end, over it",
                source=self._source,
            ) from None
        except BaseException:  # Ctrl-C between two halves of an answer
            self.end()
            raise
        finally:
            timer.cancel()
        earned = len(answer["content"]) / SLOWEST
        self._patience = min(self._patience - (time.monotonic() - began) + earned, PATIENCE)
        if "refusal" in answer:
            raise FileError(str(answer["refusal"]), source=self._source)
        return answer

    def _conversation(self, question: dict[str, Any]) -> dict[str, Any]:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(json.dumps(question).encode("ascii") + b"\n")
        self._process.stdin.flush()
        answer: dict[str, Any] = json.loads(self._process.stdout.readline(_LONGEST_ANSWER))
        answer["content"] = self._process.stdout.read(answer["bytes"])
        if len(answer["content"]) < answer["bytes"]:
            raise ValueError("the process ended within its answer")
        return answer

    def end(self) -> None:
        """End the process."""
        self._process.kill()
        self._process.wait()
        for stream in (self._process.stdin, self._process.stdout):
            if stream is not None:
                try:
                    stream.close()
                except OSError:  # a question that was never read
                    continue

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.end()
