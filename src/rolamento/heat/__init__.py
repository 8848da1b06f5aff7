"""The heat of a bearing: where it goes, how warm everything gets, what becomes of the preload."""

from rolamento.heat.balance import HeatBalance, HeatCurve, HeatRoot, HeatState, heat_balance
from rolamento.heat.network import (
    CONDUCTANCES,
    NODES,
    OIL_CAPACITY,
    HeatFlow,
    Network,
    network_of,
)

__all__ = [
    "CONDUCTANCES",
    "NODES",
    "OIL_CAPACITY",
    "HeatBalance",
    "HeatCurve",
    "HeatFlow",
    "HeatRoot",
    "HeatState",
    "Network",
    "heat_balance",
    "network_of",
]
