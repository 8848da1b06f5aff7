"""Search that finds a standard by its number: "281", "ISO/TS 16281", "20816-3".

Sphinx leaves numbers out of its index, and its page passes over numbers in what is asked. The
language of the search here says what a word is, to the index in Python and to the page in
JavaScript: a number is one, with a letter before it. A designation with a part, 20816-3, is found
by the number of the standard and by the whole. A page is found by its terms' Portuguese words too.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Final

import snowballstemmer

__all__ = [
    "EXPECTED",
    "NUMBER",
    "SPLITTER",
    "asked",
    "index_of",
    "keywords",
    "missing",
    "words_of",
]

NUMBER: Final = "n"
"""Stands before a number: with it Sphinx takes the number for a word."""

_WORD: Final = re.compile(r"\w+")
_PART: Final = re.compile(r"\b(\d{2,})-(\d{1,4})\b")

SPLITTER: Final = r"""
var splitQuery = function (query) {
  const part = /\b(\d{2,})-(\d{1,4})\b/gu;
  const parts = [...query.matchAll(part)].map((found) => `n${found[1]}_${found[2]}`);
  const words = query.replace(part, (all, standard) => standard)
    .split(/[^\p{Letter}\p{Number}_]+/gu).filter((word) => word);
  return [...words.map((word) => (/^\d+$/.test(word) ? `n${word}` : word)), ...parts];
};
// A browser reads no other page of a site on a disk: without the extracts of what was found.
if (location.protocol === "file:") DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false;
document.addEventListener("DOMContentLoaded", () => {
  const summary = Search.makeSearchSummary;
  const shown = (word) => word.replace(/^n(?=\d)/, "").replace(/^(\d+)_(?=\d)/, "$1-");
  Search.makeSearchSummary = (text, words, ...more) =>
    summary(text, new Set([...words].map(shown)), ...more);
});
"""
"""`words_of` for the page, where Sphinx looks for it, and what the page shows of numbers."""

EXPECTED: Final[Mapping[str, Sequence[str]]] = {
    "281": ("theory/life", "life"),
    "ISO 281": ("theory/life", "life"),
    "ISO 76": ("theory/life", "theory/ratings"),
    "16281": ("theory/life", "life"),
    "ISO/TS 16281": ("theory/life", "theory/line-contact"),
    "20816-3": ("severity",),
    "ISO 20816-3": ("severity",),
    "4406": ("theory/life",),
    "15242-2": ("anderon",),
    "pista externa": ("diagnose", "frequencies"),
    "gravidade": ("severity",),
    "vida": ("life", "weibull"),
    "folga": ("clearance",),
    "ruído": ("anderon",),
}
"""What may be asked, and pages that have to be among what is found."""


def words_of(text: str) -> list[str]:
    """Return the words of a text or a question, numbers with their letter before them."""
    parts = [f"{NUMBER}{standard}_{part}" for standard, part in _PART.findall(text)]
    words = _WORD.findall(_PART.sub(r"\1", text))
    return [f"{NUMBER}{word}" if word.isdigit() else word for word in words] + parts


def keywords(
    docname: str, text: str, terms: Iterable[tuple[str, str]], portuguese: Mapping[str, str]
) -> list[str]:
    """Return words of the other language by which a page is found too.

    Parameters
    ----------
    docname, text
        The page and what stands on it.
    terms
        Of the glossary, English and Portuguese: a page with the one is found by the other.
    portuguese
        What else a reader may type, by page.
    """
    lowered = f" {' '.join(text.lower().split())} "
    found = [other for term, other in terms if f" {term.lower()}" in lowered]
    found += portuguese.get(docname, "").split(",")
    return sorted({word.lower() for one in found for word in words_of(one)})


def index_of(site: Path) -> dict[str, Any]:
    """Return the index of a built site, as its page reads it."""
    text = (site / "searchindex.js").read_text("utf-8")
    found: dict[str, Any] = json.loads(text.removeprefix("Search.setIndex(").rstrip().rstrip(")"))
    return found


def asked(index: Mapping[str, Any], question: str) -> set[str]:
    """Return the pages that have every word of a question, as those of the page's search."""
    stem = snowballstemmer.stemmer("english").stemWord  # as Sphinx does
    found: set[str] | None = None
    for word in map(stem, map(str.lower, words_of(question))):
        pages: set[str] = set()
        for table in (index["terms"], index["titleterms"]):
            places = table.get(word, [])
            places = places if isinstance(places, list) else [places]
            pages |= {index["docnames"][place] for place in places}
        found = pages if found is None else found & pages
    return found or set()


def missing(index: Mapping[str, Any]) -> list[str]:
    """Return what is asked for in `EXPECTED` and not found."""
    return [
        f'"{question}" does not find {page}'
        for question, pages in EXPECTED.items()
        for page in pages
        if page not in asked(index, question)
    ]
