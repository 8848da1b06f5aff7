"""What is said of electricity in a bearing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rolamento.words.speaking import marked

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["BREAKDOWNS", "DENSITIES", "SENTENCES"]

DENSITIES: Final = {
    "cracks": marked("white etching cracks possible"),
    "harmless": marked("no influence on the life reported"),
    "between": marked("depends on bearing, grease and time"),
    "fluting": marked("shorter life and fluting reported from here on"),
}
"""Names of the bands of current density in data/electrical.toml."""
BREAKDOWNS: Final = {
    "oil": marked("mineral oil"),
    "pfpe": marked("perfluoropolyether"),
}
"""Names of the breakdown fields there."""

SENTENCES: Final[dict[str, Sentence]] = {
    "ceramic_insulates": marked(
        "The rolling elements are of a ceramic: no current flows through them. The numbers of the"
        " films are those of the same bearing with steel elements."
    ),
    "asperities_conduct": marked(
        "The film parameter is {film_parameter:.3}: asperities touch and the bearing conducts at"
        " times; capacitance and field hold while it does not."
    ),
    "conduction_unknown": marked(
        "Without [surface] it is not known whether asperities touch: then the bearing conducts, and"
        " capacitance and field do not hold."
    ),
    "no_film_conducts": marked(
        "Nothing turns, or too slowly for a film: the contacts conduct, and the bearing is no"
        " capacitor."
    ),
    "permittivity_assumed": marked(
        "The relative permittivity is taken as {permittivity:.2}, that of mineral oils:"
        " `electrical.permittivity` gives that of the lubricant."
    ),
    "outside_of_ellipses": marked(
        "The gap around an ellipse is counted by a factor of {factor:.2}; published ratios go from"
        " 1.5 to 4: the capacitance is right to a factor of about two."
    ),
}
"""By key."""
