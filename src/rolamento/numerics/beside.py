"""Compiling beside the work: kernels are made by another process while this one goes on without.

What takes a compiler a minute, plain Python takes milliseconds to seconds for a few cases. So
nobody waits: where a kernel is not yet kept on this machine, one process of low priority compiles
all of them, one after the other (`rolamento warm`), and goes on when the one that started it has
ended. There is one at a time on a machine, which a lock beside the kernels sees to.

The environment variable ROLAMENTO_COMPILE says otherwise: `here` compiles where a kernel is needed,
and starts no process.
"""

from __future__ import annotations

import atexit
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path
from typing import IO, Final

from rolamento.numerics.locks import lock
from rolamento.numerics.trust import is_trusted
from rolamento.words import said

__all__ = ["LOW", "alone", "begin", "compile_beside", "compiles_here", "has_begun"]


VARIABLE: Final = "ROLAMENTO_COMPILE"
HERE: Final = "here"
LOW: Final = 15
"""How much the process gives way to others."""
_LOCK: Final = "compiling.lock"
_BEGUN: Final = "compiled.txt"
"""Names the version of the program that has been compiled, or begun to be."""
_process: Final[list[subprocess.Popen[bytes]]] = []


def compiles_here() -> bool:
    """Whether kernels are compiled by the process that needs them."""
    return os.environ.get(VARIABLE) == HERE


def compile_beside() -> bool:
    """Start the process if none is at work; whether one is."""
    folder = _folder()
    if compiles_here() or folder is None:
        return False
    if _process:
        return _process[0].poll() is None or _is_locked(folder)
    if _is_locked(folder):
        return True
    try:
        _process.append(_started())
    except OSError:  # no interpreter to be found, or no more processes
        return False
    import logging

    logging.getLogger("rolamento").warning(
        said(
            "compiling the solver for this machine in the background, once: until it is ready, "
            "many cases take longer"
        )
    )
    return True


@cache
def _folder() -> Path | None:
    """Where lock and note are kept; None if nowhere.

    A compiler that cannot keep what it makes is not started beside the work (`Kernel.is_kept`).
    """
    for folder in _folders():
        with suppress(OSError):
            folder.mkdir(parents=True, exist_ok=True)
            tempfile.TemporaryFile(dir=folder).close()
            if is_trusted(folder):
                return folder
    return None


def _folders() -> Iterator[Path]:
    """The compiler's folder where one is given, else ours, or the user's."""
    if given := os.environ.get("NUMBA_CACHE_DIR"):
        yield Path(given)
        return
    yield Path(__file__).parent / "__pycache__"
    home = os.environ.get("LOCALAPPDATA") or os.environ.get("XDG_CACHE_HOME")
    with suppress(RuntimeError):  # nobody is at home
        yield (Path(home) if home else Path.home() / ".cache") / "rolamento"


def _started() -> subprocess.Popen[bytes]:
    """Start the process in a session of its own, so that it outlives this one and its terminal.

    -P: what lies in the folder where somebody works is not imported.
    """
    process = subprocess.Popen(
        [sys.executable, "-P", "-m", "rolamento", "warm", "--background"],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    atexit.register(_leave, process)
    return process


def _leave(process: subprocess.Popen[bytes]) -> None:
    """Forget a process, which goes on: else Python warns that it does."""
    if process.poll() is None:
        process.returncode = 0


@contextmanager
def alone() -> Iterator[bool]:
    """Keep others from compiling at the same time; False where one is at it."""
    folder = _folder()
    file = None if folder is None else _locked(folder)
    if file is not None:  # who it is, for whoever wants to end it
        file.truncate(0)
        file.write(str(os.getpid()).encode())
        file.flush()
    try:
        yield folder is None or file is not None
    finally:
        if file is not None:
            file.close()


def _is_locked(folder: Path) -> bool:
    """Whether a process is compiling, as far as the system has locks."""
    file = _locked(folder)
    if file is not None:
        file.close()
    return file is None


def _locked(folder: Path) -> IO[bytes] | None:
    """The lock as long as it is open; None where another process has it."""
    try:
        file = (folder / _LOCK).open("ab")
    except OSError:
        return None
    if not lock(file):
        file.close()
        return None
    return file


def has_begun(version: str) -> bool:
    """Whether compiling has been begun on this machine for a version, or nothing can be kept.

    What has been begun is begun by itself no more: it may have failed for good. Whoever needs a
    kernel begins it anew.
    """
    for folder in _folders():
        with suppress(OSError, UnicodeDecodeError):
            return (folder / _BEGUN).read_text("utf-8") == version
    return _folder() is None


def begin(version: str) -> None:
    """Keep that compiling has been begun for a version."""
    folder = _folder()
    if folder is not None:
        with suppress(OSError):
            (folder / _BEGUN).write_text(version, "utf-8")
