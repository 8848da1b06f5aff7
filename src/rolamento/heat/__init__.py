"""The heat of a bearing: where it goes, how warm everything gets, what becomes of the preload."""

from rolamento.heat.balance import (
    HeatBalance,
    HeatCurve,
    HeatRoot,
    HeatState,
    heat_balance,
    heat_balances,
)
from rolamento.heat.network import (
    CAPACITIES,
    CONDUCTANCES,
    NODES,
    OIL_CAPACITY,
    HeatFlow,
    Network,
    network_of,
)
from rolamento.heat.transient import HeatTransient, heat_transient

__all__ = [
    "CAPACITIES",
    "CONDUCTANCES",
    "NODES",
    "OIL_CAPACITY",
    "HeatBalance",
    "HeatCurve",
    "HeatFlow",
    "HeatRoot",
    "HeatState",
    "HeatTransient",
    "Network",
    "heat_balance",
    "heat_balances",
    "heat_transient",
    "network_of",
]
