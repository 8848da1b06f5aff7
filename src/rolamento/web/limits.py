"""How much is done at once, and for how long: threads for what is fast, processes for the rest.

What is fast runs in a thread of the server, few at once: they share one interpreter. What follows a
hand is apart (`hands`): the API and curves take up to a second and would hold it up. What is slow
runs in worker processes, which a time limit or a visitor's leaving ends, with a lower priority: so
it never holds up what is fast.
"""

from __future__ import annotations

import os
import pickle
import threading
from collections.abc import AsyncIterator, Awaitable, Callable, Mapping
from contextlib import asynccontextmanager
from contextvars import ContextVar
from functools import cache
from heapq import heapify, heappop, heappush
from itertools import count
from math import inf, isfinite, log10
from typing import Any, Final, TypeVar, cast

import anyio
import anyio.to_process
import anyio.to_thread
from starlette.types import Receive

from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.system.shafts import FINENESS
from rolamento.web import modest
from rolamento.web.answers import RequestError
from rolamento.words import language, said, speaking

__all__ = [
    "VISITOR",
    "Limits",
    "MachineSize",
    "Turns",
    "by_weight",
    "check_machine",
    "fast",
    "in_language",
    "size_of_machine",
    "slow",
]

R = TypeVar("R")

FAST_AT_ONCE: Final = max(1, (os.cpu_count() or 1) - 2)
SLOW_AT_ONCE: Final = max(1, os.cpu_count() or 1)
_FAST_WAITING: Final = 100
_SLOW_WAITING: Final = 8
"""Requests of a kind that may wait for their turn."""
SECONDS: Final = 60.0
"""That something slow may take, its turn in the queue not counted."""
_LONGEST_WAIT: Final = 60.0
"""Seconds in the queue."""


VISITOR: Final[ContextVar[Receive | None]] = ContextVar("visitor", default=None)
"""Reports that whoever made the current request has left; its body has been read then."""


class Limits:
    """The queue of one kind of work; that of what is fast by default."""

    def __init__(self, at_once: int, most_waiting: int = _FAST_WAITING) -> None:
        self.limiter = anyio.CapacityLimiter(at_once)
        self.most_waiting = most_waiting

    @property
    def waiting(self) -> int:
        """Requests that wait for their turn."""
        return self.limiter.statistics().tasks_waiting

    def check(self) -> None:
        """Refuse a request if too many wait already.

        Raises
        ------
        RequestError
            503, to be tried again later.
        """
        if self.waiting >= self.most_waiting:
            raise _busy()


def _busy() -> RequestError:
    return RequestError(said("too many requests are waiting; try again in a moment"), 503)


class Turns:
    """Turns at slow work: of those who wait the smallest is next, unless it came much later.

    Ten times the size is worth one place in the queue: so nobody is overtaken without end.
    """

    def __init__(self, at_once: int, most_waiting: int) -> None:
        self._free, self._most_waiting = at_once, most_waiting
        self._waiting: list[tuple[float, int, anyio.Event]] = []
        self._came = count()

    @asynccontextmanager
    async def turn(self, size: float) -> AsyncIterator[None]:
        """Wait for a turn, and take it within the block.

        Raises
        ------
        RequestError
            503, if too many wait, or the turn does not come in a minute.
        """
        if self._free:
            self._free -= 1
        else:
            await self._wait(size)
        try:
            yield
        finally:
            self._pass_on()

    async def _wait(self, size: float) -> None:
        if len(self._waiting) >= self._most_waiting:
            raise _busy()
        number = next(self._came)
        own = (number + log10(max(size, 1.0)), number, anyio.Event())
        heappush(self._waiting, own)
        try:
            with anyio.fail_after(_LONGEST_WAIT):
                await own[2].wait()
        except BaseException as error:
            if own in self._waiting:
                self._waiting.remove(own)
                heapify(self._waiting)
            else:  # its turn had come
                self._pass_on()
            if isinstance(error, TimeoutError):
                raise _busy() from None
            raise

    def _pass_on(self) -> None:
        if self._waiting:
            heappop(self._waiting)[2].set()
        else:
            self._free += 1


@cache
def _queue(_thread: int) -> Limits:
    """The queue of what is fast, of an event loop, which is one to a thread."""
    return Limits(FAST_AT_ONCE)


