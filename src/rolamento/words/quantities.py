"""What results are called: each name stands here once, for pages, reports, charts and studies."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from rolamento.words.speaking import marked, said

__all__ = ["CALLED", "called"]

CALLED: Final[Mapping[str, str]] = {
    "load": marked("contact load"),
    "contact_angle": marked("contact angle"),
    "deflection": marked("contact approach"),
    "line_deflection": marked("contact approach, maximum"),
    "semi_major": marked("semi-major axis"),
    "semi_minor": marked("semi-minor axis"),
    "half_length": marked("half the effective length"),
    "half_width": marked("half-width"),
    "pressure": marked("contact pressure"),
    "max_pressure": marked("maximum contact pressure"),
    "mean_pressure": marked("mean contact pressure"),
    "max_shear": marked("maximum shear stress"),
    "max_shear_depth": marked("depth of the maximum shear stress"),
    "orthogonal_shear": marked("orthogonal shear stress"),
    "orthogonal_shear_depth": marked("depth of the orthogonal shear stress"),
    "spin_to_roll": marked("spin-to-roll ratio"),
    "ring_tilt": marked("tilt between the rings"),
    "film_parameter": marked("film parameter λ"),
    "viscosity_ratio": marked("viscosity ratio κ"),
    "contamination_factor": marked("contamination factor e_C"),
    "torque": marked("friction torque"),
    "starting_torque": marked("starting torque"),
    "power": marked("power loss"),
    "rolling_power": marked("power loss in the contacts (friction control)"),
    "cage_speed": marked("cage speed (friction control)"),
    "dynamic_rating": marked("basic dynamic load rating C"),
    "static_rating": marked("basic static load rating C_0"),
    "axial_dynamic_rating": marked("basic dynamic axial load rating C_a"),
    "axial_static_rating": marked("basic static axial load rating C_0a"),
    "fatigue_load_limit": marked("fatigue load limit C_u"),
    "equivalent_load": marked("dynamic equivalent load P"),
    "axial_equivalent_load": marked("dynamic equivalent axial load P_a"),
    "static_equivalent_load": marked("static equivalent load P_0"),
    "axial_static_equivalent_load": marked("static equivalent axial load P_0a"),
    "reference_load": marked("dynamic equivalent reference load P_ref"),
    "static_safety": marked("static safety factor S_0"),
    "load_ratio": marked("load ratio C/P"),
    "velocity": marked("velocity"),
    "acceleration": marked("acceleration"),
    "displacement": marked("displacement"),
    "unknown": marked("signal"),
    "required_life_reliability": marked("reliability at the required life"),
}
"""Names of results, marked; most by what they are called in studies and in JSON."""


def called(quantity: str, *, bound: bool = False) -> str:
    """Return what a result is called, by its name in `CALLED`; bound: of an upper bound."""
    name = said(CALLED[quantity])
    return said("{quantity}, at most", quantity=name) if bound else name
