"""Friction of a solved state: torque, power, heat, and which models hold."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rolamento._json import plain
from rolamento.errors import InputError
from rolamento.friction import (
    harris_1971,
    jones_control,
    jones_full,
    jones_simplified,
    palmgren,
    skf,
    todd,
)
from rolamento.friction.control import ControlChoice, controlling_race, unit_motion
from rolamento.friction.ellipse_mesh import EllipseMesh
from rolamento.friction.hysteresis import DEFAULT_LOSS, hysteresis_loss
from rolamento.friction.loaded_balls import LoadedBalls, loaded_balls
from rolamento.friction.machine import MachineBearing, palmgren_torque, skf_moment_of
from rolamento.friction.regime import LOW_SPEED, ModelVerdict, film_regime, verdict
from rolamento.friction.rolling_resistance import rolling_resistance_loss
from rolamento.friction.torque import (
    ContactLoss,
    Torque,
    checked_coefficient,
    torque_of_losses,
)
from rolamento.numerics import FloatArray
from rolamento.rows.ball import BatchState
from rolamento.state import State

ContactModel = Literal["jones_full", "jones_control", "jones_simplified", "harris_1971", "todd"]

HYSTERESIS: Final = "hysteresis"
ROLLING_RESISTANCE: Final = "rolling_resistance"


@dataclass(frozen=True, slots=True, eq=False)
class Friction:
    """Friction of solved cases; arrays over cases, NaN without a result.

    Attributes
    ----------
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
        the same sources, contact by contact: (cases, balls), W; sums up to the power
    regime
        (cases,): "boundary", "mixed", "full_film" or "unknown"
    models
        every model that could be evaluated: its torque
    verdicts
        whether each of them holds here, and if not, why
    """

    model: str
    torque: FloatArray
    starting_torque: FloatArray
    power: FloatArray
    torque_by_source: Mapping[str, FloatArray]
    heat: Mapping[str, ContactLoss]
    regime: NDArray[np.str_]
    models: Mapping[str, Torque]
    verdicts: tuple[ModelVerdict, ...]

    def holding(self, case: int = 0) -> tuple[str, ...]:
        """Name the models that hold for a case."""
        return tuple(found.model for found in self.verdicts if found.holds[case])

    def to_mapping(self, case: int = 0) -> dict[str, Any]:
        """Give one case as plain mappings and lists in SI units, NaN as None."""
        return {
            "model": self.model,
            "regime": str(self.regime[case]),
            "torque": plain(self.torque[case]),
            "starting_torque": plain(self.starting_torque[case]),
            "power": plain(self.power[case]),
            "torque_by_source": {k: plain(v[case]) for k, v in self.torque_by_source.items()},
            "heat": [
                {
                    race: {k: plain(getattr(v, race)[case, j]) for k, v in self.heat.items()}
                    for race in ("inner", "outer")
                }
                for j in range(self._ball_count)
            ],
            "models": [
                {
                    "model": found.model,
                    "torque": plain(self.models[found.model].total[case]),
                    "holds": bool(found.holds[case]),
                    "notes": [name for name, where in found.notes.items() if where[case]],
                }
                for found in self.verdicts
            ],
        }

    @property
    def _ball_count(self) -> int:
        return next((int(loss.inner.shape[1]) for loss in self.heat.values()), 0)


def friction(
    state: State | BatchState,
    *,
    friction_coefficient: ArrayLike,
    model: ContactModel = "jones_full",
    static_coefficient: ArrayLike | None = None,
    hysteresis: ArrayLike = DEFAULT_LOSS,
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
        Of the friction in the contacts.
    static_coefficient
        μ at the first motion; μ itself if not given.
    hysteresis
        α_h of the material; 0 leaves hysteresis out.
    dynamic_viscosity
        η₀ of the oil at the contacts' inlets, Pa·s; with it the oil's rolling resistance counts.
    film_parameter
        λ of the cases, if known: it decides which models hold.
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
    if model not in LOW_SPEED:
        raise InputError(f"must be one of {', '.join(LOW_SPEED)}", field="model", value=model)
    balls = loaded_balls(state)
    mu = checked_coefficient(friction_coefficient, "friction_coefficient")
    still = (
        mu
        if static_coefficient is None
        else checked_coefficient(static_coefficient, "static_coefficient")
    )
    wanted = LOW_SPEED if _compares(state, compare) else (model,)
    models = {name: _contact_model(name, balls, mu[:, 0], control, mesh) for name in wanted}
    chosen = models[model]
    slow = _hysteresis(balls, hysteresis, control)
    oil = _oil(balls, dynamic_viscosity)
    regime = film_regime(film_parameter, len(chosen.total))
    compared = {**models, **_machine_models(state, balls, machine)}
    sources = [chosen, slow, *([] if oil is None else [oil])]
    with np.errstate(divide="ignore", invalid="ignore"):
        lift = np.where(mu > 0.0, still / mu, 1.0)[:, 0]
    torque = np.sum([source.total for source in sources], axis=0)
    return Friction(
        model=model,
        torque=torque,
        starting_torque=lift * chosen.total + slow.total,
        power=np.sum([source.power for source in sources], axis=0),
        torque_by_source={k: v for source in sources for k, v in source.parts.items()},
        heat={k: v for source in sources for k, v in source.losses.items()},
        regime=regime,
        models=compared,
        verdicts=tuple(
            verdict(
                name,
                balls,
                mu,
                regime,
                found.converged,
                other_angle=name == skf.NAME and machine is not None and machine.skf_angle_differs,
            )
            for name, found in compared.items()
        ),
    )


def _compares(state: State | BatchState, compare: bool | None) -> bool:
    return isinstance(state, State) if compare is None else compare


def _contact_model(
    name: str,
    balls: LoadedBalls,
    mu: FloatArray,
    control: ControlChoice,
    mesh: EllipseMesh | None,
) -> Torque:
    """One model of the contacts, without hysteresis."""
    if name == jones_full.NAME:
        return jones_full.jones_full(balls, mu, mesh=mesh)
    if name == jones_control.NAME:
        return jones_control.jones_control(balls, mu, control=control, mesh=mesh)
    if name == jones_simplified.NAME:
        return jones_simplified.jones_simplified(balls, mu, control=control)
    if name == harris_1971.NAME:
        return harris_1971.harris_1971(balls, mu)
    return _without_hysteresis(todd.todd(balls, mu, hysteresis=0.0, control=control))


def _without_hysteresis(torque: Torque) -> Torque:
    """Todd's torque without the source that is counted for every model."""
    parts = {name: part for name, part in torque.parts.items() if name != HYSTERESIS}
    losses = {name: loss for name, loss in torque.losses.items() if name != HYSTERESIS}
    return Torque(torque.model, torque.total, parts, torque.power, torque.converged, losses)


