"""What the fields of a case are called by readers: on axes, on pages over a field, in lists."""

from __future__ import annotations

from typing import Final

from rolamento.words import marked, said

__all__ = ["LABELS", "label_of"]

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
    "life.reliability": marked("reliability"),
    "life.wanted_life": marked("required life"),
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
    "mounting.shaft_material": marked("shaft"),
    "mounting.housing_material": marked("housing"),
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
    return leaf.replace("_", " ")
