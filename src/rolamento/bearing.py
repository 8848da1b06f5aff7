"""The internal geometry of one row of balls."""

from __future__ import annotations

import math
from typing import Annotated, Self

from pydantic import Field, model_validator

from rolamento._quantity import Count, Quantity, Ratio
from rolamento._record import Record
from rolamento.errors import InputError
from rolamento.material import DEFAULT_MATERIAL, Material, MaterialField
from rolamento.units import from_si

__all__ = ["Bearing"]

_Conformity = Annotated[float, Ratio(at_least=0.501, at_most=1.0)]
_ShoulderHeight = Annotated[float, Quantity("length", above="0 mm", at_most="1 m")]


class Bearing(Record):
    """One row of balls between two grooved rings, by its internal geometry.

    Exactly one of `contact_angle` and `diametral_clearance` is given: the first for an
    angular-contact bearing, whose axial displacement then counts from first contact,
    the second for a deep-groove bearing, whose axial displacement counts from the
    centred position.

    Parameters
    ----------
    ball_count
        Z, balls in the row, 3 to 500.
    ball_diameter
        D, in m.
    pitch_diameter
        d_m, diameter of the circle of ball centres, in m.
    contact_angle
        α, free contact angle, in rad, 0 ≤ α < π/2.
    diametral_clearance
        P_d, in m; negative for an interference.
    inner_conformity, outer_conformity
        f_i, f_o, groove radius over ball diameter, 0.501 to 1.
    ring_material
        A `Material`, its name or its table; 100Cr6 if not given.
    ball_material
        Likewise; the rings' material if not given.
    inner_shoulder_height, outer_shoulder_height
        Height of the shoulder above the bottom of the groove, in m; without it, nobody
        checks whether the contact runs over the shoulder.

    Raises
    ------
    InputError
        If a value is missing or out of range, or the values contradict each other.
    """

    ball_count: Annotated[int, Count] = Field(strict=True, ge=3, le=500, examples=[16])
    ball_diameter: Annotated[float, Quantity("length", at_least="0.01 mm", at_most="1 m")] = Field(
        examples=["22.23 mm"]
    )
    pitch_diameter: Annotated[float, Quantity("length", at_least="0.01 mm", at_most="20 m")] = (
        Field(examples=["125.26 mm"])
    )
    contact_angle: Annotated[float, Quantity("angle", at_least="0 deg", below="90 deg")] | None = (
        Field(None, examples=["40 deg"])
    )
    diametral_clearance: (
        Annotated[float, Quantity("length", at_least="-1 m", at_most="1 m")] | None
    ) = Field(None, examples=["0.015 mm"])
    inner_conformity: _Conformity = Field(examples=[0.5232])
    outer_conformity: _Conformity = Field(examples=[0.5232])
    ring_material: MaterialField = Field(default_factory=lambda: Material.named(DEFAULT_MATERIAL))
    ball_material: MaterialField = Field(default_factory=lambda data: data["ring_material"])
    inner_shoulder_height: _ShoulderHeight | None = Field(None, examples=["4.5 mm"])
    outer_shoulder_height: _ShoulderHeight | None = Field(None, examples=["4.5 mm"])

    @model_validator(mode="after")
    def _consistent(self) -> Self:
        self._check_that_balls_fit()
        self._check_angle_or_clearance()
        self._check_clearance()
        self._check_shoulders()
        return self

    def _check_that_balls_fit(self) -> None:
        """Neighbouring balls touch when D = d_m sin(π/Z)."""
        if self.pitch_diameter <= self.ball_diameter:
            raise InputError(
                f"must be greater than the ball diameter, {from_si(self.ball_diameter, 'length')}",
                field="pitch_diameter",
                value=from_si(self.pitch_diameter, "length"),
                example='pitch_diameter = "125.26 mm"',
            )
        ratio = self.ball_diameter / self.pitch_diameter
        if ratio > math.sin(math.pi / self.ball_count):
            room = math.floor(math.pi / math.asin(ratio))
            raise InputError(
                f"balls of {from_si(self.ball_diameter, 'length')} do not fit on a pitch circle"
                f" of {from_si(self.pitch_diameter, 'length')}: there is room for {room}",
                field="ball_count",
                value=self.ball_count,
                example=f"ball_count = {room}" if room >= 3 else "",
            )

    def _check_angle_or_clearance(self) -> None:
        if self.contact_angle is None and self.diametral_clearance is None:
            raise InputError(
                "is missing: give the contact angle or the diametral clearance",
                field="contact_angle",
                example='contact_angle = "40 deg" or diametral_clearance = "0.015 mm"',
            )
        if self.contact_angle is not None and self.diametral_clearance is not None:
            raise InputError(
                "is given beside the contact angle; each follows from the other, give one",
                field="diametral_clearance",
                value=from_si(self.diametral_clearance, "length"),
                example='diametral_clearance = "0.015 mm" without contact_angle',
            )

    def _check_clearance(self) -> None:
        """Keep cos α = 1 − P_d/(2BD) above 0, and an interference elastic."""
        if self.diametral_clearance is None:
            return
        groove_distance = self.ball_diameter * (self.inner_conformity + self.outer_conformity - 1.0)
        if not -groove_distance / 4 < self.diametral_clearance < 2 * groove_distance:
            least, most = (_rounded_length(f * groove_distance) for f in (-0.25, 2.0))
            raise InputError(
                f"must be greater than {least} and less than {most}"
                " with these balls and conformities",
                field="diametral_clearance",
                value=from_si(self.diametral_clearance, "length"),
                example='diametral_clearance = "0.015 mm"',
            )

    def _check_shoulders(self) -> None:
        for name in ("inner_shoulder_height", "outer_shoulder_height"):
            height = getattr(self, name)
            if height is not None and height >= self.ball_diameter / 2:
                raise InputError(
                    f"must be less than the ball radius, {_rounded_length(self.ball_diameter / 2)}",
                    field=name,
                    value=from_si(height, "length"),
                    example=f'{name} = "{_rounded_length(0.2 * self.ball_diameter)}"',
                )


def _rounded_length(value: float) -> str:
    return from_si(float(f"{value:.4g}"), "length")
