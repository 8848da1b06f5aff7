"""A vibration signal of a bearing with known damage, written with its truth."""

from __future__ import annotations

import os
import shlex
from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from functools import cached_property
from math import isfinite, log10, nan, pi, sqrt
from typing import TYPE_CHECKING, Any, Final, Literal, NamedTuple

import numpy as np

from rolamento.case import case_of
from rolamento.case.bearing import Bearing
from rolamento.case.case import BearingLike, name_of
from rolamento.case.fields import Changes
from rolamento.case.roller_bearing import RollerBearing
from rolamento.errors import InputError, arguments
from rolamento.io.json import dumps
from rolamento.io.writing import write_text
from rolamento.records import frozen
from rolamento.tasks.bearing import at_speeds, has_load
from rolamento.tasks.parameters import speed_of
from rolamento.units import rpm_of
from rolamento.vibration.frequencies import FaultFrequencies, frequencies_of, nominal_frequencies
from rolamento.vibration.synthesis import (
    DEFAULT_MODES,
    Fault,
    FaultTruth,
    GivenSpeed,
    LoadDistribution,
    Mode,
    Noise,
    Recipe,
    SpeedProfile,
    SteadySpeed,
    Synthesis,
    TransferPath,
    Waviness,
    waviness_lines,
)
from rolamento.vibration.synthesis import synthesise as signal_of
from rolamento.vibration.writing import check_signal_name, write_signal
from rolamento.words import Note, said
from rolamento.words.naming import of_element

if TYPE_CHECKING:
    from rolamento.solved import Solved

SCHEMA: Final = 3
_MOST_IMPACTS: Final = 1_000_000
"""In a file of truth."""
MOST_SAMPLES: Final = 20_000_000
"""Maximum number of samples of a signal that is made at once: 1.6 GB of memory."""
_MOST_FAULTS: Final = 20

_MOST_RINGING: Final = 400_000_000
_MOST_WAVING: Final = 5_000_000_000
"""Samples, times faults and modes, and times lines: each takes about two minutes."""

LoadName = Literal["uniform", "radial", "solved"]

_TURN: Final = 2.0 * pi


class PlantedFault(NamedTuple):
    """What a fault makes: impacts with any force, power over the noise's (dB)."""

    fault: Fault
    truth: FaultTruth
    impacts: int
    to_noise: float


class PlantedLine(NamedTuple):
    """A line of a wavy surface or the shaft: waves a turn, order, Hz, amplitude (m), RMS (m/s²)."""

    source: Literal["outer", "inner", "ball", "shaft"]
    waves: int
    order: float
    frequency: float
    amplitude: float
    rms: float


