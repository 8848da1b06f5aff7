"""Shafts in their bearings: from a machine to a network, and from its rest to what each part bears.

Shafts are beams; their nodes stand wherever something is fixed or changes. What is linear (beams,
springs, housings) is condensed to the nodes at which rows of rolling elements stand, exactly: there
the network is solved, many cases at once, and the rest follows. An outer ring is held, or a node of
its own: on a housing that yields, free to slide in its seat, or on another shaft.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice, pairwise
from typing import Final

import numpy as np

from rolamento.case.machine import Machine, MachineBearing, Shaft, Spring, Step
from rolamento.numerics import BoolArray, FloatArray, IntArray
from rolamento.records import frozen
from rolamento.rows.row import Guided, Indices, Response
from rolamento.solved import Index
from rolamento.status import CONVERGED, NO_EQUILIBRIUM, NOT_CONVERGED
from rolamento.system.beam import Chain, Elements
from rolamento.system.cases import Cases
from rolamento.system.network import (
    FIVE,
    PRECISION,
    ROUNDING,
    Asked,
    Linear,
    Reaction,
    Rest,
    RowBetween,
    solve,
    unknowns_of,
)
from rolamento.system.ring import pressed_in

FINENESS: Final = 40
"""Elements of a shaft at least; statics are exact for any, pictures and modes are not."""
SHOULDER: Final = 1e10
"""Stiffness of a shoulder that an outer ring leans on one way; N/m."""
LONGEST: Final = 0.3
"""Longest step of a node at a time, over the distance between centres of curvature."""
FARTHEST: Final = 0.2
"""How far a node may go before it counts as running away, over the largest element's diameter, and
besides what springs and housings yield under all loads at once."""
STEPS: Final = (0.2, 0.4, 0.6, 0.8, 1.0)
"""Parts of the load by which a machine is loaded where the whole at once leads nowhere."""


@frozen(eq=False)
class Beam:
    """A shaft as elements between nodes.

    first: its first node among those of the machine. place: of its nodes along the machine's x;
    (nodes,), m.
    """

    shaft: Shaft
    first: int
    place: FloatArray
    elements: Elements

    @classmethod
    def of(cls, shaft: Shaft, first: int, stops: Sequence[float]) -> Beam:
        """Divide a shaft at its sections and at the places where something stands."""
        ends = np.concatenate([[0.0], np.cumsum([one.length for one in shaft.sections])])
        whole = ends[-1]
        along = np.unique(np.concatenate([ends, np.clip(stops, 0.0, whole)]))
        along = along[np.concatenate([[True], np.diff(along) > 1e-9 * whole])]
        along[-1] = whole
        pieces = [
            np.linspace(a, z, 1 + max(1, round(FINENESS * (z - a) / whole)))[:-1]
            for a, z in pairwise(along)
        ]
        place = np.append(np.concatenate(pieces), whole)
        left, right = place[:-1], place[1:]
        which = np.clip(np.searchsorted(ends, 0.5 * (left + right)) - 1, 0, len(shaft.sections) - 1)

        def at(begin: Sequence[float], end: Sequence[float]) -> tuple[FloatArray, FloatArray]:
            a, z = np.array(begin)[which], np.array(end)[which]
            part = [(s - ends[which]) / np.diff(ends)[which] for s in (left, right)]
            return a + (z - a) * part[0], a + (z - a) * part[1]

        sections, n = shaft.sections, len(left)
        outside = at(
            [s.diameter for s in sections],
            [s.diameter if s.end_diameter is None else s.end_diameter for s in sections],
        )
        inside = at(
            [s.bore for s in sections],
            [s.bore if s.end_bore is None else s.end_bore for s in sections],
        )
        material = shaft.material
        elements = Elements(
            right - left, *outside, *inside,
            np.full(n, material.youngs_modulus), np.full(n, material.poisson_ratio),
            np.full(n, material.density),
        )  # fmt: skip
        return cls(shaft, first, shaft.position + place, elements)

    @property
    def nodes(self) -> IntArray:
        """Its nodes among those of the machine."""
        return self.first + np.arange(len(self.place))

    def node_at(self, position: float) -> int:
        """The node at a position from the shaft's left end."""
        return self.first + int(np.argmin(np.abs(self.place - self.shaft.position - position)))

    def kept(self, nodes: Sequence[int]) -> IntArray:
        """Those of some nodes that are its own; its first one where there is none."""
        own = np.intersect1d(self.nodes, np.array(nodes, np.int64))
        return own if len(own) else self.nodes[:1]

    def chains(self, kept: IntArray) -> list[tuple[Chain, IntArray, FloatArray]]:
        """Its bending in both planes and its stretching, by the kept of its nodes.

        With each the degrees of freedom that it is of, and their signs.
        """
        elements = self.elements
        bent = Chain.of(elements.length, elements.flexibility(), kept)
        along = Chain.along(elements.stretch(), kept)
        return [
            (bent, np.array([1, 4]), np.array([1.0, 1.0])),
            (bent, np.array([2, 3]), np.array([1.0, -1.0])),
            (along, np.array([0]), np.array([1.0])),
        ]

    def unknowns(self) -> IntArray:
        """The degrees of freedom of each element among those of the machine; (elements, 10)."""
        return FIVE * self.nodes[:-1, np.newaxis] + np.arange(2 * FIVE)


