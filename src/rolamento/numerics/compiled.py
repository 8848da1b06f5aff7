"""How the project's kernels are compiled: in one place, so that each choice is made once.

A kernel is written once and runs in two ways. Called, it runs as the plain Python it is: slow by
a factor of hundreds, but without loading a compiler, which is what one case on the command line
wants. Its attribute `compiled` is the same text through Numba, for everything else. Numba is not
imported before that.

`kernel` is for what is compiled and called as a whole: cached on disk, free of the interpreter
lock. `shared` functions are called by kernels; `filling` ones make no arrays, nor does a
`filling_kernel`, which therefore is loaded sooner. `inline_fast` and
`inline_exact` are for formulas, compiled into every caller: fast ones may be re-associated, so that
they turn into vector code; exact ones follow IEEE 754 to the letter and serve to check the fast
ones. No formula may assume that NaN does not happen: a NaN is how a case says that it has failed.
In a formula that is of numbers and of arrays (`numerics.elementwise`) `choose` is the condition.
"""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import cache, cached_property, partial, update_wrapper, wraps
from hashlib import sha256
from importlib import import_module
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, ParamSpec, Self, TypeVar

import numpy as np

from rolamento.numerics.locks import lock
from rolamento.numerics.trust import is_trusted

P = ParamSpec("P")
R = TypeVar("R")

_DIGEST = sha256().digest_size
_VECTORISABLE = {"reassoc", "arcp", "contract", "afn", "nsz"}
_LINKED = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
"""Options of what only kernels call: nothing in Python does, nor a program in C."""
_OF_ARRAYS = "numba.np.arraymath"
_FAMILIES = (  # where kernels live, each with the formulas that they are compiled from
    ("numerics", "rows/ball", "rows/ball/traction"),
    ("numerics", "contact", "rows/roller"),
    ("numerics", "rows"),
    ("numerics", "friction"),
    ("numerics", "."),
)
_DECORATED = r"(?m)^ *@(\w*kernel|shared|filling|inline_\w+|vector_loop)$"
_CONSTANTS = frozenset({"compiled", "layout", "newton"})  # files without kernels that shape them


class Kernel(partial[R], Generic[P, R]):
    """A function that runs as it is written, or compiled.

    A `partial` without arguments: one case calls kernels in kernels ten thousands of times.
    """

    def __new__(cls, function: Callable[P, R], **options: Any) -> Self:
        """Bind nothing: the options are how to compile."""
        return super().__new__(cls, function)

    def __init__(self, function: Callable[P, R], **options: Any) -> None:
        self.python = function
        self._options = options
        update_wrapper(self, function)

    if TYPE_CHECKING:

        def __call__(self, *args: P.args, **kwargs: P.kwargs) -> R:
            """Run the function as plain Python."""

    @cached_property
    def compiled(self) -> Callable[P, R]:
        """The function compiled by Numba, on the first call or from the cache."""
        numba = _numba()
        options = {"error_model": "numpy", **self._options}
        if not options.pop("cache", False):
            return numba.njit(**options)(self.python)  # type: ignore[no-any-return]
        _discard_stale_caches()
        compiled = numba.njit(**options)(self.python)
        # no folder for the cache: compile anew in each process
        with suppress(RuntimeError):
            cache = _checked_cache()(self.python, options.get("_nrt", True))
            cache.ensure_trusted()
            compiled._cache = cache
        return compiled  # type: ignore[no-any-return]

    @cached_property
    def linked(self) -> Callable[P, R]:
        """The function as kernels call it: without an entry from Python, unless it is one."""
        if self._options.get("cache"):
            return self.compiled
        options = {"error_model": "numpy", **self._options, **_LINKED}
        return _numba().njit(**options)(self.python)  # type: ignore[no-any-return]

    @property
    def is_loaded(self) -> bool:
        """Whether the compiled function is ready in this process."""
        return "compiled" in vars(self) and bool(getattr(self.compiled, "signatures", ()))

    @property
    def is_cached(self) -> bool:
        """Whether compiled code is on disk or loaded; if not, the first call takes a while."""
        if self.is_loaded:
            return True
        if self._folder is None:
            return False
        source = Path(self.python.__code__.co_filename).stem
        pattern = f"{source}.{self.python.__qualname__}-*.nbi"
        return any(self._folder.glob(pattern))

    @property
    def is_kept(self) -> bool:
        """Whether there is a place on disk for the compiled code."""
        return self._folder is not None

    @property
    def _folder(self) -> Path | None:
        folder = getattr(getattr(self.compiled, "_cache", None), "cache_path", None)
        return None if folder is None else Path(folder)


