"""Each theory's life of solved cases, in the common record."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from rolamento.errors import InputError
from rolamento.life import l_able as nsk
from rolamento.life.a23 import adjustment_notes
from rolamento.life.basic import basic_rating_life, hours, load_notes
from rolamento.life.conditions import LifeConditions
from rolamento.life.contamination import ContaminationClass, contamination_factor
from rolamento.life.duty_loads import (
    EquivalentLoads,
    Ratings,
    equivalent_loads,
    left_out_of_load,
    left_out_of_sharing,
    light_load,
    notes_on_bearing,
    over_cases,
    ratings_of,
    turning_rings,
    viscosity_ratio_of,
    without_thrust_bearings,
)
from rolamento.life.ioannides_harris import stress_volume_life
from rolamento.life.modified import (
    MOST_RATIO,
    bounded_modification_factor,
    life_modification_factor,
    modification_notes,
)
from rolamento.life.record import BOUNDS, OUTSIDE, Life
from rolamento.life.reference import RaceRatings, ReferenceLife, race_ratings, reference_life
from rolamento.life.reliability import outside_print, reliability_factor
from rolamento.life.solved_balls import SolvedRows
from rolamento.numerics import BoolArray, FloatArray

BASIC: Final = "iso281"
MODIFIED: Final = "iso281_modified"
ADJUSTED: Final = "iso281_1990"
REFERENCE: Final = "iso16281"
MODIFIED_REFERENCE: Final = "iso16281_modified"
STRESS_VOLUME: Final = "ioannides_harris"
L_ABLE: Final = "l_able"


Notes = dict[str, BoolArray]


@dataclass(frozen=True, slots=True, eq=False)
class Basis:
    """What the theories share."""

    balls: SolvedRows
    given: LifeConditions
    ratings: Ratings
    loads: EquivalentLoads
    turning: tuple[BoolArray, BoolArray]
    reference: ReferenceLife
    reliability_factor: FloatArray
    viscosity_ratio: FloatArray | None
    contamination_factor: FloatArray | None
    common: Notes

    def record(
        self, theory: str, basic: FloatArray, factors: dict[str, FloatArray], notes: Notes
    ) -> Life:
        """One theory's record; its factors, a_1 among them, multiply the basic life."""
        cases = len(self.balls)
        whole = {name: np.broadcast_to(value, cases) for name, value in factors.items()}
        known = [value for name, value in whole.items() if name in _MULTIPLIERS]
        unloaded = self.balls.unloaded
        refused = unloaded | notes.get("no_force", np.zeros(cases, dtype=np.bool_))
        result = np.where(refused, np.nan, np.prod([basic, *known], axis=0))
        # what a number leaves out, or is a bound of, matters only where there is a number
        kept = {
            name: where if name in OUTSIDE - BOUNDS else where & ~refused
            for name, where in (self.common | notes).items()
        }
        kept["unloaded"] = unloaded
        return Life(
            theory=theory,
            reliability=self.given.reliability,
            basic=basic,
            life=result,
            hours=hours(result, self.balls.speed),
            factors=whole,
            notes={name: np.broadcast_to(where, cases) for name, where in kept.items()},
        )


_MULTIPLIERS: Final = frozenset({"a_1", "a_iso", "a_2", "a_3", "a_nsk"})


def basis_of(balls: SolvedRows, given: LifeConditions) -> Basis:
    """Gather what the theories share; InputError as `summary.life`."""
    balls, steep = without_thrust_bearings(balls)
    ratings = ratings_of(balls, given)
    loads = equivalent_loads(balls, ratings)
    ratio = viscosity_ratio_of(balls, given)
    turning = turning_rings(balls, given)
    outside = bool(outside_print(given.reliability, given.edition))
    common = notes_on_bearing(balls, given)
    common["thrust_bearing"] = steep
    common["no_dynamic_rating"] = np.isnan(ratings.dynamic_of_set) & ~steep
    common["reliability_continued"] = np.full(len(balls), outside)
    return Basis(
        balls=balls,
        given=given,
        ratings=ratings,
        loads=loads,
        turning=turning,
        reference=_reference_of(balls, ratings, turning),
        reliability_factor=reliability_factor(given.reliability, given.edition),
        viscosity_ratio=ratio,
        contamination_factor=_contamination(balls, given, ratio),
        common=common,
    )


def _contamination(
    balls: SolvedRows, given: LifeConditions, ratio: FloatArray | None
) -> FloatArray | None:
    """e_C of each case; None where it or κ is not known."""
    if ratio is None or given.contamination is None:
        return None
    if not isinstance(given.contamination, ContaminationClass):
        return over_cases(given.contamination, "contamination", len(balls))
    return contamination_factor(given.contamination, ratio, balls.pitch_diameter.min(axis=1))


