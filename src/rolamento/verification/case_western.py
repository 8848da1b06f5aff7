"""Fault frequencies of a test rig's bearings: the kinematics at equal contact angles, from outside.

At contact angle zero a damaged outer race meets Z balls a turn of the cage, a damaged inner race Z
balls a turn of the shaft against the cage, and a damaged ball strikes a race twice a turn of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Final

from rolamento.kinematics import ball_motion
from rolamento.verification.check import Check, half_unit
from rolamento.verification.published import published

__all__ = ["ROUNDED", "checks", "multiples"]

_QUANTITIES: Final = {
    "cage": "cage",
    "outer_race": "outer race",
    "inner_race": "inner race",
    "ball": "ball, twice",
}
ROUNDED: Final = (
    "The tolerance includes what the rounding of the printed diameters leaves open; the contact"
    " angle is zero."
)
"""Explanation of checks that allow for it."""


def multiples(diameter_ratio: float, ball_count: int) -> dict[str, float]:
    """Return the fault frequencies over the shaft's, for D/d_m and Z."""
    motion = ball_motion(0.0, 0.0, diameter_ratio, 1.0)
    cage = float(motion.orbital_speed)
    return {
        "cage": cage,
        "outer_race": ball_count * cage,
        "inner_race": ball_count * (1.0 - cage),
        "ball": 2.0 * abs(float(motion.ball_speed)),
    }


def checks() -> Iterator[Check]:
    """Compare the four multiples of the shaft speed of both bearings."""
    for bearing in published("case_western")["bearing"]:
        yield from _checks_of(bearing)


def _checks_of(bearing: Mapping[str, Any]) -> Iterator[Check]:
    ball, pitch = bearing["ball_diameter_in"], bearing["pitch_diameter_in"]
    count = bearing["ball_count"]
    found = multiples(float(ball) / float(pitch), count)
    least = (float(ball) - half_unit(ball)) / (float(pitch) + half_unit(pitch))
    most = (float(ball) + half_unit(ball)) / (float(pitch) - half_unit(pitch))
    ends = [multiples(ratio, count) for ratio in (least, most)]
    for key, printed in bearing["multiples"].items():
        room = max(abs(end[key] - found[key]) for end in ends)
        yield Check(
            source=bearing["source"],
            quantity=_QUANTITIES[key],
            unit="1/turn",
            printed=printed,
            computed=found[key],
            tolerance=half_unit(printed) + room,
            explanation=ROUNDED,
        )
