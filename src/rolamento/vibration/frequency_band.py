"""Uncertainty of fault frequencies: bands, and the other geometries that ratings allow.

The bands are intervals: every line is monotonic in ball diameter, pitch diameter, contact angle,
slip and each ring's speed as long as the others stay where they are, so the extremes lie at the
corners, and nothing is lost to a first order.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import partial
from itertools import product
from math import pi
from typing import Final, NamedTuple

from rolamento.case.bearing import Bearing
from rolamento.case.roller_bearing import RollerBearing
from rolamento.catalogue import RollerCandidate
from rolamento.errors import InputError
from rolamento.geometry import ring_geometry
from rolamento.records import frozen
from rolamento.vibration.frequencies import (
    LINES,
    AngleChoice,
    FaultFrequencies,
    FaultLine,
    LineBand,
    LineName,
    check_angle,
    line_orders,
    nominal_angle,
    nominal_frequencies,
    shaft_of,
    turns_of,
)
from rolamento.words import Note, said

_RIGHT_ANGLE: Final = 0.5 * pi
_LEAST_GAP: Final = 1e-9
"""By which a pitch diameter stays above the balls', relatively."""
_DECIDED: Final = 0.95
"""Share of one number of rollers from which on it is taken as known."""
_MOST_COUNTS: Final = 4
Interval = tuple[float, float]


@frozen(kw_only=True)
class Tolerances:
    """By how much the figures may be off, up and down.

    Attributes
    ----------
    ball_diameter, pitch_diameter
        in m
    contact_angle
        in rad; by default, a bearing given by its clearance may have any angle from 0 to its free
        contact angle
    speed
        of both rings, as a part of each
    slip
        in addition to the slip given, 0 to 1: the cage may lag by as much more
    candidates
        whether the alternatives of an estimated geometry are taken in
    """

    ball_diameter: float = 0.0
    pitch_diameter: float = 0.0
    contact_angle: float | None = None
    speed: float = 0.0
    slip: float = 0.0
    candidates: bool = True

    def __post_init__(self) -> None:
        limits = {
            "ball_diameter": 1.0,
            "pitch_diameter": 20.0,
            "contact_angle": _RIGHT_ANGLE,
            "speed": 1.0,
            "slip": 1.0,
        }
        for field, most in limits.items():
            value = getattr(self, field)
            if value is not None and not 0.0 <= value <= most:
                raise InputError(
                    said("must be at least 0 and at most {most:.4g}", most=most),
                    field=field,
                    value=value,
                    example=f"{field} = 0.0",
                )


@frozen
class Alternative:
    """One internal geometry that a bearing's ratings allow, and the orders that it would have.

    Attributes
    ----------
    rank, share
        1 for the best; its part of the likelihood
    ball_count, ball_diameter, pitch_diameter
        Z, D and d_m (m)
    reproduces
        whether it gives every printed rating
    orders
        of the shaft, by the names of the lines
    """

    rank: int
    share: float
    ball_count: int
    ball_diameter: float
    pitch_diameter: float
    reproduces: bool
    orders: Mapping[LineName, float]


class _Place(NamedTuple):
    """Intervals of what the orders depend on, for one count of balls."""

    ball_count: int
    ball: Interval
    pitch: Interval
    angle: Interval


def alternatives_of(
    bearing: Bearing | RollerBearing,
    inner_speed: float | None = None,
    outer_speed: float = 0.0,
    *,
    slip: float = 0.0,
    contact_angle: float | AngleChoice = "zero",
) -> tuple[Alternative, ...]:
    """Orders of every geometry that the bearing's ratings allow; empty if its balls are known.

    Parameters as of `nominal_frequencies`.
    """
    inner, outer = shaft_of(inner_speed, outer_speed).ratios
    check_angle(bearing, contact_angle)
    angle, _ = nominal_angle(bearing, contact_angle)
    found = []
    for one in _candidates(bearing):
        turns = turns_of(one.diameter / one.pitch, angle, inner, outer, slip)
        orders = {name: abs(o) for name, o in line_orders(turns, one.elements).items()}
        found.append(
            Alternative(
                one.rank, one.share, one.elements, one.diameter, one.pitch, one.reproduces, orders
            )
        )
    return tuple(found)


