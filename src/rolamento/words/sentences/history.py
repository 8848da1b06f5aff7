"""What a machine's history says, its bearings together, and a bearing that nobody knows."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

from rolamento.words.naming import listed, part_name, the_part, the_part_first
from rolamento.words.sentences.diagnosis import hertz
from rolamento.words.speaking import counted, marked, said

if TYPE_CHECKING:
    from rolamento.words.sentences import Sentence

__all__ = ["SENTENCES", "series_name"]

Values = Mapping[str, Any]


def series_name(name: str) -> str:
    """Return what is followed over many records: RMS, kurtosis, or the depth of a part."""
    if name == "rms":
        return said("RMS")
    if name == "kurtosis":
        return said("kurtosis")
    return said("depth, {part}", part=part_name(name))


def _grown(values: Values) -> str:
    return counted(
        "{part} is damaged: modulation depth {now:.0f %}, at most {then:.0f %} in the {n} record of"
        " the machine in good order.",
        "{part} is damaged: modulation depth {now:.0f %}, at most {then:.0f %} in the {n} records"
        " of the machine in good order.",
        values["records"],
        part=the_part_first(values["part"]), now=values["now"], then=values["then"],
    )  # fmt: skip


def _as_always(values: Values) -> str:
    return counted(
        "As always: {part} has a modulation depth of {now:.0f %}, and up to {then:.0f %} in the {n}"
        " record of the machine in good order.",
        "As always: {part} has a modulation depth of {now:.0f %}, and up to {then:.0f %} in the {n}"
        " records of the machine in good order.",
        values["records"],
        part=the_part(values["part"]), now=values["now"], then=values["then"],
    )  # fmt: skip


def _changed(values: Values) -> str:
    return said(
        "{series}: from {before:.3} to {after:.3} at {record} (p = {probability:.2}).",
        series=series_name(values["series"]), before=values["before"], after=values["after"],
        record=values["record"], probability=values["probability"],
    )  # fmt: skip


def _nothing_changed(values: Values) -> str:
    return counted(
        "No change of level in {n} record.", "No change of level in {n} records.", values["records"]
    )


def _either(values: Values) -> str:
    one, other = (
        said("{part} of {bearing}", part=the_part(part), bearing=bearing)
        for part, bearing in zip(values["parts"], values["bearings"], strict=True)
    )
    return said(
        "Undecided: the peak at {frequency} Hz is that of {one} as well as of {other}.",
        frequency=hertz(values["frequency"]), one=one, other=other,
    )  # fmt: skip


def _comb(values: Values) -> str:
    return said(
        "The deepest comb is at {frequency} Hz (order {order:.4}), modulation depth {depth:.0f %}.",
        frequency=hertz(values["frequency"]), order=values["order"], depth=values["depth"],
    )  # fmt: skip


def _bearings(values: Values) -> str:
    return counted(
        "{n} bearing of the catalogue would have some of the combs: {named}.",
        "{n} bearings of the catalogue would have some of the combs, those that explain most first:"
        " {named}. Slip hides which of them it is: read the designation off the bearing.",
        values["count"],
        named=listed(values["named"]),
    )


SENTENCES: Final[dict[str, Sentence]] = {
    "depth_grown": _grown,
    "depth_as_always": _as_always,
    "no_like_speed": marked(
        "No record of the machine in good order is at like speed, within {within:.0f %}: nothing"
        " could be compared."
    ),
    "series_changed": _changed,
    "nothing_changed": _nothing_changed,
    "last_record": marked("The last record:"),
    "peak_of_either": _either,
    "of_bearing": marked("{name}:"),
    "no_combs": marked("Nothing found: no peak of the envelope spectrum stands out of the noise."),
    "deepest_comb": _comb,
    "bearings_with_combs": _bearings,
    "no_bearing_with_combs": marked(
        "None of the {compared} bearings in the catalogue would have any of the combs: check the"
        " speed, or allow more `slip`."
    ),
}
