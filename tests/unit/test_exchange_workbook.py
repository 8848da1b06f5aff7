"""Machines as workbooks and data frames, and what else may stand in a workbook."""

from __future__ import annotations

import io
import random
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pandas as pd
import pytest
from typer.testing import CliRunner

import rolamento
from rolamento.case.machine import Machine, load_machine
from rolamento.case.machine_sheets import Sheet, sheets_of_tables, tables_of_sheets
from rolamento.cli.app import app
from rolamento.errors import InputError
from rolamento.exchange.workbook import machine_of_frames, machine_to_frames, machine_to_xlsx

MACHINES = sorted((Path(rolamento.__file__).parent / "examples" / "machines").glob("*.toml"))
SPINDLE = next(path for path in MACHINES if path.stem == "spindle")


def odd() -> Machine:
    """A machine with matrices, tables in tables, and numbers of all digits."""
    tables = load_machine(SPINDLE).to_mapping()
    tables["shafts"][0]["sections"] = [
        {"length": f"{length!r} mm", "diameter": "0.1 m"} for length in (100.1 / 3.0, 286.7, 1e-1)
    ]
    tables["shafts"][0]["material"] = {
        "name": "cast iron", "youngs_modulus": "110.00000000000001 GPa", "poisson_ratio": 0.27,
        "density": "7200 kg/m^3",
    }  # fmt: skip
    tables["housings"] = [{
        "name": "wall", "bearings": ["nose", "rear"], "units": "N/m",
        "matrix": (np.diag(np.arange(1.0, 11.0) / 3.0 * 1e8)).tolist(),
    }]  # fmt: skip
    for bearing in tables["bearings"]:
        bearing.pop("housing", None)
    tables["spectrum"] = [{"share": 1.0 / 3.0}, {"share": 2.0 / 3.0, "name": "=1+1"}]
    tables["title"] = "=HYPERLINK(1)"
    return Machine.from_mapping(tables)


@pytest.fixture(scope="module")
def machines() -> list[Machine]:
    return [*map(load_machine, MACHINES), odd()]


def test_a_workbook_reads_back_identically(machines: list[Machine], tmp_path: Path) -> None:
    for index, machine in enumerate(machines):
        path = tmp_path / f"{index}.xlsx"
        path.write_bytes(machine_to_xlsx(machine))
        assert load_machine(path) == machine
    assert machine_to_xlsx(machines[0]) == machine_to_xlsx(machines[0])


def test_data_frames_read_back_identically(machines: list[Machine]) -> None:
    for machine in machines:
        assert machine_of_frames(machine_to_frames(machine)) == machine


def test_numbers_are_numbers_and_texts_are_texts() -> None:
    book = openpyxl.load_workbook(io.BytesIO(machine_to_xlsx(odd())))
    sections = list(book["sections"].values)
    assert sections[0][:3] == ("shaft", "length [mm]", "diameter [mm]")
    assert sections[2][1] == 286.7
    assert sections[1][1] == "0.03336666666666667 m"  # more digits than a sheet holds
    assert book["spectrum"]["A2"].value is not None
    assert {cell.data_type for row in book["machine"].rows for cell in row} == {"inlineStr", "s"}
    assert len(list(book["matrix 1"].rows)) == 11


def test_every_field_is_described() -> None:
    book = openpyxl.load_workbook(io.BytesIO(machine_to_xlsx(odd())))
    known = {(row[0], row[1]) for row in book["# fields"].values}
    assert {("loads", "fz"), ("sections", "end_bore"), ("bearings", "bearing.ball_count")} <= known


# --- as people write them -------------------------------------------------------------------------

Change = Callable[[Any], None]


def book(change: Change, tmp_path: Path) -> Path:
    own = openpyxl.load_workbook(io.BytesIO(machine_to_xlsx(load_machine(MACHINES[1]))))
    change(own)
    path = tmp_path / "own.xlsx"
    own.save(path)
    return path


def at(sheet: Any, column: str, row: int) -> Any:
    heads = [str(cell.value).partition(" [")[0] for cell in sheet[1]]
    return sheet.cell(row, heads.index(column) + 1)