def kernel(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a kernel: compiled code is kept on disk where there is a place for it."""
    return Kernel(function, nogil=True, cache=True)


def shared(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a function that kernels call, in IEEE 754 arithmetic as it is written."""
    return Kernel(function, nogil=True)


def filling(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a function that kernels call, which only reads and fills the arrays that it is given.

    It makes none, returns none, and calls nothing that does. So it need not be counted who holds
    them, which takes longer than a short function, and threads that share an array wait for it.
    """
    return Kernel(function, nogil=True, _nrt=False)


def filling_kernel(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a kernel that is `filling` itself: loading it needs less of Numba than another's."""
    return Kernel(function, nogil=True, cache=True, _nrt=False)


def inline_exact(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a formula that is compiled into its callers, as it is written."""
    return Kernel(function, forceinline=True)


def inline_fast(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a formula that is compiled into its callers, free to become vector code."""
    return Kernel(function, forceinline=True, fastmath=_VECTORISABLE)


def vector_loop(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a loop over lanes that fills arrays, compiled on its own to become vector code."""
    return Kernel(function, nogil=True, fastmath=_VECTORISABLE, _nrt=False)


def choose(condition: Any, this: Any, that: Any) -> Any:
    """Return this where a condition holds, else that: of arrays, and of numbers in a kernel."""
    return np.where(condition, this, that)


def at_hand() -> bool:
    """Whether this process has loaded the compiler for something: many cases were solved."""
    return bool(_numba.cache_info().currsize)


@cache
def _numba() -> Any:
    """Import Numba, and teach it that a kernel inside a kernel means the compiled one.

    The loops over lanes read and write so many rows that LLVM, left to itself, gives up sorting
    them before it has seen that they do not overlap, and compiles scalar code.
    """
    import llvmlite.binding
    import numba

    _take_whole_vectors(numba.config)
    llvmlite.binding.set_option("rolamento", "--memory-check-merge-threshold=1000")
    from numba.core import types
    from numba.extending import overload, typeof_impl

    cpu: Any = import_module("numba.core.cpu")
    load = cpu.CPUContext.load_additional_registries
    cpu.CPUContext.load_additional_registries = _without_linear_algebra(load)
    environment: Any = import_module("numba.core.environment")
    environment._rebuild_env = _without_linear_algebra(environment._rebuild_env)
    cpu.CPUContext.get_executable = _only_of_kernels(cpu.CPUContext.get_executable)

    @typeof_impl.register(Kernel)
    def _typeof(value: Kernel[Any, Any], context: Any) -> Any:
        return types.Dispatcher(value.linked)

    overload(choose)(
        lambda condition, this, that: lambda condition, this, that: this if condition else that
    )

    return numba


def _take_whole_vectors(config: Any) -> None:
    """Use 512-bit vectors wherever there are any, unless NUMBA_CPU_FEATURES says otherwise.

    LLVM prefers 256 bits on Intel's processors, whose clock once fell with more.
    """
    features = import_module("numba.core.codegen").get_host_cpu_features()
    if config.CPU_FEATURES is None and "+avx512f" in features:
        config.CPU_FEATURES = f"{features},-prefer-256-bit"


def _only_of_kernels(executable: Callable[..., Any]) -> Callable[..., Any]:
    """Neither optimise what only kernels call nor make machine code of it, before it is linked.

    Numba does both for each function by itself, and again for each that calls it.
    """
    make_function = import_module("numba._dynfunc").make_function

    def executable_of_kernel(context: Any, library: Any, described: Any, environment: Any) -> Any:
        if library._finalized or _has(library, described.llvm_cpython_wrapper_name):
            return executable(context, library, described, environment)
        library._optimize_final_module = lambda: None
        library._finalize_final_module = library._finalize_dynamic_globals
        library.finalize()
        library._finalized = True
        module, name = described.lookup_module(), described.qualname
        return make_function(module, name, "", 0, environment, (library,))

    return executable_of_kernel


def _has(library: Any, name: str) -> bool:
    """Whether a library defines a function."""
    try:
        return not library.get_function(name).is_declaration
    except NameError:
        return False


def _without_linear_algebra(act: Callable[..., Any]) -> Callable[..., Any]:
    """Have Numba import what it knows of arrays without SciPy's linear algebra, 0.1 s of it.

    It imports that only to say whether it is there, and anew where a kernel would call it. `act`
    imports the module of its first argument, or all that Numba compiles with.
    """

    @wraps(act)  # kernels on disk name it
    def act_without(of: Any, *others: Any) -> Any:
        if of == _OF_ARRAYS or not isinstance(of, str):
            linalg: Any = import_module("numba.np.linalg")
            looks = linalg.ensure_blas
            linalg.ensure_blas = lambda: None
            try:
                arrays: Any = import_module(_OF_ARRAYS)
                arrays.ensure_blas = looks
            finally:
                linalg.ensure_blas = looks
        return act(of, *others)

    return act_without


@cache
def _checked_cache() -> Any:
    """Numba's cache on disk, with a checksum behind each file.

    Numba takes what it finds for whole: a damaged file raises whatever its bytes lead to, or ends
    the process, and one that cannot be written is an error of the function that was called.
    """
    caching: Any = import_module("numba.core.caching")
    runtime: Any = import_module("numba.core.runtime")

    class CheckedFiles(caching.IndexDataCacheFile):  # type: ignore[misc]
        @contextmanager
        def _open_for_write(self, filepath: str) -> Iterator[io.BytesIO]:
            with super()._open_for_write(filepath) as file:
                content = io.BytesIO()
                yield content
                # what reads a pickle stops at its end
                file.write(content.getvalue() + sha256(content.getvalue()).digest())

        def save(self, key: Any, data: Any) -> None:
            # Numba's own order names the file before it is there: another process would run what
            # an older source or another signature has left under that name
            with Path(self._index_path).with_name("kernels.lock").open("ab") as file:
                lock(file, wait=True)
                names = self._load_index()
                name = names.get(key) or self._free_name(set(names.values()))
                self._save_data(name, data)
                if key not in names:
                    self._save_index({**names, key: name})

        def _free_name(self, taken: set[str]) -> str:
            return next(name for i in count(1) if (name := str(self._data_name(i))) not in taken)

        def _load_index(self) -> Any:
            _check(self._index_path)
            return super()._load_index()

        def _load_data(self, name: str) -> Any:
            _check(self._data_path(name))
            return super()._load_data(name)

    class CheckedCache(caching.FunctionCache):  # type: ignore[misc]
        def __init__(self, function: Callable[..., Any], makes_arrays: bool) -> None:
            super().__init__(function)
            self._makes_arrays = makes_arrays
            self._cache_file: Any = CheckedFiles(
                self._cache_path, self._impl.filename_base, self._impl.locator.get_source_stamp()
            )

        def ensure_trusted(self) -> None:
            # what is kept is run as soon as it is read
            folder = Path(self.cache_path)
            self._impl.locator.ensure_cache_path()
            if not is_trusted(folder):
                _tell_once(
                    f"others may write to {folder} or to a folder above it: the compiled solver is "
                    "neither read from there nor kept there, and each process compiles it anew"
                )
                raise RuntimeError(folder)

        def load_overload(self, sig: Any, target_context: Any) -> Any:
            # what is compiled needs Numba's memory, not all that Numba knows how to compile
            if self._makes_arrays:
                runtime.rtsys.initialize(target_context)
            try:
                with self._guard_against_spurious_io_errors():
                    return self._load_overload(sig, target_context)
            except Exception:  # whatever the bytes led to
                _warn(
                    f"the compiled solver that is kept in {self.cache_path} is damaged:"
                    " compiling it anew"
                )
                self._discard()
                return None

        def save_overload(self, sig: Any, data: Any) -> None:
            try:
                super().save_overload(sig, data)
            except OSError as error:
                _tell_once(
                    f"the compiled solver cannot be kept in {self.cache_path} "
                    f"({(error.strerror or str(error)).lower()}): each process compiles it anew"
                )

        def _discard(self) -> None:
            for file in Path(self.cache_path).glob(f"{self._impl.filename_base}.*nb[ic]"):
                try:
                    file.unlink()
                except OSError:  # a folder that is only read: never mind what is in it
                    self.disable()

    return CheckedCache


def _check(path: str) -> None:
    """Raise ValueError for a file of others, or whose end is not the checksum of all before it."""
    try:
        content = Path(path).read_bytes()
    except FileNotFoundError:  # nothing is kept yet
        return
    if sha256(content[:-_DIGEST]).digest() != content[-_DIGEST:] or not is_trusted(Path(path)):
        raise ValueError(path)


def _warn(message: str) -> None:
    import logging

    logging.getLogger("rolamento").warning("%s", message)


_tell_once = cache(_warn)


@cache
def _discard_stale_caches() -> None:
    """Delete cached kernels that are older than a formula they were compiled from.

    Numba looks only at the file of the kernel itself, not at the files of what it inlines.
    """
    package = Path(__file__).resolve().parent.parent
    for rooms in _FAMILIES:
        sources = [source for room in rooms for source in (package / room).glob("*.py")]
        newest = max(source.stat().st_mtime for source in sources if _is_compiled(source))
        for room in rooms:
            for index in (package / room / "__pycache__").glob("*.nbi"):
                try:
                    if index.stat().st_mtime < newest:
                        index.unlink()
                except OSError:  # another process was faster, or the folder is read-only
                    continue


def _is_compiled(source: Path) -> bool:
    """Whether a file holds kernels or formulas, or constants that they were compiled with."""
    return source.stem in _CONSTANTS or bool(re.search(_DECORATED, source.read_text("utf-8")))
