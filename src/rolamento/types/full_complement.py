"""Full-complement cylindrical roller bearings: one row of rollers without a cage, NCF and NJG."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from rolamento.types import cylindrical
from rolamento.types._type import BearingType
from rolamento.words import marked

TYPE: Final[BearingType] = replace(
    cylindrical.TYPE,
    key="full_complement",
    name=marked("full-complement cylindrical roller bearing"),
    called="full_complement full_complement_cylindrical vollrollig ncf njg",
)
