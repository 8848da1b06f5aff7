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

import json
import os
from collections.abc import Mapping
from math import inf, nan
from typing import Any, Final

import numpy as np

from rolamento.analysis import Analysis, analyse
from rolamento.analysis.needs import has_friction, has_oil, machines_known
from rolamento.case import Case, case_of
from rolamento.case.bearing import Bearing
from rolamento.case.heat import Heat
from rolamento.case.roller_bearing import RollerBearing
from rolamento.errors import InputError
from rolamento.friction import MachineBearing, friction
from rolamento.friction.seals import seals_and_bath
from rolamento.friction.summary import default_model, no_coefficient
from rolamento.geometry import clearance_of_angle, ring_geometry
from rolamento.heat.network import NODES, HeatFlow, Network, network_of
from rolamento.io.json import plain
from rolamento.lubrication.films import film, has_film
from rolamento.numerics import BoolArray, FloatArray
from rolamento.numerics.root import increasing_root
from rolamento.records import frozen
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.words import Note, said

__all__ = ["HeatBalance", "HeatCurve", "HeatRoot", "HeatState", "heat_balance"]

_POINTS: Final = 33
"""Powers at which friction is looked at first, 4 K apart between 20 and 150 °C."""
_CLOSER: Final = 4
"""Rounds that look between two powers for roots that lie there together."""
_TOLERANCE: Final = 1e-9
"""Relative, of the power at a root: what the equilibrium of the elements is solved to."""
_DOUBT: Final = 1e-6
"""Relative difference of friction and heat above which a root is none."""
_SLOPE: Final = 1e-3
"""Share of the greatest power: the step by which d friction/dP is found."""
_BETWEEN: Final = 5
"""Speeds that are tried at once between one with a state and one without."""
_ROUNDS: Final = 6
"""6^-6 = 2e-5 of the speed is where these end."""
_COLD: Final = ("inner_ring", "outer_ring", "balls", "shaft", "housing")
_SPEEDS: Final = ("duty.inner_speed", "duty.outer_speed")
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
class HeatState:
    """What a bearing is like at some temperatures.

    Attributes
    ----------
    case
        with these temperatures: analysed alone it gives this state
    temperatures
        by node, K
    analysis
        film, friction and life of it
    torque
        of the friction that the heat balance uses, N·m
    power
        of it, W
    """

    case: Case
    temperatures: Mapping[str, float]
    analysis: Analysis
    torque: float
    power: float

    @property
    def lubricant(self) -> float | None:
        """Temperature of the lubricant, K; None without."""
        return self.case.lubricant_temperature

    @property
    def preload(self) -> float | None:
        """Axial force between rows that face each other, without external load, at speed; N."""
        preload = self.analysis.solved.preload
        return None if preload is None else preload.at_speed

    @property
    def axial_load(self) -> float:
        """F_x: of a ring that is held axially the force that holds it; N."""
        return float(self.analysis.solved.load.fx[0])

    @property
    def clearance(self) -> tuple[float, ...]:
        """Diametral clearance of each row as it runs; NaN of tapered rollers; m."""
        return tuple(
            _clearance(place.bearing) for place in self.analysis.solved.case.bearing.places
        )

    @property
    def contact_angle(self) -> tuple[float, ...]:
        """Free contact angle of each row as it runs, rad."""
        return tuple(self.analysis.solved.rows.free_contact_angle[0].tolist())

    @property
    def max_pressure(self) -> float:
        """The largest of all contacts, Pa."""
        solved = self.analysis.solved
        found = [contacts.max_pressure for contacts in (solved.inner, solved.outer)]
        if not np.isfinite(found).any():
            return nan
        return float(np.nanmax(found))

    @property
    def film_parameter(self) -> float | None:
        """The minimum λ of all contacts; None without a film or roughness."""
        found = self.analysis.film
        value = nan if found is None else float(found.minimum_film_parameter[0])
        return value if np.isfinite(value) else None

    @property
    def viscosity_ratio(self) -> float | None:
        """The ratio κ; None without an oil."""
        found = self.analysis.film
        return None if found is None else float(found.viscosity_ratio[0])

    @property
    def life_hours(self) -> float | None:
        """The life that leads, h; None if the case has none."""
        life = self.analysis.life
        return None if life is None else float(life.headline.hours[0])

    def to_mapping(self) -> dict[str, Any]:
        """Give it as plain values, SI; the life in hours."""
        names = (
            "lubricant", "preload", "axial_load", "clearance", "contact_angle", "max_pressure",
            "film_parameter", "viscosity_ratio", "torque", "power", "life_hours",
        )  # fmt: skip
        own: dict[str, Any] = plain({name: getattr(self, name) for name in names})
        return {"temperatures": dict(self.temperatures), **own, "case": self.case.to_mapping()}


