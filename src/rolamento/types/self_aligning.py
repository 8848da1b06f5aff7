"""Self-aligning ball bearings: two rows in an outer ring that is a sphere about their centre."""

from __future__ import annotations

from math import radians
from typing import Final

from rolamento.ratings import SELF_ALIGNING_CONFORMITY
from rolamento.types._type import OF_BALLS, BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="self_aligning",
    name=marked("self-aligning ball bearing"),
    untitled=marked("Ball bearing"),
    called="self_aligning self_aligning_ball pendelkugellager autocompensador_de_esferas",
    grooves="self_aligning",
    adjective=marked("self-aligning"),
    row="rolamento.rows.ball.arc.sphere:sphere_row",
    rated="self_aligning",
    rows=2,
    rated_together=True,
    aligns=True,
    mountable=False,
    conformity=SELF_ALIGNING_CONFORMITY,
    class_table="self_aligning",
    class_table_of_tapered_bore="self_aligning_tapered",
    usual_misalignment=radians(
        2.5
    ),  # Nachi, self-aligning ball bearings: series 12, 22; 13, 23: 3°
    notes=(*OF_BALLS, "free_tilt"),
)
