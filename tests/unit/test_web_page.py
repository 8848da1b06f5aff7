"""The files of the page: what they refer to exists, and nothing leaves the machine."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rolamento.web.page_words import WORDS, page_words
from rolamento.web.server import PAGE
from rolamento.words import speaking

_MOST_LINES = 4200
_FILES = sorted(path for path in PAGE.iterdir() if path.is_file())
_SCRIPTS = [path for path in _FILES if path.suffix == ".js"]
_OF_DROPS = {"drops.js", "drops.css"}
"""They have their words with what they are described by."""


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8")


def _html() -> str:
    return _text(PAGE / "index.html")


def test_the_whole_page_is_small() -> None:
    assert sum(len(_text(path).splitlines()) for path in _FILES) < _MOST_LINES


def test_every_word_of_the_page_is_known_and_used() -> None:
    asked = set(re.findall(r'data-(?:word|label)="([^"]+)"', _html()))
    text = "\n".join(_text(path) for path in _SCRIPTS if path.name not in _OF_DROPS)
    asked |= set(re.findall(r'\bsay\(\s*"([^"]+)"', text))
    chosen = set(re.findall(r'\bsay\([^()"]*\? "([^"]+)" : "([^"]+)"', text))
    asked |= {key for pair in chosen for key in pair}
    assert asked - set(WORDS) == set()
    assert {key for key in WORDS if f'"{key}"' not in text + _html()} == set()


@pytest.mark.parametrize("language", ["en", "pt"])
def test_words_keep_the_places_that_the_page_fills_in(language: str) -> None:
    with speaking(language):
        said = page_words()
    assert said.pop("decimal.mark") == {"en": ".", "pt": ","}[language]
    places = re.compile(r"\{\w+\}")
    for key, text in WORDS.items():
        assert set(places.findall(said[key])) == set(places.findall(text)), key


def test_every_element_that_a_script_asks_for_exists() -> None:
    known = set(re.findall(r'\bid="([^"]+)"', _html()))
    assert len(known) == len(re.findall(r'\bid="', _html()))
    main = "\n".join(_text(PAGE / name) for name in ("main.js", "opening.js", "machine.js"))
    asked = set(re.findall(r'(?:\$|getElementById)\("([^"]+)"\)', main))
    assert asked - known == set()
    labelled = re.findall(r'\b(?:for|aria-labelledby|aria-controls)="([^"]+)"', _html())
    described = re.findall(r'aria-describedby="([^"]+)"', _html())
    assert {name for text in labelled + described for name in text.split()} - known == set()


def test_the_page_has_no_text_of_its_own() -> None:
    body = _html().partition("<body")[2].partition(">")[2]
    texts = {text.strip() for text in re.findall(r">([^<]+)<", body)} - {""}
    assert texts <= {"Rolamento", "A", "B"}


@pytest.mark.parametrize("path", _FILES, ids=lambda path: path.name)
def test_nothing_is_inline_and_nothing_leaves_the_machine(path: Path) -> None:
    text = _text(path)
    if path.suffix == ".html":
        assert not re.search(r"<script(?![^>]*\bsrc=)|<style|\sstyle=|\son\w+=", text)
    addresses = re.findall(r"\bhttps?://[^\s\"'`)]+", text)
    assert set(addresses) <= {"http://www.w3.org/2000/svg"}
    assert not re.search(r"\beval\(|new Function\(|document\.write\(|@import", text)


def test_every_module_that_is_imported_exists_and_exports_what_is_asked() -> None:
    for path in _SCRIPTS:
        found = re.findall(r'import\s*\{([^}]*)\}\s*from\s*"\./([\w.]+)"', _text(path))
        for names, file in found:
            own = _text(PAGE / file)
            for name in filter(None, (name.strip() for name in names.split(","))):
                assert re.search(rf"export (async )?(function|class|const) {name}\b", own), (
                    f"{path.name}: {name} of {file}"
                )


def test_files_that_the_page_asks_for_exist() -> None:
    asked = re.findall(r'(?:href|src)="/static/([^"]+)"', _html())
    assert asked
    assert [name for name in asked if not (PAGE / name).is_file()] == []
