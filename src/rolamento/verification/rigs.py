"""Fault frequencies of bearings whose vibration records are public, as printed with the records.

What a user will compare first. The dimensions are printed with few digits; where these give the
printed frequency to its last digit nothing more is allowed, else what their rounding leaves open.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product
from math import radians
from typing import Any, Final

from rolamento.verification.case_western import ROUNDED
from rolamento.verification.check import Check, half_unit
from rolamento.verification.published import published
from rolamento.vibration.frequencies import LineName, line_orders, turns_of

__all__ = ["checks", "frequency", "room_of_rounding"]

_QUANTITIES: Final[Mapping[LineName, str]] = {
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


def checks() -> Iterator[Check]:
    """Compare every printed frequency of every rig."""
    for rig in published("rigs")["rig"]:
        for line, printed in rig["printed"].items():
            yield _check(rig, line, printed)


def _check(rig: Mapping[str, Any], line: LineName, printed: str) -> Check:
    found, tolerance = frequency(rig, line), half_unit(printed)
    exact = abs(found - float(printed)) <= tolerance
    return Check(
        source=rig["source"],
        quantity=_QUANTITIES[line],
        unit="Hz" if "speed_rpm" in rig else "1/turn",
        printed=printed,
        computed=found,
        tolerance=tolerance if exact else tolerance + room_of_rounding(rig, line),
        explanation="" if exact else ROUNDED,
    )
