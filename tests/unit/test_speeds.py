"""Limiting speeds and minimum loads: limits, data, the task, the command and its page."""

from __future__ import annotations

import json
from math import nan, pi
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rolamento import InputError, load_case, parse_case, solve
from rolamento.analysis.speed_limits import limiting_speeds, speed_limits
from rolamento.case import case_of
from rolamento.case.bearing import Bearing
from rolamento.case.preload_classes import level_of_force
from rolamento.cli.app import app
from rolamento.document.terminal import terminal
from rolamento.io.data import toml_of
from rolamento.pages.speed import speed_page
from rolamento.ratings import dynamic_rating, roller_dynamic_rating, static_rating
from rolamento.speeds import (
    ceramic_factor,
    general_minimum_shares,
    heat_shares,
    minimum_axial_load,
    minimum_axial_load_of_thrust,
    minimum_load_factors,
    minimum_radial_load,
    reference_coefficients,
    reference_heat_flow,
    set_factor,
    speed_class,
    speed_ratio,
    thermal_reference_speed,
)
from rolamento.words.headlines import qualifies

RPM = pi / 30.0
WARM = ["lubricant=ISO VG 32", "temperature.lubricant=70 degC"]


def test_under_reference_conditions_nothing_is_to_correct() -> None:
    """K_L + K_P = 1, so that the permissible speed is the reference speed."""
    coefficients = reference_coefficients("62")
    assert coefficients is not None
    speed = thermal_reference_speed(0.05, 0.09, 0.02, 23_200.0, coefficients)
    shares = heat_shares(
        speed,
        0.07,
        reference_heat_flow(0.05, 0.09, 0.02),
        viscosity=12e-6,
        load=0.05 * 23_200.0,
        f_0=coefficients.f_0r,
        f_1=coefficients.f_1r,
    )
    assert sum(shares) == pytest.approx(1.0, rel=1e-9)
    assert speed_ratio(*shares) == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize(("lubricant", "load"), [(0.3, 0.2), (1e-6, 4.0), (50.0, 0.0), (0.0, 0.5)])
def test_the_ratio_solves_its_equation(lubricant: float, load: float) -> None:
    f = speed_ratio(lubricant, load)
    assert lubricant * f ** (5.0 / 3.0) + load * f == pytest.approx(1.0, rel=1e-12)


@pytest.mark.parametrize(("lubricant", "load"), [(0.0, 0.0), (-1.0, 0.5), (nan, 0.5)])
def test_shares_that_are_none(lubricant: float, load: float) -> None:
    with pytest.raises(InputError):
        speed_ratio(lubricant, load)


def test_heat_flow_density_falls_on_large_bearings() -> None:
    """At the knee both forms agree; beyond it the flow grows with A^0.66."""
    width = 50_000e-6 / (pi * 0.5)
    knee = reference_heat_flow(0.2, 0.3, width)
    assert knee == pytest.approx(800.0, rel=1e-9)
    assert reference_heat_flow(0.2, 0.3, 2.0 * width) == pytest.approx(knee * 2.0**0.66, rel=1e-9)


def test_reference_speed_refuses_what_is_no_bearing() -> None:
    coefficients = reference_coefficients("62")
    assert coefficients is not None
    for sizes in ((0.05, 0.04, 0.02, 1e4), (0.0, 0.09, 0.02, 1e4), (0.05, 0.09, 0.02, nan)):
        with pytest.raises(InputError):
            thermal_reference_speed(*sizes, coefficients)
    assert reference_coefficients("70") is None


def test_printed_limiting_speeds_lie_near_their_class() -> None:
    """n d_m is a class only if it hardly changes with the size: within 12 % of the mean."""
    for row in toml_of("speeds")["classes"]["series"]:
        angle = row.get("contact_angle_deg")
        found = speed_class(row["series"][0], None if angle is None else angle * pi / 180.0)
        assert found is not None
        for one in row["bearings"]:
            mean = 0.5e-3 * (one["d"] + one["D"])
            for lubrication, product in (("grease", found.grease), ("oil", found.oil_bath)):
                assert one[lubrication] * RPM * mean == pytest.approx(product, rel=0.12)