@frozen(eq=False, slots=False)
class SynthesisResult:
    """A synthetic signal with its truth, and where both were written; or why there is none.

    Attributes
    ----------
    name
        designation or title of the case
    source
        what the bearing was given as
    bearing
        whose vibration this is
    solved
        the case, if it has a load; without a solution there is no signal
    load, extent
        name of the load distribution; ε of a radial one
    path, truth_path
        where signal and truth were written; "" and None if they were not
    synthesis
        the signal and its truth, as `made`; None without a solution
    """

    name: str
    source: str
    bearing: Bearing | RollerBearing
    load: LoadName
    extent: float
    path: str
    truth_path: str | None
    solved: Solved | None = None
    synthesis: Synthesis | None = None

    @property
    def status(self) -> str:
        """Whether there is a signal: "made", or the status of a case without a solution."""
        solved = self.solved
        return "made" if solved is None or solved.converged[0] else str(solved.status.code[0])

    @property
    def made(self) -> Synthesis:
        """The signal and its truth.

        Raises
        ------
        InputError
            If the case has no solution.
        """
        if self.synthesis is None:
            raise InputError(said("has no signal: its load has no solution"), source=self.name)
        return self.synthesis

    @property
    def recipe(self) -> Recipe:
        """That the signal was made by."""
        return self.made.truth.recipe

    @cached_property
    def rms(self) -> float:
        """RMS of the signal; m/s²."""
        return sqrt(float(np.mean(np.square(self.made.signal.samples))))

    @cached_property
    def faults(self) -> tuple[PlantedFault, ...]:
        """What each fault makes."""
        truth = self.made.truth
        found = []
        for fault, told in zip(self.recipe.faults, truth.faults, strict=True):
            struck = int(np.count_nonzero(told.strengths > 0.0))
            to_noise = _decibels(told.rms, truth.noise_level)
            found.append(PlantedFault(fault, told, struck, to_noise))
        return tuple(found)

    @cached_property
    def lines(self) -> tuple[PlantedLine, ...]:
        """Lines of waviness and of the shaft, the strongest first."""
        shaft = abs(float(np.mean(self.made.truth.speed))) / _TURN
        found = [
            PlantedLine(
                line.surface, line.waves, line.order, line.order * shaft, line.amplitude,
                line.amplitude * (_TURN * line.order * shaft) ** 2 / sqrt(2.0),
            )
            for line in self.made.truth.waviness_lines
        ]  # fmt: skip
        for order, size in enumerate(self.recipe.shaft_harmonics, start=1):
            place = order * shaft
            amplitude = size / (_TURN * place) ** 2
            found.append(
                PlantedLine("shaft", order, float(order), place, amplitude, size / sqrt(2.0))
            )
        return tuple(sorted(found, key=lambda line: -line.rms))

    @property
    def steady(self) -> bool:
        """Whether the shaft keeps its speed."""
        return self.recipe.speed is None or isinstance(self.recipe.speed, SteadySpeed)

    @property
    def notes(self) -> tuple[Note, ...]:
        """What is to be known of it."""
        notes, kinds = [], [one.fault.kind for one in self.faults if not one.impacts]
        if kinds:
            notes.append(Note("damage_not_struck", {"parts": list(dict.fromkeys(kinds))}))
        if any(one.fault.modulation == "frequency" for one in self.faults):
            notes.append(Note("frequency_modulation"))
        if "inferred" in self.bearing.origins.values():
            notes.append(Note("signal_of_estimated_geometry"))
        element = self.recipe.frequencies.rolling_element
        if self.recipe.waviness and element == "roller":
            notes.append(Note("waviness_of_rollers"))
        return tuple(of_element(note, element) for note in notes)

    def truth(self) -> dict[str, Any]:
        """Return the truth and the recipe as plain data, in SI units, Hz and dB.

        Raises
        ------
        InputError
            If it would be very long.
        """
        recipe, truth = self.recipe, self.made.truth
        if sum(len(one.times) for one in truth.faults) > _MOST_IMPACTS:
            rule = said("would hold more than {most} impacts", most=_MOST_IMPACTS)
            raise InputError(rule, field="truth", value=self.truth_path)
        return {
            "schema": SCHEMA,
            "kind": "synthesis",
            "bearing": self.name,
            "file": self.path,
            "unit": self.made.signal.unit,
            "rms": self.rms,
            **truth.to_mapping(),
            "faults": [{**one.truth.to_mapping(), "to_noise": one.to_noise} for one in self.faults],
            "recipe": {
                "faults": [asdict(fault) for fault in recipe.faults],
                "load": {"kind": self.load, "extent": self.extent},
                "load_turns": recipe.load_turns,
                "path": asdict(recipe.path),
                "modes": [asdict(mode) for mode in recipe.modes],
                "shaft_harmonics": list(recipe.shaft_harmonics),
                "waviness": [asdict(one) for one in recipe.waviness],
                "noise": None if recipe.noise is None else asdict(recipe.noise),
                "speed": self._speed_profile(),
            },
        }

    def _speed_profile(self) -> dict[str, Any]:
        profile = self.recipe.speed
        if profile is None or isinstance(profile, GivenSpeed):
            return {"kind": "SteadySpeed", "speed": float(np.mean(self.made.truth.speed))}
        return {"kind": type(profile).__name__, **asdict(profile)}

    @property
    def command(self) -> str:
        """How to have the signal diagnosed; what its file says is left out."""
        words = ["rolamento", "diagnose", self.path, "--bearing", self.source]
        found = self.recipe.frequencies
        if self.path.lower().endswith(".wav") or found.outer_speed != 0.0:
            words += ["--speed", f"{rpm_of(found.inner_speed):.6g} rpm"]
        if found.outer_speed != 0.0:
            words += ["--outer-speed", f"{rpm_of(found.outer_speed):.6g} rpm"]
        return shlex.join(words)


