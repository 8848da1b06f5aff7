"""What the theories share: ratings of solved rows, their loads in the standards' sense, notes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Bearing
from rolamento.case.bearing import ball_bearing
from rolamento.errors import InputError
from rolamento.life.conditions import LifeConditions
from rolamento.life.contamination import (
    ContaminationClass,
    ContaminationLevel,
    contamination_factor,
)
from rolamento.life.equivalent_load import (
    MAXIMUM_ANGLE,
    equivalent_load,
    minimum_axial_load,
    static_equivalent_load,
    static_safety,
)
from rolamento.life.iso281 import basic_rating_life, hours, load_notes
from rolamento.life.iso281_modified import (
    fatigue_load_limit,
    fatigue_load_limit_of_contacts,
)
from rolamento.life.iso16281 import ReferenceLife, race_ratings, reference_life
from rolamento.life.record import BOUNDS, OUTSIDE, Life
from rolamento.life.reliability import outside_print, reliability_factor
from rolamento.lubrication.oil_state import viscosity_ratio
from rolamento.numerics import BoolArray, FloatArray
from rolamento.ratings import (
    SELF_ALIGNING_CONFORMITY,
    RatedType,
    dynamic_factor,
    dynamic_factor_of_grooves,
    dynamic_rating,
    static_rating,
    thrust_dynamic_factor,
)
from rolamento.solved import Rows, Solved
from rolamento.words import said

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
_MINIMUM_LOAD: Final = 0.01
"""P/C below which balls may slide. SKF, Rolling bearings (catalogue 10000 EN), minimum load."""
_CENTRIFUGAL: Final = 1.05
"""Mean outer over mean inner ball load, likewise."""
_INNER_GROOVE, _OUTER_GROOVE, _GROOVE_MARGIN = 0.52, 0.53, 1e-3
_GROOVES: Final[dict[RatedType, tuple[float, float]]] = {
    "radial": (_INNER_GROOVE, _OUTER_GROOVE),
    "self_aligning": (SELF_ALIGNING_CONFORMITY, np.inf),
    "thrust": (0.54, 0.54),
}
"""Conformities up to which the standards' factors hold; ISO 281:2007, 5.1 and 5.2."""
_MAXIMUM_OF_STEEL: Final = 120.0 + 273.15
"""K; for rings that are not specially stabilised. Saurer Ball Bearings (ska.swiss) and SMB Bearings
(smbbearings.com) say 120 °C for standard steel, SKF 120 to 200 °C by the heat treatment."""


@dataclass(frozen=True, slots=True, eq=False)
class Ratings:
    """C, C_0 and C_u of each row (cases, rows), and of all of them (cases,); N.

    kind: what the bearing is rated as; of thrust bearings the ratings are axial.
    """

    dynamic: FloatArray
    static: FloatArray
    fatigue: FloatArray
    dynamic_of_set: FloatArray
    static_of_set: FloatArray
    fatigue_of_set: FloatArray
    kind: RatedType = "radial"

    @property
    def is_axial(self) -> bool:
        """Whether these are ratings for axial load."""
        return self.kind == "thrust"

    @property
    def fatigue_in_factor(self) -> FloatArray:
        """C_u as it stands in a_ISO: of thrust bearings a third. ISO 281:2007, 9.3.3; (cases,)."""
        return self.fatigue_of_set / 3.0 if self.is_axial else self.fatigue_of_set


@dataclass(frozen=True, slots=True, eq=False)
class EquivalentLoads:
    """P, P_0, X, Y, e and the static safety; arrays (cases,), N; NaN where there is no P."""

    dynamic: FloatArray
    static: FloatArray
    safety: FloatArray
    radial_factor: FloatArray
    axial_factor: FloatArray
    limit: FloatArray


Notes = dict[str, BoolArray]


