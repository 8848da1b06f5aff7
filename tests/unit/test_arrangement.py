"""Rows, arrangements and preloads as the user gives them: checks, messages, round trips."""

from __future__ import annotations

import copy
import json
import pickle
from itertools import pairwise
from typing import Annotated, Any, Literal

import pytest

from rolamento import (
    Bearing,
    Case,
    Duty,
    InputError,
    UnknownKeyError,
    case_to_json,
    case_to_toml,
    load_case,
    override,
    parse_case,
    save_case,
)
from rolamento.case.arrangement import ARRANGEMENTS, BallRow, Preload
from rolamento.case.bearing import MOST_ROWS
from rolamento.case.record import ByElement, Record

GEOMETRY: dict[str, Any] = {
    "ball_count": 16,
    "ball_diameter": "22.23 mm",
    "pitch_diameter": "125.26 mm",
    "contact_angle": "40 deg",
    "inner_conformity": 0.5232,
    "outer_conformity": 0.5232,
}
PAIR: dict[str, Any] = {**GEOMETRY, "arrangement": "DB", "spacing": "40 mm"}
FILE = """
title = "A set"

[bearing]
ball_count = 22
ball_diameter = "9.525 mm"
pitch_diameter = "77.5 mm"
contact_angle = "15 deg"
inner_conformity = 0.52
outer_conformity = 0.52
preload = { force = "500 N" }

[[bearing.rows]]
orientation = "+"
position = "-20 mm"

[[bearing.rows]]
orientation = "-"
position = "5 mm"
phase = "4 deg"
ball_count = 18
contact_angle = "25 deg"

[[bearing.rows]]
orientation = "-"
position = "25 mm"

[duty]
inner_speed = "9000 rpm"
"""


# --- where the rows are ----------------------------------------------------------------------


@pytest.mark.parametrize("name", ARRANGEMENTS)
def test_the_rows_of_an_arrangement_stand_about_the_middle(name: Any) -> None:
    bearing = Bearing(**{**PAIR, "arrangement": name})
    places = bearing.places
    signs = "".join("+" if place.sign > 0 else "-" for place in places)
    assert tuple(signs) == ARRANGEMENTS[name]
    assert sum(place.position for place in places) == pytest.approx(0.0, abs=1e-15)
    gaps = [b.position - a.position for a, b in pairwise(places)]
    assert gaps == pytest.approx([0.04] * (len(places) - 1))
    assert all(place.bearing == Bearing(**GEOMETRY) for place in places)
    assert bearing.is_set


def test_the_letters_mean_what_the_catalogues_say() -> None:
    """B: the outer rows carry load outward; F: inward; mirrored, a name stays or swaps its B, F."""
    counts = {"D": 2, "T": 3, "Q": 4}
    for name, rows in ARRANGEMENTS.items():
        assert len(rows) == counts[name[0]]
        if name.endswith("T") and name[1:] != "T":
            assert (rows.count("+"), rows.count("-")) in {(1, len(rows) - 1), (len(rows) - 1, 1)}
        if "B" in name:
            assert (rows[0], rows[-1]) == ("+", "-")
        elif "F" in name:
            assert (rows[0], rows[-1]) == ("-", "+")
        else:
            assert set(rows) == {"+"}


def test_a_plain_bearing_is_its_own_row() -> None:
    plain = Bearing(**GEOMETRY)
    assert not plain.is_set
    (place,) = plain.places
    assert place == (plain, 1.0, 0.0, 0.0, None)


def test_rows_take_from_the_set_what_they_do_not_have() -> None:
    bearing = parse_case(FILE).bearing
    one, two, three = bearing.places
    assert [place.position for place in bearing.places] == [-0.02, 0.005, 0.025]
    assert one.bearing == three.bearing
    assert (two.bearing.ball_count, two.bearing.pitch_diameter) == (18, bearing.pitch_diameter)
    assert two.bearing.contact_angle == pytest.approx(0.4363323129985824)
    assert (two.sign, two.phase) == (-1.0, pytest.approx(0.06981317007977318))
    assert not two.bearing.is_set


def test_a_rows_own_angle_takes_the_place_of_the_sets_clearance() -> None:
    bearing = Bearing(
        **{**GEOMETRY, "contact_angle": None, "diametral_clearance": "20 um"},
        rows=[{"position": 0.0}, {"position": 0.04, "contact_angle": "15 deg"}],
    )
    deep, angular = (place.bearing for place in bearing.places)
    assert (deep.contact_angle, deep.diametral_clearance) == (None, 20e-6)
    assert (angular.diametral_clearance, angular.contact_angle) == (None, pytest.approx(0.2617994))


