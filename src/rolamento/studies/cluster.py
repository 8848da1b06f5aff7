"""Solve the chunks of a study on a Dask cluster (``pip install 'rolamento[cluster]'``).

A chunk travels as a `Task`, some text and two numbers, and is solved by one thread of a worker:
its result does not depend on who solves it. Dask gives the chunks of a worker that is lost to
another.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from itertools import islice
from typing import Any, Final

import rolamento
from rolamento.errors import InputError
from rolamento.studies.plan import Part, Plan, solve_task
from rolamento.studies.runner import Executor

__all__ = ["ClusterError", "dask_cluster"]

PATIENCE: Final = "10 s"
"""For the scheduler to answer."""
AHEAD: Final = 3
"""Chunks that wait for each thread of the cluster: it is kept busy, and memory bounded."""
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
        When it is used: if there is no such scheduler, no worker has joined it, or the workers
        run another version of Rolamento.
    """

    def execute(plan: Plan, indices: Sequence[int]) -> Iterator[Part]:
        client = _client(address)
        try:
            threads = _check_workers(client, address)
            yield from _solved(client, plan, indices, AHEAD * threads, address)
        finally:
            client.close()

    return execute


def _client(address: str) -> Any:
    distributed = _distributed()
    try:
        return distributed.Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        raise ClusterError(
            f"cannot be reached: {_first_line(error)}",
            value=address,
            source="scheduler",
            example=_EXAMPLE,
        ) from None


def _distributed() -> Any:
    try:
        import distributed
    except ImportError:
        raise ClusterError(
            "needs Dask, which is not installed", example="pip install 'rolamento[cluster]'"
        ) from None
    return distributed


def _check_workers(client: Any, address: str) -> int:
    """Return how many threads the cluster has; refuse one that would give other numbers."""
    versions = client.run(_version)
    if not versions:
        raise ClusterError(
            "has no workers", value=address, source="scheduler", example=f"dask worker {address}"
        )
    others = {version for version in versions.values() if version != rolamento.__version__}
    if others:
        raise ClusterError(
            f"has workers with Rolamento {', '.join(sorted(others))}; this is"
            f" {rolamento.__version__}",
            value=address,
            source="scheduler",
        )
    return sum(client.nthreads().values())


def _version() -> str:
    return rolamento.__version__


def _solved(
    client: Any, plan: Plan, indices: Sequence[int], ahead: int, address: str
) -> Iterator[Part]:
    """Keep some chunks in the cluster, and yield them as they come."""
    waiting = iter(indices)
    futures = [_submitted(client, plan, index) for index in islice(waiting, ahead)]
    running = _distributed().as_completed(futures, loop=client.loop)
    try:
        for future in running:
            part = future.result()
            future.release()
            for index in islice(waiting, 1):
                running.add(_submitted(client, plan, index))
            yield part
    except (OSError, RuntimeError) as error:
        raise ClusterError(
            f"has failed: {_first_line(error)}; what was solved is kept",
            value=address,
            source="scheduler",
        ) from None


def _submitted(client: Any, plan: Plan, index: int) -> Any:
    task = plan.task(index)
    return client.submit(solve_task, task, 1, key=f"rolamento-{os.urandom(8).hex()}-{index}")


def _first_line(error: Exception) -> str:
    text = str(error).strip().splitlines()
    return text[0] if text else type(error).__name__
