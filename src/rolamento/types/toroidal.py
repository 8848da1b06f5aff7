"""Toroidal roller bearings: one row of long barrel-shaped rollers between races that are tori."""

from __future__ import annotations

from math import radians
from typing import Final

from rolamento.types._type import OF_RIBS, BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="toroidal",
    name=marked("toroidal roller bearing"),
    untitled=marked("Toroidal roller bearing"),
    called="toroidal toroidal_roller carb toroidalrollenlager rolos_toroidais rodillos_toroidales",
    element="barrel",
    grooves="toroidal",
    adjective=marked("toroidal"),
    described=marked(
        "{count} toroidal rollers of {diameter}, effective length {length}, pitch diameter {pitch}"
    ),
    row="rolamento.rows.barrel:barrel_row",
    rated="roller",
    rated_together=True,
    floats=True,
    clearance_table="toroidal",
    class_table="toroidal",
    class_table_of_tapered_bore="toroidal_tapered",
    idle_fields=(*OF_RIBS, "preload"),
    usual_misalignment=radians(0.5),  # SKF, Rolling bearings (17000 EN): up to 0.5°
    notes=("axial_load_on_torus",),
)
