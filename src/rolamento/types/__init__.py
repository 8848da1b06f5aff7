"""The types of bearings: a file each, and one registry; nothing else in the house names a type.

A type says what sets it apart in words that the laws ask for: how its elements are shaped, what
its case files have, by which formula it is rated, what a maker lists of it. Tables of figures by
type (friction, speeds, ratings, clearances) stand in data files, under its key.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final, Literal, get_args

from rolamento.types import (
    angular_contact,
    barrel,
    cylindrical,
    deep_groove,
    double_row,
    double_row_cylindrical,
    four_point,
    full_complement,
    needle,
    self_aligning,
    spherical,
    tapered,
    thrust_ball,
    thrust_cylindrical,
    thrust_tapered,
    toroidal,
)
from rolamento.types._type import BALL, ROLLER, BearingType, Ribs

__all__ = [
    "BALL",
    "BY_ELEMENT",
    "PLAIN_BALLS",
    "PLAIN_ROLLER",
    "ROLLER",
    "TYPES",
    "BearingKey",
    "BearingType",
    "Grooves",
    "Ribs",
    "RollerElement",
    "RollerRings",
    "of_balls",
    "type_of_element",
]

BearingKey = Literal[
    "deep_groove", "angular_contact", "double_row", "four_point", "self_aligning", "thrust",
    "cylindrical", "tapered", "needle", "drawn_cup", "barrel", "spherical", "toroidal",
    "cylindrical_thrust", "tapered_thrust", "full_complement", "double_row_cylindrical",
]  # fmt: skip
"""Keys of the types, as a catalogue has them."""
RollerElement = Literal["cylindrical", "tapered", "needle", "barrel"]
"""What rolls in a row of rollers, as a case file has it."""
PLAIN_ROLLER: Final[RollerElement] = "cylindrical"
"""What rolls in a row of rollers that does not say."""
PLAIN_BALLS: Final[BearingKey] = "deep_groove"
"""What a bearing of a catalogue is that does not say."""
Grooves = Literal["four_point", "self_aligning", "thrust"]
"""What balls roll in, where it is not one groove a ring."""
RollerRings = Literal["spherical", "toroidal", "thrust"]
"""What rollers roll in, where it is not a plain row."""

TYPES: Final[Mapping[str, BearingType]] = MappingProxyType(
    {
        one.key: one
        for one in (
            deep_groove.TYPE,
            angular_contact.TYPE,
            double_row.TYPE,
            four_point.TYPE,
            self_aligning.TYPE,
            thrust_ball.TYPE,
            cylindrical.TYPE,
            tapered.TYPE,
            needle.TYPE,
            needle.DRAWN_CUP,
            barrel.TYPE,
            spherical.TYPE,
            toroidal.TYPE,
            thrust_cylindrical.TYPE,
            thrust_tapered.TYPE,
            full_complement.TYPE,
            double_row_cylindrical.TYPE,
        )
    }
)
"""Every type by its key, in the order in which they are shown."""
assert tuple(TYPES) == get_args(BearingKey)

_BY_RINGS: Final = {(one.element, one.grooves): one for one in TYPES.values() if one.grooves}
BY_ELEMENT: Final[Mapping[str, BearingType]] = MappingProxyType(
    {
        one.element: next(own for own in TYPES.values() if own.element == one.element)
        for one in TYPES.values()
    }
)
"""The plain type of each rolling element, the first of its kind."""


def type_of_element(element: str, kind: str | None = None) -> BearingType:
    """Return the type by what rolls, such as ``"tapered"``, and by the ``kind`` of the rings.

    Where no such rollers roll in such rings, the first type of rollers that has them.
    """
    if kind is None:
        return BY_ELEMENT[element]
    if (element, kind) in _BY_RINGS:
        return _BY_RINGS[element, kind]
    return next(one for one in TYPES.values() if one.has_rollers and one.grooves == kind)


def of_balls(*, angled: bool) -> BearingType:
    """Return the type of a row of balls in plain grooves, by whether it has a contact angle."""
    return angular_contact.TYPE if angled else deep_groove.TYPE
