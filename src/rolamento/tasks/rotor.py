"""How a machine vibrates, from its file: modes, Campbell diagram, response to unbalance."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, Final

import numpy as np

from rolamento.case.machine import Machine, load_machine
from rolamento.catalogue import catalogues as catalogues_beside
from rolamento.errors import InputError
from rolamento.io.json import dumps
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.rotors import (
    MOST_MODES,
    campbell,
    natural_modes,
    turning_shaft,
    unbalance_response,
)
from rolamento.solved.rotor import Campbell, CriticalSpeed, Modes, UnbalanceResponse
from rolamento.studies.ranges import check_points, ends_of
from rolamento.tasks.machines import MOST_POINTS
from rolamento.tasks.parameters import Progress
from rolamento.units import rpm_of, to_si
from rolamento.words import said

__all__ = ["MOST_ORDERS", "MachineVibration", "machine_vibration"]

POINTS: Final = 40
_BEYOND: Final = 1.5
"""Times the operating speed up to which the diagram goes if nobody says."""
_EXAMPLE: Final = "--speeds 0..6000rpm"
MOST_ORDERS: Final = 20
_NEAR: Final = (0.97, 0.99, 1.0, 1.01, 1.03)
"""Parts of each critical speed at which the response is sought besides: peaks are narrow."""


@frozen(eq=False)
class MachineVibration:
    """How a machine vibrates.

    Attributes
    ----------
    modes
        at the operating point
    campbell
        over the speed of a shaft
    response
        to the unbalances on it; None where nothing is unbalanced
    """

    modes: Modes
    campbell: Campbell
    response: UnbalanceResponse | None

    @property
    def machine(self) -> Machine:
        """The machine at its operating point."""
        return self.modes.machine

    @property
    def speed(self) -> float:
        """Operating speed of the shaft whose speed varies; rad/s."""
        return abs(self.machine.speed(self.campbell.shaft, _factor(self.machine)))

    @property
    def nearest(self) -> CriticalSpeed | None:
        """The critical speed that is nearest to the operating speed; None where none was met."""
        return min(
            self.campbell.critical, key=lambda one: abs(one.speed - self.speed), default=None
        )

    @property
    def converged(self) -> bool:
        """Whether every speed has an equilibrium."""
        return bool((self.campbell.status == "converged").all())

    def to_json(self) -> str:
        """Give it as one JSON object in SI units."""
        mapping: dict[str, Any] = {
            "schema": 1,
            "kind": "machine_vibration",
            "title": self.machine.title,
            "operating_speed": self.speed,
            "modes": self.modes.to_mapping(),
            "campbell": self.campbell.to_mapping(),
            "unbalance_response": None if self.response is None else self.response.to_mapping(),
        }
        return dumps(mapping, indent=2)


def machine_vibration(
    source: Machine | str | os.PathLike[str],
    settings: Sequence[str] = (),
    catalogues: Sequence[str | os.PathLike[str]] = (),
    *,
    speeds: str | None = None,
    shaft: str | None = None,
    points: int = POINTS,
    count: int = 8,
    orders: Sequence[float] = (1.0,),
    damping: float | None = None,
    progress: Progress | None = None,
) -> MachineVibration:
    """Find modes, Campbell diagram and response to unbalance of a machine.

    Parameters
    ----------
    source, settings, catalogues
        As of `rolamento.tasks.machines.analysed_machine`; or a machine, which settings do not go
        over.
    speeds
        ``"0..6000rpm"``, of the shaft; from 0 to 1.5 times its own if not given.
    shaft
        Whose speeds they are; the first that turns if not given.
    points
        How many speeds, 2 to 500.
    count
        How many modes, at most 60.
    orders
        Of the rotation, at which critical speeds are sought; at most 20.
    damping
        s: the damping matrix is so many times the stiffness. None for modes, and 1e-5 s for the
        response, if not given.
    progress
        Called with how many of the three parts are done.

    Returns
    -------
    MachineVibration

    Raises
    ------
    InputError, FileError
        As `rolamento.rotors.campbell`; or if a range, an order or the damping is none.
    """
    _check(count, orders, damping)
    with catalogues_beside(catalogues):
        machine = source if isinstance(source, Machine) else load_machine(source, settings)
        name = turning_shaft(machine, shaft)
        asked = _speeds(speeds, points, abs(machine.speed(name)))
        done = progress or (lambda _done, _all: None)
        modes = natural_modes(machine, count=count, damping=damping or 0.0)
        done(1, 3)
        diagram = campbell(
            machine, asked, shaft=name, count=count, orders=orders, damping=damping or 0.0
        )
        done(2, 3)
        response = None
        if any(mass.unbalance for mass in machine.masses if mass.shaft == name):
            near = [f * one.speed for one in diagram.critical if one.order == 1.0 for f in _NEAR]
            own = abs(modes.machine.speed(name, _factor(modes.machine)))
            closer = [one for one in (*near, own) if asked[0] <= one <= asked[-1]]
            response = unbalance_response(
                machine, np.union1d(asked, closer), shaft=name, damping=damping
            )
        done(3, 3)
    return MachineVibration(modes, diagram, response)


def _factor(machine: Machine) -> float:
    """Factor of all speeds in the step that counts."""
    return machine.spectrum[0].speed_factor if machine.spectrum else 1.0


def _speeds(speeds: str | None, points: int, own: float) -> FloatArray:
    text = f"0..{rpm_of(_BEYOND * own):.12g} rpm" if speeds is None else speeds
    check_points(points, MOST_POINTS)
    try:
        first, last = (to_si(end, "angular_speed") for end in ends_of(text) or ("", ""))
    except InputError:
        raise InputError(
            said("must be FIRST..LAST, with a unit"),
            field="--speeds", value=text[:200], example=_EXAMPLE,
        ) from None  # fmt: skip
    if not 0.0 <= first < last:
        raise InputError(
            said("must rise from 0 or more"), field="--speeds", value=text, example=_EXAMPLE
        )
    return np.linspace(first, last, points)


def _check(count: int, orders: Sequence[float], damping: float | None) -> None:
    if not 1 <= count <= MOST_MODES:
        raise InputError(
            said("must be at least {at_least} and at most {at_most}", at_least=1,
                 at_most=MOST_MODES),
            field="--modes", value=count, example="--modes 8",
        )  # fmt: skip
    if not 1 <= len(orders) <= MOST_ORDERS or not all(0.0 < one <= 1e4 for one in orders):
        raise InputError(
            said("must be 1 to {most} numbers above 0", most=MOST_ORDERS),
            field="--orders", example="--orders 1,2",
        )  # fmt: skip
    if damping is not None and not 0.0 <= damping <= 1.0:
        raise InputError(
            said("must be between {at_least} and {at_most}", at_least=0, at_most=1),
            field="--damping", value=damping, example="--damping 2e-5",
        )  # fmt: skip
