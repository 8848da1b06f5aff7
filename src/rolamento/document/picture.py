"""Pictures and equations as bytes and paths: the same ones give the same bytes, always."""

from __future__ import annotations

import base64
import io
import re
import warnings
from typing import TYPE_CHECKING, Any, Final

from rolamento.records import frozen

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from rolamento.document.model import Figure as Shown

__all__ = [
    "Formula",
    "alternative_of",
    "conclusion_of",
    "formula",
    "picture_address",
    "picture_bytes",
]

# Nothing that tells when or with which release a figure was drawn.
_METADATA: Final[dict[str, dict[str, Any]]] = {
    "png": {"Software": None},
    "svg": {"Date": None, "Creator": "Rolamento"},
    "pdf": {"CreationDate": None, "Creator": "Rolamento", "Producer": None},
}
_SETTINGS: Final[Any] = {
    "savefig.dpi": 200.0,
    "pdf.fonttype": 42,
    "svg.hashsalt": "rolamento",
    "svg.fonttype": "path",
}
_IN_THE_DARK: Final = (
    "<style>@media (prefers-color-scheme: dark) {"
    "svg { filter: invert(.91) hue-rotate(180deg); }"
    'image, [id*="QuadMesh"], [id*="colour-map"] { filter: invert(1) hue-rotate(180deg); }'
    "}</style>"
)
"""As `page.css` says of pictures that stand in a page: a map of colours stays as it is."""
_NOT_XML: Final = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_CODES: Final = {1: "M", 2: "L", 3: "Q", 4: "C"}
_POINTS_OF_CODE: Final = {1: 1, 2: 1, 3: 2, 4: 3}
_CLOSE: Final = 79
_SIZE: Final = 100.0


def conclusion_of(shown: Shown, drawn: Figure | Axes | None) -> str:
    """Return what a picture says, in a line below its caption; empty if the caption says it.

    Parameters
    ----------
    shown
        The block of a page.
    drawn
        What it has drawn.
    """
    caption = shown.caption.casefold()
    said = dict.fromkeys(says.rstrip(".") for _, says in _charts(drawn))
    new = [one for one in said if one and one.casefold() not in caption]
    return " · ".join(one[:1].upper() + one[1:] for one in new)


def alternative_of(shown: Shown, drawn: Figure | Axes | None = None) -> str:
    """Return what a picture shows, for those who cannot see it; its parameters as above."""
    told = ". ".join(dict.fromkeys(". ".join(filter(None, one)) for one in _charts(drawn)))
    caption = shown.caption.rstrip(".")
    if shown.alternative or not told:
        return shown.alternative or shown.caption
    return told if caption in told else f"{caption}. {told}"


def _charts(drawn: Figure | Axes | None) -> list[tuple[str, str]]:
    """Return of each chart in a picture what it shows and what it says."""
    figure: Any = None if drawn is None else drawn.get_figure(root=True)
    labels = [] if figure is None else [str(axes.get_label()) for axes in figure.axes]
    parted = (label.partition("\n") for label in labels)
    return [(shows, says) for shows, end, says in parted if end and (shows or says)]


def picture_bytes(drawn: Figure | Axes, kind: str, *, transparent: bool = False) -> bytes:
    """Return a figure, or that of axes, as a file of kind ``"png"``, ``"svg"`` or ``"pdf"``."""
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    figure: Any = drawn.get_figure(root=True)
    content = io.BytesIO()
    if figure.canvas is None:
        FigureCanvasAgg(figure)
    with rc_context(_SETTINGS), warnings.catch_warnings():
        # A title may hold letters that the font lacks; a box stands for them.
        warnings.filterwarnings("ignore", "Glyph .* missing from font")
        if kind == "png" and not transparent:
            _draw_once(figure, content)
        else:
            figure.savefig(content, format=kind, metadata=_METADATA[kind], transparent=transparent)
    if kind != "svg":
        return content.getvalue()
    # Matplotlib says in comments which text it has drawn, whatever its characters
    return _NOT_XML.sub("?", content.getvalue().decode("utf-8", "replace")).encode()


def picture_address(drawn: Figure | Axes) -> str:
    """Return a picture as the address of an image that holds it, dark where its place is dark.

    No style of a page reaches into an image; it knows the colour scheme of its place by itself.
    """
    opening, start, rest = picture_bytes(drawn, "svg", transparent=True).partition(b"<defs>")
    own = opening + _IN_THE_DARK.encode() + start + rest
    return f"data:image/svg+xml;base64,{base64.b64encode(own).decode()}"


def _draw_once(figure: Figure, content: io.BytesIO) -> None:
    """Write a figure as PNG; `Figure.savefig` draws it twice, first for its layout alone."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    canvas, dpi = figure.canvas, figure.dpi
    try:
        figure.dpi = _SETTINGS["savefig.dpi"]
        drawn: Any = FigureCanvasAgg(figure)
        drawn.print_png(content, metadata=_METADATA["png"])
    finally:
        figure.dpi = dpi
        figure.set_canvas(canvas)


@frozen
class Formula:
    """A formula as the path of an SVG, sizes over that of its letters, y downward.

    Parameters
    ----------
    path
        Its outlines, in hundredths of the size of letters; the base line at y = 0.
    width, height, depth
        Its extent: to the right, above and below the base line.
    """

    path: str
    width: float
    height: float
    depth: float

    def svg(self, attributes: str = "") -> str:
        """Return it as an SVG element, as large as letters of 1 em."""
        left, top = -2.0, -_SIZE * self.height - 2.0
        width, height = _SIZE * self.width + 4.0, _SIZE * (self.height + self.depth) + 4.0
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width / _SIZE:.3f}em" '
            f'height="{height / _SIZE:.3f}em" viewBox="{left:.1f} {top:.1f} {width:.1f} '
            f'{height:.1f}"{attributes}><path d="{self.path}" fill="currentColor"/></svg>'
        )


def formula(latex: str) -> Formula | None:
    """Set a formula by Matplotlib's mathematics; None where it does not understand it."""
    import numpy as np
    from matplotlib import rc_context
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextToPath

    setter = TextToPath()
    text = f"${_displayed(latex)}$"
    with rc_context({"mathtext.fontset": "stix"}):
        font = FontProperties(size=setter.FONT_SCALE)
        try:
            vertices, codes = setter.get_text_path(font, text, ismath=True)
        except ValueError:
            return None
    if not len(vertices):
        return None
    vertices = np.asarray(vertices)
    scale = _SIZE / setter.FONT_SCALE
    pieces: list[str] = []
    place = 0
    while place < len(codes):
        code = int(codes[place])
        if code == _CLOSE:
            pieces.append("Z")
            place += 1
            continue
        count = _POINTS_OF_CODE[code]
        points = vertices[place : place + count]
        numbers = " ".join(f"{scale * x:.1f} {-scale * y:.1f}" for x, y in points)
        pieces.append(_CODES[code] + numbers)
        place += count
    right, highest = vertices.max(axis=0) / setter.FONT_SCALE
    lowest = vertices[:, 1].min() / setter.FONT_SCALE
    return Formula("".join(pieces), float(right), float(highest), float(-lowest))


def _displayed(latex: str) -> str:
    """Return a formula with its outermost fractions at full size, as in a line of their own."""
    depth, pieces = 0, []
    for piece in re.split(r"(\\frac\b|\\.|[{}])", latex):
        depth += (piece == "{") - (piece == "}")
        pieces.append("\\dfrac" if piece == "\\frac" and depth == 0 else piece)
    return "".join(pieces)
