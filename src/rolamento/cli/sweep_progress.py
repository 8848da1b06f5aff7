"""How far a study has come: a bar on a terminal, now and then a line elsewhere."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Final, TextIO

from rolamento.cli.streams import complain
from rolamento.cli.waiting import silenced
from rolamento.document.medium import Medium
from rolamento.words import counted, said

__all__ = ["Lines", "told"]

Progress = Callable[[int, int, int], None]

INTERVAL: Final = 10.0
"""Seconds between two lines where there is no terminal."""


@contextmanager
def told(stream: TextIO | None = None) -> Iterator[Progress]:
    """Show progress on standard error while the body runs."""
    stream = sys.stderr if stream is None else stream
    if stream is None or not stream.isatty():
        yield Lines()
        return
    from rich.console import Console

    console = Console(file=stream, highlight=False)
    if console.is_dumb_terminal:
        yield Lines()
        return
    with silenced(), _bar(console, Medium.of(stream)) as progress:
        yield progress


class Rate:
    """Cases per second since the first report, and the seconds that are left."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._began: float | None = None
        self._kept = 0

    def tell(self, done: int) -> None:
        """Take note of the cases done; those of the first time were there before."""
        if self._began is None:
            self._began, self._kept = self._clock(), done

    def at(self, done: int) -> float:
        """Cases per second."""
        elapsed = self._clock() - (self._began or 0.0)
        return (done - self._kept) / elapsed if elapsed > 0.0 else 0.0

    def left(self, done: int, total: int) -> float:
        """Seconds until the last case."""
        rate = self.at(done)
        return (total - done) / rate if rate > 0.0 else float("nan")


class Lines:
    """Writes a line every few seconds."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._rate = Rate(clock)
        self._next = clock() + INTERVAL

    def __call__(self, done: int, total: int, failed: int) -> None:
        """Take note, and write a line if it is time."""
        self._rate.tell(done)
        if self._clock() < self._next or done >= total:
            return
        self._next = self._clock() + INTERVAL
        line = said(
            "{done} of {total} cases, {rate:.0f}/s, {left} left",
            done=done,
            total=total,
            rate=self._rate.at(done),
            left=_clock_time(self._rate.left(done, total)),
        )
        complain(f"{line}, {_failed(failed)}" if failed else line)


@contextmanager
def _bar(console: Any, medium: Medium) -> Iterator[Progress]:
    from rich.progress import BarColumn, TextColumn
    from rich.progress import Progress as RichProgress

    columns = (TextColumn("{task.description}"), BarColumn(), TextColumn("{task.fields[state]}"))
    with RichProgress(*columns, console=console, transient=True) as bar:
        task = bar.add_task(medium.fitted(said("solving")), total=None, state="")
        rate = Rate()

        def progress(done: int, total: int, failed: int) -> None:
            rate.tell(done)
            parts = [said("{done} / {total}", done=done, total=total)]
            if rate.at(done) > 0.0:
                left = _clock_time(rate.left(done, total))
                parts.append(said("{rate:.0f}/s, {left} left", rate=rate.at(done), left=left))
            if failed:
                parts.append(_failed(failed))
            state = medium.fitted("  ".join(parts))
            bar.update(task, completed=done, total=total, state=state)

        yield progress


def _failed(number: int) -> str:
    return counted("{n} without a result", "{n} without a result", number)


def _clock_time(seconds: float) -> str:
    """Write seconds as minutes and seconds, with hours if there are any."""
    if seconds != seconds:
        return "?"
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02d}:{rest:02d}" if hours else f"{minutes}:{rest:02d}"
