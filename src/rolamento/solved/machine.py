"""The result of a machine: its shafts, and a `Solved` for each of its bearings.

All arrays run over cases first: the steps of the machine's spectrum, or one. Machine's axes; a
bearing's own result counts along its own x, which is the machine's -x where it is turned round.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from rolamento.case.duty import AXES, LOADS
from rolamento.case.machine import Machine, MachineBearing, Shaft
from rolamento.errors import FileError, InputError
from rolamento.io.json import dumps, plain
from rolamento.io.text import parse_mapping
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solved import form
from rolamento.solved.result import Solved
from rolamento.solved.tables import Status, taken
from rolamento.status import STATUS_NUMBERS
from rolamento.words import Note, said

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

__all__ = ["SeatedBearing", "SolvedMachine", "SolvedShaft"]

SCHEMA: Final = 1
KIND: Final = "machine"
_OF_SHAFT: Final[dict[str, Callable[[int, int], tuple[int, ...]]]] = {
    "position": lambda cases, nodes: (nodes,),
    "diameter": lambda cases, nodes: (nodes, 2),
    "displacement": lambda cases, nodes: (cases, nodes, 5),
    "force": lambda cases, nodes: (cases, nodes, 2, 5),
    "torque": lambda cases, nodes: (cases, nodes, 2),
    "stress": lambda cases, nodes: (cases, nodes, 2),
}
_OF_CASES_OF_SHAFT: Final = ("displacement", "force", "torque", "stress")
_OF_BEARING: Final = ("inner", "outer", "force")


@frozen(eq=False)
class SolvedShaft:
    """A shaft under load; SI.

    Attributes
    ----------
    shaft
        as it is given
    position
        of its nodes from its left end; (nodes,)
    diameter
        on the left and on the right of each node; (nodes, 2)
    displacement
        x, y, z, ry, rz of each node; (cases, nodes, 5)
    force
        what the part on the right puts on the part on the left: N, V_y, V_z, M_y, M_z, just left
        and just right of each node; (cases, nodes, 2, 5)
    torque
        likewise, about x; (cases, nodes, 2)
    stress
        nominal equivalent stress at the surface, by von Mises, of both; (cases, nodes, 2)
    euler_load
        the axial force at which it would buckle between its outermost bearings
    """

    shaft: Shaft
    position: FloatArray
    diameter: FloatArray
    displacement: FloatArray
    force: FloatArray
    torque: FloatArray
    stress: FloatArray
    euler_load: float

    @property
    def name(self) -> str:
        """What the machine calls it."""
        return self.shaft.name

    @property
    def deflection(self) -> FloatArray:
        """How far each node is from the axis; (cases, nodes), m."""
        return np.asarray(np.hypot(self.displacement[..., 1], self.displacement[..., 2]))

    @property
    def slope(self) -> FloatArray:
        """How much each node is turned; (cases, nodes), rad."""
        return np.asarray(np.hypot(self.displacement[..., 3], self.displacement[..., 4]))

    @property
    def bending_moment(self) -> FloatArray:
        """Bending moment of both planes together; (cases, nodes, 2), N·m."""
        return np.asarray(np.hypot(self.force[..., 3], self.force[..., 4]))

    @property
    def shear_force(self) -> FloatArray:
        """Shear force of both planes together; (cases, nodes, 2), N."""
        return np.asarray(np.hypot(self.force[..., 1], self.force[..., 2]))

    def displacement_at(self, position: float) -> FloatArray:
        """Return the displacement of the node nearest to a position; (cases, 5)."""
        return np.asarray(self.displacement[:, int(np.argmin(np.abs(self.position - position)))])


@frozen(eq=False)
class SeatedBearing:
    """A bearing in its machine; SI.

    Attributes
    ----------
    bearing
        as it is given
    solved
        its own result: what reads one reads this
    inner, outer
        displacement of its rings; (cases, 5)
    force
        that the shaft puts on its inner ring; (cases, 5), N and N·m
    """

    bearing: MachineBearing
    solved: Solved
    inner: FloatArray
    outer: FloatArray
    force: FloatArray

    @property
    def name(self) -> str:
        """What the machine calls it."""
        return self.bearing.name

    @property
    def tilt(self) -> FloatArray:
        """Angle between its rings; (cases,), rad."""
        apart = self.inner - self.outer
        return np.asarray(np.hypot(apart[:, 3], apart[:, 4]))

    @property
    def radial_force(self) -> FloatArray:
        """(cases,), N."""
        return np.asarray(np.hypot(self.force[:, 1], self.force[:, 2]))

    @property
    def max_pressure(self) -> FloatArray:
        """Greatest contact pressure of both races; (cases,), Pa."""
        races = [contacts.max_pressure.max(axis=1) for contacts in self.solved.contacts.values()]
        return np.asarray(np.max(races, axis=0))

    @property
    def relative_speed(self) -> FloatArray:
        """Speed of the rings against each other, without a sign; (cases,), rad/s."""
        own = self.solved
        return own.relative_speed


@frozen(eq=False)
class SolvedMachine:
    """Where a machine comes to rest, in each step of its spectrum.

    Attributes
    ----------
    machines
        what was solved: one; or several of one structure that differ in forces and speeds alone.
        The cases are all steps of the first, then all of the second, …
    status
        whether and how each case was solved; `unsupported` of "no_equilibrium" counts as in a
        bearing, of the part that `advice` names
    shafts, bearings
        by name
    notes
        what qualifies the result
    advice
        of each case that has no result, why
    """

    machines: tuple[Machine, ...]
    status: Status
    shafts: Mapping[str, SolvedShaft]
    bearings: Mapping[str, SeatedBearing]
    notes: tuple[tuple[Note, ...], ...]
    advice: tuple[Note | None, ...]

    def __len__(self) -> int:
        """Count the cases."""
        return len(self.status.number)

    @property
    def machine(self) -> Machine:
        """What was solved; of several the first."""
        return self.machines[0]

    @property
    def title(self) -> str:
        """The title of the machine."""
        return self.machine.title

    @property
    def share(self) -> FloatArray:
        """Share of the time of each case; (cases,)."""
        return np.concatenate([machine.step_shares for machine in self.machines])

    @property
    def steps(self) -> tuple[str, ...]:
        """What the cases of each machine are called."""
        steps = self.machine.spectrum
        return tuple(step.name or str(index + 1) for index, step in enumerate(steps)) or ("",)

    # --- of several machines --------------------------------------------------------------------

    @property
    def unsolved(self) -> tuple[int | None, ...]:
        """The first case of each machine that has no result; None if all have one."""
        lost = ~self.status.converged.reshape(len(self.machines), -1)
        return tuple(
            index * len(own) + int(own.argmax()) if own.any() else None
            for index, own in enumerate(lost)
        )

    def greatest(self, values: FloatArray) -> FloatArray:
        """Return the greatest of an array (cases, …) in all steps of each machine; (machines,).

        NaN of a machine that has no result in some step.
        """
        whole = values.reshape(len(self.machines), -1).max(axis=1)
        return np.where([case is not None for case in self.unsolved], np.nan, whole)

    def cases_of(self, index: int) -> slice:
        """Return the cases of a machine."""
        steps = len(self) // len(self.machines)
        return slice(index * steps, (index + 1) * steps)

    def of_machine(self, index: int) -> SolvedMachine:
        """Return the result of one machine."""
        machine, cases = self.machines[index], self.cases_of(index)
        return (
            self
            if len(self.machines) == 1
            else SolvedMachine(
                machines=(machine,),
                status=taken(self.status, cases),
                shafts={
                    name: replace(
                        one,
                        shaft=machine.shaft(name),
                        **{part: getattr(one, part)[cases] for part in _OF_CASES_OF_SHAFT},
                    )
                    for name, one in self.shafts.items()
                },
                bearings={
                    name: SeatedBearing(
                        bearing=machine.bearing(name),
                        solved=one.solved[cases],
                        **{part: getattr(one, part)[cases] for part in _OF_BEARING},
                    )
                    for name, one in self.bearings.items()
                },
                notes=self.notes[cases],
                advice=self.advice[cases],
            )
        )

    # --- as plain data --------------------------------------------------------------------------

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists in SI units, NaN as None."""
        status = self.status
        return {
            "schema": SCHEMA,
            "kind": KIND,
            "title": self.title,
            "steps": [
                {
                    "name": name,
                    "share": float(share),
                    "status": str(status.code[case]),
                    "residual": plain(float(status.residual[case])),
                    "iterations": int(status.iterations[case]),
                    "safe_path": bool(status.safe_path[case]),
                    "unsupported": int(status.unsupported[case]),
                    "advice": None if advice is None else advice.to_mapping(),
                    "notes": [note.to_mapping() for note in self.notes[case]],
                }
                for case, (name, share, advice) in enumerate(
                    zip(self.steps, self.share, self.advice, strict=True)
                )
            ],
            "shafts": [
                {
                    "name": one.name,
                    **{name: plain(getattr(one, name).tolist()) for name in _OF_SHAFT},
                    "euler_load": plain(one.euler_load),
                }
                for one in self.shafts.values()
            ],
            "bearings": [
                {
                    "name": one.name,
                    **{name: plain(getattr(one, name).tolist()) for name in _OF_BEARING},
                    "tilt": plain(one.tilt.tolist()),
                    "state": one.solved.whole_mapping(),
                }
                for one in self.bearings.values()
            ],
            "machine": self.machine.to_mapping(),
        }

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give everything as one JSON object in SI units, which `from_json` reads identically."""
        return dumps(self.to_mapping(), indent)

    @classmethod
    def from_mapping(cls, mapping: Mapping[str, Any]) -> SolvedMachine:
        """Read what `to_json` wrote, parsed: every number as it was written.

        Raises
        ------
        FileError
            If this is no result of a machine, or one of another schema.
        InputError
            If a key is missing or not what it should be.
        """
        if mapping.get("kind") != KIND or mapping.get("schema") != SCHEMA:
            raise FileError(
                said("is not the JSON of a solved machine"),
                example="rolamento shaft machine.toml --json machine.json",
            )
        try:
            machine = Machine.from_mapping(form.table(mapping, "machine"))
        except InputError as error:
            raise error.with_details(field=f"machine.{error.field}") from None
        steps = [form.entry(s, f"steps.{i}") for i, s in enumerate(form.rows(mapping, "steps"))]
        count = len(machine.spectrum) or 1
        if len(steps) != count:
            raise InputError(said("must be a list of {count} numbers", count=count), field="steps")
        codes = [form.text(step, "status") for step in steps]
        for index, code in enumerate(codes):
            if code not in STATUS_NUMBERS:
                raise InputError(said("is no status"), field=f"steps.{index}.status", value=code)
        status = Status(
            np.array([STATUS_NUMBERS[code] for code in codes]),
            np.array([form.number(step, "residual") for step in steps]),
            np.array([int(form.number(step, "iterations")) for step in steps]),
            np.array([form.truth(step, "safe_path") for step in steps]),
            np.array([int(form.number(step, "unsupported")) for step in steps]),
        )
        return cls(
            machines=(machine,),
            status=status,
            shafts=_read_shafts(machine, mapping, count),
            bearings=_read_bearings(machine, mapping, count),
            notes=tuple(
                tuple(form.note(one, f"steps.{i}.notes") for one in form.rows(step, "notes", 0))
                for i, step in enumerate(steps)
            ),
            advice=tuple(
                None
                if (given := form.value(step, "advice")) is None
                else form.note(given, f"steps.{i}.advice")
                for i, step in enumerate(steps)
            ),
        )

    @classmethod
    def from_json(cls, text: str) -> SolvedMachine:
        """Read what `to_json` wrote; raises as `from_mapping`, and if this is not JSON."""
        return cls.from_mapping(parse_mapping(text, "json", "<text>"))

    def to_xarray(self) -> xr.Dataset:
        """Give shafts and bearings as a dataset over case, node or bearing, and axis; SI."""
        import xarray as xr

        data: dict[str, Any] = {"status": ("case", self.status.code), "share": ("case", self.share)}
        for one in self.shafts.values():
            node = f"node of {one.name}"
            data[f"displacement of {one.name}"] = (("case", node, "axis"), one.displacement)
            data[f"force of {one.name}"] = (("case", node, "side", "load"), one.force)
            data[f"stress of {one.name}"] = (("case", node, "side"), one.stress)
            data[f"position of {one.name}"] = (node, one.position)
        seated = list(self.bearings.values())
        for name in _OF_BEARING:
            values = np.stack([getattr(one, name) for one in seated], axis=1)
            data[name] = (("case", "bearing", "load" if name == "force" else "axis"), values)
        data["tilt"] = (("case", "bearing"), np.stack([one.tilt for one in seated], axis=1))
        coordinates = {
            "bearing": list(self.bearings), "axis": list(AXES), "load": list(LOADS),
            "side": ["left", "right"],
        }  # fmt: skip
        return xr.Dataset(data, coordinates, {"title": self.title})

    def to_pandas(self, table: str = "bearings") -> pd.DataFrame:
        """Give one table as a data frame; SI.

        Parameters
        ----------
        table
            ``"bearings"``: forces and displacements, a line a step and bearing; ``"shafts"``: a
            line a step and node.

        Raises
        ------
        InputError
            For another table.
        """
        import pandas as pd

        cases = np.arange(len(self))
        if table == "bearings":
            frames = [
                pd.DataFrame({
                    "case": cases, "bearing": name, "status": one.solved.status.code,
                    **dict(zip(LOADS, one.force.T, strict=True)),
                    **dict(zip(AXES, one.inner.T, strict=True)),
                    **{f"outer_{a}": v for a, v in zip(AXES, one.outer.T, strict=True)},
                    "tilt": one.tilt,
                })
                for name, one in self.bearings.items()
            ]  # fmt: skip
        elif table == "shafts":
            frames = [
                pd.DataFrame({
                    "case": np.repeat(cases, len(one.position)), "shaft": name,
                    "position": np.tile(one.position, len(cases)),
                    **dict(zip(AXES, one.displacement.reshape(-1, 5).T, strict=True)),
                    **{
                        f"{load}_{side}": one.force[:, :, i, j].ravel()
                        for i, side in enumerate(("left", "right"))
                        for j, load in enumerate(LOADS)
                    },
                    "stress": one.stress.max(axis=2).ravel(),
                })
                for name, one in self.shafts.items()
            ]  # fmt: skip
        else:
            raise InputError(
                said("must be bearings or shafts"), field="table", value=table,
                example='solved.to_pandas("shafts")',
            )  # fmt: skip
        return pd.concat(frames, ignore_index=True)


def _read_shafts(
    machine: Machine, mapping: Mapping[str, Any], count: int
) -> dict[str, SolvedShaft]:
    items = form.rows(mapping, "shafts")
    _check_count(items, len(machine.shafts), "shafts")
    found = {}
    for index, (shaft, given) in enumerate(zip(machine.shafts, items, strict=True)):
        at = f"shafts.{index}."
        item = form.entry(given, at[:-1])
        nodes = len(form.rows(item, f"{at}position"))
        arrays = {
            name: form.array(item, f"{at}{name}", shape(count, nodes))
            for name, shape in _OF_SHAFT.items()
        }
        euler = form.number(item, f"{at}euler_load")
        found[shaft.name] = SolvedShaft(
            shaft=shaft, euler_load=float("inf") if np.isnan(euler) else euler, **arrays
        )
    return found


def _read_bearings(
    machine: Machine, mapping: Mapping[str, Any], count: int
) -> dict[str, SeatedBearing]:
    items = form.rows(mapping, "bearings")
    _check_count(items, len(machine.bearings), "bearings")
    found = {}
    for index, (bearing, given) in enumerate(zip(machine.bearings, items, strict=True)):
        at = f"bearings.{index}."
        item = form.entry(given, at[:-1])
        solved = Solved.from_mapping(form.table(item, f"{at}state"))
        arrays = {name: form.array(item, f"{at}{name}", (count, 5)) for name in _OF_BEARING}
        found[bearing.name] = SeatedBearing(bearing=bearing, solved=solved, **arrays)
    return found


def _check_count(items: list[Any], count: int, field: str) -> None:
    if len(items) != count:
        raise InputError(said("must be a list of {count} tables", count=count), field=field)
