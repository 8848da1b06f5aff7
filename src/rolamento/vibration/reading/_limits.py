"""What a signal file may ask for, and how its failures become one sentence.

A file is somebody else's: every size that it declares is held against these limits before memory
is taken for it, and whatever a library raises over its contents becomes a `FileError`.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO, Final

import numpy as np

from rolamento._foreign.bounds import LARGEST_WHOLE
from rolamento.errors import FileError, InputError, shown

__all__ = [
    "LONGEST_NAME",
    "LONGEST_UNIT",
    "MOST_CHANNELS",
    "MOST_SAMPLES",
    "check_size",
    "exactly",
    "file_size",
    "guarded",
    "opened",
]

MOST_SAMPLES: Final = 100_000_000
"""Of one channel in memory at once: 0.8 GB."""
MOST_CHANNELS: Final = 1000
LONGEST_NAME: Final = 100
"""Characters of a channel's name; longer ones are cut."""
LONGEST_UNIT: Final = 30


def file_size(path: str | os.PathLike[str]) -> int:
    """Size of a regular file with something in it; bytes.

    Raises
    ------
    FileError
        If there is none, it is of another kind, or it is empty.
    """
    with guarded(source := _named(path), "file"):
        about = os.stat(path)
        if stat.S_ISDIR(about.st_mode):
            raise FileError("is a directory; give a signal file", source=source)
        if not stat.S_ISREG(about.st_mode):
            raise FileError("is not a regular file", source=source)
        if about.st_size == 0:
            raise FileError("is empty; it should hold a signal", source=source)
    return about.st_size


def check_size(size: int, source: str, what: str = "file") -> None:
    """Refuse what is too large to be held whole.

    Raises
    ------
    FileError
        If it is.
    """
    if size > LARGEST_WHOLE:
        raise FileError(
            f"this kind of {what} is read whole, up to {LARGEST_WHOLE // 2**20} MB; "
            "store it as WAV, .npy, HDF5 or Parquet, which are read in blocks",
            field="size in bytes",
            value=size,
            source=source,
        )


def opened(path: Path) -> BinaryIO:
    """Open a file for reading.

    Raises
    ------
    FileError
        If it cannot be.
    """
    with guarded(str(path), "file"):
        return path.open("rb")


def exactly(file: BinaryIO, count: int, source: str) -> bytes:
    """Read so many bytes and no fewer.

    Raises
    ------
    FileError
        If the file ends before.
    """
    content = file.read(count)
    if len(content) < count:
        raise FileError("ends in the middle of what it says it holds", source=source)
    return content


@contextmanager
def guarded(source: str, kind: str) -> Iterator[None]:
    """Turn whatever goes wrong over a file's contents into a `FileError` that names the file.

    Numbers that are none are not warned of here: signals refuse them.
    """
    try:
        with np.errstate(all="ignore"):
            yield
    except InputError as error:
        raise error if error.source else error.with_details(source=source) from None
    except OSError as error:
        reason = _in_short(error.strerror or str(error))
        raise FileError(f"cannot be read: {reason}", source=source) from None
    except MemoryError:
        raise FileError("asks for more memory than there is", source=source) from None
    except Exception as error:  # what a format's library raises is not for us to list
        reason = _in_short(str(error) or type(error).__name__)
        raise FileError(f"is not a readable {kind}: {reason}", source=source) from None


def _in_short(reason: str) -> str:
    """First line of a library's complaint, printable and of bounded length."""
    line = reason.strip().partition("\n")[0][:120]
    return shown(line)[1:-1].removesuffix(".").lower() if line else "no reason is given"


def _named(path: str | os.PathLike[str]) -> str:
    return path if isinstance(path, str) else str(path)
