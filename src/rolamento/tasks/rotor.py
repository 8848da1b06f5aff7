"""How a machine vibrates, from its file: modes, Campbell diagram, response to unbalance."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final

import numpy as np

from rolamento.errors import InputError, arguments
from rolamento.io.json import dumps
from rolamento.records import frozen
from rolamento.tasks.case_request import Finding, drawn
from rolamento.tasks.machines import MOST_POINTS, MachineRequest
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import Input
from rolamento.units import rpm_of, to_si
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.case.machine import Machine
    from rolamento.numerics import FloatArray
    from rolamento.solved.rotor import Campbell, CriticalSpeed, Modes, UnbalanceResponse

__all__ = ["MachineVibration", "RotorRequest"]

_BEYOND: Final = 1.5
"""Times the operating speed up to which the diagram goes if nobody says."""
_EXAMPLE: Final = "0..6000rpm"
_MOST_ORDERS: Final = 20
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


def _factor(machine: Machine) -> float:
    """Factor of all speeds in the step that counts."""
    return machine.spectrum[0].speed_factor if machine.spectrum else 1.0


class RotorRequest(MachineRequest):
    """Show natural frequencies and critical speeds of shafts.

    The bearings are solved anew at each speed: their stiffness changes with load and speed. Where
    masses of the machine are unbalanced, how they shake it.

    Parameters
    ----------
    speeds
        Speeds of the shaft, such as 0..6000rpm; to 1.5 times its own by default.
    shaft
        Shaft whose speeds these are; by default the first that turns.
    points
        How many speeds, 2 to 500.
    modes
        How many modes, 1 to 60.
    orders
        Orders of the rotation that excite, such as 1,2 or the teeth of a gear; 1 by default.
    damping
        Damping over stiffness, in s; of the response 1e-5 by default, with a note.
    picture
        What `plot` draws: campbell, modes or unbalance.
    """

    speeds: Annotated[str | None, Input(example=_EXAMPLE, metavar="FIRST..LAST")] = None
    shaft: Annotated[str | None, Input(example="shaft", metavar="NAME")] = None
    points: Annotated[int, Input("", "count", default="40", between=(2, MOST_POINTS))] = 40
    modes: Annotated[int, Input("", "count", default="8", between=(1, 60))] = 8
    orders: Annotated[
        tuple[float, ...],
        Input(
            "", "numbers", example="1,2", separator=",", between=(0.001, 1e4), default="1",
            most=_MOST_ORDERS, metavar="LIST",
        ),
    ] = (1.0,)  # fmt: skip
    damping: Annotated[
        float | None, Input("", "number", example="2e-5", between=(0, 1), metavar="S")
    ] = None
    picture: Annotated[
        str,
        Input(
            "", "choice", choices=lambda: dict.fromkeys(("campbell", "modes", "unbalance"), ""),
            default="campbell", metavar="NAME",
        ),
    ] = "campbell"  # fmt: skip

    counts: ClassVar = True
    waiting: ClassVar = marked("parts of the calculation")
    examples: ClassVar = (
        "Examples: rotor machine.toml; rotor machine.toml --speeds 0..12000rpm --orders 1,2"
        " --plot campbell.png; rotor machine.toml --picture unbalance --plot unbalance.png"
        " --damping 2e-5."
    )
    products: ClassVar = drawn(marked("Draw the result: a .png, .svg or .pdf file."))

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it, a `MachineVibration`."""
        from rolamento.pages.rotor import vibration_page

        with self.loaded() as machine:
            found = self._vibration(machine, progress)
        return Finding(
            found, partial(vibration_page, found), found.to_json, partial(self._drawn, found), "",
            found.converged,
        )  # fmt: skip

    def _vibration(self, machine: Machine, progress: Progress) -> MachineVibration:
        from rolamento.rotors import campbell, natural_modes, turning_shaft, unbalance_response

        name, damping = turning_shaft(machine, self.shaft), self.damping or 0.0
        speeds = self._speeds(abs(machine.speed(name)))
        modes = natural_modes(machine, count=self.modes, damping=damping)
        progress(1, 3)
        orders = self.orders or (1.0,)
        diagram = campbell(
            machine, speeds, shaft=name, count=self.modes, orders=orders, damping=damping
        )
        progress(2, 3)
        response = None
        if any(mass.unbalance for mass in machine.masses if mass.shaft == name):
            near = [f * one.speed for one in diagram.critical if one.order == 1.0 for f in _NEAR]
            own = abs(modes.machine.speed(name, _factor(modes.machine)))
            closer = [one for one in (*near, own) if speeds[0] <= one <= speeds[-1]]
            response = unbalance_response(
                machine, np.union1d(speeds, closer), shaft=name, damping=self.damping
            )
        progress(3, 3)
        return MachineVibration(modes, diagram, response)

    def _speeds(self, own: float) -> FloatArray:
        from rolamento.studies.ranges import ends_of

        text = f"0..{rpm_of(_BEYOND * own):.12g} rpm" if self.speeds is None else self.speeds
        rule = said("must rise from 0 or more")
        try:
            first, last = (to_si(end, "angular_speed") for end in ends_of(text) or ("", ""))
        except InputError:
            first, last, rule = 0.0, 0.0, said("must be FIRST..LAST, with a unit")
        if not 0.0 <= first < last:
            example = arguments(speeds=_EXAMPLE)
            raise InputError(rule, field="speeds", value=text, example=example)
        return np.linspace(first, last, self.points)

    def _drawn(self, found: MachineVibration) -> Any:
        from rolamento.plots.machine import campbell_figure, modes_figure, response_figure

        if self.picture != "unbalance":
            is_modes = self.picture == "modes"
            return modes_figure(found.modes) if is_modes else campbell_figure(found.campbell)
        if found.response is None:
            shaft = f'"{found.campbell.shaft}"'
            rule = said("is missing: nothing on shaft {shaft} is unbalanced", shaft=shaft)
            raise InputError(rule, field="masses", example='unbalance = "100 g mm"')
        return response_figure(found.response)
