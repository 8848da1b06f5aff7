"""What a person sees on standard error when something takes longer than usual.

One case is solved without the compiler, at once. The few that need compiled code wait for it, the
first time on a machine about 20 s. What is counted, tests or parts of a signal, has a bar.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer
from typing import TYPE_CHECKING, Final

from rolamento.cli.common import Language
from rolamento.words import said

if TYPE_CHECKING:
    from rich.status import Status

__all__ = ["PATIENCE", "PATIENCE_AT_WORK", "Progress", "progress_of", "told", "waiting"]

PATIENCE: Final = 2.0
"""Seconds after which a person wants to know why nothing comes."""
PATIENCE_AT_WORK: Final = 1.0
"""The same where work is known to take long."""

Progress = Callable[[int, int], None]
"""Is told how much is done, and of how much."""


@contextmanager
def waiting(
    lang: Language | None, text: str | None = None, after: float = PATIENCE
) -> Iterator[None]:
    """Tell whoever waits at a terminal for long why; by default, that kernels are compiled."""
    if not _is_terminal():
        yield
        return
    kernels = said("Solving; compiling the kernels for this machine, once, takes about 20 s …")
    with told(kernels if text is None else text, after):
        yield


@contextmanager
def told(text: str, after: float = PATIENCE) -> Iterator[None]:
    """Show a line with a spinner if the body has not ended after a while."""
    shown: list[Status] = []
    timer = Timer(after, lambda: shown.append(_started(text)))
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        timer.join()
        for status in shown:
            status.stop()


@contextmanager
def progress_of(text: str, after: float = PATIENCE_AT_WORK) -> Iterator[Progress]:
    """Show a bar if the body has not ended after a while; nothing where there is no terminal."""
    if not _is_terminal():
        yield lambda done, total: None
        return
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
