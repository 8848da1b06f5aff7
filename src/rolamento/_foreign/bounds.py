"""How large, how slow and how hungry a file may be that somebody else wrote.

A file is bounded by its own size: what it inflates to, or declares that it holds, may be 32 times
as much, or 64 MB where that is more. Measured signals compress to a third, text to a tenth; what
goes beyond that holds one number over and over, or nothing.
"""

from __future__ import annotations

from typing import Final

from rolamento.errors import FileError

__all__ = [
    "LARGEST_CHUNK",
    "LARGEST_WHOLE",
    "MOST_MEMORY",
    "PATIENCE",
    "SLOWEST",
    "check_declared",
    "check_inflated",
    "most_declared",
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
            f"declares {_amount(declared)} and has {_amount(size)}; a file may declare "
            f"{_RATIO} times its size, or {_amount(_ALWAYS)}; store it without compression",
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
        raise FileError(f"inflates to more than {_amount(LARGEST_WHOLE)}", source=source)
    check_declared(inflated, size, source)


def _amount(size: int) -> str:
    for unit, worth in (("GB", 2**30), ("MB", 2**20)):
        if size >= worth:
            return f"{size / worth:.4g} {unit}"
    return f"{size / 2**10:.4g} kB"
