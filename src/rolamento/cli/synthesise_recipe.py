"""From the options of `rolamento synthesise` to a recipe; each is named after a field of it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import nan
from typing import TYPE_CHECKING, Any, Final, Literal

import rolamento
from rolamento.cli.bearing_case import case_of, has_load
from rolamento.cli.quantities import number_of
from rolamento.cli.synthesise_options import (
    EXAMPLES,
    Asked,
    fields_given,
    in_option,
    named,
    options_named,
)
from rolamento.errors import InputError
from rolamento.vibration.frequencies import frequencies_of, nominal_frequencies
from rolamento.vibration.synthesis import (
    DEFAULT_MODES,
    Fault,
    LoadDistribution,
    Mode,
    Noise,
    Recipe,
    SpeedProfile,
    SwingingSpeed,
    TransferPath,
    WanderingSpeed,
    Waviness,
    waviness_lines,
)

if TYPE_CHECKING:
    from rolamento.state import State
    from rolamento.vibration.frequencies import FaultFrequencies

__all__ = [
    "MOST_SAMPLES",
    "Asked",
    "Given",
    "given_of",
    "load_name",
    "options_named",
    "recipe_from",
]

MOST_SAMPLES: Final = 20_000_000
"""Of a signal that is made at once: 1.6 GB of memory."""
_MOST_FAULTS: Final = 20

_MOST_RINGING: Final = 400_000_000
_MOST_WAVING: Final = 5_000_000_000
"""Samples, times faults and modes, and times lines: each takes about two minutes."""

LoadName = Literal["uniform", "radial", "solved"]
_LOADS: Final[tuple[LoadName, ...]] = ("uniform", "radial", "solved")
_EXTENT: Final = 0.5
"""ε of a radial load without clearance."""


@dataclass(frozen=True, slots=True)
class Given:
    """The bearing: its case, the solved state if it has a load, and its frequencies."""

    name: str
    case: rolamento.Case
    state: State | None
    frequencies: FaultFrequencies


def given_of(asked: Asked) -> Given:
    """Return the bearing that is asked for; a case with a load is solved.

    Raises
    ------
    InputError, FileError
        If there is none, or nothing turns.
    """
    case = case_of(asked.bearing, asked.settings, asked.inner_speed, asked.outer_speed)
    inner, outer = case.duty.inner_speed, case.duty.outer_speed
    if inner == outer:
        raise InputError(
            "is missing: nothing turns" if inner == 0.0 else "is that of both rings: no ball rolls",
            source="--speed",
            example=EXAMPLES["--speed"],
        )
    name = case.title or asked.bearing
    with named({"slip": "--slip"}):
        if not has_load(case):
            found = nominal_frequencies(case.bearing, inner, outer, slip=asked.slip)
            return Given(name, case, None, found)
        state = rolamento.solve(case)
        return Given(name, case, state, frequencies_of(state, slip=asked.slip))


def recipe_from(asked: Asked, given: Given) -> Recipe:
    """Return the recipe of a signal.

    Parameters
    ----------
    asked
        The options.
    given
        The bearing; a state has to have converged.

    Raises
    ------
    InputError
        If an option is none, or the signal would be silent or too long.
    """
    if len(asked.faults) > _MOST_FAULTS:
        raise InputError(f"may be given {_MOST_FAULTS} times at most", source="--fault")
    faults = tuple(_fault(text, asked.jitter) for text in asked.faults)
    noise = _noise(asked)
    if not (faults or asked.waviness or asked.shaft_harmonics or noise):
        raise InputError(
            "would be silent: give --fault, --waviness, --shaft-harmonics or --noise",
            field="signal",
            example="--fault inner_race --snr -8",
        )
    if not asked.duration * asked.rate <= MOST_SAMPLES:
        raise InputError(
            f"gives more than {MOST_SAMPLES} samples at this rate",
            source="--duration",
            value=f"{asked.duration:g} s",
            example=EXAMPLES["--duration"],
        )
    with options_named():
        recipe = Recipe(
            frequencies=replace(given.frequencies, rows=()),
            speed=_profile(asked, given.frequencies),
            duration=asked.duration,
            rate=asked.rate,
            faults=faults,
            load=_load(asked.load, given),
            load_turns=asked.load_turns,
            path=_path(asked.path),
            modes=tuple(_mode(text) for text in asked.modes) or DEFAULT_MODES,
            shaft_harmonics=_harmonics(asked.shaft_harmonics),
            waviness=tuple(_waviness(text) for text in asked.waviness),
            noise=noise,
            seed=asked.seed,
            title=f"synthetic, {given.name}"[:300],
        )
        _check_work(recipe)
    return recipe


def _check_work(recipe: Recipe) -> None:
    """Refuse what would take many minutes."""
    lines = sum(len(waviness_lines(recipe.frequencies, wavy)) for wavy in recipe.waviness)
    waving = recipe.count * (lines + len(recipe.shaft_harmonics))
    if recipe.count * len(recipe.faults) * len(recipe.modes) > _MOST_RINGING:
        option, what = "--duration", "faults and modes"
    elif waving > _MOST_WAVING:
        option, what = "--waviness", "lines"
    else:
        return
    raise InputError(
        f"would take too long: {recipe.count} samples with so many {what}",
        source=option,
        example=EXAMPLES[option],
    )


def _fault(text: str, jitter: float | None) -> Fault:
    fields = fields_given("--fault", text)
    fields["kind"] = fields["kind"].replace("-", "_")
    if jitter is not None:
        fields.setdefault("jitter", jitter)
    with in_option("--fault"):
        return Fault(**fields)


def _noise(asked: Asked) -> Noise | None:
    if asked.snr is None and asked.noise is None:
        return None
    if asked.snr is not None and asked.noise is not None:
        raise InputError("give one of --snr and --noise, not both", source="--snr")
    of = "faults" if asked.faults else "signal"
    fields: dict[str, Any] = {"colour": asked.colour, "of": of}
    if asked.noise is not None:
        fields["level"] = number_of(asked.noise, "--noise", "acceleration", EXAMPLES["--noise"])
    elif asked.faults or asked.waviness or asked.shaft_harmonics:
        fields["ratio"] = asked.snr
    else:
        raise InputError(
            "is a ratio to faults, waviness or harmonics of the shaft, and there are none; for"
            " noise alone give --noise",
            source="--snr",
            example=EXAMPLES["--noise"],
        )
    with named({"ratio": "--snr", "level": "--noise", "colour": "--colour"}):
        return Noise(**fields)


def _profile(asked: Asked, found: FaultFrequencies) -> SpeedProfile | None:
    """Speed of the shaft; None where it is steady."""
    if asked.swing is not None and asked.wander is not None:
        raise InputError("give one of --swing and --wander, not both", source="--swing")
    mean = found.inner_speed if found.shaft == "inner" else found.outer_speed
    if asked.swing is not None:
        fields = fields_given("--swing", asked.swing)
        fields.setdefault("frequency", 0.3)
        return SwingingSpeed(mean, **fields)
    if asked.wander is not None:
        fields = fields_given("--wander", asked.wander)
        fields.setdefault("memory", 2.0)
        return WanderingSpeed(mean, **fields)
    return None


def load_name(asked: Asked, given: Given) -> tuple[LoadName, float]:
    """Return the name of the load distribution, and ε of a radial one; NaN of others."""
    name, fields = _load_fields(asked.load, given)
    return name, fields.get("extent", _EXTENT) if name == "radial" else nan


def _load_fields(text: str | None, given: Given) -> tuple[LoadName, dict[str, float]]:
    default = "uniform" if given.state is None else "solved"
    fields = fields_given("--load", default if text is None else text)
    kind = next((name for name in _LOADS if name == fields["kind"]), None)
    del fields["kind"]
    if kind is None or (fields and kind != "radial"):
        rule = f"must be one of {', '.join(_LOADS)}; of radial with extent and azimuth"
        raise InputError(rule, source="--load", value=text, example=EXAMPLES["--load"])
    return kind, fields


def _load(text: str | None, given: Given) -> LoadDistribution:
    kind, fields = _load_fields(text, given)
    if kind == "uniform":
        return LoadDistribution.uniform()
    if kind == "radial":
        with in_option("--load"):
            return LoadDistribution.radial(**{"extent": _EXTENT, **fields})
    if given.state is None:
        raise InputError(
            "needs a case file with a load", source="--load", value=kind, example="--load radial"
        )
    return LoadDistribution.of_state(given.state, row=given.frequencies.row)


def _mode(text: str) -> Mode:
    with in_option("--mode"):
        return Mode(**fields_given("--mode", text))


def _path(text: str | None) -> TransferPath:
    if text is None:
        return TransferPath()
    with in_option("--path"):
        return TransferPath(**fields_given("--path", text))


def _harmonics(text: str | None) -> tuple[float, ...]:
    if text is None:
        return ()
    example = EXAMPLES["--shaft-harmonics"]
    parts = text.split(",")[:1000]
    return tuple(number_of(part, "--shaft-harmonics", "acceleration", example) for part in parts)


def _waviness(text: str) -> Waviness:
    fields = fields_given("--waviness", text)
    if "amplitude" not in fields:
        raise InputError(
            "is missing", source="--waviness", field="amplitude", example=EXAMPLES["--waviness"]
        )
    with in_option("--waviness"):
        return Waviness.falling(**fields)
