"""What the fields of a case are called by readers: on axes, on pages over a field, in lists."""

from __future__ import annotations

from typing import Final

from rolamento.types import TYPES
from rolamento.words import marked, said

__all__ = ["CHOICES", "LABELS", "choice_label", "label_of"]

LABELS: Final = {
    "title": marked("title"),
    "report.project": marked("project"),
    "report.author": marked("author"),
    "report.revision": marked("revision"),
    "report.date": marked("date"),
    "report.checked_by": marked("checked by"),
    "bearing.element": marked("rolling element"),
    "bearing.kind": marked("type of the grooves"),
    "bearing.shim_angle": marked("shim angle"),
    "bearing.designation": marked("designation"),
    "bearing.ball_count": marked("number of balls"),
    "bearing.ball_diameter": marked("ball diameter"),
    "bearing.pitch_diameter": marked("pitch diameter"),
    "bearing.roller_count": marked("number of rollers"),
    "bearing.roller_diameter": marked("roller diameter"),
    "bearing.roller_length": marked("roller length"),
    "bearing.effective_length": marked("effective roller length"),
    "bearing.roller_half_angle": marked("half angle of the rollers"),
    "bearing.roller_profile_radius": marked("profile radius of the rollers"),
    "bearing.inner_raceway_radius": marked("profile radius of the inner raceway"),
    "bearing.outer_raceway_radius": marked("profile radius of the outer raceway"),
    "bearing.inner_ribs": marked("ribs of the inner ring"),
    "bearing.outer_ribs": marked("ribs of the outer ring"),
    "bearing.axial_play": marked("axial play between the ribs"),
    "bearing.rib_height": marked("height of the rib contact"),
    "bearing.roller_end_radius": marked("radius of the roller's end"),
    "bearing.roller_material": marked("roller material"),
    "bearing.roller_profile": marked("roller profile"),
    "bearing.roller_profile.kind": marked("kind of the roller profile"),
    "bearing.roller_profile.factor": marked("factor of the roller profile"),
    "bearing.roller_profile.amplitude": marked("amplitude of the roller profile"),
    "bearing.roller_profile.crowned_length": marked("crowned length of the roller profile"),
    "bearing.roller_profile.end_drop": marked("end drop of the roller profile"),
    "bearing.roller_profile.radius": marked("radius of the roller profile"),
    "bearing.roller_profile.flat_length": marked("straight length of the roller profile"),
    "bearing.roller_profile.places": marked("places of the roller profile"),
    "bearing.roller_profile.drops": marked("drops of the roller profile"),
    "bearing.inner_profile": marked("inner raceway profile"),
    "bearing.inner_profile.kind": marked("kind of the inner raceway profile"),
    "bearing.inner_profile.factor": marked("factor of the inner raceway profile"),
    "bearing.inner_profile.amplitude": marked("amplitude of the inner raceway profile"),
    "bearing.inner_profile.crowned_length": marked("crowned length of the inner raceway profile"),
    "bearing.inner_profile.end_drop": marked("end drop of the inner raceway profile"),
    "bearing.inner_profile.radius": marked("radius of the inner raceway profile"),
    "bearing.inner_profile.flat_length": marked("straight length of the inner raceway profile"),
    "bearing.inner_profile.places": marked("places of the inner raceway profile"),
    "bearing.inner_profile.drops": marked("drops of the inner raceway profile"),
    "bearing.outer_profile": marked("outer raceway profile"),
    "bearing.outer_profile.kind": marked("kind of the outer raceway profile"),
    "bearing.outer_profile.factor": marked("factor of the outer raceway profile"),
    "bearing.outer_profile.amplitude": marked("amplitude of the outer raceway profile"),
    "bearing.outer_profile.crowned_length": marked("crowned length of the outer raceway profile"),
    "bearing.outer_profile.end_drop": marked("end drop of the outer raceway profile"),
    "bearing.outer_profile.radius": marked("radius of the outer raceway profile"),
    "bearing.outer_profile.flat_length": marked("straight length of the outer raceway profile"),
    "bearing.outer_profile.places": marked("places of the outer raceway profile"),
    "bearing.outer_profile.drops": marked("drops of the outer raceway profile"),
    "bearing.contact_angle": marked("free contact angle"),
    "bearing.diametral_clearance": marked("diametral clearance"),
    "bearing.inner_conformity": marked("inner conformity"),
    "bearing.outer_conformity": marked("outer conformity"),
    "bearing.ring_material": marked("ring material"),
    "bearing.ball_material": marked("ball material"),
    "bearing.inner_shoulder_height": marked("inner shoulder height"),
    "bearing.outer_shoulder_height": marked("outer shoulder height"),
    "bearing.arrangement": marked("arrangement"),
    "bearing.spacing": marked("spacing between rows"),
    "bearing.rows": marked("rows"),
    "bearing.preload": marked("preload"),
    "bearing.preload.force": marked("preload force"),
    "bearing.preload.offset": marked("preload offset"),
    "bearing.preload.spring": marked("preload spring force"),
    "bearing.preload.level": marked("preload class"),
    "bearing.preload.designation": marked("designation for the preload class"),
    "duty.inner_speed": marked("inner ring speed"),
    "duty.outer_speed": marked("outer ring speed"),
    "duty.first_ball_azimuth": marked("azimuth of the first ball"),
    "duty.load.fx": marked("axial load Fx"),
    "duty.load.fy": marked("radial load Fy"),
    "duty.load.fz": marked("radial load Fz"),
    "duty.load.my": marked("moment My"),
    "duty.load.mz": marked("moment Mz"),
    "duty.displacement.x": marked("axial displacement x"),
    "duty.displacement.y": marked("radial displacement y"),
    "duty.displacement.z": marked("radial displacement z"),
    "duty.displacement.ry": marked("tilt about y"),
    "duty.displacement.rz": marked("tilt about z"),
    "model.raceway_control": marked("raceway control"),
    "model.cage": marked("cage"),
    "model.centrifugal_force": marked("centrifugal force considered"),
    "model.gyroscopic_moment": marked("gyroscopic moment considered"),
    "model.cage_drag": marked("cage drag torque"),
    "model.mesh": marked("contact mesh"),
    "model.roller_contact": marked("contact of the rollers"),
    "model.slices": marked("slices of a roller"),
    "model.traction": marked("traction model"),
    "model.film_in_contact": marked("film thickness in the contact geometry"),
    "lubricant": marked("lubricant"),
    "lubricant.name": marked("lubricant name"),
    "lubricant.kind": marked("lubricant type"),
    "lubricant.base_oil": marked("base oil"),
    "lubricant.viscosity_40": marked("kinematic viscosity at 40 °C"),
    "lubricant.viscosity_100": marked("kinematic viscosity at 100 °C"),
    "lubricant.viscosity_index": marked("viscosity index"),
    "lubricant.viscosities": marked("viscosities at two temperatures"),
    "lubricant.density": marked("lubricant density"),
    "lubricant.density_temperature": marked("reference temperature of the density"),
    "lubricant.thermal_expansion": marked("lubricant thermal expansion"),
    "lubricant.pressure_viscosity": marked("pressure-viscosity coefficient α"),
    "lubricant.pressure_viscosity_method": marked("pressure-viscosity method"),
    "lubricant.thermal_conductivity": marked("lubricant thermal conductivity"),
    "lubricant.minimum_temperature": marked("minimum lubricant temperature"),
    "lubricant.maximum_temperature": marked("maximum lubricant temperature"),
    "lubricant.oil_type": marked("type of oil"),
    "lubricant.friction_coefficient": marked("friction coefficient"),
    "lubricant.source": marked("source of the lubricant data"),
    "surface.parameter": marked("roughness parameter"),
    "surface.inner_roughness": marked("inner race roughness"),
    "surface.outer_roughness": marked("outer race roughness"),
    "surface.ball_roughness": marked("ball roughness"),
    "temperature.lubricant": marked("lubricant temperature"),
    "temperature.inner_ring": marked("inner ring temperature"),
    "temperature.outer_ring": marked("outer ring temperature"),
    "temperature.balls": marked("ball temperature"),
    "temperature.shaft": marked("shaft temperature"),
    "temperature.housing": marked("housing temperature"),
    "temperature.inner_spacer": marked("inner spacer temperature"),
    "temperature.outer_spacer": marked("outer spacer temperature"),
    "mounting.bore": marked("bore diameter d"),
    "mounting.outside_diameter": marked("outside diameter D"),
    "mounting.clearance_class": marked("clearance class"),
    "mounting.measured_clearance": marked("measured clearance"),
    "mounting.measuring_load": marked("measuring load"),
    "mounting.shaft_tolerance": marked("shaft tolerance class"),
    "mounting.shaft_interference": marked("shaft interference"),
    "mounting.housing_tolerance": marked("housing tolerance class"),
    "mounting.housing_interference": marked("housing interference"),
    "mounting.tolerance_class": marked("bearing tolerance class"),
    "mounting.shaft_bore": marked("shaft bore"),
    "mounting.housing_outside_diameter": marked("housing outside diameter"),
    "mounting.shaft_material": marked("shaft material"),
    "mounting.housing_material": marked("housing material"),
    "mounting.shaft_finish": marked("shaft finish"),
    "mounting.shaft_roughness": marked("shaft seat roughness Rz"),
    "mounting.housing_finish": marked("housing finish"),
    "mounting.housing_roughness": marked("housing seat roughness Rz"),
    "mounting.width": marked("bearing width B"),
    "mounting.inner_spacer_material": marked("inner spacer material"),
    "mounting.outer_spacer_material": marked("outer spacer material"),
    "mounting.ring_expansion": marked("ring thermal expansion"),
    "mounting.ball_expansion": marked("ball thermal expansion"),
    "mounting.assembly_temperature": marked("assembly temperature"),
    "mounting.wear": marked("clearance increase by wear"),
    "mounting.limit": marked("clearance limit"),
    "film.thermal": marked("thermal reduction model"),
    "film.starvation": marked("starvation model"),
    "film.inlet_distance": marked("inlet distance"),
    "film.supply": marked("lubricant supply to the contact"),
    "film.bore": marked("bore diameter (replenishment)"),
    "film.outside_diameter": marked("outside diameter (replenishment)"),
    "film.line": marked("film formulas of line contacts"),
    "heat.ambient": marked("ambient temperature"),
    "heat.inner_ring_elements": marked("conductance inner ring to rolling elements"),
    "heat.elements_outer_ring": marked("conductance rolling elements to outer ring"),
    "heat.inner_ring_shaft": marked("conductance inner ring to shaft"),
    "heat.outer_ring_housing": marked("conductance outer ring to housing"),
    "heat.shaft_ambient": marked("conductance shaft to ambient"),
    "heat.housing_ambient": marked("conductance housing to ambient"),
    "heat.housing_along": marked("conductance of the housing to the next bearing"),
    "heat.oil_flow": marked("oil flow"),
    "heat.oil_inlet": marked("oil inlet temperature"),
    "heat.shaft_heat": marked("heat from outside into the shaft"),
    "heat.housing_heat": marked("heat from outside into the housing"),
    "heat.inner_share": marked("share of friction heat in the inner ring"),
    "heat.friction": marked("friction of the heat balance"),
    "heat.limit": marked("temperature limit"),
    "heat.bore": marked("bore diameter (heat estimates)"),
    "heat.outside_diameter": marked("outside diameter (heat estimates)"),
    "heat.width": marked("bearing width (heat estimates)"),
    "heat.inner_ring_capacity": marked("heat capacity of the inner ring"),
    "heat.elements_capacity": marked("heat capacity of the rolling elements"),
    "heat.outer_ring_capacity": marked("heat capacity of the outer ring"),
    "heat.shaft_capacity": marked("heat capacity of the shaft"),
    "heat.housing_capacity": marked("heat capacity of the housing"),
    "heat.steps": marked("steps in time (heat)"),
    "life.reliability": marked("reliability"),
    "life.required_life": marked("required life"),
    "life.dynamic_rating": marked("basic dynamic load rating C"),
    "life.static_rating": marked("basic static load rating C_0"),
    "life.fatigue_load_limit": marked("fatigue load limit C_u"),
    "life.fatigue_load_method": marked("fatigue load limit method"),
    "life.contamination": marked("contamination factor e_C"),
    "life.cleanliness": marked("cleanliness code (ISO 4406)"),
    "life.oil_supply": marked("oil supply"),
    "life.filter_size": marked("filter rating"),
    "life.filter_ratio": marked("filtration ratio β"),
    "life.grease_cleanliness": marked("grease contamination level"),
    "life.additives": marked("effective EP additives"),
    "life.viscosity_ratio": marked("viscosity ratio κ"),
    "life.rotating_load": marked("rotating load"),
    "life.edition": marked("edition of ISO 281"),
    "life.material_factor": marked("material factor a_2"),
    "life.operation_factor": marked("operating conditions factor a_3"),
    "life.fatigue_limit": marked("fatigue limit stress τ_u"),
    "life.depth": marked("stress-volume depth"),
    "life.nsk_cleanliness": marked("contamination factor a_c (NSK)"),
}
"""By dotted name."""

