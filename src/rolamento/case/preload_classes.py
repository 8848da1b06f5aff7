"""Preload classes as makers list them for matched pairs of their bearings.

The lists, with their sources, are in data/preloads.toml.
"""

from __future__ import annotations

from functools import lru_cache
from math import degrees
from typing import Any, Final, Literal, get_args

from rolamento._data import toml_of
from rolamento.errors import InputError, nearest
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
    given = None if contact_angle is None else degrees(contact_angle)
    for record in records:
        if given is not None and abs(record["angle"] - given) <= _SAME_ANGLE:
            if level not in record:
                raise InputError(
                    said("has no such class of preload in its maker's list"),
                    field="level",
                    value=level,
                    example='level = "light"',
                )
            return float(record[level])
    angles = ", ".join(f"{record['angle']:g} deg" for record in records)
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


@lru_cache(maxsize=1)
def _records() -> dict[str, list[dict[str, Any]]]:
    found: dict[str, list[dict[str, Any]]] = {}
    for maker in toml_of("preloads")["maker"]:
        for line in maker["bearings"]:
            record = {
                "designation": line["designation"],
                "angle": degrees(to_si(line["contact_angle"], "angle")),
                **{
                    level: to_si(line[level], "force") for level in get_args(Level) if level in line
                },
            }
            found.setdefault(_folded(line["designation"]), []).append(record)
    return found
