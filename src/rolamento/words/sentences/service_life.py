"""What is said of what ends a bearing: names of the endings, and what their hours are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rolamento.words.speaking import marked

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["BASES", "ENDING_NAMES", "SENTENCES"]

ENDING_NAMES: Final = {
    "fatigue": marked("fatigue"),
    "oscillation": marked("fatigue in oscillation"),
    "fretting": marked("fretting, false brinelling"),
    "grease": marked("grease"),
    "relubrication": marked("relubrication is due"),
    "wear": marked("wear in boundary lubrication"),
    "currents": marked("electrical erosion"),
    "overload": marked("overload"),
}
"""Names of `rolamento.tasks.endings.Ending.name`."""
BASES: Final = {
    "l10h": marked("L_10h, without oil and contamination"),
    "l10mh": marked("L_10mh, with oil and contamination"),
    "grease_l10": marked("L_10 of the grease, by all laws"),
    "interval": marked("interval by SKF, spread of all factors"),
    "untimed": marked("no law says when"),
    "static": marked("static safety by stress"),
    "below_bands": marked("current density below the published bands"),
}
"""What the hours of an ending are, by `Ending.basis`."""

SENTENCES: Final[dict[str, Sentence]] = {
    "fatigue_without_rating": marked("The fatigue life is not known: the bearing has no rating."),
    "fatigue_without_speed": marked("Nothing turns: fatigue has no hours."),
    "permanent_deformation": marked(
        "The static safety by stress is {safety:.2f}: races and rolling elements are permanently"
        " deformed by more than a ten-thousandth of the element's diameter."
    ),
    "wear_at_boundary": marked(
        "The viscosity ratio is {ratio:.2g}: below 0.1 the surfaces touch, and they wear."
    ),
    "grease_without_life": marked(
        "No law of the life of a grease is valid here: `rolamento grease` says why."
    ),
}
"""By key."""
