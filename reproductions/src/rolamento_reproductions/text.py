"""What is said in each language: Markdown templates beside the code, filled in with numbers.

A publication's prose lies in its folders ``en`` and ``pt``, one file a chapter. A template has a
key: the heading above it, or for a short one what stands before the colon in a list::

    - cage: cage

    ## table_of_frequencies.caption

    The 218 at {speed_rpm:.0f} rpm: frequencies in Hz.

Places are filled in as `rolamento.words.manner` says.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, Final

from rolamento.words import language, manner, speaking

ENGLISH: Final = "en"
_MINUS: Final = "−"
_HEADING: Final = "## "
_LABEL: Final = re.compile(r"- ([\w.]+): (.+)")
_FUNCTION: Final = re.compile(r"\b(sin|tan)\b")


@dataclass(frozen=True, slots=True)
class Text:
    """A text that is said when it is read, in the language that is spoken then."""

    say: Callable[[], str]

    def __str__(self) -> str:
        return self.say()

    def speak(self, code: str) -> str:
        """Return what is said in a language."""
        with speaking(code):
            return self.say()


@dataclass(frozen=True, slots=True)
class Prose:
    """The templates of a publication; called with a key and values it returns a `Text`.

    Parameters
    ----------
    folder
        Of the publication in this package; ``""`` for what all have in common.
    """

    folder: str

    def __call__(self, key: str, /, *values: object, **named: object) -> Text:
        """Fill a template in: places with names, or with numbers in the order of the values."""
        templates(self.folder, ENGLISH)[key]
        return Text(lambda: _filled(self._spoken()[key], values, named))

    def _spoken(self) -> Mapping[str, str]:
        return templates(self.folder, language()) or templates(self.folder, ENGLISH)


@cache
def templates(folder: str, code: str) -> Mapping[str, str]:
    """Return the templates of a publication in a language by their keys, empty if it has none.

    Raises
    ------
    ValueError
        If a key stands there twice.
    """
    place = files("rolamento_reproductions").joinpath(folder, code)
    found: dict[str, str] = {}
    if not place.is_dir():
        return found
    for file in place.iterdir():
        key = ""
        for line in map(str.strip, file.read_text(encoding="utf-8").splitlines()):
            label = _LABEL.fullmatch(line) if not key else None
            begun = label[1] if label else line.removeprefix(_HEADING)
            if label or line.startswith(_HEADING):
                if begun in found:
                    raise ValueError(f"{file}: {begun} stands there twice")
                found[begun] = label[2] if label else ""
                key = key if label else begun
            elif line:
                found[key] = f"{found[key]} {line}".strip()
    return found


def same(text: str, *values: object, **named: object) -> Text:
    """Return what is the same in all languages; a template if there is something to fill in."""
    return Text(lambda: _filled(text, values, named))


def formula(text: str) -> Text:
    """Return a formula; the names of functions are those of the language."""
    return Text(lambda: _FUNCTION.sub(lambda name: str(_common(name[0])), text))


def fixed(value: float, decimals: int) -> Text:
    """Return a number with so many decimals, ungrouped, as it stands in files too."""
    return written(f"{value:.{decimals}f}")


def written(number: str) -> Text:
    """Return a number that is written with a point and a hyphen in the manner of the language."""
    return Text(lambda: localised(number))


def listed(parts: Sequence[Text]) -> Text:
    """Return texts as a list: "57.8, 151.2 and 189"."""
    if len(parts) < 2:
        return parts[0] if parts else _common("none")
    separator = _common("separator")
    before = Text(lambda: f"{separator} ".join(map(str, parts[:-1])))
    return _common("and", before=before, last=parts[-1])


def localised(number: str) -> str:
    """Write a number that is written with a point and a hyphen in the manner of the language."""
    return number.replace("-", _MINUS).replace(".", manner().mark)


_common: Final = Prose("")


def _filled(template: str, values: Sequence[Any], named: Mapping[str, Any]) -> str:
    return manner().vformat(template, values, named) if values or named else template
