"""A reproduction to a folder: pages, pictures and data, over nothing that is not ours.

Only files of known names. The data are comma-separated values, the same in every language: RFC
4180, units in the header, a decimal point, an empty field for a number that does not exist.
"""

from __future__ import annotations

import csv
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from io import StringIO
from math import isfinite
from pathlib import Path
from typing import Final

from rolamento.document import Document
from rolamento.document import Figure as Picture
from rolamento.document.html import html, style
from rolamento.document.markdown import markdown
from rolamento.errors import FileError
from rolamento.io.writing import write_bytes
from rolamento_reproductions.page import (
    PageEnding,
    index_page,
    kind_of,
    misprints_page,
    said,
    summary,
)
from rolamento_reproductions.record import (
    ERRATA_STEM,
    Cell,
    Ending,
    Errata,
    Figure,
    Pictures,
    Progress,
    Section,
    Source,
    Table,
    TableColumn,
    power_above,
)
from rolamento_reproductions.text import ENGLISH, Text


def figure_csv(figure: Figure) -> str:
    """Return a figure's columns, one row a line."""
    header = [column.header for column in figure.columns]
    columns = [[_eight_digits(value) for value in column.values] for column in figure.columns]
    return _csv_text(header, zip(*columns, strict=True))


def table_csv(table: Table) -> str:
    """Return a table; a column of printed numbers becomes three: printed, computed, agreement."""
    header: list[str] = []
    columns: list[list[str]] = []
    for column in table.columns:
        names, values = _csv_columns(column)
        header += names
        columns += values
    return _csv_text(header, zip(*columns, strict=True))


def errata_csv(errata: Errata) -> str:
    """Return misprints and valid equations with their residuals.

    What is left by rounding alone is given as the power of ten above it, the same everywhere.
    """
    names = ("median", "greatest", "corrected_below")
    header = ["place", "printed", "corrected", *(f"residual_{name}" for name in names)]
    rows = [
        [
            one.place.speak(ENGLISH),
            one.printed.speak(ENGLISH),
            one.corrected.speak(ENGLISH),
            f"{one.printed_residual.median:.1e}",
            f"{one.printed_residual.maximum:.1e}",
            f"{power_above(one.corrected_residual.maximum):.0e}",
        ]
        for one in errata.misprints
    ]
    rows += [
        [
            f"Equation ({one.number})",
            one.form.speak(ENGLISH),
            "",
            "",
            "",
            f"{power_above(one.residual.maximum):.0e}",
        ]
        for one in errata.valid
    ]
    return _csv_text(header, rows)


def _csv_columns(column: TableColumn) -> tuple[list[str], list[list[str]]]:
    """Return the names and the values of what a table's column becomes."""
    cells = column.cells
    if any(isinstance(cell, Cell) for cell in cells):
        numbers = [cell for cell in cells if isinstance(cell, Cell)]
        names = [f"{column.name}_{what}" for what in ("printed", "computed", "agreement")]
        return names, [
            [cell.printed for cell in numbers],
            [_eight_digits(cell.computed) for cell in numbers],
            [cell.agreement for cell in numbers],
        ]
    return [column.name], [[c.speak(ENGLISH) if isinstance(c, Text) else str(c) for c in cells]]


