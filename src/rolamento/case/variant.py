"""Variants of a case: what is compared with it, each by a name and what is different in it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Final, Self

from pydantic import Field, ValidationInfo, model_validator

from rolamento.case.case import Case, with_changes
from rolamento.case.fields import fields_of, in_file_form, values_of
from rolamento.case.quantity import AT_THE_BORDER, Line
from rolamento.case.record import Record
from rolamento.errors import InputError
from rolamento.words import said

__all__ = [
    "AS_GIVEN",
    "MOST_VARIANTS",
    "VARIANT_SOURCE",
    "Variant",
    "cases_compared",
    "named",
    "read_variant",
    "read_variants",
    "settings_in",
    "with_the_case",
]

VARIANT_SOURCE: Final = "--variant"
AS_GIVEN: Final = "as given"
"""What the case itself is called among its variants, where they do not name it."""
MOST_VARIANTS: Final = 20
_EXAMPLE: Final = """--variant 'spring:bearing.preload={ spring = "500 N" }'"""
_NAME: Final = re.compile(r"\s*([^:={}\[\]\"']{1,60}?)\s*:(.*)", re.DOTALL)
_NEXT: Final = re.compile(r"\s*[A-Za-z_][\w.]*\s*=")
_OPENING, _CLOSING, _QUOTES = "{[", "}]", "\"'"


class Variant(Record):
    """A case that differs from another in some fields.

    Parameters
    ----------
    name
        What it is called in tables and figures.
    changes
        By dotted field, such as ``{"bearing.preload.spring": "500 N"}``: values as in a case file,
        in Python SI numbers and records too. A table takes the place of the whole one,
        ``{"bearing.preload": {"spring": "500 N"}}``, an empty one takes it away; a field takes the
        place of its rival. Empty for the case as it is.

    Raises
    ------
    InputError
        If a field is unknown, or does not take the value.
    """

    name: Line = Field(min_length=1, examples=["spring"])
    changes: dict[str, Any] = Field(
        default_factory=dict, max_length=50, examples=['{ "bearing.preload.spring" = "500 N" }']
    )

    @model_validator(mode="after")
    def _as_a_file_holds_them(self, info: ValidationInfo) -> Self:
        changes = dict(_flat(self.changes, ""))
        for name, value in changes.items():
            if info.context != AT_THE_BORDER:
                changes[name] = in_file_form(name, value, Case)
            elif (field := fields_of(Case).get(name)) is not None and field.continuous:
                field.checked(value, in_file=True)
        object.__setattr__(self, "changes", changes)
        return self

    def of(self, case: Case) -> Case:
        """Return the case with the changes.

        Raises
        ------
        InputError
            If the two do not go together.
        """
        if not self.changes:
            return case
        taken = {name: None if value == {} else value for name, value in self.changes.items()}
        return with_changes(case, taken)


def with_the_case(variants: Sequence[Variant]) -> tuple[Variant, ...]:
    """Return the variants with the case itself before them, unless one without changes names it.

    Raises
    ------
    InputError
        If two have one name, or there are more than 20.
    """
    found = tuple(variants)
    if not found:
        return ()
    if all(variant.changes for variant in found):
        found = (Variant(name=AS_GIVEN), *found)
    names = [variant.name for variant in found]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise InputError(
            said("occurs twice"), value=twice, example=_EXAMPLE, source=VARIANT_SOURCE
        )  # fmt: skip
    if len(found) > MOST_VARIANTS:
        raise InputError(
            said("may be given at most {most} times", most=MOST_VARIANTS),
            source=VARIANT_SOURCE,
            value=len(found),
        )
    return found


def cases_compared(case: Case, variants: Sequence[Variant]) -> dict[str, Case]:
    """Return the case and its variants by their names.

    Raises
    ------
    InputError
        As `with_the_case`, or if a variant is none of the case: with its name.
    """
    found = {}
    for variant in with_the_case(variants):
        try:
            found[variant.name] = variant.of(case)
        except InputError as error:
            raise named(error, variant.name) from None
    return found


def named(error: InputError, name: str, field: str | None = None) -> InputError:
    """Return an error that says of which variant it is."""
    at = error.field if field is None else field
    return error.with_details(field=f"{name}: {at}" if at else name, source=VARIANT_SOURCE)


def read_variants(texts: Iterable[str]) -> tuple[Variant, ...]:
    """Return variants from texts; see `read_variant`."""
    return tuple(read_variant(text) for text in texts)


def read_variant(text: str) -> Variant:
    """Return the variant that a text stands for: ``NAME:FIELD=VALUE[,FIELD=VALUE…]``.

    Parameters
    ----------
    text
        The name may be left out: then the changes are the name. Values are as in a case file, the
        quotes around text may be left out; a table is written in one line, as TOML has it. A name
        with a colon alone is the case as it is.

    Raises
    ------
    InputError
        If it is not of that form, or its fields do not take the values.
    """
    name, settings = settings_in(text)
    if not settings and (not name or ":" not in text):
        raise InputError(
            said("must be NAME:FIELD=VALUE, with further FIELD=VALUE after commas"),
            value=text,
            source=VARIANT_SOURCE,
            example=_EXAMPLE,
        )
    try:
        changes = values_of(settings, Case)
        return Variant.from_mapping({"name": name or ", ".join(settings), "changes": changes})
    except InputError as error:
        raise error.with_details(source=VARIANT_SOURCE) from None


def settings_in(text: str) -> tuple[str, tuple[str, ...]]:
    """Return the name, or nothing, and each ``FIELD=VALUE`` that a variant's text has."""
    found = _NAME.fullmatch(text)
    name, rest = (found[1], found[2]) if found else ("", text)
    parts = tuple(part.strip() for part in _at_commas(rest))
    return name, tuple(part for part in parts if part)


def _at_commas(text: str) -> Iterator[str]:
    """Cut a text at the commas before another field, outside quotes, tables and lists."""
    depth, quote, begin = 0, "", 0
    for place, sign in enumerate(text):
        if quote:
            quote = "" if sign == quote else quote
        elif sign in _QUOTES:
            quote = sign
        elif sign in _OPENING:
            depth += 1
        elif sign in _CLOSING:
            depth -= 1
        elif sign == "," and depth == 0 and _NEXT.match(text, place + 1):
            yield text[begin:place]
            begin = place + 1
    yield text[begin:]


def _flat(changes: Mapping[str, Any], table: str) -> Iterator[tuple[str, Any]]:
    """Give tables in tables, as TOML makes of dotted keys, by the names of their fields.

    A table by its dotted name stays whole: it takes the place of the case's.
    """
    for key, value in changes.items():
        name = f"{table}{key}"
        if isinstance(value, Mapping) and "." not in key and not _is_named(name):
            yield from _flat(value, f"{name}.")
        else:
            yield name, value


def _is_named(name: str) -> bool:
    """Whether a table is a field by itself, or none of the case's: a material, say."""
    known = fields_of(Case)
    return name in known or not any(other.startswith(f"{name}.") for other in known)