@frozen(eq=False)
class Seat:
    """How a bearing stands in the machine.

    way: +1, or -1 of a bearing that faces the machine's -x. inner, outer: its rings' nodes; None
    of an outer ring that is held. slide: the node of outer rings that springs push, if any.
    offset: how far the machine presses it in besides; (cases,), m.
    """

    bearing: MachineBearing
    cases: Cases
    press: tuple[FloatArray, ...]
    offset: FloatArray
    way: float
    inner: int
    outer: int | None
    slide: int | None

    @property
    def element_count(self) -> int:
        """Rolling elements of all its rows."""
        return sum(placed.row.element_count for placed in self.cases.rows)

    def rows(self) -> list[RowBetween]:
        """Its rows between its rings."""
        return [
            RowBetween(
                row=placed.row,
                inner=self.inner,
                outer=self.outer,
                way=self.way * placed.sign,
                lever=self.way * placed.lever,
                press=press,
                slide=self.slide if placed.sign < 0.0 else None,
            )
            for placed, press in zip(self.cases.rows, self.press, strict=True)
        ]

    def guided(self, control: FloatArray) -> Seat:
        """The same, its elements guided so."""
        return replace(self, cases=self.cases.guided(control))


@frozen(eq=False)
class Shoulder:
    """What holds a node against motion one way along x, and lets it go the other."""

    node: int
    way: float

    @property
    def nodes(self) -> tuple[int, ...]:
        """The outer ring's."""
        return (self.node,)

    def respond(self, place: FloatArray, which: Indices, memory: FloatArray | None) -> Reaction:
        """Push back where it is leant on."""
        against = self.way * place[:, 0] > 0.0
        force, stiffness = np.zeros_like(place), np.zeros((len(place), FIVE, FIVE))
        force[:, 0] = np.where(against, SHOULDER * place[:, 0], 0.0)
        stiffness[:, 0, 0] = np.where(against, SHOULDER, 0.0)
        return Reaction(force, stiffness, np.abs(force[:, 0]) * (ROUNDING / PRECISION))

    def moved(self, places: Mapping[int, int]) -> Shoulder:
        """The same among other nodes."""
        return replace(self, node=places[self.node])

    def no_response(self, cases: int) -> Response | None:
        """There is nothing to keep."""
        return None


