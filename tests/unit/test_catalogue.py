"""The catalogue: designations, search, users' files, and what is said of a bearing's inside."""

from __future__ import annotations

import dataclasses
import re
from math import degrees
from pathlib import Path

import numpy as np
import pytest

from rolamento.catalogue import (
    CatalogueBearing,
    ambiguity_axis,
    ball_name,
    ball_sizes,
    catalogue,
    geometry_of,
    inferred_geometry,
    parse_designation,
    practice_of,
)
from rolamento.catalogue.geometry import middle_clearance
from rolamento.catalogue.records import records_of_csv, records_of_toml
from rolamento.clearance import class_clearance
from rolamento.errors import FileError, InputError, UnknownKeyError

HEADER = "designation,bore_mm,outside_diameter_mm,dynamic_rating_kN,static_rating_N\n"


@pytest.mark.parametrize(
    ("text", "number", "angle", "clearance"),
    [
        ("6205", "6205", None, None),
        ("6205/C3", "6205", None, "C3"),
        ("6205-2RS1/C3", "6205", None, "C3"),
        ("6205zz c4", "6205", None, "C4"),
        ("W 6205-2Z", "6205", None, None),
        ("7218B", "7218", 40.0, None),
        ("7218 BEP", "7218", 40.0, None),
        ("7205ACDGA/P4A", "7205", 25.0, None),
        ("B7014E", "7014", 25.0, None),
        ("71914C", "71914", 15.0, None),
        ("7206A5", "7206", 25.0, None),
        ("7010 15°", "7010", 15.0, None),
        ("EX 70 25deg", "", 25.0, None),
        ("EX 70 15 deg/C2", "", 15.0, "C2"),
    ],
)
def test_parts_of_a_designation(
    text: str, number: str, angle: float | None, clearance: str | None
) -> None:
    parts = parse_designation(text)
    assert parts.number == number
    assert parts.clearance_class == clearance
    assert parts.contact_angle == (None if angle is None else pytest.approx(np.radians(angle)))


def test_bore_by_its_code() -> None:
    bores = {name: parse_designation(name).bore for name in ("6200", "6203", "6204", "6821")}
    assert bores == {
        "6200": pytest.approx(0.010),
        "6203": pytest.approx(0.017),
        "6204": pytest.approx(0.020),
        "6821": pytest.approx(0.105),
    }


def test_suffixes_are_told_and_the_unknown_is_named() -> None:
    parts = parse_designation("6305DDUC3E")
    assert dict(parts.meanings) == {
        "DDU": "contact seals on both sides",
        "E": "reinforced internal design",
    }
    assert parse_designation("6205-Q").unknown == ("Q",)


@pytest.mark.parametrize(
    ("text", "meanings", "unknown"),
    [
        ("6205 SKF", ("SKF",), ()),
        ("SKF 6310", ("SKF",), ()),
        ("6205 NTN", ("NTN",), ()),
        ("6205 FAG", ("FAG",), ()),
        ("6205SNR", ("SNR",), ()),
        ("skf6205", ("SKF",), ()),
        ("6205/C3 (Koyo)", ("KOYO",), ()),
        ("SKF E2.6205-2Z", ("SKF", "E2", "2Z"), ()),
        ("6205ZZCM", ("ZZ",), ()),
        ("6205-2Z/C3GJN", ("2Z", "GJN"), ()),
        ("6205/C3WT", ("WT",), ()),
        ("6205 K", ("K",), ()),
        ("6205-XYZ", (), ("XYZ",)),
        ("6205-C3Q", (), ("Q",)),
        ("7205ACDGA/P4A", ("D", "G", "A", "P4A"), ()),
        ("6310 M/C3 VL0241", ("M", "VL0241"), ()),
        ("6309.C3", (), ()),
        ("6205-2RSH/C3GJN", ("2RSH", "GJN"), ()),
        ("6205/P63", ("P6",), ()),
        ("7014CTYNDBLP4XQZ", ("TYN", "DB", "L", "P4"), ("XQZ",)),
    ],
)
def test_words_are_not_read_as_suffix_letters(
    text: str, meanings: tuple[str, ...], unknown: tuple[str, ...]
) -> None:
    parts = parse_designation(text)
    assert tuple(part for part, _ in parts.meanings) == meanings
    assert parts.unknown == unknown
    assert catalogue().find(text).bearing.bore == pytest.approx(parts.bore)


