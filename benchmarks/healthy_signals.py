"""Signals of machines whose bearing is in order: noise, resonances, shafts, gears, modulation.

Each is drawn anew from its seed: speed, resonances, tooth numbers and levels too. The bearing of
some has lines at its own frequencies, as those of real machines have, from load that varies and
from waviness: of 2 to 27 % of modulation depth, as healthy bearings of public test rigs show.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import pi
from typing import Any, Final

import numpy as np
from scipy import signal

from rolamento import Bearing
from rolamento.vibration.diagnosis import FaultOrders
from rolamento.vibration.frequencies import nominal_frequencies
from rolamento.vibration.signal import Signal

RATE: Final = 51_200.0
DESIGNATIONS: Final = ("6205", "6305", "6208", "6012")
DEPTHS: Final = (0.02, 0.27)
"""Modulation depths of lines that healthy bearings have."""
Array = np.ndarray[Any, np.dtype[np.float64]]


@dataclass(frozen=True, slots=True)
class Machine:
    """A shaft that turns, and a bearing's orders.

    speed: rad/s, () or (samples,); turns: (samples,), revolutions.
    """

    orders: FaultOrders
    speed: Array
    turns: Array

    @property
    def frequency(self) -> float:
        """Of the shaft; Hz."""
        return float(np.mean(self.speed)) / (2.0 * pi)


def machine(duration: float, random: np.random.Generator, wander: float = 0.0) -> Machine:
    """A bearing of the catalogue at 15 to 60 revolutions a second, by chance."""
    count = int(duration * RATE)
    frequency = float(random.uniform(15.0, 60.0))
    designation = DESIGNATIONS[random.integers(len(DESIGNATIONS))]
    orders = FaultOrders.of(nominal_frequencies(Bearing.named(designation), 2 * pi * frequency))
    if wander == 0.0:
        speed = np.asarray(2 * pi * frequency)
        return Machine(orders, speed, np.arange(count) * (frequency / RATE))
    time = np.arange(count) / RATE
    swing = sum(
        random.uniform(-wander, wander) * np.sin(2 * pi * time / period + random.uniform(0, 7))
        for period in (3.0, 7.0, 19.0)
    )
    speeds = 2 * pi * frequency * (1.0 + swing)
    steps = 0.5 * (speeds[1:] + speeds[:-1]) / (2 * pi * RATE)
    return Machine(orders, speeds, np.concatenate([[0.0], np.cumsum(steps)]))


def white(shaft: Machine, random: np.random.Generator) -> Array:
    """Noise without colour."""
    return random.normal(size=len(shaft.turns))


def resonances(shaft: Machine, random: np.random.Generator) -> Array:
    """Noise that three resonances colour."""
    count = len(shaft.turns)
    frequency = np.fft.rfftfreq(count, 1.0 / RATE)
    transfer = np.full(len(frequency), 0.3, dtype=np.complex128)
    for low, high in ((800, 3000), (3000, 9000), (9000, 18_000)):
        own, damping = random.uniform(low, high), random.uniform(0.01, 0.05)
        gain = random.uniform(0.15, 0.9) * own**2
        transfer += gain / (own**2 - frequency**2 + 2j * damping * own * frequency)
    noise = np.fft.irfft(np.fft.rfft(white(shaft, random)) * transfer, count)
    return np.asarray(noise / noise.std())


def harmonics(shaft: Machine, random: np.random.Generator) -> Array:
    """Of the shaft, in coloured noise."""
    total = resonances(shaft, random)
    for order in range(1, 8):
        total += _tone(shaft.turns, order, 10 ** random.uniform(-1, 1) / order, random)
    return total


def own_gear(shaft: Machine, random: np.random.Generator) -> Array:
    """A gear on the shaft, in coloured noise."""
    return resonances(shaft, random) + _gear(shaft.turns, int(random.integers(17, 60)), random)


def other_gear(shaft: Machine, random: np.random.Generator) -> Array:
    """A gear of another shaft, which turns at a ratio of tooth numbers."""
    teeth, own = int(random.integers(17, 60)), int(random.integers(17, 60))
    return resonances(shaft, random) + _gear(shaft.turns * (own / teeth), teeth, random)


def modulated(shaft: Machine, random: np.random.Generator) -> Array:
    """Coloured noise that rises and falls with the shaft's angle, and slowly."""
    angle = 2 * pi * shaft.turns
    slow = 2 * pi * np.arange(len(angle)) / RATE / random.uniform(2.0, 10.0)
    level = (
        1.0
        + random.uniform(0.1, 0.5) * np.cos(angle)
        + random.uniform(0.0, 0.3) * np.cos(2 * angle + 1.0)
        + random.uniform(0.0, 0.3) * np.cos(slow)
    )
    return level * resonances(shaft, random)


def lines_of_parts(shaft: Machine, random: np.random.Generator) -> Array:
    """Coloured noise that rises and falls with the balls, the cage and the shaft's angle."""
    level = np.ones(len(shaft.turns))
    angle = 2 * pi * shaft.turns
    slip = 1.0 + random.uniform(-0.01, 0.005)
    for part in random.choice(("outer_race", "inner_race", "ball", "cage"), 2, replace=False):
        order = (shaft.orders.fundamental(part) or 0.0) * slip
        depth = float(np.exp(random.uniform(*np.log(DEPTHS))))
        level += depth * np.cos(order * angle + random.uniform(0, 7))
        level += random.uniform(0.0, 0.5) * depth * np.cos(2 * order * angle)
    level += random.uniform(0.0, 0.2) * np.cos(angle)
    total = np.sqrt(np.maximum(level, 0.05)) * resonances(shaft, random)
    for order in range(1, 11):
        total += _tone(shaft.turns, order, 10 ** random.uniform(-1.5, 0) / order, random)
    return total


