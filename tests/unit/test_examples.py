"""The examples are copied as they are shipped, run, and show what is said of them."""

from __future__ import annotations

import csv
import importlib.util
import shlex
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from typer.testing import CliRunner

import rolamento
from rolamento.cli.app import app
from rolamento.errors import FileError, InputError
from rolamento.tasks.examples import EXAMPLES, copy_examples

ROOT = Path(__file__).resolve().parents[2]
FOLDER = Path(rolamento.__file__).parent / "examples"
SCRIPTS = sorted(FOLDER.glob("*.py"))
GALLERY = ROOT / "docs" / "gallery" / "sets"


def loaded(path: Path) -> ModuleType:
    """Import a script as a module: scripts are not a package."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("contact_angles", "121 of 121 solved"),
        ("film_over_temperature", "κ is below 1 from"),
        pytest.param("frequencies_under_thrust", "BPFO: 75.5", marks=pytest.mark.sweep),
        pytest.param("small_samples", "true shape 1.5", marks=pytest.mark.sweep),
    ],
)
def test_a_script_says_and_draws(
    name: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    loaded(FOLDER / f"{name}.py").main(tmp_path)
    assert said in capsys.readouterr().out
    assert (tmp_path / f"{name}.png").read_bytes().startswith(b"\x89PNG")


def test_every_script_is_tried() -> None:
    tried = {"contact_angles", "film_over_temperature", "frequencies_under_thrust", "small_samples"}
    assert {path.stem for path in SCRIPTS} == tried | {"preload_over_speed"}


def test_rigid_and_spring_preload_differ_with_speed(tmp_path: Path) -> None:
    script = loaded(FOLDER / "preload_over_speed.py")
    curves = script.main(tmp_path)
    rigid, spring = curves["force"], curves["spring"]
    # at rest: one force; the springs leave one row to resist axially
    assert rigid.force[0] == pytest.approx(script.FORCE)
    assert spring.force == pytest.approx(np.full(81, script.FORCE))
    assert rigid.axial_stiffness[0] == pytest.approx(2.0 * spring.axial_stiffness[0], rel=1e-6)
    assert rigid.radial_stiffness[0] == pytest.approx(spring.radial_stiffness[0], rel=1e-6)
    # at speed: the clamped force more than doubles, and with it the stiffness stays
    assert (np.diff(rigid.force) > 0.0).all()
    assert rigid.force[-1] > 2.0 * script.FORCE
    assert rigid.axial_stiffness.min() > 0.8 * rigid.axial_stiffness[0]
    assert spring.axial_stiffness.min() < 0.55 * spring.axial_stiffness[0]
    assert spring.radial_stiffness[-1] < 0.6 * rigid.radial_stiffness[-1]
    assert (tmp_path / "preload_over_speed.png").read_bytes().startswith(b"\x89PNG")

    def table(folder: Path) -> list[list[str]]:
        with open(folder / "preload_over_speed.csv", encoding="utf-8", newline="") as file:
            return list(csv.reader(file))

    written, shown = table(tmp_path), table(GALLERY)
    assert written[0] == shown[0]
    assert len(written) == len(shown) == 82
    # what the gallery shows is what the script gives, but for the last digit
    for new, old in zip(written[1:], shown[1:], strict=True):
        assert np.array(new, float) == pytest.approx(np.array(old, float), abs=0.11)


# --- the list of them -----------------------------------------------------------------------------

SLOW = {"218_scatter": ("count = 20000", "count = 40")}
"""What is made smaller for the test."""


def test_every_file_is_of_an_example() -> None:
    named = {file for example in EXAMPLES.values() for file in example.files}
    there = {
        path.relative_to(FOLDER).as_posix()
        for path in FOLDER.rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    assert there <= named
    assert all(ex.source(file).is_file() for ex in EXAMPLES.values() for file in ex.files)


@pytest.mark.parametrize("name", [n for n, ex in EXAMPLES.items() if "python" not in ex.command])
@pytest.mark.thirds
def test_what_is_to_be_tried_works(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    copied = run("examples", name, "-o", "there")
    command = copied.splitlines()[-1].partition(": ")[2]
    for file in EXAMPLES[name].files:
        path = tmp_path / "there" / file
        assert path.read_text("utf-8") == EXAMPLES[name].source(file).read_text("utf-8")
        if name in SLOW:
            path.write_text(path.read_text("utf-8").replace(*SLOW[name]), encoding="utf-8")
    program, *arguments = shlex.split(command)
    assert program == "rolamento"
    assert len(run(*arguments)) > 200


def run(*arguments: str, code: int = 0) -> str:
    result = CliRunner().invoke(app, arguments, env={"LC_ALL": "C.UTF-8"})
    if result.exception and not isinstance(result.exception, SystemExit):
        raise result.exception
    assert result.exit_code == code, result.stderr
    return result.stdout


def test_they_are_listed() -> None:
    listed = run("examples")
    for name, example in EXAMPLES.items():
        assert f"{name}\n    {example.shows}\n    {example.command}\n" in listed


def test_nothing_is_overwritten(tmp_path: Path) -> None:
    copy_examples("218_hybrid", tmp_path)
    copy_examples("218_combined", tmp_path)  # a file of both, and still as shipped
    (tmp_path / "218_hybrid.toml").unlink()
    with (tmp_path / "218_combined.toml").open("a", encoding="utf-8") as own:
        own.write("# mine\n")
    with pytest.raises(FileError, match="already exists; --force overwrites it"):
        copy_examples("218_hybrid.toml", tmp_path)
    assert not (tmp_path / "218_hybrid.toml").exists()
    assert list(copy_examples("all", tmp_path, force=True)) == list(EXAMPLES)
    with pytest.raises(InputError, match="did you mean 6310_motor"):
        copy_examples("6310_moter", tmp_path)
    with pytest.raises(FileError, match="cannot be made"):
        copy_examples("218_hybrid", tmp_path / "218_hybrid.toml" / "below")
