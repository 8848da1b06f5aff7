"""The sentence of every note, by key: a chapter for what it is about.

A sentence is a template, or a function of the note's values that returns what is said.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from typing import Any, Final

from rolamento.words.speaking import said

__all__ = ["Sentence", "sentence", "sentences"]

Sentence = str | Callable[[Mapping[str, Any]], str]


_FIRST: Final = ("solved", "life")
"""Chapters that most pages need: where the note is in one of them no other is opened."""


@cache
def _chapters() -> tuple[str, ...]:
    known = [chapter.name for chapter in iter_modules(__path__)]
    return (*_FIRST, *(name for name in known if name not in _FIRST))


@cache
def _sentences_of(chapter: str) -> Mapping[str, Sentence]:
    return import_module(f"{__name__}.{chapter}").SENTENCES  # type: ignore[no-any-return]


def sentences() -> Mapping[str, Sentence]:
    """Return all sentences by the keys of their notes."""
    found: dict[str, Sentence] = {}
    for own in map(_sentences_of, _chapters()):
        assert not own.keys() & found.keys(), f"{own.keys() & found.keys()} have two sentences"
        found |= own
    return found


def sentence(key: str, values: Mapping[str, Any]) -> str:
    """Return the sentence of a note in the language that is spoken; the key where it has none."""
    own = map(_sentences_of, _chapters())
    template = next((sentences[key] for sentences in own if key in sentences), key)
    return said(template, **values) if isinstance(template, str) else template(values)