_PARTS: Final = {
    "bearing.ring_material": marked("rings"),
    "bearing.ball_material": marked("balls"),
    "bearing.roller_material": marked("rollers"),
    "mounting.shaft_material": marked("shaft"),
    "mounting.housing_material": marked("housing"),
    "mounting.inner_spacer_material": marked("inner spacer"),
    "mounting.outer_spacer_material": marked("outer spacer"),
    "life.tallian_subsurface": marked("Tallian, subsurface"),
    "life.tallian_surface": marked("Tallian, surface"),
}
_QUANTITIES: Final = {
    "name": marked("material name"),
    "youngs_modulus": marked("Young's modulus E"),
    "poisson_ratio": marked("Poisson's ratio ν"),
    "density": marked("density ρ"),
    "thermal_expansion": marked("thermal expansion coefficient"),
    "source": marked("source of the data"),
    "strength": marked("strength φ0"),
    "defect_shape": marked("defect shape φ1"),
    "defect_density": marked("defect density φ2"),
    "failure_rate": marked("failure rate φ3"),
    "pressure_distribution": marked("pressure distribution φ4"),
    "exponent": marked("exponent s"),
}
_OF_ENTRIES: Final = {
    "orientation": marked("orientation"),
    "position": marked("position"),
    "phase": marked("phase"),
    "temperature": marked("temperature"),
    "viscosity": marked("viscosity"),
}
"""Labels of the tables in a list, what no table of a case has."""


