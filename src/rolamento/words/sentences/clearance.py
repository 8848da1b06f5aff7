"""What is said of the clearance in operation: its notes, and where its steps come from."""

from __future__ import annotations

from typing import Final

from rolamento.words.sentences import Sentence
from rolamento.words.speaking import marked, said

__all__ = ["SENTENCES"]

SENTENCES: Final[dict[str, Sentence]] = {
    "clearance_in_operation": marked(
        "Mounted, at its temperatures and speeds, the bearing has a diametral clearance of"
        " {mean:.1f µm}, between {minimum:.1f [µm]} and {maximum:.1f µm} with all tolerances at"
        " their limits."
    ),
    "interference": marked("The mean clearance in operation is negative: the balls are preloaded."),
    "interference_of_rollers": marked(
        "The mean clearance in operation is negative: the rollers are preloaded."
    ),
    "interference_at_minimum": marked(
        "The minimum clearance in operation is negative: some bearings are preloaded."
    ),
    "first_contact_moves": marked(
        "A single tapered roller bearing has no clearance of its own: mounting, temperatures and"
        " speeds move the first contact of its rollers, from which x counts, by {shift:.1f µm}"
        " along the shaft. In a pair they change the preload."
    ),
    "clearance_of_tapered": marked(
        "The diametral clearance of tapered rollers counts from first contact: a change of it moves"
        " first contact along the shaft by half of it times cot α."
    ),
    "inner_ring_loose": marked(
        "In operation the inner ring may lose all its interference: it may creep on the shaft."
    ),
    "outer_ring_loose": marked(
        "In operation the outer ring may lose all its interference: it may creep in the housing."
    ),
    "tight_shaft": marked(
        "The interference of the inner ring may exceed a thousandth of the bore: the ring may crack"
        " (NTN, Ball and Roller Bearings, chapter 7.3)."
    ),
    # of a set
    "preload_in_operation": marked(
        "Mounted, at its temperatures and speeds, the set has an axial preload of {mean:.4 N},"
        " between {loosest:.4 [N]} and {tightest:.4 N} with all tolerances at their limits; before"
        " mounting it was {unmounted:.4 N}."
    ),
    "preload_lost_mounted": lambda values: (
        said("In operation the set has no preload: its rows have play.")
        if values["always"]
        else said("With the loosest fits the set has no preload in operation: its rows have play.")
    ),
    "no_free_angle": marked(
        "The fits take the whole clearance of a row: it has no free contact angle, and only the"
        " axial offset of its clamped grooves gives its balls one."
    ),
    "distance_of_rings": marked(
        "The rings, {width:.5 mm} wide, and the spacers between them set the distance of the rows;"
        " what they expand differently moves the rows against each other."
    ),
    "distance_of_seats": marked(
        "The shaft and the housing set the distance of the rows; where rings and spacers do, give"
        " `mounting.width`."
    ),
    # formulas of the steps
    "step_initial": marked("P_d before mounting"),
    "step_reading": marked("reading under the measuring load"),
    "step_measuring_load": "−2 [δ_r(F) − P_d/2]",
    "step_shaft_fit": marked(
        "−expansion of the raceway under p(δ − smoothing + thermal expansion − rotation)"
    ),
    "step_housing_fit": marked(
        "−contraction of the raceway under p(δ − smoothing + thermal expansion − rotation)"
    ),
    "step_temperature": "α_r (T_e d_e − T_i d_i) − 2 α_b T_b D",
    "step_temperature_tapered": "α_r (T_e d_e − T_i d_i) − 2 α_w T_w D_we cos β",
    "step_speed": marked("centrifugal expansion of the rotating raceways"),
    "step_wear": marked("as given"),
    # their sources
    "source_clearance_class": marked("{standard}, class {name}"),
    "source_own_clearance": marked("the bearing's own"),
    "source_first_contact": marked("counted from first contact"),
    "source_measured": marked("measured"),
    "source_equilibrium": marked("radial equilibrium"),
    "source_fit": marked("Lamé; Harris 1991, chapter 3"),
    "source_tolerances": marked("{tolerances}; {bearing}; Lamé; Harris 1991, chapter 3"),
    "source_temperature": marked("free expansion; NSK E1102, chapter 9.2"),
    "source_speed": marked("Timoshenko and Goodier 1970, section 32"),
    "source_given": marked("given"),
}
