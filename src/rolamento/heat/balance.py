"""The heat balance of a bearing or a set: at which temperatures it runs, and what its preload is.

All temperatures are linear in the friction P (`rolamento.heat.network`), so that one equation is
left:

    h(P) = friction(T(P)) - P = 0.

Friction falls where the oil gets thinner and rises with the preload that warm inner parts make, so
that h may have no root, one or several. All of them below the temperature limit are looked for: a
state is stable where d friction/dP < 1, for then a little more heat makes less than it needs. A
bearing that starts cold comes to the stable state of lowest temperature. Where there is none the
temperature runs away; then the highest speed with a state is looked for, at which in general a
stable and an unstable state merge.

Geometry, film, friction and life at any temperatures are those of `rolamento.analyse` for the case
with these temperatures; the lubricant has the mean of the rings unless the case gives its own.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import cached_property
from math import inf, nan
from typing import Any, Final

import numpy as np

from rolamento.analysis import Analysis, analyse
from rolamento.analysis.needs import has_oil
from rolamento.case import Case, case_of
from rolamento.case.bearing import Bearing
from rolamento.case.heat import Heat
from rolamento.case.roller_bearing import RollerBearing
from rolamento.clearance import clearance_notes, clearance_of_case
from rolamento.friction.summary import Friction
from rolamento.geometry import clearance_of_angle, ring_geometry
from rolamento.heat.network import NODES, HeatFlow, Network, network_of
from rolamento.heat.warmed import Warmed, temperature_fields
from rolamento.io.json import dumps, plain
from rolamento.lubrication.films import Film
from rolamento.numerics import BoolArray, FloatArray, IntArray
from rolamento.numerics.root import increasing_root
from rolamento.records import frozen
from rolamento.solved import Solved
from rolamento.system.mounted import notes_on_set
from rolamento.words import Note

__all__ = ["HeatBalance", "HeatCurve", "HeatRoot", "HeatState", "heat_balance", "heat_balances"]

CaseLike = Case | Bearing | RollerBearing | str | os.PathLike[str]

_POINTS: Final = 17
"""Powers at which friction is looked at first, some 8 K apart between 20 and 150 °C."""
_CLOSER: Final = 8
"""Rounds that halve intervals in which there may be more roots than their ends show."""
_FINEST: Final = 2000.0
"""Parts of the greatest power below which intervals are not halved, 0.07 K."""
_EVENLY: Final = 33
"""Powers at which the least friction at a speed is looked for, and where it has no equilibrium."""
_TOLERANCE: Final = 1e-6
"""Relative, of the last of Newton's steps to a root; one more follows with its final slope."""
_APART: Final = 1e-4
"""Share of an interval: the step by which Newton's method finds the slope."""
_DOUBT: Final = 1e-6
"""Relative difference of friction and heat above which a root is none."""
_SLOPE: Final = 1e-3
"""Share of the greatest power: the step by which d friction/dP is found."""
_BETWEEN: Final = 5
"""Speeds that are tried at once between one with a state and one without."""
_ROUNDS: Final = 6
"""6^-6 = 2e-5 of the speed is where these end."""
_COLD: Final = ("inner_ring", "outer_ring", "balls", "shaft", "housing")
RUNAWAY: Final = "thermal_runaway"


