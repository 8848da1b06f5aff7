"""A synthetic vibration signal from its parts, and the truth about it.

Noise is white or pink, at a given ratio to the signal or at a given level.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace
from math import isfinite
from typing import TYPE_CHECKING, Any, Final, Literal

import numpy as np

from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.validate import check_count, number, one_of
from rolamento.vibration.frequencies import FaultFrequencies, FaultKind, frequencies_of
from rolamento.vibration.signal import Signal
from rolamento.vibration.synthesis.faults import (
    Fault,
    Impacts,
    LoadDistribution,
    Turning,
    cycles_at,
    impacts_of,
)
from rolamento.vibration.synthesis.speed import SpeedProfile, SteadySpeed, angle_of, speeds_of
from rolamento.vibration.synthesis.transfer import (
    DEFAULT_MODES,
    Mode,
    TransferPath,
    check_modes,
    fast_length,
    modulated_in_frequency,
    ringing,
)
from rolamento.vibration.synthesis.waviness import (
    Waviness,
    WavinessLine,
    waviness_acceleration,
    waviness_lines,
)
from rolamento.words import said

if TYPE_CHECKING:
    from rolamento.solved import Solved


@frozen(kw_only=True)
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
        for name, allowed in (("colour", ("white", "pink")), ("of", ("signal", "faults"))):
            one_of(getattr(self, name), name, allowed)
        if (self.ratio is None) == (self.level is None):
            raise InputError(
                said("takes either ratio or level"), field="noise", example="ratio = 0.0"
            )
        if self.ratio is not None:
            number(self.ratio, "ratio", least=-200.0, most=200.0, unit="dB", example="ratio = 0.0")
        if self.level is not None:
            number(self.level, "level", least=0.0, most=1e9, unit="m/s²", example="level = 1.0")

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


# --- recipe, truth and signal --------------------------------------------------------------------


_TURN: Final = 2.0 * np.pi
_MOST_SAMPLES: Final = 50_000_000
_MOST_PARTS: Final = 100
_MOST_SEED: Final = 2**64


@frozen(kw_only=True)
class Recipe:
    """What a synthetic signal is made of.

    Attributes
    ----------
    frequencies
        of the bearing: its orders and signed speeds over the shaft's
    speed
        of the shaft; without one, steady at that of the frequencies
    duration, rate
        s, and samples per second
    faults
        damage
    load
        that the strengths of impacts go with; equal all round if not given
    load_turns
        speed of the load's direction over the shaft's: 0 where it stands still, 1 for unbalance
    path, modes
        from the impacts to the sensor
    shaft_harmonics
        amplitudes at 1, 2, 3 … times the shaft's frequency (m/s²)
    waviness
        of races and balls
    noise
        beside all that
    seed
        of everything random; each part draws from its own source, so that one more part changes
        none of the others
    title
        of the signal
    """

    frequencies: FaultFrequencies
    speed: SpeedProfile | None = None
    duration: float = 10.0
    rate: float = 51_200.0
    faults: tuple[Fault, ...] = ()
    load: LoadDistribution = field(default_factory=LoadDistribution.uniform)
    load_turns: float = 0.0
    path: TransferPath = field(default_factory=TransferPath)
    modes: tuple[Mode, ...] = DEFAULT_MODES
    shaft_harmonics: tuple[float, ...] = ()
    waviness: tuple[Waviness, ...] = ()
    noise: Noise | None = None
    seed: int = 0
    title: str = "synthetic"

    def __post_init__(self) -> None:
        number(self.rate, "rate", least=1.0, most=1e8, unit="Hz", example="rate = 51200.0")
        number(
            self.duration,
            "duration",
            least=2.0 / self.rate,
            most=1e6,
            unit="s",
            example="duration = 10.0",
        )
        number(self.load_turns, "load_turns", least=-1e3, most=1e3, example="load_turns = 0.0")
        if self.count > _MOST_SAMPLES:
            raise InputError(
                said("gives more than {most} samples at this rate", most=_MOST_SAMPLES),
                field="duration",
                value=self.duration,
                example="duration = 10.0",
            )
        if isinstance(self.seed, bool) or not 0 <= self.seed < _MOST_SEED:
            raise InputError(said("must be a non-negative integer"), field="seed", value=self.seed)
        for name in ("faults", "shaft_harmonics", "waviness"):
            check_count(name, len(getattr(self, name)), _MOST_PARTS)
        for amplitude in self.shaft_harmonics:
            number(
                amplitude,
                "shaft_harmonics",
                least=0.0,
                most=1e9,
                unit="m/s²",
                example="shaft_harmonics = (0.5,)",
            )
        check_modes(self.modes, self.rate)
        if not isfinite(self.frequencies.cage.order):
            raise InputError(said("have no result to make a signal from"), field="frequencies")
        noise = self.noise
        to_faults = noise is not None and noise.ratio is not None and noise.of == "faults"
        if to_faults and not self.faults:
            raise InputError(
                said("is what the noise ratio refers to, but there are none"),
                field="noise.of",
                value="faults",
                example='of = "signal"',
            )

    @property
    def count(self) -> int:
        """Samples."""
        return round(self.duration * self.rate)


@frozen(eq=False)
class FaultTruth:
    """What one fault did.

    Attributes
    ----------
    kind, modulation
        of the `Fault`
    order, frequency
        of the shaft, and the mean over the signal (Hz), without jitter
    rms
        root mean square of what the fault alone makes (m/s²)
    times, azimuths, strengths
        of the impacts (impacts,): s, rad, dimensionless. With modulation of frequency they are the
        passages, and the strengths have no effect.
    """

    kind: FaultKind
    modulation: str
    order: float
    frequency: float
    rms: float
    times: FloatArray
    azimuths: FloatArray
    strengths: FloatArray

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values and lists."""
        arrays = {name: getattr(self, name).tolist() for name in ("times", "azimuths", "strengths")}
        plain = {"kind": self.kind, "modulation": self.modulation}
        numbers = {"order": self.order, "frequency": self.frequency, "rms": self.rms}
        return {**plain, **numbers, **arrays}


