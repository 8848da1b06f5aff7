"""Double-row, four-point, self-aligning and thrust ball bearings by their designation."""

from __future__ import annotations

from math import atan, cos, degrees, radians, sin, tan

import numpy as np
import pytest

from rolamento import Bearing
from rolamento.catalogue import (
    CatalogueBearing,
    catalogue,
    geometry_of,
    inferred_geometry,
    parse_designation,
)
from rolamento.catalogue.geometry import middle_clearance
from rolamento.catalogue.records import records_of_csv, records_of_toml
from rolamento.errors import InputError
from rolamento.ratings import dynamic_rating, static_rating


@pytest.mark.parametrize(
    ("text", "kind", "listed", "angle"),
    [
        ("3206", "double_row", "3206-BD", 30.0),
        ("3206 A-2RS1/C3", "double_row", "3206-BD", 30.0),
        ("3206-BD-2Z-TVH", "double_row", "3206-BD", 30.0),
        ("3206 B", "double_row", "5206", 25.0),
        ("5206ZZ", "double_row", "5206", 25.0),
        ("3314", "double_row", "5314", 25.0),
        ("SKF QJ 210 MA", "four_point", "QJ 210", 35.0),
        ("QJ210/C3", "four_point", "QJ 210", 35.0),
        ("QJF 1016", "four_point", "QJ 1016", 35.0),
        ("1210 ETN9", "self_aligning", "1210", 7.8),
        ("2210-2RS1", "self_aligning", "2210", 10.8),
        ("51210", "thrust", "51210", 90.0),
        ("51420 X", "thrust", "51420", 90.0),
        ("51210 FAG", "thrust", "51210", 90.0),
    ],
)
def test_designations_of_the_kinds(text: str, kind: str, listed: str, angle: float) -> None:
    found = catalogue().find(text).bearing
    assert (found.kind, found.designation) == (kind, listed)
    assert found.contact_angle == pytest.approx(radians(angle), abs=radians(0.051))


def test_a_series_is_not_one_of_more_figures() -> None:
    assert parse_designation("2216").kind == "self_aligning"
    assert parse_designation("32206").kind == parse_designation("33206").kind == "tapered"
    for text in ("62216", "52210"):
        assert parse_designation(text).kind == ""
        with pytest.raises(InputError, match=r"is a"):
            catalogue().find(text)


@pytest.mark.parametrize(
    ("designation", "balls", "diameter"),
    [  # standard balls that reproduce both ratings within a part in a hundred
        ("5207", 9, 7 / 16),
        ("QJ 210", 14, 1 / 2),
        ("QJ 214", 15, 11 / 16),
        ("1210", 18, 3 / 8),
        ("2212", 18, 15 / 32),
        ("51311", 13, 11 / 16),
        ("51210", 17, 13 / 32),
    ],
)
def test_inferred_balls(designation: str, balls: int, diameter: float) -> None:
    best = inferred_geometry(catalogue().find(designation).bearing)[0]
    assert (best.ball_count, best.ball_diameter) == (balls, pytest.approx(25.4e-3 * diameter))
    assert best.reproduces
    assert best.dynamic_error == pytest.approx(0.0, abs=0.012)
    assert best.static_error == pytest.approx(0.0, abs=0.012)