def test_classes_of_sets_and_angles() -> None:
    alone = speed_class("70", 15.0 * pi / 180.0)
    steep = speed_class("70", 30.0 * pi / 180.0)
    assert alone is not None
    assert steep is not None
    assert steep.grease < alone.grease < alone.oil_bath < alone.high_speed
    # 7010 C in pairs: 10 000 and 14 000 rpm (NSK E1102, page B54)
    matched = set_factor(2, None)
    assert (matched.name, matched.level) == ("matched", "")
    assert matched.value * alone.grease / 0.065 / RPM == pytest.approx(10_000, rel=0.05)
    assert matched.value * alone.oil_bath / 0.065 / RPM == pytest.approx(14_000, rel=0.05)
    assert speed_class("70", None) is None
    assert speed_class("99", None) is None


def test_preload_sets_and_ceramic_balls_by_gmn() -> None:
    """GMN, limiting speed for spindle bearings, f_n2 and f_n4, figure by figure."""
    assert ceramic_factor().value == 1.25
    assert set_factor(2, "spring") == ("spring", 1.0, "")
    pairs = {level: set_factor(2, level).value for level in ("light", "medium", "heavy")}
    assert pairs == {"light": 0.8, "medium": 0.7, "heavy": 0.5}
    for count in (3, 4):  # the lowest of its lines of sets of more than two
        sets = {level: set_factor(count, level).value for level in ("light", "medium", "heavy")}
        assert sets == {"light": 0.6, "medium": 0.5, "heavy": 0.3}
    for unknown in (None, "extra_light", "A"):
        assert set_factor(2, unknown) == set_factor(4, unknown) == ("matched", 0.82, "")
    assert set_factor(4, "spring").name == "matched"


def test_a_force_has_the_lightest_class_that_reaches_up_to_it() -> None:
    angle = 15.0 * pi / 180.0
    # 47 kN: light to 0.63 %, medium to 1.68 %, heavy to 3.36 % of C
    levels = [level_of_force(share * 47e3, 47e3, angle) for share in (1e-6, 0.0062, 0.0064, 0.02)]
    assert levels == ["light", "light", "medium", "heavy"]
    assert level_of_force(0.04 * 47e3, 47e3, angle) is None
    assert level_of_force(100.0, 47e3, 40.0 * pi / 180.0) is None


def _limits(designation: str, *settings: str) -> dict[str, float]:
    found = speed_limits(designation, settings)
    return {one.name: one.speed / RPM for one in found.limits}


def test_what_a_designation_says_is_considered_or_said_not_to_be() -> None:
    alone, hybrid = _limits("7014C"), _limits("7014C/HCP4A")
    for name in ("grease", "oil_bath", "high_speed"):
        assert hybrid[name] == pytest.approx(1.25 * alone[name])
    light, heavy = _limits("7014C DBL"), _limits("7014C DBH")
    assert light["high_speed"] == pytest.approx(0.8 * alone["high_speed"])
    assert heavy["grease"] == pytest.approx(0.5 * alone["grease"])
    sprung = _limits("7014C DB", 'bearing.preload={spring="240 N"}')
    assert sprung == pytest.approx(alone)
    assert _limits("7014C DB", "bearing.preload=240 N") == pytest.approx(light)

    found = speed_limits("7014C/HCP4ADBA")
    assert [one.name for one in found.limits] == ["grease", "oil_bath"]
    assert [factor.name for factor in found.limits[0].factors] == ["matched", "ceramic"]
    note = found.notes[0]
    assert note.key == "speed_class_leaves_out"
    assert [part for part, _ in note.values["parts"]] == ["P4A"]
    assert note.values["preload"]
    assert not note.values["ceramic"]
    page = terminal(speed_page(found))
    assert page.index("P4A") < page.index("Limits of the speed")
    assert "×1.25 (GMN)" in page
    assert found.to_mapping()["limits"][0]["factors"][1] == {
        "name": "ceramic",
        "value": 1.25,
        "level": "",
    }


