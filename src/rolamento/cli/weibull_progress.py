"""How far the drawing of tests is, on standard error, for whoever waits longer than a moment."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer
from typing import Final

__all__ = ["told"]

Progress = Callable[[int, int], None]

PATIENCE: Final = 1.0
"""Seconds after which a person wants to know."""


@contextmanager
def told(text: str, after: float = PATIENCE) -> Iterator[Progress]:
    """Show a bar if the body has not ended after a while; nothing where there is no terminal."""
    if sys.stderr is None or not sys.stderr.isatty():
        yield lambda done, total: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bar

    from rolamento.report.medium import Medium

    console = Console(stderr=True, highlight=False)
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
