"""The heat balance of a machine: the temperatures of all its bearings, joined along its shafts.

Each bearing has the five nodes of `rolamento.heat.network`. Those of its shaft are joined with the
ones beside it by what the shaft conducts between them,

    G = 1/∫ dx/(k A),

the housings by what `housing_along` gives. The outer ring of a bearing between two shafts sits on
the outer one, whose nodes take the place of a housing's. All temperatures are linear in the
frictions P of the bearings, so that as many equations are left as there are bearings:

    F(T(P)) = P.

F is the friction of each bearing of the solved machine: temperatures change fits, clearance and
oil, and what shaft and housing grow between the bearings presses those that they hold. From P = 0
the pseudo-transient dP/dτ = F - P is followed with growing steps (Kelley and Keyes (1998)),
so that a machine that starts cold comes to the state to which it would come in time. It is stable
where all eigenvalues of dF/dP have real parts below 1. Past the temperature limit there is none.
"""

from __future__ import annotations

import os
from itertools import pairwise
from math import nan, pi
from typing import Any, Final

import numpy as np

from rolamento.analysis.needs import has_friction, has_oil
from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.heat import Heat
from rolamento.case.machine import Machine, MachineBearing, Section, Shaft, load_machine
from rolamento.case.temperature import Temperature
from rolamento.clearance.chain import PartTemperatures, gathered
from rolamento.clearance.sets import running_rows
from rolamento.errors import InputError
from rolamento.friction import friction
from rolamento.friction.seals import seals_and_bath
from rolamento.friction.summary import default_model, no_coefficient
from rolamento.geometry import clearance_of_angle, ring_geometry
from rolamento.heat.balance import RUNAWAY
from rolamento.heat.network import CONDUCTIVITY, NODES, Network, network_of
from rolamento.heat.warmed import temperature_fields
from rolamento.io.json import dumps, plain
from rolamento.lubrication.films import film, has_film
from rolamento.machines import laid_out, solve_machines
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solved.machine import SolvedMachine
from rolamento.words import Note, said

__all__ = ["MachineHeat", "ShaftLink", "machine_heat"]

_SIZE: Final = len(NODES)
_SHAFT, _HOUSING = NODES.index("shaft"), NODES.index("housing")
_TOLERANCE: Final = 1e-7
"""Share of the greatest friction within which the balance is met."""
_MOST_STEPS: Final = 60
_FIRST: Final = 1.0
"""τ of the first step."""
_LEAST: Final = 1e-3
"""τ below which a step that passes the limit is believed."""
_NUDGE: Final = 1e-3
"""Share of the greatest friction by which each is changed for the slopes."""
_CUTS: Final = 32
"""Pieces of a section for the integral along a cone."""


@frozen
class ShaftLink:
    """What a shaft or a housing conducts between two bearings, W/K.

    part: "shaft" or "housing", first, second: names of the bearings; nodes: which of their nodes.
    """

    part: str
    first: str
    second: str
    conductance: float
    nodes: tuple[str, str]


@frozen(eq=False)
class MachineHeat:
    """Temperatures of the bearings of a machine, and what becomes of their loads.

    Attributes
    ----------
    machine
        as it is given
    status
        "converged"; "thermal_runaway" where no state lies below the temperature limits;
        "no_equilibrium" where the machine has none on the way; "not_converged"
    bearings
        names, in order
    networks
        of conductances, one a bearing
    links
        between bearings
    power
        friction of each, NaN without a state, (bearings,), W
    temperatures
        of their nodes, NaN without a state, (bearings, 5), K
    cold, warm
        the machine at ambient temperature, and at these; None without a state
    growth
        the greatest real part of the eigenvalues of dF/dP: stable below 1
    notes
        what to know
    """

    machine: Machine
    status: str
    bearings: tuple[str, ...]
    networks: tuple[Network, ...]
    links: tuple[ShaftLink, ...]
    power: FloatArray
    temperatures: FloatArray
    cold: SolvedMachine
    warm: SolvedMachine | None
    growth: float
    notes: tuple[Note, ...]

    @property
    def converged(self) -> bool:
        """Whether there is a state."""
        return self.status == "converged"

    def link_flows(self) -> tuple[float, ...]:
        """Return what flows through each link from its first to its second bearing, W."""
        places = {name: index for index, name in enumerate(self.bearings)}
        at = self.temperatures
        return tuple(
            one.conductance
            * float(
                at[places[one.first], NODES.index(one.nodes[0])]
                - at[places[one.second], NODES.index(one.nodes[1])]
            )
            for one in self.links
        )

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists, SI."""
        return {
            "title": self.machine.title,
            "status": self.status,
            "growth": plain(self.growth),
            "bearings": [
                {
                    "name": name,
                    "power": plain(self.power[index]),
                    "temperatures": plain(dict(zip(NODES, self.temperatures[index], strict=True))),
                    "conductances": {
                        key: {"value": plain(value), "estimated": key in net.estimated}
                        for key, value in net.conductances.items()
                    },
                }
                for index, (name, net) in enumerate(zip(self.bearings, self.networks, strict=True))
            ],
            "links": [
                {
                    "part": one.part,
                    "bearings": [one.first, one.second],
                    "conductance": one.conductance,
                }
                for one in self.links
            ],
            "cold": self.cold.to_mapping(),
            "warm": None if self.warm is None else self.warm.to_mapping(),
            "notes": [note.to_mapping() for note in self.notes],
        }

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give it as one JSON object, in SI units."""
        return dumps(self.to_mapping(), indent)


