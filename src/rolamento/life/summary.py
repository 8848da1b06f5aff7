"""All theories of life side by side, for one solved case or many."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cached_property, partial
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.errors import InputError
from rolamento.life import iso16281, iso16281_modified
from rolamento.life.basis import Basis, EquivalentLoads
from rolamento.life.conditions import LifeConditions, conditions_of
from rolamento.life.headline import Headline, headline_of
from rolamento.life.iso281_modified import MAXIMUM_RATIO
from rolamento.life.iso16281 import ReferenceLife
from rolamento.life.record import BOUNDS, OUTSIDE, Life
from rolamento.life.reliability import reliability_factor, reliability_of
from rolamento.life.rib_load import RibLoad
from rolamento.life.row_ratings import Ratings
from rolamento.life.theories import THEORIES
from rolamento.numerics import FloatArray
from rolamento.records import Lazily, frozen, span
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.units import HOUR
from rolamento.validate import finite, numbers
from rolamento.words import Note, said
from rolamento.words.headlines import qualifies

_ALIKE: Final = 1e-12
"""Fraction of a life: races that differ by less do so by rounding, and the first of them is
named."""
_MILLION: Final = 1e6
_WORTH: Final = 1.5
"""Gain of the modified life below which neither oil nor cleanliness is what limits it."""


@frozen(eq=False)
class Limit:
    """What limits the life; arrays over cases.

    Attributes
    ----------
    row
        that lives shortest, counted from 0
    race
        of that row that lives shortest: "inner" or "outer"; empty without load or result
    ball
        that presses hardest on that race, counted from 0 over all rows; -1 without
    share
        of the bearing's risk that this race has
    factor
        what would raise the modified life most: "viscosity_ratio", "contamination" or "load";
        empty where lubrication is not known
    """

    row: NDArray[np.int64]
    race: NDArray[np.str_]
    ball: NDArray[np.int64]
    share: FloatArray
    factor: NDArray[np.str_]


@frozen(eq=False, slots=False)
class LifeSummary:
    """Lives of solved cases by every theory that the conditions allow; arrays over cases.

    Attributes
    ----------
    theories
        by their names in `theories.THEORIES`, in that order; those that were asked for. Each is
        evaluated when it is first looked up, unless the conditions may have to be refused for it
    ratings
        C, C_0 and C_u, N
    loads
        P, P_0, X, Y, e and the static safety
    headline
        the life that leads, by the one rule for all reports, figures and outputs
    reference, reference_load
        the reference life, race by race, and P_ref, (cases,), N
    limiting
        finds the `limit`
    viscosity_ratio, contamination_factor
        κ and e_C, (cases,); None where lubrication is not given
    rib_load
        what the ribs of a cylindrical roller bearing carry and may carry; None of others
    slices
        into how many slices rollers were divided; None without rollers
    independent
        the life that leads with independent slices, of which the standards' lives are; None where
        the slices are not coupled, and of many cases of a mounted bearing
    conditions
        what it was calculated with
    """

    theories: Mapping[str, Life]
    headline: Headline
    ratings: Ratings
    loads: EquivalentLoads
    reference: ReferenceLife
    reference_load: FloatArray
    limiting: Callable[[], Limit]
    viscosity_ratio: FloatArray | None
    contamination_factor: FloatArray | None
    conditions: LifeConditions
    rib_load: RibLoad | None = None
    slices: int | None = None
    independent: Headline | None = None

    def _shown(self) -> dict[str, str]:
        ratings = self.ratings
        dynamic, static = span(ratings.dynamic_of_set, "N"), span(ratings.static_of_set, "N")
        return {
            **self.headline._shown(),
            "ratings": f"C {dynamic}, C0 {static}",
            "equivalent load": span(self.loads.dynamic, "N"),
            "static safety": span(self.loads.safety),
            "theories": ", ".join(self.theories),
        }

    def __getitem__(self, theory: str) -> Life:
        """Return the life by one theory."""
        return self.theories[theory]

    @cached_property
    def limit(self) -> Limit:
        """What limits the life."""
        return self.limiting()

    @property
    def rating_sources(self) -> dict[str, str]:
        """Where C, C_0 and C_u come from: "given", "geometry", or the source of the catalogue.

        "rows" of a set of balls and rollers: each row's own, by its designation or its geometry.
        """
        given, limit = self.conditions, self.conditions.fatigue_load_limit
        listed = given.sources.get("fatigue_load_limit", "given")
        found = {"fatigue": limit if isinstance(limit, str) else listed}
        for name in ("dynamic", "static"):
            own = getattr(given, f"{name}_rating") is not None
            other = "rows" if self.ratings.mixed else "geometry"
            found[name] = given.sources.get(f"{name}_rating", "given") if own else other
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
            ratio = numbers(time, "time") / HOUR / for_ninety
        known = np.where(np.isnan(ratio), 1.0, ratio)
        return np.where(np.isnan(ratio), np.nan, reliability_of(known, edition))

    def qualifications(self, case: int = 0) -> tuple[Note, ...]:
        """Return the notes that qualify the life that leads in one case; none where none leads.

        What it leaves out, and where its theory is strained. Why it is a bound, or why nothing
        leads, is `Headline.reason_of`.
        """
        leading = self.headline
        if not leading.leads[case]:
            return ()
        own = self.theories.get(str(leading.theory[case]), self.theories[iso16281.THEORY.name])
        said_before = OUTSIDE | BOUNDS
        return (
            *self._lubrication_left_out(case),
            *self._coupled(case),
            *(n for n in own.notes_of(case) if n.key not in said_before and qualifies(n)),
        )

    def _lubrication_left_out(self, case: int) -> tuple[Note, ...]:
        """What the basic reference life leaves out where it leads, and what is missing for it."""
        if self.headline.below[case] or self.headline.theory[case] != iso16281.THEORY.name:
            return ()
        only_clean = self.viscosity_ratio is not None and self.contamination_factor is None
        return (Note("cleanliness_missing" if only_clean else "lubrication_left_out"),)

    def _coupled(self, case: int) -> tuple[Note, ...]:
        """What the standards' independent slices give where those of the case are coupled."""
        if self.independent is None:
            return ()
        valid = bool(self.independent.leads[case])
        life, hours = (
            finite(getattr(self.independent, name)[case] * unit) if valid else None
            for name, unit in (("life", _MILLION), ("hours", HOUR))
        )
        below = bool(self.independent.below[case])
        values = {"revolutions": life, "life": hours, "upper_bound": below}
        return (Note("life_of_coupled_slices", values),)

    def to_mapping(self, case: int = 0) -> dict[str, Any]:
        """Give one case as plain values, SI and millions of revolutions; NaN as None."""
        theories = {name: life.to_mapping(case) for name, life in self.theories.items()}
        whole = self.whole(case)
        return {"headline": whole.pop("headline"), "theories": theories, **whole}

    def whole(self, case: int = 0) -> dict[str, Any]:
        """What `to_mapping` has that is not of a single theory."""
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
            "headline": {
                **self.headline.to_mapping(case),
                "notes": [note.to_mapping() for note in self.qualifications(case)],
            },
            "loads": {
                **{name: _at(array, case) for name, array in loads.items()},
                "factors_listed": self.loads.listed,
            },
            "ratings": {
                "dynamic": _at(self.ratings.dynamic_of_set, case),
                "static": _at(self.ratings.static_of_set, case),
                "fatigue": _at(self.ratings.fatigue_of_set, case),
                "fatigue_by_contacts": _at(self.ratings.fatigue_by_contacts, case),
                "sources": self.rating_sources,
                **self._of_rows(case),
            },
            "viscosity_ratio": _at(self.viscosity_ratio, case),
            "contamination_factor": _at(self.contamination_factor, case),
            "required_life": self._required(case),
            "limit": {
                "row": int(self.limit.row[case]),
                "race": str(self.limit.race[case]) or None,
                "ball": int(self.limit.ball[case]) if self.limit.ball[case] >= 0 else None,
                "share": share,
                "factor": str(self.limit.factor[case]) or None,
            },
            **({} if self.slices is None else {"slices": self.slices}),
            **({} if self.rib_load is None else {"rib_load": self.rib_load.to_mapping(case)}),
        }

    def _of_rows(self, case: int) -> dict[str, Any]:
        """Ratings row by row of a set of balls and rollers, which has none of its own."""
        if not self.ratings.mixed:
            return {}
        columns = {name: getattr(self.ratings, name) for name in ("dynamic", "static", "fatigue")}
        return {
            "rows": [
                {name: finite(values[case, index]) for name, values in columns.items()}
                for index in range(len(self.ratings.kinds))
            ]
        }

    def _required(self, case: int) -> dict[str, float | bool | None] | None:
        """The required life (s), and its reliability; None if there is none."""
        wanted = self.conditions.required_life
        if wanted is None:
            return None
        return {
            "life": wanted,
            "reliability": _at(self.reliability_after(wanted), case),
            "upper_bound": bool(self.headline.below[case]),
        }