@dataclass(frozen=True, slots=True, eq=False)
class Basis:
    """Solved cases, conditions, and what follows from them for every theory.

    contact_angle is the nominal one of the rows, (cases, rows), of radial bearings NaN beyond 45°;
    speed that of the rings against each other, unsigned, (cases,), rad/s; unloaded: where no
    element carries load.
    """

    solved: Solved
    contact_angle: FloatArray
    given: LifeConditions
    ratings: Ratings
    loads: EquivalentLoads
    turning: tuple[BoolArray, BoolArray]
    reference: ReferenceLife
    reliability_factor: FloatArray
    speed: FloatArray
    unloaded: BoolArray
    viscosity_ratio: FloatArray | None
    common_notes: Notes

    @classmethod
    def of(cls, solved: Solved, given: LifeConditions) -> Basis:
        """Gather what the theories share; InputError as `summary.life`."""
        rows, kind = solved.rows, rated_as(ball_bearing(solved.case))
        angle = nominal_contact_angle(solved)
        if kind != "thrust":
            angle = _within_rating(angle)
        steep = np.isnan(angle).any(axis=1)
        ratings = _ratings(solved, angle, given, kind)
        inner_turning, outer_turning = turning = _turning_rings(solved, given)
        reference = reference_life(
            solved.inner.load,
            solved.outer.load,
            race_ratings(
                ratings.dynamic,
                rows.element_count,
                rows.ball_diameter,
                rows.pitch_diameter,
                rows.inner_conformity,
                rows.outer_conformity,
                angle,
                kind,
            ),
            tuple(rows.starts.tolist()),
            inner_turning=inner_turning,
            outer_turning=outer_turning,
        )
        speed = _speed(solved)
        outside = bool(outside_print(given.reliability, given.edition))
        return cls(
            solved=solved,
            contact_angle=angle,
            given=given,
            ratings=ratings,
            loads=_equivalent_loads(solved, angle, ratings),
            turning=turning,
            reference=reference,
            reliability_factor=reliability_factor(given.reliability, given.edition),
            speed=speed,
            unloaded=np.all(solved.inner.load == 0.0, axis=1),
            viscosity_ratio=_viscosity_ratio(rows, speed, given),
            common_notes={
                **_notes_on_bearing(solved, given),
                "hours_at_rest": np.asarray(speed == 0.0),
                "thrust_bearing": np.asarray(steep),
                "no_dynamic_rating": np.isnan(ratings.dynamic_of_set) & ~steep,
                "reliability_continued": np.full(len(solved), outside),
            },
        )

    def __len__(self) -> int:
        """Count the cases."""
        return len(self.solved)

    def over_cases(self, name: str) -> FloatArray:
        """One of the conditions, a number for each case; NaN where it is not given."""
        value = getattr(self.given, name)
        return over_cases(np.nan if value is None else value, name, len(self))

    @property
    def basic_life(self) -> FloatArray:
        """L_10 by the equivalent load; millions of revolutions."""
        return basic_rating_life(self.ratings.dynamic_of_set, self.loads.dynamic)

    @property
    def reference_load(self) -> FloatArray:
        """P_ref = C/L_10r^(1/3): load of the rating life that the reference life stands for; N."""
        return np.asarray(self.ratings.dynamic_of_set / np.cbrt(self.reference.life))

    @property
    def contamination_factor(self) -> FloatArray | None:
        """e_C of each case; None where it or κ is not known."""
        return None if self.viscosity_ratio is None else self.cleanliness_at(self.viscosity_ratio)

    def cleanliness_at(self, viscosity_ratio: FloatArray) -> FloatArray | None:
        """e_C of each case if its viscosity ratio were another; None where it is not known."""
        given = self.given.contamination
        if given is None:
            return None
        if not isinstance(given, ContaminationClass | ContaminationLevel):
            return over_cases(given, "contamination", len(self))
        pitch = self.solved.rows.pitch_diameter.min(axis=1)
        return contamination_factor(given, viscosity_ratio, pitch)

    def notes_on_load(self) -> Notes:
        """What the theories of the equivalent load leave out or cannot judge."""
        solved, ratings, load = self.solved, self.ratings, self.loads.dynamic
        radial = np.hypot(solved.load.fy, solved.load.fz)
        force = np.linalg.norm(solved.load.array[:, :3], axis=1)
        if ratings.is_axial:
            # what a washer without a radial hold leaves is rounding
            return {**self._notes_on_axial_load(radial, force), **self._notes_on_ratings(load)}
        moment = np.linalg.norm(solved.load.array[:, 3:], axis=1)
        arm = solved.rows.pitch_diameter.max(axis=1)
        by_clearance = np.all(self.contact_angle == 0.0, axis=1)
        preloaded = solved.case.bearing.preload is not None
        with np.errstate(divide="ignore", invalid="ignore"):
            outer, inner = solved.outer.load.sum(axis=1), solved.inner.load.sum(axis=1)
            no_force = (force <= _FORCE * inner) & ~self.unloaded
            governs = 2.0 * moment > force * arm
            ratio = self.basic_life / self.reference.life
            otherwise = (ratio > _OTHERWISE) | (ratio < 1.0 / _OTHERWISE)
            return {
                **self._notes_on_ratings(load),
                "no_equivalent_load": np.isnan(load) & ~np.isnan(force),
                "no_force": no_force,
                "moment_governs": governs & ~no_force,
                "moment_left_out": (moment > _MOMENT * force * arm) & ~governs,
                "preload_left_out": np.full(len(self), preloaded),
                "centrifugal_left_out": outer > _CENTRIFUGAL * inner,
                "load_shared_otherwise": otherwise & np.isfinite(self.basic_life) & by_clearance,
            }

    def _notes_on_ratings(self, load: FloatArray) -> Notes:
        ratings = self.ratings
        return {
            **load_notes(load, ratings.dynamic_of_set, ratings.static_of_set),
            "light_load": load < _MINIMUM_LOAD * ratings.dynamic_of_set,
            "no_static_rating": np.isnan(ratings.static_of_set),
        }

    def _notes_on_axial_load(self, radial: FloatArray, force: FloatArray) -> Notes:
        """What the axial equivalent load of a thrust bearing leaves out or cannot judge."""
        solved, load = self.solved, self.loads.dynamic
        moment = np.linalg.norm(solved.load.array[:, 3:], axis=1)
        arm = solved.rows.pitch_diameter.max(axis=1)
        right = self.contact_angle[:, 0] >= np.pi / 2 * (1.0 - _SAME)
        least = minimum_axial_load(
            np.where(np.isnan(self.ratings.static_of_set), np.inf, self.ratings.static_of_set),
            self.speed,
            _limiting_speed(solved),
        )
        with np.errstate(divide="ignore", invalid="ignore"):
            outer, inner = solved.outer.load.sum(axis=1), solved.inner.load.sum(axis=1)
            no_force = (force <= _FORCE * inner) & ~self.unloaded
            governs = 2.0 * moment > force * arm
            return {
                "no_equivalent_load": np.isnan(load) & ~np.isnan(force) & ~self.unloaded,
                "no_force": no_force,
                "moment_governs": governs & ~no_force,
                "moment_left_out": (moment > _MOMENT * force * arm) & ~governs,
                "radial_load_left_out": right & (radial > _MOMENT * force),
                "centrifugal_left_out": outer > _CENTRIFUGAL * inner,
                "axial_load_too_small": (np.abs(solved.load.fx) < least) & np.isfinite(least),
            }

    def notes_on_reference_load(self) -> Notes:
        """Where the load of the reference life is too great or too small for it."""
        load, rating = self.reference_load, self.ratings.dynamic_of_set
        return {
            **load_notes(load, rating, self.ratings.static_of_set),
            "light_load": load < _MINIMUM_LOAD * rating,
        }

    def record(
        self, theory: str, basic: FloatArray, factors: dict[str, FloatArray], notes: Notes
    ) -> Life:
        """One theory's record; its factors, a_1 among them, multiply the basic life."""
        cases = len(self)
        whole = {name: np.broadcast_to(value, cases) for name, value in factors.items()}
        known = [value for name, value in whole.items() if name.startswith("a_")]
        unloaded = self.unloaded
        refused = unloaded | notes.get("no_force", np.zeros(cases, dtype=np.bool_))
        result = np.where(refused, np.nan, np.prod([basic, *known], axis=0))
        # what a number leaves out, or is a bound of, matters only where there is a number
        kept = {
            name: where if name in OUTSIDE - BOUNDS else where & ~refused
            for name, where in (self.common_notes | notes).items()
        }
        kept["unloaded"] = unloaded
        return Life(
            theory=theory,
            reliability=self.given.reliability,
            basic=basic,
            life=result,
            hours=hours(result, self.speed),
            factors=whole,
            notes={name: np.broadcast_to(where, cases) for name, where in kept.items()},
        )


