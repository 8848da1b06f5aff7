"""The bearing in section as SVG; its classes take the colours of the page, of lead.css."""

from __future__ import annotations

from functools import lru_cache
from html import escape
from typing import TYPE_CHECKING, Final
from zlib import crc32

from rolamento.plots.bearing_section import SectionDrawing, section_drawing

if TYPE_CHECKING:
    from rolamento.case import Case
    from rolamento.solved import Solved

__all__ = ["section_svg"]

_MM: Final = 1e3
_HEAD: Final = 0.55
"""Length of an arrow's head, over the height of letters."""


def section_svg(case: Case, solved: Solved | None = None, *, mark: str = "hatch") -> str:
    """Return a bearing in section as SVG; what it shows is also said in its title.

    Parameters
    ----------
    case
        The case.
    solved
        Its result, if there is one.
    mark
        What begins its identifiers: unlike that of other drawings of the page.
    """
    return _svg(section_drawing(case, solved), mark)


def _svg(drawing: SectionDrawing, begins: str) -> str:
    left, bottom, wide, tall = (_MM * one for one in drawing.box)
    letter = _MM * drawing.letter
    paths = [_path(one.points) + ("Z" if one.closed else "") for one in drawing.outlines]
    mark = f"{begins}-{crc32(''.join(paths).encode()):x}"
    parts = [
        f'<svg class="section-drawing" viewBox="{left:.3f} {-bottom - tall:.3f} {wide:.3f} '
        f'{tall:.3f}" role="img" aria-label="{escape(drawing.said)}">',
        f"<title>{escape(drawing.remark)}</title>",
        f'<defs><pattern id="{mark}" patternUnits="userSpaceOnUse" '
        f'width="{0.5 * letter:.3f}" height="{0.5 * letter:.3f}" '
        'patternTransform="rotate(45)"><path class="hatching" '
        f'd="M0 0V{0.5 * letter:.3f}" stroke-width="{0.09 * letter:.3f}"/></pattern></defs>',
    ]
    for one, path in zip(drawing.outlines, paths, strict=True):
        fill = f' fill="url(#{mark})"' if one.kind == "housing" else ""
        parts.append(f'<path class="{one.kind}"{fill} d="{path}"/>')
    for arrow in drawing.arrows:
        parts.append(f'<path class="{arrow.kind} arrow" d="{_path(arrow.points)}"/>')
        parts.append(f'<path class="{arrow.kind} head" d="{_head(arrow.points, drawing.letter)}"/>')
    for label in drawing.labels:
        x, y = (_MM * one for one in label.at)
        parts.append(
            f'<text class="{label.kind}" x="{x:.3f}" y="{0.35 * letter - y:.3f}" '
            f'font-size="{letter:.3f}" text-anchor="{label.anchor}">{escape(label.text)}</text>'
        )
    parts.append("</svg>")
    return "".join(parts)


@lru_cache(maxsize=256)
def _path(points: tuple[tuple[float, float], ...]) -> str:
    return "M" + "L".join(f"{_MM * x:.3f} {-_MM * y:.3f}" for x, y in points)


def _head(points: tuple[tuple[float, float], ...], letter: float) -> str:
    """A triangle at the end of a line."""
    (x, y), (u, v) = points[-1], points[-2]
    size = ((x - u) ** 2 + (y - v) ** 2) ** 0.5 or 1.0
    along = ((x - u) / size * _HEAD * letter, (y - v) / size * _HEAD * letter)
    across = (-0.45 * along[1], 0.45 * along[0])
    corners = (
        (x + 0.2 * along[0], y + 0.2 * along[1]),
        (x - along[0] + across[0], y - along[1] + across[1]),
        (x - along[0] - across[0], y - along[1] - across[1]),
    )
    return _path(corners) + "Z"
