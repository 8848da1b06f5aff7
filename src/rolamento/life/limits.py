"""What limits a bearing's life: which row, race, ball, and which condition."""

from __future__ import annotations

from typing import Final

import numpy as np

from rolamento.life.record import Limit
from rolamento.life.reference import SLOPE, ReferenceLife
from rolamento.life.solved_balls import SolvedRows
from rolamento.numerics import FloatArray

_WORTH: Final = 1.5
"""Gain of the modified life below which neither oil nor cleanliness is what limits it."""


def limit_of(
    balls: SolvedRows,
    reference: ReferenceLife,
    factor: FloatArray | None,
    factor_if_thick: FloatArray | None,
    factor_if_clean: FloatArray | None,
) -> Limit:
    """Find what limits the life of solved cases.

    Parameters
    ----------
    balls, reference : the cases, and their reference life.
    factor, factor_if_thick, factor_if_clean : a_ISO as it is (or its bound), with κ = 4, and with
        e_C = 1, NaN where there is none; None where lubrication is not known.
    """
    count = balls.ball_count.size
    races = np.concatenate([reference.inner, reference.outer], axis=1)
    ended = np.isfinite(reference.life) & ~balls.unloaded
    weakest = np.argmin(np.where(np.isnan(races), np.inf, races), axis=1)
    row = np.where(ended, weakest % count, 0)
    inner = weakest < count
    race = np.where(ended, np.where(inner, "inner", "outer"), "")
    with np.errstate(divide="ignore", invalid="ignore"):
        risk = races**-SLOPE
        share = np.take_along_axis(risk, weakest[:, np.newaxis], 1)[:, 0] / risk.sum(axis=1)
    load = np.where(inner[:, np.newaxis], balls.inner_load, balls.outer_load)
    starts = np.array([*balls.row_starts, balls.inner_load.shape[1]])
    index = np.arange(balls.inner_load.shape[1])
    own = (index >= starts[row][:, np.newaxis]) & (index < starts[row + 1][:, np.newaxis])
    heaviest = np.argmax(np.where(own & ~np.isnan(load), load, -1.0), axis=1)
    return Limit(
        row=np.asarray(row, dtype=np.int64),
        race=np.asarray(race, dtype=np.str_),
        ball=np.where(ended, heaviest, -1).astype(np.int64),
        share=np.where(ended, share, np.nan),
        factor=_factor(len(balls), factor, factor_if_thick, factor_if_clean),
    )


def _factor(
    cases: int, factor: FloatArray | None, thick: FloatArray | None, clean: FloatArray | None
) -> np.ndarray[tuple[int, ...], np.dtype[np.str_]]:
    if factor is None or thick is None or clean is None:
        return np.full(cases, "", dtype="U15")
    with np.errstate(invalid="ignore", divide="ignore"):
        gain_of_oil, gain_of_filter = thick / factor, clean / factor
        oil, dirt = np.nan_to_num(gain_of_oil), np.nan_to_num(gain_of_filter)
    best = np.where(oil >= dirt, "viscosity_ratio", "contamination")
    named = np.where(np.maximum(oil, dirt) < _WORTH, "load", best)
    # where only one of them can be judged, the load cannot be told to be what costs most
    judged = ~np.isnan(gain_of_oil) & ~np.isnan(gain_of_filter)
    return np.asarray(np.where((named == "load") & ~judged, "", named), dtype="U15")
