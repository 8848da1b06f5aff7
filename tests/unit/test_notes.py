"""Notes: every key has a sentence in both languages, and comes back from JSON, hostile or old."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

import rolamento
from rolamento import Case, Solved, load_case, solve
from rolamento.words import Note, speaking
from rolamento.words.sentences import sentences

SOURCE = Path(rolamento.__file__).parent
ENGINE = ("solved/notes", "analysis", "clearance", "friction", "life", "lubrication")


def keys_of_the_engine() -> set[str]:
    """Keys that stand as ``Note("…"`` in the engine's modules."""
    files = [
        file
        for name in ENGINE
        for file in ([SOURCE / name] if name.endswith(".py") else (SOURCE / name).rglob("*.py"))
    ]
    return {key for f in files for key in re.findall(r'Note\(\s*"(\w+)"', f.read_text("utf-8"))}


def test_every_note_has_a_sentence() -> None:
    found = keys_of_the_engine()
    assert len(found) > 50
    assert found <= set(sentences())


@pytest.mark.parametrize("key", sorted(keys_of_the_engine()))
def test_sentences_without_values_are_translated(key: str) -> None:
    template = sentences()[key]
    if isinstance(template, str) and "{" not in template:
        with speaking("pt"):
            assert Note(key).text != template


def test_a_note_comes_back_from_json(examples: Path) -> None:
    solved = solve(load_case(examples / "209_radial.toml"))
    (note,) = solved.notes[0]
    assert note.key == "balls_unloaded"
    assert Solved.from_json(solved.to_json()).notes == solved.notes
    assert json.loads(solved.to_json())["notes"] == [note.to_mapping()]


def test_the_text_in_json_is_english(case_218: Case) -> None:
    lost = solve(rolamento.override(case_218, ["duty.load.fx=-20 kN"]))
    with speaking("pt"):
        advice = json.loads(lost.to_json())["status"]["advice"]
        assert str(lost.advice[0]).startswith("Nada sustenta o anel interno")
    assert advice["key"] == "unsupported_axially"
    assert advice["text"].startswith("Nothing supports the inner ring toward -x")


def test_notes_of_the_first_schema_are_kept_as_texts(examples: Path) -> None:
    mapping = json.loads(solve(load_case(examples / "209_radial.toml")).to_json())
    mapping |= {"schema": 1, "notes": ["Four balls carry nothing.", "{braces}"]}
    back = Solved.from_json(json.dumps(mapping))
    assert [note.text for note in back.notes[0]] == ["Four balls carry nothing.", "{braces}"]
    assert {note.key for note in back.notes[0]} == {"text"}
    assert Solved.from_json(back.to_json()).notes == back.notes


@pytest.mark.parametrize(
    ("key", "values"),
    [
        ("of_a_later_release", {}),
        ("balls_unloaded", {}),
        ("balls_unloaded", {"balls": 1, "azimuths": "x", "pressed_outward": []}),
        ("cage_skids", {"skid": "much"}),
    ],
)
def test_what_cannot_be_said_is_kept_as_its_text(key: str, values: dict[str, Any]) -> None:
    note = Note.from_mapping({"key": key, "text": "What it said.", "values": values})
    assert note == Note("text", {"text": "What it said."})
