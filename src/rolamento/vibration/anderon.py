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

The velocity is that of a signal in one piece or in many. Acceleration and displacement become
velocity line by line of the spectrum: divided by, and times, 2πf. Welch's segments run across the
pieces, so that these give the density of the whole signal.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from math import inf, isfinite, log2, nan, pi, sqrt
from typing import Final, NamedTuple, TypeAlias

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.vibration._checks import Band, checked_band, checked_count, checked_number, pieces_of
from rolamento.vibration.signal import Quantity, Signal
from rolamento.vibration.spectrum import Spectrum, averaged_density, axis_of
from rolamento.words import Note, said

_POWERS: Final[dict[Quantity, float]] = {
    "acceleration": -2.0, "velocity": 0.0, "displacement": 2.0
}  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class Velocity:
    """The velocity of a signal, over frequency.

    Attributes
    ----------
    density
        averaged power density, (m/s)²/Hz, 0 at zero frequency; over Hz
    rate
        of the samples; Hz
    duration
        of the signal; s
    quantity
        that was measured
    speed
        mean of the shaft's; rad/s, NaN if it is not known
    """

    density: Spectrum
    rate: float
    duration: float
    quantity: Quantity
    speed: float


def velocity_of(signal: Signal | Iterable[Signal], resolution: float) -> Velocity:
    """Return the velocity of a signal.

    Parameters
    ----------
    signal
        Acceleration, velocity or displacement; in one piece, or as consecutive pieces of any
        length, of which no more than one and a segment is held at a time.
    resolution
        Distance of the lines: the segments are of one over that; Hz.

    Raises
    ------
    InputError
        If the quantity is unknown, the signal is shorter than a segment or does not change, or the
        pieces differ in rate, quantity or unit.
    """
    pieces = pieces_of(signal)
    first = next(pieces)
    if first.quantity not in _POWERS:
        raise InputError(
            said("must be velocity, acceleration or displacement"),
            field="quantity",
            value=first.quantity,
            example='quantity = "velocity"',
        )
    total = _Total(first, resolution, max(round(first.rate / resolution), 2))
    total.add(first)
    for piece in pieces:
        total.add(piece)
    return total.velocity()


@dataclass(slots=True, eq=False)
class _Total:
    """What pieces come to so far.

    first: of them; size: samples of a segment; waiting: samples that are in no density yet, the
    first half a segment but for the beginning; density: sum over `segments`; turned: sum of the
    speeds over all samples.
    """

    first: Signal
    resolution: float
    size: int
    waiting: list[FloatArray] = field(default_factory=list)
    density: FloatArray | None = None
    segments: int = 0
    samples: int = 0
    turned: float = 0.0
    least: float = inf
    most: float = -inf

    def add(self, piece: Signal) -> None:
        """Take a piece into account."""
        self._check(piece)
        self.samples += len(piece.samples)
        self.turned += len(piece.samples) * piece.mean_speed
        self.least = min(self.least, float(np.min(piece.samples)))
        self.most = max(self.most, float(np.max(piece.samples)))
        self.waiting.append(piece.in_si.samples)
        overlap = self.size // 2
        hop = self.size - overlap
        segments = (sum(map(len, self.waiting)) - overlap) // hop
        if segments < 1:
            return
        held = self.waiting[0] if len(self.waiting) == 1 else np.concatenate(self.waiting)
        whole = Signal(held[: overlap + segments * hop], self.first.rate)
        density = segments * averaged_density(whole, self.first.rate / self.size).values
        self.density = density if self.density is None else self.density + density
        self.segments += segments
        self.waiting = [held[segments * hop :].copy()]

    def velocity(self) -> Velocity:
        """Return what all pieces come to.

        Raises
        ------
        InputError
            If they are shorter than a segment, or do not change.
        """
        first, duration = self.first, self.samples / self.first.rate
        if self.density is None:
            rule = said("must be at least {resolution:.6g} s", resolution=1.0 / self.resolution)
            raise InputError(rule, field="duration", value=duration, source=first.title)
        if self.least == self.most:
            raise InputError(
                said(
                    "is constant over {samples} samples: no sensor was connected, or it is "
                    "the wrong channel",
                    samples=self.samples,
                ),
                field="signal",
                value=self.least,
                source=first.title,
            )
        resolution = first.rate / self.size
        axis = axis_of(len(self.density), resolution)
        values = np.zeros(len(axis))
        values[1:] = self.density[1:] / self.segments
        values[1:] *= (2.0 * np.pi * axis[1:]) ** _POWERS[first.quantity]
        density = Spectrum(axis, values, "Hz", "(m/s)^2/Hz", resolution, self.segments)
        return Velocity(density, first.rate, duration, first.quantity, self.turned / self.samples)

    def _check(self, piece: Signal) -> None:
        for name in ("rate", "quantity", "unit"):
            value, wanted = getattr(piece, name), getattr(self.first, name)
            if value != wanted:
                rule = said("must be that of the first piece, {wanted}", wanted=wanted)
                raise InputError(rule, field=name, value=value, source=piece.title)


# --- anderons ------------------------------------------------------------------------------------


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
"""Of the inner ring: 1800 rpm; rad/s."""
ACCEPTED: Final = 0.4
"""Of the full scale; Campanha 2008, chapter 2.8."""

_MICROINCH: Final = 25.4e-9
_SPEED_TOLERANCE: Final = (-0.02 - 1e-9, 0.01 + 1e-9)
"""ISO 15242-2:2015, clause 4.1, and rounding."""
_MOST_PARTS: Final = 1000
_RESOLUTION: Final = 2.0
"""Of the spectrum; Hz: a twenty-fifth of the lowest edge."""


@dataclass(frozen=True, slots=True)
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


@dataclass(frozen=True, slots=True)
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
    checked_number(speed, "speed", above=0.0, example="speed = 188.5")
    measured = []
    for name, band in bands.items():
        held = band[1] <= 0.5 * velocity.rate
        size = _rms_in(velocity.density, band) if held else nan
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
    checked_count(parts, "parts", least=1, most=_MOST_PARTS, example="parts = 8")
    found = {}
    for band in noise.bands:
        if band.name in noise.missing:
            continue
        edges = np.geomspace(*band.band, parts + 1)
        pairs = list(zip(edges[:-1].tolist(), edges[1:].tolist(), strict=True))
        sizes = (_rms_in(noise.velocity.density, pair) for pair in pairs)
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
    """RMS velocity, m/s, of a number of anderons; inverse of `anderons_of_velocity`."""
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
    checked_number(part, "part", above=0.0, most=1.0, example="part = 0.4")
    names = [band.name for band in noise.bands]
    if not full_scale or not set(full_scale) <= set(names):
        raise InputError(
            said("must give at least one of {names}, and nothing else", names=", ".join(names)),
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
        raise InputError(said("must begin above 0 Hz"), field="band", value=str(band))
    return _MICROINCH * speed * sqrt(log2(high / low))


def _check_bands(bands: Mapping[BandName, Band]) -> None:
    for name, band in bands.items():
        if checked_band(band, 1e12, f"bands.{name}")[0] <= 0.0:
            raise InputError(said("must begin above 0 Hz"), field=f"bands.{name}", value=str(band))


def _rms_in(density: Spectrum, band: Band) -> float:
    """RMS of what lies in a band; lines at its edges count by their part inside."""
    half = 0.5 * density.resolution
    inside = np.minimum(density.axis + half, band[1]) - np.maximum(density.axis - half, band[0])
    return sqrt(float(np.sum(density.values * np.clip(inside, 0.0, None))))