@frozen(eq=False)
class Truth:
    """What is known of a synthetic signal.

    Attributes
    ----------
    recipe
        that it was made by
    faults
        what each fault did
    waviness_lines
        of all wavy surfaces
    speed
        of the shaft, () or (samples,); rad/s
    noise_level
        root mean square of the noise (m/s²)
    signal_to_noise
        of the signal without noise and of the noise (dB); infinite without noise
    """

    recipe: Recipe
    faults: tuple[FaultTruth, ...]
    waviness_lines: tuple[WavinessLine, ...]
    speed: FloatArray
    noise_level: float
    signal_to_noise: float

    @property
    def speeds(self) -> FloatArray:
        """Speed of the shaft at every sample, steady or not; (samples,), rad/s."""
        return np.broadcast_to(self.speed, (self.recipe.count,))

    def to_mapping(self) -> dict[str, Any]:
        """Give the truth as plain values and lists, in SI units and Hz."""
        ratio = self.signal_to_noise
        return {
            "seed": self.recipe.seed,
            "rate": self.recipe.rate,
            "duration": self.recipe.duration,
            "frequencies": self.recipe.frequencies.to_mapping(),
            "faults": [fault.to_mapping() for fault in self.faults],
            "waviness": [line._asdict() for line in self.waviness_lines],
            "speed": {
                "mean": float(np.mean(self.speed)),
                "minimum": float(np.min(self.speed)),
                "maximum": float(np.max(self.speed)),
            },
            "noise_level": self.noise_level,
            "signal_to_noise": ratio if isfinite(ratio) else None,
        }


@frozen(eq=False)
class Synthesis:
    """A signal, and the truth about it."""

    signal: Signal
    truth: Truth


def recipe_of(solved: Solved, faults: Sequence[Fault], **parts: Any) -> Recipe:
    """Return a recipe with the loaded frequencies and the load distribution of a solved case.

    Parameters
    ----------
    solved
        One case of what `rolamento.solve` returns; of a set, the row that carries most.
    faults
        Damage.
    parts
        Of the `Recipe`, in the place of its defaults.

    Raises
    ------
    InputError
        If the case has no result, or a part is out of range.
    """
    found = frequencies_of(solved)
    load = parts.pop("load", None) or LoadDistribution.of_solved(solved, row=found.row)
    alone = replace(found, rows=())
    return Recipe(**{"frequencies": alone, "faults": tuple(faults), "load": load, **parts})


