"""Run a study: in memory for Python, or to a file in bounded memory.

Who solves the chunks is a matter of the executor: the threads of this process, or a cluster. It
takes a `Plan` and the numbers of the chunks that are wanted, and gives their `Part`s back in any
order.
"""

from __future__ import annotations

import os
import time
from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.errors import FileError, InputError
from rolamento.studies.plan import Part, Plan
from rolamento.studies.solving import CONVERGED, status_names
from rolamento.studies.store import Store
from rolamento.studies.study import Study
from rolamento.studies.summary import OutputRange, Spreads, Summary
from rolamento.studies.writing import Writer, writer_for

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["Executor", "Interrupted", "Progress", "local_threads", "run", "run_to_file"]

Executor = Callable[[Plan, Sequence[int]], Iterator[Part]]
"""Solves chunks of a plan, given by number; parts come in any order."""

Progress = Callable[[int, int, int], None]
"""Is told of cases done, cases in all, and how many of those done have no result: once at the
beginning, then after every chunk."""

_MOST_BYTES: Final = 4 * 2**30
"""Of a result in memory."""
_MOST_MESSAGES: Final = 5


class Interrupted(KeyboardInterrupt):
    """A run was interrupted; what was solved is kept.

    done and total: cases; folder: where the parts are.
    """

    def __init__(self, done: int, total: int, folder: Path) -> None:
        super().__init__(f"{done} of {total} cases are kept in {folder}")
        self.done, self.total, self.folder = done, total, folder


