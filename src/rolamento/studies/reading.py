"""Study files: from TOML or JSON to a `Study`, and back."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, Final

import tomli_w

from rolamento._reading import (
    STANDARD_INPUT,
    LineIndex,
    TextFormat,
    format_of_path,
    format_of_text,
    line_of,
    lines_of_keys,
    parse_mapping,
    read_text,
)
from rolamento.case import Case, load_case
from rolamento.case.fields import OVERRIDE_SOURCE, overridden
from rolamento.errors import InputError
from rolamento.studies.study import Study

__all__ = ["case_file_of", "load_study", "parse_study", "study_to_json", "study_to_toml"]

_LIST_HEADER: Final = re.compile(r"^([ \t]*)\[\[[ \t]*([A-Za-z_.]{1,60})[ \t]*\]\]", re.MULTILINE)


def case_file_of(path: str | os.PathLike[str]) -> Path | None:
    """Return the case file that a study file names, if it does.

    Raises
    ------
    FileError
        As `load_study`.
    """
    text, source = read_text(path)
    case = parse_mapping(text, format_of_path(path) or format_of_text(text), source).get("case")
    return Path(path).parent / case if isinstance(case, str) and case else None


def load_study(path: str | os.PathLike[str], overrides: Iterable[str] = ()) -> Study:
    """Read a study file.

    Parameters
    ----------
    path
        A TOML or JSON file; ``"-"`` for standard input. A case that it names is looked for beside
        it.
    overrides
        Settings ``KEY=VALUE`` that go over the case, such as ``"duty.load.fz=10 kN"``.

    Raises
    ------
    FileError
        If the file or its case cannot be read, or is neither TOML nor JSON.
    InputError
        If it does not describe a valid study; with the line number.
    """
    text, source = read_text(path)
    folder = Path() if source == STANDARD_INPUT else Path(path).parent
    return parse_study(
        text, format=format_of_path(path), source=source, folder=folder, overrides=overrides
    )


def parse_study(
    text: str,
    *,
    format: TextFormat | None = None,
    source: str = "",
    folder: str | os.PathLike[str] = ".",
    overrides: Iterable[str] = (),
) -> Study:
    """Return the study that a TOML or JSON text describes.

    Parameters
    ----------
    text
        The text of a study file.
    format
        ``"toml"``, ``"json"``, or ``None`` to go by the first character.
    source
        What to call the text in messages.
    folder
        Where to look for the case file that it names.
    overrides
        As in `load_study`.

    Raises
    ------
    InputError
        As `load_study`.
    """
    known_format = format or format_of_text(text)
    mapping = parse_mapping(text, known_format, source)
    try:
        case = _case_of(mapping, Path(folder), tuple(overrides))
        return Study.from_mapping(mapping if case is None else {**mapping, "case": case})
    except InputError as error:
        if error.source:
            raise
        line = line_of(error.field, _lines(text, known_format))
        raise error.with_details(source=source, line=line) from None


def study_to_toml(study: Study) -> str:
    """Return a study as the text of a study file that holds its case: one file says it all."""
    return tomli_w.dumps(study.to_mapping())


def study_to_json(study: Study) -> str:
    """Return a study as JSON, its case included."""
    return json.dumps(study.to_mapping(), ensure_ascii=False)


def _case_of(mapping: Mapping[str, Any], folder: Path, settings: tuple[str, ...]) -> Case | None:
    """Return the case that a study names or holds, with settings put over it."""
    given = mapping.get("case")
    if given is None:
        return None
    if isinstance(given, str):
        try:
            return load_case(folder / given, settings)
        except InputError as error:
            raise error.with_details(source=error.source or given) from None
    if not isinstance(given, dict):
        raise InputError(
            "must be the name of a case file, or a table",
            field="case",
            value=given,
            example='case = "case.toml"',
        )
    changed, set_fields = overridden(given, settings, Case)
    try:
        return Case.from_mapping(changed)
    except InputError as error:
        if error.field in set_fields:
            raise error.with_details(source=OVERRIDE_SOURCE) from None
        raise error.with_details(field=f"case.{error.field}".rstrip(".")) from None


def _lines(text: str, text_format: TextFormat) -> LineIndex:
    """Return the lines of keys; tables in lists by their number, as errors name them."""
    if text_format == "toml":
        counts: dict[str, int] = {}

        def numbered(match: re.Match[str]) -> str:
            number = counts[match[2]] = counts.get(match[2], -1) + 1
            return f"{match[1]}[{match[2]}.{number}]"

        text = _LIST_HEADER.sub(numbered, text)
    index: LineIndex = {}
    for path, line in lines_of_keys(text, text_format).items():
        index.setdefault(tuple(".".join(path).split(".")), line)
    return index
