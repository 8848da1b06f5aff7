"""The clearance in operation, step by step, at its limits and in its scatter.

The chain: clearance before mounting, less the excess reading under the measuring load, press fit on
the shaft, press fit in the housing, expansion, rotation, wear. Each step is a record of what it
adds to the clearance, with its formula and source.

The limits are those of all tolerances at their limits together: the minimum clearance goes with the
tightest fits. `sample_clearance` draws the tolerances independently instead.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from math import acos, tan
from typing import Any, Final, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.case.bearing import Bearing, clearance_fits
from rolamento.case.mounting import Mounting
from rolamento.case.roller_bearing import RollerBearing, roller_clearance_fits
from rolamento.case.temperature import Temperature
from rolamento.clearance.chain import (
    Assembly,
    Chain,
    ChainResult,
    Temperatures,
    warm_geometry,
)
from rolamento.clearance.measuring_load import usual_measuring_load
from rolamento.clearance.standards import (
    BEARING_TOLERANCE_SOURCE,
    TOLERANCE_SOURCE,
    Band,
    Limit,
    clearance_source,
)
from rolamento.errors import InputError
from rolamento.geometry import ring_geometry
from rolamento.numerics import FloatArray
from rolamento.numerics.percentiles import percentile
from rolamento.records import frozen
from rolamento.units import readable
from rolamento.validate import generator, one_of, whole_number
from rolamento.words import Note, said


@frozen
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
        by what it is calculated, and from where
    details
        what went into it, SI, at the three limits
    """

    name: str
    change: tuple[float, float, float]
    clearance: tuple[float, float, float]
    formula: Note
    source: Note
    details: Mapping[str, tuple[float, float, float]]


