"""How the project's kernels are compiled: in one place, so that each choice is made once.

A kernel is written once and runs in two ways. Called, it runs as the plain Python it is: slow by
a factor of hundreds, but without loading a compiler, which is what one case on the command line
wants. Its attribute `compiled` is the same text through Numba, for everything else. Numba is not
imported before that.

`kernel` is for what is compiled and called as a whole: cached on disk, free of the interpreter
lock. `shared` functions are called by kernels. `inline_fast` and `inline_exact` are for formulas,
compiled into every caller: fast ones may be re-associated, so that they turn into vector code;
exact ones follow IEEE 754 to the letter and serve to check the fast ones. No formula may assume
that NaN does not happen: a NaN is how a case says that it has failed.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, cached_property, update_wrapper
from pathlib import Path
from typing import Any, Generic, ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")

_VECTORISABLE = {"reassoc", "arcp", "contract", "afn", "nsz"}
_ROOMS = ("numerics", "equilibrium", "equilibrium/traction")  # where kernels and formulas live
_CONSTANTS = frozenset({"compiled", "rows"})  # files without kernels that shape them


class Kernel(Generic[P, R]):
    """A function that runs as it is written, or compiled."""

    def __init__(self, function: Callable[P, R], **options: Any) -> None:
        self.python = function
        self._options = options
        update_wrapper(self, function)

    def __call__(self, *args: P.args, **kwargs: P.kwargs) -> R:
        """Run the function as plain Python."""
        return self.python(*args, **kwargs)

    @cached_property
    def compiled(self) -> Callable[P, R]:
        """The function compiled by Numba, on the first call or from the cache."""
        numba = _numba()
        options = {"error_model": "numpy", **self._options}
        if not options.pop("cache", False):
            return numba.njit(**options)(self.python)  # type: ignore[no-any-return]
        _discard_stale_caches()
        try:
            return numba.njit(cache=True, **options)(self.python)  # type: ignore[no-any-return]
        except RuntimeError:  # no folder for the cache: compile anew in each process
            return numba.njit(**options)(self.python)  # type: ignore[no-any-return]

    @property
    def is_loaded(self) -> bool:
        """Whether the compiled function is ready in this process."""
        return "compiled" in vars(self) and bool(getattr(self.compiled, "signatures", ()))

    @property
    def is_cached(self) -> bool:
        """Whether compiled code is on disk or loaded; if not, the first call takes a while."""
        if self.is_loaded:
            return True
        folder = getattr(getattr(self.compiled, "_cache", None), "cache_path", None)
        if folder is None:
            return False
        source = Path(self.python.__code__.co_filename).stem
        pattern = f"{source}.{self.python.__qualname__}-*.nbi"
        return any(Path(folder).glob(pattern))


def kernel(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a kernel: compiled code is kept on disk where there is a place for it."""
    return Kernel(function, nogil=True, cache=True)


def shared(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a function that kernels call, in IEEE 754 arithmetic as it is written."""
    return Kernel(function, nogil=True)


def inline_exact(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a formula that is compiled into its callers, as it is written."""
    return Kernel(function, forceinline=True)


def inline_fast(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a formula that is compiled into its callers, free to become vector code."""
    return Kernel(function, forceinline=True, fastmath=_VECTORISABLE)


def vector_loop(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a loop over lanes, compiled on its own so that it can become vector code."""
    return Kernel(function, nogil=True, fastmath=_VECTORISABLE)


@cache
def _numba() -> Any:
    """Import Numba, and teach it that a kernel inside a kernel means the compiled one."""
    import numba
    from numba.core import types
    from numba.extending import typeof_impl

    @typeof_impl.register(Kernel)
    def _typeof(value: Kernel[Any, Any], context: Any) -> Any:
        return types.Dispatcher(value.compiled)

    return numba


@cache
def _discard_stale_caches() -> None:
    """Delete cached kernels that are older than a formula they were compiled from.

    Numba looks only at the file of the kernel itself, not at the files of what it inlines.
    """
    package = Path(__file__).resolve().parent.parent
    sources = [source for room in _ROOMS for source in (package / room).glob("*.py")]
    sources = [source for source in sources if _is_compiled(source)]
    newest = max(source.stat().st_mtime for source in sources)
    for room in _ROOMS:
        for index in (package / room / "__pycache__").glob("*.nbi"):
            try:
                if index.stat().st_mtime < newest:
                    index.unlink()
            except OSError:  # another process was faster, or the folder is read-only
                continue


def _is_compiled(source: Path) -> bool:
    """Tell whether a file holds kernels, or constants that they were compiled with."""
    return source.stem in _CONSTANTS or "numerics.compiled" in source.read_text("utf-8")
