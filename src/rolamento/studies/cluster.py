"""Solve the chunks of a study on a Dask cluster (``pip install 'rolamento[cluster]'``).

Chunks travel as `Task`s, some text and two numbers, as many at once as take a second, and are
solved by one thread of a worker: a result does not depend on who solves it. Dask gives the chunks
of a worker that is lost to another.

Dask waits for minutes for a scheduler that does not answer, and says why in tracebacks. Here
everything that is asked of it has an end, and its loggers are silent meanwhile.
"""

from __future__ import annotations

import asyncio
import concurrent.futures
import logging
import os
import queue
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from itertools import islice
from typing import Any, Final, TypeVar

import rolamento
from rolamento.errors import InputError
from rolamento.studies.plan import Part, Plan, Task, solve_task
from rolamento.studies.runner import Executor
from rolamento.words import said

__all__ = ["ClusterError", "dask_cluster"]

T = TypeVar("T")

PATIENCE: Final = 6.0
"""Seconds for the scheduler to answer."""
SILENCE: Final = 5.0
"""Seconds without a result after which it is asked whether it is there."""
AHEAD: Final = 3
"""Messages that wait for each thread of the cluster: it is kept busy, and memory bounded."""
_SECONDS: Final = 1.0
"""That the chunks of a message are to take."""
_MOST_CHUNKS: Final = 64
_CLOSING: Final = 2.0
_LOGGERS: Final = ("distributed", "tornado", "asyncio")
_EXAMPLE: Final = "--scheduler tcp://127.0.0.1:8786"


class ClusterError(InputError):
    """The cluster cannot be reached, does not suit, or has failed."""


def dask_cluster(address: str) -> Executor:
    """Return an executor that solves chunks on a Dask cluster.

    Parameters
    ----------
    address
        Of the scheduler, such as ``"tcp://127.0.0.1:8786"``.

    Raises
    ------
    ClusterError
        When it is used: if there is no such scheduler, no worker has joined it, the workers run
        another version of Rolamento, or it is lost.
    """

    def execute(plan: Plan, indices: Sequence[int]) -> Iterator[Part]:
        _distributed()
        with _quiet():
            client = _client(address)
            try:
                threads = _check_workers(client, address)
                yield from _solved(client, plan, indices, AHEAD * threads, address)
            finally:
                with suppress(Exception):
                    _within(_CLOSING, lambda: client.close(timeout=_CLOSING))

    return execute


def _client(address: str) -> Any:
    """A client of a scheduler that has answered: Dask's own attempts have no end."""
    distributed = _distributed()
    example: dict[str, Any] = {"value": address, "source": "scheduler", "example": _EXAMPLE}

    async def who() -> dict[str, Any]:
        async with distributed.rpc(address, timeout=PATIENCE) as scheduler:
            answer: dict[str, Any] = await asyncio.wait_for(scheduler.identity(), PATIENCE)
            return answer

    try:
        kind = _within(PATIENCE, lambda: asyncio.run(who())).get("type")
        if kind == "Scheduler":
            client = _within(
                PATIENCE,
                lambda: distributed.Client(address, timeout=PATIENCE, set_as_default=False),
            )
    except Exception as error:  # whatever answers there, in whatever words
        raise ClusterError(
            said("cannot be reached: {reason}", reason=_first_line(error)), **example
        ) from None
    if kind != "Scheduler":
        raise ClusterError(
            said("is a {kind} of Dask and no scheduler", kind=str(kind).lower()), **example
        )
    return client


def _distributed() -> Any:
    try:
        import distributed
    except ImportError:
        raise ClusterError(
            said("needs Dask, which is not installed"), example="pip install 'rolamento[cluster]'"
        ) from None
    return distributed


def _check_workers(client: Any, address: str) -> int:
    """Return how many threads the cluster has; refuse one that would give other numbers."""
    try:
        versions = _within(PATIENCE, lambda: client.run(_version))
        threads = _within(PATIENCE, client.nthreads)
    except Exception as error:
        raise _lost(_first_line(error), address) from None
    if not versions:
        raise ClusterError(
            said("has no workers"),
            value=address,
            source="scheduler",
            example=f"dask worker {address}",
        )
    others = {version for version in versions.values() if version != rolamento.__version__}
    if others:
        raise ClusterError(
            said(
                "has workers with Rolamento {others}; this is {own}",
                others=", ".join(sorted(others)),
                own=rolamento.__version__,
            ),
            value=address,
            source="scheduler",
        )
    return sum(threads.values())


