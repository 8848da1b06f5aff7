"""Single-row deep-groove ball bearings; plain balls in one groove a ring."""

from __future__ import annotations

from typing import Final

from rolamento.types._type import BearingType
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
)
