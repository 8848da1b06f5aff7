"""What a bearing loses beside its contacts: the [losses] table of a case."""

from typing import Annotated, Literal

from pydantic import Field

from rolamento.case.quantity import Quantity
from rolamento.case.record import Record

__all__ = ["Losses", "Seal"]

Seal = Literal["none", "rsl", "rsh", "rs1", "ls", "cs"]
_Length = Annotated[float, Quantity("length", above="0 mm", at_most="20 m")]


class Losses(Record):
    """Seals and the oil bath of a bearing, for its friction.

    Parameters
    ----------
    seal
        SKF's kind of contact seal: ``"rsl"``, ``"rsh"``, ``"rs1"``, ``"ls"``, ``"cs"``; ``"none"``
        where nothing touches. That of the designation if not given.
    seal_count
        Seals of the bearing, 1 or 2; of the designation, else 2.
    seal_diameter
        Of the counterface on which the lip runs, in m; estimated from the elements if not given.
    seal_moment
        Friction of all seals, in N·m, where it is known, in the place of SKF's formula.
    oil_level
        H of an oil bath above the lowest contact of an element with the outer raceway, in m; with
        it the drag of the bath is counted.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    seal: Seal | None = Field(None, examples=["rs1"])
    seal_count: Literal[1, 2] | None = Field(None, examples=[2])
    seal_diameter: _Length | None = Field(None, examples=["34.3 mm"])
    seal_moment: (
        Annotated[float, Quantity("moment", at_least="0 N mm", at_most="1e6 N m")] | None
    ) = Field(None, examples=["30 N mm"])
    oil_level: Annotated[float, Quantity("length", at_least="0 mm", at_most="20 m")] | None = Field(
        None, examples=["5 mm"]
    )
