"""A single case of a result as a tree of plain numbers, which a test of one case reads."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import fields, is_dataclass
from types import SimpleNamespace
from typing import Any

from rolamento.case import Case
from rolamento.solution import solve
from rolamento.solved import RingDisplacement, RingLoad, Solved
from rolamento.words import Note, speaking


def one(solved: Solved) -> SimpleNamespace:
    """The case of a result of one: as its JSON has it, None as NaN."""
    assert len(solved) == 1
    tree = _tree(solved.to_mapping())
    tree.displacement = RingDisplacement(*(axis[0] for axis in solved.displacement))
    tree.load = RingLoad(*(part[0] for part in solved.load))
    tree.stiffness = solved.stiffness.array[0]
    tree.status.advice = solved.advice[0]
    tree.notes = solved.notes[0]
    tree.preload, tree.case = solved.preload, solved.case
    tree.title, tree.solved = solved.title, solved
    tree.to_mapping, tree.to_json = solved.to_mapping, solved.to_json
    if solved.rolling is None:
        tree.rolling = None
    for row in tree.rows:
        row.load = RingLoad(*vars(row.load).values())
    return tree


def _tree(value: Any) -> Any:
    if is_dataclass(value) and not isinstance(value, type):
        value = {field.name: getattr(value, field.name) for field in fields(value)}
    if isinstance(value, dict):
        return SimpleNamespace(**{key: _tree(item) for key, item in value.items()})
    if isinstance(value, list | tuple):
        return tuple(_tree(item) for item in value)
    return float("nan") if value is None else value


def solve_one(case: Case) -> SimpleNamespace:
    """Solve a single case."""
    return one(solve(case))


def keys(notes: Iterable[Note]) -> set[str]:
    """The keys of notes."""
    return {note.key for note in notes}


def said(note: Note | None, language: str = "en") -> str:
    """A note in a language; nothing for none."""
    with speaking(language):
        return "" if note is None else note.text
