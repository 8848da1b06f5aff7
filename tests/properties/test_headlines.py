"""A headline contains any note that could change it: of every shipped example, on every page."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

import rolamento
from rolamento import load_case
from rolamento.analysis import Analysis, analyse
from rolamento.document import Beside, Document, Notes, Section
from rolamento.pages.friction import friction_page
from rolamento.pages.life import life_page
from rolamento.pages.report import report_page
from rolamento.pages.state import state_page
from rolamento.tasks.report import calculation_report, with_life
from rolamento.words import Note
from rolamento.words.headlines import REMARKS, parted, qualifies
from rolamento.words.sentences import sentences

FOLDER = Path(rolamento.__file__).parent / "examples"
CASES = sorted(path.stem for path in FOLDER.glob("*.toml"))
HEADS = {"cautions", "film", "friction", "life", "summary"}
FEET = {"notes", "remarks"}


@cache
def analysed(name: str) -> Analysis:
    return analyse(with_life(load_case(FOLDER / f"{name}.toml")))


def sections_of(document: Document) -> Iterator[Section]:
    for one in document.sections:
        if isinstance(one, Beside):
            yield from (*one.left, *one.right)
        else:
            yield one


def keys_below(document: Document, headings: set[str]) -> set[str]:
    """The keys of the notes that stand in sections of some keys."""
    return {
        remark.key
        for section in sections_of(document)
        if section.key in headings
        for block in section.blocks
        if isinstance(block, Notes)
        for remark in block.remarks
    }


def qualifying(found: Analysis) -> set[str]:
    """The keys of all notes of a case that qualify what a page of it says first."""
    notes: list[Note] = [*found.solved.notes[0], *found.notes]
    if found.film is not None:
        notes += found.film.notes_of()
    if found.life is not None:
        notes += found.life.qualifications()
    return {note.key for note in notes if qualifies(note)}


def test_every_remark_has_a_sentence() -> None:
    assert set(sentences()) >= REMARKS


def test_a_new_note_qualifies() -> None:
    remark, known = Note(min(REMARKS)), Note("of_a_later_release")
    assert parted([remark, known, known]) == ((known,), (remark,))


@pytest.mark.parametrize("name", CASES)
def test_a_state_carries_what_qualifies_it(name: str) -> None:
    found = analysed(name)
    page = state_page(found.solved, found)
    assert qualifying(found) <= keys_below(page, HEADS)
    leading = set() if found.life is None else {n.key for n in found.life.qualifications()}
    at_the_foot = keys_below(page, FEET)
    assert not leading & at_the_foot
    assert not {n.key for n in found.solved.notes[0] if qualifies(n)} & at_the_foot
    # and nothing is lost
    shown = keys_below(page, HEADS | FEET)
    assert {note.key for note in (*found.solved.notes[0], *found.notes)} <= shown


@pytest.mark.parametrize("name", CASES)
def test_a_life_carries_what_qualifies_it(name: str) -> None:
    found = analysed(name)
    if found.life is None:
        return
    page = life_page(found.solved, found.life)
    notes = (*found.solved.notes[0], *found.life.qualifications())
    assert {note.key for note in notes if qualifies(note)} <= keys_below(page, HEADS)


@pytest.mark.parametrize("name", CASES)
def test_a_torque_carries_what_qualifies_it(name: str) -> None:
    found = analysed(name)
    if found.friction is None:
        return
    page = friction_page(found)
    nowhere = found.friction.without_model(found.solved)
    chosen = [one for one in found.friction.judged if one.model == found.friction.model]
    notes = nowhere or [note for one in chosen for note in one.notes_of()]
    keys = {note.key for note in (*notes, *found.solved.notes[0]) if qualifies(note)}
    assert keys <= keys_below(page, HEADS)


@pytest.mark.parametrize("name", CASES)
def test_a_summary_carries_what_qualifies_it(name: str) -> None:
    report = calculation_report([FOLDER / f"{name}.toml"])
    page = report_page(report)
    keys = qualifying(report.cases[0].analysis)
    assert keys <= keys_below(page, {"summary"})
    assert not keys & keys_below(page, {"remarks"})
    order = [section.key for section in sections_of(page) if section.level == 1]
    assert order[:2] == ["summary", "inputs"]
    if "remarks" in order:
        assert order.index("remarks") > order.index("results")
