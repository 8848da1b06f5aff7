"""What was taken for what as a signal was read from its file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

from rolamento.words.speaking import marked, said

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["SENTENCES"]


def _multiplied(values: Mapping[str, Any]) -> str:
    if values["before"]:
        return said("Samples in {before} are multiplied by {scale:.6} {unit}.", **values)
    return said("Samples are multiplied by {scale:.6} {unit}.", **values)


SENTENCES: Final[dict[str, Sentence]] = {
    "rate_over_file": marked(
        "The sampling rate is {rate:.9 Hz} as given; the file says {file:.9 Hz}."
    ),
    "rate_over_doubt": marked(
        "The sampling rate is {rate:.9 Hz} as given; the file gives more than one: {doubt}."
    ),
    "rate_aside": marked(
        "The sampling rate is {rate:.9 Hz}; {name} = {value:.9} of the file is taken for something"
        " else."
    ),
    "speed_over_file": marked("The speed is {speed:.6 rpm} as given; the file says {file:.6 rpm}."),
    "samples_multiplied": _multiplied,
    "samples_not_calibrated": marked(
        "Samples in {unit} are not calibrated: no sensitivity was given."
    ),
    "bits_to_full_scale": marked("Samples of {bits} bits are scaled to a full scale of 1."),
}
