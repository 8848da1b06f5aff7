"""`rolamento import` and `rolamento export` as a person uses them."""

from __future__ import annotations

import json
import tomllib
import zipfile
from pathlib import Path

import pytest
from tests.rexs_models import gear_pair, shaft_on_two
from typer.testing import CliRunner

import rolamento
from rolamento.case.machine import load_machine
from rolamento.cli.app import app
from rolamento.exchange.rexs import machine_of_rexs, parse_rexs, read_rexs

MACHINES = Path(rolamento.__file__).parent / "examples" / "machines"


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("gearbox.rexs").write_bytes(gear_pair("1.0").xml())
    Path("small.rexsz").write_bytes(shaft_on_two().zipped())


def run(*words: str, code: int = 0, given: bytes | None = None) -> tuple[str, str]:
    ended = CliRunner().invoke(app, words, input=given, env={"LC_ALL": "C.UTF-8"})
    assert ended.exit_code == code, ended.output
    return ended.stdout, ended.stderr


def test_import_writes_a_machine_and_lists_what_became_of_the_model() -> None:
    page, _ = run("import", "gearbox.rexs")
    machine = load_machine("gearbox.toml")
    assert [one.name for one in machine.shafts] == ["Welle", "Abtrieb"]
    for heading in ("Taken", "Inferred", "Left out", "now try: rolamento shaft gearbox.toml"):
        assert heading in page
    run("shaft", "gearbox.toml")


@pytest.mark.parametrize("name", ["machine.toml", "machine.json"])
def test_import_writes_toml_and_json(name: str) -> None:
    run("import", "small.rexsz", "-o", name)
    assert load_machine(name) == machine_of_rexs(read_rexs("small.rexsz")).machine


def test_import_reads_standard_input_and_writes_standard_output() -> None:
    text, _ = run("import", "-", "-o", "-", given=shaft_on_two().json())
    Path("again.toml").write_text(text, encoding="utf-8")
    assert load_machine("again.toml") == machine_of_rexs(read_rexs("small.rexsz")).machine


def test_the_list_as_json() -> None:
    text, _ = run("import", "gearbox.rexs", "--json")
    mapping = json.loads(text)
    assert (mapping["kind"], mapping["version"]) == ("rexs_import", "1.0")
    assert {"taken", "inferred", "left", "machine"} <= {*mapping}
    run("import", "gearbox.rexs", "--force", "--json", "list.json")
    assert json.loads(Path("list.json").read_text("utf-8")) == mapping


@pytest.mark.parametrize("language", ["en", "pt"])
def test_both_languages(language: str) -> None:
    page, _ = run("import", "gearbox.rexs", "--lang", language)
    assert ("Inferred" if language == "en" else "Inferido") in page


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["import", "nothing.rexs"], "nothing.rexs: cannot be opened"),
        (["import", "."], "is a directory; give a REXS file"),
        (["import", "small.rexsz", "-o", "there.toml"], "already exists; --force overwrites it"),
        (["import", "small.rexsz", "-o", "machine.xml"], "must end in .toml or .json"),
        (["import", "small.rexsz", "-o", "small.rexsz"], "is one of the input files"),
        (["import", "small.rexsz", "-o", "-", "--json"], "only one of --output and --json"),
        (["import", "small.rexsz", "--load-case", "3"], "is no load case of the file"),
        (["import", "laughs.rexs"], "laughs.rexs, line 1: has a document type or entities"),
        (["import", "half.rexs"], "half.rexs, line 5: is not valid XML"),
        (["import", "machine.toml", "-o", "a.toml"], "is not a REXS model, which is XML, JSON or"),
        (["import", "machine.toml"], "a machine file for rolamento shaft"),
        (["import", "text.rexs"], "is not a REXS model, which is XML, JSON or a zip archive\n"),
        (["export", "nothing.toml"], "nothing.toml: cannot be opened"),
        (["export", "spindle.toml", "-o", "a.xml"], "must end in .rexs, .rexsj, .rexsz"),
        (["export", "spindle.toml", "-o", "spindle.toml", "--ross", "3"], "one of the input files"),
        (["export", "spindle.toml", "--set", "shafts.0.speed=1 mm"], "shafts.0.speed"),
        (["shaft", "gearbox.rexs"], "is a REXS model of a gear unit; make a machine file of it"),
    ],
)
def test_wrong_input_is_one_line(words: list[str], expected: str) -> None:
    Path("there.toml").write_text("", encoding="utf-8")
    Path("machine.toml").write_text("title = 'x'", encoding="utf-8")
    Path("text.rexs").write_text("title = 'x'", encoding="utf-8")
    Path("laughs.rexs").write_text('<!DOCTYPE a [<!ENTITY b "c">]><model/>', encoding="utf-8")
    Path("half.rexs").write_bytes(b"\n".join(gear_pair().xml().split(b"\n")[:5]))
    Path("spindle.toml").write_bytes((MACHINES / "spindle.toml").read_bytes())
    before = Path("there.toml").read_text("utf-8")
    _, complaint = run(*words, code=2)
    assert expected in complaint
    assert complaint.count("\n") == 1
    assert Path("there.toml").read_text("utf-8") == before


