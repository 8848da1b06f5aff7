"""Fault frequencies of a test rig's bearing: the kinematics at equal contact angles, from outside.

At contact angle zero a damaged outer race meets Z balls a turn of the cage, a damaged inner race Z
balls a turn of the shaft against the cage, and a damaged ball strikes a race twice a turn of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from rolamento.kinematics import ball_motion
from rolamento.verification.check import Check, half_unit
from rolamento.verification.published import published

__all__ = ["checks", "multiples"]

_QUANTITIES: Final = {
    "cage": "cage",
    "outer_race": "outer race",
    "inner_race": "inner race",
    "ball": "ball, twice",
}
_ROUNDED: Final = (
    "The tolerance includes what the rounding of the printed diameters leaves open; the contact"
    " angle is zero."
)


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
    """Compare the four multiples of the shaft speed."""
    data = published("case_western")
    ball, pitch = data["ball_diameter_in"], data["pitch_diameter_in"]
    count = data["ball_count"]
    found = multiples(float(ball) / float(pitch), count)
    least = (float(ball) - half_unit(ball)) / (float(pitch) + half_unit(pitch))
    most = (float(ball) + half_unit(ball)) / (float(pitch) - half_unit(pitch))
    ends = [multiples(ratio, count) for ratio in (least, most)]
    for key, printed in data["multiples"].items():
        room = max(abs(end[key] - found[key]) for end in ends)
        yield Check(
            source=data["source"],
            quantity=_QUANTITIES[key],
            unit="1/turn",
            printed=printed,
            computed=found[key],
            tolerance=half_unit(printed) + room,
            explanation=_ROUNDED,
        )
