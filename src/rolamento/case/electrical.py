"""Voltage and current across a bearing: the [electrical] table of a case."""

from typing import Annotated

from pydantic import Field

from rolamento.case.quantity import Quantity
from rolamento.case.record import Record

__all__ = ["Electrical"]


class Electrical(Record):
    """Voltage and current across a bearing, and what its lubricant is to them.

    Parameters
    ----------
    voltage
        Between the rings, its peak, in V.
    current
        Through the bearing, its amplitude, in A.
    permittivity
        ε_r of the lubricant; 2.2, of mineral oils, if not given.
    outside_factor
        Capacitance of a whole contact over that of its ellipse; about 2 by what is published.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    voltage: Annotated[float, Quantity("voltage", at_least="0 V", at_most="1e6 V")] | None = Field(
        None, examples=["10 V"]
    )
    current: (
        Annotated[float, Quantity("electric_current", at_least="0 A", at_most="1e6 A")] | None
    ) = Field(None, examples=["0.5 A"])
    permittivity: Annotated[float, Quantity(at_least=1.0, at_most=100.0)] | None = Field(
        None, examples=[2.2]
    )
    outside_factor: Annotated[float, Quantity(at_least=1.0, at_most=10.0)] = Field(
        2.0, examples=[2.0]
    )
