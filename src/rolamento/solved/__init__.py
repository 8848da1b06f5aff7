"""What solving returns: one result, `Solved`, for one case and for a million.

Arrays over cases, in SI; one case is a batch of one, and `solved[i]` is again a `Solved`. A number
that does not exist is NaN, and null in JSON. The ring's result is at hand at once; the tables of
elements and contacts are made by the rows when they are first asked for, and kept.
"""

from rolamento.solved.result import NO_LOAD, Delivered, Solved, refuse_other
from rolamento.solved.rollers import Line, Rollers
from rolamento.solved.tables import (
    RACES,
    Answer,
    Contacts,
    Elements,
    Index,
    IntArray,
    Preloading,
    PreloadStage,
    Pressed,
    RingDisplacement,
    RingLoad,
    Rolling,
    RollingContacts,
    Rows,
    Status,
    Stiffness,
    Tables,
    taken,
)

__all__ = [
    "NO_LOAD",
    "RACES",
    "Answer",
    "Contacts",
    "Delivered",
    "Elements",
    "Index",
    "IntArray",
    "Line",
    "PreloadStage",
    "Preloading",
    "Pressed",
    "RingDisplacement",
    "RingLoad",
    "Rollers",
    "Rolling",
    "RollingContacts",
    "Rows",
    "Solved",
    "Status",
    "Stiffness",
    "Tables",
    "refuse_other",
    "taken",
]
