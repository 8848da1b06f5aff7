"""The options of `rolamento synthesise`, and which fields of a recipe they give."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Final

from rolamento.cli.quantities import Kind, fields_of
from rolamento.errors import InputError

__all__ = ["EXAMPLES", "KINDS", "Asked", "fields_given", "in_option", "named", "options_named"]

KINDS: Final[dict[str, dict[str, Kind]]] = {
    "--fault": {
        "kind": "text",
        "strength": "number",
        "azimuth": "angle",
        "jitter": "number",
        "slip": "text",
        "scatter": "number",
        "modulation": "text",
        "index": "number",
        "inner_gain": "number",
    },
    "--mode": {"frequency": "frequency", "damping": "number", "gain": "acceleration"},
    "--path": {"sensor_azimuth": "angle", "far_gain": "number"},
    "--load": {"kind": "text", "extent": "number", "azimuth": "angle"},
    "--swing": {"depth": "number", "frequency": "frequency", "phase": "angle"},
    "--wander": {"deviation": "number", "memory": "time"},
    "--waviness": {
        "surface": "text",
        "amplitude": "length",
        "first": "whole",
        "last": "whole",
        "slope": "number",
        "direction": "text",
    },
}
"""Keys of the options that give a record by fields. The first may stand alone, but of --path."""
EXAMPLES: Final = {
    "--fault": "--fault inner_race,strength=2,jitter=0.02",
    "--mode": "--mode '3500 Hz,damping=0.03,gain=10'",
    "--path": "--path far_gain=0.3,sensor_azimuth='90 deg'",
    "--load": "--load radial,extent=0.5",
    "--swing": "--swing 0.02,frequency='0.3 Hz'",
    "--wander": "--wander 0.005,memory='2 s'",
    "--waviness": "--waviness outer,amplitude='50 nm',last=60",
    "--snr": "--snr -8",
    "--noise": "--noise '0.5 m/s^2'",
    "--colour": "--colour pink",
    "--slip": "--slip 0.01",
    "--rate": "--rate '51.2 kHz'",
    "--duration": "--duration '10 s'",
    "--load-turns": "--load-turns 1",
    "--shaft-harmonics": "--shaft-harmonics 0.5,0.2",
    "--seed": "--seed 1",
    "--speed": "--speed '1797 rpm'",
}
_OPTIONS: Final = {
    "rate": "--rate",
    "duration": "--duration",
    "seed": "--seed",
    "load_turns": "--load-turns",
    "shaft_harmonics": "--shaft-harmonics",
    "modes": "--mode",
    "modes.frequency": "--mode",
    "faults": "--fault",
    "faults.impacts": "--fault",
    "waviness": "--waviness",
    "waviness.lines": "--waviness",
    "waviness.direction": "--waviness",
    "speed": "--speed",
    "depth": "--swing",
    "frequency": "--swing",
    "deviation": "--wander",
    "memory": "--wander",
}
"""Of fields that the recipe and the synthesis check, the options that give them."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """What the options say, as they were written; speeds in rad/s."""

    bearing: str
    settings: tuple[str, ...] = ()
    inner_speed: float | None = None
    outer_speed: float | None = None
    slip: float = 0.0
    faults: tuple[str, ...] = ()
    jitter: float | None = None
    snr: float | None = None
    noise: str | None = None
    colour: str = "white"
    duration: float = 10.0
    rate: float = 51_200.0
    load: str | None = None
    load_turns: float = 0.0
    swing: str | None = None
    wander: str | None = None
    modes: tuple[str, ...] = ()
    path: str | None = None
    shaft_harmonics: str | None = None
    waviness: tuple[str, ...] = ()
    seed: int = 0


def fields_given(option: str, text: str) -> dict[str, Any]:
    """Return the fields that an option gives, as plain SI values.

    Raises
    ------
    InputError
        If a key is unknown or given twice, or a value is none.
    """
    known = KINDS[option]
    first = "" if option == "--path" else next(iter(known))
    return fields_of(text, option, known, EXAMPLES[option], first=first)


@contextmanager
def in_option(option: str) -> Iterator[None]:
    """Say in which option the field is that is refused."""
    try:
        yield
    except InputError as error:
        if error.source:
            raise
        raise error.with_details(source=option, example=EXAMPLES[option]) from None


@contextmanager
def options_named() -> Iterator[None]:
    """Say which option gave a field of the recipe that is refused."""
    with named(_OPTIONS):
        yield


@contextmanager
def named(options: Mapping[str, str]) -> Iterator[None]:
    """Say which option gave a field, by a table of both."""
    try:
        yield
    except InputError as error:
        if error.source or error.field not in options:
            raise
        option = options[error.field]
        field = error.field.rpartition(".")[2] if option in KINDS else ""
        raise error.with_details(source=option, field=field, example=EXAMPLES[option]) from None
