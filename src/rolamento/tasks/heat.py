"""What the heat of a bearing is asked for beyond its balance: answers, and how to run it up."""

from __future__ import annotations

from functools import lru_cache
from math import inf, isfinite, nan
from typing import Any, Final

import numpy as np

from rolamento.analysis.speed_limits import speed_limits
from rolamento.case import Case, case_of
from rolamento.case.heat import HeatStep
from rolamento.errors import InputError
from rolamento.heat import HeatBalance, HeatTransient, heat_balance, heat_transient
from rolamento.heat.answers import (
    HeatVariant,
    NeutralDistance,
    highest_speed,
    neutral_distance,
    oil_needed,
    variants_of,
)
from rolamento.heat.balance import CaseLike
from rolamento.heat.transient import until_steady
from rolamento.io.json import dumps, plain
from rolamento.records import frozen
from rolamento.units import readable, to_si
from rolamento.words import said

__all__ = ["HeatAnswers", "WarmUp", "balance_of", "heat_answers", "limit_of_text", "warm_up"]

_REMEMBERED: Final = 16

_LEVELS: Final = 4
"""Speeds of a plan: equal shares of that of the case."""
_TRIES: Final = 4
"""Times that a step is halved to find how long it has to last."""
_SHORTEST: Final = 60.0
"""s: below that a step is left out."""


@lru_cache(maxsize=_REMEMBERED)
def balance_of(case: Case) -> HeatBalance | None:
    """Return the heat balance of a case, without looking for a speed; None where it has none.

    Remembered, for those who show the same case again.

    Parameters
    ----------
    case
        Without an oil, a coefficient of friction, or sizes for the estimates it has none.
    """
    try:
        return heat_balance(case, look_for_speed=False)
    except InputError:
        return None


@frozen(eq=False, slots=False)
class HeatAnswers:
    """What a heat balance is asked for.

    Attributes
    ----------
    variants
        the case as it is given, and with the other preload and the other elements
    neutral
        how the preload depends on the distance of the rows; None where it does not
    speed_factor
        multiple of the speeds up to which there is a state; infinite, or NaN, as `highest_speed`
    merges
        whether two states merge there
    permissible_speed
        by DIN 732-2, rad/s; NaN where the bearing has none
    most
        temperature that an oil flow was looked for, K; None if none was
    oil_flow
        that keeps all parts below it, m³/s; NaN if none was looked for
    """

    variants: tuple[HeatVariant, ...]
    neutral: NeutralDistance | None
    speed_factor: float
    merges: bool
    permissible_speed: float
    most: float | None
    oil_flow: float

    @property
    def balance(self) -> HeatBalance:
        """The balance of the case as it is given."""
        return self.variants[0].balance

    @property
    def speed(self) -> float:
        """Speed of the rings against each other up to which there is a state, rad/s."""
        duty = self.balance.case.duty
        return self.speed_factor * abs(duty.inner_speed - duty.outer_speed)

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists, SI."""
        return {
            "title": self.balance.case.title,
            "variants": [{"name": one.name, **one.balance.to_mapping()} for one in self.variants],
            "neutral_distance": None if self.neutral is None else self.neutral.to_mapping(),
            "highest_speed": {
                "factor": plain(self.speed_factor),
                "speed": plain(self.speed),
                "merges": self.merges,
                "permissible_speed": plain(self.permissible_speed),
            },
            "oil": None
            if self.most is None
            else {"limit": self.most, "flow": plain(self.oil_flow)},
        }

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give it as one JSON object, in SI units."""
        return dumps(self.to_mapping(), indent)


def heat_answers(case: CaseLike, most: float | None = None) -> HeatAnswers:
    """Answer what a heat balance is asked for.

    Parameters
    ----------
    case
        As of `rolamento.heat.heat_balance`.
    most
        Temperature (K) that no part is to pass: the oil flow is looked for that does it.

    Raises
    ------
    InputError
        As `heat_balance` and `rolamento.heat.answers.oil_needed`.
    """
    case = case_of(case)
    variants = variants_of(case)
    found = variants[0].balance
    factor, merges = highest_speed(found)
    return HeatAnswers(
        variants, neutral_distance(found), factor, merges, _permissible(case, found), most,
        nan if most is None else oil_needed(case, most),
    )  # fmt: skip


def _permissible(case: Case, found: HeatBalance) -> float:
    """The permissible speed of DIN 732-2 with the oil as warm as in the balance; NaN without."""
    state = found.cold if found.warm is None else found.warm
    try:
        limits = speed_limits(state.case).limits
    except InputError:  # different elements in its rows
        return nan
    return next((one.speed for one in limits if one.name == "permissible"), nan)


