"""What is said to people: English where it is used, other languages from gettext catalogues.

`said` translates a text into the language that is spoken and fills it in; which one that is,
`speaking` sets for a block of code. The catalogues are `locale/<language>/LC_MESSAGES`.
"""

from __future__ import annotations

import gettext
import os
import re
import struct
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any, Final

from rolamento.words.manner import Manner

__all__ = [
    "CATALOGUES",
    "DOMAIN",
    "code_asked",
    "counted",
    "language",
    "language_asked",
    "language_of",
    "languages",
    "manner",
    "marked",
    "said",
    "said_in",
    "speaking",
    "spelling",
]

DOMAIN: Final = "rolamento"
CATALOGUES: Final = Path(__file__).parents[1] / "locale"
ENGLISH: Final = "en"

_VARIABLES: Final = ("LC_ALL", "LC_MESSAGES", "LANG")
_MARK: Final = "decimal mark"
"""The context of the entry by which a catalogue gives its decimal mark."""

_spoken: ContextVar[str] = ContextVar("language", default=ENGLISH)
_spelled: ContextVar[Callable[[str], str]] = ContextVar("spelling", default=str)
_NAME: Final = re.compile(r"`([^`]+)`")


@cache
def languages() -> Mapping[str, str]:
    """Return the languages by their codes: ``{"en": "en", "pt": "pt_BR"}``."""
    folders = sorted(path.parent.parent.name for path in CATALOGUES.glob("*/LC_MESSAGES/*.po"))
    return {ENGLISH: ENGLISH} | {name.partition("_")[0]: name for name in folders}


def language() -> str:
    """Return the code of the language that is spoken, such as ``"en"`` or ``"pt"``."""
    return _spoken.get()


def language_of(code: str | None = None, environment: Mapping[str, str] | None = None) -> str:
    """Return the language of a code, or else of the locale; English where there is no catalogue."""
    if code is None:
        variables = os.environ if environment is None else environment
        code = next((variables[name] for name in _VARIABLES if variables.get(name)), "")
    code = code[:2].lower()
    return code if code in languages() else ENGLISH


def code_asked(arguments: Sequence[str] | None = None) -> str | None:
    """Return what a command line gives for ``--lang``, be it a language or not; None for nothing.

    Parameters
    ----------
    arguments
        Without the program's name; by default those of this process.
    """
    words = [*(sys.argv[1:] if arguments is None else arguments), ""]
    words = words[: words.index("--")] if "--" in words else words
    code = None
    for word, behind in pairwise(words):
        if word == "--lang":
            code = behind
        elif word.startswith("--lang="):
            code = word.removeprefix("--lang=")
    return code


def language_asked(arguments: Sequence[str] | None = None) -> str:
    """Return the language of `code_asked`, or else the locale's."""
    return language_of(code_asked(arguments))


@contextmanager
def speaking(code: str | None) -> Iterator[None]:
    """Speak a language within a block; None leaves it as it is.

    Parameters
    ----------
    code
        Such as ``"pt"``; a language without a catalogue is English.
    """
    if code is None:
        yield
        return
    token = _spoken.set(language_of(code))
    try:
        yield
    finally:
        _spoken.reset(token)


@contextmanager
def spelling(spelled: Callable[[str], str]) -> Iterator[None]:
    """Spell the names in texts in one's own way within a block: as options, as labels of a form.

    Parameters
    ----------
    spelled
        Takes what stands between backticks in a text: an input (``"speed"``), a field of a case
        (``"life.cleanliness"``), either with a value (``"shape=1.5"``), or a command
        (``"rolamento life"``). Without one they stand as they are.
    """
    token = _spelled.set(spelled)
    try:
        yield
    finally:
        _spelled.reset(token)


def said(message: str, /, **values: Any) -> str:
    """Say a text in the language that is spoken, its places filled in.

    Parameters
    ----------
    message
        In English; what stands in braces is filled in as `rolamento.words.manner` says, a name
        between backticks as `spelling` says.
    values
        What is filled in; numbers in SI.
    """
    return _filled(_catalogue(_spoken.get()).gettext(message), values)


def said_in(context: str, message: str, /, **values: Any) -> str:
    """Say a text that has another translation in another context: the inner race, ring."""
    return _filled(_catalogue(_spoken.get()).pgettext(context, message), values)


def counted(one: str, many: str, number: int, /, **values: Any) -> str:
    """Say a text of one or of many; ``{n}`` is how many."""
    text = _catalogue(_spoken.get()).ngettext(one, many, int(number))
    return _filled(text, {"n": number, **values})


def marked(message: str) -> str:
    """Return a text as it is: the catalogues take it up, and `said` says it later."""
    return message


def manner() -> Manner:
    """Return how the language that is spoken writes numbers."""
    return _manner(_spoken.get())


def _filled(text: str, values: Mapping[str, Any]) -> str:
    if "`" in text:
        spelled = _spelled.get()
        text = _NAME.sub(lambda found: spelled(found[1]), text)
    return manner().vformat(text, (), values) if values else text


@cache
def _manner(code: str) -> Manner:
    mark = _catalogue(code).pgettext(_MARK, ".")
    return Manner(mark)


@cache
def _catalogue(code: str) -> gettext.NullTranslations:
    if code == ENGLISH:
        return gettext.NullTranslations()
    folder = [languages()[code]]
    try:
        return gettext.translation(DOMAIN, CATALOGUES, languages=folder, fallback=True)
    except (OSError, ValueError, struct.error):  # a damaged file
        return gettext.NullTranslations()
