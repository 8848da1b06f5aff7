"""Single-direction thrust ball bearings: a groove in each of two washers, face to face."""

from __future__ import annotations

from typing import Final

from rolamento.ratings import THRUST_CONFORMITY
from rolamento.types._type import BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="thrust",
    name=marked("single-direction thrust ball bearing"),
    untitled=marked("Ball bearing"),
    called="thrust thrust_ball axial_rillenkugellager axial_de_esferas axialrillenkugellager",
    grooves="thrust",
    adjective=marked("thrust"),
    row="rolamento.rows.ball.arc.grooves:thrust_row",
    rated="thrust",
    rated_together=True,
    washers=True,
    with_cage_only=True,
    mountable=False,
    conformity=THRUST_CONFORMITY,
    carries_axial=True,
    notes=(
        "past_edge",
        "shoulders",
        "orbits",
        "gyroscopic_left_out",
        "rolling",
        "radial_load_on_thrust",
    ),
)
