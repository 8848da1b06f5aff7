"""The hidden inside of a roller bearing, inferred from its raceways and its ratings.

Where both raceways are printed, D_we = (E_w - F_w)/2 and d_pw = (E_w + F_w)/2. Where they are not,
the ratings give the diameter: by ISO 281 and ISO 76

    C^(9/7)/C_0 ~ D_we^0.38 Z^(-1/28),

so that they give D_we within some two parts in a hundred whatever the number of rollers: one
diameter of the standard rollers, or that of a tapered roller, which is of no standard. Then C_0
gives Z L_we. The ratings determine the number of rollers poorly: all counts that fill the pitch
circle as rollers usually do are candidates, each with its length, and what they share says how
sure the first is.

Sources: ISO 281:2007, 7.1; ISO 76:2006, 7.1; the contact angle of tapered bearings by
ISO 281:2007, table 7: e = 1.5 tan α.
"""

from __future__ import annotations

from math import atan, exp, pi, sqrt
from typing import Any, Final, NamedTuple

import numpy as np

from rolamento.catalogue.records import CatalogueBearing
from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.numerics import FloatArray
from rolamento.ratings import roller_dynamic_rating, roller_static_rating
from rolamento.records import frozen
from rolamento.words import said

__all__ = ["RollerCandidate", "inferred_rollers", "nominal_angle", "roller_diameters"]

MAX_CANDIDATES: Final = 8
_CREDIBLE: Final = 3.0
"""Tolerances within which a candidate reproduces a rating."""
_FARTHEST: Final = 9.0
"""A candidate is left out beyond this much more of squared misfit than the best."""
_FILLINGS: Final = (0.4, 1.0)
_FREE_SHARES: Final = np.linspace(0.36, 0.62, 131)
"""Fractions of the section height, diameters of tapered and barrel-shaped rollers that are tried:
they are of no standard."""
_SHARES: Final = (0.20, 0.90)
_PITCHES: Final = (0.99, 1.0, 1.01)
"""Fractions of the mean diameter, of bearings that print no raceway."""
_TENTH_OF_MICROMETRE: Final = 7
_ROUNDING: Final = 1e-9


@frozen(kw_only=True)
class RollerCandidate:
    """One inside that could have the printed ratings.

    Attributes
    ----------
    rank
        1 for the best.
    roller_count, roller_diameter, effective_length, pitch_diameter
        Z, D_we (in the middle of a tapered roller), L_we and d_pw, in m.
    roller_diameter_range, effective_length_range, pitch_diameter_range
        Minimum and maximum that fits about as well with this count, in m.
    misfit
        Root mean square of the differences over their tolerances: 1 is as good as usual.
    weight
        Share of this candidate in the likelihood of all.
    dynamic_error, static_error
        Relative difference of the computed from the printed C and C_0; None if not printed.
    rating_factor
        By which the maker rates C higher than ISO 281.
    filling
        Part of the pitch circle that the rollers take.
    reproduces
        Whether every printed rating is within three tolerances.
    rests_on
        Names of the figures that it was inferred from.
    """

    rank: int
    roller_count: int
    roller_diameter: float
    effective_length: float
    pitch_diameter: float
    roller_diameter_range: tuple[float, float]
    effective_length_range: tuple[float, float]
    pitch_diameter_range: tuple[float, float]
    misfit: float
    weight: float
    dynamic_error: float | None
    static_error: float | None
    rating_factor: float
    filling: float
    reproduces: bool
    rests_on: tuple[str, ...]


def roller_diameters() -> FloatArray:
    """Return the diameters of standard cylindrical rollers and needles in m, rising."""
    return 1e-3 * np.array(toml_of("rating_practice")["rollers"]["diameters_mm"], dtype=np.float64)


def nominal_angle(bearing: CatalogueBearing) -> float:
    """Return α in rad: published, else by e or Y where makers list these, else 0; of washers 90°.

    ISO 281:2007, table 8: e = 1.5 tan α; of one row Y = 0.4 cot α, of two Y = 0.45 cot α up to e,
    which is printed with more digits than e is.
    """
    if bearing.contact_angle is not None:
        return bearing.contact_angle
    if bearing.type.washers:
        return 0.5 * pi
    if not bearing.type.axial_limit_of_maker:
        return 0.0
    two, factor = bearing.rows > 1, bearing.axial_factor
    if factor is not None and (two or bearing.axial_limit is None):
        return atan((0.45 if two else 0.4) / factor)
    return 0.0 if bearing.axial_limit is None else atan(bearing.axial_limit / 1.5)


