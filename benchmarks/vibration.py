"""Vibration: diagnosis of a signal and of an hour streamed from disk, kurtogram and the rest.

A 6205 with a damaged inner race under radial load, 51.2 kHz, in noise; at steady speed, and at one
that swings by 5 %. Beside each stands what a user would write instead (`vibration_plain`), in the
same run; both have to find the same. The hour is a file of its own in a temporary directory, which
a process of its own reads, so that its memory can be told.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, Final

import numpy as np

from benchmarks import vibration_plain
from benchmarks.figures import (
    Figure,
    Findings,
    alternately,
    at_least,
    below,
    peak_megabytes,
    seconds,
)
from rolamento import Bearing
from rolamento.vibration.cyclic import cyclic_coherence
from rolamento.vibration.demodulation import kurtogram
from rolamento.vibration.diagnosis import Diagnosis, FaultOrders, diagnose
from rolamento.vibration.frequencies import FaultFrequencies, nominal_frequencies
from rolamento.vibration.order_tracking import order_tracked, revolutions_of
from rolamento.vibration.reading import open_signal
from rolamento.vibration.signal import Signal
from rolamento.vibration.synthesis import (
    Fault,
    LoadDistribution,
    Noise,
    Recipe,
    SwingingSpeed,
    synthesise,
)

RATE: Final = 51_200.0
DURATION: Final = 10.0
"""s"""
SPEED: Final = 1797.0 * np.pi / 30.0
"""rad/s"""
SHORT: Final = 2.0
"""s; a signal of which the search takes as long as all the rest."""
SECONDS: Final = 0.25
"""That the diagnosis of a signal of full length may take."""
NOISE: Final = 0.0
"""Ratio of the fault to the noise; dB."""
DIVISIONS: Final = (1, 2, 3, 4, 6, 8)
"""Of half the rate, in bands: those of the diagnosis."""
SLIP: Final = 0.02
LEVELS: Final = 8
FAULT: Final = "inner_race"
HIGHEST: Final = 500.0
"""Of the modulations of the cyclic coherence; Hz."""
WINDOW: Final = 256
MODULATION: Final = 90.0
"""Of the noise whose coherence is taken; Hz."""
PIECE: Final = 2**20
"""Samples that are read at a time."""
ROUNDING: Final = 1e-9
ESTIMATORS: Final = 0.03
"""By which two estimates of a coherence may differ."""
GROWTH: Final = 50.0
"""Of the memory with the length of a recording that still counts as none; MB."""


def recipe(duration: float, swing: float = 0.0, noise: float | None = NOISE) -> Recipe:
    """A damaged inner race; swing: part by which the speed swings."""
    return Recipe(
        frequencies=frequencies(),
        speed=SwingingSpeed(SPEED, swing, 0.2, 0.0) if swing else None,
        duration=duration,
        rate=RATE,
        faults=(Fault(kind=FAULT),),
        load=LoadDistribution.radial(),
        noise=None if noise is None else Noise(ratio=noise, of="faults"),
        seed=1,
    )


def frequencies() -> FaultFrequencies:
    return nominal_frequencies(Bearing.named("6205"), SPEED)


def measure(duration: float, repeats: int) -> Findings:
    """Diagnosis at steady and at varying speed, beside filters, Hilbert transform and FFT."""
    findings = Findings.none()
    for kind, swing in (("steady", 0.0), ("varying", 0.05)):
        findings.add(
            _diagnosed(f"diagnosis of {duration:g} s, {kind} speed", duration, swing, repeats)
        )
    return findings


def measure_short(repeats: int) -> Findings:
    """Likewise of a short signal, of which plain code has the least to do."""
    return _diagnosed(f"diagnosis of {SHORT:g} s, steady speed", SHORT, 0.0, repeats)


def _diagnosed(name: str, duration: float, swing: float, repeats: int) -> Findings:
    signal, orders = synthesise(recipe(duration, swing)).signal, FaultOrders.of(frequencies())
    assert signal.speed is not None
    run = partial(diagnose, signal, orders)
    parts = [
        vibration_plain.Part(part, orders.fundamental(part) or 0.0, orders.spacing(part))
        for part in ("outer_race", "inner_race", "ball", "cage")
    ]
    plain = partial(
        vibration_plain.diagnose, signal.samples, RATE, signal.speed, parts, DIVISIONS, SLIP
    )
    begin = time.perf_counter()
    found = run()
    first = time.perf_counter() - begin
    ours, theirs = alternately([run, plain], repeats)
    target = below(SECONDS) if duration >= DURATION else None
    faster = at_least(1.0) if duration == SHORT or duration >= DURATION else None
    figures = [
        Figure(name, "wall time", ours, "s", target),
        *([] if swing else [Figure(name, "first call in the process", first, "s", target)]),
        Figure(name, "SciPy, band by band", theirs, "s"),
        Figure(name, "  the engine is faster by", theirs / ours, "times", faster),
    ]
    return Findings(figures, [], _complaints(name, found, plain()))


def _complaints(name: str, found: Diagnosis, match: vibration_plain.Match) -> list[str]:
    """What is wrong with a diagnosis, and with what was written instead."""
    verdict = found.of(FAULT)
    if found.faults != (FAULT,):
        return [f"{name}: finds {', '.join(found.faults) or 'nothing'}, not {FAULT}"]
    far = abs(match.order - verdict.order) > 2.0 * found.resolution
    if match.part != FAULT or far:
        return [f"{name}: SciPy finds {match.part} at {match.order:.4f}, not {verdict.order:.4f}"]
    return []


def measure_kurtogram(duration: float, repeats: int) -> Findings:
    """The fast kurtogram, beside short-time transforms and the same filters one by one."""
    signal = synthesise(recipe(duration, noise=-10.0)).signal
    run = partial(kurtogram, signal, LEVELS)
    half, most = (
        partial(vibration_plain.kurtogram_of_stft, signal.samples, RATE, LEVELS, overlap)
        for overlap in (0.5, 0.75)
    )
    filters = partial(vibration_plain.kurtogram_of_filters, signal.samples, LEVELS)
    ours, halved, overlapping, one_by_one = alternately([run, half, most, filters], repeats)
    name = f"kurtogram of {duration:g} s, {LEVELS} levels"
    faster = at_least(1.0) if duration >= DURATION else None
    figures = [
        Figure(name, "wall time", ours, "s"),
        Figure(name, "SciPy's STFT, overlap ¾", overlapping, "s"),
        Figure(name, "  the engine is faster by", overlapping / ours, "times", faster),
        Figure(name, "SciPy's STFT, overlap ½", halved, "s"),
        Figure(name, "  the engine is faster by", halved / ours, "times", faster),
        Figure(name, "the same filters, one by one", one_by_one, "s"),
        Figure(name, "  the engine is faster by", one_by_one / ours, "times"),
    ]
    found, failures = run(), []
    same = filters()
    worst = max(
        float(np.max(np.abs(level.kurtosis - same[len(level.kurtosis)])))
        for level in found.levels[1:]
    )
    if not worst < ROUNDING:
        failures.append(f"{name}: the same filters differ by {worst:.1e}")
    low, high = found.best().band
    bands, kurtosis = max(most().items(), key=lambda item: float(np.max(item[1])))
    centre = 0.5 * RATE / bands * int(np.argmax(kurtosis))
    if not low - 0.5 * RATE / bands < centre < high + 0.5 * RATE / bands:
        failures.append(f"{name}: STFT finds {centre:.0f} Hz, not {low:.0f} to {high:.0f} Hz")
    return Findings(figures, [], failures)


def measure_synthesis(duration: float, repeats: int) -> Findings:
    """Making the signals."""
    name = f"synthesis of {duration:g} s"
    return Findings(
        [
            Figure(name, f"{kind} speed", seconds(partial(synthesise, given), repeats), "s")
            for kind, given in (
                ("steady", recipe(duration)),
                ("varying", recipe(duration, swing=0.05)),
            )
        ],
        [],
        [],
    )


def measure_tracking(duration: float, repeats: int) -> Findings:
    """A signal over the shaft's angle, beside SciPy's spline through its samples."""
    signal = synthesise(recipe(duration, swing=0.05)).signal
    turns, tracked = revolutions_of(signal), order_tracked(signal)
    per_turn = tracked.samples_per_revolution
    run = partial(order_tracked, signal)
    plain = partial(vibration_plain.over_angle, signal.samples, turns, per_turn)
    ours, theirs = alternately([run, plain], repeats)
    name = f"order tracking of {duration:g} s"
    figures = [
        Figure(name, "wall time", ours, "s"),
        Figure(name, "SciPy's make_interp_spline", theirs, "s"),
        Figure(name, "  the engine is faster by", theirs / ours, "times"),
    ]
    # the ends differ: a mirror here, the not-a-knot condition there
    inside = slice(100, -100)
    difference = np.max(np.abs(plain() - tracked.samples)[inside]) / np.std(signal.samples)
    wrong = not difference < ROUNDING
    return Findings(figures, [], [f"{name}: SciPy differs by {difference:.1e}"] if wrong else [])


def measure_coherence(duration: float, sample: int, repeats: int) -> Findings:
    """Cyclic coherence of all modulations, beside `scipy.signal.csd` for a sample of them."""
    signal = _modulated(duration)
    run = partial(cyclic_coherence, signal, HIGHEST, WINDOW)
    found = run()
    step = int(RATE / (4.0 * HIGHEST))
    line = int(np.argmin(np.abs(found.modulation - MODULATION)))
    modulation = float(found.modulation[line])
    one = partial(vibration_plain.coherence, signal.samples, RATE, modulation, WINDOW, step)

    def plain() -> None:
        for _ in range(sample):
            one()

    ours, theirs = alternately([run, plain], repeats)
    count = len(found.modulation)
    each = theirs / sample
    name = f"cyclic coherence of {duration:g} s, {count} modulations"
    figures = [
        Figure(name, "wall time", ours, "s"),
        Figure(name, "SciPy's csd and welch, a modulation", each, "s"),
        Figure(name, "  the engine is faster by", count * each / ours, "times"),
    ]
    inside = slice(8, WINDOW // 2 - 8)
    difference = float(np.max(np.abs(one() - found.coherence[: WINDOW // 2, line])[inside]))
    wrong = not difference < ESTIMATORS
    return Findings(figures, [], [f"{name}: SciPy differs by {difference:.2f}"] if wrong else [])


def _modulated(duration: float) -> Signal:
    """Noise that rises and falls."""
    count = round(duration * RATE)
    swing = 1.0 + 0.8 * np.cos(2.0 * np.pi * MODULATION / RATE * np.arange(count))
    return Signal(swing * np.random.default_rng(2).normal(size=count), RATE)


def measure_recording(short: float, long: float) -> Findings:
    """Recordings of so many minutes, diagnosed from a file: time, and memory that may not grow."""
    minutes = [short, long]
    try:
        found = [_streamed(length) for length in minutes]
    except (RuntimeError, OSError) as error:
        return Findings([], [], [f"streaming: {error}"])
    name = f"{long:g} min at 51.2 kHz, from a file"
    grown = found[1]["megabytes"] - found[0]["megabytes"]
    figures = [
        Figure(name, "wall time", found[1]["seconds"], "s"),
        Figure(name, "signal over time taken", 60.0 * long / found[1]["seconds"], "times"),
        *(
            Figure(name, f"peak memory, {length:g} min", one["megabytes"], "MB")
            for length, one in zip(minutes, found, strict=True)
        ),
        Figure(name, "more for the longer one", grown, "MB", below(GROWTH)),
        Figure(name, "size of the file", found[1]["size"], "MB"),
    ]
    failures = [
        f"{name}: finds {one['faults']} in {length:g} min, not {FAULT}"
        for length, one in zip(minutes, found, strict=True)
        if one["faults"] != [FAULT]
    ]
    if grown > GROWTH:
        failures.append(f"{name}: takes {grown:.0f} MB more than {short:g} min")
    return Findings(figures, [], failures)


def _streamed(minutes: float) -> dict[str, Any]:
    """Write a recording, have a new process diagnose it, and delete it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "recording.npy"
        write_recording(path, minutes)
        command = [sys.executable, "-m", "benchmarks.vibration", str(path)]
        root = Path(__file__).parents[1]
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=3600, check=False, cwd=root
        )
        size = path.stat().st_size / 1e6
    if done.returncode != 0:
        last = (done.stderr or done.stdout).strip().splitlines()[-1:]
        raise RuntimeError(f"exit code {done.returncode}: {' '.join(last)}")
    return {**json.loads(done.stdout), "size": size}


