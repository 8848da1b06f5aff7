"""What was kept back from the development, and how much of it holds.

A number that was at hand while a program was written may have shaped it. These were not: tables,
states of rival programs and recordings of machines, tried once the program was finished.
"""

from __future__ import annotations

from rolamento.io.data import toml_of
from rolamento.records import frozen
from rolamento.words import Note


@frozen
class HeldOut:
    """One kind of numbers that took no part in the development.

    Attributes
    ----------
    what
        Which numbers, as a note.
    of, hold
        How many were tried, and how many agree; None where only the difference is known.
    within
        Relative difference that counts as agreement, as text; "" for half a unit of the last
        printed digit, or for a verdict.
    """

    what: Note
    of: int | None = None
    hold: int | None = None
    within: str = ""


def held_out() -> tuple[HeldOut, ...]:
    """Return what was held out, in the order of the page."""
    tried = toml_of("held_out")["tried"]
    return tuple(HeldOut(**{**one, "what": Note(f"held_out_{one['what']}")}) for one in tried)
