"""The heat balance over one field of a case: temperatures, power and preload at every point."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from rolamento.case import Case
from rolamento.errors import InputError, arguments
from rolamento.heat import NODES, HeatBalance, heat_balances
from rolamento.numerics import BoolArray, FloatArray
from rolamento.records import frozen
from rolamento.studies.fields import Field
from rolamento.studies.ranges import Range, refuse_many_singles
from rolamento.words import said
from rolamento.words.headlines import Qualified, over_cases

__all__ = ["HeatOver", "heat_over"]

SCHEMA: Final = 1
_FOUND: Final = "temperature."
_GIVEN: Final = "temperature.lubricant"


@frozen(eq=False)
class HeatOver:
    """Heat balances of a case over the values of one field.

    Attributes
    ----------
    case
        what does not vary
    field, values
        what varies, (points,), SI
    balances
        one at each point
    """

    case: Case
    field: Field
    values: FloatArray
    balances: tuple[HeatBalance, ...]

    def __len__(self) -> int:
        """Count the points."""
        return len(self.balances)

    @property
    def status(self) -> NDArray[np.str_]:
        """Status of each balance, (points,)."""
        return np.array([one.status for one in self.balances], dtype=np.str_)

    @property
    def converged(self) -> bool:
        """Whether there is a state at every point."""
        return all(one.converged for one in self.balances)

    @property
    def power(self) -> FloatArray:
        """Friction in the warm state, NaN without one; (points,), W."""
        return np.array([one.power for one in self.balances])

    @property
    def temperatures(self) -> FloatArray:
        """Temperatures of the nodes in the warm state, NaN without one; (5, points), K."""
        return np.array([[one.temperatures[node] for one in self.balances] for node in NODES])

    @property
    def cold_preload(self) -> FloatArray:
        """Preload of a set at ambient temperature, NaN without one; (points,), N."""
        return np.array([_number(one.cold.preload) for one in self.balances])

    @property
    def warm_preload(self) -> FloatArray:
        """Preload of a set in the warm state, likewise."""
        return np.array(
            [_number(None if one.warm is None else one.warm.preload) for one in self.balances]
        )

    @property
    def max_pressure(self) -> FloatArray:
        """The largest of all contacts in the warm state, NaN without one; (points,), Pa."""
        return np.array(
            [_number(None if one.warm is None else one.warm.max_pressure) for one in self.balances]
        )

    @property
    def axial_stiffness(self) -> FloatArray:
        """Stiffness along the shaft in the warm state, NaN without one; (points,), N/m."""
        return np.array(
            [np.nan if one.warm is None else one.warm.axial_stiffness for one in self.balances]
        )

    @property
    def contact_angle(self) -> FloatArray:
        """Free contact angle of the first row in the warm state, likewise; (points,), rad."""
        return np.array(
            [np.nan if one.warm is None else one.warm.contact_angle[0] for one in self.balances]
        )

    @property
    def viscosity_ratio(self) -> FloatArray:
        """The ratio κ in the warm state, NaN without one or without an oil; (points,)."""
        return np.array(
            [_number(None if one.warm is None else one.warm.viscosity_ratio)
             for one in self.balances]
        )  # fmt: skip

    @property
    def slope(self) -> FloatArray:
        """Slope d friction/dP in the warm state, NaN without one; (points,)."""
        return np.array(
            [_number(None if one.root is None else one.root.slope) for one in self.balances]
        )

    @property
    def has_preload(self) -> bool:
        """Whether any point is a set with a preload."""
        return bool(np.isfinite(self.cold_preload).any())

    @property
    def cautions(self) -> tuple[Qualified, ...]:
        """What qualifies the numbers, and at which points."""
        return over_cases(one.notes for one in self.balances)

    def failed(self) -> BoolArray:
        """Which points have no state."""
        return np.array([not one.converged for one in self.balances])

    def to_mapping(self) -> dict[str, Any]:
        """Give the points as plain mappings and arrays, SI."""
        return {
            "schema": SCHEMA,
            "kind": "heat_over",
            "title": self.case.title,
            "field": self.field.name,
            "unit": self.field.unit,
            "values": self.values,
            "status": self.status.tolist(),
            "power": self.power,
            "temperatures": dict(zip(NODES, self.temperatures, strict=True)),
            "slope": self.slope,
            "cold_preload": self.cold_preload,
            "warm_preload": self.warm_preload,
            "max_pressure": self.max_pressure,
            "axial_stiffness": self.axial_stiffness,
            "contact_angle": self.contact_angle,
            "viscosity_ratio": self.viscosity_ratio,
        }


def heat_over(case: Case, over: Range) -> HeatOver:
    """Find the heat balance of a case at every point of a range.

    Parameters
    ----------
    case
        As of `heat_balance`.
    over
        From `read_range`.

    Raises
    ------
    InputError
        As `heat_balance`, or if the field is a temperature that the balance finds.
    """
    name = over.field.name
    if name.startswith(_FOUND) and name != _GIVEN:
        raise InputError(
            said("is what the heat balance finds"),
            field="over",
            value=name,
            example=arguments(over="duty.inner_speed=1000..6000rpm"),
        )
    refuse_many_singles(len(over.values))
    balances = heat_balances(case, {name: over.values})
    return HeatOver(case, over.field, over.values, balances)


def _number(value: float | None) -> float:
    return np.nan if value is None else value
