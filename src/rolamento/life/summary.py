"""All theories of life side by side, for a solved state or a batch of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.life import theories as by
from rolamento.life.conditions import LifeConditions, conditions_of
from rolamento.life.duty_loads import EquivalentLoads, Ratings
from rolamento.life.headline import Headline, headline_of
from rolamento.life.limits import limit_of
from rolamento.life.modified import MOST_RATIO
from rolamento.life.record import Life, Limit
from rolamento.life.reference import ReferenceLife
from rolamento.life.reliability import reliability_factor, reliability_of
from rolamento.life.solved_balls import SolvedRows, rows_of_batch, rows_of_state
from rolamento.numerics import FloatArray
from rolamento.rows.ball import BatchState
from rolamento.state import State

_HOUR: Final = 3600.0


@dataclass(frozen=True, slots=True, eq=False)
class LifeSummary:
    """Lives of solved cases by every theory that the conditions allow; arrays over cases.

    Attributes
    ----------
    theories
        by name: "iso281", "iso281_modified", "iso281_1990", "iso16281", "iso16281_modified",
        "ioannides_harris", "l_able"
    ratings
        C, C_0 and C_u, N
    loads
        P, P_0, X, Y, e and the static safety
    headline
        the life that leads, by the one rule for all reports, figures and outputs
    reference
        the reference life, race by race
    limit
        what limits the life
    viscosity_ratio, contamination_factor
        κ and e_C, (cases,); None where lubrication is not given
    conditions
        what it was reckoned with
    """

    theories: Mapping[str, Life]
    headline: Headline
    ratings: Ratings
    loads: EquivalentLoads
    reference: ReferenceLife
    limit: Limit
    viscosity_ratio: FloatArray | None
    contamination_factor: FloatArray | None
    conditions: LifeConditions

    def __getitem__(self, theory: str) -> Life:
        """Return the life by one theory."""
        return self.theories[theory]

    @property
    def rating_sources(self) -> dict[str, str]:
        """Where C, C_0 and C_u come from: "given", "geometry", or the source of the catalogue."""
        given, limit = self.conditions, self.conditions.fatigue_load_limit
        found = {"fatigue": limit if isinstance(limit, str) else "given"}
        for name in ("dynamic", "static"):
            own = getattr(given, f"{name}_rating") is not None
            found[name] = given.sources.get(f"{name}_rating", "given") if own else "geometry"
        return found

    def reliability_after(self, time: ArrayLike) -> FloatArray:
        """Reliability with which the bearing runs for a time, by the life that leads.

        Parameters
        ----------
        time
            A number or (cases,), s.

        Returns
        -------
        (cases,); NaN where there are no hours, or no life. Where the life is below a bound, so is
        the reliability.
        """
        edition, leading = self.conditions.edition, self.headline
        for_ninety = leading.hours / reliability_factor(leading.reliability, edition)
        with np.errstate(divide="ignore", invalid="ignore"):
            ratio = np.asarray(time, np.float64) / _HOUR / for_ninety
        known = np.where(np.isnan(ratio), 1.0, ratio)
        return np.where(np.isnan(ratio), np.nan, reliability_of(known, edition))

    def to_mapping(self, case: int = 0) -> dict[str, Any]:
        """Give one case as plain values, SI and millions of revolutions; NaN as None."""
        loads = {
            "equivalent": self.loads.dynamic,
            "static_equivalent": self.loads.static,
            "static_safety": self.loads.safety,
            "radial_factor": self.loads.radial_factor,
            "axial_factor": self.loads.axial_factor,
            "load_ratio_limit": self.loads.limit,
        }
        share = _at(self.limit.share, case)
        return {
            "headline": self.headline.to_mapping(case),
            "theories": {name: life.to_mapping(case) for name, life in self.theories.items()},
            "loads": {name: _at(array, case) for name, array in loads.items()},
            "ratings": {
                "dynamic": _at(self.ratings.dynamic_of_set, case),
                "static": _at(self.ratings.static_of_set, case),
                "fatigue": _at(self.ratings.fatigue_of_set, case),
                "sources": self.rating_sources,
            },
            "viscosity_ratio": _at(self.viscosity_ratio, case),
            "contamination_factor": _at(self.contamination_factor, case),
            "wanted_life": self._wanted(case),
            "limit": {
                "row": int(self.limit.row[case]),
                "race": str(self.limit.race[case]) or None,
                "ball": int(self.limit.ball[case]) if self.limit.ball[case] >= 0 else None,
                "share": share,
                "factor": str(self.limit.factor[case]) or None,
            },
        }

    def _wanted(self, case: int) -> dict[str, float | bool | None] | None:
        """The life that is wanted (s), and its reliability; None if none is."""
        wanted = self.conditions.wanted_life
        if wanted is None:
            return None
        return {
            "life": wanted,
            "reliability": _at(self.reliability_after(wanted), case),
            "below": bool(self.headline.below[case]),
        }


def life(
    state: State, conditions: LifeConditions | None = None, *, stress_volume: bool = True
) -> LifeSummary:
    """Life of a solved state by every theory that the conditions allow.

    Parameters
    ----------
    state
        Of `rolamento.solve`.
    conditions
        Ratings, lubrication and wishes; by default those of the case, `conditions_of`.
    stress_volume
        Whether to evaluate the theory of Ioannides and Harris.

    Raises
    ------
    InputError
        If the bearing is a thrust bearing (above 45°), or no rating is given and none follows.
    """
    given = conditions_of(state.case) if conditions is None else conditions
    return _summary(rows_of_state(state), given, stress_volume)


def life_of_batch(
    case: Case,
    batch: BatchState,
    conditions: LifeConditions | None = None,
    *,
    stress_volume: bool = False,
) -> LifeSummary:
    """Life of solved cases; as `life`, with arrays over cases.

    Parameters
    ----------
    case
        The one that was solved.
    batch
        Of `solve_batch`.
    conditions, stress_volume
        As `life`; the numbers of the conditions may be arrays (cases,).
    """
    given = conditions_of(case) if conditions is None else conditions
    return _summary(rows_of_batch(case, batch), given, stress_volume)


def _summary(balls: SolvedRows, given: LifeConditions, stress_volume: bool) -> LifeSummary:
    basis = by.basis_of(balls, given)
    theories = {by.BASIC: by.basic(basis), by.REFERENCE: by.referenced(basis)}
    if basis.contamination_factor is not None:
        theories[by.MODIFIED] = by.modified(basis)
        theories[by.MODIFIED_REFERENCE] = by.modified_reference(basis)
    if given.material_factor is not None or given.operation_factor is not None:
        theories[by.ADJUSTED] = by.adjusted(basis)
    if stress_volume:
        theories[by.STRESS_VOLUME] = by.stress_volume(basis)
    if given.nsk_cleanliness is not None:
        theories[by.L_ABLE] = by.l_able(basis)
    return LifeSummary(
        theories=theories,
        headline=headline_of(basis, theories.get(by.MODIFIED_REFERENCE), theories[by.REFERENCE]),
        ratings=basis.ratings,
        loads=basis.loads,
        reference=basis.reference,
        limit=limit_of(
            balls,
            basis.reference,
            by.factor_now(basis),
            by.factor_if(basis, ratio=MOST_RATIO),
            by.factor_if(basis, clean=1.0),
        ),
        viscosity_ratio=basis.viscosity_ratio,
        contamination_factor=basis.contamination_factor,
        conditions=given,
    )


def _at(array: FloatArray | None, case: int) -> float | None:
    """One case's number of an array over cases, or of one for all; None where there is none."""
    if array is None:
        return None
    value = float(array[case if array.size > 1 else 0])
    return value if np.isfinite(value) else None
