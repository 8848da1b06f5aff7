"""Ratings of solved rows, their loads in the standards' sense, and what the standards leave out."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.life.conditions import LifeConditions
from rolamento.life.equivalent_load import (
    STEEPEST,
    equivalent_load,
    static_equivalent_load,
    static_safety,
)
from rolamento.life.modified import fatigue_load_limit, fatigue_load_limit_of_contacts
from rolamento.life.solved_balls import SolvedRows
from rolamento.lubrication.oil_state import viscosity_ratio
from rolamento.numerics import BoolArray, FloatArray
from rolamento.ratings import (
    dynamic_factor,
    dynamic_factor_of_grooves,
    dynamic_rating,
    static_rating,
)

_ROW_SHARE: Final = 0.7
"""C of i equal rows is i^0.7 times that of one."""
_SAME: Final = 1e-9
_MOMENT: Final = 0.01
"""Moment over load times pitch diameter above which it is worth a note."""
_FORCE: Final = 1e-9
"""Force over the sum of the ball loads below which it is what rounding left."""
_OTHERWISE: Final = 2.0
"""Ratio of rating life and reference life from which the balls share the load otherwise.

With normal clearances of 6012, 6205 and 6305 it lies between 0.5 and 2 under loads of C/10 and
more, axial or radial: so far X, Y and e of the table go.
"""
_LEAST_LOAD: Final = 0.01
"""P/C below which balls may slide. SKF, Rolling bearings (catalogue 10000 EN), minimum load."""
_CENTRIFUGAL: Final = 1.05
"""Mean outer over mean inner ball load, likewise."""
_INNER_GROOVE, _OUTER_GROOVE, _GROOVE_MARGIN = 0.52, 0.53, 1e-3
_HOTTEST_STEEL: Final = 120.0 + 273.15
"""K; for rings that are not specially stabilised. Saurer Ball Bearings (ska.swiss) and SMB Bearings
(smbbearings.com) say 120 °C for standard steel, SKF 120 to 200 °C by the heat treatment."""


@dataclass(frozen=True, slots=True, eq=False)
class Ratings:
    """C, C_0 and C_u of each row (cases or 1, rows), and of all of them (cases or 1,); N."""

    dynamic: FloatArray
    static: FloatArray
    fatigue: FloatArray
    dynamic_of_set: FloatArray
    static_of_set: FloatArray
    fatigue_of_set: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class EquivalentLoads:
    """P, P_0, X, Y, e and the static safety; arrays (cases,), N; NaN where there is no P."""

    dynamic: FloatArray
    static: FloatArray
    safety: FloatArray
    radial_factor: FloatArray
    axial_factor: FloatArray
    limit: FloatArray


def ratings_of(balls: SolvedRows, given: LifeConditions) -> Ratings:
    """Ratings as given, or from the geometry.

    Raises
    ------
    InputError
        If the geometry is outside the standard's table, and no rating is given.
    """
    shape = (balls.ball_count, balls.ball_diameter, balls.pitch_diameter, balls.contact_angle)
    lowered = dynamic_rating(*shape, factor=_groove_factor(balls))
    dynamic = _given(given.dynamic_rating, lowered, balls)
    if given.static_rating is None and not balls.steel_balls:
        static = np.full_like(balls.ball_diameter, np.nan)
    else:
        static = _given(given.static_rating, static_rating(*shape), balls)
    if np.all(np.isnan(dynamic)):
        raise InputError(
            "is missing: the geometry lies outside the standard's table (D cos α/d_m from 0.01 to"
            " 0.40)",
            field="dynamic_rating",
            example="dynamic_rating = 20600.0",
        )
    fatigue = _fatigue(balls, static, given)
    count = balls.ball_count.size
    return Ratings(
        dynamic,
        static,
        fatigue,
        dynamic.sum(axis=1) * count ** (_ROW_SHARE - 1.0),
        static.sum(axis=1),
        fatigue.sum(axis=1),
    )


def equivalent_loads(balls: SolvedRows, ratings: Ratings) -> EquivalentLoads:
    """P and P_0 of the shaft's load, for one row, a tandem, or a pair that faces each other."""
    cases = len(balls)
    fx, fy, fz = balls.ring_load[:, 0], balls.ring_load[:, 1], balls.ring_load[:, 2]
    radial, axial = np.hypot(fy, fz), np.abs(fx)
    signs = balls.signs
    facing = len(signs) == 2 and signs[0] != signs[1]
    angle = balls.contact_angle[:, 0]
    if not _equal_rows(balls) or (len(set(signs)) > 1 and not facing):
        nothing = np.full(cases, np.nan)
        return EquivalentLoads(*([nothing] * 6))
    carrying = np.where(facing & (angle > 0.0), 1.0, float(len(signs)))
    relative = axial / (carrying * balls.ball_count[0] * balls.ball_diameter[:, 0] ** 2)
    found = equivalent_load(radial, axial, angle, relative, double_row=facing)
    static = static_equivalent_load(radial, axial, angle, double_row=facing)
    safety = static_safety(ratings.static_of_set, static)
    whole = (np.broadcast_to(a, cases).copy() for a in (found.load, static, safety))
    factors = (found.radial_factor, found.axial_factor, found.limit)
    unsolved = np.where(np.isnan(radial), np.nan, 0.0)
    return EquivalentLoads(*whole, *(np.broadcast_to(a, cases) + unsolved for a in factors))


