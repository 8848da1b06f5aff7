"""Figures to files: the same picture gives the same bytes, today and tomorrow."""

from __future__ import annotations

import os
from typing import Final

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from rolamento.charts.frame import figure_of
from rolamento.charts.style import in_style
from rolamento.document.picture import picture_bytes
from rolamento.errors import FileError
from rolamento.io.writing import write_bytes
from rolamento.words import said

__all__ = ["FORMATS", "check_name", "save_figure"]

FORMATS: Final = ("png", "svg", "pdf")


@in_style
def save_figure(figure: Figure | Axes, path: str | os.PathLike[str]) -> None:
    """Write a figure, or the figure of axes, as PNG, SVG or PDF.

    Parameters
    ----------
    figure
        What to write.
    path
        A name that ends in ``.png``, ``.svg`` or ``.pdf``.

    Raises
    ------
    FileError
        If the name ends otherwise or the file cannot be written.
    """
    kind = check_name(path)
    drawn = figure if isinstance(figure, Figure) else figure_of(figure)
    write_bytes(picture_bytes(drawn, kind), path)


def check_name(path: str | os.PathLike[str]) -> str:
    """Return the format that a file's name ends in.

    Raises
    ------
    FileError
        If it is none of `FORMATS`.
    """
    kind = os.path.splitext(os.fspath(path))[1].lower().removeprefix(".")
    if kind not in FORMATS:
        raise FileError(
            said("must end in .png, .svg or .pdf"), source=os.fspath(path), example="rosette.pdf"
        )
    return kind
