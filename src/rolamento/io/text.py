"""From a file to a plain mapping, whatever the file holds.

Every failure is a `FileError`: a reader that is fed a photograph, a directory or a
million brackets says so in one sentence.
"""

from __future__ import annotations

import json
import os
import re
import stat
import sys
from collections.abc import Iterator, Mapping
from typing import Any, Final, Literal, NoReturn

from rolamento.errors import FileError, cause, shown
from rolamento.words import marked, said

__all__ = [
    "STANDARD_INPUT",
    "LineIndex",
    "TextFormat",
    "format_of_path",
    "format_of_text",
    "line_of",
    "lines_of_keys",
    "parse_mapping",
    "read_bytes",
    "read_text",
    "text_of_mapping",
]

TextFormat = Literal["toml", "json"]

STANDARD_INPUT: Final = "standard input"

LineIndex = dict[tuple[str, ...], int]

_KEY_PART: Final = r"""(?:[A-Za-z0-9_-]+|"[^"\n]*"|'[^'\n]*')"""
_DOTTED: Final = rf"{_KEY_PART}(?:[ \t]*\.[ \t]*{_KEY_PART})*"
_TOML_TABLE: Final = rf"[ \t]*\[{{1,2}}[ \t]*({_DOTTED})[ \t]*\]"
_TOML_KEY: Final = rf"[ \t]*({_DOTTED})[ \t]*="
_JSON_TOKEN: Final = r'"(?:[^"\\]|\\.)*"|[{}:\n]'

_LARGEST_FILE: Final = 1_000_000
# The standard library's TOML reader takes memory with the square of the parts of a
# dotted key: 400 kB of "a.a.a…" fill a machine.
_MOST_DOTS: Final = 100
_MOST_KEYS: Final = 1000
"""Maximum number of keys of one table; a case has some two hundred fields."""
_DEEPEST: Final = 100
"""Lists and tables in each other; what reads them may call itself for each."""
_ENCODING_MARKS: Final = {b"\xff\xfe": "UTF-16", b"\xfe\xff": "UTF-16"}


def read_text(path: str | os.PathLike[str]) -> tuple[str, str]:
    """Return the text of a file, or of standard input for ``"-"``, and what to call it.

    Raises
    ------
    FileError
        If there is no such regular file, it cannot be read, is larger than 1 MB, or
        is not UTF-8 text.
    """
    content = read_bytes(path, _LARGEST_FILE, marked("a case file"))
    source = STANDARD_INPUT if os.fspath(path) == "-" else os.fspath(path)
    if len(content) > _LARGEST_FILE:
        raise FileError(said("is larger than 1 MB, more than is read"), source=source)
    wrong = _ENCODING_MARKS.get(content[:2])
    if wrong:
        raise FileError(said("is {encoding} text; save it as UTF-8", encoding=wrong), source=source)
    if b"\0" in content:
        raise FileError(said("is a binary file; a case is TOML or JSON text"), source=source)
    try:
        return content.decode("utf-8-sig"), source
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise FileError(said("is not UTF-8 text"), source=source, line=line) from None


def read_bytes(path: str | os.PathLike[str], most: int, what: str) -> bytes:
    """Return the content of a regular file, or of standard input for ``"-"``, bounded.

    Parameters
    ----------
    path
        Of the file.
    most
        Bytes; of what is larger one byte more is returned.
    what
        To give in place of a directory.

    Raises
    ------
    FileError
        If there is no such regular file, or it cannot be read.
    """
    place = os.fspath(path)
    source = STANDARD_INPUT if place == "-" else place
    if place == "-" and sys.stdin is None:
        raise FileError(said("is closed"), source=source)
    try:
        if place == "-":
            return sys.stdin.buffer.read(most + 1)
        kind = os.stat(place).st_mode
        if stat.S_ISREG(kind):
            with open(place, "rb") as file:
                return file.read(most + 1)
    except OSError as error:
        rule = said("cannot be opened: {reason}", reason=cause(error))
        raise FileError(rule, source=source) from None
    except (TypeError, ValueError):
        raise FileError(said("is not a valid file name"), source=source) from None
    if stat.S_ISDIR(kind):
        raise FileError(said("is a directory; give {what}", what=said(what)), source=source)
    raise FileError(said("is not a regular file; use - for standard input"), source=source)


def format_of_path(path: str | os.PathLike[str]) -> TextFormat | None:
    """Return the format that a file name's ending names, if it does."""
    suffix = os.path.splitext(os.fspath(path))[1].lower()
    formats: dict[str, TextFormat] = {".toml": "toml", ".json": "json"}
    return formats.get(suffix)


def format_of_text(text: str) -> TextFormat:
    """Return the format that the first character names."""
    return "json" if text.lstrip().startswith("{") else "toml"


def text_of_mapping(mapping: Mapping[str, Any], text_format: TextFormat) -> str:
    """Return a mapping as TOML or JSON text, which `parse_mapping` reads back."""
    if text_format == "json":
        return json.dumps(mapping, indent=2, ensure_ascii=False) + "\n"
    import tomli_w  # when something is written, not whenever anything is read

    return tomli_w.dumps(mapping)


