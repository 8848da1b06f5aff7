"""Designations of other systems: insert bearings and their units, and types that are not known."""

from __future__ import annotations

import re
from functools import partial
from typing import Any, Final, NamedTuple

from rolamento._data import toml_of
from rolamento.errors import InputError

__all__ = ["Insert", "insert_of", "other_type"]

_data = partial(toml_of, "designations")

_INSERT: Final = re.compile(
    r"(?P<letters>[A-Z]{2,7})-?(?P<series>[23X])(?P<bore>\d\d)(?:-(?P<sixteenths>\d{1,2})(?![A-Z\d]))?"
    r"(?P<rest>(?:[-/]?[A-Z]|[-/]\d).*)?"
)
_UNIT: Final = re.compile(r"(?P<letters>[A-Z]{2,5})-?(?P<bore>\d{2,3})(?P<rest>(?:-|[A-Z]).*)?")
_LEAST_CODE: Final = 4
"""Of the bore: below 20 mm makers differ in the outside diameter."""
_MOST_CODE: Final = 22


class Insert(NamedTuple):
    """An insert bearing, alone or in its housing.

    Attributes
    ----------
    number
        of the deep-groove bearing with the same inside
    clearance_class
        with which it is supplied, unless its suffixes say another
    meanings
        of its letters
    rest
        suffixes that follow
    """

    number: str
    clearance_class: str
    meanings: tuple[tuple[str, str], ...]
    rest: str


def insert_of(text: str) -> Insert | None:
    """Return the insert bearing that a designation names, such as ``"UCP 205-16"``; else None.

    Raises
    ------
    InputError
        If it is one whose inside depends on the maker.
    """
    plain = re.sub(r"[\s.]", "", text.upper())
    found = _INSERT.fullmatch(plain)
    parts = None if found is None else _letters(found["letters"])
    if found is not None and parts is not None:
        series, code = found["series"], int(found["bore"])
        _check_code(text, series, code)
        number = f"62{code + 1:02d}" if series == "X" else f"6{series}{code:02d}"
        meanings = [(parts.insert, parts.meaning)]
        if parts.housing:
            meanings.append((parts.housing, _data()["insert_housings"][parts.housing]))
        if found["sixteenths"]:
            meanings.append((f"-{found['sixteenths']}", _data()["phrases"]["inches"]))
        tapered = "tapered" in parts.meaning
        return Insert(number, "C4" if tapered else "C3", tuple(meanings), found["rest"] or "")
    found = _UNIT.fullmatch(plain)
    if found is None or found["letters"] not in _data()["insert_units"]["names"]:
        return None
    code, off = divmod(int(found["bore"]), 5)
    plain_bearing = found["letters"] == "GE" and not re.match(r"-?(?:K|NPP)", found["rest"] or "")
    if off or plain_bearing or code > _MOST_CODE:
        return None
    _check_code(text, "2", code)
    meanings = [(found["letters"], _data()["phrases"]["unit"])]
    return Insert(f"62{code:02d}", "C3", tuple(meanings), found["rest"] or "")


class _Letters(NamedTuple):
    insert: str
    meaning: str
    housing: str


def _letters(letters: str) -> _Letters | None:
    """Part the letters of a unit into those of its insert and of its housing."""
    data = _data()
    for insert in sorted(data["inserts"], key=len, reverse=True):
        housing = letters.removeprefix(insert)
        if letters.startswith(insert) and (not housing or housing in data["insert_housings"]):
            return _Letters(insert, data["inserts"][insert], housing)
    return None


def _check_code(text: str, series: str, code: int) -> None:
    if _LEAST_CODE <= code <= _MOST_CODE:
        return
    if code > _MOST_CODE:
        rule = f"is no insert bearing: bore codes end at {_MOST_CODE}"
    else:
        of_code = "6304" if series == "3" else "6203 or of 6204, by its maker"
        rule = f"is an insert bearing with the inside of {of_code}: give that"
    raise InputError(rule, field="designation", value=text, example='designation = "6204"')


def other_type(text: str) -> str:
    """Return what a designation is, as the end of a sentence, if its type is not known here."""
    plain = re.sub(r"[\s\-/.]", "", text.upper())
    for kind in _data()["type"]:
        kept_out = kind.get("unless")
        if re.match(kind["begins"], plain) and not (kept_out and re.match(kept_out, plain)):
            return _sentence(kind)
    return ""


def _sentence(kind: dict[str, Any]) -> str:
    known = "known are single-row deep-groove and angular-contact ball bearings"
    if "advice" in kind:
        return f"is {kind['name']}; {kind['advice']}"
    return f"is {kind['name']}, a type that is not known here; {known}"
