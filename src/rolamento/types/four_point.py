"""Four-point contact ball bearings: two arcs in each ring, so that one row carries both ways."""

from __future__ import annotations

from typing import Final

from rolamento.types._type import BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="four_point",
    name=marked("four-point contact ball bearing"),
    untitled=marked("Ball bearing"),
    called="four_point four_point_contact vierpunktlager quatro_pontos",
    grooves="four_point",
    adjective=marked("four-point"),
    row="rolamento.rows.ball.arc.grooves:four_point_row",
    rated_together=True,
    has_arches=True,
    with_cage_only=True,
    mountable=False,
    class_table="four_point",
    carries_axial=True,
    notes=("shoulders", "orbits", "gyroscopic_left_out", "arches", "rolling", "four_point_load"),
)
