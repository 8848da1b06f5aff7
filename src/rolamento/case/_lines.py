"""Where in a text a key stands, for messages that a person can act on.

The parsers of the standard library do not tell. This looks only for keys and takes
a valid text for granted; what it misses, such as a key inside an inline table, gets
the line of the nearest table around it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Final

from rolamento._reading import TextFormat

__all__ = ["LineIndex", "line_of", "lines_of_keys"]

LineIndex = dict[tuple[str, ...], int]

_KEY_PART: Final = r"""(?:[A-Za-z0-9_-]+|"[^"\n]*"|'[^'\n]*')"""
_DOTTED: Final = rf"{_KEY_PART}(?:[ \t]*\.[ \t]*{_KEY_PART})*"
_TOML_TABLE: Final = re.compile(rf"[ \t]*\[{{1,2}}[ \t]*({_DOTTED})[ \t]*\]")
_TOML_KEY: Final = re.compile(rf"[ \t]*({_DOTTED})[ \t]*=")
_PART: Final = re.compile(_KEY_PART)
_JSON_TOKEN: Final = re.compile(r'"(?:[^"\\]|\\.)*"|[{}:\n]')


def lines_of_keys(text: str, text_format: TextFormat) -> LineIndex:
    """Return the line of every key and table that is found, counted from 1."""
    pairs = _json_keys(text) if text_format == "json" else _toml_keys(text)
    index: LineIndex = {}
    for path, line in pairs:
        index.setdefault(path, line)
    return index


def line_of(field: str, index: LineIndex) -> int | None:
    """Return the line of a dotted field, or of the nearest table around it."""
    path = tuple(field.split("."))
    for length in range(len(path), 0, -1):
        if path[:length] in index:
            return index[path[:length]]
    return None


def _toml_keys(text: str) -> Iterator[tuple[tuple[str, ...], int]]:
    table: tuple[str, ...] = ()
    for number, line in enumerate(text.split("\n"), start=1):
        if match := _TOML_TABLE.match(line):
            table = _parts(match[1])
            yield table, number
        elif match := _TOML_KEY.match(line):
            yield (*table, *_parts(match[1])), number


def _parts(dotted: str) -> tuple[str, ...]:
    return tuple(part.strip("\"'") for part in _PART.findall(dotted))


def _json_keys(text: str) -> Iterator[tuple[tuple[str, ...], int]]:
    """Follow the braces: a string before a colon is a key of the innermost object."""
    path: list[str] = []
    line, name, name_line = 1, "", 1
    for match in _JSON_TOKEN.finditer(text):
        token = match[0]
        if token == "\n":
            line += 1
        elif token == "{":
            path.append("")
        elif token == "}" and path:
            path.pop()
        elif token == ":" and path:
            path[-1] = name
            yield tuple(path), name_line
        elif token.startswith('"'):
            name, name_line = token[1:-1], line
