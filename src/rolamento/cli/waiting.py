"""What a person sees on standard error while the kernels compile."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

from rich.console import Console

from rolamento.report.medium import Medium

__all__ = ["told"]


@contextmanager
def told(text: str) -> Iterator[None]:
    """Show a line with a spinner as long as the body runs; a plain line on a plain terminal."""
    console, medium = Console(stderr=True, highlight=False), Medium.of(sys.stderr)
    line = medium.fitted(text)
    if console.is_dumb_terminal:
        console.print(line)
        yield
        return
    with console.status(line, spinner="dots" if medium.draws else "line"):
        yield