def synthesise(
    bearing: BearingLike,
    path: str | os.PathLike[str] | None = None,
    *,
    speed: str | float | None = None,
    outer_speed: str | float | None = None,
    slip: float = 0.0,
    faults: Sequence[Fault] = (),
    load: LoadName | None = None,
    extent: float = 0.5,
    load_azimuth: float = 0.0,
    load_turns: float = 0.0,
    speed_profile: Callable[[float], SpeedProfile] | None = None,
    transfer: TransferPath | None = None,
    modes: Sequence[Mode] = DEFAULT_MODES,
    shaft_harmonics: Sequence[float] = (),
    waviness: Sequence[Waviness] = (),
    noise: Noise | None = None,
    duration: float = 10.0,
    rate: float = 51_200.0,
    seed: int = 0,
    truth_path: str | os.PathLike[str] | None = None,
    changes: Changes = (),
) -> SynthesisResult:
    """Make a vibration signal of a bearing, and write it with all that is known of it.

    Parameters
    ----------
    bearing
        Designation, case file or case; a case with a load is solved.
    path
        A .wav, .csv or .npz file; nothing is written by default.
    speed, outer_speed
        Of the rings: text such as "1797 rpm", or rad/s; by default those of the case.
    slip
        Part of the cage's speed against the outer ring that it lags behind.
    faults
        Damage.
    load, extent, load_azimuth
        That the strengths of impacts go with: "uniform"; "radial", with ε of the load zone and the
        direction (rad); or "solved", of a case with a load, and then the default.
    load_turns, modes, shaft_harmonics, waviness, duration, rate, seed
        As of a `Recipe`.
    speed_profile
        Gives the speed over time from its mean (rad/s), such as ``partial(SwingingSpeed,
        depth=0.02, frequency=0.3)``; steady by default.
    transfer
        From the impacts to the sensor.
    noise
        Beside all that.
    truth_path
        A file of JSON.
    changes
        What goes over the case, by dotted name, such as ``{"duty.load.fz": "5 kN"}``.

    Returns
    -------
    SynthesisResult
        Its `status` says whether the case has a solution, and so a signal.

    Raises
    ------
    FileError, InputError
        If there is no such bearing, nothing turns, a parameter is out of range, the signal would
        be silent or too long, or cannot be written.
    """
    given = speed_of(speed, "speed"), speed_of(outer_speed, "outer_speed")
    case = at_speeds(case_of(bearing, changes), *given)
    inner, outer = case.duty.inner_speed, case.duty.outer_speed
    if inner == outer:
        raise InputError(
            (
                said("is missing: nothing rotates")
                if inner == 0.0
                else said("is that of both rings: nothing rolls")
            ),
            field="speed",
            example=arguments(speed="1797 rpm"),
        )
    solved: Solved | None = None
    if has_load(case):
        from rolamento.solution import solve

        solved = solve(case)
    kind = load or ("uniform" if solved is None else "solved")
    name = name_of(bearing, case)
    found = SynthesisResult(
        name=name,
        source=os.fspath(bearing) if isinstance(bearing, str | os.PathLike) else name,
        bearing=case.bearing,
        load=kind,
        extent=extent if kind == "radial" else nan,
        path="" if path is None else os.fspath(path),
        truth_path=None if truth_path is None else os.fspath(truth_path),
        solved=solved,
    )
    if solved is None:
        frequencies = nominal_frequencies(case.bearing, inner, outer, slip=slip)
    elif not solved.converged[0]:
        return found
    else:
        frequencies = frequencies_of(solved, slip=slip)
    _check_size(faults, waviness, shaft_harmonics, noise, duration, rate)
    mean = frequencies.inner_speed if frequencies.shaft == "inner" else frequencies.outer_speed
    recipe = Recipe(
        frequencies=replace(frequencies, rows=()),
        speed=None if speed_profile is None else speed_profile(mean),
        duration=duration,
        rate=rate,
        faults=tuple(faults),
        load=_distribution(kind, extent, load_azimuth, solved, frequencies),
        load_turns=load_turns,
        path=transfer or TransferPath(),
        modes=tuple(modes) or DEFAULT_MODES,
        shaft_harmonics=tuple(shaft_harmonics),
        waviness=tuple(waviness),
        noise=noise,
        seed=seed,
        title=f"synthetic, {name}"[:300],
    )
    _check_work(recipe)
    if path is not None:
        check_signal_name(path, recipe.count, recipe.rate)
    made = signal_of(recipe)
    _refuse_silence(made)
    found = replace(found, synthesis=made)
    truth = None if truth_path is None else dumps(found.truth(), indent=2) + "\n"
    if path is not None:
        write_signal(made.signal, path)
    if truth_path is not None and truth is not None:
        write_text(truth, truth_path)
    return found


