"""Processes that tests start: with the signals that a test relies on, and none left behind."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import rolamento

__all__ = ["python"]


@contextmanager
def python(
    *arguments: str, ignored: Sequence[signal.Signals] = (), **options: Any
) -> Iterator[subprocess.Popen[Any]]:
    """Run Python with this package in a session of its own, which ends with the block.

    Ctrl-C reaches it, unless it is among the ignored signals: a process that a shell starts in the
    background, as build servers do, ignores it, and so do its children.
    """

    def as_in_a_terminal() -> None:
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, signal.SIG_IGN if number in ignored else signal.SIG_DFL)

    if os.name == "posix":
        options |= {"preexec_fn": as_in_a_terminal, "start_new_session": True}
    environment = {
        **os.environ,
        "PYTHONPATH": str(Path(rolamento.__file__).parents[1]),
        **options.pop("env", {}),
    }
    with subprocess.Popen([sys.executable, *arguments], env=environment, **options) as process:
        try:
            yield process
        finally:
            with suppress(ProcessLookupError):
                if os.name == "posix":
                    os.killpg(process.pid, signal.SIGKILL)
                else:
                    process.kill()
