"""Outputs of the heat balance: temperatures, power and preload of each case as warm as it runs.

Of cases with a [heat] table; what the study varies is that of the balances too.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.studies.outputs import Evaluation, Floats, Output

if TYPE_CHECKING:
    from rolamento.heat import HeatBalance
    from rolamento.solved import Solved

_NEEDS: Final = ("lubricant", "heat")
_NODES: Final = ("inner_ring", "elements", "outer_ring", "shaft", "housing")


def heat_outputs() -> tuple[Output, ...]:
    """Return the outputs of the heat balance."""
    temperatures = [
        Output(f"warm_{node}", "K", _of(_temperature(node)), needs=_NEEDS, slow=True)
        for node in _NODES
    ]
    return (
        *temperatures,
        Output("warm_power", "W", _of(lambda one: one.power), needs=_NEEDS, slow=True),
        Output("warm_preload", "N", _of(_preload), needs=(*_NEEDS, "bearing.preload"), slow=True),
        Output("warm_max_pressure", "Pa", _of(_pressure), needs=_NEEDS, slow=True),
        Output("warm_slope", "1", _of(_slope), needs=_NEEDS, slow=True),
    )


def _balances(solved: Solved) -> tuple[HeatBalance, ...]:
    """The heat balance of each case, as it was given."""
    from rolamento.heat import heat_balance, heat_balances
    from rolamento.solution import Refused

    given = solved.refusals
    if not isinstance(given, Refused):
        case = solved.case if solved.before_mounting is None else solved.before_mounting.case
        return (heat_balance(case, look_for_speed=False, threads=1),) * len(solved)
    return heat_balances(given.case, given.values, threads=1)


def _of(value: Callable[[HeatBalance], float]) -> Callable[[Evaluation], Floats]:
    def compute(given: Evaluation) -> Floats:
        return np.array([value(one) for one in given.of(_balances)], np.float64)

    return compute


def _temperature(node: str) -> Callable[[HeatBalance], float]:
    return lambda one: one.temperatures[node]


def _preload(one: HeatBalance) -> float:
    preload = None if one.warm is None else one.warm.preload
    return np.nan if preload is None else preload


def _pressure(one: HeatBalance) -> float:
    return np.nan if one.warm is None else one.warm.max_pressure


def _slope(one: HeatBalance) -> float:
    return np.nan if one.root is None else one.root.slope
