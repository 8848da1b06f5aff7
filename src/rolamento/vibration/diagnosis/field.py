"""The spectra that are searched: which lines are left out, and the noise about the others."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Final

import numpy as np

from rolamento.numerics import BoolArray, FloatArray
from rolamento.vibration.diagnosis.band_spectra import BandSpectra
from rolamento.vibration.diagnosis.hypotheses import hypotheses_of
from rolamento.vibration.diagnosis.mains import MAINS, is_near_mains
from rolamento.vibration.diagnosis.masks import filled, lines_about, lines_connected, most_spread
from rolamento.vibration.diagnosis.orders import Component, FaultOrders
from rolamento.vibration.diagnosis.search import Finding, Scores, search
from rolamento.vibration.diagnosis.settings import DiagnosisSettings
from rolamento.vibration.diagnosis.size import depth_error, depth_of
from rolamento.vibration.noise_floor import mean_over_median, running_medians

__all__ = ["SEEN", "Field", "field_of"]

SEEN: Final = 0.8
"""Of a band's width: up to there the noise of its squared envelope falls slowly."""
_HIGHEST_MAINS: Final = 360.0
"""Hz; higher harmonics of a supply are hardly felt, and every line is near one of them."""
_DISCRETE: Final = 0.95
"""Depth of a line alone over that of all lines about it: from there on it is discrete."""
_HUMP: Final = 16


@dataclass(frozen=True, eq=False)
class Field:
    """The lines that are searched, and what is known of them.

    Attributes
    ----------
    spectra
        that were measured
    medians
        (bands, lines), of the noise about each line
    left_out
        (bands, lines)
    shaft
        (bands, lines), of those the lines of what turns, and those too fast for a band
    orders, settings
        as given
    freedom
        part by which the speed may still be off
    """

    spectra: BandSpectra
    medians: FloatArray
    left_out: BoolArray
    shaft: BoolArray
    orders: FaultOrders
    settings: DiagnosisSettings
    freedom: float

    @property
    def turns(self) -> float:
        """Lines per order."""
        return self.spectra.turns

    @property
    def level(self) -> FloatArray:
        """Mean power of the noise about each line; (bands, lines)."""
        return self.medians * mean_over_median(self.spectra.blocks)

    @cached_property
    def depths(self) -> FloatArray:
        """Mean squares of the modulation depth, less those of noise about each; (bands, lines).

        0 at lines of what turns.
        """
        return np.where(self.shaft, 0.0, self.spectra.depth - self._depth_levels)

    @cached_property
    def _depth_levels(self) -> FloatArray:
        """Mean squares of the modulation depth that the noise about each line has."""
        levels = running_medians(self.spectra.depth) * mean_over_median(self.spectra.blocks)
        return np.asarray(np.nan_to_num(levels))

    def window(self, component: Component) -> tuple[float, float]:
        """Orders between which a component's is looked for."""
        nominal = self.orders.fundamental(component) or 0.0
        within = self.orders.tolerance(component, self.settings.tolerance) + self.freedom
        return nominal * (1.0 - within), nominal * (1.0 + within)

    def depth(self, band: int, line: float, width: int = 1) -> float:
        """Modulation depth of a band at a line."""
        return depth_of(self.depths[band], line, width)

    def depth_error(self, band: int, line: float) -> float:
        """Standard deviation of the depth at a line by the noise about it."""
        place = min(round(line), self._depth_levels.shape[1] - 1)
        return depth_error(float(self._depth_levels[band, place]), self.spectra.blocks)

    def on_mains(self, band: int, line: float) -> bool:
        """Whether a line is of the mains and discrete: a bearing slips, a grid hardly."""
        per_line = self.spectra.shaft_frequency / self.turns
        hertz = np.array([line * per_line])
        near = any(is_near_mains(hertz, per_line, mains)[0] for mains in MAINS)
        return (
            near
            and line * per_line <= _HIGHEST_MAINS
            and self.depth(band, line) >= _DISCRETE * self.depth(band, line, _HUMP)
        )

    def findings(self, parts: Iterable[Component]) -> dict[Component, Finding | None]:
        """Return the best match for each of some components among the lines that are left."""
        scores = Scores(self.spectra.power, self.left_out, self.medians, self.spectra.blocks)
        return {part: self._finding(scores, part) for part in parts}

    def with_shaft(self) -> Field:
        """Return the field with the lines of what turns, as they are."""
        spectra = replace(self.spectra, power=self.spectra.plain)
        return replace(
            self,
            spectra=spectra,
            medians=running_medians(spectra.power),
            left_out=_too_fast(spectra),
            shaft=_too_fast(spectra),
        )

    def _finding(self, scores: Scores, component: Component) -> Finding | None:
        if self.orders.fundamental(component) is None:
            return None
        return search(
            scores,
            hypotheses_of(self.orders, component),
            self.turns,
            *self.window(component),
            self.settings.tolerance if component == "ball" else 0.0,
        )


def field_of(
    spectra: BandSpectra, orders: FaultOrders, settings: DiagnosisSettings, freedom: float
) -> Field:
    """Leave out lines of what turns and those too fast for a band, and take the noise's level."""
    lines = spectra.power.shape[1]
    plain_level = mean_over_median(spectra.blocks) * running_medians(spectra.plain)
    shaft = lines_about(spectra.plain, plain_level, spectra.regular, most_spread(spectra.turns))
    left_out = shaft | lines_connected(spectra.spreads, spectra.regular, spectra.turns, lines)
    medians = running_medians(filled(spectra.power, left_out))
    fast = _too_fast(spectra)
    return Field(spectra, medians, left_out | fast, shaft | fast, orders, settings, freedom)


def _too_fast(spectra: BandSpectra) -> BoolArray:
    """Lines beyond what a band's width shows; (bands, lines)."""
    frequency = np.arange(spectra.power.shape[1]) * (spectra.shaft_frequency / spectra.turns)
    widths = np.array([high - low for low, high in spectra.bands])
    return np.asarray(frequency[None] > SEEN * widths[:, None])