def inferred_rollers(
    bearing: CatalogueBearing, *, most: int = MAX_CANDIDATES
) -> tuple[RollerCandidate, ...]:
    """Return what could be inside a roller bearing, the best first.

    Parameters
    ----------
    bearing
        With its dynamic or static rating; what is published of its rollers is kept.
    most
        Maximum number of candidates.

    Raises
    ------
    InputError
        If the bearing has balls, no rating to infer from or, tapered, nothing that shows its
        contact angle.
    """
    if not bearing.has_rollers:
        raise InputError(
            said("has balls, not rollers"), field="designation", value=bearing.designation
        )
    if bearing.rated == (None, None) and bearing.effective_length is None:
        raise InputError(
            said(
                "has no load rating to estimate the rollers from: give roller_count,"
                " roller_diameter, effective_length and pitch_diameter"
            ),
            field="designation",
            value=bearing.designation,
        )
    angle = nominal_angle(bearing)
    if bearing.type.axial_limit_of_maker and angle <= 0.0:
        raise InputError(
            said(
                "has neither the limit e nor the factor Y that tell its contact angle: give"
                " contact_angle beside it in its catalogue, or with the rollers in the case"
            ),
            field="designation",
            value=bearing.designation,
            example='contact_angle = "14 deg"',
        )
    places = _places(bearing, angle)
    if not places.number.size:
        return ()
    best: dict[tuple[int, float], int] = {}  # of each count, and each standard diameter
    order = np.flatnonzero(places.chi <= places.chi.min() + _FARTHEST)
    for index in order[np.argsort(places.chi[order], kind="stable")].tolist():
        size = 0.0 if places.is_free else _rounded(places.diameter[index])
        best.setdefault((int(places.number[index]), size), index)
    chosen = list(best.values())[: max(1, most)]
    weights = np.exp(-0.5 * (places.chi[chosen] - places.chi[chosen[0]]))
    return tuple(
        _candidate(rank, bearing, places, index, float(weight / weights.sum()))
        for rank, (index, weight) in enumerate(zip(chosen, weights, strict=True), start=1)
    )


class _Places(NamedTuple):
    """Every Z, D_we and d_pw that is tried, with its length; squared misfits."""

    number: FloatArray
    diameter: FloatArray
    pitch: FloatArray
    length: FloatArray
    factor: FloatArray
    filling: FloatArray
    dynamic: FloatArray
    static: FloatArray
    chi: FloatArray
    is_free: bool


def _places(bearing: CatalogueBearing, angle: float) -> _Places:
    """Rate what fits into the section."""
    practice = toml_of("rating_practice")["rollers"]
    usual, tolerance = practice[bearing.kind], practice["tolerance"]
    diameter, pitch, unusual, is_free = _sections(bearing, usual, tolerance)
    counts = np.arange(4.0, 201.0)
    if bearing.roller_count is not None:
        counts = np.array([float(bearing.roller_count)])
    count, row = (a.ravel() for a in np.meshgrid(counts, np.arange(diameter.size), indexing="ij"))
    diameter, pitch, unusual = diameter[row], pitch[row], unusual[row]
    room = pi / np.arcsin(np.minimum(diameter / pitch, 1.0))
    filling = count / room
    keep = (filling > _FILLINGS[0]) & (filling <= _FILLINGS[1])
    if bearing.roller_count is not None:
        keep = count <= room
    count, diameter, pitch, unusual, filling = (
        a[keep] for a in (count, diameter, pitch, unusual, filling)
    )
    one = 1e-3
    listed, listed_static = bearing.rated
    kind = bearing.kind
    rows, axial = bearing.rows, bearing.type.washers
    static = roller_static_rating(count, diameter, one, pitch, angle, thrust=axial, rows=rows)
    dynamic = roller_dynamic_rating(
        count, diameter, one, pitch, angle, kind=kind, thrust=axial, rows=rows
    )
    chi, factors = unusual, practice["practice"].get(bearing.maker, practice["practice"]["iso"])
    low, high = practice["filling_without_cage"] if bearing.is_full_complement else usual["filling"]
    if bearing.roller_count is None:
        chi = chi + ((filling - 0.5 * (low + high)) / (0.5 * (high - low))) ** 2
    found = []
    for factor in factors["dynamic"]:
        length = _length(bearing, static, factor * dynamic, listed, listed_static)
        computed = factor * dynamic * (length / one) ** (7.0 / 9.0)
        computed_static = static * (length / one)
        error, error_static = (
            np.zeros(count.shape) if printed is None else np.log(own_rating / printed)
            for own_rating, printed in ((computed, listed), (computed_static, listed_static))
        )
        own = chi + (error / tolerance["dynamic"]) ** 2 + (error_static / tolerance["static"]) ** 2
        if bearing.width and bearing.effective_length is None:
            own = own + _beyond(length / _room_for(bearing, angle), usual["length"]) / (
                tolerance["length"] ** 2
            )
        own = np.where(np.isnan(own), np.inf, own)
        found.append((length, np.full(count.shape, factor), error, error_static, own))
    length, factor, error, error_static, chi = (
        np.concatenate(columns) for columns in zip(*found, strict=True)
    )
    times = len(found)
    good = np.isfinite(chi)
    counts, diameters, pitches, fillings = (
        np.tile(a, times)[good] for a in (count, diameter, pitch, filling)
    )
    return _Places(
        counts,
        diameters,
        pitches,
        length[good],
        factor[good],
        fillings,
        error[good],
        error_static[good],
        chi[good],
        is_free,
    )