@pytest.mark.parametrize(
    ("text", "number", "clearance"),
    [
        ("UC204", "6204", "C3"),
        ("UCP 204", "6204", "C3"),
        ("UCF205 NSK", "6205", "C3"),
        ("UCFL 206/C4", "6206", "C4"),
        ("UCT305", "6305", "C3"),
        ("UC205-16", "6205", "C3"),
        ("UK 206", "6206", "C4"),
        ("UCX05", "6206", "C3"),
        ("NA205", "6205", "C3"),
        ("YAR 205-2F", "6205", "C3"),
        ("SY 25 TF", "6205", "C3"),
        ("GYE25-KRR-B", "6205", "C3"),
    ],
)
def test_insert_bearings_have_the_inside_of_a_deep_groove_one(
    text: str, number: str, clearance: str
) -> None:
    inside, plain = geometry_of(text), geometry_of(f"{number}/{clearance}")
    assert (inside.designation.number, inside.designation.insert) == (number, True)
    assert inside.fields == plain.fields
    assert inside.clearance_class == clearance


def test_small_insert_bearings_depend_on_the_maker() -> None:
    with pytest.raises(
        InputError, match="internal geometry of 6203 or 6204, depending on the maker"
    ):
        geometry_of("UC202")


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("NU 2910", "a cylindrical roller bearing of a size or series in no list; give its"),
        ("NN 3210", "a cylindrical roller bearing"),
        ("NUP296 NSK", "a cylindrical roller bearing"),
        ("30296", "a tapered roller bearing of a size or series in no list"),
        ("22299 EK/C3", "a spherical roller bearing of a size or series in no list; give its"),
        ("HK 2021", "a needle roller bearing of a size or series in no list"),
        ("NKI 25/20", "a needle roller bearing"),
        ("K 10x13x11", "a needle roller bearing"),
        ("K81106", "a cylindrical roller thrust bearing"),
        ("239/500", "a spherical roller bearing"),
        ("BS2-2210-2CS", "a spherical roller bearing"),
        ("GE 30 ES", "a spherical plain bearing"),
        ("KR 26", "a track roller"),
        ("52210", "a double-direction thrust ball bearing; give one of its sides"),
        ("53210", "a thrust ball bearing with a spherical housing washer"),
        ("3218", "a double-row angular-contact ball bearing of a size in no list"),
        ("1230", "a self-aligning ball bearing of a size in no list"),
        ("QJ 256", "a four-point contact ball bearing of a size in no list"),
        ("4205", "a double-row deep-groove ball bearing"),
        ("C 2292", "a toroidal roller bearing of a size in no list; give its"),
        ("29412", "a spherical roller thrust bearing"),
        ("62205-2RS1", "wider rings; its inside is that of the same number without the third"),
        ("608-2Z", "a deep-groove ball bearing of a series in no list; give its balls"),
        ("SNL 510", "a split plummer-block housing; give the bearing in it"),
        ("P204", "a housing of an insert bearing; give the insert"),
        ("NUTR 20", "a track roller"),
    ],
)
def test_other_types_are_named(text: str, kind: str) -> None:
    with pytest.raises(InputError) as caught:
        geometry_of(text)
    assert f"is {kind}" in str(caught.value) or kind in str(caught.value)
    assert "did you mean" not in str(caught.value)


def test_a_suffix_leaves_an_entry_of_ones_own(tmp_path: Path) -> None:
    """With a class, a seal or a maker behind it, a bearing of one's own is still that one."""
    path = tmp_path / "own.csv"
    rows = "6205-XL,25,52,20000,9000\nQ-17,17,40,9000,4500\nS6205,25,52,13000,7000\n"
    path.write_text(HEADER.replace("_kN", "_N") + rows, "utf-8")
    own = catalogue().beside([path])
    for text, name in (
        ("6205-XL/C3", "6205-XL"),
        ("6205-XL-2RS1/C3 SKF", "6205-XL"),
        ("6205 XL", "6205-XL"),
        ("Q-17/C3", "Q-17"),
        ("Q-17-2RS", "Q-17"),
        ("Q 17 NTN", "Q-17"),
        ("S6205/C3", "S6205"),
    ):
        found = own.find(text)
        assert (found.bearing.designation, text) == (name, text)
        assert found.designation.clearance_class == ("C3" if "C3" in text else None)
    assert own.find("6205/C3").bearing.designation == "6205"
    with pytest.raises(InputError, match="in no catalogue"):
        catalogue().find("EX 70")


