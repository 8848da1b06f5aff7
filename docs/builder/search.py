"""Search that finds a standard by its number: "281", "ISO/TS 16281", "20816-3".

Sphinx leaves numbers out of its index, and its page passes over numbers in what is asked. The
language of the search here says what a word is, to the index in Python and to the page in
JavaScript: a number is one, with a letter before it. A designation with a part, 20816-3, is found
by the number of the standard and by the whole. A page is found by its terms' Portuguese words too.

Sphinx does not know how often a page has a word, and lists pages that have it by their titles.
`weigh` adds to its index how much a page is about each of its words, which `scorer.js` reads.
"""

from __future__ import annotations

import json
import re
from collections import Counter
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
    "weigh",
    "words_of",
    "write_index",
]

NUMBER: Final = "n"
"""Stands before a number: with it Sphinx takes the number for a word."""

_WORD: Final = re.compile(r"\w+")
_ABOUT: Final = 20
"""Times that a page counts as having a word which it is said to be about."""
_INDEX: Final = "searchindex.js"
_BEFORE: Final = "Search.setIndex("
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
) -> Counter[str]:
    """Return words of the other language by which a page is found too, and how often it has them.

    Parameters
    ----------
    docname, text
        The page and what stands on it.
    terms
        Of the glossary, English and Portuguese: a page with the one is found by the other.
    portuguese
        What else a reader may type, by page: it is about that.
    """
    lowered = f" {' '.join(text.lower().split())} "
    found: Counter[str] = Counter()
    for term, other in terms:
        if times := lowered.count(f" {term.lower()}"):
            found.update(dict.fromkeys(map(str.lower, words_of(other)), times))
    for word in words_of(portuguese.get(docname, "").lower()):
        found[word] += _ABOUT
    return found


def weigh(index: Mapping[str, Any], pages: Mapping[str, Counter[str]]) -> dict[str, Any]:
    """Return an index with ``weights``: by word a digit for each page that has it.

    It grows with how often the page has the word among how many others, to a bound (BM25: Robertson
    and Zaragoza, The Probabilistic Relevance Framework, 2009, with its usual constants).

    Parameters
    ----------
    index
        As Sphinx makes it.
    pages
        How often each page has its words, by its name.
    """
    stem = snowballstemmer.stemmer("english").stemWord  # as Sphinx does
    counts: dict[str, Counter[str]] = {}
    for docname, words in pages.items():
        counts[docname] = Counter()
        for word, times in words.items():
            counts[docname][stem(word)] += times
    sizes = {docname: own.total() for docname, own in counts.items()}
    usual = sum(sizes.values()) / max(len(sizes), 1)
    names = index["docnames"]

    def digit(word: str, place: int) -> str:
        times = counts[names[place]][word]
        room = 1.2 * (0.25 + 0.75 * sizes[names[place]] / usual)
        return str(round(9 * times / (times + room)))

    weights = {
        word: "".join(digit(word, place) for place in _places(index, word))
        for word in {**index["terms"], **index["titleterms"]}
    }
    return {**index, "weights": weights}


def _places(index: Mapping[str, Any], word: str) -> list[int]:
    """Pages that have a word: in their text, then in a heading, which Sphinx keeps apart."""
    found = (index[table].get(word, []) for table in ("terms", "titleterms"))
    return [place for one in found for place in (one if isinstance(one, list) else [one])]


def index_of(site: Path) -> dict[str, Any]:
    """Return the index of a built site, as its page reads it."""
    text = (site / _INDEX).read_text("utf-8")
    found: dict[str, Any] = json.loads(text.removeprefix(_BEFORE).rstrip().rstrip(")"))
    return found


def write_index(site: Path, index: Mapping[str, Any]) -> None:
    """Write the index of a site, as `index_of` reads it."""
    text = json.dumps(index, ensure_ascii=False, separators=(",", ":"))
    (site / _INDEX).write_text(f"{_BEFORE}{text})", "utf-8")


def asked(index: Mapping[str, Any], question: str) -> set[str]:
    """Return the pages that have every word of a question, as those of the page's search."""
    stem = snowballstemmer.stemmer("english").stemWord  # as Sphinx does
    found: set[str] | None = None
    for word in map(stem, map(str.lower, words_of(question))):
        pages = {index["docnames"][place] for place in _places(index, word)}
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