@frozen
class OperatingClearance:
    """The clearance in operation, with the steps that lead to it; m.

    Attributes
    ----------
    bearing
        before mounting
    warm_bearing
        before mounting, with the sizes that the temperatures leave
    steps
        in their order
    minimum, mean, maximum
        of the diametral clearance; the mean is that of mean dimensions
    warnings
        what to know about it
    """

    bearing: Bearing | RollerBearing
    warm_bearing: Bearing | RollerBearing
    steps: tuple[Step, ...]
    minimum: float
    mean: float
    maximum: float
    warnings: tuple[Note, ...]

    def operating_bearing(self, limit: Limit = "mean") -> Bearing | RollerBearing:
        """The bearing as it runs: with this clearance, or the contact angle that goes with it.

        A tapered row is as it was: what it gains or loses moves its first contact, from which x
        counts.

        Raises
        ------
        InputError
            If no bearing is left: the fits close it, or open it too far.
        """
        return bearing_with_clearance(self.warm_bearing, getattr(self, limit))

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists, SI."""
        return {
            "minimum": self.minimum,
            "mean": self.mean,
            "maximum": self.maximum,
            "warnings": [note.to_mapping() for note in self.warnings],
            "steps": [
                {
                    "name": step.name,
                    "change": list(step.change),
                    "clearance": list(step.clearance),
                    "formula": step.formula.to_mapping(),
                    "source": step.source.to_mapping(),
                    "details": {name: list(values) for name, values in step.details.items()},
                }
                for step in self.steps
            ],
        }


def bearing_with_clearance(
    bearing: Bearing | RollerBearing, clearance: float
) -> Bearing | RollerBearing:
    """A bearing of another clearance (m), or of the contact angle that goes with it.

    Raises
    ------
    InputError
        If the clearance closes the bearing, or opens it too far.
    """
    shown = readable(float(f"{clearance:.4g}"), "length")
    if isinstance(bearing, RollerBearing):
        if bearing.bearing_type.conical:
            return bearing
        if not roller_clearance_fits(clearance, bearing.roller_diameter):
            raise _beyond(shown, closed=clearance < 0.0)
        return bearing.replace(diametral_clearance=clearance)
    distance = ring_geometry(bearing).groove_centre_distance
    angular = bearing.contact_angle is not None and bearing.contact_angle > 0.0
    if not clearance_fits(clearance, distance) or (angular and clearance < 0.0):
        raise _beyond(shown, closed=clearance < 0.0, angular=angular)
    if angular:
        return bearing.replace(contact_angle=acos(1.0 - clearance / (2.0 * distance)))
    return bearing.replace(contact_angle=None, diametral_clearance=clearance)


def _beyond(clearance: str, *, closed: bool, angular: bool = False) -> InputError:
    """Error of a mounting that leaves no bearing."""
    if not closed:
        rule = said(
            "opens the bearing too far: its operating clearance would be {clearance}",
            clearance=clearance,
        )
    elif angular:
        rule = said(
            "closes the bearing: an operating clearance of {clearance} leaves no contact angle",
            clearance=clearance,
        )
    else:
        rule = said(
            "closes the bearing: its operating clearance would be {clearance}", clearance=clearance
        )
    example = 'a looser shaft_tolerance, or clearance_class = "C3"'
    return InputError(rule, field="mounting", example=example)


_TIGHTEST: Final = 1e-3
"""Maximum interference over the bore. NTN, Ball and Roller Bearings, chapter 7.3.3."""


def operating_clearance(
    bearing: Bearing | RollerBearing,
    mounting: Mounting,
    temperatures: Temperatures | None = None,
    *,
    inner_speed: float = 0.0,
    outer_speed: float = 0.0,
) -> OperatingClearance:
    """Clearance of a mounted bearing in operation, each step shown.

    Parameters
    ----------
    bearing
        Before mounting; one row.
    mounting
        A `Mounting`.
    temperatures
        A `PartTemperatures`; everything as at assembly if not given.
    inner_speed, outer_speed
        Of the rings with shaft and housing, in rad/s.

    Raises
    ------
    InputError
        If something is missing, contradicts itself or is not in the tables.
    """
    chain = Chain.of(bearing, mounting, temperatures, inner_speed, outer_speed)
    tight = chain.shaft and chain.shaft.mirrored
    held = chain.housing and chain.housing.mirrored
    result = chain.run(_at_limits(chain.initial), _at_limits(tight), _at_limits(held))
    steps = _chain_steps(chain, result)
    low, mean, high = steps[-1].clearance
    sizes = warm_geometry(bearing, chain.assembly.strains)
    warm = bearing.replace(**{name: float(size) for name, size in sizes.items()})
    warnings = _warnings(chain, result, low, mean)
    return OperatingClearance(bearing, warm if sizes else bearing, steps, low, mean, high, warnings)


def clearance_of_case(case: Case) -> OperatingClearance:
    """Clearance in operation of a case that has a mounting, at its temperatures and speeds.

    Raises
    ------
    InputError
        As `operating_clearance`, and if the case has no mounting.
    """
    if case.mounting is None:
        raise InputError(
            said("is missing: without it the bearing runs at its own clearance"),
            field="mounting",
            example='mounting = { bore = "25 mm", outside_diameter = "62 mm" }',
        )
    return _clearance_of(_Mounted.of(case, case.mounting))


class _Mounted(NamedTuple):
    """What the clearance of a case depends on.

    given: the user's own fields, which bearings that are equal may differ in.
    """

    bearing: Bearing | RollerBearing
    given: frozenset[str]
    mounting: Mounting
    temperature: Temperature | None
    inner_speed: float
    outer_speed: float

    @classmethod
    def of(cls, case: Case, mounting: Mounting) -> _Mounted:
        bearing, duty = case.bearing, case.duty
        given = frozenset(bearing.model_fields_set)
        speeds = duty.inner_speed, duty.outer_speed
        return cls(bearing, given, mounting, case.temperature, *speeds)


@lru_cache(maxsize=256)
def _clearance_of(one: _Mounted) -> OperatingClearance:
    """Found once: what solves a case asks, then what shows it, and the next of another load."""
    return operating_clearance(
        one.bearing,
        one.mounting,
        one.temperature,
        inner_speed=one.inner_speed,
        outer_speed=one.outer_speed,
    )


@lru_cache(maxsize=256)
def _running(one: _Mounted) -> Bearing | RollerBearing:
    """The bearing as it runs; found once likewise."""
    return _clearance_of(one).operating_bearing(one.mounting.limit)


def operating_case(case: Case) -> Case:
    """The case with its bearing as it runs, and no mounting; what `solve` solves.

    A case without a mounting is returned as it is.

    Raises
    ------
    InputError
        As `operating_clearance`, and if no bearing is left.
    """
    if case.mounting is None:
        return case
    running = _running(_Mounted.of(case, case.mounting))
    warm = case.temperature
    of_bearing = None if warm is None else warm.of_bearing
    # of parts that are valid, and agreed with each other as they were delivered
    parts = {"bearing": running, "mounting": None, "temperature": of_bearing}
    return case.model_copy(update=parts)


def _at_limits(band: Any) -> Any:
    """Minimum, mean and maximum as an array; None of None."""
    return None if band is None else np.array([band.low, band.middle, band.high])


def _numbers_at_limits(values: NDArray[np.float64] | float) -> tuple[float, float, float]:
    if np.size(values) == 1:
        one = np.asarray(values, np.float64).item()
        return one, one, one
    low, mean, high = np.asarray(values).tolist()
    return low, mean, high


def _chain_steps(chain: Chain, result: ChainResult) -> tuple[Step, ...]:
    assembly, mounting = chain.assembly, chain.assembly.mounting
    conical = assembly.bearing.bearing_type.conical
    steps: list[Step] = []

    def add(name: str, change: Any, formula: str, source: Note, **details: Any) -> None:
        before = np.array(steps[-1].clearance) if steps else np.zeros(3)
        shown = {key: _numbers_at_limits(value) for key, value in details.items()}
        after = _numbers_at_limits(before + change)
        steps.append(Step(name, _numbers_at_limits(change), after, Note(formula), source, shown))

    if chain.reading is None:
        add("initial", result.initial, "step_initial", _origin_of_clearance(assembly))
    else:
        add("initial", chain.reading, "step_reading", Note("source_measured"))
        if isinstance(assembly.bearing, Bearing):
            add(
                "measuring_load",
                result.initial - chain.reading,
                "step_measuring_load",
                Note("source_equilibrium"),
                load=mounting.measuring_load or usual_measuring_load(mounting.bore),
            )
    standards = {"tolerances": TOLERANCE_SOURCE, "bearing": BEARING_TOLERANCE_SOURCE}
    for name, fit, given in (
        ("shaft_fit", result.shaft, mounting.shaft_tolerance),
        ("housing_fit", result.housing, mounting.housing_tolerance),
    ):
        if fit is not None:
            by_tolerances = Note("source_tolerances", standards)
            add(
                name,
                fit.change,
                f"step_{name}",
                Note("source_fit") if given is None else by_tolerances,
                interference=fit.interference,
                smoothing=fit.smoothing,
                expansion=fit.expansion,
                rotation=fit.rotation,
                effective_interference=fit.effective,
                pressure=fit.pressure,
            )
    if assembly.expansion_change:
        add(
            "temperature",
            assembly.expansion_change,
            "step_temperature_tapered" if conical else "step_temperature",
            Note("source_temperature"),
            inner_raceway=assembly.inner_raceway,
            outer_raceway=assembly.outer_raceway,
        )
    if assembly.spin_change:
        add("speed", assembly.spin_change, "step_speed", Note("source_speed"))
    if mounting.wear:
        add("wear", mounting.wear, "step_wear", Note("source_given"))
    return tuple(steps)


def _origin_of_clearance(assembly: Assembly) -> Note:
    if assembly.bearing.bearing_type.conical:
        return Note("source_first_contact")
    named = assembly.mounting.clearance_class or assembly.bearing.clearance_class
    if named is not None:
        source = clearance_source(named, assembly.bearing.bearing_type.clearance_table or "")
        return Note("source_clearance_class", {"standard": source, "name": named})
    return Note("source_own_clearance")


def _warnings(chain: Chain, result: ChainResult, low: float, mean: float) -> tuple[Note, ...]:
    found = []
    of_bearing = chain.assembly.bearing.bearing_type
    if low < 0.0 and not of_bearing.conical:  # of which only first contact moves
        of_mean = "interference_of_rollers" if of_bearing.has_rollers else "interference"
        found.append(of_mean if mean < 0.0 else "interference_at_minimum")
    for name, fit in (("inner_ring_loose", result.shaft), ("outer_ring_loose", result.housing)):
        if fit is not None and fit.interference[1] > 0.0 and fit.effective.min() <= 0.0:
            found.append(name)
    shaft = chain.shaft
    if shaft is not None and shaft.high > _TIGHTEST * chain.assembly.mounting.bore:
        found.append("tight_shaft")
    return tuple(map(Note, found))


def clearance_notes(found: OperatingClearance) -> tuple[Note, ...]:
    """The clearance in operation and its warnings."""
    if found.bearing.bearing_type.conical:
        shift = -0.5 * found.mean / tan(found.bearing.row_angle)
        return (Note("first_contact_moves", {"shift": shift}), *found.warnings)
    limits = {"minimum": found.minimum, "mean": found.mean, "maximum": found.maximum}
    return (Note("clearance_in_operation", limits), *found.warnings)


PERCENTILES: Final = (0.135, 5.0, 50.0, 95.0, 99.865)
"""Per cent of the samples: the outer ones lie three standard deviations from the mean."""
_MAX_SAMPLES: Final = 1_000_000
_SIGMAS: Final = 3.0


@frozen(eq=False)
class ClearanceSamples:
    """Clearances in operation of many bearings, drawn from their tolerances; m.

    Attributes
    ----------
    clearance
        (samples,)
    shaft_interference, housing_interference
        (samples,) as mounted, negative for a gap; NaN where the ring has no seat
    shaft_effective, housing_effective
        (samples,) of it left in operation
    preloaded
        share of the samples with a negative clearance, 0 to 1
    """

    clearance: FloatArray
    shaft_interference: FloatArray
    housing_interference: FloatArray
    shaft_effective: FloatArray
    housing_effective: FloatArray
    preloaded: float

    @property
    def mean(self) -> float:
        """Mean of the clearance."""
        return float(self.clearance.mean())

    @property
    def standard_deviation(self) -> float:
        """Standard deviation of the clearance, with n - 1; NaN of one sample."""
        return float(self.clearance.std(ddof=1)) if len(self.clearance) > 1 else np.nan

    def to_mapping(self) -> dict[str, Any]:
        """Give the scatter of the clearance as plain values, m."""
        return {
            "count": len(self.clearance),
            "mean": self.mean,
            "standard_deviation": self.standard_deviation,
            "percentiles": {f"{p:g}": self.percentile(p) for p in PERCENTILES},
            "preloaded": self.preloaded,
        }

    def percentile(self, percent: float) -> float:
        """Clearance below which so many per cent of the samples lie; NaN of too few samples."""
        return percentile(self.clearance, percent)


def sample_clearance(
    bearing: Bearing | RollerBearing,
    mounting: Mounting,
    temperatures: Temperatures | None = None,
    *,
    inner_speed: float = 0.0,
    outer_speed: float = 0.0,
    samples: int = 10_000,
    seed: int = 0,
    distribution: Literal["normal", "uniform"] = "normal",
) -> ClearanceSamples:
    """Clearances in operation of many bearings whose dimensions scatter within their tolerances.

    Parameters
    ----------
    samples
        1 to a million.
    seed
        Of the random numbers: the same seed draws the same bearings.
    distribution
        Of each dimension over its band, independent of the others: ``"normal"`` about the middle,
        the limits three standard deviations away and never passed, or ``"uniform"``.

    The others are as of `operating_clearance`.

    Raises
    ------
    InputError
        As `operating_clearance`, or if one of these three is out of range.
    """
    whole_number(samples, "samples", 1, _MAX_SAMPLES)
    random = generator(seed)
    one_of(distribution, "distribution", ("normal", "uniform"))
    chain = Chain.of(bearing, mounting, temperatures, inner_speed, outer_speed)
    draws = _Draws(random, samples, distribution)
    initial = draws.over(chain.initial)
    on_shaft = None if chain.shaft is None else draws.total(chain.shaft_parts)
    in_housing = None if chain.housing is None else draws.total(chain.housing_parts)
    result = chain.run(initial, on_shaft, in_housing)
    nothing = np.full(samples, np.nan)
    shaft, housing = result.shaft, result.housing
    return ClearanceSamples(
        clearance=result.clearance,
        shaft_interference=nothing if shaft is None else shaft.interference,
        housing_interference=nothing if housing is None else housing.interference,
        shaft_effective=nothing if shaft is None else shaft.effective,
        housing_effective=nothing if housing is None else housing.effective,
        preloaded=float(np.mean(result.clearance < 0.0)),
    )


class _Draws(NamedTuple):
    """Independent draws from bands."""

    random: np.random.Generator
    size: int
    distribution: str

    def over(self, band: Band) -> FloatArray:
        share = self.random.random(self.size)
        if self.distribution == "normal":
            from scipy.special import ndtr, ndtri

            tail = float(ndtr(-_SIGMAS))
            share = 0.5 + ndtri(tail + share * (1.0 - 2.0 * tail)) / (2.0 * _SIGMAS)
        return np.asarray(band.low + share * (band.high - band.low))

    def total(self, bands: tuple[Band, ...]) -> FloatArray:
        return np.asarray(sum(self.over(band) for band in bands))
