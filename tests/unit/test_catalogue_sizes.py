"""What a designation brings to a case: sizes, class, ratings, and what is inferred."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

import pytest
from tests.one_case import said

from rolamento import (
    Bearing,
    Case,
    Duty,
    InputError,
    Load,
    Mounting,
    override,
    parse_case,
    solve,
)
from rolamento.case import case_to_json, case_to_toml
from rolamento.case.case import _with_catalogue_sizes, designation_of
from rolamento.clearance import class_clearance, clearance_of_case
from rolamento.life import conditions_of, life
from rolamento.words import Note

TEXT = textwrap.dedent(
    """
    [bearing]
    designation = "{designation}"
    {bearing}
    [duty]
    inner_speed = "1000 rpm"
    [duty.load]
    fz = "2 kN"
    [mounting]
    shaft_tolerance = "k5"
    {mounting}
    """
)


def case(designation: str = "6305/C3", *, bearing: str = "", mounting: str = "") -> Case:
    return parse_case(
        TEXT.format(designation=designation, bearing=bearing, mounting=mounting), source="case.toml"
    )


# --- bore and outside diameter ----------------------------------------------------------------


def test_a_mounting_gets_the_sizes_of_the_designation() -> None:
    found = case().mounting
    assert found is not None
    # boundary dimensions of 6305, ISO 15: 25 x 62 x 17
    assert (found.bore, found.outside_diameter) == (0.025, 0.062)


def test_sizes_may_be_given_if_they_are_the_same() -> None:
    assert case(mounting='bore = "25 mm"').mounting == case().mounting


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ('bore = "30 mm"', 'mounting.bore = "30 mm": must be 25 mm, the value of 6305/C3'),
        ('outside_diameter = "72 mm"', 'mounting.outside_diameter = "72 mm": must be 62 mm'),
    ],
)
def test_other_sizes_are_refused(given: str, said: str) -> None:
    with pytest.raises(InputError, match=re.escape(said)) as caught:
        case(mounting=given)
    assert caught.value.line == 11
    assert "(example: " in str(caught.value)


def test_sizes_are_not_made_up() -> None:
    plain = TEXT.format(designation="6305", bearing="", mounting="").replace(
        'designation = "6305"',
        'ball_count = 8\nball_diameter = "10 mm"\npitch_diameter = "44 mm"\n'
        'contact_angle = "0 deg"\ninner_conformity = 0.52\nouter_conformity = 0.52',
    )
    with pytest.raises(InputError, match=r"mounting\.bore"):
        parse_case(plain)


def test_an_unknown_designation_is_told_of_itself() -> None:
    with pytest.raises(InputError, match=r"bearing\.designation") as caught:
        case("6399")
    assert "mounting" not in str(caught.value)


def test_in_python_too() -> None:
    found = Case(
        bearing=Bearing.named("6305"),
        duty=Duty(load=Load(fz=1000.0)),
        mounting={"shaft_tolerance": "k5"},
    )
    assert found.mounting == Mounting(bore=0.025, outside_diameter=0.062, shaft_tolerance="k5")
    with pytest.raises(InputError, match="must be 25 mm"):
        Case(
            bearing=Bearing.named("6305"),
            duty=Duty(),
            mounting=Mounting(bore=0.03, outside_diameter=0.062),
        )


def test_replenishment_gets_them_as_well() -> None:
    text = TEXT.replace(
        "[mounting]\nshaft_tolerance", '[film]\nstarvation = "replenishment"\nsupply'
    )
    found = parse_case(
        text.format(designation="6305", bearing="", mounting="").replace('"k5"', '"bath"')
    )
    assert found.film is not None
    assert (found.film.bore, found.film.outside_diameter) == (0.025, 0.062)
    none = text.replace('starvation = "replenishment"\nsupply = "k5"', 'thermal = "none"')
    plain = parse_case(none.format(designation="6305", bearing="", mounting=""))
    assert plain.film is not None
    assert plain.film.bore is None


@pytest.mark.parametrize("mounting", ["3", "[]", '"H7"'])
def test_a_mounting_that_is_no_table_is_refused_as_such(mounting: str) -> None:
    given = f'mounting = {mounting}\n[bearing]\ndesignation = "6305"\n[duty.load]\nfz = "1 kN"\n'
    with pytest.raises(InputError, match=r"mounting = .*must be a table"):
        parse_case(given)


@pytest.mark.parametrize("designation", [6305, "6305"])
def test_a_number_is_a_designation(designation: object) -> None:
    given = {"mounting": {}, "bearing": {"designation": designation}}
    found = _with_catalogue_sizes(given, "6305")
    assert found["mounting"] == {"bore": 0.025, "outside_diameter": 0.062}
    assert given["mounting"] == {}
    assert designation_of(given["bearing"]) == "6305"


def test_files_hold_them() -> None:
    own = case()
    assert parse_case(case_to_toml(own)) == parse_case(case_to_json(own)) == own


# --- what is published ------------------------------------------------------------------------


def test_what_the_catalogue_publishes(bearing_218: Bearing) -> None:
    published = Bearing.named("6305/C3").published
    assert published is not None
    # NSK, Rolling Bearings E1102: 6305, C 20 600 N, C_0 11 200 N, f_0 13.2
    assert (published.dynamic_rating, published.static_rating) == (20_600.0, 11_200.0)
    assert "NSK" in published.sources["dynamic_rating"]
    assert bearing_218.published is None


def test_the_class_of_a_clearance() -> None:
    assert Bearing.named("6305/C3").clearance_class == "C3"
    assert Bearing.named("6305").clearance_class == "CN"
    own = Bearing.named("6305/C3", diametral_clearance=2e-5)
    assert own.clearance_class is None
    assert Bearing.named("S 6012 C").clearance_class is None


def test_a_mounted_designation_starts_from_its_class() -> None:
    first = clearance_of_case(case("6305/C3")).steps[0]
    band = class_clearance(0.025, "C3")
    assert first.clearance == pytest.approx((band.low, band.middle, band.high))
    assert first.source.values["name"] == "C3"
    given = clearance_of_case(case("6305/C3", mounting='clearance_class = "C4"')).steps[0]
    assert given.clearance[1] == pytest.approx(class_clearance(0.025, "C4").middle)
    own = clearance_of_case(case("6305/C3", bearing='diametral_clearance = "0.02 mm"')).steps[0]
    assert own.clearance == pytest.approx((2e-5, 2e-5, 2e-5))


# --- ratings ----------------------------------------------------------------------------------


def test_ratings_come_from_the_designation() -> None:
    found = life(solve(case()))
    assert found.ratings.dynamic_of_set[0] == 20_600.0
    assert found.ratings.static_of_set[0] == 11_200.0
    assert found.rating_sources["dynamic"].startswith("NSK, Rolling Bearings")
    assert found.rating_sources["fatigue"] == "estimate"


def test_a_rating_that_is_given_goes_before() -> None:
    own = override(case(), ["life.dynamic_rating=22 kN"])
    found = life(solve(own))
    assert found.ratings.dynamic_of_set[0] == pytest.approx(22_000.0)
    assert found.rating_sources["dynamic"] == "given"
    assert found.rating_sources["static"].startswith("NSK")


def test_the_static_rating_of_ceramic_balls_is_that_of_steel_by_the_stiffness_squared() -> None:
    hybrid = override(case(), ["bearing.ball_material=Si3N4"])
    conditions = conditions_of(hybrid)
    assert conditions.dynamic_rating == 20_600.0
    assert conditions.static_rating == pytest.approx(0.709 * 11_200.0, rel=1e-3)


# --- inferred balls ---------------------------------------------------------------------------


def test_inferred_balls_are_a_note() -> None:
    (note,) = (note for note in solve(case()).notes[0] if note.key.startswith("geometry"))
    assert note == Note("geometry_estimated_uniquely", {"designation": "6305/C3"})
    assert "no other standard ball size reproduces them" in note.text
    assert said(note, "pt").startswith("A geometria interna do 6305/C3 não é publicada")


def test_published_or_given_balls_are_none() -> None:
    for own in (
        Bearing.named("S 6012 C"),
        Bearing.named(
            "6305", ball_count=7, ball_diameter=0.0115, pitch_diameter=0.0435,
            diametral_clearance=1e-5,
        ),
    ):  # fmt: skip
        state = solve(Case(bearing=own, duty=Duty(load=Load(fx=500.0))))
        assert state.converged.all()
        assert not [note for note in state.notes[0] if note.key.startswith("geometry")]


def test_the_note_counts_the_alternatives(examples: Path) -> None:
    state = solve(Case(bearing=Bearing.named("6205"), duty=Duty(load=Load(fz=500.0))))
    (note,) = (note for note in state.notes[0] if note.key == "geometry_estimated")
    assert note.values["designation"] == "6205"
    assert said(note, "pt") != said(note)
