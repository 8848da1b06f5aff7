"""Barrel roller bearings: one row of barrel-shaped rollers in an outer ring that is a sphere."""

from __future__ import annotations

from math import radians
from typing import Final

from rolamento.types._type import OF_RIBS, BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="barrel",
    name=marked("barrel roller bearing"),
    untitled=marked("Barrel roller bearing"),
    called="barrel barrel_roller tonnenlager rolos_barrilete rodillos_de_barrilete",
    element="barrel",
    rolling=marked("barrel roller"),
    described=marked(
        "{count} barrel-shaped rollers of {diameter}, effective length {length}, pitch diameter"
        " {pitch}"
    ),
    row="rolamento.rows.barrel:barrel_row",
    rated="roller",
    aligns=True,
    notes=("free_tilt",),
    inclined=True,
    clearance_table="spherical",
    class_table="spherical",
    class_table_of_tapered_bore="spherical_tapered",
    idle_fields=(*OF_RIBS, "preload"),
    # Schaeffler permits 4° at low load and turning inner ring; the limit of the note is the lower
    # one that makers give of spherical roller bearings
    usual_misalignment=radians(1.5),
)
