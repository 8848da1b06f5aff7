"""What a bearing bears at rest: static safety of every contact, launch loads, hardness needed."""

from rolamento.safety.hardening import (
    Hardening,
    case_depth,
    hardening_of,
    hardness_needed,
    rockwell_of_vickers,
    vickers_of_rockwell,
)
from rolamento.safety.launch import Allowable, Launch, launch_of
from rolamento.safety.load_curve import LoadCurve, static_over_load
from rolamento.safety.static_safety import (
    RaceSafety,
    Recommended,
    StaticSafety,
    load_of_rating,
    pressure_limit,
    recommended_safety,
    static_safety_of,
    stress_safety,
)

__all__ = [
    "Allowable",
    "Hardening",
    "Launch",
    "LoadCurve",
    "RaceSafety",
    "Recommended",
    "StaticSafety",
    "case_depth",
    "hardening_of",
    "hardness_needed",
    "launch_of",
    "load_of_rating",
    "pressure_limit",
    "recommended_safety",
    "rockwell_of_vickers",
    "static_over_load",
    "static_safety_of",
    "stress_safety",
    "vickers_of_rockwell",
]