def run(
    study: Study,
    *,
    threads: int | None = None,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> xr.Dataset:
    """Solve a study and return the result in memory.

    Parameters
    ----------
    study
        What to solve.
    threads
        As many as there are processors by default.
    executor
        Who solves the chunks, instead of threads of this process.
    progress
        Called after every chunk.

    Returns
    -------
    xarray.Dataset
        Dimensions: the axes, ``"sample"`` of scatter, ``"ball"`` of outputs per ball. SI units; a
        case without a result carries NaN, and ``status`` says why.

    Raises
    ------
    InputError
        If the result would take more than 4 GB: `run_to_file` writes it to a file.
    """
    from rolamento.studies.dataset import dataset

    plan = Plan(study)
    needed = _bytes_of(plan)
    if needed > _MOST_BYTES:
        raise InputError(
            f"makes a result of {needed / 1e9:.1f} GB; run_to_file writes it to a file",
            field="outputs",
            example="fewer outputs",
        )
    whole = plan.empty(plan.cases)
    tally = _Tally(plan, progress)
    tally.tell()
    for part in (executor or local_threads(threads))(plan, range(plan.chunks)):
        first, last = plan.bounds(part.index)
        for name, array in part.arrays.items():
            whole[name][first:last] = array
        tally.add(part)
    return dataset(plan, whole, tally.counts, tally.some_messages)


def run_to_file(
    study: Study,
    path: str | os.PathLike[str],
    *,
    threads: int | None = None,
    executor: Executor | None = None,
    restart: bool = False,
    progress: Progress | None = None,
    chunk: int | None = None,
) -> Summary:
    """Solve a study in bounded memory and write the result to a file.

    Solved chunks are kept in a folder beside the file until it is complete. A run that stopped
    goes on where it was when it is started again.

    Parameters
    ----------
    study, threads, executor, progress
        As in `run`.
    path
        Of the result; ``.nc`` (NetCDF), ``.csv`` or ``.parquet``.
    restart
        Throw away what an earlier run has kept.
    chunk
        Cases in a chunk; by default 16 384, or fewer for bearings with many balls.

    Returns
    -------
    Summary
        Counts by status, and the range of each output.

    Raises
    ------
    FileError
        If the file cannot be written, its name ends otherwise, or the folder holds parts of
        another study.
    Interrupted
        On Ctrl-C.
    """
    result = Path(path)
    writer = writer_for(result)
    _check_place(result)
    began = time.perf_counter()
    plan = Plan(study, chunk)
    store = Store(result, plan)
    with store.held():
        kept = store.open(restart=restart)
        tally = _Tally(plan, progress)
        for part in kept.values():
            tally.keep(part)
        try:
            tally.tell()
            for part in _solved(plan, kept, executor or local_threads(threads)):
                store.put(part)
                tally.add(part)
            seconds = time.perf_counter() - began
            ranges = _assembled(plan, store, writer, tally)
            _move(store.result, result)
        except KeyboardInterrupt:
            raise Interrupted(tally.done, plan.cases, store.folder) from None
    store.remove()
    return Summary(
        path=result,
        cases=plan.cases,
        solved=tally.done - tally.kept,
        seconds=seconds,
        counts=dict(tally.counts),
        messages=tally.some_messages,
        ranges=ranges,
    )


def local_threads(threads: int | None = None) -> Executor:
    """Return an executor that solves chunks in threads of this process.

    A few chunks are solved ahead, not more: memory stays bounded however slow the writer is.
    """
    workers = threads or os.cpu_count() or 1

    def execute(plan: Plan, indices: Sequence[int]) -> Iterator[Part]:
        if len(indices) < 2 or workers == 1:
            yield from (plan.solve(index, threads=workers) for index in indices)
            return
        pool = ThreadPoolExecutor(min(workers, len(indices)))
        try:
            yield from _in_turn(pool, plan, indices, ahead=2 * workers)
        finally:
            pool.shutdown(wait=True, cancel_futures=True)

    return execute


def _in_turn(
    pool: ThreadPoolExecutor, plan: Plan, indices: Iterable[int], ahead: int
) -> Iterator[Part]:
    waiting: deque[Future[Part]] = deque()
    for index in indices:
        waiting.append(pool.submit(plan.solve, index, 1))
        if len(waiting) >= ahead:
            yield waiting.popleft().result()
    while waiting:
        yield waiting.popleft().result()


def _assembled(plan: Plan, store: Store, writer: Writer, tally: _Tally) -> tuple[OutputRange, ...]:
    """Put the parts together in one file, in order, and gather the ranges of the outputs."""
    spreads = Spreads(plan)
    with writer(store.result, plan, tally.counts, tally.some_messages) as file:
        for index in range(plan.chunks):
            part = store.get(index)
            file.put(part)
            spreads.add(part)
    return spreads.ranges()


def _solved(plan: Plan, kept: Iterable[int], executor: Executor) -> Iterator[Part]:
    """Solve what is not kept; the executor is closed whatever happens."""
    done = set(kept)
    missing = [index for index in range(plan.chunks) if index not in done]
    parts = executor(plan, missing) if missing else iter(())
    try:
        yield from parts
    finally:
        close = getattr(parts, "close", None)
        if close is not None:
            close()


class _Tally:
    """Counts what is done, and tells of it."""

    def __init__(self, plan: Plan, progress: Progress | None) -> None:
        self._plan, self._progress = plan, progress
        self._names = {code: name for name, code in status_names().items()}
        self.counts: Counter[str] = Counter()
        self.messages: list[str] = []
        self.done = self.kept = 0

    def add(self, part: Part) -> None:
        """Count a part that was solved now."""
        self._count(part)
        self.tell()

    @property
    def some_messages(self) -> tuple[str, ...]:
        """The first few of the messages."""
        return tuple(self.messages[:_MOST_MESSAGES])

    def keep(self, part: Part) -> None:
        """Count a part of an earlier run."""
        self._count(part)
        self.kept = self.done

    def tell(self) -> None:
        """Tell of what is done."""
        if self._progress is not None:
            self._progress(self.done, self._plan.cases, self.done - self.counts[CONVERGED])

    def _count(self, part: Part) -> None:
        codes, numbers = np.unique(part.arrays["status"], return_counts=True)
        for code, number in zip(codes, numbers, strict=True):
            self.counts[self._names[int(code)]] += int(number)
        self.messages += [text for text in part.messages if text not in self.messages]
        self.done += self._plan.size(part.index)


def _bytes_of(plan: Plan) -> int:
    per_case = sum(array.nbytes for array in plan.empty(1).values())
    return per_case * plan.cases


def _check_place(result: Path) -> None:
    """Refuse a place that cannot take the result before anything is solved."""
    if result.is_dir():
        raise FileError("is a directory; give a file", source=str(result))
    if not result.parent.is_dir():
        raise FileError("cannot be written: there is no such directory", source=str(result))


def _move(unfinished: Path, result: Path) -> None:
    try:
        os.replace(unfinished, result)
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise FileError(f"cannot be written: {reason}", source=str(result)) from None
