"""The makers' lists as they are on file: no double, and no number that stands out of its series.

Of each maker, kind, angle and series the neighbours in size are compared: C over (d + D)^1.75, C_0
over (d + D)², the limiting speed times d + D. What does stand out stands so in the list, and is
named here with how far.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from math import degrees
from typing import Final

import numpy as np
import pytest

from rolamento.catalogue import CatalogueBearing
from rolamento.catalogue.search import built_in_catalogue, folded

NEIGHBOURS: Final = 3
"""On either side; a series of fewer than four is not compared."""
FAR: Final = 1.3

SMALLEST = "the smallest of its series, whose rings are thin"
SHORT = "VE240: rollers of C 5915 V in a wider ring, for more axial displacement"
KNOWN = {
    "dynamic_rating": {
        "SEA 45 15deg": "the last with balls of 3.17 mm, in a thicker section",
        "SEA 45 25deg": "as with 15°",
        "SEA 10 15deg": SMALLEST, "SEA 10 25deg": SMALLEST, "6800": SMALLEST, "7000C": SMALLEST,
        "7000A": SMALLEST, "NA 4900": SMALLEST, "RNA 4900": SMALLEST, "51100": SMALLEST,
        "SEB 20 15deg": "the list begins with 17 mm, of the thinner section",
        "SEB 20 25deg": "as with 15°",
        "C 6915 V": SHORT,
    },
    "static_rating": {
        "SEA 45 15deg": "as its C", "SEA 45 25deg": "as its C", "NA 4900": SMALLEST,
        "RNA 4900": SMALLEST, "51100": SMALLEST, "30303 D": SMALLEST, "C 6915 V": SHORT,
    },
    "limiting_speed": dict.fromkeys(
        ("C 4040 V", "C 4044 V", "C 4120 V", "C 4138 V", "C 4140 V"),
        "without a cage it falls faster than 1/d",
    ),
}  # fmt: skip
EXPONENTS = {"dynamic_rating": 1.75, "static_rating": 2.0, "limiting_speed": -1.0}


def series_of(bearing: CatalogueBearing) -> tuple[object, ...]:
    """Maker, kind, angle and the designation without its bore."""
    angle = round(degrees(bearing.contact_angle or 0.0))
    number = re.sub(r" \d\ddeg$", "", bearing.designation)
    return bearing.maker, bearing.kind, angle, re.sub(r"\d\d(?=\D*$)|/\d+", "#", number)


def size_of(bearing: CatalogueBearing) -> float:
    return (bearing.bore or 0.0) + (bearing.outside_diameter or 0.0)


def outliers(
    bearings: tuple[CatalogueBearing, ...], name: str, far: float = FAR
) -> dict[str, float]:
    """Which lie so far from the median of their neighbours, and how far."""
    by_series: dict[tuple[object, ...], list[CatalogueBearing]] = {}
    for bearing in bearings:
        if getattr(bearing, name):
            by_series.setdefault(series_of(bearing), []).append(bearing)
    found = {}
    for own in by_series.values():
        own.sort(key=size_of)
        values = np.log([getattr(one, name) * size_of(one) ** -EXPONENTS[name] for one in own])
        for place, one in enumerate(own if len(own) > NEIGHBOURS else ()):
            near = np.arange(max(0, place - NEIGHBOURS), min(len(own), place + NEIGHBOURS + 1))
            ratio = float(np.exp(values[place] - np.median(values[near[near != place]])))
            if max(ratio, 1.0 / ratio) >= far:
                found[one.designation] = ratio
    return found


@pytest.mark.parametrize("name", KNOWN)
def test_numbers_follow_their_series(name: str) -> None:
    assert set(outliers(built_in_catalogue().bearings, name)) == set(KNOWN[name])


def changed(designation: str, name: str, change: Callable[[float], float]) -> dict[str, float]:
    """The outliers if one number of one bearing were misprinted."""
    bearings = tuple(
        replace(one, **{name: change(getattr(one, name))})
        if one.designation == designation
        else one
        for one in built_in_catalogue().bearings
    )
    return outliers(bearings, name)


@pytest.mark.parametrize(
    ("designation", "name"),
    [("6310", "dynamic_rating"), ("6210", "static_rating"), ("NA 4834", "limiting_speed")],
)
def test_a_number_of_another_line_would_stand_out(designation: str, name: str) -> None:
    assert designation in changed(designation, name, lambda value: 1.5 * value)
    assert designation in changed(designation, name, lambda value: value / 1.5)


def test_every_bearing_is_listed_once() -> None:
    """By its designation as it is looked up; letters of an execution make another bearing."""
    counts = Counter(folded(one.designation) for one in built_in_catalogue().bearings)
    assert [name for name, count in counts.items() if count > 1] == []


def test_two_editions_of_one_list_are_known() -> None:
    """SKF's catalogues differ by the Explorer class: 33205/Q and 320/28 X/Q are of the older one.

    Of their sizes NSK's C is the same within 7 %, where Explorer bearings have 15 % more.
    """
    by_name = {one.designation: one for one in built_in_catalogue().bearings}
    for older, same_size in (("33205/Q", "HR 33205 J"), ("320/28 X/Q", "HR 320/28 XJ")):
        own, other = by_name[older].dynamic_rating, by_name[same_size].dynamic_rating
        assert own is not None
        assert other is not None
        assert own / other == pytest.approx(1.0, abs=0.07)
