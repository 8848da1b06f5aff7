"""What is said in English and in Portuguese, with numbers in the manner of each."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from string import Formatter
from typing import Any, Final, Literal

Language = Literal["en", "pt"]

_MINUS: Final = "−"
_THIN_SPACE: Final = "\N{NARROW NO-BREAK SPACE}"
_FOUR_DIGITS: Final = re.compile(r"(?<![\d,])(\d),(\d{3})(?!,)")
_SINE: Final = re.compile(r"\bsin\b")
_TANGENT: Final = re.compile(r"\btan\b")
_INDEXED: Final = re.compile(r"(?<![A-Za-z0-9_])([A-Za-zα-ω])_([A-Za-z0-9]+)(?![^\W²³])")


@dataclass(frozen=True, slots=True)
class Text:
    """The same said in both languages."""

    en: str
    pt: str

    def speak(self, language: Language) -> str:
        """Return what is said in one of the languages."""
        return self.pt if language == "pt" else self.en


def said(en: str, pt: str, *values: object, **named: object) -> Text:
    """Fill numbers into both templates (`str.format`); a `Text` speaks the template's language."""
    return Text(_Manner("en").vformat(en, values, named), _Manner("pt").vformat(pt, values, named))


def same(text: str, *values: object, **named: object) -> Text:
    """Return what is the same in both languages; a template if there is something to fill in."""
    return said(text, text, *values, **named) if values or named else Text(text, text)


def in_both(speak: Callable[[Language], str]) -> Text:
    """Return what is said in each of the languages."""
    return Text(speak("en"), speak("pt"))


def formula(text: str) -> Text:
    """Return a formula; the sine is "sen" and the tangent "tg" in Portuguese."""
    return Text(text, _TANGENT.sub("tg", _SINE.sub("sen", text)))


def localised(number: str, language: Language) -> str:
    """Return a number written with a point, hyphen and commas in the manner of a language.

    Threes are set apart from ten thousand on.
    """
    plain = _FOUR_DIGITS.sub(r"\1\2", number)
    grouped = plain.replace("-", _MINUS).replace(",", _THIN_SPACE)
    return grouped.replace(".", ",") if language == "pt" else grouped


def with_indices(text: str, form: Callable[[str, str], str]) -> str:
    """Replace every symbol with an index, such as ``"δ_a"``, by what `form` makes of the two."""
    return _INDEXED.sub(lambda found: form(found[1], found[2]), text)


class _Manner(Formatter):
    """Formats numbers in the manner of a language; ``,`` in a specification groups by threes."""

    def __init__(self, language: Language) -> None:
        self._language: Language = language

    def format_field(self, value: Any, format_spec: str) -> str:
        if isinstance(value, Text):
            return value.speak(self._language)
        text = str(super().format_field(value, format_spec))
        return text if isinstance(value, str) else localised(text, self._language)