def test_export_writes_a_model_that_reads_back_as_the_same_machine() -> None:
    source = str(MACHINES / "three_supports.toml")
    page, _ = run("export", source, "--set", "loads.0.fz=-1.25 kN")
    assert "REXS 2.0" in page
    found = machine_of_rexs(read_rexs("three_supports.rexs")).machine
    assert found == load_machine(source, ["loads.0.fz=-1.25 kN"])


def test_export_to_standard_output_and_without_results() -> None:
    source = str(MACHINES / "spindle.toml")
    text, _ = run("export", source, "-o", "-", "--without-results")
    model = parse_rexs(text.encode())
    assert machine_of_rexs(model).machine == load_machine(source)
    assert "maximum_hertzian_pressure" not in text
    notes, _ = run("export", source, "-o", "a.rexsj", "--without-results", "--json")
    assert {note["key"] for note in json.loads(notes)["notes"]} == {"rexs_kept_by_custom"}


def test_export_without_equilibrium_says_so() -> None:
    source = str(MACHINES / "gear_shaft.toml")
    page, _ = run(
        "export", source, "-o", "a.rexs", "--set", "bearings.locating.located=floating", code=1
    )
    assert "Without results" in page
    assert Path("a.rexs").is_file()


# --- for simulation programs ----------------------------------------------------------------------

SPINDLE = str(MACHINES / "spindle.toml")


@pytest.mark.parametrize("language", ["en", "pt"])
def test_elements_for_ross_with_what_they_leave_out(language: str) -> None:
    page, _ = run("export", SPINDLE, "--ross", "3", "--points", "7", "--force",
                  "-o", "b.toml", "--lang", language)  # fmt: skip
    assert ("left out" if language == "en" else "omitido") in page
    tables = tomllib.loads(Path("b.toml").read_text("utf-8"))
    assert list(tables) == ["BearingElement_nose", "BearingElement_rear"]
    assert tables["BearingElement_rear"]["speed"][-1] == pytest.approx(837.758)


def test_ross_by_its_usual_name_and_to_standard_output() -> None:
    run("export", SPINDLE, "--ross", "2", "--bearing", "rear", "--points", "7")
    text, _ = run("export", SPINDLE, "--ross", "2", "--bearing", "rear", "--points", "7", "-o", "-")
    assert Path("spindle_ross.toml").read_text("utf-8") == text
    assert "frequency" in tomllib.loads(text)["BearingElement_rear"]


def test_a_designation_a_case_and_a_machine_are_mapped() -> None:
    over = ["--over", "duty.load.fz=1..2kN", "--points", "2"]
    page, _ = run("export", "6310/C3", *over, "-o", "a.csv")
    assert "6310/C3" in page
    case = '[bearing]\ndesignation = "6310/C3"\n[duty]\n'
    run("export", "-", *over, "-o", "b.csv", given=case.encode())
    rows = [Path(name).read_text("utf-8").splitlines()[-1] for name in ("a.csv", "b.csv")]
    assert rows[0].split(",")[1:] == rows[1].split(",")[1:]
    run("export", SPINDLE, "--over", "loads.0.fz=1..2kN", "--points", "2", "-o", "c.mat")
    assert Path("c.mat").read_bytes().startswith(b"MATLAB 5.0")


