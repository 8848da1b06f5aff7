"""Answers that follow a hand: in the server; where several hands are at work, in processes too.

The threads of the server share one interpreter. Where requests wait for it, processes are started
beside it; some seconds later they are ready, take what comes, and stay.
"""

from __future__ import annotations

import asyncio
import os
import signal
import threading
from collections.abc import Callable
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context, parent_process
from typing import Any, Final, TypeVar

import anyio
import anyio.to_thread

from rolamento.errors import InputError
from rolamento.web.limits import MOST_WAITING, busy, in_language
from rolamento.web.warming import make_follower_ready
from rolamento.words import language

__all__ = ["Hands"]

R = TypeVar("R")

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
        self._turns = anyio.CapacityLimiter(1)
        self._pool: ProcessPoolExecutor | None = None
        self._ready = False

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
        waiting = self._turns.statistics().tasks_waiting
        if waiting >= MOST_WAITING["fast"]:
            raise busy()
        if waiting > _FEW and self._pool is None and self._processes:
            self._start()
        async with self._turns:
            if self._ready:
                try:
                    return await self._beside(function, *args)
                except BrokenProcessPool:  # ended by somebody: here, and in new ones later
                    self.close()
            return await anyio.to_thread.run_sync(function, *args)

    async def _beside(self, function: Callable[..., R], *args: Any) -> R:
        assert self._pool is not None
        work = self._pool.submit(in_language, language(), function, args)
        found = await asyncio.wrap_future(work)
        if isinstance(found, InputError):
            raise found
        return found

    def _start(self) -> None:
        """Start the processes, in the background; when all are ready they are asked alone.

        The server's interpreter then has the requests to read, and each process its next one
        waiting.
        """
        pool = ProcessPoolExecutor(self._processes, get_context("spawn"), initializer=_follow)
        loop, self._pool = asyncio.get_running_loop(), pool
        left = self._processes

        def be_ready(first: Future[None]) -> None:
            nonlocal left
            left -= 1
            if self._pool is pool and not left and not first.cancelled() and not first.exception():
                self._ready = True
                self._turns.total_tokens = 1 + self._processes

        for _ in range(self._processes):
            pool.submit(self._make_ready).add_done_callback(
                lambda first: loop.call_soon_threadsafe(be_ready, first)
            )

    def close(self) -> None:
        """End the processes."""
        if self._pool is not None:
            self._pool.shutdown(wait=False, cancel_futures=True)
        self._pool, self._ready = None, False
        self._turns.total_tokens = 1


def _follow() -> None:
    """Leave it to the server when to end, and end with it whatever ends it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    server = parent_process()
    assert server is not None

    def end() -> None:
        server.join()
        os._exit(0)

    threading.Thread(target=end, daemon=True).start()
