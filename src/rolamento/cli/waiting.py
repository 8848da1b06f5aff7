"""What a person sees on standard error when something takes longer than a second.

Every command shows that it is at work (`working`). Some say more in the place of that; what is
counted, tests or parts of a signal, has a bar. There is one word at a time, and none while
something is written.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer
from typing import TYPE_CHECKING, Final

from rolamento.words import said

if TYPE_CHECKING:
    from rich.status import Status

    from rolamento.cli.common import Language

__all__ = ["PATIENCE", "Progress", "progress_of", "silenced", "told", "waiting", "working"]

PATIENCE: Final = 1.0
"""Seconds after which a person wants to know why nothing comes."""

Progress = Callable[[int, int], None]
"""Called with how much is done, and of how much."""


class _Word:
    """A line with a spinner that comes after a while, and may be stopped and begun again."""

    def __init__(self, text: str, after: float) -> None:
        self._text, self._after = text, after
        self._shown: list[Status] = []
        self.begin()

    def begin(self) -> None:
        """Wait for its time to come."""
        self._began = time.monotonic()
        self._timer = Timer(self._after, lambda: self._shown.append(_started(self._text)))
        self._timer.daemon = True
        self._timer.start()

    def end(self) -> None:
        """Take the line away, if it has come."""
        self._timer.cancel()
        self._timer.join()
        while self._shown:
            self._shown.pop().stop()

    @property
    def elapsed(self) -> float:
        """Seconds that nothing has been seen for but this word."""
        return time.monotonic() - self._began


_AT_WORK: Final[list[_Word | None]] = []
"""The words of what is under way; the last one is seen. None is for what shows itself."""


@contextmanager
def working() -> Iterator[None]:
    """Show at a terminal after a while that something is done; around every command."""
    if not _is_terminal() or _is_typed():
        yield
        return
    with told(said("Working …")):
        yield


@contextmanager
def waiting(
    lang: Language | None, text: str | None = None, after: float = PATIENCE
) -> Iterator[None]:
    """Show at a terminal after a while why; by default, that something is solved."""
    if not _is_terminal():
        yield
        return
    with told(said("Solving …") if text is None else text, after):
        yield


@contextmanager
def told(text: str, after: float = PATIENCE) -> Iterator[None]:
    """Show a line with a spinner if the body has not ended after a while."""
    with silenced() as elapsed:
        word = _Word(text, max(0.0, after - elapsed))
        _AT_WORK.append(word)
        try:
            yield
        finally:
            _AT_WORK.pop()
            word.end()


@contextmanager
def silenced() -> Iterator[float]:
    """Take the word of what is under way off the terminal while the body writes or shows something.

    Yields for how long nothing but that word has been seen, in s.
    """
    word = _AT_WORK[-1] if _AT_WORK else None
    elapsed = 0.0
    if word is not None:
        elapsed = word.elapsed
        word.end()
    _AT_WORK.append(None)
    try:
        yield elapsed
    finally:
        _AT_WORK.pop()
        if word is not None:
            word.begin()


@contextmanager
def progress_of(text: str, after: float = PATIENCE) -> Iterator[Progress]:
    """Show a bar if the body has not ended after a while; nothing where there is no terminal."""
    if not _is_terminal():
        yield lambda done, total: None
        return
    with silenced() as elapsed, _bar(text, max(0.0, after - elapsed)) as progress:
        yield progress


@contextmanager
def _bar(text: str, after: float) -> Iterator[Progress]:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bar

    console = Console(stderr=True, highlight=False)
    from rolamento.document.medium import Medium

    line = Medium.of(sys.stderr).fitted(text)
    if console.is_dumb_terminal:  # where a bar cannot move
        timer = Timer(after, console.print, [line])
        bar = None
    else:
        columns = (BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TextColumn(line))
        bar = Bar(*columns, console=console, transient=True)
        task = bar.add_task("", total=None)
        timer = Timer(after, bar.start)
    timer.daemon = True
    timer.start()

    def progress(done: int, total: int) -> None:
        if bar is not None:
            bar.update(task, completed=done, total=total)

    try:
        yield progress
    finally:
        timer.cancel()
        timer.join()
        if bar is not None and bar.live.is_started:
            bar.stop()


def _is_terminal() -> bool:
    return sys.stderr is not None and sys.stderr.isatty()


def _is_typed() -> bool:
    """Whether a person may be typing what is read, which a spinner would write into."""
    return "-" in sys.argv[1:] and sys.stdin is not None and sys.stdin.isatty()


def _started(text: str) -> Status:
    from rich.console import Console

    from rolamento.document.medium import Medium

    medium = Medium.of(sys.stderr)
    console = Console(stderr=True, highlight=False)
    line = medium.fitted(text)
    status = console.status(line, spinner="dots" if medium.draws else "line")
    if console.is_dumb_terminal:  # where a spinner cannot turn
        console.print(line)
    status.start()
    return status
