"""What a maker lists of a bearing leads, and what its letters say and the figures lack is said."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from typer.testing import CliRunner

from rolamento import Case, solve
from rolamento.case import case_of, case_to_toml, parse_case
from rolamento.case.arrangement import Preload
from rolamento.case.bearing import Bearing
from rolamento.case.roller_bearing import RollerBearing
from rolamento.catalogue import geometry_of
from rolamento.cli.app import app
from rolamento.document.terminal import terminal
from rolamento.errors import InputError
from rolamento.friction import friction
from rolamento.geometry import apex_distance, usual_end_radius
from rolamento.life import life
from rolamento.pages.life import life_page, rating_source
from rolamento.pages.state import state_page
from rolamento.solved import Solved
from rolamento.tasks.new_case import case_template

RPM = pi / 30.0


def solved_of(designation: str, *settings: str) -> Solved:
    given = ["duty.inner_speed=600 rpm", "duty.load.fz=1569 N", "duty.load.fx=3474 N"]
    return solve(case_of(designation, [*given, *settings]))


# --- Y, Y_0 and e ---------------------------------------------------------------------------------


def test_the_listed_factors_lead() -> None:
    found = life(solved_of("HR 30305 DJ"))
    loads = found.loads
    assert loads.listed
    assert (loads.axial_factor[0], loads.limit[0]) == (0.73, 0.83)
    assert loads.dynamic[0] == pytest.approx(0.4 * 1569.0 + 0.73 * 3474.0)
    published = case_of("HR 30305 DJ").bearing.published
    assert published is not None
    assert published.static_axial_factor is not None
    assert loads.static[0] == pytest.approx(0.5 * 1569.0 + published.static_axial_factor * 3474.0)
    assert found.to_mapping()["loads"]["factors_listed"]
    assert "the maker's" in terminal(life_page(solved_of("HR 30305 DJ"), found))


def test_rows_that_face_each_other_keep_the_proportion_of_the_standard() -> None:
    alone = life(solved_of("HR 30305 DJ")).loads
    pair = life(solved_of("HR 30305 DJ DB")).loads
    assert pair.listed
    assert pair.axial_factor[0] == pytest.approx(0.67 / 0.4 * 0.73)
    assert pair.limit[0] == alone.limit[0]
    low = life(solved_of("HR 30305 DJ DB", "duty.load.fx=500 N")).loads
    assert low.dynamic[0] == pytest.approx(1569.0 + 0.45 / 0.4 * 0.73 * 500.0)
    tandem = life(solved_of("HR 30305 DJ DT")).loads
    assert tandem.dynamic[0] == pytest.approx(alone.dynamic[0])


def test_an_angle_of_ones_own_has_its_own_factors() -> None:
    loads = life(solved_of("HR 30305 DJ", "bearing.contact_angle=28 deg")).loads
    assert not loads.listed
    assert loads.axial_factor[0] == pytest.approx(0.4 / np.tan(np.radians(28.0)))
    varied = solve(
        case_of("HR 30305 DJ", ["duty.inner_speed=600 rpm", "duty.load.fx=3474 N"]),
        {"bearing.contact_angle": np.radians([28.0, 29.0])},
    )
    assert life(varied).loads.axial_factor == pytest.approx(0.4 / np.tan(np.radians([28.0, 29.0])))


def test_batch_and_single_take_the_same_factors() -> None:
    case = case_of("30206", ["duty.inner_speed=600 rpm", "duty.load.fz=1 kN"])
    batch = life(solve(case, {"duty.load.fx": np.array([1e3, 3e3])})).loads
    for index, axial in enumerate((1e3, 3e3)):
        one = life(solve(case, {"duty.load.fx": np.array([axial])})).loads
        assert batch.dynamic[index] == pytest.approx(one.dynamic[0], rel=1e-12)
    assert batch.listed


# --- C_u ------------------------------------------------------------------------------------------


def test_an_inferred_interior_has_the_simplified_fatigue_load_limit() -> None:
    found = life(solved_of("6310", "duty.load.fx=0 N"))
    assert found.ratings.fatigue_of_set[0] == pytest.approx(38_500.0 / 22.0)
    assert found.rating_sources["fatigue"] == "estimate"
    by_contacts = found.ratings.fatigue_by_contacts
    assert by_contacts is not None
    assert by_contacts[0] == pytest.approx(1986.0, rel=1e-3)
    assert "1.986 kN" in rating_source(found, "fatigue")
    mapping = found.to_mapping()["ratings"]
    assert mapping["fatigue_by_contacts"] == pytest.approx(by_contacts[0])
    asked = life(solved_of("6310", "duty.load.fx=0 N", "life.fatigue_load_method=contacts"))
    assert asked.ratings.fatigue_of_set[0] == pytest.approx(by_contacts[0])
    assert asked.ratings.fatigue_by_contacts is None


def test_the_printed_fatigue_load_limit_leads() -> None:
    found = life(solved_of("NU 205 ECP", "duty.load.fx=0 N"))
    assert found.ratings.fatigue_of_set[0] == 3350.0
    assert found.rating_sources["fatigue"].startswith("SKF")
    given = life(solved_of("NU 205 ECP", "duty.load.fx=0 N", "life.fatigue_load_limit=3 kN"))
    assert given.ratings.fatigue_of_set[0] == 3000.0
    assert given.rating_sources["fatigue"] == "given"
    asked = life(solved_of("NU 205 ECP", "duty.load.fx=0 N", "life.fatigue_load_method=estimate"))
    assert asked.ratings.fatigue_of_set[0] == pytest.approx(27_000.0 / 8.2)


def test_rollers_are_estimated_by_their_own_share() -> None:
    found = life(solved_of("HR 30305 DJ"))
    assert found.ratings.fatigue_of_set[0] == pytest.approx(40_500.0 / 8.2)
    assert "C_0/8.2" in rating_source(found, "fatigue")


@pytest.mark.parametrize(
    ("designation", "method"),
    [("S 6012 C", "contacts"), ("EX 70 15deg", "contacts"), ("6310/HC5", "estimate")],
)
def test_a_known_interior_has_it_by_the_contacts_and_an_inferred_one_by_c_0(
    designation: str, method: str
) -> None:
    assert life(solved_of(designation)).rating_sources["fatigue"] == method


def test_an_interior_that_is_given_is_not_inferred() -> None:
    row = case_of("6310").bearing
    assert isinstance(row, Bearing)
    own = [
        f"bearing.ball_count={row.ball_count}",
        f"bearing.ball_diameter={1e3 * row.ball_diameter} mm",
        f"bearing.pitch_diameter={1e3 * row.pitch_diameter} mm",
    ]
    found = life(solved_of("6310", *own, "duty.load.fx=0 N"))
    assert found.rating_sources["fatigue"] == "contacts"
    assert found.ratings.fatigue_of_set[0] == pytest.approx(1986.0, rel=1e-3)


# --- what the letters say -------------------------------------------------------------------------


@pytest.mark.parametrize("designation", ["W 6205", "S6205-2RS", "SS 6205/C3", "SUC205"])
def test_stainless_steel_leads(designation: str) -> None:
    solved = solved_of(designation, "duty.load.fx=0 N")
    note = solved.notes[0][0]
    assert note.key == "stainless_rating"
    assert (note.values["low"], note.values["high"]) == (0.80, 0.85)
    assert "51" in note.text
    page = terminal(life_page(solved, life(solved)))
    assert page.index("stainless") < page.index("Life by theory")
    assert page.count("is of stainless steel") == 1
    assert "without_effect" not in {one.key for one in solved.notes[0]}
    geometry = geometry_of(designation)
    assert not {part for part, _ in geometry.idle} & {"W", "S", "SS", "SUC"}


@pytest.mark.parametrize("designation", ["6205", "S7014C", "S 6012 C", "7014 C/HC"])
def test_other_steel_is_not_called_stainless(designation: str) -> None:
    keys = {note.key for note in solved_of(designation).notes[0]}
    assert "stainless_rating" not in keys


def test_ratings_of_ones_own_are_those_of_stainless_steel() -> None:
    solved = solved_of("W 6205", "duty.load.fx=0 N", "life.dynamic_rating=11.5 kN")
    assert "stainless_rating" not in {note.key for note in solved.notes[0]}


def test_a_preload_that_no_list_has_stands_above_the_result() -> None:
    solved = solved_of("7014 C/HCP4A DBA")
    assert solved.notes[0][0].key == "designation_preload"
    page = terminal(state_page(solved))
    assert page.index("in no list here") < page.index("Inner ring")
    assert page.count("in no list here") == 1
    known = solved_of("7014 C DBL")
    of_designation = {"designation_preload", "pair_clearance_not_listed", "stainless_rating"}
    assert not {note.key for note in known.notes[0]} & of_designation


@pytest.mark.parametrize("letters", ["UA", "DUA"])
def test_a_of_universal_bearings_is_a_clearance(letters: str) -> None:
    """FAG's UA is no class of preload, and UO is neither."""
    geometry = geometry_of(f"B7014-C-T-P4S-{letters}")
    assert geometry.designation.letters.preload is None
    assert geometry.designation.letters.pair_clearance is not None
    solved = solved_of(f"B7014-C-T-P4S-{letters} DB")
    assert solved.notes[0][0].key == "pair_clearance_not_listed"
    alone = solved_of(f"B7014-C-T-P4S-{letters}")
    assert "pair_clearance_not_listed" not in {note.key for note in alone.notes[0]}
    set_so = solved_of(f"B7014-C-T-P4S-{letters} DB", "bearing.preload=-3 um")
    assert "pair_clearance_not_listed" not in {note.key for note in set_so.notes[0]}
    flush = geometry_of("B7014-C-T-P4S-UO").designation.letters
    assert flush.preload is None
    assert flush.pair_clearance is None
    # behind SKF's universal letter G it stays a class of preload
    assert geometry_of("7014 CDGA/P4A").designation.letters.preload is not None


