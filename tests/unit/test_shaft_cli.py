"""`rolamento shaft`: the page, the files, settings, refusals."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import rolamento as ro
from rolamento.analysis.machine import analyse_machine
from rolamento.case.machine import Step, load_machine, with_settings
from rolamento.cli.app import app
from rolamento.document.tables import to_csv
from rolamento.document.terminal import terminal
from rolamento.errors import FileError, InputError
from rolamento.pages.machine import machine_page, machine_report
from rolamento.solved.machine import SolvedMachine
from rolamento.types.cylindrical import TYPE as CYLINDRICAL

EXAMPLES = Path(ro.__file__).parent / "examples" / "machines"
GEAR_SHAFT = str(EXAMPLES / "gear_shaft.toml")


def run(*arguments: str) -> tuple[int, str, str]:
    result = CliRunner().invoke(
        app, ["shaft", *arguments], env={"LC_ALL": "C.UTF-8", "LANGUAGE": "en"}
    )
    return result.exit_code, result.stdout, result.stderr


def test_the_page_has_bearings_shafts_and_gears(tmp_path: Path) -> None:
    """Steps, lives, tilts beside the permissible; tables as files."""
    table, book = tmp_path / "bearings.csv", tmp_path / "all.xlsx"
    code, out, _ = run(GEAR_SHAFT, "--csv", str(table), "--xlsx", str(book))
    assert code == 0
    for text in ("Gear shaft: NU 308 and 6308", "3 steps", "full load: 20 % of the time",
                 "Life of all bearings together", "Bearing locating limits it"):  # fmt: skip
        assert text in out
    rows = list(csv.DictReader(table.read_text(encoding="utf-8").splitlines()))
    assert [row["bearing"] for row in rows] == ["floating", "locating"] * 3
    found = ro.shaft(GEAR_SHAFT)
    forces = [one.radial_force[case] for case in range(3) for one in found.bearings.values()]
    np.testing.assert_allclose([float(row["radial_force_N"]) for row in rows], forces, rtol=1e-9)
    assert book.stat().st_size > 5000


def test_names_with_commas_are_told_apart() -> None:
    """The bearings that a note is about: "hollow, left" is one of them."""
    code, out, _ = run(str(EXAMPLES / "coaxial.toml"))
    assert code == 0
    assert "  • hollow, left; hollow, right: The internal geometry of 6018" in out


def test_json_reads_back_identically(tmp_path: Path) -> None:
    """Every number as it was written; the rest of it is what follows."""
    path = tmp_path / "result.json"
    assert run(GEAR_SHAFT, "--json", str(path))[0] == 0
    text = path.read_text(encoding="utf-8")
    found = ro.shaft(GEAR_SHAFT)
    again = SolvedMachine.from_json(text)
    assert again.to_json() == found.to_json()
    for name, one in found.bearings.items():
        np.testing.assert_array_equal(again.bearings[name].force, one.force)
        np.testing.assert_array_equal(again.bearings[name].solved.outer.load, one.solved.outer.load)
    parsed = json.loads(text)
    assert parsed["life"]["headline"]["hours"] == pytest.approx(8.46e5, rel=0.05)
    assert parsed["bearings"][1]["steps"][0]["friction_power"] > 0.0


@pytest.mark.parametrize(
    ("broken", "field"),
    [
        ({"kind": "bearing"}, ""),
        ({"steps": []}, "steps"),
        ({"shafts": [{}]}, "position"),
        ({"bearings": [1, 2, 3]}, "bearings"),
        ({"machine": {"shafts": 3}}, "shafts"),
    ],
)
def test_other_json_is_refused(broken: dict[str, object], field: str) -> None:
    """With the key that is wrong."""
    mapping = json.loads(ro.shaft(EXAMPLES / "three_supports.toml").to_json())
    with pytest.raises((InputError, FileError)) as caught:
        SolvedMachine.from_mapping({**mapping, **broken})
    assert field in caught.value.field


def test_settings_go_over_the_file() -> None:
    """By name, by number, into tables that are not there yet."""
    code, out, _ = run(
        GEAR_SHAFT, "--set", "bearings.locating.designation=6309", "--set", "gears.0.power=11 kW",
        "--set", "temperature.lubricant=50 degC",
    )  # fmt: skip
    assert code == 0
    assert "6309 on output shaft" in out
    settings = ['shafts."output shaft".speed=970 rpm', "spectrum.1.load_factor=0.5"]
    machine = load_machine(GEAR_SHAFT, settings)
    assert machine.speed("output shaft") == pytest.approx(970 * np.pi / 30)
    assert machine.spectrum[1].load_factor == 0.5


@pytest.mark.parametrize(
    ("setting", "says"),
    [
        ("loads", "KEY=VALUE"),
        ("bearings.lost.position=1 mm", "locating"),
        ("bearings.9.position=1 mm", "unknown"),
        ("gears.wheel.powr=3 kW", "power"),
        ("gears.wheel.power=3", "unit"),
        ("shafts.0.x=3", "unknown key"),
        ("nothing=3", "unknown key"),
    ],
)
def test_settings_that_name_nothing_are_refused(setting: str, says: str) -> None:
    """One message, exit code 2."""
    code, _, err = run(GEAR_SHAFT, "--set", setting)
    assert code == 2
    assert says in err
    assert err.startswith("rolamento: --set: ")  # and no line of a file that does not have it
    assert "Traceback" not in err


def test_settings_leave_the_mapping_alone() -> None:
    """What is changed is a copy."""
    given = {"shafts": [{"name": "a", "sections": [1]}]}
    with_settings(given, ["shafts.a.speed=3 rpm"])
    assert given == {"shafts": [{"name": "a", "sections": [1]}]}


def test_a_machine_without_equilibrium_says_why(tmp_path: Path) -> None:
    """Exit code 1, the reason and the advice; nothing that looks like a number."""
    text = Path(GEAR_SHAFT).read_text(encoding="utf-8").replace('"6308"', '"NU308"')
    path = tmp_path / "loose.toml"
    path.write_text(text, encoding="utf-8")
    code, out, _ = run(str(path))
    assert code == 1
    assert "there is no equilibrium" in out
    assert "Nothing holds shaft output shaft along x" in " ".join(out.split())


def test_the_report_has_a_chapter_for_each_bearing() -> None:
    """The machine first, then each bearing in its hardest step."""
    document = machine_report(ro.analyse_machine(GEAR_SHAFT))
    headings = [part.heading for part in document.parts() if part.level == 1]
    assert headings == ["Bearing floating: full load", "Bearing locating: full load"]


def test_frames_and_datasets() -> None:
    """A line a step and bearing, or node; the same numbers."""
    found = ro.shaft(GEAR_SHAFT)
    frame = found.to_pandas()
    assert len(frame) == 6
    nodes = found.to_pandas("shafts")
    assert len(nodes) == 3 * len(found.shafts["output shaft"].position)
    dataset = found.to_xarray()
    np.testing.assert_array_equal(
        dataset["force"].sel(bearing="locating"), found.bearings["locating"].force
    )
    with pytest.raises(InputError):
        found.to_pandas("gears")


def test_the_template_of_a_machine_solves(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`new --machine` writes a file that solves as it is; and all its tables are understood."""
    monkeypatch.chdir(tmp_path)
    assert CliRunner().invoke(app, ["new", "--machine"]).exit_code == 0
    assert ro.shaft("machine.toml").status.converged.all()
    assert CliRunner().invoke(app, ["new", "6310", "--machine"]).exit_code == 2
    text = Path("machine.toml").read_text(encoding="utf-8")
    lines = [
        line[2:] if line.startswith("# ") and ("=" in line or "[" in line) else line
        for line in text.split("\n")
    ]
    other = {"# ratio", "outer_shaft", "offset", 'faces = "-x"'}
    awake = [line for line in lines if not any(line.startswith(one) for one in other)]
    awake = [line for line in awake if not line.startswith(("Every value", "begin with", "x runs"))]
    Path("all.toml").write_text("\n".join(awake), encoding="utf-8")
    assert ro.shaft("all.toml").status.converged.all()