def machine_heat(machine: Machine | str | os.PathLike[str]) -> MachineHeat:
    """Find the temperatures of all bearings of a machine, and what becomes of their loads.

    Parameters
    ----------
    machine
        A `Machine`, or its file. Its [heat], and that of each bearing, says where the heat goes;
        without [mounting] of its bearings only their oil gets warm. Under a spectrum the friction
        is the mean over time.

    Returns
    -------
    MachineHeat
        Never raises for a machine without a state: the status says so.

    Raises
    ------
    InputError
        If a size that an estimate needs is missing, heat has no way out, or the friction of a
        bearing is not known.
    FileError
        If the file cannot be read.

    Harris (1991), chapter 15 (networks); Kelley and Keyes, SIAM J. Numer. Anal. 35 (1998), 508.

    >>> from rolamento.case.machine import machine_of_tables
    >>> machine = machine_of_tables({
    ...     "lubricant": "ISO VG 68",
    ...     "shafts": [{"name": "shaft", "speed": "1500 rpm",
    ...                 "sections": [{"length": "300 mm", "diameter": "40 mm"}]}],
    ...     "bearings": [{"name": "A", "shaft": "shaft", "position": "20 mm",
    ...                   "designation": "6208"},
    ...                  {"name": "B", "shaft": "shaft", "position": "280 mm",
    ...                   "designation": "6208", "located": "floating"}],
    ...     "loads": [{"shaft": "shaft", "position": "150 mm", "fz": "5 kN"}],
    ... })
    >>> found = machine_heat(machine)
    >>> print(found.status, [f"{one:.0f} W" for one in found.power])
    converged ['18 W', '18 W']
    """
    return _Balance(machine if isinstance(machine, Machine) else load_machine(machine)).found()


def section_resistance(section: Section) -> float:
    """Return ∫ dx/A of a section of a shaft, 1/m.

    Parameters
    ----------
    section
        A cylinder, or a cone.
    """
    part = (np.arange(_CUTS) + 0.5) / _CUTS
    outside = section.diameter + part * (section.right_diameter - section.diameter)
    inside = section.bore + part * (section.right_bore - section.bore)
    area = 0.25 * pi * (outside**2 - inside**2)
    return float(section.length * np.mean(1.0 / area))


def shaft_conductance(shaft: Shaft, first: float, second: float) -> float:
    """Return what a steel shaft conducts between two places, k/∫ dx/A; W/K.

    Parameters
    ----------
    shaft
        Its sections count; k is 46 W/(m K).
    first, second
        From its left end, m.

    >>> shaft = Shaft(name="s", sections=[{"length": "1 m", "diameter": "40 mm"}])
    >>> print(f"{shaft_conductance(shaft, 0.1, 0.5):.4f} W/K")  # 46 π/4 0.04²/0.4
    0.1445 W/K
    """
    left, right = min(first, second), max(first, second)
    whole = 0.0
    for section, begin in zip(shaft.sections, shaft.edges, strict=False):
        within = min(right, begin + section.length) - max(left, begin)
        if within > 0.0:
            whole += section_resistance(section) * within / section.length
    return CONDUCTIVITY / whole if whole > 0.0 else 1e9


