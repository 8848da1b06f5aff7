"""A machine from its file to all that follows."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from contextlib import nullcontext
from typing import Final

import numpy as np

from rolamento.analysis.machine import MachineAnalysis, analyse_machine
from rolamento.case.machine import load_machine
from rolamento.errors import FileError, InputError
from rolamento.io.json import dumps
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.tasks.parameters import Progress
from rolamento.words import said

__all__ = ["MachineCurve", "analysed_machine", "machine_over", "read_range"]


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
    from rolamento.catalogue import catalogues as among

    with among(catalogues) if catalogues else nullcontext():
        return analyse_machine(load_machine(source, settings))


# --- over a field ---------------------------------------------------------------------------------

POINTS: Final = 15
MOST_POINTS: Final = 500
_RANGE: Final = re.compile(r"([^=]+?)\.\.([^=]+)", re.DOTALL)
_NUMBER: Final = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)", re.DOTALL)
_LONGEST: Final = 200


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
    if quantity == "max_pressure":
        both = (seated.solved.inner.max_pressure, seated.solved.outer.max_pressure)
        return float(max(part.max() for part in both))
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
    key, values, unit = _read_over(over, points)
    found: list[MachineAnalysis | None] = []
    refused, last = [], None
    for done, value in enumerate(values.tolist(), start=1):
        try:
            setting = f"{key}={value:.12g} {unit}".rstrip()
            found.append(analysed_machine(source, (*settings, setting), catalogues))
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


def _read_over(text: str, points: int) -> tuple[str, FloatArray, str]:
    key, equals, range_ = text.partition("=") if len(text) <= _LONGEST else ("", "", "")
    if not key.strip() or not equals:
        raise InputError(
            said("must be FIELD=FIRST..LAST"),
            field="--over",
            value=text[:_LONGEST],
            example="loads.0.fz=-1..-10kN",
        )
    return key.strip(), *read_range(range_, points, "--over", "loads.0.fz=-1..-10kN")


def read_range(text: str, points: int, field: str, example: str) -> tuple[FloatArray, str]:
    """Return so many values from the first to the last of a range, and their unit.

    Parameters
    ----------
    text
        ``"0..6000 rpm"``; a first value without a unit has that of the last.
    points
        How many, 2 to 500.
    field, example
        What to call the range in messages, and one that will do.

    Raises
    ------
    InputError
        If it is not of that form.
    """
    match = _RANGE.fullmatch(text) if len(text) <= _LONGEST else None
    first, last = (None, None) if match is None else (
        _NUMBER.fullmatch(match[1]), _NUMBER.fullmatch(match[2]),
    )  # fmt: skip
    bare = first is not None and last is not None and first[2].strip() in ("", last[2].strip())
    if first is None or last is None or not bare:
        raise InputError(
            said("must be FIRST..LAST, with a unit"),
            field=field, value=text[:_LONGEST], example=example,
        )  # fmt: skip
    if not 2 <= points <= MOST_POINTS:
        raise InputError(
            said("must be 2 to {most}", most=MOST_POINTS), field="--points", value=points
        )
    return np.linspace(float(first[1]), float(last[1]), points), last[2].strip()
