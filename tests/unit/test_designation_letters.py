"""What the letters of a designation do to a case: applied, without effect, or not understood."""

from __future__ import annotations

from math import degrees, radians

import pytest

from rolamento import Bearing, Case, Duty, InputError, Load, solve, studies
from rolamento.case import case_to_json, case_to_toml, override, parse_case
from rolamento.catalogue import catalogue, geometry_of, parse_designation
from rolamento.clearance import class_clearance, clearance_of_case


def _angle(text: str) -> float | None:
    angle = parse_designation(text).contact_angle
    return None if angle is None else round(degrees(angle))


@pytest.mark.parametrize(
    "text", ["6205/HC5C3", "6205 HC5 C3", "HC6205/C3", "6205/C3SN24", "SKF 6205/HC5C3", "5S-6205C3"]
)
def test_ceramic_balls_are_solved_as_such(text: str) -> None:
    bearing = Bearing.named(text)
    assert (bearing.ball_material.name, bearing.ring_material.name) == ("Si3N4", "100Cr6")
    assert bearing.origins["ball_material"] == "designation"
    assert bearing.clearance_class == "C3"
    steel = Bearing.named(text, ball_material="100Cr6")
    assert (steel.ball_material.name, steel.origins["ball_material"]) == ("100Cr6", "given")


def test_ceramic_balls_survive_files_studies_and_settings() -> None:
    case = Case(bearing=Bearing.named("6205/HC5C3"), duty=Duty(load=Load(fz=2000.0)))
    for again in (
        parse_case(case_to_toml(case), format="toml"),
        parse_case(case_to_json(case), format="json"),
        override(case, ["duty.load.fz=1 kN"]).with_({"duty.load.fz": 2000.0}),
        studies.Study.from_mapping(
            studies.Study(
                case=case, axes=[studies.Axis(field="duty.load.fz", values=[1.0])], outputs=("fx",)
            ).to_mapping()
        ).case,
    ):
        assert again.bearing == case.bearing
    assert "ball_material" not in case.to_mapping()["bearing"]
    steel = override(case, ["bearing.designation=6205/C3"])
    assert steel.bearing.ball_material.name == "100Cr6"


@pytest.mark.parametrize(
    ("text", "arrangement"),
    [
        ("7014 CD/P4ADBA", "DB"),
        ("7014CTYNDFLP4", "DF"),
        ("7014CDBLP4", "DB"),
        ("7014C DT", "DT"),
        ("7014 CD/P4AQBCA", "QBC"),
        ("7014 CD/P4ATBTB", "TBT"),
        ("7014CTYNDBDLP4", "TBT"),
        ("7014CTYNDBBLP4", "QBC"),
        ("7014 CD/P4ADBB", "DB"),
        ("7010UCDB/GLP4", "DB"),
        ("7206 BDB", "DB"),
        ("6206 DB", "DB"),
    ],
)
def test_sets_are_arranged_side_by_side(text: str, arrangement: str) -> None:
    bearing = Bearing.named(text)
    published = bearing.published
    assert published is not None
    assert bearing.arrangement == arrangement
    assert bearing.spacing == published.width
    assert (bearing.origins["arrangement"], bearing.origins["spacing"]) == (
        "designation",
        "assumed",
    )
    assert len(bearing.places) == len(Bearing.named("7014C", arrangement=arrangement).places)
    apart = bearing.replace(spacing=0.040)
    assert (apart.spacing, apart.arrangement) == (0.040, arrangement)


def test_a_set_of_ones_own_has_its_spacing_too() -> None:
    assert Bearing.named("S 6014 C", arrangement="DB").spacing == 0.020  # GMN prints no width
    assert Bearing.named("7014C DB", arrangement="DF").arrangement == "DF"
    rows = [{"position": -0.01}, {"position": 0.01, "orientation": "-"}]
    listed = Bearing.named("7014C DB", rows=rows)
    assert (listed.arrangement, len(listed.places)) == (None, 2)


@pytest.mark.parametrize(
    ("text", "level", "force"),
    [
        ("7014CTYNDBELP4", "extra_light", 145.0),
        ("7014CTYNDBLP4", "light", 290.0),
        ("7206CDBMP5", "medium", 290.0),
        ("7914CTYNDFHP4", "heavy", 980.0),
        ("S 6014 C TA P4 DBL", "light", 240.0),
        ("EX 70 15deg DBF", "heavy", 1600.0),
    ],
)
def test_the_makers_preload_is_applied(text: str, level: str, force: float) -> None:
    bearing = Bearing.named(text)
    assert bearing.preload is not None
    assert bearing.preload.level == level
    assert bearing.preload.pair_force(bearing.contact_angle) == force
    assert bearing.origins["preload"] == "designation"
    assert Bearing.named(text, preload="500 N").preload.force == 500.0  # type: ignore[union-attr]