def synthesise(recipe: Recipe) -> Synthesis:
    """Make a vibration signal.

    Parameters
    ----------
    recipe
        What it is made of.

    Returns
    -------
    Synthesis
        The acceleration at the sensor (m/s²) with the shaft's speed, and the truth.

    Raises
    ------
    InputError
        If the shaft does not turn one way throughout, or a part is out of range.

    Antoni and Randall (2003); McFadden and Smith (1984); Wardle (1988). See
    docs/theory/vibration-frequencies.md.
    """
    sources = _Sources.of(recipe)
    speeds = speeds_of(_speed_profile(recipe), recipe.count, recipe.rate, sources.speed)
    turning = Turning(angle_of(speeds, recipe.count, recipe.rate), recipe.rate)
    damage, truths = _damage(recipe, turning, sources)
    lines = tuple(
        line for wavy in recipe.waviness for line in waviness_lines(recipe.frequencies, wavy)
    )
    clean = damage + _shaft_and_waviness(recipe, lines, turning, speeds, sources)
    power = {"signal": float(np.mean(clean**2)), "faults": float(np.mean(damage**2))}
    level = 0.0 if recipe.noise is None else recipe.noise.level_beside(power[recipe.noise.of])
    samples = clean
    if recipe.noise is not None and level > 0.0:
        samples = clean + noise_samples(recipe.noise, level, recipe.count, sources.noise)
    signal = Signal(samples, recipe.rate, "acceleration", "m/s^2", speeds, recipe.title)
    ratio = _decibels(power["signal"], level**2)
    return Synthesis(signal, Truth(recipe, truths, lines, speeds, level, ratio))


@frozen
class _Sources:
    """A source of random numbers for every part."""

    speed: np.random.Generator
    noise: np.random.Generator
    phases: np.random.Generator
    waves: np.random.Generator
    faults: tuple[np.random.Generator, ...]

    @classmethod
    def of(cls, recipe: Recipe) -> _Sources:
        parts = np.random.SeedSequence(recipe.seed).spawn(5)
        speed, noise, phases, waves = (np.random.default_rng(part) for part in parts[:4])
        own = parts[4].spawn(len(recipe.faults))
        faults = tuple(np.random.default_rng(part) for part in own)
        return cls(speed, noise, phases, waves, faults)


def _speed_profile(recipe: Recipe) -> SpeedProfile:
    if recipe.speed is not None:
        return recipe.speed
    found = recipe.frequencies
    speed = found.inner_speed if found.shaft == "inner" else found.outer_speed
    if not isfinite(speed) or speed == 0.0:
        raise InputError(
            said("is missing: the frequencies have no speed either"),
            field="speed",
            example="speed = SteadySpeed(188.5)",
        )
    return SteadySpeed(speed)


def _damage(
    recipe: Recipe, turning: Turning, sources: _Sources
) -> tuple[FloatArray, tuple[FaultTruth, ...]]:
    """What the faults make, and what each did."""
    total, truths = np.zeros(recipe.count), []
    mean = float(turning.size[-1]) / _TURN / (recipe.count - 1) * recipe.rate
    for fault, random in zip(recipe.faults, sources.faults, strict=True):
        impacts = impacts_of(
            fault,
            recipe.frequencies,
            turning,
            recipe.load,
            recipe.path,
            random,
            recipe.load_turns,
        )
        order = recipe.frequencies.of_fault(fault.kind).order
        answer = _response(recipe, fault, impacts, turning, order)
        total += answer
        truths.append(
            FaultTruth(
                fault.kind,
                fault.modulation,
                order,
                order * mean,
                float(np.sqrt(np.mean(np.square(answer)))),
                impacts.times,
                impacts.azimuths,
                impacts.strengths,
            )
        )
    return total, tuple(truths)


def _response(
    recipe: Recipe, fault: Fault, impacts: Impacts, turning: Turning, order: float
) -> FloatArray:
    if fault.modulation == "amplitude":
        return ringing(impacts.times, impacts.strengths, recipe.modes, recipe.count, recipe.rate)
    cycles = cycles_at(impacts, turning, order)
    return modulated_in_frequency(cycles, recipe.modes, recipe.rate, fault.index, fault.strength)


def _shaft_and_waviness(
    recipe: Recipe,
    lines: Sequence[WavinessLine],
    turning: Turning,
    speeds: FloatArray,
    sources: _Sources,
) -> FloatArray:
    """Waviness and the shaft's own harmonics."""
    phases = sources.waves.uniform(0.0, _TURN, len(lines))
    total = waviness_acceleration(lines, phases, turning.angle, speeds, recipe.rate)
    starts = sources.phases.uniform(0.0, _TURN, len(recipe.shaft_harmonics))
    most = float(np.max(np.abs(speeds)))
    for order, amplitude in enumerate(recipe.shaft_harmonics, start=1):
        if amplitude > 0.0 and order * most < 0.5 * recipe.rate * _TURN:
            total += amplitude * np.cos(order * turning.angle + starts[order - 1])
    return total


def _decibels(power: float, noise: float) -> float:
    if noise == 0.0:
        return float("inf")
    return float(10.0 * np.log10(power / noise)) if power > 0.0 else float("-inf")
