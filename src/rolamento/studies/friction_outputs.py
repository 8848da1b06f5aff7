"""Outputs of friction: torque and power by each model, losses and pressure times slip.

Torques are running torques of all sources: the contacts by the model, elastic hysteresis and,
where the case has an oil and its temperature, the oil's rolling resistance; without a coefficient
of friction that of the regime of lubrication; those of the contacts
of each ball are taken with the motion as it was solved. The models of whole bearings, Palmgren's
and SKF's, have all sources in them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.friction.models import torque_model_name
from rolamento.geometry import Race
from rolamento.solved import RACES
from rolamento.studies.bearing_outputs import at_race, family
from rolamento.studies.outputs import Evaluation, Floats, Output
from rolamento.words import marked, said
from rolamento.words.quantities import CALLED, called

if TYPE_CHECKING:
    from rolamento.friction import Friction, Torque
    from rolamento.solved import Solved

_COEFFICIENT: Final = ("friction",)
_OF_BALLS: Final = (*_COEFFICIENT, "balls")
_OF_ROLLERS: Final = (*_COEFFICIENT, "rollers")
_OIL: Final = ("lubricant", "temperature.lubricant")


def friction_outputs() -> tuple[Output, ...]:
    """Return the outputs of friction."""
    return (
        *_of_models(),
        Output(
            "hysteresis_torque",
            "N*m",
            lambda: said("friction torque, elastic hysteresis"),
            _source("hysteresis"),
            needs=_COEFFICIENT,
        ),
        Output(
            "rib_torque",
            "N*m",
            lambda: said("friction torque, sliding of rollers at the ribs"),
            _source("rib"),
            needs=_OF_ROLLERS,
        ),
        Output(
            "rolling_resistance_torque",
            "N*m",
            lambda: said("friction torque, rolling resistance of the oil"),
            _source("rolling_resistance"),
            needs=(*_COEFFICIENT, *_OIL),
        ),
        *_of_control(),
        *_of_contacts(),
    )


def _of_models() -> Iterator[Output]:
    from rolamento.friction import CONTACT_MODELS, ROLLER_MODEL, TORQUE_MODELS

    for model, known in TORQUE_MODELS.items():
        if not known.of_contacts:
            for name, unit in (("torque", "N*m"), ("power", "W")):
                yield Output(
                    f"friction_{name}_{model}",
                    unit,
                    partial(_of_model, name, model),
                    _of_whole(model, name),
                    needs=(*_COEFFICIENT, *_OIL, "bearing.designation"),
                )
    for model in (*CONTACT_MODELS, ROLLER_MODEL):
        known = TORQUE_MODELS[model]
        for name, unit in (("torque", "N*m"), ("power", "W")):
            yield Output(
                f"friction_{name}_{model}",
                unit,
                partial(_of_model, name, model),
                _total(model, name),
                needs=_OF_ROLLERS if model == ROLLER_MODEL else _OF_BALLS,
                slow=not known.closed_form,
            )


def _of_model(what: str, model: str) -> str:
    return said("{quantity}, {part}", quantity=called(what), part=torque_model_name(model))


def _of_control() -> Iterator[Output]:
    """What friction control finds, where the case is solved with it."""
    for name, unit, text, attribute in (
        ("rolling_power", "W", CALLED["rolling_power"], "power"),
        ("cage_speed", "rad/s", CALLED["cage_speed"], "cage_speed"),
    ):
        yield Output(
            name, unit, partial(said, text), _of_rolling(attribute), needs=("friction control",)
        )


def _of_contacts() -> Iterator[Output]:
    for race in RACES:
        yield from family(
            f"{race}_spin_loss",
            "W",
            at_race(race, marked("spin power loss")),
            _spin_loss(race),
            None,
            _OF_BALLS,
        )
        yield from family(
            f"{race}_pressure_slip",
            "W/m^2",
            at_race(race, marked("maximum of pressure times slip")),
            _pressure_slip(race),
            None,
            ("balls",),
        )


def _coefficient(solved: Solved) -> Floats:
    """μ of every case, given or by the regime; NaN where the friction models take none."""
    mu = solved.field("lubricant.friction_coefficient")
    if np.isnan(mu).all():
        from rolamento.friction.coefficient import coefficient_by_regime

        mu = coefficient_by_regime(solved)[0].balls[:, 0]
    return np.where(mu <= 1.0, mu, np.nan)


def _friction(solved: Solved, *, model: str) -> Friction:
    """Torque, power and heat; without friction where there is no coefficient for the models."""
    from rolamento.friction import friction

    mu = solved.field("lubricant.friction_coefficient")
    return friction(
        solved,
        friction_coefficient=None if np.isnan(mu).all() else np.where(mu <= 1.0, mu, 0.0),
        model=model,
        film_parameter=np.nan,
        compare=False,
        threads=1,
    )


def _total(model: str, attribute: str) -> Callable[[Evaluation], Floats]:
    def compute(given: Evaluation) -> Floats:
        values: Floats = getattr(given.of(_friction, model=model), attribute)
        return np.where(np.isnan(_coefficient(given.solved)), np.nan, values)

    return compute


def _of_whole_bearings(solved: Solved) -> Mapping[str, Torque]:
    """Torque of the models of whole bearings, by name; those whose tables have the bearing."""
    from rolamento.analysis.needs import machines_known
    from rolamento.friction import CONTACT_MODELS, ROLLER_MODEL, TORQUE_MODELS, friction
    from rolamento.lubrication.films import film

    fast = (own for own in CONTACT_MODELS if TORQUE_MODELS[own].closed_form)
    model = next(fast) if "ball" in solved.rows.element else ROLLER_MODEL
    machine = machines_known(solved, film(solved))
    found = friction(solved, model=model, machine=machine, compare=False, threads=1)
    return {
        own: torque for own, torque in found.models.items() if not TORQUE_MODELS[own].of_contacts
    }


def _of_whole(model: str, attribute: str) -> Callable[[Evaluation], Floats]:
    def compute(given: Evaluation) -> Floats:

        found = given.of(_of_whole_bearings).get(model)
        if found is None:
            return np.full(len(given.solved), np.nan)
        speed = given.solved.relative_speed if attribute == "power" else 1.0
        return np.where(given.solved.converged, found.total * speed, np.nan)

    return compute


def _source(name: str) -> Callable[[Evaluation], Floats]:
    def compute(given: Evaluation) -> Floats:
        from rolamento.friction.summary import default_model

        model = default_model(given.solved, quick=True)
        found = given.of(_friction, model=model).torque_by_source.get(name)
        unknown = np.isnan(_coefficient(given.solved))
        return np.where(unknown, np.nan, np.nan if found is None else found)

    return compute


def _of_rolling(attribute: str) -> Callable[[Evaluation], Floats]:
    def compute(given: Evaluation) -> Floats:
        rolling, converged = given.solved.rolling, given.solved.converged
        return np.where(
            converged, np.nan if rolling is None else getattr(rolling, attribute), np.nan
        )

    return compute


def _spin_loss(race: Race) -> Callable[[Evaluation], Floats]:
    """M_s |ω_s| with the spin as it was solved; 0 at a race that a ball rolls on without spin."""

    def compute(given: Evaluation) -> Floats:
        from rolamento.friction.closed_forms import spin_moment
        from rolamento.friction.slip import Patch

        contacts = given.solved.contacts[race]
        mu = _coefficient(given.solved)[:, np.newaxis]
        loss = spin_moment(Patch.of(contacts), mu) * np.abs(contacts.spin)
        return _of_loaded(given.solved, loss)

    return compute


def _pressure_slip(race: Race) -> Callable[[Evaluation], Floats]:
    def compute(given: Evaluation) -> Floats:
        from rolamento.friction.slip import Patch, fast_maximum_pressure_slip, solved_motion

        patch, motion = Patch.of(given.solved.contacts[race]), solved_motion(given.solved, race)
        return _of_loaded(given.solved, fast_maximum_pressure_slip(patch, motion))

    return compute


def _of_loaded(solved: Solved, values: Floats) -> Floats:
    """Values of the balls that bear on both races, 0 of the others."""
    unloaded = np.where(np.isnan(solved.outer.load), np.nan, 0.0)
    return np.where(solved.balls_bear, values, unloaded)
