"""Which of the rival models to use, and which effects to leave out."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BeforeValidator, Field

from rolamento._record import Record
from rolamento.errors import InputError

__all__ = ["Model", "RacewayControl"]

RacewayControl = Literal["outer", "inner", "jones", "none"]


def _available(value: object) -> object:
    if value == "friction":
        raise InputError(
            "is not available in this version; use outer, inner, jones or none", value=value
        )
    return value


class Model(Record):
    """Choices of the physical model.

    Parameters
    ----------
    raceway_control
        Which race the ball rolls on without spin: ``"outer"``; ``"inner"``;
        ``"jones"``, where Jones's criterion decides ball by ball; ``"none"``, where
        both races share the gyroscopic moment.
    centrifugal_force
        Whether the balls feel their centrifugal force.
    gyroscopic_moment
        Whether the balls feel their gyroscopic moment.

    Raises
    ------
    InputError
        If a choice is not known.
    """

    raceway_control: Annotated[RacewayControl, BeforeValidator(_available)] = Field(
        "outer", examples=["outer"]
    )
    centrifugal_force: bool = Field(True, strict=True, examples=[True])
    gyroscopic_moment: bool = Field(True, strict=True, examples=[True])
