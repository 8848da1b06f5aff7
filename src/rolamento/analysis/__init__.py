"""Everything that follows from a case: its state, the lubricant film, friction, life.

`analyse` for a case, `analyse_batch` for many solved cases at once. A part that a case does not
ask for is None; one that it asks for and that cannot be had is None with a note, never an
exception.
"""

from rolamento.analysis.batch import analyse_batch, least_film_parameter, remembering
from rolamento.analysis.joining import BatchAnalysis, joined
from rolamento.analysis.one import NOTES, Analysis, analyse, analyse_state

__all__ = [
    "NOTES",
    "Analysis",
    "BatchAnalysis",
    "analyse",
    "analyse_batch",
    "analyse_state",
    "joined",
    "least_film_parameter",
    "remembering",
]
