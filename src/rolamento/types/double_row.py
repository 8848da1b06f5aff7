"""Double-row angular-contact ball bearings, their rows back to back."""

from __future__ import annotations

from typing import Final

from rolamento.types._type import OF_BALLS, BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="double_row",
    name=marked("double-row angular-contact ball bearing"),
    untitled=marked("Ball bearing"),
    rows=2,
    rated_together=True,
    clearance_table="",
    carries_axial=True,
    notes=OF_BALLS,
)
