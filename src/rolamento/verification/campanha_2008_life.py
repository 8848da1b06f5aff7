"""The rating factor of measured grooves and the rating life that Campanha prints."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from rolamento.life.iso281 import basic_rating_life, hours
from rolamento.ratings import dynamic_factor_of_grooves
from rolamento.verification.check import Check
from rolamento.verification.published import RPM, published

__all__ = ["checks"]

_ROUNDED_GROOVE: Final = (
    "The author rounds the inner groove's radius to 5.21 mm; the outer conformity is 0.53. The"
    " standard raises no rating for closer grooves: this factor is theory."
)
_BALL: Final = 25.4 * 13.0 / 32.0
"""mm: 13/32 in, which the text rounds to 10.319 mm."""
_ROUNDING: Final = 0.5
"""Of f_c: what a hundredth of a millimetre of the groove makes."""


def checks() -> Iterator[Check]:
    """Compare f_c of the measured grooves and L_10 in hours."""
    data = published("campanha_2008")
    bearing, life = data["bearing_6305"], data["life"]
    diameter = bearing["ball_diameter_mm"]
    gamma = diameter / bearing["pitch_diameter_mm"]
    outer = life["outer_conformity"]
    rounded = life["groove_radius_mm"] / _BALL
    yield Check(
        source=life["source"],
        quantity="f_c",
        unit="",
        printed=life["factor_of_measured_grooves"],
        computed=float(dynamic_factor_of_grooves(gamma, life["measured_conformity"], outer)),
        explanation=_ROUNDED_GROOVE,
        deviation=_ROUNDING,
        evidence=float(
            dynamic_factor_of_grooves(_BALL / bearing["pitch_diameter_mm"], rounded, outer)
        ),
    )
    basic = basic_rating_life(life["dynamic_rating_N"], life["load_N"])
    yield Check(
        source=life["source_of_life"],
        quantity="L_10h",
        unit="h",
        printed=life["basic_life_h"],
        computed=float(hours(basic, life["speed_rpm"] * RPM)),
    )