def _by_clearance(case: Case) -> Case:
    """A case whose mounted row of balls is given by its clearance, which a fit may close.

    A free contact angle ends where the clearance does. So given, x counts from the middle.
    """
    bearing = case.bearing
    angle = bearing.contact_angle
    single = case.mounting is not None and not bearing.is_set and bearing.kind is None
    if not single or bearing.bearing_type.has_rollers or not angle:
        return case
    assert isinstance(bearing, Bearing)
    clearance = clearance_of_angle(angle, ring_geometry(bearing).groove_centre_distance)
    return case.with_({"bearing.diametral_clearance": float(clearance)})


class _Balance:
    """A balance in the making."""

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.heats = [bearing.case.heat or Heat() for bearing in machine.bearings]
        self.names = tuple(bearing.name for bearing in machine.bearings)
        if not self.names:
            raise InputError(said("is missing"), field="bearings", example="[[bearings]]")
        self.count = len(self.names)
        self.bases = [_by_clearance(bearing.case) for bearing in machine.bearings]
        self.ambient = np.array([np.full(_SIZE, heat.ambient) for heat in self.heats])
        self.cold_offsets = self._axial(self.ambient)
        self.cold = self.solved(self.ambient)
        self.networks = self._networks()
        self.links = tuple(self._links())
        self.still, self.slopes = self._linear()
        self.limits = np.array([heat.limit for heat in self.heats])

    # --- the network ------------------------------------------------------------------------------

    def _networks(self) -> tuple[Network, ...]:
        found = []
        for index, (name, bearing) in enumerate(
            zip(self.names, self.machine.bearings, strict=True)
        ):
            try:
                found.append(network_of(bearing.case, self.cold.bearings[name].solved))
            except InputError as error:
                raise error.with_details(field=f"bearings.{index}.{error.field}") from None
        return tuple(found)

    def _links(self) -> list[ShaftLink]:
        found = []
        for shaft in self.machine.shafts:
            on = [
                (bearing.position, bearing.name, "shaft")
                for bearing in self.machine.bearings
                if bearing.shaft == shaft.name
            ]
            on += [
                (self.machine.outer_position(bearing.name), bearing.name, "housing")
                for bearing in self.machine.bearings
                if bearing.outer_shaft == shaft.name
            ]
            for (x, first, part), (end, second, other) in pairwise(sorted(on)):
                g = shaft_conductance(shaft, x, end)
                found.append(ShaftLink("shaft", first, second, g, (part, other)))
        fixed = sorted(
            (self._place(bearing), bearing.name, heat.housing_along)
            for bearing, heat in zip(self.machine.bearings, self.heats, strict=True)
            if bearing.outer_shaft is None
        )
        for (_, first, along), (_, second, _) in pairwise(fixed):
            if along:
                nodes = ("housing", "housing")
                found.append(ShaftLink("housing", first, second, along, nodes))
        return found

    def _place(self, bearing: MachineBearing) -> float:
        return bearing.position + self.machine.shaft(bearing.shaft).position

    def _linear(self) -> tuple[FloatArray, FloatArray]:
        """T at P = 0, (bearings, 5), K, and dT/dP, (bearings, 5, bearings), K/W."""
        size = self.count * _SIZE
        matrix, source = np.zeros((size, size)), np.zeros(size)
        shares = np.zeros((size, self.count))
        for index, net in enumerate(self.networks):
            own = slice(index * _SIZE, (index + 1) * _SIZE)
            among, heat, share = net.equations()
            among = np.nan_to_num(among)  # contacts of a bearing without an equilibrium
            matrix[own, own] += among
            source[own] += heat + among.sum(axis=1) * net.ambient
            shares[own, index] = share
        for link in self.links:
            one, two = (
                self.names.index(name) * _SIZE + NODES.index(node)
                for name, node in zip((link.first, link.second), link.nodes, strict=True)
            )
            for a, b in ((one, two), (two, one)):
                matrix[a, a] += link.conductance
                matrix[a, b] -= link.conductance
        try:
            found = np.linalg.solve(matrix, np.hstack([source[:, np.newaxis], shares]))
        except np.linalg.LinAlgError:
            found = np.full((size, 1 + self.count), np.inf)
        if not np.isfinite(found).all() or np.abs(found[:, 1:]).max() > 1e9:
            raise InputError(said("leaves no way for the heat to go"), field="heat",
                             example='housing_ambient = "5 W/K"')  # fmt: skip
        shape = (self.count, _SIZE)
        whole = np.asarray(found, np.float64)
        return whole[:, 0].reshape(shape), whole[:, 1:].reshape(*shape, self.count)

    def at(self, power: FloatArray) -> FloatArray:
        """Temperatures at frictions (bearings,); (bearings, 5), K."""
        return np.asarray(self.still + self.slopes @ power)

    # --- the machine at temperatures --------------------------------------------------------------

    def case_at(self, index: int, temperatures: FloatArray) -> Case:
        """The case of a bearing at the temperatures of its nodes (5,)."""
        case = self.bases[index]
        fields = temperature_fields(case, temperatures)
        own = {name.partition(".")[2]: float(value) for name, value in fields.items()}
        given = case.lubricant_temperature
        if given is not None:
            own["lubricant"] = given
        return case.replace(temperature=Temperature(**own))

    def cases_at(self, temperatures: FloatArray) -> dict[str, Case]:
        """The cases of all bearings at the temperatures of their nodes (bearings, 5)."""
        return {name: self.case_at(i, temperatures[i]) for i, name in enumerate(self.names)}

    def _axial(self, temperatures: FloatArray) -> dict[str, tuple[float, float]]:
        """Axial distance of the groove centres of single rows, as the machine sets them, m.

        And what it is of that at assembly, by what the grooves have grown.
        """
        cases = self.cases_at(temperatures)
        structure = laid_out(self.machine, cases=cases)
        found: dict[str, tuple[float, float]] = {}
        for seat in structure.seats:
            case = cases[seat.bearing.name]
            if case.mounting is None or case.bearing.is_set:
                continue
            limit = case.mounting.limit
            row = running_rows(case, {}, "running", limit)[0]
            own = case.bearing.places[0].bearing
            angular = own.bearing_type.conical or bool(own.contact_angle)
            touch = float(np.ravel(row.touch)[0]) if angular else 0.0
            stretch = float(np.ravel(row.stretch)[0])
            found[seat.bearing.name] = touch + float(seat.offset[0]), stretch
        return found

    def shifts_at(self, temperatures: FloatArray) -> dict[str, float]:
        """How far warm parts move inner rings along their own x, by bearing, m.

        What is pressed in stays where the cold machine has put it, and follows shaft and housing,
        which grow between the bearings.
        """
        warm = self._axial(temperatures)
        shifts = {}
        for name, (axial, stretch) in warm.items():
            cold, before = self.cold_offsets[name]
            shifts[name] = cold * stretch / before - axial
        for shaft in self.machine.shafts:
            on = sorted(
                (bearing.position, index)
                for index, bearing in enumerate(self.machine.bearings)
                if bearing.shaft == shaft.name and bearing.outer_shaft is None
            )
            mounted = all(self.machine.bearings[i].case.mounting is not None for _, i in on)
            if len(on) < 2 or not mounted:
                continue
            grown = 0.0
            strains = [self._strain(index, temperatures[index]) for _, index in on]
            for place, ((x, _), (end, index)) in enumerate(pairwise(on)):
                grown += (end - x) * 0.5 * (strains[place] + strains[place + 1])
                bearing = self.machine.bearings[index]
                shifts[bearing.name] = shifts.get(bearing.name, 0.0) + bearing.side * grown
        return shifts

    def _strain(self, index: int, temperatures: FloatArray) -> float:
        """Strain of the shaft at a bearing over that of the housing, beyond the cold ones."""
        case = self.machine.bearings[index].case
        found = []
        for at in (temperatures, self.ambient[index]):
            inner, balls, outer, shaft, housing = at.tolist()
            parts = PartTemperatures(
                inner_ring=inner, outer_ring=outer, balls=balls, shaft=shaft, housing=housing
            )
            row = case.bearing.places[0].bearing
            strains = gathered(row, case.mounting, parts, 0.0, 0.0).strains
            found.append(float(strains.shaft) - float(strains.housing))
        return found[0] - found[1]

    def solved(self, temperatures: FloatArray) -> SolvedMachine:
        """The machine at temperatures (bearings, 5)."""
        cases, shifts = self.cases_at(temperatures), self.shifts_at(temperatures)
        return solve_machines((self.machine,), cases=cases, shifts=shifts)

    def friction_of(self, solved: SolvedMachine) -> FloatArray:
        """Mean friction of each bearing over the spectrum, (bearings,), W."""
        share = self.machine.step_shares
        found = []
        for index, name in enumerate(self.names):
            own = solved.bearings[name].solved
            if not has_friction(own):
                error = no_coefficient(own.case)
                raise error.with_details(field=f"bearings.{index}.{error.field}")
            if not own.converged.all():
                found.append(nan)
                continue
            oil = film(own) if has_film(own) else None
            lost = friction(
                own,
                model=default_model(own, quick=True),
                film_parameter=np.nan if oil is None else oil.minimum_film_parameter,
                compare=False,
                machine=(),
            )
            beside = seals_and_bath(own, oil)
            of_seals = 0.0 if beside is None else beside.power
            found.append(float(share @ (np.abs(lost.power) + of_seals)))
        return np.array(found)

    def friction_at(self, power: FloatArray) -> FloatArray:
        """Friction at the temperatures that frictions make, (bearings,), W."""
        at = self.at(power)
        if not np.isfinite(at).all() or at.max() > 600.0:
            return np.full(self.count, nan)
        return self.friction_of(self.solved(at))

    # --- the balance ------------------------------------------------------------------------------

    def found(self) -> MachineHeat:
        """The state to which the cold machine comes."""
        nothing = np.zeros(self.count)
        status, power, growth = "not_converged", nothing, nan
        if not self.cold.status.converged.all():
            status = "no_equilibrium"
        elif (self.still.max(axis=1) > self.limits).any():
            status = RUNAWAY
        else:
            status, power = self._followed(nothing)
        warm = None
        if status == "converged":
            jacobian = self._jacobian(power, self.friction_at(power))
            growth = float(np.linalg.eigvals(jacobian).real.max())
            if growth < 1.0:
                warm = self.solved(self.at(power))
            else:
                status = RUNAWAY
        lost = np.full(self.count, nan)
        return MachineHeat(
            self.machine, status, self.names, self.networks, self.links,
            power if warm is not None else lost,
            self.at(power) if warm is not None else np.full((self.count, _SIZE), nan),
            self.cold, warm, growth, tuple(self._notes(status, power)),
        )  # fmt: skip

    def _jacobian(self, power: FloatArray, own: FloatArray) -> FloatArray:
        step = _NUDGE * max(float(own.max()), 1e-6)
        beside = [self.friction_at(power + step * one) for one in np.eye(self.count)]
        return np.array([(one - own) / step for one in beside]).T

    def _followed(self, start: FloatArray) -> tuple[str, FloatArray]:
        """Follow dP/dτ = F - P from a start to where it ends: its status, and P."""
        power, own = start, self.friction_at(start)
        if not np.isfinite(own).all():
            return "no_equilibrium", power
        scale = max(float(own.max()), 1e-9)
        slopes = self._jacobian(power, own)
        tau, one = _FIRST, np.eye(self.count)
        for _ in range(_MOST_STEPS):
            off = own - power
            size = float(np.abs(off).max())
            if size <= _TOLERANCE * scale:
                return "converged", power
            step = np.linalg.solve((1.0 / tau + 1.0) * one - slopes, off)
            there = np.maximum(power + step, 0.0)
            hot = bool((self.at(there).max(axis=1) > self.limits).any())
            found = self.friction_at(there)
            if hot or not np.isfinite(found).all():
                if tau < _LEAST:
                    return RUNAWAY if hot else "no_equilibrium", power
                tau *= 0.25
                continue
            moved = there - power
            bend = found - own - slopes @ moved
            slopes = slopes + np.outer(bend, moved) / max(float(moved @ moved), 1e-300)  # Broyden
            before = size
            power, own = there, found
            scale = max(scale, float(own.max()))
            after = float(np.abs(own - power).max())
            tau = min(1e6, tau * max(0.5, min(10.0, 2.0 * before / max(after, 1e-300))))
        return "not_converged", power

    def _notes(self, status: str, power: FloatArray) -> list[Note]:
        notes = []
        if status == RUNAWAY:
            at = self.at(power)
            hottest = int(at.max(axis=1).argmax())
            notes.append(
                Note(
                    "machine_runaway",
                    {"bearing": self.names[hottest], "limit": float(self.limits[hottest])},
                )
            )
        names = {name for net in self.networks for name in net.estimated}
        ordered = [name for name in self.networks[0].conductances if name in names]
        if ordered:
            notes.append(Note("conductances_estimated", {"names": ordered}))
        if any(bearing.case.mounting is None for bearing in self.machine.bearings):
            bare = [one.name for one in self.machine.bearings if one.case.mounting is None]
            notes.append(Note("machine_heat_without_mounting", {"names": bare}))
        if any(
            bearing.case.lubricant_temperature is not None and has_oil(bearing.case)
            for bearing in self.machine.bearings
        ):
            notes.append(Note("machine_lubricant_keeps_temperature"))
        return notes
