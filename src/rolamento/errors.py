"""The exceptions of Rolamento.

::

    RolamentoError                 everything that Rolamento raises on purpose
    └── InputError (ValueError)    what the user gave is not usable
        ├── FileError              a file cannot be read, decoded, parsed or written
        ├── UnknownKeyError        a key that nobody reads, with the nearest known one
        └── UnitError              a unit that is missing, unknown or of another quantity

A solve that finds no equilibrium raises nothing: its result carries a status.
"""

from __future__ import annotations

import difflib
import json
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Final, Self

from rolamento.words import Note, languages, marked, said, speaking
from rolamento.words.naming import either, shortened

__all__ = [
    "FileError",
    "InputError",
    "Phrase",
    "RolamentoError",
    "UnitError",
    "UnknownKeyError",
    "alike",
    "arguments",
    "cause",
    "guess",
    "kind_of",
    "nearest",
    "phrase",
    "printable",
    "refusal",
    "respelled",
    "shown",
]

_LONGEST_VALUE: Final = 60
_MOST_LISTED: Final = 40
_MOST_ALIKE: Final = 3
_NEAREST: Final = 5
_ACTING: Final = "[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff]"


_STREAMS: Final = (
    marked("standard input"),
    marked("standard output"),
    marked("standard error"),
)
"""Sources that are no files."""


class _Absent:
    """The type of `ABSENT`, which stands for a value that was not given."""

    def __repr__(self) -> str:
        return "ABSENT"

    def __reduce__(self) -> str:
        return "ABSENT"

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self


ABSENT: Final = _Absent()


class Phrase(str):
    """A text that knows which arguments of a function it names.

    A command or a page writes them as its own options and fields (`respelled`), so that nobody has
    to find them in a sentence.
    """

    message: str | None
    values: Mapping[str, Any]

    def __new__(cls, text: str, message: str | None, values: Mapping[str, Any]) -> Self:
        """Keep what the text was made from; message: None of arguments alone."""
        self = super().__new__(cls, text)
        self.message, self.values = message, values
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return Phrase, (str(self), self.message, self.values)


def arguments(**values: Any) -> Phrase:
    """Return arguments of a function as an example.

    >>> arguments(speed="1797 rpm", pulses=2)
    'speed="1797 rpm", pulses=2'
    """
    return Phrase(_as_arguments(values, {}, "{}={}".format, ", "), None, values)


def phrase(message: str, **values: Any) -> Phrase:
    """Say a text, `marked`, of whose values some are `arguments`, or names of fields."""
    return Phrase(said(message, **values), message, values)


def respelled(
    text: str,
    names: Mapping[str, str],
    written: Callable[[str, str], str] = "{}={}".format,
    between: str = ", ",
) -> str:
    """Return a text with the arguments and fields that it names by other names.

    Parameters
    ----------
    text
        A `Phrase`; any other text is returned as it is.
    names
        The other name of each; one without is written as before.
    written
        Writes an argument, by its other name, with a value.
    between
        What stands between two arguments.
    """
    if not isinstance(text, Phrase):
        return text
    if text.message is None:
        return _as_arguments(text.values, names, written, between)

    def other(value: Any) -> Any:
        if isinstance(value, Phrase):
            return respelled(value, names, written, between)
        return names.get(value, value) if isinstance(value, str) else value

    return said(text.message, **{name: other(value) for name, value in text.values.items()})


def _as_arguments(
    values: Mapping[str, Any],
    names: Mapping[str, str],
    written: Callable[[str, str], str],
    between: str,
) -> str:
    parts = [
        written(names[name], _literal(value)) if name in names else f"{name}={_literal(value)}"
        for name, value in values.items()
    ]
    return (between if names.keys() & values.keys() else ", ").join(parts)


def _literal(value: object) -> str:
    """Write a value as Python does, texts in double quotes."""
    if value is ...:
        return "…"
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, list | dict):
        return json.dumps(value, ensure_ascii=False)
    return repr(value)


class RolamentoError(Exception):
    """Base of every exception that Rolamento raises on purpose."""


class InputError(RolamentoError, ValueError):
    """What the user gave is not usable: where, what, which rule, an example.

    Parameters
    ----------
    rule
        The rule that was broken, as the end of a sentence; `said` where it is raised.
    field
        Dotted name of the field, such as ``"bearing.ball_diameter"``, or words in English that are
        `marked`, such as ``"number of samples"``.
    value
        What was given; shown shortened and with control characters escaped.
    example
        A value that would be accepted, as it is written in a case file; or `arguments`.
    source
        Where the value came from: a file name, ``"standard input"``, ``"--set"``.
    line
        Line number in the source, counted from 1.
    """

    def __init__(
        self,
        rule: str,
        *,
        field: str = "",
        value: object = ABSENT,
        example: str = "",
        source: str = "",
        line: int | None = None,
    ) -> None:
        super().__init__(rule)
        self.rule = rule
        self.field = field
        self.value = value
        self.example = example
        self.source = source
        self.line = line

    def __str__(self) -> str:
        parts = [part for part in (self._place(), self._subject(), self.rule) if part]
        text = ": ".join(parts)
        if self.example:
            text += " " + said("(example: {example})", example=self.example)
        return printable(text)

    def _place(self) -> str:
        source = said(self.source) if self.source in _STREAMS else _escaped(self.source)
        line = "" if self.line is None else said("line {line}", line=str(self.line))
        return ", ".join(part for part in (source, line) if part)

    def _subject(self) -> str:
        named = said(self.field) if " " in self.field else self.field
        field = shortened(_escaped(named), 2 * _LONGEST_VALUE)
        if self.value is ABSENT:
            return field
        between = ": " if field.startswith("--") else " = "  # an option, or a field of a case
        return f"{field}{between}{shown(self.value)}" if field else shown(self.value)

    def with_details(
        self,
        *,
        field: str | None = None,
        value: object = ABSENT,
        example: str | None = None,
        source: str | None = None,
        line: int | None = None,
        rule: str | None = None,
    ) -> Self:
        """Return the same error with the given details filled in."""
        # not copy.copy: what Dask registers for exceptions shares their attributes
        return type(self)(
            self.rule if rule is None else rule,
            field=self.field if field is None else field,
            value=self.value if value is ABSENT else value,
            example=self.example if example is None else example,
            source=self.source if source is None else source,
            line=self.line if line is None else line,
        )

    def spelled(
        self,
        names: Mapping[str, str],
        written: Callable[[str, str], str] = "{}={}".format,
        between: str = ", ",
    ) -> Self:
        """Return the same error with the arguments that it names by other names, as `respelled`.

        Its field or its source may be one.
        """
        rule, example = (
            respelled(text, names, written, between) for text in (self.rule, self.example)
        )
        field = self.field if self.source in names else names.get(self.field, self.field)
        source = names.get(self.source, self.source)
        return self.with_details(rule=rule, field=field, source=source, example=example)