@frozen(eq=False, slots=False)
class Structure:
    """A machine as a network, as `guidance` asks for a system.

    Attributes
    ----------
    beams, seats
        its shafts and its bearings
    springs
        and housings: constant stiffness between nodes
    held
        degrees of freedom that stay where they are; (unknowns,)
    shoulders
        of outer rings that are held one way
    load
        on the nodes; (cases, unknowns), N and N·m
    """

    beams: tuple[Beam, ...]
    seats: tuple[Seat, ...]
    springs: tuple[Linear, ...]
    held: BoolArray
    shoulders: tuple[Shoulder, ...]
    load: FloatArray

    def __len__(self) -> int:
        """Count the cases."""
        return len(self.load)

    @property
    def shape(self) -> tuple[int, int]:
        """Cases and rolling elements of all bearings."""
        return len(self), sum(seat.element_count for seat in self.seats)

    def components(self) -> list[RowBetween | Linear | Shoulder]:
        """The rows of all bearings, in order, then springs, housings and shoulders."""
        rows = (row for seat in self.seats for row in seat.rows())
        return [*rows, *self.springs, *self.shoulders]

    def held_rows(self, rest: MachineRest) -> Iterator[tuple[Seat, tuple[Response, ...]]]:
        """Each bearing, and its rows where they came to rest."""
        rows = iter(rest.rest.rows)
        for seat in self.seats:
            yield seat, tuple(islice(rows, len(seat.cases.rows)))

    def guided(self, control: FloatArray) -> Structure:
        """The same machine, its elements guided so; (cases or 1, elements)."""
        parts = zip(self.seats, self.split(control), strict=True)
        return replace(self, seats=tuple(seat.guided(own) for seat, own in parts))

    def split(self, control: FloatArray) -> list[FloatArray]:
        """The columns of an array over all elements, bearing by bearing."""
        ends = np.cumsum([seat.element_count for seat in self.seats])[:-1]
        return list(np.split(control, ends, axis=1))

    def verdict(self, rest: MachineRest, which: Index = slice(None)) -> IntArray:
        """What guides every element of all cases, or some; (cases, elements)."""
        chosen = np.arange(len(self))[which]
        parts = []
        for seat, rows in self.held_rows(rest):
            mode = seat.cases.case.model.raceway_control
            for placed, held in zip(seat.cases.rows, rows, strict=True):
                row = placed.row
                if mode == "jones" and isinstance(row, Guided):
                    parts.append(row.verdict(held, chosen))
                else:
                    own = -1 if mode == "inner" else 1
                    parts.append(np.full((len(chosen), row.element_count), own))
        return np.concatenate(parts, axis=1)

    # --- solving --------------------------------------------------------------------------------

    def solve(self, which: Index = slice(None)) -> MachineRest:
        """Find where all nodes come to rest in all cases, or some."""
        chosen = np.arange(len(self))[which]
        if (loose := self.loose_shaft()) is not None:
            return self._running_off(loose, len(chosen))
        condensed = self._condensed
        rest = condensed.solve(self, chosen, np.zeros((len(chosen), condensed.kept.size)), 1.0)
        left = np.flatnonzero(np.isin(rest.number, (NOT_CONVERGED, NO_EQUILIBRIUM)))
        if len(left):  # loaded little by little, each time from where the part before has led
            start = np.zeros((len(left), condensed.kept.size))
            for part in STEPS:
                again = condensed.solve(self, chosen[left], start, part)
                settled = (again.number == CONVERGED)[:, np.newaxis]
                start = np.where(settled, again.place, start)
            rest.put(left, again)
        known = rest.unsupported >= 0
        rest.unsupported[known] = condensed.kept[rest.unsupported[known]]
        return MachineRest(rest, condensed.whole(self.load[chosen], rest.place))

    def _running_off(self, beam: Beam, cases: int) -> MachineRest:
        """What nothing holds along x has no place, whatever its load."""
        rest = Rest.nowhere(cases, self._condensed.kept.size, self.components())
        rest.number[:], rest.unsupported[:] = NO_EQUILIBRIUM, FIVE * beam.first
        return MachineRest(rest, np.full((cases, len(self.held) // FIVE, FIVE), np.nan))

    @cached_property
    def _condensed(self) -> _Condensed:
        return _Condensed.of(self)

    def loose_shaft(self) -> Beam | None:
        """A shaft that nothing holds along x, whatever its load."""
        nodes = len(self.held) // FIVE
        group = np.arange(nodes + 1)  # the last is the ground
        pairs = [(int(node), beam.first) for beam in self.beams for node in beam.nodes]
        pairs += [(int(node), nodes) for node in np.flatnonzero(self.held[::FIVE])]
        pairs += [(shoulder.node, nodes) for shoulder in self.shoulders]
        for spring in self.springs:
            k = spring.matrix[0, ::FIVE, ::FIVE]
            for place, node in enumerate(spring.nodes):
                pairs += [(node, spring.nodes[other]) for other in np.flatnonzero(k[place])]
                # what is left of a row of stiffness is to the ground
                if abs(k[place].sum()) > 1e-9 * np.abs(k[place]).sum():
                    pairs.append((node, nodes))
        for seat in self.seats:
            for row in seat.rows():
                if not row.row.floats:
                    pairs.append((row.inner, nodes if row.outer is None else row.outer))
        for one, other in pairs:
            group[group == group[one]] = group[other]
        loose = (beam for beam in self.beams if group[beam.first] != group[nodes])
        return next(loose, None)

    def yields(self, chosen: Indices) -> FloatArray:
        """How far the softest spring or housing would yield under all loads at once; (n,), m."""
        rates = [
            rate
            for spring in self.springs
            for rate in np.diagonal(spring.matrix[0]).reshape(-1, FIVE)[:, :3].ravel()
            if rate > 0.0
        ]
        if not rates:
            return np.zeros(len(chosen))
        forces = self.load[chosen].reshape(len(chosen), -1, FIVE)[..., :3]
        return np.asarray(np.abs(forces).sum(axis=(1, 2)) / min(rates))

    def tangent(self, rest: MachineRest) -> FloatArray:
        """The stiffness of everything where it came to rest; (cases, unknowns, unknowns)."""
        unknowns = len(self.held)
        k = np.zeros((len(self), unknowns, unknowns))
        for beam in self.beams:
            for at, own in zip(beam.unknowns(), beam.elements.stiffness(), strict=True):
                k[:, at[:, np.newaxis], at] += own
        parts = [
            (row.nodes, row.tangent(held))
            for seat, rows in self.held_rows(rest)
            for row, held in zip(seat.rows(), rows, strict=True)
        ]
        parts += [(spring.nodes, spring.matrix) for spring in self.springs]
        for shoulder in self.shoulders:
            place = rest.place[:, shoulder.node]
            own = shoulder.respond(place, np.arange(len(self)), None).stiffness
            parts.append((shoulder.nodes, own))
        for nodes, own in parts:
            at = unknowns_of(nodes)
            k[:, at[:, np.newaxis], at] += own
        return k

    def carried(self, rest: MachineRest) -> FloatArray:
        """What acts on each node from outside the beams: loads, rows and springs.

        (cases, nodes, 5).
        """
        out = self.load.reshape(len(self), -1, FIVE).copy()
        for seat, rows in self.held_rows(rest):
            for row, held in zip(seat.rows(), rows, strict=True):
                force = row.on_nodes(held.force)
                out[:, row.inner] -= force
                if row.outer is not None:
                    out[:, row.outer] += force
        for spring in self.springs:
            at = list(spring.nodes)
            place = rest.place[:, at].reshape(len(self), -1)
            out[:, at] -= (place @ spring.matrix[0]).reshape(len(self), -1, FIVE)
        return out


@frozen(eq=False)
class _Condensed:
    """The beams seen from the nodes at which something else stands.

    Attributes
    ----------
    nodes
        those nodes
    kept
        their degrees of freedom among those of the machine
    beams
        the beams' stiffness between the kept
    follow
        how all degrees of freedom follow the kept; its transpose puts loads on the kept
    by_load
        how all yield to loads of their own, the kept held
    scale
        1 of a shift, an arm of a tilt; (kept,)
    """

    nodes: tuple[int, ...]
    kept: IntArray
    beams: Linear
    follow: FloatArray
    by_load: FloatArray
    scale: FloatArray

    @classmethod
    def of(cls, structure: Structure) -> _Condensed:
        """Condense, exactly."""
        parts = [node for part in structure.components() for node in part.nodes]
        touched = {*parts, *(n for beam in structure.beams for n in beam.kept(parts))}
        nodes = sorted(touched)
        where = {node: place for place, node in enumerate(nodes)}
        unknowns, size = len(structure.held), FIVE * len(nodes)
        stiffness, follow = np.zeros((size, size)), np.zeros((unknowns, size))
        by_load = np.zeros((unknowns, unknowns))
        kept = unknowns_of(tuple(nodes))
        follow[kept, np.arange(size)] = 1.0
        for beam in structure.beams:
            own = beam.kept(parts)
            places = FIVE * np.array([where[int(node)] for node in own])
            for chain, axes, signs in beam.chains(own - beam.first):
                among = (places[:, np.newaxis] + axes).ravel()
                every = (FIVE * beam.nodes[:, np.newaxis] + axes).ravel()
                a, z = np.tile(signs, len(own)), np.tile(signs, len(beam.nodes))
                stiffness[among[:, np.newaxis], among] += a[:, np.newaxis] * chain.stiffness * a
                follow[every[:, np.newaxis], among] = z[:, np.newaxis] * chain.follow * a
                by_load[every[:, np.newaxis], every] = z[:, np.newaxis] * chain.by_load * z
        rows = [placed.row for seat in structure.seats for placed in seat.cases.rows]
        arms = np.concatenate([np.ravel(row.sizes.arm) for row in rows])
        known = arms[np.isfinite(arms)]  # a case that is not valid has none, and leaves the others
        arm = known.mean() if len(known) else 1.0
        scale = np.tile([1.0, 1.0, 1.0, arm, arm], len(nodes))
        linear = Linear(tuple(range(len(nodes))), stiffness[np.newaxis])
        return cls(tuple(nodes), kept, linear, follow, by_load, scale)

    def solve(self, structure: Structure, chosen: Indices, start: FloatArray, part: float) -> Rest:
        """Balance the kept nodes under a part of the load; start (cases, kept), SI."""
        where = {node: place for place, node in enumerate(self.nodes)}
        components = [self.beams, *(part.moved(where) for part in structure.components())]
        load = part * structure.load[chosen]
        rows = [placed.row for seat in structure.seats for placed in seat.cases.rows]
        sizes = [row.sizes for row in rows]
        free = ~structure.held[self.kept]
        arms = np.broadcast_to(self.scale, (len(chosen), self.kept.size))
        sound = np.all([row.valid[chosen] for row in rows], axis=0)
        sound &= np.isfinite(load).all(axis=1)
        sound &= np.all([np.isfinite(e[chosen]) for s in structure.seats for e in s.press], axis=0)
        return solve(
            components,
            Asked(
                chosen=chosen,
                arms=arms,
                free=np.broadcast_to(free, arms.shape),
                target=np.where(free, load @ self.follow, 0.0) / arms,
                start=start * arms,
                sound=sound,
                longest=LONGEST * np.min([size.reach[chosen] for size in sizes], axis=0),
                limit=structure.yields(chosen)
                + FARTHEST * np.max([size.diameter[chosen] for size in sizes], axis=0),
                reference=1.5e-6 * np.max([size.stiffness[chosen] for size in sizes], axis=0),
            ),
        )

    def whole(self, load: FloatArray, place: FloatArray) -> FloatArray:
        """Where all nodes are, by where the kept are; (cases, nodes, 5)."""
        out = place @ self.follow.T + load @ self.by_load.T
        return np.asarray(out.reshape(len(place), -1, FIVE))


@dataclass(slots=True)
class MachineRest:
    """Where a machine came to rest.

    rest: of the nodes at which rows stand; its `unsupported` counts all degrees of freedom of the
    machine. place: of all nodes; (cases, nodes, 5), SI.
    """

    rest: Rest
    place: FloatArray

    @property
    def number(self) -> IntArray:
        """How each case went."""
        return self.rest.number

    @property
    def iterations(self) -> IntArray:
        """Newton steps of each case."""
        return self.rest.iterations

    @property
    def safe_path(self) -> BoolArray:
        """Whether a row's fast path needed help."""
        return self.rest.safe_path

    def put(self, cases: Indices, part: MachineRest) -> None:
        """Copy some of the cases to their places."""
        self.rest.put(cases, part.rest)
        self.place[cases] = part.place


# --- from a machine to its structure --------------------------------------------------------------


def structure_of(
    machines: Sequence[Machine],
    cases: Sequence[Cases],
    shifts: Mapping[str, float] | None = None,
) -> Structure:
    """Lay out machines that differ in forces and speeds alone.

    cases: of each bearing, as many as the spectra of all have steps, one of each without steps.
    shifts: how far warm parts move the inner ring of a bearing along its own x, against its outer
    ring, by name, m.
    """
    machine = machines[0]
    beams = beams_of(machine)
    by_name = {beam.shaft.name: beam for beam in beams}
    layout = _Layout(sum(len(beam.place) for beam in beams))
    seats, shoulders = [], []
    for bearing, own in zip(machine.bearings, cases, strict=True):
        inner = by_name[bearing.shaft].node_at(bearing.position)
        outer = _outer_node(machine, bearing, own, by_name, layout)
        way = float(bearing.side)
        slide = None
        if own.preload == "spring":
            slide = layout.node(free=(0,))
            layout.push(slide, way * own.preload_value)
        if slides(bearing, own) and bearing.located != "floating" and outer is not None:
            shoulders.append(Shoulder(outer, 1.0 if bearing.located == "+x" else -1.0))
        if bearing.spring_force is not None and outer is not None:
            layout.push(outer, np.full(len(own), -way * bearing.spring_force))
        press, offset = _pressed(bearing, own)
        if shifts is not None and (shift := shifts.get(bearing.name)) is not None:
            press = tuple(e + row.sign * shift for e, row in zip(press, own.rows, strict=True))
            offset = offset + shift
        seats.append(Seat(bearing, own, press, offset, way, inner, outer, slide))
    _put_housings(machine, {seat.bearing.name: seat for seat in seats}, layout)
    springs = [*layout.springs, *(_spring(one, by_name) for one in machine.springs)]
    load = np.stack(
        [
            _load_of(one, by_name, step, FIVE * layout.nodes)
            for one in machines
            for step in one.spectrum or (None,)
        ]
    )
    for node, force in layout.pushed:
        load[:, FIVE * node] += force
    return Structure(
        tuple(beams), tuple(seats), tuple(springs), np.array(layout.held), tuple(shoulders), load
    )


class _Layout:
    """The nodes of a machine: those of its shafts, then outer rings that may move."""

    def __init__(self, of_shafts: int) -> None:
        self.held = [False] * (FIVE * of_shafts)
        self.springs: list[Linear] = []
        self.pushed: list[tuple[int, FloatArray]] = []

    @property
    def nodes(self) -> int:
        """Number of nodes."""
        return len(self.held) // FIVE

    def node(self, free: Sequence[int]) -> int:
        """Add one that may move in some directions."""
        self.held += [axis not in free for axis in range(FIVE)]
        return self.nodes - 1

    def push(self, node: int, force: FloatArray) -> None:
        """Push a node along x; (cases,), N."""
        self.pushed.append((node, force))


def beams_of(machine: Machine, more: Mapping[str, Sequence[float]] | None = None) -> list[Beam]:
    """The shafts, divided wherever something stands on them, and at further places of each."""
    stops: dict[str, list[float]] = {shaft.name: [] for shaft in machine.shafts}
    parts = (machine.loads, machine.gears, machine.belts, machine.masses, machine.springs)
    for part in (*machine.bearings, *(one for kind in parts for one in kind)):
        stops[part.shaft].append(part.position)
    for bearing in machine.bearings:
        if bearing.outer_shaft is not None:
            stops[bearing.outer_shaft].append(machine.outer_position(bearing.name))
    for spring in machine.springs:
        if spring.to_shaft is not None and spring.to_position is not None:
            stops[spring.to_shaft].append(spring.to_position)
    for name, places in (more or {}).items():
        stops[name] += places
    beams: list[Beam] = []
    for shaft in machine.shafts:
        first = 0 if not beams else int(beams[-1].nodes[-1]) + 1
        beams.append(Beam.of(shaft, first, stops[shaft.name]))
    return beams


def _outer_node(
    machine: Machine,
    bearing: MachineBearing,
    cases: Cases,
    beams: Mapping[str, Beam],
    layout: _Layout,
) -> int | None:
    """The node of a bearing's outer ring; None of one that is held."""
    if bearing.outer_shaft is not None:
        return beams[bearing.outer_shaft].node_at(machine.outer_position(bearing.name))
    housing = machine.housing_of(bearing.name)
    if housing is None:
        return layout.node(free=(0,)) if slides(bearing, cases) else None
    return layout.node(free=range(3 if housing.holds_tilt else FIVE))


def slides(bearing: MachineBearing, cases: Cases) -> bool:
    """Whether the outer ring may slide in its seat, and has reason to: its rows hold it along x."""
    holds = not all(placed.row.floats for placed in cases.rows)
    return bearing.located != "both" and holds


def _put_housings(machine: Machine, seats: Mapping[str, Seat], layout: _Layout) -> None:
    """Put the stiffness under outer rings in; one that slides in its seat has none along x."""
    for housing in machine.housings:
        whole = np.asarray(housing.stiffness_matrix, np.float64)
        if housing.bearings:
            groups = [[seats[name] for name in housing.bearings]]
        else:
            groups = [[s] for s in seats.values() if s.bearing.housing == housing.name]
        for group in groups:
            k = whole.copy()
            for place, seat in enumerate(group):
                if slides(seat.bearing, seat.cases):
                    k = _released(k, FIVE * place)
            nodes = tuple(seat.outer for seat in group if seat.outer is not None)
            layout.springs.append(Linear(nodes, k[np.newaxis]))


def _released(matrix: FloatArray, free: int) -> FloatArray:
    """A stiffness with one degree of freedom let go: nothing pushes it."""
    pivot = matrix[free, free]
    left = matrix - (np.outer(matrix[:, free], matrix[free]) / pivot if pivot > 0.0 else 0.0)
    left[free], left[:, free] = 0.0, 0.0
    return left


def _pressed(bearing: MachineBearing, cases: Cases) -> tuple[tuple[FloatArray, ...], FloatArray]:
    """How far each row of a bearing is pressed in, and how much of that is the machine's.

    (cases,) each, m.
    """
    press, row = pressed_in(cases), cases.rows[0].row
    if bearing.preload is not None:
        force = np.full(len(cases), bearing.preload)
        offset = np.where(force > 0.0, row.press_in(force), row.first_contact())
    elif bearing.offset is not None:
        offset = row.first_contact() + bearing.offset
    else:
        return press, np.zeros(len(cases))
    return (press[0] + offset,), offset


def _spring(spring: Spring, beams: Mapping[str, Beam]) -> Linear:
    k = np.asarray(spring.stiffness_matrix, np.float64)
    nodes = [beams[spring.shaft].node_at(spring.position)]
    if spring.to_shaft is not None and spring.to_position is not None:
        nodes.append(beams[spring.to_shaft].node_at(spring.to_position))
        k = np.block([[k, -k], [-k, k]])
    return Linear(tuple(nodes), k[np.newaxis])


def _load_of(
    machine: Machine, beams: Mapping[str, Beam], step: Step | None, unknowns: int
) -> FloatArray:
    """What acts on the nodes in a step; (unknowns,), N and N·m."""
    load = np.zeros(unknowns)
    for force in machine.forces(step):
        at = FIVE * beams[force.shaft].node_at(force.position)
        load[at : at + FIVE] += np.delete(force.force, 3)
    if machine.gravity is not None:
        acceleration = np.array(machine.gravity.vector)
        for beam in beams.values():
            for at, own in zip(beam.unknowns(), beam.elements.body_load(acceleration), strict=True):
                load[at] += own
        for mass in machine.masses:
            at = FIVE * beams[mass.shaft].node_at(mass.position)
            load[at : at + 3] += mass.inertia.mass * acceleration
    return load
