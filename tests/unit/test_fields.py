"""The registry of fields, what changes a case by it, and the schema of a case."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import numpy as np
import pandas as pd
import pytest

from rolamento import Case, InputError, Load, UnitError, UnknownKeyError, load_case, override
from rolamento.case.fields import Field
from rolamento.case.labels import LABELS
from rolamento.case.varied import bounded, varied_arrays
from rolamento.units import SI_UNIT
from rolamento.words import languages, speaking

FIELDS = Case.fields()
NUMBERS = [name for name, field in FIELDS.items() if field.kind == "number"]


def taken(field: Field, value: object) -> bool:
    try:
        field.checked(value, in_file=False)
    except InputError:
        return False
    return True


# --- what the registry tells ---------------------------------------------------------------------


def test_what_is_told_of_a_field() -> None:
    load = FIELDS["duty.load.fz"]
    assert (load.leaf, load.kind, load.dimension) == ("fz", "number", "force")
    assert (load.unit, load.shown_unit, load.example) == ("N", "kN", '"15 kN"')
    assert (load.label, load.long_name) == ("radial load Fz", "radial load Fz")
    assert load.rivals == ("duty.displacement.z",)
    assert load.limits == "at least −1 000 000 kN and at most 1 000 000 kN"
    assert load.varies
    assert load.meaning == "Forces, in N."
    balls = FIELDS["bearing.ball_count"]
    assert (balls.kind, balls.unit, balls.varies, balls.example) == ("count", "", False, "16")
    assert FIELDS["bearing.rows"].kind == FIELDS["lubricant.viscosities"].kind == "list"
    assert FIELDS["model.centrifugal_force"].kind == "switch"
    assert FIELDS["bearing.ring_material"].kind == FIELDS["model.cage"].kind == "text"
    assert "duty.load" not in FIELDS
    assert "lubricant.viscosities.temperature" not in FIELDS


def test_every_field_has_a_label_of_its_own_in_every_language() -> None:
    for language in languages():
        with speaking(language):
            labels = {field.label: name for name, field in FIELDS.items()}
        assert len(labels) == len(FIELDS)
    assert set(LABELS) <= set(FIELDS)
    parts = (
        "bearing.ring_",
        "bearing.ball_",
        "bearing.roller_material.",
        "mounting.shaft_",
        "mounting.housing_",
        "life.tall",
    )
    parts += ("mounting.inner_spacer_material.", "mounting.outer_spacer_material.")
    assert all(name in LABELS or name.startswith(parts) for name in FIELDS)


def test_every_field_has_a_meaning_and_an_example() -> None:
    for field in FIELDS.values():
        assert field.meaning, field.name
        assert field.example, field.name


@pytest.mark.parametrize("name", NUMBERS)
@pytest.mark.thirds
def test_bounds_are_those_of_the_record(name: str) -> None:
    field = FIELDS[name]
    assert field.bounds is not None
    assert field.limits
    assert field.shown_unit == (field.example.strip('"').partition(" ")[2])
    limits = [
        limit
        for relation in ("above", "at_least", "below", "at_most")
        if (limit := getattr(field.bounds, relation, None)) not in ("", None)
    ]
    values = [
        float(field.checked(limit, in_file=False)) for limit in limits if taken(field, limit)
    ] or [0.5, -1e9]
    around = np.array([*values, *(np.array(values) * 1.1), *(np.array(values) - 1.0), np.nan])
    allowed = field.bounds.allows(around)
    assert [taken(field, float(value)) for value in around] == allowed.tolist()


def test_rivals_are_each_others() -> None:
    for name, field in FIELDS.items():
        for rival in field.rivals:
            assert name in FIELDS[rival].rivals
        assert set(field.replaces) <= set(FIELDS)
    assert set(FIELDS["life.filter_size"].rivals) == {
        "life.contamination",
        "life.cleanliness",
        "life.grease_cleanliness",
    }
    assert "bearing.preload.designation" not in FIELDS["bearing.preload.level"].rivals


# --- changes --------------------------------------------------------------------------------------


def test_nested_names_as_text_as_numbers_and_as_keywords(case_218: Case) -> None:
    by_text = case_218.with_({"duty.load.fz": "10 kN", "duty.inner_speed": "0 rpm"})
    by_number = case_218.with_(duty__load__fz=np.float64(10e3), duty__inner_speed=0)
    by_setting = override(case_218, ["duty.load.fz=10 kN", "duty.inner_speed=0 rpm"])
    assert by_text == by_number == by_setting
    assert by_text.duty.load.fz == 10e3
    assert case_218.with_({"bearing.ball_count": np.int64(12)}).bearing.ball_count == 12
    assert not case_218.with_(model__centrifugal_force=np.bool_(False)).model.centrifugal_force
    assert case_218.with_() == case_218


def test_numbers_come_through_to_the_last_bit(case_218: Case) -> None:
    for value in (1 / 3, 0.1 + 0.2, 1e4 / 7):
        assert case_218.with_(duty__load__fx=value).duty.load.fx == value


def test_a_value_replaces_its_rival(case_218: Case) -> None:
    held = case_218.with_(duty__displacement__z=1e-5, bearing__diametral_clearance="0.1 mm")
    assert (held.duty.load.fz, held.bearing.contact_angle) == (None, None)
    back = held.with_(duty__load__fz="15 kN", bearing__contact_angle="40 deg")
    assert back == case_218


def test_whole_tables(case_218: Case) -> None:
    case = case_218.with_(
        {"duty.load": Load(fx=1.0), "lubricant": "ISO VG 68"},
        temperature={"lubricant": 343.15, "inner_ring": "80 degC"},
        bearing__ball_material={"youngs_modulus": 3e11, "poisson_ratio": 0.2, "density": 3e3},
    )
    assert case.duty.load == Load(fx=1.0)
    assert case.temperature is not None
    assert (case.temperature.lubricant, case.temperature.inner_ring) == (343.15, 353.15)
    assert case.bearing.ball_material.youngs_modulus == 3e11
    assert case.with_(lubricant=None).lubricant is None
    rows = case_218.with_(bearing__rows=[{"position": 0.0}, {"position": "40 mm"}])
    assert [place.position for place in rows.bearing.places] == [0.0, 0.04]


def test_a_field_of_what_is_given_by_name(case_218: Case) -> None:
    softer = case_218.with_(bearing__ball_material__youngs_modulus="150 GPa")
    assert softer.bearing.ball_material.youngs_modulus == 150e9
    assert softer.bearing.ball_material.density == case_218.bearing.ball_material.density
    oil = case_218.with_(lubricant="ISO VG 68").with_(lubricant__friction_coefficient=0.1)
    assert oil.lubricant is not None
    assert oil.lubricant.viscosity_40 == pytest.approx(68e-6)


def test_balls_go_on_following_the_rings() -> None:
    case = load_case("src/rolamento/examples/218_combined.toml")
    for changed in (
        case.with_(bearing__ring_material="440C"),
        override(case, ["bearing.ring_material=440C"]),
    ):
        assert changed.bearing.ball_material.name == "440C"
    hybrid = case.with_(bearing__ball_material="Si3N4").with_(bearing__ring_material="440C")
    assert hybrid.bearing.ball_material.name == "Si3N4"


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"duty.load.fq": 1.0}, "duty.load.fq: is an unknown key"),
        ({"duty.load": 3.0}, "is a table; set all of it, or one of its fields: fx"),
        ({"duty.load.fz": float("nan")}, "must be a finite number"),
        ({"duty.load.fz": [1.0, 2.0]}, "must be a single value, not a table or a list"),
        ({"duty.load.fz": "3 mm"}, "not a unit of force"),
        ({"duty.load.fz": 1.0, "duty.displacement.z": 0.0}, "a load or a displacement"),
        ({"bearing": None}, "bearing: is missing"),
        ({"bearing.rows": 3}, "is a list"),
        ({"bearing.ball_material": "wood"}, "is an unknown name"),
        ({"bearing.ball_material.density": "3 mm"}, "not a unit of density"),
        ({"title": 3}, "must be text"),
    ],
)
def test_wrong_changes_are_refused(case_218: Case, values: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        case_218.with_(values)
    assert not caught.value.source
    with pytest.raises(InputError, match="given twice"):
        case_218.with_({"duty.load.fz": 1.0}, duty__load__fz=2.0)


# --- values over many cases ----------------------------------------------------------------------


@pytest.mark.parametrize(
    "values",
    [
        {"duty.inner_speed": ["60 rpm", 4.0 * np.pi, None]},
        {"inner_speed": np.array(["60 rpm", "120 rpm", None], dtype=object)},
        pd.DataFrame({"duty.inner_speed": ["60 rpm", "120 rpm", pd.NA]}),
        {"inner_speed": pd.Series([2.0 * np.pi, 4.0 * np.pi, None])},
        {"inner_speed": pd.Series([2.0 * np.pi, 4.0 * np.pi, pd.NA], dtype="Float64")},
        {"inner_speed": np.ma.array([2.0 * np.pi, 4.0 * np.pi, 1.0], mask=[0, 0, 1])},
        {"inner_speed": np.ma.array(["60 rpm", "120 rpm", "none"], mask=[0, 0, 1])},
    ],
)
def test_what_stands_for_numbers(values: Any) -> None:
    ((name, array),) = varied_arrays(values).items()
    assert name == "duty.inner_speed"
    assert array == pytest.approx([2.0 * np.pi, 4.0 * np.pi, np.nan], nan_ok=True)


def test_scalars_and_nothing() -> None:
    found = varied_arrays(inner_speed="60 rpm", fx=3)
    assert [array.shape for array in found.values()] == [(), ()]
    assert found["duty.inner_speed"] == pytest.approx(2.0 * np.pi)
    assert varied_arrays() == varied_arrays({}) == varied_arrays(pd.DataFrame()) == {}


def test_values_stay_and_bounds_are_put_on_them_afterwards() -> None:
    given = varied_arrays({"bearing.inner_conformity": [0.4, 0.52, np.inf]})
    assert given["bearing.inner_conformity"].tolist() == [0.4, 0.52, np.inf]
    kept = bounded(given)["bearing.inner_conformity"]
    assert np.array_equal(kept, [np.nan, 0.52, np.nan], equal_nan=True)


@pytest.mark.parametrize(
    ("values", "kind", "message"),
    [
        ({"inner_speed": ["100 mm"]}, UnitError, "duty.inner_speed.*not a unit of angular speed"),
        ({"inner_speed": ["100"]}, UnitError, "needs a unit"),
        ({"life.contamination": "0.5"}, InputError, "must be a number"),
        ({"fz": True}, InputError, "must be numbers"),
        ({"fz": [1j]}, InputError, "must be numbers"),
        ({"fz": np.array(["2020-01-01"], "M8[D]")}, InputError, "must be numbers"),
        ({"fz": [[1.0], [2.0, 3.0]]}, InputError, "must be a number"),
        ({"fz": [[1.0], [2.0]]}, InputError, "one-dimensional"),
        ({"fz": {1.0, 2.0}}, InputError, "must be a number"),
        ({"fz": [1.0, 10**400]}, InputError, "finite number"),
        ({"bearing.ball_count": [16]}, UnknownKeyError, "is not a field that can vary"),
        ({3: 1.0}, UnknownKeyError, "is not a field that can vary"),
        (
            pd.Series([1.0]),
            InputError,
            "must be values by field names, or a table whose columns are",
        ),
        ([1.0], InputError, "must be values by field names, or a table whose columns are"),
        (pd.DataFrame([[1.0, 2.0]], columns=["fz", "fz"]), InputError, "given twice"),
        ({"x": 0.0, "fx": 1.0}, InputError, "cannot be combined with duty.displacement.x"),
    ],
)
def test_what_stands_for_none_is_refused(values: Any, kind: type[InputError], message: str) -> None:
    with pytest.raises(kind, match=message) as caught:
        varied_arrays(values)
    assert caught.value.field


def test_a_number_with_a_unit_of_another_library_is_refused() -> None:
    pint = pytest.importorskip("pint")
    with pytest.raises(InputError, match="plain number or text"):
        varied_arrays({"fz": pint.UnitRegistry().Quantity(1.0, "kN")})


# --- the schema ----------------------------------------------------------------------------------


SCHEMA: dict[str, Any] = Case.model_json_schema()


def alternatives(entry: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """What an entry of the schema allows, references followed."""
    if "$ref" in entry:
        yield SCHEMA["$defs"][entry["$ref"].rpartition("/")[2]]
    for one in entry.get("anyOf", ()):
        yield from alternatives(one)
    yield entry


def entry_of(name: str) -> dict[str, Any]:
    tables, entry = [SCHEMA], SCHEMA
    for part in name.split("."):
        entry = next(one["properties"][part] for one in tables if part in one["properties"])
        tables = [one for one in alternatives(entry) if "properties" in one]
    return entry


@pytest.mark.parametrize("name", NUMBERS)
@pytest.mark.thirds
def test_bounds_and_units_are_in_the_schema(name: str) -> None:
    field, entry = FIELDS[name], entry_of(name)
    number = next(one for one in alternatives(entry) if one.get("type") == "number")
    if field.dimension is not None:
        assert number["unit"] == SI_UNIT[field.dimension]
        text = next(one for one in alternatives(entry) if one.get("type") == "string")
        assert (text["dimension"], text["limits"]) == (field.dimension, field.limits)
    limits = {key: number[key] for key in number if key.lower().endswith("imum")}
    assert limits
    for key, limit in limits.items():
        beyond = np.nextafter(limit, np.inf if "ax" in key else -np.inf)
        assert taken(field, limit) == (not key.startswith("exclusive"))
        assert not taken(field, float(beyond))


@pytest.mark.parametrize("name", FIELDS)
@pytest.mark.thirds
def test_meanings_and_examples_are_in_the_schema(name: str) -> None:
    field, entry = FIELDS[name], entry_of(name)
    assert entry["description"]
    assert len(entry.get("replaces", [])) == len(field.replaces)
    if field.kind != "list":
        assert field.checked(entry["examples"][0], in_file=True) is not None


def test_a_designation_or_rows_may_tell_the_geometry() -> None:
    bearing = SCHEMA["$defs"]["Bearing"]
    assert {"required": ["designation"]} in bearing["anyOf"]
    assert {"required": ["rows"]} in bearing["anyOf"]
    assert "required" not in bearing
    assert SCHEMA["required"] == ["bearing", "duty"]
    json.dumps(SCHEMA)