def write_recording(path: Path, minutes: float) -> None:
    """Write a recording in pieces: the damage of ten seconds again and again, noise never twice."""
    damage = synthesise(recipe(DURATION, noise=None)).signal.samples.astype(np.float32)
    level = np.float32(np.std(damage) * 10.0 ** (-0.05 * NOISE))
    random = np.random.default_rng(3)
    left = round(60.0 * minutes * RATE)
    header = {"descr": "<f4", "fortran_order": False, "shape": (left,)}
    with path.open("wb") as file:
        np.lib.format.write_array_header_1_0(file, header)
        while left > 0:
            piece = damage[: min(left, len(damage))]
            noise = random.standard_normal(len(piece), dtype=np.float32)
            file.write((piece + level * noise).astype("<f4").tobytes())
            left -= len(piece)


def diagnose_file(path: str) -> dict[str, Any]:
    """Diagnose a recording piece by piece; the time, the peak memory, and what was found."""
    begin = time.perf_counter()
    with open_signal(path, rate=RATE, unit="m/s^2") as file:
        found = diagnose(_pieces(file.blocks(PIECE)), FaultOrders.of(frequencies()))
    taken = time.perf_counter() - begin
    return {"seconds": taken, "megabytes": peak_megabytes(), "faults": list(found.faults)}


def _pieces(blocks: Iterator[Signal]) -> Iterator[Signal]:
    speed = np.asarray(SPEED)
    for block in blocks:
        yield replace(block, speed=speed)


def main(arguments: list[str]) -> None:
    """Diagnose a recording for `measure_recording`, or without one measure and print everything."""
    if arguments:
        print(json.dumps(diagnose_file(arguments[0])))
        return
    for measured in (
        partial(measure, DURATION, 5),
        partial(measure_short, 5),
        partial(measure_kurtogram, DURATION, 5),
        partial(measure_synthesis, DURATION, 5),
        partial(measure_tracking, DURATION, 5),
        partial(measure_coherence, DURATION, 2, 3),
        partial(measure_recording, 5.0, 60.0),
    ):
        found = measured()
        for figure in found.figures:
            print(f"{figure.group}, {figure.name.strip()}: {figure.value:.3g} {figure.unit}")
        for failure in found.failures:
            print("Failed:", failure)


if __name__ == "__main__":
    main(sys.argv[1:])