# --- what is refused -------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("changes", "field", "message"),
    [
        ({"arrangement": "XX"}, "arrangement", "must be one of|must be"),
        ({"spacing": None}, "spacing", "is missing; arrangement needs it"),
        ({"arrangement": None}, "arrangement", "is missing; spacing needs it"),
        ({"spacing": "0 mm"}, "spacing", "greater than 0 mm"),
        ({"spacing": "11 m"}, "spacing", "at most 10 m"),
        (
            {"rows": [{"position": 0.0}]},
            "arrangement",
            "cannot be combined with rows listed one by one",
        ),
        ({"arrangement": "DT", "preload": "500 N"}, "preload", "opposed rows"),
        ({"preload": "500"}, "preload", "with its unit"),
        ({"preload": "500 K"}, "preload", "a force or an offset"),
        ({"preload": {}}, "preload", "exactly one of force, offset, spring, level"),
        ({"preload": {"force": 1.0, "spring": 1.0}}, "preload", "exactly one"),
        ({"preload": {"force": -1.0}}, "preload.force", "at least 0 N"),
        ({"preload": {"force": float("nan")}}, "preload.force", "finite"),
        ({"preload": {"spring": 0.0}}, "preload.spring", "greater than 0 N"),
        ({"preload": {"offset": "11 mm"}}, "preload.offset", "at most 10 mm"),
        (
            {"preload": {"level": "light"}},
            "preload.designation",
            "a level of preload is that of a bearing in a maker's list",
        ),
        (
            {"preload": {"force": 1.0, "designation": "S 6012 C"}},
            "preload.designation",
            "is of a level of preload only",
        ),
        (
            {"preload": {"level": "light", "designation": "S 6012 C"}},
            "preload.designation",
            "15° only",
        ),
        ({"preload": {"level": "huge", "designation": "x"}}, "preload.level", "light"),
        ({"preload": {"forse": 1.0}}, "preload.forse", "did you mean force"),
    ],
)
def test_impossible_sets_are_refused(changes: dict[str, Any], field: str, message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        Bearing(**{**PAIR, **changes})
    assert caught.value.field == field


@pytest.mark.parametrize(
    ("row", "field", "message"),
    [
        ({}, "rows.1.position", "missing"),
        ({"position": "11 m"}, "rows.1.position", "at most 10 m"),
        ({"position": 0.0, "orientation": "left"}, "rows.1.orientation", "must be"),
        ({"position": 0.0, "ball_count": 2}, "rows.1.ball_count", "at least 3"),
        ({"position": 0.0, "ball_count": 40}, "rows.1.ball_count", "room for 17"),
        ({"position": 0.0, "ball_diameter": "2 m"}, "rows.1.ball_diameter", "at most 1 m"),
        ({"position": 0.0, "pitch_diameter": "20 mm"}, "rows.1.pitch_diameter", "greater than"),
        ({"position": 0.0, "angle": 0.3}, "rows.1.angle", "contact_angle"),
        ({"position": 0.0, "phase": "400 deg"}, "rows.1.phase", "at most 360°"),
    ],
)
def test_a_wrong_row_is_named_by_its_number(row: dict[str, Any], field: str, message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        Bearing(**GEOMETRY, rows=[{"position": -0.04}, row])
    assert caught.value.field == field


def test_a_wrong_row_in_a_file_is_named_with_its_line() -> None:
    wrong = FILE.replace('position = "5 mm"', "position = 5")
    with pytest.raises(InputError, match="needs a unit") as caught:
        parse_case(wrong, source="set.toml")
    assert (caught.value.field, caught.value.source) == ("bearing.rows.1.position", "set.toml")
    with pytest.raises(UnknownKeyError, match="did you mean phase") as unknown:
        parse_case(FILE.replace("phase =", "fase ="))
    assert unknown.value.field == "bearing.rows.1.fase"


def test_the_number_of_rows_is_bounded() -> None:
    rows = [{"position": 0.03 * i} for i in range(MOST_ROWS)]
    assert len(Bearing(**GEOMETRY, rows=rows).places) == MOST_ROWS
    for wrong in ([], [*rows, {"position": 1.0}], {"position": 1.0}, "DB", 3):
        with pytest.raises(InputError) as caught:
            Bearing(**GEOMETRY, rows=wrong)
        assert caught.value.field == "rows"


# --- preloads --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("given", "preload"),
    [
        ("500 N", Preload(force=500.0)),
        ("0.5 kN", Preload(force=500.0)),
        ("5 um", Preload(offset=5e-6)),
        ("-5 µm", Preload(offset=-5e-6)),
        ({"spring": "300 N"}, Preload(spring=300.0)),
        ({"spring": 300.0}, Preload(spring=300.0)),
        (Preload(force=0.0), Preload(force=0.0)),
    ],
)
def test_a_preload_is_a_table_or_text(given: Any, preload: Preload) -> None:
    assert Bearing(**{**PAIR, "preload": given}).preload == preload


def test_a_preload_of_facing_rows_needs_rows_of_either_orientation() -> None:
    rows = [
        {"orientation": "-", "position": 0.0},
        {"orientation": "-", "position": 0.04},
    ]
    with pytest.raises(InputError, match="opposed rows"):
        Bearing(**GEOMETRY, rows=rows, preload="5 um")
    assert Bearing(
        **GEOMETRY, rows=[*rows, {"orientation": "+", "position": 0.08}], preload="5 um"
    ).preload == Preload(offset=5e-6)


def test_what_a_row_has_of_its_own() -> None:
    row = BallRow(position=0.0, ball_count=12, contact_angle="25 deg", orientation="-", phase=0.1)
    assert row.own == {
        "ball_count": 12,
        "contact_angle": pytest.approx(0.4363323),
        "diametral_clearance": None,
    }
    assert BallRow(position=0.0).own == {}


# --- round trips -----------------------------------------------------------------------------

CASES = [
    parse_case(FILE),
    Case(bearing=Bearing(**PAIR), duty=Duty()),
    Case(bearing=Bearing(**{**PAIR, "preload": "7 um"}), duty=Duty()),
    Case(bearing=Bearing(**{**PAIR, "preload": {"spring": "300 N"}}), duty=Duty()),
    Case(
        bearing=Bearing(
            **{
                **PAIR,
                "contact_angle": "15 deg",
                "arrangement": "QFC",
                "preload": {"level": "heavy", "designation": "s6012c"},
            }
        ),
        duty=Duty(),
    ),
]


@pytest.mark.parametrize("case", CASES, ids=range(len(CASES)))
def test_a_set_comes_back_from_a_file_as_it_was(case: Case, tmp_path: Any) -> None:
    assert parse_case(case_to_toml(case)) == case
    assert parse_case(case_to_json(case)) == case
    for name in ("case.toml", "case.json"):
        save_case(case, tmp_path / name)
        assert load_case(tmp_path / name) == case
    assert Case.from_mapping(json.loads(json.dumps(case.to_mapping()))) == case
    assert pickle.loads(pickle.dumps(case)) == case == copy.deepcopy(case)
    assert hash(pickle.loads(pickle.dumps(case))) == hash(case)


@pytest.mark.parametrize(
    ("settings", "preload"),
    [
        (["bearing.preload.spring=300 N"], Preload(spring=300.0)),
        (["bearing.preload.offset=3 um"], Preload(offset=3e-6)),
        (["bearing.preload=400 N"], Preload(force=400.0)),
        (["bearing.preload=2 um"], Preload(offset=2e-6)),
        (
            ["bearing.preload.level=light", "bearing.preload.designation=S 6012 C"],
            Preload(level="light", designation="S 6012 C"),
        ),
    ],
)
def test_a_setting_replaces_the_preload(settings: list[str], preload: Preload) -> None:
    for start in ("500 N", {"spring": "9 N"}):
        case = Case(
            bearing=Bearing(**{**PAIR, "contact_angle": "15 deg", "preload": start}), duty=Duty()
        )
        assert override(case, settings).bearing.preload == preload


def test_a_setting_replaces_the_arrangement_or_the_rows() -> None:
    case = Case(bearing=Bearing(**PAIR), duty=Duty())
    assert override(case, ["bearing.arrangement=DF"]).bearing.arrangement == "DF"
    assert override(case, ["bearing.spacing=50 mm"]).bearing.spacing == 0.05
    rows = parse_case(FILE)
    back = override(rows, ["bearing.arrangement=DF", "bearing.spacing=20 mm"]).bearing
    assert (back.rows, back.arrangement, back.preload) == (None, "DF", rows.bearing.preload)


def test_a_wrong_setting_is_told_as_such() -> None:
    case = Case(bearing=Bearing(**PAIR), duty=Duty())
    for setting, message in (
        ("bearing.preload.sprung=3 N", "did you mean spring"),
        ("bearing.preload.spring=3", "needs a unit"),
        ("bearing.arrangement=DX", "DB"),
    ):
        with pytest.raises(InputError, match=message) as caught:
            override(case, [setting])
        assert caught.value.source == "--set"


# --- rows of any elements --------------------------------------------------------------------


def test_the_element_is_a_ball_unless_said_otherwise() -> None:
    assert Bearing(**GEOMETRY) == Bearing(**GEOMETRY, element="ball")
    rows = [{"position": 0.0}, {"position": 0.04, "element": "ball"}]
    bearing = Bearing(**GEOMETRY, rows=rows)
    assert [place.bearing.element for place in bearing.places] == ["ball", "ball"]


@pytest.mark.parametrize(
    ("fields", "field"),
    [
        ({"element": "cone", "cone_angle": 0.1}, "element"),
        ({"rows": [{"position": 0.0}, {"element": "cone", "taper": 0.1}]}, "rows.1.element"),
        ({"rows": [{"element": ["ball"], "position": 0.0}]}, "rows.0.element"),
    ],
)
def test_an_unknown_element_is_refused_with_the_known_ones(
    fields: dict[str, Any], field: str
) -> None:
    with pytest.raises(InputError, match="must be one of ball") as caught:
        Bearing(**GEOMETRY, **fields)
    assert caught.value.field == field


def test_places_of_errors_do_not_name_the_element() -> None:
    with pytest.raises(InputError, match="must be a number") as caught:
        Bearing(**GEOMETRY, rows=[{"element": "ball", "position": []}])
    assert caught.value.field == "rows.0.position"
    with pytest.raises(InputError, match="must be a table"):
        Bearing(**GEOMETRY, rows=[3])


def test_rows_of_two_kinds_are_told_apart() -> None:
    """What another kind of row has to do to join."""

    class ConeRow(Record):
        element: Literal["cone"] = "cone"
        cone_angle: float

    class Several(Record):
        rows: tuple[Annotated[BallRow | ConeRow, ByElement()], ...]

    cone, ball = Several(rows=[{"element": "cone", "cone_angle": 0.1}, {"position": 0.0}]).rows
    assert (cone, ball) == (ConeRow(cone_angle=0.1), BallRow(position=0.0))
    assert Several(rows=[cone, ball]).rows == (cone, ball)
    with pytest.raises(InputError, match="must be one of ball, cone"):
        Several(rows=[{"element": "barrel"}])
    with pytest.raises(InputError, match="is missing") as caught:
        Several(rows=[{"element": "cone"}])
    assert caught.value.field == "rows.0.cone_angle"


def test_rows_that_tell_all_need_no_geometry_beside_them() -> None:
    own = {name: value for name, value in GEOMETRY.items() if name != "contact_angle"}
    first = {**own, "contact_angle": "30 deg", "position": "-20 mm"}
    second = {"orientation": "-", "position": "20 mm", "contact_angle": "25 deg", "ball_count": 12}
    bearing = Bearing(rows=[first, second], preload="5 um")
    same = Bearing(
        **{**own, "contact_angle": "30 deg"},
        rows=[{"position": "-20 mm"}, second],
        preload="5 um",
    )
    for one, other in zip(bearing.places, same.places, strict=True):
        assert one[1:] == other[1:]
        assert one.bearing.model_dump() == other.bearing.model_dump()
    case = Case(bearing=bearing, duty=Duty())
    assert parse_case(case_to_toml(case)) == case
    assert "ball_count" not in case.bearing.model_fields_set
    changed = bearing.replace(preload="9 um")
    assert changed.places[0].bearing.ball_count == GEOMETRY["ball_count"]
    with pytest.raises(InputError, match="is missing"):
        Bearing(rows=[{"position": 0.0}, first])


def test_a_row_of_a_clearance_beside_one_of_an_angle() -> None:
    rows = [{"position": 0.0}, {"position": 0.04, "diametral_clearance": "20 um"}]
    first, second = Bearing(**GEOMETRY, rows=rows).places
    assert first.bearing.diametral_clearance is None
    assert second.bearing.contact_angle is None
    assert second.bearing.diametral_clearance == pytest.approx(20e-6)
    with pytest.raises(InputError, match="cannot be combined with"):
        BallRow(position=0.0, contact_angle=0.5, diametral_clearance=1e-5)
