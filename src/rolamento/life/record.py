"""The common record of all theories of life, and the notes that limit them.

The sentences of the notes are in `rolamento.words.sentences.life`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Any, Final

import numpy as np

from rolamento.life.iso16281 import ROLLER_SLOPE, SLOPE
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.validate import finite
from rolamento.words import Note

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
        "theory_of_balls",
    }
)
"""Notes that say that a theory is not valid for the case, though it may give a number."""
UNRATED: Final = frozenset({"no_force", "no_equivalent_load", "theory_of_balls"})
"""Those of them that say nothing against the case: the theory does not know such a one."""


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


_BY_ELEMENT: Final = frozenset(
    {
        "unloaded",
        "no_force",
        "moment_governs",
        "moment_left_out",
        "no_dynamic_rating",
        "ceramic_balls",
    }
)
"""Notes whose sentences name what rolls."""


def slope_of(element: str) -> float:
    """Return Weibull's e of a bearing's life, by its `Life.element`.

    A set of balls and rollers has none of its own; that of balls, the smaller, is the careful one.
    """
    return ROLLER_SLOPE if element == "roller" else SLOPE


def note_of(key: str, element: str) -> Note:
    """Return a note on a life by its key.

    Parameters
    ----------
    key
        Of the note.
    element
        "ball", "roller", or "element" of a set of both: the sentence of some names it.
    """
    return Note(key, {"element": element} if element != "ball" and key in _BY_ELEMENT else {})


@frozen(eq=False)
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
        by key, and in which cases each of them applies
    element
        "ball", "roller", or "element" of a set of both: what notes name
    """

    theory: str
    reliability: float
    basic: FloatArray
    life: FloatArray
    hours: FloatArray
    factors: Mapping[str, FloatArray] = field(default_factory=dict)
    notes: Mapping[str, BoolArray] = field(default_factory=dict)
    element: str = "ball"

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

    def notes_of(self, case: int = 0) -> tuple[Note, ...]:
        """Return the notes of one case."""
        return tuple(note_of(key, self.element) for key, where in self.notes.items() if where[case])

    def to_mapping(self, case: int = 0) -> dict[str, Any]:
        """Give one case as plain values; NaN as None, infinite life as None beside its note."""
        return {
            "theory": self.theory,
            "reliability": self.reliability,
            "basic": finite(self.basic[case]),
            "life": finite(self.life[case]),
            "hours": finite(self.hours[case]),
            "unlimited": bool(np.isposinf(self.life[case])),
            "factors": {name: finite(array[case]) for name, array in self.factors.items()},
            "valid": bool(self.valid[case]),
            "upper_bound": bool(self.below[case]),
            "notes": [note.to_mapping() for note in self.notes_of(case)],
        }
