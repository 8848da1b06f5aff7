"""White and pink noise at a given ratio to the signal, or at a given level."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.vibration.synthesis._checks import check_within
from rolamento.vibration.synthesis.transfer import fast_length

__all__ = ["Noise", "noise_samples"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Noise:
    """Noise beside the signal; one of `ratio` and `level` is given.

    Attributes
    ----------
    colour
        "white", equal power at all frequencies, or "pink", power that falls as 1/f
    ratio
        of the powers of signal and noise (dB)
    level
        root mean square (m/s²)
    of
        what the ratio is to: the "signal" without noise, such as waviness alone, or the "faults"
    """

    colour: Literal["white", "pink"] = "white"
    ratio: float | None = None
    level: float | None = None
    of: Literal["signal", "faults"] = "signal"

    def __post_init__(self) -> None:
        for field, allowed in (("colour", ("white", "pink")), ("of", ("signal", "faults"))):
            if getattr(self, field) not in allowed:
                raise InputError(
                    f"must be one of {', '.join(allowed)}",
                    field=field,
                    value=getattr(self, field),
                    example=allowed[0],
                )
        if (self.ratio is None) == (self.level is None):
            raise InputError("takes either ratio or level", field="noise", example="ratio = 0.0")
        if self.ratio is not None:
            check_within("ratio", self.ratio, -200.0, 200.0, "ratio = 0.0", "dB")
        if self.level is not None:
            check_within("level", self.level, 0.0, 1e9, "level = 1.0", "m/s²")

    def level_beside(self, power: float) -> float:
        """Root mean square of the noise beside a signal of some mean square; m/s²."""
        if self.ratio is None:
            return float(self.level or 0.0)
        return float(np.sqrt(power / 10.0 ** (0.1 * self.ratio)))


def noise_samples(
    noise: Noise, level: float, count: int, random: np.random.Generator
) -> FloatArray:
    """Return noise of exactly a level; (count,), m/s²."""
    samples = random.standard_normal(count)
    if noise.colour == "pink":
        length = fast_length(count)
        spectrum = np.fft.rfft(samples, length)
        spectrum[1:] /= np.sqrt(np.arange(1, spectrum.size))
        spectrum[0] = 0.0
        samples = np.fft.irfft(spectrum, length)[:count]
    size = float(np.sqrt(np.mean(samples**2)))
    return np.asarray(samples * (level / size)) if size > 0.0 else np.zeros(count)
