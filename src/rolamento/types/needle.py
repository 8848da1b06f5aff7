"""Needle roller bearings, with machined rings or a drawn cup, and cages with needles."""

from __future__ import annotations

from dataclasses import replace
from math import radians
from typing import Final

from rolamento.types._type import BearingType
from rolamento.words import marked

TYPE: Final = BearingType(
    key="needle",
    name=marked("needle roller bearing"),
    untitled=marked("Needle roller bearing"),
    called="needle needle_roller nadellager rolos_de_agulhas agulhas",
    element="needle",
    rolling=marked("needle"),
    described=marked(
        "{count} needle rollers of {diameter}, effective length {length}, pitch diameter {pitch}"
    ),
    row="rolamento.rows.roller.row:roller_row",
    rated="roller",
    floats=True,
    clearance_table="cylindrical",
    class_table="cylindrical",
    idle_fields=("preload",),
    as_a_cage=True,
    usual_misalignment=radians(1.0 / 60.0),  # SKF, drawn cup needle roller bearings, bearing data
)
DRAWN_CUP: Final = replace(
    TYPE,
    key="drawn_cup",
    name=marked("drawn cup needle roller bearing"),
    class_table=None,
    called="",
    usual_letters="HK",
    as_a_cage=False,
)
