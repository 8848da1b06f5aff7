"""The hidden inside of a bearing, inferred from its ratings, and the sizes of standard balls.

Makers seldom publish the balls of a bearing, but its ratings follow from them by ISO 281 and
ISO 76. All standard balls, counts and pitch diameters that could be inside are rated, and those
that reproduce the printed C, C_0 and f_0 are ranked by their misfit. What comes out is a guess
with alternatives, and is marked as such.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from math import cos, exp, pi, sqrt
from typing import Any, Final, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from rolamento.catalogue.records import CatalogueBearing
from rolamento.errors import InputError
from rolamento.io.data import toml_of
from rolamento.numerics import FloatArray
from rolamento.ratings import (
    MAXIMUM_GAMMA,
    SELF_ALIGNING_CONFORMITY,
    THRUST_CONFORMITY,
    RatedType,
    dynamic_factor,
    dynamic_factor_of_grooves,
    dynamic_rating,
    static_factor,
    static_factor_of_grooves,
    static_rating,
    thrust_dynamic_factor,
)
from rolamento.records import frozen
from rolamento.words import said

_INCH: Final = 25.4e-3
_SAME: Final = 2e-3
"""Relative difference within which a printed ball size is a rounded standard one."""


def ball_sizes() -> FloatArray:
    """Return the diameters of the standard balls in m, rising."""
    return np.array(sorted({round(size, 9) for size, _ in _named_sizes()}))


def ball_name(diameter: float) -> str:
    """Return how a standard ball is called, ``"5/16 in"`` or ``"8 mm"``; else an empty text.

    Parameters
    ----------
    diameter
        In m.
    """
    size, name = min(_named_sizes(), key=lambda known: abs(known[0] - diameter))
    return name if abs(size - diameter) <= _SAME * diameter else ""


@lru_cache(maxsize=1)
def _named_sizes() -> tuple[tuple[float, str], ...]:
    data = toml_of("ball_sizes")
    inches = [
        Fraction(number, parts)
        for key, parts in (("inch_64ths", 64), ("inch_32nds", 32), ("inch_16ths", 16))
        for number in data[key]
    ]
    metric = [(1e-3 * size, f"{size:g} mm") for size in data["metric_mm"]]
    return (*((float(size) * _INCH, _inch_name(size)) for size in inches), *metric)


def _inch_name(size: Fraction) -> str:
    whole, rest = divmod(size, 1)
    return " ".join(str(part) for part in (whole, rest) if part) + " in"


MAX_CANDIDATES: Final = 12
_CREDIBLE: Final = 3.0
"""Tolerances within which a candidate reproduces a figure."""
_FARTHEST: Final = 25.0
"""A candidate is left out beyond this much more of squared misfit than the best."""
_COUNTS: Final = np.arange(4, 81)
_SHARES: Final = (0.30, 0.76)
_FILLINGS: Final = (0.35, 0.98)
_PITCHES: Final = np.linspace(0.964, 1.036, 37)
_FIRST_LOOK: Final = 0.25
"""Part by which C may be off at the mean diameter for a closer look."""
_GAMMAS: Final = np.linspace(0.005, MAXIMUM_GAMMA, 80)
_FROM_ZERO: Final = np.linspace(0.0, MAXIMUM_GAMMA, 81)


@frozen(kw_only=True)
class Candidate:
    """One inside that could have the printed ratings.

    Attributes
    ----------
    rank
        1 for the best.
    ball_count, ball_diameter, pitch_diameter
        Z, D and d_m, in m.
    pitch_diameter_range
        Minimum and maximum d_m that fits about as well, in m.
    inner_conformity, outer_conformity
        The most open grooves that the ratings allow; closer ones give the same C. The outer race
        of a self-aligning bearing is a sphere.
    misfit
        Root mean square of the differences over their tolerances: 1 is as good as the printed
        digits, 3 is doubtful.
    weight
        Share of this candidate in the likelihood of all.
    dynamic_error, static_error
        Relative difference of the computed from the printed C and C_0; None if not printed.
    f0_error
        Difference of f_0; None if not printed.
    filling
        Part of the pitch circle that the balls take.
    reproduces
        Whether every printed figure is within three tolerances.
    rests_on
        Names of the figures that it was inferred from.
    """

    rank: int
    ball_count: int
    ball_diameter: float
    pitch_diameter: float
    pitch_diameter_range: tuple[float, float]
    inner_conformity: float
    outer_conformity: float
    misfit: float
    weight: float
    dynamic_error: float | None
    static_error: float | None
    f0_error: float | None
    filling: float
    reproduces: bool
    rests_on: tuple[str, ...]


@frozen(kw_only=True)
class Practice:
    """How a maker's printed ratings stand to the standards'.

    Attributes
    ----------
    dynamic, static
        Printed rating over that of ISO 281 and ISO 76.
    dynamic_tolerance, static_tolerance, f0_tolerance
        Standard deviations: of the logarithm of the ratings, and of f_0 itself.
    source
        Where that is from.
    """

    dynamic: float = 1.0
    static: float = 1.0
    dynamic_tolerance: float = 0.006
    static_tolerance: float = 0.010
    f0_tolerance: float = 0.06
    source: str = ""


def practice_of(maker: str) -> Practice:
    """Return a maker's practice, that of the standards if it is not known to differ."""
    data = toml_of("rating_practice")
    return Practice(**data[maker if maker in data and maker.isupper() else "iso"])


