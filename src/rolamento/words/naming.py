"""Names as they stand in sentences and tables: the parts of a bearing, lists, titles of others."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Final

from rolamento.words.note import Note
from rolamento.words.speaking import marked, said

__all__ = [
    "PARTS",
    "by_element",
    "either",
    "listed",
    "machine_title",
    "of_element",
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
    "roller": marked("roller"),
    "cage": marked("cage"),
}
_THE_PARTS: Final[Mapping[str, str]] = {
    "outer_race": marked("the outer race"),
    "inner_race": marked("the inner race"),
    "ball": marked("a ball"),
    "roller": marked("a roller"),
    "cage": marked("the cage"),
    "ball_or_cage": marked("a ball or the cage"),
    "roller_or_cage": marked("a roller or the cage"),
}
_FIRST: Final[Mapping[str, str]] = {
    "outer_race": marked("The outer race"),
    "inner_race": marked("The inner race"),
    "ball": marked("A ball"),
    "roller": marked("A roller"),
    "cage": marked("The cage"),
    "ball_or_cage": marked("A ball or the cage"),
    "roller_or_cage": marked("A roller or the cage"),
}


_OF_ROLLERS: Final[Mapping[str, str]] = {"ball": "roller", "ball_or_cage": "roller_or_cage"}


def part_name(part: str, element: str = "ball") -> str:
    """Return the name of a part, as it stands in a table: "outer race".

    element: what rolls in the bearing; its part "ball" is a roller where no balls do.
    """
    return said(PARTS[_own(part, element)])


def the_part(part: str, element: str = "ball") -> str:
    """Return the name of a part within a sentence: "the outer race", "a ball"; as `part_name`."""
    return said(_THE_PARTS[_own(part, element)])


def _own(part: str, element: str) -> str:
    return part if element == "ball" else _OF_ROLLERS.get(part, part)


def the_part_first(part: str) -> str:
    """Return the name of a part at the beginning of a sentence: "The outer race"."""
    return said(_FIRST[part])


def by_element(balls: str, rollers: str) -> Callable[[Mapping[str, Any]], str]:
    """Return the sentence of a note whose value `element` is "roller" where rollers roll."""

    def sentence(values: Mapping[str, Any]) -> str:
        return said(rollers if values.get("element") == "roller" else balls, **values)

    return sentence


def of_element(note: Note, element: str) -> Note:
    """Return a note as it is said where so rolls, "ball" or "roller": its parts, and `element`."""
    if element == "ball":
        return note
    return Note(note.key, {**_of_rollers(dict(note.values)), "element": element})


def _of_rollers(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {name: _of_rollers(one) for name, one in value.items()}
    if isinstance(value, list | tuple):
        return [_of_rollers(one) for one in value]
    return _OF_ROLLERS.get(value, value) if isinstance(value, str) else value


def listed(items: Iterable[str]) -> str:
    """Return names one after the other, the last two joined by "and"."""
    *rest, last = [*items] or [""]
    return said("{list} and {last}", list=", ".join(rest), last=last) if rest else last


def either(items: Iterable[str]) -> str:
    """Return names one after the other, the last two joined by "or"."""
    *rest, last = [*items] or [""]
    return said("{list} or {last}", list=", ".join(rest), last=last) if rest else last


def machine_title(title: str) -> str:
    """Return the title of a machine, or what one without is called."""
    return title or said("Machine without a title")


def one_line(text: str, longest: int = 200) -> str:
    """Return a text of others as one line that can be printed, not too long."""
    plain = " ".join("".join(c if c.isprintable() else " " for c in text[:2000]).split())
    return shortened(plain, longest)


def shortened(text: str, longest: int = 20) -> str:
    """Return a text that fits into a cell."""
    return text if len(text) <= longest else text[: longest - 1] + "…"