def _hysteresis(balls: LoadedBalls, loss: ArrayLike, control: ControlChoice) -> Torque:
    lost = checked_coefficient(loss, "hysteresis")
    motion = unit_motion(balls, controlling_race(balls, control))
    return torque_of_losses(
        HYSTERESIS, balls, {HYSTERESIS: hysteresis_loss(balls, motion, lost)}, balls.solved
    )


def _oil(balls: LoadedBalls, viscosity: ArrayLike | None) -> Torque | None:
    """The oil's rolling resistance as a torque; none where no viscosity is given."""
    if viscosity is None:
        return None
    speed = np.abs(balls.relative_speed)
    turning = np.where(speed > 0.0, speed, 1.0)
    unit = rolling_resistance_loss(balls, viscosity).scaled(1.0 / turning)
    return torque_of_losses(ROLLING_RESISTANCE, balls, {ROLLING_RESISTANCE: unit}, balls.solved)


def _machine_models(
    state: State | BatchState, balls: LoadedBalls, machine: MachineBearing | None
) -> dict[str, Torque]:
    if machine is None:
        return {}
    found = {palmgren.NAME: palmgren_torque(state, balls, machine)}
    moment = skf_moment_of(state, balls, machine)
    if moment is not None:
        found[skf.NAME] = skf.skf_torque(moment, balls.relative_speed[:, 0])
    return {name: torque for name, torque in found.items() if torque is not None}
