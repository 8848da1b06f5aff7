"""Fault frequencies of bearings whose vibration records are public, as printed with the records.

What a user will compare first. The dimensions are printed with few digits; where these give the
printed frequency to its last digit nothing more is allowed, else what their rounding leaves open.
The multiples of Case Western Reserve University come from the kinematics alone: at contact angle
zero a damaged outer race meets Z balls a turn of the cage, a damaged inner race Z balls a turn of
the shaft against the cage, and a damaged ball strikes a race twice a turn of its own.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product
from math import radians
from typing import Any, Final

from rolamento.kinematics import ball_motion
from rolamento.verification.check import Check, half_unit, published
from rolamento.vibration.frequencies import LineName, line_orders, turns_of
from rolamento.words import Note

_MULTIPLES: Final = {
    "cage": "cage",
    "outer_race": "outer race",
    "inner_race": "inner race",
    "ball": "ball, twice",
}
ROUNDED: Final = Note("verify_rigs_rounded")
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


def case_western_checks() -> Iterator[Check]:
    """Compare the four multiples of the shaft speed of both bearings."""
    for bearing in published("case_western")["bearing"]:
        yield from _case_western_bearing(bearing)


def _case_western_bearing(bearing: Mapping[str, Any]) -> Iterator[Check]:
    ball, pitch = bearing["ball_diameter_in"], bearing["pitch_diameter_in"]
    count = bearing["ball_count"]
    found = multiples(float(ball) / float(pitch), count)
    low = (float(ball) - half_unit(ball)) / (float(pitch) + half_unit(pitch))
    high = (float(ball) + half_unit(ball)) / (float(pitch) - half_unit(pitch))
    ends = [multiples(ratio, count) for ratio in (low, high)]
    for key, printed in bearing["multiples"].items():
        room = max(abs(end[key] - found[key]) for end in ends)
        yield Check(
            source=bearing["source"],
            quantity=_MULTIPLES[key],
            unit="1/turn",
            printed=printed,
            computed=found[key],
            tolerance=half_unit(printed) + room,
            explanation=ROUNDED,
        )


_FREQUENCIES: Final[Mapping[LineName, str]] = {
    "cage": "cage",
    "ball_pass_outer": "outer race",
    "ball_pass_inner": "inner race",
    "ball_spin": "f_b",
    "ball_spin_twice": "ball, twice",
}
_RPM_PER_HERTZ: Final = 60.0


def frequency(rig: Mapping[str, Any], line: LineName, **changes: float) -> float:
    """Return a fault frequency of a rig's bearing: Hz, or over the shaft's if no speed is given.

    Parameters
    ----------
    rig
        Of the data file.
    line
        Which frequency.
    changes
        To be taken instead of what is printed: ball_diameter, pitch_diameter, contact_angle_deg.
    """
    given = {"contact_angle_deg": 0.0} | dict(rig) | changes
    ratio = float(given["ball_diameter"]) / float(given["pitch_diameter"])
    turns = turns_of(ratio, radians(float(given["contact_angle_deg"])))
    order = abs(line_orders(turns, int(given["ball_count"]))[line])
    return order * float(given.get("speed_rpm", _RPM_PER_HERTZ)) / _RPM_PER_HERTZ


def room_of_rounding(rig: Mapping[str, Any], line: LineName) -> float:
    """Return how far a frequency may be off, because the dimensions are rounded; as `frequency`."""
    found = frequency(rig, line)
    names = [
        name for name in ("ball_diameter", "pitch_diameter", "contact_angle_deg") if name in rig
    ]
    ends = [
        (float(rig[name]) - half_unit(rig[name]), float(rig[name]) + half_unit(rig[name]))
        for name in names
    ]
    corners = (dict(zip(names, corner, strict=True)) for corner in product(*ends))
    return max(abs(frequency(rig, line, **corner) - found) for corner in corners)


def rig_checks() -> Iterator[Check]:
    """Compare every printed frequency of every rig."""
    for rig in published("rigs")["rig"]:
        for line, printed in rig["printed"].items():
            yield _rig_check(rig, line, printed)


def _rig_check(rig: Mapping[str, Any], line: LineName, printed: str) -> Check:
    found, tolerance = frequency(rig, line), half_unit(printed)
    exact = abs(found - float(printed)) <= tolerance
    return Check(
        source=rig["source"],
        quantity=_FREQUENCIES[line],
        unit="Hz" if "speed_rpm" in rig else "1/turn",
        printed=printed,
        computed=found,
        tolerance=tolerance if exact else tolerance + room_of_rounding(rig, line),
        explanation=None if exact else ROUNDED,
    )
