"""How warm a bearing gets in time: start-up and duty steps, and when its preload is greatest.

The nodes of `rolamento.heat.network` store heat, C (J/K) each:

    C dT/dt = b + P(T) s - A T.

The inner ring is warm before the housing is, so that a rigid preload may pass a maximum that the
steady state knows nothing of. Friction P at the temperatures is that of the equilibrium there: a
value costs far more than a step, and its slope in all temperatures hardly more than a value. So the
equations are integrated by an exponential Rosenbrock method of order 3 with an error estimate of
order 2: with J the slopes of dT/dt at the beginning of a step of length h and f its value there,

    U = T + h φ1(h J) f,    T' = U + 2 h φ3(h J) D,    D = s [P(U) - P - dP/dT (U - T)]/C.

What is linear is exact whatever the step, however stiff; only the curvature of P is approximated.

Source: Hochbruck, Ostermann, Schweitzer, Exponential Rosenbrock-type methods, SIAM J. Numer. Anal.
47 (2009), 786-803 (exprb32).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite, nan
from typing import Any, Final

import numpy as np

from rolamento.case import Case, case_of
from rolamento.case.heat import Heat, HeatStep
from rolamento.errors import InputError
from rolamento.heat.balance import RUNAWAY, CaseLike
from rolamento.heat.network import NODES, Network, capacities_of, network_of
from rolamento.heat.warmed import Warmed
from rolamento.io.json import dumps, plain
from rolamento.numerics import FloatArray
from rolamento.numerics.exponential import exponential
from rolamento.records import frozen
from rolamento.words import Note, said

__all__ = ["HeatTransient", "heat_transient", "until_steady"]

TOLERANCE: Final = 0.1
"""Estimated error of a step, K; that of the temperatures is a tenth of it or less."""
_NUDGE: Final = 0.05
"""K by which each temperature is changed to find the slopes of the friction."""
_FIRST: Final = 1.0
"""s of the first step."""
_SHORTEST: Final = 1e-3
"""s of the shortest step."""
_MOST_STEPS: Final = 2000
_WITHIN: Final = 8
"""Points shown of a step."""
_CLOSER: Final = 9
"""Points looked at around the largest preload."""


@frozen(eq=False)
class HeatTransient:
    """Temperatures, friction and preload of a bearing in time; arrays over points of time.

    Attributes
    ----------
    case
        as it was given
    status
        "converged"; "thermal_runaway" where a part passes the temperature limit, and the points end
        there; that of the equilibrium where the bearing has none
    steps
        of the duty, one after another
    network
        of conductances
    capacities
        of the nodes, (5,), J/K
    time
        (points,), s
    temperatures
        of the nodes, (5, points), K
    power
        friction, (points,), W
    speed
        multiple of the case's speeds, (points,)
    preload
        force between rows that face each other, without external load, (points,), N; NaN of a
        bearing without such rows
    max_pressure
        the largest of all contacts, (points,), Pa
    notes
        what to know about it
    """

    case: Case
    status: str
    steps: tuple[HeatStep, ...]
    network: Network
    capacities: FloatArray
    time: FloatArray
    temperatures: FloatArray
    power: FloatArray
    speed: FloatArray
    preload: FloatArray
    max_pressure: FloatArray
    notes: tuple[Note, ...]

    def __len__(self) -> int:
        """Count the points of time."""
        return len(self.time)

    @property
    def converged(self) -> bool:
        """Whether all steps were run."""
        return self.status == "converged"

    @property
    def has_preload(self) -> bool:
        """Whether the bearing is a set with a preload."""
        return bool(np.isfinite(self.preload).any())

    @property
    def worst(self) -> int:
        """The point of the largest preload, or of the largest pressure where there is none."""
        sizes = self.preload if self.has_preload else self.max_pressure
        return int(np.nanargmax(sizes)) if np.isfinite(sizes).any() else 0

    @property
    def largest_preload(self) -> tuple[float, float]:
        """The largest preload (N) and when (s); NaN without one."""
        if not self.has_preload:
            return nan, nan
        return float(self.preload[self.worst]), float(self.time[self.worst])

    @property
    def final(self) -> dict[str, float]:
        """Temperatures at the end, by node, K."""
        return dict(zip(NODES, self.temperatures[:, -1].tolist(), strict=True))

    def to_mapping(self) -> dict[str, Any]:
        """Give everything as plain mappings and lists, SI."""
        preload, when = self.largest_preload
        mapping: dict[str, Any] = plain(
            {
                "title": self.case.title,
                "status": self.status,
                "time": self.time,
                "temperatures": dict(zip(NODES, self.temperatures, strict=True)),
                "power": self.power,
                "speed_factor": self.speed,
                "preload": self.preload,
                "max_pressure": self.max_pressure,
                "largest_preload": {"value": preload, "time": when},
                "capacities": dict(zip(NODES, self.capacities, strict=True)),
            }
        )
        return {
            **mapping,
            "steps": [step.to_mapping() for step in self.steps],
            "notes": [note.to_mapping() for note in self.notes],
            "case": self.case.to_mapping(),
        }

    def to_json(self, *, indent: int | None = 2) -> str:
        """Give it as one JSON object, in SI units."""
        return dumps(self.to_mapping(), indent)


def heat_transient(
    case: CaseLike,
    duration: float | None = None,
    *,
    steps: Sequence[HeatStep] | None = None,
    start: Mapping[str, float] | None = None,
    threads: int | None = None,
) -> HeatTransient:
    """Find how temperatures, friction and preload of a bearing change in time.

    Parameters
    ----------
    case
        As of `rolamento.heat.heat_balance`; capacities that its [heat] does not give are estimated.
    duration
        At the speed and the load of the case, in s; or:
    steps
        Of speeds and loads one after another; those of `case.heat` if neither is given.
    start
        Temperatures of nodes by name, K; those of the surroundings if not given.
    threads
        As many as there are processors by default.

    Returns
    -------
    HeatTransient
        Never raises for a duty without a solution: the status says so.

    Raises
    ------
    InputError
        As `heat_balance`; or if there is no duration and no steps, or both.

    Hochbruck, Ostermann and Schweitzer (2009): the method; docs/theory/heat.md.

    >>> from rolamento import load_case
    >>> duty = {"duty.load.fz": "10 kN", "duty.inner_speed": "3000 rpm"}
    >>> case = load_case("6220", duty | {"lubricant": "ISO VG 68"})
    >>> course = heat_transient(case, 3600.0)
    >>> print(f"inner ring {course.final['inner_ring'] - 273.15:.0f} °C after an hour")
    inner ring 56 °C after an hour
    """
    case = case_of(case)
    heat = case.heat or Heat()
    if duration is not None and steps is not None:
        raise InputError(said("cannot be combined with {before}", before="steps"), field="duration")
    if duration is not None:
        steps = (HeatStep(duration=duration),)
    steps = heat.steps if steps is None else tuple(steps)
    if not steps:
        raise InputError(said("is missing; or steps in [heat]"), field="duration", example="3600.0")
    return _Course(case, steps, threads).run(start or {})


def until_steady(case: CaseLike) -> float:
    """Return five times the longest time constant of a bearing's network, s.

    What differs from the steady state has then fallen to 1 %, but for what the friction changes.

    Parameters
    ----------
    case
        As of `heat_transient`.

    Raises
    ------
    InputError
        As `heat_transient`.
    """
    course = _Course(case_of(case), (), None)
    rates = np.linalg.eigvals(course.conductances / course.capacities[:, np.newaxis]).real
    if not (np.isfinite(rates).all() and rates.min() > 0.0):
        raise InputError(said("leaves no way for the heat to go"), field="heat")
    return float(5.0 / rates.min())


@dataclass(frozen=True, slots=True)
class _Piece:
    """A step of the integration: where it begins, and what temperatures do in it.

    whole: the equations, as `_equations`; off: what the friction at its end is beyond the line, W;
    shown: temperatures at `_WITHIN` equal parts of it, (5, parts), K.
    """

    begin: float
    length: float
    step: int
    first: FloatArray
    whole: FloatArray
    off: float
    shown: FloatArray

    def at(self, time: float) -> FloatArray:
        """Temperatures at a time in it; (5,), K."""
        own = exponential(self.whole * (time - self.begin))
        return self.first + own[:5, 5] + self.off / self.length**2 * own[:5, 8]


def _equations(jacobian: FloatArray, flow: FloatArray, curving: FloatArray) -> FloatArray:
    """The matrix M of z' = M z, z = (y, 1, t², t, 1), for y' = J y + f + r t².

    exp(M t) has what f alone makes of y = 0 in column 5, and what r alone does in column 8.
    """
    whole = np.zeros((9, 9))
    whole[:5, :5], whole[:5, 5], whole[:5, 6] = jacobian, flow, curving
    whole[6, 7], whole[7, 8] = 2.0, 1.0
    return whole


class _Course:
    """Temperatures in the making."""

    def __init__(self, case: Case, steps: tuple[HeatStep, ...], threads: int | None) -> None:
        self.case, self.steps = case, steps
        self.warmed = Warmed(case, threads=threads)
        ambient = np.full(len(NODES), self.warmed.heat.ambient)
        self.cold = self.warmed.solved(ambient[:, np.newaxis])
        self.network = network_of(case, self.cold)
        self.capacities, self.estimated = capacities_of(case)
        self.conductances, self.source, self.share = self.network.equations()

    def run(self, start: Mapping[str, float]) -> HeatTransient:
        limit = self.warmed.heat.limit
        at = np.array([start.get(node, self.network.ambient) for node in NODES], np.float64)
        pieces: list[_Piece] = []
        status, time = "converged", 0.0
        if not self.cold.converged[0]:
            status = str(self.cold.status.code[0])
        for index in range(len(self.steps)):
            if status != "converged":
                break
            status, time, at = self._step(index, time, at, limit, pieces)
        return self._record(status, pieces, at, limit)

    def _step(
        self, index: int, time: float, at: FloatArray, limit: float, pieces: list[_Piece]
    ) -> tuple[str, float, FloatArray]:
        """Run one step of the duty; its status, and time and temperatures where it ends."""
        step = self.steps[index]
        end, length = time + step.duration, min(_FIRST, step.duration)
        known: tuple[float, FloatArray] | None = None
        for _ in range(_MOST_STEPS):
            if end - time <= 1e-9 * end:
                return "converged", time, at
            length = min(length, end - time)
            power, slopes = known = self._friction(at, step) if known is None else known
            if not isfinite(power):
                return "no_equilibrium", time, at
            jacobian = (np.outer(self.share, slopes) - self.conductances) / self.capacities[:, None]
            above = at - self.network.ambient
            flow = (self.source + power * self.share - self.conductances @ above) / self.capacities
            whole = _equations(jacobian, flow, self.share / self.capacities)
            part = exponential(whole * (length / _WITHIN))
            grown = [part]
            for _ in range(_WITHIN - 1):
                grown.append(grown[-1] @ part)
            by_line = np.array([one[:5, 5] for one in grown]).T
            by_bend = np.array([one[:5, 8] for one in grown]).T
            moved = by_line[:, -1]
            there, ahead = self._friction(at + moved, step)
            off = there - power - float(slopes @ moved)
            if not isfinite(there):
                if length < _SHORTEST:
                    return "no_equilibrium", time, at
                length *= 0.2
                continue
            bent = off / length**2 * by_bend
            error = float(np.abs(bent[:, -1]).max())
            if error > TOLERANCE and length > _SHORTEST:
                length *= max(0.2, 0.9 * (TOLERANCE / error) ** (1.0 / 3.0))
                continue
            shown = at[:, np.newaxis] + by_line + bent
            pieces.append(_Piece(time, length, index, at, whole, off, shown))
            after = shown[:, -1]
            known = there + float(ahead @ bent[:, -1]), ahead  # within the tolerance
            if after.max() > limit:
                return RUNAWAY, time + length, after
            time, at = time + length, after
            length *= min(5.0, 0.9 * (TOLERANCE / max(error, 1e-12)) ** (1.0 / 3.0))
        return "not_converged", time, at

    def _power(self, temperatures: FloatArray, step: HeatStep) -> FloatArray:
        return self.warmed.power(temperatures, speed=step.speed_factor, load=step.load_factor)

    def _friction(self, at: FloatArray, step: HeatStep) -> tuple[float, FloatArray]:
        """Friction at temperatures, W, and its slopes in them, W/K."""
        beside = at[:, np.newaxis] + _NUDGE * np.hstack([np.zeros((5, 1)), np.eye(5)])
        found = self._power(beside, step)
        slopes = (found[1:] - found[0]) / _NUDGE
        return float(found[0]), np.where(np.isfinite(slopes), slopes, 0.0)

    def _record(
        self, status: str, pieces: list[_Piece], last: FloatArray, limit: float
    ) -> HeatTransient:
        notes = list(self._notes())
        parts = [np.linspace(0.0, 1.0, _WITHIN + 1)[1:] * one.length + one.begin for one in pieces]
        time = np.concatenate([np.zeros(1), *parts])
        step = np.concatenate([[0], *(np.full(_WITHIN, one.step) for one in pieces)]).astype(int)
        first = pieces[0].first if pieces else last
        at = np.hstack([first[:, np.newaxis], *(one.shown for one in pieces)])
        if status == RUNAWAY:
            kept = np.flatnonzero(at.max(axis=0) <= limit)
            time, step, at = time[kept], step[kept], at[:, kept]
            notes.insert(0, Note("limit_passed_at", {"limit": limit, "time": float(time[-1])}))
        power, preload, pressure = self._looked_at(at, step)
        if np.isfinite(preload).any():
            more = self._around(pieces, time, int(np.nanargmax(preload)), at.max() <= limit)
            if more is not None:
                own_time, own_step, own_at = more
                found = self._looked_at(own_at, own_step)
                order = np.argsort(np.concatenate([time, own_time]), kind="stable")
                time, step, power, preload, pressure = (
                    np.concatenate(pair)[order]
                    for pair in (
                        (time, own_time), (step, own_step), (power, found[0]),
                        (preload, found[1]), (pressure, found[2]),
                    )
                )  # fmt: skip
                at = np.hstack([at, own_at])[:, order]
        speed = np.array([one.speed_factor for one in self.steps])[step]
        return HeatTransient(
            self.case, status, self.steps, self.network, self.capacities, time, at, power, speed,
            preload, pressure, tuple(notes),
        )  # fmt: skip

    def _looked_at(
        self, at: FloatArray, step: FloatArray
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Power, preload and the largest pressure at temperatures (5, n) in steps of the duty."""
        speed = np.array([one.speed_factor for one in self.steps])[step]
        load = np.array([one.load_factor for one in self.steps])[step]
        solved = self.warmed.solved(at, speed=speed, load=load)
        power = self.warmed.torque_and_power(solved, *self.warmed.friction_of(solved))[1]
        both = [contacts.max_pressure for contacts in (solved.inner, solved.outer)]
        found = np.concatenate(both, axis=1)
        pressure = np.fmax.reduce(found, axis=1)
        return power, self.warmed.preload(solved), np.where(solved.converged, pressure, np.nan)

    def _around(
        self, pieces: list[_Piece], time: FloatArray, worst: int, within: bool
    ) -> tuple[FloatArray, FloatArray, FloatArray] | None:
        """Points of time between the neighbours of the worst, their steps and temperatures."""
        if worst in (0, len(time) - 1) or not within:
            return None
        own = np.linspace(time[worst - 1], time[worst + 1], _CLOSER + 2)[1:-1]
        own = own[own != time[worst]]
        ends = np.array([one.begin + one.length for one in pieces])
        place = np.minimum(np.searchsorted(ends, own), len(pieces) - 1)
        at = np.array([pieces[k].at(one) for k, one in zip(place.tolist(), own, strict=True)]).T
        return own, np.array([pieces[k].step for k in place.tolist()]), at

    def _notes(self) -> list[Note]:
        notes = []
        if self.network.estimated:
            notes.append(Note("conductances_estimated", {"names": list(self.network.estimated)}))
        if self.estimated:
            notes.append(Note("capacities_estimated", {"names": list(self.estimated)}))
        if self.case.mounting is None:
            notes.append(Note("heat_without_mounting"))
        return notes
