"""Files that are written whole or not at all.

What is written goes to a file of another name in the same folder, which then takes the place of
the old one: whoever reads sees the old file or the new one, whatever ends the program in between.
Devices and pipes have no place to take, and are written to as they are.
"""

from __future__ import annotations

import os
import shutil
import stat
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, Final

from rolamento.errors import FileError, cause
from rolamento.io.text import format_of_path, text_of_mapping
from rolamento.words import said

__all__ = [
    "UNFINISHED",
    "check_space",
    "write_bytes",
    "write_mapping",
    "write_text",
    "written_whole",
]

UNFINISHED: Final = r"\.rolamento-[0-9a-f]{16}\.unfinished"
"""Names of files that are not whole yet, as a regular expression."""


@contextmanager
def written_whole(
    path: str | os.PathLike[str], *, new: bool = False, through_links: bool = True
) -> Iterator[Path]:
    """Give a place to write to, and put what was written in the place of a file.

    Parameters
    ----------
    path
        Of the file.
    new
        Refuse a file that is there already.
    through_links
        Write to the file that a symbolic link leads to; otherwise in the place of the link.

    Raises
    ------
    FileError
        If it cannot be written; the old file is as it was. What the body raises, if it is no
        `OSError`, goes on.
    """
    source = os.fspath(path)
    unfinished: Path | None = None
    try:
        if not source:
            raise FileNotFoundError(None, "no name is given")
        target = Path(os.path.realpath(source) if through_links else source)
        if not _takes_a_place(target, new):
            yield target
            return
        import secrets  # which takes longer to load than most files to write

        unfinished = target.with_name(f".rolamento-{secrets.token_hex(8)}.unfinished")
        with open(unfinished, "xb"):
            pass
        if target.exists():
            shutil.copymode(target, unfinished)
        yield unfinished
        _put_in_place(unfinished, target, new)
    except FileExistsError:
        raise FileError(said("already exists; choose another name"), source=source) from None
    except FileError as error:
        raise error if error.source else error.with_details(source=source) from None
    except OSError as error:
        raise FileError(
            said("cannot be written: {reason}", reason=cause(error)), source=source
        ) from None
    except ValueError as error:
        if "null" not in str(error):
            raise
        raise FileError(said("is not a valid file name"), source=source) from None
    finally:
        if unfinished is not None:
            with suppress(OSError):
                unfinished.unlink()


def write_bytes(
    content: bytes, path: str | os.PathLike[str], *, new: bool = False, through_links: bool = True
) -> None:
    """Write a file whole.

    Raises
    ------
    FileError
        As `written_whole`.
    """
    with written_whole(path, new=new, through_links=through_links) as place:
        place.write_bytes(content)


def write_text(text: str, path: str | os.PathLike[str], *, new: bool = False) -> None:
    """Write a text as UTF-8, whole.

    Raises
    ------
    FileError
        As `written_whole`.
    """
    write_bytes(text.encode("utf-8"), path, new=new)


def write_mapping(
    mapping: Mapping[str, Any], path: str | os.PathLike[str], *, example: str
) -> None:
    """Write a mapping as TOML or JSON, as the file's name ends.

    Raises
    ------
    FileError
        If the name ends otherwise; or as `written_whole`.
    """
    text_format = format_of_path(path)
    if text_format is None:
        raise FileError(said("must end in .toml or .json"), source=os.fspath(path), example=example)
    write_text(text_of_mapping(mapping, text_format), path)


def check_space(needed: int, path: Path) -> None:
    """Refuse a file that is larger than what is free where it is to lie.

    Parameters
    ----------
    needed
        Bytes of the file.
    path
        Of the file, whose folder is there.

    Raises
    ------
    FileError
        If it is.
    """
    try:
        free = shutil.disk_usage(path.parent).free
    except OSError:  # a file system that does not say
        return
    if needed > free:
        raise FileError(
            said(
                "cannot be written: it needs {needed}, and {free} are free",
                needed=_megabytes(needed),
                free=_megabytes(free),
            ),
            source=str(path),
        )


def _takes_a_place(target: Path, new: bool) -> bool:
    """Whether there is a regular file, or none yet, that may be written."""
    try:
        mode = target.stat().st_mode
    except FileNotFoundError:
        return True
    if new:
        raise FileExistsError
    if stat.S_ISDIR(mode):
        raise FileError(said("is a directory; give a file"))
    if not stat.S_ISREG(mode):
        return False
    if not os.access(target, os.W_OK):  # renaming would not ask
        raise PermissionError(None, "permission denied")
    return True


def _put_in_place(unfinished: Path, target: Path, new: bool) -> None:
    if not new:
        os.replace(unfinished, target)
        return
    try:
        os.link(unfinished, target)  # unlike renaming, not over a file that has come meanwhile
    except FileExistsError:
        raise
    except OSError:  # a file system without links
        if target.exists():
            raise FileExistsError from None
        os.replace(unfinished, target)


def _megabytes(size: int) -> str:
    return said("{size:.4} MB", size=size / 1e6)
