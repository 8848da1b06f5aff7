"""What is to be known of fault frequencies."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

from rolamento.words.naming import by_element, listed
from rolamento.words.speaking import marked, said

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["SENTENCES"]


def _counts(values: Mapping[str, Any]) -> str:
    shares = listed(
        said("{count} ({share:.0f %})", count=count, share=share)
        for count, share in values["shares"]
    )
    return said(
        "The number of rollers was estimated from the load ratings: {shares}. The orders of the"
        " races are in proportion to it, those of cage and roller do not depend on it: count the"
        " rollers and give `bearing.roller_count=N`.",
        shares=shares,
    )


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
    "roller_count_open": _counts,
    "no_common_apex": marked(
        "The cones of rollers and raceways have no common apex: the half angle is"
        " {half_angle:.4 °}, that of true rolling {apex_half_angle:.4 °}. The rollers roll at their"
        " middle and slide at their ends; by the angles alone the cage would have the order"
        " {order_by_angles:.4f}."
    ),
    "rollers_slide_on_washers": marked(
        "Cylindrical rollers between flat washers roll at their middle and slide at their ends."
    ),
    "waviness_of_rollers": marked(
        "Waviness: of waves that run straight along the line of contact; the formulas were"
        " published for ball bearings under axial load."
    ),
    "cage_by_friction": marked("The cage speed follows from the friction at the balls."),
}
