"""Profiles of rollers and races: what may be given, and the drop that it means."""

from __future__ import annotations

import numpy as np
import pytest

from rolamento.case.profile import PROFILE_KINDS, Profile
from rolamento.contact.line import slice_places
from rolamento.contact.profile import drop
from rolamento.errors import InputError

D, L = 10e-3, 12e-3
GIVEN = {
    "none": {},
    "iso": {},
    "logarithmic": {"amplitude": "3 um", "crowned_length": "3 mm", "end_drop": "20 um"},
    "crowned": {"radius": "1 m"},
    "tangential": {"radius": "500 mm", "flat_length": "6 mm"},
    "table": {"places": ["0 mm", "3 mm", "6 mm"], "drops": ["0 um", "1 um", "7 um"]},
}


def profile(kind: str, **fields: object) -> Profile:
    return Profile.from_mapping({"kind": kind, **GIVEN[kind], **fields})


def at(given: Profile, *places: float, **sizes: float) -> np.ndarray:
    return drop(given, places, **{"length": L, "diameter": D, **sizes})


def test_every_kind_is_given_written_and_read_back() -> None:
    assert set(GIVEN) == set(PROFILE_KINDS)
    for kind in PROFILE_KINDS:
        one = profile(kind)
        assert Profile.from_mapping(one.to_mapping()) == one


@pytest.mark.parametrize("kind", PROFILE_KINDS)
def test_drops_are_even_begin_at_nothing_and_rise_to_the_end(kind: str) -> None:
    places = slice_places(L, 101)
    found = drop(profile(kind), places, length=L, diameter=D)
    np.testing.assert_allclose(found, found[::-1], atol=1e-18)
    assert found[50] == 0.0
    assert np.all(np.diff(found[50:]) >= 0.0)
    assert np.all(np.isinf(at(profile(kind), 0.51 * L, -0.51 * L)))


def test_the_standard_profile() -> None:
    # by hand: 0.00035·10 mm·ln(1/(1 - 0.5²)) and the ends of 12.5 mm of a roller of 40 mm
    iso = profile("iso")
    assert at(iso, 3e-3)[0] == pytest.approx(3.5e-6 * np.log(4.0 / 3.0), rel=1e-14)
    assert at(iso, 0.5 * L)[0] == np.inf
    assert drop(iso, 3e-3, length=L, diameter=D, tapered=True) == pytest.approx(
        4.5e-6 * np.log(4.0 / 3.0), rel=1e-14
    )
    long = {"length": 40e-3}
    assert at(iso, 7.5e-3, **long)[0] == 0.0
    x = 7.5e-3 + 6.25e-3
    assert at(iso, x, **long)[0] == pytest.approx(5e-6 * np.log(4.0 / 3.0), rel=1e-13)
    # the standard's form: (2|x| - (L - 2.5 D))/(2.5 D)
    s = (2.0 * x - (40e-3 - 25e-3)) / 25e-3
    assert at(iso, x, **long)[0] == pytest.approx(0.0005 * D * -np.log(1.0 - s * s), rel=1e-13)


def test_a_factor_takes_the_place_of_the_standards() -> None:
    twice = profile("iso", factor=0.0007)
    np.testing.assert_allclose(at(twice, 1e-3, 5e-3), 2.0 * at(profile("iso"), 1e-3, 5e-3))


def test_logarithmic_profile_without_numbers_is_the_standards_of_short_rollers() -> None:
    plain = Profile.from_mapping({"kind": "logarithmic"})
    places = slice_places(L, 35)
    np.testing.assert_allclose(
        drop(plain, places, length=L, diameter=D),
        drop(profile("iso"), places, length=L, diameter=D),
        rtol=1e-14,
    )


def test_logarithmic_profile_has_a_straight_middle_and_its_drop_at_the_end() -> None:
    log = profile("logarithmic")
    np.testing.assert_array_equal(at(log, 0.0, 1e-3, 3e-3), 0.0)
    assert at(log, 0.5 * L)[0] == pytest.approx(20e-6, rel=1e-12)
    # Fujiwara and Kawase (2007): A ln 1/(1 - (1 - exp(-z/A)) s²)
    expected = -3e-6 * np.log(1.0 - (1.0 - np.exp(-20.0 / 3.0)) * 0.25)
    assert at(log, 4.5e-3)[0] == pytest.approx(expected, rel=1e-12)


def test_arcs() -> None:
    crowned, tangential = profile("crowned"), profile("tangential")
    assert at(crowned, 6e-3)[0] == pytest.approx(1.0 - np.sqrt(1.0 - 36e-6), rel=1e-9)
    np.testing.assert_array_equal(at(tangential, 0.0, 3e-3, -3e-3), 0.0)
    assert at(tangential, 5e-3)[0] == pytest.approx((2e-3) ** 2 / (2.0 * 0.5), rel=1e-4)
    step = 1e-6  # no kink where the arc begins
    assert at(tangential, 3e-3 + step)[0] / step < 2e-6


def test_measured_profile_of_unlike_ends() -> None:
    one = profile("table", places=["-6 mm", "0 mm", "6 mm"], drops=["4 um", "0 um", "8 um"])
    np.testing.assert_allclose(at(one, -3e-3, 3e-3), [2e-6, 4e-6])


def test_words_stand_for_kinds_that_need_nothing_else() -> None:
    assert Profile.table_of_text(" ISO ") == {"kind": "iso"}
    assert Profile.table_of_text("none") == {"kind": "none"}
    with pytest.raises(InputError, match=r"needs radius, flat_length"):
        Profile.table_of_text("tangential")
    with pytest.raises(InputError, match="did you mean logarithmic"):
        Profile.table_of_text("logaritmic")


@pytest.mark.parametrize(
    ("table", "field", "rule"),
    [
        ({"kind": "crowned"}, "radius", "is needed"),
        ({"kind": "none", "radius": "1 m"}, "radius", "does not apply to a profile of kind none"),
        ({"kind": "iso", "factor": 0.5}, "factor", "at most 0.01"),
        ({"kind": "crowned", "radius": 1.0}, "radius", "needs a unit"),
        ({"kind": "round"}, "kind", "must be one of"),
        ({}, "kind", "is missing"),
        (
            {"kind": "table", "places": ["0 mm", "1 mm"], "drops": ["0 mm", "1 um", "2 um"]},
            "drops",
            "as many as there are places",
        ),
        (
            {"kind": "table", "places": ["1 mm", "0 mm"], "drops": ["0 mm", "1 um"]},
            "places",
            "must rise",
        ),
        (
            {"kind": "table", "places": ["1 mm", "2 mm"], "drops": ["0 mm", "1 um"]},
            "places",
            "from the middle",
        ),
        ({"kind": "table", "places": ["0 mm"], "drops": ["0 mm"]}, "places", "at least 2"),
    ],
)
def test_refused(table: dict[str, object], field: str, rule: str) -> None:
    with pytest.raises(InputError, match=rule) as refused:
        Profile.from_mapping(table)
    assert refused.value.field == field


@pytest.mark.parametrize(
    ("one", "field"),
    [
        (profile("table", places=["0 mm", "2 mm"], drops=["0 um", "1 um"]), "places"),
        (profile("crowned", radius="5 mm"), "radius"),
    ],
)
def test_profiles_that_end_before_the_roller_does(one: Profile, field: str) -> None:
    with pytest.raises(InputError, match="end of the") as refused:
        at(one, 1e-3)
    assert refused.value.field == field
