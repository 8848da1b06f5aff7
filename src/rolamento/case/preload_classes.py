"""Preload classes as makers list them for matched pairs of their bearings.

The lists, with their sources, are in data/preloads.toml.
"""

from __future__ import annotations

from functools import cache
from math import degrees
from typing import Final, Literal

from rolamento.errors import InputError, nearest
from rolamento.io.data import toml_of
from rolamento.units import to_si
from rolamento.words import said

__all__ = ["Level", "listed_designations", "listed_preload"]

Level = Literal["extra_light", "light", "medium", "heavy"]

_SAME_ANGLE: Final = 1.5
"""Degrees by which a bearing's contact angle may differ from the listed nominal one."""


def listed_preload(designation: str, level: Level, contact_angle: float | None) -> float:
    """Return the axial preload of a pair, in N.

    Parameters
    ----------
    designation
        As the maker writes it; case and spaces do not matter.
    level
        The class.
    contact_angle
        Nominal, in rad: some designations are made with several.

    Raises
    ------
    InputError
        If no list has the designation, or not at this angle, or not this class.
    """
    records = _records().get(_folded(designation))
    if records is None:
        near = nearest(designation, listed_designations())
        raise InputError(
            said("is in no maker's list of preloads; did you mean {near}?", near=near)
            if near
            else said("is in no maker's list of preloads; give the preload as a force"),
            field="designation",
            value=designation,
            example='designation = "S 6012 C", or preload = "500 N"',
        )
    nominal = [degrees(to_si(record["contact_angle"], "angle")) for record in records]
    given = None if contact_angle is None else degrees(contact_angle)
    for record, angle in zip(records, nominal, strict=True):
        if given is not None and abs(angle - given) <= _SAME_ANGLE:
            if level not in record:
                raise InputError(
                    said("has no such class of preload in its maker's list"),
                    field="level",
                    value=level,
                    example='level = "light"',
                )
            return to_si(record[level], "force")
    angles = ", ".join(f"{angle:g} deg" for angle in nominal)
    raise InputError(
        said("is listed for contact angles of {angles} only", angles=angles),
        field="designation",
        value=designation,
        example='contact_angle = "15 deg", or preload = "500 N"',
    )


def listed_designations() -> tuple[str, ...]:
    """Return the designations of all lists, as their makers write them."""
    names = (record["designation"] for records in _records().values() for record in records)
    return tuple(dict.fromkeys(names))


def _folded(designation: str) -> str:
    return "".join(designation.split()).casefold()


@cache
def _records() -> dict[str, list[dict[str, str]]]:
    """The lines of all lists, in the units that they are written in."""
    found: dict[str, list[dict[str, str]]] = {}
    for maker in toml_of("preloads")["maker"]:
        for line in maker["bearings"]:
            found.setdefault(_folded(line["designation"]), []).append(line)
    return found