# --- running up -----------------------------------------------------------------------------------


@frozen(eq=False, slots=False)
class WarmUp:
    """A plan of speeds that keeps a bearing below a limit while it gets warm.

    Attributes
    ----------
    at_once
        what happens without a plan: full speed from the start
    preload, temperature
        the limit, N or K; None of the one that is not limited
    transient
        what happens with the plan; None where no plan does it
    """

    at_once: HeatTransient
    preload: float | None
    temperature: float | None
    transient: HeatTransient | None

    @property
    def steps(self) -> tuple[HeatStep, ...]:
        """The plan; empty where there is none."""
        return () if self.transient is None else self.transient.steps

    @property
    def needed(self) -> bool:
        """Whether full speed from the start breaks the limit."""
        return not _keeps(self.at_once, self.preload, self.temperature)

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists, SI."""
        return {
            "limit": {"preload": self.preload, "temperature": self.temperature},
            "needed": self.needed,
            "at_once": self.at_once.to_mapping(),
            "plan": None if self.transient is None else self.transient.to_mapping(),
        }


def limit_of_text(text: str) -> dict[str, float]:
    """Return a limit of a plan by what it limits, such as ``"1500 N"`` or ``"60 degC"``; SI.

    Raises
    ------
    InputError
        If it is neither a force nor a temperature.

    >>> limit_of_text("2 kN")
    {'preload': 2000.0}
    """
    for name, dimension in (("preload", "force"), ("temperature", "temperature")):
        try:
            return {name: to_si(text, dimension)}  # type: ignore[arg-type]
        except InputError:
            continue
    raise InputError(said("must be a preload or a temperature"), value=text, example="1500 N")


def warm_up(
    case: CaseLike, *, preload: float | None = None, temperature: float | None = None
) -> WarmUp:
    """Plan steps of speed that keep the preload or the temperatures of a bearing below a limit.

    A quarter of the speed, a half, three quarters: each lasts until the next one stays below the
    limit when it begins then, found by halving; what can be left out is. Temperatures in time are
    those of `rolamento.heat.heat_transient`.

    Parameters
    ----------
    case
        As of `heat_balance`.
    preload, temperature
        The limit, in N or K; one of them.

    Returns
    -------
    WarmUp
        Without a plan where the steady state itself is beyond the limit, or none was found.

    Raises
    ------
    InputError
        As `heat_balance`; or if not one of the limits is given, or the bearing has no preload.
    """
    case = case_of(case)
    if (preload is None) == (temperature is None):
        raise InputError(
            said("give one of them: preload or temperature"), field="preload", example="1500.0"
        )
    whole = until_steady(case)
    at_once = heat_transient(case, whole)
    if preload is not None and not at_once.has_preload and at_once.converged:
        raise InputError(
            said("is of a set with a preload; this bearing has none"),
            field="preload",
            value=readable(preload, "force"),
        )
    plan: HeatTransient | None = at_once
    if not _keeps(at_once, preload, temperature):
        plan = _planned(case, whole, preload, temperature)
    return WarmUp(at_once, preload, temperature, plan)


def _planned(
    case: Case, whole: float, preload: float | None, temperature: float | None
) -> HeatTransient | None:
    steps: list[HeatStep] = []

    def run(more: list[HeatStep]) -> HeatTransient:
        return heat_transient(case, steps=[*steps, *more])

    def step(level: int, duration: float) -> HeatStep:
        return HeatStep(duration=duration, speed_factor=level / _LEVELS)

    for level in range(1, _LEVELS):
        later = step(level + 1, whole)
        if _keeps(run([later]), preload, temperature):
            continue
        if not _keeps(run([step(level, whole)]), preload, temperature):
            return None
        if not _keeps(run([step(level, whole), later]), preload, temperature):
            return None
        short, long = 0.0, whole
        for _ in range(_TRIES):
            middle = 0.25 * whole if long == whole and short == 0.0 else 0.5 * (short + long)
            kept = _keeps(run([step(level, middle), later]), preload, temperature)
            short, long = (short, middle) if kept else (middle, long)
        if long > _SHORTEST:
            steps.append(step(level, 60.0 * float(np.ceil(long / 60.0))))
    found = run([step(_LEVELS, whole)])
    return found if _keeps(found, preload, temperature) else None


def _keeps(found: HeatTransient, preload: float | None, temperature: float | None) -> bool:
    """Whether a course stays below the limit to its end."""
    if not found.converged:
        return False
    if preload is not None:
        largest = found.largest_preload[0]
        return isfinite(largest) and largest <= preload
    return float(found.temperatures.max()) <= (inf if temperature is None else temperature)
