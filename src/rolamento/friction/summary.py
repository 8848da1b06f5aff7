"""Friction of solved cases: torque, power, heat, and which models are valid."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento.errors import InputError
from rolamento.friction.closed_forms import DEFAULT_HYSTERESIS
from rolamento.friction.loaded_balls import LoadedBalls, loaded_balls
from rolamento.friction.machine import MachineBearing
from rolamento.friction.model import (
    ContactLoss,
    ControlChoice,
    ModelValidity,
    Setting,
    Torque,
    checked_coefficient,
    controlling_race,
    film_regime,
    hysteresis_loss,
    torque_of_losses,
    unit_motion,
    validity_of,
)
from rolamento.friction.models import CONTACT_MODELS, TORQUE_MODELS
from rolamento.friction.rolling_resistance import rolling_resistance_loss
from rolamento.friction.traction import EllipseMesh
from rolamento.numerics import FloatArray
from rolamento.rows.ball import BatchState
from rolamento.state import State

HYSTERESIS: Final = "hysteresis"
ROLLING_RESISTANCE: Final = "rolling_resistance"


@dataclass(frozen=True, slots=True, eq=False)
class Friction:
    """Friction of solved cases; arrays over cases, NaN without a result.

    Attributes
    ----------
    friction_coefficient
        μ between balls and races, (cases,)
    model
        of the friction in the contacts
    torque
        running torque of all sources, (cases,), N·m; at rest the limit of slow turning
    starting_torque
        of the first motion: static friction and hysteresis, (cases,), N·m
    power
        running torque times the relative speed of the rings, (cases,), W
    torque_by_source
        "spin", "rolling_slip", "hysteresis", "rolling_resistance": (cases,), N·m
    heat
        the same sources, contact by contact: (cases, elements), W; sums up to the power
    regime
        (cases,): "boundary", "mixed", "full_film" or "unknown"
    models
        every model that could be evaluated: its torque
    validity
        whether each of them is valid here, and if not, why
    """

    friction_coefficient: FloatArray
    model: str
    torque: FloatArray
    starting_torque: FloatArray
    power: FloatArray
    torque_by_source: Mapping[str, FloatArray]
    heat: Mapping[str, ContactLoss]
    regime: NDArray[np.str_]
    models: Mapping[str, Torque]
    validity: tuple[ModelValidity, ...]

    def valid_models(self, case: int = 0) -> tuple[str, ...]:
        """Name the models that are valid for a case."""
        return tuple(found.model for found in self.validity if found.valid[case])

    def to_mapping(self, case: int = 0) -> dict[str, Any]:
        """Give one case as plain mappings and lists in SI units, NaN as None."""
        return {
            "friction_coefficient": _number(self.friction_coefficient[case]),
            "model": self.model,
            "regime": str(self.regime[case]),
            "torque": _number(self.torque[case]),
            "starting_torque": _number(self.starting_torque[case]),
            "power": _number(self.power[case]),
            "torque_by_source": _numbers(self.torque_by_source, case),
            "heat": {
                source: {
                    race: [_number(value) for value in getattr(loss, race)[case]]
                    for race in ("inner", "outer")
                }
                for source, loss in self.heat.items()
            },
            "models": {
                found.model: {
                    "torque": _number(self.models[found.model].total[case]),
                    "parts": _numbers(self.models[found.model].parts, case),
                    "holds": bool(found.valid[case]),
                    "reasons": [name for name, where in found.notes.items() if where[case]],
                }
                for found in self.validity
            },
        }


def friction(
    state: State | BatchState,
    *,
    friction_coefficient: ArrayLike,
    model: str = "jones_full",
    static_coefficient: ArrayLike | None = None,
    hysteresis: ArrayLike = DEFAULT_HYSTERESIS,
    dynamic_viscosity: ArrayLike | None = None,
    film_parameter: ArrayLike | None = None,
    machine: MachineBearing | None = None,
    control: ControlChoice = "jones",
    compare: bool | None = None,
    mesh: EllipseMesh | None = None,
) -> Friction:
    """Find torque, power and heat of friction in a solved bearing.

    Parameters
    ----------
    state
        A solved state, or a batch of them.
    friction_coefficient
        μ between balls and races, a number or one for each case.
    model
        Of the friction in the contacts: a name in `CONTACT_MODELS`.
    static_coefficient
        μ at the first motion; μ itself if not given.
    hysteresis
        α_h of the material; 0 leaves hysteresis out.
    dynamic_viscosity
        η₀ of the oil at the contacts' inlets, Pa·s; with it the oil's rolling resistance counts.
    film_parameter
        λ of the cases, if known: it decides which models are valid.
    machine
        Sizes, rating and lubricant, for Palmgren's and SKF's models beside.
    control
        Which race the balls roll on, for the models that need to know.
    compare
        Whether to evaluate the other models of the contacts too; by default for a state, and
        not for a batch.
    mesh
        Points on the ellipses; 80 × 5 by default.

    Returns
    -------
    Friction

    Raises
    ------
    InputError
        For an unknown word, or a number out of range.
    """
    if model not in CONTACT_MODELS:
        raise InputError(f"must be one of {', '.join(CONTACT_MODELS)}", field="model", value=model)
    balls = loaded_balls(state)
    cases = len(balls.loaded)
    mu = checked_coefficient(friction_coefficient, "friction_coefficient")
    lost = checked_coefficient(hysteresis, "hysteresis")
    static = mu
    if static_coefficient is not None:
        static = checked_coefficient(static_coefficient, "static_coefficient")
    load = np.asarray(state.load, np.float64).reshape(cases, 5)
    setting = Setting(
        balls,
        mu,
        film_regime(film_parameter, cases),
        control,
        mesh,
        radial_load=np.hypot(load[:, 1], load[:, 2]),
        axial_load=np.abs(load[:, 0]),
        machine=machine,
    )
    compared = isinstance(state, State) if compare is None else compare
    models = {
        name: own.evaluate(setting)
        for name, own in TORQUE_MODELS.items()
        if name == model or ((compared or not own.of_contacts) and _is_known(own.needs, setting))
    }
    beside = [_hysteresis(setting, lost)]
    if dynamic_viscosity is not None:
        beside.append(_rolling_resistance(setting, dynamic_viscosity))
    sources = [models[model], *beside]
    with np.errstate(divide="ignore", invalid="ignore"):
        lift = np.where(mu > 0.0, static / mu, 1.0)[:, 0]
    return Friction(
        friction_coefficient=np.broadcast_to(mu[:, 0], cases),
        model=model,
        torque=np.sum([source.total for source in sources], axis=0),
        starting_torque=lift * models[model].total + beside[0].total,
        power=np.sum([source.power for source in sources], axis=0),
        torque_by_source={k: v for source in sources for k, v in source.parts.items()},
        heat={k: v for source in sources for k, v in source.losses.items()},
        regime=setting.regime,
        models=models,
        validity=tuple(
            validity_of(TORQUE_MODELS[name], setting, found.converged)
            for name, found in models.items()
        ),
    )


def _is_known(needs: tuple[str, ...], setting: Setting) -> bool:
    return all(map(setting.supplies, needs))


def _hysteresis(setting: Setting, loss: FloatArray) -> Torque:
    balls = setting.balls
    motion = unit_motion(balls, controlling_race(balls, setting.control))
    lost = hysteresis_loss(balls, motion, loss)
    return torque_of_losses(HYSTERESIS, balls, {HYSTERESIS: lost}, balls.solved)


def _rolling_resistance(setting: Setting, viscosity: ArrayLike) -> Torque:
    """The oil's rolling resistance as a torque."""
    balls: LoadedBalls = setting.balls
    speed = np.abs(balls.relative_speed)
    turning = np.where(speed > 0.0, speed, 1.0)
    unit = rolling_resistance_loss(balls, viscosity).scaled(1.0 / turning)
    return torque_of_losses(ROLLING_RESISTANCE, balls, {ROLLING_RESISTANCE: unit}, balls.solved)


def _number(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


def _numbers(arrays: Mapping[str, FloatArray], case: int) -> dict[str, float | None]:
    return {name: _number(array[case]) for name, array in arrays.items()}
