"""Run a study: in memory for Python, or to a file in bounded memory.

Who solves the chunks is a matter of the executor: the threads of this process, or a cluster. It
takes a `Plan` and the numbers of the chunks that are wanted, and gives their `Part`s back in any
order.
"""

from __future__ import annotations

import math
import os
import queue
import stat
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from importlib import import_module
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Final, Protocol

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import FileError, InputError, cause
from rolamento.numerics.threads import thread_count
from rolamento.records import frozen
from rolamento.status import CONVERGED, STATUS_NAMES
from rolamento.studies.outputs import Output
from rolamento.studies.plan import REASON, Part, Plan, Reasons
from rolamento.studies.store import Store
from rolamento.studies.study import Study
from rolamento.words import Note, said
from rolamento.words.headlines import over_cases

if TYPE_CHECKING:
    import xarray as xr

    from rolamento.studies.tables import CaseColumn, KeptCases

Executor = Callable[[Plan, Sequence[int]], Iterator[Part]]
"""Solves chunks of a plan, given by number; parts come in any order."""

Progress = Callable[[int, int, int], None]
"""Called with cases done, cases in all, and how many of those done have no result: once at the
beginning, then after every chunk."""

_MOST_BYTES: Final = 4 * 2**30
"""Maximum size of a result in memory."""
_LONGEST_UNWRITTEN: Final = 2.0
"""Seconds that a solved chunk waits for others before it is written."""
_PATIENCE: Final = 2.0
"""Seconds that threads are given to end in when a run stops; they end by themselves later."""
_MOST_ENDS: Final = 16
"""Cases at the ends of the ranges that are solved once more for what qualifies them."""
_MOST_KEPT: Final = 200_000
"""Values of an output that are kept for its median."""


class Interrupted(KeyboardInterrupt):
    """A run was interrupted; what was solved is kept.

    done and total: cases; folder: where the parts are.
    """

    def __init__(self, done: int, total: int, folder: Path) -> None:
        super().__init__(done, total, folder)
        self.done, self.total, self.folder = done, total, folder

    def __str__(self) -> str:
        return said(
            "stopped; {done} of {total} cases are kept in {folder}. Run the same command to"
            " continue",
            done=self.done,
            total=self.total,
            folder=str(self.folder),
        )


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
            said(
                "makes a result of {needed:.1f} GB; run_to_file writes it to a file",
                needed=needed / 1e9,
            ),
            field="outputs",
            example=said("fewer outputs"),
        )
    whole = plan.empty(plan.cases)
    tally = _Tally(plan, progress)
    tally.tell()
    for part in (executor or local_threads(threads))(plan, range(plan.chunks)):
        first, last = plan.bounds(part.index)
        tally.add(part)
        for name, array in tally.reasons.renumbered(part).arrays.items():
            whole[name][first:last] = array
    return dataset(plan, whole, tally.counts, tally.reasons.notes)


