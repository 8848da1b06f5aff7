"""How the project's kernels are compiled: in one place, so that each choice is made once.

`kernel` is for what is called from Python: cached on disk, free of the interpreter lock.
`inline_fast` and `inline_exact` are for the formulas inside, compiled into every caller:
fast ones may be re-associated, so that they turn into vector code; exact ones follow IEEE 754
to the letter and serve to check the fast ones. No formula may assume that NaN does not happen:
a NaN is how a lane says that it has failed.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar, cast

import numba

F = TypeVar("F", bound=Callable[..., Any])

_VECTORISABLE = {"reassoc", "arcp", "contract", "afn", "nsz"}

_kernels: list[Any] = []


@cache
def _discard_stale_caches() -> None:
    """Delete cached kernels that are older than a formula they were compiled from.

    Numba looks only at the file of the kernel itself, not at the files of what it inlines.
    """
    package = Path(__file__).resolve().parent.parent
    newest = max(
        source.stat().st_mtime
        for room in ("numerics", "equilibrium")
        for source in (package / room).glob("*.py")
    )
    for room in ("numerics", "equilibrium"):
        for index in (package / room / "__pycache__").glob("*.nbi"):
            try:
                if index.stat().st_mtime < newest:
                    index.unlink()
            except OSError:  # another process was faster, or the folder is read-only
                continue


def kernel(function: F) -> F:
    """Compile a function that Python calls, with a cache on disk where one can be kept."""
    _discard_stale_caches()
    try:
        compiled = numba.njit(cache=True, nogil=True, error_model="numpy")(function)
    except RuntimeError:  # no folder for the cache: compile anew in each process
        compiled = numba.njit(nogil=True, error_model="numpy")(function)
    _kernels.append(compiled)
    return cast("F", compiled)


def shared(function: F) -> F:
    """Compile a function that kernels call, exactly, without pressing it into each of them."""
    return cast("F", numba.njit(error_model="numpy", nogil=True)(function))


def inline_exact(function: F) -> F:
    """Compile a formula into its callers, in IEEE 754 arithmetic as it is written."""
    return cast("F", numba.njit(error_model="numpy", forceinline=True)(function))


def inline_fast(function: F) -> F:
    """Compile a formula into its callers, free to be re-ordered into vector code."""
    compiled = numba.njit(fastmath=_VECTORISABLE, error_model="numpy", forceinline=True)(function)
    return cast("F", compiled)


def vector_loop(function: F) -> F:
    """Compile a loop over lanes on its own, where the compiler can turn it into vector code."""
    compiled = numba.njit(fastmath=_VECTORISABLE, error_model="numpy", nogil=True)(function)
    return cast("F", compiled)


def kernels_are_cached() -> bool:
    """Tell whether the kernels have been compiled before: if not, the first call takes a while."""
    return all(_is_cached(compiled) for compiled in _kernels)


def _is_cached(compiled: Any) -> bool:
    """Whether Numba has an index of a kernel for this machine; if it cannot tell, it has not."""
    cache_of_kernel = getattr(compiled, "_cache", None)
    folder = getattr(cache_of_kernel, "cache_path", None)
    if compiled.signatures:
        return True
    if folder is None:
        return False
    name = f"{Path(compiled.py_func.__code__.co_filename).stem}.{compiled.py_func.__name__}-"
    return any(entry.name.startswith(name) for entry in Path(folder).glob("*.nbi"))
