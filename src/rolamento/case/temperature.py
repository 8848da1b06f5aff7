"""How warm a bearing runs: the [temperature] table of a case."""

from typing import Annotated, Final

from pydantic import Field

from rolamento.case.quantity import Quantity
from rolamento.case.record import Record

__all__ = ["Temperature"]

_OF_BEARING: Final = ("inner_ring", "outer_ring", "balls")
_Celsius = Annotated[
    float, Quantity("temperature", at_least="-100 degC", at_most="400 degC", varies=True)
]


class Temperature(Record):
    """Temperatures in operation.

    Parameters
    ----------
    lubricant
        Of the lubricant as it enters the contacts, in K; in files in °C. Film, friction and life
        need it; the clearance in operation does not.
    inner_ring, outer_ring
        Of the rings, for the clearance of a mounted bearing, as at assembly if not given; and for
        the life, which plain bearing steel has up to 120 °C.
    balls
        Those of the inner ring if not given.
    shaft, housing
        At their seats, and along the distance of the rows of a set; those of their rings if not
        given.
    inner_spacer, outer_spacer
        Of the spacers between the rows of a set; those of shaft and housing if not given.

    Raises
    ------
    InputError
        If a value is missing or out of range.
    """

    lubricant: _Celsius | None = Field(None, examples=["70 degC"])
    inner_ring: _Celsius | None = Field(None, examples=["75 degC"])
    outer_ring: _Celsius | None = Field(None, examples=["68 degC"])
    balls: _Celsius | None = Field(None, examples=["75 degC"])
    shaft: _Celsius | None = Field(None, examples=["75 degC"])
    housing: _Celsius | None = Field(None, examples=["60 degC"])
    inner_spacer: _Celsius | None = Field(None, examples=["75 degC"])
    outer_spacer: _Celsius | None = Field(None, examples=["62 degC"])

    @property
    def of_bearing(self) -> "Temperature":
        """Those of the bearing and its lubricant, without the seats."""
        kept = {name: getattr(self, name) for name in ("lubricant", *_OF_BEARING)}
        return Temperature(**{name: warm for name, warm in kept.items() if warm is not None})