@cache
def _turns(_thread: int) -> Turns:
    """The queue of slow work, one for each event loop."""
    return Turns(SLOW_AT_ONCE, _SLOW_WAITING)


_HEAVY: Final = frozenset({"coupled"})
"""Values of a case that take seconds or minutes: the time of coupled slices grows with their third
power."""
_MANY: Final = 400
"""Rolling elements of all rows together above which a case takes longer than a second: some 2 ms
each, where it takes the safe path."""
_MINUTES: Final = 1e5
"""Rolling elements that a case which takes minutes stands for in the queue."""
_COUNTS: Final = ("ball_count", "roller_count")
_ROWS: Final = ("rows", "arrangement")


def _is_heavy(asked: Any) -> bool:
    """Whether a case of a request takes long."""
    return _counted(asked)[0] > _MANY


def _size_of(args: tuple[Any, ...]) -> float:
    """How much is asked for: rolling elements of all cases, and kilobytes of a file."""
    size = 0.0
    for one in args:
        if isinstance(one, str):
            size += os.path.getsize(one) / 1e3 if os.path.isfile(one) else 0.0
        else:
            elements, cases = _counted(one)
            size += min(elements, _MINUTES) * cases
    return size


def _counted(asked: Any) -> tuple[float, int]:
    """Rolling elements of all rows of the largest case of a request, and how many cases it has.

    Wherever they stand; fields may be dotted names. Infinitely many where a case takes minutes.
    """
    elements, rows, cases = 1.0, 1, 1
    left = [asked]
    while left:
        one = left.pop()
        if isinstance(one, Mapping):
            for name, value in one.items():
                own = str(name).rpartition(".")[2]
                if own in _COUNTS:
                    elements = max(elements, _whole(value))
                elif own in _ROWS and isinstance(value, list | str):
                    rows = max(rows, len(value))
                if isinstance(value, Mapping | list | tuple | str):
                    left.append(value)
        elif isinstance(one, list | tuple):
            cases = max(cases, sum(isinstance(item, Mapping) for item in one))
            left += one
        elif isinstance(one, str) and one in _HEAVY:
            elements = inf
    return rows * elements, cases


def _whole(value: Any) -> int:
    """A count as it is given, or 1."""
    try:
        return int(value)
    except (TypeError, ValueError, OverflowError):
        return 1


# --- machines -------------------------------------------------------------------------------------

_ON_SHAFTS: Final = ("bearings", "springs", "loads", "gears", "belts", "masses")
_USUAL: Final = 20
"""Rolling elements of a bearing that is given by its designation."""
MOST_NODES: Final = 1200
"""Most nodes of all shafts: beyond, what joins each with each takes gigabytes."""
MOST_OVER_STEPS: Final = 20_000
"""Nodes, and likewise rolling elements, over all steps: some seconds, and megabytes of answer."""
_FAST_NODES: Final = 400
_FAST_ELEMENTS: Final = 1000
_FAST_BEARINGS: Final = 10


@frozen
class MachineSize:
    """What a machine costs, estimated from its tables, valid or not.

    steps: of its spectrum; nodes: of its shafts; bearings, and rolling elements in all of them.
    """

    steps: int
    nodes: int
    bearings: int
    elements: float

    @property
    def is_fast(self) -> bool:
        """Whether it takes less than a second."""
        return (
            self.bearings <= _FAST_BEARINGS
            and self.steps * self.nodes <= _FAST_NODES * _FAST_BEARINGS
            and self.nodes <= _FAST_NODES
            and self.steps * self.elements <= _FAST_ELEMENTS
        )


def size_of_machine(tables: Any) -> MachineSize:
    """Return what a machine costs by the tables of its file."""

    def listed(table: Any, name: str) -> list[Any]:
        found = table.get(name) if isinstance(table, Mapping) else None
        return found if isinstance(found, list) else []

    bearings = listed(tables, "bearings")
    nodes = sum(FINENESS + 1 + len(listed(one, "sections")) for one in listed(tables, "shafts"))
    nodes += sum(len(listed(tables, kind)) for kind in _ON_SHAFTS)
    elements = sum(max(_counted(one)[0], _USUAL) for one in bearings)
    return MachineSize(max(len(listed(tables, "spectrum")), 1), nodes, len(bearings), elements)


