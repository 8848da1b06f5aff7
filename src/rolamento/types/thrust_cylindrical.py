"""Cylindrical roller thrust bearings: rollers between two flat washers."""

from __future__ import annotations

from typing import Final

from rolamento.types._type import OF_RIBS, BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="cylindrical_thrust",
    name=marked("cylindrical roller thrust bearing"),
    untitled=marked("Cylindrical roller thrust bearing"),
    called="cylindrical_thrust cylindrical_roller_thrust axial_zylinderrollenlager",
    element="cylindrical",
    grooves="thrust",
    adjective=marked("thrust"),
    described=marked(
        "{count} cylindrical rollers of {diameter} between flat washers, effective length {length},"
        " pitch diameter {pitch}"
    ),
    row="rolamento.rows.roller.row:roller_row",
    rated="roller_thrust",
    rated_together=True,
    washers=True,
    mountable=False,
    idle_fields=(*OF_RIBS, "preload"),
    carries_axial=True,
    notes=("radial_load_on_thrust",),
)
