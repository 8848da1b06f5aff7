"""What theme and generator leave out for those who cannot see a page: levels, names, lists."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Final

__all__ = ["make_accessible"]

_NAMED: Final = {
    '<p class="caption" role="heading">': '<p class="caption" role="heading" aria-level="2">',
    '<aside class="sidebar-drawer">': '<aside class="sidebar-drawer" aria-label="Site">',
    '<aside class="toc-drawer': '<aside aria-label="Page" class="toc-drawer',
}
_SIGNATURE: Final = re.compile(r'<dl>\n((?:<dd><em class="sig-param">.*?</dd>\n)+)</dl>')
"""Parameters one below the other, which Sphinx writes as a list of definitions without terms."""


def make_accessible(folder: Path) -> None:
    """Mend all pages of a site."""
    for path in folder.rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        mended = _SIGNATURE.sub(_lines, text)
        for left, right in _NAMED.items():
            mended = mended.replace(left, right)
        if mended != text:
            path.write_text(mended, encoding="utf-8")


def _lines(found: re.Match[str]) -> str:
    lines = found[1].replace("<dd>", "<span>").replace("</dd>", "</span>")
    return f'<span class="parameters">\n{lines}</span>'
