"""Single-row tapered roller bearings: rollers and raceways are cones with one apex."""

from __future__ import annotations

from math import radians
from typing import Final

from rolamento.types._type import BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="tapered",
    name=marked("tapered roller bearing"),
    untitled=marked("Tapered roller bearing"),
    called=(
        "tapered tapered_roller taper_roller kegelrollenlager rolos_conicos rodillos_conicos trb"
    ),
    element="tapered",
    rolling=marked("tapered roller"),
    described=marked(
        "{count} tapered rollers of {diameter} mean diameter, effective length {length}, pitch"
        " diameter {pitch}"
    ),
    row="rolamento.rows.roller.row:roller_row",
    rated="roller",
    conical=True,
    axial_limit_of_maker=True,
    idle_fields=("inner_ribs", "outer_ribs", "axial_play"),
    carries_axial=True,
    # 0.0009 rad; NSK's catalogue E1102, general knowledge, no page at hand
    usual_misalignment=radians(3.0 / 60.0),
)
