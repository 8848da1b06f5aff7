"""Notes on a page: those that qualify a headline stand with it, the remarks at the end."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Final

from rolamento.document import Notes, Remark, Section
from rolamento.words import Note, said
from rolamento.words.headlines import parted, qualifies
from rolamento.words.naming import one_line

__all__ = ["about", "cautions", "cautions_section", "notes_section", "remarks_of"]

_LONGEST_NAME: Final = 32
_NAMED: Final = 3
"""Most signals that a note names."""


def cautions(notes: Iterable[Note]) -> tuple[Notes, ...]:
    """Return the notes that qualify a headline, as a block to stand below it; nothing without."""
    leading, _ = parted(notes)
    remarks = tuple(Remark(note.text, note.key, "warning") for note in leading)
    return (Notes(remarks),) if remarks else ()


def cautions_section(notes: Iterable[Note], level: int = 2) -> list[Section]:
    """Return the notes that qualify what the head of a page says; nothing without."""
    blocks = cautions(notes)
    return [Section(said("Caution"), blocks, "cautions", level)] * bool(blocks)


def remarks_of(notes: Iterable[Note]) -> tuple[Note, ...]:
    """Return the notes that stand with no headline."""
    return parted(notes)[1]


def notes_section(notes: Iterable[Note], level: int = 2) -> list[Section]:
    """Return what else the reader should know, each said once; nothing without notes."""
    remarks = {note.text: Remark(note.text, note.key) for note in notes}
    block = Notes(tuple(remarks.values()))
    return [Section(said("Notes"), (block,), "notes", level)] * bool(remarks)


def about(
    signals: Sequence[tuple[str, Iterable[Note]]], of_all: Iterable[Note] = ()
) -> tuple[tuple[Notes, ...], list[Section]]:
    """Return what qualifies the verdict on signals, to stand below it, and the section of remarks.

    Each note once; of several signals with those that it is about.

    signals: title and notes of each; of_all: notes on all of them.
    """
    titles: dict[Note, list[str]] = {note: [] for note in of_all}
    for title, notes in signals:
        for note in dict.fromkeys(notes):
            titles.setdefault(note, []).append(one_line(title, _LONGEST_NAME))
    leading, rest = [], []
    for note, named in titles.items():
        text = note.text
        if 0 < len(named) < len(signals):
            text = said("{note} ({signals})", note=text, signals=", ".join(named[:_NAMED]))
        if qualifies(note):
            leading.append(Remark(text, note.key, "warning"))
        else:
            rest.append(Remark(text, note.key))
    section = Section(said("Notes"), (Notes(tuple(rest)),), "notes")
    return (Notes(tuple(leading)),) * bool(leading), [section] * bool(rest)
