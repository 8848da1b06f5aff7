"""What the variables of studies are called: inputs, outputs, and the models they are by."""

from __future__ import annotations

import re
from functools import cache
from typing import Final

from rolamento.case import Case
from rolamento.case.machine_fields import field_of_machine
from rolamento.case.variant import AS_GIVEN, settings_in
from rolamento.friction.models import torque_model_name
from rolamento.words import manner, marked, said, speaking
from rolamento.words.theories import theory_name

__all__ = ["OF", "setting_name", "variable_long_name", "variable_name"]

OF: Final = " of "
"""Between an output of a machine and the bearing or shaft that it is of."""

_WHOLE: Final = {
    "residual": marked("residual of the equilibrium, over the scale of its loads"),
    "iterations": marked("Newton iterations"),
    "loaded_balls": marked("number of loaded balls (inner race)"),
    "loaded_rollers": marked("number of loaded rollers (inner race)"),
    "ball": marked("ball"),
    "row": marked("row"),
    "variant": marked("variant"),
    "sample": marked("sample"),
    "azimuth": marked("azimuth of the ball"),
    # rows of a set
    "row_loaded_balls": marked("number of loaded balls (inner race), per row"),
    "preload_at_rest": marked("axial preload at rest"),
    "preload_at_speed": marked("axial preload at speed"),
    "lift_factor": marked("load factor at which the first ball loses contact"),
    "lift_row": marked("row whose ball first loses contact, counted from 0"),
    "loss_factor": marked("load factor at which a row loses contact"),
    "lost_row": marked("row that first loses contact, counted from 0"),
    # film
    "film_parameter": marked("film parameter λ, minimum of all contacts"),
    "viscosity_ratio": marked("viscosity ratio κ"),
    "kinematic_viscosity": marked("kinematic viscosity of the lubricant"),
    # friction
    "hysteresis_torque": marked("friction torque, elastic hysteresis"),
    "rib_torque": marked("friction torque, sliding of rollers at the ribs"),
    "rolling_resistance_torque": marked("friction torque, rolling resistance of the oil"),
    "rolling_power": marked("power loss in the contacts (friction control)"),
    "cage_speed": marked("cage speed (friction control)"),
    # heat
    "warm_inner_ring": marked("temperature of the inner ring (heat balance)"),
    "warm_elements": marked("temperature of the rolling elements (heat balance)"),
    "warm_outer_ring": marked("temperature of the outer ring (heat balance)"),
    "warm_shaft": marked("temperature of the shaft (heat balance)"),
    "warm_housing": marked("temperature of the housing (heat balance)"),
    "warm_power": marked("friction power loss (heat balance)"),
    "warm_preload": marked("axial preload (heat balance)"),
    "warm_max_pressure": marked("maximum contact pressure (heat balance)"),
    "warm_slope": marked("slope of the friction over the heat (heat balance)"),
    # life
    "life_hours": marked("life"),
    "life_revolutions": marked("life in revolutions"),
    "life_valid": marked("life valid (1) or not (0)"),
    "life_upper_bound": marked("life an upper bound (1) or not (0)"),
    "dynamic_rating": marked("basic dynamic load rating C"),
    "static_rating": marked("basic static load rating C_0"),
    "fatigue_load_limit": marked("fatigue load limit C_u"),
    "equivalent_load": marked("equivalent dynamic load P (ISO 281)"),
    "reference_load": marked("equivalent reference load P_ref (ISO/TS 16281)"),
    "static_equivalent_load": marked("equivalent static load P_0"),
    "static_safety": marked("static safety factor S_0 = C_0/P_0"),
    "static_safety_by_stress": marked("static safety by stress, minimum of all contacts"),
    "static_safety_by_load": marked("static safety by load, minimum of all contacts"),
    "oscillation_hours": marked("life in oscillation"),
    "oscillation_critical": marked("critical angle of oscillation"),
    "row_gap": marked("gap of a row at the inner race"),
    "bearing_capacitance": marked("capacitance of the bearing"),
    "current_density": marked("apparent current density"),
    "film_field": marked("electric field across the film"),
    "rating_over_load": marked("load ratio C/P"),
    "contamination_factor": marked("contamination factor e_C"),
    "modification_factor_iso281": marked("life modification factor a_ISO (ISO 281)"),
    "modification_factor_iso16281": marked("life modification factor a_ISO (ISO/TS 16281)"),
    "required_life_reliability": marked("reliability at the required life"),
    "inner_risk_share": marked("share of the inner races in the failure probability"),
    "weakest_race_share": marked("share of the weakest race in the failure probability"),
    "weakest_row": marked("row of the weakest race, counted from 0"),
    # of a machine
    "weakest_bearing": marked("bearing that limits the life, counted from 0"),
    "friction_power": marked("friction power loss"),
    "bearing_status": marked("how the solution ended"),
    "bearing_life_hours": marked("life"),
    "bearing_life_valid": marked("life valid (1) or not (0)"),
    "radial_force": marked("radial force"),
    "axial_force": marked("axial force"),
    "tilting_moment": marked("moment"),
    "ring_tilt": marked("tilt between the rings"),
    "max_pressure": marked("maximum contact pressure"),
    "shaft_deflection": marked("deflection"),
    "shaft_slope": marked("slope"),
    "shaft_bending_moment": marked("bending moment"),
    "shaft_stress": marked("nominal stress"),
    "weakest_ball": marked("heaviest ball on the weakest race, counted from 0"),
}
_QUANTITIES: Final = {
    "load": marked("contact load"),
    "contact_angle": marked("contact angle"),
    "deflection": marked("contact deflection"),
    "semi_major": marked("semi-major axis of the ellipse"),
    "semi_minor": marked("semi-minor axis of the ellipse"),
    "max_pressure": marked("Hertz pressure"),
    "mean_pressure": marked("mean Hertz pressure"),
    "spin_to_roll": marked("spin-to-roll ratio"),
    "centrifugal_force": marked("centrifugal force"),
    "gyroscopic_moment": marked("gyroscopic moment"),
    "orbital_speed": marked("orbital speed"),
    "ball_speed": marked("ball speed about its own axis"),
    "attitude": marked("angle of the ball's axis to the shaft"),
    "central_film_thickness": marked("central film thickness"),
    "minimum_film_thickness": marked("minimum film thickness"),
    "film_parameter": marked("film parameter λ"),
    "entrainment_speed": marked("entrainment speed"),
    "spin_loss": marked("spin power loss"),
    "roller_tilt": marked("tilt of the roller"),
    "rib_force": marked("force of the ribs on the roller"),
    "end_pressure": marked("pressure at the roller's worse end"),
    "edge_ratio": marked("pressure at the roller's worse end over that in the middle"),
    "pressure_slip": marked("maximum of pressure times slip"),
}
_ONLY_LOADED: Final = ("contact_angle", "spin_to_roll")
"""What is taken over the loaded balls alone."""

