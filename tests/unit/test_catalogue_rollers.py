"""Roller bearings of the catalogue: their names, what is inferred, ribs, clearance and spacing."""

from __future__ import annotations

import json
from math import cos, pi, tan
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rolamento import Case
from rolamento.case.roller_bearing import RollerBearing
from rolamento.catalogue import catalogue, catalogues, geometry_of, inferred_rollers
from rolamento.cli.catalogue import app
from rolamento.errors import InputError

HEADER = (
    "designation,kind,bore_mm,outside_diameter_mm,width_mm,inner_raceway_diameter_mm,"
    "outer_raceway_diameter_mm,dynamic_rating_N,static_rating_N\n"
)


def run(*arguments: str) -> str:
    result = CliRunner().invoke(app, [*arguments])
    assert result.exit_code == 0, result.output
    return result.stdout


@pytest.mark.parametrize(
    ("written", "listed"),
    [
        ("NU 205", "NU 205 EW"),
        ("nu205ecp", "NU 205 ECP"),
        ("SKF NU 205 ECP/C3", "NU 205 ECP"),
        ("NJ 2310 E.TVP2", "NJ 2310 ET"),
        ("N 210", "N 210"),
        ("30205", "HR 30205 J"),
        ("HR30205J", "HR 30205 J"),
        ("NSK 30205 J2/Q", "HR 30205 J"),
        ("320/28 X", "HR 320/28 XJ"),
        ("NA 4905", "NA 4905"),
        ("RNA4905", "RNA 4905"),
        ("HK 2020", "FJ-2020"),
        ("FJ-2020", "FJ-2020"),
    ],
)
def test_designations(written: str, listed: str) -> None:
    assert catalogue().find(written).bearing.designation == listed


def test_every_roller_bearing_finds_itself() -> None:
    for bearing in catalogue().bearings:
        if bearing.has_rollers:
            found = catalogue().find(f"{bearing.maker} {bearing.designation}").bearing
            assert (found.designation, found.kind) == (bearing.designation, bearing.kind)


def test_a_bore_behind_a_stroke_is_not_a_bore_code() -> None:
    """320/28 has 28 mm; 32028 would have 140 mm, and is in no list."""
    assert catalogue().find("320/28").bearing.bore == pytest.approx(0.028)
    with pytest.raises(InputError, match=r"did you mean|of a size"):
        catalogue().find("32099")


@pytest.mark.parametrize("name", ["NN 3210", "NU 2999", "K 500x510x20", "NA 4999", "20210"])
def test_rollers_of_no_list_are_named_as_such(name: str) -> None:
    with pytest.raises(InputError, match="roller bearing of a size or series in no list"):
        catalogue().find(name)


@pytest.mark.parametrize(
    ("name", "inner", "outer"),
    [
        ("NU 208", "none", "both"),
        ("NJ 208", "-", "both"),
        ("NUP 208", "both", "both"),
        ("N 208", "both", "none"),
        ("NF 208", "both", "+"),
    ],
)
def test_the_letters_say_where_the_ribs_are(name: str, inner: str, outer: str) -> None:
    fields = geometry_of(name).fields
    assert (fields["inner_ribs"], fields["outer_ribs"]) == (inner, outer)
    assert fields.get("axial_play") == (101e-6 if name == "NUP 208" else None)


def test_a_cylindrical_roller_bearing() -> None:
    """NU 205 EW by NSK: F_w = 31.5 mm is printed, E_w is not; SKF's NU 205 ECP has both."""
    found = geometry_of("SKF NU 205 ECP/C3")
    fields = found.fields
    listed = found.bearing
    assert listed.inner_raceway_diameter == pytest.approx(31.5e-3)
    assert listed.outer_raceway_diameter == pytest.approx(46.5e-3)
    assert (fields["roller_diameter"], fields["pitch_diameter"]) == pytest.approx((7.5e-3, 39e-3))
    assert fields["diametral_clearance"] == pytest.approx(47.5e-6)  # ISO 5753-1: 35 to 60 µm
    assert fields["roller_count"] in (12, 13)
    assert set(found.origins) >= set(fields) - {"element"}
    other = geometry_of("NSK NU 205 EW").fields
    assert (other["roller_diameter"], other["pitch_diameter"]) == pytest.approx((7.5e-3, 39e-3))


