"""What the models of lubricated machine bearings need beside a solved state."""

from __future__ import annotations

from dataclasses import dataclass

from rolamento.friction.palmgren import BearingKind, Lubrication
from rolamento.friction.skf import SkfConstants, Supply


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
    def mean_diameter(self) -> float:
        """d_m of these models, the mean of bore and outside diameter; m."""
        return 0.5 * (self.bore_diameter + self.outside_diameter)
