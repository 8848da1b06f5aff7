"""What a grease has to bear beside heat, load and speed: the [grease] table of a case."""

from typing import Annotated, Literal

from pydantic import Field

from rolamento.case.quantity import Quantity
from rolamento.case.record import Record

__all__ = ["BaseOil", "Grease", "Thickener"]

Thickener = Literal["lithium", "urea"]
BaseOil = Literal["mineral", "pao", "ester", "diester", "silicone", "ether"]


class Grease(Record):
    """The grease of a bearing and how it is kept, for its life and its relubrication.

    What is not given is inferred, with a note in the result.

    Parameters
    ----------
    thickener
        Soap: ``"lithium"`` or ``"urea"``; lithium if not given.
    base_oil
        ``"mineral"``, ``"pao"``, ``"ester"``, ``"diester"``, ``"silicone"`` or ``"ether"``; if not
        given by `lubricant.oil_type`: mineral, of synthetic ones PAO.
    sealed
        Whether shields or seals on both sides keep the grease in; by the designation if not given.
    vertical_shaft
        Whether the shaft stands upright.
    limiting_speed
        N of the maker for this bearing with grease, in rad/s; that of the maker's class of its
        series if not given.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    thickener: Thickener | None = Field(None, examples=["lithium"])
    base_oil: BaseOil | None = Field(None, examples=["mineral"])
    sealed: bool | None = Field(None, strict=True, examples=[True])
    vertical_shaft: bool = Field(False, strict=True, examples=[True])
    limiting_speed: (
        Annotated[float, Quantity("angular_speed", above="0 rpm", at_most="1e6 rpm")] | None
    ) = Field(None, examples=["6700 rpm"])