class FileError(InputError):
    """A file cannot be read, decoded, parsed or written."""


class UnknownKeyError(InputError):
    """A key that nobody reads; the message names the nearest known one."""


class UnitError(InputError):
    """A unit that is missing, unknown or of another quantity."""


def refusal(attempt: Callable[[], object]) -> Note | None:
    """Return which rule an attempt violates, as a note; None if it violates none.

    Its values: "field", dotted; "rule", the message of the `InputError` by language.
    """
    field, rules = "", {}
    for code in languages():
        with speaking(code):
            try:
                attempt()
            except InputError as error:
                field, rules[code] = error.field, str(error)
            else:
                return None
    return Note("invalid_input", {"field": field, "rule": rules})


def kind_of(value: object) -> object:
    """Return what an error shows of a value of a wrong kind: a plain one itself, else its type."""
    plain = value is None or isinstance(value, str | int | float | list | tuple | dict)
    return value if plain else type(value)


def shown(value: object) -> str:
    """Return a value as one short line of printable text, whatever the value is."""
    if isinstance(value, type):
        return said("an object of type {name}", name=value.__name__)
    if isinstance(value, dict):
        return said("a table")
    if isinstance(value, list | tuple | set):
        return said("a list")
    if isinstance(value, str):
        return f'"{shortened(_escaped(value), _LONGEST_VALUE)}"'
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int) and value.bit_length() > 200:
        return said("a very long integer")
    return shortened(_escaped(str(value)), _LONGEST_VALUE)


def printable(text: str) -> str:
    """Return a text with what a terminal would act on written as an escape.

    Those are control characters, but for ends of lines and tabs, and what turns the direction of
    writing. Texts of files come through here before they are shown.
    """
    return re.sub(_ACTING, lambda found: found[0].encode("unicode_escape").decode(), text)


def alike(word: str, known: Iterable[str]) -> tuple[str, ...]:
    """Return the known words most like `word`, all that are equally so; none if none is near."""
    by_folded = {candidate.casefold(): candidate for candidate in known}
    # A bounded word: the matching is quadratic in its length.
    folded = word[:_LONGEST_VALUE].casefold()
    found = difflib.get_close_matches(folded, by_folded, n=_MOST_ALIKE, cutoff=0.6)
    ratios = {one: difflib.SequenceMatcher(None, one, folded).ratio() for one in found}
    best = max(ratios.values(), default=0.0)
    return tuple(name for one, name in by_folded.items() if ratios.get(one) == best)


def nearest(word: str, known: Iterable[str]) -> str:
    """Return the known word most like `word`, or an empty string if none is near."""
    return next(iter(alike(word, known)), "")


def guess(word: str, known: Iterable[str], where: str = "") -> str:
    """Return what to say of a word that is not known.

    Parameters
    ----------
    word, known
        It names those that are most like it; without any all, or of many the nearest.
    where
        What is said of where the list of many stands; by default how many they are.
    """
    known = tuple(known)
    near = alike(word, known)
    if near:
        return said("did you mean {near}?", near=either(near))
    if len(known) <= _MOST_LISTED:
        return said("known: {known}", known=", ".join(known))
    like = difflib.get_close_matches(word[:_LONGEST_VALUE], known, n=_NEAREST, cutoff=0.0)
    few = ", ".join(one for one in known if one in like)
    if where:
        return said("nearest: {few}; {where}", few=few, where=where)
    return said("nearest: {few}, of {count}", few=few, count=len(known))


def cause(error: OSError) -> str:
    """Return why the system refused something, as it is said."""
    reason = (error.strerror or str(error)).lower()
    return said(reason) if error.strerror else reason


_OF_SYSTEM: Final = (
    marked("no such file or directory"),
    marked("permission denied"),
    marked("is a directory"),
    marked("not a directory"),
    marked("no space left on device"),
    marked("read-only file system"),
    marked("file name too long"),
    marked("file exists"),
    marked("input/output error"),
    marked("too many open files"),
    marked("too many levels of symbolic links"),
    marked("address already in use"),
    marked("cannot assign requested address"),
)
"""What `cause` has to say most often."""


def _escaped(text: str) -> str:
    head = text[: 4 * _LONGEST_VALUE]
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in head)
