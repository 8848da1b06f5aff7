"""The noise of a bearing as an anderometer measures it: radial velocity of the outer ring in bands.

The inner ring turns at 1800 rpm under a light axial load; a velocity pick-up touches the outer
ring. One anderon is one microinch RMS of radial motion per radian of rotation and per square root
of the band's octaves,

    An = v / (25.4 nm · ω · √log₂(f₂/f₁)),

v the RMS velocity in the band and ω the speed: at 1800 rpm 7.698 µm/s per anderon in the low and
medium bands and 7.531 µm/s in the high one. The radian is one of rotation, so that v/ω is the
motion; a band that is twice as many octaves wide has √2 times the velocity at the same anderons.

The same bands at the same speed are those in which ISO 15242-2 measures the velocity of radial
ball bearings; its other parts, for roller bearings, have others. The anderons of a band are the
root mean square of those of its equally wide parts, in octaves: a part that stands out shows which
frequencies make the level, on the scale on which it is judged.

Campanha, dissertation (2008), chapter 2.8: bands, and acceptance up to 40 % of the full scale that
is set for a bearing's size and type. ISO 15242-2:2015.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import isfinite, log2, nan, pi, sqrt
from typing import Final, NamedTuple, TypeAlias

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import number, whole_number
from rolamento.vibration.signal import Band, Signal, checked_band
from rolamento.vibration.velocity import Velocity, rms_in, velocity_of
from rolamento.words import Note, said

BandName: TypeAlias = str
"""low, medium or high; any other name of bands that somebody else defines."""

BANDS: Final[dict[BandName, Band]] = {
    "low": (50.0, 300.0),
    "medium": (300.0, 1800.0),
    "high": (1800.0, 10_000.0),
}
"""Hz, at 1800 rpm. Low: errors of form and large damage; medium: dents and waviness; high:
roughness (Campanha 2008, chapter 2.8)."""
SPEED: Final = 60.0 * pi
"""Speed of the inner ring: 1800 rpm; rad/s."""
ACCEPTED: Final = 0.4
"""Fraction of the full scale; Campanha 2008, chapter 2.8."""

_MICROINCH: Final = 25.4e-9
_SPEED_TOLERANCE: Final = (-0.02 - 1e-9, 0.01 + 1e-9)
"""ISO 15242-2:2015, clause 4.1, and rounding."""
_MOST_PARTS: Final = 1000
_RESOLUTION: Final = 2.0
"""Resolution of the spectrum; Hz: a twenty-fifth of the lowest edge."""


@frozen
class BandNoise:
    """Noise in one band.

    Attributes
    ----------
    name
        low, medium, high, or as given
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


@frozen
class Noise:
    """Noise of a bearing.

    Attributes
    ----------
    speed
        of the inner ring; rad/s
    bands
        low, medium, high; or those that were asked for
    notes
        what a reader should know
    velocity
        of the outer ring, of which the bands are parts
    """

    speed: float
    bands: tuple[BandNoise, ...]
    notes: tuple[Note, ...]
    velocity: Velocity

    def of(self, name: BandName) -> BandNoise:
        """Return one band."""
        return next(band for band in self.bands if band.name == name)

    @property
    def missing(self) -> tuple[BandName, ...]:
        """Bands that the sampling rate does not hold."""
        return tuple(band.name for band in self.bands if not isfinite(band.velocity))


class NoiseSteps(NamedTuple):
    """Anderons of equally wide parts of a band: edges (parts + 1,), Hz, and anderons (parts,)."""

    edges: FloatArray
    anderons: FloatArray


@frozen
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