def without_thrust_bearings(balls: SolvedRows) -> tuple[SolvedRows, BoolArray]:
    """Take the angle from cases with one beyond 45°, and tell which they are, (cases,).

    Raises
    ------
    InputError
        If all are such.
    """
    steep = balls.contact_angle > STEEPEST * (1.0 + _SAME)
    if np.all(steep.any(axis=1)):
        raise InputError(
            "is a thrust bearing's: the theories of life here are for radial bearings, up to 45°",
            field="bearing.contact_angle",
            value=f"{float(np.degrees(balls.contact_angle.max())):.4g} deg",
            example='contact_angle = "25 deg"',
        )
    whole = np.broadcast_to(steep.any(axis=1), len(balls))
    return replace(balls, contact_angle=np.where(steep, np.nan, balls.contact_angle)), whole


def viscosity_ratio_of(balls: SolvedRows, given: LifeConditions) -> FloatArray | None:
    """κ of each case, (cases,), of the row that needs the thickest oil; None if not known."""
    if given.viscosity_ratio is not None:
        return over_cases(given.viscosity_ratio, "viscosity_ratio", len(balls))
    if given.viscosity is None:
        return None
    viscosity = over_cases(given.viscosity, "viscosity", len(balls))
    ratio = viscosity_ratio(
        viscosity[:, np.newaxis], balls.speed[:, np.newaxis], balls.pitch_diameter
    )
    return np.asarray(ratio.min(axis=1))


def left_out_of_load(balls: SolvedRows, loads: EquivalentLoads) -> dict[str, BoolArray]:
    """What the equivalent load does not know, by note."""
    force = np.linalg.norm(balls.ring_load[:, :3], axis=1)
    moment = np.linalg.norm(balls.ring_load[:, 3:], axis=1)
    arm = balls.pitch_diameter.max(axis=1)
    with np.errstate(invalid="ignore"):
        outer, inner = balls.outer_load.sum(axis=1), balls.inner_load.sum(axis=1)
        none = (force <= _FORCE * inner) & ~balls.unloaded
        governs = 2.0 * moment > force * arm
        return {
            "no_equivalent_load": np.isnan(loads.dynamic) & ~np.isnan(force),
            "no_force": none,
            "moment_governs": np.asarray(governs & ~none),
            "moment_left_out": np.asarray((moment > _MOMENT * force * arm) & ~governs),
            "preload_left_out": np.full(len(balls), balls.preloaded),
            "centrifugal_left_out": np.asarray(outer > _CENTRIFUGAL * inner),
        }


