"""Single-row deep-groove ball bearings; plain balls in one groove a ring."""

from __future__ import annotations

from math import radians
from typing import Final

from rolamento.types._type import OF_BALLS, BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="deep_groove",
    name=marked("deep-groove ball bearing"),
    untitled=marked("Ball bearing"),
    called=(
        "deep_groove deep_groove_ball deep_groove_ball_bearing dgbb rigid_ball "
        "rillenkugellager rigido_de_esferas rolamento_rigido_de_esferas rigido_de_bolas"
    ),
    clearance_table="",
    class_table="",
    # by clearance and size 2′ to 10′: SKF, Rolling bearings (17000 EN), deep groove ball bearings,
    # and NSK, Rolling Bearings (CAT. No. E1102), in radians
    usual_misalignment=radians(10.0 / 60.0),
    notes=OF_BALLS,
)