def test_over_a_field(tmp_path: Path) -> None:
    """Preload of a pinion: forces as at each point alone; a point that is refused says why."""
    table, picture = tmp_path / "over.csv", tmp_path / "over.png"
    data = tmp_path / "over.json"
    pinion = str(EXAMPLES / "pinion.toml")
    code, out, _ = run(
        pinion, "--over", "bearings.pinion side.preload=0..2kN", "--points", "3", "--csv",
        str(table), "--plot", str(picture), "--json", str(data),
    )  # fmt: skip
    assert code == 0
    assert "over bearings.pinion side.preload" in " ".join(out.split())
    assert picture.stat().st_size > 10_000
    found = json.loads(data.read_text(encoding="utf-8"))
    assert found["values"] == [0.0, 1.0, 2.0]
    alone = ro.shaft(load_machine(pinion, ["bearings.pinion side.preload=1 kN"]))
    for name, one in alone.bearings.items():
        np.testing.assert_allclose(
            found["bearings"][name]["radial_force"][1], one.radial_force[0], rtol=1e-9
        )
    rows = list(csv.DictReader(table.read_text(encoding="utf-8").splitlines()))
    assert len(rows) == 3
    code, out, _ = run(pinion, "--over", "bearings.pinion side.position=40..900mm", "--points", "2")
    assert code == 1
    assert "is not on shaft" in " ".join(out.split())


@pytest.mark.parametrize("over", ["loads", "loads.0.fz=1", "loads.0.fz=1kN..2mm", "a=1..2"])
def test_what_is_no_range_is_refused(over: str) -> None:
    """One message, exit code 2."""
    code, _, err = run(GEAR_SHAFT, "--over", over, "--points", "2")
    assert code == 2
    assert "Traceback" not in err


@pytest.mark.parametrize(
    ("designation", "minutes"),
    [("NU 210", 4.0), ("NU 1010", 4.0), ("NU 2210 ECP", 2.0), ("NJ 2310", 2.0), (None, 2.0)],
)
def test_wide_cylindrical_rollers_bear_less_tilt(designation: str | None, minutes: float) -> None:
    """NSK E1102: 4 minutes, of the wide series 2; the lesser where nobody knows."""
    found = CYLINDRICAL.misalignment_of(designation)
    assert found == pytest.approx(minutes / 60.0 * np.pi / 180.0)


def test_many_steps_are_all_in_files_and_the_first_on_pages() -> None:
    steps = [Step(name=f"load {i}", share=1.0 / 15.0, load_factor=0.3 + 0.05 * i)
             for i in range(15)]  # fmt: skip
    machine = load_machine(EXAMPLES / "three_supports.toml").replace(spectrum=steps)
    page = machine_page(analyse_machine(machine))
    for table in ("bearings", "shafts"):
        lines = list(csv.DictReader(to_csv(page, table).splitlines()))
        assert len(lines) == 15 * (3 if table == "bearings" else 1)
        assert lines[-1]["step"] == "load 14"
    shown = terminal(page)
    assert "load 11: " in shown
    assert "load 12: " not in shown
    assert "the first 12 of 15 steps" in shown
