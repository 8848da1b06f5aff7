"""What it takes to draw a test again, and how it went."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Protocol, Self

import numpy as np

from rolamento.weibull.profile import BatchFit, Rows

__all__ = ["Drawing", "Model", "RightCensored", "portions"]

_AT_ONCE: Final = 100_000
_MOST_DRAWN: Final = 400_000_000
_MANY: Final = 0.1
_LEAST_FITS: Final = 50


class Model(Protocol):
    """How a test is drawn."""

    @property
    def width(self) -> int:
        """Numbers in one drawn test."""

    @property
    def exact(self) -> bool:
        """Whether only lives are random."""

    @property
    def inspected(self) -> bool:
        """Whether failures are only found at inspections."""

    def fits(
        self, shape: float, log_scale: float, samples: int, random: np.random.Generator
    ) -> BatchFit:
        """Draw so many tests and fit each."""


class RightCensored(Model, Protocol):
    """A model whose tests are right-censored, so that groups of them can be fitted together."""

    def rows(
        self, shape: float, log_scale: float, samples: int, random: np.random.Generator
    ) -> Rows:
        """Draw so many tests."""


@dataclass(frozen=True, slots=True)
class Drawing:
    """How tests were drawn.

    Attributes
    ----------
    code
        "converged", or why there are none
    samples, dropped
        drawn tests, and how many of them had no fit and are left out
    notes
        names in `fit.NOTES`
    """

    code: str
    samples: int = 0
    dropped: int = 0
    notes: tuple[str, ...] = ()

    @classmethod
    def of(cls, model: Model, samples: int, dropped: int) -> Self:
        """Note what was modelled, and what was left out."""
        if model.exact:
            return cls._noted(samples, dropped, "")
        note = "inspections_shared" if model.inspected else "censoring_modelled"
        return cls._noted(samples, dropped, note)

    @classmethod
    def resampled(cls, samples: int, dropped: int) -> Self:
        """Note what was left out of a plain bootstrap."""
        return cls._noted(samples, dropped, "large_sample_method")

    @classmethod
    def _noted(cls, samples: int, dropped: int, note: str) -> Self:
        if samples - dropped < _LEAST_FITS:
            return cls("not_converged")
        notes = (note,) if note else ()
        if dropped > _MANY * samples:
            notes = (*notes, "many_without_fit")
        return cls("converged", samples, dropped, notes)


def portions(width: int, samples: int) -> list[int]:
    """Part so many drawn tests into portions that fit into memory; fewer of very large tests."""
    samples = min(samples, max(_MOST_DRAWN // width, 100))
    step = max(_AT_ONCE // width, 1)
    return [min(step, samples - first) for first in range(0, samples, step)]
