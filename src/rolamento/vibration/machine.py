"""Frequencies of a machine: how often its shafts turn, its gears mesh, its bearings' parts pass."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import pi
from typing import Any, Final, Literal

from rolamento.case.machine import Machine
from rolamento.case.machine_loads import Gear
from rolamento.records import frozen
from rolamento.vibration.frequencies import FaultFrequencies, LineName

__all__ = ["MachineFrequency", "frequencies_of_machine"]

_OF_BEARINGS: Final[tuple[LineName, ...]] = (
    "cage", "ball_pass_outer", "ball_pass_inner", "ball_spin",
)  # fmt: skip


@frozen
class MachineFrequency:
    """One frequency of a machine.

    Attributes
    ----------
    part
        name of the shaft, the bearing, or the gear with its mate
    line
        "rotation" of a shaft, "mesh" of gears, or the line of a bearing
    frequency
        Hz
    order
        multiple of the rotation of the first shaft that turns
    element
        what rolls in the bearing, as a case file has it; empty of others
    """

    part: str
    line: LineName | Literal["rotation", "mesh"]
    frequency: float
    order: float
    element: str = ""

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, without the element."""
        return {
            "part": self.part, "line": self.line,
            "frequency": self.frequency, "order": self.order,
        }  # fmt: skip


def frequencies_of_machine(
    machine: Machine, bearings: Mapping[str, FaultFrequencies], factor: float = 1.0
) -> tuple[MachineFrequency, ...]:
    """Give the frequencies of all shafts, gears and bearings of a machine.

    Parameters
    ----------
    machine
        Whose shafts and gears they are.
    bearings
        Those of its bearings, by name.
    factor
        By which all speeds are multiplied.

    Returns
    -------
    tuple of MachineFrequency
        Of shafts that turn, meshes whose teeth are known, and bearings that do not stand still, as
        the machine has them.
    """
    turns = {
        shaft.name: abs(machine.speed(shaft.name, factor)) / (2.0 * pi) for shaft in machine.shafts
    }
    main = next((turn for turn in turns.values() if turn), float("nan"))
    found = [
        MachineFrequency(name, "rotation", turn, turn / main)
        for name, turn in turns.items()
        if turn
    ]
    for name, gears in _meshes(machine):
        mesh = max((gear.teeth or 0) * turns[gear.shaft] for gear in gears)
        if mesh:
            found.append(MachineFrequency(name, "mesh", mesh, mesh / main))
    for name, own in bearings.items():
        for line in _OF_BEARINGS:
            frequency = own.lines[line].frequency
            if frequency > 0.0:  # neither at rest nor without a result
                found.append(MachineFrequency(name, line, frequency, frequency / main, own.element))
    return tuple(found)


def _meshes(machine: Machine) -> Iterator[tuple[str, tuple[Gear, ...]]]:
    """Gears by twos where the machine has both, once each, and what to call them."""
    named = {gear.name: gear for gear in machine.gears if gear.name}
    seen: set[str] = set()
    for number, gear in enumerate(machine.gears, start=1):
        if gear.name in seen:
            continue
        by = (one.name for one in machine.gears if gear.name and one.mate == gear.name)
        mate = gear.mate or next(by, None)
        gears = (gear,) if mate not in named else (gear, named[mate])
        seen |= {one.name for one in gears if one.name}
        yield " – ".join(one.name or str(number) for one in gears), gears
