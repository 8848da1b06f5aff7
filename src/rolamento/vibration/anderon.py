"""The noise of a bearing as an anderometer tells it: radial velocity of the outer ring in bands.

The inner ring turns at 1800 rpm under a light axial load; a velocity pick-up touches the outer
ring. One anderon is one microinch RMS of radial motion per radian of rotation and per square root
of the band's octaves,

    An = v / (25.4 nm · ω · √log₂(f₂/f₁)),

v the RMS velocity in the band and ω the speed: at 1800 rpm 7.698 µm/s per anderon in the low and
medium bands and 7.531 µm/s in the high one. The radian is one of rotation, so that v/ω is the
motion; a band that is twice as many octaves wide has √2 times the velocity at the same anderons.

The same bands at the same speed are those in which ISO 15242-2 measures the velocity of radial
ball bearings; its other parts, for roller bearings, have others.

Campanha, dissertation (2008), chapter 2.8: bands, and acceptance up to 40 % of the full scale that
is set for a bearing's size and type. ISO 15242-2:2015.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite, log2, nan, pi, sqrt
from typing import Final, Literal

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.vibration._checks import Band, checked_band, checked_number
from rolamento.vibration.signal import Signal
from rolamento.vibration.spectrum import averaged_density

__all__ = [
    "ACCEPTED",
    "BANDS",
    "NOISE_NOTES",
    "SPEED",
    "Acceptance",
    "BandName",
    "BandNoise",
    "Noise",
    "accept",
    "anderons_of_velocity",
    "measure_noise",
    "velocity_of_anderons",
]

BandName = Literal["low", "medium", "high"]

BANDS: Final[dict[BandName, Band]] = {
    "low": (50.0, 300.0),
    "medium": (300.0, 1800.0),
    "high": (1800.0, 10_000.0),
}
"""Hz, at 1800 rpm. Low: errors of form and large damage; medium: dents and waviness; high:
roughness (Campanha 2008, chapter 2.8)."""
SPEED: Final = 60.0 * pi
"""Of the inner ring: 1800 rpm; rad/s."""
ACCEPTED: Final = 0.4
"""Of the full scale; Campanha 2008, chapter 2.8."""
NOISE_NOTES: Final[dict[str, str]] = {
    "speed_unknown": "The signal does not tell the speed; 1800 rpm is assumed.",
    "speed_differs": (
        "The speed is more than 2 % off 1800 rpm: anderons are reckoned with the actual speed, but "
        "bands and limits are those of 1800 rpm."
    ),
    "band_incomplete": "The sampling rate does not hold the high band, which ends at 10 kHz.",
}

_MICROINCH: Final = 25.4e-9
_SPEED_TOLERANCE: Final = 0.02
_RESOLUTION: Final = 2.0
"""Of the spectrum; Hz: a twenty-fifth of the lowest edge."""


@dataclass(frozen=True, slots=True)
class BandNoise:
    """Noise in one band.

    Attributes
    ----------
    name
        low, medium or high
    band
        Hz
    velocity
        RMS; m/s, NaN if the sampling rate does not hold the band
    anderons
        An; NaN likewise
    """

    name: BandName
    band: Band
    velocity: float
    anderons: float


@dataclass(frozen=True, slots=True)
class Noise:
    """Noise of a bearing.

    Attributes
    ----------
    speed
        of the inner ring; rad/s
    bands
        low, medium, high
    notes
        names in `NOISE_NOTES`
    """

    speed: float
    bands: tuple[BandNoise, ...]
    notes: tuple[str, ...]

    def of(self, name: BandName) -> BandNoise:
        """Return one band."""
        return next(band for band in self.bands if band.name == name)


@dataclass(frozen=True, slots=True)
class Acceptance:
    """Whether a bearing passes.

    Attributes
    ----------
    accepted
        whether all bands do
    of_full_scale
        anderons over the full scale, by band; NaN where not measured
    rejected
        bands above the limit, or not measured
    """

    accepted: bool
    of_full_scale: dict[BandName, float]
    rejected: tuple[BandName, ...]


def measure_noise(signal: Signal) -> Noise:
    """Noise of a bearing in the bands of an anderometer.

    Parameters
    ----------
    signal
        Velocity; acceleration and displacement are turned into it. At least half a second.

    Raises
    ------
    InputError
        If the quantity is unknown or the signal too short.
    """
    if signal.quantity == "unknown":
        raise InputError(
            "must be velocity, acceleration or displacement",
            field="quantity",
            value=signal.quantity,
            example='quantity = "velocity"',
        )
    if signal.duration * _RESOLUTION < 1.0:
        raise InputError(
            f"must be at least {1.0 / _RESOLUTION:g} s", field="duration", value=signal.duration
        )
    frequency, density = _velocity_density(signal.in_si)
    known = isfinite(signal.mean_speed)
    speed = abs(signal.mean_speed) if known else SPEED
    checked_number(speed, "speed", above=0.0, example="speed = 188.5")
    notes = [] if known else ["speed_unknown"]
    if abs(speed / SPEED - 1.0) > _SPEED_TOLERANCE:
        notes.append("speed_differs")
    bands = []
    for name, band in BANDS.items():
        held = band[1] <= 0.5 * signal.rate
        velocity = _rms_in(frequency, density, band) if held else nan
        bands.append(BandNoise(name, band, velocity, anderons_of_velocity(velocity, band, speed)))
    if not isfinite(bands[-1].velocity):
        notes.append("band_incomplete")
    return Noise(speed, tuple(bands), tuple(notes))


def anderons_of_velocity(velocity: float, band: Band, speed: float = SPEED) -> float:
    """Anderons of an RMS velocity (m/s) in a band (Hz) at a speed (rad/s).

    Raises
    ------
    InputError
        If the band has no width or the speed is not positive.
    """
    return velocity / _velocity_per_anderon(band, speed)


def velocity_of_anderons(anderons: float, band: Band, speed: float = SPEED) -> float:
    """RMS velocity, m/s, of a number of anderons; inverse of `anderons_of_velocity`."""
    return anderons * _velocity_per_anderon(band, speed)


def accept(noise: Noise, full_scale: dict[BandName, float], part: float = ACCEPTED) -> Acceptance:
    """Tell whether a bearing's noise is acceptable.

    Parameters
    ----------
    noise
        As measured.
    full_scale
        Anderons by band, as set for the bearing's size and type; bands that are left out do not
        count.
    part
        Of the full scale up to which noise is accepted.

    Raises
    ------
    InputError
        If a full scale is not positive, or there is none.
    """
    checked_number(part, "part", above=0.0, most=1.0, example="part = 0.4")
    if not full_scale or not set(full_scale) <= set(BANDS):
        raise InputError(
            f"must give at least one of {', '.join(BANDS)}, and nothing else",
            field="full_scale",
            example='full_scale = {"low": 30.0, "medium": 60.0, "high": 60.0}',
        )
    for name, value in full_scale.items():
        checked_number(value, f"full_scale.{name}", above=0.0, example="30.0")
    parts = {name: noise.of(name).anderons / value for name, value in full_scale.items()}
    rejected = tuple(name for name, value in parts.items() if not value <= part)
    return Acceptance(not rejected, parts, rejected)


def _velocity_per_anderon(band: Band, speed: float) -> float:
    checked_number(speed, "speed", above=0.0, example="speed = 188.5")
    low, high = checked_band(band, 1e12)
    if low <= 0.0:
        raise InputError("must begin above 0 Hz", field="band", value=str(band))
    return _MICROINCH * speed * sqrt(log2(high / low))


def _velocity_density(signal: Signal) -> tuple[FloatArray, FloatArray]:
    """Frequency and power density of the velocity, (m/s)²/Hz, above zero frequency."""
    spectrum = averaged_density(signal, _RESOLUTION)
    frequency, density = spectrum.axis[1:], spectrum.values[1:]
    turns = 2.0 * pi * frequency
    if signal.quantity == "acceleration":
        density = density / np.square(turns)
    elif signal.quantity == "displacement":
        density = density * np.square(turns)
    return frequency, density


def _rms_in(frequency: FloatArray, density: FloatArray, band: Band) -> float:
    """RMS of what lies in a band; lines at its edges count by their part inside."""
    half = 0.5 * float(frequency[1] - frequency[0])
    inside = np.minimum(frequency + half, band[1]) - np.maximum(frequency - half, band[0])
    return sqrt(float(np.sum(density * np.clip(inside, 0.0, None))))
