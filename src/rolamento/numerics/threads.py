"""How a calculation is shared out: to threads, or one small case to plain Python."""

from __future__ import annotations

import operator
import os
from collections.abc import Callable, Sequence
from functools import cache
from threading import Lock
from time import perf_counter, sleep
from typing import Any, Final, ParamSpec, TypeVar

import numpy as np

from rolamento.errors import InputError, arguments
from rolamento.numerics.beside import compile_beside, compiles_here
from rolamento.numerics.compiled import Kernel
from rolamento.words import said

__all__ = [
    "goes_plainly",
    "load_at_first_use",
    "ready",
    "share_out",
    "side_by_side",
    "thread_count",
]

LOADING: Final = 0.5
"""Seconds of plain Python in this process after which the compiler is worth loading."""
COMPILING: Final = 60.0
"""The same after which it is worth compiling here, where no other process can."""
SLICE: Final = 0.1
"""Seconds of plain Python between two looks for what has been compiled."""
POLL: Final = 0.1
_spent: Final = [0.0]
_ready: Final[set[Kernel[..., Any]]] = set()
"""What has been compiled or loaded: to ask each time takes as long as a small case."""

P = ParamSpec("P")
_one: Final = Lock()
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
            example=arguments(threads=2),
        )
    return count


def share_out(
    kernel: Kernel[..., Any],
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
    not loaded. What has never been compiled on this machine runs as plain Python while another
    process compiles it, from one case to the next.
    """
    done, some = 0, 1
    while done < cases and goes_plainly(kernel, little=little):
        last = cases if little else min(done + some, cases)
        start = perf_counter()
        with np.errstate(all="ignore"):
            run(kernel, done, last)
        took = perf_counter() - start
        _spent[0] += took
        done, some = last, 2 * some if took < SLICE else some
    if done == cases:
        return
    compiled = ready(kernel)
    starts = range(done, cases, chunk)
    side_by_side(lambda first: run(compiled, first, min(first + chunk, cases)), starts, threads)


def goes_plainly(kernel: Kernel[..., Any], *, little: bool) -> bool:
    """Whether a kernel should run as plain Python now.

    While it is nowhere compiled: as long as another process is at it, or what was calculated
    plainly in this one has not yet taken as long as compiling would.
    """
    if kernel in _ready or kernel.is_loaded:
        return False
    if little and _spent[0] < LOADING:
        return True
    if kernel.is_cached or compiles_here():
        return False
    return (kernel.is_kept and compile_beside()) or _spent[0] < COMPILING


def load_at_first_use() -> None:
    """Load each kernel when it is first run, however little that is: this process runs on."""
    _spent[0] = max(_spent[0], LOADING)


def ready(kernel: Kernel[P, R]) -> Callable[P, R]:
    """The kernel compiled, loaded or waited for, which is said."""
    if kernel in _ready:
        return kernel.compiled
    with _one:  # two threads would compile it twice
        if not kernel.is_cached:
            _say_that_it_takes_a_while()
            while kernel.is_kept and compile_beside() and not kernel.is_cached:
                sleep(POLL)
        compiled = kernel.compiled
    _ready.add(kernel)
    return compiled


@cache
def _say_that_it_takes_a_while() -> None:
    import logging

    message = said("compiling the solver for this machine, once: this takes one or two minutes")
    logging.getLogger("rolamento").warning(message)


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
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor(workers) as pool:
        return list(pool.map(function, items))
