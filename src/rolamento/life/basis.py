"""What the theories share: ratings of solved rows, their loads in the standards' sense, notes."""

from __future__ import annotations

from functools import cached_property, reduce
from typing import Final, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.errors import InputError
from rolamento.life.conditions import LifeConditions, conditions_of
from rolamento.life.contamination import (
    ContaminationClass,
    ContaminationLevel,
    contamination_factor,
)
from rolamento.life.equivalent_load import (
    ListedFactors,
    equivalent_load,
    minimum_axial_load,
    static_equivalent_load,
    static_safety,
)
from rolamento.life.iso281 import EXPONENT, ROLLER_EXPONENT, basic_rating_life, hours, load_notes
from rolamento.life.iso281_modified import bounded_modification_factor, life_modification_factor
from rolamento.life.iso16281 import (
    ROLLER_SLOPE,
    SLOPE,
    RaceRatings,
    ReferenceLife,
    equivalent_ball_load,
    race_life,
    race_ratings,
    reference_life,
    system_life,
)
from rolamento.life.lamina import EXPONENT as LAMINA_EXPONENT
from rolamento.life.lamina import lamina_life, roller_race_ratings
from rolamento.life.record import BOUNDS, OUTSIDE, Life
from rolamento.life.reliability import outside_print, reliability_factor
from rolamento.life.rib_load import RibLoad
from rolamento.life.row_ratings import (
    Ratings,
    UnratedError,
    has_steel_elements,
    nominal_conformities,
    nominal_contact_angle,
    ratings_of,
    row_kinds,
    within_rating,
)
from rolamento.numerics import BoolArray, FloatArray
from rolamento.ratings import INNER_GROOVE, rated_as
from rolamento.records import frozen
from rolamento.solved import Rows, Solved
from rolamento.words import said

_T = TypeVar("_T", bound=np.generic)
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
_OTHERWISE_OF_ROLLERS: Final = 3.0
"""The same for rollers, whose reference life has another exponent: at normal clearance of NU 205,
2205, 308, 220 and 2316 the reference life is 0.9 to 2.2 times the rating life from C/50 to C/3.
"""
_MINIMUM_LOAD: Final = 0.01
"""P/C below which balls may slide. SKF, Rolling bearings (catalogue 10000 EN), minimum load."""
_CENTRIFUGAL: Final = 1.05
"""Mean outer over mean inner ball load, likewise."""
_ROLLER_MINIMUM_LOAD: Final = 0.02
"""The same for rollers."""
_GROOVE_MARGIN: Final = 1e-3
_REFUSING: Final = OUTSIDE - BOUNDS
_MAXIMUM_OF_STEEL: Final = 120.0 + 273.15
"""K; for rings that are not specially stabilised. Saurer Ball Bearings (ska.swiss) and SMB Bearings
(smbbearings.com) say 120 °C for standard steel, SKF 120 to 200 °C by the heat treatment."""


@frozen(eq=False)
class EquivalentLoads:
    """P, P_0, X, Y, e and the static safety; arrays (cases,), N; NaN where there is no P.

    listed: whether Y, Y_0 and e are those that the maker lists.
    """

    dynamic: FloatArray
    static: FloatArray
    safety: FloatArray
    radial_factor: FloatArray
    axial_factor: FloatArray
    limit: FloatArray
    listed: bool = False


Notes = dict[str, BoolArray]


