"""A file that one process at a time may lock."""

from __future__ import annotations

from typing import IO, Any

try:
    import fcntl
except ImportError:  # Windows, where processes have to keep apart by themselves
    fcntl = None  # type: ignore[assignment]

__all__ = ["lock"]


def lock(file: IO[Any], *, wait: bool = False) -> bool:
    """Lock an open file until it is closed; return False where another process has it.

    wait: until that lets it go. Where the system has no such locks, every process gets it.

    Raises
    ------
    OSError
        If it waits where the file system has no locks.
    """
    if fcntl is None:
        return True
    try:
        fcntl.flock(file, fcntl.LOCK_EX if wait else fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        if wait:
            raise
        return False
    return True
