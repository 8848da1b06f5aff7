"""Where a worker process begins: it steps back before it loads what it works with.

This module imports nothing of the project, so that loading it takes no time from what is fast.
"""

from __future__ import annotations

import os
import pickle
from functools import cache
from typing import Any, Final

__all__ = ["run"]

_NICENESS: Final = 10


def run(work: bytes) -> Any:
    """Run a function and its arguments, pickled as a pair by the server, with a low priority."""
    _step_back()
    function, args = pickle.loads(work)  # from the server that started this process
    return function(*args)


@cache
def _step_back() -> None:
    if hasattr(os, "nice"):
        os.nice(_NICENESS)
