"""Which life leads: one rule for every report, table, figure and output.

The reference life counts every ball; where κ and e_C are known, the modified reference life counts
oil and contamination too, and leads. A life that includes less never takes its place: what it
leaves out is what is wrong with the case. Three things may stand in the way of a number:

- κ below 0.1, or e_C of 0: the standard gives no factor. a_ISO does not fall with κ or e_C, and is
  0.1 where either ends, so the life is below a tenth of the basic one. That bound leads.
- Only one of κ and e_C is known. The other can at best be κ = 4 or e_C = 1. Where even then a_ISO
  is below 1, it bounds the life, and that bound leads; else the basic reference life does, with the
  remark that lubrication and contamination are not included.
- The load, the temperature or the geometry is outside what the reference life is for: nothing
  leads.

So the life that leads never increases as the oil thins, contamination rises or the load grows.

Sources: ISO 281:2007, 9.3.3; ADR 0010.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rolamento.life.basis import Basis
from rolamento.life.iso281_modified import MAXIMUM_RATIO, MINIMUM_RATIO
from rolamento.life.iso16281_modified import THEORY as MODIFIED_REFERENCE
from rolamento.life.record import BOUNDS, OUTSIDE, Life, note_of
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen, span
from rolamento.validate import finite
from rolamento.words import Note

__all__ = ["Headline", "headline_of"]

Names = NDArray[np.str_]
_NAME = "U40"


@frozen(eq=False)
class Headline:
    """The life that leads; arrays over cases.

    Attributes
    ----------
    theory
        that it is by: "iso16281_modified", or "iso16281"; empty without a result
    reliability
        S that it is for
    life, hours
        millions of revolutions and hours; NaN where there is none. Where neither `valid` nor
        `below` is true this is what the formula gives, and not to be relied on
    valid
        whether the theory is for such a case
    below
        whether the number is a bound, and the life less
    reason
        key of a note: why it is a bound, or why nothing leads; empty where the life is valid
    factor
        of the basic reference life: a_1 a_ISO
    element
        as of `Life`
    """

    theory: Names
    reliability: float
    life: FloatArray
    hours: FloatArray
    valid: BoolArray
    below: BoolArray
    reason: Names
    factor: FloatArray
    element: str = "ball"

    def _shown(self) -> dict[str, str]:
        theories = ", ".join(dict.fromkeys(map(str, self.theory)))
        if not self.valid.all():
            theories += ", an upper bound" if self.leads.all() else ", not valid"
        return {
            "": theories,
            "cases": str(len(self.life)),
            "life": f"{span(self.hours, 'h')}, {span(self.life)} million revolutions",
            "reliability": f"{self.reliability:.6g}",
        }

    @property
    def leads(self) -> BoolArray:
        """(cases,): whether there is a life, or a bound of it, to go by."""
        return np.asarray(self.valid | self.below)

    def reason_of(self, case: int = 0) -> Note | None:
        """Say why it is a bound, or why nothing leads, in one case; None where it is valid."""
        return note_of(str(self.reason[case]), self.element) if self.reason[case] else None

    def to_mapping(self, case: int = 0) -> dict[str, Any]:
        """Give one case as plain values; NaN as None, infinite life as None beside "unlimited"."""
        reason = self.reason_of(case)
        return {
            "theory": str(self.theory[case]) or None,
            "reliability": self.reliability,
            "life": finite(self.life[case]),
            "hours": finite(self.hours[case]),
            "unlimited": bool(np.isposinf(self.life[case])),
            "valid": bool(self.valid[case]),
            "upper_bound": bool(self.below[case]),
            "reason": None if reason is None else reason.to_mapping(),
        }


def headline_of(basis: Basis, modified: Life | None, basic: Life) -> Headline:
    """Choose the life that leads.

    Parameters
    ----------
    basis
        What the theories share.
    modified
        The modified reference life; None unless κ and e_C are known.
    basic
        The basic reference life.
    """
    if modified is not None:
        return _headline(modified, modified.factors["a_1"] * modified.factors["a_iso"])
    bound, reason = _half_known(basis, basic)
    binds = bound < 1.0
    share = np.where(binds, bound, 1.0)
    found = _headline(basic, basic.factors["a_1"] * share)
    below = binds & found.valid
    return Headline(
        theory=np.where(binds, MODIFIED_REFERENCE.name, found.theory).astype(_NAME),
        reliability=found.reliability,
        life=found.life * share,
        hours=found.hours * share,
        valid=np.asarray(found.valid & ~binds),
        below=np.asarray(below),
        reason=np.where(below, reason, found.reason).astype(_NAME),
        factor=found.factor,
        element=found.element,
    )


def _headline(record: Life, factor: FloatArray) -> Headline:
    cases = len(record.life)
    return Headline(
        theory=np.full(cases, record.theory, dtype=_NAME),
        reliability=record.reliability,
        life=record.life,
        hours=record.hours,
        valid=record.valid,
        below=record.below,
        reason=_reason(record),
        factor=np.asarray(np.broadcast_to(factor, cases)),
        element=record.element,
    )


def _reason(record: Life) -> Names:
    """First note that refuses the life; if none does, the first that makes it a bound."""
    found = np.full(len(record.life), "", dtype=_NAME)
    refusing = [name for name in record.notes if name in OUTSIDE - BOUNDS]
    bounding = [name for name in record.notes if name in BOUNDS]
    for name in (*refusing, *bounding):
        found = np.where((found == "") & record.notes[name], name, found).astype(_NAME)
    return found


def _half_known(basis: Basis, basic: Life) -> tuple[FloatArray, Names]:
    """a_ISO with the best that may be where one of κ and e_C is unknown, and the note for it."""
    cases = len(basis)
    ratio = basis.viscosity_ratio
    clean = basis.cleanliness_at(np.full(cases, MAXIMUM_RATIO) if ratio is None else ratio)
    if ratio is None and clean is None:
        return np.full(cases, np.inf), np.full(cases, "", dtype=_NAME)
    kappa = np.full(cases, MAXIMUM_RATIO) if ratio is None else ratio
    dirt = np.ones(cases) if clean is None else clean
    factor = basis.modification_factor(kappa, dirt)
    reason = np.full(cases, "viscosity_unknown" if ratio is None else "contamination_unknown")
    reason = np.where(kappa < MINIMUM_RATIO, "viscosity_ratio_too_small", reason)
    reason = np.where(dirt <= 0.0, "contamination_severe", reason)
    return np.where(np.isnan(factor), np.inf, factor), reason.astype(_NAME)
