"""Solve machines: shafts on their bearings, and all that a bearing's own result says of each.

The equilibrium is found by `rolamento.system.shafts`; here the bearings are taken as they run, and
what comes out is put into records. Each bearing's result is that of its case under the load and at
the tilt that the machine gives it: solved alone, it gives the same.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import pi, radians
from typing import Final

import numpy as np

from rolamento.case import Case
from rolamento.case.duty import AXES, LOADS, Displacement, Duty, Load
from rolamento.case.machine import Machine, Step, load_machine
from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.solved import Solved, Status
from rolamento.solved.machine import (
    SeatedBearing,
    SolvedMachine,
    SolvedShaft,
)
from rolamento.status import CONVERGED, NO_EQUILIBRIUM, STATUS_NAMES
from rolamento.system import Balanced, Cases, result, spread
from rolamento.system.guidance import solve_by_jones
from rolamento.system.network import FIVE, gravest, seen_by_row
from rolamento.system.ring import condensed
from rolamento.system.shafts import Beam, MachineRest, Seat, Structure, structure_of
from rolamento.words import Note, said

__all__ = ["acts_alone", "shaft", "solve_machine", "solve_machines"]

MOST_TILT: Final = radians(5.0)
"""Between the rings of a bearing: what a `Duty` takes."""
BUCKLING_SHARE: Final = 0.05
"""Axial force over the Euler load above which its say in the bending, which is left out, counts."""


def shaft(machine: Machine | str | os.PathLike[str]) -> SolvedMachine:
    """Find where the shafts of a machine come to rest, and what each of its bearings carries.

    Parameters
    ----------
    machine
        A `Machine`, or its file.

    Returns
    -------
    SolvedMachine
        A case for each step of the machine's spectrum, or one. Never raises for a machine without
        equilibrium: the status says so, with advice, and its numbers are NaN.

    Raises
    ------
    InputError
        If the machine is not valid, or a bearing asks for what a machine cannot give.
    FileError
        If the file cannot be read.

    Friswell, Penny, Garvey and Lees, Dynamics of Rotating Machines (2010), chapter 5, of the
    shafts; Harris, Rolling Bearing Analysis, 3rd ed. (1991), chapter 8, of the bearings.
    """
    return solve_machine(machine if isinstance(machine, Machine) else load_machine(machine))


def solve_machine(machine: Machine) -> SolvedMachine:
    """As `shaft`."""
    return solve_machines((machine,))


def solve_machines(
    machines: Sequence[Machine],
    *,
    cases: Mapping[str, Case] | None = None,
    shifts: Mapping[str, float] | None = None,
) -> SolvedMachine:
    """Solve machines that differ in nothing but what `acts_alone`, all steps of all at once.

    Parameters
    ----------
    machines
        At least one.
    cases
        By the name of a bearing, in the place of its own: such as it is at other temperatures.
    shifts
        How far warm parts move the inner ring of a bearing along its own x against its outer ring,
        by name, in m.

    Raises
    ------
    InputError
        As `shaft`, of any of them.
    """
    structure, rest, control = balanced(*machines, cases=cases, shifts=shifts)
    tilted = _too_far(structure, rest)
    bearings = _bearings(structure, rest, control)
    outside = structure.carried(rest)
    shafts = {
        beam.shaft.name: _shaft(machines, structure, beam, rest.place, outside)
        for beam in structure.beams
    }
    number = rest.number
    status = Status(
        number, rest.rest.residual, rest.iterations, rest.safe_path,
        np.where(rest.rest.unsupported >= 0, rest.rest.unsupported % FIVE, -1),
    )  # fmt: skip
    steps = len(structure) // len(machines)
    return SolvedMachine(
        machines=tuple(machines),
        status=status,
        shafts=shafts,
        bearings=bearings,
        notes=tuple(
            _notes(machines[case // steps], shafts, case) for case in range(len(structure))
        ),
        advice=tuple(
            tilted.get(case) or _advice(structure, rest, bearings, case)
            for case in range(len(structure))
        ),
    )


_ACTS: Final[Mapping[str, tuple[str, ...]]] = {
    "shafts": ("speed", "ratio"),
    "loads": ("fx", "fy", "fz", "mx", "my", "mz"),
    "gears": ("torque", "power"),
    "belts": ("tight", "slack", "tension", "torque", "power"),
    "spectrum": ("share", "speed_factor", "load_factor"),
}
"""Forces and speeds: fields of parts that leave the structure of a machine as it is."""


def acts_alone(machine: Machine, key: Sequence[str]) -> bool:
    """Return whether machines that differ in a field can be solved together.

    Parameters
    ----------
    machine
        One of them.
    key
        The parts of the field's name, such as ``("loads", "0", "fz")``.
    """
    kind, leaf = key[0], key[-1]
    if len(key) != 3 or leaf not in _ACTS.get(kind, ()):
        return False
    if leaf not in ("speed", "ratio", "speed_factor"):
        return True
    # the fit of a set is taken at its fastest step
    cases = [bearing.case for bearing in machine.bearings]
    return not any(case.mounting is not None and case.bearing.is_set for case in cases)


def balanced(
    *machines: Machine,
    cases: Mapping[str, Case] | None = None,
    shifts: Mapping[str, float] | None = None,
) -> tuple[Structure, MachineRest, FloatArray]:
    """Lay machines out and find where they come to rest; what guides each rolling element.

    cases, shifts: as of `solve_machines`.
    """
    structure = laid_out(*machines, cases=cases, shifts=shifts)
    rest, control = _solved(structure)
    return structure.guided(control), rest, control


def laid_out(
    *machines: Machine,
    cases: Mapping[str, Case] | None = None,
    shifts: Mapping[str, float] | None = None,
) -> Structure:
    """Return machines as a network of nodes; cases, shifts: as of `solve_machines`."""
    given = cases or {}
    running = [
        _running(machines, index, given.get(bearing.name))
        for index, bearing in enumerate(machines[0].bearings)
    ]
    return structure_of(machines, running, shifts)


# --- the bearings as they run ---------------------------------------------------------------------


def _running(machines: Sequence[Machine], index: int, given: Case | None = None) -> Cases:
    """The cases of a bearing, with the clearance in operation and the speeds of its rings."""
    bearing, field = machines[0].bearings[index], f"bearings.{index}"
    case = bearing.case if given is None else given
    if case.model.raceway_control == "friction" or case.model.film_field:
        raise InputError(
            said("is for a bearing alone, not for one in a machine"),
            field=f"{field}.{case.model.film_field or 'model.raceway_control'}",
            example='raceway_control = "jones"',
        )
    inner, outer = bearing.shaft, bearing.outer_shaft
    values: dict[str, FloatArray] = {
        "duty.inner_speed": _speeds(machines, inner),
        "duty.outer_speed": _speeds(machines, outer),
    }
    try:
        return _mounted(case, values)
    except InputError as error:
        raise error.with_details(field=f"{field}.{error.field}" if error.field else field) from None


def _speeds(machines: Sequence[Machine], shaft: str | None) -> FloatArray:
    """The speed of a shaft in all steps of all machines; none of a ring that is on no shaft."""
    found = [
        step.speed_factor * (0.0 if shaft is None else machine.speed(shaft))
        for machine in machines
        for step in machine.spectrum or (Step(share=1.0),)
    ]
    return np.array(found)


def _mounted(case: Case, values: Mapping[str, FloatArray]) -> Cases:
    if case.mounting is None:
        return spread(case, values)
    if case.bearing.is_set:
        from rolamento.system.mounted import running_set

        fastest = int(np.argmax(np.abs(values["duty.inner_speed"])))
        duty = Duty(**{name.partition(".")[2]: float(v[fastest]) for name, v in values.items()})
        running = running_set(case.replace(duty=duty))
        return spread(running, values)
    from rolamento.clearance import operating_batch

    running, of_running = operating_batch(case, dict(values))
    return spread(running, dict(of_running))


def _solved(structure: Structure) -> tuple[MachineRest, FloatArray]:
    """Where the machine comes to rest, and what guides each rolling element."""
    modes = [seat.cases.case.model.raceway_control for seat in structure.seats]
    if "jones" in modes:
        rest, control, _ = solve_by_jones(structure)
        return rest, control
    parts = [
        np.full((1, seat.element_count), -1.0 if mode == "inner" else 1.0)
        for seat, mode in zip(structure.seats, modes, strict=True)
    ]
    control = np.concatenate(parts, axis=1)
    return structure.guided(control).solve(), np.broadcast_to(control, structure.shape)


# --- results --------------------------------------------------------------------------------------


def _too_far(structure: Structure, rest: MachineRest) -> dict[int, Note]:
    """Advice on cases whose rings are tilted beyond what the equations are for: no result."""
    found: dict[int, Note] = {}
    for seat in structure.seats:
        outer = 0.0 if seat.outer is None else rest.place[:, seat.outer, 3:]
        tilt = np.abs(rest.place[:, seat.inner, 3:] - outer).max(axis=1)
        for case in np.flatnonzero((rest.number == CONVERGED) & (tilt > MOST_TILT)).tolist():
            values = {"bearing": seat.bearing.name, "tilt": float(tilt[case]), "most": MOST_TILT}
            found.setdefault(case, Note("tilted_too_far", values))
    rest.number[list(found)] = NO_EQUILIBRIUM
    return found


def _bearings(
    structure: Structure, rest: MachineRest, control: FloatArray
) -> dict[str, SeatedBearing]:
    found = {}
    settled = rest.number != NO_EQUILIBRIUM
    parts = structure.split(control)
    for (seat, rows), own in zip(structure.held_rows(rest), parts, strict=True):
        inner = rest.place[:, seat.inner]
        outer = np.zeros_like(inner) if seat.outer is None else rest.place[:, seat.outer]
        n = len(inner)
        turn = np.array([seat.way, 1.0, 1.0, seat.way, seat.way])
        place = (inner - outer) * turn
        place[:, 0] += seat.offset
        force, stiffness = np.zeros((n, FIVE)), np.zeros((n, 2 * FIVE, 2 * FIVE))
        for placed, row in zip(seat.cases.rows, rows, strict=True):
            t = seen_by_row(placed.sign, placed.lever)
            if seat.slide is not None:
                along = np.zeros((n, FIVE, FIVE))
                along[:, 0, 0] = 1.0 if placed.sign < 0.0 else 0.0
                t = np.concatenate([t, along], axis=2)
            back = np.swapaxes(t, 1, 2)
            force += (back @ row.force[..., np.newaxis])[:, :FIVE, 0]
            size = t.shape[2]
            stiffness[:, :size, :size] += back @ (row.stiffness @ t)
        lost = rest.number != CONVERGED
        place[lost], force[lost], stiffness[lost] = np.nan, np.nan, np.nan
        number, unsupported = gravest(rows, n)
        number = np.where(settled & (rest.number == CONVERGED), number, rest.number)
        status = Status(
            number, np.max([row.residual for row in rows], axis=0), rest.iterations,
            rest.safe_path, unsupported,
        )  # fmt: skip
        own_stiffness = condensed(stiffness if seat.slide is not None else stiffness[:, :5, :5])
        solved = _solved_bearing(
            seat, Balanced(status, place, force, own_stiffness, rows, own, own.astype(np.int64))
        )
        shown = force * turn
        found[seat.bearing.name] = SeatedBearing(
            seat.bearing, solved, _without(inner, lost), _without(outer, lost), shown
        )
    return found


def _without(place: FloatArray, lost: FloatArray) -> FloatArray:
    return np.where(lost[:, np.newaxis], np.nan, place)


def _solved_bearing(seat: Seat, balanced: Balanced) -> Solved:
    """A bearing's own result: under its forces, at the tilt of its rings.

    What floats has a place along x and no force.
    """
    floats = all(placed.row.floats for placed in seat.cases.rows)
    free = np.array([not floats, True, True, False, False])
    place, force = balanced.place, balanced.force
    known = {
        name: force[:, i] if free[i] else place[:, i]
        for i, name in enumerate(
            f"duty.load.{load}" if free[i] else f"duty.displacement.{axis}"
            for i, (axis, load) in enumerate(zip(AXES, LOADS, strict=True))
        )
    }
    case = seat.cases.case
    varied = {**seat.cases.varied, **known}
    if len(place) == 1:  # a single case is written out, as it would be solved alone
        case = _written_out(case, varied, free)
        varied = {}
    cases = replace(
        seat.cases,
        case=case,
        varied=varied,
        free=np.broadcast_to(free, place.shape),
        load=np.where(free, force, 0.0),
        displacement=np.where(free, 0.0, place),
    )
    return result(cases, balanced)


def _written_out(case: Case, values: Mapping[str, FloatArray], free: FloatArray) -> Case:
    own = {name: float(value[0]) for name, value in values.items() if np.isfinite(value[0])}
    load = {k.rpartition(".")[2]: v for k, v in own.items() if k.startswith("duty.load.")}
    shift = {k.rpartition(".")[2]: v for k, v in own.items() if k.startswith("duty.displacement.")}
    speeds = {k.rpartition(".")[2]: v for k, v in own.items() if k.endswith("_speed")}
    rest = {k: v for k, v in own.items() if not k.startswith("duty.")}
    duty = Duty(load=Load(**load), displacement=Displacement(**shift), **speeds)
    return case.with_(rest).replace(duty=duty)


def _section_forces(machine: Machine, beam: Beam, outside: FloatArray) -> FloatArray:
    """What the right part puts on the left at both sides of each node; (cases, nodes, 2, 5).

    By statics alone: the sum of what acts on the right of the cut.
    """
    x = beam.place[:, np.newaxis]
    about = outside.copy()  # moments about x = 0
    about[..., 3] -= x[:, 0] * outside[..., 2]
    about[..., 4] += x[:, 0] * outside[..., 1]
    beyond = np.flip(np.cumsum(np.flip(about, 1), axis=1), 1)
    shown = np.zeros((*outside.shape[:2], 2, FIVE))
    shown[:, :, 0] = beyond
    shown[:, :-1, 1] = beyond[:, 1:]
    shown[..., 3] += x * shown[..., 2]
    shown[..., 4] -= x * shown[..., 1]
    if machine.gravity is not None:  # weights stand at nodes, but act between them
        weight = beam.elements.body_load(np.array(machine.gravity.vector))
        shown[:, 1:, 0] -= weight[:, FIVE:]
        shown[:, :-1, 1] += weight[:, :FIVE]
    shown[:, 0, 0], shown[:, -1, 1] = 0.0, 0.0
    return shown


def _shaft(
    machines: Sequence[Machine],
    structure: Structure,
    beam: Beam,
    place: FloatArray,
    outside: FloatArray,
) -> SolvedShaft:
    elements = beam.elements
    cases, nodes = len(place), len(beam.place)
    shown = _section_forces(machines[0], beam, outside[:, beam.nodes])
    torque = np.concatenate([_torque(machine, beam) for machine in machines])
    sides = [elements.sections(right=True), elements.sections(right=False)]
    diameter, stress = np.zeros((nodes, 2)), np.zeros((cases, nodes, 2))
    for side, (section, where) in enumerate(
        zip(sides, (slice(1, None), slice(None, -1)), strict=True)
    ):
        own = section.diameter
        diameter[where, side] = own
        bending = np.hypot(shown[:, where, side, 3], shown[:, where, side, 4])
        normal = np.abs(shown[:, where, side, 0]) / section.area
        normal = normal + bending * 0.5 * own / section.inertia
        shear = torque[:, where, side] * 0.25 * own / section.inertia
        stress[:, where, side] = np.sqrt(normal**2 + 3.0 * shear**2)
    diameter[0, 0], diameter[-1, 1] = diameter[0, 1], diameter[-1, 0]
    return SolvedShaft(
        shaft=beam.shaft,
        position=beam.place - beam.shaft.position,
        diameter=diameter,
        displacement=place[:, beam.nodes],
        force=shown,
        torque=torque,
        stress=stress,
        euler_load=_euler_load(structure, beam),
    )


def _torque(machine: Machine, beam: Beam) -> FloatArray:
    """Torque in the shaft on both sides of its nodes; (cases, nodes, 2), N·m.

    What the torques that are given leave over is taken at the right end.
    """
    steps = machine.spectrum or (None,)
    torque = np.zeros((len(steps), len(beam.place), 2))
    for case, step in enumerate(steps):
        for force in machine.forces(step):
            if force.shaft == beam.shaft.name:
                node = beam.node_at(force.position) - beam.first
                torque[case, node, 1] -= force.force[3]
                torque[case, node + 1 :] -= force.force[3]
    torque[:, 0, 0] = 0.0
    torque[:, -1, 1] = 0.0
    return torque


def _euler_load(structure: Structure, beam: Beam) -> float:
    """π² E I/L² between the outermost bearings, of the mean flexibility there; N."""
    on = [seat.inner for seat in structure.seats if seat.inner in beam.nodes]
    on += [s.outer for s in structure.seats if s.outer is not None and s.outer in beam.nodes]
    if len(set(on)) < 2:
        return float("inf")
    first, last = min(on) - beam.first, max(on) - beam.first
    some = slice(first, last)
    length = beam.elements.length[some]
    bending = beam.elements.sections(right=False).bending[some]
    return float(pi**2 / (length.sum() * (length / bending).sum()))


def _notes(machine: Machine, shafts: Mapping[str, SolvedShaft], case: int) -> tuple[Note, ...]:
    found = list(machine.notes)
    for one in shafts.values():
        axial = float(np.abs(one.force[case, ..., 0]).max())
        if axial > BUCKLING_SHARE * one.euler_load:
            found.append(
                Note("near_buckling", {"shaft": one.name, "share": axial / one.euler_load})
            )
        left, most = abs(float(one.torque[case, -1, 0])), float(np.abs(one.torque[case]).max())
        if left > 1e-6 * most > 0.0:
            found.append(Note("torque_left_over", {"shaft": one.name, "torque": left}))
    return tuple(found)


def _advice(
    structure: Structure, rest: MachineRest, bearings: Mapping[str, SeatedBearing], case: int
) -> Note | None:
    number = int(rest.number[case])
    if number == CONVERGED:
        return None
    unknown = int(rest.rest.unsupported[case])
    if number == NO_EQUILIBRIUM and unknown >= 0:
        node, axis = divmod(unknown, FIVE)
        for beam in structure.beams:
            if node in beam.nodes:
                return Note("shaft_not_held", {"shaft": beam.shaft.name, "axis": AXES[axis]})
        for seat in structure.seats:
            if node in (seat.outer, seat.slide):
                return Note("ring_not_held", {"bearing": seat.bearing.name, "axis": AXES[axis]})
    for name, seated in bearings.items():
        own = int(seated.solved.status.number[case])
        if own not in (CONVERGED, number) or own == number != NO_EQUILIBRIUM:
            return Note("bearing_of_machine", {"bearing": name, "status": STATUS_NAMES[own]})
    return Note("machine_not_converged", {})
