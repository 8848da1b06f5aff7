"""How many threads share a calculation."""

from __future__ import annotations

import operator
import os

from rolamento.errors import InputError
from rolamento.words import said

__all__ = ["thread_count"]


def thread_count(threads: int | None) -> int:
    """Return how many threads are asked for: as many as there are processors by default.

    Raises
    ------
    InputError
        If it is not a whole number from 1 on.
    """
    if threads is None:
        return os.cpu_count() or 1
    try:
        count = 0 if isinstance(threads, bool) else operator.index(threads)
    except TypeError:
        count = 0
    if count < 1:
        raise InputError(
            said("must be a positive integer, or None for all processors"),
            field="threads",
            value=threads,
            example="threads=2",
        )
    return count
