"""How many threads share a calculation, and one that they share."""

from __future__ import annotations

import operator
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from rolamento.errors import InputError
from rolamento.words import said

__all__ = ["side_by_side", "thread_count"]

T = TypeVar("T")
R = TypeVar("R")


def side_by_side(function: Callable[[T], R], items: Sequence[T]) -> list[R]:
    """Return what a function makes of each item; as many at a time as there are processors.

    It pays for a function whose time goes into NumPy's and SciPy's loops, which let others run.
    """
    workers = min(thread_count(None), len(items))
    if workers <= 1:
        return [function(item) for item in items]
    with ThreadPoolExecutor(workers) as pool:
        return list(pool.map(function, items))


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