def test_what_was_solved_as_json() -> None:
    text, _ = run("export", SPINDLE, "-o", "r.py", "--points", "7", "--levers", "--json")
    mapping = json.loads(text)
    assert (mapping["kind"], len(mapping["bearings"]), len(mapping["elements"])) == (
        "ross_export", 2, 4,
    )  # fmt: skip
    assert set(mapping["elements"][0]["left_out"]) == {"axial_radial", "shift_tilt", "tilt"}


def test_an_fmu_says_what_lies_between_its_points() -> None:
    page, _ = run("export", "6310/C3", "--set", "duty.load.fz=1 kN", "--points", "3",
                  "--over", "duty.inner_speed=0..3000rpm", "-o", "a.fmu", "--fmi", "2")  # fmt: skip
    assert "Between its points the stiffness is linear" in page
    assert zipfile.is_zipfile("a.fmu")


def test_points_without_equilibrium_end_with_1() -> None:
    page, _ = run("export", "NU206", "--set", "duty.load.fz=1 kN", "--points", "2",
                  "--over", "duty.load.fx=0..1kN", "-o", "a.csv", code=1)  # fmt: skip
    assert "without a" in page


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (["-o", "a.toml"], "--ross: is missing: elements for ROSS need its version"),
        (["-o", "a.toml", "--ross", "4"], "--ross: 4: must be one of 2, 3"),
        (["-o", "a.py", "--ross", "3"], "--ross: is not for files that end in .py"),
        (["-o", "a.rexs", "--over", "loads.0.fz=1..2kN"], "--over: is not for files that end in"),
        (["-o", "a.csv", "--levers"], "--levers: is not for files that end in .csv"),
        (["-o", "a.csv", "--without-results"], "--without-results: is not for files"),
        (["-o", "a.fmu"], "--bearing: is missing: an FMU is of one bearing; one of nose, rear"),
        (["-o", "a.fmu", "--bearing", "rear", "--fmi", "1"], "--fmi: 1: must be one of 2, 3"),
        (["-o", "a.py", "--over", "loads.0.fz=1..2kN"], "must be the speed of a shaft"),
        (["-o", "a.py", "--points", "6"], "--points: 6: must be at least 7"),
        (["-o", "a.csv", "--bearing", "front"], "--bearing"),
        (["-o", "a.csv", "--points", "100000"], "--points"),
        (["-o", "a.csv", "--over", "loads.9.fz=1..2kN"], "loads.9"),
        (["-o", "a.csv", "--over", "duty.load.fz=1..2kN"], "duty"),
        (["-o", "a.csv", "--over", "loads.0.fz=1mm..2mm"], "loads.0.fz"),
        (["-o", "there.toml", "--ross", "3"], "already exists"),
        (["-o", "no/folder/a.csv", "--points", "2"], "cannot be written"),
    ],
)
def test_wrong_options_are_one_line(words: list[str], expected: str) -> None:
    Path("there.toml").write_text("", encoding="utf-8")
    _, complaint = run("export", SPINDLE, *words, code=2)
    assert expected in complaint
    assert complaint.count("\n") == 1


@pytest.mark.parametrize("name", ["a.py", "a.xlsx"])
def test_a_bearing_alone_is_no_machine(name: str) -> None:
    _, complaint = run("export", "6310/C3", "--set", "duty.inner_speed=9 rpm", "-o", name, code=2)
    assert "is a bearing alone" in complaint


def test_a_workbook_is_exported_and_solved() -> None:
    run("export", SPINDLE, "--set", "loads.0.fz=900 N", "-o", "m.xlsx")
    assert load_machine("m.xlsx") == load_machine(SPINDLE, ["loads.0.fz=900 N"])
    page, _ = run("export", "m.xlsx", "-o", "again.rexs", "--without-results")
    assert "REXS 2.0" in page