def _life_by(basis: Basis, name: str) -> Life:
    """The life by one theory."""
    theory = THEORIES[name]
    if theory.of_balls and basis.has_rollers:
        return basis.refused(name, "theory_of_balls")
    return theory.evaluate(basis)


def life(
    solved: Solved,
    conditions: LifeConditions | None = None,
    *,
    stress_volume: bool | None = None,
) -> LifeSummary:
    """Life of solved cases by every theory that the conditions ask for.

    Parameters
    ----------
    solved
        Of `rolamento.solve`, one case or many.
    conditions
        Ratings, lubrication and wishes, numbers or arrays (cases,); by default what the case says
        and what varied from it, `conditions_of`.
    stress_volume
        Whether to evaluate theories that take milliseconds for a case, such as that of Ioannides
        and Harris; by default of a single case only.

    Raises
    ------
    InputError
        If the bearing is a thrust bearing (above 45°), or no rating is given and none follows.
    """
    if not isinstance(solved, Solved):
        raise InputError(
            said("must be the result of rolamento.solve"),
            field="solved",
            value=type(solved).__name__,
            example="life(rolamento.solve(case))",
        )
    given = conditions_of(solved) if conditions is None else conditions
    slow = len(solved) == 1 if stress_volume is None else stress_volume
    basis = Basis.of(solved, given)
    asked = [one for one in THEORIES.values() if one.asked(basis) and (slow or not one.slow)]
    theories = Lazily((one.name for one in asked), partial(_life_by, basis))
    for one in asked:
        if one.refuses:
            theories[one.name]
    modified = theories.get(iso16281_modified.THEORY.name)
    return LifeSummary(
        theories=theories,
        headline=headline_of(basis, modified, theories[iso16281.THEORY.name]),
        ratings=basis.ratings,
        loads=basis.loads,
        reference=basis.reference,
        reference_load=basis.reference_load,
        limiting=partial(_limit_of, basis),
        viscosity_ratio=basis.viscosity_ratio,
        contamination_factor=basis.contamination_factor,
        conditions=given,
        rib_load=basis.rib_load,
        slices=None if solved.rollers is None else solved.rollers.slices,
        independent=_by_independent_slices(solved, given),
    )