@frozen
class HeatRoot:
    """A state in which friction and the heat that is removed are equal.

    Attributes
    ----------
    power
        W
    temperatures
        by node, K
    slope
        d friction/dP
    """

    power: float
    temperatures: Mapping[str, float]
    slope: float

    @property
    def stable(self) -> bool:
        """Whether the bearing returns to it."""
        return self.slope < 1.0

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, SI."""
        return {
            "power": self.power,
            "temperatures": dict(self.temperatures),
            "slope": self.slope,
            "stable": self.stable,
        }


@frozen(eq=False)
class HeatCurve:
    """Friction over the heat that is removed; arrays over the points that were calculated.

    Attributes
    ----------
    power
        that is removed, rising, (points,), W
    temperatures
        of the nodes then, (5, points), K
    friction
        at these temperatures, W; NaN without an equilibrium
    """

    power: FloatArray
    temperatures: FloatArray
    friction: FloatArray


@frozen(eq=False)
class _Batch:
    """Solved cases with their film, friction and preload, of which a state is one.

    alone: whether all of them are of one case.
    """

    solved: Solved
    film: Film | None
    friction: Friction | None
    preload: FloatArray
    by: str
    alone: bool


@frozen(eq=False, slots=False)
class HeatState:
    """What a bearing is like at some temperatures.

    Attributes
    ----------
    given
        the case as it was given
    temperatures
        by node, K
    torque
        of the friction that the heat balance uses, N·m
    power
        of it, W
    """

    given: Case
    temperatures: Mapping[str, float]
    torque: float
    power: float
    _batch: _Batch
    _index: int
    _threads: int | None = None

    @cached_property
    def case(self) -> Case:
        """The case with these temperatures: analysed alone it gives this state."""
        own = self.given.temperature
        gone = {
            f"temperature.{name}": None
            for name in ("inner_spacer", "outer_spacer")
            if getattr(own, name, None) is not None
        }
        at = temperature_fields(self.given, np.array(list(self.temperatures.values())))
        return self.given.with_({**gone, **{name: float(value) for name, value in at.items()}})

    @cached_property
    def analysis(self) -> Analysis:
        """Film, friction and life of it."""
        return analyse(self.case, quick=True, threads=self._threads)

    @property
    def lubricant(self) -> float | None:
        """Temperature of the lubricant, K; None without."""
        return self.case.lubricant_temperature

    @property
    def preload(self) -> float | None:
        """Axial force between rows that face each other, without external load, at speed; N."""
        value = float(self._batch.preload[self._index])
        return value if np.isfinite(value) else None

    @property
    def axial_load(self) -> float:
        """F_x: of a ring that is held axially the force that holds it; N."""
        return float(self._batch.solved.load.fx[self._index])

    @property
    def axial_stiffness(self) -> float:
        """Stiffness along the shaft, N/m."""
        return float(self._batch.solved.stiffness.array[self._index, 0, 0])

    @property
    def clearance(self) -> tuple[float, ...]:
        """Diametral clearance of each row as it runs; NaN of tapered rollers; m."""
        return tuple(
            _clearance(place.bearing) for place in self.analysis.solved.case.bearing.places
        )

    @property
    def contact_angle(self) -> tuple[float, ...]:
        """Free contact angle of each row as it runs, rad."""
        return tuple(self._batch.solved.rows.free_contact_angle[self._index].tolist())

    @property
    def max_pressure(self) -> float:
        """The largest of all contacts, Pa."""
        solved = self._batch.solved
        found = [contacts.max_pressure[self._index] for contacts in (solved.inner, solved.outer)]
        if not np.isfinite(found).any():
            return nan
        return float(np.nanmax(found))

    @property
    def film_parameter(self) -> float | None:
        """The minimum λ of all contacts; None without a film or roughness."""
        found = self._batch.film
        value = nan if found is None else float(found.minimum_film_parameter[self._index])
        return value if np.isfinite(value) else None

    @property
    def viscosity_ratio(self) -> float | None:
        """The ratio κ; None without an oil."""
        found = self._batch.film
        value = nan if found is None else float(found.viscosity_ratio[self._index])
        return value if np.isfinite(value) else None

    @cached_property
    def notes(self) -> tuple[Note, ...]:
        """What the analysis says of it, without what a quick one leaves out."""
        batch, index = self._batch, self._index
        solved, lost = batch.solved, batch.friction
        notes: list[Note] = []
        if batch.alone:
            notes = [*self.analysis.solved.notes[0], *self.analysis.notes]
        elif solved.converged[index]:
            notes = [*_of_mounting(self.case), *solved[index].notes[0]]
        if lost is not None and batch.by == "contacts":
            notes += lost.qualifications(solved, index)
        elif lost is not None:
            of_model = (one for one in lost.validity if one.model == batch.by)
            notes += (note for one in of_model for note in one.notes_of(index))
        return tuple(note for note in notes if note.key not in _LEFT_OUT)

    @property
    def life_hours(self) -> float | None:
        """The life that leads, h; None if the case has none."""
        life = self.analysis.life
        return None if life is None else float(life.headline.hours[0])

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, SI; the life in hours."""
        names = (
            "lubricant", "preload", "axial_load", "axial_stiffness", "clearance", "contact_angle",
            "max_pressure", "film_parameter", "viscosity_ratio", "torque", "power", "life_hours",
        )  # fmt: skip
        own: dict[str, Any] = plain({name: getattr(self, name) for name in names})
        return {"temperatures": dict(self.temperatures), **own, "case": self.case.to_mapping()}


