"""What a person sees on standard error when solving takes longer than usual.

One case is solved without the compiler, at once. The few that need compiled code wait for it, the
first time on a machine about 20 s.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Timer
from typing import TYPE_CHECKING, Final

from rolamento.cli.common import Language, words_of
from rolamento.report.medium import Medium

if TYPE_CHECKING:
    from rich.status import Status

__all__ = ["PATIENCE", "told", "waiting"]

PATIENCE: Final = 2.0
"""Seconds after which a person wants to know."""


@contextmanager
def waiting(lang: Language | None) -> Iterator[None]:
    """Tell whoever waits at a terminal for long why."""
    if sys.stderr is None or not sys.stderr.isatty():
        yield
        return
    with told(words_of(lang).waiting):
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


def _started(text: str) -> Status:
    from rich.console import Console

    medium = Medium.of(sys.stderr)
    console = Console(stderr=True, highlight=False)
    line = medium.fitted(text)
    status = console.status(line, spinner="dots" if medium.draws else "line")
    if console.is_dumb_terminal:  # where a spinner cannot turn
        console.print(line)
    status.start()
    return status