def _csv_text(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    text = StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(header)
    writer.writerows(rows)
    return text.getvalue()


def _eight_digits(value: object) -> str:
    """Write eight significant digits: finer than any picture, and the same on every machine."""
    if isinstance(value, str):
        return value
    number = float(value)  # type: ignore[arg-type]
    return f"{number + 0.0:.8g}" if isfinite(number) else ""


PAGE: Final = "index.html"
STYLE: Final = "document.css"
_HEAD_OF_PAGE: Final = 10_000
_ENDINGS: Final[tuple[Ending, ...]] = ("svg", "png")


def reproduce(
    source: Source, folder: str | None, pictures: Pictures, progress: Progress
) -> list[str]:
    """Compute a source and write it, in the language that is spoken.

    Parameters
    ----------
    source
        What to reproduce.
    folder
        Where to write; by default a folder of the source's name.
    pictures
        Which formats to write.
    progress
        Called with every part and picture.

    Returns
    -------
    list of str
        What came out, in sentences, and the path of the page.

    Raises
    ------
    FileError
        If the folder cannot be taken, or a file not be written.
    """
    place = open_folder(source.name if folder is None else folder, source)
    sections = computed(source, progress)
    write(source, sections, place, pictures=pictures, progress=progress)
    return [*map(str, summary(sections)), str(place / PAGE)]


def computed(source: Source, progress: Progress) -> tuple[Section, ...]:
    """Compute all parts; progress counts a part and a picture alike."""
    sections = []
    for place, part in enumerate(source.parts):
        progress(place, _step_count(source), part.title)
        sections.append(part.compute(part.title))
    return tuple(sections)


def write(
    source: Source,
    sections: Sequence[Section],
    folder: Path,
    *,
    pictures: Pictures = "both",
    progress: Progress = lambda done, total, what: None,
) -> None:
    """Write the pages, the data and the pictures of a reproduction, in the language that is spoken.

    Parameters
    ----------
    source, sections
        From `computed`.
    folder
        From `open_folder`.
    pictures
        Which formats to write.
    progress
        Called with every picture.

    Raises
    ------
    FileError
        If a file cannot be written.
    """
    from rolamento_reproductions.drawing import rendered  # Matplotlib is slow to load

    endings = _ENDINGS if pictures == "both" else (pictures,)
    # The page first: by it the folder is known again, should the rest not be reached.
    _write_pages(folder, "index", partial(index_page, source, sections, endings), endings)
    _write_file(folder, STYLE, style().encode())
    done = len(source.parts)
    for item in _items(sections):
        _write_file(folder, f"{item.stem}.csv", _csv_of(item).encode())
        if isinstance(item, Errata):
            _write_pages(folder, item.stem, partial(misprints_page, source, item))
        if not isinstance(item, Figure):
            continue
        progress(done, _step_count(source), item.caption)
        contents = rendered(item, endings)
        for ending in _ENDINGS:
            name = f"{item.stem}.{ending}"
            if ending in contents:
                _write_file(folder, name, contents[ending])
            else:
                _remove(folder, name)
        done += 1
    progress(done, _step_count(source), source.title)


def open_folder(path: str, source: Source) -> Path:
    """Make a folder for a reproduction, or take one that may be written into.

    Raises
    ------
    FileError
        If the path is no folder and cannot become one, or if the folder holds files of our names
        that are not ours: it has no index page written by this command for this source.
    """
    if not path or "\0" in path:
        raise FileError(str(said("folder.impossible")), source=path, example=source.name)
    folder = Path(path)
    try:
        if folder.exists() and not folder.is_dir():
            raise FileError(str(said("folder.is_file")), source=path, example=source.name)
        folder.mkdir(parents=True, exist_ok=True)
        taken = [name for name in file_names(source) if os.path.lexists(folder / name)]
        ours = _is_ours(folder, source)
    except OSError as error:
        raise _refused(error, path) from None
    if taken and not ours:
        raise FileError(str(said("folder.taken", name=taken[0])), source=path, example=source.name)
    return folder


def file_names(source: Source) -> tuple[str, ...]:
    """Return all names that a reproduction may write."""
    names = [PAGE, "index.md", STYLE]
    for part in source.parts:
        names += [f"{stem}.csv" for stem in part.stems]
        names += [f"{stem}.{ending}" for stem in part.figures for ending in _ENDINGS]
        if ERRATA_STEM in part.stems:
            names += [f"{ERRATA_STEM}.html", f"{ERRATA_STEM}.md"]
    return tuple(names)


def _step_count(source: Source) -> int:
    return len(source.parts) + sum(len(part.figures) for part in source.parts)


def _items(sections: Sequence[Section]) -> Iterator[Figure | Table | Errata]:
    for section in sections:
        yield from section.items


def _csv_of(item: Figure | Table | Errata) -> str:
    if isinstance(item, Errata):
        return errata_csv(item)
    return figure_csv(item) if isinstance(item, Figure) else table_csv(item)


def _is_ours(folder: Path, source: Source) -> bool:
    """Return whether the folder's page was written by this command for this source."""
    page = folder / PAGE
    if not page.is_file():
        return False
    with page.open("rb") as file:
        return f'rolamento {kind_of(source)}"'.encode() in file.read(_HEAD_OF_PAGE)


def _write_pages(
    folder: Path, stem: str, page: Callable[[PageEnding], Document], endings: Sequence[Ending] = ()
) -> None:
    """Write a page as HTML and as Markdown, with its pictures beside it."""

    def picture(figure: Picture) -> str:
        return f"{figure.key}.{endings[0]}"

    linked = html(page("html"), picture=picture, stylesheet=STYLE)
    _write_file(folder, f"{stem}.html", linked.encode())
    _write_file(folder, f"{stem}.md", markdown(page("md"), picture=picture).encode())


def _write_file(folder: Path, name: str, content: bytes) -> None:
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
    return FileError(str(said("unwritten", reason=reason)), source=path)
