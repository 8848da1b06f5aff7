"""Documents to files, by what the names of the files end in."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from itertools import count
from pathlib import Path
from typing import Final

from rolamento.document.medium import WIDEST, Medium
from rolamento.document.model import Document, Figure
from rolamento.errors import InputError
from rolamento.io.writing import write_bytes
from rolamento.words import said

__all__ = ["REPORTS", "check_ending", "write"]

REPORTS: Final = (".html", ".pdf", ".md", ".txt")
"""What the name of a report may end in."""


def write(document: Document, path: str | os.PathLike[str]) -> None:
    """Write a document to a file, whole or not at all.

    Parameters
    ----------
    document
        What to write.
    path
        A name that ends in ``.html``, ``.pdf``, ``.md`` or ``.txt``. The pictures of Markdown are
        written beside it.

    Raises
    ------
    InputError
        If the name ends otherwise.
    FileError
        If the file cannot be written.
    """
    ending = check_ending(path, REPORTS)
    write_bytes(_CONTENT[ending](document, Path(path)), path)


def check_ending(path: str | os.PathLike[str], allowed: tuple[str, ...]) -> str:
    """Return what a name ends in, in small letters.

    Raises
    ------
    InputError
        If it is nothing of what is allowed.
    """
    ending = os.path.splitext(os.fspath(path))[1].lower()
    if ending not in allowed:
        name = Path(path).stem or "file"
        raise InputError(
            said("must end in one of {endings}", endings=", ".join(filter(None, allowed))),
            source=os.fspath(path),
            example=f"{name}{allowed[0]}",
        )
    return ending


def _html(document: Document, path: Path) -> bytes:
    from rolamento.document.html import html

    return html(document).encode("utf-8")


def _pdf(document: Document, path: Path) -> bytes:
    from rolamento.document.pdf import pdf

    return pdf(document)


def _text(document: Document, path: Path) -> bytes:
    from rolamento.document.terminal import terminal

    return terminal(document, Medium(width=WIDEST)).encode("utf-8")


def _markdown(document: Document, path: Path) -> bytes:
    from rolamento.document.markdown import markdown
    from rolamento.document.picture import picture_bytes

    numbers = count(1)

    def picture(figure: Figure) -> str | None:
        if figure.draw is None:
            return None
        name = re.sub(r"\W+", "-", figure.key) or "figure"
        file = path.with_name(f"{path.stem}-{next(numbers)}-{name}.svg")
        write_bytes(picture_bytes(figure.draw(), "svg"), file)
        return file.name

    return markdown(document, picture=picture).encode("utf-8")


_CONTENT: Final[dict[str, Callable[[Document, Path], bytes]]] = {
    ".html": _html,
    ".pdf": _pdf,
    ".md": _markdown,
    ".txt": _text,
}
