"""Which parts of an analysis a case asks for, and which it has what they need for."""

from __future__ import annotations

import numpy as np

from rolamento.case import Case
from rolamento.solved import Solved


def has_oil(case: Case) -> bool:
    """Whether there is an oil or a grease."""
    return case.lubricant is not None and case.lubricant.kind != "dry"


def has_life(case: Case) -> bool:
    """Whether a life is asked for: by a designation, or the [life] table."""
    return case.life is not None or case.bearing.designation is not None


def has_friction(solved: Solved) -> bool:
    """Whether the coefficient of friction is known, or a film that it may be taken by."""
    if np.isfinite(solved.field("lubricant.friction_coefficient")).any():
        return True
    if not has_oil(solved.case):
        return False
    from rolamento.lubrication.films import has_film

    return has_film(solved)
