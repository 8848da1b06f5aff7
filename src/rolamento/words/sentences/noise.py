"""What is to be known of the noise of a bearing in anderons, and of a synthetic signal."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

from rolamento.words.naming import by_element, listed, part_name
from rolamento.words.speaking import marked, said, said_in

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["SENTENCES", "band_name"]


def band_name(band: str) -> str:
    """Return the name of a band of noise, low, medium or high; of another, what it is called."""
    return {
        "low": said_in("band", "low"),
        "medium": said_in("band", "medium"),
        "high": said_in("band", "high"),
    }.get(band, band)


def _incomplete(values: Mapping[str, Any]) -> str:
    return said(
        "The sampling rate of {rate:.6 Hz} is too low for: {bands}.",
        rate=values["rate"],
        bands=", ".join(map(band_name, values["bands"])),
    )


_UNSTRUCK: Final = by_element(
    marked(
        "Damage without any impact of non-zero force: {parts}. No ball is loaded where it lies, or"
        " the signal is too short."
    ),
    marked(
        "Damage without any impact of non-zero force: {parts}. No roller is loaded where it lies,"
        " or the signal is too short."
    ),
)


def _unstruck(values: Mapping[str, Any]) -> str:
    return _UNSTRUCK({**values, "parts": listed(map(part_name, values["parts"]))})


SENTENCES: Final[dict[str, Sentence]] = {
    "speed_unknown": marked(
        "The signal does not give the speed: anderons hold for 1800 rpm. Give `speed` if it was"
        " another."
    ),
    "speed_differs": marked(
        "The speed is not within −2 and +1 % of 1800 rpm, as ISO 15242-2 requires: anderons are"
        " calculated with the actual speed, but bands and limits are those of 1800 rpm."
    ),
    "band_incomplete": _incomplete,
    "near_half_rate": marked(
        "10 kHz is near half the sampling rate of {rate:.6 Hz}: a recorder's filter may attenuate"
        " part of the high band."
    ),
    "velocity_from_acceleration": marked(
        "Velocity is obtained from acceleration, line by line of the spectrum."
    ),
    "velocity_from_displacement": marked(
        "Velocity is obtained from displacement, line by line of the spectrum."
    ),
    "scaled_by_sensitivity": marked("The samples are scaled by {sensitivity}, as given."),
    "damage_not_struck": _unstruck,
    "frequency_modulation": marked(
        "Frequency modulation is what Braga and Almeida assume, not what impacts do: its envelope"
        " is flat."
    ),
    "signal_of_estimated_geometry": marked(
        "The internal geometry was estimated from the load ratings (see `rolamento catalogue`)."
    ),
}
