"""Use cases of a machine, shafts on their bearings: what follows from its file."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final, Self

import numpy as np
from pydantic import model_validator

from rolamento.case.machine import Machine, load_machine, machine_reader
from rolamento.catalogue import catalogues
from rolamento.errors import FileError, InputError, arguments, phrase
from rolamento.io.json import dumps
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.tasks.case_request import Finding, FindingRequest, drawn
from rolamento.tasks.parameters import Progress, quietly
from rolamento.tasks.request import Input
from rolamento.words import marked, said
from rolamento.words.reasons import reason

if TYPE_CHECKING:
    from rolamento.analysis.machine import MachineAnalysis

__all__ = ["CATALOGUES", "SETTINGS", "MachineCurve", "MachineRequest", "ShaftRequest"]

CATALOGUES: Final = Input("", "paths", option="--catalogue", metavar="FILE")
SETTINGS: Final = Input(
    "", "list", separator="", option="--set", metavar="KEY=VALUE", at_computer=True
)
MOST_POINTS: Final = 500
_EXAMPLE: Final = "loads.0.fz=-1..-10kN"


class MachineRequest(FindingRequest):
    """A use case of a machine.

    Parameters
    ----------
    machine
        Machine file (TOML or JSON, or a workbook, .xlsx); - for standard input.
    settings
        Override a field of the machine: parts by name, or by number from 0.
    catalogues
        A catalogue of your own, CSV or TOML, for designations.
    """

    machine: Annotated[Any, Input("", "file", essential=True, metavar="MACHINE")]
    settings: Annotated[Any, SETTINGS] = ()
    catalogues: Annotated[Any, CATALOGUES] = ()

    @contextmanager
    def loaded(self) -> Iterator[Machine]:
        """Give the machine, with the settings over it, while the catalogues are known.

        Raises
        ------
        InputError, FileError
            As `rolamento.case.load_machine`.
        """
        with catalogues(self.catalogues):
            is_read = isinstance(self.machine, Machine)
            yield self.machine if is_read else load_machine(self.machine, self.settings)


def _kinds() -> Mapping[str, str]:
    return dict.fromkeys(("machine", "drawing", "deflection", "forces", "bearings"), "")


class ShaftRequest(MachineRequest):
    """Show loads, tilts and lives of the bearings on shafts.

    Every bearing is solved with the shaft, nonlinear and at speed, in each step of the spectrum.

    Parameters
    ----------
    kind
        With `plot`: machine (drawing, deflection, moments, stress), drawing, deflection (of `step`,
        or of all steps), forces (shear, moment, axial force, torque, stress), bearings (a load
        rosette each).
    step
        Step of the spectrum to draw, from 1.
    over
        Vary a field of the machine, such as loads.0.fz=-1..-10kN.
    points
        With `over`, values of it, 2 to 500.
    heat
        How warm the bearings run, and what becomes of their loads: [heat].
    """

    kind: Annotated[str, Input("", "choice", choices=_kinds, default="machine")] = "machine"
    step: Annotated[int | None, Input("", "count", example="1", metavar="N")] = None
    over: Annotated[str | None, Input(example=_EXAMPLE, metavar="KEY=FIRST..LAST")] = None
    points: Annotated[int, Input("", "count", default="15", between=(2, MOST_POINTS))] = 15
    heat: Annotated[bool, Input("", "switch")] = False

    counts: ClassVar = True
    examples: ClassVar = (
        "Examples: new --machine, then shaft machine.toml; shaft machine.toml"
        " --set loads.0.fz='-8 kN' --set bearings.A.designation=6310; shaft machine.toml --json"
        " result.json --xlsx result.xlsx; shaft machine.toml --report machine.pdf."
    )
    products: ClassVar = drawn(marked("Draw the result: a .png, .svg or .pdf file."))

    @model_validator(mode="after")
    def _warm_at_one_point(self) -> Self:
        if self.heat and self.over is not None:
            before = arguments(over=...)
            raise InputError(
                phrase(marked("cannot be combined with {before}"), before=before), field="heat"
            )
        return self

    def run(self, progress: Progress = quietly) -> Finding:
        """Find it: a `MachineAnalysis`, a `MachineCurve` or a `MachineHeat`."""
        if self.over is not None:
            return self._varied(progress)
        with self.loaded() as machine:
            return _warm(machine) if self.heat else self._analysed(machine)

    def _analysed(self, machine: Machine) -> Finding:
        from rolamento.analysis.machine import analyse_machine
        from rolamento.pages.machine import machine_page, machine_report

        found = analyse_machine(machine)
        status = found.solved.status
        failed = (
            ": ".join(part for part in (name, reason(str(code))) if part)
            for name, code in zip(found.solved.steps, status.code, strict=True)
            if code != "converged"
        )
        return Finding(
            found, partial(machine_page, found), found.to_json, partial(self._drawn, found),
            "\n".join(failed), found.converged, partial(machine_report, found),
        )  # fmt: skip

    def _drawn(self, found: MachineAnalysis) -> Any:
        from rolamento.plots import machine

        solved = found.solved
        if self.step is not None and not 1 <= self.step <= len(solved):
            rule = said(
                "must be at least {at_least} and at most {at_most}", at_least=1, at_most=len(solved)
            )
            raise InputError(rule, field="step", value=self.step)
        place = None if self.step is None else self.step - 1
        if self.kind == "deflection":
            return machine.draw_deflection(solved, step=place)
        draws: dict[str, Callable[..., Any]] = {
            "machine": machine.machine_figure,
            "drawing": machine.draw_machine,
            "forces": machine.draw_section_forces,
            "bearings": machine.draw_bearings_in_place,
        }
        return draws[self.kind](solved, step=place or 0)

    def _varied(self, progress: Progress) -> Finding:
        """Solve the machine over a range of one of its fields; some points may be refused."""
        from rolamento.analysis.machine import analyse_machine
        from rolamento.pages.machine import machine_over_page
        from rolamento.plots.machine import machine_over_figure

        key, values, unit = self._range()
        machine_under = machine_reader(self.machine)
        found: list[MachineAnalysis | None] = []
        refused, last = [], None
        with catalogues(self.catalogues):
            for done, value in enumerate(values.tolist(), start=1):
                try:
                    setting = f"{key}={value:.12g} {unit}".rstrip()
                    found.append(analyse_machine(machine_under((*self.settings, setting))))
                    refused.append("")
                except FileError:
                    raise
                except InputError as error:
                    found.append(None)
                    refused.append(str(error))
                    last = error
                progress(done, self.points)
        if last is not None and not any(one is not None for one in found):
            raise last
        curve = MachineCurve(key, values, unit, tuple(found), tuple(refused))
        return Finding(
            curve, partial(machine_over_page, curve), curve.to_json,
            partial(machine_over_figure, curve), "", curve.converged,
        )  # fmt: skip

    def _range(self) -> tuple[str, FloatArray, str]:
        """A field, its values, and their unit: the machine has no record that knows of it."""
        from rolamento.studies.ranges import number_and_unit, range_of_field

        text = self.over or ""
        key, *ends = range_of_field(text, _EXAMPLE)
        first, last = (number_and_unit(end) for end in ends)
        if first is None or last is None or first[1] != last[1]:
            rule = said("must be two numbers with the same unit")
            raise InputError(rule, field="over", value=text, example=arguments(over=_EXAMPLE))
        return key, np.linspace(first[0], last[0], self.points), last[1]


def _warm(machine: Machine) -> Finding:
    from rolamento.heat.machine import machine_heat
    from rolamento.pages.machine_heat import machine_heat_page
    from rolamento.plots.heat import machine_heat_figure

    found = machine_heat(machine)
    return Finding(
        found, partial(machine_heat_page, found), found.to_json,
        partial(machine_heat_figure, found),
        "" if found.converged else reason(found.status), found.converged,
    )  # fmt: skip


# --- over a field ---------------------------------------------------------------------------------


@frozen(eq=False)
class MachineCurve:
    """A machine over one of its fields.

    Attributes
    ----------
    key
        what varies, by its dotted name
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