def open_counts(bearing: Bearing | RollerBearing) -> tuple[Note, ...]:
    """Say how many rollers there may be where the ratings do not decide it; empty of balls."""
    shares = roller_counts(bearing)
    if len(shares) < 2 or max(shares.values()) > _DECIDED:
        return ()
    counts = sorted(shares.items(), key=lambda item: -item[1])[:_MOST_COUNTS]
    return (Note("roller_count_open", {"shares": [list(item) for item in counts]}),)


def roller_counts(bearing: Bearing | RollerBearing) -> dict[int, float]:
    """Return the numbers of rollers that the ratings allow, with their shares; empty of balls."""
    shares: dict[int, float] = {}
    for one in _candidates(bearing) if bearing.element != "ball" else ():
        shares[one.elements] = shares.get(one.elements, 0.0) + one.share
    return shares


def banded_frequencies(
    bearing: Bearing | RollerBearing,
    inner_speed: float | None = None,
    outer_speed: float = 0.0,
    *,
    slip: float = 0.0,
    contact_angle: float | AngleChoice = "zero",
    tolerances: Tolerances | None = None,
) -> FaultFrequencies:
    """Fault frequencies by the geometry, each with the band that uncertainty leaves open.

    Parameters
    ----------
    bearing, inner_speed, outer_speed, slip, contact_angle
        As of `nominal_frequencies`.
    tolerances
        By how much what may be off. Those of an estimated geometry, of an assumed angle, and
        whatever is given, are taken at their worst together.

    Returns
    -------
    FaultFrequencies
        With a `LineBand` at every line, of intervals: no first-order estimate.
    """
    allowed = tolerances or Tolerances()
    found = nominal_frequencies(
        bearing, inner_speed, outer_speed, slip=slip, contact_angle=contact_angle
    )
    banded = partial(_with_bands, slip=(slip, min(slip + allowed.slip, 1.0)), speed=allowed.speed)
    rows = [
        banded(row, _places(place.bearing, contact_angle, allowed))
        for row, place in zip(found.rows or (found,), bearing.element_rows, strict=True)
    ]
    return rows[0] if not found.rows else replace(rows[0], rows=tuple(rows))


def _with_bands(
    found: FaultFrequencies, places: Iterable[_Place], slip: Interval, speed: float
) -> FaultFrequencies:
    """Return frequencies with bands over all corners of all places."""
    shaft = found.shaft_frequency
    inner, outer = found.turns.inner, found.turns.outer
    orders: dict[LineName, list[Interval]] = {name: [] for name in LINES}
    sizes: dict[LineName, list[Interval]] = {name: [] for name in LINES}
    for place in places:
        ratios = product((inner,), _ratios(outer, speed) if inner else (outer,))
        for name, interval in _extremes(place, ratios, slip).items():
            orders[name].append(interval)
        speeds = product(_around(inner, speed), _around(outer, speed))
        for name, interval in _extremes(place, speeds, slip).items():
            sizes[name].append(interval)
    lines = {
        name: _banded(line, orders[name], sizes[name], shaft) for name, line in found.lines.items()
    }
    return found.with_lines(lines)


def _banded(
    line: FaultLine, orders: list[Interval], sizes: list[Interval], shaft: float
) -> FaultLine:
    low, high = (f(o[i] for o in orders) for i, f in enumerate((min, max)))
    least, most = (f(s[i] for s in sizes) for i, f in enumerate((min, max)))
    return replace(line, band=LineBand(low, high, least * shaft, most * shaft))