def inferred_geometry(
    bearing: CatalogueBearing, *, practice: Practice | None = None, most: int = MAX_CANDIDATES
) -> tuple[Candidate, ...]:
    """Return what could be inside a bearing, the best first.

    Parameters
    ----------
    bearing
        With its dynamic or static rating; a ball count, ball diameter or pitch diameter that
        is published is kept.
    practice
        How the maker rates; by default as `practice_of` its name.
    most
        Maximum number of candidates.

    Raises
    ------
    InputError
        If the bearing has no rating to infer from.
    """
    if bearing.rated == (None, None):
        raise InputError(
            said(
                "has no load rating to estimate the balls from: give ball_count, "
                "ball_diameter and pitch_diameter"
            ),
            field="designation",
            value=bearing.designation,
        )
    rates = practice or practice_of(bearing.maker)
    grid = _grid(bearing, rates)
    parts = _misfits(bearing, rates, grid)
    chi = np.concatenate([part.chi for part in parts])
    if not chi.size:
        return ()
    chosen, ranges = _best_of_each(chi, grid)
    chosen = chosen[: max(1, most)]
    weights = np.exp(-0.5 * (chi[chosen] - chi[chosen[0]]))
    candidates = []
    for rank, (index, weight) in enumerate(zip(chosen.tolist(), weights, strict=True), start=1):
        groove, place = divmod(index, grid.balls.size)
        candidates.append(
            _candidate(
                rank,
                bearing,
                rates,
                [float(column[place]) for column in grid],
                *_conformities(bearing, groove, grid, place),
                [float(error[place]) for error in parts[groove].errors],
                float(chi[index]),
                float(weight / weights.sum()),
                ranges[index],
            )
        )
    return tuple(candidates)


class _Grid(NamedTuple):
    """Every Z, D and d_m to be rated, one an element; plausibility of each as squared misfit."""

    balls: FloatArray
    ball: FloatArray
    pitch: FloatArray
    filling: FloatArray


class _Groove(NamedTuple):
    inner: float
    outer: float
    penalty: float
    dynamic: FloatArray
    static: FloatArray


class _Factors(NamedTuple):
    """f_c and f_0 at every place of the grid, and how unusual the grooves behind them are."""

    penalty: float
    dynamic: FloatArray
    static: FloatArray


class _Misfits(NamedTuple):
    chi: FloatArray
    errors: tuple[FloatArray, ...]


def _grid(bearing: CatalogueBearing, rates: Practice) -> _Grid:
    """Return what fits into the section and is near the printed rating."""
    height, mean = bearing.section_height, bearing.mean_diameter
    sizes = ball_sizes()
    balls = sizes[(sizes > _SHARES[0] * height) & (sizes < _SHARES[1] * height)]
    if bearing.ball_diameter is not None:
        balls = np.array([bearing.ball_diameter])
    counts = _COUNTS if bearing.ball_count is None else np.array([bearing.ball_count])
    count, ball = (grid.ravel() for grid in np.meshgrid(counts, balls, indexing="ij"))
    filling = count * np.arcsin(np.minimum(ball / mean, 1.0)) / pi
    keep = (filling > _FILLINGS[0]) & (filling < _FILLINGS[1])
    keep &= _near(bearing, rates, count, ball)
    count, ball = count[keep].astype(np.float64), ball[keep]
    pitches = mean * _PITCHES
    if bearing.pitch_diameter is not None:
        pitches = np.array([bearing.pitch_diameter])
    count, pitch = (grid.ravel() for grid in np.meshgrid(count, pitches, indexing="ij"))
    ball = np.repeat(ball, pitches.size)
    filling = count * np.arcsin(np.minimum(ball / pitch, 1.0)) / pi
    return _Grid(count, ball, pitch, filling)


