"""Life under changing duty, and of several bearings on a shaft.

Miner: each step of a duty uses up its share of revolutions over the life that it would allow, and
the bearing has lived when the shares make one. Parts that all have to survive multiply their
reliabilities: lives combine with Weibull's slope, 10/9 for ball and 9/8 for roller bearings
(`reference.system_life`).

Where races are known apart, each gathers its damage first, and then the races combine: the order
matters when the steps load different races or rows.

Sources: Palmgren (1924), Miner (1945); Lundberg and Palmgren (1947); Harris (1991), chapter 18.
"""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.errors import InputError
from rolamento.life.iso16281 import SLOPE, system_life
from rolamento.numerics import FloatArray
from rolamento.validate import numbers, positive
from rolamento.words import said

_SUM: Final = 1e-6


def miner_life(lives: ArrayLike, shares: ArrayLike, *, axis: int = 0) -> FloatArray:
    """Life under a duty of several steps.

    Parameters
    ----------
    lives : array, of each step alone along `axis`; in revolutions with shares of revolutions, in
        hours with shares of time.
    shares : array (steps,), that sum to 1.

    Returns
    -------
    Array without that axis, in the unit of the lives: 1/Σ(q/L). A step that takes no part of the
    duty counts nothing; NaN if a step that does has no life.

    Raises
    ------
    InputError
        If the shares are negative, do not sum to 1, or are as many as there are no lives.
    """
    life = np.moveaxis(numbers(lives, "lives"), axis, -1)
    share = positive(shares, "shares", zero=True)
    if share.ndim != 1 or share.size != life.shape[-1]:
        raise InputError(
            said(
                "must be as many as the steps, {steps}; given: {given}",
                steps=life.shape[-1],
                given=share.size,
            ),
            field="shares",
        )
    if not abs(float(share.sum()) - 1.0) <= _SUM:
        raise InputError(said("must sum to 1"), field="shares", value=float(share.sum()))
    with np.errstate(divide="ignore", invalid="ignore"):
        damage = np.where(share > 0.0, share / life, 0.0).sum(axis=-1)
        return np.asarray(1.0 / damage)


def revolution_shares(time_shares: ArrayLike, speeds: ArrayLike) -> FloatArray:
    """Shares of revolutions of steps that last shares of the time at given speeds.

    Parameters: arrays (steps,); the speeds in any one unit, their size counts.

    Raises
    ------
    InputError
        If nothing turns in any step.
    """
    turned = positive(time_shares, "time_shares", zero=True) * np.abs(numbers(speeds, "speeds"))
    total = turned.sum()
    if not total > 0.0:
        raise InputError(said("must not all be zero: nothing rotates"), field="speeds")
    return np.asarray(turned / total)


def races_under_spectrum(
    inner: ArrayLike, outer: ArrayLike, shares: ArrayLike, *, slope: ArrayLike = SLOPE
) -> FloatArray:
    """Life of one bearing under several steps, damage gathered race by race.

    Parameters
    ----------
    inner, outer : arrays (steps, rows), lives of the races in each step alone.
    shares : array (steps,), of revolutions (or of time, with lives in hours).
    slope : Weibull's e; one number, or (2·rows,) of the inner and then the outer races.

    Returns
    -------
    Life, in the unit of the lives; a 0-dimensional array.
    """
    races = np.concatenate([numbers(inner, "inner"), numbers(outer, "outer")], axis=1)
    return system_life(miner_life(races, shares), slope=slope)


def shaft_life(lives: ArrayLike, *, axis: int = -1, slope: ArrayLike = SLOPE) -> FloatArray:
    """Life of several bearings that all have to survive, for the reliability of each life.

    Parameters
    ----------
    lives : array, of the bearings along `axis`; in hours if they turn at different speeds.
    slope : Weibull's e of the bearings; ball and roller bearings together have one each, and the
        life then follows from Σ (t/L)^e = 1.

    Returns
    -------
    Array without that axis, in the unit of the lives.
    """
    return system_life(lives, axis=axis, slope=slope)
