"""What is to be known of fault frequencies."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rolamento.words.speaking import marked

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["SENTENCES"]

SENTENCES: Final[dict[str, Sentence]] = {
    "angle_zero": marked(
        "The bearing is given by its clearance: contact angle 0, as under radial load. Under axial"
        " load the contact angle is the free one or more."
    ),
    "angle_free": marked(
        "The bearing is given by its clearance: free contact angle, as under axial load."
    ),
    "orders_at_rest": marked("Nothing turns: the orders are those of a turning inner ring."),
    "rings_turn_alike": marked("Both rings turn at the same speed: no ball rolls."),
    "no_solution_no_frequencies": marked(
        "The case has no solution, and so no frequencies under load."
    ),
    "no_ball_drives_cage": marked(
        "The inner ring is in contact with no ball: nothing drives the cage."
    ),
    "cage_by_friction": marked("The cage speed follows from the friction at the balls."),
}