def _near(
    bearing: CatalogueBearing, rates: Practice, count: NDArray[np.int64], ball: FloatArray
) -> NDArray[np.bool_]:
    """Say what is worth a closer look: no groove lifts C, open ones take a third off."""
    listed = bearing.rated[0]
    if listed is None:
        return np.ones(count.shape, dtype=np.bool_)
    angle = bearing.contact_angle or 0.0
    rated = rates.dynamic * dynamic_rating(
        count, ball, bearing.mean_diameter, angle, kind=_rated_as(bearing), rows=bearing.rows
    )
    ratio = rated / listed
    return np.asarray((ratio > 1.0 - _FIRST_LOOK) & (ratio < 1.6 * (1.0 + _FIRST_LOOK)))


def _misfits(bearing: CatalogueBearing, rates: Practice, grid: _Grid) -> tuple[_Misfits, ...]:
    """Return how far each place of the grid is from the printed figures, groove by groove."""
    place = (grid.balls, grid.ball, grid.pitch, bearing.contact_angle or 0.0)
    tolerances = (rates.dynamic_tolerance, rates.static_tolerance, rates.f0_tolerance)
    listed, listed_static = bearing.rated
    rule: dict[str, Any] = {"kind": _rated_as(bearing), "rows": bearing.rows, "factor": 1.0}
    dynamic = _excess(listed, rates.dynamic * dynamic_rating(*place, **rule))
    static = _excess(listed_static, rates.static * static_rating(*place, **rule))
    implausible = _implausible(bearing, grid)
    found = []
    for factors in _factors(bearing, grid):
        errors = [np.zeros(grid.balls.shape)] * 3
        if dynamic is not None:
            errors[0] = dynamic + np.log(factors.dynamic)
        if static is not None:
            errors[1] = static + np.log(factors.static)
        if bearing.f0 is not None:
            errors[2] = factors.static - bearing.f0
        chi = implausible + factors.penalty
        for error, tolerance in zip(errors, tolerances, strict=True):
            chi = chi + (error / tolerance) ** 2
        found.append(_Misfits(np.where(np.isnan(chi), np.inf, chi), tuple(errors)))
    return tuple(found)


def _rated_as(bearing: CatalogueBearing) -> RatedType:
    return cast("RatedType", bearing.type.rated)


def _factors(bearing: CatalogueBearing, grid: _Grid) -> list[_Factors]:
    """Return the factors of every groove that a rating of this kind may suppose."""
    angle = bearing.contact_angle or 0.0
    ratio = grid.ball / grid.pitch
    gamma = ratio * np.cos(angle)
    if _rated_as(bearing) == "radial":
        at = _Interpolation.at(gamma)
        return [
            _Factors(groove.penalty, at(groove.dynamic), at(groove.static)) for groove in _grooves()
        ]
    kind = _rated_as(bearing)
    static = np.interp(np.maximum(gamma, 0.0), _FROM_ZERO, static_factor(_FROM_ZERO, kind))
    dynamic = (
        thrust_dynamic_factor(ratio, angle) if bearing.type.washers else dynamic_factor(gamma, kind)
    )
    return [_Factors(0.0, dynamic, static)]


def _conformities(
    bearing: CatalogueBearing, groove: int, grid: _Grid, place: int
) -> tuple[float, float]:
    """Return f_i and f_o that the rating of a candidate supposes."""
    if _rated_as(bearing) == "radial":
        return _grooves()[groove].inner, _grooves()[groove].outer
    if bearing.type.washers:
        return THRUST_CONFORMITY, THRUST_CONFORMITY
    gamma = grid.ball[place] * cos(bearing.contact_angle or 0.0) / grid.pitch[place]
    return SELF_ALIGNING_CONFORMITY, 0.5 * (1.0 + 1.0 / float(gamma))


def _excess(printed: float | None, rated: FloatArray) -> FloatArray | None:
    return None if printed is None else np.log(rated / printed)


class _Interpolation(NamedTuple):
    """Where numbers lie in `_GAMMAS`; NaN outside."""

    below: NDArray[np.intp]
    part: FloatArray

    @classmethod
    def at(cls, gamma: FloatArray) -> _Interpolation:
        place = (gamma - _GAMMAS[0]) / (_GAMMAS[1] - _GAMMAS[0])
        inside = (place >= 0.0) & (place <= _GAMMAS.size - 1)
        below = np.where(inside, np.minimum(place, _GAMMAS.size - 2), 0.0).astype(np.intp)
        return cls(below, np.where(inside, place - below, np.nan))

    def __call__(self, values: FloatArray) -> FloatArray:
        return np.asarray(values[self.below] + self.part * np.diff(values)[self.below])


def _implausible(bearing: CatalogueBearing, grid: _Grid) -> FloatArray:
    """Return how unusual a candidate is, as a squared misfit."""
    plausible = toml_of("rating_practice")["plausible"]
    windows, tolerance = plausible[bearing.kind], plausible["tolerance"]
    shift = grid.pitch / bearing.mean_diameter - 1.0
    outside = (shift / tolerance["pitch_diameter"]) ** 2
    share = grid.ball / bearing.section_height
    for name, value in (("filling", grid.filling), ("share", share)):
        low, high = windows[name]
        beyond = np.maximum(low - value, 0.0) + np.maximum(value - high, 0.0)
        outside = outside + (beyond / tolerance[name]) ** 2
    return np.asarray(outside)