@pytest.mark.parametrize("kind", ["double_row", "four_point", "self_aligning", "thrust"])
def test_ratings_of_the_lists_follow_from_standard_balls(kind: str) -> None:
    """The formulas of ISO 281 and ISO 76 against the printed lists of NSK and Schaeffler."""
    listed = [bearing for bearing in catalogue().bearings if bearing.kind == kind]
    assert len(listed) >= 50
    best = [inferred_geometry(bearing, most=1) for bearing in listed[:: max(1, len(listed) // 25)]]
    assert sum(bool(found) and found[0].reproduces for found in best) >= len(best) - 1


def test_inference_finds_what_was_rated() -> None:
    """Ratings computed from balls give these balls back: a round trip for every formula."""
    balls, pitch = 25.4e-3 * 7 / 16, 0.0635
    for kind, rows, angle, count in (
        ("double_row", 2, 30.0, 11),
        ("four_point", 1, 35.0, 14),
        ("self_aligning", 2, 10.0, 15),
        ("thrust", 1, 90.0, 16),
        ("thrust", 1, 60.0, 16),
    ):
        bare = CatalogueBearing(
            designation="x", kind=kind, bore=pitch - 0.0166, outside_diameter=pitch + 0.0166,
            contact_angle=radians(angle),
        )  # fmt: skip
        rule = {"kind": bare.type.rated, "rows": rows}
        rated = CatalogueBearing(
            designation="x", kind=kind, bore=bare.bore, outside_diameter=bare.outside_diameter,
            contact_angle=bare.contact_angle,
            dynamic_rating=float(dynamic_rating(count, balls, pitch, radians(angle), **rule)),
            static_rating=float(static_rating(count, balls, pitch, radians(angle), **rule)),
        )  # fmt: skip
        best = inferred_geometry(rated)[0]
        assert (best.ball_count, best.ball_diameter) == (count, pytest.approx(balls)), kind
        assert best.pitch_diameter == pytest.approx(pitch, rel=3e-3)


def test_rows_of_a_double_row_stand_where_their_contact_lines_say() -> None:
    bearing = Bearing.named("3206")
    apart = bearing.published.load_centre_distance
    assert bearing.spacing == pytest.approx(apart - bearing.pitch_diameter * tan(radians(30.0)))
    assert bearing.arrangement == "DB"
    assert bearing.origins["spacing"] == "inferred"
    assert [place.sign for place in bearing.places] == [1.0, -1.0]
    assert all(place.bearing.arrangement is None for place in bearing.places)
    unlisted = CatalogueBearing(
        designation="D", kind="double_row", bore=0.03, outside_diameter=0.062, width=0.0238,
        contact_angle=radians(30.0), ball_count=9, ball_diameter=0.01,
    )  # fmt: skip
    from rolamento.catalogue import listed

    with listed([unlisted]):
        assumed = geometry_of("D")
    assert assumed.origins["spacing"] == "assumed"
    assert 0.36 < assumed.fields["spacing"] / unlisted.width < 0.46


def test_arches_of_a_four_point_bearing_leave_its_clearance() -> None:
    """The axial play between both contacts is the middle of its class: NSK, table 9.18."""
    for text, middle in (("QJ 210", 101e-6), ("QJ 210/C3", 141e-6), ("QJ 210/C2", 61e-6)):
        bearing = Bearing.named(text)
        distance = bearing.ball_diameter * (bearing.inner_conformity + bearing.outer_conformity - 1)
        play = 2 * distance * (sin(bearing.contact_angle) - sin(bearing.shim_angle))
        assert play == pytest.approx(middle, rel=1e-9)
        assert bearing.origins["shim_angle"] == "assumed"


def test_sphere_and_clearance_of_a_self_aligning_bearing() -> None:
    bearing = Bearing.named("1210")
    assert bearing.diametral_clearance == pytest.approx(22.5e-6)
    assert Bearing.named("1210 K").diametral_clearance == pytest.approx(30.5e-6)
    assert bearing.row_angle == pytest.approx(bearing.published.contact_angle)
    sphere = bearing.outer_conformity * bearing.ball_diameter
    reach = 0.5 * bearing.pitch_diameter / cos(bearing.row_angle) + 0.5 * bearing.ball_diameter
    assert sphere == pytest.approx(reach)
    own = Bearing.named("1210", contact_angle=radians(9.0))
    assert own.spacing is None
    assert own.row_angle == pytest.approx(radians(9.0))


def test_angles_of_self_aligning_bearings_give_the_printed_factors() -> None:
    """NSK prints e, Y2, Y3 and Y0 of 2310: 0.42, 2.3, 1.5 and 1.6."""
    tangent = tan(catalogue().find("2310").bearing.contact_angle)
    found = [1.5 * tangent, 0.65 / tangent, 0.42 / tangent, 0.44 / tangent]
    assert np.round(found, [2, 1, 1, 1][0]) == pytest.approx([0.42, 2.3, 1.5, 1.6], abs=0.06)
    assert degrees(atan(tangent)) == pytest.approx(15.7, abs=0.2)


def test_clearance_outside_the_tables_is_none() -> None:
    assert middle_clearance(0.2, "CN", "self_aligning") is None
    assert middle_clearance(0.05, "C5", "four_point") is None
    assert middle_clearance(0.05, "CN", "four_point") == pytest.approx(101e-6)


def test_own_catalogues_take_the_kinds() -> None:
    head = "designation,kind,bore_mm,outside_diameter_mm,contact_angle_deg,dynamic_rating_N,"
    text = head + "static_rating_N,limiting_speed_rpm\nT1,thrust,50,78,90,49000,111000,3600\n"
    (read,) = records_of_csv(text, "own.csv")
    assert (read.kind, read.type.rated, read.rows) == ("thrust", "thrust", 1)
    assert read.limiting_speed == pytest.approx(3600 * np.pi / 30)
    table = """[[bearing]]
designation = "Q"
kind = "four_point"
bore = "50 mm"
outside_diameter = "90 mm"
contact_angle = "35 deg"
axial_dynamic_rating = "57 kN"
axial_static_rating = "97 kN"
"""
    (read,) = records_of_toml(table, "own.toml")
    assert read.rated == (pytest.approx(0.66 * 57e3), pytest.approx(0.29 * 97e3))
    with pytest.raises(InputError, match="kind"):
        records_of_csv(text.replace("T1,thrust", "T1,roller"), "own.csv")
