"""What is to be known of the severity of vibration, and what its classes and zones are called."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rolamento.words.speaking import marked, said

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["SENTENCES", "class_name", "zone_meaning"]

_CLASSES: Final = {
    "group 1, rigid": marked("group 1, rigid support"),
    "group 1, flexible": marked("group 1, flexible support"),
    "group 2, rigid": marked("group 2, rigid support"),
    "group 2, flexible": marked("group 2, flexible support"),
    "class I": marked("class I"),
    "class II": marked("class II"),
    "class III": marked("class III"),
    "class IV": marked("class IV"),
}
_ZONES: Final = {
    "A": marked("as of new machines"),
    "B": marked("fit for unrestricted long-term operation"),
    "C": marked("not fit for long-term operation: plan a correction"),
    "D": marked("severe enough to damage the machine"),
}


def class_name(name: str) -> str:
    """Return the name of a class of machines."""
    return said(_CLASSES[name])


def zone_meaning(zone: str) -> str:
    """Return what a zone, A to D, means."""
    return said(_ZONES[zone])


SENTENCES: Final[dict[str, Sentence]] = {
    "severity_not_bearings": marked(
        "Severity does not show early bearing damage: its impacts are short and lie above 1 kHz, so"
        " a machine in zone A may have a damaged bearing. Use `rolamento diagnose` for that."
    ),
    "severity_speed_unknown": marked(
        "The speed is not known: the band begins at 10 Hz. Below 600 rpm it must begin at 2 Hz;"
        " give `speed`."
    ),
    "severity_speed_outside": marked(
        "{speed:.4 rpm} is outside the 120 to 30 000 rpm of ISO 20816-3: its zones are not defined"
        " for this machine."
    ),
    "severity_band_missing": marked(
        "The sampling rate of {rate:.6 Hz} does not contain the band up to {high:.6 Hz}: no"
        " severity. Record with at least 2560 Hz."
    ),
    "severity_near_half_rate": marked(
        "1 kHz is near half the sampling rate of {rate:.6 Hz}: a recorder's filter may attenuate"
        " part of the band."
    ),
    "severity_displacement_worse": marked(
        "By displacement the machine is in zone {zone}, by velocity in zone {by_velocity}: low"
        " frequencies dominate. ISO 20816-3 takes the worse of the two, and so does the verdict."
    ),
}
