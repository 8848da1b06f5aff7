"""Electricity in a bearing: capacitance of its films, current density, field, breakdown."""

from rolamento.electrical.bearing import (
    Band,
    BearingElectrics,
    RaceElectrics,
    electrics_of,
    has_electrics,
)
from rolamento.electrical.contacts import (
    apparent_current_density,
    film_capacitance,
    in_series,
    share_of_voltage,
)

__all__ = [
    "Band",
    "BearingElectrics",
    "RaceElectrics",
    "apparent_current_density",
    "electrics_of",
    "film_capacitance",
    "has_electrics",
    "in_series",
    "share_of_voltage",
]