def rated_as(bearing: Bearing) -> RatedType:
    """By which formula of the standards a bearing is rated."""
    return bearing.kind if bearing.kind in ("thrust", "self_aligning") else "radial"


def _rows_of_one_bearing(bearing: Bearing) -> int:
    """Rows that makers rate together: of a double-row, four-point or self-aligning bearing.

    1 for rows that are bearings of their own.
    """
    published = bearing.published
    one = bearing.kind is not None or (published is not None and published.kind == "double_row")
    return len(bearing.places) if one else 1


def _limiting_speed(solved: Solved) -> float | None:
    published = solved.case.bearing.published
    return None if published is None else published.limiting_speed


def _speed(solved: Solved) -> FloatArray:
    """Of the rings against each other, unsigned, (cases,), rad/s."""
    return np.abs(solved.field("duty.inner_speed") - solved.field("duty.outer_speed"))


def _has_steel_balls(solved: Solved) -> bool:
    """Whether the balls of all rows are as stiff as the rings, within a tenth."""
    return all(
        abs(
            p.bearing.element_material.youngs_modulus / p.bearing.ring_material.youngs_modulus - 1.0
        )
        <= 0.1
        for p in solved.case.bearing.places
    )


def nominal_contact_angle(solved: Solved) -> FloatArray:
    """Contact angle that standards rate the rows by, (cases, rows), rad: that before mounting.

    ISO 281:2007, 4; ISO/TS 16281:2008, 4. What fits, heat and speed make of it acts through the
    balls' loads.
    """
    delivered = solved.before_mounting
    return solved.rows.free_contact_angle if delivered is None else delivered.contact_angle