def test_what_has_no_effect_and_what_is_not_understood_is_said_once() -> None:
    case = Case(
        bearing=Bearing.named("7014 CD/P4ADBA-XYZ"), duty=Duty(load=Load(fx=500.0, fz=500.0))
    )
    notes = {note.key: note for note in solve(case).notes[0]}
    assert [part for part, _ in notes["designation_without_effect"].values["parts"]] == ["P4A"]
    assert notes["designation_preload"].values["part"] == "A"
    assert notes["designation_not_understood"].values["parts"] == ["XYZ"]
    assert notes["designation_listed_as"].values["listed"] == "EX 70 15deg"
    assert "P4A: tolerance class 4A of the maker" in notes["designation_without_effect"].text
    preloaded = solve(case.with_({"bearing.preload": "300 N"})).notes[0]
    assert "designation_preload" not in {note.key for note in preloaded}
    plain = solve(Case(bearing=Bearing.named("6205/C3"), duty=Duty(load=Load(fz=500.0))))
    assert not any(note.key.startswith("designation") for note in plain.notes[0])


@pytest.mark.parametrize(
    ("bore", "low", "high"),
    [(0.010, 4, 11), (0.018, 4, 11), (0.025, 5, 12), (0.050, 9, 17), (0.080, 12, 22),
     (0.100, 18, 30), (0.120, 18, 30), (0.160, 24, 38)],
)  # fmt: skip
def test_motor_clearance(bore: float, low: float, high: float) -> None:
    """NSK, Rolling Bearings (CAT. No. E1102e), table 9.13.1."""
    band = class_clearance(bore, "CM")
    assert (band.low, band.high) == pytest.approx((low * 1e-6, high * 1e-6))


@pytest.mark.parametrize("bore", [0.009, 0.161, 0.5])
def test_motor_clearance_has_its_bores(bore: float) -> None:
    with pytest.raises(InputError, match="has no range for a bore of"):
        class_clearance(bore, "CM")


@pytest.mark.parametrize("text", ["6205-C-2HRS-C3", "6205EEC3"])
def test_seals_of_other_makers(text: str) -> None:
    letters = parse_designation(text).letters
    assert letters.clearance_class == "C3"
    assert [part.meaning for part in letters.parts] == ["contact seals on both sides"]


@pytest.mark.parametrize("text", ["6205DDUCM NSK", "6205ZZCM", "6205 CM", "6205LLUCM/L047"])
def test_motor_clearance_of_a_designation(text: str) -> None:
    bearing = Bearing.named(text)
    assert bearing.diametral_clearance == pytest.approx(8.5e-6)
    assert bearing.clearance_class == "CM"


def test_motor_clearance_in_a_mounting() -> None:
    case = parse_case(
        '[bearing]\ndesignation = "6205ZZCM"\n[mounting]\nshaft_tolerance = "k5"\n[duty]\n'
    )
    first = clearance_of_case(case).steps[0]
    assert first.clearance == pytest.approx((5e-6, 8.5e-6, 12e-6))
    assert "NSK, Rolling Bearings" in first.source.text
    assert "CM" in first.source.text


@pytest.mark.parametrize(
    ("text", "number", "angle"),
    [
        ("7014 CD/P4ADBA", "7014", 15),
        ("S7014 ACE/HCP4A", "7014", 25),
        ("71914 CB/HCP4A", "71914", 15),
        ("7014 FE/HCP4A", "7014", 18),
        ("70BNR10HTYNDBELP4", "7014", 18),
        ("70BER19STYNSULP4", "7914", 25),
        ("7014CTYNDULP4", "7014", 15),
        ("7014A5TRDUMP3", "7014", 25),
        ("B7014-C-T-P4S-UL", "7014", 15),
        ("HCB71914-E-T-P4S-DUL", "71914", 25),
        ("B71914-E", "71914", 25),
        ("HY S 6014 C", "", None),
        ("5S-7014UADDB/GLP42", "7014", 25),
        ("2LA-HSB014C/GNP42", "7014", 15),
        ("7210BECBM", "7210", 40),
        ("7210ADB", "7210", 30),
    ],
)
def test_numbers_and_angles_of_spindle_bearings(text: str, number: str, angle: int | None) -> None:
    designation = parse_designation(text)
    assert (designation.number, _angle(text)) == (number, angle)
    assert designation.unknown == ()


@pytest.mark.parametrize(
    ("text", "maker", "listed"),
    [
        ("7014C", "NSK", "7014C"),
        ("71914 C", "NSK", "7914C"),
        ("B7014-C-T-P4S-UL", "NSK", "7014C"),
        ("7914A5", "NSK", "7914A5"),
        ("71914-E", "NSK", "7914A5"),
        ("7014 CD/P4ADBA", "SNFA", "EX 70 15deg"),
        ("7014 ACD/P4A", "SNFA", "EX 70 25deg"),
        ("71914 ACD/HCP4A", "SNFA", "SEB 70 25deg"),
        ("71814 CD/P4", "SNFA", "SEA 70 15deg"),
        ("7214 CD/P4A", "SNFA", "E 270 15deg"),
        ("HY S 6014 C TA P4 UL", "GMN", "S 6014 C"),
    ],
)
def test_where_the_balls_are_from(text: str, maker: str, listed: str) -> None:
    bearing = Bearing.named(text).published
    assert bearing is not None
    assert (bearing.maker, bearing.designation) == (maker, listed)


