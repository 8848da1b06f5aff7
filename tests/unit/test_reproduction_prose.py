"""The templates of the reproductions: the same keys and places in all languages, all used."""

from __future__ import annotations

import ast
import re
from pathlib import Path
from string import Formatter

import pytest
from tests.reproduced import both, english, portuguese

import rolamento_reproductions
from rolamento_reproductions.given import Given
from rolamento_reproductions.text import Prose, formula, listed, same, templates, written

PACKAGE = Path(rolamento_reproductions.__file__).parent
FOLDERS = ["", *sorted(place.parent.name for place in PACKAGE.glob("*/en"))]
LANGUAGES = sorted(place.name for place in PACKAGE.glob("??") if place.is_dir())


def places(template: str) -> set[str]:
    """Names and forms: a number is written alike in all languages."""
    return {
        f"{name}:{form}" for _, name, form, _ in Formatter().parse(template) if name is not None
    }


def constants(folder: str) -> tuple[set[str], set[str]]:
    """Return all texts of the code, and those that a template is called by."""
    every, called = set(), set()
    for path in (PACKAGE / folder).glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                every.add(node.value)
            elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.args:
                key = node.args[0]
                if node.func.id == "said" and isinstance(key, ast.Constant):
                    called.add(str(key.value))
    return every, called


def test_there_is_something_to_check() -> None:
    assert LANGUAGES == ["en", "pt"]
    assert len(FOLDERS) == 5


@pytest.mark.parametrize("folder", FOLDERS)
@pytest.mark.parametrize("language", LANGUAGES)
def test_languages_have_the_same_keys_and_places(folder: str, language: str) -> None:
    theirs, ours = templates(folder, "en"), templates(folder, language)
    assert set(theirs) == set(ours)
    for key, text in ours.items():
        assert text, key
        assert places(text) == places(theirs[key]), key
    files = {path.name for path in (PACKAGE / folder / "en").iterdir()}
    assert files == {path.name for path in (PACKAGE / folder / language).iterdir()}


@pytest.mark.parametrize("folder", FOLDERS)
def test_every_template_is_used_and_every_key_there(folder: str) -> None:
    known = set(templates(folder, "en"))
    every, called = constants(folder)
    if folder:
        every |= {f"source.{name}" for name in Given(folder).data}
    else:
        every |= {"sin", "tan"}
    begun = tuple(text for text in every if re.fullmatch(r"[a-z_]+\.", text))
    unused = {key for key in known - every if not (begun and key.startswith(begun))}
    assert unused == set()
    assert called <= known


def test_a_key_that_is_not_there() -> None:
    with pytest.raises(KeyError):
        Prose("")("no such key")


def test_numbers_in_two_manners() -> None:
    text = same("{:.1f} mm, {count}", -12345.67, count=3)
    assert english(text) == "−12 345.7 mm, 3"
    assert portuguese(text) == "−12 345,7 mm, 3"


def test_texts_within_texts_speak_the_same_language() -> None:
    text = same("<{inner}>", inner=both("a.b, c", "á.b, c"))
    assert english(text) == "<a.b, c>"
    assert portuguese(text) == "<á.b, c>"


def test_what_is_written_already() -> None:
    assert portuguese(written("-1.5")) == "−1,5"
    assert english(written("1.0217e6")) == "1.0217e6"
    assert english(formula("{x} = sin α")) == "{x} = sin α"


def test_lists() -> None:
    words = [written("57.8"), written("151.2"), written("189")]
    assert english(listed(words)) == "57.8, 151.2 and 189"
    assert portuguese(listed(words)) == "57,8; 151,2 e 189"
    assert english(listed(words[:1])) == "57.8"
    assert english(listed([])) == "none"
