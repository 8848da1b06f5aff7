"""Outputs of friction: torque and power by each model, losses and pressure times slip.

Torques are running torques of all sources: the contacts by the model, elastic hysteresis and,
where the case has an oil and its temperature, the oil's rolling resistance; those of the contacts
of each ball are taken with the motion as it was solved.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.geometry import Race
from rolamento.studies.ball_outputs import RACES, family
from rolamento.studies.outputs import Floats, Output, Solved

if TYPE_CHECKING:
    from rolamento.friction.slip import Patch, RelativeMotion

__all__ = ["friction_outputs", "greatest_product"]

_COEFFICIENT: Final = ("lubricant.friction_coefficient",)
_OIL: Final = ("lubricant", "temperature.lubricant")
_POINTS: Final = 41
_ZOOMS: Final = 4
_SHRINKING: Final = 0.1
_BLOCK: Final = 2048
"""Contacts at a time."""


def friction_outputs() -> tuple[Output, ...]:
    """Return the outputs of friction."""
    return (
        *_of_models(),
        Output(
            "hysteresis_torque",
            "N*m",
            "friction torque by elastic hysteresis",
            _source("hysteresis"),
            needs=_COEFFICIENT,
        ),
        Output(
            "rolling_resistance_torque",
            "N*m",
            "friction torque by the oil at the inlets",
            _source("rolling_resistance"),
            needs=(*_COEFFICIENT, *_OIL),
        ),
        *_of_control(),
        *_of_contacts(),
    )


def _of_models() -> Iterator[Output]:
    from rolamento.friction import CONTACT_MODELS, TORQUE_MODELS

    for model in CONTACT_MODELS:
        known = TORQUE_MODELS[model]
        for name, unit in (("torque", "N*m"), ("power", "W")):
            yield Output(
                f"friction_{name}_{model}",
                unit,
                f"friction {name} by {known.long_title}",
                _total(model, name),
                needs=_COEFFICIENT,
                slow=not known.closed_form,
            )


def _of_control() -> Iterator[Output]:
    """What friction control finds, where the case is solved with it."""
    for name, unit, words, compute in (
        ("rolling_power", "W", "power lost in the contacts", _rolling_power),
        ("cage_speed", "rad/s", "speed of the cage", _cage_speed),
    ):
        yield Output(
            name, unit, f"{words} under friction control", compute, needs=("friction control",)
        )


def _of_contacts() -> Iterator[Output]:
    for race in RACES:
        yield from family(
            f"{race}_spin_loss",
            "W",
            f"power lost by spin, {race} race",
            _spin_loss(race),
            None,
            _COEFFICIENT,
        )
        yield from family(
            f"{race}_pressure_slip",
            "W/m^2",
            f"greatest product of pressure and slip, {race} race",
            _pressure_slip(race),
            None,
            (),
        )


def _total(model: str, attribute: str) -> Callable[[Solved], Floats]:
    def compute(solved: Solved) -> Floats:
        values: Floats = getattr(solved.friction(model), attribute)
        return np.where(solved.has_friction, values, np.nan)

    return compute


def _source(name: str) -> Callable[[Solved], Floats]:
    def compute(solved: Solved) -> Floats:
        found = solved.friction("jones_simplified").torque_by_source.get(name)
        return np.where(solved.has_friction, np.nan if found is None else found, np.nan)

    return compute


def _rolling_power(solved: Solved) -> Floats:
    rolling = solved.batch.rows[0].rolling
    if rolling is None:
        return np.full(len(solved.batch), np.nan)
    return np.where(solved.batch.converged, rolling.power.sum(axis=(1, 2)), np.nan)


def _cage_speed(solved: Solved) -> Floats:
    rolling = solved.batch.rows[0].rolling
    if rolling is None:
        return np.full(len(solved.batch), np.nan)
    return np.where(solved.batch.converged, rolling.cage_speed, np.nan)


def _spin_loss(race: Race) -> Callable[[Solved], Floats]:
    """M_s |ω_s| with the spin as it was solved; 0 at a race that a ball rolls on without spin."""

    def compute(solved: Solved) -> Floats:
        from rolamento.friction.closed_forms import spin_moment

        motion = solved.balls.motion
        spin = motion.inner_spin if race == "inner" else motion.outer_spin
        mu = solved.friction_coefficient[:, np.newaxis]
        balls = solved.loaded_balls
        loss = spin_moment(balls.patch(race), mu) * np.abs(spin)
        return np.where(balls.loaded, loss, np.where(np.isnan(balls.outer.load), np.nan, 0.0))

    return compute


def _pressure_slip(race: Race) -> Callable[[Solved], Floats]:
    def compute(solved: Solved) -> Floats:
        from rolamento.friction.slip import BallVelocity, relative_motion

        balls = solved.loaded_balls
        patch = balls.patch(race)
        yaw = solved.balls.yaw
        across = balls.ball_speed * np.cos(balls.attitude)
        ball = BallVelocity(
            across * np.cos(yaw),
            across * np.sin(yaw),
            -balls.ball_speed * np.sin(balls.attitude),
        )
        motion = relative_motion(patch, ball, balls.ring_speed(race))
        value = greatest_product(patch, motion)
        touching = np.where(np.isnan(balls.outer.load), np.nan, 0.0)
        return np.where(balls.loaded, value, touching)

    return compute


def greatest_product(patch: Patch, motion: RelativeMotion) -> Floats:
    """Return the greatest product p·v of each contact; W/m², NaN without a contact.

    For a ball that does not tumble, v² = v_y(u)² + (b ω_n v)² at u = x0/a, v = y0/b, and over v
    (1 - u² - v²)(A² + B² v²) is greatest at v² = max(0, ((1 - u²) B² - A²)/(2 B²)): only u is left
    to be searched. Where balls tumble, the whole ellipse is searched.
    """
    from rolamento.friction.slip import RelativeMotion, maximum_pressure_slip

    shape = patch.load.shape
    flat = patch.mapped(np.ravel)
    columns = [np.ravel(a) for a in (motion.drift, motion.roll, motion.twist, motion.tumble)]
    tumbles = bool(np.any(np.nan_to_num(columns[3]) != 0.0))
    found = np.full(flat.load.size, np.nan)
    size = _BLOCK // 16 if tumbles else _BLOCK
    (contacts,) = np.nonzero(flat.load > 0.0)
    for first in range(0, contacts.size, size):
        some = contacts[first : first + size]
        part = flat.mapped(lambda array, chosen=some: array[chosen])  # type: ignore[misc]
        drift, roll, twist, tumble = (column[some] for column in columns)
        own = RelativeMotion(drift, roll, twist, tumble, motion.side)
        if tumbles:
            found[some] = maximum_pressure_slip(part, own).value
        else:
            found[some] = _without_tumbling(part, own)
    return found.reshape(shape)


def _without_tumbling(patch: Patch, motion: RelativeMotion) -> Floats:
    """The greatest product of contacts (contacts,): a grid over u, then grids about its best."""
    points = patch.at_points()
    drift, roll, twist = (
        array[:, np.newaxis] for array in (motion.drift, motion.roll, motion.twist)
    )
    across = (points.semi_minor * twist) ** 2
    steps, centre, width = np.linspace(-1.0, 1.0, _POINTS), np.zeros((patch.load.size, 1)), 1.0
    best = np.zeros(patch.load.size)
    for _ in range(_ZOOMS):
        u = np.clip(centre + width * steps, -1.0, 1.0)
        rolling = drift + motion.side * points.rolling_radius(u) * roll
        along = (rolling - points.semi_major * u * twist) ** 2
        room = 1.0 - u**2
        with np.errstate(divide="ignore", invalid="ignore"):
            square = np.where(across > 0.0, 0.5 * (room - along / across), 0.0)
        square = np.clip(square, 0.0, room)
        product = (room - square) * (along + across * square)
        place = np.argmax(product, axis=1)[:, np.newaxis]
        centre = np.take_along_axis(u, place, axis=1)
        best = np.maximum(best, np.take_along_axis(product, place, axis=1)[:, 0])
        width *= _SHRINKING
    return np.sqrt(best) * patch.max_pressure
