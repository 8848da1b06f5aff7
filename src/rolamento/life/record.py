"""The common record of all theories of life, and what the notes mean."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import isfinite
from typing import Any, Final

import numpy as np

from rolamento.numerics import BoolArray, FloatArray

NOTES: Final[Mapping[str, str]] = {
    # outside what the theory is valid for
    "load_above_half_rating": (
        "The equivalent load is above half of the dynamic rating: the contacts deform plastically,"
        " and the standard does not vouch for the life."
    ),
    "load_above_static_rating": (
        "The equivalent load is above the static rating: lasting dents are to be expected."
    ),
    "viscosity_ratio_too_small": (
        "The viscosity ratio κ is below 0.1, where the standard gives no factor: the surfaces"
        " touch, and the life is less than a tenth of the basic one."
    ),
    "contamination_severe": (
        "The contamination factor is 0: wear, not fatigue, ends the life, before a tenth of the"
        " basic one."
    ),
    "too_hot_for_steel": (
        "The rings, the balls or the lubricant are hotter than 120 °C, which plain bearing steel"
        " bears: hardness and size change, and the rating falls. Ask for stabilised rings."
    ),
    "unloaded": (
        "No ball carries load from ring to ring: there is no rating life. Without a minimum load"
        " balls slide, and that is what ends the life."
    ),
    "no_force": (
        "No force acts from ring to ring, so there is no equivalent load, and the standard does not"
        " apply; the reference life counts the moment or the preload that loads the balls."
    ),
    "moment_governs": (
        "The moment loads the balls more than the forces do (2M/d_m > F), and the equivalent load"
        " leaves out the moment; the reference life counts it, ball by ball."
    ),
    "no_fatigue_load_limit": (
        "Without a fatigue load limit C_u there is no modified life: give life.fatigue_load_limit."
    ),
    "no_equivalent_load": (
        "The standard has no equivalent load for this set: its rows differ, or are more than a"
        " tandem or a pair. The reference life is valid for it."
    ),
    "thrust_bearing": (
        "The contact angle is beyond 45°: a thrust bearing, for which these theories are not valid."
    ),
    "no_dynamic_rating": (
        "The geometry lies outside the standard's table (D cos α/d_m from 0.01 to 0.40), and no"
        " dynamic rating is given; or the case has no geometry."
    ),
    "too_slow": "The bearing turns slower than 20 r/min, for which the maker gives no life.",
    "too_hot": "The bearing is hotter than 130 °C, for which the maker gives no life.",
    "outside_the_table": (
        "Viscosity ratio or load lie outside the user's table of a_NSK, which is not continued."
    ),
    # an upper bound only
    "viscosity_unknown": (
        "The viscosity is not given: even with the thickest oil so much dirt leaves less than this."
    ),
    "contamination_unknown": (
        "The cleanliness is not given: even perfectly clean so thin an oil leaves less than this."
    ),
    # what the number leaves out, or how it was had
    "factors_of_the_user": (
        "The factors of Tallian's form are the user's: none are public. What is not given is by"
        " Lundberg and Palmgren."
    ),
    "surface_left_out": (
        "No factors of failures from the surface are given: only those from below it count."
    ),
    "moment_left_out": (
        "The equivalent load leaves out the moment; the reference life counts it, ball by ball."
    ),
    "preload_left_out": "The equivalent load leaves out the preload; the reference life counts it.",
    "centrifugal_left_out": (
        "The balls press harder on the outer race than on the inner, by their centrifugal force;"
        " the equivalent load leaves that out; the reference life counts it."
    ),
    "open_grooves": (
        "The grooves are more open than 0.52 (inner) or 0.53 (outer). A rating that is not given"
        " is lowered for it; one that is given has to be the bearing's own."
    ),
    "close_grooves": (
        "The grooves are closer than 0.52 (inner) or 0.53 (outer). The standard warns that closer"
        " grooves need not raise the rating, and none is raised."
    ),
    "ceramic_balls": (
        "The balls are not of steel. With silicon nitride the dynamic rating is that of steel balls"
        " (ISO 20056-1); the static rating is not, and has to be given."
    ),
    "no_static_rating": (
        "Without the maker's static rating for these balls there is no static safety."
    ),
    "viscosity_ratio_capped": "The viscosity ratio κ counts as 4, where the standard ends.",
    "reliability_continued": (
        "The reliability lies outside the standard's table; its formula is continued."
    ),
    "material_factor_unsupported": (
        "a_2 is not 1: the standard requires evidence from the maker for it."
    ),
    "operation_factor_too_great": (
        "The oil is thinner than 13 mm²/s, or n d_m below 10 000: the standard asks for a_3 < 1."
    ),
    "operation_factor_unfounded": (
        "a_3 above 1 needs surfaces that a film separates; it makes up for no steel."
    ),
    "stand_in_for_the_chart": (
        "a_NSK is published as charts only: a_ISO with e_C = a_c stands in for it here."
    ),
    "no_surface_stress": (
        "Stress below the surface only, with a fatigue limit: without friction, dents and"
        " asperities this is an upper bound, wildly optimistic at 3 GPa and more."
    ),
    "below_fatigue_limit": "No point is stressed beyond the fatigue limit: no end by fatigue.",
    "at_rest": "Nothing turns: there are no hours.",
    "light_load": (
        "The equivalent load is below C/100, the usual minimum load of ball bearings: the balls may"
        " slide rather than roll, which no theory of fatigue counts."
    ),
    "load_shared_otherwise": (
        "The balls do not share the load as the standard takes it, with a normal clearance: the"
        " reference life, which counts the real one, is less than half or more than twice this one."
    ),
}
"""What each note says."""

OUTSIDE: Final = frozenset(
    {
        "load_above_half_rating",
        "load_above_static_rating",
        "viscosity_ratio_too_small",
        "contamination_severe",
        "too_hot_for_steel",
        "unloaded",
        "no_force",
        "moment_governs",
        "no_fatigue_load_limit",
        "no_equivalent_load",
        "thrust_bearing",
        "no_dynamic_rating",
        "too_slow",
        "too_hot",
        "outside_the_table",
    }
)
"""Notes that say that a theory is not valid for the case, though it may give a number."""


BOUNDS: Final = frozenset(
    {
        "viscosity_ratio_too_small",
        "contamination_severe",
        "viscosity_unknown",
        "contamination_unknown",
        "no_surface_stress",
    }
)
"""Notes that say that the number is an upper bound: the life is below it."""


@dataclass(frozen=True, slots=True, eq=False)
class Life:
    """Life by one theory; arrays over cases, NaN where the theory gives no number.

    Attributes
    ----------
    theory
        its name
    reliability
        S that the life is for
    basic
        life for 90 % without the factors; millions of revolutions
    life
        with the factors and for the reliability, millions of revolutions of one ring against the
        other; infinite where fatigue never ends it
    hours
        the same at the case's speed; NaN where nothing turns
    factors
        by which the basic life was multiplied, and what they come from, by name
    notes
        names in `NOTES`, and in which cases each of them is true
    """

    theory: str
    reliability: float
    basic: FloatArray
    life: FloatArray
    hours: FloatArray
    factors: Mapping[str, FloatArray] = field(default_factory=dict)
    notes: Mapping[str, BoolArray] = field(default_factory=dict)

    @property
    def valid(self) -> BoolArray:
        """(cases,): whether there is a life, and the case lies within what the theory is for."""
        return self._without(OUTSIDE)

    @property
    def below(self) -> BoolArray:
        """(cases,): whether the number is an upper bound, and the life is below it."""
        bound = np.zeros(len(self.life), dtype=np.bool_)
        for name in BOUNDS & set(self.notes):
            bound = bound | self.notes[name]
        return np.asarray(bound & self._without(OUTSIDE - BOUNDS))

    def _without(self, refusing: frozenset[str]) -> BoolArray:
        """(cases,): whether there is a life, and none of some notes is true."""
        fine = ~np.isnan(self.life)
        for name in refusing & set(self.notes):
            fine = fine & ~self.notes[name]
        return np.asarray(fine)

    def notes_of(self, case: int = 0) -> tuple[str, ...]:
        """Name the notes of one case."""
        return tuple(name for name, where in self.notes.items() if where[case])

    def sentences(self, case: int = 0) -> tuple[str, ...]:
        """Say the notes of one case."""
        return tuple(NOTES[name] for name in self.notes_of(case))

    def to_mapping(self, case: int = 0) -> dict[str, Any]:
        """Give one case as plain values; NaN as None, endless life as None beside its note."""
        return {
            "theory": self.theory,
            "reliability": self.reliability,
            "basic": finite(self.basic[case]),
            "life": finite(self.life[case]),
            "hours": finite(self.hours[case]),
            "endless": bool(np.isposinf(self.life[case])),
            "factors": {name: finite(array[case]) for name, array in self.factors.items()},
            "holds": bool(self.valid[case]),
            "below": bool(self.below[case]),
            "notes": list(self.sentences(case)),
        }


def finite(value: float) -> float | None:
    """Return a number as JSON has it: None where there is none."""
    return float(value) if isfinite(value) else None
