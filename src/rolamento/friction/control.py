"""Which race holds a ball, for the models that need one, and how the ball then moves."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from rolamento.errors import InputError
from rolamento.friction.loaded_balls import LoadedBalls
from rolamento.kinematics import BallMotion, ball_motion, spin_resistance

ControlChoice = Literal["jones", "state", "inner", "outer"]

_CHOICES = ("jones", "state", "inner", "outer")


def controlling_race(balls: LoadedBalls, control: ControlChoice) -> NDArray[np.int64]:
    """Tell which race each ball rolls on without spin: 1 outer, -1 inner; (cases, balls).

    control: "inner", "outer"; "state", as the state was solved; "jones", the race with the
    greater resistance to spin Q a E. Where the state's control is undecided, Jones's is taken.

    Raises
    ------
    InputError
        For any other word.
    """
    if control not in _CHOICES:
        raise InputError(
            f"must be one of {', '.join(_CHOICES)}",
            field="control",
            value=control,
            example='control = "jones"',
        )
    shape = balls.loaded.shape
    if control in ("inner", "outer"):
        return np.full(shape, 1 if control == "outer" else -1, dtype=np.int64)
    jones = np.where(_resistance(balls, "outer") > _resistance(balls, "inner"), 1, -1)
    if control == "jones":
        return jones.astype(np.int64)
    return np.where(balls.control != 0, balls.control, jones).astype(np.int64)


def unit_motion(balls: LoadedBalls, control: NDArray[np.int64]) -> BallMotion:
    """Motion under raceway control for a unit speed of the inner ring relative to the outer.

    Seen from the outer ring; arrays (cases, balls), rad/s.
    """
    return ball_motion(
        balls.inner.contact_angle,
        balls.outer.contact_angle,
        balls.inner.ball_diameter / balls.inner.pitch_diameter,
        1.0,
        0.0,
        control,
    )


def _resistance(balls: LoadedBalls, race: Literal["inner", "outer"]) -> NDArray[np.float64]:
    patch = balls.patch(race)
    touching = patch.load > 0.0
    ratio = np.where(touching, patch.semi_major, 1.0) / np.where(touching, patch.semi_minor, 1.0)
    return spin_resistance(patch.load, patch.semi_major, ratio)
