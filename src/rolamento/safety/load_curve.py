"""Static safety over the load: how it falls, and from which load on the rows of a set gap."""

from __future__ import annotations

import numpy as np

from rolamento.case import Case
from rolamento.case.static import Static
from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen, span
from rolamento.safety.static_safety import StaticSafety, static_safety_of
from rolamento.solution import solve
from rolamento.validate import number, whole_number
from rolamento.words import said

__all__ = ["LoadCurve", "static_over_load"]

_MOST_POINTS = 1001


@frozen(eq=False)
class LoadCurve:
    """Static safety at multiples of the design load; NaN where there is no equilibrium.

    Attributes
    ----------
    case
        whose load factor is 1 in these numbers
    factor
        multiples of the design load, rising, (points,)
    design
        load factor of the case: 1 in `factor` is that times the duty's load
    found
        the safeties of all points
    """

    case: Case
    factor: FloatArray
    design: float
    found: StaticSafety

    def _shown(self) -> dict[str, str]:
        return {
            "": self.case.title or "a case without a title",
            "multiples of the design load": span(self.factor),
            "safety by stress": span(self.safety),
            "gap": span(1e6 * self.gap, "um"),
        }

    @property
    def safety(self) -> FloatArray:
        """Safety by stress, the minimum of all contacts; (points,)."""
        return np.where(self.found.solved.converged, self.found.minimum("stress"), np.nan)

    @property
    def gap(self) -> FloatArray:
        """Gap of each row; (points, rows), m."""
        return self.found.launch.gap


def static_over_load(case: Case, *, most: float = 2.0, points: int = 41) -> LoadCurve:
    """Find the static safety over the load of a case, up to a multiple of its design load.

    Parameters
    ----------
    case
        With a load; its preload stays.
    most
        The last multiple.
    points
        From ``most/points`` on, 2 to 1001.

    Raises
    ------
    InputError
        If the case has no load, or a number is out of range.

    >>> from rolamento.case import case_of
    >>> curve = static_over_load(case_of("6310", {"duty.load.fz": "19 kN"}), points=4)
    >>> curve.factor.tolist()
    [0.5, 1.0, 1.5, 2.0]
    >>> bool(np.all(np.diff(curve.safety) < 0.0))
    True
    """
    whole_number(points, "points", 2, _MOST_POINTS, "points = 41")
    number(most, "most", above=0.0, most=1000.0, example="most = 2.0")
    load = case.duty.load
    given = {name: getattr(load, name) for name in ("fx", "fy", "fz", "my", "mz")}
    loads = {name: value for name, value in given.items() if value}
    if not loads:
        raise InputError(
            said("is missing: there is no load to vary"), field="duty.load", example='fz = "10 kN"'
        )
    demands = case.static or Static()
    plain = case.with_({"static.load_factor": 1.0})
    factor = most * np.arange(1, points + 1) / points
    times = demands.load_factor * factor
    values = {f"duty.load.{name}": times * value for name, value in loads.items()}
    return LoadCurve(plain, factor, demands.load_factor, static_safety_of(solve(plain, values)))