def test_what_a_spreadsheet_makes_of_names_and_counts(tmp_path: Path) -> None:
    def change(own: Any) -> None:
        at(own["bearings"], "designation", 3).value = 6309
        at(own["gears"], "teeth", 2).value = 60.0
        at(own["sections"], "length", 2).value = "3 cm"
        at(own["sections"], "length", 3).value = "41"
        own.create_sheet("# my own")["A1"] = "anything"

    machine = load_machine(book(change, tmp_path))
    assert machine.bearings[1].designation == "6309"
    assert machine.gears[0].teeth == 60
    assert [one.length for one in machine.shafts[0].sections[:2]] == pytest.approx([0.03, 0.041])


def test_settings_and_commands_take_workbooks(tmp_path: Path) -> None:
    path = book(lambda own: None, tmp_path)
    assert load_machine(path, ["gears.0.power=11 kW"]).gears[0].power == 11e3
    ended = CliRunner().invoke(app, ["shaft", str(path)], env={"LC_ALL": "C.UTF-8"})
    assert ended.exit_code == 0, ended.output


def _twice(own: Any) -> None:
    own["shafts"].cell(1, own["shafts"].max_column + 1).value = "name"
    own["shafts"].cell(2, own["shafts"].max_column).value = "x"


def _two_of_a_name(own: Any) -> None:
    for column, cell in enumerate(list(own["shafts"][2]), 1):
        own["shafts"].cell(3, column).value = cell.value


@pytest.mark.parametrize(
    ("change", "rule"),
    [
        (lambda own: own.create_sheet("bearngs").append(["a"]), "is no table of a machine"),
        (_twice, "shafts.name: is given twice"),
        (_two_of_a_name, 'shafts.1.name = "output shaft": is given twice'),
        (lambda own: own["shafts"].cell(2, 30, "x"), "a column without a name"),
        (lambda own: setattr(at(own["bearings"], "position", 2), "value", "2 kg"), "position"),
        (lambda own: setattr(at(own["bearings"], "shaft", 2), "value", "other"), "other"),
        (
            lambda own: setattr(at(own["sections"], "shaft", 2), "value", "other"),
            "sections.0.shaft",
        ),
        (lambda own: setattr(at(own["gears"], "teeth", 2), "value", 57.5), "teeth"),
        (lambda own: own["loads"].append(1) if "loads" in own else own.remove(own["shafts"]), ""),
        (lambda own: own["machine"].append(["title", "again"]), "machine.title: is given twice"),
        (lambda own: own["machine"].append(["life.cleanliness.x", "1"]), "must be a table"),
        (
            lambda own: own["machine"].append(["lubricant", "x"]),
            "machine.lubricant: is given twice",
        ),
        (
            lambda own: own["machine"].append(["surface", "[1"]),
            'machine.surface.value = "[1": is not valid JSON',
        ),
        (lambda own: own["machine"].append(["surface", "[" * 5000 + "]" * 5000]), "JSON"),
        (lambda own: own["machine"].append(["film", "sheet: nowhere"]), "unknown name"),
        (lambda own: own["machine"].append(["a." * 60 + "b", "1"]), "nested too deeply"),
        (lambda own: own["machine"].append(["surface.no_such_key", 1]), "no_such_key"),
    ],
)
def test_wrong_workbooks_are_one_message(change: Change, rule: str, tmp_path: Path) -> None:
    path = book(change, tmp_path)
    with pytest.raises(InputError) as refused:
        load_machine(path)
    assert rule in str(refused.value)
    assert "own.xlsx" in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_formula_without_its_value_is_empty(tmp_path: Path) -> None:
    def change(own: Any) -> None:
        at(own["bearings"], "position", 2).value = "=1+1"

    with pytest.raises(InputError, match=r"bearings\.0\.position: is missing"):
        load_machine(book(change, tmp_path))


# --- damaged and hostile --------------------------------------------------------------------------