def _within_rating(angle: FloatArray) -> FloatArray:
    """Nominal contact angle of radial bearings, NaN beyond 45°, (cases, rows).

    Raises
    ------
    InputError
        If all cases have such a row.
    """
    steep = angle > MAXIMUM_ANGLE * (1.0 + _SAME)
    if steep.size and np.all(steep.any(axis=1)):
        raise InputError(
            said('is above 45°: such a bearing is rated for axial load; give it kind = "thrust"'),
            field="bearing.contact_angle",
            value=f"{float(np.degrees(angle.max())):.4g} deg",
            example='kind = "thrust"',
        )
    return np.where(steep, np.nan, angle)


def _ratings(solved: Solved, angle: FloatArray, given: LifeConditions, kind: RatedType) -> Ratings:
    """Ratings as given, or from the geometry.

    Raises
    ------
    InputError
        If the geometry is outside the standard's table, and no rating is given.
    """
    rows, steel = solved.rows, _has_steel_balls(solved)
    shape = (rows.element_count, rows.ball_diameter, rows.pitch_diameter, angle)
    lowered = dynamic_rating(*shape, kind=kind, factor=_groove_factor(rows, angle, kind))
    together = _rows_of_one_bearing(ball_bearing(solved.case))
    dynamic = _rating_or(given.dynamic_rating, lowered, together**_ROW_SHARE)
    if given.static_rating is None and not steel:
        static = np.full_like(rows.ball_diameter, np.nan)
    else:
        static = _rating_or(given.static_rating, static_rating(*shape, kind=kind), together)
    if dynamic.size and np.all(np.isnan(dynamic)):
        raise InputError(
            said(
                "is missing: the geometry is outside the table of the standard (D cos "
                "α/d_m from 0.01 to 0.40)"
            ),
            field="dynamic_rating",
            example="dynamic_rating = 20600.0",
        )
    method = given.fatigue_load_limit
    if not isinstance(method, str):
        fatigue = _rating_or(method, static, together)
    elif method == "contacts":
        fatigue = fatigue_load_limit_of_contacts(
            rows.element_count,
            rows.ball_diameter,
            rows.pitch_diameter,
            rows.inner_conformity,
            rows.outer_conformity,
            angle,
            rows.modulus,
            kind=kind,
        )
    else:
        known = np.where(np.isnan(static), 1.0, static)
        estimate = fatigue_load_limit(known, rows.pitch_diameter)
        fatigue = np.where(np.isnan(static) | (not steel), np.nan, estimate)
    return Ratings(
        dynamic,
        static,
        fatigue,
        dynamic.sum(axis=1) * len(rows) ** (_ROW_SHARE - 1.0),
        static.sum(axis=1),
        fatigue.sum(axis=1),
        kind,
    )


