"""Rating and fatigue life: one file a theory, one record for all of them.

Pure functions of arrays first; `life` gathers all theories for solved cases,
`sensitivity` finds what would help.
"""

from rolamento.life.conditions import LifeConditions, conditions_of, with_lubricant
from rolamento.life.headline import Headline
from rolamento.life.record import Life
from rolamento.life.sensitivity import Change, holding_load, sensitivity
from rolamento.life.summary import LifeSummary, Limit, life
from rolamento.life.theories import THEORIES

__all__ = [
    "THEORIES",
    "Change",
    "Headline",
    "Life",
    "LifeConditions",
    "LifeSummary",
    "Limit",
    "conditions_of",
    "holding_load",
    "life",
    "sensitivity",
    "with_lubricant",
]