# --- preload classes ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("designation", "level", "listed", "force"),
    [
        ("7014C DB", "light", "7014C", 290.0), ("7014C DB", "extra_light", "7014C", 145.0),
        ("EX 70 15deg DB", "medium", "EX 70", 800.0), ("7014C DF", "heavy", "7014C", 1470.0),
    ],
)  # fmt: skip
def test_a_level_alone_is_that_of_the_bearing(
    designation: str, level: str, listed: str, force: float
) -> None:
    case = case_of(designation, [f"bearing.preload.level={level}"])
    preload = case.bearing.preload
    assert preload == Preload(level=level, designation=listed)
    assert preload.pair_force(case.bearing.contact_angle) == force
    text = case_to_toml(case)
    assert parse_case(text).bearing.preload == preload
    record = Bearing.named(designation, preload=Preload(level=level))
    assert record.preload == preload


def test_levels_that_no_list_has_are_refused_with_what_there_is() -> None:
    with pytest.raises(InputError, match="extra_light, light, medium, heavy"):
        case_of("7014C DB", ["bearing.preload.level=A"])
    with pytest.raises(InputError, match="no maker's list"):
        case_of("7014A DB", ["bearing.preload.level=light"])
    row = 'ball_count = 20\nball_diameter = "11.9 mm"\npitch_diameter = "90 mm"\n'
    row += 'contact_angle = "15 deg"\ninner_conformity = 0.52\nouter_conformity = 0.52\n'
    row += 'arrangement = "DB"\nspacing = "20 mm"\npreload = { level = "light" }\n'
    with pytest.raises(InputError, match=r"preload\.designation"):
        parse_case(f'[bearing]\n{row}[duty.load]\nfx = "1 kN"\n')
    with pytest.raises(InputError, match="level of preload only"):
        Preload(force=100.0, designation="7014C")


