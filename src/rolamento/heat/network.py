"""Temperatures of a bearing, its shaft and its housing as a network of conductances.

Five nodes: inner ring i, elements e, outer ring o, shaft s, housing h. Between them, to ambient and
to the oil flow conductances G (W/K); into shaft and housing heat from outside; into the rings the
friction P with its shares. In the steady state

    A T = b + P s

with A the sum of G at each node less G between nodes, b the heat from outside and what ambient and
oil bring at their own temperatures, s = (ξ, 0, 1 - ξ, 0, 0). So every temperature is linear in P.

What is not given is estimated, within ± 50 % at best:

    shaft, housing to ambient    q_r A_r/50 K, in proportion to d and D      (ISO 15312:2003)
    seats                        5 kW/(m² K) over π d B and π D B            (2 to 10 as pressed)
    rings to elements            Σ a e √(π u b/2) + 2 k √(a b) over the contacts
    oil flow                     30 W/(l/min K) = ρ c of mineral oil times the flow

The third is how two half-spaces that touch for the time 2b/u conduct, with a contact ellipse a, b
and the speed u of its surfaces, e = √(k ρ c); the second part of it is the constriction of two
half-spaces at rest (Carslaw, Jaeger, Conduction of Heat in Solids, 2nd ed. (1959), 2.8 and 8.2).
The oil between them is left out, which may make it several times too large.

What the nodes store, C, is ρ c of steel times their volumes: the rings up to the pitch circle less
or more an element, the elements, the shaft and a housing of 1.5 D over three widths of the bearing.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import nan, pi, sqrt
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.case import Case
from rolamento.case.bearing import Bearing
from rolamento.case.heat import Heat
from rolamento.case.roller_bearing import RollerBearing
from rolamento.errors import InputError
from rolamento.numerics import FloatArray
from rolamento.records import frozen
from rolamento.solved import Solved
from rolamento.speeds import reference_heat_flow
from rolamento.words import said

__all__ = [
    "CAPACITIES",
    "CONDUCTANCES",
    "NODES",
    "OIL_CAPACITY",
    "HeatFlow",
    "Network",
    "capacities_of",
    "network_of",
]

NODES: Final = ("inner_ring", "elements", "outer_ring", "shaft", "housing")
AMBIENT: Final = "ambient"
OIL: Final = "oil"
CONDUCTANCES: Final[Mapping[str, tuple[str, str]]] = {
    "inner_ring_elements": ("inner_ring", "elements"),
    "elements_outer_ring": ("elements", "outer_ring"),
    "inner_ring_shaft": ("inner_ring", "shaft"),
    "outer_ring_housing": ("outer_ring", "housing"),
    "shaft_ambient": ("shaft", AMBIENT),
    "housing_ambient": ("housing", AMBIENT),
}
"""Fields of [heat], and what each lies between."""
CAPACITIES: Final = tuple(f"{node}_capacity" for node in NODES)
"""Fields of [heat]: what the nodes store."""
OIL_CAPACITY: Final = 30.0 * 60e3
"""ρ c of oil, J/(m³ K): 30 W take it through 1 K at 1 l/min."""
SEAT: Final = 5e3
"""W/(m² K) of a press fit; 2000 to 10 000 are usual."""
REFERENCE_RISE: Final = 50.0
"""K of the outer ring above ambient at which ISO 15312 gives the heat flow."""
CONDUCTIVITY, DENSITY, CAPACITY = 46.0, 7800.0, 460.0
"""k, ρ and c of bearing steel: W/(m K), kg/m³, J/(kg K)."""
SEAT_WIDTHS: Final = 3.0
"""Widths of the bearing along which shaft and housing are taken to warm with it."""
HOUSING_WALL: Final = 1.5
"""Outside diameter of a housing over that of the bearing, if nothing is given."""
_EFFUSIVITY: Final = sqrt(CONDUCTIVITY * DENSITY * CAPACITY)


@frozen
class HeatFlow:
    """Heat that flows from one place to another, W; negative where it flows the other way.

    Attributes
    ----------
    start, end
        nodes, "ambient", "oil", "friction" or "outside"
    power
        W
    """

    start: str
    end: str
    power: float


@frozen
class Network:
    """Conductances between the nodes, and the heat that does not depend on the friction.

    Attributes
    ----------
    conductances
        by the fields of [heat], W/K
    oil
        conductance of the oil flow at the elements, W/K
    ambient, oil_inlet
        temperatures, K
    outside
        heat into shaft and housing from outside, W
    inner_share
        ξ of the friction
    estimated
        fields whose conductance is an estimate
    """

    conductances: Mapping[str, float]
    oil: float
    ambient: float
    oil_inlet: float
    outside: tuple[float, float]
    inner_share: float
    estimated: tuple[str, ...] = ()

    def temperatures(self, power: ArrayLike) -> FloatArray:
        """Steady temperatures of the nodes at a friction; (5, …), K.

        Raises
        ------
        InputError
            If the heat of a node can go nowhere.
        """
        still, slope = self._line()
        return np.multiply.outer(slope, np.asarray(power, np.float64)) + np.reshape(
            still, (-1, *(1,) * np.ndim(power))
        )

    def equations(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """A (5, 5), W/K, b (5,), W, and the shares s (5,) of A T = b + P s, T above ambient.

        With the capacities C of the nodes, C dT/dt = b + P s - A T.
        """
        size = len(NODES)
        matrix, source = np.zeros((size, size)), np.zeros(size)
        for name, (start, end) in CONDUCTANCES.items():
            g, first = self.conductances[name], NODES.index(start)
            matrix[first, first] += g
            if end in NODES:
                second = NODES.index(end)
                matrix[second, second] += g
                matrix[first, second] -= g
                matrix[second, first] -= g
        elements = NODES.index("elements")
        matrix[elements, elements] += self.oil
        source[elements] += self.oil * (self.oil_inlet - self.ambient)
        source[[NODES.index("shaft"), NODES.index("housing")]] += self.outside
        share = np.zeros(size)
        share[NODES.index("inner_ring")] = self.inner_share
        share[NODES.index("outer_ring")] = 1.0 - self.inner_share
        return matrix, source, share

    def _line(self) -> tuple[FloatArray, FloatArray]:
        """T at P = 0, K, and dT/dP, K/W; above ambient, so that no digits are lost."""
        self._check_ways_out()
        matrix, source, share = self.equations()
        found = np.linalg.solve(matrix, np.stack([source, share], axis=1))
        still, slope = np.asarray(found, np.float64).T
        return self.ambient + still, slope

    def _check_ways_out(self) -> None:
        reached = {AMBIENT} | ({"elements"} if self.oil else set())
        for _ in NODES:
            for name, ends in CONDUCTANCES.items():
                if self.conductances[name] > 0.0 and reached & {*ends}:
                    reached |= {*ends}
        for node in NODES:
            if node not in reached:
                name = next(name for name, ends in CONDUCTANCES.items() if node in ends)
                raise InputError(
                    said("leaves no way for the heat to go"),
                    field=f"heat.{name}",
                    value=f"{self.conductances[name]:g} W/K",
                    example=f'{name} = "5 W/K"',
                )

    def most_power(self, limit: float) -> float:
        """Friction at which the hottest node comes to a limit (K); below 0 if it is past it, W."""
        still, slope = self._line()
        with np.errstate(divide="ignore", invalid="ignore"):
            reached = (limit - still) / slope
        if np.any(still > limit):
            return -1.0
        return float(np.min(np.where(slope > 0.0, reached, np.inf)))

    def flows(self, temperatures: FloatArray, power: float) -> tuple[HeatFlow, ...]:
        """What flows between the nodes at temperatures (5,) and a friction (W)."""
        at = dict(zip(NODES, temperatures.tolist(), strict=True)) | {AMBIENT: self.ambient}
        found = [
            HeatFlow("friction", "inner_ring", self.inner_share * power),
            HeatFlow("friction", "outer_ring", (1.0 - self.inner_share) * power),
        ]
        for node, heat in zip(("shaft", "housing"), self.outside, strict=True):
            if heat:
                found.append(HeatFlow("outside", node, heat))
        for name, (start, end) in CONDUCTANCES.items():
            found.append(HeatFlow(start, end, self.conductances[name] * (at[start] - at[end])))
        if self.oil:
            found.append(HeatFlow("elements", OIL, self.oil * (at["elements"] - self.oil_inlet)))
        return tuple(found)


def network_of(case: Case, cold: Solved, index: int = 0) -> Network:
    """Return the network of a case, with estimates for what its [heat] does not give.

    Parameters
    ----------
    case
        Its [heat] may be missing: all of it is estimated then.
    cold
        The solved cold state, whose contacts conduct.
    index
        Which of its cases.

    Raises
    ------
    InputError
        If a size that an estimate needs is missing.
    """
    heat = case.heat or Heat()
    given = {name: getattr(heat, name) for name in CONDUCTANCES}
    estimated = tuple(name for name, value in given.items() if value is None)
    found = {name: value for name, value in given.items() if value is not None}
    for name in estimated:
        found[name] = _estimate(name, case, heat, cold, index)
    return Network(
        conductances={name: float(found[name]) for name in CONDUCTANCES},
        oil=OIL_CAPACITY * heat.oil_flow,
        ambient=heat.ambient,
        oil_inlet=heat.ambient if heat.oil_inlet is None else heat.oil_inlet,
        outside=(heat.shaft_heat, heat.housing_heat),
        inner_share=heat.inner_share,
        estimated=estimated,
    )


def capacities_of(case: Case) -> tuple[FloatArray, tuple[str, ...]]:
    """Return the heat that warms each node by 1 K, (5,), J/K, and which of them are estimates.

    Parameters
    ----------
    case
        Its [heat] may be missing: all of it is estimated then.

    Raises
    ------
    InputError
        If a size that an estimate needs is missing.
    """
    heat = case.heat or Heat()
    given = {name: getattr(heat, name) for name in CAPACITIES}
    estimated = tuple(name for name, value in given.items() if value is None)
    values = [_capacity(name, case, heat) if own is None else own for name, own in given.items()]
    return np.array(values, np.float64), estimated


def _capacity(name: str, case: Case, heat: Heat) -> float:
    """ρ c of steel times the volume of a node, of all bearings of the case; J/K."""
    bearing, mounting = case.bearing, case.mounting
    rows = [place.bearing for place in bearing.places]
    if name == "elements_capacity":
        return DENSITY * CAPACITY * sum(_elements(row) for row in rows)
    bore, outside, width = (
        _size(case, heat, size, name) for size in ("bore", "outside_diameter", "width")
    )
    within = rows[0].pitch_diameter - rows[0].element_diameter
    around = rows[0].pitch_diameter + rows[0].element_diameter
    hollow = 0.0 if mounting is None else mounting.shaft_bore
    wall = None if mounting is None else mounting.housing_outside_diameter
    ends = {
        "inner_ring_capacity": (bore, within, 1.0),
        "outer_ring_capacity": (around, outside, 1.0),
        "shaft_capacity": (hollow, bore, SEAT_WIDTHS),
        "housing_capacity": (outside, wall or HOUSING_WALL * outside, SEAT_WIDTHS),
    }
    inside, edge, widths = ends[name]
    count = len(bearing.places) // bearing.rows_of_one_bearing
    area = 0.25 * pi * max(edge**2 - inside**2, 0.01 * edge**2)
    return DENSITY * CAPACITY * count * area * widths * width


def _elements(row: Bearing | RollerBearing) -> float:
    """Volume of the elements of a row, m³."""
    if isinstance(row, Bearing):
        return row.ball_count * pi / 6.0 * row.ball_diameter**3
    return row.roller_count * 0.25 * pi * row.roller_diameter**2 * row.effective_length


def _estimate(name: str, case: Case, heat: Heat, cold: Solved, index: int) -> float:
    if name in ("inner_ring_elements", "elements_outer_ring"):
        return _contact_conductance(cold, index, inner=name == "inner_ring_elements")
    bearing = case.bearing
    if bearing.bearing_type.washers:
        raise InputError(
            said("is missing; its estimate is for radial bearings"),
            field=f"heat.{name}",
            example=f'{name} = "5 W/K"',
        )
    bore, outside, width = (
        _size(case, heat, size, name) for size in ("bore", "outside_diameter", "width")
    )
    count = len(bearing.places) // bearing.rows_of_one_bearing
    if name.endswith("ambient"):
        share = (bore if name == "shaft_ambient" else outside) / (bore + outside)
        flow = reference_heat_flow(bore, outside, width) / REFERENCE_RISE
        return count * share * flow
    return count * SEAT * pi * width * (bore if name == "inner_ring_shaft" else outside)


def _size(case: Case, heat: Heat, name: str, wanted: str) -> float:
    """A size of one bearing, m."""
    for table in (heat, case.mounting, case.film, case.bearing.published):
        found = getattr(table, name, None)
        if found is not None:
            return float(found)
    example = {"bore": "40 mm", "outside_diameter": "80 mm", "width": "18 mm"}[name]
    raise InputError(
        said("is missing; the estimate of heat.{wanted} needs it", wanted=wanted),
        field=f"heat.{name}",
        example=f'{name} = "{example}", or {wanted} = "5 W/K"',
    )


def _contact_conductance(cold: Solved, index: int, *, inner: bool) -> float:
    """Conductance of all contacts of a race, W/K; NaN where they are not known."""
    if not cold.converged[index]:
        return nan
    contacts = cold.inner if inner else cold.outer
    a, b = contacts.semi_major[index], contacts.semi_minor[index]
    speed = np.abs(np.nan_to_num(contacts.entrainment[index]))
    moving = a * _EFFUSIVITY * np.sqrt(0.5 * pi * speed * b)
    return float(np.nansum(moving + 2.0 * CONDUCTIVITY * np.sqrt(a * b)))
