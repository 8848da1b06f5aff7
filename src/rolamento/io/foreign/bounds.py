"""How large, how slow and how hungry a file may be, and how its failures become one sentence.

A file is bounded by its own size: what it inflates to, or declares that it holds, may be 32 times
as much, or 64 MB where that is more. Measured signals compress to a third, text to a tenth; what
goes beyond that holds one number over and over, or nothing. Whatever a library raises over its
contents becomes a `FileError`.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Final

import numpy as np

from rolamento.errors import FileError, InputError, cause, shown
from rolamento.words import manner, marked, said

__all__ = [
    "LARGEST_CHUNK",
    "LARGEST_WHOLE",
    "MOST_MEMORY",
    "PATIENCE",
    "SLOWEST",
    "check_declared",
    "check_inflated",
    "check_whole",
    "guarded",
    "most_declared",
    "size_of_file",
]

LARGEST_WHOLE: Final = 512 * 2**20
"""Bytes of a file that has to be held whole, and of what it inflates to."""
LARGEST_CHUNK: Final = 256 * 2**20
"""Bytes of a piece that is inflated as one."""
MOST_MEMORY: Final = 2 * 2**30
"""Bytes of a process that reads for another."""
PATIENCE: Final = 30.0
"""Seconds that such a process may fall behind."""
SLOWEST: Final = 4e6
"""Bytes per second that it has to bring, beyond that."""

_RATIO: Final = 32
_ALWAYS: Final = 64 * 2**20


def most_declared(size: int) -> int:
    """Bytes that a file of so many bytes may inflate to, or declare; numbers count as 8 bytes."""
    return max(_ALWAYS, _RATIO * size)


def check_declared(declared: int, size: int, source: str) -> None:
    """Refuse a file that declares more than one of its size may.

    Parameters
    ----------
    declared
        Bytes that it says it holds, or inflates to; numbers count as 8 bytes.
    size
        Bytes of the file.
    source
        What to call it.

    Raises
    ------
    FileError
        If it does.
    """
    if declared > most_declared(size):
        raise FileError(
            said(
                "declares {declared} and has {size}; a file may declare {ratio} times "
                "its size, or {always}; store it without compression",
                declared=_amount(declared),
                size=_amount(size),
                ratio=_RATIO,
                always=_amount(_ALWAYS),
            ),
            source=source,
        )


def check_inflated(inflated: int, size: int, source: str) -> None:
    """Refuse a file that inflates to more than is held whole, or than one of its size may.

    Parameters
    ----------
    inflated, size
        Bytes of the contents, and of the file.
    source
        What to call it.

    Raises
    ------
    FileError
        If it does.
    """
    if inflated > LARGEST_WHOLE:
        raise FileError(
            said("inflates to more than {most}", most=_amount(LARGEST_WHOLE)), source=source
        )
    check_declared(inflated, size, source)


def size_of_file(path: str | os.PathLike[str]) -> int:
    """Size of a regular file with something in it; bytes.

    Raises
    ------
    FileError
        If there is none, it is of another kind, or it is empty.
    """
    with guarded(source := str(path), marked("file")):
        about = os.stat(path)
        if stat.S_ISDIR(about.st_mode):
            raise FileError(said("is a directory; give a signal file"), source=source)
        if not stat.S_ISREG(about.st_mode):
            raise FileError(said("is not a regular file"), source=source)
        if about.st_size == 0:
            raise FileError(said("is empty; it should hold a signal"), source=source)
    return about.st_size


def check_whole(size: int, source: str) -> None:
    """Refuse what is too large to be held whole.

    Raises
    ------
    FileError
        If it is.
    """
    if size > LARGEST_WHOLE:
        raise FileError(
            said(
                "this kind of file is read whole, up to {most} MB; store it as WAV, "
                ".npy, HDF5 or Parquet, which are read in blocks",
                most=LARGEST_WHOLE // 2**20,
            ),
            field=marked("size in bytes"),
            value=size,
            source=source,
        )


@contextmanager
def guarded(source: str, kind: str) -> Iterator[None]:
    """Turn whatever goes wrong over a file's contents into a `FileError` that names the file.

    Numbers that are none are not warned of here: signals refuse them.
    """
    try:
        with np.errstate(all="ignore"):
            yield
    except InputError as error:
        raise error if error.source else error.with_details(source=source) from None
    except MemoryError:
        raise FileError(said("asks for more memory than there is"), source=source) from None
    except Exception as error:  # what a format's library raises is not for us to list
        if isinstance(error, OSError) and error.strerror:  # of the system, not of a library
            rule = said("cannot be read: {reason}", reason=cause(error))
            raise FileError(rule, source=source) from None
        reason = _in_short(str(error) or type(error).__name__)
        raise FileError(
            said("is not a readable {kind}: {reason}", kind=said(kind), reason=reason),
            source=source,
        ) from None


def _amount(size: int) -> str:
    for unit, worth in (("GB", 2**30), ("MB", 2**20)):
        if size >= worth:
            return f"{manner().number(size / worth, '.4g')} {unit}"
    return f"{manner().number(size / 2**10, '.4g')} kB"


def _in_short(reason: str) -> str:
    """First line of a library's complaint, printable and of bounded length."""
    line = reason.strip().partition("\n")[0][:120]
    return shown(line)[1:-1].removesuffix(".").lower() if line else "no reason is given"