def everything(shaft: Machine, random: np.random.Generator) -> Array:
    """Modulated noise, harmonics and both gears."""
    total = modulated(shaft, random)
    for part in (harmonics, own_gear, other_gear):
        total += part(shaft, random) - resonances(shaft, random)
    return total


def fan(shaft: Machine, random: np.random.Generator) -> Array:
    """Blades that strike the air as often as there are of them in a turn."""
    blades = int(random.integers(3, 12))
    return harmonics(shaft, random) + _struck(shaft, blades, 0.01, random)


def coupling(shaft: Machine, random: np.random.Generator) -> Array:
    """A jaw coupling with play: its jaws strike, one harder than the others."""
    jaws = int(random.integers(2, 7))
    uneven = _struck(shaft, 1, 0.003, random)
    return harmonics(shaft, random) + _struck(shaft, jaws, 0.003, random) + 0.5 * uneven


def converter(shaft: Machine, random: np.random.Generator) -> Array:
    """A motor on a converter: noise that swings at twice the supply, tones where it switches."""
    time = np.arange(len(shaft.turns)) / RATE
    supply = shaft.frequency * int(random.choice([1, 2])) / (1.0 - random.uniform(0.005, 0.04))
    switching = random.uniform(2000.0, 12_000.0)
    level = 1.0 + random.uniform(0.05, 0.6) * np.cos(4 * pi * supply * time)
    total = np.sqrt(level) * harmonics(shaft, random)
    for side in (-4, -2, 0, 2, 4):
        total += random.uniform(0.2, 3.0) * np.sin(2 * pi * (switching + side * supply) * time)
    return total


def knocks(shaft: Machine, random: np.random.Generator) -> Array:
    """Something that knocks on the machine now and then, and a rub once a turn."""
    total = harmonics(shaft, random)
    count = int(random.integers(5, 60))
    places = random.integers(0, len(total) - 1000, size=count)
    total += _rung(places, 10 ** random.uniform(0.5, 2.0, size=count), len(total), random)
    return total + random.uniform(0.2, 1.0) * _struck(shaft, 1, 0.002, random)


KINDS: Final[dict[str, tuple[Callable[[Machine, np.random.Generator], Array], float]]] = {
    "white noise": (white, 0.0),
    "noise with resonances": (resonances, 0.0),
    "shaft harmonics": (harmonics, 0.0),
    "gear on the shaft": (own_gear, 0.0),
    "gear on another shaft": (other_gear, 0.0),
    "noise modulated by the shaft": (modulated, 0.0),
    "all of these": (everything, 0.0),
    "all of these, speed wandering": (everything, 0.03),
    "fan": (fan, 0.0),
    "coupling": (coupling, 0.0),
    "converter": (converter, 0.0),
    "knocks": (knocks, 0.0),
    "lines of a healthy bearing": (lines_of_parts, 0.0),
    "lines of a healthy bearing, speed wandering": (lines_of_parts, 0.03),
}
"""What makes them, and by which part the speed wanders."""


def healthy(kind: str, duration: float, seed: int) -> tuple[Signal, FaultOrders]:
    """A signal of a machine in order, and the orders of its bearing."""
    make, wander = KINDS[kind]
    random = np.random.default_rng([seed, list(KINDS).index(kind), round(1000 * duration)])
    shaft = machine(duration, random, wander)
    samples = make(shaft, random)
    return Signal(samples, RATE, "acceleration", "m/s^2", shaft.speed, kind), shaft.orders


def _tone(turns: Array, order: float, amplitude: float, random: np.random.Generator) -> Array:
    return amplitude * np.sin(2 * pi * order * turns + random.uniform(0, 2 * pi))


def _struck(shaft: Machine, times: int, scatter: float, random: np.random.Generator) -> Array:
    """Blows so many times a turn, in step with the shaft but for a part of a period of each."""
    turns = shaft.turns
    blows = np.arange(1, int(turns[-1] * times)) / times
    blows = blows + scatter / times * random.normal(size=len(blows))
    unlike = 1.0 + 0.1 * random.normal(size=times)
    size = 10 ** random.uniform(0.0, 1.3) * np.resize(unlike, len(blows))
    places = np.clip(np.searchsorted(turns, blows), 0, len(turns) - 1)
    return _rung(places, size, len(turns), random)


def _rung(places: Any, size: Array, count: int, random: np.random.Generator) -> Array:
    """A resonance that is struck at some places."""
    struck = np.zeros(count)
    np.add.at(struck, places, size)
    decay = np.arange(2048) / RATE
    own = random.uniform(1500.0, 9000.0)
    ringing = np.exp(-random.uniform(300.0, 1500.0) * decay) * np.sin(2 * pi * own * decay)
    return np.asarray(signal.fftconvolve(struck, ringing)[:count])


def _gear(turns: Array, teeth: int, random: np.random.Generator) -> Array:
    """Meshing tones, modulated in size and phase once and twice per revolution."""
    angle = 2 * pi * turns
    size = 1.0 + 0.5 * np.cos(angle) + 0.3 * np.cos(2 * angle + 1.0)
    total = np.zeros(len(turns))
    for number in range(1, 8):
        amplitude = 10 ** random.uniform(-0.5, 1) / number
        phase = random.uniform(0, 2 * pi) + 0.3 * np.sin(angle)
        total += amplitude * size * np.sin(number * teeth * angle + phase)
    return total
