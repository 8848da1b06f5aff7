"""What is said of a key that nobody knows: the field that may be meant, wherever it stands."""

from __future__ import annotations

from typing import Any

import pytest

from rolamento import Bearing, Duty, override, parse_case, solve
from rolamento.case import Case
from rolamento.case.fields import fields_of
from rolamento.case.hints import ALIASES, hint
from rolamento.errors import InputError
from rolamento.studies.fields import read_field

CASE = '[bearing]\ndesignation = "6310"\n[duty]\n'


@pytest.mark.parametrize(
    ("key", "near"),
    [
        ("duty.speed", "inner_speed"),
        ("speed", "duty.inner_speed"),
        ("duty.n", "inner_speed"),
        ("fr", "duty.load.fz"),
        ("duty.radial_load", "duty.load.fz"),
        ("duty.axial_load", "duty.load.fx"),
        ("duty.load.fa", "fx"),
        ("duty.fz", "duty.load.fz"),
        ("duty.load.x", "duty.displacement.x"),
        ("duty.load.speed", "duty.inner_speed"),
        ("bearing.clearance", "diametral_clearance"),
        ("bearing.balls", "ball_count"),
        ("bearing.Z", "ball_count"),
        ("bearing.contact_angel", "contact_angle"),
        ("bearing.speed", "duty.inner_speed"),
        ("bearing.ball-diameter", "ball_diameter"),
        ("lubricant.viscosity", "viscosity_40"),
        ("oil", "lubricant"),
        ("temperature.temperatura", "lubricant"),
        ("mounting.clearance", "clearance_class"),
        ("life.C", "dynamic_rating"),
    ],
)
def test_the_field_that_is_meant(key: str, near: str) -> None:
    with pytest.raises(InputError, match=rf"did you mean {near}\?"):
        override(parse_case(CASE), [f"{key}=1"])
    table, _, leaf = key.rpartition(".")
    if leaf.isidentifier() and table != "bearing":
        text = (
            f"{CASE.partition('[duty]')[0]}[{table}]\n{leaf} = 1\n"
            if table
            else f"{key} = 1\n{CASE}"
        )
        text += "" if table == "duty" else "[duty]\n" if table else ""
        with pytest.raises(InputError, match=rf"did you mean {near}\?"):
            parse_case(text)


def test_nothing_is_meant() -> None:
    with pytest.raises(InputError, match="known: title, bearing, duty"):
        override(parse_case(CASE), ["xyzzy=1"])


def test_records_studies_and_batches_tell_too() -> None:
    with pytest.raises(InputError, match=r"did you mean ball_count\?"):
        Bearing(designation="6310", balls=8)  # type: ignore[call-arg]
    with pytest.raises(InputError, match=r"did you mean inner_speed\?"):
        Duty(speed=3)  # type: ignore[call-arg]
    with pytest.raises(InputError, match=r"did you mean duty\.inner_speed\?"):
        read_field("duty.speed")
    with pytest.raises(InputError, match=r"did you mean bearing\.contact_angle\?"):
        read_field("bearing.contact_angel")
    with pytest.raises(InputError, match=r"did you mean duty\.load\.fz\?"):
        solve("6310", radial_load=[1.0])


def test_of_many_the_nearest_are_named_and_where_the_others_stand() -> None:
    with pytest.raises(InputError) as caught:
        solve("6310", fq=[1.0])  # type: ignore[call-arg]
    text = str(caught.value)
    assert "nearest: fx, fy, fz," in text
    assert "rolamento sweep --list fields lists them all" in text
    assert len(text) < 200
    with pytest.raises(InputError, match=r"did you mean inner_speed or outer_speed\?"):
        solve("6310", speed=[1.0])  # type: ignore[call-arg]


@pytest.mark.parametrize(
    ("given", "told"), [(None, "None"), (3, "3"), ([], "a list"), (object(), "an object of type")]
)
def test_what_is_no_case_is_shown_as_it_is(given: Any, told: str) -> None:
    with pytest.raises(InputError, match=rf"^case = {told}.*: must be a Case, a bearing.*6310/C3"):
        solve(given)


def test_the_words_are_for_fields_and_each_for_one() -> None:
    known = fields_of(Case)
    assert not [name for name in ALIASES if name not in known]
    words = [word for several in ALIASES.values() for word in several]
    assert len(words) == len({*words})
    assert all(word == word.casefold() and "-" not in word for word in words)


def test_a_table_inline() -> None:
    pair = parse_case(
        '[bearing]\ndesignation = "S 6012 C"\narrangement = "DB"\nspacing = "18 mm"\n'
        'preload = "500 N"\n[duty]\n[duty.displacement]\nx = "1 um"\n'
    )
    spring = override(pair, ['bearing.preload={ spring = "300 N" }'])
    assert spring.bearing.preload is not None
    assert (spring.bearing.preload.spring, spring.bearing.preload.force) == (300.0, None)
    loaded = override(pair, ['duty.load={ fx = "1 kN", fz = "2 kN" }'])
    assert (loaded.duty.load.fx, loaded.duty.displacement.x) == (1000.0, None)
    oil = override(pair, ['lubricant={ base_oil = "ISO VG 68", friction_coefficient = 0.08 }'])
    assert oil.lubricant is not None
    assert oil.lubricant.friction_coefficient == 0.08
    rows = '[{ orientation = "+", position = "-9 mm" }, { orientation = "-", position = "9 mm" }]'
    assert len(override(pair, [f"bearing.rows={rows}"]).bearing.places) == 2
    assert override(pair, ["title=[ours] {1}"]).title == "[ours] {1}"


@pytest.mark.parametrize(
    ("setting", "told"),
    [
        ('bearing.preload={ force = "300" }', "--set: bearing.preload.force"),
        ('bearing.preload={ forse = "300 N" }', "did you mean force"),
        ("bearing.preload={ force ", "is not valid TOML"),
        ('bearing.preload={ force = "1 N" }\ntitle = "x"', "must be a single value"),
        ("bearing.preload={" + "a.a" * 300 + "=1}", "dots"),
        ("bearing.ball_count={ a = 1 }", "must be an integer"),
        ("bearing.rows=2", "is a list; give all of it"),
        ("duty.load=3", "is a table; set all of it, or one of its fields: fx, fy"),
    ],
)
def test_an_inline_table_that_will_not_do(setting: str, told: str) -> None:
    with pytest.raises(InputError) as caught:
        override(parse_case(CASE), [setting])
    assert told in str(caught.value)


def test_a_hint_without_any_field() -> None:
    assert hint("a.b", (), ("one", "two")) == "known: one, two"
