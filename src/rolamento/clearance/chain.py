"""The chain of clearances for many bearings at once: what scatters, and what it leads to."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from rolamento.case.bearing import Bearing
from rolamento.case.mounting import Mounting
from rolamento.clearance.assembly import (
    Assembly,
    FitState,
    PartTemperatures,
    Temperatures,
    assembly_of,
)
from rolamento.clearance.band import Band, Limit
from rolamento.clearance.classes import class_clearance
from rolamento.clearance.iso286 import hole_deviations, shaft_deviations
from rolamento.clearance.iso492 import bore_deviations, outside_deviations
from rolamento.clearance.measuring_load import clearance_from_reading, usual_measuring_load
from rolamento.errors import InputError
from rolamento.numerics import FloatArray

__all__ = ["Chain", "ChainResult"]


class ChainResult(NamedTuple):
    """The chain for many bearings at once; arrays."""

    initial: FloatArray
    shaft: FitState | None
    housing: FitState | None
    clearance: FloatArray


@dataclass(frozen=True, slots=True)
class Chain:
    """The bands of what scatters, and the assembly that does not; m."""

    assembly: Assembly
    initial: Band
    reading: float | None
    """What a gauge showed, if the clearance was measured."""
    shaft_parts: tuple[Band, ...]
    housing_parts: tuple[Band, ...]

    @classmethod
    def of(
        cls,
        bearing: Bearing,
        mounting: Mounting,
        temperatures: Temperatures | None,
        inner_speed: float,
        outer_speed: float,
    ) -> Chain:
        """Gather it all; InputError as of `operating_clearance`."""
        for field, speed in (("inner_speed", inner_speed), ("outer_speed", outer_speed)):
            if not abs(speed) <= 1e6:
                raise InputError("must be at most 1e6 rad/s", field=f"duty.{field}", value=speed)
        warm = PartTemperatures() if temperatures is None else temperatures
        assembly = assembly_of(bearing, mounting, warm, inner_speed, outer_speed)
        try:
            initial, reading = initial_band(assembly, bearing)
            return cls(assembly, initial, reading, shaft_bands(mounting), housing_bands(mounting))
        except InputError as error:
            raise error.with_details(field=f"mounting.{error.field}") from None

    def at(self, limit: Limit) -> FloatArray:
        """Clearance in operation at one of the limits: the least goes with the tightest fits."""
        shaft, housing = self.shaft, self.housing
        on_shaft = None if shaft is None else shaft.mirrored.at(limit)
        in_housing = None if housing is None else housing.mirrored.at(limit)
        return self.run(self.initial.at(limit), on_shaft, in_housing).clearance

    @property
    def shaft(self) -> Band | None:
        """Interference on the shaft."""
        return _sum(self.shaft_parts)

    @property
    def housing(self) -> Band | None:
        """Interference in the housing."""
        return _sum(self.housing_parts)

    def run(
        self, initial: FloatArray, shaft: FloatArray | None, housing: FloatArray | None
    ) -> ChainResult:
        """Clearance in operation for initial clearances and interferences as mounted."""
        on_shaft = None if shaft is None else self.assembly.shaft_fit(shaft)
        in_housing = None if housing is None else self.assembly.housing_fit(housing)
        clearance = initial + self.assembly.expansion_change + self.assembly.spin_change
        clearance = clearance + self.assembly.mounting.wear
        for fit in (on_shaft, in_housing):
            clearance = clearance if fit is None else clearance + fit.change
        return ChainResult(initial, on_shaft, in_housing, clearance)


def initial_band(assembly: Assembly, bearing: Bearing) -> tuple[Band, float | None]:
    """Clearance before mounting, without load, and the reading if it was measured."""
    mounting = assembly.mounting
    given = [n for n in ("clearance_class", "measured_clearance") if getattr(mounting, n)]
    if given and bearing.contact_angle:
        raise InputError(
            "is for bearings given by their clearance; this one has a contact angle",
            field=given[0],
            value=getattr(mounting, given[0]),
        )
    if mounting.clearance_class is not None:
        return class_clearance(mounting.bore, mounting.clearance_class), None
    reading = mounting.measured_clearance
    if reading is None and bearing.clearance_class is not None:
        return class_clearance(mounting.bore, bearing.clearance_class), None
    if reading is not None:
        load = mounting.measuring_load or usual_measuring_load(mounting.bore)
        found = clearance_from_reading(bearing, reading, load)
        return Band(found, found), reading
    return Band(assembly.initial_clearance, assembly.initial_clearance), None


def shaft_bands(mounting: Mounting) -> tuple[Band, ...]:
    """What adds up to the interference on the shaft."""
    if mounting.shaft_interference is not None:
        return (Band(mounting.shaft_interference, mounting.shaft_interference),)
    if mounting.shaft_tolerance is None:
        return ()
    bore = bore_deviations(mounting.bore, mounting.tolerance_class)
    return shaft_deviations(mounting.bore, mounting.shaft_tolerance), Band(-bore.high, -bore.low)


def housing_bands(mounting: Mounting) -> tuple[Band, ...]:
    """What adds up to the interference in the housing."""
    if mounting.housing_interference is not None:
        return (Band(mounting.housing_interference, mounting.housing_interference),)
    if mounting.housing_tolerance is None:
        return ()
    diameter = mounting.outside_diameter
    hole = hole_deviations(diameter, mounting.housing_tolerance)
    return outside_deviations(diameter, mounting.tolerance_class), Band(-hole.high, -hole.low)


def _sum(bands: tuple[Band, ...]) -> Band | None:
    if not bands:
        return None
    return Band(sum(band.low for band in bands), sum(band.high for band in bands))
