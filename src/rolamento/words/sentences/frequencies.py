"""What is to be known of fault frequencies."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rolamento.words.naming import by_element
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
    "rings_turn_alike": by_element(
        marked("Both rings turn at the same speed: no ball rolls."),
        marked("Both rings turn at the same speed: no roller rolls."),
    ),
    "no_solution_no_frequencies": marked(
        "The case has no solution, and so no frequencies under load."
    ),
    "no_ball_drives_cage": by_element(
        marked("The inner ring is in contact with no ball: nothing drives the cage."),
        marked("The inner ring is in contact with no roller: nothing drives the cage."),
    ),
    "no_common_apex": marked(
        "The cones of rollers and raceways have no common apex: the half angle is"
        " {half_angle:.4 °}, that of true rolling {apex_half_angle:.4 °}. The rollers roll at their"
        " middle and slide at their ends; by the angles alone the cage would have the order"
        " {order_by_angles:.4f}."
    ),
    "waviness_of_rollers": marked(
        "Waviness: of waves that run straight along the line of contact; the formulas were"
        " published for ball bearings under axial load."
    ),
    "cage_by_friction": marked("The cage speed follows from the friction at the balls."),
}