def test_a_workbook_that_is_none_is_called_so(tmp_path: Path) -> None:
    path = tmp_path / "none.xlsx"
    path.write_text("title = 'x'", encoding="utf-8")
    with pytest.raises(InputError, match="is not a readable workbook"):
        load_machine(path)
    with pytest.raises(InputError, match="no such file"):
        load_machine(tmp_path / "nothing.xlsx")


def test_a_bomb_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "bomb.xlsx"
    with zipfile.ZipFile(io.BytesIO(machine_to_xlsx(load_machine(SPINDLE)))) as old:
        parts = {name: old.read(name) for name in old.namelist()}
    rows = b"<row><c t='inlineStr'><is><t>" + b"a" * 1000 + b"</t></is></c></row>"
    name = next(name for name in parts if "worksheets/sheet1" in name)
    head, _, tail = parts[name].partition(b"<sheetData>")
    parts[name] = head + b"<sheetData>" + rows * 120_000 + tail
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as new:
        for one, data in parts.items():
            new.writestr(one, data)
    with pytest.raises(InputError, match=r"bomb\.xlsx"):
        load_machine(path)


def test_more_sheets_rows_or_columns_than_a_machine_has(tmp_path: Path) -> None:
    for change, rule in (
        (lambda own: [own.create_sheet(f"# {i}").append(["a"]) for i in range(160)], "150 sheets"),
        (lambda own: own["shafts"].cell(1, 1500, "a"), "more than 1000 columns"),
        (lambda own: own["shafts"].cell(20_000, 1, "a"), "more than 12 000 rows"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=rule):
            load_machine(book(change, tmp_path))


def test_damaged_files_are_refused_or_read(tmp_path: Path) -> None:
    chance = random.Random(43)
    whole = machine_to_xlsx(load_machine(SPINDLE))
    path = tmp_path / "damaged.xlsx"
    for _ in range(12):
        content = bytearray(whole)
        if chance.random() < 0.4:
            del content[chance.randrange(30, len(content)) :]
        for _ in range(chance.randrange(1, 40)):
            content[chance.randrange(4, len(content))] = chance.randrange(256)
        path.write_bytes(bytes(content))
        try:
            load_machine(path)
        except InputError as refused:
            assert "\n" not in str(refused)


def test_tables_of_anything_are_refused_or_a_machine() -> None:
    chance = random.Random(7)
    sheets = sheets_of_tables(load_machine(MACHINES[1]).to_mapping())
    values = [
        "",
        None,
        "x",
        "=1",
        "[]",
        "{}",
        "[[1]]",
        "1 mm",
        -1.0,
        1e308,
        float("inf"),
        True,
        "é",
    ]
    for _ in range(300):
        name = chance.choice(list(sheets))
        sheet = sheets[name]
        rows = [list(row) for row in sheet.rows]
        columns = list(sheet.columns)
        place = chance.randrange(len(columns))
        if chance.random() < 0.3:
            columns[place] = str(chance.choice([*values, "name.name", "[mm]", "a [", "position"]))
        else:
            chance.choice(rows)[place] = chance.choice(values)
        changed = {**sheets, name: Sheet(tuple(columns), tuple(map(tuple, rows)))}
        try:
            Machine.from_mapping(tables_of_sheets(changed))
        except InputError as refused:
            assert "\n" not in str(refused)


def test_frames_that_are_none_are_refused() -> None:
    frames = machine_to_frames(load_machine(SPINDLE))
    with pytest.raises(InputError, match="must be a data frame"):
        machine_of_frames({**frames, "loads": [1]})  # type: ignore[dict-item]
    with pytest.raises(InputError, match="is no table"):
        machine_of_frames({**frames, "weights": pd.DataFrame({"a": [1]})})


def test_a_template_is_a_machine(tmp_path: Path) -> None:
    path = tmp_path / "machine.xlsx"
    runner = CliRunner()
    ended = runner.invoke(app, ["new", "--machine", "-o", str(path)], env={"LC_ALL": "C.UTF-8"})
    assert ended.exit_code == 0, ended.output
    assert [one.name for one in load_machine(path).bearings] == ["fixed", "floating"]
