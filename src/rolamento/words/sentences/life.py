"""What is said of lives: limits of the theories, parts that are missing, changes that help."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from rolamento.words.sentences import Sentence
from rolamento.words.speaking import marked, said

__all__ = ["SENTENCES"]


def _of_element(balls: str, rollers: str, both: str) -> Sentence:
    """Return the sentence of a note that names what rolls: its value "element", balls without."""
    texts = {"roller": rollers, "element": both}
    return lambda values: said(texts.get(values.get("element", ""), balls))


def _life_of_coupled_slices(values: Mapping[str, Any]) -> str:
    first = said(
        "The slices of the rollers are coupled, whereas the rating lives of the standards are of"
        " independent slices (ISO/TS 16281)."
    )
    if values["revolutions"] is None:
        return f"{first} " + said("With those no theory of life is valid for this case.")
    if values["life"] is None:
        second = (
            said("With those the life is below {revolutions:.3r [10⁶ rev]} million revolutions.",
                 **values)
            if values["upper_bound"]
            else said("With those the life is {revolutions:.3r [10⁶ rev]} million revolutions.",
                      **values)
        )  # fmt: skip
        return f"{first} {second}"
    second = (
        said("With those the life is below {life:.3r h}, {revolutions:.3r [10⁶ rev]} million"
             " revolutions.", **values)
        if values["upper_bound"]
        else said("With those the life is {life:.3r h}, {revolutions:.3r [10⁶ rev]} million"
                  " revolutions.", **values)
    )  # fmt: skip
    return f"{first} {second}"


SENTENCES: Final[dict[str, Sentence]] = {
    # outside what the theory is valid for
    "load_above_half_rating": marked(
        "The equivalent load exceeds half of the dynamic load rating: the contacts deform"
        " plastically, and the standard no longer applies."
    ),
    "load_above_static_rating": marked(
        "The equivalent load exceeds the static load rating: permanent indentations are to be"
        " expected."
    ),
    "viscosity_ratio_too_small": marked(
        "The viscosity ratio κ is below 0.1, where the standard gives no factor: the surfaces are"
        " in contact, and the life is less than 10 % of the basic rating life."
    ),
    "contamination_severe": marked(
        "The contamination factor is 0: wear, not fatigue, ends the life, before 10 % of the basic"
        " rating life."
    ),
    "cleanliness_in_words": marked(
        "A level of cleanliness in words stands for a range of the contamination factor, of which"
        " the middle is taken: an ISO 4406 code, or the filter, determines it better."
    ),
    "too_hot_for_steel": marked(
        "Rings, balls or lubricant exceed 120 °C, the limit of standard bearing steel: hardness and"
        " dimensions change, and the load rating decreases. Specify dimensionally stabilised rings."
    ),
    "unloaded": _of_element(
        marked(
            "No ball transmits load between the rings: there is no rating life. Without a"
            " minimum load"
            " the balls slide, which is what ends the life."
        ),
        marked(
            "No roller transmits load between the rings: there is no rating life. Without a minimum"
            " load the rollers slide, which is what ends the life."
        ),
        marked(
            "No rolling element transmits load between the rings: there is no rating life. Without"
            " a minimum load the elements slide, which is what ends the life."
        ),
    ),
    "no_force": _of_element(
        marked(
            "No force acts between the rings, so there is no equivalent load, and the"
            " standard does not"
            " apply; the reference life accounts for the moment or the preload that loads the"
            " balls."
        ),
        marked(
            "No force acts between the rings, so there is no equivalent load, and the standard does"
            " not apply; the reference life accounts for the moment or the preload that loads the"
            " rollers."
        ),
        marked(
            "No force acts between the rings, so there is no equivalent load, and the standard does"
            " not apply; the reference life accounts for the moment or the preload that loads the"
            " rolling elements."
        ),
    ),
    "moment_governs": _of_element(
        marked(
            "The moment loads the balls more than the forces do (2M/d_m > F), and the"
            " equivalent load"
            " does not include the moment; the reference life does, ball by ball."
        ),
        marked(
            "The moment loads the rollers more than the forces do (2M/d_pw > F), and the equivalent"
            " load does not include the moment; the reference life does, roller by roller."
        ),
        marked(
            "The moment loads the rolling elements more than the forces do (2M/d_pw > F), and the"
            " equivalent load does not include the moment; the reference life does."
        ),
    ),
    "no_fatigue_load_limit": marked(
        "Without a fatigue load limit C_u there is no modified rating life: give"
        " `life.fatigue_load_limit`."
    ),
    "no_equivalent_load": marked(
        "The standard has no equivalent load for this set: its rows differ, or it is more than a"
        " tandem or a pair. The reference life is valid for it."
    ),
    "thrust_bearing": marked(
        "The contact angle exceeds 45°: a thrust bearing, rated for axial load; give it as one,"
        ' kind = "thrust".'
    ),
    "no_dynamic_rating": _of_element(
        marked(
            "The geometry lies outside the table of the standard (D cos α/d_m from 0.01 to"
            " 0.40), and"
            " no dynamic load rating is given; or the case has no geometry."
        ),
        marked(
            "The geometry lies outside the table of the standard (D cos α/d_pw from 0.01 to 0.30),"
            " and no dynamic load rating is given; or the case has no geometry."
        ),
        marked(
            "The geometry of a row lies outside the tables of the standard, and its designation"
            " gives no dynamic load rating."
        ),
    ),
    "too_slow": marked("The bearing runs below 20 rpm, for which the manufacturer gives no life."),
    "too_hot": marked("The bearing exceeds 130 °C, for which the manufacturer gives no life."),
    "outside_the_table": marked(
        "Viscosity ratio or load lies outside the user's table of a_NSK, which is not extrapolated."
    ),
    # an upper bound only
    "viscosity_unknown": marked(
        "The viscosity is not given: even with the most viscous oil, this contamination leaves a"
        " shorter life than this."
    ),
    "contamination_unknown": marked(
        "The cleanliness is not given: even perfectly clean, so thin an oil leaves a shorter life"
        " than this."
    ),
    # what the number leaves out, or how it was obtained
    "lubrication_left_out": marked(
        "Lubrication and contamination are not included: the case needs the viscosity "
        "(lubricant with its temperature, or `life.viscosity_ratio`) and the cleanliness "
        "(`life.cleanliness`, for instance)."
    ),
    "cleanliness_missing": marked(
        "Lubrication and contamination are not included: the case needs the cleanliness "
        "(`life.cleanliness`, for instance)."
    ),
    "life_of_coupled_slices": _life_of_coupled_slices,
    "factors_of_the_user": marked(
        "The factors of Tallian's model are the user's: none are published. What is not given"
        " follows Lundberg and Palmgren."
    ),
    "surface_left_out": marked(
        "No factors for surface-initiated failures are given: only subsurface-initiated ones count."
    ),
    "moment_left_out": _of_element(
        marked(
            "The equivalent load does not include the moment; the reference life does, ball"
            " by ball."
        ),
        marked(
            "The equivalent load does not include the moment; the reference life does, slice by"
            " slice of each roller."
        ),
        marked("The equivalent load does not include the moment; the reference life does."),
    ),
    "radial_load_left_out": marked(
        "A thrust bearing of 90° has an equivalent load of the axial force alone: the radial force,"
        " which another bearing should carry, is not included; the reference life includes it."
    ),
    "axial_load_too_small": marked(
        "The axial load is below the minimum of a thrust ball bearing at this speed, the greater of"
        " (C_0/100)·(n/n_max)² and C_0/1000: the balls may slide under their gyroscopic moment."
    ),
    "preload_left_out": marked(
        "The equivalent load does not include the preload; the reference life does."
    ),
    "centrifugal_left_out": marked(
        "Centrifugal force loads the outer race more than the inner race, which the equivalent load"
        " does not include; the reference life does."
    ),
    "open_grooves": marked(
        "The conformities exceed 0.52 (inner) or 0.53 (outer). A load rating that is not given is"
        " reduced accordingly; one that is given has to be that of this bearing."
    ),
    "close_grooves": marked(
        "The conformities are below 0.52 (inner) or 0.53 (outer). The standard warns that closer"
        " conformity need not raise the load rating, and none is raised."
    ),
    "ceramic_balls": _of_element(
        marked(
            "The balls are not of steel. With silicon nitride the dynamic load rating is that of"
            " steel balls; C_0 and C_u, if not given, are those of steel balls at the same"
            " pressure, times (E'_steel/E')² (Hertz)."
        ),
        marked(
            "The rollers are not of steel: C is taken as that of steel rollers; C_0 and C_u, if not"
            " given, as theirs at the same pressure, times E'_steel/E' (Hertz)."
        ),
        marked(
            "The rolling elements are not of steel: C is taken as that of steel elements; C_0 and"
            " C_u, if not given, as theirs at the same pressure (Hertz)."
        ),
    ),
    "no_static_rating": marked(
        "Without the manufacturer's static load rating for these balls there is no static safety"
        " factor."
    ),
    "viscosity_ratio_capped": marked(
        "The viscosity ratio κ is taken as 4, the limit of the standard."
    ),
    "reliability_continued": marked(
        "The reliability lies outside the table of the standard; its formula is extrapolated."
    ),
    "material_factor_unsupported": marked(
        "a_2 is not 1: the standard requires evidence from the manufacturer for it."
    ),
    "operation_factor_too_great": marked(
        "The oil has less than 13 mm²/s, or n·d_m is below 10 000 mm·rpm: the standard calls for"
        " a_3 < 1."
    ),
    "operation_factor_unfounded": marked(
        "a_3 above 1 requires surfaces separated by a film; it does not compensate for a steel."
    ),
    "stand_in_for_the_chart": marked(
        "a_NSK is published in charts only: here a_ISO with e_C = a_c is used in its place."
    ),
    "no_surface_stress": marked(
        "Subsurface stress only, with a fatigue limit: without friction, indentations and"
        " asperities this is an upper bound, highly optimistic from 3 GPa on."
    ),
    "below_fatigue_limit": marked(
        "No point is stressed beyond the fatigue limit: fatigue does not end the life."
    ),
    "hours_at_rest": marked("Nothing rotates: there is no life in hours."),
    "light_load": marked(
        "The equivalent load is below C/100, the usual minimum load of ball bearings: the balls may"
        " slide instead of roll, which no fatigue theory includes."
    ),
    "load_shared_otherwise": marked(
        "The load distribution is not the one that the standard assumes, with normal clearance: the"
        " reference life, which uses the actual one, is less than half or more than twice this one."
    ),
    "light_load_of_rollers": marked(
        "The equivalent load is below C/50, the usual minimum load of roller bearings: the rollers"
        " may slide instead of roll, which no fatigue theory includes."
    ),
    "edge_factor_left_out": marked(
        "The slices of the rollers are coupled, so their loads contain the peaks at the edges: the"
        " edge factor of ISO/TS 16281 is not applied."
    ),
    "axial_load_above_permissible": marked(
        "The axial load on the ribs exceeds the permissible continuous one by the rules of NSK or"
        " SKF: the sliding of the roller ends on the ribs heats and wears them."
    ),
    "rollers_loaded_otherwise": marked(
        "The load distribution is not the one that the standard assumes, with normal clearance and"
        " aligned rings: the reference life, which uses the actual one, is less than a third or"
        " more than three times this one."
    ),
    "theory_of_balls": marked(
        "This theory is for point contact: it does not apply to bearings with rollers."
    ),
    # why a part of an analysis is missing
    "no_temperature": marked(
        "No film: the temperature of the lubricant is not given (`temperature.lubricant`)."
    ),
    "no_temperature_no_friction": marked(
        "No film and no friction torque: the temperature of the lubricant is not given"
        " (`temperature.lubricant`)."
    ),
    "life_of_thrust_bearing": marked(
        "No life: with contact angles above 45° a bearing is rated as a thrust bearing; give"
        ' kind = "thrust".'
    ),
    "life_without_rating": _of_element(
        marked(
            "No life: the geometry lies outside the table of the standard (D cos α/d_m from 0.01"
            " to 0.40), and no dynamic load rating is given (`life.dynamic_rating`)."
        ),
        marked(
            "No life: the geometry lies outside the table of the standard (D cos α/d_pw from 0.01"
            " to 0.30), and no dynamic load rating is given (`life.dynamic_rating`)."
        ),
        marked(
            "No life: the geometry of a row lies outside the tables of the standard, and its"
            " designation gives no dynamic load rating."
        ),
    ),
    "l_able_without_viscosity": marked(
        "No L_able: the viscosity ratio is not known; it needs a lubricant with its temperature, or"
        " `life.viscosity_ratio`."
    ),
    # what a quick analysis leaves out
    "without_friction_models": marked(
        "Quick analysis: the friction by the other models is left out."
    ),
    "without_stress_volume": marked(
        "Quick analysis: the life by the stress volume, that of Ioannides and Harris, is left out."
    ),
    "without_preload_loss": marked(
        "Quick analysis: the load at which the set loses its preload is left out."
    ),
    # changes that help
    "less_load": marked("all forces and moments {change:+.0f %}"),
    "less_clearance": marked("diametral clearance {change:+.0f µm}"),
    "more_clearance": marked("diametral clearance {change:+.0f µm}"),
    "thicker_oil": marked("viscosity {change:+.0f %}, about one ISO VG grade"),
    "less_tilt": marked("tilt of the rings {change:+.0f %}"),
    "profiled_rollers": marked("rollers with the logarithmic profile of ISO/TS 16281"),
    "cleaner_oil": marked("contamination factor {change:+.1f}, at most 1"),
}