@frozen(eq=False, slots=False)
class HeatBalance:
    """The temperatures at which a bearing runs, and what becomes of its preload.

    Attributes
    ----------
    case
        as it was given
    status
        "converged"; "thermal_runaway" where no stable state lies below the temperature limit; that
        of the equilibrium where the cold bearing has none; "not_converged"
    network
        of conductances
    cold, warm
        all parts at ambient temperature; in the state that is the answer, None without one
    flows
        heat between the nodes in the warm state, W; empty without one
    roots
        all states below the temperature limit, the coldest first
    curve
        friction over the heat that is removed
    runaway
        the speeds as a multiple of the case's up to which there is a state; NaN if that was not
        looked for
    merges
        whether two states merge there; else the coldest one comes to the temperature limit
    """

    case: Case
    status: str
    network: Network
    cold: HeatState
    warm: HeatState | None
    flows: tuple[HeatFlow, ...]
    roots: tuple[HeatRoot, ...]
    curve: HeatCurve
    runaway: float
    merges: bool
    _own_notes: tuple[Note, ...] = ()

    @cached_property
    def notes(self) -> tuple[Note, ...]:
        """What to know about it."""
        state = self.cold if self.warm is None else self.warm
        return tuple(dict.fromkeys((*self._own_notes, *state.notes)))

    @property
    def converged(self) -> bool:
        """Whether there is a state."""
        return self.status == "converged"

    @property
    def root(self) -> HeatRoot | None:
        """The state that is the answer."""
        return self._answer() if self.converged else None

    def _answer(self) -> HeatRoot | None:
        return next((root for root in self.roots if root.stable), None)

    @property
    def power(self) -> float:
        """Friction in the warm state, W; NaN without one."""
        return nan if self.root is None else self.root.power

    @property
    def temperatures(self) -> dict[str, float]:
        """By node in the warm state, K; NaN without one."""
        return dict.fromkeys(NODES, nan) if self.root is None else dict(self.root.temperatures)

    @property
    def limit(self) -> float:
        """The temperature limit, K."""
        return (self.case.heat or Heat()).limit

    @property
    def runaway_speeds(self) -> tuple[float, float]:
        """Inner and outer speed up to which there is a state, rad/s; NaN if not looked for."""
        duty = self.case.duty
        return self.runaway * duty.inner_speed, self.runaway * duty.outer_speed

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists, SI."""
        network = self.network
        return {
            "title": self.case.title,
            "status": self.status,
            "power": plain(self.power),
            "temperatures": plain(self.temperatures),
            "limit": self.limit,
            "flows": [
                {"from": flow.start, "to": flow.end, "power": flow.power} for flow in self.flows
            ],
            "states": [root.to_mapping() for root in self.roots],
            "runaway_speed": plain(dict(zip(("inner", "outer"), self.runaway_speeds, strict=True))),
            "cold": self.cold.to_mapping(),
            "warm": None if self.warm is None else self.warm.to_mapping(),
            "conductances": {
                **{
                    name: {"value": plain(value), "estimated": name in network.estimated}
                    for name, value in network.conductances.items()
                },
                "oil": {"value": network.oil, "estimated": False},
            },
            "curve": plain(
                {
                    "power": self.curve.power,
                    "friction": self.curve.friction,
                    **dict(zip(NODES, self.curve.temperatures, strict=True)),
                }
            ),
            "notes": [note.to_mapping() for note in self.notes],
            "case": self.case.to_mapping(),
        }

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give it as one JSON object, in SI units."""
        return dumps(self.to_mapping(), indent)


