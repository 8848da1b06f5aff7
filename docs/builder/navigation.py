"""The order of the pages: what an index page lists by its links is what stands below it."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Final

__all__ = ["pages_of", "with_pages"]

_SECTION: Final = re.compile(r"^## +(.+)$", re.MULTILINE)
_LINK: Final = re.compile(r"\]\(([^)#\s:]+\.md)(?:#[^)]*)?\)")


def pages_of(text: str) -> list[tuple[str, list[str]]]:
    """Return the sections of an index page and the pages that each links to, in their order.

    Returns
    -------
    list
        Of headings (empty before the first), each with relative paths; a page stands where it
        is linked to first.
    """
    pieces = _SECTION.split(text)
    sections = [("", pieces[0]), *zip(pieces[1::2], pieces[2::2], strict=True)]
    known: set[str] = set()
    found = []
    for heading, part in sections:
        links = [link for link in dict.fromkeys(_LINK.findall(part)) if link not in known]
        known.update(links)
        found.append((heading, links))
    return found


def with_pages(docname: str, text: str, docs: Path) -> str:
    """Return an index page with the trees of the pages that it lists; any other as it is."""
    folder, _, name = docname.rpartition("/")
    if name != "index":
        return text
    trees = []
    for heading, links in pages_of(text):
        own = [link for link in links if _is_below(link, folder, docs)]
        if own:
            caption = f":caption: {heading}\n" if heading and not folder else ""
            trees.append("\n```{toctree}\n:hidden:\n" + caption + "\n" + "\n".join(own) + "\n```\n")
    return text + "".join(trees)


def _is_below(link: str, folder: str, docs: Path) -> bool:
    """Whether a link leads to a page of this folder, or to the index of a folder in it."""
    path = Path(os.path.normpath(link))
    near = len(path.parts) == 1 or (len(path.parts) == 2 and path.name == "index.md")
    return near and ".." not in path.parts and (docs / folder / path).exists()
