"""`rolamento import` and `rolamento export` as a person uses them."""

from __future__ import annotations

import json
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
        (["import", "small.rexsz", "-o", "small.rexsz"], "is the file that is read"),
        (["import", "small.rexsz", "-o", "-", "--json"], "only one of --output, --json"),
        (["import", "small.rexsz", "--load-case", "3"], "is no load case of the file"),
        (["import", "laughs.rexs"], "laughs.rexs, line 1: has a document type or entities"),
        (["import", "half.rexs"], "half.rexs, line 5: is not valid XML"),
        (["import", "machine.toml", "-o", "a.toml"], "is not a REXS model, which is XML, JSON or"),
        (["export", "nothing.toml"], "nothing.toml: cannot be opened"),
        (["export", "spindle.toml", "-o", "a.xml"], "must end in .rexs, .rexsj, .rexsz"),
        (["export", "spindle.toml", "-o", "spindle.toml"], "is the file that is read"),
        (["export", "spindle.toml", "--set", "shafts.0.speed=1 mm"], "shafts.0.speed"),
        (["shaft", "gearbox.rexs"], "is a REXS model of a gear unit; make a machine file of it"),
    ],
)
def test_wrong_input_is_one_line(words: list[str], expected: str) -> None:
    Path("there.toml").write_text("", encoding="utf-8")
    Path("machine.toml").write_text("title = 'x'", encoding="utf-8")
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
