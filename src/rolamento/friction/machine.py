"""What the models of lubricated machine bearings need beside a solved state."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from rolamento.friction.loaded_balls import LoadedBalls
from rolamento.friction.palmgren import BearingKind, Lubrication, palmgren
from rolamento.friction.skf import SkfConstants, SkfMoment, Supply, skf_moment
from rolamento.friction.torque import Torque
from rolamento.numerics import FloatArray
from rolamento.rows.ball import BatchState
from rolamento.state import State

_SAME_ANGLE: Final = float(np.radians(1.0))


@dataclass(frozen=True, slots=True)
class MachineBearing:
    """Size, rating and lubricant of a bearing, for Palmgren's and SKF's models.

    bore_diameter, outside_diameter m; kinematic_viscosity of the oil, or the grease's base oil,
    at its temperature, m²/s; static_load_rating C_0, N; static_load_ratio P_0/C_0 for Palmgren's
    model (left out without); contact_angle nominal, rad, for angular-contact bearings; constants
    of the series for SKF's model (left out without).
    """

    kind: BearingKind
    bore_diameter: float
    outside_diameter: float
    kinematic_viscosity: float
    static_load_rating: float
    static_load_ratio: float | None = None
    contact_angle: float = 0.0
    lubrication: Lubrication = "grease"
    supply: Supply = "grease"
    oil: str = "mineral"
    constants: SkfConstants | None = None

    @property
    def skf_angle_differs(self) -> bool:
        """Whether SKF's constants for angular-contact bearings are for another contact angle."""
        own = None if self.constants is None else self.constants.contact_angle
        return own is not None and abs(self.contact_angle - own) > _SAME_ANGLE

    @property
    def mean_diameter(self) -> float:
        """d_m of these models, the mean of bore and outside diameter; m."""
        return 0.5 * (self.bore_diameter + self.outside_diameter)


def ring_loads(state: State | BatchState) -> tuple[FloatArray, FloatArray]:
    """Radial and axial load on the bearing, (cases,); N."""
    load = np.asarray([state.load]) if isinstance(state, State) else np.asarray(state.load)
    return np.hypot(load[:, 1], load[:, 2]), np.abs(load[:, 0])


def palmgren_torque(
    state: State | BatchState, balls: LoadedBalls, machine: MachineBearing
) -> Torque | None:
    """Palmgren's torque of the states, or None without a load ratio."""
    if machine.static_load_ratio is None:
        return None
    radial, axial = ring_loads(state)
    return palmgren(
        kind=machine.kind,
        lubrication=machine.lubrication,
        speed=balls.relative_speed[:, 0],
        mean_diameter=machine.mean_diameter,
        kinematic_viscosity=machine.kinematic_viscosity,
        radial_load=radial,
        axial_load=axial,
        static_load_ratio=machine.static_load_ratio,
        contact_angle=machine.contact_angle,
    )


def skf_moment_of(
    state: State | BatchState, balls: LoadedBalls, machine: MachineBearing
) -> SkfMoment | None:
    """SKF's moment of the states, or None without the constants of the series."""
    if machine.constants is None:
        return None
    radial, axial = ring_loads(state)
    return skf_moment(
        machine.constants,
        speed=balls.relative_speed[:, 0],
        bore_diameter=machine.bore_diameter,
        outside_diameter=machine.outside_diameter,
        kinematic_viscosity=machine.kinematic_viscosity,
        radial_load=radial,
        axial_load=axial,
        static_load_rating=machine.static_load_rating,
        supply=machine.supply,
        oil=machine.oil,
    )
