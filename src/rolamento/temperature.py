"""How warm a bearing runs: the [temperature] table of a case."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from rolamento._quantity import Quantity
from rolamento._record import Record

__all__ = ["Temperature"]


class Temperature(Record):
    """Temperatures in operation.

    Parameters
    ----------
    lubricant
        Of the lubricant as it enters the contacts, in K; in files in °C.

    Raises
    ------
    InputError
        If the value is missing or out of range.
    """

    lubricant: Annotated[
        float, Quantity("temperature", at_least="-100 degC", at_most="400 degC")
    ] = Field(examples=["70 degC"])
