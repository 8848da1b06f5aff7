"""What is asked of a bearing at rest: the [static] table of a case."""

from typing import Annotated, Literal

from pydantic import Field

from rolamento.case.quantity import Quantity
from rolamento.case.record import Record

__all__ = ["Operation", "Requirement", "Static"]

Operation = Literal["smooth", "normal", "shock"]
Requirement = Literal["unimportant", "normal", "high", "at_rest"]


class Static(Record):
    """Demands on the static safety of a bearing, and what its raceways bear.

    Parameters
    ----------
    operation
        ``"smooth"`` (without vibration), ``"normal"`` or ``"shock"``, for the safety that makers
        recommend.
    requirement
        Of the running, quiet or free of vibration: ``"unimportant"``, ``"normal"``, ``"high"``; or
        ``"at_rest"`` of a bearing that does not turn.
    load_factor
        On the loads of the duty, such as the design factor of a launch load; the preload is not
        multiplied.
    allowable_pressure
        Maximum Hertz pressure that is allowed, in Pa; the margin to it is shown.
    surface_hardness
        Of the raceways, in HRC; below 58 they bear less.
    core_hardness
        Of the core below a hardened case, in HV; 350 if not given.
    case_depth
        Of the hardened case, in m, to compare with what is needed.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    operation: Operation = Field("normal", examples=["shock"])
    requirement: Requirement = Field("normal", examples=["high"])
    load_factor: Annotated[float, Quantity(above=0.0, at_most=1000.0)] = Field(1.0, examples=[1.4])
    allowable_pressure: (
        Annotated[float, Quantity("stress", above="0 MPa", at_most="100 GPa")] | None
    ) = Field(None, examples=["3200 MPa"])
    surface_hardness: Annotated[float, Quantity(at_least=20.0, at_most=68.0)] | None = Field(
        None, examples=[60]
    )
    core_hardness: Annotated[float, Quantity(at_least=100.0, at_most=900.0)] | None = Field(
        None, examples=[350]
    )
    case_depth: Annotated[float, Quantity("length", above="0 mm", at_most="1 m")] | None = Field(
        None, examples=["1.5 mm"]
    )
