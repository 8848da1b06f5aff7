"""Solved chunks on disk, so that nothing is lost when a run stops: the folder of parts."""

from __future__ import annotations

import json
import re
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path
from typing import Any, Final, TypeVar

import numpy as np

import rolamento
from rolamento.errors import FileError, cause, shown
from rolamento.io.json import dumps
from rolamento.io.writing import UNFINISHED, write_bytes, written_whole
from rolamento.numerics.locks import lock
from rolamento.studies.plan import REASON, Part, Plan
from rolamento.words import Note, said

__all__ = ["Store"]

T = TypeVar("T")

_FORMAT: Final = 3
_MANIFEST: Final = "manifest.json"
_LOCK: Final = "lock"
_REASONS: Final = "_reasons"
_CHUNKS: Final = "_chunks"
_OURS: Final = re.compile(rf"manifest\.json|part-\d{{7,10}}\.npz|result|{UNFINISHED}")
_LONGEST_MANIFEST: Final = 10_000
_OPEN_AT_ONCE: Final = 3
"""Files of parts in memory: neighbours lie in one, but for those that were overtaken."""


class Store:
    """Parts of a result, in a folder beside it.

    A manifest says what they are parts of. Each file holds some chunks, in the order in which
    they came, and is there whole or not at all.

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
        self._files: dict[int, int] = {}
        self._read: dict[int, dict[int, Part]] = {}

    @contextmanager
    def held(self) -> Iterator[None]:
        """Make the folder if there is none, and keep other runs out of it.

        Raises
        ------
        FileError
            If the folder cannot be made, or another run is at work in it.
        """
        if self.folder.exists() and not self.folder.is_dir():
            raise FileError(
                said(
                    "is where parts of the result are kept, and is not a folder; move it "
                    "away, or give the result another name"
                ),
                source=str(self.folder),
            )
        self._attempt(lambda: self.folder.mkdir(exist_ok=True))
        with self._attempt((self.folder / _LOCK).open, "wb") as file:
            if not lock(file):
                raise FileError(said("is in use by another run"), source=str(self.folder))
            yield

    def open(self, *, restart: bool = False) -> dict[int, Part]:
        """Find what is in the folder; return the statuses of the chunks at hand.

        Raises
        ------
        FileError
            If the folder cannot be used, or holds parts of something else.
        """
        self._refuse_foreign()
        if restart:
            self._clear()
        self._files, self._read = {}, {}
        if not any(path.name != _LOCK for path in self._contents()):
            write_bytes(json.dumps(self._manifest(), indent=2).encode(), self.folder / _MANIFEST)
            return {}
        if self._found_manifest() != self._manifest():
            raise FileError(
                said(
                    "contains parts of another study, or of another version of Rolamento; "
                    "`restart` discards them"
                ),
                source=str(self.folder),
            )
        return self._kept()

    def put(self, *parts: Part) -> None:
        """Write chunks to one file.

        Raises
        ------
        FileError
            If it cannot be written.
        """
        whole = Part.joined(parts)
        about = {
            _REASONS: np.array([dumps(note.to_mapping()) for note in whole.reasons], dtype=np.str_),
            _CHUNKS: np.array([part.index for part in parts], dtype=np.int64),
        }
        number = max(self._files.values(), default=-1) + 1
        with written_whole(self._path(number)) as place, place.open("wb") as file:
            np.savez(file, **about, **whole.arrays)  # type: ignore[arg-type]
        self._files.update((part.index, number) for part in parts)

    def get(self, index: int) -> Part:
        """Read a chunk.

        Raises
        ------
        FileError
            If it cannot be read, or is not what was written.
        """
        number = self._files[index]
        if number not in self._read:
            if len(self._read) >= _OPEN_AT_ONCE:
                del self._read[next(iter(self._read))]
            self._read[number] = self._chunks_of(number)
        chunks = self._read[number]
        if index not in chunks:
            raise self._damaged(self._path(number))
        return chunks[index]

    def _chunks_of(self, number: int, *, only: tuple[str, ...] = ()) -> dict[int, Part]:
        """Chunks of a file, or of each some of its arrays."""
        path = self._path(number)
        try:
            # Opened here: NumPy leaves a file that it cannot read open.
            with path.open("rb") as raw, np.load(raw, allow_pickle=False) as file:
                wanted = (*only, _REASONS, _CHUNKS) if only else file.files
                arrays = {name: file[name] for name in wanted}
            written = [json.loads(str(text)) for text in arrays.pop(_REASONS)]
            reasons = tuple(Note.from_mapping(mapping) for mapping in written)
            indices = [int(index) for index in arrays.pop(_CHUNKS)]
        except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
            raise self._damaged(path) from None
        if not all(0 <= index < self.plan.chunks for index in indices):
            raise self._damaged(path)
        ends = np.cumsum([self.plan.size(index) for index in indices])
        if not len(ends) or any(len(array) != ends[-1] for array in arrays.values()):
            raise self._damaged(path)
        pieces = {name: np.split(array, ends[:-1]) for name, array in arrays.items()}
        return {
            index: Part(index, {name: pieces[name][place] for name in pieces}, reasons)
            for place, index in enumerate(indices)
        }

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

    def _refuse_foreign(self) -> None:
        """Refuse a folder with files in it that are not ours, which nothing here will remove."""
        foreign = [p.name for p in self._contents() if p.name != _LOCK and not _is_ours(p)]
        if foreign:
            raise FileError(
                said(
                    "contains {foreign}, which Rolamento did not write and does not "
                    "remove; move it away, or give the result another name",
                    foreign=shown(foreign[0]),
                ),
                source=str(self.folder),
            )

    def _contents(self) -> list[Path]:
        return sorted(self._attempt(lambda: list(self.folder.iterdir())))

    def _kept(self) -> dict[int, Part]:
        """How the cases of whole files ended; the others will be solved again."""
        kept: dict[int, Part] = {}
        for path in self._contents():
            if not path.name.startswith("part-"):
                continue
            number = int(path.stem.removeprefix("part-"))
            try:
                found = self._chunks_of(number, only=("status", REASON))
            except FileError:
                self._attempt(path.unlink)
                continue
            kept.update(found)
            self._files.update(dict.fromkeys(found, number))
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

    def _path(self, number: int) -> Path:
        return self.folder / f"part-{number:07d}.npz"

    def _attempt(self, action: Callable[..., T], *arguments: Any, **options: Any) -> T:
        try:
            return action(*arguments, **options)
        except OSError as error:
            raise FileError(
                said("cannot be used: {reason}", reason=cause(error)), source=str(self.folder)
            ) from None

    def _damaged(self, path: Path) -> FileError:
        return FileError(said("is damaged; remove it and run the study again"), source=str(path))


def _is_ours(path: Path) -> bool:
    return bool(_OURS.fullmatch(path.name)) and not path.is_dir()
