"""Notes on a page: those that qualify a headline stand with it, the remarks at the end."""

from __future__ import annotations

from collections.abc import Iterable

from rolamento.document import Notes, Remark, Section
from rolamento.words import Note, said
from rolamento.words.headlines import parted

__all__ = ["cautions", "cautions_section", "notes_section", "remarks_of"]


def cautions(notes: Iterable[Note]) -> tuple[Notes, ...]:
    """Return the notes that qualify a headline, as a block to stand below it; nothing without."""
    leading, _ = parted(notes)
    remarks = tuple(Remark(note.text, note.key, "warning") for note in leading)
    return (Notes(remarks),) if remarks else ()


def cautions_section(notes: Iterable[Note], level: int = 2) -> list[Section]:
    """Return the notes that qualify what the head of a page says; nothing without."""
    blocks = cautions(notes)
    return [Section(said("Caution"), blocks, key="cautions", level=level)] * bool(blocks)


def remarks_of(notes: Iterable[Note]) -> tuple[Note, ...]:
    """Return the notes that stand with no headline."""
    return parted(notes)[1]


def notes_section(notes: Iterable[Note], level: int = 2) -> list[Section]:
    """Return what else the reader should know, each said once; nothing without notes."""
    remarks = {note.text: Remark(note.text, note.key) for note in notes}
    block = Notes(tuple(remarks.values()))
    return [Section(said("Notes"), (block,), key="notes", level=level)] * bool(remarks)
