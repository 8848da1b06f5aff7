"""Figures to files: the same picture gives the same bytes, today and tomorrow."""

from __future__ import annotations

import io
import os
import warnings
from typing import Any, Final

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from rolamento._writing import write_bytes
from rolamento.errors import FileError
from rolamento.plots.frame import figure_of
from rolamento.plots.style import in_style
from rolamento.words import said

__all__ = ["FORMATS", "check_name", "save_figure"]

FORMATS: Final = ("png", "svg", "pdf")
# Nothing that tells when or with which release a figure was drawn.
_METADATA: Final[dict[str, dict[str, Any]]] = {
    "png": {"Software": None},
    "svg": {"Date": None, "Creator": "Rolamento"},
    "pdf": {"CreationDate": None, "Creator": "Rolamento", "Producer": None},
}


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
    content = io.BytesIO()
    if drawn.canvas is None:
        FigureCanvasAgg(drawn)
    with warnings.catch_warnings():
        # A title may hold letters that the font lacks; a box stands for them.
        warnings.filterwarnings("ignore", "Glyph .* missing from font")
        drawn.savefig(content, format=kind, metadata=_METADATA[kind])
    write_bytes(content.getvalue(), path)


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