def _version() -> str:
    return rolamento.__version__


def _solved(
    client: Any, plan: Plan, indices: Sequence[int], ahead: int, address: str
) -> Iterator[Part]:
    """Keep some messages in the cluster, and yield their chunks as they come."""
    left, size = iter(indices), 1
    done: queue.SimpleQueue[Any] = queue.SimpleQueue()
    running = 0

    def send() -> int:
        tasks = [plan.task(index) for index in islice(left, size)]
        if not tasks:
            return 0
        key = f"rolamento-{os.urandom(8).hex()}-{tasks[0].index}"
        client.submit(_solve_tasks, tasks, key=key).add_done_callback(done.put)
        return 1

    try:
        while running < ahead and send():
            running += 1
        while running:
            future = _next(done, client)
            parts, seconds = _result(future, client)
            future.release()
            running -= 1
            size = _paced(len(parts), seconds, size)
            while running < ahead and send():
                running += 1
            yield from parts
    except (
        OSError,
        RuntimeError,
        TimeoutError,
        _distributed().KilledWorker,
        asyncio.CancelledError,
        concurrent.futures.CancelledError,
    ) as error:
        raise _lost(_first_line(error), address) from None


def _solve_tasks(tasks: Sequence[Task]) -> tuple[list[Part], float]:
    """Solve some chunks; what a worker does. Returns also the seconds that it took."""
    began = time.perf_counter()
    return [solve_task(task, 1) for task in tasks], time.perf_counter() - began


def _paced(chunks: int, seconds: float, size: int) -> int:
    """Number of chunks to send at once, adapted slowly to the time that earlier ones took."""
    wanted = round(chunks * _SECONDS / max(seconds, 1e-3))
    return min(max(wanted, 1), 2 * size, _MOST_CHUNKS)


def _next(done: queue.SimpleQueue[Any], client: Any) -> Any:
    """The next future that is done.

    Raises
    ------
    TimeoutError
        If none comes, and the scheduler does not answer.
    """
    while True:
        with suppress(queue.Empty):
            return done.get(timeout=SILENCE)
        _ask(client)


def _result(future: Any, client: Any) -> tuple[list[Part], float]:
    """What a future has found.

    It goes with its worker if that is lost before it is fetched: Dask then has another solve it
    again, which takes its time.

    Raises
    ------
    TimeoutError
        If it does not come, and the scheduler does not answer.
    """
    while True:
        with suppress(TimeoutError):
            found: tuple[list[Part], float] = future.result(timeout=PATIENCE)
            return found
        _ask(client)


def _ask(client: Any) -> None:
    """Ask the scheduler whether it is there.

    Raises
    ------
    TimeoutError
        If it is not, or does not answer.
    """
    if client.status != "running":
        raise TimeoutError(said("the scheduler has gone away"))
    _within(PATIENCE, lambda: client.sync(client.scheduler.identity, callback_timeout=PATIENCE))


def _within(seconds: float, action: Callable[[], T]) -> T:
    """Return what an action does in a thread of its own, which is left alone if it takes longer.

    Raises
    ------
    TimeoutError
        If it does; else what the action raises.
    """
    results: queue.SimpleQueue[tuple[bool, Any]] = queue.SimpleQueue()

    def run() -> None:
        try:
            results.put((True, action()))
        except BaseException as error:  # raised again by the thread that asks
            results.put((False, error))

    threading.Thread(target=run, daemon=True).start()
    try:
        succeeded, result = results.get(timeout=seconds + 1.0)
    except queue.Empty:
        raise TimeoutError(said("no answer within {seconds:.4 s}", seconds=seconds)) from None
    if not succeeded:
        raise result
    found: T = result
    return found


@contextmanager
def _quiet() -> Iterator[None]:
    """Silence the loggers of Dask: what they log is reported here, in a sentence."""
    named = [logging.getLogger(name) for name in list(logging.root.manager.loggerDict)]
    loud = [
        logger
        for logger in named
        if logger.name.partition(".")[0] in _LOGGERS and not logger.disabled
    ]
    for logger in loud:
        logger.disabled = True
    try:
        yield
    finally:
        for logger in loud:
            logger.disabled = False


def _lost(reason: str, address: str) -> ClusterError:
    return ClusterError(
        said("has failed: {reason}; what was solved is kept", reason=reason),
        value=address,
        source="scheduler",
    )


def _first_line(error: BaseException) -> str:
    text = str(error).strip().splitlines()
    if text:
        return text[0]
    return "no answer" if isinstance(error, TimeoutError) else type(error).__name__
