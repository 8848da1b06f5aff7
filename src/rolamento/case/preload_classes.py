"""Preload classes as makers list them for matched pairs of their bearings.

The lists, with their sources, are in data/preloads.toml.
"""

from __future__ import annotations

from functools import cache
from math import degrees
from typing import Final, Literal, cast, get_args

from rolamento.errors import InputError, nearest
from rolamento.io.data import toml_of
from rolamento.units import to_si
from rolamento.words import Written, said

__all__ = ["Level", "level_of_force", "listed_designations", "listed_preload"]

Level = Literal["extra_light", "light", "medium", "heavy", "A", "B", "C", "D"]
"""Classes of preload: A to D, from the lightest on, are SKF's of its spindle bearings."""

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
                known = [name for name in get_args(Level) if name in record]
                raise InputError(
                    said("is no class of its maker's list: {known}", known=", ".join(known)),
                    field="level",
                    value=level,
                    example=f'level = "{known[0]}", or preload = "500 N"',
                )
            return to_si(record[level], "force")
    angles = [Written(f"{angle:g} deg") for angle in nominal]
    raise InputError(
        said("is listed for contact angles of {angles} only", angles=angles),
        field="designation",
        value=designation,
        example='contact_angle = "15 deg", or preload = "500 N"',
    )


def level_of_force(force: float, dynamic_rating: float, contact_angle: float) -> Level | None:
    """Return the lightest class whose preloads reach up to a force; None beyond the heaviest.

    Parameters
    ----------
    force
        Axial preload of a pair of angular-contact ball bearings, N.
    dynamic_rating
        C of one of them, N.
    contact_angle
        Nominal, rad: 15° or 25°, else None is returned.

    By the greatest F/C of each class in the lists of SNFA and GMN; no maker prints such a rule.
    """
    for row in toml_of("preloads")["share_of_dynamic_rating"]:
        if abs(degrees(contact_angle - to_si(row["contact_angle"], "angle"))) > _SAME_ANGLE:
            continue
        if force <= row["high"] * dynamic_rating:
            return cast("Level", row["class"])
    return None


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