def test_a_number_of_ones_own_with_the_letters_of_its_angle(tmp_path: Path) -> None:
    path = tmp_path / "own.csv"
    text = "designation,bore_mm,outside_diameter_mm,contact_angle_deg,ball_count,ball_diameter_mm\n"
    path.write_text(text + "7205,25,52,40,13,7.938\n", "utf-8")
    own = catalogue().beside([path])
    assert own.find("7205B").bearing.ball_count == 13
    assert own.find("7205C").bearing.ball_count is None  # 15 degrees: another bearing


@pytest.mark.parametrize("text", ["", "   ", "x" * 61])
def test_no_designation(text: str) -> None:
    with pytest.raises(InputError, match="1 to 60 characters"):
        parse_designation(text)


def test_a_class_that_does_not_exist() -> None:
    with pytest.raises(InputError, match="no clearance class of ISO 5753-1 with C9"):
        parse_designation("6205/C9")


def test_what_the_makers_publish() -> None:
    bearing = catalogue().find("6205-2RS/C3").bearing
    assert (bearing.maker, bearing.kind) == ("NSK", "deep_groove")
    assert bearing.figures == {
        "bore": pytest.approx(0.025),
        "outside_diameter": pytest.approx(0.052),
        "width": pytest.approx(0.015),
        "dynamic_rating": 14000.0,
        "static_rating": 7850.0,
        "f0": 13.9,
    }
    assert all("NSK" in bearing.sources[name] for name in bearing.figures)
    spindle = catalogue().find("ex70 25°").bearing
    assert (spindle.ball_count, spindle.dynamic_rating) == (18, 48800.0)
    assert degrees(spindle.contact_angle or 0.0) == pytest.approx(25.0)


def test_every_record_has_a_source_for_every_figure() -> None:
    for bearing in catalogue().bearings:
        assert bearing.sources.keys() == bearing.figures.keys()
        assert all(bearing.sources.values())
    assert len(catalogue().bearings) > 550


def test_the_same_series_gives_boundary_dimensions() -> None:
    bearing = catalogue().find("7230B").bearing
    assert (bearing.bore, bearing.outside_diameter) == pytest.approx((0.150, 0.270))
    assert bearing.dynamic_rating is None
    assert "ISO 15" in bearing.sources["bore"]
    with pytest.raises(InputError, match="has no load rating to estimate the balls from: give"):
        geometry_of("7230B")


def test_unknown_designation_offers_the_nearest() -> None:
    with pytest.raises(InputError, match=r'"6255": is in no catalogue; did you mean 62\d5'):
        catalogue().find("6255")
    with pytest.raises(InputError, match="EX 7"):
        catalogue().find("EX 71 25deg")


def test_search_as_one_types() -> None:
    search = catalogue().search
    found = [bearing.designation for bearing in search("620") if not bearing.has_rollers]
    assert found == [f"620{i}" for i in range(10)] + [
        f"S 620{i} {angle}" for i in range(10) for angle in "CE"
    ]
    assert [bearing.designation for bearing in search("nsk 6305")] == ["6305"]
    of_sizes = search("25 x 52 x 15")
    assert "NU 205 EW" in {bearing.designation for bearing in of_sizes}
    assert {bearing.designation for bearing in of_sizes if not bearing.has_rollers} == {
        "1205",
        "6205",
        "7205A",
        "7205B",
        "7205C",
        "E 225 15deg",
        "E 225 25deg",
    }
    assert search("") == search("no such thing") == ()
    assert len(search("6", most=7)) == 7


def test_csv_of_a_user(tmp_path: Path) -> None:
    file = tmp_path / "own.csv"
    file.write_text("# maker: ACME\n# source: drawing 7\n" + HEADER + "AC-1,25,52,14,7850\n\n")
    bearing = catalogue().beside([file]).find("ac1").bearing
    assert bearing.maker == "ACME"
    assert bearing.dynamic_rating == pytest.approx(14000.0)
    assert bearing.sources["static_rating"] == "drawing 7"
    assert geometry_of("AC-1", catalogue_of=catalogue().beside([file])).fields["ball_count"] == 9