def _by_independent_slices(solved: Solved, given: LifeConditions) -> Headline | None:
    """The life that leads if the same cases are solved with independent slices; see `LifeSummary`.

    Where a mounting changed what varies, the cases cannot be written down again.
    """
    mounted = bool(solved.varied) and solved.before_mounting is not None
    if solved.rollers is None or solved.case.model.roller_contact != "coupled" or mounted:
        return None
    model = solved.case.model.replace(roller_contact="slices")
    again = solve(solved.case.replace(model=model), dict(solved.varied) or None, preload_loss=False)
    again = replace(again, before_mounting=solved.before_mounting)
    return life(again, given, stress_volume=False).headline


def _limit_of(basis: Basis) -> Limit:
    """Find what limits the life of solved cases."""
    reference, rows = basis.reference, basis.solved.rows
    count = len(rows)
    races = np.concatenate([reference.inner, reference.outer], axis=1)
    ended = np.isfinite(reference.life) & ~basis.unloaded
    lives = np.where(np.isnan(races), np.inf, races)
    weakest = np.argmax(lives <= (1.0 + _ALIKE) * lives.min(axis=1, keepdims=True), axis=1)
    row = np.where(ended, weakest % count, 0)
    inner = weakest < count
    race = np.where(ended, np.where(inner, "inner", "outer"), "")
    with np.errstate(divide="ignore", invalid="ignore"):
        risk = (reference.life[:, np.newaxis] / races) ** reference.race_slopes
        share = np.take_along_axis(risk, weakest[:, np.newaxis], 1)[:, 0] / risk.sum(axis=1)
    load = np.where(inner[:, np.newaxis], basis.solved.inner.load, basis.solved.outer.load)
    own = rows.row_of_element == row[:, np.newaxis]
    heaviest = np.argmax(np.where(own & ~np.isnan(load), load, -1.0), axis=1)
    return Limit(
        row=np.asarray(row, dtype=np.int64),
        race=np.asarray(race, dtype=np.str_),
        ball=np.where(ended, heaviest, -1).astype(np.int64),
        share=np.where(ended, share, np.nan),
        factor=_costliest(basis),
    )


def _costliest(basis: Basis) -> NDArray[np.str_]:
    """Which of thicker oil (κ = 4), cleaner oil (e_C = 1) and less load would gain most."""
    ratio, clean = basis.viscosity_ratio, basis.contamination_factor
    if ratio is None or clean is None:
        return np.full(len(basis), "", dtype="U15")
    thick = np.full(len(basis), MAXIMUM_RATIO)
    clean_if_thick = basis.cleanliness_at(thick)
    assert clean_if_thick is not None

    def factor_if(ratio: FloatArray, clean: FloatArray) -> FloatArray:
        """a_ISO if the oil were thicker or cleaner; NaN where the theory cannot judge it."""
        factor = basis.modification_factor(ratio, clean, bounded=False)
        return np.where(clean > 0.0, factor, np.nan)

    now = basis.modification_factor(ratio, clean)
    with np.errstate(invalid="ignore", divide="ignore"):
        gain_of_oil = factor_if(thick, clean_if_thick) / now
        gain_of_filter = factor_if(ratio, np.ones(len(basis))) / now
        oil, dirt = np.nan_to_num(gain_of_oil), np.nan_to_num(gain_of_filter)
    best = np.where(oil >= dirt, "viscosity_ratio", "contamination")
    named = np.where(np.maximum(oil, dirt) < _WORTH, "load", best)
    # where only one of them can be judged, the load cannot be judged to cost most
    judged = ~np.isnan(gain_of_oil) & ~np.isnan(gain_of_filter)
    return np.asarray(np.where((named == "load") & ~judged, "", named), dtype="U15")


def _at(array: FloatArray | None, case: int) -> float | None:
    """One case's number of an array over cases, or of one for all; None where there is none."""
    if array is None:
        return None
    return finite(array[case])
