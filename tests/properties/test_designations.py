"""Designations: whatever is written, an answer or one message, and soon; letters add up."""

from __future__ import annotations

import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rolamento import Bearing, InputError
from rolamento.catalogue import catalogue, geometry_of, parse_designation
from rolamento.catalogue.letters import designation_data, letters_behind

_DATA = designation_data()
_NUMBERS = ("6205", "6310", "7014", "71914", "7206", "70BNR10", "UC205", "EX 70 15deg", "S 6014 C")
_PARTS = st.sampled_from(
    [
        *_DATA["suffixes"], *_DATA["sets"], *_DATA["universal"], *_DATA["preloads"],
        *_DATA["angles"], *_DATA["clearance"], *_DATA["makers"]["names"], "CD", "ACE", "C9", "XYZ",
    ]
)  # fmt: skip
_SIGNS = st.sampled_from(["", " ", "-", "/", ".", ","])


@st.composite
def _designations(draw: st.DrawFn) -> str:
    text = draw(st.sampled_from(["", "SKF ", "HC", "B", "S", "XCB"])) + draw(
        st.sampled_from(_NUMBERS)
    )
    for part in draw(st.lists(_PARTS, max_size=6)):
        text += draw(_SIGNS) + part
    return text[:60]


@given(st.one_of(_designations(), st.text(max_size=70)))
def test_an_answer_or_one_message(text: str) -> None:
    try:
        Bearing.named(text)
    except InputError as error:
        assert "\n" not in str(error).strip()


@given(_designations())
def test_nothing_of_a_designation_is_lost(text: str) -> None:
    """Every sign behind the number is in a part that is understood, or in one that is not."""
    try:
        found = parse_designation(text)
    except InputError:
        return
    told = [*(part.text for part in found.letters.parts), *found.unknown]
    assert len(set(found.unknown)) <= len(found.unknown)
    assert all(part for part in told)
    assert {part.text for part in found.letters.idle} <= set(told)


@pytest.mark.parametrize("part", ["U", "DB", "P4", "C3", "GA", "TYN", "X", "2RS", "VL0241", "P63"])
@pytest.mark.parametrize("tail", ["", "Q", "#"])
def test_the_longest_groups_take_no_time(part: str, tail: str) -> None:
    group = (part * 60)[:59] + tail
    began = time.perf_counter()
    letters_behind([group], group, angular=True)
    assert time.perf_counter() - began < 1.0


def test_every_angular_contact_bearing_is_found_with_every_suffix() -> None:
    """Letters behind a listed designation never lead to another bearing."""
    for bearing in catalogue().bearings:
        if bearing.kind == "angular_contact" and bearing.maker:
            for suffix in ("/P4A", " DB", "-P4S-UL"):
                found = catalogue().find(bearing.designation + suffix)
                assert found.bearing == bearing, bearing.designation + suffix


@given(st.sampled_from(["DB", "DF", "DT", "TBT", "TFT", "TT", "QBC", "QFC", "QBT", "QFT", "QT"]))
def test_skf_and_plain_letters_name_one_set(name: str) -> None:
    plain = geometry_of(f"7014C {name}")
    of_skf = geometry_of(f"7014 CD/P4A{name}A")
    assert plain.fields["arrangement"] == of_skf.fields["arrangement"] == name