# --- ends of tapered rollers ----------------------------------------------------------------------


def test_tapered_rollers_of_the_catalogue_end_in_a_sphere() -> None:
    row = case_of("32216").bearing
    assert isinstance(row, RollerBearing)
    assert row.roller_half_angle is not None
    sizes = (row.roller_diameter, row.roller_length, row.roller_half_angle)
    distance = 0.5 * row.roller_diameter / np.tan(row.roller_half_angle) + 0.5 * row.roller_length
    assert apex_distance(*sizes) == pytest.approx(distance)
    assert row.roller_end_radius == pytest.approx(0.95 * distance)
    assert row.roller_end_radius == pytest.approx(float(usual_end_radius(*sizes)))
    assert row.origins["roller_end_radius"] == "assumed"
    assert "roller_end_radius" in case_template("32216")
    result = CliRunner().invoke(app, ["catalogue", "show", "32216"])
    line = next(one for one in result.stdout.splitlines() if "radius of the roller ends" in one)
    assert line.endswith("assumed")


def test_only_catalogue_rollers_have_the_assumption() -> None:
    given = [
        'element = "tapered"', "roller_count = 16", 'roller_diameter = "17 mm"',
        'effective_length = "22.7 mm"', 'pitch_diameter = "108.5 mm"', 'contact_angle = "14 deg"',
    ]  # fmt: skip
    case = parse_case("[bearing]\n" + "\n".join(given) + '\n[duty.load]\nfx = "1 kN"\n')
    assert isinstance(case.bearing, RollerBearing)
    assert case.bearing.roller_end_radius is None
    cylinder = case_of("NU 205").bearing
    assert isinstance(cylinder, RollerBearing)
    assert cylinder.roller_end_radius is None
    own = case_of("32216", ["bearing.roller_end_radius=200 mm"]).bearing
    assert isinstance(own, RollerBearing)
    assert (own.roller_end_radius, own.origins["roller_end_radius"]) == (0.2, "given")


