"""Single-row angular-contact ball bearings."""

from __future__ import annotations

from typing import Final

from rolamento.types._type import OF_BALLS, BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="angular_contact",
    name=marked("angular-contact ball bearing"),
    untitled=marked("Ball bearing"),
    called=(
        "angular_contact angular_contact_ball angular_contact_ball_bearing acbb "
        "schragkugellager contato_angular esferas_de_contato_angular contacto_angular"
    ),
    in_pairs=True,
    clearance_table="",
    carries_axial=True,
    notes=OF_BALLS,
)
