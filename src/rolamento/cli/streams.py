"""Standard output and standard error: what is written arrives, or ends quietly."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING, Final, TextIO

from rolamento.cli.waiting import silenced
from rolamento.errors import FileError, cause, printable
from rolamento.io.writing import write_text
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.document import Document

__all__ = [
    "STANDARD_STREAM",
    "complain",
    "end_of_output",
    "print_data",
    "print_text",
    "put",
    "show",
]

STANDARD_STREAM: Final = "-"
_STANDARD_OUTPUT: Final = "standard output"
_COLOURS: Final = re.compile(r"(\x1b\[[0-9;]*m)")


def print_text(text: str) -> None:
    """Write for a person to standard output, in its encoding.

    Raises
    ------
    FileError
        If it cannot be written; a reader that has gone away is no error.
    """
    _write(sys.stdout, lambda: _encoded(text, sys.stdout), _STANDARD_OUTPUT)


def print_data(text: str) -> None:
    """Write for a program to standard output, in UTF-8 whatever the locale.

    A terminal gets escapes for what it would act on.

    Raises
    ------
    FileError
        As `print_text`.
    """
    shown = printable(text) if sys.stdout is not None and sys.stdout.isatty() else text
    _write(sys.stdout, lambda: shown.encode("utf-8"), _STANDARD_OUTPUT)


def put(text: str, path: str) -> None:
    """Write for a program to a file, or to standard output for ``"-"``.

    Raises
    ------
    FileError
        If it cannot be written.
    """
    if path == STANDARD_STREAM:
        print_data(text)
    else:
        write_text(text, path)


def show(document: Document) -> None:
    """Show a page on standard output, as `print_text`."""
    from rolamento.document.medium import Medium
    from rolamento.document.terminal import terminal

    print_text(terminal(document, Medium.of(sys.stdout)))


def complain(text: str) -> None:
    """Write one line to standard error, if there is one."""
    with suppress(FileError):
        _write(sys.stderr, lambda: _encoded(f"rolamento: {text}\n", sys.stderr), "standard error")


def end_of_output(error: OSError) -> None:
    """Say that what a library wrote to standard output, such as a help, has not arrived."""
    if sys.stdout is not None:
        _silence(sys.stdout)
    if not isinstance(error, BrokenPipeError):
        rule = said("cannot be written: {reason}", reason=cause(error))
        complain(str(FileError(rule, source=_STANDARD_OUTPUT)))


def _encoded(text: str, stream: TextIO) -> bytes:
    encoding = stream.encoding or "utf-8"
    from rolamento.document.medium import Medium

    medium = Medium(encoding=encoding)
    # a report has its colours already; what it took from files was fitted before them
    pieces = _COLOURS.split(text) if stream.isatty() else [text]
    return "".join(
        piece if place % 2 else medium.fitted(piece) for place, piece in enumerate(pieces)
    ).encode(encoding)


def _write(stream: TextIO | None, content: Callable[[], bytes], name: str) -> None:
    """Write bytes and see them off: what is left in a buffer fails where nobody can report it."""
    if stream is None:
        raise FileError(said("is closed"), source=name)
    try:
        data = content()
        with silenced():
            stream.flush()
            stream.buffer.write(data)
            stream.flush()
    except BrokenPipeError:
        _silence(stream)
    except OSError as error:
        _silence(stream)
        raise FileError(
            said("cannot be written: {reason}", reason=cause(error)), source=name
        ) from None


def _silence(stream: TextIO) -> None:
    """Send what is still in the buffer to nowhere, so that the end of the program is quiet."""
    with open(os.devnull, "wb") as nowhere:
        os.dup2(nowhere.fileno(), stream.fileno())
