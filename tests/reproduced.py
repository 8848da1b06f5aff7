"""What tests of the reproductions have in common."""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import entry_points
from typing import TypeVar

from rolamento.cli.reproduce import GROUP
from rolamento.document import Figure
from rolamento.words import language, speaking
from rolamento_reproductions.record import Source
from rolamento_reproductions.text import Text

Made = TypeVar("Made")


def find(name: str) -> Source:
    """Return a source, found as the command finds it."""
    source = entry_points(group=GROUP)[name].load()
    assert isinstance(source, Source)
    return source


def spoken(code: str, make: Callable[[], Made]) -> Made:
    """Make something in a language."""
    with speaking(code):
        return make()


def beside(figure: Figure) -> str:
    """Return the name of a picture's file."""
    return f"{figure.key}.svg"


def both(en: str, pt: str) -> Text:
    """Return a text of two languages, without templates."""
    return Text(lambda: pt if language() == "pt" else en)


def english(text: Text) -> str:
    return text.speak("en")


def portuguese(text: Text) -> str:
    return text.speak("pt")
