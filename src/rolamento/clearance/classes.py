"""Clearance classes of deep-groove ball bearings: ISO 5753-1, radial internal clearance."""

from __future__ import annotations

from typing import Final, Literal, get_args

from rolamento.clearance.band import Band
from rolamento.clearance.tables import MICROMETRE, MILLIMETRE, step_of, table
from rolamento.errors import InputError
from rolamento.units import from_si

__all__ = ["CLEARANCE_CLASSES", "CLEARANCE_SOURCE", "ClearanceClass", "class_clearance"]

ClearanceClass = Literal["C2", "CN", "C3", "C4", "C5"]
CLEARANCE_CLASSES: Final[tuple[ClearanceClass, ...]] = get_args(ClearanceClass)
CLEARANCE_SOURCE: Final = "ISO 5753-1:2009"


def class_clearance(bore: float, clearance_class: str) -> Band:
    """Radial internal clearance of a class, before mounting.

    Parameters
    ----------
    bore
        d, in m; over 2.5 mm, at most 500 mm.
    clearance_class
        ``"C2"``, ``"CN"``, ``"C3"``, ``"C4"`` or ``"C5"``.

    Raises
    ------
    InputError
        If there is no such class, or the standard has none for this bore.
    """
    if clearance_class not in CLEARANCE_CLASSES:
        raise InputError(
            f"must be one of {', '.join(CLEARANCE_CLASSES)}",
            field="clearance_class",
            value=clearance_class,
            example='clearance_class = "C3"',
        )
    data = table("iso5753")
    step = step_of(bore, data["bore_mm"], field="bore", standard=CLEARANCE_SOURCE)
    pair = data["classes"][clearance_class][step]
    if not pair:
        least = from_si(data["bore_mm"][step + 1] * MILLIMETRE, "length")
        raise InputError(
            f"has no range for bores up to {least} in {CLEARANCE_SOURCE}",
            field="clearance_class",
            value=clearance_class,
            example='clearance_class = "C3"',
        )
    return Band(pair[0] * MICROMETRE, pair[1] * MICROMETRE)
