"""Tapered roller thrust bearings: rollers between two washers that are cones with their apex."""

from __future__ import annotations

from typing import Final

from rolamento.types._type import BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="tapered_thrust",
    name=marked("tapered roller thrust bearing"),
    untitled=marked("Tapered roller thrust bearing"),
    called="tapered_thrust tapered_roller_thrust axial_kegelrollenlager tthd",
    element="tapered",
    grooves="thrust",
    adjective=marked("thrust"),
    rolling=marked("tapered roller"),
    described=marked(
        "{count} tapered rollers of {diameter} mean diameter between conical washers, effective"
        " length {length}, pitch diameter {pitch}"
    ),
    row="rolamento.rows.roller.row:roller_row",
    rated="roller_thrust",
    rated_together=True,
    conical=True,
    washers=True,
    mountable=False,
    idle_fields=("inner_ribs", "outer_ribs", "axial_play", "preload"),
    carries_axial=True,
    notes=("radial_load_on_thrust",),
)
