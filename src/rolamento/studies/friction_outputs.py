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

__all__ = ["friction_outputs"]

_COEFFICIENT: Final = ("lubricant.friction_coefficient",)
_OIL: Final = ("lubricant", "temperature.lubricant")


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
        from rolamento.friction.model import bears_on_both
        from rolamento.friction.slip import Patch, fast_maximum_pressure_slip, solved_motion

        cases = solved.cases
        value = fast_maximum_pressure_slip(
            Patch.of(cases.contacts[race]), solved_motion(cases, race)
        )
        touching = np.where(np.isnan(cases.outer.load), np.nan, 0.0)
        return np.where(bears_on_both(cases), value, touching)

    return compute
