"""Single-row cylindrical roller bearings: N, NU, NJ, NUP and NF by their ribs."""

from __future__ import annotations

from math import radians
from typing import Final

from rolamento.types._type import BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="cylindrical",
    name=marked("cylindrical roller bearing"),
    untitled=marked("Cylindrical roller bearing"),
    called=(
        "cylindrical cylindrical_roller zylinderrollenlager rolos_cilindricos "
        "rodillos_cilindricos crb"
    ),
    element="cylindrical",
    rolling=marked("cylindrical roller"),
    described=marked(
        "{count} cylindrical rollers of {diameter}, effective length {length}, pitch diameter"
        " {pitch}"
    ),
    row="rolamento.rows.roller.row:roller_row",
    rated="roller",
    floats=True,
    clearance_table="cylindrical",
    class_table="cylindrical",
    idle_fields=("preload",),
    # of width series 0 and 1: 0.0012 rad, of series 2 half of it; NSK's catalogue E1102, general
    # knowledge, no page at hand
    usual_misalignment=radians(4.0 / 60.0),
    usual_misalignment_of_wide=radians(2.0 / 60.0),
    ribbed=True,
)
