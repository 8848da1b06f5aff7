"""Lives of bearings that all have to survive: a shaft's, or a machine's.

Their reliabilities multiply; each fails by a Weibull law of its own slope. Lundberg and Palmgren
(1947); Harris (1991), chapter 18.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from rolamento.life.headline import Headline
from rolamento.life.iso16281 import SLOPE
from rolamento.life.record import Life, slope_of
from rolamento.life.spectrum import shaft_life
from rolamento.numerics import FloatArray
from rolamento.records import frozen

__all__ = ["SystemLife"]


@frozen(eq=False)
class SystemLife:
    """Life of several bearings that all have to survive, for the reliability of each; h.

    Attributes
    ----------
    theories
        of the bearings; empty without a result
    bearing_hours
        (bearings,); NaN without a result or rotation
    hours
        of all together
    risk
        (bearings,): share of each in what ends the life; that of an endless one is zero
    valid
        whether all of these lives are valid
    below
        whether the life of all together is a bound: that of some bearing is
    """

    theories: tuple[str, ...]
    bearing_hours: FloatArray
    hours: float
    risk: FloatArray
    valid: bool
    below: bool

    @classmethod
    def of(cls, lives: Sequence[Life | Headline | None]) -> SystemLife:
        """Put together the lives of bearings, each of one case."""
        hours = np.array([np.nan if own is None else own.hours[0] for own in lives])
        valid = all(own is not None and bool(own.valid[0]) for own in lives)
        leads = all(own is not None and bool(own.valid[0] | own.below[0]) for own in lives)
        return cls.combined(
            ["" if own is None else str(np.ravel(own.theory)[0]) for own in lives],
            hours,
            np.array([SLOPE if own is None else slope_of(own.element) for own in lives]),
            valid=valid,
            below=leads and any(own is not None and bool(own.below[0]) for own in lives),
        )

    @classmethod
    def combined(
        cls,
        theories: Sequence[str],
        hours: FloatArray,
        slopes: FloatArray,
        *,
        valid: bool,
        below: bool,
    ) -> SystemLife:
        """Put together lives of bearings in hours, each with the slope of its Weibull law."""
        with np.errstate(divide="ignore", invalid="ignore"):
            together = float(shaft_life(hours, slope=slopes))
            risk = ((together if np.isfinite(together) else np.min(hours)) / hours) ** slopes
        return cls(
            theories=tuple(theories),
            bearing_hours=hours,
            hours=together,
            risk=np.asarray(risk / risk.sum()),
            valid=valid,
            below=below,
        )

    def to_mapping(self) -> dict[str, Any]:
        """Give hours and shares as plain values; an endless life as None beside "unlimited"."""
        return {
            "hours": self.hours,
            "unlimited": bool(np.isposinf(self.hours)),
            "valid": self.valid,
            "risk": self.risk,
        }
