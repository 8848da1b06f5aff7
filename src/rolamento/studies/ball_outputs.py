"""Outputs of the balls: each by itself, and its greatest, least and mean over the balls."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Final, get_args

import numpy as np

from rolamento.geometry import Race
from rolamento.studies.outputs import Floats, Output, Solved
from rolamento.studies.pressure import greatest_pressure

__all__ = ["RACES", "ball_outputs", "family"]

Get = Callable[[Solved], Floats]

RACES: Final[tuple[Race, ...]] = get_args(Race)
_CONTACT: Final = (
    ("load", "N", "load"),
    ("contact_angle", "rad", "contact angle under load"),
    ("deflection", "m", "approach of ball and groove"),
)
_ELLIPSE: Final = (
    ("semi_major", "m", "semi-axis of the contact ellipse across rolling"),
    ("semi_minor", "m", "semi-axis of the contact ellipse along rolling"),
    ("max_pressure", "Pa", "greatest Hertz pressure"),
    ("mean_pressure", "Pa", "mean Hertz pressure"),
)
_BALL: Final = (
    ("centrifugal_force", "N", "centrifugal force on the ball"),
    ("gyroscopic_moment", "N*m", "gyroscopic moment on the ball, signed"),
)
_MOTION: Final = (
    ("orbital_speed", "rad/s", "speed of the ball about the bearing's axis"),
    ("ball_speed", "rad/s", "speed of the ball about its own axis, signed"),
    ("attitude", "rad", "angle of the ball's axis to the bearing's axis"),
)
_ONLY_LOADED: Final = ("contact_angle", "spin_to_roll")
"""Means nothing at a contact without load, and is left out of what is taken over the balls."""


def ball_outputs() -> tuple[Output, ...]:
    """Return the outputs of the balls."""
    azimuth = Output(
        "azimuth", "rad", "azimuth of the ball", lambda solved: solved.balls.azimuth, per_ball=True
    )
    return (azimuth, *_of_contacts(), *_of_balls())


def _of_contacts() -> Iterator[Output]:
    for race in RACES:
        for name, unit, words in _CONTACT:
            yield from family(
                f"{race}_{name}", unit, f"{words}, {race} race", _contact(race, name), race
            )
        for name, unit, words in _ELLIPSE:
            yield from family(
                f"{race}_{name}", unit, f"{words}, {race} race", _ellipse(race, name), race
            )
        name = f"{race}_spin_to_roll"
        yield from family(name, "1", f"ratio of spin to roll, {race} race", _motion(name), race)


def _of_balls() -> Iterator[Output]:
    for name, unit, words in _BALL:
        yield from family(name, unit, words, _ball(name), None)
    for name, unit, words in _MOTION:
        yield from family(name, unit, words, _motion(name), None)


def family(
    name: str, unit: str, words: str, get: Get, race: Race | None, needs: tuple[str, ...] = ()
) -> Iterator[Output]:
    """Make an output per ball, and what is taken of it over the balls.

    race: whose loads tell which balls count, for outputs that mean nothing without load.
    """
    yield Output(name, unit, words, get, per_ball=True, needs=needs)
    among = race if name.endswith(_ONLY_LOADED) else None
    over = "loaded balls" if among else "balls"
    for prefix, word, reduce in _REDUCTIONS:
        compute = _reduced(get, reduce, among)
        if prefix == "max" and race is not None and name.endswith("_max_pressure"):
            compute = _greatest_pressure(race)
        yield Output(
            f"{prefix}_{name}", unit, f"{words}: {word} of the {over}", compute, needs=needs
        )


def _contact(race: Race, name: str) -> Get:
    return lambda solved: getattr(solved.contacts(race), name)


def _ellipse(race: Race, name: str) -> Get:
    return lambda solved: getattr(solved.hertz(race), name)


def _ball(name: str) -> Get:
    return lambda solved: getattr(solved.balls, name)


def _motion(name: str) -> Get:
    return lambda solved: getattr(solved.balls.motion, name)


def _greatest_pressure(race: Race) -> Get:
    return lambda solved: greatest_pressure(solved, race)


def _reduced(get: Get, reduce: Callable[[Floats], Floats], race: Race | None) -> Get:
    """Take something over the balls; over those that a race loads, if one is named."""

    def reduced(solved: Solved) -> Floats:
        values = get(solved)
        if race is not None:
            values = np.where(solved.contacts(race).load > 0.0, values, np.nan)
        return reduce(values)

    return reduced


def _greatest(values: Floats) -> Floats:
    return np.asarray(np.fmax.reduce(values, axis=1))


def _least(values: Floats) -> Floats:
    return np.asarray(np.fmin.reduce(values, axis=1))


def _mean(values: Floats) -> Floats:
    """Mean of what is there; NaN where nothing is."""
    there = ~np.isnan(values)
    count = there.sum(axis=1)
    total = np.where(there, values, 0.0).sum(axis=1)
    mean = np.full(len(values), np.nan)
    np.divide(total, count, out=mean, where=count > 0)
    return mean


_REDUCTIONS: Final = (
    ("max", "greatest", _greatest),
    ("min", "least", _least),
    ("mean", "mean", _mean),
)
