"""The sentence of every note, by key: a chapter for what it is about.

A sentence is a template, or a function of the note's values that returns what is said.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from rolamento.words.speaking import said

__all__ = ["Sentence", "sentence", "sentences"]

Sentence = str | Callable[[Mapping[str, Any]], str]


@cache
def sentences() -> Mapping[str, Sentence]:
    """Return all sentences by the keys of their notes."""
    found: dict[str, Sentence] = {}
    for chapter in iter_modules(__path__):
        own = import_module(f"{__name__}.{chapter.name}").SENTENCES
        assert not own.keys() & found.keys(), f"{own.keys() & found.keys()} have two sentences"
        found |= own
    return found


def sentence(key: str, values: Mapping[str, Any]) -> str:
    """Return the sentence of a note in the language that is spoken; the key where it has none."""
    template = sentences().get(key, key)
    return said(template, **values) if isinstance(template, str) else template(values)