def _rating_or(value: ArrayLike | None, computed: FloatArray, together: float) -> FloatArray:
    """A rating of each row as it is given, or as computed; (cases, rows).

    together: how much greater what is given is, where it is that of several rows.
    """
    if value is None:
        return computed
    array = np.asarray(value, dtype=np.float64) / together
    column = array.reshape(-1, 1) if array.ndim == 1 else array
    if column.ndim > 2 or (column.ndim == 2 and len(column) not in (1, len(computed))):
        raise InputError(said("must be one number, or one for each case"), field="rating")
    return np.broadcast_to(column, computed.shape).copy()


def _equivalent_loads(solved: Solved, angles: FloatArray, ratings: Ratings) -> EquivalentLoads:
    """P and P_0 of the shaft's load, for one row, a tandem, or a pair that faces each other."""
    rows, load, cases, kind = solved.rows, solved.load, len(solved), ratings.kind
    radial, axial = np.hypot(load.fy, load.fz), np.abs(load.fx)
    facing = len(rows) == 2 and bool(rows.sign[0] != rows.sign[1])
    angle = angles[:, 0]
    if not _equal_rows(rows, angles) or (len(set(rows.sign.tolist())) > 1 and not facing):
        nothing = np.full(cases, np.nan)
        return EquivalentLoads(*([nothing] * 6))
    carrying = np.where(facing & (angle > 0.0), 1.0, float(len(rows)))
    relative = axial / (carrying * rows.element_count[0] * rows.ball_diameter[:, 0] ** 2)
    found = equivalent_load(radial, axial, angle, relative, double_row=facing, kind=kind)
    static = static_equivalent_load(radial, axial, angle, double_row=facing, kind=kind)
    safety = static_safety(ratings.static_of_set, static)
    factors = (found.radial_factor, found.axial_factor, found.limit)
    unsolved = np.where(np.isnan(radial), np.nan, 0.0)
    return EquivalentLoads(found.load, static, safety, *(a + unsolved for a in factors))


def _equal_rows(rows: Rows, angle: FloatArray) -> bool:
    return bool(
        np.all(rows.element_count == rows.element_count[0])
        and all(
            np.allclose(a, a[:, :1], rtol=_SAME, atol=_SAME, equal_nan=True)
            for a in (rows.ball_diameter, rows.pitch_diameter, angle)
        )
    )


