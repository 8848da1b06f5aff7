"""What a built site has to be: found by its search, and asking nothing of any network."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path
from typing import Final

from builder import search

__all__ = ["wrong_in"]

_LOADED: Final = {
    ("script", "src"), ("img", "src"), ("link", "href"), ("iframe", "src"), ("source", "src"),
    ("video", "src"), ("object", "data"), ("embed", "src"), ("image", "href"), ("use", "href"),
}  # fmt: skip
_OF_LINKS: Final = {"stylesheet", "icon", "preload", "modulepreload", "prefetch", "preconnect"}
_ADDRESS: Final = re.compile(r"(?:https?:)?//[\w.-]+\.\w")
_IN_STYLES: Final = re.compile(r"(?:url\(\s*['\"]?|@import\s+['\"])((?:https?:)?//[^)'\"]+)")


class _Page(HTMLParser):
    """What a page loads from elsewhere, and its anchors."""

    def __init__(self) -> None:
        super().__init__()
        self.loaded: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Look at one element."""
        given = dict(attrs)
        kinds = set((given.get("rel") or "").split())
        if tag == "link" and not kinds & _OF_LINKS:
            return
        for name, value in attrs:
            if (tag, name) in _LOADED and value and _ADDRESS.match(value):
                self.loaded.append(value)


def wrong_in(site: Path) -> list[str]:
    """Return what is wrong in a built site, a sentence each."""
    wrong = search.missing(search.index_of(site))
    for path in sorted(site.rglob("*.html")):
        page = _Page()
        page.feed(path.read_text("utf-8"))
        wrong += [f"{path.relative_to(site)} loads {address}" for address in page.loaded]
    for path in sorted(site.rglob("*.css")):
        found = _IN_STYLES.findall(path.read_text("utf-8"))
        wrong += [f"{path.relative_to(site)} loads {address}" for address in found]
    return wrong
