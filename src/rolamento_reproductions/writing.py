"""A reproduction to a folder: only files of known names, and over nothing that is not ours."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Final, Literal

from rolamento._writing import write_bytes
from rolamento.errors import FileError
from rolamento_reproductions.data_files import errata_csv, figure_csv, table_csv
from rolamento_reproductions.errata import ERRATA_STEM, Errata
from rolamento_reproductions.errata_page import errata_html, errata_markdown
from rolamento_reproductions.markdown import markdown_page
from rolamento_reproductions.page import generator_mark, html_page
from rolamento_reproductions.record import Ending, Figure, Section, Source, Table
from rolamento_reproductions.text import Language, Text

__all__ = ["PAGE", "Pictures", "Progress", "computed", "file_names", "open_folder", "write"]

PAGE: Final = "index.html"
_MARKDOWN: Final = "index.md"
_HEAD_OF_PAGE: Final = 10_000
_ENDINGS: Final[tuple[Ending, ...]] = ("svg", "png")

Pictures = Literal["svg", "png", "both"]
Progress = Callable[[int, int, Text], None]
"""Told how much is done, of how much, and what comes next."""


def computed(source: Source, progress: Progress) -> tuple[Section, ...]:
    """Compute all parts; progress counts a part and a picture alike."""
    sections = []
    for place, part in enumerate(source.parts):
        progress(place, _steps(source), part.title)
        sections.append(part.compute(part.title))
    return tuple(sections)


def write(
    source: Source,
    sections: Sequence[Section],
    folder: Path,
    *,
    language: Language = "en",
    pictures: Pictures = "both",
    progress: Progress = lambda done, total, what: None,
) -> None:
    """Write the index pages, the data and the pictures of a reproduction.

    Parameters
    ----------
    source, sections
        From `computed`.
    folder
        From `open_folder`.
    language
        Of the pages and the pictures; the data are the same in all.
    pictures
        Which formats to write.
    progress
        Told about every picture.

    Raises
    ------
    FileError
        If a file cannot be written.
    """
    from rolamento_reproductions.drawing import rendered  # Matplotlib is slow to load

    endings = _endings(pictures)
    # The page first: by it the folder is known again, should the rest not be reached.
    _put(folder, PAGE, html_page(source, sections, endings, language).encode())
    _put(folder, _MARKDOWN, markdown_page(source, sections, endings, language).encode())
    done = len(source.parts)
    for item in _items(sections):
        _put(folder, f"{item.stem}.csv", _data(item).encode())
        if isinstance(item, Errata):
            _put(folder, f"{item.stem}.html", errata_html(source, item, language).encode())
            _put(folder, f"{item.stem}.md", errata_markdown(source, item, language).encode())
        if not isinstance(item, Figure):
            continue
        progress(done, _steps(source), item.caption)
        contents = rendered(item, endings, language)
        for ending in _ENDINGS:
            name = f"{item.stem}.{ending}"
            if ending in contents:
                _put(folder, name, contents[ending])
            else:
                _remove(folder, name)
        done += 1
    progress(done, _steps(source), source.title)


def open_folder(path: str, source: Source) -> Path:
    """Make a folder for a reproduction, or take one that may be written into.

    Raises
    ------
    FileError
        If the path is no folder and cannot become one, or if the folder holds files of our names
        that are not ours: it has no index page written by this command for this source.
    """
    if not path or "\0" in path:
        raise FileError("is not a possible folder name", source=path, example=source.name)
    folder = Path(path)
    try:
        if folder.exists() and not folder.is_dir():
            raise FileError("is a file; give a folder", source=path, example=source.name)
        folder.mkdir(parents=True, exist_ok=True)
        taken = [name for name in file_names(source) if os.path.lexists(folder / name)]
        ours = _is_ours(folder, source)
    except OSError as error:
        raise _refused(error, path) from None
    if taken and not ours:
        raise FileError(
            f"holds a {taken[0]} that this command did not write; choose another folder",
            source=path,
            example=source.name,
        )
    return folder


def file_names(source: Source) -> tuple[str, ...]:
    """Return all names that a reproduction may write."""
    names = [PAGE, _MARKDOWN]
    for part in source.parts:
        names += [f"{stem}.csv" for stem in part.holds]
        names += [f"{stem}.{ending}" for stem in part.figures for ending in _ENDINGS]
        if ERRATA_STEM in part.holds:
            names += [f"{ERRATA_STEM}.html", f"{ERRATA_STEM}.md"]
    return tuple(names)


def _endings(pictures: Pictures) -> tuple[Ending, ...]:
    return _ENDINGS if pictures == "both" else (pictures,)


def _steps(source: Source) -> int:
    return len(source.parts) + sum(len(part.figures) for part in source.parts)


def _items(sections: Sequence[Section]) -> Iterator[Figure | Table | Errata]:
    for section in sections:
        yield from section.items


def _data(item: Figure | Table | Errata) -> str:
    if isinstance(item, Errata):
        return errata_csv(item)
    return figure_csv(item) if isinstance(item, Figure) else table_csv(item)


def _is_ours(folder: Path, source: Source) -> bool:
    """Tell whether the folder's page was written by this command for this source."""
    page = folder / PAGE
    if not page.is_file():
        return False
    with page.open("rb") as file:
        return generator_mark(source.name).encode() in file.read(_HEAD_OF_PAGE)


def _put(folder: Path, name: str, content: bytes) -> None:
    """Write a file whole or not at all; a link of that name is replaced, not followed."""
    write_bytes(content, folder / name, through_links=False)


def _remove(folder: Path, name: str) -> None:
    """Take away a picture of an earlier run that would not go with the data any more."""
    try:
        (folder / name).unlink(missing_ok=True)
    except OSError as error:
        raise _refused(error, str(folder / name)) from None


def _refused(error: OSError, path: str) -> FileError:
    reason = (error.strerror or str(error)).lower()
    return FileError(f"cannot be written: {reason}", source=path)