_STIFFNESS: Final = re.compile(r"stiffness_(r?[xyz])(r?[xyz])")
_OF_BALLS: Final = re.compile(r"(row_)?(?:(max|min|mean)_)?(?:(inner|outer)_)?([a-z_]+)")
_OF_ROW: Final = re.compile(r"row_([fm][xyz])")
_OF_MODEL: Final = re.compile(r"friction_(torque|power)_([a-z_0-9]+)")
_OF_THEORY: Final = re.compile(r"life_(hours|revolutions|valid)_([a-z_0-9]+)")


def variable_name(variable: str, field: str = "") -> str:
    """Return what a variable of a study is called, or nothing if it is not known.

    Parameters
    ----------
    variable
        Such as ``"fx"``, ``"stiffness_zz"`` or ``"max_inner_load"``.
    field
        Dotted name of the field of the case that it holds, if that is known.
    """
    base, of, part = variable.partition(OF)
    if of and (name := variable_name(base)):
        return said("{quantity}, {part}", quantity=name, part=part)
    name = field if field in Case.fields() else _fields_by_leaf().get(variable, "")
    if name:
        return Case.fields()[name].label
    if (own := field_of_machine(field) if field else None) is not None:
        return own.label
    if variable in _WHOLE:
        return said(_WHOLE[variable])
    if match := _STIFFNESS.fullmatch(variable):
        return said("stiffness {load}–{axis}", load=match[1], axis=match[2])
    if match := _OF_MODEL.fullmatch(variable):
        return _of_model(*match.groups())
    if match := _OF_THEORY.fullmatch(variable):
        return _of_theory(*match.groups())
    if match := _OF_ROW.fullmatch(variable):
        return said("{quantity}, per row", quantity=Case.fields()[f"duty.load.{match[1]}"].label)
    match = _OF_BALLS.fullmatch(variable)
    if match is None or match[4] not in _QUANTITIES:
        return ""
    name = _of_balls(*match.groups()[1:])
    return said("{quantity}, per row", quantity=name) if match[1] else name


def variable_long_name(variable: str, field: str = "") -> str:
    """Return what a variable is called in files: its name in English."""
    with speaking("en"):
        return variable_name(variable, field)


def setting_name(setting: str) -> str:
    """Write what was set, ``"life.contamination=0.8"``, with the label of its field.

    Of a variant, its name as it is, or all that it sets.
    """
    if setting == AS_GIVEN:
        return said("as given")
    return ", ".join(_one_setting(part) for part in settings_in(setting)[1]) or setting


def _one_setting(setting: str) -> str:
    name, equals, value = setting.partition("=")
    field = Case.fields().get(name.strip())
    if not equals or field is None:
        return setting
    return f"{field.label} = {manner().localised(value.strip())}"


def _of_balls(reduction: str | None, race: str | None, quantity: str) -> str:
    name = said(_QUANTITIES[quantity])
    if race:
        inner = race == "inner"
        name = (
            said("{quantity}, inner race", quantity=name)
            if inner
            else said("{quantity}, outer race", quantity=name)
        )
    if not reduction:
        return name
    if quantity in _ONLY_LOADED:
        name = said("{quantity}, loaded balls", quantity=name)
    return {
        "max": said("maximum {quantity}", quantity=name),
        "min": said("minimum {quantity}", quantity=name),
        "mean": said("mean {quantity}", quantity=name),
    }[reduction]


def _of_model(what: str, model: str) -> str:
    name = torque_model_name(model)
    if what == "torque":
        return said("friction torque, {model}", model=name)
    return said("friction power loss, {model}", model=name)


def _of_theory(what: str, theory: str) -> str:
    name = theory_name(theory)
    return {
        "hours": said("life, {theory}", theory=name),
        "revolutions": said("life in revolutions, {theory}", theory=name),
        "valid": said("life valid (1) or not (0), {theory}", theory=name),
    }[what]


@cache
def _fields_by_leaf() -> dict[str, str]:
    """Names of fields by the last part, where that is of one field and of no output."""
    leaves: dict[str, list[str]] = {}
    fields = Case.fields()
    for name, field in fields.items():
        leaves.setdefault(field.leaf, []).append(name)
    return {
        leaf: names[0]
        for leaf, names in leaves.items()
        if len(names) == 1 and leaf not in _WHOLE and fields[names[0]].kind != "switch"
    }
