"""What notes about a machine say."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from rolamento.words.reasons import reason
from rolamento.words.sentences import Sentence
from rolamento.words.sentences.solved import direction
from rolamento.words.speaking import marked, said

__all__ = ["SENTENCES"]

Values = Mapping[str, Any]


def _not_held(values: Values) -> str:
    return said(
        "Nothing holds shaft {shaft} {direction}. A locating bearing, a spring or a stop along that"
        " direction would.",
        shaft=values["shaft"],
        direction=direction(str(values["axis"])),
    )


def _ring_not_held(values: Values) -> str:
    return said(
        "Nothing holds the outer ring of bearing {bearing} {direction}.",
        bearing=values["bearing"],
        direction=direction(str(values["axis"])),
    )


def _bearing(values: Values) -> str:
    return said(
        "Bearing {bearing}: {reason}.",
        bearing=values["bearing"],
        reason=reason(str(values["status"])),
    )


SENTENCES: Final[dict[str, Sentence]] = {
    "bore_beside_shaft": marked(
        "Bearing {bearing} has a bore of {bore:.6g mm}, and the shaft there a diameter of"
        " {seat:.6g mm}."
    ),
    "near_buckling": marked(
        "The axial force in shaft {shaft} is {share:.2 %} of its Euler load between the outermost"
        " bearings; above 5 % it changes the bending, which is left out here."
    ),
    "torque_left_over": marked(
        "The torques on shaft {shaft} do not balance: {torque:.4g N·m} are left at its right end."
        " Torque does not bend; it counts in the stress of the shaft alone."
    ),
    "shaft_not_held": _not_held,
    "ring_not_held": _ring_not_held,
    "bearing_of_machine": _bearing,
    "assumed_damping": marked(
        "The damping is assumed: {damping:.1e s} times the stiffness. Amplitudes near a resonance"
        " are as uncertain as that."
    ),
    "beyond_linear": marked(
        "Bearing {bearing}: from {speed:.5 rpm} on there are speeds at which unbalance adds more"
        " force than its rows carry. Contact is then lost in each turn, and the response, which is"
        " linear, is no more than an estimate."
    ),
    "tilted_too_far": marked(
        "The rings of bearing {bearing} are tilted by {tilt:.3g °}, more than the {most:.3g °} that"
        " the equations are for: the shaft hangs on it alone, or bends far too much."
    ),
    "machine_not_converged": marked(
        "No balance was found. Check the clearances and which bearings are located, or begin with"
        " less load."
    ),
}
