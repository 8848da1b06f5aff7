"""The spectra that are searched: which lines are left out, and the noise about the others."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from rolamento.numerics import BoolArray, FloatArray
from rolamento.vibration.diagnosis.band_spectra import BandSpectra
from rolamento.vibration.diagnosis.hypotheses import hypotheses_of
from rolamento.vibration.diagnosis.masks import (
    fault_places,
    filled,
    lines_about,
    lines_connected,
)
from rolamento.vibration.diagnosis.orders import Component, FaultOrders
from rolamento.vibration.diagnosis.search import Finding, Scores, search
from rolamento.vibration.diagnosis.settings import DiagnosisSettings
from rolamento.vibration.noise_floor import mean_over_median, running_medians

__all__ = ["SEEN", "Field", "field_of"]

SEEN: Final = 0.8
"""Of a band's width: up to there the noise of its squared envelope falls slowly."""
_STANDS_OUT: Final = 0.9
"""Quantile of noise below which a line that a fault may make is no more than noise."""


@dataclass(frozen=True, slots=True, eq=False)
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
    orders, settings
        as given
    """

    spectra: BandSpectra
    medians: FloatArray
    left_out: BoolArray
    orders: FaultOrders
    settings: DiagnosisSettings

    @property
    def turns(self) -> float:
        """Lines per order."""
        return self.spectra.turns

    @property
    def level(self) -> FloatArray:
        """Mean power of the noise about each line; (bands, lines)."""
        return self.medians * mean_over_median(self.spectra.blocks)

    def findings(self, parts: Iterable[Component]) -> dict[Component, Finding | None]:
        """Return the best match for each of some components among the lines that are left."""
        scores = Scores(self.spectra.power, self.left_out, self.medians, self.spectra.blocks)
        return {part: self._finding(scores, part) for part in parts}

    def without(self, component: Component, finding: Finding) -> Field:
        """Return the field without the lines of a fault that stand out."""
        lines = self.left_out.shape[1]
        places = fault_places(
            component, finding, self.orders, self.turns, lines, self.settings.tolerance
        )
        about = lines_about(
            self.spectra.power,
            self.level,
            places,
            stands_out=_STANDS_OUT,
            averages=self.spectra.blocks,
        )
        return replace(self, left_out=self.left_out | about)

    def _finding(self, scores: Scores, component: Component) -> Finding | None:
        nominal = self.orders.fundamental(component)
        if nominal is None:
            return None
        tolerance = self.orders.tolerance(component, self.settings.tolerance)
        return search(
            scores,
            hypotheses_of(self.orders, component),
            self.turns,
            nominal * (1.0 - tolerance),
            nominal * (1.0 + tolerance),
            self.settings.tolerance if component == "ball" else 0.0,
        )


def field_of(spectra: BandSpectra, orders: FaultOrders, settings: DiagnosisSettings) -> Field:
    """Leave out lines of what turns and those too fast for a band, and take the noise's level."""
    lines = spectra.power.shape[1]
    plain_level = mean_over_median(spectra.blocks) * running_medians(spectra.plain)
    left_out = lines_about(spectra.plain, plain_level, spectra.regular)
    left_out |= lines_connected(spectra.spreads, spectra.regular, spectra.turns, lines)
    medians = running_medians(filled(spectra.power, left_out))
    frequency = np.arange(lines) * (spectra.shaft_frequency / spectra.turns)
    widths = np.array([high - low for low, high in spectra.bands])
    left_out |= frequency[None] > SEEN * widths[:, None]
    return Field(spectra, medians, left_out, orders, settings)