def _check_size(
    faults: Sequence[Fault],
    waviness: Sequence[Waviness],
    shaft_harmonics: Sequence[float],
    noise: Noise | None,
    duration: float,
    rate: float,
) -> None:
    """Refuse what would be silent, or too much for memory."""
    if len(faults) > _MOST_FAULTS:
        raise InputError(
            said("may be at most {most}", most=_MOST_FAULTS), field="faults", value=len(faults)
        )
    if not (faults or waviness or shaft_harmonics or noise):
        raise InputError(
            said("would be silent: give faults=…, waviness=…, shaft_harmonics=… or noise=…"),
            field="signal",
            example=arguments(faults=..., noise=...),
        )
    if not duration * rate <= MOST_SAMPLES:
        raise InputError(
            said("gives more than {most} samples at this rate", most=MOST_SAMPLES),
            field="duration",
            value=f"{duration:g} s",
            example=arguments(duration=10),
        )


def _distribution(
    kind: LoadName,
    extent: float,
    azimuth: float,
    solved: Solved | None,
    frequencies: FaultFrequencies,
) -> LoadDistribution:
    if kind == "uniform":
        return LoadDistribution.uniform()
    if kind == "radial":
        return LoadDistribution.radial(
            extent=extent, azimuth=azimuth, element=frequencies.rolling_element
        )
    if kind != "solved":
        rule = said("must be one of uniform, radial, solved")
        raise InputError(rule, field="load", value=kind, example=arguments(load="radial"))
    if solved is None:
        raise InputError(
            said("needs a case file with a load"),
            field="load",
            value=kind,
            example=arguments(load="radial"),
        )
    return LoadDistribution.of_solved(solved, row=frequencies.row)


def _check_work(recipe: Recipe) -> None:
    """Refuse what would take many minutes."""
    lines = sum(len(waviness_lines(recipe.frequencies, wavy)) for wavy in recipe.waviness)
    waving = recipe.count * (lines + len(recipe.shaft_harmonics))
    if recipe.count * len(recipe.faults) * len(recipe.modes) > _MOST_RINGING:
        rule = said(
            "would take too long: {count} samples with this many faults and modes",
            count=recipe.count,
        )
        raise InputError(rule, field="duration")
    if waving > _MOST_WAVING:
        rule = said("would take too long: {count} samples with this many lines", count=recipe.count)
        raise InputError(rule, field="waviness")


def _refuse_silence(made: Synthesis) -> None:
    """Refuse a ratio to faults that are never struck, and a signal without anything in it."""
    recipe = made.truth.recipe
    struck = any((one.strengths > 0.0).any() for one in made.truth.faults)
    has_ratio = recipe.noise is not None and recipe.noise.ratio is not None
    if recipe.faults and has_ratio and made.truth.noise_level == 0.0 and not struck:
        raise InputError(
            said(
                "is the ratio to faults without any impact: no rolling element is "
                "loaded where they are, or the signal is too short"
            ),
            field="ratio",
            value=recipe.noise.ratio if recipe.noise else None,
        )
    if not made.signal.samples.any():
        rule = said("is silent: no part of it has any amplitude")
        if recipe.faults:
            rule = said(
                "is silent: no rolling element is loaded where the damage lies, or the signal is "
                "too short"
            )
        raise InputError(rule, field="signal", example=arguments(load="uniform"))


def _decibels(rms: float, noise: float) -> float:
    if not (rms > 0.0 and noise > 0.0 and isfinite(rms)):
        return nan
    return 20.0 * log10(rms / noise)
