"""What the chain of clearances gives back: its steps, its limits, its warnings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import acos
from typing import Any, Final

from rolamento.case.bearing import Bearing, clearance_fits
from rolamento.clearance.band import Limit
from rolamento.errors import InputError
from rolamento.geometry import ring_geometry
from rolamento.units import from_si

__all__ = ["WARNINGS", "Limit", "OperatingClearance", "Step", "bearing_with_clearance"]

WARNINGS: Final[Mapping[str, str]] = {
    "interference": "The clearance in operation is negative at its mean: the balls are preloaded.",
    "interference_at_minimum": (
        "The clearance in operation is negative at its minimum: some bearings are preloaded."
    ),
    "inner_ring_loose": (
        "In operation nothing may be left of the inner ring's interference: it may creep."
    ),
    "outer_ring_loose": (
        "In operation nothing may be left of the outer ring's interference: it may creep."
    ),
    "tight_shaft": (
        "The inner ring's interference may be more than a thousandth of the bore: the ring may"
        " crack (NTN, Ball and Roller Bearings, chapter 7.3)."
    ),
}
"""What the user should know, by name."""


@dataclass(frozen=True, slots=True)
class Step:
    """One step of the chain; lengths in m.

    Attributes
    ----------
    name
        initial, measuring_load, shaft_fit, housing_fit, temperature, speed, wear
    change
        of the clearance, at its minimum, mean and maximum; of the first step the clearance itself
    clearance
        after the step
    formula, source
        in words
    details
        what went into it, SI, at the three limits
    """

    name: str
    change: tuple[float, float, float]
    clearance: tuple[float, float, float]
    formula: str
    source: str
    details: Mapping[str, tuple[float, float, float]]


@dataclass(frozen=True, slots=True)
class OperatingClearance:
    """The clearance in operation, with the steps that lead to it; m.

    Attributes
    ----------
    bearing
        before mounting
    steps
        in their order
    minimum, mean, maximum
        of the diametral clearance; the mean is that of mean dimensions
    warnings
        names in `WARNINGS`
    """

    bearing: Bearing
    steps: tuple[Step, ...]
    minimum: float
    mean: float
    maximum: float
    warnings: tuple[str, ...]

    def operating_bearing(self, limit: Limit = "mean") -> Bearing:
        """The bearing as it runs: with this clearance, or the contact angle that goes with it.

        Raises
        ------
        InputError
            If no bearing is left: the fits close it, or open it too far.
        """
        return bearing_with_clearance(self.bearing, getattr(self, limit))

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists, SI."""
        return {
            "minimum": self.minimum,
            "mean": self.mean,
            "maximum": self.maximum,
            "warnings": list(self.warnings),
            "steps": [
                {
                    "name": step.name,
                    "change": list(step.change),
                    "clearance": list(step.clearance),
                    "formula": step.formula,
                    "source": step.source,
                    "details": {name: list(values) for name, values in step.details.items()},
                }
                for step in self.steps
            ],
        }


def bearing_with_clearance(bearing: Bearing, clearance: float) -> Bearing:
    """A bearing of another clearance (m), or of the contact angle that goes with it.

    Raises
    ------
    InputError
        If the clearance closes the bearing, or opens it too far.
    """
    distance = ring_geometry(bearing).groove_centre_distance
    shown = from_si(float(f"{clearance:.4g}"), "length")
    angular = bearing.contact_angle is not None and bearing.contact_angle > 0.0
    if not clearance_fits(clearance, distance) or (angular and clearance < 0.0):
        way = "closes" if clearance < 0.0 else "opens too far"
        raise InputError(
            f"{way} the bearing: a clearance of {shown} in operation"
            + (" leaves no contact angle" if angular and clearance < 0.0 else " is out of reach"),
            field="mounting",
            example='a looser shaft_tolerance, or clearance_class = "C3"',
        )
    if angular:
        return bearing.replace(contact_angle=acos(1.0 - clearance / (2.0 * distance)))
    return bearing.replace(contact_angle=None, diametral_clearance=clearance)