@frozen(eq=False, slots=False)
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
    rib_load: RibLoad | None
    common_notes: Notes

    @classmethod
    def of(cls, solved: Solved, given: LifeConditions) -> Basis:
        """Gather what the theories share; InputError as `summary.life`."""
        rows, kinds = solved.rows, row_kinds(solved)
        angle = within_rating(nominal_contact_angle(solved), kinds)
        steep = np.isnan(angle).any(axis=1)
        ratings = ratings_of(solved, angle, given)
        turning = _turning_rings(solved, given)
        speed = solved.relative_speed
        outside = bool(outside_print(given.reliability, given.edition))
        return cls(
            solved=solved,
            contact_angle=angle,
            given=given,
            ratings=ratings,
            loads=_equivalent_loads(solved, angle, ratings),
            turning=turning,
            reference=_reference(solved, angle, ratings, turning),
            reliability_factor=reliability_factor(given.reliability, given.edition),
            speed=speed,
            unloaded=np.all(solved.inner.load == 0.0, axis=1),
            viscosity_ratio=_viscosity_ratio(rows, speed, given),
            rib_load=RibLoad.of(solved, ratings.static[:, 0], speed),
            common_notes={
                **_notes_on_bearing(solved, given),
                "hours_at_rest": np.asarray(speed == 0.0),
                "thrust_bearing": np.asarray(steep),
                "no_dynamic_rating": np.asarray(np.isnan(ratings.dynamic).any(axis=1)) & ~steep,
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

    @cached_property
    def basic_life(self) -> FloatArray:
        """L_10 by the equivalent load; millions of revolutions."""
        exponent = ROLLER_EXPONENT if self.has_rollers else EXPONENT
        return basic_rating_life(self.ratings.dynamic_of_set, self.loads.dynamic, exponent)

    @cached_property
    def has_rollers(self) -> bool:
        """Whether there are rows of rollers."""
        return bool(np.any(self.ratings.rollers))

    @cached_property
    def reference_load(self) -> FloatArray:
        """P_ref = C/L_10r^(1/3): load of the rating life that the reference life stands for; N.

        Of roller bearings C/L_10r^(3/10); NaN of a set of balls and rollers.
        """
        if not self.has_rollers:
            return np.asarray(self.ratings.dynamic_of_set / np.cbrt(self.reference.life))
        with np.errstate(divide="ignore"):
            return np.asarray(
                self.ratings.dynamic_of_set * self.reference.life ** (-1.0 / ROLLER_EXPONENT)
            )

    @cached_property
    def row_reference_load(self) -> FloatArray:
        """P_ref of each row alone, (cases, rows); N."""
        with np.errstate(divide="ignore"):
            return np.asarray(
                self.ratings.dynamic * self.reference.row ** (-1.0 / self.ratings.exponents)
            )

    def modification_factor(
        self,
        viscosity_ratio: FloatArray,
        cleanliness: FloatArray,
        load: FloatArray | None = None,
        *,
        bounded: bool = True,
    ) -> FloatArray:
        """a_ISO with a κ and an e_C, (cases,).

        Of a set of balls and rollers, for which the standard has none, each row is modified by its
        own load and C_u, and the rows then live together: what that makes of the life.

        Parameters
        ----------
        viscosity_ratio, cleanliness
            κ and e_C, (cases,).
        load
            P, (cases,), N; by default that of the reference life.
        bounded
            Whether κ below 0.1 gives the bound 0.1, or NaN.
        """
        law = bounded_modification_factor if bounded else life_modification_factor
        additives, ratings = self.given.additives, self.ratings
        if load is not None or not ratings.mixed:
            limit = ratings.fatigue_in_factor
            rollers = self.has_rollers
            under = self.reference_load if load is None else load
            return law(
                viscosity_ratio, cleanliness, limit, under, additives=additives, rollers=rollers
            )
        loads, limits = self.row_reference_load, ratings.fatigue_of_rows_in_factor
        factors = np.stack(
            [
                law(
                    viscosity_ratio,
                    cleanliness,
                    limits[:, i],
                    loads[:, i],
                    additives=additives,
                    rollers=bool(rolling),
                )
                for i, rolling in enumerate(ratings.rollers)
            ],
            axis=1,
        )
        reference = self.reference
        races = np.concatenate([reference.inner * factors, reference.outer * factors], axis=1)
        with np.errstate(invalid="ignore"):
            return system_life(races, slope=reference.race_slopes) / reference.life

    @cached_property
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
            return {
                **self._notes_on_axial_load(radial, force),
                **self._notes_on_ratings(load),
                **self._notes_on_rollers(),
            }
        moment = np.linalg.norm(solved.load.array[:, 3:], axis=1)
        arm = solved.rows.pitch_diameter.max(axis=1)
        by_clearance = np.all(self.contact_angle == 0.0, axis=1)
        preloaded = solved.case.bearing.preload is not None
        with np.errstate(divide="ignore", invalid="ignore"):
            outer, inner = solved.outer.load.sum(axis=1), solved.inner.load.sum(axis=1)
            no_force = (force <= _FORCE * inner) & ~self.unloaded
            governs = 2.0 * moment > force * arm
            ratio = self.basic_life / self.reference.life
            limit = _OTHERWISE_OF_ROLLERS if self.has_rollers else _OTHERWISE
            otherwise = (ratio > limit) | (ratio < 1.0 / limit)
            return {
                **self._notes_on_ratings(load),
                **self._notes_on_rollers(),
                "no_equivalent_load": np.isnan(load) & ~np.isnan(force),
                "no_force": no_force,
                "moment_governs": governs & ~no_force,
                "moment_left_out": (moment > _MOMENT * force * arm) & ~governs,
                "preload_left_out": np.full(len(self), preloaded),
                "centrifugal_left_out": outer > _CENTRIFUGAL * inner,
                self._shared_otherwise: otherwise
                & np.isfinite(self.basic_life)
                & (by_clearance | (self.has_rollers & (ratio > 1.0))),
            }

    @property
    def _shared_otherwise(self) -> str:
        return "rollers_loaded_otherwise" if self.has_rollers else "load_shared_otherwise"

    def _notes_on_ratings(self, load: FloatArray) -> Notes:
        ratings = self.ratings
        return {
            **load_notes(load, ratings.dynamic_of_set, ratings.static_of_set),
            **self._light_load(load),
            "no_static_rating": np.asarray(np.isnan(ratings.static).any(axis=1)),
        }

    def _light_load(self, load: FloatArray) -> Notes:
        rating = self.ratings.dynamic_of_set
        if self.has_rollers:
            return {"light_load_of_rollers": load < _ROLLER_MINIMUM_LOAD * rating}
        return {"light_load": load < _MINIMUM_LOAD * rating}

    def _notes_on_rollers(self) -> Notes:
        """What the ribs of rollers have to say, whatever the theory."""
        if self.rib_load is None:
            return {}
        return {"axial_load_above_permissible": self.rib_load.exceeded}

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
                "axial_load_too_small": (np.abs(solved.load.fx) < least)
                & np.isfinite(least)
                & (not self.has_rollers),
            }

    def notes_on_reference_load(self) -> Notes:
        """Where the load of the reference life is too great or too small for it."""
        ratings, cases = self.ratings, len(self)
        notes = self._notes_on_rollers()
        if self.has_rollers:
            coupled = self.solved.case.model.roller_contact == "coupled"
            notes["edge_factor_left_out"] = np.full(cases, coupled)
        if ratings.mixed:
            by_row = load_notes(self.row_reference_load, ratings.dynamic, ratings.static)
            return {
                **notes,
                **{name: np.asarray(where.any(axis=1)) for name, where in by_row.items()},
            }
        load = self.reference_load
        return {
            **load_notes(load, ratings.dynamic_of_set, ratings.static_of_set),
            **self._light_load(load),
            **notes,
        }

    def record(
        self, theory: str, basic: FloatArray, factors: dict[str, FloatArray], notes: Notes
    ) -> Life:
        """One theory's record; its factors, a_1 among them, multiply the basic life."""
        cases = len(self)
        whole = {name: _repeated(value, cases) for name, value in factors.items()}
        known = (value for name, value in whole.items() if name.startswith("a_"))
        unloaded = self.unloaded
        refused = unloaded | notes["no_force"] if "no_force" in notes else unloaded
        result = np.where(refused, np.nan, reduce(np.multiply, known, basic))
        counts = ~refused
        # what a number leaves out, or is a bound of, matters only where there is a number
        kept = {
            name: where if name in _REFUSING else where & counts
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
            notes={name: _repeated(where, cases) for name, where in kept.items()},
            element=self.element,
        )

    @property
    def element(self) -> str:
        """What rolls, as the notes name it: "ball", "roller", or "element" of both."""
        if self.ratings.mixed:
            return "element"
        return "roller" if self.has_rollers else "ball"

    def refused(self, theory: str, note: str) -> Life:
        """Record of a theory that is not for such a bearing, by the note that says so."""
        nothing = np.full(len(self), np.nan)
        return self.record(theory, nothing, {"a_1": nothing}, {note: np.ones(len(self), np.bool_)})


def _reference(
    solved: Solved, angle: FloatArray, ratings: Ratings, turning: tuple[BoolArray, BoolArray]
) -> ReferenceLife:
    """Reference life: of rows of balls ball by ball, of rows of rollers slice by slice."""
    rows, rollers = solved.rows, solved.rollers
    if rollers is None:
        return reference_life(
            solved.inner.load,
            solved.outer.load,
            _ball_ratings(solved, angle, ratings, slice(None)),
            tuple(rows.starts.tolist()),
            inner_turning=turning[0],
            outer_turning=turning[1],
        )
    edges = solved.case.model.roller_contact != "coupled"
    lives: list[list[FloatArray]] = [[], []]
    loads: list[list[FloatArray]] = [[], []]
    for index, rolling in enumerate(ratings.rollers):
        own = np.flatnonzero(rows.row_of_element == index)
        make = _roller_ratings if rolling else _ball_ratings
        rated = make(solved, angle, ratings, index)
        for race, (rating, turns) in enumerate(
            zip((rated.inner, rated.outer), turning, strict=True)
        ):
            if rolling:
                line = (rollers.inner, rollers.outer)[race].load_per_length[:, own]
                width = rows.effective_length[:, index, np.newaxis, np.newaxis] / rollers.slices
                life = lamina_life(rating, line * width, turning=turns, edges=edges)
                with np.errstate(divide="ignore"):
                    load = rating * life ** (-1.0 / LAMINA_EXPONENT)
            else:
                ball = (solved.inner, solved.outer)[race].load[:, own]
                load = equivalent_ball_load(ball, turning=turns)
                life = race_life(rating, load)
            lives[race].append(life)
            loads[race].append(load)
    inner, outer, inner_load, outer_load = (np.stack(v, axis=1) for v in (*lives, *loads))
    slope = np.where(ratings.rollers, ROLLER_SLOPE, SLOPE)
    return ReferenceLife.of_races(inner, outer, inner_load, outer_load, slope)


def _ball_ratings(
    solved: Solved, angle: FloatArray, ratings: Ratings, own: int | slice
) -> RaceRatings:
    """Q_ci and Q_ce of a row of balls, (cases,), or of all rows, (cases, rows)."""
    rows = solved.rows
    kind = ratings.kinds[0 if isinstance(own, slice) else own]
    assert kind != "roller"
    assert kind != "roller_thrust"
    return race_ratings(
        ratings.dynamic[:, own],
        rows.element_count[own],
        rows.ball_diameter[:, own],
        rows.pitch_diameter[:, own],
        rows.inner_conformity[:, own],
        rows.outer_conformity[:, own],
        angle[:, own],
        kind,
    )


def _roller_ratings(solved: Solved, angle: FloatArray, ratings: Ratings, own: int) -> RaceRatings:
    """Q_ci and Q_ce of a row of rollers, (cases,)."""
    rows = solved.rows
    return roller_race_ratings(
        ratings.dynamic[:, own],
        rows.element_count[own],
        rows.ball_diameter[:, own],
        rows.pitch_diameter[:, own],
        angle[:, own],
        thrust=ratings.kinds[own] == "roller_thrust",
    )


def _is_wide(solved: Solved) -> bool:
    """Whether a bearing is of a wide series, by its designation: the second digit of NU 22."""
    resolved = solved.case.bearing.resolved
    series = None if resolved is None else getattr(resolved.designation, "series", None)
    return series in ("12", "20", "22", "23", "28", "29", "30", "39")


def _limiting_speed(solved: Solved) -> float | None:
    published = solved.case.bearing.published
    return None if published is None else published.limiting_speed


def _equivalent_loads(solved: Solved, angles: FloatArray, ratings: Ratings) -> EquivalentLoads:
    """P and P_0 of the shaft's load, for one row, a tandem, or a pair that faces each other."""
    rows, load, cases, kind = solved.rows, solved.load, len(solved), ratings.kind
    radial, axial = np.hypot(load.fy, load.fz), np.abs(load.fx)
    facing = len(rows) == 2 and bool(rows.sign[0] != rows.sign[1])
    angle = angles[:, 0]
    facing_otherwise = len(set(rows.sign.tolist())) > 1 and not facing
    if ratings.mixed or facing_otherwise or not _equal_rows(rows, angles):
        nothing = np.full(cases, np.nan)
        return EquivalentLoads(nothing, nothing, nothing, nothing, nothing, nothing)
    carrying = np.where(facing & (angle > 0.0), 1.0, float(len(rows)))
    relative = axial / (carrying * rows.element_count[0] * rows.ball_diameter[:, 0] ** 2)
    listed = listed_factors(solved, angles)
    found = equivalent_load(
        radial, axial, angle, relative, double_row=facing, kind=kind, wide=_is_wide(solved),
        listed=listed,
    )  # fmt: skip
    static = static_equivalent_load(
        radial, axial, angle, double_row=facing, kind=kind, listed=listed
    )
    safety = static_safety(ratings.static_of_set, static)
    factors = (found.radial_factor, found.axial_factor, found.limit)
    unsolved = np.where(np.isnan(radial), np.nan, 0.0)
    x, y, e = (factor + unsolved for factor in factors)
    return EquivalentLoads(found.load, static, safety, x, y, e, listed=listed is not None)


def listed_factors(solved: Solved, angles: FloatArray) -> ListedFactors | None:
    """e, Y and Y_0 as the maker of a tapered bearing lists them; None where they do not hold.

    angles: nominal, (cases, rows), rad. A contact angle of the user's own has its own factors.
    """
    found = set()
    for place in solved.delivered_case.bearing.places:
        row, published = place.bearing, place.bearing.published
        if (
            not row.bearing_type.axial_limit_of_maker
            or published is None
            or row.contact_angle is None
        ):
            return None
        if row.origins.get("contact_angle") == "given":
            return None
        if not np.allclose(angles, row.contact_angle, rtol=_SAME, atol=0.0, equal_nan=True):
            return None
        values = (
            published.axial_limit,
            published.axial_factor,
            published.static_axial_factor,
        )
        found.add(values)
    (first, *others) = found
    e, y, y_0 = first
    if others or e is None or y is None or y_0 is None:
        return None
    return ListedFactors(e, y, y_0)


def static_of_bearings(
    solved: Solved, known: tuple[Ratings, EquivalentLoads] | None = None
) -> tuple[FloatArray, FloatArray]:
    """C_0 and P_0 of each bearing of a set under its own load, (cases, bearings), N.

    Of a bearing whose rows are rated together, and of one row, those of the whole; NaN where the
    standards do not rate it. known: ratings and loads of the same cases, as of their `Basis`.
    """
    rows = solved.rows
    try:
        ratings, loads = known or _rated(solved)
    except UnratedError:
        nothing = np.full((len(solved), 1), np.nan)
        return nothing, nothing
    if solved.case.bearing.rows_of_one_bearing > 1 or len(rows) == 1:
        return ratings.static_of_set[:, np.newaxis], loads.static[:, np.newaxis]
    nominal = nominal_contact_angle(solved)
    angle, listed = within_rating(nominal, ratings.kinds), listed_factors(solved, nominal)
    axial, radial = np.abs(rows.load[:, :, 0]), np.hypot(rows.load[:, :, 1], rows.load[:, :, 2])
    static = [
        static_equivalent_load(
            radial[:, index], axial[:, index], angle[:, index], kind=kind, listed=listed
        )
        for index, kind in enumerate(ratings.kinds)
    ]
    return ratings.static, np.stack(static, axis=1)


def _rated(solved: Solved) -> tuple[Ratings, EquivalentLoads]:
    """Ratings by what the cases say, and the loads to compare them with."""
    angle = within_rating(nominal_contact_angle(solved), row_kinds(solved))
    ratings = ratings_of(solved, angle, conditions_of(solved))
    return ratings, _equivalent_loads(solved, angle, ratings)


def _equal_rows(rows: Rows, angle: FloatArray) -> bool:
    return len(rows) == 1 or bool(
        np.all(rows.element_count == rows.element_count[0])
        and all(
            np.allclose(a, a[:, :1], rtol=_SAME, atol=_SAME, equal_nan=True)
            for a in (rows.ball_diameter, rows.pitch_diameter, rows.effective_length, angle)
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
    from rolamento.oil.state import viscosity_ratio

    ratio = viscosity_ratio(viscosity[:, np.newaxis], speed[:, np.newaxis], rows.pitch_diameter)
    return np.asarray(ratio.min(axis=1))


def _notes_on_bearing(solved: Solved, given: LifeConditions) -> Notes:
    """What every theory that starts from the rating has to say of the bearing, by note."""
    cases = len(solved)
    inner, outer = nominal_conformities(solved)
    # rollers have no grooves: NaN, neither open nor close
    most = np.array([rated_as(kind)["conformities"] for kind in row_kinds(solved)])
    opened = (inner > most[:, 0] + _GROOVE_MARGIN) | (outer > most[:, 1] + _GROOVE_MARGIN)
    closed = (inner < INNER_GROOVE - _GROOVE_MARGIN) | (outer < INNER_GROOVE - _GROOVE_MARGIN)
    hot = np.zeros(cases, dtype=np.bool_)
    for name in ("temperature", "bearing_temperature"):
        warm = getattr(given, name)
        if warm is not None:
            hot = hot | (over_cases(warm, name, cases) > _MAXIMUM_OF_STEEL)
    return {
        "open_grooves": np.asarray(opened.any(axis=1)),
        "close_grooves": np.asarray(closed.any(axis=1)),
        "ceramic_balls": np.full(cases, not has_steel_elements(solved)),
        "too_hot_for_steel": hot,
        "duty_oscillates": np.full(cases, solved.case.duty.oscillation is not None),
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


def _repeated(values: NDArray[_T], cases: int) -> NDArray[_T]:
    """The same for each case, (cases,), where it is not that already."""
    return values if values.shape == (cases,) else np.broadcast_to(values, (cases,))


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
