"""What pictures of the contacts show, whatever draws them: numbers by race and row, their names."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.charts.axes_units import DEGREE, MEGAPASCAL, ReadableUnit, readable_unit
from rolamento.charts.texts import capitalised
from rolamento.errors import InputError
from rolamento.geometry import Race
from rolamento.records import frozen
from rolamento.solved import NO_LOAD, RACES, Solved, refuse_other
from rolamento.words import said, said_in, worded
from rolamento.words.quantities import called

__all__ = [
    "AROUND",
    "ContactQuantity",
    "QuantityName",
    "Shown",
    "azimuth_name",
    "check_one_case",
    "contact_quantity",
    "free_angle",
    "load_unit",
    "race_name",
    "race_word",
    "refuse_rollers",
    "rows_in_order",
    "touching",
]

Floats = NDArray[np.float64]
QuantityName = Literal["load", "contact_angle", "max_pressure"]

AROUND: Final = ("0°, +z", "45°", "90°\n+y", "135°", "180°", "225°", "270°", "315°")
"""Directions around a bearing seen from +x: +z is up, azimuths run clockwise over +y."""


@frozen(eq=False)
class Shown:
    """A case in a picture.

    Attributes
    ----------
    name
        what the legend calls it; empty if it is alone
    solved
        one case that has a result
    place
        among the cases, from 0; of two it decides how they are drawn
    """

    name: str
    solved: Solved
    place: int = 0

    def named(self, what: str) -> str:
        """Name a line of the case."""
        return said("{case}: {what}", case=self.name, what=what) if self.name else what


class ContactQuantity(NamedTuple):
    """A number of the contacts: its column, what it is called, its unit (None: by its size).

    from_zero: whether its axis begins at zero.
    """

    column: QuantityName
    name: str
    unit: ReadableUnit | None
    from_zero: bool

    def of(self, solved: Solved, race: Race) -> Floats:
        """Return it of a single case, SI, (elements,); of a contact without load 0, else NaN."""
        if self.column == "load":
            return np.asarray(solved.contacts[race].load[0])
        return touching(solved, race, self.column)


def contact_quantity(column: QuantityName) -> ContactQuantity:
    """Return a number of the contacts by its column."""
    units = {"contact_angle": DEGREE, "max_pressure": MEGAPASCAL}
    name, angle = capitalised(called(column)), column == "contact_angle"
    return ContactQuantity(column, name, units.get(column), from_zero=not angle)


def load_unit(cases: Iterable[Solved]) -> ReadableUnit:
    """Return the unit in which the loads of all contacts are read."""
    loads = [solved.contacts[race].load[0] for solved in cases for race in RACES]
    return readable_unit("N", np.concatenate(loads))


def free_angle(solved: Solved) -> float | None:
    """Return the free contact angle (rad) of a single row of balls that has one; else None."""
    bearing = solved.case.bearing
    one = bearing.element == "ball" and bearing.arrangement is None and bearing.rows is None
    return bearing.contact_angle if one else None


def azimuth_name(elements: Iterable[str]) -> str:
    """Name the azimuth of what rolls."""
    return worded(
        elements,
        said("Azimuth of the ball"),
        said("Azimuth of the roller"),
        said("Azimuth of the rolling element"),
    )


def touching(solved: Solved, race: Race, name: str) -> Floats:
    """Return a number of the contacts with a race; NaN where they do not touch; (balls,)."""
    other: Race = "outer" if race == "inner" else "inner"
    own, beside = solved.contacts[race], solved.contacts[other]
    touches = own.load[0] > NO_LOAD * np.abs(beside.load[0])
    return np.where(touches, getattr(own, name)[0], np.nan)


def check_one_case(solved: Solved, figure: str) -> None:
    """Refuse what is not one solved case.

    Raises
    ------
    InputError
        Saying what it must be.
    """
    refuse_other(solved, f"plots.{figure}")
    if len(solved) != 1:
        raise InputError(
            said("must be a single case"), field="solved", value=len(solved), example="solved[0]"
        )


def refuse_rollers(solved: Solved) -> None:
    """Refuse a bearing with rollers, whose contacts are lines.

    Raises
    ------
    InputError
        Naming a figure that suits them.
    """
    if set(solved.rows.element) != {"ball"}:
        raise InputError(
            said("is for ball bearings: rollers touch along lines"),
            field="solved",
            value=", ".join(dict.fromkeys(solved.rows.element)),
            example="pressures_of_both_races(solved)",
        )


def race_word(race: Race) -> str:
    """Name the race in a word."""
    return said_in("race", "inner") if race == "inner" else said_in("race", "outer")


def race_name(race: Race, row: int, rows: int) -> str:
    """Name the race, and the row if there are several."""
    name = race_word(race)
    return name if rows == 1 else said("{race}, row {number}", race=name, number=row)


def rows_in_order(solved: Solved) -> list[NDArray[np.intp]]:
    """Return the elements of each row in order of azimuth, as indices."""
    order = np.argsort(solved.elements.azimuth[0], kind="stable")
    return [order[solved.elements.row[order] == row] for row in range(len(solved.rows))]
