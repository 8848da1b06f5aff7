"""Spherical roller bearings: two rows of barrel-shaped rollers in a sphere about their centre."""

from __future__ import annotations

from math import radians
from typing import Final

from rolamento.types._type import OF_RIBS, BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="spherical",
    name=marked("spherical roller bearing"),
    untitled=marked("Spherical roller bearing"),
    called=(
        "spherical spherical_roller spherical_roller_bearing srb pendelrollenlager "
        "autocompensador_de_rolos rodillos_a_rotula"
    ),
    element="barrel",
    grooves="spherical",
    adjective=marked("spherical"),
    described=marked(
        "two rows of {count} barrel-shaped rollers of {diameter}, effective length {length}, pitch"
        " diameter {pitch}"
    ),
    row="rolamento.rows.barrel:barrel_row",
    rated="roller",
    rows=2,
    rated_together=True,
    aligns=True,
    notes=("free_tilt",),
    inclined=True,
    clearance_table="spherical",
    class_table="spherical",
    class_table_of_tapered_bore="spherical_tapered",
    axial_limit_of_maker=True,
    idle_fields=(*OF_RIBS, "preload"),
    usual_misalignment=radians(1.5),  # NSK, Rolling Bearings (CAT. No. E1102e): 1° to 2.5°
)
