"""Many cases in blocks that stay near the processor, side by side in threads."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from functools import partial
from typing import TYPE_CHECKING, Any, Final, Protocol, Self, TypeVar

import numpy as np

from rolamento.numerics.threads import thread_count

if TYPE_CHECKING:
    from concurrent.futures import ThreadPoolExecutor

__all__ = ["BLOCK", "in_blocks", "joined"]

BLOCK: Final = 2048
"""Cases at a time."""


class Cases(Protocol):
    """What can be counted and taken apart by cases."""

    def __len__(self) -> int: ...

    def __getitem__(self, some: slice, /) -> Self: ...


C = TypeVar("C", bound=Cases)
R = TypeVar("R")


def in_blocks(function: Callable[[C], R], cases: C, threads: int | None = None) -> R:
    """Apply a function to some cases at a time, and put what it returns together again.

    Parameters
    ----------
    function
        Of some of the cases; returns an array over cases, or a record, mapping or tuple of such.
    cases
        All of them.
    threads
        As many as there are processors by default: NumPy lets them run side by side.
    """
    count = thread_count(threads)
    if len(cases) <= BLOCK:
        return function(cases)
    parts = [slice(first, first + BLOCK) for first in range(0, len(cases), BLOCK)]
    if count == 1:
        return joined([function(cases[part]) for part in parts])
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor(min(count, len(parts))) as pool:
        return joined(list(pool.map(lambda part: function(cases[part]), parts)), pool)


def joined(parts: list[R], pool: ThreadPoolExecutor | None = None) -> R:
    """Put arrays over cases one after another, in records, mappings and tuples alike.

    What is neither is the same in all parts. A pool copies the arrays until it is shut down.
    """
    whole: R = _joined(parts, pool, {})
    return whole


def _joined(
    parts: list[Any], pool: ThreadPoolExecutor | None, known: dict[tuple[int, ...], Any]
) -> Any:
    """known: by the identities of the parts, since an array may stand in a result twice."""
    first = parts[0]
    if isinstance(first, np.ndarray):
        same = tuple(map(id, parts))
        if same in known:
            return known[same]
        count = sum(map(len, parts))
        whole = np.empty((count, *first.shape[1:]), np.result_type(*parts))
        known[same] = whole
        copy = partial(np.concatenate, parts, out=whole)
        copy() if pool is None else pool.submit(copy)
        return whole
    if isinstance(first, Mapping):
        return {key: _joined([part[key] for part in parts], pool, known) for key in first}
    if isinstance(first, tuple):
        return tuple(_joined(list(column), pool, known) for column in zip(*parts, strict=True))
    if is_dataclass(first) and not isinstance(first, type):
        names = [one.name for one in fields(first)]
        return type(first)(
            *(_joined([getattr(part, name) for part in parts], pool, known) for name in names)
        )
    return first
