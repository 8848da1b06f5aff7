"""The scatter of the clearance in operation: many bearings drawn from their tolerances."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal, NamedTuple

import numpy as np

from rolamento.case.bearing import Bearing
from rolamento.case.mounting import Mounting
from rolamento.clearance.assembly import Temperatures
from rolamento.clearance.band import Band
from rolamento.clearance.chain import Chain
from rolamento.errors import InputError
from rolamento.numerics import FloatArray

__all__ = ["ClearanceSamples", "sample_clearance"]

_MOST_SAMPLES: Final = 1_000_000
_SIGMAS: Final = 3.0


@dataclass(frozen=True, slots=True, eq=False)
class ClearanceSamples:
    """Clearances in operation of many bearings, drawn from their tolerances; m.

    Attributes
    ----------
    clearance
        (samples,)
    shaft_interference, housing_interference
        (samples,) as mounted, negative for a gap; NaN where the ring has no seat
    shaft_effective, housing_effective
        (samples,) of it left in operation
    preloaded
        share of the samples with a negative clearance, 0 to 1
    """

    clearance: FloatArray
    shaft_interference: FloatArray
    housing_interference: FloatArray
    shaft_effective: FloatArray
    housing_effective: FloatArray
    preloaded: float

    @property
    def mean(self) -> float:
        """Of the clearance."""
        return float(self.clearance.mean())

    @property
    def standard_deviation(self) -> float:
        """Of the clearance, with n - 1; NaN of one sample."""
        return float(self.clearance.std(ddof=1)) if len(self.clearance) > 1 else np.nan

    def percentile(self, percent: float) -> float:
        """Clearance below which so many per cent of the samples lie."""
        return float(np.percentile(self.clearance, percent))


def sample_clearance(
    bearing: Bearing,
    mounting: Mounting,
    temperatures: Temperatures | None = None,
    *,
    inner_speed: float = 0.0,
    outer_speed: float = 0.0,
    samples: int = 10_000,
    seed: int = 0,
    distribution: Literal["normal", "uniform"] = "normal",
) -> ClearanceSamples:
    """Clearances in operation of many bearings whose dimensions scatter within their tolerances.

    Parameters
    ----------
    samples
        1 to a million.
    seed
        Of the random numbers: the same seed draws the same bearings.
    distribution
        Of each dimension over its band, independent of the others: ``"normal"`` about the middle,
        the limits three standard deviations away and never passed, or ``"uniform"``.

    The others, and what is raised, are as of `operating_clearance`.
    """
    if isinstance(samples, bool) or not 1 <= samples <= _MOST_SAMPLES:
        raise InputError(
            f"must be a whole number from 1 to {_MOST_SAMPLES}", field="samples", value=samples
        )
    if isinstance(seed, bool) or not 0 <= seed < 2**128:
        raise InputError("must be a whole number, not negative", field="seed", value=seed)
    if distribution not in ("normal", "uniform"):
        raise InputError(
            "must be normal or uniform", field="distribution", value=distribution, example="normal"
        )
    chain = Chain.of(bearing, mounting, temperatures, inner_speed, outer_speed)
    draws = _Draws(np.random.default_rng(seed), samples, distribution)
    initial = draws.over(chain.initial)
    on_shaft = None if chain.shaft is None else draws.total(chain.shaft_parts)
    in_housing = None if chain.housing is None else draws.total(chain.housing_parts)
    result = chain.run(initial, on_shaft, in_housing)
    nothing = np.full(samples, np.nan)
    shaft, housing = result.shaft, result.housing
    return ClearanceSamples(
        clearance=result.clearance,
        shaft_interference=nothing if shaft is None else shaft.interference,
        housing_interference=nothing if housing is None else housing.interference,
        shaft_effective=nothing if shaft is None else shaft.effective,
        housing_effective=nothing if housing is None else housing.effective,
        preloaded=float(np.mean(result.clearance < 0.0)),
    )


class _Draws(NamedTuple):
    """Independent draws from bands."""

    random: np.random.Generator
    size: int
    distribution: str

    def over(self, band: Band) -> FloatArray:
        share = self.random.random(self.size)
        if self.distribution == "normal":
            from scipy.special import ndtr, ndtri

            tail = float(ndtr(-_SIGMAS))
            share = 0.5 + ndtri(tail + share * (1.0 - 2.0 * tail)) / (2.0 * _SIGMAS)
        return np.asarray(band.low + share * (band.high - band.low))

    def total(self, bands: tuple[Band, ...]) -> FloatArray:
        return np.asarray(sum(self.over(band) for band in bands))