def cleanliness_at_best(basis: Basis) -> FloatArray | None:
    """e_C with the viscosity ratio as it is, or where that is not known with κ = 4; (cases,)."""
    kappa = basis.viscosity_ratio
    best = np.full(len(basis.balls), MOST_RATIO) if kappa is None else kappa
    return _contamination(basis.balls, basis.given, best)


def basic(basis: Basis) -> Life:
    """Basic rating life, ISO 281."""
    rating_life = basic_rating_life(basis.ratings.dynamic_of_set, basis.loads.dynamic)
    return basis.record(BASIC, rating_life, {"a_1": basis.reliability_factor}, _load_notes(basis))


def _load_notes(basis: Basis) -> Notes:
    ratings, load = basis.ratings, basis.loads.dynamic
    rating_life = basic_rating_life(ratings.dynamic_of_set, load)
    return {
        **load_notes(load, ratings.dynamic_of_set, ratings.static_of_set),
        **left_out_of_load(basis.balls, basis.loads),
        **left_out_of_sharing(basis.balls, rating_life, basis.reference.life),
        "light_load": light_load(load, ratings.dynamic_of_set),
        "no_static_rating": np.isnan(ratings.static_of_set),
    }


def modified(basis: Basis) -> Life:
    """Modified rating life, ISO 281; needs κ and e_C."""
    rating_life = basic_rating_life(basis.ratings.dynamic_of_set, basis.loads.dynamic)
    factors = _modification(basis, basis.loads.dynamic)
    notes = {**_load_notes(basis), **_modification_notes(basis)}
    return basis.record(MODIFIED, rating_life, factors, notes)


def adjusted(basis: Basis) -> Life:
    """Adjusted rating life, ISO 281:1990."""
    given = basis.given
    a2 = 1.0 if given.material_factor is None else given.material_factor
    a3 = 1.0 if given.operation_factor is None else given.operation_factor
    cases = len(basis.balls)
    a2, a3 = over_cases(a2, "material_factor", cases), over_cases(a3, "operation_factor", cases)
    nu = np.nan if given.viscosity is None else given.viscosity
    a1 = reliability_factor(given.reliability, "1990")
    rating_life = basic_rating_life(basis.ratings.dynamic_of_set, basis.loads.dynamic)
    diameter = basis.balls.pitch_diameter.max(axis=1)
    notes = {
        **_load_notes(basis),
        **adjustment_notes(a2, a3, nu, basis.balls.speed, diameter),
        "reliability_continued": np.asarray(outside_print(given.reliability, "1990")),
    }
    return basis.record(ADJUSTED, rating_life, {"a_1": a1, "a_2": a2, "a_3": a3}, notes)


def _reference_of(
    balls: SolvedRows, ratings: Ratings, turning: tuple[BoolArray, BoolArray]
) -> ReferenceLife:
    """Basic reference rating life, race by race, ISO/TS 16281."""
    inner, outer = turning
    return reference_life(
        balls.inner_load,
        balls.outer_load,
        _race_ratings(balls, ratings),
        balls.row_starts,
        inner_turning=inner,
        outer_turning=outer,
    )


def _race_ratings(balls: SolvedRows, ratings: Ratings) -> RaceRatings:
    return race_ratings(
        ratings.dynamic,
        balls.ball_count,
        balls.ball_diameter,
        balls.pitch_diameter,
        balls.inner_conformity,
        balls.outer_conformity,
        balls.contact_angle,
    )


def _reference_load(basis: Basis) -> FloatArray:
    """P_ref = C/L_10r^(1/3): the load of the rating life that the reference life stands for."""
    return np.asarray(basis.ratings.dynamic_of_set / np.cbrt(basis.reference.life))


def referenced(basis: Basis) -> Life:
    """Record the basic reference rating life."""
    load = _reference_load(basis)
    factors = {"a_1": basis.reliability_factor, "equivalent_load": load}
    return basis.record(REFERENCE, basis.reference.life, factors, _reference_notes(basis, load))


def _reference_notes(basis: Basis, load: FloatArray) -> Notes:
    rating = basis.ratings.dynamic_of_set
    return {
        **load_notes(load, rating, basis.ratings.static_of_set),
        "light_load": light_load(load, rating),
    }


def modified_reference(basis: Basis) -> Life:
    """Modified reference rating life, ISO/TS 16281; needs κ and e_C."""
    load = _reference_load(basis)
    factors = {**_modification(basis, load), "equivalent_load": load}
    notes = {**_reference_notes(basis, load), **_modification_notes(basis)}
    return basis.record(MODIFIED_REFERENCE, basis.reference.life, factors, notes)


