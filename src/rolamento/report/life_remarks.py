"""Whether theories hold, and their notes, each said once with those that it is about."""

from __future__ import annotations

from collections.abc import Iterable

from rich.text import Text

from rolamento.life.record import OUTSIDE
from rolamento.report.life_numbers import said_of
from rolamento.report.page import Lines, Page

__all__ = ["remarks", "verdict"]


def remarks(page: Page, found: Iterable[tuple[str, str, str]], count: int) -> Lines:
    """List what refuses theories, then what they leave out.

    Parameters
    ----------
    page
        What is written on.
    found
        Theory, name of the note, and where it is true, if not everywhere.
    count
        How many theories there are.
    """
    said = said_of(page)
    about: dict[tuple[str, str], list[str]] = {}
    for theory, name, place in found:
        about.setdefault((name, place), []).append(theory)
    lines: Lines = []
    for name, place in sorted(about, key=lambda key: key[0] not in OUTSIDE):
        theories = about[name, place]
        every = len(theories) == count > 1
        named = said.every_theory if every else "; ".join(said.names[t] for t in theories)
        named += f", {place}" if place else ""
        if name in OUTSIDE:
            text = said.fails_for.format(theories=named, reason=said.notes[name])
            lines += page.hanging(page.text("  ✗ ", "yellow"), text, "yellow")
        else:
            lines += page.hanging(page.text("  • ", "yellow"), f"{named}: {said.notes[name]}")
    return lines


def verdict(page: Page, holds: bool, below: bool) -> Text:
    """Say in a word whether a theory holds, or gives an upper bound of the life."""
    said = said_of(page)
    if below:
        return page.text(said.bound, "green" if holds else "yellow")
    return page.text(said.holds, "green") if holds else page.text(said.fails, "yellow")
