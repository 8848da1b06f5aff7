"""From the clearance of a bearing before mounting to its clearance in operation.

Pure functions, one idea a file: clearance classes, the measuring load, tolerances of seats, press
fits, temperature, speed, wear; `operating` puts them in a chain. See docs/theory/clearance.md.
"""

from __future__ import annotations

from rolamento.case.mounting import Mounting, SeatMaterial
from rolamento.clearance.batch import MOUNTED_FIELDS, operating_batch
from rolamento.clearance.chain import PartTemperatures
from rolamento.clearance.measuring_load import (
    clearance_from_reading,
    measuring_load_correction,
    usual_measuring_load,
)
from rolamento.clearance.operating import (
    ClearanceSamples,
    OperatingClearance,
    Step,
    bearing_with_clearance,
    clearance_notes,
    clearance_of_case,
    operating_case,
    operating_clearance,
    sample_clearance,
)
from rolamento.clearance.standards import (
    CLEARANCE_CLASSES,
    Band,
    ClearanceClass,
    Limit,
    ToleranceClass,
    bore_deviations,
    class_clearance,
    hole_deviations,
    outside_deviations,
    shaft_deviations,
    standard_tolerance,
)
from rolamento.clearance.wear import WearFit, WearLaw, fit_wear

__all__ = [
    "CLEARANCE_CLASSES",
    "MOUNTED_FIELDS",
    "Band",
    "ClearanceClass",
    "ClearanceSamples",
    "Limit",
    "Mounting",
    "OperatingClearance",
    "PartTemperatures",
    "SeatMaterial",
    "Step",
    "ToleranceClass",
    "WearFit",
    "WearLaw",
    "bearing_with_clearance",
    "bore_deviations",
    "class_clearance",
    "clearance_from_reading",
    "clearance_notes",
    "clearance_of_case",
    "fit_wear",
    "hole_deviations",
    "measuring_load_correction",
    "operating_batch",
    "operating_case",
    "operating_clearance",
    "outside_deviations",
    "sample_clearance",
    "shaft_deviations",
    "standard_tolerance",
    "usual_measuring_load",
]