@pytest.mark.parametrize(
    ("designation", "left_out"),
    [
        ("6205-2RS1", {"2RS1"}), ("6205/HC5", {"ceramic"}), ("6205 DB", {"rows"}),
        ("30206 DB", {"rows"}), ("6205", set()), ("6205/C3", set()), ("S 6012 C DUM", set()),
        ("7014CTYNP4", {"TYN", "P4"}), ("NU 205 ECP", {"P"}),
    ],
)  # fmt: skip
def test_what_no_table_knows_leads(designation: str, left_out: set[str]) -> None:
    found = speed_limits(designation)
    values = next(
        (note.values for note in found.notes if note.key == "speed_class_leaves_out"),
        {"parts": []},
    )
    named = {part for part, _ in values["parts"]}
    named |= {name for name in ("rows", "ceramic") if values.get(name)}
    assert named == left_out


@pytest.mark.parametrize("designation", ["6310", "7014C", "NU 205", "51210"])
def test_limits_of_any_load_are_those_of_the_page(designation: str) -> None:
    settings = ["duty.load.fz=1 kN", "duty.inner_speed=1000 rpm", "lubricant=ISO VG 68",
                "temperature.lubricant=70 degC"]  # fmt: skip
    case = case_of(designation, settings)
    of_page = tuple(one for one in speed_limits(case).limits if one.name != "permissible")
    assert limiting_speeds(case) == of_page


def test_a_limit_above_leads() -> None:
    found = speed_limits("6210", ["duty.inner_speed=20000 rpm"])
    assert found.notes[0].key == "speed_above_limits"
    page = terminal(speed_page(found))
    assert page.index("The speed is above") < page.index("Limits of the speed")
    assert page.count("The speed is above") == 1
    limits = " ".join(page.partition("The speed is above")[2].partition(".")[0].split())
    assert {"limiting speed, grease", "limiting speed, oil bath"} <= {*limits.split("; ")}


@pytest.mark.parametrize(
    ("designation", "series", "rows"),
    [
        ("QJ 210", "QJ2", 1), ("QJ 310", "QJ3", 1), ("3210", "32", 1), ("5210", "52", 1),
        ("1210", "12", 1), ("2310", "23", 1), ("7014C DBL", "70", 2), ("S 6012 C", "70", 1),
        ("EX 70 15deg", "70", 1), ("NU 205 ET", "NU2", 1), ("51210", "512", 1),
    ],
)  # fmt: skip
def test_series_and_bearings_side_by_side(designation: str, series: str, rows: int) -> None:
    boundary = speed_limits(designation).boundary
    assert (boundary.series, boundary.rows) == (series, rows)


def test_two_rows_of_one_bearing_are_rated_once() -> None:
    """C of a list is that of both rows, C_0 of QJ that of both pairs of arcs."""
    double = speed_limits("3210", ["duty.load.fz=1 kN"])
    assert double.boundary.dynamic_rating == 53e3
    assert double.minimum_loads[0].load == pytest.approx(530.0)
    four_point = speed_limits("QJ 210").boundary
    row = case_of("QJ 210").bearing
    assert isinstance(row, Bearing)
    sizes = (row.ball_count, row.ball_diameter, row.pitch_diameter, row.contact_angle)
    assert four_point.static_rating == pytest.approx(2.0 * static_rating(*sizes))
    assert four_point.dynamic_rating == pytest.approx(2.0**0.7 * dynamic_rating(*sizes))


def test_a_size_alone_borrows_no_series_of_another_kind() -> None:
    case = parse_case(
        '[bearing]\nkind = "four_point"\nball_count = 14\nball_diameter = "12.7 mm"\n'
        'pitch_diameter = "70 mm"\ncontact_angle = "35 deg"\nshim_angle = "20 deg"\n'
        'inner_conformity = 0.52\nouter_conformity = 0.52\n[duty.load]\nfx = "1 kN"\n'
        '[film]\nstarvation = "replenishment"\nsupply = "bath"\n'
        'bore = "50 mm"\noutside_diameter = "90 mm"\n'
    )
    found = speed_limits(case)
    assert found.boundary.series == ""
    assert not found.limits
    assert [note.key for note in found.notes if qualifies(note)] == ["no_series_for_speed"]
    assert speed_limits(case, series="QJ2", width=0.02).limits[0].name == "reference"


