"""The command line: `rolamento`, and a module for each of its commands."""

import atexit
import gc
import os
import sys
from contextlib import suppress
from typing import Final

__all__ = ["main"]

_LITTLE_GARBAGE: Final = 250_000
"""Objects made between two looks for garbage: nearly all that a start makes stay."""


def main() -> None:
    """Run the command line, and end the process."""
    codes: list[int] = []
    atexit.register(_leave, codes)  # the first that is registered is called last
    gc.set_threshold(_LITTLE_GARBAGE)
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "1")  # else all that is installed is searched
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # others would spin beside small matrices
    from rolamento.cli.app import run

    try:
        run()
    except SystemExit as end:
        if isinstance(end.code, int):
            codes.append(end.code)
        raise


def _leave(codes: list[int]) -> None:
    """End at once: all that is left to do is to give back memory, object by object."""
    if codes:
        with suppress(AttributeError, OSError, ValueError):  # no stream, or a closed one
            sys.stdout.flush()
        os._exit(codes[0])
