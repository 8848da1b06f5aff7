"""Squared-envelope spectra of a block in many bands at once, over orders of the shaft.

All lines of a block's spectrum have been given one size (cepstrum pre-whitening; see `whitening`):
the phases alone decide, no carrier weighs more than another, and what few carriers of a tone too
weak to be found can add is bounded. Half the sampling rate is divided in 1, 2, 3, 4, 6, 8 equal
bands, as in the fast kurtogram; the inverse transform of a band's lines is its analytic signal, at
no more samples than its squared envelope needs.

In noise the lines of a squared envelope's spectrum are sums of many products of independent
phases: complex Gaussian, their powers exponential about a level that falls slowly with frequency.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import ceil
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy import fft

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.vibration._checks import Band
from rolamento.vibration.diagnosis.blocks import Block
from rolamento.vibration.diagnosis.masks import Place, most_spread, shaft_places
from rolamento.vibration.diagnosis.modulation import (
    fastest_line,
    limited,
    modulation_powers,
    over_angle,
)
from rolamento.vibration.diagnosis.tones import Comb
from rolamento.vibration.diagnosis.watch import MOST_GAPS, Watch
from rolamento.vibration.diagnosis.whitening import whitened
from rolamento.vibration.noise_floor import HALF_WIDTH

__all__ = ["BandSpectra", "Plan", "band_spectra"]

_DIVISIONS: Final = (1, 2, 3, 4, 6, 8)
_BANDWIDTH: Final = 2.5
"""Of the narrowest band, over the highest modulation frequency that is looked at in it."""


@dataclass(frozen=True, slots=True)
class Plan:
    """How blocks are analysed.

    Attributes
    ----------
    highest_order
        of the spectra
    slow_order
        up to which a modulation counts as slow
    regular
        orders of what turns
    remove_tones
        whether to take out discrete lines
    combs
        of faults whose discrete lines stay: lowest and highest order of each, and its spacing
    speed_uncertainty
        part by which a steady speed may be off
    """

    highest_order: float
    slow_order: float
    regular: tuple[float, ...]
    remove_tones: bool
    combs: tuple[tuple[float, float, float], ...]
    speed_uncertainty: float


@dataclass(frozen=True, slots=True, eq=False)
class BandSpectra:
    """Powers of the squared envelopes' lines, averaged over blocks.

    Attributes
    ----------
    plain
        (bands, lines), of the squared envelopes as they are, in arbitrary units
    power
        (bands, lines), of the squared envelopes with their regular part divided out
    depth
        (bands, lines), mean square of the modulation depth
    regular
        places of multiples of what turns
    spreads
        (bands, 1 + regular), greatest number of lines on either side of zero and of each of these
        that were taken for regular in any block; -1 for none
    bands
        Hz
    turns
        revolutions in a block: the lines are one over this apart, from order 0
    blocks
        how many were averaged
    still
        how many more were left out because they hardly change; if all are, the powers are 0
    samples
        how many were used
    rate
        Hz
    slow_order
        up to which the modulation is divided out
    bare
        likewise because they hold nothing but tones
    has_comb
        whether most hold a full comb of discrete lines at a part's frequency: blows without slip
    dropouts
        whether samples only repeat the one before, again and again
    repeats_after
        samples after which the record begins anew, one by one the same; None if it does not
    """

    plain: FloatArray
    power: FloatArray
    depth: FloatArray
    regular: tuple[Place, ...]
    spreads: NDArray[np.int64]
    bands: tuple[Band, ...]
    turns: float
    blocks: int
    still: int
    samples: int
    rate: float
    slow_order: float
    bare: int
    has_comb: bool
    dropouts: bool
    repeats_after: int | None

    @property
    def shaft_frequency(self) -> float:
        """Mean over the record; Hz."""
        return self.turns * self.blocks * self.rate / self.samples


def band_spectra(blocks: Iterable[Block], plan: Plan) -> BandSpectra:
    """Squared-envelope spectra of many bands, averaged over blocks.

    Raises
    ------
    InputError
        If there are no blocks.
    """
    watch = Watch()
    sums: _Sums | None = None
    length = 0
    for block in blocks:
        sums = _Sums(block, plan) if sums is None else sums
        length = len(block.samples)
        if watch.usable(block.samples):
            sums.add(block)
    if sums is None:
        raise InputError("holds no samples", field="signal")
    number, samples = (sums.number, sums.samples) if sums.number else (1, length)
    return BandSpectra(
        plain=sums.powers[0] / number,
        power=sums.powers[1] / number,
        depth=sums.depths / number,
        regular=sums.regular,
        spreads=sums.spreads,
        bands=sums.bands,
        turns=sums.turns,
        blocks=number,
        still=watch.still,
        samples=samples,
        rate=sums.rate,
        slow_order=plan.slow_order,
        bare=sums.bare,
        has_comb=2 * sums.combs > sums.number,
        dropouts=watch.gaps > MOST_GAPS,
        repeats_after=watch.repeats_after,
    )


class _Sums:
    """Sums over blocks that are all like the first."""

    def __init__(self, first: Block, plan: Plan) -> None:
        turns, rate = first.turns, first.rate
        lines = ceil(plan.highest_order * turns) + 1 + HALF_WIDTH
        self.turns, self.rate = turns, rate
        self.bands = _bands(rate, plan.highest_order * turns * rate / len(first.samples))
        # where the speed was measured all along, orders are as they are
        uncertainty = plan.speed_uncertainty if first.places is None else 0.0
        self._combs = [
            Comb(low * turns, high * turns, spacing * turns, turns, uncertainty)
            for low, high, spacing in plan.combs
        ]
        self.regular = tuple(shaft_places(plan.regular, turns, lines, uncertainty))
        self._slow = max(1, int(plan.slow_order * turns))
        self._remove_tones = plan.remove_tones
        self.powers = np.zeros((2, len(self.bands), lines))
        self.depths = np.zeros((len(self.bands), lines))
        self.spreads = np.full((len(self.bands), 1 + len(self.regular)), -1, dtype=np.int64)
        self.number = self.samples = self.bare = self.combs = 0

    def add(self, block: Block) -> None:
        """Add a block's powers, plain and with the regular part divided out."""
        found = whitened(block, remove_tones=self._remove_tones, combs=self._combs)
        if found is None:
            self.bare += 1
            return
        white = found.spectrum
        self.combs += found.has_comb
        lines = self.powers.shape[2]
        per_hertz = len(white) / (0.5 * block.rate)
        fastest = fastest_line(block.places, lines) + 1
        for number, (low, high) in enumerate(self.bands):
            carriers = white[max(1, round(low * per_hertz)) : round(high * per_hertz)]
            # a squared envelope is twice as wide as its band; only what is looked at must not fold
            size = fft.next_fast_len(min(2 * len(carriers), len(carriers) + fastest))
            analytic = np.asarray(fft.ifft(carriers, size))
            squared = np.square(analytic.real) + np.square(analytic.imag)
            envelope = over_angle(limited(squared), block.places, lines)
            # the sum over products of carriers, however many steps it was taken in
            scale = float(size) ** 4 / float(len(envelope)) ** 2
            powers = modulation_powers(
                envelope, self._slow, self.regular, lines, most_spread(self.turns)
            )
            self.powers[0, number] += powers.plain * scale
            self.depths[number] += powers.depth
            self.powers[1, number] += powers.even * scale
            self.spreads[number] = np.maximum(self.spreads[number], powers.spreads)
        self.number += 1
        self.samples += len(block.samples)


def _bands(rate: float, highest: float) -> tuple[Band, ...]:
    """Equal divisions of half the rate, none narrower than the modulations to be seen need."""
    half = 0.5 * rate
    divisions = [d for d in _DIVISIONS if d == 1 or half / d >= _BANDWIDTH * highest]
    return tuple((half * i / d, half * (i + 1) / d) for d in divisions for i in range(d))
