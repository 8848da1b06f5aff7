"""Which bearings of the catalogue would have the combs of a vibration signal.

The squared envelope of a signal whose bearing nobody knows has lines at the orders of its parts,
if it is damaged, at their multiples and at sidebands of the shaft. What is left after multiples and
sidebands are taken together are combs, the deepest first. A bearing fits as well as it explains
their depth with one speed of its cage.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import asdict
from itertools import product
from math import isfinite
from typing import Any, Final

import numpy as np

from rolamento.catalogue.rolling import RollingBearing
from rolamento.errors import InputError
from rolamento.records import frozen
from rolamento.vibration.diagnosis.band_spectra import Plan, band_spectra
from rolamento.vibration.diagnosis.blocks import blocks_of
from rolamento.vibration.diagnosis.field import cage_slip, field_of, unexplained_lines
from rolamento.vibration.diagnosis.record import UnexplainedLine
from rolamento.vibration.diagnosis.settings import (
    COMPONENTS,
    Component,
    DiagnosisSettings,
    FaultOrders,
)
from rolamento.vibration.diagnosis.shaft import shaft_lines
from rolamento.vibration.diagnosis.whitening import Whitening
from rolamento.vibration.lookalikes import orders_of
from rolamento.vibration.signal import Signal
from rolamento.words import said

__all__ = ["Comb", "Fit", "UnknownBearing", "unknown_bearing"]

_HIGHEST: Final = 30.0
"""Order up to which lines are looked for: the inner race of 25 rollers is near 14."""
_LOWEST: Final = 0.3
"""A cage turns at 0.33 to 0.5 of the shaft's speed where the outer ring stands still."""
_MOST_LINES: Final = 24
_SAME: Final = 0.006
"""Fraction of an order: as near, a line is a multiple or a sideband of a comb."""
_MULTIPLES: Final = 8
_SIDEBANDS: Final = 2
_SAME_CAGE: Final = 0.005
"""Fraction of the cage's speed, by which the parts of one bearing may differ."""


@frozen
class Comb:
    """A line that stands out, and those that go with it.

    Attributes
    ----------
    order, frequency
        of the shaft, and Hz
    depth
        modulation depth of the squared envelope there
    above_noise
        dB
    lines
        how many multiples and sidebands go with it
    """

    order: float
    frequency: float
    depth: float
    above_noise: float
    lines: int


@frozen
class Fit:
    """A bearing of the catalogue that would have some of the combs.

    Attributes
    ----------
    designation
        of the catalogue
    is_inferred
        whether its balls or rollers are inferred from its ratings
    parts
        of each comb that it explains the part, the comb's number, and by which part its cage would
        be faster than nominal
    share
        of the squared depth of all combs that it explains
    """

    designation: str
    is_inferred: bool
    parts: tuple[tuple[Component, int, float], ...]
    share: float

    @property
    def slip(self) -> float:
        """Greatest part by which the cage would be off."""
        return max(abs(slip) for _, _, slip in self.parts)


@frozen
class UnknownBearing:
    """The combs of a signal, and the bearings that would have them.

    Attributes
    ----------
    combs
        the deepest first
    fits
        the best first: those that explain most, with the least slip
    compared
        bearings of the catalogue
    shaft_frequency
        as it was taken; Hz
    speed_confirmed
        whether the shaft's own lines give it
    """

    combs: tuple[Comb, ...]
    fits: tuple[Fit, ...]
    compared: int
    shaft_frequency: float
    speed_confirmed: bool

    def to_mapping(self) -> dict[str, Any]:
        """Return all of it as plain data."""
        return asdict(self)


