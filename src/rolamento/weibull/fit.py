"""What all fits say: a Weibull distribution with a status, and what may be estimated of one.

    R(t) = exp(-((t - γ)/η)^β),    t_R = γ + η (-ln R)^(1/β)

η is the time, after γ, that 63.2 % of the bearings do not reach; it is not the mean.
"""

from __future__ import annotations

import re
from dataclasses import replace
from math import exp, gamma, isfinite
from typing import Any, Final, Literal, Self

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import finite, number, numbers, share, shares
from rolamento.weibull.life_test import MAXIMUM_TIME, LifeTest
from rolamento.words import Note, said


class Outcome:
    """What a result says of itself: whether there is one, what to do if not, and its notes.

    Attributes
    ----------
    code
        "converged", or why there is no result
    notes
        what limits the result, each once
    """

    __slots__ = ()
    code: str
    notes: tuple[Note, ...]

    @property
    def converged(self) -> bool:
        """Whether there is a result."""
        return self.code == "converged"

    @property
    def advice(self) -> Note | None:
        """What a person can do, where there is no result."""
        return advice_on(self.code)

    def status(self) -> dict[str, Any]:
        """Give the status as plain values."""
        return {
            "code": self.code,
            "converged": self.converged,
            "advice": None if self.advice is None else self.advice.to_mapping(),
        }


def advice_on(code: str) -> Note | None:
    """Return what a person can do, by the code of a status; nothing where there is a result."""
    return None if code == "converged" else Note(f"weibull_{code}")


@frozen(eq=False)
class WeibullFit(Outcome):
    """A Weibull distribution fitted to a life test; NaN where there is none.

    Attributes
    ----------
    method
        "maximum_likelihood", "three_parameter", "rank_regression_y_on_x",
        "rank_regression_x_on_y", "fixed_shape", "unbiased"
    code
        "converged", or why there is no result, a key of `ADVICE`
    shape, scale, location
        β, η, γ; scale and location in the unit of the test
    log_likelihood
        of the data, at the fit; NaN where it was not what was sought
    failures, size
        how many bearings failed, of how many tested
    unit
        label of times
    correlation
        of the points on the Weibull plot, for rank regression; NaN otherwise
    notes
        names in `NOTES`
    """

    method: str
    code: str
    shape: float = np.nan
    scale: float = np.nan
    location: float = 0.0
    log_likelihood: float = np.nan
    failures: int = 0
    size: int = 0
    unit: str = "h"
    correlation: float = np.nan
    notes: tuple[Note, ...] = ()

    @classmethod
    def without(cls, test: LifeTest, method: str, code: str) -> Self:
        """Say that a test has no fit, and why."""
        return cls(
            method, code, location=np.nan, failures=test.failures, size=test.size, unit=test.unit
        )

    @property
    def l10(self) -> float:
        """Life that 90 % reach; unit of the test."""
        return float(self.life_at(0.9))

    @property
    def l50(self) -> float:
        """Life that half of the bearings reach: the median."""
        return float(self.life_at(0.5))

    @property
    def mean(self) -> float:
        """Mean life; infinite where it is beyond any number."""
        if not isfinite(self.shape):
            return np.nan
        try:
            return self.location + self.scale * gamma(1.0 + 1.0 / self.shape)
        except OverflowError:
            return np.inf

    def life_at(self, reliability: ArrayLike) -> FloatArray:
        """Life that a share of the bearings reach.

        Parameters
        ----------
        reliability : array, between 0 and 1; 0.9 for L10.
        """
        risk = -np.log(shares(reliability, "reliability"))
        with np.errstate(over="ignore"):
            return np.asarray(self.location + self.scale * risk ** (1.0 / self.shape))

    def reliability_at(self, time: ArrayLike) -> FloatArray:
        """Share of the bearings that reach a time; 1 up to the location."""
        t = numbers(time, "time", "[100.0, 200.0]") - self.location
        with np.errstate(over="ignore"):
            alive = np.exp(-((np.maximum(t, 0.0) / self.scale) ** self.shape))
        return np.where(np.isnan(t), np.nan, alive)

    def life_at_ordinate(self, ordinate: FloatArray) -> FloatArray:
        """Times of the fitted line at ordinates of the Weibull plot, see `plot_ordinate`."""
        with np.errstate(over="ignore"):
            return np.asarray(self.location + self.scale * np.exp(ordinate / self.shape))

    def with_notes(self, *notes: Note) -> Self:
        """Return the same fit with more notes."""
        return replace(self, notes=tuple(dict.fromkeys((*self.notes, *notes))))

    def to_mapping(self) -> dict[str, Any]:
        """Give the fit as plain values; None where there is no number."""
        numbers = ("shape", "scale", "location", "log_likelihood", "correlation")
        found = {name: finite(getattr(self, name)) for name in numbers}
        return {
            "method": self.method,
            "status": self.status(),
            **found,
            "l10": finite(self.l10),
            "l50": finite(self.l50),
            "mean": finite(self.mean),
            "failures": self.failures,
            "size": self.size,
            "unit": self.unit,
            "notes": [note.to_mapping() for note in self.notes],
        }


