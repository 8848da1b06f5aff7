"""Roller bearings: how a radial load is shared, and the factor of the dynamic rating."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi
from typing import Final

import numpy as np

from rolamento.case import Case
from rolamento.case.duty import Displacement, Duty, Load
from rolamento.case.profile import Profile
from rolamento.case.roller_bearing import RollerBearing
from rolamento.ratings import roller_dynamic_factor
from rolamento.solution import solve
from rolamento.verification.check import Check, half_unit, published
from rolamento.words import Note

_EXPONENT: Final = Note("verify_rollers_exponent")
_EXPONENT_ROOM: Final = 3e-4
"""Relative: what 1.11 in the place of 10/9 makes of the number."""
_LOAD: Final = 1e3


def checks() -> Iterator[Check]:
    """Compare Stribeck's number from 3 to 50 rollers, and f_c over its table."""
    data = published("rollers")
    table = data["stribeck"]
    for count, printed in zip(table["roller_count"], table["numbers"], strict=True):
        yield Check(
            source=table["source"],
            quantity=f"Z Q_max/F_r, Z = {count}",
            unit="",
            printed=printed,
            computed=_stribeck(count),
            tolerance=half_unit(printed) + _EXPONENT_ROOM * float(printed),
            explanation=_EXPONENT,
        )
    table = data["dynamic_factor"]
    for gamma, printed in zip(table["gamma"], table["factors"], strict=True):
        yield Check(
            source=table["source"],
            quantity=f"f_c, γ = {gamma:.2f}",
            unit="",
            printed=printed,
            computed=float(roller_dynamic_factor(gamma)),
        )


def _stribeck(count: int) -> float:
    """Z Q_max/F_r of straight rollers without clearance, in the worse of two places."""
    bearing = RollerBearing(
        roller_count=count,
        roller_diameter=4e-3,
        effective_length=6e-3,
        pitch_diameter=0.12,
        diametral_clearance=0.0,
        roller_profile=Profile(kind="none"),
    )
    duty = Duty(load=Load(fz=_LOAD), displacement=Displacement(x=0.0))
    solved = solve(
        Case(bearing=bearing, duty=duty),
        {"duty.first_ball_azimuth": np.array([0.0, pi / count])},
    )
    return count * float(solved.inner.load.max()) / _LOAD
