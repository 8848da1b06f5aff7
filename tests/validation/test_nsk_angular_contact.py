"""NSK, Rolling Bearings, CAT. No. E1102e: single-row angular-contact ball bearings.

Pages B50 to B63 (ratings, f0), A91 (boundary dimensions go with ISO 15) and A98 (preloads).
"""

from __future__ import annotations

import pytest

from rolamento.case.preload_classes import listed_preload
from rolamento.catalogue import CatalogueBearing, catalogue, inferred_geometry, parse_designation
from rolamento.catalogue.search import dimensions_of, standard_width
from rolamento.ratings import dynamic_rating, static_rating


def _listed() -> list[CatalogueBearing]:
    return [
        bearing
        for bearing in catalogue().bearings
        if bearing.maker == "NSK" and bearing.kind == "angular_contact"
    ]


def test_every_printed_rating_follows_from_standard_balls() -> None:
    """C by ISO 281, C0 and f0 by ISO 76, of balls that exist, within what is printed.

    A figure that was copied wrongly fits no balls: three or two figures of each of 220 bearings.
    """
    listed = _listed()
    assert len(listed) == 220
    for bearing in listed:
        best = inferred_geometry(bearing)[0]
        assert best.reproduces, bearing.designation
        assert abs(best.dynamic_error or 0.0) < 0.012, bearing.designation
        assert abs(best.static_error or 0.0) < 0.020, bearing.designation


def test_ratings_by_hand() -> None:
    """7014C, printed 47 000 and 43 000 N, f0 15.7, with the balls that are inferred for it."""
    bearing = catalogue().find("7014C").bearing
    best = inferred_geometry(bearing)[0]
    angle = bearing.contact_angle
    assert angle is not None
    place = (best.ball_count, best.ball_diameter, best.pitch_diameter, angle)
    assert float(dynamic_rating(*place)) == pytest.approx(47000.0, rel=0.01)
    assert float(static_rating(*place)) == pytest.approx(43000.0, rel=0.01)


@pytest.mark.parametrize(
    ("number", "alike"),
    [("7014", "7914"), ("7206", "7306")],
)
def test_the_angles_of_one_number_have_like_balls(number: str, alike: str) -> None:
    """A steeper angle costs radial capacity; a heavier series has larger balls."""
    ratings = {
        bearing.designation: bearing.dynamic_rating or 0.0
        for bearing in _listed()
        if bearing.designation.startswith((number, alike))
    }
    by_angle = [ratings[number + letter] for letter in "CAB" if number + letter in ratings]
    assert by_angle == sorted(by_angle, reverse=True)
    assert len(by_angle) > 1


def test_boundary_dimensions_are_those_of_iso_15() -> None:
    for bearing in _listed():
        found = dimensions_of(parse_designation(bearing.designation))
        assert found is not None
        assert bearing.width is not None
        assert (found.outside_diameter, found.width) == pytest.approx(
            (bearing.outside_diameter, bearing.width)
        )


def test_other_makers_have_the_widths_of_iso_15() -> None:
    """SNFA's list prints widths; every bearing whose size ISO 15 has, has its width too."""
    compared = 0
    for bearing in catalogue().bearings:
        if bearing.maker != "SNFA" or bearing.width is None:
            continue
        width = standard_width(bearing.bore, bearing.outside_diameter)
        if width is not None:
            assert width == pytest.approx(bearing.width), bearing.designation
            compared += 1
    assert compared > 300


@pytest.mark.parametrize(
    ("designation", "forces"),
    [
        ("7901C", (8.6, 15.0, 39.0, 78.0)),
        ("7914C", (100.0, 200.0, 490.0, 980.0)),
        ("7014C", (145.0, 290.0, 740.0, 1470.0)),
        ("7220C", (490.0, 980.0, 2350.0, 4710.0)),
    ],
)
def test_preloads(designation: str, forces: tuple[float, ...]) -> None:
    angle = catalogue().find(designation).bearing.contact_angle
    levels = ("extra_light", "light", "medium", "heavy")
    found = [listed_preload(designation, level, angle) for level in levels]
    assert found == list(forces)
