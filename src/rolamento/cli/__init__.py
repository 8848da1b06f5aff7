"""The command line: `rolamento`, and a module for each of its commands."""

import atexit
import gc
import os
import sys
from contextlib import suppress
from importlib import import_module
from types import ModuleType
from typing import Any, Final

__all__ = ["main"]

_LITTLE_GARBAGE: Final = 250_000
"""Objects made between two looks for garbage: nearly all that a start makes stay."""
_PLUGINS: Final = "pydantic.plugin._loader"


def main() -> None:
    """Run the command line, and end the process."""
    codes: list[int] = []
    atexit.register(_leave, codes)  # the first that is registered is called last
    gc.set_threshold(_LITTLE_GARBAGE)
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "1")  # else all that is installed is searched
    sys.modules[_PLUGINS] = _NoPlugins(_PLUGINS)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # others would spin beside small matrices
    from rolamento.cli.app import run

    try:
        run()
    except SystemExit as end:
        if isinstance(end.code, int):
            codes.append(end.code)
        raise


class _NoPlugins(ModuleType):
    """In the place of what looks for plugins of pydantic, and imports `email` before it does."""

    get_plugins = staticmethod(tuple)

    def __getattr__(self, name: str) -> Any:  # a later pydantic, which asks for something else
        if name.startswith("__"):
            raise AttributeError(name)
        del sys.modules[self.__name__]
        return getattr(import_module(self.__name__), name)


def _leave(codes: list[int]) -> None:
    """End at once: all that is left to do is to give back memory, object by object."""
    if not codes or hasattr(sys, "last_type"):  # else a program that went on has failed since
        return
    for stream in (sys.stdout, sys.stderr):
        with suppress(AttributeError, OSError, ValueError):  # no stream, or a closed one
            stream.flush()
    os._exit(codes[0])
