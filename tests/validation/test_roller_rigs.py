"""Roller bearings of test rigs: the records of bearings against the frequencies that are printed.

The numbers, with their sources and how they were come by, are in
`rolamento/verification/data/rigs.toml`; here the bearing is a record with its cones.
"""

from __future__ import annotations

from math import pi, radians
from typing import Any

import pytest

from rolamento.case.roller_bearing import RollerBearing
from rolamento.geometry import apex_half_angle
from rolamento.verification.check import half_unit, published
from rolamento.vibration.frequencies import nominal_frequencies

RIGS = [rig for rig in published("rigs")["rig"] if "ZA-2115" in rig["source"]]
INCH = 0.0254


def bearing(rig: dict[str, Any], *, of_axis: bool) -> RollerBearing:
    """The tapered bearing with the printed angle as that of its rollers' axis, or of its cup."""
    roller, pitch = float(rig["ball_diameter"]) * INCH, float(rig["pitch_diameter"]) * INCH
    printed = outer = radians(float(rig["contact_angle_deg"]))
    if of_axis:  # the half angle of one apex then puts the axis at the printed angle
        for _ in range(20):
            outer = printed + float(apex_half_angle(roller, pitch, outer))
    return RollerBearing(
        element="tapered",
        roller_count=int(rig["ball_count"]),
        roller_diameter=roller,
        effective_length=roller,
        pitch_diameter=pitch,
        contact_angle=outer,
        roller_half_angle=float(apex_half_angle(roller, pitch, outer)),
    )


@pytest.mark.parametrize("rig", RIGS, ids=lambda rig: rig["source"])
def test_the_frequencies_of_rexnord_za_2115(rig: dict[str, Any]) -> None:
    """Printed to the last digit by the mean angle of the rollers, as users of the records take it.

    By the same angle as that of the cup the outer race would be 0.09 % lower: 236.2 Hz.
    """
    speed = float(rig["speed_rpm"]) * pi / 30.0
    for line, printed in rig["printed"].items():
        found = nominal_frequencies(bearing(rig, of_axis=True), speed).lines[line].frequency
        assert abs(found - float(printed)) <= half_unit(printed)
        cup = nominal_frequencies(bearing(rig, of_axis=False), speed).lines[line].frequency
        assert 1e-4 < abs(cup / found - 1.0) < 1e-3


def test_there_are_roller_bearings_to_compare() -> None:
    assert len(RIGS) == 3
