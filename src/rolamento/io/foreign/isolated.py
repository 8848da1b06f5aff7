"""A process in which a library reads a file, and the conversation with it.

Some libraries are not made for damaged files: one wrong byte sends them into memory that is not
theirs, or round in circles. Here that ends a child, not the program.
"""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final, Self

import numpy as np

from rolamento.errors import FileError, InputError
from rolamento.io.foreign.bounds import MOST_MEMORY, PATIENCE, SLOWEST, guarded
from rolamento.words import language, said, speaking

__all__ = ["Isolated", "serve"]

_PROGRAM: Final = (
    "import pickle, sys; sys.path[:] = pickle.load(sys.stdin.buffer); "
    "from rolamento.io.foreign.isolated import serve; serve()"
)
_LEFT_ALONE: Final = round(PATIENCE) + 5
"""Seconds of one answer, after which the process ends itself: who asked may have been ended first,
and a library that goes round in circles never hears of that."""
_LONGEST_SECONDS: Final = 3600
"""Seconds of work, should nobody be left to end it."""


class Isolated:
    """A reader of a file in a process of its own; leaving it as a context ends it.

    The process has 2 GB of memory where the system can refuse more (Linux), and is ended when it
    falls 30 s behind 4 MB/s.

    Parameters
    ----------
    reader
        Makes the reader there from the file's name; its methods are what can be asked.
    path
        Of the file.
    kind
        Of the file, for messages: a text that is marked.

    Raises
    ------
    FileError
        If there is no interpreter to run it, or the file cannot be opened.
    """

    def __init__(self, reader: Callable[[str], Any], path: Path, kind: str) -> None:
        self._source = str(path)
        self._kind = kind
        self._patience = PATIENCE
        if not sys.executable:
            rule = said("needs a Python interpreter of its own to be read")
            raise FileError(rule, source=self._source)
        with guarded(self._source, kind):
            path.open("rb").close()
            self._process = subprocess.Popen(
                [sys.executable, "-W", "ignore", "-c", _PROGRAM],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                env={**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"},
            )
        self._first: tuple[Any, ...] = (sys.path, (reader, self._source, kind))

    def ask(self, method: str, *arguments: Any) -> Any:
        """Return what a method of the reader answers.

        Raises
        ------
        FileError
            If the file is refused, or the process breaks off or falls behind.
        """
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        timer = threading.Timer(max(self._patience, 0.0), self._process.kill)
        timer.daemon = True
        timer.start()
        began = time.monotonic()
        try:
            for message in (*self._first, (method, arguments, language())):
                pickle.dump(message, self._process.stdin)
            self._first = ()
            self._process.stdin.flush()
            answer = pickle.load(self._process.stdout)
        except Exception:  # a broken pipe, or half an answer
            self.end()
            raise FileError(
                said(
                    "is damaged: the library of this {kind} broke off, or came to no end",
                    kind=said(self._kind),
                ),
                source=self._source,
            ) from None
        except BaseException:  # Ctrl-C between two halves of an answer
            self.end()
            raise
        finally:
            timer.cancel()
        earned = answer.nbytes / SLOWEST if isinstance(answer, np.ndarray) else 0.0
        self._patience = min(self._patience - (time.monotonic() - began) + earned, PATIENCE)
        if isinstance(answer, InputError):
            raise answer
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


def serve() -> None:
    """Answer questions over standard input until it ends; what runs in the process."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # whatever a library prints goes nowhere
    make, source, kind = pickle.load(sys.stdin.buffer)
    _limit_this_process()
    reader: Any = None
    while True:
        try:
            method, arguments, code = pickle.load(sys.stdin.buffer)
        except EOFError:
            return
        answer: Any
        _end_in(_LEFT_ALONE)
        try:
            with speaking(code), guarded(source, kind):
                reader = reader or make(source)
                answer = getattr(reader, method)(*arguments)
        except InputError as error:
            answer = error
        _end_in(0)
        pickle.dump(answer, answers, protocol=5)
        answers.flush()


def _end_in(seconds: int) -> None:
    """Have the system end this process, whatever it does then; 0 for never."""
    if hasattr(signal, "alarm"):
        signal.alarm(seconds)


def _limit_this_process() -> None:
    """Let the system refuse more than a file may ask for, where it can."""
    try:
        import resource
    except ImportError:
        return
    for limit, most in (
        (resource.RLIMIT_AS, MOST_MEMORY),
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_CPU, _LONGEST_SECONDS),
    ):
        try:
            resource.setrlimit(limit, (most, resource.getrlimit(limit)[1]))
        except (ValueError, OSError):
            continue