def _modification(basis: Basis, load: FloatArray) -> dict[str, FloatArray]:
    ratio, clean = basis.viscosity_ratio, basis.contamination_factor
    assert ratio is not None
    assert clean is not None
    factor = bounded_modification_factor(
        ratio, clean, basis.ratings.fatigue_of_set, load, additives=basis.given.additives
    )
    return {
        "a_1": basis.reliability_factor,
        "a_iso": factor,
        "viscosity_ratio": ratio,
        "contamination_factor": clean,
    }


def _modification_notes(basis: Basis) -> Notes:
    assert basis.viscosity_ratio is not None
    assert basis.contamination_factor is not None
    notes = modification_notes(basis.viscosity_ratio, basis.contamination_factor)
    return {
        **notes,
        "no_fatigue_load_limit": np.isnan(basis.ratings.fatigue_of_set)
        & ~notes["viscosity_ratio_too_small"],
    }


def factor_now(basis: Basis) -> FloatArray | None:
    """a_ISO of the reference life as it is, or its bound; None where lubrication is not known."""
    if basis.contamination_factor is None:
        return None
    return _modification(basis, _reference_load(basis))["a_iso"]


def factor_if(
    basis: Basis,
    *,
    ratio: float | None = None,
    clean: float | None = None,
) -> FloatArray | None:
    """a_ISO if the oil were thicker or cleaner; NaN where the theory cannot judge it.

    None where lubrication is not known.
    """
    if basis.contamination_factor is None or basis.viscosity_ratio is None:
        return None
    kappa = basis.viscosity_ratio if ratio is None else np.full(len(basis.balls), ratio)
    dirt = _contamination(basis.balls, basis.given, kappa) if clean is None else np.asarray(clean)
    assert dirt is not None
    load = _reference_load(basis)
    factor = life_modification_factor(
        kappa, dirt, basis.ratings.fatigue_of_set, load, additives=basis.given.additives
    )
    return np.where(dirt > 0.0, factor, np.nan)


def stress_volume(basis: Basis) -> Life:
    """Life by Ioannides and Harris."""
    (inner, outer), reference = basis.turning, basis.reference
    found = stress_volume_life(
        reference,
        basis.balls.ellipses("inner"),
        basis.balls.ellipses("outer"),
        basis.balls.row_starts,
        fatigue_limit=over_cases(basis.given.fatigue_limit, "fatigue_limit", len(basis.balls)),
        inner_turning=inner,
        outer_turning=outer,
        depth=basis.given.depth,
    )
    notes = {
        "no_surface_stress": np.ones(len(basis.balls), dtype=np.bool_),
        "below_fatigue_limit": np.isinf(found.life) & np.isfinite(reference.life),
    }
    return basis.record(STRESS_VOLUME, found.life, {"a_1": basis.reliability_factor}, notes)


def l_able(basis: Basis) -> Life:
    """NSK's L_able.

    Raises
    ------
    InputError
        If κ is not known.
    """
    given, cases = basis.given, len(basis.balls)
    if basis.viscosity_ratio is None:
        raise InputError(
            "is missing: L_able needs the viscosity ratio, or the viscosity",
            field="viscosity_ratio",
            example="viscosity_ratio = 1.5",
        )
    assert given.nsk_cleanliness is not None
    clean = over_cases(given.nsk_cleanliness, "nsk_cleanliness", cases)
    load, ratings = basis.loads.dynamic, basis.ratings
    warm = [t for t in (given.temperature, given.bearing_temperature) if t is not None]
    hot = np.max(np.broadcast_arrays(*warm), axis=0) if warm else np.nan
    refused = nsk.refusals(
        load, ratings.dynamic_of_set, ratings.static_of_set, basis.balls.speed, hot
    )
    if given.nsk_table is None:
        factor = life_modification_factor(
            basis.viscosity_ratio, np.minimum(clean, 1.0), ratings.fatigue_of_set, load
        )
    else:
        place = nsk.load_parameter(load, ratings.fatigue_of_set, ratings.dynamic_of_set, clean)
        factor = given.nsk_table.at(basis.viscosity_ratio, place)
    rating_life = basic_rating_life(ratings.dynamic_of_set, load)
    outside = np.isnan(factor) & ~np.isnan(load)
    refused_factor = nsk.l_able(1.0, factor, refused)
    notes = {
        **_load_notes(basis),
        **refused,
        "stand_in_for_the_chart": np.full(cases, given.nsk_table is None),
        "viscosity_ratio_too_small" if given.nsk_table is None else "outside_the_table": outside,
    }
    factors = {"a_1": basis.reliability_factor, "a_nsk": refused_factor}
    return basis.record(L_ABLE, rating_life, factors, notes)