def heat_balance(
    case: CaseLike,
    *,
    look_for_speed: bool = True,
    threads: int | None = None,
) -> HeatBalance:
    """Find the temperatures at which a bearing or a set runs, and what its preload is then.

    Parameters
    ----------
    case
        Its file, or a designation; `case.heat` says where the heat goes. It needs what its friction
        needs: an oil or a grease, or a coefficient of friction. With a mounting the temperatures
        change clearance and preload; the temperatures that it gives, but that of the lubricant, are
        replaced by those of the balance.
    look_for_speed
        Whether to look for the highest speed with a state where there is none at the case's.
    threads
        As many as there are processors by default.

    Returns
    -------
    HeatBalance
        Never raises for a duty without a solution: the status says so.

    Raises
    ------
    InputError
        If a size that an estimate needs is missing, heat has no way out, or the friction that is
        asked for is not known.

    Harris (1991), chapter 15 (the network); ISO 15312:2003; docs/theory/heat.md.

    >>> from rolamento import load_case
    >>> duty = {"duty.load.fz": "10 kN", "duty.inner_speed": "3000 rpm"}
    >>> found = heat_balance(load_case("6220", duty | {"lubricant": "ISO VG 68"}))
    >>> print(f"{found.power:.0f} W, inner ring {found.temperatures['inner_ring'] - 273.15:.0f} °C")
    300 W, inner ring 57 °C
    """
    case = case_of(case)
    return balances_of(case, threads).answers(look_for_speed)[0]


def heat_balances(
    case: CaseLike,
    values: Mapping[str, FloatArray],
    *,
    threads: int | None = None,
) -> tuple[HeatBalance, ...]:
    """Find the heat balances of a case over the values of some fields, all of them at once.

    Parameters
    ----------
    case
        As of `heat_balance`.
    values
        By the dotted names of fields, (points,) each, SI.
    threads
        As of `heat_balance`.

    Returns
    -------
    tuple of HeatBalance
        One a point, each as `heat_balance` gives it without looking for a speed.

    Raises
    ------
    InputError
        As `heat_balance`.
    """
    case = case_of(case)
    count = len(next(iter(values.values())))
    cases = tuple(
        case.with_({name: float(array[index]) for name, array in values.items()})
        for index in range(count)
    )
    fields = Case.fields()
    of_network = {name for name in values if name.startswith("heat.")}
    together = {name: np.asarray(a, np.float64) for name, a in values.items()}
    together = {name: array for name, array in together.items() if name not in of_network}
    if all(fields[name].varies for name in together) and "heat.friction" not in of_network:
        return _Balances(case, together, cases, threads).answers(look_for_speed=False)
    return tuple(heat_balance(one, look_for_speed=False, threads=threads) for one in cases)


def balances_of(case: Case, threads: int | None = None) -> _Balances:
    """Return a heat balance in the making, for those who look at other speeds."""
    return _Balances(case, {}, (case,), threads)


