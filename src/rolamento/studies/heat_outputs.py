"""Outputs of the heat balance: temperatures, power and preload of each case as warm as it runs.

Of cases with a [heat] table; what the study varies is that of the balances too.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Final

import numpy as np

from rolamento.studies.outputs import Evaluation, Floats, Output
from rolamento.words import marked, said

if TYPE_CHECKING:
    from rolamento.heat import HeatBalance
    from rolamento.solved import Solved

_NEEDS: Final = ("lubricant", "heat")
_NODES: Final = {
    "inner_ring": marked("temperature of the inner ring (heat balance)"),
    "elements": marked("temperature of the rolling elements (heat balance)"),
    "outer_ring": marked("temperature of the outer ring (heat balance)"),
    "shaft": marked("temperature of the shaft (heat balance)"),
    "housing": marked("temperature of the housing (heat balance)"),
}


def heat_outputs() -> tuple[Output, ...]:
    """Return the outputs of the heat balance."""
    return tuple(
        Output(f"warm_{name}", unit, partial(said, called), _of(value), needs=needs, slow=True)
        for name, unit, called, value, needs in (
            *((node, "K", called, _temperature(node), _NEEDS) for node, called in _NODES.items()),
            (
                "power",
                "W",
                marked("power loss (heat balance)"),
                lambda one: one.power,
                _NEEDS,
            ),
            (
                "preload",
                "N",
                marked("axial preload (heat balance)"),
                _preload,
                (*_NEEDS, "bearing.preload"),
            ),
            (
                "max_pressure",
                "Pa",
                marked("maximum contact pressure (heat balance)"),
                _pressure,
                _NEEDS,
            ),
            (
                "slope",
                "1",
                marked("slope of the friction over the heat (heat balance)"),
                _slope,
                _NEEDS,
            ),
        )
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