@pytest.mark.parametrize(
    ("text", "sister"),
    [
        ("7014A5", "S 6014 E"),
        ("HCB7014-E-T-P4S-DUL", "S 6014 E HC UL"),
        ("S7014 ACE/HCP4ADBA", "VEX 70 25deg HC DB"),  # of the high-speed design
        ("70BNR10HTYNDBMP4", "VEX 70 15deg HC DBM"),
    ],
)
def test_a_sister_is_offered_and_not_taken(text: str, sister: str) -> None:
    with pytest.raises(InputError, match="neither published balls nor load ratings") as caught:
        Bearing.named(text)
    assert caught.value.value == text
    assert caught.value.example == f'designation = "{sister}"'
    accepted = Bearing.named(sister)  # what the message says to write
    assert accepted.origins["ball_count"] == "published"
    without = geometry_of(text, with_balls=False)
    assert sister.startswith(without.sisters[0].designation)
    assert accepted.arrangement == without.fields.get("arrangement")
    assert accepted.ball_material.name == without.fields.get("ball_material", "100Cr6")
    assert accepted.published is not None
    assert accepted.published.bore == without.bearing.bore


def test_sisters_beside_an_inferred_interior() -> None:
    names = [bearing.designation for bearing in geometry_of("7014C").sisters]
    assert {"S 6014 C", "EX 70 15deg"} <= set(names)
    assert not any("25deg" in name or name.endswith("E") for name in names)
    assert geometry_of("S 6014 C").sisters == ()
    assert catalogue().sisters(catalogue().find("6205").bearing) == ()


RATED = """
[bearing]
designation = "{}"
[duty.load]
fx = "500 N"
fz = "500 N"
[life]
dynamic_rating = "{}"
static_rating = "{}"
"""


def test_ratings_of_the_case_are_inferred_from() -> None:
    """With NSK's ratings of 7014A, 30 degrees, under a number that has none: NSK's balls."""
    listed = geometry_of("7014A").fields
    case = parse_case(RATED.format("7014 30deg /XL", "44 kN", "41.5 kN"))
    assert case.bearing.ball_count == listed["ball_count"]
    text = RATED.format("7014A5", "45 kN", "41 kN")
    case = parse_case(text)
    assert case.bearing.origins["ball_count"] == "inferred"
    assert case.bearing.from_given_ratings
    assert case.bearing.contact_angle == pytest.approx(radians(25.0))
    notes = {note.key for note in solve(case).notes[0]}
    assert "geometry_estimated_from_given" in notes
    again = parse_case(case_to_toml(case), format="toml")
    assert again == case
    assert case.with_({"duty.load.fx": "400 N"}).bearing == case.bearing
    smaller = case.with_({"life.dynamic_rating": "30 kN", "life.static_rating": "30 kN"})
    assert smaller.bearing.ball_diameter < case.bearing.ball_diameter
    assert case.replace(life=smaller.life).bearing == smaller.bearing
    with pytest.raises(InputError, match="neither published balls nor load ratings"):
        case.with_({"life.dynamic_rating": None, "life.static_rating": None})


def test_ratings_of_the_case_serve_deep_groove_numbers_in_no_list() -> None:
    """NSK's list here ends before 6226; ratings of about that size give its balls."""
    with pytest.raises(InputError, match=r"give life\.dynamic_rating"):
        Bearing.named("6226")
    case = parse_case(RATED.format("6226/C3", "156 kN", "132 kN"))
    assert case.bearing.origins["ball_diameter"] == "inferred"
    assert case.bearing.clearance_class == "C3"
    pitch = case.bearing.pitch_diameter
    assert pitch == pytest.approx(0.180, rel=0.03)  # (130 + 230)/2


def test_ratings_of_the_case_leave_listed_bearings_alone() -> None:
    case = parse_case(RATED.format("6205", "20 kN", "10 kN"))
    assert case.bearing == Bearing.named("6205")


@pytest.mark.parametrize("rating", ["-5 kN", "5 kg", "1e300 kN", "nan N", "x"])
def test_impossible_ratings_are_refused_by_their_own_field(rating: str) -> None:
    with pytest.raises(InputError):
        parse_case(RATED.format("7014A5", rating, "41 kN"))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("7014", "does not say its contact angle: write 7014C"),
        ("7014 XYZ", "does not say its contact angle"),
        ("7230C", r"give life\.dynamic_rating"),
        ("7014C9", "no clearance class"),
    ],
)
def test_what_is_missing_is_named(text: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        Bearing.named(text)