class _Balances:
    """Heat balances in the making: what stays the same while powers and speeds are tried.

    cases: each as it is given; values: what differs between them, for `Warmed`.
    """

    def __init__(
        self,
        case: Case,
        values: Mapping[str, FloatArray],
        cases: tuple[Case, ...],
        threads: int | None,
    ) -> None:
        self.cases, self.threads = cases, threads
        self.warmed = Warmed(case, values, threads)
        self.heats = [one.heat or Heat() for one in cases]
        self.each = np.arange(len(cases))
        self.ambient = np.tile([heat.ambient for heat in self.heats], (len(NODES), 1))
        self.cold = self.warmed.solved(self.ambient, self.each)
        self.nets = [network_of(one, self.cold, index) for index, one in enumerate(cases)]
        self.most = np.array(
            [
                net.most_power(heat.limit) if solved else nan
                for net, heat, solved in zip(
                    self.nets, self.heats, self.cold.converged.tolist(), strict=True
                )
            ]
        )

    def friction_over(
        self, temperatures: FloatArray, which: IntArray, factor: FloatArray | float = 1.0
    ) -> FloatArray:
        """Friction of cases at temperatures (5, n), at multiples of the speeds; (n,), W."""
        return self.warmed.power(temperatures, which, speed=factor)

    def friction_at(self, power: FloatArray, which: IntArray) -> FloatArray:
        """Friction of cases at the temperatures that powers (n,) make, W."""
        return self.friction_over(self.at(power, which), which)

    def at(self, power: FloatArray, which: IntArray) -> FloatArray:
        """Temperatures of the nodes of cases at powers (n,); (5, n), K."""
        pairs = zip(which.tolist(), power, strict=True)
        return np.array([self.nets[k].temperatures(one) for k, one in pairs]).T

    # --- the roots --------------------------------------------------------------------------------

    def answers(self, look_for_speed: bool) -> tuple[HeatBalance, ...]:
        """All balances."""
        curves = self.scanned()
        cold, roots, warm, doubtful = self.states_of(*self.roots(curves))
        balances = []
        for index, (case, net) in enumerate(zip(self.cases, self.nets, strict=True)):
            runaway, merges, notes = nan, False, list(self._notes(index))
            status = str(self.cold.status.code[index])
            place = next((k for k, root in enumerate(roots[index]) if root.stable), None)
            if status == "converged" and place is None:
                status = "not_converged" if doubtful[index] else RUNAWAY
            if status == RUNAWAY:
                runaway, merges = self.runaway(index) if look_for_speed else (nan, False)
                notes.insert(0, self._runaway_note(index, curves[index], runaway, merges))
            flows: tuple[HeatFlow, ...] = ()
            if place is not None:
                root = roots[index][place]
                flows = net.flows(np.array(list(root.temperatures.values())), root.power)
                hotter = [one for one in roots[index] if not one.stable]
                if hotter:
                    hot = max(hotter[0].temperatures.values())
                    notes.append(Note("hotter_unstable_state", {"temperature": hot}))
            power, values = curves[index]
            at = net.temperatures(power) if len(power) else np.zeros((len(NODES), 0))
            balances.append(
                HeatBalance(
                    case, status, net, cold[index], None if place is None else warm[index][place],
                    flows, roots[index], HeatCurve(power, at, values), runaway, merges,
                    tuple(notes),
                )
            )  # fmt: skip
        return tuple(balances)

    def states_of(
        self, which: IntArray, powers: FloatArray
    ) -> tuple[
        list[HeatState], list[tuple[HeatRoot, ...]], list[tuple[HeatState, ...]], list[bool]
    ]:
        """The cold state of each case, its roots, the states there, and whether one is doubtful.

        which: of which case a root is; powers: where it probably is, W. Cold states, roots and what
        lies beside them for their slopes are solved together.
        """
        most = self.most[which]
        step = _SLOPE * most
        below, above = np.maximum(powers - step, 0.0), np.minimum(powers + step, most)
        every = np.concatenate([self.each, np.tile(which, 3)])
        at = self.ambient
        if len(which):
            at = np.hstack(
                [at, self.at(np.concatenate([powers, below, above]), every[len(at.T) :])]
            )
        torque, power, batch = self.looked_at(at, every)
        count, roots = len(self.cases), len(which)
        own, low, high = np.split(power[count:], 3)
        with np.errstate(invalid="ignore", divide="ignore"):
            slopes = (high - low) / (above - below)
            exact = powers - (powers - own) / (1.0 - slopes)  # a last step of Newton's
            good = np.abs(own - powers) <= _DOUBT * np.maximum(powers, 1e-4 * step)
            exact = np.where(np.isfinite(exact) & good, np.clip(exact, 0.0, most), powers)

        def state(index: int) -> HeatState:
            temperatures = dict(zip(NODES, at[:, index].tolist(), strict=True))
            return HeatState(
                self.cases[int(every[index])], temperatures, float(torque[index]),
                float(power[index]), batch, index, self.threads,
            )  # fmt: skip

        found: list[tuple[HeatRoot, ...]] = []
        warm: list[tuple[HeatState, ...]] = []
        doubtful = []
        for index in range(count):
            places = [k for k in range(roots) if which[k] == index]
            kept = sorted((k for k in places if good[k]), key=lambda k: float(powers[k]))
            doubtful.append(len(kept) < len(places))
            found.append(
                tuple(
                    HeatRoot(
                        float(exact[k]),
                        dict(
                            zip(
                                NODES,
                                self.nets[index].temperatures(exact[k]).tolist(),
                                strict=True,
                            )
                        ),
                        float(slopes[k]),
                    )
                    for k in kept
                )
            )
            warm.append(tuple(state(count + k) for k in kept))
        return [state(index) for index in range(count)], found, warm, doubtful

    def looked_at(
        self, temperatures: FloatArray, which: IntArray
    ) -> tuple[FloatArray, FloatArray, _Batch]:
        """Torque (N·m) and power (W) of cases at temperatures (5, n), and all that is known."""
        warmed = self.warmed
        solved = warmed.solved(temperatures, which)
        torque = power = np.full(len(solved), nan)
        oil: Film | None = None
        lost: Friction | None = None
        if solved.converged.any():
            oil, lost = warmed.friction_of(solved)
            torque, power = warmed.torque_and_power(solved, oil, lost)
        alone = len(self.cases) == 1
        return torque, power, _Batch(solved, oil, lost, warmed.preload(solved), warmed.by, alone)

    def scanned(self) -> list[tuple[FloatArray, FloatArray]]:
        """Powers of each case up to the temperature limit, and the friction there."""
        curves = [(np.zeros(0), np.zeros(0)) for _ in self.cases]
        wanted = [
            np.linspace(0.0, most, _POINTS) if most >= 0.0 else np.zeros(0)
            for most in self.most.tolist()
        ]
        for _ in range(_CLOSER + 1):
            which = np.repeat(self.each, [len(one) for one in wanted])
            if not len(which):
                break
            found = self.friction_at(np.concatenate(wanted), which)
            parts = np.split(found, np.cumsum([len(one) for one in wanted])[:-1])
            for index, (more, values) in enumerate(zip(wanted, parts, strict=True)):
                power = np.concatenate([curves[index][0], more])
                order = np.argsort(power)
                curves[index] = power[order], np.concatenate([curves[index][1], values])[order]
            wanted = [
                _between(power, values - power) if len(more) else more
                for more, (power, values) in zip(wanted, curves, strict=True)
            ]
        return curves

    def roots(self, curves: list[tuple[FloatArray, FloatArray]]) -> tuple[IntArray, FloatArray]:
        """The case of each root, and its power but for a last step, (roots,), W."""
        exact: list[tuple[int, float]] = []
        which, ends = [], []
        for index, (power, values) in enumerate(curves):
            h = values - power
            exact += [(index, float(power[i])) for i in np.flatnonzero(h == 0.0)]
            for i in np.flatnonzero(h[:-1] * h[1:] < 0.0).tolist():
                which.append(index)
                ends.append((power[i], power[i + 1], h[i], _started(power, h, i)))
        cases = np.array([*(index for index, _ in exact), *which], np.int64)
        known = np.array([power for _, power in exact])
        if not ends:
            return cases, known
        own_cases = np.array(which)
        lower, upper, first, start = np.array(ends).T
        sign = np.where(first > 0.0, 1.0, -1.0)  # of roots that end in the stable state
        step = _APART * (upper - lower)

        def excess(x: FloatArray) -> tuple[FloatArray, FloatArray]:
            beside = np.where(x + step <= upper, x + step, x - step)
            both = self.friction_at(np.concatenate([x, beside]), np.tile(own_cases, 2))
            own, next_to = np.split(both, 2)
            slope = 1.0 - (next_to - own) / (beside - x)
            return sign * (x - own), sign * slope

        x, _ = increasing_root(excess, start, lower, upper, tolerance=_TOLERANCE)
        x = np.where(np.isfinite(x), x, 0.5 * (lower + upper))
        return cases, np.concatenate([known, x])

    # --- the highest speed ------------------------------------------------------------------------

    def runaway(self, index: int, low: float = 0.0, high: float = 1.0) -> tuple[float, bool]:
        """The multiple of the speeds up to which there is a state, and whether two merge there."""
        if self.most[index] < 0.0:
            return nan, False
        merges = False
        for _ in range(_ROUNDS):
            factors = np.linspace(low, high, _BETWEEN + 2)[1:-1]
            least, at_end = self.least_excess(index, factors)
            without = np.flatnonzero(~(least <= 0.0))
            first = int(without[0]) if len(without) else len(factors)
            if first < len(factors):
                high, merges = float(factors[first]), not at_end[first]
            if first > 0:
                low = float(factors[first - 1])
        return low, merges

    def least_excess(self, index: int, factors: FloatArray) -> tuple[FloatArray, BoolArray]:
        """Least h at each multiple of the speeds, and whether it lies at the temperature limit."""
        own = np.full(len(factors), index)
        cold = self.warmed.solved(self.ambient[:, own], own, speed=factors)
        known, case, limit = cold.converged, self.cases[index], self.heats[index].limit
        nets = [
            network_of(case, cold, place) if known[place] else self.nets[index]
            for place in range(len(factors))
        ]
        most = np.array([net.most_power(limit) for net in nets])

        def excess(power: FloatArray) -> FloatArray:
            at = [net.temperatures(one) for net, one in zip(nets, power, strict=True)]
            points = power.shape[1]
            which, factor = np.repeat(own, points), np.repeat(factors, points)
            found = self.friction_over(np.concatenate(at, axis=1), which, factor)
            h = found.reshape(power.shape) - power
            return np.where(np.isfinite(h) & known[:, np.newaxis], h, inf)

        power = np.linspace(0.0, most, _EVENLY, axis=1)
        h = excess(power)
        place = np.argmin(h, axis=1)
        each = np.arange(len(factors))
        before, after = np.maximum(place - 1, 0), np.minimum(place + 1, _EVENLY - 1)
        closer = np.linspace(power[each, before], power[each, after], 2 * _BETWEEN + 1, axis=1)
        least = np.minimum(h.min(axis=1), excess(closer).min(axis=1))
        return least, place == _EVENLY - 1

    # --- what to know -----------------------------------------------------------------------------

    def _notes(self, index: int) -> list[Note]:
        case, network, notes = self.cases[index], self.nets[index], []
        if network.estimated:
            notes.append(Note("conductances_estimated", {"names": list(network.estimated)}))
        if case.mounting is None:
            notes.append(Note("heat_without_mounting"))
        if self.warmed.gives_lubricant and has_oil(case):
            warm = case.lubricant_temperature
            notes.append(Note("lubricant_keeps_temperature", {"temperature": warm}))
        own = case.temperature
        names = (*_COLD, "inner_spacer", "outer_spacer")
        given = [name for name in names if getattr(own, name, None) is not None]
        if given:
            notes.append(Note("temperatures_of_balance", {"names": given}))
        return notes

    def _runaway_note(
        self, index: int, curve: tuple[FloatArray, FloatArray], runaway: float, merges: bool
    ) -> Note:
        limit = self.heats[index].limit
        if self.most[index] < 0.0:
            return Note("heated_past_limit", {"limit": limit})
        duty, (power, values) = self.cases[index].duty, curve
        speed = max(duty.inner_speed, duty.outer_speed, key=abs)
        lost = power[~np.isfinite(values)]
        warm = None
        if len(lost):
            warm = float(self.nets[index].temperatures(lost.min()).max())
        return Note(
            RUNAWAY,
            {
                "limit": limit,
                "factor": plain(runaway),
                "speed": plain(abs(runaway * speed)),
                "merges": merges,
                "lost_at": warm,
            },
        )


