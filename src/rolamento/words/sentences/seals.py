"""What is said of seals and of an oil bath."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rolamento.words.speaking import marked

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["SENTENCES"]

SENTENCES: Final[dict[str, Sentence]] = {
    "seal_sizes_unknown": marked(
        "The friction of the seals is not counted: without a designation, or"
        " `losses.seal_diameter`, the size of their counterface is not known."
    ),
    "seal_not_in_table": marked(
        "The friction of the seals is not counted: SKF's table has none of the kind {seal} for"
        " this bearing; `losses.seal_moment` gives it."
    ),
    "seal_diameter_estimated": marked(
        "The counterface of the seals is estimated as {diameter:.3 mm}; `losses.seal_diameter`"
        " gives it. SKF's constants are at second hand."
    ),
    "seal_taken_as": marked(
        "The seals of this maker are taken as SKF's {seal}; `losses.seal_moment` gives their own"
        " friction."
    ),
    "bath_without_oil": marked(
        "The drag of the oil bath is not counted: it needs an oil and its temperature."
    ),
    "bath_without_designation": marked(
        "The drag of the oil bath is not counted: it needs the sizes of a designation."
    ),
    "bath_too_viscous": marked(
        "The oil is above {limit:.3 mm²/s}, up to which SKF's drag of an oil bath is valid at this"
        " level."
    ),
    "bath_by_diagram": marked(
        "The drag of the oil bath rests on V_M read off SKF's diagram, within some tens of percent;"
        " it is for a large reservoir and a horizontal shaft."
    ),
}
"""By key."""