def parse_mapping(text: str, text_format: TextFormat, source: str) -> dict[str, Any]:
    """Return the mapping that a TOML or JSON text describes.

    Raises
    ------
    FileError
        If the text is empty, is not valid TOML or JSON, is nested too deep, repeats a
        key, or does not hold a table.
    """
    if not text.strip():
        raise FileError(said("is empty; a table in TOML or JSON is expected"), source=source)
    _refuse_rexs(text, source)
    parse = _parsed_json if text_format == "json" else _parsed_toml
    try:
        mapping = parse(text)
        _refuse_shape(mapping)
    except FileError as error:
        raise error.with_details(source=source) from None
    except RecursionError:
        raise FileError(said("is nested too deeply"), source=source) from None
    except ValueError as error:
        raise _syntax_error(error, text, source) from None
    if not isinstance(mapping, dict):
        raise FileError(
            said("must contain a table (an object in JSON)"),
            source=source,
            example='{"bearing": {…}, "duty": {…}}',
        )
    return mapping


def _refuse_shape(parsed: object) -> None:
    """Refuse lists and tables that stand in each other too deep, and tables of too many keys."""
    level = [parsed]
    for _ in range(_DEEPEST):
        inner: list[object] = []
        for one in level:
            if isinstance(one, dict) and len(one) > _MOST_KEYS:
                raise FileError(said("has a table of more than {most} keys", most=_MOST_KEYS))
            inner += one.values() if isinstance(one, dict) else one if isinstance(one, list) else ()
        level = [one for one in inner if isinstance(one, dict | list)]
        if not level:
            return
    raise FileError(said("is nested too deeply"))


_REXS: Final = (
    r"""(?s)\s*(?:<\?xml[^>]*>\s*)?(?:<!--.*?-->\s*)*<model\s[^>]*version\s*="""
    r"""|\s*\{\s*"model"\s*:\s*\{"""
)
"""How a model begins as XML (.rexs) and as JSON (.rexsj): REXS 1.4, FVA."""


def _refuse_rexs(text: str, source: str) -> None:
    """Refuse a model of a gear unit, by name.

    Raises
    ------
    FileError
        If it is one.
    """
    if not re.match(_REXS, text[:2000]) or not re.search(r"\b(?:relations|components)\b", text):
        return
    raise FileError(
        said("is a REXS model of a gear unit; make a machine file of it first"),
        source=source,
        example="rolamento import gearbox.rexs -o machine.toml",
    )


def _parsed_toml(text: str) -> object:
    for number, line in enumerate(text.split("\n"), start=1):
        if line.count(".") > _MOST_DOTS and not line.lstrip().startswith("#"):
            raise FileError(
                said("has more than {most} dots in one line", most=_MOST_DOTS), line=number
            )
    import tomllib

    return tomllib.loads(text)


def _parsed_json(text: str) -> object:
    return json.loads(text, object_pairs_hook=_without_repetition, parse_constant=_refused)


def _without_repetition(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    mapping = dict(pairs)
    if len(mapping) < len(pairs):
        seen: set[str] = set()
        for name, _ in pairs:
            if name in seen:
                raise FileError(said("gives the key {name} twice", name=shown(name)))
            seen.add(name)
    return mapping


def _refused(constant: str) -> NoReturn:
    raise FileError(said("contains {constant}, which is not a number", constant=constant))


def _syntax_error(error: ValueError, text: str, source: str) -> FileError:
    """Return a parser's complaint with its line number taken out of the sentence."""
    if isinstance(error, json.JSONDecodeError):
        rule = said("is not valid JSON: {reason}", reason=error.msg.lower())
        return FileError(rule, source=source, line=error.lineno)
    import tomllib

    if not isinstance(error, tomllib.TOMLDecodeError):  # the interpreter's limit on digits
        return FileError(said("contains a number with too many digits"), source=source)
    reason, _, place = str(error).partition(" (at ")
    number = re.match(r"line (\d+)", place)
    line = int(number[1]) if number else text.rstrip().count("\n") + 1
    return FileError(
        said("is not valid TOML: {reason}", reason=reason[:150].lower()),
        source=source,
        line=line,
    )


# --- where in a text a key stands -----------------------------------------------------------------
# The parsers of the standard library do not tell. This looks only for keys and takes a valid text
# for granted; what it misses, such as a key inside an inline table, gets the line of the nearest
# table around it.


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
        if match := re.match(_TOML_TABLE, line):
            table = _parts(match[1])
            yield table, number
        elif match := re.match(_TOML_KEY, line):
            yield (*table, *_parts(match[1])), number


def _parts(dotted: str) -> tuple[str, ...]:
    return tuple(part.strip("\"'") for part in re.findall(_KEY_PART, dotted))


def _json_keys(text: str) -> Iterator[tuple[tuple[str, ...], int]]:
    """Follow the braces: a string before a colon is a key of the innermost object."""
    path: list[str] = []
    line, name, name_line = 1, "", 1
    for match in re.finditer(_JSON_TOKEN, text):
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