def test_minimum_loads_by_hand() -> None:
    # 6310 at 1480 rpm in oil of 50 mm²/s: 0.03 (74)^(2/3) 0.8² kN
    found = minimum_radial_load(0.03, 50e-6, 1480.0 * RPM, 0.08)
    assert found == pytest.approx(1e3 * 0.03 * 74.0 ** (2.0 / 3.0) * 0.64, rel=1e-9)
    # 7210 B: 1.4 · 28 500/1000 (4200 · 70/1e5)² N
    found = minimum_axial_load(1.4, 28_500.0, 4200.0 * RPM, 0.07)
    assert found == pytest.approx(1.4 * 28.5 * 2.94**2, rel=1e-9)
    assert minimum_axial_load_of_thrust(12.0, 2000.0 * RPM) == pytest.approx(48.0)
    assert minimum_load_factors("63", None).radial == 0.03
    assert minimum_load_factors("72", 15.0 * pi / 180.0).axial is None
    assert minimum_load_factors("72", 40.0 * pi / 180.0).axial == 1.4


def test_a_designation_is_enough() -> None:
    found = speed_limits("6210", [*WARM, "duty.inner_speed=6000 rpm", "duty.load.fz=2 kN"])
    names = [one.name for one in found.limits]
    assert names == ["reference", "permissible", "grease", "oil_bath", "high_speed"]
    assert found.n_dm == pytest.approx(420_000.0)
    assert found.boundary.series == "62"
    reference = found.limits[0]
    assert reference.speed / RPM == pytest.approx(8200, rel=0.015)
    assert reference.share == pytest.approx(6000.0 * RPM / reference.speed)
    assert all(one.enough for one in found.minimum_loads)
    light = speed_limits("6210", [*WARM, "duty.inner_speed=6000 rpm", "duty.load.fz=100 N"])
    assert "load_below_minimum" in {note.key for note in light.notes}
    fast = speed_limits("6210", [*WARM, "duty.inner_speed=9000 rpm", "duty.load.fz=2 kN"])
    above = next(note for note in fast.notes if note.key == "speed_above_limits")
    assert "reference" in above.values["limits"]


def test_more_load_and_thicker_oil_lower_the_permissible_speed() -> None:
    def permissible(*more: str) -> float:
        found = speed_limits("6210", [*WARM, "duty.load.fz=2 kN", *more])
        return next(one.speed for one in found.limits if one.name == "permissible")

    assert permissible("duty.load.fz=6 kN") < permissible()
    assert permissible("lubricant=ISO VG 220") < permissible()


PAIR = """
[bearing]
ball_count = 20
ball_diameter = "11.906 mm"
pitch_diameter = "90 mm"
contact_angle = "15 deg"
inner_conformity = 0.52
outer_conformity = 0.52
arrangement = "DB"
spacing = "20 mm"
preload = "250 N"
[mounting]
bore = "70 mm"
outside_diameter = "110 mm"
width = "20 mm"
[duty]
inner_speed = "15000 rpm"
"""


def test_a_set_by_its_size(tmp_path: Path) -> None:
    found = speed_limits(parse_case(PAIR))
    assert found.boundary.series == "70"  # as 6014 has this size
    assert found.n_dm == pytest.approx(1.35e6)
    assert [one.name for one in found.limits] == ["grease", "oil_bath", "high_speed"]
    assert found.limits[0].factors[0].level == "light"  # 250 N
    keys = {note.key for note in found.notes}
    assert {"no_reference_coefficients", "speed_above_limits", "preload_for_minimum_load"} <= keys
    page = terminal(speed_page(found))
    assert "1.35 million mm·rpm" in page
    path = tmp_path / "pair.toml"
    path.write_text(PAIR, encoding="utf-8")
    result = CliRunner().invoke(app, ["speed", str(path), "--json", "-"])
    assert result.exit_code == 0
    mapping = json.loads(result.stdout)
    assert mapping["n_dm"] == pytest.approx(1.35e6)
    assert mapping["limits"][0]["share"] > 2.0


def test_the_command_takes_what_nobody_tells() -> None:
    run = CliRunner().invoke
    result = run(app, ["speed", "6210", "--speed", "6000 rpm", "--fr", "2 kN"])
    assert result.exit_code == 0
    assert "thermal reference speed" in result.stdout
    assert "--lubricant" in result.stdout  # what the permissible speed lacks
    result = run(app, ["speed", "6210", "--width", "-3 mm"])
    assert (result.exit_code, "greater than zero" in result.stderr) == (2, True)
    result = run(app, ["speed", "6210", "--width", "3 kg"])
    assert (result.exit_code, "--width" in result.stderr) == (2, True)


