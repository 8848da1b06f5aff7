"""A bearing between its shaft and its housing, and the chain of what happens to its clearance.

All parts are linear and elastic, so that press fit, expansion and rotation superpose. What couples
them is the interference that is left in operation:

    δ_eff = max(δ - smoothing + expansion - rotation, 0).

The chain is computed for many bearings at once: what scatters comes as arrays.
"""

from __future__ import annotations

from math import inf
from typing import Any, Final, NamedTuple, cast

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case.bearing import Bearing
from rolamento.case.material import Material
from rolamento.case.mounting import Mounting, SeatMaterial
from rolamento.case.roller_bearing import RollerBearing
from rolamento.case.temperature import Temperature
from rolamento.clearance.effects import (
    Finish,
    bore_shrinkage,
    clearance_change,
    contact_pressure,
    expansion_of,
    finish_loss,
    interference_change,
    outside_growth,
    roughness_loss,
    spin_growth,
)
from rolamento.clearance.measuring_load import clearance_from_reading, usual_measuring_load
from rolamento.clearance.standards import (
    Band,
    ClearanceClass,
    Limit,
    bore_deviations,
    class_clearance,
    hole_deviations,
    outside_deviations,
    shaft_deviations,
)
from rolamento.errors import InputError
from rolamento.geometry import clearance_of_angle, groove_places
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.units import readable
from rolamento.words import marked, said

_WARMEST: Final = 1000.0


@frozen
class PartTemperatures:
    """Temperatures in operation; K, numbers or arrays (cases,). Without those of the rings: none.

    Attributes
    ----------
    inner_ring, outer_ring
        of the rings
    balls
        of balls or rollers; those of the inner ring if None
    shaft, housing
        at their seats; those of the rings if None
    inner_spacer, outer_spacer
        of the spacers between the rings; those of shaft and housing if None
    """

    inner_ring: Any = None
    outer_ring: Any = None
    balls: Any = None
    shaft: Any = None
    housing: Any = None
    inner_spacer: Any = None
    outer_spacer: Any = None


Temperatures = Temperature | PartTemperatures
"""What the clearance reads temperatures of: the table of a case, or their own record."""


class Strains(NamedTuple):
    """Free thermal strain α T of each part since assembly; numbers or arrays (cases,)."""

    inner_ring: Any
    outer_ring: Any
    balls: Any
    shaft: Any
    housing: Any
    inner_spacer: Any
    outer_spacer: Any


class FitState(NamedTuple):
    """A press fit in operation; arrays, m and Pa."""

    interference: FloatArray
    """δ as mounted, on nominal diameters."""
    smoothing: FloatArray
    expansion: float
    rotation: float
    effective: FloatArray
    pressure: FloatArray
    change: FloatArray
    """Change of the clearance; never above 0."""


