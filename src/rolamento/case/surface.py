"""How rough the surfaces are that roll on each other: the [surface] table of a case."""

from typing import Annotated, Final, Literal

from pydantic import Field

from rolamento.case.quantity import Quantity
from rolamento.case.record import Record

__all__ = ["RQ_OVER_RA", "RoughnessParameter", "Surface"]

RoughnessParameter = Literal["Rq", "Ra"]

RQ_OVER_RA: Final = 1.25
"""Ratio R_q/R_a of a Gaussian surface: √(π/2), which is used as 1.25 since the meters of old."""

_Roughness = Annotated[float, Quantity("length", above="0 um", at_most="100 um")]


class Surface(Record):
    """Roughness of races and balls; all three by the same parameter.

    Parameters
    ----------
    parameter
        ``"Rq"``, the root mean square, or ``"Ra"``, the mean; Rq is taken as 1.25 Ra.
    inner_roughness, outer_roughness
        Of the races, in m.
    ball_roughness
        Of the balls, in m.

    Raises
    ------
    InputError
        If a value is missing, is zero, or is out of range.
    """

    parameter: RoughnessParameter = Field("Rq", examples=["Rq"])
    inner_roughness: _Roughness = Field(examples=["0.025 um"])
    outer_roughness: _Roughness = Field(examples=["0.025 um"])
    ball_roughness: _Roughness = Field(examples=["0.0225 um"])

    @property
    def inner_combined(self) -> float:
        """Root mean square roughness of ball and inner race together, in m."""
        return self._rms * float((self.inner_roughness**2 + self.ball_roughness**2) ** 0.5)

    @property
    def outer_combined(self) -> float:
        """Root mean square roughness of ball and outer race together, in m."""
        return self._rms * float((self.outer_roughness**2 + self.ball_roughness**2) ** 0.5)

    @property
    def _rms(self) -> float:
        return RQ_OVER_RA if self.parameter == "Ra" else 1.0