def test_the_ends_follow_rollers_of_ones_own_and_hold_in_sets() -> None:
    own = case_of("32216", ["bearing.roller_diameter=15 mm"]).bearing
    assert isinstance(own, RollerBearing)
    sizes = (0.015, own.roller_length, own.roller_half_angle or 0.0)
    assert own.roller_end_radius == pytest.approx(float(usual_end_radius(*sizes)))
    alone, pair = case_of("32216").bearing, case_of("32216 DB").bearing
    assert isinstance(alone, RollerBearing)
    for place in pair.places:
        assert isinstance(place.bearing, RollerBearing)
        assert place.bearing.roller_end_radius == alone.roller_end_radius
    written = parse_case(case_to_toml(case_of("32216", ["duty.load.fx=1 kN"])))
    assert written.bearing == case_of("32216").bearing


def test_the_film_at_the_rib_counts_by_default() -> None:
    oil = {"lubricant": {"name": "ISO VG 100", "base_oil": "ISO VG 100"}}
    case = Case.from_mapping(
        {
            "bearing": {"designation": "32216"},
            "duty": {"inner_speed": "500 rpm", "load": {"fx": "6 kN"}},
            **oil,
            "temperature": {"lubricant": "50 degC"},
            "surface": {
                "inner_roughness": "0.12 um",
                "outer_roughness": "0.12 um",
                "ball_roughness": "0.1 um",
            },
        }
    )
    found = friction(solve(case), friction_coefficient=0.2)
    # as Wingertszahn and others (2023) measured it: dry ends would be nearly twice that
    assert found.torque[0] == pytest.approx(1.30, rel=0.25)
    assert found.torque_by_source["rib"][0] < 0.1 * found.torque[0]


def test_a_batch_of_other_rollers_has_their_ends() -> None:
    """Row by row what a case of its own gives."""
    case = case_of("32216", ["duty.inner_speed=500 rpm", "duty.load.fx=6 kN"])
    lengths = np.array([0.020, 0.0225])
    batch = solve(case, {"bearing.effective_length": lengths})
    for index, length in enumerate(lengths):
        own = case_of("32216", ["duty.inner_speed=500 rpm", "duty.load.fx=6 kN",
                                f"bearing.effective_length={1e3 * length} mm"])  # fmt: skip
        one = solve(own)
        assert batch.displacement.x[index] == pytest.approx(one.displacement.x[0], rel=1e-9)