def measure_noise(
    signal: Signal | Iterable[Signal], bands: Mapping[BandName, Band] = BANDS
) -> Noise:
    """Noise of a bearing in the bands of an anderometer.

    Parameters
    ----------
    signal
        Velocity; acceleration and displacement are turned into it. At least half a second, in one
        piece, or as consecutive pieces of any length that need not fit into memory together.
    bands
        Hz, by name: by default `BANDS`.

    Raises
    ------
    InputError
        If the quantity is unknown, the signal too short, does not change or stands still, its
        pieces do not fit together, or a band has no width.
    """
    _check_bands(bands)
    velocity = velocity_of(signal, _RESOLUTION)
    known = isfinite(velocity.speed)
    speed = abs(velocity.speed) if known else SPEED
    number(speed, "speed", above=0.0, example="speed = 188.5")
    measured = []
    for name, band in bands.items():
        held = band[1] <= 0.5 * velocity.rate
        size = rms_in(velocity.density, band) if held else nan
        measured.append(BandNoise(name, band, size, anderons_of_velocity(size, band, speed)))
    notes = [] if known else [Note("speed_unknown")]
    if not _SPEED_TOLERANCE[0] <= speed / SPEED - 1.0 <= _SPEED_TOLERANCE[1]:
        notes.append(Note("speed_differs"))
    missing = [band.name for band in measured if not isfinite(band.velocity)]
    if missing:
        notes.append(Note("band_incomplete", {"rate": velocity.rate, "bands": missing}))
    return Noise(speed, tuple(measured), tuple(notes), velocity)


def noise_steps(noise: Noise, parts: int = 8) -> dict[BandName, NoiseSteps]:
    """Anderons of equally wide parts of every band that the sampling rate holds.

    Parameters
    ----------
    noise
        As measured.
    parts
        Of each band, equal in octaves; 8 are a third of an octave each, in `BANDS`. The root mean
        square of their anderons is the band's level.

    Raises
    ------
    InputError
        If the number of parts is none.
    """
    whole_number(parts, "parts", least=1, most=_MOST_PARTS, example="parts = 8")
    found = {}
    for band in noise.bands:
        if band.name in noise.missing:
            continue
        edges = np.geomspace(*band.band, parts + 1)
        pairs = list(zip(edges[:-1].tolist(), edges[1:].tolist(), strict=True))
        sizes = (rms_in(noise.velocity.density, pair) for pair in pairs)
        levels = [
            anderons_of_velocity(size, pair, noise.speed)
            for size, pair in zip(sizes, pairs, strict=True)
        ]
        found[band.name] = NoiseSteps(edges, np.array(levels))
    return found


def anderons_of_velocity(velocity: float, band: Band, speed: float = SPEED) -> float:
    """Anderons of an RMS velocity (m/s) in a band (Hz) at a speed (rad/s).

    Raises
    ------
    InputError
        If the band has no width or the speed is not positive.
    """
    return velocity / _velocity_per_anderon(band, speed)


def velocity_of_anderons(anderons: float, band: Band, speed: float = SPEED) -> float:
    """RMS velocity, m/s, of a number of anderons; inverse of `anderons_of_velocity`.

    >>> found = 1e6 * velocity_of_anderons(anderons_of_velocity(1e-5, (50.0, 300.0)), (50.0, 300.0))
    >>> print(f"{found:.1f} um/s")
    10.0 um/s
    """
    return anderons * _velocity_per_anderon(band, speed)


def accept(
    noise: Noise, full_scale: Mapping[BandName, float], part: float = ACCEPTED
) -> Acceptance:
    """Return whether a bearing's noise is acceptable.

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
    number(part, "part", above=0.0, most=1.0, example="part = 0.4")
    names = [band.name for band in noise.bands]
    if not full_scale or not set(full_scale) <= set(names):
        raise InputError(
            said("must give at least one of {names}, and nothing else", names=", ".join(names)),
            field="full_scale",
            example='full_scale = {"low": 30.0, "medium": 60.0, "high": 60.0}',
        )
    for name, value in full_scale.items():
        number(value, f"full_scale.{name}", above=0.0, example="30.0")
    parts = {name: noise.of(name).anderons / value for name, value in full_scale.items()}
    rejected = tuple(name for name, value in parts.items() if not value <= part)
    return Acceptance(not rejected, parts, rejected)


def _velocity_per_anderon(band: Band, speed: float) -> float:
    number(speed, "speed", above=0.0, example="speed = 188.5")
    low, high = checked_band(band, 1e12)
    if low <= 0.0:
        raise InputError(said("must begin above 0 Hz"), field="band", value=str(band))
    return _MICROINCH * speed * sqrt(log2(high / low))


def _check_bands(bands: Mapping[BandName, Band]) -> None:
    for name, band in bands.items():
        if checked_band(band, 1e12, f"bands.{name}")[0] <= 0.0:
            raise InputError(said("must begin above 0 Hz"), field=f"bands.{name}", value=str(band))