def left_out_of_sharing(
    balls: SolvedRows, rating_life: FloatArray, reference_life: FloatArray
) -> dict[str, BoolArray]:
    """Whether the balls of a bearing given by its clearance share the load otherwise, by note."""
    by_clearance = np.all(balls.contact_angle == 0.0, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = rating_life / reference_life
        otherwise = (ratio > _OTHERWISE) | (ratio < 1.0 / _OTHERWISE)
    return {
        "load_shared_otherwise": np.asarray(otherwise & np.isfinite(rating_life) & by_clearance)
    }


def light_load(equivalent_load: FloatArray, dynamic_rating: FloatArray) -> BoolArray:
    """Whether a load is below the least under which balls roll; arrays, N."""
    return np.asarray(equivalent_load < _LEAST_LOAD * dynamic_rating)


def notes_on_bearing(balls: SolvedRows, given: LifeConditions) -> dict[str, BoolArray]:
    """What every theory that starts from the rating has to say of the bearing, by note."""
    cases = len(balls)
    inner, outer = balls.inner_conformity, balls.outer_conformity
    opened = (inner > _INNER_GROOVE + _GROOVE_MARGIN) | (outer > _OUTER_GROOVE + _GROOVE_MARGIN)
    closed = (inner < _INNER_GROOVE - _GROOVE_MARGIN) | (outer < _INNER_GROOVE - _GROOVE_MARGIN)
    hot = np.zeros(cases, dtype=np.bool_)
    for name in ("temperature", "bearing_temperature"):
        warm = getattr(given, name)
        if warm is not None:
            hot = hot | (over_cases(warm, name, cases) > _HOTTEST_STEEL)
    return {
        "open_grooves": np.broadcast_to(opened.any(axis=1), cases),
        "close_grooves": np.broadcast_to(closed.any(axis=1), cases),
        "ceramic_balls": np.full(cases, not balls.steel_balls),
        "too_hot_for_steel": hot,
        "at_rest": np.asarray(balls.speed == 0.0),
    }


def turning_rings(balls: SolvedRows, given: LifeConditions) -> tuple[BoolArray, BoolArray]:
    """Whether the rings turn against the load, (cases,): as given, or by their speeds."""
    inner = np.asarray(balls.inner_speed != 0.0)
    outer = np.asarray(balls.outer_speed != 0.0)
    inner = inner | ~outer
    if given.inner_turning is not None:
        inner = np.full(len(balls), given.inner_turning)
    if given.outer_turning is not None:
        outer = np.full(len(balls), given.outer_turning)
    return inner, outer


def over_cases(value: ArrayLike, name: str, cases: int) -> FloatArray:
    """One number for each case, (cases,).

    Raises
    ------
    InputError
        If it is neither one number nor as many as there are cases.
    """
    array = np.asarray(value, dtype=np.float64)
    if array.shape not in ((), (cases,)):
        raise InputError(f"must be one number, or one for each of the {cases} cases", field=name)
    return np.broadcast_to(array, (cases,)).copy()


def _groove_factor(balls: SolvedRows) -> FloatArray:
    """f_c of the table, lowered for grooves that are more open than it takes, never raised."""
    gamma = balls.ball_diameter * np.cos(balls.contact_angle) / balls.pitch_diameter
    inner = np.maximum(balls.inner_conformity, _INNER_GROOVE)
    outer = np.maximum(balls.outer_conformity, _OUTER_GROOVE)
    full = dynamic_factor_of_grooves(gamma, _INNER_GROOVE, _OUTER_GROOVE)
    return np.asarray(dynamic_factor(gamma) * dynamic_factor_of_grooves(gamma, inner, outer) / full)


def _given(value: ArrayLike | None, computed: FloatArray, balls: SolvedRows) -> FloatArray:
    """A rating of each row, (cases or 1, rows)."""
    if value is None:
        return np.atleast_2d(computed)
    array = np.asarray(value, dtype=np.float64)
    column = array.reshape(-1, 1) if array.ndim == 1 else array
    if column.ndim > 2 or (column.ndim == 2 and len(column) not in (1, len(balls))):
        raise InputError("must be one number, or one for each case", field="rating")
    return np.atleast_2d(column * np.ones(balls.ball_count.size))


def _fatigue(balls: SolvedRows, static: FloatArray, given: LifeConditions) -> FloatArray:
    wanted = given.fatigue_load_limit
    if isinstance(wanted, str):
        if wanted == "estimate":
            usable = np.where(np.isnan(static), 1.0, static)
            found = fatigue_load_limit(usable, balls.pitch_diameter)
            return np.where(np.isnan(static) | (not balls.steel_balls), np.nan, found)
        return np.atleast_2d(
            fatigue_load_limit_of_contacts(
                balls.ball_count,
                balls.ball_diameter,
                balls.pitch_diameter,
                balls.inner_conformity,
                balls.outer_conformity,
                balls.contact_angle,
                balls.modulus,
            )
        )
    return _given(wanted, static, balls)


def _equal_rows(balls: SolvedRows) -> bool:
    names = ("ball_diameter", "pitch_diameter", "contact_angle")
    arrays = [getattr(balls, name) for name in names]
    return bool(
        np.all(balls.ball_count == balls.ball_count[0])
        and all(np.allclose(a, a[:, :1], rtol=_SAME, atol=_SAME, equal_nan=True) for a in arrays)
    )