def _extremes(
    place: _Place, speeds: Iterable[tuple[float, float]], slip: Interval
) -> dict[LineName, Interval]:
    """Return the minimum and maximum size of every line over all corners."""
    corners: dict[LineName, list[float]] = {name: [] for name in LINES}
    geometry = list(product(place.ball, place.pitch, place.angle, slip))
    for inner, outer in speeds:
        for ball, pitch, angle, lag in geometry:
            turns = turns_of(ball / max(pitch, ball * (1.0 + _LEAST_GAP)), angle, inner, outer, lag)
            for name, order in line_orders(turns, place.ball_count).items():
                corners[name].append(order)
    return {name: _sizes(values) for name, values in corners.items()}


def _sizes(values: list[float]) -> Interval:
    """Return the minimum and maximum magnitude in an interval: 0 if it holds 0."""
    low, high = min(values), max(values)
    least = 0.0 if low <= 0.0 <= high else min(abs(low), abs(high))
    return least, max(abs(low), abs(high))


def _ratios(outer: float, part: float) -> Interval:
    """Return the outer ring's speed over the shaft's, the inner ring's, where both may be off."""
    return outer * (1.0 - part) / (1.0 + part), outer * (1.0 + part) / max(1.0 - part, _LEAST_GAP)


def _around(value: float, part: float) -> Interval:
    return value * (1.0 - part), value * (1.0 + part)


def _places(
    bearing: Bearing | RollerBearing, contact_angle: float | AngleChoice, allowed: Tolerances
) -> list[_Place]:
    """Return the geometry as it is given, and those that the ratings also allow."""
    angles = _angles(bearing, contact_angle, allowed)
    size, pitch = bearing.element_diameter, bearing.pitch_diameter
    insides = [(bearing.element_count, (size, size), (pitch, pitch))]
    if allowed.candidates:
        insides += [
            (one.elements, one.diameter_range, one.pitch_range)
            for one in _candidates(bearing)
            if one.reproduces or one.rank == 1
        ]
    return [
        _Place(
            count,
            (max(least - allowed.ball_diameter, least * _LEAST_GAP), most + allowed.ball_diameter),
            (low - allowed.pitch_diameter, high + allowed.pitch_diameter),
            angles,
        )
        for count, (least, most), (low, high) in insides
    ]


def _angles(
    bearing: Bearing | RollerBearing, contact_angle: float | AngleChoice, allowed: Tolerances
) -> Interval:
    angle, _ = nominal_angle(bearing, contact_angle)
    if isinstance(bearing, RollerBearing) and not bearing.bearing_type.conical:
        return angle, angle
    if allowed.contact_angle is not None:
        spread = allowed.contact_angle
        return max(angle - spread, 0.0), min(angle + spread, _RIGHT_ANGLE)
    if isinstance(bearing, RollerBearing):
        return angle, angle
    if bearing.contact_angle is None and isinstance(contact_angle, str):
        return 0.0, ring_geometry(bearing).free_contact_angle
    return angle, angle


class _Inside(NamedTuple):
    """What may roll in a bearing, by its ratings; m."""

    rank: int
    share: float
    elements: int
    diameter: float
    diameter_range: Interval
    pitch: float
    pitch_range: Interval
    reproduces: bool


def _candidates(bearing: Bearing | RollerBearing) -> list[_Inside]:
    """Return which other balls or rollers are possible, if inferred and not the user's own."""
    resolved = bearing.resolved
    if resolved is None or "inferred" not in bearing.origins.values():
        return []
    found = []
    given = bearing.origins.get("roller_count") == "given"
    for one in resolved.candidates:
        if isinstance(one, RollerCandidate):
            if given and one.roller_count != bearing.element_count:
                continue
            count, diameter = one.roller_count, one.roller_diameter
            sizes = one.roller_diameter_range
        else:
            count, diameter = one.ball_count, one.ball_diameter
            sizes = (diameter, diameter)
        pitch = (one.pitch_diameter, one.pitch_diameter_range)
        found.append(_Inside(one.rank, one.weight, count, diameter, sizes, *pitch, one.reproduces))
    return found
