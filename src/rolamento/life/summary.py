"""All theories of life side by side, for a solved state or a batch of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from rolamento.case import Case
from rolamento.equilibrium import BatchState
from rolamento.life import theories as by
from rolamento.life.conditions import LifeConditions
from rolamento.life.duty_loads import EquivalentLoads, Ratings
from rolamento.life.limits import limit_of
from rolamento.life.record import Life, Limit
from rolamento.life.reference import ReferenceLife
from rolamento.life.solved_balls import SolvedRows, rows_of_batch, rows_of_state
from rolamento.numerics import FloatArray
from rolamento.state import State


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
    reference
        the reference life, race by race
    limit
        what limits the life
    viscosity_ratio, contamination_factor
        κ and e_C, (cases,); None where lubrication is not given
    """

    theories: Mapping[str, Life]
    ratings: Ratings
    loads: EquivalentLoads
    reference: ReferenceLife
    limit: Limit
    viscosity_ratio: FloatArray | None
    contamination_factor: FloatArray | None

    def __getitem__(self, theory: str) -> Life:
        """Return the life by one theory."""
        return self.theories[theory]

    def best(self) -> Life:
        """Return the theory that knows most: modified reference, else reference life."""
        return self.theories.get(by.MODIFIED_REFERENCE, self.theories[by.REFERENCE])

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
            "theories": {name: life.to_mapping(case) for name, life in self.theories.items()},
            "loads": {name: _at(array, case) for name, array in loads.items()},
            "ratings": {
                "dynamic": _at(self.ratings.dynamic_of_set, case),
                "static": _at(self.ratings.static_of_set, case),
                "fatigue": _at(self.ratings.fatigue_of_set, case),
            },
            "viscosity_ratio": _at(self.viscosity_ratio, case),
            "contamination_factor": _at(self.contamination_factor, case),
            "limit": {
                "row": int(self.limit.row[case]),
                "race": str(self.limit.race[case]) or None,
                "ball": int(self.limit.ball[case]) if self.limit.ball[case] >= 0 else None,
                "share": share,
                "factor": str(self.limit.factor[case]) or None,
            },
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
        Ratings, lubrication and wishes; by default everything from the geometry, for 90 %.
    stress_volume
        Whether to evaluate the theory of Ioannides and Harris.

    Raises
    ------
    InputError
        If the bearing is a thrust bearing (above 45°), or no rating is given and none follows.
    """
    return _summary(rows_of_state(state), conditions or LifeConditions(), stress_volume)


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
    return _summary(rows_of_batch(case, batch), conditions or LifeConditions(), stress_volume)


def _summary(balls: SolvedRows, given: LifeConditions, stress_volume: bool) -> LifeSummary:
    basis = by.basis_of(balls, given)
    reference = by.reference_of(basis)
    theories = {by.BASIC: by.basic(basis), by.REFERENCE: by.referenced(basis, reference)}
    if basis.contamination_factor is not None:
        theories[by.MODIFIED] = by.modified(basis)
        theories[by.MODIFIED_REFERENCE] = by.modified_reference(basis, reference)
    if given.material_factor is not None or given.operation_factor is not None:
        theories[by.ADJUSTED] = by.adjusted(basis)
    if stress_volume:
        theories[by.STRESS_VOLUME] = by.stress_volume(basis, reference)
    if given.nsk_cleanliness is not None:
        theories[by.L_ABLE] = by.l_able(basis)
    return LifeSummary(
        theories=theories,
        ratings=basis.ratings,
        loads=basis.loads,
        reference=reference,
        limit=limit_of(
            balls,
            reference,
            by.factor_now(basis, reference),
            by.factor_if(basis, reference, ratio=4.0),
            by.factor_if(basis, reference, clean=1.0),
        ),
        viscosity_ratio=basis.viscosity_ratio,
        contamination_factor=basis.contamination_factor,
    )


def _at(array: FloatArray | None, case: int) -> float | None:
    """One case's number of an array over cases, or of one for all; None where there is none."""
    if array is None:
        return None
    value = float(array[case if array.size > 1 else 0])
    return value if np.isfinite(value) else None
