"""Closed static analyses of a ball bearing at rest: radial, axial and combined load.

Each returns a frozen record with a status per load. They stand for themselves and as starting
points; the general equilibrium lives in `rolamento.rows.ball`.
"""

from __future__ import annotations

from rolamento.contact.race import BallBearing, RaceStiffness, race_stiffness
from rolamento.static._common import StaticStatus
from rolamento.static.one_sided import AxialSolution, CombinedSolution, axial_load, combined_load
from rolamento.static.radial import RadialSolution, radial_load
from rolamento.static.sjovall import load_zone_half_angle, sjovall_axial, sjovall_radial

__all__ = [
    "AxialSolution",
    "BallBearing",
    "CombinedSolution",
    "RaceStiffness",
    "RadialSolution",
    "StaticStatus",
    "axial_load",
    "combined_load",
    "load_zone_half_angle",
    "race_stiffness",
    "radial_load",
    "sjovall_axial",
    "sjovall_radial",
]
