"""Answers that follow a hand: in the server; where several hands are at work, in processes too.

The threads of the server share one interpreter. Where requests wait for it, processes are started
beside it; some seconds later they are ready, take what comes, and stay.
"""

from __future__ import annotations

import asyncio
import logging
import os
import signal
import threading
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context, parent_process
from typing import Any, Final, TypeVar

import anyio
import anyio.to_thread

from rolamento.errors import InputError
from rolamento.web.limits import Limits, in_language
from rolamento.web.warming import make_follower_ready
from rolamento.words import language

__all__ = ["Hands"]

R = TypeVar("R")

_log: Final = logging.getLogger("rolamento.web")

PROCESSES: Final = min((os.cpu_count() or 1) - 1, 4)
"""Beside the server: as many as there are other cores; each takes some 200 MB."""
_FEW: Final = 1
"""Requests that may wait without a process being started for them."""


class Hands:
    """Where answers that follow a hand are worked out.

    Parameters
    ----------
    processes
        That may be started beside the server; 0 for its own thread alone.
    ready
        What each of them does before it is asked.
    """

    def __init__(
        self, processes: int = PROCESSES, ready: Callable[[], None] = make_follower_ready
    ) -> None:
        self._processes, self._make_ready = processes, ready
        self._queue = Limits(at_once=1)
        self._starting: asyncio.Task[None] | None = None
        self._pool: ProcessPoolExecutor | None = None

    async def run(self, function: Callable[..., R], *args: Any) -> R:
        """Run what takes milliseconds, in the language that is spoken.

        Parameters
        ----------
        function
            Of a module, not nested; it, the arguments and what it returns may be pickled.

        Raises
        ------
        RequestError
            503, if too many wait.
        """
        self._queue.check()
        if self._queue.waiting > _FEW and self._processes and self._starting is None:
            self._starting = asyncio.create_task(self._start())
        async with self._queue.limiter:
            if (pool := self._pool) is not None:
                try:
                    return await _beside(pool, function, *args)
                except BrokenProcessPool:  # ended by somebody: here, and in new ones later
                    if pool is self._pool:
                        self.close()
            return await anyio.to_thread.run_sync(function, *args)

    async def _start(self) -> None:
        """Start the processes; as soon as one is ready they are asked alone.

        The server's interpreter then has the requests to read, and each process its next one
        waiting.
        """
        pool = ProcessPoolExecutor(
            self._processes, get_context("spawn"), initializer=_begin, initargs=(self._make_ready,)
        )
        try:
            await _beside(pool, os.getpid)
        except BaseException as error:
            pool.shutdown(wait=False, cancel_futures=True)
            if not isinstance(error, BrokenProcessPool):
                raise
            _log.warning("no process beside the server could be made ready")
        else:
            self._pool = pool
            self._queue.limiter.total_tokens = 1 + self._processes

    def close(self) -> None:
        """End the processes."""
        if self._starting is not None:
            self._starting.cancel()
        if self._pool is not None:
            self._pool.shutdown(wait=False, cancel_futures=True)
        self._starting = self._pool = None
        self._queue.limiter.total_tokens = 1


async def _beside(pool: ProcessPoolExecutor, function: Callable[..., R], *args: Any) -> R:
    work = pool.submit(in_language, language(), function, args)
    found = await asyncio.wrap_future(work)
    if isinstance(found, InputError):
        raise found
    return found


def _begin(make_ready: Callable[[], None]) -> None:
    """Leave it to the server when to end, end with it whatever ends it, and be ready."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    server = parent_process()
    assert server is not None

    def end() -> None:
        server.join()
        os._exit(0)

    threading.Thread(target=end, daemon=True).start()
    make_ready()