def run_to_file(
    study: Study,
    path: str | os.PathLike[str],
    *,
    threads: int | None = None,
    executor: Executor | None = None,
    restart: bool = False,
    progress: Progress | None = None,
    chunk: int | None = None,
    keep_cases: bool = False,
    writers: Mapping[str, Opener] = MappingProxyType({}),
) -> Summary:
    """Solve a study in bounded memory and write the result to a file.

    Solved chunks are kept in a folder beside the file until it is complete. A run that stopped
    goes on where it was when it is started again.

    Parameters
    ----------
    study, threads, executor, progress
        As in `run`. What was solved is on the disk some two seconds later.
    path
        Of the result; ``.nc`` (NetCDF), ``.csv`` or ``.parquet``.
    restart
        Throw away what an earlier run has kept.
    chunk
        Cases in a chunk, after each of which a run can be stopped; by default some 10 ms of the
        solver, or 32 where a case takes milliseconds. The last digits depend on it.
    keep_cases
        Whether the summary has the cases too, as columns in memory; at most 2²⁰ - 1.
    writers
        Of files with other endings, by these.

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
    openers = {**_WRITERS, **writers}
    _check_ending(result, openers)
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
            with _Shelf(store, plan) as shelf:
                tally.tell()
                for part in _solved(plan, kept, executor or local_threads(threads)):
                    shelf.add(part)
                    tally.add(part)
            seconds = time.perf_counter() - began
            opener = openers[result.suffix.lower()]
            ranges, ends, cases = _assembled(plan, store, tally, result, opener, keep=keep_cases)
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
        first=dict(tally.first),
        ranges=ranges,
        ends=len(ends),
        cautions=_qualified(plan, ends),
        columns=cases,
    )


def _qualified(plan: Plan, cases: Sequence[int]) -> tuple[tuple[Note, int], ...]:
    """What qualifies the outputs of some cases: by key the first note, and of how many."""
    found = over_cases(plan.qualifications(case) for case in cases)
    return tuple((note, int(where.sum())) for note, where in found)


def local_threads(threads: int | None = None) -> Executor:
    """Return an executor that solves chunks in threads of this process.

    A few chunks are solved ahead, not more: memory stays bounded however slow the writer is. The
    thread that asks never solves, so that it hears Ctrl-C; threads that are in the middle of a
    chunk then are not waited for longer than a moment.

    Raises
    ------
    InputError
        If the number of threads is none.
    """
    workers = thread_count(threads)

    def execute(plan: Plan, indices: Sequence[int]) -> Iterator[Part]:
        team = _Team(plan, indices, workers)
        try:
            yield from team.parts()
        finally:
            team.stop()

    return execute


class _Team:
    """Threads that solve chunks, which come in order, until they are asked to stop.

    They are daemons: a program that ends does not wait for the chunks that they are at.
    """

    def __init__(self, plan: Plan, indices: Sequence[int], workers: int) -> None:
        self._plan = plan
        self._left = iter(enumerate(indices))
        self._count = len(indices)
        self._taking = threading.Lock()
        self._room = threading.Semaphore(2 * workers)
        self._solved: queue.SimpleQueue[tuple[int, Part | BaseException]] = queue.SimpleQueue()
        self._stopped = threading.Event()
        self._threads = [
            threading.Thread(target=self._work, daemon=True)
            for _ in range(min(workers, self._count))
        ]

    def parts(self) -> Iterator[Part]:
        for thread in self._threads:
            thread.start()
        early: dict[int, Part | BaseException] = {}
        for place in range(self._count):
            while place not in early:
                found, solved = self._solved.get()
                early[found] = solved
            part = early.pop(place)
            self._room.release()
            if isinstance(part, BaseException):
                raise part
            yield part

    def stop(self) -> None:
        self._stopped.set()
        self._room.release(len(self._threads) or 1)
        latest = time.monotonic() + _PATIENCE
        for thread in self._threads:
            if thread.ident is not None:
                thread.join(max(latest - time.monotonic(), 0.0))

    def _work(self) -> None:
        while True:
            self._room.acquire()
            with self._taking:
                taken = None if self._stopped.is_set() else next(self._left, None)
            if taken is None:
                return
            place, index = taken
            try:
                self._solved.put((place, self._plan.solve(index, 1)))
            except BaseException as error:  # raised again by the thread that asks
                self._solved.put((place, error))
                return


class _Shelf:
    """Solved chunks that wait to be written together: neither many small files nor much lost."""

    def __init__(self, store: Store, plan: Plan) -> None:
        self._store, self._most = store, plan.chunks_together
        self._parts: list[Part] = []
        self._written = time.monotonic()

    def add(self, part: Part) -> None:
        self._parts.append(part)
        late = time.monotonic() - self._written > _LONGEST_UNWRITTEN
        if late or len(self._parts) >= self._most:
            self._write()

    def __enter__(self) -> _Shelf:
        return self

    def __exit__(self, *_: object) -> None:
        self._write()

    def _write(self) -> None:
        if self._parts:
            self._store.put(*self._parts)
        self._parts = []
        self._written = time.monotonic()


def _assembled(
    plan: Plan, store: Store, tally: _Tally, result: Path, opener: Opener, *, keep: bool
) -> tuple[tuple[OutputRange, ...], tuple[int, ...], tuple[CaseColumn, ...]]:
    """Put the parts together in one file, in order.

    Returns ranges of the outputs, some cases at their ends, and the cases kept.
    """
    spreads, reasons = Spreads(plan), tally.reasons
    kept_cases: KeptCases | None = None
    if keep:
        from rolamento.studies.tables import KeptCases

        kept_cases = KeptCases(plan, reasons.notes)
    try:
        with open_result(store.result, opener, plan, tally.counts, reasons.notes) as file:
            for first in range(0, plan.chunks, plan.chunks_together):
                last = min(first + plan.chunks_together, plan.chunks)
                part = Part.joined([store.get(index) for index in range(first, last)])
                part = reasons.renumbered(part)
                file.put(part)
                spreads.add(part)
                if kept_cases is not None:
                    kept_cases.put(part)
    except FileError as error:
        if error.source != str(store.result):
            raise
        store.result.unlink(missing_ok=True)  # room for whoever is asked to make some
        kept = said(
            "{rule}; what was solved is kept in {folder}", rule=error.rule, folder=str(store.folder)
        )
        raise FileError(kept, source=str(result)) from None
    kept_columns = () if kept_cases is None else kept_cases.columns
    return spreads.ranges(), spreads.ends(), kept_columns


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
    """Counts what is done, and names it."""

    def __init__(self, plan: Plan, progress: Progress | None) -> None:
        self._plan, self._progress = plan, progress
        self.counts: Counter[str] = Counter()
        self.reasons = Reasons()
        self.first: dict[str, FirstCase] = {}
        self.done = self.kept = 0

    def add(self, part: Part) -> None:
        """Count a part that was solved now."""
        self._count(part)
        self.tell()

    def keep(self, part: Part) -> None:
        """Count a part of an earlier run."""
        self._count(part)
        self.kept = self.done

    def tell(self) -> None:
        """Report what is done."""
        if self._progress is not None:
            self._progress(
                self.done, self._plan.cases, self.done - self.counts[STATUS_NAMES[CONVERGED]]
            )

    def _count(self, part: Part) -> None:
        found = np.unique(part.arrays["status"], return_counts=True, return_index=True)
        begin, _ = self._plan.bounds(part.index)
        for code, place, number in zip(*(array.tolist() for array in found), strict=True):
            name = STATUS_NAMES[code]
            self.counts[name] += number
            known, reason = self.first.get(name), int(part.arrays[REASON][place])
            if reason >= 0 and (known is None or begin + place < known.case):
                self.first[name] = FirstCase(begin + place, part.reasons[reason])
        for note in part.reasons:
            self.reasons.number(note)
        self.done += self._plan.size(part.index)


def _bytes_of(plan: Plan) -> int:
    per_case = sum(array.nbytes for array in plan.empty(1).values())
    return per_case * plan.cases


def _check_place(result: Path) -> None:
    """Refuse a place that cannot take the result before anything is solved."""
    if result.is_dir():
        raise FileError(said("is a directory; give a file"), source=str(result))
    if result.exists() and not stat.S_ISREG(result.stat().st_mode):
        raise FileError(said("is not a regular file; give another name"), source=str(result))
    if not result.parent.is_dir():
        raise FileError(said("cannot be written: there is no such directory"), source=str(result))


def _move(unfinished: Path, result: Path) -> None:
    try:
        os.replace(unfinished, result)
    except OSError as error:
        raise _unwritable(result, error) from None


@frozen
class FirstCase:
    """The first case that ended in some way, counted from 0, and why it has no result."""

    case: int
    reason: Note


@frozen
class OutputRange:
    """Minimum, median and maximum of an output over the cases with a result; SI units.

    every: the median is of every so-manieth case; 1 if of all.
    """

    output: Output
    minimum: float
    median: float
    maximum: float
    every: int


@frozen
class Summary:
    """A run to a file.

    Attributes
    ----------
    path
        the result
    cases
        in all
    solved
        in this run; the others were kept from an earlier one
    seconds
        that this took
    counts
        of cases by status
    first
        of each status but "converged", the first case and its reason
    ranges
        of the outputs
    ends
        how many cases at the ends of the ranges were looked at
    cautions
        what qualifies their outputs, and in how many of them
    columns
        of the cases, where they were to be kept
    """

    path: Path
    cases: int
    solved: int
    seconds: float
    counts: Mapping[str, int]
    first: Mapping[str, FirstCase]
    ranges: tuple[OutputRange, ...]
    ends: int = 0
    cautions: tuple[tuple[Note, int], ...] = ()
    columns: tuple[CaseColumn, ...] = ()

    @property
    def converged(self) -> int:
        """Cases with a result."""
        return self.counts.get("converged", 0)


class Spreads:
    """Gathers the ranges of the outputs, part by part, in bounded memory."""

    def __init__(self, plan: Plan) -> None:
        self._plan = plan
        self._every = -(-plan.cases // _MOST_KEPT)
        self._minimum = {output.name: math.inf for output in plan.outputs}
        self._maximum = {output.name: -math.inf for output in plan.outputs}
        self._ends: dict[tuple[str, str], int] = {}
        self._kept: dict[str, list[NDArray[np.float32]]] = {o.name: [] for o in plan.outputs}

    def add(self, part: Part) -> None:
        """Take in a part."""
        first, _ = self._plan.bounds_of(part)
        chosen = slice(-first % self._every, None, self._every)
        solved = part.arrays["status"] == CONVERGED
        for output in self._plan.outputs:
            values = part.arrays[output.name]
            there = (
                values[solved & np.isfinite(values)]
                if values.ndim == 1
                else values[np.isfinite(values)]
            )
            if there.size:
                low, high = float(there.min()), float(there.max())
                for end, value, is_beyond, known in (
                    ("minimum", low, low < self._minimum[output.name], self._minimum),
                    ("maximum", high, high > self._maximum[output.name], self._maximum),
                ):
                    if is_beyond:
                        known[output.name] = value
                        case = int(np.argwhere(values == value)[0, 0])
                        self._ends[output.name, end] = first + case
            some = values[chosen][solved[chosen]]
            self._kept[output.name].append(_few(some).astype(np.float32))

    def ranges(self) -> tuple[OutputRange, ...]:
        """Return the ranges so far; NaN of an output without a value."""
        return tuple(self._range(output) for output in self._plan.outputs)

    def ends(self) -> tuple[int, ...]:
        """Return cases at the ends of the ranges, each once, of the first outputs."""
        return tuple(dict.fromkeys(self._ends.values()))[:_MOST_ENDS]

    def _range(self, output: Output) -> OutputRange:
        kept = np.concatenate(self._kept[output.name])
        kept = kept[np.isfinite(kept)]
        if not len(kept):
            return OutputRange(output, math.nan, math.nan, math.nan, self._every)
        minimum, maximum = self._minimum[output.name], self._maximum[output.name]
        return OutputRange(output, minimum, float(np.median(kept)), maximum, self._every)


def _few(values: NDArray[np.generic]) -> NDArray[np.generic]:
    """Values of an output per ball, the values of every ball in turn: one for each case."""
    if values.ndim == 1:
        return values
    cases = np.arange(len(values))
    return np.asarray(values[cases, cases % values.shape[1]])


class PartWriter(Protocol):
    """Takes the parts of a result, one after the other from the first to the last."""

    def put(self, part: Part) -> None:
        """Write a part."""
        ...


def _check_ending(result: Path, known: Iterable[str]) -> None:
    if result.suffix.lower() not in known:
        raise FileError(
            said("must end in {known}", known=", ".join(known)),
            source=str(result),
            example="result.nc",
        )


Opener = Callable[
    [Path, Plan, Mapping[str, int], tuple[Note, ...]], AbstractContextManager[PartWriter]
]
"""Opens the writer of a kind of file, given cases by status and why some have no result."""


@contextmanager
def open_result(
    place: Path, opener: Opener, plan: Plan, counts: Mapping[str, int], reasons: tuple[Note, ...]
) -> Iterator[PartWriter]:
    """Open the writer of a file; what the disk refuses is a `FileError`."""
    try:
        with opener(place, plan, counts, reasons) as opened:
            yield opened
    except FileError:
        raise
    except OSError as error:
        raise _unwritable(place, error) from None


def _of_module(module: str, name: str) -> Opener:
    """An opener that brings a library which the others do not need."""

    def opened(
        place: Path, plan: Plan, counts: Mapping[str, int], reasons: tuple[Note, ...]
    ) -> AbstractContextManager[PartWriter]:
        opener: Opener = getattr(import_module(module), name)
        return opener(place, plan, counts, reasons)

    return opened


_WRITERS: Final[Mapping[str, Opener]] = {
    ".nc": _of_module("rolamento.studies.netcdf", "netcdf_writer"),
    ".csv": _of_module("rolamento.studies.tables", "csv_writer"),
    ".parquet": _of_module("rolamento.studies.tables", "parquet_writer"),
}


def _unwritable(path: Path, error: OSError) -> FileError:
    return FileError(said("cannot be written: {reason}", reason=cause(error)), source=str(path))
