"""The one result: its cases, its tables, its words, and its way to JSON and back."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rolamento import Case, FileError, InputError, Lubricant, UnknownKeyError, load_case, override
from rolamento.solution import solve
from rolamento.solved import Solved


@pytest.fixture(scope="module")
def case(examples: Path) -> Case:
    return load_case(examples / "218_combined.toml")


@pytest.fixture(scope="module")
def four(case: Case) -> Solved:
    """Of the last one the axial load points the way that the bearing does not bear."""
    return solve(case, fx=[1e4, 1e4, 1e4, -1e4], fz=[1e3, 5e3, 2e4, 1e3])


# --- cases ----------------------------------------------------------------------------------------


def test_one_case_is_a_batch_of_one(case: Case) -> None:
    solved = solve(case)
    assert len(solved) == 1
    assert solved.displacement.x.shape == (1,)
    assert solved.stiffness.array.shape == (1, 5, 5)
    assert solved.inner.load.shape == solved.elements.azimuth.shape == (1, 16)
    assert solved.rows.load.shape == (1, 1, 5)


def test_a_file_is_as_good_as_a_case(case: Case, examples: Path) -> None:
    by_path = solve(examples / "218_combined.toml")
    np.testing.assert_array_equal(by_path.load.array, solve(case).load.array)


@pytest.mark.parametrize("given", [3, None, {"bearing": {}}, ["case.toml"]])
def test_what_is_no_case_is_refused(given: Any) -> None:
    with pytest.raises(InputError, match="case") as caught:
        solve(given)
    assert caught.value.example is not None


def test_a_part_is_what_it_would_be_alone(case: Case, four: Solved) -> None:
    for index in (0, 2):
        part = four[index]
        assert len(part) == 1
        radial = part.field("duty.load.fz")[0]
        alone = solve(override(case, [f"duty.load.fz={radial} N", "duty.load.fx=10 kN"]))
        np.testing.assert_allclose(part.inner.load, alone.inner.load, rtol=1e-7)
        assert part.notes == alone.notes


@pytest.mark.parametrize("index", [slice(1, 3), [1, 2], np.array([False, True, True, False]), -1])
def test_all_tables_go_with_the_index(four: Solved, index: Any) -> None:
    part = four[index]
    chosen = np.atleast_1d(np.arange(4)[index])
    assert len(part) == len(chosen)
    np.testing.assert_array_equal(part.load.fx, four.load.fx[chosen])
    np.testing.assert_array_equal(part.status.code, four.status.code[chosen])
    np.testing.assert_array_equal(part.outer.max_pressure, four.outer.max_pressure[chosen])
    np.testing.assert_array_equal(part.rows.position, four.rows.position[chosen])
    np.testing.assert_array_equal(part.varied["duty.load.fz"], four.varied["duty.load.fz"][chosen])


def test_a_name_is_no_case(four: Solved) -> None:
    with pytest.raises(
        InputError, match=r'^solved = "fz": must be the number of a case.*\.field\('
    ):
        four["fz"]  # type: ignore[index]


def test_a_case_that_is_not_there(four: Solved) -> None:
    with pytest.raises(IndexError, match="case 4 of 4"):
        four[4]


def test_a_lost_case_holds_no_number(four: Solved) -> None:
    assert four.status.code.tolist() == ["converged"] * 3 + ["no_equilibrium"]
    lost = four[3]
    numbers = (lost.stiffness.array, lost.inner.load, lost.outer.max_pressure, lost.rows.load)
    for array in (*lost.displacement, *lost.load, *numbers, lost.elements.orbital_speed):
        assert np.isnan(array).all()
    assert lost.advice[0] is not None
    assert lost.advice[0].key == "unsupported_axially"
    assert lost.notes == ((),)
    assert [advice is None for advice in four.advice] == [True, True, True, False]


# --- fields and names -----------------------------------------------------------------------------


def test_a_field_whether_it_varied_or_not(case: Case, four: Solved) -> None:
    np.testing.assert_array_equal(four.field("duty.load.fz"), [1e3, 5e3, 2e4, 1e3])
    np.testing.assert_array_equal(four.field("duty.inner_speed"), case.duty.inner_speed)
    assert np.isnan(four.field("lubricant.friction_coefficient")).all()
    with pytest.raises(UnknownKeyError):
        four.field("duty.speed")


def test_a_field_of_an_invalid_case_does_no_harm(case: Case) -> None:
    solved = solve(case, {"bearing.ball_diameter": [0.02223, -1.0]})
    assert solved.status.code.tolist() == ["converged", "invalid_input"]
    np.testing.assert_array_equal(solved.field("bearing.ball_diameter"), [0.02223, 0.02223])


def test_stiffness_by_names(four: Solved) -> None:
    np.testing.assert_array_equal(four.stiffness["fz", "z"], four.stiffness.array[:, 2, 2])
    np.testing.assert_array_equal(four.stiffness["my", "x"], four.stiffness.array[:, 3, 0])
    with pytest.raises(UnknownKeyError, match="fx, fy, fz, my, mz"):
        four.stiffness["z", "fz"]


# --- tables ---------------------------------------------------------------------------------------


def test_the_rows_of_a_set(examples: Path) -> None:
    solved = solve(load_case(examples / "6012_pair.toml"))
    rows = solved.rows
    assert len(rows) == 2
    assert rows.sign.tolist() == [1.0, -1.0] or rows.sign.tolist() == [-1.0, 1.0]
    assert rows.starts.tolist() == [0, rows.element_count[0]]
    np.testing.assert_array_equal(solved.elements.row, np.repeat([0, 1], rows.element_count))
    assert rows.per_element(rows.position).shape == solved.elements.azimuth.shape
    np.testing.assert_allclose(rows.load.sum(axis=1), solved.load.array, atol=1e-6)
    loaded = (solved.inner.load > 0.0)[0]
    assert solved.loaded_elements[0].tolist() == [
        int(loaded[solved.elements.row == row].sum()) for row in (0, 1)
    ]


def test_contacts_tell_what_presses_and_what_does_not(four: Solved) -> None:
    contacts = four[:3].inner
    np.testing.assert_array_equal(contacts.load > 0.0, contacts.approach > 0.0)
    np.testing.assert_array_equal(contacts.deflection, np.maximum(contacts.approach, 0.0))
    inner = four.contacts["inner"]
    assert inner is four.inner
    assert (contacts.entrainment > 0.0).all()


def test_a_data_frame_for_every_table(four: Solved) -> None:
    cases = four.to_pandas()
    assert cases["duty.load.fz"].tolist() == [1e3, 5e3, 2e4, 1e3]
    assert cases["status"].tolist()[3] == "no_equilibrium"
    assert len(four.to_pandas("elements")) == 4 * 16
    contacts = four.to_pandas("contacts")
    assert len(contacts) == 2 * 4 * 16
    heaviest = contacts[contacts.race == "outer"].groupby("case").load.max()
    np.testing.assert_array_equal(heaviest[:3], four.outer.load[:3].max(axis=1))
    with pytest.raises(InputError, match="cases, elements or contacts"):
        four.to_pandas("balls")


def test_a_dataset_of_everything(four: Solved) -> None:
    data = four.to_xarray()
    assert dict(data.sizes) == {"case": 4, "load": 5, "axis": 5, "element": 16}
    np.testing.assert_array_equal(
        data["stiffness"].sel(load="fz", axis="z"), four.stiffness["fz", "z"]
    )
    np.testing.assert_array_equal(data["outer_max_pressure"], four.outer.max_pressure)


# --- words ----------------------------------------------------------------------------------------


def test_it_says_what_it_is_in_ten_lines(four: Solved) -> None:
    said = repr(four)
    assert len(said.splitlines()) <= 10
    assert "converged 3" in said
    assert "no_equilibrium 1" in said
    assert "duty.load.fz" in said
    assert "maximum at the inner race" in said
    assert len(repr(four[3]).splitlines()) <= 10
    page = four._repr_html_()
    assert page.count("<tr>") == len(said.splitlines()) - 1


def test_the_title_cannot_break_out_of_the_page(case: Case) -> None:
    solved = solve(case.replace(title="<script>alert(1)</script>"))
    assert "<script>" not in solved._repr_html_()


# --- JSON -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "name", ["218_combined.toml", "218_tilted.toml", "6012_pair.toml", "6305_life.toml"]
)
def test_json_comes_back_to_the_last_bit(examples: Path, name: str) -> None:
    solved = solve(load_case(examples / name))
    text = solved.to_json()
    back = Solved.from_json(text)
    assert back.to_json() == text
    for table, other in ((solved.inner, back.inner), (solved.outer, back.outer)):
        for column in ("load", "approach", "semi_major", "max_shear_depth", "ellipticity",
                       "rolling_curvature", "entrainment", "spin_to_roll"):  # fmt: skip
            np.testing.assert_array_equal(getattr(table, column), getattr(other, column))
    np.testing.assert_array_equal(solved.rows.load, back.rows.load)
    assert repr(back.preload) == repr(solved.preload)  # NaN is not equal to itself
    assert back.notes == solved.notes


def test_friction_control_comes_back(case: Case) -> None:
    dry = Lubricant(kind="dry", friction_coefficient=0.07)
    friction = case.model.replace(raceway_control="friction")
    rolled = solve(case.replace(lubricant=dry, model=friction))
    assert rolled.rolling is not None
    back = Solved.from_json(rolled.to_json())
    assert back.rolling is not None
    assert back.to_json() == rolled.to_json()
    np.testing.assert_array_equal(back.rolling.power, rolled.rolling.power)
    np.testing.assert_array_equal(back.elements.yaw, rolled.elements.yaw)


def test_many_cases_come_back(four: Solved) -> None:
    text = four.to_json()
    back = Solved.from_json(text)
    assert len(back) == 4
    assert back.to_json() == text
    assert back.advice == four.advice
    np.testing.assert_array_equal(back[1].inner.load, four[1].inner.load)
    np.testing.assert_array_equal(back.field("duty.load.fz"), four.field("duty.load.fz"))


def test_a_file_of_json(case: Case, tmp_path: Path) -> None:
    file = tmp_path / "state.json"
    file.write_text(solve(case).to_json(), encoding="utf-8")
    np.testing.assert_array_equal(Solved.read(file).load.array, solve(case).load.array)


@pytest.mark.parametrize(
    ("path", "value", "field"),
    [
        (("schema",), 4, "schema"),
        (("schema",), True, "schema"),
        (("balls",), [], "balls"),
        (("balls",), {"0": 1}, "balls"),
        (("balls", 3), 7, "balls.3"),
        (("balls", 3, "row"), -1, "balls.3.row"),
        (("balls", 3, "row"), 10**9, "balls.3.row"),
        (("balls", 3, "inner", "load"), "much", "balls.3.inner.load"),
        (("balls", 3, "inner", "load"), -1.0, "balls.3.inner.load"),
        (("balls", 3, "inner", "load"), 1e300, "balls.3.inner.load"),
        (("balls", 3, "inner"), None, "balls.3.inner"),
        (("status", "code"), "fine", "status.code"),
        (("status", "converged"), False, "status.converged"),
        (("status", "converged"), 1, "status.converged"),
        (("displacement", "ry"), [], "displacement.ry"),
        (("stiffness",), [[1.0]], "stiffness"),
        (("rows",), [], "rows"),
        (("rows", 0, "modulus"), "steel", "rows.0.modulus"),
        (("notes",), [1], "notes.0"),
        (("notes",), [{"key": 1, "text": "", "values": {}}], "notes.0.key"),
        (("notes",), [{"key": "overspeed", "text": ""}], "notes.0.values"),
        (("case",), 5, "case"),
        (("case", "bearing", "ball_count"), 1, "case.bearing.ball_count"),
        (("varied",), {"duty.load.fz": [1.0, 2.0]}, "varied.duty.load.fz"),
    ],
)
def test_a_damaged_key_is_named(case: Case, path: tuple[Any, ...], value: Any, field: str) -> None:
    mapping = json.loads(solve(case).to_json())
    part = mapping
    for key in path[:-1]:
        part = part[key]
    part[path[-1]] = value
    with pytest.raises(InputError) as caught:
        Solved.from_mapping(mapping)
    assert field in str(caught.value)


def test_what_is_no_result_at_all(tmp_path: Path) -> None:
    for mapping in ({}, {"schema": 1}, {"schema": 1, "weibull": {}}):
        with pytest.raises(FileError):
            Solved.from_mapping(mapping)
    with pytest.raises(InputError):
        Solved.from_json("[1, 2]")
    toml = tmp_path / "case.toml"
    toml.write_text("title = 1", encoding="utf-8")
    with pytest.raises(FileError, match="is not the JSON of a solved state; solve a case first"):
        Solved.read(toml)


def test_a_result_of_an_earlier_release(examples: Path) -> None:
    """It has neither approaches nor spin and roll, nor the geometry of its rows."""
    solved = solve(load_case(examples / "6012_pair.toml"))
    mapping = json.loads(solved.to_json())
    for ball in mapping["balls"]:
        for race in ("inner", "outer"):
            for name in ("approach", "spin", "roll"):
                del ball[race][name]
    for row in mapping["rows"]:
        for name in ("ball_count", "ball_diameter", "pitch_diameter", "inner_conformity",
                     "outer_conformity", "free_contact_angle", "modulus"):  # fmt: skip
            del row[name]
    back = Solved.from_mapping(mapping)
    np.testing.assert_array_equal(back.inner.max_pressure, solved.inner.max_pressure)
    np.testing.assert_array_equal(back.rows.ball_diameter, solved.rows.ball_diameter)
    np.testing.assert_array_equal(back.rows.modulus, solved.rows.modulus)
    np.testing.assert_array_equal(back.inner.entrainment, solved.inner.entrainment)
    assert np.isnan(back.inner.approach).all()
