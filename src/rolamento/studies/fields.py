"""The fields of a case, or of a machine, that a study may vary."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Final

from rolamento.case import Case
from rolamento.case.fields import Field, Value
from rolamento.case.hints import LISTED, hint
from rolamento.case.machine_fields import field_of_machine, is_of_part
from rolamento.errors import InputError, UnknownKeyError
from rolamento.words import said

__all__ = ["Field", "Value", "known_fields", "read_field", "read_varied", "refuse_rivals"]

_MOST_NAMED: Final = 12
"""Maximum number of the fields of a table, in a message."""
_LABELS: Final = ("title", "name", "source")
"""Last parts of the names of fields that change nothing."""


@cache
def known_fields() -> Mapping[str, Field]:
    """Return the fields of a case that a study may vary, by their dotted names."""
    return {
        name: field
        for name, field in Case.fields().items()
        if field.kind != "list" and field.leaf not in _LABELS
    }


def no_range(name: str) -> str:
    """Say that a field takes no range; of a table that may be given as text, which of its do."""
    inside = (one for one, field in known_fields().items() if field.continuous)
    inner = next((one for one in inside if one.startswith(f"{name}.")), "")
    return said("takes no range; {inner} does", inner=inner) if inner else said("takes no range")


def read_field(name: str, *, at: str = "field") -> Field:
    """Return the field of a name.

    Parameters
    ----------
    name
        Dotted.
    at
        Where the study has it, for the message.

    Raises
    ------
    UnknownKeyError
        If no case has it; the message gives the nearest one.
    """
    known = known_fields()
    field = known.get(name)
    if field is not None:
        return field
    raise UnknownKeyError(
        said("is not a field that can be varied; {guess}", guess=_advice(name, known)),
        field=at,
        value=name,
        example='"duty.load.fx"',
    )


def read_varied(name: str, *, at: str = "field") -> Field:
    """Return the field of a name, of a case or of a part of a machine; as `read_field`."""
    if not is_of_part(name):
        return read_field(name, at=at)
    field = field_of_machine(name)
    if field is None:
        raise UnknownKeyError(
            said("is not a field of a machine; rolamento sweep STUDY --list fields lists them all"),
            field=at,
            value=name,
            example='"loads.0.fz"',
        )
    return field


def _advice(name: str, known: Mapping[str, Field]) -> str:
    inside = [other for other in known if other.startswith(f"{name}.")]
    if inside:
        more = ("…",) if len(inside) > _MOST_NAMED else ()
        return said("it is a table with {fields}", fields=", ".join((*inside[:_MOST_NAMED], *more)))
    return hint(name, known, known, said(LISTED))


def refuse_rivals(names: tuple[str, ...], *, at: str) -> None:
    """Refuse to vary two fields of which a case takes one.

    Raises
    ------
    UnknownKeyError
        As of `read_varied`.
    InputError
        Naming both.
    """
    fields = [read_varied(name, at=at) for name in names]
    for index, field in enumerate(fields):
        for before in names[:index]:
            if before in field.rivals:
                raise InputError(
                    said("cannot be combined with {before}", before=before),
                    field=at,
                    value=field.name,
                )
