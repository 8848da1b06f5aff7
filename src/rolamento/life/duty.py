"""The life of a bearing under a duty of several steps: damage gathered race by race.

Miner: a step uses up its share of the revolutions over the life that it alone would allow. For the
lives that know the races apart, each race gathers its damage before the races combine, for the
steps may load different races and rows. Palmgren (1924), Miner (1945); Harris (1991), chapter 18.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from rolamento.life.headline import Headline
from rolamento.life.iso281 import hours
from rolamento.life.iso16281 import THEORY as REFERENCE
from rolamento.life.record import Life
from rolamento.life.spectrum import miner_life, races_under_spectrum
from rolamento.life.theories import THEORIES
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen

__all__ = ["DutyLife", "lives_of_duty"]


@frozen(eq=False)
class DutyLife:
    """A life under all steps together.

    Attributes
    ----------
    theory
        that it is by; of the life that leads that of the step that takes most
    life, hours
        millions of revolutions and hours; NaN if a step that takes part has no life
    steps
        if a step were all of the duty: life, hours, whether it is valid; arrays (steps,)
    damage
        (steps,): share of each step in what ends the life
    valid
        whether it is valid in every step that takes part and carries load
    below
        whether the life is a bound: that of some step is
    """

    theory: str
    life: float
    hours: float
    steps: Life | Headline
    damage: FloatArray
    valid: bool
    below: bool

    def to_mapping(self) -> dict[str, Any]:
        """Give the life as plain values; an endless one as None beside "unlimited"."""
        return {
            "life": self.life,
            "hours": self.hours,
            "unlimited": bool(np.isposinf(self.life)),
            "valid": self.valid,
            "upper_bound": self.below,
        }


def lives_of_duty(
    theories: Mapping[str, Life],
    headline: Headline,
    races: FloatArray,
    slopes: FloatArray,
    turns: FloatArray,
    mean_speed: float,
) -> tuple[DutyLife, dict[str, DutyLife]]:
    """Life that leads, and that by each theory, under all steps together.

    Parameters
    ----------
    theories, headline
        of the steps; arrays (steps,)
    races, slopes
        basic reference life of each race, (steps, races), 10^6 rev, and Weibull's e, (races,)
    turns
        shares of the revolutions; (steps,)
    mean_speed
        of the rings against each other, over the time; rad/s
    """
    idle = theories[REFERENCE.name].notes["unloaded"]
    own = np.where(idle[:, np.newaxis], np.inf, races)
    with np.errstate(invalid="ignore"):
        leading = np.where(np.isinf(own), own, own * headline.factor[:, np.newaxis])
    by_theory = {
        name: _summed(record, _race_lives(record, own), slopes, idle, turns, mean_speed)
        for name, record in theories.items()
    }
    return _summed(headline, leading, slopes, idle, turns, mean_speed), by_theory


def _race_lives(record: Life, races: FloatArray) -> FloatArray | None:
    """Lives of the races by a theory that knows them apart, (steps, races)."""
    if not THEORIES[record.theory].by_race:
        return None
    factor = record.factors["a_1"] * record.factors.get("a_iso", 1.0)
    return np.asarray(races * np.asarray(factor)[:, np.newaxis])


def _summed(
    steps: Life | Headline,
    races: FloatArray | None,
    slopes: FloatArray,
    idle: BoolArray,
    turns: FloatArray,
    mean_speed: float,
) -> DutyLife:
    """Sum the damage of steps, race by race where the lives of the races are known."""
    part = (turns > 0.0) & ~idle
    # a step in which no ball carries load is endless: no damage there
    lives = np.where(idle, np.inf, steps.life)
    own = lives[:, np.newaxis] if races is None else races
    if races is None:
        life = float(miner_life(lives, turns))
    else:
        half = races.shape[1] // 2
        life = float(races_under_spectrum(races[:, :half], races[:, half:], turns, slope=slopes))
    with np.errstate(divide="ignore", invalid="ignore"):
        used = np.where(turns[:, np.newaxis] > 0.0, turns[:, np.newaxis] / own, 0.0)
        total = used.sum(axis=0)
        # of one slope the unit cancels; where slopes differ the risk is that at the end of the life
        risk = (total * life if np.isfinite(life) else total) ** (1.0 if races is None else slopes)
        risk = risk / risk.sum()
        damage = np.asarray(np.where(total > 0.0, used / total, 0.0) @ risk)
    theory, valid, below = steps.theory, steps.valid[part], steps.below[part]
    if isinstance(steps, Headline):
        theory = str(steps.theory[int(np.argmax(np.nan_to_num(damage)))])
        below = below & np.all(steps.leads[part])
        valid = steps.leads[part] & ~np.any(below)
    return DutyLife(
        theory=str(theory),
        life=life,
        hours=float(hours(life, mean_speed)),
        steps=steps,
        damage=damage,
        valid=bool(part.any()) and bool(np.all(valid)),
        below=bool(np.any(below)),
    )
