"""Everything that follows from a case: its equilibrium, the lubricant film, friction, life.

`analyse` of a case or of what solving it returned. A part that a case does not ask for is None;
one that it asks for and that cannot be had is None with a note, never an exception.
"""

from rolamento.analysis.analysis import Analysis, analyse, film_and_friction, life_of

__all__ = ["Analysis", "analyse", "film_and_friction", "life_of"]
