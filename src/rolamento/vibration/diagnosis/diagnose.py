"""Diagnosis of a bearing from its vibration."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from itertools import chain
from typing import Final

import numpy as np

from rolamento.errors import InputError
from rolamento.vibration.diagnosis.band_spectra import Plan, band_spectra
from rolamento.vibration.diagnosis.blocks import blocks_of
from rolamento.vibration.diagnosis.hypotheses import highest_order
from rolamento.vibration.diagnosis.orders import COMPONENTS, FaultOrders
from rolamento.vibration.diagnosis.record import Diagnosis
from rolamento.vibration.diagnosis.settings import DiagnosisSettings
from rolamento.vibration.diagnosis.shaft import shaft_lines
from rolamento.vibration.diagnosis.verdict import judge
from rolamento.vibration.signal import Signal

__all__ = ["diagnose"]

_SLOW: Final = 0.25
"""Of the lowest order that is looked for: modulations up to there are of the load."""
_SPARE: Final = 1.0
"""Orders beyond the highest that is looked for, in which the noise about that is seen."""


def diagnose(
    signal: Signal | Iterable[Signal],
    orders: FaultOrders,
    settings: DiagnosisSettings | None = None,
) -> Diagnosis:
    """Tell which parts of a bearing a vibration signal shows to be damaged.

    Two things decide. The probability that noise without lines of the bearing gives any finding is
    at most ``settings.false_alarm``: the search counts all that it tries. And the modulation is as
    deep as healthy bearings do not have it: see `size`. "Nothing found" is a verdict about this
    record, not a certificate: docs/diagnosis-rates.md tells what is found how often.

    Parameters
    ----------
    signal
        Acceleration, or anything else that rings, with the shaft's speed; or consecutive parts of
        one, which are read once, and of which only a block is held at a time.
    orders
        Of the bearing's faults.
    settings
        By default a false-alarm probability of 1 %, ±2 % for slip and ±3 % for the speed.

    Raises
    ------
    InputError
        If there are no samples, the speed is missing, comes near zero or changes its sign, or
        parts do not belong together.
    """
    chosen = DiagnosisSettings() if settings is None else settings
    if not isinstance(orders, FaultOrders):
        raise InputError(
            "must be FaultOrders", field="orders", example="FaultOrders(outer_race=3.585)"
        )
    blocks = iter(blocks_of(signal, chosen.block_revolutions))
    first = next(blocks, None)
    if first is None:
        raise InputError("holds no samples", field="signal")
    shaft = shaft_lines(first, chosen.speed_tolerance)
    freedom = 0.0 if shaft.confirmed else chosen.speed_tolerance
    present = [part for part in COMPONENTS if orders.fundamental(part) is not None]
    plan = Plan(
        highest_order=_SPARE
        + max(highest_order(orders, part, chosen.tolerance + freedom) for part in present),
        slow_order=_SLOW * min(orders.fundamental(part) or np.inf for part in present),
        regular=(1.0, *orders.known),
        remove_tones=chosen.remove_tones,
        combs=_combs(orders, chosen.tolerance, freedom),
        speed_uncertainty=chosen.speed_uncertainty,
    )
    at_speed = (
        replace(block, turns=block.turns * shaft.factor) for block in chain([first], blocks)
    )
    return judge(band_spectra(at_speed, plan), orders, chosen, shaft)


def _combs(
    orders: FaultOrders, tolerance: float, freedom: float
) -> tuple[tuple[float, float, float], ...]:
    combs = []
    for part in COMPONENTS:
        nominal = orders.fundamental(part)
        if nominal is not None and part != "cage":
            allowed = orders.tolerance(part, tolerance) + freedom
            low, high = nominal * (1.0 - allowed), nominal * (1.0 + allowed)
            combs.append((low, high, orders.spacing(part)))
    return tuple(combs)
