"""A machine from its file to all that follows."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Final

import numpy as np

from rolamento.analysis.machine import MachineAnalysis, analyse_machine
from rolamento.case.machine import load_machine, machine_reader
from rolamento.catalogue import catalogues as catalogues_beside
from rolamento.errors import FileError, InputError
from rolamento.heat.machine import MachineHeat, machine_heat
from rolamento.io.json import dumps
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.studies.ranges import check_points, number_and_unit, range_of_field
from rolamento.tasks.parameters import Progress
from rolamento.words import said

__all__ = ["MachineCurve", "analysed_machine", "heat_of_machine", "machine_over"]


def analysed_machine(
    source: str | os.PathLike[str],
    settings: Sequence[str] = (),
    catalogues: Sequence[str | os.PathLike[str]] = (),
) -> MachineAnalysis:
    """Read a machine, solve it, and find what follows for its bearings.

    Parameters
    ----------
    source
        Its file.
    settings
        That go over it, as of `rolamento.case.load_machine`.
    catalogues
        Files of catalogues of one's own, for designations.

    Raises
    ------
    InputError, FileError
        As `rolamento.case.load_machine` and `analyse_machine`.
    """
    with catalogues_beside(catalogues):
        return analyse_machine(load_machine(source, settings))


def heat_of_machine(
    source: str | os.PathLike[str],
    settings: Sequence[str] = (),
    catalogues: Sequence[str | os.PathLike[str]] = (),
) -> MachineHeat:
    """Read a machine, and find how warm its bearings run.

    Parameters
    ----------
    source, settings, catalogues
        As of `analysed_machine`.

    Raises
    ------
    InputError, FileError
        As `analysed_machine` and `rolamento.heat.machine.machine_heat`.
    """
    with catalogues_beside(catalogues):
        return machine_heat(load_machine(source, settings))


# --- over a field ---------------------------------------------------------------------------------

POINTS: Final = 15
MOST_POINTS: Final = 500
_EXAMPLE: Final = "loads.0.fz=-1..-10kN"


@frozen(eq=False)
class MachineCurve:
    """A machine over one of its fields.

    Attributes
    ----------
    key
        what varies, as ``--set`` has it
    values, unit
        of each point, and their unit; (points,)
    found
        the machine at each point; None where it is refused
    refused
        why; empty where it is not
    """

    key: str
    values: FloatArray
    unit: str
    found: tuple[MachineAnalysis | None, ...]
    refused: tuple[str, ...]

    @property
    def first(self) -> MachineAnalysis:
        """The first machine that is none refused."""
        return next(one for one in self.found if one is not None)

    @property
    def converged(self) -> bool:
        """Whether every point has a result."""
        return all(one is not None and one.converged for one in self.found)

    @property
    def hours(self) -> FloatArray:
        """Life of all bearings together; NaN where there is none; (points,)."""
        return np.array([
            np.nan if one is None or one.together is None or not one.converged
            else one.together.hours
            for one in self.found
        ])  # fmt: skip

    def of_bearing(self, name: str, quantity: str) -> FloatArray:
        """The greatest of all steps at a bearing: of its forces, tilt, pressure; its life.

        Parameters
        ----------
        name
            The bearing.
        quantity
            ``"radial_force"``, ``"tilt"``, ``"max_pressure"`` or ``"hours"``.
        """
        return np.array([_of_bearing(one, name, quantity) for one in self.found])

    def of_shaft(self, name: str, quantity: str) -> FloatArray:
        """The greatest of all steps along a shaft: of `OF_SHAFTS`; (points,)."""
        return np.array([
            np.nan if one is None or not one.converged
            else float(getattr(one.solved.shafts[name], quantity).max())
            for one in self.found
        ])  # fmt: skip

    def to_json(self) -> str:
        """Give it as one JSON object: SI units but for the values, and hours."""
        machine = self.first.solved
        return dumps(
            {
                "schema": 1,
                "kind": "machine_curve",
                "title": machine.title,
                "field": self.key,
                "unit": self.unit,
                "values": self.values,
                "converged": [one is not None and one.converged for one in self.found],
                "refused": self.refused,
                "hours": self.hours,
                "bearings": {
                    name: {q: self.of_bearing(name, q) for q in OF_BEARINGS}
                    for name in machine.bearings
                },
                "shafts": {
                    name: {q: self.of_shaft(name, q) for q in OF_SHAFTS} for name in machine.shafts
                },
            },
            indent=2,
        )


OF_BEARINGS: Final = ("radial_force", "tilt", "max_pressure", "hours")
OF_SHAFTS: Final = ("deflection", "slope", "stress")


def _of_bearing(one: MachineAnalysis | None, name: str, quantity: str) -> float:
    if one is None or not one.converged:
        return float("nan")
    seated = one.solved.bearings[name]
    if quantity == "hours":
        life = one.lives[name]
        return float("nan") if life is None else life.headline.hours
    return float(getattr(seated, quantity).max())


def machine_over(
    source: str | os.PathLike[str],
    over: str,
    settings: Sequence[str] = (),
    catalogues: Sequence[str | os.PathLike[str]] = (),
    *,
    points: int = POINTS,
    progress: Progress | None = None,
) -> MachineCurve:
    """Solve a machine over a range of one of its fields.

    Parameters
    ----------
    source, settings, catalogues
        As of `analysed_machine`.
    over
        ``"loads.0.fz=-1..-10kN"``: a field as a setting has it, first and last value; a first value
        without a unit has that of the last.
    points
        How many values, 2 to 500.
    progress
        Called with how many of how many points are done.

    Raises
    ------
    InputError
        If it is not of that form, or the machine is refused at every point.
    FileError
        If a file cannot be read.
    """
    key, values, unit = _over(over, points)
    machine_under = machine_reader(source)
    found: list[MachineAnalysis | None] = []
    refused, last = [], None
    with catalogues_beside(catalogues):
        for done, value in enumerate(values.tolist(), start=1):
            try:
                setting = f"{key}={value:.12g} {unit}".rstrip()
                found.append(analyse_machine(machine_under((*settings, setting))))
                refused.append("")
            except FileError:
                raise
            except InputError as error:
                found.append(None)
                refused.append(str(error))
                last = error
            if progress is not None:
                progress(done, points)
    if last is not None and not any(one is not None for one in found):
        raise last
    return MachineCurve(key, values, unit, tuple(found), tuple(refused))


def _over(text: str, points: int) -> tuple[str, FloatArray, str]:
    """A field, its values, and their unit: the machine has no record that knows of the field."""
    key, *ends = range_of_field(text, _EXAMPLE)
    first, last = (number_and_unit(end) for end in ends)
    if first is None or last is None or first[1] != last[1]:
        raise InputError(
            said("must be two numbers with the same unit"),
            field="--over", value=text, example=_EXAMPLE,
        )  # fmt: skip
    check_points(points, MOST_POINTS)
    return key, np.linspace(first[0], last[0], points), last[1]