def label_of(name: str) -> str:
    """Return what a field is called, in the language that is spoken.

    Parameters
    ----------
    name
        Dotted, such as ``"temperature.lubricant"``; that of no field of a case is said as it is
        written, without its underscores.
    """
    if name in LABELS:
        return said(LABELS[name])
    table, _, leaf = name.rpartition(".")
    if table in _PARTS and leaf in _QUANTITIES:
        return said(
            "{quantity} ({part})", quantity=said(_QUANTITIES[leaf]), part=said(_PARTS[table])
        )
    return said(_OF_ENTRIES[name]) if name in _OF_ENTRIES else leaf.replace("_", " ")


_PROFILES: Final = {
    "none": marked("straight"),
    "iso": marked("ISO/TS 16281"),
    "logarithmic": marked("logarithmic"),
    "crowned": marked("crowned"),
    "tangential": marked("crowned at the ends"),
    "table": marked("by a table"),
}
_RIBS: Final = {
    "none": marked("none"),
    "+": marked("at +x"),
    "-": marked("at -x"),
    "both": marked("on both sides"),
}
_FINISHES: Final = {"ground": marked("ground"), "turned": marked("turned")}

CHOICES: Final = {
    "bearing.kind": {one.grooves: one.adjective for one in TYPES.values() if one.grooves},
    "bearing.preload.level": {
        "extra_light": marked("extra light"),
        "light": marked("light"),
        "medium": marked("medium"),
        "heavy": marked("heavy"),
    },
    "bearing.inner_ribs": _RIBS,
    "bearing.outer_ribs": _RIBS,
    "bearing.roller_profile.kind": _PROFILES,
    "bearing.inner_profile.kind": _PROFILES,
    "bearing.outer_profile.kind": _PROFILES,
    "model.raceway_control": {
        "outer": marked("outer raceway"),
        "inner": marked("inner raceway"),
        "jones": marked("by Jones's criterion"),
        "none": marked("no control"),
        "friction": marked("by friction"),
    },
    "model.cage": {
        "loose": marked("loose"),
        "rigid": marked("rigid"),
        "none": marked("without a cage"),
    },
    "model.mesh": {"coarse": marked("coarse"), "fine": marked("fine")},
    "model.traction": {"coulomb": marked("Coulomb friction"), "film": marked("of the film")},
    "model.roller_contact": {
        "slices": marked("independent slices"),
        "coupled": marked("coupled slices"),
    },
    "lubricant.kind": {"oil": marked("oil"), "grease": marked("grease"), "dry": marked("dry")},
    "lubricant.oil_type": {
        "mineral": marked("mineral oil"),
        "synthetic": marked("synthetic oil"),
        "transmission_fluid": marked("transmission fluid"),
    },
    "lubricant.pressure_viscosity_method": {
        "wooster": marked("Wooster"),
        "so_klaus": marked("So and Klaus"),
    },
    "mounting.tolerance_class": {"normal": marked("normal")},
    "mounting.shaft_finish": _FINISHES,
    "mounting.housing_finish": _FINISHES,
    "mounting.limit": {
        "minimum": marked("minimum"),
        "mean": marked("mean"),
        "maximum": marked("maximum"),
    },
    "film.thermal": {
        "murch_wilson": marked("Murch and Wilson"),
        "gupta_cheng": marked("Gupta and Cheng"),
        "none": marked("none"),
    },
    "film.starvation": {
        "none": marked("none"),
        "inlet_distance": marked("by the inlet distance"),
        "replenishment": marked("by replenishment"),
    },
    "film.supply": {
        "bath": marked("oil bath"),
        "jet": marked("oil jet"),
        "grease": marked("grease"),
        "oil_air": marked("oil-air"),
    },
    "film.line": {
        "pan_hamrock": marked("Pan and Hamrock"),
        "dowson_toyoda": marked("Dowson and Toyoda"),
    },
    "heat.friction": {
        "contacts": marked("contacts and rolling resistance"),
        "palmgren": marked("Palmgren"),
        "skf": marked("SKF"),
    },
    "life.fatigue_load_method": {
        "contacts": marked("from the contact stress"),
        "estimate": marked("estimated from C0"),
    },
    "life.oil_supply": {
        "circulating": marked("circulating oil"),
        "bath": marked("oil bath"),
    },
    "life.grease_cleanliness": {
        "high": marked("high cleanliness"),
        "normal": marked("normal cleanliness"),
        "slight": marked("slight contamination"),
        "severe": marked("severe contamination"),
        "very_severe": marked("very severe contamination"),
    },
    "life.depth": {"local": marked("of each contact"), "mean": marked("mean")},
}
"""What the choices of a field are called; those that are no words of a language call themselves."""


def choice_label(name: str, value: str) -> str:
    """Return what a choice of a field is called, in the language that is spoken.

    Parameters
    ----------
    name, value
        Dotted name of the field, and what its file has.
    """
    label = CHOICES.get(name, {}).get(value)
    return value if label is None else said(label)
