"""How a machine vibrates: modes, Campbell diagram, unbalance, stiffness at a place.

Each speed has an operating point of its own: the bearings' stiffness changes with speed and load.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize import linear_sum_assignment

from rolamento.case.machine import Machine, Step, load_machine
from rolamento.errors import InputError
from rolamento.machines import balanced
from rolamento.numerics import BoolArray, ComplexArray, FloatArray, IntArray
from rolamento.records import frozen
from rolamento.rows.row import Response
from rolamento.solved.maps import MapAxis, StiffnessMap
from rolamento.solved.rotor import Campbell, CriticalSpeed, Modes, UnbalanceResponse, whirl_names
from rolamento.status import CONVERGED, STATUS_NAMES
from rolamento.system.network import FIVE, unknowns_of
from rolamento.system.rotor import Eigenmodes, Rotor, rotor_of, unbalance_force
from rolamento.system.shafts import MachineRest, Seat, Structure
from rolamento.validate import number, whole_number
from rolamento.words import Note, said

__all__ = [
    "Campbell",
    "CriticalSpeed",
    "Modes",
    "UnbalanceResponse",
    "campbell",
    "compliance",
    "natural_modes",
    "supports",
    "turning_shaft",
    "unbalance_response",
]

DAMPING: Final = 1e-5
"""s; of the stiffness, where a response needs some and none is given."""
MOST_SPEEDS: Final = 2000
MOST_MODES: Final = 60
REFINED: Final = 8
"""How often a critical speed is sought at most."""
MET: Final = 1e-8
"""Part of a frequency by which it may miss an order where they meet."""
_AXIAL: Final = 0.9
"""Part of the sum of all squares of shifts from which on a mode counts as axial."""

Source = Machine | str | os.PathLike[str]


def natural_modes(
    machine: Source,
    *,
    speed: float | None = None,
    shaft: str | None = None,
    count: int = 8,
    damping: float = 0.0,
) -> Modes:
    """Natural frequencies and modes at the machine's own speed and load, or another speed.

    Parameters
    ----------
    machine
        A `Machine`, or its file; of a spectrum the first step counts.
    speed
        rad/s; the bearings are solved anew at it. The machine's own if not given.
    shaft
        Whose speed it is; the first that turns if not given.
    count
        How many modes, at most 60.
    damping
        s: the damping matrix is so many times the stiffness.

    Returns
    -------
    Modes

    Raises
    ------
    InputError
        If the machine is not valid, or has no equilibrium.
    FileError
        If the file cannot be read.

    Friswell, Penny, Garvey and Lees, Dynamics of Rotating Machines (2010), chapter 5.
    """
    base, by = _machine(machine), None
    if speed is not None:
        by = _checked_speeds(speed) / base.speed(turning_shaft(base, shaft))
    given, structure, rest, rotor = _at_work(base, by, damping)
    _refuse_lost(rest)
    found = rotor.modes(0, whole_number(count, "count", 1, MOST_MODES))
    shapes = found.shape.reshape(len(found.shape), -1, FIVE)
    return Modes(
        machine=given,
        frequency=found.frequency,
        damping_ratio=found.damping_ratio,
        whirl=whirl_names(found.forward, _axial(shapes)),
        position=_positions(structure),
        shape={beam.shaft.name: shapes[:, beam.nodes] for beam in structure.beams},
    )


def campbell(
    machine: Source,
    speeds: ArrayLike,
    *,
    shaft: str | None = None,
    count: int = 8,
    orders: Sequence[float] = (1.0,),
    damping: float = 0.0,
) -> Campbell:
    """Natural frequencies over speed, and where they meet orders of the rotation.

    Parameters
    ----------
    machine
        A `Machine`, or its file; its own speeds say how fast the shafts turn to each other.
    speeds
        (speeds,), rad/s, at most 2000.
    shaft
        Whose speeds they are; the first that turns if not given.
    count, damping
        As of `natural_modes`.
    orders
        Of the rotation, such as 2 for twice a revolution, or the teeth of a gear. Where a branch
        meets one between two speeds, the machine is solved anew until both are one to 1e-8.

    Returns
    -------
    Campbell

    Raises
    ------
    InputError
        As `natural_modes`; or if no shaft turns.
    """
    base = _machine(machine)
    name = turning_shaft(base, shaft)
    asked = _checked_speeds(speeds)
    given, _, rest, rotor = _at_work(base, asked / base.speed(name), damping)
    count = whole_number(count, "count", 1, MOST_MODES)
    frequency = np.full((len(asked), count), np.nan)
    ratio, whirl = np.full(frequency.shape, np.nan), np.full(frequency.shape, "", "U16")
    before: Eigenmodes | None = None
    modes: list[Eigenmodes | None] = [None] * len(asked)
    for case in range(len(asked)):
        if rest.number[case] != CONVERGED:
            before = None
            continue
        found = rotor.modes(case, count)
        order: IntArray = np.arange(len(found.frequency))
        if before is not None:
            order = _followed(before, found, rotor.mass)
        found = Eigenmodes(found.eigenvalue[order], found.shape[order], found.forward[order])
        shapes = found.shape.reshape(len(order), -1, FIVE)
        frequency[case, : len(order)] = found.frequency
        ratio[case, : len(order)] = found.damping_ratio
        whirl[case, : len(order)] = whirl_names(found.forward, _axial(shapes))
        before = modes[case] = found
    return Campbell(
        machine=given,
        shaft=name,
        speed=asked,
        status=np.array([STATUS_NAMES[int(one)] for one in rest.number]),
        frequency=frequency,
        damping_ratio=ratio,
        whirl=whirl,
        critical=_critical(
            _Run(base, name, count, damping, rotor.mass), asked, modes, frequency, whirl, orders
        ),
    )


def unbalance_response(
    machine: Source,
    speeds: ArrayLike,
    *,
    shaft: str | None = None,
    damping: float | None = None,
) -> UnbalanceResponse:
    """Steady vibration by the unbalances of a shaft's masses over its speed.

    Parameters
    ----------
    machine, speeds, shaft
        As of `campbell`.
    damping
        s: the damping matrix is so many times the stiffness. 1e-5 s if not given, with a note: the
        amplitudes at resonance are as uncertain as that.

    Returns
    -------
    UnbalanceResponse

    Raises
    ------
    InputError
        As `campbell`; or if nothing on the shaft is unbalanced.

    Friswell, Penny, Garvey and Lees, Dynamics of Rotating Machines (2010), chapter 6.
    """
    base = _machine(machine)
    name = turning_shaft(base, shaft)
    if not any(mass.unbalance for mass in base.masses if mass.shaft == name):
        raise InputError(
            said("is missing: nothing on shaft {shaft} is unbalanced", shaft=f'"{name}"'),
            field="masses",
            example='unbalance = "100 g mm"',
        )
    asked = _checked_speeds(speeds)
    used = DAMPING if damping is None else damping
    given, structure, rest, rotor = _at_work(base, asked / base.speed(name), used)
    moved = np.full((len(asked), len(structure.held)), np.nan + 0j)
    for case, speed in enumerate(asked.tolist()):
        if rest.number[case] == CONVERGED:
            force = unbalance_force(given, structure, speed, name)
            moved[case] = rotor.response(case, speed, force)
    nodes = moved.reshape(len(asked), -1, FIVE)
    notes = [] if damping is not None else [Note("assumed_damping", {"damping": DAMPING})]
    added, carried = _bearing_forces(structure, rest, nodes)
    notes += _beyond_linear(asked, added, carried)
    return UnbalanceResponse(
        machine=given,
        shaft=name,
        speed=asked,
        position=_positions(structure),
        displacement={beam.shaft.name: nodes[:, beam.nodes] for beam in structure.beams},
        force=added,
        damping=used,
        notes=tuple(notes),
    )


def compliance(machine: Source, shaft: str, position: float) -> FloatArray:
    """How a place of a shaft yields to small loads there, at the operating point of each step.

    Parameters
    ----------
    machine
        A `Machine`, or its file.
    shaft, position
        The shaft's name, and the place from its left end, in m.

    Returns
    -------
    (cases, 5, 5), m and rad by N and N·m; NaN without equilibrium. Its inverse is the stiffness
    there.

    Raises
    ------
    InputError
        As `natural_modes`; or if there is no such place.
    """
    given = _machine(machine)
    length = given.shaft(shaft).length
    number(position, "position", least=0.0, most=length, unit="m", example="0.1")
    structure, rest, _ = balanced(given)
    beam = next(one for one in structure.beams if one.shaft.name == shaft)
    at = FIVE * beam.node_at(position) + np.arange(FIVE)
    free = np.flatnonzero(~structure.held)
    unit = np.zeros((len(structure.held), FIVE))
    unit[at, np.arange(FIVE)] = 1.0
    tangent = structure.tangent(rest)[:, free[:, np.newaxis], free]
    out = np.full((len(structure), FIVE, FIVE), np.nan)
    known = rest.number == CONVERGED
    where = np.searchsorted(free, at)
    out[known] = np.linalg.solve(tangent[known], unit[free])[:, where]
    return out


def supports(
    machine: Source, speeds: ArrayLike, *, shaft: str | None = None
) -> tuple[StiffnessMap, ...]:
    """How each bearing holds its shaft over speed, with what stands under its outer ring.

    Parameters
    ----------
    machine, speeds, shaft
        As of `campbell`.

    Returns
    -------
    A `StiffnessMap` for each bearing, over the speed of the shaft that its inner ring is on.
    Housings and springs under its outer ring are condensed into it; of a matrix over several
    bearings what couples them is left out, with a note of its size. Displacements are those of the
    inner ring against the outer one.

    Raises
    ------
    InputError
        As `campbell`.
    """
    base = _machine(machine)
    name = turning_shaft(base, shaft)
    asked = _checked_speeds(speeds)
    given, structure, rest = _at_rest(base, asked / base.speed(name))
    known = rest.number == CONVERGED
    status = np.array([STATUS_NAMES[int(one)] for one in rest.number])
    tangent = structure.tangent(rest)
    found = []
    for seat, rows in structure.held_rows(rest):
        stiffness = np.full((len(asked), FIVE, FIVE), np.nan)
        force, place = np.full((2, len(asked), FIVE), np.nan)
        own, between = _held(structure, tangent, seat, rows, known)
        stiffness[known] = own
        outer = 0.0 if seat.outer is None else rest.place[:, seat.outer]
        for row, held in zip(seat.rows(), rows, strict=True):
            force[known] = np.nan_to_num(force[known]) + row.on_nodes(held.force)[known]
        place[known] = (rest.place[:, seat.inner] - outer)[known]
        bearing = seat.bearing
        own_shaft = bearing.shaft if base.speed(bearing.shaft) else name
        ratio = abs(base.speed(own_shaft) / base.speed(name))
        notes = []
        if between > 0.0:
            values = {"bearing": bearing.name, "stiffness": between}
            notes.append(Note("coupled_by_housing", values))
        axis = MapAxis(f"shafts.{own_shaft}.speed", "rad/s", np.abs(asked) * ratio)
        found.append(
            StiffnessMap(
                bearing.name, (axis,), stiffness, force, place, status, {"title": given.title},
                tuple(notes),
            )
        )  # fmt: skip
    return tuple(found)


def turning_shaft(machine: Machine, shaft: str | None) -> str:
    """Return the shaft whose speed counts.

    Parameters
    ----------
    machine
        Whose shafts they are.
    shaft
        Its name; None for the first that turns.

    Raises
    ------
    InputError
        If there is none of that name, it does not turn, or none does.
    """
    if shaft is not None:
        if machine.speed(machine.shaft(shaft).name) == 0.0:
            raise InputError(
                said("does not turn; give it a speed, of which others are fractions"),
                field="shaft",
                value=shaft,
                example='speed = "1480 rpm"',
            )
        return shaft
    for one in machine.shafts:
        if machine.speed(one.name) != 0.0:
            return one.name
    raise InputError(
        said("does not turn; give it a speed, of which others are fractions"),
        field="shafts.0.speed",
        example='speed = "1480 rpm"',
    )


# --- parts ----------------------------------------------------------------------------------------


def _machine(source: Source) -> Machine:
    return source if isinstance(source, Machine) else load_machine(source)


def _at_work(
    machine: Machine, factors: FloatArray | None, damping: float
) -> tuple[Machine, Structure, MachineRest, Rotor]:
    """The machine at several speeds and its matrices, as `_at_rest`."""
    given, structure, rest = _at_rest(machine, factors)
    by = [step.speed_factor for step in given.spectrum]
    speeds = {shaft.name: np.array(by) * given.speed(shaft.name) for shaft in given.shafts}
    return given, structure, rest, rotor_of(given, structure, rest, speeds, damping)


def _at_rest(
    machine: Machine, factors: FloatArray | None
) -> tuple[Machine, Structure, MachineRest]:
    """The machine at several speeds, under the load of its first step or its only one."""
    first = machine.spectrum[0] if machine.spectrum else None
    by = np.array([1.0 if first is None else first.speed_factor]) if factors is None else factors
    heavier = 1.0 if first is None else first.load_factor
    steps = [Step(share=1.0 / len(by), speed_factor=float(one), load_factor=heavier) for one in by]
    given = machine.replace(spectrum=steps)
    structure, rest, _ = balanced(given)
    return given, structure, rest


def _held(
    structure: Structure,
    tangent: FloatArray,
    seat: Seat,
    rows: Sequence[Response],
    known: BoolArray,
) -> tuple[FloatArray, float]:
    """How a bearing holds its inner ring, its outer one following; and what couples it to others.

    (known cases, 5, 5), and the greatest stiffness to rings of other bearings, N/m.
    """
    stiffness = np.sum(
        [
            row.tangent(held)[known, :FIVE, :FIVE]
            for row, held in zip(seat.rows(), rows, strict=True)
        ],
        axis=0,
    )
    on_shafts = structure.beams[-1].nodes[-1]
    rings = tuple(n for n in (seat.outer, seat.slide) if n is not None and n > on_shafts)
    if not rings:
        return stiffness, 0.0
    at = unknowns_of(rings)
    at = at[~structure.held[at]]
    inner = unknowns_of((seat.inner,))
    whole = tangent[known]
    coupled = whole[:, inner[:, np.newaxis], at]
    yields = np.linalg.pinv(whole[:, at[:, np.newaxis], at])
    back = whole[:, at[:, np.newaxis], inner]
    of_rings = np.arange(FIVE * (on_shafts + 1), len(structure.held))
    others = np.setdiff1d(of_rings[~structure.held[of_rings]], at)
    shifts = others[others % FIVE < 3]
    between = whole[:, at[at % FIVE < 3][:, np.newaxis], shifts]
    return stiffness - coupled @ yields @ back, float(np.abs(between).max(initial=0.0))


def _refuse_lost(rest: MachineRest) -> None:
    if rest.number[0] != CONVERGED:
        raise InputError(
            said("has no equilibrium; see what `rolamento shaft` says of it"), field="machine"
        )


def _checked_speeds(speeds: ArrayLike) -> FloatArray:
    asked = np.atleast_1d(np.asarray(speeds, np.float64))
    if asked.ndim != 1 or not 1 <= asked.size <= MOST_SPEEDS or not np.isfinite(asked).all():
        raise InputError(
            said("must be 1 to {most} finite numbers", most=MOST_SPEEDS), field="speeds"
        )
    return asked


def _positions(structure: Structure) -> dict[str, FloatArray]:
    return {beam.shaft.name: beam.place - beam.shaft.position for beam in structure.beams}


def _axial(shapes: ComplexArray) -> BoolArray:
    """Which modes shift shafts along their axis; (modes,)."""
    energy = (np.abs(shapes[..., :3]) ** 2).sum(axis=1)
    return np.asarray(energy[:, 0] > _AXIAL * energy.sum(axis=1))


def _followed(before: Eigenmodes, found: Eigenmodes, mass: FloatArray) -> IntArray:
    """In which order modes go on from those of the speed before: by their shapes.

    The modal assurance criterion, weighted by mass; Allemang and Brown (1982).
    """
    a, b = before.shape, found.shape
    cross = np.abs(np.conj(a) @ mass @ b.T) ** 2
    own = [((np.conj(s) @ mass) * s).sum(axis=1).real for s in (a, b)]
    likeness = cross / (own[0][:, np.newaxis] * own[1])
    _, order = linear_sum_assignment(-likeness)
    return np.asarray(order)


@frozen(eq=False)
class _Run:
    """What a Campbell diagram is made of; mass: by which modes are known again."""

    machine: Machine
    shaft: str
    count: int
    damping: float
    mass: FloatArray

    def frequencies(
        self, speeds: FloatArray, near: Sequence[Eigenmodes], branches: Sequence[int]
    ) -> FloatArray:
        """Frequency of a branch at each of some speeds, known by the modes of one nearby.

        NaN without equilibrium; (speeds,).
        """
        factors = speeds / self.machine.speed(self.shaft)
        _, _, rest, rotor = _at_work(self.machine, factors, self.damping)
        out = np.full(len(speeds), np.nan)
        for case in np.flatnonzero(rest.number == CONVERGED).tolist():
            found, branch = rotor.modes(case, self.count), branches[case]
            order = _followed(near[case], found, self.mass)
            if branch < len(order):
                out[case] = found.frequency[order[branch]]
        return out


@dataclass(slots=True)
class _Crossing:
    """A branch meets an order between two speeds; apart: by how much it lies above there."""

    order: float
    branch: int
    near: Eigenmodes
    whirl: str
    low: float
    high: float
    apart_low: float
    apart_high: float

    @property
    def at(self) -> float:
        """Where it would be on a straight line; rad/s."""
        step = self.apart_low - self.apart_high
        return self.low + (self.apart_low / step if step else 0.0) * (self.high - self.low)

    def narrow(self, speed: float, apart: float) -> None:
        """Take in what was found between the two: regula falsi as in Illinois.

        Dowell and Jarratt, A modified regula falsi method (1971).
        """
        if apart * self.apart_high <= 0.0:
            self.low, self.apart_low = self.high, self.apart_high
        else:
            self.apart_low *= 0.5
        self.high, self.apart_high = speed, apart


def _critical(
    run: _Run,
    speed: FloatArray,
    modes: Sequence[Eigenmodes | None],
    frequency: FloatArray,
    whirl: np.ndarray,
    orders: Sequence[float],
) -> tuple[CriticalSpeed, ...]:
    """Where branches meet orders of the rotation: between two speeds, and solved anew there."""
    found = _crossings(speed, modes, frequency, whirl, orders)
    # at zero speed, or where a standstill lies between, there is nothing to solve for
    left = [one for one in found if one.low * one.high >= 0.0 and one.apart_low * one.apart_high]
    for _ in range(REFINED):
        if not left:
            break
        at = np.array([one.at for one in left])
        known = run.frequencies(at, [one.near for one in left], [one.branch for one in left])
        again = []
        for one, place, own in zip(left, at.tolist(), known.tolist(), strict=True):
            apart = own - one.order * abs(place)
            if np.isfinite(apart):
                one.narrow(place, apart)
                if abs(apart) > MET * own:
                    again.append(one)
        left = again
    critical = [
        CriticalSpeed(float(one.order), abs(one.at), one.order * abs(one.at), one.whirl, one.branch)
        for one in found
        if one.at
    ]
    return tuple(sorted(critical, key=lambda one: (one.speed, one.order)))


def _crossings(
    speed: FloatArray,
    modes: Sequence[Eigenmodes | None],
    frequency: FloatArray,
    whirl: np.ndarray,
    orders: Sequence[float],
) -> list[_Crossing]:
    found = []
    for order in orders:
        for branch in range(frequency.shape[1]):
            apart = frequency[:, branch] - order * np.abs(speed)
            for i in np.flatnonzero(apart[:-1] * apart[1:] <= 0.0).tolist():
                near, last = modes[i], i + 2 == len(speed)
                if near is None or (apart[i + 1] == 0.0 and not last):  # the next has it too
                    continue
                ends = (*speed[i : i + 2].tolist(), *apart[i : i + 2].tolist())
                name = str(whirl[i, branch])
                found.append(_Crossing(float(order), branch, near, name, *ends))
    return found


def _bearing_forces(
    structure: Structure, rest: MachineRest, nodes: ComplexArray
) -> tuple[dict[str, ComplexArray], dict[str, FloatArray]]:
    """What the shaft puts on each inner ring besides, (cases, 5), and what its rows carry."""
    added, carried = {}, {}
    for seat, rows in structure.held_rows(rest):
        total = np.zeros((len(nodes), FIVE), np.complex128)
        static = np.zeros(len(nodes))
        for row, own in zip(seat.rows(), rows, strict=True):
            moved = nodes[:, list(row.nodes)].reshape(len(nodes), -1)
            total += (row.tangent(own)[:, :FIVE] @ moved[..., np.newaxis])[..., 0]
            static += np.linalg.norm(row.on_nodes(own.force)[:, :3], axis=1)
        added[seat.bearing.name], carried[seat.bearing.name] = total, static
    return added, carried


def _beyond_linear(
    speed: FloatArray, added: dict[str, ComplexArray], carried: dict[str, FloatArray]
) -> list[Note]:
    """Bearings whose contact is lost and met again in each turn: no small vibration any more."""
    notes = []
    for name, force in added.items():
        size = np.sqrt((np.abs(force[:, 1:3]) ** 2).sum(axis=1))
        beyond = size > carried[name]
        if beyond.any():
            values = {"bearing": name, "speed": float(np.abs(speed[beyond]).min())}
            notes.append(Note("beyond_linear", values))
    return notes
