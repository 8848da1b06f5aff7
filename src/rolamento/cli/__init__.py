"""The command line: `rolamento`, and a module for each of its commands."""

import atexit
import gc
import os
from typing import Final

__all__ = ["main"]

_LITTLE_GARBAGE: Final = 250_000
"""Objects made between two looks for garbage: nearly all that a start makes stay."""


def main() -> None:
    """Run the command line."""
    gc.set_threshold(_LITTLE_GARBAGE)
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "1")  # else all that is installed is searched
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # others would spin beside small matrices
    atexit.register(gc.freeze)  # at the end all memory is given back: nobody has to search it
    from rolamento.cli.app import run

    run()