def _viscosity_ratio(rows: Rows, speed: FloatArray, given: LifeConditions) -> FloatArray | None:
    """κ of each case, (cases,), of the row that needs the thickest oil; None if not known."""
    cases = len(speed)
    if given.viscosity_ratio is not None:
        return over_cases(given.viscosity_ratio, "viscosity_ratio", cases)
    if given.viscosity is None:
        return None
    viscosity = over_cases(given.viscosity, "viscosity", cases)
    ratio = viscosity_ratio(viscosity[:, np.newaxis], speed[:, np.newaxis], rows.pitch_diameter)
    return np.asarray(ratio.min(axis=1))


def _notes_on_bearing(solved: Solved, given: LifeConditions) -> Notes:
    """What every theory that starts from the rating has to say of the bearing, by note."""
    cases, rows = len(solved), solved.rows
    inner, outer = rows.inner_conformity, rows.outer_conformity
    kind = rated_as(ball_bearing(solved.case))
    most_inner, most_outer = _GROOVES[kind]
    opened = (inner > most_inner + _GROOVE_MARGIN) | (outer > most_outer + _GROOVE_MARGIN)
    closed = (inner < _INNER_GROOVE - _GROOVE_MARGIN) | (outer < _INNER_GROOVE - _GROOVE_MARGIN)
    hot = np.zeros(cases, dtype=np.bool_)
    for name in ("temperature", "bearing_temperature"):
        warm = getattr(given, name)
        if warm is not None:
            hot = hot | (over_cases(warm, name, cases) > _MAXIMUM_OF_STEEL)
    return {
        "open_grooves": np.asarray(opened.any(axis=1)),
        "close_grooves": np.asarray(closed.any(axis=1)),
        "ceramic_balls": np.full(cases, not _has_steel_balls(solved)),
        "too_hot_for_steel": hot,
    }


def _turning_rings(solved: Solved, given: LifeConditions) -> tuple[BoolArray, BoolArray]:
    """Whether the rings turn against the load, (cases,): as given, or by their speeds."""
    inner = solved.field("duty.inner_speed") != 0.0
    outer = solved.field("duty.outer_speed") != 0.0
    inner = inner | ~outer
    if given.inner_turning is not None:
        inner = np.full(len(solved), given.inner_turning)
    if given.outer_turning is not None:
        outer = np.full(len(solved), given.outer_turning)
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
        raise InputError(
            said("must be one number, or one for each of the {cases} cases", cases=cases),
            field=name,
        )
    return np.broadcast_to(array, (cases,)).copy()


def _groove_factor(rows: Rows, angle: FloatArray, kind: RatedType) -> FloatArray:
    """f_c of the table, lowered for grooves that are more open than it takes, never raised."""
    if kind == "thrust":
        ratio = rows.ball_diameter / rows.pitch_diameter
        usual = thrust_dynamic_factor(ratio, angle)
        openest = np.maximum(rows.inner_conformity, rows.outer_conformity)
        opened = openest > _GROOVES[kind][0]
        return np.where(opened, thrust_dynamic_factor(ratio, angle, openest), usual)
    gamma = rows.ball_diameter * np.cos(angle) / rows.pitch_diameter
    if kind == "self_aligning":
        own, least = rows.inner_conformity, SELF_ALIGNING_CONFORMITY
        lower = ((2.0 * own / (2.0 * own - 1.0)) / (2.0 * least / (2.0 * least - 1.0))) ** 0.41
        return np.asarray(dynamic_factor(gamma, kind) * np.minimum(lower, 1.0))
    inner = np.maximum(rows.inner_conformity, _INNER_GROOVE)
    outer = np.maximum(rows.outer_conformity, _OUTER_GROOVE)
    full = dynamic_factor_of_grooves(gamma, _INNER_GROOVE, _OUTER_GROOVE)
    return np.asarray(dynamic_factor(gamma) * dynamic_factor_of_grooves(gamma, inner, outer) / full)