def test_a_pair_of_tapered_bearings_stands_by_its_load_centres() -> None:
    found = geometry_of("30205")
    fields, width = found.fields, found.width
    assert width == found.bearing.width == pytest.approx(16.25e-3)
    angle = fields["contact_angle"]
    assert tan(angle) == pytest.approx((found.bearing.axial_limit or 0.0) / 1.5, rel=1e-9)
    back = found.spacing("DB")
    assert back is not None
    assert back + (found.spacing("DF") or 0.0) == pytest.approx(2.0 * width)
    raceway = 0.5 * (fields["pitch_diameter"] + fields["roller_diameter"] * cos(angle))
    assert 0.5 * back + raceway * tan(angle) == pytest.approx(found.bearing.load_centre)
    assert found.spacing("DT") == width


@pytest.mark.parametrize("name", ["HK 2020", "RNA 4905"])
def test_bearings_without_a_ring_need_a_clearance(name: str) -> None:
    assert "diametral_clearance" not in geometry_of(name).fields
    assert geometry_of(f"{name}/C3").fields.get("diametral_clearance") is None
    with pytest.raises(InputError, match="shaft"):
        RollerBearing.named(name)
    assert RollerBearing.named(name, diametral_clearance=20e-6).roller_count > 10


def test_a_case_by_designation() -> None:
    case = Case.model_validate(
        {
            "bearing": {"designation": "NU 205/C3"},
            "duty": {"load": {"fy": "5 kN"}, "inner_speed": "3000 rpm"},
        }
    )
    bearing = case.bearing
    assert isinstance(bearing, RollerBearing)
    assert bearing.element == "cylindrical"
    assert bearing.diametral_clearance == pytest.approx(47.5e-6)
    assert bearing.origins["roller_count"] == "inferred"
    own = RollerBearing.named("NU 205/C3", roller_count=12, effective_length="8.2 mm")
    assert (own.roller_count, own.effective_length) == (12, pytest.approx(8.2e-3))


def test_needles_and_clearance_by_the_bore() -> None:
    fields = geometry_of("NA 4905").fields
    assert fields["element"] == "needle"
    assert fields["diametral_clearance"] == pytest.approx(32.5e-6)  # 25 mm: 20 to 45 µm
    assert fields["inner_ribs"] == "none"


def test_candidates_share_the_weight() -> None:
    found = inferred_rollers(catalogue().find("30205").bearing, most=50)
    assert [one.rank for one in found] == list(range(1, len(found) + 1))
    assert sum(one.weight for one in found) == pytest.approx(1.0)
    for one in found:
        low, high = one.effective_length_range
        assert low <= one.effective_length <= high
        assert one.roller_count * one.roller_diameter < pi * one.pitch_diameter


def test_a_catalogue_of_ones_own(tmp_path: Path) -> None:
    file = tmp_path / "own.csv"
    file.write_text(
        "# maker: ACME\n# source: drawing 8\n"
        + HEADER
        + "R-1,cylindrical,25,52,15,31.5,46.5,29300,27700\n"
    )
    own = catalogue().beside([file])
    fields = geometry_of("R-1", catalogue_of=own).fields
    assert fields["roller_diameter"] == pytest.approx(7.5e-3)
    assert fields["inner_ribs"] == "none"
    file.write_text(
        "# source: drawing 8\n" + HEADER + "R-1,cylindrical,25,52,15,46,31,29300,27700\n"
    )
    with pytest.raises(InputError, match="raceway"):
        catalogue().beside([file])


def test_balls_have_no_rollers() -> None:
    with pytest.raises(InputError, match="has balls, not rollers"):
        inferred_rollers(catalogue().find("6205").bearing)


@pytest.mark.parametrize("name", ["NU 205/C3", "30205", "NA 4905", "HK 2020", "SKF NU 205 ECP"])
@pytest.mark.parametrize(("language", "ball"), [("en", "ball"), ("pt", "esfera")])
def test_pages(name: str, language: str, ball: str) -> None:
    assert ball not in run("show", name, "--lang", language).lower()
    found = json.loads(run("show", name, "--json"))
    assert found["inside"]["roller_count"]["value"] > 10


def test_search_lists_rollers() -> None:
    shown = run("search", "NU 22", "--lang", "en")
    assert "NU 2205 ET" in shown


def test_a_tapered_bearing_without_an_angle_says_where_to_give_it(tmp_path: Path) -> None:
    file = tmp_path / "own.csv"
    header = "designation,kind,bore_mm,outside_diameter_mm,width_mm,dynamic_rating_kN"
    file.write_text(f"# source: drawing 8\n{header}\nT-1,tapered,25,52,16.25,32\n")
    with catalogues([file]):
        with pytest.raises(InputError, match="tell its contact angle"):
            RollerBearing.named("T-1", contact_angle=0.25)
        bearing = RollerBearing.named(
            "T-1", contact_angle=0.25, roller_count=17, roller_diameter=6e-3,
            effective_length=9e-3, pitch_diameter=38.5e-3,
        )  # fmt: skip
    assert bearing.element == "tapered"
