"""Figures: functions that take records and Axes, and return the Axes. No physics here.

>>> from rolamento.plots import load_rosette, save_figure
>>> save_figure(load_rosette(rolamento.solve("case.toml")), "rosette.png")  # doctest: +SKIP

Names are imported when they are first used: matplotlib is not loaded until then.
"""

from __future__ import annotations

import importlib
from typing import Any, Final

_NAMES_OF_MODULES: Final = {
    "anderon": ("noise_bands", "noise_figure", "noise_trend_figure"),
    "balls": ("ball_loads", "compared_states", "contact_angles", "load_rosette", "pressures"),
    "cage_turn": ("cage_turn_figure",),
    "curves": ("contact_angle_over_speed", "load_displacement", "stiffness_over_speed"),
    "ellipses": ("contact_ellipses", "ellipses_of_both_races"),
    "friction": ("friction_figure",),
    "grease": ("grease_figure",),
    "heat": (
        "heat_figure",
        "heat_over_figure",
        "heat_time_figure",
        "heat_variants_figure",
        "machine_heat_figure",
    ),
    "history": ("records_figure", "then_figure"),
    "life": (
        "aiso_chart",
        "helps_figure",
        "life_figure",
        "life_over_zone",
        "load_over_life",
        "load_zone_figure",
        "sn_figure",
        "what_helps",
    ),
    "machine": (
        "campbell_figure",
        "draw_bearings_in_place",
        "draw_deflection",
        "draw_section_forces",
        "machine_figure",
        "machine_over_figure",
        "modes_figure",
        "response_figure",
    ),
    "machine_drawing": ("draw_machine",),
    "oscillation": ("oscillation_figure",),
    "replace": ("cost_of_ages_figure", "fleet_failures_figure", "remaining_life_figure"),
    "roller": (
        "compared_rollers",
        "pressure_along_rollers",
        "pressures_of_both_races",
        "roller_between_races",
    ),
    "saving": ("save_figure",),
    "service_life": ("service_life_figure",),
    "severity": ("severity_figure", "severity_trend_figure", "zone_bars"),
    "slip": ("slip_map", "slip_maps"),
    "static": ("static_figure",),
    "sweep": (
        "compared_histograms",
        "compared_lines",
        "study_histogram",
        "study_lines",
        "study_map",
        "study_scatter",
    ),
    "tolerance": ("tolerance_figure",),
    "trend": ("trend_figure",),
    "vibration": (
        "diagnosis_figure",
        "envelope_figure",
        "impacts_figure",
        "kurtogram_figure",
        "waveform_figure",
    ),
    "vibration_modulation": ("modulation_figure",),
    "weibull": ("contour_figure", "weibull_figure"),
    "weibull_plan": ("chance_figure", "cost_figure"),
}
_MODULE_OF_NAME: Final = {
    name: module for module, names in _NAMES_OF_MODULES.items() for name in names
}


def __getattr__(name: str) -> Any:
    module = _MODULE_OF_NAME.get(name)
    if module is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(importlib.import_module(f"{__name__}.{module}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(_MODULE_OF_NAME)