def test_toml_of_a_user_takes_the_place_of_the_built_in(tmp_path: Path) -> None:
    file = tmp_path / "own.toml"
    file.write_text(
        'source = "measured"\n[[bearing]]\ndesignation = "6205"\nbore = "25 mm"\n'
        'outside_diameter = "52 mm"\nball_count = 9\nball_diameter = "0.3126 in"\n'
        'pitch_diameter = "1.537 in"\ninner_conformity = 0.515\nouter_conformity = 0.53\n'
    )
    both = catalogue().beside([file])
    inside = geometry_of("6205", catalogue_of=both)
    assert not inside.is_inferred
    assert inside.fields["pitch_diameter"] == pytest.approx(0.03904, abs=1e-5)
    assert inside.origins["inner_conformity"] == "published"
    assert catalogue().find("6205").bearing.maker == "NSK"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "contains no table"),
        ("designation,bore_mm,outside_mm\n", "outside_diameter"),
        ("designation,bore_mm,bore_mm\n", "occurs twice"),
        (HEADER + "A,25,52,14\n", "line 2: has 4 cells where the header has 5"),
        (HEADER + "A,25,52,14,x\n", "must be a number"),
        (HEADER + "A,25,52,14,nan\n", "must be a number"),
        (HEADER + "A,25,52,14,1e99\n", "must be between"),
        (HEADER + "A,52,25,14,1\n", "greater than the bore"),
        (HEADER + ",25,52,14,1\n", "designation: is missing"),
        (HEADER + "A,,52,14,1\n", "bore: is missing"),
        (HEADER + '"A,25\n', "not a line of a CSV table"),
        (
            "# kind: roller\n" + HEADER + "A,25,52,14,1\n",
            "must be one of deep_groove, angular_contact",
        ),
        ("designation,bore_mm,outside_diameter_mm,ball_count\nA,25,52,8.5\n", "integer"),
    ],
)
def test_wrong_csv(text: str, message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        records_of_csv(text, "own.csv")
    assert "own.csv" in str(caught.value)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a = ", "not valid TOML"),
        ("[bearing]\n", r"contains no \[\[bearing\]\]"),
        ("[[bearing]]\ndesignatoin = 'A'\n", "did you mean designation"),
        ("[[bearing]]\ndesignation = 'A'\nbore = 25\n", 'needs a unit .*bore = "25 mm"'),
        ("[[bearing]]\ndesignation = 'A'\nbore = '25 kg'\n", "bore"),
        ("[[bearing]]\ndesignation = 5\n", "one line of text"),
        ("[[bearing]]\ndesignation = 'A'\nbore = '1 mm'\nf0 = true\n", "must be a number"),
    ],
)
def test_wrong_toml(text: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        records_of_toml(text, "own.toml")


def test_wrong_files(tmp_path: Path) -> None:
    (tmp_path / "own.xls").write_text("x")
    with pytest.raises(FileError, match=r"\.csv or \.toml"):
        catalogue().beside([tmp_path / "own.xls"])
    with pytest.raises(FileError, match="cannot be opened"):
        catalogue().beside([tmp_path / "absent.csv"])
    with pytest.raises(UnknownKeyError):
        records_of_csv("colour\nred\n", "own.csv")
    many = HEADER + "A,25,52,14,1\n" * 20_001
    with pytest.raises(FileError, match="more than 20 000 rows"):
        records_of_csv(many, "own.csv")


def test_standard_balls() -> None:
    sizes = ball_sizes()
    assert (np.diff(sizes) > 0.0).all()
    for millimetres in (2.38125, 4.7625, 5.953125, 6.746875, 7.9375, 8.0, 10.31875, 38.1):
        assert np.isclose(sizes, millimetres * 1e-3, rtol=1e-9).any()
    assert [ball_name(size) for size in (7.938e-3, 8e-3, 38.1e-3, 7.7e-3)] == [
        "5/16 in",
        "8 mm",
        "1 1/2 in",
        "",
    ]


def test_every_published_ball_is_a_standard_one() -> None:
    """The list is complete for GMN and SNFA; they print two decimals, at times cut off."""
    published = {b.ball_diameter for b in catalogue().bearings if b.ball_diameter and b.maker}
    assert all(np.abs(ball_sizes() - size).min() < 9e-6 for size in published)


def test_the_inside_is_marked_as_inferred() -> None:
    inside = geometry_of("6305/C3")
    assert inside.is_inferred
    assert inside.clearance_class == "C3"
    assert inside.origins == {
        "ball_count": "inferred",
        "ball_diameter": "inferred",
        "pitch_diameter": "inferred",
        "inner_conformity": "assumed",
        "outer_conformity": "assumed",
        "diametral_clearance": "assumed",
    }
    best = inside.candidates[0]
    assert best.rests_on == ("dynamic_rating", "static_rating", "f0")
    assert best.rank == 1
    low, high = best.pitch_diameter_range
    assert low <= best.pitch_diameter <= high
    assert sum(one.weight for one in inside.candidates) == pytest.approx(1.0)
    misfits = [one.misfit for one in inside.candidates]
    assert misfits == sorted(misfits)


def test_the_inside_that_is_published_is_not_inferred() -> None:
    spindle = geometry_of("S 6012 C")
    assert set(spindle.origins.values()) == {"published", "assumed"}
    assert spindle.fields["ball_count"] == 22
    assert spindle.candidates == ()
    harris = geometry_of("7218B")
    assert set(harris.origins.values()) == {"published"}
    assert harris.fields["inner_conformity"] == 0.5232
    assert geometry_of("EX 70 25deg").origins["pitch_diameter"] == "assumed"


def test_other_candidates_can_be_chosen() -> None:
    first, second = geometry_of("6205"), geometry_of("6205", rank=2)
    assert second.fields["ball_diameter"] == first.candidates[1].ball_diameter
    with pytest.raises(InputError, match=r"rank = 99: must be between 1 and"):
        geometry_of("6205", rank=99)


def test_what_is_published_is_kept() -> None:
    known = dataclasses.replace(catalogue().find("6205").bearing, ball_count=10)
    assert {one.ball_count for one in inferred_geometry(known)} == {10}
    assert inferred_geometry(known)[0].rests_on[-1] == "ball_count"


def test_one_rating_is_enough_for_a_guess() -> None:
    only = dataclasses.replace(catalogue().find("6205").bearing, static_rating=None, f0=None)
    candidates = inferred_geometry(only)
    assert candidates[0].static_error is None
    assert candidates[0].rests_on == ("dynamic_rating",)
    assert (9, pytest.approx(7.9375e-3)) in [(c.ball_count, c.ball_diameter) for c in candidates]


def test_ratings_that_nothing_reproduces() -> None:
    odd = CatalogueBearing(
        designation="odd", bore=0.025, outside_diameter=0.052, dynamic_rating=1e6
    )
    assert inferred_geometry(odd) == ()


def test_practice_of_makers() -> None:
    assert practice_of("SNFA").static > 1.2
    assert practice_of("grooves") == practice_of("iso") == practice_of("")


def test_the_middle_of_a_class_is_that_of_the_clearance_module() -> None:
    for bore in (0.003, 0.010, 0.0101, 0.025, 0.030, 0.055, 0.5):
        for name in ("C2", "CN", "C3"):
            expected = class_clearance(bore, name).middle
            assert middle_clearance(bore, name) == pytest.approx(expected, rel=1e-12)
    assert middle_clearance(0.004, "C5") is None
    assert middle_clearance(0.6, "CN") is None


def test_axis_of_a_study() -> None:
    candidates = geometry_of("6205").candidates
    credible = ambiguity_axis(candidates)["zipped"]
    assert 1 <= len(credible["bearing.ball_count"]) <= len(candidates)
    everything = ambiguity_axis(candidates, credible_only=False)["zipped"]
    assert len(everything["bearing.ball_diameter"]) == len(candidates)
    with pytest.raises(InputError, match="no candidates"):
        ambiguity_axis(())


DOCUMENT = Path(__file__).resolve().parents[2] / "docs" / "catalogue.md"


def test_examples_of_the_guide_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The ambiguity as an axis of a study is among them."""
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    for block in re.findall(r"```python\n(.*?)```", DOCUMENT.read_text("utf-8"), re.DOTALL):
        exec(compile(block, "example", "exec"), names)
    assert names["low"] != names["high"]


def test_the_guide_counts_right() -> None:
    text = DOCUMENT.read_text("utf-8")
    for maker, kind, named in (
        ("NSK", "deep_groove", "deep-groove"),
        ("NSK", "angular_contact", "angular"),
        ("NSK", "double_row", "double-row"),
        ("FAG", "double_row", "double-row"),
        ("NSK", "four_point", "four-point"),
        ("NSK", "self_aligning", "self-aligning"),
        ("NSK", "thrust", "thrust"),
        ("SNFA", "angular_contact", "angular"),
        ("GMN", "angular_contact", "angular"),
    ):
        known = catalogue().bearings
        count = sum(bearing.maker == maker and bearing.kind == kind for bearing in known)
        assert f"| {maker} | {count} {named}" in text


def test_a_class_without_a_range_for_the_bore(tmp_path: Path) -> None:
    file = tmp_path / "own.csv"
    file.write_text(
        "designation,bore_mm,outside_diameter_mm,ball_count,ball_diameter_mm\nQX,4,12,7,2\n"
    )
    own = catalogue().beside([file])
    assert "diametral_clearance" in geometry_of("QX/C3", catalogue_of=own).fields
    without = geometry_of("QX/C5", catalogue_of=own)
    assert "diametral_clearance" not in without.fields
    assert "class C5, for which ISO 5753-1 has no range at a bore of 4 mm" in without.lack_of_play
