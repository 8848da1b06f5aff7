"""Solved chunks on disk, so that nothing is lost when a run stops: the folder of parts."""

from __future__ import annotations

import json
import os
import re
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path
from typing import Any, Final, TypeVar

import numpy as np

import rolamento
from rolamento.errors import FileError
from rolamento.studies.plan import Part, Plan

try:
    import fcntl
except ImportError:  # not on Windows
    fcntl = None  # type: ignore[assignment]

__all__ = ["Store"]

T = TypeVar("T")

_FORMAT: Final = 1
_MANIFEST: Final = "manifest.json"
_LOCK: Final = "lock"
_MESSAGES: Final = "_messages"
_OURS: Final = re.compile(r"manifest\.json|part-\d{7,10}\.npz|result|[a-z0-9.-]+\.tmp")
_LONGEST_MANIFEST: Final = 10_000


class Store:
    """Parts of a result, in a folder beside it.

    A manifest says what they are parts of. Each part is written under another name and then
    renamed: it is there whole or not at all.

    Parameters
    ----------
    result
        The file that the parts will become.
    plan
        What they are parts of.
    """

    def __init__(self, result: Path, plan: Plan) -> None:
        self.plan = plan
        self.folder = result.with_name(f"{result.name}.parts")
        self.result = self.folder / "result"

    @contextmanager
    def held(self) -> Iterator[None]:
        """Make the folder if there is none, and keep other runs out of it.

        Raises
        ------
        FileError
            If the folder cannot be made, or another run is at work in it.
        """
        self._attempt(lambda: self.folder.mkdir(exist_ok=True))
        if fcntl is None:  # no such locks on this system: runs have to keep apart by themselves
            yield
            return
        with self._attempt((self.folder / _LOCK).open, "wb") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                raise FileError("is in use by another run", source=str(self.folder)) from None
            yield

    def open(self, *, restart: bool = False) -> dict[int, Part]:
        """Find what is in the folder; return the statuses of the parts at hand.

        Raises
        ------
        FileError
            If the folder cannot be used, or holds parts of something else.
        """
        if restart:
            self._clear()
        if not any(path.name != _LOCK for path in self._contents()):
            self._write(_MANIFEST, json.dumps(self._manifest(), indent=2).encode())
            return {}
        if self._found_manifest() != self._manifest():
            raise FileError(
                "holds parts of another study, or of another version of Rolamento;"
                " --restart throws them away",
                source=str(self.folder),
            )
        return self._kept()

    def put(self, part: Part) -> None:
        """Write a part.

        Raises
        ------
        FileError
            If it cannot be written.
        """
        messages = np.array(part.messages, dtype=np.str_)

        def write(path: Path) -> None:
            with path.open("wb") as file:
                np.savez(file, **{_MESSAGES: messages}, **part.arrays)  # type: ignore[arg-type]

        self._replace(self._name(part.index), write)

    def get(self, index: int, *, only: str | None = None) -> Part:
        """Read a part, or one of its arrays.

        Raises
        ------
        FileError
            If it cannot be read, or is not what was written.
        """
        path = self.folder / self._name(index)
        try:
            # Opened here: NumPy leaves a file that it cannot read open.
            with path.open("rb") as raw, np.load(raw, allow_pickle=False) as file:
                arrays = {
                    name: file[name] for name in (file.files if only is None else (only, _MESSAGES))
                }
        except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
            raise self._damaged(path) from None
        messages = tuple(str(text) for text in arrays.pop(_MESSAGES))
        part = Part(index, arrays, messages)
        if any(len(array) != self.plan.size(index) for array in arrays.values()):
            raise self._damaged(path)
        return part

    def remove(self) -> None:
        """Remove the folder, but nothing in it that is not ours.

        Raises
        ------
        FileError
            If it cannot be removed.
        """
        self._clear()
        self._attempt((self.folder / _LOCK).unlink, missing_ok=True)
        self._attempt(self.folder.rmdir)

    def _clear(self) -> None:
        for path in self._contents():
            if _OURS.fullmatch(path.name):
                self._attempt(path.unlink)

    def _contents(self) -> list[Path]:
        return sorted(self._attempt(lambda: list(self.folder.iterdir())))

    def _kept(self) -> dict[int, Part]:
        """Statuses of the parts that are whole; the others will be solved again."""
        kept = {}
        for index in range(self.plan.chunks):
            if not (self.folder / self._name(index)).is_file():
                continue
            try:
                kept[index] = self.get(index, only="status")
            except FileError:
                continue
        return kept

    def _manifest(self) -> dict[str, Any]:
        key = f"{rolamento.__version__}\n{self.plan.text}"
        return {
            "format": _FORMAT,
            "rolamento_version": rolamento.__version__,
            "study": sha256(key.encode()).hexdigest(),
            "cases": self.plan.cases,
            "cases_in_a_part": self.plan.chunk,
        }

    def _found_manifest(self) -> object:
        try:
            with (self.folder / _MANIFEST).open("rb") as file:
                return json.loads(file.read(_LONGEST_MANIFEST))
        except (OSError, ValueError, RecursionError):
            return None

    def _name(self, index: int) -> str:
        return f"part-{index:07d}.npz"

    def _write(self, name: str, content: bytes) -> None:
        def write(path: Path) -> None:
            path.write_bytes(content)

        self._replace(name, write)

    def _replace(self, name: str, write: Callable[[Path], None]) -> None:
        unfinished = self.folder / f"{name}.tmp"
        self._attempt(lambda: write(unfinished))
        self._attempt(lambda: os.replace(unfinished, self.folder / name))

    def _attempt(self, action: Callable[..., T], *arguments: Any, **options: Any) -> T:
        try:
            return action(*arguments, **options)
        except OSError as error:
            reason = (error.strerror or str(error)).lower()
            raise FileError(f"cannot be used: {reason}", source=str(self.folder)) from None

    def _damaged(self, path: Path) -> FileError:
        return FileError("is damaged; remove it and run the study again", source=str(path))