_WRITTEN: Final = re.compile(r"([LlRr])([0-9]{1,20}(?:\.[0-9]{1,20})?(?:[eE][+-]?[0-9]{1,2})?)")


@frozen
class Estimand:
    """What is estimated of a Weibull distribution: shape, scale, a life, the reliability at a time.

    Written as a word: "shape", "scale", "L10" (the life that 90 % reach), "L50", "L0.1", and "R100"
    (the reliability at time 100, in the unit of the test).

    Attributes
    ----------
    kind
        "shape", "life" or "reliability"
    value
        the reliability that the life is for; or the time that the reliability is for, in the unit
        of the test; NaN for the shape
    name
        as it is written
    """

    kind: Literal["shape", "life", "reliability"]
    value: float
    name: str

    @classmethod
    def of(cls, written: str | Estimand) -> Self | Estimand:
        """Read what is to be estimated.

        Raises
        ------
        InputError
            If it is none.
        """
        if isinstance(written, Estimand):
            return written
        word = str(written).strip()
        if word in ("shape", "scale"):
            return cls("shape", np.nan, word) if word == "shape" else cls("life", exp(-1.0), word)
        match = _WRITTEN.fullmatch(word)
        number = float(match[2]) if match else np.nan
        if match and match[1] in "Ll" and 0.0 < number < 100.0:
            return cls.life(1.0 - number / 100.0)
        if match and match[1] in "Rr" and 0.0 < number <= MAXIMUM_TIME:
            return cls.reliability(number)
        raise InputError(
            said(
                "must be shape, scale, a life such as L10 (10 % failed), or a "
                "reliability at a time such as R100"
            ),
            field="quantity",
            value=written,
            example="L10",
        )

    @classmethod
    def life(cls, reliability: float) -> Self:
        """Life that a share of the bearings reach."""
        r = share(reliability, "reliability")
        return cls("life", r, f"L{100.0 * (1.0 - r):.6g}")

    @classmethod
    def reliability(cls, time: float) -> Self:
        """Share of the bearings that reach a time."""
        t = number(time, "time", above=0.0, example="100.0")
        return cls("reliability", t, f"R{t:.12g}")

    @property
    def log_risk(self) -> float:
        """Logarithm of the risk of a life: ln(-ln R), the ordinate of the Weibull plot."""
        return float(np.log(-np.log(self.value)))

    @property
    def level(self) -> float:
        """What it is for: ln(-ln R) of a life, ln t of a reliability, 0 of the shape."""
        if self.kind == "shape":
            return 0.0
        return self.log_risk if self.kind == "life" else float(np.log(self.value))

    @property
    def ends(self) -> tuple[float, float]:
        """Minimum and maximum that it can be."""
        return (0.0, 1.0) if self.kind == "reliability" else (0.0, np.inf)

    def at(self, shape: FloatArray, log_scale: FloatArray) -> FloatArray:
        """Value for distributions given by shape and logarithm of the scale; arrays of one shape.

        NaN where the distribution has none.
        """
        if self.kind == "shape":
            return shape
        with np.errstate(over="ignore", invalid="ignore"):
            if self.kind == "life":
                return np.asarray(np.exp(log_scale + self.log_risk / shape))
            return np.asarray(np.exp(-np.exp(shape * (np.log(self.value) - log_scale))))


def plot_ordinate(failed_share: ArrayLike) -> FloatArray:
    """Ordinate ln ln 1/(1 - F) of the Weibull plot, F being the share that has failed.

    >>> print(f"{plot_ordinate(1.0 - np.exp(-1.0)):.3f}")
    0.000
    """
    share_ = numbers(failed_share, "failed_share", "[0.1, 0.5]")
    with np.errstate(divide="ignore"):
        return np.asarray(np.log(-np.log1p(-share_)))