# --- rollers --------------------------------------------------------------------------------------


def test_roller_bearings_by_their_designation() -> None:
    found = speed_limits("NU 205", [*WARM, "duty.inner_speed=8000 rpm", "duty.load.fz=2 kN"])
    names = [one.name for one in found.limits]
    assert names == ["catalogue", "reference", "permissible", "grease", "oil_bath"]
    assert found.limits[1].speed / RPM == pytest.approx(11_800, rel=0.015)
    assert found.boundary.series == "NU2"
    (rule,) = found.minimum_loads
    ratio = 8000.0 * RPM / found.limits[1].speed
    assert rule.load == pytest.approx(1e3 * 0.15 * (6.0 + 4.0 * ratio) * 0.385**2, rel=1e-9)
    tapered = speed_limits("30205", ["duty.inner_speed=8000 rpm", "duty.load.fz=200 N"])
    assert tapered.boundary.width == pytest.approx(16.25e-3)
    assert tapered.minimum_loads[0].load == pytest.approx(0.02 * tapered.boundary.dynamic_rating)
    note = next(note for note in tapered.notes if note.key == "load_below_minimum")
    assert "rollers" in note.text
    assert "Minimum load" in terminal(speed_page(tapered))


def test_coefficients_and_factors_that_no_print_supports_are_named() -> None:
    keys = {note.key for note in speed_limits("32205").notes}
    assert "reference_coefficients_unchecked" in keys
    keys = {note.key for note in speed_limits("NU 1005", ["duty.inner_speed=1000 rpm"]).notes}
    assert "minimum_load_factors_unchecked" in keys
    assert "reference_coefficients_unchecked" not in keys


def test_ratings_of_rollers_without_a_designation() -> None:
    case = parse_case(
        '[bearing]\nelement = "needle"\nroller_count = 20\nroller_diameter = "3 mm"\n'
        'effective_length = "12 mm"\npitch_diameter = "30 mm"\ndiametral_clearance = "20 um"\n'
        '[duty.load]\nfz = "100 N"\n'
    )
    found = speed_limits(case)
    rating = float(roller_dynamic_rating(20, 3e-3, 12e-3, 30e-3, kind="needle"))
    assert found.minimum_loads[0].load == pytest.approx(0.02 * rating)


def test_different_elements_are_asked_for_alone() -> None:
    with pytest.raises(InputError, match="ask for each bearing alone"):
        speed_limits(
            parse_case(
                '[bearing]\nrows = [\n{ designation = "6205", position = "-10 mm" },\n'
                '{ designation = "NU 205", element = "cylindrical", position = "10 mm" }]\n'
                '[duty.load]\nfz = "1 kN"\n'
            )
        )


def test_makers_ask_alike_of_all_bearings() -> None:
    rules = {one.maker: one.share for one in general_minimum_shares("cylindrical")}
    assert rules == {"SKF": 0.02, "Schaeffler": 0.02}
    assert {one.share for one in general_minimum_shares("ball")} == {0.01}


def test_without_a_cage_schaeffler_asks_for_more() -> None:
    rules = {one.maker: one.share for one in general_minimum_shares("cylindrical", True)}
    assert rules["Schaeffler"] == 2.0 * rules["SKF"]


def test_general_rules_stand_beside_the_case_and_warn_of_nothing() -> None:
    changes = {"duty.load.fz": "1 kN", "duty.inner_speed": "3000 rpm"}
    found = speed_limits("NU210", changes)
    skf = found.general_loads[0]
    assert skf.load == pytest.approx(0.02 * found.boundary.dynamic_rating)
    assert not skf.enough
    assert "load_below_minimum" not in {note.key for note in found.notes}


def test_the_cage_slips_where_friction_moves_the_balls() -> None:
    changes = {"model.raceway_control": "friction", "lubricant.kind": "dry",
               "lubricant.friction_coefficient": 0.06}  # fmt: skip
    case = load_case("src/rolamento/examples/218_combined.toml", changes)
    slip = speed_limits(case).cage_slip
    assert slip is not None
    assert slip == pytest.approx(float(solve(case).rolling.skid[0]))  # type: ignore[union-attr]
    assert speed_limits(case.with_({"model.raceway_control": "outer"})).cage_slip is None