@frozen
class _Seat:
    """One fit: where, of what, how smooth, and what operation adds to its interference."""

    diameter: float
    finish: Finish | None
    roughness: float | None
    expansion: float
    rotation: float

    def state(self, interference: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Loss by smoothing, and the interference that is left."""
        if self.finish is not None:
            lost = finish_loss(interference, self.diameter, self.finish)
        else:
            lost = roughness_loss(interference, 0.0 if self.roughness is None else self.roughness)
        left = interference - lost + self.expansion - self.rotation
        return lost, np.maximum(left, 0.0)


@frozen
class Assembly:
    """Bearing, seats, temperatures and speeds, checked and ready for the calculation; SI.

    Of a batch all numbers may be arrays (cases,).
    """

    bearing: Bearing | RollerBearing
    mounting: Mounting
    inner_raceway: float
    """Diameter at the bottom of the groove; of tapered rollers in the middle of their length."""
    outer_raceway: float
    initial_clearance: float
    """The bearing's own, or the one that goes with its contact angle."""
    expansion_change: float
    """Change of the clearance, by free expansion of rings and rolling elements."""
    spin_change: float
    """Change of the clearance, by free growth of the rings as they turn."""
    strains: Strains
    _shaft: _Seat
    _housing: _Seat

    def shaft_fit(self, interference: FloatArray) -> FitState:
        """Fit of the inner ring on the shaft for the interferences as mounted (m)."""
        lost, effective = self._shaft.state(interference)
        ring, mounting = self.bearing.ring_material, self.mounting
        pressure = contact_pressure(
            effective,
            mounting.bore,
            bore=mounting.shaft_bore,
            outside=self.inner_raceway,
            inner=mounting.shaft_material or ring,
            outer=ring,
        )
        growth = outside_growth(pressure, mounting.bore, self.inner_raceway, ring)
        seat = self._shaft
        return FitState(
            interference, lost, seat.expansion, seat.rotation, effective, pressure, 0.0 - growth
        )

    def housing_fit(self, interference: FloatArray) -> FitState:
        """Fit of the outer ring in the housing for the interferences as mounted (m)."""
        lost, effective = self._housing.state(interference)
        ring, mounting = self.bearing.ring_material, self.mounting
        outside = mounting.housing_outside_diameter
        pressure = contact_pressure(
            effective,
            mounting.outside_diameter,
            bore=self.outer_raceway,
            outside=inf if outside is None else outside,
            inner=ring,
            outer=mounting.housing_material or ring,
        )
        shrinkage = bore_shrinkage(pressure, mounting.outside_diameter, self.outer_raceway, ring)
        seat = self._housing
        return FitState(
            interference, lost, seat.expansion, seat.rotation, effective, pressure, 0.0 - shrinkage
        )


def assembly_of(
    bearing: Bearing | RollerBearing,
    mounting: Mounting,
    temperatures: Temperatures,
    inner_speed: float,
    outer_speed: float,
) -> Assembly:
    """Gather what the clearance in operation rests on.

    Raises
    ------
    InputError
        If the bearing is a set, has no inner ring, does not lie between bore and outside diameter,
        or a temperature or an expansion that is needed is missing.
    """
    if not bearing.is_one_bearing:
        raise InputError(
            said("is a set: the clearance is that of one of its rows"),
            field="bearing",
            example="bearing.places[0].bearing",
        )
    check_two_rings(bearing)
    assembly = gathered(bearing, mounting, temperatures, inner_speed, outer_speed)
    _check_rings_between_seats(mounting, assembly.inner_raceway, assembly.outer_raceway)
    return assembly


def gathered(
    bearing: Any, mounting: Any, temperatures: Any, inner_speed: ArrayLike, outer_speed: ArrayLike
) -> Assembly:
    """Gather it from records, or from objects with their attributes as arrays (cases,).

    Raises
    ------
    InputError
        If a temperature or an expansion that is needed is missing.
    """
    inner, outer, across, clearance = raceways(bearing)
    warm = _Rises.of(mounting, temperatures)
    ring_expansion = _expansion_if_warm(
        mounting.ring_expansion, bearing.ring_material, "ring_expansion", warm
    )
    ball_expansion = _expansion_if_warm(
        mounting.ball_expansion, bearing.element_material, "ball_expansion", warm
    )
    shaft, housing = mounting.shaft_material, mounting.housing_material
    of_shaft = shaft.thermal_expansion if shaft else ring_expansion
    of_housing = housing.thermal_expansion if housing else ring_expansion
    between, around = mounting.inner_spacer_material, mounting.outer_spacer_material
    inner_spin = _ring_growth(bearing.ring_material, mounting.bore, inner, inner_speed)
    outer_spin = _ring_growth(bearing.ring_material, outer, mounting.outside_diameter, outer_speed)
    return Assembly(
        bearing=bearing,
        mounting=mounting,
        inner_raceway=inner,
        outer_raceway=outer,
        initial_clearance=clearance,
        expansion_change=_number_or_array(
            clearance_change(
                inner_raceway=inner,
                outer_raceway=outer,
                ball_diameter=across,
                inner_rise=warm.inner,
                outer_rise=warm.outer,
                ball_rise=warm.balls,
                ring_expansion=ring_expansion,
                ball_expansion=ball_expansion,
            )
        ),
        spin_change=outer_spin[0] - inner_spin[1],
        strains=Strains(
            inner_ring=ring_expansion * warm.inner,
            outer_ring=ring_expansion * warm.outer,
            balls=ball_expansion * warm.balls,
            shaft=of_shaft * warm.shaft,
            housing=of_housing * warm.housing,
            inner_spacer=(between.thermal_expansion if between else of_shaft) * warm.inner_spacer,
            outer_spacer=(around.thermal_expansion if around else of_housing) * warm.outer_spacer,
        ),
        _shaft=_Seat(
            diameter=mounting.bore,
            finish=mounting.shaft_finish,
            roughness=mounting.shaft_roughness,
            expansion=interference_change(
                mounting.bore,
                inner_expansion=of_shaft,
                inner_rise=warm.shaft,
                outer_expansion=ring_expansion,
                outer_rise=warm.inner,
            ),
            rotation=inner_spin[0] - _shaft_growth(bearing, mounting, inner_speed),
        ),
        _housing=_Seat(
            diameter=mounting.outside_diameter,
            finish=mounting.housing_finish,
            roughness=mounting.housing_roughness,
            expansion=interference_change(
                mounting.outside_diameter,
                inner_expansion=ring_expansion,
                inner_rise=warm.outer,
                outer_expansion=of_housing,
                outer_rise=warm.housing,
            ),
            rotation=_housing_growth(bearing, mounting, outer_speed) - outer_spin[1],
        ),
    )


def warm_geometry(bearing: Any, strains: Strains) -> dict[str, Any]:
    """The sizes of a row as its temperatures leave them, by field; nothing where none are given.

    Groove radii follow their rings, elements and their ends their own temperature, and the pitch
    circle the mean of the rings, so that parts as warm as each other change nothing but the size;
    the cone of a tapered roller keeps its angle.

    Parameters
    ----------
    bearing
        The row, or its parameters in many cases.
    strains
        Of its rings and elements; numbers or arrays.
    """
    rings = np.asarray(strains.inner_ring), np.asarray(strains.outer_ring)
    elements = np.asarray(strains.balls)
    if not any(np.any(strain) for strain in (*rings, elements)):
        return {}
    pitch = np.asarray(bearing.pitch_diameter * (1.0 + 0.5 * (rings[0] + rings[1])))
    if bearing.bearing_type.has_rollers:
        diameter = np.asarray(bearing.roller_diameter * (1.0 + elements))
        arcs = {
            f"{name}_radius": np.asarray(radius * (1.0 + strain))
            for name, strain in (
                ("roller_profile", elements), ("roller_end", elements),
                ("inner_raceway", rings[0]), ("outer_raceway", rings[1]),
            )
            if (radius := getattr(bearing, f"{name}_radius")) is not None
        }  # fmt: skip
        cones = {"roller_half_angle": bearing.roller_half_angle}
        cones = cones if bearing.bearing_type.conical else {}  # warmth turns no angle
        return {"roller_diameter": diameter, "pitch_diameter": pitch, **arcs, **cones}
    inner, outer = ((1.0 + ring) / (1.0 + elements) for ring in rings)
    return {
        "ball_diameter": np.asarray(bearing.ball_diameter * (1.0 + elements)),
        "pitch_diameter": pitch,
        "inner_conformity": np.asarray(bearing.inner_conformity * inner),
        "outer_conformity": np.asarray(bearing.outer_conformity * outer),
    }


def raceways(bearing: Any) -> tuple[Any, Any, Any, Any]:
    """Diameters of the raceways, what an element takes of the radius between them, the clearance.

    All in m, numbers or arrays. Balls: at the bottom of the grooves, D. Rollers, whose axis is at β
    to the bearing's, that of barrels at the contact angle: d_pw - D_we cos β on the inner ring, in
    the middle of their length, D_we cos β, and what the clearance leaves around them; that of a
    tapered row counts from first contact.
    """
    if bearing.bearing_type.has_rollers:
        lean = 0.0
        if bearing.bearing_type.conical:
            lean = bearing.contact_angle - bearing.roller_half_angle
        elif bearing.bearing_type.barrels and bearing.contact_angle is not None:
            lean = bearing.contact_angle
        across = bearing.roller_diameter * np.cos(lean)
        clearance = 0.0 if bearing.bearing_type.conical else bearing.diametral_clearance
        inner = bearing.pitch_diameter - across
        return inner, inner + 2.0 * across + clearance, across, clearance
    angle, clearance = bearing.contact_angle, bearing.diametral_clearance
    places = groove_places(
        bearing.ball_diameter,
        bearing.pitch_diameter,
        bearing.inner_conformity,
        bearing.outer_conformity,
        contact_angle=angle,
        diametral_clearance=clearance,
    )
    if angle is not None:
        clearance = _number_or_array(
            clearance_of_angle(angle, places.inner_length + places.outer_length)
        )
    groove = bearing.inner_conformity * bearing.ball_diameter
    inner = _number_or_array(2.0 * (places.inner_groove_radius - groove))
    outer = inner + 2.0 * bearing.ball_diameter + clearance
    return inner, outer, bearing.ball_diameter, clearance


def _number_or_array(value: FloatArray) -> Any:
    """A plain number of an array without dimensions."""
    return value if value.ndim else float(value)


class _Rises(NamedTuple):
    """Temperatures above that of assembly; K."""

    inner: float
    outer: float
    balls: float
    shaft: float
    housing: float
    inner_spacer: float
    outer_spacer: float

    @classmethod
    def of(cls, mounting: Mounting, given: Temperatures) -> _Rises:
        start = mounting.assembly_temperature
        if given.inner_ring is None and given.outer_ring is None:
            for field in cls._fields[2:]:
                if getattr(given, field) is not None:
                    raise _missing_temperature("inner_ring", field)
            return cls(*(0.0 for _ in cls._fields))
        if given.inner_ring is None:
            raise _missing_temperature("inner_ring", "outer_ring")
        if given.outer_ring is None:
            raise _missing_temperature("outer_ring", "inner_ring")
        inner, outer = given.inner_ring, given.outer_ring
        balls = inner if given.balls is None else given.balls
        shaft = inner if given.shaft is None else given.shaft
        housing = outer if given.housing is None else given.housing
        between = shaft if given.inner_spacer is None else given.inner_spacer
        around = housing if given.outer_spacer is None else given.outer_spacer
        values = (inner, outer, balls, shaft, housing, between, around)
        for name, value in zip(PartTemperatures.__dataclass_fields__, values, strict=True):
            if not np.all((value > 0.0) & (value <= _WARMEST) | np.isnan(value)):
                raise InputError(
                    said("must be above 0 K and at most {most:.6g} K", most=_WARMEST),
                    field=f"temperature.{name}",
                    value=value,
                    example=f'{name} = "60 degC"',
                )
        return cls(*(value - start for value in values))


def _missing_temperature(field: str, beside: str) -> InputError:
    return InputError(
        said("is missing; with {beside}, the clearance needs both rings", beside=beside),
        field=f"temperature.{field}",
        example=f'{field} = "60 degC"',
    )


def _expansion_if_warm(given: Any, material: Any, field: str, warm: _Rises) -> Any:
    """Coefficient of expansion; without temperatures none is needed."""
    if given is not None:
        return given
    return expansion_of(material, f"mounting.{field}") if any(map(np.any, warm)) else 0.0


def _ring_growth(material: Any, bore: Any, outside: Any, speed: ArrayLike) -> tuple[Any, Any]:
    """Growth of bore and outside diameter of a ring."""
    first, second = (
        _number_or_array(spin_growth(speed, at, bore=bore, outside=outside, material=material))
        for at in (bore, outside)
    )
    return first, second


def _shaft_growth(bearing: Any, mounting: Any, speed: ArrayLike) -> Any:
    material: Material | SeatMaterial = mounting.shaft_material or bearing.ring_material
    return _number_or_array(
        spin_growth(
            speed, mounting.bore, bore=mounting.shaft_bore, outside=mounting.bore, material=material
        )
    )


def _housing_growth(bearing: Any, mounting: Any, speed: ArrayLike) -> Any:
    if not np.any(speed) or not (
        mounting.housing_tolerance or mounting.housing_interference is not None
    ):
        return 0.0
    if mounting.housing_outside_diameter is None:
        raise InputError(
            said("is missing; the expansion of a rotating housing depends on it"),
            field="mounting.housing_outside_diameter",
            example='housing_outside_diameter = "100 mm"',
        )
    material: Material | SeatMaterial = mounting.housing_material or bearing.ring_material
    return _number_or_array(
        spin_growth(
            speed,
            mounting.outside_diameter,
            bore=mounting.outside_diameter,
            outside=mounting.housing_outside_diameter,
            material=material,
        )
    )


def _check_rings_between_seats(mounting: Mounting, inner: float, outer: float) -> None:
    for field, value, rule, limit in (
        (
            "bore",
            inner - mounting.bore,
            marked("must be less than the diameter of the inner raceway, {limit}"),
            inner,
        ),
        (
            "outside_diameter",
            mounting.outside_diameter - outer,
            marked("must be greater than the diameter of the outer raceway, {limit}"),
            outer,
        ),
    ):
        if value <= 0.0:
            raise InputError(
                said(rule, limit=readable(float(f"{limit:.5g}"), "length")),
                field=f"mounting.{field}",
                value=readable(getattr(mounting, field), "length"),
            )


class ChainResult(NamedTuple):
    """The chain for many bearings at once; arrays."""

    initial: FloatArray
    shaft: FitState | None
    housing: FitState | None
    clearance: FloatArray


@frozen
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
        bearing: Bearing | RollerBearing,
        mounting: Mounting,
        temperatures: Temperatures | None,
        inner_speed: float,
        outer_speed: float,
    ) -> Chain:
        """Gather it all; InputError as of `operating_clearance`."""
        for field, speed in (("inner_speed", inner_speed), ("outer_speed", outer_speed)):
            if not abs(speed) <= 1e6:
                raise InputError(
                    said("must be at most 1e6 rad/s"), field=f"duty.{field}", value=speed
                )
        warm = PartTemperatures() if temperatures is None else temperatures
        assembly = assembly_of(bearing, mounting, warm, inner_speed, outer_speed)
        try:
            initial, reading = initial_band(assembly, bearing)
            return cls(assembly, initial, reading, shaft_bands(mounting), housing_bands(mounting))
        except InputError as error:
            raise error.with_details(field=f"mounting.{error.field}") from None

    def at(self, limit: Limit) -> FloatArray:
        """Clearance in operation at one of the limits: the minimum goes with the tightest fits."""
        shaft, housing = self.shaft, self.housing
        on_shaft = None if shaft is None else shaft.mirrored.at(limit)
        in_housing = None if housing is None else housing.mirrored.at(limit)
        return self.run(self.initial.at(limit), on_shaft, in_housing).clearance

    @property
    def shaft(self) -> Band | None:
        """Interference on the shaft."""
        return _total_band(self.shaft_parts)

    @property
    def housing(self) -> Band | None:
        """Interference in the housing."""
        return _total_band(self.housing_parts)

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


