r"""Displayed mathematics as outlines, by the same setting as in a report: no script, no font.

A block is what a forge shows too: LaTeX, of several lines in `align` with a `\tag` each.
"""

from __future__ import annotations

import re
from functools import cache
from html import escape
from typing import Final

from rolamento.document.picture import formula

__all__ = ["anchor_of", "block", "inline", "numbers_of"]

_TAG: Final = re.compile(r"\\tag\{([^{}]+)\}")
_ENVIRONMENT: Final = re.compile(r"\\(?:begin|end)\{(?:align|aligned|gather)\*?\}")
_ROW: Final = re.compile(r"\\\\(?:\s|$)")
# What Matplotlib's mathematics calls otherwise.
_OTHERWISE: Final = (
    (re.compile(r"\\qquad\b"), r"\\quad\\quad "),
    (re.compile(r"\\([lg])e\b"), r"\\\1eq "),
    (re.compile(r"\\tfrac\b"), r"\\frac"),
    (re.compile(r"\\[lr]vert\b"), "|"),
    (re.compile(r"\\[lr]Vert\b"), r"\\|"),
    (re.compile(r"\\[Bb]igg?[lr]?(?=[^a-zA-Z])"), ""),
    # and the space before a function's name, which it leaves out
    (
        re.compile(r"(?<=[\w})\]])\s*(?=\\(?:sin|cos|tan|cot|ln|log|exp|arcsin)(?![a-zA-Z]))"),
        r"\\,",
    ),
)


def anchor_of(number: str) -> str:
    """Return the anchor of an equation by its number."""
    return f"equation-{number.strip().lower()}"


def numbers_of(text: str) -> list[str]:
    """Return the numbers of the equations in a page's source."""
    return [
        number
        for fence in re.findall(r"^ *```math\n(.*?)^ *```", text, re.DOTALL | re.MULTILINE)
        for number in _TAG.findall(fence)
    ]


def block(latex: str) -> str:
    """Return displayed mathematics as HTML: a table of lines, each number a link to its line.

    Raises
    ------
    ValueError
        If a line is not understood.
    """
    rows = [row for row in _ROW.split(_ENVIRONMENT.sub("", latex)) if row.strip()]
    cells = [_TAG.sub("", row).split("&") for row in rows]
    width = max(map(len, cells))
    return (
        '<div class="equations" tabindex="0"><table role="presentation">'
        + "".join(_row(row, own, width) for row, own in zip(rows, cells, strict=True))
        + "</table></div>"
    )


def _row(row: str, cells: list[str], width: int) -> str:
    tags = _TAG.findall(row)
    if len(tags) > 1:
        raise ValueError(f"two numbers in one line: {row.strip()}")
    shown = [f"<td>{inline(cell)}</td>" if cell.strip() else "<td></td>" for cell in cells]
    if len(cells) < width:  # the last one reaches over those that are not there
        shown[-1] = shown[-1].replace("<td>", f'<td colspan="{width - len(cells) + 1}">', 1)
    number = tags[0] if tags else ""
    anchor = anchor_of(number)
    mark = f' id="{anchor}"' if number else ""
    link = f'<a href="#{anchor}">({escape(number)})</a>' if number else ""
    return f'<tr{mark}>{"".join(shown)}<td class="number">{link}</td></tr>'


@cache
def inline(latex: str) -> str:
    """Return a formula as an SVG that stands on the line of the text.

    Raises
    ------
    ValueError
        If it is not understood.
    """
    asked = " ".join(latex.split())
    for pattern, other in _OTHERWISE:
        asked = pattern.sub(other, asked)
    found = formula(asked)
    if found is None:
        raise ValueError(f"a formula that is not understood: {latex.strip()}")
    name = escape(" ".join(latex.split()), quote=True)
    style = f"vertical-align:{-found.depth - 0.02:.3f}em"
    return found.svg(f' class="formula" role="img" aria-label="{name}" style="{style}"')