@frozen(eq=False)
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
    notes
        what to know about it
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
    notes: tuple[Note, ...]

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
        return json.dumps(self.to_mapping(), indent=indent, ensure_ascii=False, allow_nan=False)


def heat_balance(
    case: Case | Bearing | RollerBearing | str | os.PathLike[str],
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
    >>> found = heat_balance(load_case("6220", {**duty, "lubricant": "ISO VG 68"}))
    >>> print(f"{found.power:.0f} W, inner ring {found.temperatures['inner_ring'] - 273.15:.0f} °C")
    300 W, inner ring 57 °C
    """
    case = case_of(case)
    balance = _Balance(case, threads)
    return balance.answer(look_for_speed)


class _Balance:
    """A heat balance in the making: what stays the same while powers and speeds are tried."""

    def __init__(self, case: Case, threads: int | None) -> None:
        self.case, self.threads = case, threads
        self.heat = case.heat or Heat()
        self.gives_lubricant = case.lubricant_temperature is not None
        self.by = self.heat.friction
        if self.by != "contacts" and not has_oil(case):
            raise no_coefficient(case)
        self.cold_case = self.case_at(np.full(len(NODES), self.heat.ambient))
        self.cold = analyse(self.cold_case, quick=True, threads=threads)
        self.network = network_of(case, self.cold.solved)
        solved = bool(self.cold.solved.converged[0])
        self.most = self.network.most_power(self.heat.limit) if solved else nan

    # --- the bearing at temperatures --------------------------------------------------------------

    def fields_at(self, temperatures: FloatArray) -> dict[str, FloatArray]:
        """The temperatures of nodes (5, …) as fields of the case."""
        inner, balls, outer, shaft, housing = temperatures
        found = {"inner_ring": inner, "outer_ring": outer, "balls": balls}
        if self.case.mounting is not None:
            found |= {"shaft": shaft, "housing": housing}
        if has_oil(self.case) and not self.gives_lubricant:
            found["lubricant"] = 0.5 * (inner + outer)
        return {f"temperature.{name}": value for name, value in found.items()}

    def case_at(self, temperatures: FloatArray) -> Case:
        """The case at the temperatures of nodes (5,); spacers follow shaft and housing."""
        own = self.case.temperature
        gone = {"inner_spacer": None, "outer_spacer": None}
        spacers = {
            f"temperature.{name}": None for name in gone if getattr(own, name, None) is not None
        }
        values = {name: float(value) for name, value in self.fields_at(temperatures).items()}
        return self.case.with_({**spacers, **values})

    def friction_of(self, solved: Solved) -> tuple[FloatArray, FloatArray]:
        """Torque (N·m) and power (W) of solved cases; NaN without an equilibrium."""
        if not has_friction(solved):
            raise no_coefficient(self.case)
        oil = film(solved) if has_film(solved) else None
        machine: tuple[MachineBearing, ...]
        if self.by == "contacts":
            model, machine = default_model(solved), ()
        else:
            model, machine = default_model(solved, quick=True), machines_known(solved, oil)
        found = friction(
            solved,
            model=model,
            film_parameter=np.nan if oil is None else oil.minimum_film_parameter,
            machine=machine,
            compare=False,
            threads=self.threads,
        )
        if self.by == "contacts":
            torque, power = found.torque, found.power
        else:
            whole = found.models.get(self.by)
            if whole is None:
                raise InputError(
                    said("needs a bearing with a designation that this model has constants for"),
                    field="heat.friction",
                    value=self.by,
                    example='friction = "contacts"',
                )
            torque, power = whole.total, whole.power
        beside = seals_and_bath(solved, oil)
        if beside is not None:
            torque, power = torque + beside.torque, np.abs(power) + beside.power
        return (
            np.where(solved.converged, torque, np.nan),
            np.where(solved.converged, np.abs(power), np.nan),
        )

    def friction_at(self, power: FloatArray) -> FloatArray:
        """Friction at the temperatures that a power makes, W."""
        return self.friction_over(self.network.temperatures(power))

    def friction_over(
        self, temperatures: FloatArray, factor: FloatArray | float = 1.0
    ) -> FloatArray:
        """Friction at temperatures of the nodes (5, n), at a multiple of the speeds; W."""
        fields = self.fields_at(temperatures)
        if self.case.mounting is None:  # those of the rings act through it
            fields = {name: one for name, one in fields.items() if name.endswith("lubricant")}
        duty = self.case.duty
        for name, speed in zip(_SPEEDS, (duty.inner_speed, duty.outer_speed), strict=True):
            fields[name] = np.broadcast_to(factor * speed, temperatures.shape[1:])
        solved = solve(self.cold_case, fields, threads=self.threads)
        return self.friction_of(solved)[1]

    def state(self, temperatures: FloatArray, analysis: Analysis | None = None) -> HeatState:
        case = self.case_at(temperatures)
        found = analysis or analyse(case, quick=True, threads=self.threads)
        torque = power = nan
        if found.solved.converged[0]:
            torque, power = (float(one[0]) for one in self.friction_of(found.solved))
        return HeatState(
            case, dict(zip(NODES, temperatures.tolist(), strict=True)), found, torque, power
        )

    # --- the roots --------------------------------------------------------------------------------

    def answer(self, look_for_speed: bool) -> HeatBalance:
        cold = self.state(np.full(len(NODES), self.heat.ambient), self.cold)
        status = str(self.cold.solved.status.code[0])
        roots: tuple[HeatRoot, ...] = ()
        power = values = np.zeros(0)
        runaway, merges, notes = nan, False, list(self._notes())
        if status == "converged":
            power, values = self.scanned()
            roots, doubtful = self.roots(power, values)
            if not any(root.stable for root in roots):
                status = "not_converged" if doubtful else RUNAWAY
        if status == RUNAWAY:
            runaway, merges = self.runaway() if look_for_speed else (nan, False)
            notes.insert(0, self._runaway_note(power, values, runaway, merges))
        warm: HeatState | None = None
        flows: tuple[HeatFlow, ...] = ()
        if status == "converged":
            root = next(one for one in roots if one.stable)
            temperatures = self.network.temperatures(root.power)
            warm, flows = self.state(temperatures), self.network.flows(temperatures, root.power)
            hotter = [one for one in roots if not one.stable]
            if hotter:
                hot = max(hotter[0].temperatures.values())
                notes.append(Note("hotter_unstable_state", {"temperature": hot}))
        notes += self._notes_of(warm or cold)
        at = self.network.temperatures(power) if len(power) else np.zeros((len(NODES), 0))
        curve = HeatCurve(power, at, values)
        return HeatBalance(
            self.case, status, self.network, cold, warm, flows, roots, curve, runaway, merges,
            tuple(dict.fromkeys(notes)),
        )  # fmt: skip

    def scanned(self) -> tuple[FloatArray, FloatArray]:
        """Powers up to the temperature limit, and the friction there."""
        if self.most < 0.0:
            return np.zeros(0), np.zeros(0)
        power = np.linspace(0.0, self.most, _POINTS)
        values = self.friction_at(power)
        for _ in range(_CLOSER):
            more = _between(power, values - power)
            if not len(more):
                break
            power = np.concatenate([power, more])
            values = np.concatenate([values, self.friction_at(more)])
            order = np.argsort(power)
            power, values = power[order], values[order]
        return power, values

    def roots(self, power: FloatArray, values: FloatArray) -> tuple[tuple[HeatRoot, ...], bool]:
        """All roots, and whether one of them could not be found as it should."""
        h = values - power
        found = [float(power[i]) for i in np.flatnonzero(h == 0.0)]
        crossed = np.flatnonzero(h[:-1] * h[1:] < 0.0)
        doubtful = False
        if len(crossed):
            lower, upper = power[crossed], power[crossed + 1]
            sign = np.where(h[crossed] > 0.0, 1.0, -1.0)  # of roots that end in the stable state
            step = 1e-4 * (upper - lower)

            def excess(x: FloatArray) -> tuple[FloatArray, FloatArray]:
                beside = np.where(x + step <= upper, x + step, x - step)
                own, next_to = np.split(self.friction_at(np.concatenate([x, beside])), 2)
                slope = 1.0 - (next_to - own) / (beside - x)
                return sign * (x - own), sign * slope

            start = lower + (upper - lower) * h[crossed] / (h[crossed] - h[crossed + 1])
            x, _ = increasing_root(excess, start, lower, upper, tolerance=_TOLERANCE)
            x = np.where(np.isfinite(x), x, 0.5 * (lower + upper))
            off = np.abs(self.friction_at(x) - x)
            good = off <= _DOUBT * np.maximum(x, step)
            doubtful = not bool(good.all())
            found += x[good].tolist()
        return tuple(self._root(at) for at in sorted(found)), doubtful

    def _root(self, power: float) -> HeatRoot:
        step = _SLOPE * self.most
        ends = np.array([max(power - step, 0.0), min(power + step, self.most)])
        values = self.friction_at(ends)
        temperatures = self.network.temperatures(power)
        return HeatRoot(
            power,
            dict(zip(NODES, temperatures.tolist(), strict=True)),
            float((values[1] - values[0]) / (ends[1] - ends[0])),
        )

    def runaway(self) -> tuple[float, bool]:
        """The multiple of the speeds up to which there is a state, and whether two merge there."""
        if self.most < 0.0:
            return nan, False
        low, high, merges = 0.0, 1.0, False
        for _ in range(_ROUNDS):
            factors = np.linspace(low, high, _BETWEEN + 2)[1:-1]
            least, at_end = self._least_excess(factors)
            without = np.flatnonzero(~(least <= 0.0))
            first = int(without[0]) if len(without) else len(factors)
            if first < len(factors):
                high, merges = float(factors[first]), not at_end[first]
            if first > 0:
                low = float(factors[first - 1])
        return low, merges

    def _least_excess(self, factors: FloatArray) -> tuple[FloatArray, BoolArray]:
        """Least h of each multiple of the speeds, and whether it lies at the temperature limit."""
        duty = self.case.duty
        speeds = {
            name: factors * speed
            for name, speed in zip(_SPEEDS, (duty.inner_speed, duty.outer_speed), strict=True)
        }
        cold = solve(self.cold_case, speeds, threads=self.threads)
        known = cold.converged
        nets = [
            network_of(self.case, cold, index) if known[index] else self.network
            for index in range(len(factors))
        ]
        most = np.array([net.most_power(self.heat.limit) for net in nets])

        def excess(power: FloatArray) -> FloatArray:
            at = [net.temperatures(own) for net, own in zip(nets, power, strict=True)]
            points = power.shape[1]
            found = self.friction_over(np.concatenate(at, axis=1), np.repeat(factors, points))
            h = found.reshape(power.shape) - power
            return np.where(np.isfinite(h) & known[:, np.newaxis], h, inf)

        power = np.linspace(0.0, most, _POINTS, axis=1)
        h = excess(power)
        place = np.argmin(h, axis=1)
        each = np.arange(len(factors))
        before, after = np.maximum(place - 1, 0), np.minimum(place + 1, _POINTS - 1)
        closer = np.linspace(power[each, before], power[each, after], 2 * _BETWEEN + 1, axis=1)
        least = np.minimum(h.min(axis=1), excess(closer).min(axis=1))
        return least, place == _POINTS - 1

    # --- what to know -----------------------------------------------------------------------------

    def _notes(self) -> list[Note]:
        notes = []
        if self.network.estimated:
            notes.append(Note("conductances_estimated", {"names": list(self.network.estimated)}))
        if self.case.mounting is None:
            notes.append(Note("heat_without_mounting"))
        if self.gives_lubricant and has_oil(self.case):
            warm = self.case.lubricant_temperature
            notes.append(Note("lubricant_keeps_temperature", {"temperature": warm}))
        own = self.case.temperature
        names = (*_COLD, "inner_spacer", "outer_spacer")
        given = [name for name in names if getattr(own, name, None) is not None]
        if given:
            notes.append(Note("temperatures_of_balance", {"names": given}))
        return notes

    def _notes_of(self, state: HeatState) -> list[Note]:
        """What the analysis of a state says, without what a quick one leaves out."""
        found = state.analysis
        notes = [*found.solved.notes[0], *found.notes]
        if found.friction is not None and self.by == "contacts":
            notes += found.friction.qualifications(found.solved)
        elif found.friction is not None:
            of_model = (one for one in found.friction.validity if one.model == self.by)
            notes += (note for one in of_model for note in one.notes_of(0))
        return [note for note in notes if note.key not in _LEFT_OUT]

    def _runaway_note(
        self, power: FloatArray, values: FloatArray, runaway: float, merges: bool
    ) -> Note:
        limit = self.heat.limit
        if self.most < 0.0:
            return Note("heated_past_limit", {"limit": limit})
        duty = self.case.duty
        speed = max(duty.inner_speed, duty.outer_speed, key=abs)
        lost = power[~np.isfinite(values)]
        warm = None
        if len(lost):
            warm = float(self.network.temperatures(lost.min()).max())
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


def _between(power: FloatArray, h: FloatArray) -> FloatArray:
    """Powers to look at where h comes close to zero between points and may touch it."""
    more: list[float] = []
    for i in range(1, len(power) - 1):
        before, here, after = h[i - 1 : i + 2]
        if not (np.isfinite([before, here, after]).all() and before * here > 0.0 < here * after):
            continue
        if abs(here) > min(abs(before), abs(after)):
            continue
        curve = np.polyfit(power[i - 1 : i + 2] - power[i], [before, here, after], 2)
        vertex = here - curve[1] ** 2 / (4.0 * curve[0]) if curve[0] else here
        if vertex / here > 0.5:  # far from zero
            continue
        for end in (power[i - 1], power[i + 1]):
            more += [power[i] + part * (end - power[i]) for part in (0.25, 0.5, 0.75)]
    return np.array(more)


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
