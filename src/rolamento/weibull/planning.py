"""Planning a demonstration: how many bearings, and how long, so that few failures prove a life.

n bearings run to the time T. If at most k of them fail, the life t_R for the reliability R is shown
with the confidence C, at a shape β from experience:

    F = 1 - R^((T/t_R)^β),    Σ_{i ≤ k} C(n, i) F^i (1 - F)^(n-i) = 1 - C.

Without failures (k = 0, "success run") this is n (T/t_R)^β (-ln R) = -ln(1 - C): any bearings and
times with the same n T^β show as much. Bearings of exactly the required life pass such a test
once in 1/(1 - C) times: they have to be better to have a fair chance. All of it is as good as the
shape is, but for T = t_R, where the shape does not matter.

Sources: Nelson (1985); Abernethy (2006), chapter 6; Lipson and Sheth (1973) for k > 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from math import isfinite
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import finite, number, numbers, share, whole_number
from rolamento.weibull.life_test import MAXIMUM_TIME
from rolamento.weibull.limits import MAXIMUM_SHAPE, shape_of
from rolamento.words import Note, said

MAXIMUM_ALLOWED: Final = 1000
MAXIMUM_BEARINGS: Final = 100_000
MINIMUM_SHAPE: Final = 0.1
_POINTS: Final = 2001


def advice_on_plan(code: str) -> Note | None:
    """Return what a person can do, by the code of a plan; nothing where there is one."""
    return None if code == "planned" else Note(f"plan_{code}")


def status_of_plan(code: str) -> dict[str, Any]:
    """Give the status of a plan as plain values."""
    advice = advice_on_plan(code)
    return {
        "code": code,
        "planned": code == "planned",
        "advice": None if advice is None else advice.to_mapping(),
    }


@frozen
class Demonstration:
    """A test that shows a life if few enough fail; NaN for what does not exist.

    Attributes
    ----------
    code
        "planned", or why there is none, a code that `advice` explains
    life, reliability, confidence
        what is to be shown: the life, the share of bearings that reach it, how surely
    shape
        β, from experience
    failures_allowed
        k
    bearings
        n; 0 if none are enough
    time
        T, for each bearing; in the unit of the life
    shown
        confidence with which the life is shown if the test is passed; at least that wanted, since
        bearings are whole
    """

    code: str
    life: float
    reliability: float
    confidence: float
    shape: float
    failures_allowed: int
    bearings: int
    time: float
    shown: float

    @property
    def planned(self) -> bool:
        """Whether the test shows the life."""
        return self.code == "planned"

    @property
    def advice(self) -> Note | None:
        """What a person can do, where it does not."""
        return advice_on_plan(self.code)

    @property
    def total_time(self) -> float:
        """Sum of the times of all bearings, if none fails."""
        return self.bearings * self.time

    def chance_of_passing(self, life_ratio: ArrayLike) -> FloatArray:
        """Probability that the bearings pass.

        Parameters
        ----------
        life_ratio : array
            Their true life over the one to be shown; 1 for bearings that are just as wanted.
        """
        ratio = numbers(life_ratio, "life_ratio", "[1.0, 2.0, 5.0]")
        with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
            risk = self._risk() * np.maximum(ratio, 0.0) ** -self.shape
        failed = np.where(ratio >= 0.0, -np.expm1(-risk), np.nan)
        return _chance_of_at_most(self.failures_allowed, self.bearings, failed)

    def life_ratio_for(self, chance: float) -> float:
        """Life over the one to be shown that bearings need in order to pass with a probability."""
        p = share(chance, "chance")
        failed = _failed_share(self.failures_allowed, self.bearings, p)
        return float((self._risk() / -np.log1p(-failed)) ** (1.0 / self.shape))

    def confidence_at(self, shape: ArrayLike) -> FloatArray:
        """Confidence that the same test gives if the shape is another: array."""
        beta = numbers(shape, "shape", "[1.0, 1.5]")
        if not np.all((beta > 0.0) & np.isfinite(beta)):
            raise InputError(said("must be positive"), field="shape", example="1.5")
        with np.errstate(over="ignore"):
            risk = (self.time / self.life) ** beta * -np.log(self.reliability)
        return 1.0 - _chance_of_at_most(self.failures_allowed, self.bearings, -np.expm1(-risk))

    def expected_time(self, life_ratio: float = 1.0) -> float:
        """Mean time until the test ends: at T, or at the failure that is one too many.

        All bearings run at once.

        Parameters
        ----------
        life_ratio
            True life over the one to be shown.
        """
        ratio = number(life_ratio, "life_ratio", above=0.0, example="2.0")
        if not isfinite(self.time) or not self.bearings:
            return float("nan")
        t = np.linspace(0.0, 1.0, _POINTS)
        risk = self._risk() * (t / ratio) ** self.shape
        running = _chance_of_at_most(self.failures_allowed, self.bearings, -np.expm1(-risk))
        inner = float(np.sum(running[1:-1])) + 0.5 * float(running[0] + running[-1])
        return self.time * inner / (_POINTS - 1)

    def to_mapping(self) -> dict[str, Any]:
        """Give the plan as plain values; None where there is no number."""
        values = {name: value for name, value in asdict(self).items() if name != "code"}
        values["total_time"] = self.total_time
        plain = {
            name: finite(value) if isinstance(value, float) else value
            for name, value in values.items()
        }
        return {
            "status": status_of_plan(self.code),
            **plain,
        }

    def _risk(self) -> float:
        """Cumulated risk of one bearing over the test, were its life the one to be shown."""
        ratio = np.float64(self.time / self.life)
        with np.errstate(over="ignore"):
            return float(ratio**self.shape * -np.log(self.reliability))


def demonstrate(
    life: float,
    *,
    shape: float,
    bearings: int | None = None,
    time: float | None = None,
    reliability: float = 0.9,
    confidence: float = 0.9,
    failures_allowed: int = 0,
) -> Demonstration:
    """Plan a test that shows a life.

    Parameters
    ----------
    life
        To be shown; any unit.
    shape
        β, from experience with such bearings.
    bearings
        How many there are: the time is found. Up to 100 000.
    time
        For which each is to run, in the unit of the life: how many it takes is found. With both,
        the confidence is found.
    reliability
        Of the life: 0.9 for L10.
    confidence
        With which it is to be shown.
    failures_allowed
        How many may fail.

    Raises
    ------
    InputError
        Without bearings and time, or for a number out of range.

    >>> print(f"{demonstrate(1000.0, shape=1.5, bearings=22).time:.0f} h")
    996 h
    """
    wanted = number(life, "life", above=0.0, example="1000.0")
    given = (
        wanted, share(reliability, "reliability"), share(confidence, "confidence"),
        planned_shape(shape),
        whole_number(failures_allowed, "failures_allowed", 0, MAXIMUM_ALLOWED),
    )  # fmt: skip
    if bearings is None and time is None:
        raise InputError(said("or time must be given"), field="bearings", example="10")
    if bearings is not None:
        whole_number(bearings, "bearings", given[4] + 1, MAXIMUM_BEARINGS)
    if time is not None:
        number(time, "time", above=0.0, example="500.0")
    if bearings is None:
        assert time is not None
        return _bearings_for(*given, time)
    if time is None:
        return _time_for(*given, bearings)
    return _confidence_of(*given, bearings, time)


def alternatives(
    plan: Demonstration,
    bearings: Sequence[int] = (1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30),
    failures_allowed: Sequence[int] = (0, 1, 2),
) -> tuple[Demonstration, ...]:
    """Plan tests that show the same life as surely with other numbers of bearings and failures.

    Parameters
    ----------
    plan
        What is to be shown.
    bearings, failures_allowed
        Of the tests; those with no more bearings than failures allowed are left out.
    """
    return tuple(
        demonstrate(
            plan.life,
            shape=plan.shape,
            bearings=count,
            reliability=plan.reliability,
            confidence=plan.confidence,
            failures_allowed=allowed,
        )
        for count in bearings
        for allowed in failures_allowed
        if count > allowed
    )


def _time_for(
    life: float, reliability: float, confidence: float, shape: float, allowed: int, bearings: int
) -> Demonstration:
    """Find the time."""
    failed = _failed_share(allowed, bearings, 1.0 - confidence)
    with np.errstate(over="ignore"):
        ratio = (np.log1p(-failed) / np.log(reliability)) ** (1.0 / shape)
    time = float(life * ratio)
    given = (life, reliability, confidence, shape, allowed, bearings)
    if not 0.0 < time <= MAXIMUM_TIME:
        return Demonstration("too_long", *given, float("nan"), float("nan"))
    return Demonstration("planned", *given, time, confidence)


def _bearings_for(
    life: float, reliability: float, confidence: float, shape: float, allowed: int, time: float
) -> Demonstration:
    """Find the least number of bearings."""
    given = (life, reliability, confidence, shape, allowed)

    def shows(bearings: int) -> bool:
        return _confidence_of(*given, bearings, time).planned

    low, high = allowed, allowed + 1  # of the lower one it is known that it does not
    while not shows(high):
        if high == MAXIMUM_BEARINGS:
            nan = float("nan")
            return Demonstration("too_many_bearings", *given, 0, float(time), nan)
        low, high = high, min(2 * high, MAXIMUM_BEARINGS)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if shows(middle) else (middle, high)
    return _confidence_of(*given, high, time)


def _confidence_of(
    life: float,
    reliability: float,
    confidence: float,
    shape: float,
    allowed: int,
    bearings: int,
    time: float,
) -> Demonstration:
    """Find the confidence."""
    trial = Demonstration(
        "planned", life, reliability, confidence, shape, allowed, bearings, float(time), 0.0
    )
    shown = float(trial.confidence_at(shape))
    # a plan that this module made shows what it was made for, but for rounding
    code = "planned" if shown >= confidence - 1e-9 else "not_shown"
    return Demonstration(
        code, life, reliability, confidence, shape, allowed, bearings, float(time), shown
    )


def _chance_of_at_most(allowed: int, bearings: int, failed: FloatArray) -> FloatArray:
    """Probability that at most so many fail, each with a probability."""
    from scipy.special import bdtr

    if not bearings:
        return np.full(np.shape(failed), np.nan)
    return np.asarray(bdtr(float(allowed), bearings, failed))


def _failed_share(allowed: int, bearings: int, chance: float) -> float:
    """Share that fails of a population of which so many pass with a probability."""
    from scipy.special import betaincinv

    return float(betaincinv(allowed + 1.0, bearings - allowed, 1.0 - chance))


def planned_shape(value: object) -> float:
    """Return a shape that plans can be made with."""
    shape = shape_of(value)
    if shape < MINIMUM_SHAPE:
        raise InputError(
            said(
                "must be from {least:.6g} to {most:.6g}",
                least=MINIMUM_SHAPE,
                most=MAXIMUM_SHAPE,
            ),
            field="shape",
            value=value,
            example="1.5",
        )
    return shape