def _sections(
    bearing: CatalogueBearing, usual: dict[str, Any], tolerance: dict[str, float]
) -> tuple[FloatArray, FloatArray, FloatArray, bool]:
    """Return D_we and d_pw that are tried, how unusual each is, and whether D_we is free."""
    inner, outer = bearing.inner_raceway_diameter, bearing.outer_raceway_diameter
    if bearing.roller_diameter is not None:
        diameter = np.array([bearing.roller_diameter])
    elif inner is not None and outer is not None and bearing.type.straight:
        diameter = np.array([0.5 * (outer - inner)])
    elif not bearing.type.straight:
        diameter = bearing.section_height * _FREE_SHARES
    else:
        sizes, (low, high) = roller_diameters(), _SHARES
        height = bearing.section_height
        diameter = sizes[(sizes > low * height) & (sizes < high * height)]
    is_free = not bearing.type.straight and bearing.roller_diameter is None
    known = bearing.pitch_diameter
    if known is not None:
        pitch = np.full(diameter.shape, known)
    elif inner is not None and bearing.type.straight:
        pitch = inner + diameter
    elif outer is not None and bearing.type.straight:
        pitch = outer - diameter
    else:
        mean = bearing.mean_diameter * np.array(_PITCHES)
        diameter, pitch = (a.ravel() for a in np.meshgrid(diameter, mean, indexing="ij"))
    unusual = ((pitch / bearing.mean_diameter - 1.0) / tolerance["pitch_diameter"]) ** 2
    if known is not None or (bearing.type.straight and (inner or outer)):
        unusual = np.zeros(diameter.shape)
    if bearing.roller_diameter is None and not (inner and outer):
        height = bearing.section_height
        if inner is not None and bearing.bore >= inner - _ROUNDING:  # without inner ring
            share, window = 2.0 * diameter / (bearing.outside_diameter - inner), usual["share_cup"]
        else:
            share, window = diameter / height, usual["share"]
        unusual = unusual + _beyond(share, window) / tolerance["share"] ** 2
    return diameter, pitch, unusual, is_free


def _room_for(bearing: CatalogueBearing, angle: float) -> float:
    """Return the length between the faces that a roller has to do with, in m."""
    if bearing.type.washers:
        return bearing.section_height
    width = bearing.outer_width or bearing.width
    assert width is not None
    return float(width / bearing.rows / np.cos(angle))


def _beyond(value: FloatArray, window: tuple[float, float]) -> FloatArray:
    """Square of the distance from a window."""
    low, high = window
    return (np.maximum(low - value, 0.0) + np.maximum(value - high, 0.0)) ** 2


def _length(
    bearing: CatalogueBearing,
    static: FloatArray,
    dynamic: FloatArray,
    listed: float | None,
    listed_static: float | None,
) -> FloatArray:
    """Return L_we in m by the static rating, else by the dynamic one; both are given of 1 mm."""
    if bearing.effective_length is not None:
        return np.full(static.shape, bearing.effective_length)
    if listed_static is not None:
        return 1e-3 * listed_static / static
    assert listed is not None
    return 1e-3 * (listed / dynamic) ** (9.0 / 7.0)


def _candidate(
    rank: int, bearing: CatalogueBearing, places: _Places, index: int, weight: float
) -> RollerCandidate:
    listed = bearing.rated
    tolerance = toml_of("rating_practice")["rollers"]["tolerance"]
    errors = (float(places.dynamic[index]), float(places.static[index]))
    scaled = [
        error / tolerance[name]
        for error, name, value in zip(errors, ("dynamic", "static"), listed, strict=True)
        if value is not None
    ]
    alike = (places.number == places.number[index]) & (places.chi <= places.chi[index] + 1.0)
    if not places.is_free:
        alike &= np.abs(places.diameter - places.diameter[index]) < _ROUNDING

    def span(values: FloatArray) -> tuple[float, float]:
        return _rounded(values[alike].min()), _rounded(values[alike].max())

    told = [
        None if value is None else exp(error) - 1.0
        for error, value in zip(errors, listed, strict=True)
    ]
    names = (
        "dynamic_rating", "static_rating", "inner_raceway_diameter", "outer_raceway_diameter",
        "axial_limit", "roller_count", "roller_diameter", "effective_length", "pitch_diameter",
    )  # fmt: skip
    return RollerCandidate(
        rank=rank,
        roller_count=round(float(places.number[index])),
        roller_diameter=_rounded(places.diameter[index]),
        effective_length=_rounded(places.length[index]),
        pitch_diameter=_rounded(places.pitch[index]),
        roller_diameter_range=span(places.diameter),
        effective_length_range=span(places.length),
        pitch_diameter_range=span(places.pitch),
        misfit=sqrt(float(places.chi[index]) / max(1, len(scaled))),
        weight=weight,
        dynamic_error=told[0],
        static_error=told[1],
        rating_factor=float(places.factor[index]),
        filling=float(places.filling[index]),
        reproduces=all(abs(error) <= _CREDIBLE for error in scaled),
        rests_on=tuple(name for name in names if getattr(bearing, name) is not None),
    )


def _rounded(length: Any) -> float:
    return round(float(length), _TENTH_OF_MICROMETRE)
