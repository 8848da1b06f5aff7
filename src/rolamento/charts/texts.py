"""Numbers and short texts as figures show them, whatever draws them."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Final

from rolamento.words import manner, said
from rolamento.words.manner import Manner
from rolamento.words.naming import one_line
from rolamento.words.reasons import reason
from rolamento.words.theories import theory_name

_LONGEST_LABEL: Final = 90
_THIN_SPACE: Final = "\u2009"
_DIGITS: Final = 4
_POINT: Final = Manner(".")

_LONG_NUMBER: Final = re.compile(r"\d{5,}")
_INDEXED: Final = re.compile(r"(?<![A-Za-z0-9_])([A-Za-zα-ω])_([A-Za-z0-9]+)(?![^\W²³])")
_LONE_SYMBOL: Final = re.compile(r"(?<![$\w{}])([α-ωQ])(?![\w$}])")


def number(value: float, digits: int = _DIGITS) -> str:
    """Write one number in a legend."""
    return _written(value, digits, manner().mark)


def numbers() -> Callable[[float, object], str]:
    """Return what writes the numbers of ticks, whatever is spoken when they are drawn."""
    mark = manner().mark
    return lambda value, _: _written(value, _DIGITS, mark)


def capitalised(name: str) -> str:
    """Return a name as the label of an axis begins."""
    return name[:1].upper() + name[1:]


def no_result(code: str = "") -> str:
    """Say that there is no result, and why."""
    if not code:
        return said("No result")
    return said("No result: {reason}", reason=reason(code))


def no_result_count(count: int, total: int, why: str = "") -> str:
    """Say how many have no result, and why the first of them has none if that is known."""
    if why:
        return said(
            "no result: {count} of {total}; first: {why}", count=count, total=total, why=why
        )
    return said("no result: {count} of {total}", count=count, total=total)


def shown_text(text: str, longest: int = _LONGEST_LABEL) -> str:
    """Return a text of others as one line that can be printed, not too long."""
    return one_line(text, longest)


def mathematical(text: str) -> str:
    """Set symbols for Matplotlib: indices below, letters that stand for quantities slanted.

    >>> mathematical("load Q_0")
    'load $Q_{0}$'
    """
    indexed = _INDEXED.sub(
        lambda found: (
            f"${found[1]}_{{{found[2]}}}$"
            if len(found[2]) == 1
            else f"${found[1]}_{{\\mathrm{{{found[2]}}}}}$"
        ),
        text,
    )
    return _LONE_SYMBOL.sub(r"$\1$", indexed)


def theory_label(theory: str) -> str:
    """Name a theory of life, and whether it only gives an upper bound."""
    from rolamento.life.theories import THEORIES

    name = theory_name(theory)
    return said("{theory} (upper bound)", theory=name) if THEORIES[theory].bound else name


def _written(value: float, digits: int, mark: str) -> str:
    text = _POINT.formatted(value, f".{digits}g")
    if "e" in text and 1e-4 <= abs(value) < 1e7:
        text = _POINT.formatted(value, ".0f")
    return marked_number(text, mark)


def marked_number(text: str, mark: str) -> str:
    """Return a number with the decimal mark of a language, thousands apart."""
    whole, point, rest = text.partition(".")
    grouped = _LONG_NUMBER.sub(lambda found: f"{int(found[0]):,}", whole)
    return grouped.replace(",", _THIN_SPACE) + (mark if point else "") + rest
