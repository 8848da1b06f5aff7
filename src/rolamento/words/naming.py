"""Names as they stand in sentences and tables: the parts of a bearing, lists, titles of others."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Final

from rolamento.words.speaking import marked, said

__all__ = [
    "PARTS",
    "either",
    "listed",
    "one_line",
    "part_name",
    "shortened",
    "the_part",
    "the_part_first",
]

PARTS: Final[Mapping[str, str]] = {
    "outer_race": marked("outer race"),
    "inner_race": marked("inner race"),
    "ball": marked("ball"),
    "cage": marked("cage"),
}
_THE_PARTS: Final[Mapping[str, str]] = {
    "outer_race": marked("the outer race"),
    "inner_race": marked("the inner race"),
    "ball": marked("a ball"),
    "cage": marked("the cage"),
    "ball_or_cage": marked("a ball or the cage"),
}
_FIRST: Final[Mapping[str, str]] = {
    "outer_race": marked("The outer race"),
    "inner_race": marked("The inner race"),
    "ball": marked("A ball"),
    "cage": marked("The cage"),
    "ball_or_cage": marked("A ball or the cage"),
}


def part_name(part: str) -> str:
    """Return the name of a part, as it stands in a table: "outer race"."""
    return said(PARTS[part])


def the_part(part: str) -> str:
    """Return the name of a part within a sentence: "the outer race", "a ball"."""
    return said(_THE_PARTS[part])


def the_part_first(part: str) -> str:
    """Return the name of a part at the beginning of a sentence: "The outer race"."""
    return said(_FIRST[part])


def listed(items: Iterable[str]) -> str:
    """Return names one after the other, the last two joined by "and"."""
    *rest, last = [*items] or [""]
    return said("{list} and {last}", list=", ".join(rest), last=last) if rest else last


def either(items: Iterable[str]) -> str:
    """Return names one after the other, the last two joined by "or"."""
    *rest, last = [*items] or [""]
    return said("{list} or {last}", list=", ".join(rest), last=last) if rest else last


def one_line(text: str, longest: int = 200) -> str:
    """Return a text of others as one line that can be printed, not too long."""
    plain = " ".join("".join(c if c.isprintable() else " " for c in text[:2000]).split())
    return shortened(plain, longest)


def shortened(text: str, longest: int = 20) -> str:
    """Return a text that fits into a cell."""
    return text if len(text) <= longest else text[: longest - 1] + "…"