def _started(power: FloatArray, h: FloatArray, i: int) -> float:
    """Where h changes its sign between two points, by a cubic through two more."""
    some = slice(max(i - 1, 0), i + 3)
    x, y = power[some], h[some]
    low, high = float(power[i]), float(power[i + 1])
    line = low + (high - low) * float(h[i] / (h[i] - h[i + 1]))
    if not np.isfinite(y).all():
        return line
    scale = high - low
    roots = np.roots(np.polyfit((x - low) / scale, y, len(x) - 1))
    real = [float(one.real) for one in roots if abs(one.imag) < 1e-9 and 0.0 <= one.real <= 1.0]
    return low + scale * real[0] if len(real) == 1 else line


def _between(power: FloatArray, h: FloatArray) -> FloatArray:
    """Middles of intervals in which h may have roots that the signs at their ends do not show.

    Its second derivative, by neighbours, bounds how far h may dip between two points of one sign,
    and how much its slope may turn between two of different signs; doubled for safety.
    """
    count = len(power)
    if count < 3:
        return np.zeros(0)
    step = np.diff(power)
    slope = np.diff(h) / step
    bend = np.abs(np.diff(slope)) / (0.5 * (step[:-1] + step[1:]))
    bend = np.concatenate([bend[:1], bend, bend[-1:]])  # at every point
    with np.errstate(invalid="ignore"):
        most = 2.0 * np.fmax(bend[:-1], bend[1:])
        dips = np.fmin(np.abs(h[:-1]), np.abs(h[1:])) < most * step**2 / 8.0
        turns = np.abs(slope) < 0.5 * most * step
        crosses = h[:-1] * h[1:] < 0.0
    known = np.isfinite(h[:-1]) & np.isfinite(h[1:]) & np.isfinite(most)
    looked = np.where(crosses, turns, dips & turns) & known & (h[:-1] != 0.0) & (h[1:] != 0.0)
    looked &= step > power[-1] / _FINEST
    edges = np.isfinite(h[:-1]) != np.isfinite(h[1:])
    looked |= edges & (step > power[-1] / _EVENLY)
    return np.asarray(0.5 * (power[:-1] + power[1:])[looked])


def _of_mounting(case: Case) -> tuple[Note, ...]:
    """What `rolamento.solve` says of the fits of a single case, but for stages of the preload."""
    if case.mounting is None:
        return ()
    if not case.bearing.is_one_bearing:
        return notes_on_set(case, ())
    return clearance_notes(clearance_of_case(case))


def _clearance(bearing: Bearing | RollerBearing) -> float:
    if bearing.bearing_type.conical:
        return nan
    if bearing.diametral_clearance is not None:
        return float(bearing.diametral_clearance)
    assert isinstance(bearing, Bearing)
    distance = ring_geometry(bearing).groove_centre_distance
    return float(clearance_of_angle(bearing.contact_angle or 0.0, distance))


_LEFT_OUT: Final = frozenset(f"without_{name}" for name in ("friction_models", "stress_volume",
                                                            "preload_loss"))  # fmt: skip