def _best_of_each(
    chi: FloatArray, grid: _Grid
) -> tuple[NDArray[np.intp], dict[int, tuple[float, float]]]:
    """Return the best pitch and grooves of each Z and D, in order, and the pitches that do.

    The misfits are those of the whole grid with one groove after the other.
    """
    order = np.flatnonzero(chi <= chi.min() + _FARTHEST)
    order = order[np.argsort(chi[order], kind="stable")]
    place = order % grid.balls.size
    keys = grid.balls[place] + 1j * grid.ball[place]
    _, group, member = np.unique(keys, return_index=True, return_inverse=True)
    ranges = {}
    for number, first in enumerate(group.tolist()):
        index = int(order[first])
        own = order[member == number]
        well = own[chi[own] <= chi[index] + 1.0]
        pitches = grid.pitch[well % grid.balls.size]
        ranges[index] = (float(pitches.min()), float(pitches.max()))
    return order[np.sort(group)], ranges


def _candidate(
    rank: int,
    bearing: CatalogueBearing,
    rates: Practice,
    place: list[float],
    inner: float,
    outer: float,
    errors: list[float],
    chi: float,
    weight: float,
    pitch_range: tuple[float, float],
) -> Candidate:
    count, ball, pitch, filling = place
    printed = (*bearing.rated, bearing.f0)
    tolerances = (rates.dynamic_tolerance, rates.static_tolerance, rates.f0_tolerance)
    names = ("dynamic_rating", "static_rating", "f0")
    if bearing.dynamic_rating is None and bearing.axial_dynamic_rating is not None:
        names = ("axial_dynamic_rating", "axial_static_rating", "f0")
    given = [value is not None for value in printed]
    scaled = [
        error / tolerance
        for error, tolerance, known in zip(errors, tolerances, given, strict=True)
        if known
    ]
    told = [error if known else None for error, known in zip(errors, given, strict=True)]
    kept = [name for name in ("ball_count", "ball_diameter", "pitch_diameter")
            if getattr(bearing, name) is not None]  # fmt: skip
    return Candidate(
        rank=rank,
        ball_count=round(count),
        ball_diameter=ball,
        pitch_diameter=_rounded(pitch) if bearing.pitch_diameter is None else pitch,
        pitch_diameter_range=pitch_range,
        inner_conformity=inner,
        outer_conformity=outer,
        misfit=sqrt(chi / len(scaled)),
        weight=weight,
        dynamic_error=_relative(told[0]),
        static_error=_relative(told[1]),
        f0_error=told[2],
        filling=filling,
        reproduces=all(abs(error) <= _CREDIBLE for error in scaled),
        rests_on=tuple(name for name, known in zip(names, given, strict=True) if known)
        + tuple(kept),
    )


def _rounded(length: float) -> float:
    """Round what is known to a part in a hundred to a tenth of a micrometre."""
    return round(length, 7)


def _relative(logarithm: float | None) -> float | None:
    return None if logarithm is None else exp(logarithm) - 1.0


@lru_cache(maxsize=1)
def _grooves() -> tuple[_Groove, ...]:
    """Return the grooves that ratings may suppose, with their factors over `_GAMMAS`.

    The standards' tables hold for 0.52 and 0.53 and everything closer; in C0 closer grooves
    count (ISO 76 gives f0 by Hertz), in C they do not, and more open ones count in both.
    """
    ratio = dynamic_factor_of_grooves(_GAMMAS)
    found = []
    for groove in toml_of("rating_practice")["grooves"]:
        inner, outer = groove["inner"], groove["outer"]
        own = dynamic_factor_of_grooves(_GAMMAS, inner, outer)
        standard = dynamic_factor_of_grooves(_GAMMAS, max(inner, 0.52), max(inner, 0.52))
        open_part = np.minimum(np.where(inner > 0.52, own, standard) / ratio, 1.0)
        static = static_factor(_GAMMAS)
        if (inner, outer) != (0.52, 0.53):
            static = static_factor_of_grooves(_GAMMAS, inner, outer)
        found.append(
            _Groove(inner, outer, groove["penalty"], _dynamic_factor_extended() * open_part, static)
        )
    return tuple(found)


def _dynamic_factor_extended() -> FloatArray:
    """Return f_c of the table, below its first value by the closed form."""
    table = dynamic_factor(_GAMMAS)
    return np.where(np.isnan(table), dynamic_factor_of_grooves(_GAMMAS), table)
