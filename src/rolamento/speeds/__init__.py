"""What limits the speed of a bearing, and what load keeps its elements rolling.

A file a question: heat in balance under reference conditions (`reference`) and under one's own
(`permissible`), a maker's experience (`class_of_maker`) and what preload, sets and ceramic balls
make of it (`speed_factors`), the load that keeps balls and rollers from sliding (`minimum_load`).
See docs/theory/speeds.md.
"""

from rolamento.speeds.class_of_maker import SpeedClass, speed_class
from rolamento.speeds.minimum_load import (
    GeneralShare,
    general_minimum_shares,
    minimum_axial_load,
    minimum_axial_load_of_thrust,
    minimum_load_factors,
    minimum_radial_load,
    minimum_radial_load_of_rollers,
    minimum_share,
    minimum_share_source,
    minimum_static_share,
    roller_load_factor,
)
from rolamento.speeds.permissible import HeatShares, heat_shares, speed_ratio
from rolamento.speeds.reference import (
    ReferenceCoefficients,
    reference_coefficients,
    reference_heat_flow,
    thermal_reference_speed,
)
from rolamento.speeds.speed_factors import SpeedFactor, ceramic_factor, set_factor

__all__ = [
    "GeneralShare",
    "HeatShares",
    "ReferenceCoefficients",
    "SpeedClass",
    "SpeedFactor",
    "ceramic_factor",
    "general_minimum_shares",
    "heat_shares",
    "minimum_axial_load",
    "minimum_axial_load_of_thrust",
    "minimum_load_factors",
    "minimum_radial_load",
    "minimum_radial_load_of_rollers",
    "minimum_share",
    "minimum_share_source",
    "minimum_static_share",
    "reference_coefficients",
    "reference_heat_flow",
    "roller_load_factor",
    "set_factor",
    "speed_class",
    "speed_ratio",
    "thermal_reference_speed",
]
