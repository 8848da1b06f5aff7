"""Texts of others on a page: names and titles from files, as one line of bounded length."""

from __future__ import annotations

from typing import Final

__all__ = ["one_line", "shortened"]

_LONGEST: Final = 200


def one_line(text: str) -> str:
    """Return a text of others as one line that any medium can be given."""
    plain = " ".join("".join(c if c.isprintable() else " " for c in text[:2000]).split())
    return shortened(plain, _LONGEST)


def shortened(text: str, longest: int = 20) -> str:
    """Return a text that fits into a cell."""
    return text if len(text) <= longest else text[: longest - 1] + "…"