def unknown_bearing(
    signal: Signal | Iterable[Signal],
    bearings: Sequence[RollingBearing],
    settings: DiagnosisSettings | None = None,
) -> UnknownBearing:
    """Find the combs of a signal, and rank the bearings that would have them.

    Parameters
    ----------
    signal
        With the speed of its shaft, as of `diagnose`.
    bearings
        Of a catalogue.
    settings
        As of `diagnose`; the slip is what a bearing's cage may be off.

    Raises
    ------
    InputError
        If there are no samples, or the speed is missing.
    """
    chosen = DiagnosisSettings() if settings is None else settings
    blocks = map(Whitening, blocks_of(signal, chosen.block_revolutions))
    first = next(blocks, None)
    if first is None:
        raise InputError(said("has no samples"), field="signal")
    shaft = shaft_lines(first, chosen.speed_tolerance)
    plan = Plan(
        highest_order=_HIGHEST + 1.0,
        slow_order=0.25 * _LOWEST,
        regular=(1.0,),
        remove_tones=chosen.remove_tones,
        combs=(),
        speed_uncertainty=chosen.speed_uncertainty,
        speed_factor=shaft.factor,
    )
    spectra = band_spectra((first, *blocks), plan)
    field = field_of(spectra, FaultOrders(cage=_LOWEST), chosen, 0.0)
    lines = [one for one in unexplained_lines(field, None, _MOST_LINES) if not one.of_mains]
    combs = _combs([one for one in lines if _LOWEST <= one.order <= _HIGHEST])
    fits = [fit for bearing in bearings if (fit := _fit(bearing, combs, chosen)) is not None]
    fits.sort(key=lambda fit: (-round(fit.share, 2), fit.slip, fit.is_inferred, fit.designation))
    return UnknownBearing(
        combs, tuple(fits), len(bearings), spectra.shaft_frequency, shaft.confirmed
    )


def _combs(lines: Sequence[UnexplainedLine]) -> tuple[Comb, ...]:
    """Take lines together that are multiples of one, or sidebands of the shaft."""
    left, combs = sorted(lines, key=lambda line: -line.depth), []
    while left:
        base = _base(left[0], left)
        own = [line for line in left if _belongs(line.order, base.order)]
        left = [line for line in left if line not in own]
        combs.append(Comb(base.order, base.frequency, base.depth, base.above_noise, len(own)))
    return tuple(combs)


def _base(deepest: UnexplainedLine, lines: Sequence[UnexplainedLine]) -> UnexplainedLine:
    """Return the lowest line of which the deepest is a multiple."""
    lower = [
        line
        for line in lines
        if any(
            abs(number * line.order - deepest.order) <= _SAME * deepest.order for number in (2, 3)
        )
    ]
    return min(lower, key=lambda line: line.order, default=deepest)


def _belongs(order: float, base: float) -> bool:
    return any(
        abs(abs(number * base + side) - order) <= _SAME * order
        for number, side in product(range(1, _MULTIPLES + 1), range(-_SIDEBANDS, _SIDEBANDS + 1))
    )


def _fit(bearing: RollingBearing, combs: Sequence[Comb], settings: DiagnosisSettings) -> Fit | None:
    """Return what a bearing explains of combs, with one speed of its cage."""
    orders = orders_of(bearing)
    found: list[tuple[Component, int, float]] = []
    for number, comb in enumerate(combs):
        for part in COMPONENTS:
            nominal = orders.fundamental(part)
            if nominal is None:
                continue
            allowed = orders.tolerance(part, settings.tolerance)
            if abs(comb.order / nominal - 1.0) <= allowed:
                found.append((part, number, cage_slip(part, comb.order, orders)))
    if not found:
        return None
    weights = np.array([comb.depth**2 for comb in combs])
    best: list[tuple[Component, int, float]] = []
    for _, _, slip in found:
        agreeing = {one[1]: one for one in found if abs(one[2] - slip) <= _SAME_CAGE}
        some = list(agreeing.values())
        if _sum(some, weights) > _sum(best, weights):
            best = some
    share = _sum(best, weights) / float(np.sum(weights))
    return Fit(bearing.designation, bearing.is_inferred, tuple(best), share) if best else None


def _sum(parts: Sequence[tuple[Component, int, float]], weights: Any) -> float:
    total = float(sum(weights[number] for _, number, _ in parts))
    return total if isfinite(total) else 0.0
