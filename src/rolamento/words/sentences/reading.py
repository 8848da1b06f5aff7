"""What was taken for what as a signal was read from its file."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final

from rolamento.words.naming import listed
from rolamento.words.speaking import marked, said

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["SENTENCES", "claimed"]

_TIMES: Final = marked("the column of times")
"""A name that a reader of files gives; others are quoted from the file."""


def claimed(claims: Iterable[Sequence[Any]]) -> str:
    """Say what a file gives for its sampling rate: names and numbers (Hz)."""
    numbers: dict[str, list[float]] = {}
    for name, value in claims:
        numbers.setdefault(name, []).append(value)
    texts = [
        said("{name} says {value:.9 Hz}", name=said(name), value=values[0])
        if len(values) == 1
        else said(
            "{name} says {value:.9 Hz} or {other:.9 Hz}, by its point",
            name=said(name), value=values[0], other=values[1],
        )
        for name, values in numbers.items()
    ]  # fmt: skip
    if len(texts) == 1 and len(next(iter(numbers.values()))) == 1:
        return said("{claim}, which may be the speed of the shaft as well", claim=texts[0])
    return listed(texts)


def _over_doubt(values: Mapping[str, Any]) -> str:
    return said(
        "The sampling rate is {rate:.9 Hz} as given; in the file {doubt}.",
        rate=values["rate"],
        doubt=claimed(values["claims"]),
    )


def _multiplied(values: Mapping[str, Any]) -> str:
    if values["before"]:
        return said("Samples in {before} are multiplied by {scale:.6} {unit}.", **values)
    return said("Samples are multiplied by {scale:.6} {unit}.", **values)


SENTENCES: Final[dict[str, Sentence]] = {
    "rate_over_file": marked(
        "The sampling rate is {rate:.9 Hz} as given; the file says {file:.9 Hz}."
    ),
    "rate_over_doubt": _over_doubt,
    "rate_aside": marked(
        "The sampling rate is {rate:.9 Hz}; {name} = {value:.9} of the file is taken for something"
        " else."
    ),
    "speed_over_file": marked("The speed is {speed:.6 rpm} as given; the file says {file:.6 rpm}."),
    "samples_multiplied": _multiplied,
    "samples_not_calibrated": marked(
        "Samples in {unit} are not calibrated: no sensitivity was given."
    ),
    "full_scale_unknown": marked(
        "Whole numbers of unknown full scale: the unit {unit} alone does not calibrate them, and"
        " sizes stay parts of the full scale. Give what that is worth, such as `scale='5 {unit}'`."
    ),
    "bits_to_full_scale": marked("Samples of {bits} bits are scaled to a full scale of 1."),
}
