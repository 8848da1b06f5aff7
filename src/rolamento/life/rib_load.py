"""What the ribs of a solved cylindrical roller bearing carry, and how much they may."""

from __future__ import annotations

from typing import Any

import numpy as np

from rolamento.case import Case
from rolamento.numerics import BoolArray, FloatArray
from rolamento.ratings.ribs import (
    RibLubricant,
    permissible_axial_load_nsk,
    permissible_axial_load_skf,
)
from rolamento.records import frozen
from rolamento.solved import Solved
from rolamento.validate import finite


@frozen(eq=False)
class RibLoad:
    """Axial load of the ribs, and how much the makers' rules permit; arrays (cases,), N.

    Attributes
    ----------
    axial
        |F_x|
    nsk, skf
        permissible continuous load by either maker's rule; NaN where it has none
    lubricant
        that they were found for; grease, the more careful, where the case has none
    """

    axial: FloatArray
    nsk: FloatArray
    skf: FloatArray
    lubricant: RibLubricant

    @classmethod
    def of(cls, solved: Solved, static_rating: FloatArray, speed: FloatArray) -> RibLoad | None:
        """Find it for a single row of cylindrical rollers of which the boundary is known.

        Parameters
        ----------
        solved
            Of `rolamento.solve`.
        static_rating
            C_0, (cases,); N.
        speed
            Of the rings against each other, (cases,); rad/s.
        """
        bearing = solved.case.bearing
        published = bearing.published
        ribbed = "none" not in (
            getattr(bearing, "inner_ribs", "none"), getattr(bearing, "outer_ribs", "none")
        )  # fmt: skip
        if not bearing.bearing_type.ribbed or len(solved.rows) > 1 or not ribbed:
            return None
        if published is None or published.width is None:
            return None
        resolved = bearing.resolved
        series = str(getattr(getattr(resolved, "designation", None), "series", "") or "")
        lubricant = _lubricant(solved.case)
        load = solved.load
        return cls(
            axial=np.abs(load.fx),
            nsk=permissible_axial_load_nsk(
                published.bore, speed, int(series[-1]) if series[-1:].isdecimal() else 0, lubricant
            ),
            skf=permissible_axial_load_skf(
                published.bore,
                published.outside_diameter,
                published.width,
                static_rating,
                np.hypot(load.fy, load.fz),
                speed,
                lubricant,
                series_2=series == "2",
            ),
            lubricant=lubricant,
        )

    @property
    def permissible(self) -> FloatArray:
        """The lesser of both, (cases,); N."""
        return np.fmin(self.nsk, self.skf)

    @property
    def exceeded(self) -> BoolArray:
        """Whether the axial load is above it, (cases,)."""
        return np.asarray(self.axial > self.permissible)

    def to_mapping(self, case: int = 0) -> dict[str, Any]:
        """Give one case as plain values; NaN as None."""
        return {
            "axial": finite(self.axial[case]),
            "permissible": finite(self.permissible[case]),
            "nsk": finite(self.nsk[case]),
            "skf": finite(self.skf[case]),
            "lubricant": self.lubricant,
        }


def _lubricant(case: Case) -> RibLubricant:
    return "oil" if case.lubricant is not None and case.lubricant.kind == "oil" else "grease"
