"""How a calculation is shared out: to threads, or one small case to plain Python."""

from __future__ import annotations

import logging
import operator
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from time import perf_counter
from typing import Any, Final, TypeVar

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics.compiled import Kernel
from rolamento.words import said

__all__ = ["share_out", "side_by_side", "thread_count"]

_log = logging.getLogger("rolamento")

COMPILING: Final = "compiling the solver for this machine, once: this takes a minute or two"
LONG: Final = 1.0
"""Seconds of plain Python in this process after which the compiler is worth loading."""
_spent: Final = [0.0]
_ready: Final[set[Kernel[..., None]]] = set()
"""What has been compiled or loaded: to ask each time takes as long as a small case."""

T = TypeVar("T")
R = TypeVar("R")


@cache
def _processors() -> int:
    """Ask once: the system takes as long for the answer as a small case."""
    return os.cpu_count() or 1


def thread_count(threads: int | None) -> int:
    """Return how many threads are asked for: as many as there are processors by default.

    Raises
    ------
    InputError
        If it is not a whole number from 1 on.
    """
    if threads is None:
        return _processors()
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


def share_out(
    kernel: Kernel[..., None],
    run: Callable[[Callable[..., Any], int, int], None],
    cases: int,
    *,
    chunk: int,
    threads: int | None,
    little: bool,
) -> None:
    """Run a kernel over many cases, in chunks, by threads.

    run: takes the kernel, compiled or plain, the first case and the one after the last. little:
    whether they are less work than loading the compiler: then they run as plain Python while it is
    not loaded.
    """
    if little and kernel not in _ready and (_spent[0] < LONG or not kernel.is_cached):
        start = perf_counter()
        with np.errstate(all="ignore"):
            run(kernel, 0, cases)
        _spent[0] += perf_counter() - start
        return
    if kernel not in _ready and cases and not kernel.is_cached:
        _log.warning(COMPILING)
    compiled = kernel.compiled
    _ready.add(kernel)
    starts = range(0, cases, chunk)
    side_by_side(lambda first: run(compiled, first, min(first + chunk, cases)), starts, threads)


def side_by_side(
    function: Callable[[T], R], items: Sequence[T], threads: int | None = None
) -> list[R]:
    """Return what a function makes of each item; by default as many at a time as processors.

    It pays for a function whose time goes into kernels, or NumPy's and SciPy's loops, which let
    others run.
    """
    workers = min(thread_count(threads), len(items))
    if workers <= 1:
        return [function(item) for item in items]
    with ThreadPoolExecutor(workers) as pool:
        return list(pool.map(function, items))
