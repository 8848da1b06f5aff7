"""Why a torque model is not valid, or only with a remark."""

from __future__ import annotations

from typing import Final

from rolamento.words.sentences import Sentence
from rolamento.words.speaking import marked

__all__ = ["SENTENCES"]

SENTENCES: Final[dict[str, Sentence]] = {
    "inertia": marked(
        "The gyroscopic moment or the centrifugal force on a ball exceeds {share:.0f %} of what"
        " friction or its load can hold."
    ),
    "full_film": marked("A lubricant film separates the surfaces: friction is not Coulomb's."),
    "partial_film": marked(
        "A lubricant film carries part of the load: the coefficient of friction is an effective"
        " one."
    ),
    "no_film": marked("The asperities carry the load, and the model is for lubricated bearings."),
    "more_contacts": marked(
        "Balls bear on both arcs of a ring and have to slide on them; this model lets each pair of"
        " contacts move the ball for itself, so that its torque is too low."
    ),
    "other_angle": marked(
        "The manufacturer's constants are for bearings of another contact angle."
    ),
    "torque_at_rest": marked("Nothing rotates: the torque is that of the first motion."),
    "torque_unknown": marked("The state, or the model, has no result."),
}