def check_machine(tables: Any) -> None:
    """Refuse a machine that takes more than a request may.

    Raises
    ------
    InputError
        That says of what there is too much.
    """
    size = size_of_machine(tables)
    for field, total, most in (
        ("shafts", size.nodes, MOST_NODES),
        ("bearings", size.elements, MOST_OVER_STEPS),
        ("spectrum", size.steps * size.nodes, MOST_OVER_STEPS),
        ("spectrum", size.steps * size.elements, MOST_OVER_STEPS),
    ):
        if isfinite(total) and total > most:
            raise InputError(
                said(
                    "is too large here: about {count} nodes or rolling elements in all steps, at"
                    " most {most}; the command line takes more",
                    count=int(total),
                    most=most,
                ),
                field=field,
            )


async def by_weight(
    function: Callable[..., R],
    *args: Any,
    asked: Mapping[str, Any],
    seconds: float = 0.0,
    light: Callable[..., Awaitable[R]] | None = None,
) -> R:
    """Run what a request asks where it belongs: as slow work if it is, else as fast.

    Parameters
    ----------
    function, args
        As of `slow`.
    asked
        The request: what is usually fast is slow where a case of it is heavy.
    seconds
        That it may take where it is always slow; 0 of what is usually fast.
    light
        What runs it where it is fast: `fast`, or `Hands.run`.
    """
    if seconds or _is_heavy(asked):
        return await slow(function, *args, seconds=seconds or SECONDS)
    return await (light or fast)(function, *args)


async def fast(function: Callable[..., R], *args: Any) -> R:
    """Run what takes milliseconds, in a thread, in the language that is spoken.

    Raises
    ------
    RequestError
        503, if too many wait.
    """
    queue = _queue(threading.get_ident())
    queue.check()
    return await anyio.to_thread.run_sync(function, *args, limiter=queue.limiter)


async def slow(function: Callable[..., R], *args: Any, seconds: float = SECONDS) -> R:
    """Run what may take seconds, in a process that a time limit or a cancellation ends.

    Parameters
    ----------
    function
        Of a module, not nested; it, the arguments and what it returns are pickled.
    seconds
        It may take.

    Raises
    ------
    RequestError
        503 if too many wait, or the process was ended twice; 504 if it takes longer.
    """
    work = pickle.dumps((in_language, (language(), function, args)))
    async with _turns(threading.get_ident()).turn(_size_of(args)):
        try:
            with anyio.fail_after(seconds):
                try:
                    found = await _while_there(work)
                except anyio.BrokenWorkerProcess:  # ended by somebody: once more, in another one
                    found = await _while_there(work)
        except anyio.BrokenWorkerProcess:
            rule = said("the process that worked on it was ended; try again in a moment")
            raise RequestError(rule, 503) from None
        except TimeoutError:
            rule = said("took longer than {seconds} s and was ended", seconds=seconds)
            raise RequestError(rule, 504) from None
    if isinstance(found, InputError):
        raise found
    return cast(R, found)


async def _while_there(work: bytes) -> Any:
    """Run what is pickled in a process that ends when the visitor leaves.

    Raises
    ------
    Exception
        What it raised.
    """
    found: list[Any] = []
    failure: list[Exception] = []

    async def run() -> None:
        try:
            found.append(
                await anyio.to_process.run_sync(
                    modest.run, work, cancellable=True, limiter=_unlimited()
                )
            )
        except Exception as error:
            failure.append(error)
        group.cancel_scope.cancel()

    async def watch(receive: Receive) -> None:
        while (await receive())["type"] != "http.disconnect":
            pass
        group.cancel_scope.cancel()

    receive = VISITOR.get()
    async with anyio.create_task_group() as group:
        group.start_soon(run)
        if receive is not None:
            group.start_soon(watch, receive)
    if failure:
        raise failure[0]
    return found[0] if found else RequestError(said("the visitor has left"), 499)


@cache
def _unlimited() -> anyio.CapacityLimiter:
    return anyio.CapacityLimiter(float("inf"))


def in_language(code: str, function: Callable[..., R], args: tuple[Any, ...]) -> R | InputError:
    """Run a function; what it refuses is returned, with all that it says."""
    with speaking(code):
        try:
            return function(*args)
        except InputError as error:
            return error
