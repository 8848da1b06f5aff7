"""What is said of a ring that oscillates."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rolamento.words.speaking import marked

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["SENTENCES"]

SENTENCES: Final[dict[str, Sentence]] = {
    "duty_oscillates": marked(
        "The duty oscillates, and this life is of continuous rotation: `rolamento oscillation`"
        " gives the life in oscillations."
    ),
    "oscillation_frets": marked(
        "The bearing swings by {angle:.3 °}, less than half of the critical {critical:.3 °}: no"
        " fresh lubricant reaches the contacts, and fretting or false brinelling ends it, not"
        " fatigue. Turn it by more than {critical:.3 °} from time to time."
    ),
    "oscillation_under_critical": marked(
        "The bearing swings by {angle:.3 °}, less than the critical {critical:.3 °}: the arcs of"
        " neighbouring elements do not meet, and fretting is possible."
    ),
    "oscillation_unloaded": marked("No rolling element carries load: nothing fatigues."),
    "oscillation_without_lubrication": marked(
        "Lubrication and contamination are not included: the film breaks down at each reversal,"
        " and κ is of a steady speed."
    ),
    "oscillation_without_frequency": marked(
        "Without `duty.oscillation.frequency` the life has no hours."
    ),
    "oscillation_as_own_loads": marked(
        "The load distribution is taken at the rolling elements alone: between them it is not"
        " known."
    ),
}
"""By key."""