def initial_band(assembly: Assembly, bearing: Bearing | RollerBearing) -> tuple[Band, float | None]:
    """Clearance before mounting, without load, and the reading if it was measured.

    What a gauge reads of a roller bearing is its clearance: the approach under the measuring load
    is negligible (NSK, Rolling Bearings, E1102, page A88).
    """
    mounting = assembly.mounting
    _check_given_clearance(mounting, bearing)
    reading = mounting.measured_clearance
    named: str | None = mounting.clearance_class
    if named is None and reading is None:
        named = cast("ClearanceClass | None", bearing.clearance_class)
    if named is not None:
        return class_clearance(
            mounting.bore, named, bearing.bearing_type.clearance_table or ""
        ), None
    if reading is None:
        return Band(assembly.initial_clearance, assembly.initial_clearance), None
    found = reading
    if isinstance(bearing, Bearing):
        load = mounting.measuring_load or usual_measuring_load(mounting.bore)
        found = clearance_from_reading(bearing, reading, load)
    return Band(found, found), reading


def check_two_rings(bearing: Bearing | RollerBearing) -> None:
    """Refuse needle bearings whose inner raceway is the shaft: nothing is fitted on it."""
    if bearing.bearing_type.as_a_cage and bearing.resolved and not bearing.resolved.has_inner_ring:
        raise InputError(
            said("is for bearings with two rings: here the shaft is the inner raceway"),
            field="mounting",
            value=bearing.designation,
            example='[bearing] diametral_clearance = "0.01 mm"',
        )


def _check_given_clearance(mounting: Any, bearing: Bearing | RollerBearing) -> None:
    """Refuse a class or a reading of a bearing that is not given by its clearance."""
    given = [n for n in ("clearance_class", "measured_clearance") if getattr(mounting, n)]
    if given and bearing.bearing_type.conical:
        raise InputError(
            said("is not of tapered rollers: clearance or preload of a pair is set at mounting"),
            field=given[0],
            value=getattr(mounting, given[0]),
            example='[bearing] preload = { offset = "-20 um" }',
        )
    if given and bearing.contact_angle:
        raise InputError(
            said(
                "is for bearings given by their clearance; this one is given by its contact angle"
            ),
            field=given[0],
            value=getattr(mounting, given[0]),
        )
    if mounting.measuring_load is not None and bearing.bearing_type.has_rollers:
        raise InputError(
            said("applies to ball bearings; it has little effect on a roller bearing"),
            field="measuring_load",
            value=readable(mounting.measuring_load, "force"),
            example='measured_clearance = "0.045 mm"',
        )


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


def _total_band(bands: tuple[Band, ...]) -> Band | None:
    if not bands:
        return None
    return Band(sum(band.low for band in bands), sum(band.high for band in bands))
