"""How the clearance grows as a bearing wears: functions fitted to what was measured.

The wear of a bearing cannot be predicted; a clearance measured again and again during a test
can be described by

    running_in             P_d = P_0 + A (1 - e^(-t/τ))
    running_in_and_steady  P_d = P_0 + A (1 - e^(-t/τ)) + w t
    power                  P_d = P_0 + A (t/t_last)^n,  0 < n ≤ 1

with constants from least squares. The first two are what Campanha (2008, figure 4.3.3) describes:
much at first, little afterwards. Beyond the last measurement a function is not valid: NaN, unless
asked for.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import one_of
from rolamento.words import said

WearLaw = Literal["running_in", "running_in_and_steady", "power"]
_LAWS: Final[tuple[WearLaw, ...]] = get_args(WearLaw)
_NAMES: Final[dict[WearLaw, tuple[str, ...]]] = {
    "running_in": ("initial_clearance", "running_in_wear", "running_in_time"),
    "running_in_and_steady": (
        "initial_clearance",
        "running_in_wear",
        "running_in_time",
        "wear_rate",
    ),
    "power": ("initial_clearance", "wear_at_last", "exponent"),
}
_MOST_POINTS: Final = 100_000
_STEPS: Final = 2000


@frozen(eq=False)
class WearFit:
    """A law of wear with the constants that fit a record of measurements.

    Attributes
    ----------
    law
        which
    constants
        by name, SI: initial_clearance P_0, running_in_wear A, wear_at_last A (m), running_in_time
        τ (s), wear_rate w (m/s), exponent n
    standard_errors
        of the constants, from the curvature at the best fit; NaN where there are no more points
        than constants, or a constant lies on its bound
    residual
        standard deviation of the points from the curve, with the degrees of freedom that remain;
        m, NaN if none remain
    last_time
        of the measurements; s
    """

    law: WearLaw
    constants: dict[str, float]
    standard_errors: dict[str, float]
    residual: float
    last_time: float

    def clearance(self, time: ArrayLike, *, beyond: bool = False) -> FloatArray:
        """Clearance after a running time; m.

        Parameters
        ----------
        time
            In s; array.
        beyond
            Whether to go on after the last measurement; NaN there by default, and before 0.
        """
        t = np.asarray(time, dtype=np.float64)
        known = (t >= 0.0) & (beyond | (t <= self.last_time))
        law = _FUNCTIONS[self.law]
        values = np.array(list(self.constants.values()))
        safe = np.where(known, t, 0.0)
        return np.where(known, law(safe / self.last_time, self._scaled(values)), np.nan)

    def growth(self, time: ArrayLike, *, beyond: bool = False) -> FloatArray:
        """Wear alone: what the clearance has grown by since the start; m."""
        return self.clearance(time, beyond=beyond) - self.constants["initial_clearance"]

    def _scaled(self, values: FloatArray) -> FloatArray:
        return values / _scales(self.law, 1.0, self.last_time)


def fit_wear(time: ArrayLike, clearance: ArrayLike, law: WearLaw = "running_in") -> WearFit:
    """Fit a law of wear to measured clearances by least squares.

    Parameters
    ----------
    time
        Running time of each measurement, in s; from 0 on, of one bearing or of several alike.
    clearance
        Measured then, in m, all in one way: without the measuring load, or all with it.
    law
        See the module.

    Raises
    ------
    InputError
        If there are too few measurements for the law, or some are not usable numbers.
    """
    t, c = _checked(time, clearance, law)
    from scipy.optimize import least_squares

    last, spread = float(t.max()), float(np.ptp(c))
    size = spread if spread > 0.0 else max(float(np.abs(c).max()), 1e-9)
    function, x = _FUNCTIONS[law], t / last
    best = min(
        (
            least_squares(
                lambda p: function(x, p) - c / size,
                start,
                bounds=_bounds(law),
                xtol=1e-13,
                ftol=1e-13,
                gtol=1e-13,
                max_nfev=_STEPS,
            )
            for start in _starts(law, float(c.min()) / size, spread / size)
        ),
        key=lambda found: float(found.cost),
    )
    scales = _scales(law, size, last)
    freedom = len(t) - len(best.x)
    variance = 2.0 * float(best.cost) / freedom if freedom > 0 else np.nan
    errors = _standard_errors(best.jac, variance, best.active_mask)
    return WearFit(
        law=law,
        constants=dict(zip(_NAMES[law], map(float, best.x * scales), strict=True)),
        standard_errors=dict(zip(_NAMES[law], map(float, errors * scales), strict=True)),
        residual=float(np.sqrt(variance)) * size,
        last_time=last,
    )


# Laws of x = t/t_last with constants in units of the spread of the clearances.


def _running_in(x: FloatArray, p: FloatArray) -> FloatArray:
    return np.asarray(p[0] - p[1] * np.expm1(-x / p[2]))


def _running_in_and_steady(x: FloatArray, p: FloatArray) -> FloatArray:
    return np.asarray(_running_in(x, p) + p[3] * x)


def _power(x: FloatArray, p: FloatArray) -> FloatArray:
    return np.asarray(p[0] + p[1] * x ** p[2])


_FUNCTIONS: Final[dict[WearLaw, Callable[[FloatArray, FloatArray], FloatArray]]] = {
    "running_in": _running_in,
    "running_in_and_steady": _running_in_and_steady,
    "power": _power,
}


def _bounds(law: WearLaw) -> tuple[list[float], list[float]]:
    low, high = [-np.inf, 0.0, 1e-4], [np.inf, np.inf, 1e2]
    if law == "power":
        return [-np.inf, 0.0, 1e-3], [np.inf, np.inf, 1.0]
    extra = law == "running_in_and_steady"
    return low + [0.0] * extra, high + [np.inf] * extra


def _starts(law: WearLaw, minimum: float, spread: float) -> list[list[float]]:
    """Several: the sum of squares may have more than one hollow."""
    if law == "power":
        return [[minimum, max(spread, 1e-3), n] for n in (0.2, 0.5, 0.9)]
    tail = [0.1] if law == "running_in_and_steady" else []
    return [[minimum, max(spread, 1e-3), tau, *tail] for tau in (0.02, 0.1, 0.3, 1.0)]


def _scales(law: WearLaw, size: float, last: float) -> FloatArray:
    third = 1.0 if law == "power" else last
    tail = [size / last] if law == "running_in_and_steady" else []
    return np.array([size, size, third, *tail])


def _standard_errors(jacobian: FloatArray, variance: float, active: FloatArray) -> FloatArray:
    if not np.isfinite(variance) or np.any(active != 0):
        return np.full(jacobian.shape[1], np.nan)
    normal = jacobian.T @ jacobian
    if np.linalg.matrix_rank(normal) < len(normal):
        return np.full(len(normal), np.nan)
    return np.asarray(np.sqrt(variance * np.diag(np.linalg.inv(normal))))


def _checked(time: ArrayLike, clearance: ArrayLike, law: WearLaw) -> tuple[FloatArray, FloatArray]:
    one_of(law, "law", _LAWS, "running_in")
    t, c = (np.asarray(values, dtype=np.float64) for values in (time, clearance))
    if t.ndim != 1 or t.shape != c.shape or len(t) > _MOST_POINTS:
        raise InputError(
            said(
                "must be a list of at most {most} numbers, as long as the times", most=_MOST_POINTS
            ),
            field="clearance",
            example="[27e-6, 36e-6, 41e-6]",
        )
    for field, values, allowed in (("time", t, t >= 0.0), ("clearance", c, np.isfinite(c))):
        bad = ~(np.isfinite(values) & allowed)
        if np.any(bad):
            raise InputError(
                said("must be finite and not negative")
                if field == "time"
                else said("must be finite numbers"),
                field=field,
                value=float(values[bad][0]),
            )
    needed = len(_NAMES[law])
    if len(np.unique(t)) < needed:
        raise InputError(
            said(
                "must have at least {needed} different values for the law {law}",
                needed=needed,
                law=law,
            ),
            field="time",
            value=len(np.unique(t)),
            example="[0, 216e3, 432e3, 648e3]",
        )
    return t, c
