"""A note: what the engine has to say, as a key and values; its sentence is made by the reader."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from types import MappingProxyType
from typing import Any

from rolamento.records import frozen
from rolamento.words.speaking import speaking

__all__ = ["Note"]


@frozen
class Note:
    """What the engine has to say about a result: a warning, a limit, advice.

    Parameters
    ----------
    key
        What it is, such as ``"ellipse_over_shoulder"``: stable, for programs.
    values
        The numbers and names of it, in SI.
    """

    key: str
    values: Mapping[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "values", MappingProxyType(dict(self.values)))

    @property
    def text(self) -> str:
        """The sentence in the current language (`rolamento.words.speaking`)."""
        from rolamento.words.sentences import sentence

        return sentence(self.key, self.values)

    def __str__(self) -> str:
        return self.text

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.key, dict(self.values))

    def __hash__(self) -> int:
        return hash((self.key, repr(sorted(self.values.items()))))

    def to_mapping(self) -> dict[str, Any]:
        """Return key, English text and values, as they stand in JSON."""
        with speaking("en"):
            return {"key": self.key, "text": self.text, "values": dict(self.values)}

    @classmethod
    def from_mapping(cls, given: Mapping[str, Any]) -> Note:
        """Return the note that was written as such a mapping.

        One that this release cannot say, or of hostile values, is kept as its text.
        """
        from rolamento.words.sentences import sentences

        note = cls(given["key"], given["values"])
        try:
            known = note.key in sentences() and bool(note.text)
        except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError):
            known = False
        return note if known else cls("text", {"text": given["text"]})
