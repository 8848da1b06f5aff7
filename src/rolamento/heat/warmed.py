"""A bearing at the temperatures of its nodes: its equilibrium, its friction, its preload.

Geometry, film and friction are those of `rolamento.solve` for the case with these temperatures; the
lubricant has the mean of the rings unless the case gives its own. Many temperatures, speeds and
cases are solved at once.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from rolamento.analysis.needs import has_friction, has_oil, machines_known
from rolamento.case import Case
from rolamento.case.duty import LOADS
from rolamento.case.heat import Heat
from rolamento.errors import InputError
from rolamento.friction import MachineBearing, friction
from rolamento.friction.seals import seals_and_bath
from rolamento.friction.summary import Friction, default_model, no_coefficient
from rolamento.heat.network import NODES
from rolamento.lubrication.films import Film, film, has_film
from rolamento.numerics import FloatArray, IntArray
from rolamento.solution import solve
from rolamento.solved import Solved
from rolamento.system.preload import preload_at
from rolamento.words import said

__all__ = ["SPEEDS", "Warmed", "temperature_fields"]

SPEEDS: Final = ("duty.inner_speed", "duty.outer_speed")
_OUTSIDE: Final = tuple(f"duty.load.{name}" for name in LOADS)


def temperature_fields(case: Case, temperatures: FloatArray) -> dict[str, FloatArray]:
    """Return the temperatures of nodes (5, …) as fields of a case, by dotted name; K."""
    inner, balls, outer, shaft, housing = temperatures
    found = {"inner_ring": inner, "outer_ring": outer, "balls": balls}
    if case.mounting is not None:
        found |= {"shaft": shaft, "housing": housing}
    if has_oil(case) and case.lubricant_temperature is None:
        found["lubricant"] = 0.5 * (inner + outer)
    return {f"temperature.{name}": value for name, value in found.items()}


class Warmed:
    """Cases that differ in some fields, at any temperatures of their nodes.

    Parameters
    ----------
    case
        What they have in common.
    values
        What differs, by the dotted names of fields that many cases may differ in; (cases,) each.
    threads
        As many as there are processors by default.

    Raises
    ------
    InputError
        If the friction that the case asks for is not known.
    """

    def __init__(
        self,
        case: Case,
        values: Mapping[str, FloatArray] | None = None,
        threads: int | None = None,
    ) -> None:
        self.case, self.threads = case, threads
        self.values = dict(values or {})
        self.heat = case.heat or Heat()
        self.by = self.heat.friction
        varies = "temperature.lubricant" in self.values
        self.gives_lubricant = case.lubricant_temperature is not None or varies
        if self.by != "contacts" and not has_oil(case):
            raise no_coefficient(case)
        self.cold_case = self.case_at(np.full(len(NODES), self.heat.ambient))

    def fields_at(self, temperatures: FloatArray) -> dict[str, FloatArray]:
        """The temperatures of nodes (5, …) as fields of the case, but for those that vary."""
        fields = temperature_fields(self.case, temperatures)
        if self.gives_lubricant:
            fields.pop("temperature.lubricant", None)
        return fields

    def case_at(self, temperatures: FloatArray) -> Case:
        """The common case at the temperatures of nodes (5,); spacers follow shaft and housing."""
        own = self.case.temperature
        spacers = {
            f"temperature.{name}": None
            for name in ("inner_spacer", "outer_spacer")
            if getattr(own, name, None) is not None
        }
        values = {name: float(value) for name, value in self.fields_at(temperatures).items()}
        return self.case.with_({**spacers, **values})

    def solved(
        self,
        temperatures: FloatArray,
        which: IntArray | None = None,
        *,
        speed: ArrayLike = 1.0,
        load: ArrayLike = 1.0,
    ) -> Solved:
        """Solve the cases at temperatures.

        Parameters
        ----------
        temperatures
            Of the nodes, (5, n), K.
        which
            Of the cases, (n,); the first if not given.
        speed, load
            Multiples of the speeds and the loads of the cases; numbers or (n,).
        """
        count = temperatures.shape[1]
        which = np.zeros(count, np.int64) if which is None else which
        fields = self.fields_at(temperatures)
        if self.case.mounting is None:  # those of the rings act through it
            fields = {name: one for name, one in fields.items() if name.endswith("lubricant")}
        own: dict[str, FloatArray] = {name: a[which] for name, a in self.values.items()}
        duty = self.case.duty
        for name in SPEEDS:
            fixed = getattr(duty, name.partition(".")[2])
            own[name] = np.multiply(speed, own.get(name, np.full(count, fixed)))
        if np.any(np.asarray(load) != 1.0):
            for name in _OUTSIDE:
                fixed = getattr(duty.load, name.rpartition(".")[2])
                if name in own or fixed is not None:
                    own[name] = np.multiply(load, own.get(name, np.full(count, fixed or 0.0)))
        return solve(self.cold_case, {**own, **fields}, threads=self.threads)

    def friction_of(self, solved: Solved) -> tuple[Film | None, Friction]:
        """Film and friction of solved cases, by the model that the case asks for.

        Raises
        ------
        InputError
            If that is not known.
        """
        if not has_friction(solved):
            raise no_coefficient(self.case)
        oil = film(solved) if has_film(solved) else None
        machine: tuple[MachineBearing, ...] = ()
        model = default_model(solved)
        if self.by != "contacts":
            model, machine = default_model(solved, quick=True), machines_known(solved, oil)
        found = friction(
            solved,
            model=model,
            film_parameter=np.nan if oil is None else oil.minimum_film_parameter,
            machine=machine,
            compare=False,
            threads=self.threads,
        )
        return oil, found

    def torque_and_power(
        self, solved: Solved, oil: Film | None, found: Friction
    ) -> tuple[FloatArray, FloatArray]:
        """Torque (N·m) and power (W) of solved cases, of seals and an oil bath as well.

        NaN without an equilibrium.

        Raises
        ------
        InputError
            If the model that is asked for has no constants of the bearing.
        """
        torque, power = found.torque, found.power
        if self.by != "contacts":
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

    def power(
        self,
        temperatures: FloatArray,
        which: IntArray | None = None,
        *,
        speed: ArrayLike = 1.0,
        load: ArrayLike = 1.0,
    ) -> FloatArray:
        """Friction at temperatures, (n,), W; NaN without an equilibrium. Parameters: `solved`."""
        solved = self.solved(temperatures, which, speed=speed, load=load)
        return self.torque_and_power(solved, *self.friction_of(solved))[1]

    @property
    def has_preload(self) -> bool:
        """Whether rows of the bearing face each other, and are pressed together."""
        bearing = self.case.bearing
        facing = len({place.sign for place in bearing.places if place.bearing.locates}) > 1
        return facing and (bearing.preload is not None or self.case.mounting is not None)

    def preload(self, solved: Solved) -> FloatArray:
        """Force between rows that face each other, without external load; (n,), N, NaN without."""
        if not self.has_preload:
            return np.full(len(solved), np.nan)
        return preload_at(solved, running=True)
